//! Answers of every kind: responses with the verdict that they get.

mod bank;
mod complex;
mod equation;
mod formula;
mod function;
mod interval;
mod matrix;
mod mode_shape;

use vibank::bank::Catalogue;
use vibank::instance::Instance;
use vibank::solution::Solution;

/// The marking of each response to the first part of an item with this text.
fn check(item: &str, responses: &[(&str, &str)]) {
    let text = format!(
        "[item]\ntitle = \"Test\"\nsource = \"test\"\n[statement]\ntext = \"Test.\"\n{item}"
    );
    let (catalogue, findings) = Catalogue::load([
        ("bank.toml", "format = 1\ntitle = \"Test\"\n"),
        ("ch1/_chapter.toml", "title = \"Test\"\n"),
        ("ch1/test.toml", text.as_str()),
    ]);
    assert!(!catalogue.items().is_empty(), "{findings:#?}");
    let solution = Solution::of(Instance::of_source(&catalogue.items()[0]));
    let marker = solution.marker(0).expect("the key exists");
    let mut wrong = Vec::new();
    for (response, expected) in responses {
        let marking = marker.mark(response);
        let reason = marking
            .reasons
            .first()
            .map(vibank::answer::Reason::code)
            .unwrap_or_default();
        let found = format!("{} {reason}", marking.verdict.name());
        if !found.starts_with(expected) {
            let reading = marking.reading.map(|reading| reading.text);
            wrong.push(format!(
                "{response}: {found}, not {expected}; read as {reading:?}; {:?}",
                marking.feedback
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
