//! The widths of letters, so that the boxes of labels are known without a font.
//!
//! They are those of Libertinus Serif, regular and italic, in thousandths of the letter size, widened by
//! [`ALLOWANCE`] for the fonts that a browser may put in its place.

/// Share by which other text fonts are wider.
const ALLOWANCE: f64 = 1.06;

/// Height of capitals and of most ascenders above the baseline, as a share of the size.
pub(crate) const ASCENT: f64 = 0.68;

/// Height of small letters.
pub(crate) const X_HEIGHT: f64 = 0.45;

/// Depth of `g`, `y`, `μ` and parentheses below the baseline.
pub(crate) const DESCENT: f64 = 0.22;

/// Printable ASCII from the space on, upright.
const UPRIGHT: [u16; 95] = [
    250, 288, 336, 465, 465, 637, 705, 190, 298, 298, 369, 550, 220, 338, 220, 323, 465, 465, 465,
    465, 465, 465, 465, 465, 465, 465, 236, 236, 550, 550, 550, 435, 895, 695, 588, 646, 701, 557,
    485, 685, 730, 297, 322, 637, 528, 839, 699, 702, 541, 702, 587, 485, 597, 661, 652, 951, 660,
    575, 604, 356, 287, 356, 518, 486, 392, 457, 493, 428, 506, 447, 310, 500, 538, 271, 272, 512,
    264, 790, 542, 504, 519, 503, 372, 390, 316, 531, 497, 747, 490, 515, 424, 277, 205, 277, 449,
];

/// Printable ASCII from the space on, italic.
const ITALIC: [u16; 95] = [
    250, 227, 336, 438, 438, 637, 705, 190, 306, 313, 433, 527, 219, 333, 219, 291, 444, 444, 444,
    444, 445, 444, 444, 444, 444, 444, 219, 219, 487, 527, 487, 405, 829, 667, 557, 616, 667, 526,
    457, 664, 673, 280, 414, 637, 519, 804, 666, 668, 499, 668, 555, 454, 544, 634, 597, 909, 628,
    552, 578, 334, 321, 334, 518, 486, 392, 486, 478, 389, 489, 401, 314, 477, 519, 276, 259, 486,
    266, 783, 518, 447, 489, 491, 357, 353, 307, 521, 472, 688, 475, 503, 436, 273, 205, 273, 449,
];

/// Capital Greek from `Α` on.
const GREEK_CAPITALS: [u16; 25] = [
    695, 588, 497, 636, 557, 604, 730, 702, 297, 637, 658, 839, 699, 648, 702, 667, 541, 0, 574,
    597, 575, 643, 660, 679, 697,
];

/// Small Greek from `α` on, italic.
const GREEK_SMALL: [u16; 25] = [
    522, 472, 458, 450, 369, 402, 490, 447, 258, 506, 494, 451, 440, 391, 447, 525, 482, 410, 521,
    410, 455, 546, 469, 584, 630,
];

/// The width of a letter as a share of its size.
pub(crate) fn width(letter: char, is_italic: bool) -> f64 {
    let code = letter as usize;
    let thousandths = match letter {
        ' '..='~' if is_italic => ITALIC[code - 0x20],
        ' '..='~' => UPRIGHT[code - 0x20],
        'Α'..='Ω' => GREEK_CAPITALS[code - 0x391],
        'α'..='ω' => GREEK_SMALL[code - 0x3B1],
        '\u{A0}' | '⋅' | '·' | '′' | '°' => 255,
        '\u{2009}' => 170,
        'ϑ' | 'ϵ' | 'ϕ' | '×' | '−' | '≤' | '≥' | '≈' | '–' => 550,
        '√' => 565,
        '∞' => 785,
        '…' => 750,
        '→' | '←' => 1130,
        _ => 650,
    };
    f64::from(thousandths) * 1e-3 * ALLOWANCE
}

/// Whether a letter rises above small ones.
pub(crate) fn is_tall(letter: char) -> bool {
    !matches!(
        letter,
        'a' | 'c' | 'e' | 'g' | 'm'..='s' | 'u'..='z' | 'α' | 'γ' | 'ε' | 'η' | 'ι' | 'κ'
            | 'μ'..='ο' | 'π'..='χ' | 'ω' | ',' | '.' | '−' | '=' | '+' | '⋅' | ' ' | '\u{A0}' | '\u{2009}'
    )
}

/// Whether a letter goes below the baseline.
pub(crate) fn is_deep(letter: char) -> bool {
    matches!(
        letter,
        'f' | 'g'
            | 'j'
            | 'p'
            | 'q'
            | 'y'
            | 'J'
            | 'Q'
            | '('
            | ')'
            | '['
            | ']'
            | '/'
            | ','
            | ';'
            | 'β'
            | 'γ'
            | 'ζ'
            | 'η'
            | 'μ'
            | 'ξ'
            | 'ρ'
            | 'φ'
            | 'χ'
            | 'ψ'
            | 'ϕ'
            | 'ς'
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_letter_has_a_width() {
        for letter in ('\u{20}'..'\u{500}').chain(['′', '∞', '𝑥', '\u{2009}']) {
            let (upright, italic) = (width(letter, false), width(letter, true));
            assert!(upright < 1.3 && italic < 1.3, "{letter}");
        }
        assert!(width('m', true) > width('i', true));
    }
}
