//! Reading a workbook: its cells one after the other, since a table of all that a single cell at the far end spans has
//! 17 thousand million of them.

use std::collections::BTreeMap;
use std::io::{Cursor, Read};

use calamine::{DataRef, Reader, SheetType, SheetVisible, Xlsx, XlsxError};
use zip::ZipArchive;

use super::places::misleading;
use super::{Spoilt, WorkbookSheet};
use crate::cli::table::composed;

/// Bytes of all files in a workbook, unpacked: a workbook of 30,000 rows has a tenth of it. What is packed may be a
/// thousand times as much.
const MAX_UNPACKED: u64 = 128 << 20;

/// Columns that are read.
const MAX_COLUMNS: usize = 1000;

/// Cells that are read, blank ones before the last of a row included.
const MAX_CELLS: usize = 5_000_000;

/// Bytes of text that are read: many cells may share one long text.
const MAX_TEXT: usize = 64 << 20;

/// The first visible sheet with something in it, or what is wrong.
pub(crate) fn sheet(bytes: &[u8]) -> Result<WorkbookSheet, String> {
    check_size(bytes)?;
    let mut book = Xlsx::new(Cursor::new(bytes))
        .map_err(|error| format!("a workbook that cannot be read: {error}"))?;
    let sheets = book.sheets_metadata().iter();
    let names: Vec<String> = sheets
        .filter(|sheet| sheet.typ == SheetType::WorkSheet && sheet.visible == SheetVisible::Visible)
        .map(|sheet| sheet.name.clone())
        .collect();
    let mut filled: Option<(String, WorkbookSheet)> = None;
    for name in names {
        let sheet = cells(&mut book, &name)?;
        if sheet.rows.is_empty() {
            continue;
        }
        if let Some((first, found)) = &mut filled {
            found.doubt = Some(format!(
                "of the sheets of the workbook the first one was read, `{first}`, and not `{name}`"
            ));
            break;
        }
        filled = Some((name, sheet));
    }
    Ok(filled.map(|(_, sheet)| sheet).unwrap_or_default())
}

/// What is said of an archive.
fn broken(error: impl std::fmt::Display) -> String {
    format!("an archive that cannot be read: {error}")
}

/// Unpacks all files once, and looks the sheets over: what an archive says about sizes need not be true.
fn check_size(bytes: &[u8]) -> Result<(), String> {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(broken)?;
    if archive.index_for_name("xl/workbook.xml").is_none() {
        return Err("an archive, and no workbook of Excel (.xlsx)".to_owned());
    }
    let mut left = MAX_UNPACKED;
    for place in 0..archive.len() {
        let file = archive.by_index(place).map_err(broken)?;
        let name = file.name().map_err(broken)?.into_owned();
        let mut content = Vec::new();
        let read = file.take(left + 1).read_to_end(&mut content);
        let read = read.map_err(broken)? as u64;
        left = left.checked_sub(read).ok_or_else(|| {
            format!(
                "a workbook of more than {} MiB, unpacked",
                MAX_UNPACKED >> 20
            )
        })?;
        if let Some(found) = misleading(&content) {
            return Err(format!("a workbook with a file `{name}` {found}"));
        }
    }
    Ok(())
}

fn cells(book: &mut Xlsx<Cursor<&[u8]>>, name: &str) -> Result<WorkbookSheet, String> {
    let broken = |error: XlsxError| format!("the sheet `{name}` cannot be read: {error}");
    let mut rows: BTreeMap<usize, Vec<String>> = BTreeMap::new();
    let mut spoilt = BTreeMap::new();
    let (mut count, mut text) = (0, 0);
    let mut reader = book.worksheet_cells_reader(name).map_err(broken)?;
    while let Some(cell) = reader.next_cell().map_err(broken)? {
        let (row, column) = cell.get_position();
        let (row, column) = (row as usize + 1, column as usize);
        let (words, fault) = written(cell.get_value());
        if words.is_empty() {
            continue;
        }
        if column >= MAX_COLUMNS {
            return Err(format!("row {row} has a cell beyond column {MAX_COLUMNS}"));
        }
        let cells = rows.entry(row).or_default();
        count += (column + 1).saturating_sub(cells.len());
        text += words.len();
        if count > MAX_CELLS || text > MAX_TEXT {
            return Err(format!(
                "a table of more than {MAX_CELLS} cells or {} MiB of text",
                MAX_TEXT >> 20
            ));
        }
        if cells.len() <= column {
            cells.resize(column + 1, String::new());
        }
        cells[column] = words;
        spoilt.extend(fault.map(|fault| ((row, column), fault)));
    }
    Ok(WorkbookSheet {
        rows: rows.into_iter().collect(),
        doubt: None,
        spoilt,
    })
}

/// What a cell shows, and what has become of it.
fn written(value: &DataRef<'_>) -> (String, Option<Spoilt>) {
    match value {
        DataRef::Empty => (String::new(), None),
        DataRef::Int(number) => (number.to_string(), None),
        DataRef::Float(number) => (number.to_string(), None),
        DataRef::String(text) => (composed(text.trim().to_owned()), None),
        DataRef::SharedString(text) => (composed(text.trim().to_owned()), None),
        DataRef::Bool(is_true) => (is_true.to_string().to_uppercase(), None),
        DataRef::DateTime(date) if date.is_datetime() => {
            let (year, month, day, ..) = date.to_ymd_hms_milli();
            (format!("{year}-{month:02}-{day:02}"), Some(Spoilt::Date))
        }
        DataRef::DateTime(time) => (time.as_f64().to_string(), Some(Spoilt::Date)),
        DataRef::DateTimeIso(text) | DataRef::DurationIso(text) => {
            (composed(text.trim().to_owned()), Some(Spoilt::Date))
        }
        DataRef::Error(error) => (error.to_string(), Some(Spoilt::Formula)),
    }
}
