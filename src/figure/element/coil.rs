//! A coil (inductance) between two points.
//!
//! ```toml
//! elements = [{ coil = ["[0, 0]", "[2.4, 0]"], label = "L" }]
//! ```

use super::family::middle;
use super::{Element, Layer, Role, Takes};
use crate::figure::part::Part;
use crate::figure::{Drawing, Noun, Path, Spot, Weight, spots};
use std::f64::consts::PI;

pub(crate) struct Coil;

const TURNS: usize = 4;

impl Element for Coil {
    fn name(&self) -> &'static str {
        "coil"
    }

    fn takes(&self) -> Takes {
        Takes::Two
    }

    fn layer(&self) -> Layer {
        Layer::Link
    }

    fn role(&self) -> Role {
        Role::Link(Noun::new("coil", "une bobine"))
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (a, b) = part.link();
        let (from, to) = middle(a, b, 1.2);
        let radius = from.distance(to) / (2.0 * TURNS as f64);
        let start = (a - b).angle();
        let mut path = Path::line(a, from);
        for turn in 0..TURNS {
            let centre = from.towards(to, (2 * turn + 1) as f64 / (2 * TURNS) as f64);
            path = path.arc_on(centre, radius, start, start - PI);
        }
        drawing.stroke(path.line_to(b), part.pen(Weight::Medium));
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (a, b) = part.link();
        spots::beside(a, b, 0.16, part.at)
    }
}
