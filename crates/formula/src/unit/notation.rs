//! How numbers are printed.

/// What separates the decimals of a number.
///
/// # Examples
///
/// ```
/// use vibank_formula::unit::{DecimalMark, Quantity};
///
/// let mass = Quantity::parse("2.50 kg").unwrap();
/// assert_eq!(mass.text(DecimalMark::Comma), "2,50 kg");
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum DecimalMark {
    /// `2.5`
    #[default]
    Point,
    /// `2,5`
    Comma,
}

impl DecimalMark {
    /// The one of a character.
    pub const fn of_char(char: char) -> Option<Self> {
        match char {
            '.' => Some(Self::Point),
            ',' => Some(Self::Comma),
            _ => None,
        }
    }

    /// The character.
    pub const fn char(self) -> char {
        match self {
            Self::Point => '.',
            Self::Comma => ',',
        }
    }
}
