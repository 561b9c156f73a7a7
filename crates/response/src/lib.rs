//! Formulas as people type them.
//!
//! Files are read strictly, responses leniently: products need no sign and are split by the item's own
//! names (`mgl`, `2zeta omega_n`, `kl²`), Greek letters come as words or signs, subscripts with or
//! without underscore, and the signs of paper (`√`, `²`, `·`, `×`, `−`) stand beside `^`, `**`, `x''`,
//! `xdot`, `d²x/dt²` and simple LaTeX. What was read is echoed; what cannot be read is refused with
//! its place and with what to type instead. Nothing is guessed in silence.
//!
//! ```
//! use vibank_formula::expr::{Expr, Name};
//! use vibank_notation::symbol;
//! use vibank_response::{Folded, Lexicon, Manner};
//!
//! let mut lexicon = Lexicon::new();
//! for name in ["k", "m"] {
//!     lexicon.allow(&Name::new(name), symbol(name), false);
//! }
//! // LaTeX, words and the signs of paper become one spelling, which is read with the names of the item.
//! let folded = Folded::of(r"\sqrt{\frac{k}{2m}}").expect("no dollar sign stands alone");
//! let typed = folded.passage().formula(&lexicon, Manner::default()).expect("it is a formula");
//! assert_eq!(typed.value, Expr::read("sqrt(k/(2*m))")?);
//! # Ok::<(), vibank_formula::expr::ReadError>(())
//! ```
//!
//! # The slash
//!
//! A slash takes what stands right after it, without a space: `k/2m` is `k/(2m)`, while `k/2 m` is `(k/2) m`.
//! Between two numbers it is a fraction: `1/2mv²` is `½ m v²`. What comes after a bracket does not
//! belong to the divisor: `1/(2m)c` is `c/(2m)`.
//!
//! # Other readings
//!
//! How far a divisor reaches, a root or a function without brackets, an exponent, may be meant otherwise than the
//! rules have it. A text has all its other readings, too: a kind takes one where only that has the
//! right dimension, and asks back where one is right that was not taken.

mod again;
mod amount;
mod answering;
mod arguments;
mod around_token;
mod aside;
mod before_unit;
mod both_signs;
mod calls;
mod components;
mod composition;
mod conjugates;
mod counts;
mod customary;
mod defined;
mod derivative;
mod determinant;
mod differential;
mod digits;
mod distance;
mod entry_units;
mod equated;
mod equations;
mod error;
mod fold;
mod folded;
mod frame;
mod free_letters;
mod identity;
mod label;
mod labels;
mod latex;
mod layout;
mod letters;
mod lexer;
mod lexicon;
mod list;
mod lost_power;
mod matrix_form;
mod measured;
mod naming;
mod near;
mod nothing;
mod number;
mod parser;
mod passage;
mod phrase;
mod pieces;
mod ranges;
mod ranks;
mod related;
mod relation;
mod reworded;
mod senses;
mod sides;
mod signs;
mod spellings;
mod stated;
mod statements;
mod subscript;
mod surroundings;
mod token;
mod values;
mod vocabulary;
mod ways;
mod wording;
mod words;

pub use amount::{Amount, Number, has_pi};
pub use before_unit::BeforeUnit;
pub use customary::{E_FOR_EPSILON, L_FOR_ELL, is_customary};
pub use defined::Defining;
pub use error::TypedError;
pub use error::{At, Trouble, ValueTrouble};
pub use folded::{Folded, LoneDollar};
pub use label::Label;
pub use lexicon::Lexicon;
pub use list::{Listed, Wanted};
pub use measured::Measured;
pub use naming::{label_behind, label_in_front, parted};
pub use nothing::unit_of_zero;
pub use passage::Passage;
pub use phrase::Phrase;
pub use pieces::FunctionPiece;
pub use ranges::{AskedBound, Bounding, Condition, Group, RangeError, Ranges, Said};
pub use reworded::Reworded;
pub use senses::Senses;
pub use stated::Stated;
pub use surroundings::{behind_arrow, withdrawn};
pub use values::{Part, Style, Values};
pub use wording::Wording;

use self::lexer::tokens;
use self::parser::Parser;
use self::ways::readings;
use vibank_formula::expr::{Expr, Relation};
use vibank_formula::unit::DecimalMark;

/// Longest response that is read, in bytes.
const MAX_LENGTH: usize = 2_000;
/// Deepest formula that is read; deeper ones would strain the recursion of what follows.
const MAX_DEPTH: u32 = 150;

/// How a text is to be read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Manner {
    /// Whether a comma between two digits is a decimal sign.
    pub comma_is_decimal: bool,
    /// Whether `i` and `j` are the imaginary unit.
    pub has_imaginary_unit: bool,
    /// For values: units come after numbers, and decimals are exact, with this decimal sign.
    pub values: Option<DecimalMark>,
    /// Whether letters that are not known may be names in the other case, `M` for m.
    pub is_in_any_case: bool,
}

impl Manner {
    /// For formulas of real numbers.
    pub const REAL: Self = Self {
        comma_is_decimal: true,
        has_imaginary_unit: false,
        values: None,
        is_in_any_case: false,
    };
    /// For formulas of complex numbers.
    pub const COMPLEX: Self = Self {
        has_imaginary_unit: true,
        ..Self::REAL
    };

    /// The same where letters may be names in the other case.
    #[must_use]
    pub fn in_any_case(self) -> Self {
        Self {
            is_in_any_case: true,
            ..self
        }
    }
}

/// What was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Typed<T> {
    /// By the rules.
    pub value: T,
    /// What it may be meant as otherwise, the nearest to the rules first.
    pub others: Vec<T>,
}

impl<T> Typed<T> {
    /// The first reading that fits; that of the rules where none does.
    pub fn fitting(self, fits: impl Fn(&T) -> bool) -> T {
        if fits(&self.value) {
            return self.value;
        }
        self.others.into_iter().find(fits).unwrap_or(self.value)
    }
}

/// An equation, or a chain of comparisons: one relation fewer than sides.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// What is compared.
    pub sides: Vec<Expr>,
    /// The signs in between; `=` is [`Relation::Equal`].
    pub relations: Vec<Relation>,
}

/// The formula that a text is, after a symbol and an equals sign that may stand before it.
pub(crate) fn formula(
    text: &str,
    lexicon: &Lexicon,
    manner: Manner,
) -> Result<Typed<Expr>, TypedError> {
    let sides = sides::sides(text, lexicon)?;
    let place = sides.last().map_or(0..text.len(), |side| side.range());
    formula_at(text, place.start, place.end, lexicon, manner)
}

/// The formula that a part of a text is; its places count in the whole text.
pub(crate) fn formula_at(
    text: &str,
    from: usize,
    to: usize,
    lexicon: &Lexicon,
    manner: Manner,
) -> Result<Typed<Expr>, TypedError> {
    read(text, from, to, lexicon, manner, |parser| {
        parser.whole_formula()
    })
}

/// The equation or comparison that a part of a text is; its places count in the whole text.
pub(crate) fn chain(
    text: &str,
    from: usize,
    to: usize,
    lexicon: &Lexicon,
    manner: Manner,
) -> Result<Typed<Chain>, TypedError> {
    let place = text.get(from..to).unwrap_or_default();
    if let Some(two) = both_signs::Two::of(text, from, place) {
        return two.chain(|text| chain(text, from, to, lexicon, manner));
    }
    read(text, from, to, lexicon, manner, |parser| {
        parser.whole_chain()
    })
}

fn read<T: PartialEq>(
    text: &str,
    from: usize,
    to: usize,
    lexicon: &Lexicon,
    manner: Manner,
    parse: impl Fn(&mut Parser<'_>) -> Result<T, TypedError>,
) -> Result<Typed<T>, TypedError> {
    if text.len() > MAX_LENGTH {
        return Err(TypedError::new(Trouble::TooLong, MAX_LENGTH, text.len()));
    }
    let tokens = tokens(text, from, to, lexicon, manner)?;
    readings(|ways| parse(&mut Parser::new(&tokens, to, ways)))
}

#[cfg(test)]
mod tests;
