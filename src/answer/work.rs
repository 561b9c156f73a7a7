//! `work`: a sketch, a derivation or a free-body diagram, which a person marks.
//!
//! Such a part has no key. Its `rubric` says what the points are given for; they sum up to the `points` of the part.
//! It is printed for whoever marks and with the worked solutions, and the points come with the responses, `2;1;0` for
//! the rows or `3` for the sum. `minutes` is the time that it takes, 10 if left out.
//!
//! ```toml
//! [[part]]
//! kind    = "work"
//! id      = "bodies"
//! points  = 3
//! space   = "7 cm squared"
//! ask     = "Draw the free-body diagram of the block."
//! rubric  = [
//!   { points = 2, text = "weight and force of the spring, with their directions" },
//!   { points = 1, text = "coordinate $x$, and its origin" },
//! ]
//! ```

use super::{Answer, AnswerKind, Asked, Blank, Context, Declare, Marker};
use crate::quantity::{Absent, NodeId};
use crate::source::Table;
#[cfg(feature = "render")]
use crate::{
    answer::AnswerError,
    document::Document,
    numerics::Rational,
    source::{Text, Value},
};

/// What some of the points are given for.
#[cfg(feature = "render")]
#[derive(Clone, Debug)]
pub struct Criterion {
    /// Points as the item counts them; a sheet that gives the part other points shares these out alike.
    pub points: Rational,
    /// What they are given for.
    pub text: Document,
}

#[derive(Debug)]
struct Work {
    #[cfg(feature = "render")]
    minutes: u32,
    #[cfg(feature = "render")]
    rubric: Vec<Criterion>,
}

/// Most rows of a rubric.
#[cfg(feature = "render")]
const MAX_COUNT: usize = 20;

/// Reads the keys of a part that belong to this kind; what is wrong is noted.
#[cfg(feature = "render")]
pub(crate) fn read(part: &Table<'_>, declare: &mut dyn Declare) -> Option<Box<dyn Answer>> {
    let minutes = part.integer("minutes", "an integer from 1 to 240", 1..=240);
    let minutes = minutes.map_or(AnswerKind::Work.minutes(), |minutes| {
        minutes.unsigned_abs() as u32
    });
    let rubric = rubric(part, declare)?;
    if part.has("key") {
        let error = AnswerError::Rubric("what a person marks has no key".to_owned());
        declare.find(&error, &place(part, "key"));
        return None;
    }
    Some(Box::new(Work { minutes, rubric }))
}

/// The same in a page, where nobody marks by the rubric.
#[cfg(not(feature = "render"))]
#[expect(clippy::unnecessary_wraps, reason = "all kinds are read alike")]
pub(crate) fn read(part: &Table<'_>, _declare: &mut dyn Declare) -> Option<Box<dyn Answer>> {
    let _ = (part.value("rubric"), part.value("minutes"));
    Some(Box::new(Work {}))
}

/// The rows of the rubric, whose points sum up to those of the part.
#[cfg(feature = "render")]
fn rubric(part: &Table<'_>, declare: &mut dyn Declare) -> Option<Vec<Criterion>> {
    part.required("rubric")?;
    let mut rows = Vec::new();
    for table in part.tables("rubric") {
        let text = table.required_text("text").map(|text| declare.text(&text));
        let points = points(&table);
        if points.is_none() && table.required("points").is_some() {
            let error = AnswerError::Rubric("the points of a row are a positive number".to_owned());
            declare.find(&error, &place(&table, "points"));
        }
        table.finish();
        rows.push(Criterion {
            points: points?,
            text: text?,
        });
    }
    let whole = points(part).or_else(|| (!part.has("points")).then_some(Rational::ONE));
    let sum = Rational::sum(&rows.iter().map(|row| row.points).collect::<Vec<_>>());
    if rows.is_empty() || rows.len() > MAX_COUNT {
        let found = rows.len();
        let error = format!("a rubric has from 1 to {MAX_COUNT} rows, and this one {found}");
        declare.find(&AnswerError::Rubric(error), &place(part, "rubric"));
        return None;
    }
    // Points that cannot be read are reported where those of all parts are read.
    if let Some(whole) = whole.filter(|whole| sum != Some(*whole)) {
        let sum = sum.map_or_else(|| "more than can be counted".to_owned(), number);
        let whole = number(whole);
        let error =
            format!("the points of the rubric sum up to {sum}, those of the part are {whole}");
        declare.find(&AnswerError::Rubric(error), &place(part, "rubric"));
        return None;
    }
    Some(rows)
}

#[cfg(feature = "render")]
fn points(table: &Table<'_>) -> Option<Rational> {
    let text = table.as_formula("points", table.value("points")?)?;
    Rational::from_decimal(&text.value).filter(|points| *points > Rational::ZERO)
}

#[cfg(feature = "render")]
fn number(points: Rational) -> String {
    points.to_f64().to_string()
}

/// Where the value of a key stands.
#[cfg(feature = "render")]
fn place(table: &Table<'_>, key: &'static str) -> Text {
    let span = table
        .value(key)
        .map_or_else(|| table.span(), |value| value.span);
    Text {
        value: String::new(),
        span,
    }
}

impl Answer for Work {
    fn kind(&self) -> AnswerKind {
        AnswerKind::Work
    }

    fn keys(&self) -> Vec<NodeId> {
        Vec::new()
    }

    fn blank(&self) -> Blank {
        Blank::of(Asked::Work)
    }

    #[cfg(feature = "render")]
    fn minutes(&self) -> u32 {
        self.minutes
    }

    #[cfg(feature = "render")]
    fn rubric(&self) -> &[Criterion] {
        &self.rubric
    }

    #[cfg(feature = "render")]
    fn read_mistake(
        &mut self,
        _number: usize,
        _answer: &Value,
        part: &Table<'_>,
        declare: &mut dyn Declare,
    ) -> Option<Vec<NodeId>> {
        let error = AnswerError::Rubric("what a person marks has no named mistakes".to_owned());
        let (value, span) = (String::new(), part.span());
        declare.find(&error, &Text { value, span });
        None
    }

    fn prepare<'t>(&self, _context: &Context<'t>) -> Result<Box<dyn Marker + 't>, Absent> {
        Err(Absent::ByHand)
    }
}
