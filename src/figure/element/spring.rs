//! A coil spring between two points, in any direction; `coils` counts its turns.
//!
//! With `around`, a centre, it lies along the arc about it, counterclockwise from the first point to the second.
//! Several springs and dampers between the same two points are spread evenly.
//!
//! ```toml
//! points = { O = [6, 0], P = [5, 0.9] }
//! elements = [
//!   { spring = ["[0, 0.5]", "[3, 0.5]"], label = "k" },
//!   { spring = ["[7.2, 0]", "[6, 1.2]"], around = "O", label = "kappa" },
//! ]
//! ```

use super::{Element, ElementKey, Holds, Layer, Role, Takes, number};
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Noun, Path, Point, Spot, Weight, spots};
use crate::numerics::sin_cos;

pub(crate) struct Spring;

/// Half of the breadth of the coils.
const RADIUS: f64 = 0.2;

/// What the line and its roundings reach beyond this.
const LINE: f64 = 0.04;

/// Advance of a turn.
const PITCH: f64 = 0.23;

/// How far the loops lean, as a share of their radius.
const LEAN: f64 = 0.5;

/// Straight length at each end.
const LEAD: f64 = 0.22;

/// The middle line of a spring: straight or an arc.
enum Axis {
    Straight {
        start: Point,
        along: Point,
    },
    Arc {
        centre: Point,
        radius: f64,
        from: f64,
    },
}

impl Axis {
    fn of(part: &Part<'_>) -> (Self, f64) {
        if let Some(centre) = part.vector("around") {
            let (start, end) = (part.ends[0].point - centre, part.ends[1].point - centre);
            let turn = crate::numerics::atan2(start.cross(end), start.dot(end));
            let turn = if turn <= 0.0 {
                turn + std::f64::consts::TAU
            } else {
                turn
            };
            let radius = start.length();
            // Balls at the ends shorten it.
            let [first, last] = [0, 1].map(|end: usize| {
                let ball = part.ends[end].body.map(|body| body.bounds().width() / 2.0);
                ball.unwrap_or(0.0)
            });
            let axis = Self::Arc {
                centre,
                radius,
                from: start.angle() + first / radius.max(0.1),
            };
            return (axis, (radius * turn - first - last).max(0.1));
        }
        let (a, b) = part.working();
        let along = (b - a).unit();
        (Self::Straight { start: a, along }, a.distance(b))
    }

    /// The point so far along the line and so far to its left.
    fn at(&self, along: f64, left: f64) -> Point {
        match *self {
            Self::Straight { start, along: unit } => start + unit * along + unit.left() * left,
            Self::Arc {
                centre,
                radius,
                from,
            } => centre + Point::at_angle(from + along / radius.max(1e-3)) * (radius - left),
        }
    }
}

/// The turns of a helix, seen from the side: each quarter as a cubic curve with its ends and tangents.
///
/// Half a turn more than is counted makes both ends alike: the loops lean one way, so that after whole turns the last one
/// would hang over the end.
fn coils(axis: &Axis, length: f64, turns: usize) -> Path {
    let lead = LEAD.min(0.2 * length);
    let span = length - 2.0 * lead;
    let radius = RADIUS.min(0.35 * length);
    let lean = LEAN * radius;
    let pitch = (span - 2.0 * lean) / (turns as f64 + 0.5);
    let quarters = 4 * turns + 2;
    let step = std::f64::consts::FRAC_PI_2;
    let place = |sine: f64, cosine: f64, turned: f64| {
        let along = lead + pitch * turned + lean * (1.0 - cosine);
        (along, radius * sine)
    };
    let tangent = |sine: f64, cosine: f64| {
        let along = pitch / std::f64::consts::TAU + lean * sine;
        (along * step / 3.0, radius * cosine * step / 3.0)
    };
    let mut path = Path::line(axis.at(0.0, 0.0), axis.at(lead, 0.0));
    for quarter in 0..quarters {
        let (share, next) = (quarter as f64 / 4.0, (quarter + 1) as f64 / 4.0);
        let (s0, c0) = sin_cos(share * std::f64::consts::TAU);
        let (s1, c1) = sin_cos(next * std::f64::consts::TAU);
        let ((x0, y0), (dx0, dy0)) = (place(s0, c0, share), tangent(s0, c0));
        let ((x1, y1), (dx1, dy1)) = (place(s1, c1, next), tangent(s1, c1));
        path = path.curve_to(
            axis.at(x0 + dx0, y0 + dy0),
            axis.at(x1 - dx1, y1 - dy1),
            axis.at(x1, y1),
        );
    }
    path.line_to(axis.at(length, 0.0))
}

/// How many turns it has: as many as fit, if it does not say it.
fn turns(part: &Part<'_>, length: f64) -> f64 {
    let fitting = ((length - 2.0 * LEAD) / PITCH).round().clamp(3.0, 40.0);
    let turns = part.number("coils").unwrap_or(fitting);
    turns.round().clamp(1.0, 60.0)
}

impl Element for Spring {
    fn name(&self) -> &'static str {
        "spring"
    }

    fn takes(&self) -> Takes {
        Takes::Two
    }

    fn keys(&self) -> &'static [ElementKey] {
        const {
            &[
                number("coils"),
                ElementKey {
                    name: "around",
                    holds: Holds::Point,
                },
            ]
        }
    }

    fn layer(&self) -> Layer {
        Layer::Link
    }

    fn role(&self) -> Role {
        Role::Link(Noun::new("spring", "un ressort"))
    }

    fn spreads(&self) -> bool {
        true
    }

    fn kept(&self, part: &Part<'_>) -> Option<(&'static str, f64)> {
        Some(("coils", turns(part, Axis::of(part).1)))
    }

    fn pieces(&self, part: &Part<'_>) -> Vec<(Point, Point)> {
        let Some(centre) = part.vector("around") else {
            return vec![part.link()];
        };
        // It pulls along the tangent at each of its ends.
        let (_, length) = Axis::of(part);
        let tangent = |end: usize, sign: f64| {
            let end = &part.ends[end];
            let along = (end.point - centre).unit().left() * sign;
            let ball = end.body.map_or(0.0, |body| body.bounds().width() / 2.0);
            (
                end.point + along * ball,
                end.point + along * (ball + length / 2.0),
            )
        };
        let (first, last) = (tangent(0, 1.0), tangent(1, -1.0));
        vec![first, (last.1, last.0)]
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (axis, length) = Axis::of(part);
        let path = coils(&axis, length, turns(part, length) as usize);
        drawing.decorate(path, Some(part.pen(Weight::Medium)), Fill::None);
        drawing.stroke(part.leads(), part.pen(Weight::Medium));
        // A capsule of this radius reaches beyond its ends by as much.
        let (first, last) = (
            RADIUS.min(length / 2.0),
            (length - RADIUS).max(length / 2.0),
        );
        let pieces = if matches!(axis, Axis::Straight { .. }) {
            1
        } else {
            8
        };
        for piece in 0..pieces {
            let at =
                |piece: usize| axis.at(first + (last - first) * piece as f64 / pieces as f64, 0.0);
            drawing.keep_clear(at(piece), at(piece + 1), RADIUS);
        }
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (axis, length) = Axis::of(part);
        match axis {
            Axis::Straight { .. } => {
                let (a, b) = part.working();
                spots::beside(a, b, RADIUS + LINE, part.at)
            }
            Axis::Arc { centre, .. } => {
                let mut spots = Vec::new();
                for share in [0.5, 0.4, 0.6, 0.3, 0.7] {
                    let at = axis.at(length * share, 0.0);
                    spots.extend(spots::off(at, at - centre, RADIUS + LINE));
                }
                spots
            }
        }
    }
}
