//! Which option of a choice a platform reports: it writes the words of the option as they were exported, without tags.

use vibank::bank::Part;
use vibank::document::{Document, Filling, Formulas};
use vibank::math::Voice;

use super::cells::bare;

/// The place in the file of the option with these words, if there is one.
pub(crate) fn chosen(part: &Part, words: &str) -> Option<usize> {
    let options = part.answer.options();
    let only = |same: &dyn Fn(&Document) -> bool| {
        let mut found = (0..options.len()).filter(|at| same(&options[*at].text));
        let first = found.next()?;
        found.next().is_none().then_some(first)
    };
    let typed = bare(words);
    let notations = [Formulas::MathMl, Formulas::Tex];
    // Moodle marks bold and slanted words by signs of its own.
    only(&|document| {
        let mut written = notations
            .iter()
            .map(|notation| exported(document, *notation));
        written.any(|own| own == typed)
    })
    .or_else(|| {
        only(&|document| {
            let mut written = notations
                .iter()
                .map(|notation| exported(document, *notation));
            written.any(|own| letters(&own) == letters(&typed))
        })
    })
}

/// The letters and digits of a text.
fn letters(text: &str) -> String {
    text.chars()
        .filter(|char| char.is_alphanumeric())
        .collect::<String>()
}

/// The words of an option as they were exported.
fn exported(document: &Document, notation: Formulas) -> String {
    let mut html = String::new();
    // What is heard of formulas is an attribute, which is not reported.
    let none = Vec::<Filling>::new();
    document.write_html_line_with(&mut html, &none, notation, Voice::ENGLISH);
    bare(&html)
}
