//! How pieces of a row are spaced: the atoms of TeX.

use super::{Class, Holes, Math};

/// What a piece is to its neighbours in a row.
///
/// # References
///
/// D. E. Knuth, *The TeXbook*, chapter 18 and appendix G, rule 20.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Atom {
    /// The start of a row.
    Edge,
    /// A symbol or number.
    Ordinary,
    /// A named function or large operator.
    Operator,
    /// Between two operands.
    Binary,
    /// Between two sides.
    Relation,
    /// An opening delimiter.
    Opening,
    /// A closing delimiter.
    Closing,
    /// A comma.
    Punctuation,
    /// A fraction.
    Inner,
    /// A space, after which nothing is added.
    Space,
}

impl Atom {
    /// The atom that a tree is as a whole, with its holes filled; `None` for a row, which is several.
    pub(crate) fn of(math: &Math, holes: &dyn Holes) -> Option<Self> {
        Some(match math {
            Math::Row(_) => return None,
            Math::Hole(hole) => match holes.filling(*hole) {
                Some(Math::Hole(_)) | None => Self::Ordinary,
                Some(filling) => return Self::of(filling, &super::Empty),
            },
            Math::Operator { class, .. } => Self::of_class(*class),
            Math::Function(_) => Self::Operator,
            Math::Fraction { .. } => Self::Inner,
            Math::Space(_) => Self::Space,
            Math::Script { base, .. } | Math::Stack { base, .. } => {
                Self::of(base, holes).unwrap_or(Self::Ordinary)
            }
            _ => Self::Ordinary,
        })
    }

    fn of_class(class: Class) -> Self {
        match class {
            Class::Binary => Self::Binary,
            Class::Relation => Self::Relation,
            Class::Punctuation => Self::Punctuation,
            Class::Opening => Self::Opening,
            Class::Closing => Self::Closing,
            Class::Prefix | Class::Ordinary => Self::Ordinary,
            Class::Large => Self::Operator,
        }
    }

    /// Whether a sign that follows is the sign of an operand, as in `= −k`.
    #[cfg(feature = "latex")]
    pub(crate) fn makes_sign_unary(self) -> bool {
        matches!(
            self,
            Self::Edge
                | Self::Operator
                | Self::Binary
                | Self::Relation
                | Self::Opening
                | Self::Punctuation
        )
    }

    /// Whether a thin space stands between this and the next atom, outside scripts.
    ///
    /// Binary operators, relations and punctuation bring their own space.
    pub(crate) fn is_thinly_spaced_from(self, next: Self) -> bool {
        let is_operand = matches!(
            self,
            Self::Ordinary | Self::Closing | Self::Operator | Self::Inner
        );
        match next {
            Self::Operator | Self::Inner => is_operand,
            Self::Ordinary => matches!(self, Self::Operator | Self::Inner),
            Self::Opening => self == Self::Inner,
            _ => false,
        }
    }
}
