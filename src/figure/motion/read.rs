//! From the table `[figure.motion]` to a motion.

use super::{Motion, MovedPoint, PointTurn, Spot};
use crate::diagnostic::Finding;
use crate::expr::{Expr, Kind, Name, fold};
use crate::figure::FigureError;
use crate::figure::formula::{Amount, LocalScope};
use crate::figure::read::FigureReader;
use crate::source::{Data, Entry, Span, Table, Text, Value};
use crate::unit::Dimension;

/// Most points that move.
const MAX_COUNT: usize = 100;

/// How the figure moves; read last, so that what it takes from the item is not a demand of the figure itself.
pub(crate) fn motion(figure: &mut FigureReader<'_, '_>) -> Option<Motion> {
    let outer = figure.table;
    let span = outer.value("motion")?.span;
    let table = outer.table("motion")?;
    let names = figure.item.coordinates();
    if names.is_empty() {
        figure.find(&FigureError::NoModel { span });
        return None;
    }
    let before = figure.names.taken().len();
    let lengths = ["scale", "metre"].map(|key| {
        let entry = table.entries().iter().find(|entry| entry.key == key)?;
        let text = table.as_formula(key, &entry.value)?;
        figure.amount(&text)
    });
    let variables = names.iter();
    let coordinates = variables
        .map(|(name, dimension)| figure.names.add_variable(name, *dimension))
        .collect();
    let time = figure.names.add_variable(&Name::new("t"), Dimension::TIME);
    let entries = table.entries().iter();
    let points = entries
        .filter(|entry| !["scale", "metre"].contains(&entry.key.as_str()))
        .take(MAX_COUNT)
        .filter_map(|entry| moved(figure, &table, entry))
        .collect();
    let taken = figure.names.taken().split_off(before);
    let [scale, metre] = lengths;
    Some(Motion {
        coordinates,
        time,
        taken,
        scale,
        metre,
        points,
    })
}

fn moved<'s>(
    figure: &mut FigureReader<'_, 's>,
    table: &Table<'s>,
    entry: &'s Entry,
) -> Option<MovedPoint> {
    let name = entry.name();
    let is_table = matches!(entry.value.data, Data::Table(_));
    let (place, shift, turn, drawn) = if is_table {
        let inner = Table::of(
            table.source(),
            table.problems(),
            "figure.motion",
            &entry.value,
        )?;
        let place = match inner.value("at") {
            Some(value) => figure.pair(&inner, "at", value).map(Spot::Own),
            None => figure.named(&entry.key, &name).map(Spot::Named),
        };
        let shift = inner
            .value("shift")
            .map(|value| shift(figure, &inner, "shift", value));
        let turn = inner.text("turn").map(|text| turn(figure, &inner, &text));
        if shift.is_none() && turn.is_none() {
            inner.wrong::<()>(
                &entry.key,
                "`shift`, `turn` or both, `{ turn = \"theta\" }`",
                &entry.value,
            );
        }
        let drawn = match inner.value("drawn") {
            Some(value) if turn.is_none() => figure.pair(&inner, "drawn", value),
            _ => None,
        };
        inner.finish();
        (place, shift.flatten(), turn.flatten(), drawn)
    } else {
        let place = figure.named(&entry.key, &name).map(Spot::Named);
        (
            place,
            shift(figure, table, &entry.key, &entry.value),
            None,
            None,
        )
    };
    Some(MovedPoint {
        place: place?,
        shift,
        turn,
        drawn,
    })
}

fn shift<'s>(
    figure: &mut FigureReader<'_, 's>,
    table: &Table<'s>,
    key: &str,
    value: &'s Value,
) -> Option<[Amount; 2]> {
    let Data::List(items) = &value.data else {
        return table.wrong(
            key,
            "a shift, `[\"x\", 0]`, or a turn, `{ turn = \"theta\" }`",
            value,
        );
    };
    let [x, y] = items.as_slice() else {
        return table.wrong(key, "a shift to the right and up, `[\"x\", 0]`", value);
    };
    let found = figure.findings.len();
    let shift = [x, y].map(|own| {
        let text = table.as_formula(key, own)?;
        displacement(figure, &text, Dimension::LENGTH)
    });
    let [x, y] = shift;
    let (x, y) = (x?, y?);
    if let (Amount::Fixed(_), Amount::Fixed(_)) = (&x, &y)
        && figure.findings.len() == found
    {
        still(figure, "this shift", value.span);
    }
    Some([x, y])
}

fn turn<'s>(
    figure: &mut FigureReader<'_, 's>,
    table: &Table<'s>,
    text: &Text,
) -> Option<PointTurn> {
    let angle = displacement(figure, text, Dimension::PURE);
    if let Some(Amount::Fixed(_)) = angle {
        still(figure, &text.value, text.span);
    }
    let about = match table.text("about") {
        Some(about) => Some(figure.named(&about.value, &about)?),
        None => None,
    };
    let drawn = table.value("drawn").and_then(|value| {
        let text = table.as_formula("drawn", value)?;
        figure.amount(&text)
    });
    Some(PointTurn {
        angle: angle?,
        about,
        drawn,
    })
}

/// A formula of the coordinates; what no coordinate moves is no displacement.
fn displacement(
    figure: &mut FigureReader<'_, '_>,
    text: &Text,
    wanted: Dimension,
) -> Option<Amount> {
    let expr = match Expr::read(&text.value) {
        Ok(expr) => figure.item.in_coordinates(&expr),
        Err(error) => {
            figure.find_in(&error, text);
            return None;
        }
    };
    if fold(&expr).is_some_and(|value| value.to_f64() == 0.0) {
        return Some(Amount::Fixed(0.0));
    }
    let (source, findings) = (figure.table.source(), &mut figure.findings);
    let local = LocalScope {
        names: &figure.names,
        item: figure.item.scope(),
    };
    let (amount, dimension) = local.measure(&expr, text, &mut |error, text| {
        findings.push(Finding::within(error, source, text));
    })?;
    let mut moves = false;
    let names = figure.item.coordinates();
    expr.walk(&mut |node| {
        moves |= matches!(node.kind(), Kind::Name(name)
            if name.as_str() == "t" || names.iter().any(|(own, _)| own == name));
    });
    if !moves {
        still(figure, &text.value, text.span);
        return None;
    }
    if dimension != wanted {
        let error = FigureError::Displacement {
            found: dimension.describe(),
            is_turn: wanted.is_pure(),
            span: Span::NONE,
        };
        figure.find_in(&error, text);
        return None;
    }
    Some(amount)
}

fn still(figure: &mut FigureReader<'_, '_>, found: &str, span: Span) {
    let names = figure.item.coordinates();
    let known = names.iter().map(|(name, _)| name.to_string());
    let error = FigureError::Still {
        found: found.to_owned(),
        known: known.collect(),
        span,
    };
    figure.find(&error);
}
