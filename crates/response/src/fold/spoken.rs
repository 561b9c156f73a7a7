//! Operations in words: `square root of (k over m)`, `cosine of (ω t)`, `x double dot`.

use super::Folder;
use crate::signs::is_times;
use crate::surroundings::behind_words;
use crate::words::{FUNCTIONS, RATES_IN_WORDS, SPOKEN_ROOTS};

impl Folder<'_> {
    /// Writes the sign for words of an operation; whether some stand here.
    pub(crate) fn spoken(&mut self) -> bool {
        let found = self.spoken_rate().or_else(|| self.spoken_function());
        if let Some((length, plain)) = found {
            self.write(plain, length);
        }
        found.is_some()
    }

    /// A space and the word for the rate of the letter before it, ` double dot`.
    fn spoken_rate(&self) -> Option<(usize, &'static str)> {
        let words = self.rest().strip_prefix(' ')?;
        let (behind, plain) = RATES_IN_WORDS
            .iter()
            .find_map(|(own, plain)| Some((behind_words(words, own, str::eq)?, *plain)))?;
        let before = &self.typed[self.answer.start..self.at];
        if !before.ends_with(|last: char| last.is_alphanumeric() || "_}".contains(last)) {
            return None;
        }
        // `c dot(x)` is a call, `a dot b` a product.
        let next = behind.trim_start_matches(' ');
        let is_product = plain == "'" && next.starts_with(|next: char| next.is_alphanumeric());
        let goes_on = ["plus ", "minus ", "times ", "squared", "equals ", "is "];
        let ends = !behind.starts_with(|next: char| next == '(' || next.is_alphanumeric())
            && (!is_product || goes_on.iter().any(|word| next.starts_with(word)));
        ends.then(|| (1 + words.len() - behind.len(), plain))
    }

    /// The words for a root or a function here; a root of words without brackets gets them.
    fn spoken_function(&mut self) -> Option<(usize, &'static str)> {
        let before = &self.typed[self.answer.start..self.at];
        let is_apart = before.is_empty() || before.ends_with([' ', '(', '=', '*', '/']);
        let rest = &self.typed[self.at..self.answer.end];
        if !is_apart || !rest.starts_with(char::is_alphabetic) {
            return None;
        }
        let behind = |words: &str| behind_words(rest, words, str::eq)?.strip_prefix(' ');
        let function = FUNCTIONS
            .iter()
            .find_map(|(words, plain)| Some((behind(words)?, *plain)));
        if let Some((argument, plain)) = function {
            return argument
                .starts_with('(')
                .then_some((rest.len() - argument.len(), plain));
        }
        let radicand = SPOKEN_ROOTS.iter().find_map(|words| behind(words))?;
        let length = rest.len() - radicand.len();
        if radicand.starts_with('(') {
            return Some((length, "sqrt"));
        }
        let end = self.at + length + end_of_radicand(radicand)?;
        self.roots.push(end);
        Some((length, "sqrt("))
    }
}

const QUOTIENTS: [&str; 3] = [" over ", " divided by ", "/"];

/// Where what stands under a spoken root ends, `k over m`; none where it may be a part of that alone.
fn end_of_radicand(text: &str) -> Option<usize> {
    const ENDS: [&str; 10] = [
        " plus ", " minus ", " + ", " - ", " for ", " where ", " with ", " if ", " = ", " is ",
    ];
    let words = ENDS.iter().filter_map(|end| text.find(end));
    let signs = text.find([',', ';', '\n', '=', '≈', '(', ')']);
    let end = words.chain(signs).min().unwrap_or(text.len());
    let own = text[..end].trim_end();
    // `the root of k m over c`
    let quotient = QUOTIENTS.iter().find_map(|sign| own.split_once(sign));
    let parts = |char: char| matches!(char, ' ' | '*' | '/') || is_times(char);
    let is_one = |side: &str| !side.trim().contains(parts);
    let is_clear = quotient.is_none_or(|(above, below)| is_one(above) && is_one(below));
    (is_clear && !own.is_empty() && !text[end..].starts_with('(')).then_some(own.len())
}

/// Whether words for an operation begin with a word.
pub(crate) fn begins_operation(word: &str) -> bool {
    let words = RATES_IN_WORDS.iter().chain(FUNCTIONS).map(|(own, _)| *own);
    let mut words = words.chain(SPOKEN_ROOTS.iter().copied());
    words.any(|own| own.split(' ').next() == Some(word))
}
