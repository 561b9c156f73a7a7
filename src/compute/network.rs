//! Reading systems of several degrees of freedom: masses, springs and dampers, or matrices.

use std::borrow::Cow;

use nalgebra::DMatrix;

use super::{Parameters, RequestError};
use crate::vibration::modes::{Link, MAX_DEGREES_OF_FREEDOM, System};

/// The system of `masses` and `springs`, or of `M` and `K`.
pub(crate) fn system(parameters: &Parameters) -> Result<System, RequestError> {
    let system = if parameters.has("M") || parameters.has("K") {
        if parameters.has("masses") || parameters.has("springs") {
            let reason = "give either `masses` and `springs`, or `M` and `K`".to_owned();
            return Err(RequestError::OutOfDomain { reason });
        }
        System::of_matrices(&matrix(parameters, "M")?, &matrix(parameters, "K")?)
    } else {
        System::of_network(&parameters.list("masses")?, &links(parameters, "springs")?)
    };
    system.map_err(RequestError::domain)
}

/// A list of `[i, j, coefficient]`; node 0 is the ground.
fn links(parameters: &Parameters, name: &'static str) -> Result<Vec<Link>, RequestError> {
    const EXPECTED: &str = "a list of [i, j, coefficient], where node 0 is the ground";
    let entries = parameters.lists(name, EXPECTED)?;
    let link = |entry: Option<Cow<[f64]>>| entry.and_then(|entry| link(&entry));
    let links = entries.into_iter().map(|entry| {
        link(entry).ok_or(RequestError::NotANumber {
            name,
            expected: EXPECTED,
        })
    });
    links.collect()
}

/// The list if it was given, or none.
pub(crate) fn optional_links(
    parameters: &Parameters,
    name: &'static str,
) -> Result<Vec<Link>, RequestError> {
    if parameters.has(name) {
        links(parameters, name)
    } else {
        Ok(Vec::new())
    }
}

fn link(entry: &[f64]) -> Option<Link> {
    let &[first, second, coefficient] = entry else {
        return None;
    };
    Some(Link::between(node(first)?, node(second)?, coefficient))
}

fn node(value: f64) -> Option<usize> {
    let index = value as u32;
    let is_index = f64::from(index) == value && value <= 1e9;
    is_index.then_some(index as usize)
}

/// A square matrix as a list of rows.
pub(crate) fn matrix(
    parameters: &Parameters,
    name: &'static str,
) -> Result<DMatrix<f64>, RequestError> {
    const EXPECTED: &str = "a square matrix as a list of rows of numbers";
    let wrong = || RequestError::NotANumber {
        name,
        expected: EXPECTED,
    };
    let rows = parameters.lists(name, EXPECTED)?;
    if rows.len() > MAX_DEGREES_OF_FREEDOM {
        return Err(RequestError::TooMany {
            name,
            count: rows.len(),
            most: MAX_DEGREES_OF_FREEDOM,
        });
    }
    let mut matrix = DMatrix::zeros(rows.len(), rows.len());
    for (i, row) in rows.iter().enumerate() {
        let row = row.as_ref().filter(|row| row.len() == rows.len());
        for (j, entry) in row.ok_or_else(wrong)?.iter().enumerate() {
            matrix[(i, j)] = *entry;
        }
    }
    Ok(matrix)
}
