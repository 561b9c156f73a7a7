//! `vibank sheet BLUEPRINT`

mod choice;
mod format;
mod guard;
mod key_book;
mod known;
mod ledger;
mod make;
mod make_up;
mod outputs;
mod print;
mod stamp;
mod trace;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use serde_json::json;
use vibank::seed::Secret;
use vibank::worksheet::{Audience, Blueprint, Choice, Chooser, Fairness, Plan, Student};

pub(crate) use self::choice::FormatChoice;
pub(crate) use self::guard::{KEPT, MANIFESTS, MARKS};
pub(crate) use self::ledger::RunMark;
pub(crate) use self::print::FOLDER as PRINTS;
pub(crate) use self::stamp::{PROGRAM, Stamp};

use self::known::KnownFiles;
use self::ledger::Ledger;
use self::make::{Job, Made};
use self::make_up::MakeUp;
use self::outputs::Outputs;
use super::bank::{self, BankArgument};
use super::files::Access;
use super::folder::Folder;
use super::record::{Origin, Record};
use super::shard::Shard;
use super::table::Dialect;
use super::{Failure, Format, Outcome, class_list, counted, file_kind, files, form};

/// Make the sheets of a blueprint, with keys, worked solutions, a response form and a manifest.
///
/// A run that was interrupted continues where it stopped; what is there already and would come out the same is left
/// as it is.
///
/// Example: vibank sheet examples/midterm.toml --out midterm
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The blueprint; `vibank new sheet FILE` begins one.
    blueprint: PathBuf,
    /// The folder to write to; named after the blueprint if left out.
    #[arg(short, long, value_name = "FOLDER")]
    out: Option<PathBuf>,
    /// A file for each sheet, in place of one file for all.
    #[arg(long)]
    split: bool,
    /// Make one part of the sheets, such as 2/4, with `--split`; then a run without it joins the parts.
    #[arg(long, value_name = "I/N", default_value_t)]
    shard: Shard,
    /// A folder with page layouts of your own, `FORMAT/worksheet.EXT` and so on.
    #[arg(long, value_name = "FOLDER")]
    layouts: Option<PathBuf>,
    /// Overwrite files that were edited, and a run that has answers or marks; a copy of them is kept.
    #[arg(long)]
    force: bool,
    /// Print codes alone, no names, and write which student has which code to this file and nowhere else.
    #[arg(long, value_name = "FILE")]
    pseudonyms: Option<PathBuf>,
    /// Make other sheets for these students of the class list, by id: a make-up exam, with no datum that they had.
    #[arg(
        long,
        value_name = "STUDENT",
        value_delimiter = ',',
        conflicts_with = "pseudonyms"
    )]
    make_up: Vec<String>,
    /// The manifest of the run whose sheets these students had, or its folder; if left out, that in the folder named after
    /// the blueprint.
    #[arg(long, value_name = "MANIFEST", requires = "make_up", value_parser = file_kind::manifest())]
    first: Option<PathBuf>,
    /// How many threads work; all cores if left out.
    #[arg(long, value_name = "NUMBER", value_parser = clap::value_parser!(u16).range(1..=MAX_THREADS as i64))]
    threads: Option<u16>,
    /// How the summary is printed.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    /// Print what the first sheet computed and what it did not.
    #[arg(long)]
    trace: bool,
    #[command(flatten)]
    bank: BankArgument,
}

/// Most threads that are started: beyond this many none has anything to do.
pub(crate) const MAX_THREADS: u64 = 512;

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let path = &arguments.blueprint;
    let source = file_kind::blueprint(path)?;
    let blueprint = match Blueprint::read(&source) {
        Ok(blueprint) => blueprint,
        Err(findings) => return bank::refuse(&findings),
    };
    bank::print(&blueprint.warnings);
    check_pseudonyms(arguments, &blueprint)?;
    let catalogue = arguments.bank.catalogue()?;
    let mut choices = blueprint.questions.iter().map(|question| &question.choice);
    if choices.any(|choice| matches!(choice, Choice::Pick { .. })) {
        bank::read_all(&catalogue);
    }
    let folder = path.parent().unwrap_or(Path::new("."));
    let mut plan = match Plan::of(&blueprint, &catalogue, secret(&blueprint)?) {
        Ok(plan) => plan,
        Err(findings) => return bank::refuse(&findings),
    };
    bank::print(&plan.warnings);
    let mut students = students(&blueprint, folder)?;
    let make_up = if arguments.make_up.is_empty() {
        None
    } else {
        check_make_up(&blueprint)?;
        let own = MakeUp::of(arguments, std::mem::take(&mut students))?;
        make_up::SITTING.clone_into(&mut plan.sitting);
        students.clone_from(&own.students);
        Some(own)
    };
    let choice = FormatChoice::of(&blueprint, arguments.shard)?;
    let named: &[Student] = match arguments.pseudonyms {
        Some(_) => &[],
        None => &students,
    };
    let fonts = blueprint.fonts.as_ref();
    let fonts = fonts.map(|fonts| folder.join(&fonts.value));
    let choice = choice.with_names(named, fonts.as_deref())?;
    let count = match blueprint.audience {
        Audience::Variants(count) => count,
        // Spare sheets are those of the first run.
        Audience::Students(_) if make_up.is_some() => students.len(),
        Audience::Students(_) => students.len() + blueprint.spares,
    };
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(arguments.threads.map_or(0, usize::from))
        .build();
    let pool = pool.map_err(|error| Failure::new(format!("cannot start threads: {error}")))?;
    let run = SheetRun {
        arguments,
        plan: &plan,
        choice: &choice,
        students: &students,
        make_up: make_up.as_ref(),
        out: &Folder::at(&out(arguments)),
        is_split: arguments.split || !arguments.shard.is_whole(),
    };
    let mut summary = pool.install(|| run.make(&catalogue, count))?;
    let screens = pool.install(|| run.screens(&catalogue))?;
    summary.files.extend(screens);
    if arguments.trace {
        trace::first_sheet(&plan)?;
    }
    summary.print(arguments, &plan);
    let is_whole = summary.report_unprinted(&choice);
    Ok(if is_whole {
        Outcome::Done
    } else {
        Outcome::Unprinted
    })
}

/// One run: what it makes of what, and where.
struct SheetRun<'a, 'c> {
    arguments: &'a Arguments,
    plan: &'a Plan<'c>,
    choice: &'a FormatChoice,
    students: &'a [Student],
    make_up: Option<&'a MakeUp>,
    out: &'a Folder,
    is_split: bool,
}

impl SheetRun<'_, '_> {
    fn make(
        &self,
        catalogue: &vibank::bank::Catalogue,
        count: usize,
    ) -> Result<RunSummary, Failure> {
        let shard = self.arguments.shard;
        let layouts = self.arguments.layouts.as_deref();
        let named = match self.arguments.pseudonyms {
            Some(_) => &[],
            None => self.students,
        };
        let formats = format::formats(self.plan, self.choice, named, layouts, self.is_split)?;
        let stamp = Stamp::of(self.plan, self.students, catalogue, &formats).for_run(
            self.is_split,
            shard,
            self.arguments.pseudonyms.is_some(),
            self.make_up.map(|own| own.digest.as_str()),
        );
        let known = KnownFiles::in_folder(self.out);
        let has_key = self
            .arguments
            .pseudonyms
            .as_ref()
            .is_none_or(|path| path.is_file());
        if has_key && known.is_current(self.out, shard, &stamp) {
            return Ok(RunSummary::unchanged(self.out, shard.share(count).len()));
        }
        let share = shard.share(count);
        // Not before: a run that is refused leaves no empty folder.
        self.out.make()?;
        let (ledger, mark) = Ledger::open(self.out, shard, &stamp.inputs)?;
        let held = known.of(shard);
        guard::make_room(self.out, held, &stamp, shard, self.arguments.force)?;
        let keeps_form = guard::keeps_form(self.out, held, &stamp)?;
        let form = held
            .map(|held| held.form().to_owned())
            .filter(|_| keeps_form);
        let outputs = Outputs::open(&formats, self.out, shard, &mark)?;
        let origin = Origin {
            plan: self.plan,
            catalogue,
            choice: self.choice,
            shard,
            stamp: &stamp,
        };
        let record = Record::open(self.out, origin, &mark, form)?;
        let job = Job {
            plan: self.plan,
            students: self.students,
            count,
            has_pseudonyms: self.arguments.pseudonyms.is_some(),
            fixed: known.fixed(
                self.plan,
                self.students,
                Chooser::max_tries(self.make_up.is_some()),
            ),
            earlier: self
                .make_up
                .map(|own| own.earlier.clone())
                .unwrap_or_default(),
            formats: &formats,
            known: known.for_look(&stamp.look),
            out: self.out,
            layouts,
            is_whole: shard.is_whole(),
        };
        let made = job.make(
            share,
            &mark,
            make::Store {
                ledger,
                outputs,
                record,
            },
        )?;
        let kept = known.tidy(self.out, shard, &self.choice.kept());
        if let Some(path) = &self.arguments.pseudonyms {
            self.write_key(path, &made)?;
        }
        Ok(RunSummary::of(self.out, made, kept))
    }
}

impl SheetRun<'_, '_> {
    /// Makes the sheets of students whose class list says `format = screen` as pages on which they are answered.
    fn screens(
        &self,
        catalogue: &vibank::bank::Catalogue,
    ) -> Result<Option<(String, &'static str)>, Failure> {
        let wanted: BTreeSet<&str> = self
            .students
            .iter()
            .filter(|student| {
                student.columns.iter().any(|(name, value)| {
                    name.eq_ignore_ascii_case("format")
                        && value.trim().eq_ignore_ascii_case("screen")
                })
            })
            .map(|student| student.id.as_str())
            .collect();
        if wanted.is_empty() || !self.arguments.shard.is_whole() {
            return Ok(None);
        }
        if self.arguments.pseudonyms.is_some() {
            eprintln!(
                "a run without names makes no pages for `format = screen`: `vibank form` makes them by code"
            );
            return Ok(None);
        }
        let manifest = super::grade::manifest(&self.out.path("manifest.json")?)?;
        let whose = manifest.variants.iter().filter_map(|variant| {
            let id = variant.student.as_ref()?.get("id")?;
            wanted.contains(id.as_str()).then(|| variant.code.clone())
        });
        let codes: BTreeSet<String> = whose.collect();
        let is_wanted = |code: &str| codes.contains(code);
        form::pages(&manifest, catalogue, &is_wanted, self.out, form::SCREEN)?;
        Ok(Some((
            form::SCREEN.to_owned(),
            "sheets that are answered on a screen",
        )))
    }

    /// Writes which student has which code.
    fn write_key(&self, path: &Path, made: &Made) -> Result<(), Failure> {
        let blueprint = self.plan.blueprint;
        let dialect = Dialect::new(blueprint.csv, blueprint.decimal);
        let mut table = dialect.head(&["code", "id", "name", "group", "seat"])?;
        for (student, variant) in self.students.iter().zip(&made.variants) {
            let Student {
                id,
                name,
                group,
                seat,
                ..
            } = student;
            table.extend(dialect.line(&[&variant.to_string(), id, name, group, seat])?);
        }
        files::write(path, &table, Access::Private)
    }
}

/// Only students of a list can be named, and their data follow from the seed alone.
fn check_make_up(blueprint: &Blueprint) -> Result<(), Failure> {
    match blueprint.audience {
        Audience::Students(_) => Ok(()),
        Audience::Variants(_) => Err(Failure::new("there are no students who could be named")
            .help("name a class list with `students`, or make another run with another `seed`")),
    }
}

/// Pseudonyms are refused where they would hide nothing.
fn check_pseudonyms(arguments: &Arguments, blueprint: &Blueprint) -> Result<(), Failure> {
    let Some(path) = &arguments.pseudonyms else {
        return Ok(());
    };
    if blueprint.secret.is_none() {
        return Err(Failure::new(
            "without a secret everybody can tell by trying which student has which code",
        )
        .help("make one with `vibank new secret FILE`, and name it in the blueprint"));
    }
    if matches!(blueprint.audience, Audience::Variants(_)) {
        return Err(Failure::new("there are no students to give pseudonyms to")
            .help("name a class list with `students`, or remove `--pseudonyms`"));
    }
    if path.starts_with(out(arguments)) {
        return Err(Failure::new("the run is to know no names")
            .help("write the file of pseudonyms to another folder"));
    }
    Ok(())
}

/// What a run tells in the end.
struct RunSummary {
    folder: PathBuf,
    sheets: usize,
    /// Sheets whose files were there and are left as they are.
    unchanged: usize,
    rejected: u64,
    /// The item whose data were not suitable most often, with how often.
    unsuitable: Option<(String, u64)>,
    /// Sheets on which a wrong method may come within a tolerance.
    lenient: u64,
    /// Nothing where nothing was made.
    fairness: Option<Fairness>,
    /// Each with what it is.
    files: Vec<(String, &'static str)>,
    /// Files that could not be printed, and why.
    unprinted: Vec<String>,
    /// Files of an earlier run that this one would have renewed with a press.
    kept: usize,
}

impl RunSummary {
    fn of(out: &Folder, made: Made, kept: usize) -> Self {
        Self {
            folder: out.root().to_owned(),
            sheets: made.sheets,
            unchanged: made.unchanged,
            rejected: made.rejected,
            unsuitable: made.unsuitable,
            lenient: made.lenient,
            fairness: Some(made.fairness),
            files: made.shown,
            unprinted: made.unprinted,
            kept,
        }
    }

    fn unchanged(out: &Folder, count: usize) -> Self {
        Self {
            folder: out.root().to_owned(),
            sheets: count,
            unchanged: count,
            rejected: 0,
            unsuitable: None,
            lenient: 0,
            fairness: None,
            files: Vec::new(),
            unprinted: Vec::new(),
            kept: 0,
        }
    }

    fn print(&self, arguments: &Arguments, plan: &Plan<'_>) {
        if arguments.format == Format::Json {
            let files = self.files.iter().map(|(file, _)| file);
            let summary = json!({
                "folder": self.folder,
                "sheets": self.sheets,
                "unchanged": self.unchanged,
                "questions": plan.questions.len(),
                "rejected": self.rejected,
                "unsuitable": self.unsuitable,
                "lenient": self.lenient,
                "fairness": self.fairness,
                "files": files.collect::<Vec<_>>(),
                "unprinted": self.unprinted,
            });
            return println!("{summary}");
        }
        println!(
            "{} of {} in {}",
            counted(self.sheets, "sheet"),
            counted(plan.questions.len(), "question"),
            self.folder.display()
        );
        let widths = self.files.iter().map(|(file, _)| file.chars().count());
        let width = widths.max().unwrap_or(0).max(18);
        for (file, what) in &self.files {
            println!("  {file:<width$} {what}");
        }
        let gave_way = self.fairness.iter().flat_map(|fairness| &fairness.gave_way);
        let gave_way: Vec<&str> = gave_way.map(String::as_str).collect();
        if !gave_way.is_empty() {
            /// Students who are named here; the page on fairness names all.
            const MAX_COUNT: usize = 12;
            let more = gave_way.len().saturating_sub(MAX_COUNT);
            let names = gave_way[..gave_way.len() - more].join(", ");
            let more = if more > 0 {
                format!(" and {more} more")
            } else {
                String::new()
            };
            eprintln!(
                "gave way, since their first variant repeats what another student has: {names}{more}; without this manifest they may get other sheets when the list changes"
            );
        }
        if plan.secret.is_none() {
            eprintln!(
                "whoever has this program can turn a printed code into its key; for an exam use a secret: `vibank new secret FILE`"
            );
        }
        if self.unchanged > 0 {
            eprintln!("{} unchanged", counted(self.unchanged, "sheet"));
        }
        if self
            .fairness
            .as_ref()
            .is_some_and(|fairness| !fairness.is_fair())
        {
            eprintln!("the variants are not all alike: see the page on fairness");
        }
        if self.lenient > 0 {
            eprintln!(
                "no seed suits all questions of {}: there a wrong method may come within the tolerance of an answer; ask fewer questions on a sheet",
                counted(self.lenient as usize, "sheet")
            );
        }
        if self.rejected > 0 {
            let were = if self.rejected == 1 { "was" } else { "were" };
            let seeds = counted(self.rejected as usize, "seed");
            let most = self.unsuitable.as_ref();
            let most = most.map(|(item, count)| format!(", {count} of them for {item}"));
            eprintln!(
                "{seeds} {were} not suitable and passed over{}",
                most.unwrap_or_default()
            );
        }
    }
}

impl RunSummary {
    /// Reports what was not printed; whether all that was named is there.
    fn report_unprinted(&self, choice: &FormatChoice) -> bool {
        /// Lines of one kind: with them a teacher sees what is wrong, the rest is counted.
        const SHOWN: usize = 10;
        for line in self.unprinted.iter().take(SHOWN) {
            eprintln!("error: {line}");
        }
        if self.unprinted.len() > SHOWN {
            eprintln!("and {} more", self.unprinted.len() - SHOWN);
        }
        if let Some(line) = choice.faces.remark().filter(|_| !self.files.is_empty()) {
            eprintln!("warning: {line}");
        }
        let skipped = choice.remark();
        let is_whole = self.unprinted.is_empty() && !matches!(skipped, Some(Err(_)));
        match skipped {
            Some(Err(failure)) => eprintln!("{}", failure.to_string().trim_end()),
            Some(Ok(line)) if !self.files.is_empty() => eprintln!("{}", line.trim_end()),
            _ => {}
        }
        if self.kept > 0 {
            let (files, were) = if self.kept == 1 {
                ("file", "was")
            } else {
                ("files", "were")
            };
            eprintln!(
                "{} PDF or LaTeX {files} of an earlier run {were} not renewed",
                self.kept
            );
        }
        is_whole
    }
}

/// The folder to write to.
fn out(arguments: &Arguments) -> PathBuf {
    let blueprint = &arguments.blueprint;
    arguments
        .out
        .clone()
        .unwrap_or_else(|| match arguments.make_up[..] {
            [] => blueprint.file_stem().unwrap_or("sheet".as_ref()).into(),
            _ => make_up::folder(blueprint),
        })
}

/// The students of the class list of a blueprint, which stands in its folder; none without a list.
pub(crate) fn students(blueprint: &Blueprint, folder: &Path) -> Result<Vec<Student>, Failure> {
    match &blueprint.audience {
        Audience::Variants(_) => Ok(Vec::new()),
        Audience::Students(list) => class_list::read(&folder.join(&list.value), &blueprint.columns),
    }
}

/// The contents of the file that keys the seeds of a blueprint, which stands beside it.
pub(crate) fn secret(blueprint: &Blueprint) -> Result<Option<Secret>, Failure> {
    let Some(file) = &blueprint.secret else {
        return Ok(None);
    };
    let path = Path::new(&*blueprint.source.path).with_file_name(&file.value);
    let help = || format!("`vibank new secret {}` makes one", path.display());
    let bytes = files::read_bytes(&path).map_err(|failure| failure.help(help()))?;
    if files::is_open_to_others(&path) {
        let shown = path.display();
        eprintln!(
            "warning: others can read the secret `{shown}`; `chmod 600 {shown}` keeps it to you"
        );
    }
    let secret = Secret::new(&bytes)
        .map_err(|error| Failure::new(format!("`{}`: {error}", path.display())).help(help()));
    secret.map(Some)
}
