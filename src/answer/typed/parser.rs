//! From tokens to formulas.

use super::token::{Item, Token};
use super::{Chain, DEEPEST, Trouble, TypedError};
use crate::expr::{Constant, Expr, Function, Kind, Name, Operator, Relation};
use crate::numerics::Rational;
use crate::source::Span;
use crate::unit::Unit;

/// How far a divisor reaches that has no brackets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Slash {
    /// By the rule.
    Rule,
    /// The other way wherever there are two.
    Other,
}

pub(super) struct Parser<'a> {
    tokens: &'a [Token],
    at: usize,
    end: usize,
    slash: Slash,
    is_open: bool,
    depth: u32,
    /// Open bars of absolute values within the innermost bracket.
    bars: u32,
}

type Result<T> = std::result::Result<T, TypedError>;

/// Brackets, functions and exponents within one another.
const MOST_NESTED: u32 = 60;

impl<'a> Parser<'a> {
    pub(super) fn new(tokens: &'a [Token], end: usize, slash: Slash) -> Self {
        Self {
            tokens,
            at: 0,
            end,
            slash,
            is_open: false,
            depth: 0,
            bars: 0,
        }
    }

    /// Whether a slash left it open how far its divisor reaches.
    pub(super) fn is_open(&self) -> bool {
        self.is_open
    }

    pub(super) fn whole_formula(&mut self) -> Result<Expr> {
        let formula = self.sum()?;
        self.finish()?;
        Ok(formula)
    }

    pub(super) fn whole_chain(&mut self) -> Result<Chain> {
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

    fn item(&self) -> Option<&'a Item> {
        self.tokens.get(self.at).map(|token| &token.item)
    }

    fn is_sign(&self, sign: char) -> bool {
        self.item() == Some(&Item::Sign(sign))
    }

    fn take(&mut self, sign: char) -> bool {
        let found = self.is_sign(sign);
        self.at += usize::from(found);
        found
    }

    fn here(&self) -> Span {
        self.tokens
            .get(self.at)
            .map_or(Span::new(self.end, self.end), |token| token.span)
    }

    fn error<T>(&self, trouble: Trouble) -> Result<T> {
        Err(TypedError {
            trouble,
            span: self.here(),
        })
    }

    fn deeper<T>(&mut self, inner: impl FnOnce(&mut Self) -> Result<T>) -> Result<T> {
        if self.depth >= MOST_NESTED {
            return self.error(Trouble::TooDeep);
        }
        self.depth += 1;
        let result = inner(self);
        self.depth -= 1;
        result
    }

    fn sum(&mut self) -> Result<Expr> {
        let mut sum = self.term()?;
        loop {
            let operator = match self.item() {
                Some(Item::Sign('+')) => Operator::Add,
                Some(Item::Sign('-')) => Operator::Subtract,
                _ => return Ok(sum),
            };
            self.at += 1;
            let term = self.term()?;
            sum = Self::binary(operator, sum, term)?;
        }
    }

    fn term(&mut self) -> Result<Expr> {
        let mut left = self.signed()?;
        loop {
            match self.item() {
                Some(Item::Sign('*')) => {
                    self.at += 1;
                    let right = self.signed()?;
                    left = Self::binary(Operator::Multiply, left, right)?;
                }
                Some(Item::Sign('/')) => {
                    self.at += 1;
                    let divisor = self.divisor(&left)?;
                    left = Self::binary(Operator::Divide, left, divisor)?;
                }
                Some(Item::Number(_)) if !self.is_after_imaginary_unit() => {
                    return self.error(Trouble::NumberAfter);
                }
                Some(Item::Number(_)) => {
                    let right = self.power()?;
                    left = Self::binary(Operator::Multiply, left, right)?;
                }
                _ if self.begins_factor() => {
                    let right = self.power()?;
                    left = Self::binary(Operator::Multiply, left, right)?;
                }
                _ => return Ok(left),
            }
        }
    }

    /// Whether a number may stand here without a sign, as in `j100`.
    fn is_after_imaginary_unit(&self) -> bool {
        let before = self.at.checked_sub(1).and_then(|at| self.tokens.get(at));
        before.is_some_and(|token| {
            matches!(&token.item, Item::Leaf(leaf) if *leaf.kind() == Kind::Constant(Constant::ImaginaryUnit))
        })
    }

    /// A factor with signs in front.
    fn signed(&mut self) -> Result<Expr> {
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
    fn divisor(&mut self, numerator: &Expr) -> Result<Expr> {
        let is_closed = matches!(
            self.item(),
            Some(
                Item::Sign('(' | '[' | '{' | '|')
                    | Item::Fraction
                    | Item::Radical
                    | Item::Function(_)
            )
        );
        let mut divisor = self.signed()?;
        if is_closed || !self.begins_factor() {
            return Ok(divisor);
        }
        let is_fraction = is_number(numerator) && is_number(&divisor);
        let is_tight = !self.tokens[self.at].is_spaced;
        let by_rule = !is_fraction && is_tight;
        // `1/2 m` can be read in one way only.
        self.is_open |= !is_fraction || is_tight;
        let takes = match self.slash {
            Slash::Rule => by_rule,
            Slash::Other => !by_rule && (!is_fraction || is_tight),
        };
        while takes
            && self.begins_factor()
            && (self.slash == Slash::Other || !self.tokens[self.at].is_spaced)
        {
            let factor = self.power()?;
            divisor = Self::binary(Operator::Multiply, divisor, factor)?;
        }
        Ok(divisor)
    }

    /// Whether a factor can begin here without a sign before it.
    fn begins_factor(&self) -> bool {
        match self.item() {
            Some(Item::Sign(sign)) => {
                matches!(sign, '(' | '[' | '{') || *sign == '|' && self.bars == 0
            }
            Some(
                Item::Leaf(_) | Item::Function(_) | Item::Root | Item::Radical | Item::Fraction,
            ) => true,
            _ => false,
        }
    }

    fn power(&mut self) -> Result<Expr> {
        let base = self.primary()?;
        self.raised(base)
    }

    /// A base with the exponents behind it.
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
                Some(Item::Sign('^')) => {
                    self.at += 1;
                    let exponent = self.deeper(|parser| parser.exponent(&base))?;
                    return Self::binary(Operator::Power, base, exponent);
                }
                _ => return Ok(base),
            }
        }
    }

    fn exponent(&mut self, base: &Expr) -> Result<Expr> {
        let is_closed = matches!(self.item(), Some(Item::Sign('(' | '{' | '[')));
        let span = self.here();
        if self.take('-') {
            let inner = self.deeper(|parser| parser.exponent(base))?;
            return Ok(Expr::new(Kind::Negate(inner), span));
        }
        let mut exponent = self.power()?;
        // `e^iωt` has all of it in the exponent.
        let is_exponential = *base.kind() == Kind::Constant(Constant::E) && !is_closed;
        while is_exponential && self.goes_on_in_exponent() {
            let factor = self.power()?;
            exponent = Self::binary(Operator::Multiply, exponent, factor)?;
        }
        let is_open = is_exponential && !exponent.names().uses(&Name::new("t"));
        if is_open && self.tokens.get(self.at).is_some_and(is_time) {
            // `e^-λ t`: by the rule the time is no part of it, as most people mean it is.
            return self.error(Trouble::Exponent);
        }
        if !is_closed && is_number(&exponent) && self.is_fraction_of_numbers() {
            // `a^1/2` is a/2, but where only the root has the right dimension it is the root.
            self.is_open = true;
            if self.slash == Slash::Other {
                self.at += 1;
                let divisor = self.primary()?;
                exponent = Self::binary(Operator::Divide, exponent, divisor)?;
            }
        }
        Ok(exponent)
    }

    /// Whether a factor follows without a space, as in `e^iωt` and `e^i2t`.
    fn goes_on_in_exponent(&self) -> bool {
        let is_number = matches!(self.item(), Some(Item::Number(_)));
        let begins = self.begins_factor() || is_number && self.is_after_imaginary_unit();
        begins && !self.tokens[self.at].is_spaced
    }

    /// Whether a slash and a number follow without a space.
    fn is_fraction_of_numbers(&self) -> bool {
        let Some([slash, number]) = self.tokens.get(self.at..self.at + 2) else {
            return false;
        };
        slash.item == Item::Sign('/')
            && matches!(number.item, Item::Number(_))
            && !slash.is_spaced
            && !number.is_spaced
    }

    fn primary(&mut self) -> Result<Expr> {
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
                    let degree = Unit::parse("deg").unwrap_or(Unit::ONE);
                    return Ok(Expr::new(Kind::Measure(*value, Box::new(degree)), span));
                }
                Ok(Expr::new(Kind::Number(*value), span))
            }
            Item::Leaf(leaf) => {
                self.skip_time(leaf);
                Ok(Expr::new(leaf.kind().clone(), span))
            }
            Item::Function(function) => self.deeper(|parser| parser.function(*function, span)),
            Item::Root => self.deeper(|parser| {
                let inner = parser.primary()?;
                let inner = parser.quotient_under_root(inner)?;
                Ok(Expr::new(Kind::Call(Function::Sqrt, vec![inner]), span))
            }),
            Item::Radical => self.deeper(|parser| parser.radical(span)),
            Item::Fraction => self.deeper(|parser| {
                let above = parser.argument_of_command()?;
                let below = parser.argument_of_command()?;
                Self::binary(Operator::Divide, above, below)
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

    /// `x(t)` and `x[t]` are `x`.
    fn skip_time(&mut self, leaf: &Expr) {
        let is_name = matches!(leaf.kind(), Kind::Name(name) if name.as_str() != "t")
            || matches!(leaf.kind(), Kind::Prime(..));
        if let Some([open, time, close]) = self.tokens.get(self.at..self.at + 3)
            && is_name
            && matches!(
                (&open.item, &close.item),
                (Item::Sign('('), Item::Sign(')')) | (Item::Sign('['), Item::Sign(']'))
            )
            && is_time(time)
            && !open.is_spaced
        {
            self.at += 3;
        }
    }

    /// What stands in a bracket that is open.
    fn bracket(&mut self, open: char, span: Span) -> Result<Expr> {
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
        if !self.take(close) {
            return match self.item() {
                None => Err(TypedError {
                    trouble: Trouble::Bracket,
                    span,
                }),
                Some(_) => self.error(Trouble::LeftOver),
            };
        }
        Ok(inner)
    }

    /// What a LaTeX command takes: braces, or one sign.
    fn argument_of_command(&mut self) -> Result<Expr> {
        let span = self.here();
        if self.take('{') {
            return self.bracket('{', span);
        }
        self.primary()
    }

    fn radical(&mut self, span: Span) -> Result<Expr> {
        let index = if self.is_sign('[') {
            let open = self.here();
            self.at += 1;
            Some(self.bracket('[', open)?)
        } else {
            None
        };
        let inner = self.argument_of_command()?;
        match index {
            None => Ok(Expr::new(Kind::Call(Function::Sqrt, vec![inner]), span)),
            Some(index) => {
                let one = Expr::new(number(1), span);
                let exponent = Self::binary(Operator::Divide, one, index)?;
                Self::binary(Operator::Power, inner, exponent)
            }
        }
    }

    fn function(&mut self, function: Function, span: Span) -> Result<Expr> {
        let mut function = function;
        let mut exponent = None;
        match self.item() {
            Some(Item::Power(-1)) => {
                function = self.inverse(function)?;
                self.at += 1;
            }
            Some(Item::Power(power)) => {
                exponent = Some(Expr::new(number(*power), self.here()));
                self.at += 1;
            }
            Some(Item::Sign('^')) => {
                self.at += 1;
                let one = Expr::number(1);
                let found = self.exponent(&one)?;
                if found.as_number() == Some(-Rational::ONE) {
                    function = self.inverse(function)?;
                } else {
                    exponent = Some(found);
                }
            }
            _ => {}
        }
        let is_bare = !matches!(self.item(), Some(Item::Sign('(' | '[' | '{')));
        let mut arguments = self.arguments(function)?;
        if let (true, Function::Sqrt, [inner]) = (is_bare, function, &arguments[..]) {
            arguments = vec![self.quotient_under_root(inner.clone())?];
        }
        let call = Expr::new(Kind::Call(function, arguments), span);
        match exponent {
            Some(exponent) => Self::binary(Operator::Power, call, exponent),
            None => Ok(call),
        }
    }

    /// `√k/m` is √k over m, but where only the root of the quotient has the right dimension it is that.
    fn quotient_under_root(&mut self, inner: Expr) -> Result<Expr> {
        let is_tight = self.is_sign('/') && !self.tokens[self.at].is_spaced;
        self.is_open |= is_tight;
        if !is_tight || self.slash == Slash::Rule {
            return Ok(inner);
        }
        self.at += 1;
        let divisor = self.power()?;
        Self::binary(Operator::Divide, inner, divisor)
    }

    /// `sin⁻¹` is the inverse function, not the reciprocal.
    fn inverse(&self, function: Function) -> Result<Function> {
        Ok(match function {
            Function::Sin => Function::Asin,
            Function::Cos => Function::Acos,
            Function::Tan => Function::Atan,
            Function::Sinh => Function::Asinh,
            Function::Cosh => Function::Acosh,
            Function::Tanh => Function::Atanh,
            _ => return self.error(Trouble::Sign),
        })
    }

    fn arguments(&mut self, function: Function) -> Result<Vec<Expr>> {
        let open = self.here();
        let close = match self.item() {
            Some(Item::Sign('(')) => ')',
            Some(Item::Sign('[')) => ']',
            Some(Item::Sign('{')) => '}',
            _ => {
                let argument = self.bare_argument()?;
                return Self::counted(function, vec![argument], open);
            }
        };
        self.at += 1;
        let bars = std::mem::take(&mut self.bars);
        let mut arguments = vec![self.sum()?];
        while self.take(',') || self.take(';') {
            arguments.push(self.sum()?);
        }
        self.bars = bars;
        if !self.take(close) {
            return Err(TypedError {
                trouble: Trouble::Bracket,
                span: open,
            });
        }
        Self::counted(function, arguments, open)
    }

    fn counted(function: Function, arguments: Vec<Expr>, span: Span) -> Result<Vec<Expr>> {
        let (least, most) = function.arity();
        if (least..=most).contains(&arguments.len()) {
            return Ok(arguments);
        }
        let count = if least == 1 && most == 1 {
            "one argument".to_owned()
        } else {
            format!("{least} arguments in brackets")
        };
        Err(TypedError {
            trouble: Trouble::Arguments {
                name: function.name(),
                count,
            },
            span,
        })
    }

    /// What a function without brackets takes: a product without signs, up to the next function.
    fn bare_argument(&mut self) -> Result<Expr> {
        let mut argument = self.signed()?;
        while self.begins_factor() && !matches!(self.item(), Some(Item::Function(_))) {
            // A bracket after a space does not belong to it: `sin x (a + b)`.
            let token = &self.tokens[self.at];
            if token.is_spaced && matches!(token.item, Item::Sign(_)) {
                break;
            }
            let factor = self.power()?;
            argument = Self::binary(Operator::Multiply, argument, factor)?;
        }
        Ok(argument)
    }

    fn binary(operator: Operator, left: Expr, right: Expr) -> Result<Expr> {
        let span = left.span().join(right.span());
        let expr = Expr::new(Kind::Binary(operator, left, right), span);
        if expr.depth() > DEEPEST {
            return Err(TypedError {
                trouble: Trouble::TooDeep,
                span,
            });
        }
        Ok(expr)
    }
}

/// Whether this is the time.
fn is_time(token: &Token) -> bool {
    let Item::Leaf(leaf) = &token.item else {
        return false;
    };
    matches!(leaf.kind(), Kind::Name(name) if name.as_str() == "t")
}

fn number(value: i128) -> Kind {
    Kind::Number(Rational::new(value, 1).unwrap_or(Rational::ZERO))
}

fn is_number(expr: &Expr) -> bool {
    expr.as_number().is_some()
}
