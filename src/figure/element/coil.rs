//! A coil (inductance) between two points.
//!
//! ```toml
//! elements = [{ coil = ["[0, 0]", "[2.4, 0]"], label = "L" }]
//! ```

use std::f64::consts::PI;

use super::family::Branch;
use crate::figure::part::Part;
use crate::figure::{Drawing, Path, Point, Weight};

pub(crate) static COIL: Branch = Branch {
    name: "coil",
    link: "coil",
    length: 1.2,
    half_width: 0.16,
    symbol,
};

const TURNS: usize = 4;

fn symbol(part: &Part<'_>, from: Point, to: Point, drawing: &mut Drawing) {
    let radius = from.distance(to) / (2.0 * TURNS as f64);
    let start = (from - to).angle();
    let mut path = Path::new().move_to(from);
    for turn in 0..TURNS {
        let centre = from.towards(to, (2 * turn + 1) as f64 / (2 * TURNS) as f64);
        path = path.arc_on(centre, radius, start, start - PI);
    }
    drawing.stroke(path, part.pen(Weight::Medium));
}
