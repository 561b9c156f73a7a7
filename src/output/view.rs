//! What the layouts see of a sheet: finished pieces, by question and part.

use std::cell::RefCell;
use std::collections::BTreeMap;

use serde::Serialize;

use super::key_table::KeyRow;
use super::pages::{PageKind, Run};
use super::{Writer, extent};
use crate::answer::{Choosing, Criterion, KeyValue};
use crate::bank::{Group, Passage, Space, share_in_group};
use crate::document::{Document, Filling};
use crate::numerics::Rational;
use crate::scene::Scene;
use crate::solution::Solution;
use crate::worksheet::{Best, Sheet, SheetQuestion, headings, letter};

#[derive(Serialize)]
pub(crate) struct SheetView {
    code: String,
    name: String,
    student: String,
    group: String,
    /// Room and seat.
    seat: String,
    /// What is granted beyond the duration.
    extra_time: String,
    /// The size of type in points, where it is not the usual one.
    type_size: Option<u8>,
    /// The mark by which a scan is sorted, as the format has it; empty without one.
    scan_mark: String,
    count: String,
    points: String,
    /// Rows of the table where marks are written in; none where nothing is written on the sheet.
    marks: Vec<Vec<MarkView>>,
    questions: Vec<QuestionView>,
}

/// A column of the table of marks: a question, or the sum.
#[derive(Serialize)]
struct MarkView {
    name: String,
    /// The points as a number.
    worth: String,
    is_sum: bool,
}

/// Most columns of the table of marks: on paper each is then a centimetre wide, enough to write in.
const MARKS: usize = 13;

/// Columns of the table of marks in type of a size in points, where it is not the usual one of 10.5.
fn columns(size: Option<u8>) -> usize {
    size.filter(|size| *size > 10)
        .map_or(MARKS, |size| MARKS * 21 / (2 * usize::from(size)))
        .clamp(3, MARKS)
}

#[derive(Default, Serialize)]
pub(crate) struct QuestionView {
    number: usize,
    title: String,
    points: String,
    statement: String,
    figure: String,
    caption: String,
    solution: String,
    notes: String,
    identity: String,
    /// Whether it may take more than most of a page.
    is_long: bool,
    parts: Vec<PartView>,
}

/// Millimetres of paper beyond which a question may be torn between its parts, since it may not fit on a page: one of A4
/// has 263, and the estimate is up to a tenth off.
const LONG: usize = 240;

/// The same of the first question. The head of a sheet is above it, and would fill a page alone.
const LONG_FIRST: usize = 180;

/// The usual size of type in points, rounded.
const USUAL: usize = 10;

impl QuestionView {
    /// About how many millimetres of paper it takes. A rough estimate: a question that is taken for longer may be torn
    /// though it would fit.
    fn height(&self) -> usize {
        /// The title.
        const HEAD: usize = 10;
        let texts = [&self.caption, &self.solution].map(|words| extent::text(words));
        let setting = extent::with_figure(&self.statement, &self.figure);
        let parts = self.parts.iter().map(PartView::height);
        HEAD + setting + texts.iter().sum::<usize>() + parts.sum::<usize>()
    }
}

impl PartView {
    /// About how many millimetres of paper it takes, the opening of its group included.
    fn height(&self) -> usize {
        /// What is free above it.
        const GAP: usize = 2;
        let hints = |hints: &[String]| hints.iter().map(|hint| extent::text(hint)).sum::<usize>();
        let opening = self.group.as_ref().map_or(0, |group| {
            extent::text(&group.ask) + hints(&group.hints) + extent::text(&group.solution)
        });
        let answer = match (self.options.len(), &self.space, self.kind) {
            (0, ..) if !self.key.is_empty() => 9,
            (0, Some(space), _) => usize::from(space.height),
            (0, None, "matrix") => 20,
            (0, None, "equation" | "function") => 15,
            (0, None, "formula" | "interval" | "mode-shape") => 12,
            (0, None, _) => 7,
            (count, ..) => 6 * count + 2,
        };
        let texts = extent::text(&self.ask) + hints(&self.hints) + extent::text(&self.solution);
        opening + texts + answer + 5 * self.rubric.len() + GAP
    }
}

/// What is printed before the first blank of a group.
#[derive(Serialize)]
struct GroupView {
    letter: String,
    points: String,
    ask: String,
    hints: Vec<String>,
    solution: String,
}

#[derive(Default, Serialize)]
struct PartView {
    /// The group that begins with it.
    group: Option<GroupView>,
    /// Whether it belongs to a group.
    is_blank: bool,
    letter: String,
    /// PageKind of the answer.
    kind: &'static str,
    points: String,
    ask: String,
    hints: Vec<String>,
    /// Whether a person marks it, so that it has room for work in place of an answer line.
    by_hand: bool,
    /// What its points are given for.
    rubric: Vec<RowView>,
    /// Room for work.
    space: Option<SpaceView>,
    options: Vec<OptionView>,
    /// Whether the options are put in order; then the key holds their letters.
    ranked: bool,
    lead: String,
    unit: String,
    /// What the answer line says.
    asked: String,
    key: String,
    accepted: String,
    absent: String,
    solution: String,
}

/// A row of a rubric.
#[derive(Serialize)]
struct RowView {
    /// As a number.
    points: String,
    text: String,
}

/// Room for work: its look, `blank`, `lines` or `squared`, and its height.
#[derive(Serialize)]
struct SpaceView {
    look: &'static str,
    /// In mm.
    height: u16,
    /// As lines of text, for formats without heights.
    lines: u16,
}

impl SpaceView {
    fn of(space: Space) -> Self {
        Self {
            look: space.name(),
            height: space.millimetres(),
            lines: space.lines(),
        }
    }
}

#[derive(Serialize)]
struct OptionView {
    letter: String,
    text: String,
    right: bool,
}

/// Writes the pieces of sheets, and gathers the figures that the notation cannot hold.
pub(crate) struct View<'p> {
    writer: &'static dyn Writer,
    run: &'p Run,
    kind: PageKind,
    /// The answers of the sheet, where they are written already.
    keys: Option<&'p KeyRow>,
    pictures: RefCell<BTreeMap<String, String>>,
}

/// How many questions count, in words after their number.
fn best(best: &[Best]) -> String {
    let words = best.iter().map(|best| match best.section.as_str() {
        "" => format!(", of which the best {} count", best.count),
        section => format!(", of section {section} the best {} count", best.count),
    });
    words.collect()
}

impl<'p> View<'p> {
    pub(crate) fn new(writer: &'static dyn Writer, run: &'p Run, kind: PageKind) -> Self {
        Self {
            writer,
            run,
            kind,
            keys: None,
            pictures: RefCell::default(),
        }
    }

    /// The same with the answers of the sheet as they are written already.
    pub(crate) fn with_keys(self, keys: Option<&'p KeyRow>) -> Self {
        Self { keys, ..self }
    }

    /// The figures that were met: the name of each, and its SVG.
    pub(crate) fn pictures(self) -> BTreeMap<String, String> {
        self.pictures.into_inner()
    }

    pub(crate) fn sheet(&self, sheet: &Sheet<'_>) -> SheetView {
        let student = sheet.student.clone().unwrap_or_default();
        let count = sheet.questions.len();
        SheetView {
            code: sheet.variant.to_string(),
            name: self.placed(self.run.name(&student.name, &student.id)),
            student: self.placed(self.run.plain_name(&student.id)),
            group: self.placed(self.run.plain_name(&student.group)),
            seat: self.placed(&self.run.seat(&student)),
            extra_time: self.placed(self.run.plain_name(&student.extra_time)),
            // A key is read by whoever marks.
            type_size: student.type_size.filter(|_| self.kind != PageKind::Key),
            scan_mark: if self.run.scan_marks && self.kind == PageKind::Sheet {
                self.writer.scan_mark(sheet.variant)
            } else {
                String::new()
            },
            count: format!(
                "{}{}",
                self.run.words.questions(count),
                self.placed(&best(&sheet.best))
            ),
            points: self.run.points(sheet.points),
            marks: self.marks(sheet),
            questions: sheet
                .questions
                .iter()
                .map(|question| self.question(sheet, question))
                .collect(),
        }
    }

    /// What a question is worth.
    fn worth(&self, question: &SheetQuestion<'_>) -> String {
        let section = match question.section.as_str() {
            "" => String::new(),
            section => format!("section {}, ", self.placed(section)),
        };
        let points = self.run.points(question.total());
        let bonus = if question.bonus { " of bonus" } else { "" };
        format!("{section}{points}{bonus}")
    }

    /// The table where marks are written in, in rows of nearly equal length; one question needs none.
    fn marks(&self, sheet: &Sheet<'_>) -> Vec<Vec<MarkView>> {
        if sheet.questions.len() < 2 || self.run.answer_space == "none" {
            return Vec::new();
        }
        let questions = sheet.questions.iter().map(|question| MarkView {
            name: question.number.to_string(),
            worth: self.run.number(question.total()),
            is_sum: false,
        });
        let sum = MarkView {
            name: self.run.words.sum.clone(),
            worth: self.run.number(sheet.points),
            is_sum: true,
        };
        let mut rest: Vec<MarkView> = questions.chain([sum]).collect();
        let mut rows = Vec::new();
        let size = sheet.student.as_ref().and_then(|student| student.type_size);
        for left in (1..=rest.len().div_ceil(columns(size))).rev() {
            let next = rest.split_off(rest.len().div_ceil(left));
            rows.push(std::mem::replace(&mut rest, next));
        }
        rows
    }

    /// Words that a layout places: where it does not escape, they are escaped here.
    fn placed(&self, words: &str) -> String {
        if self.writer.escape().is_some() {
            words.to_owned()
        } else {
            self.writer.words(words)
        }
    }

    /// A text, written; its figures are noted.
    fn texts(&self, scene: &Scene<'_, '_>, passage: &Passage) -> String {
        let shown = scene.passage(passage);
        for piece in &shown {
            for filling in &piece.fillings {
                if let Filling::Figure(svg) = filling {
                    self.note(svg);
                }
            }
        }
        self.writer.texts(&shown, self.run.voice())
    }

    /// Notes a figure that becomes a file of its own.
    fn note(&self, svg: &str) {
        if let Some(name) = self.writer.picture_name(svg) {
            self.pictures.borrow_mut().insert(name, svg.to_owned());
        }
    }

    /// A question of a text, which is worth no points.
    pub(crate) fn example(&self, question: &SheetQuestion<'_>) -> QuestionView {
        let scene = Scene::of(&question.solution, self.run.data).spoken(self.run.spoken());
        let mut view = self.shown(&scene, question);
        view.points.clear();
        for part in &mut view.parts {
            part.points.clear();
            if let Some(group) = &mut part.group {
                group.points.clear();
            }
        }
        view
    }

    fn question(&self, sheet: &Sheet<'_>, question: &SheetQuestion<'_>) -> QuestionView {
        let scope = format!("s-{}-{}", sheet.variant, question.number);
        let scene = Scene::of(&question.solution, self.run.data)
            .within(scope)
            .spoken(self.run.spoken());
        let mut view = self.shown(&scene, question);
        if self.kind == PageKind::Sheet && self.writer.keeps_questions_together() {
            let size = sheet.student.as_ref().and_then(|student| student.type_size);
            let long = if question.number == 1 {
                LONG_FIRST
            } else {
                LONG
            };
            let long = size.map_or(long, |size| long * USUAL / usize::from(size));
            view.is_long = view.height() > long;
        }
        view
    }

    fn shown(&self, scene: &Scene<'_, '_>, question: &SheetQuestion<'_>) -> QuestionView {
        let template = question.solution.template();
        let mut view = QuestionView {
            number: question.number,
            title: self.placed(&template.about.title),
            points: self.worth(question),
            ..QuestionView::default()
        };
        if self.kind != PageKind::Key {
            view.statement = self.texts(scene, &template.statement);
            if self.run.figures
                && !template.statement.places_figure()
                && let Some(picture) = scene.picture()
            {
                self.note(&picture.svg);
                view.figure = self.writer.figure(&picture.svg);
                view.caption = self.caption(&template.caption);
            }
        }
        if self.kind == PageKind::Solutions && !template.solution.is_empty() {
            view.solution = self.texts(scene, &template.solution);
        }
        if self.kind == PageKind::Key && !template.notes.is_empty() {
            view.notes = self.texts(scene, &template.notes);
        }
        let instance = question.solution.instance();
        view.identity = match self.kind {
            PageKind::Sheet => String::new(),
            // Solutions are handed out, and a keyed seed would give the keys of items with the same seed away.
            PageKind::Solutions if self.run.is_keyed => instance.origin(),
            PageKind::Solutions | PageKind::Key => instance.identity(),
        };
        let headings = headings(template, &question.parts);
        let parts = question.parts.iter().zip(&question.points);
        let spaces = question.spaces.iter().copied();
        let spaces = spaces.map(|space| {
            Some(space).filter(|space| self.kind == PageKind::Sheet && *space != Space::None)
        });
        let keys = self
            .keys
            .and_then(|row| row.questions.get(question.number - 1));
        let keys = keys.map_or(&[][..], |keys| &keys.cells);
        let keys = keys.iter().map(Some).chain(std::iter::repeat(None));
        view.parts = headings
            .into_iter()
            .zip(parts.zip(spaces))
            .zip(keys)
            .map(|((heading, ((place, points), space)), key)| PartView {
                group: heading.opened().map(|(letter, group)| {
                    let points = question.points_of(group);
                    self.group(scene, letter, group, points)
                }),
                letter: heading.letter.clone(),
                space: space.map(SpaceView::of),
                ..self.part(scene, *place, *points, key)
            })
            .collect();
        view
    }

    fn group(
        &self,
        scene: &Scene<'_, '_>,
        letter: &str,
        group: &Group,
        points: Rational,
    ) -> GroupView {
        let text = |passage: &Passage, is_shown: bool| {
            let passage = Some(passage).filter(|passage| is_shown && !passage.is_empty());
            passage.map_or_else(String::new, |passage| self.texts(scene, passage))
        };
        let hints = group.hints.iter();
        let hints = hints.filter(|_| self.kind == PageKind::Sheet && self.run.hints);
        GroupView {
            letter: letter.to_owned(),
            points: self.run.points(points),
            ask: text(&group.text, self.kind != PageKind::Key),
            hints: hints.map(|hint| text(hint, true)).collect(),
            solution: text(&group.solution, self.kind == PageKind::Solutions),
        }
    }

    /// What is written under a figure.
    fn caption(&self, caption: &Document) -> String {
        if caption.is_empty() {
            String::new()
        } else {
            self.writer.line(caption, self.run.voice())
        }
    }

    /// A part; `written` is its answer, where that is written already.
    fn part(
        &self,
        scene: &Scene<'_, '_>,
        place: usize,
        points: Rational,
        written: Option<&String>,
    ) -> PartView {
        let solution = scene.solution();
        let part = &solution.template().parts[place];
        let texts = |passage| self.texts(scene, passage);
        let mut view = PartView {
            is_blank: part.group.is_some(),
            kind: part.answer.kind().name(),
            by_hand: part.answer.kind().is_by_hand(),
            points: self.run.points(points),
            ..PartView::default()
        };
        if self.kind != PageKind::Key {
            view.ask = texts(&part.ask);
        }
        if self.kind == PageKind::Sheet && self.run.hints {
            view.hints = part.own_hints().iter().map(texts).collect();
        }
        view.options = self.options(scene, place);
        if self.kind != PageKind::Sheet {
            view.rubric = self.rubric(part.answer.rubric(), points);
        }
        view.ranked = part.answer.choosing() == Some(Choosing::Ranking);
        match self.kind {
            PageKind::Sheet => {
                view.lead = self.lead(scene, place);
                let blank = part.blank();
                view.unit = blank
                    .unit_behind()
                    .map(|unit| self.writer.math(&unit.math(), self.run.voice()))
                    .unwrap_or_default();
                view.asked = self
                    .writer
                    .line(&self.run.spoken().blank(blank), self.run.voice());
            }
            PageKind::Key | PageKind::Solutions => match scene.key(place) {
                Ok(Some(key)) => {
                    view.key = written
                        .map_or_else(|| self.writer.math(&key, self.run.voice()), String::clone);
                    view.accepted = self.accepted(solution, place);
                }
                Ok(None) if self.kind == PageKind::Solutions => {}
                Ok(None) => view.absent = self.placed(&self.run.words.in_the_solution),
                Err(_) if view.by_hand => {}
                Err(absent) => view.absent = self.placed(&absent.to_string()),
            },
        }
        if self.kind == PageKind::Solutions && !part.solution.is_empty() {
            view.solution = texts(&part.solution);
        }
        view
    }

    /// What the points of a part are given for.
    fn rubric(&self, rows: &[Criterion], points: Rational) -> Vec<RowView> {
        let weights: Vec<Rational> = rows.iter().map(|row| row.points).collect();
        let shares = share_in_group(points, &weights);
        let rows = rows.iter().zip(shares);
        rows.map(|(row, points)| RowView {
            points: self.run.number(points),
            text: self.writer.line(&row.text, self.run.voice()),
        })
        .collect()
    }

    /// The range that is accepted, on a key.
    fn accepted(&self, solution: &Solution<'_>, place: usize) -> String {
        let key = solution
            .key(place)
            .ok()
            .filter(|_| self.kind == PageKind::Key);
        let range = key.and_then(|key| key.accepted.as_ref());
        range.map_or_else(String::new, |range| {
            let range = self.run.spoken().formula(range);
            format!(
                "{} {}",
                self.run.words.accepted,
                self.writer.math(&range, self.run.voice())
            )
        })
    }

    /// The symbol of the quantity that is asked, and an equals sign.
    fn lead(&self, scene: &Scene<'_, '_>, place: usize) -> String {
        let math = scene.lead(place);
        math.map(|math| self.writer.math(&math, self.run.voice()))
            .unwrap_or_default()
    }

    fn options(&self, scene: &Scene<'_, '_>, place: usize) -> Vec<OptionView> {
        let solution = scene.solution();
        let options = solution.template().parts[place].answer.options();
        if options.is_empty() {
            return Vec::new();
        }
        let is_ranked =
            solution.template().parts[place].answer.choosing() == Some(Choosing::Ranking);
        let right = match self.kind {
            PageKind::Key | PageKind::Solutions if !is_ranked => {
                match solution.key(place).map(|key| &key.value) {
                    Ok(KeyValue::Options { ids, .. }) => ids.clone(),
                    _ => Vec::new(),
                }
            }
            PageKind::Sheet | PageKind::Key | PageKind::Solutions => Vec::new(),
        };
        solution
            .order(place)
            .into_iter()
            .enumerate()
            .map(|(position, at)| {
                let option = &options[at];
                OptionView {
                    letter: letter(position),
                    text: self.writer.line(&option.text, self.run.voice()),
                    right: right.contains(&option.id),
                }
            })
            .collect()
    }
}
