//! From the text of an item file to its template, with all findings at once.
//!
//! The order is that of what depends on what: data and names first, then the quantities, then
//! everything whose formulas may use them.

mod checks;
mod error;
mod figure;
mod models;
mod parts;
mod passages;
mod phasors;
mod plots;
mod quantities;
mod texts;

use std::collections::BTreeMap;
use std::sync::Arc;

pub use error::ItemError;
#[cfg(feature = "render")]
pub(crate) use texts::{Noting, Parsers};
pub(crate) use texts::{Stored, Texts};

use super::bounds;
use super::rule::Rule;
use super::template::{Allowed, Constraint, Part, QuantityInfo, Template};
use super::{About, ItemId, Parameter, Revision};
use crate::answer::Known;
use crate::diagnostic::{Diagnose, Finding};
use crate::expr::{Expr, Field, Name};
use crate::math::{Math, symbol};
use crate::numerics::{SortedMap, SortedSet};
use crate::quantity::{Graph, NodeId};
use crate::source::{Problems, Source, Span, Table, Text, Value};
use crate::unit::{self, Unit};
use crate::work;

/// The state of reading one item.
struct ItemReader<'s> {
    source: &'s Source,
    texts: &'s mut dyn Texts,
    findings: Vec<Finding>,
    graph: Graph,
    parameters: Vec<Parameter>,
    quantities: SortedMap<NodeId, QuantityInfo>,
    digits: u8,
    plots: SortedSet<String>,
    has_figure: bool,
    /// Whether the figure has free-body diagrams.
    has_free: bool,
    /// Whether the figure moves.
    moves: bool,
    /// The symbols and coordinates.
    free: Vec<Known>,
    /// What the parts that were read ask for.
    asked: Vec<NodeId>,
    /// The names that they and the part that is being read write in their keys.
    introduced: SortedSet<String>,
    /// What each draw has to meet, in the order of the file.
    constraints: Vec<NodeId>,
    /// The part that is being read.
    part: String,
    /// Where the identities stand that parts had.
    was: SortedMap<String, Span>,
}

/// An item file, or what a compiled item has of it.
pub(crate) struct Item<'s> {
    pub(crate) id: ItemId,
    pub(crate) revision: Revision,
    pub(crate) source: &'s Source,
    pub(crate) tree: &'s Value,
    /// The vocabulary of topics, where it is to be kept to.
    pub(crate) topics: Option<&'s BTreeMap<String, String>>,
}

/// Builds the template of an item; there is none where something is wrong with it.
/// What was noted about the form of the file is added to the findings.
pub(crate) fn item(
    item: Item<'_>,
    problems: &Problems,
    texts: &mut dyn Texts,
) -> (Option<Template>, Vec<Finding>) {
    let source = item.source;
    let excesses = bounds::excesses(item.tree);
    if !excesses.is_empty() {
        let findings = excesses.iter().map(|excess| Finding::of(excess, source));
        return (None, findings.collect());
    }
    let mut reader = ItemReader::new(source, texts);
    let read = work::within(bounds::READING, || {
        Table::of(source, problems, "", item.tree).and_then(|table| reader.item(item, &table))
    });
    if read.is_exhausted {
        // What the steps that were not taken lack would be found wrong with the item.
        return (None, vec![Finding::of(&bounds::Excess::Work, source)]);
    }
    let template = read.value;
    let mut findings: Vec<Finding> = problems
        .take()
        .iter()
        .map(|problem| Finding::of(problem, source))
        .collect();
    findings.append(&mut reader.findings);
    crate::numerics::sort_by(&mut findings, Finding::order);
    let is_sound = !findings
        .iter()
        .any(|finding| finding.severity == crate::diagnostic::Severity::Error);
    (
        template.filter(|_| is_sound),
        bounds::shortened(findings, source),
    )
}

impl<'s> ItemReader<'s> {
    fn new(source: &'s Source, texts: &'s mut dyn Texts) -> Self {
        Self {
            source,
            texts,
            findings: Vec::new(),
            graph: Graph::new(),
            parameters: Vec::new(),
            quantities: SortedMap::new(),
            digits: 3,
            plots: SortedSet::new(),
            has_figure: false,
            has_free: false,
            moves: false,
            free: Vec::new(),
            asked: Vec::new(),
            introduced: SortedSet::new(),
            constraints: Vec::new(),
            part: String::new(),
            was: SortedMap::new(),
        }
    }

    fn item(&mut self, item: Item<'_>, table: &Table<'s>) -> Option<Template> {
        let about = table.required_table("item").map(About::read);
        if let Some(about) = &about {
            self.digits = about.digits;
            self.about(about, item.topics);
        }
        self.has_figure = table.has("figure");
        if let Some(plots) = table.table("plots") {
            self.plots = plots
                .entries()
                .iter()
                .map(|entry| entry.key.clone())
                .collect();
        }
        quantities::data(self, table);
        quantities::read(self, table);
        let plots = plots::read(self, table);
        let constraints = self.constraints(table);
        self.constraints = constraints.iter().map(|own| own.node).collect();
        let (figure, caption) = figure::read(self, table);
        let statement = table.required_table("statement").map(|statement| {
            let passage = statement
                .required("text")
                .map(|text| passages::read(self, &statement, "text", text));
            statement.finish();
            passage.unwrap_or_default()
        });
        let solution = table.table("solution").map(|solution| {
            let passage = solution
                .required("text")
                .map(|text| passages::read(self, &solution, "text", text));
            solution.finish();
            passage.unwrap_or_default()
        });
        let parts = parts::read(self, table);
        let checks = checks::read(self, table, &parts);
        let allowed = self.allowed(table, &parts);
        let notes = about
            .as_ref()
            .and_then(|about| about.notes.as_ref())
            .map(|notes| passages::of_text(self, notes));
        let template = Template {
            id: item.id,
            revision: item.revision,
            about: about?,
            source: self.source.clone(),
            parameters: std::mem::take(&mut self.parameters),
            constraints,
            graph: std::mem::take(&mut self.graph),
            quantities: std::mem::take(&mut self.quantities),
            symbols: self
                .free
                .iter()
                .map(|known| (known.name.clone(), known.symbol.clone()))
                .collect(),
            plots,
            statement: statement?,
            solution: solution.unwrap_or_default(),
            notes: notes.unwrap_or_default(),
            figure,
            caption,
            parts,
            checks,
            allowed,
            methods: std::sync::OnceLock::new(),
            drawn: crate::answer::Drawn::default(),
        };
        table.finish_ref();
        Some(template)
    }

    /// Topics and lifted guards have to be known words.
    fn about(&mut self, about: &About, topics: Option<&BTreeMap<String, String>>) {
        for topic in &about.topics {
            if let Some(topics) = topics.filter(|topics| !topics.contains_key(&topic.value)) {
                let known = topics.keys().cloned().collect();
                self.find(
                    &ItemError::Topic {
                        found: topic.value.clone(),
                        known,
                    },
                    topic,
                );
            }
        }
        for word in &about.allow {
            if !super::about::LIFTABLE.contains(&word.value.as_str()) {
                self.find(
                    &ItemError::Allow {
                        found: word.value.clone(),
                    },
                    word,
                );
            }
        }
    }

    /// Findings of `check` that are in order here, each with a reason.
    fn allowed(&mut self, table: &Table<'s>, parts: &[Part]) -> Vec<Allowed> {
        let mut allowed = Vec::new();
        for own in table.tables("allow") {
            let (rule, part) = (own.required_text("rule"), own.text("part"));
            let reason = own.required_text("reason");
            own.finish();
            if let Some(rule) = rule
                .as_ref()
                .filter(|rule| Rule::of_name(&rule.value).is_none())
            {
                let found = rule.value.clone();
                self.find(&ItemError::Rule { found }, rule);
            }
            if let Some(part) = &part
                && !parts.iter().any(|known| known.is_named(&part.value))
            {
                let ids = parts.iter().map(|known| known.id.as_str());
                let nearest = crate::source::nearest(&part.value, ids).map(str::to_owned);
                let found = part.value.clone();
                self.find(&ItemError::Expected { found, nearest }, part);
            }
            let (Some(rule), Some(reason)) = (rule, reason) else {
                continue;
            };
            if reason.value.trim().is_empty() {
                self.find(&ItemError::Reason, &reason);
            }
            allowed.push(Allowed {
                rule,
                part: part.map(|part| part.value),
                reason: reason.value,
            });
        }
        allowed
    }

    fn constraints(&mut self, table: &Table<'s>) -> Vec<Constraint> {
        let Some(constraints) = table.table("constraints") else {
            return Vec::new();
        };
        let found = constraints.entries().iter().filter_map(|entry| {
            let text = constraints.as_formula(&entry.key, &entry.value)?;
            let node = self.condition(&format!("constraint {}", entry.key), &text)?;
            Some(Constraint {
                name: entry.key.clone(),
                node,
            })
        });
        found.collect()
    }

    /// Reads a formula whose names are known.
    fn formula(&mut self, label: &str, text: &Text) -> Option<NodeId> {
        let expr = self.expr(text)?;
        match self.graph.formula(label, expr) {
            Ok(node) => Some(node),
            Err(errors) => {
                errors.iter().for_each(|error| self.find(error, text));
                None
            }
        }
    }

    /// Reads a formula that is true or false.
    fn condition(&mut self, label: &str, text: &Text) -> Option<NodeId> {
        let node = self.formula(label, text)?;
        let is_condition = self
            .graph
            .kind(node)
            .is_some_and(|kind| kind.field() == Field::Boolean);
        if !is_condition {
            self.find(&ItemError::NoCondition, text);
            return None;
        }
        Some(node)
    }

    fn expr(&mut self, text: &Text) -> Option<Expr> {
        match Expr::read(&text.value) {
            Ok(expr) => Some(expr),
            Err(error) => {
                self.find(&error, text);
                None
            }
        }
    }

    fn unit(&mut self, text: &Text) -> Option<Unit> {
        match Unit::parse(&text.value) {
            Ok(unit) => Some(unit),
            Err(error) => {
                self.find(&ItemError::Unit(error), text);
                None
            }
        }
    }

    /// The symbol of a name: what the item says, else what follows from the name.
    fn symbol(&mut self, name: &str, text: Option<&Text>) -> Arc<Math> {
        let Some(text) = text else {
            return Arc::new(symbol(name));
        };
        let mut errors = Vec::new();
        let math = self.texts.math(text, &mut errors);
        for error in &errors {
            self.find(error.as_ref(), text);
        }
        Arc::new(math.unwrap_or_else(|| symbol(name)))
    }

    /// A name that formulas can use.
    fn name(&mut self, key: &str, span: Span) -> Option<Name> {
        const RESERVED: [&str; 7] = ["t", "i", "pi", "e", "inf", "model", "models"];
        let is_reserved = RESERVED.contains(&key) || crate::expr::Function::of_name(key).is_some();
        let mut letters = key.chars();
        let is_name = letters
            .next()
            .is_some_and(|first| first.is_ascii_alphabetic())
            && letters.all(|letter| letter.is_ascii_alphanumeric() || letter == '_');
        if is_name && !is_reserved && key.len() <= 64 {
            return Some(Name::new(key));
        }
        let text = Text {
            value: key.to_owned(),
            span,
        };
        self.find(
            &ItemError::Name {
                found: key.to_owned(),
                is_reserved,
            },
            &text,
        );
        None
    }

    fn find(&mut self, error: &dyn Diagnose, text: &Text) {
        self.findings.push(found_in(text, error, self.source));
    }
}

/// A finding about a text, which is its place where the error has none.
fn found_in(text: &Text, error: &dyn Diagnose, source: &Source) -> Finding {
    let mut finding = Finding::within(error, source, text);
    let labels = finding.labels.iter_mut();
    for label in labels.filter(|label| label.span.is_none()) {
        label.span = text.span;
    }
    finding
}

impl From<unit::Error> for ItemError {
    fn from(error: unit::Error) -> Self {
        Self::Unit(error)
    }
}
