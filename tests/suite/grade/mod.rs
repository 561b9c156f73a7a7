//! Grading of whole instances.

mod follow;
mod relations;
