//! The manifest and the response form of a run, written as sheets are made.

use std::collections::BTreeMap;
use std::path::Path;

use vibank::bank::Catalogue;
use vibank::worksheet::{
    BankStamp, FORMAT, FileStamp, Manifest, PartEntry, Plan, QuestionEntry, Sheet, VariantEntry,
    letter,
};

use super::Failure;
use super::files::Draft;

/// The two files of a run that grow with each sheet.
pub(crate) struct Record {
    manifest: Draft,
    responses: Draft,
    is_first: bool,
}

/// What is recorded of a sheet.
pub(crate) struct Entry(VariantEntry);

/// The columns of a response form.
const COLUMNS: [&str; 7] = [
    "code", "student", "question", "part", "kind", "unit", "response",
];

impl Entry {
    /// A file that was made for the sheet.
    pub(crate) fn file(&mut self, path: String, digest: String) {
        self.0.files.insert(path, digest);
    }
}

/// What is recorded of a sheet; its files are added when they are written.
pub(crate) fn entry(sheet: &Sheet<'_>) -> Entry {
    let question = |question: &vibank::worksheet::SheetQuestion<'_>| {
        let solution = &question.solution;
        let template = solution.template();
        let values = template.parameters.iter().zip(solution.instance().values());
        let part = |(position, (place, points)): (usize, (&usize, &vibank::numerics::Rational))| {
            let part = &template.parts[*place];
            let options = part.answer.options();
            PartEntry {
                letter: letter(position),
                id: part.id.clone(),
                kind: part.answer.kind().name().to_owned(),
                unit: part
                    .answer
                    .unit()
                    .map(|unit| unit.to_string())
                    .unwrap_or_default(),
                points: points.to_f64(),
                options: solution
                    .order(*place)
                    .into_iter()
                    .filter(|_| !options.is_empty())
                    .map(|at| options[at].id.clone())
                    .collect(),
            }
        };
        QuestionEntry {
            number: question.number,
            item: template.id.clone(),
            revision: template.revision,
            seed: solution
                .instance()
                .seed()
                .map_or(0, vibank::seed::Seed::number),
            points: question.total().to_f64(),
            values: values
                .map(|(parameter, value)| (parameter.name.to_string(), value.to_string()))
                .collect(),
            parts: question
                .parts
                .iter()
                .zip(&question.points)
                .enumerate()
                .map(part)
                .collect(),
        }
    };
    Entry(VariantEntry {
        code: sheet.variant.to_string(),
        seed: sheet.variant.number(),
        student: sheet
            .student
            .as_ref()
            .map(|student| student.columns.clone()),
        files: BTreeMap::new(),
        questions: sheet.questions.iter().map(question).collect(),
    })
}

impl Record {
    /// Begins both files.
    pub(crate) fn begin(
        out: &Path,
        plan: &Plan<'_>,
        catalogue: &Catalogue,
        digest: &str,
    ) -> Result<Self, Failure> {
        let blueprint = plan.blueprint;
        let name = Path::new(&*blueprint.source.path)
            .file_name()
            .map(|name| name.to_string_lossy().into_owned());
        let head = Manifest {
            format: FORMAT,
            program: concat!("vibank ", env!("CARGO_PKG_VERSION")).to_owned(),
            bank: BankStamp {
                title: catalogue.bank.title.clone(),
                digest: catalogue.digest(),
            },
            blueprint: FileStamp {
                path: name.unwrap_or_default(),
                digest: digest.to_owned(),
            },
            title: blueprint.title.clone(),
            data: blueprint.data,
            language: blueprint.language.clone(),
            decimal: blueprint.decimal,
            keyed: plan.secret.is_some(),
            shard: "1/1".to_owned(),
            variants: Vec::new(),
        };
        let head = serde_json::to_string(&head).expect("a manifest is plain data");
        let head = head
            .strip_suffix("]}")
            .expect("the variants come last, and there are none");
        let mut manifest = Draft::begin(&out.join("manifest.json"))?;
        manifest.write(head.as_bytes())?;
        let mut responses = Draft::begin(&out.join("responses.csv"))?;
        responses.write(line(&COLUMNS)?.as_slice())?;
        Ok(Self {
            manifest,
            responses,
            is_first: true,
        })
    }

    /// Adds a sheet.
    pub(crate) fn add(&mut self, entry: Entry) -> Result<(), Failure> {
        let Entry(variant) = entry;
        let text = serde_json::to_string(&variant).expect("an entry is plain data");
        let before = if std::mem::take(&mut self.is_first) {
            "\n"
        } else {
            ",\n"
        };
        self.manifest.write(before.as_bytes())?;
        self.manifest.write(text.as_bytes())?;
        let student = variant
            .student
            .as_ref()
            .and_then(|student| student.get("id"))
            .map_or("", String::as_str);
        for question in &variant.questions {
            let number = question.number.to_string();
            for part in &question.parts {
                let fields = [
                    &variant.code,
                    student,
                    &number,
                    &part.letter,
                    &part.kind,
                    &part.unit,
                    "",
                ];
                self.responses.write(&line(&fields)?)?;
            }
        }
        Ok(())
    }

    /// Ends both files.
    pub(crate) fn finish(mut self) -> Result<(), Failure> {
        self.manifest.write(b"\n]}\n")?;
        self.manifest.finish()?;
        self.responses.finish()?;
        Ok(())
    }
}

/// One line of CSV.
pub(crate) fn line(fields: &[&str]) -> Result<Vec<u8>, Failure> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let fail = |error: csv::Error| Failure::new(format!("cannot write CSV: {error}"));
    writer
        .write_record(fields.iter().map(|field| guarded(field)))
        .map_err(fail)?;
    writer
        .into_inner()
        .map_err(|error| Failure::new(format!("cannot write CSV: {error}")))
}

/// A cell that a spreadsheet would take for a formula gets an apostrophe in front, unless it is a number.
fn guarded(field: &str) -> String {
    let is_formula =
        field.starts_with(['=', '+', '-', '@', '\t', '\r']) && field.parse::<f64>().is_err();
    if is_formula {
        format!("'{field}")
    } else {
        field.to_owned()
    }
}
