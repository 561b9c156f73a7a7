//! Manifests: whole, or one sheet after the other.

use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;

use vibank::bank::Catalogue;
use vibank::instance::Instance;
use vibank::seed::Seed;
use vibank::solution::Solution;
use vibank::unit::DecimalMark;
use vibank::worksheet::{FORMAT, Manifest, QuestionEntry, VariantEntry};

use crate::cli::{Failure, files};

/// Longest line of a manifest: what is recorded of one sheet.
const LONGEST_LINE: u64 = 4 << 20;

/// A manifest.
pub(crate) fn manifest(path: &Path) -> Result<Manifest, Failure> {
    read(path, &files::read(path)?)
}

fn read(path: &Path, text: &str) -> Result<Manifest, Failure> {
    let manifest: Manifest =
        serde_json::from_str(text).map_err(|error| no_manifest(path, &error.to_string()))?;
    if manifest.format != FORMAT {
        return Err(Failure::new(format!(
            "`{}` has format {}, this program reads format {FORMAT}",
            path.display(),
            manifest.format
        )));
    }
    Ok(manifest)
}

fn no_manifest(path: &Path, why: &str) -> Failure {
    Failure::new(format!("`{}` is no manifest: {why}", path.display()))
        .help("give the `manifest.json` that `vibank sheet` wrote")
}

/// The sheets of a manifest, read one after the other as they are asked for.
pub(crate) struct Sheets {
    path: std::path::PathBuf,
    /// What holds for all sheets; its own list of them is empty.
    pub(crate) head: Manifest,
    rest: Rest,
}

enum Rest {
    /// Lines of the file, from the second one on.
    Lines(BufReader<File>, usize),
    /// All of them, where the file is not laid out line by line.
    All(std::vec::IntoIter<VariantEntry>),
}

impl Sheets {
    /// Opens a manifest and reads its head.
    pub(crate) fn open(path: &Path) -> Result<Self, Failure> {
        let fail = |error: std::io::Error| {
            Failure::new(format!("cannot read `{}`: {error}", path.display()))
        };
        let mut file = BufReader::new(File::open(path).map_err(fail)?);
        let mut first = String::new();
        let is_text = (&mut file).take(LONGEST_LINE).read_line(&mut first).is_ok();
        let begins_list = first.trim_end().ends_with('[');
        if is_text && begins_list {
            let head = read(path, &format!("{}]}}", first.trim_end()))?;
            return Ok(Self {
                path: path.to_owned(),
                head,
                rest: Rest::Lines(file, 1),
            });
        }
        let mut head = manifest(path)?;
        let all = std::mem::take(&mut head.variants).into_iter();
        Ok(Self {
            path: path.to_owned(),
            head,
            rest: Rest::All(all),
        })
    }

    /// The next sheets, at most so many; none at the end.
    pub(crate) fn chunk(&mut self, most: usize) -> Result<Vec<VariantEntry>, Failure> {
        let mut chunk = Vec::new();
        while chunk.len() < most {
            match self.next()? {
                Some(variant) => chunk.push(variant),
                None => break,
            }
        }
        Ok(chunk)
    }

    fn next(&mut self) -> Result<Option<VariantEntry>, Failure> {
        let (file, number) = match &mut self.rest {
            Rest::All(all) => return Ok(all.next()),
            Rest::Lines(file, number) => (file, number),
        };
        let mut line = String::new();
        *number += 1;
        let fail = |why: String| no_manifest(&self.path, &format!("line {number}: {why}"));
        file.take(LONGEST_LINE)
            .read_line(&mut line)
            .map_err(|error| fail(error.to_string()))?;
        let entry = line.trim().trim_end_matches(',');
        if entry.is_empty() {
            let why = "it ends before its end; make the sheets again";
            return Err(fail(why.to_owned()));
        }
        if entry.starts_with(']') {
            self.rest = Rest::All(Vec::new().into_iter());
            return Ok(None);
        }
        let entry = serde_json::from_str(entry).map_err(|error| fail(error.to_string()))?;
        Ok(Some(entry))
    }
}

/// The solution of a question as it was handed out.
pub(crate) fn solution<'c>(
    catalogue: &'c Catalogue,
    question: &QuestionEntry,
    decimal: char,
    accept: bool,
) -> Result<Solution<'c>, Failure> {
    let id = &question.item;
    let template = catalogue
        .find(id.as_str())
        .ok_or_else(|| Failure::new(format!("the bank has no item `{id}` any more")))?;
    if template.revision != question.revision && !accept {
        return Err(Failure::new(format!(
            "`{id}` has changed: the sheets have revision {}, the bank has {}",
            question.revision, template.revision
        ))
        .help("mark with the bank of that time, or add `--accept-revisions`"));
    }
    let known: Vec<(&str, &str)> = question
        .values
        .iter()
        .map(|(name, value)| (name.as_str(), value.as_str()))
        .filter(|(name, _)| template.parameter(name).is_some())
        .collect();
    let instance = Instance::of(template, Some(Seed::new(question.seed)), &known)
        .map_err(|error| Failure::new(error.to_string()))?;
    let mark = if decimal == ',' {
        DecimalMark::Comma
    } else {
        DecimalMark::Point
    };
    Ok(Solution::with_mark(instance, mark))
}
