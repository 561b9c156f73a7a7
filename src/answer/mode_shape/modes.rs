//! The modes of the model that a part asks about.

use super::span::{coordinates, lies_in, vectors};
use crate::answer::Declare;
use crate::expr::{Name, Path};
use crate::quantity::{Evaluation, NodeId};
use crate::source::{Data, Span, Table, Text};

/// Which modes are asked, counted from 1, and where those of the model are to be had.
#[derive(Clone, Debug)]
pub(crate) struct AskedModes {
    pub(crate) numbers: Vec<usize>,
    frequencies: Option<NodeId>,
    shapes: Option<NodeId>,
}

/// The modes of a model for an instance.
#[derive(Clone, Debug)]
pub(crate) struct Modes {
    frequencies: Vec<f64>,
    /// With unit modal mass.
    shapes: Vec<Vec<f64>>,
}

/// Frequencies that differ by less than this part of the highest are one.
const REPEATED: f64 = 1e-9;

impl AskedModes {
    /// Reads the keys `mode` and `model`.
    pub(crate) fn read(part: &Table<'_>, declare: &mut dyn Declare) -> Option<Self> {
        let value = part.required("mode")?;
        let number = |value: &crate::source::Value| match &value.data {
            Data::Number { number } => number.parse::<usize>().ok().filter(|number| *number > 0),
            _ => None,
        };
        let numbers: Option<Vec<usize>> = match &value.data {
            Data::List(items) => items.iter().map(number).collect(),
            _ => number(value).map(|number| vec![number]),
        };
        let Some(numbers) = numbers.filter(|numbers| !numbers.is_empty()) else {
            return part.wrong("mode", "the number of a mode, or a list of them", value);
        };
        let stated = part.text("model");
        let model = stated
            .as_ref()
            .map_or("model", |text| text.value.as_str())
            .to_owned();
        let span = stated.as_ref().map_or(Span::NONE, |text| text.span);
        let mut quantity = |name: &str| {
            let names: Vec<Name> = model.split('.').chain([name]).map(Name::new).collect();
            let is_there = declare.graph().offered(&Path::new(names)).is_some();
            let text = Text {
                value: format!("{model}.{name}"),
                span,
            };
            // A model that is named has to be there.
            (is_there || stated.is_some()).then(|| declare.formula(name, &text))?
        };
        Some(Self {
            numbers,
            frequencies: quantity("natural_angular_frequencies"),
            shapes: quantity("mode_shapes"),
        })
    }

    /// The modes for an instance, if there is a model that has them.
    pub(crate) fn modes(&self, evaluation: &Evaluation<'_>) -> Option<Modes> {
        let frequencies = evaluation.value(self.frequencies?).ok()?;
        let shapes = evaluation.value(self.shapes?).ok()?;
        let frequencies = frequencies.numbers().to_vec();
        let width = shapes.numbers().len() / frequencies.len().max(1);
        let shapes = vectors(shapes.numbers(), width);
        (shapes.len() == frequencies.len()).then_some(Modes {
            frequencies,
            shapes,
        })
    }
}

impl Modes {
    /// How many there are.
    pub(crate) fn count(&self) -> usize {
        self.shapes.len()
    }

    /// The shapes of the modes with the frequency of this one.
    pub(crate) fn space(&self, number: usize) -> Vec<Vec<f64>> {
        let Some(own) = self.frequencies.get(number.wrapping_sub(1)) else {
            return Vec::new();
        };
        let highest = self.frequencies.iter().copied().fold(0.0, f64::max);
        (0..self.count())
            .filter(|place| (self.frequencies[*place] - own).abs() <= REPEATED * highest)
            .map(|place| self.shapes[place].clone())
            .collect()
    }

    /// The number of the mode in whose space a vector lies.
    pub(crate) fn of(&self, vector: &[f64], angle: f64) -> Option<usize> {
        (1..=self.count()).find(|number| lies_in(vector, &self.space(*number), angle))
    }

    /// The modal mass of a vector in the space of a mode.
    pub(crate) fn modal_mass(&self, vector: &[f64], number: usize) -> Option<f64> {
        let parts = coordinates(vector, &self.space(number))?;
        Some(parts.iter().map(|part| part * part).sum())
    }
}
