//! Natural frequencies and mode shapes of several degrees of freedom, `K φ = ω² M φ`.
//!
//! A [`System`] says what moves: a network of masses and springs, a potential energy written as squares, or matrices.
//! [`Modes`] solves it once; frequencies are read off, shapes are formed when asked for.
//!
//! The frequencies of a network are accurate to the last digits for any spread of stiffnesses and masses, because its
//! stiffness matrix is never formed: it is eliminated by sums of positive terms, and the frequencies are the singular values
//! of the factor. Rigid motions have the frequency 0, exactly. Motions that grow instead of oscillating are reported by
//! their growth rate. [`Refined`] carries frequencies and shapes to about thirty digits, for long times and for beats.
//!
//! Absent on purpose: complex modes. Motion with general damping goes through the matrix exponential.
//!
//! # References
//!
//! Demmel, Gu, Eisenstat, Slapničar, Veselić, Drmač, Linear Algebra Appl. 299 (1999) 21. Ye, Math. Comp. 77 (2008) 2195.

mod chain;
mod error;
mod factor;
mod mass_root;
mod matrices;
mod network;
mod pair;
mod polished;
mod rayleigh;
mod reduced;
mod refined;
mod solve;
mod system;

pub use error::ModesError;
pub use pair::Pair;
pub use polished::Polished;
pub use refined::Refined;
pub(crate) use refined::{inner, momenta};
pub use solve::natural_angular_frequencies;
pub use system::{Link, MAX_DEGREES_OF_FREEDOM, MAX_ELEMENTS, MAX_WITHOUT_PROOF, System};
pub(crate) use system::{assembled, check_symmetric};

use std::ops::Range;

use nalgebra::DMatrix;

use crate::numerics::jacobi::{ScaledColumns, dot, largest_magnitude};
use mass_root::MassRoot;

/// The modes of a system, in ascending order of `ω²`.
///
/// # Examples
///
/// Two masses between two walls:
///
/// ```
/// use vibank_dynamics::vibration::modes::{Link, Modes};
///
/// let springs = [Link::to_ground(1, 100.0), Link::between(1, 2, 62.5), Link::to_ground(2, 100.0)];
/// let modes = Modes::of_network(&[1.0, 1.0], &springs)?;
/// assert_eq!(modes.natural_angular_frequency(0), Some(10.0));
/// assert_eq!(modes.natural_angular_frequency(1), Some(15.0));
/// assert!(modes.mode_shape(1)[0] > 0.0 && modes.mode_shape(1)[1] < 0.0);
/// # Ok::<(), vibank_dynamics::vibration::modes::ModesError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Modes {
    system: System,
    root: MassRoot,
    /// `ω`, or minus the growth rate.
    rates: Vec<f64>,
    /// Mass-weighted shapes, orthonormal, one after the other.
    vectors: Vec<f64>,
}

impl Modes {
    /// Solves a system.
    ///
    /// # Errors
    ///
    /// [`ModesError::MassNotPositiveDefinite`]; [`ModesError::OutOfRange`] if a frequency is not a finite number;
    /// [`ModesError::NotProven`] for a system of more than [`MAX_WITHOUT_PROOF`] degrees of freedom with modes that are too
    /// close or too far apart.
    pub fn of(system: System) -> Result<Self, ModesError> {
        solve::modes(system)
    }

    /// The modes of point masses (kg) and springs (N/m).
    ///
    /// # Errors
    ///
    /// Those of [`System::of_network`] and [`Modes::of`].
    pub fn of_network(masses: &[f64], springs: &[Link]) -> Result<Self, ModesError> {
        Self::of(System::of_network(masses, springs)?)
    }

    /// The modes of a mass matrix and the potential energy `Σ 1/2 k_s (B q)_s²`.
    ///
    /// # Errors
    ///
    /// Those of [`System::of_squares`] and [`Modes::of`].
    ///
    /// # Examples
    ///
    /// A bar of mass 3 kg and moment of inertia 0.25 kg·m² on two springs one metre apart, in heave and pitch:
    ///
    /// ```
    /// use nalgebra::dmatrix;
    /// use vibank_dynamics::vibration::modes::Modes;
    ///
    /// let mass = dmatrix![3.0, 0.0; 0.0, 0.25];
    /// let elongations = dmatrix![1.0, -0.5; 1.0, 0.5];
    /// let modes = Modes::of_squares(&mass, &elongations, &[150.0, 150.0])?;
    /// assert!((modes.natural_angular_frequency(0).unwrap() - 10.0).abs() < 1e-14);
    /// # Ok::<(), vibank_dynamics::vibration::modes::ModesError>(())
    /// ```
    pub fn of_squares(
        mass: &DMatrix<f64>,
        rows: &DMatrix<f64>,
        stiffnesses: &[f64],
    ) -> Result<Self, ModesError> {
        Self::of(System::of_squares(mass, rows, stiffnesses)?)
    }

    /// The modes of a mass matrix and a stiffness matrix.
    ///
    /// # Errors
    ///
    /// Those of [`System::of_matrices`] and [`Modes::of`].
    ///
    /// # Examples
    ///
    /// An unstable equilibrium:
    ///
    /// ```
    /// use nalgebra::dmatrix;
    /// use vibank_dynamics::vibration::modes::Modes;
    ///
    /// let modes = Modes::of_matrices(&dmatrix![2.0, 0.0; 0.0, 2.0], &dmatrix![0.0, 8.0; 8.0, 0.0])?;
    /// assert_eq!(modes.natural_angular_frequency(0), None);
    /// assert!((modes.growth_rate(0).unwrap() - 2.0).abs() < 1e-15);
    /// assert!((modes.natural_angular_frequency(1).unwrap() - 2.0).abs() < 1e-15);
    /// # Ok::<(), vibank_dynamics::vibration::modes::ModesError>(())
    /// ```
    pub fn of_matrices(mass: &DMatrix<f64>, stiffness: &DMatrix<f64>) -> Result<Self, ModesError> {
        Self::of(System::of_matrices(mass, stiffness)?)
    }

    /// The system whose modes these are.
    pub fn system(&self) -> &System {
        &self.system
    }

    /// Number of modes, which is that of the degrees of freedom.
    pub fn count(&self) -> usize {
        self.rates.len()
    }

    /// Natural angular frequency of a mode in rad/s; 0 for rigid motion, none for motion that grows.
    pub fn natural_angular_frequency(&self, mode: usize) -> Option<f64> {
        self.rates.get(mode).copied().filter(|rate| *rate >= 0.0)
    }

    /// Rate `κ` in 1/s of the motion `exp(κ t)` of an unstable mode, where `ω² = -κ²`; none for the others.
    pub fn growth_rate(&self, mode: usize) -> Option<f64> {
        self.rates
            .get(mode)
            .filter(|rate| **rate < 0.0)
            .map(|rate| -rate)
    }

    /// `ω²` of a mode in 1/s², negative for an unstable one.
    ///
    /// # Panics
    ///
    /// If there is no such mode.
    pub fn eigenvalue(&self, mode: usize) -> f64 {
        self.rates[mode] * self.rates[mode].abs()
    }

    /// Whether any motion grows.
    pub fn is_unstable(&self) -> bool {
        self.rates.iter().any(|rate| *rate < 0.0)
    }

    /// Number of rigid motions.
    pub fn rigid_count(&self) -> usize {
        self.rates.iter().filter(|rate| **rate == 0.0).count()
    }

    /// Mass-normalized shape `φᵀ M φ = 1`, its first component that is not zero positive.
    ///
    /// A component counts as zero below 1e-13 of the largest, mass-weighted.
    ///
    /// # Panics
    ///
    /// If there is no such mode.
    pub fn mode_shape(&self, mode: usize) -> Vec<f64> {
        let weighted = self.weighted_shape(mode);
        let mut shape = self.root.unweighted(weighted);
        if is_reversed(weighted) {
            for x in &mut shape {
                *x = -*x;
            }
        }
        shape
    }

    /// All shapes, as columns.
    pub fn modal_matrix(&self) -> DMatrix<f64> {
        let size = self.count();
        let columns = (0..size).flat_map(|mode| self.mode_shape(mode));
        DMatrix::from_iterator(size, size, columns)
    }

    /// Modal coordinates `p_r = φ_rᵀ M q` of a displacement or velocity.
    ///
    /// # Errors
    ///
    /// [`ModesError::Length`] if the vector does not fit.
    pub fn modal_coordinates(&self, vector: &[f64]) -> Result<Vec<f64>, ModesError> {
        self.check_length(vector)?;
        let weighted = self.root.weighted(vector);
        Ok((0..self.count())
            .map(|mode| {
                let shape = self.weighted_shape(mode);
                let sign = if is_reversed(shape) { -1.0 } else { 1.0 };
                sign * dot(shape, &weighted)
            })
            .collect())
    }

    /// Participation factors `Γ_r = φ_rᵀ M ι` of a base motion that moves coordinate `i` by `ι_i`.
    ///
    /// The effective modal masses `Γ_r²` add up to `ιᵀ M ι`.
    ///
    /// # Errors
    ///
    /// [`ModesError::Length`] if the vector does not fit.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_dynamics::vibration::modes::{Link, Modes};
    ///
    /// let modes = Modes::of_network(&[2.0, 1.0], &[Link::to_ground(1, 3.0), Link::between(1, 2, 1.0)])?;
    /// let factors = modes.participation_factors(&[1.0, 1.0])?;
    /// let effective_mass: f64 = factors.iter().map(|factor| factor * factor).sum();
    /// assert!((effective_mass - 3.0).abs() < 1e-14);
    /// # Ok::<(), vibank_dynamics::vibration::modes::ModesError>(())
    /// ```
    pub fn participation_factors(&self, direction: &[f64]) -> Result<Vec<f64>, ModesError> {
        self.modal_coordinates(direction)
    }

    /// Frequencies and shapes rounded once, up to 64 masses; none if two modes are too close for that, which
    /// [`Self::refined`] tells apart.
    pub fn polished(&self) -> Option<Polished> {
        Polished::of(self)
    }

    /// Frequencies and shapes to about thirty digits.
    pub fn refined(&self) -> Refined {
        Refined::of(self)
    }

    /// The same for motions in which modes pass energy to others, so that all digits of all shapes matter.
    pub(crate) fn fully_refined(&self) -> Refined {
        Refined::of_all_pairs(self)
    }

    pub(crate) fn check_length(&self, vector: &[f64]) -> Result<(), ModesError> {
        if vector.len() != self.count() {
            return Err(ModesError::Length {
                length: vector.len(),
                size: self.count(),
            });
        }
        Ok(())
    }

    fn weighted_shape(&self, mode: usize) -> &[f64] {
        &self.vectors[mode * self.count()..][..self.count()]
    }

    /// Groups of consecutive modes whose frequencies differ by at most `tolerance` times the larger one.
    ///
    /// # Examples
    ///
    /// An equilateral ring of three masses: one rigid motion, then two motions of the same frequency.
    ///
    /// ```
    /// use vibank_dynamics::vibration::modes::{Link, Modes};
    ///
    /// let ring = [Link::between(1, 2, 5.0), Link::between(2, 3, 5.0), Link::between(3, 1, 5.0)];
    /// let modes = Modes::of_network(&[1.0; 3], &ring)?;
    /// assert_eq!(modes.clusters(1e-9), [0..1, 1..3]);
    /// # Ok::<(), vibank_dynamics::vibration::modes::ModesError>(())
    /// ```
    pub fn clusters(&self, tolerance: f64) -> Vec<Range<usize>> {
        let mut clusters: Vec<Range<usize>> = Vec::new();
        for (mode, &rate) in self.rates.iter().enumerate() {
            let is_close =
                |other: f64| (rate - other).abs() <= tolerance * rate.abs().max(other.abs());
            match clusters.last_mut() {
                Some(cluster) if is_close(self.rates[mode - 1]) => cluster.end = mode + 1,
                _ => clusters.push(mode..mode + 1),
            }
        }
        clusters
    }

    /// Smallest relative distance of a group of modes to the other frequencies; infinite if there are none.
    ///
    /// The shapes of the group are determined to about the precision of the data over this number.
    pub fn relative_gap(&self, cluster: Range<usize>) -> f64 {
        let distance = |inside: usize, outside: usize| {
            let (a, b) = (self.rates[inside], self.rates[outside]);
            if a == b {
                0.0
            } else {
                (a - b).abs() / a.abs().max(b.abs())
            }
        };
        let last = cluster.end.min(self.count()).saturating_sub(1);
        let below = cluster
            .start
            .checked_sub(1)
            .map(|outside| distance(cluster.start, outside));
        let above = (last + 1 < self.count()).then(|| distance(last, last + 1));
        below.into_iter().chain(above).fold(f64::INFINITY, f64::min)
    }

    /// Sine of the largest angle between the span of some shapes and that of a group of modes, in the inner product of M.
    ///
    /// ```text
    /// max over w in the span of  |(I - U Uᵀ M) w| / |w|,    |w|² = wᵀ M w
    /// ```
    ///
    /// For one shape this is `sqrt(1 - MAC)`. Scale, sign and order are free; dependent shapes count as what they span.
    ///
    /// # Errors
    ///
    /// A shape that does not fit the system or is not finite.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_dynamics::vibration::modes::{Link, Modes};
    ///
    /// let springs = [Link::to_ground(1, 2.0), Link::between(1, 2, 1.0), Link::to_ground(2, 2.0)];
    /// let modes = Modes::of_network(&[1.0, 1.0], &springs)?;
    /// assert!(modes.largest_principal_angle_sine(0..1, &[vec![3.0, 3.0]])? < 1e-15);
    /// assert!(modes.largest_principal_angle_sine(1..2, &[vec![3.0, 3.0]])? > 0.999);
    /// # Ok::<(), vibank_dynamics::vibration::modes::ModesError>(())
    /// ```
    ///
    /// # References
    ///
    /// Björck, Golub, Math. Comp. 27 (1973) 579. Allemang, Sound and Vibration 37 (2003) 14.
    pub fn largest_principal_angle_sine(
        &self,
        cluster: Range<usize>,
        shapes: &[Vec<f64>],
    ) -> Result<f64, ModesError> {
        let mut entries = Vec::new();
        for shape in shapes {
            self.check_length(shape)?;
            if shape.iter().any(|x| !x.is_finite()) {
                return Err(ModesError::NotFinite);
            }
            // Before the weights and after them: shapes are typed in any unit, and neither products nor
            // squares are to overflow.
            entries.extend(normalized(self.root.weighted(&normalized(shape.clone()))));
        }
        let span =
            ScaledColumns::new(self.count(), entries, vec![1.0; shapes.len()]).left_singular();
        let independent = span
            .values
            .iter()
            .zip(span.vectors.chunks_exact(self.count()))
            // Columns have a largest entry of one: less than this is what rounding leaves of a shape that
            // depends on the others.
            .filter(|(value, _)| **value > 1e-12);
        let mut residuals = Vec::new();
        for (_, direction) in independent {
            residuals.extend(self.without(cluster.clone(), direction));
        }
        let count = residuals.len() / self.count();
        let sines = ScaledColumns::new(self.count(), residuals, vec![1.0; count]).left_singular();
        Ok(sines.values.last().copied().unwrap_or(0.0).min(1.0))
    }

    /// What a weighted direction has outside a group of modes.
    fn without(&self, cluster: Range<usize>, direction: &[f64]) -> Vec<f64> {
        let mut rest = direction.to_vec();
        for mode in cluster.start..cluster.end.min(self.count()) {
            let shape = self.weighted_shape(mode);
            let overlap = dot(&rest, shape);
            rest.iter_mut()
                .zip(shape)
                .for_each(|(x, y)| *x -= overlap * y);
        }
        rest
    }
}

/// Whether the first component that is not zero is negative.
fn is_reversed(weighted: &[f64]) -> bool {
    let largest = largest_magnitude(weighted);
    weighted
        .iter()
        .find(|x| x.abs() > 1e-13 * largest)
        .is_some_and(|x| *x < 0.0)
}

/// The vector over its largest component, or zero.
fn normalized(mut vector: Vec<f64>) -> Vec<f64> {
    let largest = largest_magnitude(&vector);
    if largest > 0.0 {
        for x in &mut vector {
            *x /= largest;
        }
    }
    vector
}
