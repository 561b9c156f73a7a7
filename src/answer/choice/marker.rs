//! Reads and marks what was chosen: letters as printed, words of options.

use std::sync::Arc;

use super::formula::Formula;
use crate::answer::{
    Answered, Credit, Key, KeyValue, Marker, Marking, Nature, Reading, Remark, Slip, Trial,
    Unreadable, Why,
};
use crate::document::Document;
use crate::math::Math;
use crate::numerics::Rational;
use crate::response::{Passage, Phrase, Wording};

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

/// The options of a part, whatever the data; places are those of the file.
#[derive(Debug)]
pub(crate) struct Options {
    pub(crate) ids: Vec<String>,
    pub(crate) words: Vec<Phrase>,
    /// As they stand in the file, LaTeX included.
    pub(crate) sources: Vec<Phrase>,
    /// As they are printed.
    pub(crate) texts: Vec<String>,
    /// What the words mean, without and with those of the ids.
    pub(crate) meanings: Vec<Wording>,
    pub(crate) named: Vec<Wording>,
    /// Their own words, with those of the ids.
    pub(crate) literal: Vec<Wording>,
    /// The words of the question, which say nothing beside an option.
    pub(crate) asked: Wording,
    pub(crate) feedback: Vec<Option<Document>>,
}

/// A prepared key.
pub(crate) struct Chosen {
    pub(crate) options: Arc<Options>,
    pub(crate) right: Vec<bool>,
    pub(crate) order: Vec<usize>,
    pub(crate) is_several: bool,
    pub(crate) is_ranking: bool,
}

impl Chosen {
    fn letter(&self, place: usize) -> char {
        let position = self
            .order
            .iter()
            .position(|own| *own == place)
            .unwrap_or(place);
        (b'a' + position as u8) as char
    }

    /// What was chosen: by the letters that are printed and the texts of the options; by ids for programs.
    fn reading(&self, places: &[usize]) -> Reading {
        let ids: Vec<String> = places
            .iter()
            .map(|at| self.options.ids[*at].clone())
            .collect();
        let texts: Vec<&str> = places
            .iter()
            .map(|at| self.options.texts[*at].as_str())
            .collect();
        Reading {
            math: self.letters(places),
            text: texts.join("; "),
            answered: Answered::Options(ids),
        }
    }

    /// The printed letters of options.
    fn letters(&self, places: &[usize]) -> Math {
        let letters = places.iter().map(|place| self.letter(*place).to_string());
        Math::text(letters.collect::<Vec<_>>().join(", "))
    }

    fn remark(&self, place: usize) -> Option<Remark> {
        self.options.feedback[place].clone().map(Remark::Option)
    }

    fn mark_one(&self, places: &[usize]) -> Marking {
        let mut places = places.to_vec();
        places.dedup();
        let [place] = &places[..] else {
            return Marking::unreadable(Why::OneOption);
        };
        let reading = self.reading(&places);
        if self.right[*place] {
            return Marking::right(reading);
        }
        Marking::wrong(reading, self.remark(*place))
    }

    fn mark_several(&self, places: &[usize]) -> Marking {
        let agree = (0..self.right.len())
            .filter(|place| self.right[*place] == places.contains(place))
            .count();
        let differ = self.right.len() - agree;
        let share = Rational::new(
            agree.saturating_sub(differ) as i128,
            self.right.len() as i128,
        );
        let credit = share.and_then(Credit::new).unwrap_or(Credit::NONE);
        let mut marking = Marking::read(self.reading(places), credit, None);
        let wrong = places.iter().filter(|place| !self.right[**place]);
        marking
            .remarks
            .extend(wrong.filter_map(|place| self.remark(*place)));
        marking
    }

    /// The pairs of neighbours in the right order count.
    fn mark_ranking(&self, places: &[usize]) -> Marking {
        let mut seen = places.to_vec();
        crate::numerics::sort_by(&mut seen, Ord::cmp);
        seen.dedup();
        if seen.len() != self.options.ids.len() || places.len() != self.options.ids.len() {
            return Marking::unreadable(Why::Ranking(self.options.ids.len()));
        }
        let ordered = places.windows(2).filter(|pair| pair[0] < pair[1]).count();
        let all = places.len() - 1;
        let credit = Rational::new(ordered as i128, all as i128)
            .and_then(Credit::new)
            .unwrap_or(Credit::NONE);
        let is_reversed = ordered == 0 && all > 1;
        let remark = is_reversed.then_some(Remark::Slip(Slip::Reversed));
        Marking::read(self.reading(places), credit, remark)
    }
}

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

    /// The only option that words mean, in their order; of several the one that bears a letter beside them. As they stand
    /// they come before words of the same meaning.
    fn of_meaning(&self, words: &Phrase, letter: Option<usize>) -> Option<usize> {
        let text = words.typed();
        let options = &self.options;
        self.of_wording(&Wording::literal(text), &options.literal, letter)
            .or_else(|| self.of_wording(&Wording::of(text), &options.named, letter))
    }

    fn of_wording(
        &self,
        words: &Wording,
        named: &[Wording],
        letter: Option<usize>,
    ) -> Option<usize> {
        let options = &self.options;
        let known = words.known_among(named, &options.asked)?;
        if known.is_empty() {
            return None;
        }
        if let Some(letter) = letter {
            return known.is_within(&named[letter]).then_some(letter);
        }
        let found = self.only(|place| known.is_same(&options.meanings[place]));
        let found = found.or_else(|| self.only(|place| known.is_run_of(&named[place])));
        let found = found.or_else(|| self.only(|place| known.is_within(&named[place])))?;
        let others = (0..options.ids.len()).filter(|place| *place != found);
        let others: Vec<&Wording> = others.map(|place| &named[place]).collect();
        (!known.leaves_out(&named[found], &others)).then_some(found)
    }

    /// The option that is chosen in one's own words, with a reason or with what it is not: `ζ > 1, overdamped`,
    /// `elastic, not viscous`, `c) in series`.
    fn of_clauses(&self, typed: &Phrase) -> Option<usize> {
        /// Nobody explains a choice at this length.
        const MAX_LENGTH: usize = 300;
        if !typed.passage().is_shorter_than(MAX_LENGTH) {
            return None;
        }
        let options = &self.options;
        let relate = options.words.iter().any(Phrase::relate);
        let (mut said, mut letter, mut denied) = (None::<Phrase>, None, Vec::new());
        for clause in typed.clauses() {
            if clause.compare() && !relate {
                continue;
            }
            if let Some(other) = clause.denied() {
                let place = self.of_letter(&other);
                denied.push(place.or_else(|| self.of_meaning(&other, None))?);
                continue;
            }
            let is_open = clause.are_doubtful() || clause.wording().denies();
            let (own, words) = match clause.lettered() {
                Some((own, words)) if self.agrees(&own, &words) => (own, words),
                _ if clause.letter().is_some() => (clause, Phrase::of("")),
                _ => (Phrase::of(""), clause),
            };
            if let Some(place) = self.of_letter(&own)
                && letter.replace(place).is_some_and(|before| before != place)
            {
                return None;
            }
            if words.wording().touches(&options.named) {
                said = Some(said.map_or_else(|| words.clone(), |said| said.and(&words)));
            } else if is_open {
                return None;
            }
        }
        let found = match said {
            Some(said) => self.of_meaning(&said, letter)?,
            None => letter?,
        };
        (!denied.contains(&found)).then_some(found)
    }

    /// Whether a letter and words are of one option.
    fn agrees(&self, letter: &Phrase, words: &Phrase) -> bool {
        let place = self.of_letter(letter);
        place.is_some_and(|place| self.of_meaning(words, Some(place)).is_some())
    }

    /// All that was typed, or what of it is not an option.
    fn places(&self, response: Passage<'_>) -> Result<Vec<usize>, String> {
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
        let is_one = !self.is_several && !self.is_ranking;
        let place = place.or_else(|| self.of_clauses(&response).filter(|_| is_one));
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

impl Marker for Chosen {
    fn trials(&self) -> Vec<Trial> {
        let all: Vec<usize> = (0..self.options.ids.len()).collect();
        let letters = |places: &[usize]| {
            let letters = places.iter().map(|place| self.letter(*place).to_string());
            letters.collect::<Vec<_>>().join(", ")
        };
        let (right, wrong): (Vec<usize>, Vec<usize>) =
            all.iter().copied().partition(|place| self.right[*place]);
        let (right, wrong) = match (self.is_ranking, self.is_several) {
            (true, _) => (all.clone(), all.iter().rev().copied().collect()),
            (false, true) => (right, wrong),
            (false, false) => (
                right.into_iter().take(1).collect(),
                wrong.into_iter().take(1).collect(),
            ),
        };
        let mut trials = vec![Trial::new(Nature::Unreadable, "zz9")];
        if !right.is_empty() {
            trials.push(Trial::new(Nature::Right, letters(&right)));
            let loud = letters(&right).to_ascii_uppercase().replace(',', ";");
            trials.push(Trial::new(Nature::Borderline, loud));
        }
        if !wrong.is_empty() {
            trials.push(Trial::new(Nature::Wrong, letters(&wrong)));
        }
        trials
    }

    fn key(&self) -> Key {
        let places: Vec<usize> = if self.is_ranking {
            (0..self.options.ids.len()).collect()
        } else {
            (0..self.options.ids.len())
                .filter(|place| self.right[*place])
                .collect()
        };
        let ids = places
            .iter()
            .map(|place| self.options.ids[*place].clone())
            .collect();
        let is_list = self.is_several || self.is_ranking;
        Key {
            math: self.letters(&places),
            accepted: None,
            value: KeyValue::Options { ids, is_list },
        }
    }

    fn mark(&self, response: Passage<'_>) -> Marking {
        let places = match self.places(response) {
            Ok(places) => places,
            Err(unknown) => {
                let last = self.letter(self.order[self.order.len() - 1]);
                let shown: String = unknown.chars().take(40).collect();
                return Marking::unreadable(Unreadable::at(shown, Why::NoOption(last)));
            }
        };
        match (self.is_ranking, self.is_several) {
            (true, _) => self.mark_ranking(&places),
            (false, true) => self.mark_several(&places),
            (false, false) => self.mark_one(&places),
        }
    }
}
