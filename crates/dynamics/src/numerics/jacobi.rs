//! One-sided Jacobi singular value decomposition, accurate for every column scaling.
//!
//! The matrix comes as `G diag(s)` with well-scaled columns `G` and a diagonal that may span the whole exponent range.
//! Plane rotations make the columns orthogonal; their lengths are then the singular values.
//! The scales stay outside the columns, so neither products of columns nor their differences can underflow,
//! and a small singular value is as accurate, relatively, as a large one.
//!
//! # References
//!
//! Demmel, Veselić, SIAM J. Matrix Anal. 13 (1992) 1204; Drmač, Veselić, SIAM J. Matrix Anal. 29 (2008) 1322.

use super::{ascending, binary_exponent, fast_two_sum, scale_by_power_of_two};

/// A matrix `G diag(s)`: its columns, each with a positive factor of its own.
///
/// The columns should have lengths near one; the factors carry the magnitudes.
#[derive(Debug, Clone)]
pub(crate) struct ScaledColumns {
    rows: usize,
    entries: Vec<f64>,
    scales: Vec<f64>,
    /// What rounding has left of the scales.
    scale_errors: Vec<f64>,
}

/// The singular values, ascending, and the left singular vectors, one column each.
#[derive(Debug, Clone)]
pub(crate) struct LeftSingular {
    /// Singular values in ascending order.
    pub(crate) values: Vec<f64>,
    /// Orthonormal vectors in the same order, one after the other.
    pub(crate) vectors: Vec<f64>,
}

/// More sweeps than any matrix needs: convergence is quadratic from about the fifth on.
const MAX_SWEEPS: usize = 60;

impl ScaledColumns {
    /// A matrix of `scales.len()` columns with `rows` entries each, given one column after the other.
    pub(crate) fn new(rows: usize, entries: Vec<f64>, scales: Vec<f64>) -> Self {
        assert_eq!(entries.len(), rows * scales.len());
        Self {
            rows,
            entries,
            scale_errors: vec![0.0; scales.len()],
            scales,
        }
    }

    /// Rotates the columns until all pairs are orthogonal to rounding and reads off the decomposition.
    pub(crate) fn left_singular(mut self) -> LeftSingular {
        self.orthogonalize();
        let lengths: Vec<f64> = self.squared_lengths().iter().map(|a| a.sqrt()).collect();
        let order = ascending(lengths.len(), &|j| self.scales[j] * lengths[j]);
        let mut vectors = Vec::with_capacity(self.entries.len());
        for &j in &order {
            vectors.extend(self.column(j).iter().map(|x| x / lengths[j]));
        }
        let values = order.iter().map(|&j| self.scales[j] * lengths[j]).collect();
        LeftSingular { values, vectors }
    }

    fn column(&self, j: usize) -> &[f64] {
        &self.entries[j * self.rows..(j + 1) * self.rows]
    }

    fn squared_lengths(&self) -> Vec<f64> {
        (0..self.scales.len())
            .map(|j| dot(self.column(j), self.column(j)))
            .collect()
    }

    fn orthogonalize(&mut self) {
        // A product of n terms is off by n u of both lengths: a smaller one cannot be told from zero.
        let tolerance = self.rows.max(4) as f64 * (f64::EPSILON / 2.0);
        for _ in 0..MAX_SWEEPS {
            if !self.sweep(tolerance * tolerance) {
                return;
            }
        }
    }

    /// Visits each pair once, the longer column first; says whether any pair was rotated.
    fn sweep(&mut self, tolerance_squared: f64) -> bool {
        let mut squares = self.squared_lengths();
        self.balance(&mut squares);
        // The longest first, which takes fewer sweeps (de Rijk, SIAM J. Sci. Stat. Comput. 10 (1989) 359).
        let mut order = ascending(squares.len(), &|j| -(self.scales[j] * squares[j].sqrt()));
        let mut rotated = false;
        for p in 0..order.len() {
            for q in p + 1..order.len() {
                let (i, j) = (order[p], order[q]);
                let product = dot(self.column(i), self.column(j));
                if product * product > tolerance_squared * squares[i] * squares[j] {
                    rotated = true;
                    if !self.rotate(i, j, product, &mut squares) {
                        order.swap(p, q);
                    }
                }
            }
        }
        rotated
    }

    /// Makes columns `i` and `j` orthogonal; returns whether `i` was the longer one.
    fn rotate(&mut self, i: usize, j: usize, product: f64, squares: &mut [f64]) -> bool {
        let ratio = self.scales[j] / self.scales[i];
        let first_is_longer = ratio * ratio * squares[j] <= squares[i];
        let (long, short, ratio) = if first_is_longer {
            (i, j, ratio)
        } else {
            (j, i, self.scales[i] / self.scales[j])
        };
        let rotation = Rotation::of(squares[long], squares[short], product, ratio);
        let [x, y] = self
            .entries
            .get_disjoint_mut([
                long * self.rows..(long + 1) * self.rows,
                short * self.rows..(short + 1) * self.rows,
            ])
            .expect("two columns of one matrix do not overlap");
        rotation.apply(x, y);
        squares[long] = rotation.stretched(squares[long] - rotation.into_long * product);
        let shortened = squares[short] + rotation.into_short * product;
        // What cancellation leaves of the shorter length is summed anew.
        squares[short] = if shortened > 0.25 * squares[short] {
            rotation.stretched(shortened)
        } else {
            dot(y, y)
        };
        self.shrink_scale(long, rotation.versine);
        self.shrink_scale(short, rotation.versine);
        first_is_longer
    }

    /// Multiplies a scale by a cosine, `1 - versine`, without piling up roundings.
    fn shrink_scale(&mut self, j: usize, versine: f64) {
        let less = -versine * self.scales[j];
        let (scale, error) = fast_two_sum(self.scales[j], less + self.scale_errors[j]);
        self.scales[j] = scale;
        self.scale_errors[j] = error;
    }

    /// Moves powers of two from columns that have grown to their scales.
    fn balance(&mut self, squares: &mut [f64]) {
        // 2^20: columns are scaled again seldom, and long before a square leaves the exponent range.
        const MAX_SCALE: f64 = 1_048_576.0;
        for (j, square) in squares.iter_mut().enumerate() {
            if *square > MAX_SCALE {
                let exponent = binary_exponent(*square) / 2;
                let factor = scale_by_power_of_two(1.0, -exponent);
                self.entries[j * self.rows..(j + 1) * self.rows]
                    .iter_mut()
                    .for_each(|x| *x *= factor);
                *square *= factor * factor;
                self.scales[j] = scale_by_power_of_two(self.scales[j], exponent);
                self.scale_errors[j] = scale_by_power_of_two(self.scale_errors[j], exponent);
            }
        }
    }
}

/// A plane rotation of the columns `x` (long) and `y` (short), in units of their scales:
/// `x <- c (x - a y)`, `y <- c (y + b x)`. The cosine goes to the scales.
///
/// # References
///
/// Anda, Park, SIAM J. Matrix Anal. 15 (1994) 162.
struct Rotation {
    versine: f64,
    squared_tangent: f64,
    into_long: f64,
    into_short: f64,
}

impl Rotation {
    /// `ratio` is the scale of the short column over that of the long one.
    ///
    /// With `t` the tangent of the angle, `b = t/ratio` and `a = t ratio`; written with `b`, nothing is divided by the ratio,
    /// which may be as small as zero.
    fn of(long: f64, short: f64, product: f64, ratio: f64) -> Self {
        let square = ratio * ratio;
        let difference = square * short - long;
        let twice = 2.0 * product;
        let root = (difference * difference + square * twice * twice).sqrt();
        // The smaller of both angles: its denominator is a sum of positive terms.
        let into_short = -twice / (difference.abs() + root);
        let into_long = square * into_short;
        let squared_tangent = into_long * into_short;
        let cosine = 1.0 / (1.0 + squared_tangent).sqrt();
        Self {
            versine: squared_tangent * cosine * cosine / (1.0 + cosine),
            squared_tangent,
            into_long,
            into_short,
        }
    }

    fn apply(&self, x: &mut [f64], y: &mut [f64]) {
        for (x, y) in x.iter_mut().zip(y) {
            let (long, short) = (*x, *y);
            *x = long - self.into_long * short;
            *y = short + self.into_short * long;
        }
    }

    /// A squared length over that of the cosine.
    fn stretched(&self, square: f64) -> f64 {
        square + square * self.squared_tangent
    }
}

/// The largest magnitude; zero of nothing. What is not a number does not count.
pub(crate) fn largest_magnitude(values: &[f64]) -> f64 {
    const LANES: usize = 8;
    let mut lanes = [0.0_f64; LANES];
    // A comparison and not `max`, which would look after numbers that are none in every step.
    let keep = |largest: &mut f64, x: &f64| {
        if x.abs() > *largest {
            *largest = x.abs();
        }
    };
    let chunks = values.chunks_exact(LANES);
    let rest = chunks.remainder();
    for chunk in chunks {
        lanes
            .iter_mut()
            .zip(chunk)
            .for_each(|(lane, x)| keep(lane, x));
    }
    let mut largest = 0.0;
    lanes.iter().chain(rest).for_each(|x| keep(&mut largest, x));
    largest
}

/// The inner product, in eight partial sums of fixed order.
pub(crate) fn dot(x: &[f64], y: &[f64]) -> f64 {
    let (x, y) = (x, &y[..x.len()]);
    let mut lanes = [0.0; 8];
    let (xs, ys) = (x.chunks_exact(8), y.chunks_exact(8));
    let rest: f64 = xs
        .remainder()
        .iter()
        .zip(ys.remainder())
        .map(|(a, b)| a * b)
        .sum();
    for (a, b) in xs.zip(ys) {
        for (lane, (a, b)) in lanes.iter_mut().zip(a.iter().zip(b)) {
            *lane += a * b;
        }
    }
    let [a, b, c, d, e, f, g, h] = lanes;
    ((a + e) + (c + g)) + ((b + f) + (d + h)) + rest
}
