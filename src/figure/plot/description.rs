//! What a plot shows, in words.

use std::fmt::Write as _;

use super::course::Line;
use super::sample::cubic;
use super::{Axis, Plot, Style};
use crate::math::Math;
use crate::unit::{Decimal, DecimalMark, Quantity, Unit};

/// Share of a curve's extent from which a turn counts.
const TURN: f64 = 0.02;
/// Points that stand for a cubic piece.
const POINTS: usize = 4;

/// `x(t) against t`.
pub(crate) fn title(plot: &Plot<'_>, up: &Math) -> String {
    let (up, across) = (name(up), name(&plot.x.label));
    match (up.is_empty(), across.is_empty()) {
        (false, false) => format!("{up} against {across}"),
        (false, true) => up,
        (true, false) => format!("Plot against {across}"),
        (true, true) => "Plot".to_owned(),
    }
}

/// Axes, curves and marks, one sentence each.
pub(crate) fn of(plot: &Plot<'_>, lines: &[Line], up: &Math) -> String {
    let mark = plot.decimal;
    let title = title(plot, up);
    let range = if lines.is_empty() {
        None
    } else {
        plot.x.range.or(Some(plot.range))
    };
    let mut text = title;
    let is_plane = plot
        .curves
        .iter()
        .any(|curve| matches!(curve.course, super::Course::Path(_)));
    if let Some([from, to]) = range.filter(|_| !is_plane) {
        let (from, to) = (number(from, Unit::ONE, mark), number(to, plot.x.unit, mark));
        let _ = write!(text, ", from {from} to {to}");
    }
    if plot.x.is_logarithmic {
        text += " (logarithmic)";
    }
    text.push('.');
    for line in lines {
        text += &curve(plot, line, is_plane);
    }
    for point in &plot.marks {
        let label = point.label.as_ref().map(name).unwrap_or_default();
        let at = [
            number(point.at[0], plot.x.unit, mark),
            number(point.at[1], plot.y.unit, mark),
        ];
        let comma = if label.is_empty() { "" } else { ", " };
        let _ = write!(text, " Marked{comma}{label}: {}, {}.", at[0], at[1]);
    }
    text
}

/// A symbol or words as they are spoken of in running text.
fn name(math: &Math) -> String {
    math.plain()
}

fn curve(plot: &Plot<'_>, line: &Line, is_plane: bool) -> String {
    let curve = &plot.curves[line.curve];
    let kind = match curve.style {
        Style::Limit => "Limit",
        Style::Band => "Edge of",
        _ => "Curve",
    };
    let label = curve.label.as_ref().map(name).unwrap_or_default();
    let label = match (label.is_empty(), curve.style) {
        (true, Style::Band) => " a band".to_owned(),
        (true, _) => label,
        (false, _) => format!(" {label}"),
    };
    if is_plane {
        return String::new();
    }
    let values: Vec<f64> = line
        .runs
        .iter()
        .flat_map(|run| run.windows(2))
        .flat_map(|pair| {
            (0..=POINTS).map(|point| cubic(&pair[0], &pair[1], point as f64 / POINTS as f64).0[1])
        })
        .collect();
    match behaviour(&values, &plot.y, plot.decimal) {
        Some(behaviour) => format!(" {kind}{label} {behaviour}."),
        None => String::new(),
    }
}

/// What values do from first to last.
fn behaviour(values: &[f64], axis: &Axis, mark: DecimalMark) -> Option<String> {
    let (first, last) = (*values.first()?, *values.last()?);
    let say = |coordinate: f64| number(axis.value(coordinate), axis.unit, mark);
    let (low, high) = values.iter().fold((first, first), |(low, high), value| {
        (low.min(*value), high.max(*value))
    });
    if high - low <= 1e-6 * high.abs().max(low.abs()) {
        return Some(format!("is constant at {}", say(first)));
    }
    let turns = turns(values, TURN * (high - low));
    let verb = |from: f64, to: f64| if to > from { "rises" } else { "falls" };
    Some(match turns.as_slice() {
        [] => format!("{} from {} to {}", verb(first, last), say(first), say(last)),
        [turn] => format!(
            "{} from {} to {}, then {} to {}",
            verb(first, *turn),
            say(first),
            say(*turn),
            verb(*turn, last),
            say(last)
        ),
        turns => format!(
            "oscillates between {} and {}{}, with {} turning points",
            say(low),
            say(high),
            tendency(turns),
            turns.len()
        ),
    })
}

/// Whether oscillations decay or grow.
fn tendency(turns: &[f64]) -> &'static str {
    let swings: Vec<f64> = turns
        .windows(2)
        .map(|pair| (pair[1] - pair[0]).abs())
        .collect();
    let is_falling = swings.windows(2).all(|pair| pair[1] < pair[0] * 0.999);
    let is_rising = swings.windows(2).all(|pair| pair[1] > pair[0] * 1.001);
    match (
        swings.len() > 1 && is_falling,
        swings.len() > 1 && is_rising,
    ) {
        (true, _) => " and decays",
        (_, true) => " and grows",
        _ => "",
    }
}

/// The values at which a sequence turns by more than `least`.
fn turns(values: &[f64], least: f64) -> Vec<f64> {
    let mut turns = Vec::new();
    let Some(&start) = values.first() else {
        return turns;
    };
    // Direction of the way so far, and its furthest value.
    let (mut direction, mut furthest) = (0.0_f64, start);
    for &value in values {
        let ahead = (value - furthest) * direction;
        if direction == 0.0 {
            if (value - start).abs() > least {
                (direction, furthest) = ((value - start).signum(), value);
            }
        } else if ahead > 0.0 {
            furthest = value;
        } else if -ahead > least {
            turns.push(furthest);
            (direction, furthest) = (-direction, value);
        }
    }
    turns
}

/// A number with its unit to three figures.
pub(crate) fn number(value: f64, unit: Unit, mark: DecimalMark) -> String {
    let decimal = Decimal::rounded(value, 3).unwrap_or(Decimal::ZERO);
    let decimal = Decimal::shortest(decimal.to_f64()).unwrap_or(decimal);
    Quantity::new(decimal, unit).text(mark)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn says(values: &[f64]) -> String {
        let axis = Axis {
            label: Math::Row(Vec::new()),
            unit: Unit::parse("mm").unwrap(),
            is_logarithmic: false,
            spacing: crate::figure::plot::Spacing::Round,
            range: None,
        };
        behaviour(values, &axis, DecimalMark::Point).unwrap()
    }

    #[test]
    fn courses_are_told_apart() {
        assert_eq!(says(&[2.0, 2.0]), "is constant at 2 mm");
        assert_eq!(says(&[2.0, 1.0, 0.5]), "falls from 2 mm to 0.5 mm");
        assert_eq!(
            says(&[0.0, 3.0, 1.0]),
            "rises from 0 mm to 3 mm, then falls to 1 mm"
        );
        let decay = [4.0, -3.0, 2.0, -1.0, 0.5, 0.0];
        assert_eq!(
            says(&decay),
            "oscillates between −3 mm and 4 mm and decays, with 4 turning points"
        );
        assert!(says(&[0.0, 1.0, -1.0, 1.0, -1.0, 1.0]).contains("between −1 mm and 1 mm, with"));
    }
}
