//! The tables of models: energies, dissipation, forces, friction, initial state.

use super::{ItemReader, quantities};
use crate::answer::Role;
use crate::diagnostic::Finding;
use crate::expr::{Expr, Name};
use crate::mechanics::{Body, Coordinate, Definition, Friction, Initial};
use crate::quantity::NodeId;
use crate::source::{Data, Entry, Span, Table, Value};

/// The keys of a model that `like` may take over.
const FORMULAS: [&str; 3] = ["kinetic", "potential", "dissipation"];

/// The keys on which the motion of a model depends.
const OF_THE_MOTION: [&str; 7] = [
    "coordinates",
    "kinematics",
    "kinetic",
    "potential",
    "dissipation",
    "forces",
    "friction",
];

/// A model as declared, until all names are known.
pub(crate) struct Declared {
    pub(crate) node: NodeId,
    span: Span,
}

/// All models of an item.
pub(crate) fn read<'s>(reader: &mut ItemReader<'s>, table: &Table<'s>) -> Vec<Declared> {
    let main = table.table("model");
    let mut declared = Vec::new();
    if let Some(model) = &main {
        let definition = definition(reader, model, None);
        declared.push(Declared {
            node: reader.graph.model("model", definition),
            span: model.span(),
        });
    }
    if let Some(models) = table.table("models") {
        for entry in models.entries() {
            let name = format!("models.{}", entry.key);
            let Some(model) = Table::of(models.source(), models.problems(), &name, &entry.value)
            else {
                continue;
            };
            let like = model
                .text("like")
                .filter(|like| like.value == "model")
                .and(main.as_ref());
            let definition = definition(reader, &model, like);
            declared.push(Declared {
                node: reader.graph.model(&name, definition),
                span: model.span(),
            });
            model.finish();
        }
    }
    if let Some(model) = main {
        model.finish();
    }
    declared
}

/// The definition in a table; what it does not say is taken from `like`.
fn definition<'s>(
    reader: &mut ItemReader<'s>,
    table: &Table<'s>,
    like: Option<&Table<'s>>,
) -> Definition {
    let from = |key: &'static str| {
        if table.has(key) {
            Some(table)
        } else {
            like.filter(|like| like.has(key))
        }
    };
    let mut definition = Definition::default();
    if like.is_none() {
        table.required("coordinates");
        table.required("kinetic");
    }
    if let Some(coordinates) = from("coordinates").and_then(|own| own.table("coordinates")) {
        definition.coordinates = coordinates
            .entries()
            .iter()
            .filter_map(|entry| coordinate(reader, &coordinates, entry))
            .collect();
    }
    for key in FORMULAS {
        let Some(formula) = from(key).and_then(|own| located(reader, own, key, own.value(key)?))
        else {
            continue;
        };
        match key {
            "kinetic" => definition.kinetic = formula,
            "potential" => definition.potential = formula,
            _ => definition.dissipation = formula,
        }
    }
    definition.kinematics = by_name(reader, from("kinematics"), "kinematics");
    definition.forces = by_name(reader, from("forces"), "forces");
    definition.equilibrium = by_name(reader, from("equilibrium"), "equilibrium");
    // Bodies are laws of the same motion: another energy makes them those of another system.
    let is_other = OF_THE_MOTION.iter().any(|key| table.has(key));
    let own = Some(table).filter(|own| own.has("bodies"));
    let own = own.or(like.filter(|like| !is_other && like.has("bodies")));
    definition.bodies = bodies(reader, own);
    definition.friction = frictions(reader, from("friction"));
    definition.initial = initials(reader, from("initial"));
    definition
}

/// A coordinate; its name is free in all formulas of the item that have no quantity of the same name.
fn coordinate<'s>(
    reader: &mut ItemReader<'s>,
    table: &Table<'s>,
    entry: &'s Entry,
) -> Option<Coordinate> {
    let name = reader.name(&entry.key, entry.span)?;
    let mut symbol = None;
    let unit = match &entry.value.data {
        Data::Table(_) => {
            let inner = Table::of(table.source(), table.problems(), &entry.key, &entry.value)?;
            let unit = inner.required_text("unit");
            symbol = inner.text("symbol");
            inner.text("name");
            inner.finish();
            unit
        }
        _ => table.as_text(&entry.key, &entry.value),
    };
    let unit = unit.and_then(|text| reader.unit(&text))?;
    quantities::know(
        reader,
        name.clone(),
        unit,
        symbol.as_ref(),
        Role::Coordinate,
        entry.span,
    );
    let is_angle = unit.dimension().is_pure() && !unit.is_one();
    Some(Coordinate {
        is_angle,
        span: entry.span,
        ..Coordinate::new(name, unit.dimension())
    })
}

fn by_name<'s>(
    reader: &mut ItemReader<'s>,
    table: Option<&Table<'s>>,
    key: &'static str,
) -> Vec<(Name, Expr)> {
    let Some(own) = table.and_then(|table| table.table(key)) else {
        return Vec::new();
    };
    own.entries()
        .iter()
        .filter_map(|entry| {
            Some((
                Name::new(entry.key.as_str()),
                located(reader, &own, &entry.key, &entry.value)?,
            ))
        })
        .collect()
}

/// The bodies, each with its moves and the mass or moment of inertia that belongs to each.
fn bodies<'s>(reader: &mut ItemReader<'s>, table: Option<&Table<'s>>) -> Vec<Body> {
    let Some(own) = table.and_then(|table| table.table("bodies")) else {
        return Vec::new();
    };
    let mut bodies = Vec::new();
    for entry in own.entries() {
        let table = Table::of(own.source(), own.problems(), &entry.key, &entry.value);
        if let Some(table) = table {
            bodies.extend(body(reader, &table, entry));
            table.finish();
        }
    }
    bodies
}

fn body<'s>(reader: &mut ItemReader<'s>, table: &Table<'s>, entry: &'s Entry) -> Option<Body> {
    let mut inertia = |key: &'static str| {
        let value = table.value(key)?;
        located(reader, table, key, value)
    };
    let (mass, moment) = (inertia("mass"), inertia("inertia"));
    let value = table.required("moves")?;
    let names: Vec<Name> = match &value.data {
        Data::List(items) => items
            .iter()
            .filter_map(|item| table.as_text("moves", item))
            .map(|text| Name::new(text.value.as_str()))
            .collect(),
        _ => vec![Name::new(table.as_text("moves", value)?.value.as_str())],
    };
    let last = names.len().saturating_sub(1);
    // With a mass and a moment of inertia the last of several moves is the turn.
    let of = |at: usize| match (&mass, &moment) {
        (Some(_), Some(moment)) if at == last && last > 0 => Some(moment.clone()),
        (Some(mass), None) => Some(mass.clone()),
        (Some(mass), Some(_)) if at < last => Some(mass.clone()),
        (None, Some(moment)) if last == 0 => Some(moment.clone()),
        _ => None,
    };
    let moves = names
        .iter()
        .enumerate()
        .map(|(at, name)| Some((name.clone(), of(at)?)));
    let Some(moves) = moves
        .collect::<Option<Vec<_>>>()
        .filter(|moves| !moves.is_empty())
    else {
        return table.wrong(
            "moves",
            "one move with `mass` or `inertia`, several with `mass`, or several with both, the turn last",
            value,
        );
    };
    Some(Body {
        name: Name::new(entry.key.as_str()),
        forces: forces_of_body(reader, table, moves.len()),
        unknowns: table
            .value("unknowns")
            .map(|value| table.items("unknowns", value))
            .unwrap_or_default()
            .iter()
            .filter_map(|item| table.as_text("unknowns", item))
            .map(|text| Name::new(text.value.as_str()))
            .collect(),
        moves,
        span: entry.span,
    })
}

/// The forces on a body: one formula, or one for each of its moves.
fn forces_of_body<'s>(
    reader: &mut ItemReader<'s>,
    table: &Table<'s>,
    moves: usize,
) -> Vec<(Name, Vec<Expr>)> {
    let Some(own) = table.table("forces") else {
        return Vec::new();
    };
    let mut forces = Vec::new();
    for entry in own.entries() {
        let name = Name::new(entry.key.as_str());
        let components: Option<Vec<Expr>> = match &entry.value.data {
            Data::List(items) if items.len() == moves => items
                .iter()
                .map(|item| located(reader, &own, &entry.key, item))
                .collect(),
            Data::List(_) => own.wrong(&entry.key, "a component for each move", &entry.value),
            _ if moves == 1 => {
                located(reader, &own, &entry.key, &entry.value).map(|force| vec![force])
            }
            _ => own.wrong(
                &entry.key,
                "a list with a component for each move",
                &entry.value,
            ),
        };
        forces.extend(components.map(|components| (name, components)));
    }
    forces
}

fn frictions<'s>(reader: &mut ItemReader<'s>, table: Option<&Table<'s>>) -> Vec<(Name, Friction)> {
    let Some(own) = table.and_then(|table| table.table("friction")) else {
        return Vec::new();
    };
    let mut frictions = Vec::new();
    for entry in own.entries() {
        let friction = if let Data::Table(_) = entry.value.data {
            let Some(inner) = Table::of(own.source(), own.problems(), &entry.key, &entry.value)
            else {
                continue;
            };
            let kinetic = inner
                .required("kinetic")
                .and_then(|value| located(reader, &inner, "kinetic", value));
            let holding = inner
                .value("static")
                .and_then(|value| located(reader, &inner, "static", value));
            inner.finish();
            kinetic.map(|kinetic| Friction { kinetic, holding })
        } else {
            let kinetic = located(reader, &own, &entry.key, &entry.value);
            kinetic.map(|kinetic| Friction {
                kinetic,
                holding: None,
            })
        };
        frictions.extend(friction.map(|friction| (Name::new(entry.key.as_str()), friction)));
    }
    frictions
}

fn initials<'s>(reader: &mut ItemReader<'s>, table: Option<&Table<'s>>) -> Vec<(Name, Initial)> {
    let Some(own) = table.and_then(|table| table.table("initial")) else {
        return Vec::new();
    };
    let mut initials = Vec::new();
    for entry in own.entries() {
        let initial = match &entry.value.data {
            Data::List(items) if items.len() == 2 => {
                let position = located(reader, &own, &entry.key, &items[0]);
                let velocity = located(reader, &own, &entry.key, &items[1]);
                position.zip(velocity)
            }
            Data::List(_) => own.wrong(
                &entry.key,
                "a position, or position and velocity",
                &entry.value,
            ),
            _ => located(reader, &own, &entry.key, &entry.value)
                .map(|position| (position, Expr::number(0))),
        };
        let initial = initial.map(|(position, velocity)| Initial { position, velocity });
        initials.extend(initial.map(|initial| (Name::new(entry.key.as_str()), initial)));
    }
    initials
}

/// A formula whose nodes know their places in the file.
fn located<'s>(
    reader: &mut ItemReader<'s>,
    table: &Table<'s>,
    key: &str,
    value: &'s Value,
) -> Option<Expr> {
    let text = table.as_formula(key, value)?;
    let expr = reader.expr(&text)?;
    Some(moved(&expr, &|span| reader.source.place(&text, span)))
}

/// Notes a finding about a model; its places count in the file.
pub(crate) fn find_in_model(
    reader: &mut ItemReader<'_>,
    error: &impl crate::diagnostic::Diagnose,
    model: &Declared,
) {
    let mut finding = Finding::of(error, reader.source);
    for label in finding
        .labels
        .iter_mut()
        .filter(|label| label.span.is_none())
    {
        label.span = model.span;
    }
    reader.findings.push(finding);
}

/// The same formula with its places mapped. Formulas that were read have a bounded depth.
fn moved(expr: &Expr, place: &impl Fn(Span) -> Span) -> Expr {
    let same =
        expr.try_map_children::<std::convert::Infallible>(&mut |child| Ok(moved(child, place)));
    let Ok(same) = same;
    Expr::new(
        same.kind().clone(),
        if expr.span().is_none() {
            Span::NONE
        } else {
            place(expr.span())
        },
    )
}
