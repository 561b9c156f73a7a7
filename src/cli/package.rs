//! Reading a SCORM package back: which questions it has, and which data a learner has in it.

use std::io::{Cursor, Read};
use std::path::Path;

use serde::Deserialize;
use vibank::answer::Doubt;
use vibank::bank::{Catalogue, Compiled, Space, Template};
use vibank::course::first_variant;
use vibank::instance::Instance;
use vibank::numerics::Rational;
use vibank::output::DESCRIPTION;
use vibank::seed::Variant;
use vibank::solution::Solution;
use vibank::wasm::Grader;
use vibank::worksheet::{Manifest, Practice, PracticeQuestion, QuestionEntry, SheetQuestion};

use super::{Failure, files, record};

/// Most that the description of a package unpacks to; that of the whole bank has 60 kB.
const MAX_LENGTH: u64 = 8_000_000;

/// What a package says of itself.
#[derive(Deserialize)]
struct Described {
    id: String,
    questions: Vec<AskedQuestion>,
    practice: Practice,
}

#[derive(Deserialize)]
struct AskedQuestion {
    key: String,
    revision: String,
    /// What its parts are worth.
    #[serde(default)]
    parts: Vec<Worth>,
}

#[derive(Deserialize)]
struct Worth {
    id: String,
    points: f64,
}

/// A package with the items of the bank that it was made of.
pub(crate) struct ReadPackage<'c> {
    id: String,
    pub(crate) practice: Practice,
    /// The item of each question, and what its parts are worth.
    questions: Vec<(&'c Template, Vec<Worth>)>,
    /// What chooses variants in the page, too.
    grader: Grader,
}

/// Reads a package, whose items have to be in the bank as they were.
pub(crate) fn read<'c>(path: &Path, catalogue: &'c Catalogue) -> Result<ReadPackage<'c>, Failure> {
    let name = path.display();
    let described: Described = serde_json::from_str(&description(path)?).map_err(|error| {
        Failure::new(format!("{name}: `{DESCRIPTION}` cannot be read: {error}"))
            .help("a package is made by `vibank page --scorm`")
    })?;
    let mut practice = described.practice;
    let mut items: Vec<Compiled> = Vec::new();
    let mut questions = Vec::new();
    for (question, asked) in practice.questions.iter_mut().zip(described.questions) {
        let template = current(catalogue, question)?;
        if template.revision.to_string() != asked.revision {
            let id = &question.item;
            return Err(Failure::new(format!(
                "{name}: `{}` was made of `{id}` @ {}, and the bank has {}",
                asked.key, asked.revision, template.revision
            ))
            .help("give the bank that the package was made of with `--bank`"));
        }
        question.place = items.len();
        items.push(Compiled::of(template));
        questions.push((template, asked.parts));
    }
    let program = concat!("vibank ", env!("CARGO_PKG_VERSION"));
    if practice.program != program {
        eprintln!(
            "{name}: made by {}, and this is {program}, which may choose other data",
            practice.program
        );
    }
    let grader = Grader::of(&practice.lines(&items));
    let grader = grader.map_err(Failure::of)?;
    Ok(ReadPackage {
        id: described.id,
        practice,
        questions,
        grader,
    })
}

impl ReadPackage<'_> {
    /// A manifest of it, without sheets.
    pub(crate) fn manifest(&self, catalogue: &Catalogue) -> Manifest {
        let practice = &self.practice;
        let items = self.questions.iter();
        Manifest {
            title: practice.title.clone(),
            data: practice.data,
            language: practice.language.clone(),
            decimal: practice.decimal,
            // A page asks back; of what it has reported nobody can be asked any more.
            doubt: Doubt::Benefit,
            other_form: practice.other_form,
            items: items
                .map(|(template, _)| (template.id.to_string(), template.source.text.to_string()))
                .collect(),
            ..record::without_sheets(catalogue)
        }
    }

    /// The question that asks a part of an item, with the data of a variant.
    pub(crate) fn asking(
        &self,
        item: &str,
        part: &str,
        code: Variant,
    ) -> Result<Option<QuestionEntry>, Failure> {
        let place = (0..self.questions.len()).find(|place| {
            let (template, _) = &self.questions[*place];
            let question = &self.practice.questions[*place];
            let part = template.parts.iter().find(|own| own.id == part);
            question.item.as_str() == item && part.is_some_and(|part| question.asks(part))
        });
        place.map(|place| self.question(place, code)).transpose()
    }

    /// The question at a place, from 0, with the data of a variant.
    pub(crate) fn question(&self, place: usize, code: Variant) -> Result<QuestionEntry, Failure> {
        let question = &self.practice.questions[place];
        let (template, worths) = &self.questions[place];
        let set: Vec<(&str, &str)> = question
            .set
            .iter()
            .map(|(name, value)| (name.as_str(), value.as_str()))
            .collect();
        let instance = Instance::of(
            template,
            Some(code.item(question.item.as_str(), None)),
            &set,
        );
        let instance = instance.map_err(Failure::of)?;
        let solution = Solution::of(instance);
        let parts: Vec<usize> = (0..template.parts.len())
            .filter(|place| solution.asks(*place) && question.asks(&template.parts[*place]))
            .collect();
        let points = parts.iter().map(|place| {
            let worth = worths
                .iter()
                .find(|own| own.id == template.parts[*place].id);
            let points = worth.and_then(|own| Rational::from_decimal(&own.points.to_string()));
            points.unwrap_or(Rational::ONE)
        });
        let points = points.collect();
        Ok(record::question(&SheetQuestion {
            number: place + 1,
            place,
            solution,
            spaces: vec![Space::None; parts.len()],
            parts,
            points,
            bonus: false,
            section: String::new(),
        }))
    }

    /// The variant of a learner's question.
    pub(crate) fn variant(&self, place: usize, learner: &str) -> Result<Variant, Failure> {
        let key = self.practice.questions[place].key();
        let from = first_variant(&self.id, &key, learner);
        let request = serde_json::json!({ "do": "choose", "question": place, "from": from });
        let reply = self.grader.answer(&request.to_string());
        let reply: serde_json::Value = serde_json::from_str(&reply).unwrap_or_default();
        let code = reply["code"].as_str().and_then(|code| code.parse().ok());
        code.ok_or_else(|| {
            let why = reply["error"].as_str().unwrap_or("no variant was found");
            Failure::new(format!("`{key}`: {why}"))
        })
    }
}

/// The item of a question in this bank.
pub(crate) fn current<'c>(
    catalogue: &'c Catalogue,
    question: &PracticeQuestion,
) -> Result<&'c Template, Failure> {
    let id = &question.item;
    catalogue.find(id.as_str()).ok_or_else(|| {
        if id.is_own() {
            return Failure::new(format!(
                "the package asks `{id}`, a question of its blueprint"
            ))
            .help("give the blueprint that the package was made of with `--blueprint`");
        }
        Failure::new(format!(
            "the package asks `{id}`, which this bank does not have"
        ))
        .help("give the bank that the package was made of with `--bank`")
    })
}

fn description(path: &Path) -> Result<String, Failure> {
    let name = path.display();
    let refuse = |why: String| {
        Failure::new(format!("{name} is not a package of this program: {why}"))
            .help("give the ZIP file that `vibank page --scorm` wrote")
    };
    let bytes = files::read_bytes(path)?;
    let archive = zip::ZipArchive::new(Cursor::new(bytes));
    let mut archive = archive.map_err(|error| refuse(error.to_string()))?;
    let file = archive.by_name(DESCRIPTION);
    let file = file.map_err(|error| refuse(format!("`{DESCRIPTION}`: {error}")))?;
    let mut text = String::new();
    let read = file.take(MAX_LENGTH + 1).read_to_string(&mut text);
    read.map_err(|error| refuse(format!("`{DESCRIPTION}`: {error}")))?;
    if text.len() as u64 > MAX_LENGTH {
        return Err(refuse(format!(
            "`{DESCRIPTION}` has more than {MAX_LENGTH} bytes"
        )));
    }
    Ok(text)
}
