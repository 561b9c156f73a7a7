//! A template: an item as it was read, from which instances are drawn.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::plot::Plot;
use super::{About, ItemId, Parameter, Passage, Revision};
use crate::answer::Answer;
use crate::document::Document;
use crate::expr::{Name, Precise};
use crate::figure::Figure;
use crate::math::Math;
use crate::numerics::Rational;
use crate::quantity::{Graph, NodeId};
use crate::source::Source;
use crate::unit::{Quantity, Unit};

/// An item as it was read: what can be drawn, asked, answered and shown.
#[derive(Debug)]
pub struct Template {
    /// Its identity.
    pub id: ItemId,
    /// The text it was read from.
    pub revision: Revision,
    /// What it says of itself.
    pub about: About,
    /// Its file.
    pub source: Source,
    /// Its data.
    pub parameters: Vec<Parameter>,
    /// What a draw has to keep to.
    pub constraints: Vec<Constraint>,
    /// Everything in it that has a value.
    pub graph: Graph,
    /// What is known of named nodes beyond their value.
    pub quantities: BTreeMap<NodeId, QuantityInfo>,
    /// Symbols of coordinates and other free names, where the item states them.
    pub symbols: BTreeMap<Name, Arc<Math>>,
    /// Plots, by name.
    pub plots: Vec<Plot>,
    /// What is given.
    pub statement: Passage,
    /// What comes before the solutions of the parts.
    pub solution: Passage,
    /// For the teacher.
    pub notes: Passage,
    /// Its schematic.
    pub figure: Option<Figure>,
    /// What is written under the schematic.
    pub caption: Document,
    /// What is asked.
    pub parts: Vec<Part>,
    /// Known results.
    pub checks: Vec<Check>,
}

/// A condition that every draw keeps.
#[derive(Clone, Debug)]
pub struct Constraint {
    /// Its name, for messages.
    pub name: String,
    /// The condition.
    pub node: NodeId,
}

/// What is known of a parameter or quantity beyond its value.
#[derive(Clone, Debug)]
pub struct QuantityInfo {
    /// Its name in formulas.
    pub name: Name,
    /// What it is, in words.
    pub title: Option<Arc<str>>,
    /// Its symbol.
    pub symbol: Arc<Math>,
    /// Its units; an abbreviation has none.
    pub units: Option<Units>,
    /// Significant figures in which it is printed.
    pub digits: u8,
    /// The independent second route.
    pub verify: Option<NodeId>,
    /// The place of a parameter in the list of data.
    pub parameter: Option<usize>,
}

/// The unit of all entries of a quantity, or one for each, by rows.
#[derive(Clone, Debug, PartialEq)]
pub enum Units {
    /// The same for all.
    One(Unit),
    /// One for each entry.
    Each(Vec<Unit>),
}

/// One thing that is asked.
#[derive(Debug)]
pub struct Part {
    /// Its identity in the item.
    pub id: String,
    /// The question.
    pub ask: Passage,
    /// What answers it.
    pub answer: Box<dyn Answer>,
    /// Its weight.
    pub points: Rational,
    /// It is asked only if this holds.
    pub when: Option<NodeId>,
    /// From a nudge to the way.
    pub hints: Vec<Passage>,
    /// The worked solution.
    pub solution: Passage,
    /// Known wrong, or also acceptable, answers.
    pub mistakes: Vec<Mistake>,
}

/// A known wrong, or also acceptable, answer.
#[derive(Debug)]
pub struct Mistake {
    /// What it gives.
    pub answer: MistakeAnswer,
    /// What is said about it.
    pub feedback: Passage,
    /// Its share of the points.
    pub credit: crate::answer::Credit,
    /// The unit in which it is given, where it has another dimension than the part.
    pub unit: Option<Unit>,
    /// The data for which it is a mistake.
    pub when: Option<NodeId>,
}

/// What a mistake gives.
#[derive(Debug)]
pub enum MistakeAnswer {
    /// These formulas.
    Formulas(Vec<NodeId>),
    /// The key with these quantities replaced.
    Replaced(Vec<(NodeId, NodeId)>),
}

/// A known result of an item.
#[derive(Clone, Debug)]
pub struct Check {
    /// Where it comes from.
    pub source: String,
    /// Data that are not at their value.
    pub given: Vec<(usize, Quantity)>,
    /// Times, for functions.
    pub at: Vec<Precise>,
    /// What has to come out, by quantity or part.
    pub expect: Vec<Expected>,
}

/// One expected result.
#[derive(Clone, Debug)]
pub struct Expected {
    /// The quantity or part.
    pub id: crate::source::Text,
    /// A response that has to be right.
    pub response: crate::source::Text,
}

impl Template {
    /// The part of this id.
    pub fn part(&self, id: &str) -> Option<&Part> {
        self.parts.iter().find(|part| part.id == id)
    }

    /// All texts that placeholders stand in, in the order in which they are shown.
    pub fn passages(&self) -> impl Iterator<Item = &Passage> {
        let parts = self.parts.iter().flat_map(|part| {
            let feedback = part.mistakes.iter().map(|mistake| &mistake.feedback);
            let texts = std::iter::once(&part.ask).chain(&part.hints);
            texts.chain(std::iter::once(&part.solution)).chain(feedback)
        });
        [&self.statement, &self.solution, &self.notes]
            .into_iter()
            .chain(parts)
    }

    /// The parameter of this name and its place.
    pub fn parameter(&self, name: &str) -> Option<(usize, &Parameter)> {
        self.parameters
            .iter()
            .enumerate()
            .find(|(_, parameter)| parameter.name.as_str() == name)
    }

    /// What is known of a named node.
    pub fn info(&self, node: NodeId) -> Option<&QuantityInfo> {
        self.quantities.get(&node)
    }

    /// Everything that can be answered: quantities with a unit, and parts, each once, in the order of the item.
    pub fn answer_ids(&self) -> Vec<&str> {
        let named = self.quantities.values().filter(|info| {
            info.units.is_some()
                && info.parameter.is_none()
                && self.graph.find(&info.name).is_some()
        });
        let mut ids: Vec<&str> = named.map(|info| info.name.as_str()).collect();
        for part in &self.parts {
            if !ids.contains(&part.id.as_str()) {
                ids.push(&part.id);
            }
        }
        ids
    }

    /// How many instances the grids of the parameters allow; saturates.
    pub fn instances(&self) -> u64 {
        let counts = self
            .parameters
            .iter()
            .filter_map(|parameter| parameter.grid.map(|grid| grid.count()));
        counts.fold(1, u64::saturating_mul)
    }

    /// The expected working time in minutes.
    pub fn minutes(&self) -> u32 {
        self.about.minutes.unwrap_or_else(|| {
            self.parts
                .iter()
                .map(|part| part.answer.kind().minutes())
                .sum()
        })
    }
}
