//! The figure of an item.

use super::{ItemReader, passages};
use crate::answer::Known;
use crate::bank::template::QuantityInfo;
use crate::document::Document;
use crate::expr::{Expr, Name, Notation, Scope, Symbol};
use crate::figure::{Acting, Figure, Move, Subject};
use crate::math::{Math, symbol};
use crate::mechanics::Model;
use crate::numerics::SortedMap;
use crate::quantity::{Graph, NodeId};
use crate::source::Table;
use crate::unit::Dimension;

/// The names of an item as its figure and its plots see them.
pub(crate) struct ItemNames<'a> {
    graph: &'a Graph,
    quantities: &'a SortedMap<NodeId, QuantityInfo>,
    free: &'a [Known],
}

impl<'a> ItemNames<'a> {
    pub(crate) fn of(reader: &'a ItemReader<'_>) -> Self {
        Self {
            graph: &reader.graph,
            quantities: &reader.quantities,
            free: &reader.free,
        }
    }

    /// The symbol of a quantity, or else of a free variable.
    pub(crate) fn symbol(&self, name: &Name) -> Math {
        let quantity = self
            .graph
            .find(name)
            .and_then(|node| self.quantities.get(&node));
        let mut free = self.free.iter();
        quantity
            .map(|info| &info.symbol)
            .or_else(|| Some(&free.find(|known| known.name == *name)?.symbol))
            .map_or_else(|| symbol(name.as_str()), |own| own.as_ref().clone())
    }
}

impl Notation for ItemNames<'_> {
    fn name(&self, name: &Name) -> Symbol {
        Symbol::letter(self.symbol(name))
    }
}

impl Subject for ItemNames<'_> {
    fn scope(&self) -> &dyn Scope {
        self.graph
    }

    fn typeset(&self, formula: &Expr) -> Math {
        formula.typeset(self)
    }

    fn bodies(&self) -> Vec<Acting> {
        let bodies = self
            .graph
            .derived("model")
            .map_or(&[][..], |model| model.bodies());
        let of_turn = Dimension::MASS * Dimension::LENGTH * Dimension::LENGTH;
        bodies
            .iter()
            .map(|body| Acting {
                body: body.name.clone(),
                moves: body
                    .moves
                    .iter()
                    .map(|(name, inertia)| {
                        let kind = inertia.check(self.graph).ok();
                        Move {
                            name: name.clone(),
                            is_turn: kind.and_then(|kind| kind.dimension()) == Some(of_turn),
                        }
                    })
                    .collect(),
                forces: body.forces.clone(),
            })
            .collect()
    }

    fn coordinates(&self) -> Vec<(Name, Dimension)> {
        self.model()
            .map_or_else(Vec::new, Model::coordinate_dimensions)
    }

    fn in_coordinates(&self, formula: &Expr) -> Expr {
        self.model()
            .and_then(|model| model.in_coordinates(formula))
            .unwrap_or_else(|| formula.clone())
    }
}

impl ItemNames<'_> {
    fn model(&self) -> Option<&Model> {
        self.graph.derived("model").map(AsRef::as_ref)
    }
}

/// The figure and what is written under it.
pub(crate) fn read<'s>(
    reader: &mut ItemReader<'s>,
    table: &Table<'s>,
) -> (Option<Figure>, Document) {
    let Some(table) = table.table("figure") else {
        return (None, Document::default());
    };
    let caption = table.text("caption");
    reader.has_free = table.has("free");
    reader.moves = table.has("motion");
    let caption = caption
        .map(|text| passages::document(reader, &text))
        .unwrap_or_default();
    let (figure, mut findings) = Figure::read(&table, &ItemNames::of(reader));
    reader.findings.append(&mut findings);
    table.finish();
    (Some(figure), caption)
}
