//! The amounts that parts of a response are.

use super::{MAX_FORMULA_LENGTH, Part, Values};
use crate::amount::{Amount, split};
use crate::counts;
use crate::lost_power::lost_power;
use crate::parser::Parser;
use crate::signs::MIDDLE_POINT;
use crate::token::{Item, Token};
use crate::ways::readings;
use crate::{Trouble, Typed, TypedError, ValueTrouble};
use vibank_dynamics::numerics::Rational;
use vibank_formula::expr::{Constant, Expr, Kind, Operator};
use vibank_formula::unit::{Decimal, Unit};

impl Values<'_> {
    /// The amount that a part is.
    ///
    /// # Errors
    ///
    /// What stands in the way, and where.
    pub fn amount(&self, part: &Part) -> Result<Amount, TypedError> {
        let part = &self.without_mark(part);
        if let Some(amount) = self.literal(part) {
            return Ok(amount);
        }
        let inner = self.unbracketed(part);
        if let Some(amount) = inner.as_ref().and_then(|inner| self.literal(inner)) {
            return Ok(amount);
        }
        if let Some(amount) = self.in_words(part).or_else(|| self.mixed(part)) {
            return Ok(amount);
        }
        self.refuse(part, inner.as_ref())?;
        let whole = self.formula(part);
        if let Some(mut amount) = lost_power(&self.tokens[part.clone()], self.text) {
            amount
                .others
                .extend(whole.and_then(|whole| self.checked(&whole.value, part)));
            return Ok(amount);
        }
        let whole = whole?;
        let mut amount = self.checked(&whole.value, part)?;
        let others = whole.others.iter();
        // `arctan(1,0)` may have one argument or two: no rule for products says which.
        amount.is_by_rule = !self.has_tight_comma(part);
        amount
            .others
            .extend(others.filter_map(|other| self.checked(other, part).ok()));
        amount.others.extend(self.by_middle_point(part));
        Ok(amount)
    }

    /// The amount that words are, `one third`, `fifty %`, `minus ninety degrees`.
    fn in_words(&self, part: &Part) -> Option<Amount> {
        let text = self.text(part);
        let (is_negative, bare) = match text.strip_prefix(['-', '+']) {
            Some(bare) => (text.starts_with('-'), bare.trim_start()),
            None => (false, text),
        };
        if !bare.starts_with(char::is_alphabetic) {
            return None;
        }
        let (value, unit) = match counts::in_words(bare) {
            Some((value, true)) => (value, Unit::read("%").ok()?),
            Some((value, false)) => (value, Unit::ONE),
            None => {
                let (number, unit) = counts::in_front(bare);
                (counts::in_words(number)?.0, Unit::read(unit).ok()?)
            }
        };
        let value = if is_negative { -value } else { value };
        Some(Amount::ratio(value, unit))
    }

    /// An integer and a fraction after it, `33 1/3 %`, `7 3/4`.
    fn mixed(&self, part: &Part) -> Option<Amount> {
        let (numbers, unit) = match &self.tokens[part.clone()] {
            [
                numbers @ ..,
                Token {
                    item: Item::Unit(unit),
                    ..
                },
            ] => (numbers, **unit),
            numbers => (numbers, Unit::ONE),
        };
        // `3 1/2 m` may be a product.
        if !unit.is_one() && Ok(unit) != Unit::read("%") {
            return None;
        }
        let [whole, above, slash, below] = numbers else {
            return None;
        };
        let number = |token: &Token| match token.item {
            Item::Number(number) if number.denominator() == 1 => Some(number),
            _ => None,
        };
        let fraction = number(above)?.checked_div(number(below)?)?;
        let is_mixed = above.is_spaced && slash.item == Item::Sign('/') && fraction < Rational::ONE;
        let value = number(whole)?.checked_add(fraction).filter(|_| is_mixed)?;
        Some(Amount::ratio(value, unit))
    }

    /// The ratio of two numbers around a colon, `2:7`.
    pub fn ratio(&self, part: &Part) -> Option<Amount> {
        let [above, colon, below] = &self.tokens[part.clone()] else {
            return None;
        };
        let (Item::Number(above), Item::Number(below)) = (&above.item, &below.item) else {
            return None;
        };
        let is_ratio = colon.item == Item::Sign(':');
        let value = above.checked_div(*below).filter(|_| is_ratio)?;
        Some(Amount::ratio(value, Unit::ONE))
    }

    /// The decimal that a product of two integers may be, `6·1237 m`.
    fn by_middle_point(&self, part: &Part) -> Option<Amount> {
        let (sign, tokens) = match self.first(part) {
            Item::Sign(sign @ ('-' | '+')) => (*sign, &self.tokens[part.start + 1..part.end]),
            _ => ('+', &self.tokens[part.clone()]),
        };
        let [whole, point, decimals, unit @ ..] = tokens else {
            return None;
        };
        let typed = |token: &Token| &self.text[token.span.range()];
        let unit = match unit {
            [] => Unit::ONE,
            [
                Token {
                    item: Item::Unit(unit),
                    ..
                },
            ] => **unit,
            _ => return None,
        };
        let is_point = typed(point) == MIDDLE_POINT.encode_utf8(&mut [0; 4]);
        let value = format!("{sign}{}.{}", typed(whole), typed(decimals));
        let value = Decimal::parse(value.trim_start_matches('+'))
            .ok()
            .filter(|_| is_point)?;
        Some(Amount::decimal(value, unit))
    }

    /// What speaks against a part as an amount before its formula is read; `inner` is what stands in brackets around all
    /// of it.
    fn refuse(&self, part: &Part, inner: Option<&Part>) -> Result<(), TypedError> {
        let span = self.span(part);
        let error = |trouble| Err(TypedError { trouble, span });
        if !self.has_number(part) {
            let unread = self.items(part).find_map(|item| match item {
                Item::Unread(error) => Some((**error).clone()),
                _ => None,
            });
            return Err(unread.unwrap_or(TypedError {
                trouble: Trouble::Value(ValueTrouble::Missing),
                span,
            }));
        }
        let is_sign = |item: Option<&Item>| matches!(item, Some(Item::Sign('+' | '-' | '±' | '∓')));
        let mut items = self.items(part);
        if is_sign(items.next()) && is_sign(items.next()) {
            return error(Trouble::Value(ValueTrouble::TwoSigns));
        }
        let are_doubled = |pair: &[Token]| {
            let is_it = |token: &Token| matches!(token.item, Item::Sign('+' | '-'));
            is_it(&pair[0]) && is_it(&pair[1]) && !pair[1].is_spaced
        };
        if self.tokens[part.clone()].windows(2).any(are_doubled) {
            return error(Trouble::Value(ValueTrouble::TwoSigns));
        }
        // `[2]` is a list of one value, `[2, 3]` is not.
        let is_list =
            |inner: &Part| self.statements(inner).len() > 1 || self.spaced(inner).is_some();
        if inner.is_some_and(is_list) && *self.first(part) != Item::Sign('(') {
            return error(Trouble::List);
        }
        if matches!(self.first(part), Item::Unit(_)) {
            return error(Trouble::Value(ValueTrouble::Missing));
        }
        if self.text(part).len() > MAX_FORMULA_LENGTH {
            return error(Trouble::TooLong);
        }
        Ok(())
    }

    /// The amount that a side before the last one is: there `6-4` is a difference, no range.
    ///
    /// # Errors
    ///
    /// As for [`Self::amount`].
    pub fn amount_of_step(&self, part: &Part) -> Result<Amount, TypedError> {
        self.amount(part).or_else(|error| match error.trouble {
            Trouble::Value(ValueTrouble::Range) => {
                let formula = self.formula(part)?.value;
                split(&formula).map_err(|trouble| TypedError { trouble, ..error })
            }
            _ => Err(error),
        })
    }

    fn first(&self, part: &Part) -> &Item {
        const NOTHING: &Item = &Item::Sign(' ');
        self.tokens[part.clone()]
            .first()
            .map_or(NOTHING, |token| &token.item)
    }

    /// The formula that a part is, units as factors, and what it may be meant as otherwise.
    fn formula(&self, part: &Part) -> Result<Typed<Expr>, TypedError> {
        let end = self.span(part).range().end;
        let tokens = &self.tokens[part.clone()];
        readings(|ways| Parser::of_values(tokens, end, ways).whole_formula())
    }

    /// A decimal with its unit.
    pub(crate) fn literal(&self, part: &Part) -> Option<Amount> {
        let tokens = &self.tokens[part.clone()];
        let (is_negative, tokens) = match tokens.first()?.item {
            Item::Sign('-') => (true, &tokens[1..]),
            Item::Sign('+') => (false, &tokens[1..]),
            _ => (false, tokens),
        };
        let (number, unit) = match tokens {
            [number] => (number, Unit::ONE),
            [
                number,
                Token {
                    item: Item::Unit(unit),
                    ..
                },
            ] => (number, **unit),
            [
                number,
                times,
                Token {
                    item: Item::Unit(unit),
                    ..
                },
            ] if times.item == Item::Sign('*') => (number, **unit),
            _ => return None,
        };
        let literal = number.literal.as_ref()?;
        let of = |decimal: Decimal| {
            let signed = if is_negative {
                decimal.negated()
            } else {
                decimal
            };
            Amount::decimal(signed, unit)
        };
        let mut amount = of(literal.value);
        amount.others.extend(literal.other.map(of));
        Some(amount)
    }

    /// Without the sign of a number that has no unit: `[-]`, `(-)`, `[1]`.
    fn without_mark(&self, part: &Part) -> Part {
        let length = match &self.tokens[part.clone()] {
            [_, .., open, sign, close] => {
                let are_round = (&open.item, &close.item) == (&Item::Sign('('), &Item::Sign(')'));
                let are_square = (&open.item, &close.item) == (&Item::Sign('['), &Item::Sign(']'));
                let is_one = matches!(&sign.item, Item::Number(one) if *one == Rational::ONE);
                let is_dash = sign.item == Item::Sign('-') && (are_round || are_square);
                if is_dash || are_square && is_one {
                    3
                } else {
                    0
                }
            }
            _ => 0,
        };
        part.start..part.end - length
    }

    /// The amount that a formula is, unless it may be meant otherwise.
    fn checked(&self, formula: &Expr, part: &Part) -> Result<Amount, TypedError> {
        let span = self.span(part);
        let error = |trouble| Err(TypedError { trouble, span });
        let (mut bare, mut powers, mut has_infinity) = (0, 0, false);
        formula.walk(&mut |node| match node.kind() {
            Kind::Constant(Constant::E) => bare += 1,
            Kind::Constant(Constant::Infinity) => has_infinity = true,
            Kind::Binary(Operator::Power, base, _)
                if *base.kind() == Kind::Constant(Constant::E) =>
            {
                powers += 1;
            }
            _ => {}
        });
        if bare > powers {
            return error(Trouble::Value(ValueTrouble::NoExponent));
        }
        if has_infinity {
            return error(Trouble::Value(ValueTrouble::Missing));
        }
        let minus = part
            .clone()
            .skip(1)
            .find(|at| self.tokens[*at].item == Item::Sign('-'));
        if let Some(at) = minus.filter(|at| at + 1 < part.end)
            && self.tokens[at..=at + 1].iter().all(|own| !own.is_spaced)
            && self.literal(&(part.start..at)).is_some()
            && self.literal(&(at + 1..part.end)).is_some()
        {
            return error(Trouble::Value(ValueTrouble::Range));
        }
        split(formula).map_err(|trouble| TypedError { trouble, span })
    }
}
