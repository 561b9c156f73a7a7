//! Modes by reduction to tridiagonal form, for systems whose frequencies do not spread far.
//!
//! Several times as fast as rotations, but accurate only beside the largest frequency. What comes out counts when it is
//! proven: Rayleigh quotients and residuals of a network are formed from its springs. Everything else, repeated frequencies
//! too, is left to rotations.

use nalgebra::DMatrix;

use super::chain::Chain;
use super::factor::root_of_ratio;
use super::rayleigh::{self, Mode, are_proven};
use super::solve::ModalBasis;
use super::system::Link;
use crate::numerics::householder::Reduction;
use crate::numerics::jacobi::{dot, largest_magnitude};
use crate::numerics::product::product;
use crate::numerics::tridiagonal::{Eigenpairs, Factored, eigenvalues};
use crate::numerics::{binary_exponent, scale_by_power_of_two};

/// Up to this size rotations take less than what can be seen, and lose nothing.
pub(crate) const SMALL: usize = 16;

/// Whether systems of this size are reduced.
fn is_large(size: usize) -> bool {
    cfg!(feature = "large") && size > SMALL
}

/// Largest eigenvalue over the smallest, up to which a dense reduction leaves the shapes of networks as accurate as their data
/// determine them: it is accurate beside the largest.
const SPREAD: f64 = 1e4;

/// The modes of a network of attractive springs, if they can be proven.
pub(crate) fn of_network(masses: &[f64], springs: &[Link]) -> Option<ModalBasis> {
    // As in `network`: products of four of these numbers stay within 1e±280.
    const RANGE: std::ops::Range<f64> = 1e-70..1e70;
    let in_range = |x: f64| RANGE.contains(&x) || x == 0.0;
    let coefficients = springs.iter().map(|spring| spring.coefficient);
    if !is_large(masses.len())
        || !masses.iter().all(|m| in_range(*m))
        || !coefficients.into_iter().all(in_range)
    {
        return None;
    }
    match Chain::of(masses, springs) {
        Some(chain) => of_chain(&chain, masses, springs),
        None => of_any(masses, springs),
    }
}

fn of_chain(chain: &Chain, masses: &[f64], springs: &[Link]) -> Option<ModalBasis> {
    let vectors = chain.elastic_shapes()?;
    let modes = rayleigh::of_springs(masses, springs, &vectors);
    let elastic = proven(&modes, chain.is_free(), vectors)?;
    if !chain.is_free() {
        return Some(elastic);
    }
    // The rigid motion is known: all masses move alike.
    let total: f64 = masses.iter().sum();
    let rigid = masses.iter().map(|m| (m / total).sqrt());
    Some(ModalBasis {
        rates: std::iter::once(0.0).chain(elastic.rates).collect(),
        vectors: rigid.chain(elastic.vectors).collect(),
    })
}

/// By the matrix of the springs; the springs themselves give the quotients of soft modes, of which the matrix loses digits, and
/// of all modes if they are few.
fn of_any(masses: &[f64], springs: &[Link]) -> Option<ModalBasis> {
    // A mode takes 8 n terms by its springs and n² by the matrix, of which n is 17 at least; the springs lose
    // nothing.
    const FEW: usize = 8;
    /// Of the largest eigenvalue: the matrix gives others to a few units in the last place.
    const SOFT: f64 = 1.0 / 16.0;
    let size = masses.len();
    let entries = weighted_matrix(masses, springs);
    let Eigenpairs { values, vectors } = eigenpairs(entries.clone(), size)?;
    if !is_narrow(&values) {
        return None;
    }
    let largest = values[size - 1];
    let soft = if springs.len() <= FEW * size {
        size
    } else {
        values.partition_point(|value| *value <= SOFT * largest)
    };
    let (softer, stiffer) = vectors.split_at(soft * size);
    let mut modes = rayleigh::of_springs(masses, springs, softer);
    modes.extend(of_matrix(&entries, stiffer, size));
    proven(&modes, false, vectors)
}

/// `M^(-1/2) K M^(-1/2)`.
fn weighted_matrix(masses: &[f64], springs: &[Link]) -> Vec<f64> {
    let size = masses.len();
    let mut matrix = DMatrix::<f64>::zeros(size, size);
    for spring in springs {
        spring.stamp(spring.coefficient / masses[0], &mut matrix);
    }
    let roots = masses.iter().map(|m| root_of_ratio(*m, masses[0]));
    let roots: Vec<f64> = roots.collect();
    let mut entries = Vec::with_capacity(size * size);
    for (column, root) in matrix.as_slice().chunks_exact(size).zip(&roots) {
        entries.extend(
            column
                .iter()
                .zip(&roots)
                .map(|(k, other)| k / (other * root)),
        );
    }
    entries
}

fn proven(modes: &[Mode], is_free: bool, vectors: Vec<f64>) -> Option<ModalBasis> {
    are_proven(modes, is_free).then(|| ModalBasis {
        rates: modes.iter().map(|mode| mode.frequency).collect(),
        vectors,
    })
}

fn is_narrow(values: &[f64]) -> bool {
    let ends = values.first().zip(values.last());
    ends.is_some_and(|(first, last)| *first > 0.0 && *first * SPREAD >= *last)
}

/// The modes of a mass-weighted stiffness matrix, given column after column, if they can be proven and none grows.
pub(crate) fn of_weighted(entries: Vec<f64>, size: usize) -> Option<ModalBasis> {
    if !is_large(size) {
        return None;
    }
    let Eigenpairs { values, vectors } = eigenpairs(entries.clone(), size)?;
    if !is_narrow(&values) {
        return None;
    }
    let modes = of_matrix(&entries, &vectors, size);
    proven(&modes, false, vectors)
}

/// What a matrix says of vectors.
fn of_matrix(entries: &[f64], vectors: &[f64], size: usize) -> Vec<Mode> {
    let images = product(entries, vectors, size);
    let columns = vectors.chunks_exact(size).zip(images.chunks_exact(size));
    columns.map(|(x, image)| mode(x, image)).collect()
}

/// The Rayleigh quotient of a vector with its image, and the residual.
fn mode(x: &[f64], image: &[f64]) -> Mode {
    let square = dot(x, x);
    let eigenvalue = dot(x, image) / square;
    let rest: f64 = x
        .iter()
        .zip(image)
        .map(|(x, y)| {
            let rest = y - eigenvalue * x;
            rest * rest
        })
        .sum();
    Mode {
        frequency: eigenvalue.sqrt(),
        eigenvalue,
        residual: (rest / square).sqrt(),
    }
}

/// The eigenpairs of a symmetric matrix, given column after column.
fn eigenpairs(mut entries: Vec<f64>, size: usize) -> Option<Eigenpairs> {
    let largest = largest_magnitude(&entries);
    if largest == 0.0 || !largest.is_finite() {
        return None;
    }
    // The squares of the QL algorithm stay in range when the largest entry is near one; a power of two rounds
    // nothing.
    let exponent = binary_exponent(largest);
    for entry in &mut entries {
        *entry = scale_by_power_of_two(*entry, -exponent);
    }
    let reduction = Reduction::of(entries, size);
    let (diagonal, off_diagonal) = (&reduction.diagonal, &reduction.off_diagonal);
    let approximate = eigenvalues(diagonal, off_diagonal)?;
    let (first, last) = (*approximate.first()?, *approximate.last()?);
    // Below all eigenvalues, by enough that the factorization is positive definite, and near, so that vectors are told apart by
    // the distances of the eigenvalues from here.
    let shift = first - (last - first) / 64.0;
    let factored = Factored::of_shifted(diagonal, off_diagonal, shift)?;
    let shifted: Vec<f64> = approximate.iter().map(|value| value - shift).collect();
    let mut pairs = factored.eigenpairs(&shifted)?;
    reduction.back(&mut pairs.vectors);
    for value in &mut pairs.values {
        *value = scale_by_power_of_two(*value + shift, exponent);
    }
    Some(pairs)
}
