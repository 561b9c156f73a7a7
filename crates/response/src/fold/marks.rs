//! Marks of Markdown and of lists: what sets an answer apart, points, labels of several answers.

use super::Folder;
use crate::signs::BULLETS;
use crate::surroundings::enumeration;

/// Signs after which a value begins, and no factor of what stands before them.
const BEFORE_A_VALUE: [char; 11] = ['=', '≈', ':', ';', ',', '\n', '<', '>', '≤', '≥', '('];

impl Folder<'_> {
    /// Has the labels of several answers part them.
    pub(crate) fn enumerate(&mut self) {
        for label in enumeration(&self.typed[self.answer.clone()]) {
            let label = self.answer.start + label.start..self.answer.start + label.end;
            let before = self.typed[self.answer.start..label.start].trim_end_matches(' ');
            let is_parted = before.is_empty() || before.ends_with([',', ';', '\n']);
            let sign = (!is_parted).then_some(label.end - 1);
            self.row_ends.extend(sign);
            self.blanked.extend(label.filter(|at| Some(*at) != sign));
        }
    }

    /// Finds the marks before the points of a list, one on each line; a dash is one where each line has a symbol or is set
    /// apart.
    pub(crate) fn bullets(&mut self) {
        let lines = || self.typed.lines().filter(|line| !line.trim().is_empty());
        let Some(mark) = self.typed.trim_start().get(..2) else {
            return;
        };
        let is_mark = BULLETS.contains(&mark) || mark == "- ";
        if !is_mark || lines().count() < 2 {
            return;
        }
        let is_point = |line: &str| {
            line.trim_start().starts_with(mark)
                && (mark != "- " || line.contains(['=', '≈', ':']) || line.contains("**"))
        };
        if lines().all(is_point) {
            let start = self.typed.as_ptr() as usize;
            let places = lines().map(|line| {
                let own = line.as_ptr() as usize - start;
                own + line.len() - line.trim_start().len()
            });
            let places: Vec<usize> = places.collect();
            self.blanked.extend(places);
        }
    }

    /// Whether one of the marks stands here that set a part of an answer apart in Markdown, `ω = **5 rad/s**`. What opens
    /// has nothing before it that it could multiply, and its partner nothing behind it.
    pub(crate) fn is_set_apart(&mut self, mark: char) -> bool {
        if self.marks.first() == Some(&self.at) {
            self.marks.remove(0);
            return true;
        }
        let typed = self.typed;
        let rest = &typed[self.at..self.answer.end];
        let before = self.text.trim_end_matches(' ');
        let is_behind_nothing = before.is_empty() || before.ends_with(BEFORE_A_VALUE);
        let mark: &'static str = match mark {
            '*' if rest.starts_with("**") => "**",
            '_' if rest.starts_with("__") => "__",
            '`' => "`",
            _ => return false,
        };
        let inner = &rest[mark.len()..];
        let may_open = !self.is_unmarked && self.marks.is_empty() && is_behind_nothing;
        if !may_open || inner.starts_with([' ', '*', '_', '`', '\n']) {
            return false;
        }
        let mut closing = inner.match_indices(mark).filter(|(at, _)| {
            let behind = inner[at + mark.len()..].chars().next();
            let is_apart =
                behind.is_none_or(|next| next.is_whitespace() || ".,;:!?)".contains(next));
            is_apart && *at > 0 && !inner[..*at].ends_with([' ', '*', '_'])
        });
        let Some((close, _)) = closing.next() else {
            // None of those behind it closes anything either.
            self.is_unmarked = true;
            return false;
        };
        let (open, close) = (self.at, self.at + mark.len() + close);
        self.marks.extend(open + 1..open + mark.len());
        self.marks.extend(close..close + mark.len());
        true
    }
}
