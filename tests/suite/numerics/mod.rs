//! Bare numbers against references of many digits.

mod double;
