//! Words from the tree, for those who hear a formula.

use super::script::Bearer;
use super::sign::greek_name;
use super::{Accent, Class, Empty, Holes, Math, Sign, Style, TableKind};
use vibank_source::is_capital;

impl Math {
    /// As words: `omega sub n equals the square root of k over m end root`.
    pub fn spoken(&self) -> String {
        let mut out = String::new();
        self.write_spoken(&mut out, &Empty);
        out
    }

    /// Appends the words.
    pub fn write_spoken(&self, out: &mut String, holes: &dyn Holes) {
        let start = out.len();
        SpokenWriter { out, holes, start }.math(self);
    }
}

struct SpokenWriter<'a> {
    out: &'a mut String,
    holes: &'a dyn Holes,
    /// Where this formula begins.
    start: usize,
}

impl SpokenWriter<'_> {
    fn math(&mut self, math: &Math) {
        match math {
            Math::Row(pieces) => pieces.iter().for_each(|piece| self.math(piece)),
            Math::Identifier { text, style } => self.identifier(text, *style),
            Math::Number(digits) => match digits.strip_prefix(['-', '−']) {
                Some(digits) => {
                    self.say("minus");
                    self.say(digits);
                }
                None => self.say(digits),
            },
            Math::Operator { text, class } => self.operator(text, *class),
            Math::Function(name) => self.say(function_words(name)),
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
                    None => self.say("the square root of"),
                    Some(degree) => {
                        self.say("the root of degree");
                        self.math(degree);
                        self.say("of");
                    }
                }
                self.math(radicand);
                self.say("end root");
            }
            Math::Script { base, sub, sup } => self.script(base, sub.as_deref(), sup.as_deref()),
            Math::Stack { base, under, over } => {
                self.stack(base, under.as_deref(), over.as_deref());
            }
            Math::Accent { base, accent } => {
                self.math(base);
                self.say(match accent {
                    Accent::Dot => "dot",
                    Accent::DoubleDot => "double dot",
                    Accent::TripleDot => "triple dot",
                    Accent::Hat => "hat",
                    Accent::Tilde => "tilde",
                    Accent::Bar => "bar",
                    Accent::Vector => "vector",
                });
            }
            Math::Fence {
                open, close, body, ..
            } => self.fence(open, close, body),
            Math::Table { rows, kind } => self.table(rows, *kind),
            Math::Hole(hole) => match self.holes.filling(*hole) {
                Some(Math::Hole(_)) | None => self.say("blank"),
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

    fn identifier(&mut self, text: &str, style: Style) {
        match style {
            Style::Bold | Style::BoldItalic => self.say("bold"),
            Style::Script => self.say("script"),
            Style::Double => self.say("double-struck"),
            Style::Default | Style::Upright => {}
        }
        let mut chars = text.chars();
        if let (Some(letter), None) = (chars.next(), chars.next()) {
            return self.letter(letter);
        }
        self.say(text);
    }

    fn letter(&mut self, letter: char) {
        if is_capital(letter) {
            self.say("capital");
        }
        match greek_name(letter) {
            Some(name) => {
                let name = name.strip_prefix("var").unwrap_or(name);
                let start = self.out.len();
                self.say(name);
                let capital = start + usize::from(start > self.start);
                self.out[capital..].make_ascii_lowercase();
            }
            None => match Sign::of(letter) {
                Some(sign) => self.say(sign.words),
                None => self.say(letter.encode_utf8(&mut [0; 4])),
            },
        }
    }

    fn operator(&mut self, text: &str, class: Class) {
        for char in text.chars() {
            let char = if char == '-' { '−' } else { char };
            match Sign::of(char) {
                Some(sign) => self.say(sign.words),
                None => self.say(char.encode_utf8(&mut [0; 4])),
            }
        }
        if class == Class::Large {
            self.say("of");
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
        let over = if bar { "over" } else { "above" };
        if self.is_short(numerator) && self.is_short(denominator) {
            self.math(numerator);
            self.say(over);
            return self.math(denominator);
        }
        self.say("the fraction");
        self.math(numerator);
        self.say(over);
        self.math(denominator);
        self.say("end fraction");
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
            self.say("sub");
            self.math(sub);
            if !self.is_short(sub) {
                self.say("end sub");
            }
        }
        if let Some(sup) = bearer.sup {
            self.power(sup);
        }
    }

    fn power(&mut self, sup: &Math) {
        match sup.filled(self.holes) {
            Math::Number(digits) if digits == "2" => self.say("squared"),
            Math::Number(digits) if digits == "3" => self.say("cubed"),
            Math::Operator { text, .. } if text == "′" => self.say("prime"),
            Math::Operator { text, .. } if text == "∘" => self.say("degrees"),
            Math::Operator { text, .. } if text == "∗" => self.say("star"),
            _ => {
                self.say("to the power");
                self.math(sup);
                if !self.is_short(sup) {
                    self.say("end power");
                }
            }
        }
    }

    /// A sum or integral with its bounds.
    fn bounds(&mut self, sign: &str, from: Option<&Math>, to: Option<&Math>) {
        for char in sign.chars() {
            self.say(Sign::of(char).map_or("the operator", |sign| sign.words));
        }
        for (word, bound) in [("from", from), ("to", to)] {
            if let Some(bound) = bound {
                self.say(word);
                self.math(bound);
            }
        }
        self.say("of");
    }

    fn stack(&mut self, base: &Math, under: Option<&Math>, over: Option<&Math>) {
        let is_brace = |mark: &Math| matches!(mark, Math::Operator { text, .. } if matches!(text.as_str(), "⏟" | "⏞"));
        if let Math::Operator {
            class: Class::Large,
            text,
        } = base
        {
            return self.bounds(text, under, over);
        }
        self.math(base);
        for (word, mark) in [("with", under), ("under", over)] {
            match mark {
                Some(mark) if is_brace(mark) => self.say("in a brace"),
                Some(mark) => {
                    self.say(word);
                    self.math(mark);
                    if word == "with" {
                        self.say("below");
                    }
                }
                None => {}
            }
        }
    }

    fn fence(&mut self, open: &str, close: &str, body: &Math) {
        if let Math::Table { .. } = body {
            if (open, close) == ("|", "|") {
                self.say("the determinant of");
            }
            return self.math(body);
        }
        if (open, close) == ("|", "|") {
            self.say("the absolute value of");
            self.math(body);
            return self.say("end absolute value");
        }
        self.operator(open, Class::Opening);
        self.math(body);
        self.operator(close, Class::Closing);
    }

    fn table(&mut self, rows: &[Vec<Math>], kind: TableKind) {
        let (name, line, cell, end) = match kind {
            TableKind::Matrix => ("the matrix with", "row", ",", "end matrix"),
            TableKind::Cases => ("the cases", "case", "", "end cases"),
            TableKind::Aligned => ("", "line", "", ""),
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

fn function_words(name: &str) -> &str {
    match name {
        "sin" => "sine",
        "cos" => "cosine",
        "tan" => "tangent",
        "exp" => "the exponential of",
        "ln" => "the natural logarithm of",
        "log" => "the logarithm of",
        "arctan" => "the arc tangent of",
        "arcsin" => "the arc sine of",
        "arccos" => "the arc cosine of",
        "sinh" => "the hyperbolic sine of",
        "cosh" => "the hyperbolic cosine of",
        "tanh" => "the hyperbolic tangent of",
        "lim" => "the limit",
        "max" => "the maximum",
        "min" => "the minimum",
        "det" => "the determinant of",
        "arg" => "the argument of",
        name => name,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbol;

    #[test]
    fn formulas_are_read_aloud() {
        let x = || symbol("x1");
        for (math, words) in [
            (symbol("Omega"), "capital omega"),
            (symbol("theta0_max"), "theta sub 0 comma max end sub"),
            (x().derivative(2), "x double dot sub 1"),
            (Math::letter('r').with_sup(Math::number("2")), "r squared"),
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
            assert_eq!(math.spoken(), words);
        }
    }
}
