//! What people type around a function: the times for which it is meant to hold.

use crate::response::Manner;

/// How a function is read.
pub(super) const MANNER: Manner = Manner {
    comma_is_decimal: true,
    has_imaginary_unit: false,
    values: None,
};

/// Without the times for which a function is meant to hold: `…, t >= 0` or `… for t > 0`.
pub(super) fn without_condition(response: &str) -> &str {
    let is_condition = |text: &str| text.contains(['<', '>', '≤', '≥']);
    let words = [",", ";", " for ", " if ", " when ", " where "].into_iter();
    let bracket = response.trim_end().ends_with(')').then_some("(");
    let cuts = words.chain(bracket).filter_map(|sign| response.rfind(sign));
    let cut = cuts.filter(|at| is_condition(&response[*at..])).min();
    cut.map_or(response, |at| response[..at].trim_end())
}
