//! About how wide a formula is, for style sheets that keep a wide one within its page.

use super::{Class, Holes, Math, Style};

/// The size of a script to that of its base.
const SCRIPT: f64 = 0.72;

/// Of a letter, a digit and a letter of a word, in em.
const LETTER: f64 = 0.6;
const DIGIT: f64 = 0.52;
const WORD: f64 = 0.5;

/// The width of a formula in em, rather too large than too small.
pub(crate) fn of(math: &Math, holes: &dyn Holes) -> f64 {
    let own = |part: &Math| of(part, holes);
    let most = |all: &mut dyn Iterator<Item = f64>| all.fold(0.0, f64::max);
    match math {
        Math::Row(pieces) => pieces.iter().map(own).sum(),
        Math::Identifier { text, style } => {
            let letters = text.chars().count() as f64;
            let wide = text
                .chars()
                .any(|letter| matches!(letter, 'M' | 'W' | 'm' | 'w'));
            let is_bold = matches!(style, Style::Bold | Style::BoldItalic);
            letters * LETTER + if wide { 0.45 } else { 0.1 } + if is_bold { 0.1 } else { 0.0 }
        }
        Math::Number(digits) => digits.chars().count() as f64 * DIGIT,
        Math::Operator { text, class } => {
            let signs = text.chars().count() as f64;
            match class {
                Class::Relation => signs * 0.8 + 0.56,
                Class::Binary => signs * 0.8 + 0.45,
                Class::Large => signs + 0.2,
                Class::Opening | Class::Closing | Class::Punctuation => signs * 0.45,
                Class::Prefix | Class::Ordinary => signs * 0.6,
            }
        }
        Math::Function(name) => name.chars().count() as f64 * WORD + 0.2,
        Math::Text(words) => words.chars().count() as f64 * WORD,
        Math::Space(width) => f64::from(*width) / 18.0,
        Math::Fraction {
            numerator,
            denominator,
            ..
        } => own(numerator).max(own(denominator)) + 0.3,
        Math::Root { radicand, degree } => {
            own(radicand) + 1.0 + degree.as_deref().map_or(0.0, own) * SCRIPT
        }
        Math::Script { base, sub, sup } => {
            let scripts = [sub, sup].into_iter().flatten();
            own(base) + 0.1 + most(&mut scripts.map(|script| own(script) * SCRIPT))
        }
        Math::Stack { base, under, over } => {
            let marks = [under, over].into_iter().flatten();
            most(&mut marks.map(|mark| own(mark) * SCRIPT)).max(own(base))
        }
        Math::Accent { base, .. } => own(base),
        Math::Fence { body, .. } => own(body) + 1.0,
        Math::Table { rows, .. } => {
            let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
            (0..columns)
                .map(|place| most(&mut rows.iter().filter_map(|row| row.get(place)).map(own)))
                .sum::<f64>()
                + columns as f64
        }
        Math::Hole(_) => match math.filled(holes) {
            Math::Hole(_) => LETTER,
            filling => of(filling, &super::Empty),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Empty, symbol};

    #[test]
    fn a_fraction_is_as_wide_as_its_wider_half() {
        let sum = || Math::row([symbol("k_1"), Math::binary("+"), symbol("k_2")]);
        let width = |math: &Math| math.width(&Empty);
        let high = Math::fraction(sum(), symbol("m"));
        assert!(width(&high) > width(&sum()) && width(&high) < width(&sum()) + 1.0);
        let filled = Math::row([Math::Hole(0), Math::Hole(0)]);
        assert!((filled.width(&vec![sum()]) - 2.0 * width(&sum())).abs() < 1e-12);
    }
}
