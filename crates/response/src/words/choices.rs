//! The tables of words that choose among options and name what is counted.

/// Words before the option that is chosen.
pub(crate) const ANNOUNCEMENTS: &[&str] = &[
    "i choose",
    "my choice is",
    "the answer is",
    "answer is",
    "answer",
    "option",
    "choice",
    "letter",
    "only",
];

/// Words that say nothing within an option.
pub(crate) const ARTICLES: &[&str] = &["the", "a", "an"];

/// Words that begin a reason or a correction.
pub(crate) const CLAUSES: &[&str] = &[
    " so ",
    " because ",
    " since ",
    " but ",
    " hence ",
    " therefore ",
    " thus ",
    " i.e. ",
];

/// Words that leave open what is said beside them.
pub(crate) const DOUBTS: &[&str] = &[
    "or", "if", "unless", "except", "maybe", "perhaps", "hardly", "barely", "almost", "nearly",
    "neither", "rather", "instead",
];

/// Words that deny what an option says, or say more.
pub(crate) const DENIALS: &[&str] = &[
    "not", "no", "never", "without", "neither", "nor", "and", "or",
];

/// What is asked about, as people name it beside their choice.
pub(crate) const THINGS: &[&str] = &[
    "motion",
    "system",
    "oscillator",
    "oscillation",
    "regime",
    "response",
    "equilibrium",
    "position",
    "damping",
    "displacement",
    "coupling",
    "behind",
    "case",
    "it",
    "this",
    "they",
];

/// Words that mean the same in this field, each in any of its endings.
pub(crate) const SYNONYMS: &[&[&str]] = &[
    &["aperiodic", "overdamped", "overcritical", "supercritical"],
    &[
        "pseudoperiodic",
        "underdamped",
        "oscillatory",
        "undercritical",
        "subcritical",
    ],
    &["inphase", "symmetric", "symmetrical"],
    &[
        "opposed",
        "opposition",
        "antiphase",
        "outofphase",
        "antisymmetric",
        "antisymmetrical",
    ],
    &["static", "elastic", "stiffness"],
    &["dynamic", "inertial", "inertia"],
    &["every", "always", "all", "each", "any"],
    &["zero", "0", "vanish", "die", "dies", "null"],
    &[
        "not", "no", "never", "without", "neither", "nor", "isn't", "doesn't", "cannot",
    ],
    &["further", "more"],
    &[
        "halfcycle",
        "halfoscillation",
        "halfswing",
        "halbschwingung",
        "halbschwingungen",
    ],
    &[
        "pseudoperiod",
        "quasiperiod",
        "period",
        "cycle",
        "oscillation",
    ],
];

/// Runs of words that are one, and how that is spelled.
pub(crate) const RUNS_OF_WORDS: &[(&str, &str)] = &[
    ("out of phase", "outofphase"),
    ("out-of-phase", "outofphase"),
    ("in phase", "inphase"),
    ("d.o.f.", "dof"),
];

/// Words that belong to the next one, with or without a dash.
pub(crate) const PREFIXES: &[&str] = &["pseudo", "quasi", "half", "over", "under", "anti"];

/// Endings of words, in the order in which they fall.
pub(crate) const SUFFIXES: &[&[&str]] = &[
    &["ally", "ly"],
    &["ing", "ed", "es", "s"],
    &["al", "a", "e"],
];

/// Words that say nothing beside others.
pub(crate) const FILLERS: &[&str] = &[
    "the",
    "a",
    "an",
    "it",
    "its",
    "it's",
    "they",
    "there",
    "this",
    "that",
    "these",
    "one",
    "ones",
    "is",
    "are",
    "be",
    "was",
    "has",
    "have",
    "had",
    "does",
    "do",
    "will",
    "would",
    "in",
    "on",
    "at",
    "of",
    "to",
    "for",
    "by",
    "with",
    "through",
    "via",
    "from",
    "as",
    "them",
    "so",
    "therefore",
    "thus",
    "hence",
    "then",
    "we",
    "you",
    "i",
    "makes",
    "make",
    "needs",
    "goes",
    "tends",
    "out",
    "away",
    "decays",
    "decay",
    "approaches",
    "per",
];

/// Words that stress what is said, where no option tells itself from others by them.
pub(crate) const STRESSES: &str = "only just simply purely yes clearly indeed definitely and";
