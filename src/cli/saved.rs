//! The files of answers that pages save, `vibank form`: one of them, or a folder.
//!
//! Each has the sum of what it says. It finds out a file that was cut off or edited; it keeps nobody from making another
//! file with another sum, which is why answers that matter are collected by whoever gives the exam.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use serde::Deserialize;
use vibank::grade::{Place, Responses, Row, RowError};
use vibank::seed::Variant;

use super::{Failure, files};

/// What the files of answers are known by.
const FORMAT: &str = "vibank answers 1";

/// What a page has saved.
#[derive(Deserialize)]
struct File {
    format: String,
    code: String,
    answers: Vec<SavedAnswer>,
    sum: String,
}

#[derive(Deserialize)]
struct SavedAnswer {
    question: usize,
    part: String,
    response: String,
}

/// The answers of one or several files.
#[derive(Default)]
pub(crate) struct Saved {
    pub(crate) responses: Responses,
    /// What is wrong with single files.
    pub(crate) faults: Vec<String>,
    /// The names of the files, by the code of their sheets.
    names: BTreeMap<String, String>,
}

/// Whether a text is a file of answers, sound or not.
pub(crate) fn is_saved(text: &str) -> bool {
    text.trim_start().starts_with('{') && text.contains(FORMAT)
}

/// The answers of one file.
pub(crate) fn file(path: &Path, text: &str) -> Saved {
    let mut reading = SavedReading::default();
    reading.add(&name(path), text);
    reading.finish()
}

/// The answers of all files in a folder; those in folders below it are not looked at.
pub(crate) fn folder(path: &Path) -> Result<Saved, Failure> {
    let mut reading = SavedReading::default();
    for path in paths(path)? {
        match files::read(&path) {
            Ok(text) => reading.add(&name(&path), &text),
            Err(failure) => {
                let words = failure.to_string();
                let words = words.lines().next().unwrap_or_default();
                let words = words.trim_start_matches("error: ").to_owned();
                reading.saved.faults.push(words);
            }
        }
    }
    Ok(reading.finish())
}

/// The digest of a file of responses, or of all files in a folder.
pub(crate) fn digest(path: &Path) -> Result<String, Failure> {
    if !path.is_dir() {
        return files::digest_of(path);
    }
    let mut all = String::new();
    for path in paths(path)? {
        all.push_str(&name(&path));
        all.push_str(&files::digest_of(&path)?);
    }
    Ok(files::digest(all.as_bytes()))
}

/// The files in a folder that are not hidden, by name.
fn paths(folder: &Path) -> Result<Vec<std::path::PathBuf>, Failure> {
    let entries = std::fs::read_dir(folder).map_err(files::unreadable(folder))?;
    let mut paths = Vec::new();
    for entry in entries {
        let path = entry.map_err(files::unreadable(folder))?.path();
        // Systems leave files of their own in folders, such as `.DS_Store`.
        if path.is_file() && !name(&path).starts_with('.') {
            paths.push(path);
        }
    }
    // By name: reports and the digest must not depend on the order in which a disk lists them.
    paths.sort();
    if paths.is_empty() {
        return Err(Failure::new(format!("`{}` has no files", folder.display()))
            .help("give the folder with the files that the pages saved"));
    }
    Ok(paths)
}

fn name(path: &Path) -> String {
    path.file_name()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned()
}

#[derive(Default)]
struct SavedReading {
    saved: Saved,
    /// The answers of each sheet so far, by place.
    known: BTreeMap<String, BTreeMap<String, String>>,
    /// How many files were read, in place of lines.
    count: usize,
}

impl SavedReading {
    fn add(&mut self, name: &str, text: &str) {
        self.count += 1;
        let shown: String = name.chars().flat_map(char::escape_debug).collect();
        let file: File = match serde_json::from_str(text) {
            Ok(file) => file,
            Err(error) => {
                let what = if is_saved(text) {
                    format!("cannot be read any more: {error}")
                } else {
                    "is not a file of answers".to_owned()
                };
                return self.fault(format!("`{shown}` {what}; it was left out"));
            }
        };
        if file.format != FORMAT {
            return self.fault(format!(
                "`{shown}` has the format `{}`, this program reads `{FORMAT}`; it was left out",
                file.format.escape_debug()
            ));
        }
        let Ok(code) = file.code.parse::<Variant>() else {
            return self.fault(format!(
                "`{shown}` is of a sheet `{}`, which is not a code; it was left out",
                file.code.escape_debug()
            ));
        };
        let code = code.to_string();
        let is_sound = file.sum == files::digest(summed(&file).as_bytes());
        if !is_sound {
            self.fault(format!(
                "`{shown}` was changed after it was saved; its answers to sheet {code} are not decided"
            ));
        }
        self.compare(&shown, &code, &file);
        for answer in &file.answers {
            let row = Row {
                line: self.count,
                code: &code,
                question: &answer.question.to_string(),
                part: &answer.part,
                response: &answer.response,
            };
            if is_sound {
                let error = self.saved.responses.add(&row);
                self.saved
                    .faults
                    .extend(error.map(|error| error.to_string()));
            } else {
                self.saved.responses.add_open(&row);
            }
        }
    }

    fn fault(&mut self, words: String) {
        self.saved.faults.push(words);
    }

    /// Reports what another file of the same sheet says otherwise.
    fn compare(&mut self, shown: &str, code: &str, file: &File) {
        let known = self.known.entry(code.to_owned()).or_default();
        let mut differing = Vec::new();
        for answer in &file.answers {
            let place = format!("{}{}", answer.question, answer.part);
            let response = answer.response.trim();
            match known.get(&place) {
                Some(other) if other != response => differing.push(place),
                Some(_) => {}
                None => {
                    known.insert(place, response.to_owned());
                }
            }
        }
        let first = self.saved.names.get(code).cloned();
        match first {
            None => {
                self.saved.names.insert(code.to_owned(), shown.to_owned());
            }
            Some(first) if differing.is_empty() => {
                self.fault(format!("`{shown}` has the same answers to sheet {code} as `{first}`"));
            }
            Some(first) => self.fault(format!(
                "`{shown}` and `{first}` answer sheet {code} differently, in {}; keep the one that counts",
                differing.join(", ")
            )),
        }
    }

    fn finish(mut self) -> Saved {
        // What contradicts itself was reported by the names of the files.
        let _ = self.saved.responses.settle();
        self.saved
    }
}

/// What the sum of a file is made of.
fn summed(file: &File) -> String {
    let mut text = format!("{}\n", file.code);
    for answer in &file.answers {
        let SavedAnswer {
            question,
            part,
            response,
        } = answer;
        let _ = writeln!(text, "{question}{part}\t{response}");
    }
    text
}

impl Saved {
    /// The files of sheets that were not handed out, each reported by its name.
    pub(crate) fn foreign(
        names: &BTreeMap<String, String>,
        is_known: impl Fn(&str) -> bool,
    ) -> Vec<String> {
        let foreign = names.iter().filter(|(code, _)| !is_known(code));
        foreign
            .map(|(code, name)| format!("`{name}` is of sheet {code}, which is not in this run"))
            .collect()
    }

    /// The names of the files, by the code of their sheets.
    pub(crate) fn names(&self) -> BTreeMap<String, String> {
        self.names.clone()
    }
}

/// What is wrong with a row of a file, by its name.
pub(crate) fn said(error: &RowError, names: &BTreeMap<String, String>) -> String {
    let place: Option<&Place> = match error {
        RowError::Unknown { place, .. } | RowError::Contradiction { place, .. } => Some(place),
        RowError::Question { .. } => None,
    };
    let named = place.and_then(|place| Some((place, names.get(&place.code)?)));
    match named {
        Some((place, name)) => format!(
            "`{name}`: no part {}{} of the sheet {} was handed out",
            place.question, place.part, place.code
        ),
        None => error.to_string(),
    }
}
