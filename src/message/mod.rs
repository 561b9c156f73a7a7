//! What is said to people about their responses: for each [`Remark`] a sentence, in each language.
//!
//! One file a language, each a function from remarks to texts; nothing else in the program words what is said about a
//! response. A further language is one more file and one more row of [`Language::ALL`].

mod en;

use crate::answer::{Blank, Remark, Verdict};
use crate::document::Document;

/// A language in which responses are spoken about.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Language {
    /// English.
    #[default]
    English,
}

impl Language {
    /// All there are.
    pub const ALL: &[Self] = &[Self::English];

    /// What is said about a response; nothing where the item has the text.
    ///
    /// ```
    /// use vibank::answer::{Remark, Slip};
    /// use vibank::message::Language;
    ///
    /// let said = Language::English.say(&Remark::Slip(Slip::Zero)).unwrap();
    /// assert_eq!(said.plain(&Vec::new()).trim(), "This is zero.");
    /// assert!(Language::English.say(&Remark::Mistake(0)).is_none());
    /// ```
    pub fn say(self, remark: &Remark) -> Option<Document> {
        match self {
            Self::English => en::say(remark),
        }
    }

    /// What an answer line says: form, letters, unit where it is not behind the line, figures, order.
    ///
    /// ```
    /// # #[cfg(feature = "render")] {
    /// use vibank::{bank, message::Language};
    /// let (catalogue, _) = bank::Catalogue::load(bank::embedded());
    /// let part = &catalogue.find("ch2/e8-springs-parallel-series").unwrap().parts[0];
    /// let said = Language::English.blank(&part.answer.blank());
    /// assert!(said.plain(&Vec::new()).starts_with('('));
    /// # }
    /// ```
    pub fn blank(self, blank: &Blank) -> Document {
        match self {
            Self::English => en::blank(blank),
        }
    }

    /// A verdict in short.
    pub fn heading(self, verdict: Verdict) -> &'static str {
        match self {
            Self::English => en::heading(verdict),
        }
    }

    /// What students read of an answer that could not be read, until their teacher decides.
    pub fn undecided(self) -> &'static str {
        match self {
            Self::English => en::UNDECIDED,
        }
    }

    /// What went wrong, by the code of a reason, for statistics over many responses; nothing of what the item words.
    pub fn slip(self, code: &str) -> Option<&'static str> {
        match self {
            Self::English => en::slip_in_short(code),
        }
    }

    /// What is said where there is nothing more to say than the verdict.
    pub fn verdict(self, verdict: Verdict) -> Document {
        match self {
            Self::English => en::verdict(verdict),
        }
    }
}

#[cfg(test)]
mod tests;
