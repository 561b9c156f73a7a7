//! Masses in a row.

use super::system::Link;
use crate::numerics::bidiagonal;
use crate::numerics::tridiagonal::{Factored, eigenvalues};

/// Masses in a row: each spring joins neighbours or a mass and the ground.
pub(crate) struct Chain<'a> {
    masses: &'a [f64],
    ground: Vec<f64>,
    /// Springs between mass i and mass i+1.
    couplings: Vec<f64>,
}

impl<'a> Chain<'a> {
    pub(crate) fn of(masses: &'a [f64], springs: &[Link]) -> Option<Self> {
        // The sum of as many springs as are accepted, 100,000, is then still a finite number.
        const MAX_STIFFNESS: f64 = 1e280;
        let mut ground = vec![0.0; masses.len()];
        let mut couplings = vec![0.0; masses.len() - 1];
        for spring in springs {
            match spring.ends {
                _ if spring.coefficient > MAX_STIFFNESS => return None,
                [0, node] | [node, 0] => ground[node - 1] += spring.coefficient,
                [first, second] if first.abs_diff(second) == 1 => {
                    couplings[first.min(second) - 1] += spring.coefficient;
                }
                _ => return None,
            }
        }
        Some(Self {
            masses,
            ground,
            couplings,
        })
    }

    /// Frequencies in ascending order, to high relative accuracy.
    pub(crate) fn natural_angular_frequencies(&self) -> Option<Vec<f64>> {
        let Eliminated {
            squares,
            off_squares,
            ..
        } = self.eliminated();
        bidiagonal::singular_values(squares, off_squares)
    }

    /// Whether no spring holds it to the ground.
    pub(crate) fn is_free(&self) -> bool {
        self.ground.iter().all(|stiffness| *stiffness == 0.0)
    }

    /// Mass-weighted shapes in the order of their frequencies, but for the rigid one; none for a chain that falls apart.
    ///
    /// The mass-weighted stiffness matrix comes as a product of accurate factors, so that shapes are as good as the relative
    /// distances of the frequencies allow.
    pub(crate) fn elastic_shapes(&self) -> Option<Vec<f64>> {
        // Parts of a chain that fell apart may have the same frequency, and shapes are distinguished by their
        // frequencies alone.
        if self.couplings.contains(&0.0) {
            return None;
        }
        let Eliminated { squares, lower, .. } = self.eliminated();
        let largest = squares.iter().copied().fold(0.0, f64::max);
        // Relative: a factor for all entries changes no shape, and their squares are to stay in range.
        let diagonal = squares.iter().map(|square| square / largest).collect();
        let factored = Factored::new(diagonal, lower);
        let [diagonal, off_diagonal] = factored.product();
        let approximate = eigenvalues(&diagonal, &off_diagonal)?;
        let elastic = &approximate[usize::from(self.is_free())..];
        let pairs = factored.eigenpairs(elastic)?;
        pairs
            .values
            .first()
            .is_some_and(|value| *value > 0.0)
            .then_some(pairs.vectors)
    }

    /// Eliminated from the first mass on, the factor is bidiagonal, and all its entries are accurate.
    fn eliminated(&self) -> Eliminated {
        let size = self.masses.len();
        let mut squares = Vec::with_capacity(size);
        let mut off_squares = Vec::with_capacity(size - 1);
        let mut lower = Vec::with_capacity(size - 1);
        let mut ground = self.ground[0];
        for i in 0..size {
            let coupling = self.couplings.get(i).copied().unwrap_or(0.0);
            let pivot = ground + coupling;
            squares.push(pivot / self.masses[i]);
            if i + 1 < size {
                // A free mass at the end has no pivot, and 0/0 is undefined.
                let share = if coupling == 0.0 {
                    0.0
                } else {
                    coupling / pivot
                };
                off_squares.push(share * (coupling / self.masses[i + 1]));
                lower.push(-share * (self.masses[i] / self.masses[i + 1]).sqrt());
                ground = self.ground[i + 1] + share * ground;
            }
        }
        Eliminated {
            squares,
            off_squares,
            lower,
        }
    }
}

/// The factor of a mass-weighted stiffness matrix: its squared entries, and those beside the diagonal over the ones on it.
struct Eliminated {
    squares: Vec<f64>,
    off_squares: Vec<f64>,
    lower: Vec<f64>,
}
