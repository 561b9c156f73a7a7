//! The words of a language for formulas that are heard.

/// What a formula is read aloud with; [`Voice::ENGLISH`] belongs to the crate, others are made by those who speak them.
///
/// Of two words the first is said before what they belong to, the second after it; one that is empty is left out.
#[derive(Debug)]
pub struct Voice {
    /// Before a negative number.
    pub minus: &'static str,
    /// Around a capital letter.
    pub capital: [&'static str; 2],
    /// Around a bold letter.
    pub bold: [&'static str; 2],
    /// Around a letter of a script.
    pub script: [&'static str; 2],
    /// Around a double-struck letter.
    pub double: [&'static str; 2],
    /// Around what stands under a square root.
    pub root: [&'static str; 2],
    /// Around the degree of another root, which [`root`](Self::root) ends.
    pub degree: [&'static str; 2],
    /// Around a fraction of more than two signs.
    pub fraction: [&'static str; 2],
    /// Between numerator and denominator.
    pub over: &'static str,
    /// Between two lines without a bar.
    pub above: &'static str,
    /// Around a subscript; a single sign needs no end.
    pub sub: [&'static str; 2],
    /// Around an exponent; a single sign needs no end.
    pub power: [&'static str; 2],
    /// The exponent 2.
    pub squared: &'static str,
    /// The exponent 3.
    pub cubed: &'static str,
    /// The mark of a derivative.
    pub prime: &'static str,
    /// The mark of degrees.
    pub degrees: &'static str,
    /// A star as superscript.
    pub star: &'static str,
    /// Accents: one, two and three dots, hat, tilde, bar, arrow.
    pub accents: [&'static str; 7],
    /// A hole without a filling.
    pub blank: &'static str,
    /// After the sign and the bounds of a sum or integral.
    pub of: &'static str,
    /// Before the lower and the upper bound.
    pub bounds: [&'static str; 2],
    /// A large sign that has no name.
    pub operator: &'static str,
    /// Around what stands below something.
    pub with: [&'static str; 2],
    /// Before what stands above something.
    pub under: &'static str,
    /// A brace below or above something.
    pub brace: &'static str,
    /// Before the matrix of a determinant.
    pub determinant: &'static str,
    /// Around what an absolute value is taken of.
    pub absolute: [&'static str; 2],
    /// Begin of a matrix, before the number of each row, end.
    pub matrix: [&'static str; 3],
    /// The same of cases.
    pub cases: [&'static str; 3],
    /// Before the number of each of several lines.
    pub line: &'static str,
    /// Before a unit that divides.
    pub per: &'static str,
    /// The exponent 1/2 of a unit.
    pub half: &'static str,
    /// The name of a sign, given the English one.
    pub sign: fn(&'static str) -> &'static str,
    /// The name of a Greek letter, given that of its command, such as `omega` and `Omega`.
    pub letter: fn(&'static str) -> &'static str,
    /// The words before the argument of a function, given its name, such as `sin`; none for one that is said as it is.
    pub function: fn(&str) -> Option<&'static str>,
    /// The name of a unit or prefix in this language.
    pub unit: fn(UnitName) -> &'static str,
}

/// The name of a unit or prefix in each language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UnitName {
    /// For one or for several.
    pub english: &'static str,
    /// In the singular.
    pub french: &'static str,
}

impl Voice {
    /// The words of English.
    pub const ENGLISH: &'static Self = &Self {
        minus: "minus",
        capital: ["capital", ""],
        bold: ["bold", ""],
        script: ["script", ""],
        double: ["double-struck", ""],
        root: ["the square root of", "end root"],
        degree: ["the root of degree", "of"],
        fraction: ["the fraction", "end fraction"],
        over: "over",
        above: "above",
        sub: ["sub", "end sub"],
        power: ["to the power", "end power"],
        squared: "squared",
        cubed: "cubed",
        prime: "prime",
        degrees: "degrees",
        star: "star",
        accents: [
            "dot",
            "double dot",
            "triple dot",
            "hat",
            "tilde",
            "bar",
            "vector",
        ],
        blank: "blank",
        of: "of",
        bounds: ["from", "to"],
        operator: "the operator",
        with: ["with", "below"],
        under: "under",
        brace: "in a brace",
        determinant: "the determinant of",
        absolute: ["the absolute value of", "end absolute value"],
        matrix: ["the matrix with", "row", "end matrix"],
        cases: ["the cases", "case", "end cases"],
        line: "line",
        per: "per",
        half: "one half",
        sign: |words| words,
        letter: |name| name,
        function: english_function,
        unit: |name| name.english,
    };
}

fn english_function(name: &str) -> Option<&'static str> {
    Some(match name {
        "sin" => "sine",
        "cos" => "cosine",
        "tan" => "tangent",
        "exp" => "the exponential of",
        "ln" => "the natural logarithm of",
        "log" => "the logarithm of",
        "arctan" => "the arc tangent of",
        "arcsin" => "the arc sine of",
        "arccos" => "the arc cosine of",
        "sinh" => "the hyperbolic sine of",
        "cosh" => "the hyperbolic cosine of",
        "tanh" => "the hyperbolic tangent of",
        "lim" => "the limit",
        "max" => "the maximum",
        "min" => "the minimum",
        "det" => "the determinant of",
        "arg" => "the argument of",
        _ => return None,
    })
}
