//! Reads what was chosen: letters as printed, words of options.

use super::formula::Formula;
use super::marker::Chosen;
use crate::response::Folded;
use crate::source::lower;

/// The words of an option as those of a response are compared with them.
pub(crate) fn words(option: &str) -> String {
    let folded = Folded::of(option);
    normalized(folded.as_ref().map_or(option, Folded::text))
}

/// Words without regard to case and spacing.
pub(crate) fn normalized(text: &str) -> String {
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let words = words.trim_matches(['"', '\'']);
    lower(words.trim_end_matches(['.', '!', ',', ';', ':']))
}

/// Letters of the shortest words that stand for an option in another form than its own.
const MIN_LETTERS: usize = 4;

/// The words of a text without articles and signs.
fn contents(text: &str) -> Vec<&str> {
    const ARTICLES: [&str; 3] = ["the", "a", "an"];
    let words = text.split(|char: char| char.is_whitespace() || "(),".contains(char));
    words
        .filter(|word| !word.is_empty() && !ARTICLES.contains(word))
        .collect()
}

/// The one thing that there is.
fn only<T>(mut found: impl Iterator<Item = T>) -> Option<T> {
    let first = found.next()?;
    found.next().is_none().then_some(first)
}

/// Words as one, `under-damped` and `under damped`; a formula keeps its signs.
fn joined(text: &str) -> Option<String> {
    let is_gap = |char: char| " -_".contains(char);
    // `a periodic` has an article.
    let is_of_words = !text.starts_with("a ")
        && text
            .chars()
            .all(|char| char.is_alphabetic() || is_gap(char));
    let word: String = text.chars().filter(|char| !is_gap(*char)).collect();
    (is_of_words && word.chars().count() >= MIN_LETTERS).then_some(word)
}

/// Words without the command of LaTeX that sets them, `\text{stable}`.
fn without_face(text: &str) -> &str {
    let inner = ["\\text{", "\\mathrm{", "\\textbf{"].iter();
    let mut inner = inner.filter_map(|face| text.trim().strip_prefix(face)?.strip_suffix('}'));
    inner
        .find(|inner| !inner.contains(['{', '}']))
        .unwrap_or(text)
}

/// What comes after words that say that an answer comes: `option b`, `answer: b`.
fn announced(text: &str) -> &str {
    const WORDS: &[&str] = &[
        "the answer is",
        "answer is",
        "answer",
        "option",
        "choice",
        "letter",
        "only",
    ];
    let text = text.trim().trim_end_matches(['.', '!']);
    // `(option a)`, `(a).`
    let inner = text
        .strip_prefix('(')
        .and_then(|text| text.strip_suffix(')'));
    let text = inner
        .filter(|inner| !inner.contains(['(', ')']))
        .unwrap_or(text);
    let text = text.trim().trim_start_matches(['-', '=', ' ']);
    let rest = WORDS.iter().find_map(|word| {
        let rest = text
            .get(..word.len())
            .filter(|head| head.eq_ignore_ascii_case(word));
        let behind = rest.map(|_| &text[word.len()..]);
        // `only a`; before words it belongs to them.
        behind.filter(|behind| *word != "only" || behind.trim().len() == 1)
    });
    match rest {
        Some(rest) if rest.starts_with([' ', ':', '=']) => rest.trim_start_matches([' ', ':', '=']),
        _ => text,
    }
}

/// What is asked about, as people name it beside their choice.
const THINGS: &[&str] = &[
    "motion",
    "system",
    "oscillator",
    "oscillation",
    "regime",
    "response",
    "equilibrium",
    "position",
    "damping",
    "displacement",
    "coupling",
    "behind",
    "case",
    "it",
    "this",
    "they",
];

/// What is said of the thing that is asked about: `the motion is underdamped`, `it is stable`.
fn said(text: &str) -> Option<&str> {
    // Words for an equals sign have become one.
    let mut signs = ["=", " is ", " are "].iter();
    let (thing, said) = signs.find_map(|sign| text.split_once(sign))?;
    let thing = normalized(thing);
    let thing = thing.strip_prefix("the ").unwrap_or(&thing);
    THINGS.contains(&thing).then(|| said.trim())
}

impl Chosen {
    /// The place in the file of what was typed: a letter as printed, the words of an option, or an id.
    fn place(&self, typed: &str) -> Option<usize> {
        // `a) overdamped`: letter and words have to agree.
        let both = typed
            .split_once([')', ':', '.'])
            .or_else(|| typed.split_once(" - "));
        if let Some((letter, words)) = both
            && matches!(letter.trim_matches(['(', ' ']).as_bytes(), [letter] if letter.is_ascii_alphabetic())
            && !words.trim().is_empty()
        {
            return self
                .place(letter)
                .filter(|place| self.place(words) == Some(*place));
        }
        let whole = normalized(typed);
        let bare = normalized(typed.trim_matches(|sign: char| "()[]{}. ".contains(sign)));
        self.of_letter(&bare)
            .or_else(|| self.of_words(&whole))
            .or_else(|| self.of_words(&bare))
            .or_else(|| self.of_first_words(&bare))
            .or_else(|| self.of_words_within(&bare))
            .or_else(|| self.of_words_within(&joined(&bare)?))
            .or_else(|| self.of_words_beside(&bare))
            .or_else(|| self.of_assent(&bare))
            .or_else(|| self.of_formula(typed))
    }

    /// The only option that is this formula, however it is written.
    fn of_formula(&self, typed: &str) -> Option<usize> {
        /// No option has a formula this long.
        const MAX_LENGTH: usize = 300;
        let typed = Some(typed).filter(|typed| typed.len() <= MAX_LENGTH);
        let typed = Formula::of(typed?)?;
        let formulas: Vec<Option<Formula>> = self
            .options
            .texts
            .iter()
            .map(|text| Formula::of(text))
            .collect();
        let is_it = |place: &usize| formulas[*place].as_ref().is_some_and(|own| own.is(&typed));
        only((0..formulas.len()).filter(is_it))
    }

    /// The option that bears a letter.
    fn of_letter(&self, word: &str) -> Option<usize> {
        let [letter @ b'a'..=b'z'] = word.as_bytes() else {
            return None;
        };
        self.order.get(usize::from(letter - b'a')).copied()
    }

    /// The option that reads so, however it is spaced, or that is called so in the file.
    fn of_words(&self, words: &str) -> Option<usize> {
        let place = |is_it: &dyn Fn(&String) -> bool| self.options.words.iter().position(is_it);
        place(&|own| own == words)
            .or_else(|| {
                self.options
                    .ids
                    .iter()
                    .position(|id| normalized(id) == words)
            })
            .or_else(|| {
                let word = joined(words)?;
                place(&|own| joined(own).as_ref() == Some(&word))
            })
    }

    /// The only option that begins with these words.
    fn of_first_words(&self, words: &str) -> Option<usize> {
        let begins = |own: &String| {
            let rest = own.strip_prefix(words);
            rest.is_some_and(|rest| !rest.starts_with(char::is_alphanumeric))
        };
        let found =
            (0..self.options.words.len()).filter(|place| begins(&self.options.words[*place]));
        only(found).filter(|_| words.chars().count() >= MIN_LETTERS)
    }

    /// The only option in which these words stand, `inductance` for "the inductance L", articles aside. Not within a
    /// denial or beside others: `decreases` is not "never decreases", nor `damped` "elastic and damped".
    fn of_words_within(&self, words: &str) -> Option<usize> {
        const JOINTS: [&str; 8] = [
            "not", "no", "never", "without", "neither", "nor", "and", "or",
        ];
        let typed = contents(words);
        let stands = |place: &usize| {
            let own = contents(&self.options.words[*place]);
            let mut runs = own.windows(typed.len().max(1));
            runs.any(|run| run == typed)
        };
        let is_joined = |place: &usize| {
            let own = contents(&self.options.words[*place]);
            own.iter()
                .any(|word| JOINTS.contains(word) && !typed.contains(word))
        };
        let is_all = |place: &usize| contents(&self.options.words[*place]) == typed;
        let places = || 0..self.options.words.len();
        let is_long = typed.iter().any(|word| word.chars().count() >= MIN_LETTERS);
        only(places().filter(is_all))
            .or_else(|| only(places().filter(stands)).filter(|place| !is_joined(place)))
            .filter(|_| is_long)
    }

    /// The only option whose words were typed beside what is asked about: `elastic coupling`, `the displacement lags`.
    fn of_words_beside(&self, words: &str) -> Option<usize> {
        let typed = contents(words);
        let stands = |own: &[&str]| {
            let run = typed.windows(own.len().max(1)).position(|run| run == own);
            run.is_some_and(|at| {
                let mut others = typed[..at].iter().chain(&typed[at + own.len()..]);
                others.all(|word| THINGS.contains(word))
            })
        };
        let is_it = |place: &usize| {
            let id = normalized(&self.options.ids[*place]);
            stands(&contents(&self.options.words[*place])) || stands(&[id.as_str()])
        };
        only((0..self.options.words.len()).filter(is_it))
    }

    /// The option `yes` or `no` in another language.
    fn of_assent(&self, word: &str) -> Option<usize> {
        const WORDS: [(&str, &[&str]); 2] = [
            (
                "yes",
                &["y", "oui", "ja", "sí", "true", "it does", "yes, it does"],
            ),
            (
                "no",
                &[
                    "n",
                    "non",
                    "nein",
                    "false",
                    "it does not",
                    "no, it does not",
                ],
            ),
        ];
        let (own, _) = WORDS.iter().find(|(_, others)| others.contains(&word))?;
        self.of_words(own)
    }

    /// All that was typed, or what of it is not an option.
    pub(crate) fn places(&self, response: &str) -> Result<Vec<usize>, String> {
        let response = without_face(response);
        // All words of an option are it, also those that could announce one: `only if K = 0`. One word may be a letter.
        let whole = normalized(response);
        let is_it = |words: &&String| whole.contains(' ') && **words == whole;
        if let Some(place) = self.options.words.iter().position(|words| is_it(&words)) {
            return Ok(vec![place]);
        }
        let response = announced(response);
        if self.is_several && normalized(response) == "none" {
            return Ok(Vec::new());
        }
        if let Some(place) = self.place(response) {
            return Ok(vec![place]);
        }
        if let Some(place) = said(response).and_then(|said| self.place(said)) {
            return Ok(vec![place]);
        }
        let only = response.strip_prefix("only ");
        if let Some(place) = only.and_then(|rest| self.of_words(&normalized(rest))) {
            return Ok(vec![place]);
        }
        let separated = response
            .split([',', ';', '>', '→', '\n'])
            .flat_map(|piece| piece.split(" and "))
            .flat_map(|piece| piece.split(" & "));
        let pieces: Vec<&str> = separated
            .map(str::trim)
            .filter(|piece| !piece.is_empty())
            .collect();
        let pieces = match pieces[..] {
            [one] if one.contains(' ') => one.split_whitespace().collect(),
            // `acd`, where no option is called so.
            [one] if self.are_letters(one) => one
                .char_indices()
                .map(|(at, letter)| &one[at..at + letter.len_utf8()])
                .collect(),
            _ => pieces,
        };
        pieces
            .into_iter()
            .map(|piece| self.place(piece).ok_or_else(|| piece.to_owned()))
            .collect()
    }

    /// Whether a word is a run of printed letters, each once, where several are asked.
    fn are_letters(&self, word: &str) -> bool {
        let last = b'a' + (self.options.ids.len() - 1) as u8;
        let mut letters = word.to_ascii_lowercase().into_bytes();
        crate::numerics::sort_by(&mut letters, Ord::cmp);
        (self.is_several || self.is_ranking)
            && letters.iter().all(|letter| (b'a'..=last).contains(letter))
            && letters.windows(2).all(|pair| pair[0] != pair[1])
    }
}
