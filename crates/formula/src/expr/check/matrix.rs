//! The types of vectors and matrices, whose entries have dimensions of their own.

use super::{CheckError, Joint, TypeChecker, scaled, times};
use crate::expr::{AnyDimension, Expr, Form, Shape, Type};
use crate::unit::Dimension;
use vibank_source::Span;

/// `[a, b]`, or rows of a matrix.
pub(crate) fn array(checker: &mut TypeChecker<'_>, parts: &[Expr]) -> Option<Type> {
    let found: Vec<Option<Type>> = parts.iter().map(|part| checker.numbers(part)).collect();
    let found: Vec<Type> = found.into_iter().collect::<Option<_>>()?;
    let first = found.first()?.shape();
    for (part, other) in parts.iter().zip(&found) {
        if matches!(other.shape(), Shape::Matrix(..)) {
            let (found, span) = (other.form(), part.span());
            let due = "numbers, or rows of numbers";
            return checker.report(CheckError::ShapeDue {
                function: "[ ]",
                due,
                found,
                span,
            });
        }
        if other.shape() != first {
            let (left, right, spans) = (first, other.shape(), [parts[0].span(), part.span()]);
            return checker.report(CheckError::Shapes {
                operator: "[ ]",
                left,
                right,
                spans,
            });
        }
    }
    let shape = match first {
        Shape::Vector(length) => Shape::Matrix(parts.len(), length),
        _ => Shape::Vector(parts.len()),
    };
    let field = found.iter().map(Type::field).max()?;
    Type::each(
        Form { field, shape },
        found.iter().flat_map(Type::entries).collect(),
    )
}

/// `u[1]`, `M[1, 2]`, or the row `M[1]`.
pub(crate) fn index(
    checker: &mut TypeChecker<'_>,
    inner: &Expr,
    indices: &[Expr],
    span: Span,
) -> Option<Type> {
    let found = checker.numbers(inner);
    let indices: Vec<Option<usize>> = indices.iter().map(|index| whole(checker, index)).collect();
    let (found, indices) = (found?, indices.into_iter().collect::<Option<Vec<usize>>>()?);
    let (_, columns) = found.shape().rows_and_columns();
    let (shape, range) = match (found.shape(), indices.as_slice()) {
        (Shape::Vector(_), [row]) => (Shape::Scalar, range(checker, &found, [*row, 1], 1, span)?),
        (Shape::Matrix(..), [row]) => (
            Shape::Vector(columns),
            range(checker, &found, [*row, 1], columns, span)?,
        ),
        (Shape::Matrix(..), [row, column]) => (
            Shape::Scalar,
            range(checker, &found, [*row, *column], 1, span)?,
        ),
        _ => {
            let count = indices.len();
            return checker.report(CheckError::IndexCount {
                found: found.form(),
                count,
                span,
            });
        }
    };
    Type::each(
        Form {
            field: found.field(),
            shape,
        },
        range.map(|position| found.entry(position)).collect(),
    )
}

/// The positions of `length` entries from this row and column on.
fn range(
    checker: &mut TypeChecker<'_>,
    found: &Type,
    [row, column]: [usize; 2],
    length: usize,
    span: Span,
) -> Option<std::ops::Range<usize>> {
    let (rows, columns) = found.shape().rows_and_columns();
    for (index, most) in [(row, rows), (column, columns)] {
        if index == 0 || index > most {
            checker.report(CheckError::IndexRange {
                index,
                shape: found.shape(),
                span,
            });
            return None;
        }
    }
    let first = (row - 1) * columns + column - 1;
    Some(first..first + length)
}

fn whole(checker: &mut TypeChecker<'_>, index: &Expr) -> Option<usize> {
    let value = index.as_number().filter(|value| value.is_integer());
    let value = value.and_then(|value| usize::try_from(value.numerator()).ok());
    if value.is_none() {
        checker.report(CheckError::IndexNotWhole { span: index.span() });
    }
    value
}

/// A product in which one factor may be a number, or two conformable matrices.
pub(crate) fn product(checker: &mut TypeChecker<'_>, a: &Expr, b: &Expr) -> Option<Type> {
    let (left, right) = (checker.numbers(a), checker.numbers(b));
    let (left, right) = (left?, right?);
    let field = left.field().max(right.field());
    let shape = match (left.shape(), right.shape()) {
        (Shape::Scalar, _) => return Some(scaled(&right, left.dimension()).over(field)),
        (_, Shape::Scalar) => return Some(scaled(&left, right.dimension()).over(field)),
        (Shape::Matrix(rows, inner), Shape::Vector(length)) if inner == length => {
            Shape::Vector(rows)
        }
        (Shape::Matrix(rows, inner), Shape::Matrix(length, columns)) if inner == length => {
            Shape::Matrix(rows, columns)
        }
        (left, right) => {
            let spans = [a.span(), b.span()];
            return checker.report(CheckError::Shapes {
                operator: "*",
                left,
                right,
                spans,
            });
        }
    };
    conformable(
        checker,
        &left,
        &right,
        Form { field, shape },
        a.span().join(b.span()),
    )
}

/// Entry (i, j) is the sum of a_ik b_kj, whose terms have to agree.
fn conformable(
    checker: &mut TypeChecker<'_>,
    left: &Type,
    right: &Type,
    form: Form,
    span: Span,
) -> Option<Type> {
    let (rows, inner) = left.shape().rows_and_columns();
    let (_, columns) = right.shape().rows_and_columns();
    let mut dimensions = Vec::with_capacity(rows * columns);
    for row in 0..rows {
        for column in 0..columns {
            let terms = (0..inner)
                .map(|k| {
                    times(
                        left.entry(row * inner + k),
                        right.entry(k * columns + column),
                    )
                })
                .collect();
            dimensions.push(sum(checker, Joint::Terms("*"), terms, span)?);
        }
    }
    Type::each(form, dimensions)
}

/// The dimension of a sum of terms.
pub(crate) fn sum(
    checker: &mut TypeChecker<'_>,
    joint: Joint,
    terms: Vec<AnyDimension>,
    span: Span,
) -> Option<AnyDimension> {
    let mut known = terms.into_iter().flatten();
    let Some(first) = known.next() else {
        return Some(None);
    };
    if let Some(other) = known.find(|other| *other != first) {
        let spans = [span, span];
        checker.report(CheckError::Dimensions {
            joint,
            left: first,
            right: other,
            spans,
        });
        return None;
    }
    Some(Some(first))
}

pub(crate) fn transpose(checker: &mut TypeChecker<'_>, matrix: &Expr) -> Option<Type> {
    let found = checker.numbers(matrix)?;
    let (rows, columns) = found.shape().rows_and_columns();
    let entries = (0..columns).flat_map(|column| (0..rows).map(move |row| row * columns + column));
    let form = Form {
        field: found.field(),
        shape: Shape::Matrix(columns, rows),
    };
    Type::each(
        form,
        entries.map(|position| found.entry(position)).collect(),
    )
}

/// The dimension of a determinant: entries have to be in dimensions of rows times dimensions of columns.
pub(crate) fn determinant(checker: &mut TypeChecker<'_>, matrix: &Expr) -> Option<Type> {
    let found = checker.numbers(matrix)?;
    let Shape::Matrix(rows, columns) = found.shape() else {
        let (found, span) = (found.form(), matrix.span());
        return checker.report(CheckError::ShapeDue {
            function: "det",
            due: "a square matrix",
            found,
            span,
        });
    };
    if rows != columns || rows > MAX_DETERMINANT {
        let (found, span) = (found.form(), matrix.span());
        let due = "a square matrix of at most ten rows";
        return checker.report(CheckError::ShapeDue {
            function: "det",
            due,
            found,
            span,
        });
    }
    match factored(&found, rows) {
        Ok(dimension) => Some(Type::uniform(Form::scalar(found.field()), dimension)),
        Err((left, right)) => {
            let spans = [matrix.span(), matrix.span()];
            checker.report(CheckError::Dimensions {
                joint: Joint::Terms("det"),
                left,
                right,
                spans,
            })
        }
    }
}

/// As far as a program computes determinants.
const MAX_DETERMINANT: usize = 10;

/// The dimension of the determinant of a matrix whose entries are in rᵢ cⱼ: the product of all rᵢ and cⱼ.
///
/// Rows and columns are the two sides of a graph whose edges are the entries of known dimension. In each connected
/// part the factors are found from one row on; an entry that contradicts them is the error.
fn factored(found: &Type, order: usize) -> Result<AnyDimension, (Dimension, Dimension)> {
    let mut row_factors: Vec<AnyDimension> = vec![None; order];
    let mut column_factors: Vec<AnyDimension> = vec![None; order];
    for start in 0..order {
        row_factors[start].get_or_insert(Dimension::PURE);
        // Each pass reaches further along the graph; the longest path has 2·order edges.
        for _ in 0..2 * order {
            for (position, entry) in found.entries().enumerate() {
                let (row, column) = (position / order, position % order);
                let Some(entry) = entry else { continue };
                match (row_factors[row], column_factors[column]) {
                    (Some(r), None) => column_factors[column] = Some(entry / r),
                    (None, Some(c)) => row_factors[row] = Some(entry / c),
                    (Some(r), Some(c)) if r * c != entry => return Err((entry, r * c)),
                    _ => {}
                }
            }
        }
    }
    // A column without known entries is a column of zeros.
    Ok(times(of_product(row_factors), of_product(column_factors)))
}

/// The dimension of a product, if all its factors have one.
fn of_product(factors: Vec<AnyDimension>) -> Option<Dimension> {
    factors
        .into_iter()
        .try_fold(Dimension::PURE, |product, factor| Some(product * factor?))
}
