//! Formulas as objects of calculation: derivatives, substitution, a normal form.
//!
//! Everything here is exact (coefficients are fractions) and bounded: what would grow beyond
//! [`MAX_SIZE`] nodes is refused with [`SymbolicError::TooLarge`] instead of being computed.
//! Simplification is light; there is no general computer algebra and no guessing of domains.

mod calls;
mod derivative;
mod error;
mod normal;
mod substitute;

pub use derivative::{Variable, differentiate, time_derivative};
pub use error::SymbolicError;
pub use normal::sum_of_signed_terms;
pub use normal::{Harmonic, Normal, Order};
pub use substitute::Substitution;

use super::Expr;
use crate::work;

/// Number of nodes, counted with repetition, beyond which a derived formula is refused.
const MAX_SIZE: u32 = 50_000;

/// Depth beyond which a derived formula is refused; recursion over formulas stays within any stack.
const MAX_DEPTH: u32 = 600;

/// Units of work of a node of a derived formula: it is looked at, and written anew.
const UNITS_OF_A_NODE: u64 = 10;

/// The formula, if it is not too large.
fn bounded(expr: Expr) -> Result<Expr, SymbolicError> {
    work::spend(UNITS_OF_A_NODE)?;
    if expr.size() > MAX_SIZE || expr.depth() > MAX_DEPTH {
        return Err(SymbolicError::TooLarge);
    }
    Ok(expr)
}
