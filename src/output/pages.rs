//! What the layouts are filled with.

use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;
use tera::Value;

use super::Writer;
use super::key_table::KeyRow;
use super::layouts::{Layouts, OutputError, font};
use super::lists::List;
use super::view::{SheetView, View};
use super::words::Words;
use crate::bank::Chapter;
use crate::document::{Block, Document, Inline};
use crate::math::{Voice, quote};
use crate::message::Language;
use crate::numerics::Rational;
use crate::scene::{Data, Shown};
use crate::unit::DecimalMark;
use crate::worksheet::{AnswerSpace, Blueprint, Paper, Sheet, Student};

/// What a page is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum PageKind {
    /// Questions with room for answers.
    Sheet,
    /// Answers alone.
    Key,
    /// Questions with worked solutions.
    Solutions,
}

/// How names are printed that the fonts of a format lack.
#[derive(Clone, Debug, Default)]
pub struct Names {
    /// Families of fonts for them, in the order in which they are tried.
    pub families: Vec<String>,
    /// Names, ids and groups that none of them has: in place of a name the `id` of the student is printed.
    pub without: BTreeSet<String>,
}

/// What all pages of a run have in common.
#[derive(Clone, Debug, Serialize)]
pub struct Run {
    /// Title of the sheet.
    pub title: String,
    /// Name of the course.
    pub course: String,
    /// Date as printed.
    pub date: String,
    /// Duration as printed.
    pub duration: String,
    /// Instructions, written.
    pub instructions: String,
    /// The formulas of the chapters, written; may be empty.
    pub formulas: String,
    /// `lines`, `boxes` or `none`.
    pub answer_space: &'static str,
    /// The words of the layouts, in the language of the run.
    pub(crate) words: &'static Words,
    /// Whether the students have seats, so that sheets have room for one.
    pub has_seats: bool,
    #[serde(skip)]
    pub(crate) language: String,
    #[serde(skip)]
    pub(crate) paper: Paper,
    #[serde(skip)]
    pub(crate) data: Data,
    #[serde(skip)]
    pub(crate) hints: bool,
    #[serde(skip)]
    pub(crate) figures: bool,
    #[serde(skip)]
    pub(crate) mark: DecimalMark,
    /// Whether sheets have marks by which scans of them are sorted.
    #[serde(skip)]
    pub(crate) scan_marks: bool,
    /// Whether the seeds are keyed with a secret, so that pages that are handed out must not tell them.
    #[serde(skip)]
    pub(crate) is_keyed: bool,
    #[serde(skip)]
    pub(crate) names: Names,
}

/// Fills the layouts of one format.
pub struct Pages {
    pub(crate) writer: &'static dyn Writer,
    pub(crate) layouts: Layouts,
    pub(crate) run: Run,
    /// The run as the layouts see it.
    shown: Value,
}

/// A page, written.
#[derive(Clone, Debug, Default)]
pub struct Page {
    /// What is written to the file, in the notation of the format.
    pub text: String,
    /// The figures that its notation cannot hold: the name of each, and its SVG.
    pub pictures: BTreeMap<String, String>,
}

#[derive(Serialize)]
struct Begin<'a> {
    title: &'a str,
    subtitle: &'a str,
    language: &'a str,
    paper: &'a str,
    program: &'a str,
    style: &'a str,
    families: Vec<String>,
    font: String,
    words: &'static Words,
}

#[derive(Serialize)]
struct SheetPage<'a> {
    run: &'a Value,
    sheet: SheetView,
}

impl Run {
    /// What the pages of a grading run have in common.
    pub fn plain(title: &str, language: &str, decimal: char) -> Self {
        Self {
            title: title.to_owned(),
            course: String::new(),
            date: String::new(),
            duration: String::new(),
            instructions: String::new(),
            formulas: String::new(),
            answer_space: "none",
            words: Words::of(spoken(language)),
            has_seats: false,
            language: language.to_owned(),
            paper: Paper::A4,
            data: Data::Both,
            hints: false,
            figures: true,
            scan_marks: false,
            is_keyed: true,
            names: Names::default(),
            mark: DecimalMark::of_char(decimal).unwrap_or_default(),
        }
    }

    /// What the pages of a blueprint have in common, in one notation.
    pub fn of(blueprint: &Blueprint, writer: &dyn Writer) -> Self {
        let instructions = &blueprint.instructions;
        let is_empty = instructions.is_empty();
        Self {
            title: blueprint.title.clone(),
            course: blueprint.course.clone(),
            date: blueprint.date.clone(),
            duration: blueprint.duration.clone(),
            instructions: if is_empty {
                String::new()
            } else {
                writer.line(instructions, spoken(&blueprint.language.value).voice())
            },
            formulas: String::new(),
            answer_space: match blueprint.answer_space {
                AnswerSpace::Lines => "lines",
                AnswerSpace::Boxes => "boxes",
                AnswerSpace::None => "none",
            },
            words: Words::of(spoken(&blueprint.language.value)),
            has_seats: false,
            language: blueprint.language.value.clone(),
            paper: blueprint.paper,
            data: blueprint.data,
            hints: blueprint.hints,
            figures: blueprint.figures,
            scan_marks: blueprint.scan_marks,
            is_keyed: blueprint.secret.is_some(),
            names: Names::default(),
            mark: DecimalMark::of_char(blueprint.decimal).unwrap_or_default(),
        }
    }

    /// The same on this paper.
    #[must_use]
    pub fn with_paper(self, paper: Paper) -> Self {
        Self { paper, ..self }
    }

    /// The same with names printed in this way.
    #[must_use]
    pub fn with_names(self, names: Names) -> Self {
        Self { names, ..self }
    }

    /// The same with room for the seats of these students, if they have some.
    #[must_use]
    pub fn with_seats(self, students: &[Student]) -> Self {
        let mut seats = students
            .iter()
            .map(|student| (&student.room, &student.seat));
        let has_seats = seats.any(|(room, seat)| !room.is_empty() || !seat.is_empty());
        Self { has_seats, ..self }
    }

    /// Room and seat of a student, as far as they can be printed.
    pub(crate) fn seat(&self, student: &Student) -> String {
        let words = [&student.room, &student.seat].map(|words| self.plain_name(words));
        let words = words.into_iter().filter(|words| !words.is_empty());
        words.collect::<Vec<_>>().join(", ")
    }

    /// What is printed as the name of a student.
    pub(crate) fn name<'n>(&self, name: &'n str, id: &'n str) -> &'n str {
        if self.names.without.contains(name) {
            self.plain_name(id)
        } else {
            name
        }
    }

    /// An id or a group, where it can be printed.
    pub(crate) fn plain_name<'n>(&self, words: &'n str) -> &'n str {
        if self.names.without.contains(words) {
            ""
        } else {
            words
        }
    }

    /// The same with the formulas of some chapters after the questions.
    #[must_use]
    pub fn with_formulas(mut self, chapters: &[&Chapter], writer: &dyn Writer) -> Self {
        for chapter in chapters {
            let title = Block::Heading {
                level: 3,
                content: vec![Inline::Text(chapter.title.clone())],
            };
            let title = Document::of(vec![title], Vec::new());
            for document in [&title, &chapter.formulas] {
                let shown = Shown {
                    document: Cow::Borrowed(document),
                    fillings: Vec::new(),
                };
                let texts = writer.texts(&[shown], self.voice());
                self.formulas.push_str(&texts);
                self.formulas.push_str("\n\n");
            }
        }
        self
    }

    /// Points in words, `2.5 points`.
    pub fn points(&self, points: Rational) -> String {
        let is_one = self.spoken().is_singular(points.to_f64());
        self.words.points(&self.number(points), is_one)
    }

    /// Points as a decimal of at most two places.
    pub(crate) fn number(&self, points: Rational) -> String {
        self.marked(&crate::grade::rounded(points))
    }

    /// The language in which responses are spoken about.
    pub(crate) fn spoken(&self) -> Language {
        spoken(&self.language)
    }

    /// The words with which formulas are heard.
    pub(crate) fn voice(&self) -> &'static Voice {
        self.spoken().voice()
    }

    /// Decimals with the sign of the run.
    pub(crate) fn marked(&self, decimals: &str) -> String {
        if self.mark == DecimalMark::Comma {
            decimals.replace('.', ",")
        } else {
            decimals.to_owned()
        }
    }
}

impl PageKind {
    /// The name of its layout and of its single file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Sheet => "worksheet",
            Self::Key => "key",
            Self::Solutions => "solutions",
        }
    }

    /// The folder of its files.
    pub fn folder(self) -> &'static str {
        match self {
            Self::Sheet => "sheets",
            Self::Key => "keys",
            Self::Solutions => "solutions",
        }
    }

    /// What it is, for the list of files of a run.
    pub fn title(self) -> &'static str {
        match self {
            Self::Sheet => "the sheets",
            Self::Key => "answer key",
            Self::Solutions => "worked solutions",
        }
    }

    fn subtitle(self, words: &'static Words) -> &'static str {
        match self {
            Self::Sheet => "",
            Self::Key => &words.answer_key,
            Self::Solutions => &words.worked_solutions,
        }
    }
}

impl Pages {
    /// The pages of a run in one format; `own` are layouts of the user.
    ///
    /// # Errors
    ///
    /// [`OutputError::Layouts`].
    pub fn new(
        writer: &'static dyn Writer,
        run: Run,
        own: &[(String, String)],
    ) -> Result<Self, OutputError> {
        Ok(Self {
            writer,
            layouts: Layouts::of(writer, own)?,
            shown: Value::from_serializable(&run),
            run,
        })
    }

    /// The format.
    pub fn writer(&self) -> &'static dyn Writer {
        self.writer
    }

    /// All that its pages depend on beside their sheets: layouts, and what the run says.
    pub fn description(&self) -> String {
        format!("{:?}{}", self.run, self.layouts.text())
    }

    /// What stands before the first page of a file.
    ///
    /// # Errors
    ///
    /// [`OutputError::Page`].
    pub fn begin(&self, subtitle: &str) -> Result<String, OutputError> {
        let style = self.writer.style();
        self.layouts.fill(
            "begin",
            &Begin {
                title: &self.run.title,
                subtitle,
                language: &tag(&self.run.language),
                paper: match self.run.paper {
                    Paper::A4 => "A4",
                    Paper::Letter => "letter",
                },
                program: concat!("vibank ", env!("CARGO_PKG_VERSION")),
                style: &style,
                families: self.families(),
                font: font(),
                words: self.run.words,
            },
        )
    }

    /// The families of fonts for names, in quotation marks.
    fn families(&self) -> Vec<String> {
        let quoted = self.run.names.families.iter().map(|family| {
            let mut out = String::new();
            quote(&mut out, family);
            out
        });
        quoted.collect()
    }

    /// What stands after the last page of a file.
    ///
    /// # Errors
    ///
    /// [`OutputError::Page`].
    pub fn end(&self) -> Result<String, OutputError> {
        #[derive(Serialize)]
        struct Nothing {}
        self.layouts.fill("end", &Nothing {})
    }

    /// What the title of a file says of its kind.
    pub fn subtitle(&self, kind: PageKind) -> &'static str {
        kind.subtitle(self.run.words)
    }

    /// What the title of a file with feedback says of it.
    pub fn feedback_subtitle(&self) -> &'static str {
        &self.run.words.feedback
    }

    /// What the title of the file with the answers of all variants says of it.
    pub fn table_subtitle(&self) -> &'static str {
        &self.run.words.all_answers
    }

    /// What the title of a list says beside the title of the sheet.
    pub fn list_title(&self, list: List) -> &str {
        list.title(self.run.words)
    }

    /// What the title of the page on fairness says of it.
    pub fn fairness_subtitle(&self) -> &'static str {
        &self.run.words.fairness.title
    }

    /// What the title of an item analysis says of it.
    pub fn report_subtitle(&self) -> &'static str {
        &self.run.words.report.title
    }

    /// The page of a sheet.
    ///
    /// # Errors
    ///
    /// [`OutputError::Page`].
    pub fn page(&self, kind: PageKind, sheet: &Sheet<'_>) -> Result<Page, OutputError> {
        self.page_with(kind, sheet, None)
    }

    /// The same; `keys` are the answers of the sheet, where they are written already.
    ///
    /// # Errors
    ///
    /// [`OutputError::Page`].
    pub fn page_with(
        &self,
        kind: PageKind,
        sheet: &Sheet<'_>,
        keys: Option<&KeyRow>,
    ) -> Result<Page, OutputError> {
        let view = View::new(self.writer, &self.run, kind).with_keys(keys);
        let content = SheetPage {
            run: &self.shown,
            sheet: view.sheet(sheet),
        };
        Ok(Page {
            text: self.layouts.fill(kind.name(), &content)?,
            pictures: view.pictures(),
        })
    }

    /// Whether these pages are printed as they are: they have a layout for sheets that stand among others.
    pub fn is_for_paper(&self) -> bool {
        self.layouts.has("among")
    }

    /// A page as it stands in a file with others; with `duplex` the next one begins on a leaf of its own.
    ///
    /// # Errors
    ///
    /// [`OutputError::Page`].
    pub fn among(&self, page: &str, duplex: bool) -> Result<String, OutputError> {
        #[derive(Serialize)]
        struct Among<'a> {
            page: &'a str,
            duplex: bool,
        }
        self.layouts.fill("among", &Among { page, duplex })
    }

    /// Words that a layout places: where it does not escape, they are escaped here.
    pub(crate) fn placed(&self, words: &str) -> String {
        if self.writer.escape().is_some() {
            words.to_owned()
        } else {
            self.writer.words(words)
        }
    }

    /// Points in words, `2.5 points`.
    pub fn points(&self, points: Rational) -> String {
        self.run.points(points)
    }
}

/// The language in which a run speaks: that of its texts, else English.
fn spoken(language: &str) -> Language {
    Language::of(language).unwrap_or_default()
}

/// What of a language's name can stand in a tag.
fn tag(language: &str) -> String {
    language
        .chars()
        .filter(|char| char.is_ascii_alphanumeric() || *char == '-')
        .collect()
}
