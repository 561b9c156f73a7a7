//! M, C and K as somebody has them: numbers for these data, and formulas where they were given as such.

use super::answers::{Own, in_data, number};
use crate::expr::{Expr, Kind};
use crate::mechanics::{Model, Quantity};
use crate::solution::Solution;

/// An entry of a matrix.
#[derive(Clone, Debug)]
pub(crate) struct MatrixEntry {
    pub(crate) value: f64,
    pub(crate) formula: Option<Expr>,
}

/// The rows of M, C and K side by side.
#[derive(Clone, Debug)]
pub(crate) struct Matrices {
    rows: Vec<Vec<MatrixEntry>>,
}

/// In how many entries two rows agree when one is multiplied.
pub(crate) struct Likeness {
    pub(crate) count: usize,
    factor: MatrixEntry,
}

/// Entries that differ by less than this part are the same.
const SAME: f64 = 1e-9;

fn is_same(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME * a.abs().max(b.abs())
}

impl Matrices {
    /// Those of a model, where they have formulas.
    pub(crate) fn of_model(model: &Model, solution: &Solution<'_>) -> Option<Self> {
        let blocks = [
            model.mass_matrix()?,
            model.damping_matrix()?,
            model.stiffness_matrix()?,
        ];
        let size = model.degrees_of_freedom();
        let mut rows = vec![Vec::with_capacity(3 * size); size];
        for block in &blocks {
            for (row, entries) in rows.iter_mut().zip(entries(block, size)?.chunks(size)) {
                for entry in entries {
                    let formula = in_data(entry, &solution.template().graph)?;
                    let value = number(&formula, solution.evaluation())?;
                    row.push(MatrixEntry {
                        value,
                        formula: Some(formula),
                    });
                }
            }
        }
        Some(Self { rows })
    }

    pub(crate) fn size(&self) -> usize {
        self.rows.len()
    }

    pub(crate) fn mass(&self) -> Vec<f64> {
        self.block(0)
    }

    pub(crate) fn damping(&self) -> Vec<f64> {
        self.block(1)
    }

    pub(crate) fn stiffness(&self) -> Vec<f64> {
        self.block(2)
    }

    fn block(&self, block: usize) -> Vec<f64> {
        let size = self.size();
        let own = self
            .rows
            .iter()
            .flat_map(|row| &row[block * size..(block + 1) * size]);
        own.map(|entry| entry.value).collect()
    }

    /// All entries as formulas, if they were all given so.
    pub(crate) fn formulas(&self) -> Option<[Vec<Expr>; 3]> {
        let size = self.size();
        let block = |block: usize| {
            self.rows
                .iter()
                .flat_map(|row| &row[block * size..(block + 1) * size])
                .map(|entry| entry.formula.clone())
                .collect::<Option<Vec<_>>>()
        };
        Some([block(0)?, block(1)?, block(2)?])
    }

    /// The factor under which a row agrees best with the one at a place; none where it agrees nowhere.
    pub(crate) fn likeness(&self, at: usize, row: &[MatrixEntry]) -> Option<Likeness> {
        let right = &self.rows[at];
        let candidates = right.iter().zip(row).filter_map(|(right, own)| {
            if right.value == 0.0 || own.value == 0.0 {
                return None;
            }
            let value = right.value / own.value;
            let formula = right.formula.clone().zip(own.formula.clone());
            Some(Likeness {
                count: right_count(&self.rows[at], row, |(right, own)| {
                    right.value != 0.0 && is_same(right.value, value * own.value)
                }),
                factor: MatrixEntry {
                    value,
                    formula: formula.map(|(right, own)| right / own),
                },
            })
        });
        // Of equals the first: the mass is the entry that is least often wrong.
        candidates.reduce(|best, other| {
            if other.count > best.count {
                other
            } else {
                best
            }
        })
    }

    /// Puts a row in the place of another.
    pub(crate) fn set_row(&mut self, at: usize, row: Vec<MatrixEntry>) {
        self.rows[at] = row;
    }

    /// Puts an answer in the place of a matrix; whether it is one of them.
    pub(crate) fn set(&mut self, quantity: Quantity, own: &Own) -> bool {
        let block = match quantity {
            Quantity::MassMatrix => 0,
            Quantity::DampingMatrix => 1,
            Quantity::StiffnessMatrix => 2,
            _ => return false,
        };
        let size = self.size();
        let numbers = own.value.numbers();
        if numbers.len() != size * size {
            return false;
        }
        let formulas = own
            .formula
            .as_ref()
            .and_then(|formula| entries(formula, size));
        for (place, value) in numbers.iter().enumerate() {
            self.rows[place / size][block * size + place % size] = MatrixEntry {
                value: *value,
                formula: formulas.as_ref().map(|formulas| formulas[place].clone()),
            };
        }
        true
    }
}

fn right_count(
    right: &[MatrixEntry],
    own: &[MatrixEntry],
    agrees: impl Fn(&(&MatrixEntry, &MatrixEntry)) -> bool,
) -> usize {
    right.iter().zip(own).filter(|pair| agrees(pair)).count()
}

impl Likeness {
    /// An entry with the factor.
    pub(crate) fn scaled(&self, entry: &MatrixEntry) -> MatrixEntry {
        let formula = entry.formula.clone().zip(self.factor.formula.clone());
        MatrixEntry {
            value: entry.value * self.factor.value,
            formula: formula.map(|(own, factor)| own * factor),
        }
    }
}

/// The entries of a square matrix that is written as an array of rows.
fn entries(matrix: &Expr, size: usize) -> Option<Vec<Expr>> {
    let Kind::Array(rows) = matrix.kind() else {
        return None;
    };
    let rows = rows.iter().map(|row| match row.kind() {
        Kind::Array(entries) => Some(entries.clone()),
        _ => None,
    });
    let entries = rows.collect::<Option<Vec<_>>>()?.concat();
    (entries.len() == size * size).then_some(entries)
}
