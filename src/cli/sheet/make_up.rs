//! A make-up exam: other sheets of the same blueprint for students who had one, with nothing that they had.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use vibank::source::nearest;
use vibank::worksheet::{QuestionEntry, Student};

use super::Arguments;
use crate::cli::grade::manifest;
use crate::cli::table::composed;
use crate::cli::{Failure, files};

/// What variants of a make-up are named after, and its folder.
pub(crate) const SITTING: &str = "make-up";

/// The students of a make-up, and what they had.
pub(crate) struct MakeUp {
    /// Those of the class list who are named.
    pub(crate) students: Vec<Student>,
    /// The questions of their first sheets, by identity.
    pub(crate) earlier: BTreeMap<String, Vec<QuestionEntry>>,
    /// The digest of the manifest of the first run.
    pub(crate) digest: String,
}

impl MakeUp {
    /// The students that the command names, each with a sheet of the first run.
    pub(crate) fn of(arguments: &Arguments, students: Vec<Student>) -> Result<Self, Failure> {
        let path = first(arguments);
        if !path.is_file() {
            return Err(Failure::new(format!(
                "the first sheets are not known: there is no `{}`",
                path.display()
            ))
            .help("give the manifest of the first run with `--first`"));
        }
        let beside = path.parent().unwrap_or(Path::new("."));
        if is_same(beside, &super::out(arguments)) {
            return Err(Failure::new(format!(
                "`{}` has the sheets of the first run, which the make-up would replace",
                beside.display()
            ))
            .help("give the make-up a folder of its own with `--out`, or leave that out"));
        }
        let manifest_of_first = manifest(&path)?;
        let mut had = BTreeMap::new();
        for variant in manifest_of_first.variants {
            let id = variant
                .student
                .as_ref()
                .and_then(|student| student.get("id"));
            if let Some(id) = id.cloned() {
                had.insert(composed(id), variant.questions);
            }
        }
        let mut make_up = Self {
            students: Vec::new(),
            earlier: BTreeMap::new(),
            digest: files::digest_of(&path)?,
        };
        for id in &arguments.make_up {
            let id = id.trim();
            if make_up.earlier.contains_key(id) {
                continue;
            }
            let student = students.iter().find(|student| student.id == id);
            let Some(student) = student else {
                return Err(unknown(id, &students));
            };
            let Some(questions) = had.remove(id) else {
                let shown = path.display();
                return Err(Failure::new(format!("`{id}` has no sheet in `{shown}`"))
                    .help("a student who had none gets an ordinary sheet: leave out `--make-up`"));
            };
            make_up.earlier.insert(id.to_owned(), questions);
            make_up.students.push(student.clone());
        }
        // In the order of the class list, however they are named.
        let place = |own: &Student| students.iter().position(|student| student.id == own.id);
        make_up.students.sort_by_key(place);
        Ok(make_up)
    }
}

/// Whether two paths lead to one folder.
fn is_same(one: &Path, other: &Path) -> bool {
    whole(one).is_some_and(|one| Some(one) == whole(other))
}

/// A folder by its whole path.
fn whole(path: &Path) -> Option<PathBuf> {
    let here = path.as_os_str().is_empty();
    std::fs::canonicalize(if here { Path::new(".") } else { path }).ok()
}

/// The folder of a make-up, if it is not named.
pub(crate) fn folder(blueprint: &Path) -> PathBuf {
    let name = blueprint.file_stem().unwrap_or("sheet".as_ref());
    PathBuf::from(format!("{}-{SITTING}", name.to_string_lossy()))
}

/// The manifest of the first run.
fn first(arguments: &Arguments) -> PathBuf {
    arguments.first.clone().unwrap_or_else(|| {
        let name = arguments.blueprint.file_stem().unwrap_or("sheet".as_ref());
        Path::new(name).join("manifest.json")
    })
}

fn unknown(id: &str, students: &[Student]) -> Failure {
    let failure = Failure::new(format!("the class list has no student `{id}`"));
    if let Some(named) = students.iter().find(|student| student.name == id) {
        return failure.help(format!("`{id}` is named by the id `{}`", named.id));
    }
    let near = nearest(id, students.iter().map(|student| student.id.as_str()));
    match near {
        Some(near) => failure.help(format!("did you mean `{near}`?")),
        None => failure.help("name students by their `id` in the class list"),
    }
}
