//! Arrows: of forces, of motion, of dimensions.

use super::{Drawing, Fill, Path, Pen, Point, Weight};

/// The head of an arrow.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Head {
    length: f64,
    half_width: f64,
}

impl Head {
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
pub(crate) fn arrow(drawing: &mut Drawing, from: Point, to: Point, pen: Pen, head: Head) {
    let along = (to - from).unit();
    let neck = to - along * (0.75 * head.length).min(from.distance(to));
    drawing.stroke(Path::line(from, neck), pen);
    head.draw(drawing, to, along);
}

/// Draws an arrow at both ends.
pub(crate) fn double(drawing: &mut Drawing, a: Point, b: Point, pen: Pen) {
    let head = Head::SLIM;
    let along = (b - a).unit() * (0.75 * head.length).min(a.distance(b) / 2.0);
    drawing.stroke(Path::line(a + along, b - along), pen);
    head.draw(drawing, a, a - b);
    head.draw(drawing, b, b - a);
}

/// Draws an arrow along a circle, from one angle to another, in radians.
pub(crate) fn bent(
    drawing: &mut Drawing,
    centre: Point,
    radius: f64,
    from: f64,
    to: f64,
    pen: Pen,
) {
    let head = Head::of(pen);
    let share = head.length / radius.max(1e-3);
    let turn = (to - from).signum();
    let neck = to - turn * (0.75 * share).min((to - from).abs());
    drawing.stroke(Path::arc(centre, radius, from, neck), pen);
    // The head points along the chord of the arc that it covers.
    let tip = centre + Point::at_angle(to) * radius;
    let back = centre + Point::at_angle(to - turn * share) * radius;
    head.draw(drawing, tip, tip - back);
}
