//! The grammar, by binding strength.
//!
//! One word decides each step, so the time is linear in the text.

use super::ReadError;
use super::slip::unexpected;
use super::token::{Token, TokenKind, tokens};
use super::{call, slip};
use crate::expr::{Constant, Expr, Function, Kind, Name, Operator, Path, Relation};
use crate::unit::Unit;
use vibank_dynamics::numerics::Rational;
use vibank_source::Span;

/// Most bytes of a text.
const MAX_BYTES: usize = 100_000;
/// Most nodes of a formula.
const MAX_NODES: u32 = 10_000;
/// Largest depth of a formula, and most brackets inside one another.
const MAX_DEPTH: u32 = 200;
/// Most calls of [`Parser::expression`] inside one another; a level of the tree takes at most two.
const MAX_CALLS: u32 = 2 * MAX_DEPTH;
/// Highest order of a time derivative.
pub(crate) const MAX_PRIMES: u8 = 8;

/// Words that are neither names nor functions.
pub(crate) const WORDS: &[&str] = &[
    "if", "then", "else", "and", "or", "not", "at", "diff", "root", "integral", "pi", "e", "i",
    "inf", "model", "models",
];

/// Binding strength: what stands further down binds more tightly.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Strength {
    Condition,
    Conjunction,
    Negation,
    Comparison,
    Sum,
    Term,
    Sign,
    Power,
}

/// What stands between two operands.
#[derive(Clone, Copy)]
enum Infix {
    Or,
    And,
    Compare(Relation),
    Arithmetic(Operator),
}

/// A place in the words of a text.
pub(crate) struct Parser<'a> {
    pub(crate) tokens: Vec<Token<'a>>,
    pub(crate) at: usize,
    nodes: u32,
    calls: u32,
}

impl<'a> Parser<'a> {
    pub(crate) fn new(text: &'a str) -> Result<Self, ReadError> {
        if text.len() > MAX_BYTES {
            return Err(ReadError::TooLong {
                bytes: text.len(),
                most: MAX_BYTES,
            });
        }
        Ok(Self {
            tokens: tokens(text)?,
            at: 0,
            nodes: 0,
            calls: 0,
        })
    }

    /// `if … then … else …`, or a condition.
    pub(crate) fn formula(&mut self) -> Result<Expr, ReadError> {
        if !self.next_is("if") {
            return self.expression(Strength::Condition);
        }
        self.enter()?;
        let start = self.advance().span;
        let condition = self.expression(Strength::Condition)?;
        self.expect("then", "`then` and the value")?;
        let first = self.formula()?;
        self.expect("else", "`else` and the value otherwise")?;
        let second = self.formula()?;
        self.calls -= 1;
        self.node(Kind::If(condition, first, second), start)
    }

    /// Operands joined by operators that bind at least as tightly as `least`.
    pub(crate) fn expression(&mut self, least: Strength) -> Result<Expr, ReadError> {
        self.enter()?;
        let start = self.peek().span;
        let mut left = self.prefix(least)?;
        while let Some((strength, infix)) = infix(self.peek()) {
            if strength < least {
                break;
            }
            left = self.joined(left, strength, infix, start)?;
        }
        self.calls -= 1;
        Ok(left)
    }

    /// `left`, the operator at hand, and its right operand.
    fn joined(
        &mut self,
        left: Expr,
        strength: Strength,
        infix: Infix,
        start: Span,
    ) -> Result<Expr, ReadError> {
        let kind = match infix {
            Infix::Compare(_) => return self.comparison(left, start),
            Infix::Or => {
                self.advance();
                Kind::Or(left, self.expression(Strength::Conjunction)?)
            }
            Infix::And => {
                self.advance();
                Kind::And(left, self.expression(Strength::Negation)?)
            }
            Infix::Arithmetic(operator) => {
                self.advance();
                let tighter = match strength {
                    Strength::Sum => Strength::Term,
                    // The exponent may bear a sign and a power of its own: `2^-1`, `2^3^2`.
                    _ => Strength::Sign,
                };
                Kind::Binary(operator, left, self.expression(tighter)?)
            }
        };
        self.node(kind, start)
    }

    /// A chain of comparisons that begins with `first`.
    fn comparison(&mut self, first: Expr, start: Span) -> Result<Expr, ReadError> {
        let (mut operands, mut relations) = (vec![first], Vec::new());
        while let Some((_, Infix::Compare(relation))) = infix(self.peek()) {
            self.advance();
            relations.push(relation);
            operands.push(self.expression(Strength::Sum)?);
        }
        self.node(Kind::Compare(operands, relations), start)
    }

    /// A sign or `not` with its operand, or an operand.
    fn prefix(&mut self, least: Strength) -> Result<Expr, ReadError> {
        let token = *self.peek();
        if token.is("not") && least <= Strength::Negation {
            self.advance();
            let operand = self.expression(Strength::Negation)?;
            return self.node(Kind::Not(operand), token.span);
        }
        if token.is("-") {
            self.advance();
            let operand = self.expression(Strength::Sign)?;
            return self.node(Kind::Negate(operand), token.span);
        }
        if token.is("+") {
            self.advance();
            return self.expression(Strength::Sign);
        }
        self.postfix()
    }

    /// An operand with its primes and indices.
    fn postfix(&mut self) -> Result<Expr, ReadError> {
        let start = self.peek().span;
        let mut operand = self.primary()?;
        loop {
            if self.next_is("'") {
                let order = self.primes()?;
                // The derivative of a derivative, `(x')'`, is one of a higher order.
                let (inner, order) = match operand.kind() {
                    Kind::Prime(inner, own) if own + order <= MAX_PRIMES => {
                        (inner.clone(), own + order)
                    }
                    _ => (operand, order),
                };
                operand = self.node(Kind::Prime(inner, order), start)?;
            } else if self.next_is("[") && !matches!(operand.kind(), Kind::Number(_)) {
                self.advance();
                let indices = self.formulas_to("]", "`,` or `]` after an index")?;
                operand = self.node(Kind::Index(operand, indices), start)?;
            } else {
                return Ok(operand);
            }
        }
    }

    fn primes(&mut self) -> Result<u8, ReadError> {
        let start = self.peek().span;
        let mut order = 0;
        while self.next_is("'") {
            self.advance();
            order += 1;
            if order > MAX_PRIMES {
                return Err(ReadError::TooManyPrimes {
                    most: MAX_PRIMES,
                    span: self.since(start),
                });
            }
        }
        Ok(order)
    }

    fn primary(&mut self) -> Result<Expr, ReadError> {
        let token = *self.peek();
        match token.kind {
            TokenKind::Number => self.number(),
            TokenKind::Word => self.word(),
            TokenKind::Sign if token.text == "(" => {
                self.advance();
                let inner = self.formula()?;
                self.expect(")", "an operator or `)`")?;
                Ok(inner)
            }
            TokenKind::Sign if token.text == "[" => {
                self.advance();
                let entries = self.formulas_to("]", "an operator, `,` or `]`")?;
                self.node(Kind::Array(entries), token.span)
            }
            TokenKind::Sign if token.text == "." => Err(ReadError::BarePoint { span: token.span }),
            _ => Err(unexpected(&token, "a number, a name or `(`")),
        }
    }

    /// A number, with its unit if there is one.
    fn number(&mut self) -> Result<Expr, ReadError> {
        let token = self.advance();
        let number = Rational::from_decimal(token.text).ok_or_else(|| ReadError::NumberRange {
            text: token.text.to_owned(),
            span: token.span,
        })?;
        if self.peek().kind != TokenKind::Unit {
            return self.node(Kind::Number(number), token.span);
        }
        let written = self.advance();
        let unit = Unit::parse(written.text).map_err(|reason| ReadError::Unit {
            reason,
            span: written.span,
        })?;
        self.node(Kind::Measure(number, Box::new(unit)), token.span)
    }

    /// A constant, a path, a call or a name.
    fn word(&mut self) -> Result<Expr, ReadError> {
        let token = self.advance();
        let kind = match token.text {
            "pi" => Kind::Constant(Constant::Pi),
            "e" => Kind::Constant(Constant::E),
            "i" => Kind::Constant(Constant::ImaginaryUnit),
            "inf" => Kind::Constant(Constant::Infinity),
            "model" | "models" => self.path(&token)?,
            "if" => {
                return Err(unexpected(
                    &token,
                    "an operand (a case inside a formula needs parentheses)",
                ));
            }
            "not" => {
                return Err(unexpected(
                    &token,
                    "an operand (`not` needs parentheses here)",
                ));
            }
            "then" | "else" | "and" | "or" => {
                return Err(unexpected(&token, "a number, a name or `(`"));
            }
            _ if self.next_is("(") => call::call(self, &token)?,
            name if Function::of_name(name).is_some() || WORDS.contains(&name) => {
                return Err(ReadError::Reserved {
                    name: name.to_owned(),
                    span: token.span,
                });
            }
            name => Kind::Name(Name::from(name)),
        };
        self.node(kind, token.span)
    }

    /// What follows `model` or `models`.
    fn path(&mut self, first: &Token<'_>) -> Result<Kind, ReadError> {
        let mut names = vec![Name::from(first.text)];
        let least = if first.text == "model" { 2 } else { 3 };
        while self.next_is(".") || names.len() < least {
            self.expect(".", "`.` and a name")?;
            let token = *self.peek();
            if token.kind != TokenKind::Word {
                return Err(unexpected(&token, "a name"));
            }
            self.advance();
            names.push(Name::from(token.text));
        }
        Ok(Kind::Path(Path::new(names)))
    }

    /// One or more formulas up to a closing bracket.
    fn formulas_to(
        &mut self,
        close: &'static str,
        expected: &'static str,
    ) -> Result<Vec<Expr>, ReadError> {
        let mut formulas = vec![self.formula()?];
        while self.next_is(",") {
            self.advance();
            formulas.push(self.formula()?);
        }
        self.expect(close, expected)?;
        Ok(formulas)
    }

    /// One of two brackets; whether it is the second.
    pub(crate) fn bracket(
        &mut self,
        closed: &str,
        open: &str,
        expected: &'static str,
    ) -> Result<bool, ReadError> {
        let token = *self.peek();
        if !token.is(closed) && !token.is(open) {
            return Err(slip::surprise(self, expected));
        }
        self.advance();
        Ok(token.is(open))
    }

    /// A node from `start` to the last word read.
    fn node(&mut self, kind: Kind, start: Span) -> Result<Expr, ReadError> {
        let span = self.since(start);
        self.nodes += 1;
        if self.nodes > MAX_NODES {
            return Err(ReadError::TooLarge {
                most: MAX_NODES,
                span,
            });
        }
        let expr = Expr::new(kind, span);
        if expr.depth() > MAX_DEPTH {
            return Err(ReadError::TooDeep {
                most: MAX_DEPTH,
                span,
            });
        }
        Ok(expr)
    }

    /// Notes one more level of calls; the caller takes it back.
    fn enter(&mut self) -> Result<(), ReadError> {
        self.calls += 1;
        if self.calls > MAX_CALLS {
            return Err(ReadError::TooDeep {
                most: MAX_DEPTH,
                span: self.peek().span,
            });
        }
        Ok(())
    }

    pub(crate) fn peek(&self) -> &Token<'a> {
        &self.tokens[self.at]
    }

    pub(crate) fn next_is(&self, text: &str) -> bool {
        self.peek().is(text)
    }

    /// Takes the word at hand; the end is never passed.
    pub(crate) fn advance(&mut self) -> Token<'a> {
        let token = *self.peek();
        if token.kind != TokenKind::End {
            self.at += 1;
        }
        token
    }

    /// From `start` to the last word read.
    pub(crate) fn since(&self, start: Span) -> Span {
        let last = self.tokens[self.at.saturating_sub(1)].span;
        if last.end <= start.start {
            start
        } else {
            start.join(last)
        }
    }

    pub(crate) fn expect(&mut self, text: &str, expected: &'static str) -> Result<(), ReadError> {
        if !self.next_is(text) {
            return Err(slip::surprise(self, expected));
        }
        self.advance();
        Ok(())
    }

    pub(crate) fn end(&self) -> Result<(), ReadError> {
        match self.peek().kind {
            TokenKind::End => Ok(()),
            _ => Err(slip::surprise(self, "an operator or the end")),
        }
    }
}

/// The operator that a word is, and how tightly it binds.
fn infix(token: &Token<'_>) -> Option<(Strength, Infix)> {
    if !matches!(token.kind, TokenKind::Sign | TokenKind::Word) {
        return None;
    }
    let compare = |relation| (Strength::Comparison, Infix::Compare(relation));
    let arithmetic = |strength, operator| (strength, Infix::Arithmetic(operator));
    Some(match token.text {
        "or" => (Strength::Condition, Infix::Or),
        "and" => (Strength::Conjunction, Infix::And),
        "<" => compare(Relation::Less),
        "<=" => compare(Relation::LessOrEqual),
        ">" => compare(Relation::Greater),
        ">=" => compare(Relation::GreaterOrEqual),
        "==" => compare(Relation::Equal),
        "!=" => compare(Relation::NotEqual),
        "+" => arithmetic(Strength::Sum, Operator::Add),
        "-" => arithmetic(Strength::Sum, Operator::Subtract),
        "*" => arithmetic(Strength::Term, Operator::Multiply),
        "/" => arithmetic(Strength::Term, Operator::Divide),
        "^" => arithmetic(Strength::Power, Operator::Power),
        _ => return None,
    })
}
