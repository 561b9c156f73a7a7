//! The pieces of a question as a page shows them.

use serde::Serialize;

use crate::answer::{AnswerKind, Blank};
use crate::bank::{Part, Template};
use crate::document::Document;
use crate::expr::Shape;
use crate::figure::Picture;
use crate::math::{Display, Voice};
use crate::scene::Shown;
use crate::solution::Solution;
use crate::worksheet::{PracticeQuestion, letter};

/// The parts of a question that are asked for these data, as places in the item.
pub(crate) fn asked(question: &PracticeQuestion, solution: &Solution<'_>) -> Vec<usize> {
    let parts = &solution.template().parts;
    (0..parts.len())
        .filter(|place| question.asks(&parts[*place]) && solution.asks(*place))
        .collect()
}

/// Texts, one after the other.
pub(crate) fn html(shown: &[Shown<'_>], voice: &'static Voice) -> String {
    let mut out = String::new();
    for piece in shown {
        piece.document.write_html(&mut out, &piece.fillings, voice);
    }
    out
}

/// A figure with what is written under it.
pub(crate) fn figure(picture: &Picture, caption: &Document, voice: &'static Voice) -> String {
    let mut out = format!("<figure>{}", picture.svg);
    if !caption.is_empty() {
        out.push_str("<figcaption>");
        caption.write_html_line(&mut out, &Vec::new(), voice);
        out.push_str("</figcaption>");
    }
    out.push_str("</figure>\n");
    out
}

/// An option of a choice.
#[derive(Serialize)]
pub(crate) struct ShownOption {
    id: String,
    letter: String,
    text: String,
}

/// The options of a choice in the order in which they are shown.
pub(crate) fn options(
    solution: &Solution<'_>,
    place: usize,
    voice: &'static Voice,
) -> Vec<ShownOption> {
    let options = solution.template().parts[place].answer.options();
    if options.is_empty() {
        return Vec::new();
    }
    let order = solution.order(place).into_iter().enumerate();
    order
        .map(|(at, place)| {
            let mut text = String::new();
            let own = &options[place].text;
            own.write_html_line(&mut text, &Vec::new(), voice);
            ShownOption {
                id: options[place].id.clone(),
                letter: letter(at),
                text,
            }
        })
        .collect()
}

/// What a tap puts into an answer.
#[derive(Serialize)]
pub(crate) struct Insertion {
    /// The characters that are inserted.
    typed: String,
    /// As it is shown.
    symbol: String,
    /// As it is said.
    name: String,
}

/// The letters that an answer may use, and the unit of its numbers.
pub(crate) fn insertions(blank: &Blank, voice: &'static Voice) -> Vec<Insertion> {
    let letters = blank.letters.iter().map(|letter| Insertion {
        typed: letter.typed.clone(),
        symbol: letter.symbol.mathml(Display::Inline, voice),
        name: letter.symbol.spoken(voice),
    });
    let unit = blank.unit.iter().map(|unit| Insertion {
        typed: format!(" {unit}"),
        symbol: unit.math().mathml(Display::Inline, voice),
        name: unit.spoken(true, voice),
    });
    letters.chain(unit).collect()
}

/// Rows and columns of an answer that is easier to fill in entry by entry.
pub(crate) fn shape(part: &Part, template: &Template) -> Option<(usize, usize)> {
    /// Wider tables do not fit a telephone.
    const MAX_COUNT: usize = 6;
    let keys = part.answer.keys();
    let [key] = keys[..] else {
        return None;
    };
    let shape = template.graph.kind(key)?.shape();
    let (rows, columns) = match (part.answer.kind(), shape) {
        (AnswerKind::Matrix, Shape::Matrix(rows, columns)) => (rows, columns),
        (AnswerKind::ModeShape, Shape::Vector(rows)) => (rows, 1),
        _ => return None,
    };
    (rows <= MAX_COUNT && columns <= MAX_COUNT).then_some((rows, columns))
}
