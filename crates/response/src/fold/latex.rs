//! Commands of LaTeX in what is folded: environments, faces, wrappers, units.

use super::Folder;
use crate::letters::greek_word;
use crate::signs::{
    CASES, COMMANDS, DISPLAYS, FACES, NUMBERED, UNITS, WRAPPERS, escaped, is_minus,
};
use crate::words::{JOINING, STATEMENTS};
use vibank_dynamics::numerics::sort_by;

/// How the rows of an environment are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Environment {
    /// As statements.
    Display,
    /// As statements with conditions.
    Cases,
    /// As those of a matrix.
    Matrix,
}

impl Environment {
    fn of_name(name: &str) -> Self {
        let name = name.trim_end_matches('*');
        if DISPLAYS.contains(&name) {
            Self::Display
        } else if CASES.contains(&name) {
            Self::Cases
        } else {
            Self::Matrix
        }
    }
}

impl Folder<'_> {
    /// Writes what a sign of alignment stands for in an environment that is not a matrix; whether it stands in one.
    pub(crate) fn alignment(&mut self) -> bool {
        let is_open = matches!(
            self.open.last(),
            Some(Environment::Matrix | Environment::Cases)
        );
        if !is_open && self.rest()[1..].trim_start().starts_with('=') {
            self.write(" ", 1);
            return true;
        }
        let is_parted = self.text.trim_end().ends_with([',', ';']);
        match self.open.last() {
            Some(Environment::Display) => self.write(" ", 1),
            Some(Environment::Cases) if is_parted => self.write(" ", 1),
            Some(Environment::Cases) => self.write(",", 1),
            Some(Environment::Matrix) | None => return false,
        }
        true
    }

    /// `{a \over b}`, the fraction of plain TeX, as `{(a)/(b)}`; whether one of its signs stands here.
    pub(crate) fn fraction(&mut self, sign: char) -> bool {
        const OVER: &str = "\\over";
        if !self.has_over {
            return false;
        }
        match sign {
            '{' => {
                let parts = parts_of_group(&self.typed[self.at + 1..], OVER);
                let Some((over, close)) = parts else {
                    return false;
                };
                let start = self.at + 1;
                self.overs.push((start + over, start + close));
                self.write("{(", 1);
            }
            '}' if self.overs.iter().any(|(_, close)| *close == self.at) => self.write(")}", 1),
            '\\' if self.overs.iter().any(|(over, _)| *over == self.at) => {
                self.write(")/(", OVER.len());
            }
            _ => return false,
        }
        true
    }

    /// The end of a row. One that goes on with a sign is the same statement.
    fn row(&mut self) {
        let next = self.rest()[2..].trim_start_matches([' ', '&', '\n']);
        // Lines of statements outside of all environments.
        let is_line = self.open.is_empty()
            && next.contains('=')
            && self.text.contains('=')
            && !(self.typed.contains('&') || self.typed.contains('['));
        match self.open.last() {
            None if is_line => self.write("\n", 2),
            Some(Environment::Display) if next.starts_with(['=', '+', '-']) => self.write(" ", 2),
            Some(Environment::Display | Environment::Cases) => self.write("\n", 2),
            Some(Environment::Matrix) | None => self.write("\\\\", 2),
        }
    }

    /// Opens or closes an environment; whether one stands here that is not a matrix.
    fn environment(&mut self, name: &str) -> bool {
        let start = 1 + name.len();
        let inner = self.rest()[start..].strip_prefix('{');
        let Some((own, _)) = inner.and_then(|inner| inner.split_once('}')) else {
            return false;
        };
        let (length, environment) = (start + own.len() + 2, Environment::of_name(own));
        if name == "begin" {
            self.open.push(environment);
        } else {
            self.open.pop();
        }
        let is_statement = environment != Environment::Matrix;
        if is_statement {
            self.write(" ", length);
        }
        is_statement
    }

    /// Whether the wide space of this length parts two equations: `z = 0 \\quad x^2 + y^2 = 1`.
    fn parts_statements(&self, length: usize) -> bool {
        let before = self.text.trim_end();
        let own = before.rsplit([';', '\n']).next().unwrap_or(before);
        let behind = self.rest()[length..].trim_start();
        let next = behind.split("\\quad").next().unwrap_or(behind);
        let command = next.strip_prefix('\\').map(|rest| {
            let end = rest.find(|char: char| !char.is_ascii_alphabetic());
            &rest[..end.unwrap_or(rest.len())]
        });
        let begins = match command {
            Some(name) => {
                greek_word(name).is_some() || matches!(name, "dot" | "ddot" | "sqrt" | "frac")
            }
            None => next.starts_with(char::is_alphabetic),
        };
        let is_whole =
            before.ends_with(|last: char| last.is_alphanumeric() || ")]}'".contains(last));
        self.open.iter().all(|open| *open == Environment::Display)
            && is_whole
            && own.contains('=')
            && begins
            && next.contains('=')
    }

    pub(crate) fn command(&mut self) {
        let typed = self.typed;
        let behind = &typed[self.at + 1..];
        let name: &str = &behind[..behind
            .find(|char: char| !char.is_ascii_alphabetic())
            .unwrap_or(behind.len())];
        let Some(first) = behind.chars().next() else {
            return self.write("\\", 1);
        };
        if name.is_empty() {
            match (first, escaped(first)) {
                // A new row of a matrix.
                ('\\', _) => self.row(),
                ('[', _) if self.escaped_greek() => {}
                // Displayed formulas.
                ('(' | ')' | '[' | ']', _) => self.write(" ", 2),
                (_, Some(plain)) => self.plain(plain, 1 + first.len_utf8()),
                (_, None) => self.write("\\", 1),
            }
            return;
        }
        let length = 1 + name.len();
        if matches!(name, "frac" | "dfrac" | "tfrac" | "cfrac")
            && let Some((fraction, length)) = bare_fraction(&typed[self.at + length..])
        {
            return self.write(&fraction, 1 + name.len() + length);
        }
        // Options, `\SI[per-mode=symbol]{…}`, say how it is set.
        let option = self.typed[self.at + length..].strip_prefix('[');
        let option = option.and_then(|option| Some(option.find(']')? + 2));
        if let Some((_, count)) = WRAPPERS.iter().find(|(own, _)| *own == name)
            && let Some(braces) = self.arguments(self.at + length + option.unwrap_or(0), *count)
        {
            let length = length + option.unwrap_or(0);
            self.blanked.extend(braces);
            return self.write("", length);
        }
        if FACES.contains(&name)
            && let Some(braces) = self.arguments(self.at + length, 1)
            && is_unlettered(&self.typed[braces[0] + 1..braces[1]])
        {
            self.blanked.extend(braces);
            return self.write(" ", length);
        }
        // A line under a whole answer, or under one side of it; under a letter it makes a vector of it.
        if name == "underline"
            && let Some(braces) = self.arguments(self.at + length, 1)
            && is_whole(&self.typed[braces[0] + 1..braces[1]])
        {
            self.blanked.extend(braces);
            return self.write(" ", length);
        }
        if matches!(name, "dv" | "pdv" | "derivative") && self.quotient(length) {
            return;
        }
        if name == "angle"
            && self.typed[self.at + length..].starts_with('{')
            && let Some(braces) = self.arguments(self.at + length, 1)
        {
            self.blanked.extend(braces);
            return self.write("∠", length);
        }
        if NUMBERED.contains(&name)
            && let Some(braces) = self.arguments(self.at + length, 1)
        {
            return self.write(" ", braces[1] + 1 - self.at);
        }
        if matches!(name, "begin" | "end") && self.environment(name) {
            return;
        }
        if matches!(name, "quad" | "qquad") && self.parts_statements(length) {
            return self.write(";", length);
        }
        if name == "propto" && self.is_before_list(length) {
            return self.write("=", length);
        }
        if let Some((_, unit)) = UNITS.iter().find(|(own, _)| *own == name) {
            return self.write(unit, length);
        }
        if matches!(name, "text" | "mathrm" | "mbox" | "operatorname")
            && let Some(braces) = self.arguments(self.at + length, 1)
            && [JOINING, STATEMENTS]
                .iter()
                .any(|words| words.contains(&self.typed[braces[0] + 1..braces[1]].trim()))
            // `\omega_\mathrm{in}` has an index.
            && !self.text.trim_end().ends_with(['_', '{'])
        {
            self.blanked.extend(braces);
            return self.write(" ", length);
        }
        match COMMANDS.iter().find(|(own, _)| *own == name) {
            Some((_, plain)) => self.plain(*plain, length),
            None => {
                let kept = self.rest()[..length].to_owned();
                self.write(&kept, length);
            }
        }
    }
}

/// Whether what is set in another face is a number, perhaps with its unit, an equation, or nothing.
fn is_unlettered(text: &str) -> bool {
    let text = text.trim_matches([' ', '~']);
    if text.contains('=') {
        return true;
    }
    // A line under a line.
    let text = text.strip_prefix("\\underline{").unwrap_or(text);
    text.is_empty()
        || text.starts_with(|char: char| {
            char.is_ascii_digit() || "+.".contains(char) || is_minus(char)
        })
}

impl Folder<'_> {
    /// `\dv[2]{x}{t}`, the derivative of the package physics, as a quotient; whether one stands here.
    fn quotient(&mut self, length: usize) -> bool {
        let typed = self.typed;
        let rest = &typed[self.at + length..];
        let order = rest.strip_prefix('[').and_then(|rest| rest.split_once(']'));
        let order = order.map(|(order, _)| order);
        let option = order.map_or(0, |order| order.len() + 2);
        let Some(braces) = self.arguments(self.at + length + option, 2) else {
            return false;
        };
        let (of, by) = (
            &typed[braces[0] + 1..braces[1]],
            &typed[braces[2] + 1..braces[3]],
        );
        let is_name = |text: &str| {
            text.chars()
                .all(|char| char.is_alphanumeric() || "\\_{}".contains(char))
        };
        if !is_name(of) || !is_name(by) {
            return false;
        }
        let power = order.map_or(String::new(), |order| format!("^{{{order}}}"));
        let quotient = format!("\\frac{{d{power} {of}}}{{d{by}{power}}}");
        self.write(&quotient, braces[3] + 1 - self.at);
        true
    }
}

/// `\frac` with one sign for a part, `\frac12` and `\frac d5`, in braces, and how long those parts are.
fn bare_fraction(text: &str) -> Option<(String, usize)> {
    let (above, rest) = sign_of_part(text)?;
    match sign_of_part(rest) {
        Some((below, rest)) => Some((
            format!("\\frac{{{above}}}{{{below}}}"),
            text.len() - rest.len(),
        )),
        None => Some((format!("\\frac{{{above}}}"), text.len() - rest.len())),
    }
}

/// The letter, digit or command that is an argument without braces, and what comes after it.
fn sign_of_part(text: &str) -> Option<(&str, &str)> {
    let own = text.trim_start();
    let first = own.chars().next()?;
    let length = match first {
        '\\' => {
            let name = &own[1..];
            let end = name.find(|char: char| !char.is_ascii_alphabetic());
            let end = end.unwrap_or(name.len());
            greek_word(&name[..end])?;
            1 + end
        }
        first if first.is_alphanumeric() => first.len_utf8(),
        _ => return None,
    };
    Some(own.split_at(length))
}

impl Folder<'_> {
    /// `{\ddot x}_1`, as some programs set the index of a rate, without the braces.
    pub(crate) fn dotted_group(&mut self) -> bool {
        let rest = self.rest();
        let group = rest.strip_prefix('{').and_then(|rest| rest.split_once('}'));
        let Some((inner, behind)) = group.filter(|(_, behind)| behind.starts_with('_')) else {
            return false;
        };
        let dots = ["\\ddot", "\\dot"]
            .iter()
            .find(|dots| inner.starts_with(**dots));
        let Some(letter) = dots.map(|dots| &inner[dots.len()..]) else {
            return false;
        };
        let is_letter = sign_of_part(letter).is_some_and(|(_, rest)| rest.trim().is_empty());
        if is_letter {
            let (plain, length) = (inner.to_owned(), rest.len() - behind.len());
            self.write(&plain, length);
        }
        is_letter
    }
}

/// Whether more than a letter is underlined: a statement, or a formula.
fn is_whole(text: &str) -> bool {
    let inner = text
        .trim()
        .strip_prefix("\\underline{")
        .and_then(|text| text.strip_suffix('}'));
    let text = inner.unwrap_or(text);
    text.contains(['=', '≈', '+', '-', '/', '^', '*', '(', '&'])
        || text.contains("\\frac")
        || text.contains("\\sqrt")
        || text.contains("\\cdot")
}

/// Where a command parts the group that stands open before a text, and where that closes; `None` where it stands not
/// there, or more than once.
fn parts_of_group(inner: &str, command: &str) -> Option<(usize, usize)> {
    let (mut depth, mut parts) = (0_usize, None);
    for (at, char) in inner.char_indices() {
        match char {
            '{' => depth += 1,
            '}' if depth == 0 => return Some((parts?, at)),
            '}' => depth -= 1,
            '\\' if depth == 0 => {
                let behind = inner[at..].strip_prefix(command);
                let is_command =
                    behind.is_some_and(|behind| !behind.starts_with(char::is_alphabetic));
                if is_command && parts.replace(at).is_some() {
                    return None;
                }
            }
            _ => {}
        }
    }
    None
}

/// Where each brace of a text opens, and where its partner closes; ascending.
fn partners(text: &str) -> Vec<(usize, usize)> {
    let (mut open, mut found) = (Vec::new(), Vec::new());
    for (at, byte) in text.bytes().enumerate() {
        match byte {
            b'{' => open.push(at),
            b'}' => found.extend(open.pop().map(|start| (start, at))),
            _ => {}
        }
    }
    sort_by(&mut found, Ord::cmp);
    found
}

impl Folder<'_> {
    /// The places of the braces around the next `count` arguments.
    fn arguments(&self, from: usize, count: usize) -> Option<Vec<usize>> {
        let partners = self.partners.get_or_init(|| partners(self.typed));
        let (mut braces, mut at) = (Vec::new(), from);
        for _ in 0..count {
            let rest = self.typed.get(at..)?;
            let open = at + rest.len() - rest.trim_start().len();
            let place = partners
                .binary_search_by_key(&open, |(open, _)| *open)
                .ok()?;
            let close = partners[place].1;
            braces.extend([open, close]);
            at = close + 1;
        }
        Some(braces)
    }
}
