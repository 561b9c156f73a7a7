//! From what was typed to one spelling, sign by sign.

mod alphabets;
mod dots;
mod latex;
mod marks;
mod minutes;
mod plain;
mod programs;
mod raised;
mod spaces;
mod spoken;
mod steps;
mod words;

use std::cell::OnceCell;

use self::alphabets::unstyled;
use self::latex::Environment;
pub(crate) use self::plain::is_plain;
use self::plain::{has_barred_numbers, has_cells};
pub(crate) use self::programs::arguments_of_call;
pub(crate) use self::spaces::OneWidth;
use self::words::is_shouted;
use super::signs::{
    MIDDLE_POINT, Plain, is_digit, is_minus, is_of_name, of_char, run_at, would_run,
};
use super::surroundings::answer_in;
use super::words::is_function;
use vibank_formula::unit::Unit;

/// What was typed in one spelling, and where a piece begins in it and in what was typed.
pub(crate) fn folded(typed: &str) -> (String, Vec<(u32, u32)>) {
    let mut folder = Folder::new(typed);
    folder.enumerate();
    folder.bullets();
    folder.derive();
    while folder.at < typed.len() {
        folder.piece();
    }
    folder.close();
    (folder.text, folder.pieces)
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
    /// Commas and arrows that stand for an equals sign, and how long they are.
    equals: Vec<(usize, usize)>,
    /// What ends the rows of a matrix, or one of several answers.
    row_ends: Vec<usize>,
    /// Whether tabs part cells.
    has_cells: bool,
    /// Whether bars part numbers.
    has_barred_numbers: bool,
    /// Where the brackets of the roots in words that are open close, the innermost last.
    roots: Vec<usize>,
    /// The environments of LaTeX that are open.
    open: Vec<Environment>,
    /// Where `\over` parts a group, and where that group closes.
    overs: Vec<(usize, usize)>,
}

impl<'t> Folder<'t> {
    fn new(typed: &'t str) -> Self {
        Self {
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
            roots: Vec::new(),
            open: Vec::new(),
            overs: Vec::new(),
        }
    }

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
        !is_letter && would_run(&self.text, sign)
    }

    /// Closes the brackets that roots in words have opened, where what stands under them ends.
    fn close(&mut self) {
        while self.roots.pop_if(|end| *end == self.at).is_some() {
            self.write(")", 0);
        }
    }

    fn piece(&mut self) {
        self.close();
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
        if self.blanked.contains(&self.at) || char == '$' || self.is_around_function(char) {
            return self.write(" ", width);
        }
        if "{}\\".contains(char) && self.fraction(char) || char == '{' && self.dotted_group() {
            return;
        }
        if let Some((_, length)) = self.equals.iter().find(|(at, _)| *at == self.at) {
            return self.write("=", *length);
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
        if self.row_ends.contains(&self.at) {
            return self.write(";", 1);
        }
        if let Some((plain, length)) = self.power_of_ten(char) {
            return self.write(plain, length);
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
            // Beside semicolons, `[1,2; 0,2 | 0,2; 2,2]`, it ends a row.
            return self.write(if self.typed.contains(';') { "\n" } else { ";" }, 1);
        }
        if let Some(length) = self.silent() {
            return self.write("", length);
        }
        if char == '~' && self.is_nearly() {
            return self.write("≈", 1);
        }
        if self.apart_dots(char) || self.spoken() {
            return;
        }
        if let Some((length, plain)) = self.raised() {
            return self.write(&plain, length);
        }
        if char.is_ascii_alphabetic() && (self.equation() || self.matrix() || self.subscript()) {
            return;
        }
        if matches!(char, '1' | '/')
            && let Some((length, plain)) = self.rooted_unit()
        {
            return self.write(plain, length);
        }
        if let Some((length, plain)) = self.word().or_else(|| self.word_of_list()) {
            return self.write(plain, length);
        }
        if char == '\n' {
            return self.line_ends();
        }
        if char == '·' && self.is_between_integers() {
            return self.write(MIDDLE_POINT.encode_utf8(&mut [0; 4]), width);
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
        // `5, 6 (in m)`
        if char == '(' && self.is_before_unit_in_words() {
            return self.write("(", "(in ".len());
        }
        // `u = <1, 2>`, `u ∝ (1, 2)`
        let is_equal = char == '=' && self.is_before_chevrons();
        if is_equal || char == '∝' && self.is_before_list(width) {
            return self.write("=", width);
        }
        self.single(char, width);
    }

    /// Writes a run of signs, a sign of the table or a letter.
    fn single(&mut self, char: char, width: usize) {
        if let Some((run, sign)) = run_at(self.rest()) {
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

    /// Whether the bracket here, which word processors do not show, is one around the name of a function, `〖cos〗^2`.
    fn is_around_function(&self, bracket: char) -> bool {
        let inner = match bracket {
            '〖' => self.rest()[bracket.len_utf8()..]
                .split_once('〗')
                .map(|own| own.0),
            '〗' => self.typed[..self.at].rsplit_once('〖').map(|own| own.1),
            _ => None,
        };
        inner.is_some_and(is_function)
    }

    /// Whether a unit in brackets is said with its preposition here, `(in rad/s)`.
    fn is_before_unit_in_words(&self) -> bool {
        let inner = self.rest().strip_prefix("(in ");
        let unit = inner.and_then(|inner| inner.split_once(')'));
        unit.is_some_and(|(unit, _)| Unit::read(unit).is_ok())
    }

    /// Whether a list of several entries comes after the sign of this length.
    fn is_before_list(&self, length: usize) -> bool {
        let list = self.typed[self.at + length..self.answer.end].trim_start();
        list.starts_with(['(', '[', '{', '\\']) && list.contains([',', ';', '&'])
            || list.contains("\\\\")
    }

    /// Whether the list of chevrons to the end of the answer comes after an equals sign.
    fn is_before_chevrons(&self) -> bool {
        let list = self.typed[self.at + 1..self.answer.end].trim();
        let inner = list
            .strip_prefix('<')
            .and_then(|list| list.strip_suffix('>'));
        inner.is_some_and(|inner| inner.contains([',', ';']) && !inner.contains(['<', '>', '=']))
    }

    /// Whether integers stand right before and after the sign here, and end there; a power of ten is raised.
    fn is_between_integers(&self) -> bool {
        const DECIMALS: [char; 3] = ['.', ',', '·'];
        let before = &self.typed[..self.at];
        let whole = before.trim_end_matches(is_digit);
        let behind = &self.rest()['·'.len_utf8()..];
        let rest = behind.trim_start_matches(is_digit);
        whole.len() < before.len()
            && !whole.ends_with(DECIMALS)
            && !whole.ends_with(is_of_name)
            && rest.len() < behind.len()
            && !behind.starts_with("10")
            && !rest.starts_with(DECIMALS)
            && !rest.starts_with(['^', 'e', 'E'])
    }

    /// `1.4 10^-2`, as on paper; whether the space before the power stands here. In square brackets it parts entries.
    fn is_before_power_of_ten(&self) -> bool {
        let before = &self.typed[..self.at];
        let power = self.rest()[1..].strip_prefix("10");
        let is_power = power.is_some_and(|power| {
            power.starts_with(|next: char| "^⁻⁺".contains(next) || "¹²³⁴⁵⁶⁷⁸⁹".contains(next))
                || power.starts_with("**")
        });
        is_power && before.ends_with(is_digit) && !before.contains(['[', '&', '^'])
    }

    /// What stands between a number and its power of ten, and how long that is.
    fn power_of_ten(&self, char: char) -> Option<(&'static str, usize)> {
        match char {
            ' ' if self.is_before_power_of_ten() => Some(("*", 1)),
            ' ' if self.is_before_spaced_power() => Some(("e", " E ".len())),
            '.' if self.is_french_times() => Some(("*", 1)),
            _ => None,
        }
    }

    /// `1.4 E -2`, as some calculators show it.
    fn is_before_spaced_power(&self) -> bool {
        let power = self.rest().strip_prefix(" E ");
        let power = power.map(|power| power.strip_prefix(['+', '-']).unwrap_or(power));
        power.is_some_and(|power| power.starts_with(is_digit))
            && self.typed[..self.at].ends_with(is_digit)
    }

    /// `1,4.10^-2`: after a decimal comma the point before a power of ten multiplies.
    fn is_french_times(&self) -> bool {
        let whole = self.typed[..self.at].trim_end_matches(is_digit);
        let power = self.rest()[1..].strip_prefix("10");
        whole.len() < self.at
            && whole
                .strip_suffix(',')
                .is_some_and(|whole| whole.ends_with(is_digit))
            && power.is_some_and(|power| power.starts_with(['^', '⁻', '⁺', '¹', '²', '³']))
    }

    /// Whether `~` says what a symbol nearly is: `x ~ 0.24`. Otherwise it is the space of LaTeX.
    fn is_nearly(&self) -> bool {
        let before = &self.typed[self.answer.start..self.at];
        let last = before.trim_end().chars().next_back();
        let is_tight = !before.ends_with(' ');
        let follows = last.is_some_and(|last| {
            last.is_alphabetic() || "})'|".contains(last) || !is_tight && last.is_alphanumeric()
        });
        // `~9.02 ~12.4`
        let marks_each = before.trim_start().starts_with('~');
        let next = self.rest()[1..].trim_start().chars().next();
        // `sqrt(25)~1/s` has a space before its unit.
        let behind = self.rest()[1..].trim_start().strip_prefix("1/");
        let is_unit = behind.is_some_and(|unit| unit.starts_with(char::is_alphabetic));
        follows
            && !is_unit
            && !marks_each
            && next
                .is_some_and(|next| next.is_ascii_digit() || ".+√".contains(next) || is_minus(next))
    }
}
