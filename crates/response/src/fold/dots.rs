//! The dots of time derivatives: after their letter, before it, and as points.

use super::Folder;
use super::alphabets::unstyled;
use crate::signs::is_of_name;

impl Folder<'_> {
    /// Dots of derivatives that stand apart from their letter; whether some do here.
    pub(crate) fn apart_dots(&mut self, char: char) -> bool {
        // Copied from a page, dots stand before their letter: `m ¨x`.
        if let Some(length) = self.dots_before() {
            let (dots, letter) = self.rest()[..length].split_at('¨'.len_utf8());
            let dots = if dots == "¨" { "\u{308}" } else { "\u{307}" };
            let letter = format!(" {}{dots}", unstyled(letter.chars().next().unwrap_or(' ')));
            self.write(&letter, length);
            return true;
        }
        if char == 'ü' && self.is_derivative() {
            self.write("u\u{308}", char.len_utf8());
            return true;
        }
        // `(x_1 ) ̈`, as word processors write it on one line.
        if char == '('
            && let Some((name, dots, length)) = self.bracketed_name()
        {
            self.write(&format!(" {name}{dots} "), length);
            return true;
        }
        // A dot belongs to the letter before it, whatever stands between.
        let behind = self.rest().strip_prefix(' ');
        let mut signs = behind.unwrap_or_default().chars();
        let is_dot = signs
            .next()
            .is_some_and(|sign| "\u{307}\u{308}¨˙".contains(sign));
        let belongs_before = is_dot && !signs.next().is_some_and(char::is_alphabetic);
        if belongs_before {
            self.write("", char.len_utf8());
        }
        belongs_before
    }

    /// The name in the brackets that open here and have dots after them, the dots, and the length of all.
    fn bracketed_name(&self) -> Option<(String, char, usize)> {
        // A letter with its index.
        const MAX_LENGTH: usize = 16;
        let rest = self.rest();
        let close = rest.find(')').filter(|close| *close < MAX_LENGTH)?;
        let behind = &rest[close + 1..];
        let sign = behind.trim_start_matches(' ');
        let dots = match sign.chars().next()? {
            '\u{307}' | '˙' => '\u{307}',
            '\u{308}' | '¨' => '\u{308}',
            _ => return None,
        };
        let name: String = rest[1..close].trim().chars().map(unstyled).collect();
        let is_name = name.starts_with(char::is_alphabetic) && name.chars().all(is_of_name);
        let length = rest.len() - sign.len() + sign.chars().next().map_or(0, char::len_utf8);
        is_name.then_some((name, dots, length))
    }

    /// Whether the letter here ends a run of letters that is too short for a word: `m ü`, `kü`, not `für` or `Menü`.
    fn is_derivative(&self) -> bool {
        const MAX_BEFORE: usize = 2;
        let mut behind = self.rest().chars().skip(1);
        let before = self.typed[..self.at].chars().rev();
        !behind.next().is_some_and(char::is_alphabetic)
            && before.take_while(|char| char.is_alphabetic()).count() <= MAX_BEFORE
    }

    /// `x1..`, the dots of a derivative after its letter; one dot alone is such where two are.
    pub(crate) fn dots(&self) -> Option<(usize, &'static str)> {
        let rest = self.rest();
        if !rest.starts_with('.') {
            return None;
        }
        let before = &self.typed[..self.at];
        let parts = |char: char| !char.is_alphanumeric() && !"_}".contains(char);
        let name = before.rsplit(parts).next().unwrap_or_default();
        if !name.starts_with(char::is_alphabetic) {
            return None;
        }
        let next = |length: usize| rest[length..].chars().next().unwrap_or(' ');
        if rest.starts_with("..") {
            return (next(2) != '.').then_some((2, "\u{308}"));
        }
        let is_dot = self.typed.contains("..") && !next(1).is_alphanumeric();
        is_dot.then_some((1, "\u{307}"))
    }

    /// The length of dots that a letter follows, where nothing stands right before them and they have no letter there.
    fn dots_before(&self) -> Option<usize> {
        let rest = self.rest();
        let behind = rest.strip_prefix(['¨', '˙'])?;
        let before = &self.typed[..self.at];
        let is_apart = before.is_empty() || before.ends_with([' ', '+', '-', '*', '=', '(', '·']);
        let letter = behind.chars().next().filter(|next| next.is_alphabetic())?;
        is_apart.then(|| rest.len() - behind.len() + letter.len_utf8())
    }
}
