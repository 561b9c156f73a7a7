//! Typst from the tree.
//!
//! Nothing in a tree can be read as Typst: words and numbers are quoted strings, signs are escaped,
//! single letters stand alone, and all structure is the functions of Typst's `math` module and the
//! few of [`PRELUDE`].

use std::fmt::Write;

use super::script::Bearer;
use super::{Accent, Class, Display, Empty, Holes, Math, Size, Style, TableKind, Voice, spoken};

/// What a Typst file defines before the formulas that are written here: `m`, `sm`, `dm` and `lm` set a
/// formula in a line, one so short that no line ends in it, one on its own, and one on its own that is
/// made smaller where its place is too narrow, each with its words for who cannot see it; `tm` sets one
/// that is long but narrow, with the distances of `lm`; `fit` makes anything smaller; the others are the
/// classes of signs, which TeX and Typst do not give to the same signs.
pub const PRELUDE: &str = r#"#let fit(body) = layout(room => {
  let wide = measure(body).width
  if wide > room.width { scale(room.width / wide * 100%, reflow: true, box(width: wide, body)) } else { body }
})
#let m(words, formula) = math.equation(alt: words, formula.body)
#let sm(words, formula) = box(m(words, formula))
#let dm(words, formula) = math.equation(block: true, alt: words, formula.body)
#let lm(words, formula) = fit(dm(words, formula))
#let tm(words, formula) = block(width: 100%, dm(words, formula))
#let bin = math.class.with("binary")
#let rel = math.class.with("relation")
#let ord = math.class.with("normal")
#let opening = math.class.with("opening")
#let closing = math.class.with("closing")
#let pun = math.class.with("punctuation")
#let lim = math.op.with(limits: true)
#let rows = math.mat.with(delim: none, column-gap: 1em, row-gap: .35em)
#let cases2 = math.mat.with(delim: none, align: left, column-gap: 1.2em, row-gap: .45em)
#let lines = math.mat.with(delim: none, column-gap: 0pt, row-gap: .7em)
"#;

/// Bytes of a formula in which no line ends, about those of `x₀ = −0.17 m`.
const SHORT: usize = 80;

/// Bytes of a formula, those of cells side by side alone, that may be wider than a page; to measure one takes as long as
/// to set it.
const LONG: usize = 200;

/// Appends Typst markup that sets the formula.
pub(crate) fn write(
    math: &Math,
    out: &mut String,
    display: Display,
    holes: &dyn Holes,
    voice: &'static Voice,
) {
    let mut body = String::new();
    let mut writer = TypstWriter {
        out: &mut body,
        holes,
        below: 0,
    };
    writer.math(math);
    let below = writer.below;
    out.push_str(match display {
        Display::Inline if body.len() <= SHORT => "#sm(",
        Display::Inline => "#m(",
        Display::Block if body.len() <= LONG => "#dm(",
        Display::Block if body.len() - below <= LONG => "#tm(",
        Display::Block => "#lm(",
    });
    let mut words = String::new();
    spoken::write(math, &mut words, holes, voice);
    quote(out, &words);
    out.push_str(",$");
    out.push_str(&body);
    out.push_str("$)");
}

/// Appends a string of Typst's code mode that is this text.
pub fn quote(out: &mut String, text: &str) {
    out.push('"');
    for char in text.chars() {
        match char {
            '\\' | '"' => {
                out.push('\\');
                out.push(char);
            }
            '\n' => out.push_str("\\n"),
            char if char.is_control() || super::is_invisible(char) => {}
            char => out.push(char),
        }
    }
    out.push('"');
}

struct TypstWriter<'a> {
    out: &'a mut String,
    holes: &'a dyn Holes,
    /// Bytes of what stands above or below wider cells of a table, and so adds nothing to the width of the formula.
    below: usize,
}

impl TypstWriter<'_> {
    fn math(&mut self, math: &Math) {
        match math {
            Math::Row(pieces) => pieces.iter().for_each(|piece| self.math(piece)),
            Math::Identifier { text, style } => self.identifier(text, *style),
            Math::Number(digits) => self.number(digits),
            Math::Operator { text, class } => self.operator(text, *class),
            Math::Function(name) => self.function(name),
            Math::Text(words) => quote(self.out, words),
            Math::Space(width) => self.space(*width),
            Math::Fraction {
                numerator,
                denominator,
                bar,
                size,
            } => self.fraction(numerator, denominator, *bar, *size),
            Math::Root { radicand, degree } => match degree {
                Some(degree) => self.call("root", &[degree, radicand]),
                None => self.call("sqrt", &[radicand]),
            },
            Math::Script { base, sub, sup } => self.script(base, sub.as_deref(), sup.as_deref()),
            Math::Stack { base, under, over } => {
                self.stack(base, under.as_deref(), over.as_deref());
            }
            Math::Accent { base, accent } => self.accent(base, *accent),
            Math::Fence {
                open,
                close,
                body,
                stretchy,
            } => self.fence(open, close, body, *stretchy),
            Math::Table { rows, kind } => self.table(rows, *kind),
            Math::Hole(hole) => match self.holes.filling(*hole) {
                Some(filling) => {
                    let holes = std::mem::replace(&mut self.holes, &Empty);
                    self.math(filling);
                    self.holes = holes;
                }
                None => self.sign('□'),
            },
        }
    }

    /// A letter, digit or name, kept apart from one before it.
    fn word(&mut self, word: &str) {
        if self.out.ends_with(char::is_alphanumeric) {
            self.out.push(' ');
        }
        self.out.push_str(word);
    }

    /// A character that means itself.
    fn sign(&mut self, sign: char) {
        if sign.is_alphanumeric() {
            return self.word(sign.encode_utf8(&mut [0; 4]));
        }
        if sign.is_whitespace() || sign.is_control() {
            return;
        }
        self.out.push('\\');
        self.out.push(sign);
    }

    fn call(&mut self, function: &str, arguments: &[&Math]) {
        self.open(function);
        for (number, argument) in arguments.iter().enumerate() {
            if number > 0 {
                self.out.push(',');
            }
            self.argument(argument);
        }
        self.out.push(')');
    }

    /// Functions of Typst want their argument: nothing is an empty text.
    fn argument(&mut self, math: &Math) {
        let start = self.out.len();
        self.math(math);
        if self.out.len() == start {
            self.out.push_str("\"\"");
        }
    }

    fn open(&mut self, function: &str) {
        self.word(function);
        self.out.push('(');
    }

    fn identifier(&mut self, text: &str, style: Style) {
        let mut letters = text.chars();
        let single = letters.next().filter(|_| letters.next().is_none());
        let function = match (style, single) {
            (Style::Default, Some(letter)) if ('Α'..='Ω').contains(&letter) => "upright",
            (Style::Default, Some(letter)) => return self.sign(letter),
            (Style::Upright, Some(_)) => "upright",
            (Style::Default | Style::Upright, None) => return quote(self.out, text),
            (Style::Bold, _) => "bold(upright",
            (Style::BoldItalic, _) => "bold(italic",
            (Style::Script, _) => "cal",
            (Style::Double, _) => "bb",
        };
        self.open(function);
        text.chars().for_each(|letter| self.sign(letter));
        self.out
            .push_str(if function.contains('(') { "))" } else { ")" });
    }

    fn number(&mut self, digits: &str) {
        let is_plain = digits.bytes().all(|byte| byte.is_ascii_digit());
        if is_plain && !digits.is_empty() {
            return self.word(digits);
        }
        quote(self.out, &digits.replace('-', "−"));
    }

    fn operator(&mut self, text: &str, class: Class) {
        let function = match class {
            Class::Relation if matches!(text, "=" | "<" | ">" | "≤" | "≥" | "≈" | "≠" | "→") => {
                None
            }
            Class::Punctuation if matches!(text, "," | ";") => None,
            Class::Opening if matches!(text, "(" | "[" | "{") => None,
            Class::Closing if matches!(text, ")" | "]" | "}") => None,
            Class::Large => None,
            Class::Binary => Some("bin"),
            Class::Relation => Some("rel"),
            Class::Prefix | Class::Ordinary => Some("ord"),
            Class::Punctuation => Some("pun"),
            Class::Opening => Some("opening"),
            Class::Closing => Some("closing"),
        };
        if let Some(function) = function {
            self.open(function);
        }
        for char in text.chars() {
            self.sign(if char == '-' { '−' } else { char });
        }
        if function.is_some() {
            self.out.push(')');
        }
    }

    fn function(&mut self, name: &str) {
        let has_limits = matches!(name, "lim" | "max" | "min" | "sup" | "inf" | "gcd");
        self.open(if has_limits { "lim" } else { "op" });
        quote(self.out, name);
        self.out.push(')');
    }

    /// Space in eighteenths of an em.
    fn space(&mut self, width: i16) {
        // Writing to a string cannot fail.
        let _ = write!(self.out, "#h({:.4}em)", f64::from(width) / 18.0);
    }

    fn fraction(&mut self, numerator: &Math, denominator: &Math, bar: bool, size: Size) {
        let style = match size {
            Size::Auto => None,
            Size::Display => Some("display"),
            Size::Text => Some("inline"),
        };
        if let Some(style) = style {
            self.open(style);
        }
        if bar {
            self.call("frac", &[numerator, denominator]);
        } else {
            self.open("rows");
            self.argument(numerator);
            self.out.push(';');
            self.argument(denominator);
            self.out.push(')');
        }
        if style.is_some() {
            self.out.push(')');
        }
    }

    fn script(&mut self, base: &Math, sub: Option<&Math>, sup: Option<&Math>) {
        let holes = self.holes;
        let bearer = Bearer::of(base, sub, sup, holes);
        self.open("attach");
        if bearer.needs_parentheses {
            self.fence("(", ")", base, true);
        } else {
            self.math(bearer.base);
        }
        self.scripts(bearer.sub, bearer.sup);
    }

    fn scripts(&mut self, below: Option<&Math>, above: Option<&Math>) {
        for (place, script) in [(",b:", below), (",t:", above)] {
            if let Some(script) = script {
                self.out.push_str(place);
                self.math(script);
            }
        }
        self.out.push(')');
    }

    fn stack(&mut self, base: &Math, under: Option<&Math>, over: Option<&Math>) {
        if over.is_none() && under.is_some_and(|mark| mark.is_sign("⏟")) {
            return self.call("underbrace", &[base]);
        }
        if under.is_none() && over.is_some_and(|mark| mark.is_sign("⏞")) {
            return self.call("overbrace", &[base]);
        }
        self.open("attach");
        let is_movable = matches!(
            base,
            Math::Function(_)
                | Math::Operator {
                    class: Class::Large,
                    ..
                }
        );
        if is_movable {
            self.math(base);
        } else {
            self.call("limits", &[base]);
        }
        self.scripts(under, over);
    }

    fn accent(&mut self, base: &Math, accent: Accent) {
        let is_wide = !matches!(base.filled(self.holes), Math::Identifier { text, .. } if text.chars().nth(1).is_none());
        let function = match accent {
            Accent::Dot => "dot",
            Accent::DoubleDot => "dot.double",
            Accent::TripleDot => "dot.triple",
            Accent::Hat => "hat",
            Accent::Tilde => "tilde",
            Accent::Bar if is_wide => "overline",
            Accent::Bar => "macron",
            Accent::Vector => "arrow",
        };
        self.call(function, &[base]);
    }

    fn fence(&mut self, open: &str, close: &str, body: &Math, stretchy: bool) {
        if stretchy {
            self.open("lr");
            open.chars().for_each(|sign| self.sign(sign));
            self.math(body);
            close.chars().for_each(|sign| self.sign(sign));
            return self.out.push(')');
        }
        if !open.is_empty() {
            self.operator(open, Class::Opening);
        }
        self.math(body);
        if !close.is_empty() {
            self.operator(close, Class::Closing);
        }
    }

    /// Cells are set at the size of text, which Typst would make smaller than TeX does.
    fn table(&mut self, rows: &[Vec<Math>], kind: TableKind) {
        let (function, size) = match kind {
            TableKind::Matrix => ("rows", "inline"),
            TableKind::Cases => ("cases2", "inline"),
            TableKind::Aligned => ("lines", "display"),
        };
        let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
        let mut widest = vec![0; columns];
        let (start, below) = (self.out.len(), self.below);
        self.open(function);
        for (number, row) in rows.iter().enumerate() {
            if number > 0 {
                self.out.push(';');
            }
            for (column, widest) in widest.iter_mut().enumerate() {
                if column > 0 {
                    self.out.push(',');
                }
                let (start, below) = (self.out.len(), self.below);
                self.cell(row.get(column), column, kind, size);
                *widest = (self.out.len() - start - (self.below - below)).max(*widest);
            }
        }
        // A table of one row stays a table.
        self.out.push_str(";)");
        self.below = below + (self.out.len() - start - widest.iter().sum::<usize>());
    }

    fn cell(&mut self, cell: Option<&Math>, column: usize, kind: TableKind, size: &str) {
        let is_right = kind == TableKind::Aligned && column % 2 == 1;
        if is_right {
            self.out.push('&');
        } else if kind == TableKind::Aligned && column > 0 {
            self.out.push_str("#h(2em)");
        }
        if let Some(cell) = cell {
            self.open(size);
            self.argument(cell);
            self.out.push(')');
        }
        if kind == TableKind::Aligned && !is_right {
            self.out.push('&');
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbol;

    fn check(math: Math, expected: &str) {
        let written = math.typst(Display::Inline, Voice::ENGLISH);
        let body = written
            .split_once(",$")
            .and_then(|(_, rest)| rest.strip_suffix("$)"));
        assert_eq!(body, Some(expected), "{written}");
    }

    #[test]
    fn an_empty_cell_is_an_argument_too() {
        let rows = vec![vec![Math::row([]), Math::letter('x')]];
        let table = Math::Table {
            rows,
            kind: TableKind::Aligned,
        };
        check(table, "lines(display(\"\")&,&display(x);)");
        check(
            Math::fraction(Math::row([]), Math::letter('x')),
            "frac(\"\",x)",
        );
    }

    #[test]
    fn neighbours_do_not_merge_into_names() {
        let row = Math::row([
            Math::fraction(Math::letter('g'), Math::letter('ℓ')),
            Math::function("sin"),
            Math::letter('θ'),
            Math::letter('t'),
            Math::number("2"),
        ]);
        check(row, "frac(g,ℓ)op(\"sin\")θ t 2");
        check(symbol("omega_n"), "attach(ω,b:n)");
        check(
            symbol("omega_n").with_sup(Math::number("2")),
            "attach(ω,b:n,t:2)",
        );
        check(Math::letter('x').derivative(2), "dot.double(x)");
        check(Math::number("2.5"), "\"2.5\"");
    }

    #[test]
    fn lines_one_above_the_other_do_not_make_a_formula_wide() {
        let cell = |length: usize| Math::text("a".repeat(length));
        let begins = |rows: Vec<Vec<Math>>, begin: &str| {
            let table = Math::Table {
                rows,
                kind: TableKind::Aligned,
            };
            let written = table.typst(Display::Block, Voice::ENGLISH);
            assert!(written.starts_with(begin), "{written}");
        };
        begins(vec![vec![cell(LONG / 2)]], "#dm(");
        begins(vec![vec![cell(LONG / 2)], vec![cell(LONG / 2)]], "#tm(");
        begins(vec![vec![cell(LONG / 2), cell(LONG / 2)]], "#lm(");
        begins(vec![vec![cell(LONG)], vec![cell(1)]], "#lm(");
    }

    #[test]
    fn words_cannot_leave_their_string() {
        let text = Math::text("a\" + panic() \\");
        let written = text.typst(Display::Block, Voice::ENGLISH);
        let words = r#""a\" + panic() \\""#;
        assert_eq!(written, format!("#dm({words},${words}$)"));
    }
}
