//! `vibank export`

mod manifest;

use std::num::NonZeroU32;
use std::path::{Path, PathBuf};

use vibank::bank::Catalogue;
use vibank::diagnostic::Finding;
use vibank::document::Formulas;
use vibank::export::{Canvas, Export, Moodle, Qti, Version, Wish};
use vibank::message::{Language, Phrase};
use vibank::source::Source;
use vibank::worksheet::{Audience, Blueprint, Choice, Chooser, Plan, Sheet};

use self::manifest::Record;
use super::bank::{self, BankArgument};
use super::files::{self, Access};
use super::filter::{Filter, Given};
use super::{Failure, Outcome, counted, file_kind};

/// Variants of each item where no blueprint says how many.
const VARIANTS: usize = 10;

/// Write questions for a course platform.
///
/// Numbers and choices are marked by the platform, with the tolerances of the grader. Other kinds are listed with the
/// reason, or become essay questions with the key for whoever marks them. Beside the file a manifest is written, with
/// which `vibank grade` marks the answers that the platform gives back.
///
/// Example: vibank export moodle examples/midterm.toml --out midterm.xml
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The course platform that imports the questions.
    platform: Platform,
    /// A blueprint whose questions are exported, or a word that names items as in `vibank practice`; else the items that
    /// pass the filter.
    #[arg(value_name = "BLUEPRINT|ITEMS")]
    given: Option<PathBuf>,
    #[command(flatten)]
    filter: Filter,
    /// Variants of each question; else as many as the blueprint says, or 10.
    #[arg(long, value_name = "COUNT")]
    variants: Option<NonZeroU32>,
    /// Write parts that the platform cannot mark as essay questions.
    #[arg(long)]
    essay: bool,
    /// Write questions for one number so that units are typed and read (Moodle).
    #[arg(long)]
    units: bool,
    /// How formulas are written.
    #[arg(long, value_name = "NOTATION", default_value = "mathml")]
    formulas: Notation,
    /// The version of QTI: 1.2 for Canvas, 2.1, 2.2 or 3.0.
    #[arg(long, value_name = "VERSION", default_value = "2.1")]
    qti: QtiVersion,
    /// The file to write, else `questions.xml` or `questions.zip`; the manifest goes beside it.
    #[arg(short, long, value_name = "FILE")]
    out: Option<PathBuf>,
    #[command(flatten)]
    bank: BankArgument,
}

/// A course platform.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Platform {
    /// Moodle XML with cloze questions.
    Moodle,
    /// A content package of QTI.
    Qti,
}

/// The version of the QTI standard that a package follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum QtiVersion {
    /// As Canvas reads it.
    #[value(name = "1.2")]
    V12,
    /// Read most widely.
    #[value(name = "2.1")]
    V21,
    #[value(name = "2.2")]
    V22,
    #[value(name = "3.0")]
    V30,
}

/// How formulas are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Notation {
    /// MathML, which browsers typeset.
    Mathml,
    /// TeX between `\(` and `\)`, for platforms that typeset it.
    Tex,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let catalogue = arguments.bank.catalogue()?;
    let made = match arguments.given.as_deref().map(Given::of) {
        Some(Given::Blueprint(path)) if arguments.filter.is_open() => {
            of_blueprint(path, arguments, &catalogue)?
        }
        Some(Given::Blueprint(_)) => {
            return Err(
                Failure::new("questions are exported of a blueprint or of a filter")
                    .help("give one of the two"),
            );
        }
        Some(Given::Word(word)) => of_filter(Some(word), arguments, &catalogue)?,
        None => of_filter(None, arguments, &catalogue)?,
    };
    let (export, record) = match made {
        Ok(made) => made,
        Err(findings) => return bank::refuse(&findings),
    };
    let out = arguments.out.clone().unwrap_or_else(|| {
        PathBuf::from(match arguments.platform {
            Platform::Moodle => "questions.xml",
            Platform::Qti => "questions.zip",
        })
    });
    report(&*export, &out, arguments.essay);
    let bytes = export.finish();
    let bytes = bytes.map_err(|error| Failure::new(format!("`{}`: {error}", out.display())))?;
    // Both hold the keys.
    let manifest = out.with_extension("manifest.json");
    files::write(&manifest, record.finish().as_bytes(), Access::Private)?;
    files::write(&out, &bytes, Access::Private)?;
    Ok(Outcome::Done)
}

/// What was made and its manifest, or what is wrong with the blueprint.
type MadeExport = Result<(Box<dyn Export>, Record), Vec<Finding>>;

/// A file with nothing in it yet.
fn begin(arguments: &Arguments, wish: Wish) -> Box<dyn Export> {
    let wish = Wish {
        formulas: match arguments.formulas {
            Notation::Mathml => Formulas::MathMl,
            Notation::Tex => Formulas::Tex,
        },
        has_essays: arguments.essay,
        has_units: arguments.units,
        ..wish
    };
    match arguments.platform {
        Platform::Moodle => Box::new(Moodle::new(wish)),
        Platform::Qti => {
            let version = match arguments.qti {
                QtiVersion::V12 => return Box::new(Canvas::new(wish)),
                QtiVersion::V21 => Version::V21,
                QtiVersion::V22 => Version::V22,
                QtiVersion::V30 => Version::V30,
            };
            Box::new(Qti::new(wish, version))
        }
    }
}

/// The questions of a blueprint, a category each.
fn of_blueprint(
    path: &Path,
    arguments: &Arguments,
    catalogue: &Catalogue,
) -> Result<MadeExport, Failure> {
    let source = file_kind::blueprint(path)?;
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
    let mut export = begin(
        arguments,
        Wish {
            title: blueprint.title.clone(),
            language: blueprint.language.value.clone(),
            data: blueprint.data,
            ..Wish::default()
        },
    );
    let language = Language::of(&blueprint.language.value).unwrap_or_default();
    let mut record = Record::of(catalogue, &blueprint, plan.secret.is_some());
    for place in 0..plan.questions.len() {
        let number = place + 1;
        export.category(&[&language.phrase(&Phrase::Question(number))]);
        for sheet in &sheets {
            let mut questions = sheet.questions.iter();
            if let Some(question) = questions.find(|own| own.place == place) {
                export.add(sheet, question, number);
                record.add(sheet, question, number);
            }
        }
    }
    Ok(Ok((export, record)))
}

/// The items that pass the filter, a category each.
fn of_filter(
    word: Option<&str>,
    arguments: &Arguments,
    catalogue: &Catalogue,
) -> Result<MadeExport, Failure> {
    let items = arguments.filter.items_of(word, catalogue)?;
    let language = &catalogue.bank.language;
    let mut export = begin(
        arguments,
        Wish {
            title: catalogue.bank.title.clone(),
            language: language.clone(),
            ..Wish::default()
        },
    );
    let mut record = Record::new(catalogue);
    for (place, item) in items.into_iter().enumerate() {
        let id = item.id.as_str();
        // Each by itself: on one sheet all would have to be suitable with the same code.
        let text = format!(
            "title = 'T'\nlanguage = '{language}'\nseed = 1\nvariants = 1\n[[question]]\nitem = '{id}'\n"
        );
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
        export.category(&[chapter, &item.about.title]);
        for sheet in &sheets {
            for question in &sheet.questions {
                export.add(sheet, question, place + 1);
                record.add(sheet, question, place + 1);
            }
        }
    }
    Ok(Ok((export, record)))
}

fn count(arguments: &Arguments, stated: usize) -> usize {
    arguments
        .variants
        .map_or(stated, |count| count.get() as usize)
}

/// The sheets of a plan.
fn sheets<'c>(plan: &Plan<'c>, count: usize) -> Result<Vec<Sheet<'c>>, Failure> {
    let mut chooser = Chooser::new(plan, &[], std::collections::BTreeMap::new());
    for index in 0..count as u64 {
        let mut from = 0;
        loop {
            let candidate = chooser.propose(index, from).map_err(Failure::of)?;
            if chooser.take(&candidate) {
                break;
            }
            from = candidate.next_attempt();
        }
    }
    let variants: Vec<_> = chooser.taken().collect();
    variants
        .into_iter()
        .map(|variant| Sheet::draw(plan, variant, None).map_err(Failure::of))
        .collect()
}

fn report(export: &dyn Export, out: &Path, has_essays: bool) {
    let tally = export.tally();
    println!(
        "{}: {} with {} to be marked there",
        out.display(),
        counted(tally.questions, "question"),
        counted(tally.boxes, "box"),
    );
    if tally.unfit.is_empty() {
        return;
    }
    let what = match (tally.unfit.len(), has_essays) {
        (1, true) => "is an essay, which a person marks",
        (_, true) => "are essays, which a person marks",
        (1, false) => {
            "is not exported, since platforms cannot mark it; `--essay` makes it an essay"
        }
        (_, false) => {
            "are not exported, since platforms cannot mark them; `--essay` makes them essays"
        }
    };
    eprintln!("{} {what}:", counted(tally.unfit.len(), "part"));
    for unfit in &tally.unfit {
        eprintln!("  {}/{}  {}", unfit.item, unfit.part, unfit.reason);
    }
}
