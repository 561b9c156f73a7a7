//! From tokens to formulas.

use super::around_token::{
    begins_fraction, is_after_constant, is_bare_behind_unit, is_doubtful_bracket, length_of_call,
};
use super::composition::{has_unit, is_constant, is_number, number, uses_time};
use super::token::{Item, Token, is_time};
use super::ways::{Doubtful, Ways};
use super::{Chain, MAX_DEPTH, Trouble, TypedError, ValueTrouble};
use vibank_dynamics::numerics::Rational;
use vibank_formula::expr::{Constant, Expr, Function, Kind, Operator, Relation, time_derivative};
use vibank_formula::unit::Unit;
use vibank_source::Span;

/// A parser of one reading.
pub(crate) struct Parser<'a> {
    pub(crate) tokens: &'a [Token],
    pub(crate) at: usize,
    end: usize,
    pub(crate) ways: &'a mut Ways,
    depth: u32,
    /// Open bars of absolute values within the innermost bracket.
    pub(crate) bars: u32,
    units: Units,
}

/// What units may stand after.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Units {
    Nothing,
    /// Numbers, each of which may be a value of its own.
    Values,
    /// The numbers of one formula.
    Terms,
}

pub(crate) type Result<T> = std::result::Result<T, TypedError>;

/// Brackets, functions and exponents within one another.
const MAX_NESTED: u32 = 60;

impl<'a> Parser<'a> {
    pub(crate) fn new(tokens: &'a [Token], end: usize, ways: &'a mut Ways) -> Self {
        Self {
            tokens,
            at: 0,
            end,
            ways,
            depth: 0,
            bars: 0,
            units: Units::Nothing,
        }
    }

    /// A parser of numbers with units.
    pub(crate) fn of_values(tokens: &'a [Token], end: usize, ways: &'a mut Ways) -> Self {
        Self {
            units: Units::Values,
            ..Self::new(tokens, end, ways)
        }
    }

    /// A parser of a formula with units in it.
    pub(crate) fn of_terms(tokens: &'a [Token], end: usize, ways: &'a mut Ways) -> Self {
        Self {
            units: Units::Terms,
            ..Self::new(tokens, end, ways)
        }
    }

    fn has_units(&self) -> bool {
        self.units != Units::Nothing
    }

    /// Whether the sign here stands right behind a word and before a space, as a colon of prose does.
    fn is_lead(&self) -> bool {
        let is_spaced = |at: usize| self.tokens.get(at).is_some_and(|token| token.is_spaced);
        !is_spaced(self.at) && is_spaced(self.at + 1)
    }

    pub(crate) fn whole_formula(&mut self) -> Result<Expr> {
        let formula = self.sum()?;
        self.finish()?;
        Ok(formula)
    }

    pub(crate) fn whole_chain(&mut self) -> Result<Chain> {
        let mut sides = vec![self.sum()?];
        let mut relations = Vec::new();
        while let Some(Item::Sign(sign)) = self.item() {
            relations.push(match sign {
                '=' => Relation::Equal,
                '≠' => Relation::NotEqual,
                '<' => Relation::Less,
                '>' => Relation::Greater,
                '≤' => Relation::LessOrEqual,
                '≥' => Relation::GreaterOrEqual,
                _ => break,
            });
            self.at += 1;
            sides.push(self.sum()?);
        }
        self.finish()?;
        if relations.is_empty() {
            return Err(TypedError::new(Trouble::NoRelation, self.end, self.end));
        }
        Ok(Chain { sides, relations })
    }

    fn finish(&self) -> Result<()> {
        match self.tokens.get(self.at) {
            None => Ok(()),
            Some(Token {
                item: Item::Unread(error),
                ..
            }) => Err((**error).clone()),
            Some(token) => Err(TypedError {
                trouble: match token.item {
                    Item::Sign(',' | ';' | '&') => Trouble::List,
                    Item::Sign(')' | ']' | '}' | '|') => Trouble::Bracket,
                    _ => Trouble::LeftOver,
                },
                span: token.span,
            }),
        }
    }

    pub(crate) fn item(&self) -> Option<&'a Item> {
        self.tokens.get(self.at).map(|token| &token.item)
    }

    pub(crate) fn is_sign(&self, sign: char) -> bool {
        self.item() == Some(&Item::Sign(sign))
    }

    pub(crate) fn take(&mut self, sign: char) -> bool {
        let found = self.is_sign(sign);
        self.at += usize::from(found);
        found
    }

    pub(crate) fn here(&self) -> Span {
        self.tokens
            .get(self.at)
            .map_or(Span::new(self.end, self.end), |token| token.span)
    }

    pub(crate) fn error<T>(&self, trouble: Trouble) -> Result<T> {
        Err(TypedError {
            trouble,
            span: self.here(),
        })
    }

    fn deeper<T>(&mut self, inner: impl FnOnce(&mut Self) -> Result<T>) -> Result<T> {
        if self.depth >= MAX_NESTED {
            return self.error(Trouble::TooDeep);
        }
        self.depth += 1;
        let result = inner(self);
        self.depth -= 1;
        result
    }

    pub(crate) fn term(&mut self) -> Result<Expr> {
        let mut left = self.signed()?;
        loop {
            match self.item() {
                Some(Item::Sign('*')) => {
                    self.at += 1;
                    if self.units == Units::Values && is_bare_behind_unit(self.tokens, self.at) {
                        return self.error(Trouble::Value(ValueTrouble::UnitLast));
                    }
                    let right = self.signed()?;
                    left = Self::binary(Operator::Multiply, left, right)?;
                }
                // `M:l` and `M : l`; `F = m g: m g/k` says what follows.
                Some(Item::Sign(sign))
                    if *sign == '/' || *sign == ':' && !self.has_units() && !self.is_lead() =>
                {
                    self.at += 1;
                    let divisor = self.divisor(&left)?;
                    left = Self::binary(Operator::Divide, left, divisor)?;
                }
                Some(Item::Sign('∠')) if !self.has_units() => {
                    let span = self.here();
                    self.at += 1;
                    let angle = self.term()?;
                    left = Self::polar(left, angle, span)?;
                }
                // `√(50:2)`; of values a colon outside of brackets comes after a name, or in a time of day.
                Some(Item::Sign(':')) if self.depth > 0 => {
                    self.at += 1;
                    let right = self.signed()?;
                    left = Self::binary(Operator::Divide, left, right)?;
                }
                // `x 2` is asked back: numbers stand before what they multiply, so that a sign or an exponent
                // may be lost here.
                Some(Item::Number(_)) if !self.is_after_constant() => {
                    return self.error(Trouble::NumberAfter);
                }
                Some(Item::Number(_)) => {
                    let right = self.power()?;
                    left = Self::binary(Operator::Multiply, left, right)?;
                }
                _ if self.begins_factor() => {
                    if self.units == Units::Values && is_doubtful_bracket(self.tokens, self.at) {
                        return self.error(Trouble::Value(ValueTrouble::Bracketed));
                    }
                    let right = self.power()?;
                    left = Self::binary(Operator::Multiply, left, right)?;
                }
                _ => return Ok(left),
            }
        }
    }

    /// The complex number of a modulus and an angle.
    pub(crate) fn polar(modulus: Expr, angle: Expr, span: Span) -> Result<Expr> {
        let unit = Expr::new(Kind::Constant(Constant::ImaginaryUnit), span);
        let base = Expr::new(Kind::Constant(Constant::E), span);
        let angle = Self::binary(Operator::Multiply, unit, angle)?;
        let turned = Self::binary(Operator::Power, base, angle)?;
        Self::binary(Operator::Multiply, modulus, turned)
    }

    /// Whether a number may stand here without a sign, as in `j100` and `2 π 0.8`.
    fn is_after_constant(&self) -> bool {
        self.is_after_imaginary_unit()
            || self.has_units()
                && is_after_constant(self.tokens, self.at, Constant::Pi)
                && !self.is_tight()
    }

    fn is_after_imaginary_unit(&self) -> bool {
        is_after_constant(self.tokens, self.at, Constant::ImaginaryUnit)
    }

    /// A factor with signs in front.
    pub(crate) fn signed(&mut self) -> Result<Expr> {
        let span = self.here();
        if self.take('-') {
            // −a b is −(a b) all the same.
            let inner = self.deeper(Self::signed)?;
            return Ok(Expr::new(Kind::Negate(inner), span));
        }
        if self.take('+') {
            return self.deeper(Self::signed);
        }
        self.power()
    }

    /// What a slash divides by.
    pub(crate) fn divisor(&mut self, numerator: &Expr) -> Result<Expr> {
        let is_closed = matches!(
            self.item(),
            Some(
                Item::Sign('(' | '[' | '{' | '|')
                    | Item::Fraction
                    | Item::Radical
                    | Item::Function(_)
                    | Item::Powered(_)
            )
        );
        let mut divisor = self.signed()?;
        let mut has_spaced = false;
        let is_bare = self.has_units() && !has_unit(numerator);
        while !is_closed && self.begins_factor() {
            if let Some(Item::Unit(_)) = self.item() {
                // In `1/2 m` and `100/i ohm` the unit is that of the fraction, in `5 m/2 s` each number has its own.
                // Of `1/0.2s` and `1/5 Hz` that is not so clear.
                let is_measure =
                    matches!(self.item(), Some(Item::Unit(unit)) if !unit.dimension().is_pure());
                let is_real = !self.is_after_imaginary_unit();
                let may_be_own = self.is_tight() || is_measure && is_real;
                if is_bare
                    && is_constant(&divisor)
                    && !(may_be_own && self.ways.choose(Doubtful::Unit, false))
                {
                    break;
                }
                let unit = self.power()?;
                divisor = Self::binary(Operator::Multiply, divisor, unit)?;
                break;
            }
            let is_tight = self.is_tight();
            let is_fraction = is_number(numerator) && is_number(&divisor);
            // `1/2 m` can be read in one way only; of `k mm` all belongs to the divisor or nothing.
            let is_end = is_fraction && !is_tight;
            let goes_on = has_spaced && is_tight;
            if is_end
                || !goes_on
                    && !self
                        .ways
                        .choose(Doubtful::Divisor, is_tight && !is_fraction)
            {
                break;
            }
            has_spaced |= !is_tight;
            let factor = self.power()?;
            divisor = Self::binary(Operator::Multiply, divisor, factor)?;
        }
        Ok(divisor)
    }

    /// Whether no space stands before what is here.
    pub(crate) fn is_tight(&self) -> bool {
        self.tokens
            .get(self.at)
            .is_some_and(|token| !token.is_spaced)
    }

    /// Whether a factor can begin here without a sign before it.
    pub(crate) fn begins_factor(&self) -> bool {
        match self.item() {
            Some(Item::Sign(sign)) => {
                matches!(sign, '(' | '[' | '{') || *sign == '|' && self.bars == 0
            }
            Some(
                Item::Leaf(_)
                | Item::Function(_)
                | Item::Powered(_)
                | Item::Root
                | Item::Radical
                | Item::Fraction
                | Item::Bar
                | Item::Rate(_)
                | Item::Unit(_),
            ) => true,
            _ => false,
        }
    }

    pub(crate) fn power(&mut self) -> Result<Expr> {
        let base = self.primary()?;
        self.raised(base)
    }

    /// A base with the exponents after it.
    fn raised(&mut self, base: Expr) -> Result<Expr> {
        let mut base = base;
        loop {
            match self.item() {
                Some(Item::Power(power)) => {
                    let exponent = Expr::new(number(*power), self.here());
                    self.at += 1;
                    base = Self::binary(Operator::Power, base, exponent)?;
                }
                Some(Item::Primes(order)) => {
                    let span = base.span().join(self.here());
                    self.at += 1;
                    base = Expr::new(Kind::Prime(base, *order), span);
                }
                Some(Item::Conjugate) => {
                    let span = base.span().join(self.here());
                    self.at += 1;
                    base = Expr::new(Kind::Call(Function::Conj, vec![base]), span);
                }
                Some(Item::Sign('^')) => {
                    self.at += 1;
                    let exponent = self.deeper(|parser| parser.exponent(&base))?;
                    return Self::binary(Operator::Power, base, exponent);
                }
                _ => return Ok(base),
            }
        }
    }

    pub(crate) fn exponent(&mut self, base: &Expr) -> Result<Expr> {
        let is_closed = matches!(self.item(), Some(Item::Sign('(' | '{' | '[')));
        let span = self.here();
        // `10^+3`, as calculators have it.
        let is_number = |token: Option<&Token>| matches!(token, Some(token) if matches!(token.item, Item::Number(_)) && !token.is_spaced);
        if self.is_sign('+') && is_number(self.tokens.get(self.at + 1)) {
            self.at += 1;
        }
        if self.take('-') {
            let inner = self.deeper(|parser| parser.exponent(base))?;
            return Ok(Expr::new(Kind::Negate(inner), span));
        }
        let mut exponent = self.power()?;
        // `e^iωt` has all of it in the exponent.
        let is_exponential = *base.kind() == Kind::Constant(Constant::E) && !is_closed;
        while is_exponential && self.goes_on_in_exponent(&exponent) {
            let factor = self.power()?;
            exponent = Self::binary(Operator::Multiply, exponent, factor)?;
        }
        // `e^-ct/2m`, where only so it makes sense.
        if is_exponential
            && uses_time(&exponent)
            && self.is_sign('/')
            && self.is_tight()
            && self.ways.choose(Doubtful::Exponent, false)
        {
            self.at += 1;
            let divisor = self.divisor(&exponent)?;
            exponent = Self::binary(Operator::Divide, exponent, divisor)?;
        }
        let next = self.at + usize::from(self.is_sign('*'));
        let is_open = is_exponential && !uses_time(&exponent);
        if is_open && self.tokens.get(next).is_some_and(is_time) {
            // `e^-λ t` and `e^-λ·t`: by the rule the time is no part of it, as most people mean it is.
            return self.error(Trouble::Exponent);
        }
        if !is_closed && begins_fraction(self.tokens, self.at, &exponent) {
            // `a^1/2` is the root: nobody writes a power of 1. `a^3/2` is a³/2.
            let is_root = exponent.as_number() == Some(Rational::ONE);
            if self.ways.choose(Doubtful::Exponent, is_root) {
                self.at += 1;
                let below = self.primary()?;
                exponent = Self::binary(Operator::Divide, exponent, below)?;
            }
        }
        Ok(exponent)
    }

    /// Whether the exponent of e goes on, as in `e^iωt`, `e^i2t`.
    fn goes_on_in_exponent(&mut self, exponent: &Expr) -> bool {
        let is_number = matches!(self.item(), Some(Item::Number(_)));
        if !(self.begins_factor() || is_number && self.is_after_imaginary_unit()) {
            return false;
        }
        // `e^-5t(2 + t)`, `e^-5tcos 3t`: an exponent that has the time in it is whole, since nobody means one that
        // oscillates.
        if matches!(self.item(), Some(Item::Sign(_) | Item::Function(_))) {
            return self.is_tight() && self.ways.choose(Doubtful::Exponent, !uses_time(exponent));
        }
        // `e^-λ t`.
        self.is_tight()
            || matches!(self.item(), Some(Item::Leaf(_)))
                && self.ways.choose(Doubtful::Exponent, false)
    }

    pub(crate) fn primary(&mut self) -> Result<Expr> {
        let Some(item) = self.item() else {
            return self.error(Trouble::Missing);
        };
        let span = self.here();
        self.at += 1;
        match item {
            Item::Number(value) => {
                if self.item() == Some(&Item::Degree) {
                    let span = span.join(self.here());
                    self.at += 1;
                    let degree = Unit::degree();
                    return Ok(Expr::new(Kind::Measure(*value, Box::new(degree)), span));
                }
                Ok(Expr::new(Kind::Number(*value), span))
            }
            Item::Unit(unit) => Ok(Expr::new(Kind::Measure(Rational::ONE, unit.clone()), span)),
            Item::Unread(error) => Err((**error).clone()),
            Item::Leaf(leaf) => {
                self.at += length_of_call(self.tokens, self.at, leaf);
                Ok(Expr::new(leaf.kind().clone(), span))
            }
            Item::Function(function) => self.deeper(|parser| parser.function(*function, span)),
            Item::Powered(powered) => self.deeper(|parser| parser.powered(*powered, span)),
            Item::Root => self.deeper(|parser| parser.root(span)),
            Item::Radical => self.deeper(|parser| parser.radical(span)),
            Item::Bar => self.deeper(|parser| {
                let inner = parser.argument_of_command()?;
                Ok(Expr::new(Kind::Call(Function::Conj, vec![inner]), span))
            }),
            Item::Fraction => self.deeper(|parser| {
                let above = parser.argument_of_command()?;
                let below = parser.argument_of_command()?;
                Self::binary(Operator::Divide, above, below)
            }),
            Item::Rate(moving) => self.deeper(|parser| {
                let inner = parser.primary()?;
                time_derivative(&inner, moving).map_err(|_| TypedError {
                    trouble: Trouble::Sign,
                    span,
                })
            }),
            Item::Sign('|') => self.deeper(|parser| {
                let outside = parser.bars;
                parser.bars += 1;
                let inner = parser.sum();
                // A bracket that is left open inside leaves its own count behind.
                parser.bars = outside;
                let inner = inner?;
                if !parser.take('|') {
                    return Err(TypedError {
                        trouble: Trouble::Bracket,
                        span,
                    });
                }
                Ok(Expr::new(Kind::Call(Function::Abs, vec![inner]), span))
            }),
            Item::Sign(open @ ('(' | '[' | '{')) => {
                self.deeper(|parser| parser.bracket(*open, span))
            }
            _ => {
                self.at -= 1;
                let trouble = match item {
                    Item::Sign(')' | ']' | '}') => Trouble::Missing,
                    _ => Trouble::Sign,
                };
                self.error(trouble)
            }
        }
    }

    /// What stands in a bracket that is open.
    pub(crate) fn bracket(&mut self, open: char, span: Span) -> Result<Expr> {
        // Within a bracket a bar opens a modulus again: `|a (|b|)|`.
        let bars = std::mem::take(&mut self.bars);
        let inner = self.sum();
        self.bars = bars;
        let inner = inner?;
        if self.is_sign(',') || self.is_sign(';') || self.is_sign('&') {
            return self.error(Trouble::List);
        }
        let close = match open {
            '(' => ')',
            '[' => ']',
            _ => '}',
        };
        self.close(close, span)?;
        Ok(inner)
    }

    /// The bracket that closes the one at a place.
    pub(crate) fn close(&mut self, close: char, open: Span) -> Result<()> {
        if self.take(close) {
            return Ok(());
        }
        match self.item() {
            None | Some(Item::Sign(')' | ']' | '}')) => Err(TypedError {
                trouble: Trouble::Bracket,
                span: open,
            }),
            Some(Item::Degree) => self.error(Trouble::Sign),
            Some(_) => self.error(Trouble::LeftOver),
        }
    }

    /// What a LaTeX command takes: braces, or one sign.
    pub(crate) fn argument_of_command(&mut self) -> Result<Expr> {
        let span = self.here();
        if self.take('{') {
            return self.bracket('{', span);
        }
        self.primary()
    }

    pub(crate) fn binary(operator: Operator, left: Expr, right: Expr) -> Result<Expr> {
        let span = left.span().join(right.span());
        let expr = Expr::new(Kind::Binary(operator, left, right), span);
        if expr.depth() > MAX_DEPTH {
            return Err(TypedError {
                trouble: Trouble::TooDeep,
                span,
            });
        }
        Ok(expr)
    }
}
