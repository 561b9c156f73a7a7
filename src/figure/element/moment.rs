//! A moment about a point, `sense` = `ccw` or `cw`; `radius` is that of its arrow.
//!
//! ```toml
//! elements = [{ disk = [1.2, 1.2], radius = 1.1 }, { moment = [1.2, 1.2], sense = "cw", label = "'M(t)'" }]
//! ```

use super::{Element, ElementKey, FROM, Holds, Layer, Role, Takes, number};
use crate::figure::arrow::{Orbit, bent};
use crate::figure::part::Part;
use crate::figure::{Drawing, Noun, Point, Spot, Weight, spots};

pub(crate) struct Moment;

/// Where the arrow begins and ends if it turns counterclockwise, in degrees.
const SPAN: (f64, f64) = (-50.0, 130.0);

fn span(part: &Part<'_>) -> (f64, f64) {
    let (from, to) = (SPAN.0.to_radians(), SPAN.1.to_radians());
    if part.word("sense") == Some("cw") {
        (to, from)
    } else {
        (from, to)
    }
}

impl Element for Moment {
    fn name(&self) -> &'static str {
        "moment"
    }

    fn takes(&self) -> Takes {
        Takes::PointOrLabel
    }

    fn keys(&self) -> &'static [ElementKey] {
        const {
            &[
                ElementKey {
                    name: "sense",
                    holds: Holds::Word(&["ccw", "cw"]),
                },
                number("radius"),
                FROM,
            ]
        }
    }

    fn layer(&self) -> Layer {
        Layer::Mark
    }

    fn role(&self) -> Role {
        Role::Thing(Noun::MOMENT)
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (from, to) = span(part);
        let orbit = Orbit {
            centre: part.point(),
            radius: part.length("radius", 0.5),
            axis: None,
        };
        bent(drawing, orbit, from, to, part.pen(Weight::Bold));
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (centre, radius) = (part.point(), part.length("radius", 0.5));
        let mut spots = Vec::new();
        if let Some(side) = part.at {
            spots.extend(spots::off(centre, side.direction(), radius));
        }
        for angle in [40.0_f64, 60.0, 20.0, 90.0, 0.0, 120.0, -20.0, 150.0] {
            spots.extend(spots::off(
                centre,
                Point::at_angle(angle.to_radians()),
                radius,
            ));
        }
        spots
    }
}
