//! Counts and fractions in words: `two degrees of freedom`, `one third`, `fifty percent`.

use std::sync::OnceLock;

use super::signs::{is_digit, is_of_word};
use super::wording::Wording;
use super::words::{COUNTS, DENIALS, DOUBTS, OTHER_VALUES, PARTS, WITHDRAWALS};
use vibank_dynamics::numerics::Rational;
use vibank_source::lower;

/// What is counted in this field, and words beside it. Cycles and half-cycles are missing: three of the ones are six of the
/// others.
const COUNTED: &str = "degree degrees of freedom degrés de liberté freiheitsgrade freiheitsgrad dofs ddl coordinates coords \
                       constraints equations pairs modes equilibria positions independent holonomic geometric number \
                       total altogether translations rotations lengths distances angles fixed";

/// What is counted in this field, by its words.
pub(crate) fn things() -> Wording {
    Wording::of(COUNTED)
}

/// What is counted in time.
const TURNS_OF_TIME: &str = "periods oscillations vibrations swings times half-cycles";

/// Words with which a count is another one, or none, beside those that leave open, deny or change anything.
const OTHERS: &[&str] = &["less", "fewer", "least", "most", "than", "times", "but"];

/// What is said before the number of one of several.
const NUMBERED: [&str; 3] = ["No. ", "no. ", "Nr. "];

/// Words and signs before a count that follows from what stands before them; an arrow has become an equals sign.
const SO: &[&str] = &[
    " so ",
    " hence ",
    " thus ",
    " therefore ",
    "→",
    "->",
    "=>",
    " = ",
];

/// A count in digits without what is counted, one of the known words, and without a reason: `two degrees of
/// freedom`, `2 half-cycles`, `two (x, y)` and `x, y so 2` are `2`; none where nothing of that was typed.
pub(crate) fn in_digits(typed: &str, known: &Wording) -> Option<String> {
    let text = typed.trim().trim_end_matches(['.', '!']);
    let numbered = NUMBERED.iter().find_map(|word| text.strip_prefix(word));
    if let Some(number) = numbered.filter(|own| own.parse::<u32>().is_ok()) {
        return Some(number.to_owned());
    }
    let signs = [text.rfind(':'), text.rfind('=')].into_iter().flatten();
    let starts = std::iter::once(0).chain(signs.map(|at| at + 1));
    let mut found = starts.filter_map(|start| {
        let (label, said) = text.split_at(start);
        let number = count(said, known)?;
        // `there are none`
        let is_idle = Wording::of(label.trim_end_matches(['=', ':', ' '])).is_empty();
        let label = if is_idle { "" } else { label };
        let space = if label.is_empty() { "" } else { " " };
        Some(format!("{label}{space}{number}"))
    });
    // Alone it is no answer.
    let found = found
        .next()
        .filter(|digits| digits != text && !text.eq_ignore_ascii_case("none"));
    let found = found.or_else(|| conclusion(text, known));
    found.or_else(|| calculation(text, known))
}

/// The count that follows from what stands before it: `x, y, z so 3`, `n = 3.17 → 4`.
fn conclusion(text: &str, known: &Wording) -> Option<String> {
    let mut ends = SO.iter().filter_map(|so| text.rsplit_once(so));
    ends.find_map(|(reason, said)| {
        let number = bare_count(said, known)?;
        let own = count(reason, known).filter(|own| own.parse::<u32>().is_ok());
        let last = reason.rsplit('=').next().unwrap_or_default().trim();
        // A number of steps is the next integer of what was computed.
        let is_near = |value: Rational| {
            let count = Rational::from_decimal(&number);
            let off = count.and_then(|count| value.checked_sub(count));
            !value.is_integer() && off.is_some_and(|off| off.abs() < Rational::ONE)
        };
        let has_number = last.contains(|char: char| char.is_ascii_digit());
        let is_reason = match Rational::from_decimal(last) {
            Some(value) => is_near(value),
            None => !has_number || last.contains([',', ':']) || last.contains(" and "),
        };
        (own.is_none_or(|own| own == number) && is_reason).then_some(number)
    })
}

/// A calculation without what is counted in it, `4 points x 3 = 12`.
fn calculation(text: &str, known: &Wording) -> Option<String> {
    let (terms, others): (Vec<&str>, Vec<&str>) = text
        .split_whitespace()
        .partition(|word| !word.contains(char::is_alphabetic) || *word == "x");
    let numbers = terms.iter().filter(|word| number(word).is_some());
    (numbers.count() > 1 && !others.is_empty() && are_idle(&others, known)).then(|| terms.join(" "))
}

/// The number of what a text counts, with what is said of it: `2, x1 and θ`, `three: x, y, z`, `two (x, y)`.
fn count(said: &str, known: &Wording) -> Option<String> {
    let said = said.trim();
    if let Some(number) = bare_count(said, known) {
        return Some(number);
    }
    let bracketed = said.strip_suffix(')').and_then(|own| own.split_once(" ("));
    let (head, remark) = bracketed
        .or_else(|| said.split_once(':'))
        .or_else(|| said.split_once(", "))?;
    let number = bare_count(head.trim(), known)?;
    let items: Vec<&str> = remark
        .split([',', ';'])
        .flat_map(|item| item.split(" and "))
        .map(|item| item.trim().trim_start_matches("the "))
        .collect();
    let is_name = |item: &&str| {
        item.starts_with(|first: char| first.is_alphabetic() || first == '\\')
            && (item.contains('=') || !item.contains([' ', '<', '>', '+']))
    };
    let is_value =
        |item: &&str| is_name(item) || !item.trim_start_matches(['±', ' ']).contains(' ');
    let is_said = if items.iter().all(is_name) || items.len() > 1 && items.iter().all(is_value) {
        let pairs = items.iter().filter(|item| item.starts_with('±')).count();
        number == (items.len() + pairs).to_string()
    } else {
        bare_count(remark, known).is_some_and(|own| own == number) || is_remark(remark, &number)
    };
    is_said.then_some(number)
}

/// Whether words say nothing against a count; integers among them are factors of it, `12 (3 per point)`, decimals what it
/// comes from, `3 (2.76 rounded up)`, and zeros what vanishes, `2 (z = 0 and length constant)`.
fn is_remark(remark: &str, count: &str) -> bool {
    let remark = remark.replace(" = ", "=").replace("=0", " ");
    let is_decimal = |own: &str| {
        let value = Rational::from_decimal(own);
        value.is_some_and(|value| !value.is_integer())
    };
    let is_factor = |own: &str| {
        let pair = own.parse::<u32>().ok().zip(count.parse::<u32>().ok());
        pair.is_some_and(|(own, count)| 0 < own && own < count && count % own == 0)
    };
    let mut words = remark
        .split(|char: char| !char.is_alphanumeric() && char != '.')
        .filter(|word| !word.is_empty());
    remark.contains(char::is_alphabetic)
        && words.all(|word| match number(word) {
            Some(own) => is_factor(&own) || is_decimal(&own),
            None => matches!(word, "and" | "per") || !is_other(word),
        })
}

/// Whether a count beside a word may be another one, or none.
fn is_other(word: &str) -> bool {
    let word = lower(word.trim_end_matches([',', '.']));
    let mut tables = [OTHERS, DOUBTS, DENIALS, OTHER_VALUES, WITHDRAWALS].into_iter();
    tables.any(|table| table.contains(&word.as_str()))
}

/// Whether words are known, and leave a count beside them as it is.
fn are_idle(words: &[&str], known: &Wording) -> bool {
    let are_plain = words.iter().all(|word| {
        let mut chars = word.chars();
        // `half cycles` is one word.
        let is_known = *word == "half" || !is_other(word);
        chars.all(|char| is_of_word(char) || ",.".contains(char))
            && word.chars().nth(1).is_some()
            && is_known
    });
    are_plain && Wording::of(&words.join(" ")).is_part_of(known)
}

/// The only number among words that name what is counted.
fn bare_count(said: &str, known: &Wording) -> Option<String> {
    /// A longer sentence says more than a count.
    const MAX_WORDS: usize = 12;
    let words = words(said);
    let all = words.iter().map(String::as_str);
    let (numbers, others): (Vec<&str>, Vec<&str>) = all.partition(|word| number(word).is_some());
    let [only] = numbers[..] else {
        return None;
    };
    // Who is asked how many says no rank.
    let is_rank = only.ends_with(char::is_alphabetic) && only.starts_with(is_digit);
    let is_asked = !is_rank || known.has_word("which");
    let is_said = is_asked && words.len() <= MAX_WORDS && are_idle(&others, known);
    number(only).filter(|_| is_said)
}

/// The words of a text, figures apart from the noun behind them, `1DOF`; those of one number are one, `twenty four`.
fn words(said: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    for word in said.split_whitespace() {
        let noun = word.trim_start_matches(is_digit);
        // `2nd` is a number, and `2m` none.
        let is_noun = noun.chars().all(char::is_alphabetic) && noun.chars().nth(2).is_some();
        let (figures, noun) = word.split_at(if is_noun { word.len() - noun.len() } else { 0 });
        for word in [figures, noun].into_iter().filter(|word| !word.is_empty()) {
            match words.last_mut() {
                Some(last) if spelled(&format!("{last} {word}")).is_some() => {
                    *last = format!("{last} {word}");
                }
                _ => words.push(word.to_owned()),
            }
        }
    }
    words
}

/// Whether the stem of a word says how many.
pub(crate) fn is_count(stem: &str) -> bool {
    let mut rests = COUNTS.iter().filter_map(|(own, _)| own.strip_prefix(stem));
    rests.any(|rest| matches!(rest, "" | "e")) || number(stem).is_some()
}

/// The number that a word is, in digits: `two`, `2`, `2nd`, `twenty-four`.
fn number(word: &str) -> Option<String> {
    let word = word.trim_end_matches(',');
    if word.starts_with(is_digit) {
        let mut ranks = ["st", "nd", "rd", "th"].into_iter();
        let bare = ranks
            .find_map(|rank| word.strip_suffix(rank))
            .unwrap_or(word);
        let mut figures = bare.bytes();
        let is_number = figures.all(|byte| byte.is_ascii_digit() || b".,".contains(&byte));
        return is_number.then(|| bare.to_owned());
    }
    let found = COUNTS.iter().find(|(own, _)| {
        let is_roman = own.starts_with('I');
        word == *own || !is_roman && word.eq_ignore_ascii_case(own)
    });
    let found = found.map(|(_, number)| i128::from(*number));
    Some(found.or_else(|| spelled(word))?.to_string())
}

/// The integer that words are, between spaces or dashes.
fn spelled(words: &str) -> Option<i128> {
    cardinal(&words.split([' ', '-']).collect::<Vec<_>>())
}

/// The number that words are, and whether it is in percent: `zero`, `one third`, `half`, `fifty %`.
pub(crate) fn in_words(text: &str) -> Option<(Rational, bool)> {
    let bare = text.trim().trim_end_matches('%');
    let is_percent = bare.len() < text.trim().len();
    let words: Vec<&str> = bare
        .split([' ', '-'])
        .filter(|word| !word.is_empty())
        .collect();
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
        [only] if part(only).is_some() => Rational::new(1, part(only)?),
        ["a" | "A" | "an" | "un", own] => Rational::new(1, part(own)?),
        [number, own] if part(own).is_some() => Rational::new(cardinal(&[number])?, part(own)?),
        _ => Rational::new(cardinal(&words)?, 1),
    }?;
    Some((value, is_percent))
}

/// The words of a number at the beginning of a text, as far as they are such, and what comes after them: `ten thousand N`.
pub(crate) fn in_front(text: &str) -> (&str, &str) {
    let words = text.split_inclusive(' ');
    let numbers =
        words.take_while(|word| word.trim_end().split('-').all(|word| size(word).is_some()));
    text.split_at(numbers.map(str::len).sum())
}

/// The size of a word for a number, where no other word is meant by it.
fn size(word: &str) -> Option<i128> {
    const OTHERS: [&str; 7] = [
        "no", "none", "null", "double", "single", "triple", "twofold",
    ];
    let found = COUNTS.iter().find(|(own, _)| {
        word.eq_ignore_ascii_case(own) && !own.starts_with('I') && !OTHERS.contains(own)
    });
    found.map(|(_, number)| i128::from(*number))
}

/// The integer that words are: `twenty five`, `ten thousand`. Smaller words come after tens and after larger ones.
fn cardinal(words: &[&str]) -> Option<i128> {
    let (mut thousands, mut below) = (0, 0);
    for (place, word) in words.iter().enumerate() {
        let size = size(word)?;
        match size {
            1000 if thousands == 0 => (thousands, below) = (1000 * i128::max(below, 1), 0),
            100 if below < 10 => below = 100 * i128::max(below, 1),
            0..=99 if place == 0 => below = size,
            1..=9 if below % 10 == 0 && below % 100 != 10 && thousands + below > 0 => below += size,
            10..=99 if below % 100 == 0 => below += size,
            _ => return None,
        }
    }
    (!words.is_empty()).then_some(thousands + below)
}

/// The word for what is counted, after a number: `2 periods`.
pub(crate) fn counted(value: &str) -> Option<&str> {
    // It is looked up for each response that is not a number, and few of those have its words.
    static KNOWN: OnceLock<Wording> = OnceLock::new();
    let known = KNOWN.get_or_init(|| things().joined(&Wording::of(TURNS_OF_TIME)));
    let word = value.trim_start_matches(|char: char| !char.is_alphabetic());
    let own = Wording::of(word);
    (!own.is_empty() && own.is_part_of(known)).then_some(word)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_those_of_what_is_asked_for() {
        let known = things().joined(&Wording::of(
            "How many half-cycles does the block make before it rests?",
        ));
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
            ("there are none", Some("0")),
            ("twenty-four", Some("24")),
            ("Twenty four half-cycles", Some("24")),
            ("1DOF", Some("1")),
            ("3 coords in total", Some("3")),
            ("three (3)", Some("3")),
            ("one, the angle", Some("1")),
            ("3 (0, ±93.5)", Some("3")),
            ("x, y, z so 3", Some("3")),
            ("n = 3.17 → 4", Some("4")),
            ("7.9, so 8", Some("8")),
            ("two full cycles, = 4", Some("4")),
            ("4 constraints * 3 = 12", Some("4 * 3 = 12")),
            ("12 (3 per point)", Some("12")),
            ("2, x1 and x2, θ follows", Some("2")),
            ("the 4th", None),
            ("one hundred twenty half-cycles", Some("120")),
            ("20 4", None),
            ("3 → 4", None),
            ("3.17 = 5", None),
            ("2 + 1 = 4", None),
            ("2, but 1 is redundant", None),
            ("3 (0, 93.5)", None),
            ("none", None),
            ("1 or 2, so 1 or 2", None),
            ("3 (2 of them redundant)", None),
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
            assert_eq!(in_digits(typed, &known).as_deref(), digits, "{typed}");
        }
    }

    #[test]
    fn a_rank_is_a_count_where_one_is_asked() {
        let known = things().joined(&Wording::of("Which is the last extremum?"));
        for (typed, digits) in [
            ("the 4th", Some("4")),
            ("4th extremum", Some("4")),
            ("4th cycle", None),
        ] {
            assert_eq!(in_digits(typed, &known).as_deref(), digits, "{typed}");
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
            ("twelve", Some((12, 1, false))),
            ("twenty-five", Some((25, 1, false))),
            ("ten thousand", Some((10_000, 1, false))),
            ("two hundred five", Some((205, 1, false))),
            ("three thousand four hundred twenty", Some((3420, 1, false))),
            ("two five", None),
            ("ten five", None),
            ("five twenty", None),
            ("hundred hundred", None),
            ("double", None),
            ("half of l", None),
            ("no", None),
            ("a few", None),
        ] {
            assert_eq!(of(typed), value, "{typed}");
        }
    }
}
