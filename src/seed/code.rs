//! Codes: a variant's number in base 32 with a check character, `K7Q-2M9-XF3`.
//!
//! The alphabet has no `I`, `L`, `O`, `U`; the first three are read as the digits they look like.
//! Nine characters in three groups are easy to copy, and no spreadsheet takes them for a number.
//!
//! The check character makes a weighted sum over the field of 32 elements vanish,
//!
//! ```text
//! a⁸ c₁ + a⁷ c₂ + ... + a c₈ + c₉ = 0        a: root of x⁵ + x² + 1, of order 31
//! ```
//!
//! so every single wrong character and every exchange of two, neighbours or not, is noticed: the weights
//! differ from each other and from zero.

use thiserror::Error;

const ALPHABET: &[u8; 32] = b"0123456789ABCDEFGHJKMNPQRSTVWXYZ";
// Eight characters of five bits hold a number of 40, the ninth is the check.
const LENGTH: usize = 9;
const GROUP: usize = 3;

/// Why a text is not a sheet's code.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum CodeError {
    /// A character that no code has.
    #[error("`{found}` does not occur in codes")]
    Character {
        /// The character.
        found: char,
        /// Its first byte in the text.
        at: usize,
    },
    /// Too few or too many characters.
    #[error("a code has {LENGTH} characters, this has {found}")]
    Length {
        /// How many there are, besides hyphens and spaces.
        found: usize,
    },
    /// The check character does not fit: there is a slip somewhere.
    #[error("the code is not quite right: a character is wrong, or two are exchanged")]
    Check,
}

/// The code of a number below 2⁴⁰.
pub(crate) fn write(number: u64) -> String {
    let digits: [u8; LENGTH - 1] =
        std::array::from_fn(|i| (number >> (5 * (LENGTH - 2 - i)) & 31) as u8);
    let check = times_a(digits.iter().fold(0, |sum, digit| times_a(sum) ^ digit));
    let mut code = String::with_capacity(LENGTH + 2);
    for (i, &digit) in digits.iter().chain([&check]).enumerate() {
        if i > 0 && i % GROUP == 0 {
            code.push('-');
        }
        code.push(char::from(ALPHABET[usize::from(digit)]));
    }
    code
}

/// The number in a code, which is read in any case and with any hyphens and spaces.
pub(crate) fn read(text: &str) -> Result<u64, CodeError> {
    let (mut number, mut sum, mut found) = (0_u64, 0, 0_usize);
    for (at, char) in text
        .char_indices()
        .filter(|&(_, char)| !char.is_whitespace() && char != '-')
    {
        let digit = digit(char).ok_or(CodeError::Character { found: char, at })?;
        if found < LENGTH - 1 {
            number = number << 5 | u64::from(digit);
        }
        sum = times_a(sum) ^ digit;
        found += 1;
    }
    match (found, sum) {
        (LENGTH, 0) => Ok(number),
        (LENGTH, _) => Err(CodeError::Check),
        _ => Err(CodeError::Length { found }),
    }
}

/// What a character counts, if it occurs in codes.
fn digit(char: char) -> Option<u8> {
    let upper = match char.to_ascii_uppercase() {
        'O' => '0',
        'I' | 'L' => '1',
        upper => upper,
    };
    ALPHABET
        .iter()
        .position(|&letter| char::from(letter) == upper)
        .map(|place| place as u8)
}

/// The product with `a` in the field of 32 elements, whose members are polynomials in `a` with bits as coefficients.
fn times_a(element: u8) -> u8 {
    let shifted = element << 1;
    if shifted & 32 == 0 {
        shifted
    } else {
        shifted ^ 0b10_0101
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn ends_of_the_range() {
        for (number, code) in [
            (0, "000-000-000"),
            (1, "000-000-012"),
            ((1 << 40) - 1, "ZZZ-ZZZ-ZZ3"),
        ] {
            assert_eq!(write(number), code);
            assert_eq!(read(code), Ok(number));
        }
    }

    #[test]
    fn reads_what_looks_alike() {
        assert_eq!(read("3pz hen yfb"), Ok(127_760_029_647));
        assert_eq!(read("ooo-OOO-OI2"), read("000-000-012"));
        assert_eq!(read("000-000-0l2"), read("000-000-012"));
    }

    #[test]
    fn says_what_is_wrong() {
        assert_eq!(
            read("3PZ-HEN-YUB"),
            Err(CodeError::Character { found: 'U', at: 9 })
        );
        assert_eq!(read("3PZ-HEN-YF"), Err(CodeError::Length { found: 8 }));
        assert_eq!(read("3PZ-HEN-YFBB"), Err(CodeError::Length { found: 10 }));
        assert_eq!(read(""), Err(CodeError::Length { found: 0 }));
        assert_eq!(read("3PZ-HEN-YFA"), Err(CodeError::Check));
    }

    proptest! {
        #[test]
        fn reading_inverts_writing(number in 0_u64..1 << 40) {
            prop_assert_eq!(read(&write(number)), Ok(number));
        }

        #[test]
        fn every_wrong_character_and_every_exchange_is_noticed(number in 0_u64..1 << 40) {
            let code: Vec<u8> = write(number).into_bytes().into_iter().filter(|&byte| byte != b'-').collect();
            let is_refused = |changed: Vec<u8>| read(&String::from_utf8(changed).unwrap()) == Err(CodeError::Check);
            for place in 0..LENGTH {
                for &wrong in ALPHABET.iter().filter(|&&wrong| wrong != code[place]) {
                    let mut changed = code.clone();
                    changed[place] = wrong;
                    prop_assert!(is_refused(changed));
                }
                for other in (0..place).filter(|&other| code[other] != code[place]) {
                    let mut changed = code.clone();
                    changed.swap(place, other);
                    prop_assert!(is_refused(changed));
                }
            }
        }

        #[test]
        fn any_text_is_read_or_refused(text in any::<String>()) {
            if let Ok(number) = read(&text) {
                prop_assert!(number < 1 << 40);
            }
        }
    }
}
