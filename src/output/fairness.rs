//! The page that tells a teacher how alike the variants of a run are.

use serde::Serialize;

use crate::unit::{Decimal, DecimalMark};
use crate::worksheet::{Fairness, ItemFairness, QuestionFairness, Range};

/// How alike the variants are, as the layout sees it.
#[derive(Serialize)]
pub(super) struct FairnessView<'f> {
    variants: u64,
    is_fair: bool,
    neighbours: u64,
    alike_neighbours: u64,
    questions: Vec<QuestionView<'f>>,
}

#[derive(Serialize)]
struct QuestionView<'f> {
    number: usize,
    repeats: u64,
    unusual: u64,
    is_alike: bool,
    items: Vec<ItemView<'f>>,
}

#[derive(Serialize)]
struct ItemView<'f> {
    id: String,
    #[serde(flatten)]
    item: &'f ItemFairness,
    /// Fewest and most parts, once if they are the same.
    steps: Vec<usize>,
    ranges: Vec<RangeView<'f>>,
}

#[derive(Serialize)]
struct RangeView<'f> {
    part: &'f str,
    least: String,
    most: String,
    unit: &'f str,
}

impl<'f> FairnessView<'f> {
    pub(super) fn of(fairness: &'f Fairness, mark: DecimalMark) -> Self {
        let questions = fairness.questions.iter().enumerate();
        Self {
            variants: fairness.variants,
            is_fair: fairness.is_fair(),
            neighbours: fairness.neighbours,
            alike_neighbours: fairness.alike_neighbours,
            questions: questions
                .map(|(place, one)| QuestionView::of(place + 1, one, mark))
                .collect(),
        }
    }
}

impl<'f> QuestionView<'f> {
    fn of(number: usize, question: &'f QuestionFairness, mark: DecimalMark) -> Self {
        let range = |(part, range): (&'f String, &'f Range)| RangeView {
            part,
            least: three_figures(range.least, mark),
            most: three_figures(range.most, mark),
            unit: &range.unit,
        };
        let items = question.items.iter().map(|(id, item)| {
            let [fewest, most] = item.parts;
            let most = Some(most).filter(|most| *most != fewest);
            ItemView {
                id: id.to_string(),
                item,
                steps: std::iter::once(fewest).chain(most).collect(),
                ranges: item.answers.iter().map(range).collect(),
            }
        });
        Self {
            number,
            repeats: question.repeats,
            unusual: question.unusual,
            is_alike: question.is_alike(),
            items: items.collect(),
        }
    }
}

fn three_figures(number: f64, mark: DecimalMark) -> String {
    let rounded = Decimal::rounded(number, 3).unwrap_or(Decimal::ZERO);
    match mark {
        DecimalMark::Point => rounded.to_string(),
        DecimalMark::Comma => rounded.to_string().replace('.', ","),
    }
}
