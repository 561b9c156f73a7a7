//! What bears a script once holes are filled.

use super::{Holes, Math};

/// The base of a script, its scripts, and whether it needs parentheses.
pub(crate) struct Bearer<'a> {
    pub(crate) base: &'a Math,
    pub(crate) sub: Option<&'a Math>,
    pub(crate) sup: Option<&'a Math>,
    /// A filled base of several pieces: the square of `2 kg` is `(2 kg)²`.
    pub(crate) needs_parentheses: bool,
}

impl<'a> Bearer<'a> {
    /// Looks through a hole: `ω_n` filled into `□²` bears both scripts on its letter.
    pub(crate) fn of(
        base: &'a Math,
        sub: Option<&'a Math>,
        sup: Option<&'a Math>,
        holes: &'a dyn Holes,
    ) -> Self {
        let filled = base.filled(holes);
        match filled {
            Math::Script {
                base,
                sub: Some(own),
                sup: None,
            } if sub.is_none() => Self {
                base,
                sub: Some(own),
                sup,
                needs_parentheses: false,
            },
            Math::Script {
                base,
                sub: None,
                sup: Some(own),
            } if sup.is_none() => Self {
                base,
                sub,
                sup: Some(own),
                needs_parentheses: false,
            },
            _ => Self {
                base: filled,
                sub,
                sup,
                needs_parentheses: matches!(base, Math::Hole(_))
                    && matches!(
                        filled,
                        Math::Row(_) | Math::Fraction { .. } | Math::Script { .. }
                    ),
            },
        }
    }
}
