//! Why a response could not be read, where, and what to type instead.

use crate::expr::CheckError;
use crate::quantity::Absent;
use crate::response::{At, Folded, LoneDollar, Passage, Trouble, TypedError, is_customary};
use crate::unit::{Quantity, Unit};

/// Why a response could not be read.
#[derive(Clone, Debug, PartialEq)]
pub struct Unreadable {
    /// Where, if it is a place.
    pub at: Option<At>,
    /// What stands in the way.
    pub why: Box<Why>,
    /// What is shown for imitation.
    pub example: Option<Example>,
}

/// What is shown for imitation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Example {
    /// Numbers with units.
    Number,
    /// Numbers with the unit last.
    UnitLast,
    /// Complex numbers.
    Complex,
    /// Inequalities and intervals.
    Interval,
    /// One value, alone or after its name.
    OneValue,
}

/// What stands in the way of reading, or of marking what was read.
#[derive(Clone, Debug, PartialEq)]
pub enum Why {
    /// Nothing but the example.
    Form,
    /// A text beyond the bound.
    TooLong,
    /// A text of more bytes than this.
    LongerThan(usize),
    /// A part that has no key for these data.
    NoKey(Absent),
    /// A dollar sign that encloses nothing.
    Dollar,
    /// A response that is struck out, or that says that it is wrong.
    Withdrawn,
    /// A formula that cannot be read.
    Formula(Trouble),
    /// A decimal or a unit that cannot be read.
    Quantity(crate::unit::Error),
    /// A formula whose dimensions do not fit.
    Dimension(Option<CheckError>),

    /// Letters in a number.
    Letters,
    /// A unit before the end of a number.
    UnitNotLast,
    /// What is counted, after a number.
    Counted(String),
    /// What is counted, by a unit such as a turn.
    CountedUnit,
    /// A number alone is asked, without what it counts.
    NumberAlone,
    /// Two signs before a number.
    TwoSigns(String),
    /// A text without a value.
    NoValue(String),
    /// `2e`, which may lack its exponent.
    ExponentMissing(String),
    /// `19-21`, a range or a difference.
    RangeOrDifference(String),
    /// An angle in degrees beside one without a unit.
    MixedDegrees,
    /// Two units after one number.
    TwoUnits,
    /// `1,250`: how it reads with a decimal sign and without.
    CommaOfThree {
        /// As it was typed.
        typed: String,
        /// With a decimal comma.
        decimal: String,
        /// With a separator of thousands.
        thousands: String,
    },
    /// `162.10^-3`, a decimal sign or a product, and the number before it.
    PointOrProduct(String),
    /// `0.29 (2/7)`.
    BracketAfterNumber,
    /// An inequality where one value is asked.
    Inequality,
    /// A zero in a unit that is not that of the other side of its equation.
    UnitOfZero,
    /// Two sides that are not equal.
    UnequalSides(String, String),
    /// A side of which the value may be or not.
    UnclearSide,
    /// An angle of too many turns.
    TooManyTurns {
        /// The number of turns beyond which an angle is refused.
        times: u32,
        /// One of them.
        turn: Quantity,
    },
    /// `g` where an acceleration is asked.
    Gram,
    /// Angles that enter a unit otherwise than in this one, which is asked.
    AngleInUnit(Unit),
    /// Another quantity than the one that is asked before an equals sign.
    OtherQuantity,
    /// Symbols whose order is not that of their values.
    LabelsInOtherOrder,
    /// Two values of a list have the same symbol.
    LabelTwice,
    /// Nothing between two signs that part values.
    EmptyPlace,
    /// More numbers than this.
    MostNumbers(usize),
    /// Commas between digits in a list.
    TightComma,
    /// An angle without a unit that is too large for radians.
    AngleWithoutUnit(String),
    /// An angle in a unit that does not measure angles.
    AngleUnit,
    /// Several complex numbers where one is asked.
    SeveralComplex,

    /// No option of a choice; the last letter.
    NoOption(char),
    /// Several options where one is asked.
    OneOption,
    /// Not all options of a ranking, each once.
    Ranking(usize),

    /// Inequalities side by side.
    JoinInequalities,
    /// Conditions that no value meets.
    NoneSatisfies(String),
    /// More inequalities in a chain than bound a value.
    LongChain,
    /// Two signs of inequality that point the same way.
    SameWay,
    /// Neither an inequality nor an interval.
    NoInterval,
    /// Something before an interval; the symbol of the variable.
    BeforeInterval(String),
    /// A bracket of an interval.
    IntervalBracket,
    /// No unit, after an interval.
    NoUnit,
    /// An interval without two ends.
    TwoEnds,
    /// An inequality that is not solved for this symbol or its distance.
    SolveForDistance(String),
    /// An inequality that is not solved for this symbol.
    SolveFor(String),
    /// An inequality without this symbol.
    NotInInequality(String),
    /// Bounds in the wrong order.
    BoundsOrder,
    /// Bounds as formulas, where they are asked so.
    BoundsAsFormulas,
    /// Bounds as numbers, where they are asked so.
    BoundsAsNumbers,
    /// A bound without a value.
    BoundValue,

    /// A number where a formula is asked.
    FormulaNotNumber,
    /// A formula that cannot be compared.
    Incomparable,
    /// A formula of which no digits are left when it is computed.
    DigitsLost,
    /// Two readings, of which one may be right.
    TwoReadings(String, String),
    /// A unit after letters that does not fit.
    UnitBehindLetters,
    /// A unit after letters that come out in another one by themselves.
    UnitComesOut(Option<Unit>),

    /// No equals sign.
    NoEquation,
    /// An inequality where an equation is asked.
    NotInequality,
    /// The number of an equation.
    EquationNumber,
    /// The state at the start, beside an equation.
    InitialState,
    /// An equation that cannot be compared.
    IncomparableEquation,
    /// Right but for the rounding of numbers that a formula asks for exactly.
    RoundedNumbers,
    /// A number that may be right has fewer figures than are asked for.
    Figures {
        /// The number of significant figures that are asked for.
        asked: u32,
        /// The number as it was typed.
        number: String,
        /// The significant figures of the number.
        has: u32,
    },
    /// Values in place of the letters of the question.
    ValuesForLetters,

    /// Entries as numbers, where they can only be compared so.
    EntriesAsNumbers,
    /// Entries that cannot be compared.
    IncomparableEntries,
    /// A unit after a matrix of formulas.
    UnitBehindMatrix,
    /// Another shape than that of the matrix.
    Shape {
        /// Rows and columns that were typed.
        found: (usize, usize),
        /// Those that are asked.
        asked: (usize, usize),
    },
    /// Formulas where numbers are asked.
    NumbersNotFormulas,
    /// Numbers where formulas are asked.
    FormulasNotNumbers,
    /// An entry without a value.
    EntryValue,
    /// A unit that does not fit all entries.
    UnitOfEntries(Unit),

    /// Components in several units after which one stands.
    UnitOfComponents,
    /// A unit that is not that of a shape with unit modal mass.
    UnitOfShape(Unit),
    /// A component without a value.
    ComponentValue,
    /// Another number of components than one shape has.
    Components {
        /// How many were typed.
        found: usize,
        /// How many are asked.
        asked: usize,
    },
    /// Another number of components than several shapes have.
    ShapesOf {
        /// How many were typed.
        found: usize,
        /// The rows that were typed, of which each should be a shape.
        rows: usize,
        /// How many shapes are asked.
        shapes: usize,
        /// Components of each.
        width: usize,
    },

    /// Sides of the equals sign before this that are not the same function.
    UnequalFunctions(String),
    /// A function that is said to hold where it is not asked.
    OutsideOfSpan,
    /// A letter that may be a unit or a quantity.
    UnitOrQuantity,
    /// An angle that is added to a function.
    AngleAdded,
    /// Units at some terms.
    UnitOfTerms,
    /// A unit in the argument of a function that is neither that of an angle nor a rate before the time.
    UnitOfArgument,
    /// A unit that does not fit; the one that is asked.
    UnitOfFunction(Unit),
    /// Several functions where one is asked, as it is written.
    OneFunction(String),
    /// Another function than the one that is asked, as it is written.
    OtherFunction(String),
    /// What may stand for the function that is asked, as it is written.
    UnclearFunction(String),
    /// Another number of functions than these symbols ask for.
    Functions(Vec<String>),
    /// Two functions for this symbol.
    TwoFunctions(String),
    /// A function too few.
    FunctionMissing,
    /// Functions that cannot be differentiated.
    Undifferentiable,
    /// More free constants than a response may use.
    TooManyConstants {
        /// How many it may use.
        most: usize,
        /// How many would do.
        needed: usize,
    },
}

impl Unreadable {
    /// Without a place.
    pub fn of(why: Why) -> Self {
        Self {
            at: None,
            why: Box::new(why),
            example: None,
        }
    }

    /// Of a text that could not be read.
    pub fn typed(error: &TypedError, passage: Passage<'_>) -> Self {
        Self {
            at: Some(error.at(passage)),
            why: Box::new(Why::Formula(error.trouble.clone())),
            example: None,
        }
    }

    /// At these signs.
    pub fn at(place: impl Into<String>, why: Why) -> Self {
        Self {
            at: Some(At::Here(place.into())),
            why: Box::new(why),
            example: None,
        }
    }

    /// With its place as it was typed, in place of how it was read; none where nothing was typed for it.
    pub(crate) fn point_at_typed(&mut self, folded: &Folded<'_>) {
        self.at = self.at.as_ref().and_then(|at| folded.typed_at(at));
    }

    /// The symbol of the field at which reading stopped, where it would be read if the answer said what it is.
    pub(crate) fn undefined(&self) -> Option<&str> {
        let is_open = matches!(
            *self.why,
            Why::Formula(Trouble::Unknown { near: None, .. } | Trouble::NotAllowed(_))
        );
        match &self.at {
            Some(At::Here(place)) if is_open && is_customary(place) => Some(place),
            _ => None,
        }
    }

    /// With an example.
    #[must_use]
    pub fn like(mut self, example: Example) -> Self {
        self.example = Some(example);
        self
    }
}

impl From<LoneDollar> for Unreadable {
    fn from(_: LoneDollar) -> Self {
        Self::at("$", Why::Dollar)
    }
}

impl From<Why> for Unreadable {
    fn from(why: Why) -> Self {
        Self::of(why)
    }
}
