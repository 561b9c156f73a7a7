//! Grading of whole instances.

mod doubt;
mod follow;
mod form;
mod recalled;
mod relations;
