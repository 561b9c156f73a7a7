//! Numbers that test this kind.

use super::complex;
use super::marker::Numbers;
use super::target::Target;
use crate::answer::trial::{Nature, Trial, other_unit, typed};
use crate::unit::Unit;

fn with_unit(number: String, unit: &Unit) -> String {
    if unit.is_one() {
        number
    } else {
        format!("{number} {unit}")
    }
}

impl Numbers {
    pub(crate) fn made_up(&self) -> Vec<Trial> {
        let shown = |si: f64| with_unit(typed(self.unit.of_si(si)), &self.unit);
        let all = |of: &dyn Fn(usize, &Target) -> f64| {
            let numbers = self.targets.iter().enumerate();
            let texts: Vec<String> = numbers.map(|(at, target)| shown(of(at, target))).collect();
            texts.join("; ")
        };
        let moved = |share: f64| {
            all(&|at, target| {
                let step = if at == 0 { share * target.half } else { 0.0 };
                target.value + step
            })
        };
        let mut trials = vec![
            Trial::new(Nature::WrongUnit, format!("7 {}", other_unit(&self.unit))),
            Trial::new(Nature::Unreadable, "about seven"),
            Trial::new(Nature::Unreadable, "7 m or 8 furlong"),
        ];
        // This many figures would cost something.
        if self.ask_digits.is_some() {
            return trials;
        }
        trials.push(Trial::new(Nature::Right, moved(0.0)));
        let half = self.targets.first().map_or(0.0, |target| target.half);
        let is_clear = self.modulo.is_none_or(|period| 3.0 * half < period);
        if half > 0.0 && is_clear {
            trials.push(Trial::new(Nature::Borderline, moved(0.99)));
            trials.push(Trial::new(Nature::Borderline, moved(-0.99)));
            // Of a list another number may be as near.
            if !self.is_list {
                trials.push(Trial::new(Nature::Wrong, moved(1.01)));
                trials.push(Trial::new(Nature::Wrong, moved(-1.01)));
            }
        }
        trials
    }
}

impl complex::Numbers {
    pub(crate) fn made_up(&self) -> Vec<Trial> {
        let shown = |re: f64, im: f64| {
            let (re, im) = (self.unit.of_si(re), self.unit.of_si(im));
            let sign = if im < 0.0 { "-" } else { "+" };
            let sum = format!("({} {sign} {}i)", typed(re), typed(im.abs()));
            with_unit(sum, &self.unit)
        };
        let moved = |share: f64| {
            let texts = self.targets.iter().enumerate().map(|(at, target)| {
                let step = if at == 0 { share * target.half } else { 0.0 };
                shown(target.value.re, target.value.im + step)
            });
            texts.collect::<Vec<_>>().join("; ")
        };
        let mut trials = vec![
            Trial::new(Nature::Right, moved(0.0)),
            Trial::new(
                Nature::WrongUnit,
                format!("7 - 2i {}", other_unit(&self.unit)),
            ),
            Trial::new(Nature::Unreadable, "seven"),
        ];
        if self.targets.first().is_some_and(|target| target.half > 0.0) {
            trials.push(Trial::new(Nature::Borderline, moved(0.99)));
            if !self.is_list {
                trials.push(Trial::new(Nature::Wrong, moved(1.01)));
            }
        }
        trials
    }
}
