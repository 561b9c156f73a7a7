//! Networks of attractive springs: elimination and rotations.

use super::solve::{ModalBasis, completed};
use super::system::Link;
use super::{ModesError, Pair, factor, rayleigh, reduced};
use crate::numerics::jacobi::dot;
use crate::numerics::{Dd, ascending};

pub(crate) fn solve(masses: &[f64], springs: &[Link]) -> Result<ModalBasis, ModesError> {
    // The cheapest first; each gives way where it would lose digits.
    if let Some(solution) = pair(masses, springs) {
        return Ok(solution);
    }
    if let Some(solution) = reduced::of_network(masses, springs) {
        return Ok(solution);
    }
    ModesError::refuse_unproven(masses.len())?;
    let elastic = factor::of_network(masses, springs).left_singular();
    let mut solution = completed(masses.len(), elastic, || rigid_motions(masses, springs));
    remove_stiff_motions(masses, springs, &mut solution);
    take_rayleigh_quotients(masses, springs, &mut solution);
    Ok(solution)
}

/// Two masses whose closed form is in range.
fn pair(masses: &[f64], springs: &[Link]) -> Option<ModalBasis> {
    let &[first, second] = masses else {
        return None;
    };
    let mut sums = [0.0; 3];
    for spring in springs {
        match spring.ends {
            [0, 1] | [1, 0] => sums[0] += spring.coefficient,
            [0, 2] | [2, 0] => sums[2] += spring.coefficient,
            _ => sums[1] += spring.coefficient,
        }
    }
    Pair::is_in_range(masses, sums).then(|| ModalBasis {
        rates: Pair::exact_frequencies([first, second], sums).to_vec(),
        vectors: Pair::of_network([first, second], sums)
            .weighted_shapes()
            .concat(),
    })
}

/// Mass-weighted translations of the parts that no spring ties to the ground.
fn rigid_motions(masses: &[f64], springs: &[Link]) -> Vec<Vec<f64>> {
    let part = parts(masses.len(), springs);
    let ground = part[0];
    (1..part.len())
        .filter(|&node| part[node] == node && node != ground)
        .map(|free| {
            let largest = (1..part.len())
                .filter(|&node| part[node] == free)
                // Over the largest of its masses, so that the sum of the squares below stays in range.
                .map(|node| masses[node - 1])
                .fold(0.0, f64::max);
            let mut motion: Vec<f64> = (1..part.len())
                .map(|node| {
                    if part[node] == free {
                        (masses[node - 1] / largest).sqrt()
                    } else {
                        0.0
                    }
                })
                .collect();
            let length = dot(&motion, &motion).sqrt();
            for x in &mut motion {
                *x /= length;
            }
            motion
        })
        .collect()
}

/// For each node, the ground first, the first node of the connected part it belongs to.
fn parts(nodes: usize, springs: &[Link]) -> Vec<usize> {
    let mut parent: Vec<usize> = (0..=nodes).collect();
    for spring in springs.iter().filter(|spring| spring.coefficient != 0.0) {
        let [first, second] = spring.ends.map(|node| root(&parent, node));
        // The smaller node is the root: so all that is tied to the ground has the ground, node 0, for it.
        parent[first.max(second)] = first.min(second);
    }
    (0..=nodes).map(|node| root(&parent, node)).collect()
}

/// The root of the tree in which a node stands.
fn root(parent: &[usize], mut node: usize) -> usize {
    while parent[node] != node {
        node = parent[node];
    }
    node
}

/// The elongations of all springs in all modes, up to a common factor.
struct Displacements<'a> {
    springs: &'a [Link],
    /// Elongations of one mode after the other.
    elongations: Vec<f64>,
}

impl<'a> Displacements<'a> {
    fn of(masses: &[f64], springs: &'a [Link], vectors: &[f64]) -> Self {
        let roots: Vec<f64> = masses
            .iter()
            .map(|m| factor::root_of_ratio(*m, masses[0]))
            .collect();
        let elongations = vectors
            .chunks_exact(masses.len())
            .flat_map(|weighted| {
                let shape = displacement(weighted, &roots);
                springs.iter().map(move |spring| spring.elongation(&shape))
            })
            .collect();
        Self {
            springs,
            elongations,
        }
    }

    fn elongations(&self, mode: usize) -> &[f64] {
        &self.elongations[mode * self.springs.len()..][..self.springs.len()]
    }

    /// `φᵢᵀ K φⱼ` as a sum over the springs.
    fn coupling(&self, i: usize, j: usize) -> f64 {
        let pairs = self.elongations(i).iter().zip(self.elongations(j));
        self.springs
            .iter()
            .zip(pairs)
            .map(|(spring, (x, y))| spring.coefficient * x * y)
            .sum()
    }
}

fn displacement(weighted: &[f64], roots: &[f64]) -> Vec<f64> {
    weighted
        .iter()
        .zip(roots)
        .map(|(y, root)| y / root)
        .collect()
}

/// Takes out of each shape what it has of motions that are much stiffer.
///
/// Rounding leaves as much of every motion in a shape. A stiff one of light masses moves them far, so that little of it
/// is seen in mass-weighted displacements; but it is known much better from the forces. One step of the correction of Ogita
/// and Aishima for these pairs of modes. Skipped for densely coupled networks, where it would cost as much as all the rest.
fn remove_stiff_motions(masses: &[f64], springs: &[Link], solution: &mut ModalBasis) {
    // On like springs a motion that is r times as fast is one of masses r² times lighter: u of it,
    // mass-weighted, moves them by r u. Up to this ratio that is 1e-14 and left as it is.
    const STIFFER: f64 = 100.0;
    let ModalBasis { rates, vectors } = solution;
    let size = masses.len();
    let (Some(&softest), Some(&stiffest)) = (rates.iter().find(|rate| **rate > 0.0), rates.last())
    else {
        return;
    };
    if stiffest <= STIFFER * softest || !is_sparse_and_in_range(masses, springs, stiffest) {
        return;
    }
    let displacements = Displacements::of(masses, springs, vectors);
    // All steps start from the same shapes, as one product of matrices does: the order of the pairs must not
    // matter.
    let before = vectors.clone();
    let weighted = |mode: usize| &before[mode * size..][..size];
    for soft in 0..size {
        let rate = rates[soft];
        let first = if rate > 0.0 {
            rates.partition_point(|other| *other <= STIFFER * rate)
        } else {
            size
        };
        for (stiff, stiff_rate) in rates.iter().enumerate().skip(first) {
            let (soft_square, stiff_square) = (rate * rate, stiff_rate * stiff_rate);
            let overlap = dot(weighted(soft), weighted(stiff));
            // Elongations are those of shapes times the root of the first mass.
            let coupling = displacements.coupling(soft, stiff) / masses[0];
            let share = (coupling - soft_square * overlap) / (soft_square - stiff_square);
            let target = &mut vectors[soft * size..][..size];
            target
                .iter_mut()
                .zip(weighted(stiff))
                .for_each(|(x, y)| *x += share * y);
        }
    }
}

/// Frequencies this far below the largest, over the size, are left as they are; see [`are_spread`].
// At this ratio r a shape that is off by 10 n u spoils its quotient by (10 u r)² = 1e-17, a tenth of u.
const WIDEST: f64 = 3e6;

/// Whether some elastic frequency is so far below the largest that the error of its Rayleigh quotient, the square of the
/// shape's times the ratio of the eigenvalues, may exceed rounding.
pub(crate) fn are_spread(rates: &[f64]) -> bool {
    let softest = rates.iter().find(|rate| **rate > 0.0);
    let stiffest = rates.last().copied().unwrap_or_default();
    softest.is_some_and(|softest| softest * WIDEST < stiffest * rates.len() as f64)
}

/// Frequencies of so few masses come from sums of thirty digits: their error may be three units, and rounded sums take all of
/// that.
const FEW: usize = 4;

/// Replaces frequencies by Rayleigh quotients `Σ k e² / Σ m φ²`: sums of positive terms, whose error is that of the shape
/// squared.
fn take_rayleigh_quotients(masses: &[f64], springs: &[Link], solution: &mut ModalBasis) {
    /// Squares of extreme frequencies leave the range of numbers, and the quotient with them.
    const AGREEMENT: f64 = 1e-12;
    let ModalBasis { rates, vectors } = solution;
    let size = masses.len();
    let stiffest = rates.last().copied().unwrap_or_default();
    if size > FEW && !is_sparse_and_in_range(masses, springs, stiffest) {
        return;
    }
    let quotients = if size > reduced::SMALL {
        let modes = rayleigh::of_springs(masses, springs, vectors);
        modes.iter().map(|mode| mode.frequency).collect()
    } else {
        few_quotients(masses, springs, vectors)
    };
    for (rate, quotient) in rates.iter_mut().zip(quotients) {
        if *rate * WIDEST < stiffest * size as f64 {
            continue;
        }
        if (quotient - *rate).abs() <= AGREEMENT * *rate {
            *rate = quotient;
        }
    }
    sort(size, solution);
}

/// The quotients of systems so small that none of them takes much.
fn few_quotients(masses: &[f64], springs: &[Link], vectors: &[f64]) -> Vec<f64> {
    let roots: Vec<f64> = masses
        .iter()
        .map(|m| factor::root_of_ratio(*m, masses[0]))
        .collect();
    let shapes = vectors.chunks_exact(masses.len());
    shapes
        .map(|weighted| {
            let shape = displacement(weighted, &roots);
            if masses.len() <= FEW {
                exact_rayleigh_rate(masses, springs, &shape)
            } else {
                rayleigh_rate(masses, springs, &shape)
            }
        })
        .collect()
}

fn rayleigh_rate(masses: &[f64], springs: &[Link], shape: &[f64]) -> f64 {
    let kinetic: f64 = masses.iter().zip(shape).map(|(m, x)| m * x * x).sum();
    let potential: f64 = springs
        .iter()
        .map(|spring| {
            let elongation = spring.elongation(shape);
            spring.coefficient * elongation * elongation
        })
        .sum();
    (potential / kinetic).sqrt()
}

/// The same rounded once.
fn exact_rayleigh_rate(masses: &[f64], springs: &[Link], shape: &[f64]) -> f64 {
    let inertia = masses.iter().zip(shape);
    let kinetic: Dd = inertia.map(|(m, x)| Dd::product(*x, *x) * *m).sum();
    let energies = springs.iter().map(|spring| {
        let [first, second] = spring.displacements(shape);
        Dd::sum(first, -second).square() * spring.coefficient
    });
    let potential: Dd = energies.sum();
    (potential / kinetic).sqrt().hi()
}

/// Whether sums over the springs of all modes cost little beside the rotations, and none of them leaves the range of numbers.
fn is_sparse_and_in_range(masses: &[f64], springs: &[Link], stiffest: f64) -> bool {
    // The sums for n²/2 pairs of modes then have 8 n³ terms; a sweep of rotations takes about 3 n³, and
    // several are made.
    const SPARSE: usize = 16;
    // Products of four of these numbers stay within 1e±280.
    const RANGE: std::ops::Range<f64> = 1e-70..1e70;
    springs.len() <= SPARSE * masses.len()
        && masses.iter().all(|m| RANGE.contains(m))
        && RANGE.contains(&stiffest)
}

fn sort(size: usize, solution: &mut ModalBasis) {
    // Quotients of frequencies that are equal to rounding may have changed places.
    if solution.rates.is_sorted() {
        return;
    }
    let order = ascending(solution.rates.len(), &|mode| solution.rates[mode]);
    solution.vectors = order
        .iter()
        .flat_map(|&mode| solution.vectors[mode * size..][..size].to_vec())
        .collect();
    solution.rates = order.iter().map(|&mode| solution.rates[mode]).collect();
}
