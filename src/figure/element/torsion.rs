//! A spiral torsion spring at a hinge: it begins on the turning body in the direction `from`, winds about the point
//! counterclockwise `turns` times, and ends at its outer `radius` in the direction `to`, in degrees. A foot there
//! marks what holds it.
//!
//! ```toml
//! points = { O = [1.2, 0.8], A = "O + 2*[sin(0.4), cos(0.4)]" }
//! elements = [
//!   { rod = ["O", "A"] },
//!   { torsion = "O", from = 67, to = -20, label = "kappa" },
//!   { pin = "O", support = "below" },
//! ]
//! ```

use super::{Element, ElementKey, Layer, Role, number};
use crate::figure::part::Part;
use crate::figure::{Drawing, Fill, Noun, Path, Point, Spot, Weight, spots};

pub(crate) struct Torsion;

/// Outer radius where none is given.
const RADIUS: f64 = 0.62;

/// The spiral begins clear of the ball of a pin, whose radius is 0.1.
const HUB: f64 = 0.16;

/// Turns where none are given: enough to be seen as wound, few enough to be distinguished in print.
const TURNS: f64 = 2.5;

/// Length of the foot at the outer end.
const FOOT: f64 = 0.22;

/// An Archimedean spiral about a point.
struct Spiral {
    centre: Point,
    start: f64,
    sweep: f64,
    radius: f64,
}

impl Spiral {
    fn of(part: &Part<'_>) -> Self {
        let degrees =
            |key: &str, usual: f64| part.number(key).unwrap_or(usual).clamp(-720.0, 720.0);
        let (from, to) = (degrees("from", 90.0), degrees("to", -20.0));
        let turns = part.number("turns").unwrap_or(TURNS).clamp(1.0, 8.0);
        // The outer end is the first one in its direction after at least this many turns.
        let rest = (to - from - 360.0 * turns).rem_euclid(360.0);
        Self {
            centre: part.point(),
            start: from.to_radians(),
            sweep: (360.0 * turns + rest).to_radians(),
            radius: part.length("radius", RADIUS).max(HUB + 0.1),
        }
    }

    fn at(&self, share: f64) -> Point {
        let radius = HUB + (self.radius - HUB) * share;
        self.centre + Point::at_angle(self.start + self.sweep * share) * radius
    }

    /// The derivative of [`Self::at`].
    fn rate(&self, share: f64) -> Point {
        let radius = HUB + (self.radius - HUB) * share;
        let outwards = Point::at_angle(self.start + self.sweep * share);
        outwards * (self.radius - HUB) + outwards.left() * (radius * self.sweep)
    }

    /// Eight cubic pieces a turn follow the spiral to far less than the width of its line.
    fn path(&self) -> Path {
        let pieces = (8.0 * self.sweep / std::f64::consts::TAU).ceil().max(1.0);
        let step = 1.0 / pieces;
        let mut path = Path::line(self.centre, self.at(0.0));
        for piece in 0..pieces as usize {
            let (a, b) = (piece as f64 * step, (piece + 1) as f64 * step);
            path = path.curve_to(
                self.at(a) + self.rate(a) * (step / 3.0),
                self.at(b) - self.rate(b) * (step / 3.0),
                self.at(b),
            );
        }
        let outwards = Point::at_angle(self.start + self.sweep);
        path.line_to(self.at(1.0) + outwards * FOOT)
    }
}

impl Element for Torsion {
    fn name(&self) -> &'static str {
        "torsion"
    }

    fn keys(&self) -> &'static [ElementKey] {
        const {
            &[
                number("radius"),
                number("from"),
                number("to"),
                number("turns"),
            ]
        }
    }

    fn layer(&self) -> Layer {
        Layer::Link
    }

    fn role(&self) -> Role {
        Role::Thing(Noun::new("torsion spring", "un ressort de torsion"))
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let spiral = Spiral::of(part);
        drawing.decorate(spiral.path(), Some(part.pen(Weight::Medium)), Fill::None);
        let outwards = Point::at_angle(spiral.start + spiral.sweep);
        let foot = spiral.at(1.0) + outwards * FOOT;
        let along = outwards.left() * 0.12;
        drawing.decorate(
            Path::line(foot - along, foot + along),
            Some(part.pen(Weight::Bold)),
            Fill::None,
        );
        // Labels keep out of the turns: two capsules cross the disk that they fill.
        for direction in [Point::at_angle(0.0), Point::at_angle(1.57)] {
            let half = direction * (0.5 * spiral.radius);
            drawing.keep_clear(
                spiral.centre - half,
                spiral.centre + half,
                0.5 * spiral.radius,
            );
        }
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let spiral = Spiral::of(part);
        let mut spots = Vec::new();
        if let Some(side) = part.at {
            spots.extend(spots::off(spiral.centre, side.direction(), spiral.radius));
        }
        for degrees in [-20.0_f64, 20.0, 200.0, 160.0, -45.0, 225.0] {
            let direction = Point::at_angle(degrees.to_radians());
            spots.extend(spots::off(spiral.centre, direction, spiral.radius + FOOT));
        }
        spots
    }
}
