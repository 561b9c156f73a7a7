//! What was typed so far: each answer is a line of a journal before the next one is asked for, and the file for `grade`
//! is made of it, whole, after each sheet.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::cli::Failure;
use crate::cli::files::{self, Access};
use crate::cli::folder::Folder;
use crate::cli::journal_file::JournalFile;

/// The place of an answer.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub(crate) struct Place {
    pub(crate) code: String,
    pub(crate) question: usize,
    pub(crate) part: String,
}

/// An answer, in the journal and in the file.
#[derive(Serialize, Deserialize)]
struct JournalEntry {
    #[serde(flatten)]
    place: Place,
    response: String,
}

/// The first line of a journal, as this program writes it.
const HEAD: &str = r#"{"entered":1}"#;

/// The answers, and the journal of them; while it is open nobody else types into it.
pub(crate) struct Journal {
    out: PathBuf,
    file: JournalFile,
    answers: BTreeMap<Place, String>,
}

impl Journal {
    /// Opens the journal of a file of answers.
    pub(crate) fn open(out: &Path) -> Result<Self, Failure> {
        let shown = out.display();
        let Some(name) = out.file_name().and_then(|name| name.to_str()) else {
            return Err(Failure::new(format!("`{shown}` is not the name of a file")));
        };
        let folder = out.parent().filter(|folder| !folder.as_os_str().is_empty());
        let folder = Folder::at(folder.unwrap_or(Path::new(".")));
        let journal = format!(".{name}.journal");
        let Some(mut file) = JournalFile::claim(&folder, journal.clone())? else {
            return Err(Failure::new(format!("somebody else types into `{shown}`"))
                .help("give another file with `--out`; `vibank grade` marks each"));
        };
        let mut answers = BTreeMap::new();
        match file.head()? {
            Some(head) if head == HEAD => {
                file.go_on(|line| match serde_json::from_str::<JournalEntry>(line) {
                    Ok(entry) => {
                        answers.insert(entry.place, entry.response);
                        true
                    }
                    Err(_) => false,
                })?;
            }
            Some(_) => {
                return Err(
                    Failure::new(format!("`{journal}` is not a journal of this program"))
                        .help("give another file with `--out`, or move the journal away"),
                );
            }
            None if folder.has(name) => {
                return Err(
                    Failure::new(format!("`{shown}` exists, and its journal does not"))
                        .help("give another file with `--out`, or move it away"),
                );
            }
            None => file.begin(HEAD)?,
        }
        Ok(Self {
            out: out.to_owned(),
            file,
            answers,
        })
    }

    /// Keeps an answer; an empty one is no answer.
    pub(crate) fn set(&mut self, place: Place, response: String) -> Result<(), Failure> {
        let entry = JournalEntry { place, response };
        self.file.add(std::slice::from_ref(&entry))?;
        self.file.sync()?;
        self.answers.insert(entry.place, entry.response);
        Ok(())
    }

    /// The answer at a place.
    pub(crate) fn get(&self, place: &Place) -> Option<&str> {
        let answer = self.answers.get(place).map(String::as_str);
        answer.filter(|answer| !answer.is_empty())
    }

    /// How many answers a sheet has.
    pub(crate) fn of(&self, code: &str) -> usize {
        self.given().filter(|(place, _)| place.code == code).count()
    }

    /// How many sheets have answers.
    pub(crate) fn sheets(&self) -> usize {
        let codes: BTreeSet<&str> = self.given().map(|(place, _)| place.code.as_str()).collect();
        codes.len()
    }

    fn given(&self) -> impl Iterator<Item = (&Place, &String)> {
        self.answers.iter().filter(|(_, answer)| !answer.is_empty())
    }

    /// Writes the file of answers, an object a line.
    pub(crate) fn write(&self) -> Result<(), Failure> {
        let lines: Vec<String> = self
            .given()
            .map(|(place, response)| {
                let entry = JournalEntry {
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
