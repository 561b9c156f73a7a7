//! Other layouts of lists, put as lists with brackets and commas: LaTeX environments, entries parted by spaces.

use std::borrow::Cow;

/// The text with brackets in place of those of LaTeX, `\left\{ a, b \right\}`, and of its environments,
/// `\begin{pmatrix} a & b \\ c & d \end{pmatrix}`; all places stay.
pub(super) fn without_latex(text: &str) -> Cow<'_, str> {
    if !text.contains('\\') {
        return Cow::Borrowed(text);
    }
    let mut plain = text.to_owned();
    if plain.contains("\\begin{") {
        // The environment has brackets of its own.
        for delimiter in ["\\left[", "\\left(", "\\right]", "\\right)"] {
            plain = plain.replace(delimiter, &" ".repeat(delimiter.len()));
        }
    }
    for (sign, bracket) in [("\\left", ""), ("\\right", ""), ("\\{", "{"), ("\\}", "}")] {
        plain = plain.replace(sign, &format!("{bracket:>0$}", sign.len()));
    }
    if plain.contains("\\begin{") {
        environments(&mut plain);
    }
    Cow::Owned(plain)
}

fn environments(plain: &mut String) {
    *plain = plain.replace("\\cr", "\\\\ ").replace("\\\\", "; ");
    *plain = plain.replace('&', ",");
    for (command, bracket) in [("\\begin{", '['), ("\\end{", ']')] {
        while let Some(start) = plain.find(command) {
            let mut length = plain[start..]
                .find('}')
                .map_or(command.len(), |end| end + 1);
            if plain[start..start + length].ends_with("array}") && bracket == '[' {
                // `{cc}` says how the columns are set.
                let columns = plain[start + length..].find('}');
                length += columns.map_or(0, |end| end + 1);
            }
            let padded = format!("{bracket}{}", " ".repeat(length - 1));
            plain.replace_range(start..start + length, &padded);
        }
    }
    // A row may be ended though none follows.
    let ends: Vec<usize> = plain.match_indices(']').map(|(at, _)| at).collect();
    for end in ends {
        if let Some(body) = plain[..end].trim_end().strip_suffix(';') {
            let at = body.len();
            plain.replace_range(at..=at, " ");
        }
    }
}

/// A list with semicolons for the ends of lines between its rows; all places stay.
pub(in crate::answer) fn rows_by_line(text: &str) -> String {
    let text = text.replace('\r', " ");
    let mut plain = String::with_capacity(text.len());
    for (at, char) in text.char_indices() {
        let before = text[..at]
            .trim_end()
            .ends_with([',', ';', '&', '[', '(', '{', '\\', '=']);
        let after = text[at..]
            .trim_start()
            .starts_with([']', ')', '}', '\\', ',', ';']);
        let is_end = char == '\n' && !before && !after;
        plain.push(match char {
            '\n' if is_end => ';',
            '\n' => ' ',
            char => char,
        });
    }
    plain
}

/// The same list with a comma for each space that parts entries, as in `[1 -2; 0 3]`; all places stay.
/// A space parts two values, and a value from a sign that stands at the next one.
pub(super) fn spaced(text: &str) -> String {
    let mut depth: Vec<char> = Vec::new();
    let mut plain = String::with_capacity(text.len());
    let chars: Vec<char> = text.chars().collect();
    for (at, char) in chars.iter().enumerate() {
        match char {
            '(' | '[' | '{' => depth.push(*char),
            ')' | ']' | '}' => {
                depth.pop();
            }
            _ => {}
        }
        let is_in_list = match depth[..] {
            [] | [_] => true,
            [.., last] => last != '(',
        };
        let parts = *char == ' ' && is_in_list && parts_entries(&chars, at);
        plain.push(if parts { ',' } else { *char });
    }
    plain
}

/// Whether the space at a place stands between two entries.
fn parts_entries(chars: &[char], at: usize) -> bool {
    let before = at.checked_sub(1).map(|at| chars[at]);
    let mut after = chars[at + 1..].iter().skip_while(|char| **char == ' ');
    let (next, second) = (after.next(), after.next());
    let ends = |char: char| char.is_alphanumeric() || ")]}²³'′.".contains(char);
    let begins = |char: char| char.is_alphanumeric() || "([{√\\.".contains(char);
    let is_signed = |sign: char| "+-−".contains(sign) && second.is_some_and(|next| begins(*next));
    before.is_some_and(ends) && next.is_some_and(|next| begins(*next) || is_signed(*next))
}
