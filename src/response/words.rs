//! The one table of words that join or measure, other languages beside English.

/// Words that stand for others, between spaces.
pub(super) const WORDS: &[(&str, &str)] = &[
    ("et", "and"),
    ("AND", "and"),
    ("And", "and"),
    ("und", "and"),
    ("ou", "or"),
    ("OR", "or"),
    ("Or", "or"),
    ("oder", "or"),
    ("si", "if"),
    ("pour", "for"),
    ("quand", "when"),
    ("else", "otherwise"),
    ("sinon", "otherwise"),
];

/// Words that join values, also where they are set as text within a formula.
pub(super) const JOINING: &[&str] = &["and", "or", "et", "ou", "und", "oder", "in", "at", "cis"];
