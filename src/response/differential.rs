//! Time derivatives as quotients of differentials, `dx/dt`, `\frac{d^2 x}{dt^2}`, and as functions, `diff(x, t, 2)`.

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

/// Reads a derivative that is written as a function at a place, `diff(x, t, 2)`, `ddot(x1)`: spelling of the name,
/// order, end.
pub(super) fn called(text: &str, at: usize) -> Option<(String, u8, usize)> {
    const LONGEST: usize = 80;
    let rest = &text[at..];
    let (name, inner) = rest.split_once('(')?;
    let dots = match name {
        "dot" => Some(1),
        "ddot" => Some(2),
        "diff" | "Diff" | "D" | "Derivative" => None,
        _ => return None,
    };
    let close = closing(inner).filter(|close| *close < LONGEST)?;
    let arguments: Vec<&str> = inner[..close].split(',').map(str::trim).collect();
    let spelling = arguments[0].strip_suffix("(t)").unwrap_or(arguments[0]);
    let spelling = Letters::spelling(spelling)?;
    let order = match (dots, &arguments[1..]) {
        (Some(order), []) => order,
        (None, ["t"]) => 1,
        (None, ["t", "t" | "2"] | ["(t", "2)"] | ["t$2"]) => 2,
        _ => return None,
    };
    Some((spelling, order, at + name.len() + 1 + close + 1))
}

/// Where the bracket closes that stands open before a text.
fn closing(text: &str) -> Option<usize> {
    let mut depth = 0_i32;
    let closes = |char: char| {
        depth += match char {
            '(' => 1,
            ')' => -1,
            _ => 0,
        };
        depth < 0
    };
    text.find(closes)
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
        let signs = ["\\mathrm{d}", "\\mathrm d", "\\partial", "∂", "d"];
        let found = signs.iter().any(|sign| self.take(sign));
        found.then_some(())
    }

    fn order(&mut self) -> u8 {
        let is_second = ["²", "^{2}", "^2", "2"].iter().any(|sign| self.take(sign));
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
