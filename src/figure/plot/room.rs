//! What is taken of the space between the axes, and what is free for a label.

use crate::figure::{Bounds, Point};

/// Side of a cell, in figure units.
const CELL: f64 = 0.05;

/// The cells that lines pass, summed so that the number in any box is known at once.
#[derive(Clone, Debug)]
pub(crate) struct Room {
    bounds: Bounds,
    columns: usize,
    rows: usize,
    taken: Vec<bool>,
    /// Taken cells below and to the left of each corner.
    sums: Vec<u32>,
}

impl Room {
    /// Free space.
    pub(crate) fn of(bounds: Bounds) -> Self {
        let columns = (bounds.width() / CELL) as usize + 1;
        let rows = (bounds.height() / CELL) as usize + 1;
        Self {
            bounds,
            columns,
            rows,
            taken: vec![false; columns * rows],
            sums: Vec::new(),
        }
    }

    /// Takes the cells along a segment.
    pub(crate) fn take(&mut self, a: Point, b: Point) {
        let steps = (a.distance(b) / (0.7 * CELL)) as usize + 1;
        for step in 0..=steps.min(4000) {
            let point = a.towards(b, step as f64 / steps as f64);
            if self.bounds.has(point) {
                let (column, row) = self.cell(point);
                self.taken[row * self.columns + column] = true;
            }
        }
    }

    /// Counts, after the last cell was taken.
    pub(crate) fn count(&mut self) {
        let width = self.columns + 1;
        self.sums = vec![0; width * (self.rows + 1)];
        for row in 0..self.rows {
            let mut sum = 0;
            for column in 0..self.columns {
                sum += u32::from(self.taken[row * self.columns + column]);
                self.sums[(row + 1) * width + column + 1] =
                    self.sums[row * width + column + 1] + sum;
            }
        }
    }

    /// How many cells in a box are taken.
    pub(crate) fn taken(&self, bounds: Bounds) -> u32 {
        let (left, low) = self.cell(bounds.low);
        let (right, high) = self.cell(bounds.high);
        let width = self.columns + 1;
        let sum = |column: usize, row: usize| self.sums[row * width + column];
        sum(right + 1, high + 1) + sum(left, low) - sum(left, high + 1) - sum(right + 1, low)
    }

    /// The cell of a point, or the nearest one.
    fn cell(&self, point: Point) -> (usize, usize) {
        (
            cell(point.x, self.bounds.low.x, self.columns),
            cell(point.y, self.bounds.low.y, self.rows),
        )
    }
}

/// The cell of a place.
fn cell(at: f64, from: f64, count: usize) -> usize {
    (((at - from) / CELL).max(0.0) as usize).min(count - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_takes_what_it_passes_and_nothing_else() {
        let point = Point::new;
        let mut room = Room::of(Bounds::of(point(0.0, 0.0), point(10.0, 5.0)));
        room.take(point(0.0, 0.0), point(10.0, 5.0));
        room.take(point(2.0, -1.0), point(2.0, -3.0));
        room.count();
        let taken = |a: Point, b: Point| room.taken(Bounds::of(a, b));
        assert!(taken(point(4.9, 2.4), point(5.1, 2.6)) > 0);
        assert_eq!(taken(point(1.0, 3.0), point(4.0, 4.9)), 0);
        assert_eq!(taken(point(6.0, 0.0), point(9.0, 2.0)), 0);
        assert!(taken(point(0.0, 0.0), point(10.0, 5.0)) >= 200);
    }
}
