//! The tables of words that say which values are meant, and which of several comes first.

/// Words before a condition.
pub(crate) const CONDITIONS: &[&str] = &[
    "for all values of",
    "for all",
    "for any",
    "for every",
    "for each",
    "for values of",
    "for",
    "if and only if",
    "only if",
    "iff",
    "if",
    "when",
    "whenever",
    "where",
    "with",
    "wenn",
    "all values of",
    "all values",
    "all",
    "any value of",
    "any value",
    "any",
    "every",
    "each",
    "values of",
    "values",
    "either",
    "provided that",
    "provided",
    "as long as",
    "everywhere with",
    "everywhere where",
    "wherever",
    "falls",
    "anywhere",
];

/// Words around the two ends of a range.
pub(crate) const RANGES: &[(&str, &str)] = &[
    ("from ", " to "),
    ("between ", " and "),
    ("von ", " bis "),
    ("zwischen ", " and "),
    ("entre ", " and "),
    ("de ", " à "),
];

/// What comes after the lower end of a range that has no upper one.
pub(crate) const UNBOUNDED: &[&str] = &[
    " on",
    " onwards",
    " upwards",
    " to ∞",
    " to infinity",
    " to inf",
];

/// Words before both ends of a range at once, `within ±3 mm`.
pub(crate) const WITHIN: &[&str] = &["within", "between"];

/// What comes after both ends at once, `±3 mm and everything in between`.
pub(crate) const INSIDE: &[&str] = &[
    " and everything in between",
    " and everything between",
    " and anything in between",
    " and all in between",
];

/// What comes after the one end of a range, and whether that is the upper one.
pub(crate) const ONWARDS: &[(&str, bool)] = &[
    (" and above", false),
    (" and more", false),
    (" and up", false),
    (" and larger", false),
    (" and greater", false),
    (" and higher", false),
    (" and below", true),
    (" and less", true),
    (" and smaller", true),
    (" and lower", true),
    (" or higher", false),
    (" or bigger", false),
    (" or more", false),
    (" or greater", false),
    (" or larger", false),
    (" or above", false),
    (" or less", true),
    (" or smaller", true),
    (" or lower", true),
    (" or below", true),
];

/// What a value of a list is said to be by its rank, with that rank; the last one has none.
pub(crate) const RANKS: &[(&str, Option<u8>)] = &[
    ("lowest", Some(1)),
    ("lower", Some(1)),
    ("smallest", Some(1)),
    ("smaller", Some(1)),
    ("fundamental", Some(1)),
    ("in phase", Some(1)),
    ("in-phase", Some(1)),
    ("symmetric", Some(1)),
    ("first", Some(1)),
    ("1st", Some(1)),
    ("mode 1", Some(1)),
    ("1", Some(1)),
    ("middle", Some(2)),
    ("second", Some(2)),
    ("2nd", Some(2)),
    ("mode 2", Some(2)),
    ("2", Some(2)),
    ("third", Some(3)),
    ("3rd", Some(3)),
    ("mode 3", Some(3)),
    ("3", Some(3)),
    ("highest", None),
    ("higher", None),
    ("upper", None),
    ("largest", None),
    ("larger", None),
    ("opposed", None),
    ("in opposition", None),
    ("out of phase", None),
    ("out-of-phase", None),
    ("antiphase", None),
    ("antisymmetric", None),
];

/// Words before the one end of a range, and whether that is the upper one.
pub(crate) const LIMITS: &[(&str, bool)] = &[
    ("maximum", true),
    ("max.", true),
    ("max", true),
    ("minimum", false),
    ("min.", false),
    ("min", false),
];

/// Words after a range, alone or in brackets, and whether they leave its ends out; the longer ones before those with
/// which they end.
pub(crate) const ENDS: &[(&str, bool)] = &[
    ("incl. ends", false),
    ("incl. the ends", false),
    ("incl.", false),
    ("excl.", true),
    ("both ends included", false),
    ("ends included", false),
    ("both included", false),
    ("both inclusive", false),
    ("including both ends", false),
    ("including the ends", false),
    ("including the bounds", false),
    ("inclusive", false),
    ("not included", true),
    ("included", false),
    ("including", false),
    ("both ends excluded", true),
    ("ends excluded", true),
    ("both excluded", true),
    ("excluding both ends", true),
    ("excluding the ends", true),
    ("exclusive", true),
    ("excluded", true),
    ("excluding", true),
];
