//! How tables are written: plain CSV, or as the spreadsheets of a class want it.

use std::borrow::Cow;

use vibank::worksheet::Csv;

use crate::cli::Failure;

/// A way of writing CSV.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Dialect {
    csv: Csv,
    decimal: char,
}

impl Dialect {
    /// Tables of a run with this decimal sign.
    pub(crate) fn new(csv: Csv, decimal: char) -> Self {
        Self { csv, decimal }
    }

    /// What stands before the first line: a spreadsheet takes a file without a mark of byte order for one in the
    /// encoding of its system.
    pub(crate) fn mark(self) -> &'static str {
        match self.csv {
            Csv::Plain => "",
            Csv::Excel => "\u{feff}",
        }
    }

    /// A number with the decimal sign that the readers of the file use.
    pub(crate) fn number(self, number: &str) -> String {
        match self.csv {
            Csv::Excel if self.decimal == ',' => number.replace('.', ","),
            _ => number.to_owned(),
        }
    }

    /// One line of CSV.
    pub(crate) fn line(self, fields: &[&str]) -> Result<Vec<u8>, Failure> {
        let delimiter = match self.csv {
            Csv::Plain => b',',
            Csv::Excel => b';',
        };
        // A buffer of its usual eight kilobytes would be cleared for each line.
        const ROOM: usize = 512;
        let mut writer = csv::WriterBuilder::new()
            .delimiter(delimiter)
            .buffer_capacity(ROOM)
            .from_writer(Vec::new());
        writer
            .write_record(fields.iter().map(|field| guarded(field)))
            .map_err(|error| Failure::new(format!("cannot write CSV: {error}")))?;
        writer
            .into_inner()
            .map_err(|error| Failure::new(format!("cannot write CSV: {error}")))
    }

    /// A number to three decimals; nothing where there is none.
    pub(crate) fn thousandths(self, value: Option<f64>) -> String {
        value.map_or_else(String::new, |own| self.number(&format!("{own:.3}")))
    }

    /// The first line, after the mark of byte order.
    pub(crate) fn head(self, names: &[&str]) -> Result<Vec<u8>, Failure> {
        let mut head = self.mark().as_bytes().to_vec();
        head.extend(self.line(names)?);
        Ok(head)
    }
}

/// A cell that a spreadsheet would take for a formula gets an apostrophe in front, unless it is a number.
fn guarded(field: &str) -> Cow<'_, [u8]> {
    if field.starts_with(['=', '+', '-', '@', '\t', '\r'])
        && field.replacen(',', ".", 1).parse::<f64>().is_err()
    {
        format!("'{field}").into_bytes().into()
    } else {
        field.as_bytes().into()
    }
}
