//! The tables of words that join, measure or count, other languages beside English.

/// Words that stand for others or for signs, between spaces; the longer ones before those with which they begin.
pub(super) const WORDS: &[(&str, &str)] = &[
    ("greater than or equal to", "≥"),
    ("larger than or equal to", "≥"),
    ("more than or equal to", "≥"),
    ("less than or equal to", "≤"),
    ("smaller than or equal to", "≤"),
    ("not less than", "≥"),
    ("no less than", "≥"),
    ("not smaller than", "≥"),
    ("no smaller than", "≥"),
    ("not more than", "≤"),
    ("no more than", "≤"),
    ("not greater than", "≤"),
    ("no greater than", "≤"),
    ("not larger than", "≤"),
    ("no larger than", "≤"),
    ("greater than", ">"),
    ("larger than", ">"),
    ("more than", ">"),
    ("less than", "<"),
    ("smaller than", "<"),
    ("at least", "≥"),
    ("at most", "≤"),
    ("up to", "≤"),
    ("not below", "≥"),
    ("not above", "≤"),
    ("above or equal to", "≥"),
    ("below or equal to", "≤"),
    ("above", ">"),
    ("below", "<"),
    ("au moins", "≥"),
    ("au plus", "≤"),
    ("mindestens", "≥"),
    ("höchstens", "≤"),
    ("per cent", "%"),
    ("is", "="),
    ("equals", "="),
    ("est", "="),
    ("ist", "="),
    ("approximately", " "),
    ("approx.", " "),
    ("approx", " "),
    ("about", " "),
    ("roughly", " "),
    ("circa", " "),
    ("ca.", " "),
    ("environ", " "),
    ("etwa", " "),
    ("par", "per"),
    ("por", "per"),
    ("pro", "per"),
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

/// Verbs before words that compare: `x must be at least 3 m`.
pub(super) const VERBS: &[&str] = &[
    "is",
    "must be",
    "should be",
    "has to be",
    "needs to be",
    "can be",
    "may be",
];

/// What is said before an answer and is no part of it, in any case.
pub(super) const LEADS: &[&str] = &[
    "the answer is",
    "answer is",
    "the result is",
    "answer",
    "ans.",
    "ans",
    "result",
    "la réponse est",
    "réponse",
    "die antwort ist",
    "antwort",
    "la respuesta es",
    "respuesta",
    "it is",
    "it's",
    "this is",
    "we get",
    "we find",
    "we have",
    "i get",
    "so",
    "thus",
    "hence",
    "therefore",
    "donc",
    "alors",
    "also",
    "daher",
    "approximately",
    "approx.",
    "approx",
    "about",
    "around",
    "roughly",
    "nearly",
    "exactly",
    "circa",
    "ca.",
    "environ",
    "etwa",
    "ungefähr",
    "eom",
    "equation of motion",
    "equation",
    "équation du mouvement",
    "équation",
    "bewegungsgleichung",
    "lambda t",
    "@(t)",
    "t ->",
    "t →",
    "t ↦",
    "t \\mapsto",
    "t \\to",
    "return",
    "def x(t): return",
    "\\therefore",
    "\\Rightarrow",
    "\\implies",
    "∴",
    "⇒",
    "⟹",
    "→",
    "=>",
];

/// What is said behind an answer and is no part of it.
pub(super) const TRAILS: &[&str] = &[
    "approx.",
    "approximately",
    "in SI units",
    "in SI",
    ", t in s",
    ", t in seconds",
];

/// What is said before or behind a response that is not meant.
pub(super) const WITHDRAWALS: &[&str] = &[
    "wrong",
    "false",
    "incorrect",
    "untrue",
    "faux",
    "falsch",
    "falso",
    "incorrecto",
];

/// Words of a remark in brackets behind an answer, `(to 3 s.f.)`, `(in SI units)`.
pub(super) const ASIDES: &[&str] = &[
    "approx",
    "approx.",
    "approximately",
    "rounded",
    "exact",
    "exactly",
    "about",
    "to",
    "in",
    "SI",
    "units",
    "s.f.",
    "sf",
    "s.f",
    "sig",
    "sig.",
    "fig",
    "fig.",
    "figs",
    "figs.",
    "figures",
    "significant",
    "d.p.",
    "dp",
    "decimal",
    "decimals",
    "places",
    "digits",
    "environ",
    "arrondi",
    "unités",
    "gerundet",
    "ca.",
    "Einheiten",
];

/// Small numbers as words.
const COUNTS: &[(&str, u8)] = &[
    ("zero", 0),
    ("one", 1),
    ("two", 2),
    ("three", 3),
    ("four", 4),
    ("five", 5),
    ("six", 6),
    ("seven", 7),
    ("eight", 8),
    ("nine", 9),
    ("ten", 10),
    ("eleven", 11),
    ("twelve", 12),
    ("un", 1),
    ("deux", 2),
    ("trois", 3),
    ("quatre", 4),
    ("cinq", 5),
    ("sept", 7),
    ("huit", 8),
    ("neuf", 9),
    ("dix", 10),
    ("eins", 1),
    ("zwei", 2),
    ("drei", 3),
    ("vier", 4),
    ("fünf", 5),
    ("sechs", 6),
    ("sieben", 7),
    ("acht", 8),
    ("neun", 9),
    ("zehn", 10),
];

/// What is counted in this field, the longer words before those with which they end. Cycles and half-cycles are missing:
/// three of the ones are six of the others.
const COUNTED: &[&str] = &[
    "degrees of freedom",
    "degree of freedom",
    "degrés de liberté",
    "degré de liberté",
    "freiheitsgrade",
    "freiheitsgrad",
    "dofs",
    "dof",
    "ddl",
    "coordinates",
    "constraints",
    "modes",
];

/// A count in digits without what is counted: `two degrees of freedom` is `2`; none where nothing of that was typed.
pub fn count_in_digits(typed: &str) -> Option<String> {
    let text = typed.trim().trim_end_matches(['.', '!']);
    let without = |what: &&str| {
        let (before, tail) = text.split_at_checked(text.len().checked_sub(what.len())?)?;
        let is_it = tail.eq_ignore_ascii_case(what) && before.ends_with(' ');
        is_it
            .then(|| before.trim_end())
            .filter(|before| !before.is_empty())
    };
    let alone = COUNTED.iter().find_map(without);
    let count = alone.unwrap_or(text);
    let last = count.rsplit([' ', '=', ':']).next().unwrap_or(count);
    let number = COUNTS
        .iter()
        .find(|(word, _)| last.eq_ignore_ascii_case(word));
    match number {
        Some((_, number)) => Some(format!("{}{number}", &count[..count.len() - last.len()])),
        None => alone.map(str::to_owned),
    }
}

/// Roots in other languages, before a bracket.
pub(super) const ROOTS: &[&str] = &[
    "racine", "RACINE", "Racine", "wurzel", "WURZEL", "Wurzel", "raiz", "RAIZ", "raíz", "RAÍZ",
];

/// Calls of programs that stand for the number in their brackets.
pub(super) const NUMBERS: &[&str] = &[
    "np.float64",
    "np.float32",
    "np.complex128",
    "numpy.float64",
    "float",
    "int",
];

/// Calls of programs that stand for the list in their brackets.
pub(super) const LISTS: &[&str] = &[
    "np.array",
    "numpy.array",
    "array",
    "np.matrix",
    "numpy.matrix",
    "sp.Matrix",
    "sympy.Matrix",
    "Matrix",
    "matrix",
    "mat",
    "vec",
    "vector",
    "Vector",
    "col",
    "list",
    "List",
    "tuple",
];

/// Calls of programs that make an equation of their two arguments.
pub(super) const EQUATIONS: &[&str] = &["Eq", "sp.Eq", "sympy.Eq", "Equal", "Equality"];

/// Words that join values, also where they are set as text within a formula.
pub(super) const JOINING: &[&str] = &["and", "or", "et", "ou", "und", "oder", "in", "at", "cis"];
