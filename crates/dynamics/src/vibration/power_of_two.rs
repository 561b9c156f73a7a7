//! Powers of two as units: exact changes of scale.

/// A factor 2^n, as two factors within the exponent range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PowerOfTwo {
    exponent: i32,
    first: f64,
    second: f64,
}

impl PowerOfTwo {
    /// The factor 2^n.
    #[inline]
    pub(crate) fn new(exponent: i32) -> Self {
        let first = exponent.clamp(-1022, 1023);
        let second = (exponent - first).clamp(-1022, 1023);
        Self {
            exponent,
            first: power(first),
            second: power(second),
        }
    }

    /// The factor 2^(n + more).
    pub(crate) fn times(self, more: i32) -> Self {
        Self::new(self.exponent + more)
    }

    /// Number times the factor, exactly barring over- and underflow.
    #[inline]
    pub(crate) fn apply(self, x: f64) -> f64 {
        x * self.first * self.second
    }
}

/// 2^n within the exponent range.
fn power(exponent: i32) -> f64 {
    f64::from_bits(((exponent + 1023) as u64) << 52)
}
