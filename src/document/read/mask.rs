//! Placeholders put out of the parsers' sight.
//!
//! Each `<< name.form >>` is replaced by one character of a private-use area, which Markdown and
//! LaTeX take for a letter; a map leads from places in the masked text back to the written one.

use super::TextError;
use crate::document::{Form, Placeholder};
use crate::math::holes::{LIMIT, LITERAL, is_private, mark};
use crate::source::{Span, nearest};

/// A text whose placeholders are single characters.
pub(crate) struct Masked {
    pub(crate) text: String,
    pub(crate) placeholders: Vec<Placeholder>,
    /// Ends of replaced pieces: in the masked text, and in the written one.
    ends: Vec<(usize, usize)>,
    pub(crate) errors: Vec<TextError>,
}

/// Whether a byte is a character that stands for itself.
fn is_plain(byte: u8) -> bool {
    matches!(byte, b' '..=b'~' | b'\n' | b'\r' | b'\t') && !matches!(byte, b'\\' | b'<')
}

impl Masked {
    /// Masks the placeholders of a text.
    pub(crate) fn of(text: &str) -> Self {
        let mut masked = Self {
            text: String::with_capacity(text.len()),
            placeholders: Vec::new(),
            ends: Vec::new(),
            errors: Vec::new(),
        };
        let mut at = 0;
        while at < text.len() {
            let plain = text[at..].bytes().position(|byte| !is_plain(byte));
            let end = plain.map_or(text.len(), |length| at + length);
            masked.text.push_str(&text[at..end]);
            at = end;
            if at < text.len() {
                at = masked.step(text, at);
            }
        }
        masked
    }

    /// Takes what stands at a place, and returns where it ends.
    fn step(&mut self, text: &str, at: usize) -> usize {
        let rest = &text[at..];
        if rest.starts_with("\\\\") {
            self.text.push_str("\\\\");
            return at + 2;
        }
        if rest.starts_with("\\<<") {
            return self.replace(LITERAL, at + 3);
        }
        if rest.starts_with("<<") {
            return self.placeholder(text, at);
        }
        let Some(char) = rest.chars().next() else {
            return text.len();
        };
        let end = at + char.len_utf8();
        let is_refused =
            is_private(char) || char.is_control() && !matches!(char, '\n' | '\r' | '\t');
        if is_refused {
            let span = Span::new(at, end);
            self.errors.push(TextError::Character { char, span });
            return self.replace(char::REPLACEMENT_CHARACTER, end);
        }
        self.text.push(char);
        end
    }

    fn replace(&mut self, char: char, end: usize) -> usize {
        self.text.push(char);
        self.ends.push((self.text.len(), end));
        end
    }

    fn placeholder(&mut self, text: &str, start: usize) -> usize {
        let rest = &text[start..];
        let line = rest.find('\n').unwrap_or(rest.len());
        let Some(length) = rest[..line].find(">>") else {
            let end = start + rest[..line].trim_end().len();
            let span = Span::new(start, end);
            self.errors
                .push(TextError::UnterminatedPlaceholder { span });
            return self.replace(LITERAL, start + 2);
        };
        let end = start + length + 2;
        let name = rest[2..length].trim();
        let from = start + 2 + (rest[2..length].len() - rest[2..length].trim_start().len());
        let (path, form) = match demand(name, from) {
            Ok(demand) => demand,
            Err(error) => {
                self.errors.push(error);
                return self.replace(char::REPLACEMENT_CHARACTER, end);
            }
        };
        let span = Span::new(start, end);
        let Some(mark) = mark(self.placeholders.len()) else {
            let limit = LIMIT;
            self.errors
                .push(TextError::TooManyPlaceholders { limit, span });
            return self.replace(char::REPLACEMENT_CHARACTER, end);
        };
        self.placeholders.push(Placeholder {
            path: path.to_owned(),
            form,
            in_math: false,
            span,
        });
        self.replace(mark, end)
    }

    /// The place in the written text of a place in the masked one.
    fn origin(&self, at: usize) -> usize {
        let before = self.ends.partition_point(|(masked, _)| *masked <= at);
        match before.checked_sub(1).map(|last| self.ends[last]) {
            Some((masked, written)) => written + (at - masked),
            None => at,
        }
    }

    /// The span in the written text of a range of the masked one.
    pub(crate) fn span(&self, range: std::ops::Range<usize>) -> Span {
        Span::new(self.origin(range.start), self.origin(range.end))
    }
}

/// The path and form of what stands between the angles, which begins at `from`.
fn demand(name: &str, from: usize) -> Result<(&str, Form), TextError> {
    let span = Span::new(from, from + name.len());
    let malformed = || TextError::MalformedPlaceholder {
        text: name.chars().take(80).collect(),
        span,
    };
    let names: Vec<&str> = name.split('.').collect();
    if !is_path(&names) || names.len() > 8 {
        return Err(malformed());
    }
    // How many names a path has at least: what comes after may be a form.
    let least = match names[0] {
        "model" | "plots" => 2,
        "models" => 3,
        _ => 1,
    };
    let last = names[names.len() - 1];
    match names.len().checked_sub(least) {
        None => Err(malformed()),
        Some(0) => Ok((name, Form::Value)),
        Some(1) if name == "figure.free" => Ok((name, Form::Value)),
        Some(2) if name.starts_with("figure.mode.") => Ok((name, Form::Value)),
        Some(more) => match Form::of_name(last) {
            _ if matches!(names[0], "plots" | "figure") => Err(malformed()),
            Some(form) => Ok((&name[..name.len() - last.len() - 1], form)),
            // The coordinate of a model's quantity.
            None if least > 1 && more == 1 => Ok((name, Form::Value)),
            None => Err(TextError::UnknownForm {
                name: last.to_owned(),
                nearest: nearest(last, Form::NAMED.iter().map(|(name, _)| *name)),
                span: Span::new(span.end as usize - last.len(), span.end as usize),
            }),
        },
    }
}

/// `[A-Za-z][A-Za-z0-9_]*`
/// Names, the later of which may be numbers: `model.row.1`.
fn is_path(names: &[&str]) -> bool {
    let (first, rest) = (names.first(), names.iter().skip(1));
    first.is_some_and(|name| is_name(name))
        && rest.into_iter().all(|name| {
            is_name(name) || !name.is_empty() && name.bytes().all(|b| b.is_ascii_digit())
        })
}

fn is_name(name: &str) -> bool {
    name.starts_with(|c: char| c.is_ascii_alphabetic())
        && name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_')
}
