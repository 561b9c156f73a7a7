//! The decisions about a run, `decisions.toml`: what was found to be wrong after the sheets were handed out, who decided
//! what about it, and why.
//!
//! A decision is about a part of an item, whichever number it has on a sheet; `sheet` confines it to one. What it names is
//! checked against what was handed out, before anything is marked.

mod error;

use std::collections::{BTreeMap, BTreeSet};

use super::marks::{self, Marks};
use crate::answer::Credit;
use crate::bank::shortened;
use crate::diagnostic::Finding;
use crate::numerics::Rational;
use crate::seed::Variant;
use crate::source::{Data, Problems, Source, Span, Table, Text, Value, nearest, toml};

pub use error::DecisionError;

/// The file of decisions about a run.
#[derive(Clone, Debug)]
pub struct Decisions {
    /// The file.
    pub source: Source,
    /// The decisions, in order.
    pub decisions: Vec<Decision>,
    /// Rules for marks in place of those of the blueprint.
    pub marks: Option<Marks>,
}

/// What was decided about a part of an item, for all sheets or for one.
#[derive(Clone, Debug, PartialEq)]
pub struct Decision {
    /// Where its header stands.
    pub span: Span,
    /// The line of its header, from 1.
    pub line: usize,
    /// The code of the one sheet that it is about, if it is about one.
    pub sheet: Option<Text>,
    /// The item; may be left out where the number of the question says it.
    pub item: Option<Text>,
    /// The number of the question.
    pub question: Option<usize>,
    /// The id or the letter of the part.
    pub part: Text,
    /// The words that were given, of those whom it is about.
    pub given: Option<Text>,
    /// What was decided.
    pub effect: Effect,
    /// What the student reads.
    pub feedback: Option<String>,
    /// Who decided it.
    pub who: String,
    /// The reason, which stands in the report.
    pub why: String,
}

/// What was decided.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// The part does not count as it was answered.
    Void(Void),
    /// These answers are worth this much, as they are typed or in another spelling of the same.
    Accept(Vec<String>, Credit),
    /// The key is another one: a value of an item file.
    Key(Corrected),
    /// This is marked in place of what was handed in.
    Read(String),
    /// The points, whatever was handed in.
    Points(Rational),
}

/// A key in place of the one that an item has.
#[derive(Clone, Debug, PartialEq)]
pub struct Corrected {
    /// What an item file would say.
    pub value: Value,
    /// The same as it is written.
    pub written: String,
}

/// What becomes of the points of a part that does not count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Void {
    /// Everybody has them.
    FullMarks,
    /// The other parts of the question share them.
    Rescaled,
    /// The question is worth that much less.
    LeftOut,
}

/// The part that a decision is about.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Subject {
    /// The code of the one sheet, if it is about one.
    pub sheet: Option<String>,
    /// The id of the item.
    pub item: String,
    /// The part of the item.
    pub part: String,
}

/// What was handed out, as far as decisions name it.
#[derive(Clone, Debug, Default)]
pub struct HandedOut {
    /// The codes of the sheets.
    pub codes: BTreeSet<String>,
    /// By the number of a question, the items that it is.
    pub questions: BTreeMap<usize, BTreeSet<String>>,
    /// By item, the parts that are asked together, each as id and letter.
    pub parts: BTreeMap<String, BTreeSet<Vec<(String, String)>>>,
}

/// The words for what becomes of the points.
const VOID: [(&str, Void); 3] = [
    ("full marks", Void::FullMarks),
    ("rescaled", Void::Rescaled),
    ("left out", Void::LeftOut),
];

/// The keys for what is decided.
const EFFECTS: [&str; 5] = ["void", "accept", "key", "read", "points"];

impl Decisions {
    /// Reads a file of decisions.
    ///
    /// # Errors
    ///
    /// All findings at once.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank::source::Source;
    /// use vibank::worksheet::{Decisions, Effect, Void};
    ///
    /// let text = "[[decision]]\nitem = 'ch3/e1'\npart = 'b'\nvoid = 'full marks'\nwho = 'A. Meyer'\nwhy = 'The figure was wrong.'\n";
    /// let decisions = Decisions::read(&Source::new("decisions.toml", text)).unwrap();
    /// assert_eq!(decisions.decisions[0].effect, Effect::Void(Void::FullMarks));
    /// assert!(Decisions::read(&Source::new("decisions.toml", text.replace("who", "whom"))).is_err());
    /// ```
    pub fn read(source: &Source) -> Result<Self, Vec<Finding>> {
        let problems = Problems::default();
        let value = toml::read(source, &problems);
        let mut reader = DecisionReader {
            source,
            findings: Vec::new(),
        };
        let (mut decisions, mut marks) = (Vec::new(), None);
        if let Some(table) = Table::of(source, &problems, "", &value) {
            for own in table.tables("decision") {
                decisions.extend(reader.decision(&own));
                own.finish();
            }
            marks = table.table("marks").map(|table| {
                let (marks, mut findings) = marks::read(&table);
                reader.findings.append(&mut findings);
                marks
            });
            table.finish();
        }
        let problems = problems.take();
        let mut findings: Vec<Finding> = problems
            .iter()
            .map(|problem| Finding::of(problem, source))
            .collect();
        findings.extend(reader.findings);
        Finding::sort(&mut findings);
        if !findings.is_empty() {
            return Err(shortened(findings, source));
        }
        Ok(Self {
            source: source.clone(),
            decisions,
            marks,
        })
    }

    /// The part that each decision is about, among what was handed out.
    ///
    /// # Errors
    ///
    /// All findings at once: what was not handed out, and what contradicts itself.
    pub fn subjects(&self, handed_out: &HandedOut) -> Result<Vec<Subject>, Vec<Finding>> {
        let (mut subjects, mut findings) = (Vec::new(), Vec::new());
        let mut known = BTreeMap::new();
        for decision in &self.decisions {
            let subject = decision.subject(handed_out).and_then(|subject| {
                let effect = decision.effect.name();
                let given = decision.given.as_ref().map(|given| given.value.clone());
                let line = known.insert((subject.clone(), given, effect), decision.line);
                match line {
                    Some(line) => Err(DecisionError::Twice(line, decision.span)),
                    None => Ok(subject),
                }
            });
            match subject {
                Ok(subject) => subjects.push(subject),
                Err(error) => findings.push(Finding::of(&error, &self.source)),
            }
        }
        if findings.is_empty() {
            findings = self.without_rest(&subjects, handed_out);
        }
        if findings.is_empty() {
            Ok(subjects)
        } else {
            Err(shortened(findings, &self.source))
        }
    }

    /// Parts whose points are to be taken over where nothing is left that could.
    fn without_rest(&self, subjects: &[Subject], handed_out: &HandedOut) -> Vec<Finding> {
        let off: BTreeSet<(&str, &str)> = subjects
            .iter()
            .zip(&self.decisions)
            .filter(|(_, Decision { effect, .. })| {
                matches!(effect, Effect::Void(Void::Rescaled | Void::LeftOut))
            })
            .map(|(subject, _)| (subject.item.as_str(), subject.part.as_str()))
            .collect();
        let pairs = subjects.iter().zip(&self.decisions);
        pairs
            .filter(|(subject, decision)| {
                let item = subject.item.as_str();
                let mut together = handed_out.parts.get(item).into_iter().flatten();
                decision.effect == Effect::Void(Void::Rescaled)
                    && together.any(|parts| {
                        parts.iter().any(|(id, _)| *id == subject.part)
                            && parts.iter().all(|(id, _)| off.contains(&(item, id)))
                    })
            })
            .map(|(subject, decision)| {
                let (item, span) = (subject.item.clone(), decision.span);
                Finding::of(&DecisionError::NothingLeft { item, span }, &self.source)
            })
            .collect()
    }
}

impl Decision {
    /// The part that it is about, among what was handed out.
    fn subject(&self, handed_out: &HandedOut) -> Result<Subject, DecisionError> {
        let sheet = match &self.sheet {
            None => None,
            Some(code) => {
                let found = printed(&code.value);
                if !handed_out.codes.contains(&found) {
                    let codes = handed_out.codes.iter().map(String::as_str);
                    let near = nearest(&found, codes).map(str::to_owned);
                    let span = code.span;
                    return Err(DecisionError::Sheet { found, near, span });
                }
                Some(found)
            }
        };
        let item = self.item_among(handed_out)?;
        let parts = &handed_out.parts[&item];
        let part = self.part_among(&item, parts)?;
        Ok(Subject { sheet, item, part })
    }

    fn item_among(&self, handed_out: &HandedOut) -> Result<String, DecisionError> {
        if let Some(item) = &self.item {
            if handed_out.parts.contains_key(&item.value) {
                return Ok(item.value.clone());
            }
            let items = handed_out.parts.keys().map(String::as_str);
            return Err(DecisionError::Item {
                found: item.value.clone(),
                near: nearest(&item.value, items).map(str::to_owned),
                span: item.span,
            });
        }
        let number = self.question.ok_or(DecisionError::NoItem(self.span))?;
        let items = handed_out.questions.get(&number);
        let items: Vec<&String> = items.into_iter().flatten().collect();
        match items[..] {
            [] => Err(DecisionError::Question(number, self.span)),
            [item] => Ok(item.clone()),
            _ => Err(DecisionError::Questions {
                number,
                items: named(&items),
                span: self.span,
            }),
        }
    }

    fn part_among(
        &self,
        item: &str,
        parts: &BTreeSet<Vec<(String, String)>>,
    ) -> Result<String, DecisionError> {
        let found = self.part.value.as_str();
        let all = || parts.iter().flatten();
        if all().any(|(id, _)| id == found) {
            return Ok(found.to_owned());
        }
        let letter = found.to_lowercase();
        let ids: BTreeSet<&String> = all()
            .filter(|(_, own)| *own == letter)
            .map(|(id, _)| id)
            .collect();
        let ids: Vec<&String> = ids.into_iter().collect();
        let (item, span) = (item.to_owned(), self.part.span);
        match ids[..] {
            [id] => Ok(id.clone()),
            [] => {
                let known: BTreeSet<&str> = all().map(|(id, _)| id.as_str()).collect();
                let help = match nearest(found, known.iter().copied()) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => {
                        let known: Vec<&str> = known.into_iter().collect();
                        format!("its parts are {}", known.join(", "))
                    }
                };
                Err(DecisionError::Part {
                    item,
                    found: found.to_owned(),
                    help,
                    span,
                })
            }
            _ => Err(DecisionError::Letters {
                item,
                letter,
                parts: named(&ids),
                span,
            }),
        }
    }

    /// What was decided, in a few words.
    pub fn words(&self) -> String {
        match &self.effect {
            Effect::Void(Void::FullMarks) => "full marks for all".to_owned(),
            Effect::Void(Void::Rescaled) => "void, its points go to the other parts".to_owned(),
            Effect::Void(Void::LeftOut) => "left out".to_owned(),
            Effect::Accept(answers, credit) => {
                let answers: Vec<String> = answers.iter().map(|own| format!("`{own}`")).collect();
                let worth = match credit.share() {
                    share if share == Rational::ONE => "accepted".to_owned(),
                    share => format!("worth {share} of the points"),
                };
                format!("{} {worth}", answers.join(", "))
            }
            Effect::Key(key) => format!("key corrected to `{}`", key.written),
            Effect::Read(read) => format!("read as `{read}`"),
            Effect::Points(points) => format!("{points} points"),
        }
    }
}

impl Effect {
    fn name(&self) -> &'static str {
        match self {
            Self::Void(_) => "void",
            Self::Accept(..) => "accept",
            Self::Key(_) => "key",
            // Both settle the mark.
            Self::Read(_) | Self::Points(_) => "read",
        }
    }
}

fn named(names: &[&String]) -> String {
    let names: Vec<String> = names
        .iter()
        .take(4)
        .map(|name| format!("`{name}`"))
        .collect();
    names.join(", ")
}

struct DecisionReader<'s> {
    source: &'s Source,
    findings: Vec<Finding>,
}

impl DecisionReader<'_> {
    fn find<T>(&mut self, error: &DecisionError) -> Option<T> {
        self.findings.push(Finding::of(error, self.source));
        None
    }

    fn decision(&mut self, table: &Table<'_>) -> Option<Decision> {
        let span = table.span();
        let effect = self.effect(table);
        let [who, why] = ["who", "why"].map(|key| table.required_text(key).map(|text| text.value));
        let decision = Decision {
            span,
            line: self.source.position(span.start as usize).0,
            sheet: table.text("sheet"),
            item: table.text("item"),
            question: table
                .integer("question", "the number of a question", 1..=10_000)
                .map(|number| number as usize),
            part: table.required_text("part")?,
            given: table.text("given"),
            effect: effect?,
            feedback: table.text("feedback").map(|text| text.value),
            who: who?,
            why: why?,
        };
        if decision.item.is_none() && decision.question.is_none() {
            return self.find(&DecisionError::NoItem(span));
        }
        let effect = decision.effect.name();
        if let Some(given) = decision.given.as_ref().filter(|_| effect != "read") {
            return self.find(&DecisionError::Beside("given", effect, given.span));
        }
        if let Some(sheet) = decision.sheet.as_ref() {
            // What an item says is the same for all, and so is what others lose by it.
            let of_all = ["key", "given"].into_iter().find(|key| table.has(key));
            if let Some(other) = of_all {
                return self.find(&DecisionError::Beside("sheet", other, sheet.span));
            }
        }
        Some(decision)
    }

    fn effect(&mut self, table: &Table<'_>) -> Option<Effect> {
        let stated: Vec<&str> = EFFECTS.into_iter().filter(|key| table.has(key)).collect();
        let credit = Credit::of_table(table, "credit");
        let [key] = stated[..] else {
            let stated = match stated[..] {
                [] => "none".to_owned(),
                _ => stated.join(" and "),
            };
            return self.find(&DecisionError::Effects(stated, table.span()));
        };
        if let Some(value) = table.value("credit").filter(|_| key != "accept") {
            let key = EFFECTS.into_iter().find(|own| *own == key)?;
            return self.find(&DecisionError::Beside("credit", key, value.span));
        }
        match key {
            "void" => {
                let text = table.text("void")?;
                let word = VOID.iter().find(|(word, _)| *word == text.value);
                match word {
                    Some((_, void)) => Some(Effect::Void(*void)),
                    None => self.find(&DecisionError::Void(text.value, text.span)),
                }
            }
            "accept" => {
                let texts = table.texts("accept").into_iter();
                let texts = texts.map(|text| text.value.trim().to_owned());
                let texts: Vec<String> = texts.filter(|text| !text.is_empty()).collect();
                if texts.is_empty() {
                    return self.find(&DecisionError::Empty("accept", table.value("accept")?.span));
                }
                Some(Effect::Accept(texts, credit.unwrap_or(Credit::FULL)))
            }
            "key" => {
                let value = table.value("key")?.clone();
                let written = written(self.source, &value);
                Some(Effect::Key(Corrected { value, written }))
            }
            "read" => Some(Effect::Read(table.text("read")?.value)),
            _ => {
                let value = table.value("points")?;
                let points = match &value.data {
                    Data::Number { number } => Rational::from_decimal(number),
                    _ => None,
                };
                let points = points.filter(|points| *points >= Rational::ZERO);
                let points = points.or_else(|| table.wrong("points", "a number of points", value));
                points.map(Effect::Points)
            }
        }
    }
}

/// A code as it is printed.
fn printed(code: &str) -> String {
    let variant = code.parse::<Variant>();
    variant.map_or_else(|_| code.to_uppercase(), |variant| variant.to_string())
}

/// A value as it is written in its file; a text without its quotes.
fn written(source: &Source, value: &Value) -> String {
    match &value.data {
        Data::Text(text) => text.clone(),
        _ => source
            .text
            .get(value.span.range())
            .unwrap_or_default()
            .to_owned(),
    }
}
