//! What follows from a student's own equation of motion with one coordinate.

use super::answers::in_data;
use crate::bank::Template;
use crate::expr::{Equation, Expr, Kind, Name, Substitution, Variable, differentiate};
use crate::mechanics::{Model, Quantity, Sdof};
use crate::quantity::{Graph, NodeId};

/// The coefficients of m x'' + c x' + k x = f(t).
pub(crate) struct Coefficients {
    pub(crate) mass: Expr,
    pub(crate) damping: Expr,
    pub(crate) stiffness: Expr,
}

/// The quantities of an item that are, by their formula or their second route, a number of a model of one
/// coordinate, each as it follows from an equation of motion in this coordinate.
pub(crate) fn quantities(template: &Template, equation: &Equation) -> Vec<(NodeId, Expr)> {
    let found = numbers(template).filter_map(|(node, coordinate, single)| {
        let formula = Coefficients::of(equation, &coordinate)?.formula(single)?;
        Some((node, formula))
    });
    found.collect()
}

/// The quantities of an item that are numbers of models of one coordinate, with the coordinate.
pub(crate) fn numbers(template: &Template) -> impl Iterator<Item = (NodeId, Name, Sdof)> + '_ {
    template.quantities.iter().filter_map(|(node, info)| {
        let mut routes = [Some(*node), info.verify].into_iter().flatten();
        let (coordinate, single) = routes.find_map(|route| number(&template.graph, route))?;
        Some((*node, coordinate, single))
    })
}

/// The number of a model of one coordinate that a node is, and the coordinate.
fn number(graph: &Graph, node: NodeId) -> Option<(Name, Sdof)> {
    match (offered(graph, node)?, offered(graph, node)?.0.coordinates()) {
        ((_, Quantity::Sdof(single)), [coordinate]) => Some((coordinate.clone(), single)),
        _ => None,
    }
}

/// The quantity of a model that a node is.
fn offered(graph: &Graph, node: NodeId) -> Option<(&Model, Quantity)> {
    let Kind::Path(path) = graph.expr(node)?.kind() else {
        return None;
    };
    let (model, quantity) = graph.offered(path)?;
    Some((model, quantity))
}

/// A number of the model of one coordinate by its right equation of motion, in the data.
pub(crate) fn right(template: &Template, coordinate: &Name, single: Sdof) -> Option<Expr> {
    let graph = &template.graph;
    let mut nodes = template
        .quantities
        .iter()
        .flat_map(|(node, info)| [Some(*node), info.verify].into_iter().flatten());
    let equation = nodes.find_map(|node| {
        let (model, _) = offered(graph, node)?;
        let is_it = model.coordinates() == std::slice::from_ref(coordinate);
        model.equation(0).filter(|_| is_it)
    })?;
    let formula = Coefficients::of(&equation, coordinate)?.formula(single)?;
    in_data(&formula, graph)
}

impl Coefficients {
    /// The coefficients, if the equation is linear in the coordinate and they are constant.
    pub(crate) fn of(equation: &Equation, coordinate: &Name) -> Option<Self> {
        let difference = equation.difference();
        let coefficient = |order| {
            let slope = differentiate(&difference, Variable::of(coordinate, order)).ok()?;
            let is_constant = !slope.reaches(|name| name == coordinate || name.as_str() == "t");
            is_constant.then_some(slope)
        };
        let (mass, damping, stiffness) = (coefficient(2)?, coefficient(1)?, coefficient(0)?);
        (!mass.is_zero()).then_some(Self {
            mass,
            damping,
            stiffness,
        })
    }

    /// A number of the oscillator in formulas.
    fn formula(&self, single: Sdof) -> Option<Expr> {
        let put = Substitution::new()
            .with("m", self.mass.clone())
            .with("c", self.damping.clone())
            .with("k", self.stiffness.clone());
        put.apply(&Expr::read(single.definition()).ok()?).ok()
    }
}
