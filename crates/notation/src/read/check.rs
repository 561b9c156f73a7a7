//! A formula looked over before it is parsed: every finding with its place, and nothing left that
//! the parser could choke on.

use super::LatexError;
use super::holes::{LITERAL, hole};
use crate::latex::FUNCTIONS;
use crate::{GREEK, SIGNS, Sign, greek_name};
use vibank_source::{Span, nearest};

/// The longest formula that is read, in bytes.
const LENGTH: usize = 8192;
/// How many braces, environments and delimiters may stand in each other.
const DEPTH: usize = 24;
/// How many commands may take each other as arguments without braces, as in `\sqrt\sqrt2`.
const CHAIN: usize = 8;

/// Commands other than signs, letters and functions.
const COMMANDS: &[&str] = &[
    "frac",
    "dfrac",
    "tfrac",
    "binom",
    "sqrt",
    "text",
    "mathrm",
    "mathbf",
    "boldsymbol",
    "bm",
    "mathcal",
    "mathbb",
    "operatorname",
    "left",
    "right",
    "bigl",
    "bigr",
    "Bigl",
    "Bigr",
    "biggl",
    "biggr",
    "big",
    "Big",
    "begin",
    "end",
    "dot",
    "ddot",
    "dddot",
    "hat",
    "widehat",
    "tilde",
    "widetilde",
    "bar",
    "overline",
    "vec",
    "overrightarrow",
    "overset",
    "underset",
    "stackrel",
    "underbrace",
    "overbrace",
    "xrightarrow",
    "xleftarrow",
    "limits",
    "nolimits",
    "quad",
    "qquad",
    "enspace",
    "thinspace",
    "mkern",
    "qty",
];

/// Second names of signs.
const ALIASES: &[&str] = &[
    "degree",
    "leq",
    "geq",
    "neq",
    "lt",
    "gt",
    "rightarrow",
    "gets",
    "dots",
    "dotsb",
    "dotsc",
    "land",
    "lor",
    "lnot",
    "ast",
    "lvert",
    "rvert",
    "lVert",
    "rVert",
    "vert",
    "Vert",
    "lbrace",
    "rbrace",
    "lbrack",
    "rbrack",
    "exp",
];

/// Commands of one character other than a letter.
const SYMBOLS: &str = ",:;!> {}|%&#$_\\";

const ENVIRONMENTS: &[&str] = &[
    "matrix", "pmatrix", "bmatrix", "Bmatrix", "vmatrix", "Vmatrix", "cases", "dcases", "aligned",
    "align", "align*", "split",
];

/// Commands after which an argument is due.
const TAKES_ARGUMENT: &[&str] = &[
    "frac",
    "dfrac",
    "tfrac",
    "binom",
    "sqrt",
    "mathrm",
    "mathbf",
    "boldsymbol",
    "bm",
    "mathcal",
    "mathbb",
    "dot",
    "ddot",
    "dddot",
    "hat",
    "widehat",
    "tilde",
    "widetilde",
    "bar",
    "overline",
    "vec",
    "overrightarrow",
    "overset",
    "underset",
    "stackrel",
    "underbrace",
    "overbrace",
    "xrightarrow",
    "xleftarrow",
    "limits",
    "nolimits",
];

/// A brace, environment or delimiter that has begun and not yet ended.
#[derive(Clone, Copy, PartialEq)]
enum Open<'a> {
    Brace,
    /// The degree of a root.
    Degree,
    /// The number of `\qty{number}{unit}`.
    Quantity,
    Left,
    Environment(&'a str),
}

/// What is wrong with a formula before it is parsed: unknown commands, braces that do not match.
pub fn faults(latex: &str) -> Vec<LatexError> {
    Checked::of(latex).errors
}

/// A formula that holds nothing unknown and is balanced.
pub(crate) struct Checked {
    /// As the parser takes it.
    pub(crate) source: String,
    pub(crate) errors: Vec<LatexError>,
}

impl Checked {
    /// Looks over a formula.
    pub(crate) fn of(source: &str) -> Self {
        if source.len() > LENGTH {
            let error = LatexError::TooLong {
                length: source.len(),
                limit: LENGTH,
                span: Span::new(0, source.len()),
            };
            return Self {
                source: String::new(),
                errors: vec![error],
            };
        }
        let mut checker = LatexChecker {
            source,
            at: 0,
            out: String::with_capacity(source.len() + 16),
            open: Vec::new(),
            chain: 0,
            errors: Vec::new(),
        };
        checker.run();
        Self {
            source: checker.out,
            errors: checker.errors,
        }
    }
}

struct LatexChecker<'a> {
    source: &'a str,
    at: usize,
    out: String,
    open: Vec<(Open<'a>, Span)>,
    chain: usize,
    errors: Vec<LatexError>,
}

impl<'a> LatexChecker<'a> {
    fn run(&mut self) {
        while let Some(char) = self.source[self.at..].chars().next() {
            let start = self.at;
            self.at += char.len_utf8();
            match char {
                '\\' => self.command(start),
                '{' => self.open(Open::Brace, start, "{"),
                '}' => self.close_brace(start),
                ']' if self.innermost() == Some(Open::Degree) => {
                    self.open.pop();
                    self.out.push_str("}]");
                }
                '&' if !self.in_environment() => self.stray(char, start),
                char if Self::is_known(char) => self.out.push(char),
                char => self.stray(char, start),
            }
            if !matches!(char, '\\' | ' ') {
                self.chain = 0;
            }
        }
        while let Some((open, span)) = self.open.pop() {
            let sign = match open {
                Open::Brace | Open::Quantity => "{",
                Open::Degree => "[",
                Open::Left => r"\left",
                Open::Environment(_) => r"\begin",
            };
            self.unbalanced(sign, span);
        }
    }

    fn is_known(char: char) -> bool {
        char.is_ascii_alphanumeric()
            || matches!(
                char,
                ' ' | '\n'
                    | '\r'
                    | '\t'
                    | '^'
                    | '_'
                    | '\''
                    | '&'
                    | '~'
                    | '-'
                    | '*'
                    | '·'
                    | '∥'
                    | 'µ'
            )
            || hole(char).is_some()
            || char == LITERAL
            || greek_name(char).is_some()
            || !"%#$".contains(char) && Sign::of(char).is_some()
    }

    fn span(&self, start: usize) -> Span {
        Span::new(start, self.at)
    }

    fn stray(&mut self, char: char, start: usize) {
        let span = self.span(start);
        self.errors.push(LatexError::StrayCharacter { char, span });
    }

    fn unbalanced(&mut self, sign: &str, span: Span) {
        self.errors.push(LatexError::Unbalanced {
            sign: sign.to_owned(),
            span,
        });
    }

    fn innermost(&self) -> Option<Open<'a>> {
        self.open.last().map(|(open, _)| *open)
    }

    /// Whether cells may be parted here.
    fn in_environment(&self) -> bool {
        matches!(self.innermost(), Some(Open::Environment(_)))
    }

    fn open(&mut self, open: Open<'a>, start: usize, written: &str) {
        if self.open.len() == DEPTH {
            let span = self.span(start);
            self.errors.push(LatexError::TooDeep { span });
        }
        self.open.push((open, self.span(start)));
        self.out.push_str(written);
    }

    fn close_brace(&mut self, start: usize) {
        match self.innermost() {
            Some(Open::Brace) => {
                self.open.pop();
                self.out.push('}');
            }
            Some(Open::Quantity) => {
                self.open.pop();
                self.out.push_str(r"}\,\mathrm");
            }
            _ => self.unbalanced("}", self.span(start)),
        }
    }

    /// A command, whose backslash has been taken.
    fn command(&mut self, start: usize) {
        let rest = &self.source[self.at..];
        let letters = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
        if letters == 0 {
            return self.symbol(start);
        }
        let name = &rest[..letters];
        self.at += letters;
        self.chain = if TAKES_ARGUMENT.contains(&name) {
            self.chain + 1
        } else {
            0
        };
        if self.chain > CHAIN {
            let span = self.span(start);
            self.errors.push(LatexError::TooDeep { span });
            return;
        }
        match name {
            "text" => self.text(start),
            "operatorname" => self.operator_name(start),
            "begin" | "end" => self.environment(name, start),
            "left" => self.open(Open::Left, start, r"\left"),
            "right" => self.close_right(start),
            "sqrt" => self.root(start),
            "qty" => self.quantity(start),
            "dddot" => self.out.push_str(r"\overset{\ldots}"),
            "bm" => self.out.push_str(r"\boldsymbol"),
            _ if commands().any(|command| command == name) => {
                self.out.push('\\');
                self.out.push_str(name);
            }
            _ => self.unknown(name, start),
        }
    }

    fn unknown(&mut self, name: &str, start: usize) {
        self.errors.push(LatexError::UnknownCommand {
            name: name.to_owned(),
            nearest: nearest(name, commands()),
            span: self.span(start),
        });
    }

    /// A backslash before something that is not a letter.
    fn symbol(&mut self, start: usize) {
        let Some(char) = self.source[self.at..].chars().next() else {
            return self.stray('\\', start);
        };
        self.at += char.len_utf8();
        match char {
            '\\' if !self.in_environment() => self.stray('\\', start),
            '(' | ')' | '[' | ']' => {
                let span = self.span(start);
                self.errors
                    .push(LatexError::BracketMath { sign: char, span });
            }
            '\n' | '\t' => self.out.push_str(r"\ "),
            '\\' => {
                self.out.push_str(r"\\");
                // After a blank a bracket begins the next line and is not a length.
                let rest = &self.source[self.at..];
                if rest.starts_with(char::is_whitespace) && rest.trim_start().starts_with('[') {
                    self.out.push_str("{}");
                }
            }
            char if SYMBOLS.contains(char) => {
                self.out.push('\\');
                self.out.push(char);
            }
            char => self.unknown(char.encode_utf8(&mut [0; 4]), start),
        }
    }

    /// Takes a brace after blanks.
    fn take_brace(&mut self) -> bool {
        let rest = &self.source[self.at..];
        let blanks = rest.len() - rest.trim_start().len();
        let found = rest[blanks..].starts_with('{');
        if found {
            self.at += blanks + 1;
        }
        found
    }

    /// Words, up to the brace that closes them.
    fn text(&mut self, start: usize) {
        if !self.take_brace() {
            return self.unbalanced(r"\text", self.span(start));
        }
        self.out.push_str(r"\text{");
        let mut depth = 0_usize;
        while let Some(char) = self.source[self.at..].chars().next() {
            let at = self.at;
            self.at += char.len_utf8();
            match char {
                '\\' => self.text_command(at),
                '}' if depth == 0 => {
                    self.out.push('}');
                    return;
                }
                '{' => depth += 1,
                '}' => depth -= 1,
                '$' if matches!(self.errors.last(), Some(LatexError::MathInText { .. })) => {}
                '$' => {
                    let span = self.span(at);
                    self.errors.push(LatexError::MathInText { span });
                }
                '%' | '#' | '&' => self.stray(char, at),
                '_' | '^' => self.out.extend(['\\', char]),
                char => self.out.push(char),
            }
        }
        // A dollar sign in the words ends the formula of a line in the midst of them.
        let span = self.span(start);
        self.errors.push(LatexError::MathInText { span });
    }

    /// A command in words: an escaped character.
    fn text_command(&mut self, start: usize) {
        const WORDS: &[&str] = &["textbackslash{}", "textasciicircum{}", "textasciitilde{}"];
        let rest = &self.source[self.at..];
        if let Some(word) = WORDS.iter().find(|word| rest.starts_with(**word)) {
            self.at += word.len();
            self.out.push('\\');
            self.out.push_str(word);
            return;
        }
        match rest.chars().next() {
            Some(char) if "#$%&_{} ".contains(char) => {
                self.at += 1;
                self.out.extend(['\\', char]);
            }
            _ => {
                let letters = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
                self.at += letters;
                let name = &rest[..letters];
                self.unknown(name, start);
            }
        }
    }

    fn operator_name(&mut self, start: usize) {
        let name = self
            .take_brace()
            .then(|| self.source[self.at..].split_once('}'))
            .flatten()
            .map(|(name, _)| name);
        match name {
            Some(name) if !name.is_empty() && name.bytes().all(|b| b.is_ascii_alphanumeric()) => {
                self.at += name.len() + 1;
                self.out.push_str(r"\operatorname{");
                self.out.push_str(name);
                self.out.push('}');
            }
            _ => self.unbalanced(r"\operatorname", self.span(start)),
        }
    }

    fn environment(&mut self, command: &str, start: usize) {
        let name = self
            .take_brace()
            .then(|| self.source[self.at..].split_once('}'))
            .flatten()
            .map(|(name, _)| name);
        let Some(name) = name else {
            return self.unbalanced(command, self.span(start));
        };
        self.at += name.len() + 1;
        if !ENVIRONMENTS.contains(&name) {
            self.errors.push(LatexError::UnknownEnvironment {
                name: name.chars().take(80).collect(),
                span: self.span(start),
            });
            return;
        }
        let written = format!(r"\{command}{{{name}}}");
        if command == "begin" {
            return self.open(Open::Environment(name), start, &written);
        }
        if self.innermost() != Some(Open::Environment(name)) {
            return self.unbalanced(&written, self.span(start));
        }
        self.open.pop();
        self.out.push_str(&written);
    }

    fn close_right(&mut self, start: usize) {
        if self.innermost() != Some(Open::Left) {
            return self.unbalanced(r"\right", self.span(start));
        }
        self.open.pop();
        self.out.push_str(r"\right");
    }

    /// The degree of a root is put in braces, else the parser takes its first letter alone.
    fn root(&mut self, start: usize) {
        self.out.push_str(r"\sqrt");
        let rest = &self.source[self.at..];
        let blanks = rest.len() - rest.trim_start().len();
        if rest[blanks..].starts_with('[') {
            self.at += blanks + 1;
            self.open(Open::Degree, start, "[{");
        }
    }

    fn quantity(&mut self, start: usize) {
        if !self.take_brace() {
            return self.unbalanced(r"\qty", self.span(start));
        }
        self.open(Open::Quantity, start, "{");
    }
}

/// All commands made of letters.
fn commands() -> impl Iterator<Item = &'static str> {
    let signs = SIGNS
        .iter()
        .filter_map(|sign| sign.latex.strip_prefix('\\'))
        .filter(|name| name.bytes().all(|b| b.is_ascii_alphabetic()));
    COMMANDS
        .iter()
        .chain(FUNCTIONS)
        .chain(ALIASES)
        .copied()
        .chain(GREEK.iter().map(|(name, _)| *name))
        .chain(signs)
}
