//! Tables that people and spreadsheets write: CSV in all its dialects, and workbooks.

mod cells;
mod decode;
mod dialect;
pub(crate) mod workbook;

pub(crate) use self::cells::{Broken, RowFault, TableRow};
pub(crate) use self::decode::composed;
pub(crate) use self::dialect::Dialect;
pub(crate) use self::workbook::Spoilt;

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::path::Path;

use self::cells::Cursor;
use super::{Failure, files};

/// What becomes of a row.
pub(crate) enum Edit {
    /// It stays as it is.
    Keep,
    /// It goes.
    Drop,
    /// Another line, with its end, takes its place.
    Replace(String),
}

/// A table with a row of headings.
#[derive(Debug)]
pub(crate) struct Table {
    /// Headings, as they are written.
    pub(crate) headings: Vec<String>,
    /// What the reader should look at, if the encoding had to be guessed.
    pub(crate) doubt: Option<String>,
    /// Whether it began with a mark of byte order, or needs one to be read as UTF-8 by the program that wrote it.
    pub(crate) has_mark: bool,
    body: Body,
    /// Cells of a workbook that do not hold what was typed, by line and place.
    spoilt: BTreeMap<(usize, usize), Spoilt>,
}

/// UTF-8 with a mark of byte order begins like this.
const MARK: &[u8] = "\u{feff}".as_bytes();

/// Workbooks begin like this, as other archives do.
const PACKED: &[u8] = b"PK\x03\x04";

#[derive(Debug)]
enum Body {
    Text {
        text: String,
        delimiter: u8,
    },
    /// The rows of a workbook that are not blank, with their numbers.
    Rows(Vec<(usize, Vec<String>)>),
}

impl Table {
    /// Reads a file: CSV with commas, semicolons or tabs, in UTF-8, UTF-16 or Windows-1252; or a workbook.
    pub(crate) fn read(path: &Path) -> Result<Self, Failure> {
        let shown = path.display();
        let bytes = files::read_bytes(path)?;
        if bytes.starts_with(PACKED) {
            return Self::of_workbook(path, &bytes);
        }
        if let Some(what) = foreign(&bytes) {
            return Err(
                Failure::new(format!("`{shown}` is {what}, no table of text"))
                    .help("save it as CSV (UTF-8)"),
            );
        }
        let has_mark =
            bytes.starts_with(MARK) || bytes.contains(&0) || std::str::from_utf8(&bytes).is_err();
        let decoded = decode::decode(bytes).map_err(|error| {
            Failure::new(format!("`{shown}`, line {}: {}", error.line, error.found))
                .help("save the file as CSV in UTF-8")
        })?;
        let doubt = decoded.is_guessed.then(|| {
            let sample = sample(&decoded.text);
            format!("`{shown}` is not UTF-8 and was read as Windows-1252; is `{sample}` right?")
        });
        let (text, delimiter) = match named_delimiter(&decoded.text) {
            // The line stays, empty, so that lines are counted as an editor does.
            Some((end, delimiter)) => (decoded.text[end..].to_owned(), delimiter),
            None => {
                let delimiter = delimiter(&decoded.text);
                (decoded.text, delimiter)
            }
        };
        let table = Self {
            headings: Vec::new(),
            doubt,
            has_mark,
            body: Body::Text { text, delimiter },
            spoilt: BTreeMap::new(),
        };
        table.with_headings(path)
    }

    fn of_workbook(path: &Path, bytes: &[u8]) -> Result<Self, Failure> {
        let sheet = workbook::read(&path.display().to_string(), bytes)?;
        let table = Self {
            headings: Vec::new(),
            doubt: sheet.doubt,
            has_mark: false,
            body: Body::Rows(sheet.rows),
            spoilt: sheet.spoilt,
        };
        table.with_headings(path)
    }

    /// The table with its first row as headings.
    fn with_headings(mut self, path: &Path) -> Result<Self, Failure> {
        let shown = path.display();
        let header = match self.all(&|_| false).next() {
            None => {
                return Err(Failure::new(format!("`{shown}` is empty"))
                    .help("give it a row of headings, and a row for each student or answer"));
            }
            Some(Err(fault)) => return Err(Failure::new(format!("`{shown}`, {fault}"))),
            Some(Ok(row)) => row
                .cells
                .into_iter()
                .map(|cell| cell.into_owned())
                .collect(),
        };
        self.headings = header;
        Ok(self)
    }

    /// What has become of a cell in a workbook, if that is not what was typed.
    pub(crate) fn spoilt(&self, line: usize, at: usize) -> Option<Spoilt> {
        self.spoilt.get(&(line, at)).copied()
    }

    /// The rows below the headings; blank ones are passed over. A cell without a heading is a fault.
    ///
    /// `begins_row` says whether cells look like those of a row of their own: a quoted cell with such a line in it was
    /// not closed.
    pub(crate) fn rows<'t>(
        &'t self,
        begins_row: &'t dyn Fn(&TableRow<'_>) -> bool,
    ) -> impl Iterator<Item = Result<TableRow<'t>, Broken<'t>>> {
        let delimiter = self.delimiter().map(char::from);
        self.all(begins_row).skip(1).map(move |row| {
            let row = row?;
            let Some(at) = row.cells.iter().enumerate().position(|(at, cell)| {
                let heading = self.headings.get(at);
                !cell.is_empty() && heading.is_none_or(|heading| heading.is_empty())
            }) else {
                return Ok(row);
            };
            let (line, column) = (row.line, at + 1);
            // After the last heading a cell with a delimiter in it has shifted the others.
            let is_between = |at: usize| {
                let mut behind = self.headings.iter().skip(at);
                behind.any(|heading| !heading.is_empty())
            };
            let fault = match delimiter {
                None => RowFault::Unheaded { line },
                Some(_) if is_between(at) => RowFault::Nameless { line, column },
                Some(delimiter) => RowFault::Wide { line, delimiter },
            };
            Err(Broken { fault, row })
        })
    }

    /// What stands between two cells of a text.
    pub(crate) fn delimiter(&self) -> Option<u8> {
        match &self.body {
            Body::Text { delimiter, .. } => Some(*delimiter),
            Body::Rows(_) => None,
        }
    }

    /// The text of the table with other rows, and how many are other ones; what is not changed keeps its bytes, and a row
    /// that cannot be read stays.
    pub(crate) fn edited(
        &self,
        edit: &mut dyn FnMut(&TableRow<'_>) -> Result<Edit, Failure>,
    ) -> Result<(String, usize), Failure> {
        let Body::Text { text, delimiter } = &self.body else {
            return Err(Failure::new("a table of the run is a workbook now")
                .help("save it as CSV under the name that it has, or remove it"));
        };
        let mut cursor = Cursor::new(text, *delimiter);
        let (mut edited, mut count) = (String::new(), 0);
        loop {
            let start = cursor.at();
            let Some(row) = cursor.row(&|_| false) else {
                return Ok((edited, count));
            };
            let own = &text[start..cursor.at()];
            let edit = match row {
                Ok(row) => edit(&row)?,
                Err(_) => Edit::Keep,
            };
            count += usize::from(!matches!(edit, Edit::Keep));
            match edit {
                Edit::Keep => edited.push_str(own),
                Edit::Replace(line) => edited.push_str(&line),
                Edit::Drop => {}
            }
        }
    }

    /// All rows that are not blank.
    fn all<'t>(
        &'t self,
        begins_row: &'t dyn Fn(&TableRow<'_>) -> bool,
    ) -> impl Iterator<Item = Result<TableRow<'t>, Broken<'t>>> {
        let (text, rows): (_, &[(usize, Vec<String>)]) = match &self.body {
            Body::Text { text, delimiter } => (Some((text, *delimiter)), &[]),
            Body::Rows(rows) => (None, rows),
        };
        let mut cursor = text.map(|(text, delimiter)| Cursor::new(text, delimiter));
        let next = move || cursor.as_mut()?.row(begins_row);
        let typed = rows.iter().map(|(line, cells)| {
            let cells = cells.iter().map(|cell| Cow::Borrowed(cell.as_str()));
            let cells = cells.collect();
            Ok(TableRow { line: *line, cells })
        });
        let rows = std::iter::from_fn(next).chain(typed);
        rows.filter(|row| !matches!(row, Ok(row) if row.width() == 0))
    }
}

/// Files that teachers take for tables.
fn foreign(bytes: &[u8]) -> Option<&'static str> {
    let kinds: [(&[u8], &str); 2] = [
        (b"\xd0\xcf\x11\xe0", "an old workbook or document"),
        (b"%PDF-", "a PDF"),
    ];
    let mut kinds = kinds.into_iter();
    kinds
        .find(|(mark, _)| bytes.starts_with(mark))
        .map(|(_, what)| what)
}

/// The first word with a letter by which one sees whether the encoding was guessed right.
fn sample(text: &str) -> String {
    let mut words = text.split(|char: char| !char.is_alphanumeric());
    let word = words
        .find(|word| !word.is_ascii())
        .or_else(|| text.lines().find(|line| !line.is_ascii()));
    word.unwrap_or_default().chars().take(30).collect()
}

/// The delimiter that a first line `sep=;` names for a spreadsheet, and where that line ends.
fn named_delimiter(text: &str) -> Option<(usize, u8)> {
    let end = text.find(['\n', '\r'])?;
    match text.as_bytes()[..end].split_at_checked(4)? {
        (word, [delimiter]) if word.eq_ignore_ascii_case(b"sep=") => Some((end, *delimiter)),
        _ => None,
    }
}

/// The delimiter of the first line with words: spreadsheets write semicolons where the comma is the decimal sign.
pub(crate) fn delimiter(text: &str) -> u8 {
    let mut lines = text
        .split(['\n', '\r'])
        .skip_while(|line| line.trim_matches([',', ';', '\t', ' ']).is_empty());
    let header = lines.next().unwrap_or_default();
    // Quotation marks do not nest: every other piece lies outside of them.
    let outside = || header.split('"').step_by(2);
    [b'\t', b';', b',']
        .into_iter()
        .max_by_key(|sign| {
            let bytes = outside().flat_map(str::bytes);
            bytes.filter(|byte| *byte == *sign).count()
        })
        .unwrap_or(b',')
}
