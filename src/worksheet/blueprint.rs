//! A blueprint: what a sheet is made of, as a teacher writes it.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::manifest::Csv;
use super::marks::Marks;
use super::own::Own;
use super::printing::Printing;
use super::rules::Rules;
use crate::answer::{Credit, Doubt};
use crate::bank::{Space, SpaceError};
use crate::diagnostic::{Code, Diagnose, Finding, Label, Severity};
use crate::document::Document;
use crate::message::Language;
use crate::scene;
use crate::source::{Data, Problems, Source, Span, Table, Text, nearest, toml};

/// Where answers are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AnswerSpace {
    /// Ruled lines.
    #[default]
    Lines,
    /// Boxes.
    Boxes,
    /// Nowhere: on paper of their own.
    None,
}

/// The headings of a class list for what is known of a student; several are joined.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Columns {
    /// Headings by what they are, as [`Self::ROLES`] has it.
    pub headings: Vec<(&'static str, Vec<Text>)>,
}

impl Columns {
    /// What may be known of a student.
    pub const ROLES: [&'static str; 8] = [
        "id",
        "name",
        "group",
        "room",
        "seat",
        "language",
        "large_print",
        "extra_time",
    ];
}

/// Which keys are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Keys {
    /// One page for all variants.
    pub table: bool,
    /// One page for each variant.
    pub each: bool,
}

/// For whom sheets are made.
#[derive(Clone, Debug, PartialEq)]
pub enum Audience {
    /// So many variants.
    Variants(usize),
    /// One sheet for each row of this class list.
    Students(Text),
}

/// What a sheet is made of.
#[derive(Clone, Debug)]
pub struct Blueprint {
    /// The file it was read from.
    pub source: Source,
    /// Printed at the top.
    pub title: String,
    /// Name of the course; may be empty.
    pub course: String,
    /// Date as it is printed; may be empty.
    pub date: String,
    /// Duration as it is printed; may be empty.
    pub duration: String,
    /// Instructions; may be empty.
    pub instructions: Document,
    /// The number from which all seeds are derived.
    pub seed: u64,
    /// A file that keys the seeds.
    pub secret: Option<Text>,
    /// A folder with fonts for names.
    pub fonts: Option<Text>,
    /// For whom.
    pub audience: Audience,
    /// What the class list calls its columns, where that is stated.
    pub columns: Columns,
    /// How tables are written.
    pub csv: Csv,
    /// Sheets without a name beside those of a class list.
    pub spares: usize,
    /// Output formats, by name; HTML where none is named.
    pub formats: Vec<Text>,
    /// Whether formats are named. If not, PDF is made too where there is a press.
    pub names_formats: bool,
    /// `a4` or `letter`.
    pub paper: Paper,
    /// Language of headings, answer lines, remarks and feedback, `en` or `fr`; the texts of items are in that of their bank.
    pub language: Text,
    /// Decimal sign; where none is stated, that of the language: `,` in French.
    pub decimal: char,
    /// What becomes of answers with two readings, where that is stated.
    pub doubt: Option<Doubt>,
    /// What a right value is worth where a formula is asked, and the reverse, in place of what items say.
    pub other_form: Option<Credit>,
    /// Data as numbers or symbols.
    pub data: scene::Data,
    /// Whether figures are shown.
    pub figures: bool,
    /// Whether hints are printed.
    pub hints: bool,
    /// Where it says that the formulas of the chapters are printed after the questions, if it does.
    pub formula_sheet: Option<Span>,
    /// Where answers are written.
    pub answer_space: AnswerSpace,
    /// Room for work at each part that has none of its own, where it is stated.
    pub space: Option<Space>,
    /// Whether the order of the questions is drawn.
    pub shuffle: bool,
    /// Which keys are made.
    pub keys: Keys,
    /// Whether worked solutions are made.
    pub solutions: bool,
    /// What is made for the printer, if it is wanted.
    pub print: Option<Printing>,
    /// The rules of the page that is made of it for a course.
    pub rules: Rules,
    /// What becomes of the points of a sheet, where that is stated.
    pub marks: Option<Marks>,
    /// The questions in the order of the blueprint.
    pub questions: Vec<Question>,
    /// What may be wrong with its own questions.
    pub warnings: Vec<Finding>,
}

/// Size of the paper.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Paper {
    /// 210 mm by 297 mm.
    #[default]
    A4,
    /// 8.5 in by 11 in.
    Letter,
}

/// One `[[question]]`.
#[derive(Clone, Debug)]
pub struct Question {
    /// Where its header stands.
    pub span: Span,
    /// Where its item comes from.
    pub choice: Choice,
    /// The parts that are asked; all if empty.
    pub parts: Vec<Text>,
    /// Points of the whole question; else the sum over its parts.
    pub points: Option<f64>,
    /// Points of single parts, by name.
    pub part_points: Vec<(Text, f64)>,
    /// Room for work at each of its parts, in place of what the item says.
    pub space: Option<Space>,
    /// Room for work at single parts and groups, by name.
    pub part_space: Vec<(Text, Space)>,
    /// Data that are fixed, as name and quantity.
    pub set: Vec<(Text, Text)>,
    /// Whether its points are beyond those of the sheet.
    pub bonus: bool,
    /// Its section, of which the best questions may count.
    pub section: Option<Text>,
}

/// Where the item of a question comes from.
#[derive(Clone, Debug)]
pub enum Choice {
    /// A certain item.
    Item(Text),
    /// None: the question stands in the blueprint.
    Own(Arc<Own>),
    /// Any items that pass a filter.
    Pick {
        /// What they have to be.
        filter: Filter,
        /// How many questions are made of it.
        count: usize,
        /// Whether all variants get the same items.
        same: bool,
    },
}

/// What an item has to be; all that is stated has to hold.
#[derive(Clone, Debug, Default)]
pub struct Filter {
    /// One of these items.
    pub items: Vec<Text>,
    /// Of this chapter.
    pub chapter: Option<Text>,
    /// With this topic.
    pub topic: Option<Text>,
    /// Of one of these levels.
    pub levels: Vec<i64>,
    /// With a part of this kind.
    pub kind: Option<Text>,
}

/// What is wrong with a blueprint beyond its form.
#[derive(Clone, Debug, thiserror::Error)]
pub enum BlueprintError {
    /// Two keys of which one is due.
    #[error("a blueprint has either `{0}` or `{1}`")]
    Either(&'static str, &'static str, Span),
    /// A word that is none of the known ones.
    #[error("`{key}` cannot be `{found}`")]
    Word {
        /// The key of the blueprint, as it is written.
        key: &'static str,
        /// The word.
        found: String,
        /// What it can be.
        known: &'static [&'static str],
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A working space that is none.
    #[error("{0}")]
    Space(SpaceError, Span),
    /// `columns` without a class list.
    #[error("`columns` names headings of a class list, and there is none")]
    Columns(Span),
    /// No `[[question]]`.
    #[error("the blueprint has no question")]
    NoQuestion,
    /// More of something than a sheet can have.
    #[error("there are {found} {of}, at most {most} are read")]
    TooMany {
        /// What there are many of.
        of: &'static str,
        /// The number that is asked for.
        found: usize,
        /// The largest number that is accepted.
        most: usize,
        /// The bytes of the text that the message points at.
        span: Span,
    },
    /// A public number and a file that keys the seeds.
    #[error("a blueprint has either `seed` or `secret`")]
    SeedAndSecret(Span),
    /// Sheets beside a class list that is not there.
    #[error("`spares` stands beside `students` alone")]
    SparesWithoutList(Span),
    /// No output format.
    #[error("`formats` is empty, so that no sheet would be written")]
    NoFormat(Span),
    /// `[print]` without a format that is printed.
    #[error("`[print]` makes files for the printer, of which there are none in these formats")]
    NothingToPrint(Span),
    /// An `id` of `[page]` that is no name.
    #[error("the `id` of a page has 1 to 64 letters, digits, dots and hyphens")]
    PageId(Span),
    /// A question without anything to ask.
    #[error("a question has one of `item`, `pick` and `statement`")]
    Nothing(Span),
    /// A question of one's own that also names an item.
    #[error("a question of your own has no `{0}`")]
    OwnAndItem(&'static str, Span),
    /// An `id` of a question of one's own that is no name.
    #[error("the `id` of a question has 1 to 80 small letters, digits and hyphens")]
    OwnId(Span),
    /// Two questions of one's own with one name.
    #[error("another question of your own has the name `{0}`")]
    OwnTwice(String, Span),
    /// Something else between the lines of a question.
    #[error("this stands between the lines of a question of your own")]
    OwnApart(Span),
    /// A question of one's own in braces.
    #[error("a question of your own has a header `[[question]]`")]
    OwnInline(Span),
    /// An output format that is listed twice.
    #[error("the format `{0}` is listed twice")]
    FormatTwice(String, Span),
}

impl Diagnose for BlueprintError {
    fn code(&self) -> Code {
        Code::BLUEPRINT
    }

    fn labels(&self) -> Vec<Label> {
        match self {
            Self::Either(_, _, span)
            | Self::Columns(span)
            | Self::Space(_, span)
            | Self::Word { span, .. }
            | Self::TooMany { span, .. }
            | Self::SeedAndSecret(span)
            | Self::SparesWithoutList(span)
            | Self::NoFormat(span)
            | Self::NothingToPrint(span)
            | Self::PageId(span)
            | Self::Nothing(span)
            | Self::OwnAndItem(_, span)
            | Self::OwnId(span)
            | Self::OwnTwice(_, span)
            | Self::OwnApart(span)
            | Self::OwnInline(span)
            | Self::FormatTwice(_, span) => vec![Label {
                span: *span,
                text: String::new(),
            }],
            Self::NoQuestion => Vec::new(),
        }
    }

    fn help(&self) -> Option<String> {
        Some(match self {
            Self::Either(a, b, _) => format!("write one of `{a}` and `{b}`"),
            Self::Word { known, found, .. } => {
                let near = nearest(found, known.iter().copied());
                let near = near.map_or_else(String::new, |near| format!("did you mean `{near}`? "));
                format!("{near}it can be {}", known.join(", "))
            }
            Self::Space(..) => SpaceError::HELP.to_owned(),
            Self::Columns(_) => "name the list with `students`, or remove `columns`".to_owned(),
            Self::NoQuestion => "add a `[[question]]` with an `item`".to_owned(),
            Self::TooMany { of, .. } => format!("write fewer {of}"),
            Self::SeedAndSecret(_) => {
                "for an exam keep `secret` and remove `seed`; `vibank new secret FILE` makes a secret"
                    .to_owned()
            }
            Self::SparesWithoutList(_) => "raise `variants` instead".to_owned(),
            Self::NoFormat(_) => {
                let known = FORMATS.join(", ");
                format!("list at least one of {known}, or remove the key for html")
            }
            Self::NothingToPrint(_) => {
                "add `pdf` or `html` to `formats`, or remove `[print]`".to_owned()
            }
            Self::PageId(_) => "write a name such as `dynamics-week-3`, and keep it".to_owned(),
            Self::Nothing(_) => {
                "name an `item`, `pick` among items, or write `statement` and `[[question.part]]` of your own"
                    .to_owned()
            }
            Self::OwnAndItem(key, _) => {
                format!("remove `{key}`, or `statement` and `[[question.part]]`")
            }
            Self::OwnId(_) => "write a name such as `bungee-jump`, and keep it".to_owned(),
            Self::OwnTwice(..) => "give one of them another `id`".to_owned(),
            Self::OwnApart(_) => "move it above the first `[[question]]`".to_owned(),
            Self::OwnInline(_) => "write `[[question]]` above its keys, without braces".to_owned(),
            Self::FormatTwice(..) => "list each format once".to_owned(),
        })
    }
}

/// What a sheet can be written as: the formats of pages, then those of programs.
pub const FORMATS: &[&str] = &["html", "md", "pdf", "tex", "json", "xlsx"];

/// Most variants that one run makes.
const MAX_VARIANTS: i64 = 100_000;

/// Most questions of a sheet.
const MAX_QUESTIONS: usize = 200;

/// Most letters of a title.
const MAX_TITLE_LENGTH: usize = 300;

impl Blueprint {
    /// Whether a file is meant to be a blueprint, sound or not: it asks questions, which items do not.
    pub fn is_meant(source: &Source) -> bool {
        let problems = Problems::default();
        let value = toml::read(source, &problems);
        let table = Table::of(source, &problems, "", &value);
        table.is_some_and(|table| {
            let has = |keys: &[&'static str]| keys.iter().any(|key| table.has(key));
            has(&["question", "variants", "students"]) && !has(&["item", "part", "statement"])
        })
    }

    /// The questions of its own, which stand in it.
    pub fn own_questions(&self) -> impl Iterator<Item = &Own> {
        self.questions.iter().filter_map(|own| match &own.choice {
            Choice::Own(own) => Some(&**own),
            _ => None,
        })
    }

    /// Reads a blueprint.
    ///
    /// # Errors
    ///
    /// All findings at once. Warnings about questions of its own refuse nothing: they are [`Self::warnings`].
    pub fn read(source: &Source) -> Result<Self, Vec<Finding>> {
        let problems = Problems::default();
        let value = toml::read(source, &problems);
        let faults = Faults {
            source,
            findings: Vec::new(),
            warnings: Vec::new(),
        };
        let (blueprint, faults) = match Table::of(source, &problems, "", &value) {
            Some(table) => blueprint(table, faults),
            None => (None, faults),
        };
        let mut findings: Vec<Finding> = problems
            .take()
            .iter()
            .map(|problem| Finding::of(problem, source))
            .collect();
        findings.extend(faults.findings);
        Finding::sort(&mut findings);
        match blueprint {
            Some(blueprint) if findings.is_empty() => Ok(Self {
                warnings: faults.warnings,
                ..blueprint
            }),
            _ => {
                findings.extend(faults.warnings);
                Finding::sort(&mut findings);
                Err(findings)
            }
        }
    }
}

impl Question {
    /// The section of each question that is made of it; the nameless one where it states none.
    fn sections(&self) -> impl Iterator<Item = &str> {
        let count = match &self.choice {
            Choice::Item(_) | Choice::Own(_) => 1,
            Choice::Pick { count, .. } => *count,
        };
        let section = self.section.as_ref().map_or("", |text| text.value.as_str());
        std::iter::repeat_n(section, count)
    }
}

pub(super) struct Faults<'s> {
    source: &'s Source,
    findings: Vec<Finding>,
    /// What refuses nothing.
    warnings: Vec<Finding>,
}

impl Faults<'_> {
    pub(super) fn add(&mut self, error: &BlueprintError) {
        self.findings.push(Finding::of(error, self.source));
    }

    /// Notes what was found out about a question of its own.
    pub(super) fn found(&mut self, finding: Finding) {
        if finding.severity == Severity::Error {
            self.findings.push(finding);
        } else {
            self.warnings.push(finding);
        }
    }

    /// Notes more of something than is read.
    fn at_most(&mut self, most: usize, found: usize, of: &'static str, place: Option<Span>) {
        if found > most {
            let span = place.unwrap_or(Span::NONE);
            self.add(&BlueprintError::TooMany {
                of,
                found,
                most,
                span,
            });
        }
    }

    /// The working space that a text names.
    fn space(&mut self, text: &Text) -> Option<Space> {
        let space = Space::read(&text.value);
        let fault = |error| self.add(&BlueprintError::Space(error, text.span));
        space.map_err(fault).ok()
    }

    /// The meaning of a word out of a short list.
    pub(super) fn word<T: Copy>(
        &mut self,
        table: &Table<'_>,
        key: &'static str,
        words: &'static [&'static str],
        values: &[T],
    ) -> T {
        let Some(text) = table.text(key) else {
            return values[0];
        };
        match words.iter().position(|word| *word == text.value) {
            Some(position) => values[position],
            None => {
                self.add(&BlueprintError::Word {
                    key,
                    found: text.value,
                    known: words,
                    span: text.span,
                });
                values[0]
            }
        }
    }
}

/// The questions, as many as a sheet can have.
fn questions(table: &Table<'_>, faults: &mut Faults<'_>) -> Vec<Question> {
    let tables = table.tables("question");
    let place = tables.get(MAX_QUESTIONS).map(Table::span);
    let of = "questions";
    faults.at_most(MAX_QUESTIONS, tables.len(), of, place);
    let tables = tables.into_iter().take(MAX_QUESTIONS).enumerate();
    let questions: Vec<Question> = tables
        .filter_map(|(place, own)| question(own, place, table, faults))
        .collect();
    if !table.has("question") {
        faults.add(&BlueprintError::NoQuestion);
    }
    let mut known = BTreeSet::new();
    for question in &questions {
        if let Choice::Own(own) = &question.choice
            && !known.insert(&own.item.id)
        {
            let slug = own.item.id.slug().to_owned();
            faults.add(&BlueprintError::OwnTwice(slug, question.span));
        }
    }
    questions
}

/// The decimal sign: where none is stated, that of the language.
fn decimal(table: &Table<'_>, language: &str, faults: &mut Faults<'_>) -> char {
    if !table.has("decimal") && Language::of(language) == Some(Language::French) {
        return ',';
    }
    faults.word(table, "decimal", &[".", ","], &['.', ','])
}

/// How tables are written: a class with a decimal comma opens its files with spreadsheets that part cells by semicolons.
fn csv(table: &Table<'_>, decimal: char, faults: &mut Faults<'_>) -> Csv {
    if decimal == ',' && !table.has("csv") {
        return Csv::Excel;
    }
    let ways = [Csv::Plain, Csv::Excel];
    faults.word(table, "csv", &["plain", "excel"], &ways)
}

/// What becomes of the points of a sheet, where that is stated.
fn marks(table: &Table<'_>, questions: &[Question], faults: &mut Faults<'_>) -> Option<Marks> {
    let table = table.table("marks")?;
    let (marks, mut findings) = Marks::read(&table);
    let counted = questions.iter().filter(|question| !question.bonus);
    let sections: Vec<&str> = counted.flat_map(Question::sections).collect();
    let lacking = marks.check(&sections, table.span());
    findings.extend(
        lacking
            .iter()
            .map(|error| Finding::of(error, faults.source)),
    );
    faults.findings.append(&mut findings);
    Some(marks)
}

/// How doubts are settled, where that is stated.
fn doubt(table: &Table<'_>, faults: &mut Faults<'_>) -> Option<Doubt> {
    let ways = [Doubt::Benefit, Doubt::Ask, Doubt::Undecided];
    let read = || faults.word(table, "doubt", &["benefit", "ask", "undecided"], &ways);
    table.has("doubt").then(read)
}

fn blueprint<'s>(table: Table<'_>, mut faults: Faults<'s>) -> (Option<Blueprint>, Faults<'s>) {
    let line = |key| table.text(key).map(|text| text.value).unwrap_or_default();
    let keys = keys(&table, &mut faults);
    let questions = questions(&table, &mut faults);
    let title = table.required_text("title");
    if let Some(title) = &title {
        let letters = title.value.chars().count();
        let of = "letters in the title";
        faults.at_most(MAX_TITLE_LENGTH, letters, of, Some(title.span));
    }
    let title = title.map(|text| text.value);
    let audience = audience(&table, &mut faults);
    if let Some(value) = table.value("columns")
        && !table.has("students")
    {
        faults.add(&BlueprintError::Columns(value.span));
    }
    let spares = spares(&table, &mut faults);
    let secret = table.text("secret");
    let seed = table.integer("seed", "an integer, 0 or larger", 0..=i64::MAX);
    if seed.is_none() && secret.is_none() && !table.has("seed") {
        table.required("seed");
    }
    let names_formats = table.has("formats");
    if seed.is_some()
        && let Some(secret) = &secret
    {
        faults.add(&BlueprintError::SeedAndSecret(secret.span));
    }
    let formats = formats(&table, &mut faults);
    let language = table.text("language").unwrap_or_else(|| word("en"));
    let decimal = decimal(&table, &language.value, &mut faults);
    let csv = csv(&table, decimal, &mut faults);
    let doubt = doubt(&table, &mut faults);
    let instructions = table.text("instructions").map(|text| {
        let (document, mut found) = Document::read_bare(&text, faults.source);
        faults.findings.append(&mut found);
        document
    });
    let instructions = instructions.unwrap_or_default();
    let rules = table.table("page");
    let rules = rules.map(|table| Rules::read(&table, &mut faults));
    let marks = marks(&table, &questions, &mut faults);
    let is_whole = title.is_some() && audience.is_some();
    let read = Blueprint {
        source: table.source().clone(),
        title: title.unwrap_or_default(),
        course: line("course"),
        date: line("date"),
        duration: line("duration"),
        instructions,
        seed: seed.unwrap_or(0).unsigned_abs(),
        secret,
        fonts: table.text("fonts"),
        audience: audience.unwrap_or(Audience::Variants(0)),
        columns: table.table("columns").map(columns).unwrap_or_default(),
        csv,
        spares,
        print: print(&table, &formats, &mut faults),
        formats,
        names_formats,
        paper: faults.word(
            &table,
            "paper",
            &["a4", "letter"],
            &[Paper::A4, Paper::Letter],
        ),
        language,
        decimal,
        doubt,
        other_form: Credit::of_table(&table, "other_form"),
        data: faults.word(
            &table,
            "data",
            &["both", "numbers", "symbols"],
            &[
                scene::Data::Both,
                scene::Data::Numbers,
                scene::Data::Symbols,
            ],
        ),
        figures: table.boolean("figures").unwrap_or(true),
        hints: table.boolean("hints").unwrap_or(false),
        formula_sheet: formula_sheet(&table),
        answer_space: faults.word(
            &table,
            "answer_space",
            &["lines", "boxes", "none"],
            &[AnswerSpace::Lines, AnswerSpace::Boxes, AnswerSpace::None],
        ),
        space: table.text("space").and_then(|text| faults.space(&text)),
        shuffle: table.boolean("shuffle").unwrap_or(false),
        keys,
        solutions: table.boolean("solutions").unwrap_or(true),
        rules: rules.unwrap_or_default(),
        marks,
        questions,
        warnings: Vec::new(),
    };
    table.finish();
    (is_whole.then_some(read), faults)
}

/// Where it says that the formulas of the chapters are printed, if it does.
fn formula_sheet(table: &Table<'_>) -> Option<Span> {
    let is_on = table.boolean("formula_sheet").unwrap_or(false);
    let value = table.value("formula_sheet").filter(|_| is_on);
    value.map(|value| value.span)
}

/// What is made for the printer, of the formats that are printed.
fn print(table: &Table<'_>, formats: &[Text], faults: &mut Faults<'_>) -> Option<Printing> {
    let print = table.table("print")?;
    let mut formats = formats.iter().map(|format| format.value.as_str());
    if !formats.any(|format| matches!(format, "html" | "pdf")) {
        faults.add(&BlueprintError::NothingToPrint(print.span()));
    }
    Some(Printing::read(&print, faults))
}

fn word(value: &str) -> Text {
    Text {
        value: value.to_owned(),
        span: Span::NONE,
    }
}

/// Sheets without a name, which only a class list leaves room for.
fn spares(table: &Table<'_>, faults: &mut Faults<'_>) -> usize {
    let spares = table.integer("spares", "an integer from 0 to 1000", 0..=1000);
    if let Some(value) = table.value("spares").filter(|_| table.has("variants")) {
        faults.add(&BlueprintError::SparesWithoutList(value.span));
    }
    spares.unwrap_or(0) as usize
}

fn audience(table: &Table<'_>, faults: &mut Faults<'_>) -> Option<Audience> {
    let variants = table.integer("variants", "an integer from 1 to 100000", 1..=MAX_VARIANTS);
    let students = table.text("students");
    match (variants, students) {
        (Some(count), None) => Some(Audience::Variants(count as usize)),
        (None, Some(list)) => Some(Audience::Students(list)),
        (None, None) if table.has("variants") || table.has("students") => None,
        (_, _) => {
            faults.add(&BlueprintError::Either(
                "variants",
                "students",
                table.span(),
            ));
            None
        }
    }
}

fn columns(table: Table<'_>) -> Columns {
    let heading = |key: &'static str| {
        let value = table.value(key)?;
        let headings = match &value.data {
            Data::List(_) => table.texts(key),
            _ => table.as_text(key, value).into_iter().collect(),
        };
        Some((key, headings))
    };
    let headings = Columns::ROLES.into_iter().filter_map(heading).collect();
    table.finish();
    Columns { headings }
}

/// The output formats, each once; HTML where none is asked for.
fn formats(table: &Table<'_>, faults: &mut Faults<'_>) -> Vec<Text> {
    let Some(value) = table.value("formats") else {
        return vec![word("html")];
    };
    let span = value.span;
    let formats = table.texts("formats");
    let is_empty_list = matches!(&value.data, crate::source::Data::List(items) if items.is_empty());
    if is_empty_list {
        faults.add(&BlueprintError::NoFormat(span));
    }
    for (place, format) in formats.iter().enumerate() {
        if !FORMATS.contains(&format.value.as_str()) {
            faults.add(&BlueprintError::Word {
                key: "formats",
                found: format.value.clone(),
                known: FORMATS,
                span: format.span,
            });
        }
        let mut earlier = formats[..place].iter();
        if earlier.any(|other| other.value == format.value) {
            let name = format.value.clone();
            faults.add(&BlueprintError::FormatTwice(name, format.span));
        }
    }
    formats
}

fn keys(table: &Table<'_>, faults: &mut Faults<'_>) -> Keys {
    let mut keys = Keys {
        table: !table.has("keys"),
        each: !table.has("keys"),
    };
    for text in table.texts("keys") {
        match text.value.as_str() {
            "table" => keys.table = true,
            "each" => keys.each = true,
            _ => {
                let (found, span) = (text.value.clone(), text.span);
                faults.add(&BlueprintError::Word {
                    key: "keys",
                    found,
                    known: &["table", "each"],
                    span,
                });
            }
        }
    }
    keys
}

fn question(
    table: Table<'_>,
    place: usize,
    whole: &Table<'_>,
    faults: &mut Faults<'_>,
) -> Option<Question> {
    let choice = choice(&table, place, whole, faults);
    let set = table.table("set").map(settings).unwrap_or_default();
    let parts = table.texts("parts");
    let points = table.number("points");
    let part_points = table.table("part_points").map(numbers).unwrap_or_default();
    let space = table.text("space").and_then(|text| faults.space(&text));
    let part_space = table.table("part_space");
    let part_space = part_space.map_or_else(Vec::new, |table| spaces(&table, faults));
    let bonus = table.boolean("bonus").unwrap_or(false);
    let section = table.text("section");
    let span = table.span();
    table.finish();
    Some(Question {
        span,
        choice: choice?,
        parts,
        points,
        part_points,
        space,
        part_space,
        set,
        bonus,
        section,
    })
}

/// Where the item of a question comes from.
fn choice(
    table: &Table<'_>,
    place: usize,
    whole: &Table<'_>,
    faults: &mut Faults<'_>,
) -> Option<Choice> {
    let item = table.text("item");
    let pick = table.table("pick").map(filter);
    let count = table
        .integer("count", "an integer from 1 to 100", 1..=100)
        .unwrap_or(1) as usize;
    let same = table.boolean("same").unwrap_or(true);
    if Own::is_meant(table) {
        let others = ["item", "pick", "count", "same"];
        let mut others = others.into_iter();
        if let Some((key, other)) = others.find_map(|key| Some((key, table.entry(key)?))) {
            faults.add(&BlueprintError::OwnAndItem(key, other.span));
        }
        return Own::read(table, place, whole, faults).map(Choice::Own);
    }
    match (item, pick) {
        (Some(item), None) => Some(Choice::Item(item)),
        (None, Some(filter)) => Some(Choice::Pick {
            filter,
            count,
            same,
        }),
        (None, None) => {
            faults.add(&BlueprintError::Nothing(table.span()));
            None
        }
        (Some(_), Some(_)) => {
            faults.add(&BlueprintError::Either("item", "pick", table.span()));
            None
        }
    }
}

fn numbers(table: Table<'_>) -> Vec<(Text, f64)> {
    let entries = table.entries().iter();
    entries
        .filter_map(|entry| {
            let name = Text {
                value: entry.key.clone(),
                span: entry.span,
            };
            Some((name, table.as_number(&entry.key, &entry.value)?))
        })
        .collect()
}

fn spaces(table: &Table<'_>, faults: &mut Faults<'_>) -> Vec<(Text, Space)> {
    let entries = table.entries().iter();
    entries
        .filter_map(|entry| {
            let name = Text {
                value: entry.key.clone(),
                span: entry.span,
            };
            let text = table.as_text(&entry.key, &entry.value)?;
            Some((name, faults.space(&text)?))
        })
        .collect()
}

fn settings(table: Table<'_>) -> Vec<(Text, Text)> {
    let entries = table.entries().iter();
    entries
        .filter_map(|entry| {
            let name = Text {
                value: entry.key.clone(),
                span: entry.span,
            };
            Some((name, table.as_formula(&entry.key, &entry.value)?))
        })
        .collect()
}

fn filter(table: Table<'_>) -> Filter {
    let levels = match table.value("level") {
        Some(
            value @ crate::source::Value {
                data: Data::List(_),
                ..
            },
        ) => table
            .items("level", value)
            .iter()
            .filter_map(|item| level(&table, item))
            .collect(),
        Some(value) => level(&table, value).into_iter().collect(),
        None => Vec::new(),
    };
    let filter = Filter {
        items: table.texts("items"),
        chapter: table.text("chapter"),
        topic: table.text("topic"),
        levels,
        kind: table.text("kind"),
    };
    table.finish();
    filter
}

fn level(table: &Table<'_>, value: &crate::source::Value) -> Option<i64> {
    match &value.data {
        Data::Number { number } => number.parse().ok().filter(|level| (1..=3).contains(level)),
        _ => None,
    }
    .or_else(|| table.wrong("level", "1, 2 or 3", value))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Blueprint, Vec<String>> {
        Blueprint::read(&Source::new("b.toml", text))
            .map_err(|all| all.iter().map(ToString::to_string).collect())
    }

    #[test]
    fn the_smallest_blueprint_has_the_defaults() {
        let blueprint =
            read("title = 'T'\nseed = 1\nvariants = 2\n[[question]]\nitem = 'ch1/a'\n").unwrap();
        assert_eq!(blueprint.audience, Audience::Variants(2));
        assert!(
            blueprint.figures && blueprint.solutions && blueprint.keys.table && blueprint.keys.each
        );
        assert_eq!(blueprint.formats[0].value, "html");
    }

    #[test]
    fn all_faults_come_at_once_with_their_places() {
        let faults =
            read("title = 3\nseed = 1\nvariants = 0\npaper = 'a3'\nfigure = true\n[[question]]\n")
                .unwrap_err();
        let all = faults.join("\n");
        for part in [
            "b.toml:1:9",
            "b.toml:3:12",
            "b.toml:6:1",
            "`item`, `pick` and `statement`",
        ] {
            assert!(all.contains(part), "{part} is missing in\n{all}");
        }
    }
}
