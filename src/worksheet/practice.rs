//! What a self-check page offers: its questions, and the compiled items they are drawn from.
//!
//! It is written as lines of JSON, so that a page can be opened before its items are read: the first
//! line says what there is, each further one is an item.

use serde::Serialize;
use serde_json::Value as Json;

use crate::answer::Doubt;
#[cfg(feature = "render")]
use crate::bank::Catalogue;
use crate::bank::{Compiled, ItemId, Part, Template};
use crate::document::Document;
use crate::numerics::Rational;
use crate::scene::Data;
use crate::source::{Fields, FromJson, Misfit, deserialize};

/// What a page offers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Practice {
    /// Version of the program that wrote it; the module that reads it is of the same.
    pub program: String,
    /// The title of the page.
    pub title: String,
    /// What is said before the questions.
    pub instructions: Document,
    /// Language of the texts.
    pub language: String,
    /// Decimal sign.
    pub decimal: char,
    /// What becomes of answers with two readings.
    pub doubt: Doubt,
    /// What an answer in the other form is worth; the items decide where this is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub other_form: Option<f64>,
    /// Data as numbers or symbols.
    pub data: Data,
    /// The questions in order.
    pub questions: Vec<PracticeQuestion>,
}

/// A question, before its data are drawn.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PracticeQuestion {
    /// The item that the question draws from.
    pub item: ItemId,
    /// The place of the item among those of the page, from 0.
    pub place: usize,
    /// The title of the item.
    pub title: String,
    /// The title of the chapter.
    pub chapter: String,
    /// The topics of the item.
    pub topics: Vec<String>,
    /// Difficulty, 1 to 3.
    pub level: u8,
    /// Expected working time.
    pub minutes: u32,
    /// The parts and groups that are asked; all if empty.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub parts: Vec<String>,
    /// Data that are fixed.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub set: Vec<(String, String)>,
    /// What its parts are worth, which only courses ask about.
    #[serde(skip)]
    pub weights: Vec<Weighed>,
}

/// A part and what it is worth.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Weighed {
    /// The part.
    pub id: String,
    /// The points that can be reached.
    pub points: f64,
    /// Whether it is asked for some data only.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub varies: bool,
}

/// Why the lines of a page cannot be read.
#[derive(Debug, thiserror::Error)]
#[error("line {line} of the items cannot be read: {message}")]
pub struct PracticeError {
    /// The line, from 1.
    pub line: usize,
    /// What is wrong.
    pub message: String,
}

impl PracticeQuestion {
    /// A question on a whole item, which stands at a place among those of the page.
    pub fn of(item: &Template, place: usize, chapter: &str) -> Self {
        Self {
            item: item.id.clone(),
            place,
            title: item.about.title.clone(),
            chapter: chapter.to_owned(),
            topics: item
                .about
                .topics
                .iter()
                .map(|topic| topic.value.clone())
                .collect(),
            level: item.about.level,
            minutes: item.minutes(),
            parts: Vec::new(),
            set: Vec::new(),
            weights: Weighed::of(
                item,
                &(0..item.parts.len()).collect::<Vec<_>>(),
                &item
                    .parts
                    .iter()
                    .map(|part| part.points)
                    .collect::<Vec<_>>(),
            ),
        }
    }

    /// By what it is known, on the page and in a course: its item, its parts where not all are asked, and data that are
    /// fixed.
    pub fn key(&self) -> String {
        let mut key = self.item.to_string();
        for part in &self.parts {
            key.push_str(&format!(" {part}"));
        }
        for (name, value) in &self.set {
            key.push_str(&format!(" {name}={value}"));
        }
        key
    }

    /// Whether a part is asked.
    pub fn asks(&self, part: &Part) -> bool {
        self.parts.is_empty() || self.parts.iter().any(|asked| part.is_named(asked))
    }
}

impl Weighed {
    /// Some parts of an item, by their places, without those that a person marks.
    fn of(item: &Template, places: &[usize], points: &[Rational]) -> Vec<Self> {
        // What a person marks is no part of a score.
        let is_marked =
            |(place, _): &(&usize, &Rational)| !item.parts[**place].answer.kind().is_by_hand();
        let parts = places.iter().zip(points);
        parts
            .filter(is_marked)
            .map(|(place, points)| Self {
                id: item.parts[*place].id.clone(),
                points: points.to_f64(),
                varies: item.parts[*place].when.is_some(),
            })
            .collect()
    }
}

#[cfg(feature = "render")]
impl Practice {
    /// A practice of whole items.
    pub fn of_items(
        catalogue: &Catalogue,
        items: &[&Template],
        title: &str,
    ) -> (Self, Vec<Compiled>) {
        let mut practice = Self {
            program: concat!("vibank ", env!("CARGO_PKG_VERSION")).to_owned(),
            title: title.to_owned(),
            instructions: Document::default(),
            language: catalogue.bank.language.clone(),
            decimal: '.',
            doubt: Doubt::Ask,
            other_form: None,
            data: Data::default(),
            questions: Vec::new(),
        };
        let mut compiled = Vec::new();
        for item in items {
            practice.add(catalogue, item, &mut compiled);
        }
        (practice, compiled)
    }

    /// A practice of the questions of a blueprint; of a pick, all items that pass its filter.
    pub fn of_plan(plan: &super::Plan<'_>, catalogue: &Catalogue) -> (Self, Vec<Compiled>) {
        let blueprint = plan.blueprint;
        let (mut practice, mut compiled) = Self::of_items(catalogue, &[], &blueprint.title);
        practice.instructions.clone_from(&blueprint.instructions);
        practice.language.clone_from(&blueprint.language.value);
        practice.decimal = blueprint.decimal;
        practice.doubt = blueprint.doubt.unwrap_or_default();
        practice.other_form = blueprint.other_form.map(|share| share.share().to_f64());
        practice.data = blueprint.data;
        for planned in &plan.questions {
            for item in &planned.candidates {
                practice.add(catalogue, item, &mut compiled);
                let question = practice.questions.last_mut().expect("one was added");
                question.parts.clone_from(&planned.parts);
                question.set.clone_from(&planned.set);
                let asked: Vec<usize> = (0..item.parts.len())
                    .filter(|place| question.asks(&item.parts[*place]))
                    .collect();
                let points = super::draw::points_of(planned, item, &asked);
                question.weights = Weighed::of(item, &asked, &points);
                let question = question.clone();
                let (_, earlier) = practice.questions.split_last().expect("one was added");
                if earlier.contains(&question) {
                    practice.questions.pop();
                }
            }
        }
        (practice, compiled)
    }

    fn add(&mut self, catalogue: &Catalogue, item: &Template, compiled: &mut Vec<Compiled>) {
        let place = compiled.iter().position(|known| known.id == item.id);
        let place = place.unwrap_or_else(|| {
            compiled.push(Compiled::of(item));
            compiled.len() - 1
        });
        let chapters = &catalogue.chapters;
        let chapter = chapters
            .iter()
            .find(|chapter| chapter.folder == item.id.chapter());
        let chapter = chapter.map_or(item.id.chapter(), |chapter| &chapter.title);
        self.questions
            .push(PracticeQuestion::of(item, place, chapter));
    }
}

impl Practice {
    /// The lines of a page.
    pub fn lines(&self, items: &[Compiled]) -> String {
        let mut out = serde_json::to_string(self).expect("plain data, with texts as keys");
        for item in items {
            out.push('\n');
            out.push_str(&serde_json::to_string(item).expect("plain data, with texts as keys"));
        }
        out
    }

    /// What a page offers, and the line of each of its items.
    ///
    /// # Errors
    ///
    /// [`PracticeError`].
    pub fn read(text: &str) -> Result<(Self, Vec<&str>), PracticeError> {
        let mut lines = text.lines();
        let first = lines.next().unwrap_or_default();
        let practice = Self::from_text(first).map_err(|misfit| PracticeError {
            line: 1,
            message: misfit.to_string(),
        })?;
        Ok((practice, lines.collect()))
    }
}

deserialize!(Practice);

impl FromJson for Practice {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        let mut fields = Fields::of(json)?;
        Ok(Self {
            program: fields.take("program")?,
            title: fields.take("title")?,
            instructions: fields.take("instructions")?,
            language: fields.take("language")?,
            decimal: fields.take("decimal")?,
            doubt: fields.optional("doubt")?.unwrap_or_default(),
            other_form: fields.optional("other_form")?,
            data: fields.take("data")?,
            questions: fields.take("questions")?,
        })
    }
}

impl FromJson for PracticeQuestion {
    fn from_json(json: Json) -> Result<Self, Misfit> {
        let mut fields = Fields::of(json)?;
        Ok(Self {
            item: fields.take("item")?,
            place: fields.take("place")?,
            title: fields.take("title")?,
            chapter: fields.take("chapter")?,
            topics: fields.take("topics")?,
            level: fields.take("level")?,
            minutes: fields.take("minutes")?,
            parts: fields.optional("parts")?.unwrap_or_default(),
            set: fields.optional("set")?.unwrap_or_default(),
            weights: Vec::new(),
        })
    }
}
