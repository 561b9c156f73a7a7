//! Why a response cannot be read, where, and what to type instead.

use crate::source::Span;

/// What stands in the way of reading.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub(crate) enum Trouble {
    /// Nothing is there.
    #[error("a formula is missing here")]
    Missing,
    /// A text beyond the bound.
    #[error("this is too long to be read")]
    TooLong,
    /// Brackets within brackets beyond the bound.
    #[error("this is nested too deeply")]
    TooDeep,
    /// A word that is no name of the item.
    #[error("it is not clear what this means{0}")]
    Unknown(String),
    /// A name of the item that the answer may not use.
    #[error("the answer may not contain this{0}")]
    NotAllowed(String),
    /// A unit.
    #[error(
        "units do not belong into a formula: letters carry their own, and numbers are in SI units"
    )]
    Unit,
    /// A sign that is not understood.
    #[error("this sign is not understood here")]
    Sign,
    /// A number that cannot be held exactly.
    #[error("this number has too many digits")]
    Number,
    /// A bracket without its partner.
    #[error("this bracket has no partner")]
    Bracket,
    /// Two numbers side by side.
    #[error("a sign is missing before this number; write `*` for a product or `^` for a power")]
    NumberAfter,
    /// A list where one formula is due.
    #[error("one formula is due here, not a list; write decimals with a point")]
    List,
    /// A time behind an exponent, of which it may be a factor.
    #[error("does this belong to the exponent? Write brackets: `e^(-2 t)` or `e^(-2)*t`")]
    Exponent,
    /// `log`, of which people mean different things.
    #[error("write `ln` or `log10`")]
    Logarithm,
    /// A wrong number of arguments.
    #[error("`{name}` takes {count}")]
    Arguments {
        /// The function.
        name: &'static str,
        /// How many.
        count: String,
    },
    /// Two values at once.
    #[error("give one value, without `±`")]
    TwoValues,
    /// More than a symbol before an equals sign.
    #[error(
        "only the symbol that is asked may stand before an equals sign; solve for it and give the formula alone"
    )]
    Unsolved,
    /// Something after the end.
    #[error("this is left over; is a sign missing before it?")]
    LeftOver,
    /// No relation in an equation or inequality.
    #[error("an equals sign or an inequality sign is missing")]
    NoRelation,
    /// A unit at an entry of a list.
    #[error("give the unit once, behind the list in brackets")]
    UnitOfEntry,
    /// A list without brackets with `m` behind.
    #[error(
        "this ends with a letter or with a unit; put the list in brackets, and that behind them"
    )]
    UnitOrLetter,
    /// Symbols before the entries that do not ascend.
    #[error("give them in the order of the question, as a list without names")]
    Order,
    /// Rows of different lengths.
    #[error("the rows have different lengths")]
    Ragged,
}

/// What stands in the way, and where in the response.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct TypedError {
    pub(crate) trouble: Trouble,
    pub(crate) span: Span,
}

impl TypedError {
    pub(super) fn new(trouble: Trouble, start: usize, end: usize) -> Self {
        Self {
            trouble,
            span: Span::new(start, end.max(start)),
        }
    }

    /// A sentence for whoever typed `text`.
    pub(crate) fn sentence(&self, text: &str) -> String {
        const LONGEST_QUOTE: usize = 40;
        let place = text.get(self.span.range()).unwrap_or_default().trim();
        let short: String = place.chars().take(LONGEST_QUOTE).collect();
        let trouble = self.trouble.to_string();
        let stop = if trouble.ends_with('?') { "" } else { "." };
        if short.is_empty() {
            let before: String = text.chars().rev().take(12).collect();
            let before: String = before.chars().rev().collect();
            return format!("After `{}`: {trouble}{stop}", before.trim());
        }
        format!("At `{short}`: {trouble}{stop}")
    }
}
