//! Points that are drawn once for all parts of an instance.
//!
//! What is drawn depends on the names of an item, their values and its constraints, not on a key; most draws break a
//! constraint. Parts whose answers are made of the same names take their points from the same draws, in the same order.

use std::cell::RefCell;
use std::sync::Arc;

use super::draw::{Around, State};
use super::{MAX_DRAWS, WIDEST};
use crate::answer::meaning::{Input, Meaning};
use crate::expr::Precise;
use crate::quantity::Evaluation;

/// The draws for an instance, made as parts ask for them.
#[derive(Debug, Default)]
pub struct Drawn(RefCell<Vec<Draw>>);

/// The draws around some values of some names.
#[derive(Debug)]
struct Draw {
    inputs: Vec<Input>,
    centres: Vec<Option<f64>>,
    /// By attempt; none where the draw broke a constraint.
    points: Vec<Option<Arc<[Precise]>>>,
    /// What the next attempt goes on from.
    state: State,
}

impl Drawn {
    /// Hands out draws around the data of an instance, nearer and nearer to them, until `take` has enough; what the
    /// draws after all of them go on from is left in what is returned.
    pub(crate) fn around<'a>(
        &self,
        meaning: &'a Meaning,
        evaluation: &Evaluation<'_>,
        mut take: impl FnMut(&Arc<[Precise]>) -> bool,
    ) -> Around<'a> {
        let mut around = Around::new(meaning, evaluation);
        let mut all = self.0.borrow_mut();
        let is_own = |own: &Draw| own.inputs == meaning.inputs && own.centres == around.centres();
        let place = all.iter().position(is_own).unwrap_or_else(|| {
            all.push(Draw {
                inputs: meaning.inputs.clone(),
                centres: around.centres().to_vec(),
                points: Vec::new(),
                state: State::new(),
            });
            all.len() - 1
        });
        let own = &mut all[place];
        std::mem::swap(around.state(), &mut own.state);
        for attempt in 0..MAX_DRAWS {
            if attempt == own.points.len() {
                let point = around.attempt(attempt);
                own.points.push(point.map(Arc::from));
            }
            if own.points[attempt].as_ref().is_some_and(&mut take) {
                break;
            }
        }
        own.state = around.state().clone();
        around
    }
}

impl Around<'_> {
    /// One of the draws for an instance.
    fn attempt(&mut self, attempt: usize) -> Option<Vec<Precise>> {
        // What has no value far from the data may have one near to them.
        let share = attempt as f64 / MAX_DRAWS as f64;
        let spread = WIDEST * (1.0 - share).max(0.02);
        self.point(spread, share < 0.5, attempt % 4 == 3 || share > 0.6)
    }
}
