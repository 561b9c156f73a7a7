//! `vibank grade MANIFEST RESPONSES`

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use rayon::prelude::*;
use serde_json::{Value as Json, json};
use vibank::answer::{Marking, Verdict};
use vibank::bank::Catalogue;
use vibank::grade::{self, Place, Said};
use vibank::instance::Instance;
use vibank::numerics::Rational;
use vibank::output::{self, Feedback, FeedbackPart, FeedbackQuestion, Pages, Run};
use vibank::scene::{Data, Scene};
use vibank::seed::Seed;
use vibank::solution::Solution;
use vibank::unit::DecimalMark;
use vibank::worksheet::{FORMAT, Manifest, QuestionEntry, VariantEntry};

use super::bank::BankArgument;
use super::files::{self, Draft};
use super::{Failure, Outcome, progress, record, responses};

/// Mark the responses to the sheets of a run: marks, reasons and a feedback page for each sheet.
///
/// Example: vibank grade midterm/manifest.json midterm/responses.csv --out midterm/marks
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The manifest of the run.
    manifest: PathBuf,
    /// The responses, as CSV or JSON.
    responses: PathBuf,
    /// The folder to write to; `marks` beside the manifest if left out.
    #[arg(long, value_name = "FOLDER")]
    out: Option<PathBuf>,
    /// Mark also with items whose text has changed since the sheets were made.
    #[arg(long)]
    accept_revisions: bool,
    /// Write no feedback pages.
    #[arg(long)]
    no_feedback: bool,
    #[command(flatten)]
    bank: BankArgument,
}

/// Sheets that are marked at once; memory holds no more.
const CHUNK: usize = 256;

/// A manifest.
pub(crate) fn manifest(path: &Path) -> Result<Manifest, Failure> {
    let text = files::read(path)?;
    let shown = path.display();
    let manifest: Manifest = serde_json::from_str(&text).map_err(|error| {
        Failure::new(format!("`{shown}` is no manifest: {error}"))
            .help("give the `manifest.json` that `vibank sheet` wrote")
    })?;
    if manifest.format != FORMAT {
        return Err(Failure::new(format!(
            "`{shown}` has format {}, this program reads format {FORMAT}",
            manifest.format
        )));
    }
    Ok(manifest)
}

/// The solution of a question as it was handed out.
pub(crate) fn solution<'c>(
    catalogue: &'c Catalogue,
    question: &QuestionEntry,
    decimal: char,
    accept: bool,
) -> Result<Solution<'c>, Failure> {
    let id = &question.item;
    let template = catalogue
        .find(id.as_str())
        .ok_or_else(|| Failure::new(format!("the bank has no item `{id}` any more")))?;
    if template.revision != question.revision && !accept {
        return Err(Failure::new(format!(
            "`{id}` has changed: the sheets have revision {}, the bank has {}",
            question.revision, template.revision
        ))
        .help("mark with the bank of that time, or add `--accept-revisions`"));
    }
    let set: Vec<(&str, &str)> = question
        .values
        .iter()
        .map(|(name, value)| (name.as_str(), value.as_str()))
        .collect();
    let known: Vec<(&str, &str)> = set
        .into_iter()
        .filter(|(name, _)| template.parameter(name).is_some())
        .collect();
    let instance = Instance::of(template, Some(Seed::new(question.seed)), &known)
        .map_err(|error| Failure::new(error.to_string()))?;
    let mark = if decimal == ',' {
        DecimalMark::Comma
    } else {
        DecimalMark::Point
    };
    Ok(Solution::with_mark(instance, mark))
}

/// One part that was marked.
struct Marked {
    question: usize,
    letter: String,
    item: String,
    id: String,
    response: String,
    marking: Marking,
    feedback: Vec<String>,
    points: Rational,
    max: Rational,
}

/// One sheet that was marked.
struct Sheet<'m> {
    variant: &'m VariantEntry,
    parts: Vec<Marked>,
    page: Option<String>,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let manifest = manifest(&arguments.manifest)?;
    let catalogue = arguments.bank.catalogue()?;
    let (rows, mut faults) = responses::read(&arguments.responses)?;
    let (mut given, errors) = grade::collect(rows);
    faults.extend(errors.iter().map(ToString::to_string));
    let beside = arguments.manifest.parent().unwrap_or(Path::new("."));
    let out = arguments
        .out
        .clone()
        .unwrap_or_else(|| beside.join("marks"));
    let writer = output::writer("html").expect("the format is in the list");
    let pages = Pages::new(
        writer,
        Run::plain(&manifest.title, &manifest.language, manifest.decimal),
        &[],
    );
    let pages = pages.map_err(|error| Failure::new(error.to_string()))?;
    let ends = (pages.begin("feedback"), pages.end());
    let (Ok(begin), Ok(end)) = ends else {
        return Err(Failure::new("the layouts cannot be filled"));
    };
    let mut tally = Tally::begin(&out, &manifest)?;
    let bar = progress::bar(manifest.variants.len() as u64, "sheets");
    for chunk in manifest.variants.chunks(CHUNK) {
        let marked: Vec<Result<Sheet<'_>, Failure>> = chunk
            .par_iter()
            .map(|variant| sheet(arguments, &catalogue, &manifest, variant, &given, &pages))
            .collect();
        for sheet in marked {
            let sheet = sheet?;
            tally.add(&sheet)?;
            for part in &sheet.parts {
                given.remove(&Place {
                    code: sheet.variant.code.clone(),
                    question: part.question,
                    part: part.letter.clone(),
                });
            }
            if let Some(page) = sheet.page {
                let path = out
                    .join("feedback")
                    .join(format!("{}.html", sheet.variant.code));
                files::write(&path, format!("{begin}{page}{end}").as_bytes())?;
            }
            bar.inc(1);
        }
    }
    bar.finish_and_clear();
    faults.extend(
        given
            .iter()
            .filter(|(_, response)| !response.is_empty())
            .map(|(place, _)| {
                format!(
                    "no part {}{} of a sheet {} was handed out",
                    place.question, place.part, place.code
                )
            }),
    );
    tally.finish(&out, &faults, !arguments.no_feedback)
}

fn sheet<'m>(
    arguments: &Arguments,
    catalogue: &Catalogue,
    manifest: &'m Manifest,
    variant: &'m VariantEntry,
    given: &BTreeMap<Place, String>,
    pages: &Pages,
) -> Result<Sheet<'m>, Failure> {
    let mut parts = Vec::new();
    let mut questions = Vec::new();
    for question in &variant.questions {
        let solution = solution(
            catalogue,
            question,
            manifest.decimal,
            arguments.accept_revisions,
        )?;
        let first = parts.len();
        for entry in &question.parts {
            let place = Place {
                code: variant.code.clone(),
                question: question.number,
                part: entry.letter.clone(),
            };
            let response = given.get(&place).cloned().unwrap_or_default();
            parts.push(part(&solution, question, entry, response, pages)?);
        }
        if !arguments.no_feedback {
            questions.push(feedback(&solution, question.number, &parts[first..], pages));
        }
    }
    let column = |name: &str| {
        variant
            .student
            .as_ref()
            .and_then(|student| student.get(name))
            .cloned()
            .unwrap_or_default()
    };
    let page = if arguments.no_feedback {
        None
    } else {
        let total = format!(
            "{} of {}",
            shown(sum(&parts, |part| part.points)),
            pages.points(sum(&parts, |part| part.max))
        );
        let feedback = Feedback {
            code: variant.code.clone(),
            name: column("name"),
            student: column("id"),
            total,
            questions,
        };
        Some(
            pages
                .feedback(&feedback)
                .map_err(|error| Failure::new(error.to_string()))?,
        )
    };
    Ok(Sheet {
        variant,
        parts,
        page,
    })
}

fn part(
    solution: &Solution<'_>,
    question: &QuestionEntry,
    entry: &vibank::worksheet::PartEntry,
    response: String,
    pages: &Pages,
) -> Result<Marked, Failure> {
    let template = solution.template();
    let place = template.parts.iter().position(|part| part.id == entry.id);
    let place = place.ok_or_else(|| {
        Failure::new(format!(
            "`{}` has no part `{}` any more",
            template.id, entry.id
        ))
    })?;
    let marking = grade::mark(solution, place, &response);
    let feedback = grade::said(solution, place, &marking)
        .iter()
        .map(|said| written(solution, said, pages))
        .collect();
    let max = Rational::from_decimal(&entry.points.to_string()).unwrap_or(Rational::ONE);
    Ok(Marked {
        question: question.number,
        letter: entry.letter.clone(),
        item: template.id.to_string(),
        id: entry.id.clone(),
        response,
        points: grade::points(&marking, max),
        marking,
        feedback,
        max,
    })
}

/// A piece of feedback in HTML.
fn written(solution: &Solution<'_>, said: &Said<'_>, pages: &Pages) -> String {
    let writer = pages.writer();
    match said {
        Said::Words(words) => format!("<p>{}</p>", writer.words(words)),
        Said::Document(document) => format!("<p>{}</p>", writer.line(document)),
        Said::Passage(passage) => writer.texts(&Scene::of(solution, Data::Both).passage(passage)),
    }
}

fn feedback(
    solution: &Solution<'_>,
    number: usize,
    parts: &[Marked],
    pages: &Pages,
) -> FeedbackQuestion {
    let part = |part: &Marked| FeedbackPart {
        letter: part.letter.clone(),
        verdict: part.marking.verdict.name(),
        points: format!("{} of {}", shown(part.points), pages.points(part.max)),
        response: part.response.clone(),
        reading: part
            .marking
            .reading
            .as_ref()
            .map(|reading| pages.writer().math(&reading.math))
            .unwrap_or_default(),
        feedback: part.feedback.clone(),
    };
    let total = format!(
        "{} of {}",
        shown(sum(parts, |part| part.points)),
        pages.points(sum(parts, |part| part.max))
    );
    FeedbackQuestion {
        number,
        title: solution.template().about.title.clone(),
        points: total,
        parts: parts.iter().map(part).collect(),
    }
}

fn sum(parts: &[Marked], of: impl Fn(&Marked) -> Rational) -> Rational {
    parts.iter().map(of).fold(Rational::ZERO, |sum, points| {
        sum.checked_add(points).unwrap_or(sum)
    })
}

/// Points as a decimal of at most two places: the only rounding of a mark.
fn shown(points: Rational) -> String {
    ((points.to_f64() * 100.0).round() / 100.0).to_string()
}

/// The files of a grading run, and its counts.
struct Tally {
    marks: Draft,
    details: Draft,
    results: Draft,
    columns: Vec<String>,
    verdicts: BTreeMap<Verdict, usize>,
    unreadable: Vec<String>,
    sheets: usize,
    is_first: bool,
}

impl Tally {
    fn begin(out: &Path, manifest: &Manifest) -> Result<Self, Failure> {
        let mut columns: Vec<(usize, String)> = Vec::new();
        for question in manifest
            .variants
            .iter()
            .flat_map(|variant| &variant.questions)
        {
            for part in &question.parts {
                let column = (question.number, part.letter.clone());
                if !columns.contains(&column) {
                    columns.push(column);
                }
            }
        }
        columns.sort_by(|a, b| {
            a.0.cmp(&b.0)
                .then(a.1.len().cmp(&b.1.len()))
                .then_with(|| a.1.cmp(&b.1))
        });
        let columns: Vec<String> = columns
            .into_iter()
            .map(|(question, part)| format!("{question}{part}"))
            .collect();
        let mut marks = Draft::begin(&out.join("marks.csv"))?;
        let head = ["code", "student", "name", "group", "points", "max"];
        let all: Vec<&str> = head
            .into_iter()
            .chain(columns.iter().map(String::as_str))
            .collect();
        marks.write(&record::line(&all)?)?;
        let mut details = Draft::begin(&out.join("details.csv"))?;
        details.write(&record::line(&DETAILS)?)?;
        let mut results = Draft::begin(&out.join("results.json"))?;
        results.write(b"[")?;
        let (verdicts, unreadable) = (BTreeMap::new(), Vec::new());
        Ok(Self {
            marks,
            details,
            results,
            columns,
            verdicts,
            unreadable,
            sheets: 0,
            is_first: true,
        })
    }

    fn add(&mut self, sheet: &Sheet<'_>) -> Result<(), Failure> {
        let column = |name: &str| {
            sheet
                .variant
                .student
                .as_ref()
                .and_then(|student| student.get(name))
                .map_or("", String::as_str)
        };
        let total = [
            shown(sum(&sheet.parts, |part| part.points)),
            shown(sum(&sheet.parts, |part| part.max)),
        ];
        let cells: Vec<String> = self
            .columns
            .iter()
            .map(|name| {
                sheet
                    .parts
                    .iter()
                    .find(|part| format!("{}{}", part.question, part.letter) == *name)
                    .map(|part| shown(part.points))
                    .unwrap_or_default()
            })
            .collect();
        let mut row = vec![
            sheet.variant.code.as_str(),
            column("id"),
            column("name"),
            column("group"),
            &total[0],
            &total[1],
        ];
        row.extend(cells.iter().map(String::as_str));
        self.marks.write(&record::line(&row)?)?;
        for part in &sheet.parts {
            *self.verdicts.entry(part.marking.verdict).or_default() += 1;
            if part.marking.verdict == Verdict::Unreadable {
                let shown: String = part.response.chars().take(60).collect();
                self.unreadable.push(format!(
                    "{} {}{}: `{shown}`",
                    sheet.variant.code, part.question, part.letter
                ));
            }
            self.detail(&sheet.variant.code, column("id"), part)?;
        }
        self.sheets += 1;
        Ok(())
    }

    fn detail(&mut self, code: &str, student: &str, part: &Marked) -> Result<(), Failure> {
        let reasons: Vec<String> = part
            .marking
            .reasons
            .iter()
            .map(vibank::answer::Reason::code)
            .collect();
        let reading = part
            .marking
            .reading
            .as_ref()
            .map(|reading| reading.math.latex());
        let feedback: Vec<String> = part.feedback.iter().map(|piece| strip(piece)).collect();
        let credit = part.marking.credit.share().to_f64();
        let fields = [
            code.to_owned(),
            student.to_owned(),
            part.question.to_string(),
            part.letter.clone(),
            part.item.clone(),
            part.id.clone(),
            part.response.clone(),
            reading.clone().unwrap_or_default(),
            part.marking.verdict.name().to_owned(),
            credit.to_string(),
            shown(part.points),
            shown(part.max),
            reasons.join(" "),
            feedback.join(" "),
        ];
        let fields: Vec<&str> = fields.iter().map(String::as_str).collect();
        self.details.write(&record::line(&fields)?)?;
        let entry = json!({
            "code": code, "student": student, "question": part.question, "part": part.letter, "item": part.item, "id": part.id,
            "response": part.response, "reading": reading, "verdict": part.marking.verdict, "credit": credit,
            "points": part.points.to_f64(), "max": part.max.to_f64(), "reasons": reasons, "feedback": feedback.join(" "),
        });
        self.result(&entry)
    }

    fn result(&mut self, entry: &Json) -> Result<(), Failure> {
        let before: &[u8] = if std::mem::take(&mut self.is_first) {
            b"\n"
        } else {
            b",\n"
        };
        self.results.write(before)?;
        self.results.write(entry.to_string().as_bytes())
    }

    fn finish(
        mut self,
        out: &Path,
        faults: &[String],
        has_pages: bool,
    ) -> Result<Outcome, Failure> {
        self.results.write(b"\n]\n")?;
        self.marks.finish()?;
        self.details.finish()?;
        self.results.finish()?;
        if !self.unreadable.is_empty() {
            eprintln!("could not be read, and cost nothing:");
            self.unreadable
                .iter()
                .for_each(|line| eprintln!("  {line}"));
        }
        if !faults.is_empty() {
            eprintln!("rows that were left out:");
            faults.iter().for_each(|line| eprintln!("  {line}"));
        }
        let counts: Vec<String> = self
            .verdicts
            .iter()
            .map(|(verdict, count)| format!("{count} {}", verdict.name()))
            .collect();
        println!("{} sheets: {}", self.sheets, counts.join(", "));
        println!("  {:<24} one row a sheet", out.join("marks.csv").display());
        println!(
            "  {:<24} one row a part, with reading and reasons",
            out.join("details.csv").display()
        );
        println!(
            "  {:<24} the same for programs",
            out.join("results.json").display()
        );
        if has_pages {
            println!(
                "  {:<24} a page for each sheet",
                out.join("feedback").display()
            );
        }
        Ok(if faults.is_empty() {
            Outcome::Done
        } else {
            Outcome::Findings
        })
    }
}

/// The columns of the details.
const DETAILS: [&str; 14] = [
    "code", "student", "question", "part", "item", "id", "response", "reading", "verdict",
    "credit", "points", "max", "reasons", "feedback",
];

/// The words of a piece of HTML that we wrote.
fn strip(html: &str) -> String {
    let mut out = String::new();
    let mut inside = false;
    for letter in html.chars() {
        match letter {
            '<' => inside = true,
            '>' => inside = false,
            _ if !inside => out.push(letter),
            _ => {}
        }
    }
    out.trim()
        .replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&quot;", "\"")
        .replace("&#39;", "'")
        .replace("&amp;", "&")
}
