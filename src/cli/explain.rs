//! `vibank explain CODE`

use vibank::diagnostic::{Code, codes};
use vibank::source::nearest;

use super::{Failure, Outcome};

/// Explain the code of a finding, such as `bank::unknown-key`.
///
/// Example: vibank explain bank::unknown-key
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The code, as it stands in brackets after `error`; without it, all codes are listed.
    code: Option<String>,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let Some(name) = &arguments.code else {
        for page in codes::PAGES {
            println!("{:<28} {}", page.code.name(), page.title);
        }
        return Ok(Outcome::Done);
    };
    let page = Code::of_name(name).ok_or_else(|| unknown(name))?.page();
    println!("{}\n\n{}\n\n{}", page.code, page.title, page.text);
    Ok(Outcome::Done)
}

fn unknown(name: &str) -> Failure {
    let failure = Failure::new(format!("there is no code `{name}`"));
    match nearest(name, codes::PAGES.iter().map(|page| page.code.name())) {
        Some(near) => failure.help(format!("did you mean `{near}`?")),
        None => failure.help("`vibank explain` lists all codes"),
    }
}
