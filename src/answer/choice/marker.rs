//! Marks what was chosen.

use std::sync::Arc;

use crate::answer::{
    Answered, Credit, Key, KeyValue, Marker, Marking, Nature, Reading, Remark, Slip, Trial,
    Unreadable, Why,
};
use crate::document::Document;
use crate::math::Math;
use crate::numerics::Rational;
use crate::response::{Passage, Phrase};

/// The options of a part, whatever the data; places are those of the file.
#[derive(Debug)]
pub(crate) struct Options {
    pub(crate) ids: Vec<String>,
    pub(crate) words: Vec<Phrase>,
    /// As they stand in the file, LaTeX included.
    pub(crate) sources: Vec<Phrase>,
    /// As they are printed.
    pub(crate) texts: Vec<String>,
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
