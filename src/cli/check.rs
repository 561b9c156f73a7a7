//! `vibank check [FILE|ITEM]`

use std::path::Path;

use rayon::prelude::*;
use vibank::bank::Catalogue;
use vibank::diagnostic::{Finding, Severity};
use vibank::scene;
use vibank::solution::proof;
use vibank::survey::Survey;

use super::bank::{self, BankArgument};
use super::{Failure, Format, Outcome, files, progress, survey};

/// Look over a bank: form, names, dimensions, texts, and the known results of each item.
///
/// Example: vibank check --report ch4/p1-rolling-disk-hub-moment
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The items to look over, or files of items; all of the bank without any.
    items: Vec<String>,
    #[command(flatten)]
    bank: BankArgument,
    /// Draws over which the two routes to a quantity are compared.
    #[arg(long, value_name = "NUMBER", default_value_t = 200, value_parser = clap::value_parser!(u64).range(0..=100_000))]
    seeds: u64,
    /// Tell also what the draws look like: instances, redraws, answers, tolerances, mistakes.
    #[arg(long)]
    report: bool,
    /// How findings and reports are printed.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

impl Arguments {
    /// Whether a file of the bank is to be looked over.
    fn wants(&self, path: &str) -> bool {
        let wanted = |item: &String| path.contains(inside(item).trim_end_matches(".toml"));
        self.items.is_empty() || self.items.iter().any(wanted)
    }

    /// The bank with the files that are named added to it; a name that leads to nothing is misuse.
    fn load(&self) -> Result<(Catalogue, Vec<Finding>), Failure> {
        let files: Vec<&Path> = self.items.iter().map(Path::new).collect();
        let files = files.into_iter().filter(|file| file.is_file());
        let texts = files.map(|file| {
            let path = inside(&file.to_string_lossy());
            Ok((path, files::read(file)?))
        });
        let texts = texts.collect::<Result<Vec<(String, String)>, Failure>>()?;
        let (catalogue, findings) = self.bank.load_with(&texts)?;
        let is_known = |item: &&String| {
            let path = inside(item);
            let path = path.trim_end_matches(".toml");
            let items = catalogue.items().map(|item| &*item.source.path);
            let broken = findings.iter().map(|finding| &*finding.source.path);
            items.chain(broken).any(|known| known.contains(path))
        };
        match self.items.iter().find(|item| !is_known(item)) {
            None => Ok((catalogue, findings)),
            Some(unknown) => {
                let failure = Failure::new(format!("there is no item or file `{unknown}`"));
                Err(match catalogue.nearest(unknown) {
                    Some(near) => failure.help(format!("did you mean `{near}`?")),
                    None => failure.help("`vibank list` shows all items"),
                })
            }
        }
    }
}

/// The path of a file or item inside its bank: the folder of the chapter and the name.
fn inside(item: &str) -> String {
    let pieces: Vec<&str> = item
        .split(['/', '\\'])
        .filter(|piece| *piece != ".")
        .collect();
    match pieces.as_slice() {
        [.., chapter, name] => format!("{chapter}/{name}"),
        // A file without a chapter stands beside them.
        [name] if name.ends_with(".toml") => format!("new/{name}"),
        _ => item.to_owned(),
    }
}

/// What looking over one item brings to light.
type Looked = (Vec<Finding>, Option<Survey>);

/// What the known results and the second routes of the items disprove, and what their draws look like.
fn look_over(catalogue: &Catalogue, arguments: &Arguments) -> Vec<Looked> {
    let wanted: Vec<_> = catalogue
        .items()
        .filter(|item| arguments.wants(&item.source.path))
        .collect();
    let progress = progress::bar(wanted.len() as u64, "items");
    let looked = wanted.par_iter().map(|item| {
        let mut findings = proof::findings(item, arguments.seeds);
        findings.extend(scene::undrawn(item));
        let survey = arguments
            .report
            .then(|| Survey::over(item, arguments.seeds));
        progress.inc(1);
        (findings, survey)
    });
    let looked = looked.collect();
    progress.finish_and_clear();
    looked
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let (catalogue, mut findings) = arguments.load()?;
    let mut surveys = Vec::new();
    for (found, survey) in look_over(&catalogue, arguments) {
        findings.extend(found);
        surveys.extend(survey);
    }
    Finding::sort(&mut findings);
    if !arguments.items.is_empty() {
        findings.retain(|finding| arguments.wants(&finding.source.path));
    }
    match arguments.format {
        Format::Text => {
            bank::print(&findings);
            survey::print(&surveys, !arguments.items.is_empty());
        }
        Format::Json => println!(
            "{}",
            serde_json::to_string(&Looks {
                findings: &findings,
                items: &surveys
            })
            .expect("findings and surveys are plain data")
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
        counted(catalogue.items().count(), "item"),
        counted(errors, "error"),
        counted(warnings, "warning")
    );
    Ok(if findings.is_empty() {
        Outcome::Done
    } else {
        Outcome::Findings
    })
}

/// What programs get.
#[derive(serde::Serialize)]
struct Looks<'a> {
    findings: &'a [Finding],
    /// With `--report`, one for each item.
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    items: &'a [Survey],
}

/// A number of things, in words.
fn counted(number: usize, thing: &str) -> String {
    let plural = if number == 1 { "" } else { "s" };
    format!("{number} {thing}{plural}")
}
