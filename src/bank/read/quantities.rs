//! Data, symbols, coordinates and quantities: the names of an item.

use std::sync::Arc;

use super::{ItemError, ItemReader};
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

impl<'s> ItemReader<'s> {
    /// Parameters and symbols.
    pub(crate) fn data(&mut self, table: &Table<'s>) {
        if let Some(parameters) = table.table("parameters") {
            parameters
                .entries()
                .iter()
                .for_each(|entry| self.parameter(&parameters, entry));
        }
        if let Some(symbols) = table.table("symbols") {
            symbols
                .entries()
                .iter()
                .for_each(|entry| self.free_name(&symbols, entry, Role::Symbol));
        }
    }

    fn parameter(&mut self, table: &Table<'s>, entry: &'s Entry) {
        let Some(name) = self.name(&entry.key, entry.span) else {
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
        let symbol = self.symbol(name.as_str(), symbol.as_ref());
        let title: Option<Arc<str>> = title.map(|text| text.value.into());
        let texts = Texts {
            value: &value.value,
            range: range.as_ref().map(|text| text.value.as_str()),
            step: step.as_ref().map(|text| text.value.as_str()),
        };
        match Parameter::of(&name, title.clone(), symbol.clone(), &texts) {
            Ok(parameter) => self.take_parameter(parameter, entry.span),
            Err((field, error)) => {
                let about = match field {
                    ParameterField::Value => &value,
                    ParameterField::Range => range.as_ref().unwrap_or(&value),
                    ParameterField::Step => step.as_ref().unwrap_or(&value),
                };
                self.find(&error, about);
            }
        }
    }

    fn take_parameter(&mut self, parameter: Parameter, span: Span) {
        let kind = Type::real(parameter.unit.dimension());
        match self.graph.parameter(&parameter.name, kind) {
            Err(error) => self.find_name(&error, parameter.name.as_str(), span),
            Ok(node) => {
                let info = QuantityInfo {
                    name: parameter.name.clone(),
                    title: parameter.title.clone(),
                    symbol: Arc::clone(&parameter.symbol),
                    units: Some(Units::One(parameter.unit)),
                    digits: self.digits,
                    verify: None,
                    parameter: Some(self.parameters.len()),
                };
                self.quantities.insert(node, info);
                self.parameters.push(parameter);
            }
        }
    }

    /// A symbol or coordinate: a unit, or a table with one.
    fn free_name(&mut self, table: &Table<'s>, entry: &'s Entry, role: Role) {
        let Some(name) = self.name(&entry.key, entry.span) else {
            return;
        };
        let mut symbol = None;
        let unit = match &entry.value.data {
            Data::Table(_) => {
                let Some(inner) =
                    Table::of(table.source(), table.problems(), &entry.key, &entry.value)
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
        let Some(unit) = unit.and_then(|text| self.unit(&text)) else {
            return;
        };
        self.know(name, unit, symbol.as_ref(), role, entry.span);
    }

    /// A name that is free in all formulas, unless a quantity bears it too.
    pub(crate) fn know(
        &mut self,
        name: Name,
        unit: Unit,
        symbol: Option<&Text>,
        role: Role,
        span: Span,
    ) {
        let kind = Type::real(unit.dimension());
        if let Err(error) = self.graph.free(&name, kind.clone()) {
            self.find_name(&error, name.as_str(), span);
        }
        let symbol = self.symbol(name.as_str(), symbol);
        if !self.free.iter().any(|known| known.name == name) {
            self.free.push(Known {
                name,
                symbol,
                title: None,
                kind,
                role,
            });
        }
    }

    /// The quantities: all names first, then the formulas in an order that their dependence allows.
    pub(crate) fn quantities(&mut self, table: &Table<'s>) {
        let models = self.models(table);
        let quantities = table.table("quantities");
        let declared: Vec<DeclaredQuantity> = match &quantities {
            Some(own) => own
                .entries()
                .iter()
                .filter_map(|entry| self.declare(own, entry))
                .collect(),
            None => Vec::new(),
        };
        for (node, error) in self.graph.resolve() {
            let owner = declared
                .iter()
                .find(|one| one.node == node || self.graph.condition(one.node) == Some(node));
            if let Some(model) = models.iter().find(|model| model.node == node) {
                self.find_in_model(&error, model);
            }
            if let Some(one) = owner {
                let text = if one.node == node {
                    &one.formula
                } else {
                    one.when.as_ref().unwrap_or(&one.formula)
                };
                self.find(&error, text);
            }
        }
        for one in &declared {
            self.hold_unit(one);
        }
        for one in declared {
            let label = format!("check of {}", one.name);
            if let (Some(text), Some(node)) =
                (&one.verify, self.graph.kind(one.node).map(|_| one.node))
            {
                let verify = self
                    .formula(&label, text)
                    .filter(|route| self.is_route(&one, *route, text));
                if let Some(info) = self.quantities.get_mut(&node) {
                    info.verify = verify;
                }
            }
        }
    }

    /// Whether a second route leads to what the first one does: truth or numbers, of the same dimension.
    fn is_route(&mut self, declared: &DeclaredQuantity, route: NodeId, text: &Text) -> bool {
        let (Some(own), Some(other)) = (self.graph.kind(declared.node), self.graph.kind(route))
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
            self.find(&error, text);
        }
        is_alike
    }

    fn declare(&mut self, table: &Table<'s>, entry: &'s Entry) -> Option<DeclaredQuantity> {
        let name = self.name(&entry.key, entry.span)?;
        if let Data::Text(_) | Data::Number { .. } = entry.value.data {
            let formula = table.as_formula(&entry.key, &entry.value)?;
            let expr = self.expr(&formula)?;
            let symbol = Arc::new(crate::math::symbol(name.as_str()));
            return self.take_quantity(
                name, expr, None, formula, None, None, None, symbol, None, entry.span,
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
            .and_then(|value| self.units(&inner, value));
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
        let expr = self.expr(&formula)?;
        let symbol = self.symbol(name.as_str(), symbol.as_ref());
        let condition = match &when {
            Some(text) => Some((self.expr(text)?, text.clone())),
            None => None,
        };
        self.take_quantity(
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
        &mut self,
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
        match self.graph.quantity(&name, expr, assumed, condition) {
            Err(error) => {
                self.find_name(&error, name.as_str(), span);
                None
            }
            Ok(node) => {
                let info = QuantityInfo {
                    name: name.clone(),
                    title,
                    symbol,
                    units: units.as_ref().map(|(units, _)| units.clone()),
                    digits: digits.unwrap_or(self.digits),
                    verify: None,
                    parameter: None,
                };
                self.quantities.insert(node, info);
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

    fn find_name(&mut self, error: &GraphError, name: &str, span: Span) {
        let text = Text {
            value: name.to_owned(),
            span,
        };
        self.find(error, &text);
    }

    /// One unit for all entries, or an array of them; the text is for findings.
    fn units(&mut self, table: &Table<'s>, value: &'s Value) -> Option<(Units, Text)> {
        if let Data::Text(_) = value.data {
            let text = table.as_text("unit", value)?;
            return Some((Units::One(self.unit(&text)?), text));
        }
        let mut units = Vec::new();
        let rows = table.items("unit", value);
        for row in rows {
            match &row.data {
                Data::List(cells) => {
                    for cell in cells {
                        let text = table.as_text("unit", cell)?;
                        units.push(self.entry_unit(&text)?);
                    }
                }
                _ => {
                    let text = table.as_text("unit", row)?;
                    units.push(self.entry_unit(&text)?);
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
    fn entry_unit(&mut self, text: &Text) -> Option<Unit> {
        if text.value == "0" {
            Some(Unit::ONE)
        } else {
            self.unit(text)
        }
    }

    /// Holds the declared unit against the dimension of the formula.
    fn hold_unit(&mut self, declared: &DeclaredQuantity) {
        let Some((units, text)) = &declared.units else {
            return;
        };
        let Some(kind) = self.graph.kind(declared.node).cloned() else {
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
                self.find(&error, text);
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
                    self.find(&error, &declared.formula);
                }
            }
        }
    }
}
