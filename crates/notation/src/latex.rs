//! LaTeX from the tree.
//!
//! What is written compiles under `amsmath`, `amssymb` and `mathtools` and reads back as the same
//! tree.

use super::script::Bearer;
use super::sign::greek_name;
use super::{Accent, Class, Empty, Holes, Math, Sign, Size, Style, TableKind};

/// Appends LaTeX source, without dollar signs.
pub(crate) fn write(math: &Math, out: &mut String, holes: &dyn Holes) {
    LatexWriter {
        out,
        holes,
        after_word: false,
    }
    .math(math);
}

/// Functions that have a command of their own.
pub(crate) const FUNCTIONS: &[&str] = &[
    "arccos", "arcsin", "arctan", "arg", "cos", "cosh", "cot", "coth", "csc", "deg", "det", "dim",
    "exp", "gcd", "inf", "ker", "lg", "lim", "ln", "log", "max", "min", "sec", "sin", "sinh",
    "sup", "tan", "tanh",
];

struct LatexWriter<'a> {
    out: &'a mut String,
    holes: &'a dyn Holes,
    /// Whether a command made of letters has just ended.
    after_word: bool,
}

impl LatexWriter<'_> {
    fn math(&mut self, math: &Math) {
        match math {
            Math::Row(pieces) => pieces.iter().for_each(|piece| self.math(piece)),
            Math::Identifier { text, style } => self.identifier(text, *style),
            Math::Number(digits) => self.number(digits),
            Math::Operator { text, class } => self.operator(text, *class),
            Math::Function(name) => self.function(name),
            Math::Text(words) => self.text(words),
            Math::Space(width) => self.space(*width),
            Math::Fraction {
                numerator,
                denominator,
                bar,
                size,
            } => {
                self.command(match (bar, size) {
                    (true, Size::Auto) => r"\frac",
                    (true, Size::Display) => r"\dfrac",
                    (true, Size::Text) => r"\tfrac",
                    (false, Size::Auto) => r"\genfrac{}{}{0pt}{}",
                    (false, Size::Display) => r"\genfrac{}{}{0pt}{0}",
                    (false, Size::Text) => r"\genfrac{}{}{0pt}{1}",
                });
                self.group(numerator);
                self.group(denominator);
            }
            Math::Root { radicand, degree } => self.root(radicand, degree.as_deref()),
            Math::Script { base, sub, sup } => self.script(base, sub.as_deref(), sup.as_deref()),
            Math::Stack { base, under, over } => {
                self.stack(base, under.as_deref(), over.as_deref());
            }
            Math::Accent { base, accent } => {
                self.command(match accent {
                    Accent::Dot => r"\dot",
                    Accent::DoubleDot => r"\ddot",
                    Accent::TripleDot => r"\dddot",
                    Accent::Hat => r"\hat",
                    Accent::Tilde => r"\tilde",
                    Accent::Bar => r"\bar",
                    Accent::Vector => r"\vec",
                });
                self.group(base);
            }
            Math::Fence {
                open,
                close,
                body,
                stretchy,
            } => self.fence(open, close, body, *stretchy),
            Math::Table { rows, kind } => self.table(
                rows,
                match kind {
                    TableKind::Matrix => "matrix",
                    TableKind::Cases => "cases",
                    TableKind::Aligned => "aligned",
                },
            ),
            Math::Hole(hole) => match self.holes.filling(*hole) {
                Some(filling) => {
                    // A filling has no holes of its own: one that held itself would be written without end.
                    let holes = std::mem::replace(&mut self.holes, &Empty);
                    self.math(filling);
                    self.holes = holes;
                }
                None => self.command(r"\square"),
            },
        }
    }

    /// Writes characters, kept apart from a command before them.
    fn raw(&mut self, text: &str) {
        if self.after_word && text.starts_with(|c: char| c.is_ascii_alphabetic()) {
            self.out.push(' ');
        }
        self.out.push_str(text);
        self.after_word &= text.is_empty();
    }

    fn command(&mut self, command: &str) {
        self.raw(command);
        self.after_word = command.rsplit_once('\\').is_some_and(|(_, name)| {
            !name.is_empty() && name.bytes().all(|byte| byte.is_ascii_alphabetic())
        });
    }

    fn group(&mut self, math: &Math) {
        self.raw("{");
        self.math(math);
        self.raw("}");
    }

    /// One character of a symbol.
    fn char(&mut self, char: char) {
        if char.is_ascii_alphanumeric() {
            return self.raw(char.encode_utf8(&mut [0; 4]));
        }
        if let Some(name) = greek_name(char) {
            self.raw("\\");
            self.raw(name);
            self.after_word = true;
            return;
        }
        match Sign::of(char) {
            Some(sign) => self.command(sign.latex),
            None => self.text(char.encode_utf8(&mut [0; 4])),
        }
    }

    fn identifier(&mut self, text: &str, style: Style) {
        let is_single = text.chars().nth(1).is_none();
        let font = match style {
            Style::Default if is_single => {
                return text.chars().for_each(|char| self.char(char));
            }
            Style::Default | Style::Upright => r"\mathrm",
            Style::Bold => r"\mathbf",
            Style::BoldItalic => r"\boldsymbol",
            Style::Script => r"\mathcal",
            Style::Double => r"\mathbb",
        };
        self.raw(font);
        self.raw("{");
        text.chars().for_each(|char| self.char(char));
        self.raw("}");
    }

    /// A decimal comma is kept from being spaced as punctuation.
    fn number(&mut self, digits: &str) {
        for char in digits.chars() {
            match char {
                ',' => self.raw("{,}"),
                '.' => self.raw("."),
                char => self.char(char),
            }
        }
    }

    fn operator(&mut self, text: &str, class: Class) {
        match (text, class) {
            ("|", Class::Opening) => self.command(r"\lvert"),
            ("|", Class::Closing) => self.command(r"\rvert"),
            ("‖", Class::Opening) => self.command(r"\lVert"),
            ("‖", Class::Closing) => self.command(r"\rVert"),
            (_, Class::Relation) => self.spaced(text),
            (_, Class::Binary) if matches!(text, "+" | "−" | "-" | "±" | "∓") => {
                self.spaced(text);
            }
            (_, Class::Punctuation) => {
                self.signs(text);
                self.raw(" ");
            }
            _ => self.signs(text),
        }
    }

    fn signs(&mut self, text: &str) {
        for char in text.chars() {
            self.char(if char == '-' { '−' } else { char });
        }
    }

    /// Blanks around a sign mean nothing in LaTeX and help who reads the source.
    fn spaced(&mut self, text: &str) {
        if !self.out.is_empty() && !self.out.ends_with([' ', '{', '$', '(']) {
            self.raw(" ");
        }
        self.signs(text);
        self.raw(" ");
    }

    fn function(&mut self, name: &str) {
        if FUNCTIONS.contains(&name) {
            self.raw("\\");
            self.raw(name);
            self.after_word = true;
            return;
        }
        self.raw(r"\operatorname{");
        name.chars()
            // Names come from files: nothing in them may be read as LaTeX.
            .filter(char::is_ascii_alphanumeric)
            .for_each(|char| self.out.push(char));
        self.raw("}");
    }

    fn text(&mut self, words: &str) {
        self.raw(r"\text{");
        escape_text(self.out, words);
        self.raw("}");
    }

    fn space(&mut self, width: i16) {
        match width {
            -3 => self.raw(r"\!"),
            3 => self.raw(r"\,"),
            4 => self.raw(r"\:"),
            5 => self.raw(r"\;"),
            6 => self.raw(r"\ "),
            18 => self.command(r"\quad"),
            36 => self.command(r"\qquad"),
            width => {
                self.raw(r"\mkern");
                self.raw(&width.to_string());
                self.raw("mu ");
            }
        }
    }

    fn root(&mut self, radicand: &Math, degree: Option<&Math>) {
        self.command(r"\sqrt");
        if let Some(degree) = degree {
            // In braces, since a bracket within the degree would close the option.
            self.raw("[{");
            self.math(degree);
            self.raw("}]");
        }
        self.group(radicand);
    }

    fn script(&mut self, base: &Math, sub: Option<&Math>, sup: Option<&Math>) {
        let holes = self.holes;
        let bearer = Bearer::of(base, sub, sup, holes);
        if bearer.needs_parentheses {
            self.raw(r"\left(");
            self.math(base);
            self.raw(r"\right)");
        } else {
            self.base(bearer.base);
        }
        if let Some(sub) = bearer.sub {
            self.raw("_");
            self.argument(sub);
        }
        let Some(sup) = bearer.sup else { return };
        let (primes, rest) = if is_token(bearer.base)
            && !matches!(bearer.base, Math::Number(_))
            && !is_prime(bearer.base)
        {
            leading_primes(sup)
        } else {
            (0, &[][..])
        };
        self.raw(&"'".repeat(primes));
        match rest {
            [] if primes > 0 => {}
            [] => {
                self.raw("^");
                self.argument(sup);
            }
            rest => {
                self.raw("^{");
                for piece in rest {
                    self.math(piece);
                }
                self.raw("}");
            }
        }
    }

    /// What bears scripts, braced unless it is one token or closes itself.
    fn base(&mut self, base: &Math) {
        if is_token(base) {
            self.math(base);
        } else {
            self.group(base);
        }
    }

    /// A script: one letter, one digit or one upright word stands without braces.
    fn argument(&mut self, script: &Math) {
        match script {
            Math::Identifier { text, .. }
                if text
                    .chars()
                    .all(|c| c.is_ascii_alphanumeric() || greek_name(c).is_some())
                    && !text.is_empty() =>
            {
                self.math(script);
            }
            Math::Number(digits) if digits.len() == 1 => self.math(script),
            Math::Operator { text, .. } if text == "∘" => self.math(script),
            _ => self.group(script),
        }
    }

    fn stack(&mut self, base: &Math, under: Option<&Math>, over: Option<&Math>) {
        match base {
            _ if over.is_none() && under.is_some_and(|mark| mark.is_sign("⏟")) => {
                self.command(r"\underbrace");
                self.group(base);
            }
            _ if under.is_none() && over.is_some_and(|mark| mark.is_sign("⏞")) => {
                self.command(r"\overbrace");
                self.group(base);
            }
            Math::Stack {
                under: mark,
                over: None,
                ..
            } if over.is_none() && mark.as_deref().is_some_and(|mark| mark.is_sign("⏟")) => {
                self.math(base);
                self.limits(under, None);
            }
            Math::Stack {
                over: mark,
                under: None,
                ..
            } if under.is_none() && mark.as_deref().is_some_and(|mark| mark.is_sign("⏞")) => {
                self.math(base);
                self.limits(None, over);
            }
            Math::Operator {
                class: Class::Large,
                ..
            } => {
                self.math(base);
                self.command(r"\limits");
                self.limits(under, over);
            }
            _ => self.set_around(base, under, over),
        }
    }

    fn limits(&mut self, under: Option<&Math>, over: Option<&Math>) {
        for (mark, limit) in [("_", under), ("^", over)] {
            if let Some(limit) = limit {
                self.raw(mark);
                self.group(limit);
            }
        }
    }

    fn set_around(&mut self, base: &Math, under: Option<&Math>, over: Option<&Math>) {
        if let Some(under) = under {
            self.command(r"\underset");
            self.group(under);
            self.raw("{");
        }
        match over {
            Some(over) => {
                self.command(r"\overset");
                self.group(over);
                self.group(base);
            }
            None => self.math(base),
        }
        if under.is_some() {
            self.raw("}");
        }
    }

    fn fence(&mut self, open: &str, close: &str, body: &Math, stretchy: bool) {
        if let Math::Table { rows, kind } = body {
            let environment = match (open, close, kind) {
                ("{", "", TableKind::Cases) => Some("cases"),
                ("(", ")", TableKind::Matrix) => Some("pmatrix"),
                ("[", "]", TableKind::Matrix) => Some("bmatrix"),
                ("{", "}", TableKind::Matrix) => Some("Bmatrix"),
                ("|", "|", TableKind::Matrix) => Some("vmatrix"),
                ("‖", "‖", TableKind::Matrix) => Some("Vmatrix"),
                _ => None,
            };
            if let Some(environment) = environment {
                return self.table(rows, environment);
            }
        }
        if let (
            "(",
            ")",
            true,
            Math::Fraction {
                numerator,
                denominator,
                bar: false,
                size: Size::Auto,
            },
        ) = (open, close, stretchy, body)
        {
            self.command(r"\binom");
            self.group(numerator);
            return self.group(denominator);
        }
        self.delimiter(if stretchy { r"\left" } else { "" }, open, true);
        self.math(body);
        self.delimiter(if stretchy { r"\right" } else { "" }, close, false);
    }

    fn delimiter(&mut self, size: &str, sign: &str, is_open: bool) {
        self.command(size);
        match (sign, is_open) {
            ("", _) if size.is_empty() => {}
            // `\left` needs a partner; a point draws none.
            ("", _) => self.raw("."),
            ("|", true) => self.command(r"\lvert"),
            ("|", false) => self.command(r"\rvert"),
            ("‖", true) => self.command(r"\lVert"),
            ("‖", false) => self.command(r"\rVert"),
            _ => self.signs(sign),
        }
    }

    fn table(&mut self, rows: &[Vec<Math>], environment: &str) {
        self.raw(r"\begin{");
        self.raw(environment);
        self.raw("}");
        for (number, row) in rows.iter().enumerate() {
            self.raw(if number == 0 { " " } else { r" \\ " });
            for (column, cell) in row.iter().enumerate() {
                if column > 0 {
                    self.raw(" & ");
                }
                let start = self.out.len();
                self.math(cell);
                // A bracket at the start of a line would be read as a length.
                if self.out[start..].starts_with('[') && column == 0 {
                    self.out.insert_str(start, "{}");
                }
            }
        }
        self.raw(r" \end{");
        self.raw(environment);
        self.raw("}");
    }
}

/// Whether scripts after a tree are borne by all of it without braces.
fn is_token(math: &Math) -> bool {
    match math {
        // The degree sign is a script itself.
        Math::Operator { text, .. } if text == "°" => false,
        Math::Identifier { .. }
        | Math::Function(_)
        | Math::Fence { stretchy: true, .. }
        | Math::Accent { .. }
        | Math::Operator {
            class: Class::Large | Class::Closing | Class::Ordinary,
            ..
        }
        | Math::Root { .. } => true,
        Math::Number(digits) => {
            digits.bytes().all(|b| b.is_ascii_digit() || b == b'.')
                && digits.starts_with(|c: char| c.is_ascii_digit())
                && digits.ends_with(|c: char| c.is_ascii_digit())
        }
        _ => false,
    }
}

fn is_prime(math: &Math) -> bool {
    matches!(math, Math::Operator { text, .. } if text == "′")
}

/// The number of primes at the start of a superscript, and what follows them.
fn leading_primes(sup: &Math) -> (usize, &[Math]) {
    match sup {
        Math::Row(pieces) => {
            let primes = pieces.iter().take_while(|piece| is_prime(piece)).count();
            match primes {
                0 => (0, &[]),
                primes => (primes, &pieces[primes..]),
            }
        }
        prime => (usize::from(is_prime(prime)), &[]),
    }
}

/// Appends words so that LaTeX sets them as they are.
pub(crate) fn escape_text(out: &mut String, words: &str) {
    for char in words.chars() {
        match char {
            '#' | '$' | '%' | '&' | '_' | '{' | '}' => {
                out.push('\\');
                out.push(char);
            }
            '\\' => out.push_str(r"\textbackslash{}"),
            '^' => out.push_str(r"\textasciicircum{}"),
            '~' => out.push_str(r"\textasciitilde{}"),
            '\u{a0}' => out.push('~'),
            char if char.is_control() => out.push(' '),
            char => out.push(char),
        }
    }
}
