//! The manifest and the response form of a run, written as sheets are made.

use std::collections::BTreeMap;
use std::path::Path;

use vibank::answer::Doubt;
use vibank::bank::Catalogue;
use vibank::scene::Data;
use vibank::worksheet::{
    BankStamp, Csv, FORMAT, FileStamp, Manifest, Paper, PartEntry, Plan, QuestionEntry, Sheet,
    SheetQuestion, VariantEntry, headings,
};

use serde_json::json;

use super::Failure;
use super::files;
use super::folder::{Draft, Folder, Left};
use super::shard::Shard;
use super::sheet::{FormatChoice, PROGRAM, RunMark, Stamp};
use super::table::Dialect;

/// The two files of a run that grow with each sheet.
pub(crate) struct Record {
    name: String,
    manifest: Draft,
    /// Only the whole run has a form, which is left as it is where somebody has filled it in.
    responses: Option<Draft>,
    dialect: Dialect,
    /// Digest of the form as it was made.
    form: String,
    is_first: bool,
}

/// What the head of a manifest names.
#[derive(Clone, Copy)]
pub(crate) struct Origin<'a> {
    pub(crate) plan: &'a Plan<'a>,
    pub(crate) catalogue: &'a Catalogue,
    pub(crate) choice: &'a FormatChoice,
    pub(crate) shard: Shard,
    pub(crate) stamp: &'a Stamp,
}

/// The name of the form.
pub(crate) const FORM: &str = "responses.csv";

/// The columns of a response form.
const COLUMNS: [&str; 7] = [
    "code", "student", "question", "part", "kind", "unit", "response",
];

/// What is recorded of a sheet; its files are added when they are written.
pub(crate) fn entry(sheet: &Sheet<'_>) -> VariantEntry {
    VariantEntry {
        code: sheet.variant.to_string(),
        seed: sheet.variant.number(),
        student: sheet
            .student
            .as_ref()
            .map(|student| student.columns.clone()),
        gave_way: false,
        files: BTreeMap::new(),
        pages: BTreeMap::new(),
        questions: sheet.questions.iter().map(question).collect(),
    }
}

/// What is recorded of a question.
pub(crate) fn question(question: &SheetQuestion<'_>) -> QuestionEntry {
    let solution = &question.solution;
    let template = solution.template();
    let values = template.parameters.iter().zip(solution.instance().values());
    QuestionEntry {
        number: question.number,
        item: template.id.clone(),
        revision: template.revision,
        seed: solution
            .instance()
            .seed()
            .map_or(0, vibank::seed::Seed::number),
        points: question.total().to_f64(),
        bonus: question.bonus,
        section: question.section.clone(),
        values: values
            .map(|(parameter, value)| (parameter.name.to_string(), value.to_string()))
            .collect(),
        parts: headings(template, &question.parts)
            .into_iter()
            .zip(question.parts.iter().zip(&question.points))
            .map(|(heading, (place, points))| {
                let part = &template.parts[*place];
                let options = part.answer.options();
                PartEntry {
                    letter: heading.letter,
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
            })
            .collect(),
    }
}

/// The manifest of questions that are on no sheet, without any yet.
pub(crate) fn without_sheets(catalogue: &Catalogue) -> Manifest {
    Manifest {
        format: FORMAT,
        program: PROGRAM.to_owned(),
        bank: BankStamp {
            title: catalogue.bank.title.clone(),
            digest: catalogue.digest(),
        },
        blueprint: FileStamp {
            path: String::new(),
            digest: String::new(),
        },
        title: catalogue.bank.title.clone(),
        data: Data::default(),
        language: "en".to_owned(),
        decimal: '.',
        doubt: Doubt::Benefit,
        other_form: None,
        marks: None,
        csv: Csv::default(),
        paper: Paper::default(),
        keyed: false,
        shard: "1/1".to_owned(),
        inputs: String::new(),
        look: String::new(),
        formats: Vec::new(),
        press: None,
        fonts: Vec::new(),
        variants: Vec::new(),
        items: BTreeMap::new(),
        form: String::new(),
        files: BTreeMap::new(),
    }
}

impl Record {
    /// The files of a run that goes on at `mark`; of a form that is filled in, `kept_form` is the digest.
    pub(crate) fn open(
        out: &Folder,
        origin: Origin<'_>,
        mark: &RunMark,
        kept_form: Option<String>,
    ) -> Result<Self, Failure> {
        let Origin { plan, shard, .. } = origin;
        let name = shard.named("manifest", "json");
        let mut manifest = out.go_on(&name, mark.left(&name))?;
        let makes_form = shard.is_whole() && kept_form.is_none();
        let mut responses = makes_form
            .then(|| out.go_on(FORM, mark.left(FORM)))
            .transpose()?;
        let dialect = Dialect::new(plan.blueprint.csv, plan.blueprint.decimal);
        let is_first = mark.done == 0;
        if is_first {
            manifest.write(head(origin).as_bytes())?;
            if let Some(form) = &mut responses {
                form.write(&dialect.head(&COLUMNS)?)?;
            }
        }
        Ok(Self {
            name,
            manifest,
            responses,
            dialect,
            form: kept_form.unwrap_or_default(),
            is_first,
        })
    }

    /// Adds a sheet.
    pub(crate) fn add(&mut self, variant: &VariantEntry) -> Result<(), Failure> {
        let text = serde_json::to_string(variant).expect("an entry is plain data");
        let before = if std::mem::take(&mut self.is_first) {
            "\n"
        } else {
            ",\n"
        };
        self.manifest.write(before.as_bytes())?;
        self.manifest.write(text.as_bytes())?;
        match &mut self.responses {
            Some(form) => rows(form, self.dialect, variant),
            None => Ok(()),
        }
    }

    /// Hands everything to the system; what a later run would go on with.
    pub(crate) fn flush(&mut self) -> Result<Vec<(String, Left)>, Failure> {
        let mut lengths = vec![(self.name.clone(), self.manifest.flush()?)];
        if let Some(form) = &mut self.responses {
            lengths.push((FORM.to_owned(), form.flush()?));
        }
        Ok(lengths)
    }

    /// Ends both files, the manifest last, with the items that were used and the digests of the `files` of the run.
    ///
    /// The form is not among them: it is there to be filled in.
    pub(crate) fn finish(
        mut self,
        items: &BTreeMap<String, String>,
        files: &BTreeMap<String, String>,
    ) -> Result<Vec<(String, &'static str)>, Failure> {
        let mut shown = Vec::new();
        let mut digest = self.form;
        if let Some(form) = self.responses {
            digest = form.finish()?;
            let what = "form for the answers, filled in and given to `vibank grade`";
            shown.push((FORM.to_owned(), what));
        }
        // Last of all: a manifest with an end says that whatever it names is there.
        self.manifest.write(end(items, &digest, files).as_bytes())?;
        self.manifest.finish()?;
        shown.push((self.name, "what marking needs; keep it to yourself"));
        Ok(shown)
    }
}

/// The rows of a sheet in the form.
fn rows(form: &mut Draft, dialect: Dialect, variant: &VariantEntry) -> Result<(), Failure> {
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
            form.write(&dialect.line(&fields)?)?;
        }
    }
    Ok(())
}

/// What stands before the variants.
fn head(origin: Origin<'_>) -> String {
    let Origin {
        plan,
        catalogue,
        choice,
        shard,
        stamp,
    } = origin;
    let blueprint = plan.blueprint;
    let name = Path::new(&*blueprint.source.path)
        .file_name()
        .map(|name| name.to_string_lossy().into_owned());
    let head = Manifest {
        format: FORMAT,
        program: PROGRAM.to_owned(),
        bank: BankStamp {
            title: catalogue.bank.title.clone(),
            digest: catalogue.digest(),
        },
        blueprint: FileStamp {
            path: name.unwrap_or_default(),
            digest: files::digest(blueprint.source.text.as_bytes()),
        },
        title: blueprint.title.clone(),
        data: blueprint.data,
        language: blueprint.language.value.clone(),
        decimal: blueprint.decimal,
        doubt: blueprint.doubt.unwrap_or(Doubt::Benefit),
        other_form: blueprint.other_form.map(|share| share.share().to_f64()),
        marks: blueprint.marks.clone(),
        csv: blueprint.csv,
        paper: blueprint.paper,
        keyed: plan.secret.is_some(),
        shard: shard.to_string(),
        inputs: stamp.inputs.clone(),
        look: stamp.look.clone(),
        formats: choice.made.clone(),
        press: choice.press.as_ref().map(|press| press.digest().to_owned()),
        fonts: choice.faces.stamps.clone(),
        variants: Vec::new(),
        items: BTreeMap::new(),
        form: String::new(),
        files: BTreeMap::new(),
    };
    begin(&head)
}

/// What stands before the sheets of a manifest, which has none yet.
fn begin(bare: &Manifest) -> String {
    let head = serde_json::to_string(bare).expect("a manifest is plain data");
    head.strip_suffix("],\"files\":{}}")
        .expect("variants and files come last, and there are none")
        .to_owned()
}

/// What comes after the sheets of a manifest.
fn end(items: &BTreeMap<String, String>, form: &str, files: &BTreeMap<String, String>) -> String {
    let end = json!({ "items": items, "form": form, "files": files }).to_string();
    let end = end
        .strip_prefix('{')
        .expect("an object begins with a brace");
    format!("\n],{end}\n")
}

/// A manifest as a run writes it, line by line.
pub(crate) fn written(mut manifest: Manifest) -> String {
    let variants = std::mem::take(&mut manifest.variants);
    let items = std::mem::take(&mut manifest.items);
    let form = std::mem::take(&mut manifest.form);
    let files = std::mem::take(&mut manifest.files);
    let lines: Vec<String> = variants
        .iter()
        .map(|variant| serde_json::to_string(variant).expect("an entry is plain data"))
        .collect();
    let before = if lines.is_empty() { "" } else { "\n" };
    let (begin, end) = (begin(&manifest), end(&items, &form, &files));
    format!("{begin}{before}{}{end}", lines.join(",\n"))
}
