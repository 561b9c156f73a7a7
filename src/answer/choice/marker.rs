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
use crate::response::{Passage, Phrase, Senses};

/// Options, and what stands for them.
const ASSENTS: [(&str, &[&str]); 2] = [("yes", &["y", "true", "it does"]), ("no", &["n", "false"])];

/// The options of a part, whatever the data; places are those of the file.
#[derive(Debug)]
pub(crate) struct Options {
    pub(crate) ids: Vec<String>,
    pub(crate) words: Vec<Phrase>,
    /// As they stand in the file, LaTeX included.
    pub(crate) sources: Vec<Phrase>,
    /// As they are printed.
    pub(crate) texts: Vec<String>,
    /// What they say.
    pub(crate) senses: Senses,
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
            .or_else(|| {
                let mut all = ASSENTS.iter();
                let (own, _) = all.find(|(_, others)| others.iter().any(|other| bare.is(other)))?;
                self.of_words(&Phrase::of(own))
            })
            .or_else(|| self.of_formula(typed))
            .or_else(|| self.of_clauses(&bare))
            .or_else(|| self.of_letter(&bare.rank()?))
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
        let is_it = |own: &Phrase| Formula::of(own.passage()).is_some_and(|own| own.is(&typed));
        self.only(|place| {
            let own = &self.options.words[place];
            let is_one = own.statements().len() == 1;
            is_it(own) || is_one && own.clauses().iter().any(is_it)
        })
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
            .or_else(|| options.ids.iter().position(|id| words.is_called(id)))
            .or_else(|| options.words.iter().position(|own| own.is_joined_as(words)))
    }

    /// The option that is chosen in one's own words, with a reason or with what it is not: `ζ > 1, overdamped`,
    /// `elastic, not viscous`, `c) in series`.
    fn of_clauses(&self, typed: &Phrase) -> Option<usize> {
        /// Nobody explains a choice at this length.
        const MAX_LENGTH: usize = 300;
        if !typed.passage().is_shorter_than(MAX_LENGTH) {
            return None;
        }
        let senses = &self.options.senses;
        let relate = self.options.words.iter().any(Phrase::relate);
        let (mut said, mut letter, mut denied) = (Vec::new(), None, Vec::new());
        // Beside words a letter may be a symbol of theirs.
        let is_letter = |clause: &Phrase| {
            let is_alone = typed.letter().is_some();
            self.of_letter(clause).is_some() && (is_alone || !senses.know(clause))
        };
        for clause in typed.clauses() {
            if clause.compare() && !relate {
                continue;
            }
            // `not coupled` says no more than `not`.
            let is_idle = |words: &Phrase| senses.said(words).is_some_and(|own| own.is_empty());
            if let Some(other) = clause.denied().filter(|other| !is_idle(other)) {
                denied.push(
                    self.of_letter(&other)
                        .or_else(|| self.meant(&other, None))?,
                );
                continue;
            }
            let (own, words) = match clause.lettered() {
                Some((own, words)) if self.agrees(&own, &words) => (own, words),
                _ if is_letter(&clause) => (clause, Phrase::of("")),
                _ => (Phrase::of(""), clause),
            };
            if let Some(place) = self.of_letter(&own)
                && letter.replace(place).is_some_and(|before| before != place)
            {
                return None;
            }
            if senses.touches(&words) {
                said.push(senses.said(&words)?);
            } else if words.are_doubtful() || words.wording().denies() {
                return None;
            }
        }
        said.retain(|words| !words.is_empty());
        let found = if said.is_empty() {
            letter?
        } else {
            senses.chosen(&said, letter)?
        };
        (!denied.contains(&found)).then_some(found)
    }

    /// The option that words mean; of several that of a letter beside them.
    fn meant(&self, words: &Phrase, letter: Option<usize>) -> Option<usize> {
        let senses = &self.options.senses;
        senses.chosen(&[senses.said(words)?], letter)
    }

    /// Whether a letter and words are of one option.
    fn agrees(&self, letter: &Phrase, words: &Phrase) -> bool {
        let place = self.of_letter(letter);
        place.is_some_and(|place| self.meant(words, Some(place)).is_some())
    }

    /// Whether one option is to be chosen.
    fn is_one(&self) -> bool {
        !self.is_several && !self.is_ranking
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
        // Commas part several.
        let is_single = self.is_one() || response.clauses().len() == 1;
        if let Some(place) = self.place(&response).filter(|_| is_single) {
            return Ok(vec![place]);
        }
        let mut pieces = response.parts();
        // `acd`, where no option is called so.
        if let ([one], false) = (&pieces[..], self.is_one())
            && let Some(letters) = one.letters().or_else(|| one.letters_apart())
            && letters
                .iter()
                .all(|letter| self.of_letter(letter).is_some())
        {
            pieces = letters;
        }
        // `v_block > v_sphere`
        let of_index = |piece: &Phrase| self.place(&piece.index().filter(|_| self.is_ranking)?);
        let place = |piece: &Phrase| {
            let place = self.place(piece).or_else(|| of_index(piece));
            place.ok_or_else(|| piece.typed().to_owned())
        };
        let places: Vec<usize> = pieces.iter().map(place).collect::<Result<_, _>>()?;
        // `if K = 0 and a = 0` is not "if K = 0 or a = 0".
        let are_parts = self.is_one() && places.windows(2).all(|pair| pair[0] == pair[1]);
        if are_parts && pieces.iter().any(|piece| piece.letter().is_none()) {
            return Err(response.typed().to_owned());
        }
        Ok(places)
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
