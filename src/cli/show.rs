//! `vibank show ITEM|CODE`

use std::path::{Path, PathBuf};

use vibank::bank::{Catalogue, Part};
use vibank::instance::Instance;
use vibank::message::Language;
use vibank::scene::{Data, Scene, Shown};
use vibank::seed::{Seed, Variant};
use vibank::solution::Solution;
use vibank::suitability;
use vibank::worksheet::{Blueprint, PartEntry, Plan, Sheet, headings, letter};

use super::bank::{self, BankArgument};
use super::{Failure, Outcome, file_kind, package, solve};

/// Show an item, or the sheet of a code, in the terminal.
///
/// Example: vibank show ch3/e5-log-decrement --seed 7 --solution
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The item, the code of a sheet, or with `--learner` the file of a package.
    item: String,
    /// The manifest in which a code is looked up, or the folder of its run.
    #[arg(long, value_name = "FILE", value_parser = file_kind::manifest())]
    manifest: Option<PathBuf>,
    /// The blueprint whose sheet a code is, its bank has to be as it was then; or that of a package with questions of its
    /// own.
    #[arg(long, value_name = "FILE", conflicts_with = "manifest")]
    blueprint: Option<PathBuf>,
    /// The data of this learner in a SCORM package, which is named in place of an item.
    #[arg(long, value_name = "ID", value_parser = clap::builder::NonEmptyStringValueParser::new(), conflicts_with_all = ["manifest", "seed", "set"])]
    learner: Option<String>,
    /// Draw the data from this seed; else those of the source are shown.
    #[arg(short, long)]
    seed: Option<u64>,
    /// A value for a parameter, such as m=2kg.
    #[arg(long = "set", value_name = "NAME=VALUE")]
    set: Vec<String>,
    /// Show the answers.
    #[arg(long)]
    key: bool,
    /// Show hints and worked solution.
    #[arg(long)]
    solution: bool,
    /// Print what was computed and what was not.
    #[arg(long)]
    trace: bool,
    #[command(flatten)]
    bank: BankArgument,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let of_package = arguments
        .learner
        .as_ref()
        .and(arguments.blueprint.as_deref());
    let catalogue = arguments.bank.catalogue_with(of_package)?;
    if let Some(learner) = &arguments.learner {
        return of_learner(arguments, learner, &catalogue);
    }
    if let Some(template) = catalogue.find(&arguments.item) {
        let set = solve::settings(&arguments.set)?;
        let set: Vec<(&str, &str)> = set
            .iter()
            .map(|(name, value)| (name.as_str(), value.as_str().unwrap_or_default()))
            .collect();
        let instance =
            Instance::of(template, arguments.seed.map(Seed::new), &set).map_err(Failure::of)?;
        let solution = Solution::of(instance);
        let parts = asked(&solution);
        show(arguments, &solution, Data::Both, &parts);
        if !set.is_empty() {
            warn_of_slips(&solution, &parts);
        }
        return Ok(Outcome::Done);
    }
    if let Some(blueprint) = &arguments.blueprint {
        return of_blueprint(arguments, blueprint, &catalogue);
    }
    let Some(manifest) = &arguments.manifest else {
        let wanted = &arguments.item;
        if catalogue.has(wanted) {
            let failure =
                Failure::new(format!("there is something wrong with the item `{wanted}`"));
            return Err(failure.help(format!("`vibank check {wanted}` shows what it is")));
        }
        if let Some(failure) = file_kind::not_an_item(wanted) {
            return Err(failure);
        }
        let failure = Failure::new(format!("there is no item `{wanted}`"));
        let is_code = arguments.item.parse::<Variant>().is_ok();
        return Err(match catalogue.nearest(wanted) {
            _ if is_code => failure.help(
                "for the code of a sheet give its manifest: `--manifest FOLDER/manifest.json`, \
                 or its `--blueprint`",
            ),
            Some(near) => failure.help(format!("did you mean `{near}`?")),
            None => failure.help("`vibank list` shows all items"),
        });
    };
    let manifest = super::grade::manifest(manifest)?;
    let code = code(arguments)?;
    let entry = manifest
        .variants
        .iter()
        .find(|variant| variant.code == code.to_string());
    let entry = entry.ok_or_else(|| Failure::new(format!("the manifest has no sheet {code}")))?;
    let items =
        super::grade::RunItems::of(std::slice::from_ref(&manifest.items), &catalogue, false);
    for question in &entry.questions {
        println!("Question {}", question.number);
        let solution = super::grade::solution(&items, question, manifest.decimal, manifest.doubt)?;
        let place = |part: &PartEntry| solution.template().place(&part.id);
        let places: Vec<usize> = question.parts.iter().filter_map(place).collect();
        show(arguments, &solution, manifest.data, &places);
    }
    Ok(Outcome::Done)
}

/// Data that are given are shown whatever they are; sheets are drawn with others where a slip would come out right.
fn warn_of_slips(solution: &Solution<'_>, parts: &[usize]) {
    for part in parts {
        let part = std::slice::from_ref(part);
        let judged = suitability::judge(solution, part);
        if let Err(unfit) = judged.and_then(|()| suitability::judge_methods(solution, part)) {
            eprintln!("warning: with these data, {unfit}");
        }
    }
}

/// Shows the sheet that a code is of a blueprint.
fn of_blueprint(
    arguments: &Arguments,
    path: &Path,
    catalogue: &Catalogue,
) -> Result<Outcome, Failure> {
    let source = file_kind::blueprint(path)?;
    let blueprint = match Blueprint::read(&source) {
        Ok(blueprint) => blueprint,
        Err(findings) => return bank::refuse(&findings),
    };
    let secret = super::sheet::secret(&blueprint)?;
    let plan = match Plan::of(&blueprint, catalogue, secret) {
        Ok(plan) => plan,
        Err(findings) => return bank::refuse(&findings),
    };
    let sheet = Sheet::draw(&plan, code(arguments)?, None);
    let sheet = sheet.map_err(Failure::of)?;
    for question in &sheet.questions {
        println!("Question {}", question.number);
        show(
            arguments,
            &question.solution,
            blueprint.data,
            &question.parts,
        );
    }
    Ok(Outcome::Done)
}

/// Shows what a learner has in a package.
fn of_learner(
    arguments: &Arguments,
    learner: &str,
    catalogue: &Catalogue,
) -> Result<Outcome, Failure> {
    let package = package::read(Path::new(&arguments.item), catalogue)?;
    for (place, question) in package.practice.questions.iter().enumerate() {
        let key = question.key();
        let code = package.variant(place, learner)?;
        println!("{key}  {code}");
        let template = package::current(catalogue, question)?;
        let set: Vec<(&str, &str)> = question
            .set
            .iter()
            .map(|(name, value)| (name.as_str(), value.as_str()))
            .collect();
        let seed = code.item(template.id.as_str(), None);
        let instance = Instance::of(template, Some(seed), &set).map_err(Failure::of)?;
        let solution = Solution::of(instance);
        let mut places = asked(&solution);
        places.retain(|place| question.asks(&template.parts[*place]));
        show(arguments, &solution, package.practice.data, &places);
    }
    Ok(Outcome::Done)
}

/// The code that was given.
fn code(arguments: &Arguments) -> Result<Variant, Failure> {
    let code = arguments.item.parse::<Variant>();
    code.map_err(|error| Failure::new(format!("`{}`: {error}", arguments.item)))
}

/// The parts of an item that are asked for these data.
fn asked(solution: &Solution<'_>) -> Vec<usize> {
    let places = 0..solution.template().parts.len();
    places.filter(|place| solution.asks(*place)).collect()
}

fn show(arguments: &Arguments, solution: &Solution<'_>, data: Data, parts: &[usize]) {
    let template = solution.template();
    let scene = Scene::of(solution, data).in_words();
    println!(
        "{}  ({})\n",
        template.about.title,
        solution.instance().identity()
    );
    println!("{}", text(&scene.passage(&template.statement)));
    if arguments.solution {
        let before = text(&scene.passage(&template.solution));
        if !before.is_empty() {
            println!("\n{before}");
        }
    }
    for (heading, place) in headings(template, parts).iter().zip(parts.iter().copied()) {
        let part = &template.parts[place];
        if let Some((letter, group)) = heading.opened() {
            println!("\n{letter}) {}", text(&scene.passage(&group.text)));
            if arguments.solution {
                let hints = group.hints.iter();
                hints.for_each(|hint| println!("   hint: {}", text(&scene.passage(hint))));
                let worked = text(&scene.passage(&group.solution));
                worked.lines().for_each(|line| println!("   {line}"));
            }
        }
        println!("\n{}", called(&heading.letter, &scene, part));
        let options = part.answer.options();
        for (at, option) in solution
            .order(place)
            .into_iter()
            .enumerate()
            .filter(|_| !options.is_empty())
        {
            println!(
                "   {}  {}",
                letter(at),
                options[option].text.plain(&Vec::new())
            );
        }
        println!("   {}", answer_line(&scene, place));
        if arguments.solution {
            part.own_hints()
                .iter()
                .for_each(|hint| println!("   hint: {}", text(&scene.passage(hint))));
        }
        if arguments.key || arguments.solution {
            match scene.key(place) {
                Ok(Some(key)) => println!("   = {}", key.plain()),
                Ok(None) => println!("   = see the worked solution"),
                Err(absent) => println!("   – {absent}"),
            }
        }
        if arguments.solution {
            let worked = text(&scene.passage(&part.solution));
            worked.lines().for_each(|line| println!("   {line}"));
        }
    }
    println!();
    if arguments.trace {
        let trace = solution.trace();
        eprintln!("computed: {}", trace.computed.join(", "));
        eprintln!("skipped:  {}", trace.skipped.join(", "));
    }
}

/// A part and what it asks, `b) …`.
pub(crate) fn called(letter: &str, scene: &Scene<'_, '_>, part: &Part) -> String {
    let ask = text(&scene.passage(&part.ask));
    format!("{letter}) {ask}").trim_end().to_owned()
}

/// The line for an answer: `ω_n = ____ rad/s (value, 3 figures)`.
pub(crate) fn answer_line(scene: &Scene<'_, '_>, place: usize) -> String {
    let answer = &scene.solution().template().parts[place].answer;
    let blank = answer.blank();
    let said = Language::default().blank(&blank);
    let said = said.plain(&Vec::new()).trim_end().to_owned();
    if !answer.options().is_empty() {
        return said;
    }
    let lead = scene.lead(place).map(|lead| lead.plain());
    let unit = blank.unit_behind().map(|unit| unit.text());
    let line = [lead, Some("____".to_owned()), unit, Some(said)];
    line.into_iter().flatten().collect::<Vec<_>>().join(" ")
}

fn text(shown: &[Shown<'_>]) -> String {
    let pieces = shown
        .iter()
        .map(|piece| piece.document.plain(&piece.fillings).trim_end().to_owned());
    pieces.collect::<Vec<_>>().join("\n\n")
}
