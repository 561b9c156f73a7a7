//! Tokens: the pieces of a response with their places.

use std::sync::Arc;

use super::TypedError;
use super::words::Powered;
use vibank_dynamics::numerics::{Rational, SortedSet};
use vibank_formula::expr::{Expr, Function, Kind, Name};
use vibank_formula::unit::{Decimal, Unit};
use vibank_source::Span;

/// A piece of a response.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Item {
    Number(Rational),
    /// A name, a time derivative of one, or a constant.
    Leaf(Expr),
    Function(Function),
    /// A power that is written as a function.
    Powered(Powered),
    /// A superscript integer, `²`.
    Power(i128),
    /// `c.c.`, the complex conjugates of the terms before it.
    Conjugates,
    /// The mark of a complex conjugate after its letter, `A*`.
    Conjugate,
    /// The line over a conjugate, `\bar`.
    Bar,
    /// Primes after a bracket.
    Primes(u8),
    /// `√`.
    Root,
    /// `\sqrt`.
    Radical,
    /// `\frac`.
    Fraction,
    /// The operator of a time derivative before a bracket, `d/dt (m x')`, and what moves with time.
    Rate(Arc<SortedSet<Name>>),
    /// `°`.
    Degree,
    /// An operator, bracket or other sign.
    Sign(char),
    /// A unit, with its prefix and power.
    Unit(Box<Unit>),
    /// A word that joins values.
    Word(&'static str),
    /// What cannot be read, among values, and why.
    Unread(Box<TypedError>),
}

/// A number as it was typed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Literal {
    pub(crate) value: Decimal,
    /// With the other meaning of its comma.
    pub(crate) other: Option<Decimal>,
}

/// A token with its place.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Token {
    pub(crate) item: Item,
    pub(crate) span: Span,
    /// Whether a space stands before it.
    pub(crate) is_spaced: bool,
    /// The decimal that a number among values is.
    pub(crate) literal: Option<Literal>,
}

/// Whether this is the time.
pub(crate) fn is_time(token: &Token) -> bool {
    let Item::Leaf(leaf) = &token.item else {
        return false;
    };
    matches!(leaf.kind(), Kind::Name(name) if name.as_str() == "t")
}
