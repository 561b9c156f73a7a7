//! What a wrong answer is, worded so that alike ones of different variants are recognized.

use crate::answer::Marking;
use crate::solution::Solution;
use crate::unit::Decimal;

/// A wrong answer without its data: a number as a multiple of the key in three figures, all else as it was read.
pub fn pattern(solution: &Solution<'_>, place: usize, marking: &Marking) -> Option<String> {
    const MAX_LENGTH: usize = 80;
    let reading = marking.reading.as_ref()?;
    if let [number] = reading.answered.si()[..]
        && let Ok(marker) = solution.marker(place)
        && let Some(key) = marker.number()
        && key != 0.0
    {
        let ratio = Decimal::rounded(number / key, 3)?;
        return Some(format!("{ratio} × the key"));
    }
    let text = reading.text.as_str();
    Some(match text.char_indices().nth(MAX_LENGTH) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    })
}
