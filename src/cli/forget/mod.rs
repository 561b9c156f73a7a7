//! `vibank forget FOLDER STUDENT`

mod rows;
mod sheets;
mod trace;

use std::collections::BTreeSet;
use std::fs::File;
use std::path::PathBuf;

use vibank::worksheet::{Manifest, VariantEntry};

use self::trace::Person;
use super::folder::Folder;
use super::record::FORM;
use super::sheet::{KEPT, MANIFESTS, MARKS};
use super::{Failure, Outcome, grade};

/// Remove what a run holds of one student: sheets, keys, solutions, feedback, rows of answers and marks, and the
/// entries in its manifests.
///
/// What is left with a trace of the student is listed. Remove the row from the class list, too, or the next run makes
/// the sheet again.
///
/// Example: vibank forget midterm XM2-9SB-THF --dry-run
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The folder of the run.
    folder: PathBuf,
    /// The student's `id` in the class list, or the code of the sheet.
    student: String,
    /// A further folder with marks of this run; `marks` beside the manifest is looked through in any case.
    #[arg(long, value_name = "FOLDER")]
    marks: Vec<PathBuf>,
    /// Say what would be removed, and remove nothing.
    #[arg(long)]
    dry_run: bool,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let shown = arguments.folder.display();
    let out = Folder::at(&arguments.folder);
    let manifests = manifests(&out)?;
    if manifests.is_empty() {
        return Err(Failure::new(format!("there is no manifest in `{shown}`"))
            .help("name the folder that `vibank sheet` wrote"));
    }
    let Some(person) = Person::find(&manifests, &arguments.student) else {
        let student = arguments.student.escape_debug();
        let message = format!("no manifest in `{shown}` has a student or a sheet `{student}`");
        return Err(Failure::new(message).help(
            "give the `id` as in the class list, or the code, by which a run with pseudonyms knows the sheet",
        ));
    };
    let places = places(&out, arguments);
    let _locks = locks(&out, &places)?;
    let mut task = Task {
        person,
        is_dry: arguments.dry_run,
        done: Vec::new(),
        form: None,
    };
    // The manifests last: while they know the student, an interrupted removal is taken up by the same command.
    for (folder, inside) in &places {
        rows::remove(&mut task, folder, inside)?;
        rows::remove_overviews(&mut task, folder, inside)?;
    }
    sheets::remove(&mut task, &out, manifests)?;
    task.report(&places);
    Ok(Outcome::Done)
}

/// A removal, with what it has done so far.
struct Task {
    person: Person,
    is_dry: bool,
    /// Lines of the report.
    done: Vec<String>,
    /// Digests of the form for the answers, before and after.
    form: Option<(String, String)>,
}

/// The sheets of some manifests.
pub(crate) fn entries(manifests: &[(String, Manifest)]) -> impl Iterator<Item = &VariantEntry> {
    manifests
        .iter()
        .flat_map(|(_, manifest)| &manifest.variants)
}

/// The manifests of a folder, those of earlier runs among them, by their names.
fn manifests(out: &Folder) -> Result<Vec<(String, Manifest)>, Failure> {
    let own = out.names("").into_iter().filter(|name| {
        name == "manifest.json" || name.starts_with("manifest-") && name.ends_with(".json")
    });
    let earlier = out.names(MANIFESTS).into_iter();
    let earlier = earlier.filter(|name| name.ends_with(".json"));
    own.chain(earlier.map(|name| format!("{MANIFESTS}/{name}")))
        .map(|name| {
            let manifest = grade::manifest(&out.path(&name)?)?;
            Ok((name, manifest))
        })
        .collect()
}

/// Where tables and pages may be: the run itself, the copies that it keeps, and marks; each with what leads to it in its
/// folder.
fn places(out: &Folder, arguments: &Arguments) -> Vec<(Folder, String)> {
    let runs = runs(out);
    let marks = runs.iter().map(|run| format!("{run}{MARKS}/"));
    let own = runs.iter().cloned().chain(marks);
    let own = own.map(|inside| (out.clone(), inside));
    let others = arguments.marks.iter();
    let others = others.map(|folder| (Folder::at(folder), String::new()));
    own.chain(others).collect()
}

/// What leads to the run and to the copies that it keeps.
fn runs(out: &Folder) -> Vec<String> {
    let kept = out.names(KEPT).into_iter();
    let kept = kept.map(|name| format!("{KEPT}/{name}/"));
    std::iter::once(String::new()).chain(kept).collect()
}

/// The locks of runs that write here: nothing is removed beside them, nor from what an interrupted one has left.
fn locks(out: &Folder, places: &[(Folder, String)]) -> Result<Vec<File>, Failure> {
    let is_ledger = |name: &String| name.starts_with(".sheet") && name.ends_with(".run");
    let ledgers = out.names("").into_iter().filter(is_ledger);
    let ledgers = ledgers.map(|name| (out, name));
    let journals = places.iter().flat_map(|(folder, inside)| {
        let names = folder.names(inside.trim_end_matches('/')).into_iter();
        let names = names.filter(|name| grade::is_journal(name));
        names.map(move |name| (folder, format!("{inside}{name}")))
    });
    let mut locks = Vec::new();
    for (folder, name) in ledgers
        .chain(journals)
        .filter(|(folder, name)| folder.has(name))
    {
        let shown = folder.root().display();
        let Some(lock) = folder.claim(&name)? else {
            return Err(Failure::new(format!("a run writes to `{shown}`")).help("wait for it"));
        };
        if is_ledger(&name) {
            return Err(
                Failure::new(format!("a run into `{shown}` was interrupted"))
                    .help("finish it with the same `vibank sheet`, then forget the student"),
            );
        }
        locks.push(lock);
    }
    Ok(locks)
}

impl Task {
    /// Removes a file, if it is there.
    fn remove(&mut self, out: &Folder, name: &str) -> Result<(), Failure> {
        if out.has(name) {
            if !self.is_dry {
                out.remove(name)?;
            }
            self.done.push(name.to_owned());
        }
        Ok(())
    }

    /// Writes a file anew.
    fn write(&self, out: &Folder, name: &str, text: &[u8]) -> Result<(), Failure> {
        if self.is_dry {
            return Ok(());
        }
        out.write(name, text).map(drop)
    }

    /// Notes that this many things of a file are gone.
    fn note(&mut self, count: usize, thing: [&str; 2], name: &str) {
        if count > 0 {
            let thing = thing[usize::from(count != 1)];
            self.done.push(format!("{count} {thing} of {name}"));
        }
    }

    /// Says what was removed, and what is left.
    fn report(&self, places: &[(Folder, String)]) {
        let codes: Vec<&str> = self.person.codes.iter().map(String::as_str).collect();
        let whose = match &self.person.id {
            Some(id) => format!("`{}`, {}", id.escape_debug(), codes.join(", ")),
            None => codes.join(", "),
        };
        let verb = if self.is_dry {
            "would be removed"
        } else {
            "removed"
        };
        println!("{verb} of {whose}:");
        for line in &self.done {
            println!("  {line}");
        }
        if self.is_dry {
            return;
        }
        let mut left = BTreeSet::new();
        for (folder, inside) in places.iter().filter(|(_, inside)| inside.is_empty()) {
            self.person.traces(folder, inside, &mut left);
        }
        if !left.is_empty() {
            eprintln!("left, to be looked at by hand:");
            for line in &left {
                eprintln!("  {line}");
            }
        }
        eprintln!(
            "not in this folder: the class list, {FORM} under another name, a file of pseudonyms, copies and printed sheets"
        );
    }
}
