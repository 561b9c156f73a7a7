//! Formulas as people type them.
//!
//! Files are read strictly, responses leniently: products need no sign and are split by the item's own
//! names (`mgl`, `2zeta omega_n`, `kl²`), Greek letters come as words or signs, subscripts with or
//! without underscore, and the signs of paper (`√`, `²`, `·`, `×`, `−`) stand beside `^`, `**`, `x''`,
//! `xdot`, `d²x/dt²` and simple LaTeX. What was read is echoed; what cannot be read is refused with
//! its place and with what to type instead. Nothing is guessed in silence.
//!
//! # The slash
//!
//! A slash takes what stands right behind it, without a space: `k/2m` is `k/(2m)`, while `k/2 m` is `(k/2) m`.
//! Between two numbers it is a fraction: `1/2mv²` is `½ m v²`. What stands behind a bracket does not
//! belong to the divisor: `1/(2m)c` is `c/(2m)`. A text that can be read in another way has an
//! [`other`](Typed::other) reading, which a kind may take where only that one has the right dimension.

mod behind;
mod differential;
mod error;
mod frame;
mod labels;
mod latex;
mod layout;
mod letters;
mod lexicon;
mod list;
mod parser;
mod token;
mod words;

pub(super) use behind::with_unit;
pub(super) use error::{Trouble, TypedError};
pub(super) use frame::first_bracket;
pub(super) use lexicon::Lexicon;
pub(super) use list::{Listed, cut, list_of_form};

use self::parser::{Parser, Slash};
use self::token::tokens;
use crate::expr::{Expr, Relation};

/// Longest response that is read, in bytes.
const LONGEST: usize = 2_000;
/// Deepest formula that is read; deeper ones would strain the recursion of what follows.
const DEEPEST: u32 = 150;

/// How a text is to be read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Manner {
    /// Whether a comma between two digits is a decimal sign.
    pub(super) comma_is_decimal: bool,
    /// Whether `i` and `j` are the imaginary unit.
    pub(super) has_imaginary_unit: bool,
}

/// What was read.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Typed<T> {
    /// By the rules.
    pub(super) value: T,
    /// Where a slash leaves it open: with the other extent of divisors.
    pub(super) other: Option<T>,
}

/// An equation, or a chain of comparisons: one relation fewer than sides.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Chain {
    /// What is compared.
    pub(super) sides: Vec<Expr>,
    /// The signs in between; `=` is [`Relation::Equal`].
    pub(super) relations: Vec<Relation>,
}

/// The formula that a text is, after a symbol and an equals sign that may stand before it.
pub(super) fn formula(
    text: &str,
    lexicon: &Lexicon,
    manner: Manner,
) -> Result<Typed<Expr>, TypedError> {
    let start = behind_equals(text);
    read(text, start, text.len(), lexicon, manner, |parser| {
        parser.whole_formula()
    })
}

/// Where what stands behind the last equals sign begins; those of `<=` and its like are none.
fn behind_equals(text: &str) -> usize {
    let is_alone = |at: usize| {
        !text[..at].ends_with(['<', '>', '!']) && !text[at + 1..].starts_with(['<', '>'])
    };
    let last = text.char_indices().rev().find(|(at, char)| match char {
        '=' => is_alone(*at),
        char => *char == '≈',
    });
    last.map_or(0, |(at, char)| at + char.len_utf8())
}

/// The equation or comparison that a part of a text is; its places count in the whole text.
pub(super) fn chain(
    text: &str,
    from: usize,
    to: usize,
    lexicon: &Lexicon,
    manner: Manner,
) -> Result<Typed<Chain>, TypedError> {
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
    if text.len() > LONGEST {
        return Err(TypedError::new(Trouble::TooLong, LONGEST, text.len()));
    }
    let tokens = tokens(text, from, to, lexicon, manner)?;
    let mut parser = Parser::new(&tokens, to, Slash::Rule);
    let value = parse(&mut parser)?;
    let other = if parser.is_open() {
        let mut parser = Parser::new(&tokens, to, Slash::Other);
        parse(&mut parser).ok().filter(|other| *other != value)
    } else {
        None
    };
    Ok(Typed { value, other })
}

#[cfg(test)]
mod tests;
