//! Names of functions beside those of item files, and operations in words.

use vibank_formula::expr::Function;

/// The functions that people type under other names than files do.
pub(crate) const ALIASES: &[(&str, Function)] = &[
    ("arcsin", Function::Asin),
    ("arccos", Function::Acos),
    ("arctan", Function::Atan),
    ("arctg", Function::Atan),
    ("arctan2", Function::Atan2),
    ("Arctan2", Function::Atan2),
    ("ArcTan2", Function::Atan2),
    ("ATAN2", Function::Atan2),
    ("arctg2", Function::Atan2),
    ("Arctan", Function::Atan),
    ("ArcTan", Function::Atan),
    ("ARCTAN", Function::Atan),
    ("ARCSIN", Function::Asin),
    ("ARCCOS", Function::Acos),
    ("ATAN", Function::Atan),
    ("ASIN", Function::Asin),
    ("ACOS", Function::Acos),
    ("ArcSin", Function::Asin),
    ("ArcCos", Function::Acos),
    ("invsin", Function::Asin),
    ("invcos", Function::Acos),
    ("invtan", Function::Atan),
    ("fabs", Function::Abs),
    ("Abs", Function::Abs),
    ("ABS", Function::Abs),
    ("tg", Function::Tan),
    ("sen", Function::Sin),
    ("arsinh", Function::Asinh),
    ("arcosh", Function::Acosh),
    ("artanh", Function::Atanh),
    ("sgn", Function::Sign),
    ("signum", Function::Sign),
    // French and German.
    ("racine", Function::Sqrt),
    ("Racine", Function::Sqrt),
    ("Wurzel", Function::Sqrt),
    ("wurzel", Function::Sqrt),
    ("Re", Function::Re),
    ("Im", Function::Im),
    ("real", Function::Re),
    ("imag", Function::Im),
];

/// Powers that are written as functions.
pub(crate) const POWERS: &[(&str, Powered)] = &[
    ("pow", Powered::Any),
    ("power", Powered::Any),
    ("Power", Powered::Any),
    ("POWER", Powered::Any),
    ("POTENZ", Powered::Any),
    ("PUISSANCE", Powered::Any),
    ("POTENCIA", Powered::Any),
    ("POTENZA", Powered::Any),
    ("Rational", Powered::Quotient),
    ("Fraction", Powered::Quotient),
    ("cbrt", Powered::CubeRoot),
    ("root", Powered::Root),
    ("nroot", Powered::Root),
    ("nthroot", Powered::Root),
    ("complex", Powered::Complex),
    ("Complex", Powered::Complex),
    ("polar", Powered::Polar),
    ("rect", Powered::Polar),
    ("surd", Powered::Root),
    ("Surd", Powered::Root),
];

/// A power that is written as a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Powered {
    /// `pow(base, exponent)`.
    Any,
    /// `cbrt(base)`.
    CubeRoot,
    /// `root(base)`, `nthroot(base, degree)`.
    Root,
    /// `complex(real, imaginary)`, which is not a power.
    Complex,
    /// `polar(modulus, angle)`.
    Polar,
    /// `Rational(1, 2)`.
    Quotient,
}

/// Functions that can stand within a run of letters, without a bracket after them.
pub(crate) const BARE: &[Function] = &[
    Function::Sin,
    Function::Cos,
    Function::Tan,
    Function::Asin,
    Function::Acos,
    Function::Atan,
    Function::Sinh,
    Function::Cosh,
    Function::Tanh,
    Function::Asinh,
    Function::Acosh,
    Function::Atanh,
    Function::Exp,
    Function::Ln,
    Function::Log10,
    Function::Sqrt,
    Function::Sign,
];

/// Roots in other languages, before a bracket.
pub(crate) const ROOTS: &[&str] = &[
    "racine", "RACINE", "Racine", "wurzel", "WURZEL", "Wurzel", "raiz", "RAIZ", "raíz", "RAÍZ",
    "radq", "RADQ",
];

/// Roots in words, the longer ones before those with which they begin.
pub(crate) const SPOKEN_ROOTS: &[&str] = &[
    "the square root of",
    "square root of",
    "square root",
    "the root of",
    "root of",
    "sqrt of",
    "root",
    "la racine carrée de",
    "la racine de",
    "racine carrée de",
    "racine de",
    "Wurzel aus",
    "Wurzel von",
];

/// Functions in words before a bracket.
pub(crate) const FUNCTIONS: &[(&str, &str)] = &[
    ("sin of", "sin"),
    ("sine of", "sin"),
    ("the sine of", "sin"),
    ("cos of", "cos"),
    ("cosine of", "cos"),
    ("the cosine of", "cos"),
    ("tan of", "tan"),
    ("tangent of", "tan"),
    ("arctan of", "arctan"),
    ("arctangent of", "arctan"),
    ("exp of", "exp"),
    ("ln of", "ln"),
];

/// Rates in words after their letter.
pub(crate) const RATES_IN_WORDS: &[(&str, &str)] = &[
    ("double dot", "''"),
    ("double-dot", "''"),
    ("dot dot", "''"),
    ("double prime", "''"),
    ("dot", "'"),
    ("prime", "'"),
];

/// What stands for infinity, in words.
pub(crate) const INFINITY: &[&str] = &[
    "inf",
    "Inf",
    "INF",
    "infinity",
    "Infinity",
    "infini",
    "infinito",
    "unendlich",
    "oo",
    "infty",
];

/// Whether a word is a function, also one that files do not have.
pub(crate) fn is_function(word: &str) -> bool {
    Function::of_name(word).is_some()
        || ALIASES.iter().any(|(alias, _)| *alias == word)
        || POWERS.iter().any(|(name, _)| *name == word)
}
