//! Attempts as sheets: what each student was asked, from the manifest of the export or from the package, and answered.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};

use vibank::bank::Template;
use vibank::grade::{Responses, Row};
use vibank::seed::{Seed, Variant};
use vibank::worksheet::{Manifest, PartEntry, QuestionEntry, VariantEntry, letter};

use super::attempts::Which;
use super::cells::{boxes, essay, lines};
use super::moment::Moment;
use super::options::chosen;
use super::origin::{Interaction, QuestionOrigin};
use super::{AnswerTarget, Attempt, ColumnAnswer, Report};
use crate::cli::Failure;
use crate::cli::package::ReadPackage;

/// Longest response that SCORM 1.2 keeps.
const MAX_LENGTH: usize = 255;

/// What parts the codes of attempts from those of sheets; any number will do that stays.
const ATTEMPTS: u64 = 0x6174_7465_6d70_7473;

/// What may have been asked.
pub(crate) enum KnownQuestions<'a> {
    /// The questions of a manifest, by code.
    Manifest(BTreeMap<String, Vec<QuestionEntry>>),
    /// A package, which draws them when they are asked for.
    Package(&'a ReadPackage<'a>),
}

/// An attempt as a sheet.
pub(crate) struct TakenAttempt {
    /// The sheet, under a code of its own.
    pub(crate) entry: VariantEntry,
    line: usize,
    moment: Option<Moment>,
    rows: Vec<AnsweredPart>,
}

/// What was answered to one part.
struct AnsweredPart {
    question: usize,
    part: String,
    response: String,
    /// Whether the report does not say what was answered.
    is_open: bool,
}

impl TakenAttempt {
    /// The identity of the student.
    pub(crate) fn student(&self) -> &str {
        let student = self.entry.student.as_ref();
        student
            .and_then(|student| student.get("id"))
            .map_or("", String::as_str)
    }

    /// Whether it was made after another one: by the dates of the report, else by its lines.
    pub(crate) fn is_after(&self, other: &Self) -> bool {
        match (self.moment, other.moment) {
            (Some(own), Some(other)) if own != other => own > other,
            _ => self.line > other.line,
        }
    }
}

/// The answers of attempts, by the codes of their sheets.
pub(crate) fn responses(attempts: &[TakenAttempt]) -> Responses {
    let mut responses = Responses::default();
    for taken in attempts {
        for given in &taken.rows {
            let row = Row {
                line: taken.line,
                code: &taken.entry.code,
                question: &given.question.to_string(),
                part: &given.part,
                response: &given.response,
            };
            if given.is_open {
                responses.add_open(&row);
            } else {
                responses.add(&row);
            }
        }
    }
    responses.settle();
    responses
}

impl KnownQuestions<'_> {
    /// The questions of a manifest.
    pub(crate) fn of(manifest: &Manifest) -> Self {
        let variants = manifest.variants.iter();
        Self::Manifest(
            variants
                .map(|variant| (variant.code.clone(), variant.questions.clone()))
                .collect(),
        )
    }

    /// The largest number of a question.
    fn most(&self) -> usize {
        match self {
            Self::Manifest(variants) => {
                let questions = variants.values().flatten();
                questions.map(|question| question.number).max().unwrap_or(0)
            }
            Self::Package(package) => package.practice.questions.len(),
        }
    }

    /// The question with the boxes of an exported one.
    fn boxed(&self, origin: &QuestionOrigin) -> Option<QuestionEntry> {
        let Self::Manifest(variants) = self else {
            return None;
        };
        let has_all = |question: &QuestionEntry| {
            origin.boxes.iter().all(|asked| {
                question
                    .parts
                    .iter()
                    .any(|part| part.letter == asked.letter)
            })
        };
        let questions = variants.get(&origin.code.to_string())?.iter();
        let mut question = questions
            .filter(|question| origin.number.is_none_or(|number| number == question.number))
            .filter(|question| origin.item.ends_with(question.item.as_str()) && has_all(question))
            .max_by_key(|question| question.item.as_str().len())?
            .clone();
        question
            .parts
            .retain(|part| origin.boxes.iter().any(|asked| asked.letter == part.letter));
        question.points = question.parts.iter().map(|part| part.points).sum();
        Some(question)
    }

    /// The question of which a package reports a part.
    fn interacted(&self, own: &Interaction) -> Result<Option<QuestionEntry>, Failure> {
        match self {
            Self::Package(package) => package.asking(&own.item, &own.part, own.code),
            Self::Manifest(_) => Ok(None),
        }
    }
}

/// The attempts of a report as sheets; `which` of the tries at a part of a package counts; `template` finds the item of
/// a question. What could not be matched is added to the faults.
pub(crate) fn taken<'t>(
    mut report: Report,
    known: &KnownQuestions<'_>,
    which: Which,
    template: &dyn Fn(&QuestionEntry) -> Result<&'t Template, Failure>,
) -> Result<(Vec<TakenAttempt>, Vec<String>), Failure> {
    for column in &report.foreign {
        eprintln!("not marked: `{column}`, which is not a question of this program");
    }
    let mut lost = BTreeSet::new();
    let mut unanswered = BTreeMap::new();
    let (mut taken, mut codes) = (Vec::new(), BTreeSet::new());
    for attempt in &report.attempts {
        let mut sheet = AttemptSheet {
            questions: Vec::new(),
            rows: Vec::new(),
            faults: &mut report.faults,
            lost: &mut lost,
            unanswered: &mut unanswered,
            line: attempt.line,
            which,
            next: known.most() + 1,
        };
        sheet.fill(attempt, known, template)?;
        let AttemptSheet {
            questions, rows, ..
        } = sheet;
        if questions.is_empty() {
            continue;
        }
        let id = &attempt.student["id"];
        let mut codes_of = (0..).map(|at| Variant::of_student(Seed::new(ATTEMPTS), id, at, None));
        let Some(code) = codes_of.find(|code| codes.insert(*code)) else {
            continue;
        };
        taken.push(TakenAttempt {
            entry: VariantEntry {
                code: code.to_string(),
                seed: code.number(),
                student: Some(attempt.student.clone()),
                gave_way: false,
                files: BTreeMap::new(),
                pages: BTreeMap::new(),
                questions,
            },
            line: attempt.line,
            moment: attempt.moment,
            rows,
        });
    }
    if taken.is_empty() {
        let name = report.name;
        let questions: Vec<String> = lost.into_iter().take(3).collect();
        return Err(Failure::new(format!(
            "none of the questions of this {name} is in the manifest: {}",
            questions.join(", ")
        ))
        .help("give the manifest that was written beside the questions which were imported, or the package"));
    }
    let unknown = lost.iter().map(|name| {
        format!("`{name}` is not in the manifest; what was answered to it is not marked")
    });
    report.faults.extend(unknown);
    Ok((taken, report.faults))
}

/// The sheet of an attempt while it is put together.
struct AttemptSheet<'f> {
    questions: Vec<QuestionEntry>,
    rows: Vec<AnsweredPart>,
    faults: &'f mut Vec<String>,
    /// Questions that are not known.
    lost: &'f mut BTreeSet<String>,
    /// Questions of a package by place, for those who did not answer them.
    unanswered: &'f mut BTreeMap<usize, QuestionEntry>,
    line: usize,
    which: Which,
    /// The number of the next question whose own number is taken.
    next: usize,
}

impl AttemptSheet<'_> {
    fn fill<'t>(
        &mut self,
        attempt: &Attempt,
        known: &KnownQuestions<'_>,
        template: &dyn Fn(&QuestionEntry) -> Result<&'t Template, Failure>,
    ) -> Result<(), Failure> {
        let mut tries: Vec<(&Interaction, &ColumnAnswer)> = Vec::new();
        for answer in &attempt.answers {
            match &answer.asked {
                AnswerTarget::Boxes(origin) => match known.boxed(origin) {
                    Some(question) => {
                        let question = self.numbered(question);
                        self.boxes(&question, origin, answer, template(&question)?);
                        self.questions.push(question);
                    }
                    None => {
                        let name = format!("{} {}", origin.item, origin.code);
                        self.lost.insert(name);
                    }
                },
                // Each try is reported.
                AnswerTarget::Interaction(own) => {
                    let same = tries.iter().position(|(known, _)| {
                        (&known.item, &known.part, known.code) == (&own.item, &own.part, own.code)
                    });
                    match same {
                        Some(at) if !self.which.replaces(own, answer, tries[at]) => {}
                        Some(at) => tries[at] = (own, answer),
                        None => tries.push((own, answer)),
                    }
                }
            }
        }
        for (own, answer) in tries {
            let at = self.questions.iter().position(|question| {
                question.item.as_str() == own.item
                    && question.seed == own.code.item(&own.item, None).number()
                    && question.parts.iter().any(|part| part.id == own.part)
            });
            let at = match at {
                Some(at) => at,
                None => match known.interacted(own)? {
                    Some(question) => {
                        let question = self.numbered(question);
                        self.questions.push(question);
                        self.questions.len() - 1
                    }
                    None => {
                        self.lost.insert(format!("{} {}", own.item, own.code));
                        continue;
                    }
                },
            };
            self.interaction(at, own, answer);
        }
        if let KnownQuestions::Package(package) = known
            && !self.questions.is_empty()
        {
            self.unanswered(package, &attempt.student["id"])?;
        }
        Ok(())
    }

    /// Adds the questions of a package of which no part was answered, so that they count as missing.
    fn unanswered(&mut self, package: &ReadPackage<'_>, student: &str) -> Result<(), Failure> {
        for place in 0..package.practice.questions.len() {
            if self.questions.iter().any(|own| own.number == place + 1) {
                continue;
            }
            // Its data do not matter, since nothing was typed: those of one student do for all.
            let question = match self.unanswered.entry(place) {
                Entry::Occupied(known) => known.into_mut(),
                Entry::Vacant(vacant) => {
                    let code = package.variant(place, student)?;
                    vacant.insert(package.question(place, code)?)
                }
            };
            self.questions.push(question.clone());
        }
        self.questions.sort_by_key(|question| question.number);
        Ok(())
    }

    /// The question under its number, or under a free one if another question of the sheet has a part of that name.
    fn numbered(&mut self, mut question: QuestionEntry) -> QuestionEntry {
        let is_taken = self.questions.iter().any(|other| {
            let mut own = question.parts.iter();
            other.number == question.number
                && own.any(|part| other.parts.iter().any(|known| known.letter == part.letter))
        });
        if is_taken {
            question.number = self.next;
            self.next += 1;
        }
        question
    }

    fn add(&mut self, question: &QuestionEntry, part: &PartEntry, response: String, is_open: bool) {
        self.rows.push(AnsweredPart {
            question: question.number,
            part: part.letter.clone(),
            response,
            is_open,
        });
    }

    /// What a cell cannot say is left to the teacher.
    fn open(&mut self, question: &QuestionEntry, answer: &ColumnAnswer, why: &str) {
        let ColumnAnswer { column, text, .. } = answer;
        let line = self.line;
        self.faults.push(format!(
            "line {line}, column `{column}`: {why}; what it answers is not decided"
        ));
        for part in &question.parts {
            self.add(question, part, text.clone(), true);
        }
    }

    /// The answers of the boxes of an exported question.
    fn boxes(
        &mut self,
        question: &QuestionEntry,
        origin: &QuestionOrigin,
        answer: &ColumnAnswer,
        template: &Template,
    ) {
        if let Some(why) = &answer.spoilt {
            return self.open(question, answer, why);
        }
        let text = if answer.text == "-" {
            ""
        } else {
            answer.text.as_str()
        };
        if text.is_empty() {
            for part in &question.parts {
                self.add(question, part, String::new(), false);
            }
            return;
        }
        let cut = if question
            .parts
            .iter()
            .all(|part| matches!(part.kind.as_str(), "numeric" | "integer" | "choice"))
        {
            boxes(text, origin.boxes.len())
        } else {
            None
        };
        let (answers, is_boxed): (Vec<String>, bool) = match cut {
            Some(Ok(answers)) => (answers, true),
            Some(Err(())) => {
                return self.open(
                    question,
                    answer,
                    "the answers of its boxes cannot be told apart",
                );
            }
            None => match &origin.boxes[..] {
                [_] if answer.is_canvas() => (vec![text.to_owned()], true),
                [_] => {
                    let lines = lines(text).map(str::trim).filter(|line| !line.is_empty());
                    (vec![lines.collect::<Vec<_>>().join("\n")], false)
                }
                several => {
                    let letters: Vec<&str> =
                        several.iter().map(|own| own.letter.as_str()).collect();
                    match essay(text, &letters) {
                        Some(answers) => (answers, false),
                        None => {
                            let why = format!(
                                "the answers to {} do not follow their letters, such as `{})`",
                                letters.join(", "),
                                letters[0]
                            );
                            return self.open(question, answer, &why);
                        }
                    }
                }
            },
        };
        for part in &question.parts {
            let given: Vec<String> = origin
                .boxes
                .iter()
                .zip(&answers)
                .filter(|(asked, _)| asked.letter == part.letter)
                .map(|(asked, text)| match part.kind.as_str() {
                    "numeric" | "integer" if is_boxed => with_unit(text, &part.unit, asked.power),
                    "choice" => option(template, part, text),
                    _ => text.clone(),
                })
                .collect();
            let is_empty = given.iter().all(String::is_empty);
            let response = if is_empty {
                String::new()
            } else {
                given.join("; ")
            };
            self.add(question, part, response, false);
        }
    }

    /// The answer that a package reports.
    fn interaction(&mut self, at: usize, own: &Interaction, answer: &ColumnAnswer) {
        let question = self.questions[at].clone();
        let Some(part) = question.parts.iter().find(|part| part.id == own.part) else {
            self.lost
                .insert(format!("{} {}/{}", own.item, own.code, own.part));
            return;
        };
        // A blank at the cut is lost when the table is read.
        let is_cut = answer.text.chars().count() + 1 >= MAX_LENGTH;
        let why = match &answer.spoilt {
            Some(why) => Some(why.clone()),
            None => is_cut.then(|| {
                format!(
                    "the platform keeps {MAX_LENGTH} characters of an answer, and this one may have had more"
                )
            }),
        };
        if let Some(why) = &why {
            let (line, column) = (self.line, &answer.column);
            self.faults.push(format!(
                "line {line}, column `{column}`: {why}; what it answers is not decided"
            ));
        }
        self.add(&question, part, answer.text.clone(), why.is_some());
    }
}

impl ColumnAnswer {
    /// Whether the heading is the text of the question.
    fn is_canvas(&self) -> bool {
        self.column.starts_with(|char: char| char.is_ascii_digit())
    }
}

/// A number with the unit that was printed after its box; what has a unit of its own stays as it is.
fn with_unit(text: &str, unit: &str, power: i32) -> String {
    const WORDS: &[&str] = &["e", "E", "x", "pi", "sqrt", "π"];
    let mut words = text.split(|char: char| !char.is_alphabetic());
    if text.is_empty() || !words.all(|word| word.is_empty() || WORDS.contains(&word)) {
        return text.to_owned();
    }
    let number = match power {
        0 => text.to_owned(),
        _ => format!("({text})*1e{power}"),
    };
    format!("{number} {unit}").trim_end().to_owned()
}

/// An option by its letter on the sheet, else the words as they are.
fn option(template: &Template, part: &PartEntry, words: &str) -> String {
    let place = template.place(&part.id);
    let id = place.and_then(|place| {
        let own = &template.parts[place];
        let at = chosen(own, words)?;
        Some(own.answer.options()[at].id.clone())
    });
    let at = id.and_then(|id| part.options.iter().position(|own| *own == id));
    at.map_or_else(|| words.to_owned(), letter)
}
