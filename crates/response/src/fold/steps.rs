//! The steps of a derivation, of which the last one is the answer, and lines that go on with the one before.

use super::Folder;
use crate::signs::{is_digit, is_minus};

/// Arrows from a step of a derivation to the next, and from an equation to one that says the same.
const ARROWS: [&str; 17] = [
    "⇒",
    "⟹",
    "⇔",
    "⟺",
    "∴",
    "=>",
    "->",
    "→",
    "⟶",
    "\\Rightarrow",
    "\\implies",
    "\\Longrightarrow",
    "\\Leftrightarrow",
    "\\iff",
    "\\therefore",
    "\\rightarrow",
    "\\to",
];
/// Those of them that are also signs of a bound, a rule or a limit, and lead from an equation to another alone.
const AMBIGUOUS_ARROWS: [&str; 6] = ["=>", "->", "→", "⟶", "\\rightarrow", "\\to"];

/// Signs of which each arrow has one.
const OF_ARROWS: [char; 9] = ['>', '\\', '⇒', '⟹', '⇔', '⟺', '∴', '→', '⟶'];

/// What may stand with an arrow before the first step of a line.
const ARROWS_AND_SPACES: [char; 12] = [' ', '\n', '=', '-', '>', '⇒', '⟹', '⇔', '⟺', '∴', '→', '⟶'];

/// Where the last step begins in a line that has some, after its arrow; an arrow in front leads from the line before.
fn end_of_steps(line: &str, line_before: &str) -> Option<usize> {
    // In one pass: the searches for all arrows take longer than all the rest of a line without one.
    if !line.contains(OF_ARROWS) {
        return None;
    }
    let found = ARROWS
        .iter()
        .filter_map(|arrow| Some((line.rfind(arrow)?, *arrow)));
    let (at, arrow) = found.max_by_key(|(at, arrow)| at + arrow.len())?;
    let (before, behind) = (&line[..at], &line[at + arrow.len()..]);
    let from = if before.trim().is_empty() {
        line_before
    } else {
        before
    };
    let is_command =
        arrow.starts_with('\\') && behind.starts_with(|next: char| next.is_ascii_alphabetic());
    let is_within =
        before.matches(['(', '[', '{']).count() != before.matches([')', ']', '}']).count();
    let relates = |text: &str| text.contains(['=', '≈']);
    let is_led_to = before.trim().is_empty() || before.contains(['=', '≈', '<', '>', '≤', '≥']);
    let compares = |text: &str| text.contains(['<', '>', '≤', '≥']);
    let is_sure = if AMBIGUOUS_ARROWS.contains(&arrow) {
        relates(from) && relates(behind) || arrow != "=>" && compares(before) && compares(behind)
    } else {
        is_led_to
    };
    // `ω1² = 4 ⇒ ω1 = 2, ω2² = 9 ⇒ ω2 = 3` derives two values.
    let arrow_before = ARROWS
        .iter()
        .filter_map(|arrow| Some(before.rfind(arrow)? + arrow.len()))
        .max();
    let is_one = arrow_before.is_none_or(|end| !before[end..].contains([',', '&']));
    let is_step = !is_command && !is_within && is_sure && is_one && !behind.trim().is_empty();
    is_step.then_some(at + arrow.len())
}

/// Where the only arrow of a line stands that leads from a name to its value, `ζ → 1.06`, `C -> {{k, -k}, {-k, k}}`, and
/// how long it is: programs and some people write it for an equals sign.
fn arrow_to_value(line: &str) -> Option<(usize, usize)> {
    if !line.contains(OF_ARROWS) {
        return None;
    }
    let mut found = AMBIGUOUS_ARROWS[1..]
        .iter()
        .filter_map(|arrow| Some((line.find(arrow)?, *arrow)));
    let (at, arrow) = found.next().filter(|_| found.next().is_none())?;
    let (before, behind) = (line[..at].trim(), &line[at + arrow.len()..]);
    let relates = |text: &str| text.contains(['=', '≈', '<', '>', '≤', '≥', '→', ':']);
    let begins =
        |first: char| first.is_ascii_digit() || ".+√π∞([{".contains(first) || is_minus(first);
    let is_name = before.starts_with(|first: char| first.is_alphabetic() || "\\|".contains(first))
        && !before.contains(',')
        // `t -> 2 t` is a function.
        && before != "t";
    let is_value = behind.starts_with([' ', '\\']) || behind.starts_with(begins);
    let value = behind.trim_start();
    // `λ -> c/(2 m)`, where one letter alone may be what a limit goes to.
    let is_formula =
        || value.starts_with(char::is_alphabetic) && value.contains(['*', '/', '^', '(', '+', '²']);
    let is_value =
        is_value && (value.starts_with(begins) || value.starts_with("\\pi") || is_formula());
    let is_used = value
        .split(|char: char| !char.is_alphanumeric())
        .any(|word| word == before);
    // `1.4156 -> 1.42 s` rounds.
    let is_rounded =
        before.starts_with(begins) && before.ends_with(is_digit) && before.contains(['.', ',']);
    ((is_name || is_rounded)
        && is_value
        && !is_used
        && (is_rounded || !relates(before))
        && !(relates(behind) || is_rounded && behind.contains(',')))
    .then_some((at, arrow.len()))
}

/// Where the equals sign stands in a line that is about the same symbol as the line before, and says nothing of where
/// either holds.
fn repeated(before: &str, line: &str) -> Option<usize> {
    let bare = |text: &'_ str| -> bool {
        !text.contains([',', '<', '>', '≤', '≥', '&', '\\', '[', '{'])
    };
    let (own, _) = line.split_once('=')?;
    let (other, _) = before.split_once('=')?;
    let is_symbol = |text: &str| {
        text.chars()
            .all(|char| char.is_alphanumeric() || "_' ".contains(char))
    };
    let says_where = |text: &str| {
        [" for ", " if ", " when ", " pour "]
            .iter()
            .any(|word| text.contains(word))
    };
    let is_same = !own.trim().is_empty() && own.trim() == other.trim() && is_symbol(own.trim());
    (is_same && bare(line) && bare(before) && !says_where(line) && !says_where(before))
        .then_some(own.len())
}

impl Folder<'_> {
    /// Finds the steps of a derivation, of which the last one is the answer: `ω² = 4/s² ⇒ ω = 2 rad/s`; and lines that go
    /// on with what the line before is about, `ω = √(k/m)` and `ω = 2 rad/s`.
    pub(crate) fn derive(&mut self) {
        let (start, text) = (self.answer.start, &self.typed[self.answer.clone()]);
        let mut line_before: Option<std::ops::Range<usize>> = None;
        let mut at = start;
        for line in text.split_inclusive(['\n', ';']) {
            let own = at..at + line.len();
            at = own.end;
            if line.trim().is_empty() {
                continue;
            }
            if let Some((arrow, length)) = arrow_to_value(line) {
                self.equals.push((own.start + arrow, length));
            }
            let text_before = line_before.clone().map_or("", |own| &self.typed[own]);
            if let Some(end) = end_of_steps(line, text_before) {
                let is_first = line[..end].trim_start_matches(ARROWS_AND_SPACES).is_empty();
                let from = line_before
                    .filter(|_| is_first)
                    .map_or(own.start, |own| own.start);
                self.dropped.push(from..own.start + end);
            } else if let Some(before) = &line_before
                && self.typed[before.clone()].ends_with('\n')
                && let Some(end) = repeated(&self.typed[before.clone()], line)
            {
                // Up to the equals sign, with the end of the line before.
                self.dropped.push(before.end - 1..own.start + end);
            }
            line_before = Some(own);
        }
        // The next one last.
        self.dropped.reverse();
    }

    pub(crate) fn is_dropped(&mut self) -> bool {
        while self.dropped.last().is_some_and(|own| own.end <= self.at) {
            self.dropped.pop();
        }
        self.dropped
            .last()
            .is_some_and(|own| own.contains(&self.at))
    }

    /// The ends of lines that follow each other, and the spaces between them: none where the statement goes on in the next
    /// line.
    pub(crate) fn line_ends(&mut self) {
        let typed = self.typed;
        let rest = &typed[self.at..self.answer.end];
        let next = rest.trim_start_matches([' ', '\n']);
        let blank = &rest[..rest.len() - next.len()];
        let run = blank.rfind('\n').map_or(1, |last| last + 1);
        let goes_on = next.trim_start().starts_with(['=', '≈'])
            || self.text.trim_end_matches(' ').ends_with(['=', '≈']);
        self.write(if goes_on { " " } else { &rest[..run] }, run);
    }
}
