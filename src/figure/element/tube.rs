//! A U-tube with liquid: its point is the middle of the lowest part of the bore, `width` the distance of the
//! arms, `level` the height of the liquid above the point.
//!
//! ```toml
//! elements = [{ tube = [2, 0], width = 2.4, level = 1.6 }]
//! ```

use super::{Element, ElementKey, Layer, Role, number};
use crate::figure::part::Part;
use crate::figure::{Bounds, Drawing, Fill, Noun, Path, Point, Spot, Weight, spots};
use std::f64::consts::PI;

pub(crate) struct Tube;

/// Half of the bore.
const BORE: f64 = 0.25;

/// Length of the arms above the liquid.
const ABOVE: f64 = 0.9;

/// A U between the arms at this distance from the middle line of the bore: from the top of the left arm to that
/// of the right one.
fn bend(low: Point, half: f64, offset: f64, top: f64) -> Path {
    let radius = (half * 0.6).min(0.8);
    let at = |x: f64, y: f64| low + Point::new(x, y);
    let (outer, curve) = (half + offset, (radius + offset).max(0.02));
    Path::line(at(-outer, top), at(-outer, radius))
        .arc_on(at(radius - half, radius), curve, PI, 1.5 * PI)
        .line_to(at(half - radius, -offset))
        .arc_on(at(half - radius, radius), curve, 1.5 * PI, 2.0 * PI)
        .line_to(at(outer, top))
}

impl Element for Tube {
    fn name(&self) -> &'static str {
        "tube"
    }

    fn keys(&self) -> &'static [ElementKey] {
        const { &[number("width"), number("level")] }
    }

    fn layer(&self) -> Layer {
        Layer::Body
    }

    fn role(&self) -> Role {
        Role::Thing(Noun::new(
            "U-tube with liquid",
            "un tube en U rempli de liquide",
        ))
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let half = part.length("width", 2.4) / 2.0;
        let level = part.length("level", 1.6);
        let low = part.point();
        let outer = bend(low, half, BORE, level);
        let at = |x: f64, y: f64| low + Point::new(x, y);
        let radius = (half * 0.6).min(0.8);
        let curve = (radius - BORE).max(0.02);
        let liquid = outer
            .line_to(at(half - BORE, level))
            .line_to(at(half - BORE, radius))
            .arc_on(at(half - radius, radius), curve, 0.0, -0.5 * PI)
            .line_to(at(radius - half, BORE))
            .arc_on(at(radius - half, radius), curve, -0.5 * PI, -PI)
            .line_to(at(BORE - half, level))
            .close();
        drawing.decorate(liquid, None, part.fill(Fill::Shade));
        let pen = part.pen(Weight::Bold);
        let top = level + ABOVE;
        drawing.stroke(bend(low, half, BORE, top), pen);
        drawing.stroke(bend(low, half, -BORE, top), pen);
        for side in [-1.0, 1.0] {
            let (a, b) = (at(side * half - BORE, level), at(side * half + BORE, level));
            drawing.stroke(Path::line(a, b), part.pen(Weight::Thin));
        }
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (half, level) = (part.length("width", 2.4) / 2.0, part.length("level", 1.6));
        let low = part.point() - Point::new(half + BORE, BORE);
        let high = part.point() + Point::new(half + BORE, level + ABOVE);
        spots::outside(Bounds::of(low, high), part.at)
    }
}
