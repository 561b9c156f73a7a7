//! `vibank export`

use std::num::NonZeroU32;
use std::path::{Path, PathBuf};

use vibank::bank::Catalogue;
use vibank::diagnostic::Finding;
use vibank::export::Moodle;
use vibank::scene::Data;
use vibank::source::Source;
use vibank::worksheet::{Audience, Blueprint, Choice, Chooser, Plan, Sheet, SheetError};

use super::bank::{self, BankArgument};
use super::files::{self, Access};
use super::filter::Filter;
use super::{Failure, Outcome};

/// Variants of each item where no blueprint says how many.
const VARIANTS: usize = 10;

/// Write questions for a course platform.
///
/// Numbers and choices are marked by the platform, with the tolerances and named mistakes of the grader. Other kinds are
/// listed with the reason, or become essay questions with the key for whoever marks them.
///
/// Example: vibank export moodle examples/midterm.toml --out midterm.xml
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The platform.
    platform: Platform,
    /// A blueprint whose questions are exported; else the items that pass the filter.
    blueprint: Option<PathBuf>,
    #[command(flatten)]
    filter: Filter,
    /// Variants of each question; else as many as the blueprint says, or 10.
    #[arg(long, value_name = "COUNT")]
    variants: Option<NonZeroU32>,
    /// Write parts that the platform cannot mark as essay questions.
    #[arg(long)]
    essay: bool,
    /// The file to write.
    #[arg(long, value_name = "FILE", default_value = "questions.xml")]
    out: PathBuf,
    #[command(flatten)]
    bank: BankArgument,
}

/// A course platform.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Platform {
    /// Moodle XML with cloze questions.
    Moodle,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let Platform::Moodle = arguments.platform;
    let catalogue = arguments.bank.catalogue()?;
    let made = match &arguments.blueprint {
        Some(path) if arguments.filter.is_open() => of_blueprint(path, arguments, &catalogue)?,
        Some(_) => {
            return Err(
                Failure::new("questions are exported of a blueprint or of a filter")
                    .help("give one of the two"),
            );
        }
        None => of_filter(arguments, &catalogue)?,
    };
    let moodle = match made {
        Ok(moodle) => moodle,
        Err(findings) => return bank::refuse(&findings),
    };
    report(&moodle, arguments);
    // It holds the keys.
    files::write(&arguments.out, moodle.finish().as_bytes(), Access::Private)?;
    Ok(Outcome::Done)
}

/// What was made, or what is wrong with the blueprint.
type Made = Result<Moodle, Vec<Finding>>;

/// The questions of a blueprint, a category each.
fn of_blueprint(
    path: &Path,
    arguments: &Arguments,
    catalogue: &Catalogue,
) -> Result<Made, Failure> {
    let source = Source::new(path.display().to_string(), files::read(path)?);
    let blueprint = match Blueprint::read(&source) {
        Ok(blueprint) => blueprint,
        Err(findings) => return Ok(Err(findings)),
    };
    let mut choices = blueprint.questions.iter().map(|question| &question.choice);
    if choices.any(|choice| matches!(choice, Choice::Pick { .. })) {
        bank::read_all(catalogue);
    }
    let secret = super::sheet::secret(&blueprint)?;
    let plan = match Plan::of(&blueprint, catalogue, secret) {
        Ok(plan) => plan,
        Err(findings) => return Ok(Err(findings)),
    };
    let stated = match blueprint.audience {
        Audience::Variants(count) => count,
        Audience::Students(_) => VARIANTS,
    };
    let sheets = sheets(&plan, count(arguments, stated))?;
    let mut moodle = Moodle::new(&blueprint.title, blueprint.data, arguments.essay);
    for place in 0..plan.questions.len() {
        moodle.category(&format!("Question {}", place + 1));
        for sheet in &sheets {
            let question = sheet.questions.iter().find(|own| own.place == place);
            question.into_iter().for_each(|own| moodle.add(sheet, own));
        }
    }
    Ok(Ok(moodle))
}

/// The items that pass the filter, a category each.
fn of_filter(arguments: &Arguments, catalogue: &Catalogue) -> Result<Made, Failure> {
    let items = arguments.filter.items(catalogue)?;
    let mut moodle = Moodle::new(&catalogue.bank.title, Data::default(), arguments.essay);
    for item in items {
        let id = item.id.as_str();
        // Each by itself: on one sheet all would have to be suitable with the same code.
        let text = format!("title = 'T'\nseed = 1\nvariants = 1\n[[question]]\nitem = '{id}'\n");
        let source = Source::new(id.to_owned(), text);
        let blueprint = match Blueprint::read(&source) {
            Ok(blueprint) => blueprint,
            Err(findings) => return Ok(Err(findings)),
        };
        let plan = match Plan::of(&blueprint, catalogue, None) {
            Ok(plan) => plan,
            Err(findings) => return Ok(Err(findings)),
        };
        let sheets = sheets(&plan, count(arguments, VARIANTS))?;
        let mut chapters = catalogue.chapters.iter();
        let chapter = chapters.find(|chapter| chapter.folder == item.id.chapter());
        let chapter = chapter.map_or(item.id.chapter(), |chapter| chapter.title.as_str());
        moodle.category(&format!("{chapter}: {}", item.about.title));
        for sheet in &sheets {
            sheet
                .questions
                .iter()
                .for_each(|own| moodle.add(sheet, own));
        }
    }
    Ok(Ok(moodle))
}

fn count(arguments: &Arguments, stated: usize) -> usize {
    arguments
        .variants
        .map_or(stated, |count| count.get() as usize)
}

/// The sheets of a plan.
fn sheets<'c>(plan: &Plan<'c>, count: usize) -> Result<Vec<Sheet<'c>>, Failure> {
    let refuse = |error: SheetError| Failure::new(error.to_string());
    let mut chooser = Chooser::new(plan, &[], std::collections::BTreeMap::new());
    for index in 0..count as u64 {
        let mut from = 0;
        loop {
            let candidate = chooser.propose(index, from).map_err(refuse)?;
            if chooser.take(&candidate) {
                break;
            }
            from = candidate.next_attempt();
        }
    }
    let variants: Vec<_> = chooser.taken().collect();
    let draw = |variant| Sheet::draw(plan, variant, None).map_err(refuse);
    variants.into_iter().map(draw).collect()
}

fn report(moodle: &Moodle, arguments: &Arguments) {
    println!(
        "{}: {} questions with {} blanks",
        arguments.out.display(),
        moodle.questions(),
        moodle.blanks()
    );
    if moodle.unfit().is_empty() {
        return;
    }
    let what = if arguments.essay {
        "are essays, which a person marks"
    } else {
        "are not exported, since Moodle cannot mark them; `--essay` makes them essays"
    };
    eprintln!("{} parts {what}:", moodle.unfit().len());
    for unfit in moodle.unfit() {
        eprintln!("  {}/{}  {}", unfit.item, unfit.part, unfit.reason);
    }
}
