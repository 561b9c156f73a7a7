//! The tables of phasor diagrams: pointers and the angles between them.

use super::plots::coherent;
use super::{ItemError, ItemReader, plots};
use crate::bank::plot::{Phasor, Phasors, Turn};
use crate::expr::{Form, Type};
use crate::quantity::NodeId;
use crate::source::{Table, Text};

pub(crate) fn read<'s>(reader: &mut ItemReader<'s>, table: &Table<'s>) -> Option<Phasors> {
    let unit = table.text("unit");
    let unit = unit.and_then(|text| reader.unit(&text));
    let items = table.required("phasors");
    let mut phasors: Vec<(Phasor, Text)> = Vec::new();
    for item in plots::few(reader, table, "phasors", items?) {
        let inner = Table::of(table.source(), table.problems(), "phasors", item);
        phasors.extend(inner.and_then(|inner| phasor(reader, table.name(), &inner)));
    }
    let angles = table.tables("angles").into_iter();
    let angles = angles
        .filter_map(|angle| turn(reader, table.name(), &angle))
        .collect();
    let unit = match unit {
        Some(unit) => unit,
        None => coherent(plots::dimension_of(reader, &[phasors.first()?.0.of])),
    };
    for (phasor, text) in &phasors {
        let dimension = plots::dimension_of(reader, &[phasor.of]);
        plots::hold(reader, &unit, dimension, text);
    }
    Some(Phasors {
        phasors: phasors.into_iter().map(|(phasor, _)| phasor).collect(),
        angles,
        unit,
    })
}

fn phasor<'s>(
    reader: &mut ItemReader<'s>,
    plot: &str,
    table: &Table<'s>,
) -> Option<(Phasor, Text)> {
    let of = table
        .required("of")
        .and_then(|of| table.as_formula("of", of));
    let label = table
        .text("label")
        .map(|label| plots::label_of(reader, &label));
    let style = plots::style(reader, table);
    let is_joined = table.boolean("joined").unwrap_or(false);
    table.finish_ref();
    let text = of?;
    let of = pointer(reader, plot, &text)?;
    let phasor = Phasor {
        of,
        label,
        is_joined,
        style,
    };
    Some((phasor, text))
}

fn turn<'s>(reader: &mut ItemReader<'s>, plot: &str, table: &Table<'s>) -> Option<Turn> {
    let ends = ["from", "to"].map(|key| {
        let value = table.required(key)?;
        let text = table.as_formula(key, value)?;
        pointer(reader, plot, &text)
    });
    let label = table
        .text("label")
        .map(|label| plots::label_of(reader, &label));
    table.finish_ref();
    let [from, to] = ends;
    Some(Turn {
        ends: [from?, to?],
        label,
    })
}

/// A formula that is one real or complex number for given data.
fn pointer(reader: &mut ItemReader<'_>, plot: &str, text: &Text) -> Option<NodeId> {
    let node = reader.formula(&format!("{plot}: phasor"), text)?;
    let form = reader.graph.kind(node).map(Type::form);
    if form != Some(Form::REAL) && form != Some(Form::COMPLEX) {
        reader.find(&ItemError::Phasor, text);
        return None;
    }
    if let Some(of) = reader.graph.variables(node).first() {
        let of = of.to_string();
        reader.find(&ItemError::PlotVariable { of }, text);
        return None;
    }
    Some(node)
}
