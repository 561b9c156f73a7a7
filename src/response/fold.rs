//! One spelling for what is typed, with a map back to what was typed.

use std::borrow::Cow;

use super::letters::greek_word;
use super::signs::{
    CASES, COMMANDS, DISPLAYS, FACES, Plain, RUNS, TURNS, UNITS, WRAPPERS, escaped, of_char,
};
use super::surroundings::answer_in;
use super::words::{EQUATIONS, JOINING, LISTS, NUMBERS, ROOTS, VERBS, WORDS};
use crate::source::Span;

/// A response in plain signs: letters of mathematical alphabets as ordinary ones, one minus, one sign for "at most",
/// without what only sets off or sizes a formula in LaTeX. Each place in it has its place in what was typed.
///
/// ```
/// use vibank::response::Folded;
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
        if is_plain(typed) {
            return Ok(Self {
                typed,
                text: Cow::Borrowed(typed),
                pieces: Vec::new(),
            });
        }
        let dollars = typed.matches('$').count() - typed.matches("$$").count();
        if dollars % 2 == 1 {
            return Err(LoneDollar);
        }
        let mut folder = Folder {
            typed,
            answer: answer_in(typed),
            at: 0,
            text: String::with_capacity(typed.len()),
            pieces: Vec::new(),
            blanked: Vec::new(),
            equals: Vec::new(),
            has_cells: has_cells(typed),
            open: Vec::new(),
        };
        while folder.at < typed.len() {
            folder.piece();
        }
        Ok(Self {
            typed,
            text: Cow::Owned(folder.text),
            pieces: folder.pieces,
        })
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
    let is_kept =
        |byte: u8| byte == b'\n' || (b' '..=b'~').contains(&byte) && !b"$\\`~".contains(&byte);
    let mut may_run = false;
    let is_kept_all = typed.bytes().all(|byte| {
        may_run |= b"=*&{".contains(&byte);
        is_kept(byte)
    });
    is_kept_all
        && !(may_run && (RUNS.iter().any(|(run, _)| typed.contains(run)) || typed.contains("*^")))
        && !typed.contains("...")
        && !typed.contains('\n')
        && !TURNS.iter().any(|(turn, _)| typed.contains(turn))
        && !typed
            .match_indices('(')
            .any(|(at, _)| is_called(&typed[..at]))
        && !typed.split(' ').any(begins_words)
        && answer_in(typed).len() == typed.len()
}

/// Whether what stands before a bracket is a call of which the fold knows.
fn is_called(before: &str) -> bool {
    [ROOTS, NUMBERS, LISTS, EQUATIONS]
        .iter()
        .any(|names| names.iter().any(|name| before.ends_with(name)))
}

/// Whether tabs part the cells of several rows, as spreadsheets copy them.
fn has_cells(typed: &str) -> bool {
    let mut rows = typed.trim().lines();
    typed.trim().contains('\n') && rows.all(|row| row.trim().is_empty() || row.contains('\t'))
}

/// Whether one of the words that stand for others begins with a word.
fn begins_words(own: &str) -> bool {
    let is_word = |byte: u8| byte.is_ascii_alphabetic() || byte == b'.';
    let begins = |words: &str| {
        let behind = words.as_bytes().get(own.len());
        words.starts_with(own) && matches!(behind, None | Some(b' '))
    };
    own.len() > 1
        && own.bytes().all(is_word)
        && (WORDS.iter().any(|(words, _)| begins(words)) || VERBS.iter().any(|verb| begins(verb)))
}

struct Folder<'t> {
    typed: &'t str,
    /// Where the answer stands among what is said around it.
    answer: std::ops::Range<usize>,
    at: usize,
    text: String,
    pieces: Vec<(u32, u32)>,
    /// Braces of wrappers, which become spaces.
    blanked: Vec<usize>,
    /// Commas that stand for an equals sign.
    equals: Vec<usize>,
    /// Whether tabs part cells.
    has_cells: bool,
    /// The environments of LaTeX that are open.
    open: Vec<Environment>,
}

/// How the rows of an environment are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Environment {
    /// As statements.
    Display,
    /// As statements with conditions.
    Cases,
    /// As those of a matrix.
    Matrix,
}

impl Environment {
    fn of_name(name: &str) -> Self {
        let name = name.trim_end_matches('*');
        if DISPLAYS.contains(&name) {
            Self::Display
        } else if CASES.contains(&name) {
            Self::Cases
        } else {
            Self::Matrix
        }
    }
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
        RUNS.iter().any(|(run, _)| {
            let before = run.strip_suffix(sign).unwrap_or_default();
            !before.is_empty() && self.text.ends_with(before)
        })
    }

    fn piece(&mut self) {
        let Some(char) = self.rest().chars().next() else {
            return;
        };
        let width = char.len_utf8();
        if !self.answer.contains(&self.at) {
            return self.write("", width);
        }
        if self.blanked.contains(&self.at) || char == '$' {
            return self.write(" ", width);
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
        if char == '~' && self.is_nearly() {
            return self.write("≈", 1);
        }
        // A dot belongs to the letter before it, whatever stands between.
        if char == ' ' && self.rest()[1..].starts_with(['\u{307}', '\u{308}', '¨', '˙']) {
            return self.write("", width);
        }
        if char.is_ascii_alphabetic() && self.equation() {
            return;
        }
        if let Some((length, plain)) = self.word() {
            return self.write(plain, length);
        }
        if let Some((length, plain)) = self.beside_digits().or_else(|| self.before_others()) {
            return self.write(plain, length);
        }
        if self.rest().starts_with("^{\\circ}") {
            return self.write("°", "^{\\circ}".len());
        }
        if self.rest().starts_with("^\\circ") {
            return self.write("°", "^\\circ".len());
        }
        if let Some((run, sign)) = RUNS.iter().find(|(run, _)| self.rest().starts_with(run)) {
            return self.write(sign, run.len());
        }
        // Only in what word processors draw as a matrix does it part rows.
        let is_alone = char == '@' && !self.typed.contains('■');
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
            let found = WORDS.iter().find(|(words, _)| {
                rest.strip_prefix(words)
                    .is_some_and(|rest| rest.starts_with(' '))
            });
            found.map(|(words, plain)| (words.len(), *plain))
        };
        let compares = |verb: &str| {
            let behind = rest.strip_prefix(verb)?.strip_prefix(' ')?;
            let (length, plain) = of_words(behind)?;
            let is_sign = matches!(plain, "<" | ">" | "≤" | "≥");
            is_sign.then_some((verb.len() + 1 + length, plain))
        };
        // `or` and the like join what stands on both sides.
        VERBS
            .iter()
            .find_map(|verb| compares(verb))
            .or_else(|| of_words(rest))
            .filter(|(_, plain)| !before.is_empty() || matches!(*plain, "<" | ">" | "≤" | "≥"))
    }

    /// What stands here behind a digit and is read otherwise there: the power of ten of Mathematica, the points of a
    /// decimal that goes on.
    fn beside_digits(&self) -> Option<(usize, &'static str)> {
        let is_digit = |char: char| char.is_ascii_digit();
        if !self.typed[..self.at].ends_with(|char| is_digit(char) || char == '.') {
            return None;
        }
        let rest = self.rest();
        if let Some(power) = rest.strip_prefix("*^") {
            let is_power =
                power.starts_with(|char| is_digit(char) || char == '+' || is_minus(char));
            return is_power.then_some((2, "e"));
        }
        let points = ["...", "…"]
            .into_iter()
            .find(|sign| rest.starts_with(sign))?;
        let behind = &rest[points.len()..];
        let goes_on = behind.starts_with(|char| is_digit(char) || ".,;".contains(char));
        (!goes_on).then_some((points.len(), ""))
    }

    /// What is read together with what stands behind it: units of turning, roots, a statement that goes on in the
    /// next line.
    fn before_others(&self) -> Option<(usize, &'static str)> {
        let rest = self.rest();
        if let Some(next) = rest.strip_prefix('\n') {
            let goes_on = next.trim_start().starts_with(['=', '≈']);
            return goes_on.then_some((1, " "));
        }
        if self.typed[..self.at].ends_with(|char: char| char.is_alphabetic() || char == '_') {
            return None;
        }
        if let Some((turn, plain)) = TURNS.iter().find(|(turn, _)| rest.starts_with(turn)) {
            return Some((turn.len(), plain));
        }
        let is_call = |name: &&&str| {
            rest.strip_prefix(**name)
                .is_some_and(|rest| rest.starts_with('('))
        };
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

    /// `Eq(a, b)`: what its brackets become spaces for; whether it stands here.
    fn equation(&mut self) -> bool {
        let rest = self.rest();
        let is_letter = |before: char| before.is_alphanumeric() || before == '_';
        let behind = EQUATIONS.iter().find_map(|name| {
            let inner = rest.strip_prefix(*name)?.strip_prefix('(')?;
            Some((name.len(), inner))
        });
        let Some((length, inner)) = behind.filter(|_| !self.typed[..self.at].ends_with(is_letter))
        else {
            return false;
        };
        let (close, commas) = arguments_of_call(inner);
        let (Some(close), [comma]) = (close, &commas[..]) else {
            return false;
        };
        let start = self.at + length + 1;
        self.equals.push(start + comma);
        self.blanked.push(start + close);
        self.write(" ", length + 1);
        true
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
        follows
            && next
                .is_some_and(|next| next.is_ascii_digit() || ".+√".contains(next) || is_minus(next))
    }

    /// Writes what a sign of alignment stands for in an environment that is no matrix; whether it stands in one.
    fn alignment(&mut self) -> bool {
        let is_open = matches!(
            self.open.last(),
            Some(Environment::Matrix | Environment::Cases)
        );
        if !is_open && self.rest()[1..].trim_start().starts_with('=') {
            self.write(" ", 1);
            return true;
        }
        let is_parted = self.text.trim_end().ends_with([',', ';']);
        match self.open.last() {
            Some(Environment::Display) => self.write(" ", 1),
            Some(Environment::Cases) if is_parted => self.write(" ", 1),
            Some(Environment::Cases) => self.write(",", 1),
            Some(Environment::Matrix) | None => return false,
        }
        true
    }

    /// The end of a row. One that goes on with a sign is the same statement.
    fn row(&mut self) {
        let next = self.rest()[2..].trim_start_matches([' ', '&', '\n']);
        match self.open.last() {
            Some(Environment::Display) if next.starts_with(['=', '+', '-']) => self.write(" ", 2),
            Some(Environment::Display | Environment::Cases) => self.write("\n", 2),
            Some(Environment::Matrix) | None => self.write("\\\\", 2),
        }
    }

    /// Opens or closes an environment; whether one stands here that is no matrix.
    fn environment(&mut self, name: &str) -> bool {
        let start = 1 + name.len();
        let inner = self.rest()[start..].strip_prefix('{');
        let Some((own, _)) = inner.and_then(|inner| inner.split_once('}')) else {
            return false;
        };
        let (length, environment) = (start + own.len() + 2, Environment::of_name(own));
        if name == "begin" {
            self.open.push(environment);
        } else {
            self.open.pop();
        }
        let is_statement = environment != Environment::Matrix;
        if is_statement {
            self.write(" ", length);
        }
        is_statement
    }

    /// `\[Omega]`, `\[CapitalOmega]`, as Mathematica writes Greek letters; whether one stands here.
    fn escaped_greek(&mut self) -> bool {
        let Some((name, _)) = self.rest()[2..].split_once(']') else {
            return false;
        };
        let (is_capital, letter) = match name.strip_prefix("Capital") {
            Some(letter) => (true, letter),
            None => (false, name),
        };
        let word = match letter {
            "CurlyPhi" => "varphi".to_owned(),
            _ if is_capital => letter.to_owned(),
            _ => letter.to_ascii_lowercase(),
        };
        let is_greek = greek_word(&word).is_some();
        if is_greek {
            // What follows the bracket is no part of the letter's name.
            self.write(&format!("\\{word} "), name.len() + "\\[]".len());
        }
        is_greek
    }

    fn command(&mut self) {
        let typed = self.typed;
        let behind = &typed[self.at + 1..];
        let name: &str = &behind[..behind
            .find(|char: char| !char.is_ascii_alphabetic())
            .unwrap_or(behind.len())];
        let Some(first) = behind.chars().next() else {
            return self.write("\\", 1);
        };
        if name.is_empty() {
            match (first, escaped(first)) {
                // A new row of a matrix.
                ('\\', _) => self.row(),
                ('[', _) if self.escaped_greek() => {}
                // Displayed formulas.
                ('(' | ')' | '[' | ']', _) => self.write(" ", 2),
                (_, Some(plain)) => self.plain(plain, 1 + first.len_utf8()),
                (_, None) => self.write("\\", 1),
            }
            return;
        }
        let length = 1 + name.len();
        if let Some((_, count)) = WRAPPERS.iter().find(|(own, _)| *own == name)
            && let Some(braces) = arguments(self.typed, self.at + length, *count)
        {
            self.blanked.extend(braces);
            return self.write("", length);
        }
        if FACES.contains(&name)
            && let Some(braces) = arguments(self.typed, self.at + length, 1)
            && is_unlettered(&self.typed[braces[0] + 1..braces[1]])
        {
            self.blanked.extend(braces);
            return self.write(" ", length);
        }
        if name == "angle"
            && self.typed[self.at + length..].starts_with('{')
            && let Some(braces) = arguments(self.typed, self.at + length, 1)
        {
            self.blanked.extend(braces);
            return self.write("∠", length);
        }
        if name == "hspace"
            && let Some(braces) = arguments(self.typed, self.at + length, 1)
        {
            return self.write(" ", braces[1] + 1 - self.at);
        }
        if matches!(name, "begin" | "end") && self.environment(name) {
            return;
        }
        if let Some((_, unit)) = UNITS.iter().find(|(own, _)| *own == name) {
            return self.write(unit, length);
        }
        if matches!(name, "text" | "mathrm" | "mbox" | "operatorname")
            && let Some(braces) = arguments(self.typed, self.at + length, 1)
            && JOINING.contains(&self.typed[braces[0] + 1..braces[1]].trim())
        {
            self.blanked.extend(braces);
            return self.write(" ", length);
        }
        match COMMANDS.iter().find(|(own, _)| *own == name) {
            Some((_, plain)) => self.plain(*plain, length),
            None => {
                let kept = self.rest()[..length].to_owned();
                self.write(&kept, length);
            }
        }
    }
}

/// Where a bracket closes that stands open before a text, and where signs part what it holds.
fn arguments_of_call(inner: &str) -> (Option<usize>, Vec<usize>) {
    let (mut depth, mut parts) = (1_usize, Vec::new());
    let close = inner.char_indices().find_map(|(at, char)| {
        match char {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            ',' | ';' if depth == 1 => parts.push(at),
            _ => {}
        }
        (depth == 0).then_some(at)
    });
    (close, parts)
}

/// Whether a list stands in the bracket that is open before a text.
fn holds_list(inner: &str) -> bool {
    inner.trim_start().starts_with(['[', '{', '(']) || !arguments_of_call(inner).1.is_empty()
}

/// Whether a sign is one of those that stand for a minus.
fn is_minus(char: char) -> bool {
    char == '-' || of_char(char) == Some(Plain::Text("-"))
}

/// Whether what is set in another face is a number, perhaps with its unit, or nothing.
fn is_unlettered(text: &str) -> bool {
    let text = text.trim_matches([' ', '~']);
    text.is_empty()
        || text.starts_with(|char: char| {
            char.is_ascii_digit() || "+.".contains(char) || is_minus(char)
        })
}

/// The places of the braces around the next `count` arguments.
fn arguments(text: &str, from: usize, count: usize) -> Option<Vec<usize>> {
    let (mut braces, mut at) = (Vec::new(), from);
    for _ in 0..count {
        let rest = text.get(at..)?;
        let open = at + rest.len() - rest.trim_start().len();
        let mut depth = 0_usize;
        let close = text.get(open..)?.char_indices().find_map(|(place, char)| {
            match char {
                '{' => depth += 1,
                '}' => depth = depth.checked_sub(1)?,
                _ => {}
            }
            (depth == 0).then_some(open + place)
        })?;
        if close == open {
            return None;
        }
        braces.extend([open, close]);
        at = close + 1;
    }
    Some(braces)
}

/// The ordinary letter or digit for one of another width or style.
fn unstyled(char: char) -> char {
    match char {
        '！'..='～' => char::from_u32(u32::from(char) - 0xfee0).unwrap_or(char),
        '\u{1d400}'..='\u{1d7ff}' => mathematical(u32::from(char) - 0x1d400).unwrap_or(char),
        _ => char,
    }
}
/// The letter or digit at a place of the block of mathematical alphabets.
fn mathematical(place: u32) -> Option<char> {
    const LETTERS: u32 = 13 * 52;
    const GREEK: u32 = 0x2a8;
    const DIGITS: u32 = 0x3ce;
    let of = |first: char, offset: u32| char::from_u32(u32::from(first) + offset);
    match place {
        0..LETTERS if place % 52 < 26 => of('A', place % 52),
        0..LETTERS => of('a', place % 52 - 26),
        GREEK..DIGITS if place < GREEK + 5 * 58 => match (place - GREEK) % 58 {
            17 => Some('Θ'),
            25 => Some('∇'),
            offset @ 0..25 => of('Α', offset),
            offset @ 26..51 => of('α', offset - 26),
            offset => ['∂', 'ϵ', 'ϑ', 'ϰ', 'ϕ', 'ϱ', 'ϖ']
                .get(offset as usize - 51)
                .copied(),
        },
        DIGITS.. => of('0', (place - DIGITS) % 10),
        _ => None,
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
            ("\\(k/m\\)", " k/m "),
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
