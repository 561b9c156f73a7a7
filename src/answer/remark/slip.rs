//! What makes a response wrong, where that can be named.

use super::Terms;
use crate::answer::Reason;
use crate::unit::{Quantity, Unit};

/// In what a response differs from the key.
#[derive(Clone, Debug, PartialEq)]
pub enum Slip {
    /// A factor 2π.
    TwoPi(TwoPi),
    /// A factor 2π too many or too few, and where it slipped.
    PowerOfTen(Decades),
    /// The value of the key with the opposite sign.
    Sign(Negated),
    /// Degrees in place of radians, or the other way round; the unit that was typed or asked.
    AngleUnit(Unit),
    /// A phase in degrees without their sign.
    PhaseInDegrees,
    /// It is near the key but not within its tolerance.
    Near(Close),
    /// It is right up to its scale.
    Scale(Scaling),
    /// The magnitude of a complex number is right, its angle is not.
    Angle,
    /// An angle that is right but for whole turns, where it is asked within an interval with these ends.
    OutsideInterval(Box<[Quantity; 2]>),
    /// No integer where one is asked.
    NotInteger,
    /// The sides of a statement are not equal.
    UnequalSides,
    /// A function or formula without a value for data for which there is an answer.
    NoValueForData,
    /// A function without a value somewhere on its span.
    NoValueOnSpan,
    /// Functions without values at some times.
    NoValueAtTimes,
    /// Zero, where the key is not.
    Zero,
    /// A factor that is a number alone.
    Factor,
    /// A motion that begins as the key does and departs from it later.
    RunsAway,
    /// All entries of a matrix off by one factor.
    CommonFactor,
    /// The entries for the coordinates in another order.
    OtherOrder,
    /// A ranking from its end to its beginning.
    Reversed,
    /// Entries of a matrix, by row and column from 1.
    Entries(Vec<(usize, usize)>),
    /// Another number of intervals than there are.
    CountOfIntervals,
    /// Mode shapes: what is wrong with which.
    Shapes(Vec<Shape>),
    /// Mode shapes that are multiples of one another.
    DependentShapes,
    /// A shape without a motion.
    NoMotion,
    /// A general solution that does not satisfy the equations of motion.
    Unsatisfied,
    /// A solution whose constants cannot meet every initial state.
    NotGeneral,
    /// A solution with fewer free constants than a general one has: a letter of the question is no constant.
    TooFewConstants {
        /// How many it has.
        found: usize,
        /// How many are needed.
        needed: usize,
    },
    /// A solution in which a constant is neither a factor nor a phase.
    NotFactors,
    /// An equation that follows from those of the system, but is not the one that is asked.
    OtherEquation,
    /// Equations that hold for any motion.
    Tautology,
    /// Fewer independent equations than are asked; `found` counts those among the typed ones.
    Fewer {
        /// How many were typed.
        typed: usize,
        /// How many of these are independent.
        found: usize,
        /// How many are asked.
        needed: usize,
    },
    /// Terms of an equation.
    Terms(Terms),
    /// How many numbers of a list are right.
    Counted {
        /// Right ones, in any order.
        right: usize,
        /// How many are asked.
        of: usize,
        /// How many are given, where they are too many.
        surplus: Option<usize>,
        /// Whether their order is wrong.
        is_order_wrong: bool,
    },
    /// How many complex numbers of a list are right.
    CountedComplex {
        /// Right ones.
        right: usize,
        /// How many are asked.
        of: usize,
    },
}

/// Where a factor 2π slipped.
#[derive(Clone, Debug, PartialEq)]
pub enum TwoPi {
    /// A formula that is 2π times the key, or its 2πth part.
    Formula,
    /// In a formula for a frequency or a period.
    Frequency,
    /// In a number, between an angular and a cyclic frequency.
    Number,
    /// Between a unit that counts cycles and the one that is asked.
    Cycles {
        /// As it was typed.
        typed: Box<Unit>,
        /// That of the key.
        asked: Box<Unit>,
    },
    /// In the argument of a sine or cosine.
    Wave,
}

/// What a power of ten comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum Decades {
    /// A factor of ten to an integer power, as a forgotten or mistaken prefix leaves it.
    Prefix,
    /// A percentage without its sign.
    Percent,
    /// A function in another unit than this one.
    Function(Unit),
}

/// What has the wrong sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Negated {
    /// All of it.
    Whole,
    /// A number whose magnitude fits.
    Number,
    /// An angle that was measured in the opposite direction.
    Angle,
    /// The imaginary part.
    Imaginary,
    /// All entries of a matrix.
    Entries,
}

/// How a response is near the key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Close {
    /// A number, or a function in numbers, a little outside the tolerance.
    Rounding,
    /// A formula with rounded numbers in it.
    RoundedFormula,
    /// A function in letters that differs from the key, though not by much for these data.
    Function,
    /// An interval with the right bounds and the wrong ends.
    Ends,
}

/// The scale in which shapes are asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scaling {
    /// Their first component is 1.
    First,
    /// Their modal mass is 1.
    Mass,
}

/// What is wrong with a mode shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// It is that of another mode.
    OfMode {
        /// Which it is, from 1.
        found: usize,
        /// The mode that the part asks for at this place, from 1.
        asked: usize,
    },
    /// Only signs of its components are wrong.
    Reversed,
    /// Neither of these: the number of the mode, from 1.
    Wrong(usize),
}

impl Slip {
    /// The reason that it is for statistics.
    pub fn reason(&self) -> Reason {
        match self {
            Self::TwoPi(_) => Reason::TwoPi,
            Self::PowerOfTen(_) => Reason::PowerOfTen,
            Self::Sign(_) => Reason::Sign,
            Self::AngleUnit(_) | Self::PhaseInDegrees => Reason::AngleUnit,
            Self::Near(_) => Reason::Near,
            Self::Scale(_) => Reason::Scale,
            Self::Terms(terms) if terms.is_sign() => Reason::Sign,
            Self::Shapes(shapes) if shapes.iter().all(|shape| *shape == Shape::Reversed) => {
                Reason::Sign
            }
            _ => Reason::Other,
        }
    }
}
