//! The work that forces of a diagram do: whether an arrow does what the model's force does.

use super::error::FreeFault;
use super::{CutBody, Force};
use crate::figure::Point;
use crate::figure::story;

/// Below this share of its length an arrow counts as square to a motion; drawn angles are exact but for rounding.
pub(crate) const SQUARE: f64 = 0.02;

/// A motion with numbers.
pub(crate) enum Moved {
    Along(Point),
    /// The centre, and 1 for counterclockwise or −1.
    Turn(Point, f64),
    /// The axis, where it lies in the plane of the drawing, towards the tip from which it turns counterclockwise.
    Twist(Point),
}

impl Moved {
    /// The work of a unit force at a point along a direction, per unit of the motion.
    pub(crate) fn work(&self, point: Point, direction: Point) -> f64 {
        match self {
            Self::Along(along) => along.dot(direction),
            Self::Turn(centre, sense) => sense * (point - *centre).cross(direction),
            // What lies in a plane has no moment about a line of this plane.
            Self::Twist(_) => 0.0,
        }
    }

    /// The work of a unit moment, counterclockwise in the drawing.
    pub(crate) fn work_of_moment(&self) -> f64 {
        match self {
            Self::Along(_) | Self::Twist(_) => 0.0,
            Self::Turn(_, sense) => *sense,
        }
    }
}

/// 1 if the arrow of a force points along a direction, −1 if against it.
pub(crate) fn sense(
    body: &CutBody,
    force: &Force,
    moved: &[Moved],
    at: Point,
    along: Point,
) -> Result<f64, FreeFault> {
    let first = force
        .signs
        .iter()
        .zip(moved)
        .find_map(|(sign, motion)| Some(((*sign)?, motion.work(at, along))));
    match first {
        Some((is_negative, work)) if work.abs() > SQUARE => Ok(if is_negative {
            -work.signum()
        } else {
            work.signum()
        }),
        _ => Err(fault(body, force)),
    }
}

/// Holds an arrow to the work of its force.
pub(crate) fn works(
    body: &CutBody,
    force: &Force,
    moved: &[Moved],
    at: Point,
    direction: Point,
    share: Option<f64>,
) -> Result<(), FreeFault> {
    let works = moved.iter().map(|motion| motion.work(at, direction));
    agrees(body, force, works)?;
    // A force has its whole letter along a displacement, or the share of it that is written.
    let along = moved
        .iter()
        .zip(&force.signs)
        .find_map(|(motion, sign)| match motion {
            Moved::Along(_) if sign.is_some() => Some(motion.work(at, direction)),
            _ => None,
        });
    let share = share.unwrap_or(1.0).abs();
    match along {
        Some(work) if (work.abs() - share).abs() > SQUARE => Err(fault(body, force)),
        _ => Ok(()),
    }
}

/// Holds the signs of works to those of the components.
pub(crate) fn agrees(
    body: &CutBody,
    force: &Force,
    works: impl Iterator<Item = f64>,
) -> Result<(), FreeFault> {
    let is_right = works.zip(&force.signs).all(|(work, sign)| match sign {
        None => work.abs() <= SQUARE,
        Some(is_negative) => work.abs() > SQUARE && (work < 0.0) == *is_negative,
    });
    if is_right {
        return Ok(());
    }
    Err(fault(body, force))
}

/// The moment of a link that is twisted about its own line: the axis of the twist, and its sense about it; nothing if no
/// twist is about it.
pub(crate) fn twisted(
    body: &CutBody,
    force: &Force,
    moved: &[Moved],
    out: Point,
) -> Result<Option<(Point, story::Sense)>, FreeFault> {
    let about = moved
        .iter()
        .zip(&force.signs)
        .find_map(|(motion, sign)| match motion {
            Moved::Twist(axis) if axis.cross(out).abs() <= SQUARE => Some((*axis, (*sign)?)),
            _ => None,
        });
    let Some((axis, is_negative)) = about else {
        return Ok(None);
    };
    let moment = if is_negative { -axis } else { axis };
    let works = moved.iter().map(|motion| match motion {
        Moved::Twist(own) => own.dot(moment),
        Moved::Along(_) | Moved::Turn(..) => 0.0,
    });
    agrees(body, force, works)?;
    let sense = if is_negative {
        story::Sense::AgainstTwist
    } else {
        story::Sense::WithTwist
    };
    Ok(Some((axis, sense)))
}

/// An arrow and its force do not do the same work.
pub(crate) fn fault(body: &CutBody, force: &Force) -> FreeFault {
    FreeFault::Work {
        body: body.name.clone(),
        force: force.name.to_string(),
    }
}
