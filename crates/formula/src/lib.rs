//! Units, exact decimals, and formulas with dimensions.

pub mod expr;
pub mod unit;
pub mod work;
