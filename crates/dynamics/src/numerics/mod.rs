//! Bare numbers: portable elementary functions, exact arithmetic, double-double numbers, roots and integrals.
//!
//! Everything here is a pure function of its arguments and gives the same bits on every platform: elementary functions
//! are written in Rust, error-free sums and products do not depend on the instructions at hand, sums run in a fixed order.
//!
//! - [`sin`], [`exp`], [`pow`] and kin, with errors below one unit in the last place.
//! - [`two_sum`], [`two_prod`], [`diff_of_products`]: the error of an operation as a number.
//! - [`Dd`]: numbers of about 106 bits, for small differences and long phases.
//! - [`Long`]: numbers of 256 bits, for what thirty digits cannot tell from zero.
//! - [`Rational`]: exact fractions.
//! - [`ExactNumber`], [`sign_of_sum`]: numbers as they were written, compared without rounding.
//! - [`Complex`]: complex numbers.
//! - [`agm`], [`carlson_rf`], [`JacobiFunctions`]: elliptic integrals and functions.
//! - [`ascending`], [`sort_by`]: the order of numbers, and of anything else; [`SortedMap`], [`SortedSet`]: few entries in order.
//! - `pencil`: eigenvalues of small matrices that need not be symmetric.
//! - [`bracketed_root`], [`integral`]: a zero in an interval, the area under a curve, with their error bounds.
//!
//! Absent on purpose: instructions chosen at run time.

pub(crate) mod bidiagonal;
pub(crate) mod cholesky;
mod complex;
pub(crate) mod complex_lu;
mod decimal;
mod double;
mod elementary;
mod elliptic;
mod exact;
mod exact_number;
pub(crate) mod exponential;
pub(crate) mod householder;
pub(crate) mod jacobi;
mod long;
mod natural;
mod order;
mod pencil;
pub(crate) mod product;
mod quadrature;
mod rational;
mod roots;
mod sorted;
pub(crate) mod symmetric;
pub(crate) mod tridiagonal;

pub use complex::Complex;
pub use double::Dd;
pub use elementary::{
    acos, acosh, asin, asinh, atan, atan2, atanh, binary_exponent, cbrt, cos, cosh, exp, exp2,
    expm1, hypot, ln, ln_1p, log2, log10, pow, powi, scale_by_power_of_two, sin, sin_cos, sinh,
    tan, tanh,
};
pub use elliptic::{
    JacobiFunctions, JacobiValues, agm, agm_dd, carlson_rd, carlson_rf, complete_elliptic_first,
    complete_elliptic_second, elliptic_first, elliptic_second,
};
pub(crate) use exact::ordinary_product;
pub use exact::{diff_of_products, fast_two_sum, sum_of_products, two_prod, two_sum};
pub use exact_number::{ExactNumber, sign_of_sum};
pub use long::Long;
pub use order::{ascending, sort_by, sort_by_key};
pub use pencil::{EigenPair, pencil};
pub use quadrature::{Integral, IntegralError, integral};
pub use rational::Rational;
pub use roots::{RootError, bracketed_root};
pub use sorted::{SortedMap, SortedSet};
