//! What was typed so far: each answer is a line of a journal before the next one is asked for, and the file for `grade`
//! is made of it, whole, after each sheet.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::File;
use std::io::{BufRead, BufReader, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::cli::Failure;
use crate::cli::files::{self, Access};
use crate::cli::folder::Folder;

/// The place of an answer.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub(super) struct Place {
    pub(super) code: String,
    pub(super) question: usize,
    pub(super) part: String,
}

/// An answer, in the journal and in the file.
#[derive(Serialize, Deserialize)]
struct Entry {
    #[serde(flatten)]
    place: Place,
    response: String,
}

/// The first line of a journal.
#[derive(Serialize, Deserialize, PartialEq)]
struct Head {
    entered: u32,
}

/// As this program writes it.
const HEAD: Head = Head { entered: 1 };

/// The answers, and the journal of them; while it is open nobody else types into it.
pub(super) struct Journal {
    out: PathBuf,
    file: File,
    answers: BTreeMap<Place, String>,
}

impl Journal {
    /// Opens the journal of a file of answers.
    pub(super) fn open(out: &Path) -> Result<Self, Failure> {
        let shown = out.display();
        let Some(name) = out.file_name().and_then(|name| name.to_str()) else {
            return Err(Failure::new(format!("`{shown}` is not the name of a file")));
        };
        let folder = out.parent().filter(|folder| !folder.as_os_str().is_empty());
        let folder = Folder::at(folder.unwrap_or(Path::new(".")));
        let journal = format!(".{name}.journal");
        let fail = |error: std::io::Error| {
            Failure::new(format!(
                "cannot write the journal `{journal}` of `{shown}`: {error}"
            ))
        };
        let Some(mut file) = folder.claim(&journal)? else {
            return Err(Failure::new(format!("somebody else types into `{shown}`"))
                .help("give another file with `--out`; `vibank grade` marks each"));
        };
        let (end, answers) = match read(&file).map_err(fail)? {
            Read::Same(end, answers) => (end, answers),
            Read::Empty if folder.has(name) => {
                return Err(
                    Failure::new(format!("`{shown}` exists, and its journal does not"))
                        .help("give another file with `--out`, or move it away"),
                );
            }
            Read::Empty => (0, BTreeMap::new()),
            Read::Other => {
                return Err(
                    Failure::new(format!("`{journal}` is no journal of this program"))
                        .help("give another file with `--out`, or move the journal away"),
                );
            }
        };
        // The last line may have been cut off in the middle.
        file.set_len(end).map_err(fail)?;
        file.seek(SeekFrom::End(0)).map_err(fail)?;
        if end == 0 {
            line(&mut file, &HEAD).map_err(fail)?;
        }
        Ok(Self {
            out: out.to_owned(),
            file,
            answers,
        })
    }

    /// Keeps an answer; an empty one is no answer.
    pub(super) fn set(&mut self, place: Place, response: String) -> Result<(), Failure> {
        let entry = Entry { place, response };
        let kept = line(&mut self.file, &entry).and_then(|()| self.file.sync_data());
        kept.map_err(|error| Failure::new(format!("the answer could not be kept: {error}")))?;
        self.answers.insert(entry.place, entry.response);
        Ok(())
    }

    /// The answer at a place.
    pub(super) fn get(&self, place: &Place) -> Option<&str> {
        let answer = self.answers.get(place).map(String::as_str);
        answer.filter(|answer| !answer.is_empty())
    }

    /// How many answers a sheet has.
    pub(super) fn of(&self, code: &str) -> usize {
        self.given().filter(|(place, _)| place.code == code).count()
    }

    /// How many sheets have answers.
    pub(super) fn sheets(&self) -> usize {
        let codes: BTreeSet<&str> = self.given().map(|(place, _)| place.code.as_str()).collect();
        codes.len()
    }

    fn given(&self) -> impl Iterator<Item = (&Place, &String)> {
        self.answers.iter().filter(|(_, answer)| !answer.is_empty())
    }

    /// Writes the file of answers, an object a line.
    pub(super) fn write(&self) -> Result<(), Failure> {
        let lines: Vec<String> = self
            .given()
            .map(|(place, response)| {
                let entry = Entry {
                    place: place.clone(),
                    response: response.clone(),
                };
                serde_json::to_string(&entry).expect("an answer is plain data")
            })
            .collect();
        let text = format!("[\n{}\n]\n", lines.join(",\n"));
        files::write(&self.out, text.as_bytes(), Access::Private)
    }
}

fn line(file: &mut File, value: &impl Serialize) -> std::io::Result<()> {
    let mut line = serde_json::to_vec(value)?;
    line.push(b'\n');
    // In one piece, so that a line is there or is cut off.
    file.write_all(&line)
}

/// What a journal holds.
enum Read {
    Empty,
    /// It is no journal.
    Other,
    /// Up to where it is sound, and its answers.
    Same(u64, BTreeMap<Place, String>),
}

fn read(mut file: &File) -> std::io::Result<Read> {
    file.seek(SeekFrom::Start(0))?;
    let mut reader = BufReader::new(file);
    let mut line = Vec::new();
    let mut end = reader.read_until(b'\n', &mut line)?;
    if !line.ends_with(b"\n") {
        return Ok(Read::Empty);
    }
    if !serde_json::from_slice::<Head>(&line).is_ok_and(|own| own == HEAD) {
        return Ok(Read::Other);
    }
    let mut answers = BTreeMap::new();
    loop {
        line.clear();
        let length = reader.read_until(b'\n', &mut line)?;
        let entry = serde_json::from_slice::<Entry>(&line);
        match entry {
            Ok(entry) if line.ends_with(b"\n") => {
                answers.insert(entry.place, entry.response);
                end += length;
            }
            _ => return Ok(Read::Same(end as u64, answers)),
        }
    }
}
