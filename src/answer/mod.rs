//! Answer kinds: what a part asks for, how a response to it is read and how it is marked.
//!
//! Each kind is a module, listed in [`AnswerKind`]. Reading an item asks the kind
//! for an [`Answer`]: what this part asks for, whatever the data. With the values of an instance the
//! answer is prepared into a [`Marker`], which knows the key, the tolerance and the named mistakes,
//! and marks any number of responses.
//!
//! A response that cannot be read is not a wrong one: it is [`Verdict::Unreadable`], with a message
//! that says where and what to type instead.

mod answered;
mod band;
mod blank;
mod bound;
mod choice;
mod declare;
mod echo;
mod equality;
mod equation;
mod error;
mod formula;
mod function;
mod integer;
mod interval;
mod kind;
mod letters;
mod marking;
mod matrix;
mod meaning;
mod mode_shape;
mod naming;
mod numeric;
mod recalled;
mod remark;
mod rounded;
mod settle;
mod shared;
mod steps;
mod symbolic;
mod tolerance;
mod trial;
mod work;

pub use answered::{Answered, Bounds};
pub use band::Band;
pub use blank::{Asked, Blank, Entries, Letter, ShapeScale};
pub use declare::{Context, Declare, Known, Mistaken, Role};
pub use echo::Echo;
pub use equality::{Drawn, Sampling};
pub use error::AnswerError;
pub use kind::AnswerKind;
pub use marking::{Credit, Key, KeyValue, Marking, Reading, Reason, Verdict};
pub(crate) use naming::Naming;
pub(crate) use numeric::are_one_value;
pub use recalled::Recalled;
pub use remark::{
    Close, Coefficient, Decades, Example, Fault, Linearity, Misfit, Negated, Note, Remark, Scaling,
    Shape, Slip, Term, TermKind, Terms, TwoPi, Unreadable, Why,
};
pub use settle::Doubt;
pub(crate) use symbolic::without_paths;
pub use tolerance::Tolerance;
pub use trial::{Nature, Trial};
#[cfg(feature = "render")]
pub use work::Criterion;

use std::sync::Arc;

use crate::document::Document;
use crate::expr::{Equation, Name, Precise};
use crate::numerics::Complex;
use crate::quantity::{Absent, Evaluation, NodeId};
use crate::response::{AskedBound, Passage};
pub use crate::response::{At, Trouble};
use crate::source::{Table, Value};
use crate::unit::Unit;

/// What a part asks for, whatever the data.
pub trait Answer: Send + Sync {
    /// The kind as the item file names it.
    fn kind(&self) -> AnswerKind;

    /// The minutes that it takes, if the item does not say.
    fn minutes(&self) -> u32 {
        self.kind().minutes()
    }

    /// What the points are given for where a person marks.
    #[cfg(feature = "render")]
    fn rubric(&self) -> &[Criterion] {
        &[]
    }

    /// The formulas of the key: what the scene of a key demands, and what a mistake may replace.
    fn keys(&self) -> Vec<NodeId>;

    /// What its answer line says.
    fn blank(&self) -> Blank;

    /// The unit that is printed after the blank.
    fn unit(&self) -> Option<Unit> {
        None
    }

    /// The bound of a quantity that is asked for, where it is one.
    fn bound(&self) -> Option<AskedBound> {
        None
    }

    /// The letter whose values are asked for, where they are more than one: that of an interval.
    fn ranging(&self) -> Option<&crate::math::Math> {
        None
    }

    /// The significant figures that are asked for.
    fn figures(&self) -> u32 {
        3
    }

    /// Whether the part states its tolerance.
    fn states_tolerance(&self) -> bool {
        false
    }

    /// The named mistake of this number as a response, where the kind keeps it as one.
    fn kept_mistake(&self, _number: usize) -> Option<String> {
        None
    }

    /// The options of a choice, in the order of the file.
    fn options(&self) -> &[Choosable] {
        &[]
    }

    /// The one option that is right whatever the data, by its place in the file.
    fn always_right(&self) -> Option<usize> {
        None
    }

    /// How one chooses among the options, if there are any.
    fn choosing(&self) -> Option<Choosing> {
        None
    }

    /// Whether the options are shuffled.
    fn shuffles(&self) -> bool {
        false
    }

    /// What asks for the same in the other form, a value in place of a formula or a formula in place of a value.
    fn other_form(&self) -> Option<&dyn Answer> {
        None
    }

    /// Whether named mistakes are compared as formulas; otherwise by their values.
    fn keeps_mistakes(&self) -> bool {
        false
    }

    /// Whether a response is marked with those to the item's other parts of this kind at hand.
    fn heeds_others(&self) -> bool {
        false
    }

    /// Reads the answer of the named mistake of this number, written as a response of this kind in formulas.
    /// What is returned is computed for an instance; what the answer keeps for itself is not.
    fn read_mistake(
        &mut self,
        _number: usize,
        answer: &Value,
        part: &Table<'_>,
        declare: &mut dyn Declare,
    ) -> Option<Vec<NodeId>> {
        let text = part.as_formula("answer", answer)?;
        Some(vec![declare.formula("mistake", &text)?])
    }

    /// The key as it is printed, from a kind that has it without preparing what marks; such a kind knows
    /// no distance of mistakes.
    fn printed(&self, _evaluation: &Evaluation<'_>) -> Option<Result<Arc<Key>, Absent>> {
        None
    }

    /// The key for these data, with what marking needs.
    ///
    /// # Errors
    ///
    /// Why the key does not exist for these data.
    fn prepare<'t>(&self, context: &Context<'t>) -> Result<Box<dyn Marker + 't>, Absent>;
}

/// Its kind alone: what all kinds hold would travel in each page with its way to be printed.
impl std::fmt::Debug for dyn Answer {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Answer({:?})", self.kind())
    }
}

/// A key with its tolerance and named mistakes: marks responses.
pub trait Marker {
    /// The key as it is printed and as programs get it.
    fn key(&self) -> Key;

    /// The number of the key in SI units, where it is one.
    fn number(&self) -> Option<f64> {
        self.key().number()
    }

    /// Marks a response that is not empty.
    fn mark(&self, response: Passage<'_>) -> Marking;

    /// How a response is read while it is typed, whatever the key.
    ///
    /// # Errors
    ///
    /// Why it cannot be read.
    fn echo(&self, response: Passage<'_>) -> Result<Echo, Unreadable> {
        Echo::of_marking(self.mark(response))
    }

    /// Marks a response with those to the item's other parts of this kind at hand.
    fn mark_beside(&self, response: Passage<'_>, _others: &[Beside<'_>]) -> Marking {
        self.mark(response)
    }

    /// Whether a condition that is said beside an answer holds somewhere in the domain of the item.
    fn may_hold(&self, _condition: Passage<'_>) -> bool {
        true
    }

    /// The right answers that are so for other data, too; none where a verdict depends on the data, and once one was asked
    /// for that does.
    fn recalled(&self) -> Option<&Recalled> {
        None
    }

    /// The equations of the key and those that a response is, where equations are asked.
    fn equations(&self, _response: Passage<'_>) -> Option<Equations> {
        None
    }

    /// Responses that test this kind with this key: right and borderline ones, wrong ones, a wrong unit, unreadable ones.
    #[cfg(feature = "render")]
    fn trials(&self) -> Vec<Trial>;
    /// The same where nobody asks for them: out of the trait object, and so out of the page.
    #[cfg(not(feature = "render"))]
    fn trials(&self) -> Vec<Trial>
    where
        Self: Sized;

    /// The least distance of a named mistake from the key, in tolerances, if it is below `limit`; `None` without a mistake
    /// that differs.
    fn clearance(&self, limit: f64) -> Option<f64> {
        let _ = limit;
        None
    }

    /// The ranges of numbers that are marked alike, for each value that is asked: the first that fits counts. Empty where
    /// ranges do not say how a response is marked.
    #[cfg(feature = "render")]
    fn bands(&self) -> Vec<Vec<Band>> {
        Vec::new()
    }
    /// The same where nothing is exported.
    #[cfg(not(feature = "render"))]
    fn bands(&self) -> Vec<Vec<Band>>
    where
        Self: Sized,
    {
        Vec::new()
    }

    /// How far numbers in SI units are from those of the key, in tolerances, with whole turns of an angle taken off:
    /// the farthest decides. None where the kind has no tolerance around numbers, or there are not as many.
    fn distance(&self, _si: &[f64]) -> Option<f64> {
        None
    }

    /// The times at which functions are compared with the key, and its values there; none where no functions are asked.
    fn samples(&self) -> (&[Precise], &[f64]) {
        (&[], &[])
    }

    /// Whether functions are compared beyond these times, too, where what is near at them may be told apart.
    fn looks_later(&self) -> bool {
        false
    }

    /// Whether rounding leaves less of the key than answers are marked by.
    fn is_uncertain(&self) -> bool {
        false
    }

    /// Whether a named mistake that is not worth everything is the very key for these data.
    fn is_mistaken_key(&self) -> bool {
        false
    }

    /// The named mistake of this number as it is typed for these data, from a kind that alone can write it.
    fn typed_mistake(&self, _number: usize) -> Option<String> {
        None
    }

    /// How far each number of the key may be off, in SI units; empty where the kind has no such numbers.
    fn half_widths(&self) -> Vec<f64> {
        Vec::new()
    }
}

/// A response to another part of the same item.
#[derive(Clone, Copy)]
pub struct Beside<'a> {
    /// What marks it.
    pub marker: &'a dyn Marker,
    /// What was answered; may be empty.
    pub response: Passage<'a>,
}

/// What a part that asks for equations asks for, and what it got.
#[derive(Clone, Debug, PartialEq)]
pub struct Equations {
    /// In what they are.
    pub unknowns: Vec<Name>,
    /// Those of the key.
    pub key: Vec<Equation>,
    /// Those of the response; none if there is none, or it cannot be read.
    pub typed: Vec<Equation>,
}

/// How one chooses among options.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choosing {
    /// One of them.
    One,
    /// Any number of them.
    Several,
    /// All of them, in order.
    Ranking,
}

impl Choosing {
    /// Its name for programs.
    pub fn name(self) -> &'static str {
        match self {
            Self::One => "one",
            Self::Several => "several",
            Self::Ranking => "ranking",
        }
    }
}

/// An option of a choice.
#[derive(Clone, Debug)]
pub struct Choosable {
    /// Its identity.
    pub id: String,
    /// What is printed beside its letter.
    pub text: Document,
}

/// The complex number in SI units that a text is, as a response would be read; without a unit it is in `unit`.
///
/// ```
/// use vibank::answer::complex_number;
/// use vibank::unit::Unit;
///
/// let ohm = Unit::parse("ohm").unwrap();
/// let impedance = complex_number("3 - 4i kohm", &ohm).unwrap();
/// assert_eq!((impedance.re, impedance.im), (3000.0, -4000.0));
/// assert!(complex_number("3 - 4i V", &ohm).is_none());
/// ```
pub fn complex_number(text: &str, unit: &Unit) -> Option<Complex> {
    let (value, stated) = numeric::complex_number(text)?;
    let stated = stated.unwrap_or(*unit);
    let fits = stated.dimension() == unit.dimension();
    fits.then(|| Complex::new(stated.to_si(value.re), stated.to_si(value.im)))
}
