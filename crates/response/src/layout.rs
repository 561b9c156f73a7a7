//! Other layouts of lists, put as lists with brackets and separators: LaTeX environments, rows by lines, entries parted
//! by spaces. All places stay.

use std::borrow::Cow;

use super::frame::groups;
use super::signs::{is_between_digits, is_digit};
use vibank_formula::unit::Unit;
use vibank_source::Span;

/// The text of a list with brackets and separators as they are read.
pub(crate) fn laid_out(text: &str) -> String {
    let (list, unit) = text.split_at(end_of_numbers(text));
    let list = angled(list).or_else(|| slashed(list));
    let list = list.map_or(Cow::Borrowed(&text[..text.len() - unit.len()]), Cow::Owned);
    let plain = rows_by_line(&without_latex(&list)).replace(" and ", " ;   ");
    without_brackets_of_unit(plain + unit)
}

/// `m 0 / 0 k` and `[m 0, 0 k]` with semicolons between their rows, as many rows as each has entries; all places stay.
fn slashed(text: &str) -> Option<String> {
    let start = text.find('=').map_or(0, |label| label + 1);
    let square = |(sign, semicolon, within): (&str, &str, &str)| {
        let rows: Vec<&str> = text[start..].split(sign).collect();
        let is_whole = |row: &&str| {
            let entries = row.split(|char: char| char.is_whitespace() || within.contains(char));
            entries.filter(|entry| !entry.is_empty()).count() == rows.len()
        };
        let is_square = rows.len() > 1 && rows.iter().all(is_whole);
        is_square.then(|| text[..start].to_owned() + &rows.join(semicolon))
    };
    // Between commas those within a row may be decimal signs.
    let signs = [(" / ", " ; ", ",;"), (", ", "; ", "")];
    signs.into_iter().find_map(square)
}

/// Where a list of numbers ends before its unit, `1 0\n0 2 kg`. Between letters its last one may be an entry.
fn end_of_numbers(text: &str) -> usize {
    let list = text.trim_end_matches(|last: char| !last.is_ascii_digit() && !"|>".contains(last));
    let unit = text[list.len()..].trim();
    let numbers = list.rsplit('=').next().unwrap_or(list);
    let is_unit = unit.starts_with(char::is_alphabetic) && Unit::read(unit).is_ok();
    if is_unit && !numbers.contains(char::is_alphabetic) {
        list.len()
    } else {
        text.len()
    }
}

/// `<<a|b>,<c|d>>` and `<a, b>` of Maple in square brackets: bars part the entries of a row, commas rows and the entries
/// of a column. Columns that bars part, `<<a,c>|<b,d>>`, are the rows of the transpose.
fn angled(text: &str) -> Option<String> {
    let start = text.find(['=', ':']).map_or(0, |label| label + 1);
    let list = text[start..].trim();
    let is_angled = list.starts_with('<') && list.ends_with('>') && !list.contains(['≤', '≥']);
    if !is_angled {
        return None;
    }
    let has_columns = list.split('>').any(|behind| {
        let next = behind.trim_start().strip_prefix('|');
        next.is_some_and(|next| next.trim_start().starts_with('<'))
    });
    if has_columns {
        return Some(format!("{}{}", &text[..start], by_columns(&text[start..])));
    }
    let signs = text[start..].chars().map(|char| match char {
        '<' => '[',
        '>' => ']',
        '|' => ',',
        char => char,
    });
    Some(text[..start].chars().chain(signs).collect())
}

/// `<<a,c>|<b,d>>` as `[ a,c ; b,d ]'`; all places stay.
fn by_columns(text: &str) -> String {
    let mut depth = 0_usize;
    let signs = text.chars().map(|char| match char {
        '<' => {
            depth += 1;
            if depth == 1 { '[' } else { ' ' }
        }
        '>' => {
            depth = depth.saturating_sub(1);
            if depth == 0 { '\'' } else { ' ' }
        }
        '|' if depth == 1 => ';',
        char => char,
    });
    let mut plain: String = signs.collect();
    // The bracket takes the place where the last column ends, before the sign of transposition.
    if let Some(last) = plain.rfind('\'')
        && plain[..last].ends_with(' ')
    {
        plain.replace_range(last - 1..last, "]");
    }
    plain
}

/// `[1 2; 3 4] [N/m]` without the brackets around its unit, which are not a list of their own.
fn without_brackets_of_unit(mut text: String) -> String {
    let inner = text
        .trim_end()
        .strip_suffix(']')
        .and_then(|text| text.rsplit_once('['));
    let Some((before, unit)) =
        inner.filter(|(before, _)| before.trim_end().ends_with([']', ')', '}']))
    else {
        return text;
    };
    let is_unit = unit.trim().starts_with(char::is_alphabetic) && Unit::read(unit).is_ok();
    let (open, close) = (before.len(), before.len() + 1 + unit.len());
    if is_unit {
        for bracket in [open, close] {
            text.replace_range(bracket..=bracket, " ");
        }
    }
    text
}

/// The text with brackets in place of those of LaTeX, `\left\{ a, b \right\}`, and of its environments,
/// `\begin{pmatrix} a & b \\ c & d \end{pmatrix}`.
pub(crate) fn without_latex(text: &str) -> Cow<'_, str> {
    if !text.contains('\\') {
        return Cow::Borrowed(text);
    }
    let mut plain = text.to_owned();
    for space in ["\\,", "\\;", "\\:", "\\!"] {
        plain = plain.replace(space, "  ");
    }
    without_outer_brackets(&mut plain);
    for (sign, bracket) in [("\\left", ""), ("\\right", ""), ("\\{", "{"), ("\\}", "}")] {
        plain = plain.replace(sign, &format!("{bracket:>0$}", sign.len()));
    }
    let has_bare_rows = plain.contains("\\\\") && plain.contains('&');
    if plain.contains("\\begin{") || has_bare_rows {
        environments(&mut plain);
    }
    binomials(&mut plain);
    Cow::Owned(plain)
}

/// Blanks the brackets right around an environment, `\left[\begin{array}…\end{array}\right]`: it stands for brackets
/// itself. Those within are of its entries.
fn without_outer_brackets(plain: &mut String) {
    let mut blank = |is_outer: &dyn Fn(&str, usize, usize) -> bool, delimiters: [&str; 2]| {
        for delimiter in delimiters {
            let places: Vec<usize> = plain.match_indices(delimiter).map(|(at, _)| at).collect();
            for at in places {
                let end = at + delimiter.len();
                if is_outer(plain, at, end) {
                    plain.replace_range(at..end, &" ".repeat(delimiter.len()));
                }
            }
        }
    };
    let opens = |text: &str, _: usize, end: usize| text[end..].trim_start().starts_with("\\begin{");
    let closes = |text: &str, at: usize, _: usize| {
        let before = text[..at].trim_end().strip_suffix('}');
        let command = before.and_then(|before| before.rsplit_once('{'));
        command.is_some_and(|(command, _)| command.ends_with("\\end"))
    };
    blank(&opens, ["\\left[", "\\left("]);
    blank(&closes, ["\\right]", "\\right)"]);
}

/// `\binom{1}{2}` as the column that it looks like.
fn binomials(plain: &mut String) {
    const COMMAND: &str = "\\binom";
    while let Some(start) = plain.find(COMMAND) {
        plain.replace_range(start..start + COMMAND.len(), &" ".repeat(COMMAND.len()));
        let groups = groups(plain, Span::new(start, plain.len()));
        let [upper, lower] = match groups[..] {
            [upper, lower, ..] => [upper.range(), lower.range()],
            _ => return,
        };
        if plain[upper.end..lower.start].trim().is_empty() {
            plain.replace_range(upper.start..=upper.start, "[");
            plain.replace_range(upper.end - 1..upper.end, ";");
            plain.replace_range(lower.start..=lower.start, " ");
            plain.replace_range(lower.end - 1..lower.end, "]");
        }
    }
}

fn environments(plain: &mut String) {
    *plain = plain.replace("\\cr", "\\\\ ");
    while let Some(start) = plain.find("\\\\") {
        // `[4pt]` says how far the next row is.
        let rest = &plain[start + 2..];
        let length = rest.strip_prefix('[').and_then(|rest| rest.split_once(']'));
        let length = length.map_or("", |(length, _)| length);
        let is_length = ["pt", "ex", "em", "mm", "cm"]
            .iter()
            .any(|unit| length.ends_with(unit));
        let skipped = if is_length { length.len() + 2 } else { 0 };
        plain.replace_range(
            start..start + 2 + skipped,
            &format!(";{}", " ".repeat(1 + skipped)),
        );
    }
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

/// A list with semicolons for the ends of lines between its rows, whose entries semicolons may part as well.
fn rows_by_line(text: &str) -> String {
    let text = barred_rows(text)
        .or_else(|| rows_by_comma(text))
        .unwrap_or_else(|| text.to_owned());
    let ends = |at: usize| {
        let is_blank = text[at + 1..].trim_start_matches(' ').starts_with('\n');
        if is_blank {
            return false;
        }
        let before = text[..at]
            .trim_end()
            .ends_with([',', ';', '&', '[', '(', '{', '=']);
        let after = text[at..]
            .trim_start()
            .starts_with([']', ')', '}', ',', ';']);
        !before && !after
    };
    let mut line_ends = text.match_indices('\n').map(|(at, _)| at);
    let mut commas = text.match_indices(',');
    let has_decimals = commas.all(|(at, _)| is_between_digits(&text, at));
    let inner = &text[text.find('=').map_or(0, |label| label + 1)..];
    let inner = inner.trim_start().strip_prefix(['[', '(']).unwrap_or(inner);
    let parts_entries = line_ends.any(&ends) && has_decimals && !inner.contains(['&', '[', '(']);
    let signs = text.char_indices().map(|(at, char)| match char {
        '\n' if ends(at) => ';',
        '\n' => ' ',
        ';' if parts_entries => '&',
        char => char,
    });
    signs.collect()
}

/// Rows of equal length in one pair of brackets whose lines end with commas, `[a, b,\n c, d]`, with semicolons for
/// these; nothing where a row has brackets of its own.
fn rows_by_comma(text: &str) -> Option<String> {
    let list = text[text.find('=').map_or(0, |label| label + 1)..].trim();
    let inner = list.strip_prefix(['[', '(']).unwrap_or(list);
    let inner = inner.strip_suffix([']', ')']).unwrap_or(inner).trim();
    let lines: Vec<&str> = inner.split('\n').map(str::trim_end).collect();
    let (last, rows) = lines.split_last()?;
    let count = |row: &str| row.split(',').count();
    let is_row = |row: &&str| {
        row.strip_suffix(',')
            .is_some_and(|row| count(row) == count(last))
    };
    let is_it = count(last) > 1 && !rows.is_empty() && rows.iter().all(is_row);
    let row = |line: &str| match line.trim_end().strip_suffix(',') {
        Some(row) => format!("{row};{}", &line[row.len() + 1..]),
        None => line.to_owned(),
    };
    let rows = || text.split('\n').map(row).collect::<Vec<_>>().join("\n");
    (is_it && !inner.contains(['[', ';', '&'])).then(rows)
}

/// Rows between bars, as programs draw them, in brackets, behind a symbol and an equals sign; nothing where not all lines
/// are so.
fn barred_rows(text: &str) -> Option<String> {
    let (label, text) = text.split_at(text.find('=').map_or(0, |label| label + 1));
    let rows = text.split('\n').map(|line| {
        let inner = line.trim().strip_prefix('|')?.strip_suffix('|')?;
        let start = line.len() - line.trim_start().len();
        // The rule below the head of a table of Markdown.
        if inner.contains('-') && inner.chars().all(|char| "-:| ".contains(char)) {
            return Some(" ".repeat(line.len()));
        }
        let inner = inner.replace('|', ",");
        let (before, after) = (&line[..start], &line[start + inner.len() + 2..]);
        Some(format!("{before}[{inner}]{after}"))
    });
    let rows: Vec<String> = rows.collect::<Option<_>>()?;
    (rows.len() > 1).then(|| label.to_owned() + &rows.join("\n"))
}

/// The same list with `&` for each space that parts entries, as in `[1 -2; 0 3]`. A space parts two values, and a value
/// from a sign that stands at the next one; beside a list in brackets it parts nothing but such lists.
pub(crate) fn spaced(text: &str) -> String {
    let (text, unit) = text.split_at(end_of_numbers(text));
    let inner = parted(text, |depth, _, _| depth > 0);
    let whole = Span::new(0, text.len());
    let has_list = groups(&inner, whole)
        .iter()
        .any(|group| inner[group.range()].contains([',', ';', '&']));
    let plain = parted(&inner, |depth, before, next| {
        depth == 0 && (!has_list || ")]}".contains(before) && "([{".contains(next))
    });
    plain + unit
}

/// Whether a sign stands at the number after a space, where commas may be decimal signs.
pub(crate) fn has_signed_gap(text: &str) -> bool {
    let mut commas = text.match_indices(',');
    let spaces = text.match_indices(' ');
    let mut gaps = spaces.filter_map(|(at, _)| entries_around(text, at));
    commas.any(|(at, _)| is_between_digits(text, at))
        && gaps.any(|(before, next)| is_digit(before) && "+-".contains(next))
}

/// The text with `&` for spaces between entries where it may stand, by the depth of brackets and the signs around.
fn parted(text: &str, may: impl Fn(usize, char, char) -> bool) -> String {
    // For each open bracket whether it may hold entries: none within another but in square ones, no argument.
    let mut open: Vec<bool> = Vec::new();
    let mut plain = String::with_capacity(text.len());
    for (at, char) in text.char_indices() {
        match char {
            '(' | '[' | '{' => {
                let before = text[..at].trim_end_matches(|char: char| char.is_ascii_alphabetic());
                let is_call = text[..at].len() > before.len() + 1;
                open.push(!is_call && (open.is_empty() || char != '('));
            }
            ')' | ']' | '}' => {
                open.pop();
            }
            _ => {}
        }
        let around = Some(char).filter(|char| char.is_whitespace());
        let around = around.and_then(|_| entries_around(text, at));
        let parts = open.last().is_none_or(|holds| *holds)
            && around.is_some_and(|(before, next)| may(open.len(), before, next));
        if parts {
            plain.push('&');
            plain.extend((1..char.len_utf8()).map(|_| ' '));
        } else {
            plain.push(char);
        }
    }
    plain
}

/// The signs around the space at a place where it stands between two entries.
fn entries_around(text: &str, at: usize) -> Option<(char, char)> {
    let before = text[..at].chars().next_back()?;
    // Within a run of spaces nothing is looked for.
    let ends = before.is_alphanumeric() || ")]}²³'.".contains(before);
    if !ends {
        return None;
    }
    let mut after = text[at..].trim_start().chars();
    let (next, second) = (after.next()?, after.next());
    let begins = |char: char| char.is_alphanumeric() || "([{√\\.".contains(char);
    let is_signed = "+-".contains(next) && second.is_some_and(begins);
    (begins(next) || is_signed).then_some((before, next))
}
