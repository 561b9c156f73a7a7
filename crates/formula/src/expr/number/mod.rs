//! The numbers of evaluation: values with error bounds, over binary64 and double-double numbers.

mod approx;
pub(crate) mod complex;
mod hyper_dual;
mod precise;
mod real;
mod scalar;
mod undefined;

pub use approx::Approx;
pub use hyper_dual::HyperDual;
pub use precise::Precise;
pub use real::Real;
pub use scalar::{Doubt, Scalar};
pub use undefined::Undefined;
