//! `vibank new item|sheet FILE`

use std::path::PathBuf;

use super::{Failure, Outcome, files};

/// Begin an item or a blueprint with a commented file that works.
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
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let text = match arguments.what {
        What::Item => include_str!("../../templates/new/item.toml"),
        What::Sheet => include_str!("../../templates/new/sheet.toml"),
    };
    let shown = arguments.file.display();
    if arguments.file.exists() {
        return Err(Failure::new(format!("`{shown}` exists already")).help("choose another name"));
    }
    files::write(&arguments.file, text.as_bytes())?;
    println!("wrote {shown}");
    match arguments.what {
        What::Item => println!("next: vibank check {shown}"),
        What::Sheet => println!("next: vibank sheet {shown}"),
    }
    Ok(Outcome::Done)
}
