//! Reading decimals: as files have them, and as people type them.

use super::decimal::Decimal;
use super::error::{Error, ErrorKind};
use super::notation::DecimalMark;
use super::scanner::Scanner;
use super::strict::MAX_LENGTH;

/// The digits of a number while it is read.
#[derive(Clone, Copy, Default)]
struct Digits {
    significand: u128,
    exponent: i32,
    /// How many digits are kept, from the first that is not zero.
    kept: u32,
    /// Digits beyond those that are kept.
    dropped: u32,
}

impl Digits {
    fn push(&mut self, digit: u8, after_point: bool) {
        let digit = u128::from(digit - b'0');
        if self.kept < Decimal::MAX_DIGITS {
            self.significand = 10 * self.significand + digit;
            self.kept += u32::from(self.significand > 0);
            self.exponent -= i32::from(after_point);
            return;
        }
        // Rounded up, 38 nines would take one digit more.
        if self.dropped == 0
            && digit >= 5
            && self.significand + 1 < 10_u128.pow(Decimal::MAX_DIGITS)
        {
            self.significand += 1;
        }
        self.dropped += 1;
        self.exponent += i32::from(!after_point);
    }
}

/// Reads the decimal at the beginning of a text, as files have it; returns its length too.
pub(crate) fn strict(text: &str) -> Result<(Decimal, usize), Error> {
    let bytes = text.as_bytes();
    let is_digit = |at: usize| bytes.get(at).is_some_and(u8::is_ascii_digit);
    let run = |from: usize| {
        (from..bytes.len())
            .find(|&at| !is_digit(at))
            .unwrap_or(bytes.len())
    };
    let start = usize::from(matches!(bytes.first(), Some(b'-' | b'+')));
    let mut end = run(start);
    if text.len() > MAX_LENGTH || end == start {
        return Err(not_a_number(text));
    }
    let mut digits = Digits::default();
    bytes[start..end]
        .iter()
        .for_each(|&digit| digits.push(digit, false));
    // Two points are those of a range.
    if bytes.get(end) == Some(&b'.') && bytes.get(end + 1) != Some(&b'.') {
        let tenths = end + 1;
        end = run(tenths);
        if end == tenths {
            return Err(not_a_number(text));
        }
        bytes[tenths..end]
            .iter()
            .for_each(|&digit| digits.push(digit, true));
    }
    let mut scientific = false;
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'-' | b'+')));
        if is_digit(end + 1 + sign) {
            let stop = run(end + 1 + sign);
            digits.exponent += power(&text[end + 1..stop]);
            end = stop;
            scientific = true;
        }
    }
    if digits.dropped > 0 {
        return Err(Error::new(
            ErrorKind::TooManyDigits {
                limit: Decimal::MAX_DIGITS,
            },
            0..end,
        ));
    }
    let decimal = Decimal::of_parts(
        bytes[0] == b'-',
        digits.significand,
        digits.exponent,
        scientific,
    );
    Ok((
        decimal.ok_or_else(|| Error::new(ErrorKind::OutOfRange, 0..end))?,
        end,
    ))
}

/// A power of ten; what is too large for it is out of range anyway.
fn power(text: &str) -> i32 {
    let size = text
        .bytes()
        .filter(u8::is_ascii_digit)
        // Bounded on the way, as digits without end would overflow.
        .fold(0_i32, |power, digit| {
            (power * 10 + i32::from(digit - b'0')).min(100_000)
        });
    if text.starts_with('-') { -size } else { size }
}

fn not_a_number(text: &str) -> Error {
    if text.is_empty() {
        return Error::new(ErrorKind::NumberMissing, 0..0);
    }
    if text.len() > MAX_LENGTH {
        return Error::new(ErrorKind::TooLong { limit: MAX_LENGTH }, 0..text.len());
    }
    let end = text.find(char::is_whitespace).unwrap_or(text.len());
    Error::new(
        ErrorKind::NotANumber {
            found: excerpt(&text[..end]),
        },
        0..end,
    )
}

/// The beginning of a text, for a message.
pub(crate) fn excerpt(text: &str) -> String {
    text.chars().take(40).collect()
}

/// Reads the decimal at the beginning of a text as people type it: `2,52`, `−1.6`, `.5`, `1 200`, `3×10^-4`, `10⁻³`.
///
/// Digits beyond the 38th are rounded away.
pub(crate) fn lenient(text: &str, mark: DecimalMark) -> Result<(Decimal, usize), Error> {
    let mut scanner = Scanner::new(text)?;
    let negative = ['-', '−', '–'].into_iter().any(|sign| scanner.takes(sign));
    if !negative {
        scanner.takes('+');
    }
    let start = scanner.at();
    let body = body(scanner.rest());
    let point =
        decimal_point(body, mark).map_err(|kind| Error::new(kind, start..start + body.len()))?;
    let mut digits = Digits::default();
    for (at, byte) in body
        .bytes()
        .enumerate()
        .filter(|(_, byte)| byte.is_ascii_digit())
    {
        digits.push(byte, point.is_some_and(|point| at > point));
    }
    if digits.kept == 0 && !body.contains('0') {
        return Err(not_a_number(text));
    }
    scanner.takes_text(body);
    let bare = if body == "10" {
        exponent_of_ten(&mut scanner)
    } else {
        None
    };
    if bare.is_some() {
        digits = Digits {
            significand: 1,
            ..Digits::default()
        };
    }
    let power = bare.or_else(|| power_of_ten(&mut scanner));
    digits.exponent += power.unwrap_or(0);
    let decimal = Decimal::of_parts(
        negative,
        digits.significand,
        digits.exponent,
        power.is_some(),
    );
    Ok((
        decimal.ok_or_else(|| Error::new(ErrorKind::OutOfRange, 0..scanner.at()))?,
        scanner.at(),
    ))
}

/// The digits at the beginning of a text, with points, commas, spaces and apostrophes between groups of three.
fn body(text: &str) -> &str {
    let digits = |from: usize| text[from..].bytes().take_while(u8::is_ascii_digit).count();
    let next = |at: usize| text[at..].chars().next();
    let mut end = digits(0);
    while let Some(space) = next(end).filter(|char| GROUP_SIGNS.contains(char)) {
        let group = end + space.len_utf8();
        // `12 345` is one number, `2024 365` are two.
        if digits(0) == 0 || digits(0) > 3 || digits(group) != 3 {
            break;
        }
        end = group + 3;
    }
    while let Some('.' | ',') = next(end) {
        match digits(end + 1) {
            // A point may end a number, but two are those of a range.
            0 if end > 0 && next(end) == Some('.') && next(end + 1) != Some('.') => {
                return &text[..=end];
            }
            0 => break,
            digits => end += 1 + digits,
        }
    }
    &text[..end]
}

/// What people put between groups of three digits, beside points and commas.
const GROUP_SIGNS: [char; 6] = [' ', '\u{a0}', '\u{2009}', '\u{202f}', '\'', '’'];

/// Where the decimal point or comma stands in a number.
fn decimal_point(body: &str, mark: DecimalMark) -> Result<Option<usize>, ErrorKind> {
    let (points, commas) = (body.matches('.').count(), body.matches(',').count());
    let not_a_number = || ErrorKind::NotANumber {
        found: excerpt(body),
    };
    let (separator, decimal) = match (points, commas) {
        (0, 0) => return Ok(None),
        (1, 0) => return Ok(body.find('.')),
        // `1,234` is more than a thousand for some and little more than one for others; `0,234` is a decimal
        // for all.
        (0, 1) if mark == DecimalMark::Point && grouped(body, ',') && !body.starts_with('0') => {
            return Err(ErrorKind::AmbiguousComma {
                found: excerpt(body),
            });
        }
        (0, 1) => return Ok(body.find(',')),
        (_, 0) => ('.', None),
        (0, _) => (',', None),
        (1, 1) if body.find('.') < body.find(',') => ('.', body.find(',')),
        (1, _) => (',', body.find('.')),
        (_, 1) => ('.', body.find(',')),
        _ => return Err(not_a_number()),
    };
    let whole = &body[..decimal.unwrap_or(body.len())];
    if grouped(whole, separator) && !body[whole.len()..].contains(separator) {
        Ok(decimal)
    } else {
        Err(not_a_number())
    }
}

/// Whether a separator cuts a number into groups of three digits.
fn grouped(whole: &str, separator: char) -> bool {
    let mut groups = whole.split(separator);
    groups
        .next()
        // `1.5.2` is a section of a book or a date, and no number of thousands.
        .is_some_and(|first| (1..=3).contains(&first.len()))
        && groups.all(|group| group.len() == 3)
}

/// A power of ten after a number: `e-4`, `×10^-4`, `·10⁻⁴`, `\times 10^{-4}`.
fn power_of_ten(scanner: &mut Scanner<'_>) -> Option<i32> {
    let mut ahead = *scanner;
    let mut spaced = ahead;
    spaced.space();
    // `77.8 e-1`, but the letter of `5 e` or `2 e^3` is another one.
    let marked = spaced.rest().strip_prefix(['e', 'E']);
    if marked.is_some_and(is_exponent) {
        ahead = spaced;
    }
    let power = if ahead.takes('e') || ahead.takes('E') {
        let power = ahead.plain_exponent().filter(|power| power.is_integer())?;
        power.numerator()
    } else {
        ahead.space();
        TIMES_SIGNS
            .into_iter()
            .find(|sign| ahead.takes_text(sign))?;
        ahead.space();
        if !ahead.takes_text("10") {
            return None;
        }
        exponent_of_ten(&mut ahead)?
    };
    *scanner = ahead;
    Some(power)
}

/// Whether an integer stands alone at the beginning of a text.
fn is_exponent(text: &str) -> bool {
    let unsigned = text.strip_prefix(['-', '−', '–', '+']).unwrap_or(text);
    let rest = unsigned.trim_start_matches(|char: char| char.is_ascii_digit());
    rest.len() < unsigned.len()
        && !rest.starts_with(|char: char| char.is_alphanumeric() || char == '.' || char == ',')
}

/// What people put before a power of ten.
const TIMES_SIGNS: [&str; 8] = ["×", "*", "·", "⋅", "x", "X", "\\times", "\\cdot"];

/// What stands after the `10` of a power of ten.
fn exponent_of_ten(scanner: &mut Scanner<'_>) -> Option<i32> {
    let mut ahead = *scanner;
    let raised = ahead.takes('^') || ahead.takes_text("**");
    let power = if raised {
        ahead.exponent(true)
    } else {
        ahead.superscript()
    };
    let power = power.filter(|power| power.is_integer())?;
    *scanner = ahead;
    Some(power.numerator())
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn reads_numbers_as_they_are_typed() {
        for (typed, value, rest) in [
            ("2,52 Hz", 2.52, " Hz"),
            ("2.52Hz", 2.52, "Hz"),
            ("-1.5", -1.5, ""),
            ("−1,5", -1.5, ""),
            ("–1.5", -1.5, ""),
            ("+3", 3.0, ""),
            (".5", 0.5, ""),
            (",5 m", 0.5, " m"),
            ("5.", 5.0, ""),
            ("5 N", 5.0, " N"),
            ("0,125", 0.125, ""),
            ("1200,5", 1200.5, ""),
            ("1,2345", 1.2345, ""),
            ("1,234.5", 1234.5, ""),
            ("1.234,5", 1234.5, ""),
            ("1,234,567", 1_234_567.0, ""),
            ("1 200 N", 1200.0, " N"),
            ("1\u{202f}200,5", 1200.5, ""),
            ("12 3 N", 12.0, " 3 N"),
            ("1.6e-2 m", 0.016, " m"),
            ("1.6E−2", 0.016, ""),
            ("3×10^-4", 3e-4, ""),
            ("3·10⁻⁴ m", 3e-4, " m"),
            ("3 * 10^(-4)", 3e-4, ""),
            ("3*10**-4", 3e-4, ""),
            ("3x10^4", 3e4, ""),
            ("3 \\times 10^{-4} m", 3e-4, " m"),
            ("3 \\cdot 10^{4}", 3e4, ""),
            ("77.8 e-1 m", 7.78, " m"),
            ("7.78X10^1", 77.8, ""),
            ("5e–3 m", 0.005, " m"),
            ("1'250 m", 1250.0, " m"),
            ("5 e m", 5.0, " e m"),
            ("5 e-0.75t", 5.0, " e-0.75t"),
            ("5 e-3t", 5.0, " e-3t"),
            ("10^-4 m", 1e-4, " m"),
            ("10⁻⁴", 1e-4, ""),
            ("10 m", 10.0, " m"),
            ("3e", 3.0, "e"),
            ("3·m", 3.0, "·m"),
            (
                "0.333333333333333333333333333333333333333333333333",
                1.0 / 3.0,
                "",
            ),
        ] {
            let (decimal, length) = lenient(typed, DecimalMark::Point)
                .unwrap_or_else(|error| panic!("`{typed}`: {error}"));
            assert_eq!(
                (decimal.to_f64(), &typed[length..]),
                (value, rest),
                "`{typed}`"
            );
        }
    }

    #[test]
    fn asks_back_where_a_comma_may_mean_two_things() {
        let error = lenient("1,250 N", DecimalMark::Point).unwrap_err();
        assert_eq!(error.help().as_deref(), Some("write `1.250` or `1250`"));
        assert_eq!(error.span, 0..5);
        assert_eq!(
            lenient("1,250", DecimalMark::Comma).unwrap().0.to_string(),
            "1.250"
        );
    }

    #[test]
    fn refuses_what_is_no_number() {
        for typed in [
            "",
            "x",
            "-",
            ".",
            "1,2,3",
            "1.2.3",
            "12,34.5",
            "1e999",
            "3×10^999",
            "NaN",
        ] {
            assert!(lenient(typed, DecimalMark::Point).is_err(), "`{typed}`");
        }
    }

    proptest! {
        #[test]
        fn any_text_of_number_characters_is_read_or_refused(text in "[0-9., eE×·*^⁻²+−\u{202f}-]{0,20}") {
            if let Ok((_, length)) = lenient(&text, DecimalMark::Point) {
                prop_assert!(text.is_char_boundary(length));
            }
        }
    }
}
