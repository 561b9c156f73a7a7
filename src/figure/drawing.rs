//! A drawing under way: its lines and areas, its labels, and what labels have to keep clear of.

use super::{Bounds, FigureLabel, Fill, Head, Path, Pen, Point, placing, svg};

/// What is left free around the marks of a drawing.
const MARGIN: f64 = 0.08;

/// How much wider than its box a label may become in the font of a reader: DejaVu Serif, the widest that stands in on
/// common systems, sets `e(t)` 1.25 times as wide as Libertinus with its allowance.
const WIDEST: f64 = 1.25;

/// A drawing: marks in the order in which they cover each other, labels above them.
///
/// Lines are given in figure units (10 mm, y up); the frame follows from what is drawn.
///
/// # Examples
///
/// ```
/// use vibank::figure::{Anchor, Drawing, Head, FigureLabel, Path, Pen, Point, Weight};
///
/// let mut drawing = Drawing::new();
/// let (a, b) = (Point::new(0.0, 0.0), Point::new(3.0, 0.0));
/// drawing.stroke(Path::line(a, b), Pen::new(Weight::Bold));
/// drawing.text(FigureLabel::words("F(t)"), b, Anchor::LEFT);
/// let svg = drawing.svg(&Head { id: "q1", title: "A line", description: "" });
/// assert!(svg.starts_with("<svg ") && svg.contains(">F<"));
/// ```
#[derive(Clone, Debug, Default)]
pub struct Drawing {
    pub(crate) marks: Vec<DrawnPath>,
    pub(crate) labels: Vec<Lettering>,
    pub(crate) obstacles: Vec<Obstacle>,
    pub(crate) areas: Vec<Area>,
    pub(crate) wishes: Vec<Wish>,
    owner: u32,
}

/// A line or area of a drawing.
#[derive(Clone, Debug)]
pub struct DrawnPath {
    /// Its line or outline.
    pub path: Path,
    /// How the line is drawn, if it is.
    pub pen: Option<Pen>,
    /// How the inside is filled.
    pub fill: Fill,
    /// The number of the element that it belongs to.
    pub owner: u32,
}

/// A label at its place.
#[derive(Clone, Debug)]
pub struct Lettering {
    /// What is written.
    pub label: FigureLabel,
    /// The point of the drawing to which it is tied.
    pub at: Point,
    /// The point of the label that lies there.
    pub anchor: Anchor,
    /// The box that it takes.
    pub bounds: Bounds,
    /// The number of the element that it belongs to.
    pub owner: u32,
}

/// The point of a label's box that is tied to a place: −1 is left or below, 0 the middle, 1 right or above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anchor {
    /// From left to right.
    pub x: f64,
    /// From bottom to top.
    pub y: f64,
}

/// A thick segment that labels keep clear of.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Obstacle {
    pub(crate) a: Point,
    pub(crate) b: Point,
    pub(crate) radius: f64,
    pub(crate) bounds: Bounds,
}

/// The inside of a body, where labels of others are misleading.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Area {
    pub(crate) bounds: Bounds,
    pub(crate) owner: u32,
}

/// A label that goes to the first free one of some places.
#[derive(Clone, Debug)]
pub(crate) struct Wish {
    pub(crate) label: FigureLabel,
    pub(crate) owner: u32,
    pub(crate) spots: Vec<Spot>,
}

/// A place for a label.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// The point of the drawing.
    pub at: Point,
    /// The point of the label that lies there.
    pub anchor: Anchor,
}

impl Anchor {
    /// The middle.
    pub(crate) const MIDDLE: Self = Self { x: 0.0, y: 0.0 };
    /// The middle of the left side: the label stands to the right of its point.
    pub const LEFT: Self = Self { x: -1.0, y: 0.0 };
    /// The middle of the right side: the label stands to the left of its point.
    pub const RIGHT: Self = Self { x: 1.0, y: 0.0 };
    /// The middle of the lower side: the label stands above its point.
    pub const BOTTOM: Self = Self { x: 0.0, y: -1.0 };
    /// The middle of the upper side: the label stands below its point.
    pub const TOP: Self = Self { x: 0.0, y: 1.0 };

    /// The anchor of a label that stands in this direction from its point.
    pub(crate) fn facing(direction: Point) -> Self {
        let unit = direction.unit();
        Self {
            x: side(unit.x),
            y: side(unit.y),
        }
    }

    /// The box of a label that is tied to a point.
    pub fn bounds(self, label: &FigureLabel, at: Point) -> Bounds {
        let (width, height) = (label.width(), label.ascent() + label.depth());
        let centre = at - Point::new(self.x * width / 2.0, self.y * height / 2.0);
        Bounds::around(centre, width, height)
    }
}

/// To which side a part of a direction leads.
fn side(part: f64) -> f64 {
    // sin 22.5°: each of the eight sides has an eighth of the directions.
    if part > 0.38 {
        -1.0
    } else if part < -0.38 {
        1.0
    } else {
        0.0
    }
}

impl Drawing {
    /// An empty drawing.
    pub fn new() -> Self {
        Self::default()
    }

    /// What is drawn from now on belongs to this element.
    pub(crate) fn belongs_to(&mut self, owner: u32) {
        self.owner = owner;
    }

    /// Draws a line; labels keep clear of it.
    pub fn stroke(&mut self, path: Path, pen: Pen) {
        self.shape(path, Some(pen), Fill::None);
    }

    /// Fills an area without an outline; labels keep clear of its border.
    pub fn fill(&mut self, path: Path, fill: Fill) {
        self.shape(path, None, fill);
    }

    /// Draws an outline and fills it.
    pub fn shape(&mut self, path: Path, pen: Option<Pen>, fill: Fill) {
        let radius = pen.map_or(0.0, Pen::width) / 2.0;
        let obstacles = &mut self.obstacles;
        path.for_each_segment(|a, b| obstacles.push(Obstacle::new(a, b, radius)));
        self.decorate(path, pen, fill);
    }

    /// Draws without asking labels to keep clear: for fine marks whose place is kept free by [`Self::keep_clear`].
    pub(crate) fn decorate(&mut self, path: Path, pen: Option<Pen>, fill: Fill) {
        if path.is_empty() {
            return;
        }
        self.marks.push(DrawnPath {
            path,
            pen,
            fill,
            owner: self.owner,
        });
    }

    /// Asks labels to keep this far from a segment.
    pub(crate) fn keep_clear(&mut self, a: Point, b: Point, radius: f64) {
        self.obstacles.push(Obstacle::new(a, b, radius));
    }

    /// Marks the inside of a body: labels of other elements go there last.
    pub fn inside(&mut self, bounds: Bounds) {
        self.areas.push(Area {
            bounds,
            owner: self.owner,
        });
    }

    /// Writes a label at a fixed place; its box is returned.
    pub fn text(&mut self, label: FigureLabel, at: Point, anchor: Anchor) -> Bounds {
        self.letter(label, self.owner, Spot { at, anchor })
    }

    /// Writes a label at the first of some places that is free when the drawing is complete.
    pub fn place(&mut self, label: FigureLabel, spots: Vec<Spot>) {
        self.wishes.push(Wish {
            label,
            owner: self.owner,
            spots,
        });
    }

    pub(crate) fn letter(&mut self, label: FigureLabel, owner: u32, spot: Spot) -> Bounds {
        let bounds = spot.anchor.bounds(&label, spot.at);
        self.labels.push(Lettering {
            label,
            at: spot.at,
            anchor: spot.anchor,
            bounds,
            owner,
        });
        bounds
    }

    /// The marks, in the order in which they cover each other.
    pub fn marks(&self) -> &[DrawnPath] {
        &self.marks
    }

    /// The labels at their places.
    pub fn labels(&self) -> &[Lettering] {
        &self.labels
    }

    /// Adds another drawing above this one.
    pub(crate) fn add(&mut self, other: Self) {
        self.marks.extend(other.marks);
        self.labels.extend(other.labels);
    }

    /// The frame: the box of all marks and labels, with a margin.
    pub fn frame(&self) -> Bounds {
        let marks = self.marks.iter().map(|mark| {
            let reach = mark.pen.map_or(0.0, Pen::width) / 2.0;
            mark.path.bounds().grown(reach)
        });
        let labels = self.labels.iter().map(Lettering::reach);
        let bounds = marks.chain(labels).fold(Bounds::NOTHING, Bounds::joined);
        if bounds.is_nothing() {
            return Bounds::of(Point::default(), Point::new(1.0, 1.0));
        }
        bounds.grown(MARGIN)
    }

    /// Settles the labels that have several places. Where some find none that is free and near, all are settled again,
    /// these first; the round with the fewest of them counts.
    pub fn settle(&mut self) {
        placing::settle(self);
    }

    /// Width and height in print, in millimetres.
    pub fn size(&self) -> (f64, f64) {
        svg::size(self.frame())
    }

    /// The drawing as an SVG element; labels that were not settled are left out.
    pub fn svg(&self, head: &Head<'_>) -> String {
        svg::element(self.frame(), head, &svg::content(self))
    }
}

impl Lettering {
    /// The box that it takes in the widest font: it grows away from the side at which it is tied.
    fn reach(&self) -> Bounds {
        let more = (WIDEST - 1.0) * self.label.width();
        let (left, right) = match self.anchor.x {
            x if x < 0.0 => (0.0, more),
            x if x > 0.0 => (more, 0.0),
            _ => (more / 2.0, more / 2.0),
        };
        let Bounds { low, high } = self.bounds;
        Bounds {
            low: Point::new(low.x - left, low.y),
            high: Point::new(high.x + right, high.y),
        }
    }

    /// The same elsewhere.
    pub(crate) fn shifted(&self, by: Point) -> Self {
        let Bounds { low, high } = self.bounds;
        Self {
            at: self.at + by,
            bounds: Bounds {
                low: low + by,
                high: high + by,
            },
            ..self.clone()
        }
    }
}

impl Obstacle {
    fn new(a: Point, b: Point, radius: f64) -> Self {
        Self {
            a,
            b,
            radius,
            bounds: Bounds::of(a, b).grown(radius),
        }
    }
}

impl Spot {
    /// A place for a label at a point.
    pub fn new(at: Point, anchor: Anchor) -> Self {
        Self { at, anchor }
    }

    /// The place at a distance from a point, with the label on the far side.
    pub fn beside(point: Point, direction: Point, distance: f64) -> Self {
        let unit = direction.unit();
        Self::new(point + unit * distance, Anchor::facing(unit))
    }
}
