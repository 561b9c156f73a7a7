//! A blueprint: what a sheet is made of, as a teacher writes it.

mod error;
mod read;

use std::sync::Arc;

use super::manifest::Csv;
use super::marks::Marks;
use super::own::Own;
use super::paper::Paper;
use super::printing::Printing;
use super::rules::Rules;
use crate::answer::{Credit, Doubt};
use crate::bank::{Space, shortened};
use crate::diagnostic::Finding;
use crate::document::Document;
use crate::scene;
use crate::source::{Problems, Source, Span, Table, Text, toml};

pub use error::BlueprintError;
pub(crate) use read::Faults;

/// Where answers are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AnswerSpace {
    /// Ruled lines.
    #[default]
    Lines,
    /// An empty frame below each part.
    Boxes,
    /// Nowhere: on paper of their own.
    None,
}

/// The headings of a class list for what is known of a student; several are joined.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Columns {
    /// Headings by what they are, as `ROLES` has it.
    pub headings: Vec<(&'static str, Vec<Text>)>,
}

impl Columns {
    /// What may be known of a student.
    pub(crate) const ROLES: [&'static str; 8] = [
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
    /// Nobody in particular: the number of variants to be made.
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
    /// Whether each page has marks by which a scan of it is sorted.
    pub scan_marks: bool,
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

/// What a `[[question]]` of the blueprint asks for.
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
    /// The chapter that the item is in.
    pub chapter: Option<Text>,
    /// With this topic.
    pub topic: Option<Text>,
    /// Of one of these levels.
    pub levels: Vec<i64>,
    /// With a part of this kind.
    pub kind: Option<Text>,
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
            Some(table) => read::blueprint(table, faults),
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
                Err(shortened(findings, source))
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
