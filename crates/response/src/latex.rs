//! LaTeX commands in responses.

use super::letters::{Letters, greek_word, name_of_command};
use super::lexer::Lexer;
use super::subscript::subscript;
use super::token::Item;
use super::vocabulary::Ending;
use super::{Trouble, TypedError};
use vibank_formula::expr::Function;

impl Lexer<'_> {
    /// A LaTeX command.
    pub(crate) fn command(&mut self) -> Result<(), TypedError> {
        let start = self.at;
        let name = name_of_command(self.rest());
        if name.is_empty() {
            return self.escaped(start);
        }
        self.at += 1 + name.len();
        if let Some(word) = greek_word(name) {
            // The space that ends a command is none.
            self.skip_space_before_letter();
            return self.run(Some((word, start)));
        }
        let sign = |char| Item::Sign(char);
        let item = match name {
            "mathit" | "mathbf" | "boldsymbol" => return Ok(()),
            "mathrm" | "operatorname" | "text" | "rm" => return self.word_in_braces(),
            "frac" => Item::Fraction,
            "sqrt" => Item::Radical,
            "bar" | "overline"
                if self.manner.has_imaginary_unit && self.manner.values.is_none() =>
            {
                Item::Bar
            }
            "dot" | "ddot" => return self.dots(if name == "dot" { 1 } else { 2 }, start),
            "begin" | "end" => {
                if let Some(end) = self.rest().find('}').filter(|end| *end < 12) {
                    self.at += end + 1;
                }
                sign(if name == "begin" { '[' } else { ']' })
            }
            "log" => return self.error(Trouble::Logarithm, start),
            other => match Function::of_name(other).or(match other {
                "arcsin" => Some(Function::Asin),
                "arccos" => Some(Function::Acos),
                "arctan" => Some(Function::Atan),
                _ => None,
            }) {
                Some(function) => Item::Function(function),
                None => return self.error(Trouble::Sign, start),
            },
        };
        self.push(item, start);
        Ok(())
    }

    /// Primes as an exponent, `^{\prime\prime}` or `^{''}`; how many there are.
    pub(crate) fn raised_primes(&mut self) -> u8 {
        let Some(rest) = self.rest().strip_prefix('^') else {
            return 0;
        };
        // `x^{(2)}`, the second derivative.
        for (order, raised) in [(1, "{(1)}"), (2, "{(2)}")] {
            if rest.starts_with(raised) {
                self.at += 1 + raised.len();
                return order;
            }
        }
        let braced = rest.strip_prefix('{');
        let (mut rest, mut primes) = (braced.unwrap_or(rest), 0_u8);
        loop {
            rest = rest.trim_start_matches(' ');
            let next = rest
                .strip_prefix("\\prime")
                .or_else(|| rest.strip_prefix('\''));
            let Some(next) = next.filter(|_| primes < 4) else {
                break;
            };
            (rest, primes) = (next, primes + 1);
        }
        if primes > 0 && braced.is_some() {
            let Some(closed) = rest.strip_prefix('}') else {
                return 0;
            };
            rest = closed;
        }
        if primes > 0 {
            self.at = self.text.len() - rest.len();
        }
        primes
    }

    /// A backslash before a sign.
    fn escaped(&mut self, start: usize) -> Result<(), TypedError> {
        self.at += 1;
        match self.peek() {
            Some('\\') => {
                self.take(1, Item::Sign(';'));
                Ok(())
            }
            _ => self.error(Trouble::Sign, start),
        }
    }

    /// `\mathrm{st}`, `\operatorname{sign}`: the word within.
    fn word_in_braces(&mut self) -> Result<(), TypedError> {
        while self.peek() == Some(' ') {
            self.at += 1;
        }
        let Some(inner) = self.rest().strip_prefix('{') else {
            return Ok(());
        };
        let Some(length) = inner.find('}') else {
            return Ok(());
        };
        let is_word = inner[..length]
            .chars()
            .all(|char| char.is_ascii_alphanumeric());
        if !is_word || length == 0 {
            return Ok(());
        }
        let (start, end) = (self.at + 1, self.at + 1 + length);
        let mut letters = Letters::default();
        for (offset, char) in inner[..length].char_indices() {
            letters.push(char, start + offset, start + offset);
        }
        self.at = end + 1;
        while self.peek() == Some('_') {
            self.at = subscript(self.text, self.at, &mut letters);
        }
        self.words(&letters, start, end.max(self.at), 0)
    }

    /// `\dot{x}`, `\ddot\theta_1`.
    fn dots(&mut self, order: u8, start: usize) -> Result<(), TypedError> {
        let mut letters = Letters::default();
        let mut open = 0;
        while let Some(char) = self.peek() {
            let at = self.at;
            match char {
                ' ' if letters.text.is_empty() || open > 0 => self.at += 1,
                '{' => {
                    open += 1;
                    self.at += 1;
                }
                '}' if open > 0 => {
                    open -= 1;
                    self.at += 1;
                }
                '_' => self.at = subscript(self.text, self.at, &mut letters),
                '\\' if letters.text.is_empty() => {
                    let name = name_of_command(self.rest());
                    let Some(word) = greek_word(name) else {
                        return self.error(Trouble::Sign, at);
                    };
                    letters.push_word(word, at);
                    self.at += 1 + name.len();
                }
                '0'..='9' | '₀'..='₉' => {
                    letters.push(char, at, at);
                    self.at += char.len_utf8();
                }
                // Only the one letter under the dot, unless braces hold more.
                _ if letters.text.is_empty() || open > 0 => {
                    if !letters.push(char, at, at) {
                        break;
                    }
                    self.at += char.len_utf8();
                }
                _ => break,
            }
        }
        let initial = ["(0)", "\\left(0\\right)"]
            .iter()
            .find(|call| self.rest().starts_with(**call));
        if let Some(call) = initial
            && let Some(leaf) = self.lexicon.ended(&letters.text, Ending::Initial(order))
        {
            self.at += call.len();
            self.push(Item::Leaf(leaf), start);
            return Ok(());
        }
        match self.lexicon.dotted(&letters.text, order) {
            Some(leaf) => {
                self.push(Item::Leaf(leaf), start);
                Ok(())
            }
            None => self.error(self.lexicon.unknown(""), start),
        }
    }
}
