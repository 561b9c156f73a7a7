//! The outlines of bodies: where links end, and how much room there is for a label.

use super::{Bounds, FigureLabel, Point};

/// The outline of a body that is placed at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outline {
    /// Its middle.
    pub centre: Point,
    /// A circle or a turned rectangle.
    pub form: OutlineForm,
    /// Whether links to its point go to its middle, as to the axle of a disk.
    pub has_axle: bool,
}

/// The form of an outline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OutlineForm {
    /// A box with these halves of its sides, turned by an angle in radians.
    Box {
        /// Half of width and height.
        half: Point,
        /// The angle by which it is turned, counterclockwise.
        angle: f64,
    },
    /// A circle.
    Round {
        /// Distance of the circle from the middle.
        radius: f64,
    },
}

/// One of the four sides, of a body or of the place of a label.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Up.
    Above,
    /// Down.
    Below,
    /// Toward smaller x.
    Left,
    /// Toward larger x.
    Right,
}

impl Side {
    /// Its unit vector.
    pub fn direction(self) -> Point {
        match self {
            Self::Above => Point::new(0.0, 1.0),
            Self::Below => Point::new(0.0, -1.0),
            Self::Left => Point::new(-1.0, 0.0),
            Self::Right => Point::new(1.0, 0.0),
        }
    }

    /// The side of a label by its word in `at`.
    pub(crate) fn of_word(word: &str) -> Option<Self> {
        let place = Self::WORDS.iter().position(|known| *known == word)?;
        Some([Self::Above, Self::Below, Self::Left, Self::Right][place])
    }

    /// The side of a body by its word after a point, `B.left`.
    pub(crate) fn of_body(word: &str) -> Option<Self> {
        let place = Self::BODY.iter().position(|known| *known == word)?;
        Some([Self::Above, Self::Below, Self::Left, Self::Right][place])
    }

    /// The words of `at`.
    pub const WORDS: [&str; 4] = ["above", "below", "left", "right"];

    /// The words after a point.
    pub(crate) const BODY: [&str; 4] = ["top", "bottom", "left", "right"];
}

impl Outline {
    /// A box.
    pub fn boxed(centre: Point, width: f64, height: f64) -> Self {
        Self::turned(centre, width, height, 0.0)
    }

    /// A box that is turned by an angle.
    pub fn turned(centre: Point, width: f64, height: f64, angle: f64) -> Self {
        let half = Point::new(width / 2.0, height / 2.0);
        Self {
            centre,
            form: OutlineForm::Box { half, angle },
            has_axle: false,
        }
    }

    /// A circle.
    pub fn round(centre: Point, radius: f64, has_axle: bool) -> Self {
        Self {
            centre,
            form: OutlineForm::Round { radius },
            has_axle,
        }
    }

    /// The middle of a side, and the direction out of the body there.
    pub fn side(&self, side: Side) -> (Point, Point) {
        let direction = side.direction();
        match self.form {
            OutlineForm::Box { half, angle } => {
                let out = turned(direction, angle);
                let reach = (direction.x * half.x).abs() + (direction.y * half.y).abs();
                (self.centre + out * reach, out)
            }
            OutlineForm::Round { radius } => (self.centre + direction * radius, direction),
        }
    }

    /// Where a straight line that comes from a point and passes through another one inside enters the body.
    pub fn entry(&self, from: Point, inside: Point) -> Point {
        let way = inside - from;
        let share = match self.form {
            OutlineForm::Box { half, angle } => {
                let (start, way) = (turned(from - self.centre, -angle), turned(way, -angle));
                enter(start.x, way.x, half.x).max(enter(start.y, way.y, half.y))
            }
            OutlineForm::Round { radius } => {
                let start = from - self.centre;
                let (a, b) = (way.dot(way), way.dot(start));
                let rest = b * b - a * (start.dot(start) - radius * radius);
                if a < 1e-18 || rest < 0.0 {
                    1.0
                } else {
                    (-b - rest.sqrt()) / a
                }
            }
        };
        from + way * share.clamp(0.0, 1.0)
    }

    /// Whether a point lies in it, or at most this far outside.
    pub fn is_near(&self, point: Point, margin: f64) -> bool {
        match self.form {
            OutlineForm::Box { half, angle } => {
                let local = turned(point - self.centre, -angle);
                local.x.abs() <= half.x + margin && local.y.abs() <= half.y + margin
            }
            OutlineForm::Round { radius } => point.distance(self.centre) <= radius + margin,
        }
    }

    /// How far it reaches across a direction.
    pub(crate) fn breadth(&self, direction: Point) -> f64 {
        match self.form {
            OutlineForm::Box { half, angle } => {
                let across = turned(direction.unit().left(), -angle);
                2.0 * ((across.x * half.x).abs() + (across.y * half.y).abs())
            }
            OutlineForm::Round { radius } => 2.0 * radius,
        }
    }

    /// The box around it.
    pub fn bounds(&self) -> Bounds {
        match self.form {
            OutlineForm::Box { half, angle } => {
                let (x, y) = (
                    turned(Point::new(half.x, 0.0), angle),
                    turned(Point::new(0.0, half.y), angle),
                );
                Bounds::around(
                    self.centre,
                    2.0 * (x.x.abs() + y.x.abs()),
                    2.0 * (x.y.abs() + y.y.abs()),
                )
            }
            OutlineForm::Round { radius } => {
                Bounds::around(self.centre, 2.0 * radius, 2.0 * radius)
            }
        }
    }

    /// Its corners, counterclockwise; none for a circle.
    pub(crate) fn corners(&self) -> Vec<Point> {
        match self.form {
            OutlineForm::Box { half, angle } => {
                [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
                    .map(|(x, y)| self.centre + turned(Point::new(x * half.x, y * half.y), angle))
                    .to_vec()
            }
            OutlineForm::Round { .. } => Vec::new(),
        }
    }

    /// Whether a label fits inside when its middle lies at a point.
    pub fn holds(&self, label: &FigureLabel, middle: Point) -> bool {
        // 0.6 mm in print of paper between letters and the outline.
        const MARGIN: f64 = 0.06;
        let bounds =
            Bounds::around(middle, label.width(), label.ascent() + label.depth()).grown(MARGIN);
        let corners = [
            bounds.low,
            bounds.high,
            Point::new(bounds.low.x, bounds.high.y),
            Point::new(bounds.high.x, bounds.low.y),
        ];
        corners.iter().all(|corner| match self.form {
            OutlineForm::Box { half, angle } => {
                let local = turned(*corner - self.centre, -angle);
                local.x.abs() <= half.x && local.y.abs() <= half.y
            }
            OutlineForm::Round { radius } => corner.distance(self.centre) <= radius,
        })
    }
}

/// When a way enters a strip of this half width around zero.
fn enter(start: f64, way: f64, half: f64) -> f64 {
    if way.abs() < 1e-9 {
        f64::NEG_INFINITY
    } else {
        (-half.copysign(way) - start) / way
    }
}

/// A vector turned by an angle, counterclockwise.
pub(crate) fn turned(vector: Point, angle: f64) -> Point {
    if angle == 0.0 {
        return vector;
    }
    let direction = Point::at_angle(angle);
    direction * vector.x + direction.left() * vector.y
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_end_at_the_outline() {
        let block = Outline::boxed(Point::new(4.0, 1.0), 2.0, 1.0);
        let from = Point::new(0.0, 1.0);
        assert_eq!(block.entry(from, block.centre), Point::new(3.0, 1.0));
        let bob = Outline::round(Point::new(4.0, 1.0), 0.5, false);
        assert_eq!(bob.entry(from, bob.centre), Point::new(3.5, 1.0));
        assert_eq!(block.side(Side::Above).0, Point::new(4.0, 1.5));
        assert_eq!(block.breadth(Point::new(1.0, 0.0)), 1.0);
    }

    #[test]
    fn a_turned_block_has_its_sides_along_the_slope() {
        let quarter = std::f64::consts::FRAC_PI_2;
        let block = Outline::turned(Point::default(), 2.0, 1.0, quarter);
        let (point, out) = block.side(Side::Right);
        assert!(point.distance(Point::new(0.0, 1.0)) < 1e-12);
        assert!(out.distance(Point::new(0.0, 1.0)) < 1e-12);
    }

    #[test]
    fn a_label_fits_or_does_not() {
        let label = FigureLabel::words("m");
        let middle = Point::default();
        assert!(Outline::round(middle, 0.5, false).holds(&label, middle));
        assert!(!Outline::round(middle, 0.15, false).holds(&label, middle));
    }
}
