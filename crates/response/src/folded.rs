//! A response in one spelling, with a map back to what was typed.

use std::borrow::Cow;

use super::answering::answering;
use super::error::At;
use super::fold::{OneWidth, folded, is_plain};
use super::passage::Passage;
use super::ranges::AskedBound;
use super::signs::{is_digit, is_minus};
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
        let (text, pieces) = folded(typed);
        Ok(Self {
            typed,
            text: Cow::Owned(text),
            pieces,
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
    /// that is the first one, nothing need be before it. Beside complex numbers it is that of the `whole` symbol.
    pub fn answering<'f>(
        &'f self,
        answers: impl Fn(Passage<'f>) -> bool,
        is_whole: impl Fn(Passage<'f>) -> bool,
    ) -> Option<Span> {
        answering(self.text(), answers, is_whole)
    }

    /// Where the value stands after the name of what is asked, with no sign between them, `x_a 3 m`.
    pub fn behind_name<'f>(&'f self, is_asked: impl Fn(Passage<'f>) -> bool) -> Option<Span> {
        let text = self.text();
        let is_bare =
            !text.contains(['=', '≈', '<', '>', '≤', '≥', ':', ';']) && !text.contains(", ");
        let mut starts = text.match_indices(' ').map(|(at, _)| at + 1);
        let start = starts.find(|at| {
            let unsigned = text[*at..].strip_prefix(is_minus).unwrap_or(&text[*at..]);
            unsigned.starts_with(is_digit)
        })?;
        let name = text[..start].trim();
        let is_name = name.starts_with(|first: char| first.is_alphabetic() || first == '\\');
        (is_name && is_bare && is_asked(Passage::of(name))).then(|| Span::new(start, text.len()))
    }

    /// Where the bound of a quantity of such a name stands, if that is all it says: `k ≤ 251`.
    pub fn bound(&self, bound: AskedBound, is_name: impl Fn(Passage<'_>) -> bool) -> Option<Span> {
        bound.place(self.text(), is_name)
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
            ("square root of k over m", "sqrt(k / m)"),
            ("root of square root of k", "sqrt(sqrt(k))"),
            ("2 + the root of the root of k + 1", "2 + sqrt(sqrt(k)) + 1"),
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
