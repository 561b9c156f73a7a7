//! The tables of phasor diagrams: pointers and the angles between them.

use super::plots::coherent;
use super::{ItemError, ItemReader};
use crate::bank::plot::{Phasor, Phasors, Turn};
use crate::expr::{Form, Type};
use crate::quantity::NodeId;
use crate::source::{Table, Text};

impl<'s> ItemReader<'s> {
    pub(crate) fn phasors(&mut self, table: &Table<'s>) -> Option<Phasors> {
        let unit = table.text("unit");
        let unit = unit.and_then(|text| self.unit(&text));
        let items = table.required("phasors");
        let mut phasors: Vec<(Phasor, Text)> = Vec::new();
        for item in self.few(table, "phasors", items?) {
            let inner = Table::of(table.source(), table.problems(), "phasors", item);
            phasors.extend(inner.and_then(|inner| self.phasor(table.name(), &inner)));
        }
        let angles = table.tables("angles").into_iter();
        let angles = angles
            .filter_map(|angle| self.turn(table.name(), &angle))
            .collect();
        let unit = match unit {
            Some(unit) => unit,
            None => coherent(self.dimension_of(&[phasors.first()?.0.of])),
        };
        for (phasor, text) in &phasors {
            self.hold(&unit, self.dimension_of(&[phasor.of]), text);
        }
        Some(Phasors {
            phasors: phasors.into_iter().map(|(phasor, _)| phasor).collect(),
            angles,
            unit,
        })
    }

    fn phasor(&mut self, plot: &str, table: &Table<'s>) -> Option<(Phasor, Text)> {
        let of = table
            .required("of")
            .and_then(|of| table.as_formula("of", of));
        let label = table.text("label").map(|label| self.plot_label(&label));
        let style = self.style(table);
        let is_joined = table.boolean("joined").unwrap_or(false);
        table.finish_ref();
        let text = of?;
        let of = self.pointer(plot, &text)?;
        let phasor = Phasor {
            of,
            label,
            is_joined,
            style,
        };
        Some((phasor, text))
    }

    fn turn(&mut self, plot: &str, table: &Table<'s>) -> Option<Turn> {
        let ends = ["from", "to"].map(|key| {
            let value = table.required(key)?;
            let text = table.as_formula(key, value)?;
            self.pointer(plot, &text)
        });
        let label = table.text("label").map(|label| self.plot_label(&label));
        table.finish_ref();
        let [from, to] = ends;
        Some(Turn {
            ends: [from?, to?],
            label,
        })
    }

    /// A formula that is one real or complex number for given data.
    fn pointer(&mut self, plot: &str, text: &Text) -> Option<NodeId> {
        let node = self.formula(&format!("{plot}: phasor"), text)?;
        let form = self.graph.kind(node).map(Type::form);
        if form != Some(Form::REAL) && form != Some(Form::COMPLEX) {
            self.find(&ItemError::Phasor, text);
            return None;
        }
        if let Some(of) = self.graph.variables(node).first() {
            let of = of.to_string();
            self.find(&ItemError::PlotVariable { of }, text);
            return None;
        }
        Some(node)
    }
}
