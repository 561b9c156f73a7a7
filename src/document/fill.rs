//! What is put into the holes of a text.

use super::Inline;
use crate::math::{Holes, Math};

/// What fills one hole.
#[derive(Clone, Copy, Debug)]
pub enum Fill<'a> {
    /// Typeset; outside of formulas it becomes one, except for a [`Math::Text`], which is words.
    Math(&'a Math),
    /// A figure or plot in the notation of the output, written as it stands: for HTML an SVG
    /// element. It has to come from a writer, never from a text.
    Figure(&'a str),
    /// Lines of a derivation.
    Steps(&'a [Step]),
}

/// A step of a derivation: words, and lines that are aligned below them.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// What is done.
    pub words: Vec<Inline>,
    /// The lines; what stands on the left of one, empty where it continues the line above, and a relation with what
    /// follows it.
    pub lines: Vec<[Math; 2]>,
}

/// What fills the holes of a text.
pub trait Fills {
    /// What fills a hole; nothing leaves an empty box.
    fn fill(&self, hole: u32) -> Option<Fill<'_>>;
}

/// A filling that is owned, for lists of them.
#[derive(Clone, Debug, PartialEq)]
pub enum Filling {
    /// As [`Fill::Math`].
    Math(Math),
    /// As [`Fill::Figure`].
    Figure(String),
    /// As [`Fill::Steps`].
    Steps(Vec<Step>),
}

impl Filling {
    /// Upright words, as a formula in the line.
    pub fn words(words: impl Into<String>) -> Self {
        Self::Math(Math::Text(words.into()))
    }

    /// Writes the decimals within its formulas with another sign.
    pub fn set_decimal_sign(&mut self, sign: &str) {
        match self {
            Self::Math(math) => math.set_decimal_sign(sign),
            Self::Figure(_) => {}
            Self::Steps(steps) => {
                for side in steps.iter_mut().flat_map(|step| &mut step.lines).flatten() {
                    side.set_decimal_sign(sign);
                }
            }
        }
    }
}

/// Hole `n` is filled with the `n`-th filling.
impl Fills for [Filling] {
    fn fill(&self, hole: u32) -> Option<Fill<'_>> {
        self.get(hole as usize).map(|filling| match filling {
            Filling::Math(math) => Fill::Math(math),
            Filling::Figure(markup) => Fill::Figure(markup),
            Filling::Steps(steps) => Fill::Steps(steps),
        })
    }
}

/// Hole `n` is filled with the `n`-th filling.
impl Fills for Vec<Filling> {
    fn fill(&self, hole: u32) -> Option<Fill<'_>> {
        self.as_slice().fill(hole)
    }
}

impl Step {
    /// Its lines as one formula, for writers that have a notation for aligned lines.
    pub(crate) fn aligned(&self) -> Math {
        Math::aligned(self.lines.iter().map(|line| line.to_vec()).collect())
    }
}

/// The fillings as formulas see them.
pub(crate) struct InMath<'a>(pub(crate) &'a dyn Fills);

impl Holes for InMath<'_> {
    fn filling(&self, hole: u32) -> Option<&Math> {
        match self.0.fill(hole) {
            Some(Fill::Math(math)) => Some(math),
            Some(Fill::Figure(_) | Fill::Steps(_)) | None => None,
        }
    }
}
