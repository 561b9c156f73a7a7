//! Powers of the matrix exponential: motion of a linear system from any state to any time.
//!
//! `exp(A τ)` for one short time is squared again and again; a state moves to the time `t` by the powers in the binary digits
//! of `t/τ` and a short Taylor series. Each power is rounded once, so that the error does not grow with the number of squarings:
//! over short times it is formed by a Padé approximant in `f64`, over long ones by a Taylor series in double-double arithmetic.
//!
//! # References
//!
//! Al-Mohy, Higham, SIAM J. Matrix Anal. 31 (2009) 970; SIAM J. Sci. Comput. 33 (2011) 488.

use nalgebra::{DMatrix, DVector};

use super::{Dd, binary_exponent, scale_by_power_of_two};

/// The powers of `exp(A τ)` up to a horizon.
#[derive(Debug, Clone)]
pub(crate) struct Propagator {
    generator: DMatrix<f64>,
    base: f64,
    /// `exp(A τ)` to the powers 1, 2, 4, ....
    powers: Vec<DMatrix<f64>>,
}

/// Up to this norm of `A t` squaring in `f64` is accurate enough.
// These are seven squarings, which double the rounding of the first power to 1.4e-14.
const SHORT: f64 = 64.0;

/// Largest matrix that is squared in double-double arithmetic.
const MAX_EXACT: usize = 128;

/// Squarings after which six digits are left, since each doubles the rounding of the first power: `2^-53` in `f64`.
const MAX_SQUARINGS: i32 = 33;

/// The same where they are done in double-double arithmetic, which rounds at `2^-104`.
const MAX_EXACT_SQUARINGS: i32 = 84;

/// Why the motion up to a horizon cannot be prepared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PropagatorError {
    /// A power leaves the range of numbers.
    OutOfRange,
    /// The fastest rate makes so many turns until the horizon that hardly a digit would be left.
    TooLong,
}

impl Propagator {
    /// Prepared for times from zero to the horizon.
    pub(crate) fn of(generator: &DMatrix<Dd>, horizon: f64) -> Result<Self, PropagatorError> {
        let rounded = generator.map(Dd::hi);
        let size = one_norm(&rounded) * horizon;
        if !size.is_finite() {
            return Err(PropagatorError::OutOfRange);
        }
        let squarings = (binary_exponent(size) + 1).max(0);
        let is_large = rounded.nrows() > MAX_EXACT;
        let most = if is_large {
            MAX_SQUARINGS
        } else {
            MAX_EXACT_SQUARINGS
        };
        if squarings > most {
            return Err(PropagatorError::TooLong);
        }
        let base = scale_by_power_of_two(horizon, -squarings);
        let powers = if size <= SHORT || is_large {
            squares(pade(&(&rounded * base)), squarings)
        } else {
            exact_powers(generator, base, squarings)
        };
        let is_finite = powers
            .iter()
            .all(|power| power.iter().all(|x| x.is_finite()));
        if !is_finite {
            return Err(PropagatorError::OutOfRange);
        }
        Ok(Self {
            generator: rounded,
            base,
            powers,
        })
    }

    /// Moves a state on by a time between zero and the horizon.
    pub(crate) fn advance(&self, state: &mut DVector<f64>, time: f64) {
        if time == 0.0 {
            return;
        }
        let steps = (time / self.base).floor();
        let rest = (Dd::from(time) - Dd::product(steps, self.base)).hi();
        self.series(state, rest);
        // Bits of an integer of at most as many digits as there are powers.
        let mut left = steps;
        for (level, power) in self.powers.iter().enumerate().rev() {
            let weight = scale_by_power_of_two(1.0, level as i32);
            if left >= weight {
                left -= weight;
                *state = power * &*state;
            }
        }
    }

    /// The matrix that moves states on by a time: the exponential of `A t`.
    pub(crate) fn step(&self, time: f64) -> DMatrix<f64> {
        let size = self.generator.nrows();
        let mut columns = DMatrix::identity(size, size);
        for j in 0..size {
            let mut column = columns.column(j).into_owned();
            self.advance(&mut column, time);
            columns.set_column(j, &column);
        }
        columns
    }

    /// The Taylor series for `|A t|` of at most about one.
    fn series(&self, state: &mut DVector<f64>, time: f64) {
        // 1/24! is less than 2e-24: at a norm of one the test in the loop ends the series before this.
        const TERMS: i32 = 24;
        let mut term = state.clone();
        for order in 1..=TERMS {
            term = &self.generator * term * (time / f64::from(order));
            *state += &term;
            if term.amax() <= f64::EPSILON / 64.0 * state.amax() {
                return;
            }
        }
    }
}

/// Largest sum of magnitudes of a column.
fn one_norm(matrix: &DMatrix<f64>) -> f64 {
    let sums = matrix
        .column_iter()
        .map(|column| column.iter().map(|x| x.abs()).sum::<f64>());
    sums.fold(0.0, f64::max)
}

/// The first matrix and its repeated squares.
fn squares(first: DMatrix<f64>, squarings: i32) -> Vec<DMatrix<f64>> {
    let mut powers = vec![first];
    for level in 0..squarings as usize {
        powers.push(&powers[level] * &powers[level]);
    }
    powers
}

/// The diagonal Padé approximant of order 13, for norms up to about 5.
fn pade(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    // (26 - j)!/((13 - j)! j!), integers that binary64 holds exactly: the coefficients of both polynomials,
    // times 26!/13! (Higham, SIAM J. Matrix Anal. 26 (2005) 1179).
    const B: [f64; 14] = [
        64_764_752_532_480_000.0,
        32_382_376_266_240_000.0,
        7_771_770_303_897_600.0,
        1_187_353_796_428_800.0,
        129_060_195_264_000.0,
        10_559_470_521_600.0,
        670_442_572_800.0,
        33_522_128_640.0,
        1_323_241_920.0,
        40_840_800.0,
        960_960.0,
        16_380.0,
        182.0,
        1.0,
    ];
    let size = matrix.nrows();
    let one = DMatrix::<f64>::identity(size, size);
    let second = matrix * matrix;
    let fourth = &second * &second;
    let sixth = &fourth * &second;
    let combination = |a: f64, b: f64, c: f64| &sixth * a + &fourth * b + &second * c;
    let odd = matrix
        * (&sixth * combination(B[13], B[11], B[9]) + combination(B[7], B[5], B[3]) + &one * B[1]);
    let even =
        &sixth * combination(B[12], B[10], B[8]) + combination(B[6], B[4], B[2]) + &one * B[0];
    let (numerator, denominator) = (&even + &odd, even - odd);
    denominator
        .lu()
        .solve(&numerator)
        // The caller looks for powers that are not finite, and refuses them; there is no second kind of
        // error.
        .unwrap_or_else(|| DMatrix::from_element(size, size, f64::NAN))
}

/// Powers whose squarings are done in double-double arithmetic and rounded at the end.
fn exact_powers(generator: &DMatrix<Dd>, base: f64, squarings: i32) -> Vec<DMatrix<f64>> {
    let mut power = taylor(&generator.map(|x| x * base));
    let mut powers = vec![power.map(Dd::hi)];
    for _ in 0..squarings {
        power = product(&power, &power);
        powers.push(power.map(Dd::hi));
    }
    powers
}

/// The exponential of a matrix of norm one: the Taylor series of a sixteenth of it, squared four times.
fn taylor(matrix: &DMatrix<Dd>) -> DMatrix<Dd> {
    // Eighteen products and four squarings in place of the thirty products that the series of the whole would
    // take.
    const HALVINGS: i32 = 4;
    // The next term is at most (1/16)^19/19! = 1e-40, less than 2^-106 also after four squarings.
    const TERMS: i32 = 18;
    let size = matrix.nrows();
    let small = matrix.map(|x| x.scale(-HALVINGS));
    let one = DMatrix::from_fn(size, size, |i, j| if i == j { Dd::ONE } else { Dd::ZERO });
    let mut sum = one.clone();
    for order in (1..=TERMS).rev() {
        let inner = product(&small, &sum).map(|x| x / f64::from(order));
        sum = inner.zip_map(&one, |x, y| x + y);
    }
    for _ in 0..HALVINGS {
        sum = product(&sum, &sum);
    }
    sum
}

fn product(left: &DMatrix<Dd>, right: &DMatrix<Dd>) -> DMatrix<Dd> {
    let size = left.nrows();
    let mut result = DMatrix::from_element(size, size, Dd::ZERO);
    for (j, target) in result.as_mut_slice().chunks_exact_mut(size).enumerate() {
        for (k, column) in left.as_slice().chunks_exact(size).enumerate() {
            let factor = right[(k, j)];
            // The series starts from the identity, whose zeros would cost as much as numbers.
            if factor != Dd::ZERO {
                target
                    .iter_mut()
                    .zip(column)
                    .for_each(|(x, y)| *x += *y * factor);
            }
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::{cos, exp, sin};

    fn rotation(rate: f64, decay: f64) -> DMatrix<Dd> {
        DMatrix::from_row_slice(2, 2, &[-decay, rate, -rate, -decay]).map(Dd::from)
    }

    #[test]
    fn rotations_stay_rotations() {
        for (horizon, tolerance) in [(1.0, 1e-15), (30.0, 2e-14), (1e4, 2e-15), (1e9, 4e-15)] {
            let propagator = Propagator::of(&rotation(1.0, 0.0), horizon).unwrap();
            for time in [0.0, 0.1 * horizon, 0.7 * horizon, horizon] {
                let mut state = DVector::from_vec(vec![1.0, 0.0]);
                propagator.advance(&mut state, time);
                assert!(
                    (state[0] - cos(time)).abs() < tolerance,
                    "{time}: {}",
                    state[0] - cos(time)
                );
                assert!(
                    (state[1] + sin(time)).abs() < tolerance,
                    "{time}: {}",
                    state[1] + sin(time)
                );
            }
        }
    }

    #[test]
    fn a_defective_matrix_is_no_exception() {
        let matrix = DMatrix::from_row_slice(2, 2, &[-2.0, 1.0, 0.0, -2.0]).map(Dd::from);
        let step = Propagator::of(&matrix, 3.0).unwrap().step(1.5);
        assert!((step[(0, 1)] / (1.5 * exp(-3.0)) - 1.0).abs() < 1e-14);
        assert!((step[(0, 0)] / exp(-3.0) - 1.0).abs() < 1e-14);
    }

    #[test]
    fn growth_beyond_all_numbers_has_no_propagator() {
        let matrix = DMatrix::from_element(1, 1, Dd::ONE);
        let refused = |horizon| Propagator::of(&matrix, horizon).err();
        assert_eq!(refused(1e4), Some(PropagatorError::OutOfRange));
        assert_eq!(refused(f64::INFINITY), Some(PropagatorError::OutOfRange));
        assert_eq!(refused(0.0), None);
    }

    #[test]
    fn turns_beyond_all_digits_have_no_propagator() {
        let refused = |horizon| Propagator::of(&rotation(1.0, 0.0), horizon).err();
        assert_eq!(refused(1e24), None);
        assert_eq!(refused(1e26), Some(PropagatorError::TooLong));
    }
}
