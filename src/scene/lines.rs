//! Chains of equal formulas in lines that fit a column.

use crate::math::{Class, Math};

/// Characters of a line beyond which a sum continues on the next: a column of a printed page, a phone held upright.
const MAX_LINE_LENGTH: usize = 35;

/// Characters kept free for a right side like 0.
const MIN_RIGHT: usize = 4;

/// Characters of a left side to which the lines of a step are still aligned.
const MAX_LEFT_LENGTH: usize = 12;

/// A chain of sides as it is set.
pub(crate) struct SetChain {
    pub(crate) sides: Vec<Math>,
    /// Whether the last one is an approximation.
    pub(crate) is_approximate: bool,
}

/// The lines, aligned at their relations where the left sides are short; long sums continue on the next line.
pub(crate) fn aligned(lines: &[SetChain]) -> Vec<[Math; 2]> {
    let has_short_sides = lines.iter().all(|line| {
        line.sides
            .first()
            .is_none_or(|left| width(left) <= MAX_LEFT_LENGTH)
    });
    let mut rows: Vec<[Math; 2]> = Vec::new();
    for line in lines {
        let count = line.sides.len();
        let sign = |at: usize| {
            let is_last = at + 1 == count;
            Math::relation(if line.is_approximate && is_last {
                "≈"
            } else {
                "="
            })
        };
        let Some((first, others)) = line.sides.split_first() else {
            continue;
        };
        if has_short_sides {
            let mut room = 0;
            for (at, side) in others.iter().enumerate() {
                let own = width(side) + width(&sign(at + 1));
                if let Some([_, last]) = rows.last_mut().filter(|_| at > 0 && own <= room) {
                    let before = std::mem::replace(last, Math::row([]));
                    *last = Math::row([before, sign(at + 1), side.clone()]);
                    room -= own;
                    continue;
                }
                let left = if at == 0 {
                    first.clone()
                } else {
                    Math::row([])
                };
                let mut pieces = broken(side, MAX_LINE_LENGTH).into_iter();
                let start = pieces.next().unwrap_or_else(|| Math::row([]));
                room = MAX_LINE_LENGTH.saturating_sub(width(&start) + MAX_LEFT_LENGTH / 2);
                rows.push([left, Math::row([sign(at + 1), start])]);
                for piece in pieces {
                    room = 0;
                    rows.push([Math::row([]), further(piece)]);
                }
            }
            continue;
        }
        let mut pieces = broken(first, MAX_LINE_LENGTH - MIN_RIGHT);
        for (at, side) in others.iter().enumerate() {
            let mut parts = broken(side, MAX_LINE_LENGTH).into_iter();
            let start = parts.next().unwrap_or_else(|| Math::row([]));
            let last = pieces.pop().unwrap_or_else(|| Math::row([]));
            if at == 0 && width(&last) + width(&start) <= MAX_LINE_LENGTH {
                pieces.push(Math::row([last, sign(at + 1), start]));
            } else {
                pieces.push(last);
                pieces.push(Math::row([sign(at + 1), start]));
            }
            pieces.extend(parts);
        }
        let pieces = pieces.into_iter().enumerate();
        rows.extend(
            pieces.map(|(at, piece)| [Math::row([]), if at == 0 { piece } else { further(piece) }]),
        );
    }
    rows
}

/// A piece that continues the line above it.
fn further(piece: Math) -> Math {
    Math::row([Math::Space(36), piece])
}

/// A formula in pieces that fit a line; each but the first begins with the sign of its first term.
fn broken(math: &Math, longest: usize) -> Vec<Math> {
    let mut atoms = Vec::new();
    flatten(math, &mut atoms);
    let terms = terms(atoms).into_iter();
    let terms = terms.flat_map(|term| opened(term, longest));
    let mut pieces: Vec<Vec<Math>> = Vec::new();
    let mut length = 0;
    for term in terms {
        let own = width(&Math::Row(term.clone()));
        match pieces.last_mut() {
            Some(last) if length + own <= longest => {
                last.extend(term);
                length += own;
            }
            _ => {
                pieces.push(term);
                length = own;
            }
        }
    }
    pieces.into_iter().map(Math::row).collect()
}

/// Atoms in pieces that begin with the signs between terms.
fn terms(atoms: Vec<Math>) -> Vec<Vec<Math>> {
    let mut terms: Vec<Vec<Math>> = vec![Vec::new()];
    for atom in atoms {
        let is_sign = matches!(&atom, Math::Operator { text, class: Class::Binary } if text == "+" || text == "−");
        if is_sign {
            terms.push(Vec::new());
        }
        if let Some(last) = terms.last_mut() {
            last.push(atom);
        }
    }
    terms
}

/// A term in pieces: where it is too long for a line and calls a function of several arguments, they go on in new lines.
fn opened(term: Vec<Math>, longest: usize) -> Vec<Vec<Math>> {
    let list = term.iter().rposition(|atom| match atom {
        Math::Fence { open, body, .. } => open == "(" && has_comma(body),
        _ => false,
    });
    let Some(place) = list.filter(|_| width(&Math::Row(term.clone())) > longest) else {
        return vec![term];
    };
    let mut before = term;
    let after = before.split_off(place + 1);
    let Some(Math::Fence { body, close, .. }) = before.pop() else {
        return vec![before];
    };
    before.push(Math::operator("(", Class::Opening));
    let mut arguments = Vec::new();
    flatten(&body, &mut arguments);
    let mut pieces = vec![before];
    for argument in arguments.split_inclusive(is_comma) {
        let mut own = terms(argument.to_vec()).into_iter();
        if let (Some(last), Some(first)) = (pieces.last_mut(), own.next()) {
            // The first argument stands at the name of the function.
            if last.iter().any(is_comma) {
                pieces.push(first);
            } else {
                last.extend(first);
            }
        }
        pieces.extend(own.filter(|own| !own.is_empty()));
    }
    if let Some(last) = pieces.last_mut() {
        last.push(Math::operator(close, Class::Closing));
        last.extend(after);
    }
    pieces
}

fn has_comma(math: &Math) -> bool {
    matches!(math, Math::Row(pieces) if pieces.iter().any(is_comma))
}

fn is_comma(math: &Math) -> bool {
    matches!(math, Math::Operator { text, class: Class::Punctuation } if text == ",")
}

fn flatten(math: &Math, atoms: &mut Vec<Math>) {
    match math {
        Math::Row(pieces) => pieces.iter().for_each(|piece| flatten(piece, atoms)),
        other => atoms.push(other.clone()),
    }
}

/// About how many characters wide a formula is.
fn width(math: &Math) -> usize {
    match math {
        Math::Row(pieces) => pieces.iter().map(width).sum(),
        Math::Identifier { text, .. }
        | Math::Number(text)
        | Math::Text(text)
        | Math::Function(text) => text.chars().count(),
        Math::Operator { class, .. } => match class {
            Class::Binary | Class::Relation => 3,
            _ => 1,
        },
        Math::Space(_) => 0,
        Math::Fraction {
            numerator,
            denominator,
            ..
        } => width(numerator).max(width(denominator)) + 1,
        Math::Root { radicand, .. } => width(radicand) + 1,
        Math::Script { base, sub, sup } => {
            let script = |own: &Option<Box<Math>>| own.as_ref().map_or(0, |own| width(own));
            // Scripts are set smaller.
            width(base) + (script(sub).max(script(sup)) * 2).div_ceil(3)
        }
        Math::Stack { base, .. } | Math::Accent { base, .. } => width(base),
        Math::Fence { body, .. } => width(body) + 2,
        Math::Table { rows, .. } => rows
            .iter()
            .map(|row| row.iter().map(|cell| width(cell) + 2).sum())
            .max()
            .unwrap_or(0),
        Math::Hole(_) => 1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::{Expr, PlainNotation};

    #[test]
    fn a_function_of_two_long_arguments_goes_on_after_its_comma() {
        let formula =
            "atan2(mass*damping*speed^3, stiffness*(stiffness - mass*speed^2) + (damping*speed)^2)";
        let formula = Expr::read(formula).expect("a formula");
        let pieces = broken(&formula.typeset(&PlainNotation), MAX_LINE_LENGTH);
        assert!(pieces.len() >= 2, "{pieces:?}");
        let all: String = pieces.iter().map(Math::plain).collect::<Vec<_>>().join(" ");
        let whole = formula.typeset(&PlainNotation).plain();
        let bare = |text: &str| text.replace(' ', "");
        assert_eq!(bare(&all), bare(&whole));
    }
}
