//! Frequencies and shapes that are rounded once, for systems of some tens of masses.
//!
//! What a shape leaves of `K φ = λ M φ` is formed without error that matters: each matrix is split into a part of few bits,
//! whose products with the leading bits of the shapes are exact, and a small rest. One step of Ogita and Aishima then takes
//! frequencies and shapes to the last digit, in the time of a few products of matrices. Modes too close for that are left to
//! [`Refined`](super::Refined).
//!
//! # References
//!
//! Ogita, Aishima, Japan J. Indust. Appl. Math. 35 (2018) 1007. Ozaki, Ogita, Oishi, Rump, Numer. Algorithms 59 (2012) 95
//! (splitting).

use std::ops::Range;

use nalgebra::DMatrix;

use super::system::{Inertia, System};
use super::{Modes, is_reversed};
use crate::numerics::jacobi::largest_magnitude;
use crate::numerics::product::product;
use crate::numerics::{Dd, binary_exponent, ordinary_product, scale_by_power_of_two, two_sum};

/// Bits of the leading parts: sums of sixty-four products of two of them, each factor below two, take 53.
const BITS: i32 = 22;

/// Largest number of terms whose sum of leading parts is exact.
const MAX_SIZE: usize = 64;

/// Distance of two eigenvalues, of the largest, at which what is left of a residual, 2^-75 times the root of the size, still
/// leaves shapes to the last digit.
const CLOSEST: f64 = 1e-5;

/// Largest part of one shape in another that is taken out in one step: its square is an error that stays.
const MAX_STEP: f64 = 1e-9;

/// Modes whose frequencies and shapes are rounded once.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::vibration::modes::{Link, Modes};
///
/// let springs: Vec<Link> = (0..20).map(|i| Link::between(i, i + 1, 1.0)).collect();
/// let modes = Modes::of_network(&[1.0; 20], &springs)?;
/// let polished = modes.polished().expect("no two modes are close");
/// let expected = 2.0 * vibank_dynamics::numerics::sin(std::f64::consts::PI / 82.0);
/// assert!((polished.natural_angular_frequency(0).unwrap() / expected - 1.0).abs() < 3e-16);
/// # Ok::<(), vibank_dynamics::vibration::modes::ModesError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Polished {
    /// `ω`, or minus the growth rate.
    rates: Vec<f64>,
    /// Shapes, one after the other.
    shapes: Vec<f64>,
}

impl Polished {
    pub(crate) fn of(modes: &Modes) -> Option<Self> {
        let size = modes.count();
        let are_told_apart = size <= MAX_SIZE && are_apart(modes);
        if !are_told_apart {
            return None;
        }
        let scaled = Scaled::of(&modes.system)?;
        let shapes = scaled.shapes(modes);
        // The splitting takes numbers below two; larger ones would have leading parts of more bits than sums
        // have room for.
        if !shapes.iter().all(|x| x.abs() < 2.0) {
            return None;
        }
        let eigenvalues: Vec<f64> = (0..size)
            .map(|mode| scale_by_power_of_two(modes.eigenvalue(mode), -2 * scaled.rate_exponent))
            .collect();
        let split = Split::of(shapes.iter().map(|x| Dd::from(*x)));
        let momenta = scaled.momenta(&shapes, &split);
        let residuals = scaled.residuals(&shapes, &split, &momenta, &eigenvalues);
        let lengths: Vec<Dd> = (0..size)
            .map(|mode| {
                let column = mode * size..(mode + 1) * size;
                inner_product(&shapes[column.clone()], &momenta, column)
            })
            .collect();
        let mut mixing = product(&transposed(&shapes, size), &residuals, size);
        let mut rates = Vec::with_capacity(size);
        for (j, column) in mixing.chunks_exact_mut(size).enumerate() {
            let eigenvalue = Dd::from(eigenvalues[j]) + Dd::from(column[j]) / lengths[j];
            let is_rigid = modes.rates[j] == 0.0;
            rates.push(if is_rigid {
                0.0
            } else {
                signed_root(eigenvalue, scaled.rate_exponent)
            });
            for (entry, other) in column.iter_mut().zip(&eigenvalues) {
                *entry /= eigenvalues[j] - other;
            }
            column[j] = (Dd::from(1.0) - lengths[j]).hi() / 2.0;
        }
        // Modes that changed places were closer than the correction tells apart.
        if !mixing.iter().all(|x| x.abs() <= MAX_STEP) || !rates.is_sorted() {
            return None;
        }
        let mut shapes = shapes;
        let corrections = product(&shapes, &mixing, size);
        let steps = corrections.chunks_exact(size);
        for (shape, step) in shapes.chunks_exact_mut(size).zip(steps) {
            let entries = shape.iter_mut().zip(step).zip(&scaled.exponents);
            for ((x, step), exponent) in entries {
                *x = scale_by_power_of_two(*x + step, *exponent);
            }
            if is_reversed(&modes.root.weighted(shape)) {
                shape.iter_mut().for_each(|x| *x = -*x);
            }
        }
        Some(Self { rates, shapes })
    }

    /// Natural angular frequency of a mode in rad/s; 0 for rigid motion, none for motion that grows.
    pub fn natural_angular_frequency(&self, mode: usize) -> Option<f64> {
        self.rates.get(mode).copied().filter(|rate| *rate >= 0.0)
    }

    /// Rate in 1/s of the motion `exp(κ t)` of an unstable mode; none for the others.
    pub fn growth_rate(&self, mode: usize) -> Option<f64> {
        let growing = self.rates.get(mode).filter(|rate| **rate < 0.0);
        growing.map(|rate| -rate)
    }

    /// Mass-normalized shape of a mode, its first component that is not zero positive.
    ///
    /// # Panics
    ///
    /// If there is no such mode.
    pub fn mode_shape(&self, mode: usize) -> &[f64] {
        let size = self.rates.len();
        &self.shapes[mode * size..(mode + 1) * size]
    }
}

/// Whether no two eigenvalues are closer than their shapes can be told apart.
fn are_apart(modes: &Modes) -> bool {
    let eigenvalues: Vec<f64> = (0..modes.count())
        .map(|mode| modes.eigenvalue(mode))
        .collect();
    let largest = largest_magnitude(&eigenvalues);
    let mut pairs = eigenvalues.windows(2);
    pairs.all(|pair| pair[1] - pair[0] >= CLOSEST * largest)
}

fn signed_root(eigenvalue: Dd, exponent: i32) -> f64 {
    let root = scale_by_power_of_two(eigenvalue.abs().sqrt().hi(), exponent);
    if eigenvalue.is_negative() {
        -root
    } else {
        root
    }
}

/// A system in units, powers of two for each coordinate and for time, in which all entries are about one or less.
struct Scaled {
    size: usize,
    /// Displacements are these powers of two times the scaled ones.
    exponents: Vec<i32>,
    /// Rates are this power of two times the scaled ones.
    rate_exponent: i32,
    stiffness: Split,
    inertia: ScaledInertia,
}

enum ScaledInertia {
    Masses(Vec<f64>),
    Matrix(Split),
}

impl Scaled {
    fn of(system: &System) -> Option<Self> {
        let size = system.degrees_of_freedom();
        let masses = match &system.inertia {
            Inertia::Masses(masses) => masses.clone(),
            Inertia::Matrix(mass) => mass.diagonal().iter().copied().collect(),
        };
        let exponents: Vec<i32> = masses
            .iter()
            .map(|m| -(binary_exponent(*m).div_euclid(2)))
            .collect();
        let stiffness = system.exact_stiffness_matrix();
        let largest = scaled_entries(&stiffness, &exponents, 0)
            .fold(0.0_f64, |largest, x| largest.max(x.hi().abs()));
        if largest == 0.0 || !largest.is_finite() {
            return None;
        }
        let rate_exponent = (binary_exponent(largest) + 2).div_euclid(2);
        let inertia = match &system.inertia {
            Inertia::Masses(masses) => ScaledInertia::Masses(
                masses
                    .iter()
                    .zip(&exponents)
                    .map(|(m, exponent)| scale_by_power_of_two(*m, 2 * exponent))
                    .collect(),
            ),
            // Half of it, so that all entries are below two.
            Inertia::Matrix(mass) => ScaledInertia::Matrix(Split::of(scaled_entries(
                &mass.map(Dd::from),
                &exponents,
                -1,
            ))),
        };
        let entries = scaled_entries(&stiffness, &exponents, -2 * rate_exponent);
        let stiffness = Split::of(entries);
        Some(Self {
            size,
            exponents,
            rate_exponent,
            stiffness,
            inertia,
        })
    }

    /// The shapes of modes, in the scaled coordinates.
    fn shapes(&self, modes: &Modes) -> Vec<f64> {
        let mut shapes = Vec::with_capacity(self.size * self.size);
        for mode in 0..self.size {
            let shape = modes.root.unweighted(modes.weighted_shape(mode));
            let components = shape.iter().zip(&self.exponents);
            shapes.extend(components.map(|(x, exponent)| scale_by_power_of_two(*x, -exponent)));
        }
        shapes
    }

    /// `M φ` for each shape. Components that are so small that the errors of their products leave the range of numbers add
    /// nothing to any sum.
    fn momenta(&self, shapes: &[f64], split: &Split) -> Split {
        match &self.inertia {
            ScaledInertia::Masses(masses) => {
                let columns = shapes.chunks_exact(self.size);
                let products = columns.flat_map(|shape| {
                    let components = shape.iter().zip(masses);
                    components.map(|(x, m)| ordinary_product(*x, *m))
                });
                let (leading, rest) = products.unzip();
                Split { leading, rest }
            }
            ScaledInertia::Matrix(mass) => {
                let mut momenta = mass.product(shapes, split, self.size);
                let parts = momenta.leading.iter_mut().chain(&mut momenta.rest);
                parts.for_each(|x| *x *= 2.0);
                momenta
            }
        }
    }

    /// `K φ - λ M φ` for each shape.
    fn residuals(
        &self,
        shapes: &[f64],
        split: &Split,
        momenta: &Split,
        eigenvalues: &[f64],
    ) -> Vec<f64> {
        let forces = self.stiffness.product(shapes, split, self.size);
        let mut residuals = Vec::with_capacity(shapes.len());
        for (mode, eigenvalue) in eigenvalues.iter().enumerate() {
            let column = mode * self.size..(mode + 1) * self.size;
            let forces = forces.pairs(column.clone());
            residuals.extend(forces.zip(momenta.pairs(column)).map(|(force, momentum)| {
                let (inertia, error) = ordinary_product(*eigenvalue, momentum.0);
                let (difference, rest) = two_sum(force.0, -inertia);
                difference + (rest + (force.1 - (error + eigenvalue * momentum.1)))
            }));
        }
        residuals
    }
}

/// The entries of a matrix, column after column, times 2 to the powers of their row, their column, and one for all.
fn scaled_entries<'a>(
    matrix: &'a DMatrix<Dd>,
    exponents: &'a [i32],
    exponent: i32,
) -> impl Iterator<Item = Dd> + 'a {
    let columns = matrix.as_slice().chunks_exact(exponents.len());
    columns.zip(exponents).flat_map(move |(column, of_column)| {
        column.iter().zip(exponents).map(move |(x, of_row)| {
            let power = of_row + of_column + exponent;
            Dd::sum(
                scale_by_power_of_two(x.hi(), power),
                scale_by_power_of_two(x.lo(), power),
            )
        })
    })
}

/// `φᵀ M φ` of a shape whose `M φ` stands in a column, in four partial sums of fixed order.
fn inner_product(shape: &[f64], momenta: &Split, column: Range<usize>) -> Dd {
    const LANES: usize = 4;
    let (mut high, mut low) = ([0.0; LANES], [0.0; LANES]);
    for (i, (x, momentum)) in shape.iter().zip(momenta.pairs(column)).enumerate() {
        let lane = i % LANES;
        let (term, error) = ordinary_product(*x, momentum.0);
        let (sum, rest) = two_sum(high[lane], term);
        high[lane] = sum;
        low[lane] += rest + (error + x * momentum.1);
    }
    (0..LANES).map(|lane| Dd::sum(high[lane], low[lane])).sum()
}

/// The leading parts of numbers, and what they leave.
struct Split {
    leading: Vec<f64>,
    rest: Vec<f64>,
}

impl Split {
    /// The leading bits of numbers below two.
    fn of(entries: impl Iterator<Item = Dd>) -> Self {
        /// Sums with this have no bits below 2^-BITS.
        const ROUNDING: f64 = 1.5 * (1_u64 << (52 - BITS)) as f64;
        let (leading, rest) = entries
            .map(|x| {
                let leading = (x.hi() + ROUNDING) - ROUNDING;
                (leading, (x.hi() - leading) + x.lo())
            })
            .unzip();
        Self { leading, rest }
    }

    /// This matrix times vectors, also split: the exact sums of the leading products, and the sums of all others.
    fn product(&self, vectors: &[f64], split: &Self, size: usize) -> Self {
        let leading = product(&self.leading, &split.leading, size);
        let mut rest = product(&self.leading, &split.rest, size);
        let by_rest = product(&self.rest, vectors, size);
        rest.iter_mut().zip(by_rest).for_each(|(x, y)| *x += y);
        Self { leading, rest }
    }

    /// Both parts of some numbers.
    fn pairs(&self, range: Range<usize>) -> impl Iterator<Item = (f64, f64)> {
        let leading = self.leading[range.clone()].iter();
        leading.copied().zip(self.rest[range].iter().copied())
    }
}

/// The rows of a square matrix as its columns.
fn transposed(matrix: &[f64], size: usize) -> Vec<f64> {
    let mut transposed = vec![0.0; matrix.len()];
    for (j, column) in matrix.chunks_exact(size).enumerate() {
        let row = transposed[j..].iter_mut().step_by(size);
        row.zip(column).for_each(|(to, from)| *to = *from);
    }
    transposed
}
