//! `vibank schema NAME`

use super::{Failure, Outcome};

/// Print a JSON schema, for editors that check and complete while a file is written.
///
/// Example: vibank schema item > item.schema.json
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// Of which files.
    name: Name,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum Name {
    /// Items of a bank.
    Item,
    /// Blueprints of sheets.
    Blueprint,
}

impl Name {
    fn schema(self) -> &'static str {
        match self {
            Self::Item => include_str!("../../templates/schema/item.json"),
            Self::Blueprint => include_str!("../../templates/schema/blueprint.json"),
        }
    }
}

#[expect(clippy::unnecessary_wraps, reason = "all commands end in the same way")]
pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    println!("{}", arguments.name.schema().trim_end());
    Ok(Outcome::Done)
}
