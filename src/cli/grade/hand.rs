//! Points that a person gave for work on paper, as they stand among the responses: `3`, or `2;1;0` by the rows of the
//! rubric.

use vibank::answer::Criterion;
use vibank::bank::share_in_group;
use vibank::document::{Block, Document, Inline};
use vibank::grade::{Comment, rounded};
use vibank::message::{ByHand, Language};
use vibank::numerics::Rational;

use super::outcome::sum;

/// What is given at most for a part and each row of its rubric, on one sheet.
pub(crate) struct PartRubric<'a> {
    rubric: &'a [Criterion],
    shares: Vec<Rational>,
    max: Rational,
    decimal: char,
}

/// What a person gave.
pub(crate) struct Hand {
    pub(crate) points: Rational,
    /// By the rows of the rubric, where they were given so.
    rows: Option<Vec<Rational>>,
}

impl<'a> PartRubric<'a> {
    /// A part with this rubric that is worth this many points.
    pub(crate) fn of(rubric: &'a [Criterion], max: Rational, decimal: char) -> Self {
        let weights: Vec<Rational> = rubric.iter().map(|row| row.points).collect();
        Self {
            rubric,
            shares: share_in_group(max, &weights),
            max,
            decimal,
        }
    }

    /// The points that a text states; none where it is empty, since nobody has marked the part yet.
    ///
    /// # Errors
    ///
    /// What is wrong with it, as a sentence that goes on after its place.
    pub(crate) fn read(&self, text: &str) -> Result<Option<Hand>, String> {
        let text = text.trim();
        if text.is_empty() {
            return Ok(None);
        }
        if !text.contains(';') {
            let what = format!("the {} of this part", self.written(self.max));
            let points = points(text, self.max, &what)?;
            let rows = (self.shares.len() == 1).then(|| vec![points]);
            return Ok(Some(Hand { points, rows }));
        }
        let cells: Vec<&str> = text.trim_end_matches(';').split(';').collect();
        if cells.len() != self.shares.len() {
            let (found, due) = (cells.len(), self.shares.len());
            return Err(format!(
                "`{text}` has {found} numbers, the rubric {due} rows; write one for each, or their sum"
            ));
        }
        let mut rows = Vec::new();
        for (at, (cell, share)) in cells.iter().zip(&self.shares).enumerate() {
            let what = format!("the {} of row {}", self.written(*share), at + 1);
            rows.push(points(cell, *share, &what)?);
        }
        let points = sum(rows.iter().copied());
        let rows = Some(rows);
        Ok(Some(Hand { points, rows }))
    }

    /// The comments for a student: the rows of the rubric with the points that were given.
    pub(crate) fn comments(&self, hand: &Hand, language: Language) -> Vec<Comment> {
        let first = Comment::sentence(&language.by_hand(&ByHand::Marked));
        std::iter::once(first)
            .chain((0..self.shares.len()).map(|at| {
                let given = hand.rows.as_ref().map(|rows| self.written(rows[at]));
                let most = self.written(self.shares[at]);
                let points = language.by_hand(&ByHand::Row { given, most });
                let mut content = vec![Inline::Text(points)];
                for block in self.rubric[at].text.blocks() {
                    if let Block::Paragraph(inlines) = block {
                        content.extend(inlines.iter().cloned());
                    }
                }
                Comment::from(Document::of(vec![Block::Paragraph(content)], Vec::new()))
            }))
            .collect()
    }

    fn written(&self, points: Rational) -> String {
        rounded(points).replace('.', &self.decimal.to_string())
    }
}

/// A number of points, at most this many.
fn points(text: &str, most: Rational, what: &str) -> Result<Rational, String> {
    let text = text.trim();
    let given = Rational::from_decimal(&text.replace(',', "."));
    let given = given.filter(|given| *given >= Rational::ZERO);
    let given = given.ok_or_else(|| {
        format!("`{text}` is not a number of points; write for example `2`, or `1;0.5` by rows")
    })?;
    // What is printed is rounded, and so is what is copied from it.
    if rounded(given) == rounded(most) {
        return Ok(most);
    }
    if given > most {
        return Err(format!("`{text}` is more than {what}"));
    }
    Ok(given)
}
