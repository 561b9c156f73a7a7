//! Functions and roots, with brackets and without.

use super::composition::{has_unit, number, uses_time};
use super::parser::{Parser, Result};
use super::signs::DECIMAL;
use super::token::Item;
use super::token::is_time;
use super::ways::Doubtful;
use super::words::Powered;
use super::{Trouble, TypedError};
use vibank_dynamics::numerics::Rational;
use vibank_formula::expr::{Constant, Expr, Function, Kind, Operator};
use vibank_source::Span;

impl Parser<'_> {
    pub(crate) fn radical(&mut self, span: Span) -> Result<Expr> {
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

    /// Whether a number in square brackets and a brace come next, as behind the command of a root: `sqrt[3]{x}`.
    fn is_indexed(&self) -> bool {
        let next = self.tokens.get(self.at..).unwrap_or_default();
        let mut items = next.iter().map(|token| &token.item);
        items.next() == Some(&Item::Sign('['))
            && matches!(items.next(), Some(Item::Number(_)))
            && items.next() == Some(&Item::Sign(']'))
            && items.next() == Some(&Item::Sign('{'))
    }

    pub(crate) fn function(&mut self, function: Function, span: Span) -> Result<Expr> {
        if function == Function::Sqrt && self.is_indexed() {
            return self.radical(span);
        }
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
        let is_square = self.is_sign('[');
        let mut arguments = self.arguments(function)?;
        if function == Function::Atan && arguments.len() == 2 {
            // `ArcTan[x, y]` of Mathematica has the abscissa first.
            if is_square {
                arguments.reverse();
            }
            function = Function::Atan2;
        }
        let is_minus_one = |argument: &Expr| argument.as_number() == Some(-Rational::ONE);
        let kind = if function == Function::Sqrt && arguments.iter().all(is_minus_one) {
            Kind::Constant(Constant::ImaginaryUnit)
        } else {
            Kind::Call(function, arguments)
        };
        let call = Expr::new(kind, span);
        match exponent {
            Some(exponent) => Self::binary(Operator::Power, call, exponent),
            None => Ok(call),
        }
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

    /// `pow(base, exponent)`, `cbrt(base)`, `root(base)`, `nthroot(base, degree)`.
    pub(crate) fn powered(&mut self, powered: Powered, span: Span) -> Result<Expr> {
        let (name, least, most) = match powered {
            Powered::Any => ("pow", 2, 2),
            Powered::CubeRoot => ("cbrt", 1, 1),
            Powered::Root => ("root", 1, 2),
            Powered::Complex => ("complex", 2, 2),
            Powered::Polar => ("polar", 2, 2),
            Powered::Quotient => ("Rational", 2, 2),
        };
        let whole = |value| Expr::new(number(value), span);
        let mut arguments = self.listed()?.into_iter();
        let found = (arguments.next(), arguments.next(), arguments.next());
        let (base, degree) = match (powered, found) {
            (Powered::Any, (Some(base), Some(exponent), None)) => {
                return Self::binary(Operator::Power, base, exponent);
            }
            (Powered::Complex, (Some(real), Some(imaginary), None)) => {
                let unit = Expr::new(Kind::Constant(Constant::ImaginaryUnit), span);
                let imaginary = Self::binary(Operator::Multiply, unit, imaginary)?;
                return Self::binary(Operator::Add, real, imaginary);
            }
            (Powered::Polar, (Some(modulus), Some(angle), None)) => {
                return Self::polar(modulus, angle, span);
            }
            (Powered::Quotient, (Some(above), Some(below), None)) => {
                return Self::binary(Operator::Divide, above, below);
            }
            (Powered::Root, (Some(base), None, None)) => {
                return Ok(Expr::new(Kind::Call(Function::Sqrt, vec![base]), span));
            }
            (Powered::Root, (Some(base), Some(degree), None)) => (base, degree),
            (Powered::CubeRoot, (Some(base), None, None)) => (base, whole(3)),
            _ => {
                let trouble = Trouble::Arguments { name, least, most };
                return Err(TypedError { trouble, span });
            }
        };
        let exponent = Self::binary(Operator::Divide, whole(1), degree)?;
        Self::binary(Operator::Power, base, exponent)
    }

    fn arguments(&mut self, function: Function) -> Result<Vec<Expr>> {
        let open = self.here();
        if !matches!(self.item(), Some(Item::Sign('(' | '[' | '{'))) {
            let first = self.signed()?;
            let is_root = function == Function::Sqrt;
            let argument = self.goes_on_bare(first, false, is_root)?;
            return Self::counted(function, vec![argument], open);
        }
        let mut arguments = self.listed()?;
        // `cos(ω_n) t`, where only so it makes sense; a sign of times says that the bracket ends the argument.
        if let [argument] = &arguments[..]
            && function != Function::Sqrt
            && !self.is_sign('*')
            && let Some(end) = self.end_at_time(argument)
            && self.ways.choose(Doubtful::Argument, false)
        {
            arguments = vec![self.times(argument.clone(), end)?];
        }
        Self::counted(function, arguments, open)
    }

    /// Where a product of letters and numbers goes on to the time, with signs or without, behind an argument that does
    /// not have it: `cos ω_n·t`, `cos 2π·f·t`.
    fn end_at_time(&self, argument: &Expr) -> Option<usize> {
        if uses_time(argument) || has_unit(argument) {
            return None;
        }
        let mut at = self.at;
        loop {
            at += usize::from(self.tokens.get(at)?.item == Item::Sign('*'));
            let token = self.tokens.get(at)?;
            match token.item {
                _ if is_time(token) => return Some(at + 1),
                Item::Leaf(_) | Item::Number(_) | Item::Power(_) => at += 1,
                _ => return None,
            }
        }
    }

    /// An argument times what stands before a place, with signs or without.
    fn times(&mut self, argument: Expr, end: usize) -> Result<Expr> {
        let mut argument = argument;
        while self.at < end {
            self.take('*');
            let factor = self.power()?;
            argument = Self::binary(Operator::Multiply, argument, factor)?;
        }
        Ok(argument)
    }

    /// Whether a brace opens here right around a bracket, as in `\operatorname{atan2}{(y, x)}`.
    fn is_brace_around(&self) -> bool {
        let mut depth = 0_usize;
        let close = (self.at..self.tokens.len()).find(|at| {
            match self.tokens[*at].item {
                Item::Sign('(' | '[' | '{') => depth += 1,
                Item::Sign(')' | ']' | '}') => depth = depth.saturating_sub(1),
                _ => {}
            }
            depth <= 1 && *at > self.at + 1
        });
        let is = |at: usize, sign: char| {
            self.tokens
                .get(at)
                .is_some_and(|token| token.item == Item::Sign(sign))
        };
        is(self.at, '{')
            && is(self.at + 1, '(')
            && close.is_some_and(|close| is(close, ')') && is(close + 1, '}'))
    }

    /// The formulas in a bracket.
    fn listed(&mut self) -> Result<Vec<Expr>> {
        let open = self.here();
        if self.is_brace_around() {
            self.at += 1;
            let arguments = self.listed()?;
            self.close('}', open)?;
            return Ok(arguments);
        }
        let close = match self.item() {
            Some(Item::Sign('(')) => ')',
            Some(Item::Sign('[')) => ']',
            Some(Item::Sign('{')) => '}',
            _ => return self.error(Trouble::Missing),
        };
        self.at += 1;
        let bars = std::mem::take(&mut self.bars);
        let mut arguments = vec![self.sum()?];
        if self.is_sign(DECIMAL) {
            self.decimals(&mut arguments)?;
        }
        while self.take(',') || self.take(';') {
            arguments.push(self.sum()?);
        }
        self.bars = bars;
        self.close(close, open)?;
        Ok(arguments)
    }

    /// The digits after a comma that is a decimal sign by the rule, and may part two arguments.
    fn decimals(&mut self, arguments: &mut Vec<Expr>) -> Result<()> {
        self.at += 1;
        let span = self.here();
        let behind = self.sum()?;
        if !self.ways.choose(Doubtful::Comma, true) {
            arguments.push(behind);
            return Ok(());
        }
        let figures = u32::try_from(span.range().len()).ok();
        let whole = arguments.first().and_then(Expr::as_number);
        let value =
            figures
                .zip(whole)
                .zip(behind.as_number())
                .and_then(|((figures, whole), tenths)| {
                    let unit = Rational::new(1, 10_i128.checked_pow(figures)?)?;
                    whole.checked_add(tenths.checked_mul(unit)?)
                });
        match value {
            Some(value) => {
                *arguments = vec![Expr::new(Kind::Number(value), span)];
                Ok(())
            }
            None => self.error(Trouble::Number),
        }
    }

    fn counted(function: Function, arguments: Vec<Expr>, span: Span) -> Result<Vec<Expr>> {
        let (least, most) = function.arity();
        // `atan(y, x)` and `ArcTan[x, y]`.
        let most = if function == Function::Atan { 2 } else { most };
        if (least..=most).contains(&arguments.len()) {
            return Ok(arguments);
        }
        Err(TypedError {
            trouble: Trouble::Arguments {
                name: function.name(),
                least,
                most,
            },
            span,
        })
    }

    /// What stands under `√`: brackets, or what they may be left out of.
    pub(crate) fn root(&mut self, span: Span) -> Result<Expr> {
        let is_closed = matches!(
            self.item(),
            Some(Item::Sign(_) | Item::Function(_) | Item::Powered(_) | Item::Root)
        );
        let inner = if is_closed {
            self.primary()?
        } else {
            let first = self.power()?;
            self.goes_on_bare(first, true, true)?
        };
        Ok(Expr::new(Kind::Call(Function::Sqrt, vec![inner]), span))
    }

    /// An argument without brackets: a product without signs, up to the next function. The sign `√` takes no more
    /// of it than the letters that stand tight. A slash ends it, unless only so it makes sense: `√k/m`.
    fn goes_on_bare(&mut self, first: Expr, is_sign: bool, is_root: bool) -> Result<Expr> {
        let mut argument = first;
        while self.begins_factor() {
            if let Some(Item::Unit(unit)) = self.item() {
                // `sin 30°`, but `√25 m` and `sqrt 90 deg`.
                if is_root || !unit.dimension().is_pure() {
                    break;
                }
                let angle = self.power()?;
                argument = Self::binary(Operator::Multiply, argument, angle)?;
                continue;
            }
            let is_tight = self.is_tight();
            let by_rule = match self.item() {
                Some(Item::Function(_) | Item::Powered(_)) => break,
                // `cos 5t e^-t`
                Some(Item::Leaf(leaf)) if *leaf.kind() == Kind::Constant(Constant::E) => break,
                // `sin x (a + b)`.
                Some(Item::Sign(_)) if !is_tight => break,
                Some(Item::Leaf(_) | Item::Unit(_)) => is_tight || !is_sign,
                _ => !is_sign,
            };
            if !self.ways.choose(Doubtful::Argument, by_rule) {
                break;
            }
            let factor = self.power()?;
            argument = Self::binary(Operator::Multiply, argument, factor)?;
        }
        // `cos ω_n·t`: a sign of times ends an argument, but before the time that it lacks.
        if !is_root
            && self.is_sign('*')
            && let Some(end) = self.end_at_time(&argument)
            && self.ways.choose(Doubtful::Argument, true)
        {
            argument = self.times(argument, end)?;
        }
        while self.is_sign('/')
            && self.is_tight()
            // `√50/√2` is a quotient of roots.
            && !(is_root && matches!(self.tokens.get(self.at + 1).map(|next| &next.item), Some(Item::Root | Item::Radical)))
            && self.ways.choose(Doubtful::Argument, false)
        {
            self.at += 1;
            let divisor = self.divisor(&argument)?;
            argument = Self::binary(Operator::Divide, argument, divisor)?;
        }
        Ok(argument)
    }
}
