//! Data, symbols, coordinates and quantities: the names of an item.

use std::sync::Arc;

use super::{ItemError, ItemReader, models};
use crate::answer::{Known, Role};
use crate::bank::parameter::{Parameter, ParameterField, Texts};
use crate::bank::template::{QuantityInfo, Units};
use crate::expr::{Name, Type};
use crate::quantity::{GraphError, NodeId};
use crate::source::{Data, Entry, Span, Table, Text, Value};
use crate::unit::Unit;

/// A quantity as declared, until all names are known.
struct DeclaredQuantity {
    node: NodeId,
    name: Name,
    formula: Text,
    units: Option<(Units, Text)>,
    verify: Option<Text>,
    when: Option<Text>,
}

/// Parameters and symbols.
pub(crate) fn data<'s>(reader: &mut ItemReader<'s>, table: &Table<'s>) {
    if let Some(parameters) = table.table("parameters") {
        parameters
            .entries()
            .iter()
            .for_each(|entry| parameter(reader, &parameters, entry));
    }
    if let Some(symbols) = table.table("symbols") {
        symbols
            .entries()
            .iter()
            .for_each(|entry| free_name(reader, &symbols, entry, Role::Symbol));
    }
}

fn parameter<'s>(reader: &mut ItemReader<'s>, table: &Table<'s>, entry: &'s Entry) {
    let Some(name) = reader.name(&entry.key, entry.span) else {
        return;
    };
    let (value, range, step, title, symbol) = match &entry.value.data {
        Data::Table(_) => {
            let Some(inner) = Table::of(
                table.source(),
                table.problems(),
                &format!("parameters.{name}"),
                &entry.value,
            ) else {
                return;
            };
            let texts = (
                inner
                    .required("value")
                    .and_then(|value| inner.as_formula("value", value)),
                inner.text("range"),
                inner
                    .value("step")
                    .and_then(|value| inner.as_formula("step", value)),
                inner.text("name"),
                inner.text("symbol"),
            );
            inner.finish();
            texts
        }
        _ => (
            table.as_formula(&entry.key, &entry.value),
            None,
            None,
            None,
            None,
        ),
    };
    let Some(value) = value else { return };
    let symbol = reader.symbol(name.as_str(), symbol.as_ref());
    let title: Option<Arc<str>> = title.map(|text| text.value.into());
    let texts = Texts {
        value: &value.value,
        range: range.as_ref().map(|text| text.value.as_str()),
        step: step.as_ref().map(|text| text.value.as_str()),
    };
    match Parameter::of(&name, title.clone(), symbol.clone(), &texts) {
        Ok(parameter) => take_parameter(reader, parameter, entry.span),
        Err((field, error)) => {
            let about = match field {
                ParameterField::Value => &value,
                ParameterField::Range => range.as_ref().unwrap_or(&value),
                ParameterField::Step => step.as_ref().unwrap_or(&value),
            };
            reader.find(&error, about);
        }
    }
}

fn take_parameter(reader: &mut ItemReader<'_>, parameter: Parameter, span: Span) {
    let kind = Type::real(parameter.unit.dimension());
    match reader.graph.parameter(&parameter.name, kind) {
        Err(error) => find_name(reader, &error, parameter.name.as_str(), span),
        Ok(node) => {
            let info = QuantityInfo {
                name: parameter.name.clone(),
                title: parameter.title.clone(),
                symbol: Arc::clone(&parameter.symbol),
                units: Some(Units::One(parameter.unit)),
                digits: reader.digits,
                verify: None,
                parameter: Some(reader.parameters.len()),
            };
            reader.quantities.insert(node, info);
            reader.parameters.push(parameter);
        }
    }
}

/// A symbol or coordinate: a unit, or a table with one.
fn free_name<'s>(reader: &mut ItemReader<'s>, table: &Table<'s>, entry: &'s Entry, role: Role) {
    let Some(name) = reader.name(&entry.key, entry.span) else {
        return;
    };
    let mut symbol = None;
    let unit = match &entry.value.data {
        Data::Table(_) => {
            let Some(inner) = Table::of(table.source(), table.problems(), &entry.key, &entry.value)
            else {
                return;
            };
            let unit = inner.required_text("unit");
            symbol = inner.text("symbol");
            inner.text("name");
            inner.finish();
            unit
        }
        _ => table.as_text(&entry.key, &entry.value),
    };
    let Some(unit) = unit.and_then(|text| reader.unit(&text)) else {
        return;
    };
    know(reader, name, unit, symbol.as_ref(), role, entry.span);
}

/// A name that is free in all formulas, unless a quantity bears it too.
pub(crate) fn know(
    reader: &mut ItemReader<'_>,
    name: Name,
    unit: Unit,
    symbol: Option<&Text>,
    role: Role,
    span: Span,
) {
    let kind = Type::real(unit.dimension());
    if let Err(error) = reader.graph.free(&name, kind.clone()) {
        find_name(reader, &error, name.as_str(), span);
    }
    let symbol = reader.symbol(name.as_str(), symbol);
    if !reader.free.iter().any(|known| known.name == name) {
        reader.free.push(Known {
            name,
            symbol,
            title: None,
            kind,
            role,
        });
    }
}

/// The quantities: all names first, then the formulas in an order that their dependence allows.
pub(crate) fn read<'s>(reader: &mut ItemReader<'s>, table: &Table<'s>) {
    let models = models::read(reader, table);
    let quantities = table.table("quantities");
    let declared: Vec<DeclaredQuantity> = match &quantities {
        Some(own) => own
            .entries()
            .iter()
            .filter_map(|entry| declare(reader, own, entry))
            .collect(),
        None => Vec::new(),
    };
    for (node, error) in reader.graph.resolve() {
        let owner = declared
            .iter()
            .find(|one| one.node == node || reader.graph.condition(one.node) == Some(node));
        if let Some(model) = models.iter().find(|model| model.node == node) {
            models::find_in_model(reader, &error, model);
        }
        if let Some(one) = owner {
            let text = if one.node == node {
                &one.formula
            } else {
                one.when.as_ref().unwrap_or(&one.formula)
            };
            reader.find(&error, text);
        }
    }
    for one in &declared {
        hold_unit(reader, one);
    }
    for one in declared {
        let label = format!("check of {}", one.name);
        if let (Some(text), Some(node)) =
            (&one.verify, reader.graph.kind(one.node).map(|_| one.node))
        {
            let verify = reader
                .formula(&label, text)
                .filter(|route| is_route(reader, &one, *route, text));
            if let Some(info) = reader.quantities.get_mut(&node) {
                info.verify = verify;
            }
        }
    }
}

/// Whether a second route leads to what the first one does: truth or numbers, of the same dimension.
fn is_route(
    reader: &mut ItemReader<'_>,
    declared: &DeclaredQuantity,
    route: NodeId,
    text: &Text,
) -> bool {
    let (Some(own), Some(other)) = (reader.graph.kind(declared.node), reader.graph.kind(route))
    else {
        return true;
    };
    let is_truth = |kind: &Type| kind.field() == crate::expr::Field::Boolean;
    let is_alike = is_truth(own) == is_truth(other)
        && match (own.dimension(), other.dimension()) {
            (Some(own), Some(other)) => own == other,
            _ => true,
        };
    if !is_alike {
        let described = |kind: &Type| match kind.dimension() {
            Some(dimension) if !is_truth(kind) => dimension.describe(),
            _ => kind.form().to_string(),
        };
        let error = ItemError::Route {
            name: declared.name.to_string(),
            expected: described(own),
            found: described(other),
        };
        reader.find(&error, text);
    }
    is_alike
}

fn declare<'s>(
    reader: &mut ItemReader<'s>,
    table: &Table<'s>,
    entry: &'s Entry,
) -> Option<DeclaredQuantity> {
    let name = reader.name(&entry.key, entry.span)?;
    if let Data::Text(_) | Data::Number { .. } = entry.value.data {
        let formula = table.as_formula(&entry.key, &entry.value)?;
        let expr = reader.expr(&formula)?;
        let symbol = Arc::new(crate::math::symbol(name.as_str()));
        return take_quantity(
            reader, name, expr, None, formula, None, None, None, symbol, None, entry.span,
        );
    }
    let inner = Table::of(
        table.source(),
        table.problems(),
        &format!("quantities.{name}"),
        &entry.value,
    )?;
    let formula = inner
        .required("formula")
        .and_then(|value| inner.as_formula("formula", value));
    let units = inner
        .value("unit")
        .and_then(|value| units(reader, &inner, value));
    let (title, symbol) = (inner.text("name"), inner.text("symbol"));
    let verify = inner
        .value("verify")
        .and_then(|value| inner.as_formula("verify", value));
    let when = inner.text("when");
    let digits = inner
        .integer("digits", "an integer from 1 to 12", 1..=12)
        .map(|digits| digits as u8);
    inner.finish();
    let formula = formula?;
    let expr = reader.expr(&formula)?;
    let symbol = reader.symbol(name.as_str(), symbol.as_ref());
    let condition = match &when {
        Some(text) => Some((reader.expr(text)?, text.clone())),
        None => None,
    };
    take_quantity(
        reader,
        name,
        expr,
        units,
        formula,
        verify,
        condition,
        title.map(|text| text.value.into()),
        symbol,
        digits,
        entry.span,
    )
}

#[expect(
    clippy::too_many_arguments,
    reason = "the fields of one declaration, taken apart once"
)]
fn take_quantity(
    reader: &mut ItemReader<'_>,
    name: Name,
    expr: crate::expr::Expr,
    units: Option<(Units, Text)>,
    formula: Text,
    verify: Option<Text>,
    when: Option<(crate::expr::Expr, Text)>,
    title: Option<Arc<str>>,
    symbol: Arc<crate::math::Math>,
    digits: Option<u8>,
    span: Span,
) -> Option<DeclaredQuantity> {
    let assumed = match &units {
        Some((Units::One(unit), _)) => Some(Type::real(unit.dimension())),
        _ => None,
    };
    let (condition, when) = when.map_or((None, None), |(expr, text)| (Some(expr), Some(text)));
    match reader.graph.quantity(&name, expr, assumed, condition) {
        Err(error) => {
            find_name(reader, &error, name.as_str(), span);
            None
        }
        Ok(node) => {
            let info = QuantityInfo {
                name: name.clone(),
                title,
                symbol,
                units: units.as_ref().map(|(units, _)| units.clone()),
                digits: digits.unwrap_or(reader.digits),
                verify: None,
                parameter: None,
            };
            reader.quantities.insert(node, info);
            Some(DeclaredQuantity {
                node,
                name,
                formula,
                units,
                verify,
                when,
            })
        }
    }
}

fn find_name(reader: &mut ItemReader<'_>, error: &GraphError, name: &str, span: Span) {
    let text = Text {
        value: name.to_owned(),
        span,
    };
    reader.find(error, &text);
}

/// One unit for all entries, or an array of them; the text is for findings.
fn units<'s>(
    reader: &mut ItemReader<'s>,
    table: &Table<'s>,
    value: &'s Value,
) -> Option<(Units, Text)> {
    if let Data::Text(_) = value.data {
        let text = table.as_text("unit", value)?;
        return Some((Units::One(reader.unit(&text)?), text));
    }
    let mut units = Vec::new();
    let rows = table.items("unit", value);
    for row in rows {
        match &row.data {
            Data::List(cells) => {
                for cell in cells {
                    let text = table.as_text("unit", cell)?;
                    units.push(entry_unit(reader, &text)?);
                }
            }
            _ => {
                let text = table.as_text("unit", row)?;
                units.push(entry_unit(reader, &text)?);
            }
        }
    }
    let text = Text {
        value: String::new(),
        span: value.span,
    };
    Some((Units::Each(units), text))
}

/// The unit of an entry; `0` marks one that is always zero.
fn entry_unit(reader: &mut ItemReader<'_>, text: &Text) -> Option<Unit> {
    if text.value == "0" {
        Some(Unit::ONE)
    } else {
        reader.unit(text)
    }
}

/// Holds the declared unit against the dimension of the formula.
fn hold_unit(reader: &mut ItemReader<'_>, declared: &DeclaredQuantity) {
    let Some((units, text)) = &declared.units else {
        return;
    };
    let Some(kind) = reader.graph.kind(declared.node).cloned() else {
        return;
    };
    let name = declared.name.to_string();
    let count = kind.shape().len();
    match units {
        Units::Each(units) if units.len() != count => {
            let error = ItemError::UnitCount {
                name,
                found: units.len(),
                expected: count,
            };
            reader.find(&error, text);
        }
        _ => {
            let unit = |position: usize| match units {
                Units::One(unit) => *unit,
                Units::Each(units) => units[position],
            };
            let wrong = kind.entries().enumerate().find_map(|(position, found)| {
                found
                    .filter(|found| *found != unit(position).dimension())
                    .map(|found| (unit(position), found))
            });
            if let Some((declared_unit, found)) = wrong {
                let error = ItemError::DeclaredUnit {
                    name,
                    declared: declared_unit.to_string(),
                    found: found.describe(),
                };
                reader.find(&error, &declared.formula);
            }
        }
    }
}
