//! The equation of the natural frequencies.

use super::Model;
use super::linear::Matrix;
use crate::expr::{Equation, Expr, Name, Normal};
use crate::numerics::SortedSet;

/// `det(K − ω² M) = 0`, or `det(M s² + C s + K) = 0` with damping, with the factors common to all
/// terms divided out. The unknown is `omega` (`s`), or another letter where the model uses that one.
pub(crate) fn equation(model: &Model) -> Option<Equation> {
    let linear = model.linear()?;
    let is_undamped = linear.is_undamped();
    let unknown = free_letter(
        model,
        if is_undamped {
            &["omega", "w", "p"]
        } else {
            &["s", "lambda", "z"]
        },
    )?;
    let power = |order| Normal::of(&Expr::name(unknown.clone()).power(Expr::number(order)));
    let (first, second) = (power(1).ok()?, power(2).ok()?);
    let second = if is_undamped {
        second.negated()
    } else {
        second
    };
    let entry = |row: usize, column: usize| {
        let inertia = linear.mass[row][column].times(&second)?;
        let damping = linear.damping[row][column].times(&first)?;
        linear.stiffness[row][column].plus(&inertia)?.plus(&damping)
    };
    let size = model.degrees_of_freedom();
    let rows = (0..size).map(|row| (0..size).map(|column| entry(row, column)).collect());
    let matrix: Matrix = rows.collect::<Result<_, _>>().ok()?;
    let kept = SortedSet::from([unknown.clone()]);
    let (_, reduced) = determinant(&matrix)?.without_common_factor(&kept).ok()?;
    let leads_with_sign = size % 2 == 1 && is_undamped;
    let reduced = if leads_with_sign {
        reduced.negated()
    } else {
        reduced
    };
    let order = model.order().clone().moving([unknown]).descending();
    Some(Equation {
        left: reduced.to_expr(&order),
        right: Expr::number(0),
    })
}

/// The first of these letters that the model does not use.
fn free_letter(model: &Model, letters: &[&str]) -> Option<Name> {
    let linear = model.linear()?;
    let mut entries = Vec::new();
    for matrix in [&linear.mass, &linear.damping, &linear.stiffness] {
        entries.extend(matrix.iter().flatten());
    }
    letters
        .iter()
        .map(|letter| Name::from(*letter))
        .find(|name| entries.iter().all(|entry| !entry.mentions(name)))
}

/// By expansion along the first row; the matrices are small.
pub(crate) fn determinant(matrix: &Matrix) -> Option<Normal> {
    // The expansion of n rows has n! products: 720 of six.
    const MAX_ROWS: usize = 6;
    match matrix.as_slice() {
        [row] => row.first().cloned(),
        rows if rows.len() > MAX_ROWS => None,
        [first, rest @ ..] => {
            let mut sum = Normal::of(&Expr::number(0)).ok()?;
            for (column, entry) in first.iter().enumerate() {
                if entry.is_zero() {
                    continue;
                }
                let minor = rest.iter().map(|row| {
                    let others = row.iter().enumerate().filter(|(at, _)| *at != column);
                    others.map(|(_, own)| own.clone()).collect()
                });
                let term = entry.times(&determinant(&minor.collect())?).ok()?;
                let term = if column % 2 == 0 {
                    term
                } else {
                    term.negated()
                };
                sum = sum.plus(&term).ok()?;
            }
            Some(sum)
        }
        [] => None,
    }
}
