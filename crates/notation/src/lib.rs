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
mod json;
mod latex;
mod math;
mod mathml;
mod plain;
#[cfg(feature = "latex")]
mod read;
mod script;
mod sign;
mod spoken;
mod style;
mod symbol;
mod typst;
mod voice;
mod width;

pub(crate) use atom::Atom;
pub use math::Math;
pub use mathml::{Display, STYLE as MATHML_STYLE, escape, write_line as write_mathml_line};
#[cfg(feature = "latex")]
pub use read::{LatexError, faults, holes, read_all, read_latex};
pub use sign::{GREEK, SIGNS, Sign, greek_name};
pub use style::{Accent, Class, Size, Style, TableKind};
pub use symbol::symbol;
pub use typst::PRELUDE as TYPST_PRELUDE;
pub use typst::quote;
pub use voice::{UnitName, Voice};

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
