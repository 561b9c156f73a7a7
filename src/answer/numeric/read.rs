//! Numbers with units: what a response says that its name is, and how that is shown.

use super::restated::said_once;
use crate::answer::steps::Steps;
use crate::answer::{Example, Unreadable, Why};
use crate::expr::{Constant, Expr, Kind, Operator, PlainNotation};
use crate::math::Math;
use crate::response::{
    Amount, Lexicon, Manner, Number as Typed, Part, Passage, Style, Trouble, TypedError,
    ValueTrouble, Values, Wording,
};
use crate::unit::{Decimal, DecimalMark, Dimension, Quantity, Unit};

/// A number with its unit as it was typed.
#[derive(Clone, Debug)]
pub(crate) struct TypedNumber {
    pub(crate) quantity: Quantity,
    /// What was typed instead of a decimal.
    pub(crate) arithmetic: Option<Expr>,
    /// What else may have been meant.
    pub(crate) others: Vec<Self>,
    /// Whether the rules for products without signs say which is.
    pub(crate) is_by_rule: bool,
}

impl TypedNumber {
    /// The number that an amount is, if it has a real value.
    fn of(amount: &Amount) -> Option<Self> {
        let (value, arithmetic) = match &amount.number {
            Typed::Decimal(decimal) => (*decimal, None),
            Typed::Formula(formula) => {
                let value = amount.value()?.as_real()?;
                (Decimal::shortest(value)?, Some(formula.clone()))
            }
        };
        let others = amount.others.iter().filter_map(Self::of);
        Some(Self {
            quantity: Quantity::new(value, amount.unit),
            arithmetic,
            others: others.collect(),
            is_by_rule: amount.is_by_rule,
        })
    }

    /// The number that a formula of numbers is in a unit.
    pub(crate) fn of_formula(formula: Expr, unit: Unit) -> Option<Self> {
        Self::of(&Amount::of_formula(formula, unit))
    }

    /// The number that a product with a unit in it is, `80 cm * 0.2955`.
    fn of_product(typed: Passage<'_>) -> Option<Self> {
        let measured = typed.measured(&Lexicon::new(), false).ok()?.value;
        Self::of_formula(measured.formula, measured.unit?)
    }

    /// The same without its other readings.
    pub(crate) fn alone(&self) -> Self {
        Self {
            others: Vec::new(),
            ..self.clone()
        }
    }

    /// The same in a unit that stands elsewhere.
    pub(crate) fn with_unit(self, unit: Unit) -> Self {
        let others = self.others.into_iter().map(|other| other.with_unit(unit));
        Self {
            quantity: Quantity::new(self.quantity.value, unit),
            others: others.collect(),
            arithmetic: self.arithmetic,
            is_by_rule: self.is_by_rule,
        }
    }

    /// Typeset; arithmetic with what it comes to.
    pub(crate) fn math(&self, mark: DecimalMark) -> Math {
        // Two more than are asked for as a rule.
        const DIGITS: u32 = 5;
        let Some(expr) = &self.arithmetic else {
            return self.quantity.math(mark);
        };
        let value = self.quantity.value.to_f64();
        let rounded = Decimal::rounded(value, DIGITS).unwrap_or(self.quantity.value);
        let short = Decimal::shortest(rounded.to_f64()).unwrap_or(rounded);
        let is_exact = short.to_f64() == value;
        Math::row([
            expr.typeset(&PlainNotation),
            Math::relation(if is_exact { "=" } else { "≈" }),
            Quantity::new(short, self.quantity.unit).math(mark),
        ])
    }

    /// In the formula language.
    pub(crate) fn text(&self) -> String {
        match &self.arithmetic {
            None => self.quantity.to_string(),
            Some(expr) if self.quantity.unit.is_one() => expr.to_string(),
            Some(expr) => format!("({expr}) {}", self.quantity.unit),
        }
    }

    /// With radians per second for its hertz, where π multiplies them.
    pub(crate) fn in_radians(&self) -> Option<Self> {
        self.arithmetic
            .as_ref()
            .filter(|value| has_pi_as_factor(value))?;
        let hertz = self.quantity.unit;
        let is_hertz = hertz.has_factor("Hz") && hertz.dimension() == Dimension::TIME.inverse();
        let radians = ["rad/s", "krad/s", "mrad/s", "Mrad/s"].into_iter();
        let mut radians = radians.filter_map(|unit| Unit::parse(unit).ok());
        let unit = radians.find(|unit| is_hertz && unit.to_si(1.0) == hertz.to_si(1.0))?;
        Some(Self {
            quantity: Quantity::new(self.quantity.value, unit),
            arithmetic: self.arithmetic.clone(),
            others: Vec::new(),
            is_by_rule: false,
        })
    }

    /// With the readings alone that a step before it comes to, if there are such: of `6.283/4.964 = 1,266` that is 1.266.
    fn agreeing(&self, step: &Self) -> Option<Self> {
        // `2π · 2 Hz = 12.57 rad/s`
        let in_radians = step.in_radians();
        let agreeing = self.readings().filter(|own| {
            let mut readings = step.readings().chain(&in_radians);
            readings.any(|step| are_equal(own, step))
        });
        let mut agreeing = agreeing.cloned();
        let first = agreeing.next()?;
        Some(Self {
            others: agreeing.collect(),
            ..first
        })
    }

    /// What it is by the rules, and what else it may be.
    fn readings(&self) -> impl Iterator<Item = &Self> {
        std::iter::once(self).chain(&self.others)
    }

    /// Its other reading, where it has one.
    pub(crate) fn otherwise(&self) -> Self {
        self.others.first().unwrap_or(self).clone()
    }

    /// The question that is asked where the number may be meant otherwise.
    pub(crate) fn question(&self, mark: DecimalMark) -> Option<Unreadable> {
        let other = self.others.first()?;
        let shown = |number: &Self| number.quantity.text(mark);
        Some(Why::TwoReadings(shown(self), shown(other)).into())
    }
}

/// Whether a formula is π times something.
fn has_pi_as_factor(formula: &Expr) -> bool {
    match formula.kind() {
        Kind::Constant(Constant::Pi) => true,
        Kind::Negate(inner) | Kind::Binary(Operator::Divide, inner, _) => has_pi_as_factor(inner),
        Kind::Binary(Operator::Multiply, left, right) => {
            has_pi_as_factor(left) || has_pi_as_factor(right)
        }
        _ => false,
    }
}

/// What is known of an item where numbers are read.
#[derive(Clone, Copy)]
pub(crate) struct Setting<'a> {
    /// The decimal sign of the sheet.
    pub(crate) mark: DecimalMark,
    /// The unit that is asked for, and what steps may be written in.
    pub(crate) steps: Option<(&'a Unit, &'a Steps)>,
    /// The words of the question.
    pub(crate) asked: Option<&'a Wording>,
}

impl Setting<'_> {
    /// That of numbers which are derived from nothing.
    pub(crate) fn of(mark: DecimalMark) -> Self {
        Self {
            mark,
            steps: None,
            asked: None,
        }
    }

    /// Whether a side is a step in letters.
    fn is_step_in_letters(&self, side: Passage<'_>) -> bool {
        self.steps.is_some_and(|(_, steps)| steps.are_in(side))
    }

    /// Whether a side is a formula in letters of the question that has the dimension of what is asked.
    fn is_derived(&self, side: Passage<'_>) -> bool {
        self.steps
            .is_some_and(|(_, steps)| steps.are_derived_in(side))
    }

    /// Whether a unit has the dimension of what is asked.
    fn fits(&self, unit: &Unit) -> bool {
        let asked = self.steps.map(|(asked, _)| asked);
        asked.is_some_and(|asked| asked.dimension() == unit.dimension())
    }

    /// Whether a side is a power of what is asked.
    fn vanishes(&self, side: Passage<'_>) -> bool {
        self.steps.is_some_and(|(_, steps)| steps.vanishes(side))
    }

    /// Whether a step of bare numbers is in SI units, and what it comes to in the unit that is asked: `50/3872 = 12.9` of
    /// millimetres.
    fn is_in_si(&self, number: &TypedNumber, step: &TypedNumber) -> bool {
        let are_bare = number.quantity.unit.is_one() && step.quantity.unit.is_one();
        self.steps.is_some_and(|(asked, _)| {
            let in_si = || step.clone().with_unit(asked.coherent());
            are_bare
                && step.arithmetic.is_some()
                && are_equal(&number.clone().with_unit(*asked), &in_si())
        })
    }

    /// Whether the units of a step are letters of the question: `2√(L/C)` is no litre where a resistance is asked for.
    fn is_in_letters(&self, step: Passage<'_>, amount: &TypedNumber) -> bool {
        let unit = &amount.quantity.unit;
        self.steps.is_some_and(|(asked, steps)| {
            let is_formula = || step.formula(&steps.letters, Manner::default());
            !unit.is_one()
                && unit.dimension() != asked.dimension()
                && is_formula().is_ok_and(|formula| !formula.value.names().free.is_empty())
        })
    }
}

/// The number that a response is, beside its name and what it is said to equal.
///
/// # Errors
///
/// What cannot be read, and why.
pub(crate) fn number(
    response: Passage<'_>,
    setting: Setting<'_>,
) -> Result<TypedNumber, Unreadable> {
    number_alone(response, setting).or_else(|why| {
        // Ways to read it again, in the order in which they are tried. Unlike those of `grade` they are echoed, and what
        // comes out of one may be wrong.
        let without_words =
            || number_alone(response.without_words_of(setting.asked?)?, setting).ok();
        let concluded = || concluded(response, setting);
        // Last, since an uncertainty says more of a value than the words beside it.
        let without_spread = || number_alone(response.without_spread()?.passage(), setting).ok();
        let in_singular = || {
            let number = number_alone(response.in_singular()?, setting).ok()?;
            (!number.quantity.unit.is_one()).then_some(number)
        };
        let ratio = || number_alone(response.without_sign_of_ratio()?, setting).ok();
        let fits = |number: &TypedNumber| setting.fits(&number.quantity.unit);
        let is_pure = |_: &TypedNumber| setting.steps.is_some_and(|(asked, _)| asked.is_one());
        without_words()
            .or_else(concluded)
            .or_else(|| in_singular().filter(fits))
            .or_else(|| ratio().filter(is_pure))
            .or_else(without_spread)
            .ok_or(why)
    })
}

/// The number without a name that is concluded last, if it fits what is asked: `mg = μmg, so 1`.
fn concluded(response: Passage<'_>, setting: Setting<'_>) -> Option<TypedNumber> {
    let conclusion = response.concluded()?;
    let (asked, _) = setting.steps?;
    let number = number_alone(conclusion, setting).ok()?;
    let unit = number.quantity.unit;
    let is_fitting = unit.is_one() || unit.dimension() == asked.dimension();
    (is_fitting && conclusion.equated().is_none()).then_some(number)
}

/// The same with no word of the question beside it.
fn number_alone(response: Passage<'_>, setting: Setting<'_>) -> Result<TypedNumber, Unreadable> {
    let style = Style {
        mark: setting.mark,
        comma_is_decimal: true,
        is_complex: false,
    };
    let values =
        Values::read(response, style).map_err(|error| Unreadable::typed(&error, response))?;
    let all = values.all();
    let mut restated = values.statements(&all);
    if restated.len() > 1 {
        return said_once(&values, &restated, true, setting).ok_or_else(|| {
            Unreadable::at(response.short(), Why::Inequality).like(Example::OneValue)
        });
    }
    if let Some((value, inner)) = values.back_bracket(&all) {
        restated = vec![value, inner];
        if let Some(number) = said_once(&values, &restated, false, setting) {
            return Ok(number);
        }
        // `0.7 s (second)`
        let [value, inner] = &restated[..] else {
            return statement(&values, &all, setting);
        };
        if values.is_unit_again(value, inner) {
            return statement(&values, value, setting);
        }
    }
    statement(&values, &all, setting)
}

/// The number that a statement gives.
pub(crate) fn statement(
    values: &Values<'_>,
    part: &Part,
    setting: Setting<'_>,
) -> Result<TypedNumber, Unreadable> {
    let statement = values.statement(part);
    if let Some(sign) = statement.unequal {
        if let Some(ratio) = values.ratio(part).as_ref().and_then(TypedNumber::of) {
            return Ok(ratio);
        }
        if let Some(number) = rightly_compared(values, part, setting) {
            return Ok(number);
        }
        return Err(Unreadable::at(sign.to_string(), Why::Inequality).like(Example::OneValue));
    }
    let sides = statement.sides;
    let is_value = |side: &Part| values.has_number(side) && !values.is_name(side);
    let value = sides.iter().rposition(is_value).unwrap_or(sides.len() - 1);
    let mut number = amount(values, &sides[value])?;
    // `print(ω) -> 5`
    let first = values.unbracketed(&sides[0]);
    let first = first.filter(|first| values.is_name(first));
    let (name, beside) = values.unit_beside_name(first.as_ref().unwrap_or(&sides[0]));
    let is_named = values.is_name(&name);
    if number.quantity.unit.is_one()
        && is_named
        && let Some(unit) = beside
    {
        number = number.with_unit(unit);
    }
    let others = sides.iter().enumerate();
    let is_name = |at: usize, side: &Part| at == 0 && is_named || values.is_name(side);
    for (at, side) in others.filter(|(at, side)| *at != value && !is_name(*at, side)) {
        let is_step = 0 < at && at < value;
        let is_between = is_step && is_named;
        let step = values.amount_of_step(side).ok();
        let step = step.as_ref().and_then(TypedNumber::of);
        let step = step.or_else(|| TypedNumber::of_product(values.passage(side)));
        if let Some(agreeing) = step.as_ref().and_then(|step| number.agreeing(step)) {
            number = agreeing;
            continue;
        }
        match step {
            Some(other) if setting.is_in_si(&number, &other) => {}
            Some(other) if are_equal_in_si(&number, &other) => {
                // `121 mm = 0.121` says its unit before.
                if number.quantity.unit.is_one() {
                    number = other;
                }
            }
            Some(other)
                if setting.is_in_letters(values.passage(side), &other)
                    && (is_step || at < value && setting.is_derived(values.passage(side))) => {}
            Some(_) => {
                let (one, other) = (values.passage(side), values.passage(&sides[value]));
                return Err(Why::UnequalSides(one.short(), other.short()).into());
            }
            None if is_between && !values.goes_on_in_words(side) => {}
            None if at < value && setting.is_step_in_letters(values.passage(side)) => {}
            None if number.quantity.value.is_zero() && setting.vanishes(values.passage(side)) => {}
            None => {
                return Err(Unreadable::at(
                    values.passage(side).short(),
                    Why::UnclearSide,
                ));
            }
        }
    }
    Ok(number)
}

/// The value that is compared with a number that is rightly less or greater, `ζ = 0.285 < 1`.
fn rightly_compared(values: &Values<'_>, part: &Part, setting: Setting<'_>) -> Option<TypedNumber> {
    let (value, sign, other) = values.compared(part)?;
    let number = statement(values, &value, setting).ok()?;
    let other = amount(values, &other).ok()?.quantity;
    let own = number.quantity;
    let difference = if other.unit.is_one() {
        own.value.to_f64() - other.value.to_f64()
    } else {
        own.si() - other.si_for(&own.unit).ok()?
    };
    let is_right = if sign == '<' {
        difference < 0.0
    } else {
        difference > 0.0
    };
    is_right.then_some(number)
}

/// The number that a part is.
pub(crate) fn amount(values: &Values<'_>, part: &Part) -> Result<TypedNumber, Unreadable> {
    let typed = values.passage(part);
    let amount = values
        .amount(part)
        .map_err(|error| explained(&error, values, typed))?;
    TypedNumber::of(&amount).ok_or_else(|| Why::NoValue(typed.short()).into())
}

/// Why a number cannot be read.
pub(crate) fn explained(error: &TypedError, values: &Values<'_>, typed: Passage<'_>) -> Unreadable {
    if let Some(word) = typed.counted() {
        return Why::Counted(word.into()).into();
    }
    let place = values.typed(error).short();
    let whole = || String::from(typed);
    match &error.trouble {
        Trouble::Unknown { .. } | Trouble::NotAllowed(_) if !place.is_empty() => {
            Unreadable::at(place, Why::Letters).like(Example::UnitLast)
        }
        Trouble::Value(trouble) => match trouble {
            ValueTrouble::Missing => Unreadable::at(place, Why::Form).like(Example::UnitLast),
            ValueTrouble::Quantity(error) => {
                let unreadable = Unreadable::at(place, Why::Quantity(error.clone()));
                if error.help().is_some() {
                    unreadable
                } else {
                    unreadable.like(Example::Number)
                }
            }
            ValueTrouble::TwoSigns => Why::TwoSigns(typed.short()).into(),
            ValueTrouble::NoExponent => Why::ExponentMissing(whole()).into(),
            ValueTrouble::Range => Why::RangeOrDifference(whole()).into(),
            ValueTrouble::UnitLast | ValueTrouble::UnitOfOne => {
                Unreadable::at(place, Why::UnitNotLast).like(Example::UnitLast)
            }
            ValueTrouble::Bracketed => Unreadable::at(place, Why::BracketAfterNumber),
            ValueTrouble::Units | ValueTrouble::UnitOfArgument => {
                Unreadable::of(Why::TwoUnits).like(Example::UnitLast)
            }
            ValueTrouble::MixedAngles => Why::MixedDegrees.into(),
        },
        _ => Unreadable::typed(error, values.whole()).like(Example::UnitLast),
    }
}

/// The quantity that a response is, by its conventional reading, and what else may be meant.
///
/// # Errors
///
/// As for [`number`].
pub(crate) fn readings(
    response: Passage<'_>,
    mark: DecimalMark,
) -> Result<(Quantity, Vec<Quantity>), Unreadable> {
    let number = number(response, Setting::of(mark))?;
    let others = number.others.iter().map(|other| other.quantity);
    Ok((number.quantity, others.collect()))
}

/// The same for a count, whose steps may be written in these letters, and where a range that descends is a difference.
///
/// # Errors
///
/// As for [`number`].
pub(crate) fn counts(
    response: Passage<'_>,
    mark: DecimalMark,
    steps: (&Unit, &Steps),
) -> Result<(Quantity, Vec<Quantity>), Unreadable> {
    let setting = Setting {
        steps: Some(steps),
        ..Setting::of(mark)
    };
    let read = number(response, setting).or_else(|why| {
        let style = Style {
            mark,
            comma_is_decimal: true,
            is_complex: false,
        };
        let values = Values::read(response, style).ok();
        let difference = values.and_then(|values| values.amount_of_step(&values.all()).ok());
        let difference = difference.as_ref().and_then(TypedNumber::of);
        let descending = difference.filter(|own| own.quantity.value.to_f64() > 0.0);
        descending.ok_or(why)
    })?;
    let others = read.others.iter().map(|other| other.quantity);
    Ok((read.quantity, others.collect()))
}

/// The quantity that a response is without a doubt.
///
/// # Errors
///
/// As for [`number`].
pub(crate) fn quantity(response: Passage<'_>, mark: DecimalMark) -> Result<Quantity, Unreadable> {
    let number = number(response, Setting::of(mark))?;
    match number.question(mark) {
        Some(question) => Err(question),
        None => Ok(number.quantity),
    }
}

/// Whether a side without a unit is the other one in SI units, as `0.0142 = 14.2 mm`.
fn are_equal_in_si(one: &TypedNumber, other: &TypedNumber) -> bool {
    let (a, b) = (&one.quantity.unit, &other.quantity.unit);
    let in_si = |number: &TypedNumber, unit: &Unit| {
        if number.quantity.unit.is_one() {
            number.clone().with_unit(unit.coherent())
        } else {
            number.clone()
        }
    };
    a.is_one() != b.is_one() && are_equal(&in_si(one, b), &in_si(other, a))
}

/// Whether two sides say the same value, whatever each stands for.
pub(crate) fn are_one_value(one: Passage<'_>, other: Passage<'_>, mark: DecimalMark) -> bool {
    let read = |side| number(side, Setting::of(mark)).ok();
    match (read(one), read(other)) {
        (Some(one), Some(other)) => are_equal(&one, &other) || are_equal_in_si(&one, &other),
        _ => false,
    }
}

/// Whether two numbers differ by no more than their rounding.
fn are_equal(one: &TypedNumber, other: &TypedNumber) -> bool {
    // Two values that were each rounded to three figures differ by no more than one percent.
    const SHARE: f64 = 0.01;
    let last_place = |number: &TypedNumber| match &number.arithmetic {
        Some(_) => 0.0,
        None => number.quantity.value.last_place().to_f64(),
    };
    let are_near =
        |a: f64, b: f64, places: f64| (a - b).abs() <= SHARE * a.abs().max(b.abs()) + 0.5 * places;
    let (a, b) = (&one.quantity, &other.quantity);
    let (place, other_place) = (last_place(one), last_place(other));
    let are_bare = a.unit.is_one() || b.unit.is_one();
    are_bare && are_near(a.value.to_f64(), b.value.to_f64(), place.max(other_place))
        || b.conversion(&a.unit).is_ok_and(|conversion| {
            let places = a.unit.to_si(place).max(conversion.apply(other_place));
            are_near(a.si(), conversion.apply_decimal(&b.value), places)
        })
}
