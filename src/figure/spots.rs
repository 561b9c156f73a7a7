//! The places that labels try, best first.

use super::outline::{Outline, Side};
use super::{Anchor, Bounds, FigureLabel, Point, Spot};

/// Room between a label and what it belongs to.
const GAP: f64 = 0.08;

/// How much farther a label goes when the places nearby are taken.
const FARTHER: [f64; 4] = [0.0, 0.14, 0.32, 0.55];

/// Shares of a line at which its label is tried.
const ALONG: [f64; 9] = [0.5, 0.42, 0.58, 0.34, 0.66, 0.25, 0.75, 0.12, 0.88];

/// Beside a line that needs this much room on each side.
pub(crate) fn beside(a: Point, b: Point, clear: f64, at: Option<Side>) -> Vec<Spot> {
    beside_at(a, b, clear, at, &FARTHER)
}

/// The same at some of the distances.
fn beside_at(a: Point, b: Point, clear: f64, at: Option<Side>, farther: &[f64]) -> Vec<Spot> {
    let across = (b - a).unit().left();
    // Above; of an upright line to the left.
    let usual = if across.y < -0.3 || (across.y.abs() <= 0.3 && across.x > 0.0) {
        -across
    } else {
        across
    };
    let normal = match at.map(Side::direction) {
        Some(wanted) if across.dot(wanted).abs() > 0.2 => across * across.dot(wanted).signum(),
        _ => usual,
    };
    let mut spots = Vec::with_capacity(2 * farther.len() * ALONG.len());
    for normal in [normal, -normal] {
        for more in farther {
            for share in ALONG {
                let at = a.towards(b, share) + normal * (clear + GAP + more);
                spots.push(Spot::new(at, Anchor::facing(normal)));
            }
        }
    }
    spots
}

/// At the tip of an arrow, beyond it or at its side, then along it; anywhere near the arrow before farther off.
pub(crate) fn at_tip(from: Point, tip: Point, at: Option<Side>) -> Vec<Spot> {
    let along = (tip - from).unit();
    let mut normals = [along.left(), -along.left()];
    if normals[1].y > normals[0].y + 1e-9 || (normals[0].y.abs() < 1e-9 && normals[1].x > 0.0) {
        normals.swap(0, 1);
    }
    let mut spots = Vec::new();
    let (near, far) = FARTHER.split_at(2);
    for farther in [near, far] {
        if let Some(side) = at {
            spots.extend(off_at(tip, side.direction(), 0.08, farther));
            spots.extend(beside_at(from, tip, 0.08, at, farther));
        }
        spots.push(Spot::beside(tip, along, GAP));
        for normal in normals {
            spots.extend(off_at(tip - along * 0.1, normal, 0.08, farther));
        }
        spots.extend(off_at(tip, along, 0.0, farther));
        spots.extend(beside_at(from, tip, 0.08, at, farther));
    }
    spots
}

/// Beside a point, in a direction, at growing distances.
pub(crate) fn off(point: Point, direction: Point, clear: f64) -> impl Iterator<Item = Spot> {
    off_at(point, direction, clear, &FARTHER)
}

/// The same at some of the distances.
fn off_at(
    point: Point,
    direction: Point,
    clear: f64,
    farther: &[f64],
) -> impl Iterator<Item = Spot> {
    farther
        .iter()
        .map(move |more| Spot::beside(point, direction, clear + GAP + more))
}

/// Around a point that needs this much room: to the wanted side first.
pub(crate) fn around(point: Point, clear: f64, at: Option<Side>) -> Vec<Spot> {
    let mut directions: Vec<Point> = at.map(Side::direction).into_iter().collect();
    directions.extend([
        Point::new(1.0, 0.0),
        Point::new(0.0, 1.0),
        Point::new(-1.0, 0.0),
        Point::new(0.0, -1.0),
    ]);
    for (x, y) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
        directions.push(Point::new(x, y));
    }
    let mut spots = Vec::new();
    if let Some(side) = at {
        spots.extend(off(point, side.direction(), clear));
    }
    for more in FARTHER {
        let place = |direction: &Point| Spot::beside(point, *direction, clear + GAP + more);
        spots.extend(directions.iter().map(place));
    }
    spots
}

/// Outside of a box, in the middle of its sides first.
pub(crate) fn outside(bounds: Bounds, at: Option<Side>) -> Vec<Spot> {
    let mut sides: Vec<Side> = at.into_iter().collect();
    sides.extend([Side::Right, Side::Above, Side::Left, Side::Below]);
    let half = Point::new(bounds.width() / 2.0, bounds.height() / 2.0);
    let mut spots = Vec::new();
    for more in FARTHER {
        for side in &sides {
            let out = side.direction();
            let reach = (out.x * half.x).abs() + (out.y * half.y).abs();
            let along = Point::new(out.y.abs() * half.x, out.x.abs() * half.y);
            for share in [0.0, 0.6, -0.6, 1.0, -1.0] {
                let at = bounds.centre() + out * (reach + GAP + more) + along * share;
                spots.push(Spot::new(at, Anchor::facing(out)));
            }
        }
    }
    spots
}

/// Inside a body if the label fits, in the middle or at the wanted side; else outside.
pub(crate) fn inside(outline: &Outline, label: &FigureLabel, at: Option<Side>) -> Vec<Spot> {
    let bounds = outline.bounds();
    let half = Point::new(bounds.width() / 2.0, bounds.height() / 2.0);
    let mut spots = Vec::new();
    let mut add = |direction: Point, share: f64| {
        let reach = Point::new(direction.x * half.x, direction.y * half.y);
        let middle = outline.centre + reach * share;
        if outline.holds(label, middle) {
            spots.push(Spot::new(middle, Anchor::MIDDLE));
        }
    };
    let directions = [Side::Above, Side::Right, Side::Left, Side::Below].map(Side::direction);
    match at {
        Some(side) => [0.55, 0.65, 0.45, 0.75, 0.35]
            .into_iter()
            .for_each(|share| add(side.direction(), share)),
        None => add(directions[0], 0.0),
    }
    let diagonals =
        [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)].map(|(x, y)| Point::new(x, y));
    for share in [0.3, 0.45, 0.6, 0.72] {
        for direction in directions
            .into_iter()
            .chain(diagonals.map(|diagonal| diagonal * 0.75))
        {
            add(direction, share);
        }
    }
    spots.extend(outside(bounds, at));
    spots
}
