//! A place in a text that moves forward: what the readers of numbers and units share.

use super::error::{Error, ErrorKind};
use super::rational::Rational;
use super::strict::MAX_LENGTH;

/// A text and a place in it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scanner<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Scanner<'a> {
    /// At the beginning of a text that is not too long.
    pub(crate) fn new(text: &'a str) -> Result<Self, Error> {
        if text.len() > MAX_LENGTH {
            return Err(Error::new(
                ErrorKind::TooLong { limit: MAX_LENGTH },
                0..text.len(),
            ));
        }
        Ok(Self { text, at: 0 })
    }

    pub(crate) fn at(&self) -> usize {
        self.at
    }

    /// Whether the text ends with a word here, but for spaces.
    pub(crate) fn is_behind(&self, word: &str) -> bool {
        self.text[..self.at].trim_end().ends_with(word)
    }

    /// What has not been read yet.
    pub(crate) fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    pub(crate) fn is_at_end(&self) -> bool {
        self.at == self.text.len()
    }

    pub(crate) fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    /// Moves past the next character; whether there was one.
    pub(crate) fn skip(&mut self) -> bool {
        let next = self.peek();
        self.at += next.map_or(0, char::len_utf8);
        next.is_some()
    }

    /// Moves past a character, if it is the next one.
    pub(crate) fn takes(&mut self, char: char) -> bool {
        let next = self.rest().starts_with(char);
        if next {
            self.at += char.len_utf8();
        }
        next
    }

    /// Moves past a text, if it is what comes next.
    pub(crate) fn takes_text(&mut self, text: &str) -> bool {
        let next = self.rest().starts_with(text);
        if next {
            self.at += text.len();
        }
        next
    }

    /// Moves past a `1` that stands for no unit.
    pub(crate) fn takes_one(&mut self) -> bool {
        let mut rest = self.rest().chars();
        let one = rest.next() == Some('1')
            && rest
                .next()
                .is_none_or(|next| !next.is_ascii_digit() && next != '.');
        if one {
            self.at += 1;
        }
        one
    }

    /// Moves past white space.
    pub(crate) fn space(&mut self) {
        self.at = self.text.len() - self.rest().trim_start().len();
    }

    /// Moves past the characters of a kind, and returns them.
    pub(crate) fn run(&mut self, kind: impl Fn(char) -> bool) -> &'a str {
        let rest = self.rest();
        let run = &rest[..rest.find(|char| !kind(char)).unwrap_or(rest.len())];
        self.at += run.len();
        run
    }

    /// An error about the next character.
    pub(crate) fn error(&self, kind: ErrorKind) -> Error {
        let length = self.peek().map_or(0, char::len_utf8);
        Error::new(kind, self.at..self.at + length)
    }

    /// An exponent, `2`, `-2`, `(-1/2)`; for people also `1/2` in braces, `0.5` and a Unicode minus.
    pub(crate) fn exponent(&mut self, lenient: bool) -> Option<Rational> {
        if self.takes('(') {
            return self.fraction(')', lenient);
        }
        if lenient && self.takes('{') {
            return self.fraction('}', lenient);
        }
        self.number(lenient)
    }

    /// An exponent without parentheses, as people type it.
    pub(crate) fn plain_exponent(&mut self) -> Option<Rational> {
        self.number(true)
    }

    fn fraction(&mut self, close: char, lenient: bool) -> Option<Rational> {
        let above = self.number(lenient)?;
        let below = if self.takes('/') {
            self.number(lenient)?
        } else {
            Rational::ONE
        };
        let power = Rational::new(above.numerator(), below.numerator());
        let power = if above.is_integer() && below.is_integer() {
            power
        } else {
            Some(above)
        };
        if self.takes(close) { power } else { None }
    }

    fn number(&mut self, lenient: bool) -> Option<Rational> {
        let negative = self.takes('-') || lenient && (self.takes('−') || self.takes('–'));
        if !negative && lenient {
            self.takes('+');
        }
        let whole = self.run(|char| char.is_ascii_digit());
        let tenths = if lenient && self.takes('.') {
            self.run(|char| char.is_ascii_digit())
        } else {
            ""
        };
        // More digits than any exponent has, and few enough for 32 bits.
        if whole.len() > 3 || tenths.len() > 3 || whole.is_empty() && tenths.is_empty() {
            return None;
        }
        let digits = whole
            .bytes()
            .chain(tenths.bytes())
            .fold(0, |number, digit| 10 * number + i32::from(digit - b'0'));
        let power = Rational::new(digits, [1, 10, 100, 1000][tenths.len()])?;
        Some(if negative { power.negated() } else { power })
    }

    /// An exponent in raised digits, `²`, `⁻¹`.
    pub(crate) fn superscript(&mut self) -> Option<Rational> {
        let mut ahead = *self;
        let negative = ahead.takes('⁻');
        let raised = ahead.run(|char| SUPERSCRIPTS.contains(&char));
        if raised.is_empty() || raised.chars().count() > 3 {
            return None;
        }
        let power = raised
            .chars()
            .fold(0, |power, char| 10 * power + digit(char));
        *self = ahead;
        Some(Rational::integer(if negative { -power } else { power }))
    }
}

/// The digit that a raised sign is.
fn digit(char: char) -> i32 {
    SUPERSCRIPTS
        .iter()
        .position(|&raised| raised == char)
        .unwrap_or(0) as i32
}

/// The raised digits, in order.
pub(crate) const SUPERSCRIPTS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
