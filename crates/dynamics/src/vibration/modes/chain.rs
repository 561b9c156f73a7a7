//! Frequencies of masses in a row.

use super::system::Link;
use crate::numerics::bidiagonal;

/// Masses in a row: each spring joins neighbours or a mass and the ground.
pub(super) struct Chain<'a> {
    masses: &'a [f64],
    ground: Vec<f64>,
    /// Springs between mass i and mass i+1.
    couplings: Vec<f64>,
}

impl<'a> Chain<'a> {
    pub(super) fn of(masses: &'a [f64], springs: &[Link]) -> Option<Self> {
        const LARGEST: f64 = 1e280;
        let mut ground = vec![0.0; masses.len()];
        let mut couplings = vec![0.0; masses.len() - 1];
        for spring in springs {
            match spring.ends {
                _ if spring.coefficient > LARGEST => return None,
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

    /// Eliminated from the first mass on, the factor is bidiagonal, and all its entries are accurate.
    pub(super) fn natural_angular_frequencies(&self) -> Option<Vec<f64>> {
        let size = self.masses.len();
        let mut squares = Vec::with_capacity(size);
        let mut off_squares = Vec::with_capacity(size - 1);
        let mut ground = self.ground[0];
        for i in 0..size {
            let coupling = self.couplings.get(i).copied().unwrap_or(0.0);
            let pivot = ground + coupling;
            squares.push(pivot / self.masses[i]);
            if i + 1 < size {
                let share = if coupling == 0.0 {
                    0.0
                } else {
                    coupling / pivot
                };
                off_squares.push(share * (coupling / self.masses[i + 1]));
                ground = self.ground[i + 1] + share * ground;
            }
        }
        bidiagonal::singular_values(squares, off_squares)
    }
}
