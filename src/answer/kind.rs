//! The kinds of answers.

use serde::{Serialize, Serializer};

use super::{
    Answer, Declare, choice, equation, formula, function, integer, interval, matrix, mode_shape,
    numeric, work,
};
use crate::source::Table;

/// A kind of answer: what is typed, and how it is marked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum AnswerKind {
    /// A real or complex number with a unit, or a list of numbers.
    Numeric,
    /// An integer, such as a count.
    Integer,
    /// A formula in symbols.
    Formula,
    /// A matrix of formulas or numbers.
    Matrix,
    /// Intervals of values.
    Interval,
    /// A function of one variable, or a general solution.
    Function,
    /// Equations, such as those of motion.
    Equation,
    /// The components of one or more modes of a system.
    ModeShape,
    /// One or several of listed options.
    Choice,
    /// Work on paper, which a person marks.
    Work,
}

impl AnswerKind {
    /// All kinds.
    pub const ALL: &[Self] = &[
        Self::Numeric,
        Self::Integer,
        Self::Formula,
        Self::Matrix,
        Self::Interval,
        Self::Function,
        Self::Equation,
        Self::ModeShape,
        Self::Choice,
        Self::Work,
    ];

    /// The kind of this name.
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|kind| kind.name() == name)
    }

    /// Its name in item files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Numeric => "numeric",
            Self::Integer => "integer",
            Self::Formula => "formula",
            Self::Matrix => "matrix",
            Self::Interval => "interval",
            Self::Function => "function",
            Self::Equation => "equation",
            Self::ModeShape => "mode-shape",
            Self::Choice => "choice",
            Self::Work => "work",
        }
    }

    /// The minutes that a part of this kind takes, if the item does not say.
    pub fn minutes(self) -> u32 {
        match self {
            Self::Numeric => 3,
            Self::Integer => 2,
            Self::Formula => 4,
            Self::Matrix => 5,
            Self::Interval => 4,
            Self::Function => 6,
            Self::Equation => 6,
            Self::ModeShape => 5,
            Self::Choice => 1,
            Self::Work => 10,
        }
    }

    /// Whether a person marks it: it has no key.
    pub fn is_by_hand(self) -> bool {
        self == Self::Work
    }

    /// Reads the keys of a part that belong to this kind; what is wrong is noted.
    pub fn read(self, part: &Table<'_>, declare: &mut dyn Declare) -> Option<Box<dyn Answer>> {
        match self {
            Self::Numeric => numeric::read(part, declare),
            Self::Integer => integer::read(part, declare),
            Self::Formula => formula::read(part, declare),
            Self::Matrix => matrix::read(part, declare),
            Self::Interval => interval::read(part, declare),
            Self::Function => function::read(part, declare),
            Self::Equation => equation::read(part, declare),
            Self::ModeShape => mode_shape::read(part, declare),
            Self::Choice => choice::read(part, declare),
            Self::Work => work::read(part, declare),
        }
    }
}

impl Serialize for AnswerKind {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}
