//! Decimals as they are written, for the exact numbers.

/// The most significant digits that are read: 38 nines still fit in the integer.
const MAX_DIGITS: usize = 38;

/// Reads a decimal such as `-12.50`, `.5` or `1e-4` as an integer and the power of ten of its last digit.
///
/// `None` where it is not a decimal, or has more than 38 significant digits.
pub(crate) fn read(text: &str) -> Option<(i128, i32)> {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (text, 0),
    };
    let unsigned = mantissa.strip_prefix(['-', '+']).unwrap_or(mantissa);
    let (whole, fraction) = unsigned.split_once('.').unwrap_or((unsigned, ""));
    let magnitude = digits(whole, fraction)?;
    let power = exponent.checked_sub(i32::try_from(fraction.len()).ok()?)?;
    let is_negative = mantissa.starts_with('-');
    Some((if is_negative { -magnitude } else { magnitude }, power))
}

fn digits(whole: &str, fraction: &str) -> Option<i128> {
    let mut digits = whole.bytes().chain(fraction.bytes()).peekable();
    digits.peek()?;
    digits
        .skip_while(|byte| *byte == b'0')
        .enumerate()
        .try_fold(0_i128, |magnitude, (at, byte)| {
            (byte.is_ascii_digit() && at < MAX_DIGITS)
                .then(|| 10 * magnitude + i128::from(byte - b'0'))
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_read_as_they_are_written() {
        for (text, read_as) in [
            ("12.50", (1250, -2)),
            ("-0.3", (-3, -1)),
            ("+.5", (5, -1)),
            ("3.", (3, 0)),
            ("1e-4", (1, -4)),
            ("1.5E+3", (15, 2)),
            ("0.000", (0, -3)),
        ] {
            assert_eq!(read(text), Some(read_as), "{text}");
        }
        let nines = "9".repeat(38);
        assert_eq!(read(&nines), Some((10_i128.pow(38) - 1, 0)));
        for text in [
            "",
            "-",
            ".",
            "e5",
            "1e",
            "1,5",
            "--1",
            "1.-5",
            "0x10",
            &(nines + "9"),
        ] {
            assert_eq!(read(text), None, "{text}");
        }
    }
}
