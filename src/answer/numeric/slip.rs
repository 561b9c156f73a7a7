//! Slips that a number alone gives away: 2π, a sign, degrees, a power of ten.

use std::f64::consts::TAU;

use super::super::Reason;
use super::marker::Numbers;
use super::target::{Target, Typed};
use crate::numerics::Dd;
use crate::unit::{Quantity, Unit};

impl Numbers {
    /// A slip that the number alone gives away.
    pub(super) fn slip(
        &self,
        target: &Target,
        typed: Typed,
        quantity: &Quantity,
    ) -> (Reason, Option<String>) {
        let fits = |factor: f64| {
            target.value != 0.0 && target.accepts(typed * Dd::from(factor), self.modulo)
        };
        let counts = self.unit.dimension() == crate::unit::Dimension::TIME.inverse();
        if counts && (fits(TAU) || fits(1.0 / TAU)) {
            let words = "A factor 2π slipped: an angular frequency ω in rad/s is 2π times the frequency f in Hz.";
            return (Reason::TwoPi, Some(words.to_owned()));
        }
        if self.modulo.is_none() && fits(-1.0) {
            return (
                Reason::Sign,
                Some("The magnitude fits, the sign does not.".to_owned()),
            );
        }
        let is_angle = !self.unit.is_one() && self.unit.dimension().is_pure();
        let degree = TAU / 360.0;
        if is_angle && (fits(degree) || fits(1.0 / degree)) {
            let words = format!(
                "The number fits in another unit of angle, not in {}.",
                shown(&quantity.unit, &self.unit)
            );
            return (Reason::AngleUnit, Some(words));
        }
        if (1..=9).any(|power| {
            fits(crate::numerics::powi(10.0, power)) || fits(crate::numerics::powi(10.0, -power))
        }) {
            return (
                Reason::PowerOfTen,
                Some("The digits fit, the power of ten does not: check the prefixes.".to_owned()),
            );
        }
        if target.distance(typed, self.modulo) <= 3.0 * target.half {
            return (
                Reason::Near,
                Some(
                    "Close, but outside the tolerance: keep one more figure in the steps."
                        .to_owned(),
                ),
            );
        }
        (Reason::Other, None)
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
