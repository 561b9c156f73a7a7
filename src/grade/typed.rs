//! A response as it is marked: folded once, however often it is looked at.

use std::cell::OnceCell;

use super::MAX_RESPONSE_LENGTH;
use crate::response::{Folded, LoneDollar, behind_arrow};

/// What was typed, and the same in one spelling: other forms of the answer, follow-through and the equations of other
/// parts look at it again.
#[derive(Debug, Default)]
pub(crate) struct TypedResponse<'r> {
    typed: &'r str,
    folded: OnceCell<Result<Folded<'r>, LoneDollar>>,
}

impl<'r> TypedResponse<'r> {
    /// What was typed, without the spaces around it.
    pub(crate) fn new(typed: &'r str) -> Self {
        Self {
            typed: typed.trim(),
            folded: OnceCell::new(),
        }
    }

    pub(crate) fn typed(&self) -> &'r str {
        self.typed
    }

    /// Whether nothing so long is read.
    pub(crate) fn is_too_long(&self) -> bool {
        self.typed.len() > MAX_RESPONSE_LENGTH
    }

    /// In one spelling, without an arrow before it.
    ///
    /// # Errors
    ///
    /// As [`Folded::of`].
    pub(crate) fn folded(&self) -> Result<&Folded<'r>, LoneDollar> {
        let folded = self
            .folded
            .get_or_init(|| Folded::of(behind_arrow(self.typed)));
        folded.as_ref().map_err(|dollar| *dollar)
    }
}
