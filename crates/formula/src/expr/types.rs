//! What a formula stands for: truth or number, how many, of which dimension.

use std::fmt;
use std::sync::Arc;

use crate::unit::Dimension;

/// What the entries of a value are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Field {
    /// True or false.
    Boolean,
    /// Real numbers.
    Real,
    /// Complex numbers.
    Complex,
}

/// How the entries of a value are arranged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Shape {
    /// One entry.
    Scalar,
    /// A list of this length.
    Vector(usize),
    /// Rows and columns.
    Matrix(usize, usize),
}

/// Field and shape together: what a program computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Form {
    /// What the entries are.
    pub field: Field,
    /// How they are arranged.
    pub shape: Shape,
}

/// What is known of the dimension of an entry: zero and infinity have every dimension.
///
/// `None` is that every dimension fits.
pub type AnyDimension = Option<Dimension>;

/// The type of a formula: form and dimensions.
///
/// # Examples
///
/// ```
/// use vibank_formula::expr::{Form, Type};
/// use vibank_formula::unit::Dimension;
///
/// let mass = Type::real(Dimension::MASS);
/// assert_eq!(mass.form(), Form::REAL);
/// assert_eq!(mass.dimension(), Some(Dimension::MASS));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Type {
    form: Form,
    dimensions: Dimensions,
}

/// The dimensions of the entries.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Dimensions {
    /// One for all.
    Uniform(AnyDimension),
    /// One per entry, by rows.
    Each(Arc<[AnyDimension]>),
}

impl Shape {
    /// The number of entries.
    pub fn len(self) -> usize {
        match self {
            Self::Scalar => 1,
            Self::Vector(length) => length,
            Self::Matrix(rows, columns) => rows * columns,
        }
    }

    /// Whether there is no entry; formulas cannot write such a shape.
    pub fn is_empty(self) -> bool {
        self.len() == 0
    }

    /// Rows and columns; a vector is a column.
    pub fn rows_and_columns(self) -> (usize, usize) {
        match self {
            Self::Scalar => (1, 1),
            Self::Vector(length) => (length, 1),
            Self::Matrix(rows, columns) => (rows, columns),
        }
    }
}

impl Form {
    /// True or false.
    pub const BOOLEAN: Self = Self::scalar(Field::Boolean);
    /// A real number.
    pub const REAL: Self = Self::scalar(Field::Real);
    /// A complex number.
    pub const COMPLEX: Self = Self::scalar(Field::Complex);

    /// One entry.
    pub const fn scalar(field: Field) -> Self {
        Self {
            field,
            shape: Shape::Scalar,
        }
    }

    /// Real entries of this shape.
    pub const fn real(shape: Shape) -> Self {
        Self {
            field: Field::Real,
            shape,
        }
    }

    /// The number of real numbers that hold a value: two for a complex entry.
    pub fn width(self) -> usize {
        match self.field {
            Field::Complex => 2 * self.shape.len(),
            Field::Boolean | Field::Real => self.shape.len(),
        }
    }
}

impl Type {
    /// The type with this form whose entries all have this dimension.
    pub fn uniform(form: Form, dimension: impl Into<AnyDimension>) -> Self {
        Self {
            form,
            dimensions: Dimensions::Uniform(dimension.into()),
        }
    }

    /// The type with this form and a dimension per entry, by rows; `None` unless there is one for each entry.
    pub fn each(form: Form, dimensions: Vec<AnyDimension>) -> Option<Self> {
        if dimensions.len() != form.shape.len() {
            return None;
        }
        let first = dimensions.first().copied().flatten();
        if dimensions.iter().all(|dimension| *dimension == first) {
            return Some(Self::uniform(form, first));
        }
        Some(Self {
            form,
            dimensions: Dimensions::Each(dimensions.into()),
        })
    }

    /// True or false.
    pub fn boolean() -> Self {
        Self::uniform(Form::BOOLEAN, Dimension::PURE)
    }

    /// A real number of this dimension.
    pub fn real(dimension: impl Into<AnyDimension>) -> Self {
        Self::uniform(Form::REAL, dimension)
    }

    /// A complex number of this dimension.
    pub fn complex(dimension: impl Into<AnyDimension>) -> Self {
        Self::uniform(Form::COMPLEX, dimension)
    }

    /// Field and shape.
    pub fn form(&self) -> Form {
        self.form
    }

    /// What the entries are.
    pub fn field(&self) -> Field {
        self.form.field
    }

    /// How the entries are arranged.
    pub fn shape(&self) -> Shape {
        self.form.shape
    }

    /// The dimension of the entry at `position`, by rows; `None` if every dimension fits.
    pub fn entry(&self, position: usize) -> AnyDimension {
        match &self.dimensions {
            Dimensions::Uniform(dimension) => *dimension,
            Dimensions::Each(dimensions) => dimensions.get(position).copied().flatten(),
        }
    }

    /// The dimensions of all entries, by rows.
    pub fn entries(&self) -> impl Iterator<Item = AnyDimension> + '_ {
        (0..self.shape().len()).map(|position| self.entry(position))
    }

    /// The dimension that all entries have; `None` if every dimension fits, or if the entries differ.
    pub fn dimension(&self) -> AnyDimension {
        match self.dimensions {
            Dimensions::Uniform(dimension) => dimension,
            Dimensions::Each(_) => None,
        }
    }

    /// Whether all entries have one dimension.
    pub fn is_uniform(&self) -> bool {
        matches!(self.dimensions, Dimensions::Uniform(_))
    }

    /// Whether a value of this type serves where `other` is due: the same form (a real number serves as a complex one),
    /// and dimensions that agree entry by entry.
    pub fn fits(&self, other: &Self) -> bool {
        let fields = self.field() == other.field()
            || (self.field(), other.field()) == (Field::Real, Field::Complex);
        fields
            && self.shape() == other.shape()
            && self
                .entries()
                .zip(other.entries())
                .all(|(a, b)| agree(a, b))
    }

    /// The same form and dimensions over another field.
    #[must_use]
    pub(crate) fn over(&self, field: Field) -> Self {
        Self {
            form: Form { field, ..self.form },
            dimensions: self.dimensions.clone(),
        }
    }

    /// The same field and shape with each dimension changed.
    #[must_use]
    pub(crate) fn map(&self, change: impl Fn(Dimension) -> Dimension) -> Self {
        let dimensions = match &self.dimensions {
            Dimensions::Uniform(dimension) => Dimensions::Uniform(dimension.map(&change)),
            Dimensions::Each(all) => {
                Dimensions::Each(all.iter().map(|dimension| dimension.map(&change)).collect())
            }
        };
        Self {
            form: self.form,
            dimensions,
        }
    }
}

/// Whether two dimensions may be the same.
pub(crate) fn agree(a: AnyDimension, b: AnyDimension) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => a == b,
        _ => true,
    }
}

/// In words: `a number`, `a vector of 3`.
impl fmt::Display for Shape {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Scalar => formatter.write_str("a number"),
            Self::Vector(length) => write!(formatter, "a vector of {length}"),
            Self::Matrix(rows, columns) => write!(formatter, "a matrix of {rows} by {columns}"),
        }
    }
}

/// In words: `a condition`, `a complex number`, `a vector of 3`.
impl fmt::Display for Form {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.field, self.shape) {
            (Field::Boolean, _) => formatter.write_str("a condition"),
            (Field::Complex, Shape::Scalar) => formatter.write_str("a complex number"),
            (Field::Complex, shape) => write!(formatter, "{shape} with complex entries"),
            (Field::Real, shape) => shape.fmt(formatter),
        }
    }
}
