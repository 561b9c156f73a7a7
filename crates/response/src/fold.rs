//! One spelling for what is typed, with a map back to what was typed.

mod alphabets;
mod latex;
mod marks;
mod minutes;
mod programs;
mod spaces;
mod steps;

use std::borrow::Cow;
use std::cell::OnceCell;

use self::alphabets::unstyled;
use self::latex::Environment;
use self::programs::holds_list;
use self::spaces::OneWidth;
use super::signs::{Plain, RUNS, TURNS, begins_run, is_minus, of_char};
use super::surroundings::{answer_in, behind_words, enumeration};
use super::words::{EQUATIONS, LISTS, NUMBERS, PERCENT, ROOTS, VERBS, WORDS};
use vibank_formula::unit::Unit;
use vibank_source::Span;

/// A response in plain signs: letters of mathematical alphabets as ordinary ones, one minus, one sign for "at most",
/// without what only sets off or sizes a formula in LaTeX. Each place in it has its place in what was typed.
///
/// ```
/// use vibank_response::Folded;
///
/// let folded = Folded::of(r"$\omega \leq −5$ rad/s").unwrap();
/// assert_eq!(folded.text().trim(), r"\omega ≤ -5  rad/s");
/// let minus = folded.text().find('-').unwrap();
/// assert_eq!(folded.typed(minus..minus + 1), "−");
/// assert_eq!(Folded::of("𝑘/𝑚").unwrap().text(), "k/m");
/// assert!(Folded::of("5 $").is_err());
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Folded<'t> {
    typed: &'t str,
    text: Cow<'t, str>,
    /// Where a piece begins, in the text and in what was typed; ascending. Empty where both are the same.
    pieces: Vec<(u32, u32)>,
}

/// A dollar sign that encloses nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LoneDollar;

impl<'t> Folded<'t> {
    /// Folds what was typed.
    ///
    /// # Errors
    ///
    /// Where a dollar sign encloses nothing.
    pub fn of(typed: &'t str) -> Result<Self, LoneDollar> {
        let Some(plain) = OneWidth::of(typed) else {
            return Self::of_one_width(typed);
        };
        let Folded { text, pieces, .. } = Folded::of_one_width(&plain.text)?;
        let pieces = if pieces.is_empty() {
            let places = text.char_indices().map(|(at, _)| at as u32);
            places.map(|at| (at, plain.place(at))).collect()
        } else {
            let pieces = pieces.into_iter();
            pieces.map(|(at, own)| (at, plain.place(own))).collect()
        };
        Ok(Self {
            typed,
            text: Cow::Owned(text.into_owned()),
            pieces,
        })
    }

    /// Folds what was typed in spaces and letters of one width.
    fn of_one_width(typed: &'t str) -> Result<Self, LoneDollar> {
        // Most responses are plain, and are not copied.
        if is_plain(typed) {
            return Ok(Self {
                typed,
                text: Cow::Borrowed(typed),
                pieces: Vec::new(),
            });
        }
        // `$$` is one sign in LaTeX, and `diff(x, t$2)` is Maple's second derivative.
        let dollars =
            typed.matches('$').count() - typed.matches("$$").count() - typed.matches("t$2").count();
        if dollars % 2 == 1 {
            return Err(LoneDollar);
        }
        let mut folder = Folder {
            typed,
            answer: answer_in(typed),
            at: 0,
            text: String::with_capacity(typed.len()),
            pieces: Vec::new(),
            dropped: Vec::new(),
            blanked: Vec::new(),
            marks: Vec::new(),
            is_unmarked: false,
            is_shouted: is_shouted(typed),
            has_over: typed.contains("\\over"),
            partners: OnceCell::new(),
            equals: Vec::new(),
            row_ends: Vec::new(),
            has_cells: has_cells(typed),
            has_barred_numbers: has_barred_numbers(typed),
            open: Vec::new(),
            overs: Vec::new(),
        };
        folder.enumerate();
        folder.bullets();
        folder.derive();
        while folder.at < typed.len() {
            folder.piece();
        }
        Ok(Self {
            typed,
            text: Cow::Owned(folder.text),
            pieces: folder.pieces,
        })
    }

    /// The same with a name in place of what stands before a place.
    #[must_use]
    pub fn with_name(self, end: usize, name: &str) -> Self {
        let (typed_from, typed_to) = {
            let place = self.place(0..end).range();
            (place.start, place.end)
        };
        // One piece that is as long as what was typed would be taken for the same text.
        let mut text = format!("{name} ");
        if text.len() == typed_to - typed_from {
            text.push(' ');
        }
        let moved = |at: u32| at - end as u32 + text.len() as u32;
        let mut pieces = vec![(0, typed_from as u32), (text.len() as u32, typed_to as u32)];
        let behind = self.pieces.iter().filter(|(at, _)| *at as usize > end);
        pieces.extend(behind.map(|(at, typed)| (moved(*at), *typed)));
        text.push_str(&self.text[end..]);
        Self {
            typed: self.typed,
            text: Cow::Owned(text),
            pieces,
        }
    }

    /// The same up to a place.
    #[must_use]
    pub fn up_to(mut self, end: usize) -> Self {
        let last = self.place(end..end).range().start;
        self.pieces.retain(|(at, _)| (*at as usize) < end);
        if self.pieces.is_empty() {
            self.pieces.push((0, 0));
        }
        // Without a piece after it the last one would go on to the end of what was typed.
        self.pieces.push((end as u32, last as u32));
        self.text = Cow::Owned(self.text[..end].to_owned());
        self
    }

    /// In plain signs.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The place in what was typed of a place in the text.
    pub fn place(&self, range: std::ops::Range<usize>) -> Span {
        if self.pieces.is_empty() {
            return Span::new(range.start, range.end);
        }
        let start = self
            .piece_at(range.start)
            .map_or(range.start, |(place, _)| place);
        let end = match range.end.checked_sub(1) {
            Some(last) if range.end > range.start => {
                self.piece_at(last).map_or(range.end, |(_, end)| end)
            }
            _ => start,
        };
        Span::new(start, end.max(start))
    }

    /// What was typed at a place in the text.
    pub fn typed(&self, range: std::ops::Range<usize>) -> &'t str {
        self.typed
            .get(self.place(range).range())
            .unwrap_or_default()
    }

    /// Where the piece that holds a place of the text begins and ends in what was typed.
    fn piece_at(&self, at: usize) -> Option<(usize, usize)> {
        let behind = self
            .pieces
            .partition_point(|(text, _)| *text as usize <= at);
        let (text, typed) = *self.pieces.get(behind.checked_sub(1)?)?;
        let end = self
            .pieces
            .get(behind)
            .map_or(self.typed.len(), |(_, typed)| *typed as usize);
        let next = self
            .pieces
            .get(behind)
            .map_or(self.text.len(), |(text, _)| *text as usize);
        // A piece that was kept as it is maps byte by byte.
        if next - text as usize == end - typed as usize {
            // The last byte of a range may lie within a sign.
            let begins = |at: &usize| self.text.is_char_boundary(*at);
            let at = (0..=at).rev().find(begins).unwrap_or(at);
            let place = typed as usize + at - text as usize;
            let length = self.text[at..].chars().next().map_or(1, char::len_utf8);
            return Some((place, (place + length).min(end)));
        }
        Some((typed as usize, end))
    }
}

/// Whether nothing is to be folded: printable ASCII without commands, dollars, marks and runs of signs.
fn is_plain(typed: &str) -> bool {
    let is_kept = |byte: u8| (b' '..=b'~').contains(&byte) && !b"$\\`~|".contains(&byte);
    let bytes = typed.as_bytes();
    let mut may_run = false;
    let is_kept_all = bytes.iter().enumerate().all(|(at, byte)| {
        may_run |= b"=*&{".contains(byte);
        is_kept(*byte) && !begins_sign(&bytes[at..])
    });
    is_kept_all
        && !(may_run && (RUNS.iter().any(|(run, _)| typed.contains(run)) || typed.contains("*^")))
        && !TURNS.iter().any(|(turn, _)| typed.contains(turn))
        && !typed
            .match_indices('(')
            .any(|(at, _)| is_called(&typed[..at]))
        && !typed.split(' ').any(begins_words)
        && !is_shouted(typed)
        && answer_in(typed).len() == typed.len()
        && enumeration(typed).is_empty()
}

/// Whether a sign of several characters begins here that is folded, or is none of a plain response.
// In one pass over the bytes: a search for each of them takes longer than all the rest of a plain response.
fn begins_sign(rest: &[u8]) -> bool {
    matches!(
        rest,
        [b'.', b'.', ..]
            | [b'-', b'>' | b'+', ..]
            | [b'+', b'-', ..]
            | [b'+', b'/', b'-', ..]
            | [b'-', b'/', b'+', ..]
            | [b'_', b']' | b'C' | b'_' | b'(', ..]
            | [b'C', b'[', ..]
            | [b'S', b'u', b'b', b's', b'c', ..]
            | [b'>' | b'<', b' ', b'=', ..]
            | [b' ', b'1', b'0', b'^', ..]
    )
}

/// Whether what stands before a bracket is a call of which the fold knows.
fn is_called(before: &str) -> bool {
    [ROOTS, NUMBERS, LISTS, EQUATIONS]
        .iter()
        .any(|names| names.iter().any(|name| before.ends_with(name)))
}

/// Whether words are in capitals throughout, as those of options are shouted.
fn is_shouted(typed: &str) -> bool {
    let is_word = |word: &str| word.chars().filter(|char| char.is_uppercase()).count() > 2;
    !typed.contains(char::is_lowercase) && typed.split(' ').filter(|word| is_word(word)).count() > 1
}

/// Whether tabs part the cells of several rows, as spreadsheets copy them.
fn has_cells(typed: &str) -> bool {
    let mut rows = typed.trim().lines();
    typed.trim().contains('\n') && rows.all(|row| row.trim().is_empty() || row.contains('\t'))
}

/// Whether all bars stand between numbers, `(1 | -0.5)`, as schools write vectors.
fn has_barred_numbers(typed: &str) -> bool {
    let is_between = |(at, _): (usize, &str)| {
        let behind = typed[at + 1..].trim_start();
        let unsigned = behind.strip_prefix(is_minus).unwrap_or(behind);
        let is_digit = |char: char| char.is_ascii_digit();
        typed[..at].trim_end().ends_with(is_digit)
            && unsigned.starts_with(|char: char| is_digit(char) || char == '.')
    };
    typed.contains('|')
        && !typed.contains(['<', '>', '≤', '≥'])
        && typed.match_indices('|').all(is_between)
}

/// Whether one of the words that stand for others begins with a word.
fn begins_words(own: &str) -> bool {
    if matches!(own, "y" | "e" | "in") {
        return true;
    }
    let is_word = |byte: u8| byte.is_ascii_alphabetic() || byte == b'.';
    let is_begun = |words: &str| {
        let behind = words.as_bytes().get(own.len());
        begins(words, own) && matches!(behind, None | Some(b' '))
    };
    own.len() > 1
        && own.bytes().all(is_word)
        && (WORDS.iter().any(|(words, _)| is_begun(words))
            || VERBS.iter().any(|verb| is_begun(verb)))
}

/// Whether a text begins with a word.
fn begins(text: &str, word: &str) -> bool {
    begin_alike(text, word) && text.starts_with(word)
}

/// Whether two texts have the same first byte.
// Of a table, most words differ in it, and a comparison of texts is a call.
fn begin_alike(text: &str, word: &str) -> bool {
    text.as_bytes().first() == word.as_bytes().first()
}

struct Folder<'t> {
    typed: &'t str,
    /// Where the answer stands among what is said around it.
    answer: std::ops::Range<usize>,
    at: usize,
    text: String,
    pieces: Vec<(u32, u32)>,
    /// Steps before the answer, and symbols that are repeated.
    dropped: Vec<std::ops::Range<usize>>,
    /// Braces of wrappers, which become spaces.
    blanked: Vec<usize>,
    /// Where marks of Markdown stand that are open, ascending.
    marks: Vec<usize>,
    /// Whether no mark of Markdown closes from here on.
    is_unmarked: bool,
    /// Whether words are in capitals throughout.
    is_shouted: bool,
    /// Whether a command may part a group into a fraction.
    has_over: bool,
    /// Where each brace opens, and where its partner closes, once they were looked for.
    partners: OnceCell<Vec<(usize, usize)>>,
    /// Commas that stand for an equals sign.
    equals: Vec<usize>,
    /// What ends the rows of a matrix, or one of several answers.
    row_ends: Vec<usize>,
    /// Whether tabs part cells.
    has_cells: bool,
    /// Whether bars part numbers.
    has_barred_numbers: bool,
    /// The environments of LaTeX that are open.
    open: Vec<Environment>,
    /// Where `\over` parts a group, and where that group closes.
    overs: Vec<(usize, usize)>,
}

impl Folder<'_> {
    fn rest(&self) -> &str {
        &self.typed[self.at..]
    }

    /// Writes a text for the next `length` bytes.
    fn write(&mut self, text: &str, length: usize) {
        self.pieces.push((self.text.len() as u32, self.at as u32));
        self.text.push_str(text);
        self.at += length;
    }

    fn plain(&mut self, plain: Plain, length: usize) {
        match plain {
            Plain::Text(text) => self.sign(text, length),
            Plain::Nothing => self.write("", length),
        }
    }

    /// Writes one sign. Signs that were typed as different ones are no run: `*·` is not a power.
    fn sign(&mut self, text: &str, length: usize) {
        if self.would_run(text) {
            self.write(" ", 0);
        }
        self.write(text, length);
    }

    /// Whether a sign would make a run with what stands before it.
    fn would_run(&self, sign: &str) -> bool {
        let is_letter = sign.starts_with(|char: char| char.is_ascii_alphanumeric() || char == ' ');
        let last = sign.as_bytes().last();
        !is_letter
            && RUNS.iter().any(|(run, _)| {
                run.as_bytes().last() == last
                    && run
                        .strip_suffix(sign)
                        .is_some_and(|before| !before.is_empty() && self.text.ends_with(before))
            })
    }

    /// Dots of derivatives that stand apart from their letter; whether some do here.
    fn apart_dots(&mut self, char: char) -> bool {
        // Copied from a page, dots stand before their letter: `m ¨x`.
        if let Some(length) = self.dots_before() {
            let (dots, letter) = self.rest()[..length].split_at('¨'.len_utf8());
            let dots = if dots == "¨" { "\u{308}" } else { "\u{307}" };
            let letter = format!(" {}{dots}", unstyled(letter.chars().next().unwrap_or(' ')));
            self.write(&letter, length);
            return true;
        }
        // A dot belongs to the letter before it, whatever stands between.
        let behind = self.rest().strip_prefix(' ');
        let mut signs = behind.unwrap_or_default().chars();
        let is_dot = signs
            .next()
            .is_some_and(|sign| "\u{307}\u{308}¨˙".contains(sign));
        let belongs_before = is_dot && !signs.next().is_some_and(char::is_alphabetic);
        if belongs_before {
            self.write("", char.len_utf8());
        }
        belongs_before
    }

    fn piece(&mut self) {
        let Some(char) = self.rest().chars().next() else {
            return;
        };
        let width = char.len_utf8();
        // The order counts: what is said around the answer goes first, then what encloses and parts it, then
        // words, then runs of signs. The table of single signs comes last, since all the others begin with
        // one of these.
        if !self.answer.contains(&self.at) || self.is_dropped() {
            return self.write("", width);
        }
        if "*_`".contains(char) && self.is_set_apart(char) {
            return self.write(" ", width);
        }
        if self.blanked.contains(&self.at) || char == '$' {
            return self.write(" ", width);
        }
        if "{}\\".contains(char) && self.fraction(char) {
            return;
        }
        if char == '\\' {
            return self.command();
        }
        if char == '&' && self.alignment() {
            return;
        }
        if char == '\t' && self.has_cells {
            return self.write("&", 1);
        }
        if self.equals.contains(&self.at) {
            return self.write("=", 1);
        }
        if self.row_ends.contains(&self.at) {
            return self.write(";", 1);
        }
        if char == ' ' && self.is_before_power_of_ten() {
            return self.write("*", width);
        }
        if self.is_rule() {
            return self.write("=", if char == '-' { 2 } else { width });
        }
        // `ω₁,₂` lists indices.
        if ('₀'..='₉').contains(&char) && self.typed[..self.at].ends_with(',') {
            let digit = char::from(b'0' + (u32::from(char) - u32::from('₀')) as u8);
            return self.write(digit.encode_utf8(&mut [0; 4]), width);
        }
        if char == '|' && self.has_barred_numbers {
            return self.write(";", 1);
        }
        if let Some(length) = self.silent() {
            return self.write("", length);
        }
        if char == '~' && self.is_nearly() {
            return self.write("≈", 1);
        }
        if self.apart_dots(char) {
            return;
        }
        if char.is_ascii_alphabetic() && (self.equation() || self.matrix() || self.subscript()) {
            return;
        }
        if let Some((length, plain)) = self.word().or_else(|| self.word_of_list()) {
            return self.write(plain, length);
        }
        if char == '\n' {
            return self.line_ends();
        }
        let others = self.beside_digits().or_else(|| self.dots());
        if let Some((length, plain)) = others.or_else(|| self.before_others()) {
            return self.write(plain, length);
        }
        if char.is_ascii_digit() && self.minutes() {
            return;
        }
        if self.rest().starts_with("^{\\circ}") {
            return self.write("°", "^{\\circ}".len());
        }
        if self.rest().starts_with("^\\circ") {
            return self.write("°", "^\\circ".len());
        }
        if char == '_'
            && let Some((index, length)) = self.bracketed_index()
        {
            return self.write(&format!("_{{{index}}}"), length);
        }
        // `u = <1, 2>`
        if char == '=' && self.is_before_chevrons() {
            return self.write("=", 1);
        }
        let mut runs = RUNS.iter().filter(|_| begins_run(char));
        if let Some((run, sign)) = runs.find(|(run, _)| self.rest().starts_with(run)) {
            return self.write(sign, run.len());
        }
        // Only in what word processors draw as a matrix does it part rows.
        let is_alone = char == '@' && !self.typed.contains(['■', '█']);
        if let Some(plain) = of_char(char).filter(|_| !is_alone) {
            return self.plain(plain, width);
        }
        let letter = unstyled(char);
        self.sign(letter.encode_utf8(&mut [0; 4]), width);
    }

    /// The words between spaces that stand here, by their length, if others or a sign stand for them.
    fn word(&self) -> Option<(usize, &'static str)> {
        let before = &self.typed[self.answer.start..self.at];
        if !(before.is_empty() || before.ends_with(' ')) {
            return None;
        }
        let rest = self.rest();
        let of_words = |rest: &str| {
            let is_same = |head: &str, word: &str| {
                head == word || self.is_shouted && head.eq_ignore_ascii_case(word)
            };
            let mut likely = WORDS
                .iter()
                .filter(|(words, _)| self.is_shouted || begin_alike(rest, words));
            likely.find_map(|(words, plain)| {
                let behind = behind_words(rest, words, is_same)?;
                let may_end = *plain == PERCENT || matches!(*plain, "^2" | "^3");
                let ends = behind.starts_with(' ')
                    || may_end && !behind.starts_with(char::is_alphanumeric);
                ends.then(|| (rest.len() - behind.len(), *plain))
            })
        };
        let compares = |verb: &str| {
            let likely = begin_alike(rest, verb).then_some(rest)?;
            let behind = behind_words(likely, verb, str::eq)?;
            let compared = behind.strip_prefix(' ')?.trim_start_matches(' ');
            let (length, plain) = of_words(compared)?;
            let is_sign = matches!(plain, "<" | ">" | "≤" | "≥");
            is_sign.then(|| (rest.len() - compared.len() + length, plain))
        };
        // `or` and the like join what stands on both sides.
        VERBS
            .iter()
            .find_map(|verb| compares(verb))
            .or_else(|| of_words(rest))
            .filter(|(_, plain)| {
                !before.is_empty() || matches!(*plain, "<" | ">" | "≤" | "≥" | "-")
            })
    }

    /// Words that are letters elsewhere: `y` and `e` between two values, `in` before a unit that ends the response.
    fn word_of_list(&self) -> Option<(usize, &'static str)> {
        let before = self.typed[self.answer.start..self.at].strip_suffix(' ')?;
        let rest = &self.typed[self.at..self.answer.end];
        let is_value = |char: char| char.is_ascii_digit() || "°)".contains(char);
        if let Some(unit) = rest.strip_prefix("in ") {
            let is_unit = Unit::read(unit.trim()).is_ok() && !unit.trim().is_empty();
            return (is_unit && before.ends_with(is_value)).then_some((2, " "));
        }
        let word = ["y ", "e "]
            .into_iter()
            .find(|word| rest.starts_with(word))?;
        let next = rest[word.len()..].trim_start_matches('-');
        let digits = next.trim_start_matches(|char: char| char.is_ascii_digit());
        let is_number = digits.len() < next.len();
        // `3 e 5` may have a power of ten, which has no decimals.
        let is_sure = word == "y " || digits.starts_with(['.', ',']);
        let is_behind = before.ends_with(is_value)
            || before.ends_with(char::is_alphabetic)
                && before.starts_with(|first: char| first.is_ascii_digit() || first == '-');
        (is_number && is_sure && is_behind).then_some((1, "and"))
    }

    /// `x1..`, the dots of a derivative after its letter; one dot alone is such where two are.
    fn dots(&self) -> Option<(usize, &'static str)> {
        let rest = self.rest();
        if !rest.starts_with('.') {
            return None;
        }
        let is_of_name = |char: char| char.is_alphanumeric() || "_}".contains(char);
        let before = &self.typed[..self.at];
        let name = &before[before.trim_end_matches(is_of_name).len()..];
        if !name.starts_with(|first: char| first.is_alphabetic()) {
            return None;
        }
        let next = |length: usize| rest[length..].chars().next().unwrap_or(' ');
        if rest.starts_with("..") {
            return (next(2) != '.').then_some((2, "\u{308}"));
        }
        let is_dot = self.typed.contains("..") && !next(1).is_alphanumeric();
        is_dot.then_some((1, "\u{307}"))
    }

    /// The index in round brackets that word processors write, `k_(eq)`, with its length.
    fn bracketed_index(&self) -> Option<(String, usize)> {
        let inner = self.rest().strip_prefix("_(")?;
        let (index, _) = inner.split_once(')')?;
        let plain: String = index.chars().map(unstyled).collect();
        let is_index = !plain.is_empty()
            && plain.chars().all(|char| char.is_ascii_alphanumeric())
            && self.typed[..self.at].ends_with(char::is_alphabetic);
        is_index.then_some((plain, index.len() + 3))
    }

    /// Whether the list of chevrons to the end of the answer comes after an equals sign.
    fn is_before_chevrons(&self) -> bool {
        let list = self.typed[self.at + 1..self.answer.end].trim();
        let inner = list
            .strip_prefix('<')
            .and_then(|list| list.strip_suffix('>'));
        inner.is_some_and(|inner| inner.contains([',', ';']) && !inner.contains(['<', '>', '=']))
    }

    /// The length of dots that a letter follows, where nothing stands right before them and they have no letter there.
    fn dots_before(&self) -> Option<usize> {
        let rest = self.rest();
        let behind = rest.strip_prefix(['¨', '˙'])?;
        let before = &self.typed[..self.at];
        let is_apart = before.is_empty() || before.ends_with([' ', '+', '-', '*', '=', '(', '·']);
        let letter = behind.chars().next().filter(|next| next.is_alphabetic())?;
        is_apart.then(|| rest.len() - behind.len() + letter.len_utf8())
    }

    /// `1.4 10^-2`, as on paper; whether the space before the power stands here. In square brackets it parts entries.
    fn is_before_power_of_ten(&self) -> bool {
        let before = &self.typed[..self.at];
        let power = self.rest()[1..].strip_prefix("10");
        let is_power = power.is_some_and(|power| {
            power.starts_with(|next: char| "^⁻⁺".contains(next) || "¹²³⁴⁵⁶⁷⁸⁹".contains(next))
                || power.starts_with("**")
        });
        is_power
            && before.ends_with(|last: char| last.is_ascii_digit())
            && !before.contains(['[', '&', '^'])
    }

    /// What is read together with what comes after it: units of turning, roots.
    fn before_others(&self) -> Option<(usize, &'static str)> {
        let rest = self.rest();
        if !rest.starts_with(char::is_alphabetic)
            || self.typed[..self.at].ends_with(|char: char| char.is_alphabetic() || char == '_')
        {
            return None;
        }
        if let Some((turn, plain)) = TURNS.iter().find(|(turn, _)| begins(rest, turn)) {
            return Some((turn.len(), plain));
        }
        let is_call =
            |name: &&&str| begins(rest, name) && rest.as_bytes().get(name.len()) == Some(&b'(');
        if let Some(root) = ROOTS.iter().find(is_call) {
            return Some((root.len(), "sqrt"));
        }
        let number = NUMBERS.iter().find(is_call);
        // `mat(1 + x)` may be a product of letters.
        let holds_list = |name: &&&str| holds_list(&rest[name.len() + 1..]);
        let list = || LISTS.iter().find(is_call).filter(holds_list);
        let name = number.or_else(list)?;
        Some((name.len(), ""))
    }

    /// Whether `~` says what a symbol nearly is: `x ~ 0.24`. Otherwise it is the space of LaTeX.
    fn is_nearly(&self) -> bool {
        let before = &self.typed[self.answer.start..self.at];
        let last = before.trim_end().chars().next_back();
        let is_tight = !before.ends_with(' ');
        let follows = last.is_some_and(|last| {
            last.is_alphabetic() || "})'".contains(last) || !is_tight && last.is_alphanumeric()
        });
        let next = self.rest()[1..].trim_start().chars().next();
        // `sqrt(25)~1/s` has a space before its unit.
        let behind = self.rest()[1..].trim_start().strip_prefix("1/");
        let is_unit = behind.is_some_and(|unit| unit.starts_with(char::is_alphabetic));
        follows
            && !is_unit
            && next
                .is_some_and(|next| next.is_ascii_digit() || ".+√".contains(next) || is_minus(next))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn pasted_letters_are_plain_ones() {
        for (pasted, meant) in [
            ("𝑚𝑥̈ + 𝑘𝑥 = 0", "mx\u{308} + kx = 0"),
            ("𝜔ₙ = √(𝑘/𝑚)", "ωₙ = √(k/m)"),
            ("𝛀𝐀𝐳𝟗", "ΩAz9"),
            ("ℎ𝒹", "hd"),
            ("５．２", "5.2"),
            ("x´´", "x''"),
            ("\u{feff}5\u{200b}", "5"),
            ("\\(k/m\\)", "k/m"),
            ("$$5$$", "  5  "),
            ("—0.3 ‑ 2 ‐ 1", "-0.3 - 2 - 1"),
            ("a =< b >= c == d", "a ≤ b ≥ c = d"),
            ("\\left(2\\cdot 3\\right)", "(2* 3)"),
            ("\\boxed{5\\,\\mathrm{m}}", " 5 \\mathrm{m} "),
            ("\\SI{5}{m/s}", " 5  m/s "),
            ("\\begin{cases}1\\\\2\\end{cases}", " 1\n2 "),
            (
                "\\begin{cases}1&t<2\\\\2,&t>2\\end{cases}",
                " 1,t<2\n2, t>2 ",
            ),
            (
                "\\begin{aligned}x&=1\\\\&=2\\\\y&=3\\end{aligned}",
                " x =1  =2\ny =3 ",
            ),
            (
                "\\begin{pmatrix}1&2\\\\3&4\\end{pmatrix}",
                "\\begin{pmatrix}1&2\\\\3&4\\end{pmatrix}",
            ),
            ("\\SI{5}{\\newton\\per\\metre}", " 5  newton /metre  "),
            ("1{,}25", "1⎖25"),
            ("x < 1 \\text{ or } x > 2", "x < 1    or   x > 2"),
            ("1 et 2 ou 3", "1 and 2 or 3"),
            ("30^{\\circ}", "30°"),
            ("Réponse\u{a0}: 5\u{202f}m", " 5 m"),
            ("x\u{a0}≥ 1 et\u{a0}x ≤ 2", "x ≥ 1 and x ≤ 2"),
            ("x ＞＝ １", "x ≥ 1"),
            ("x = **5** m", "x =   5   m"),
            ("x **2", "x ^2"),
            ("x **2 + y** 2", "x ^2 + y^ 2"),
            ("x² = 4 ⇒ x = 2", " x = 2"),
            ("x² = 4\n⇒ x = 2", " x = 2"),
            ("a ⇒ b", "a ⇒ b"),
            (
                "a = 1 ⇒ b = 2, c = 3 ⇒ d = 4",
                "a = 1 ⇒ b = 2, c = 3 ⇒ d = 4",
            ),
            ("* x = 1\n* y = 2", "x = 1\n  y = 2"),
            ("- x = 1\n- y = 2", "  x = 1\n  y = 2"),
            ("- 1\n- 2", "- 1\n- 2"),
            ("x = 4 => y = 2", " y = 2"),
            ("x => 2", "x ≥ 2"),
            ("x = a/2\nx = 5", "x = a/2= 5"),
            ("x = a, t < 1\nx = b, t > 1", "x = a, t < 1\nx = b, t > 1"),
            ("x =\n\n  5", "x =   5"),
            ("53°7'48\"", "(53+7/60+48/3600)°"),
            ("53°", "53°"),
            ("3.5 y 4 m", "3.5 and 4 m"),
            ("3 y + 4", "3 y + 4"),
            ("3.5 e 4.5", "3.5 and 4.5"),
            ("3 e 5", "3 e 5"),
            ("k_(eq)", "k_{eq}"),
            ("Subscript[m, b]", "m_{b}"),
            ("\\dv[2]{x}{t}", "\\frac{d^{2} x}{dt^{2}}"),
            ("m ¨x", "m  x\u{308}"),
            ("x ¨ + 1", "x\u{308} + 1"),
            ("u=<1, 2>", "u= <1, 2>"),
            ("x =< 2", "x ≤ 2"),
            ("A TIMES B PLUS C", "A * B + C"),
        ] {
            assert_eq!(Folded::of(pasted).unwrap().text(), meant, "{pasted}");
        }
    }

    #[test]
    fn a_dollar_alone_is_refused() {
        for typed in ["5 $", "$5", "$5$ $", "5 $$", "[[1, 2]] $"] {
            assert!(Folded::of(typed).is_err(), "{typed}");
        }
    }

    proptest! {
        /// Every place of the text is one of what was typed, between characters; what is folded already is kept.
        #[test]
        fn places_lie_within_what_was_typed(typed in r"([a-z0-9 −—·≤<>=!*$\{}\[\]°𝑘′]|\\[a-zA-Z]{1,6}|\\[,;!{}]){0,30}") {
            let Ok(folded) = Folded::of(&typed) else { return Ok(()) };
            for (at, char) in folded.text().char_indices() {
                let place = folded.place(at..at + char.len_utf8()).range();
                prop_assert!(place.end <= typed.len() && typed.get(place).is_some());
            }
            let again = Folded::of(folded.text()).map(|again| again.text().to_owned());
            if !folded.text().contains('\\') {
                prop_assert_eq!(again.as_deref(), Ok(folded.text()));
            }
        }
    }
}
