//! `vibank-scan`, the program that reads the marks: it alone carries readers of images.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use rayon::prelude::*;
use vibank::worksheet::ScanMark;

use crate::cli::Failure;
use crate::cli::program::{self, Found};

/// The program.
const NAME: &str = "vibank-scan";

/// Names it; empty, there is none.
const VARIABLE: &str = "VIBANK_SCAN";

/// Files for one process.
const FILES: usize = 16;

/// What was read from a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Reading {
    /// Which page of which sheet it is.
    Mark(ScanMark),
    /// No mark was found.
    None,
    /// It cannot be read, and why.
    Unreadable(String),
}

/// A reader of scans, ready to work.
pub(crate) struct Reader {
    program: PathBuf,
}

impl Reader {
    /// The reader of this machine.
    pub(crate) fn find() -> Result<Self, Failure> {
        let found = program::find(NAME, VARIABLE).ok_or_else(|| {
            let message = format!("there is no `{NAME}` here, which reads scans");
            Failure::new(message).help(Self::WAY_OUT)
        })?;
        let is_foreign = matches!(found, Found::OnPath(_));
        let (Found::Own(program) | Found::OnPath(program)) = found;
        let reader = Self { program };
        // Without files it says its version alone.
        let (greeting, _) = reader.answers(&[])?;
        let version = env!("CARGO_PKG_VERSION");
        if greeting != format!("{NAME} {version}") {
            return Err(reader.unusable(&format!("it is not that of version {version}")));
        }
        if is_foreign {
            eprintln!("reading with `{}`", reader.program.display());
        }
        Ok(reader)
    }

    /// How to come to a reader.
    const WAY_OUT: &'static str = "build it by `cargo build --release -p vibank-scan` or take it from the release of this version, and keep it beside `vibank` or name it in VIBANK_SCAN";

    /// What is read from files, in their order.
    pub(crate) fn read(&self, files: &[PathBuf]) -> Result<Vec<Reading>, Failure> {
        let chunks = files.par_chunks(FILES).map(|chunk| self.chunk(chunk));
        let read: Vec<Vec<Reading>> = chunks.collect::<Result<_, _>>()?;
        Ok(read.into_iter().flatten().collect())
    }

    /// A process that ends early has failed on the first file that it says nothing of; another one goes on after it.
    fn chunk(&self, files: &[PathBuf]) -> Result<Vec<Reading>, Failure> {
        let mut read = Vec::new();
        while read.len() < files.len() {
            let rest = &files[read.len()..];
            let (_, answers) = self.answers(rest)?;
            let is_whole = answers.len() == rest.len();
            read.extend(answers);
            if !is_whole {
                read.push(Reading::Unreadable("its reader failed".to_owned()));
            }
        }
        Ok(read)
    }

    /// What the program says of itself and of files, of which it may leave out the last ones.
    fn answers(&self, files: &[PathBuf]) -> Result<(String, Vec<Reading>), Failure> {
        let run = Command::new(&self.program)
            .args(files.iter().map(|file| absolute(file)))
            .stdin(Stdio::null())
            .stderr(Stdio::null())
            .output()
            .map_err(|error| self.unusable(&error.to_string()))?;
        let said = String::from_utf8_lossy(&run.stdout);
        let mut lines = said.lines();
        let greeting = lines.next().unwrap_or_default().to_owned();
        let answers = lines.take(files.len()).enumerate();
        let answers = answers.map_while(|(number, line)| {
            let (place, answer) = line.split_once(' ')?;
            (place.parse() == Ok(number)).then(|| reading(answer))?
        });
        Ok((greeting, answers.collect()))
    }

    fn unusable(&self, why: &str) -> Failure {
        let shown = self.program.display();
        Failure::new(format!("`{shown}` cannot be used to read scans: {why}")).help(Self::WAY_OUT)
    }
}

/// The path with which no file is taken for anything else, wherever the program is started.
fn absolute(file: &Path) -> PathBuf {
    std::path::absolute(file).unwrap_or_else(|_| file.to_owned())
}

/// What the program says of a file.
fn reading(answer: &str) -> Option<Reading> {
    match answer.split_once(' ').unwrap_or((answer, "")) {
        ("none", "") => Some(Reading::None),
        ("unreadable", why) => Some(Reading::Unreadable(why.to_owned())),
        ("mark", digits) => {
            let pairs = digits.as_bytes().chunks(2);
            let bytes: Option<Vec<u8>> = pairs
                .map(|pair| {
                    let pair = std::str::from_utf8(pair).ok()?;
                    u8::from_str_radix(pair, 16).ok()
                })
                .collect();
            // A code with other bytes is none of ours.
            Some(ScanMark::read(&bytes?).map_or(Reading::None, Reading::Mark))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use vibank::seed::Variant;

    use super::*;

    #[test]
    fn answers_of_the_reader_are_read() {
        let mark = ScanMark {
            variant: Variant::new(0x12_3456_789a).expect("it is below 2⁴⁰"),
            page: 3,
            is_last: true,
        };
        let digits: String = mark
            .bytes()
            .iter()
            .map(|byte| format!("{byte:02x}"))
            .collect();
        let said = format!("mark {digits}");
        assert_eq!(reading(&said), Some(Reading::Mark(mark)));
        assert_eq!(reading("mark 0011"), Some(Reading::None));
        assert_eq!(reading("mark xyz"), None);
        assert_eq!(reading("none"), Some(Reading::None));
        let why = Reading::Unreadable("it is too large".to_owned());
        assert_eq!(reading("unreadable it is too large"), Some(why));
        assert_eq!(reading("hello"), None);
    }
}
