//! Words by what they mean: stems, with one word for all that mean the same in the field, without those that say nothing.

use super::counts;
use super::letters::{greek_word, letter, lowered};
use super::signs::is_digit;
use super::words::{FILLERS, OTHER_VALUES, PREFIXES, RUNS_OF_WORDS, STRESSES, SUFFIXES, SYNONYMS};
use vibank_notation::greek_name;
use vibank_source::lower;

/// The words of a text that say something, in their order.
///
/// ```
/// use vibank_response::Wording;
///
/// let option = Wording::of("statically only");
/// assert!(Wording::of("only static").is_same(&option));
/// assert!(!Wording::of("not static").is_same(&option));
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Wording(Vec<String>);

/// A denial, whatever its word.
pub(crate) const NOT: &str = "not";

impl Wording {
    /// The words of a text, folded or not.
    pub fn of(text: &str) -> Self {
        let text = lower(text);
        let text = RUNS_OF_WORDS.iter().fold(text, |text, (run, word)| {
            if text.contains(run) {
                text.replace(run, word)
            } else {
                text
            }
        });
        let mut words: Vec<String> = Vec::new();
        let mut prefix = None;
        for piece in joined(&text).split(is_gap) {
            let mut plain = String::new();
            for char in piece.chars().filter(|char| !"-_'\\$".contains(*char)) {
                match greek_name(char) {
                    Some(name) => plain.push_str(name),
                    None => plain.push(lowered(char).unwrap_or(char)),
                }
            }
            if plain.is_empty() {
                continue;
            }
            if PREFIXES.contains(&plain.as_str()) {
                words.extend(prefix.replace(plain).as_deref().map(meant));
                continue;
            }
            // `\\varphi`
            let variant = plain
                .strip_prefix("var")
                .filter(|own| greek_word(own).is_some());
            let whole = prefix.take().unwrap_or_default() + variant.unwrap_or(&plain);
            let own = meant(&whole);
            if !FILLERS.contains(&whole.as_str()) && words.last() != Some(&own) {
                words.push(own);
            }
        }
        words.extend(prefix.as_deref().map(meant));
        Self(words)
    }

    /// The words of a question, and those that stress what is said.
    pub fn of_question(text: &str) -> Self {
        Self::of(&format!("{STRESSES} {text}"))
    }

    /// The words of a question for a count, and of what is counted in this field.
    pub fn of_count(question: Option<&str>) -> Self {
        let asked = question.map(Self::of_question);
        counts::things().joined(&asked.unwrap_or_default())
    }

    /// Whether nothing is said.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Stems of words that mean what is said.
    pub(crate) fn of_words(words: Vec<String>) -> Self {
        Self(words)
    }

    /// The stems of the words.
    pub(crate) fn words(&self) -> &[String] {
        &self.0
    }

    /// Whether a stem is that of a word.
    pub(crate) fn has_word(&self, word: &str) -> bool {
        self.0.iter().any(|own| own == word)
    }

    /// With the words of another text after its own.
    #[must_use]
    pub fn joined(mut self, other: &Self) -> Self {
        self.0.extend(other.0.iter().cloned());
        self
    }

    /// Whether words that are among these or say nothing make up a text.
    pub(crate) fn covers(&self, text: &str) -> bool {
        let own = Self::of(text);
        let is_plain = text
            .chars()
            .all(|char| char.is_alphabetic() || " -',".contains(char));
        is_plain && !own.denies() && own.0.iter().all(|word| self.0.contains(word))
    }

    /// A value without the words before and after it that are among these or say nothing; none where there are none, and
    /// where one of them makes another value of it.
    pub(crate) fn trimmed_off<'t>(&self, value: &'t str) -> Option<&'t str> {
        let is_said = |word: &str| {
            let word = word.trim_end_matches([',', ';', '.']);
            let own = Self::of(word);
            word.chars().all(|char| char.is_alphabetic() || char == '-')
                && word.chars().count() > 1
                && !OTHER_VALUES.contains(&word)
                && !own.denies()
                && own.0.iter().all(|word| self.0.contains(word))
        };
        let value = value.trim();
        let mut rest = value;
        while let Some((before, _)) = rest.rsplit_once(' ').filter(|(_, word)| is_said(word)) {
            rest = before.trim_end_matches([' ', ',']);
        }
        let after = &value[rest.len()..];
        while let Some((_, behind)) = rest.split_once(' ').filter(|(word, _)| is_said(word)) {
            rest = behind.trim_start();
        }
        let before = &value[..value.len() - after.len() - rest.len()];
        // `5 per` goes on.
        let says = |words: &str| words.is_empty() || !Self::of(words).is_empty();
        if !says(after) || !says(before) {
            return None;
        }
        let has_digit = rest.contains(is_digit);
        (rest.len() < value.len() && has_digit).then_some(rest)
    }

    /// Whether something is denied.
    pub fn denies(&self) -> bool {
        self.0.iter().any(|word| word == NOT)
    }

    /// Whether all its words are among those of another.
    pub(crate) fn is_part_of(&self, other: &Self) -> bool {
        self.0.iter().all(|word| other.0.contains(word))
    }

    /// Whether both have the same words, in any order.
    pub fn is_same(&self, other: &Self) -> bool {
        self.is_part_of(other) && other.is_part_of(self)
    }
}

/// Whether a word is a symbol or a formula: a letter, or letters with digits and signs.
pub(crate) fn is_symbol(word: &str) -> bool {
    /// Letters of the shortest Greek names that begin no word: `omegan`, not `pin`.
    const MIN_NAME: usize = 4;
    let name = word.trim_start_matches('\\');
    word.contains(char::is_alphabetic)
        && (name.chars().nth(1).is_none()
            || greek_word(name).is_some()
            || name.contains(|char: char| {
                !char.is_alphabetic() && char != '-' || greek_name(char).is_some()
            })
            || letter(name)
                .is_some_and(|(length, _)| length >= MIN_NAME && length + 1 == name.len()))
}

/// Signs that stand between words.
fn is_gap(char: char) -> bool {
    char.is_whitespace() || ",;:.()[]{}\"!?…→".contains(char)
}

/// The spelling in which the sides of a short comparison are one word, `L = m`.
fn joined(text: &str) -> String {
    let mut words: Vec<String> = Vec::new();
    let is_sign = |word: &str| matches!(word, "=" | "<" | ">" | "≤" | "≥");
    let is_side = |word: &str| is_symbol(word) || !word.contains(char::is_alphabetic);
    let mut pieces = text.split_whitespace().peekable();
    while let Some(piece) = pieces.next() {
        let next = pieces.peek().copied().unwrap_or_default();
        let is_joined =
            is_sign(piece) && is_side(next) && words.last().is_some_and(|last| is_side(last));
        match words.last_mut().filter(|_| is_joined) {
            Some(last) => {
                last.push_str(piece);
                last.push_str(next);
                pieces.next();
            }
            None => words.push(piece.to_owned()),
        }
    }
    words.join(" ")
}

/// The word that stands for all that mean the same.
fn meant(word: &str) -> String {
    let own = stem(word);
    let mut rows = SYNONYMS.iter();
    let row = rows.find(|row| row.contains(&own.as_str()));
    row.map_or(own, |row| row[0].to_owned())
}

/// A word without its ending; a Greek letter by its name.
fn stem(word: &str) -> String {
    /// Shorter words have no endings.
    const MIN_LETTERS: usize = 4;
    if greek_word(word).is_some() || !word.chars().all(char::is_alphabetic) {
        return word.to_owned();
    }
    // `frequencies`
    if let Some(head) = word.strip_suffix("ies") {
        return format!("{head}y");
    }
    let mut own = word;
    for ends in SUFFIXES {
        let cut = ends.iter().find_map(|end| own.strip_suffix(end));
        if let Some(cut) =
            cut.filter(|cut| cut.chars().count() + 1 >= MIN_LETTERS && !own.ends_with("ss"))
        {
            own = cut;
        }
    }
    let mut letters = own.chars().rev();
    let is_doubled =
        own.len() < word.len() && !own.ends_with('s') && letters.next() == letters.next();
    own[..own.len() - usize::from(is_doubled && own.is_ascii())].to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_one_meaning_are_one() {
        for (one, other) in [
            ("elastically", "elastic"),
            ("dynamically", "dynamic"),
            ("inertia", "inertial"),
            ("lagging", "lags"),
            ("overdamped", "aperiodic"),
            ("pseudo periodic", "pseudo-periodic"),
            ("half cycles", "half-cycle"),
            ("in phase", "the in-phase"),
            ("K = 0", "K=0"),
            ("theta", "θ"),
            ("always", "at every"),
            ("frequencies", "frequency"),
            ("it crosses", "cross"),
        ] {
            assert!(
                Wording::of(one).is_same(&Wording::of(other)),
                "{one}, {other}: {:?} {:?}",
                Wording::of(one),
                Wording::of(other)
            );
        }
        for (one, other) in [
            ("stable", "unstable"),
            ("overdamped", "underdamped"),
            ("in phase", "out of phase"),
            ("half-cycles", "cycles"),
            ("static", "not static"),
            ("L = m", "L = 1/k"),
        ] {
            assert!(
                !Wording::of(one).is_same(&Wording::of(other)),
                "{one}, {other}"
            );
        }
    }

    #[test]
    fn synonyms_stand_in_the_table_once() {
        let mut all: Vec<&str> = SYNONYMS.concat();
        let count = all.len();
        all.sort_unstable();
        all.dedup();
        assert_eq!(all.len(), count);
    }
}
