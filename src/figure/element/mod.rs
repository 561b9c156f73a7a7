//! The elements of schematics: one file each, listed in [`KINDS`].
//!
//! An element reads nothing and knows no data: it says what its first key holds and which other keys it
//! takes, and draws a [`Part`] whose points and numbers are known. Its `//!` is its page in the book, with
//! an example that the page draws.

mod angle;
mod arrow;
mod axes;
mod bar;
mod bead;
mod block;
mod bob;
mod capacitor;
mod cart;
mod coil;
mod column;
mod coordinate;
mod cord;
mod damper;
mod dimension;
mod disk;
mod family;
mod force;
mod gravity;
mod ground;
mod incline;
mod line;
mod mass_centre;
mod moment;
mod pin;
mod platform;
mod pulley;
mod radius;
mod resistor;
mod ring;
mod rod;
mod roller;
mod rotor;
mod source;
mod spring;
mod text;
mod torsion;
mod tube;
pub(crate) mod turn;
mod wire;

use super::outline::Outline;
use super::part::Part;
use super::{Drawing, Noun, Point, Spot};

/// A kind of element: one file, one line in [`KINDS`].
pub trait Element: Sync {
    /// Its name in item files.
    fn name(&self) -> &'static str;

    /// What its first key holds.
    fn takes(&self) -> Takes {
        Takes::Point
    }

    /// The keys that it has for itself.
    fn keys(&self) -> &'static [ElementKey] {
        &[]
    }

    /// What it covers and what covers it.
    fn layer(&self) -> Layer;

    /// What it is to its neighbours, for the description.
    fn role(&self) -> Role {
        Role::Mark
    }

    /// Whether several between the same two points are spread beside each other.
    fn spreads(&self) -> bool {
        false
    }

    /// What keeps its size when it is stretched: a key for its own eyes, and its number at rest.
    fn kept(&self, part: &Part<'_>) -> Option<(&'static str, f64)> {
        let _ = part;
        None
    }

    /// The straight pieces of a link, from its first end to its last.
    fn pieces(&self, part: &Part<'_>) -> Vec<(Point, Point)> {
        vec![part.link()]
    }

    /// The outline of a body, at which links to its point end.
    fn outline(&self, part: &Part<'_>) -> Option<Outline> {
        let _ = part;
        None
    }

    /// Draws its shapes with their pens, in units of 10 mm.
    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing);

    /// Where its label may stand, best first.
    fn spots(&self, part: &Part<'_>) -> Vec<Spot>;

    /// The label that it bears if none is given.
    fn usual_label(&self) -> &'static str {
        ""
    }
}

/// What the first key of an element holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Takes {
    /// A single point of the figure.
    Point,
    /// Two points.
    Two,
    /// Three points.
    Three,
    /// Two or more points; pulleys are passed clockwise or counterclockwise.
    Way,
    /// A point and an angle in degrees.
    PointAndDegrees,
    /// One point; or the label, if the point stands in `from`.
    PointOrLabel,
    /// The label; the point stands in `from`.
    Label,
}

impl Takes {
    /// What is due, in words.
    pub fn describe(self) -> &'static str {
        match self {
            Self::Point | Self::PointOrLabel => "one point",
            Self::Two => "an array of two points",
            Self::Three => "an array of three points",
            Self::Way => "an array of points",
            Self::PointAndDegrees => "an array of a point and an angle in degrees",
            Self::Label => "its symbol, and a point in `from`",
        }
    }
}

/// A key of an element.
#[derive(Clone, Copy, Debug)]
pub struct ElementKey {
    /// The key under which the figure gives it.
    pub name: &'static str,
    /// The kind of value that the key takes.
    pub holds: Holds,
}

/// What a key of an element holds.
#[derive(Clone, Copy, Debug)]
pub enum Holds {
    /// A formula for a number.
    Number,
    /// Two numbers.
    Vector,
    /// A point of the figure, by name or as a pair of coordinates.
    Point,
    /// `true` or `false`.
    Flag,
    /// One of some words.
    Word(&'static [&'static str]),
}

/// The order in which elements cover each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Layer {
    /// Ground, walls.
    Support,
    /// Bodies.
    Body,
    /// Springs, rods, cords.
    Link,
    /// Pins, balls.
    Joint,
    /// Arrows, dimensions, angles.
    Mark,
}

/// What an element is to its neighbours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// A wall, floor or ceiling, called so by where it lies.
    Ground,
    /// A body of this name.
    Body(Noun),
    /// A link of this name between two points.
    Link(Noun),
    /// Something else that is named in the description.
    Thing(Noun),
    /// An arrow or label that says what is measured.
    Measure,
    /// What a description leaves out.
    Mark,
}

impl Role {
    /// What descriptions call it, if it has a name of its own.
    pub fn noun(self) -> Option<Noun> {
        match self {
            Self::Body(noun) | Self::Link(noun) | Self::Thing(noun) => Some(noun),
            Self::Ground | Self::Measure | Self::Mark => None,
        }
    }
}

const fn number(name: &'static str) -> ElementKey {
    ElementKey {
        name,
        holds: Holds::Number,
    }
}

const fn flag(name: &'static str) -> ElementKey {
    ElementKey {
        name,
        holds: Holds::Flag,
    }
}

/// The point of an element whose first key may hold its label.
const FROM: ElementKey = ElementKey {
    name: "from",
    holds: Holds::Point,
};

const fn vector(name: &'static str) -> ElementKey {
    ElementKey {
        name,
        holds: Holds::Vector,
    }
}

/// All kinds.
pub static KINDS: &[&dyn Element] = &[
    &ground::Ground,
    &platform::Platform,
    &incline::Incline,
    &tube::Tube,
    &block::Block,
    &cart::Cart,
    &bead::BEAD,
    &bob::BOB,
    &disk::DISK,
    &ring::RING,
    &pulley::PULLEY,
    &rotor::ROTOR,
    &spring::Spring,
    &torsion::Torsion,
    &damper::Damper,
    &rod::Rod,
    &bar::Bar,
    &column::Column,
    &wire::Wire,
    &cord::Cord,
    &pin::Pin,
    &roller::Roller,
    &mass_centre::MassCentre,
    &force::FORCE,
    &moment::Moment,
    &arrow::ARROW,
    &coordinate::Coordinate,
    &gravity::GRAVITY,
    &axes::Axes,
    &dimension::Dimension,
    &angle::Angle,
    &radius::RADIUS,
    &turn::Turn,
    &resistor::RESISTOR,
    &coil::Coil,
    &capacitor::CAPACITOR,
    &source::SOURCE,
    &line::Line,
    &text::Text,
];

/// The kind of this name.
pub fn kind(name: &str) -> Option<&'static dyn Element> {
    KINDS.iter().copied().find(|kind| kind.name() == name)
}
