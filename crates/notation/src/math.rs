//! The tree of typeset mathematics, and short ways to make one.

use serde::Serialize;

use crate::{Accent, Class, Display, Empty, Holes, Size, Style, TableKind, Voice};
use crate::{latex, mathml, plain, spoken, typst, width};

/// One piece of typeset mathematics.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub enum Math {
    /// Pieces side by side.
    #[serde(rename = "r")]
    Row(Vec<Math>),
    /// A letter or word used as a symbol, `x`, `ω`, upright `eq`; Unicode, not LaTeX.
    #[serde(rename = "i")]
    Identifier {
        /// The letters.
        #[serde(rename = "t")]
        text: String,
        /// How they are set.
        #[serde(rename = "s", skip_serializing_if = "is_default")]
        style: Style,
    },
    /// A number as it is printed, `2.50` or `2,50`.
    #[serde(rename = "n")]
    Number(String),
    /// An operator or mark, as Unicode (`+`, `−`, `=`, `⋅`, `,`, `′`).
    #[serde(rename = "o")]
    Operator {
        /// The sign.
        #[serde(rename = "t")]
        text: String,
        /// How it is spaced.
        #[serde(rename = "c")]
        class: Class,
    },
    /// A named function, `sin`; set upright with the space of an operator.
    #[serde(rename = "f")]
    Function(String),
    /// Words inside a formula.
    #[serde(rename = "t")]
    Text(String),
    /// Horizontal space in eighteenths of an em; negative is allowed.
    #[serde(rename = "s")]
    Space(i16),
    /// A numerator over a denominator.
    #[serde(rename = "q")]
    Fraction {
        /// Above the bar.
        #[serde(rename = "n")]
        numerator: Box<Math>,
        /// Below the bar.
        #[serde(rename = "d")]
        denominator: Box<Math>,
        /// Whether there is a bar (a binomial has none).
        #[serde(rename = "b", skip_serializing_if = "Clone::clone")]
        bar: bool,
        /// Size of the parts.
        #[serde(rename = "s", skip_serializing_if = "is_default")]
        size: Size,
    },
    /// A root; without a degree, a square root.
    #[serde(rename = "v")]
    Root {
        /// What stands under it.
        #[serde(rename = "r")]
        radicand: Box<Math>,
        /// The `n` of an n-th root.
        #[serde(rename = "d", skip_serializing_if = "Option::is_none")]
        degree: Option<Box<Math>>,
    },
    /// Sub- and superscript at the side.
    #[serde(rename = "x")]
    Script {
        /// What bears the scripts.
        #[serde(rename = "b")]
        base: Box<Math>,
        /// Subscript.
        #[serde(rename = "d", skip_serializing_if = "Option::is_none")]
        sub: Option<Box<Math>>,
        /// Superscript.
        #[serde(rename = "u", skip_serializing_if = "Option::is_none")]
        sup: Option<Box<Math>>,
    },
    /// Below and above (limits, braces with a label).
    #[serde(rename = "u")]
    Stack {
        /// What is in the middle.
        #[serde(rename = "b")]
        base: Box<Math>,
        /// Below it.
        #[serde(rename = "d", skip_serializing_if = "Option::is_none")]
        under: Option<Box<Math>>,
        /// Above it.
        #[serde(rename = "u", skip_serializing_if = "Option::is_none")]
        over: Option<Box<Math>>,
    },
    /// An accent above a base.
    #[serde(rename = "a")]
    Accent {
        /// What bears the accent.
        #[serde(rename = "b")]
        base: Box<Math>,
        /// The mark above the base.
        #[serde(rename = "a")]
        accent: Accent,
    },
    /// Delimiters around a body; an empty string is no delimiter.
    #[serde(rename = "p")]
    Fence {
        /// Opening delimiter.
        #[serde(rename = "o")]
        open: String,
        /// Closing delimiter.
        #[serde(rename = "c")]
        close: String,
        /// What stands between.
        #[serde(rename = "b")]
        body: Box<Math>,
        /// Whether the delimiters grow with the body.
        #[serde(rename = "s")]
        stretchy: bool,
    },
    /// Rows and columns, without delimiters.
    #[serde(rename = "m")]
    Table {
        /// Cells by row.
        #[serde(rename = "r")]
        rows: Vec<Vec<Math>>,
        /// What the rows are: a matrix, cases, aligned equations.
        #[serde(rename = "k")]
        kind: TableKind,
    },
    /// A place to be filled with a value when a text is written.
    #[serde(rename = "h")]
    Hole(u32),
}

impl Math {
    /// Pieces side by side; a single piece stays itself.
    pub fn row(pieces: impl IntoIterator<Item = Math>) -> Self {
        let mut pieces: Vec<Math> = pieces.into_iter().collect();
        match pieces.pop() {
            Some(only) if pieces.is_empty() => only,
            last => {
                pieces.extend(last);
                Self::Row(pieces)
            }
        }
    }

    /// A letter in the style of its kind, `x`, `ω`, `Ω`.
    pub fn letter(letter: char) -> Self {
        Self::identifier(letter, Style::Default)
    }

    /// A letter or word in a style.
    pub fn identifier(text: impl Into<String>, style: Style) -> Self {
        Self::Identifier {
            text: text.into(),
            style,
        }
    }

    /// An upright word, `kg`, `eq`.
    pub fn upright(text: impl Into<String>) -> Self {
        Self::identifier(text, Style::Upright)
    }

    /// A number as it is printed.
    pub fn number(digits: impl Into<String>) -> Self {
        Self::Number(digits.into())
    }

    /// Words inside a formula.
    pub fn text(words: impl Into<String>) -> Self {
        Self::Text(words.into())
    }

    /// A named function without its argument, `sin`.
    pub fn function(name: impl Into<String>) -> Self {
        Self::Function(name.into())
    }

    /// An operator of a class.
    pub fn operator(sign: impl Into<String>, class: Class) -> Self {
        Self::Operator {
            text: sign.into(),
            class,
        }
    }

    /// An operator between two operands, `+`, `⋅`.
    pub fn binary(sign: impl Into<String>) -> Self {
        Self::operator(sign, Class::Binary)
    }

    /// A sign before its operand, `−`.
    pub fn prefix(sign: impl Into<String>) -> Self {
        Self::operator(sign, Class::Prefix)
    }

    /// A sign between two sides, `=`, `≤`, with the space of a relation.
    pub fn relation(sign: impl Into<String>) -> Self {
        Self::operator(sign, Class::Relation)
    }

    /// A comma or semicolon.
    pub fn punctuation(sign: impl Into<String>) -> Self {
        Self::operator(sign, Class::Punctuation)
    }

    /// A complex number, without its real part where that is zero.
    pub fn complex(real: Option<Math>, is_negative: bool, imaginary: Math) -> Self {
        let sign = if is_negative { "−" } else { "+" };
        let sign = match &real {
            Some(_) => Some(Self::binary(sign)),
            None => is_negative.then(|| Self::prefix(sign)),
        };
        let pieces = [real, sign, Some(imaginary), Some(Self::upright("i"))];
        Self::row(pieces.into_iter().flatten())
    }

    /// Whether it is this sign.
    pub(crate) fn is_sign(&self, sign: &str) -> bool {
        matches!(self, Self::Operator { text, .. } if text == sign)
    }

    /// Whether it is a brace below or above something.
    pub(crate) fn is_brace(&self) -> bool {
        self.is_sign("⏟") || self.is_sign("⏞")
    }

    /// A thin space, as between a number and its unit.
    pub fn thin_space() -> Self {
        Self::Space(3)
    }

    /// A fraction with a bar, sized by context.
    pub fn fraction(numerator: Math, denominator: Math) -> Self {
        Self::Fraction {
            numerator: Box::new(numerator),
            denominator: Box::new(denominator),
            bar: true,
            size: Size::Auto,
        }
    }

    /// A square root.
    pub fn root(radicand: Math) -> Self {
        Self::Root {
            radicand: Box::new(radicand),
            degree: None,
        }
    }

    /// The base with a subscript; a base that has a superscript alone keeps it.
    #[must_use]
    pub fn with_sub(self, sub: Math) -> Self {
        match self {
            Self::Script {
                base,
                sub: None,
                sup,
            } => Self::Script {
                base,
                sub: Some(Box::new(sub)),
                sup,
            },
            base => Self::Script {
                base: Box::new(base),
                sub: Some(Box::new(sub)),
                sup: None,
            },
        }
    }

    /// The base with a superscript; a base that has a subscript alone keeps it.
    #[must_use]
    pub fn with_sup(self, sup: Math) -> Self {
        match self {
            Self::Script {
                base,
                sub,
                sup: None,
            } => Self::Script {
                base,
                sub,
                sup: Some(Box::new(sup)),
            },
            base => Self::Script {
                base: Box::new(base),
                sub: None,
                sup: Some(Box::new(sup)),
            },
        }
    }

    /// With an accent over the letter, inside its subscript: the dot of `ẋ₁` stands over `x`.
    #[must_use]
    pub fn with_accent(self, accent: Accent) -> Self {
        match self {
            Self::Script { base, sub, sup } => Self::Script {
                base: Box::new(base.with_accent(accent)),
                sub,
                sup,
            },
            base => Self::Accent {
                base: Box::new(base),
                accent,
            },
        }
    }

    /// The time derivative of a symbol: one to three dots over its letter, primes beyond.
    #[must_use]
    pub fn derivative(self, order: u32) -> Self {
        match order {
            0 => self,
            1 => self.with_accent(Accent::Dot),
            2 => self.with_accent(Accent::DoubleDot),
            3 => self.with_accent(Accent::TripleDot),
            n => self.with_sup(Self::row([
                Self::operator("(", Class::Opening),
                Self::number(n.to_string()),
                Self::operator(")", Class::Closing),
            ])),
        }
    }

    /// In delimiters that grow with what they hold.
    #[must_use]
    pub fn fenced(self, open: impl Into<String>, close: impl Into<String>) -> Self {
        Self::Fence {
            open: open.into(),
            close: close.into(),
            body: Box::new(self),
            stretchy: true,
        }
    }

    /// In parentheses that do not grow.
    #[must_use]
    pub fn in_parentheses(self) -> Self {
        Self::Fence {
            open: "(".into(),
            close: ")".into(),
            body: Box::new(self),
            stretchy: false,
        }
    }

    /// A matrix in parentheses, by rows.
    pub fn matrix(rows: Vec<Vec<Math>>) -> Self {
        Self::Table {
            rows,
            kind: TableKind::Matrix,
        }
        .fenced("(", ")")
    }

    /// Values and their conditions, after a brace.
    pub fn cases(rows: Vec<Vec<Math>>) -> Self {
        Self::Table {
            rows,
            kind: TableKind::Cases,
        }
        .fenced("{", "")
    }

    /// Lines aligned at the starts of their even columns.
    pub fn aligned(rows: Vec<Vec<Math>>) -> Self {
        Self::Table {
            rows,
            kind: TableKind::Aligned,
        }
    }

    /// As LaTeX source, without dollar signs.
    pub fn latex(&self) -> String {
        let mut out = String::new();
        self.write_latex(&mut out, &Empty);
        out
    }

    /// Appends LaTeX source, without dollar signs.
    pub fn write_latex(&self, out: &mut String, holes: &dyn Holes) {
        latex::write(self, out, holes);
    }

    /// As a `math` element.
    pub fn mathml(&self, display: Display, voice: &'static Voice) -> String {
        let mut out = String::new();
        self.write_mathml(&mut out, display, &Empty, voice);
        out
    }

    /// Appends a `math` element with its words as `alttext`.
    pub fn write_mathml(
        &self,
        out: &mut String,
        display: Display,
        holes: &dyn Holes,
        voice: &'static Voice,
    ) {
        mathml::write(self, out, display, holes, voice);
    }

    /// As Typst markup that sets the formula, for a file that begins with [`TYPST_PRELUDE`](crate::TYPST_PRELUDE).
    pub fn typst(&self, display: Display, voice: &'static Voice) -> String {
        let mut out = String::new();
        self.write_typst(&mut out, display, &Empty, voice);
        out
    }

    /// Appends Typst markup that sets the formula.
    pub fn write_typst(
        &self,
        out: &mut String,
        display: Display,
        holes: &dyn Holes,
        voice: &'static Voice,
    ) {
        typst::write(self, out, display, holes, voice);
    }

    /// As a line of Unicode text: `ωₙ = √(k/m)`, `ω_d` where there is no such letter.
    pub fn plain(&self) -> String {
        let mut out = String::new();
        self.write_plain(&mut out, &Empty);
        out
    }

    /// Appends a line of Unicode text.
    pub fn write_plain(&self, out: &mut String, holes: &dyn Holes) {
        plain::write(self, out, holes);
    }

    /// As words: `omega sub n equals the square root of k over m end root`.
    pub fn spoken(&self, voice: &'static Voice) -> String {
        let mut out = String::new();
        spoken::write(self, &mut out, &Empty, voice);
        out
    }

    /// The width in em, rather too large than too small.
    pub fn width(&self, holes: &dyn Holes) -> f64 {
        width::of(self, holes)
    }

    /// This tree, or what fills it if it is a hole.
    pub fn filled<'a>(&'a self, holes: &'a dyn Holes) -> &'a Self {
        match self {
            Self::Hole(hole) => holes.filling(*hole).unwrap_or(self),
            tree => tree,
        }
    }

    /// The formula cut before each sign between its terms, so that it can go on in another line there;
    /// side by side the pieces are the formula.
    ///
    /// ```
    /// use vibank_notation::Math;
    ///
    /// let sum = Math::row([Math::letter('a'), Math::binary("+"), Math::letter('b')]);
    /// let pieces = sum.terms();
    /// assert_eq!(pieces.len(), 2);
    /// assert_eq!(pieces[1].plain(), "+ b");
    /// ```
    pub fn terms(&self) -> Vec<Math> {
        let Math::Row(row) = self else {
            return vec![self.clone()];
        };
        let mut terms = Vec::new();
        let mut term = Vec::new();
        for piece in row {
            if is_sign(piece) && !term.is_empty() {
                terms.push(Math::Row(std::mem::take(&mut term)));
            }
            term.push(piece.clone());
        }
        terms.push(Math::Row(term));
        terms
    }

    /// Numbers all holes `offset` higher.
    pub fn shift_holes(&mut self, offset: u32) {
        self.for_each_child(&mut |child| child.shift_holes(offset));
        if let Self::Hole(hole) = self {
            *hole += offset;
        }
    }

    /// Puts the words within a formula in another way; those for which `say` has none stay.
    ///
    /// ```
    /// use vibank_notation::Math;
    ///
    /// let mut range = Math::Row(vec![Math::number("1"), Math::text(" to "), Math::number("2")]);
    /// range.reword(&|word| (word == " to ").then_some(" à "));
    /// assert_eq!(range.plain(), "1 à 2");
    /// ```
    pub fn reword(&mut self, say: &dyn Fn(&str) -> Option<&'static str>) {
        self.for_each_child(&mut |child| child.reword(say));
        if let Self::Text(text) = self
            && let Some(said) = say(text)
        {
            said.clone_into(text);
        }
    }

    /// Writes the decimals within a formula with another sign.
    ///
    /// ```
    /// use vibank_notation::Math;
    ///
    /// let mut half = Math::row([Math::number("0.5"), Math::letter('k')]);
    /// half.set_decimal_sign(",");
    /// assert_eq!(half.latex(), "0{,}5k");
    /// ```
    pub fn set_decimal_sign(&mut self, sign: &str) {
        self.for_each_child(&mut |child| child.set_decimal_sign(sign));
        if let Self::Number(digits) = self
            && digits.contains('.')
        {
            *digits = digits.replace('.', sign);
        }
    }

    /// Visits the trees right below this one.
    fn for_each_child(&mut self, visit: &mut dyn FnMut(&mut Math)) {
        match self {
            Self::Row(pieces) => pieces.iter_mut().for_each(visit),
            Self::Fraction {
                numerator,
                denominator,
                ..
            } => {
                visit(numerator);
                visit(denominator);
            }
            Self::Root { radicand, degree } => {
                visit(radicand);
                if let Some(degree) = degree {
                    visit(degree);
                }
            }
            Self::Script { base, sub, sup } => {
                visit(base);
                for script in sub.iter_mut().chain(sup) {
                    visit(script);
                }
            }
            Self::Stack { base, under, over } => {
                visit(base);
                for mark in under.iter_mut().chain(over) {
                    visit(mark);
                }
            }
            Self::Accent { base, .. } | Self::Fence { body: base, .. } => visit(base),
            Self::Table { rows, .. } => rows.iter_mut().flatten().for_each(visit),
            Self::Identifier { .. }
            | Self::Number(_)
            | Self::Operator { .. }
            | Self::Function(_)
            | Self::Text(_)
            | Self::Space(_)
            | Self::Hole(_) => {}
        }
    }
}

fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

fn is_sign(piece: &Math) -> bool {
    let Math::Operator { text, class } = piece else {
        return false;
    };
    *class == Class::Binary && matches!(text.as_str(), "+" | "−" | "-" | "±" | "∓")
}
