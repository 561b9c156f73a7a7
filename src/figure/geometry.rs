//! Points, directions and boxes of the plane of a figure.

use std::ops::{Add, Mul, Neg, Sub};

use crate::numerics::{atan2, hypot, sin_cos};

/// A point or a displacement, in figure units: one unit is 10 mm in print, y points up.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// To the right.
    pub x: f64,
    /// Up.
    pub y: f64,
}

/// A box with sides along the axes; one without extent is [`Bounds::NOTHING`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Lower left corner.
    pub low: Point,
    /// Upper right corner.
    pub high: Point,
}

impl Point {
    /// A point by its coordinates.
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// The unit vector at this angle from the x axis, counterclockwise, in radians.
    pub(crate) fn at_angle(angle: f64) -> Self {
        let (sine, cosine) = sin_cos(angle);
        Self::new(cosine, sine)
    }

    /// Its angle from the x axis, in radians, from −π to π.
    pub fn angle(self) -> f64 {
        atan2(self.y, self.x)
    }

    /// Euclidean norm.
    pub fn length(self) -> f64 {
        hypot(self.x, self.y)
    }

    /// The distance to another point.
    pub fn distance(self, other: Self) -> f64 {
        (other - self).length()
    }

    /// The unit vector of its direction; to the right for a vector without length.
    #[must_use]
    pub fn unit(self) -> Self {
        let length = self.length();
        if length > 1e-9 {
            self * (1.0 / length)
        } else {
            Self::new(1.0, 0.0)
        }
    }

    /// The vector turned left by a quarter.
    #[must_use]
    pub fn left(self) -> Self {
        Self::new(-self.y, self.x)
    }

    /// The scalar product.
    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y
    }

    /// The z component of the vector product.
    pub fn cross(self, other: Self) -> f64 {
        self.x * other.y - self.y * other.x
    }

    /// The point at this share of the way to another.
    #[must_use]
    pub fn towards(self, other: Self, share: f64) -> Self {
        self + (other - self) * share
    }

    /// Whether both coordinates are finite and small enough to be drawn.
    pub(crate) fn is_drawable(self) -> bool {
        self.x.abs() <= 1e3 && self.y.abs() <= 1e3
    }
}

impl Add for Point {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y)
    }
}

impl Sub for Point {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y)
    }
}

impl Mul<f64> for Point {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self::new(self.x * factor, self.y * factor)
    }
}

impl Neg for Point {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y)
    }
}

impl Bounds {
    /// The box of no point: the neutral element of [`Bounds::with`].
    pub const NOTHING: Self = Self {
        low: Point::new(f64::INFINITY, f64::INFINITY),
        high: Point::new(f64::NEG_INFINITY, f64::NEG_INFINITY),
    };

    /// The box around a centre.
    pub fn around(centre: Point, width: f64, height: f64) -> Self {
        let half = Point::new(width / 2.0, height / 2.0);
        Self {
            low: centre - half,
            high: centre + half,
        }
    }

    /// The box of two opposite corners.
    pub fn of(a: Point, b: Point) -> Self {
        Self::NOTHING.with(a).with(b)
    }

    /// The least box that also has this point.
    #[must_use]
    pub fn with(self, point: Point) -> Self {
        Self {
            low: Point::new(self.low.x.min(point.x), self.low.y.min(point.y)),
            high: Point::new(self.high.x.max(point.x), self.high.y.max(point.y)),
        }
    }

    /// The least box around both.
    #[must_use]
    pub fn joined(self, other: Self) -> Self {
        if other.is_nothing() {
            return self;
        }
        self.with(other.low).with(other.high)
    }

    /// The box with this much more on each side.
    #[must_use]
    pub fn grown(self, by: f64) -> Self {
        if self.is_nothing() {
            return self;
        }
        let by = Point::new(by, by);
        Self {
            low: self.low - by,
            high: self.high + by,
        }
    }

    /// Whether no point is in it.
    pub(crate) fn is_nothing(self) -> bool {
        self.low.x > self.high.x
    }

    /// From left to right.
    pub fn width(self) -> f64 {
        (self.high.x - self.low.x).max(0.0)
    }

    /// From bottom to top.
    pub fn height(self) -> f64 {
        (self.high.y - self.low.y).max(0.0)
    }

    /// Its middle.
    pub fn centre(self) -> Point {
        self.low.towards(self.high, 0.5)
    }

    /// Whether a point lies in it.
    pub fn has(self, point: Point) -> bool {
        self.low.x <= point.x
            && point.x <= self.high.x
            && self.low.y <= point.y
            && point.y <= self.high.y
    }

    /// Whether two boxes overlap.
    pub fn meets(self, other: Self) -> bool {
        self.low.x < other.high.x
            && other.low.x < self.high.x
            && self.low.y < other.high.y
            && other.low.y < self.high.y
    }

    /// The area that two boxes share.
    pub fn overlap(self, other: Self) -> f64 {
        let side = |low: f64, high: f64| (high - low).max(0.0);
        side(self.low.x.max(other.low.x), self.high.x.min(other.high.x))
            * side(self.low.y.max(other.low.y), self.high.y.min(other.high.y))
    }

    /// The length of the part of a segment that lies in the box; `None` if it does not touch it.
    ///
    /// # References
    ///
    /// Liang and Barsky, *A new concept and method for line clipping*, ACM Transactions on Graphics 3 (1984).
    pub fn chord(self, a: Point, b: Point) -> Option<f64> {
        let way = b - a;
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        let sides = [
            (-way.x, a.x - self.low.x),
            (way.x, self.high.x - a.x),
            (-way.y, a.y - self.low.y),
            (way.y, self.high.y - a.y),
        ];
        for (rate, room) in sides {
            if rate == 0.0 {
                if room < 0.0 {
                    return None;
                }
            } else if rate < 0.0 {
                from = from.max(room / rate);
            } else {
                to = to.min(room / rate);
            }
        }
        (from <= to).then(|| (to - from) * way.length())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_segment_is_cut_to_a_box() {
        let unit = Bounds::of(Point::default(), Point::new(1.0, 1.0));
        let through = unit.chord(Point::new(-1.0, 0.5), Point::new(3.0, 0.5));
        assert_eq!(through, Some(1.0));
        assert_eq!(
            unit.chord(Point::new(0.2, 0.25), Point::new(0.2, 0.75)),
            Some(0.5)
        );
        assert_eq!(
            unit.chord(Point::new(-1.0, 0.5), Point::new(0.9, 3.0)),
            None
        );
        assert_eq!(unit.chord(Point::new(2.0, 0.0), Point::new(2.0, 1.0)), None);
    }

    #[test]
    fn nothing_joins_with_everything() {
        let point = Point::new(2.0, -3.0);
        assert!(Bounds::NOTHING.is_nothing());
        assert_eq!(Bounds::NOTHING.with(point), Bounds::of(point, point));
        assert_eq!(Bounds::NOTHING.width(), 0.0);
    }
}
