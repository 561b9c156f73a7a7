//! A question of the blueprint's own: an item that stands in it.

use std::sync::Arc;

use super::blueprint::{BlueprintError, Faults};
use crate::bank::{ItemId, Template, question_keys};
use crate::diagnostic::{Finding, Label};
use crate::source::{Data, Source, Span, Table, Value};

/// A question that stands in the blueprint, with its item.
///
/// The text of the item is what stands between the header of the question and its last value, as it was written: that is
/// what a manifest keeps, and what marking reads again.
#[derive(Debug)]
pub struct Own {
    /// Its item, whose chapter is `own`.
    pub item: Template,
    /// The byte of the blueprint at which its text begins.
    start: usize,
}

/// The keys that only a question of one's own has.
const MARKS: [&str; 2] = ["statement", "part"];

impl Own {
    /// Whether a question has no item to look up, but says what it is about.
    pub(crate) fn is_meant(table: &Table<'_>) -> bool {
        MARKS.into_iter().any(|key| table.has(key))
    }

    /// Reads the question at a place of the blueprint, which are all questions of `whole`.
    pub(crate) fn read(
        table: &Table<'_>,
        place: usize,
        whole: &Table<'_>,
        faults: &mut Faults<'_>,
    ) -> Option<Arc<Self>> {
        let id = id(table, place, faults);
        for key in question_keys() {
            table.value(key);
        }
        let has_all = ["title", "statement", "part"].map(|key| table.required(key).is_some());
        let text = text(table, whole, faults);
        let (id, text) = (id?, text?);
        if has_all.contains(&false) {
            return None;
        }
        let start = text.start as usize;
        let blueprint = table.source();
        let source = Source::new(
            Arc::clone(&blueprint.path),
            format!("{}\n", &blueprint.text[text.range()]),
        );
        let (item, findings) = Template::of_question(id, &source);
        for finding in findings {
            faults.found(in_blueprint(finding, start, blueprint));
        }
        Some(Arc::new(Self { item: item?, start }))
    }

    /// What was found out about its item, as a finding about the blueprint.
    pub fn in_blueprint(&self, finding: Finding, blueprint: &Source) -> Finding {
        in_blueprint(finding, self.start, blueprint)
    }
}

fn in_blueprint(mut finding: Finding, start: usize, blueprint: &Source) -> Finding {
    finding.source = blueprint.clone();
    for label in &mut finding.labels {
        label.span = label.span.shifted(start);
    }
    if !finding.labels.iter().any(|label| !label.span.is_none()) {
        let end = blueprint.text[start..]
            .find('\n')
            .map_or(start, |at| start + at);
        finding.labels = vec![Label {
            span: Span::new(start, end),
            text: String::new(),
        }];
    }
    finding
}

/// By what it is known: what it says, else its title in small letters, else its place.
fn id(table: &Table<'_>, place: usize, faults: &mut Faults<'_>) -> Option<ItemId> {
    let of = |slug: &str| ItemId::of_path(&format!("{}/{slug}.toml", ItemId::OWN));
    if let Some(stated) = table.text("id") {
        let id = of(&stated.value);
        if id.is_none() {
            faults.add(&BlueprintError::OwnId(stated.span));
        }
        return id;
    }
    let title = match table.value("title").map(|title| &title.data) {
        Some(Data::Text(title)) => title.as_str(),
        _ => "",
    };
    let words = title.split(|letter: char| !letter.is_ascii_alphanumeric());
    let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    let slug: String = words.join("-").to_ascii_lowercase();
    /// Letters of a name that is made of a title.
    const MAX_LENGTH: usize = 60;
    let slug = slug
        .get(..MAX_LENGTH)
        .unwrap_or(&slug)
        .trim_end_matches('-');
    of(slug).or_else(|| of(&format!("question-{}", place + 1)))
}

/// Where the text of the question stands, of which nothing else may be in between.
fn text(table: &Table<'_>, whole: &Table<'_>, faults: &mut Faults<'_>) -> Option<Span> {
    let header = table.span();
    let entries = table.entries().iter();
    let ends = entries.map(|entry| entry.span.join(extent(&entry.value)));
    let text = ends.fold(header, Span::join);
    let others = whole
        .entries()
        .iter()
        .flat_map(|entry| match &entry.value.data {
            Data::List(questions) if entry.key == "question" => {
                questions.iter().map(|question| question.span).collect()
            }
            _ => vec![entry.span],
        });
    let mut others = others.filter(|span| span.start > text.start && span.start < text.end);
    if let Some(span) = others.next() {
        faults.add(&BlueprintError::OwnApart(span));
        return None;
    }
    let has_header = table.source().text[header.range()].starts_with("[[");
    if !has_header {
        faults.add(&BlueprintError::OwnInline(header));
    }
    has_header.then_some(text)
}

/// From the first to the last byte of a value and all that it holds.
fn extent(value: &Value) -> Span {
    match &value.data {
        Data::List(items) => items.iter().map(extent).fold(value.span, Span::join),
        Data::Table(entries) => {
            let inner = entries.iter();
            let inner = inner.map(|entry| entry.span.join(extent(&entry.value)));
            inner.fold(value.span, Span::join)
        }
        _ => value.span,
    }
}
