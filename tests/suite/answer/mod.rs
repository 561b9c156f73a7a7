//! Answers of every kind: responses with the verdict that they get.

mod altered;
mod bank;
mod blank;
mod choice;
mod complex;
mod corpus;
mod domain;
mod echo;
mod equation;
mod formula;
mod function;
mod hostile;
mod interval;
mod matrix;
mod mode_shape;
mod number;
mod spellings;
mod trials;
mod typed;
mod typing;

use vibank::answer::Marking;
use vibank::bank::Catalogue;
use vibank::instance::Instance;
use vibank::message::Language;
use vibank::solution::Solution;

/// The catalogue of an item with this text.
fn catalogue(item: &str) -> Catalogue {
    let text = format!(
        "[item]\ntitle = \"Test\"\nsource = \"test\"\n[statement]\ntext = \"Test.\"\n{item}"
    );
    let (catalogue, findings) = Catalogue::load([
        ("bank.toml", "format = 1\ntitle = \"Test\"\n"),
        ("ch1/_chapter.toml", "title = \"Test\"\n"),
        ("ch1/test.toml", text.as_str()),
    ]);
    assert!(catalogue.items().next().is_some(), "{findings:#?}");
    catalogue
}

/// An item with one part of every kind.
pub(crate) fn kinds() -> Catalogue {
    hostile::catalogue()
}

/// What is said of a marking in English, but for texts of the item.
fn said(marking: &Marking) -> String {
    let said = marking
        .remarks
        .iter()
        .filter_map(|remark| Language::English.say(remark));
    let said = said.map(|said| vibank::grade::Comment::from(said).plain());
    said.collect::<Vec<_>>().join(" ")
}

/// Marks each response to the first part of an item with this text. Expected is the verdict, the code of the main reason,
/// and after a colon what the feedback has to contain; each may be left out.
fn check(item: &str, responses: &[(&str, &str)]) {
    let catalogue = catalogue(item);
    let solution = Solution::of(Instance::of_source(catalogue.items().next().unwrap()));
    let mut wrong = Vec::new();
    for (response, expected) in responses {
        let marking = vibank::grade::mark(&solution, 0, response);
        let reason = marking.reason().code();
        let found = format!("{} {reason}", marking.verdict.name());
        let said = said(&marking);
        let (expected, words) = expected.split_once(": ").unwrap_or((expected, ""));
        if !found.starts_with(expected) || !said.contains(words) {
            let reading = marking.reading.map(|reading| reading.text);
            wrong.push(format!(
                "{response}: {found}, not {expected}: {words}; read as {reading:?}; {said}"
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
