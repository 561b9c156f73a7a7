//! How long an exam lasts, as a blueprint has it in words.

/// The minutes in words such as `90 minutes`, `1 h 30`, `1.5 hours`, `1 h 30 min`; none where it is not a duration.
pub(crate) fn minutes(words: &str) -> Option<f64> {
    let words = words.to_lowercase().replace(',', ".");
    let mut rest = words.trim();
    let (mut sum, mut was_hours) = (None, false);
    while !rest.is_empty() {
        let end = rest.find(|sign: char| !sign.is_ascii_digit() && sign != '.');
        let (number, behind) = rest.split_at(end.unwrap_or(rest.len()));
        let number: f64 = number.parse().ok()?;
        let behind = behind.trim_start();
        let end = behind.find(|sign: char| sign.is_ascii_digit());
        let (unit, behind) = behind.split_at(end.unwrap_or(behind.len()));
        let unit = unit.trim();
        let is_hours =
            unit.starts_with('h') || unit.starts_with("std") || unit.starts_with("stunde");
        let is_minutes = unit.starts_with('m') || unit.is_empty() && was_hours;
        let minutes = match (is_hours, is_minutes) {
            (true, _) => 60.0 * number,
            (_, true) => number,
            _ => return None,
        };
        sum = Some(sum.unwrap_or(0.0) + minutes);
        (was_hours, rest) = (is_hours, behind);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::minutes;

    #[test]
    fn durations_are_read_as_people_write_them() {
        for (words, expected) in [
            ("90 minutes", Some(90.0)),
            ("90 min", Some(90.0)),
            ("1 h 30", Some(90.0)),
            ("1h30", Some(90.0)),
            ("1 hour 30 minutes", Some(90.0)),
            ("1.5 hours", Some(90.0)),
            ("1,5 h", Some(90.0)),
            ("2 Stunden", Some(120.0)),
            ("a while", None),
            ("90", None),
            ("3 days", None),
            ("", None),
            ("1.2.3 h", None),
        ] {
            assert_eq!(minutes(words), expected, "{words}");
        }
    }
}
