//! Time derivatives as quotients of differentials, `dx/dt`, `\frac{d^2 x}{dt^2}`, and as functions, `diff(x, t, 2)`.

use super::letters::{Letters, combining, dotted, greek_word, letter, name_of_command};
use crate::signs::is_of_name;
use vibank_formula::work;

/// Reads a quotient of differentials at a place, `dx/dt`, `(d^2 x)/(d t^2)`, `{dx}/{dt}`: spelling of the name, order, end.
pub(crate) fn leibniz(text: &str, at: usize) -> Option<(String, u8, usize)> {
    let mut scanner = Differentials::over_time(text, at);
    let (is_fraction, spelling, order) = scanner.quotient()?;
    let goes_on = scanner.text[scanner.at..]
        .starts_with(|next: char| next.is_ascii_alphanumeric() || next == '_');
    let is_closed = is_fraction || scanner.text[..scanner.at].ends_with([')', '}']);
    (!goes_on || is_closed).then_some((spelling, order, scanner.at))
}

/// Whether a text is a quotient of differentials by any letter, `dV/dθ`, `\frac{d^2V}{d\theta^2}`.
pub(crate) fn is_quotient(text: &str) -> bool {
    let mut scanner = Differentials {
        is_over_time: false,
        ..Differentials::over_time(text, 0)
    };
    scanner.quotient().is_some() && scanner.at == text.len()
}

/// The order of the operator of a time derivative that begins at a place and comes before a bracket, `d/dt (m x')`,
/// `d²/dt² (x + y)`, and where it ends.
pub(crate) fn operator(text: &str, at: usize) -> Option<(u8, usize)> {
    let mut scanner = Differentials::over_time(text, at);
    let order = scanner.operator()?;
    let behind = text[scanner.at..].trim_start();
    let behind = behind.strip_prefix("\\left").unwrap_or(behind);
    behind
        .starts_with(['(', '['])
        .then_some((order, scanner.at))
}

/// Reads a derivative whose name comes after the operator, `d/dt(x)`, `\frac{d}{dt}\left(\frac{dx}{dt}\right)`,
/// `\frac{d^2}{dt^2} x`, `(d/dt)^2 x`: spelling of the name, order, end.
pub(crate) fn behind(text: &str, at: usize) -> Option<(String, u8, usize)> {
    // Longer than any name with its subscripts: a bracket that closes later belongs to something else.
    const MAX_LENGTH: usize = 80;
    // Equations of motion have accelerations and nothing above; markers have room for two derivatives of a
    // name.
    const MAX_ORDER: u8 = 2;
    let mut scanner = Differentials::over_time(text, at);
    let order = scanner.operator()?;
    let is_sized = scanner.take("\\left");
    let rest = &text[scanner.at..];
    let (inner, end) = match rest.trim_start().strip_prefix('(') {
        Some(inner) => {
            let start = text.len() - inner.len();
            let close = closing(inner, MAX_LENGTH)?;
            let inner = inner[..close].trim();
            let inner = if is_sized {
                inner.strip_suffix("\\right")?.trim_end()
            } else {
                inner
            };
            (inner, start + close + 1)
        }
        None => {
            let trimmed = rest.trim_start();
            let length = length_of_name(trimmed);
            let length = Some(length).filter(|length| *length < MAX_LENGTH)?;
            (&trimmed[..length], text.len() - trimmed.len() + length)
        }
    };
    let (spelling, inner_order) = match leibniz(inner, 0) {
        Some((spelling, own, length)) if length == inner.len() => (spelling, own),
        _ => dotted_spelling(inner)?,
    };
    let order = order + inner_order;
    (order <= MAX_ORDER).then_some((spelling, order, end))
}

/// Reads a derivative by the letter of an operator, `Dx`, `D² x_1`: spelling of the name, order, end.
pub(crate) fn by_operator(text: &str, at: usize) -> Option<(String, u8, usize)> {
    let mut scanner = Differentials::over_time(text, at);
    if !scanner.take("D") {
        return None;
    }
    let order = scanner.raised_order();
    let name = scanner.text[scanner.at..].trim_start();
    let length = length_of_name(name);
    let spelling = Letters::spelling(&name[..length])?;
    Some((spelling, order, text.len() - name.len() + length))
}

/// The length of the name with which a text begins.
fn length_of_name(text: &str) -> usize {
    let is_part = |char| is_of_name(char) || "{}\\".contains(char);
    text.find(|char| !is_part(char)).unwrap_or(text.len())
}

/// The spelling of a name that may have dots or primes of its own, `x'`, `\dot x`, and how many.
fn dotted_spelling(name: &str) -> Option<(String, u8)> {
    let name = name.trim();
    let commands = [("\\ddot", 2), ("\\dot", 1)];
    if let Some((inner, order)) = commands
        .iter()
        .find_map(|(command, order)| Some((name.strip_prefix(command)?, *order)))
    {
        let inner = inner.trim().trim_start_matches('{').trim_end_matches('}');
        return Some((spelling(inner)?, order));
    }
    let name = name
        .strip_prefix('(')
        .and_then(|name| name.strip_suffix(')'))
        .unwrap_or(name);
    let bare = name.trim_end_matches('\'');
    let mut order = u8::try_from(name.len() - bare.len()).ok()?;
    let mut plain = String::new();
    for char in bare.chars() {
        match (dotted(char), combining(char)) {
            (Some((letter, dots)), _) => {
                plain.push(letter);
                order += dots;
            }
            (None, Some(dots)) => order += dots,
            (None, None) => plain.push(char),
        }
    }
    Some((spelling(&plain)?, order))
}

/// The spelling of a name, `x_1`, `\theta`, `x(t)`.
pub(crate) fn spelling(name: &str) -> Option<String> {
    let name = name.trim();
    let bracketed = name
        .strip_prefix('(')
        .and_then(|name| name.strip_suffix(')'));
    let name = bracketed.unwrap_or(name);
    let name = name.strip_suffix("(t)").unwrap_or(name);
    let Some(word) = name.strip_prefix('\\') else {
        return Letters::spelling(name);
    };
    let command = name_of_command(name);
    let index = match &word[command.len()..] {
        "" => String::new(),
        index => Letters::spelling(index)?,
    };
    Some(greek_word(command)?.to_owned() + &index)
}

/// What derivatives are called.
const CALLS: [&str; 6] = ["dot", "ddot", "diff", "Diff", "D", "Derivative"];

/// Reads a derivative that is written as a function at a place, `diff(x, t, 2)`, `ddot(x1)`: spelling of the name,
/// order, end.
pub(crate) fn called(text: &str, at: usize) -> Option<(String, u8, usize)> {
    // As above, with the time and the order beside the name.
    const MAX_LENGTH: usize = 80;
    let rest = &text[at..];
    // `ddot x1`
    let bare = [("ddot ", 2), ("dot ", 1)];
    if let Some((word, order)) = bare.iter().find(|(word, _)| rest.starts_with(word)) {
        let name = rest[word.len()..].trim_start();
        let end = name.len() - name.trim_start_matches(is_of_name).len();
        let length = rest.len() - name.len() + end;
        return Some((Letters::spelling(&name[..end])?, *order, at + length));
    }
    let (name, inner) = CALLS.iter().find_map(|name| {
        let inner = rest.strip_prefix(name)?.strip_prefix(['(', '['])?;
        Some((*name, inner))
    })?;
    let dots = match name {
        "dot" => Some(1),
        "ddot" => Some(2),
        _ => None,
    };
    let close = closing(inner, MAX_LENGTH)?;
    let whole = &inner[..close];
    // `diff(diff(x, t), t)`
    let (spelling, own, behind) = match called(whole, 0) {
        Some((spelling, own, end)) => (spelling, own, &whole[end..]),
        None => {
            let end = whole.find(',').unwrap_or(whole.len());
            let name = whole[..end].trim();
            let times = ["(t)", "[t]"];
            let bare = times.iter().find_map(|time| name.strip_suffix(time));
            (Letters::spelling(bare.unwrap_or(name))?, 0, &whole[end..])
        }
    };
    let by: Vec<&str> = match behind.trim_start().strip_prefix(',') {
        Some(by) => by.split(',').map(str::trim).collect(),
        None if behind.trim().is_empty() => Vec::new(),
        None => return None,
    };
    let order = match (dots, &by[..]) {
        (Some(order), []) => order,
        (None, []) if matches!(name, "diff" | "D") => 1,
        (None, ["2"]) if name == "diff" => 2,
        (None, by) => order_by(by)?,
        _ => return None,
    };
    let order = own + order;
    let end = at + name.len() + 1 + close + 1;
    // `(D@@2)(x)(t)`
    let is_of_time = ["(t)", "[t]"]
        .iter()
        .any(|time| text[end..].starts_with(time));
    let time = if is_of_time { "(t)".len() } else { 0 };
    (order <= 2).then_some((spelling, order, end + time))
}

/// Reads a derivative that is written as a method at a place, `x.diff(t, 2)`, `x(t).diff(t)`: spelling of the name,
/// order, end.
pub(crate) fn method(text: &str, at: usize) -> Option<(String, u8, usize)> {
    const CALL: &str = ".diff(";
    // The time, and the order.
    const MAX_LENGTH: usize = 20;
    let rest = &text[at..];
    let name = &rest[..rest.find(|char| !is_of_name(char))?];
    let behind = &rest[name.len()..];
    let inner = behind
        .strip_prefix("(t)")
        .unwrap_or(behind)
        .strip_prefix(CALL)?;
    let close = closing(inner, MAX_LENGTH)?;
    let arguments: Vec<&str> = inner[..close].split(',').map(str::trim).collect();
    let start = text.len() - inner.len();
    Some((
        Letters::spelling(name)?,
        order_by(&arguments)?,
        start + close + 1,
    ))
}

/// The order of a derivative by what it is taken by: `t`, `t, t`, `t, 2`.
fn order_by(arguments: &[&str]) -> Option<u8> {
    match arguments {
        ["t"] => Some(1),
        ["t", "t" | "2"] | ["(t", "2)"] | ["{t", "2}"] | ["t$2"] => Some(2),
        _ => None,
    }
}

/// Where the bracket closes that stands open before a text, if that is before so many bytes.
fn closing(text: &str, before: usize) -> Option<usize> {
    let text = &text[..text.floor_char_boundary(before)];
    let _ = work::spend(text.len() as u64 / 8);
    let mut depth = 0_i32;
    text.find(|char: char| {
        depth += match char {
            '(' | '[' => 1,
            ')' | ']' => -1,
            _ => 0,
        };
        depth < 0
    })
}

struct Differentials<'a> {
    text: &'a str,
    at: usize,
    /// Whether derivatives are by the time alone, and not by any letter.
    is_over_time: bool,
}

impl<'a> Differentials<'a> {
    fn over_time(text: &'a str, at: usize) -> Self {
        Self {
            text,
            at,
            is_over_time: true,
        }
    }

    /// A whole quotient: whether it is a fraction of LaTeX, the spelling of its name, and its order.
    fn quotient(&mut self) -> Option<(bool, String, u8)> {
        let group = self.opening();
        let is_fraction = group.is_none() && self.fraction();
        self.differential()?;
        let order = self.order();
        let (spelling, own) = self.name()?;
        if group.is_some_and(|close| !self.take(close)) {
            return None;
        }
        self.divisor(is_fraction, order)?;
        Some((is_fraction, spelling, order + own))
    }

    fn take(&mut self, word: &str) -> bool {
        let rest = &self.text[self.at..];
        let trimmed = rest.trim_start();
        let found = trimmed.starts_with(word);
        if found {
            self.at += rest.len() - trimmed.len() + word.len();
        }
        found
    }

    /// Whether a fraction of LaTeX begins here.
    fn fraction(&mut self) -> bool {
        let commands = ["\\frac", "\\dfrac", "\\tfrac"];
        commands.iter().any(|command| self.take(command)) && self.take("{")
    }

    /// The bracket or brace that opens a group here; what closes it.
    fn opening(&mut self) -> Option<&'static str> {
        let groups = [("(", ")"), ("{", "}")];
        let found = groups.iter().find(|(open, _)| self.take(open));
        found.map(|(_, close)| *close)
    }

    /// An operator without its name, `d/dt`, `(d^2)/(dt^2)`, `(d/dt)^2`: its order.
    fn operator(&mut self) -> Option<u8> {
        let group = self.opening();
        let is_fraction = self.fraction();
        self.differential()?;
        let order = self.order();
        let is_numerator = group.is_some_and(|close| self.take(close));
        self.divisor(is_fraction, order)?;
        match group {
            Some(close) if !is_numerator => {
                let is_closed = self.take(close);
                is_closed.then(|| order * self.raised_order())
            }
            _ => Some(order),
        }
    }

    /// The divisor of a derivative of this order, `dt^2`, `(d t^2)`, `(dt)^2`.
    fn divisor(&mut self, is_fraction: bool, order: u8) -> Option<()> {
        let is_over = if is_fraction {
            self.take("}") && self.take("{")
        } else {
            self.take("/")
        };
        if !is_over {
            return None;
        }
        let group = if is_fraction { None } else { self.opening() };
        self.differential()?;
        if !self.take("t") && (self.is_over_time || !self.letter()) {
            return None;
        }
        let mut own = self.order();
        if let Some(close) = group {
            if !self.take(close) {
                return None;
            }
            own *= if own < order { self.raised_order() } else { 1 };
        }
        (own == order && (!is_fraction || self.take("}"))).then_some(())
    }

    /// Whether a letter stands here, or the command of one.
    fn letter(&mut self) -> bool {
        let rest = self.text[self.at..].trim_start();
        let Some((length, _)) = letter(rest.trim_start_matches('\\')) else {
            return false;
        };
        let command = usize::from(rest.starts_with('\\'));
        self.at = self.text.len() - rest.len() + command + length;
        true
    }

    fn differential(&mut self) -> Option<()> {
        let signs = ["\\mathrm{d}", "\\mathrm d", "\\partial", "∂", "d"];
        let found = signs.iter().any(|sign| self.take(sign));
        found.then_some(())
    }

    fn order(&mut self) -> u8 {
        if self.take("2") {
            2
        } else {
            self.raised_order()
        }
    }

    /// Two where a square stands here.
    fn raised_order(&mut self) -> u8 {
        let is_second = ["²", "^{2}", "^2"].iter().any(|sign| self.take(sign));
        if is_second { 2 } else { 1 }
    }

    /// A name up to the slash, brace or bracket, and its own dots.
    fn name(&mut self) -> Option<(String, u8)> {
        // Each `d` of a response is tried as the beginning of a derivative: without a bound each would be
        // read to the end.
        const MAX_LENGTH: usize = 80;
        let rest = &self.text[self.at..];
        let mut depth = 0_usize;
        let is_end = |(_, char): &(usize, char)| match char {
            '{' | '(' => {
                depth += 1;
                false
            }
            '}' | ')' if depth > 0 => {
                depth -= 1;
                false
            }
            char => matches!(char, '/' | '}' | ')'),
        };
        let (end, _) = rest.char_indices().take(MAX_LENGTH).find(is_end)?;
        let found = dotted_spelling(&rest[..end])?;
        self.at += end;
        Some(found)
    }
}
