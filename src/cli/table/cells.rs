//! The cells of a text table, one row after the other, with what is wrong in a row and its line.
//!
//! The `csv` crate reads anything as something: a quote that is not closed takes the rest of the file for one cell.

use std::borrow::Cow;

/// A row of a table: where it begins, and its cells without the blanks around them.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct TableRow<'t> {
    pub(crate) line: usize,
    pub(crate) cells: Vec<Cow<'t, str>>,
}

impl TableRow<'_> {
    /// A cell; empty where the row has no more.
    pub(crate) fn cell(&self, at: usize) -> &str {
        self.cells.get(at).map_or("", |cell| &**cell)
    }

    /// The number of cells up to the last one that is not empty.
    pub(crate) fn width(&self) -> usize {
        let filled = self.cells.iter().rposition(|cell| !cell.is_empty());
        filled.map_or(0, |last| last + 1)
    }
}

/// What is wrong with a row.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub(crate) enum RowFault {
    /// A quote that is not closed, or that swallows a row.
    #[error("line {line}: a quote is not closed")]
    Open {
        /// Line in the file, from 1.
        line: usize,
    },
    /// Something after the quote that closes a cell.
    #[error(
        "line {line}: `{found}` comes after the quote that closes a cell; a quote inside of a cell is written twice"
    )]
    Behind {
        /// Line in the file, from 1.
        line: usize,
        /// What stands there.
        found: String,
    },
    /// A cell of a workbook in a column without a heading.
    #[error("row {line}: a cell in a column without a heading; give the column one, or empty it")]
    Unheaded {
        /// Row of the sheet, from 1.
        line: usize,
    },
    /// A cell of a text in a column whose heading is empty.
    #[error("line {line}: column {column} has no heading; give it one, or empty it")]
    Nameless {
        /// Line in the file, from 1.
        line: usize,
        /// The column, from 1.
        column: usize,
    },
    /// More cells than headings.
    #[error(
        "line {line}: more cells than the header has; put a cell with `{delimiter}` in it in quotes"
    )]
    Wide {
        /// Line in the file, from 1.
        line: usize,
        /// The character between two cells: comma, semicolon or tab.
        delimiter: char,
    },
}

/// A row that cannot be read: what is wrong, and its first line cut at each delimiter, which may tell whose it is.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{fault}")]
pub(crate) struct Broken<'t> {
    pub(crate) fault: RowFault,
    pub(crate) row: TableRow<'t>,
}

/// A place in a text table.
#[derive(Clone)]
pub(crate) struct Cursor<'t> {
    text: &'t str,
    at: usize,
    /// The line of `at`, from 1.
    line: usize,
    delimiter: u8,
}

/// Most lines of one row: whoever writes more has forgotten a quote. It also bounds what is read twice.
const MAX_LINES: usize = 100;

impl<'t> Cursor<'t> {
    pub(crate) fn new(text: &'t str, delimiter: u8) -> Self {
        Self {
            text,
            at: 0,
            line: 1,
            delimiter,
        }
    }

    /// The byte that is read next.
    pub(crate) fn at(&self) -> usize {
        self.at
    }

    /// Reads the next row, if there is one; after a row with a fault, reading goes on in the next line.
    ///
    /// `begins_row` says whether cells look like those of a row of their own: a quoted cell that has such a line in it
    /// was not closed.
    pub(crate) fn row(
        &mut self,
        begins_row: &dyn Fn(&TableRow<'_>) -> bool,
    ) -> Option<Result<TableRow<'t>, Broken<'t>>> {
        if self.at >= self.text.len() {
            return None;
        }
        let (start, line) = (self.at, self.line);
        let mut cells = Vec::new();
        let read = loop {
            match self.cell(line) {
                Ok(cell) => cells.push(cell),
                Err(fault) => break Err(fault),
            }
            if self.peek() != Some(self.delimiter) {
                self.end_of_line();
                break Ok(());
            }
            self.at += 1;
        };
        let swallows = |text: &str| {
            let mut inner = Cursor::new(text, self.delimiter);
            inner.end_of_row();
            inner.swallows(begins_row)
        };
        let read = match read {
            Ok(()) if self.line > line + 1 && swallows(&self.text[start..self.at]) => {
                Err(RowFault::Open { line })
            }
            other => other,
        };
        Some(match read {
            Ok(()) => Ok(TableRow { line, cells }),
            Err(fault) => {
                (self.at, self.line) = (start, line);
                self.end_of_row();
                let cells = self.pieces(&self.text[start..self.at]);
                let row = TableRow { line, cells };
                Err(Broken { fault, row })
            }
        })
    }

    /// A line cut at each delimiter, whatever its quotes are.
    fn pieces(&self, line: &'t str) -> Vec<Cow<'t, str>> {
        line.split(char::from(self.delimiter))
            .map(|cell| Cow::Borrowed(cell.trim().trim_matches('"').trim()))
            .collect()
    }

    /// Whether one of the lines that follow is a row.
    fn swallows(&mut self, begins_row: &dyn Fn(&TableRow<'_>) -> bool) -> bool {
        while self.at < self.text.len() {
            let rest = &self.text[self.at..];
            let length = rest.find(['\n', '\r']).unwrap_or(rest.len());
            // A line on its own: quotes that it leaves open end with it.
            let mut own = Cursor::new(&rest[..length], self.delimiter);
            if let Some(Ok(row)) = own.row(&|_| false)
                && begins_row(&row)
            {
                return true;
            }
            self.end_of_row();
        }
        false
    }

    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    /// Reads a cell, of a row that begins in line `first`, up to the delimiter or the end of its line.
    fn cell(&mut self, first: usize) -> Result<Cow<'t, str>, RowFault> {
        self.blanks();
        if self.peek() == Some(b'"') {
            return self.quoted(first);
        }
        let rest = &self.text[self.at..];
        let length = rest
            .bytes()
            .position(|byte| byte == self.delimiter || matches!(byte, b'\n' | b'\r'))
            .unwrap_or(rest.len());
        self.at += length;
        Ok(Cow::Borrowed(rest[..length].trim()))
    }

    fn quoted(&mut self, first: usize) -> Result<Cow<'t, str>, RowFault> {
        let line = self.line;
        let mut words = String::new();
        self.at += 1;
        loop {
            let rest = &self.text[self.at..];
            let Some(length) = rest.find(['"', '\n', '\r']) else {
                return Err(RowFault::Open { line });
            };
            words.push_str(&rest[..length]);
            self.at += length;
            if self.peek() != Some(b'"') {
                words.push('\n');
                self.end_of_line();
                if self.line - first > MAX_LINES {
                    return Err(RowFault::Open { line: first });
                }
                continue;
            }
            self.at += 1;
            if self.peek() != Some(b'"') {
                break;
            }
            words.push('"');
            self.at += 1;
        }
        self.blanks();
        match self.peek() {
            None | Some(b'\n' | b'\r') => {}
            Some(byte) if byte == self.delimiter => {}
            Some(_) if self.line > line => return Err(RowFault::Open { line }),
            Some(_) => {
                let rest = self.text[self.at..].lines().next().unwrap_or_default();
                let found = rest.chars().take(20).collect();
                return Err(RowFault::Behind { line, found });
            }
        }
        Ok(match words.trim() {
            trimmed if trimmed.len() == words.len() => Cow::Owned(words),
            trimmed => Cow::Owned(trimmed.to_owned()),
        })
    }

    fn blanks(&mut self) {
        while self
            .peek()
            .is_some_and(|byte| byte == b' ' || byte == b'\t' && self.delimiter != b'\t')
        {
            self.at += 1;
        }
    }

    /// Skips one end of a line.
    fn end_of_line(&mut self) {
        let rest = &self.text.as_bytes()[self.at..];
        self.at += match rest {
            [b'\r', b'\n', ..] => 2,
            [b'\r' | b'\n', ..] => 1,
            _ => return,
        };
        self.line += 1;
    }

    /// Skips up to after the end of the line.
    fn end_of_row(&mut self) {
        let rest = &self.text[self.at..];
        self.at += rest.find(['\n', '\r']).unwrap_or(rest.len());
        self.end_of_line();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows with their lines, cells between bars; faults as they are reported.
    fn rows(text: &str) -> Vec<String> {
        let mut cursor = Cursor::new(text, b',');
        let begins_row = |row: &TableRow<'_>| row.cells.len() == 3;
        std::iter::from_fn(|| cursor.row(&begins_row))
            .map(|row| match row {
                Ok(row) => format!("{} {}", row.line, row.cells.join("|")),
                Err(fault) => fault.to_string(),
            })
            .collect()
    }

    #[test]
    fn cells_lose_their_quotes_and_the_blanks_around_them() {
        let text = "a, b ,c\r\n\"x, \"\"y\"\"\" , \"z\nw\",5\" long\r1,,\n\n,last";
        let read = [
            "1 a|b|c",
            "2 x, \"y\"|z\nw|5\" long",
            "4 1||",
            "5 ",
            "6 |last",
        ];
        assert_eq!(rows(text), read);
    }

    #[test]
    fn a_quote_that_is_not_closed_costs_one_line() {
        let open = "line 2: a quote is not closed";
        let text = "1,a,b\n2,\"c,d\n3,e,f\n4,g,h\n";
        assert_eq!(rows(text), ["1 1|a|b", open, "3 3|e|f", "4 4|g|h"]);
        // Closed by a later one, with or without something after.
        let text = "1,a,b\n2,\"c,d\n3,\"e,f\n4,g,h\n";
        let also = "line 3: a quote is not closed";
        assert_eq!(rows(text), ["1 1|a|b", open, also, "4 4|g|h"]);
        let text = "1,a,b\n2,\"c,d\n3,e\",f\n4,g,h\n";
        let read = rows(text);
        assert_eq!(read[1..2], [open]);
        assert_eq!(read[3], "4 4|g|h");
        let long = format!("1,\"{}\",2\n", "\n".repeat(101));
        assert_eq!(rows(&long)[0], "line 1: a quote is not closed");
    }

    #[test]
    fn words_behind_a_closing_quote_are_a_fault() {
        let read = rows("1,\"5\" pipe\",b\n2,c,d\n");
        assert!(
            read[0].starts_with("line 1: `pipe\",b` comes after"),
            "{read:?}"
        );
        assert_eq!(read[1], "2 2|c|d");
    }

    #[test]
    fn no_row_is_longer_than_a_hundred_lines() {
        // From each line on, the rest would be one row that swallows the last one.
        let text = format!(
            "{}
1,2,3
\"
",
            "x\",\"
"
            .repeat(500)
        );
        let read = rows(&text);
        assert_eq!(read[0], "line 1: a quote is not closed");
        assert_eq!(read.len(), text.lines().count());
    }
}
