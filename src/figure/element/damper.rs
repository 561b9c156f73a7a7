//! A dashpot between two points: the cylinder at the first, the piston rod to the second.
//!
//! ```toml
//! points = { W = [0, 1], B = [4, 1] }
//! elements = [
//!   { ground = ["[0, 2]", "[0, 0]"] },
//!   { spring = ["W", "B"], label = "k" },
//!   { damper = ["W", "B"], label = "c" },
//!   { block = "B", size = [1.4, 2], label = "m" },
//! ]
//! ```

use super::{Element, Layer, Role, Takes};
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Noun, Path, Spot, Weight, spots};

pub(crate) struct Damper;

/// Half of the breadth of the cylinder.
const HALF: f64 = 0.2;

/// What the line and its roundings reach beyond this.
const LINE: f64 = 0.04;

/// The length at rest of one that is stretched.
const REST: &str = "length at rest";

/// Longest cylinder.
const MAX_LENGTH: f64 = 0.9;

impl Element for Damper {
    fn name(&self) -> &'static str {
        "damper"
    }

    fn takes(&self) -> Takes {
        Takes::Two
    }

    fn layer(&self) -> Layer {
        Layer::Link
    }

    fn role(&self) -> Role {
        Role::Link(Noun::new("damper", "un amortisseur"))
    }

    fn spreads(&self) -> bool {
        true
    }

    fn kept(&self, part: &Part<'_>) -> Option<(&'static str, f64)> {
        let (a, b) = part.working();
        Some((REST, a.distance(b)))
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (a, b) = part.working();
        let along = (b - a).unit();
        let length = a.distance(b);
        let rest = part.number(REST).unwrap_or(length);
        let cylinder = (0.5 * rest).min(MAX_LENGTH);
        let bottom = (rest - cylinder) / 2.0;
        // One that is pressed together stays within its ends.
        let cylinder = if length < rest {
            cylinder.min((length - bottom - 0.05).max(0.15))
        } else {
            cylinder
        };
        let across = along.left() * HALF;
        let at = |distance: f64| a + along * distance;
        // The cylinder goes with the first end, the piston with the other one, as far as there is room for it.
        let piston = bottom + 0.5 * cylinder;
        let piston = if length == rest {
            piston
        } else {
            (piston + length - rest).clamp(bottom + 0.06, bottom + cylinder - 0.06)
        };
        let pen = part.pen(Weight::Medium);
        let walls = Path::through([
            at(bottom + cylinder) + across,
            at(bottom) + across,
            at(bottom) - across,
            at(bottom + cylinder) - across,
        ]);
        let plate = Path::line(at(piston) + across * 0.8, at(piston) - across * 0.8);
        let rods = Path::line(a, at(bottom)).and(Path::line(at(piston), b));
        drawing.decorate(rods.and(walls), Some(pen), Fill::None);
        drawing.decorate(plate, Some(part.pen(Weight::Heavy)), Fill::None);
        drawing.stroke(part.leads(), pen);
        drawing.keep_clear(at(bottom), at(bottom + cylinder), HALF);
        drawing.keep_clear(a, b, pen.width() / 2.0);
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (a, b) = part.working();
        spots::beside(a, b, HALF + LINE, part.at)
    }
}
