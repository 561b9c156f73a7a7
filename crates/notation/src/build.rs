//! Short ways to make trees.

use super::{Accent, Class, Math, Size, Style, TableKind};

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
}
