//! Whether an instance is fit to hand out.
//!
//! A *draw* knows the constraints of its item only. *Choosing* takes the first seed whose items are
//! all suitable: each key exists, and no named mistake that differs from its key lies within three
//! tolerances of it, so that a slip and honest rounding can be told apart.

use crate::solution::Solution;

/// Why an instance is not fit to hand out.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Unfit {
    /// A part that is asked has no answer.
    #[error("part `{part}` has no answer: {reason}")]
    NoKey {
        /// The part.
        part: String,
        /// Why.
        reason: String,
    },
    /// A mistake that cannot be told from the key.
    #[error("a mistake of part `{part}` lies {tolerances:.1} tolerances from its key")]
    NearMistake {
        /// The part.
        part: String,
        /// The distance in tolerances.
        tolerances: f64,
    },
}

/// Mistakes keep this distance from the key, in tolerances.
pub const CLEARANCE: f64 = 3.0;

/// Whether the parts that are asked are fit to hand out.
///
/// # Errors
///
/// The first reason why they are not.
pub fn judge(solution: &Solution<'_>, parts: &[usize]) -> Result<(), Unfit> {
    for place in parts.iter().filter(|place| solution.asks(**place)) {
        let part = || solution.template().parts[*place].id.clone();
        let clearance = solution.clearance(*place);
        let clearance = clearance.map_err(|absent| Unfit::NoKey {
            part: part(),
            reason: absent.to_string(),
        })?;
        if let Some(tolerances) = clearance.filter(|clearance| *clearance < CLEARANCE) {
            return Err(Unfit::NearMistake {
                part: part(),
                tolerances,
            });
        }
    }
    Ok(())
}
