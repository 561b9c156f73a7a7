//! A capacitor between two points.
//!
//! ```toml
//! elements = [{ capacitor = ["[0, 0]", "[2.4, 0]"], label = "C" }]
//! ```

use super::resistor::middle;
use super::{Element, Layer, Role, Takes};
use crate::figure::part::Part;
use crate::figure::{Drawing, Path, Spot, Weight, spots};

pub(super) struct Capacitor;

const HALF: f64 = 0.3;

impl Element for Capacitor {
    fn name(&self) -> &'static str {
        "capacitor"
    }

    fn takes(&self) -> Takes {
        Takes::Two
    }

    fn layer(&self) -> Layer {
        Layer::Link
    }

    fn role(&self) -> Role {
        Role::Link("capacitor")
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (a, b) = part.link();
        let (from, to) = middle(a, b, 0.2);
        let across = (b - a).unit().left() * HALF;
        let leads = Path::line(a, from).and(Path::line(to, b));
        drawing.stroke(leads, part.pen(Weight::Medium));
        for plate in [from, to] {
            let path = Path::line(plate + across, plate - across);
            drawing.stroke(path, part.pen(Weight::Bold));
        }
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (a, b) = part.link();
        spots::beside(a, b, HALF, part.at)
    }
}
