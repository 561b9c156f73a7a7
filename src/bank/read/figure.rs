//! The figure of an item.

use std::collections::BTreeMap;

use super::Reader;
use crate::answer::Known;
use crate::bank::template::QuantityInfo;
use crate::document::Document;
use crate::expr::{Expr, Name, Notation, Scope, Symbol};
use crate::figure::{Figure, Subject};
use crate::math::{Math, symbol};
use crate::quantity::{Graph, NodeId};
use crate::source::Table;

/// The names of an item as its figure sees them.
struct Names<'a> {
    graph: &'a Graph,
    quantities: &'a BTreeMap<NodeId, QuantityInfo>,
    free: &'a [Known],
}

impl Notation for Names<'_> {
    fn name(&self, name: &Name) -> Symbol {
        let quantity = self
            .graph
            .find(name)
            .and_then(|node| self.quantities.get(&node));
        let free = || self.free.iter().find(|known| known.name == *name);
        Symbol::letter(
            quantity
                .map(|info| &info.symbol)
                .or_else(|| free().map(|known| &known.symbol))
                .map_or_else(|| symbol(name.as_str()), |own| Math::clone(own)),
        )
    }
}

impl Subject for Names<'_> {
    fn scope(&self) -> &dyn Scope {
        self.graph
    }

    fn typeset(&self, formula: &Expr) -> Math {
        formula.typeset(self)
    }
}

impl<'s> Reader<'s> {
    /// The figure and what is written under it.
    pub(super) fn figure(&mut self, table: &Table<'s>) -> (Option<Figure>, Document) {
        let Some(table) = table.table("figure") else {
            return (None, Document::default());
        };
        let caption = table.text("caption");
        let caption = caption
            .map(|text| self.plain_text(&text))
            .unwrap_or_default();
        let names = Names {
            graph: &self.graph,
            quantities: &self.quantities,
            free: &self.free,
        };
        let (figure, mut findings) = Figure::read(&table, &names);
        self.findings.append(&mut findings);
        table.finish();
        (Some(figure), caption)
    }
}
