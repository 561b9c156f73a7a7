//! A bar with mass between two points, with round ends, so that a pin at an end lies in it.
//!
//! ```toml
//! points = { O = [0.4, 1], E = [4, 1] }
//! elements = [{ bar = ["O", "E"], label = "m" }, { pin = "O", support = "left" }]
//! ```

use super::{Element, Layer, Role, Takes};
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Noun, Path, Spot, Weight, spots};
use std::f64::consts::{FRAC_PI_2, PI};

pub(crate) struct Bar;

/// Half of its breadth.
const HALF: f64 = 0.11;

impl Element for Bar {
    fn name(&self) -> &'static str {
        "bar"
    }

    fn takes(&self) -> Takes {
        Takes::Two
    }

    fn layer(&self) -> Layer {
        Layer::Body
    }

    fn role(&self) -> Role {
        Role::Link(Noun::BAR)
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (a, b) = (part.ends[0].point, part.ends[1].point);
        let angle = (b - a).angle();
        let across = (b - a).unit().left() * HALF;
        let path = Path::line(a - across, b - across)
            .arc_on(b, HALF, angle - FRAC_PI_2, angle + FRAC_PI_2)
            .line_to(a + across)
            .arc_on(a, HALF, angle + FRAC_PI_2, angle + FRAC_PI_2 + PI)
            .close();
        drawing.shape(path, Some(part.pen(Weight::Medium)), part.fill(Fill::Tint));
        drawing.keep_clear(a, b, HALF);
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        spots::beside(part.ends[0].point, part.ends[1].point, HALF, part.at)
    }
}
