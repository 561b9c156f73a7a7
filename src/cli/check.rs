//! `vibank check [FILE|ITEM]`

use std::path::{Path, PathBuf};

use rayon::prelude::*;
use vibank::bank::{Catalogue, ItemId, Template};
use vibank::diagnostic::{Finding, Severity};
use vibank::examine::Examination;
use vibank::instance::Instance;
use vibank::scene;
use vibank::seed::Seed;
use vibank::solution::{Solution, proof};
use vibank::source::Source;
use vibank::survey::Survey;
use vibank::worksheet::{Blueprint, Plan};

use super::bank::{self, BankArgument};
use super::watch::{self, Watch};
use super::{
    Failure, Format, Outcome, counted, file_kind, files, preview, progress, sheet, survey,
};

/// Look over a bank, or blueprints: form, names, dimensions, texts, known results; and examine each item as its
/// students meet it: mistakes, wrong methods and honest work typed and marked over many draws.
///
/// Example: vibank check --report ch4/p1-rolling-disk-hub-moment
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The items to look over, or files of items, chapters and blueprints; all of the bank without any.
    items: Vec<String>,
    #[command(flatten)]
    bank: BankArgument,
    /// Draws over which an item is examined and the two routes to each quantity are compared.
    #[arg(long, value_name = "NUMBER", default_value_t = 200, value_parser = clap::value_parser!(u64).range(0..=100_000))]
    seeds: u64,
    /// Report also what the draws look like: instances, redraws, answers, tolerances, mistakes, wrong methods.
    #[arg(long)]
    report: bool,
    /// Count these as errors, too: warnings are missing second routes, hints and solutions, and constraints that cost more than half of the draws.
    #[arg(long, value_enum, value_name = "WHAT")]
    deny: Option<Denied>,
    /// How findings and reports are printed.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    /// Look again each time a file has changed, until Ctrl-C ends it.
    #[arg(long)]
    watch: bool,
}

/// What counts as an error besides errors.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Denied {
    /// All warnings.
    Warnings,
}

/// What is to be looked over.
struct Wanted {
    /// Items, or files of them.
    items: Vec<String>,
    blueprints: Vec<Source>,
    is_all: bool,
    /// The items that are named in full: a longer name that begins alike is not meant.
    exact: Vec<String>,
}

impl Wanted {
    /// Tells the blueprints among the files from items.
    fn of(names: &[String]) -> Result<Self, Failure> {
        let (mut items, mut blueprints) = (Vec::new(), Vec::new());
        for name in names {
            let path = Path::new(name);
            let source = path
                .is_file()
                .then(|| Ok::<_, Failure>(Source::new(name.as_str(), files::read(path)?)))
                .transpose()?;
            match source {
                Some(source) if Blueprint::is_meant(&source) => blueprints.push(source),
                Some(source) => match file_kind::not_of_authors(path, &source.text) {
                    Some(failure) => return Err(failure),
                    None => items.push(name.clone()),
                },
                None => items.push(name.clone()),
            }
        }
        Ok(Self {
            items,
            blueprints,
            is_all: names.is_empty(),
            exact: Vec::new(),
        })
    }

    /// Whether an item is to be looked over.
    fn wants_item(&self, id: &ItemId) -> bool {
        self.wants(&format!("{id}.toml"))
    }

    /// Whether a file of the bank is to be looked over.
    fn wants(&self, path: &str) -> bool {
        self.is_all
            || self.items.iter().any(|item| {
                let name = inside(item);
                let name = name.trim_end_matches(".toml");
                if self.exact.iter().any(|exact| exact == name) {
                    path.strip_suffix(".toml") == Some(name)
                } else {
                    path.contains(name)
                }
            })
    }

    /// The bank with the files that are named added to it, of which the items that are wanted are read, and what is wrong
    /// with these and with the files around them; a name that leads to nothing is misuse.
    fn load(&mut self, bank: &BankArgument) -> Result<(Catalogue, Vec<Finding>), Failure> {
        let files: Vec<&Path> = self.items.iter().map(Path::new).collect();
        let files = files.into_iter().filter(|file| file.is_file());
        let texts = files.map(|file| {
            let path = inside(&file.to_string_lossy());
            Ok((path, files::read(file)?))
        });
        let texts = texts.collect::<Result<Vec<(String, String)>, Failure>>()?;
        let (catalogue, mut findings) = bank.open(&texts)?;
        let is_known = |item: &&String| {
            let path = inside(item);
            let path = path.trim_end_matches(".toml");
            let items = catalogue.ids().map(ItemId::as_str);
            let broken = findings.iter().map(|finding| &*finding.source.path);
            items.chain(broken).any(|known| known.contains(path)) || Path::new(item).is_file()
        };
        match self.items.iter().find(|item| !is_known(item)) {
            None => {
                let names = self.items.iter().map(|item| inside(item));
                let names = names.map(|name| name.trim_end_matches(".toml").to_owned());
                self.exact = names.filter(|name| catalogue.has(name)).collect();
                let ids: Vec<&ItemId> = catalogue.ids().collect();
                ids.par_iter()
                    .filter(|id| self.wants_item(id))
                    .for_each(|id| {
                        catalogue.find(id.as_str());
                    });
                findings.append(&mut catalogue.findings_among(|id| self.wants_item(id)));
                Finding::sort(&mut findings);
                Ok((catalogue, findings))
            }
            Some(unknown) => {
                let failure = Failure::new(format!("there is no item or file `{unknown}`"));
                Err(match catalogue.nearest(unknown) {
                    Some(near) => failure.help(format!("did you mean `{near}`?")),
                    None => failure.help("`vibank list` shows all items"),
                })
            }
        }
    }

    /// What is wrong with the blueprints, by themselves and with this bank.
    fn look_over_blueprints(&self, catalogue: &Catalogue, seeds: u64) -> Vec<Finding> {
        let findings = self.blueprints.iter().flat_map(|source| {
            let blueprint = match Blueprint::read(source) {
                Ok(blueprint) => blueprint,
                Err(findings) => return findings,
            };
            let mut findings = Plan::of(&blueprint, catalogue, None)
                .map_or_else(|findings| findings, |plan| plan.warnings);
            findings.extend(blueprint.warnings.iter().cloned());
            for own in blueprint.own_questions() {
                let (found, _) = look_at(&own.item, seeds);
                let errors = found.into_iter().filter(|finding| {
                    finding.severity == Severity::Error && !OF_A_BANK.contains(&finding.code.name())
                });
                findings.extend(errors.map(|finding| own.in_blueprint(finding, source)));
            }
            findings
        });
        findings.collect()
    }
}

impl Wanted {
    /// Why the files that the blueprints name, class list and secret, cannot be used.
    fn unreadable_beside(&self) -> Vec<Failure> {
        let mut failures = Vec::new();
        for source in &self.blueprints {
            let Ok(blueprint) = Blueprint::read(source) else {
                continue;
            };
            let folder = Path::new(&*source.path).parent();
            failures.extend(sheet::students(&blueprint, folder.unwrap_or(Path::new(""))).err());
            failures.extend(sheet::secret(&blueprint).err());
        }
        failures
    }
}

/// What is asked of the items of a bank, besides warnings, and of no question that a teacher writes for one exam.
const OF_A_BANK: [&str; 3] = [
    "check::few-methods",
    "check::many-questions",
    "check::same-choice",
];

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
struct Looked {
    findings: Vec<Finding>,
    examined: Examination,
    survey: Option<Survey>,
}

/// Most draws for which free-body diagrams are drawn: their places follow the data, mostly within narrow bounds.
const FREE_DRAWS: u64 = 8;

/// A free-body diagram that does not show the forces of the model, for the data of the source or of a draw.
fn unfree(item: &Template, seeds: u64) -> Option<Finding> {
    item.figure.as_ref().filter(|figure| figure.has_free())?;
    let drawn = (0..seeds.min(FREE_DRAWS)).map(Seed::new);
    let drawn = drawn.filter_map(|seed| Instance::draw(item, seed).ok());
    std::iter::once(Instance::of_source(item))
        .chain(drawn)
        .find_map(|instance| scene::unfree(&Solution::of(instance)))
}

/// What is wrong with an item whose file can be read.
fn look_at(item: &Template, seeds: u64) -> (Vec<Finding>, Examination) {
    let mut findings = proof::findings(item, seeds);
    findings.extend(scene::undrawn(item));
    findings.extend(scene::underived(item));
    findings.extend(unfree(item, seeds));
    let mut examined = Examination::of(item, seeds);
    findings.append(&mut examined.findings);
    (findings, examined)
}

/// What the known results and the second routes of the items disprove, and what their draws look like.
fn look_over(catalogue: &Catalogue, wanted: &Wanted, arguments: &Arguments) -> Vec<Looked> {
    let items: Vec<_> = catalogue.items_among(|id| wanted.wants_item(id)).collect();
    let progress = progress::bar(items.len() as u64, "items");
    let looked = items.par_iter().map(|item| {
        let (findings, examined) = look_at(item, arguments.seeds);
        let survey = arguments
            .report
            .then(|| Survey::over(item, arguments.seeds));
        progress.inc(1);
        Looked {
            findings,
            examined,
            survey,
        }
    });
    let looked = looked.collect();
    progress.finish_and_clear();
    looked
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    if !arguments.watch {
        return look(arguments);
    }
    let items = arguments.items.iter().map(PathBuf::from);
    let named: Vec<PathBuf> = items.filter(|item| item.is_file()).collect();
    let watched = || {
        let beside = named.iter().flat_map(|file| preview::beside(file));
        let named: Vec<PathBuf> = named.iter().cloned().chain(beside).collect();
        (named, arguments.bank.watched())
    };
    let mut now = watched();
    if now.0.is_empty() && now.1.is_empty() {
        return Err(Failure::new("there is no file to watch")
            .help("name a file, or a bank of your own with `--bank`"));
    }
    let mut watch = Watch::of(&now.0, &now.1);
    loop {
        // A file that cannot be read just now may be there again with the next change.
        if let Err(failure) = look(arguments) {
            eprintln!("{}", failure.to_string().trim_end());
        }
        eprintln!("waiting for changes; Ctrl-C ends");
        let changed = watch.wait();
        eprintln!("\n{}", watch::said(&changed));
        let then = std::mem::replace(&mut now, watched());
        if now != then {
            watch = Watch::of(&now.0, &now.1);
        }
    }
}

fn look(arguments: &Arguments) -> Result<Outcome, Failure> {
    let mut wanted = Wanted::of(&arguments.items)?;
    let (catalogue, mut findings) = wanted.load(&arguments.bank)?;
    let (mut surveys, mut examined) = (Vec::new(), Vec::new());
    for looked in look_over(&catalogue, &wanted, arguments) {
        findings.extend(looked.findings);
        surveys.extend(looked.survey);
        examined.push(looked.examined);
    }
    let exceptions: usize = examined.iter().map(|own| own.allowed.len()).sum();
    findings.retain(|finding| wanted.wants(&finding.source.path));
    findings.extend(wanted.look_over_blueprints(&catalogue, arguments.seeds));
    arguments.bank.name_in_help(&mut findings);
    let unreadable = wanted.unreadable_beside();
    Finding::sort(&mut findings);
    match arguments.format {
        Format::Text => {
            bank::print(&findings);
            let with_parts = arguments.report && !arguments.items.is_empty();
            survey::print(&surveys, !arguments.items.is_empty());
            survey::print_examined(if with_parts { &examined } else { &[] });
        }
        Format::Json => println!(
            "{}",
            serde_json::to_string(&Looks {
                findings: &findings,
                items: &surveys,
                examined: if arguments.report { &examined } else { &[] },
            })
            .expect("findings and surveys are plain data")
        ),
    }
    for failure in &unreadable {
        eprintln!("{}\n", failure.to_string().trim_end());
    }
    let count = |severity| {
        findings
            .iter()
            .filter(|finding| finding.severity == severity)
            .count()
    };
    let errors = count(Severity::Error) + unreadable.len();
    let warnings = count(Severity::Warning);
    let things = match wanted.blueprints.len() {
        count if count == arguments.items.len() && count > 0 => counted(count, "blueprint"),
        _ => counted(examined.len(), "item"),
    };
    eprintln!(
        "{things}, {}, {}",
        counted(errors, "error"),
        counted(warnings, "warning")
    );
    if exceptions > 0 {
        eprintln!(
            "{} with a reason in the item",
            counted(exceptions, "exception")
        );
    }
    let is_denied = warnings > 0 && arguments.deny == Some(Denied::Warnings);
    Ok(if errors > 0 || is_denied {
        Outcome::Findings
    } else {
        Outcome::Done
    })
}

/// What programs get.
#[derive(serde::Serialize)]
struct Looks<'a> {
    findings: &'a [Finding],
    /// With `--report`, one for each item.
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    items: &'a [Survey],
    /// With `--report`, one for each item.
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    examined: &'a [Examination],
}
