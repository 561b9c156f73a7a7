//! Points that are drawn once for all instances of an item.
//!
//! Whether two formulas are the same is no matter of the data on a sheet, so they are compared around data that stand for
//! all sheets of an item; only the signs are those of the sheet, since what is negative there stays so. What is drawn
//! depends on the names of an item and its constraints, not on a key; most draws break a constraint. Parts whose answers
//! are made of the same names take their points from the same draws, in the same order.

use std::cell::LazyCell;
use std::cmp::Ordering;
use std::sync::{Arc, Mutex, PoisonError};

use super::draw::{Around, State};
use super::{MAX_DRAWS, WIDEST};
use crate::answer::Context;
use crate::answer::meaning::{Input, Meaning};
use crate::expr::Precise;
use crate::quantity::Evaluation;

/// Patterns of signs for which something is kept: the data of a bank have one or two, and what a manifest claims is not
/// to fill the memory.
const MAX_KEPT: usize = 16;
/// Draws that are kept for an item, by the names of its answers and the signs of their data.
const MAX_DRAWN: usize = 64;

/// By input, how its datum compares with zero; none without a datum. Nothing else of an instance counts where formulas are
/// compared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Signs(Vec<Option<Ordering>>);

impl Signs {
    /// Those of data, by input.
    pub(crate) fn of(data: &[Option<f64>]) -> Self {
        let signs = data.iter().map(|value| value.as_ref()?.partial_cmp(&0.0));
        Self(signs.collect())
    }
}

/// What follows from the signs of the data, made once for each pattern of them.
#[derive(Debug)]
pub(crate) struct BySigns<T>(Mutex<Vec<(Signs, Arc<T>)>>);

impl<T> Default for BySigns<T> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<T> BySigns<T> {
    /// The value for these signs.
    fn get(&self, signs: &Signs, make: impl FnOnce() -> T) -> Arc<T> {
        // A panic elsewhere leaves the values as they were: each is added whole.
        let mut kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, value)) = kept.iter().find(|(own, _)| own == signs) {
            return Arc::clone(value);
        }
        let value = Arc::new(make());
        if kept.len() < MAX_KEPT {
            kept.push((signs.clone(), Arc::clone(&value)));
        }
        value
    }

    /// The value for these signs; made anew where formulas of a student stand in for the key.
    pub(crate) fn kept(
        &self,
        signs: &Signs,
        context: &Context<'_>,
        make: impl FnOnce() -> T,
    ) -> Arc<T> {
        if context.standing.is_empty() {
            self.get(signs, make)
        } else {
            Arc::new(make())
        }
    }
}

/// The draws for an item, made as parts ask for them.
#[derive(Debug, Default)]
pub struct Drawn(Mutex<Vec<Draw>>);

/// The draws for some names and some signs of their data.
#[derive(Debug)]
struct Draw {
    inputs: Vec<Input>,
    signs: Signs,
    /// What the points lie around.
    centres: Vec<Option<f64>>,
    /// By attempt; none where the draw broke a constraint.
    points: Vec<Option<Arc<[Precise]>>>,
    /// What the next attempt goes on from.
    state: State,
}

/// What the formulas of an item are compared at.
pub struct Sampling<'t> {
    drawn: &'t Drawn,
    /// Data that stand for those of all instances.
    typical: LazyCell<Evaluation<'t>, Box<dyn FnOnce() -> Evaluation<'t> + 't>>,
}

impl<'t> Sampling<'t> {
    /// With the draws that an item keeps, and data that stand for those of all its instances; they are made where there
    /// are no draws yet.
    pub fn new(drawn: &'t Drawn, typical: impl FnOnce() -> Evaluation<'t> + 't) -> Self {
        Self {
            drawn,
            typical: LazyCell::new(Box::new(typical)),
        }
    }

    /// Typical data with these signs.
    pub(crate) fn centres(&self, meaning: &Meaning, signs: &Signs) -> Vec<Option<f64>> {
        let typical = meaning.values(&self.typical).into_iter();
        let centres = typical.zip(&signs.0).map(|(typical, sign)| {
            let sign = f64::from(i32::from((*sign)? as i8));
            // Of a datum that is zero on the typical sheet nothing says how large it may be.
            let size = typical.filter(|size| *size != 0.0).map_or(1.0, f64::abs);
            Some(sign * size)
        });
        centres.collect()
    }

    /// Hands out draws, nearer and nearer to typical data, until `take` has enough; what the draws after all of them go on
    /// from is left in what is returned.
    pub(crate) fn around<'a>(
        &self,
        meaning: &'a Meaning,
        signs: &Signs,
        mut take: impl FnMut(&Arc<[Precise]>) -> bool,
    ) -> Around<'a> {
        let mut all = self.drawn.0.lock().unwrap_or_else(PoisonError::into_inner);
        let mut draws = all.iter();
        let place = draws.position(|own| own.inputs == meaning.inputs && own.signs == *signs);
        let mut own = match place {
            Some(place) => all.swap_remove(place),
            None => Draw {
                inputs: meaning.inputs.clone(),
                signs: signs.clone(),
                centres: self.centres(meaning, signs),
                points: Vec::new(),
                state: State::new(),
            },
        };
        let mut around = Around::new(meaning, own.centres.clone());
        std::mem::swap(around.state(), &mut own.state);
        for attempt in 0..MAX_DRAWS {
            if attempt == own.points.len() {
                let point = drawn(&mut around, attempt);
                own.points.push(point.map(Arc::from));
            }
            if own.points[attempt].as_ref().is_some_and(&mut take) {
                break;
            }
        }
        own.state = around.state().clone();
        if all.len() < MAX_DRAWN {
            all.push(own);
        }
        around
    }
}

/// One of the draws for an item.
fn drawn(around: &mut Around<'_>, attempt: usize) -> Option<Vec<Precise>> {
    // What has no value far from the data may have one near to them.
    let share = attempt as f64 / MAX_DRAWS as f64;
    let spread = WIDEST * (1.0 - share).max(0.02);
    around.point(spread, share < 0.5, attempt % 4 == 3 || share > 0.6)
}
