//! The words of a formula.

use std::fmt;

use super::ReadError;
use vibank_source::Span;

/// A word of a formula, with the letters it was written with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Token<'a> {
    pub(crate) kind: TokenKind,
    /// The letters; of a unit, those between the brackets.
    pub(crate) text: &'a str,
    pub(crate) span: Span,
}

/// What a word is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TokenKind {
    /// `0.5`, `1e-3`.
    Number,
    /// `[m/s]` right after a number.
    Unit,
    /// A name or a word of the language.
    Word,
    /// An operator, bracket or separator.
    Sign,
    /// The end of the text.
    End,
}

/// Splits a text into words, the end last.
pub(crate) fn tokens(text: &str) -> Result<Vec<Token<'_>>, ReadError> {
    let mut tokens = Vec::with_capacity(text.len() / 2 + 2);
    let mut at = 0;
    while let Some(character) = text[at..].chars().next() {
        if character.is_ascii_whitespace() {
            at += 1;
            continue;
        }
        let after_number = tokens.last().is_some_and(|last: &Token<'_>| {
            last.kind == TokenKind::Number && last.span.end as usize == at
        });
        let (kind, length) = match character {
            '[' if after_number => (TokenKind::Unit, unit_length(text, at)?),
            '0'..='9' => (TokenKind::Number, number_length(&text[at..])),
            'A'..='Z' | 'a'..='z' => (TokenKind::Word, word_length(&text[at..])),
            _ => (TokenKind::Sign, sign_length(text, at, character)?),
        };
        let span = Span::new(at, at + length);
        let written = match kind {
            TokenKind::Unit => &text[at + 1..at + length - 1],
            _ => &text[at..at + length],
        };
        tokens.push(Token {
            kind,
            text: written,
            span,
        });
        at += length;
    }
    tokens.push(Token {
        kind: TokenKind::End,
        text: "",
        span: Span::new(text.len(), text.len()),
    });
    Ok(tokens)
}

/// Length of the unit in brackets at `at`.
fn unit_length(text: &str, at: usize) -> Result<usize, ReadError> {
    let rest = &text[at..];
    rest.find(']')
        .map(|length| length + 1)
        .ok_or_else(|| ReadError::UnclosedUnit {
            span: Span::new(at, at + 1),
        })
}

/// Length of the number at the start; an `e` without digits belongs to what follows.
fn number_length(text: &str) -> usize {
    let digits = |from: usize| {
        text.as_bytes()[from..]
            .iter()
            .take_while(|byte| byte.is_ascii_digit())
            .count()
    };
    let byte = |at: usize| text.as_bytes().get(at).copied().unwrap_or(0);
    let mut length = digits(0);
    if byte(length) == b'.' && byte(length + 1).is_ascii_digit() {
        length += 1 + digits(length + 1);
    }
    if matches!(byte(length), b'e' | b'E') {
        let sign = usize::from(matches!(byte(length + 1), b'+' | b'-'));
        if byte(length + 1 + sign).is_ascii_digit() {
            length += 1 + sign + digits(length + 1 + sign);
        }
    }
    length
}

fn word_length(text: &str) -> usize {
    text.bytes()
        .take_while(|&byte| byte.is_ascii_alphanumeric() || byte == b'_')
        .count()
}

/// Length of the operator, bracket or separator at `at`; of two that fit, the longer one is taken.
fn sign_length(text: &str, at: usize, character: char) -> Result<usize, ReadError> {
    match (character, text.as_bytes().get(at + 1)) {
        ('*', Some(b'*')) | ('=' | '!' | '<' | '>', Some(b'=')) => Ok(2),
        (
            '<' | '>' | '=' | '+' | '-' | '*' | '/' | '^' | '(' | ')' | '[' | ']' | ',' | '\''
            | '.',
            _,
        ) => Ok(1),
        _ => Err(ReadError::UnknownCharacter {
            character,
            span: Span::new(at, at + character.len_utf8()),
        }),
    }
}

impl Token<'_> {
    /// Whether it is this operator, bracket or word of the language.
    pub(crate) fn is(&self, text: &str) -> bool {
        matches!(self.kind, TokenKind::Sign | TokenKind::Word) && self.text == text
    }
}

/// As it stands in a message: the letters in back-ticks, or `the end`.
impl fmt::Display for Token<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.kind {
            TokenKind::Number | TokenKind::Word | TokenKind::Sign => {
                write!(formatter, "`{}`", self.text)
            }
            TokenKind::Unit => write!(formatter, "`[{}]`", self.text),
            TokenKind::End => formatter.write_str("the end"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Vec<&str> {
        let tokens = tokens(text).unwrap();
        tokens.iter().map(|token| token.text).collect()
    }

    #[test]
    fn words_are_split() {
        assert_eq!(words("x'^2<=k1"), ["x", "'", "^", "2", "<=", "k1", ""]);
        assert_eq!(words("1.5e-3*a.b"), ["1.5e-3", "*", "a", ".", "b", ""]);
        assert_eq!(words("2e 3.x"), ["2", "e", "3", ".", "x", ""]);
    }

    #[test]
    fn a_bracket_after_a_number_is_a_unit() {
        assert_eq!(words("0.1[N m/rad]"), ["0.1", "N m/rad", ""]);
        assert_eq!(words("0.1 [m]"), ["0.1", "[", "m", "]", ""]);
        assert_eq!(words("u[1]"), ["u", "[", "1", "]", ""]);
    }

    #[test]
    fn what_is_no_word_is_named() {
        let error = tokens("a + ω").unwrap_err();
        assert_eq!(error.to_string(), "`ω` has no meaning in a formula");
        assert_eq!(error.span(), Span::new(4, 6));
    }
}
