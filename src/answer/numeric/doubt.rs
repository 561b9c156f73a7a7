//! What may be meant otherwise than it would be read, and so is asked back: `162·10-3`, `0.29 (2/7)`, `1,250`, `60°30'`.

use super::super::{Unreadable, Why};
use crate::response::first_bracket;
use crate::unit::DecimalMark;

/// The question about a number that may mean two things, if it does.
pub(super) fn question(text: &str, mark: DecimalMark) -> Option<Unreadable> {
    comma(text)
        .filter(|_| mark == DecimalMark::Point)
        .map(Unreadable::of)
        .or_else(|| lost_power(text))
        .or_else(|| bracket(text))
        .or_else(|| minutes(text).map(Unreadable::of))
}

/// A number with one comma that cuts it into up to three digits and exactly three.
fn comma(text: &str) -> Option<Why> {
    let is_of_number = |char: char| char.is_ascii_digit() || char == ',' || char == '.';
    let is_open = |number: &&str| {
        number.split_once(',').is_some_and(|(whole, rest)| {
            (1..=3).contains(&whole.len())
                && !whole.starts_with('0')
                && rest.len() == 3
                && !number.contains('.')
        })
    };
    let number = text.split(|char| !is_of_number(char)).find(is_open)?;
    Some(Why::CommaOfThree {
        typed: number.to_owned(),
        decimal: number.replace(',', "."),
        thousands: number.replace(',', ""),
    })
}

/// A power of ten whose exponent is not raised, `162·10-3` and `1.25×103`, or behind a point, `162.10^-3`.
fn lost_power(text: &str) -> Option<Unreadable> {
    const TIMES: [&str; 9] = ["×", "*", "·", "⋅", "•", "x", "X", "\\cdot", "\\times"];
    text.match_indices("10").find_map(|(at, ten)| {
        let (before, after) = (&text[..at], &text[at + ten.len()..]);
        if let Some(whole) = before.strip_suffix('.') {
            let whole = trailing_number(whole);
            let is_raised = after.starts_with(['^', '⁻', '¹', '²', '³', '⁴', '⁵', '⁶', '⁹']);
            let is_open = is_raised && !whole.is_empty() && whole != "0";
            return is_open.then(|| {
                Unreadable::at(format!("{whole}.10"), Why::PointOrProduct(whole.to_owned()))
            });
        }
        let factor = before.trim_end();
        let factor = TIMES.iter().find_map(|sign| factor.strip_suffix(sign))?;
        if trailing_number(factor.trim_end()).is_empty() {
            return None;
        }
        let unsigned = after.strip_prefix(['-', '−', '–']).unwrap_or(after);
        let is_negative = unsigned.len() < after.len();
        let count = unsigned.bytes().take_while(u8::is_ascii_digit).count();
        let power = &unsigned[..count];
        let goes_on = unsigned[count..].starts_with(['.', ',']);
        let is_power = !goes_on
            && if is_negative {
                (1..=2).contains(&count)
            } else {
                count == 1 && power != "0"
            };
        is_power.then(|| {
            let sign = if is_negative { "-" } else { "" };
            Unreadable::at(
                format!("10{sign}{power}"),
                Why::LostPower(format!("{sign}{power}")),
            )
        })
    })
}

/// A number in brackets right behind another one, `7.78(1)`, or arithmetic with a space before it, `0.29 (2/7)`.
fn bracket(text: &str) -> Option<Unreadable> {
    text.match_indices(['(', '[', '{']).find_map(|(at, _)| {
        let before = text[..at].trim_end();
        let number = trailing_number(before);
        let is_name = before[..before.len() - number.len()].ends_with(char::is_alphabetic);
        let close = first_bracket(&text[at..]).filter(|_| !number.is_empty() && !is_name)?;
        let inner = text[at + 1..at + close].trim();
        let is_plain = inner
            .bytes()
            .all(|byte| byte.is_ascii_digit() || b".,".contains(&byte));
        let is_arithmetic = inner
            .starts_with(|char: char| char.is_ascii_digit() || "+-−.".contains(char))
            && !inner.contains(char::is_alphabetic);
        (is_plain || is_arithmetic && before.len() < at)
            .then(|| Unreadable::at(short(&text[at..=at + close]), Why::BracketAfterNumber))
    })
}

/// An angle in degrees and minutes.
fn minutes(text: &str) -> Option<Why> {
    let (_, behind) = text.split_once('°')?;
    let digits = behind.trim_start();
    let rest = digits.trim_start_matches(|char: char| char.is_ascii_digit());
    let is_minute = rest.len() < digits.len() && rest.trim_start().starts_with(['\'', '’', '′']);
    is_minute.then_some(Why::Minutes)
}

/// The digits with points and commas at the end of a text.
pub(super) fn trailing_number(text: &str) -> &str {
    let is_of_number = |char: char| char.is_ascii_digit() || char == '.' || char == ',';
    let number = &text[text.trim_end_matches(is_of_number).len()..];
    if number.contains(|char: char| char.is_ascii_digit()) {
        number
    } else {
        ""
    }
}

/// As much of a text as a message can quote.
pub(super) fn short(text: &str) -> String {
    const MOST: usize = 40;
    let start: String = text.trim().chars().take(MOST).collect();
    if start.len() < text.trim().len() {
        format!("{start}…")
    } else {
        start
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_may_mean_two_things_is_asked_back() {
        for text in [
            "1,250",
            "162·10-3 m",
            "5.0×10−3",
            "25.2 x 10-3",
            "1.25×103 m",
            "162.10^-3",
            "1.62.10⁻³",
            "7.78(1)",
            "0.29 (2/7)",
            "0.(285714)",
            "60°30'",
            "60° 0′ 0″",
        ] {
            assert!(question(text, DecimalMark::Point).is_some(), "{text}");
        }
        for text in [
            "1,25",
            "0,250",
            "162·10^-3 m",
            "4*10 - 3",
            "2*100",
            "2*1000 m",
            "0.10^2",
            "0.5*10^3",
            "log10(5)",
            "2(3+4)",
            "10^(-3)",
            "5 (1/s)",
            "100 [N/m]",
            "sqrt(2)(3)",
            "60.5°",
            "5'",
        ] {
            assert_eq!(question(text, DecimalMark::Point), None, "{text}");
        }
        assert_eq!(question("1,250", DecimalMark::Comma), None);
    }
}
