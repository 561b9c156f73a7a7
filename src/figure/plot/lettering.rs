//! Labels of curves and marks: beside what they name, clear of all lines and of each other.
//!
//! A name stands at its curve, where no other curve is near. Limits are named at their right ends, outside of
//! the frame. What finds no room at its curve is named at the right end too, with a hairline to it.

use super::Plot;
use super::course::{CurveLine, place};
use super::frame::{Frame, HEIGHT, WIDTH};
use super::room::Room;
use crate::figure::{Anchor, Bounds, Drawing, FigureLabel, Path, Pen, Point, Weight};
use crate::math::Math;

/// Room between a label and a line.
const GAP: f64 = 0.06;
/// Distance of a label from the point that it names.
const NEAR: f64 = 0.13;
/// The same for the dot of a mark.
const AT_DOT: f64 = 0.21;
/// Distances with a hairline to the point.
const FAR: [f64; 6] = [0.5, 0.8, 1.2, 1.7, 2.3, 3.0];
/// Least distance of names at the right end.
const LINE: f64 = 0.46;
/// Distance that a name likes to have from other curves.
const ALONE: f64 = 0.3;

/// The name of a curve.
pub(crate) struct Named {
    pub(crate) curve: usize,
    pub(crate) label: Math,
    /// Whether it stands at the right end.
    pub(crate) is_at_end: bool,
}

/// Finds places for labels.
pub(crate) struct Letterer {
    /// The points of each line, by curve.
    lines: Vec<(usize, Vec<Vec<Point>>)>,
    /// What lines and dots take.
    room: Room,
    /// The boxes of labels.
    boxes: Vec<Bounds>,
    /// The hairlines from labels to what they name.
    leaders: Vec<(Point, Point)>,
}

/// A place for a label, and how bad it is.
struct LabelCandidate {
    cost: f64,
    at: Point,
    anchor: Anchor,
    leader: Option<Point>,
}

impl Letterer {
    pub(crate) fn of(
        frame: &Frame,
        lines: &[CurveLine],
        plot: &Plot<'_>,
        boxes: Vec<Bounds>,
    ) -> Self {
        let lines: Vec<_> = lines
            .iter()
            .map(|line| (line.curve, line.flat(frame)))
            .collect();
        let mut room = Room::of(Frame::bounds().grown(0.5));
        for (_, runs) in &lines {
            take(&mut room, runs);
        }
        take_axes(&mut room, frame, plot);
        for mark in &plot.marks {
            if let Some(at) = place(plot, mark.at).map(|at| frame.place(at)) {
                let half = Point::new(0.03, 0.03);
                room.take(at - half, at + half);
                room.take(at - half.left(), at + half.left());
            }
        }
        room.count();
        Self {
            lines,
            room,
            boxes,
            leaders: Vec::new(),
        }
    }

    /// Labels the marks.
    pub(crate) fn marks(&mut self, drawing: &mut Drawing, plot: &Plot<'_>, frame: &Frame) {
        for mark in &plot.marks {
            let Some((label, at)) = mark.label.as_ref().zip(place(plot, mark.at)) else {
                continue;
            };
            let (label, at) = (FigureLabel::of(label), frame.place(at));
            let near = directions()
                .map(|(direction, cost)| LabelCandidate::beside(at, direction, AT_DOT, cost));
            let far = FAR.iter().flat_map(|distance| {
                directions().chain(between()).map(move |(direction, cost)| {
                    LabelCandidate::beside(at, direction, *distance, cost + 10.0 * distance).led(at)
                })
            });
            let best = self.best(&label, near.chain(far));
            self.put(
                drawing,
                label,
                &best.unwrap_or_else(|| {
                    LabelCandidate::beside(at, Point::new(0.0, 1.0), AT_DOT, 0.0)
                }),
            );
        }
    }

    /// Names the curves.
    pub(crate) fn curves(&mut self, drawing: &mut Drawing, names: &[Named]) {
        let mut ends = Vec::new();
        for named in names {
            let label = FigureLabel::of(&named.label);
            if !named.is_at_end
                && let Some(candidate) = self.at_curve(&label, named.curve)
            {
                self.put(drawing, label, &candidate);
                continue;
            }
            if let Some(end) = self.end_of(named.curve) {
                ends.push((end, label));
            }
        }
        self.at_ends(drawing, ends);
    }

    /// The best place along a curve.
    fn at_curve(&self, label: &FigureLabel, curve: usize) -> Option<LabelCandidate> {
        let mut others = Room::of(Frame::bounds().grown(0.5));
        for (own, runs) in &self.lines {
            if *own != curve {
                take(&mut others, runs);
            }
        }
        others.count();
        let points = self.lines.iter().filter(|(own, _)| *own == curve);
        let points: Vec<Point> = points.flat_map(|(_, runs)| spaced(runs)).collect();
        let candidates = points.iter().flat_map(|at| {
            let others = &others;
            directions().map(move |(direction, cost)| {
                let mut candidate = LabelCandidate::beside(*at, direction, NEAR, cost);
                let around = candidate.bounds(label).grown(ALONE);
                candidate.cost += f64::from(others.taken(around).min(40)) * 0.25;
                candidate.cost += 3.0 * (at.x / WIDTH - 0.7).abs();
                candidate
            })
        });
        self.best(label, candidates)
    }

    /// The best free one of some places.
    fn best(
        &self,
        label: &FigureLabel,
        candidates: impl Iterator<Item = LabelCandidate>,
    ) -> Option<LabelCandidate> {
        let mut best: Option<LabelCandidate> = None;
        for candidate in candidates {
            let is_better = best.as_ref().is_none_or(|best| candidate.cost < best.cost);
            if is_better && self.is_free(candidate.bounds(label)) && self.leads(&candidate, label) {
                best = Some(candidate);
            }
        }
        best
    }

    fn is_free(&self, bounds: Bounds) -> bool {
        let space = Bounds::of(
            Point::new(0.05, 0.05),
            Point::new(WIDTH + 0.35, HEIGHT + 0.1),
        );
        let is_inside = space.has(bounds.low) && space.has(bounds.high);
        is_inside
            && self.room.taken(bounds.grown(GAP)) == 0
            && !self
                .boxes
                .iter()
                .any(|other| other.meets(bounds.grown(GAP)))
            && !self
                .leaders
                .iter()
                .any(|(from, to)| bounds.grown(GAP).chord(*from, *to).is_some())
    }

    /// Whether no label stands between a label and what it names.
    fn leads(&self, candidate: &LabelCandidate, label: &FigureLabel) -> bool {
        let Some((from, to)) = candidate.line(label) else {
            return true;
        };
        !self
            .boxes
            .iter()
            .any(|other| other.grown(GAP).chord(from, to).is_some())
    }

    fn put(&mut self, drawing: &mut Drawing, label: FigureLabel, candidate: &LabelCandidate) {
        if let Some((from, to)) = candidate.line(&label) {
            drawing.stroke(Path::line(from, to), Pen::new(Weight::Hair));
            self.leaders.push((from, to));
        }
        let bounds = drawing.text(label, candidate.at, candidate.anchor);
        self.boxes.push(bounds);
    }

    /// The last point of a curve.
    fn end_of(&self, curve: usize) -> Option<Point> {
        let lines = self.lines.iter().filter(|(own, _)| *own == curve);
        let ends = lines.filter_map(|(_, runs)| runs.last()?.last().copied());
        let (sum, count) = ends.fold((Point::default(), 0.0), |(sum, count), end| {
            (sum + end, count + 1.0)
        });
        (count > 0.0).then(|| sum * (1.0 / count))
    }

    /// Names outside of the frame, at the height where their curves end, moved apart where they are close.
    fn at_ends(&mut self, drawing: &mut Drawing, mut ends: Vec<(Point, FigureLabel)>) {
        crate::numerics::sort_by(&mut ends, |a, b| a.0.y.total_cmp(&b.0.y));
        let mut heights: Vec<f64> = ends.iter().map(|(end, _)| end.y).collect();
        spread(&mut heights);
        lift(&mut heights);
        for ((end, label), height) in ends.into_iter().zip(heights) {
            let is_moved = (height - end.y).abs() > 0.05 || end.x < WIDTH - 0.05;
            let start = if is_moved { WIDTH + 0.45 } else { WIDTH + 0.12 };
            let at = Point::new(start, height);
            if is_moved {
                let from = Point::new(end.x + 0.05, end.y);
                drawing.stroke(
                    Path::line(from, at - Point::new(0.08, 0.0)),
                    Pen::new(Weight::Hair),
                );
            }
            let bounds = drawing.text(label, at, Anchor::LEFT);
            self.boxes.push(bounds);
        }
    }
}

impl LabelCandidate {
    /// The place in a direction from a point.
    fn beside(point: Point, direction: Point, distance: f64, cost: f64) -> Self {
        Self {
            cost,
            at: point + direction * distance,
            anchor: Anchor::facing(direction),
            leader: None,
        }
    }

    /// With a hairline to a point.
    fn led(self, to: Point) -> Self {
        Self {
            leader: Some(to),
            ..self
        }
    }

    fn bounds(&self, label: &FigureLabel) -> Bounds {
        self.anchor.bounds(label, self.at)
    }

    /// The hairline from the label to what it names.
    fn line(&self, label: &FigureLabel) -> Option<(Point, Point)> {
        let to = self.leader?;
        let from = nearest(self.bounds(label).grown(0.03), to);
        Some((from, to + (from - to).unit() * 0.1))
    }
}

/// Directions from a point, with what tells against them.
fn directions() -> impl Iterator<Item = (Point, f64)> + Clone {
    // All directions have the length one, so that labels are as far off in each.
    const SLANT: f64 = std::f64::consts::FRAC_1_SQRT_2;
    const ALL: [(f64, f64, f64); 8] = [
        (SLANT, SLANT, 0.0),
        (-SLANT, SLANT, 0.2),
        (SLANT, -SLANT, 0.3),
        (-SLANT, -SLANT, 0.4),
        (0.0, 1.0, 0.1),
        (1.0, 0.0, 0.2),
        (0.0, -1.0, 0.3),
        (-1.0, 0.0, 0.4),
    ];
    ALL.iter().map(|(x, y, cost)| (Point::new(*x, *y), *cost))
}

/// The directions halfway between those.
fn between() -> impl Iterator<Item = (Point, f64)> + Clone {
    (0..8).map(|eighth| {
        let angle = (f64::from(eighth) + 0.5) * std::f64::consts::FRAC_PI_4;
        (Point::at_angle(angle), 0.5)
    })
}

/// Points of runs, no nearer than labels need.
fn spaced(runs: &[Vec<Point>]) -> Vec<Point> {
    // Less than the height of a letter, so that no label fits in between.
    const SPACE: f64 = 0.12;
    let mut points: Vec<Point> = Vec::new();
    for point in runs.iter().flatten() {
        if points
            .last()
            .is_none_or(|last| last.distance(*point) >= SPACE)
        {
            points.push(*point);
        }
    }
    points
}

fn take(room: &mut Room, runs: &[Vec<Point>]) {
    for pair in runs.iter().flat_map(|run| run.windows(2)) {
        room.take(pair[0], pair[1]);
    }
}

/// Takes the cells along the axes and the lines where a coordinate is zero.
fn take_axes(room: &mut Room, frame: &Frame, plot: &Plot<'_>) {
    let (right, top) = (Point::new(WIDTH + 0.4, 0.0), Point::new(0.0, HEIGHT + 0.4));
    room.take(Point::default(), right);
    room.take(Point::default(), top);
    let zero = frame.place([0.0, 0.0]);
    if !plot.y.is_logarithmic && (0.0..HEIGHT).contains(&zero.y) {
        room.take(Point::new(0.0, zero.y), Point::new(WIDTH, zero.y));
    }
    if !plot.x.is_logarithmic && (0.0..WIDTH).contains(&zero.x) {
        room.take(Point::new(zero.x, 0.0), Point::new(zero.x, HEIGHT));
    }
}

/// The point of a box that is nearest to another point.
fn nearest(bounds: Bounds, to: Point) -> Point {
    Point::new(
        to.x.clamp(bounds.low.x, bounds.high.x),
        to.y.clamp(bounds.low.y, bounds.high.y),
    )
}

/// Moves ascending heights apart, each as little as the others let it.
fn spread(heights: &mut [f64]) {
    let wanted = heights.to_vec();
    let mut start = 0;
    let mut groups: Vec<(usize, usize)> = Vec::new();
    while start < wanted.len() {
        groups.push((start, start + 1));
        start += 1;
        while let [.., first, second] = groups.as_slice() {
            let top = |(from, to): (usize, usize)| {
                middle(&wanted, from, to) + LINE * (to - from - 1) as f64 / 2.0
            };
            let bottom = |(from, to): (usize, usize)| {
                middle(&wanted, from, to) - LINE * (to - from - 1) as f64 / 2.0
            };
            if bottom(*second) - top(*first) >= LINE {
                break;
            }
            let joined = (first.0, second.1);
            groups.truncate(groups.len() - 2);
            groups.push(joined);
        }
    }
    for (from, to) in groups {
        let lowest = middle(&wanted, from, to) - LINE * (to - from - 1) as f64 / 2.0;
        for (place, height) in heights[from..to].iter_mut().enumerate() {
            *height = lowest + LINE * place as f64;
        }
    }
}

/// Moves heights up until none is beside what the axis to the right counts.
fn lift(heights: &mut [f64]) {
    let mut least = LINE;
    for height in heights {
        *height = height.max(least);
        least = *height + LINE;
    }
}

fn middle(heights: &[f64], from: usize, to: usize) -> f64 {
    heights[from..to].iter().sum::<f64>() / (to - from) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_at_the_end_are_moved_apart_and_no_further() {
        let mut heights = [1.0, 1.1, 4.0];
        spread(&mut heights);
        assert!((heights[1] - heights[0] - LINE).abs() < 1e-12);
        assert!((heights[0] + heights[1] - 2.1).abs() < 1e-12);
        assert_eq!(heights[2], 4.0);
        let mut many = [0.0; 5];
        spread(&mut many);
        assert!(
            many.windows(2)
                .all(|pair| (pair[1] - pair[0] - LINE).abs() < 1e-12)
        );
        lift(&mut many);
        assert_eq!(many[0], LINE);
    }
}
