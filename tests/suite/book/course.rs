//! The pages of the course, made of the chapters that the bank carries and `vibank course` prints.

use std::fs;
use std::path::PathBuf;

use vibank::output::{ChapterPiece, chapter_pieces};

use super::{items, pictures};
use crate::generated;

const FOLDER: &str = "book/src/course";

/// A chapter as a page of the book, its pieces apart: HTML goes on to the next empty line.
fn page(name: &str, text: &str) -> String {
    let head = format!(
        "<!-- Made of bank/course/{name}: `UPDATE_BOOK=1 cargo test --test suite` writes it anew. -->"
    );
    let pieces = chapter_pieces(text).unwrap().into_iter();
    let pieces = pieces.map(|(_, piece)| match piece {
        ChapterPiece::Heading(_, line) => pictures::typeset(line),
        ChapterPiece::Text(text) => {
            let lines = text.trim_matches('\n').split_inclusive('\n');
            lines.map(typeset).collect()
        }
        ChapterPiece::Picture { item, plot, words } => pictures::picture(item, plot, words),
        ChapterPiece::Example(item) => items::worked(item),
    });
    let pieces: Vec<String> = std::iter::once(head).chain(pieces).collect();
    pieces.join("\n\n") + "\n"
}

/// A line of text with its formulas typeset, or a displayed formula.
fn typeset(line: &str) -> String {
    let display = line.trim_end().strip_prefix("$$");
    match display.and_then(|rest| rest.strip_suffix("$$")) {
        Some(latex) => {
            let end = if line.ends_with('\n') { "\n" } else { "" };
            format!("{}{end}", items::math(latex))
        }
        None => pictures::typeset(line),
    }
}

/// Where to go on from a chapter: its exercises, and the chapter after it.
fn onward(place: usize) -> &'static str {
    const LINES: [&str; 5] = [
        "[All exercises of this chapter](../exercises/ch1.md) · next: [free oscillations](2-free.md)",
        "[All exercises of this chapter](../exercises/ch2.md) · next: [damped oscillations](3-damped.md)",
        "[All exercises of this chapter](../exercises/ch3.md) · next: [forced oscillations](4-forced.md)",
        "[All exercises of this chapter](../exercises/ch4.md) · next: [several degrees of freedom](5-several.md)",
        "[All exercises of this chapter](../exercises/ch5.md)",
    ];
    LINES.get(place).copied().unwrap_or_default()
}

#[test]
fn the_pages_are_those_of_the_chapters() {
    let chapters = vibank::bank::course();
    assert_eq!(chapters.len(), 6);
    for (place, (path, text)) in chapters.iter().enumerate() {
        let name = path.rsplit('/').next().unwrap();
        let page = format!("{}\n{}", page(name, text), onward(place));
        generated::compare(
            format!("{FOLDER}/{name}"),
            &format!("{}\n", page.trim_end()),
        );
    }
    let pages = fs::read_dir(FOLDER).unwrap();
    let strays: Vec<PathBuf> = pages
        .map(|page| page.unwrap().path())
        .filter(|page| {
            let name = page.file_name().unwrap().to_str().unwrap();
            chapters
                .iter()
                .all(|(path, _)| !path.ends_with(&format!("/{name}")))
        })
        .collect();
    assert!(strays.is_empty(), "no chapter makes {strays:?}");
}
