//! Texts: read, and their placeholders looked up.

use std::sync::Arc;

use super::{ItemError, ItemReader};
use crate::bank::passage::{Passage, Piece, Target};
use crate::bank::template::{QuantityInfo, Units};
use crate::document::{Document, Form, Placeholder};
use crate::expr::{Expr, Kind, Name, Path};
use crate::mechanics::QuantityError;
use crate::quantity::NodeId;
use crate::source::{Data, Table, Text, Value, nearest};
use crate::unit::Unit;

/// A text, or alternatives of `{ when, text }`.
pub(crate) fn read<'s>(
    reader: &mut ItemReader<'s>,
    table: &Table<'s>,
    key: &'static str,
    value: &'s Value,
) -> Passage {
    match &value.data {
        Data::List(items) => {
            let pieces = items
                .iter()
                .filter_map(|item| alternative(reader, table, key, item))
                .collect();
            Passage { pieces }
        }
        _ => table
            .as_text(key, value)
            .map(|text| of_text(reader, &text))
            .unwrap_or_default(),
    }
}

/// The passage of a key, empty if it is not there.
pub(crate) fn optional<'s>(
    reader: &mut ItemReader<'s>,
    table: &Table<'s>,
    key: &'static str,
) -> Passage {
    table
        .value(key)
        .map(|value| read(reader, table, key, value))
        .unwrap_or_default()
}

/// A list of texts; each may be a list of alternatives.
pub(crate) fn list<'s>(
    reader: &mut ItemReader<'s>,
    table: &Table<'s>,
    key: &'static str,
) -> Vec<Passage> {
    let Some(value) = table.value(key) else {
        return Vec::new();
    };
    table
        .items(key, value)
        .iter()
        .map(|item| read(reader, table, key, item))
        .collect()
}

/// One text that is always shown.
pub(crate) fn of_text(reader: &mut ItemReader<'_>, text: &Text) -> Passage {
    Passage {
        pieces: vec![piece(reader, None, text)],
    }
}

fn alternative<'s>(
    reader: &mut ItemReader<'s>,
    table: &Table<'s>,
    key: &'static str,
    value: &'s Value,
) -> Option<Piece> {
    if let Data::Text(_) = value.data {
        let text = table.as_text(key, value)?;
        return Some(piece(reader, None, &text));
    }
    let inner = Table::of(table.source(), table.problems(), key, value)?;
    let when = inner
        .text("when")
        .and_then(|text| reader.condition("condition of a text", &text));
    let text = inner.required_text("text");
    inner.finish();
    text.map(|text| piece(reader, when, &text))
}

fn piece(reader: &mut ItemReader<'_>, when: Option<NodeId>, text: &Text) -> Piece {
    let document = document(reader, text);
    let targets = document
        .placeholders()
        .to_vec()
        .iter()
        .map(|place| target(reader, place, text))
        .collect();
    Piece {
        when,
        document,
        targets,
    }
}

/// A text without placeholders.
pub(crate) fn document(reader: &mut ItemReader<'_>, text: &Text) -> Document {
    let mut errors = Vec::new();
    let document = reader.texts.document(text, &mut errors);
    for error in &errors {
        reader.find(error.as_ref(), text);
    }
    document
}

/// What a placeholder stands for.
fn target(reader: &mut ItemReader<'_>, place: &Placeholder, text: &Text) -> Target {
    let first = place.names().next().unwrap_or_default();
    match (first, place.path.as_str()) {
        (_, "figure") if reader.has_figure => Target::Figure,
        (_, "figure.free") if reader.has_free => Target::Free,
        ("figure", path) if let Some(number) = mode(reader, path) => Target::Mode(number),
        ("plots", path) => {
            let name = path.trim_start_matches("plots.");
            if reader.plots.contains(name) {
                return Target::Plot(name.to_owned());
            }
            let near = nearest(name, reader.plots.iter().map(String::as_str))
                .map(|near| format!("plots.{near}"));
            missing(reader, place, near, text)
        }
        ("model" | "models", path) => offered(reader, path, place, text),
        (_, name) => match reader.graph.find(&Name::new(name)) {
            Some(node) => shown(reader, node, place, text),
            None => {
                let near = nearest(name, reader.graph.names().map(Name::as_str)).map(str::to_owned);
                missing(reader, place, near, text)
            }
        },
    }
}

/// The mode that `figure.mode.1` names, from 0, where the figure moves and the model has it.
fn mode(reader: &ItemReader<'_>, path: &str) -> Option<usize> {
    let number: usize = path.strip_prefix("figure.mode.")?.parse().ok()?;
    let model = reader.graph.derived("model")?;
    let is_there = reader.moves && (1..=model.degrees_of_freedom()).contains(&number);
    is_there.then(|| number - 1)
}

/// A formula or equation of a model, or one of its numbers.
fn offered(reader: &mut ItemReader<'_>, path: &str, place: &Placeholder, text: &Text) -> Target {
    let path = Path::new(path.split('.').map(Name::new).collect::<Vec<_>>());
    if place.is_block() && place.form != Form::Worked {
        return derivation(reader, path, place, text);
    }
    let Some((model, quantity)) = reader.graph.offered(&path) else {
        return missing(reader, place, None, text);
    };
    if model.formula(quantity).is_ok() || model.equations(quantity).is_ok() {
        return Target::Model(path);
    }
    let number = Expr::derived(Kind::Path(path));
    match reader.graph.formula(place.path.as_str(), number) {
        Ok(node) => {
            inform(reader, node, &place.path);
            Target::Node(node)
        }
        Err(errors) => {
            errors.iter().for_each(|error| reader.find(error, text));
            Target::Nothing
        }
    }
}

/// The lines of a derivation. That it can be made is seen by `check`: making it here would cost each reader.
fn derivation(reader: &mut ItemReader<'_>, path: Path, place: &Placeholder, text: &Text) -> Target {
    let near = match reader.graph.derivation(&path) {
        Some(Ok(_)) => return Target::Derivation(path),
        Some(Err(QuantityError::NoCoordinate { name, first })) => {
            Some(format!("model.{name}.{first}"))
        }
        _ => None,
    };
    missing(reader, place, near, text)
}

/// What is known of a number of a model: its coherent unit, and the figures of the item.
fn inform(reader: &mut ItemReader<'_>, node: NodeId, path: &str) {
    let dimension = reader
        .graph
        .kind(node)
        .and_then(crate::expr::Type::dimension);
    let unit = dimension.and_then(|dimension| Unit::parse(&dimension.describe()).ok());
    let info = QuantityInfo {
        name: Name::new(path),
        title: None,
        symbol: Arc::new(crate::math::symbol(path.rsplit('.').next().unwrap_or(path))),
        units: Some(Units::One(unit.unwrap_or(Unit::ONE))),
        digits: reader.digits,
        verify: None,
        parameter: None,
    };
    reader.quantities.insert(node, info);
}

/// A node, if it has the form in which it is wanted.
fn shown(reader: &mut ItemReader<'_>, node: NodeId, place: &Placeholder, text: &Text) -> Target {
    let info = reader.quantities.get(&node);
    let is_bare = info.is_some_and(|info| info.units.is_none());
    let is_datum = info.is_some_and(|info| info.parameter.is_some());
    let missing = match place.form {
        Form::Value | Form::Number | Form::Unit | Form::Given | Form::Equation | Form::Worked
            if is_bare =>
        {
            Some("unit, so no value to print")
        }
        Form::Formula | Form::Substituted | Form::Equation | Form::Worked if is_datum => {
            Some("formula: it is given")
        }
        _ => None,
    };
    match missing {
        None => Target::Node(node),
        Some(form) => {
            let error = ItemError::Form {
                found: place.path.clone(),
                form,
                span: place.span,
            };
            reader.find(&error, text);
            Target::Nothing
        }
    }
}

fn missing(
    reader: &mut ItemReader<'_>,
    place: &Placeholder,
    nearest: Option<String>,
    text: &Text,
) -> Target {
    let error = ItemError::Placeholder {
        found: place.path.clone(),
        nearest,
        span: place.span,
    };
    reader.find(&error, text);
    Target::Nothing
}
