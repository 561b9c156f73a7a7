//! The centre of mass: a circle with two black quarters.
//!
//! ```toml
//! elements = [{ mass-centre = [1, 1], label = "'G'" }]
//! ```

use super::{Element, Layer};
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Path, Spot, Weight, spots};
use std::f64::consts::FRAC_PI_2;

pub(crate) struct MassCentre;

const RADIUS: f64 = 0.12;

impl Element for MassCentre {
    fn name(&self) -> &'static str {
        "mass-centre"
    }

    fn layer(&self) -> Layer {
        Layer::Joint
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let centre = part.point();
        let circle = Path::circle(centre, RADIUS);
        drawing.shape(circle, Some(part.pen(Weight::Thin)), Fill::Paper);
        for quarter in [0.0, 2.0 * FRAC_PI_2] {
            let path = Path::arc(centre, RADIUS, quarter, quarter + FRAC_PI_2)
                .line_to(centre)
                .close();
            drawing.decorate(path, None, Fill::Ink);
        }
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        spots::around(part.point(), RADIUS + 0.03, part.at)
    }
}
