//! Counts and fractions in words: `two degrees of freedom`, `one third`, `fifty percent`.

use super::signs::is_apostrophe;
use super::wording::Wording;
use vibank_dynamics::numerics::Rational;
use vibank_source::lower;

/// Small numbers as words.
const COUNTS: &[(&str, u8)] = &[
    ("zero", 0),
    ("one", 1),
    ("two", 2),
    ("three", 3),
    ("four", 4),
    ("five", 5),
    ("six", 6),
    ("seven", 7),
    ("eight", 8),
    ("nine", 9),
    ("ten", 10),
    ("eleven", 11),
    ("twelve", 12),
    ("thirteen", 13),
    ("fourteen", 14),
    ("fifteen", 15),
    ("sixteen", 16),
    ("seventeen", 17),
    ("eighteen", 18),
    ("nineteen", 19),
    ("twenty", 20),
    ("un", 1),
    ("deux", 2),
    ("trois", 3),
    ("quatre", 4),
    ("cinq", 5),
    ("sept", 7),
    ("huit", 8),
    ("neuf", 9),
    ("dix", 10),
    ("eins", 1),
    ("zwei", 2),
    ("drei", 3),
    ("vier", 4),
    ("fünf", 5),
    ("sechs", 6),
    ("sieben", 7),
    ("acht", 8),
    ("neun", 9),
    ("zehn", 10),
    ("thirty", 30),
    ("forty", 40),
    ("fifty", 50),
    ("hundred", 100),
    ("no", 0),
    ("nil", 0),
    ("single", 1),
    ("double", 2),
    ("twofold", 2),
    ("triple", 3),
    ("II", 2),
    ("III", 3),
    ("IV", 4),
];

/// Parts of one, as words.
const PARTS: &[(&str, u8)] = &[
    ("half", 2),
    ("halves", 2),
    ("third", 3),
    ("quarter", 4),
    ("fourth", 4),
    ("fifth", 5),
    ("sixth", 6),
    ("seventh", 7),
    ("eighth", 8),
    ("ninth", 9),
    ("tenth", 10),
    ("demi", 2),
    ("tiers", 3),
    ("quart", 4),
    ("halb", 2),
    ("Drittel", 3),
    ("Viertel", 4),
];

/// What is counted in this field, the longer words before those with which they end. Cycles and half-cycles are missing:
/// three of the ones are six of the others.
const COUNTED: &[&str] = &[
    "degrees of freedom",
    "degree of freedom",
    "degrés de liberté",
    "degré de liberté",
    "freiheitsgrade",
    "freiheitsgrad",
    "dofs",
    "dof",
    "d.o.f",
    "ddl",
    "independent coordinates",
    "coordinates",
    "independent constraints",
    "constraints",
    "constraint",
    "equations",
    "pairs",
    "modes",
];

/// Words with which a count is another one, or none.
const OTHERS: &[&str] = &[
    "or", "and", "less", "fewer", "least", "most", "than", "if", "not", "twice", "times", "wrong",
    "false", "maybe",
];

/// A count in digits without what is counted, be it by the words of the question: `two degrees of freedom`, `2 half-cycles`
/// and `two (x, y)` are `2`; none where nothing of that was typed.
pub(crate) fn in_digits(typed: &str, asked: &Wording) -> Option<String> {
    let text = typed.trim().trim_end_matches(['.', '!']);
    let signs = [text.rfind(':'), text.rfind('=')].into_iter().flatten();
    let starts = std::iter::once(0).chain(signs.map(|at| at + 1));
    let mut found = starts.filter_map(|start| {
        let (label, said) = text.split_at(start);
        let number = count(said, asked)?;
        let space = if label.is_empty() { "" } else { " " };
        Some(format!("{label}{space}{number}"))
    });
    found.next().filter(|digits| digits != text)
}

/// The number of what a text counts.
fn count(said: &str, asked: &Wording) -> Option<String> {
    let said = said.trim();
    if let Some(number) = bare_count(said, asked) {
        return Some(number);
    }
    // `2, x1 and θ`, `three: x, y, z`, `two (x, y)`
    let bracketed = || {
        let (head, items) = said.strip_suffix(')')?.split_once(" (")?;
        Some((head, items))
    };
    let (head, items) = bracketed()
        .or_else(|| said.split_once(':'))
        .or_else(|| said.split_once(", "))?;
    let items: Vec<&str> = items
        .split([',', ';'])
        .flat_map(|item| item.split(" and "))
        .collect();
    let is_name = |item: &&str| {
        let item = item.trim();
        item.starts_with(|first: char| first.is_alphabetic() || first == '\\')
            && (item.contains('=') || !item.contains([' ', '<', '>', '+']))
    };
    let number = bare_count(head.trim(), asked)?;
    (items.iter().all(is_name) && number == items.len().to_string()).then_some(number)
}

/// The only number among words that name what is counted.
fn bare_count(said: &str, asked: &Wording) -> Option<String> {
    /// A longer sentence says more than a count.
    const MAX_WORDS: usize = 12;
    let counted = COUNTED.iter().find_map(|what| {
        let (before, tail) = said.split_at_checked(said.len().checked_sub(what.len())?)?;
        (tail.eq_ignore_ascii_case(what) && before.ends_with(' ')).then(|| before.trim_end())
    });
    let words: Vec<&str> = counted.unwrap_or(said).split_whitespace().collect();
    let is_plain = |word: &str| {
        word.chars()
            .all(|char| char.is_alphabetic() || "-,.".contains(char) || is_apostrophe(char))
            && word.chars().count() > 1
    };
    let numbers: Vec<(usize, String)> = words
        .iter()
        .enumerate()
        .filter_map(|(at, word)| Some((at, number(word)?)))
        .collect();
    let [(at, number)] = &numbers[..] else {
        return None;
    };
    let others: Vec<&str> = words
        .iter()
        .enumerate()
        .filter(|(own, _)| own != at)
        .map(|(_, word)| *word)
        .collect();
    let is_other = |word: &&str| {
        OTHERS.contains(&lower(word.trim_end_matches([',', '.'])).as_str()) || !is_plain(word)
    };
    let known = Wording::of(&others.join(" "))
        .known_among(std::slice::from_ref(asked), &Wording::default());
    // `no` alone counts nothing.
    let is_count = words.len() > 1 || counted.is_some() || !words[0].eq_ignore_ascii_case("no");
    let are_said =
        is_count && words.len() <= MAX_WORDS && !others.iter().any(is_other) && known.is_some();
    are_said.then(|| number.clone())
}

/// Whether the stem of a word says how many.
pub(crate) fn is_count(stem: &str) -> bool {
    let mut rests = COUNTS.iter().filter_map(|(own, _)| own.strip_prefix(stem));
    rests.any(|rest| matches!(rest, "" | "e")) || number(stem).is_some()
}

/// The number that a word is, in digits.
fn number(word: &str) -> Option<String> {
    let word = word.trim_end_matches(',');
    let is_figure = |byte: u8| byte.is_ascii_digit() || b".,".contains(&byte);
    if word.starts_with(|first: char| first.is_ascii_digit()) && word.bytes().all(is_figure) {
        return Some(word.to_owned());
    }
    let is_roman = |own: &str| own.starts_with('I');
    let is_it = |own: &str| {
        if is_roman(own) {
            word == own
        } else {
            word.eq_ignore_ascii_case(own)
        }
    };
    let (_, number) = COUNTS.iter().find(|(own, _)| is_it(own))?;
    Some(number.to_string())
}

/// The number that words are, and whether it is in percent: `zero`, `one third`, `half`, `fifty %`.
pub(crate) fn in_words(text: &str) -> Option<(Rational, bool)> {
    let bare = text.trim().trim_end_matches('%');
    let is_percent = bare.len() < text.trim().len();
    let words: Vec<&str> = bare
        .split([' ', '-'])
        .filter(|word| !word.is_empty())
        .collect();
    let count = |word: &str| {
        let found = COUNTS.iter().find(|(own, _)| {
            !matches!(*own, "no" | "double" | "single" | "triple" | "twofold")
                && word.eq_ignore_ascii_case(own)
        });
        found.map(|(_, number)| i128::from(*number))
    };
    let part = |word: &str| {
        let bare = word
            .strip_suffix('s')
            .filter(|bare| *bare != "tier")
            .unwrap_or(word);
        let found = PARTS
            .iter()
            .find(|(own, _)| bare.eq_ignore_ascii_case(own) || word.eq_ignore_ascii_case(own));
        found.map(|(_, parts)| i128::from(*parts))
    };
    let value = match words[..] {
        [only] => count(only)
            // Elsewhere a number in words is as unusual as its unit.
            .filter(|count| *count == 0 || is_percent)
            .and_then(|count| Rational::new(count, 1))
            .or_else(|| Rational::new(1, part(only)?)),
        ["a" | "A" | "an" | "un", own] => Rational::new(1, part(own)?),
        [number, own] => Rational::new(count(number)?, part(own)?),
        _ => None,
    }?;
    Some((value, is_percent))
}

/// An integer without the remark in brackets after it, `3 (x, y, z)`; a factor has no letters, and a remark that leaves
/// a choice or takes back is none.
pub(crate) fn before_remark(text: &str) -> Option<&str> {
    let (before, remark) = text.strip_suffix(')')?.split_once(" (")?;
    let mut words = remark.split(|char: char| !char.is_alphabetic());
    let is_doubt = |word: &str| {
        [
            "or", "not", "oder", "maybe", "perhaps", "wrong", "if", "per", "each", "times",
        ]
        .contains(&vibank_source::lower(word).as_str())
    };
    // `33 (3 per point)`
    let number = |text: &str| text.parse::<u32>().ok().filter(|number| *number > 0);
    let per = remark.split(' ').next().and_then(number);
    let shares = || {
        let all = before.rsplit(' ').next().and_then(number);
        let is_of_all = |(all, own): (u32, u32)| all > own && all % own == 0;
        all.zip(per).is_some_and(is_of_all)
            && (remark.contains(" per ") || remark.contains(" each"))
    };
    let is_remark = remark.contains(char::is_alphabetic) && (!words.any(is_doubt) || shares());
    (before.ends_with(|last: char| last.is_ascii_digit()) && is_remark).then_some(before)
}

/// The word for what is counted, after a number: `2 periods`.
pub(crate) fn counted(value: &str) -> Option<&str> {
    const WORDS: [&str; 16] = [
        "period",
        "periods",
        "oscillation",
        "oscillations",
        "vibrations",
        "swings",
        "times",
        "dof",
        "dofs",
        "degree of freedom",
        "degrees of freedom",
        "half-cycles",
        "half cycles",
        "modes",
        "coordinates",
        "positions",
    ];
    let word = value.trim_start_matches(|char: char| !char.is_alphabetic());
    WORDS
        .contains(&word.to_ascii_lowercase().as_str())
        .then_some(word)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_those_of_what_is_asked_for() {
        let asked = Wording::of("How many half-cycles does the block make before it rests?");
        for (typed, digits) in [
            ("two", Some("2")),
            ("2 half-cycles", Some("2")),
            ("four half cycles", Some("4")),
            ("n = 2 half-cycles", Some("n = 2")),
            ("it makes 3 half-cycles", Some("3")),
            ("two degrees of freedom", Some("2")),
            ("2 d.o.f.", Some("2")),
            ("II", Some("2")),
            ("2, x1 and θ", Some("2")),
            ("Three: x, y and z", Some("3")),
            ("no half-cycles", Some("0")),
            ("2 cycles", None),
            ("2 or 3", None),
            ("2 or more half-cycles", None),
            ("not two", None),
            ("3, x1 and θ", None),
            ("two periods", None),
            ("2 half", None),
            ("about two blocks", None),
            ("2", None),
        ] {
            assert_eq!(in_digits(typed, &asked).as_deref(), digits, "{typed}");
        }
    }

    #[test]
    fn fractions_are_numbers() {
        let of = |text| {
            in_words(text)
                .map(|(value, is_percent)| (value.numerator(), value.denominator(), is_percent))
        };
        for (typed, value) in [
            ("zero", Some((0, 1, false))),
            ("one third", Some((1, 3, false))),
            ("a third", Some((1, 3, false))),
            ("two-thirds", Some((2, 3, false))),
            ("half", Some((1, 2, false))),
            ("fifty %", Some((50, 1, true))),
            ("half of l", None),
            ("no", None),
            ("a few", None),
        ] {
            assert_eq!(of(typed), value, "{typed}");
        }
    }
}
