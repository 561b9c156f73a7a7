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

/// What joins statements.
pub(crate) const JOINTS: &[&str] = &[" and ", " & ", " but ", " + ", " while ", " whereas "];

/// Words that begin a reason or a correction.
pub(crate) const CLAUSES: &[&str] = &[
    " so ",
    " because ",
    " since ",
    " hence ",
    " therefore ",
    " thus ",
    " i.e. ",
    "->",
    "=>",
];

/// Words that leave open what is said beside them.
pub(crate) const DOUBTS: &[&str] = &[
    "or", "if", "unless", "except", "maybe", "perhaps", "hardly", "barely", "almost", "nearly",
    "neither", "rather", "instead",
];

/// Words that deny what is said beside them, or say more.
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
    "force",
    "case",
    "it",
    "this",
    "they",
];

/// Words that say which way something goes: what stands beside them belongs to them.
pub(crate) const TURNS: &[&str] = &["raise", "lower"];

/// Stems of words that mean the same in this field.
pub(crate) const SYNONYMS: &[&[&str]] = &[
    &["aperiodic", "overdamp", "overcritic", "supercritic"],
    &[
        "pseudoperiodic",
        "underdamp",
        "oscillatory",
        "undercritic",
        "subcritic",
    ],
    &["inphas", "symmetric"],
    &[
        "oppos",
        "opposition",
        "antiphas",
        "outofphas",
        "antisymmetric",
    ],
    &["static", "elastic", "stiffness", "spr", "spring"],
    &["dynamic", "inerti"],
    &["damp", "damper", "dashpot"],
    &["every", "everywher", "alway", "all", "each", "any"],
    &["zero", "0", "vanish", "disappear", "die", "dy", "null"],
    &[
        "not", "no", "never", "without", "neither", "nor", "isnt", "doesnt", "cannot", "nein",
        "non",
    ],
    &["yes", "oui", "ja", "sí"],
    &["stabl", "stabil", "establ"],
    &["unstabl", "instabl", "instabil", "inestabl"],
    &[
        "rais", "mor", "further", "increas", "bigger", "larger", "higher", "greater", "stronger",
        "up",
    ],
    &[
        "lower", "decreas", "reduc", "less", "smaller", "weaker", "down",
    ],
    &["abov", ">"],
    &["below", "<"],
    &["lag", "trail", "behind"],
    &["lead", "ahead"],
    &["same", "constant", "unchang"],
    &["stay", "remain", "keep"],
    &["own", "uniqu"],
    &["theta", "angl"],
    &["quality", "q"],
    &["electromotiv", "emf"],
    &["resistanc", "resistor"],
    &["capacitanc", "capacitor"],
    &["inductanc", "inductor", "coil"],
    &[
        "halfcycl",
        "halfoscillation",
        "halfsw",
        "halbschwingung",
        "halbschwingungen",
    ],
    &[
        "pseudoperiod",
        "quasiperiod",
        "period",
        "cycl",
        "oscillation",
    ],
];

/// Runs of words that are one, and how that is spelled.
pub(crate) const RUNS_OF_WORDS: &[(&str, &str)] = &[
    ("out of phase", "outofphase"),
    ("out-of-phase", "outofphase"),
    ("in phase", "inphase"),
    ("d.o.f", "dof"),
    ("damping ratio", "damping"),
    ("damping coefficient", "damping"),
    ("rate of change", "rate"),
    ("uncoupled", "not coupled"),
    ("not stable", "unstable"),
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
    "must",
    "go",
    "during",
    "across",
];

/// Words that stress what is said, where no option tells itself from others by them.
pub(crate) const STRESSES: &str = "only just exactly simply purely yes clearly indeed definitely both and all well first last still";
