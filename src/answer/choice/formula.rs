//! Options that are formulas, compared as such: `q^2/(2C)`, `0.5 q²/C`.

use crate::expr::{Expr, Normal, Relation};
use crate::response::{Manner, Passage};

/// A formula, or a comparison of formulas, in letters that mean nothing.
pub(crate) struct Formula {
    sides: Vec<Normal>,
    relations: Vec<Relation>,
}

impl Formula {
    /// The formula that a passage is; nothing for words and for a letter alone.
    pub(crate) fn of(typed: Passage<'_>) -> Option<Self> {
        let lexicon = typed.free_letters()?;
        let normal = |side: &Expr| Normal::of(side).ok();
        let (sides, relations) = match typed.chain(&lexicon, Manner::REAL) {
            Ok(chain) => (chain.value.sides, chain.value.relations),
            Err(_) => {
                let formula = typed.formula(&lexicon, Manner::REAL).ok()?.value;
                (vec![formula], Vec::new())
            }
        };
        Some(Self {
            sides: sides.iter().map(normal).collect::<Option<_>>()?,
            relations,
        })
    }

    /// Whether both are the same for all values of their letters.
    pub(crate) fn is(&self, other: &Self) -> bool {
        let mut pairs = self.sides.iter().zip(&other.sides);
        self.relations == other.relations
            && self.sides.len() == other.sides.len()
            && pairs.all(|(own, other)| own.is_equal(other) == Ok(true))
    }
}

#[cfg(test)]
mod tests {
    use super::Formula;
    use crate::response::Phrase;

    fn of_printed(text: &str) -> Option<Formula> {
        Formula::of(Phrase::of_printed(text).passage())
    }

    #[test]
    fn a_formula_is_one_however_it_is_written() {
        let is = |typed: &str, printed: &str| {
            let (Some(typed), Some(printed)) = (of_printed(typed), of_printed(printed)) else {
                return false;
            };
            typed.is(&printed)
        };
        for (typed, printed) in [
            ("q^2/(2C)", "q²/(2 C)"),
            ("\\frac{q^2}{2C}", "q²/(2 C)"),
            ("0.5 q^2/C", "q²/(2 C)"),
            ("L*i**2/2", "1/2 L i²"),
            ("½ L i²", "1/2 L i²"),
            ("omega_0 - 1", "ω₀ − 1"),
            ("\\zeta < 1", "ζ < 1"),
        ] {
            assert!(is(typed, printed), "{typed}");
        }
        for (typed, printed) in [
            ("q^2/2", "q²/(2 C)"),
            ("q^2/C", "q²/(2 C)"),
            ("R i^2", "1/2 L i²"),
            ("zeta > 1", "ζ < 1"),
        ] {
            assert!(!is(typed, printed), "{typed}");
        }
        assert!(of_printed("overdamped").is_none());
        assert!(of_printed("the resistance R = 2").is_none());
    }
}
