//! The distance of two points: an arrow at both ends, moved by `offset` to the left of the way, with lines of extension.
//!
//! ```toml
//! points = { A = [0, 1], B = [3, 1] }
//! elements = [{ bar = ["A", "B"] }, { dimension = ["A", "B"], offset = -0.7, label = "L" }]
//! ```

use super::{Element, ElementKey, Layer, Role, Takes, number};
use crate::figure::arrow::{ArrowHead, arrow, double};
use crate::figure::part::Part;
use crate::figure::{Anchor, Drawing, Path, Point, Spot, Weight, spots};

pub(crate) struct Dimension;

/// Shortest distance whose arrows point outward from within.
const MIN_LENGTH: f64 = 0.45;

fn ends(part: &Part<'_>) -> (Point, Point) {
    let (a, b) = (part.ends[0].point, part.ends[1].point);
    let shift = (b - a).unit().left() * part.number("offset").unwrap_or(0.0).clamp(-50.0, 50.0);
    (a + shift, b + shift)
}

impl Element for Dimension {
    fn name(&self) -> &'static str {
        "dimension"
    }

    fn takes(&self) -> Takes {
        Takes::Two
    }

    fn keys(&self) -> &'static [ElementKey] {
        const { &[number("offset")] }
    }

    fn layer(&self) -> Layer {
        Layer::Mark
    }

    fn role(&self) -> Role {
        Role::Measure
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (a, b) = ends(part);
        let pen = part.pen(Weight::Hair);
        for (end, foot) in part.ends.iter().zip([a, b]) {
            let way = foot - end.point;
            if way.length() > 0.15 {
                let unit = way.unit();
                drawing.stroke(Path::line(end.point + unit * 0.08, foot + unit * 0.1), pen);
            } else {
                let across = (b - a).unit().left() * 0.1;
                drawing.stroke(Path::line(foot - across, foot + across), pen);
            }
        }
        if a.distance(b) >= MIN_LENGTH {
            double(drawing, a, b, pen);
        } else {
            let along = (b - a).unit() * 0.4;
            arrow(drawing, a - along, a, pen, ArrowHead::SLIM);
            arrow(drawing, b + along, b, pen, ArrowHead::SLIM);
        }
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (a, b) = ends(part);
        let across = (b - a).unit().left();
        let outward = part.number("offset").unwrap_or(0.0);
        let upward = if across.y.abs() > 0.3 {
            across.y.signum()
        } else {
            -across.x.signum()
        };
        let normal = across
            * if outward == 0.0 || across.y.abs() > 0.3 {
                upward
            } else {
                outward.signum()
            };
        let mut spots = Vec::new();
        if part.at.is_none() {
            for share in [0.5, 0.4, 0.6, 0.3, 0.7] {
                let at = a.towards(b, share) + normal * 0.09;
                spots.push(Spot::new(at, Anchor::facing(normal)));
            }
        }
        spots.extend(spots::beside(a, b, 0.02, part.at));
        spots.extend(spots::off(b, b - a, 0.35));
        spots
    }
}
