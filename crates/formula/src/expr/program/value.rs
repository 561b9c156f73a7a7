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
    numbers: OneOrSeveral,
}

/// The entries by rows; of complex entries real and imaginary part.
// Most values are one number, of which thousands are computed for a sheet: they take no allocation.
#[derive(Clone, Debug, PartialEq)]
enum OneOrSeveral {
    One { number: f64, bound: f64 },
    Several { numbers: Vec<f64>, bounds: Vec<f64> },
}

impl Value {
    /// A value of this form; `None` unless there are as many numbers and bounds as it holds.
    pub fn new(form: Form, numbers: Vec<f64>, bounds: Vec<f64>) -> Option<Self> {
        let fits = numbers.len() == form.width() && bounds.len() == numbers.len();
        let numbers = match (&numbers[..], &bounds[..]) {
            (&[number], &[bound]) => OneOrSeveral::One { number, bound },
            _ => OneOrSeveral::Several { numbers, bounds },
        };
        fits.then_some(Self { form, numbers })
    }

    /// The one number that a value of this form is, with a bound on its error; `None` for forms of several.
    pub(crate) fn of_one(form: Form, number: f64, bound: f64) -> Option<Self> {
        let numbers = OneOrSeveral::One { number, bound };
        (form.width() == 1).then_some(Self { form, numbers })
    }

    /// A real number with a bound on its error.
    pub fn real(number: f64, bound: f64) -> Self {
        Self {
            form: Form::REAL,
            numbers: OneOrSeveral::One { number, bound },
        }
    }

    /// The same with all numbers multiplied by a factor.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        let mut scaled = self.clone();
        match &mut scaled.numbers {
            OneOrSeveral::One { number, .. } => *number *= factor,
            OneOrSeveral::Several { numbers, .. } => {
                numbers.iter_mut().for_each(|own| *own *= factor);
            }
        }
        scaled
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
        (self.form == Form::REAL).then(|| self.numbers()[0])
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
        (self.form == Form::BOOLEAN).then(|| self.numbers()[0] != 0.0)
    }

    /// The list of real numbers that it is.
    pub fn as_vector(&self) -> Option<&[f64]> {
        match (self.form.field, self.form.shape) {
            (Field::Real, Shape::Vector(_)) => Some(self.numbers()),
            _ => None,
        }
    }

    /// The rows of the real matrix that it is.
    pub fn as_matrix(&self) -> Option<impl ExactSizeIterator<Item = &[f64]>> {
        match (self.form.field, self.form.shape) {
            (Field::Real, Shape::Matrix(_, columns)) => Some(self.numbers().chunks_exact(columns)),
            _ => None,
        }
    }

    /// The entry at `position`, by rows, as a complex number.
    ///
    /// # Panics
    ///
    /// If there is no such entry.
    pub fn entry(&self, position: usize) -> Complex {
        let numbers = self.numbers();
        match self.form.field {
            Field::Complex => Complex::new(numbers[2 * position], numbers[2 * position + 1]),
            Field::Boolean | Field::Real => Complex::from(numbers[position]),
        }
    }

    /// All numbers by rows; of complex entries real and imaginary part.
    pub fn numbers(&self) -> &[f64] {
        match &self.numbers {
            OneOrSeveral::One { number, .. } => std::slice::from_ref(number),
            OneOrSeveral::Several { numbers, .. } => numbers,
        }
    }

    /// Bounds on the errors of the numbers.
    pub fn bounds(&self) -> &[f64] {
        match &self.numbers {
            OneOrSeveral::One { bound, .. } => std::slice::from_ref(bound),
            OneOrSeveral::Several { bounds, .. } => bounds,
        }
    }
}
