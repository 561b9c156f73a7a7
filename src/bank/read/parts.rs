//! What is asked, and what is known to go wrong.

use std::sync::{Arc, OnceLock};

use super::{ItemError, ItemReader, found_in, passages};
use crate::answer::{self, Answer, Credit, Declare, Known, Naming, Role};
use crate::bank::Domain;
#[cfg(feature = "render")]
use crate::bank::Space;
use crate::bank::points::share_in_group;
use crate::bank::template::{Group, Mistake, MistakeAnswer, Part, Units};
use crate::diagnostic::Diagnose;
use crate::document::Document;
use crate::expr::{Equation, Expr, Kind, Name};
use crate::mechanics::{Model, Quantity};
use crate::numerics::{Rational, SortedSet};
use crate::quantity::{Graph, NodeId};
use crate::source::{Data, Span, Table, Text};
use crate::unit::Unit;

pub(crate) fn read<'s>(reader: &mut ItemReader<'s>, table: &Table<'s>) -> Vec<Part> {
    let mut parts: Vec<Part> = Vec::new();
    for question in table.tables("part") {
        if question.has("blank") {
            let blanks = group(reader, question, &parts);
            parts.extend(blanks);
            continue;
        }
        let span = question.span();
        if let Some(part) = part(reader, question, None)
            && is_new(reader, &part, span, &parts)
        {
            parts.push(part);
        }
    }
    old_ids(reader, &parts);
    // Only now it is known what else is asked for.
    for part in &mut parts {
        let answer = &part.answer;
        let naming = Naming::of(reader, answer.kind(), &answer.keys(), answer.unit());
        part.naming = naming.with_bound(answer.bound());
    }
    parts
}

/// Whether no part before has the identity of this one; a finding if one has.
fn is_new(reader: &mut ItemReader<'_>, part: &Part, span: Span, before: &[Part]) -> bool {
    let is_new = !before
        .iter()
        .any(|other| other.id == part.id || other.is_in(&part.id));
    if !is_new {
        part_twice(reader, &part.id, span);
    }
    is_new
}

fn part_twice(reader: &mut ItemReader<'_>, id: &str, span: Span) {
    let (found, value) = (id.to_owned(), id.to_owned());
    reader.find(&ItemError::PartTwice { found }, &Text { value, span });
}

/// An identity that a part had is that of no other.
fn old_ids(reader: &mut ItemReader<'_>, parts: &[Part]) {
    let mut old: SortedSet<&str> = SortedSet::new();
    let all = parts.iter().flat_map(|part| &part.was);
    for was in all {
        let is_taken = parts.iter().any(|part| part.id == *was || part.is_in(was));
        if is_taken || !old.insert(was) {
            let span = reader.was.get(was).copied().unwrap_or(Span::NONE);
            part_twice(reader, was, span);
        }
    }
}

/// Blanks that are asked together, as parts with one group.
fn group<'s>(reader: &mut ItemReader<'s>, table: Table<'s>, before: &[Part]) -> Vec<Part> {
    let span = table.span();
    let id = table.required_text("id");
    if let Some(id) = &id {
        own_name(reader, &id.value, None, &table);
        if !is_name(&id.value) {
            let (found, is_reserved) = (id.value.clone(), false);
            reader.find(&ItemError::Name { found, is_reserved }, id);
        }
        if before.iter().any(|part| part.is_named(&id.value)) {
            part_twice(reader, &id.value, id.span);
        }
    }
    let text = table
        .required("text")
        .map(|text| passages::read(reader, &table, "text", text));
    let points = points(reader, &table);
    let group = Arc::new(Group {
        id: id.map(|id| id.value).unwrap_or_default(),
        text: text.unwrap_or_default(),
        hints: passages::list(reader, &table, "hints"),
        solution: passages::optional(reader, &table, "solution"),
    });
    let mut blanks: Vec<Part> = Vec::new();
    let tables = table.tables("blank");
    if tables.len() < 2 {
        let value = String::new();
        reader.find(&ItemError::SmallGroup, &Text { value, span });
    }
    for blank in tables {
        let span = blank.span();
        if let Some(part) = part(reader, blank, Some(&group))
            && is_new(reader, &part, span, &blanks)
        {
            blanks.push(part);
        }
    }
    table.finish();
    let weights: Vec<Rational> = blanks.iter().map(|blank| blank.points).collect();
    let shares = share_in_group(points, &weights);
    for (blank, share) in blanks.iter_mut().zip(shares) {
        blank.points = share;
    }
    blanks
}

/// A question, or a blank of a group.
fn part<'s>(
    reader: &mut ItemReader<'s>,
    table: Table<'s>,
    group: Option<&Arc<Group>>,
) -> Option<Part> {
    let kind = kind(reader, &table)?;
    let key = table.value("key").and_then(|key| match &key.data {
        Data::Text(text) => Some(text.clone()),
        _ => None,
    });
    let id = table
        .text("id")
        .map(|text| text.value)
        .or_else(|| key.clone().filter(|key| is_name(key)));
    let Some(id) = id else {
        reader.find(
            &ItemError::PartId,
            &Text {
                value: String::new(),
                span: table.span(),
            },
        );
        return None;
    };
    // After the name of its group a blank may have any name.
    reader.part = match group {
        Some(group) => format!("{}.{id}", group.id),
        None => {
            own_name(reader, &id, key.as_deref(), &table);
            id
        }
    };
    let mut was = Vec::new();
    for old in table.texts("was") {
        reader.was.insert(old.value.clone(), old.span);
        was.push(old.value);
    }
    let ask = table
        .required("ask")
        .map(|ask| passages::read(reader, &table, "ask", ask));
    let points = points(reader, &table);
    let when = table
        .text("when")
        .and_then(|text| reader.condition("condition of a part", &text));
    let mut hints = group.map_or_else(Vec::new, |group| group.hints.clone());
    hints.extend(passages::list(reader, &table, "hints"));
    let solution = passages::optional(reader, &table, "solution");
    #[cfg(feature = "render")]
    let space = space(reader, &table);
    #[cfg(not(feature = "render"))]
    table.value("space");
    introduce(reader, &table);
    let mut answer = kind.read(&table, reader);
    let mistakes = match &mut answer {
        Some(answer) => {
            // A count that was asked is no letter that one would write.
            for key in answer.keys() {
                if kind != answer::AnswerKind::Integer {
                    reader.asked.push(key);
                    reader.asked.extend(listed(reader, key));
                }
            }
            let mut mistakes = Vec::new();
            for own in table.tables("mistakes") {
                let number = mistakes.len();
                mistakes.extend(mistake(reader, own, number, answer.as_mut()));
            }
            mistakes
        }
        None => {
            table.value("mistakes");
            Vec::new()
        }
    };
    if answer.is_some() {
        table.finish();
    }
    let id = std::mem::take(&mut reader.part);
    Some(Part {
        id,
        was,
        group: group.cloned(),
        ask: ask?,
        answer: answer?,
        blank: OnceLock::new(),
        naming: Naming::default(),
        points,
        when,
        hints,
        solution,
        #[cfg(feature = "render")]
        space,
        mistakes,
    })
}

/// Notes the names that the answer of a part is written with.
fn introduce<'s>(reader: &mut ItemReader<'s>, table: &Table<'s>) {
    let written = ["key", "unknowns", "in", "variable"];
    let entries = table.entries().iter();
    for entry in entries.filter(|entry| written.contains(&entry.key.as_str())) {
        let texts = match &entry.value.data {
            Data::Text(_) => std::slice::from_ref(&entry.value),
            Data::List(items) => items,
            _ => &[],
        };
        for text in texts {
            if let Data::Text(text) = &text.data {
                let names = text
                    .split(|letter: char| !(letter.is_ascii_alphanumeric() || letter == '_'))
                    .map(str::to_owned);
                reader.introduced.extend(names);
            }
        }
    }
}

/// The kind of answer of a part.
fn kind<'s>(reader: &mut ItemReader<'s>, table: &Table<'s>) -> Option<answer::AnswerKind> {
    let Some(text) = table.text("kind") else {
        return Some(answer::AnswerKind::Numeric);
    };
    let kind = answer::AnswerKind::of_name(&text.value);
    if kind.is_none() {
        let found = text.value.clone();
        reader.find(&ItemError::Kind { found }, &text);
    }
    kind
}

/// The quantities that a key lists, `[omega1, omega2]`.
fn listed(reader: &ItemReader<'_>, key: NodeId) -> Vec<NodeId> {
    let entries = match reader.graph.expr(key).map(Expr::kind) {
        Some(Kind::Array(entries)) => &entries[..],
        _ => &[],
    };
    entries
        .iter()
        .filter_map(|entry| match entry.kind() {
            Kind::Name(name) => reader.graph.find(name),
            _ => None,
        })
        .collect()
}

/// A part may bear the name of a quantity only if that is its key.
fn own_name<'s>(reader: &mut ItemReader<'s>, id: &str, key: Option<&str>, table: &Table<'s>) {
    if reader.graph.find(&Name::new(id)).is_some() && key != Some(id) {
        let text = table.text("id").unwrap_or(Text {
            value: id.to_owned(),
            span: table.span(),
        });
        reader.find(
            &ItemError::Taken {
                found: id.to_owned(),
            },
            &text,
        );
    }
}

fn points<'s>(reader: &mut ItemReader<'s>, table: &Table<'s>) -> Rational {
    let Some(text) = table
        .value("points")
        .and_then(|points| table.as_formula("points", points))
    else {
        return Rational::ONE;
    };
    let points = Rational::from_decimal(&text.value).filter(|points| *points > Rational::ZERO);
    points.unwrap_or_else(|| {
        reader.find(&ItemError::Points, &text);
        Rational::ONE
    })
}

#[cfg(feature = "render")]
fn space<'s>(reader: &mut ItemReader<'s>, table: &Table<'s>) -> Option<Space> {
    let text = table.text("space")?;
    Space::read(&text.value)
        .map_err(|error| reader.find(&ItemError::Space(error), &text))
        .ok()
}

fn mistake<'s>(
    reader: &mut ItemReader<'s>,
    table: Table<'s>,
    number: usize,
    answer: &mut dyn Answer,
) -> Option<Mistake> {
    let given = match (table.value("answer"), table.table("with")) {
        (Some(value), None) => answer
            .read_mistake(number, value, &table, reader)
            .map(MistakeAnswer::Formulas),
        (None, Some(with)) => Some(MistakeAnswer::Replaced(replacements(reader, &with))),
        _ => {
            reader.find(
                &ItemError::Mistake,
                &Text {
                    value: String::new(),
                    span: table.span(),
                },
            );
            None
        }
    };
    let feedback = table
        .required("feedback")
        .map(|feedback| passages::read(reader, &table, "feedback", feedback));
    let credit = table
        .value("credit")
        .and_then(|credit| table.as_formula("credit", credit));
    let credit = credit.map(|text| {
        Credit::read(&text.value).unwrap_or_else(|| {
            reader.find(&ItemError::Credit, &text);
            Credit::NONE
        })
    });
    let unit = table.text("unit").and_then(|text| reader.unit(&text));
    let when = table
        .text("when")
        .and_then(|text| reader.condition("condition of a mistake", &text));
    table.finish();
    Some(Mistake {
        answer: given?,
        feedback: feedback?,
        credit: credit.unwrap_or(Credit::NONE),
        unit,
        when,
    })
}

pub(crate) fn replacements<'s>(
    reader: &mut ItemReader<'s>,
    table: &Table<'s>,
) -> Vec<(NodeId, NodeId)> {
    let mut replaced = Vec::new();
    for entry in table.entries() {
        let Some(text) = table.as_formula(&entry.key, &entry.value) else {
            continue;
        };
        let Some(quantity) = reader.graph.find(&Name::new(entry.key.as_str())) else {
            let names = reader.graph.names().map(Name::as_str);
            let nearest = crate::source::nearest(&entry.key, names).map(str::to_owned);
            let key = entry.name();
            reader.find(
                &ItemError::Expected {
                    found: entry.key.clone(),
                    nearest,
                },
                &key,
            );
            continue;
        };
        replaced.extend(
            reader
                .formula("mistake", &text)
                .map(|value| (quantity, value)),
        );
    }
    replaced
}

/// The model and the quantity that a text names.
fn named<'r>(reader: &'r ItemReader<'_>, text: &Text) -> Option<(&'r Arc<Model>, Quantity)> {
    let path = Expr::read(&text.value).ok()?;
    let Kind::Path(path) = path.kind() else {
        return None;
    };
    reader.graph.offered(path)
}

fn is_name(key: &str) -> bool {
    key.starts_with(|first: char| first.is_ascii_alphabetic())
        && key
            .bytes()
            .all(|byte| byte.is_ascii_alphanumeric() || byte == b'_')
}

impl Declare for ItemReader<'_> {
    fn formula(&mut self, label: &str, text: &Text) -> Option<NodeId> {
        let expr = ItemReader::expr(self, text)?;
        let named = match expr.kind() {
            Kind::Name(name) => self.graph.find(name),
            _ => None,
        };
        // A key that names a quantity is that quantity, so that it is computed once and can be replaced.
        named.or_else(|| Declare::expr(self, label, expr, text))
    }

    fn condition(&mut self, label: &str, text: &Text) -> Option<NodeId> {
        let label = format!("{label} of {}", self.part);
        ItemReader::condition(self, &label, text)
    }

    fn expr(&mut self, label: &str, expr: Expr, text: &Text) -> Option<NodeId> {
        match self
            .graph
            .formula(format!("{label} of {}", self.part), expr)
        {
            Ok(node) => Some(node),
            Err(errors) => {
                errors.iter().for_each(|error| self.find(error, text));
                None
            }
        }
    }

    fn equations(&mut self, text: &Text) -> Option<Vec<Equation>> {
        let offered = named(self, text);
        let equations = offered.and_then(|(model, quantity)| model.equations(quantity).ok());
        if equations.is_none() {
            self.find(
                &ItemError::NoEquation {
                    found: text.value.clone(),
                },
                text,
            );
        }
        equations
    }

    fn coordinates_of(&self, text: &Text) -> Vec<Name> {
        let dimensions =
            named(self, text).map_or_else(Vec::new, |(model, _)| model.coordinate_dimensions());
        dimensions.into_iter().map(|(name, _)| name).collect()
    }

    fn constraints(&self) -> Vec<Expr> {
        self.constraints
            .iter()
            .filter_map(|node| {
                let expr = self.graph.expr(*node)?;
                Some(crate::answer::without_paths(&self.graph, expr))
            })
            .collect()
    }

    fn known(&self) -> Vec<Known> {
        let named = self.quantities.iter().filter_map(|(node, info)| {
            let role = match info.parameter {
                Some(place) => Role::Parameter {
                    node: *node,
                    is_signed: self.parameters[place].domain == Domain::Any,
                    is_integer: self.parameters[place].is_integer(),
                },
                None => Role::Quantity {
                    node: *node,
                    is_asked: self.asked.contains(node),
                },
            };
            Some(Known {
                name: info.name.clone(),
                symbol: info.symbol.clone(),
                title: info.title.clone(),
                kind: self.graph.kind(*node)?.clone(),
                role,
            })
        });
        named.chain(self.free.iter().cloned()).collect()
    }

    fn is_introduced(&self, symbol: &Name) -> bool {
        self.introduced.contains(symbol.as_str())
    }

    fn unit(&mut self, text: &Text) -> Option<Unit> {
        ItemReader::unit(self, text)
    }

    fn text(&mut self, text: &Text) -> Document {
        passages::document(self, text)
    }

    fn graph(&self) -> &Graph {
        &self.graph
    }

    fn unit_of(&self, node: NodeId) -> Option<Unit> {
        match self.quantities.get(&node)?.units.as_ref()? {
            Units::One(unit) => Some(*unit),
            Units::Each(_) => None,
        }
    }

    fn units_of(&self, node: NodeId) -> Vec<Unit> {
        let count = self.graph.kind(node).map_or(0, |kind| kind.shape().len());
        match self
            .quantities
            .get(&node)
            .and_then(|info| info.units.as_ref())
        {
            Some(Units::One(unit)) => vec![*unit; count],
            Some(Units::Each(units)) => units.clone(),
            None => Vec::new(),
        }
    }

    fn digits_of(&self, node: NodeId) -> u8 {
        self.quantities
            .get(&node)
            .map_or(self.digits, |info| info.digits)
    }

    fn figures(&self) -> u8 {
        self.digits
    }

    fn find(&mut self, error: &dyn Diagnose, text: &Text) {
        self.findings.push(found_in(text, error, self.source));
    }
}
