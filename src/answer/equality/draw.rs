//! Points around the data of an instance, from a fixed seed: a verdict can be repeated.

use super::super::meaning::{Meaning, ORDERS};
use crate::expr::Precise;
use crate::numerics::pow;
use crate::quantity::Evaluation;

/// Numbers from a fixed seed (SplitMix64).
pub(in crate::answer) struct Draws(u64);

impl Draws {
    pub(in crate::answer) fn new() -> Self {
        Self(0x5eed_0f70_1234_abcd)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        mixed(self.0)
    }

    /// A number from −1 to 1.
    pub(in crate::answer) fn signed(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// A number that looks drawn, from one that does not.
pub(super) fn mixed(mut bits: u64) -> u64 {
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

/// The inputs around the data of an instance.
pub(in crate::answer) struct Around<'a> {
    meaning: &'a Meaning,
    centres: Vec<Option<f64>>,
    draws: Draws,
}

impl<'a> Around<'a> {
    pub(in crate::answer) fn new(meaning: &'a Meaning, evaluation: &Evaluation<'_>) -> Self {
        let centres = (0..meaning.inputs.len())
            .map(|place| meaning.value(place, evaluation))
            .collect();
        Self {
            meaning,
            centres,
            draws: Draws::new(),
        }
    }

    /// A point within `spread` decades of the data; data keep their sign unless `flips`, and pure whole data stay whole
    /// if asked for.
    pub(in crate::answer) fn point(
        &mut self,
        spread: f64,
        flips: bool,
        keeps_whole: bool,
    ) -> Vec<Precise> {
        let mut point = Vec::with_capacity(self.centres.len() * ORDERS);
        for (input, centre) in self.meaning.inputs.iter().zip(&self.centres) {
            for order in 0..ORDERS {
                if order > 0 && !input.is_moving {
                    point.push(Precise::exact(0.0));
                    continue;
                }
                let size = centre.map_or(0.6, f64::abs);
                let size = if size == 0.0 { 1.0 } else { size };
                let mut value = size * pow(10.0, spread * self.draws.signed());
                let is_negative = match centre {
                    Some(centre) if !(flips && input.is_signed) => *centre < 0.0,
                    _ => input.is_signed && self.draws.signed() < 0.0,
                };
                if keeps_whole && centre.is_some_and(|centre| centre == centre.round()) {
                    value = value.round().max(1.0);
                }
                point.push(Precise::exact(if is_negative { -value } else { value }));
            }
        }
        point
    }
}
