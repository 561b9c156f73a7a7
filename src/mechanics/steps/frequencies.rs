//! Natural frequencies and the shapes that belong to them, in letters.

use super::{Deriver, Line, LineSide, Reason, Step, Unavailable};
use crate::expr::{Expr, Name, Normal};
use crate::mechanics::Quantity;
use crate::mechanics::characteristic::determinant;
use crate::mechanics::linear::Matrix;

/// More coordinates have no equation in letters that anybody follows.
const MAX_COORDINATES: usize = 2;

/// The determinant of K − ω² M and its equation; dampers are ignored.
pub(crate) fn characteristic(deriver: &Deriver<'_>) -> Result<Vec<Step>, Unavailable> {
    let unknown = Name::new("omega");
    let entries = stiffness_less_inertia(deriver, &unknown)?;
    let equation = determinant(&entries).ok_or(Unavailable::NoFormula)?;
    let row = |row: &Vec<Normal>| row.iter().map(|entry| deriver.collected(entry)).collect();
    let order = deriver.model.order().clone().moving([unknown]).descending();
    let zero = || LineSide::Formula(Expr::number(0));
    let matrix = LineSide::Determinant(entries.iter().map(row).collect());
    let mut lines = vec![
        Line::exact([matrix, zero()]),
        Line::exact([LineSide::Formula(equation.to_expr(&order)), zero()]),
    ];
    let has_dampers = !deriver
        .model
        .linear()
        .ok_or(Unavailable::NoFormula)?
        .is_undamped();
    let shortest = deriver.model.equations(Quantity::CharacteristicEquation);
    if let (Ok(shortest), false) = (shortest, has_dampers) {
        lines.extend(shortest.into_iter().map(super::lagrange::line_of));
    }
    Ok(vec![Step {
        reason: Reason::Characteristic,
        lines,
    }])
}

/// A row of (K − ω² M) u = 0 that joins the two coordinates, and the ratio that it gives.
pub(crate) fn row(deriver: &Deriver<'_>, mode: usize) -> Result<Vec<Step>, Unavailable> {
    let names = deriver.model.coordinates();
    let [first, second] = names else {
        return Err(Unavailable::SeveralCoordinates);
    };
    let frequency = Name::new(format!("omega{}", mode + 1));
    let entries = stiffness_less_inertia(deriver, &frequency)?;
    // In a row without the other coordinate nothing says how large that one is.
    let joined = [(0, 1), (1, 0)];
    let joined = joined
        .into_iter()
        .find(|(row, other)| !entries[*row][*other].is_zero());
    let (row, _) = joined.ok_or(Unavailable::NoFormula)?;
    let order = deriver.model.order().clone().moving(names.to_vec());
    let mut sum = Normal::of(&Expr::number(0))?;
    for (entry, name) in entries[row].iter().zip(names) {
        sum = sum.plus(&entry.times(&Normal::of(&Expr::name(name.clone()))?)?)?;
    }
    let written = |own: &Normal| own.to_bracket(deriver.model.order());
    // The sign goes where it makes the fewest.
    let (own, other) = (&entries[row][0], &entries[row][1]);
    let ratio = if other.has_negative_coefficients_alone() {
        written(own) / written(&other.negated())
    } else {
        -(written(own) / written(other))
    };
    let names = Expr::name(second.clone()) / Expr::name(first.clone());
    Ok(vec![Step {
        reason: Reason::Row(row),
        lines: vec![
            Line::exact([sum.to_expr(&order), Expr::number(0)].map(LineSide::Formula)),
            Line::exact([names, ratio].map(LineSide::Formula)),
        ],
    }])
}

/// K − ω² M with this letter for ω.
fn stiffness_less_inertia(deriver: &Deriver<'_>, frequency: &Name) -> Result<Matrix, Unavailable> {
    if deriver.model.degrees_of_freedom() > MAX_COORDINATES {
        return Err(Unavailable::SeveralCoordinates);
    }
    let linear = deriver.model.linear().ok_or(Unavailable::NoFormula)?;
    let square = Normal::of(&Expr::name(frequency.clone()).squared())?.negated();
    let rows = linear.stiffness.iter().zip(&linear.mass);
    Ok(rows
        .map(|(stiffness, mass)| {
            let entries = stiffness.iter().zip(mass);
            entries
                .map(|(stiffness, mass)| stiffness.plus(&mass.times(&square)?))
                .collect::<Result<Vec<_>, _>>()
        })
        .collect::<Result<_, _>>()?)
}
