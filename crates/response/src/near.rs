//! Words of a response that are next to those that are known: slips of names, functions with a number after them.

use super::signs::is_digit;
use super::words::{ALIASES, BARE};
use vibank_formula::expr::Function;

/// The symbol of a name, of those that are allowed, that a word may be a slip of. One letter may only be of the wrong case; a digit after a
/// letter may have lost the sign of a power.
pub(crate) fn nearest(allowed: &[String], word: &str) -> Option<String> {
    let allowed = || allowed.iter().map(String::as_str);
    if let Some(same) = allowed().find(|name| name.eq_ignore_ascii_case(word)) {
        return Some(same.to_owned());
    }
    if let Some((letter, power)) = word.split_at_checked(1)
        && matches!(power, "2" | "3" | "4")
        && allowed().any(|name| name == letter)
    {
        return Some(format!("{letter}^{power}"));
    }
    // Nobody types `L1` for `m1`: of a letter with an index the letter is no slip.
    let letter = |name: &str| {
        let stem = name.trim_end_matches(is_digit);
        let is_indexed = stem.len() < name.len() && stem.chars().nth(1).is_none();
        is_indexed.then(|| vibank_source::lower(stem))
    };
    let longer = allowed().filter(|name| name.chars().nth(1).is_some());
    let longer = longer.filter(|name| {
        let pair = letter(word).zip(letter(name));
        pair.is_none_or(|(own, other)| own == other)
    });
    let is_word = word.chars().nth(1).is_some();
    let found = is_word
        .then(|| vibank_source::nearest(word, longer))
        .flatten();
    found.map(str::to_owned)
}

/// Whether a run of letters ends with a function for which a number after it is the argument, `sin2θ`.
pub(crate) fn ends_with_function(run: &str, number: &str) -> bool {
    let bare = BARE.iter().map(|function| function.name());
    let aliases = ALIASES.iter().filter(|(_, own)| BARE.contains(own));
    let names = bare.chain(aliases.map(|(alias, _)| *alias));
    names.filter(|name| run.ends_with(name)).any(|function| {
        let whole = format!("{function}{number}");
        Function::of_name(&whole).is_none() && ALIASES.iter().all(|(alias, _)| *alias != whole)
    })
}

/// A symbol as it is typed: `k2` for k₂.
pub(crate) fn typable(symbol: &str) -> String {
    let chars = symbol.chars().map(|char| match char {
        '₀'..='₉' => char::from(b'0' + (u32::from(char) - u32::from('₀')) as u8),
        char => char,
    });
    chars.collect()
}
