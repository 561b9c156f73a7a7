//! The page that tells a teacher how alike the variants of a run are.

use serde::Serialize;

use super::layouts::OutputError;
use super::pages::{Pages, Run};
use super::words::{FairnessWords, filled};
use crate::bank::ItemId;
use crate::unit::{Decimal, DecimalMark};
use crate::worksheet::{Alike, Fairness, ItemFairness, QuestionFairness, Range};

/// How alike the variants are, as the layout sees it.
#[derive(Serialize)]
struct FairnessView<'f> {
    verdict: String,
    /// How many students sit beside each other, and how many of them share something.
    neighbours: String,
    are_neighbours_alike: bool,
    /// Pairs of neighbours who share something, a line each.
    alike: Vec<String>,
    gave_way: String,
    questions: Vec<FairnessQuestionView<'f>>,
}

#[derive(Serialize)]
struct FairnessQuestionView<'f> {
    number: usize,
    /// What to look at, a sentence each.
    remarks: Vec<String>,
    items: Vec<ItemView<'f>>,
}

#[derive(Serialize)]
struct ItemView<'f> {
    /// Identity and revision.
    identity: String,
    title: &'f str,
    /// Number of variants, level, time and parts.
    size: String,
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
    /// `written` writes the words of class lists in the notation of the page, whose remarks are marked by a triangle where
    /// it `has_triangles`.
    fn of(
        fairness: &'f Fairness,
        run: &Run,
        has_triangles: bool,
        written: impl Fn(&str) -> String,
    ) -> Self {
        let words = &run.words.fairness;
        let verdict = match (fairness.is_fair(), has_triangles) {
            (true, _) => &words.is_fair,
            (false, true) => &words.look_at_triangles,
            (false, false) => &words.look_at_bold,
        };
        let are_alike = fairness.alike_neighbours > 0;
        let neighbours = match (fairness.neighbours, are_alike) {
            (0, _) => "",
            (_, true) => &words.alike,
            (_, false) => &words.apart,
        };
        let [pairs, alike] =
            [fairness.neighbours, fairness.alike_neighbours].map(|count| count.to_string());
        let names = written(&fairness.gave_way.join(", "));
        let questions = fairness.questions.iter().enumerate();
        Self {
            verdict: filled(verdict, &[("count", &fairness.variants.to_string())]),
            neighbours: filled(neighbours, &[("count", &pairs), ("alike", &alike)]),
            are_neighbours_alike: are_alike,
            alike: fairness
                .alike
                .iter()
                .map(|alike| written(&pair(alike, words)))
                .collect(),
            gave_way: match &*names {
                "" => String::new(),
                names => filled(&words.gave_way, &[("names", names)]),
            },
            questions: questions
                .map(|(place, one)| {
                    FairnessQuestionView::of(place + 1, one, fairness.variants, run)
                })
                .collect(),
        }
    }
}

impl<'f> FairnessQuestionView<'f> {
    fn of(number: usize, question: &'f QuestionFairness, variants: u64, run: &Run) -> Self {
        let words = &run.words.fairness;
        let counted = |phrase: &str, count: u64| {
            let values = [count, variants].map(|number| number.to_string());
            (count > 0).then(|| filled(phrase, &[("count", &values[0]), ("all", &values[1])]))
        };
        let differ = (!question.is_alike()).then(|| words.differ.clone());
        let remarks = [
            differ,
            counted(&words.repeats, question.repeats),
            counted(&words.unusual, question.unusual),
        ];
        let items = question.items.iter();
        Self {
            number,
            remarks: remarks.into_iter().flatten().collect(),
            items: items
                .map(|(id, item)| ItemView::of(id, item, run))
                .collect(),
        }
    }
}

impl<'f> ItemView<'f> {
    fn of(id: &ItemId, item: &'f ItemFairness, run: &Run) -> Self {
        let words = &run.words.fairness;
        let range = |(part, range): (&'f String, &'f Range)| RangeView {
            part,
            least: three_figures(range.least, run.mark),
            most: three_figures(range.most, run.mark),
            unit: &range.unit,
        };
        let parts = match item.parts.map(|count| count.to_string()) {
            [fewest, most] if fewest == most => most,
            [fewest, most] => filled(&words.to, &[("from", &fewest), ("to", &most)]),
        };
        let size = [
            ("variants", &*item.variants.to_string()),
            ("level", &item.level.to_string()),
            ("minutes", &item.minutes.to_string()),
            ("parts", &parts),
        ];
        Self {
            identity: format!("{id} @ {}", item.revision),
            title: &item.title,
            size: filled(&words.item, &size),
            ranges: item.answers.iter().map(range).collect(),
        }
    }
}

/// The page that tells a teacher how alike the variants are.
///
/// # Errors
///
/// [`OutputError::Page`].
pub fn fairness_page(pages: &Pages, fairness: &Fairness) -> Result<String, OutputError> {
    #[derive(Serialize)]
    struct FairnessPage<'a> {
        run: &'a Run,
        fairness: FairnessView<'a>,
    }
    pages.layouts.fill(
        "fairness",
        &FairnessPage {
            run: &pages.run,
            fairness: FairnessView::of(
                fairness,
                &pages.run,
                pages.writer.escape().is_some(),
                |words| pages.placed(words),
            ),
        },
    )
}

/// Two neighbours, and in which questions they share something.
fn pair(alike: &Alike, words: &FairnessWords) -> String {
    let [one, other] = &alike.students;
    let phrase = match alike.questions.len() {
        1 => &words.pair,
        _ => &words.pair_of_several,
    };
    let questions: Vec<String> = alike.questions.iter().map(usize::to_string).collect();
    let values = [
        ("one", &**one),
        ("other", other),
        ("questions", &questions.join(", ")),
    ];
    filled(phrase, &values)
}

fn three_figures(number: f64, mark: DecimalMark) -> String {
    let rounded = Decimal::rounded(number, 3).unwrap_or(Decimal::ZERO);
    match mark {
        DecimalMark::Point => rounded.to_string(),
        DecimalMark::Comma => rounded.to_string().replace('.', ","),
    }
}
