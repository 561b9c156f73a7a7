//! Frequencies and shapes to about thirty digits.
//!
//! One Rayleigh quotient in double-double arithmetic turns a shape of sixteen digits into an eigenvalue of thirty, as long
//! as the eigenvalues do not spread too far. Where they do, or lie close together, the shapes are corrected first.

use std::cmp::Ordering;

use nalgebra::DMatrix;

use super::system::{Inertia, Stiffness, System};
use super::{Modes, is_reversed};
use crate::numerics::Dd;
use crate::numerics::symmetric::Symmetric;

/// Modes whose eigenvalues and shapes are double-double numbers.
///
/// # Examples
///
/// Beats of two pendulums with a spring of 1e-9 N/m: their frequencies agree to ten digits, the difference has sixteen.
///
/// ```
/// use vibank_dynamics::vibration::modes::{Link, Modes};
///
/// let springs = [Link::to_ground(1, 1.0), Link::between(1, 2, 1e-9), Link::to_ground(2, 1.0)];
/// let refined = Modes::of_network(&[1.0, 1.0], &springs)?.refined();
/// let beat = refined.angular_frequency_difference(0, 1);
/// let expected = 2e-9 / (1.0 + (1.0_f64 + 2e-9).sqrt());
/// assert!((beat / expected - 1.0).abs() < 1e-15);
/// # Ok::<(), vibank_dynamics::vibration::modes::ModesError>(())
/// ```
///
/// # References
///
/// Ogita, Aishima, Japan J. Indust. Appl. Math. 35 (2018) 1007.
#[derive(Debug, Clone)]
pub struct Refined {
    eigenvalues: Vec<Dd>,
    /// Shapes as columns.
    shapes: DMatrix<Dd>,
}

/// Part of an eigenvalue by which it must differ from another, so that they are two in numbers of thirty digits.
const TOLD_APART: f64 = 1e-26;

/// Corrections square the error; three take any start that has a digit to the end.
const MAX_CORRECTIONS: usize = 6;

impl Refined {
    /// Corrects the pairs of modes that need it.
    pub(crate) fn of(modes: &Modes) -> Self {
        Self::corrected(modes, mixed_pairs(modes))
    }

    /// Corrects all pairs of modes.
    pub(crate) fn of_all_pairs(modes: &Modes) -> Self {
        let size = modes.count();
        Self::corrected(modes, DMatrix::from_fn(size, size, |i, j| i != j))
    }

    fn corrected(modes: &Modes, mixed: DMatrix<bool>) -> Self {
        let size = modes.count();
        let shapes = DMatrix::from_iterator(
            size,
            size,
            (0..size)
                .flat_map(|mode| modes.root.unweighted(modes.weighted_shape(mode)))
                .map(Dd::from),
        );
        let is_rigid: Vec<bool> = modes.rates.iter().map(|rate| *rate == 0.0).collect();
        let needs_correction = mixed.iter().any(|is_mixed| *is_mixed);
        let mut basis = Basis {
            system: &modes.system,
            shapes,
            is_rigid,
            mixed,
        };
        if needs_correction {
            for _ in 0..MAX_CORRECTIONS {
                if basis.correct() {
                    break;
                }
            }
        }
        basis.finish(modes)
    }

    /// Whether all frequencies and shapes are finite; squares of extreme frequencies are not.
    pub fn is_finite(&self) -> bool {
        self.eigenvalues.iter().all(|value| value.is_finite())
            && self.shapes.iter().all(|component| component.is_finite())
    }

    /// Number of modes.
    pub fn count(&self) -> usize {
        self.eigenvalues.len()
    }

    /// `ω²` of a mode in 1/s²; negative for an unstable one, 0 for a rigid one.
    ///
    /// # Panics
    ///
    /// If there is no such mode.
    pub fn eigenvalue(&self, mode: usize) -> Dd {
        self.eigenvalues[mode]
    }

    /// Natural angular frequency of a mode in rad/s; none for motion that grows.
    ///
    /// # Panics
    ///
    /// If there is no such mode.
    pub fn natural_angular_frequency(&self, mode: usize) -> Option<Dd> {
        let eigenvalue = self.eigenvalues[mode];
        (!eigenvalue.is_negative()).then(|| eigenvalue.sqrt())
    }

    /// Rate in 1/s of the motion `exp(κ t)` of an unstable mode.
    ///
    /// # Panics
    ///
    /// If there is no such mode.
    pub fn growth_rate(&self, mode: usize) -> Option<Dd> {
        let eigenvalue = self.eigenvalues[mode];
        eigenvalue.is_negative().then(|| (-eigenvalue).sqrt())
    }

    /// Frequency of a mode, or minus its growth rate, rounded.
    pub(crate) fn rate(&self, mode: usize) -> f64 {
        let eigenvalue = self.eigenvalues[mode];
        let magnitude = eigenvalue.abs().sqrt().hi();
        if eigenvalue.is_negative() {
            -magnitude
        } else {
            magnitude
        }
    }

    /// Difference `ω_s - ω_r = (ω_s² - ω_r²)/(ω_s + ω_r)` in rad/s, the angular frequency of beats;
    /// NaN if one of the modes is unstable.
    ///
    /// # Panics
    ///
    /// If there is no such mode.
    pub fn angular_frequency_difference(&self, r: usize, s: usize) -> f64 {
        let sum = self.eigenvalues[r].sqrt() + self.eigenvalues[s].sqrt();
        let difference = self.eigenvalues[s] - self.eigenvalues[r];
        if difference == Dd::ZERO {
            0.0
        } else {
            (difference / sum).hi()
        }
    }

    /// Mass-normalized shape of a mode, its first component that is not zero positive.
    ///
    /// # Panics
    ///
    /// If there is no such mode.
    pub fn mode_shape(&self, mode: usize) -> Vec<f64> {
        self.shape(mode).iter().map(|x| x.hi()).collect()
    }

    /// All shapes, as columns.
    pub fn modal_matrix(&self) -> DMatrix<f64> {
        self.shapes.map(Dd::hi)
    }

    /// The shape with all its digits.
    pub(crate) fn shape(&self, mode: usize) -> &[Dd] {
        column(&self.shapes, mode)
    }
}

/// The pairs of modes that rounding has mixed by more than may be left: close ones, whose shapes are off by the unit
/// roundoff over their relative distance, and those far apart, since the softer one takes velocities from the stiffer that
/// are off by the shape's error times the ratio of the frequencies; its Rayleigh quotient is off by the square of that.
/// All pairs, if the system came as a matrix.
fn mixed_pairs(modes: &Modes) -> DMatrix<bool> {
    // Farther apart, rounding mixes two shapes by at most fifty unit roundoffs.
    const CLOSE: f64 = 2e-2;
    // Its square, 1e-26, is what the Rayleigh quotient of a soft mode may be off by.
    const VELOCITY_ERROR: f64 = 1e-13;
    let error = 4.0 * (modes.count() as f64).sqrt() * f64::EPSILON;
    let is_network = matches!(modes.system.stiffness, Stiffness::Springs(_));
    let all = !is_network || modes.is_unstable();
    DMatrix::from_fn(modes.count(), modes.count(), |i, j| {
        let (soft, stiff) = (modes.rates[i.min(j)], modes.rates[i.max(j)]);
        let is_close = stiff - soft < CLOSE * stiff;
        let is_far = error * stiff > VELOCITY_ERROR * soft;
        i != j && (all || is_close || is_far)
    })
}

/// Shapes on their way to thirty digits.
struct Basis<'a> {
    system: &'a System,
    shapes: DMatrix<Dd>,
    is_rigid: Vec<bool>,
    /// Pairs of modes that are corrected.
    mixed: DMatrix<bool>,
}

impl Basis<'_> {
    /// One correction of all shapes; says whether it was below what matters.
    fn correct(&mut self) -> bool {
        let size = self.shapes.ncols();
        let inertia = inertia_products(self.system, &self.shapes, &self.mixed);
        let mut stiffness = stiffness_products(self.system, &self.shapes, &self.mixed);
        for mode in (0..size).filter(|&mode| self.is_rigid[mode]) {
            // A rigid motion stretches no spring: what stands here is rounding, and would be taken for a
            // coupling.
            stiffness.row_mut(mode).fill(Dd::ZERO);
            stiffness.column_mut(mode).fill(Dd::ZERO);
        }
        let eigenvalues: Vec<Dd> = (0..size)
            .map(|mode| stiffness[(mode, mode)] / inertia[(mode, mode)])
            .collect();
        let mut correction = DMatrix::zeros(size, size);
        let mut entangled = vec![false; size];
        for j in 0..size {
            for i in (0..size).filter(|&i| i == j || self.mixed[(i, j)]) {
                let overlap = inertia[(i, j)];
                let gap = (eigenvalues[j] - eigenvalues[i]).hi();
                let mix = (stiffness[(i, j)] - eigenvalues[j] * overlap).hi();
                // Within a repeated eigenvalue both are rounding.
                let is_told = gap.abs() > TOLD_APART * eigenvalues[j].abs().hi();
                // The step is the first term of a series in mix/gap; from a hundredth on a rotation has to do
                // it.
                let is_separate = is_told && mix.abs() <= 0.01 * gap.abs();
                if i == j {
                    correction[(i, i)] = (1.0 - overlap).hi() / 2.0;
                } else if is_separate {
                    correction[(i, j)] = mix / gap;
                } else {
                    // Half for each of the pair makes them orthogonal, whatever rotation follows.
                    correction[(i, j)] = -overlap.hi() / 2.0;
                    entangled[i.max(j)] |= !(self.is_rigid[i] && self.is_rigid[j]);
                }
            }
        }
        self.add_products(&correction);
        let rotated = self.disentangle(&entangled, &stiffness, &inertia, &eigenvalues);
        let largest = correction
            .iter()
            .fold(0.0_f64, |largest, x| largest.max(x.abs()));
        // The next step would be the square of this one, 1e-30.
        largest < 1e-15 * size as f64 && !rotated
    }

    /// `U <- U + U E`.
    fn add_products(&mut self, correction: &DMatrix<f64>) {
        let size = self.shapes.ncols();
        let before = self.shapes.clone();
        for j in 0..size {
            for k in 0..size {
                let factor = correction[(k, j)];
                if factor == 0.0 {
                    continue;
                }
                for i in 0..size {
                    self.shapes[(i, j)] += before[(i, k)] * factor;
                }
            }
        }
    }

    /// Rotates shapes of nearly equal frequencies among themselves, `entangled[i]` saying that `i` belongs to the group of
    /// `i - 1`; says whether the rotations mattered.
    fn disentangle(
        &mut self,
        entangled: &[bool],
        stiffness: &DMatrix<Dd>,
        inertia: &DMatrix<Dd>,
        eigenvalues: &[Dd],
    ) -> bool {
        let mut rotated = false;
        let mut start = 0;
        while start < entangled.len() {
            let end = (start + 1..entangled.len())
                .find(|&i| !entangled[i])
                .unwrap_or(entangled.len());
            if end > start + 1 {
                let centre = eigenvalues[start];
                let inner = DMatrix::from_fn(end - start, end - start, |i, j| {
                    let (i, j) = (start + i, start + j);
                    // Less what all of them have in common, so that their small differences survive the
                    // rounding to `f64`.
                    (stiffness[(i, j)] - centre * inertia[(i, j)]).hi()
                });
                // Below this it is one repeated frequency, and any rotation of its shapes is as good.
                if inner.amax() > 1e-28 * centre.hi().abs() {
                    rotated = true;
                    self.rotate(start, &Symmetric::of(inner).vectors);
                }
            }
            start = end;
        }
        rotated
    }

    fn rotate(&mut self, start: usize, rotation: &DMatrix<f64>) {
        let count = rotation.ncols();
        let before = self.shapes.columns(start, count).into_owned();
        for j in 0..count {
            for i in 0..self.shapes.nrows() {
                self.shapes[(i, start + j)] =
                    (0..count).fold(Dd::ZERO, |sum, k| sum + before[(i, k)] * rotation[(k, j)]);
            }
        }
    }

    /// Reads off the eigenvalues, normalizes the shapes and puts them in order.
    fn finish(self, modes: &Modes) -> Refined {
        let size = self.shapes.ncols();
        let mut found: Vec<(Dd, Vec<Dd>)> = (0..size)
            .map(|mode| {
                let shape = column(&self.shapes, mode);
                let inertia = inner(shape, &momenta(self.system, shape));
                let rounded: Vec<f64> = shape.iter().map(|x| x.hi()).collect();
                let reversed = is_reversed(&modes.root.weighted(&rounded));
                let length = inertia.sqrt();
                let factor = if reversed { -length } else { length }.recip();
                let eigenvalue = self.eigenvalue(modes, mode, inertia);
                (eigenvalue, shape.iter().map(|x| *x * factor).collect())
            })
            .collect();
        crate::numerics::sort_by(&mut found, |(a, _), (b, _)| {
            a.partial_cmp(b).unwrap_or(Ordering::Equal)
        });
        Refined {
            eigenvalues: found.iter().map(|(eigenvalue, _)| *eigenvalue).collect(),
            shapes: DMatrix::from_iterator(
                size,
                size,
                found.into_iter().flat_map(|(_, shape)| shape),
            ),
        }
    }

    /// The Rayleigh quotient, or the plain eigenvalue where that of a network is below the last of thirty digits.
    fn eigenvalue(&self, modes: &Modes, mode: usize, inertia: Dd) -> Dd {
        // A network's plain eigenvalue is right to fourteen digits. A quotient that differs by more is what a
        // trace of a stiffer motion has left of it.
        const AGREEMENT: f64 = 1e-10;
        if self.is_rigid[mode] {
            return Dd::ZERO;
        }
        let shape = column(&self.shapes, mode);
        let quotient = twice_potential_energy(self.system, shape) / inertia;
        let plain = Dd::product(modes.rates[mode], modes.rates[mode].abs());
        let is_kept = (quotient - plain).abs() <= plain.abs() * AGREEMENT;
        let is_network =
            matches!(self.system.stiffness, Stiffness::Springs(_)) && !modes.is_unstable();
        if is_network && !is_kept {
            plain
        } else {
            quotient
        }
    }
}

fn column(matrix: &DMatrix<Dd>, j: usize) -> &[Dd] {
    &matrix.as_slice()[j * matrix.nrows()..][..matrix.nrows()]
}

/// `Uᵀ M U`.
fn inertia_products(system: &System, shapes: &DMatrix<Dd>, mixed: &DMatrix<bool>) -> DMatrix<Dd> {
    products(shapes, mixed, |momentum, shape| {
        momentum.extend(momenta(system, shape));
    })
}

/// `Uᵀ K U`, from elongations where there are springs.
fn stiffness_products(system: &System, shapes: &DMatrix<Dd>, mixed: &DMatrix<bool>) -> DMatrix<Dd> {
    match &system.stiffness {
        Stiffness::Matrix(stiffness) => products(shapes, mixed, |force, shape| {
            force.extend(image(stiffness, shape));
        }),
        Stiffness::Springs(springs) => {
            let elongations = DMatrix::from_iterator(
                springs.len(),
                shapes.ncols(),
                (0..shapes.ncols()).flat_map(|j| {
                    springs
                        .iter()
                        .map(move |spring| spring.elongation(column(shapes, j)))
                }),
            );
            products(&elongations, mixed, |force, elongation| {
                force.extend(
                    springs
                        .iter()
                        .zip(elongation)
                        .map(|(s, e)| *e * s.coefficient),
                );
            })
        }
        Stiffness::Squares { stiffnesses, rows } => {
            let elongations = DMatrix::from_iterator(
                stiffnesses.len(),
                shapes.ncols(),
                (0..shapes.ncols()).flat_map(|j| image(rows, column(shapes, j))),
            );
            products(&elongations, mixed, |force, elongation| {
                force.extend(stiffnesses.iter().zip(elongation).map(|(k, e)| *e * *k));
            })
        }
    }
}

/// The symmetric matrix of products of columns with the images of columns, where they are needed.
fn products(
    columns: &DMatrix<Dd>,
    needed: &DMatrix<bool>,
    map: impl Fn(&mut Vec<Dd>, &[Dd]),
) -> DMatrix<Dd> {
    let size = columns.ncols();
    let mut result = DMatrix::from_element(size, size, Dd::ZERO);
    let mut mapped = Vec::with_capacity(columns.nrows());
    for j in 0..size {
        mapped.clear();
        map(&mut mapped, column(columns, j));
        for i in (0..=j).filter(|&i| i == j || needed[(i, j)]) {
            let product = inner(column(columns, i), &mapped);
            result[(i, j)] = product;
            result[(j, i)] = product;
        }
    }
    result
}

/// `x·y`.
pub(crate) fn inner(x: &[Dd], y: &[Dd]) -> Dd {
    x.iter().zip(y).map(|(x, y)| *x * *y).sum()
}

/// Matrix times vector.
fn image(matrix: &DMatrix<f64>, vector: &[Dd]) -> Vec<Dd> {
    (0..matrix.nrows())
        .map(|i| {
            (0..matrix.ncols())
                .map(|j| vector[j] * matrix[(i, j)])
                .sum()
        })
        .collect()
}

/// `M v`.
pub(crate) fn momenta(system: &System, velocities: &[Dd]) -> Vec<Dd> {
    match &system.inertia {
        Inertia::Masses(masses) => velocities
            .iter()
            .zip(masses)
            .map(|(v, m)| *v * *m)
            .collect(),
        Inertia::Matrix(mass) => image(mass, velocities),
    }
}

/// `xᵀ K x`, from elongations where there are springs.
fn twice_potential_energy(system: &System, x: &[Dd]) -> Dd {
    match &system.stiffness {
        Stiffness::Springs(springs) => springs
            .iter()
            .map(|spring| spring.elongation(x).square() * spring.coefficient)
            .sum(),
        Stiffness::Squares { stiffnesses, rows } => {
            let elongations = image(rows, x);
            let pairs = stiffnesses.iter().zip(elongations);
            pairs.map(|(k, x)| x.square() * *k).sum()
        }
        Stiffness::Matrix(stiffness) => inner(x, &image(stiffness, x)),
    }
}
