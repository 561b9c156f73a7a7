//! Timing, and the unit in which it is stated.

use std::hint::black_box;
use std::time::Instant;

use vibank::numerics::{exp, sin_cos};

/// Time of one item, over many batches.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Timing {
    /// In yardsticks: the median over the batches, each beside a batch of the yardstick, so that a processor that changes
    /// its clock, or has others to serve, changes both.
    pub(crate) yards: f64,
    /// In nanoseconds, of the second fastest batch.
    pub(crate) fast: f64,
    /// In nanoseconds, of the median batch.
    pub(crate) median: f64,
    /// Items in a batch.
    pub(crate) items: usize,
}

impl Timing {
    /// The time of one part of an item that has several.
    pub(crate) fn over(self, parts: usize) -> Self {
        let count = parts as f64;
        Self {
            yards: self.yards / count,
            fast: self.fast / count,
            median: self.median / count,
            items: self.items * parts,
        }
    }
}

/// Batches that are timed, as long as they take less than [`MAX_DURATION`] together.
const BATCHES: usize = 25;

/// Fewest batches that are timed.
const FEWEST: usize = 3;

/// Items in a batch, unless they take longer than [`BATCH`].
const ITEMS: usize = 4096;

/// Duration of a batch of slow items in nanoseconds.
const BATCH: f64 = 5e5;

/// Items in the batch of yardsticks beside each.
const YARDS: usize = 1024;

/// Duration of all batches in nanoseconds.
const MAX_DURATION: f64 = 1.5e8;

/// Times an operation on the items 0, 1, 2, ....
pub(crate) fn time<T>(mut operation: impl FnMut(usize) -> T) -> Timing {
    let mut items = 1;
    while items < ITEMS && batch(&mut operation, items) * (items as f64) < BATCH {
        items *= 2;
    }
    let (mut times, mut yards) = (Vec::with_capacity(BATCHES), Vec::with_capacity(BATCHES));
    let mut spent = 0.0;
    while times.len() < FEWEST || times.len() < BATCHES && spent < MAX_DURATION {
        let each = batch(&mut operation, items);
        spent += each * items as f64;
        times.push(each);
        yards.push(each / batch(&mut yard, YARDS));
    }
    times.sort_by(f64::total_cmp);
    yards.sort_by(f64::total_cmp);
    Timing {
        yards: yards[yards.len() / 2],
        fast: times[1],
        median: times[times.len() / 2],
        items,
    }
}

/// Nanoseconds an item.
fn batch<T>(operation: &mut impl FnMut(usize) -> T, items: usize) -> f64 {
    #[expect(clippy::disallowed_methods, reason = "a benchmark measures time")]
    let start = Instant::now();
    for item in 0..items {
        black_box(operation(black_box(item)));
    }
    start.elapsed().as_nanos() as f64 / items as f64
}

/// The yardstick: one exponential and one pair of sine and cosine.
fn yard(item: usize) -> f64 {
    let argument = 0.1 + (item % 4096) as f64 * 1.5e-3;
    let (sine, cosine) = sin_cos(argument);
    exp(-argument) + sine + cosine
}

/// The yardstick in nanoseconds.
pub(crate) fn yardstick() -> f64 {
    time(yard).fast
}
