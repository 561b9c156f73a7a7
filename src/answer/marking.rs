//! The outcome of marking one response.

use serde::{Serialize, Serializer};

use crate::document::Document;
use crate::expr::Form;
use crate::math::Math;
use crate::numerics::Rational;
use crate::unit::Unit;

/// How a response fared.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, serde::Deserialize,
)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// Full credit.
    Right,
    /// Some credit.
    Partial,
    /// No credit.
    Wrong,
    /// It could not be read; no attempt is spent.
    Unreadable,
    /// There is none.
    Missing,
}

/// The share of a part's points, an exact fraction from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Credit(Rational);

/// Why a response got its verdict, as a code for programs and statistics.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Reason {
    /// It equals the key within the tolerance.
    Matches,
    /// It equals a named mistake of the item, counted from 0.
    Mistake(usize),
    /// It follows from the student's own answer to an earlier part.
    FollowThrough,
    /// Its unit has another dimension than the key.
    Dimension,
    /// It has no unit where one is due.
    NoUnit,
    /// It is off by a factor of 2π between angular and cyclic frequency.
    TwoPi,
    /// It is off by a power of ten or by a prefix.
    PowerOfTen,
    /// It has the right magnitude and the wrong sign.
    Sign,
    /// It is near the key but outside the tolerance.
    Near,
    /// It is right up to its scale, where one scale is asked.
    Scale,
    /// It has the wrong number of significant figures.
    Figures,
    /// It is an angle in degrees where radians were typed, or the other way round.
    AngleUnit,
    /// It is none of these.
    Other,
    /// It could not be read.
    Unreadable,
    /// There is none.
    Missing,
}

/// What is said about a response.
#[derive(Clone, Debug, PartialEq)]
pub enum Feedback {
    /// The text of the item's mistake of this number, from 0.
    Mistake(usize),
    /// A text of the item, without placeholders.
    Text(Document),
    /// A sentence of our own.
    Words(String),
}

/// How a response was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// Typeset, as it is echoed.
    pub math: Math,
    /// In the formula language.
    pub text: String,
    /// Its numbers in SI units; empty where it has none.
    pub si: Vec<f64>,
}

/// The outcome of marking one response.
#[derive(Clone, Debug, PartialEq)]
pub struct Marking {
    /// How it fared.
    pub verdict: Verdict,
    /// Its share of the points.
    pub credit: Credit,
    /// How it was read, if it could be.
    pub reading: Option<Reading>,
    /// Why, the main reason first.
    pub reasons: Vec<Reason>,
    /// What is said about it.
    pub feedback: Vec<Feedback>,
}

/// A key as it is printed and as programs get it.
#[derive(Clone, Debug, PartialEq)]
pub struct Key {
    /// Typeset with its unit.
    pub math: Math,
    /// The range of numbers that are accepted, typeset, where there is one.
    pub accepted: Option<Math>,
    /// What programs get.
    pub value: KeyValue,
}

impl Key {
    /// A key that is a formula, as it is written and typeset.
    pub(super) fn formula(text: String, math: Math) -> Self {
        let latex = math.latex();
        Self {
            math,
            accepted: None,
            value: KeyValue::Formula { text, latex },
        }
    }
}

/// A key as programs get it.
#[derive(Clone, Debug, PartialEq)]
pub enum KeyValue {
    /// Numbers in SI units, arranged by a form; complex ones as pairs.
    Numbers {
        /// How they are arranged.
        form: Form,
        /// The numbers.
        si: Vec<f64>,
    },
    /// The right options.
    Options {
        /// Their ids.
        ids: Vec<String>,
        /// Whether there can be several.
        is_list: bool,
    },
    /// Intervals in SI units, ascending.
    Intervals {
        /// Ends, `None` where there is no bound, and whether they are left out.
        pieces: Vec<([Option<f64>; 2], [bool; 2])>,
        /// As inequalities.
        text: String,
    },
    /// A formula or equation.
    Formula {
        /// In the formula language.
        text: String,
        /// In LaTeX.
        latex: String,
    },
}

impl Credit {
    /// Nothing.
    pub const NONE: Self = Self(Rational::ZERO);
    /// Everything.
    pub const FULL: Self = Self(Rational::ONE);

    /// The fraction, if it lies from 0 to 1.
    pub fn new(share: Rational) -> Option<Self> {
        (Rational::ZERO..=Rational::ONE)
            .contains(&share)
            .then_some(Self(share))
    }

    /// Reads a share that is written as a decimal.
    pub fn read(decimal: &str) -> Option<Self> {
        Self::new(Rational::from_decimal(decimal)?)
    }

    /// This credit less another, and not below nothing.
    #[must_use]
    pub fn minus(self, other: Self) -> Self {
        self.0
            .checked_sub(other.0)
            .and_then(Self::new)
            .unwrap_or(Self::NONE)
    }

    /// The fraction.
    pub fn share(self) -> Rational {
        self.0
    }

    /// The verdict that this credit means for a response that could be read.
    pub fn verdict(self) -> Verdict {
        match self {
            Self::FULL => Verdict::Right,
            Self::NONE => Verdict::Wrong,
            _ => Verdict::Partial,
        }
    }
}

impl Serialize for Credit {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_f64(self.0.to_f64())
    }
}

impl Reason {
    /// Its name for programs.
    pub fn code(&self) -> String {
        match self {
            Self::Matches => "matches".to_owned(),
            Self::Mistake(number) => format!("mistake-{}", number + 1),
            Self::FollowThrough => "follow-through".to_owned(),
            Self::Dimension => "dimension".to_owned(),
            Self::NoUnit => "no-unit".to_owned(),
            Self::TwoPi => "two-pi".to_owned(),
            Self::PowerOfTen => "power-of-ten".to_owned(),
            Self::Sign => "sign".to_owned(),
            Self::Near => "near".to_owned(),
            Self::Scale => "scale".to_owned(),
            Self::Figures => "figures".to_owned(),
            Self::AngleUnit => "angle-unit".to_owned(),
            Self::Other => "other".to_owned(),
            Self::Unreadable => "unreadable".to_owned(),
            Self::Missing => "missing".to_owned(),
        }
    }
}

impl Verdict {
    /// Its name, as in the marks.
    pub fn name(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::Partial => "partial",
            Self::Wrong => "wrong",
            Self::Unreadable => "unreadable",
            Self::Missing => "missing",
        }
    }

    /// What a student reads.
    pub fn words(self) -> &'static str {
        match self {
            Self::Right => "Right",
            Self::Partial => "Partly right",
            Self::Wrong => "Not right",
            Self::Unreadable => "Could not be read",
            Self::Missing => "No answer",
        }
    }
}

impl Marking {
    /// No response.
    pub fn missing() -> Self {
        Self {
            verdict: Verdict::Missing,
            credit: Credit::NONE,
            reading: None,
            reasons: vec![Reason::Missing],
            feedback: Vec::new(),
        }
    }

    /// A response that could not be read, and what to type instead.
    pub fn unreadable(help: impl Into<String>) -> Self {
        Self {
            verdict: Verdict::Unreadable,
            credit: Credit::NONE,
            reading: None,
            reasons: vec![Reason::Unreadable],
            feedback: vec![Feedback::Words(help.into())],
        }
    }

    /// A response that was read, with its credit, the reason and what is said.
    pub fn read(
        reading: Reading,
        credit: Credit,
        reason: Reason,
        feedback: Option<Feedback>,
    ) -> Self {
        Self {
            verdict: credit.verdict(),
            credit,
            reading: Some(reading),
            reasons: vec![reason],
            feedback: feedback.into_iter().collect(),
        }
    }

    /// Says in which unit numbers without one were taken.
    pub(super) fn say_taken(&mut self, unit: &Unit) {
        let words = format!("Taken in {}.", unit.text());
        self.reasons.push(Reason::NoUnit);
        self.feedback.push(Feedback::Words(words));
    }
}
