//! Units, exact decimals, and formulas with dimensions.
//!
//! A [`Quantity`] is a decimal as it was written with a [`Unit`]; conversions are exact and rounded once. An [`Expr`] is
//! a formula that is read from text, checked for dimensions, evaluated with a bound on the error of each number,
//! differentiated, simplified and typeset.
//!
//! ```
//! use vibank_formula::expr::{Expr, Name, differentiate};
//! use vibank_formula::unit::{DecimalMark, Quantity, Unit};
//!
//! let stiffness: Quantity = "1.2 kN/m".parse()?;
//! let declared = Unit::parse("N/m")?;
//! assert_eq!(stiffness.conversion(&declared)?.apply_decimal(&stiffness.value), 1200.0);
//! assert_eq!(stiffness.text(DecimalMark::Comma), "1,2 kN/m");
//!
//! let energy = Expr::read("k*x^2/2")?;
//! let force = differentiate(&energy, &Name::new("x"))?;
//! // As the rules of differentiation give it.
//! assert_eq!(force.to_string(), "2*(k*x)/2");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! - [`mod@unit`]: dimensions, units, decimals, quantities, their strict and their lenient reading.
//! - [`expr`]: the formula language; names, and what they stand for, belong to whoever uses it.
//! - [`work`]: budgets that bound what reading, evaluation and algebra of untrusted input may cost.

pub mod expr;
pub mod unit;
pub mod work;

pub use expr::{Equation, Expr, Program};
pub use unit::{Decimal, Dimension, Quantity, Unit};
