//! Marks general solutions: by the equations, then by what their constants can reach.

use std::sync::Arc;

use super::Setup;
use super::constants::{are_factors_and_phases, rank, vanishes};
use super::equations::satisfies;
use super::read::read;
use super::solution::{TypedSolution, used};
use crate::answer::{
    Answered, Credit, Key, Marker, Marking, Nature, Note, Reading, Remark, Slip, Trial, Why,
};
use crate::expr::{Expr, Function, Name, Precise};
use crate::math::Math;
use crate::numerics::Rational;
use crate::response::Passage;
use crate::unit::Decimal;

/// Constants that a response may use: a few more than are needed.
const MAX_USED: usize = 16;

/// A prepared key.
pub(crate) struct Prepared {
    pub(crate) setup: Arc<Setup>,
    pub(crate) data: Vec<Precise>,
    /// Frequencies, and for each the shape of its mode.
    pub(crate) modes: Vec<(f64, Vec<f64>)>,
}

impl Prepared {
    /// The data with values for constants and time.
    pub(crate) fn point(&self, constants: &[f64], time: f64) -> Vec<Precise> {
        let mut point = self.data.clone();
        let setup = &self.setup;
        for (slot, value) in setup.slots.iter().zip(constants) {
            point[*slot] = Precise::exact(*value);
        }
        if let Some(slot) = setup.slot(&Name::new("t")) {
            point[slot] = Precise::exact(time);
        }
        point
    }

    /// Times at which solutions are looked at.
    pub(crate) fn times(&self) -> Vec<f64> {
        let slowest = self
            .modes
            .iter()
            .map(|(frequency, _)| *frequency)
            .filter(|frequency| *frequency > 0.0);
        let period = std::f64::consts::TAU / slowest.fold(f64::INFINITY, f64::min);
        let span = if period.is_finite() && period > 0.0 {
            2.0 * period
        } else {
            10.0
        };
        (0..16)
            // None of them is a simple share of the period, at which sines vanish or meet cosines.
            .map(|place| span * (f64::from(place) + 0.37) / 16.0)
            .collect()
    }

    /// The solution of the key as a formula of each coordinate.
    fn written(&self) -> Vec<(Math, String)> {
        let setup = &self.setup;
        let number = |value: f64| {
            let digits =
                Decimal::rounded(value, 4).and_then(|decimal| Decimal::shortest(decimal.to_f64()));
            digits.and_then(|digits| Rational::from_decimal(&digits.to_string()))
        };
        let component = |place: usize| {
            let mut sum = Expr::number(0);
            for (mode, (frequency, shape)) in self.modes.iter().enumerate() {
                let largest = shape
                    .iter()
                    .copied()
                    .fold(0.0_f64, |a, b| if b.abs() > a.abs() { b } else { a });
                let Some(weight) = number(shape[place] / largest) else {
                    continue;
                };
                let constant = |letter: &str| Expr::name(format!("{letter}{}", mode + 1).as_str());
                let time = Expr::name("t");
                let motion = match number(*frequency) {
                    Some(frequency) if !frequency.is_zero() => {
                        let angle = Expr::number(frequency) * time;
                        let of = |function| Expr::call(function, [angle.clone()]);
                        constant("A") * of(Function::Cos) + constant("B") * of(Function::Sin)
                    }
                    _ => constant("A") + constant("B") * time,
                };
                sum = sum + Expr::number(weight) * motion;
            }
            sum
        };
        let both = (0..setup.coordinates.len()).map(|place| {
            let formula = component(place);
            let math = Math::row([
                setup.symbols[place].clone(),
                Math::relation("="),
                formula.typeset(&setup.lexicon),
            ]);
            (math, format!("{} = {formula}", setup.coordinates[place]))
        });
        both.collect()
    }
}

impl Marker for Prepared {
    fn trials(&self) -> Vec<Trial> {
        let solution: Vec<String> = self.written().into_iter().map(|(_, text)| text).collect();
        let mut still = solution.clone();
        if let (Some(first), Some(name)) = (still.first_mut(), self.setup.coordinates.first()) {
            *first = format!("{name} = A1");
        }
        vec![
            Trial::new(Nature::Right, solution.join("; ")),
            Trial::new(Nature::Wrong, still.join("; ")),
            Trial::new(Nature::Unreadable, "A cos("),
        ]
    }

    fn key(&self) -> Key {
        let (lines, texts): (Vec<_>, Vec<_>) = self.written().into_iter().unzip();
        // A line each: side by side, two motions of two modes are wider than a page.
        let math = if lines.len() > 1 {
            let row = |line| vec![Math::row(Vec::new()), line];
            Math::aligned(lines.into_iter().map(row).collect())
        } else {
            Math::row(lines)
        };
        Key::formula(texts.join("; "), math)
    }

    fn mark(&self, response: Passage<'_>) -> Marking {
        let setup = &self.setup;
        let typed = match read(setup, response) {
            Ok(typed) => typed,
            Err(why) => return Marking::unreadable(why),
        };
        let mut row = Vec::new();
        for (symbol, formula) in setup.symbols.iter().zip(&typed) {
            if !row.is_empty() {
                row.push(Math::punctuation(";"));
            }
            row.extend([
                symbol.clone(),
                Math::relation("="),
                formula.typeset(&setup.lexicon),
            ]);
        }
        let texts = setup.coordinates.iter().zip(&typed);
        let reading = Reading {
            math: Math::row(row),
            text: texts
                .map(|(name, formula)| format!("{name} = {formula}"))
                .collect::<Vec<_>>()
                .join("; "),
            answered: Answered::Functions(typed.clone()),
        };
        let wrong = |reading, slip: Slip| Marking::wrong(reading, Remark::from(slip));
        let needed = 2 * setup.coordinates.len();
        let found = used(setup, &typed).len();
        if found > MAX_USED {
            return Marking::unreadable(Why::TooManyConstants {
                most: MAX_USED,
                needed,
            });
        }
        let mut solutions = match TypedSolution::all(setup, &typed) {
            Ok(solutions) => solutions,
            Err(why) => return Marking::unreadable(why),
        };
        // Of a sum of conjugates nothing is imaginary.
        if solutions.len() > 1 && vanishes(self, &solutions[1], &solutions[0]) {
            solutions.truncate(1);
        }
        for solution in &solutions {
            match satisfies(self, solution) {
                None => return wrong(reading, Slip::NoValueAtTimes),
                Some(false) => return wrong(reading, Slip::Unsatisfied),
                Some(true) => {}
            }
        }
        if rank(self, &solutions).is_none_or(|rank| rank < needed * solutions.len()) {
            let slip = if found < needed {
                Slip::TooFewConstants { found, needed }
            } else {
                Slip::NotGeneral
            };
            return wrong(reading, slip);
        }
        if !solutions
            .iter()
            .all(|solution| are_factors_and_phases(self, solution))
        {
            return wrong(reading, Slip::NotFactors);
        }
        let note = (found > needed).then_some(Note::ConstantsToSpare { needed, found });
        Marking::read(reading, Credit::FULL, note.map(Remark::from))
    }
}
