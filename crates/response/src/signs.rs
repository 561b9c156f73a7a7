//! The one table of signs: each spelling that people type, and the sign that stands for it from here on.
//!
//! Nothing after [`Folded`](super::Folded) knows a second minus or another way to write "at most".
//! A new spelling is a row here.

/// What a spelling becomes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Plain {
    /// The spelling that everything after this table reads.
    Text(&'static str),
    /// Nothing: it has no width, or only sets the size of what follows.
    Nothing,
}

use Plain::{Nothing, Text};

/// Single characters.
pub(crate) fn of_char(char: char) -> Option<Plain> {
    Some(Text(match char {
        // Minus, with the dashes of word processors.
        '\u{2212}' | '\u{2010}'..='\u{2015}' | '\u{fe58}' | '\u{fe63}' | '\u{2796}' => "-",
        // Times.
        '·' | '×' | '⋅' | '∙' | '∗' | '•' | '⁎' | '✕' | '✖' | '⨯' => "*",
        // Divided by.
        '÷' | '∕' | '⁄' => "/",
        // Equal by definition; nearly equal.
        '≡' | '≔' | '≝' => "=",
        '∼' | '≃' | '≅' | '≐' | '≒' | '≑' | '⩰' => "≈",
        // At most, at least.
        '⩽' | '≦' => "≤",
        '⩾' | '≧' => "≥",
        // Union and intersection, or and and.
        '∨' | '⋃' | '⋁' => "∪",
        '∧' | '⋂' | '⋀' => "∩",
        // Degree.
        'º' | '˚' => "°",
        // Prime and its multiples, quotation marks as they are put for two.
        '’' | '′' | '´' | '`' | '‘' | 'ʹ' | 'ʼ' => "'",
        '″' | '“' | '”' => "\"",
        '‴' => "'''",
        // Dots that come after their letter.
        '¨' => "\u{308}",
        '˙' => "\u{307}",
        // Brackets, points, raising.
        // The brackets of word processors that are not shown.
        '⟨' | '〈' | '〖' => "(",
        '⟩' | '〉' | '〗' => ")",
        // Units that are one sign.
        '㎜' => "mm",
        '㎝' => "cm",
        '㎞' => "km",
        '㎎' => "mg",
        '㎏' => "kg",
        '㎳' => "ms",
        '㎧' => "m/s",
        '㎨' => "m/s^2",
        '㎐' => "Hz",
        '㎑' => "kHz",
        '㎒' => "MHz",
        '㎩' => "Pa",
        '㎪' => "kPa",
        '㎫' => "MPa",
        '㎬' => "GPa",
        '㎭' => "rad",
        '㎮' => "rad/s",
        '㎯' => "rad/s^2",
        '㎃' => "mA",
        '㏀' => "kΩ",
        '㎌' => "µF",
        // Brackets over several lines, as programs draw them.
        '⎡' | '⎛' => "[",
        '⎦' | '⎠' => "]",
        '⎢' | '⎣' | '⎜' | '⎝' | '⎤' | '⎥' | '⎞' | '⎟' => " ",
        // A matrix as word processors write it on one line.
        '■' | '█' => return Some(Nothing),
        '@' => ";",
        '∶' => ":",
        '、' => ",",
        'ˆ' => "^",
        '∣' => "|",
        // Letters.
        '\u{2126}' => "Ω",
        '\u{2206}' => "Δ",
        'ℎ' => "h",
        // With a line over it, as complex conjugates have.
        'Ā' => "A\u{304}",
        'ℜ' => "Re",
        'ℑ' => "Im",
        // With the signs that calculators set before an exponent.
        'ℯ' | 'ⅇ' | 'ᴇ' | '⏨' => "e",
        'ⅆ' => "d",
        'ⅅ' => "D",
        'ⅈ' => "i",
        'ⅉ' => "j",
        // Spaces within a line, invisible operators; others are ordinary ones by now.
        '\t' | '~' | '\u{2061}'..='\u{2064}' => " ",
        _ => return None,
    }))
}

/// Whether a sign is one of those that stand for a minus.
pub(crate) fn is_minus(char: char) -> bool {
    char == '-' || of_char(char) == Some(Text("-"))
}

/// Whether a sign is one of those that stand for a product.
pub(crate) fn is_times(char: char) -> bool {
    char == '*' || of_char(char) == Some(Text("*"))
}

/// Whether a character is a digit, `0` to `9`.
pub(crate) fn is_digit(char: char) -> bool {
    char.is_ascii_digit()
}

/// Whether a sign of one byte stands between two digits, as a decimal sign does.
pub(crate) fn is_between_digits(text: &str, at: usize) -> bool {
    text[..at].ends_with(is_digit) && text[at + 1..].starts_with(is_digit)
}

/// Whether a character is a digit or one of an index, `x₁`.
pub(crate) fn is_digit_or_index(char: char) -> bool {
    is_digit(char) || ('₀'..='₉').contains(&char)
}

/// Whether a character may stand in a name: a letter, a digit or `_`.
pub(crate) fn is_of_name(char: char) -> bool {
    char.is_alphanumeric() || char == '_'
}

/// Whether a character may stand in a word: a letter, a hyphen or an apostrophe.
pub(crate) fn is_of_word(char: char) -> bool {
    char.is_alphabetic() || char == '-' || is_apostrophe(char)
}

/// Whether a sign is one of those that stand for an apostrophe, as within `Newton's`.
pub(crate) fn is_apostrophe(char: char) -> bool {
    char == '\'' || of_char(char) == Some(Text("'"))
}

/// The signs after minutes and after seconds of an angle, the longer ones first, with how many make a degree.
pub(crate) const ANGLES: [(&[&str], u32); 2] = [
    (&["'", "′", "’"], 60),
    (&["''", "′′", "\"", "″", "”"], 3600),
];

/// Marks before the points of a list, and that of a prompt.
pub(crate) const BULLETS: &[&str] = &["* ", "• ", "· ", "‣ ", "◦ ", "▪ ", ">>> "];

/// The sign that is a decimal sign and nothing else.
pub(crate) const DECIMAL: char = '⎖';

/// The sign of a product of two integers that may be a decimal sign: `6·12`, as printed in Britain.
pub(crate) const MIDDLE_POINT: char = '‧';

/// Runs of signs, the longer ones before those with which they begin.
pub(crate) const RUNS: &[(&str, &str)] = &[
    ("==>", "="),
    ("=/=", "≠"),
    ("=\\=", "≠"),
    // A matrix of Maple after its name.
    ("=<<", "=<<"),
    ("<=", "≤"),
    ("< =", "≤"),
    ("> =", "≥"),
    ("=<", "≤"),
    (">=", "≥"),
    ("=>", "≥"),
    ("!=", "≠"),
    ("/=", "≠"),
    ("/_", "∠"),
    ("~=", "≈"),
    // Both signs, as keyboards have them.
    ("+/-", "±"),
    ("+-", "±"),
    ("+\u{2212}", "±"),
    ("-/+", "∓"),
    ("-+", "∓"),
    ("\u{2212}+", "∓"),
    // At most and nearly: whether the bound belongs to it is open.
    (">~", "≳"),
    ("~>", "≳"),
    ("<~", "≲"),
    ("~<", "≲"),
    ("==", "="),
    (":=", "="),
    ("**", "^"),
    ("&&", "∩"),
    // Raised and lowered signs of web pages.
    ("<sub>", "_{"),
    ("</sub>", "}"),
    ("<sup>", "^{"),
    ("</sup>", "}"),
    // Derivatives of Maple.
    ("t$2", "t,2"),
    ("(D@@2)", "ddot"),
    // And of Mathematica.
    ("Derivative[1]", "dot"),
    ("Derivative[2]", "ddot"),
    // The constants of Maxima.
    ("%pi", "pi"),
    ("%i", "i"),
    ("%e", "e"),
    // The decimal comma of LaTeX, which never parts thousands.
    ("{,}", "⎖"),
    ("×₁₀^", "e"),
    ("×₁₀", "e"),
];

/// The run of signs with which a text begins, and the sign that it is.
pub(crate) fn run_at(text: &str) -> Option<(&'static str, &'static str)> {
    const FIRST: [u128; 2] = ends_of_runs(false);
    let first = *text.as_bytes().first()?;
    if !has(FIRST, first) {
        return None;
    }
    let mut likely = RUNS.iter().filter(|(run, _)| run.as_bytes()[0] == first);
    likely.find(|(run, _)| text.starts_with(run)).copied()
}

/// Whether a sign behind a text makes a run with its end.
pub(crate) fn would_run(text: &str, sign: &str) -> bool {
    const LAST: [u128; 2] = ends_of_runs(true);
    let last = sign.as_bytes().last();
    let makes = |run: &str| {
        let before = run.strip_suffix(sign).unwrap_or_default();
        !before.is_empty() && text.ends_with(before)
    };
    last.is_some_and(|last| has(LAST, *last))
        && RUNS
            .iter()
            .any(|(run, _)| run.as_bytes().last() == last && makes(run))
}

/// A bit for each byte with which a run begins, or ends.
// Made of the table when the program is compiled, so that a new run needs no second list: most signs are in none, and each
// one of a response is asked.
const fn ends_of_runs(is_last: bool) -> [u128; 2] {
    let (mut bits, mut at) = ([0, 0], 0);
    while at < RUNS.len() {
        let run = RUNS[at].0.as_bytes();
        let byte = run[if is_last { run.len() - 1 } else { 0 }];
        bits[(byte >> 7) as usize] |= 1 << (byte & 127);
        at += 1;
    }
    bits
}

/// Whether the bit of a byte is set.
fn has(bits: [u128; 2], byte: u8) -> bool {
    bits[usize::from(byte >> 7)] >> (byte & 127) & 1 == 1
}

/// Quotation marks and other pairs that people set around a whole answer.
pub(crate) const QUOTES: &[(&str, &str)] = &[
    ("\"", "\""),
    ("'", "'"),
    ("′", "′"),
    ("`", "`"),
    ("“", "”"),
    ("„", "“"),
    ("‘", "’"),
    ("«", "»"),
    ("**", "**"),
    ("$", "$"),
    ("\\(", "\\)"),
    ("\\[", "\\]"),
];

/// Commands of LaTeX, by their name. What is not listed is a name, a function, or is read by the grammar.
pub(crate) const COMMANDS: &[(&str, Plain)] = &[
    ("cdot", Text("*")),
    ("times", Text("*")),
    ("ast", Text("*")),
    ("div", Text("/")),
    ("le", Text("≤")),
    ("leq", Text("≤")),
    ("leqslant", Text("≤")),
    ("ge", Text("≥")),
    ("geq", Text("≥")),
    ("geqslant", Text("≥")),
    ("lt", Text("<")),
    ("gt", Text(">")),
    ("ne", Text("≠")),
    ("neq", Text("≠")),
    ("gtrsim", Text("≳")),
    ("lesssim", Text("≲")),
    // What is denied comes after it, `\not=`, `\not\ge`: never the same without it.
    ("not", Text("≠")),
    ("approx", Text("≈")),
    ("simeq", Text("≈")),
    ("cong", Text("≈")),
    ("doteq", Text("≈")),
    ("equiv", Text("=")),
    ("coloneqq", Text("=")),
    ("pm", Text("±")),
    ("mp", Text("∓")),
    ("cup", Text("∪")),
    ("lor", Text("∪")),
    ("vee", Text("∪")),
    ("cap", Text("∩")),
    ("land", Text("∩")),
    ("wedge", Text("∩")),
    ("propto", Text("∝")),
    ("in", Text("∈")),
    ("infty", Text("∞")),
    ("circ", Text("°")),
    ("degree", Text("°")),
    ("angle", Text("∠")),
    ("lvert", Text("|")),
    ("rvert", Text("|")),
    ("vert", Text("|")),
    ("mid", Text("|")),
    ("langle", Text("(")),
    ("rangle", Text(")")),
    ("lbrace", Text("{")),
    ("rbrace", Text("}")),
    ("lbrack", Text("[")),
    ("rbrack", Text("]")),
    ("Re", Text("Re")),
    ("Im", Text("Im")),
    ("quad", Text(" ")),
    ("qquad", Text(" ")),
    ("dfrac", Text("\\frac")),
    ("tfrac", Text("\\frac")),
    ("dbinom", Text("\\binom")),
    ("tbinom", Text("\\binom")),
    ("cfrac", Text("\\frac")),
    ("nicefrac", Text("\\frac")),
    ("sfrac", Text("\\frac")),
    ("textrm", Text("\\mathrm")),
    ("mathsf", Text("\\mathrm")),
    ("textsf", Text("\\mathrm")),
    ("textbf", Text("\\mathrm")),
    ("textit", Text("\\mathrm")),
    ("textup", Text("\\mathrm")),
    ("mbox", Text("\\mathrm")),
    ("left", Nothing),
    ("right", Nothing),
    ("big", Nothing),
    ("Big", Nothing),
    ("bigg", Nothing),
    ("Bigg", Nothing),
    ("bigl", Nothing),
    ("bigr", Nothing),
    ("Bigl", Nothing),
    ("Bigr", Nothing),
    ("displaystyle", Nothing),
    ("textstyle", Nothing),
    ("limits", Nothing),
    ("hline", Nothing),
    ("enspace", Text(" ")),
    ("thinspace", Text(" ")),
    ("notag", Nothing),
    ("nonumber", Nothing),
    ("checkmark", Nothing),
    ("centering", Nothing),
    ("boxed", Nothing),
    ("fbox", Nothing),
    ("SI", Nothing),
    ("qty", Nothing),
    ("si", Nothing),
    ("unit", Nothing),
    ("num", Nothing),
];

/// Units as the package siunitx has them. A prefix belongs to what follows, a unit ends with a space.
pub(crate) const UNITS: &[(&str, &str)] = &[
    ("per", "/"),
    ("squared", "^2 "),
    ("cubed", "^3 "),
    ("square", "square "),
    ("cubic", "cubic "),
    ("giga", "giga"),
    ("mega", "mega"),
    ("kilo", "kilo"),
    ("hecto", "hecto"),
    ("deci", "deci"),
    ("centi", "centi"),
    ("milli", "milli"),
    ("micro", "micro"),
    ("nano", "nano"),
    ("metre", "metre "),
    ("meter", "metre "),
    ("second", "second "),
    ("minute", "minute "),
    ("hour", "hour "),
    ("gram", "gram "),
    ("kilogram", "kilogram "),
    ("newton", "newton "),
    ("joule", "joule "),
    ("watt", "watt "),
    ("pascal", "pascal "),
    ("hertz", "hertz "),
    ("radian", "radian "),
    ("kelvin", "kelvin "),
    ("volt", "volt "),
    ("ampere", "ampere "),
    ("coulomb", "coulomb "),
    ("farad", "farad "),
    ("henry", "henry "),
    ("tesla", "tesla "),
    ("ohm", "ohm "),
    ("percent", "%"),
    ("mm", "mm "),
    ("cm", "cm "),
    ("kg", "kg "),
    ("Hz", "Hz "),
];

/// Environments that only set formulas off; their rows are statements.
pub(crate) const DISPLAYS: &[&str] = &[
    "equation",
    "align",
    "aligned",
    "alignat",
    "gather",
    "gathered",
    "split",
    "multline",
    "eqnarray",
    "displaymath",
    "math",
];

/// Environments whose rows are statements, each perhaps with its condition after a sign of alignment.
pub(crate) const CASES: &[&str] = &["cases", "dcases", "rcases"];

/// Commands whose arguments stand for themselves: their braces are spaces. With how many there are.
pub(crate) const WRAPPERS: &[(&str, usize)] = &[
    ("boxed", 1),
    ("fbox", 1),
    ("SI", 2),
    ("qty", 2),
    ("si", 1),
    ("unit", 1),
    ("num", 1),
    ("ensuremath", 1),
];

/// Commands whose argument says nothing of the answer: numbers and names of equations.
pub(crate) const NUMBERED: &[&str] = &["tag", "label", "vspace", "hspace"];

/// Commands that set the face of letters: around digits or nothing their braces are spaces, too.
pub(crate) const FACES: &[&str] = &[
    "mathrm",
    "mathbf",
    "mathsf",
    "text",
    "textrm",
    "textbf",
    "textit",
    "boldsymbol",
    "underline",
    "underbrace",
];

/// Units that are read only with what comes after them, since their first letter means other things alone.
pub(crate) const TURNS: &[(&str, &str)] = &[("U/min", "rev/min"), ("r/min", "rev/min")];

/// A backslash before a sign.
pub(crate) fn escaped(char: char) -> Option<Plain> {
    Some(Text(match char {
        ',' | ';' | ':' | ' ' => " ",
        '!' => return Some(Nothing),
        '{' => "{",
        '}' => "}",
        '|' => "|",
        '%' => "%",
        '_' => "_",
        _ => return None,
    }))
}
