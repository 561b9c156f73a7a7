//! The tables of plots: variable, curves, marks; the mode shapes of a model.

use super::{ItemError, ItemReader, figure::ItemNames, parts, phasors};
use crate::bank::plot::{Abscissa, Curve, Curves, Mark, ModeShapes, Ordinate, Plot, PlotKind};
use crate::bank::template::Units;
use crate::expr::{Constant, Expr, Kind, Name, Path, Shape, Type};
use crate::figure::plot::CurveStyle;
use crate::math::Math;
use crate::quantity::NodeId;
use crate::source::{Data, Entry, Table, Text, Value};
use crate::unit::{Dimension, Unit};

/// No plot has more curves, or more marks.
const MAX_CURVES: usize = 12;

/// The variable of a plot while it is read.
struct Variable {
    name: Name,
    kind: Type,
}

/// The plots of the item. The names of all of them are known before the first text is read.
pub(crate) fn read<'s>(reader: &mut ItemReader<'s>, table: &Table<'s>) -> Vec<Plot> {
    let Some(plots) = table.table("plots") else {
        return Vec::new();
    };
    plots
        .entries()
        .iter()
        .filter_map(|entry| plot(reader, &plots, entry))
        .collect()
}

fn plot<'s>(reader: &mut ItemReader<'s>, plots: &Table<'s>, entry: &'s Entry) -> Option<Plot> {
    let name = format!("plots.{}", entry.key);
    let table = Table::of(plots.source(), plots.problems(), &name, &entry.value)?;
    let kind = table.text("kind");
    let kind = match kind.as_ref().map_or("curves", |kind| kind.value.as_str()) {
        "curves" => curves(reader, &table, false).map(PlotKind::Curves),
        "phase-plane" => curves(reader, &table, true).map(PlotKind::PhasePlane),
        "mode-shapes" => mode_shapes(reader, &table).map(PlotKind::ModeShapes),
        "phasors" => phasors::read(reader, &table).map(PlotKind::Phasors),
        other => {
            let found = other.to_owned();
            reader.find(&ItemError::PlotKind { found }, &kind.clone()?);
            return None;
        }
    };
    table.finish();
    let name = entry.key.clone();
    kind.map(|kind| Plot { name, kind })
}

fn curves<'s>(
    reader: &mut ItemReader<'s>,
    table: &Table<'s>,
    is_phase_plane: bool,
) -> Option<Curves> {
    let x = table.required_table("x");
    let y = table.table("y");
    let items = table.required("curves");
    let marks = table.tables("marks");
    let (variable, x) = abscissa(reader, table.name(), &x?)?;
    let unit = y.as_ref().and_then(|y| y.text("unit"));
    let unit = unit.and_then(|unit| reader.unit(&unit).map(|read| (read, unit)));
    let mut curves = Vec::new();
    for item in few(reader, table, "curves", items?) {
        let inner = Table::of(table.source(), table.problems(), "curves", item);
        let read = inner.and_then(|inner| {
            curve(
                reader,
                table.name(),
                inner,
                (&variable, &x.unit),
                is_phase_plane,
            )
        });
        curves.extend(read);
    }
    let unit = ordinate_unit(reader, &curves, unit, &variable)?;
    let curves = curves.into_iter().map(|(curve, _)| curve).collect();
    let y = ordinate(reader, table.name(), y, unit, is_phase_plane, &x.unit);
    let across = if is_phase_plane { y.unit } else { x.unit };
    let up = if is_phase_plane { y.rate_unit } else { y.unit };
    let marks = marks
        .into_iter()
        .take(MAX_CURVES)
        .filter_map(|own| mark(reader, table.name(), own, &[across, up]))
        .collect();
    Some(Curves {
        x,
        y,
        curves,
        marks,
    })
}

/// The items of an array that has few of them.
pub(crate) fn few<'s>(
    reader: &mut ItemReader<'s>,
    table: &Table<'s>,
    key: &'static str,
    value: &'s Value,
) -> &'s [Value] {
    let items = table.items(key, value);
    if items.is_empty() || items.len() > MAX_CURVES {
        let error = ItemError::CurveCount {
            found: items.len(),
            most: MAX_CURVES,
        };
        reader.find(&error, &place(value));
    }
    &items[..items.len().min(MAX_CURVES)]
}

fn abscissa<'s>(
    reader: &mut ItemReader<'s>,
    plot: &str,
    table: &Table<'s>,
) -> Option<(Variable, Abscissa)> {
    let name = table.required_text("variable");
    let range = table.required("range");
    let unit = table.text("unit");
    let label = table.text("label");
    let ticks = table
        .value("ticks")
        .and_then(|ticks| table.as_formula("ticks", ticks));
    let is_logarithmic = table.boolean("log").unwrap_or(false);
    let range = range.and_then(|range| ends(reader, plot, table, "range", range));
    table.finish_ref();
    let name = name?;
    let name = variable(reader, &name)?;
    let (range, _) = range?;
    let dimension = dimension_of(reader, &range);
    let unit = unit.map(|text| reader.unit(&text).map(|unit| (unit, text)));
    let unit = match unit {
        Some(Some((unit, text))) => {
            hold(reader, &unit, dimension, &text);
            unit
        }
        Some(None) => return None,
        None => unit_of_name(reader, &name, dimension),
    };
    let label = match &label {
        Some(label) => label_of(reader, label),
        None => ItemNames::of(reader).symbol(&name),
    };
    let ticks = ticks.and_then(|text| tick_distance(reader, plot, &text, &unit));
    let kind = Type::real(unit.dimension());
    let abscissa = Abscissa {
        range,
        unit,
        label,
        ticks,
        is_logarithmic,
    };
    Some((Variable { name, kind }, abscissa))
}

/// The name of a variable: any, also one that the item has.
fn variable(reader: &mut ItemReader<'_>, text: &Text) -> Option<Name> {
    if text.value == "t" {
        return Some(Name::new("t"));
    }
    reader.name(&text.value, text.span)
}

/// Two formulas for numbers of one dimension.
fn ends<'s>(
    reader: &mut ItemReader<'s>,
    plot: &str,
    table: &Table<'s>,
    key: &'static str,
    value: &'s Value,
) -> Option<([NodeId; 2], Text)> {
    let items = table.items(key, value);
    let [from, to] = items else {
        reader.find(&ItemError::PlotPair, &place(value));
        return None;
    };
    let mut end = |name: &str, value: &'s Value| {
        let text = table.as_formula(key, value)?;
        number(reader, &format!("{plot}: {name}"), &text)
    };
    let (from, to) = (end("from", from), end("to", to));
    Some(([from?, to?], place(value)))
}

/// A formula that is one real number for given data.
fn number(reader: &mut ItemReader<'_>, label: &str, text: &Text) -> Option<NodeId> {
    let node = reader.formula(label, text)?;
    real(reader, node, text)?;
    let variables = reader.graph.variables(node);
    if let Some(of) = variables.first() {
        let of = of.to_string();
        reader.find(&ItemError::PlotVariable { of }, text);
        return None;
    }
    Some(node)
}

/// A finding unless a formula is a real number.
fn real(reader: &mut ItemReader<'_>, node: NodeId, text: &Text) -> Option<()> {
    let is_real = reader
        .graph
        .kind(node)
        .is_some_and(|kind| kind.form() == crate::expr::Form::REAL);
    if !is_real {
        reader.find(&ItemError::PlotValue, text);
    }
    is_real.then_some(())
}

pub(crate) fn dimension_of(reader: &ItemReader<'_>, nodes: &[NodeId]) -> Option<Dimension> {
    nodes
        .iter()
        .find_map(|node| reader.graph.kind(*node).and_then(Type::dimension))
}

/// The unit in which a name is declared, if it has this dimension; else the coherent unit.
fn unit_of_name(reader: &ItemReader<'_>, name: &Name, dimension: Option<Dimension>) -> Unit {
    let node = reader.graph.find(name);
    let info = node.and_then(|node| reader.quantities.get(&node));
    let declared = match info.and_then(|info| info.units.as_ref()) {
        Some(Units::One(unit)) => Some(*unit),
        _ => None,
    };
    declared
        .filter(|unit| dimension.is_none_or(|dimension| unit.dimension() == dimension))
        .unwrap_or_else(|| coherent(dimension))
}

/// The distance of ticks; a share of π gives labels that are shares of π.
fn tick_distance(
    reader: &mut ItemReader<'_>,
    plot: &str,
    text: &Text,
    unit: &Unit,
) -> Option<(NodeId, bool)> {
    let node = number(reader, &format!("{plot}: ticks"), text)?;
    let dimension = dimension_of(reader, &[node]);
    hold(reader, unit, dimension, text);
    let mut is_share = false;
    Expr::read(&text.value).ok()?.walk(&mut |node| {
        is_share |= matches!(node.kind(), Kind::Constant(Constant::Pi));
    });
    Some((node, is_share))
}

/// A finding unless a unit has this dimension; zero has every dimension.
pub(crate) fn hold(
    reader: &mut ItemReader<'_>,
    unit: &Unit,
    dimension: Option<Dimension>,
    text: &Text,
) {
    if let Some(found) = dimension.filter(|found| *found != unit.dimension()) {
        let error = ItemError::PlotUnit {
            unit: unit.to_string(),
            found: found.describe(),
        };
        reader.find(&error, text);
    }
}

/// A curve, and the text of its formula.
fn curve<'s>(
    reader: &mut ItemReader<'s>,
    plot: &str,
    table: Table<'s>,
    (variable, unit): (&Variable, &Unit),
    is_phase_plane: bool,
) -> Option<(Curve, Text)> {
    let y = table.required("y").and_then(|y| table.as_formula("y", y));
    let label = table.text("label").map(|label| label_of(reader, &label));
    let style = style(reader, &table);
    let with = table.table("with");
    let with = with.map_or(Vec::new(), |with| parts::replacements(reader, &with));
    let range = table.value("range");
    let range = range.and_then(|value| ends(reader, plot, &table, "range", value));
    if let Some((ends, place)) = &range {
        let dimension = dimension_of(reader, ends);
        hold(reader, unit, dimension, place);
    }
    table.finish();
    let text = y?;
    let expr = reader.expr(&text)?;
    let node = over(
        reader,
        &format!("{plot}: curve"),
        expr.clone(),
        &text,
        variable,
    )?;
    let is_band = style == CurveStyle::Band && !is_phase_plane;
    let shape = reader.graph.kind(node)?.shape();
    if is_band && shape != Shape::Vector(2) {
        reader.find(&ItemError::PlotBand, &text);
        return None;
    }
    if !is_band {
        real(reader, node, &text)?;
    }
    let rate = if is_phase_plane {
        let rate = Expr::derived(Kind::Diff(expr, vec![variable.name.clone()]));
        Some(over(
            reader,
            &format!("{plot}: rate"),
            rate,
            &text,
            variable,
        )?)
    } else {
        None
    };
    let curve = Curve {
        y: node,
        rate,
        label,
        style,
        with,
        range: range.map(|(ends, _)| ends),
    };
    Some((curve, text))
}

/// How a curve or phasor is drawn.
pub(crate) fn style<'s>(reader: &mut ItemReader<'s>, table: &Table<'s>) -> CurveStyle {
    let Some(text) = table.text("style") else {
        return CurveStyle::Auto;
    };
    CurveStyle::of_name(&text.value).unwrap_or_else(|| {
        let found = text.value.clone();
        reader.find(&ItemError::PlotStyle { found }, &text);
        CurveStyle::Auto
    })
}

/// A formula over the variable of the plot.
fn over(
    reader: &mut ItemReader<'_>,
    label: &str,
    expr: Expr,
    text: &Text,
    variable: &Variable,
) -> Option<NodeId> {
    let kind = variable.kind.clone();
    let node = match reader.graph.formula_over(label, expr, &variable.name, kind) {
        Ok(node) => node,
        Err(errors) => {
            errors.iter().for_each(|error| reader.find(error, text));
            return None;
        }
    };
    let names = reader.graph.variables(node);
    if let [_, other, ..] = names.as_slice() {
        let of = if *other == variable.name {
            &names[0]
        } else {
            other
        };
        let of = of.to_string();
        reader.find(&ItemError::PlotVariable { of }, text);
        return None;
    }
    if let [only] = names.as_slice()
        && reader.graph.find(&variable.name).is_none()
        && *only != variable.name
    {
        let of = only.to_string();
        reader.find(&ItemError::PlotVariable { of }, text);
        return None;
    }
    Some(node)
}

/// The unit of the values: what is written, else that of the first curve; all curves agree with it.
fn ordinate_unit(
    reader: &mut ItemReader<'_>,
    curves: &[(Curve, Text)],
    written: Option<(Unit, Text)>,
    variable: &Variable,
) -> Option<Unit> {
    let unit = match &written {
        Some((unit, _)) => *unit,
        None => {
            let (first, text) = curves.first()?;
            let found = dimension_of_curve(reader, first);
            let name = Name::new(text.value.trim());
            let is_variable = name == variable.name;
            if is_variable {
                coherent(found)
            } else {
                unit_of_name(reader, &name, found)
            }
        }
    };
    for (curve, text) in curves {
        let found = dimension_of_curve(reader, curve);
        hold(reader, &unit, found, text);
    }
    Some(unit)
}

/// The dimension of the values of a curve.
fn dimension_of_curve(reader: &ItemReader<'_>, curve: &Curve) -> Option<Dimension> {
    reader.graph.kind(curve.y)?.entries().flatten().next()
}

fn ordinate<'s>(
    reader: &mut ItemReader<'s>,
    plot: &str,
    table: Option<Table<'s>>,
    unit: Unit,
    is_phase_plane: bool,
    variable: &Unit,
) -> Ordinate {
    let mut ordinate = Ordinate {
        unit,
        rate_unit: unit,
        label: None,
        range: None,
        is_logarithmic: false,
    };
    if is_phase_plane {
        let per = variable.pow(crate::unit::Rational::integer(-1));
        let rate = per.and_then(|per| unit.times(&per));
        ordinate.rate_unit = rate.unwrap_or(unit);
    }
    let Some(table) = table else {
        return ordinate;
    };
    ordinate.label = table.text("label").map(|label| label_of(reader, &label));
    ordinate.is_logarithmic = table.boolean("log").unwrap_or(false);
    if let Some(value) = table.value("range") {
        let ends = ends(reader, plot, &table, "range", value);
        if let Some((ends, place)) = ends {
            let dimension = dimension_of(reader, &ends);
            hold(reader, &unit, dimension, &place);
            ordinate.range = Some(ends);
        }
    }
    table.finish();
    ordinate
}

fn mark<'s>(
    reader: &mut ItemReader<'s>,
    plot: &str,
    table: Table<'s>,
    units: &[Unit; 2],
) -> Option<Mark> {
    let at = table.required("at");
    let label = table.text("label").map(|label| label_of(reader, &label));
    table.finish();
    let value = at?;
    let [across, up] = table_pair(reader, value)?;
    let mut coordinate = |value: &'s Value, unit: Unit| {
        let Data::Text(text) = &value.data else {
            let found = place(value);
            reader.find(&ItemError::PlotValue, &found);
            return None;
        };
        let text = Text {
            value: text.clone(),
            span: value.span,
        };
        let node = number(reader, &format!("{plot}: mark"), &text)?;
        let dimension = dimension_of(reader, &[node]);
        hold(reader, &unit, dimension, &text);
        Some(node)
    };
    let (across, up) = (coordinate(across, units[0]), coordinate(up, units[1]));
    Some(Mark {
        at: [across?, up?],
        label,
    })
}

fn mode_shapes<'s>(reader: &mut ItemReader<'s>, table: &Table<'s>) -> Option<ModeShapes> {
    let model = table.text("model");
    let beginning = model.as_ref().map_or("model", |text| text.value.as_str());
    let text = model.clone().unwrap_or(Text {
        value: String::new(),
        span: table.span(),
    });
    let Some(derived) = reader.graph.derived(beginning) else {
        let found = beginning.to_owned();
        reader.find(&ItemError::PlotModel { found }, &text);
        return None;
    };
    let names: Vec<Name> = derived.coordinates().to_vec();
    let mut offered = |quantity: &str| {
        let path = beginning.split('.').chain([quantity]).map(Name::new);
        let expr = Expr::derived(Kind::Path(Path::new(path.collect::<Vec<_>>())));
        let label = format!("{}: {quantity}", table.name());
        match reader.graph.formula(label, expr) {
            Ok(node) => Some(node),
            Err(errors) => {
                errors.iter().for_each(|error| reader.find(error, &text));
                None
            }
        }
    };
    let shapes = offered("mode_shapes");
    let frequencies = offered("natural_angular_frequencies");
    let masses = offered("M");
    let shapes = shapes?;
    let kind = reader.graph.kind(shapes)?.clone();
    let first = kind.entry(0);
    let units = (0..names.len()).map(|column| {
        let ratio = kind
            .entry(column)
            .zip(first)
            .map(|(own, first)| own / first);
        coherent(ratio)
    });
    let units: Vec<Unit> = units.collect();
    let is_uniform = units.iter().all(|unit| unit.dimension().is_pure());
    Some(ModeShapes {
        shapes,
        frequencies: frequencies?,
        masses: masses.filter(|_| !is_uniform),
        coordinates: names
            .iter()
            .map(|name| coordinate_symbol(reader, name))
            .collect(),
        units,
    })
}

/// The symbol of a coordinate, also where a quantity bears its name.
fn coordinate_symbol(reader: &ItemReader<'_>, name: &Name) -> Math {
    let known = reader.free.iter().find(|known| known.name == *name);
    known.map_or_else(
        || crate::math::symbol(name.as_str()),
        |known| Math::clone(&known.symbol),
    )
}

/// What stands at a curve, mark or axis.
pub(crate) fn label_of(reader: &mut ItemReader<'_>, text: &Text) -> Math {
    let mut errors = Vec::new();
    let label = reader.texts.label(text, &mut errors);
    for error in &errors {
        reader.find(&**error, text);
    }
    label.unwrap_or_else(|| Math::text("?"))
}

fn table_pair<'s>(reader: &mut ItemReader<'s>, value: &'s Value) -> Option<[&'s Value; 2]> {
    match &value.data {
        Data::List(items) if items.len() == 2 => Some([&items[0], &items[1]]),
        _ => {
            reader.find(&ItemError::PlotPair, &place(value));
            None
        }
    }
}

/// A value as a place to point at.
fn place(value: &Value) -> Text {
    Text {
        value: String::new(),
        span: value.span,
    }
}

/// The coherent unit of a dimension.
pub(crate) fn coherent(dimension: Option<Dimension>) -> Unit {
    dimension
        .and_then(|dimension| Unit::parse(&dimension.describe()).ok())
        .unwrap_or(Unit::ONE)
}
