//! The steady state under a harmonic force.

use nalgebra::DMatrix;

use super::Damping;
use crate::numerics::complex_lu::ComplexSystem;
use crate::numerics::{Complex, Dd};
use crate::vibration::modes::{ModesError, System};

/// The steady motion `x = Re(X e^{iΩt})` under a force `Re(F e^{iΩt})`,
///
/// ```text
/// (K - Ω² M + iΩ C) X = F
/// ```
///
/// for any damping. The differences `K - Ω² M` are formed exactly, so that the response stays accurate next to resonance.
///
/// # Examples
///
/// A vibration absorber: at its own frequency the main mass stands still.
///
/// ```
/// use vibank_dynamics::numerics::Complex;
/// use vibank_dynamics::vibration::modal::{Damping, HarmonicResponse};
/// use vibank_dynamics::vibration::modes::{Link, System};
///
/// let system = System::of_network(&[10.0, 1.0], &[Link::to_ground(1, 90.0), Link::between(1, 2, 9.0)])?;
/// let response = HarmonicResponse::of(&system, &Damping::none(), 3.0)?;
/// let amplitudes = response.amplitudes(&[Complex::from(18.0), Complex::ZERO])?;
/// assert_eq!(amplitudes, [Complex::ZERO, Complex::from(-2.0)]);
/// # Ok::<(), vibank_dynamics::vibration::modes::ModesError>(())
/// ```
#[derive(Debug, Clone)]
pub struct HarmonicResponse {
    size: usize,
    dynamic_stiffness: ComplexSystem,
}

impl HarmonicResponse {
    /// The response at an angular frequency in rad/s.
    ///
    /// # Errors
    ///
    /// Damping that does not fit the system; [`ModesError::Resonance`] if there is no steady state.
    pub fn of(
        system: &System,
        damping: &Damping,
        angular_frequency: f64,
    ) -> Result<Self, ModesError> {
        let size = system.degrees_of_freedom();
        damping.check(size)?;
        if !angular_frequency.is_finite() {
            return Err(ModesError::NotFinite);
        }
        let square = Dd::product(angular_frequency, angular_frequency);
        let mut real = system.exact_stiffness_matrix();
        real.zip_apply(&system.mass_matrix(), |k, m| *k -= square * m);
        let imaginary: DMatrix<Dd> = damping.matrix(system).map(|c| c * angular_frequency);
        if real.iter().chain(imaginary.iter()).any(|x| !x.is_finite()) {
            return Err(ModesError::OutOfRange);
        }
        let dynamic_stiffness = ComplexSystem::of(real, imaginary).ok_or(ModesError::Resonance)?;
        Ok(Self {
            size,
            dynamic_stiffness,
        })
    }

    /// Complex amplitudes in m of the displacements under forces in N.
    ///
    /// # Errors
    ///
    /// A vector that does not fit or is not finite; [`ModesError::Resonance`] if an amplitude is not finite.
    pub fn amplitudes(&self, forces: &[Complex]) -> Result<Vec<Complex>, ModesError> {
        if forces.len() != self.size {
            return Err(ModesError::Length {
                length: forces.len(),
                size: self.size,
            });
        }
        if forces.iter().any(|force| !force.is_finite()) {
            return Err(ModesError::NotFinite);
        }
        let amplitudes = self.dynamic_stiffness.solve(forces);
        if amplitudes.iter().all(|amplitude| amplitude.is_finite()) {
            Ok(amplitudes)
        } else {
            Err(ModesError::Resonance)
        }
    }

    /// Receptances in m/N: the displacements of all coordinates under a unit force at one of them.
    ///
    /// # Errors
    ///
    /// [`ModesError::Length`] if there is no such coordinate; [`ModesError::Resonance`] if an amplitude is not finite.
    pub fn receptances(&self, coordinate: usize) -> Result<Vec<Complex>, ModesError> {
        let mut forces = vec![Complex::ZERO; self.size];
        match forces.get_mut(coordinate) {
            Some(force) => *force = Complex::ONE,
            None => {
                return Err(ModesError::Length {
                    length: coordinate + 1,
                    size: self.size,
                });
            }
        }
        self.amplitudes(&forces)
    }
}
