//! The vibrations that the textbooks name, solved in closed form, and the portable numerics below them.

pub mod numerics;
pub mod vibration;
