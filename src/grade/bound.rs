//! What marking one response may cost.

use crate::answer::{Marking, Why};
use crate::work;

/// Units of work for one response: the costliest of the suite takes a fifth of it.
const MAX_WORK: u64 = 5_000_000;

/// Marks a response within the bound; one that takes more is not read.
///
/// The key has been prepared before, and what is kept of it later is not paid for by a response: it must not depend on one.
pub(crate) fn bounded(mark: impl FnOnce() -> Marking) -> Marking {
    let marked = work::for_one(MAX_WORK, mark);
    if marked.is_exhausted {
        Marking::unreadable(Why::TooLong)
    } else {
        marked.value
    }
}
