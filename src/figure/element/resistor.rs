//! A resistor between two points, as a rectangle (IEC 60617).
//!
//! ```toml
//! elements = [{ resistor = ["[0, 0]", "[2.4, 0]"], label = "R" }]
//! ```

use super::family::Branch;
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Noun, Path, Point, Weight};

pub(crate) static RESISTOR: Branch = Branch {
    name: "resistor",
    link: Noun::new("resistor", "une résistance"),
    length: 1.0,
    half_width: HALF,
    symbol,
};

// Three times as long as wide, as IEC 60617 draws it.
const HALF: f64 = 0.17;

fn symbol(part: &Part<'_>, from: Point, to: Point, drawing: &mut Drawing) {
    let across = (to - from).unit().left() * HALF;
    let body = Path::polygon([from + across, to + across, to - across, from - across]);
    drawing.shape(body, Some(part.pen(Weight::Medium)), Fill::None);
}
