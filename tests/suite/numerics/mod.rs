//! Bare numbers against references of many digits.

pub(crate) mod double;
