//! What is said to people about their responses: for each [`Remark`] a sentence, in each language.
//!
//! One file a language, each a function from remarks to texts; nothing else in the program words what is said about a
//! response. A further language is one more file and one more row of [`Language::ALL`].

mod en;
mod fr;

use std::borrow::Cow;

use crate::answer::{Blank, Remark, Verdict};
use crate::document::{Document, Inline};
use crate::expr::Notation;
use crate::figure::story::{Caption, Speaker, Story};
use crate::math::{Math, Voice};
use crate::mechanics::Reason;

/// A language in which responses are spoken about.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Language {
    /// English, in which the bank is written.
    #[default]
    English,
    /// French, for remarks and for the words around the questions.
    French,
}

/// What a person did with a response, for its student.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ByHand {
    /// Nobody has marked it yet.
    Open,
    /// A person gave the points.
    Marked,
    /// A person settled how it is read; the reading follows.
    ReadAs,
    /// The file of responses does not say clearly what was answered.
    Unclear,
    /// A person accepts an answer beside the key.
    Accepted,
    /// A person gives a share of the points for an answer.
    Shared,
    /// The part does not count: everybody has its points.
    FullMarks,
    /// The part does not count: the others share its points.
    Rescaled,
    /// The part does not count.
    LeftOut,
    /// What a wrong choice costs: points as they are printed, and whether it is one.
    Charged {
        /// What is subtracted, as it is printed.
        points: String,
        /// Whether it is a single one.
        is_one: bool,
    },
    /// Points of a row of the rubric: those given, if they were given by rows, and the most there are.
    Row {
        /// Points that were given.
        given: Option<String>,
        /// Points that could be given.
        most: String,
    },
}

/// Words among the texts, formulas and figures of an item that the item does not have itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Phrase<'a> {
    /// Before the turning points of a motion with dry friction.
    TurningPoints,
    /// Between the first and the last lines of a long list.
    AndSoOnUntil,
    /// In place of a value that there is not.
    Nonexistent,
    /// The title of a figure that moves.
    Moving,
    /// The title of the figure of a mode, by its number from 1.
    Mode(usize),
    /// What the figure of a mode shows.
    ModeShown {
        /// The number of the mode, from 1.
        number: usize,
        /// The symbol of each coordinate, and its share.
        shape: &'a [(Math, String)],
    },
    /// In place of a figure, what it shows.
    Figure(&'a str),
    /// In place of a plot, what it shows.
    Plot(&'a str),
    /// In place of a plot that these data do not have.
    NoPlot,
    /// After a box of a course platform, which takes no unit.
    NumberOnly,
    /// Above a box of a course platform that takes a number with its unit.
    NumberAndUnit,
    /// The name of a question of a course platform, by its number from 1.
    Question(usize),
    /// The name of the questions of a course platform that a person marks.
    Essays,
    /// Above the points of a rubric.
    Points,
    /// Above what the points of a rubric are given for.
    GivenFor,
}

impl Language {
    /// All there are.
    pub const ALL: &[Self] = &[Self::English, Self::French];

    /// The language of a tag, `fr` or `fr-CA`; nothing where none of its own is spoken here.
    ///
    /// ```
    /// use vibank::message::Language;
    ///
    /// assert_eq!(Language::of("fr-CA"), Some(Language::French));
    /// assert_eq!(Language::of("de"), None);
    /// ```
    pub fn of(tag: &str) -> Option<Self> {
        let primary = tag.split('-').next().unwrap_or_default();
        let is_named = |language: &&Self| primary.eq_ignore_ascii_case(language.code());
        Self::ALL.iter().find(is_named).copied()
    }

    /// Its code of two letters, after ISO 639-1.
    pub fn code(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::French => "fr",
        }
    }

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
            Self::French => fr::say(remark),
        }
    }

    /// What an answer line says: form, letters, unit where it is not after the line, figures, order.
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
            Self::French => fr::blank(blank),
        }
    }

    /// What a step of a derivation does, before its lines.
    ///
    /// ```
    /// use vibank::document::Inline;
    /// use vibank::expr::PlainNotation;
    /// use vibank::mechanics::Reason;
    /// use vibank::message::Language;
    ///
    /// let said = Language::French.step(&Reason::Balance, &PlainNotation);
    /// assert_eq!(said, [Inline::Text("Bilan d’énergie\u{a0}:".to_owned())]);
    /// ```
    pub fn step(self, reason: &Reason, symbols: &dyn Notation) -> Vec<Inline> {
        match self {
            Self::English => en::derivation::step(reason, symbols),
            Self::French => fr::derivation::step(reason, symbols),
        }
    }

    /// A formula with the words in it, of ranges, of functions by pieces and the like, in this language.
    ///
    /// ```
    /// use vibank::math::Math;
    /// use vibank::message::Language;
    ///
    /// let range = Math::row([Math::number("9,05"), Math::text(" to "), Math::number("9,15")]);
    /// assert_eq!(Language::French.formula(&range).plain(), "9,05 à 9,15");
    /// assert_eq!(Language::English.formula(&range).plain(), "9,05 to 9,15");
    /// ```
    pub fn formula(self, math: &Math) -> Cow<'_, Math> {
        match self {
            Self::English => Cow::Borrowed(math),
            Self::French => {
                let mut math = math.clone();
                math.reword(&fr::derivation::word);
                Cow::Owned(math)
            }
        }
    }

    /// Whether a number takes the singular: in French all below two do.
    pub fn is_singular(self, number: f64) -> bool {
        match self {
            Self::English => number == 1.0,
            Self::French => number.abs() < 2.0,
        }
    }

    /// The words with which formulas are heard.
    ///
    /// ```
    /// use vibank::math::{Math, symbol};
    /// use vibank::message::Language;
    ///
    /// let root = Math::root(symbol("Omega_n"));
    /// let heard = root.spoken(Language::French.voice());
    /// assert_eq!(heard, "racine carrée de oméga majuscule indice n fin de racine");
    /// ```
    pub fn voice(self) -> &'static Voice {
        match self {
            Self::English => Voice::ENGLISH,
            Self::French => &fr::voice::VOICE,
        }
    }

    /// Words among formulas and with figures.
    pub fn phrase(self, phrase: &Phrase<'_>) -> String {
        match self {
            Self::English => en::derivation::phrase(phrase),
            Self::French => fr::derivation::phrase(phrase),
        }
    }

    /// A verdict in short.
    pub fn heading(self, verdict: Verdict) -> &'static str {
        match self {
            Self::English => en::heading(verdict),
            Self::French => fr::heading(verdict),
        }
    }

    /// What students read of an answer that could not be read, until their teacher decides.
    pub fn undecided(self) -> &'static str {
        match self {
            Self::English => en::UNDECIDED,
            Self::French => fr::UNDECIDED,
        }
    }

    /// What went wrong, by the code of a reason, for statistics over many responses; nothing of what the item words.
    pub fn slip(self, code: &str) -> Option<&'static str> {
        match self {
            Self::English => en::slip_in_short(code),
            Self::French => fr::slip_in_short(code),
        }
    }

    /// What a student reads of what a person did with a response; for a row of a rubric, what stands before its text.
    ///
    /// ```
    /// use vibank::message::{ByHand, Language};
    ///
    /// assert_eq!(Language::English.by_hand(&ByHand::Marked), "Marked by your teacher.");
    /// ```
    pub fn by_hand(self, what: &ByHand) -> String {
        match self {
            Self::English => en::by_hand(what),
            Self::French => fr::by_hand(what),
        }
    }

    /// What is said where there is nothing more to say than the verdict.
    pub fn verdict(self, verdict: Verdict) -> Document {
        match self {
            Self::English => en::verdict(verdict),
            Self::French => fr::verdict(verdict),
        }
    }
}

impl Speaker for Language {
    fn caption(&self, story: &Story) -> Caption {
        match self {
            Self::English => en::picture::caption(story),
            Self::French => fr::picture::caption(story),
        }
    }
}

/// Names with commas, and a word before the last one.
fn listed<T: AsRef<str>>(names: &[T], and: &str) -> String {
    let names: Vec<&str> = names.iter().map(AsRef::as_ref).collect();
    match names.as_slice() {
        [] => String::new(),
        [one] => (*one).to_owned(),
        [first @ .., last] => format!("{} {and} {last}", first.join(", ")),
    }
}

#[cfg(test)]
mod tests;
