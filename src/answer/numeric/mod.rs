//! `numeric`: a real number with a unit, or a list of numbers.
//!
//! The student types `15.8 rad/s`, `2,52 Hz`, `1.6e-2 m`, `3×10^-4`, or arithmetic with the unit after it,
//! `2*pi rad/s`, `sqrt(2)/2 m`; a list is `0, 180°`.
//! A response is right if its value in the key's unit lies within the tolerance; units count by
//! dimension. A number without a unit is taken in the unit that is printed after the blank.
//! Arithmetic without a unit, `50/(8*484)`, may be meant in SI units: where only these are right, that is a doubt.
//! An angle with `modulo = "360 deg"` is right with any number of turns; where the item asks for one interval,
//! `within = "(-180 deg, 180 deg]"`, an angle outside of it has half the points.
//! A complex number is `3 - 4i ohm`, `-100j ohm`, `5 ohm at -53 deg` or `5∠-53°`; it is right within a distance in the plane.
//! Where the answer is a bound, `bound = "upper"` or `"lower"`, a range that it bounds on this side says it, too: `k <= 251 N/m`.
//! The key is a number or a vector; a vector is a list, marked in any order unless `ordered = true`.
//!
//! ```toml
//! [[part]]
//! kind      = "numeric"
//! key       = "omega_n"
//! unit      = "rad/s"       # of the answer; the quantity's if left out
//! tolerance = "2 %"         # derived if left out
//! ask       = "Find the natural angular frequency."
//! ```

mod bands;
mod complex;
mod list;
mod marker;
mod read;
mod restated;
mod slip;
mod target;
mod trial;
mod words;

use std::sync::Arc;

use super::steps::Steps;
use super::{
    Answer, AnswerError, Asked, Blank, Context, Credit, Declare, Marker, Tolerance, bound, formula,
};
use crate::expr::{Field, Form, Shape, Type};
use crate::quantity::{Absent, NodeId};
use crate::response::{AskedBound, Wording};
use crate::source::{Table, Text};
use crate::unit::{Quantity, Unit};

use self::marker::{Mistake, Numbers};
use self::target::Target;

pub(crate) use self::complex::complex_number;
pub(crate) use self::read::{are_one_value, counts, quantity, readings};

/// Significant figures in which one works at least.
const MIN_FIGURES: u32 = 3;

/// What a part asks for.
#[derive(Debug)]
struct Numeric {
    key: NodeId,
    /// The same as a formula.
    formula: Option<Box<dyn Answer>>,
    unit: Unit,
    tolerance: Tolerance,
    /// The period of a cyclic answer in SI units.
    modulo: Option<f64>,
    /// Where the item asks for a cyclic answer, in SI units.
    within: Option<[f64; 2]>,
    /// The bound that it is.
    bound: Option<AskedBound>,
    is_complex: bool,
    is_list: bool,
    is_ordered: bool,
    /// Whether the key is a number such as 0 or 90°, of which no figures are asked for.
    is_exact: bool,
    ask_digits: Option<u32>,
    digits_penalty: Credit,
    /// Significant figures that are asked for, which the tolerance follows.
    figures: u32,
    /// Significant figures in which the key is printed.
    digits: u32,
    /// What steps may be written in.
    steps: Arc<Steps>,
    /// The words of the question.
    asked: Arc<Wording>,
}

/// Reads the keys of a part that belong to this kind; what is wrong is noted.
pub(crate) fn read(part: &Table<'_>, declare: &mut dyn Declare) -> Option<Box<dyn Answer>> {
    let key_text = part
        .required("key")
        .and_then(|key| part.as_formula("key", key));
    let (unit_text, tolerance, modulo) = (
        part.text("unit"),
        part.text("tolerance"),
        part.text("modulo"),
    );
    let is_ordered = part.boolean("ordered").unwrap_or(false);
    let is_exact = part.boolean("exact").unwrap_or(false);
    let ask_digits = part.integer("ask_digits", "an integer from 1 to 12", 1..=12);
    let penalty = part
        .value("digits_penalty")
        .and_then(|value| part.as_formula("digits_penalty", value));
    let key_text = key_text?;
    let key = declare.formula("key", &key_text)?;
    let unit = unit(key, &key_text, unit_text.as_ref(), declare)?;
    let kind = declare.graph().kind(key)?.clone();
    let is_list = match (kind.field(), kind.shape()) {
        (Field::Real | Field::Complex, Shape::Scalar) => false,
        (Field::Real | Field::Complex, Shape::Vector(_)) => true,
        _ => {
            let found = kind.form().to_string();
            declare.find(
                &AnswerError::KeyForm {
                    expected: "a number or a list of them",
                    found,
                },
                &key_text,
            );
            return None;
        }
    };
    let tolerance = match tolerance {
        Some(text) => Tolerance::read(&text, &unit, declare)?,
        None => Tolerance::default(),
    };
    let modulo = match modulo {
        Some(text) => Some(period(&text, &unit, declare)?),
        None => None,
    };
    let within = match part.text("within") {
        None => None,
        Some(text) => Some(interval(&text, modulo.is_some(), &unit, declare)?),
    };
    let digits_penalty = penalty
        .and_then(|text| Credit::read(&text.value))
        .unwrap_or(Credit::NONE);
    let asked = part.text("ask").map(|ask| Wording::of_question(&ask.value));
    let is_real = kind.field() == Field::Real && !is_list;
    let bound = if is_real {
        bound::read(part, declare)
    } else {
        None
    };
    let formula = if is_real {
        formula::of_key(part, &key_text, key, declare)
    } else {
        None
    };
    Some(Box::new(Numeric {
        key,
        formula: formula.map(|formula| Box::new(formula) as Box<dyn Answer>),
        unit,
        tolerance,
        modulo,
        within,
        bound,
        is_complex: kind.field() == Field::Complex,
        is_list,
        is_ordered,
        is_exact,
        ask_digits: ask_digits.map(|digits| digits as u32),
        digits_penalty,
        figures: ask_digits.map_or(u32::from(declare.figures()), |digits| digits as u32),
        // What is asked for in more figures is printed in them.
        digits: u32::from(declare.digits_of(key)).max(ask_digits.map_or(0, |digits| digits as u32)),
        steps: Arc::new(Steps::of(declare, key)),
        asked: Arc::new(asked.unwrap_or_default()),
    }))
}

/// What asks for the value of a formula that does not move with time, in the unit of its quantity.
pub(crate) fn of_formula(
    key: NodeId,
    kind: &Type,
    declare: &dyn Declare,
) -> Option<Box<dyn Answer>> {
    let is_pure = kind.dimension().is_none_or(|dimension| dimension.is_pure());
    let unit = declare.unit_of(key).or(is_pure.then_some(Unit::ONE))?;
    let numeric = Numeric {
        key,
        unit,
        tolerance: Tolerance::default(),
        figures: u32::from(declare.figures()),
        digits: u32::from(declare.digits_of(key)),
        steps: Arc::new(Steps::of(declare, key)),
        asked: Arc::default(),
        formula: None,
        modulo: None,
        within: None,
        bound: None,
        is_complex: false,
        is_list: false,
        is_ordered: false,
        is_exact: false,
        ask_digits: None,
        digits_penalty: Credit::NONE,
    };
    (kind.form() == Form::REAL).then(|| Box::new(numeric) as Box<dyn Answer>)
}

/// The unit of the answer: stated, or that of the quantity, or none for a pure number.
pub(crate) fn unit(
    key: NodeId,
    text: &Text,
    stated: Option<&Text>,
    declare: &mut dyn Declare,
) -> Option<Unit> {
    let dimension = declare.graph().kind(key)?.dimension();
    let unit = match stated {
        Some(stated) => declare.unit(stated)?,
        None => match declare.unit_of(key) {
            Some(unit) => unit,
            None if dimension.is_none_or(|dimension| dimension.is_pure()) => Unit::ONE,
            None => {
                declare.find(&AnswerError::NoUnit, text);
                return None;
            }
        },
    };
    if let Some(dimension) = dimension.filter(|dimension| *dimension != unit.dimension()) {
        let (expected, found) = (dimension.describe(), unit.dimension().describe());
        declare.find(
            &AnswerError::Unit { expected, found },
            stated.unwrap_or(text),
        );
        return None;
    }
    Some(unit)
}

/// Where a cyclic answer is asked, `(-180 deg, 180 deg]`. An answer has a tolerance, so that either end counts.
fn interval(
    text: &Text,
    is_cyclic: bool,
    unit: &Unit,
    declare: &mut dyn Declare,
) -> Option<[f64; 2]> {
    let bare = text.value.trim().strip_prefix(['(', '[']);
    let bare = bare.and_then(|bare| bare.strip_suffix([')', ']']));
    let si = |end: &str| Quantity::parse(end.trim()).ok()?.si_for(unit).ok();
    let ends = bare.and_then(|bare| bare.split_once(','));
    let ends = ends.and_then(|(low, high)| Some([si(low)?, si(high)?]));
    let ends = ends.filter(|[low, high]| low < high && is_cyclic);
    if ends.is_none() {
        declare.find(&AnswerError::Within(text.value.clone()), text);
    }
    ends
}

fn period(text: &Text, unit: &Unit, declare: &mut dyn Declare) -> Option<f64> {
    let period = Quantity::parse(&text.value).ok();
    let si = period
        .and_then(|period| period.si_for(unit).ok())
        .filter(|si| *si > 0.0);
    if si.is_none() {
        let span = crate::source::Span::new(0, text.value.len());
        declare.find(
            &AnswerError::Tolerance {
                found: text.value.clone(),
                span,
            },
            text,
        );
    }
    si
}

impl Answer for Numeric {
    fn kind(&self) -> crate::answer::AnswerKind {
        crate::answer::AnswerKind::Numeric
    }

    fn blank(&self) -> Blank {
        let form = match (self.is_list, self.is_complex) {
            (true, _) => Asked::Values {
                is_ordered: self.is_ordered,
            },
            (false, true) => Asked::ComplexValue,
            (false, false) => Asked::Value,
        };
        let blank = Blank::of(form).with_numbers(Some(self.unit), self.figures);
        if self.is_exact {
            blank.without_figures()
        } else {
            blank
        }
    }

    fn keys(&self) -> Vec<NodeId> {
        vec![self.key]
    }

    fn unit(&self) -> Option<Unit> {
        Some(self.unit).filter(|unit| !unit.is_one())
    }

    fn bound(&self) -> Option<AskedBound> {
        self.bound
    }

    fn other_form(&self) -> Option<&dyn Answer> {
        self.formula.as_deref()
    }

    fn figures(&self) -> u32 {
        self.figures
    }

    fn states_tolerance(&self) -> bool {
        !self.tolerance.is_derived()
    }

    fn prepare<'t>(&self, context: &Context<'t>) -> Result<Box<dyn Marker + 't>, Absent> {
        let evaluation = &*context.evaluation;
        let key = evaluation.value(self.key)?;
        if key.form().field == Field::Complex {
            return Ok(Box::new(self.complex(key, context)));
        }
        let spreads = std::cell::OnceCell::new();
        let targets: Vec<Target> = key
            .numbers()
            .iter()
            .zip(key.bounds())
            .enumerate()
            .map(|(entry, (&value, &bound))| {
                let spread = || spreads.get_or_init(|| evaluation.spread(self.key))[entry];
                Target {
                    value,
                    bound,
                    half: self.half_width(value, spread, evaluation),
                }
            })
            .collect();
        let mistakes = context.mistakes.iter().map(Mistake::of).collect();
        Ok(Box::new(Numbers {
            unit: self.unit,
            modulo: self.modulo,
            within: self.within,
            is_list: self.is_list,
            is_ordered: self.is_ordered,
            figures: self.figures,
            ask_digits: self.ask_digits,
            digits_penalty: self.digits_penalty,
            digits: self.digits,
            mark: context.mark,
            steps: Arc::clone(&self.steps),
            asked: Arc::clone(&self.asked),
            doubt: context.doubt,
            targets,
            mistakes,
        }))
    }
}

impl Numeric {
    /// How far from a key a number may be: what is stated, or what follows from the figures that are asked for; never
    /// less than rounding to these figures takes.
    fn half_width(
        &self,
        value: f64,
        spread: impl FnOnce() -> f64,
        evaluation: &crate::quantity::Evaluation<'_>,
    ) -> f64 {
        // Nobody works in fewer figures than three to give an answer in two.
        let figures = self.figures.max(MIN_FIGURES);
        let half = self
            .tolerance
            .half_width(value, spread, figures, evaluation);
        // The key is printed in its own figures, and is right as it is printed.
        let shown = self.unit.of_si(value);
        let share = super::tolerance::half_unit(shown, self.figures.min(self.digits)) / shown.abs();
        if share.is_finite() {
            half.max(share * value.abs())
        } else {
            half
        }
    }

    /// The marker of complex keys: the tolerance is a distance in the plane.
    fn complex(&self, key: &crate::expr::Value, context: &Context<'_>) -> complex::ComplexNumbers {
        let evaluation = &*context.evaluation;
        let spreads = std::cell::OnceCell::new();
        let target = |entry: usize| {
            let value = key.entry(entry);
            let spread = || {
                let all = spreads.get_or_init(|| evaluation.spread(self.key));
                crate::numerics::hypot(all[2 * entry], all[2 * entry + 1])
            };
            let size = value.abs();
            complex::Target {
                value,
                bound: key.bounds()[2 * entry] + key.bounds()[2 * entry + 1],
                half: self.half_width(size, spread, evaluation),
            }
        };
        complex::ComplexNumbers {
            unit: self.unit,
            form: key.form(),
            digits: self.digits,
            mark: context.mark,
            steps: self.steps.clone(),
            doubt: context.doubt,
            targets: (0..key.shape().len()).map(target).collect(),
            mistakes: context.mistakes.clone(),
            is_list: self.is_list,
            is_ordered: self.is_ordered,
        }
    }
}
