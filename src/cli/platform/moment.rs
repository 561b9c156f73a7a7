//! When an attempt was made, as a site writes dates: only the order of two of them matters.

/// A date and time, largest unit first.
pub(crate) type Moment = [u32; 6];

/// How months begin in English, German, French, Spanish, Italian, Portuguese and Dutch.
const MONTHS: [&[&str]; 12] = [
    &["jan", "jän", "ene", "gen"],
    &["feb", "fév", "fev"],
    &["mar", "mär", "maa", "mrt"],
    &["apr", "avr", "abr"],
    &["may", "mai", "mei", "mag"],
    &["jun", "juin", "giu"],
    &["jul", "juil", "lug"],
    &["aug", "aoû", "ago"],
    &["sep", "set"],
    &["oct", "okt", "ott", "out"],
    &["nov"],
    &["dec", "dez", "déc", "dic"],
];

/// Reads `2026-11-02 17:20:09 UTC`, `Monday, 2 November 2026, 5:20 PM`, `2. November 2026 17:20`.
pub(crate) fn moment(text: &str) -> Option<Moment> {
    let text = text.to_lowercase();
    let words: Vec<&str> = text
        .split(|char: char| !char.is_alphanumeric())
        .filter(|word| !word.is_empty())
        .collect();
    let mut numbers = words.iter().filter_map(|word| word.parse::<u32>().ok());
    // From behind, since days of the week stand before months and may begin like them: `mardi 3 mars`.
    let month = words.iter().rev().find_map(|word| {
        let is_own = |names: &&[&str]| names.iter().any(|name| word.starts_with(name));
        let number = MONTHS.iter().position(is_own)? as u32 + 1;
        word.chars().all(char::is_alphabetic).then_some(number)
    });
    let (year, month, day) = match month {
        Some(month) => {
            let (first, second) = (numbers.next()?, numbers.next()?);
            let (year, day) = if first > 31 {
                (first, second)
            } else {
                (second, first)
            };
            (year, month, day)
        }
        None => (numbers.next()?, numbers.next()?, numbers.next()?),
    };
    let (hour, minute) = (numbers.next()?, numbers.next()?);
    let second = numbers.next().filter(|second| *second < 60).unwrap_or(0);
    let hour = match (words.contains(&"pm"), words.contains(&"am"), hour) {
        (true, _, 1..=11) => hour + 12,
        (_, true, 12) => 0,
        _ => hour,
    };
    let is_date = (1970..=9999).contains(&year)
        && (1..=12).contains(&month)
        && (1..=31).contains(&day)
        && hour < 24
        && minute < 60;
    is_date.then_some([year, month, day, hour, minute, second])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_of_sites_are_ordered() {
        let same = [2026, 11, 2, 17, 20, 0];
        for text in [
            "2026-11-02 17:20:00 UTC",
            "2 November 2026  5:20 PM",
            "Monday, 2 November 2026, 5:20 PM",
            "2. November 2026 17:20",
            "lundi 2 novembre 2026, 17:20",
            "mardi 2 novembre 2026, 17:20",
            "lunes, 2 de noviembre de 2026, 17:20",
        ] {
            assert_eq!(moment(text), Some(same), "{text}");
        }
        assert_eq!(
            moment("1 January 2026 12:05 AM"),
            Some([2026, 1, 1, 0, 5, 0])
        );
        for text in [
            "",
            "-",
            "Finished",
            "12 mins 5 secs",
            "8.50",
            "Maria Marsch",
        ] {
            assert_eq!(moment(text), None, "{text}");
        }
    }
}
