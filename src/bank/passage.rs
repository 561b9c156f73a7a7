//! A text of an item, with what its placeholders stand for.

use crate::document::Document;
use crate::quantity::NodeId;

/// A text of an item: one document, or several of which those are shown whose condition holds.
#[derive(Clone, Debug, Default)]
pub struct Passage {
    /// The documents, in order.
    pub pieces: Vec<Piece>,
}

/// A document of a passage.
#[derive(Clone, Debug)]
pub struct Piece {
    /// Shown if this holds; always without it.
    pub when: Option<NodeId>,
    /// The text.
    pub document: Document,
    /// What its placeholders stand for, hole by hole.
    pub targets: Vec<Target>,
}

/// What a placeholder stands for.
#[derive(Clone, Debug, PartialEq)]
pub enum Target {
    /// A parameter or quantity.
    Node(NodeId),
    /// The figure of the item.
    Figure,
    /// The free-body diagrams of the item.
    Free,
    /// A mode drawn on the figure of the item, by its number from 0.
    Mode(usize),
    /// A plot, by name.
    Plot(String),
    /// Something of a model.
    Model(crate::expr::Path),
    /// The lines of a derivation of a model.
    Derivation(crate::expr::Path),
    /// Nothing: the item has a finding.
    Nothing,
}

impl Passage {
    /// Whether it says where the figure stands.
    pub fn places_figure(&self) -> bool {
        self.pieces
            .iter()
            .any(|piece| piece.targets.contains(&Target::Figure))
    }

    /// Whether there is no text in it.
    pub fn is_empty(&self) -> bool {
        self.pieces.iter().all(|piece| piece.document.is_empty())
    }
}
