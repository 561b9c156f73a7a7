//! Vectors and matrices, entry by entry.

use std::rc::Rc;

use super::CompileError;
use super::assembler::Assembler;
use super::entry::EntryRegister;
use super::error::Result;
use crate::expr::{Field, Form, Function, Operator, Shape};

/// Largest order of a determinant: its minors are computed once each, 2ⁿ of them.
const MAX_DETERMINANT: usize = 10;

/// The entries of a value, by rows; cheap to clone.
#[derive(Clone, Debug)]
pub(crate) struct Array {
    pub(crate) shape: Shape,
    pub(crate) entries: Rc<[EntryRegister]>,
    pub(crate) is_boolean: bool,
}

impl Array {
    pub(crate) fn new(shape: Shape, entries: Vec<EntryRegister>) -> Self {
        Self {
            shape,
            entries: entries.into(),
            is_boolean: false,
        }
    }

    pub(crate) fn scalar(entry: EntryRegister) -> Self {
        Self {
            shape: Shape::Scalar,
            entries: Rc::new([entry]),
            is_boolean: false,
        }
    }

    pub(crate) fn boolean(register: u32) -> Self {
        Self {
            is_boolean: true,
            ..Self::scalar(EntryRegister::real(register))
        }
    }

    pub(crate) fn is_complex(&self) -> bool {
        self.entries.iter().any(|entry| entry.is_complex())
    }

    pub(crate) fn form(&self) -> Form {
        let field = match (self.is_boolean, self.is_complex()) {
            (true, _) => Field::Boolean,
            (false, true) => Field::Complex,
            (false, false) => Field::Real,
        };
        Form {
            field,
            shape: self.shape,
        }
    }

    /// The entry of a number.
    pub(crate) fn number(&self) -> Result<EntryRegister> {
        match (self.shape, self.is_boolean) {
            (Shape::Scalar, false) => Ok(self.entries[0]),
            _ => Err(CompileError::Form { found: self.form() }),
        }
    }

    /// The register of a real number.
    pub(crate) fn real(&self) -> Result<u32> {
        match self.number()? {
            EntryRegister {
                real,
                imaginary: None,
            } => Ok(real),
            _ => Err(CompileError::Form { found: self.form() }),
        }
    }

    /// The register of a condition.
    pub(crate) fn condition(&self) -> Result<u32> {
        if !self.is_boolean {
            return Err(CompileError::Form { found: self.form() });
        }
        Ok(self.entries[0].real)
    }

    fn numbers(&self) -> Result<()> {
        if self.is_boolean {
            return Err(CompileError::Form { found: self.form() });
        }
        Ok(())
    }

    pub(crate) fn map(
        &self,
        to: &mut Assembler,
        change: impl Fn(EntryRegister, &mut Assembler) -> Result<EntryRegister>,
    ) -> Result<Self> {
        self.numbers()?;
        let entries = self.entries.iter().map(|entry| change(*entry, to));
        Ok(Self::new(self.shape, entries.collect::<Result<_>>()?))
    }

    pub(crate) fn arithmetic(
        &self,
        operator: Operator,
        other: &Self,
        to: &mut Assembler,
    ) -> Result<Self> {
        self.numbers()?;
        other.numbers()?;
        match operator {
            Operator::Add => self.zip(other, to, EntryRegister::add),
            Operator::Subtract => self.zip(other, to, EntryRegister::subtract),
            Operator::Multiply => self.multiply(other, to),
            Operator::Divide => {
                let divisor = other.number()?;
                self.map(to, |entry, to| entry.divide(divisor, to))
            }
            Operator::Power => Ok(Self::scalar(self.number()?.power(other.number()?, to)?)),
        }
    }

    fn zip(
        &self,
        other: &Self,
        to: &mut Assembler,
        operation: impl Fn(EntryRegister, EntryRegister, &mut Assembler) -> Result<EntryRegister>,
    ) -> Result<Self> {
        if self.shape != other.shape {
            return Err(CompileError::Form {
                found: other.form(),
            });
        }
        let pairs = self.entries.iter().zip(&*other.entries);
        let entries = pairs.map(|(a, b)| operation(*a, *b, to));
        Ok(Self::new(self.shape, entries.collect::<Result<_>>()?))
    }

    fn multiply(&self, other: &Self, to: &mut Assembler) -> Result<Self> {
        match (self.shape, other.shape) {
            (Shape::Scalar, _) => other.map(to, |entry, to| self.entries[0].multiply(entry, to)),
            (_, Shape::Scalar) => self.map(to, |entry, to| entry.multiply(other.entries[0], to)),
            (Shape::Matrix(rows, inner), Shape::Vector(length)) if inner == length => {
                self.product(other, Shape::Vector(rows), to)
            }
            (Shape::Matrix(rows, inner), Shape::Matrix(length, columns)) if inner == length => {
                self.product(other, Shape::Matrix(rows, columns), to)
            }
            _ => Err(CompileError::Form {
                found: other.form(),
            }),
        }
    }

    fn product(&self, other: &Self, shape: Shape, to: &mut Assembler) -> Result<Self> {
        let (rows, inner) = self.shape.rows_and_columns();
        let (_, columns) = other.shape.rows_and_columns();
        let mut entries = Vec::with_capacity(rows * columns);
        for row in 0..rows {
            for column in 0..columns {
                let left = (0..inner).map(|k| self.entries[row * inner + k]);
                let right = (0..inner).map(|k| other.entries[k * columns + column]);
                entries.push(sum_of_products(left, right, to)?);
            }
        }
        Ok(Self::new(shape, entries))
    }

    pub(crate) fn transpose(&self) -> Self {
        let (rows, columns) = self.shape.rows_and_columns();
        let entries = (0..columns)
            .flat_map(|column| (0..rows).map(move |row| self.entries[row * columns + column]));
        Self::new(Shape::Matrix(columns, rows), entries.collect())
    }

    /// The bilinear product Σ u v, without conjugation.
    pub(crate) fn dot(&self, other: &Self, to: &mut Assembler) -> Result<Self> {
        match (self.shape, other.shape) {
            (Shape::Vector(a), Shape::Vector(b)) if a == b => {
                let (left, right) = (self.entries.iter().copied(), other.entries.iter().copied());
                Ok(Self::scalar(sum_of_products(left, right, to)?))
            }
            _ => Err(CompileError::Form {
                found: other.form(),
            }),
        }
    }

    /// √ Σ |u|².
    pub(crate) fn norm(&self, to: &mut Assembler) -> Result<Self> {
        let Shape::Vector(_) = self.shape else {
            return Err(CompileError::Form { found: self.form() });
        };
        let parts: Vec<EntryRegister> = self
            .entries
            .iter()
            .flat_map(|entry| [Some(entry.real), entry.imaginary])
            .flatten()
            .map(EntryRegister::real)
            .collect();
        let squares = sum_of_products(parts.iter().copied(), parts.iter().copied(), to)?;
        Ok(Self::scalar(squares.function(Function::Sqrt, to)?))
    }

    /// The determinant by minors of the upper rows, each computed once; nothing is divided.
    pub(crate) fn determinant(&self, to: &mut Assembler) -> Result<Self> {
        let (order, columns) = self.shape.rows_and_columns();
        if order != columns || order > MAX_DETERMINANT || self.is_boolean {
            return Err(CompileError::Form { found: self.form() });
        }
        // The minor of the first rows and of the columns in the set of bits.
        let mut minors: Vec<Option<EntryRegister>> = vec![None; 1 << order];
        for set in 1_usize..1 << order {
            let row = set.count_ones() as usize - 1;
            let mut sum: Option<EntryRegister> = None;
            let mut is_odd = row % 2 == 1;
            for column in (0..order).filter(|column| set >> column & 1 == 1) {
                let entry = self.entries[row * order + column];
                let term = match minors[set & !(1 << column)] {
                    Some(minor) => entry.multiply(minor, to)?,
                    // The minor of no rows is 1.
                    None => entry,
                };
                sum = Some(match (sum, is_odd) {
                    (None, false) => term,
                    (None, true) => term.negate(to)?,
                    (Some(sum), false) => sum.add(term, to)?,
                    (Some(sum), true) => sum.subtract(term, to)?,
                });
                is_odd = !is_odd;
            }
            minors[set] = sum;
        }
        let whole = minors
            .pop()
            .flatten()
            .ok_or(CompileError::Form { found: self.form() })?;
        Ok(Self::scalar(whole))
    }

    /// A component, or a row of a matrix; indices count from 1.
    pub(crate) fn component(&self, indices: &[usize]) -> Result<Self> {
        let within = |index: usize, length: usize| {
            index
                .checked_sub(1)
                .filter(|index| *index < length)
                .ok_or_else(|| CompileError::Form { found: self.form() })
        };
        match (self.shape, indices) {
            (Shape::Vector(length), [index]) => {
                Ok(Self::scalar(self.entries[within(*index, length)?]))
            }
            (Shape::Matrix(rows, columns), [row]) => {
                let first = within(*row, rows)? * columns;
                let entries = self.entries[first..first + columns].to_vec();
                Ok(Self::new(Shape::Vector(columns), entries))
            }
            (Shape::Matrix(rows, columns), [row, column]) => {
                let position = within(*row, rows)? * columns + within(*column, columns)?;
                Ok(Self::scalar(self.entries[position]))
            }
            _ => Err(CompileError::Form { found: self.form() }),
        }
    }

    /// A vector of numbers, or a matrix of rows.
    pub(crate) fn of_parts(parts: &[Self]) -> Result<Self> {
        let first = parts.first().ok_or(CompileError::TooLarge)?;
        let shape = match first.shape {
            Shape::Scalar => Shape::Vector(parts.len()),
            Shape::Vector(length) => Shape::Matrix(parts.len(), length),
            Shape::Matrix(..) => {
                return Err(CompileError::Form {
                    found: first.form(),
                });
            }
        };
        let mut entries = Vec::with_capacity(shape.len());
        for part in parts {
            part.numbers()?;
            if part.shape != first.shape {
                return Err(CompileError::Form { found: part.form() });
            }
            entries.extend_from_slice(&part.entries);
        }
        Ok(Self::new(shape, entries))
    }
}

fn sum_of_products(
    left: impl Iterator<Item = EntryRegister>,
    right: impl Iterator<Item = EntryRegister>,
    to: &mut Assembler,
) -> Result<EntryRegister> {
    let mut sum: Option<EntryRegister> = None;
    for (a, b) in left.zip(right) {
        let product = a.multiply(b, to)?;
        sum = Some(match sum {
            Some(sum) => sum.add(product, to)?,
            None => product,
        });
    }
    match sum {
        Some(sum) => Ok(sum),
        None => Ok(EntryRegister::real(to.exact(0.0)?)),
    }
}
