//! Words that stand for others or for signs, and words before brackets.

use super::Folder;
use super::programs::holds_list;
use crate::signs::{TURNS, is_digit};
use crate::surroundings::{begins, behind_words};
use crate::words::{
    Between, HALF_PI, LETTERS, LISTS, NUMBERS, PER_MILLE, PERCENT, ROOTED_UNITS, ROOTS, VERBS,
    WORDS,
};
use vibank_formula::unit::Unit;

impl Folder<'_> {
    /// The words between spaces that stand here, by their length, if others or a sign stand for them.
    pub(crate) fn word(&self) -> Option<(usize, &'static str)> {
        let before = &self.typed[self.answer.start..self.at];
        let rest = self.rest();
        let begins = before.is_empty() || before.ends_with([' ', '(']);
        if !begins || !rest.starts_with(char::is_alphabetic) {
            return None;
        }
        let of_words = |rest: &str| {
            WORDS.iter().find_map(|(words, plain)| {
                let behind = behind_words(rest, words, |head, word| {
                    head == word || self.is_shouted && head.eq_ignore_ascii_case(word)
                })?;
                let may_end = matches!(*plain, PERCENT | PER_MILLE | "^2" | "^3" | HALF_PI);
                let ends = behind.starts_with(' ')
                    || may_end && !behind.starts_with(char::is_alphanumeric);
                ends.then(|| (rest.len() - behind.len(), *plain))
            })
        };
        let comparison = VERBS.iter().find_map(|verb| {
            let behind = behind_words(rest, verb, str::eq)?;
            let compared = behind.strip_prefix(' ')?.trim_start_matches(' ');
            let (length, plain) = of_words(compared)?;
            let is_sign = matches!(plain, "<" | ">" | "≤" | "≥");
            is_sign.then(|| (rest.len() - compared.len() + length, plain))
        });
        // `or` and the like join what stands on both sides.
        comparison.or_else(|| of_words(rest)).filter(|(_, plain)| {
            !before.is_empty() || matches!(*plain, "<" | ">" | "≤" | "≥" | "-" | "+" | HALF_PI)
        })
    }

    /// A unit under a root that ends a list, `(1, -1)/√kg`.
    pub(crate) fn rooted_unit(&self) -> Option<(usize, &'static str)> {
        let rest = &self.typed[self.at..self.answer.end];
        let before = self.typed[self.answer.start..self.at].trim_end();
        let (spelling, plain) = ROOTED_UNITS
            .iter()
            .find(|(own, _)| *own == rest.trim_end())?;
        let is_list = before.ends_with([')', ']']) && before.contains([',', ';']);
        is_list.then_some((spelling.len(), *plain))
    }

    /// A word that is a letter elsewhere, `y` and `e` between two values, `in` before a unit that ends the response.
    pub(crate) fn word_of_list(&self) -> Option<(usize, &'static str)> {
        let before = self.typed[self.answer.start..self.at].strip_suffix(' ')?;
        let before = before.strip_suffix(',').unwrap_or(before);
        let rest = &self.typed[self.at..self.answer.end];
        let (word, plain, between) = LETTERS.iter().find(|(word, ..)| {
            let behind = rest.strip_prefix(word);
            behind.is_some_and(|behind| behind.starts_with(' '))
        })?;
        let behind = &rest[word.len() + 1..];
        let is_behind_value = before.ends_with(|last| is_digit(last) || "°)]".contains(last));
        let stands = if *between == Between::Unit {
            is_behind_value && !behind.trim().is_empty() && Unit::read(behind.trim()).is_ok()
        } else {
            let next = behind.trim_start_matches('-');
            let digits = next.trim_start_matches(is_digit);
            let is_sure = match between {
                Between::Decimals => digits.starts_with(['.', ',']),
                Between::Listed => !before.contains(['<', '>', '≤', '≥']),
                Between::Values | Between::Unit => true,
            };
            let is_amount = before.ends_with(char::is_alphabetic)
                && before.starts_with(|first: char| first.is_ascii_digit() || first == '-');
            digits.len() < next.len() && is_sure && (is_behind_value || is_amount)
        };
        stands.then_some((word.len(), *plain))
    }

    /// What is read together with what comes after it: units of turning, roots.
    pub(crate) fn before_others(&self) -> Option<(usize, &'static str)> {
        let rest = self.rest();
        if !rest.starts_with(char::is_alphabetic)
            || self.typed[..self.at].ends_with(|char: char| char.is_alphabetic() || char == '_')
        {
            return None;
        }
        if let Some((turn, plain)) = TURNS.iter().find(|(turn, _)| begins(rest, turn)) {
            return Some((turn.len(), plain));
        }
        let is_call =
            |name: &&&str| begins(rest, name) && rest.as_bytes().get(name.len()) == Some(&b'(');
        if let Some(root) = ROOTS.iter().find(is_call) {
            return Some((root.len(), "sqrt"));
        }
        let number = NUMBERS.iter().find(is_call);
        // `mat(1 + x)` may be a product of letters.
        let list = || LISTS.iter().find(is_call);
        let name = number.or_else(|| list().filter(|name| holds_list(&rest[name.len() + 1..])))?;
        Some((name.len(), ""))
    }
}

/// Whether words are in capitals throughout, as those of options are shouted.
pub(crate) fn is_shouted(typed: &str) -> bool {
    let is_word = |word: &str| word.chars().filter(|char| char.is_uppercase()).count() > 2;
    !typed.contains(char::is_lowercase) && typed.split(' ').filter(|word| is_word(word)).count() > 1
}

/// Whether one of the words that stand for others begins with a word.
pub(crate) fn begins_words(own: &str) -> bool {
    if LETTERS.iter().any(|(word, ..)| *word == own) {
        return true;
    }
    let mut bytes = own.bytes();
    let mut words = WORDS.iter().map(|(words, _)| words).chain(VERBS);
    own.len() > 1
        && bytes.all(|byte| byte.is_ascii_alphabetic() || byte == b'.')
        && words.any(|words| {
            let behind = words.as_bytes().get(own.len());
            begins(words, own) && matches!(behind, None | Some(b' '))
        })
}
