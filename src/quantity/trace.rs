//! What an evaluation computed, and what nobody asked for.

use super::graph::{Graph, NodeId, NodeRole};

/// The names of what was computed and of what was skipped, in the order of the item.
///
/// Parameters are given, not computed, and stand in neither list.
#[derive(Clone, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct Trace {
    /// What was computed.
    pub computed: Vec<String>,
    /// What was not.
    pub skipped: Vec<String>,
}

impl Trace {
    pub(crate) fn of(graph: &Graph, is_computed: impl Fn(&NodeId) -> bool) -> Self {
        let mut trace = Self::default();
        for id in graph.ids() {
            let node = graph.node(id);
            if matches!(node.role, NodeRole::Parameter(_)) {
                continue;
            }
            let list = if is_computed(&id) {
                &mut trace.computed
            } else {
                &mut trace.skipped
            };
            list.push(node.label.to_string());
        }
        trace
    }
}
