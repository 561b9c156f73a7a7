//! Typeset mathematics as a tree, and its writers.
//!
//! Formulas, units and texts all produce [`Math`]; each output format has one writer over it
//! (MathML, LaTeX, Typst, plain text, spoken words). The *reader* of LaTeX belongs to the
//! feature `latex`, so that the grader in the browser needs no parser.
//! A tree may have [`Math::Hole`]s, which are filled with values when a text is written.
//!
//! # Examples
//!
//! ```
//! use vibank_notation::{Math, Voice, symbol};
//!
//! let law = Math::row([
//!     symbol("omega_n"),
//!     Math::relation("="),
//!     Math::root(Math::fraction(symbol("k"), symbol("m"))),
//! ]);
//! assert_eq!(law.latex(), r"\omega_n = \sqrt{\frac{k}{m}}");
//! assert_eq!(law.plain(), "ωₙ = √(k/m)");
//! assert_eq!(law.spoken(Voice::ENGLISH), "omega sub n equals the square root of k over m end root");
//! ```

mod alphabet;
mod atom;
mod build;
mod json;
mod latex;
mod mathml;
mod plain;
#[cfg(feature = "latex")]
mod read;
mod script;
mod sign;
mod spoken;
mod symbol;
mod terms;
mod typst;
mod voice;
mod width;

pub(crate) use atom::Atom;
pub use mathml::escape;
pub use mathml::{Display, STYLE as MATHML_STYLE};
#[cfg(feature = "latex")]
pub use read::{LatexError, faults, holes, read_all, read_latex};
pub use sign::{GREEK, SIGNS, Sign, greek_name};
pub use symbol::symbol;
pub use typst::PRELUDE as TYPST_PRELUDE;
pub use typst::quote;
pub use voice::Voice;

use serde::Serialize;

/// Whether a character leaves no ink: marks of direction, of byte order, and others without width.
///
/// In the words of others they reverse what follows, or stop a typesetter whose fonts do not have them.
pub fn is_invisible(char: char) -> bool {
    matches!(
        char,
        '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}'
            | '\u{2060}' | '\u{2066}'..='\u{206f}' | '\u{fe00}'..='\u{fe0f}' | '\u{feff}'
            | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e0fff}'
    )
}

/// What stands in the holes of a tree.
///
/// A filling has no holes of its own: one that it has anyway stays empty.
pub trait Holes {
    /// The filling of a hole, if there is one.
    fn filling(&self, hole: u32) -> Option<&Math>;
}

/// No hole is filled; each is written as an empty box.
pub struct Empty;

impl Holes for Empty {
    fn filling(&self, _: u32) -> Option<&Math> {
        None
    }
}

/// Hole `n` is filled with the `n`-th tree.
impl Holes for [Math] {
    fn filling(&self, hole: u32) -> Option<&Math> {
        self.get(hole as usize)
    }
}

/// Hole `n` is filled with the `n`-th tree.
impl Holes for Vec<Math> {
    fn filling(&self, hole: u32) -> Option<&Math> {
        self.get(hole as usize)
    }
}

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

fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

impl Math {
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

/// How a symbol is set.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Style {
    /// Italic for a single letter, upright for capital Greek, as in LaTeX.
    #[default]
    Default,
    /// Upright (`\mathrm`).
    Upright,
    /// Upright bold (`\mathbf`).
    Bold,
    /// Italic bold (`\boldsymbol`).
    BoldItalic,
    /// Script (`\mathcal`).
    Script,
    /// Double-struck (`\mathbb`).
    Double,
}

/// How an operator is spaced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// `+`, `−`, `⋅` between two operands.
    Binary,
    /// A sign before an operand.
    Prefix,
    /// `=`, `<`, `→`.
    Relation,
    /// `,`, `;`.
    Punctuation,
    /// A delimiter that opens and does not grow.
    Opening,
    /// A delimiter that closes and does not grow.
    Closing,
    /// A mark without space, `!`, `′`, `/`, `∞`.
    Ordinary,
    /// `∑`, `∫`.
    Large,
}

/// Size of the parts of a fraction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Size {
    /// By context (`\frac`).
    #[default]
    Auto,
    /// Full size (`\dfrac`).
    Display,
    /// Small (`\tfrac`).
    Text,
}

/// What stands above a letter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Accent {
    /// First time derivative.
    Dot,
    /// Second time derivative.
    DoubleDot,
    /// Third time derivative.
    TripleDot,
    /// `\hat`: a circumflex over the base.
    Hat,
    /// `\tilde`: a swung dash over the base.
    Tilde,
    /// `\bar`, `\overline`: grows with its base.
    Bar,
    /// `\vec`: grows with its base.
    Vector,
}

/// What a table is for, which fixes its alignment and spacing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TableKind {
    /// Centred cells.
    Matrix,
    /// Value and condition, left-aligned.
    Cases,
    /// Pairs of right- and left-aligned columns (`aligned`).
    Aligned,
}
