//! Error-free transformations: the rounding error of a sum or a product is itself a number.
//!
//! Products are split after Veltkamp and Dekker inside the exponent range where that is exact, and otherwise use the
//! fused multiply-add, which without the processor's instruction is a call. Where the instruction is there, it is used
//! throughout. Both give the same bits.
//!
//! # References
//!
//! T. J. Dekker, Numer. Math. 18 (1971) 224. C.-P. Jeannerod, N. Louvet, J.-M. Muller, Math. Comp. 82 (2013) 2245.

/// Whether the processor surely has a fused multiply-add.
const HAS_FUSED: bool = cfg!(any(target_feature = "fma", target_arch = "aarch64"));

/// Rounded sum and its error: `a + b = sum + error`, exactly barring overflow.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::numerics::two_sum;
///
/// assert_eq!(two_sum(1e16, 1.0), (1e16, 1.0));
/// ```
#[inline]
pub fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let from_b = sum - a;
    let from_a = sum - from_b;
    (sum, (a - from_a) + (b - from_b))
}

/// [`two_sum`] in three operations, for `|a| >= |b|` or `a = 0`.
#[inline]
pub fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// Rounded product and its error: `a * b = product + error`, exactly barring over- and underflow.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::numerics::two_prod;
///
/// let (product, error) = two_prod(0.1, 10.0);
/// assert_eq!(product, 1.0);
/// assert_eq!(error, 5.551115123125783e-17);
/// ```
#[inline]
pub fn two_prod(a: f64, b: f64) -> (f64, f64) {
    let (product, error) = ordinary_product(a, b);
    if HAS_FUSED || is_exact(product, error) {
        (product, error)
    } else {
        (product, fused_error(a, b, product))
    }
}

/// The same for factors and products well inside the exponent range.
#[inline]
pub(crate) fn ordinary_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    if HAS_FUSED {
        (product, a.mul_add(b, -product))
    } else {
        (product, product_error(a, b, product))
    }
}

/// The error by the fused multiply-add, which is a call here.
#[cold]
fn fused_error(a: f64, b: f64, product: f64) -> f64 {
    a.mul_add(b, -product)
}

/// Whether a product of halves stayed within the exponent range: its parts do not fall below the smallest number, and
/// a part that overflows leaves no number as the error.
#[inline]
fn is_exact(product: f64, error: f64) -> bool {
    // 2^-106 of it, the last bit of an exact product, is just above the smallest number of binary64.
    const SMALLEST: f64 = 1e-290;
    product.abs() - error.abs() > SMALLEST
}

/// Dekker's product of halves. The added zero turns a negative zero into the positive one of the fused form.
#[inline]
fn product_error(a: f64, b: f64, product: f64) -> f64 {
    let (a_high, a_low) = halves(a);
    let (b_high, b_low) = halves(b);
    let rest = ((product - a_high * b_high) - a_low * b_high) - a_high * b_low;
    (a_low * b_low + 0.0) - rest
}

/// Veltkamp's split into two numbers of 26 bits.
#[inline]
fn halves(a: f64) -> (f64, f64) {
    // Half of the 53 bits, rounded up. With its sign the low part needs 26 bits too, so that products of
    // parts are exact.
    const SPLITTER: f64 = 134_217_729.0; // 2^27 + 1
    let scaled = SPLITTER * a;
    let high = scaled - (scaled - a);
    (high, a - high)
}

/// Difference of two products, `a b - c d`, to 1.5 units in the last place whatever cancels.
///
/// # Examples
///
/// The discriminant of a nearly critically damped oscillator, whose rounded difference is zero:
///
/// ```
/// use vibank_dynamics::numerics::diff_of_products;
///
/// let above = 1.0 + f64::EPSILON;
/// assert_eq!(diff_of_products(above, above, 1.0, 1.0 + 2.0 * f64::EPSILON), f64::EPSILON * f64::EPSILON);
/// ```
///
/// # References
///
/// W. Kahan, On the cost of floating-point computation without extra-precise arithmetic (2004).
#[inline]
pub fn diff_of_products(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let (first, first_error) = two_prod(a, b);
    let (second, second_error) = two_prod(c, d);
    let (difference, error) = two_sum(first, -second);
    difference + (error + (first_error - second_error))
}

/// Sum of two products, `a b + c d`, to 1.5 units in the last place whatever cancels.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::numerics::sum_of_products;
///
/// let above = 1.0 + f64::EPSILON;
/// assert_eq!(sum_of_products(above, above, -1.0, 1.0 + 2.0 * f64::EPSILON), f64::EPSILON * f64::EPSILON);
/// ```
#[inline]
pub fn sum_of_products(a: f64, b: f64, c: f64, d: f64) -> f64 {
    diff_of_products(a, b, -c, d)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// What the processor's fused instruction, or the call that replaces it, gives.
    fn fused(a: f64, b: f64) -> (f64, f64) {
        let product = a * b;
        (product, a.mul_add(b, -product))
    }

    proptest! {
        #[test]
        fn products_have_the_bits_of_the_fused_form(a in any::<f64>(), b in any::<f64>()) {
            let (product, error) = two_prod(a, b);
            let (expected, expected_error) = fused(a, b);
            prop_assert_eq!(product.to_bits(), expected.to_bits());
            prop_assert!(error.to_bits() == expected_error.to_bits() || error.is_nan() && expected_error.is_nan());
        }

        #[test]
        fn ordinary_products_have_the_bits_of_the_fused_form(a in -1e9..1e9_f64, b in -1e-3..1e-3_f64) {
            let (product, error) = fused(a, b);
            let split = product_error(a, b, product);
            prop_assert!(!is_exact(product, split) || split.to_bits() == error.to_bits());
        }

        #[test]
        fn both_sums_agree(a in 1e-3..1e9_f64, b in -1e-3..1e-3_f64) {
            prop_assert_eq!(two_sum(a, b), fast_two_sum(a, b));
        }
    }

    #[test]
    fn an_error_of_zero_is_positive() {
        for (a, b) in [(-1.0, 2.0), (1.0, -2.0), (-3.0, -5.0)] {
            assert_eq!(product_error(a, b, a * b).to_bits(), 0);
        }
    }
}
