//! `vibank new item|sheet|secret FILE`

use std::path::PathBuf;

use super::files::{self, Access};
use super::{Failure, Outcome};

/// Begin an item or a blueprint with a commented file that works, or make a secret for an exam.
///
/// Example: vibank new sheet test.toml
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// What to begin.
    what: What,
    /// The file to write; it must not exist yet.
    file: PathBuf,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum What {
    /// An item of a bank: bank/CHAPTER/SLUG.toml
    Item,
    /// A blueprint of a sheet.
    Sheet,
    /// A secret that keys the seeds of an exam: 256 random bits, which the owner alone may read.
    Secret,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let (text, access) = match arguments.what {
        What::Item => (
            include_str!("../../templates/new/item.toml").to_owned(),
            Access::Usual,
        ),
        What::Sheet => (
            include_str!("../../templates/new/sheet.toml").to_owned(),
            Access::Usual,
        ),
        What::Secret => (secret()?, Access::Private),
    };
    let shown = arguments.file.display();
    if arguments.file.symlink_metadata().is_ok() {
        return Err(Failure::new(format!("`{shown}` exists already")).help("choose another name"));
    }
    files::write(&arguments.file, text.as_bytes(), access)?;
    println!("wrote {shown}");
    match arguments.what {
        What::Item => println!("next: vibank check {shown}"),
        What::Sheet => println!("next: vibank sheet {shown}"),
        What::Secret => println!(
            "next: write `secret = \"{}\"` in place of `seed` in the blueprint beside it; one secret for each exam",
            arguments.file.file_name().unwrap_or_default().display()
        ),
    }
    Ok(Outcome::Done)
}

/// 256 random bits of the system, in hexadecimal digits.
fn secret() -> Result<String, Failure> {
    let mut bytes = [0; 32];
    getrandom::fill(&mut bytes)
        .map_err(|error| Failure::new(format!("the system gives no random numbers: {error}")))?;
    let digits: String = bytes.iter().map(|byte| format!("{byte:02x}")).collect();
    Ok(digits + "\n")
}
