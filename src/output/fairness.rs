//! The page that tells a teacher how alike the variants of a run are.

use serde::Serialize;

use crate::unit::{Decimal, DecimalMark};
use crate::worksheet::{Alike, Fairness, ItemFairness, QuestionFairness, Range};

/// How alike the variants are, as the layout sees it.
#[derive(Serialize)]
pub(crate) struct FairnessView<'f> {
    variants: u64,
    is_fair: bool,
    neighbours: u64,
    alike_neighbours: u64,
    /// Pairs of neighbours who share something, a line each.
    alike: Vec<String>,
    gave_way: String,
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
    /// `written` writes the words of class lists in the notation of the page.
    pub(crate) fn of(
        fairness: &'f Fairness,
        mark: DecimalMark,
        written: impl Fn(&str) -> String,
    ) -> Self {
        let questions = fairness.questions.iter().enumerate();
        Self {
            variants: fairness.variants,
            is_fair: fairness.is_fair(),
            neighbours: fairness.neighbours,
            alike_neighbours: fairness.alike_neighbours,
            alike: fairness
                .alike
                .iter()
                .map(pair)
                .map(|line| written(&line))
                .collect(),
            gave_way: written(&fairness.gave_way.join(", ")),
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

/// Two neighbours, and in which questions they share something.
fn pair(alike: &Alike) -> String {
    let [one, other] = &alike.students;
    let questions: Vec<String> = alike.questions.iter().map(usize::to_string).collect();
    let s = if questions.len() == 1 { "" } else { "s" };
    format!("{one} and {other}: question{s} {}", questions.join(", "))
}

fn three_figures(number: f64, mark: DecimalMark) -> String {
    let rounded = Decimal::rounded(number, 3).unwrap_or(Decimal::ZERO);
    match mark {
        DecimalMark::Point => rounded.to_string(),
        DecimalMark::Comma => rounded.to_string().replace('.', ","),
    }
}
