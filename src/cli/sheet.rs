//! `vibank sheet BLUEPRINT`

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use rayon::prelude::*;
use vibank::output::{self, KeyTable, Kind, Pages, Run};
use vibank::seed::Secret;
use vibank::source::Source;
use vibank::worksheet::{Audience, Blueprint, Chooser, Chosen, Plan, Sheet, SheetError, Student};

use super::bank::{self, BankArgument};
use super::files::{self, Draft};
use super::record::Record;
use super::{Failure, Outcome, class_list, progress};

/// Make the sheets of a blueprint, with keys, worked solutions, a response form and a manifest.
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
    /// A folder with page layouts of your own, `FORMAT/worksheet.EXT` and so on.
    #[arg(long, value_name = "FOLDER")]
    layouts: Option<PathBuf>,
    /// How many threads work; all cores if left out.
    #[arg(long, value_name = "NUMBER", value_parser = clap::value_parser!(u16).range(1..=512))]
    threads: Option<u16>,
    /// Print what the first sheet computed and what it did not.
    #[arg(long)]
    trace: bool,
    #[command(flatten)]
    bank: BankArgument,
}

/// Sheets that are made at once; memory holds no more.
const CHUNK: usize = 64;

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let path = &arguments.blueprint;
    let text = files::read(path)?;
    let source = Source::new(path.display().to_string(), text);
    let blueprint = match Blueprint::read(&source) {
        Ok(blueprint) => blueprint,
        Err(findings) => return bank::refuse(&findings),
    };
    let catalogue = arguments.bank.catalogue()?;
    let folder = path.parent().unwrap_or(Path::new("."));
    let secret = blueprint
        .secret
        .as_ref()
        .map(|file| secret(&folder.join(&file.value)))
        .transpose()?;
    let plan = match Plan::of(&blueprint, &catalogue, secret) {
        Ok(plan) => plan,
        Err(findings) => return bank::refuse(&findings),
    };
    let students = match &blueprint.audience {
        Audience::Variants(_) => Vec::new(),
        Audience::Students(list) => class_list::read(&folder.join(&list.value))?,
    };
    let out = arguments
        .out
        .clone()
        .unwrap_or_else(|| PathBuf::from(path.file_stem().unwrap_or("sheet".as_ref())));
    let count = if let Audience::Variants(count) = blueprint.audience {
        count
    } else {
        students.len()
    };
    let writers = Writers::open(arguments, &blueprint, &out)?;
    let record = Record::begin(
        &out,
        &plan,
        &catalogue,
        &files::digest(source.text.as_bytes()),
    )?;
    let mut job = Job {
        plan: &plan,
        students: &students,
        writers,
        record,
        out: &out,
        is_split: arguments.split,
    };
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(arguments.threads.map_or(0, usize::from))
        .build();
    let pool = pool.map_err(|error| Failure::new(format!("cannot start threads: {error}")))?;
    let rejected = pool.install(|| job.make(count))?;
    if arguments.trace {
        trace(&plan)?;
    }
    job.finish(count, rejected)
}

/// One run.
struct Job<'a, 'c> {
    plan: &'a Plan<'c>,
    students: &'a [Student],
    writers: Writers,
    record: Record,
    out: &'a Path,
    is_split: bool,
}

/// What one sheet gives, before it is written in order.
struct Made {
    /// By format and kind: the page, or the whole file where each sheet has its own.
    pages: Vec<Vec<Vec<u8>>>,
    json: Option<String>,
    entry: super::record::Entry,
}

impl Job<'_, '_> {
    fn make(&mut self, count: usize) -> Result<u64, Failure> {
        let bar = progress::bar(count as u64, "sheets");
        let mut chooser = Chooser::new(self.plan);
        let mut done = 0;
        while done < count {
            let chosen: Vec<Chosen> = (done..count.min(done + CHUNK))
                .map(|_| chooser.choose())
                .collect::<Result<_, _>>()
                .map_err(|error| refuse(&error))?;
            let made: Vec<Result<Made, Failure>> = chosen
                .par_iter()
                .map(|chosen| self.sheet(*chosen))
                .collect();
            let made = made.into_iter().collect::<Result<Vec<_>, _>>()?;
            self.tables(&chosen)?;
            for (chosen, made) in chosen.iter().zip(made) {
                self.write(&chosen.variant.to_string(), made)?;
            }
            done += chosen.len();
            bar.set_position(done as u64);
        }
        bar.finish_and_clear();
        Ok(chooser.rejected())
    }

    fn draw(&self, chosen: Chosen) -> Result<Sheet<'_>, Failure> {
        let student = self.students.get(chosen.index as usize).cloned();
        Sheet::draw(self.plan, chosen.variant, student).map_err(|error| refuse(&error))
    }

    fn sheet(&self, chosen: Chosen) -> Result<Made, Failure> {
        let sheet = self.draw(chosen)?;
        let mut pages = Vec::new();
        for format in &self.writers.formats {
            let made = format.open.iter();
            let made = made.map(|open| format.made(open, &sheet, self.out));
            pages.push(made.collect::<Result<Vec<_>, _>>()?);
        }
        let json = self
            .writers
            .json
            .as_ref()
            .map(|_| output::json(&sheet).to_string());
        Ok(Made {
            pages,
            json,
            entry: super::record::entry(&sheet),
        })
    }

    /// The answers of a chunk of variants, for the page with all of them.
    fn tables(&mut self, chosen: &[Chosen]) -> Result<(), Failure> {
        for format in 0..self.writers.formats.len() {
            if self.writers.formats[format].table.is_none() {
                continue;
            }
            let mut table = KeyTable::default();
            for chosen in chosen {
                let sheet = self.draw(*chosen)?;
                table.add(self.writers.formats[format].pages.key_row(&sheet));
            }
            let Format {
                pages, table: file, ..
            } = &mut self.writers.formats[format];
            let page = pages.key_table(&table).map_err(fail)?;
            file.as_mut().expect("checked above").push_str(&page);
        }
        Ok(())
    }

    fn write(&mut self, code: &str, made: Made) -> Result<(), Failure> {
        let mut entry = made.entry;
        for (format, pages) in self.writers.formats.iter_mut().zip(made.pages) {
            let extension = format.pages.writer().extension();
            for (open, page) in format.open.iter_mut().zip(pages) {
                if let Some(file) = &mut open.file {
                    file.write(&page)?;
                } else {
                    let inside = format!("{}/{code}.{extension}", open.kind.folder());
                    files::write(&self.out.join(&inside), &page)?;
                    entry.file(inside, files::digest(&page));
                }
            }
        }
        if let (Some(file), Some(json)) = (&mut self.writers.json, made.json) {
            file.write(json.as_bytes())?;
            file.write(b"\n")?;
        }
        self.record.add(entry)
    }

    fn finish(self, count: usize, rejected: u64) -> Result<Outcome, Failure> {
        let mut written = Vec::new();
        for format in self.writers.formats {
            let extension = format.pages.writer().extension();
            for mut open in format.open {
                let shown = match open.file.take() {
                    Some(mut file) => {
                        file.write(format.end.as_bytes())?;
                        file.finish()?;
                        format!("{}.{extension}", open.kind.folder())
                    }
                    None => format!("{}/*.{extension}", open.kind.folder()),
                };
                written.push((shown, Pages::subtitle(open.kind)));
            }
            if let Some(table) = format.table {
                let file = format!("key-table.{extension}");
                let bytes = format
                    .pages
                    .writer()
                    .bind(table + &format.end)
                    .map_err(fail)?;
                files::write(&self.out.join(&file), &bytes)?;
                written.push((file, "answers of all variants"));
            }
        }
        if let Some(file) = self.writers.json {
            file.finish()?;
            written.push(("sheets.jsonl".to_owned(), "one sheet a line"));
        }
        self.record.finish()?;
        written.push((
            "responses.csv".to_owned(),
            "form for the answers, filled in and given to `vibank grade`",
        ));
        written.push((
            "manifest.json".to_owned(),
            "what marking needs; keep it to yourself",
        ));
        let plural = if count == 1 { "" } else { "s" };
        println!(
            "{count} sheet{plural} of {} question{} in {}",
            self.plan.questions.len(),
            if self.plan.questions.len() == 1 {
                ""
            } else {
                "s"
            },
            self.out.display()
        );
        for (file, what) in written {
            println!(
                "  {:<18} {}",
                file,
                if what.is_empty() { "the sheets" } else { what }
            );
        }
        if self.is_split || rejected > 0 {
            eprintln!("{rejected} seeds were not suitable and passed over");
        }
        Ok(Outcome::Done)
    }
}

/// The files of a run.
struct Writers {
    formats: Vec<Format>,
    json: Option<Draft>,
}

/// The files of one format.
struct Format {
    pages: Pages,
    open: Vec<Open>,
    /// The page with the answers of all variants, as far as it is written.
    table: Option<String>,
    end: String,
    /// The files of figures that are written.
    placed: Mutex<BTreeSet<String>>,
}

impl Format {
    /// The page of a sheet, or its whole file where it has one of its own.
    fn made(&self, open: &Open, sheet: &Sheet<'_>, out: &Path) -> Result<Vec<u8>, Failure> {
        let page = self.pages.page(open.kind, sheet).map_err(fail)?;
        self.place(&page.pictures, out)?;
        if open.file.is_some() {
            return Ok(page.text.into_bytes());
        }
        let whole = format!("{}{}{}", open.begin, page.text, self.end);
        self.pages.writer().bind(whole).map_err(fail)
    }

    /// Writes the figures that are files of their own, each once: its name says what is in it.
    fn place(&self, pictures: &BTreeMap<String, String>, out: &Path) -> Result<(), Failure> {
        for (name, svg) in pictures {
            let is_new = self
                .placed
                .lock()
                .is_ok_and(|mut placed| placed.insert(name.clone()));
            if is_new {
                let bytes = self.pages.writer().picture(svg).map_err(fail)?;
                files::write(&out.join(name), &bytes)?;
            }
        }
        Ok(())
    }
}

fn fail(error: output::OutputError) -> Failure {
    Failure::new(error.to_string())
}

/// The file of one kind of page; none where each sheet has its own.
struct Open {
    kind: Kind,
    begin: String,
    file: Option<Draft>,
}

impl Writers {
    fn open(arguments: &Arguments, blueprint: &Blueprint, out: &Path) -> Result<Self, Failure> {
        let mut writers = Self {
            formats: Vec::new(),
            json: None,
        };
        for name in &blueprint.formats {
            if name.value == "json" {
                writers.json = Some(Draft::begin(&out.join("sheets.jsonl"))?);
                continue;
            }
            let writer = output::writer(&name.value).ok_or_else(|| unknown_format(&name.value))?;
            let own = own_layouts(arguments.layouts.as_deref(), writer.name())?;
            let pages = Pages::new(writer, Run::of(blueprint, writer), &own).map_err(fail)?;
            let mut kinds = vec![Kind::Sheet];
            kinds.extend(blueprint.keys.each.then_some(Kind::Key));
            kinds.extend(blueprint.solutions.then_some(Kind::Solutions));
            let mut open = Vec::new();
            for kind in kinds {
                let begin = pages.begin(Pages::subtitle(kind)).map_err(fail)?;
                let file = if arguments.split || writer.is_bound() {
                    None
                } else {
                    let mut file = Draft::begin(&out.join(format!(
                        "{}.{}",
                        kind.folder(),
                        writer.extension()
                    )))?;
                    file.write(begin.as_bytes())?;
                    Some(file)
                };
                open.push(Open { kind, begin, file });
            }
            let begin = || pages.begin("answers of all variants").map_err(fail);
            let table = blueprint.keys.table.then(begin).transpose()?;
            let end = pages.end().map_err(fail)?;
            writers.formats.push(Format {
                pages,
                open,
                table,
                end,
                placed: Mutex::default(),
            });
        }
        Ok(writers)
    }
}

fn unknown_format(name: &str) -> Failure {
    let known: Vec<&str> = output::WRITERS
        .iter()
        .map(|writer| writer.name())
        .chain(["json"])
        .collect();
    Failure::new(format!("`{name}` is no format"))
        .help(format!("the formats are {}", known.join(", ")))
}

/// The layouts of one format in a folder of the user.
fn own_layouts(folder: Option<&Path>, format: &str) -> Result<Vec<(String, String)>, Failure> {
    let Some(folder) = folder else {
        return Ok(Vec::new());
    };
    let inside = folder.join(format);
    let Ok(entries) = std::fs::read_dir(&inside) else {
        return Ok(Vec::new());
    };
    let mut layouts = Vec::new();
    for entry in entries.flatten().filter(|entry| entry.path().is_file()) {
        layouts.push((
            entry.file_name().to_string_lossy().into_owned(),
            files::read(&entry.path())?,
        ));
    }
    layouts.sort();
    Ok(layouts)
}

fn secret(path: &Path) -> Result<Secret, Failure> {
    let bytes = files::read_bytes(path)?;
    Secret::new(&bytes).map_err(|error| Failure::new(format!("`{}`: {error}", path.display())))
}

fn refuse(error: &SheetError) -> Failure {
    Failure::new(error.to_string())
        .help("loosen the constraints of the item, or fix other data with `set`")
}

/// What showing the question of the first variant computes.
fn trace(plan: &Plan<'_>) -> Result<(), Failure> {
    use vibank::scene::Scene;
    let sheet = Sheet::draw(plan, plan.variant(0, 0), None).map_err(|error| refuse(&error))?;
    for question in &sheet.questions {
        let template = question.solution.template();
        let scene = Scene::of(&question.solution, plan.blueprint.data);
        scene.passage(&template.statement);
        question
            .parts
            .iter()
            .for_each(|place| drop(scene.passage(&template.parts[*place].ask)));
        let trace = question.solution.trace();
        eprintln!(
            "question {} of {}: computed {}; skipped {}",
            question.number,
            template.id,
            list(&trace.computed),
            list(&trace.skipped)
        );
    }
    Ok(())
}

fn list(names: &[String]) -> String {
    if names.is_empty() {
        "nothing".to_owned()
    } else {
        names.join(", ")
    }
}
