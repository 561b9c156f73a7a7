//! Words, as responses and options are made of: without regard to case, spacing and the signs around them.

use super::letters::{Letters, greek_word, lowered};
use super::words::{ANNOUNCEMENTS, CLAUSES, DOUBTS, JOINTS, WITHDRAWALS};
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
        let words = words.trim_end_matches(['.', '!', ',', ';', ':']);
        let mut plain = String::new();
        for char in lower(words).chars() {
            match lowered(char) {
                Some(index) => plain.extend(['_', index]),
                None => plain.push(char),
            }
        }
        Self {
            typed: typed.to_owned(),
            plain,
        }
    }

    /// The words of a text that is not folded.
    pub fn unfolded(text: &str) -> Self {
        let folded = Folded::of(text);
        Self::of(folded.as_ref().map_or(text, Folded::text))
    }

    /// The words of a text that is printed. What stands before a colon is part of it.
    pub fn of_printed(text: &str) -> Self {
        let pieces = text.split(": ").map(|piece| Self::unfolded(piece).typed);
        Self::of(&pieces.collect::<Vec<_>>().join(": "))
    }

    /// As they were typed.
    pub fn typed(&self) -> &str {
        &self.typed
    }

    /// The passage that they are.
    pub fn passage(&self) -> Passage<'_> {
        Passage::of(&self.typed)
    }

    /// The single words, with their endings.
    pub(crate) fn spellings(&self) -> impl Iterator<Item = String> {
        let words = self
            .plain
            .split(|char: char| !char.is_alphabetic() && char != '-');
        words
            .map(|word| word.replace('-', ""))
            .filter(|word| !word.is_empty())
    }

    /// Whether they are those of a text in small letters.
    pub fn is(&self, words: &str) -> bool {
        self.plain == words
    }

    /// Whether both are the same words.
    pub fn is_same(&self, other: &Self) -> bool {
        self.plain == other.plain
    }

    /// Whether they are a name, in any of its spellings: `θ` and `theta`.
    pub fn is_called(&self, name: &str) -> bool {
        let own = self.plain.trim_start_matches('\\');
        self.is(&lower(name))
            || Letters::spelling(own).is_some_and(|own| Some(own) == Letters::spelling(name))
    }

    /// The index of the symbol that they are, `block` of `v_block`.
    pub fn index(&self) -> Option<Self> {
        let (symbol, index) = self.plain.split_once('_')?;
        let is_letter = Self::of(symbol).letter().is_some();
        is_letter.then(|| Self::of(index.trim_matches(['{', '}'])))
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

    /// The letter of the place that they are, `second`, `the first option`.
    pub fn rank(&self) -> Option<Self> {
        const RANKS: [&str; 5] = ["first", "second", "third", "fourth", "fifth"];
        let words = self.plain.split(' ');
        let mut words = words.filter(|word| !matches!(*word, "the" | "option" | "answer" | "one"));
        let rank = words.next().filter(|_| words.next().is_none())?;
        let place = RANKS.iter().position(|own| *own == rank)?;
        Some(Self::of(&char::from(b'a' + place as u8).to_string()))
    }

    /// The letters of the only word, each once.
    pub fn letters(&self) -> Option<Vec<Self>> {
        let mut letters = self.plain.clone().into_bytes();
        vibank_dynamics::numerics::sort_by(&mut letters, Ord::cmp);
        let are_letters = letters.iter().all(u8::is_ascii_lowercase)
            && letters.windows(2).all(|pair| pair[0] != pair[1]);
        let each = self.plain.split_inclusive(|_: char| true).map(Self::of);
        are_letters.then(|| each.collect())
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

    /// What is said at once, between words that join and equals signs that stand for `is`; `or` is a statement of its own.
    pub fn statements(&self) -> Vec<Self> {
        let text = self.typed.replace(" or ", " and or and ");
        of_pieces(pieces(&text, JOINTS))
    }

    /// What signs and words part that join or begin a reason or a correction: `ζ > 1, overdamped`, `elastic, not viscous`.
    pub fn clauses(&self) -> Vec<Self> {
        let statements = self.statements();
        let parts = statements.iter().flat_map(|own| {
            let parts = own.typed.split([',', ';', ':', '(', ')', '→', '⇒', '\n']);
            parts.flat_map(|part| pieces(part, CLAUSES))
        });
        of_pieces(parts.collect())
    }

    /// Whether they compare symbols, `ζ > 1`, with no word beside them.
    pub fn compare(&self) -> bool {
        let mut words = self
            .plain
            .split(|char: char| char.is_whitespace() || "=<>≤≥".contains(char));
        self.relate()
            && words.all(|word| {
                word.chars().filter(|char| char.is_alphabetic()).count() < MIN_LETTERS
                    || greek_word(word.trim_start_matches('\\')).is_some()
                    || word.contains('_')
            })
    }

    /// Whether a sign of comparison stands in them.
    pub fn relate(&self) -> bool {
        self.plain.contains(['<', '>', '≤', '≥', '='])
    }

    /// What a clause denies, `not viscous`; `not stable` says what it is.
    pub fn denied(&self) -> Option<Self> {
        let denied = self.plain.strip_prefix("not ");
        denied.filter(|_| self.wording().denies()).map(Self::of)
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
        let parts = self.typed.split([',', ';', '>', '≥', '→', '|', '\n']);
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

    /// Whether both are the same but for gaps, `under-damped` and `under damped`, `Ω > √2 ω` and `Ω > √2ω`.
    pub fn is_joined_as(&self, other: &Self) -> bool {
        let own = self.joined();
        let signs = |phrase: &'_ Self| phrase.plain.replace(' ', "");
        own.is_some() && own == other.joined() || self.relate() && signs(self) == signs(other)
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

    /// Whether these words begin with others that are long enough to be told apart, and leave no other way open.
    pub fn begins_with(&self, words: &Self) -> bool {
        let rest = self.plain.strip_prefix(words.plain.as_str());
        words.plain.chars().count() >= MIN_LETTERS
            && rest.is_some_and(|rest| {
                !rest.starts_with(char::is_alphanumeric) && !rest.contains(" or ")
            })
    }
}

/// The phrases of pieces that say something.
fn of_pieces(pieces: Vec<&str>) -> Vec<Phrase> {
    let pieces = pieces.into_iter().flat_map(said_apart);
    let pieces = pieces.map(|piece| piece.trim_matches([' ', '=', '-', '.', '!']));
    let pieces = pieces.filter(|piece| !piece.is_empty());
    pieces.map(Phrase::of).collect()
}

/// What words part.
fn pieces<'t>(text: &'t str, words: &[&str]) -> Vec<&'t str> {
    words.iter().fold(vec![text], |pieces, word| {
        let pieces = pieces.into_iter();
        pieces.flat_map(|piece| piece.split(*word)).collect()
    })
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
        let last = before.trim_end().rsplit(' ').next().is_some_and(is_long);
        let next = behind.trim_start().split(' ').next().is_some_and(is_long);
        let is_apart = if sign == "/" {
            last && next
        } else {
            last || next
        };
        is_apart.then_some(vec![before, behind])
    });
    between.unwrap_or_else(|| vec![text])
}
