//! Floor, wall or ceiling: a line between two points, hatched on the right of the way from the first to the second.
//!
//! A floor goes from left to right, a ceiling from right to left; a wall goes down if it stands left of the system.
//! `rough = true` gives it teeth, `smooth = true` a polished plate.
//!
//! ```toml
//! elements = [
//!   { ground = ["[0, 1.6]", "[0, 0]"] },
//!   { ground = ["[0, 0]", "[3, 0]"], rough = true },
//!   { ground = ["[4, 0]", "[7, 0]"], smooth = true },
//! ]
//! ```

use super::{Element, ElementKey, Layer, Role, Takes, flag};
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Path, Point, Spot, Weight, spots};

pub(crate) struct Ground;

/// How deep the hatching goes.
pub(crate) const DEPTH: f64 = 0.24;

/// From one stroke of the hatching to the next.
const PITCH: f64 = 0.2;

/// Height of the teeth of a rough surface.
const TEETH: f64 = 0.06;

/// Thickness of the plate of a smooth one.
const PLATE: f64 = 0.07;

impl Element for Ground {
    fn name(&self) -> &'static str {
        "ground"
    }

    fn takes(&self) -> Takes {
        Takes::Two
    }

    fn keys(&self) -> &'static [ElementKey] {
        const { &[flag("rough"), flag("smooth")] }
    }

    fn layer(&self) -> Layer {
        Layer::Support
    }

    fn role(&self) -> Role {
        Role::Ground
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (a, b) = (part.ends[0].point, part.ends[1].point);
        let top = if part.is("rough") {
            teeth(part, a, b, drawing);
            TEETH
        } else if part.is("smooth") {
            plate(part, a, b, drawing);
            PLATE
        } else {
            0.0
        };
        drawing.decorate(Path::line(a, b), Some(part.pen(Weight::Bold)), Fill::None);
        hatch(part, a, b, top, drawing);
        let out = -(b - a).unit().left() * (DEPTH / 2.0);
        drawing.keep_clear(a + out, b + out, DEPTH / 2.0);
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (a, b) = (part.ends[0].point, part.ends[1].point);
        let mut spots = spots::beside(a, b, DEPTH, part.at);
        // The hatched side is the outside.
        let out = -(b - a).unit().left();
        crate::numerics::sort_by_key(&mut spots, |spot| (spot.at - a).dot(out) < 0.0);
        spots
    }
}

/// Slanted strokes from the surface, or from this depth below it.
pub(crate) fn hatch(part: &Part<'_>, a: Point, b: Point, top: f64, drawing: &mut Drawing) {
    let along = (b - a).unit();
    let out = -along.left();
    let length = a.distance(b).min(200.0);
    let depth = DEPTH - top;
    let count = ((length - depth) / PITCH).floor().max(1.0);
    let pitch = (length - depth).max(0.0) / count;
    let mut strokes = Path::new();
    for stroke in 0..=count as usize {
        let start = a + along * (depth + stroke as f64 * pitch).min(length) + out * top;
        strokes = strokes.and(Path::line(start, start + (out - along) * depth));
    }
    drawing.decorate(strokes, Some(part.pen(Weight::Hair)), Fill::None);
}

fn teeth(part: &Part<'_>, a: Point, b: Point, drawing: &mut Drawing) {
    let out = -(b - a).unit().left() * TEETH;
    let count = (a.distance(b) / 0.12).round().clamp(2.0, 1000.0) as usize;
    let path = Path::through((0..=count).map(|place| {
        let base = a.towards(b, place as f64 / count as f64);
        if place % 2 == 1 { base + out } else { base }
    }));
    drawing.decorate(path, Some(part.pen(Weight::Thin)), Fill::None);
}

fn plate(part: &Part<'_>, a: Point, b: Point, drawing: &mut Drawing) {
    let out = -(b - a).unit().left() * PLATE;
    let path = Path::line(a + out, b + out);
    drawing.decorate(path, Some(part.pen(Weight::Hair)), Fill::None);
}
