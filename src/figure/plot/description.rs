//! What a plot shows, as data.

use super::course::CurveLine;
use super::sample::cubic;
use super::{Axis, CurveStyle, Plot};
use crate::figure::story::{self, Behaviour, Curves, Tendency};
use crate::math::Math;
use crate::unit::{Decimal, DecimalMark, Quantity, Unit};

/// Share of a curve's extent from which a turn counts.
const TURN: f64 = 0.02;
/// Share of a curve's extent below which no value can be told from zero in a plot.
const ZERO: f64 = 1e-6;
/// Points that stand for a cubic piece.
const POINTS: usize = 4;

/// Axes, curves and marks.
pub(crate) fn of(plot: &Plot<'_>, lines: &[CurveLine], up: &Math) -> Curves {
    let mark = plot.decimal;
    let is_plane = plot
        .curves
        .iter()
        .any(|curve| matches!(curve.course, super::Course::Path(_)));
    // The range of a phase plane is that of the time, which it does not show.
    let has_range = !lines.is_empty() && !is_plane;
    let range = plot.x.range.unwrap_or(plot.range);
    let marks = plot.marks.iter().map(|point| {
        let at = [
            number(point.at[0], plot.x.unit, mark),
            number(point.at[1], plot.y.unit, mark),
        ];
        (point.label.clone(), at)
    });
    Curves {
        up: up.clone(),
        across: plot.x.label.clone(),
        range: has_range.then(|| {
            [
                number(range[0], Unit::ONE, mark),
                number(range[1], plot.x.unit, mark),
            ]
        }),
        is_logarithmic: plot.x.is_logarithmic,
        curves: lines
            .iter()
            .filter(|_| !is_plane)
            .filter_map(|line| curve(plot, line))
            .collect(),
        marks: marks.collect(),
    }
}

fn curve(plot: &Plot<'_>, line: &CurveLine) -> Option<story::DescribedCurve> {
    let curve = &plot.curves[line.curve];
    let kind = match curve.style {
        CurveStyle::Limit => story::LineKind::Limit,
        CurveStyle::Band => story::LineKind::Edge,
        _ => story::LineKind::Curve,
    };
    let values: Vec<f64> = line
        .runs
        .iter()
        .flat_map(|run| run.windows(2))
        .flat_map(|pair| {
            (0..=POINTS).map(|point| cubic(&pair[0], &pair[1], point as f64 / POINTS as f64).0[1])
        })
        .collect();
    Some(story::DescribedCurve {
        kind,
        label: curve.label.clone(),
        behaviour: behaviour(&values, &plot.y, plot.decimal)?,
    })
}

/// What values do from first to last.
fn behaviour(values: &[f64], axis: &Axis, mark: DecimalMark) -> Option<Behaviour> {
    let (first, last) = (*values.first()?, *values.last()?);
    let (low, high) = values.iter().fold((first, first), |(low, high), value| {
        (low.min(*value), high.max(*value))
    });
    // What rounding leaves of zero is zero; the coordinates of a logarithmic axis are exponents.
    let is_zero = |own: f64| !axis.is_logarithmic && own.abs() < ZERO * (high - low);
    let say = |own: f64| {
        let own = if is_zero(own) { 0.0 } else { own };
        number(axis.value(own), axis.unit, mark)
    };
    if high - low <= 1e-6 * high.abs().max(low.abs()) {
        return Some(Behaviour::Constant(say(first)));
    }
    Some(match turns(values, TURN * (high - low)).as_slice() {
        [] => Behaviour::Way {
            rises: last > first,
            ends: [first, last].map(say),
        },
        [turn] => Behaviour::Turn {
            rises: *turn > first,
            values: [first, *turn, last].map(say),
        },
        turns => Behaviour::Oscillation {
            between: [low, high].map(say),
            tendency: tendency(turns),
            turns: turns.len(),
        },
    })
}

/// Whether oscillations decay or grow.
fn tendency(turns: &[f64]) -> Tendency {
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
        (true, _) => Tendency::Decays,
        (_, true) => Tendency::Grows,
        _ => Tendency::Neither,
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

    fn of(values: &[f64]) -> Behaviour {
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
        let value = |value: &str| value.to_owned();
        assert_eq!(of(&[2.0, 2.0]), Behaviour::Constant(value("2 mm")));
        let falls = Behaviour::Way {
            rises: false,
            ends: ["2 mm", "0.5 mm"].map(value),
        };
        assert_eq!(of(&[2.0, 1.0, 0.5]), falls);
        let to_nothing = Behaviour::Way {
            rises: false,
            ends: ["2 mm", "0 mm"].map(value),
        };
        assert_eq!(of(&[2.0, 1.0, -1.4e-16]), to_nothing);
        let turns = Behaviour::Turn {
            rises: true,
            values: ["0 mm", "3 mm", "1 mm"].map(value),
        };
        assert_eq!(of(&[0.0, 3.0, 1.0]), turns);
        let decays = Behaviour::Oscillation {
            between: ["−3 mm", "4 mm"].map(value),
            tendency: Tendency::Decays,
            turns: 4,
        };
        assert_eq!(of(&[4.0, -3.0, 2.0, -1.0, 0.5, 0.0]), decays);
        let oscillates = Behaviour::Oscillation {
            between: ["−1 mm", "1 mm"].map(value),
            tendency: Tendency::Neither,
            turns: 4,
        };
        assert_eq!(of(&[0.0, 1.0, -1.0, 1.0, -1.0, 1.0]), oscillates);
    }
}
