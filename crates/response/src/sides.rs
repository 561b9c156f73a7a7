//! What stands around the equals signs of a formula: the symbol that is asked, and what it is.

use super::arguments::without_arguments;
use super::differential::{is_quotient, leibniz};
use super::letters::{greek_word, is_dotted};
use super::lexer::tokens;
use super::list::trimmed;
use super::signs::{is_apostrophe, is_of_word};
use super::token::{Item, Token};
use super::words::OTHER_VALUES;
use super::{Lexicon, Manner, Trouble, TypedError};
use vibank_formula::expr::Function;
use vibank_source::{Span, lower};

/// What a text says that its symbol is: each side of the equals signs but the symbol, the last one last.
///
/// # Errors
///
/// Where more than a symbol stands on the left: `ω0² = k/m` is true, but no formula for ω0.
pub(crate) fn sides(text: &str, lexicon: &Lexicon) -> Result<Vec<Span>, TypedError> {
    let mut sides = cut_at_equals(text);
    if let Some(end) = label(text, lexicon) {
        sides = cut_at_equals(&text[end..])
            .into_iter()
            .map(|side| Span::new(end + side.range().start, end + side.range().end))
            .collect();
    }
    let last = sides.pop().unwrap_or(Span::new(0, text.len()));
    sides.retain(|side| !text[side.range()].is_empty());
    let of = |side: &Span| symbol(&text[side.range()], lexicon);
    match sides.first().map(of) {
        None => {}
        Some(Some(_)) => {
            sides.remove(0);
        }
        Some(None) if sides.len() == 1 && of(&last) == Some(Symbol::Asked) => return Ok(sides),
        Some(None) => {
            let range = sides[0].range();
            return Err(TypedError::new(Trouble::Unsolved, range.start, range.end));
        }
    }
    sides.push(last);
    Ok(sides)
}

/// Where a symbol ends with its colon, `T: m v²/2`. A letter of which the answer may be made is divided where the space
/// after the colon is missing or stands before it, too, `M:l`, `M : l`.
fn label(text: &str, lexicon: &Lexicon) -> Option<usize> {
    let at = text.find(':')?;
    let (before, behind) = (&text[..at], &text[at + 1..]);
    if behind.starts_with('=') || before.contains(['=', '≈']) {
        return None;
    }
    let is_name = !before.ends_with(' ') && behind.starts_with(' ');
    let symbol = symbol(before.trim(), lexicon)?;
    (symbol == Symbol::Asked || is_name).then_some(at + 1)
}

/// What comes after words that describe what is asked, `the natural frequency ω`, `the amplitude`; nothing where there
/// are none, or where they say that it is another value, `half the period`.
pub(crate) fn described(text: &str) -> Option<&str> {
    /// Shorter words may be products of letters.
    const MIN_LETTERS: usize = 4;
    const SMALL: [&str; 27] = [
        "the", "of", "a", "an", "for", "its", "our", "at", "in", "on", "to", "my", "la", "le",
        "les", "de", "du", "des", "die", "der", "das", "el", "los", "las", "il", "lo", "un",
    ];
    /// One word alone may be a symbol with its index, `xmax`.
    const MIN_LETTERS_ALONE: usize = 6;
    let (mut rest, mut count, mut longest) = (text.trim(), 0, 0);
    while let Some(word) = rest.split_whitespace().next() {
        let lower = lower(word);
        // `three times the period`; after a number it only counts.
        if OTHER_VALUES.contains(&lower.as_str()) || lower == "times" {
            return None;
        }
        // `tany`, `xdot`, `thetadot`, `omegan`
        let functions = Function::all().filter(|own| lower.starts_with(own.name()));
        let is_symbol = lower.ends_with("dot")
            || greek_prefix(&lower)
            || functions
                .map(Function::name)
                .any(|name| lower.len() < name.len() + 3);
        let length = word.chars().count();
        let is_due = length >= MIN_LETTERS || SMALL.contains(&lower.as_str());
        let is_word = !word.contains(|char| !is_of_word(char) || is_dotted(char));
        if !is_word || word.ends_with(is_apostrophe) || is_symbol || !is_due {
            break;
        }
        (count, longest) = (count + 1, length.max(longest));
        rest = rest[word.len()..].trim_start();
    }
    let is_said = longest >= MIN_LETTERS && count > 1 || longest >= MIN_LETTERS_ALONE;
    is_said.then_some(rest)
}

/// Whether a word begins with the name of a Greek letter.
fn greek_prefix(word: &str) -> bool {
    const SHORTEST: usize = 3;
    let ends = word.char_indices().map(|(at, _)| at).chain([word.len()]);
    ends.skip(SHORTEST)
        .any(|end| greek_word(&word[..end]).is_some())
}

/// The pieces of a text between its equals signs, the symbol before the first one among them.
pub(crate) fn statement(text: &str) -> Vec<&str> {
    let pieces = cut_at_equals(text).into_iter();
    pieces.map(|piece| text[piece.range()].trim()).collect()
}

/// The sides of the equals signs of a text; empty ones are left out.
pub(crate) fn equal_sides(text: &str) -> Vec<Span> {
    let sides = cut_at_equals(text).into_iter();
    let sides = sides.map(|side| trimmed(text, side));
    sides.filter(|side| !side.range().is_empty()).collect()
}

/// The statements of a text without the symbol before two other sides of each, `m x'' = -k x` of `ΣF = m x'' = -k x`; none
/// where no statement has such a symbol.
pub(crate) fn without_names(text: &str) -> Option<String> {
    let bare = text.split_inclusive([',', ';', '\n']).map(|piece| {
        let (name, rest) = piece.split_once('=').unwrap_or((piece, ""));
        let is_name = is_word(name.trim().trim_start_matches('∑'));
        if is_name && rest.contains('=') {
            rest
        } else {
            piece
        }
    });
    let plain: String = bare.collect();
    (plain != text).then_some(plain)
}

/// What comes after the last equals sign.
pub(crate) fn last_side(text: &str) -> Span {
    cut_at_equals(text)
        .pop()
        .unwrap_or(Span::new(0, text.len()))
}

/// The pieces between equals signs; those of `<=` and its like are none.
fn cut_at_equals(text: &str) -> Vec<Span> {
    let (mut pieces, mut start) = (Vec::new(), 0);
    for (at, char) in text.char_indices() {
        let is_alone =
            || !text[..at].ends_with(['<', '>', '!']) && !text[at + 1..].starts_with(['<', '>']);
        if char == '≈' || char == '=' && is_alone() {
            pieces.push(trimmed(text, Span::new(start, at)));
            start = at + char.len_utf8();
        }
    }
    pieces.push(Span::new(start, text.len()));
    pieces
}

/// A symbol that stands alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Symbol {
    /// A name of which the answer may be made.
    Allowed,
    /// Another.
    Asked,
}

/// Whether a text is one symbol: `ω0`, `k_{ser}`, `x(t)`, `|X|`, `dx/dt`, `ω_d [rad/s]`.
fn symbol(text: &str, lexicon: &Lexicon) -> Option<Symbol> {
    let text = match described(text) {
        Some("") => return Some(Symbol::Asked),
        Some(rest) => rest,
        None => text,
    };
    let text = text.trim_matches(['$', ' ']);
    let mut bars = [("|", "|"), ("abs(", ")")].into_iter();
    let bare = bars.find_map(|(open, close)| text.strip_prefix(open)?.strip_suffix(close));
    let text = without_arguments(bare.unwrap_or(text));
    if leibniz(text, 0).is_some_and(|(.., end)| end == text.len()) || is_quotient(text) {
        return Some(Symbol::Asked);
    }
    let mut bare = MARKS.iter().filter_map(|mark| text.strip_suffix(mark));
    if bare.any(is_word) {
        return Some(Symbol::Asked);
    }
    if !is_word(text) || begins_with_function(text) {
        return None;
    }
    let found = tokens(text, 0, text.len(), lexicon, Manner::default());
    match found {
        Ok(tokens) => matches!(
            tokens[..],
            [Token {
                item: Item::Leaf(_),
                ..
            }]
        )
        .then_some(Symbol::Allowed),
        // `kx` where x may not be used.
        Err(TypedError {
            trouble: Trouble::NotAllowed(_),
            span,
        }) => {
            // `xi` is a letter where x may not be used.
            let is_one = span.range() == (0..text.len()) || greek_word(text).is_some();
            is_one.then_some(Symbol::Asked)
        }
        Err(_) => Some(Symbol::Asked),
    }
}

/// Marks after a letter that are not letters: those of conjugate values and of parallel springs.
const MARKS: &[&str] = &[
    "^*",
    "^{*}",
    "*",
    "^\\star",
    "^{\\star}",
    "_\\parallel",
    "_∥",
    "_//",
    "_{//}",
    "_||",
    "_{||}",
    "||",
    "_\\perp",
    "_⊥",
];

/// Whether a text is written as one name is.
pub(crate) fn is_word(text: &str) -> bool {
    let is_command = text.contains('\\') && !text.contains("frac") && !text.contains("sqrt");
    let is_of_name = |char: char| {
        char.is_alphabetic()
            || char.is_ascii_digit()
            || matches!(
                char,
                '₀'..='₉' | '_' | '{' | '}' | '\'' | '"' | '\u{307}' | '\u{308}' | '∥' | '⊥'
            )
            || is_command && matches!(char, '\\' | ' ' | ',')
    };
    text.starts_with(|first: char| first.is_alphabetic() || first == '\\')
        && text.chars().all(is_of_name)
}

/// `sqrt(k)`, and `tanθ` where θ is no name of the question.
pub(crate) fn begins_with_function(text: &str) -> bool {
    Function::all().any(|function| {
        let name = function.name();
        name.len() > 2 && function.arity().1 == 1 && text.starts_with(name)
    })
}
