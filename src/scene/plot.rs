//! Plots of an instance: the formulas of a declared plot, evaluated for its data.

use super::Scene;
use crate::bank::plot::{Abscissa, Curve, Curves, ModeShapes, Phasors, Plot, PlotKind};
use crate::document::Filling;
use crate::expr::Precise;
use crate::figure::Point;
use crate::figure::plot::{self, Axis, Course, CurveStyle, ModeShape, Picture, PlotError, Spacing};
use crate::figure::story::Speaker as _;
use crate::math::{Math, symbol};
use crate::message::Phrase;
use crate::quantity::{Absent, Evaluation, Function, NodeId};
use crate::unit::{Decimal, Quantity, Rational, Unit};
use crate::work;

/// Units of work that the curves of one plot may take: some tenths of a second.
const MAX_WORK: u64 = 20_000_000;

/// Why a plot cannot be drawn for these data.
#[derive(Clone, Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Undrawn {
    /// There is no plot of this name.
    #[error("there is no plot `{0}`")]
    Unknown(String),
    /// A number that it needs does not exist.
    #[error("{0}")]
    Absent(#[from] Absent),
    /// What is there cannot be drawn.
    #[error("{0}")]
    Plot(#[from] PlotError),
    /// Its curves take too long.
    #[error("its curves take more than {} million steps", MAX_WORK / 1_000_000)]
    Work,
}

pub(crate) fn picture(scene: &Scene<'_, '_>, name: &str) -> Result<Picture, Undrawn> {
    let mut plots = scene.solution.template().plots.iter();
    let plot = plots.find(|plot: &&Plot| plot.name == name);
    let plot = plot.ok_or_else(|| Undrawn::Unknown(name.to_owned()))?;
    let drawn = work::within(MAX_WORK, || match &plot.kind {
        PlotKind::Curves(curves) => drawn_curves(scene, curves, false),
        PlotKind::PhasePlane(curves) => drawn_curves(scene, curves, true),
        PlotKind::ModeShapes(shapes) => drawn_mode_shapes(scene, shapes),
        PlotKind::Phasors(phasors) => drawn_phasors(scene, phasors),
    });
    if drawn.is_exhausted {
        // A curve with gaps where nothing was left would not be that of its formula.
        return Err(Undrawn::Work);
    }
    drawn.value
}

/// A plot as it stands in a text.
pub(crate) fn filling(scene: &Scene<'_, '_>, name: &str) -> Filling {
    let id = plot_id(scene, name);
    match picture(scene, name) {
        Ok(picture) if !scene.is_drawn => {
            let words = scene.language.caption(&picture.story).description;
            Filling::words(scene.language.phrase(&Phrase::Plot(&words)))
        }
        Ok(picture) => Filling::Figure(picture.svg(&id, &scene.language)),
        Err(_) => Filling::words(scene.language.phrase(&Phrase::NoPlot)),
    }
}

/// Letters, digits and hyphens that no other plot of a page has.
fn plot_id(scene: &Scene<'_, '_>, name: &str) -> String {
    let identity = format!("{}-plot-{name}", scene.scope());
    let is_plain = |letter: char| letter.is_ascii_alphanumeric();
    identity
        .chars()
        .map(|letter| if is_plain(letter) { letter } else { '-' })
        .collect()
}

fn drawn_curves(
    scene: &Scene<'_, '_>,
    curves: &Curves,
    is_plane: bool,
) -> Result<Picture, Undrawn> {
    let evaluations: Vec<Option<Evaluation<'_>>> = curves
        .curves
        .iter()
        .map(|curve| evaluation_of(scene, curve))
        .collect::<Result<_, Absent>>()?;
    let y = &curves.y;
    let mut drawn = Vec::new();
    for (curve, own) in curves.curves.iter().zip(&evaluations) {
        let evaluation = own.as_ref().unwrap_or_else(|| scene.solution.evaluation());
        let within = match curve.range {
            Some(ends) => ends_of(scene, ends, &curves.x.unit)?,
            None => [f64::NEG_INFINITY, f64::INFINITY],
        };
        let value = match evaluation.function(curve.y) {
            Ok(function) => values(function, curves.x.unit, within),
            // What does not exist for these data is not drawn.
            Err(Absent::NotForTheseData(_)) => continue,
            Err(absent) => return Err(absent.into()),
        };
        let course = match curve.rate {
            Some(rate) => {
                let rate = values(evaluation.function(rate)?, curves.x.unit, within);
                Course::Path(Box::new(move |variable| {
                    let at = first(&value(variable)?)?;
                    let rate = first(&rate(variable)?)?;
                    Some([y.unit.of_si(at), y.rate_unit.of_si(rate)])
                }))
            }
            None if curve.style == CurveStyle::Band => Course::Band(Box::new(move |variable| {
                let edges = value(variable)?;
                let [low, high] = *edges.as_slice() else {
                    return None;
                };
                Some([y.unit.of_si(low), y.unit.of_si(high)])
            })),
            None => Course::Graph(Box::new(move |variable| {
                first(&value(variable)?).map(|value| y.unit.of_si(value))
            })),
        };
        drawn.push(plot::Curve {
            course,
            label: curve.label.clone(),
            style: curve.style,
        });
    }
    let marks = marks(scene, curves, is_plane);
    let (x, y) = axes(scene, curves, is_plane)?;
    let plot = plot::Plot {
        x,
        y,
        range: ends_of(scene, curves.x.range, &curves.x.unit)?,
        curves: drawn,
        marks,
        decimal: scene.solution.mark(),
    };
    Ok(plot.draw()?)
}

/// The evaluation of a curve with other values of some quantities.
fn evaluation_of<'s>(
    scene: &'s Scene<'_, '_>,
    curve: &Curve,
) -> Result<Option<Evaluation<'s>>, Absent> {
    if curve.with.is_empty() {
        return Ok(None);
    }
    let evaluation = scene.solution.evaluation();
    let with = curve.with.iter();
    let with = with.map(|(quantity, value)| Ok((*quantity, evaluation.value(*value)?.clone())));
    Ok(Some(
        evaluation.replacing(with.collect::<Result<_, Absent>>()?),
    ))
}

fn axes(scene: &Scene<'_, '_>, curves: &Curves, is_plane: bool) -> Result<(Axis, Axis), Undrawn> {
    let (x, y) = (&curves.x, &curves.y);
    let label = y.label.clone().unwrap_or(Math::Row(Vec::new()));
    let axis = |label: Math, unit: Unit, is_logarithmic| Axis {
        label,
        unit,
        is_logarithmic,
        spacing: Spacing::Round,
        range: None,
    };
    if is_plane {
        let rate = rate_of(&label);
        return Ok((axis(label, y.unit, false), axis(rate, y.rate_unit, false)));
    }
    let mut across = axis(x.label.clone(), x.unit, x.is_logarithmic);
    across.spacing = spacing(scene, x)?;
    let mut up = axis(label, y.unit, y.is_logarithmic);
    if let Some(range) = y.range {
        up.range = Some(ends_of(scene, range, &y.unit)?);
    }
    Ok((across, up))
}

fn spacing(scene: &Scene<'_, '_>, x: &Abscissa) -> Result<Spacing, Absent> {
    let Some((node, is_share_of_pi)) = x.ticks else {
        return Ok(Spacing::Round);
    };
    let step = x.unit.of_si(scene.solution.evaluation().real(node)?);
    // Shares of π are those of radians.
    let is_share_of_pi = is_share_of_pi && x.unit.of_si(1.0) == 1.0;
    Ok(if is_share_of_pi {
        Spacing::ShareOfPi(step)
    } else {
        Spacing::Step(step)
    })
}

fn ends_of(scene: &Scene<'_, '_>, nodes: [NodeId; 2], unit: &Unit) -> Result<[f64; 2], Absent> {
    let evaluation = scene.solution.evaluation();
    Ok([
        unit.of_si(evaluation.real(nodes[0])?),
        unit.of_si(evaluation.real(nodes[1])?),
    ])
}

fn marks(scene: &Scene<'_, '_>, curves: &Curves, is_plane: bool) -> Vec<plot::PlotMark> {
    let (x, y) = (&curves.x, &curves.y);
    let units = if is_plane {
        [y.unit, y.rate_unit]
    } else {
        [x.unit, y.unit]
    };
    let evaluation = scene.solution.evaluation();
    let mut marks = Vec::new();
    for mark in &curves.marks {
        let place = |axis: usize| {
            evaluation
                .real(mark.at[axis])
                .map(|si| units[axis].of_si(si))
        };
        // What does not exist for these data is not marked.
        if let (Ok(across), Ok(up)) = (place(0), place(1)) {
            marks.push(plot::PlotMark {
                at: [across, up],
                label: mark.label.clone(),
            });
        }
    }
    marks
}

fn drawn_mode_shapes(scene: &Scene<'_, '_>, modes: &ModeShapes) -> Result<Picture, Undrawn> {
    let evaluation = scene.solution.evaluation();
    let shapes = evaluation.value(modes.shapes)?;
    let frequencies = evaluation.value(modes.frequencies)?;
    let count = modes.coordinates.len();
    let masses = modes
        .masses
        .map(|masses| evaluation.value(masses))
        .transpose()?;
    let weight = |place: usize| {
        let mass = masses.and_then(|masses| masses.numbers().get(place * (count + 1)));
        mass.map_or(1.0, |mass| mass.max(0.0).sqrt())
    };
    let fastest = frequencies
        .numbers()
        .iter()
        .fold(0.0_f64, |fastest, own| fastest.max(*own));
    let rows = shapes.numbers().chunks(count).zip(frequencies.numbers());
    let shape = |(number, (row, frequency)): (usize, (&[f64], &f64))| ModeShape {
        heading: heading(
            scene,
            number + 1,
            if *frequency > 1e-7 * fastest {
                *frequency
            } else {
                0.0
            },
        ),
        heights: row
            .iter()
            .enumerate()
            .map(|(place, own)| own * weight(place))
            .collect(),
        labels: components(scene, row, &modes.units),
    };
    let modes = plot::ModeShapes {
        coordinates: modes.coordinates.clone(),
        shapes: rows.enumerate().map(shape).collect(),
    };
    Ok(modes.draw())
}

fn drawn_phasors(scene: &Scene<'_, '_>, phasors: &Phasors) -> Result<Picture, Undrawn> {
    let evaluation = scene.solution.evaluation();
    let pointer = |node: NodeId| {
        let own = evaluation.value(node)?.entry(0);
        Ok::<_, Absent>(Point::new(own.re, own.im))
    };
    let drawn = phasors.phasors.iter().map(|own| {
        Ok(plot::Phasor {
            value: pointer(own.of)? * (1.0 / phasors.unit.to_si(1.0)),
            label: own.label.clone(),
            is_joined: own.is_joined,
            style: own.style,
        })
    });
    let angles = phasors.angles.iter().map(|own| {
        Ok(plot::PhasorAngle {
            from: pointer(own.ends[0])?.angle(),
            to: pointer(own.ends[1])?.angle(),
            label: own.label.clone(),
        })
    });
    let diagram = plot::Phasors {
        phasors: drawn.collect::<Result<_, Absent>>()?,
        angles: angles.collect::<Result<_, Absent>>()?,
        unit: phasors.unit,
        decimal: scene.solution.mark(),
    };
    Ok(diagram.draw()?)
}

/// `ω₁ = 3.16 rad/s`.
fn heading(scene: &Scene<'_, '_>, number: usize, frequency: f64) -> Math {
    let unit = Unit::parse("rad/s").unwrap_or(Unit::ONE);
    let value = match Decimal::rounded(frequency, 3) {
        Some(value) if frequency > 0.0 => Quantity::new(value, unit).math(scene.solution.mark()),
        _ => Math::number("0"),
    };
    Math::row([
        symbol(&format!("omega_{number}")),
        Math::relation("="),
        value,
    ])
}

/// The components as shares of the largest one; where they have several units, of the first that is not zero.
fn components(scene: &Scene<'_, '_>, row: &[f64], units: &[Unit]) -> Vec<Math> {
    let largest = row
        .iter()
        .fold(0.0_f64, |largest, own| largest.max(own.abs()));
    let is_uniform = units.windows(2).all(|pair| pair[0] == pair[1]);
    let counts = |own: &f64| {
        if is_uniform {
            own.abs() >= largest
        } else {
            own.abs() > 1e-9 * largest
        }
    };
    let reference = row.iter().position(counts).unwrap_or(0);
    let mark = scene.solution.mark();
    let component = |(place, own): (usize, &f64)| {
        if own.abs() <= 1e-9 * largest {
            return Math::number("0");
        }
        let unit = share(&units[place], &units[reference]);
        let value = own / row[reference].abs();
        let is_whole = unit.is_one() && (value.abs() - 1.0).abs() < 1e-9;
        let digits = if is_whole { 1 } else { 3 };
        let value = Decimal::rounded(value, digits).unwrap_or(Decimal::ZERO);
        Quantity::new(value, unit).math(mark)
    };
    row.iter().enumerate().map(component).collect()
}

/// What a quantity is at a value of its variable, in the unit of the axis; SI numbers.
type ValuesAt<'e> = Box<dyn Fn(f64) -> Option<Vec<f64>> + 'e>;

/// The values of a function within some range of its variable; outside of it there are none.
fn values<'e>(function: Function<'e, '_>, unit: Unit, [from, to]: [f64; 2]) -> ValuesAt<'e> {
    let count = function.variables().count();
    Box::new(move |variable| {
        if !(from..=to).contains(&variable) {
            return None;
        }
        let variables = [Precise::exact(unit.to_si(variable))];
        let value = function.at(&variables[..count.min(1)]).ok()?;
        Some(value.numbers().to_vec())
    })
}

fn first(numbers: &[f64]) -> Option<f64> {
    numbers.first().copied()
}

/// The unit of one component as a share of another.
fn share(own: &Unit, other: &Unit) -> Unit {
    let inverse = other.pow(Rational::integer(-1));
    let share = inverse.and_then(|inverse| own.times(&inverse));
    share.unwrap_or(Unit::ONE)
}

/// The symbol of the rate of something: with a dot, before its arguments.
fn rate_of(label: &Math) -> Math {
    match label {
        Math::Row(pieces) => match pieces.split_first() {
            Some((first, rest)) => {
                Math::row(std::iter::once(first.clone().derivative(1)).chain(rest.iter().cloned()))
            }
            None => label.clone(),
        },
        symbol => symbol.clone().derivative(1),
    }
}
