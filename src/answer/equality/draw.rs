//! Points around data, from a fixed seed: a verdict can be repeated.

use super::domain::Condition;
use crate::answer::meaning::{Meaning, ORDERS};
use crate::expr::{Approx, Precise, Registers};
use crate::numerics::exp;

/// Numbers from a fixed seed (SplitMix64).
#[derive(Clone, Debug)]
pub(crate) struct Draws(u64);

impl Draws {
    pub(crate) fn new() -> Self {
        Self(0x5eed_0f70_1234_abcd)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        mixed(self.0)
    }

    /// A number from −1 to 1.
    pub(crate) fn signed(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// A number that looks drawn, from one that does not.
pub(crate) fn mixed(mut bits: u64) -> u64 {
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

/// What does not vary freely in the domain of an item.
#[derive(Debug)]
pub(crate) struct Ties {
    /// By input, whether it is an integer.
    pub(crate) are_integers: Vec<bool>,
    /// Whether a constraint says that something equals something else.
    pub(crate) is_some_equal: bool,
}

/// The inputs around some data, inside the domain of the item.
pub(crate) struct Around<'a> {
    meaning: &'a Meaning,
    centres: Vec<Option<f64>>,
    /// The conditions that the data meet themselves; those of a source need not meet all.
    conditions: Vec<&'a Condition>,
    state: State,
    room: Registers<Approx<f64>>,
}

/// What the next point depends on.
#[derive(Clone, Debug)]
pub(crate) struct State {
    draws: Draws,
    /// The integers at the points so far, by input.
    integers: Vec<(usize, f64)>,
}

impl State {
    pub(crate) fn new() -> Self {
        Self {
            draws: Draws::new(),
            integers: Vec::new(),
        }
    }
}

/// Most points with the same integer. A constraint that favours few cycles would leave the points at n = 1 alone, where
/// nothing says how a formula depends on n, or at n = 2, where n² is 2n.
const MAX_ALIKE: usize = 3;
/// Below this width of the draws, in decades, nothing else is to be had.
const NARROW: f64 = 0.2;

impl<'a> Around<'a> {
    /// Around these values of the inputs; one without a value may be anything.
    pub(crate) fn new(meaning: &'a Meaning, centres: Vec<Option<f64>>) -> Self {
        let (data, mut room) = (Meaning::slots(&centres), Registers::default());
        let conditions = meaning.conditions().iter();
        let met = conditions.filter(|condition| condition.holds(&data, &mut room));
        Self {
            meaning,
            centres,
            conditions: met.collect(),
            state: State::new(),
            room,
        }
    }

    /// What the next point depends on.
    pub(crate) fn state(&mut self) -> &mut State {
        &mut self.state
    }

    /// The inputs that do not vary freely: integers, and what equals something else; none where nothing is equal.
    pub(crate) fn ties(&self) -> Ties {
        let inputs = self.meaning.inputs.iter();
        Ties {
            are_integers: inputs.map(|input| input.is_integer).collect(),
            is_some_equal: self.conditions.iter().any(|own| own.is_solved()),
        }
    }

    /// A point within `spread` decades of the data, if it lies in the domain. Data keep their sign unless one that is
    /// positive `flips`; those that are integers by their meaning stay integers, and all that seem whole if asked for.
    pub(crate) fn point(
        &mut self,
        spread: f64,
        flips: bool,
        keeps_whole: bool,
    ) -> Option<Vec<Precise>> {
        let mut point = self.drawn(spread, flips, keeps_whole, None);
        for condition in &self.conditions {
            condition.solve(&mut point, &mut self.room)?;
        }
        let mut conditions = self.conditions.iter();
        let holds = conditions.all(|condition| condition.holds(&point, &mut self.room));
        if !holds {
            return None;
        }
        let inputs = self.meaning.inputs.iter().enumerate();
        let integers = inputs.filter(|(_, input)| input.is_integer);
        let own: Vec<(usize, f64)> = integers
            .map(|(place, _)| (place, point[place * ORDERS].high()))
            .collect();
        let mut counts = own.iter().map(|own| {
            let integers = self.state.integers.iter();
            integers.filter(|other| *other == own).count()
        });
        // Later draws are nearer to the data, at last where the integers are those of the instance.
        if spread > NARROW && counts.any(|count| count >= MAX_ALIKE) {
            return None;
        }
        self.state.integers.extend(own);
        Some(point)
    }

    /// A point within `spread` decades of the data, wherever that is.
    pub(crate) fn free_point(&mut self, spread: f64) -> Vec<Precise> {
        self.drawn(spread, false, false, None)
    }

    /// A point within `spread` decades of the data that differs from another in all but its data.
    pub(crate) fn point_beside(&mut self, other: &[Precise], spread: f64) -> Vec<Precise> {
        self.drawn(spread, false, false, Some(other))
    }

    fn drawn(
        &mut self,
        spread: f64,
        flips: bool,
        keeps_whole: bool,
        beside: Option<&[Precise]>,
    ) -> Vec<Precise> {
        let widest = spread * std::f64::consts::LN_10;
        let mut point = Vec::with_capacity(self.centres.len() * ORDERS);
        for (input, centre) in self.meaning.inputs.iter().zip(&self.centres) {
            let held = beside.filter(|_| input.is_datum());
            for order in 0..ORDERS {
                if order > 0 && !input.is_moving {
                    point.push(Precise::exact(0.0));
                    continue;
                }
                let size = centre.map_or(0.6, f64::abs);
                // What is zero on the sheet may be anything, but near the sheet it is near zero.
                let near_zero = if spread > 0.0 { spread.min(1.0) } else { 1.0 };
                let size = if size == 0.0 { near_zero } else { size };
                // Drawn also where it is not taken, so that what is drawn after it stays.
                let share = self.state.draws.signed();
                let is_negative = match centre {
                    Some(centre) if *centre < 0.0 => true,
                    Some(centre) if *centre > 0.0 && !flips => false,
                    _ => input.is_signed && self.state.draws.signed() < 0.0,
                };
                if let Some(other) = held {
                    point.push(other[point.len()]);
                    continue;
                }
                let mut value = size * exp(widest * share);
                let seems_whole = || keeps_whole && centre.is_some_and(|own| own == own.round());
                if input.is_integer || seems_whole() {
                    value = value.round().max(1.0);
                }
                point.push(Precise::exact(if is_negative { -value } else { value }));
            }
        }
        point
    }
}
