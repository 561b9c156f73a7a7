//! Reads what was chosen: letters as printed, words of options.

use super::formula::Formula;
use super::marker::Chosen;
use crate::response::{Passage, Phrase};

/// The options `yes` and `no`, and those that other languages have nearly alike, in other words.
const ASSENTS: [(&str, &[&str]); 4] = [
    (
        "unstable",
        &["not stable", "instable", "instabil", "inestable"],
    ),
    ("stable", &["stabil", "estable"]),
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

impl Chosen {
    /// The place in the file of what was typed: a letter as printed, the words of an option, or an id.
    fn place(&self, typed: &Phrase) -> Option<usize> {
        // `a) overdamped`: letter and words have to agree.
        if let Some((letter, words)) = typed.labelled() {
            return self
                .place(&letter)
                .filter(|place| self.place(&words) == Some(*place));
        }
        let bare = typed.bare();
        self.of_letter(&bare)
            .or_else(|| self.of_words(typed))
            .or_else(|| self.of_words(&bare))
            .or_else(|| self.only(|place| self.options.words[place].begins_with(&bare)))
            .or_else(|| self.of_words_within(&bare))
            .or_else(|| self.of_words_within(&bare.joined()?))
            .or_else(|| self.of_words_beside(&bare))
            .or_else(|| {
                let (own, _) = ASSENTS
                    .iter()
                    .find(|(_, others)| others.iter().any(|other| bare.is(other)))?;
                self.of_words(&Phrase::of(own))
            })
            .or_else(|| self.of_formula(typed))
    }

    /// The one option of which something holds.
    fn only(&self, holds: impl Fn(usize) -> bool) -> Option<usize> {
        let mut found = (0..self.options.ids.len()).filter(|place| holds(*place));
        let first = found.next()?;
        found.next().is_none().then_some(first)
    }

    /// The only option that is this formula, however it is written.
    fn of_formula(&self, typed: &Phrase) -> Option<usize> {
        /// No option has a formula this long.
        const MAX_LENGTH: usize = 300;
        let typed = Some(typed.passage()).filter(|typed| typed.is_shorter_than(MAX_LENGTH))?;
        let typed = Formula::of(typed)?;
        let texts = self.options.texts.iter();
        let formulas: Vec<Option<Formula>> = texts.map(|text| Formula::of_printed(text)).collect();
        self.only(|place| formulas[place].as_ref().is_some_and(|own| own.is(&typed)))
    }

    /// The option that bears a letter.
    fn of_letter(&self, word: &Phrase) -> Option<usize> {
        self.order.get(usize::from(word.letter()? - b'a')).copied()
    }

    /// The option that reads so, however it is spaced, in the file or as it is printed, or that is called so there.
    fn of_words(&self, words: &Phrase) -> Option<usize> {
        let options = &self.options;
        let same = |own: &Phrase| own.is_same(words);
        let printed = options.words.iter().position(same);
        printed
            .or_else(|| options.sources.iter().position(same))
            .or_else(|| options.ids.iter().position(|id| same(&Phrase::of(id))))
            .or_else(|| options.words.iter().position(|own| own.is_joined_as(words)))
    }

    /// The only option in which these words stand, `inductance` for "the inductance L", articles aside.
    fn of_words_within(&self, words: &Phrase) -> Option<usize> {
        let own = |place: usize| &self.options.words[place];
        self.only(|place| own(place).has_contents_of(words))
            .or_else(|| {
                let holds = self.only(|place| own(place).holds(words));
                holds.filter(|place| !own(*place).changes(words))
            })
            .filter(|_| words.is_long())
    }

    /// The only option whose words were typed beside what is asked about: `elastic coupling`, `the displacement lags`.
    fn of_words_beside(&self, words: &Phrase) -> Option<usize> {
        let options = &self.options;
        self.only(|place| {
            words.names(&options.words[place]) || words.names(&Phrase::of(&options.ids[place]))
        })
    }

    /// All that was typed, or what of it is not an option.
    pub(crate) fn places(&self, response: Passage<'_>) -> Result<Vec<usize>, String> {
        let response = response.words().without_face();
        // All words of an option are it, also those that could announce one: `only if K = 0`. One word may be a letter.
        if let Some(place) = self.of_all_words(&response) {
            return Ok(vec![place]);
        }
        let response = response.announced();
        if self.is_several && response.is("none") {
            return Ok(Vec::new());
        }
        let only = || self.of_words(&response.behind("only")?);
        let place = self
            .place(&response)
            .or_else(|| self.place(&response.said()?))
            .or_else(only);
        if let Some(place) = place {
            return Ok(vec![place]);
        }
        let mut pieces = response.parts();
        // `acd`, where no option is called so.
        if let ([one], true) = (&pieces[..], self.is_several || self.is_ranking)
            && let Some(letters) = one.letters().or_else(|| one.letters_apart())
            && letters
                .iter()
                .all(|letter| self.of_letter(letter).is_some())
        {
            pieces = letters;
        }
        let place = |piece: &Phrase| self.place(piece).ok_or_else(|| piece.typed().to_owned());
        pieces.iter().map(place).collect()
    }

    /// The option with all of these words.
    fn of_all_words(&self, words: &Phrase) -> Option<usize> {
        let mut all = [&self.options.words, &self.options.sources].into_iter();
        let found = all.find_map(|all| all.iter().position(|own| own.is_same(words)));
        found.filter(|_| words.are_several())
    }
}
