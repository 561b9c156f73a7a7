//! What programs write, in what is folded: powers of ten, rules, calls, letters and constants of their own.

use super::Folder;
use crate::letters::greek_word;
use crate::signs::{is_digit, is_minus, is_of_name};
use crate::words::EQUATIONS;

impl Folder<'_> {
    /// What stands here after a digit and is read otherwise there: the power of ten of Mathematica, the points of a
    /// decimal that goes on.
    pub(crate) fn beside_digits(&self) -> Option<(usize, &'static str)> {
        if !self.typed[..self.at].ends_with(|char| is_digit(char) || char == '.') {
            return None;
        }
        let rest = self.rest();
        if let Some(power) = rest.strip_prefix("*^") {
            let is_power =
                power.starts_with(|char| is_digit(char) || char == '+' || is_minus(char));
            return is_power.then_some((2, "e"));
        }
        let points = ["...", "…"]
            .into_iter()
            .find(|sign| rest.starts_with(sign))?;
        let behind = &rest[points.len()..];
        let goes_on = behind.starts_with(|char| is_digit(char) || ".,;".contains(char));
        // The period of a sentence may follow.
        (!goes_on || behind.trim_end() == ".").then_some((points.len(), ""))
    }

    /// The length of a sign that only programs write: the one after the argument of `x[t_]`, that before the constant
    /// `_C1` of Maple, the brackets of `C[1]`.
    pub(crate) fn silent(&self) -> Option<usize> {
        let (before, rest) = (&self.typed[..self.at], self.rest());
        let is_in_name = |char: char| char.is_alphanumeric() || ")]}_".contains(char);
        let is_silent = if let Some(behind) = rest.strip_prefix('_') {
            behind.starts_with(']') || behind.starts_with('C') && !before.ends_with(is_in_name)
        } else if let Some(behind) = rest.strip_prefix('[') {
            let own = before
                .strip_suffix('C')
                .filter(|own| !own.ends_with(is_in_name));
            own.is_some() && behind.starts_with(is_digit) && behind[1..].starts_with(']')
        } else if rest.starts_with(']') {
            let inner = before
                .strip_suffix(is_digit)
                .and_then(|own| own.strip_suffix("C["));
            inner.is_some_and(|own| !own.ends_with(is_in_name))
        } else {
            false
        };
        is_silent.then_some(1)
    }

    /// `x(t) -> …`, as Mathematica gives solutions; whether its arrow stands here.
    pub(crate) fn is_rule(&self) -> bool {
        let before = self.typed[..self.at].trim_end();
        (self.rest().starts_with("->") || self.rest().starts_with('→'))
            && (before.ends_with([']', ')']) || self.typed[..self.answer.start].ends_with('{'))
    }

    /// `Eq(a, b)`: what its brackets become spaces for; whether it stands here.
    pub(crate) fn equation(&mut self) -> bool {
        let rest = self.rest();
        if self.typed[..self.at].ends_with(is_of_name) {
            return false;
        }
        let call = EQUATIONS.iter().find_map(|name| {
            let inner = rest.strip_prefix(*name)?.strip_prefix('(')?;
            Some((name.len(), inner))
        });
        let Some((length, inner)) = call else {
            return false;
        };
        let (close, commas) = arguments_of_call(inner);
        let (Some(close), [comma]) = (close, &commas[..]) else {
            return false;
        };
        let start = self.at + length + 1;
        self.equals.push((start + comma, 1));
        self.blanked.push(start + close);
        self.write(" ", length + 1);
        true
    }

    /// `Matrix(2, 2, [a, b, c, d])`: a matrix by its size; whether one stands here.
    pub(crate) fn matrix(&mut self) -> bool {
        if self.typed[..self.at].ends_with(is_of_name) {
            return false;
        }
        let typed = self.typed;
        let rest = &typed[self.at..];
        let inner = SIZED
            .iter()
            .find_map(|name| rest.strip_prefix(*name)?.strip_prefix('('));
        let Some((size, list)) =
            inner.and_then(|inner| Some(inner.split_at(inner.find(['[', '{'])?)))
        else {
            return false;
        };
        let columns = match size.split(',').map(str::trim).collect::<Vec<_>>()[..] {
            [rows, columns, ""] if rows.parse::<usize>().is_ok() => columns.parse::<usize>().ok(),
            _ => None,
        };
        let Some(columns) = columns.filter(|columns| *columns > 0) else {
            return false;
        };
        let start = self.typed.len() - list.len() + 1;
        let (_, commas) = arguments_of_call(&list[1..]);
        if !list[1..].trim_start().starts_with(['[', '{']) {
            let ends = commas.iter().skip(columns - 1).step_by(columns);
            self.row_ends.extend(ends.map(|comma| start + comma));
        }
        let length = self.typed.len() - list.len() - self.at;
        self.write("(", length);
        true
    }

    /// `Subscript[m, b]`, as Mathematica writes indices, as `m_b`; whether one stands here.
    pub(crate) fn subscript(&mut self) -> bool {
        const NAME: &str = "Subscript[";
        let typed = self.typed;
        let Some((inner, _)) = typed[self.at..]
            .strip_prefix(NAME)
            .and_then(|inner| inner.split_once(']'))
        else {
            return false;
        };
        let Some((letter, index)) = inner.split_once(',') else {
            return false;
        };
        let (letter, index) = (letter.trim(), index.trim());
        let is_name = |text: &str| !text.is_empty() && text.chars().all(char::is_alphanumeric);
        let is_subscript = is_name(letter) && is_name(index);
        if is_subscript {
            self.write(
                &format!("{letter}_{{{index}}}"),
                NAME.len() + inner.len() + 1,
            );
        }
        is_subscript
    }

    /// `\[Omega]`, `\[CapitalOmega]`, as Mathematica writes Greek letters; whether one stands here.
    pub(crate) fn escaped_greek(&mut self) -> bool {
        let Some((name, _)) = self.rest()[2..].split_once(']') else {
            return false;
        };
        let (is_capital, letter) = match name.strip_prefix("Capital") {
            Some(letter) => (true, letter),
            None => (false, name),
        };
        let word = match letter {
            "CurlyPhi" => "varphi".to_owned(),
            _ if is_capital => letter.to_owned(),
            _ => letter.to_ascii_lowercase(),
        };
        let is_greek = greek_word(&word).is_some();
        if is_greek {
            // A letter after the bracket is no part of the command's name.
            let length = name.len() + "\\[]".len();
            let is_letter =
                self.rest()[length..].starts_with(|next: char| next.is_ascii_alphabetic());
            let space = if is_letter { " " } else { "" };
            self.write(&format!("\\{word}{space}"), length);
        }
        is_greek
    }
}

/// Calls that make a matrix of its size and its entries.
const SIZED: [&str; 4] = ["Matrix", "sp.Matrix", "sympy.Matrix", "matrix"];

/// Where a bracket closes that stands open before a text, and where signs part what it holds.
pub(crate) fn arguments_of_call(inner: &str) -> (Option<usize>, Vec<usize>) {
    let (mut depth, mut parts) = (1_usize, Vec::new());
    let close = inner.char_indices().find_map(|(at, char)| {
        match char {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            ',' | ';' if depth == 1 => parts.push(at),
            _ => {}
        }
        (depth == 0).then_some(at)
    });
    (close, parts)
}

/// Whether a list stands in the bracket that is open before a text.
pub(crate) fn holds_list(inner: &str) -> bool {
    inner.trim_start().starts_with(['[', '{', '(']) || !arguments_of_call(inner).1.is_empty()
}
