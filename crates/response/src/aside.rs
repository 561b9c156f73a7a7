//! What is said after a formula or an equation and does not change it: `√(ω_n² - 2λ²) for ζ < 1/√2`, `M/l (uniform)`,
//! `… = 0 by Newton's law`.

use super::letters::greek_word;
use super::naming::begins_value;
use super::reworded::Reworded;
use super::sides::{described, is_word};
use super::signs::is_apostrophe;
use super::surroundings::behind_word;
use super::words::{CONDITIONS, COUNTING, DENIALS, METHODS, OTHER_VALUES, SOURCES, TURNING};
use vibank_formula::unit::Unit;
use vibank_source::lower;

/// Signs of what is larger.
const RELATIONS: [char; 4] = ['<', '>', '≤', '≥'];

/// What comes before the words, the condition or the remark in brackets after a formula; none where a word denies or turns
/// what it says.
pub(crate) fn before(text: &str) -> Option<&str> {
    let text = text.trim_end_matches(['.', '!', ' ']);
    let bracketed = || {
        let (before, said) = text.strip_suffix(')')?.rsplit_once(" (")?;
        // `… = 0 (in N)`, `… = 0 (EOM)`
        let unit = said.strip_prefix("in ").unwrap_or(said);
        let is_named = before.contains('=') && (said == "EOM" || Unit::read(unit).is_ok());
        (is_named || is_aside(said)).then_some(before)
    };
    let behind_comma = || {
        let (before, said) = text.rsplit_once(", ")?;
        is_aside(said).then_some(before)
    };
    let behind_word = || {
        let words = CONDITIONS.iter().chain(SOURCES);
        words.into_iter().find_map(|word| {
            let at = text.find(&format!(" {word} "))?;
            is_aside(&text[at + 1..]).then_some(&text[..at])
        })
    };
    let last_word = || {
        let (before, word) = text.rsplit_once(' ')?;
        METHODS.contains(&lower(word).as_str()).then_some(before)
    };
    let before = bracketed()
        .or_else(behind_comma)
        .or_else(behind_word)
        .or_else(last_word)?;
    let before = before.trim_end().trim_end_matches(',').trim_end();
    (!before.is_empty()).then_some(before)
}

/// The relations that are said to hold, `ζ < 1` of `for ζ < 1, else there is no peak`; an approximation is none.
pub(crate) fn conditions(said: &str) -> Vec<String> {
    let said = said.trim_matches([' ', ',', '.', '!']);
    let bracketed = said.strip_prefix('(').and_then(|own| own.strip_suffix(')'));
    let all = bracketed.unwrap_or(said).split([',', ';']);
    let all = all.flat_map(|own| own.split(" and "));
    let relations = all.filter(|own| own.contains(RELATIONS) && !own.contains('≈'));
    relations
        .map(|own| behind_all(own.trim()).to_owned())
        .collect()
}

/// What comes after the words before a condition, `valid for`.
fn behind_all(said: &str) -> &str {
    let words = CONDITIONS.iter().chain(SOURCES);
    let behind = words.into_iter().find_map(|word| behind_word(said, word));
    behind.map_or(said, behind_all)
}

/// The statements of a text, each without what is said after it, `z = 0 (vertical plane), x^2 + y^2 = l^2`; none where
/// nothing is said of any.
pub(crate) fn between(text: &str) -> Option<Reworded> {
    const ENDS: [char; 3] = [',', ';', '\n'];
    let (mut plain, mut said) = (String::new(), Vec::new());
    for piece in text.split_inclusive(ENDS) {
        let own = piece.trim_end_matches(ENDS);
        let bare = before(own).filter(|before| before.contains('='));
        let bare = bare.unwrap_or(own);
        said.extend(conditions(&own[bare.len()..]));
        plain.extend([bare, &piece[own.len()..]]);
    }
    (plain != text).then(|| Reworded::of(plain).under(said))
}

/// What comes behind words and a colon or a comma, `the sum: k1 + k2`, `weight, m g`.
pub(crate) fn behind(text: &str) -> Option<&str> {
    let (said, formula) = text.split_once([':', ','])?;
    let formula = formula.trim_start();
    (is_remark(said) && !formula.is_empty()).then_some(formula)
}

/// What comes behind a colon, and the words with formulas before it that say where it comes from,
/// `2k1 in series with k2: 2k1k2/(2k1+k2)`; none where these name it, `spring 2: …`, or say that it is another one.
pub(crate) fn explained(text: &str) -> Option<[&str; 2]> {
    let (said, formula) = text.split_once(": ")?;
    // `x2 from the force`
    let is_name = |word: &str| {
        let is_one = word.chars().count() == 1 || greek_word(&lower(word)).is_some();
        is_word(word)
            && (is_one || word.contains(|char: char| char.is_ascii_digit() || char == '_'))
    };
    let begins = |said: &str| said.split_whitespace().next().is_some_and(is_name);
    let is_named = begins(said) || described(said).is_some_and(begins) || said.ends_with(' ');
    let is_number = |word: &str| word.bytes().all(|byte| byte.is_ascii_digit());
    let is_said = |word: &str| is_long(word) && word.bytes().all(|byte| byte.is_ascii_alphabetic());
    // `when x = 0` holds elsewhere, perhaps.
    let mut values = said.split('=').skip(1).map(str::trim_start);
    let is_elsewhere =
        values.any(|own| begins_value(own) || own.starts_with('π') || own.starts_with("pi"));
    let mut words = said.split_whitespace();
    let is_explained =
        words.clone().any(is_said) && !words.any(|own| changes(own) || is_number(own));
    (is_explained && !is_named && !is_elsewhere && !formula.contains(':'))
        .then_some([said, formula])
}

/// Whether a text is a condition, or of words alone.
fn is_aside(said: &str) -> bool {
    let begins = |word: &str| behind_word(said, word).is_some();
    let compares = said.contains(RELATIONS) || said.contains('≈');
    let is_condition = CONDITIONS.iter().any(|word| begins(word))
        || said.contains('≈')
        || said.starts_with(RELATIONS);
    // A function of time is another one before it begins.
    let is_of_time = || {
        said.split(|char: char| !char.is_alphanumeric())
            .any(|word| word == "t")
    };
    compares && is_condition && !said.contains(['=', ';']) && !is_of_time() || is_remark(said)
}

/// Whether a word says that what it stands beside is another one: it turns, denies or multiplies it.
pub(crate) fn changes(word: &str) -> bool {
    let word = lower(word);
    let tables = [TURNING, COUNTING, OTHER_VALUES, DENIALS];
    tables.iter().any(|table| table.contains(&word.as_str()))
}

/// Whether a text is of words alone, none of which says that the formula is another one.
fn is_remark(said: &str) -> bool {
    let words = said.split_whitespace();
    let mut words = words.map(|word| word.trim_end_matches([',', ';']));
    let is_of_word = |char: char| char.is_alphabetic() || char == '-' || is_apostrophe(char);
    // `2nd`
    let is_ordinal = |word: &str| {
        let bare = word.trim_start_matches(|char: char| char.is_ascii_digit());
        ["st", "nd", "rd", "th", "e"].contains(&bare)
    };
    words.clone().any(is_long)
        && words.all(|word| {
            // `-y` is a direction, `-π` a value.
            let is_direction = word.strip_prefix('-').is_some_and(str::is_ascii);
            let is_word = word.chars().all(is_of_word) && !is_direction;
            is_word && !changes(word) || is_ordinal(word)
        })
}

/// Whether a word is no letter of a formula and no unit.
fn is_long(word: &str) -> bool {
    /// Shorter words may be either.
    const MIN_LETTERS: usize = 4;
    word.chars().count() >= MIN_LETTERS
        && word.is_ascii()
        && greek_word(&lower(word)).is_none()
        && !word.ends_with("dot")
}

#[cfg(test)]
mod tests {
    use super::{before, between, conditions};

    #[test]
    fn what_is_said_of_each_equation_is_no_part_of_it() {
        for (typed, equations) in [
            ("z = 0 (vertical plane), x = y", Some("z = 0, x = y")),
            ("z = 0 (plane); x = y (line)", Some("z = 0; x = y")),
            ("z = 0 (not zero), x = y", None),
            ("z = 0 (x + y), x = y", None),
            ("z = 0, x = y", None),
        ] {
            let between = between(typed);
            let plain = between.as_ref().map(|own| own.passage().text());
            assert_eq!(plain, equations, "{typed}");
        }
    }

    #[test]
    fn conditions_are_relations() {
        for (said, all) in [
            (" for ζ < 1/√2", &["ζ < 1/√2"][..]),
            (" (valid for ζ<1)", &["ζ<1"]),
            (" if k > 0 and m > 0", &["k > 0", "m > 0"]),
            (", provided that 0 < ζ < 1, else none", &["0 < ζ < 1"]),
            (" (sin θ ≈ θ)", &[]),
            (" (uniform)", &[]),
        ] {
            assert_eq!(conditions(said), all, "{said}");
        }
    }

    #[test]
    fn what_is_said_of_a_formula_is_no_part_of_it() {
        for (typed, formula) in [
            ("sqrt(w^2 - 2λ^2), if w² > 2λ²", Some("sqrt(w^2 - 2λ^2)")),
            ("sqrt(a) for ζ < 1/√2", Some("sqrt(a)")),
            ("sqrt(a) (provided ζ<0.707)", Some("sqrt(a)")),
            ("M/l (uniform)", Some("M/l")),
            ("x'' + w^2 x = 0 (sin θ ≈ θ)", Some("x'' + w^2 x = 0")),
            ("x'' + x = 0 by Newton's 2nd law", Some("x'' + x = 0")),
            ("x'' + x = 0, valid for any angle", Some("x'' + x = 0")),
            ("x'' + x = 0 Lagrange", Some("x'' + x = 0")),
            ("x'' + x = 0 banana", None),
            ("2 cos(5 t) for t < 0", None),
            ("x'' + x = 0 (in N)", Some("x'' + x = 0")),
            ("k x (N)", None),
            ("L/2, half the column", None),
            ("m g (upwards)", None),
            ("m g (not uniform)", None),
            ("k/m (twice)", None),
            ("k/m (three times)", None),
            ("2 (a + b)", None),
            ("a sin (omega t)", None),
            ("m x'' = k lambda", None),
            ("x'' = thetaddot", None),
            ("k/m for", None),
            ("k/m for m", None),
            ("m x'' = -F for x' > 0 and m x'' = F for x' < 0", None),
        ] {
            assert_eq!(before(typed), formula, "{typed}");
        }
    }
}
