//! Marks of units and of conjugates in more than one sign.

/// Spellings of a unit under a root after a list, and what is read.
pub(crate) const ROOTED_UNITS: &[(&str, &str)] = &[
    ("1/sqrt(kg)", "kg^(-1/2)"),
    ("1/√(kg)", "kg^(-1/2)"),
    ("1/√kg", "kg^(-1/2)"),
    ("/sqrt(kg)", " kg^(-1/2)"),
    ("/√(kg)", " kg^(-1/2)"),
    ("/√kg", " kg^(-1/2)"),
];

/// The complex conjugates of what stands before them, the longer ones before those with which they begin.
pub(crate) const CONJUGATES: &[&str] = &[
    "\\text{c.c.}",
    "\\mathrm{c.c.}",
    "\\text{cc}",
    "\\mathrm{cc}",
    "c.c.",
    "c. c.",
    "c.c",
    "C.C.",
    "cc",
    "k.k.",
];
