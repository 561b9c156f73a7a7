//! Why a formula cannot be read, and where.

use super::Passage;
use crate::signs::is_of_name;
use vibank_source::Span;

/// What stands in the way of reading a formula.
#[derive(Clone, Debug, PartialEq)]
pub enum Trouble {
    /// Nothing is there.
    Missing,
    /// A text beyond the bound.
    TooLong,
    /// Brackets within brackets beyond the bound.
    TooDeep,
    /// A word that is not a name of the item.
    Unknown {
        /// The name that is nearest to it.
        near: Option<String>,
        /// The letters that there are, where they are few.
        letters: Vec<String>,
    },
    /// A name of the item that the answer may not use, and the letters that it may, where they are few.
    NotAllowed(Vec<String>),
    /// A unit in a formula that is asked without units.
    Unit,
    /// A sign that is not understood.
    Sign,
    /// A number that cannot be held exactly.
    Number,
    /// A bracket without its partner.
    Bracket,
    /// Two numbers side by side.
    NumberAfter,
    /// A list where one formula is due.
    List,
    /// A time after an exponent, of which it may be a factor.
    Exponent,
    /// `log`, of which people mean different things.
    Logarithm,
    /// A wrong number of arguments.
    Arguments {
        /// The function.
        name: &'static str,
        /// How many it takes at least.
        least: usize,
        /// How many arguments it takes at most.
        most: usize,
    },
    /// Two values at once.
    TwoValues,
    /// More than a symbol before an equals sign.
    Unsolved,
    /// Something after the end.
    LeftOver,
    /// No relation in an equation or inequality.
    NoRelation,
    /// A unit at an entry of a list.
    UnitOfEntry,
    /// A list without brackets with `m` after.
    UnitOrLetter,
    /// Symbols before the entries that do not ascend.
    Order,
    /// A matrix between bars, which is a number.
    Determinant,
    /// The determinant of matrices that are given by their names.
    NamedMatrices,
    /// What stands in the way of reading a number.
    Value(ValueTrouble),
    /// Rows of different lengths.
    Ragged,
}

/// A place in what was typed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum At {
    /// These signs.
    Here(String),
    /// After these signs.
    Behind(String),
}

/// What stands in the way of reading a number with its unit.
#[derive(Clone, Debug, PartialEq)]
pub enum ValueTrouble {
    /// No number where one is due.
    Missing,
    /// A number or unit that cannot be read.
    Quantity(vibank_formula::unit::Error),
    /// Two signs before a number.
    TwoSigns,
    /// The letter e without an exponent.
    NoExponent,
    /// `19-21`.
    Range,
    /// A number after a unit.
    UnitLast,
    /// A bracket after a number.
    Bracketed,
    /// Units that do not fit together.
    Units,
    /// A unit in the argument of a function that is neither that of an angle nor a rate before the time.
    UnitOfArgument,
    /// A term with a unit and one without.
    UnitOfOne,
    /// An angle in degrees beside a number.
    MixedAngles,
}

/// What stands in the way, and where in the response.
#[derive(Clone, Debug, PartialEq)]
pub struct TypedError {
    /// What is wrong.
    pub trouble: Trouble,
    /// Where in the text.
    pub span: Span,
}

impl TypedError {
    pub(crate) fn new(trouble: Trouble, start: usize, end: usize) -> Self {
        Self {
            trouble,
            span: Span::new(start, end.max(start)),
        }
    }

    /// Where that is in the `text` that was typed.
    pub fn at(&self, passage: Passage<'_>) -> At {
        let text = passage.text();
        // The quote stands in the middle of a sentence.
        const MAX_QUOTE_LENGTH: usize = 40;
        let place = text.get(self.span.range()).unwrap_or_default().trim();
        let short: String = place.chars().take(MAX_QUOTE_LENGTH).collect();
        if short.is_empty() {
            At::Behind(last_signs(text).to_owned())
        } else {
            At::Here(short)
        }
    }
}

/// The end of a text, which begins with a word of it.
fn last_signs(text: &str) -> &str {
    // Enough to be found again in what was typed, as nothing stands at the place itself.
    const ABOUT: usize = 12;
    let text = text.trim();
    let Some((mut start, _)) = text.char_indices().rev().take(ABOUT).last() else {
        return text;
    };
    let is_of_word = |char| is_of_name(char) || char == '\\';
    if text[start..].starts_with(is_of_word) {
        start = text[..start].trim_end_matches(is_of_word).len();
    }
    text[start..].trim()
}
