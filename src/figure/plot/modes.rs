//! Mode shapes: for each mode the coordinates side by side, each with its share of the motion.

use super::Picture;
use crate::figure::story::{Mode, Story};
use crate::figure::{Anchor, Drawing, FigureLabel, Fill, Path, Pen, Point, Spot, Weight};
use crate::math::Math;

/// The mode shapes of a system.
#[derive(Clone, Debug)]
pub struct ModeShapes {
    /// The symbols of the coordinates.
    pub coordinates: Vec<Math>,
    /// The shapes, lowest frequency first.
    pub shapes: Vec<ModeShape>,
}

/// How the masses move against each other in a mode, with its heading.
#[derive(Clone, Debug)]
pub struct ModeShape {
    /// What stands above it, such as its frequency.
    pub heading: Math,
    /// The components, of any common scale.
    pub heights: Vec<f64>,
    /// What stands at them.
    pub labels: Vec<Math>,
}

/// Distance of two coordinates.
const SPACING: f64 = 1.5;
/// Height of the largest component.
const HEIGHT: f64 = 1.2;
/// Room on both sides of a shape.
const SIDE: f64 = 0.75;
/// Distance of two rows.
const ROW: f64 = 4.6;
/// Least width of a panel.
const WIDTH: f64 = 3.4;
/// Largest width of a row.
const PAGE: f64 = 15.0;
/// Height of the heading above the line of rest.
const HEADING: f64 = 2.0;

impl ModeShapes {
    /// Draws the shapes side by side, as many in a row as fit.
    pub fn draw(&self) -> Picture {
        let mut drawing = Drawing::new();
        let count = self.coordinates.len().max(1);
        let width = (SPACING * (count - 1) as f64 + 2.0 * SIDE).max(WIDTH);
        let columns = ((PAGE / width) as usize).clamp(1, self.shapes.len().max(1));
        for (number, shape) in self.shapes.iter().enumerate() {
            let (row, column) = (number / columns, number % columns);
            let origin = Point::new(width * column as f64, -ROW * row as f64);
            drawing.belongs_to(number as u32);
            self.shape(&mut drawing, shape, origin, width);
        }
        drawing.settle();
        Picture {
            drawing,
            story: self.story(),
        }
    }

    fn shape(&self, drawing: &mut Drawing, shape: &ModeShape, origin: Point, width: f64) {
        let heights = shape.heights.iter();
        let largest = heights.fold(0.0_f64, |largest, height| largest.max(height.abs()));
        let scale = if largest > 0.0 { HEIGHT / largest } else { 0.0 };
        let first = origin.x + (width - SPACING * (shape.heights.len().max(1) - 1) as f64) / 2.0;
        let foot = |place: usize| Point::new(first + SPACING * place as f64, origin.y);
        let line = Path::line(
            Point::new(origin.x + 0.2, origin.y),
            Point::new(origin.x + width - 0.2, origin.y),
        );
        drawing.stroke(line, Pen::new(Weight::Hair));
        let heights = shape.heights.iter().enumerate();
        let tips: Vec<Point> = heights
            .map(|(place, height)| foot(place) + Point::new(0.0, height * scale))
            .collect();
        for (place, tip) in tips.iter().enumerate() {
            drawing.stroke(Path::line(foot(place), *tip), Pen::new(Weight::Thin));
            drawing.shape(Path::circle(*tip, 0.08), None, Fill::Ink);
        }
        drawing.stroke(
            Path::through(tips.iter().copied()),
            Pen::new(Weight::Medium),
        );
        let heading = Point::new(origin.x + width / 2.0, origin.y + HEADING);
        drawing.text(FigureLabel::of(&shape.heading), heading, Anchor::BOTTOM);
        for (place, tip) in tips.iter().enumerate() {
            let upward = if tip.y < origin.y { -1.0 } else { 1.0 };
            if let Some(label) = shape.labels.get(place) {
                drawing.place(FigureLabel::of(label), around(*tip, upward));
            }
            if let Some(symbol) = self.coordinates.get(place) {
                drawing.place(FigureLabel::of(symbol), around(foot(place), -upward));
            }
        }
    }

    fn story(&self) -> Story {
        let shapes = self.shapes.iter().map(|shape| Mode {
            heading: shape.heading.clone(),
            components: self
                .coordinates
                .iter()
                .cloned()
                .zip(shape.labels.iter().cloned())
                .collect(),
        });
        Story::ModeShapes(shapes.collect())
    }
}

/// Places for a label at a point, first above it (`upward` 1) or below it (−1).
fn around(point: Point, upward: f64) -> Vec<Spot> {
    let directions = [
        (0.0, upward),
        (1.0, upward),
        (-1.0, upward),
        (1.0, 0.0),
        (-1.0, 0.0),
        (1.0, -upward),
        (-1.0, -upward),
        (0.0, -upward),
    ];
    let near = directions.map(|(x, y)| Spot::beside(point, Point::new(x, y), 0.17));
    let far = directions.map(|(x, y)| Spot::beside(point, Point::new(x, y), 0.3));
    near.into_iter().chain(far).collect()
}
