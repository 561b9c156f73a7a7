//! Marks shapes: each in the space of its mode, those of one frequency independent.

use std::sync::Arc;

use super::modes::Modes;
use super::read::{Shapes, read};
use super::span::{are_independent, away, independent, length, lies_in};
use super::{AskedScale, Setup};
use crate::answer::matrix::Written;
use crate::answer::trial::typed as typed_number;
use crate::answer::{
    Credit, Echo, Key, KeyValue, Marker, Marking, Nature, Remark, Scaling, Shape, Slip, Trial,
    Unreadable, Why,
};
use crate::expr::{Precise, Value};
use crate::math::Math;
use crate::numerics::Rational;
use crate::response::Passage;
use crate::unit::{DecimalMark, Unit};

/// A prepared key.
pub(crate) struct Prepared {
    pub(crate) setup: Arc<Setup>,
    pub(crate) key: Value,
    /// The vectors of the key.
    pub(crate) keys: Vec<Vec<f64>>,
    /// Which modes they are, from 1.
    pub(crate) numbers: Vec<usize>,
    /// Those of the model, where the key is in its coordinates.
    pub(crate) modes: Option<Modes>,
    pub(crate) angle: f64,
    pub(crate) digits: u32,
    pub(crate) mistakes: Vec<(usize, Vec<Vec<f64>>, Credit)>,
    pub(crate) data: Vec<Precise>,
    pub(crate) mark: DecimalMark,
}

/// Why shapes are not right.
enum ShapeFault {
    /// These places are wrong.
    Places(Vec<usize>),
    /// They are multiples of one another.
    Dependent,
}

impl Prepared {
    pub(crate) fn width(&self) -> usize {
        self.keys.first().map_or(0, Vec::len)
    }

    /// The vectors of the key in the scale that is asked for.
    fn scaled(&self) -> Vec<Vec<f64>> {
        let scaled = self.keys.iter().map(|vector| {
            let one = match self.setup.scale {
                AskedScale::First => vector[0],
                AskedScale::Any => simple_scale(vector),
                AskedScale::Mass => 1.0,
            };
            vector.iter().map(|value| value / one).collect()
        });
        scaled.collect()
    }

    /// The shapes that are right for the vector at this place.
    fn space(&self, place: usize) -> Vec<Vec<f64>> {
        match (&self.modes, self.numbers.get(place)) {
            (Some(modes), Some(number)) => modes.space(*number),
            // Without a model the vectors of the key span one space.
            _ => self.keys.clone(),
        }
    }

    fn fault(&self, typed: &[Vec<f64>]) -> Option<ShapeFault> {
        let wrong: Vec<usize> = (0..typed.len())
            .filter(|place| !lies_in(&typed[*place], &self.space(*place), self.angle))
            .collect();
        if !wrong.is_empty() {
            return Some(ShapeFault::Places(wrong));
        }
        (!are_independent(typed)).then_some(ShapeFault::Dependent)
    }

    /// Whether vectors are those of a mistake, up to scale, or span the same.
    fn are(&self, given: &[Vec<f64>], typed: &[Vec<f64>]) -> bool {
        given.len() == typed.len()
            && typed
                .iter()
                .all(|vector| lies_in(vector, given, self.angle))
            && are_independent(typed) == are_independent(given)
    }

    /// The scale that is asked, where shapes that are right have another one.
    fn other_scale(&self, typed: &[Vec<f64>]) -> Option<Scaling> {
        let margin = self.angle.max(0.005);
        match self.setup.scale {
            AskedScale::Any => None,
            AskedScale::First => {
                // Half a per cent is what rounding to three figures takes at most.
                let is_one = typed.iter().all(|vector| (vector[0] - 1.0).abs() <= 0.005);
                (!is_one).then_some(Scaling::First)
            }
            AskedScale::Mass => {
                let is_one = typed.iter().enumerate().all(|(place, vector)| {
                    let modal = self
                        .modes
                        .as_ref()
                        .and_then(|modes| modes.modal_mass(vector, *self.numbers.get(place)?));
                    let scale = match modal {
                        Some(mass) => mass.sqrt(),
                        None => length(vector) / length(&self.keys[place]),
                    };
                    (scale - 1.0).abs() <= margin
                });
                (!is_one).then_some(Scaling::Mass)
            }
        }
    }

    /// What shapes are worth that are not right, and what is wrong with them.
    fn slip(&self, typed: &[Vec<f64>], fault: &ShapeFault) -> (Credit, Option<Slip>) {
        let wrong = match fault {
            ShapeFault::Dependent => &[][..],
            ShapeFault::Places(places) => &places[..],
        };
        // Independent right shapes count one by one.
        let right: Vec<Vec<f64>> = (0..typed.len())
            .filter(|place| !wrong.contains(place))
            .map(|place| typed[place].clone())
            .collect();
        let share = Rational::new(independent(&right) as i128, typed.len() as i128);
        let credit = share.and_then(Credit::new).unwrap_or(Credit::NONE);
        if wrong.is_empty() {
            return (credit, Some(Slip::DependentShapes));
        }
        let shapes = wrong
            .iter()
            .filter_map(|place| self.shape(*place, &typed[*place]));
        let shapes: Vec<Shape> = shapes.collect();
        (credit, (!shapes.is_empty()).then_some(Slip::Shapes(shapes)))
    }

    /// What is wrong with one shape.
    fn shape(&self, place: usize, typed: &[f64]) -> Option<Shape> {
        let asked = self.numbers.get(place).copied()?;
        let modes = self.modes.as_ref();
        if let Some(found) = modes.and_then(|modes| modes.of(typed, self.angle)) {
            return Some(Shape::OfMode { found, asked });
        }
        if is_reversed(&self.keys[place], typed, self.angle) {
            return Some(Shape::Reversed);
        }
        (self.keys.len() > 1).then_some(Shape::Wrong(asked))
    }
}

impl Marker for Prepared {
    fn trials(&self) -> Vec<Trial> {
        let mut trials = vec![
            Trial::new(Nature::Unreadable, "up and down"),
            Trial::new(Nature::Unreadable, "(1, 2, 3, 4, 5, 6, 7, 8, 9)"),
        ];
        let shown = |vectors: &[Vec<f64>]| {
            let width = self.width();
            let rows = vectors.iter().enumerate().map(|(row, vector)| {
                let entries = vector.iter().enumerate().map(|(column, number)| {
                    let unit = self.setup.units.get(row * width + column);
                    typed_number(unit.map_or(*number, |unit| unit.of_si(*number)))
                });
                format!("[{}]", entries.collect::<Vec<_>>().join(", "))
            });
            let rows: Vec<String> = rows.collect();
            match &rows[..] {
                [one] => one.clone(),
                many => format!("[{}]", many.join(", ")),
            }
        };
        if self.setup.written == Written::Formula {
            return trials;
        }
        trials.push(Trial::new(Nature::Right, shown(&self.scaled())));
        if self.setup.scale != AskedScale::Any {
            return trials;
        }
        let turned = |share: f64| {
            let mut vectors = self.keys.clone();
            let away = away(&vectors[0], &self.space(0))?;
            let size = length(&vectors[0]) * crate::numerics::tan(share * self.angle);
            for (value, away) in vectors[0].iter_mut().zip(away) {
                *value = -2.0 * (*value + size * away);
            }
            Some(shown(&vectors))
        };
        trials.extend(turned(0.9).map(|text| Trial::new(Nature::Borderline, text)));
        trials.extend(turned(1.2).map(|text| Trial::new(Nature::Wrong, text)));
        trials
    }

    fn key(&self) -> Key {
        let set = |number: f64| Key::rounded(number, self.digits, Unit::ONE, self.mark);
        let shown: Vec<Math> = self.scaled().into_iter().flatten().map(set).collect();
        Key {
            math: typeset(&shown, self.width()),
            accepted: None,
            value: KeyValue::Numbers {
                form: self.key.form(),
                si: self.key.numbers().to_vec(),
            },
        }
    }

    fn echo(&self, response: Passage<'_>) -> Result<Echo, Unreadable> {
        let readings = read(self, response)?.into_iter().map(|own| own.reading);
        Echo::of(readings).ok_or_else(|| Why::ComponentValue.into())
    }

    fn mark(&self, response: Passage<'_>) -> Marking {
        let mut readings = match read(self, response) {
            Ok(readings) => readings,
            Err(why) => return Marking::unreadable(why),
        };
        let mut faults = readings.iter().map(|shapes| self.fault(&shapes.vectors));
        let first = faults.position(|fault| fault.is_none()).unwrap_or(0);
        let Shapes {
            reading,
            vectors: typed,
        } = readings.swap_remove(first);
        if typed.iter().any(|vector| length(vector) == 0.0) {
            return Marking::wrong(reading, Remark::from(Slip::NoMotion));
        }
        let Some(fault) = self.fault(&typed) else {
            return match self.other_scale(&typed) {
                None => Marking::right(reading),
                Some(scale) => {
                    Marking::read(reading, Credit::half(), Remark::from(Slip::Scale(scale)))
                }
            };
        };
        let named = self
            .mistakes
            .iter()
            .find(|(_, given, _)| self.are(given, &typed));
        if let Some((number, _, credit)) = named {
            return Marking::mistake(reading, *number, *credit);
        }
        let (credit, slip) = self.slip(&typed, &fault);
        Marking::read(reading, credit, slip.map(Remark::from))
    }
}

/// Vectors side by side, of this many components each.
pub(crate) fn typeset(entries: &[Math], width: usize) -> Math {
    let mut rows = entries
        .chunks(width.max(1))
        .map(|row| Math::matrix(row.iter().map(|entry| vec![entry.clone()]).collect()));
    let first = rows.next().unwrap_or_else(|| Math::row([]));
    Math::row(std::iter::once(first).chain(rows.flat_map(|row| [Math::punctuation(","), row])))
}
/// The component that is shown as one where any scale will do: the first, or the largest if the first is small.
fn simple_scale(vector: &[f64]) -> f64 {
    // A component near a node has few figures, and dividing by it would pass its rounding on to all others.
    const SMALL: f64 = 0.05;
    let largest = |a: f64, b: &f64| if b.abs() > a.abs() { *b } else { a };
    let largest = vector.iter().fold(0.0, largest);
    match vector.first() {
        Some(first) if first.abs() > SMALL * largest.abs() => *first,
        _ if largest == 0.0 => 1.0,
        _ => largest,
    }
}

/// Whether shapes agree but for signs of components.
fn is_reversed(key: &[f64], typed: &[f64], angle: f64) -> bool {
    let size = |vector: &[f64]| vector.iter().map(|value| value.abs()).collect::<Vec<_>>();
    lies_in(&size(typed), &[size(key)], angle)
}
