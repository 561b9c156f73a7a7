//! Grading of whole instances.

mod follow;
