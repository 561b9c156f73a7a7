//! What stands before and after the equals signs of functions.

use super::Passage;
use super::letters::is_dotted;
use super::list::cut;
use super::naming::is_symbol;
use vibank_source::{Span, lower};

/// A text before and after its first equals sign, or the colon after its name, `x(t): 2 cos(3 t)`.
pub(crate) fn equated(passage: Passage<'_>) -> Option<(Passage<'_>, Passage<'_>)> {
    let text = passage.text();
    if let Some((name, behind)) = text.split_once(':')
        && name.starts_with(|first: char| first.is_alphabetic() || first == '\\')
        && is_symbol(name)
        && !behind.starts_with('=')
    {
        return Some((Passage::of(name), Passage::of(behind)));
    }
    let (at, sign) = text.char_indices().find(|(_, char)| "=≈".contains(*char))?;
    let behind = text[at + sign.len_utf8()..].trim_start_matches('=');
    Some((Passage::of(&text[..at]), Passage::of(behind)))
}

/// The functions of several coordinates, parted by semicolons or line ends, else by commas, else by `and`.
pub(crate) fn functions(passage: Passage<'_>) -> Vec<Passage<'_>> {
    const AND: &str = " and ";
    let lines = passage.lines();
    let [line] = lines[..] else {
        return lines;
    };
    let text = passage.text();
    let all = Span::new(0, text.len());
    let pieces = cut(text, all, &[',']);
    if pieces.len() > 1 {
        return pieces
            .into_iter()
            .map(|place| passage.part(place))
            .collect();
    }
    match line.text().split_once(AND) {
        Some((first, second)) => vec![Passage::of(first), Passage::of(second)],
        None => lines,
    }
}

/// Whether a text is a letter, perhaps of one of these arguments, that may be a name of one's own.
pub(crate) fn is_free_letter(text: &str, arguments: &[String]) -> bool {
    let text = without_bracketed_unit(text);
    let (name, behind) = match text.find('(') {
        Some(open) => (text[..open].trim(), &text[open..]),
        None => (text, ""),
    };
    let argument = behind
        .strip_prefix('(')
        .and_then(|text| text.strip_suffix(')'));
    let is_of_variable = behind.is_empty()
        || argument.is_some_and(|own| arguments.iter().any(|known| known == own.trim()));
    let is_name =
        |char: char| (char.is_alphanumeric() || "_\\{}".contains(char)) && !is_dotted(char);
    is_of_variable
        && name.starts_with(|char: char| char.is_alphabetic() || char == '\\')
        && name.chars().all(is_name)
        && !name.contains("dot")
        && !["v", "a"].contains(
            &name.trim_end_matches(|char: char| char.is_ascii_digit() || "_{}".contains(char)),
        )
}

/// Whether words describe a rate of what is asked.
pub(crate) fn is_of_rate(words: &str) -> bool {
    const RATES: [&str; 6] = [
        "velocity",
        "acceleration",
        "speed",
        "rate",
        "vitesse",
        "accélération",
    ];
    words
        .split_whitespace()
        .any(|word| RATES.contains(&lower(word).as_str()))
}

/// A name without the unit in brackets after it, `x(t) [m]`.
pub(crate) fn without_bracketed_unit(text: &str) -> &str {
    let text = text.trim();
    let bracket = text.rfind('[').filter(|_| text.ends_with(']'));
    bracket.map_or(text, |at| text[..at].trim_end())
}
