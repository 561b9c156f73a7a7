//! Numbers in responses: decimals, degrees, raised digits, signs of fractions.

use super::lexer::Lexer;
use super::nothing::unit_of_nothing;
use super::signs::{DECIMAL, is_between_digits, is_digit, is_of_name};
use super::token::{Item, Token};
use super::words::Powered;
use super::{Trouble, TypedError};
use vibank_dynamics::numerics::Rational;
use vibank_formula::expr::Function;

impl Lexer<'_> {
    /// `30 deg`; whether the word stands here after a number.
    pub(crate) fn degrees(&mut self) -> bool {
        let is_behind_number =
            matches!(self.tokens.last(), Some(token) if matches!(token.item, Item::Number(_)));
        // As readings are echoed.
        const ECHOED: &str = "[deg]";
        if is_behind_number && self.rest().starts_with(ECHOED) {
            self.take(ECHOED.len(), Item::Degree);
            return true;
        }
        let Some(rest) = self.rest().strip_prefix("deg").filter(|_| is_behind_number) else {
            return false;
        };
        let rest = rest.strip_prefix("rees").unwrap_or(rest);
        let is_word = !rest.starts_with(is_of_name);
        if is_word {
            self.take(self.rest().len() - rest.len(), Item::Degree);
        }
        is_word
    }

    pub(crate) fn number(&mut self) -> Result<(), TypedError> {
        let start = self.at;
        let mut digits = String::new();
        self.digits(&mut digits);
        let is_decimal = match self.peek() {
            Some('.') => true,
            Some(',') => {
                self.manner.comma_is_decimal && !digits.is_empty() && !self.parts_arguments()
            }
            _ => false,
        };
        if let Some(decimals) = self.rest().strip_prefix(DECIMAL)
            && decimals.starts_with(is_digit)
        {
            self.at += DECIMAL.len_utf8();
            digits.push('.');
            self.digits(&mut digits);
        }
        if is_decimal && (self.rest()[1..].starts_with(is_digit) || self.peek() == Some('.')) {
            self.at += 1;
            digits.push('.');
            self.digits(&mut digits);
        }
        self.exponent(&mut digits);
        let decimal = digits
            .strip_prefix('.')
            .map_or(digits.clone(), |rest| format!("0.{rest}"));
        match Rational::from_decimal(&decimal) {
            Some(number) => {
                self.push(Item::Number(number), start);
                if number.is_zero()
                    && self.manner.values.is_none()
                    && let Some((unit, length)) = unit_of_nothing(self.rest(), &self.tokens)
                {
                    self.take(length, Item::Unit(Box::new(unit)));
                }
                Ok(())
            }
            None => self.error(Trouble::Number, start),
        }
    }

    /// `6!/(2! 4!)`; whether the sign of a factorial stands here behind its integer.
    pub(crate) fn factorial(&mut self, char: char) -> bool {
        /// Nobody types the factorial of a larger number.
        const MOST: i128 = 20;
        let Some([before @ .., last]) = (char == '!').then_some(&self.tokens[..]) else {
            return false;
        };
        let Item::Number(number) = last.item else {
            return false;
        };
        let behind = &self.rest()['!'.len_utf8()..];
        let is_integer = number.denominator() == 1 && (0..=MOST).contains(&number.numerator());
        if !is_integer || self.is_spaced || !is_factorial(before.last(), behind) {
            return false;
        }
        let product = (2..=number.numerator()).product();
        let Some(value) = Rational::new(product, 1) else {
            return false;
        };
        let start = last.span.range().start;
        self.is_spaced = last.is_spaced;
        self.tokens.pop();
        self.at += '!'.len_utf8();
        self.push(Item::Number(value), start);
        // `2! 4!`
        if begins_with_factorial(behind) {
            self.take(0, Item::Sign('*'));
        }
        true
    }

    /// An integer and the sign of a fraction right after it, `1½`, as one number; whether the sign stands here.
    pub(crate) fn mixed(&mut self, char: char) -> bool {
        let (Some(fraction), Some(last)) = (fraction(char), self.tokens.last()) else {
            return false;
        };
        let span = last.span.range();
        let is_integer = self.text[span.clone()]
            .bytes()
            .all(|byte| byte.is_ascii_digit());
        let Item::Number(whole) = last.item else {
            return false;
        };
        let Some(sum) = whole
            .checked_add(fraction)
            .filter(|_| is_integer && span.end == self.at)
        else {
            return false;
        };
        self.is_spaced = last.is_spaced;
        self.tokens.pop();
        self.at += char.len_utf8();
        self.push(Item::Number(sum), span.start);
        true
    }

    /// Whether a comma here parts arguments, or may do so.
    pub(crate) fn parts_arguments(&self) -> bool {
        self.comma_here() != Comma::Decimal
    }

    /// What a comma here is: it parts the arguments of a function of several, `max(5,1)`, unless semicolons in its
    /// brackets do. An arc tangent has one argument or two: other commas and points say which, or else it is open.
    pub(crate) fn comma_here(&self) -> Comma {
        let mut closed = 0_usize;
        let opens = |token: &Token| match token.item {
            Item::Sign(')' | ']' | '}') => {
                closed += 1;
                false
            }
            Item::Sign('(' | '[' | '{') if closed == 0 => true,
            Item::Sign('(' | '[' | '{') => {
                closed -= 1;
                false
            }
            _ => false,
        };
        let Some(open) = self.tokens.iter().rposition(opens) else {
            return Comma::Decimal;
        };
        let start = self.tokens[open].span.range().end;
        let inner = &self.text[start..];
        let inner = inner.split([')', ']', '}']).next().unwrap_or_default();
        let called = self.tokens[..open].last();
        let takes_several = called.is_some_and(|token| match token.item {
            Item::Function(function) => function.arity().1 > 1,
            Item::Powered(powered) => powered != Powered::CubeRoot,
            _ => false,
        });
        if takes_several && !inner.contains(';') {
            return Comma::Parts;
        }
        let is_arc = called.is_some_and(|token| token.item == Item::Function(Function::Atan));
        let is_square = self.tokens[open].item == Item::Sign('[');
        if !is_arc || !(is_square || are_two_numbers(inner)) {
            return Comma::Decimal;
        }
        let around = [&self.text[..start], &self.text[start + inner.len()..]];
        let has = |sign| around.iter().any(|text| has_decimal(text, sign));
        if is_square || has('.') {
            Comma::Parts
        } else if has(',') {
            Comma::Decimal
        } else {
            Comma::Either
        }
    }

    fn digits(&mut self, digits: &mut String) {
        while let Some(digit) = self.peek().filter(char::is_ascii_digit) {
            digits.push(digit);
            self.at += 1;
        }
    }

    /// `e-4`, if digits follow.
    fn exponent(&mut self, digits: &mut String) {
        let rest = self.rest();
        let Some(after) = rest.strip_prefix(['e', 'E']) else {
            return;
        };
        let signed = after.strip_prefix(['-', '+']).unwrap_or(after);
        if !signed.starts_with(is_digit) {
            return;
        }
        let is_negative = after.starts_with('-');
        self.at += rest.len() - signed.len();
        digits.push_str(if is_negative { "e-" } else { "e" });
        self.digits(digits);
    }

    /// `²`, `⁻¹`.
    pub(crate) fn raised(&mut self) -> Result<(), TypedError> {
        let start = self.at;
        let mut digits = String::new();
        while let Some(char) = self.peek() {
            match raised(char) {
                Some('-') if !digits.is_empty() => break,
                Some(plain) => digits.push(plain),
                None => break,
            }
            self.at += char.len_utf8();
        }
        match digits.parse::<i128>() {
            Ok(power) if digits.len() <= 4 => {
                self.push(Item::Power(power), start);
                Ok(())
            }
            _ => self.error(Trouble::Sign, start),
        }
    }
}

/// What a raised digit or minus is on the line.
pub(crate) fn raised(char: char) -> Option<char> {
    Some(match char {
        '⁻' => '-',
        '⁰' => '0',
        '¹' => '1',
        '²' => '2',
        '³' => '3',
        '⁴'..='⁹' => char::from(b'4' + (u32::from(char) - u32::from('⁴')) as u8),
        _ => return None,
    })
}

/// What a comma between digits is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Comma {
    /// A decimal sign.
    Decimal,
    /// It parts arguments.
    Parts,
    /// One or the other.
    Either,
}

/// Whether a comma alone stands between digits, `1,0`. Of `0,75` it is a decimal sign: nobody gives the sides of an
/// angle of nothing.
fn are_two_numbers(text: &str) -> bool {
    let is_whole = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let parts = text.trim().split_once(',');
    parts.is_some_and(|(one, other)| is_whole(one) && is_whole(other) && !one.starts_with('0'))
}

/// Whether this decimal sign stands between two digits.
fn has_decimal(text: &str, sign: char) -> bool {
    let mut signs = text.match_indices(sign);
    signs.any(|(at, _)| is_between_digits(text, at))
}

/// `½` and its like.
pub(crate) fn fraction(sign: char) -> Option<Rational> {
    let (above, below) = match sign {
        '½' => (1, 2),
        '⅓' => (1, 3),
        '⅔' => (2, 3),
        '¼' => (1, 4),
        '¾' => (3, 4),
        '⅕' => (1, 5),
        '⅖' => (2, 5),
        '⅗' => (3, 5),
        '⅘' => (4, 5),
        '⅙' => (1, 6),
        '⅚' => (5, 6),
        '⅛' => (1, 8),
        '⅜' => (3, 8),
        '⅝' => (5, 8),
        '⅞' => (7, 8),
        _ => return None,
    };
    Rational::new(above, below)
}

/// Whether a mark behind a number is the sign of a factorial, by what stands before the number and behind the mark; a
/// number alone is exclaimed, `x = 5!`, and `!=` compares.
fn is_factorial(before: Option<&Token>, behind: &str) -> bool {
    let is_divided = before.is_some_and(|token| matches!(token.item, Item::Sign('/' | '*')));
    let next = behind.trim_start();
    match next.chars().next() {
        None => is_divided,
        Some('=') => next.len() < behind.len(),
        Some('(') => next.len() == behind.len(),
        Some(next) => "/*+-)^".contains(next) || begins_with_factorial(behind),
    }
}

/// Whether the next number has the sign of a factorial, too.
fn begins_with_factorial(text: &str) -> bool {
    let text = text.trim_start();
    let behind = text.trim_start_matches(is_digit);
    behind.len() < text.len() && behind.starts_with('!')
}
