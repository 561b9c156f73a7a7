//! `vibank sheet BLUEPRINT`

mod choice;
mod known;
mod ledger;
mod make;
mod outputs;
mod shard;
mod stamp;
mod trace;

use std::path::{Path, PathBuf};

use serde_json::json;
use vibank::seed::Secret;
use vibank::source::Source;
use vibank::worksheet::{Audience, Blueprint, Choice, Fairness, Plan, Student};

pub(crate) use self::choice::FormatChoice;
pub(crate) use self::ledger::Mark;
pub(crate) use self::shard::Shard;
pub(crate) use self::stamp::{PROGRAM, Stamp};

use self::known::Known;
use self::ledger::Ledger;
use self::make::{Job, Made};
use self::outputs::Outputs;
use super::bank::{self, BankArgument};
use super::record::Record;
use super::{Failure, Format, Outcome, class_list, files};

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
    #[arg(long, value_name = "FOLDER")]
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
    /// How many threads work; all cores if left out.
    #[arg(long, value_name = "NUMBER", value_parser = clap::value_parser!(u16).range(1..=512))]
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

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let path = &arguments.blueprint;
    let source = Source::new(path.display().to_string(), files::read(path)?);
    let blueprint = match Blueprint::read(&source) {
        Ok(blueprint) => blueprint,
        Err(findings) => return bank::refuse(&findings),
    };
    let catalogue = arguments.bank.catalogue()?;
    let mut choices = blueprint.questions.iter().map(|question| &question.choice);
    if choices.any(|choice| matches!(choice, Choice::Pick { .. })) {
        bank::read_all(&catalogue);
    }
    let folder = path.parent().unwrap_or(Path::new("."));
    let plan = match Plan::of(&blueprint, &catalogue, secret(&blueprint)?) {
        Ok(plan) => plan,
        Err(findings) => return bank::refuse(&findings),
    };
    let students = students(&blueprint, folder)?;
    let choice = FormatChoice::of(&blueprint, arguments.shard)?;
    let count = match blueprint.audience {
        Audience::Variants(count) => count,
        Audience::Students(_) => students.len(),
    };
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(arguments.threads.map_or(0, usize::from))
        .build();
    let pool = pool.map_err(|error| Failure::new(format!("cannot start threads: {error}")))?;
    let run = Run {
        arguments,
        plan: &plan,
        choice: &choice,
        students: &students,
        out: &out(arguments),
        is_split: arguments.split || !arguments.shard.is_whole(),
    };
    let summary = pool.install(|| run.make(&catalogue, count))?;
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
struct Run<'a, 'c> {
    arguments: &'a Arguments,
    plan: &'a Plan<'c>,
    choice: &'a FormatChoice,
    students: &'a [Student],
    out: &'a Path,
    is_split: bool,
}

impl Run<'_, '_> {
    fn make(&self, catalogue: &vibank::bank::Catalogue, count: usize) -> Result<Summary, Failure> {
        let shard = self.arguments.shard;
        let layouts = self.arguments.layouts.as_deref();
        let formats = outputs::formats(self.plan, self.choice, layouts, self.is_split)?;
        let stamp =
            Stamp::of(self.plan, self.students, catalogue, &formats).for_run(self.is_split, shard);
        let known = Known::in_folder(self.out);
        if known.is_current(self.out, shard, &stamp) {
            return Ok(Summary::unchanged(self.out, shard.share(count).len()));
        }
        let share = shard.share(count);
        let (ledger, mark) = Ledger::open(self.out, shard, &stamp.inputs)?;
        let outputs = Outputs::open(&formats, self.out, shard, &mark)?;
        let record = Record::open(
            self.out,
            shard,
            &stamp,
            self.plan,
            self.choice,
            catalogue,
            &mark,
        )?;
        let job = Job {
            plan: self.plan,
            students: self.students,
            formats: &formats,
            known: known.for_look(&stamp.look),
            out: self.out,
            layouts,
            tell_fairness: shard.is_whole(),
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
        let kept = known.tidy(self.out, shard, self.choice.kept());
        Ok(Summary::of(self.out, made, kept))
    }
}

/// What a run tells in the end.
struct Summary {
    folder: PathBuf,
    sheets: usize,
    /// Sheets whose files were there and are left as they are.
    unchanged: usize,
    rejected: u64,
    /// Nothing where nothing was made.
    fairness: Option<Fairness>,
    /// Each with what it is.
    files: Vec<(String, &'static str)>,
    /// Files that could not be printed, and why.
    unprinted: Vec<String>,
    /// Files of an earlier run that this one would have renewed with a press.
    kept: usize,
}

impl Summary {
    fn of(out: &Path, made: Made, kept: usize) -> Self {
        Self {
            folder: out.to_owned(),
            sheets: made.sheets,
            unchanged: made.unchanged,
            rejected: made.rejected,
            fairness: Some(made.fairness),
            files: made.shown,
            unprinted: made.unprinted,
            kept,
        }
    }

    fn unchanged(out: &Path, count: usize) -> Self {
        Self {
            folder: out.to_owned(),
            sheets: count,
            unchanged: count,
            rejected: 0,
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
                "fairness": self.fairness,
                "files": files.collect::<Vec<_>>(),
                "unprinted": self.unprinted,
            });
            return println!("{summary}");
        }
        let counted = |count: usize, thing: &str| {
            let plural = if count == 1 { "" } else { "s" };
            format!("{count} {thing}{plural}")
        };
        println!(
            "{} of {} in {}",
            counted(self.sheets, "sheet"),
            counted(plan.questions.len(), "question"),
            self.folder.display()
        );
        for (file, what) in &self.files {
            println!("  {file:<18} {what}");
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
        if self.rejected > 0 {
            let were = if self.rejected == 1 { "was" } else { "were" };
            let seeds = counted(self.rejected as usize, "seed");
            eprintln!("{seeds} {were} not suitable and passed over");
        }
    }
}

impl Summary {
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
    let name = || arguments.blueprint.file_stem().unwrap_or("sheet".as_ref());
    arguments.out.clone().unwrap_or_else(|| name().into())
}

fn students(blueprint: &Blueprint, folder: &Path) -> Result<Vec<Student>, Failure> {
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
    let secret = Secret::new(&files::read_bytes(&path)?);
    let secret = secret.map_err(|error| Failure::new(format!("`{}`: {error}", path.display())));
    secret.map(Some)
}
