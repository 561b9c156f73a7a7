//! The tables of words that join, measure or count, other languages beside English.

/// What a word stands for that may stand last.
pub(crate) const PERCENT: &str = "%";

/// Words that stand for others or for signs, between spaces; the longer ones before those with which they begin.
pub(crate) const WORDS: &[(&str, &str)] = &[
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
    ("supérieur ou égal à", "≥"),
    ("supérieure ou égale à", "≥"),
    ("inférieur ou égal à", "≤"),
    ("inférieure ou égale à", "≤"),
    ("supérieur à", ">"),
    ("supérieure à", ">"),
    ("inférieur à", "<"),
    ("inférieure à", "<"),
    ("plus grand que", ">"),
    ("plus petit que", "<"),
    ("au moins", "≥"),
    ("au plus", "≤"),
    ("größer oder gleich", "≥"),
    ("kleiner oder gleich", "≤"),
    ("größer gleich", "≥"),
    ("kleiner gleich", "≤"),
    ("größer als", ">"),
    ("kleiner als", "<"),
    ("mindestens", "≥"),
    ("höchstens", "≤"),
    ("per cent", PERCENT),
    ("pour cent", PERCENT),
    ("Prozent", PERCENT),
    ("i.e.", "="),
    ("that is", "="),
    ("d.h.", "="),
    ("c.-à-d.", "="),
    ("minus", "-"),
    ("plus", "+"),
    ("times", "*"),
    ("multiplied by", "*"),
    ("divided by", "/"),
    ("over", "/"),
    ("squared", "^2"),
    ("cubed", "^3"),
    ("mal", "*"),
    ("geteilt durch", "/"),
    ("fois", "*"),
    ("divisé par", "/"),
    ("is equal to", "="),
    ("comes out as", "="),
    ("comes out to be", "="),
    ("turns out to be", "="),
    ("works out as", "="),
    ("has the value", "="),
    ("would be", "="),
    ("becomes", "="),
    ("beträgt", "="),
    ("vaut", "="),
    ("vale", "="),
    ("es", "="),
    ("è", "="),
    ("is", "="),
    ("are", "="),
    ("sind", "="),
    ("sont", "="),
    ("son", "="),
    ("sono", "="),
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
    ("env.", " "),
    ("etwa", " "),
    ("ungefähr", " "),
    ("rund", " "),
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

/// Where a word that is a letter elsewhere stands for another.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Between {
    /// Between two values.
    Values,
    /// Between two values, the second one with decimals: `3 e 5` may have a power of ten, which has none.
    Decimals,
    /// Between a value and the unit that ends the response.
    Unit,
}

/// Words that are letters elsewhere, with what they stand for and where.
pub(crate) const LETTERS: &[(&str, &str, Between)] = &[
    ("y", "and", Between::Values),
    ("e", "and", Between::Decimals),
    ("in", " ", Between::Unit),
];

/// Verbs before words that compare: `x must be at least 3 m`.
pub(crate) const VERBS: &[&str] = &[
    "is",
    "must be",
    "should be",
    "has to be",
    "needs to be",
    "can be",
    "may be",
];

/// What is said before an answer and is not part of it, in any case.
pub(crate) const LEADS: &[&str] = &[
    "the final answer is",
    "the correct answer is",
    "the general solution is",
    "general solution",
    "the solution is",
    "solution is",
    "solution",
    "sol.",
    "sol",
    "finally",
    "in conclusion",
    "in total",
    "overall",
    "as a result",
    "consequently",
    "accordingly",
    "that means",
    "this means",
    "it should be",
    "should be",
    "it must be",
    "it would be",
    "i think it is",
    "i think it's",
    "i think its",
    "i think that",
    "i think",
    "i believe",
    "i guess",
    "maybe",
    "probably",
    "which is",
    "which equals",
    "it equals",
    "equals",
    "equal to",
    "we can write",
    "we see that",
    "this leads to",
    "leads to",
    "this yields",
    "this implies",
    "from this",
    "with this",
    "substituting",
    "rearranging",
    "simplifying",
    "simplified",
    "result is",
    "the value is",
    "value",
    "outcome",
    "final answer",
    "my answer is",
    "my answer",
    "the answer is",
    "answer is",
    "the result is",
    "answer",
    "ans.",
    "ans",
    "result",
    "la réponse est",
    "réponse",
    "résultat",
    "ergebnis",
    "lösung",
    "die antwort ist",
    "antwort",
    "das ergebnis ist",
    "die lösung ist",
    "die lösung lautet",
    "das ergebnis lautet",
    "also gilt",
    "damit folgt",
    "damit",
    "dann",
    "es gilt",
    "wir erhalten",
    "ich erhalte",
    "gleichung",
    "la respuesta es",
    "la solución es",
    "el resultado es",
    "respuesta final",
    "respuesta",
    "resultado",
    "solución",
    "por lo tanto",
    "por tanto",
    "entonces",
    "luego",
    "se obtiene",
    "obtenemos",
    "aproximadamente",
    "aprox.",
    "la risposta è",
    "la soluzione è",
    "il risultato è",
    "risposta finale",
    "risposta",
    "risultato",
    "soluzione",
    "quindi",
    "dunque",
    "perciò",
    "allora",
    "si ottiene",
    "otteniamo",
    "la solution est",
    "le résultat est",
    "réponse finale",
    "par conséquent",
    "nous obtenons",
    "il s'ensuit",
    "finalement",
    "答案是",
    "答案",
    "答",
    "所以",
    "因此",
    "解得",
    "可得",
    "得到",
    "it is",
    "it's",
    "this is",
    "we get",
    "we find that",
    "we have that",
    "we find",
    "we have",
    "i get",
    "i got",
    "i find",
    "i found",
    "i obtain",
    "we got",
    "we obtain",
    "it follows that",
    "it follows",
    "this gives",
    "which gives",
    "gives",
    "yields",
    "from which",
    "then",
    "is",
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
    "env.",
    "approximativement",
    "à peu près",
    "presque",
    "soit",
    "ainsi",
    "on en déduit",
    "ce qui donne",
    "cela donne",
    "ça donne",
    "c'est",
    "j'obtiens",
    "je trouve",
    "on trouve",
    "on obtient",
    "on a",
    "il vient",
    "d'où",
    "etwa",
    "ungefähr",
    "rund",
    "somit",
    "folglich",
    "daraus folgt",
    "es folgt",
    "ergibt",
    "man erhält",
    "eom",
    "eq.",
    "eq",
    "eqn",
    "the equation of motion is",
    "the equation is",
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
    "->",
    "=>",
];

/// What is said after an answer and is not part of it.
pub(crate) const TRAILS: &[&str] = &[
    ", approx.",
    ", approx",
    ", approximately",
    "approx.",
    "approx",
    "maybe",
    "probably",
    "I think",
    "i think",
    "I guess",
    "aprox.",
    "aproximadamente",
    "approximately",
    "environ",
    "circa",
    "ungefähr",
    "// N",
    "//N",
    "// Simplify",
    "//Simplify",
    "in SI units",
    "in SI",
    "QED",
    "q.e.d.",
    ", rounded",
    ", t in s",
    ", t in seconds",
];

/// Words after a value that say of which sign or of what it is: without them it would be another one.
pub(crate) const TURNING: &[&str] = &[
    "left",
    "leftward",
    "leftwards",
    "right",
    "rightward",
    "rightwards",
    "down",
    "downward",
    "downwards",
    "upward",
    "upwards",
    "above",
    "below",
    "compressed",
    "compression",
    "stretched",
    "elongated",
    "extended",
    "extension",
    "shortened",
    "shortening",
    "lengthened",
    "negative",
    "positive",
    "minus",
    "lagging",
    "leading",
    "lags",
    "leads",
    "behind",
    "ahead",
    "clockwise",
    "counterclockwise",
    "anticlockwise",
    "inverse",
    "inverted",
    "squared",
    "cubed",
    "half",
    "double",
    "doubled",
    "each",
    "both",
    "total",
    "maybe",
    "wrong",
    "false",
    "modulo",
];

/// Marks after an answer that is meant to be right, with or without a space.
pub(crate) const SEALS: &[&str] = &[
    "✓",
    "✔",
    "✅",
    "∎",
    "□",
    "\\checkmark",
    "\\square",
    "\\blacksquare",
];

/// Words with which a reason begins after an answer; the short ones after a comma alone.
pub(crate) const REASONS: &[&str] = &[
    "because", "since", "as", "weil", "da", "denn", "puisque", "parce", "car", "porque", "ya que",
    "perché", "poiché",
];

/// What is said before or after a response that is not meant.
pub(crate) const WITHDRAWALS: &[&str] = &[
    "wrong",
    "false",
    "incorrect",
    "untrue",
    "faux",
    "falsch",
    "falso",
    "incorrecto",
];

/// Words after a value that repeat what it says, and change nothing: none of a sign, a direction or a factor.
pub(crate) const REMARKS: &[&str] = &[
    "translation",
    "rotation",
    "rigid body",
    "rigid-body",
    "rigid body mode",
    "rigid-body mode",
    "symmetric",
    "symmetrical",
    "singular",
    "double",
    "double root",
    "twofold",
    "dimensionless",
    "no unit",
    "unitless",
    "in phase",
    "out of phase",
    "in opposition",
    "in antiphase",
    "opposed",
    "lowest",
    "highest",
    "lower",
    "upper",
    "underdamped",
    "overdamped",
    "constant",
    "any combination",
    "any multiple",
    "or any multiple",
];

/// Words of a remark in brackets after an answer, `(to 3 s.f.)`, `(in SI units)`.
pub(crate) const ASIDES: &[&str] = &[
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
    "s.d.",
    "decimal",
    "decimals",
    "places",
    "digits",
    "environ",
    "arrondi",
    "à",
    "chiffres",
    "décimales",
    "unités",
    "aprox.",
    "aproximadamente",
    "redondeado",
    "arrotondato",
    "auf",
    "Stellen",
    "Nachkommastellen",
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
    ("thirteen", 13),
    ("fourteen", 14),
    ("fifteen", 15),
    ("sixteen", 16),
    ("seventeen", 17),
    ("eighteen", 18),
    ("nineteen", 19),
    ("twenty", 20),
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
    "independent coordinates",
    "coordinates",
    "independent constraints",
    "constraints",
    "constraint",
    "equations",
    "pairs",
    "modes",
];

/// A count in digits without what is counted: `two degrees of freedom` is `2`; none where nothing of that was typed.
pub(crate) fn count_in_digits(typed: &str) -> Option<String> {
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

/// An integer without the remark in brackets after it, `3 (x, y, z)`; a factor has no letters, and a remark that leaves
/// a choice or takes back is none.
pub(crate) fn before_remark(text: &str) -> Option<&str> {
    let (before, remark) = text.strip_suffix(')')?.split_once(" (")?;
    let mut words = remark.split(|char: char| !char.is_alphabetic());
    let is_doubt = |word: &str| {
        [
            "or", "not", "oder", "maybe", "perhaps", "wrong", "if", "per", "each", "times",
        ]
        .contains(&vibank_source::lower(word).as_str())
    };
    let is_remark = remark.contains(char::is_alphabetic) && !words.any(is_doubt);
    (before.ends_with(|last: char| last.is_ascii_digit()) && is_remark).then_some(before)
}

/// The word for what is counted, after a number: `2 periods`.
pub(crate) fn counted(value: &str) -> Option<&str> {
    const WORDS: [&str; 16] = [
        "period",
        "periods",
        "oscillation",
        "oscillations",
        "vibrations",
        "swings",
        "times",
        "dof",
        "dofs",
        "degree of freedom",
        "degrees of freedom",
        "half-cycles",
        "half cycles",
        "modes",
        "coordinates",
        "positions",
    ];
    let word = value.trim_start_matches(|char: char| !char.is_alphabetic());
    WORDS
        .contains(&word.to_ascii_lowercase().as_str())
        .then_some(word)
}

/// Roots in other languages, before a bracket.
pub(crate) const ROOTS: &[&str] = &[
    "racine", "RACINE", "Racine", "wurzel", "WURZEL", "Wurzel", "raiz", "RAIZ", "raíz", "RAÍZ",
    "radq", "RADQ",
];

/// Calls of programs that stand for the number in their brackets.
pub(crate) const NUMBERS: &[&str] = &[
    "np.float64",
    "np.float32",
    "np.complex128",
    "numpy.float64",
    "float",
    "int",
    "print",
    "disp",
    "simplify",
    "Simplify",
    "FullSimplify",
    "evalf",
];

/// Calls of programs that stand for the list in their brackets.
pub(crate) const LISTS: &[&str] = &[
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
    "MatrixForm",
    "vec",
    "vector",
    "Vector",
    "col",
    "list",
    "List",
    "tuple",
];

/// Calls of programs that make an equation of their two arguments.
pub(crate) const EQUATIONS: &[&str] = &["Eq", "sp.Eq", "sympy.Eq", "Equal", "Equality"];

/// Words that join values, also where they are set as text within a formula.
pub(crate) const JOINING: &[&str] = &["and", "or", "et", "ou", "und", "oder", "in", "at", "cis"];

/// Words that join statements: before what a letter is, and before what follows.
pub(crate) const STATEMENTS: &[&str] = &[
    "with",
    "where",
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

/// Coordinates, and the letters of their rates with the order of each.
type CustomaryRates = (&'static [&'static str], &'static [(&'static str, u8)]);

/// Letters and words for the rates of positions: they are read wherever the item has no such letter.
pub(crate) const VELOCITIES: CustomaryRates = (
    &["x", "y", "z", "s", "u"],
    &[("v", 1), ("a", 2), ("vel", 1), ("accel", 2)],
);

/// Letters for the rates of other coordinates by the custom of the field. They mean other things, too, `ω` a natural
/// frequency: they are rates only where nothing else can be read.
pub(crate) const RATES: &[CustomaryRates] = &[
    (&["theta", "phi"], &[("omega", 1), ("alpha", 2)]),
    (&["q"], &[("i", 1)]),
];

/// Words before the option that is chosen.
pub(crate) const ANNOUNCEMENTS: &[&str] = &[
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

/// Words before a condition.
pub(crate) const CONDITIONS: &[&str] = &[
    "for",
    "if",
    "when",
    "whenever",
    "only if",
    "provided",
    "provided that",
    "as long as",
    "wenn",
    "falls",
];

/// Words before what says when or where an answer holds, `at x = 0`.
pub(crate) const CIRCUMSTANCES: &[&str] = &[
    "at", "for", "when", "whenever", "where", "if", "bei", "für", "wenn", "wo", "pour", "quand",
    "à", "en",
];

/// Words after a formula that say by what method it was found, or how far.
pub(crate) const METHODS: &[&str] = &[
    "lagrange",
    "newton",
    "d'alembert",
    "simplified",
    "linearized",
    "linearised",
    "vereinfacht",
    "linearisiert",
];

/// Words before what an answer comes from or holds for, `by Newton's law`, `for any angle`.
pub(crate) const SOURCES: &[&str] = &[
    "by",
    "using",
    "from",
    "via",
    "per",
    "valid",
    "according",
    "nach",
    "mit",
    "par",
    "d'après",
    "selon",
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

/// What comes after the one end of a range, and whether that is the upper one.
pub(crate) const ONWARDS: &[(&str, bool)] = &[
    (" or more", false),
    (" or greater", false),
    (" or larger", false),
    (" or above", false),
    (" or less", true),
    (" or smaller", true),
    (" or lower", true),
    (" or below", true),
];

/// Modules and objects of programs before the names of functions.
pub(crate) const MODULES: &[&str] = &[
    "np.linalg.",
    "np.",
    "numpy.",
    "math.",
    "cmath.",
    "Math.",
    "sp.",
    "sympy.",
    "sym.",
    "torch.",
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
