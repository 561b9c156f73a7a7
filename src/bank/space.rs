//! Working space: room on the paper for what is worked out by hand.

use std::fmt;

/// Room for work under a question.
///
/// ```
/// use vibank::bank::Space;
/// let space = Space::read("6 cm squared").unwrap();
/// assert_eq!((space.millimetres(), space.name()), (60, "squared"));
/// assert_eq!(Space::read("8 lines").unwrap().lines(), 8);
/// assert_eq!(Space::read("none"), Ok(Space::None));
/// assert!(Space::read("5 inches").is_err());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    /// None, whatever is said elsewhere.
    None,
    /// Blank paper of this height, in mm.
    Blank(u16),
    /// This many ruled lines.
    Lines(u16),
    /// Squared paper of this height, in mm: this many whole squares.
    Squared(u16),
}

/// A text that names no working space.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{0}` is not a working space")]
pub struct SpaceError(pub String);

impl SpaceError {
    /// What can be written in its place.
    pub const HELP: &'static str =
        "write \"5 cm\", \"6 cm squared\", \"8 lines\" or \"none\"; at most 20 cm or 25 lines";
}

impl Space {
    /// That of work that a person marks, where nothing else is said.
    pub(crate) const OF_WORK: Self = Self::Blank(60);
    /// From line to line, in mm.
    pub(crate) const LINE: u16 = 8;
    /// The side of a square, in mm.
    pub(crate) const SQUARE: u16 = 5;
    /// The highest, in mm: with its question it still fits on a page.
    pub const MAX_COUNT: u16 = 200;

    /// The space that a text names.
    ///
    /// # Errors
    ///
    /// [`SpaceError`]: the text is none of the forms, or the space has no height or more than fits on a page.
    pub fn read(text: &str) -> Result<Self, SpaceError> {
        let space = Self::of_words(&text.split_whitespace().collect::<Vec<_>>());
        space.ok_or_else(|| SpaceError(text.to_owned()))
    }

    fn of_words(words: &[&str]) -> Option<Self> {
        match words {
            ["none"] => Some(Self::None),
            [count, "line" | "lines"] => {
                let count = count.parse().ok()?;
                Some(Self::Lines(count))
                    .filter(|_| (1..=Self::MAX_COUNT / Self::LINE).contains(&count))
            }
            [number, unit] => millimetres(number, unit).map(Self::Blank),
            [number, unit, "squared"] => {
                let height = millimetres(number, unit)?;
                Some(Self::Squared(height.next_multiple_of(Self::SQUARE)))
            }
            _ => None,
        }
    }

    /// Its height in mm.
    pub fn millimetres(self) -> u16 {
        match self {
            Self::None => 0,
            Self::Blank(height) | Self::Squared(height) => height,
            Self::Lines(count) => count * Self::LINE,
        }
    }

    /// How many lines fit in it.
    pub fn lines(self) -> u16 {
        match self {
            Self::Lines(count) => count,
            Self::None | Self::Blank(_) | Self::Squared(_) => {
                self.millimetres().div_ceil(Self::LINE)
            }
        }
    }

    /// What it looks like: `none`, `blank`, `lines` or `squared`.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Blank(_) => "blank",
            Self::Lines(_) => "lines",
            Self::Squared(_) => "squared",
        }
    }
}

/// As it is written in files.
impl fmt::Display for Space {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::None => f.write_str("none"),
            Self::Blank(height) => write!(f, "{height} mm"),
            Self::Lines(count) => write!(f, "{count} lines"),
            Self::Squared(height) => write!(f, "{height} mm squared"),
        }
    }
}

/// A length in whole millimetres, at most one that fits on a page.
fn millimetres(number: &str, unit: &str) -> Option<u16> {
    let number: f64 = number.parse().ok()?;
    let scale = match unit {
        "mm" => 1.0,
        "cm" => 10.0,
        _ => return None,
    };
    let height = (number * scale).round();
    let fits = (1.0..=f64::from(Space::MAX_COUNT)).contains(&height);
    fits.then_some(height as u16)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_are_whole_and_fit_on_a_page() {
        for (text, space) in [
            ("none", Space::None),
            ("5 cm", Space::Blank(50)),
            ("45 mm", Space::Blank(45)),
            ("2.5 cm", Space::Blank(25)),
            ("1 line", Space::Lines(1)),
            ("25 lines", Space::Lines(25)),
            ("20 cm squared", Space::Squared(200)),
            // Squares are whole.
            ("52 mm squared", Space::Squared(55)),
        ] {
            assert_eq!(Space::read(text), Ok(space), "{text}");
            assert_eq!(Space::read(&space.to_string()), Ok(space), "{text}");
        }
        let wrong = [
            "",
            "5",
            "5cm",
            "0 cm",
            "-1 cm",
            "21 cm",
            "1e9 cm",
            "nan cm",
            "0 lines",
            "26 lines",
            "1.5 lines",
            "5 cm lines",
            "8 lines squared",
            "70000 lines",
        ];
        for text in wrong {
            assert!(Space::read(text).is_err(), "{text}");
        }
    }
}
