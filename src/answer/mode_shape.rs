//! `mode-shape`: the shape of a mode, or a basis of the modes of one frequency.
//!
//! The student types `(1, 0.618)`, `[1; -2]` or `[1, (1 + sqrt(5))/2]`; any scale and sign is right unless
//! `normalization` asks for one: `mass` for shapes with unit modal mass, `first` for a first component of 1.
//! Several vectors, `[[1, -1, 0], [0, 1, -1]]`, are right if they span the same modes. The tolerance is an
//! angle, a hundredth of a radian for every third figure unless stated.
//!
//! ```toml
//! [[part]]
//! kind          = "mode-shape"
//! key           = "u1"
//! mode          = 1
//! normalization = "any"         # or "mass", "first"
//! ask           = "Find the shape of the first mode."
//! ```

use std::collections::BTreeMap;
use std::sync::Arc;

use super::matrix::Written;
use super::meaning::{Meaning, Prefer, lexicon};
use super::typed::{self, Lexicon, Manner};
use super::{
    Answer, AnswerError, AnswerKind, Context, Credit, Declare, Feedback, Key, KeyValue, Marker,
    Marking, Reading, Reason, Tolerance,
};
use crate::expr::{Expr, Field, Name, Precise, Shape, Value, Workspace};
use crate::math::Math;
use crate::quantity::{Absent, NodeId};
use crate::source::{Table, Value as Data};
use crate::unit::{Decimal, DecimalMark, Unit};

/// The kind.
pub(super) struct Kind;

/// Which scale is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Scale {
    Any,
    Mass,
    First,
}

#[derive(Debug)]
struct Mode {
    key: NodeId,
    tolerance: Option<Tolerance>,
    digits: u32,
    setup: Arc<Setup>,
}

#[derive(Debug)]
struct Setup {
    shape: Shape,
    scale: Scale,
    written: Written,
    units: Vec<Unit>,
    meaning: Meaning,
    lexicon: Lexicon,
}

struct Prepared {
    setup: Arc<Setup>,
    key: Value,
    angle: f64,
    digits: u32,
    mistakes: Vec<(usize, Vec<Vec<f64>>, Credit)>,
    data: Vec<Precise>,
    mark: DecimalMark,
}

impl AnswerKind for Kind {
    fn name(&self) -> &'static str {
        "mode-shape"
    }

    fn minutes(&self) -> u32 {
        5
    }

    fn read(&self, part: &Table<'_>, declare: &mut dyn Declare) -> Option<Box<dyn Answer>> {
        let text = part
            .required("key")
            .and_then(|key| part.as_formula("key", key));
        // Which mode it is matters to other parts of the program; marking compares with the key.
        part.required("mode");
        part.text("model");
        let (normalization, tolerance) = (part.text("normalization"), part.text("tolerance"));
        let written = Written::read(part, declare);
        let text = text?;
        let key = declare.formula("key", &text)?;
        let kind = declare.graph().kind(key)?.clone();
        let is_list = matches!(kind.shape(), Shape::Vector(_) | Shape::Matrix(..));
        if kind.field() != Field::Real || !is_list {
            let found = kind.form().to_string();
            declare.find(
                &AnswerError::KeyForm {
                    expected: "a vector, or several",
                    found,
                },
                &text,
            );
            return None;
        }
        let scale = match normalization.as_ref().map(|text| text.value.as_str()) {
            None | Some("any") => Scale::Any,
            Some("mass") => Scale::Mass,
            Some("first") => Scale::First,
            Some(_) => {
                let text = normalization.unwrap_or(text);
                declare.find(
                    &AnswerError::Unread(
                        text.value.clone(),
                        "normalization: `any`, `mass` or `first`",
                    ),
                    &text,
                );
                return None;
            }
        };
        let radian = Unit::parse("rad").unwrap_or(Unit::ONE);
        let tolerance = match tolerance {
            Some(text) => Some(Tolerance::read(&text, &radian, declare)?),
            None => None,
        };
        let own = Name::new(text.value.as_str());
        let named = declare.graph().find(&own).map(|_| own);
        let (lexicon, _) = lexicon(declare, &part.texts("in"), named.as_ref());
        Some(Box::new(Mode {
            key,
            tolerance,
            digits: u32::from(declare.digits_of(key)),
            setup: Arc::new(Setup {
                shape: kind.shape(),
                scale,
                written,
                units: declare.units_of(key),
                meaning: Meaning::of(declare, Prefer::Quantities),
                lexicon,
            }),
        }))
    }
}

impl Answer for Mode {
    fn kind(&self) -> &'static dyn AnswerKind {
        &Kind
    }

    fn keys(&self) -> Vec<NodeId> {
        vec![self.key]
    }

    fn read_mistake(
        &mut self,
        _number: usize,
        answer: &Data,
        part: &Table<'_>,
        declare: &mut dyn Declare,
    ) -> Option<Vec<NodeId>> {
        let text = part.as_formula("answer", answer)?;
        Some(vec![declare.formula("mistake", &text)?])
    }

    fn prepare(&self, context: &Context<'_>) -> Result<Box<dyn Marker>, Absent> {
        let evaluation = context.evaluation;
        let key = evaluation.value(self.key)?.clone();
        let derived = 0.01 * crate::numerics::powi(10.0, 3 - self.digits as i32);
        let angle = match &self.tolerance {
            Some(tolerance) => tolerance.half_width(1.0, || 0.0, self.digits, evaluation),
            None => derived,
        };
        let mistakes = context.mistakes.iter().filter_map(|mistaken| {
            let value = mistaken.values.first()?;
            Some((
                mistaken.number,
                vectors(value.numbers(), value.shape()),
                mistaken.credit,
            ))
        });
        Ok(Box::new(Prepared {
            setup: Arc::clone(&self.setup),
            key,
            angle,
            digits: self.digits,
            mistakes: mistakes.collect(),
            data: self.setup.meaning.data(evaluation),
            mark: context.mark,
        }))
    }
}

/// The rows of a matrix, or the one vector.
fn vectors(numbers: &[f64], shape: Shape) -> Vec<Vec<f64>> {
    let length = match shape {
        Shape::Matrix(_, columns) => columns,
        _ => numbers.len(),
    };
    numbers.chunks(length.max(1)).map(<[f64]>::to_vec).collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn length(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

/// Orthonormal vectors that span the same; those that add nothing are left out.
fn orthonormal(vectors: &[Vec<f64>], least: f64) -> Vec<Vec<f64>> {
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for vector in vectors {
        let (mut rest, whole) = (vector.clone(), length(vector));
        for _ in 0..2 {
            for own in &basis {
                let share = dot(own, &rest);
                rest.iter_mut()
                    .zip(own)
                    .for_each(|(value, own)| *value -= share * own);
            }
        }
        let size = length(&rest);
        if size > least * whole && size > 0.0 {
            for value in &mut rest {
                *value /= size;
            }
            basis.push(rest);
        }
    }
    basis
}

/// Whether vectors span the same space up to an angle.
fn spans(key: &[Vec<f64>], typed: &[Vec<f64>], angle: f64) -> bool {
    let (basis, own) = (orthonormal(key, 1e-9), orthonormal(typed, 0.05));
    if basis.len() != own.len() || typed.len() != own.len() {
        return false;
    }
    let limit = crate::numerics::sin(angle.min(1.5)) + 1e-12;
    typed.iter().all(|vector| {
        let mut rest = vector.clone();
        for own in &basis {
            let share = dot(own, &rest);
            rest.iter_mut()
                .zip(own)
                .for_each(|(value, own)| *value -= share * own);
        }
        length(&rest) <= limit * length(vector)
    })
}

impl Prepared {
    fn key_vectors(&self) -> Vec<Vec<f64>> {
        vectors(self.key.numbers(), self.key.shape())
    }

    /// The numbers of entries for these data.
    fn numbers(&self, entries: &[Expr]) -> Option<Vec<f64>> {
        let mut room = Workspace::default();
        let number = |entry: &Expr| {
            let program = self.setup.meaning.compile(entry, &BTreeMap::new()).ok()?;
            program.evaluate(&self.data[..], &mut room).ok()?.as_real()
        };
        entries.iter().map(number).collect()
    }

    /// What is wrong with the scale of vectors that have the right direction.
    fn scale_trouble(&self, typed: &[Vec<f64>]) -> Option<&'static str> {
        let key = self.key_vectors();
        match self.setup.scale {
            Scale::Any => None,
            Scale::First => {
                let is_one = typed.iter().all(|vector| (vector[0] - 1.0).abs() <= 0.005);
                (!is_one)
                    .then_some("The shape is right; scale it so that its first component is 1.")
            }
            Scale::Mass => {
                let is_alike = key.iter().zip(typed).all(|(key, typed)| {
                    (length(typed) / length(key) - 1.0).abs() <= self.angle.max(0.005)
                });
                (!is_alike).then_some("The shape is right; scale it so that its modal mass is 1.")
            }
        }
    }

    fn typeset(entries: &[Math], width: usize) -> Math {
        let mut rows = entries.chunks(width.max(1)).map(|row| {
            Math::matrix(row.iter().map(|entry| vec![entry.clone()]).collect()).fenced("(", ")")
        });
        let first = rows.next().unwrap_or_else(|| Math::row([]));
        Math::row(std::iter::once(first).chain(rows.flat_map(|row| [Math::punctuation(","), row])))
    }
}

impl Marker for Prepared {
    fn key(&self) -> Key {
        let numbers = self.key.numbers();
        let set = |number: &f64| match Decimal::rounded(*number, self.digits) {
            Some(decimal) => crate::unit::Quantity::new(decimal, Unit::ONE).math(self.mark),
            None => Math::text("out of range"),
        };
        let width = self.key_vectors().first().map_or(1, Vec::len);
        Key {
            math: Self::typeset(&numbers.iter().map(set).collect::<Vec<_>>(), width),
            accepted: None,
            value: KeyValue::Numbers {
                form: self.key.form(),
                si: numbers.to_vec(),
            },
        }
    }

    fn mark(&self, response: &str) -> Marking {
        let (reading, typed) = match self.read(response) {
            Ok(read) => read,
            Err(words) => return Marking::unreadable(words),
        };
        let keys = self.key_vectors();
        if typed.iter().any(|vector| length(vector) == 0.0) {
            let words = "A shape with all components zero is no motion.".to_owned();
            return Marking::read(
                reading,
                Credit::NONE,
                Reason::Other,
                Some(Feedback::Words(words)),
            );
        }
        if spans(&keys, &typed, self.angle) {
            return match self.scale_trouble(&typed) {
                None => Marking::read(reading, Credit::FULL, Reason::Matches, None),
                Some(words) => Marking::read(
                    reading,
                    Credit::NONE,
                    Reason::Near,
                    Some(Feedback::Words(words.to_owned())),
                ),
            };
        }
        let named = self
            .mistakes
            .iter()
            .find(|(_, given, _)| spans(given, &typed, self.angle));
        if let Some((number, _, credit)) = named {
            let feedback = Some(Feedback::Mistake(*number));
            return Marking::read(reading, *credit, Reason::Mistake(*number), feedback);
        }
        let is_dependent = orthonormal(&typed, 0.05).len() < typed.len();
        let words = if is_dependent && typed.len() > 1 {
            Some("These shapes are multiples of one another; independent ones are asked.")
        } else if typed.len() == 1 && is_reversed(&keys[0], &typed[0], self.angle) {
            Some("The magnitudes fit, but look again at which parts move against each other.")
        } else {
            None
        };
        let reason = if words.is_some() {
            Reason::Sign
        } else {
            Reason::Other
        };
        Marking::read(
            reading,
            Credit::NONE,
            reason,
            words.map(|words| Feedback::Words(words.to_owned())),
        )
    }
}

impl Prepared {
    /// How a response is read, and its vectors in SI units.
    fn read(&self, response: &str) -> Result<(Reading, Vec<Vec<f64>>), String> {
        let setup = &self.setup;
        let start = response.rfind('=').map_or(0, |at| at + 1);
        let manner = Manner {
            comma_is_decimal: response.contains(';')
                && response.contains(',')
                && !response.contains('.'),
            has_imaginary_unit: false,
        };
        let listed = match typed::list(response, start, response.len(), &setup.lexicon, manner) {
            Ok(listed) => listed,
            Err(error) => return Err(error.sentence(response)),
        };
        let keys = self.key_vectors();
        let width = keys.first().map_or(0, Vec::len);
        let entries = listed.rows.concat();
        if entries.len() != width * keys.len() {
            return Err(format!(
                "This has {} components; {} are asked, such as `(1, -0.5)` for two.",
                entries.len(),
                width * keys.len()
            ));
        }
        let has_names = entries.iter().any(|entry| !entry.names().free.is_empty());
        match setup.written {
            Written::Number if has_names => {
                return Err("Numbers are asked here, not formulas.".to_owned());
            }
            _ => {}
        }
        let Some(mut numbers) = self.numbers(&entries) else {
            return Err("A component has no value.".to_owned());
        };
        let reading = Reading {
            math: Self::typeset(
                &entries
                    .iter()
                    .map(|entry| entry.typeset(&setup.lexicon))
                    .collect::<Vec<_>>(),
                width,
            ),
            text: format!(
                "[{}]",
                entries
                    .iter()
                    .map(ToString::to_string)
                    .collect::<Vec<_>>()
                    .join(", ")
            ),
            si: numbers.clone(),
        };
        if !has_names {
            for (number, unit) in numbers.iter_mut().zip(&setup.units) {
                *number = unit.to_si(*number);
            }
        }
        let shape = if keys.len() == 1 {
            Shape::Vector(width)
        } else {
            setup.shape
        };
        let typed = vectors(&numbers, shape);
        Ok((reading, typed))
    }
}

/// Whether shapes agree but for signs of components.
fn is_reversed(key: &[f64], typed: &[f64], angle: f64) -> bool {
    let size = |vector: &[f64]| vector.iter().map(|value| value.abs()).collect::<Vec<_>>();
    spans(&[size(key)], &[size(typed)], angle)
}
