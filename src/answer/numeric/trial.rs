//! Numbers that test this kind.

use super::complex::ComplexNumbers;
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

/// Responses that test the marking of real numbers.
pub(crate) fn of_numbers(key: &Numbers) -> Vec<Trial> {
    let shown = |si: f64| with_unit(typed(key.unit.of_si(si)), &key.unit);
    let all = |of: &dyn Fn(usize, &Target) -> f64| {
        let numbers = key.targets.iter().enumerate();
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
        Trial::new(Nature::WrongUnit, format!("7 {}", other_unit(&key.unit))),
        Trial::new(Nature::Unreadable, "a handful"),
        Trial::new(Nature::Unreadable, "7 m or 8 furlong"),
    ];
    // This many figures would cost something.
    if key.ask_digits.is_some() {
        return trials;
    }
    trials.push(Trial::new(Nature::Right, moved(0.0)));
    let half = key.targets.first().map_or(0.0, |target| target.half);
    let is_clear = key.modulo.is_none_or(|period| 3.0 * half < period);
    if half > 0.0 && is_clear {
        trials.push(Trial::new(Nature::Borderline, moved(0.99)));
        trials.push(Trial::new(Nature::Borderline, moved(-0.99)));
        // Of a list another number may be as near.
        if !key.is_list {
            trials.push(Trial::new(Nature::Wrong, moved(1.01)));
            trials.push(Trial::new(Nature::Wrong, moved(-1.01)));
        }
    }
    trials
}

/// Responses that test the marking of complex numbers.
pub(crate) fn of_complex_numbers(key: &ComplexNumbers) -> Vec<Trial> {
    let shown = |re: f64, im: f64| {
        let (re, im) = (key.unit.of_si(re), key.unit.of_si(im));
        let sign = if im < 0.0 { "-" } else { "+" };
        let sum = format!("({} {sign} {}i)", typed(re), typed(im.abs()));
        with_unit(sum, &key.unit)
    };
    let moved = |share: f64| {
        let texts = key.targets.iter().enumerate().map(|(at, target)| {
            let step = if at == 0 { share * target.half } else { 0.0 };
            shown(target.value.re, target.value.im + step)
        });
        texts.collect::<Vec<_>>().join("; ")
    };
    let mut trials = vec![
        Trial::new(Nature::Right, moved(0.0)),
        Trial::new(
            Nature::WrongUnit,
            format!("7 - 2i {}", other_unit(&key.unit)),
        ),
        Trial::new(Nature::Unreadable, "a handful"),
    ];
    if key.targets.first().is_some_and(|target| target.half > 0.0) {
        trials.push(Trial::new(Nature::Borderline, moved(0.99)));
        if !key.is_list {
            trials.push(Trial::new(Nature::Wrong, moved(1.01)));
        }
    }
    trials
}
