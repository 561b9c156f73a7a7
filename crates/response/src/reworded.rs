//! What is read in place of what was typed, where a spelling is recognized by more than its signs.

use super::Passage;
use super::words::FACTORS;

/// A passage in other words than it was typed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reworded {
    text: String,
    steps: String,
    conditions: Vec<String>,
}

impl From<&str> for Reworded {
    fn from(text: &str) -> Self {
        Self::of(text.to_owned())
    }
}

impl Reworded {
    pub(crate) fn of(text: String) -> Self {
        Self {
            text,
            steps: String::new(),
            conditions: Vec::new(),
        }
    }

    /// The same where these conditions were said of it.
    pub(crate) fn under(self, conditions: Vec<String>) -> Self {
        Self { conditions, ..self }
    }

    /// The same where it is said to come from these steps.
    pub(crate) fn behind(self, steps: &str) -> Self {
        let steps = steps.to_owned();
        Self { steps, ..self }
    }

    /// As it is read.
    pub fn passage(&self) -> Passage<'_> {
        Passage::of(&self.text)
    }

    /// The steps that it was said to come from; empty where there were none.
    pub fn steps(&self) -> Passage<'_> {
        Passage::of(&self.steps)
    }

    /// The relations that were said to hold for it, `ζ < 1` of `… for ζ < 1`.
    pub fn conditions(&self) -> impl Iterator<Item = Passage<'_>> {
        self.conditions.iter().map(|own| Passage::of(own))
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

/// A formula with the numbers in it that are said in words, `half of m R^2`, `twice k`.
pub(crate) fn of_spoken_numbers(text: &str) -> Option<Reworded> {
    let mut words = text.split(' ').filter(|word| !word.is_empty()).peekable();
    let (mut plain, mut count) = (String::new(), 0);
    while let Some(word) = words.next() {
        let found = FACTORS.iter().find(|(spoken, _)| *spoken == word);
        let Some((_, number)) = found else {
            plain.push_str(word);
            plain.push(' ');
            continue;
        };
        count += 1;
        plain.push_str(number);
        while words.next_if(|next| ["of", "the"].contains(next)).is_some() {}
        let is_multiplied = words
            .peek()
            .is_some_and(|next| next.starts_with(['*', '/', '+', '-']));
        plain.push_str(if is_multiplied { " " } else { "*" });
    }
    (count > 0).then(|| Reworded::of(plain))
}
