//! What the steps of a program do with real numbers: each result is finite with a finite bound, or infinite because an
//! operand is.

use crate::expr::{Doubt, Function, Relation, Scalar, Undefined};

#[inline]
pub(crate) fn add<S: Scalar>(a: &S, b: &S) -> Result<S, Undefined> {
    finite(a.add(b), [a, b])
}

#[inline]
pub(crate) fn subtract<S: Scalar>(a: &S, b: &S) -> Result<S, Undefined> {
    finite(a.subtract(b), [a, b])
}

#[inline]
pub(crate) fn multiply<S: Scalar>(a: &S, b: &S) -> Result<S, Undefined> {
    finite(a.multiply(b), [a, b])
}

#[inline]
pub(crate) fn divide<S: Scalar>(a: &S, b: &S) -> Result<S, Undefined> {
    finite(a.divide(b)?, [a, b])
}

#[inline]
pub(crate) fn power<S: Scalar>(a: &S, b: &S, doubt: &mut Doubt) -> Result<S, Undefined> {
    finite(a.power(b, doubt)?, [a, b])
}

#[inline]
pub(crate) fn power_whole<S: Scalar>(a: &S, exponent: i32) -> Result<S, Undefined> {
    finite(a.power_whole(exponent)?, [a, a])
}

#[inline]
pub(crate) fn unary<S: Scalar>(
    function: Function,
    a: &S,
    doubt: &mut Doubt,
) -> Result<S, Undefined> {
    finite(a.unary(function, doubt)?, [a, a])
}

#[inline]
pub(crate) fn binary<S: Scalar>(
    function: Function,
    a: &S,
    b: &S,
    doubt: &mut Doubt,
) -> Result<S, Undefined> {
    finite(a.binary(function, b, doubt)?, [a, b])
}

#[inline]
pub(crate) fn compare<S: Scalar>(relation: Relation, a: &S, b: &S, doubt: &mut Doubt) -> S {
    truth(relation.holds(a.compare(b, doubt)))
}

#[inline]
pub(crate) fn truth<S: Scalar>(holds: bool) -> S {
    S::exact(f64::from(u8::from(holds)))
}

#[inline]
fn finite<S: Scalar>(value: S, operands: [&S; 2]) -> Result<S, Undefined> {
    if value.to_f64().is_finite() {
        return if value.bound().is_finite() {
            Ok(value)
        } else {
            Err(Undefined::Uncertain)
        };
    }
    let has_infinity = operands
        .iter()
        .any(|operand| operand.to_f64().is_infinite());
    if has_infinity && !value.to_f64().is_nan() {
        Ok(value)
    } else {
        Err(Undefined::Overflow)
    }
}

impl Relation {
    /// Whether it holds between two numbers of this order.
    #[inline]
    fn holds(self, order: std::cmp::Ordering) -> bool {
        match self {
            Self::Less => order.is_lt(),
            Self::LessOrEqual => order.is_le(),
            Self::Greater => order.is_gt(),
            Self::GreaterOrEqual => order.is_ge(),
            Self::Equal => order.is_eq(),
            Self::NotEqual => order.is_ne(),
        }
    }
}
