//! Lines of a drawing: straight, curved, along circles.

use std::f64::consts::{PI, TAU};

use super::{Bounds, Point};

/// A line of a drawing, in figure units.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Path {
    steps: Vec<PathStep>,
}

/// One step of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum PathStep {
    /// Begins anew at a point.
    Move(Point),
    /// Straight to a point.
    Line(Point),
    /// By a cubic curve with two control points to a point.
    Curve(Point, Point, Point),
    /// Along a circle, from the first angle to the second, in radians; less than a whole turn.
    Arc {
        centre: Point,
        radius: f64,
        from: f64,
        to: f64,
    },
    /// Straight back to where the line began.
    Close,
}

impl Path {
    /// A line without a step yet.
    pub const fn new() -> Self {
        Self { steps: Vec::new() }
    }

    /// The straight line between two points.
    pub fn line(a: Point, b: Point) -> Self {
        Self::new().move_to(a).line_to(b)
    }

    /// Straight lines through points.
    pub fn through(points: impl IntoIterator<Item = Point>) -> Self {
        let mut points = points.into_iter();
        let start = points
            .next()
            .map_or(Self::new(), |start| Self::new().move_to(start));
        points.fold(start, Self::line_to)
    }

    /// The closed line through corners.
    pub(crate) fn polygon(corners: impl IntoIterator<Item = Point>) -> Self {
        Self::through(corners).close()
    }

    /// A closed circle, run counterclockwise from its rightmost point.
    pub fn circle(centre: Point, radius: f64) -> Self {
        Self::new()
            .move_to(centre + Point::new(radius, 0.0))
            .arc_on(centre, radius, 0.0, PI)
            .arc_on(centre, radius, PI, TAU)
            .close()
    }

    /// A part of a circle, from one angle to another, in radians.
    pub fn arc(centre: Point, radius: f64, from: f64, to: f64) -> Self {
        let start = centre + Point::at_angle(from) * radius;
        Self::new().move_to(start).arc_on(centre, radius, from, to)
    }

    /// Begins anew at a point.
    #[must_use]
    pub(crate) fn move_to(mut self, to: Point) -> Self {
        self.steps.push(PathStep::Move(to));
        self
    }

    /// Goes straight to a point.
    #[must_use]
    pub(crate) fn line_to(mut self, to: Point) -> Self {
        self.steps.push(PathStep::Line(to));
        self
    }

    /// Goes to a point by a cubic curve.
    #[must_use]
    pub(crate) fn curve_to(mut self, first: Point, second: Point, to: Point) -> Self {
        self.steps.push(PathStep::Curve(first, second, to));
        self
    }

    /// Goes along a circle, from one angle to another, in radians; more than half a turn is cut in two.
    #[must_use]
    pub(crate) fn arc_on(mut self, centre: Point, radius: f64, from: f64, to: f64) -> Self {
        let arc = |from, to| PathStep::Arc {
            centre,
            radius,
            from,
            to,
        };
        // By its ends and its sense an arc is known up to half a turn; the hundredth is for rounding.
        if (to - from).abs() > 1.01 * PI {
            let middle = f64::midpoint(from, to);
            self.steps.extend([arc(from, middle), arc(middle, to)]);
        } else {
            self.steps.push(arc(from, to));
        }
        self
    }

    /// Goes straight back to where it began.
    #[must_use]
    pub fn close(mut self) -> Self {
        self.steps.push(PathStep::Close);
        self
    }

    /// Appends another line.
    #[must_use]
    pub fn and(mut self, other: Self) -> Self {
        self.steps.extend(other.steps);
        self
    }

    /// The line with each point at another place, turned by an angle in radians on the way.
    pub(crate) fn mapped(&self, place: impl Fn(Point) -> Point, turn: f64) -> Self {
        let steps = self.steps.iter().map(|step| match *step {
            PathStep::Move(to) => PathStep::Move(place(to)),
            PathStep::Line(to) => PathStep::Line(place(to)),
            PathStep::Curve(first, second, to) => {
                PathStep::Curve(place(first), place(second), place(to))
            }
            PathStep::Arc {
                centre,
                radius,
                from,
                to,
            } => PathStep::Arc {
                centre: place(centre),
                radius,
                from: from + turn,
                to: to + turn,
            },
            PathStep::Close => PathStep::Close,
        });
        Self {
            steps: steps.collect(),
        }
    }

    /// Whether it has no step.
    pub fn is_empty(&self) -> bool {
        self.steps.is_empty()
    }

    pub(crate) fn steps(&self) -> &[PathStep] {
        &self.steps
    }

    /// Visits straight pieces that follow the line to within a fiftieth of a millimetre at the usual sizes.
    pub fn for_each_segment(&self, mut visit: impl FnMut(Point, Point)) {
        let (mut start, mut at) = (Point::default(), Point::default());
        for step in &self.steps {
            match *step {
                PathStep::Move(to) => (start, at) = (to, to),
                PathStep::Line(to) => {
                    visit(at, to);
                    at = to;
                }
                PathStep::Curve(first, second, to) => {
                    // Chords serve to keep labels clear, not to draw: a few are enough.
                    const PIECES: usize = 6;
                    let from = at;
                    for piece in 1..=PIECES {
                        let next = cubic(from, first, second, to, piece as f64 / PIECES as f64);
                        visit(at, next);
                        at = next;
                    }
                }
                PathStep::Arc {
                    centre,
                    radius,
                    from,
                    to,
                } => {
                    // Chords that leave the circle by at most a hundredth of a unit.
                    let chord = (0.28 / radius.max(0.05).sqrt()).max(0.06);
                    let pieces = ((to - from).abs() / chord).ceil().max(1.0);
                    for piece in 1..=pieces as usize {
                        let angle = from + (to - from) * piece as f64 / pieces;
                        let next = centre + Point::at_angle(angle) * radius;
                        visit(at, next);
                        at = next;
                    }
                }
                PathStep::Close => {
                    visit(at, start);
                    at = start;
                }
            }
        }
    }

    /// The box around it, with the control points of its curves.
    pub fn bounds(&self) -> Bounds {
        let mut bounds = Bounds::NOTHING;
        for step in &self.steps {
            bounds = match *step {
                PathStep::Move(to) | PathStep::Line(to) => bounds.with(to),
                PathStep::Curve(first, second, to) => bounds.with(first).with(second).with(to),
                PathStep::Close => bounds,
                PathStep::Arc {
                    centre,
                    radius,
                    from,
                    to,
                } => {
                    let at = |angle: f64| centre + Point::at_angle(angle) * radius;
                    let (low, high) = (from.min(to), from.max(to));
                    let quarter = std::f64::consts::FRAC_PI_2;
                    let (first, last) = ((low / quarter).ceil(), (high / quarter).floor());
                    let ends = bounds.with(at(from)).with(at(to));
                    let extremes = (first as i64..=last as i64).take(5);
                    extremes.fold(ends, |bounds, turn| bounds.with(at(turn as f64 * quarter)))
                }
            };
        }
        bounds
    }
}

/// The point of a cubic curve at a share of its parameter.
fn cubic(a: Point, b: Point, c: Point, d: Point, share: f64) -> Point {
    let rest = 1.0 - share;
    a * (rest * rest * rest)
        + b * (3.0 * rest * rest * share)
        + c * (3.0 * rest * share * share)
        + d * (share * share * share)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_circle_has_its_box() {
        let bounds = Path::circle(Point::new(1.0, 2.0), 0.5).bounds();
        assert!((bounds.width() - 1.0).abs() < 1e-2 && (bounds.height() - 1.0).abs() < 1e-2);
        assert!(bounds.centre().distance(Point::new(1.0, 2.0)) < 1e-2);
    }

    #[test]
    fn a_long_arc_is_cut() {
        let arc = Path::arc(Point::default(), 1.0, 0.0, 1.9 * PI);
        assert_eq!(arc.steps().len(), 3);
    }
}
