//! Words, as responses and options are made of: without regard to case, spacing and the signs around them.

use super::letters::greek_word;
use super::words::{ANNOUNCEMENTS, ARTICLES, CLAUSES, DENIALS, DOUBTS, THINGS, WITHDRAWALS};
use super::{Folded, Passage, Wording};
use vibank_source::lower;

/// Letters of the shortest words that stand for others in another form than theirs.
const MIN_LETTERS: usize = 4;

/// Words in one spelling.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Phrase {
    typed: String,
    plain: String,
}

impl Phrase {
    /// The words of a text that is folded.
    pub fn of(typed: &str) -> Self {
        let words = typed.split_whitespace().collect::<Vec<_>>().join(" ");
        let words = words.trim_matches(['"', '\'']);
        Self {
            typed: typed.to_owned(),
            plain: lower(words.trim_end_matches(['.', '!', ',', ';', ':'])),
        }
    }

    /// The words of a text that is not folded.
    pub fn of_printed(text: &str) -> Self {
        let folded = Folded::of(text);
        Self::of(folded.as_ref().map_or(text, Folded::text))
    }

    /// As they were typed.
    pub fn typed(&self) -> &str {
        &self.typed
    }

    /// The passage that they are.
    pub fn passage(&self) -> Passage<'_> {
        Passage::of(&self.typed)
    }

    /// Whether they are those of a text in small letters.
    pub fn is(&self, words: &str) -> bool {
        self.plain == words
    }

    /// Whether both are the same words.
    pub fn is_same(&self, other: &Self) -> bool {
        self.plain == other.plain
    }

    /// Whether there are several.
    pub fn are_several(&self) -> bool {
        self.plain.contains(' ')
    }

    /// The letter that they are.
    pub fn letter(&self) -> Option<u8> {
        match self.plain.as_bytes() {
            [letter @ b'a'..=b'z'] => Some(*letter),
            _ => None,
        }
    }

    /// The letters of the only word, each once.
    pub fn letters(&self) -> Option<Vec<Self>> {
        let mut letters = self.plain.clone().into_bytes();
        vibank_dynamics::numerics::sort_by(&mut letters, Ord::cmp);
        let are_letters = letters.iter().all(u8::is_ascii_lowercase)
            && letters.windows(2).all(|pair| pair[0] != pair[1]);
        let each = || self.plain.split_inclusive(|_: char| true).map(Self::of);
        are_letters.then(|| each().collect())
    }

    /// The letters that dashes or slashes part, `c-b-a`, `c/b/a`.
    pub fn letters_apart(&self) -> Option<Vec<Self>> {
        let pieces: Vec<Self> = self.plain.split(['-', '/']).map(Self::of).collect();
        (pieces.len() > 1 && pieces.iter().all(|own| own.letter().is_some())).then_some(pieces)
    }

    /// Without the brackets around them.
    #[must_use]
    pub fn bare(&self) -> Self {
        Self::of(
            self.typed
                .trim_matches(|sign: char| "()[]{}. ".contains(sign)),
        )
    }

    /// Without the command of LaTeX that sets them, `\text{stable}`.
    #[must_use]
    pub fn without_face(&self) -> Self {
        let text = self.typed.trim();
        let mut inner = ["\\text{", "\\mathrm{", "\\textbf{"]
            .iter()
            .filter_map(|face| text.strip_prefix(face)?.strip_suffix('}'));
        let inner = inner.find(|inner| !inner.contains(['{', '}']));
        inner.map_or_else(|| self.clone(), Self::of)
    }

    /// What comes after words that say that an answer comes: `option b`, `answer: b`.
    #[must_use]
    pub fn announced(&self) -> Self {
        let text = self.typed.trim().trim_end_matches(['.', '!']);
        // `(option a)`, `(a).`
        let inner = text
            .strip_prefix('(')
            .and_then(|text| text.strip_suffix(')'));
        let inner = inner.filter(|inner| !inner.contains(['(', ')']));
        let text = inner.unwrap_or(text).trim();
        let text = text.trim_start_matches(['-', '=', ' ']);
        let rest = ANNOUNCEMENTS.iter().find_map(|word| {
            let head = text.get(..word.len())?;
            let behind = &text[word.len()..];
            // `only a`; before words it belongs to them.
            let is_it = *word != "only" || behind.trim().len() == 1;
            (head.eq_ignore_ascii_case(word) && is_it).then_some(behind)
        });
        let rest = rest.filter(|rest| rest.starts_with([' ', ':', '=']));
        Self::of(rest.map_or(text, |rest| rest.trim_start_matches([' ', ':', '='])))
    }

    /// A letter and the words after it, `a) overdamped`.
    pub fn labelled(&self) -> Option<(Self, Self)> {
        let found = self.typed.split_once([')', ':', '.']);
        let (letter, words) = found.or_else(|| self.typed.split_once(" - "))?;
        let label = letter.trim_matches(['(', ' ']).as_bytes();
        let is_label = matches!(label, [letter] if letter.is_ascii_alphabetic());
        (is_label && !words.trim().is_empty()).then(|| (Self::of(letter), Self::of(words)))
    }

    /// What is said of the thing that is asked about: `the motion is underdamped`, `it is stable`.
    pub fn said(&self) -> Option<Self> {
        // Words for an equals sign have become one.
        let mut signs = ["=", " is ", " are "].iter();
        let (thing, said) = signs.find_map(|sign| self.typed.split_once(sign))?;
        let thing = Self::of(thing).plain;
        let thing = thing.strip_prefix("the ").unwrap_or(&thing);
        THINGS.contains(&thing).then(|| Self::of(said.trim()))
    }

    /// What signs and words part that begin a reason or a correction: `ζ > 1, overdamped`, `elastic, not viscous`.
    pub fn clauses(&self) -> Vec<Self> {
        let parts = self.typed.split([',', ';', ':', '(', ')', '→', '⇒', '\n']);
        let parts = parts
            .flat_map(|part| part.split("->"))
            .flat_map(|part| part.split("=>"));
        let cut = |pieces: Vec<String>, word: &&str| -> Vec<String> {
            let cut = pieces
                .iter()
                .flat_map(|piece| piece.split(*word))
                .map(str::to_owned);
            cut.collect()
        };
        let parts = CLAUSES.iter().fold(parts.map(str::to_owned).collect(), cut);
        let parts = parts.iter().flat_map(|part| said_apart(part));
        let parts = parts.map(|part| part.trim_matches([' ', '=', '-', '.', '!']));
        parts
            .filter(|part| !part.is_empty())
            .map(Self::of)
            .collect()
    }

    /// Whether they compare symbols, `ζ > 1`, with no word beside them.
    pub fn compare(&self) -> bool {
        let is_word = |word: &str| {
            word.chars().filter(|char| char.is_alphabetic()).count() >= MIN_LETTERS
                && greek_word(word.trim_start_matches('\\')).is_none()
        };
        let mut words = self
            .plain
            .split(|char: char| char.is_whitespace() || "=<>≤≥".contains(char));
        self.relate() && !words.any(is_word)
    }

    /// Whether a sign of comparison stands in them.
    pub fn relate(&self) -> bool {
        self.plain.contains(['<', '>', '≤', '≥', '='])
    }

    /// What a clause denies, `not viscous`.
    pub fn denied(&self) -> Option<Self> {
        let own = self.plain.strip_prefix("and ").unwrap_or(&self.plain);
        own.strip_prefix("not ").map(Self::of)
    }

    /// The letter before words, `b lower the damping`, and the words.
    pub fn lettered(&self) -> Option<(Self, Self)> {
        let (letter, words) = self.plain.split_once(' ')?;
        let letter = Self::of(letter);
        letter.letter().is_some().then(|| (letter, Self::of(words)))
    }

    /// What the words mean.
    pub fn wording(&self) -> Wording {
        Wording::of(&self.typed)
    }

    /// These words and others after them.
    #[must_use]
    pub fn and(&self, other: &Self) -> Self {
        Self::of(&format!("{}, {}", self.typed, other.typed))
    }

    /// Whether a word takes back or leaves open what is said.
    pub fn are_doubtful(&self) -> bool {
        let mut words = self.plain.split(|char: char| !char.is_alphabetic());
        words.any(|word| DOUBTS.contains(&word) || WITHDRAWALS.contains(&word))
    }

    /// What comes after a word.
    pub fn behind(&self, word: &str) -> Option<Self> {
        let behind = self.typed.strip_prefix(word)?.strip_prefix(' ');
        behind.map(Self::of)
    }

    /// The phrases that signs, `and` and `&` part; the words where nothing does.
    pub fn parts(&self) -> Vec<Self> {
        // `above` that begins words has become a sign.
        if self.typed.trim_start().starts_with(['<', '>', '≤', '≥']) {
            return vec![self.clone()];
        }
        let parts = self.typed.split([',', ';', '>', '→', '\n']);
        let parts = parts.flat_map(|part| part.split(" - "));
        let parts = parts.flat_map(|part| part.split(" and "));
        let parts = parts.flat_map(|part| part.split(" then "));
        let parts = parts.flat_map(|part| part.split(" & ")).map(str::trim);
        let parts: Vec<&str> = parts.filter(|part| !part.is_empty()).collect();
        match parts[..] {
            [one] => one.split_whitespace().map(Self::of).collect(),
            _ => parts.into_iter().map(Self::of).collect(),
        }
    }

    /// Whether both are the same but for gaps, `under-damped` and `under damped`.
    pub fn is_joined_as(&self, other: &Self) -> bool {
        let own = self.joined();
        own.is_some() && own == other.joined()
    }

    /// Words as one; a formula keeps its signs.
    pub fn joined(&self) -> Option<Self> {
        let is_gap = |char: char| " -_".contains(char);
        // `a periodic` has an article.
        let are_words = !self.plain.starts_with("a ")
            && self
                .plain
                .chars()
                .all(|char| char.is_alphabetic() || is_gap(char));
        let word: String = self.plain.chars().filter(|char| !is_gap(*char)).collect();
        (are_words && word.chars().count() >= MIN_LETTERS).then(|| Self::of(&word))
    }

    /// Whether these words begin with others that are long enough to be told apart.
    pub fn begins_with(&self, words: &Self) -> bool {
        let rest = self.plain.strip_prefix(words.plain.as_str());
        words.plain.chars().count() >= MIN_LETTERS
            && rest.is_some_and(|rest| !rest.starts_with(char::is_alphanumeric))
    }

    /// The words without articles and signs.
    fn contents(&self) -> Vec<&str> {
        let signs = |char: char| char.is_whitespace() || "(),".contains(char);
        let words = self.plain.split(signs);
        words
            .filter(|word| !word.is_empty() && !ARTICLES.contains(word))
            .collect()
    }

    /// Whether one of the words is long enough to be told apart from letters.
    pub fn is_long(&self) -> bool {
        let mut words = self.contents().into_iter();
        words.any(|word| word.chars().count() >= MIN_LETTERS)
    }

    /// Whether both are the same words, articles and signs aside.
    pub fn has_contents_of(&self, other: &Self) -> bool {
        self.contents() == other.contents()
    }

    /// Whether other words stand in these.
    pub fn holds(&self, other: &Self) -> bool {
        let (own, other) = (self.contents(), other.contents());
        own.windows(other.len().max(1)).any(|run| run == other)
    }

    /// Whether words deny or join what others say: `decreases` is not "never decreases", nor `damped` "elastic and
    /// damped".
    pub fn changes(&self, other: &Self) -> bool {
        let other = other.contents();
        let mut own = self.contents().into_iter();
        own.any(|word| DENIALS.contains(&word) && !other.contains(&word))
    }

    /// Whether these words are others beside what is asked about: `elastic coupling`, `the displacement lags`.
    pub fn names(&self, other: &Self) -> bool {
        let (own, other) = (self.contents(), other.contents());
        let found = own.windows(other.len().max(1)).position(|run| run == other);
        found.is_some_and(|at| {
            let mut others = own[..at].iter().chain(&own[at + other.len()..]);
            others.all(|word| THINGS.contains(word))
        })
    }
}

/// The sides of an equals sign that stands for `is`, `upright = unstable`, and of a slash between words; those of a
/// formula, `L = m`, are one.
fn said_apart(text: &str) -> Vec<&str> {
    let is_long = |word: &str| {
        word.chars().count() > MIN_LETTERS
            && word.chars().all(|char| char.is_alphabetic() || char == '-')
    };
    let between = [" = ", "/"].into_iter().find_map(|sign| {
        let (before, behind) = text.split_once(sign)?;
        let last = before.rsplit(' ').next().is_some_and(is_long);
        let next = behind.split(' ').next().is_some_and(is_long);
        let is_apart = if sign == "/" {
            last && next
        } else {
            last || next
        };
        is_apart.then_some(vec![before, behind])
    });
    between.unwrap_or_else(|| vec![text])
}
