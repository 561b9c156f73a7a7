//! What the layouts are filled with.

use serde::Serialize;

use super::layouts::{Layouts, OutputError, font, style};
use super::{Writer, is_line};
use crate::numerics::Rational;
use crate::scene::{Data, Scene};
use crate::unit::DecimalMark;
use crate::worksheet::{AnswerSpace, Blueprint, Paper, Sheet, SheetQuestion, letter};

/// What a page is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// Questions with room for answers.
    Sheet,
    /// Answers alone.
    Key,
    /// Questions with worked solutions.
    Solutions,
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
    /// `lines`, `boxes` or `none`.
    pub answer_space: &'static str,
    #[serde(skip)]
    language: String,
    #[serde(skip)]
    paper: Paper,
    #[serde(skip)]
    data: Data,
    #[serde(skip)]
    hints: bool,
    #[serde(skip)]
    mark: DecimalMark,
}

/// Fills the layouts of one format.
pub struct Pages {
    writer: &'static dyn Writer,
    layouts: Layouts,
    run: Run,
}

#[derive(Serialize)]
struct Begin<'a> {
    title: &'a str,
    subtitle: &'a str,
    language: &'a str,
    paper: &'a str,
    program: &'a str,
    style: &'a str,
    font: String,
}

#[derive(Serialize)]
struct Page<'a> {
    run: &'a Run,
    sheet: SheetView,
}

#[derive(Serialize)]
struct SheetView {
    code: String,
    name: String,
    student: String,
    group: String,
    count: String,
    points: String,
    questions: Vec<QuestionView>,
}

#[derive(Default, Serialize)]
struct QuestionView {
    number: usize,
    title: String,
    points: String,
    statement: String,
    figure: String,
    solution: String,
    notes: String,
    identity: String,
    parts: Vec<PartView>,
}

#[derive(Default, Serialize)]
struct PartView {
    letter: String,
    points: String,
    ask: String,
    hints: Vec<String>,
    options: Vec<OptionView>,
    lead: String,
    unit: String,
    key: String,
    accepted: String,
    absent: String,
    solution: String,
}

#[derive(Serialize)]
struct OptionView {
    letter: String,
    text: String,
    right: bool,
}

/// The answers of all variants on one page.
#[derive(Clone, Debug, Default, Serialize)]
pub struct KeyTable {
    blocks: Vec<KeyBlock>,
}

#[derive(Clone, Debug, Serialize)]
struct KeyBlock {
    columns: Vec<String>,
    rows: Vec<KeyRow>,
}

#[derive(Clone, Debug, Serialize)]
struct KeyRow {
    code: String,
    cells: Vec<String>,
}

/// What a student is told.
#[derive(Clone, Debug, Serialize)]
pub struct Feedback {
    /// Code of the sheet.
    pub code: String,
    /// Name; may be empty.
    pub name: String,
    /// Identity; may be empty.
    pub student: String,
    /// Points reached of all.
    pub total: String,
    /// By question.
    pub questions: Vec<FeedbackQuestion>,
}

/// Feedback to a question.
#[derive(Clone, Debug, Serialize)]
pub struct FeedbackQuestion {
    /// Its number.
    pub number: usize,
    /// Title of the item.
    pub title: String,
    /// Points reached of all.
    pub points: String,
    /// By part.
    pub parts: Vec<FeedbackPart>,
}

/// Feedback to a part.
#[derive(Clone, Debug, Serialize)]
pub struct FeedbackPart {
    /// Its letter.
    pub letter: String,
    /// Name of the verdict.
    pub verdict: &'static str,
    /// Points reached of all.
    pub points: String,
    /// What was handed in, as it is.
    pub response: String,
    /// How it was read, written.
    pub reading: String,
    /// What is said, written.
    pub feedback: Vec<String>,
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
            answer_space: "none",
            language: language.to_owned(),
            paper: Paper::A4,
            data: Data::Both,
            hints: false,
            mark: if decimal == ',' {
                DecimalMark::Comma
            } else {
                DecimalMark::Point
            },
        }
    }

    /// What the pages of a blueprint have in common, in one notation.
    pub fn of(blueprint: &Blueprint, writer: &dyn Writer) -> Self {
        let instructions = crate::document::Document::read(&blueprint.instructions.value).document;
        let is_empty = instructions.is_empty();
        Self {
            title: blueprint.title.clone(),
            course: blueprint.course.clone(),
            date: blueprint.date.clone(),
            duration: blueprint.duration.clone(),
            instructions: if is_empty {
                String::new()
            } else {
                writer.line(&instructions)
            },
            answer_space: match blueprint.answer_space {
                AnswerSpace::Lines => "lines",
                AnswerSpace::Boxes => "boxes",
                AnswerSpace::None => "none",
            },
            language: blueprint.language.clone(),
            paper: blueprint.paper,
            data: blueprint.data,
            hints: blueprint.hints,
            mark: if blueprint.decimal == ',' {
                DecimalMark::Comma
            } else {
                DecimalMark::Point
            },
        }
    }
}

impl Kind {
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

    fn subtitle(self) -> &'static str {
        match self {
            Self::Sheet => "",
            Self::Key => "answer key",
            Self::Solutions => "worked solutions",
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
            run,
        })
    }

    /// The format.
    pub fn writer(&self) -> &'static dyn Writer {
        self.writer
    }

    /// What stands before the first page of a file.
    ///
    /// # Errors
    ///
    /// [`OutputError::Page`].
    pub fn begin(&self, subtitle: &str) -> Result<String, OutputError> {
        let style = format!("{}{}", crate::math::MATHML_STYLE, style());
        self.layouts.fill(
            "begin",
            &Begin {
                title: &self.run.title,
                subtitle,
                language: &self.run.language,
                paper: match self.run.paper {
                    Paper::A4 => "A4",
                    Paper::Letter => "letter",
                },
                program: concat!("vibank ", env!("CARGO_PKG_VERSION")),
                style: &style,
                font: font(),
            },
        )
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
    pub fn subtitle(kind: Kind) -> &'static str {
        kind.subtitle()
    }

    /// The page of a sheet.
    ///
    /// # Errors
    ///
    /// [`OutputError::Page`].
    pub fn page(&self, kind: Kind, sheet: &Sheet<'_>) -> Result<String, OutputError> {
        let view = self.sheet(kind, sheet);
        self.layouts.fill(
            kind.name(),
            &Page {
                run: &self.run,
                sheet: view,
            },
        )
    }

    /// The page with the answers of all variants.
    ///
    /// # Errors
    ///
    /// [`OutputError::Page`].
    pub fn key_table(&self, table: &KeyTable) -> Result<String, OutputError> {
        #[derive(Serialize)]
        struct Content<'a> {
            run: &'a Run,
            blocks: &'a [KeyBlock],
        }
        self.layouts.fill(
            "keytable",
            &Content {
                run: &self.run,
                blocks: &table.blocks,
            },
        )
    }

    /// The page of a student's feedback.
    ///
    /// # Errors
    ///
    /// [`OutputError::Page`].
    pub fn feedback(&self, feedback: &Feedback) -> Result<String, OutputError> {
        #[derive(Serialize)]
        struct Content<'a> {
            run: &'a Run,
            sheet: &'a Feedback,
        }
        self.layouts.fill(
            "feedback",
            &Content {
                run: &self.run,
                sheet: feedback,
            },
        )
    }

    /// Points in words, `2.5 points`.
    pub fn points(&self, points: Rational) -> String {
        let number = decimal(points, self.run.mark);
        let noun = if points == Rational::ONE {
            "point"
        } else {
            "points"
        };
        format!("{number} {noun}")
    }

    /// The answers of a sheet as a row of the table; sheets with the same questions share a block.
    pub fn add_to_table(&self, table: &mut KeyTable, sheet: &Sheet<'_>) {
        let mut columns = Vec::new();
        let mut cells = Vec::new();
        for question in &sheet.questions {
            for (position, place) in question.parts.iter().enumerate() {
                columns.push(format!("{}{}", question.number, letter(position)));
                let key = question.solution.marker(*place).map(|marker| marker.key());
                cells.push(key.map_or_else(
                    |_| self.writer.words("–"),
                    |key| self.writer.math(&key.math),
                ));
            }
        }
        let row = KeyRow {
            code: sheet.variant.to_string(),
            cells,
        };
        match table
            .blocks
            .iter_mut()
            .find(|block| block.columns == columns)
        {
            Some(block) => block.rows.push(row),
            None => table.blocks.push(KeyBlock {
                columns,
                rows: vec![row],
            }),
        }
    }

    fn sheet(&self, kind: Kind, sheet: &Sheet<'_>) -> SheetView {
        let student = sheet.student.clone().unwrap_or_default();
        let count = sheet.questions.len();
        SheetView {
            code: sheet.variant.to_string(),
            name: self.placed(&student.name),
            student: self.placed(&student.id),
            group: self.placed(&student.group),
            count: format!("{count} question{}", if count == 1 { "" } else { "s" }),
            points: self.points(sheet.points()),
            questions: sheet
                .questions
                .iter()
                .map(|question| self.question(kind, question))
                .collect(),
        }
    }

    /// Words that a layout places: where it does not escape, they are escaped here.
    fn placed(&self, words: &str) -> String {
        if self.writer.escapes() {
            words.to_owned()
        } else {
            self.writer.words(words)
        }
    }

    fn question(&self, kind: Kind, question: &SheetQuestion<'_>) -> QuestionView {
        let template = question.solution.template();
        let scene = Scene::of(&question.solution, self.run.data);
        let texts = |passage| self.writer.texts(&scene.passage(passage));
        let mut view = QuestionView {
            number: question.number,
            title: self.placed(&template.about.title),
            points: self.points(question.total()),
            ..QuestionView::default()
        };
        if kind != Kind::Key {
            view.statement = texts(&template.statement);
        }
        if kind == Kind::Solutions && !template.solution.is_empty() {
            view.solution = texts(&template.solution);
        }
        if kind == Kind::Key && !template.notes.is_empty() {
            view.notes = texts(&template.notes);
        }
        if kind != Kind::Sheet {
            view.identity = question.solution.instance().identity();
        }
        let parts = question.parts.iter().zip(&question.points).enumerate();
        view.parts = parts
            .map(|(position, (place, points))| self.part(kind, &scene, position, *place, *points))
            .collect();
        view
    }

    fn part(
        &self,
        kind: Kind,
        scene: &Scene<'_, '_>,
        position: usize,
        place: usize,
        points: Rational,
    ) -> PartView {
        let solution = scene.solution();
        let part = &solution.template().parts[place];
        let texts = |passage| self.writer.texts(&scene.passage(passage));
        let mut view = PartView {
            letter: letter(position),
            points: self.points(points),
            ..PartView::default()
        };
        if kind != Kind::Key {
            view.ask = texts(&part.ask);
        }
        if kind == Kind::Sheet && self.run.hints {
            view.hints = part.hints.iter().map(texts).collect();
        }
        view.options = self.options(kind, scene, place);
        match kind {
            Kind::Sheet => {
                view.lead = self.lead(scene, place);
                view.unit = part
                    .answer
                    .unit()
                    .map(|unit| self.writer.math(&unit.math()))
                    .unwrap_or_default();
            }
            Kind::Key | Kind::Solutions => {
                match solution.marker(place).map(|marker| marker.key()) {
                    Ok(key) => {
                        view.key = self.writer.math(&key.math);
                        let accepted = key.accepted.as_ref().filter(|_| kind == Kind::Key);
                        view.accepted = accepted
                            .map(|range| format!("accepted: {}", self.writer.math(range)))
                            .unwrap_or_default();
                    }
                    Err(absent) => view.absent = self.placed(&absent.to_string()),
                }
            }
        }
        if kind == Kind::Solutions && !part.solution.is_empty() {
            view.solution = texts(&part.solution);
        }
        view
    }

    /// The symbol of the quantity that is asked, and an equals sign.
    fn lead(&self, scene: &Scene<'_, '_>, place: usize) -> String {
        let template = scene.solution().template();
        let keys = template.parts[place].answer.keys();
        let info = keys
            .first()
            .filter(|_| keys.len() == 1)
            .and_then(|node| template.info(*node));
        let math = info.map(|info| {
            crate::math::Math::row([info.symbol.clone(), crate::math::Math::relation("=")])
        });
        math.map(|math| self.writer.math(&math)).unwrap_or_default()
    }

    fn options(&self, kind: Kind, scene: &Scene<'_, '_>, place: usize) -> Vec<OptionView> {
        let solution = scene.solution();
        let options = solution.template().parts[place].answer.options();
        if options.is_empty() {
            return Vec::new();
        }
        let right = match kind {
            Kind::Sheet => Vec::new(),
            Kind::Key | Kind::Solutions => {
                match solution.marker(place).map(|marker| marker.key().value) {
                    Ok(crate::answer::KeyValue::Options { ids, .. }) => ids,
                    _ => Vec::new(),
                }
            }
        };
        let option = |(position, at): (usize, usize)| {
            let option = &options[at];
            debug_assert!(is_line(&option.text) || !option.text.is_empty());
            OptionView {
                letter: letter(position),
                text: self.writer.line(&option.text),
                right: right.contains(&option.id),
            }
        };
        solution
            .order(place)
            .into_iter()
            .enumerate()
            .map(option)
            .collect()
    }
}

/// Points as a decimal of at most two places.
fn decimal(points: Rational, mark: DecimalMark) -> String {
    let hundredths = (points.to_f64() * 100.0).round() / 100.0;
    let text = hundredths.to_string();
    if mark == DecimalMark::Comma {
        text.replace('.', ",")
    } else {
        text
    }
}
