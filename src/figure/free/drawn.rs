//! The arrows of a body that was taken out, with their letters.

use crate::figure::arrow::{ArrowHead, Orbit, arrow, bent};
use crate::figure::element::turn;
use crate::figure::story::{Action, Sense};
use crate::figure::{Drawing, FigureLabel, Pen, Point, Side, Spot, Weight, spots};

/// The radius of the arrow of a moment.
const RADIUS: f64 = 0.5;

/// How far along its link the arrow of a moment stands: clear of the body that it acts on.
const ALONG: f64 = 0.45;

/// From the tip of an arrow to its letter: half of the breadth of its head and what labels keep clear of.
const BEYOND: f64 = 0.15;

/// The arrows of a body, and what they show in words.
#[derive(Default)]
pub(crate) struct Drawn<'f> {
    pub(crate) arrows: Vec<Arrow<'f>>,
    pub(crate) actions: Vec<Action>,
    /// Elements of the figure that show a force.
    pub(crate) shown: Vec<usize>,
}

/// An arrow of a force or moment.
pub(crate) struct Arrow<'f> {
    pub(crate) way: Way,
    pub(crate) label: &'f FigureLabel,
    /// Where its letter is wanted.
    pub(crate) at: Option<Side>,
}

/// From where to where an arrow goes.
pub(crate) enum Way {
    Straight {
        from: Point,
        to: Point,
        /// Whether its head is at the body, so that its letter stands at the other end.
        is_push: bool,
    },
    /// Round an axis in the plane of the drawing, counterclockwise as seen from its tip, or the other way round. The axis
    /// is not turned over for that: the arc would then be seen from the other side, and look like the same turn.
    Round {
        centre: Point,
        axis: Point,
        is_clockwise: bool,
    },
}

impl<'f> Drawn<'f> {
    /// A moment round a link that is cut, which leaves the body at a point.
    pub(crate) fn twist(
        &mut self,
        start: Point,
        out: Point,
        (axis, sense): (Point, &Sense),
        label: &'f FigureLabel,
    ) {
        let centre = start + out * ALONG;
        let is_clockwise = matches!(sense, Sense::AgainstTwist);
        self.arrows.push(Arrow {
            way: Way::Round {
                centre,
                axis,
                is_clockwise,
            },
            label,
            at: None,
        });
    }
}

impl Arrow<'_> {
    pub(crate) fn draw(&self, shift: Point, drawing: &mut Drawing) {
        let pen = Pen::new(Weight::Bold);
        let spots = match self.way {
            Way::Straight { from, to, is_push } => {
                let (from, to) = (from + shift, to + shift);
                arrow(drawing, from, to, pen, ArrowHead::BOLD);
                let (inner, outer) = if is_push { (to, from) } else { (from, to) };
                // Beyond the tip of an arrow that lies, clear of its head: above it a long letter would reach the body.
                let along = (outer - inner).unit();
                let beyond = (self.at.is_none() && along.x.abs() > along.y.abs())
                    .then(|| Spot::beside(outer, along, BEYOND));
                let others = spots::at_tip(inner, outer, self.at);
                beyond.into_iter().chain(others).collect()
            }
            Way::Round {
                centre,
                axis,
                is_clockwise,
            } => {
                let orbit = Orbit {
                    centre: centre + shift,
                    radius: RADIUS,
                    axis: Some(axis),
                };
                let (from, to) = match (turn::FRONT, is_clockwise) {
                    (front, false) => front,
                    ((from, to), true) => (to, from),
                };
                bent(drawing, orbit, from.to_radians(), to.to_radians(), pen);
                round(orbit)
            }
        };
        drawing.place(self.label.clone(), spots);
    }
}

/// At the sides of the arrow of a moment, then in front of it.
fn round(orbit: Orbit) -> Vec<Spot> {
    let sides = [0.0, std::f64::consts::PI, -std::f64::consts::FRAC_PI_2];
    let arms = sides.map(|angle| orbit.arm(angle));
    let spots = arms.map(|arm| spots::off(orbit.centre, arm, arm.length()));
    spots.into_iter().flatten().collect()
}
