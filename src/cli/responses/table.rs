//! Response files as tables: CSV as spreadsheets and people write it.

use std::path::Path;

use csv::{ByteRecord, Reader, ReaderBuilder};
use vibank::seed::Variant;

use super::{Layout, Reading};
use crate::cli::Failure;

/// The rows of a table and where they stand in its file.
struct Rows<'a> {
    bytes: &'a [u8],
    delimiter: u8,
    /// Columns of the header.
    width: usize,
    layout: Layout,
    lines: Lines<'a>,
}

/// Counts the lines of a file up to its rows, one after the other.
pub(crate) struct Lines<'a> {
    bytes: &'a [u8],
    byte: usize,
    line: usize,
}

impl<'a> Lines<'a> {
    pub(crate) fn of(bytes: &'a [u8]) -> Self {
        Self {
            bytes,
            byte: 0,
            line: 1,
        }
    }

    /// Where the row begins that is read from a byte on, behind ends of lines, and its line, from 1.
    pub(crate) fn of_row(&mut self, from: usize) -> (usize, usize) {
        let rest = &self.bytes[from..];
        let begin = from + count_while(rest, |byte| b"\r\n".contains(&byte));
        self.line += lines(&self.bytes[self.byte..begin]);
        self.byte = begin;
        (begin, self.line)
    }
}

impl Reading {
    pub(super) fn csv(&mut self, path: &Path, bytes: &[u8]) -> Result<(), Failure> {
        let failure = |words: &str| Failure::new(format!("`{}` {words}", path.display()));
        if [b"\xff\xfe", b"\xfe\xff"]
            .iter()
            .any(|mark| bytes.starts_with(*mark))
        {
            return Err(failure("is UTF-16").help("save it as CSV in UTF-8"));
        }
        let broken = |error: csv::Error| failure(&format!("is no CSV: {error}"));
        let (start, delimiter) = named_delimiter(bytes).unwrap_or((0, delimiter(bytes)));
        let mut header = reader(&bytes[start..], delimiter);
        let mut names = ByteRecord::new();
        header.read_byte_record(&mut names).map_err(broken)?;
        let names: Vec<String> = names
            .iter()
            .map(|name| String::from_utf8_lossy(name).trim().to_lowercase())
            .collect();
        let layout = Layout::of(&names).ok_or_else(|| {
            failure("has no columns of responses")
                .help("the header needs `code`, `question`, `part`, `response`, or `code` and one column a part (`1a`, `1b`)")
        })?;
        let mut from = start + header.position().byte() as usize;
        let mut rows = Rows {
            bytes,
            delimiter,
            width: names.len(),
            layout,
            lines: Lines::of(bytes),
        };
        while from < bytes.len() {
            from = rows.read(from, self).map_err(broken)?;
        }
        Ok(())
    }
}

impl Rows<'_> {
    /// Reads rows up to the end, or up to behind a line whose quote is not closed.
    fn read(&mut self, from: usize, into: &mut Reading) -> Result<usize, csv::Error> {
        let mut reader = reader(&self.bytes[from..], self.delimiter);
        let mut record = ByteRecord::new();
        let mut end = from;
        while reader.read_byte_record(&mut record)? {
            let (begin, line) = self.lines.of_row(end);
            end = from + reader.position().byte() as usize;
            if self.is_open(&self.bytes[begin..end], end) {
                into.faults.push(format!(
                    "line {line}: a quote is not closed; this line was left out"
                ));
                return Ok(begin + count_while(&self.bytes[begin..], |byte| byte != b'\n'));
            }
            self.row(line, &record, into);
        }
        Ok(self.bytes.len())
    }

    fn row(&self, line: usize, record: &ByteRecord, into: &mut Reading) {
        let is_blank = |cell: &[u8]| cell.trim_ascii().is_empty();
        if record.iter().all(is_blank) {
            return;
        }
        if !record.iter().skip(self.width).all(is_blank) {
            into.faults.push(format!(
                "line {line}: more cells than the header has; put an answer with `{}` in it in quotes; this line was left out",
                char::from(self.delimiter)
            ));
            return;
        }
        let cells = record.iter().map(std::str::from_utf8);
        match cells.collect::<Result<Vec<_>, _>>() {
            Ok(cells) => self.layout.rows(line, &cells, &mut |row| into.add(row)),
            Err(_) => into
                .faults
                .push(format!("line {line}: not UTF-8; save the file as UTF-8")),
        }
    }

    /// Whether a row has a quote that was not closed: it runs to the end of the file, on and on, or over another row.
    fn is_open(&self, row: &[u8], end: usize) -> bool {
        const MOST_LINES: usize = 60;
        let count = lines(row);
        if count == 0 {
            return false;
        }
        let is_odd = || row.iter().filter(|byte| **byte == b'"').count() % 2 == 1;
        let mut inner = row.split(|byte| *byte == b'\n').skip(1);
        count > MOST_LINES
            || end == self.bytes.len() && count > 1 && is_odd()
            || inner.any(|line| self.has_code(line))
    }

    /// Whether a line has the code of a sheet where codes stand.
    fn has_code(&self, line: &[u8]) -> bool {
        let mut record = ByteRecord::new();
        let is_read = reader(line, self.delimiter).read_byte_record(&mut record);
        let cell = record.get(self.layout.code()).unwrap_or_default();
        let code = std::str::from_utf8(cell).map(|code| code.trim().parse::<Variant>());
        is_read.is_ok() && record.len() > 1 && matches!(code, Ok(Ok(_)))
    }
}

fn reader(bytes: &[u8], delimiter: u8) -> Reader<&[u8]> {
    ReaderBuilder::new()
        .delimiter(delimiter)
        .flexible(true)
        .has_headers(false)
        .from_reader(bytes)
}

fn lines(bytes: &[u8]) -> usize {
    bytes.iter().filter(|byte| **byte == b'\n').count()
}

fn count_while(bytes: &[u8], is_so: impl Fn(u8) -> bool) -> usize {
    bytes.iter().take_while(|byte| is_so(**byte)).count()
}

/// The delimiter that a first line `sep=;` names for a spreadsheet, and where the table begins.
fn named_delimiter(bytes: &[u8]) -> Option<(usize, u8)> {
    let end = count_while(bytes, |byte| byte != b'\n');
    let line = bytes[..end].trim_ascii();
    match line.split_at_checked(4)? {
        (word, [delimiter]) if word.eq_ignore_ascii_case(b"sep=") => Some((end, *delimiter)),
        _ => None,
    }
}

/// Spreadsheets write semicolons where the comma is the decimal sign.
pub(crate) fn delimiter(bytes: &[u8]) -> u8 {
    let header = &bytes[..count_while(bytes, |byte| byte != b'\n')];
    let count = |sign: u8| header.iter().filter(|byte| **byte == sign).count();
    [b',', b';', b'\t']
        .into_iter()
        .max_by_key(|sign| (count(*sign), *sign == b','))
        .unwrap_or(b',')
}
