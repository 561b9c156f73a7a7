//! Small and capital letters of the scripts in which answers and options are written.
//!
//! The tables of the standard library know every script there is. The grader of the page would carry them, eleven
//! kilobytes deflated, for the words of an option and the first letter of a sentence.

/// A text in small letters: Latin, Greek, Cyrillic and Armenian ones; others stay.
///
/// ```
/// use vibank_source::lower;
/// assert_eq!(lower("Žádná ΣΊΓΜΑ, ЁЛКА"), "žádná σίγμα, ёлка");
/// ```
pub fn lower(text: &str) -> String {
    text.chars().map(small).collect()
}

/// Whether a text in small letters is this one; as [`lower`], but without writing it.
///
/// ```
/// use vibank_source::is_lower;
/// assert!(is_lower("Wrong", "wrong"));
/// assert!(!is_lower("wrong", "Wrong"));
/// ```
pub fn is_lower(text: &str, small_text: &str) -> bool {
    text.chars().map(small).eq(small_text.chars())
}

/// A sentence with a capital first letter.
///
/// ```
/// use vibank_source::capital;
/// assert_eq!(capital("überdämpft"), "Überdämpft");
/// ```
pub fn capital(sentence: &str) -> String {
    let mut letters = sentence.chars();
    letters.next().map_or_else(String::new, |first| {
        let first = large(first);
        std::iter::once(first).chain(letters).collect()
    })
}

/// Whether a letter of these scripts is a capital one.
///
/// ```
/// use vibank_source::is_capital;
/// assert!(is_capital('Ω') && is_capital('M'));
/// assert!(!is_capital('ω') && !is_capital('m') && !is_capital('2'));
/// ```
pub fn is_capital(letter: char) -> bool {
    small(letter) != letter
}

fn small(letter: char) -> char {
    if letter.is_ascii() {
        return letter.to_ascii_lowercase();
    }
    let code = u32::from(letter);
    let step = match letter {
        'À'..='Ö' | 'Ø'..='Þ' | 'Α'..='Ρ' | 'Σ'..='Ϋ' | 'А'..='Я' => 32,
        'Ѐ'..='Џ' => 80,
        'Ա'..='Ֆ' => 48,
        // In pairs, the capital letter first.
        'Ā'..='Į'
        | 'Ĳ'..='Ķ'
        | 'Ŋ'..='Ŷ'
        | 'Ѡ'..='Ҁ'
        | 'Ҋ'..='Ҿ'
        | 'Ӑ'..='Ԯ'
        | 'Ḁ'..='Ẕ'
        | 'Ạ'..='Ỿ' => u32::from(code.is_multiple_of(2)),
        'Ĺ'..='Ň' | 'Ź'..='Ž' | 'Ӂ'..='Ӎ' => code % 2,
        'Ά' => 38,
        'Έ'..='Ί' => 37,
        'Ό' => 64,
        'Ύ' | 'Ώ' => 63,
        // Signs of the ohm, the kelvin and the ångström, which some keyboards have in place of the letters.
        '\u{2126}' => return 'ω',
        '\u{212a}' => return 'k',
        '\u{212b}' => return 'å',
        'Ÿ' => return 'ÿ',
        'İ' => return 'i',
        _ => 0,
    };
    char::from_u32(code + step).unwrap_or(letter)
}

/// The capital letter of a small one, which is at one of the distances above.
fn large(letter: char) -> char {
    let found = [32, 80, 48, 1, 38, 37, 64, 63]
        .into_iter()
        .find_map(|step| {
            let capital = char::from_u32(u32::from(letter).checked_sub(step)?)?;
            (small(capital) == letter).then_some(capital)
        });
    found.unwrap_or(letter)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_are_those_of_the_standard_library() {
        // Dotted capital I is two signs in small letters there; the Caucasian palochka is far from its capital.
        let exceptions = ['İ', 'Ӏ', 'ӏ', 'ẞ', 'ı', 'ſ', 'µ', 'ÿ', 'ς'];
        let scripts = ('\0'..='ɏ')
            .chain('Ͱ'..='և')
            .chain('Ḁ'..='ỿ')
            .chain('℀'..='ⅎ');
        let mut changed = 0;
        for letter in scripts.filter(|letter| !exceptions.contains(letter)) {
            let own = small(letter);
            if own != letter {
                assert_eq!(
                    own.to_string(),
                    letter.to_lowercase().to_string(),
                    "{letter}"
                );
                changed += 1;
            }
            let capital = large(letter);
            if capital != letter {
                assert_eq!(
                    capital.to_string(),
                    letter.to_uppercase().to_string(),
                    "{letter}"
                );
            }
        }
        assert!(changed > 450, "{changed}");
        for letter in ('\0'..='ž').chain('Ά'..='ώ').chain('Ѐ'..='я') {
            if !exceptions.contains(&letter) && letter.to_lowercase().count() == 1 {
                assert_eq!(
                    small(letter).to_string(),
                    letter.to_lowercase().to_string(),
                    "{letter}"
                );
            }
        }
    }
}
