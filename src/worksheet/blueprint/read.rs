//! Reading a blueprint.

use std::collections::BTreeSet;

use super::{
    AnswerSpace, Audience, Blueprint, BlueprintError, Choice, Columns, FORMATS, Filter, Keys,
    MAX_QUESTIONS, MAX_TITLE_LENGTH, MAX_VARIANTS, Question,
};
use crate::answer::{Credit, Doubt};
use crate::bank::Space;
use crate::diagnostic::{Finding, Severity};
use crate::document::read_bare;
use crate::message::Language;
use crate::scene;
use crate::source::{Data, Source, Span, Table, Text, Value};
use crate::worksheet::manifest::Csv;
use crate::worksheet::marks::{self, Marks};
use crate::worksheet::own::Own;
use crate::worksheet::paper::Paper;
use crate::worksheet::printing::Printing;
use crate::worksheet::rules::Rules;

pub(crate) struct Faults<'s> {
    pub(crate) source: &'s Source,
    pub(crate) findings: Vec<Finding>,
    /// What refuses nothing.
    pub(crate) warnings: Vec<Finding>,
}

impl Faults<'_> {
    pub(crate) fn add(&mut self, error: &BlueprintError) {
        self.findings.push(Finding::of(error, self.source));
    }

    /// Notes what was found out about a question of its own.
    pub(crate) fn found(&mut self, finding: Finding) {
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
        Space::read(&text.value)
            .map_err(|error| self.add(&BlueprintError::Space(error, text.span)))
            .ok()
    }

    /// The meaning of a word out of a short list.
    pub(crate) fn word<T: Copy>(
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
    let (marks, mut findings) = marks::read(&table);
    let counted = questions.iter().filter(|question| !question.bonus);
    let sections: Vec<&str> = counted.flat_map(Question::sections).collect();
    let lacking = marks::check(&marks, &sections, table.span());
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
    table
        .has("doubt")
        .then(|| faults.word(table, "doubt", &["benefit", "ask", "undecided"], &ways))
}

pub(crate) fn blueprint<'s>(
    table: Table<'_>,
    mut faults: Faults<'s>,
) -> (Option<Blueprint>, Faults<'s>) {
    let keys = keys(&table, &mut faults);
    let questions = questions(&table, &mut faults);
    let title = title(&table, &mut faults);
    let [course, date, duration] = [
        ("course", "letters in the course"),
        ("date", "letters in the date"),
        ("duration", "letters in the duration"),
    ]
    .map(|(key, of)| line(&table, key, of, &mut faults));
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
        let (document, mut found) = read_bare(&text, faults.source);
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
        course,
        date,
        duration,
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
        scan_marks: table.boolean("scan_marks").unwrap_or(false),
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

fn title(table: &Table<'_>, faults: &mut Faults<'_>) -> Option<String> {
    let title = table.required_text("title")?;
    let letters = title.value.chars().count();
    let of = "letters in the title";
    faults.at_most(MAX_TITLE_LENGTH, letters, of, Some(title.span));
    Some(title.value)
}

/// A line that is printed on each page of each sheet, and so has no more letters than a title.
fn line(table: &Table<'_>, key: &'static str, of: &'static str, faults: &mut Faults<'_>) -> String {
    let Some(text) = table.text(key) else {
        return String::new();
    };
    let letters = text.value.chars().count();
    faults.at_most(MAX_TITLE_LENGTH, letters, of, Some(text.span));
    text.value
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
    let headings = Columns::ROLES.into_iter().filter_map(|key| {
        let value = table.value(key)?;
        let headings = match &value.data {
            Data::List(_) => table.texts(key),
            _ => table.as_text(key, value).into_iter().collect(),
        };
        Some((key, headings))
    });
    let headings = headings.collect();
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
    let points = table.value("points");
    let points = points.and_then(|value| points_of(&table, "points", value));
    let part_points = table.table("part_points").map(part_points);
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
        part_points: part_points.unwrap_or_default(),
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

fn part_points(table: Table<'_>) -> Vec<(Text, f64)> {
    let entries = table.entries().iter();
    entries
        .filter_map(|entry| {
            let points = points_of(&table, &entry.key, &entry.value)?;
            Some((entry.name(), points))
        })
        .collect()
}

/// Points that can be given: sums of them stay exact, and their shares show in print.
fn points_of(table: &Table<'_>, key: &str, value: &Value) -> Option<f64> {
    let expected = "a number of points from 0.001 to 1000000";
    table.as_number_in(key, value, expected, 0.001..=1e6)
}

fn spaces(table: &Table<'_>, faults: &mut Faults<'_>) -> Vec<(Text, Space)> {
    let entries = table.entries().iter();
    entries
        .filter_map(|entry| {
            let text = table.as_text(&entry.key, &entry.value)?;
            Some((entry.name(), faults.space(&text)?))
        })
        .collect()
}

fn settings(table: Table<'_>) -> Vec<(Text, Text)> {
    let entries = table.entries().iter();
    entries
        .filter_map(|entry| {
            let formula = table.as_formula(&entry.key, &entry.value)?;
            Some((entry.name(), formula))
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
