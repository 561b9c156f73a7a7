//! The frame of a plot: what part of the plane it shows, and where that lies on paper.

use super::PlotError;
use crate::figure::{Bounds, Point};

/// Width of the space between the axes, in figure units.
pub(crate) const WIDTH: f64 = 10.0;
/// Its height.
pub(crate) const HEIGHT: f64 = 5.6;

/// Room above and below the curves, as a share of their extent.
const ROOM: f64 = 0.06;
/// An axis shows zero if that makes it longer by no more than this share.
const REACH: f64 = 0.4;

/// The part of the plane that is shown, in the coordinates of the axes: logarithms where they are logarithmic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Frame {
    pub(crate) x: [f64; 2],
    pub(crate) y: [f64; 2],
}

impl Frame {
    pub(crate) fn new(x: [f64; 2], y: [f64; 2]) -> Result<Self, PlotError> {
        for (axis, [from, to]) in [('x', x), ('y', y)] {
            let is_sound = from < to && (to - from).is_finite() && is_fine(from, to);
            if !is_sound {
                return Err(PlotError::Range { axis, from, to });
            }
        }
        Ok(Self { x, y })
    }

    /// Figure units for one unit of each axis.
    pub(crate) fn size(&self) -> [f64; 2] {
        [
            WIDTH / (self.x[1] - self.x[0]),
            HEIGHT / (self.y[1] - self.y[0]),
        ]
    }

    /// Where a point lies on paper.
    pub(crate) fn place(&self, at: [f64; 2]) -> Point {
        let [across, up] = self.size();
        Point::new((at[0] - self.x[0]) * across, (at[1] - self.y[0]) * up)
    }

    /// The direction on paper of a direction in the plane.
    pub(crate) fn along(&self, direction: [f64; 2]) -> Point {
        let [across, up] = self.size();
        Point::new(direction[0] * across, direction[1] * up)
    }

    /// The space between the axes.
    pub(crate) fn bounds() -> Bounds {
        Bounds::of(Point::default(), Point::new(WIDTH, HEIGHT))
    }
}

/// Whether a range has numbers enough to be distinguished.
fn is_fine(from: f64, to: f64) -> bool {
    to - from > 1e-9 * from.abs().max(to.abs())
}

/// The range of an axis that shows values from `low` to `high`: with room, and zero where it is near.
pub(crate) fn roomy(low: f64, high: f64, is_logarithmic: bool) -> [f64; 2] {
    let [mut low, mut high] = [low, high];
    let size = low.abs().max(high.abs());
    if high - low <= 1e-9 * size || high == low {
        let around = if size > 0.0 && !is_logarithmic {
            0.5 * size
        } else {
            0.5
        };
        return [low - around, high + around];
    }
    if !is_logarithmic {
        let extent = high - low;
        if low > 0.0 && low <= REACH * extent {
            low = 0.0;
        } else if high < 0.0 && -high <= REACH * extent {
            high = 0.0;
        }
    }
    let room = ROOM * (high - low);
    [
        if low == 0.0 { low } else { low - room },
        if high == 0.0 { high } else { high + room },
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_axis_shows_zero_where_it_is_near() {
        assert_eq!(roomy(1.0, 11.0, false)[0], 0.0);
        assert!(roomy(9.0, 11.0, false)[0] > 8.0);
        assert_eq!(roomy(-11.0, -1.0, false)[1], 0.0);
        assert_eq!(roomy(0.0, 2.0, false)[0], 0.0);
        assert!(roomy(1.0, 3.0, true)[0] > 0.8);
    }

    #[test]
    fn a_constant_has_room_on_both_sides() {
        let [low, high] = roomy(2.0, 2.0, false);
        assert!(low < 2.0 && high > 2.0);
        let [low, high] = roomy(0.0, 0.0, false);
        assert!(low < 0.0 && high > 0.0);
    }

    #[test]
    fn no_frame_without_extent() {
        assert!(Frame::new([1.0, 1.0], [0.0, 1.0]).is_err());
        assert!(Frame::new([0.0, f64::INFINITY], [0.0, 1.0]).is_err());
        assert!(Frame::new([f64::NAN, 1.0], [0.0, 1.0]).is_err());
        assert!(Frame::new([0.0, 1.0], [-2.0, 3.0]).is_ok());
    }
}
