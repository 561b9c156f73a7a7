//! `vibank page`

use std::path::{Path, PathBuf};

use vibank::answer::Doubt;
use vibank::bank::{Catalogue, Compiled};
use vibank::course::Package;
use vibank::output::Scorm;
use vibank::worksheet::{Blueprint, Feedback, Plan, Practice, Rules, Worked};

use super::bank::{self, BankArgument};
use super::doubt::doubt;
use super::files::{self, Access};
use super::filter::{Filter, Given};
use super::{Failure, Outcome, counted, file_kind};

/// Write a page on which students practise and check themselves: one file, which works without a network.
///
/// As a SCORM package it goes into a course of Moodle, Canvas, Ilias or Blackboard: each learner has data of their own,
/// and the score stands in the course. The rules are in `[page]` of the blueprint.
///
/// Example: vibank page --chapter ch3 --out damping.html
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// A blueprint whose questions are practised, or a word that names items as in `vibank practice`; else the items that
    /// pass the filter.
    #[arg(value_name = "BLUEPRINT|ITEMS")]
    given: Option<PathBuf>,
    #[command(flatten)]
    filter: Filter,
    /// The title of the page; else that of the blueprint or the bank.
    #[arg(long)]
    title: Option<String>,
    /// What becomes of an answer with two readings of which one is right; else as the blueprint says, or it is asked
    /// back.
    #[arg(long, value_name = "POLICY", value_parser = doubt())]
    doubt: Option<Doubt>,
    /// Write a package of this version of SCORM for a course platform.
    #[arg(long, value_name = "VERSION")]
    scorm: Option<Version>,
    /// The file to write; else practice.html or practice.zip.
    #[arg(short, long, value_name = "FILE")]
    out: Option<PathBuf>,
    #[command(flatten)]
    bank: BankArgument,
}

/// A version of SCORM.
#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum Version {
    /// SCORM 1.2, which nearly every platform plays; keeps 4,096 characters.
    #[value(name = "1.2")]
    V12,
    /// SCORM 2004, 4th edition; keeps 64,000 characters.
    #[value(name = "2004")]
    V2004,
}

/// What a page is made of.
struct Offered {
    practice: Practice,
    items: Vec<Compiled>,
    rules: Rules,
    seed: u64,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let catalogue = arguments.bank.catalogue()?;
    let mut offered = match arguments.given.as_deref().map(Given::of) {
        Some(Given::Blueprint(path)) if arguments.filter.is_open() => {
            match planned(path, &catalogue)? {
                Ok(offered) => offered,
                Err(findings) => return bank::refuse(&findings),
            }
        }
        Some(Given::Blueprint(_)) => {
            return Err(Failure::new("a page is made of a blueprint or of a filter")
                .help("give one of the two"));
        }
        Some(Given::Word(word)) => filtered(Some(word), &arguments.filter, &catalogue)?,
        None => filtered(None, &arguments.filter, &catalogue)?,
    };
    if let Some(title) = &arguments.title {
        offered.practice.title.clone_from(title);
    }
    if let Some(doubt) = arguments.doubt {
        offered.practice.doubt = doubt;
    }
    let (written, usual) = match arguments.scorm {
        None => (page(&offered)?, "practice.html"),
        Some(version) => (package(&offered, version)?, "practice.zip"),
    };
    let out = arguments.out.clone().unwrap_or_else(|| usual.into());
    files::write(&out, &written, Access::Usual)?;
    println!(
        "{}: {}, {} kB",
        out.display(),
        counted(offered.practice.questions.len(), "question"),
        written.len().div_ceil(1000)
    );
    Ok(Outcome::Done)
}

fn page(offered: &Offered) -> Result<Vec<u8>, Failure> {
    let page = vibank::output::practice(&offered.practice, &offered.items);
    Ok(page.map_err(Failure::of)?.into_bytes())
}

fn package(offered: &Offered, version: Version) -> Result<Vec<u8>, Failure> {
    let version = match version {
        Version::V12 => Scorm::V12,
        Version::V2004 => Scorm::V2004,
    };
    let Offered {
        practice,
        items,
        rules,
        seed,
    } = offered;
    let package = Package::of(practice, items, rules, *seed);
    version.room().fit(package.parts()).map_err(|error| {
        let way = match version {
            Scorm::V12 => "take fewer questions or parts, or `--scorm 2004`",
            Scorm::V2004 => "take fewer questions or parts, in several packages",
        };
        Failure::of(error).help(way)
    })?;
    // What is never shown does not travel.
    let mut silent = Vec::new();
    if rules.solution == Worked::Never {
        silent.push("solution");
    }
    if rules.feedback == Feedback::Never {
        silent.push("feedback");
    }
    let items = items.iter().map(|item| item.silenced(&silent));
    let items: Vec<Compiled> = items.collect();
    vibank::output::scorm(practice, &items, &package, version).map_err(Failure::of)
}

/// The practice of a blueprint, or what is wrong with it.
fn planned(
    path: &Path,
    catalogue: &Catalogue,
) -> Result<Result<Offered, Vec<vibank::diagnostic::Finding>>, Failure> {
    let source = file_kind::blueprint(path)?;
    Ok(Blueprint::read(&source).and_then(|blueprint| {
        Plan::of(&blueprint, catalogue, None).map(|plan| {
            let (practice, items) = Practice::of_plan(&plan, catalogue);
            Offered {
                practice,
                items,
                rules: blueprint.rules.clone(),
                seed: blueprint.seed,
            }
        })
    }))
}

/// The practice of the items that a word names and that pass a filter.
fn filtered(
    word: Option<&str>,
    filter: &Filter,
    catalogue: &Catalogue,
) -> Result<Offered, Failure> {
    let items = filter.items_of(word, catalogue)?;
    let (practice, items) = Practice::of_items(catalogue, &items, &catalogue.bank.title);
    Ok(Offered {
        practice,
        items,
        rules: Rules::default(),
        seed: 0,
    })
}
