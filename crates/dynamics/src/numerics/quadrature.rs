//! Integrals over a finite interval.

use thiserror::Error;

/// Most pieces an interval is cut into.
const MAX_PIECES: usize = 2000;

/// An integral and a bound on its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integral {
    /// The area under the curve.
    pub value: f64,
    /// Estimated bound on the error of the value, truncation and rounding together.
    pub error: f64,
}

/// Why an integral was not found.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum IntegralError {
    /// The integrand is infinite or undefined inside the interval.
    #[error("the integrand is infinite or undefined at {at}")]
    Undefined {
        /// The place.
        at: f64,
    },
    /// The interval was cut as often as allowed and the error is still larger than asked.
    #[error("the integral does not converge: its error is still {error}")]
    NotConverged {
        /// Bound on the error when the search ended.
        error: f64,
    },
}

/// The integral of `f` from `lower` to `upper`, to the relative `tolerance` or to rounding.
///
/// The piece with the largest error is halved until the errors together are small enough; each piece takes 21
/// evaluations, none at its ends, so an integrable singularity belongs at an end of the interval.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::numerics::{integral, sin};
///
/// let area = integral(sin, 0.0, std::f64::consts::PI, 1e-12).unwrap();
/// assert!((area.value - 2.0).abs() < 1e-15);
/// assert!(area.error < 1e-12);
/// ```
///
/// # Errors
///
/// [`IntegralError::Undefined`] where `f` is not finite, [`IntegralError::NotConverged`] after two thousand cuts.
///
/// # References
///
/// R. Piessens et al., QUADPACK, Springer 1983: rule and error estimate of QK21.
pub fn integral(
    f: impl FnMut(f64) -> f64,
    lower: f64,
    upper: f64,
    tolerance: f64,
) -> Result<Integral, IntegralError> {
    let mut f = f;
    let mut pieces = vec![Panel::over(&mut f, lower, upper)?];
    loop {
        let total = Panel::total(&pieces);
        // Where positive and negative parts cancel, no number of cuts makes the sum better than the rounding
        // of its parts.
        let rounding = 2.0 * f64::EPSILON * pieces.iter().map(|piece| piece.magnitude).sum::<f64>();
        if total.error <= (tolerance * total.value.abs()).max(rounding) {
            return Ok(Integral {
                error: total.error.max(rounding),
                ..total
            });
        }
        // A heap would save little: each cut costs 42 evaluations, and there are two thousand at most.
        let worst = (0..pieces.len())
            .max_by(|&a, &b| pieces[a].error.total_cmp(&pieces[b].error))
            .unwrap_or(0);
        let Some((left, right)) = pieces[worst].halves().filter(|_| pieces.len() < MAX_PIECES)
        else {
            return Err(IntegralError::NotConverged { error: total.error });
        };
        pieces[worst] = Panel::over(&mut f, left.0, left.1)?;
        pieces.push(Panel::over(&mut f, right.0, right.1)?);
    }
}

/// Integral over one piece by the rule of Gauss and Kronrod.
struct Panel {
    lower: f64,
    upper: f64,
    value: f64,
    /// Integral of the integrand's magnitude.
    magnitude: f64,
    error: f64,
}

impl Panel {
    fn over(f: &mut impl FnMut(f64) -> f64, lower: f64, upper: f64) -> Result<Self, IntegralError> {
        // Halved before they are added, so that ends near the largest number do not overflow.
        let (middle, half) = (0.5 * lower + 0.5 * upper, 0.5 * upper - 0.5 * lower);
        let mut value = |at: f64| {
            Some(f(at))
                .filter(|y| y.is_finite())
                .ok_or(IntegralError::Undefined { at })
        };
        let centre = value(middle)?;
        let mut samples = [(centre, 0.0); RULE.len()];
        for (sample, [node, ..]) in samples.iter_mut().zip(RULE).skip(1) {
            *sample = (value(middle - half * node)?, value(middle + half * node)?);
        }
        let weighted = |weight: usize, of: &dyn Fn(f64) -> f64| -> f64 {
            let sides = samples
                .iter()
                .zip(RULE)
                .skip(1)
                .map(|(s, row)| row[weight] * (of(s.0) + of(s.1)));
            RULE[0][weight] * of(centre) + sides.sum::<f64>()
        };
        let kronrod = weighted(KRONROD, &|y| y);
        let gauss = weighted(GAUSS, &|y| y);
        let magnitude = half.abs() * weighted(KRONROD, &f64::abs);
        let spread = half.abs() * weighted(KRONROD, &|y| (y - 0.5 * kronrod).abs());
        let error = estimate((half * (kronrod - gauss)).abs(), spread, magnitude);
        Ok(Self {
            lower,
            upper,
            value: half * kronrod,
            magnitude,
            error,
        })
    }

    /// Both halves, unless the piece is too small to be cut.
    fn halves(&self) -> Option<((f64, f64), (f64, f64))> {
        let middle = 0.5 * self.lower + 0.5 * self.upper;
        (middle != self.lower && middle != self.upper)
            .then_some(((self.lower, middle), (middle, self.upper)))
    }

    fn total(pieces: &[Self]) -> Integral {
        Integral {
            value: pieces.iter().map(|piece| piece.value).sum(),
            error: pieces.iter().map(|piece| piece.error).sum(),
        }
    }
}

/// The difference of both rules overestimates the error of the better one; QUADPACK's power law, above rounding.
fn estimate(difference: f64, spread: f64, magnitude: f64) -> f64 {
    // Both numbers, 200 and the power 3/2, are those of QK21. The spread about the mean makes it independent
    // of a constant that is added to the integrand.
    let ratio = (200.0 * difference / spread).min(1.0);
    let truncation = if spread > 0.0 {
        spread * ratio * ratio.sqrt()
    } else {
        difference
    };
    truncation.max(0.5 * f64::EPSILON * magnitude)
}

// Columns of `RULE`, whose first one has the nodes.
const KRONROD: usize = 1;
const GAUSS: usize = 2;

/// Nodes from the centre outwards, their weights in the 21-point rule, and in the 10-point rule where they belong to it.
const RULE: [[f64; 3]; 11] = [
    [0.0, 0.149_445_554_002_916_9, 0.0],
    [
        0.148_874_338_981_631_22,
        0.147_739_104_901_338_49,
        0.295_524_224_714_752_87,
    ],
    [0.294_392_862_701_460_2, 0.142_775_938_577_060_09, 0.0],
    [
        0.433_395_394_129_247_2,
        0.134_709_217_311_473_34,
        0.269_266_719_309_996_35,
    ],
    [0.562_757_134_668_604_7, 0.123_491_976_262_065_84, 0.0],
    [
        0.679_409_568_299_024_4,
        0.109_387_158_802_297_64,
        0.219_086_362_515_982_04,
    ],
    [0.780_817_726_586_416_9, 0.093_125_454_583_697_6, 0.0],
    [
        0.865_063_366_688_984_5,
        0.075_039_674_810_919_96,
        0.149_451_349_150_580_6,
    ],
    [0.930_157_491_355_708_2, 0.054_755_896_574_351_995, 0.0],
    [
        0.973_906_528_517_171_7,
        0.032_558_162_307_964_725,
        0.066_671_344_308_688_14,
    ],
    [0.995_657_163_025_808_1, 0.011_694_638_867_371_874, 0.0],
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::{cos, exp, ln};

    #[test]
    fn smooth_integrals_reach_rounding() {
        let area = integral(exp, 0.0, 1.0, 0.0).unwrap();
        assert!((area.value - 1.718_281_828_459_045).abs() < 4e-16);
        assert!(area.error < 1e-15);
    }

    #[test]
    fn singular_ends_converge() {
        let area = integral(ln, 0.0, 1.0, 1e-10).unwrap();
        assert!(
            (area.value + 1.0).abs() <= area.error && area.error < 1e-9,
            "{area:?}"
        );
    }

    #[test]
    fn kinks_and_oscillations_converge() {
        let area = integral(|x| (x - 0.3).abs(), 0.0, 1.0, 1e-12).unwrap();
        assert!((area.value - 0.29).abs() < 1e-12);
        let waves = integral(|x| cos(100.0 * x), 0.0, 1.0, 1e-12).unwrap();
        assert!((waves.value + 0.005_063_656_411_097_588).abs() < 1e-14);
    }

    #[test]
    fn reversed_and_empty_intervals_are_fine() {
        assert!((integral(|x| x, 1.0, 0.0, 1e-12).unwrap().value + 0.5).abs() < 1e-15);
        assert_eq!(integral(|x| x, 1.0, 1.0, 1e-12).unwrap().value, 0.0);
    }

    #[test]
    fn divergent_integrals_are_refused() {
        assert!(integral(|x| 1.0 / x, 0.0, 1.0, 1e-12).is_err());
        assert!(matches!(
            integral(|_| f64::NAN, 0.0, 1.0, 1e-12),
            Err(IntegralError::Undefined { .. })
        ));
    }
}
