//! Axes with arrows, ticks, and what they count.

use super::frame::{Frame, HEIGHT, WIDTH};
use super::ticks::{Tick, Ticks, power_of_ten};
use super::{Axis, Plot, PlotError, Spacing};
use crate::figure::{Anchor, Bounds, Drawing, FigureLabel, Fill, Path, Pen, Point, Weight};
use crate::math::Math;
use crate::numerics::log10;
use crate::unit::DecimalMark;

/// How far an axis goes beyond the space between the axes.
const BEYOND: f64 = 0.4;
/// Length of a tick with and without a label.
const TICKS: [f64; 2] = [0.1, 0.06];
/// Room between a tick and its label.
const GAP: f64 = 0.08;
/// Most ticks across and upwards.
const MAX_TICK_COUNTS: [usize; 2] = [8, 6];

impl Axis {
    /// Where a value stands, in the axis's own coordinate.
    pub(crate) fn coordinate(&self, value: f64) -> Option<f64> {
        if self.is_logarithmic && value <= 0.0 {
            return None;
        }
        let coordinate = if self.is_logarithmic {
            log10(value)
        } else {
            value
        };
        coordinate.is_finite().then_some(coordinate)
    }

    /// The value that stands at a coordinate.
    pub(crate) fn value(&self, coordinate: f64) -> f64 {
        if self.is_logarithmic {
            crate::numerics::pow(10.0, coordinate)
        } else {
            coordinate
        }
    }

    /// The coordinates of a range.
    pub(crate) fn coordinates(&self, name: char, range: [f64; 2]) -> Result<[f64; 2], PlotError> {
        let [from, to] = range;
        let coordinate = |value| {
            self.coordinate(value).ok_or(PlotError::Range {
                axis: name,
                from,
                to,
            })
        };
        Ok([coordinate(from)?, coordinate(to)?])
    }

    fn ticks(&self, range: [f64; 2], count: usize, mark: DecimalMark) -> Ticks {
        match self.spacing {
            _ if self.is_logarithmic => Ticks::logarithmic(range, mark),
            Spacing::Round => Ticks::linear(range, count, mark),
            Spacing::Step(step) => Ticks::stepped(range, step, mark),
            Spacing::ShareOfPi(step) => Ticks::of_pi(range, step),
        }
    }

    /// Ticks whose labels, of a height or width given by `extent`, do not crowd.
    fn clear_ticks(
        &self,
        range: [f64; 2],
        most: usize,
        mark: DecimalMark,
        extent: impl Fn(&FigureLabel) -> f64,
        length: f64,
    ) -> Ticks {
        let mut ticks = Ticks::default();
        for count in (2..=most).rev() {
            ticks = self.ticks(range, count, mark);
            let labels = ticks.ticks.iter().filter_map(|tick| tick.label.as_ref());
            let widest = labels
                .map(|label| extent(&FigureLabel::of(label)))
                .fold(0.0, f64::max);
            let places: Vec<f64> = ticks
                .ticks
                .iter()
                .filter(|tick| tick.label.is_some())
                .map(|tick| tick.at)
                .collect();
            let nearest = places
                .windows(2)
                .map(|pair| pair[1] - pair[0])
                .fold(f64::INFINITY, f64::min);
            if nearest / (range[1] - range[0]) * length > 1.5 * widest + 0.15 {
                break;
            }
        }
        ticks
    }

    /// What stands at the axis: `x (10⁻³ m)`.
    fn title(&self, label: &Math, power: i32) -> Math {
        let mut factors = Vec::new();
        if power != 0 {
            factors.push(power_of_ten(power));
        }
        if !self.unit.is_one() {
            if power != 0 {
                factors.push(Math::thin_space());
            }
            factors.push(self.unit.math());
        }
        let is_bare = *label == Math::Row(Vec::new());
        let unit = Math::row(factors.clone());
        match (factors.is_empty(), is_bare) {
            (true, _) => label.clone(),
            (false, true) => unit,
            (false, false) => Math::row([label.clone(), Math::Space(4), unit.in_parentheses()]),
        }
    }
}

/// Draws both axes; the boxes of what stands at their ends are returned.
pub(crate) fn draw(
    drawing: &mut Drawing,
    frame: &Frame,
    plot: &Plot<'_>,
    up: &Math,
) -> Vec<Bounds> {
    zero_lines(drawing, frame, plot);
    let pen = Pen::new(Weight::Thin);
    let origin = Point::default();
    let ends = [
        Point::new(WIDTH + BEYOND, 0.0),
        Point::new(0.0, HEIGHT + BEYOND),
    ];
    for end in ends {
        drawing.stroke(Path::line(origin, end), pen);
    }
    for end in ends {
        arrow_head(drawing, end, end.unit());
    }
    let across = plot.x.clear_ticks(
        frame.x,
        MAX_TICK_COUNTS[0],
        plot.decimal,
        FigureLabel::width,
        WIDTH,
    );
    for tick in &across.ticks {
        let at = Point::new(frame.place([tick.at, frame.y[0]]).x, 0.0);
        draw_tick(drawing, tick, at, Point::new(0.0, -1.0));
    }
    let height = |label: &FigureLabel| label.ascent() + label.depth();
    let upward = plot
        .y
        .clear_ticks(frame.y, MAX_TICK_COUNTS[1], plot.decimal, height, HEIGHT);
    for tick in &upward.ticks {
        let at = Point::new(0.0, frame.place([frame.x[0], tick.at]).y);
        draw_tick(drawing, tick, at, Point::new(-1.0, 0.0));
    }
    let right = FigureLabel::of(&plot.x.title(&plot.x.label, across.power));
    let top = FigureLabel::of(&plot.y.title(up, upward.power));
    let mut boxes = Vec::new();
    if !right.is_empty() {
        boxes.push(drawing.text(right, ends[0] + Point::new(0.12, 0.0), Anchor::LEFT));
    }
    if !top.is_empty() {
        boxes.push(drawing.text(top, ends[1] + Point::new(0.18, 0.0), Anchor::LEFT));
    }
    boxes
}

/// Thin lines where a coordinate is zero inside the frame.
fn zero_lines(drawing: &mut Drawing, frame: &Frame, plot: &Plot<'_>) {
    let pen = Pen::new(Weight::Hair);
    if is_inside(&plot.y, frame.y) {
        let y = frame.place([frame.x[0], 0.0]).y;
        drawing.stroke(Path::line(Point::new(0.0, y), Point::new(WIDTH, y)), pen);
    }
    if is_inside(&plot.x, frame.x) {
        let x = frame.place([0.0, frame.y[0]]).x;
        drawing.stroke(Path::line(Point::new(x, 0.0), Point::new(x, HEIGHT)), pen);
    }
}

/// Whether zero lies well within the frame of an axis.
fn is_inside(axis: &Axis, [from, to]: [f64; 2]) -> bool {
    let slack = 1e-3 * (to - from);
    !axis.is_logarithmic && from < -slack && to > slack
}

fn draw_tick(drawing: &mut Drawing, tick: &Tick, at: Point, outward: Point) {
    let length = TICKS[usize::from(tick.label.is_none())];
    let end = at + outward * length;
    drawing.decorate(
        Path::line(at, end),
        Some(Pen::new(Weight::Thin)),
        Fill::None,
    );
    if let Some(label) = &tick.label {
        drawing.text(
            FigureLabel::of(label),
            end + outward * GAP,
            Anchor::facing(outward),
        );
    }
}

/// A slim head at the end of an axis.
fn arrow_head(drawing: &mut Drawing, tip: Point, direction: Point) {
    let (length, half) = (0.24, 0.07);
    let back = tip - direction * length;
    let corners = [
        tip,
        back + direction.left() * half,
        back - direction.left() * half,
    ];
    drawing.decorate(Path::polygon(corners), None, Fill::Ink);
}
