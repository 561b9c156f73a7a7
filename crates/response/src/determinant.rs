//! Determinants of matrices that are written out: `det([[a, b], [c, d]])`, `\det\begin{pmatrix}…`,
//! `\begin{vmatrix} a & b \\ c & d \end{vmatrix}`, as the sums of products that they are.

use super::list::{Listed, Wanted, list_of_form};
use super::parser::Parser;
use super::token::Item;
use super::{Lexicon, Trouble, TypedError};
use vibank_formula::expr::{Expr, Operator};

/// What people and programs call it.
const NAMES: &[&str] = &[
    "\\det",
    "det",
    "Det",
    "determinant",
    "Determinant",
    "LinearAlgebra:-Determinant",
    "LinearAlgebra[Determinant]",
];
/// Environments with bars around them, and one of the same length without.
const BARRED: [(&str, &str); 2] = [("{vmatrix}", "{pmatrix}"), ("{Vmatrix}", "{pmatrix}")];
/// Most rows: a determinant has as many products as there are orders of them.
const MAX_ROWS: usize = 4;

/// The determinant of a matrix that stands at a place, and its length; its matrix holds no other one.
pub(crate) fn determinant(text: &str, at: usize, lexicon: &Lexicon) -> Option<(Item, usize)> {
    let rest = &text[at..];
    if !rest.starts_with(['\\', 'd', 'D', 'L', '|']) {
        return None;
    }
    let (matrix, length) = enclosed(rest)?;
    let is_square = |rows: &[Vec<Expr>]| {
        (2..=MAX_ROWS).contains(&rows.len()) && rows.iter().all(|row| row.len() == rows.len())
    };
    let fits = |list: &Listed| is_square(&list.rows);
    let listed = list_of_form(&matrix, lexicon, &[], Wanted::Matrix(None), fits).ok();
    let rows = listed
        .filter(|list| list.unit.is_none() && fits(list))
        .map(|list| list.rows);
    let sum = rows.and_then(|rows| {
        let rows: Vec<&[Expr]> = rows.iter().map(Vec::as_slice).collect();
        expanded(&rows).ok()
    });
    if let Some(sum) = sum {
        return Some((Item::Leaf(sum), length));
    }
    // `det(K - ω² M)` says what is true of every system.
    let is_of_names = is_called(rest) && !lexicon.knows("det");
    is_of_names.then(|| {
        let error = TypedError::new(Trouble::NamedMatrices, at, at + length);
        (Item::Unread(Box::new(error)), length)
    })
}

/// An equation that begins with a matrix between bars, whose rows semicolons part, by the name of its determinant.
pub(crate) fn of_bars(text: &str) -> Option<String> {
    let (matrix, rest) = text.strip_prefix('|')?.split_once('|')?;
    matrix
        .contains(';')
        .then(|| format!("det([{matrix}]){rest}"))
}

/// Whether a text begins with the name of a determinant.
fn is_called(text: &str) -> bool {
    NAMES.iter().any(|name| text.starts_with(name))
}

/// The matrix of the determinant with which a text begins, and the length of all of it.
fn enclosed(text: &str) -> Option<(String, usize)> {
    let called = NAMES
        .iter()
        .filter_map(|name| text.strip_prefix(name))
        .next_back();
    let (rest, is_barred) = match (called, text.strip_prefix('|')) {
        (Some(rest), _) => (rest.trim_start(), false),
        (None, Some(rest)) => (rest.trim_start(), true),
        (None, None) => (text, false),
    };
    let start = text.len() - rest.len();
    let (matrix, end) = if let Some(behind) = rest.strip_prefix("\\begin{") {
        let has_bars = BARRED
            .iter()
            .any(|(name, _)| rest["\\begin".len()..].starts_with(name));
        let at = behind.find("\\end{")?;
        let close = behind[at..].find('}')?;
        let end = rest.len() - behind.len() + at + close + 1;
        // One of the two says that it is a determinant, and not both.
        if has_bars == (called.is_some() || is_barred) {
            return None;
        }
        let plain = |text: String, (name, plain): &(&str, &str)| text.replace(name, plain);
        (BARRED.iter().fold(rest[..end].to_owned(), plain), end)
    } else if called.is_some() {
        let mut depth = 0_usize;
        let end = rest.char_indices().find_map(|(at, char)| {
            match char {
                '(' | '[' | '{' => depth += 1,
                ')' | ']' | '}' => depth = depth.saturating_sub(1),
                _ => {}
            }
            (depth == 0).then_some(at)
        });
        let end = end.filter(|end| *end > 0)?;
        (rest[1..end].to_owned(), end + 1)
    } else {
        return None;
    };
    let end = start + end;
    let length = if is_barred {
        let behind = text[end..].trim_start().strip_prefix('|')?;
        text.len() - behind.len()
    } else {
        end
    };
    let holds_other = matrix.contains("vmatrix")
        || matrix.contains("Vmatrix")
        || matrix.to_ascii_lowercase().contains("det");
    (!holds_other).then_some((matrix, length))
}

/// The determinant of rows, by those of its minors.
fn expanded(rows: &[&[Expr]]) -> Result<Expr, TypedError> {
    let [first, below @ ..] = rows else {
        return Ok(Expr::number(1));
    };
    if let [only] = first {
        return Ok(only.clone());
    }
    let mut sum: Option<Expr> = None;
    for (column, entry) in first.iter().enumerate() {
        if entry.is_zero() {
            continue;
        }
        let kept: Vec<Vec<Expr>> = below
            .iter()
            .map(|row| [&row[..column], &row[column + 1..]].concat())
            .collect();
        let minor = expanded(&kept.iter().map(Vec::as_slice).collect::<Vec<_>>())?;
        let product = Parser::binary(Operator::Multiply, entry.clone(), minor)?;
        let is_minus = column % 2 == 1;
        sum = Some(match sum {
            Some(sum) if is_minus => Parser::binary(Operator::Subtract, sum, product)?,
            Some(sum) => Parser::binary(Operator::Add, sum, product)?,
            None if is_minus => -product,
            None => product,
        });
    }
    Ok(sum.unwrap_or_else(|| Expr::number(0)))
}
