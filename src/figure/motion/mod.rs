//! Figures that move: points that are shifted and bodies that turn by the coordinates of the model.
//!
//! `[figure.motion]` says how named points move. What is placed at them moves with them, ends of links that touch a moving
//! body too, and cords keep their passes. A displacement is drawn out of scale, so that it can be seen: the largest shift
//! of a motion is `scale` long, the largest turn [`TURN`]; with `metre`, the length of a metre in the figure, both follow
//! one scale, as a cord on a disk needs it.

mod film;
mod pose;
mod read;

pub use film::{Film, MovingFigure};
pub(crate) use read::motion;

use super::formula::{Amount, FigurePair, FigureValues};
use super::{Figure, FigureData, Point};
use crate::expr::Name;
use pose::Rigid;

/// How long the largest shift is drawn if the item does not say it.
const SHIFT: f64 = 0.5;

/// How large the largest turn is drawn if no length fixes it, in radians: well seen, and a pendulum is still one of small angles.
const TURN: f64 = 0.3;

/// How a figure moves.
#[derive(Debug)]
pub(crate) struct Motion {
    /// The slots of the coordinates, and that of time.
    coordinates: Vec<u32>,
    time: u32,
    /// What its formulas take from the item and the figure does not.
    taken: Vec<(Name, u32)>,
    scale: Option<Amount>,
    metre: Option<Amount>,
    points: Vec<MovedPoint>,
}

/// A point that moves.
#[derive(Debug)]
struct MovedPoint {
    place: Spot,
    /// In metres.
    shift: Option<[Amount; 2]>,
    /// The shift with which the figure shows it, in figure units.
    drawn: Option<FigurePair>,
    turn: Option<PointTurn>,
}

/// Where a moving point is at rest.
#[derive(Debug)]
enum Spot {
    /// A point of the figure, by its slot.
    Named(u32),
    /// Said by the motion itself.
    Own(FigurePair),
}

/// A turn, counterclockwise.
#[derive(Debug)]
struct PointTurn {
    /// In radians.
    angle: Amount,
    /// The point about which it turns.
    about: Option<u32>,
    /// The angle at which the figure shows it.
    drawn: Option<Amount>,
}

/// The coordinates of a model at a time, in SI units, counted from rest.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelState {
    /// In the order of the model.
    pub coordinates: Vec<f64>,
    /// In seconds, for what is prescribed.
    pub time: f64,
}

/// The displacements of the points of a motion, before they are scaled.
type Displacements = Vec<(Point, f64)>;

impl Motion {
    /// The numbers of the names, with those that the motion takes.
    fn values(&self, figure: &Figure, given: &dyn FigureData) -> FigureValues {
        let mut values = figure.values(given);
        for (name, slot) in &self.taken {
            values.set(*slot, given.number(name).unwrap_or(f64::NAN));
        }
        values
    }

    /// The displacements in metres and radians at a state.
    fn displacements(&self, values: &mut FigureValues, state: &ModelState) -> Displacements {
        for (slot, number) in self.coordinates.iter().zip(&state.coordinates) {
            values.set(*slot, *number);
        }
        values.set(self.time, state.time);
        let points = self.points.iter().map(|point| {
            let shift = point.shift.as_ref().map_or(Point::default(), |[x, y]| {
                Point::new(values.amount(x), values.amount(y))
            });
            let turn = point.turn.as_ref();
            (shift, turn.map_or(0.0, |turn| values.amount(&turn.angle)))
        });
        points.collect()
    }

    /// Figure units for a metre, and drawn radians for a radian, so that the largest displacements of a motion are seen.
    fn scales(&self, values: &FigureValues, all: &[Displacements]) -> (f64, f64) {
        let (mut longest, mut widest) = (0.0_f64, 0.0_f64);
        for (shift, turn) in all.iter().flatten() {
            longest = longest.max(shift.length());
            widest = widest.max(turn.abs());
        }
        let per = |room: f64, largest: f64| (largest > 0.0).then(|| room / largest);
        let amount = |amount: &Option<Amount>| amount.as_ref().map(|own| values.amount(own));
        let shown = amount(&self.scale).unwrap_or(SHIFT).clamp(0.02, 10.0);
        // What is shown displaced swings as far as it is shown.
        let drawn = self
            .points
            .iter()
            .filter_map(|point| point.turn.as_ref()?.drawn.as_ref());
        let drawn = drawn.map(|own| values.amount(own).abs());
        let turned = drawn.fold(0.0_f64, f64::max);
        let turned = if turned > 0.0 { turned } else { TURN };
        let Some(metre) = amount(&self.metre).filter(|metre| *metre > 0.0) else {
            return (
                per(shown, longest).unwrap_or(0.0),
                per(turned, widest).unwrap_or(0.0),
            );
        };
        let both = [per(shown, longest * metre), per(turned, widest)];
        let factor = both.into_iter().flatten().fold(f64::INFINITY, f64::min);
        let factor = if factor.is_finite() { factor } else { 0.0 };
        (metre * factor, factor)
    }

    /// The displacements as they are drawn; from where the figure shows them, if `shows` is true.
    fn drawn(
        &self,
        values: &FigureValues,
        displacements: &Displacements,
        (along, around): (f64, f64),
        shows: bool,
    ) -> Vec<Rigid> {
        let mut all: Vec<Rigid> = Vec::with_capacity(self.points.len());
        for (point, (shift, angle)) in self.points.iter().zip(displacements) {
            let turn = point.turn.as_ref();
            let centre = turn.and_then(|turn| turn.about);
            let about = centre.map_or_else(|| point.at(values), |about| values.point(about));
            // A centre that moves itself takes along what turns about it.
            let carried = all
                .iter()
                .find(|own| own.slot.is_some() && own.slot == centre);
            let carried = carried.map_or(Point::default(), |own| own.point(about) - about);
            let shown = if shows {
                point.shown(values)
            } else {
                Default::default()
            };
            all.push(Rigid {
                slot: point.slot(),
                shift: *shift * along + carried - shown.0,
                turn: angle * around - shown.1,
                about,
            });
        }
        all
    }
}

impl MovedPoint {
    fn slot(&self) -> Option<u32> {
        match self.place {
            Spot::Named(slot) => Some(slot),
            Spot::Own(_) => None,
        }
    }

    /// The shift and the turn with which the figure shows it.
    fn shown(&self, values: &FigureValues) -> (Point, f64) {
        let shift = self.drawn.as_ref().map(|drawn| values.pair(drawn));
        let turn = self.turn.as_ref().and_then(|turn| turn.drawn.as_ref());
        (
            shift.unwrap_or_default(),
            turn.map_or(0.0, |drawn| values.amount(drawn)),
        )
    }

    /// Where it is in the figure.
    fn at(&self, values: &FigureValues) -> Point {
        match &self.place {
            Spot::Named(slot) => values.point(*slot),
            Spot::Own(pair) => values.pair(pair),
        }
    }
}
