//! Sums, and `c.c.` in them: the complex conjugates of the terms before it, as twice their real part.

use super::composition::number;
use super::parser::{Parser, Result};
use super::token::{Item, Token};
use super::words::CONJUGATES;
use super::{Lexicon, TypedError};
use vibank_formula::expr::{Expr, Function, Kind, Operator};

/// What comes after the letter of a complex conjugate.
const MARKS: [&str; 4] = ["^*", "^{*}", "\u{304}", "\u{305}"];

/// `+ c.c.`, which is read where numbers are complex, if it stands at a place after these tokens, and its length.
pub(crate) fn conjugate_terms(
    (text, at): (&str, usize),
    tokens: &[Token],
    lexicon: &Lexicon,
    is_complex: bool,
) -> Option<(Item, usize)> {
    tokens
        .last()
        .filter(|token| token.item == Item::Sign('+'))?;
    let length = CONJUGATES.iter().find_map(|words| {
        let behind = text[at..].strip_prefix(words)?;
        let goes_on = |next: char| next.is_alphanumeric() || "_.^'(".contains(next);
        (!behind.starts_with(goes_on)).then_some(words.len())
    });
    let length = length.filter(|_| !lexicon.knows("cc"))?;
    if is_complex {
        return Some((Item::Conjugates, length));
    }
    let trouble = lexicon.unknown(&text[at..at + length]);
    let error = TypedError::new(trouble, at, at + length);
    Some((Item::Unread(Box::new(error)), length))
}

/// The length of the mark of a conjugate, `A^*`, or a line over the letter before, that begins a text after these tokens.
pub(crate) fn conjugate_mark(text: &str, tokens: &[Token]) -> Option<usize> {
    let is_marked = |token: &&Token| matches!(token.item, Item::Leaf(_) | Item::Sign(')'));
    tokens.last().filter(is_marked)?;
    let mark = MARKS.iter().find(|mark| text.starts_with(**mark))?;
    Some(mark.len())
}

/// Has `A* e^(-it)` the conjugate of a letter that stands before it as `A e^(it)`: of the sign of a product both sides or
/// none have a space.
pub(crate) fn conjugate_stars(tokens: &mut [Token]) {
    let mut bare: Vec<Expr> = Vec::new();
    for at in 0..tokens.len() {
        let leaf = match &tokens[at].item {
            Item::Leaf(leaf) if matches!(leaf.kind(), Kind::Name(_)) => leaf,
            _ => continue,
        };
        let is_star = tokens
            .get(at + 1)
            .is_some_and(|token| token.item == Item::Sign('*') && !token.is_spaced);
        let stands_apart = match tokens.get(at + 2) {
            Some(token) => match token.item {
                Item::Number(_) => false,
                Item::Sign('*' | '+' | ')') => true,
                _ => token.is_spaced,
            },
            None => true,
        };
        if !(is_star && stands_apart) {
            bare.push(leaf.clone());
        } else if bare.contains(leaf) {
            tokens[at + 1].item = Item::Conjugate;
        }
    }
}

impl Parser<'_> {
    pub(crate) fn sum(&mut self) -> Result<Expr> {
        // What stands before `c.c.` is real with it, and the next such is of what comes after that.
        let mut real: Option<Expr> = None;
        let mut sum = self.term()?;
        loop {
            if self.take_conjugates() {
                sum = Self::real(sum)?;
                sum = match real.take() {
                    Some(before) => Self::binary(Operator::Add, before, sum)?,
                    None => sum,
                };
                if !(self.is_sign('+') || self.is_sign('-')) {
                    return Ok(sum);
                }
                real = Some(sum);
                sum = self.term()?;
                continue;
            }
            let operator = match (self.item(), real.as_ref()) {
                (Some(Item::Sign('+')), _) => Operator::Add,
                (Some(Item::Sign('-')), _) => Operator::Subtract,
                (_, Some(before)) => return Self::binary(Operator::Add, before.clone(), sum),
                (_, None) => return Ok(sum),
            };
            self.at += 1;
            let term = self.term()?;
            sum = Self::binary(operator, sum, term)?;
        }
    }

    /// Whether `+ c.c.` stood here.
    fn take_conjugates(&mut self) -> bool {
        let behind = self.tokens.get(self.at + 1).map(|token| &token.item);
        let is_it = self.is_sign('+') && behind == Some(&Item::Conjugates);
        self.at += if is_it { 2 } else { 0 };
        is_it
    }

    /// A sum of complex numbers with their conjugates.
    fn real(sum: Expr) -> Result<Expr> {
        let span = sum.span();
        let part = Expr::new(Kind::Call(Function::Re, vec![sum]), span);
        Self::binary(Operator::Multiply, Expr::new(number(2), span), part)
    }
}
