//! A cord through points; a pulley or disk is passed clockwise as `"P cw"`, counterclockwise as `"P ccw"`.
//!
//! ```toml
//! points = { A = [1, 1.9], P = [3.6, 1.5], B = [4, 0.2] }
//! elements = [
//!   { block = "A", size = [1, 0.8] },
//!   { pulley = "P", radius = 0.4 },
//!   { cord = ["A.right", "P cw", "B"] },
//!   { block = "B", size = [0.9, 0.7], label = "m" },
//! ]
//! ```

use super::{Element, Layer, Role, Takes};
use crate::figure::outline::OutlineForm;
use crate::figure::part::{End, Part};
use crate::figure::{Drawing, Noun, Path, Point, Spot, Weight, spots};
use crate::numerics::asin;
use std::f64::consts::TAU;

pub(crate) struct Cord;

/// A point of the way, or a circle that it goes round.
#[derive(Clone, Copy)]
struct CordPoint {
    centre: Point,
    /// Positive counterclockwise, negative clockwise, zero for a point.
    radius: f64,
}

impl CordPoint {
    fn of(end: &End) -> Self {
        let round = match (end.pass, end.body.map(|body| body.form)) {
            (Some(is_left), Some(OutlineForm::Round { radius })) if is_left => radius,
            (Some(_), Some(OutlineForm::Round { radius })) => -radius,
            _ => 0.0,
        };
        Self {
            centre: end.point,
            radius: round,
        }
    }

    /// The straight piece that touches both.
    fn tangent(self, next: Self) -> (Point, Point) {
        let way = next.centre - self.centre;
        let sine = (next.radius - self.radius) / way.length().max(1e-9);
        let unit = Point::at_angle(way.angle() - asin(sine.clamp(-1.0, 1.0)));
        let right = -unit.left();
        (
            self.centre + right * self.radius,
            next.centre + right * next.radius,
        )
    }
}

/// The straight pieces of a cord, and the circles between them.
fn pieces(part: &Part<'_>) -> Vec<(Point, Point)> {
    let nodes: Vec<CordPoint> = part.ends.iter().map(CordPoint::of).collect();
    let mut pieces: Vec<(Point, Point)> = nodes
        .windows(2)
        .map(|pair| pair[0].tangent(pair[1]))
        .collect();
    let last = pieces.len() - 1;
    let (first, end) = (&part.ends[0], &part.ends[last + 1]);
    if first.pass.is_none() {
        pieces[0].0 = first.trimmed(pieces[0].1, pieces[0].0, false);
    }
    if end.pass.is_none() {
        pieces[last].1 = end.trimmed(pieces[last].0, pieces[last].1, false);
    }
    pieces
}

impl Element for Cord {
    fn name(&self) -> &'static str {
        "cord"
    }

    fn takes(&self) -> Takes {
        Takes::Way
    }

    fn layer(&self) -> Layer {
        Layer::Link
    }

    fn role(&self) -> Role {
        Role::Link(Noun::CORD)
    }

    fn pieces(&self, part: &Part<'_>) -> Vec<(Point, Point)> {
        pieces(part)
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let pieces = pieces(part);
        let mut path = Path::line(pieces[0].0, pieces[0].1);
        for (place, pair) in pieces.windows(2).enumerate() {
            let node = CordPoint::of(&part.ends[place + 1]);
            let (arrive, leave) = (pair[0].1 - node.centre, pair[1].0 - node.centre);
            if node.radius != 0.0 {
                let from = arrive.angle();
                let mut turn = leave.angle() - from;
                if node.radius > 0.0 && turn < -1e-6 {
                    turn += TAU;
                } else if node.radius < 0.0 && turn > 1e-6 {
                    turn -= TAU;
                }
                path = path.arc_on(node.centre, node.radius.abs(), from, from + turn);
            }
            path = path.line_to(pair[1].1);
        }
        drawing.stroke(path, part.pen(Weight::Medium));
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let pieces = pieces(part);
        let longest = pieces
            .iter()
            .max_by(|a, b| a.0.distance(a.1).total_cmp(&b.0.distance(b.1)));
        longest.map_or(Vec::new(), |(a, b)| spots::beside(*a, *b, 0.03, part.at))
    }
}
