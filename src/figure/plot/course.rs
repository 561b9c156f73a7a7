//! The courses of curves: from functions to runs of cubic pieces, and to lines on paper.

use super::frame::Frame;
use super::sample::{Coarse, CurveRun, Knot, SampledFunction, cubic};
use super::{Course, Plot, PlotError};
use crate::figure::{Path, Point};

/// Largest distance of a curve from its cubic pieces, in millimetres: a ninth of the line's width.
const ERROR: f64 = 0.04;
/// Millimetres in a figure unit.
const MILLIMETRES: f64 = 10.0;
/// Straight pieces for a cubic one where labels keep clear.
const FLAT: usize = 6;

/// A line of a curve; a band has two.
pub(crate) struct CurveLine {
    /// The number of its curve.
    pub(crate) curve: usize,
    pub(crate) runs: Vec<CurveRun>,
}

/// The lines of all curves and the frame that shows them.
pub(crate) fn lines(plot: &Plot<'_>) -> Result<(Vec<CurveLine>, Frame), PlotError> {
    let functions = functions(plot);
    let variable = if is_plane(plot) {
        plot.range
    } else {
        plot.x.coordinates('x', plot.range)?
    };
    if !(variable[0] < variable[1] && (variable[1] - variable[0]).is_finite()) {
        let [from, to] = plot.range;
        return Err(PlotError::Range {
            axis: 'x',
            from,
            to,
        });
    }
    let coarse: Vec<Coarse<'_>> = functions
        .iter()
        .map(|(_, function)| Coarse::of(&**function, variable))
        .collect();
    let extents: Vec<_> = coarse.iter().filter_map(Coarse::extent).collect();
    let mut frame = frame(plot, variable, &extents)?;
    let size = frame.size().map(|size| size * MILLIMETRES);
    let lines: Vec<CurveLine> = functions
        .iter()
        .zip(&coarse)
        .map(|((curve, _), coarse)| CurveLine {
            curve: *curve,
            runs: coarse.refine(size, ERROR),
        })
        .collect();
    let extents: Vec<_> = lines
        .iter()
        .filter_map(|line| super::sample::extent(line.runs.iter().flatten()))
        .collect();
    // Peaks between the first places are found on the way.
    frame = self::frame(plot, variable, &extents).unwrap_or(frame);
    Ok((lines, frame))
}

/// The frame around these extents and the marks.
fn frame(
    plot: &Plot<'_>,
    variable: [f64; 2],
    extents: &[[[f64; 2]; 2]],
) -> Result<Frame, PlotError> {
    let points = extents.iter().flatten().copied();
    let all: Vec<[f64; 2]> = points.collect();
    if all.is_empty() {
        return Err(PlotError::Nothing);
    }
    let marks = plot.marks.iter().filter_map(|mark| place(plot, mark.at));
    let all: Vec<[f64; 2]> = all.into_iter().chain(marks).collect();
    let span = |axis: usize| {
        let numbers = all.iter().map(|point| point[axis]);
        let low = numbers.clone().fold(f64::INFINITY, f64::min);
        [low, numbers.fold(f64::NEG_INFINITY, f64::max)]
    };
    let x = if is_plane(plot) {
        let [low, high] = span(0);
        super::frame::roomy(low, high, plot.x.is_logarithmic)
    } else {
        variable
    };
    let y = match plot.y.range {
        Some(range) => plot.y.coordinates('y', range)?,
        None => {
            let [low, high] = span(1);
            super::frame::roomy(low, high, plot.y.is_logarithmic)
        }
    };
    Frame::new(x, y)
}

/// The coordinates of a point.
pub(crate) fn place(plot: &Plot<'_>, at: [f64; 2]) -> Option<[f64; 2]> {
    Some([plot.x.coordinate(at[0])?, plot.y.coordinate(at[1])?])
}

fn is_plane(plot: &Plot<'_>) -> bool {
    plot.curves
        .iter()
        .any(|curve| matches!(curve.course, Course::Path(_)))
}

/// A function of the variable whose values are coordinates.
type Coordinates<'p> = Box<SampledFunction<'p>>;

/// The lines of all curves as functions of the variable, with the numbers of their curves.
fn functions<'p>(plot: &'p Plot<'_>) -> Vec<(usize, Coordinates<'p>)> {
    let mut functions: Vec<(usize, Coordinates<'p>)> = Vec::new();
    for (number, curve) in plot.curves.iter().enumerate() {
        match &curve.course {
            Course::Graph(function) => {
                let point = move |s: f64| Some([s, shown(plot, function(plot.x.value(s))?)?]);
                functions.push((number, Box::new(point)));
            }
            Course::Band(edges) => {
                for edge in [0, 1] {
                    let point =
                        move |s: f64| Some([s, shown(plot, edges(plot.x.value(s))?[edge])?]);
                    functions.push((number, Box::new(point)));
                }
            }
            Course::Path(function) => {
                functions.push((number, Box::new(move |s| place(plot, function(s)?))));
            }
        }
    }
    functions
}

/// The coordinate of a value, if the axis shows it.
fn shown(plot: &Plot<'_>, value: f64) -> Option<f64> {
    let is_outside = plot
        .y
        .range
        .is_some_and(|[low, high]| !(low..=high).contains(&value));
    if is_outside {
        return None;
    }
    plot.y.coordinate(value)
}

impl CurveLine {
    /// The line on paper.
    pub(crate) fn path(&self, frame: &Frame) -> Path {
        self.runs
            .iter()
            .fold(Path::new(), |path, run| path.and(run_path(run, frame)))
    }

    /// Its points on paper, dense enough to stand for the line, run by run.
    pub(crate) fn flat(&self, frame: &Frame) -> Vec<Vec<Point>> {
        self.runs
            .iter()
            .map(|run| {
                let mut points = vec![frame.place(run[0].at)];
                for pair in run.windows(2) {
                    points.extend((1..=FLAT).map(|piece| {
                        frame.place(cubic(&pair[0], &pair[1], piece as f64 / FLAT as f64).0)
                    }));
                }
                points
            })
            .collect()
    }
}

fn run_path(run: &CurveRun, frame: &Frame) -> Path {
    append(Path::new().move_to(frame.place(run[0].at)), run, frame)
}

/// Appends the pieces of a run to a path that has reached its beginning.
fn append(path: Path, run: &[Knot], frame: &Frame) -> Path {
    run.windows(2).fold(path, |path, pair| {
        let third = (pair[1].variable - pair[0].variable) / 3.0;
        let (from, to) = (frame.place(pair[0].at), frame.place(pair[1].at));
        let first = from + frame.along(pair[0].direction) * third;
        let second = to - frame.along(pair[1].direction) * third;
        let is_straight = first.distance(from.towards(to, 1.0 / 3.0)) < 1e-3
            && second.distance(from.towards(to, 2.0 / 3.0)) < 1e-3;
        if is_straight {
            path.line_to(to)
        } else {
            path.curve_to(first, second, to)
        }
    })
}

/// The area between two lines, where neither is interrupted.
pub(crate) fn area(low: &CurveLine, high: &CurveLine, frame: &Frame) -> Option<Path> {
    let ([low], [high]) = (low.runs.as_slice(), high.runs.as_slice()) else {
        return None;
    };
    let turned = high.iter().rev().map(|knot| Knot {
        variable: -knot.variable,
        direction: knot.direction.map(|part| -part),
        ..*knot
    });
    let back: CurveRun = turned.collect();
    let path = run_path(low, frame).line_to(frame.place(back[0].at));
    Some(append(path, &back, frame).close())
}
