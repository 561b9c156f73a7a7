//! Slips that a number alone gives away: 2π, a sign, degrees, a power of ten.

use std::f64::consts::TAU;

use super::super::Reason;
use super::marker::Numbers;
use super::target::{Typed, pair};
use crate::numerics::{Dd, powi};
use crate::unit::{Dimension, Unit};

/// A degree in radians.
const DEGREE: f64 = TAU / 360.0;

impl Numbers {
    /// A slip that the numbers alone give away; `unit` is what was typed.
    pub(super) fn slip(&self, typed: &[Typed], unit: &Unit) -> (Reason, Option<String>) {
        let is_zero = self.targets.iter().all(|target| target.value == 0.0);
        let fits = |factor: f64| {
            let scaled: Vec<Typed> = typed
                .iter()
                .map(|typed| *typed * Dd::from(factor))
                .collect();
            let found = pair(&self.targets, &scaled, self.modulo, self.is_ordered);
            !is_zero && typed.len() == self.targets.len() && found == typed.len()
        };
        // Of a large number little is left within a turn, and that fits by chance.
        let fits_within_turn = |factor: f64| {
            let is_within = |typed: &Typed| {
                self.modulo
                    .is_none_or(|period| (typed.hi() * factor).abs() <= period)
            };
            typed.iter().all(is_within) && fits(factor)
        };
        let counts = self.unit.dimension() == Dimension::TIME.inverse();
        if counts && (fits(TAU) || fits(1.0 / TAU)) {
            return (Reason::TwoPi, Some(self.two_pi(unit)));
        }
        if fits(-1.0) {
            let words = match self.modulo {
                None => "The magnitude fits, the sign does not.",
                Some(_) => "The angle fits with the other sign.",
            };
            return (Reason::Sign, Some(words.to_owned()));
        }
        let asked = self.unit.text();
        let is_angle = asked.contains("rad") || asked.contains('°');
        if is_angle && (fits_within_turn(DEGREE) || fits_within_turn(1.0 / DEGREE)) {
            let words = format!(
                "The number fits in another unit of angle, not in {}.",
                shown(unit, &self.unit)
            );
            return (Reason::AngleUnit, Some(words));
        }
        let is_percent = self.unit.is_one() && unit.is_one() && fits(0.01);
        if is_percent {
            let words = "The digits fit: a value in percent needs its sign, `%`.";
            return (Reason::PowerOfTen, Some(words.to_owned()));
        }
        let fits_ten = |power| fits(powi(10.0, power)) || fits(powi(10.0, -power));
        if self.modulo.is_none() && (1..=9).any(fits_ten) {
            let words = "The digits fit, the power of ten does not: check the prefixes.";
            return (Reason::PowerOfTen, Some(words.to_owned()));
        }
        if let ([target], [typed]) = (&self.targets[..], typed)
            && target.distance(*typed, self.modulo) <= 3.0 * target.half
        {
            let words = "Close, but outside the tolerance: keep one more figure in the steps.";
            return (Reason::Near, Some(words.to_owned()));
        }
        (Reason::Other, None)
    }

    /// What is said of a factor 2π.
    fn two_pi(&self, typed: &Unit) -> String {
        let is_angular = |unit: &Unit| unit.text().contains("rad");
        let is_frequency = |unit: &Unit| is_angular(unit) || unit.counts_cycles();
        if is_frequency(&self.unit) || !is_frequency(typed) {
            return "A factor 2π slipped: an angular frequency ω in rad/s is 2π times the frequency f in Hz."
                .to_owned();
        }
        format!(
            "A factor 2π slipped: `{}` counts cycles, what is asked is in {}.",
            typed.text(),
            self.unit.text()
        )
    }
}

/// The unit that was typed, or the one that was asked for.
fn shown(typed: &Unit, asked: &Unit) -> String {
    if typed.is_one() {
        asked.text()
    } else {
        typed.text()
    }
}

/// Whether a joule was typed for a moment.
pub(super) fn mixes_energy_and_moment(typed: &Unit, asked: &Unit) -> bool {
    let is_joule = |unit: &Unit| unit.text().ends_with('J');
    let is_moment = |unit: &Unit| unit.text().contains('N') && !unit.text().contains('J');
    typed.dimension() == asked.dimension() && is_joule(typed) && is_moment(asked)
}
