//! `vibank check [FILE|ITEM]`

use rayon::prelude::*;
use vibank::bank::Catalogue;
use vibank::diagnostic::{Finding, Severity};
use vibank::solution::proof;

use super::bank::{self, BankArgument};
use super::{Failure, Format, Outcome};

/// Look over a bank: form, names, dimensions, texts, and the known results of each item.
///
/// Example: vibank check ch4/p1-rolling-disk-hub-moment
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The items to look over, or files of items; all of the bank without any.
    items: Vec<String>,
    #[command(flatten)]
    bank: BankArgument,
    /// Draws over which the two routes to a quantity are compared.
    #[arg(long, value_name = "NUMBER", default_value_t = 200, value_parser = clap::value_parser!(u64).range(0..=100_000))]
    seeds: u64,
    /// How findings are printed.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

impl Arguments {
    /// Whether a file of the bank is to be looked over.
    fn wants(&self, path: &str) -> bool {
        let wanted = |item: &String| path.contains(item.trim_end_matches(".toml"));
        self.items.is_empty() || self.items.iter().any(wanted)
    }
}

/// What the known results and the second routes of the items disprove.
fn proofs(catalogue: &Catalogue, arguments: &Arguments) -> Vec<Finding> {
    let items = catalogue
        .items()
        .par_iter()
        .filter(|item| arguments.wants(&item.source.path));
    let findings = items.map(|item| {
        let mut findings = proof::known_results(item);
        findings.extend(proof::routes(item, arguments.seeds));
        findings
    });
    findings.collect::<Vec<_>>().concat()
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let (catalogue, mut findings) = arguments.bank.load()?;
    findings.extend(proofs(&catalogue, arguments));
    Finding::sort(&mut findings);
    if !arguments.items.is_empty() {
        findings.retain(|finding| arguments.wants(&finding.source.path));
    }
    match arguments.format {
        Format::Text => bank::print(&findings),
        Format::Json => println!(
            "{}",
            serde_json::to_string(&findings).expect("findings are plain data")
        ),
    }
    let count = |severity| {
        findings
            .iter()
            .filter(|finding| finding.severity == severity)
            .count()
    };
    let (errors, warnings) = (count(Severity::Error), count(Severity::Warning));
    eprintln!(
        "{}, {}, {}",
        counted(catalogue.items().len(), "item"),
        counted(errors, "error"),
        counted(warnings, "warning")
    );
    Ok(if findings.is_empty() {
        Outcome::Done
    } else {
        Outcome::Findings
    })
}

/// A number of things, in words.
fn counted(number: usize, thing: &str) -> String {
    let plural = if number == 1 { "" } else { "s" };
    format!("{number} {thing}{plural}")
}
