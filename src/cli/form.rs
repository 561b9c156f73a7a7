//! `vibank form MANIFEST`

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use rayon::prelude::*;
use serde_json::{Value as Json, json};
use vibank::bank::{Catalogue, Compiled, ItemId, Revision, Template};
use vibank::document::Document;
use vibank::numerics::Rational;
use vibank::output::{self, FormQuestion, FormSheet, Run};
use vibank::seed::Variant;
use vibank::source::nearest;
use vibank::wasm::Grader;
use vibank::worksheet::{
    Manifest, PartEntry, Practice, PracticeQuestion, QuestionEntry, VariantEntry, letter,
};

use super::bank::BankArgument;
use super::folder::Folder;
use super::grade::{RunItems, manifest};
use super::sheet::PROGRAM;
use super::{Failure, Outcome, counted, file_kind, files};

/// Write each sheet of a run as a page on which it is answered: one file, which works without a network.
///
/// The page shows how an answer is read and says nothing of whether it is right: it carries no key, and nothing from which
/// one could be computed. It saves a file of answers; `vibank grade` takes one of them, or a folder.
///
/// Example: vibank form midterm/manifest.json
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The manifest of the run, or its folder.
    #[arg(value_parser = file_kind::manifest())]
    manifest: PathBuf,
    /// Only the sheets with these codes.
    #[arg(long, value_name = "CODE", value_delimiter = ',')]
    code: Vec<String>,
    /// The folder to write to; `form` beside the manifest if left out.
    #[arg(short, long, value_name = "FOLDER")]
    out: Option<PathBuf>,
    #[command(flatten)]
    bank: BankArgument,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let path = &arguments.manifest;
    let catalogue = arguments.bank.catalogue()?;
    let manifest = manifest(path)?;
    let wanted = codes(&arguments.code, &manifest)?;
    let beside = path.parent().unwrap_or(Path::new("."));
    let folder = match &arguments.out {
        Some(out) => Folder::at(out),
        None => Folder::within(beside, "form")?,
    };
    folder.make()?;
    let written = pages(
        &manifest,
        &catalogue,
        &|code| wanted.contains(code),
        &folder,
        "",
    )?;
    let shown = folder.root().display();
    println!("{} in {shown}", counted(written.sheets, "page"));
    if !written.unread.is_empty() {
        let parts: Vec<String> = written.unread.into_iter().collect();
        eprintln!(
            "taken as they are typed, without showing how they are read: {}",
            parts.join(", ")
        );
    }
    Ok(Outcome::Done)
}

/// Folders of pages below that of a run: those of `vibank form`, and those of students who answer on a screen.
pub(crate) const PAGES: &str = "form/";
pub(crate) const SCREEN: &str = "screen/";

/// The codes that are asked for, as they are printed; all if none is.
fn codes(stated: &[String], manifest: &Manifest) -> Result<BTreeSet<String>, Failure> {
    let all = || {
        manifest
            .variants
            .iter()
            .map(|variant| variant.code.as_str())
    };
    if stated.is_empty() {
        return Ok(all().map(str::to_owned).collect());
    }
    stated
        .iter()
        .map(|code| {
            let shown = code
                .parse::<Variant>()
                .map_or_else(|_| code.to_uppercase(), |variant| variant.to_string());
            if all().any(|own| own == shown) {
                return Ok(shown);
            }
            let failure = Failure::new(format!("the run has no sheet {shown}"));
            Err(match nearest(&shown, all()) {
                Some(near) => failure.help(format!("did you mean {near}?")),
                None => failure.help("write the code that is printed on the sheet"),
            })
        })
        .collect()
}

/// What was written.
pub(crate) struct WrittenPages {
    pub(crate) sheets: usize,
    /// Parts whose answers no page can read, by item and part.
    unread: BTreeSet<String>,
}

/// Writes the pages of the sheets that are wanted, into a folder or one below it.
pub(crate) fn pages(
    manifest: &Manifest,
    catalogue: &Catalogue,
    wanted: &(dyn Fn(&str) -> bool + Sync),
    out: &Folder,
    below: &str,
) -> Result<WrittenPages, Failure> {
    out.sweep(&[below.trim_end_matches('/')], &BTreeSet::new());
    let kept = std::slice::from_ref(&manifest.items);
    let items = RunItems::of(kept, catalogue, false);
    let sheets: Vec<&VariantEntry> = manifest
        .variants
        .iter()
        .filter(|variant| wanted(&variant.code))
        .collect();
    let writer = Writer::of(manifest, &items, &sheets)?;
    let digest = files::digest(manifest.inputs.as_bytes());
    // Statements are made by one grader, which keeps what it was asked about last.
    let shown: Vec<FormSheet> = sheets
        .iter()
        .scan(0, |first, sheet| {
            let from = *first;
            *first += sheet.questions.len();
            Some(writer.sheet(sheet, from, &digest[..16]))
        })
        .collect::<Result<_, Failure>>()?;
    let readers = &writer.readers;
    let pages = shown.par_iter().zip(&sheets);
    pages.try_for_each(|(form, sheet)| {
        let (practice, readers) = reader(sheet, manifest, readers);
        let page = output::form(form, &practice, &readers);
        let page = page.map_err(Failure::of)?;
        let name = format!("{below}{}.html", sheet.code);
        out.write(&name, page.as_bytes()).map(drop)
    })?;
    Ok(WrittenPages {
        sheets: sheets.len(),
        unread: writer.unread(),
    })
}

/// An item as it was handed out, and the parts of it that are asked together.
type AskedParts = (ItemId, Revision, Vec<String>);

/// What reads the answers to an item, and the parts that it reads.
struct Reader {
    item: Option<Compiled>,
    reads: BTreeMap<String, String>,
    /// The parts that are done on paper, and are on no page.
    on_paper: BTreeSet<String>,
}

struct Writer<'m> {
    manifest: &'m Manifest,
    run: Run,
    grader: Grader,
    readers: BTreeMap<AskedParts, Reader>,
}

impl<'m> Writer<'m> {
    fn of(
        manifest: &'m Manifest,
        items: &RunItems<'_>,
        sheets: &[&VariantEntry],
    ) -> Result<Self, Failure> {
        let (mut places, mut compiled) = (BTreeMap::new(), Vec::new());
        let (mut questions, mut readers) = (Vec::new(), BTreeMap::new());
        for question in sheets.iter().flat_map(|sheet| &sheet.questions) {
            let template = items.find(&question.item, question.revision)?;
            let place = *places
                .entry((question.item.clone(), question.revision))
                .or_insert_with(|| {
                    compiled.push(Compiled::of(template));
                    compiled.len() - 1
                });
            let parts: Vec<String> = question.parts.iter().map(|part| part.id.clone()).collect();
            let set = question.values.iter();
            let set = set.filter(|(name, _)| template.parameter(name).is_some());
            questions.push(PracticeQuestion {
                parts: parts.clone(),
                set: set
                    .map(|(name, value)| (name.clone(), value.clone()))
                    .collect(),
                ..PracticeQuestion::of(template, place, "")
            });
            let asked = (question.item.clone(), question.revision, parts);
            readers
                .entry(asked)
                .or_insert_with_key(|(_, _, parts)| Reader::of(template, parts));
        }
        let practice = Practice {
            questions,
            ..bare(manifest)
        };
        let grader = Grader::of(&practice.lines(&compiled));
        let grader = grader.map_err(Failure::of)?;
        Ok(Self {
            manifest,
            run: Run::plain(&manifest.title, &manifest.language, manifest.decimal),
            grader,
            readers,
        })
    }

    /// What a sheet shows; its questions are those of the grader from a number on.
    fn sheet(&self, sheet: &VariantEntry, from: usize, run: &str) -> Result<FormSheet, Failure> {
        let name = sheet
            .student
            .as_ref()
            .and_then(|student| student.get("name"));
        let questions = sheet.questions.iter().enumerate();
        let questions = questions
            .map(|(at, question)| self.question(question, from + at, &sheet.code))
            .collect::<Result<_, _>>()?;
        Ok(FormSheet {
            code: sheet.code.clone(),
            name: name.cloned().unwrap_or_default(),
            sheet: run.to_owned(),
            title: self.manifest.title.clone(),
            questions,
        })
    }

    fn question(
        &self,
        question: &QuestionEntry,
        number: usize,
        code: &str,
    ) -> Result<FormQuestion, Failure> {
        let request = json!({ "do": "show", "question": number, "code": code });
        let reply: Json =
            serde_json::from_str(&self.grader.answer(&request.to_string())).unwrap_or_default();
        if let Some(error) = reply["error"].as_str() {
            let item = &question.item;
            return Err(Failure::new(format!("`{item}` cannot be shown: {error}")));
        }
        let reader = &self.readers[&asked(question)];
        let shown = reply["parts"].as_array().cloned().unwrap_or_default();
        let parts = question.parts.iter().map(|part| {
            let own = shown.iter().find(|own| own["id"] == part.id.as_str());
            own.map(|own| shown_part(own, part, reader)).ok_or_else(|| {
                let (item, id) = (&question.item, &part.id);
                Failure::new(format!("`{item}` has no part `{id}` for these data"))
            })
        });
        let points = Rational::from_decimal(&question.points.to_string()).unwrap_or(Rational::ZERO);
        Ok(FormQuestion {
            number: question.number,
            title: self.title(number),
            points: self.run.points(points),
            statement: reply["statement"].as_str().unwrap_or_default().to_owned(),
            parts: parts.collect::<Result<_, _>>()?,
        })
    }

    fn title(&self, number: usize) -> String {
        let question = self.grader.practice().questions.get(number);
        question.map_or_else(String::new, |question| question.title.clone())
    }

    fn unread(&self) -> BTreeSet<String> {
        let unread = self.readers.iter().flat_map(|((item, _, parts), reader)| {
            let parts = parts.iter().filter(|part| {
                !reader.reads.contains_key(*part) && !reader.on_paper.contains(*part)
            });
            parts.map(move |part| format!("{item} {part}"))
        });
        unread.collect()
    }
}

impl Reader {
    /// What reads the answers to these parts, and to no others.
    fn of(template: &Template, parts: &[String]) -> Self {
        let places = parts.iter().filter_map(|id| template.place(id));
        let places: Vec<usize> = places
            .filter(|place| template.stripped(&[*place]).is_some())
            .collect();
        let item = template.stripped(&places);
        let on_paper = parts.iter().filter(|id| {
            let part = template.part(id);
            part.is_some_and(|part| part.answer.kind().is_by_hand())
        });
        let on_paper = on_paper.cloned().collect();
        let name = |place: &usize| template.parts[*place].id.clone();
        let reads = places.iter().filter(|_| item.is_some());
        Self {
            reads: reads
                .map(|place| (name(place), name(place).replace('.', "__")))
                .collect(),
            item,
            on_paper,
        }
    }
}

/// What reads the answers to a sheet.
fn reader(
    sheet: &VariantEntry,
    manifest: &Manifest,
    readers: &BTreeMap<AskedParts, Reader>,
) -> (Practice, Vec<Compiled>) {
    let (mut questions, mut items) = (Vec::new(), Vec::new());
    for question in &sheet.questions {
        questions.push(PracticeQuestion {
            item: question.item.clone(),
            place: items.len(),
            title: String::new(),
            chapter: String::new(),
            topics: Vec::new(),
            level: 1,
            minutes: 0,
            parts: Vec::new(),
            set: Vec::new(),
            weights: Vec::new(),
        });
        items.extend(readers[&asked(question)].item.clone());
    }
    let practice = Practice {
        questions,
        ..bare(manifest)
    };
    (practice, items)
}

fn asked(question: &QuestionEntry) -> AskedParts {
    let parts = question.parts.iter().map(|part| part.id.clone());
    (question.item.clone(), question.revision, parts.collect())
}

/// A part as the page shows it: options in their printed order, and nothing that only practice has.
fn shown_part(shown: &Json, part: &PartEntry, reader: &Reader) -> Json {
    let mut own = shown.clone();
    let options = shown["options"].as_array().cloned().unwrap_or_default();
    let printed = part.options.iter().enumerate().filter_map(|(at, id)| {
        let mut option = options
            .iter()
            .find(|option| option["id"] == id.as_str())?
            .clone();
        option["letter"] = letter(at).into();
        option.as_object_mut()?.remove("id");
        Some(option)
    });
    own["options"] = printed.collect();
    own["letter"] = part.letter.clone().into();
    // A letter says what was chosen as it is.
    if let Some(reads) = reader
        .reads
        .get(&part.id)
        .filter(|_| part.options.is_empty())
    {
        own["reads"] = reads.clone().into();
    }
    if let Some(own) = own.as_object_mut() {
        for key in ["id", "was", "hints"] {
            own.remove(key);
        }
    }
    own
}

/// A practice of a run without questions.
fn bare(manifest: &Manifest) -> Practice {
    Practice {
        program: PROGRAM.to_owned(),
        title: manifest.title.clone(),
        instructions: Document::default(),
        language: manifest.language.clone(),
        decimal: manifest.decimal,
        doubt: manifest.doubt,
        other_form: None,
        data: manifest.data,
        questions: Vec::new(),
    }
}
