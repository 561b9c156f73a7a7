//! Labels: formulas set as one line of SVG text, with the box that they take.
//!
//! A label is a list of runs of letters of one look, at one height. Sub- and superscripts are smaller runs
//! that are raised or lowered; fractions stand on the line, `l/2`; the dots of time derivatives and the
//! hats of amplitudes are drawn.

use super::metrics;
use crate::math::{Accent, Class, Math, Style};

/// Size of letters in figure units: 3.7 mm, 10.5 points.
pub const LETTER_SIZE: f64 = 0.37;

/// Size of scripts as a share of that of their base.
const SCRIPT: f64 = 0.72;

/// Deepest formula that is set; what lies deeper is left out.
const MAX_DEPTH: u32 = 40;

/// A formula or words, set as one line.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FigureLabel {
    pub(crate) runs: Vec<LetterRun>,
    pub(crate) marks: Vec<Above>,
    width: f64,
    ascent: f64,
    descent: f64,
}

/// Letters of one look at one height.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LetterRun {
    pub(crate) text: String,
    pub(crate) look: Look,
    /// Space before it; negative where a superscript stands above a subscript.
    pub(crate) gap: f64,
}

/// How letters are set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Look {
    pub(crate) is_italic: bool,
    pub(crate) is_bold: bool,
    pub(crate) size: f64,
    pub(crate) rise: f64,
}

/// A mark above a letter: what it is, and where it is centred, from the start of the baseline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Above {
    accent: Accent,
    pub(crate) x: f64,
    pub(crate) y: f64,
}

impl Above {
    /// How many dots it has.
    pub(crate) fn dots(self) -> u8 {
        match self.accent {
            Accent::Dot => 1,
            Accent::DoubleDot => 2,
            Accent::TripleDot => 3,
            Accent::Hat | Accent::Tilde | Accent::Bar | Accent::Vector => 0,
        }
    }

    /// Corners of its line, from its centre, in figure units.
    pub(crate) fn line(self) -> &'static [(f64, f64)] {
        match self.accent {
            Accent::Dot | Accent::DoubleDot | Accent::TripleDot => &[],
            Accent::Hat => &[(-0.075, -0.035), (0.0, 0.035), (0.075, -0.035)],
            Accent::Tilde => &[
                (-0.08, -0.02),
                (-0.035, 0.025),
                (0.035, -0.02),
                (0.08, 0.025),
            ],
            Accent::Bar => &[(-0.08, 0.0), (0.08, 0.0)],
            Accent::Vector => &[
                (-0.09, 0.0),
                (0.09, 0.0),
                (0.035, 0.04),
                (0.09, 0.0),
                (0.035, -0.04),
            ],
        }
    }
}

impl FigureLabel {
    /// A formula, set.
    ///
    /// ```
    /// use vibank::figure::FigureLabel;
    /// use vibank::math::symbol;
    ///
    /// let (short, long) = (FigureLabel::of(&symbol("k")), FigureLabel::of(&symbol("k_eq")));
    /// assert!(short.width() < long.width() && long.depth() > 0.0);
    /// ```
    pub fn of(math: &Math) -> Self {
        let mut setter = Setter::new();
        setter.math(math, 0);
        setter.finish()
    }

    /// Words as they stand; letters alone or in pairs are symbols and italic, `F(t)`, `mg`, longer words upright, `sin θ`.
    pub fn words(text: &str) -> Self {
        let mut setter = Setter::new();
        let mut rest = text;
        while let Some(first) = rest.chars().next() {
            let is_word = first.is_alphabetic();
            let end = rest
                .find(|letter: char| letter.is_alphabetic() != is_word)
                .unwrap_or(rest.len());
            let (piece, after) = rest.split_at(end);
            let is_symbol = is_word && piece.chars().nth(2).is_none();
            setter.letters(piece, is_symbol, false);
            rest = after;
        }
        setter.finish()
    }

    /// Upright words and numbers, such as the ticks of an axis.
    pub fn upright(text: &str) -> Self {
        let mut setter = Setter::new();
        setter.letters(text, false, false);
        setter.finish()
    }

    /// This label, a blank, and another one.
    #[must_use]
    pub(crate) fn followed_by(mut self, other: Self) -> Self {
        let start = self.width + 0.25 * LETTER_SIZE;
        self.runs
            .extend(other.runs.into_iter().enumerate().map(|(place, mut run)| {
                run.gap += if place == 0 { start - self.width } else { 0.0 };
                run
            }));
        self.marks.extend(other.marks.into_iter().map(|mut mark| {
            mark.x += start;
            mark
        }));
        self.width = start + other.width;
        self.ascent = self.ascent.max(other.ascent);
        self.descent = self.descent.max(other.descent);
        self
    }

    /// Its width in figure units.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// Its height above the baseline.
    pub(crate) fn ascent(&self) -> f64 {
        self.ascent
    }

    /// Its depth below the baseline.
    pub fn depth(&self) -> f64 {
        self.descent
    }

    /// Whether there is nothing in it.
    pub fn is_empty(&self) -> bool {
        self.runs.is_empty()
    }

    /// Its letters without their look, for tests and descriptions.
    pub fn plain(&self) -> String {
        self.runs.iter().map(|run| run.text.as_str()).collect()
    }
}

/// Sets a formula from left to right.
struct Setter {
    label: FigureLabel,
    /// Where the next letter begins.
    x: f64,
    size: f64,
    rise: f64,
    /// Space that waits for the next letter.
    gap: f64,
}

impl Setter {
    fn new() -> Self {
        Self {
            label: FigureLabel::default(),
            x: 0.0,
            size: LETTER_SIZE,
            rise: 0.0,
            gap: 0.0,
        }
    }

    fn finish(mut self) -> FigureLabel {
        self.label.width = self.label.width.max(self.x);
        self.label
    }

    fn math(&mut self, math: &Math, depth: u32) {
        if depth > MAX_DEPTH {
            return;
        }
        let inner = depth + 1;
        match math {
            Math::Row(pieces) => pieces.iter().for_each(|piece| self.math(piece, inner)),
            Math::Identifier { text, style } => self.identifier(text, *style),
            Math::Number(digits) => self.letters(&digits.replace('-', "−"), false, false),
            Math::Operator { text, class } => self.operator(text, *class),
            Math::Function(name) => {
                self.letters(name, false, false);
                self.space(3.0);
            }
            Math::Text(words) => self.letters(words, false, false),
            Math::Space(width) => self.space(f64::from(*width)),
            Math::Fraction {
                numerator,
                denominator,
                ..
            } => {
                self.enclosed(numerator, inner);
                self.letters("/", false, false);
                self.enclosed(denominator, inner);
            }
            Math::Root { radicand, .. } => {
                self.letters("√", false, false);
                self.enclosed(radicand, inner);
            }
            Math::Script { base, sub, sup } => {
                self.math(base, inner);
                self.scripts(sub.as_deref(), sup.as_deref(), inner);
            }
            Math::Stack { base, under, over } => {
                self.math(base, inner);
                self.scripts(under.as_deref(), over.as_deref(), inner);
            }
            Math::Accent { base, accent } => self.accent(base, *accent, inner),
            Math::Fence {
                open, close, body, ..
            } => {
                self.letters(open, false, false);
                self.math(body, inner);
                self.letters(close, false, false);
            }
            Math::Table { rows, .. } => {
                for cell in rows.iter().flatten() {
                    self.math(cell, inner);
                    self.space(9.0);
                }
            }
            Math::Hole(_) => self.letters("?", false, false),
        }
    }

    fn identifier(&mut self, text: &str, style: Style) {
        let mut letters = text.chars();
        let is_single = letters.next().is_some() && letters.next().is_none();
        let is_capital_greek = text.starts_with(|letter| ('Α'..='Ω').contains(&letter));
        let is_italic = match style {
            Style::Default => is_single && !is_capital_greek,
            Style::BoldItalic | Style::Script => true,
            Style::Upright | Style::Bold | Style::Double => false,
        };
        self.letters(
            text,
            is_italic,
            matches!(style, Style::Bold | Style::BoldItalic),
        );
    }

    fn operator(&mut self, text: &str, class: Class) {
        let around = match class {
            Class::Relation => 5.0,
            Class::Binary if matches!(text, "⋅" | "·" | "/") => 1.0,
            Class::Binary => 4.0,
            _ => 0.0,
        };
        self.space(around);
        self.letters(if text == "-" { "−" } else { text }, false, false);
        self.space(if class == Class::Punctuation {
            3.0
        } else {
            around
        });
    }

    /// A sum is put in parentheses where it becomes part of a fraction on the line.
    fn enclosed(&mut self, math: &Math, depth: u32) {
        let is_sum = matches!(math, Math::Row(pieces) if pieces.iter().any(|piece| {
            matches!(piece, Math::Operator { class: Class::Binary, .. } | Math::Fraction { .. })
        }));
        if is_sum {
            self.letters("(", false, false);
        }
        self.math(math, depth);
        if is_sum {
            self.letters(")", false, false);
        }
    }

    fn scripts(&mut self, sub: Option<&Math>, sup: Option<&Math>, depth: u32) {
        let (size, rise, start) = (self.size, self.rise, self.x);
        let mut end = start;
        for (script, shift) in [(sub, -0.19), (sup, 0.36)] {
            let Some(script) = script else { continue };
            self.gap += start - self.x;
            self.x = start;
            // Scripts of scripts stop at 6.3 points, below which nobody reads them on paper.
            self.size = (size * SCRIPT).max(LETTER_SIZE * 0.6);
            self.rise = rise + shift * size;
            self.math(script, depth);
            end = end.max(self.x);
        }
        self.gap += end - self.x;
        (self.size, self.rise, self.x) = (size, rise, end);
    }

    fn accent(&mut self, base: &Math, accent: Accent, depth: u32) {
        let (start, ascent) = (self.x, self.label.ascent);
        self.label.ascent = 0.0;
        self.math(base, depth);
        // Slanted letters have their top to the right of their middle.
        let x = f64::midpoint(start, self.x) + 0.06 * self.size;
        let y = self.label.ascent + 0.12 * self.size;
        self.label.marks.push(Above { accent, x, y });
        self.label.ascent = ascent.max(y + 0.08 * self.size);
    }

    /// Space in eighteenths of the letter size.
    fn space(&mut self, eighteenths: f64) {
        let width = eighteenths / 18.0 * self.size;
        self.gap += width;
        self.x += width;
    }

    fn letters(&mut self, text: &str, is_italic: bool, is_bold: bool) {
        if text.is_empty() {
            return;
        }
        let look = Look {
            is_italic,
            is_bold,
            size: self.size,
            rise: self.rise,
        };
        let gap = std::mem::take(&mut self.gap);
        // SVG joins blanks, and drops those at the ends of a run.
        let text = text.replace(' ', "\u{A0}");
        for letter in text.chars() {
            self.x += metrics::width(letter, is_italic) * self.size;
            let height = if metrics::is_tall(letter) {
                metrics::ASCENT
            } else {
                metrics::X_HEIGHT
            };
            let depth = if metrics::is_deep(letter) {
                metrics::DESCENT
            } else {
                0.0
            };
            self.label.ascent = self.label.ascent.max(self.rise + height * self.size);
            self.label.descent = self.label.descent.max(depth * self.size - self.rise);
        }
        self.label.width = self.label.width.max(self.x);
        match self.label.runs.last_mut() {
            Some(last) if last.look == look && gap == 0.0 => last.text.push_str(&text),
            _ => self.label.runs.push(LetterRun { text, look, gap }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::symbol;

    #[test]
    fn scripts_are_smaller_and_lower() {
        let label = FigureLabel::of(&symbol("omega_n"));
        assert_eq!(label.plain(), "ωn");
        assert!(label.runs[1].look.size < label.runs[0].look.size);
        assert!(label.runs[1].look.rise < 0.0);
    }

    #[test]
    fn symbols_in_words_are_italic() {
        let label = FigureLabel::words("F(t)");
        let italics: Vec<bool> = label.runs.iter().map(|run| run.look.is_italic).collect();
        assert_eq!(italics, [true, false, true, false]);
        assert!(!FigureLabel::words("sin θ").runs[0].look.is_italic);
        assert!(FigureLabel::words("mg").runs[0].look.is_italic);
    }

    #[test]
    fn a_superscript_stands_above_a_subscript() {
        let both = FigureLabel::of(&symbol("x1").with_sup(Math::number("2")));
        let one = FigureLabel::of(&symbol("x1"));
        assert!((both.width() - one.width()).abs() < 0.02);
        assert!(both.ascent() > one.ascent());
    }

    #[test]
    fn dots_raise_the_box() {
        let theta = symbol("theta");
        let plain = FigureLabel::of(&theta).ascent();
        let moving = FigureLabel::of(&theta.derivative(1));
        assert_eq!(moving.marks.len(), 1);
        assert!(moving.ascent() > plain);
    }

    #[test]
    fn a_hat_is_one_line_and_no_dots() {
        let base = Box::new(symbol("X"));
        let accent = Accent::Hat;
        let label = FigureLabel::of(&Math::Accent { base, accent });
        let marks: Vec<_> = label
            .marks
            .iter()
            .map(|mark| (mark.dots(), mark.line().len()))
            .collect();
        assert_eq!(marks, [(0, 3)]);
    }
}
