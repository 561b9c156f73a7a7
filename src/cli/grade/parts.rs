//! The parts of a run that were marked apart, by `--shard`, and are joined.
//!
//! A part is what the journal of a whole run would hold of its sheets: the input in the first line, a sheet in each
//! further one, and a last line that says how many there are, by which a copy that was cut off is known.

use std::collections::VecDeque;
use std::fs::File;
use std::io::{BufRead, BufReader};

use serde::{Deserialize, Serialize};
use vibank::worksheet::VariantEntry;

use super::outcome::SheetOutcome;
use crate::cli::folder::Folder;
use crate::cli::shard::Shard;
use crate::cli::{Failure, files};

/// How the name of a part begins, and how it ends.
const NAME: (&str, &str) = ("marked", "jsonl");

/// The last line of a part.
#[derive(Serialize, Deserialize)]
pub(crate) struct PartEnd {
    /// How many sheets stand before it.
    pub(crate) end: usize,
}

/// The name of the file of a part.
pub(crate) fn name(shard: Shard) -> String {
    shard.named(NAME.0, NAME.1)
}

/// Whether a file is a part.
pub(crate) fn is_part(name: &str) -> bool {
    Shard::of_name(name, NAME.0, NAME.1).is_some()
}

/// All parts of a run, read one after the other.
pub(crate) struct Parts {
    folder: Folder,
    of: usize,
    rest: VecDeque<Shard>,
    now: Option<OpenPart>,
}

/// A part that is being read.
struct OpenPart {
    shard: Shard,
    file: BufReader<File>,
    read: usize,
}

impl Parts {
    /// The parts in a folder, which are to be whole and of the same input; nothing where there are none.
    pub(crate) fn in_folder(folder: &Folder, input: &str) -> Result<Option<Self>, Failure> {
        let names = folder.names("");
        let found: Vec<Shard> = names
            .iter()
            .filter_map(|name| Shard::of_name(name, NAME.0, NAME.1))
            .collect();
        let Some(of) = found.iter().map(|shard| shard.of()).max() else {
            return Ok(None);
        };
        let shown = folder.root().display();
        let fail =
            |what: String| Failure::new(format!("the parts in `{shown}` cannot be joined: {what}"));
        if let Some(other) = found.iter().find(|shard| shard.of() != of) {
            let message = format!(
                "{} and {} are of different runs",
                name(*other),
                name(found[0])
            );
            return Err(fail(message).help("remove the parts that are not wanted"));
        }
        let all: Vec<Shard> = Shard::all(of).collect();
        let lacking: Vec<String> = all
            .iter()
            .filter(|shard| !found.contains(shard))
            .map(ToString::to_string)
            .collect();
        if let Some(first) = lacking.first() {
            return Err(fail(format!("{} of {of} are missing: {}", lacking.len(), lacking.join(", "))).help(format!(
                "mark each by the same command with `--shard {first}` and so on, or remove `{}-*.{}` to mark all sheets here",
                NAME.0, NAME.1
            )));
        }
        for shard in &all {
            let (_, own) = open(folder, *shard)?;
            if own != input {
                return Err(fail(format!(
                    "{} was marked with another manifest, file of responses or overrides, bank, version or option",
                    name(*shard)
                ))
                .help(format!("mark it again with `--shard {shard}`")));
            }
        }
        Ok(Some(Self {
            folder: folder.clone(),
            of,
            rest: all.into(),
            now: None,
        }))
    }

    /// What came out for these sheets, which are the next ones.
    pub(crate) fn take(&mut self, sheets: &[VariantEntry]) -> Result<Vec<SheetOutcome>, Failure> {
        sheets
            .iter()
            .map(|sheet| match self.next()? {
                Some(outcome) if outcome.code == sheet.code => Ok(outcome),
                found => {
                    let found = found.map_or_else(|| "nothing".to_owned(), |found| found.code);
                    Err(self.broken(&format!(
                        "has {found} where the sheet {} belongs",
                        sheet.code
                    )))
                }
            })
            .collect()
    }

    /// All sheets are taken: nothing may be left.
    pub(crate) fn finish(mut self) -> Result<(), Failure> {
        match self.next()? {
            None => Ok(()),
            Some(outcome) => {
                Err(self.broken(&format!("has the sheet {} once too often", outcome.code)))
            }
        }
    }

    /// Removes the parts of a run that are joined.
    pub(crate) fn remove(folder: &Folder) {
        for name in folder.names("").iter().filter(|name| is_part(name)) {
            let _ = folder.remove(name);
        }
    }

    fn next(&mut self) -> Result<Option<SheetOutcome>, Failure> {
        loop {
            let part = match &mut self.now {
                Some(part) => part,
                None => {
                    let Some(shard) = self.rest.pop_front() else {
                        return Ok(None);
                    };
                    let (file, _) = open(&self.folder, shard)?;
                    self.now.insert(OpenPart {
                        shard,
                        file,
                        read: 0,
                    })
                }
            };
            let mut line = String::new();
            let length = part.file.read_line(&mut line).unwrap_or(0);
            if let Ok(outcome) = serde_json::from_str(&line) {
                part.read += 1;
                return Ok(Some(outcome));
            }
            let end = serde_json::from_str::<PartEnd>(&line).ok();
            if length == 0 || end.is_none_or(|end| end.end != part.read) {
                return Err(self.broken("is cut off, or was edited"));
            }
            self.now = None;
        }
    }

    /// What is wrong with the part that is being read.
    fn broken(&self, what: &str) -> Failure {
        let shard = self.now.as_ref().map(|part| part.shard);
        let shard = shard
            .or_else(|| Shard::all(self.of).last())
            .unwrap_or_default();
        let shown = self.folder.root().join(name(shard));
        Failure::new(format!("`{}` {what}", shown.display())).help(format!(
            "copy it again, or mark it again with `--shard {shard}`"
        ))
    }
}

/// A part, and the input that it was marked from.
fn open(folder: &Folder, shard: Shard) -> Result<(BufReader<File>, String), Failure> {
    let mut file = BufReader::new(folder.open(&name(shard))?);
    let mut input = String::new();
    let read = file.read_line(&mut input);
    read.map_err(files::unreadable(&folder.root().join(name(shard))))?;
    Ok((file, input.trim_end().to_owned()))
}
