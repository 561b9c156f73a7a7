//! From the [folded](super::Folded) signs of a response to tokens, its runs of letters split into words.

use std::sync::Arc;

use super::conjugates::{conjugate_mark, conjugate_stars, conjugate_terms};
use super::derivative::{derivative, primed, rate_by_index};
use super::determinant::determinant;
use super::differential::{method, operator};
use super::digits::fraction;
use super::letters::{Letters, combining, dotted, greek, greek_word, name_of_command};
use super::signs::{MIDDLE_POINT, is_digit, is_of_name};
use super::spellings::{may_be_small, with_other_case};
use super::subscript::{subscript, subscripts};
use super::surroundings::begins;
use super::token::{Item, Token};
use super::vocabulary::{Ending, WordPiece, WordSense};
use super::words::{MODULES, Powered};
use super::{Lexicon, Manner, Trouble, TypedError};
use vibank_dynamics::numerics::{Rational, SortedSet};
use vibank_formula::expr::{Constant, Expr, Function, Kind, Name};
use vibank_formula::unit::Unit;
use vibank_formula::work;
use vibank_source::Span;

/// Units of work of a token: it is looked for among names, functions and derivatives.
const UNITS_OF_A_TOKEN: u64 = 30;

/// The tokens of `text[from..to]`.
pub(crate) fn tokens(
    text: &str,
    from: usize,
    to: usize,
    lexicon: &Lexicon,
    manner: Manner,
) -> Result<Vec<Token>, TypedError> {
    let mut lexer = Lexer {
        text: &text[..to],
        at: from,
        lexicon,
        manner,
        is_spaced: false,
        tokens: Vec::new(),
    };
    while let Some(char) = lexer.peek() {
        let start = lexer.at;
        if work::spend(UNITS_OF_A_TOKEN).is_err() {
            return Err(TypedError::new(Trouble::TooLong, start, to));
        }
        let Err(error) = lexer.token(char) else {
            continue;
        };
        if manner.values.is_none() {
            return Err(error);
        }
        lexer.at = (lexer.at.max(error.span.range().end)).max(start + char.len_utf8());
        lexer.push(Item::Unread(Box::new(error)), start);
    }
    if manner.has_imaginary_unit && manner.values.is_none() {
        conjugate_stars(&mut lexer.tokens);
    }
    Ok(lexer.tokens)
}

pub(crate) struct Lexer<'a> {
    pub(crate) text: &'a str,
    pub(crate) at: usize,
    pub(crate) lexicon: &'a Lexicon,
    pub(crate) manner: Manner,
    pub(crate) is_spaced: bool,
    pub(crate) tokens: Vec<Token>,
}

impl<'a> Lexer<'a> {
    pub(crate) fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    pub(crate) fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    pub(crate) fn push(&mut self, item: Item, start: usize) {
        self.tokens.push(Token {
            item,
            span: Span::new(start, self.at),
            is_spaced: std::mem::take(&mut self.is_spaced),
            literal: None,
        });
    }

    /// A token of the next `length` bytes.
    pub(crate) fn take(&mut self, length: usize, item: Item) {
        let start = self.at;
        self.at += length;
        self.push(item, start);
    }

    pub(crate) fn error<T>(&self, trouble: Trouble, start: usize) -> Result<T, TypedError> {
        Err(TypedError::new(trouble, start, self.at))
    }

    fn token(&mut self, char: char) -> Result<(), TypedError> {
        let width = char.len_utf8();
        if self.value(char)? {
            return Ok(());
        }
        if char.is_whitespace() {
            self.at += width;
            self.is_spaced = true;
            return Ok(());
        }
        // First, or the `d` of a quotient would be a letter.
        if self.determinant_or_conjugate()
            || self.derivative_over_time()
            || self.manner.values.is_none() && self.degrees()
            || self.end_of_sentence(char)
        {
            return Ok(());
        }
        if self.module()
            || self.product_by_point(char)
            || self.unknown_time(char)
            || self.times_as_letter(char)
            || self.base_of_exponential(char)
            || self.factorial(char)
            || self.mixed(char)
        {
            return Ok(());
        }
        match char {
            '0'..='9' => return self.number(),
            '.' if self.rest()[1..].starts_with(is_digit) => {
                return self.number();
            }
            '\\' => return self.command(),
            '⁰' | '¹' | '²' | '³' | '⁴'..='⁹' | '⁻' => return self.raised(),
            '\'' | '"' => {
                let start = self.at;
                let primes = self.primes();
                self.push(Item::Primes(primes), start);
                return Ok(());
            }
            _ => {}
        }
        if let Some((name, length)) = self.lexicon.part(self.rest()) {
            let span = Span::new(self.at, self.at + length);
            self.take(
                length,
                Item::Leaf(Expr::new(Kind::Name(name.clone()), span)),
            );
            return Ok(());
        }
        if char.is_ascii_alphabetic() || greek(char).is_some() || dotted(char).is_some() {
            return self.run(None);
        }
        if char == ',' {
            self.comma();
            return Ok(());
        }
        let item = match char {
            '+' | '-' | '*' | '/' | '^' | '(' | ')' | '[' | ']' | '{' | '}' | '|' | ':' | ';'
            | '=' | '<' | '>' | '≤' | '≥' | '≠' | '&' => Item::Sign(char),
            '∠' if self.manner.has_imaginary_unit => Item::Sign(char),
            MIDDLE_POINT => Item::Sign('*'),
            '≈' => Item::Sign('='),
            '√' => Item::Root,
            '°' => Item::Degree,
            '∞' => Item::Leaf(Expr::constant(Constant::Infinity)),
            _ if fraction(char).is_some() => Item::Number(fraction(char).unwrap_or(Rational::ONE)),
            '±' => {
                self.at += width;
                return self.error(Trouble::TwoValues, self.at - width);
            }
            _ => {
                self.at += width;
                return self.error(Trouble::Sign, self.at - width);
            }
        };
        self.take(width, item);
        Ok(())
    }

    /// The determinant of a matrix, terms that are conjugates, or the mark of one; whether such stands in a formula here.
    fn determinant_or_conjugate(&mut self) -> bool {
        if self.manner.values.is_some() {
            return false;
        }
        let (text, at, is_complex) = (self.text, self.at, self.manner.has_imaginary_unit);
        let found = determinant(text, at, self.lexicon)
            .or_else(|| conjugate_terms((text, at), &self.tokens, self.lexicon, is_complex))
            .or_else(|| {
                let length = conjugate_mark(&text[at..], &self.tokens).filter(|_| is_complex)?;
                Some((Item::Conjugate, length))
            });
        let Some((item, length)) = found else {
            return false;
        };
        self.take(length, item);
        true
    }

    /// The point, comma or semicolon after the last sign; whether it stands here.
    fn end_of_sentence(&mut self, char: char) -> bool {
        let is_last = (char == '.' || matches!(char, ',' | ';') && self.manner.values.is_none())
            && self.rest()[1..].trim().is_empty();
        let ends = is_last && !self.tokens.is_empty();
        // The sentence may end within the braces of its last unit.
        if char == '.' && !ends && self.rest()[1..].trim_matches([' ', '}']).is_empty() {
            self.at += 1;
            return true;
        }
        if ends {
            self.at = self.text.len();
        }
        ends
    }

    /// `np.` and `math.` before the names of functions; whether one stands here.
    fn module(&mut self) -> bool {
        let mut modules = MODULES.iter().filter(|module| begins(self.rest(), module));
        let found =
            modules.find(|module| self.rest()[module.len()..].starts_with(char::is_alphabetic));
        self.at += found.map_or(0, |module| module.len());
        // What programs call so is the natural one; alone, people mean the other as well.
        let is_program = || {
            let mut signs = [".*", "./", ".^"].iter();
            found.is_some() || signs.any(|sign| self.text.contains(sign))
        };
        let is_natural = if self.rest().starts_with("log(") {
            is_program()
        } else {
            self.rest().starts_with("Log[") && !is_program()
        };
        if is_natural {
            self.take("log".len(), Item::Function(Function::Ln));
        }
        found.is_some() || is_natural
    }

    /// `1.4 x 10^-2`, and `2 x m x R^2` where x is no letter of the answer; whether the sign of times stands here as a
    /// letter.
    fn times_as_letter(&mut self, char: char) -> bool {
        let Some(behind) = self.rest().strip_prefix(['x', 'X']) else {
            return false;
        };
        let last = self.tokens.last().map(|token| &token.item);
        let is_behind_number = matches!(last, Some(Item::Number(_) | Item::Sign(')')));
        let is_before_power = is_behind_number && behind.trim_start().starts_with("10^");
        let is_it = is_before_power
            || char == 'x'
                && self.manner.values.is_none()
                && self.is_spaced
                && last.is_some()
                && behind.starts_with(' ')
                && !self.lexicon.knows("x");
        if is_it {
            self.take(1, Item::Sign('*'));
        }
        is_it
    }

    /// `E^(-t)`, as Mathematica writes it, where E is no letter of the answer; whether it stands here.
    fn base_of_exponential(&mut self, char: char) -> bool {
        let is_it = char == 'E' && self.rest()[1..].starts_with('^') && !self.lexicon.knows("E");
        if is_it {
            let span = Span::new(self.at, self.at + 1);
            let kind = Kind::Constant(Constant::E);
            self.take(1, Item::Leaf(Expr::new(kind, span)));
        }
        is_it
    }

    /// `theta'(t)` and `x[t]` where the time is no letter of the answer; whether that time stands here.
    fn unknown_time(&mut self, char: char) -> bool {
        let is_moving = self.tokens.last().is_some_and(|token| {
            matches!(&token.item, Item::Leaf(leaf) if matches!(leaf.kind(), Kind::Name(_) | Kind::Prime(..)))
        });
        let is_time = matches!(char, '(' | '[')
            && is_moving
            && !self.is_spaced
            && !self.lexicon.knows("t")
            && ["(t)", "[t]"]
                .iter()
                .any(|time| self.rest().starts_with(time));
        self.at += if is_time { "(t)".len() } else { 0 };
        is_time
    }

    /// `m.g.h`, and `.*` for entries; whether a point stands here between factors.
    fn product_by_point(&mut self, char: char) -> bool {
        if char != '.' || self.tokens.is_empty() {
            return false;
        }
        let next = self.rest()[1..].chars().next();
        let is_factor =
            !self.is_spaced && next.is_some_and(|next| next.is_alphabetic() || "(√".contains(next));
        let is_entrywise = next.is_some_and(|next| matches!(next, '*' | '/' | '^' | '²' | '³'));
        if is_factor {
            self.take(1, Item::Sign('*'));
        } else if is_entrywise {
            self.at += 1;
        }
        is_factor || is_entrywise
    }

    fn primes(&mut self) -> u8 {
        let mut primes = 0_u8;
        while let Some(char) = self.peek() {
            primes = primes.saturating_add(match char {
                '\'' => 1,
                '"' => 2,
                _ => break,
            });
            self.at += char.len_utf8();
        }
        match primes {
            0 => self.raised_primes(),
            _ => primes,
        }
    }

    /// `x1''` with its subscript last, `x''_1`, where only so it is a name.
    fn late_subscript(&mut self, letters: &mut Letters, primes: u8) {
        let ending = Ending::Primes(primes);
        let is_known = |letters: &Letters| self.lexicon.split(letters, 0, ending, false).is_ok();
        if is_known(letters) {
            return;
        }
        let mut whole = letters.clone();
        let end = subscripts(self.text, self.at, &mut whole);
        if end > self.at && is_known(&whole) {
            *letters = whole;
            self.at = end;
        }
    }

    /// `Delta m`, where only both words are a name.
    fn letter_behind_greek(&mut self, letters: &mut Letters) {
        let is_behind = self
            .rest()
            .strip_prefix(' ')
            .is_some_and(|next| next.starts_with(char::is_alphabetic));
        if !is_behind || greek_word(&letters.text).is_none() || self.lexicon.knows(&letters.text) {
            return;
        }
        let (start, mut whole) = (self.at, letters.clone());
        self.at += 1;
        while let Some(char) = self
            .peek()
            .filter(|next| next.is_alphanumeric() || *next == '_')
        {
            let at = self.at;
            if char == '_' {
                self.at = subscript(self.text, self.at, &mut whole);
                continue;
            }
            self.at += char.len_utf8();
            if !whole.push(char, at, at) {
                self.at = at;
                break;
            }
        }
        if self.lexicon.knows(&whole.text) {
            *letters = whole;
        } else {
            self.at = start;
        }
    }

    /// A run of letters, after a Greek letter that was written as a command.
    pub(crate) fn run(&mut self, word: Option<(&'static str, usize)>) -> Result<(), TypedError> {
        if word.is_none() && self.imaginary_unit() {
            return Ok(());
        }
        let start = word.map_or(self.at, |(_, start)| start);
        let mut letters = Letters::default();
        let mut dots = 0;
        if let Some((word, at)) = word {
            letters.push_word(word, at);
        } else if let Some((name, length)) = self.lexicon.product(self.rest()) {
            for (place, letter) in name.as_str().char_indices() {
                letters.push(letter, self.at + place, self.at + place);
            }
            self.at += length;
        }
        while let Some(char) = self.peek() {
            let at = self.at;
            if let Some((plain, order)) = dotted(char) {
                letters.push(plain, at, at);
                dots = order;
                self.at += char.len_utf8();
                break;
            }
            if let Some(order) = combining(char) {
                dots = order;
                self.at += char.len_utf8();
                break;
            }
            if char == '_' {
                self.at = subscript(self.text, self.at, &mut letters);
                continue;
            }
            if char == '\\' {
                let name = name_of_command(self.rest());
                let Some(word) = greek_word(name) else { break };
                letters.push_word(word, at);
                self.at += 1 + name.len();
                self.skip_space_before_letter();
                continue;
            }
            if char == 'd' && at > start && derivative(self.text, self.at, self.lexicon).is_some() {
                break;
            }
            if char.is_ascii_digit() && self.lexicon.ends_with_function(&letters.text, self.rest())
            {
                break;
            }
            self.at += char.len_utf8();
            if !letters.push(char, at, at) {
                self.at = at;
                break;
            }
        }
        if dots > 0 {
            // A subscript may come after the dot, as in ẋ₁.
            self.at = subscripts(self.text, self.at, &mut letters);
        }
        if dots == 0 {
            self.letter_behind_greek(&mut letters);
        }
        let mut end = self.at;
        let primes = if dots > 0 { dots } else { self.primes() };
        if dots == 0 && primes > 0 {
            let behind = self.at;
            self.late_subscript(&mut letters, primes);
            end = if self.at > behind { self.at } else { end };
        }
        self.words(&letters, start, end, primes)
    }

    /// `j100`, as engineers write it; whether it stands here.
    fn imaginary_unit(&mut self) -> bool {
        let rest = self.rest();
        let is_it = self.manner.has_imaginary_unit
            && (rest.starts_with(['i', 'j'])
                && rest[1..].starts_with(is_digit)
                // As Mathematica has it.
                                || rest.starts_with('I') && !rest[1..].starts_with(is_of_name) && !self.lexicon.knows("I"));
        if is_it {
            let kind = Kind::Constant(Constant::ImaginaryUnit);
            let span = Span::new(self.at, self.at + 1);
            self.take(1, Item::Leaf(Expr::new(kind, span)));
        }
        is_it
    }

    /// Passes the space that ends a command, where a letter follows.
    pub(crate) fn skip_space_before_letter(&mut self) {
        let spaces = self.rest().len() - self.rest().trim_start_matches(' ').len();
        if self.rest()[spaces..].starts_with(|next: char| next.is_ascii_alphabetic()) {
            self.at += spaces;
        }
    }

    /// Pushes the words of a run.
    pub(crate) fn words(
        &mut self,
        letters: &Letters,
        start: usize,
        end: usize,
        primes: u8,
    ) -> Result<(), TypedError> {
        if primes == 0 && self.joule(letters, start) {
            return Ok(());
        }
        let next = self.rest().trim_start();
        let has_bracket = next.starts_with(['(', '{', '[']) || next.starts_with("\\left");
        let mut calls = ["(0)", "\\left(0\\right)"].iter();
        if let Some(call) = calls.find(|call| next.starts_with(**call))
            && let Ok(pieces) = self
                .lexicon
                .split(letters, end, Ending::Initial(primes), false)
            && pieces.last().is_some_and(|piece| piece.takes_ending)
        {
            self.at += self.rest().len() - next.len() + call.len();
            return self.pieces(pieces, 0);
        }
        let ending = Ending::Primes(primes);
        let pieces = match self.lexicon.split(letters, end, ending, has_bracket) {
            Ok(pieces) => pieces,
            Err(_)
                if let Some((pieces, order)) =
                    rate_by_index(&self.text[start..end], letters, end, self.lexicon) =>
            {
                return self.pieces(pieces, primes.saturating_add(order));
            }
            Err(_) if let Some(pieces) = self.in_any_case(letters, start, end, ending) => pieces,
            Err(_) if self.manner.values.is_some() && primes == 0 => {
                return self.unit_or_unknown(letters, start, end);
            }
            Err(_) if self.is_unit(start, end) => {
                return Err(TypedError::new(Trouble::Unit, start, end));
            }
            Err(stuck) => {
                let place = letters.unknown_from(stuck).unwrap_or(start);
                let trouble = self.lexicon.unknown(&self.text[place..end]);
                return Err(TypedError::new(trouble, place, end));
            }
        };
        self.pieces(pieces, primes)
    }

    /// The words of a run with a letter in the other case, where those are read.
    fn in_any_case(
        &self,
        letters: &Letters,
        start: usize,
        end: usize,
        ending: Ending,
    ) -> Option<Vec<WordPiece>> {
        if !self.manner.is_in_any_case {
            return None;
        }
        let pieces = self.lexicon.split_in_any_case(letters, end, ending)?;
        // Who types `M` and `m` means two things.
        let is_alone = |piece: &WordPiece| {
            let own = &self.text[piece.start..piece.end];
            with_other_case(own).is_none_or(|other| !self.text.contains(&other))
        };
        let is_meant = may_be_small(self.text, start) || pieces.iter().all(is_alone);
        is_meant.then_some(pieces)
    }

    /// Whether a run of letters that are not names is a unit: only after a number, and of one letter only the second.
    fn is_unit(&self, start: usize, end: usize) -> bool {
        let run = &self.text[start..end];
        let last = self.tokens.last().map(|token| &token.item);
        let is_behind_number = matches!(last, Some(Item::Number(_)));
        let is_word = run == "s" || run.len() > 1 && run.chars().all(char::is_alphabetic);
        is_behind_number && is_word && Unit::read(run).is_ok()
    }

    fn pieces(&mut self, pieces: Vec<WordPiece>, primes: u8) -> Result<(), TypedError> {
        let count = pieces.len();
        for (position, piece) in pieces.into_iter().enumerate() {
            let is_last = position + 1 == count;
            let span = Span::new(piece.start, piece.end);
            let trouble = |trouble| TypedError { trouble, span };
            let item = match piece.sense {
                WordSense::Leaf(leaf) => {
                    let is_primed = is_last && !piece.takes_ending;
                    let order = if is_primed { primes } else { 0 };
                    let named = Expr::new(leaf.kind().clone(), span);
                    Item::Leaf(primed(named, order, span))
                }
                WordSense::Function(_) | WordSense::Power(_) | WordSense::Imaginary
                    if is_last && primes > 0 =>
                {
                    return Err(trouble(Trouble::Sign));
                }
                WordSense::Function(function) => Item::Function(function),
                WordSense::Power(Powered::Complex | Powered::Polar)
                    if !self.manner.has_imaginary_unit =>
                {
                    return Err(trouble(self.lexicon.unknown("")));
                }
                WordSense::Power(powered) => Item::Powered(powered),
                WordSense::Imaginary if self.manner.has_imaginary_unit => {
                    Item::Leaf(Expr::new(Kind::Constant(Constant::ImaginaryUnit), span))
                }
                WordSense::Imaginary => return Err(trouble(self.lexicon.unknown(""))),
                WordSense::Logarithm => return Err(trouble(Trouble::Logarithm)),
                WordSense::NotAllowed => {
                    return Err(trouble(self.lexicon.not_allowed()));
                }
            };
            self.tokens.push(Token {
                item,
                span,
                is_spaced: std::mem::take(&mut self.is_spaced),
                literal: None,
            });
        }
        Ok(())
    }

    /// `dx/dt`, `d²x/dt²`, `\frac{d^2 x}{dt^2}`; whether one stands here.
    fn derivative_over_time(&mut self) -> bool {
        let may_begin = self.rest().starts_with(['d', 'D', '∂', '\\', '('])
            || self.rest().starts_with(char::is_alphabetic) && method(self.text, self.at).is_some();
        if !may_begin {
            return false;
        }
        let start = self.at;
        let Some((leaf, end)) = derivative(self.text, self.at, self.lexicon) else {
            return self.operator();
        };
        self.at = end;
        self.push(Item::Leaf(leaf), start);
        true
    }

    /// `d/dt (m x')`; whether the operator stands here.
    fn operator(&mut self) -> bool {
        let moving: SortedSet<Name> = self.lexicon.moving_names().cloned().collect();
        let found = operator(self.text, self.at).filter(|_| !moving.is_empty());
        let Some((order, end)) = found else {
            return false;
        };
        let moving = Arc::new(moving);
        for _ in 1..order {
            self.take(0, Item::Rate(Arc::clone(&moving)));
        }
        self.take(end - self.at, Item::Rate(moving));
        true
    }
}
