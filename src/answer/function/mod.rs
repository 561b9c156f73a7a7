//! `function`: a function of time, or of another variable, over a span.
//!
//! The student types `0.632 exp(-0.0125 t) sin(15.8 t)` or the same with symbols, in any form: sines or
//! cosines, any sign convention, phases in radians. Both functions are compared over the span, which is
//! three periods unless stated; the tolerance is a share of the largest value. Where none is stated, each
//! time has its own, from rounding every intermediate result to the working figures:
//!
//! ```text
//! half-width(t) = 0.005 · 10^(3−s) · ( max|x| + Σ |z ∂x/∂z|(t) )     over the steps z between data and answer.
//! ```
//!
//! ```toml
//! [[part]]
//! kind      = "function"
//! key       = "x"
//! span      = ["0", "6*pi/omega_n"]
//! tolerance = "2 %"             # of the largest value; derived if left out
//! ask       = "Find $x(t)$."
//! ```
//!
//! With `constants`, the general solution of a model's equations is asked. The student names the constants
//! (`A`, `B1`, `phi2`, …) and gives one function for each of the `components`, `x1 = …; x2 = …`. It is right
//! when it satisfies the equations for all constants and can meet any initial state.
//!
//! ```toml
//! [[part]]
//! kind       = "function"
//! id         = "general"
//! key        = "model.general_motion"
//! components = ["x1", "x2"]
//! constants  = 4
//! ask        = "Find the general solution."
//! ```

mod general;

use std::collections::BTreeMap;
use std::sync::{Arc, OnceLock};

use super::meaning::{Meaning, ORDERS, Prefer, lexicon};
use super::trial::typed as typed_number;
use super::typed::{self, Lexicon, Manner, Typed};
use super::{
    Answer, AnswerError, AnswerKind, Context, Credit, Declare, Feedback, Key, Marker, Marking,
    Nature, Reading, Reason, Tolerance, Trial, Verdict, symbolic,
};
use crate::expr::{Expr, Form, Name, Path, Precise, Type, Value as Number, Workspace};
use crate::math::Math;
use crate::quantity::{Absent, Evaluation, Function as Curve, NodeId};
use crate::source::{Table, Text, Value};
use crate::unit::{Dimension, Unit};

/// The kind.
pub(super) struct Kind;

/// Times at which functions are compared.
const SAMPLES: usize = 48;

#[derive(Debug)]
struct Motion {
    key: NodeId,
    span: Extent,
    tolerance: Tolerance,
    digits: u32,
    setup: Arc<Setup>,
}

/// Where functions are compared.
#[derive(Clone, Copy, Debug)]
enum Extent {
    /// Between these.
    Stated([NodeId; 2]),
    /// From 0 to three periods of the slowest of these angular frequencies.
    Periods(NodeId),
}

#[derive(Debug)]
struct Setup {
    shown: Expr,
    kind: Type,
    unit: Option<Unit>,
    variable: Name,
    meaning: Meaning,
    lexicon: Lexicon,
    /// As it is printed, once it was.
    printed: OnceLock<Key>,
}

impl Setup {
    /// The key as it is printed: the same for all data.
    fn printed(&self) -> Key {
        let print = || Key::formula(self.shown.to_string(), self.shown.typeset(&self.lexicon));
        self.printed.get_or_init(print).clone()
    }
}

struct Prepared {
    setup: Arc<Setup>,
    times: Vec<Precise>,
    values: Vec<f64>,
    halves: Vec<f64>,
    mistakes: Vec<(usize, Vec<f64>, Credit)>,
    data: Vec<Precise>,
}

impl AnswerKind for Kind {
    fn name(&self) -> &'static str {
        "function"
    }

    fn minutes(&self) -> u32 {
        6
    }

    fn read(&self, part: &Table<'_>, declare: &mut dyn Declare) -> Option<Box<dyn Answer>> {
        let text = part
            .required("key")
            .and_then(|key| part.as_formula("key", key));
        let span = part.value("span").map(|value| spans(part, value));
        let (variable, tolerance) = (part.text("variable"), part.text("tolerance"));
        let (listed, components) = (part.texts("in"), part.texts("components"));
        let constants = part.integer("constants", "the number of free constants", 0..=20);
        let text = text?;
        if constants.is_some_and(|count| count > 0) {
            return general::read(&text, &components, &listed, declare);
        }
        let key = declare.formula("key", &text)?;
        let kind = declare.graph().kind(key)?.clone();
        let variable = Name::new(variable.map_or("t".to_owned(), |text| text.value));
        let of = declare.graph().variables(key);
        if kind.form() != Form::REAL || of.iter().any(|name| *name != variable) {
            let found = kind.form().to_string();
            declare.find(
                &AnswerError::KeyForm {
                    expected: "a function of one variable",
                    found,
                },
                &text,
            );
            return None;
        }
        let unit = declare.unit_of(key);
        let tolerance = match tolerance {
            Some(text) => Tolerance::read(&text, &unit.unwrap_or(Unit::ONE), declare)?,
            None => Tolerance::default(),
        };
        let span = match &span {
            Some(span) => {
                let [from, to] = &span[..] else {
                    return None;
                };
                Extent::Stated([declare.formula("span", from)?, declare.formula("span", to)?])
            }
            None => Extent::of_model(&text, declare)?,
        };
        let own = Name::new(text.value.as_str());
        let named = declare.graph().find(&own).map(|_| own);
        let (mut lexicon, mut names) = lexicon(declare, &listed, named.as_ref());
        lexicon.allow(&variable, &crate::math::symbol(variable.as_str()), false);
        names.push(variable.clone());
        let meaning = Meaning::of(declare, Prefer::Quantities);
        let shown = meaning.expanded(&symbolic::formula(declare.graph(), key), &names);
        Some(Box::new(Motion {
            key,
            span,
            tolerance,
            digits: u32::from(declare.digits_of(key)),
            setup: Arc::new(Setup {
                shown,
                kind,
                unit,
                variable,
                meaning,
                lexicon,
                printed: OnceLock::new(),
            }),
        }))
    }
}

impl Extent {
    /// Three periods of the item's model; without one the span has to be stated.
    fn of_model(key: &Text, declare: &mut dyn Declare) -> Option<Self> {
        for quantity in ["natural_angular_frequency", "natural_angular_frequencies"] {
            let path = Path::new([Name::new("model"), Name::new(quantity)]);
            if declare.graph().offered(&path).is_some() {
                let text = Text {
                    value: path.to_string(),
                    span: key.span,
                };
                return declare.formula("span", &text).map(Self::Periods);
            }
        }
        let (expected, found) = ("a function with a `span`", "one without".to_owned());
        declare.find(&AnswerError::KeyForm { expected, found }, key);
        None
    }

    fn ends(self, evaluation: &Evaluation<'_>) -> Result<[f64; 2], Absent> {
        const PERIODS: f64 = 3.0;
        match self {
            Self::Stated([from, to]) => Ok([evaluation.real(from)?, evaluation.real(to)?]),
            Self::Periods(node) => {
                let frequencies = evaluation.value(node)?.numbers();
                let slowest = frequencies.iter().copied().filter(|own| *own > 0.0);
                let slowest = slowest.fold(f64::INFINITY, f64::min);
                // Without a restoring force there is no period; a second will do.
                let end = if slowest.is_finite() {
                    PERIODS * std::f64::consts::TAU / slowest
                } else {
                    1.0
                };
                Ok([0.0, end])
            }
        }
    }
}

fn spans(part: &Table<'_>, value: &Value) -> Vec<Text> {
    match &value.data {
        crate::source::Data::List(items) => items
            .iter()
            .filter_map(|item| part.as_formula("span", item))
            .collect(),
        _ => Vec::new(),
    }
}

impl Answer for Motion {
    fn kind(&self) -> &'static dyn AnswerKind {
        &Kind
    }

    fn keys(&self) -> Vec<NodeId> {
        vec![self.key]
    }

    fn keeps_mistakes(&self) -> bool {
        true
    }

    fn printed(&self, context: &Context<'_>) -> Option<Result<Key, Absent>> {
        let times = self.span.ends(context.evaluation).map(times);
        let first = times.and_then(|times| samples(context.evaluation, self.key, &times[..1]));
        Some(first.map(|_| self.setup.printed()))
    }

    fn prepare(&self, context: &Context<'_>) -> Result<Box<dyn Marker>, Absent> {
        let evaluation = context.evaluation;
        let times = times(self.span.ends(evaluation)?);
        let values = samples(evaluation, self.key, &times)?;
        let largest = values
            .iter()
            .fold(0.0_f64, |largest, value| largest.max(value.abs()));
        let halves = if self.tolerance.is_derived() {
            derived(evaluation, self.key, &times, &values, largest, self.digits)
        } else {
            let half = self
                .tolerance
                .half_width(largest, || 0.0, self.digits, evaluation);
            vec![half; SAMPLES]
        };
        let mut mistakes = Vec::new();
        for mistaken in &context.mistakes {
            let given = if let Some(node) = mistaken.given.first() {
                samples(evaluation, *node, &times)
            } else {
                let with: Result<Vec<_>, Absent> = mistaken
                    .replaced
                    .iter()
                    .map(|(old, new)| Ok((*old, evaluation.value(*new)?.clone())))
                    .collect();
                with.and_then(|with| samples(&evaluation.replacing(with), self.key, &times))
            };
            if let Ok(given) = given {
                mistakes.push((mistaken.number, given, mistaken.credit));
            }
        }
        Ok(Box::new(Prepared {
            setup: Arc::clone(&self.setup),
            times,
            values,
            halves,
            mistakes,
            data: self.setup.meaning.data(evaluation),
        }))
    }
}

/// Times within a span: away from its ends, and not in step with any period.
fn times([from, to]: [f64; 2]) -> Vec<Precise> {
    let time = |place: usize| {
        let share = (place as f64 + 0.371) / SAMPLES as f64;
        Precise::exact(from + (to - from) * share)
    };
    (0..SAMPLES).map(time).collect()
}

/// The values of a node at these times.
fn samples(
    evaluation: &Evaluation<'_>,
    node: NodeId,
    times: &[Precise],
) -> Result<Vec<f64>, Absent> {
    let function = evaluation.function(node)?;
    times.iter().map(|time| sample(&function, *time)).collect()
}

fn sample(function: &Curve<'_, '_>, time: Precise) -> Result<f64, Absent> {
    let is_constant = function.variables().next().is_none();
    let value: Number = if is_constant {
        function.at(&[])?
    } else {
        function.at(&[time])?
    };
    Ok(value.as_real().unwrap_or(f64::NAN))
}

/// How far rounding in the steps moves the function, time by time.
fn derived(
    evaluation: &Evaluation<'_>,
    key: NodeId,
    times: &[Precise],
    values: &[f64],
    largest: f64,
    digits: u32,
) -> Vec<f64> {
    const STEP: f64 = 1e-6;
    let mut spread = vec![largest; values.len()];
    let mut add = |moved: &[f64]| {
        for ((sum, moved), value) in spread.iter_mut().zip(moved).zip(values) {
            let part = (moved - value).abs() / STEP;
            *sum += if part.is_finite() {
                part.min(10.0 * largest)
            } else {
                0.0
            };
        }
    };
    let graph = evaluation.graph();
    for step in graph
        .steps(key)
        .into_iter()
        .filter(|step| graph.variables(*step).is_empty())
    {
        let scaled = evaluation.value(step).ok().and_then(|value| {
            let numbers = value
                .numbers()
                .iter()
                .map(|number| number * (1.0 + STEP))
                .collect();
            Number::new(value.form(), numbers, value.bounds().to_vec())
        });
        let moved = scaled
            .and_then(|moved| samples(&evaluation.replacing(vec![(step, moved)]), key, times).ok());
        if let Some(moved) = moved {
            add(&moved);
        }
    }
    // A frequency that stands in the formula without a name is rounded all the same.
    let later: Vec<Precise> = times
        .iter()
        .map(|time| Precise::exact(time.high() * (1.0 + STEP)))
        .collect();
    if let Ok(moved) = samples(evaluation, key, &later) {
        add(&moved);
    }
    let share = 0.005 * crate::numerics::powi(10.0, 3 - digits as i32);
    spread.into_iter().map(|sum| share * sum).collect()
}

impl Prepared {
    /// The values of a typed function at the times.
    fn values_of(&self, expr: &Expr) -> Option<Vec<f64>> {
        let setup = &self.setup;
        let program = setup.meaning.compile(expr, &BTreeMap::new()).ok()?;
        let slot = setup.meaning.place(&setup.variable)? * ORDERS;
        let mut data = self.data.clone();
        let mut room = Workspace::default();
        let mut values = Vec::with_capacity(self.times.len());
        for time in &self.times {
            data[slot] = *time;
            values.push(program.evaluate(&data[..], &mut room).ok()?.as_real()?);
        }
        Some(values)
    }

    /// Whether a typed function with numbers has the dimension of the key, where that can be told.
    fn dimension_trouble(&self, expr: &Expr) -> Option<Dimension> {
        let setup = &self.setup;
        // Numbers stand for values in the unit of the key, rates and frequencies: only formulas in data alone have dimensions.
        let names = expr.names();
        let has_data = names
            .free
            .iter()
            .any(|variable| variable.name != setup.variable);
        let found = expr.check(&setup.meaning).ok().filter(|_| has_data)?;
        let (key, typed) = (setup.kind.dimension()?, found.dimension()?);
        (key != typed && !typed.is_pure()).then_some(typed)
    }

    fn is_near(&self, typed: &[f64], key: &[f64]) -> bool {
        typed
            .iter()
            .zip(key)
            .zip(&self.halves)
            .all(|((typed, key), half)| (typed - key).abs() <= half + 1e-12 * key.abs())
    }
}

impl Marker for Prepared {
    fn trials(&self) -> Vec<Trial> {
        let mut trials = vec![
            Trial::new(Nature::Unreadable, "exp("),
            Trial::new(Nature::Unreadable, "unheard_of cos(t)"),
        ];
        let text = self.setup.shown.to_string();
        let largest = self
            .values
            .iter()
            .fold(0.0_f64, |most, value| most.max(value.abs()));
        // Cases and numbers with units cannot be typed, and nothing is next to zero.
        let is_typable = !text.contains("if ") && !text.contains('[');
        if !is_typable || largest == 0.0 || !self.setup.shown.names().paths.is_empty() {
            return trials;
        }
        trials.push(Trial::new(Nature::Right, text.as_str()));
        let shares = self.values.iter().zip(&self.halves);
        let nearest = shares
            .map(|(value, half)| half / value.abs())
            .fold(f64::INFINITY, f64::min);
        if nearest.is_finite() {
            let scaled = |share: f64| format!("({})*({text})", typed_number(1.0 + share * nearest));
            trials.push(Trial::new(Nature::Borderline, scaled(0.99)));
            trials.push(Trial::new(Nature::Wrong, scaled(1.01)));
        }
        trials
    }

    fn key(&self) -> Key {
        self.setup.printed()
    }

    fn mark(&self, response: &str) -> Marking {
        let response = without_condition(response);
        let typed = typed::formula(response, &self.setup.lexicon, manner(response));
        let first = match typed {
            Ok(typed) => self.mark_typed(typed),
            Err(error) => Marking::unreadable(error.sentence(response)),
        };
        if matches!(first.verdict, Verdict::Unreadable | Verdict::Wrong)
            && !first
                .reasons
                .iter()
                .any(|reason| matches!(reason, Reason::Mistake(_)))
            && let Some(marking) = self.mark_with_unit(response)
        {
            return marking;
        }
        first
    }
}

fn manner(response: &str) -> Manner {
    Manner {
        comma_is_decimal: !response.contains("atan2"),
        has_imaginary_unit: false,
    }
}

/// A function with the unit that stands behind its first number taken out, `0.5 m exp(-t)`.
fn unit_in_front(text: &str) -> Option<(String, Unit)> {
    let is_of_number = |char: char| char.is_ascii_digit() || ".,".contains(char);
    let start = text.trim_start_matches('(');
    let digits = start
        .find(|char| !is_of_number(char))
        .filter(|at| *at > 0)?;
    let (number, rest) = start.split_at(digits);
    let rest = rest.trim_start();
    let end = rest.find([' ', '*', '·', ')', '('])?;
    let unit = Unit::read(&rest[..end])
        .ok()
        .filter(|unit| !unit.is_one())?;
    let is_bracketed = start.len() < text.len() && rest[end..].starts_with(')');
    let rest = &rest[end + usize::from(is_bracketed)..];
    Some((
        format!("{number} {}", rest.trim_start_matches([' ', '*', '·'])),
        unit,
    ))
}

/// Without the times for which a function is meant to hold: `…, t >= 0` or `… for t > 0`.
fn without_condition(response: &str) -> &str {
    let is_condition = |text: &str| text.contains(['<', '>', '≤', '≥']);
    let words = [",", ";", " for ", " if ", " when ", " where "].into_iter();
    let bracket = response.trim_end().ends_with(')').then_some("(");
    let cuts = words.chain(bracket).filter_map(|sign| response.rfind(sign));
    let cut = cuts.filter(|at| is_condition(&response[*at..])).min();
    cut.map_or(response, |at| response[..at].trim_end())
}

impl Prepared {
    /// The marking of numbers with a unit, behind the function or behind its first number.
    fn mark_with_unit(&self, response: &str) -> Option<Marking> {
        let setup = &self.setup;
        let own = setup.unit?;
        let start = response.rfind('=').map_or(0, |at| at + 1);
        let value = response[start..].trim();
        let bare = |text: &str| {
            let typed = typed::formula(text, &setup.lexicon, manner(text)).ok()?;
            (!self.has_data(&typed.value)).then_some(typed)
        };
        let behind = typed::with_unit(value).find_map(|(text, unit)| Some((bare(text)?, unit)));
        let (typed, unit) = behind.or_else(|| {
            let (text, unit) = unit_in_front(value)?;
            Some((bare(&text)?, unit))
        })?;
        if unit.dimension() != own.dimension() {
            let words = format!("The unit does not fit; what is asked is in {}.", own.text());
            return Some(Marking::unreadable(words));
        }
        let values = self.values_of(&typed.value)?;
        let values: Vec<f64> = values.iter().map(|value| unit.to_si(*value)).collect();
        let reading = Reading {
            math: Math::row([
                typed.value.typeset(&setup.lexicon),
                Math::thin_space(),
                unit.math(),
            ]),
            text: format!("({}) {}", typed.value, unit.text()),
            si: Vec::new(),
        };
        Some(self.judged(
            reading,
            &typed.value,
            |key| self.is_near(&values, key),
            &values,
        ))
    }

    /// Whether letters of the question stand in a function.
    fn has_data(&self, expr: &Expr) -> bool {
        let names = expr.names();
        names
            .free
            .iter()
            .any(|variable| variable.name != self.setup.variable)
    }

    fn mark_typed(&self, Typed { value, other }: Typed<Expr>) -> Marking {
        let setup = &self.setup;
        let trouble = self.dimension_trouble(&value);
        let expr = match other {
            Some(other) if trouble.is_some() && self.dimension_trouble(&other).is_none() => other,
            _ => value,
        };
        let reading = Reading {
            math: expr.typeset(&setup.lexicon),
            text: expr.to_string(),
            si: Vec::new(),
        };
        let Some(values) = self.values_of(&expr) else {
            let words = "This has no value somewhere on the span.".to_owned();
            return Marking::read(
                reading,
                Credit::NONE,
                Reason::Other,
                Some(Feedback::Words(words)),
            );
        };
        // Numbers without data may be in the unit that is asked for.
        let shown = setup.unit.map(|unit| {
            values
                .iter()
                .map(|value| unit.to_si(*value))
                .collect::<Vec<_>>()
        });
        let shown = shown.filter(|_| !self.has_data(&expr));
        let fits = |key: &[f64]| {
            self.is_near(&values, key)
                || shown.as_ref().is_some_and(|shown| self.is_near(shown, key))
        };
        self.judged(reading, &expr, fits, &values)
    }

    /// The marking of a function that was read, by whether it fits other values at the times.
    fn judged(
        &self,
        reading: Reading,
        expr: &Expr,
        fits: impl Fn(&[f64]) -> bool,
        values: &[f64],
    ) -> Marking {
        if fits(&self.values) {
            return Marking::read(reading, Credit::FULL, Reason::Matches, None);
        }
        if let Some((number, _, credit)) = self.mistakes.iter().find(|(_, given, _)| fits(given)) {
            let feedback = Some(Feedback::Mistake(*number));
            return Marking::read(reading, *credit, Reason::Mistake(*number), feedback);
        }
        let negated: Vec<f64> = self.values.iter().map(|value| -value).collect();
        let (reason, words) = if self.dimension_trouble(expr).is_some() {
            let found = self
                .dimension_trouble(expr)
                .map_or(String::new(), Dimension::describe);
            (
                Reason::Dimension,
                Some(format!("This comes out in {found}.")),
            )
        } else if fits(&negated) {
            (Reason::Sign, Some("The sign is wrong.".to_owned()))
        } else if self.starts_right(values) {
            (
                Reason::Other,
                Some(
                    "It begins rightly, but runs away later: look at the frequency and the decay."
                        .to_owned(),
                ),
            )
        } else {
            (Reason::Other, None)
        };
        Marking::read(reading, Credit::NONE, reason, words.map(Feedback::Words))
    }

    /// Whether the first samples are right.
    fn starts_right(&self, typed: &[f64]) -> bool {
        let first = 3;
        typed[..first]
            .iter()
            .zip(&self.values)
            .zip(&self.halves)
            .all(|((typed, key), half)| (typed - key).abs() <= 2.0 * half)
    }
}
