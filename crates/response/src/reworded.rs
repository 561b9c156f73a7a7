//! What is read in place of what was typed, where a spelling is recognized by more than its signs.

use super::Passage;

/// A passage in other words than it was typed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reworded(String);

impl Reworded {
    pub(crate) fn of(text: String) -> Self {
        Self(text)
    }

    /// As it is read.
    pub fn passage(&self) -> Passage<'_> {
        Passage::of(&self.0)
    }
}

/// Whether a letter stands alone in a text.
fn contains_letter(text: &str, letter: &str) -> bool {
    text.split(|char: char| !char.is_alphabetic())
        .any(|word| word == letter)
}

/// A function of another name for the time, `x(τ) = … τ …`, with its own name for it.
pub(crate) fn of_own_variable(text: &str, variable: &str) -> Option<Reworded> {
    const OTHERS: [&str; 3] = ["\\tau", "tau", "τ"];
    let (label, formula) = text.split_once('=')?;
    let (_, argument) = label.trim().strip_suffix(')')?.split_once('(')?;
    let other = OTHERS.iter().find(|other| **other == argument.trim())?;
    let is_free = !contains_letter(formula, variable) && formula.contains(other);
    is_free.then(|| Reworded::of(text.replace(other, variable)))
}
