//! How a name is spelled in letters, beside its own spelling: in letters that look like its own, in the other case, with
//! its dots as words.

use super::letters::{Letters, combining, dotted, greek_word};
use super::signs::is_digit;
use vibank_formula::expr::Name;
use vibank_notation::{Math, symbol};

/// Greek letters as people shorten them, or with the letter that looks alike or that other books have; the likelier ones
/// first.
const SHORTENED: [(&str, &str); 8] = [
    ("omega", "w"),
    ("omega", "om"),
    ("Omega", "Om"),
    ("zeta", "xi"),
    ("theta", "th"),
    ("theta", "teta"),
    ("theta", "thetha"),
    ("epsilon", "eps"),
];

/// A Greek letter shortened, `w0` for ω₀ and `th1` for θ₁.
pub(crate) fn shortened(spelling: &str) -> impl Iterator<Item = String> {
    let all = SHORTENED.iter();
    all.filter_map(move |(letter, short)| {
        let rest = spelling.strip_prefix(letter)?;
        Some(format!("{short}{rest}"))
    })
}

/// The other spellings of a name, of which `own` is the spelling, by its symbol; the likelier ones first.
pub(crate) fn others(name: &Name, own: &str, math: &Math) -> impl Iterator<Item = String> {
    let printed = Letters::spelling(&math.plain());
    let usual = Letters::spelling(&symbol(name.as_str()).plain());
    let lambda = (name.as_str() == "lam").then(|| "lambda".to_owned());
    // As often misspelled as not.
    let is_lambda = own.starts_with("lam");
    let misspelled =
        is_lambda.then(|| own.replacen("lambda", "lam", 1).replacen("lam", "lamda", 1));
    // `varepsilon` without its backslash.
    let varied = printed.as_deref().filter(|printed| {
        let mut varied = ["epsilon", "phi", "theta", "rho"].iter();
        varied.any(|letter| printed.starts_with(letter))
    });
    let varied = varied.map(|printed| format!("var{printed}"));
    // `Dm` and `delta_m` for Δm.
    let difference = |letter: &str| {
        let rest = printed.as_deref()?.strip_prefix("Delta")?;
        Some(format!("{letter}{rest}"))
    };
    let spellings = [
        usual,
        lambda,
        misspelled,
        in_ells(own, printed.as_deref()),
        varied,
        difference("D"),
        difference("delta"),
        turned(own),
    ];
    let short = [Some(own), printed.as_deref()].into_iter().flatten();
    let short: Vec<String> = short.flat_map(shortened).collect();
    let others = [printed].into_iter().chain(spellings);
    others
        .flatten()
        .chain(short)
        .filter(move |spelling| spelling != own)
}

/// `l1` for a letter that is printed ℓ₁, and `\ell` for one that is printed l or L.
fn in_ells(own: &str, printed: Option<&str>) -> Option<String> {
    if let Some(rest) = printed.and_then(|printed| printed.strip_prefix("ell")) {
        return Some(format!("l{rest}"));
    }
    let index = own.strip_prefix(['l', 'L'])?;
    let is_index = index.bytes().all(|byte| byte.is_ascii_digit());
    is_index.then(|| format!("ell{index}"))
}

/// `EA` for AE, two letters that are one name.
fn turned(own: &str) -> Option<String> {
    match own.as_bytes() {
        [a, b] if a.is_ascii_uppercase() && b.is_ascii_uppercase() => {
            Some([*b, *a].map(char::from).into_iter().collect())
        }
        _ => None,
    }
}

/// `M` for m and `k1` for K₁, as telephones and shouting have them. The time, the constants, and the Greek letters whose
/// capitals mean something else have no other case.
pub(crate) fn in_other_case(spelling: &str) -> Option<String> {
    const OWN_SENSE: [char; 8] = ['t', 'T', 'e', 'E', 'i', 'I', 'j', 'J'];
    // Capitals that mean something else in this field, and those of the constants.
    const OTHERS: [&str; 7] = ["omega", "delta", "Delta", "sigma", "Sigma", "gamma", "pi"];
    let mut chars = spelling.chars();
    let first = chars.next().unwrap_or_default();
    let (stem, _) = stem_and_index(spelling);
    let is_greek = greek_word(stem).is_some() && !OTHERS.contains(&stem);
    if !is_greek && (OWN_SENSE.contains(&first) || !chars.all(is_digit)) {
        return None;
    }
    with_other_case(spelling)
}

/// A text whose first letter has the other case; none where it is not an ASCII letter.
pub(crate) fn with_other_case(text: &str) -> Option<String> {
    let mut chars = text.chars();
    let first = chars.next().filter(char::is_ascii_alphabetic)?;
    let other = if first.is_ascii_uppercase() {
        first.to_ascii_lowercase()
    } else {
        first.to_ascii_uppercase()
    };
    Some(format!("{other}{}", chars.as_str()))
}

/// Whether the letter at a place may be a small one that was typed as a capital: telephones begin with a capital, and some
/// type in capitals throughout.
pub(crate) fn may_be_small(text: &str, at: usize) -> bool {
    let capitals = text.bytes().filter(u8::is_ascii_uppercase);
    text[at..].starts_with(char::is_uppercase)
        && (!text[..at].contains(char::is_alphabetic)
            || capitals.count() > 1 && !text.contains(|char: char| char.is_ascii_lowercase()))
}

/// A spelling without the digits at its end, and these.
fn stem_and_index(spelling: &str) -> (&str, &str) {
    let stem = spelling.trim_end_matches(is_digit);
    spelling.split_at(stem.len())
}

/// A letter with its dots as words: `xdot`, `ddotx`, and with a subscript `xdot1`.
pub(crate) fn rates(spelling: &str, order: u8) -> Vec<String> {
    let (stem, digits) = stem_and_index(spelling);
    let dots: &[&str] = match order {
        1 => &["dot"],
        2 => &["ddot", "dotdot"],
        _ => &[],
    };
    let mut words = Vec::new();
    for dots in dots {
        words.extend([format!("{spelling}{dots}"), format!("{dots}{spelling}")]);
        words.extend((!digits.is_empty()).then(|| format!("{stem}{dots}{digits}")));
    }
    words
}

/// The first rate as programs call it, `xd`, `x1d` and `xd1`; they mean products, too, where d is a name.
pub(crate) fn first_rates(spelling: &str) -> [String; 2] {
    let (stem, digits) = stem_and_index(spelling);
    [format!("{spelling}d"), format!("{stem}d{digits}")]
}

/// The second rate as people call it in programs: `ddx1`, `xdd1`, `x1dd`, `D2x1`, `x1pp`. Of the first one, `dx` and `xp`
/// mean other things, too.
pub(crate) fn second_rates(spelling: &str) -> [String; 8] {
    let (stem, digits) = stem_and_index(spelling);
    [
        format!("dd{spelling}"),
        format!("D2{spelling}"),
        format!("d2{spelling}"),
        format!("{spelling}dd"),
        format!("{spelling}pp"),
        format!("{stem}dd{digits}"),
        format!("{stem}pp{digits}"),
        format!("d2{spelling}dt2"),
    ]
}

/// The spelling of a symbol with dots over its letter, and how many.
pub(crate) fn undotted(symbol: &str) -> Option<(String, u8)> {
    let (mut plain, mut order) = (String::new(), 0);
    for char in symbol.chars() {
        if let Some(dots) = combining(char) {
            order = dots;
            continue;
        }
        let (char, dots) = dotted(char).unwrap_or((char, 0));
        order = order.max(dots);
        plain.push(char);
    }
    (order > 0).then_some((Letters::spelling(&plain)?, order))
}
