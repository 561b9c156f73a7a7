//! Units as people type them.
//!
//! ```text
//! unit    = item { ( " " | "·" | "*" | "." | "-" | "/" | "per" ) item }
//! item    = "1" | "(" unit ")" [ power ] | "\frac{" unit "}{" unit "}" | ( "square" | "cubic" ) letters | letters [ power ]
//! power   = ( "^" | "**" ) exponent | "²" | "2" | "-2" | "squared" | "cubed"
//! letters = symbol, word, or symbols without spaces
//! ```
//!
//! A slash divides by the one item after it. What follows such an item without another slash might belong above or
//! below, and `N/m/s` might be N/(m/s), so both are refused with the readings named; only `m/s/s` is clear.
//! A power without a sign, `s-2`, is small and comes after letters: in `180°-10°` and `10 mm-5 mm` a minus is a minus.

use super::error::{Error, ErrorKind};
use super::factor::{Builder, Factor};
use super::joined;
use super::product::Unit;
use super::rational::Rational;
use super::scanner::Scanner;
use super::strict::{MAX_LENGTH, is_letter};
use super::table::is_prefix_word;

/// The deepest nesting of parentheses.
const MAX_DEPTH: usize = 8;

/// Reads the unit after a number, which may be joined to it by a sign of multiplication.
pub(crate) fn after_number(text: &str) -> Result<Unit, Error> {
    let unspaced = text.trim_start();
    // `3 1` is two numbers, though `1` alone is a unit.
    if unspaced.trim_end() == "1" {
        let at = text.len() - unspaced.len();
        return Err(Error::new(ErrorKind::NumberWithinUnit, at..at + 1));
    }
    match TIMES_SIGNS
        .into_iter()
        .find_map(|sign| unspaced.strip_prefix(sign))
    {
        Some(rest) if !rest.trim().is_empty() => {
            unit(rest).map_err(|error| error.shifted(text.len() - rest.len()))
        }
        _ => unit(text),
    }
}

/// Reads a unit that makes up the whole text; nothing is `1`.
pub(crate) fn unit(text: &str) -> Result<Unit, Error> {
    // The point at the end of a sentence.
    let text = text.trim_end().trim_end_matches('.');
    let mut reader = UnitReader {
        scanner: Scanner::new(text)?,
        builder: Builder::new(),
        depth: 0,
        is_front: false,
    };
    reader.space();
    if text.trim() != "1" && !reader.scanner.is_at_end() {
        reader.product()?;
        match reader.scanner.peek() {
            None => {}
            Some(')' | '}' | ']') => return Err(reader.scanner.error(ErrorKind::Parenthesis)),
            Some('0'..='9') => return Err(reader.scanner.error(ErrorKind::NumberWithinUnit)),
            Some(found) => return Err(reader.scanner.error(ErrorKind::Unexpected { found })),
        }
    }
    reader
        .builder
        .finish()
        .map_err(|kind| Error::new(kind, 0..text.len()))
}

/// Reads the unit with which a text begins, as far as it goes, and where it ends.
pub(crate) fn front(text: &str) -> Result<(Unit, usize), Error> {
    let end = text
        .char_indices()
        .map(|(at, char)| at + char.len_utf8())
        .take_while(|end| *end <= MAX_LENGTH)
        .last();
    let mut reader = UnitReader {
        scanner: Scanner::new(&text[..end.unwrap_or(0)])?,
        builder: Builder::new(),
        depth: 0,
        is_front: true,
    };
    reader.product()?;
    let end = reader.scanner.at();
    if reader.builder.len() == 0 {
        return Err(reader.scanner.error(ErrorKind::UnitMissing));
    }
    let unit = reader.builder.finish();
    Ok((unit.map_err(|kind| Error::new(kind, 0..end))?, end))
}

struct UnitReader<'a> {
    scanner: Scanner<'a>,
    builder: Builder,
    depth: usize,
    /// Whether something else may follow the unit.
    is_front: bool,
}

/// What stands between two items.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Between {
    Product,
    Slash,
}

impl<'a> UnitReader<'a> {
    fn product(&mut self) -> Result<(), Error> {
        self.space();
        let mut divisor = None;
        if self.slash() {
            divisor = Some(self.divisor()?);
        } else {
            self.item()?;
        }
        loop {
            let kept = (self.scanner, self.builder);
            let may_end = self.is_front && self.depth == 0;
            let between = self.between();
            match self.further(between, kept.0, divisor) {
                Ok(further) => divisor = further,
                Err(error) if may_end && ends_before(between, &error.kind) => {
                    (self.scanner, self.builder) = kept;
                    return Ok(());
                }
                Err(error) => return Err(error),
            }
            if between.is_none() {
                if may_end {
                    self.scanner = kept.0;
                }
                return Ok(());
            }
        }
    }

    /// Reads what comes after a sign between items; the first factor below a slash, if there is one.
    fn further(
        &mut self,
        between: Option<Between>,
        place: Scanner<'a>,
        divisor: Option<usize>,
    ) -> Result<Option<usize>, Error> {
        match (between, divisor) {
            (Some(Between::Slash), None) => return self.divisor().map(Some),
            (Some(Between::Slash), Some(first)) => {
                let second = self.divisor()?;
                // `m/s/s` is the same either way.
                if !self.builder.are_equal(first, second) {
                    return Err(place.error(ErrorKind::SecondSlash));
                }
            }
            (Some(Between::Product), Some(_)) => {
                // What is not a unit is reported first: a remark, or another number.
                let place = self.scanner;
                self.item()?;
                return Err(place.error(ErrorKind::ProductAfterSlash));
            }
            (Some(Between::Product), None) => self.item()?,
            (None, _) => {}
        }
        Ok(divisor)
    }

    /// Reads what a slash divides by; returns its first factor's place.
    fn divisor(&mut self) -> Result<usize, Error> {
        let start = self.builder.len();
        self.space();
        self.item()?;
        self.builder.divide(start);
        Ok(start)
    }

    /// Moves to the next item, if there is one.
    fn between(&mut self) -> Option<Between> {
        self.space();
        if self.slash() {
            return Some(Between::Slash);
        }
        let sign = self.product_sign();
        self.space();
        let begins = |next| is_letter(next) || matches!(next, '(' | '{' | '[' | '\\');
        (sign || self.scanner.peek().is_some_and(begins)).then_some(Between::Product)
    }

    fn slash(&mut self) -> bool {
        let mut ahead = self.scanner;
        let slash = match ahead.peek() {
            Some('/' | '⁄' | '∕' | '÷') => ahead.skip(),
            Some('p' | 'P') => ahead.run(is_letter).eq_ignore_ascii_case("per"),
            _ => false,
        };
        if slash {
            self.scanner = ahead;
        }
        slash
    }

    fn product_sign(&mut self) -> bool {
        match self.scanner.peek() {
            // Hyphen and full stop join units for many, `N-m` and `N.m`.
            Some('·' | '⋅' | '•' | '∙' | '×' | '*' | '.' | '-' | '‐' | '‑') => {
                self.scanner.skip()
            }
            Some('\\') => self.scanner.takes_text("\\cdot") || self.scanner.takes_text("\\times"),
            _ => false,
        }
    }

    /// Moves past white space and what only sets the face of letters.
    fn space(&mut self) {
        self.scanner.space();
        while let Some('\\' | '~' | '$') = self.scanner.peek() {
            if !INVISIBLE
                .into_iter()
                .any(|sign| self.scanner.takes_text(sign))
            {
                return;
            }
            self.scanner.space();
        }
    }

    fn item(&mut self) -> Result<(), Error> {
        self.space();
        if self.scanner.peek() == Some('\\')
            && FRACTIONS
                .into_iter()
                .any(|sign| self.scanner.takes_text(sign))
        {
            return self.fraction();
        }
        let start = self.builder.len();
        // Braces that only set a face enclose nothing: `\mathrm{rad\,s}^{-1}`.
        let is_face = FACES.iter().any(|face| self.scanner.is_behind(face));
        if let Some(close) = self.opening() {
            self.nested(close)?;
            let last = self.builder.len().saturating_sub(1);
            return self.power(if is_face { last } else { start });
        }
        if self.numerator() {
            return Ok(());
        }
        let multiplied = self.square_or_cubic();
        let name = self.letters()?;
        if let Some(power) = multiplied {
            self.raise(self.builder.len() - 1, power)?;
        }
        let behind = self.scanner;
        self.power(self.builder.len() - 1)?;
        // `3 m-2 m` is a difference.
        // Read as a power, the minus would make a wrong unit in silence.
        let is_less = behind.rest().starts_with(['-', '−']) && behind.at() < self.scanner.at();
        if is_less && self.scanner.rest().trim_start().starts_with(name) {
            return Err(behind.error(ErrorKind::Unexpected { found: '-' }));
        }
        Ok(())
    }

    /// Moves past a `1` above a slash.
    fn numerator(&mut self) -> bool {
        let mut ahead = self.scanner;
        let is_one = ahead.takes_one();
        let mut behind = Self {
            scanner: ahead,
            ..*self
        };
        behind.space();
        let is_above = is_one && behind.slash();
        if is_above {
            self.scanner = ahead;
        }
        is_above
    }

    /// Moves past an opening bracket, and returns the closing one.
    fn opening(&mut self) -> Option<char> {
        let close = match self.scanner.peek()? {
            '(' => ')',
            '{' => '}',
            '[' => ']',
            _ => return None,
        };
        self.scanner.skip();
        Some(close)
    }

    fn nested(&mut self, close: char) -> Result<(), Error> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err(self.scanner.error(ErrorKind::Parenthesis));
        }
        self.product()?;
        self.space();
        self.depth -= 1;
        if self.scanner.takes(close) {
            Ok(())
        } else {
            Err(self.scanner.error(ErrorKind::Parenthesis))
        }
    }

    fn fraction(&mut self) -> Result<(), Error> {
        let start = self.builder.len();
        for divisor in [false, true] {
            let start = if divisor { self.builder.len() } else { start };
            self.space();
            if !self.scanner.takes('{') {
                return Err(self.scanner.error(ErrorKind::Parenthesis));
            }
            self.nested('}')?;
            if divisor {
                self.builder.divide(start);
            }
        }
        Ok(())
    }

    /// The power in `square metres` and `cubic metres`.
    fn square_or_cubic(&mut self) -> Option<Rational> {
        let mut ahead = self.scanner;
        let power = match ahead.peek()? {
            's' if ahead.run(is_letter) == "square" => 2,
            'c' if ahead.run(is_letter) == "cubic" => 3,
            _ => return None,
        };
        ahead.space();
        self.scanner = ahead;
        Some(Rational::integer(power))
    }

    /// Reads the units that a run of letters is; returns the run.
    fn letters(&mut self) -> Result<&'a str, Error> {
        let start = self.scanner.at();
        if self.scanner.peek() == Some('\\') && self.scanner.takes_text("\\mu") {
            return self.micro(start);
        }
        let name = match self.scanner.peek() {
            Some('\\' | '^') => self.sign(),
            Some('g') if self.scanner.takes_text("g0") => "g0",
            _ => self.scanner.run(is_letter),
        };
        if name.is_empty() {
            let is_digit = self
                .scanner
                .peek()
                .is_some_and(|next| next.is_ascii_digit());
            return Err(self.scanner.error(if is_digit {
                ErrorKind::NumberWithinUnit
            } else {
                ErrorKind::UnitMissing
            }));
        }
        if is_prefix_word(name)
            && let Some(unit) = self.apart()
        {
            self.units(&format!("{name}{unit}"), start)?;
            return Ok(unit);
        }
        self.units(name, start)?;
        Ok(name)
    }

    /// The letters after a prefix in words that stands apart, `milli meters`, `milli-J`.
    fn apart(&mut self) -> Option<&'a str> {
        let mut ahead = self.scanner;
        ahead.takes('-');
        ahead.space();
        let unit = ahead.run(is_letter);
        let is_unit = !unit.is_empty();
        if is_unit {
            self.scanner = ahead;
        }
        is_unit.then_some(unit)
    }

    /// The units after `\mu`, `\mu m` or `\mu\mathrm{m}`; returns their letters.
    fn micro(&mut self, start: usize) -> Result<&'a str, Error> {
        self.space();
        let is_braced = self.scanner.takes('{');
        let name = self.scanner.run(is_letter);
        if name.is_empty() {
            return Err(self.scanner.error(ErrorKind::UnitMissing));
        }
        if is_braced && !self.scanner.takes('}') {
            return Err(self.scanner.error(ErrorKind::Parenthesis));
        }
        self.units(&format!("µ{name}"), start)?;
        Ok(name)
    }

    /// Adds the units that a run of letters is.
    fn units(&mut self, name: &str, start: usize) -> Result<(), Error> {
        if let Some(above) = joined::per_second(name) {
            self.units(above, start)?;
            let below = self.builder.len();
            self.units("s", start)?;
            self.builder.divide(below);
            return Ok(());
        }
        let span = start..self.scanner.at();
        for found in joined::units(name, span.clone())?.iter() {
            self.builder
                .push(Factor::new(found, Rational::ONE))
                .map_err(|kind| Error::new(kind, span.clone()))?;
        }
        Ok(())
    }

    /// The unit of a sign in LaTeX; nothing if there is none.
    fn sign(&mut self) -> &'static str {
        let known = SIGNS
            .into_iter()
            .find(|(sign, _)| self.scanner.takes_text(sign));
        known.map_or("", |(_, unit)| unit)
    }

    /// Reads a power, if there is one, and raises what stands from the factor `start` on.
    fn power(&mut self, start: usize) -> Result<(), Error> {
        let behind = self.scanner;
        let place = behind.at();
        let mut ahead = self.scanner;
        let mut spaced = ahead;
        spaced.space();
        if spaced.peek() == Some('^')
            && !SIGNS
                .into_iter()
                .any(|(sign, _)| spaced.rest().starts_with(sign))
        {
            ahead = spaced;
        }
        let power = if ahead.takes('^') || ahead.takes_text("**") {
            ahead.space();
            ahead
                .exponent(true)
                .and_then(|power| halved(&mut ahead, power))
        } else if let Some(power) = ahead.superscript() {
            Some(power)
        } else if begins_exponent(ahead.rest()) && !self.builder.ends_with_sign() {
            let power = ahead
                .exponent(true)
                .filter(|power| power.abs().is_integer() && power.abs().numerator() <= 4);
            // `10 mm-5 mm` goes on after the unit.
            let is_number = power.is_none() || ahead.rest().trim_start().starts_with(is_letter);
            if self.is_front && self.depth == 0 && behind.rest().starts_with('-') && is_number {
                return Ok(());
            }
            power
        } else {
            ahead.space();
            match ahead.peek() {
                Some('s') if ahead.run(is_letter) == "squared" => Some(Rational::integer(2)),
                Some('c') if ahead.run(is_letter) == "cubed" => Some(Rational::integer(3)),
                _ => return Ok(()),
            }
        };
        self.scanner = ahead;
        self.raise(
            start,
            power
                .filter(|power| !power.is_zero())
                .ok_or_else(|| Error::new(ErrorKind::NotAnExponent, place..ahead.at()))?,
        )
    }

    fn raise(&mut self, start: usize, power: Rational) -> Result<(), Error> {
        let at = self.scanner.at();
        self.builder
            .raise(start, power)
            .map_err(|kind| Error::new(kind, at..at))
    }
}

/// Whether what follows a unit is no part of it: nothing that could be a unit, or a letter of something else.
fn ends_before(between: Option<Between>, error: &ErrorKind) -> bool {
    match error {
        ErrorKind::UnitMissing
        | ErrorKind::NumberWithinUnit
        | ErrorKind::Unexpected { .. }
        | ErrorKind::Parenthesis => true,
        ErrorKind::UnknownUnit { .. } => between == Some(Between::Product),
        _ => false,
    }
}

/// An exponent of one, up or down, with what may divide it: `-1/2`. After others, a number below a slash is refused.
fn halved(scanner: &mut Scanner<'_>, power: Rational) -> Option<Rational> {
    let mut ahead = *scanner;
    if power.abs() != Rational::ONE || !ahead.takes('/') || !begins_exponent(ahead.rest()) {
        return Some(power);
    }
    let divisor = ahead
        .plain_exponent()
        .filter(|divisor| divisor.is_integer() && !divisor.is_negative())?;
    *scanner = ahead;
    power.checked_mul(Rational::new(1, divisor.numerator())?)
}

/// Whether a digit comes next, or a minus and a digit, as in `m2` and `s-2`.
fn begins_exponent(rest: &str) -> bool {
    let unsigned = rest.strip_prefix(['-', '−']).unwrap_or(rest);
    unsigned.starts_with(|char: char| char.is_ascii_digit())
}

/// What people put between a number and its unit.
const TIMES_SIGNS: [&str; 6] = ["·", "⋅", "×", "*", "\\cdot", "\\times"];

const FRACTIONS: [&str; 3] = ["\\frac", "\\dfrac", "\\tfrac"];

/// LaTeX for units, with their symbols in files.
const SIGNS: [(&str, &str); 5] = [
    ("^\\circ", "deg"),
    ("^{\\circ}", "deg"),
    ("\\circ", "deg"),
    ("\\degree", "deg"),
    ("\\Omega", "ohm"),
];

/// LaTeX for the face of letters.
const FACES: [&str; 3] = ["\\mathrm", "\\text", "\\rm"];

/// LaTeX that shows nothing.
const INVISIBLE: [&str; 13] = [
    "~", "\\,", "\\;", "\\:", "\\!", "\\ ", "\\quad", "\\mathrm", "\\text", "\\rm", "\\left",
    "\\right", "$",
];

#[cfg(test)]
mod tests;
