//! Marks numbers: right, a named mistake, or a slip that can be diagnosed from the number alone.

use std::sync::Arc;

use super::bands::bands;
use super::list::{List, list, mark_list};
use super::read::{self, Setting, TypedNumber};
use super::slip::{mixes_energy_and_moment, rounded_too_far, slip};
use super::target::{Target, Typed, pair};
use super::trial;
use super::words::{angles, counts, gram, meant};
use crate::answer::settle::{Candidate, Rule, settle};
use crate::answer::steps::Steps;
use crate::answer::{
    Answered, Band, Credit, Doubt, Echo, Key, KeyValue, Marker, Marking, Misfit, Mistaken, Note,
    Reading, Remark, Slip, Trial, Unreadable, Why,
};
use crate::expr::{Constant, Expr, Form, Function, Kind, Operator, Shape};
use crate::math::Math;
use crate::numerics::Dd;
use crate::response::{Passage, Wording, has_pi};
use crate::unit::{Decimal, DecimalMark, Dimension, DimensionMismatch, Quantity, Unit};

/// What a named mistake gives, in SI units.
#[derive(Clone, Debug)]
pub(crate) struct Mistake {
    pub(crate) number: usize,
    pub(crate) values: Vec<f64>,
    pub(crate) unit: Option<Unit>,
    pub(crate) credit: Credit,
}

/// Numbers that differ by a smaller share are the same but for rounding in the machine.
const SAME: f64 = 1e-9;

/// A prepared key.
pub(crate) struct Numbers {
    pub(crate) unit: Unit,
    pub(crate) modulo: Option<f64>,
    /// Where a cyclic answer is asked.
    pub(crate) within: Option<[f64; 2]>,
    pub(crate) is_list: bool,
    pub(crate) is_ordered: bool,
    /// Significant figures that the line for the answer asks for.
    pub(crate) figures: u32,
    pub(crate) ask_digits: Option<u32>,
    pub(crate) digits_penalty: Credit,
    pub(crate) digits: u32,
    pub(crate) mark: DecimalMark,
    /// What steps may be written in.
    pub(crate) steps: Arc<Steps>,
    /// The words of the question.
    pub(crate) asked: Arc<Wording>,
    pub(crate) doubt: Doubt,
    pub(crate) targets: Vec<Target>,
    pub(crate) mistakes: Vec<Mistake>,
}

impl Mistake {
    pub(crate) fn of(mistaken: &Mistaken) -> Self {
        let values = mistaken
            .values
            .iter()
            .flat_map(|value| value.numbers().iter().copied())
            .collect();
        Self {
            number: mistaken.number,
            values,
            unit: mistaken.unit,
            credit: mistaken.credit,
        }
    }
}

impl Numbers {
    fn setting(&self) -> Setting<'_> {
        Setting {
            mark: self.mark,
            steps: Some((&self.unit, &self.steps)),
            asked: Some(&self.asked),
        }
    }

    /// Distance of the nearest mistake that is another number than the key.
    fn nearest_mistake(&self) -> Option<f64> {
        let [target] = &self.targets[..] else {
            return None;
        };
        let others = self
            .mistakes
            .iter()
            .filter(|mistake| mistake.unit.is_none() && mistake.credit < Credit::FULL);
        let distances = others.filter_map(|mistake| {
            Some(target.distance(Dd::from(*mistake.values.first()?), self.modulo))
        });
        distances
            .filter(|distance| *distance > SAME * target.value.abs())
            .min_by(f64::total_cmp)
    }

    fn mark_one(&self, number: &TypedNumber) -> Marking {
        let (target, quantity) = (&self.targets[0], &number.quantity);
        let Ok(typed) = self.si(quantity) else {
            return self.wrong_dimension(number);
        };
        if let Some(why) = self
            .absurd(typed)
            .or_else(|| counts(&quantity.unit, &self.unit))
            .or_else(|| angles(&quantity.unit, &self.unit))
        {
            return Marking::unreadable(why);
        }
        let reading = Self::reading(std::slice::from_ref(number), &[typed.hi()], self.mark);
        if target.accepts(typed, self.modulo) {
            return match self.outside(target, typed) {
                Some(slip) => Marking::read(reading, Credit::half(), Remark::from(slip)),
                None => self.right(reading, number),
            };
        }
        // Before the slips that are diagnosed: an author knows better what a number comes from.
        if let Some(marking) = self.mistake(&reading, std::slice::from_ref(number), &[typed]) {
            return marking;
        }
        if self.doubt != Doubt::Benefit
            && let Some(why) = rounded_too_far(self, typed, number)
        {
            return Marking::unreadable(why);
        }
        let slip = slip(self, &[typed], &quantity.unit);
        Marking::wrong(reading, slip.map(Remark::from))
    }

    /// What is said of an angle that is right but for whole turns, where it is asked within an interval.
    fn outside(&self, target: &Target, typed: Typed) -> Option<Slip> {
        let ends = self.within?;
        let slack = target.half + target.slack();
        let is_inside = ends[0] - slack <= typed.hi() && typed.hi() <= ends[1] + slack;
        // Half a turn is π, which no decimal is: ends that are whole degrees are given so.
        let degree = Unit::degree();
        let mut degrees = ends.iter().map(|si| degree.of_si(*si));
        let are_whole = degrees.all(|own| (own - own.round()).abs() < 1e-9);
        let unit = if are_whole { degree } else { self.unit };
        let [low, high] = ends.map(|si| {
            let rounded = Decimal::rounded(unit.of_si(si), 4)?;
            Some(Quantity::new(Decimal::shortest(rounded.to_f64())?, unit))
        });
        (!is_inside).then_some(Slip::OutsideInterval(Box::new([low?, high?])))
    }

    /// The value in SI units; a number without a unit is taken in the unit that is asked for.
    pub(crate) fn si(&self, quantity: &Quantity) -> Result<Typed, DimensionMismatch> {
        let taken = if quantity.unit.is_one() {
            Quantity::new(quantity.value, self.unit)
        } else {
            *quantity
        };
        let (high, low) = taken.conversion(&self.unit)?.apply_pair(&taken.value);
        // To thirty digits: the ends of a tolerance are decided on the decimals that were typed.
        Ok(Dd::sum(high, low))
    }

    /// What is said of an angle that nobody means: so many turns that what is left of it tells nothing.
    pub(crate) fn absurd(&self, typed: Typed) -> Option<Why> {
        // A whole turn in degrees that is read as radians, 360 rad, is 57 turns: such a slip is marked, not
        // refused.
        const MAX_TURNS: u32 = 100;
        let period = self.modulo?;
        let turn = Quantity::new(Decimal::rounded(self.unit.of_si(period), 4)?, self.unit);
        let times = MAX_TURNS;
        (typed.hi().abs() > f64::from(times) * period).then_some(Why::TooManyTurns { times, turn })
    }

    fn right(&self, reading: Reading, number: &TypedNumber) -> Marking {
        let quantity = &number.quantity;
        let mut marking = Marking::right(reading);
        if let Some(asked) = self
            .ask_digits
            .filter(|asked| quantity.value.significant_figures() != *asked)
        {
            marking.credit = Credit::FULL.minus(self.digits_penalty);
            marking.verdict = marking.credit.verdict();
            let figures = quantity.value.significant_figures();
            let typed = match &number.arithmetic {
                Some(_) => None,
                None => Some((quantity.value.to_string(), figures)),
            };
            marking.remarks.push(Note::Figures { asked, typed }.into());
        }
        if quantity.unit.is_one() && !self.unit.is_one() {
            marking.say_taken(&self.unit);
        } else if mixes_energy_and_moment(&quantity.unit, &self.unit) {
            marking.remarks.push(Note::JouleForMoment(self.unit).into());
        }
        marking
    }

    /// The named mistake that a response equals, if any; one in another unit is recognized by its numbers alone.
    pub(crate) fn mistake(
        &self,
        reading: &Reading,
        items: &[TypedNumber],
        typed: &[Typed],
    ) -> Option<Marking> {
        let found = self.mistakes.iter().find(|mistake| match mistake.unit {
            None => self.equals(mistake, typed),
            Some(unit) => {
                let mut units = items.iter().map(|item| item.quantity.unit);
                let numbers = items
                    .iter()
                    .map(|item| Dd::from(Quantity::new(item.quantity.value, unit).si()));
                units.all(|own| own.is_one() || own == self.unit)
                    && self.equals(mistake, &numbers.collect::<Vec<Typed>>())
            }
        })?;
        Some(Marking::mistake(
            reading.clone(),
            found.number,
            found.credit,
        ))
    }

    fn equals(&self, mistake: &Mistake, typed: &[Typed]) -> bool {
        let targets = mistake.values.iter().map(|value| self.of_mistake(*value));
        let targets: Vec<Target> = targets.collect();
        targets.len() == typed.len()
            && pair(&targets, typed, self.modulo, self.is_ordered) == typed.len()
    }

    /// What counts as a mistaken value: it may be off by the same share as the key.
    pub(crate) fn of_mistake(&self, value: f64) -> Target {
        let relative = self
            .targets
            .iter()
            .map(|target| target.half / target.value.abs())
            .fold(0.0, f64::max);
        let half = if relative.is_finite() {
            relative * value.abs()
        } else {
            0.0
        };
        Target {
            value,
            bound: 0.0,
            half: if half > 0.0 {
                half
            } else {
                self.targets[0].half
            },
        }
    }

    pub(crate) fn wrong_dimension(&self, number: &TypedNumber) -> Marking {
        let quantity = &number.quantity;
        let si = quantity.si();
        let reading = Self::reading(std::slice::from_ref(number), &[si], self.mark);
        let named = self.mistakes.iter().find(|mistake| {
            let unit = mistake
                .unit
                .filter(|unit| unit.dimension() == quantity.unit.dimension());
            unit.is_some() && self.equals(mistake, &[Dd::from(si)])
        });
        if let Some(found) = named {
            return Marking::mistake(reading, found.number, found.credit);
        }
        if let Some(why) = gram(&quantity.unit, &self.unit) {
            return Marking::unreadable(why);
        }
        let misfit = Misfit::Unit {
            typed: quantity.unit,
            asked: self.unit,
        };
        Marking::wrong(reading, Remark::from(misfit))
    }

    /// The marking of numbers that may be meant otherwise.
    fn settled(
        &self,
        items: &[TypedNumber],
        other: Option<&[TypedNumber]>,
        mark: impl Fn(&[TypedNumber]) -> Marking,
    ) -> Marking {
        let first = mark(items);
        let Some(other) = other else {
            return first;
        };
        let candidate = |items: &[TypedNumber], marking| Candidate {
            shown: Self::reading(items, &[], self.mark).math.plain(),
            marking,
        };
        let others = vec![candidate(other, mark(other))];
        // Not so of another unit, as that of hertz after 2π; a bare number is in the unit that is asked.
        let are_by_rule = items.iter().zip(other).all(|(own, other)| {
            let (own_unit, other_unit) = (own.quantity.unit, other.quantity.unit);
            own.others.is_empty()
                || own.is_by_rule && own_unit == other_unit
                || own_unit.is_one() && !other_unit.is_one() && !self.vanishes()
        });
        let rule = if are_by_rule {
            Rule::Stated
        } else {
            Rule::None
        };
        settle(self.doubt, rule, candidate(items, first), others)
    }

    /// A number as it is meant where this is asked: the one reading that has the dimension; radians for its unit, where
    /// degrees are asked and it has none, but π in it, and perhaps those in which its π counts cycles; arithmetic without a
    /// unit may be in SI units.
    fn meant(&self, mut number: TypedNumber) -> TypedNumber {
        let fits = |number: &TypedNumber| self.si(&number.quantity).is_ok();
        if !fits(&number)
            && let Some(at) = number.others.iter().position(fits)
        {
            number = number.others.swap_remove(at);
        } else if fits(&number) {
            number.others.retain(fits);
        } else if let Some(unit) = meant(&number.quantity.unit, &self.unit) {
            number.quantity.unit = unit;
        }
        if number.quantity.unit.is_one() && self.unit == Unit::degree() {
            let arithmetic = number.arithmetic.as_ref();
            if arithmetic.is_some_and(has_pi) {
                number.quantity.unit = Unit::radian();
            } else if let Some(turned) = arithmetic.and_then(in_degrees) {
                number = turned;
            }
        }
        // Of `2π · 2 Hz` people mean the angular frequency of two cycles a second.
        let is_angular = self.unit.has_factor("rad") && self.unit.to_si(1.0) == 1.0;
        if is_angular && self.unit.dimension() == Dimension::TIME.inverse() {
            number.others.extend(number.in_radians());
        }
        let coherent = self.unit.coherent();
        let is_scaled = coherent.to_si(1.0) != self.unit.to_si(1.0);
        if is_scaled && number.quantity.unit.is_one() && number.arithmetic.is_some() {
            let bare = number.alone();
            number.others.push(bare.with_unit(coherent));
        }
        number
    }

    /// Whether the key is nothing, so that one tolerance for all that is near says nothing of the unit.
    fn vanishes(&self) -> bool {
        self.targets.iter().all(|target| target.value == 0.0)
    }

    /// A number as it is marked: where the key is nothing, a bare one is near it in the unit that is asked, though it may
    /// be far off in SI units, `0.06` of metres for millimetres.
    fn doubted(&self, mut number: TypedNumber) -> TypedNumber {
        let coherent = self.unit.coherent();
        let is_bare = number.quantity.unit.is_one() && !number.quantity.value.is_zero();
        let is_scaled = coherent.to_si(1.0) != self.unit.to_si(1.0);
        if self.vanishes() && is_bare && is_scaled && number.others.is_empty() {
            number.others.push(number.alone().with_unit(coherent));
        }
        number
    }

    /// How numbers with units were read.
    pub(crate) fn reading(items: &[TypedNumber], si: &[f64], mark: DecimalMark) -> Reading {
        let math = match items {
            [one] => one.math(mark),
            many => listed(many.iter().map(|item| item.math(mark))),
        };
        let text = items
            .iter()
            .map(TypedNumber::text)
            .collect::<Vec<_>>()
            .join(", ");
        let answered = match (items, si) {
            ([item], [si]) => Answered::Number {
                si: *si,
                unit: Some(item.quantity.unit).filter(|unit| !unit.is_one()),
            },
            _ => Answered::List(si.to_vec()),
        };
        Reading {
            math,
            text,
            answered,
        }
    }

    /// A number in the unit of the answer, as a key prints it.
    fn printed(&self, si: f64, figures: u32) -> Math {
        Key::rounded(self.unit.of_si(si), figures, self.unit, self.mark)
    }
}

impl Marker for Numbers {
    fn number(&self) -> Option<f64> {
        match &self.targets[..] {
            [target] => Some(target.value),
            _ => None,
        }
    }

    fn key(&self) -> Key {
        let numbers: Vec<f64> = self.targets.iter().map(|target| target.value).collect();
        let math = match &numbers[..] {
            [one] if !self.is_list => self.printed(*one, self.digits),
            many => listed(many.iter().map(|number| self.printed(*number, self.digits))),
        };
        let accepted = match &self.targets[..] {
            [target] if target.half > 0.0 => Some(Math::row([
                self.printed(target.value - target.half, self.digits + 1),
                Math::text(" to "),
                self.printed(target.value + target.half, self.digits + 1),
            ])),
            _ => None,
        };
        let shape = if self.is_list {
            Shape::Vector(numbers.len())
        } else {
            Shape::Scalar
        };
        Key {
            math,
            accepted,
            value: KeyValue::Numbers {
                form: Form::real(shape),
                si: numbers,
            },
        }
    }

    fn echo(&self, response: Passage<'_>) -> Result<Echo, Unreadable> {
        let items = if self.is_list {
            list(
                response,
                self.targets.len(),
                self.is_ordered,
                self.setting(),
            )?
            .items
        } else {
            vec![read::number(response, self.setting())?]
        };
        let items: Vec<TypedNumber> = items.into_iter().map(|item| self.meant(item)).collect();
        let otherwise: Vec<TypedNumber> = items.iter().map(TypedNumber::otherwise).collect();
        let readings = [items, otherwise].map(|items| Self::reading(&items, &[], self.mark));
        Echo::of(readings).ok_or_else(|| Why::Form.into())
    }

    fn mark(&self, response: Passage<'_>) -> Marking {
        if self.is_list {
            return match list(
                response,
                self.targets.len(),
                self.is_ordered,
                self.setting(),
            ) {
                Ok(List {
                    items,
                    are_about_mean,
                }) => {
                    let items: Vec<TypedNumber> =
                        items.into_iter().map(|item| self.meant(item)).collect();
                    let is_ordered = self.is_ordered && !are_about_mean;
                    // One convention holds for the whole list.
                    let otherwise: Vec<TypedNumber> =
                        items.iter().map(TypedNumber::otherwise).collect();
                    let is_doubtful = items.iter().any(|item| !item.others.is_empty());
                    let other = is_doubtful.then_some(&otherwise[..]);
                    self.settled(&items, other, |items| mark_list(self, items, is_ordered))
                }
                Err(why) => Marking::unreadable(why),
            };
        }
        match read::number(response, self.setting()) {
            Ok(number) => {
                let number = self.doubted(self.meant(number));
                let other = number.otherwise();
                let other = (!number.others.is_empty()).then_some(std::slice::from_ref(&other));
                self.settled(std::slice::from_ref(&number), other, |items| {
                    self.mark_one(&items[0])
                })
            }
            Err(help) => Marking::unreadable(help),
        }
    }

    fn trials(&self) -> Vec<Trial> {
        trial::of_numbers(self)
    }

    fn clearance(&self, limit: f64) -> Option<f64> {
        let distance = self.nearest_mistake()?;
        let half = self.targets.first()?.half;
        Some(distance / half).filter(|clearance| half > 0.0 && *clearance < limit)
    }

    fn distance(&self, si: &[f64]) -> Option<f64> {
        if si.len() != self.targets.len() {
            return None;
        }
        let mut targets: Vec<&Target> = self.targets.iter().collect();
        let mut numbers = si.to_vec();
        if !self.is_ordered {
            crate::numerics::sort_by(&mut targets, |a, b| a.value.total_cmp(&b.value));
            crate::numerics::sort_by(&mut numbers, f64::total_cmp);
        }
        let pairs = targets.iter().zip(numbers);
        let distances = pairs.map(|(target, number)| {
            let distance = target.distance(Dd::from(number), self.modulo);
            if distance == 0.0 {
                0.0
            } else {
                distance / target.half
            }
        });
        Some(distances.fold(0.0, f64::max))
    }

    fn is_mistaken_key(&self) -> bool {
        let [target] = &self.targets[..] else {
            return false;
        };
        let mut others = self
            .mistakes
            .iter()
            .filter(|mistake| mistake.unit.is_none() && mistake.credit < Credit::FULL);
        others.any(|mistake| {
            let given = mistake.values.first();
            given.is_some_and(|given| {
                target.distance(Dd::from(*given), self.modulo) <= SAME * target.value.abs()
            })
        })
    }

    fn is_uncertain(&self) -> bool {
        /// Part of a tolerance that the key may be off by before answers are marked by its rounding.
        const NOTICEABLE: f64 = 0.25;
        let mut targets = self.targets.iter();
        targets.any(|target| target.half > 0.0 && target.bound > NOTICEABLE * target.half)
    }

    fn bands(&self) -> Vec<Vec<Band>> {
        bands(self)
    }

    fn half_widths(&self) -> Vec<f64> {
        self.targets.iter().map(|target| target.half).collect()
    }
}

/// Arithmetic in which angles of arcs are terms, `180 - atan(2)`, with these in degrees as the numbers beside them are.
fn in_degrees(arithmetic: &Expr) -> Option<TypedNumber> {
    fn turned(expr: &Expr) -> Option<Expr> {
        use Function::{Acos, Asin, Atan, Atan2};
        Some(match expr.kind() {
            Kind::Call(Asin | Acos | Atan | Atan2, _) => {
                expr.clone() * Expr::number(180) / Expr::constant(Constant::Pi)
            }
            Kind::Negate(inner) => -turned(inner)?,
            Kind::Binary(Operator::Add, left, right) => {
                either(left, right, |left, right| left + right)?
            }
            Kind::Binary(Operator::Subtract, left, right) => {
                either(left, right, |left, right| left - right)?
            }
            _ => return None,
        })
    }
    fn either(left: &Expr, right: &Expr, join: impl Fn(Expr, Expr) -> Expr) -> Option<Expr> {
        match (turned(left), turned(right)) {
            (None, None) => None,
            (own, other) => Some(join(
                own.unwrap_or_else(|| left.clone()),
                other.unwrap_or_else(|| right.clone()),
            )),
        }
    }
    TypedNumber::of_formula(turned(arithmetic)?, Unit::degree())
}

/// Values side by side with commas.
fn listed(items: impl Iterator<Item = Math>) -> Math {
    let mut row = Vec::new();
    for item in items {
        if !row.is_empty() {
            row.push(Math::punctuation(";"));
        }
        row.push(item);
    }
    Math::row(row)
}
