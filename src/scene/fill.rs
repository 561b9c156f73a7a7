//! What fills the holes of a text.

use super::notation::{NumberNotation, Symbols};
use super::{Data, Scene};
use super::{concrete, plot, steps};
use crate::bank::{Part, QuantityInfo, Target, Units};
use crate::document::{Filling, Form};
use crate::expr::{Equation, Expr, Field, Kind, Path, Shape, Value};
use crate::figure::Picture;
use crate::math::Math;
use crate::message::{Language, Phrase};
use crate::quantity::NodeId;
use crate::unit::{Decimal, Quantity, Unit};

pub(crate) fn filling(scene: &Scene<'_, '_>, target: &Target, form: Form) -> Filling {
    let mut filling = unworded(scene, target, form);
    if scene.language == Language::English {
        return filling;
    }
    let formulas: Vec<&mut Math> = match &mut filling {
        Filling::Math(math) => vec![math],
        Filling::Steps(steps) => {
            let lines = steps.iter_mut().flat_map(|step| &mut step.lines);
            lines.flatten().collect()
        }
        Filling::Figure(_) => Vec::new(),
    };
    for math in formulas {
        *math = scene.language.formula(math).into_owned();
    }
    filling
}

fn unworded(scene: &Scene<'_, '_>, target: &Target, form: Form) -> Filling {
    match target {
        Target::Node(node) => of_node(scene, *node, form),
        Target::Figure => shown(scene, scene.picture()),
        Target::Free => shown(scene, scene.free_picture().and_then(Result::ok)),
        Target::Mode(number) => shown(scene, scene.mode_picture(*number)),
        Target::Plot(name) => plot::filling(scene, name),
        Target::Model(path) => Filling::Math(offered(scene, path)),
        Target::Derivation(path) => steps::filling(scene, path),
        Target::Nothing => Filling::words("?"),
    }
}

/// A picture, or what it shows in words where nothing is drawn.
fn shown(scene: &Scene<'_, '_>, picture: Option<Picture>) -> Filling {
    match picture {
        Some(picture) if scene.is_drawn => Filling::Figure(picture.svg),
        Some(picture) => Filling::words(scene.language.phrase(&Phrase::Figure(&picture.alt))),
        None => Filling::Figure(String::new()),
    }
}

/// A formula or the equations of a model, in the symbols of the item.
fn offered(scene: &Scene<'_, '_>, path: &Path) -> Math {
    let notation = Symbols(scene.solution);
    let Some((model, quantity)) = scene.solution.template().graph.offered(path) else {
        return nothing();
    };
    if let Ok(formula) = model.formula(quantity) {
        return formula.typeset(&notation);
    }
    let sides = |equation: &Equation| {
        [
            equation.left.typeset(&notation),
            Math::relation("="),
            equation.right.typeset(&notation),
        ]
    };
    match model.equations(quantity).as_deref() {
        Ok([one]) => Math::row(sides(one)),
        Ok(several) => {
            let rows = several.iter().map(|equation| {
                let [left, sign, right] = sides(equation);
                vec![left, Math::row([sign, right])]
            });
            Math::aligned(rows.collect())
        }
        Err(_) => nothing(),
    }
}

fn of_node(scene: &Scene<'_, '_>, node: NodeId, form: Form) -> Filling {
    let Some(info) = scene.solution.template().info(node) else {
        return Filling::words("?");
    };
    let math = match form {
        Form::Name => {
            return Filling::words(info.title.as_deref().unwrap_or(info.name.as_str()));
        }
        Form::Worked => return steps::worked(scene, node, info),
        Form::Symbol => Math::clone(&info.symbol),
        Form::Value => value(scene, node, info),
        Form::Number => number(scene, node, info),
        Form::Unit => unit(info).map_or_else(nothing, |unit| unit.math()),
        Form::Given => given(scene, node, info),
        Form::Formula => formula(scene, node),
        Form::Substituted => substituted(scene, node),
        Form::Equation => {
            let formula = [
                Math::clone(&info.symbol),
                Math::relation("="),
                formula(scene, node),
            ];
            Math::row(
                formula
                    .into_iter()
                    .chain([Math::relation("="), value(scene, node, info)]),
            )
        }
    };
    Filling::Math(math)
}

fn given(scene: &Scene<'_, '_>, node: NodeId, info: &QuantityInfo) -> Math {
    match scene.data {
        Data::Numbers => value(scene, node, info),
        Data::Symbols => Math::clone(&info.symbol),
        Data::Both => Math::row([
            Math::clone(&info.symbol),
            Math::relation("="),
            value(scene, node, info),
        ]),
    }
}

/// The number with its unit; a function of time as its formula with numbers.
pub(crate) fn value(scene: &Scene<'_, '_>, node: NodeId, info: &QuantityInfo) -> Math {
    if let Some(place) = info.parameter {
        return scene.solution.instance().values()[place].math(scene.solution.mark());
    }
    if !scene.solution.template().graph.variables(node).is_empty() {
        return concrete::function(scene.solution, node).unwrap_or_else(nothing);
    }
    match scene.solution.evaluation().value(node) {
        Ok(value) => printed(scene, value, info, true),
        Err(_) => scene.nonexistent(),
    }
}

/// The value of a number in the unit of the part that asks for it, where that is another than its own.
pub(crate) fn value_as_asked(
    scene: &Scene<'_, '_>,
    node: NodeId,
    info: &QuantityInfo,
) -> Option<Math> {
    let template = scene.solution.template();
    let asks = |part: &&Part| match part.answer.keys()[..] {
        [key] if key == node => true,
        [key] => {
            let key = template.graph.expr(key).map(Expr::kind);
            matches!(key, Some(Kind::Name(name)) if *name == info.name)
        }
        _ => false,
    };
    let mut asked = template.parts.iter().filter(asks);
    let unit = asked.find_map(|part| part.answer.unit())?;
    let value = scene.solution.evaluation().value(node).ok()?;
    let is_other = Some(unit) != self::unit(info) && value.shape() == Shape::Scalar;
    is_other.then(|| entry(scene, value, 0, info, Some(unit), Some(unit)))
}

fn number(scene: &Scene<'_, '_>, node: NodeId, info: &QuantityInfo) -> Math {
    if let Some(place) = info.parameter {
        return scene.solution.instance().values()[place]
            .value
            .math(scene.solution.mark());
    }
    match scene.solution.evaluation().value(node) {
        Ok(value) => printed(scene, value, info, false),
        Err(_) => scene.nonexistent(),
    }
}

fn formula(scene: &Scene<'_, '_>, node: NodeId) -> Math {
    let expr = scene.solution.template().graph.expr(node);
    expr.map_or_else(nothing, |expr| expr.typeset(&Symbols(scene.solution)))
}

fn substituted(scene: &Scene<'_, '_>, node: NodeId) -> Math {
    let expr = scene.solution.template().graph.expr(node);
    expr.map_or_else(nothing, |expr| {
        concrete::concrete(scene.solution, expr).typeset(&NumberNotation(scene.solution))
    })
}

/// A value in its units, arranged as it is.
fn printed(scene: &Scene<'_, '_>, value: &Value, info: &QuantityInfo, has_unit: bool) -> Math {
    let common = match &info.units {
        Some(Units::One(unit)) => Some(*unit),
        _ => None,
    };
    let one = match (value.shape(), common) {
        (Shape::Scalar, unit) => unit.or_else(|| entry_unit(info, 0)),
        (_, unit) => unit,
    };
    let body = match value.shape() {
        Shape::Scalar => return entry(scene, value, 0, info, one.filter(|_| has_unit), one),
        Shape::Vector(length) => {
            let entries = (0..length).map(|at| cell(scene, value, at, info, one));
            let list = separated(entries);
            if length == 1 {
                list
            } else {
                list.in_parentheses()
            }
        }
        Shape::Matrix(rows, columns) => Math::matrix(
            (0..rows)
                .map(|row| {
                    (0..columns)
                        .map(|column| cell(scene, value, row * columns + column, info, one))
                        .collect()
                })
                .collect(),
        ),
    };
    match one.filter(|unit| has_unit && !unit.is_one()) {
        Some(unit) => Math::row([body, Math::thin_space(), unit.math()]),
        None => body,
    }
}

/// An entry of a vector or matrix: without unit if one serves for all.
fn cell(
    scene: &Scene<'_, '_>,
    value: &Value,
    at: usize,
    info: &QuantityInfo,
    common: Option<Unit>,
) -> Math {
    let own = entry_unit(info, at);
    entry(
        scene,
        value,
        at,
        info,
        own.filter(|_| common.is_none()),
        common.or(own),
    )
}

/// One number: rounded in `unit`, printed with the unit `shown`.
fn entry(
    scene: &Scene<'_, '_>,
    value: &Value,
    at: usize,
    info: &QuantityInfo,
    shown: Option<Unit>,
    unit: Option<Unit>,
) -> Math {
    let entry = value.entry(at);
    let unit = unit.unwrap_or(Unit::ONE);
    let real = |number: f64| {
        Decimal::rounded(unit.of_si(number), u32::from(info.digits)).unwrap_or(Decimal::ZERO)
    };
    let mark = scene.solution.mark();
    // A count is printed as one: 3 coils, not 3.00.
    let is_whole = info
        .units
        .as_ref()
        .is_some_and(|units| matches!(units, Units::One(unit) if unit.is_one()))
        && entry.im == 0.0
        && entry.re == entry.re.round()
        && entry.re.abs() < 1e6;
    if value.form().field == Field::Complex {
        let (re, im) = (real(entry.re), real(entry.im));
        let is_sum = entry.re != 0.0 || entry.im == 0.0;
        let real = is_sum.then(|| re.math(mark));
        let body = Math::complex(real, im.is_negative(), im.abs().math(mark));
        let Some(unit) = shown.filter(|unit| !unit.is_one()) else {
            return body;
        };
        let body = if is_sum { body.in_parentheses() } else { body };
        return Math::row([body, Math::thin_space(), unit.math()]);
    }
    let number = if is_whole {
        Decimal::shortest(entry.re).unwrap_or(Decimal::ZERO)
    } else {
        real(entry.re)
    };
    Quantity::new(number, shown.unwrap_or(Unit::ONE)).math(mark)
}

fn unit(info: &QuantityInfo) -> Option<Unit> {
    match info.units.as_ref()? {
        Units::One(unit) => Some(*unit),
        Units::Each(_) => None,
    }
}

fn separated(entries: impl Iterator<Item = Math>) -> Math {
    let mut row = Vec::new();
    for entry in entries {
        if !row.is_empty() {
            row.push(Math::punctuation(","));
        }
        row.push(entry);
    }
    Math::row(row)
}

/// No formula.
fn nothing() -> Math {
    Math::Row(Vec::new())
}

/// The unit in which one component is declared.
fn entry_unit(info: &QuantityInfo, at: usize) -> Option<Unit> {
    match info.units.as_ref()? {
        Units::One(unit) => Some(*unit),
        Units::Each(units) => units.get(at).copied(),
    }
}
