//! `vibank page`

use std::path::{Path, PathBuf};

use vibank::answer::Doubt;
use vibank::bank::{Catalogue, Compiled};
use vibank::source::Source;
use vibank::worksheet::{Blueprint, Plan, Practice};

use super::bank::{self, BankArgument};
use super::doubt::doubt;
use super::files::{self, Access};
use super::filter::Filter;
use super::{Failure, Outcome};

/// Write a page on which students practise and check themselves: one file, which works without a network.
///
/// Example: vibank page --chapter ch3 --out damping.html
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// A blueprint whose questions are practised; else the items that pass the filter.
    blueprint: Option<PathBuf>,
    #[command(flatten)]
    filter: Filter,
    /// The title of the page; else that of the blueprint or the bank.
    #[arg(long)]
    title: Option<String>,
    /// What becomes of an answer with two readings of which one is right; else as the blueprint says, or it is asked
    /// back.
    #[arg(long, value_name = "POLICY", value_parser = doubt())]
    doubt: Option<Doubt>,
    /// The file to write.
    #[arg(long, value_name = "FILE", default_value = "practice.html")]
    out: PathBuf,
    #[command(flatten)]
    bank: BankArgument,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let catalogue = arguments.bank.catalogue()?;
    let (mut practice, items) = match &arguments.blueprint {
        Some(path) if arguments.filter.is_open() => match planned(path, &catalogue)? {
            Ok(practice) => practice,
            Err(findings) => return bank::refuse(&findings),
        },
        Some(_) => {
            return Err(Failure::new("a page is made of a blueprint or of a filter")
                .help("leave one of the two out"));
        }
        None => filtered(&arguments.filter, &catalogue)?,
    };
    if let Some(title) = &arguments.title {
        practice.title.clone_from(title);
    }
    if let Some(doubt) = arguments.doubt {
        practice.doubt = doubt;
    }
    let page = vibank::output::practice(&practice, &items)
        .map_err(|error| Failure::new(error.to_string()))?;
    files::write(&arguments.out, page.as_bytes(), Access::Usual)?;
    println!(
        "{}: {} questions, {} kB",
        arguments.out.display(),
        practice.questions.len(),
        page.len().div_ceil(1000)
    );
    Ok(Outcome::Done)
}

type Offered = (Practice, Vec<Compiled>);

/// The practice of a blueprint, or what is wrong with it.
fn planned(
    path: &Path,
    catalogue: &Catalogue,
) -> Result<Result<Offered, Vec<vibank::diagnostic::Finding>>, Failure> {
    let source = Source::new(path.display().to_string(), files::read(path)?);
    let plan = |blueprint: Blueprint| {
        Plan::of(&blueprint, catalogue, None).map(|plan| Practice::of_plan(&plan, catalogue))
    };
    Ok(Blueprint::read(&source).and_then(plan))
}

fn filtered(filter: &Filter, catalogue: &Catalogue) -> Result<Offered, Failure> {
    let items = filter.items(catalogue)?;
    Ok(Practice::of_items(catalogue, &items, &catalogue.bank.title))
}
