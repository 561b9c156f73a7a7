//! Values of the sheet in place of letters.

use super::marker::Prepared;
use crate::answer::equality::Comparable;
use crate::expr::{Expr, Name};

/// Values are rounded to three figures.
const ROUNDING: f64 = 5e-3;

/// Whether values of the sheet stand in a formula where the key has letters, `0.8 cos θ` for `ℓ cos θ`.
pub(crate) fn has_values(marker: &Prepared, formula: &Expr, typed: &Comparable) -> bool {
    let (setup, data) = (&marker.setup, &marker.data);
    // One as a value is not written: a letter that is missing is missing.
    let is_written = |letter: &Name| {
        let place = setup.meaning.place(letter);
        place.and_then(|place| data[place]) != Some(1.0)
    };
    let (used, letters) = (formula.names(), setup.shown.names());
    let mut missing = letters.free.iter().filter(|own| !used.uses(&own.name));
    let has_no_others = used.free.iter().all(|own| letters.uses(&own.name));
    has_no_others
        && missing.any(|own| is_written(&own.name))
        && marker
            .key
            .is_near(typed, &setup.meaning, data.clone(), ROUNDING)
}
