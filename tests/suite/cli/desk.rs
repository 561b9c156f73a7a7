//! The desk of a teacher: a folder with a class list, a blueprint and the run that is made of them.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::{BANK, Ran, blueprint, content, folder, put, text_of, vibank};

pub(super) struct Desk {
    /// Where the blueprint is, and what it names.
    pub(super) folder: PathBuf,
    /// Where the sheets are.
    pub(super) out: PathBuf,
    /// The bank: the small one of the tests.
    pub(super) bank: String,
}

impl Desk {
    /// An empty one of this name.
    pub(super) fn new(name: &str) -> Self {
        let folder = folder(name);
        Self {
            out: folder.join("out"),
            bank: BANK.to_owned(),
            folder,
        }
    }

    /// One with a class list of so many students, from `s1` on.
    pub(super) fn with_class(name: &str, count: usize) -> Self {
        let desk = Self::new(name);
        desk.class(&ids(1..=count));
        desk
    }

    /// Writes the class list: these students.
    pub(super) fn class(&self, ids: &[String]) {
        let rows: String = ids.iter().map(|id| format!("{id},Name {id}\n")).collect();
        put(&self.folder, "class.csv", format!("id,name\n{rows}"));
    }

    /// Writes a secret to `exam.key`.
    pub(super) fn secret(&self) {
        put(&self.folder, "exam.key", "0123456789abcdef0123456789abcdef");
    }

    /// Writes a blueprint of the three items of the small bank, with these keys at its top.
    pub(super) fn plan(&self, top: &str) -> String {
        put(&self.folder, "t.toml", blueprint(top))
    }

    /// Writes a blueprint of one item, for the class list.
    pub(super) fn short_plan(&self, title: &str) -> String {
        let plan = format!(
            "title = '{title}'\nseed = 5\nstudents = 'class.csv'\nformats = ['md']\nsolutions = false\n\
            [[question]]\nitem = 'free/spring-mass'\n"
        );
        put(&self.folder, "t.toml", plan)
    }

    /// Runs a command on the bank.
    pub(super) fn run(&self, arguments: &[&str]) -> Ran {
        vibank(&[arguments, &["--bank", &self.bank]].concat())
    }

    /// Makes the sheets of a blueprint.
    pub(super) fn sheet(&self, plan: &str, more: &[&str]) -> Ran {
        self.run(&[&["sheet", plan, "--out", &text_of(&self.out)], more].concat())
    }

    /// Marks the form of the run.
    pub(super) fn grade(&self, more: &[&str]) -> Ran {
        let (manifest, form) = (self.path("manifest.json"), self.path("responses.csv"));
        self.run(&[&["grade", &manifest, &form], more].concat())
    }

    /// Removes a student from the run.
    pub(super) fn forget(&self, student: &str, more: &[&str]) -> Ran {
        vibank(&[&["forget", &text_of(&self.out), student], more].concat())
    }

    /// The path of something in the run, as an argument.
    pub(super) fn path(&self, name: &str) -> String {
        text_of(&self.out.join(name))
    }

    /// The text of a file of the run.
    #[track_caller]
    pub(super) fn text(&self, name: &str) -> String {
        content(self.out.join(name))
    }

    /// The manifest of the run.
    #[track_caller]
    pub(super) fn manifest(&self) -> Value {
        serde_json::from_str(&self.text("manifest.json")).expect("it is JSON")
    }

    /// Fills in every row of the form with an answer.
    pub(super) fn answer(&self, answer: &str) {
        put(
            &self.out,
            "responses.csv",
            answered(&self.text("responses.csv"), answer),
        );
    }
}

/// Students with these numbers.
pub(super) fn ids(numbers: impl IntoIterator<Item = usize>) -> Vec<String> {
    numbers
        .into_iter()
        .map(|number| format!("s{number}"))
        .collect()
}

/// A form with the same answer in every row.
pub(super) fn answered(form: &str, answer: &str) -> String {
    let rows = form.lines().enumerate().map(|(at, row)| match at {
        0 => format!("{row}\n"),
        _ => format!("{row}{answer}\n"),
    });
    rows.collect()
}

/// All files below a folder.
pub(super) fn all(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("it can be listed").path();
        if path.is_dir() {
            found.extend(all(&path));
        } else {
            found.push(path);
        }
    }
    found
}
