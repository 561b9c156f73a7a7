//! Manifests: whole, or one sheet after the other.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};

use serde::Deserialize;
use vibank::answer::{Credit, Doubt};
use vibank::bank::Template;
use vibank::instance::Instance;
use vibank::seed::Seed;
use vibank::solution::Solution;
use vibank::unit::DecimalMark;
use vibank::worksheet::{FORMAT, Manifest, QuestionEntry, VariantEntry};

use super::items::Items;
use crate::cli::file_kind::not_a_manifest;
use crate::cli::folder::Folder;
use crate::cli::sheet::MANIFESTS;
use crate::cli::{Failure, files};

/// Longest line of a manifest: what is recorded of one sheet.
const MAX_LINE_LENGTH: u64 = 4 << 20;
/// Longest foot of a manifest: the items that were used.
const MAX_FOOT_LENGTH: u64 = 64 << 20;

/// Reads the manifest that a run of `sheet` wrote.
pub(crate) fn manifest(path: &Path) -> Result<Manifest, Failure> {
    read(path, &files::read(path)?)
}

fn read(path: &Path, text: &str) -> Result<Manifest, Failure> {
    let manifest: Manifest =
        serde_json::from_str(text).map_err(|error| not_a_manifest(path, &error.to_string()))?;
    if manifest.format != FORMAT {
        return Err(Failure::new(format!(
            "`{}` has format {}, this program reads format {FORMAT}",
            path.display(),
            manifest.format
        )));
    }
    for entry in &manifest.variants {
        let checked = entry.check();
        checked.map_err(|error| not_a_manifest(path, &error.to_string()))?;
    }
    Ok(manifest)
}

/// The sheets of a manifest, read one after the other as they are asked for.
pub(crate) struct Sheets {
    path: PathBuf,
    /// What holds for all sheets of the manifest; its own list of them is empty.
    pub(crate) head: Manifest,
    /// The decimal sign of the sheets that were read last.
    pub(crate) decimal: char,
    /// What becomes of answers with two readings on the sheets that were read last.
    pub(crate) doubt: Doubt,
    /// What an answer in another form is worth on them.
    pub(crate) other_form: Option<Credit>,
    /// The items of the manifests that were read to their ends.
    pub(crate) items: Vec<BTreeMap<String, String>>,
    rest: Rest,
    /// Manifests of earlier runs in the same folder.
    earlier: Vec<PathBuf>,
    /// The sheets of earlier runs that are asked for: not yet printed anew, and answered.
    wanted: BTreeSet<String>,
    is_first: bool,
}

enum Rest {
    /// Lines of the file, from the second one on.
    Lines(BufReader<File>, usize),
    /// All of them, where the file is not laid out line by line.
    All(std::vec::IntoIter<VariantEntry>),
}

impl Sheets {
    /// Opens a manifest, and after it those of earlier runs beside it, of which the sheets with the codes `wanted` count.
    pub(crate) fn open(path: &Path, wanted: &BTreeSet<&str>) -> Result<Self, Failure> {
        let folder = Folder::at(path.parent().unwrap_or(Path::new("")));
        let earlier = folder.names(MANIFESTS).into_iter();
        let earlier = earlier
            .filter(|name| name.ends_with(".json"))
            .map(|name| folder.path(&format!("{MANIFESTS}/{name}")));
        let mut sheets = Self::of_file(path)?;
        sheets.earlier = earlier.collect::<Result<_, _>>()?;
        sheets.earlier.reverse();
        sheets.wanted = wanted.iter().map(|code| (*code).to_owned()).collect();
        Ok(sheets)
    }

    /// Attempts as sheets, under the head of a manifest that does not list them.
    pub(crate) fn of_attempts(path: &Path, head: &Manifest, attempts: Vec<VariantEntry>) -> Self {
        let mut head = head.clone();
        head.variants.clear();
        Self {
            path: path.to_owned(),
            decimal: head.decimal,
            doubt: head.doubt,
            other_form: share(&head),
            items: vec![std::mem::take(&mut head.items)],
            head,
            rest: Rest::All(attempts.into_iter()),
            earlier: Vec::new(),
            wanted: BTreeSet::new(),
            is_first: true,
        }
    }

    /// The manifests of earlier runs that are read after the first one.
    pub(crate) fn earlier(&self) -> &[PathBuf] {
        &self.earlier
    }

    fn of_file(path: &Path) -> Result<Self, Failure> {
        let of = |mut head: Manifest, rest: Rest| Self {
            path: path.to_owned(),
            decimal: head.decimal,
            doubt: head.doubt,
            other_form: share(&head),
            items: match &rest {
                Rest::Lines(..) => Vec::new(),
                Rest::All(_) => vec![std::mem::take(&mut head.items)],
            },
            head,
            rest,
            earlier: Vec::new(),
            wanted: BTreeSet::new(),
            is_first: true,
        };
        let mut file = BufReader::new(files::open(path)?);
        let mut first = String::new();
        let is_text = (&mut file)
            .take(MAX_LINE_LENGTH)
            .read_line(&mut first)
            .is_ok();
        let begins_list = first.trim_end().ends_with('[');
        if is_text && begins_list {
            let head = read(path, &format!("{}]}}", first.trim_end()))?;
            return Ok(of(head, Rest::Lines(file, 1)));
        }
        let mut head = manifest(path)?;
        let all = std::mem::take(&mut head.variants).into_iter();
        Ok(of(head, Rest::All(all)))
    }

    /// The next sheets, at most this many and all of one manifest; none at the end.
    pub(crate) fn chunk(&mut self, most: usize) -> Result<Vec<VariantEntry>, Failure> {
        let mut chunk = Vec::new();
        while chunk.len() < most {
            match self.next()? {
                Some(variant) => {
                    let is_wanted = self.wanted.remove(&variant.code);
                    if self.is_first || is_wanted {
                        chunk.push(variant);
                    }
                }
                None if !chunk.is_empty() => break,
                None => match self.earlier.pop() {
                    Some(path) => self.go_on(&path)?,
                    None => break,
                },
            }
        }
        Ok(chunk)
    }

    /// Goes on with another manifest.
    fn go_on(&mut self, path: &Path) -> Result<(), Failure> {
        let next = Self::of_file(path)?;
        self.items.extend(next.items);
        (self.path, self.rest) = (next.path, next.rest);
        (self.decimal, self.doubt) = (next.decimal, next.doubt);
        self.other_form = next.other_form;
        self.is_first = false;
        Ok(())
    }

    fn next(&mut self) -> Result<Option<VariantEntry>, Failure> {
        let (file, number) = match &mut self.rest {
            Rest::All(all) => return Ok(all.next()),
            Rest::Lines(file, number) => (file, number),
        };
        let mut line = String::new();
        *number += 1;
        let fail = |why: String| not_a_manifest(&self.path, &format!("line {number}: {why}"));
        file.take(MAX_LINE_LENGTH)
            .read_line(&mut line)
            .map_err(|error| fail(error.to_string()))?;
        let entry = line.trim().trim_end_matches(',');
        if entry.is_empty() {
            let why = "it ends before its end; make the sheets again";
            return Err(fail(why.to_owned()));
        }
        if let Some(begun) = entry.strip_prefix(']') {
            let mut foot = begun.trim_start_matches(',').to_owned();
            let rest = file.take(MAX_FOOT_LENGTH).read_to_string(&mut foot);
            rest.map_err(|error| fail(error.to_string()))?;
            let foot: Foot = serde_json::from_str(&format!("{{{foot}"))
                .map_err(|error| fail(error.to_string()))?;
            self.items.push(foot.items);
            self.rest = Rest::All(Vec::new().into_iter());
            return Ok(None);
        }
        let entry: VariantEntry =
            serde_json::from_str(entry).map_err(|error| fail(error.to_string()))?;
        entry.check().map_err(|error| fail(error.to_string()))?;
        Ok(Some(entry))
    }
}

/// What comes after the sheets.
#[derive(Deserialize)]
struct Foot {
    #[serde(default)]
    items: BTreeMap<String, String>,
}

/// What an answer in another form is worth on the sheets of a manifest.
fn share(head: &Manifest) -> Option<Credit> {
    let share = head.other_form?;
    Some(Credit::read(&share.to_string()).unwrap_or(Credit::NONE))
}

/// The solution of a question as it was handed out.
pub(crate) fn solution<'i>(
    items: &'i Items<'_>,
    question: &QuestionEntry,
    decimal: char,
    doubt: Doubt,
) -> Result<Solution<'i>, Failure> {
    let template = items.find(&question.item, question.revision)?;
    solution_of(template, question, decimal, doubt)
}

/// The same of an item as it is marked now.
pub(crate) fn solution_of<'i>(
    template: &'i Template,
    question: &QuestionEntry,
    decimal: char,
    doubt: Doubt,
) -> Result<Solution<'i>, Failure> {
    let known: Vec<(&str, &str)> = question
        .values
        .iter()
        .map(|(name, value)| (name.as_str(), value.as_str()))
        .filter(|(name, _)| template.parameter(name).is_some())
        .collect();
    let instance =
        Instance::of(template, Some(Seed::new(question.seed)), &known).map_err(Failure::of)?;
    let mark = DecimalMark::of_char(decimal).unwrap_or_default();
    Ok(Solution::with_mark(instance, mark).settling(doubt))
}
