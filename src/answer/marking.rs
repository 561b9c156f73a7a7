//! The outcome of marking one response.

use serde::{Serialize, Serializer};

use super::{Answered, Note, Remark, Unreadable};
use crate::expr::Form;
use crate::math::Math;
use crate::numerics::Rational;
use crate::response::Folded;
use crate::source::Table;
use crate::unit::{Decimal, DecimalMark, Quantity, Unit};

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

/// How a response was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// Typeset, as it is echoed.
    pub math: Math,
    /// In the formula language.
    pub text: String,
    /// As values.
    pub answered: Answered,
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
    /// What is remarked about it, the main remark first.
    pub remarks: Vec<Remark>,
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
    pub(crate) fn formula(text: String, math: Math) -> Self {
        let latex = math.latex();
        Self {
            math,
            accepted: None,
            value: KeyValue::Formula { text, latex },
        }
    }

    /// A number in a unit, as keys print it.
    pub(crate) fn rounded(value: f64, digits: u32, unit: Unit, mark: DecimalMark) -> Math {
        match Decimal::rounded(value, digits) {
            Some(rounded) => Quantity::new(rounded, unit).math(mark),
            None => Math::text("out of range"),
        }
    }

    /// Its number in SI units, where it is one.
    pub(crate) fn number(&self) -> Option<f64> {
        match &self.value {
            KeyValue::Numbers { si, .. } => match si[..] {
                [number] => Some(number),
                _ => None,
            },
            _ => None,
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
        /// The formula as LaTeX, without dollar signs.
        latex: String,
    },
}

impl Credit {
    /// Nothing.
    pub const NONE: Self = Self(Rational::ZERO);
    /// Everything.
    pub const FULL: Self = Self(Rational::ONE);

    /// What is worth half: right but for a convention that the item states.
    pub fn half() -> Self {
        Rational::new(1, 2).map_or(Self::NONE, Self)
    }

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

    /// Reads a share that is a number of a table; another one is noted as wrong.
    pub(crate) fn of_table(table: &Table<'_>, key: &'static str) -> Option<Self> {
        let value = table.value(key)?;
        let number = table.as_number(key, value)?;
        Self::read(&number.to_string())
            .or_else(|| table.wrong(key, "a share of the points, from 0 to 1", value))
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
}

impl Marking {
    /// No response.
    pub fn missing() -> Self {
        Self {
            verdict: Verdict::Missing,
            credit: Credit::NONE,
            reading: None,
            remarks: Vec::new(),
        }
    }

    /// A response that could not be read, and why.
    pub fn unreadable(why: impl Into<Unreadable>) -> Self {
        Self {
            verdict: Verdict::Unreadable,
            credit: Credit::NONE,
            reading: None,
            remarks: vec![Remark::Unreadable(why.into())],
        }
    }

    /// A response that was read, with its credit and what is remarked.
    pub fn read(reading: Reading, credit: Credit, remark: impl Into<Option<Remark>>) -> Self {
        Self {
            verdict: credit.verdict(),
            credit,
            reading: Some(reading),
            remarks: remark.into().into_iter().collect(),
        }
    }

    /// A response that is right.
    pub fn right(reading: Reading) -> Self {
        Self::read(reading, Credit::FULL, None)
    }

    /// A response that is a named mistake of the item.
    pub fn mistake(reading: Reading, number: usize, credit: Credit) -> Self {
        Self::read(reading, credit, Remark::Mistake(number))
    }

    /// A response that is wrong, and why, where that can be diagnosed.
    pub fn wrong(reading: Reading, remark: impl Into<Option<Remark>>) -> Self {
        Self::read(reading, Credit::NONE, remark)
    }

    /// With the places in its remarks as they were typed.
    #[must_use]
    pub(crate) fn in_typed(mut self, folded: &Folded<'_>) -> Self {
        for remark in &mut self.remarks {
            if let Remark::Unreadable(unreadable) = remark {
                unreadable.point_at_typed(folded);
            }
        }
        self
    }

    /// Why it fared so, for programs and statistics, the main reason first: what its remarks give, and what its
    /// verdict says where they give none.
    pub fn reasons(&self) -> Vec<Reason> {
        let mut reasons: Vec<Reason> = self.remarks.iter().filter_map(Remark::reason).collect();
        let is_beside = |reason: &Reason| {
            matches!(
                reason,
                Reason::FollowThrough | Reason::Figures | Reason::NoUnit
            )
        };
        if reasons.iter().all(is_beside) {
            let is_matched = self.verdict == Verdict::Right || reasons.contains(&Reason::Figures);
            let main = match self.verdict {
                Verdict::Missing => Reason::Missing,
                Verdict::Unreadable => Reason::Unreadable,
                _ if is_matched => Reason::Matches,
                _ => Reason::Other,
            };
            let place = usize::from(reasons.first() == Some(&Reason::FollowThrough));
            reasons.insert(place, main);
        }
        reasons
    }

    /// The main one of its [reasons](Self::reasons).
    pub fn reason(&self) -> Reason {
        self.reasons().swap_remove(0)
    }

    /// Says in which unit numbers without one were taken.
    pub(crate) fn say_taken(&mut self, unit: &Unit) {
        self.remarks.push(Note::TakenIn(*unit).into());
    }
}
