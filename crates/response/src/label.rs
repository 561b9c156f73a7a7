//! Symbols before an equals sign that are not names: `V(π)`, `x₃/x`, `cos θ`, `ω²`.

use super::letters::{Letters, greek_word};
use super::{Folded, Passage};
use vibank_formula::unit::Unit;
use vibank_notation::Math;

/// A symbol in one spelling: Greek letters as words, indices and exponents on the line, without spaces and brackets.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label(String);

impl Label {
    /// The symbol of a quantity, if it is not a name that is read as such.
    pub fn of_symbol(symbol: &Math) -> Option<Self> {
        let plain = symbol.plain();
        let is_name = Letters::spelling(&plain).is_some();
        let folded = Folded::of(&plain).ok().filter(|_| !is_name)?;
        Some(Self::of_text(folded.text()))
    }

    /// What was typed before an equals sign.
    pub fn of_passage(passage: Passage<'_>) -> Self {
        Self::of_text(passage.text())
    }

    /// Whether it is a power of another one, ω² of ω.
    pub fn is_power_of(&self, base: &Self) -> bool {
        let exponent = self.0.strip_prefix(&base.0);
        exponent.is_some_and(|exponent| exponent.starts_with('^'))
    }

    /// The same with ω for the w that many type instead.
    pub fn with_omega(&self) -> Option<Self> {
        let behind = self.0.strip_prefix('w')?;
        let is_letter = !behind.starts_with(char::is_alphabetic);
        is_letter.then(|| Self(format!("omega{behind}")))
    }

    fn of_text(text: &str) -> Self {
        let mut label = String::new();
        let mut rest = text;
        while let Some(char) = rest.chars().next() {
            rest = &rest[char.len_utf8()..];
            match char {
                '\\' => {
                    let end = rest.find(|next: char| !next.is_ascii_alphabetic());
                    let (name, behind) = rest.split_at(end.unwrap_or(rest.len()));
                    rest = behind;
                    let is_face = ["mathrm", "text", "operatorname"].contains(&name);
                    label.push_str(greek_word(name).unwrap_or(if is_face { "" } else { name }));
                }
                '"' => label.push_str("''"),
                '⁰' | '¹' | '²' | '³' | '⁴'..='⁹' => {
                    const RAISED: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";
                    let digit = RAISED.chars().position(|own| own == char).unwrap_or(0);
                    label.push('^');
                    label.push_str(&digit.to_string());
                }
                // A star is raised or stands on the line.
                '*' => {
                    label.truncate(label.trim_end_matches('^').len());
                    label.push('*');
                }
                // `V(0°)`
                '°' if label.ends_with('0') => {}
                _ if char.is_whitespace() || "_{}()[]".contains(char) => {}
                _ => {
                    let mut letter = Letters::default();
                    if letter.push(char, 0, 0) {
                        label.push_str(&letter.text);
                    } else {
                        label.push(char);
                    }
                }
            }
        }
        Self(label)
    }
}

/// A symbol without the unit that stands beside it, `f in Hz`, `f/Hz`; one of one letter may be a divisor.
pub(crate) fn without_unit(label: &str) -> &str {
    let parts = label.split_once(" in ").or_else(|| label.split_once('/'));
    let Some((name, unit)) = parts else {
        return label;
    };
    let unit = unit.trim().trim_matches(['(', ')']);
    let is_unit = unit.chars().count() > 1 && Unit::read(unit).is_ok();
    if is_unit { name.trim_end() } else { label }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_star_tells_symbols_apart() {
        let of = |text: &str| Label::of_text(Folded::of(text).unwrap().text());
        assert_ne!(of("ζ₁^∗"), of("ζ₁"));
        assert_ne!(of("a_1^*"), of("a_1"));
    }

    #[test]
    fn a_symbol_is_one_in_all_its_spellings() {
        for (printed, spellings) in [
            ("V(π)", &["V(pi)", "V(\\pi)", "V ( π )", "V[Pi]"][..3]),
            ("V′′(0)", &["V''(0)", "V\"(0)", "V″(0)"]),
            ("x₃/x", &["x3/x", "x_3/x", "x_{3}/x"]),
            ("ω²", &["omega^2", "\\omega^2", "\\omega^{2}", "ω^2"]),
            ("cos θ", &["cos(theta)", "\\cos\\theta", "cosθ"]),
            ("n_(1/2)", &["n_{1/2}", "n_1/2"]),
            ("a₁^∗", &["a_1^*", "a1*", "a_{1}^{*}"]),
            ("Q₀/Q − 1", &["Q0/Q - 1", "Q_0/Q-1"]),
        ] {
            let of = |text: &str| Label::of_text(Folded::of(text).unwrap().text());
            for spelling in spellings {
                assert_eq!(of(printed), of(spelling), "{printed}, {spelling}");
            }
        }
    }
}
