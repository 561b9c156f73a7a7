//! Words, remarks and reasons after an answer.

use super::before::is_of_motion;
use super::{behind_word, split_at_last};
use crate::counts::in_words;
use crate::letters::{combining, greek_word};
use crate::signs::{is_apostrophe, is_digit, is_digit_or_index, is_minus, is_of_word};
use crate::words::ALIASES;
use crate::words::{
    ASIDES, COUNTING, ENDS, OF_MINUS, REASONS, REMARKS, SEALS, TRAILS, TURNING, WORDS,
};
use vibank_formula::expr::Function;
use vibank_formula::unit::Unit;
use vibank_source::lower;

/// The length of words after an answer, of a remark in brackets, of a semicolon, or of a comma.
pub(crate) fn trail(text: &str) -> Option<usize> {
    // The sentence may end after them.
    let ended = text.strip_suffix('.').map(str::trim_end);
    let mut ends = std::iter::once(text).chain(ended);
    if let Some((own, words)) = ends.find_map(|own| Some((own, words_at_end(own)?))) {
        let before = &own[..own.len() - words.len()];
        let is_apart = before.ends_with([' ', ')', ']']) || words.starts_with(',');
        return is_apart.then(|| text.len() - before.len());
    }
    let ended = ended.unwrap_or(text);
    if let Some(before) = SEALS.iter().find_map(|seal| ended.strip_suffix(seal)) {
        return (!before.trim().is_empty()).then(|| text.len() - before.len());
    }
    // `…, where A and B are constants`
    if ended.ends_with("constants")
        && let Some((before, _)) = ended.split_once(" where ")
    {
        return (!before.trim().is_empty()).then(|| text.len() - before.len());
    }
    if let Some(at) = reason(text) {
        return Some(text.len() - at);
    }
    if let Some(length) = body(text).or_else(|| remark(text)) {
        return Some(length);
    }
    // A row of LaTeX that none follows.
    if text.ends_with("\\\\") {
        return Some(2);
    }
    if let Some(length) = comment(text) {
        return Some(length);
    }
    if let Some(length) = aside(text).or_else(|| precision(text)) {
        return Some(length);
    }
    if text.ends_with(">.") {
        return Some(1);
    }
    // Who asks whether it is right has answered.
    if let Some(before) = text.strip_suffix('?') {
        return ends_in_answer(before).then_some(1);
    }
    if let Some(before) = text.strip_suffix('!') {
        // `3!` is a factorial, and a power is none. The French set a space before the mark.
        let is_apart = before.ends_with([' ', '²', '³']) || before.ends_with("^2");
        let is_after = before
            .trim_end()
            .ends_with(|last: char| last.is_alphabetic() || is_apart);
        return is_after.then_some(1);
    }
    ends_in_answer(text.strip_suffix([';', ','])?).then_some(1)
}

/// The row of [`TRAILS`] in which a text ends.
fn words_at_end(text: &str) -> Option<&'static str> {
    // Most rows end otherwise.
    let last = text.as_bytes().last();
    let mut likely = TRAILS.iter().filter(|own| own.as_bytes().last() == last);
    likely.find(|own| text.ends_with(**own)).copied()
}

/// Whether a text ends in a sign in which an answer may end.
fn ends_in_answer(text: &str) -> bool {
    let text = text.trim_end();
    text.ends_with(|last: char| last.is_alphanumeric() || ")]}°%²³'".contains(last))
}

/// The length of a remark in brackets after an answer: `(3 s.f.)`, `(see above)`, and the `(1)` by which an equation is
/// numbered, which is the same as a factor.
fn aside(text: &str) -> Option<usize> {
    /// A shorter word may be a letter of a formula, and a unit.
    const MIN_LETTERS: usize = 4;
    let pairs = [(')', " ("), (']', " [")];
    let (before, aside) = pairs
        .iter()
        .find_map(|(close, open)| text.strip_suffix(*close)?.rsplit_once(open))?;
    let length = text.len() - before.len();
    if aside.starts_with("see ") || aside == "1" && before.contains('=') {
        return Some(length);
    }
    // `overdamped (ζ > 1)`
    let is_named = before
        .split(' ')
        .any(|word| word.chars().count() > MIN_LETTERS)
        && before
            .chars()
            .all(|char| char.is_alphabetic() || " -".contains(char));
    if is_named && aside.contains(['<', '>']) || is_unit_again(before, aside) {
        return Some(length);
    }
    let is_number = |word: &str| word.bytes().all(|byte| byte.is_ascii_digit());
    let is_said = |word: &str| {
        let word = word.trim_end_matches([',', ';', ':']);
        // `3sf`
        let unit = word.trim_start_matches(is_digit);
        is_number(word) || ASIDES.contains(&word) || ASIDES.contains(&unit)
    };
    // `12 (in)` has inches.
    let says_nothing = |word: &str| {
        let word = word.trim_end_matches([',', ';', ':']);
        is_number(word) || ["in", "to", "à"].contains(&word)
    };
    let mut words = aside.split_whitespace();
    if words.clone().all(is_said) && !words.clone().all(says_nothing) {
        return Some(length);
    }
    let is_word = |word: &str| {
        let word = word.trim_end_matches([',', ';', '.', '!', '?']);
        let mut chars = word.chars();
        word.starts_with(|first: char| first.is_alphabetic() || is_apostrophe(first))
            && chars.all(|own| is_of_word(own) || own == '_' || is_digit_or_index(own))
    };
    // `(sin θ - μ cos θ sign ẋ)` is a factor.
    let is_no_letter = |word: &str| {
        word.chars().filter(|char| char.is_alphabetic()).count() >= MIN_LETTERS
            && !is_of_formula(&lower(word))
            && Unit::read(word).is_err()
            && Unit::read(&lower(word)).is_err()
    };
    // One word alone may name an option, `underdamped (aperiodic)`; after a value it is a remark, `0.285 (underdamped)`,
    // unless it says of the value that it is another one, `20 mm (left)`.
    let value = before.rsplit('=').next().unwrap_or(before);
    let is_negative = value.trim_start().starts_with(is_minus);
    let is_alone = words.clone().count() == 1;
    let turns = |word: &str| {
        let word = lower(word.trim_end_matches([',', ';', '.', '!', '?']));
        let is_in = |words: &[&str]| words.contains(&word.as_str());
        let agrees = is_negative && is_in(OF_MINUS);
        is_in(TURNING) && !agrees || is_alone && is_in(COUNTING)
    };
    let is_remark = if ends_in_value(before) {
        !words.clone().any(turns)
    } else {
        !is_alone
    };
    // `(both included)` says of a range what belongs to it.
    let says_ends = ENDS.iter().any(|(own, _)| aside.ends_with(own));
    let are_words = !says_ends
        && is_remark
        && !words.clone().any(is_spoken_sign)
        && words.clone().all(is_word)
        && words.any(is_no_letter)
        && Unit::read(aside).is_err();
    are_words.then_some(length)
}

/// Whether a unit is the one in which a text ends, `0.7 s (seconds)`.
fn is_unit_again(before: &str, unit: &str) -> bool {
    let Ok(again) = Unit::read(unit) else {
        return false;
    };
    let words = before.match_indices(' ').map(|(at, _)| before[at..].trim());
    let mut units = words.filter_map(|own| Unit::read(own).ok());
    !again.is_one()
        && units.any(|own| {
            own.dimension() == again.dimension()
                && own.to_si(1.0) == again.to_si(1.0)
                && own.angles() == again.angles()
        })
}

/// Whether a text ends in a number, perhaps with a unit after a space.
fn ends_in_value(text: &str) -> bool {
    let is_number =
        |text: &str| text.ends_with(|last: char| last.is_ascii_digit() || "°%".contains(last));
    is_number(text)
        || text
            .rsplit_once(' ')
            .is_some_and(|(number, unit)| is_number(number.trim_end()) && Unit::read(unit).is_ok())
}

/// Whether a word of small letters is one of a formula: a letter by its name, a function of a letter, a letter with dots.
fn is_of_formula(word: &str) -> bool {
    // A letter with its index is longer, but then it is rarely written without a sign.
    const MAX_ARGUMENT: usize = 3;
    let is_letter = |word: &str| {
        let stem = word.strip_suffix("dot").unwrap_or(word);
        let stem = stem.strip_suffix('d').unwrap_or(stem);
        let is_dotted =
            stem.len() < word.len() || word.chars().any(|char| combining(char).is_some());
        greek_word(word).is_some()
            || greek_word(stem).is_some()
            || is_dotted && stem.len() <= MAX_ARGUMENT
    };
    let names = Function::all()
        .map(Function::name)
        .chain(ALIASES.iter().map(|(name, _)| *name));
    let mut arguments = names.filter_map(|name| word.strip_prefix(name));
    is_letter(word)
        || arguments.any(|own| {
            let count = own.chars().count();
            count < 2 || count <= MAX_ARGUMENT && !own.is_ascii() || is_letter(own)
        })
}

/// Whether a word stands for a sign in a formula, `(x double dot)`, `(k over m)`.
fn is_spoken_sign(word: &str) -> bool {
    const SIGNS: [&str; 6] = ["+", "-", "*", "/", "^2", "^3"];
    const OPERATIONS: [&str; 5] = ["double", "dot", "prime", "square", "root"];
    let word = lower(word);
    let mut signs = WORDS.iter().filter(|(own, _)| *own == word);
    OPERATIONS.contains(&word.as_str()) || signs.any(|(_, plain)| SIGNS.contains(plain))
}

/// The length of what says for which body an equation of motion holds: `… = 0 (block 1)`, `… = 0 for cart 1`,
/// `… = 0 (x to the right)`.
fn body(text: &str) -> Option<usize> {
    /// A shorter word may be a letter of a formula.
    const MIN_LETTERS: usize = 4;
    if !text.contains('=') {
        return None;
    }
    let (before, said) = text
        .strip_suffix(')')
        .and_then(|text| split_at_last(text, " ("))
        .or_else(|| split_at_last(text, " where "))
        .or_else(|| split_at_last(text, " for "))?;
    let is_long = |word: &str| {
        let word = word.trim_end_matches([',', ';', '.']);
        word.chars().count() >= MIN_LETTERS
            && word.chars().all(char::is_alphabetic)
            && greek_word(&lower(word)).is_none()
    };
    let mut words = said.split_whitespace();
    let is_said = words.clone().any(is_long)
        && !words.any(|word| is_spoken_sign(word) || is_of_formula(&lower(word)))
        && !said.contains(|char: char| "=+*/^()[]{}\\'".contains(char));
    (is_said && is_of_motion(before)).then(|| text.len() - before.len())
}

/// The length of a word that says what can be seen anyway, after a value, a list or an equation: `0 (translation)`,
/// `[1 2; 2 5] (symmetric)`, `(1, -1), in phase`.
fn remark(text: &str) -> Option<usize> {
    let in_brackets = |open: char, close: char| {
        let pair = text.strip_suffix(close)?.rsplit_once(open);
        // `0.4(dimensionless)`
        pair.filter(|(own, _)| own.ends_with(|last| is_digit(last) || " ~%°".contains(last)))
    };
    let (before, said) = in_brackets('(', ')')
        .or_else(|| in_brackets('[', ']'))
        .or_else(|| behind_list(text))
        .or_else(|| split_at_last(text, " → "))
        .or_else(|| split_at_last(text, " -> "))
        .or_else(|| split_at_last(text, " so "))
        .or_else(|| split_at_last(text, ", "))?;
    let first = before.chars().next()?;
    let begins = first.is_ascii_digit() || "([{.".contains(first) || is_minus(first);
    let is_value = begins || before.contains('=') || in_words(before).is_some();
    let is_said = REMARKS.contains(&lower(said.trim()).replace('~', " ").as_str());
    (is_value && is_said).then(|| text.len() - before.len())
}

/// A list and the words right after it, `(1, 1) translation`.
fn behind_list(text: &str) -> Option<(&str, &str)> {
    let end = text.rfind([')', ']'])? + 1;
    let said = text[end..].strip_prefix(' ')?;
    said.starts_with(char::is_alphabetic)
        .then(|| (&text[..end], said))
}

/// The length of what says to how many figures an answer is given: `to 3 s.f.`, `to 3 significant figures`.
fn precision(text: &str) -> Option<usize> {
    let (before, said) = split_at_last(text, " to ")?;
    let mut words = said.split_whitespace();
    let is_number = words
        .next()
        .is_some_and(|first| first.parse::<u8>().is_ok());
    let mut rest = words.peekable();
    let is_said = rest.peek().is_some() && rest.all(|word| ASIDES.contains(&word));
    (is_number && is_said).then(|| text.len() - before.len())
}

/// Where the reason begins that is given after an answer: `5 m, since k = 3 N/m`.
fn reason(text: &str) -> Option<usize> {
    text.match_indices(' ').find_map(|(at, _)| {
        let rest = &text[at + 1..];
        let mut reasons = REASONS.iter();
        let word = reasons.find(|word| behind_word(rest, word).is_some())?;
        let before = text[..at].trim_end();
        // Short words are letters elsewhere: `da` and `car` say why only after a comma.
        let is_apart = before.ends_with(',') || word.len() > 4;
        (is_apart && !before.trim_end_matches(',').is_empty()).then_some(at)
    })
}

/// The length of a comment of a program, `# checked`, `// by Newton`. One that is a unit or says where it is measured is
/// more than that, and `k1 // k2` are springs in parallel.
fn comment(text: &str) -> Option<usize> {
    /// Longer words are no symbols of units.
    const MAX_UNIT: usize = 5;
    // Most responses have neither sign, and a search for two letters takes longer than one for their bytes.
    if !text.bytes().any(|byte| b"#/".contains(&byte)) {
        return None;
    }
    let (before, comment) = text.split_once(" # ").or_else(|| text.split_once(" // "))?;
    // A word after `//` that is as short as a letter of a formula may be one.
    let word = comment.split([' ', ',', ':']).next().unwrap_or(comment);
    let is_word =
        word.starts_with(char::is_alphabetic) && (text.contains(" # ") || word.chars().count() > 2);
    let is_unit = comment.len() <= MAX_UNIT && Unit::read(comment).is_ok();
    (is_word && !is_unit && !before.trim().is_empty()).then(|| text.len() - before.len())
}
