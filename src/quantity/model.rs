//! Mechanical systems among the quantities: what they need, and what they offer.

use std::sync::Arc;

use super::error::GraphError;
use super::graph::{Graph, GraphNode, NodeId, NodeRole};
use crate::expr::{CheckError, Expr, Kind, Name, Names, Path, Substitution, Type};
use crate::mechanics::{Definition, Model, Quantity, QuantityType};
use crate::numerics::SortedSet;
use crate::source::nearest;

/// A system as it is written, and once its names are settled, as it was derived.
#[derive(Debug)]
pub(crate) struct DeclaredSystem {
    pub(crate) definition: Definition,
    pub(crate) model: Option<Arc<Model>>,
}

/// A quantity that a model offers.
#[derive(Debug)]
pub(crate) struct Offered {
    /// The node of the system.
    pub(crate) system: NodeId,
    pub(crate) model: Arc<Model>,
    pub(crate) quantity: Quantity,
    pub(crate) quantity_type: QuantityType,
}

impl DeclaredSystem {
    /// The names that it takes from the item.
    pub(crate) fn needs(&self) -> SortedSet<Name> {
        needs(&self.definition)
    }
}

/// The names that a definition takes from the item.
fn needs(definition: &Definition) -> SortedSet<Name> {
    needed_by(definition, formulas(definition))
}

fn needed_by<'d>(
    definition: &'d Definition,
    formulas: impl Iterator<Item = &'d Expr>,
) -> SortedSet<Name> {
    let own: SortedSet<&Name> = own_names(definition).collect();
    let names = formulas.map(Expr::names);
    let free = names.flat_map(|names| names.free.into_iter().map(|variable| variable.name));
    free.filter(|name| !own.contains(name) && name.as_str() != "t")
        .collect()
}

/// The names that a definition brings along.
fn own_names(definition: &Definition) -> impl Iterator<Item = &Name> {
    let coordinates = definition
        .coordinates
        .iter()
        .map(|coordinate| &coordinate.name);
    let unknowns = definition.bodies.iter().flat_map(|body| &body.unknowns);
    let kinematics = definition.kinematics.iter().map(|(name, _)| name);
    coordinates.chain(kinematics).chain(unknowns)
}

/// The formulas of the bodies of a definition.
fn formulas_of_bodies(definition: &Definition) -> impl Iterator<Item = &Expr> {
    definition.bodies.iter().flat_map(|body| {
        let moves = body.moves.iter().map(|(_, inertia)| inertia);
        moves.chain(body.forces.iter().flat_map(|(_, all)| all))
    })
}

/// All formulas of a definition.
fn formulas(definition: &Definition) -> impl Iterator<Item = &Expr> {
    let named = definition
        .kinematics
        .iter()
        .chain(&definition.forces)
        .chain(&definition.equilibrium);
    let friction = definition
        .friction
        .iter()
        .flat_map(|(_, own)| std::iter::once(&own.kinetic).chain(&own.holding));
    let initial = definition
        .initial
        .iter()
        .flat_map(|(_, own)| [&own.position, &own.velocity]);
    let energies = [
        &definition.kinetic,
        &definition.potential,
        &definition.dissipation,
    ];
    energies
        .into_iter()
        .chain(named.map(|(_, formula)| formula))
        .chain(friction)
        .chain(initial)
}

/// All formulas of a definition, to be changed.
fn formulas_mut(definition: &mut Definition) -> Vec<&mut Expr> {
    let mut all = vec![
        &mut definition.kinetic,
        &mut definition.potential,
        &mut definition.dissipation,
    ];
    all.extend(definition.kinematics.iter_mut().map(|(_, formula)| formula));
    all.extend(definition.forces.iter_mut().map(|(_, formula)| formula));
    all.extend(
        definition
            .equilibrium
            .iter_mut()
            .map(|(_, formula)| formula),
    );
    for (_, friction) in &mut definition.friction {
        all.push(&mut friction.kinetic);
        all.extend(friction.holding.as_mut());
    }
    for (_, initial) in &mut definition.initial {
        all.extend([&mut initial.position, &mut initial.velocity]);
    }
    for body in &mut definition.bodies {
        all.extend(body.moves.iter_mut().map(|(_, inertia)| inertia));
        all.extend(body.forces.iter_mut().flat_map(|(_, all)| all));
    }
    all
}

/// Derives a system whose names are settled.
pub(crate) fn derive(graph: &mut Graph, id: NodeId) -> Vec<GraphError> {
    let Some(system) = graph.system(id) else {
        return Vec::new();
    };
    // The equations do not need what the bodies take from the item.
    let mut all = system.needs();
    all.extend(needed_by(
        &system.definition,
        formulas_of_bodies(&system.definition),
    ));
    let unknown: Vec<GraphError> = all
        .iter()
        .filter_map(|name| unknown(graph, system, name))
        .collect();
    if !unknown.is_empty() {
        return unknown;
    }
    let mut definition = system.definition.clone();
    let names = match put_functions_into(graph, &mut definition, all) {
        Ok(names) => names,
        Err(error) => return vec![GraphError::Compile(error.into())],
    };
    for name in &names {
        let kind = graph.find(name).and_then(|node| graph.kind(node));
        if let Some(dimension) = kind.and_then(Type::dimension) {
            definition.dimensions.insert(name.clone(), dimension);
        }
    }
    match Model::derive(definition) {
        Err(errors) => errors.into_iter().map(GraphError::Model).collect(),
        Ok(model) => {
            graph.set_uses(id, names.into_iter().collect(), Vec::new());
            if let NodeRole::Model(system) = &mut graph.nodes[id.index()].role {
                system.model = Some(Arc::new(model));
            }
            Vec::new()
        }
    }
}

/// A name that a system needs and the item does not have.
fn unknown(graph: &Graph, system: &DeclaredSystem, name: &Name) -> Option<GraphError> {
    if graph.find(name).is_some() {
        return None;
    }
    let mut span = crate::source::Span::NONE;
    let definition = &system.definition;
    for formula in formulas(definition).chain(formulas_of_bodies(definition)) {
        formula.walk(&mut |node| {
            if matches!(node.kind(), Kind::Name(own) if own == name) {
                span = if span.is_none() { node.span() } else { span };
            }
        });
    }
    let known: Vec<&str> = graph
        .names
        .keys()
        .map(Name::as_str)
        .chain(own_names(&system.definition).map(Name::as_str))
        .collect();
    let nearest = nearest(name.as_str(), known).map(str::to_owned);
    Some(GraphError::Check(CheckError::UnknownName {
        name: name.clone(),
        nearest,
        span,
    }))
}

/// Puts quantities that are functions of time or of a coordinate into the formulas of a system that needs these
/// names; the names that it needs then.
fn put_functions_into(
    graph: &Graph,
    definition: &mut Definition,
    mut needed: SortedSet<Name>,
) -> Result<SortedSet<Name>, crate::expr::SymbolicError> {
    // Each round opens one level, and no chain of quantities has more levels than there are quantities.
    for _ in 0..graph.nodes.len() {
        let mut substitution = Substitution::new();
        let mut any = false;
        for name in &needed {
            let Some(id) = graph.find(name).filter(|id| graph.is_function(*id)) else {
                continue;
            };
            if let Some(expr) = graph.expr(id) {
                substitution = substitution.with(name.clone(), expr.clone());
                any = true;
            }
        }
        if !any {
            break;
        }
        for formula in formulas_mut(definition) {
            *formula = substitution.apply(formula)?;
        }
        needed = needs(definition);
    }
    Ok(needed)
}

/// The node of a formula that is a list of a model and nothing else. How long it is depends on the
/// data, so it has no type, and stands in no other formula.
pub(crate) fn list(graph: &mut Graph, expr: &Expr) -> Option<NodeId> {
    let Kind::Path(path) = expr.kind() else {
        return None;
    };
    let id = offer(graph, path).ok()?;
    match &graph.node(id).role {
        NodeRole::Offered(Offered {
            quantity_type: QuantityType::List(_),
            ..
        }) => Some(id),
        _ => None,
    }
}

/// Makes nodes for all quantities of models that a formula asks for.
pub(crate) fn offer_all(graph: &mut Graph, expr: &Expr, names: &Names) -> Vec<GraphError> {
    let mut errors = Vec::new();
    for path in &names.paths {
        if let Err(error) = offer(graph, path) {
            let span = place(expr, path);
            errors.extend(error.map(|error| error.at(span)));
        }
    }
    errors
}

/// The node of a quantity of a model. The error is empty where the model itself is at fault.
fn offer(graph: &mut Graph, path: &Path) -> Result<NodeId, Option<GraphError>> {
    if let Some(id) = graph.paths.get(path) {
        return Ok(*id);
    }
    let system = graph.model_of(path).ok_or_else(|| {
        let nearest =
            nearest(&beginning(path), graph.models.keys().map(AsRef::as_ref)).map(str::to_owned);
        Some(GraphError::Check(CheckError::UnknownPath {
            path: path.clone(),
            nearest,
            span: crate::source::Span::NONE,
        }))
    })?;
    let model = graph
        .system(system)
        .and_then(|own| own.model.clone())
        .ok_or(None)?;
    let quantity = model.quantity(rest(path)).map_err(|error| {
        Some(GraphError::Offer {
            error,
            span: crate::source::Span::NONE,
        })
    })?;
    let quantity_type = QuantityType::of(&model, quantity);
    let kind = match &quantity_type {
        QuantityType::Formula(kind) | QuantityType::Number(kind) => Some(kind.clone()),
        QuantityType::Motion(dimension) => Some(Type::real(*dimension)),
        _ => None,
    };
    let node = GraphNode::new(
        path.to_string().into(),
        NodeRole::Offered(Offered {
            system,
            model,
            quantity,
            quantity_type,
        }),
        kind,
    );
    let id = graph.push(node);
    graph.set_uses(id, Vec::new(), vec![system]);
    graph.paths.insert(path.clone(), id);
    Ok(id)
}

impl GraphError {
    /// The same error at the place where a path stands.
    fn at(self, place: crate::source::Span) -> Self {
        match self {
            Self::Check(CheckError::UnknownPath { path, nearest, .. }) => {
                Self::Check(CheckError::UnknownPath {
                    path,
                    nearest,
                    span: place,
                })
            }
            Self::Offer { error, .. } => Self::Offer { error, span: place },
            other => other,
        }
    }
}

/// `model`, or `models.relative`.
pub(crate) fn beginning(path: &Path) -> String {
    match path.names() {
        [first, second, ..] if first.as_str() == "models" => format!("{first}.{second}"),
        [first, ..] => first.to_string(),
        [] => String::new(),
    }
}

/// What follows the beginning.
pub(crate) fn rest(path: &Path) -> &[Name] {
    let names = path.names();
    let skipped = if names
        .first()
        .is_some_and(|first| first.as_str() == "models")
    {
        2
    } else {
        1
    };
    names.get(skipped..).unwrap_or(&[])
}

/// Where a path stands in a formula.
fn place(expr: &Expr, path: &Path) -> crate::source::Span {
    let mut span = crate::source::Span::NONE;
    expr.walk(&mut |node| {
        if matches!(node.kind(), Kind::Path(own) if own == path) {
            span = node.span();
        }
    });
    span
}
