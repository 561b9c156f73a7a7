//! Marks shapes: each in the space of its mode, those of one frequency independent.

use std::sync::Arc;

use super::modes::Modes;
use super::read::Shapes;
use super::span::{are_independent, away, independent, length, lies_in};
use super::{Scale, Setup};
use crate::answer::matrix::Written;
use crate::answer::trial::typed as typed_number;
use crate::answer::{Credit, Feedback, Key, KeyValue, Marker, Marking, Nature, Reason, Trial};
use crate::expr::{Precise, Value};
use crate::math::Math;
use crate::numerics::Rational;
use crate::unit::{Decimal, DecimalMark, Quantity, Unit};

/// A prepared key.
pub(super) struct Prepared {
    pub(super) setup: Arc<Setup>,
    pub(super) key: Value,
    /// The vectors of the key.
    pub(super) keys: Vec<Vec<f64>>,
    /// Which modes they are, from 1.
    pub(super) numbers: Vec<usize>,
    /// Those of the model, where the key is in its coordinates.
    pub(super) modes: Option<Modes>,
    pub(super) angle: f64,
    pub(super) digits: u32,
    pub(super) mistakes: Vec<(usize, Vec<Vec<f64>>, Credit)>,
    pub(super) data: Vec<Precise>,
    pub(super) mark: DecimalMark,
}

/// Why shapes are not right.
enum Fault {
    /// These places are wrong.
    Places(Vec<usize>),
    /// They are multiples of one another.
    Dependent,
}

impl Prepared {
    pub(super) fn width(&self) -> usize {
        self.keys.first().map_or(0, Vec::len)
    }

    /// The vectors of the key in the scale that is asked for.
    fn scaled(&self) -> Vec<Vec<f64>> {
        let scaled = |vector: &Vec<f64>| {
            let one = match self.setup.scale {
                Scale::First => vector[0],
                Scale::Any => simple_scale(vector),
                Scale::Mass => 1.0,
            };
            vector.iter().map(|value| value / one).collect()
        };
        self.keys.iter().map(scaled).collect()
    }

    /// The shapes that are right for the vector at this place.
    fn space(&self, place: usize) -> Vec<Vec<f64>> {
        match (&self.modes, self.numbers.get(place)) {
            (Some(modes), Some(number)) => modes.space(*number),
            // Without a model the vectors of the key span one space.
            _ => self.keys.clone(),
        }
    }

    fn fault(&self, typed: &[Vec<f64>]) -> Option<Fault> {
        let wrong: Vec<usize> = (0..typed.len())
            .filter(|place| !lies_in(&typed[*place], &self.space(*place), self.angle))
            .collect();
        if !wrong.is_empty() {
            return Some(Fault::Places(wrong));
        }
        (!are_independent(typed)).then_some(Fault::Dependent)
    }

    /// Whether vectors are those of a mistake, up to scale, or span the same.
    fn are(&self, given: &[Vec<f64>], typed: &[Vec<f64>]) -> bool {
        given.len() == typed.len()
            && typed
                .iter()
                .all(|vector| lies_in(vector, given, self.angle))
            && are_independent(typed) == are_independent(given)
    }

    /// What is wrong with the scale of shapes that are right.
    fn scale_trouble(&self, typed: &[Vec<f64>]) -> Option<&'static str> {
        let margin = self.angle.max(0.005);
        match self.setup.scale {
            Scale::Any => None,
            Scale::First => {
                let is_one = typed.iter().all(|vector| (vector[0] - 1.0).abs() <= 0.005);
                (!is_one)
                    .then_some("The shape is right; scale it so that its first component is 1.")
            }
            Scale::Mass => {
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
                (!is_one).then_some("The shape is right; scale it so that its modal mass is 1.")
            }
        }
    }

    /// What is said about shapes that are not right, and their credit.
    fn told(&self, typed: &[Vec<f64>], fault: &Fault) -> (Reason, Credit, Option<String>) {
        let (wrong, words) = match fault {
            Fault::Dependent => (
                &[][..],
                "These shapes are multiples of one another; independent ones are asked.",
            ),
            Fault::Places(places) => (&places[..], ""),
        };
        // Independent right shapes count one by one.
        let right: Vec<Vec<f64>> = (0..typed.len())
            .filter(|place| !wrong.contains(place))
            .map(|place| typed[place].clone())
            .collect();
        let share = Rational::new(independent(&right) as i128, typed.len() as i128);
        let credit = share.and_then(Credit::new).unwrap_or(Credit::NONE);
        if wrong.is_empty() {
            return (Reason::Other, credit, Some(words.to_owned()));
        }
        let sentences: Vec<String> = wrong
            .iter()
            .filter_map(|place| self.sentence(*place, &typed[*place]))
            .collect();
        let is_reversed = wrong
            .iter()
            .all(|place| is_reversed(&self.keys[*place], &typed[*place], self.angle));
        let reason = if is_reversed {
            Reason::Sign
        } else {
            Reason::Other
        };
        let words = (!sentences.is_empty()).then(|| sentences.join(" "));
        (reason, credit, words)
    }

    fn sentence(&self, place: usize, typed: &[f64]) -> Option<String> {
        let number = self.numbers.get(place).copied()?;
        let other = self
            .modes
            .as_ref()
            .and_then(|modes| modes.of(typed, self.angle));
        if let Some(other) = other {
            return Some(format!(
                "This is the shape of mode {other}, not of mode {number}; the modes count from the lowest frequency."
            ));
        }
        if is_reversed(&self.keys[place], typed, self.angle) {
            return Some(
                "The magnitudes fit, but look again at which parts move against each other."
                    .to_owned(),
            );
        }
        (self.keys.len() > 1).then(|| format!("The shape of mode {number} is wrong."))
    }

    pub(super) fn typeset(entries: &[Math], width: usize) -> Math {
        let mut rows = entries
            .chunks(width.max(1))
            .map(|row| Math::matrix(row.iter().map(|entry| vec![entry.clone()]).collect()));
        let first = rows.next().unwrap_or_else(|| Math::row([]));
        Math::row(std::iter::once(first).chain(rows.flat_map(|row| [Math::punctuation(","), row])))
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
        if self.setup.scale != Scale::Any {
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
        let set = |number: f64| match Decimal::rounded(number, self.digits) {
            Some(decimal) => Quantity::new(decimal, Unit::ONE).math(self.mark),
            None => Math::text("out of range"),
        };
        let shown: Vec<Math> = self.scaled().into_iter().flatten().map(set).collect();
        Key {
            math: Self::typeset(&shown, self.width()),
            accepted: None,
            value: KeyValue::Numbers {
                form: self.key.form(),
                si: self.key.numbers().to_vec(),
            },
        }
    }

    fn mark(&self, response: &str) -> Marking {
        let mut readings = match self.read(response) {
            Ok(readings) => readings,
            Err(words) => return Marking::unreadable(words),
        };
        let is_sound = |shapes: &Shapes| self.fault(&shapes.vectors).is_none();
        let first = readings.iter().position(is_sound).unwrap_or(0);
        let Shapes {
            reading,
            vectors: typed,
        } = readings.swap_remove(first);
        let say = |words: &str| Some(Feedback::Words(words.to_owned()));
        if typed.iter().any(|vector| length(vector) == 0.0) {
            let words = say("A shape with all components zero is no motion.");
            return Marking::read(reading, Credit::NONE, Reason::Other, words);
        }
        let Some(fault) = self.fault(&typed) else {
            return match self.scale_trouble(&typed) {
                None => Marking::read(reading, Credit::FULL, Reason::Matches, None),
                Some(words) => Marking::read(reading, half(), Reason::Scale, say(words)),
            };
        };
        let named = self
            .mistakes
            .iter()
            .find(|(_, given, _)| self.are(given, &typed));
        if let Some((number, _, credit)) = named {
            let feedback = Some(Feedback::Mistake(*number));
            return Marking::read(reading, *credit, Reason::Mistake(*number), feedback);
        }
        let (reason, credit, words) = self.told(&typed, &fault);
        Marking::read(reading, credit, reason, words.map(Feedback::Words))
    }
}

/// What a right shape in another scale than the one that is asked is worth.
fn half() -> Credit {
    let half = Rational::new(1, 2).and_then(Credit::new);
    half.unwrap_or(Credit::NONE)
}

/// The component that is shown as one where any scale will do: the first, or the largest if the first is small.
fn simple_scale(vector: &[f64]) -> f64 {
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
