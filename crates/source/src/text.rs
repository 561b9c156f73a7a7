//! A file's text, and texts inside it.

use std::sync::Arc;

use super::Span;

/// A file: what it is called and what stands in it.
#[derive(Clone, Debug)]
pub struct Source {
    /// The path under which messages speak of it.
    pub path: Arc<str>,
    /// What stands in it.
    pub text: Arc<str>,
}

/// A text in a file, with its way back to the bytes there.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// What it says, escapes resolved.
    pub value: String,
    /// Where it stands, quotes included.
    pub span: Span,
}

impl Source {
    /// The file `path` with this text.
    pub fn new(path: impl Into<Arc<str>>, text: impl Into<Arc<str>>) -> Self {
        Self {
            path: path.into(),
            text: text.into(),
        }
    }

    /// Line and column of a byte, both from 1; the column counts characters.
    ///
    /// ```
    /// use vibank_source::Source;
    /// let source = Source::new("a.toml", "m = 1\nk = 2\n");
    /// assert_eq!(source.position(6), (2, 1));
    /// ```
    pub fn position(&self, byte: usize) -> (usize, usize) {
        let byte = self.text.floor_char_boundary(byte.min(self.text.len()));
        let before = &self.text[..byte];
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        (
            before.matches('\n').count() + 1,
            before[line_start..].chars().count() + 1,
        )
    }

    /// The span in this file of the bytes `inner` of a text's value.
    ///
    /// Texts are mostly written as they are meant; where escapes stand in between, the literal is
    /// walked through to find the place.
    pub fn place(&self, text: &Text, inner: Span) -> Span {
        if inner.is_none() || text.span.is_none() || text.span.end as usize > self.text.len() {
            return text.span;
        }
        let literal = &self.text[text.span.range()];
        let body = opening(literal);
        let verbatim = literal.get(body..body + text.value.len()) == Some(text.value.as_str());
        let start = text.span.start as usize;
        if verbatim {
            return inner.shifted(start + body);
        }
        let at = |target: u32| start + locate(literal, body, target as usize);
        Span::new(at(inner.start), at(inner.end).max(at(inner.start)))
    }
}

/// Length of the quotes (and of the line break after three of them) that open a literal.
fn opening(literal: &str) -> usize {
    let quotes = if literal.starts_with("\"\"\"") || literal.starts_with("'''") {
        3
    } else {
        1
    };
    if quotes == 1 || !(literal.starts_with('"') || literal.starts_with('\'')) {
        return usize::from(literal.starts_with(['"', '\'']));
    }
    let rest = &literal[3..];
    3 + if rest.starts_with("\r\n") {
        2
    } else {
        usize::from(rest.starts_with('\n'))
    }
}

/// The byte of a literal at which the byte `target` of its value is written.
fn locate(literal: &str, body: usize, target: usize) -> usize {
    let escapes = literal.starts_with('"');
    let (mut at, mut value) = (body, 0);
    while at < literal.len() {
        let rest = &literal[at..];
        let (read, written) = if escapes && rest.starts_with('\\') {
            escape(rest)
        } else {
            plain(rest)
        };
        // What writes nothing, such as a line that goes on, stands before the byte that is looked for.
        if value >= target && written > 0 {
            break;
        }
        at += read;
        value += written;
    }
    at.min(literal.len())
}

/// Bytes read and bytes of value written for one plain character.
fn plain(rest: &str) -> (usize, usize) {
    let length = rest.chars().next().map_or(1, char::len_utf8);
    // A carriage return before a line break is not part of the value.
    (length, if rest.starts_with("\r\n") { 0 } else { length })
}

/// Bytes read and bytes of value written for one escape, sound or not.
fn escape(rest: &str) -> (usize, usize) {
    let digits = |count: usize| {
        let digits = rest.bytes().skip(2).take(count);
        let end = 2 + digits.take_while(u8::is_ascii_hexdigit).count();
        let code = u32::from_str_radix(&rest[2..end], 16).ok();
        let written = code.and_then(char::from_u32).map_or(1, char::len_utf8);
        (end, written)
    };
    match rest.as_bytes().get(1) {
        Some(b'u') => digits(4),
        Some(b'U') => digits(8),
        Some(b'x') => digits(2),
        Some(b'\n' | b'\r' | b' ' | b'\t') => {
            (1 + rest[1..].len() - rest[1..].trim_start().len(), 0)
        }
        _ => {
            let escaped = rest.chars().nth(1);
            (1 + escaped.map_or(0, char::len_utf8), 1)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn placed(file: &str, literal: &str, value: &str, word: &str) -> String {
        let source = Source::new("t.toml", file);
        let start = file.find(literal).unwrap();
        let text = Text {
            value: value.to_owned(),
            span: Span::new(start, start + literal.len()),
        };
        let at = value.find(word).unwrap();
        let span = source.place(&text, Span::new(at, at + word.len()));
        file[span.range()].to_owned()
    }

    #[test]
    fn a_word_is_found_in_plain_and_escaped_literals() {
        assert_eq!(placed("a = 'k*x'", "'k*x'", "k*x", "x"), "x");
        assert_eq!(placed("a = \"k*x\"", "\"k*x\"", "k*x", "x"), "x");
        assert_eq!(
            placed(r#"a = "\\frac{m}""#, r#""\\frac{m}""#, r"\frac{m}", "{m}"),
            "{m}"
        );
        assert_eq!(placed("a = '''\nk\n'''", "'''\nk\n'''", "k\n", "k"), "k");
        assert_eq!(
            placed(
                "a = \"\"\"k \\\n   x\"\"\"",
                "\"\"\"k \\\n   x\"\"\"",
                "k x",
                "x"
            ),
            "x"
        );
    }

    #[test]
    fn a_place_behind_a_broken_escape_is_one() {
        for broken in ["\\é", "\\王", "\\u00é1", "\\u12", "\\U王", "\\x", "\\"] {
            let literal = format!("\"a {broken} $x$\"");
            let file = format!("a = {literal}");
            // What the value is then, the reader of TOML decides.
            for value in [
                format!("a {broken} $x$"),
                "a é $x$".to_owned(),
                "a  $x$".to_owned(),
            ] {
                for (at, char) in value.char_indices() {
                    let source = Source::new("t.toml", file.as_str());
                    let span = Span::new(4, 4 + literal.len());
                    let text = Text {
                        value: value.clone(),
                        span,
                    };
                    let place = source.place(&text, Span::new(at, at + char.len_utf8()));
                    assert!(file.get(place.range()).is_some(), "{file}: {place:?}");
                }
            }
        }
    }
}
