//! Workbooks of spreadsheets, which a program built with the feature `xlsx` reads and writes.

#[cfg(feature = "xlsx")]
mod places;
#[cfg(feature = "xlsx")]
mod read;
#[cfg(feature = "xlsx")]
mod write;

use std::collections::BTreeMap;

use crate::cli::Failure;

/// The format, in the blueprint, and the ending of its files.
pub(crate) const XLSX: &str = "xlsx";

/// Whether this program was built with workbooks.
pub(crate) const IS_BUILT_IN: bool = cfg!(feature = "xlsx");

/// The first sheet of a workbook that has something in it.
#[derive(Debug, Default)]
pub(crate) struct WorkbookSheet {
    /// Rows that are not blank, each with its number, from 1.
    pub(crate) rows: Vec<(usize, Vec<String>)>,
    /// What the reader should look at.
    pub(crate) doubt: Option<String>,
    /// Cells that do not hold what was typed, by row and column.
    pub(crate) spoilt: BTreeMap<(usize, usize), Spoilt>,
}

/// What a spreadsheet has made of what was typed.
#[cfg_attr(
    not(feature = "xlsx"),
    expect(dead_code, reason = "found in workbooks alone")
)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub(crate) enum Spoilt {
    /// `1/2` or `3-7`.
    #[error("a date, which the spreadsheet has made of what was typed")]
    Date,
    /// `=k1+k2`, or `-k x` where the program takes it for a formula.
    #[error("the error of a formula, for which the spreadsheet has taken what was typed")]
    Formula,
}

/// A cell of a workbook that is written.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Cell {
    Text(String),
    Number(f64),
}

impl Cell {
    pub(crate) fn text(text: impl Into<String>) -> Self {
        Self::Text(text.into())
    }

    /// A number if it is one, with a decimal point, else text.
    pub(crate) fn of(text: &str) -> Self {
        let number = text.parse().ok().filter(|number: &f64| number.is_finite());
        number.map_or_else(|| Self::text(text), Self::Number)
    }
}

/// Reads the bytes of a workbook.
#[cfg(feature = "xlsx")]
pub(crate) fn read(shown: &str, bytes: &[u8]) -> Result<WorkbookSheet, Failure> {
    read::sheet(bytes).map_err(|what| {
        Failure::new(format!("`{shown}`: {what}"))
            .help("save the table as CSV (UTF-8), and give that")
    })
}

/// Reads the bytes of a workbook.
#[cfg(not(feature = "xlsx"))]
pub(crate) fn read(shown: &str, _: &[u8]) -> Result<WorkbookSheet, Failure> {
    Err(Failure::new(format!(
        "`{shown}` is a workbook or an archive, and this program was built without the feature `xlsx`"
    ))
    .help("save the table as CSV (UTF-8); or use a program from the releases, or one built with `--features xlsx`"))
}

/// A workbook of one sheet, with a row of headings that stays in sight. The same cells give the same bytes.
#[cfg(feature = "xlsx")]
pub(crate) fn written(name: &str, head: &[String], rows: &[Vec<Cell>]) -> Result<Vec<u8>, Failure> {
    write::book(name, head, rows)
        .map_err(|error| Failure::new(format!("cannot write a workbook: {error}")))
}

/// A workbook of one sheet, with a row of headings that stays in sight. The same cells give the same bytes.
#[cfg(not(feature = "xlsx"))]
pub(crate) fn written(_: &str, _: &[String], _: &[Vec<Cell>]) -> Result<Vec<u8>, Failure> {
    Err(missing())
}

/// Where a workbook is asked for that this program cannot write.
pub(crate) fn missing() -> Failure {
    Failure::new("this program was built without the feature `xlsx`, which writes workbooks")
        .help("remove `xlsx` from `formats`, `csv = \"excel\"` makes tables that a spreadsheet opens; or use a program from the releases, or one built with `--features xlsx`")
}
