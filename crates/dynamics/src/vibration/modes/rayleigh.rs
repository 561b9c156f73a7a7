//! Rayleigh quotients of networks with a proof: what they are off by follows from what the forces leave over.
//!
//! The quotient `ρ = Σ k e² / Σ m φ²` is a sum of positive terms, and with the residual `r = |K φ - ρ M φ|` in the norm of
//! `M⁻¹`, `φ` of length one, there is an eigenvalue within `r` of it. If the intervals of all modes are apart, each holds
//! exactly one, and that one is within `r²/gap` of the quotient, the gap being the distance to the nearest other interval.
//!
//! # References
//!
//! Parlett, The Symmetric Eigenvalue Problem, SIAM 1998, sections 4.5 and 11.7 (Kato, Temple).

use super::factor::root_of_ratio;
use super::system::Link;
use crate::numerics::{Dd, two_sum};

/// Modes worked out side by side.
const LANES: usize = 8;

type ModeLanes = [f64; LANES];

/// Terms that are summed plainly before their sum is added without error: three roundings at most are left of it.
const PLAIN: usize = 16;

/// Eigenvalues that are proven may be off by this part, a quarter of a unit in the last place of the frequency.
const PROVEN: f64 = f64::EPSILON / 4.0;

/// What the springs say of mass-weighted shapes, one after the other.
pub(crate) fn of_springs(masses: &[f64], springs: &[Link], weighted: &[f64]) -> Vec<Mode> {
    let size = masses.len();
    let mut motion = ModeMotion::of(masses);
    let mut modes = Vec::with_capacity(weighted.len() / size);
    for block in weighted.chunks(LANES * size) {
        motion.take(block);
        modes.extend_from_slice(&motion.energies(springs)[..block.len() / size]);
    }
    modes
}

/// A quotient, and the length of what its shape leaves over.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Mode {
    pub(crate) frequency: f64,
    pub(crate) eigenvalue: f64,
    pub(crate) residual: f64,
}

/// Whether all intervals of modes in ascending order are apart, and the quotients closer to the eigenvalues than matters.
///
/// Rigid motions, which are known, are not among the modes; `is_free` says whether there are some.
pub(crate) fn are_proven(modes: &[Mode], is_free: bool) -> bool {
    (0..modes.len()).all(|i| {
        let mode = &modes[i];
        let below = match i.checked_sub(1) {
            Some(other) => mode.eigenvalue - (modes[other].eigenvalue + modes[other].residual),
            None if is_free => mode.eigenvalue,
            None => f64::INFINITY,
        };
        let above = modes.get(i + 1).map_or(f64::INFINITY, |other| {
            (other.eigenvalue - other.residual) - mode.eigenvalue
        });
        let gap = below.min(above);
        let square = mode.residual * mode.residual;
        gap > mode.residual && square <= PROVEN * mode.eigenvalue * gap
    })
}

/// Displacements and forces of several modes.
struct ModeMotion<'a> {
    masses: &'a [f64],
    roots: Vec<f64>,
    /// The displacements of all nodes, the ground first.
    displacements: Vec<ModeLanes>,
    forces: Vec<ModeLanes>,
}

impl<'a> ModeMotion<'a> {
    fn of(masses: &'a [f64]) -> Self {
        let empty = vec![[0.0; LANES]; masses.len() + 1];
        Self {
            masses,
            roots: masses
                .iter()
                .map(|m| root_of_ratio(*m, masses[0]))
                .collect(),
            displacements: empty.clone(),
            forces: empty,
        }
    }

    /// Takes up shapes; lanes that are left over keep what they had.
    fn take(&mut self, weighted: &[f64]) {
        for (lane, shape) in weighted.chunks_exact(self.masses.len()).enumerate() {
            let nodes = self.displacements[1..].iter_mut();
            for (node, (y, root)) in nodes.zip(shape.iter().zip(&self.roots)) {
                // In units of the root of the first mass, which cancels in the quotient.
                node[lane] = y / root;
            }
        }
    }

    fn energies(&mut self, springs: &[Link]) -> [Mode; LANES] {
        self.forces.fill([0.0; LANES]);
        let mut potential = Sum::default();
        for block in springs.chunks(PLAIN) {
            let mut plain = [0.0; LANES];
            for spring in block {
                let [first, second] = spring.ends;
                let (x, y) = (self.displacements[first], self.displacements[second]);
                let mut force = [0.0; LANES];
                for lane in 0..LANES {
                    let elongation = x[lane] - y[lane];
                    force[lane] = spring.coefficient * elongation;
                    plain[lane] += force[lane] * elongation;
                }
                for lane in 0..LANES {
                    self.forces[first][lane] += force[lane];
                    self.forces[second][lane] -= force[lane];
                }
            }
            potential.add(plain);
        }
        let kinetic = self.kinetic();
        let quotients: [Dd; LANES] =
            std::array::from_fn(|lane| potential.total(lane) / kinetic.total(lane));
        let residuals = self.squared_residuals(quotients.map(Dd::hi));
        std::array::from_fn(|lane| Mode {
            frequency: quotients[lane].sqrt().hi(),
            eigenvalue: quotients[lane].hi(),
            residual: (residuals[lane] / kinetic.high[lane]).sqrt(),
        })
    }

    /// `Σ m φ²`.
    fn kinetic(&self) -> Sum {
        let mut sum = Sum::default();
        let blocks = self.displacements[1..].chunks(PLAIN);
        for (nodes, masses) in blocks.zip(self.masses.chunks(PLAIN)) {
            let mut plain = [0.0; LANES];
            for (node, mass) in nodes.iter().zip(masses) {
                for lane in 0..LANES {
                    plain[lane] += mass * node[lane] * node[lane];
                }
            }
            sum.add(plain);
        }
        sum
    }

    /// `Σ (f - ρ m φ)²/m`.
    fn squared_residuals(&self, quotients: ModeLanes) -> ModeLanes {
        let mut sums = [0.0; LANES];
        let nodes = self.displacements[1..].iter().zip(&self.forces[1..]);
        for ((node, forces), mass) in nodes.zip(self.masses) {
            for lane in 0..LANES {
                let rest = forces[lane] - quotients[lane] * (mass * node[lane]);
                sums[lane] += rest * rest / mass;
            }
        }
        sums
    }
}

/// Sums with the errors of their additions.
#[derive(Default)]
struct Sum {
    high: ModeLanes,
    low: ModeLanes,
}

impl Sum {
    fn add(&mut self, terms: ModeLanes) {
        for lane in 0..LANES {
            let (sum, error) = two_sum(self.high[lane], terms[lane]);
            self.high[lane] = sum;
            self.low[lane] += error;
        }
    }

    fn total(&self, lane: usize) -> Dd {
        Dd::sum(self.high[lane], self.low[lane])
    }
}
