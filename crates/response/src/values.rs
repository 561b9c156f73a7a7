//! Responses made of values: statements, sides and amounts, from one row of tokens.
//!
//! ```text
//! response  = statement { ( ";" | "," | new line | "and" | "or" ) statement }
//! statement = side { ( "=" | ":" | "<" | … ) side }
//! side      = name | amount
//! amount    = formula of numbers, in which units come after numbers or after the whole
//! ```
//!
//! What cannot be read is kept as a token that says why, and is an error only where its place is read as an amount:
//! `natural frequency = 5 Hz` has a name of two words before its equals sign.

mod amounts;

use std::ops::Range;
use std::sync::LazyLock;

use super::both_signs::Two;
use super::lexer::tokens;
use super::signs::is_digit;
use super::token::{Item, Token};
use super::{Lexicon, Manner, Passage, Reworded, Trouble, TypedError};
use vibank_dynamics::numerics::Rational;
use vibank_formula::expr::{Constant, Kind};
use vibank_formula::unit::{DecimalMark, Unit};
use vibank_source::Span;

/// Longest response that is read as values, in bytes.
const MAX_LENGTH: usize = 2_000;
/// Longest formula of numbers, in bytes.
const MAX_FORMULA_LENGTH: usize = 200;

/// Functions and constants, but no names.
static NUMBERS: LazyLock<Lexicon> = LazyLock::new(Lexicon::new);

/// A response as tokens, which its statements, sides and amounts are ranges of.
#[derive(Debug)]
pub struct Values<'t> {
    text: &'t str,
    tokens: Vec<Token>,
}

/// How a response of values is read.
#[derive(Clone, Copy, Debug)]
pub struct Style {
    /// The decimal sign of the document.
    pub mark: DecimalMark,
    /// Whether a comma between digits is a decimal sign; otherwise it parts values.
    pub comma_is_decimal: bool,
    /// Whether `i` and `j` are the imaginary unit.
    pub is_complex: bool,
}

/// A part of the response, as a range of its tokens.
pub type Part = Range<usize>;

/// A statement by its sides and the signs between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// At least one; empty ones are left away.
    pub sides: Vec<Part>,
    /// A sign that is not an equals sign, if there is one.
    pub unequal: Option<char>,
}

impl<'t> Values<'t> {
    /// Reads the tokens of a response.
    ///
    /// # Errors
    ///
    /// Only if it is too long.
    pub fn read(passage: Passage<'t>, style: Style) -> Result<Self, TypedError> {
        let text = passage.text();
        if text.len() > MAX_LENGTH {
            return Err(TypedError::new(Trouble::TooLong, MAX_LENGTH, text.len()));
        }
        let manner = Manner {
            comma_is_decimal: style.comma_is_decimal,
            has_imaginary_unit: style.is_complex,
            values: Some(style.mark),
            ..Manner::default()
        };
        let tokens = tokens(text, 0, text.len(), &NUMBERS, manner)?;
        Ok(Self { text, tokens })
    }

    /// What was typed.
    pub fn whole(&self) -> Passage<'t> {
        Passage::of(self.text)
    }

    /// What was typed where something cannot be read.
    pub fn typed(&self, error: &TypedError) -> Passage<'t> {
        self.whole().part(error.span)
    }

    /// What was typed as a part.
    pub fn passage(&self, part: &Part) -> Passage<'t> {
        Passage::of(self.text(part))
    }

    /// The whole response as one part.
    pub fn all(&self) -> Part {
        0..self.tokens.len()
    }

    fn text(&self, part: &Part) -> &'t str {
        let span = self.span(part);
        self.text.get(span.range()).unwrap_or_default()
    }

    /// Where a part stands.
    pub fn span(&self, part: &Part) -> Span {
        match (self.tokens.get(part.start), self.tokens[..part.end].last()) {
            (Some(first), Some(last)) if !part.is_empty() => first.span.join(last.span),
            _ => Span::new(self.text.len(), self.text.len()),
        }
    }

    fn items<'a>(&'a self, part: &Part) -> impl DoubleEndedIterator<Item = &'a Item> + use<'a, 't> {
        self.tokens[part.clone()].iter().map(|token| &token.item)
    }

    /// Whether a sign or joining word stands outside of brackets.
    pub fn has(&self, part: &Part, sign: char) -> bool {
        self.cut(part, |item| *item == Item::Sign(sign)).len() > 1
    }

    /// Whether something else than a comma between digits parts values: a semicolon, a word, a comma and a space.
    pub fn is_parted(&self) -> bool {
        let mut before = None;
        self.tokens.iter().any(|token| {
            let behind = before.replace(&token.item);
            matches!(token.item, Item::Sign(';' | '&') | Item::Word("and" | "or"))
                || token.is_spaced && behind == Some(&Item::Sign(','))
        })
    }

    /// Whether a comma stands right between two digits.
    pub fn has_tight_comma(&self, part: &Part) -> bool {
        let text = self.text(part);
        text.bytes()
            .zip(text.bytes().skip(1))
            .zip(text.bytes().skip(2))
            .any(|((a, comma), b)| a.is_ascii_digit() && comma == b',' && b.is_ascii_digit())
    }

    /// Whether a comma between digits can only be a decimal sign: other than three digits come after it, or a zero alone
    /// before it.
    pub fn has_decimal_comma(&self, part: &Part) -> bool {
        let text = self.text(part);
        text.match_indices(',').any(|(at, _)| {
            let before = &text[..at];
            let figures = before.len() - before.trim_end_matches(is_digit).len();
            let behind = &text[at + 1..];
            let decimals = behind.len() - behind.trim_start_matches(is_digit).len();
            let is_zero = figures == 1 && before.ends_with('0');
            figures > 0 && decimals > 0 && (decimals != 3 || is_zero)
        })
    }

    /// Whether nothing stands where a part is empty, between two signs that part values: `5,, 8.7`. The end of a line
    /// and a word may follow a sign.
    pub fn is_gap(&self, part: &Part) -> bool {
        let sign = |at: usize| {
            let token = self.tokens.get(at)?;
            Some(&self.text[token.span.range()]).filter(|sign| matches!(*sign, "," | ";"))
        };
        // `5, ; 8.7` has one value behind the other, parted twice.
        let before = part.start.checked_sub(1).and_then(sign);
        part.is_empty() && before.is_some() && sign(part.end) == before
    }

    /// The values of a part between semicolons, commas, `and` and `or`; empty ones are kept.
    pub fn statements(&self, part: &Part) -> Vec<Part> {
        self.cut(part, |item| {
            matches!(item, Item::Sign(';' | ',' | '&') | Item::Word("and" | "or"))
        })
    }

    fn cut(&self, part: &Part, is_end: impl Fn(&Item) -> bool) -> Vec<Part> {
        let (mut parts, mut start, mut depth) = (Vec::new(), part.start, 0_usize);
        for at in part.clone() {
            match &self.tokens[at].item {
                Item::Sign('(' | '[' | '{') => depth += 1,
                Item::Sign(')' | ']' | '}') => depth = depth.saturating_sub(1),
                item if depth == 0 && is_end(item) => {
                    parts.push(start..at);
                    start = at + 1;
                }
                _ => {}
            }
        }
        parts.push(start..part.end);
        parts
    }

    /// The sides of a statement.
    pub fn statement(&self, part: &Part) -> Statement {
        let mut unequal = self.items(part).find_map(|item| match item {
            Item::Sign(sign @ ('<' | '>' | '≤' | '≥' | '≠')) => Some(*sign),
            _ => None,
        });
        let mut sides = self.cut(part, |item| matches!(item, Item::Sign('=' | ':')));
        sides.retain(|side| !side.is_empty());
        // Only a name may stand before a colon.
        let mut first = sides.first().into_iter();
        if self.has(part, ':') && !first.any(|own| self.is_name(&self.unit_beside_name(own).0)) {
            unequal = Some(':');
        }
        if sides.is_empty() {
            sides.push(part.end..part.end);
        }
        Statement { sides, unequal }
    }

    /// A named value before the only sign of comparison, that sign, and what it is compared with: `ζ = 0.285 < 1`.
    pub fn compared(&self, part: &Part) -> Option<(Part, char, Part)> {
        let pieces = self.cut(part, |item| {
            matches!(item, Item::Sign('<' | '>' | '≤' | '≥' | '≠' | '±' | ':'))
        });
        let [value, other] = &pieces[..] else {
            return None;
        };
        let Some(Item::Sign(sign @ ('<' | '>'))) =
            self.tokens.get(value.end).map(|token| &token.item)
        else {
            return None;
        };
        // `3 N > 0` says the sign again, `0.16 < 1` that a ratio is small.
        let is_remark = other.len() == 1
            && matches!(self.tokens[other.start].item, Item::Number(own) if own.is_zero() || own == Rational::ONE);
        let is_stated = (self.has(value, '=') || is_remark) && !self.has(other, '=');
        is_stated.then(|| (value.clone(), *sign, other.clone()))
    }

    /// The first bracket without a partner of its kind.
    pub fn lone_bracket(&self) -> Option<Passage<'t>> {
        let mut open: Vec<(char, &Token)> = Vec::new();
        for token in &self.tokens {
            let Item::Sign(sign) = token.item else {
                continue;
            };
            let partner = match sign {
                '(' => ')',
                '[' => ']',
                '{' => '}',
                ')' | ']' | '}' => match open.pop() {
                    Some((partner, _)) if partner == sign => continue,
                    _ => return Some(self.whole().part(token.span)),
                },
                _ => continue,
            };
            open.push((partner, token));
        }
        Some(self.whole().part(open.first()?.1.span))
    }

    /// The brackets around the whole of a part, by what they hold.
    pub fn unbracketed(&self, part: &Part) -> Option<Part> {
        let (inner, rest) = self.front_bracket(part)?;
        rest.is_empty().then_some(inner)
    }

    /// What the bracket holds with which a part begins, and what comes after it.
    pub fn front_bracket(&self, part: &Part) -> Option<(Part, Part)> {
        let mut depth = 0_usize;
        for at in part.clone() {
            match &self.tokens[at].item {
                Item::Sign('(' | '[' | '{') => depth += 1,
                Item::Sign(')' | ']' | '}') => depth = depth.saturating_sub(1),
                _ => {}
            }
            if depth == 0 {
                let is_bracket = at > part.start;
                return is_bracket.then(|| (part.start + 1..at, at + 1..part.end));
            }
        }
        None
    }

    /// What stands before the bracket with which a part ends, and what that holds; only after a value.
    pub fn back_bracket(&self, part: &Part) -> Option<(Part, Part)> {
        let mut depth = 0_usize;
        let open = part.clone().rev().find(|at| {
            match &self.tokens[*at].item {
                Item::Sign(')' | ']' | '}') => depth += 1,
                Item::Sign('(' | '[' | '{') => depth = depth.saturating_sub(1),
                _ => {}
            }
            depth == 0
        })?;
        let before = open.checked_sub(1).filter(|at| part.contains(at))?;
        let is_value = match &self.tokens[before].item {
            Item::Leaf(leaf) => matches!(leaf.kind(), Kind::Constant(_)),
            item => matches!(item, Item::Number(_) | Item::Unit(_)),
        };
        let last = part.end.checked_sub(1).filter(|last| *last > open)?;
        is_value.then_some((part.start..before + 1, open + 1..last))
    }

    /// Whether another part is the unit once more in which a value ends, `s (second)`.
    pub fn is_unit_again(&self, value: &Part, other: &Part) -> bool {
        match (self.items(value).next_back(), self.unit(other)) {
            (Some(Item::Unit(own)), Some(other)) => {
                own.dimension() == other.dimension()
                    && own.to_si(1.0) == other.to_si(1.0)
                    && own.angles() == other.angles()
            }
            _ => false,
        }
    }

    /// The unit that makes up a part.
    pub fn unit(&self, part: &Part) -> Option<Unit> {
        match &self.tokens[part.clone()] {
            [
                Token {
                    item: Item::Unit(unit),
                    ..
                },
            ] => Some(**unit),
            _ => None,
        }
    }

    /// Whether numbers and their signs alone make up a part, parted by spaces, as in `[5 8.7]`; by what they are.
    pub fn spaced(&self, part: &Part) -> Option<Vec<Part>> {
        let (mut parts, mut start) = (Vec::new(), part.start);
        for at in part.clone() {
            match &self.tokens[at] {
                Token {
                    item: Item::Sign('-' | '+'),
                    ..
                } if at == start => {}
                token
                    if token.literal.is_some()
                        && (start == part.start || self.tokens[start].is_spaced)
                        // `5 - 3` is a difference, `5 -3` two numbers.
                        && (at == start || !token.is_spaced) =>
                {
                    parts.push(start..at + 1);
                    start = at + 1;
                }
                // The unit of all of them.
                token if matches!(token.item, Item::Unit(_)) && at + 1 == part.end => {
                    parts.last_mut()?.end = part.end;
                    start = part.end;
                }
                _ => return None,
            }
        }
        (start == part.end && parts.len() > 1).then_some(parts)
    }

    /// A number without the unit after it.
    pub fn without_unit(&self, part: &Part) -> Part {
        let has_unit = matches!(self.items(part).next_back(), Some(Item::Unit(_)));
        part.start..part.end - usize::from(has_unit)
    }

    /// The values that signs of ascending order part, `5 < 8.7 < 9`.
    pub fn ascending(&self, part: &Part) -> Option<Vec<Part>> {
        let pieces = self.cut(part, |item| *item == Item::Sign('<'));
        let is_value = |piece: &Part| self.has_number(piece) && !self.is_name(piece);
        (pieces.len() > 1 && pieces.iter().all(is_value)).then_some(pieces)
    }

    /// The numbers, perhaps with their units, that slashes between spaces part, `5 / 8.7 rad/s`.
    pub fn slashed(&self, part: &Part) -> Option<Vec<Part>> {
        let pieces = self.cut(part, |item| *item == Item::Sign('/'));
        let are_apart = pieces[1..].iter().all(|piece| {
            let around = self.tokens.get(piece.start - 1..=piece.start);
            around.is_some_and(|around| around.iter().all(|token| token.is_spaced))
        });
        let mut values = pieces.iter().map(|piece| self.literal(piece));
        (pieces.len() > 1 && are_apart && values.all(|own| own.is_some())).then_some(pieces)
    }

    /// Numbers with their units or after names, parted by spaces alone: `5 rad/s 8.7 rad/s`, `a = 5 b = 8.7`.
    pub fn spaced_amounts(&self, part: &Part) -> Option<Vec<Part>> {
        let is_named = |at: usize| {
            let behind = self.tokens.get(at + 1).filter(|_| at + 1 < part.end);
            behind.is_some_and(|token| matches!(token.item, Item::Sign('=' | ':')))
        };
        let later = (part.start + 1..part.end).filter(|at| {
            let [before, token] = [&self.tokens[at - 1], &self.tokens[*at]];
            let is_behind_unit = matches!(before.item, Item::Unit(_));
            let begins = token.literal.is_some() && is_behind_unit
                || is_named(*at) && (is_behind_unit || before.literal.is_some());
            begins && token.is_spaced
        });
        let starts: Vec<usize> = std::iter::once(part.start).chain(later).collect();
        let ends = starts[1..].iter().copied().chain([part.end]);
        let parts: Vec<Part> = starts
            .iter()
            .zip(ends)
            .map(|(start, end)| *start..end)
            .collect();
        let are_amounts = parts.len() > 1
            && parts.iter().all(|own| {
                let first = self.tokens.get(own.start);
                first.is_some_and(|first| first.literal.is_some())
                    && self.items(own).any(|item| matches!(item, Item::Unit(_)))
                    || is_named(own.start)
            });
        are_amounts.then_some(parts)
    }

    /// A part with the upper and with the lower one of its signs `±`, and whether such is its first sign.
    pub fn both_signs(&self, part: &Part) -> Option<([Reworded; 2], bool)> {
        let is_first = self.items(part).next() == Some(&Item::Sign('±'));
        let two = Two::of(self.text(part), 0, self.text(part))?;
        Some((two.texts().map(Reworded::of), is_first))
    }

    /// The modulus and the angle around `∠`, `at` or `cis`, or around a comma before an angle in degrees.
    pub fn polar(&self, part: &Part) -> Option<(Part, Part)> {
        let is_angle = |item: &Item| matches!(item, Item::Sign('∠') | Item::Word("at" | "cis"));
        let of_sign = self.items(part).position(is_angle);
        let at = part.start + of_sign.or_else(|| self.comma_before_degrees(part))?;
        Some((part.start..at, at + 1..part.end))
    }

    /// The only comma of a part that ends with an angle in degrees.
    fn comma_before_degrees(&self, part: &Part) -> Option<usize> {
        let is_degrees = matches!(self.items(part).next_back(), Some(Item::Unit(unit)) if **unit == Unit::degree());
        let is_comma = |item: &Item| *item == Item::Sign(',');
        let commas = self.items(part).filter(|item| is_comma(item)).count();
        let place = || self.items(part).position(is_comma);
        (is_degrees && commas == 1).then(place).flatten()
    }

    /// An angle without the unit that comes after its own, as in `-53° ohm`.
    pub fn unit_behind_angle(&self, part: &Part) -> (Part, Option<Unit>) {
        match &self.tokens[part.clone()] {
            [
                ..,
                Token {
                    item: Item::Unit(_),
                    ..
                },
                Token {
                    item: Item::Unit(unit),
                    ..
                },
            ] => (part.start..part.end - 1, Some(**unit)),
            [
                ..,
                close,
                Token {
                    item: Item::Unit(unit),
                    ..
                },
            ] if close.item == Item::Sign(')') && !unit.dimension().is_pure() => {
                (part.start..part.end - 1, Some(**unit))
            }
            _ => (part.clone(), None),
        }
    }

    /// Whether a part only names a quantity: `ω_0`, `x(0.5 s)`, `natural frequency`, `|X|`.
    pub fn is_name(&self, part: &Part) -> bool {
        let begins = match self.items(part).next() {
            Some(Item::Unread(error)) => self.text[error.span.range()]
                .starts_with(|char: char| char.is_alphabetic() || char == '\\'),
            Some(Item::Leaf(leaf)) => !matches!(
                leaf.kind(),
                Kind::Constant(Constant::Pi | Constant::Infinity)
            ),
            Some(Item::Unit(_)) => self
                .text(part)
                .starts_with(|char: char| char.is_alphabetic() || char == '\\'),
            Some(Item::Sign('|' | '∠')) => true,
            _ => false,
        };
        let mut depth = 0_usize;
        begins
            && self.items(part).all(|item| {
                match item {
                    Item::Sign('(' | '{') => depth += 1,
                    Item::Sign(')' | '}') => depth = depth.saturating_sub(1),
                    _ => {}
                }
                depth > 0
                    || match item {
                        Item::Sign(sign) => matches!(sign, ')' | '}' | '|' | '∠'),
                        Item::Power(_) | Item::Root | Item::Degree | Item::Word(_) => false,
                        Item::Unread(error) => !self.text[error.span.range()].starts_with('%'),
                        _ => true,
                    }
            })
    }

    /// Whether a number stands in a part.
    pub fn has_number(&self, part: &Part) -> bool {
        self.items(part).any(|item| match item {
            Item::Number(_) => true,
            Item::Leaf(leaf) => {
                matches!(
                    leaf.kind(),
                    Kind::Constant(Constant::Pi | Constant::Infinity)
                )
            }
            _ => false,
        }) || self.tokens[part.clone()]
            .iter()
            .any(|token| token.literal.is_some())
    }

    /// Whether a number, perhaps with its unit, begins a part that goes on with words: `5 m b`.
    pub fn goes_on_in_words(&self, part: &Part) -> bool {
        let mut items = self
            .items(part)
            .skip_while(|item| matches!(item, Item::Sign('-' | '+')));
        let is_number = matches!(items.next(), Some(Item::Number(_)));
        let behind = items.find(|item| !matches!(item, Item::Unit(_)));
        is_number && matches!(behind, Some(Item::Unread(_)))
    }

    /// A name without the unit that stands beside it, and that unit: `f (Hz)`, `f [Hz]`, `f/Hz`, `φ in deg`; in
    /// brackets one letter may be an argument, and after a slash a divisor.
    pub fn unit_beside_name(&self, part: &Part) -> (Part, Option<Unit>) {
        let tokens = &self.tokens[part.clone()];
        let is = |token: &Token, sign: char| token.item == Item::Sign(sign);
        let found = match tokens {
            [.., slash, open, unit, close] if is(slash, '/') && is(open, '(') && is(close, ')') => {
                Some((unit, 4))
            }
            [.., open, unit, close] if is(open, '[') && is(close, ']') => {
                return match &unit.item {
                    Item::Unit(unit) if tokens.len() > 3 => {
                        (part.start..part.end - 3, Some(**unit))
                    }
                    _ => (part.clone(), None),
                };
            }
            [.., open, unit, close] if is(open, '(') && is(close, ')') => Some((unit, 3)),
            [.., word, unit] if word.item == Item::Word("in") => {
                return match &unit.item {
                    Item::Unit(unit) if tokens.len() > 2 => {
                        (part.start..part.end - 2, Some(**unit))
                    }
                    _ => (part.clone(), None),
                };
            }
            [.., word, unit] if is(word, '/') => Some((unit, 2)),
            _ => None,
        };
        let unit = found.and_then(|(token, length)| match &token.item {
            Item::Unit(unit) if self.text[token.span.range()].chars().count() > 1 => {
                Some((part.start..part.end - length, **unit))
            }
            _ => None,
        });
        match unit {
            Some((name, unit)) if !name.is_empty() => (name, Some(unit)),
            _ => (part.clone(), None),
        }
    }

    /// The names that a part lists, `ω1, ω2`, alone or in brackets; nothing if it is something else. `ω1,2` has two.
    pub fn names(&self, part: &Part) -> Option<Vec<Part>> {
        let part = self.unbracketed(part).unwrap_or_else(|| part.clone());
        let names = self.statements(&part);
        let is_number =
            |name: &Part| matches!(&self.tokens[name.clone()], [one] if one.literal.is_some());
        let is_listed = |name: &Part| self.is_name(name) || is_number(name);
        (self.is_name(names.first()?) && names.iter().all(is_listed)).then_some(names)
    }

    /// The number in the index of a name, `2` of `ω_2`.
    pub fn index(&self, name: &Part) -> Option<u32> {
        let digits: Vec<u32> = self
            .text(name)
            .chars()
            .rev()
            .skip_while(|char| *char == '}')
            .map_while(|char| match char {
                '₀'..='₉' => Some(u32::from(char) - u32::from('₀')),
                _ => char.to_digit(10),
            })
            .collect();
        let value = |sum: u32, digit: &u32| sum.checked_mul(10)?.checked_add(*digit);
        let whole = digits.iter().rev().try_fold(0, value);
        whole.filter(|_| !digits.is_empty())
    }
}
