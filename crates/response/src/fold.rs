//! One spelling for what is typed, with a map back to what was typed.

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

use std::borrow::Cow;
use std::cell::OnceCell;

use self::alphabets::unstyled;
use self::latex::Environment;
use self::plain::{has_barred_numbers, has_cells, is_plain};
pub(crate) use self::programs::arguments_of_call;
use self::spaces::OneWidth;
use self::words::is_shouted;
use super::answering::answering;
use super::error::At;
use super::passage::Passage;
use super::signs::{MIDDLE_POINT, Plain, RUNS, begins_run, is_minus, of_char};
use super::surroundings::answer_in;
use vibank_formula::unit::Unit;
use vibank_source::Span;

/// A response in plain signs: letters of mathematical alphabets as ordinary ones, one minus, one sign for "at most",
/// without what only sets off or sizes a formula in LaTeX. Each place in it has its place in what was typed.
///
/// ```
/// use vibank_response::{At, Folded};
///
/// let folded = Folded::of(r"$\omega \leq −5$ rad/s").unwrap();
/// assert_eq!(folded.passage().to_string(), r"\omega ≤ -5  rad/s");
/// let minus = folded.typed_at(&At::Here("-".to_owned()));
/// assert_eq!(minus, Some(At::Here("−".to_owned())));
/// assert_eq!(Folded::of("𝑘/𝑚").unwrap().passage().to_string(), "k/m");
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
            closes: usize::MAX,
            open: Vec::new(),
            overs: Vec::new(),
        };
        folder.enumerate();
        folder.bullets();
        folder.derive();
        while folder.at < typed.len() {
            folder.piece();
        }
        folder.close();
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

    /// The part of it where this stands.
    #[must_use]
    pub fn part(self, place: Span) -> Self {
        let range = place.range();
        let mut part = self.up_to(range.end);
        let first = part.place(range.start..range.start).range().start;
        let start = range.start as u32;
        part.pieces.retain(|(at, _)| *at >= start);
        part.pieces.iter_mut().for_each(|(at, _)| *at -= start);
        if part.pieces.first().is_none_or(|(at, _)| *at > 0) {
            part.pieces.insert(0, (0, first as u32));
        }
        part.text = Cow::Owned(part.text[range].to_owned());
        part
    }

    /// Where the only statement stands that `answers`, by what is before its equals sign, among others that do not; where
    /// that is the first one, nothing need be before it.
    pub fn answering<'f>(&'f self, answers: impl Fn(Passage<'f>) -> bool) -> Option<Span> {
        answering(self.text(), answers)
    }

    /// Where the value stands after the name of what is asked, with no sign between them, `x_a 3 m`.
    pub fn behind_name<'f>(&'f self, is_asked: impl Fn(Passage<'f>) -> bool) -> Option<Span> {
        let text = self.text();
        let is_bare =
            !text.contains(['=', '≈', '<', '>', '≤', '≥', ':', ';']) && !text.contains(", ");
        let mut starts = text.match_indices(' ').map(|(at, _)| at + 1);
        let start = starts.find(|at| {
            let unsigned = text[*at..].strip_prefix(is_minus).unwrap_or(&text[*at..]);
            unsigned.starts_with(|first: char| first.is_ascii_digit())
        })?;
        let name = text[..start].trim();
        let is_name = name.starts_with(|first: char| first.is_alphabetic() || first == '\\');
        (is_name && is_bare && is_asked(Passage::of(name))).then(|| Span::new(start, text.len()))
    }

    /// The whole of it.
    pub fn passage(&self) -> Passage<'_> {
        Passage::of(self.text())
    }

    /// A place in it as it was typed; none where nothing was typed for it.
    pub fn typed_at(&self, place: &At) -> Option<At> {
        let typed = |at: usize, length: usize| self.typed(at..at + length).trim().to_owned();
        match place {
            At::Here(own) => {
                let at = self.text.find(own)?;
                Some(At::Here(typed(at, own.len())))
            }
            At::Behind(own) => {
                let at = self.text.rfind(own)?;
                Some(At::Behind(typed(at, own.len())))
            }
        }
    }

    /// In plain signs.
    pub(crate) fn text(&self) -> &str {
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
    /// Where the bracket of a root in words closes.
    closes: usize,
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

    /// Closes the bracket that a root in words has opened, where what stands under it ends.
    fn close(&mut self) {
        if self.at == self.closes {
            self.write(")", 0);
            self.closes = usize::MAX;
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
        if self.blanked.contains(&self.at) || char == '$' {
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
            return self.write(";", 1);
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
        // `u = <1, 2>`
        if char == '=' && self.is_before_chevrons() {
            return self.write("=", 1);
        }
        self.single(char, width);
    }

    /// Writes a run of signs, a sign of the table or a letter.
    fn single(&mut self, char: char, width: usize) {
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

    /// Whether a unit in brackets is said with its preposition here, `(in rad/s)`.
    fn is_before_unit_in_words(&self) -> bool {
        let inner = self.rest().strip_prefix("(in ");
        let unit = inner.and_then(|inner| inner.split_once(')'));
        unit.is_some_and(|(unit, _)| Unit::read(unit).is_ok())
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
        let is_digit = |char: char| char.is_ascii_digit();
        let ends = |text: &str| !text.starts_with(DECIMALS) && !text.starts_with(['^', 'e', 'E']);
        let before = &self.typed[..self.at];
        let whole = before.trim_end_matches(is_digit);
        let behind = &self.rest()['·'.len_utf8()..];
        let rest = behind.trim_start_matches(is_digit);
        let begins = |text: &str| {
            !text.ends_with(DECIMALS)
                && !text.ends_with(|last: char| last.is_alphanumeric() || last == '_')
        };
        whole.len() < before.len()
            && begins(whole)
            && rest.len() < behind.len()
            && !behind.starts_with("10")
            && ends(rest)
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
        let is_digit = |char: char| char.is_ascii_digit();
        let power = self.rest().strip_prefix(" E ");
        let power = power.map(|power| power.strip_prefix(['+', '-']).unwrap_or(power));
        power.is_some_and(|power| power.starts_with(is_digit))
            && self.typed[..self.at].ends_with(is_digit)
    }

    /// `1,4.10^-2`: after a decimal comma the point before a power of ten multiplies.
    fn is_french_times(&self) -> bool {
        let is_digit = |char: char| char.is_ascii_digit();
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
            (
                "\\underline{\\underline{\\frac{k}{m}}}",
                "    \\frac{k}{m}  ",
            ),
            ("a!\\;", "a"),
            ("1{\\,}250\\,m", "1 250 m"),
            ("1.4\\,10^{-2}", "1.4*10^{-2}"),
            ("m ü + ku", "m u\u{308} + ku"),
            ("für ü", "für u\u{308}"),
            ("6·1237 m", "6‧1237 m"),
            ("6·10-3 m", "6*10-3 m"),
            ("0.5·12 m", "0.5*12 m"),
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
