//! Time derivatives as quotients of differentials, `dx/dt`, `\frac{d^2 x}{dt^2}`.

use super::letters::{Letters, greek_word};

/// Reads a quotient of differentials at a place: spelling of the name, order, end.
pub(super) fn leibniz(text: &str, at: usize) -> Option<(String, u8, usize)> {
    let mut scanner = Differentials { text, at };
    let is_fraction = scanner.take("\\frac") && scanner.take("{");
    scanner.differential()?;
    let order = scanner.order();
    let spelling = scanner.name()?;
    let is_over = if is_fraction {
        scanner.take("}") && scanner.take("{")
    } else {
        scanner.take("/")
    };
    if !is_over {
        return None;
    }
    scanner.differential()?;
    let is_time = scanner.take("t") && scanner.order() == order;
    if !is_time || is_fraction && !scanner.take("}") {
        return None;
    }
    let goes_on = scanner.text[scanner.at..]
        .starts_with(|next: char| next.is_ascii_alphanumeric() || next == '_');
    (!goes_on || is_fraction).then_some((spelling, order, scanner.at))
}

struct Differentials<'a> {
    text: &'a str,
    at: usize,
}

impl Differentials<'_> {
    fn take(&mut self, word: &str) -> bool {
        let rest = &self.text[self.at..];
        let trimmed = rest.trim_start();
        let found = trimmed.starts_with(word);
        if found {
            self.at += rest.len() - trimmed.len() + word.len();
        }
        found
    }

    fn differential(&mut self) -> Option<()> {
        let found = self.take("\\mathrm{d}") || self.take("d");
        found.then_some(())
    }

    fn order(&mut self) -> u8 {
        let is_second = self.take("²") || self.take("^{2}") || self.take("^2");
        if is_second { 2 } else { 1 }
    }

    /// A name up to the slash or brace.
    fn name(&mut self) -> Option<String> {
        const LONGEST: usize = 80;
        let rest = &self.text[self.at..];
        let is_end = |(_, char): &(usize, char)| matches!(char, '/' | '}');
        let (end, _) = rest.char_indices().take(LONGEST).find(is_end)?;
        let (mut spelling, mut command) = (String::new(), false);
        let name = rest[..end].trim();
        let name = name.strip_suffix("(t)").unwrap_or(name);
        if let Some(word) = name.strip_prefix('\\') {
            let letters: String = word.chars().take_while(char::is_ascii_alphabetic).collect();
            spelling.push_str(greek_word(&letters)?);
            spelling.push_str(&Letters::spelling(&word[letters.len()..]).unwrap_or_default());
            command = true;
        }
        if !command {
            spelling = Letters::spelling(name)?;
        }
        self.at += end;
        Some(spelling)
    }
}
