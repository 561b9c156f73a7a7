//! Families of elements that differ in a few things alone: round bodies, straight arrows, branches of a circuit.
//!
//! A member keeps its page and its drawing in a file of its own, and is a `static` of its family.

use super::{Element, ElementKey, Layer, Role, Takes, number};
use crate::figure::arrow::{ArrowHead, arrow};
use crate::figure::outline::Outline;
use crate::figure::part::Part;
use crate::figure::{Drawing, FigureLabel, Noun, Path, Point, Spot, Weight, spots};

/// A body with a circle about its point as its outline.
pub(crate) struct Round {
    pub(crate) name: &'static str,
    /// What descriptions call it.
    pub(crate) body: Noun,
    pub(crate) keys: &'static [ElementKey],
    pub(crate) layer: Layer,
    /// The radius that it has if none is given.
    pub(crate) radius: f64,
    /// Whether links go to its axle, and not to its outline.
    pub(crate) has_axle: bool,
    pub(crate) spots: fn(&Outline, &Part<'_>) -> Vec<Spot>,
    /// Draws it about its centre, with its radius.
    pub(crate) draw: fn(&Part<'_>, Point, f64, &mut Drawing),
}

impl Round {
    /// What members have in common.
    pub(crate) const USUAL: Self = Self {
        name: "",
        body: Noun::new("body", "un corps"),
        keys: &[number("radius")],
        layer: Layer::Body,
        radius: 1.0,
        has_axle: true,
        spots: inside,
        draw: |_, _, _, _| {},
    };

    fn circle(&self, part: &Part<'_>) -> Outline {
        let radius = part.length("radius", self.radius);
        Outline::round(part.point(), radius, self.has_axle)
    }
}

impl Element for Round {
    fn name(&self) -> &'static str {
        self.name
    }

    fn keys(&self) -> &'static [ElementKey] {
        self.keys
    }

    fn layer(&self) -> Layer {
        self.layer
    }

    fn role(&self) -> Role {
        Role::Body(self.body)
    }

    fn outline(&self, part: &Part<'_>) -> Option<Outline> {
        Some(self.circle(part))
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let radius = part.length("radius", self.radius);
        (self.draw)(part, part.point(), radius, drawing);
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        (self.spots)(&self.circle(part), part)
    }
}

/// The places of a label inside a body, if it fits, else outside.
pub(crate) fn inside(outline: &Outline, part: &Part<'_>) -> Vec<Spot> {
    match &part.label {
        Some(label) => spots::inside(outline, label, part.at),
        None => spots::inside(outline, &FigureLabel::default(), part.at),
    }
}

/// The places of a label outside a body.
pub(crate) fn outside(outline: &Outline, part: &Part<'_>) -> Vec<Spot> {
    spots::outside(outline.bounds(), part.at)
}

/// A straight arrow.
pub(crate) struct Straight {
    pub(crate) name: &'static str,
    pub(crate) takes: Takes,
    pub(crate) keys: &'static [ElementKey],
    pub(crate) role: Role,
    pub(crate) label: &'static str,
    pub(crate) weight: Weight,
    pub(crate) head: ArrowHead,
    /// Its foot and its tip.
    pub(crate) ends: fn(&Part<'_>) -> (Point, Point),
    pub(crate) spots: fn(Point, Point, &Part<'_>) -> Vec<Spot>,
}

impl Straight {
    /// What members have in common.
    pub(crate) const USUAL: Self = Self {
        name: "",
        takes: Takes::Point,
        keys: &[],
        role: Role::Measure,
        label: "",
        weight: Weight::Thin,
        head: ArrowHead::USUAL,
        ends: |part| (part.ends[0].point, part.ends[1].point),
        spots: |from, to, part| spots::at_tip(from, to, part.at),
    };
}

impl Element for Straight {
    fn name(&self) -> &'static str {
        self.name
    }

    fn takes(&self) -> Takes {
        self.takes
    }

    fn keys(&self) -> &'static [ElementKey] {
        self.keys
    }

    fn layer(&self) -> Layer {
        Layer::Mark
    }

    fn role(&self) -> Role {
        self.role
    }

    fn usual_label(&self) -> &'static str {
        self.label
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (from, to) = (self.ends)(part);
        arrow(drawing, from, to, part.pen(self.weight), self.head);
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (from, to) = (self.ends)(part);
        (self.spots)(from, to, part)
    }
}

/// An element of a circuit between two points: its symbol in the middle, leads on both sides.
pub(crate) struct Branch {
    pub(crate) name: &'static str,
    /// What descriptions call it.
    pub(crate) link: Noun,
    /// The greatest length of the symbol.
    pub(crate) length: f64,
    /// How far it reaches to either side of the way.
    pub(crate) half_width: f64,
    /// Draws the symbol between two points.
    pub(crate) symbol: fn(&Part<'_>, Point, Point, &mut Drawing),
}

impl Element for Branch {
    fn name(&self) -> &'static str {
        self.name
    }

    fn takes(&self) -> Takes {
        Takes::Two
    }

    fn layer(&self) -> Layer {
        Layer::Link
    }

    fn role(&self) -> Role {
        Role::Link(self.link)
    }

    fn draw(&self, part: &Part<'_>, drawing: &mut Drawing) {
        let (a, b) = part.link();
        let (from, to) = middle(a, b, self.length);
        let leads = Path::line(a, from).and(Path::line(to, b));
        drawing.stroke(leads, part.pen(Weight::Medium));
        (self.symbol)(part, from, to, drawing);
    }

    fn spots(&self, part: &Part<'_>) -> Vec<Spot> {
        let (a, b) = part.link();
        spots::beside(a, b, self.half_width, part.at)
    }
}

/// The ends of the symbol of a branch, of at most this length; on a short branch leads remain on both sides.
pub(crate) fn middle(a: Point, b: Point, length: f64) -> (Point, Point) {
    let share = (length / a.distance(b).max(1e-9)).min(0.8) / 2.0;
    (a.towards(b, 0.5 - share), a.towards(b, 0.5 + share))
}
