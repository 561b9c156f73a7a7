//! Viscous damping of several degrees of freedom.

use nalgebra::DMatrix;

use crate::numerics::Dd;
use crate::vibration::modes::{
    Link, ModesError, Refined, System, assembled, check_symmetric, inner,
};

/// The damping matrix `C = α M + β K + dampers`.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::vibration::modal::Damping;
/// use vibank_dynamics::vibration::modes::Link;
///
/// let damping = Damping::rayleigh(0.1, 2e-4).with_dampers(&[Link::to_ground(1, 3.0)]);
/// assert_ne!(damping, Damping::none());
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Damping {
    mass_factor: f64,
    stiffness_factor: f64,
    dampers: Vec<Link>,
    matrix: Option<DMatrix<f64>>,
}

impl Damping {
    /// No damping.
    pub fn none() -> Self {
        Self::default()
    }

    /// Damping proportional to mass and stiffness, `α` in 1/s and `β` in s.
    pub fn rayleigh(mass_factor: f64, stiffness_factor: f64) -> Self {
        Self::none().with_rayleigh(mass_factor, stiffness_factor)
    }

    /// Dampers in N·s/m between masses, or a mass and the ground.
    pub fn of_dampers(dampers: &[Link]) -> Self {
        Self::none().with_dampers(dampers)
    }

    /// A symmetric damping matrix.
    pub fn of_matrix(matrix: &DMatrix<f64>) -> Self {
        Self::none().with_matrix(matrix)
    }

    /// The same with these factors of mass and stiffness.
    #[must_use]
    pub fn with_rayleigh(mut self, mass_factor: f64, stiffness_factor: f64) -> Self {
        self.mass_factor = mass_factor;
        self.stiffness_factor = stiffness_factor;
        self
    }

    /// The same with dampers added.
    #[must_use]
    pub fn with_dampers(mut self, dampers: &[Link]) -> Self {
        self.dampers.extend_from_slice(dampers);
        self
    }

    /// The same with this symmetric matrix.
    #[must_use]
    pub fn with_matrix(mut self, matrix: &DMatrix<f64>) -> Self {
        self.matrix = Some(matrix.clone());
        self
    }

    /// Checks the damping against a system.
    pub(crate) fn check(&self, size: usize) -> Result<(), ModesError> {
        Link::check_all(&self.dampers, size)?;
        if !(self.mass_factor.is_finite() && self.stiffness_factor.is_finite()) {
            return Err(ModesError::NotFinite);
        }
        match &self.matrix {
            Some(matrix) => check_symmetric(matrix, size),
            None => Ok(()),
        }
    }

    /// `Uᵀ C U` for mass-normalized shapes.
    pub(crate) fn in_modes(&self, modes: &Refined) -> DMatrix<Dd> {
        let size = modes.count();
        let mut modal = DMatrix::from_element(size, size, Dd::ZERO);
        for mode in 0..size {
            modal[(mode, mode)] = modes.eigenvalue(mode) * self.stiffness_factor + self.mass_factor;
        }
        let elongations: Vec<Vec<Dd>> = (0..size)
            .map(|mode| {
                self.dampers
                    .iter()
                    .map(|damper| damper.elongation(modes.shape(mode)))
                    .collect()
            })
            .collect();
        for s in 0..size {
            let rates = self.dampers.iter().zip(&elongations[s]);
            let forces: Vec<Dd> = rates
                .map(|(damper, rate)| *rate * damper.coefficient)
                .collect();
            for r in 0..=s {
                let mut entry = inner(&elongations[r], &forces);
                if let Some(matrix) = &self.matrix {
                    entry += form(matrix, modes.shape(r), modes.shape(s));
                }
                modal[(r, s)] += entry;
                if r != s {
                    modal[(s, r)] += entry;
                }
            }
        }
        modal
    }

    /// The damping matrix in the coordinates of the system.
    pub(crate) fn matrix(&self, system: &System) -> DMatrix<Dd> {
        let size = system.degrees_of_freedom();
        let mut sum = assembled(&self.dampers, size);
        sum.zip_apply(&system.mass_matrix(), |c, m| {
            *c += Dd::product(m, self.mass_factor);
        });
        sum.zip_apply(&system.exact_stiffness_matrix(), |c, k| {
            *c += k * self.stiffness_factor;
        });
        if let Some(matrix) = &self.matrix {
            sum.zip_apply(matrix, |c, more| *c += more);
        }
        sum
    }
}

/// `xᵀ C y`.
fn form(matrix: &DMatrix<f64>, x: &[Dd], y: &[Dd]) -> Dd {
    x.iter().enumerate().fold(Dd::ZERO, |sum, (i, x)| {
        let force = y
            .iter()
            .enumerate()
            .fold(Dd::ZERO, |sum, (j, y)| sum + *y * matrix[(i, j)]);
        sum + *x * force
    })
}
