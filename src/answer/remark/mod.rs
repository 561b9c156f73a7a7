//! What is said about a response, as data: [`crate::message`] has the sentences.
//!
//! A kind remarks what it found; in which words that is said depends on the language alone. The reasons of a marking,
//! which programs and statistics take, follow from its remarks.

mod slip;
mod terms;
mod unreadable;

pub use slip::{Close, Decades, Negated, Scaling, Shape, Slip, TwoPi};
pub use terms::{Coefficient, Fault, Linearity, Term, TermKind, Terms};
pub use unreadable::{Example, Unreadable, Why};

use super::Reason;
use crate::document::Document;
use crate::expr::CheckError;
use crate::math::Math;
use crate::unit::{Dimension, Unit};

/// What is said about a response.
#[derive(Clone, Debug, PartialEq)]
pub enum Remark {
    /// It is the mistake of this number that the item names, from 0; the item has the text.
    Mistake(usize),
    /// It is an option to which the item has a text, without placeholders.
    Option(Document),
    /// It is right for the student's own answers to what has these symbols; to equations where there are none.
    Followed(Vec<Math>),
    /// It is wrong, in a way that can be named.
    Slip(Slip),
    /// Its dimension is not the one that is asked.
    Dimension(Misfit),
    /// It could not be read.
    Unreadable(Unreadable),
    /// It is right, or nearly so, and something is to be said all the same.
    Note(Note),
}

/// How a dimension fails to be the one that is asked.
#[derive(Clone, Debug, PartialEq)]
pub enum Misfit {
    /// A unit that does not fit what is asked.
    Unit {
        /// As it was typed.
        typed: Unit,
        /// In which the answer is asked.
        asked: Unit,
    },
    /// A complex number in another unit.
    UnitOf(Unit),
    /// A unit after a count.
    Count,
    /// A formula that comes out in another dimension.
    Comes {
        /// The entry of a matrix, by row and column from 1.
        entry: Option<(usize, usize)>,
        /// In which it comes out.
        found: Dimension,
        /// The unit that is asked, where it has a name.
        unit: Option<Unit>,
        /// What is asked; none where it goes without saying.
        asked: Option<Dimension>,
    },
    /// A step that goes against the dimensions, such as a sum of unlike terms.
    Step {
        /// The entry of a matrix, by row and column from 1.
        entry: Option<(usize, usize)>,
        /// What is wrong.
        error: Option<CheckError>,
    },
    /// A bound in another unit than the variable.
    BoundUnit {
        /// Symbol of the variable.
        symbol: String,
        /// As it was typed.
        typed: Unit,
        /// That of the variable.
        asked: Unit,
    },
    /// A bound of another dimension than the variable.
    Bound {
        /// As it was typed.
        typed: String,
        /// As it was read.
        read: String,
        /// Symbol of the variable.
        symbol: String,
    },
}

/// What is said beside a verdict that needs no reason.
#[derive(Clone, Debug, PartialEq)]
pub enum Note {
    /// Numbers without a unit were taken in this one.
    TakenIn(Unit),
    /// Of two readings this one counts.
    TakenAs {
        /// The one that counts.
        taken: String,
        /// The reading that was set aside.
        other: String,
    },
    /// A number of significant figures is asked.
    Figures {
        /// The number of significant figures that the part asks for.
        asked: u32,
        /// The number, and how many it has; none of arithmetic.
        typed: Option<(String, u32)>,
    },
    /// The joule is kept for energies; the unit of the answer is another one.
    JouleForMoment(Unit),
    /// Right, though a step goes against the dimensions.
    RightBut(Misfit),
    /// A unit was typed after letters, which carry their own.
    LettersCarryUnits(String),
    /// Right together with the equations of other parts.
    RightTogether,
    /// Right; other equations were given that other parts ask for.
    OthersBelongElsewhere,
    /// Right in another form than the one that is asked: a value for a formula, or a formula for a value.
    OtherForm,
    /// Right with the values of the sheet in place of letters.
    WithValues,
    /// Right with symbols that the response leaves open as textbooks define them.
    ByTextbooks,
    /// Right but for the rounding of the numbers in a formula.
    RoundedNumbers,
    /// More free constants than it needs.
    ConstantsToSpare {
        /// How many would do.
        needed: usize,
        /// How many there are.
        found: usize,
    },
}

impl Remark {
    /// What could not be read, without a place.
    pub fn unreadable(why: Why) -> Self {
        Self::Unreadable(Unreadable::of(why))
    }

    /// The reason that it gives for a verdict, if it gives one.
    pub fn reason(&self) -> Option<Reason> {
        match self {
            Self::Mistake(number) => Some(Reason::Mistake(*number)),
            Self::Followed(_) => Some(Reason::FollowThrough),
            Self::Slip(slip) => Some(slip.reason()),
            Self::Dimension(_) => Some(Reason::Dimension),
            Self::Unreadable(_) => Some(Reason::Unreadable),
            Self::Option(_) => None,
            Self::Note(note) => match note {
                Note::TakenIn(_) => Some(Reason::NoUnit),
                Note::Figures { .. } => Some(Reason::Figures),
                _ => None,
            },
        }
    }
}

impl From<Slip> for Remark {
    fn from(slip: Slip) -> Self {
        Self::Slip(slip)
    }
}

impl From<Misfit> for Remark {
    fn from(misfit: Misfit) -> Self {
        Self::Dimension(misfit)
    }
}

impl From<Note> for Remark {
    fn from(note: Note) -> Self {
        Self::Note(note)
    }
}
