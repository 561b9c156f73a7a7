//! What a program computes.

use crate::expr::{Field, Form, Shape};
use vibank_dynamics::numerics::Complex;

/// The value of a formula: numbers in SI units with bounds on their errors.
///
/// # Examples
///
/// ```
/// use vibank_formula::expr::{Form, Value};
///
/// let value = Value::real(2.5, 0.0);
/// assert_eq!(value.form(), Form::REAL);
/// assert_eq!(value.as_real(), Some(2.5));
/// assert_eq!(value.as_boolean(), None);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Value {
    form: Form,
    /// The entries by rows; of complex entries real and imaginary part.
    numbers: Vec<f64>,
    bounds: Vec<f64>,
}

impl Value {
    /// A value of this form; `None` unless there are as many numbers and bounds as it holds.
    pub fn new(form: Form, numbers: Vec<f64>, bounds: Vec<f64>) -> Option<Self> {
        let fits = numbers.len() == form.width() && bounds.len() == numbers.len();
        fits.then_some(Self {
            form,
            numbers,
            bounds,
        })
    }

    /// A real number with a bound on its error.
    pub fn real(number: f64, bound: f64) -> Self {
        Self {
            form: Form::REAL,
            numbers: vec![number],
            bounds: vec![bound],
        }
    }

    /// Field and shape.
    pub fn form(&self) -> Form {
        self.form
    }

    /// How the entries are arranged.
    pub fn shape(&self) -> Shape {
        self.form.shape
    }

    /// The real number that it is.
    pub fn as_real(&self) -> Option<f64> {
        (self.form == Form::REAL).then(|| self.numbers[0])
    }

    /// The complex number that it is; a real number is one, too.
    pub fn as_complex(&self) -> Option<Complex> {
        match (self.form.field, self.form.shape) {
            (Field::Complex, Shape::Scalar) => Some(self.entry(0)),
            _ => self.as_real().map(Complex::from),
        }
    }

    /// The truth that it is.
    pub fn as_boolean(&self) -> Option<bool> {
        (self.form == Form::BOOLEAN).then(|| self.numbers[0] != 0.0)
    }

    /// The list of real numbers that it is.
    pub fn as_vector(&self) -> Option<&[f64]> {
        match (self.form.field, self.form.shape) {
            (Field::Real, Shape::Vector(_)) => Some(&self.numbers),
            _ => None,
        }
    }

    /// The rows of the real matrix that it is.
    pub fn as_matrix(&self) -> Option<impl ExactSizeIterator<Item = &[f64]>> {
        match (self.form.field, self.form.shape) {
            (Field::Real, Shape::Matrix(_, columns)) => Some(self.numbers.chunks_exact(columns)),
            _ => None,
        }
    }

    /// The entry at `position`, by rows, as a complex number.
    ///
    /// # Panics
    ///
    /// If there is no such entry.
    pub fn entry(&self, position: usize) -> Complex {
        match self.form.field {
            Field::Complex => {
                Complex::new(self.numbers[2 * position], self.numbers[2 * position + 1])
            }
            Field::Boolean | Field::Real => Complex::from(self.numbers[position]),
        }
    }

    /// All numbers by rows; of complex entries real and imaginary part.
    pub fn numbers(&self) -> &[f64] {
        &self.numbers
    }

    /// Bounds on the errors of the numbers.
    pub fn bounds(&self) -> &[f64] {
        &self.bounds
    }
}
