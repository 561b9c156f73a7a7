//! `vibank new item|exam|sheet|bank|secret NAME`

use std::path::{Path, PathBuf};

use super::files::{self, Access};
use super::{Failure, Outcome};

/// Begin an item, an exam, a sheet or a bank with commented files that work, or make a secret for an exam.
///
/// Nothing is asked, and nothing is overwritten.
///
/// Example: vibank new exam test.toml
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// What to begin.
    what: What,
    /// The file to write, or the folder of a bank; it must not exist yet.
    file: PathBuf,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum What {
    /// An item of a bank: bank/CHAPTER/SLUG.toml
    Item,
    /// A blueprint of an exam: an item, a choice among items, and a question of your own.
    Exam,
    /// A blueprint of a sheet, short, with a comment on every key.
    Sheet,
    /// A folder with a bank of your own: a chapter with an item.
    Bank,
    /// A secret that keys the seeds of an exam: 256 random bits, which the owner alone may read.
    Secret,
}

const ITEM: &str = include_str!("../../templates/new/item.toml");
const EXAM: &str = include_str!("../../templates/new/exam.toml");
const SHEET: &str = include_str!("../../templates/new/sheet.toml");

/// The files of a bank. The one that makes a folder a bank comes last.
const BANK: [(&str, &str); 3] = [
    ("ch1/block-on-a-spring.toml", ITEM),
    (
        "ch1/_chapter.toml",
        include_str!("../../templates/new/bank/_chapter.toml"),
    ),
    (
        "bank.toml",
        include_str!("../../templates/new/bank/bank.toml"),
    ),
];

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let Arguments { what, file } = arguments;
    let shown = file.display();
    if file.symlink_metadata().is_ok() && !(matches!(what, What::Bank) && is_begun(file)) {
        return Err(files::exists(file));
    }
    match what {
        What::Item => files::write_new(file, ITEM.as_bytes(), Access::Usual)?,
        What::Exam => files::write_new(file, EXAM.as_bytes(), Access::Usual)?,
        What::Sheet => files::write_new(file, SHEET.as_bytes(), Access::Usual)?,
        What::Secret => files::write_new(file, secret()?.as_bytes(), Access::Private)?,
        What::Bank => {
            for (name, text) in BANK {
                files::write(&file.join(name), text.as_bytes(), Access::Usual)?;
            }
        }
    }
    println!("wrote {shown}");
    match what {
        What::Item => println!("next: vibank check {shown}"),
        What::Exam => println!("next: vibank preview {shown}"),
        What::Sheet => println!("next: vibank sheet {shown}"),
        What::Bank => println!("next: vibank check --bank {shown}"),
        What::Secret => println!(
            "next: write `secret = \"{}\"` in place of `seed` in the blueprint beside it; one secret for each exam",
            file.file_name().unwrap_or_default().display()
        ),
    }
    Ok(Outcome::Done)
}

/// Whether a folder is empty, or holds what an interrupted command has written of a bank and nothing else.
fn is_begun(path: &Path) -> bool {
    let is_folder = |path: &Path| path.symlink_metadata().is_ok_and(|found| found.is_dir());
    let mut open = vec![path.to_owned()];
    while let Some(folder) = open.pop() {
        if !is_folder(&folder) {
            return false;
        }
        let Ok(entries) = std::fs::read_dir(&folder) else {
            return false;
        };
        for entry in entries.flatten() {
            let entry = entry.path();
            if folder == *path && is_folder(&entry) && entry.ends_with("ch1") {
                open.push(entry);
            } else if !is_ours(&entry, path) {
                return false;
            }
        }
    }
    // The file that makes it a bank comes last.
    path.join("bank.toml").symlink_metadata().is_err()
}

/// Whether a file in a folder is one of those that the program writes there, or a draft of one.
fn is_ours(entry: &Path, path: &Path) -> bool {
    let name = entry.strip_prefix(path).ok().and_then(Path::to_str);
    let name = name.map(|name| name.replace('\\', "/"));
    let Some(name) = name else {
        return false;
    };
    let (folder, own) = name.rsplit_once('/').unwrap_or(("", &name));
    let is_draft = |of: &str| {
        let (place, of) = of.rsplit_once('/').unwrap_or(("", of));
        place == folder && files::is_draft(own, of)
    };
    BANK.iter().any(|(of, text)| {
        is_draft(of)
            || *of == name && files::read_bytes(entry).is_ok_and(|held| held == text.as_bytes())
    })
}

/// 256 random bits of the system, in hexadecimal digits.
fn secret() -> Result<String, Failure> {
    let mut bytes = [0; 32];
    getrandom::fill(&mut bytes)
        .map_err(|error| Failure::new(format!("the system gives no random numbers: {error}")))?;
    let digits: String = bytes.iter().map(|byte| format!("{byte:02x}")).collect();
    Ok(digits + "\n")
}
