//! Why an operation has no value.

use thiserror::Error;

use crate::expr::Function;

/// Why an operation has no finite value for these numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Error)]
#[non_exhaustive]
pub enum Undefined {
    /// A division by zero, or by what cannot be told from zero.
    #[error("division by zero")]
    DivisionByZero,
    /// The square root of a negative number, in real numbers.
    #[error("square root of a negative number")]
    RootOfNegative,
    /// `ln(0)`, `log2(0)` or `log10(0)`.
    #[error("logarithm of zero")]
    LogarithmOfZero,
    /// The logarithm of a negative number, in real numbers.
    #[error("logarithm of a negative number")]
    LogarithmOfNegative,
    /// A power of a negative number whose exponent is not whole, in real numbers.
    #[error("power of a negative number with an exponent that is not an integer")]
    PowerOfNegative,
    /// An argument outside the domain of a function.
    #[error("argument outside the domain of `{}`", .0.name())]
    OutsideDomain(Function),
    /// A result beyond the largest number.
    #[error("result beyond the largest number")]
    Overflow,
    /// A root was looked for where the function has one sign.
    #[error("no sign change between the ends of the interval")]
    NoSignChange,
    /// An integral or root whose digits do not settle.
    #[error("the integral does not settle within 400 pieces of its interval")]
    NoConvergence,
    /// An evaluation that would take too long.
    #[error("roots and integrals take more than 20 million steps for one set of data")]
    TooLong,
    /// A result of which not one digit is certain.
    #[error("a result without a certain digit")]
    Uncertain,
    /// A vector, matrix or complex number where a real number is asked for.
    #[error("not a real number")]
    NotReal,
    /// An input has no value.
    #[error("a quantity that is needed has no value")]
    Missing {
        /// The slot of the input.
        slot: u32,
    },
}
