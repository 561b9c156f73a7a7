//! Where functions are compared: the span of a part, and the times within it.

use super::SAMPLES;
use crate::answer::{AnswerError, Declare};
use crate::expr::{Name, Path, Precise};
use crate::quantity::{Absent, Evaluation, NodeId};
use crate::source::{Table, Text, Value};

/// Where functions are compared.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Extent {
    /// Between these.
    Stated([NodeId; 2]),
    /// From 0 to three periods of the slowest of these angular frequencies.
    Periods(NodeId),
}

impl Extent {
    /// Three periods of the item's model; without one the span has to be stated.
    pub(crate) fn of_model(key: &Text, declare: &mut dyn Declare) -> Option<Self> {
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

    pub(crate) fn ends(self, evaluation: &Evaluation<'_>) -> Result<[f64; 2], Absent> {
        // Three periods show amplitude, phase and decay of the slowest mode.
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

/// The formulas of the key `span`.
pub(crate) fn spans(part: &Table<'_>, value: &Value) -> Vec<Text> {
    match &value.data {
        crate::source::Data::List(items) => items
            .iter()
            .filter_map(|item| part.as_formula("span", item))
            .collect(),
        _ => Vec::new(),
    }
}

/// Times within a span: away from its ends, and not in step with any period.
pub(crate) fn times([from, to]: [f64; 2]) -> Vec<Precise> {
    let time = |place: usize| {
        let share = (place as f64 + 0.371) / SAMPLES as f64;
        Precise::exact(from + (to - from) * share)
    };
    (0..SAMPLES).map(time).collect()
}
