//! Arrows: of forces, of motion, of dimensions.

use super::{Drawing, Fill, Path, Pen, Point, Weight};

/// The head of an arrow.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ArrowHead {
    length: f64,
    half_width: f64,
}

impl ArrowHead {
    /// Of forces and moments.
    pub(crate) const BOLD: Self = Self {
        length: 0.26,
        half_width: 0.085,
    };
    /// Of motion, coordinates and axes.
    pub(crate) const USUAL: Self = Self {
        length: 0.21,
        half_width: 0.065,
    };
    /// Of dimensions.
    pub(crate) const SLIM: Self = Self {
        length: 0.18,
        half_width: 0.045,
    };

    /// The head that goes with a pen.
    fn of(pen: Pen) -> Self {
        if pen.weight > Weight::Medium {
            Self::BOLD
        } else {
            Self::USUAL
        }
    }

    /// Draws the head alone, its tip at a point.
    fn draw(self, drawing: &mut Drawing, tip: Point, direction: Point) {
        let along = direction.unit();
        let (back, side) = (tip - along * self.length, along.left() * self.half_width);
        let notch = tip - along * (0.8 * self.length);
        let path = Path::polygon([tip, back + side, notch, back - side]);
        drawing.decorate(path, None, Fill::Ink);
        drawing.keep_clear(back, tip, self.half_width);
    }
}

/// Draws an arrow from one point to another.
pub(crate) fn arrow(drawing: &mut Drawing, from: Point, to: Point, pen: Pen, head: ArrowHead) {
    let along = (to - from).unit();
    let neck = to - along * (0.75 * head.length).min(from.distance(to));
    drawing.stroke(Path::line(from, neck), pen);
    head.draw(drawing, to, along);
}

/// Draws an arrow at both ends.
pub(crate) fn double(drawing: &mut Drawing, a: Point, b: Point, pen: Pen) {
    let head = ArrowHead::SLIM;
    let along = (b - a).unit() * (0.75 * head.length).min(a.distance(b) / 2.0);
    drawing.stroke(Path::line(a + along, b - along), pen);
    head.draw(drawing, a, a - b);
    head.draw(drawing, b, b - a);
}

/// The circle along which a rotation is drawn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Orbit {
    pub(crate) centre: Point,
    pub(crate) radius: f64,
    /// The axis, where it lies in the plane of the drawing: the circle about it is seen obliquely, from its tip.
    pub(crate) axis: Option<Point>,
}

/// How flat a circle about an axis in the plane looks: seen from 20° above.
const FLAT: f64 = 0.34;

impl Orbit {
    /// The vector from the centre to the point at an angle in radians, counterclockwise seen from the tip of the axis.
    pub(crate) fn arm(&self, angle: f64) -> Point {
        self.mapped(Point::at_angle(angle))
    }

    /// Where the circle has such a vector, as a share of its radius, if it is seen from the front.
    fn mapped(&self, seen: Point) -> Point {
        match self.axis.map(Point::unit) {
            None => seen * self.radius,
            Some(axis) => {
                -axis.left() * (self.radius * seen.x) + axis * (self.radius * FLAT * seen.y)
            }
        }
    }

    fn path(&self, from: f64, to: f64) -> Path {
        if self.axis.is_none() {
            return Path::arc(self.centre, self.radius, from, to);
        }
        // Cubic pieces of at most an eighth of a turn follow an ellipse to less than the width of a line.
        let pieces = ((to - from).abs() / std::f64::consts::FRAC_PI_4)
            .ceil()
            .max(1.0);
        let step = (to - from) / pieces;
        let rate = |angle: f64| self.mapped(Point::at_angle(angle).left()) * (step / 3.0);
        let mut path = Path::new().move_to(self.centre + self.arm(from));
        for piece in 0..pieces as usize {
            let (a, b) = (from + piece as f64 * step, from + (piece + 1) as f64 * step);
            let (start, end) = (self.centre + self.arm(a), self.centre + self.arm(b));
            path = path.curve_to(start + rate(a), end - rate(b), end);
        }
        path
    }
}

/// Draws an arrow along a circle, from one angle to another, in radians.
pub(crate) fn bent(drawing: &mut Drawing, orbit: Orbit, from: f64, to: f64, pen: Pen) {
    let head = ArrowHead::of(pen);
    let share = head.length / orbit.radius.max(1e-3);
    let turn = (to - from).signum();
    let neck = to - turn * (0.75 * share).min((to - from).abs());
    drawing.stroke(orbit.path(from, neck), pen);
    // The head points along the chord of the arc that it covers.
    let tip = orbit.centre + orbit.arm(to);
    let back = orbit.centre + orbit.arm(to - turn * share);
    head.draw(drawing, tip, tip - back);
}
