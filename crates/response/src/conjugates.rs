//! Sums, and `c.c.` in them: the complex conjugates of the terms before it, as twice their real part.

use super::TypedError;
use super::composition::number;
use super::lexer::Lexer;
use super::parser::{Parser, Result};
use super::token::Item;
use super::words::CONJUGATES;
use vibank_formula::expr::{Expr, Function, Kind, Operator};

/// What comes after the letter of a complex conjugate.
const MARKS: [&str; 4] = ["^*", "^{*}", "\u{304}", "\u{305}"];

impl Lexer<'_> {
    /// `+ c.c.`, where numbers are complex; whether it stands here.
    pub(crate) fn conjugate_terms(&mut self) -> bool {
        let is_added = matches!(self.tokens.last(), Some(token) if token.item == Item::Sign('+'));
        if !is_added || self.manner.values.is_some() {
            return false;
        }
        let length = CONJUGATES.iter().find_map(|words| {
            let behind = self.rest().strip_prefix(words)?;
            let goes_on = |next: char| next.is_alphanumeric() || "_.^'(".contains(next);
            (!behind.starts_with(goes_on)).then_some(words.len())
        });
        let length = length.filter(|_| !self.lexicon.knows("cc"));
        let Some(length) = length else {
            return false;
        };
        let start = self.at;
        self.at += length;
        if self.manner.has_imaginary_unit {
            self.push(Item::Conjugates, start);
        } else {
            let trouble = self.lexicon.unknown(&self.text[start..self.at]);
            let error = TypedError::new(trouble, start, self.at);
            self.push(Item::Unread(Box::new(error)), start);
        }
        true
    }
}

impl Lexer<'_> {
    /// `A^*`, and a line over the letter before; whether such a mark stands here, where numbers are complex.
    pub(crate) fn conjugate_mark(&mut self) -> bool {
        let is_complex = self.manner.has_imaginary_unit && self.manner.values.is_none();
        let is_behind = matches!(self.tokens.last(), Some(token) if matches!(token.item, Item::Leaf(_) | Item::Sign(')')));
        if !is_complex || !is_behind {
            return false;
        }
        let mark = MARKS.iter().find(|mark| self.rest().starts_with(**mark));
        if let Some(mark) = mark {
            self.take(mark.len(), Item::Conjugate);
        }
        mark.is_some()
    }

    /// Has `A* e^(-it)` the conjugate of a letter that stands before it as `A e^(it)`: of the sign of a product both
    /// sides or none have a space.
    pub(crate) fn stars(&mut self) {
        if !self.manner.has_imaginary_unit || self.manner.values.is_some() {
            return;
        }
        let mut bare: Vec<Expr> = Vec::new();
        for at in 0..self.tokens.len() {
            let leaf = match &self.tokens[at].item {
                Item::Leaf(leaf) if matches!(leaf.kind(), Kind::Name(_)) => leaf,
                _ => continue,
            };
            let is_star = self
                .tokens
                .get(at + 1)
                .is_some_and(|token| token.item == Item::Sign('*') && !token.is_spaced);
            let stands_apart = match self.tokens.get(at + 2) {
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
                self.tokens[at + 1].item = Item::Conjugate;
            }
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
