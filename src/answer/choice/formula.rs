//! Options that are formulas, compared as such: `q^2/(2C)`, `0.5 q²/C`.

use crate::expr::{Expr, Name, Normal, Relation};
use crate::math::symbol;
use crate::response::{self, Folded, Lexicon, Manner};

/// A formula, or a comparison of formulas, in letters that mean nothing.
pub(crate) struct Formula {
    sides: Vec<Normal>,
    relations: Vec<Relation>,
}

impl Formula {
    /// The formula that a text is; nothing for words and for a letter alone.
    pub(crate) fn of(text: &str) -> Option<Self> {
        let folded = Folded::of(text).ok()?;
        let text = folded.text().trim();
        let lexicon = lexicon(text)?;
        let normal = |side: &Expr| Normal::of(side).ok();
        let (sides, relations) = match response::chain(text, 0, text.len(), &lexicon, Manner::REAL)
        {
            Ok(chain) => (chain.value.sides, chain.value.relations),
            Err(_) => {
                let formula = response::formula(text, &lexicon, Manner::REAL).ok()?.value;
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

/// The letters of a text as names; nothing where its letters are words, or where it has no sign of a formula.
fn lexicon(text: &str) -> Option<Lexicon> {
    /// Letters in a row that make a word, unless they are a function or a command.
    const WORD: usize = 4;
    let is_sign = |char: char| "+-*/^=<>≤≥√½¼¾\\".contains(char) || char.is_numeric();
    let mut runs = text.split(|char: char| !char.is_ascii_alphabetic());
    let is_word = |run: &str| {
        let known = [
            "sqrt", "frac", "mathrm", "text", "theta", "omega", "Omega", "alpha", "zeta",
        ];
        run.len() >= WORD && !known.contains(&run)
    };
    if !text.contains(is_sign) || runs.any(is_word) {
        return None;
    }
    let mut lexicon = Lexicon::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let (length, name) = response::letter(rest).unwrap_or((first.len_utf8(), String::new()));
        rest = &rest[length..];
        if name.is_empty() || first.is_ascii_digit() {
            continue;
        }
        let is_index = |char: char| matches!(char, '₀'..='₉' | '0'..='9' | '_');
        let behind = rest.trim_start_matches(is_index);
        let indices = &rest[..rest.len() - behind.len()];
        let digits = indices
            .char_indices()
            .filter_map(|(at, _)| response::letter(&indices[at..]));
        let name = digits.fold(name, |name, (_, digit)| name + &digit);
        lexicon.allow(&Name::new(name.as_str()), symbol(&name), false);
        rest = behind;
    }
    Some(lexicon)
}

#[cfg(test)]
mod tests {
    use super::Formula;

    #[test]
    fn a_formula_is_one_however_it_is_written() {
        let is = |typed: &str, printed: &str| {
            let (Some(typed), Some(printed)) = (Formula::of(typed), Formula::of(printed)) else {
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
        assert!(Formula::of("overdamped").is_none());
        assert!(Formula::of("the resistance R = 2").is_none());
    }
}
