//! The generated parts of the book, held against the program.
//!
//! A part stands between `<!-- generated: DIRECTIVE -->` and `<!-- end -->`. The test makes each anew and
//! compares; `UPDATE_BOOK=1 cargo test --test suite` writes what has changed. The pages of the course are made as a whole.

mod authors;
mod course;
mod english;
mod items;
mod links;
mod pictures;
mod reference;
mod schemas;
#[cfg(unix)]
mod snippets;

use std::fs;
use std::path::{Path, PathBuf};

use crate::generated;

const BEGIN: &str = "\n<!-- generated: ";
const END: &str = "<!-- end -->";

/// All pages.
fn pages() -> Vec<PathBuf> {
    files_with("book/src", "md")
}

/// All files below a folder with an extension, in order.
fn files_with(folder: &str, extension: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![PathBuf::from(folder)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|end| end == extension) {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// A page with its generated parts made anew.
fn anew(page: &Path, text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find(BEGIN) {
        let (before, after) = rest.split_at(start);
        let (head, body) = after
            .split_once("-->\n")
            .unwrap_or_else(|| panic!("{}: a directive without its end", page.display()));
        let (_, behind) = body
            .split_once(END)
            .unwrap_or_else(|| panic!("{}: `{head}` has no `{END}`", page.display()));
        let directive = head[BEGIN.len()..].trim();
        out.push_str(before);
        out.push_str(head);
        out.push_str("-->\n");
        out.push_str(made(directive).trim_end());
        out.push('\n');
        out.push_str(END);
        rest = behind;
    }
    out.push_str(rest);
    if has_formulas(page) {
        typeset(&out)
    } else {
        out
    }
}

/// Whether dollar signs on the page stand around formulas.
fn has_formulas(page: &Path) -> bool {
    page.ends_with("trust/tolerances.md")
}

/// Typesets the formulas in the lines that are neither made nor code.
fn typeset(text: &str) -> String {
    let (mut is_made, mut is_code) = (false, false);
    let mut out = String::with_capacity(text.len());
    for line in text.split_inclusive('\n') {
        is_made |= line.starts_with(BEGIN.trim_start());
        is_code ^= line.starts_with("```");
        if is_made || is_code {
            out.push_str(line);
        } else {
            out.push_str(&pictures::typeset(line));
        }
        is_made &= !line.starts_with(END);
    }
    out
}

/// What a directive stands for.
fn made(directive: &str) -> String {
    let (verb, argument) = directive.split_once(' ').unwrap_or((directive, ""));
    match verb {
        "math" => items::math(argument),
        "item" => items::worked(argument),
        "items" => items::chapter(argument),
        "plot" | "figure" => pictures::asked(directive),
        "source" => pictures::source(argument),
        "schema" => schemas::table(argument),
        "run" => reference::run(argument),
        "commands" => reference::commands(),
        "units" => reference::units(),
        "codes" => reference::codes(),
        "answer-kinds" => reference::answer_kinds(),
        "elements" => reference::elements(),
        "renamed" => items::renamed(),
        _ => panic!("there is no directive `{verb}`"),
    }
}

#[test]
fn generated_parts_are_fresh() {
    let pages = pages().into_iter();
    let pages = pages.filter(|page| !page.starts_with("book/src/course"));
    generated::compare_all(pages.map(|page| {
        let text = fs::read_to_string(&page).unwrap();
        let anew = anew(&page, &text);
        (page, anew)
    }));
}

#[test]
fn formulas_look_like_those_of_the_sheets() {
    let rules = vibank::math::MATHML_STYLE.replace('}', "}\n");
    let marks = ["/* math: begin */\n", "/* math: end */"];
    generated::compare_between("book/theme/vibank.css", marks, &rules);
}
