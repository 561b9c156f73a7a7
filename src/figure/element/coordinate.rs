//! A coordinate and its positive direction: the key holds its symbol, `from` the point that moves.
//!
//! It is drawn from a line of reference; at a side of a body that the direction runs along, the line leads out of the body.
//!
//! ```toml
//! points = { B = [1.4, 0.6] }
//! elements = [
//!   { ground = ["[0, 0]", "[4, 0]"], smooth = true },
//!   { block = "B", size = [1.6, 1.2], label = "m" },
//!   { coordinate = "x", from = "B.top", direction = [1, 0] },
//! ]
//! ```

use super::{Element, ElementKey, FROM, Layer, Role, Takes, vector};
use crate::figure::arrow::{ArrowHead, arrow};
use crate::figure::part::Part;
use crate::figure::{Drawing, Path, Point, Spot, Weight, spots};

pub(crate) struct Coordinate;

/// Length of an arrow of direction 1.
const LENGTH: f64 = 0.9;

/// Length of the line that leads out of a body.
const LEADER: f64 = 0.55;

/// How far along that line the arrow begins.
const ALONG: f64 = 0.36;

/// The line of reference, and the arrow.
fn lines(part: &Part<'_>) -> [(Point, Point); 2] {
    let end = &part.ends[0];
    let out = end.out.unwrap_or_default();
    let direction = part.vector("direction").unwrap_or(if end.out.is_some() {
        out
    } else {
        Point::new(1.0, 0.0)
    });
    let way = direction * LENGTH;
    let unit = direction.unit();
    if out.length() > 0.0 && out.dot(unit).abs() < 0.5 {
        let from = end.point + out * 0.08;
        let start = from + out * ALONG;
        return [(from, from + out * LEADER), (start, start + way)];
    }
    let gap = if end.out.is_some() { 0.2 } else { 0.0 };
    let start = end.point + unit * gap;
    let across = unit.left() * 0.2;
    [(start - across, start + across), (start, start + way)]
}

impl Element for Coordinate {
    fn name(&self) -> &'static str {
        "coordinate"
    }

    fn takes(&self) -> Takes {
        Takes::Label
    }

    fn keys(&self) -> &'static [ElementKey] {
        const { &[vector("direction"), FROM] }
    }

    fn layer(&self) -> Layer {
        Layer::Mark
    }

    fn role(&self) -> Role {
        Role::Measure
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let [reference, (from, to)] = lines(part);
        drawing.stroke(Path::line(reference.0, reference.1), part.pen(Weight::Thin));
        arrow(drawing, from, to, part.pen(Weight::Thin), ArrowHead::USUAL);
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let [_, (from, to)] = lines(part);
        spots::at_tip(from, to, part.at)
    }
}
