//! Words that join statements and values, and words before what follows from others.

/// Words that join values, also where they are set as text within a formula.
pub(crate) const JOINING: &[&str] = &["and", "or", "et", "ou", "und", "oder", "in", "at", "cis"];

/// Words that join statements: before what a letter is, and before what follows.
pub(crate) const STATEMENTS: &[&str] = &[
    "with",
    "where",
    "here",
    "at",
    "for",
    "if",
    "when",
    "and",
    "or",
    "so",
    "thus",
    "hence",
    "therefore",
    "mit",
    "wobei",
    "also",
    "avec",
    "où",
    "donc",
    "con",
    "dove",
    "donde",
];

/// Words before what says where a value holds, `at x = 0`.
pub(crate) const PLACES: &[&str] = &["at", "for", "when", "where", "if"];

/// Words before what follows from what stands before them.
pub(crate) const CONCLUSIONS: &[&str] = &[
    "we get ",
    "we obtain ",
    "we find ",
    "we have ",
    "gives ",
    ": ",
];

/// Words and signs before what is concluded, `mg = μmg, so 1`.
pub(crate) const CONCLUDING: &[&str] = &["so", "hence", "thus", "therefore", "→", "->"];
