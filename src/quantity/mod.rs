//! An item's quantities and how they depend on each other; demand-driven evaluation and its trace.
//!
//! A [`Graph`] holds everything of an item that has a value: parameters, quantities, and the formulas
//! of constraints, keys, mistakes and figures. Its names are resolved, its dimensions checked and
//! cycles refused when the item is loaded. An [`Evaluation`] computes what is asked for and what that
//! depends on, each once, and can say afterwards what it computed ([`Trace`]).
//!
//! A quantity that reaches the time `t`, a coordinate or a symbol is a function of it and has no
//! number of its own; it is put in place where it is used.

mod error;
mod evaluate;
mod given;
mod graph;
mod link;
mod method;
mod model;
mod settle;
mod trace;

pub use error::GraphError;
pub use evaluate::{Absent, Evaluation, Function};
pub use graph::{Graph, NodeId};
#[cfg(feature = "render")]
pub(crate) use method::variations;
pub use method::{Datum, Method, Wrong};
pub use trace::Trace;
