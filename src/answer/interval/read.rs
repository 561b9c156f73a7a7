//! Reads inequalities and intervals.

use std::collections::BTreeMap;

use super::set::{End, Piece, Set};
use super::{Setup, Written, compared, quantity};
use crate::answer::typed::{self, Manner, cut};
use crate::expr::{Kind, Precise, Workspace};
use crate::source::Span;
use crate::unit::DecimalMark;

/// Reads sets for an instance.
pub(super) struct Ends<'a> {
    pub(super) setup: &'a Setup,
    pub(super) data: &'a [Precise],
    pub(super) mark: DecimalMark,
}

/// Longest response that is read, in bytes.
const LONGEST: usize = 2_000;

const HELP: &str = "Type for example `0.1 <= x < 0.5`, `x > 2` or `[0.1, 0.5)`.";

/// A sign between sides, told as `<`-like or `>`-like and whether its end is left out.
#[derive(Clone, Copy)]
struct Sign {
    is_less: bool,
    is_open: bool,
}

impl Ends<'_> {
    /// The set that a response is.
    pub(super) fn read(&self, response: &str) -> Result<Set, String> {
        if response.len() > LONGEST {
            return Err("This is too long to be read.".to_owned());
        }
        let text = normalized(response);
        let pieces = cut(&text, Span::new(0, text.len()), &[',', ';']);
        let is_relation = |piece: &Span| text[piece.range()].contains(['<', '>', '≤', '≥']);
        if pieces.len() > 1 && pieces.iter().all(is_relation) {
            return Err("Join the inequalities by `or`, or by `and`.".to_owned());
        }
        let mut pieces = Vec::new();
        for part in text.split('∪') {
            let mut set: Option<Set> = None;
            for condition in part.split('∩') {
                let own = self.condition(condition.trim())?;
                set = Some(match set {
                    None => own,
                    Some(set) => set.common(&own),
                });
            }
            pieces.extend(set.unwrap_or_default().0);
        }
        Ok(Set::of(pieces))
    }

    /// An interval in brackets, or a chain of inequalities.
    fn condition(&self, text: &str) -> Result<Set, String> {
        if text.is_empty() {
            return Err(HELP.to_owned());
        }
        let signs: Vec<(usize, char)> = text
            .char_indices()
            .filter(|(_, char)| "<>≤≥".contains(*char))
            .collect();
        if signs.is_empty() {
            return self.bracketed(text);
        }
        let mut sides = Vec::new();
        let mut start = 0;
        for (at, char) in &signs {
            sides.push(text[start..*at].trim());
            start = at + char.len_utf8();
        }
        sides.push(text[start..].trim());
        let signs: Vec<Sign> = signs
            .iter()
            .map(|(_, char)| Sign {
                is_less: "<≤".contains(*char),
                is_open: "<>".contains(*char),
            })
            .collect();
        if signs.len() == 1 && sides[0].is_empty() {
            // `≥ 0.3` speaks of what is asked.
            sides[0] = self.setup.variable.as_str();
        }
        let Some(place) = sides.iter().position(|side| self.is_variable(side)) else {
            return Err(format!(
                "`{}` does not stand in this inequality. {HELP}",
                self.setup.symbol.plain()
            ));
        };
        let mut piece = Piece([End::none(0), End::none(1)]);
        for (at, sign) in signs.iter().enumerate() {
            // Each sign bounds the variable by what stands on its other side.
            let (bound, is_less) = if at >= place {
                (sides[at + 1], sign.is_less)
            } else {
                (sides[at], !sign.is_less)
            };
            if at + 1 < place || at > place {
                return Err(format!("This chain of inequalities is too long. {HELP}"));
            }
            let value = self.side(bound)?;
            let own = End {
                value,
                is_open: sign.is_open || !value.is_finite(),
            };
            let end = usize::from(is_less);
            if piece.0[end].value.is_finite() {
                return Err(format!("Both signs point the same way. {HELP}"));
            }
            piece.0[end] = own;
        }
        one(piece)
    }

    /// `[a, b)`, `]a; b]`, `x in [a, b]`; several with commas in between.
    fn bracketed(&self, text: &str) -> Result<Set, String> {
        let start = text
            .find(['[', '(', ']'])
            .ok_or_else(|| format!("At `{text}`: no inequality sign and no interval. {HELP}"))?;
        let inner = text[start..].trim();
        let (unit_text, inner) = match inner.rfind([']', ')', '[']) {
            Some(end) if end > 0 => (inner[end + 1..].trim(), &inner[..=end]),
            _ => return Err(format!("A bracket is missing. {HELP}")),
        };
        let mut ends = inner.chars();
        let (first, last) = (ends.next(), ends.next_back());
        let body = ends.as_str();
        let Some(is_open_low) = first.map(|sign| sign != '[') else {
            return Err(HELP.to_owned());
        };
        let is_open_high = last != Some(']');
        let all = Span::new(0, body.len());
        let mut sides = cut(body, all, &[';']);
        if sides.len() == 1 {
            let is_comma_decimal = self.mark == DecimalMark::Comma;
            sides = if is_comma_decimal && body.contains(", ") {
                body.find(", ").map_or(sides, |at| {
                    vec![Span::new(0, at), Span::new(at + 1, body.len())]
                })
            } else {
                cut(body, all, &[','])
            };
        }
        let [low, high] = sides[..] else {
            return Err(format!("An interval has two ends. {HELP}"));
        };
        let with_unit = |span: Span| {
            let own = body[span.range()].trim();
            if unit_text.is_empty() || own.ends_with(|last: char| last.is_alphabetic()) {
                own.to_owned()
            } else {
                format!("{own} {unit_text}")
            }
        };
        let (low, high) = (self.side(&with_unit(low))?, self.side(&with_unit(high))?);
        let piece = Piece([
            End {
                value: low,
                is_open: is_open_low || !low.is_finite(),
            },
            End {
                value: high,
                is_open: is_open_high || !high.is_finite(),
            },
        ]);
        one(piece)
    }

    fn is_variable(&self, side: &str) -> bool {
        let typed = typed::formula(side, &self.setup.lexicon, Manner::default());
        typed.is_ok_and(
            |typed| matches!(typed.value.kind(), Kind::Name(name) if *name == self.setup.variable),
        )
    }

    /// The value of a side in SI units.
    fn side(&self, side: &str) -> Result<f64, String> {
        let number = quantity(side, &self.setup.unit, self.mark);
        if let Some(number) = number {
            return match self.setup.written {
                Written::Formula => Err("Give the bounds as formulas in symbols.".to_owned()),
                _ => Ok(number),
            };
        }
        let manner = Manner {
            comma_is_decimal: true,
            has_imaginary_unit: false,
        };
        let expr = typed::formula(side, &self.setup.lexicon, manner)
            .map_err(|error| error.sentence(side))?
            .value;
        if super::is_infinite(&expr) {
            let is_negative = !matches!(expr.kind(), Kind::Constant(_));
            return Ok(if is_negative {
                f64::NEG_INFINITY
            } else {
                f64::INFINITY
            });
        }
        let found = expr.check(&self.setup.meaning).map_err(|errors| {
            errors
                .first()
                .map_or(HELP.to_owned(), |error| format!("At `{side}`: {error}."))
        })?;
        let has_names = !expr.names().free.is_empty();
        if self.setup.written == Written::Number && has_names {
            return Err("Give the bounds as numbers.".to_owned());
        }
        if expr.names().uses(&self.setup.variable) {
            return Err(format!(
                "Solve for `{}` first. {HELP}",
                self.setup.symbol.plain()
            ));
        }
        if has_names && !found.fits(&compared(self.setup)) {
            return Err(format!(
                "At `{side}`: this has another dimension than `{}`.",
                self.setup.symbol.plain()
            ));
        }
        let program = self.setup.meaning.compile(&expr, &BTreeMap::new());
        let value = program.ok().and_then(|program| {
            program
                .evaluate(self.data, &mut Workspace::default())
                .ok()?
                .as_real()
        });
        let value = value.ok_or_else(|| format!("At `{side}`: this has no value."))?;
        Ok(if has_names {
            value
        } else {
            self.setup.unit.to_si(value)
        })
    }
}

/// The set of one interval; bounds in the wrong order are no interval.
fn one(piece: Piece) -> Result<Set, String> {
    let [low, high] = piece.0;
    if low.value > high.value {
        return Err(format!("The lower bound is above the upper one. {HELP}"));
    }
    Ok(Set::of(vec![piece]))
}

/// One spelling for signs and words that join.
fn normalized(response: &str) -> String {
    let response = response.trim().trim_end_matches(['.', ',', ';']);
    let inner = response
        .strip_prefix('(')
        .and_then(|text| text.strip_suffix(')'))
        .filter(|inner| inner.contains(['<', '>', '≤', '≥']) && !inner.contains(['(', ')']));
    let mut text = format!(" {} ", inner.unwrap_or(response));
    for (from, to) in [
        ("\\left", ""),
        ("\\right", ""),
        ("<=", "≤"),
        ("=<", "≤"),
        (">=", "≥"),
        ("=>", "≥"),
        ("\\leqslant", "≤"),
        ("\\leq", "≤"),
        ("\\le", "≤"),
        ("\\geqslant", "≥"),
        ("\\geq", "≥"),
        ("\\ge", "≥"),
        ("\\lt", "<"),
        ("\\gt", ">"),
        ("\\cup", "∪"),
        ("\\cap", "∩"),
        ("\\infty", "∞"),
        ("||", " ∪ "),
        ("&&", " ∩ "),
        ("∨", " ∪ "),
        ("∧", " ∩ "),
        (" OR ", " ∪ "),
        (" AND ", " ∩ "),
        (" Or ", " ∪ "),
        (" And ", " ∩ "),
        ("\\in ", " "),
        ("∈", " "),
        (" or ", " ∪ "),
        (" and ", " ∩ "),
        (" U ", " ∪ "),
        (" u ", " ∪ "),
        (" in ", " "),
        ("⩽", "≤"),
        ("⩾", "≥"),
    ] {
        text = text.replace(from, to);
    }
    // A comma between two intervals or inequalities joins them as well.
    for close in [")", "]", "["] {
        for open in ["(", "[", "]"] {
            for join in [", ", ",", "; ", ";", "U", "u"] {
                text = text.replace(
                    &format!("{close}{join}{open}"),
                    &format!("{close} ∪ {open}"),
                );
            }
        }
    }
    text.trim().to_owned()
}
