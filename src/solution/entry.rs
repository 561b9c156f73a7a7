//! An answer as a program gets it: the entries of `solve`.

use serde_json::{Map, Value as Json, json};

use super::Solution;
use crate::answer::KeyValue;
use crate::bank::{QuantityInfo, Units};
use crate::expr::{Field, Form, Precise, Shape, Value};
use crate::quantity::{Absent, NodeId};

/// One answer as a JSON object.
pub type Entry = Json;

impl Solution<'_> {
    /// The entry of an answer id: a quantity with a unit, or a part. Functions of time are given at the times `at`.
    pub fn entry(&self, id: &str, at: &[Precise]) -> Option<Entry> {
        let template = self.template();
        let part = template.parts.iter().position(|part| part.id == id);
        let kind = part.map_or("quantity", |place| {
            template.parts[place].answer.kind().name()
        });
        let named = template.graph.find(&crate::expr::Name::new(id));
        let quantity = named.and_then(|node| Some((node, template.info(node)?)));
        if let Some((node, info)) = quantity.filter(|(_, info)| info.units.is_some()) {
            return Some(self.quantity_entry(kind, node, info, at));
        }
        part.map(|place| self.part_entry(kind, place))
    }

    fn quantity_entry(
        &self,
        kind: &str,
        node: NodeId,
        info: &QuantityInfo,
        at: &[Precise],
    ) -> Entry {
        let variables = self.template().graph.variables(node);
        let mut entry = Map::new();
        entry.insert("kind".into(), kind.into());
        if variables.iter().any(|name| name.as_str() != "t") {
            let text = self.template().graph.expr(node).map(ToString::to_string);
            entry.insert("text".into(), text.into());
            return Json::Object(entry);
        }
        if !variables.is_empty() {
            let unit = info
                .units
                .as_ref()
                .map(|units| units_json(units, Shape::Scalar));
            entry.insert("unit".into(), unit.into());
            entry.insert(
                "at".into(),
                at.iter().map(|time| json!(time.high())).collect(),
            );
            let samples = self.evaluation().function(node).map(|function| {
                at.iter()
                    .map(|time| {
                        function
                            .at(&[*time])
                            .map_or(Json::Null, |value| numbers_json(&value))
                    })
                    .collect()
            });
            insert_value(&mut entry, samples);
            return Json::Object(entry);
        }
        let value = self.evaluation().value(node);
        let shape = self
            .template()
            .graph
            .kind(node)
            .map_or(Shape::Scalar, crate::expr::Type::shape);
        entry.insert(
            "unit".into(),
            info.units
                .as_ref()
                .map(|units| units_json(units, shape))
                .into(),
        );
        insert_value(&mut entry, value.map(numbers_json));
        Json::Object(entry)
    }

    fn part_entry(&self, kind: &str, place: usize) -> Entry {
        let mut entry = Map::new();
        entry.insert("kind".into(), kind.into());
        let part = &self.template().parts[place];
        match self.marker(place).map(|marker| marker.key().value) {
            Ok(KeyValue::Numbers { form, si }) => {
                let unit = part
                    .answer
                    .unit()
                    .map_or_else(|| "1".to_owned(), |unit| unit.coherent().to_string());
                entry.insert("unit".into(), unit.into());
                let bounds = vec![0.0; si.len()];
                entry.insert(
                    "si".into(),
                    Value::new(form, si, bounds).map_or(Json::Null, |value| numbers_json(&value)),
                );
            }
            Ok(KeyValue::Options { ids, is_list: true }) => {
                entry.insert("value".into(), ids.into());
            }
            Ok(KeyValue::Options {
                ids,
                is_list: false,
            }) => {
                entry.insert("value".into(), ids.into_iter().next().into());
            }
            Ok(KeyValue::Intervals { pieces, text }) => {
                let unit = part
                    .answer
                    .unit()
                    .map_or_else(|| "1".to_owned(), |unit| unit.coherent().to_string());
                entry.insert("unit".into(), unit.into());
                let piece = |([from, to], open): ([Option<f64>; 2], [bool; 2])| json!({ "from": from, "to": to, "open": open });
                entry.insert("si".into(), pieces.into_iter().map(piece).collect());
                entry.insert("text".into(), text.into());
            }
            Ok(KeyValue::Formula { text, latex }) => {
                entry.insert("text".into(), text.into());
                entry.insert("latex".into(), latex.into());
            }
            Err(absent) => insert_value(&mut entry, Err(absent)),
        }
        Json::Object(entry)
    }
}

/// `si`, or `null` with the reason.
fn insert_value(entry: &mut Map<String, Json>, value: Result<Json, Absent>) {
    match value {
        Ok(value) => {
            entry.insert("si".into(), value);
        }
        Err(absent) => {
            entry.insert("si".into(), Json::Null);
            entry.insert("reason".into(), absent.to_string().into());
        }
    }
}

/// One unit, or units nested as the entries are.
fn units_json(units: &Units, shape: Shape) -> Json {
    let coherent = |unit: &crate::unit::Unit| Json::from(unit.coherent().to_string());
    match (units, shape) {
        (Units::One(unit), _) => coherent(unit),
        (Units::Each(units), Shape::Matrix(_, columns)) => units
            .chunks(columns)
            .map(|row| Json::Array(row.iter().map(coherent).collect()))
            .collect(),
        (Units::Each(units), _) => units.iter().map(coherent).collect(),
    }
}

/// Numbers nested as their shape has them.
fn numbers_json(value: &Value) -> Json {
    let Form { field, shape } = value.form();
    let entry = |position: usize| match field {
        Field::Boolean => Json::Bool(value.entry(position).re != 0.0),
        Field::Real => json!(value.entry(position).re),
        Field::Complex => json!({ "re": value.entry(position).re, "im": value.entry(position).im }),
    };
    match shape {
        Shape::Scalar => entry(0),
        Shape::Vector(length) => (0..length).map(entry).collect(),
        Shape::Matrix(rows, columns) => (0..rows)
            .map(|row| {
                Json::Array(
                    (0..columns)
                        .map(|column| entry(row * columns + column))
                        .collect(),
                )
            })
            .collect(),
    }
}
