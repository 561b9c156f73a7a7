//! A capacitor between two points.
//!
//! ```toml
//! elements = [{ capacitor = ["[0, 0]", "[2.4, 0]"], label = "C" }]
//! ```

use super::family::Branch;
use crate::figure::part::Part;
use crate::figure::{Drawing, Noun, Path, Point, Weight};

pub(crate) static CAPACITOR: Branch = Branch {
    name: "capacitor",
    link: Noun::new("capacitor", "un condensateur"),
    length: 0.2,
    // A letter hard by the end of a plate would be read together with it.
    half_width: HALF + 0.1,
    symbol,
};

const HALF: f64 = 0.3;

fn symbol(part: &Part<'_>, from: Point, to: Point, drawing: &mut Drawing) {
    let across = (to - from).unit().left() * HALF;
    for plate in [from, to] {
        let path = Path::line(plate + across, plate - across);
        drawing.stroke(path, part.pen(Weight::Bold));
    }
}
