//! Phrases that a native speaker would not write, in the texts that people read: the bank, the book, layouts, messages.
//!
//! The list comes from reading them aloud with lecturers' books beside; what is found gets the better phrase, never an exception.

use std::fs;
use std::path::PathBuf;

use super::files_with;

/// What was written, and what to write.
const PHRASES: &[(&str, &str)] = &[
    ("released at rest", "released from rest"),
    ("let go on", "released on"),
    ("leave the dampers out", "ignore the dampers"),
    ("leave the damper aside", "ignore the damper"),
    ("leave out the friction", "do not contain the friction"),
    ("leave it out", "drop it"),
    ("on one line stand", "… slide along a line"),
    ("on one smooth line", "slide without friction along a line"),
    ("across the motion", "perpendicular to the motion"),
    ("in the mean ", "on average"),
    ("in the mode in phase", "in the in-phase mode"),
    (
        "divide by the mass of the own",
        "divide each equation by its own mass",
    ),
    ("adds to the own", "adds to its own"),
    ("with that of the spring", "including that of the spring"),
    ("changes of sign order", "ordered by their sign changes"),
    ("turn the problem round", "reverse the problem"),
    ("is off?", "the error of …"),
    ("which time passes", "how much time passes"),
    ("how often does the natural", "what is the multiplicity of"),
    ("by which relative error", "what is the relative error"),
    ("from which angle", "what is the smallest angle at which"),
    ("after which smallest", "after how many"),
    ("amplitude become", "what is the largest amplitude"),
    ("does go on", "moves on"),
    ("died away", "the amplitude vanishes"),
    ("is no point", "is not a point"),
    ("is no speed", "is not a speed"),
    ("is no ring", "is not a ring"),
    ("nothing rubs", "no friction acts"),
    ("is no unit", "is not a unit"),
    ("is no force", "is not a force"),
    ("are told", "are reported, are diagnosed, differ by"),
    ("is told", "is reported, is shown"),
    ("told so", "reported"),
    ("tells about", "covers"),
    ("says of itself", "is described by"),
    ("put in place", "substituted"),
    ("the data put in", "the data substituted"),
    ("a whole number", "an integer"),
    ("what a job goes by", "relies on"),
    ("frequent questions", "frequently asked questions"),
    ("has looked over", "has checked"),
    ("goes on rightly", "is otherwise right"),
];

#[test]
fn texts_are_english_as_a_lecturer_writes_it() {
    let read = [
        files_with("bank", "toml"),
        files_with("book/src", "md"),
        files_with("templates", "toml"),
        files_with("templates", "html"),
        files_with("templates", "typ"),
        files_with("templates", "md"),
        files_with("templates", "json"),
        files_with("examples", "toml"),
        files_with("src/message/en", "rs"),
        vec![PathBuf::from("README.md"), PathBuf::from("CONTRIBUTING.md")],
    ];
    let mut found = Vec::new();
    for path in read.iter().flatten() {
        let text = fs::read_to_string(path).unwrap();
        // A phrase may be cut by the end of a line.
        let words: Vec<_> = text.split_whitespace().collect();
        let text = words.join(" ").to_lowercase();
        for (phrase, better) in PHRASES {
            if text.contains(phrase) {
                found.push(format!("{}: `{phrase}`, better: {better}", path.display()));
            }
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}
