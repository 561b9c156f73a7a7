//! Ranges of numbers and what each gives, for programs that mark by ranges alone.

use super::Credit;

/// Numbers, in the unit that is printed at the blank, that are marked alike.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// The middle.
    pub value: f64,
    /// How far from the middle it reaches; the ends belong to it.
    pub half: f64,
    /// What it gives.
    pub credit: Credit,
    /// The named mistake that it is, as a place among those of the part.
    pub mistake: Option<usize>,
}
