//! What came out for a sheet: enough for all tables, and for going on after an interruption.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use vibank::answer::Verdict;
use vibank::grade::rounded;
use vibank::numerics::Rational;
use vibank::worksheet::Total;

/// A sheet that was marked.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct SheetOutcome {
    pub(crate) code: String,
    pub(crate) student: BTreeMap<String, String>,
    /// Whether it was made for nobody in the class list.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub(crate) spare: bool,
    /// Whether it is a student's, and nothing was answered on it.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub(crate) unanswered: bool,
    pub(crate) parts: Vec<PartOutcome>,
    pub(crate) questions: Vec<QuestionOutcome>,
    /// What the sheet came to.
    pub(crate) total: Standing,
}

/// What a question came to.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct QuestionOutcome {
    pub(crate) number: usize,
    pub(crate) standing: Standing,
}

/// Points, of which some may not be decided.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Standing {
    /// The least that they come to.
    pub(crate) points: Fraction,
    /// What more they come to at most, when all is decided.
    pub(crate) open: Fraction,
    pub(crate) max: Fraction,
}

/// A part that was marked.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct PartOutcome {
    pub(crate) question: usize,
    pub(crate) letter: String,
    pub(crate) item: String,
    pub(crate) id: String,
    pub(crate) response: String,
    /// LaTeX; empty if it was not read.
    pub(crate) reading: String,
    pub(crate) verdict: Verdict,
    pub(crate) credit: Fraction,
    pub(crate) points: Fraction,
    pub(crate) max: Fraction,
    pub(crate) reasons: Vec<String>,
    pub(crate) feedback: String,
    /// Whether a person marks it.
    #[serde(default)]
    pub(crate) by_hand: bool,
    /// Another wrong answer, apart from its data.
    pub(crate) other: Option<String>,
    /// How it stood without what was decided, where that is otherwise.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) before: Option<Standing>,
    /// The numbers of the decisions that have changed it, from 0.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(crate) decisions: Vec<usize>,
}

/// An exact fraction as two integers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Fraction(pub(crate) Rational);

impl SheetOutcome {
    /// A column of the class list.
    pub(crate) fn column(&self, name: &str) -> &str {
        self.student.get(name).map_or("", String::as_str)
    }

    /// Whether it is a spare sheet that nobody seems to have got.
    pub(crate) fn is_unused(&self) -> bool {
        self.spare
            && self.parts.iter().all(|part| {
                part.response.is_empty() && part.points.0.is_zero() && part.decisions.is_empty()
            })
    }

    /// The points that are decided.
    pub(crate) fn points(&self) -> Rational {
        self.total.points.0
    }

    /// How many parts nobody has decided yet, and the points that hang on them.
    pub(crate) fn undecided(&self) -> (usize, Rational) {
        let parts = self.parts.iter().filter(|part| part.is_undecided());
        (parts.count(), self.total.open.0)
    }

    /// The points of the parts that a person marks, or of all others, and those that are open there.
    pub(crate) fn points_of(&self, by_hand: bool) -> (Rational, Rational) {
        let parts = || self.parts.iter().filter(|part| part.by_hand == by_hand);
        let open = parts().filter(|part| part.is_undecided());
        (
            sum(parts().map(|part| part.points.0)),
            sum(open.map(|part| part.max.0)),
        )
    }

    /// The points that can be reached.
    pub(crate) fn max(&self) -> Rational {
        self.total.max.0
    }

    /// What a question came to, if the sheet has it.
    pub(crate) fn question(&self, number: usize) -> Option<&Standing> {
        let mut questions = self.questions.iter();
        let found = questions.find(|question| question.number == number)?;
        Some(&found.standing)
    }
}

impl PartOutcome {
    /// What could not be read is neither right nor wrong until somebody decides.
    pub(crate) fn is_undecided(&self) -> bool {
        self.verdict == Verdict::Unreadable
    }
}

impl Standing {
    /// That of a part.
    pub(crate) fn of(part: &PartOutcome) -> Self {
        let open = if part.is_undecided() {
            part.max.0.checked_sub(part.points.0).unwrap_or(part.max.0)
        } else {
            Rational::ZERO
        };
        Self {
            points: part.points,
            open: Fraction(open),
            max: part.max,
        }
    }

    /// That of a sheet.
    pub(crate) fn of_total(total: &Total) -> Self {
        Self {
            points: Fraction(total.points),
            open: Fraction(total.open),
            max: Fraction(total.max),
        }
    }

    /// The same in numbers.
    pub(crate) fn total(&self) -> Total {
        Total {
            points: self.points.0,
            open: self.open.0,
            max: self.max.0,
        }
    }

    /// The points of a part as they are shown: after a question mark what is not decided.
    pub(crate) fn shown(&self) -> String {
        if self.open.0.is_zero() {
            rounded(self.points.0)
        } else {
            format!("?{}", rounded(self.max.0))
        }
    }
}

/// A sum of points.
pub(crate) fn sum(points: impl Iterator<Item = Rational>) -> Rational {
    points.fold(Rational::ZERO, |sum, points| {
        sum.checked_add(points).unwrap_or(sum)
    })
}

impl Serialize for Fraction {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.0.to_string())
    }
}

impl<'de> Deserialize<'de> for Fraction {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        fraction(&text)
            .map(Self)
            .ok_or_else(|| serde::de::Error::custom("no fraction"))
    }
}

/// Reads `5/3` or `1.5`.
pub(crate) fn fraction(text: &str) -> Option<Rational> {
    match text.trim().split_once('/') {
        Some((above, below)) => {
            Rational::from_decimal(above.trim())?.checked_div(Rational::from_decimal(below.trim())?)
        }
        None => Rational::from_decimal(text.trim()),
    }
}
