//! What people type around a function: its unit, and the times for which it is meant to hold.

use crate::answer::typed::Manner;
use crate::unit::Unit;

/// How a function is read.
pub(super) fn manner(response: &str) -> Manner {
    Manner {
        comma_is_decimal: !response.contains("atan2"),
        has_imaginary_unit: false,
    }
}

/// A function with the unit that stands behind its first number taken out, `0.5 m exp(-t)`.
pub(super) fn unit_in_front(text: &str) -> Option<(String, Unit)> {
    let is_of_number = |char: char| char.is_ascii_digit() || ".,".contains(char);
    let start = text.trim_start_matches('(');
    let digits = start
        .find(|char| !is_of_number(char))
        .filter(|at| *at > 0)?;
    let (number, rest) = start.split_at(digits);
    let rest = rest.trim_start();
    let end = rest.find([' ', '*', '·', ')', '('])?;
    let unit = Unit::read(&rest[..end])
        .ok()
        .filter(|unit| !unit.is_one())?;
    let is_bracketed = start.len() < text.len() && rest[end..].starts_with(')');
    let rest = &rest[end + usize::from(is_bracketed)..];
    Some((
        format!("{number} {}", rest.trim_start_matches([' ', '*', '·'])),
        unit,
    ))
}

/// Without the times for which a function is meant to hold: `…, t >= 0` or `… for t > 0`.
pub(super) fn without_condition(response: &str) -> &str {
    let is_condition = |text: &str| text.contains(['<', '>', '≤', '≥']);
    let words = [",", ";", " for ", " if ", " when ", " where "].into_iter();
    let bracket = response.trim_end().ends_with(')').then_some("(");
    let cuts = words.chain(bracket).filter_map(|sign| response.rfind(sign));
    let cut = cuts.filter(|at| is_condition(&response[*at..])).min();
    cut.map_or(response, |at| response[..at].trim_end())
}
