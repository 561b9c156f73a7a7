//! An answer as a program gets it: the entries of `solve`.

use serde::Serialize;

use super::Solution;
use crate::answer::KeyValue;
use crate::bank::{QuantityInfo, Units};
use crate::expr::{Field, Form, Name, Precise, Shape, Type, Value};
use crate::quantity::{Absent, NodeId};
use crate::unit::Unit;

/// One answer. What it has depends on its kind; `si` is `null` with a reason where the answer does not exist.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Entry {
    /// The kind of its part, or `quantity`.
    pub kind: &'static str,
    /// The coherent units of its numbers.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unit: Option<Nested<String>>,
    /// The times of the samples of a function, in seconds.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<Vec<f64>>,
    /// Its numbers in SI units.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub si: Option<Nested<Number>>,
    /// Why there are none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
    /// The right options of a choice.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub value: Option<Nested<String>>,
    /// A formula in the formula language, or intervals as inequalities.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub text: Option<String>,
    /// A formula in LaTeX.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub latex: Option<String>,
}

/// Values nested as the entries of a vector or matrix, or the samples of a function.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Nested<T> {
    /// One value.
    One(T),
    /// Several.
    List(Vec<Nested<T>>),
    /// None, `null`.
    None(()),
}

/// A number as a program gets it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Number {
    /// A real number.
    Real(f64),
    /// What is true or false.
    Truth(bool),
    /// A complex number.
    Complex {
        /// Its real part.
        re: f64,
        /// Its imaginary part.
        im: f64,
    },
    /// All numbers between two ends, either of which may be missing.
    Interval {
        /// Its lower end, if it has one.
        from: Option<f64>,
        /// Its upper end, if it has one.
        to: Option<f64>,
        /// Whether the ends are left out.
        open: [bool; 2],
    },
}

pub(crate) fn of(solution: &Solution<'_>, id: &str, at: &[Precise]) -> Option<Entry> {
    let template = solution.template();
    let part = template.place(id);
    let kind = part.map_or("quantity", |place| {
        template.parts[place].answer.kind().name()
    });
    // A blank whose key is a quantity bore its name before it belonged to a group.
    let old = part
        .into_iter()
        .flat_map(|place| &template.parts[place].was);
    let mut names = std::iter::once(id).chain(old.map(String::as_str));
    let named = names.find_map(|name| template.graph.find(&Name::new(name)));
    let quantity = named.and_then(|node| Some((node, template.info(node)?)));
    if let Some((node, info)) = quantity.filter(|(_, info)| info.units.is_some()) {
        return Some(quantity_entry(solution, kind, node, info, at));
    }
    part.map(|place| part_entry(solution, kind, place))
}

fn quantity_entry(
    solution: &Solution<'_>,
    kind: &'static str,
    node: NodeId,
    info: &QuantityInfo,
    at: &[Precise],
) -> Entry {
    let graph = &solution.template().graph;
    let variables = graph.variables(node);
    if variables.iter().any(|name| name.as_str() != "t") {
        let text = graph.expr(node).map(ToString::to_string);
        return Entry {
            text,
            ..Entry::of(kind)
        };
    }
    if !variables.is_empty() {
        let function = solution.evaluation().function(node);
        let samples = function.map(|function| {
            let sample = |time: &Precise| match function.at(&[*time]) {
                Ok(value) => numbers(&value),
                Err(_) => Nested::None(()),
            };
            Nested::List(at.iter().map(sample).collect())
        });
        let entry = Entry {
            unit: info.units.as_ref().map(|own| units(own, Shape::Scalar)),
            at: Some(at.iter().map(|time| time.high()).collect()),
            ..Entry::of(kind)
        };
        return entry.with_value(samples);
    }
    let shape = graph.kind(node).map_or(Shape::Scalar, Type::shape);
    let entry = Entry {
        unit: info.units.as_ref().map(|own| units(own, shape)),
        ..Entry::of(kind)
    };
    entry.with_value(solution.evaluation().value(node).map(numbers))
}

fn part_entry(solution: &Solution<'_>, kind: &'static str, place: usize) -> Entry {
    let entry = Entry::of(kind);
    let unit = || {
        let unit = solution.template().parts[place].answer.unit();
        let unit = unit.map_or_else(|| "1".to_owned(), |unit| unit.coherent().to_string());
        Some(Nested::One(unit))
    };
    match solution.marker(place).map(|marker| marker.key().value) {
        Ok(KeyValue::Numbers { form, si }) => {
            let bounds = vec![0.0; si.len()];
            let value = Value::new(form, si, bounds);
            Entry {
                unit: unit(),
                si: Some(value.map_or(Nested::None(()), |value| numbers(&value))),
                ..entry
            }
        }
        Ok(KeyValue::Options { ids, is_list }) => {
            let mut ids = ids.into_iter().map(Nested::One);
            let value = if is_list {
                Nested::List(ids.collect())
            } else {
                ids.next().unwrap_or(Nested::None(()))
            };
            Entry {
                value: Some(value),
                ..entry
            }
        }
        Ok(KeyValue::Intervals { pieces, text }) => Entry {
            unit: unit(),
            si: Some(Nested::List(
                pieces
                    .into_iter()
                    .map(|([from, to], open)| Nested::One(Number::Interval { from, to, open }))
                    .collect(),
            )),
            text: Some(text),
            ..entry
        },
        Ok(KeyValue::Formula { text, latex }) => Entry {
            text: Some(text),
            latex: Some(latex),
            ..entry
        },
        Err(absent) => entry.with_value(Err(absent)),
    }
}

impl Entry {
    fn of(kind: &'static str) -> Self {
        Self {
            kind,
            ..Self::default()
        }
    }

    /// The value, or none with the reason.
    fn with_value(self, value: Result<Nested<Number>, Absent>) -> Self {
        match value {
            Ok(value) => Self {
                si: Some(value),
                ..self
            },
            Err(absent) => Self {
                si: Some(Nested::None(())),
                reason: Some(absent.to_string()),
                ..self
            },
        }
    }
}

/// One unit, or units nested as the entries are.
fn units(units: &Units, shape: Shape) -> Nested<String> {
    let coherent = |unit: &Unit| Nested::One(unit.coherent().to_string());
    match (units, shape) {
        (Units::One(unit), _) => coherent(unit),
        (Units::Each(units), Shape::Matrix(_, columns)) => Nested::List(
            units
                .chunks(columns)
                .map(|row| Nested::List(row.iter().map(coherent).collect()))
                .collect(),
        ),
        (Units::Each(units), _) => Nested::List(units.iter().map(coherent).collect()),
    }
}

/// Numbers nested as their shape has them.
fn numbers(value: &Value) -> Nested<Number> {
    let Form { field, shape } = value.form();
    let entry = |position: usize| {
        let own = value.entry(position);
        Nested::One(match field {
            Field::Boolean => Number::Truth(own.re != 0.0),
            Field::Real => Number::Real(own.re),
            Field::Complex => Number::Complex {
                re: own.re,
                im: own.im,
            },
        })
    };
    match shape {
        Shape::Scalar => entry(0),
        Shape::Vector(length) => Nested::List((0..length).map(entry).collect()),
        Shape::Matrix(rows, columns) => Nested::List(
            (0..rows)
                .map(|row| {
                    let columns = 0..columns;
                    Nested::List(
                        columns
                            .clone()
                            .map(|column| entry(row * columns.len() + column))
                            .collect(),
                    )
                })
                .collect(),
        ),
    }
}
