//! The pieces of a row brought into their one form.
//!
//! Nested rows are opened, digits that stand together joined, primes put where superscripts are,
//! signs before operands distinguished from signs between them, and the letters of an upright word joined.

use crate::{Atom, Class, Empty, Math, Style};

/// The row of these pieces. `before` is what stands before the first, `style` the font whose
/// letters form words.
pub(crate) fn tidy(pieces: Vec<Math>, before: Atom, style: Option<Style>) -> Math {
    let mut row = Vec::with_capacity(pieces.len());
    for piece in pieces {
        match piece {
            Math::Row(inner) => inner
                .into_iter()
                .for_each(|piece| push(&mut row, piece, style)),
            piece => push(&mut row, piece, style),
        }
    }
    classify(&mut row, before);
    Math::row(row)
}

/// Appends a piece, joined with the one before if they are one.
fn push(row: &mut Vec<Math>, piece: Math, style: Option<Style>) {
    let piece = match row.last_mut() {
        None => Some(piece),
        Some(last) => join(last, piece, style),
    };
    row.extend(piece);
}

/// Joins a piece to the one before; what cannot be joined comes back.
fn join(last: &mut Math, piece: Math, style: Option<Style>) -> Option<Math> {
    if let Some(word) = bearing_word(last, &piece, style) {
        *last = word;
        return None;
    }
    match (last, piece) {
        (Math::Number(digits), Math::Number(more)) => {
            digits.push_str(&more);
            None
        }
        (Math::Number(digits), Math::Operator { text, .. }) if text == "." => {
            digits.push('.');
            None
        }
        (
            Math::Identifier { text, style: own },
            Math::Identifier {
                text: more,
                style: other,
            },
        ) if style == Some(*own) && *own == other => {
            text.push_str(&more);
            None
        }
        (last, piece) => prime(last, piece),
    }
}

/// The word of an upright font whose last letter bears scripts, or the number whose last digit
/// does.
fn bearing_word(last: &Math, piece: &Math, style: Option<Style>) -> Option<Math> {
    let Math::Script { base, sub, sup } = piece else {
        return None;
    };
    let joined = match (last, &**base) {
        (Math::Number(digits), Math::Number(more)) => Math::Number(format!("{digits}{more}")),
        (
            Math::Identifier { text, style: own },
            Math::Identifier {
                text: more,
                style: other,
            },
        ) if style == Some(*own) && own == other => Math::identifier(format!("{text}{more}"), *own),
        _ => return None,
    };
    Some(Math::Script {
        base: Box::new(joined),
        sub: sub.clone(),
        sup: sup.clone(),
    })
}

/// Puts a prime, perhaps with scripts of its own, on what stands before it.
fn prime(last: &mut Math, piece: Math) -> Option<Math> {
    let bears = !matches!(
        last,
        Math::Space(_)
            | Math::Number(_)
            | Math::Operator {
                class: Class::Binary
                    | Class::Relation
                    | Class::Opening
                    | Class::Punctuation
                    | Class::Prefix,
                ..
            }
    );
    if !bears || is_prime(last) {
        return Some(piece);
    }
    let (mark, lower, rest) = match piece {
        piece if is_prime(&piece) => (piece, None, None),
        Math::Script { base, sub, sup } if is_prime(&base) => (*base, sub, sup),
        piece => return Some(piece),
    };
    let (has_sub, can_bear) = match last {
        Math::Script { sub, sup, .. } => (
            sub.is_some(),
            sup.as_deref().is_none_or(|sup| primes(sup).is_some()),
        ),
        _ => (false, true),
    };
    if !can_bear || has_sub && lower.is_some() {
        return Some(again(mark, lower, rest));
    }
    let bearer = std::mem::replace(last, Math::Row(Vec::new()));
    let (base, sub, own) = match bearer {
        Math::Script { base, sub, sup } => (base, sub, sup),
        base => (Box::new(base), None, None),
    };
    let mut marks = own.and_then(|own| primes(&own)).unwrap_or_default();
    marks.push(mark);
    if let Some(rest) = rest {
        match *rest {
            Math::Row(pieces) => marks.extend(pieces),
            piece => marks.push(piece),
        }
    }
    *last = Math::Script {
        base,
        sub: sub.or(lower),
        sup: Some(Box::new({
            classify(&mut marks, Atom::Edge);
            Math::row(marks)
        })),
    };
    None
}

/// A mark with the scripts that are left to it.
fn again(mark: Math, sub: Option<Box<Math>>, sup: Option<Box<Math>>) -> Math {
    match (&sub, &sup) {
        (None, None) => mark,
        _ => Math::Script {
            base: Box::new(mark),
            sub,
            sup,
        },
    }
}

fn is_prime(math: &Math) -> bool {
    matches!(math, Math::Operator { text, .. } if text == "′")
}

/// The primes of a superscript that has nothing else.
fn primes(sup: &Math) -> Option<Vec<Math>> {
    match sup {
        Math::Row(pieces) => {
            (!pieces.is_empty() && pieces.iter().all(is_prime)).then(|| pieces.clone())
        }
        prime => is_prime(prime).then(|| vec![prime.clone()]),
    }
}

/// Tells signs before operands from signs between them.
fn classify(row: &mut [Math], before: Atom) {
    let mut before = before;
    for piece in row {
        if let Math::Operator { class, .. } = piece {
            let is_sign = matches!(class, Class::Binary | Class::Prefix);
            if is_sign {
                *class = if before.makes_sign_unary() {
                    Class::Prefix
                } else {
                    Class::Binary
                };
            }
        }
        let atom = Atom::of(piece, &Empty).unwrap_or(Atom::Ordinary);
        if atom != Atom::Space {
            before = atom;
        }
    }
}
