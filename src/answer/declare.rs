//! What a kind asks of the item that is being read, and gets of an instance.

use std::rc::Rc;
use std::sync::Arc;

use crate::diagnostic::Diagnose;
use crate::document::Document;
use crate::expr::{Equation, Expr, Name, Type, Value};
use crate::math::Math;
use crate::numerics::SortedMap;
use crate::quantity::{Evaluation, Graph, NodeId};
use crate::source::Text;
use crate::unit::{DecimalMark, Unit};

use super::{Credit, Sampling};

/// The item that is being read.
pub trait Declare {
    /// Reads a formula and checks its names and dimensions; `None`, with a finding, where it is wrong.
    fn formula(&mut self, label: &str, text: &Text) -> Option<NodeId>;

    /// Reads a condition.
    fn condition(&mut self, label: &str, text: &Text) -> Option<NodeId>;

    /// Reads a unit.
    fn unit(&mut self, text: &Text) -> Option<Unit>;

    /// Reads a text without placeholders, such as that of an option.
    fn text(&mut self, text: &Text) -> Document;

    /// The graph with all names and the formulas read so far.
    fn graph(&self) -> &Graph;

    /// Takes a formula that was read as a part of `text`, and checks its names and dimensions.
    fn expr(&mut self, label: &str, expr: Expr, text: &Text) -> Option<NodeId>;

    /// The equations of a model that a path names, `model.equation.x1`; `None`, with a finding, where there are none.
    fn equations(&mut self, text: &Text) -> Option<Vec<Equation>>;

    /// The coordinates of the model whose equations a text names; none where it names none.
    fn coordinates_of(&self, text: &Text) -> Vec<Name>;

    /// The constraints of the item, which its data meet.
    fn constraints(&self) -> Vec<Expr>;

    /// All names of the item.
    fn known(&self) -> Vec<Known>;

    /// Whether the part that is read, or an earlier one, writes a symbol that only answers use.
    fn is_introduced(&self, symbol: &Name) -> bool;

    /// The one unit of all entries of a quantity.
    fn unit_of(&self, node: NodeId) -> Option<Unit>;

    /// The units of the entries of a quantity, by rows; none where they are not known.
    fn units_of(&self, node: NodeId) -> Vec<Unit>;

    /// The significant figures in which a node is printed.
    fn digits_of(&self, node: NodeId) -> u8;

    /// The significant figures of the work that the item asks for.
    fn figures(&self) -> u8;

    /// Notes a finding about a text of the file; its places count in that text.
    fn find(&mut self, error: &dyn Diagnose, text: &Text);
}

/// A name of the item, as responses may use it.
#[derive(Clone, Debug)]
pub struct Known {
    /// The name under which the item knows it.
    pub name: Name,
    /// How it is printed.
    pub symbol: Arc<Math>,
    /// What it is, in words.
    pub title: Option<Arc<str>>,
    /// What it stands for.
    pub kind: Type,
    /// A datum, a quantity, a coordinate, or a letter that only answers use.
    pub role: Role,
}

/// What a name of an item is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// A datum.
    Parameter {
        /// Its place in the graph of quantities.
        node: NodeId,
        /// Whether it may be negative.
        is_signed: bool,
        /// Whether it is an integer by its meaning, such as a number of cycles.
        is_integer: bool,
    },
    /// A letter that only answers use.
    Symbol,
    /// A coordinate of a model, which moves with time.
    Coordinate,
    /// A quantity that the item computes from its data.
    Quantity {
        /// Its place in the graph of quantities.
        node: NodeId,
        /// Whether an earlier part asks for it.
        is_asked: bool,
    },
}

/// The data of an instance, for which a key is prepared.
pub struct Context<'t> {
    /// The values.
    pub evaluation: Rc<Evaluation<'t>>,
    /// What formulas are compared at.
    pub sampling: Rc<Sampling<'t>>,
    /// The named mistakes that apply.
    pub mistakes: Vec<Mistaken>,
    /// Formulas that stand in for quantities of a symbolic key: what was answered to earlier parts.
    pub standing: SortedMap<Name, Expr>,
    /// The order in which the options of a choice are printed, as places in the file.
    pub order: Vec<usize>,
    /// The decimal sign of the sheet.
    pub mark: DecimalMark,
    /// What to do where readings of a response differ.
    pub doubt: super::Doubt,
}

/// A named mistake for these data.
#[derive(Clone, Debug)]
pub struct Mistaken {
    /// Its number in the item, from 0.
    pub number: usize,
    /// Its formulas, where it is given by such.
    pub given: Vec<NodeId>,
    /// What it gives: the values of its formulas, or of those of the key with quantities replaced.
    /// Empty where the kind compares formulas ([`super::Answer::keeps_mistakes`]).
    pub values: Vec<Value>,
    /// The quantities that it replaces in the key.
    pub replaced: Vec<(NodeId, NodeId)>,
    /// The unit in which it is given, where it has another dimension than the part.
    pub unit: Option<Unit>,
    /// What it is worth.
    pub credit: Credit,
}
