//! Words from the tree, for those who hear a formula.

use super::script::Bearer;
use super::sign::greek_name;
use super::{Accent, Class, Empty, Holes, Math, Sign, Style, TableKind, Voice};
use vibank_source::is_capital;

/// Appends the words.
pub(crate) fn write(math: &Math, out: &mut String, holes: &dyn Holes, voice: &'static Voice) {
    let start = out.len();
    let mut writer = SpokenWriter {
        out,
        holes,
        voice,
        start,
    };
    writer.math(math);
}

struct SpokenWriter<'a> {
    out: &'a mut String,
    holes: &'a dyn Holes,
    voice: &'static Voice,
    /// Where this formula begins.
    start: usize,
}

impl SpokenWriter<'_> {
    fn math(&mut self, math: &Math) {
        let voice = self.voice;
        match math {
            Math::Row(pieces) => pieces.iter().for_each(|piece| self.math(piece)),
            Math::Identifier { text, style } => self.identifier(text, *style),
            Math::Number(digits) => match digits.strip_prefix(['-', '−']) {
                Some(digits) => {
                    self.say(voice.minus);
                    self.say(digits);
                }
                None => self.say(digits),
            },
            Math::Operator { text, class } => self.operator(text, *class),
            Math::Function(name) => self.say((voice.function)(name).unwrap_or(name)),
            Math::Text(words) => self.say(words.trim()),
            Math::Space(_) => {}
            Math::Fraction {
                numerator,
                denominator,
                bar,
                ..
            } => self.fraction(numerator, denominator, *bar),
            Math::Root { radicand, degree } => {
                match degree {
                    None => self.say(voice.root[0]),
                    Some(degree) => self.around(voice.degree, degree),
                }
                self.math(radicand);
                self.say(voice.root[1]);
            }
            Math::Script { base, sub, sup } => self.script(base, sub.as_deref(), sup.as_deref()),
            Math::Stack { base, under, over } => {
                self.stack(base, under.as_deref(), over.as_deref());
            }
            Math::Accent { base, accent } => {
                self.math(base);
                self.say(
                    voice.accents[match accent {
                        Accent::Dot => 0,
                        Accent::DoubleDot => 1,
                        Accent::TripleDot => 2,
                        Accent::Hat => 3,
                        Accent::Tilde => 4,
                        Accent::Bar => 5,
                        Accent::Vector => 6,
                    }],
                );
            }
            Math::Fence {
                open, close, body, ..
            } => self.fence(open, close, body),
            Math::Table { rows, kind } => self.table(rows, *kind),
            Math::Hole(hole) => match self.holes.filling(*hole) {
                Some(Math::Hole(_)) | None => self.say(voice.blank),
                Some(filling) => {
                    let holes = std::mem::replace(&mut self.holes, &Empty);
                    self.math(filling);
                    self.holes = holes;
                }
            },
        }
    }

    fn say(&mut self, words: &str) {
        if words.is_empty() {
            return;
        }
        if self.out.len() > self.start {
            self.out.push(' ');
        }
        self.out.push_str(words);
    }

    /// Something between two words.
    fn around(&mut self, words: [&str; 2], math: &Math) {
        self.say(words[0]);
        self.math(math);
        self.say(words[1]);
    }

    fn identifier(&mut self, text: &str, style: Style) {
        let style = match style {
            Style::Bold | Style::BoldItalic => self.voice.bold,
            Style::Script => self.voice.script,
            Style::Double => self.voice.double,
            Style::Default | Style::Upright => ["", ""],
        };
        self.say(style[0]);
        let mut chars = text.chars();
        match (chars.next(), chars.next()) {
            (Some(letter), None) => self.letter(letter),
            _ => self.say(text),
        }
        self.say(style[1]);
    }

    fn letter(&mut self, letter: char) {
        let capital = if is_capital(letter) {
            self.voice.capital
        } else {
            ["", ""]
        };
        self.say(capital[0]);
        match greek_name(letter) {
            Some(name) => {
                let name = (self.voice.letter)(name.strip_prefix("var").unwrap_or(name));
                let start = self.out.len();
                self.say(name);
                let capital = start + usize::from(start > self.start);
                self.out[capital..].make_ascii_lowercase();
            }
            None => self.sign(letter),
        }
        self.say(capital[1]);
    }

    /// A sign by its name; one that has none as it is.
    fn sign(&mut self, char: char) {
        match Sign::of(char) {
            Some(sign) => self.say((self.voice.sign)(sign.words)),
            None => self.say(char.encode_utf8(&mut [0; 4])),
        }
    }

    fn operator(&mut self, text: &str, class: Class) {
        for char in text.chars() {
            self.sign(if char == '-' { '−' } else { char });
        }
        if class == Class::Large {
            self.say(self.voice.of);
        }
    }

    /// Whether a tree is one thing, which needs no word for its end.
    fn is_short(&self, math: &Math) -> bool {
        match math.filled(self.holes) {
            Math::Row(pieces) => pieces.len() < 2,
            Math::Fraction { .. } | Math::Table { .. } | Math::Stack { .. } => false,
            _ => true,
        }
    }

    fn fraction(&mut self, numerator: &Math, denominator: &Math, bar: bool) {
        let over = if bar {
            self.voice.over
        } else {
            self.voice.above
        };
        if self.is_short(numerator) && self.is_short(denominator) {
            self.math(numerator);
            self.say(over);
            return self.math(denominator);
        }
        self.say(self.voice.fraction[0]);
        self.math(numerator);
        self.say(over);
        self.math(denominator);
        self.say(self.voice.fraction[1]);
    }

    fn script(&mut self, base: &Math, sub: Option<&Math>, sup: Option<&Math>) {
        let holes = self.holes;
        let bearer = Bearer::of(base, sub, sup, holes);
        if let Math::Operator {
            class: Class::Large,
            text,
        } = bearer.base
        {
            return self.bounds(text, bearer.sub, bearer.sup);
        }
        self.math(bearer.base);
        if let Some(sub) = bearer.sub {
            self.say(self.voice.sub[0]);
            self.math(sub);
            if !self.is_short(sub) {
                self.say(self.voice.sub[1]);
            }
        }
        if let Some(sup) = bearer.sup {
            self.power(sup);
        }
    }

    fn power(&mut self, sup: &Math) {
        let voice = self.voice;
        if let Some(count) = self.primes(sup) {
            (0..count).for_each(|_| self.say(voice.prime));
            return;
        }
        match sup.filled(self.holes) {
            Math::Number(digits) if digits == "2" => self.say(voice.squared),
            Math::Number(digits) if digits == "3" => self.say(voice.cubed),
            Math::Operator { text, .. } if text == "∘" => self.say(voice.degrees),
            Math::Operator { text, .. } if text == "∗" => self.say(voice.star),
            _ => {
                self.say(voice.power[0]);
                self.math(sup);
                if !self.is_short(sup) {
                    self.say(voice.power[1]);
                }
            }
        }
    }

    /// How many primes a superscript is made of; none if it is something else.
    fn primes(&self, sup: &Math) -> Option<usize> {
        match sup.filled(self.holes) {
            Math::Operator { text, .. } if text.chars().all(|sign| sign == '′') => {
                Some(text.chars().count())
            }
            Math::Row(pieces) if !pieces.is_empty() => {
                pieces.iter().map(|piece| self.primes(piece)).sum()
            }
            _ => None,
        }
    }

    /// A sum or integral with its bounds.
    fn bounds(&mut self, sign: &str, from: Option<&Math>, to: Option<&Math>) {
        for char in sign.chars() {
            let name = Sign::of(char).map(|sign| (self.voice.sign)(sign.words));
            self.say(name.unwrap_or(self.voice.operator));
        }
        let [first, last] = self.voice.bounds;
        for (word, bound) in [(first, from), (last, to)] {
            if let Some(bound) = bound {
                self.say(word);
                self.math(bound);
            }
        }
        self.say(self.voice.of);
    }

    fn stack(&mut self, base: &Math, under: Option<&Math>, over: Option<&Math>) {
        if let Math::Operator {
            class: Class::Large,
            text,
        } = base
        {
            return self.bounds(text, under, over);
        }
        self.math(base);
        let voice = self.voice;
        for (words, mark) in [(voice.with, under), ([voice.under, ""], over)] {
            match mark {
                Some(mark) if mark.is_brace() => self.say(voice.brace),
                Some(mark) => self.around(words, mark),
                None => {}
            }
        }
    }

    fn fence(&mut self, open: &str, close: &str, body: &Math) {
        if let Math::Table { .. } = body {
            if (open, close) == ("|", "|") {
                self.say(self.voice.determinant);
            }
            return self.math(body);
        }
        if (open, close) == ("|", "|") {
            return self.around(self.voice.absolute, body);
        }
        self.operator(open, Class::Opening);
        self.math(body);
        self.operator(close, Class::Closing);
    }

    fn table(&mut self, rows: &[Vec<Math>], kind: TableKind) {
        let ([name, line, end], cell) = match kind {
            TableKind::Matrix => (self.voice.matrix, ","),
            TableKind::Cases => (self.voice.cases, ""),
            TableKind::Aligned => (["", self.voice.line, ""], ""),
        };
        self.say(name);
        for (number, row) in rows.iter().enumerate() {
            self.say(line);
            self.say(&(number + 1).to_string());
            self.out.push(':');
            for (column, entry) in row.iter().enumerate() {
                if column > 0 {
                    self.out.push_str(cell);
                }
                self.math(entry);
            }
            if number + 1 < rows.len() {
                self.out.push(';');
            }
        }
        self.say(end);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbol;

    #[test]
    fn formulas_are_read_aloud() {
        let x = || symbol("x1");
        let primes = |count| Math::row(std::iter::repeat_n(Math::prefix("′"), count));
        for (math, words) in [
            (symbol("Omega"), "capital omega"),
            (symbol("theta0_max"), "theta sub 0 comma max end sub"),
            (x().derivative(2), "x double dot sub 1"),
            (Math::letter('r').with_sup(Math::number("2")), "r squared"),
            (Math::letter('v').with_sup(primes(1)), "v prime"),
            (Math::letter('v').with_sup(primes(2)), "v prime prime"),
            (
                Math::row([
                    Math::prefix("−"),
                    Math::number("3"),
                    Math::relation("≤"),
                    x(),
                ]),
                "minus 3 is at most x sub 1",
            ),
            (
                Math::fraction(
                    Math::row([Math::letter('a'), Math::binary("+"), Math::letter('b')]),
                    x(),
                ),
                "the fraction a plus b over x sub 1 end fraction",
            ),
            (
                Math::matrix(vec![
                    vec![Math::number("1"), Math::number("0")],
                    vec![Math::letter('a'), Math::letter('b')],
                ]),
                "the matrix with row 1: 1, 0; row 2: a, b end matrix",
            ),
            (
                Math::operator("∫", Class::Large)
                    .with_sub(Math::number("0"))
                    .with_sup(Math::letter('T')),
                "the integral from 0 to capital T of",
            ),
            (Math::identifier("M", Style::Bold), "bold capital M"),
            (
                Math::Table {
                    rows: vec![vec![Math::letter('a'), Math::letter('b')]],
                    kind: TableKind::Matrix,
                }
                .fenced("|", "|"),
                "the determinant of the matrix with row 1: a, b end matrix",
            ),
        ] {
            assert_eq!(math.spoken(Voice::ENGLISH), words);
        }
    }
}
