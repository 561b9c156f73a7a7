//! Tokens among values: exact decimals, units after numbers, words that join.

use super::before_unit::gathered;
use super::digits::Comma;
use super::letters::Letters;
use super::lexer::Lexer;
use super::signs::{DECIMAL, is_digit, is_of_name};
use super::token::{Item, Literal};
use super::words::JOINING;
use super::{Trouble, TypedError, ValueTrouble};
use vibank_dynamics::numerics::Rational;
use vibank_formula::expr::{Constant, Expr, Kind};
use vibank_formula::unit::{Decimal, DecimalMark, Error, ErrorKind, Unit};
use vibank_formula::work;
use vibank_source::Span;

/// Longest unit that is read, in bytes; with all in words or in LaTeX the longest have half of it.
const MAX_UNIT_LENGTH: usize = 200;

/// A text that begins with a number, with a point for the sign in it that is a decimal sign and nothing else.
fn with_certain_sign(text: &str) -> Option<String> {
    let behind = text.trim_start_matches(is_digit);
    let decimals = behind.strip_prefix(DECIMAL)?;
    let whole = &text[..text.len() - behind.len()];
    Some(format!("{whole}.{decimals}"))
}

/// A text that begins with a number in the way of Fortran, `1.58D+01`, with an `e` in it.
fn with_exponent_sign(text: &str) -> Option<String> {
    let behind = text.trim_start_matches(|char: char| char.is_ascii_digit() || ".,".contains(char));
    let digits = &text[..text.len() - behind.len()];
    let power = behind.strip_prefix(['D', 'd'])?;
    let figures = power.strip_prefix(['+', '-']).unwrap_or(power);
    let count = figures.bytes().take_while(u8::is_ascii_digit).count();
    let ends = !figures[count..].starts_with(char::is_alphanumeric);
    (!digits.is_empty() && (1..=3).contains(&count) && ends).then(|| format!("{digits}e{power}"))
}

impl Lexer<'_> {
    /// What is read otherwise among values than within a formula; whether it stands here.
    pub(crate) fn value(&mut self, char: char) -> Result<bool, TypedError> {
        let Some(mark) = self.manner.values else {
            return Ok(false);
        };
        match char {
            '\n' => self.take(1, Item::Sign(';')),
            '(' => {
                if self.is_behind_value() && self.unit_here() {
                    return Ok(true);
                }
                return Ok(false);
            }
            // Where numbers are complex, `\mathrm{j}` is no joule.
            '\\' if self.manner.has_imaginary_unit && self.rest().starts_with("\\mathrm{j}") => {
                return Ok(false);
            }
            '[' | '\\' => return Ok(self.is_behind_value() && self.unit_here()),
            '1' if self.is_spaced
                && self.is_behind_value()
                && self.rest()[1..].starts_with('/') =>
            {
                return if self.unit_here() {
                    Ok(true)
                } else {
                    self.decimal(mark).map(|()| true)
                };
            }
            '0'..='9' => self.decimal(mark)?,
            '.' | ',' => {
                let goes_on = self.rest()[1..].starts_with(is_digit);
                let is_first = match self.tokens.last().map(|token| &token.item) {
                    None => true,
                    Some(Item::Sign(sign)) => !matches!(sign, ')' | ']' | '}'),
                    Some(_) => char == '.' && self.is_spaced,
                };
                if char == ',' && !(goes_on && is_first && self.has_decimal_comma()) {
                    self.comma();
                    return Ok(true);
                }
                if !(goes_on && is_first) {
                    return Ok(false);
                }
                self.decimal(mark)?;
            }
            '°' => self.degree(),
            '%' | '‰' => {
                if !self.unit_here() {
                    return Ok(false);
                }
            }
            'I' if self.manner.has_imaginary_unit && !self.rest()[1..].starts_with(is_of_name) => {
                let span = Span::new(self.at, self.at + 1);
                let unit = Kind::Constant(Constant::ImaginaryUnit);
                self.take(1, Item::Leaf(Expr::new(unit, span)));
            }
            '\'' | '"' => {
                let start = self.at;
                self.at += 1;
                return self.error(Trouble::Sign, start);
            }
            'x' | 'X' if self.is_cross() => self.take(1, Item::Sign('*')),
            // `θ ∈ {0, π}`
            '∈' => self.take(char.len_utf8(), Item::Sign('=')),
            ':' | '±' | '∓' | '∠' => self.take(char.len_utf8(), Item::Sign(char)),
            _ => return Ok(self.joining_word()),
        }
        Ok(true)
    }

    /// Whether a unit may stand here: after a number, or after what multiplies or divides one.
    fn is_behind_value(&self) -> bool {
        match self.tokens.last().map(|token| &token.item) {
            Some(Item::Number(_) | Item::Power(_)) => true,
            Some(Item::Leaf(leaf)) => matches!(leaf.kind(), Kind::Constant(_)),
            Some(Item::Sign(sign)) => matches!(sign, ')' | '}' | ']' | '*' | '/'),
            Some(_) | None => false,
        }
    }

    /// The text that may be a unit: up to a word that joins, or the end of the line.
    fn unit_text(&self) -> &str {
        let rest = self.rest();
        // Each word of a long text may be a unit: none of them is looked for in all of it.
        let rest = &rest[..rest.floor_char_boundary(MAX_UNIT_LENGTH)];
        // A text whose units are used up is not read in the end.
        let _ = work::spend(rest.len() as u64);
        let line = rest.find('\n').unwrap_or(rest.len());
        let mut words = rest.match_indices(' ').map(|(space, _)| space + 1);
        let joining = words.find(|at| {
            let mut behind = JOINING
                .iter()
                .filter_map(|word| rest[*at..].strip_prefix(word));
            behind.any(|behind| behind.starts_with(' '))
        });
        let end = joining.unwrap_or(line).min(line);
        let text = &rest[..self.name_in(&rest[..end]).unwrap_or(end)];
        // In `5 ∠ 53 deg ohm` the angle has its unit, and the whole has its own after that.
        match text.split_once(' ') {
            Some((first, _)) if self.is_behind_angle() => first,
            _ => text,
        }
    }

    /// Where a name of the answer stands after other letters, which are the unit before it: `5 rad/s t`.
    fn name_in(&self, text: &str) -> Option<usize> {
        if self.lexicon.is_empty() {
            return None;
        }
        let mut places = text.char_indices().map(|(at, _)| at).skip(1);
        places.find(|at| {
            let rest = &text[*at..];
            let end = || rest.len() - rest.trim_start_matches(is_of_name).len();
            !text[..*at].ends_with(is_of_name) && self.lexicon.reads(&rest[..end()]).is_some()
        })
    }

    /// Takes the unit that stands here; whether one does.
    fn unit_here(&mut self) -> bool {
        let Ok((unit, end)) = Unit::read_front(self.unit_text()) else {
            return false;
        };
        if end > 0 {
            self.take(end, Item::Unit(Box::new(gathered(unit))));
        }
        end > 0
    }

    /// Whether a number stands before this place, and the sign of an angle before that.
    fn is_behind_angle(&self) -> bool {
        let mut before = self.tokens.iter().rev();
        let is_number = before.next().is_some_and(|token| token.literal.is_some());
        let mut signs = before.skip_while(|token| matches!(token.item, Item::Sign('-' | '+')));
        let sign = signs.next().map(|token| &token.item);
        is_number && matches!(sign, Some(Item::Sign('∠') | Item::Word("at" | "cis")))
    }

    /// A sign of degrees; a rate of them if a slash follows.
    fn degree(&mut self) {
        let width = '°'.len_utf8();
        let behind = self.rest()[width..].trim_start();
        let is_rate = behind.starts_with(['/', '^', '²']) || behind.starts_with("per ");
        if is_rate && self.unit_here() {
            return;
        }
        let degree = Unit::degree();
        self.take(width, Item::Unit(Box::new(degree)));
    }

    /// Whether the letter x stands between two numbers.
    fn is_cross(&self) -> bool {
        let last = self.tokens.last();
        let is_behind = last
            .and_then(|token| token.literal)
            .is_some_and(|literal| !literal.value.is_zero());
        let factor = self.rest()[1..].trim_start();
        // Nobody multiplies by nothing: `0.5 x0` is of x_0.
        let decimals = factor.strip_prefix('0');
        let is_nothing = decimals.is_some_and(|rest| !rest.starts_with(['.', ',', DECIMAL]));
        is_behind && !is_nothing && factor.starts_with(is_digit)
    }

    /// A word that joins; whether one stands here.
    fn joining_word(&mut self) -> bool {
        const WORDS: [&str; 6] = ["and", "or", "at", "cis", "in", "not"];
        let rest = self.rest();
        let mut words = WORDS.into_iter().filter(|word| rest.starts_with(word));
        let found = words.find(|word| rest[word.len()..].starts_with(|next| !is_of_name(next)));
        if let Some(word) = found {
            self.take(word.len(), Item::Word(word));
        }
        found.is_some()
    }

    /// Takes a comma that is not a decimal sign by now; within an arc tangent it may still be meant as one.
    pub(crate) fn comma(&mut self) {
        let is_open = self.manner.comma_is_decimal && self.comma_here() == Comma::Either;
        self.take(1, Item::Sign(if is_open { DECIMAL } else { ',' }));
    }

    /// Whether a comma between digits is a decimal sign here.
    pub(crate) fn has_decimal_comma(&self) -> bool {
        self.manner.comma_is_decimal && !self.parts_arguments()
    }

    /// An exact decimal, with its power of ten.
    fn decimal(&mut self, mark: DecimalMark) -> Result<(), TypedError> {
        let start = self.at;
        let is_tied = match self.tokens.last().map(|token| &token.item) {
            Some(Item::Sign(sign)) => matches!(sign, '/' | '^'),
            Some(Item::Root | Item::Function(_) | Item::Powered(_)) => true,
            _ => false,
        };
        let rest = self.rest();
        // What binds closer than a product takes no power of ten after a sign of multiplication.
        let mut end = rest.len();
        if is_tied {
            end = rest.find(['*', 'x', 'X', '\\']).unwrap_or(end);
        }
        if !self.has_decimal_comma() {
            end = end.min(rest.find(',').unwrap_or(end));
        }
        // The point at the end of a sentence.
        let sentence = rest.trim_end();
        if sentence.ends_with('.') && sentence[..sentence.len() - 1].contains(['.', ',', DECIMAL]) {
            end = end.min(sentence.len() - 1);
        }
        let text = &rest[..end];
        let plain = with_exponent_sign(text);
        let text = plain.as_deref().unwrap_or(text);
        let certain = with_certain_sign(text);
        let read = match &certain {
            Some(plain) => Decimal::read(plain, DecimalMark::Point).map(|(value, length)| {
                // The point is narrower than the sign for which it stands, if it was read at all.
                let is_read = text.find(DECIMAL).is_some_and(|at| at < length);
                let widened = if is_read { DECIMAL.len_utf8() - 1 } else { 0 };
                (value, length + widened)
            }),
            None => Decimal::read(text, mark),
        };
        let (literal, length) = match read {
            Ok((value, length)) => (Literal { value, other: None }, length),
            Err(Error {
                kind: ErrorKind::AmbiguousComma { found },
                span,
            }) => {
                let read = Decimal::read(text, DecimalMark::Comma);
                let (value, length) = read.map_err(|error| self.unreadable(&error, start))?;
                let whole: String = found.chars().filter(char::is_ascii_digit).collect();
                let plain = format!("{whole}{}", &text[span.end.min(text.len())..]);
                let other = Decimal::read(&plain, DecimalMark::Point).ok();
                let other = other.map(|(value, _)| value);
                (Literal { value, other }, length)
            }
            Err(error) => return Err(self.unreadable(&error, start)),
        };
        self.at += length;
        match Rational::from_decimal(&literal.value.to_string()) {
            Some(number) => self.push(Item::Number(number), start),
            None => {
                let error = TypedError::new(Trouble::Number, start, self.at);
                self.push(Item::Unread(Box::new(error)), start);
            }
        }
        if let Some(last) = self.tokens.last_mut() {
            last.literal = Some(literal);
        }
        Ok(())
    }

    /// Why a number or a unit here cannot be read, and what to type instead.
    fn unreadable(&self, error: &Error, start: usize) -> TypedError {
        // A decimal sign may be wider in the text than where the number was read.
        let boundary = |at: usize| {
            let mut places = at..self.text.len();
            places
                .find(|at| self.text.is_char_boundary(*at))
                .unwrap_or(self.text.len())
        };
        let end = boundary(start + error.span.end);
        TypedError {
            trouble: Trouble::Value(ValueTrouble::Quantity(error.clone())),
            span: Span::new(boundary(start + error.span.start).min(end), end),
        }
    }

    /// Takes a run of letters that is not a word as a unit.
    ///
    /// # Errors
    ///
    /// That it is none.
    pub(crate) fn unit_or_unknown(
        &mut self,
        letters: &Letters,
        start: usize,
        end: usize,
    ) -> Result<(), TypedError> {
        if self.unit_of_run(letters, start, end) {
            return Ok(());
        }
        if let Some(error) = self.no_unit(start) {
            return Err(error);
        }
        let trouble = self.lexicon.unknown("");
        Err(TypedError::new(trouble, start, end))
    }

    /// Takes a run of letters that is not a word as a unit, `rad/s`, or as a constant before one, `iΩ`; whether it is.
    fn unit_of_run(&mut self, letters: &Letters, start: usize, end: usize) -> bool {
        if self.manner.values.is_none() {
            return false;
        }
        let after = self.at;
        self.at = start;
        if self.unit_covers(end) {
            return true;
        }
        for (own, place) in letters.cuts.iter().skip(1) {
            let constant = match &letters.text[..*own] {
                "pi" | "Pi" => Constant::Pi,
                "i" | "j" if self.manner.has_imaginary_unit => Constant::ImaginaryUnit,
                _ => continue,
            };
            let count = self.tokens.len();
            let leaf = Expr::new(Kind::Constant(constant), Span::new(start, *place));
            self.at = *place;
            self.push(Item::Leaf(leaf), start);
            if self.unit_covers(end) {
                return true;
            }
            self.tokens.truncate(count);
            self.at = start;
        }
        self.at = after;
        false
    }

    /// Takes the letter j behind a value as joule, `2.8 j`, where no number is complex; whether it is.
    pub(crate) fn joule(&mut self, letters: &Letters, start: usize) -> bool {
        let is_it = letters.text == "j"
            && self.manner.values.is_some()
            && !self.manner.has_imaginary_unit
            && self.is_behind_value();
        if is_it && let Ok(unit) = Unit::read("J") {
            self.push(Item::Unit(Box::new(gathered(unit))), start);
        }
        is_it
    }

    /// Takes the unit that stands here, if it reaches the end of a run.
    fn unit_covers(&mut self, end: usize) -> bool {
        let read = Unit::read_front(self.unit_text());
        let Ok((unit, length)) = read else {
            return false;
        };
        let reaches = self.at + length >= end;
        if reaches {
            self.take(length, Item::Unit(Box::new(gathered(unit))));
        }
        reaches
    }

    /// Why a run of letters after a number is not a unit.
    fn no_unit(&mut self, start: usize) -> Option<TypedError> {
        if self.manner.values.is_none() || !self.is_behind_value() {
            return None;
        }
        let after = std::mem::replace(&mut self.at, start);
        let error = Unit::read_front(self.unit_text()).err();
        self.at = after;
        error.map(|error| self.unreadable(&error, start))
    }
}
