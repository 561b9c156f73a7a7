//! `choice`: one or several of the listed answers.
//!
//! The student types the letter that is printed, `b`, or the word, `overdamped`; several are joined by
//! commas, `a, c`. Options are shuffled by the seed unless `shuffle = false`.
//! With `several`, each option that is rightly chosen or rightly left out counts, less one for each
//! that is wrong; with `ranking`, the options in the right order are asked.
//!
//! ```toml
//! [[part]]
//! kind    = "choice"
//! id      = "regime"
//! ask     = "The motion is"
//! options = [
//!   { id = "underdamped", text = "underdamped", right = "zeta < 1" },
//!   { id = "overdamped", text = "overdamped", right = "zeta > 1", feedback = "Compare $c^2$ with $4mk$." },
//! ]
//! ```

use super::{
    Answer, AnswerError, AnswerKind, Choosable, Choosing, Context, Credit, Declare, Feedback, Key,
    KeyValue, Marker, Marking, Nature, Reading, Reason, Trial,
};
use crate::document::Document;
use crate::math::Math;
use crate::numerics::Rational;
use crate::quantity::{Absent, NodeId};
use crate::source::{Data, Table, Text, Value};

/// The kind.
pub(super) struct Kind;

#[derive(Debug)]
struct Choice {
    options: Vec<Choosable>,
    rights: Vec<Right>,
    feedback: Vec<Option<Document>>,
    is_several: bool,
    is_ranking: bool,
    shuffles: bool,
}

/// Whether an option is right.
#[derive(Debug)]
enum Right {
    Always(bool),
    If(NodeId),
}

/// A prepared key; places are those of the file.
struct Chosen {
    ids: Vec<String>,
    words: Vec<String>,
    feedback: Vec<Option<Document>>,
    right: Vec<bool>,
    order: Vec<usize>,
    is_several: bool,
    is_ranking: bool,
}

impl AnswerKind for Kind {
    fn name(&self) -> &'static str {
        "choice"
    }

    fn minutes(&self) -> u32 {
        1
    }

    fn read(&self, part: &Table<'_>, declare: &mut dyn Declare) -> Option<Box<dyn Answer>> {
        part.required("options");
        let is_several = part.boolean("several").unwrap_or(false);
        let is_ranking = part.boolean("ranking").unwrap_or(false);
        let shuffles = part.boolean("shuffle").unwrap_or(true);
        let (mut options, mut rights, mut feedback) =
            (Vec::<Choosable>::new(), Vec::new(), Vec::new());
        for table in part.tables("options") {
            let id = table.required_text("id");
            let text = table.required_text("text").map(|text| declare.text(&text));
            rights.push(right(&table, declare)?);
            feedback.push(table.text("feedback").map(|text| declare.text(&text)));
            table.finish();
            let (id, text) = (id?, text?);
            if options.iter().any(|option| option.id == id.value) {
                declare.find(&AnswerError::OptionTwice(id.value.clone()), &id);
                return None;
            }
            options.push(Choosable { id: id.value, text });
        }
        let place = Text {
            value: String::new(),
            span: part.span(),
        };
        if !(2..=26).contains(&options.len()) {
            declare.find(
                &AnswerError::Options("a choice has from 2 to 26 options"),
                &place,
            );
            return None;
        }
        let has_right = rights
            .iter()
            .any(|right| !matches!(right, Right::Always(false)));
        if !has_right && !is_ranking && !is_several {
            declare.find(&AnswerError::Options("no option is right"), &place);
            return None;
        }
        Some(Box::new(Choice {
            options,
            rights,
            feedback,
            is_several,
            is_ranking,
            shuffles,
        }))
    }
}

fn right(table: &Table<'_>, declare: &mut dyn Declare) -> Option<Right> {
    match table.value("right") {
        None => Some(Right::Always(false)),
        Some(Value {
            data: Data::Boolean(right),
            ..
        }) => Some(Right::Always(*right)),
        Some(value) => {
            let text = table.as_formula("right", value)?;
            declare.condition("option", &text).map(Right::If)
        }
    }
}

impl Answer for Choice {
    fn kind(&self) -> &'static dyn AnswerKind {
        &Kind
    }

    fn keys(&self) -> Vec<NodeId> {
        let condition = |right: &Right| match right {
            Right::If(node) => Some(*node),
            Right::Always(_) => None,
        };
        self.rights.iter().filter_map(condition).collect()
    }

    fn options(&self) -> &[Choosable] {
        &self.options
    }

    fn choosing(&self) -> Option<Choosing> {
        Some(match (self.is_ranking, self.is_several) {
            (true, _) => Choosing::Ranking,
            (false, true) => Choosing::Several,
            (false, false) => Choosing::One,
        })
    }

    fn shuffles(&self) -> bool {
        self.shuffles
    }

    fn read_mistake(
        &mut self,
        _number: usize,
        answer: &Value,
        part: &Table<'_>,
        declare: &mut dyn Declare,
    ) -> Option<Vec<NodeId>> {
        // A wrong option bears its feedback itself; nothing is computed for it.
        let text = part.as_text("answer", answer)?;
        declare.find(&AnswerError::NoOption(text.value.clone()), &text);
        None
    }

    fn prepare(&self, context: &Context<'_>) -> Result<Box<dyn Marker>, Absent> {
        let is_right = |right: &Right| match right {
            Right::Always(right) => Ok(*right),
            Right::If(node) => context.evaluation.holds(*node),
        };
        let right = self
            .rights
            .iter()
            .map(is_right)
            .collect::<Result<Vec<_>, _>>()?;
        let words = self
            .options
            .iter()
            .map(|option| normalized(&option.text.plain(&no_fills())))
            .collect();
        let order = if context.order.len() == self.options.len() {
            context.order.clone()
        } else {
            (0..self.options.len()).collect()
        };
        Ok(Box::new(Chosen {
            ids: self
                .options
                .iter()
                .map(|option| option.id.clone())
                .collect(),
            words,
            feedback: self.feedback.clone(),
            right,
            order,
            is_several: self.is_several,
            is_ranking: self.is_ranking,
        }))
    }
}

fn no_fills() -> Vec<crate::document::Filling> {
    Vec::new()
}

/// Words without regard to case and spacing.
fn normalized(text: &str) -> String {
    text.split_whitespace()
        .collect::<Vec<_>>()
        .join(" ")
        .trim_matches(['"', '\'', '“', '”'])
        .trim_end_matches(['.', '!', ',', ';'])
        .to_lowercase()
}

/// Words as one, `under-damped` and `under damped`; a formula keeps its signs.
fn joined(text: &str) -> Option<String> {
    const SHORTEST: usize = 4;
    let is_gap = |char: char| " -‐‑_".contains(char);
    let is_of_words = text
        .chars()
        .all(|char| char.is_alphabetic() || is_gap(char));
    let word: String = text.chars().filter(|char| !is_gap(*char)).collect();
    (is_of_words && word.chars().count() >= SHORTEST).then_some(word)
}

/// What stands behind words that say that an answer comes: `option b`, `answer: b`.
fn announced(text: &str) -> &str {
    const WORDS: &[&str] = &["the answer is", "answer is", "answer", "option", "choice"];
    let text = text.trim();
    let rest = WORDS.iter().find_map(|word| {
        let rest = text
            .get(..word.len())
            .filter(|head| head.eq_ignore_ascii_case(word));
        rest.map(|_| &text[word.len()..])
    });
    match rest {
        Some(rest) if rest.starts_with([' ', ':', '=']) => rest.trim_start_matches([' ', ':', '=']),
        _ => text,
    }
}

impl Chosen {
    /// The place in the file of what was typed: an id, the words of an option, or a letter as printed.
    fn place(&self, typed: &str) -> Option<usize> {
        let word = normalized(typed.trim_matches(|sign: char| "()[].".contains(sign)));
        let as_letter = || {
            let mut letters = word.chars();
            let letter = letters
                .next()
                .filter(|letter| letter.is_ascii_lowercase() && letters.next().is_none())?;
            self.order.get((letter as u8 - b'a') as usize).copied()
        };
        // `a) overdamped`: letter and words have to agree.
        let both = typed
            .split_once([')', ':', '.'])
            .or_else(|| typed.split_once(" - "));
        if let Some((letter, words)) = both
            && letter.trim_matches(['(', ' ']).len() == 1
            && !words.trim().is_empty()
        {
            return self
                .place(letter)
                .filter(|place| self.place(words) == Some(*place));
        }
        // A letter is that of an option as printed, unless it is an id to the letter.
        let exact = self.ids.iter().position(|id| id == typed.trim());
        exact
            .or_else(as_letter)
            .or_else(|| self.ids.iter().position(|id| normalized(id) == word))
            .or_else(|| self.words.iter().position(|words| *words == word))
            .or_else(|| {
                let word = joined(&word)?;
                let is_it = |words: &String| joined(words).as_ref() == Some(&word);
                self.words.iter().position(is_it)
            })
    }

    /// All that was typed, or what of it is no option.
    fn places(&self, response: &str) -> Result<Vec<usize>, String> {
        let response = announced(response);
        if self.is_several && normalized(response) == "none" {
            return Ok(Vec::new());
        }
        if let Some(place) = self.place(response) {
            return Ok(vec![place]);
        }
        let separated = response
            .split([',', ';', '>', '\n'])
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
        let last = b'a' + (self.ids.len() - 1) as u8;
        let mut letters = word.to_ascii_lowercase().into_bytes();
        letters.sort_unstable();
        (self.is_several || self.is_ranking)
            && letters.iter().all(|letter| (b'a'..=last).contains(letter))
            && letters.windows(2).all(|pair| pair[0] != pair[1])
    }

    fn letter(&self, place: usize) -> char {
        let position = self
            .order
            .iter()
            .position(|own| *own == place)
            .unwrap_or(place);
        (b'a' + position as u8) as char
    }

    fn reading(&self, places: &[usize]) -> Reading {
        let ids: Vec<&str> = places
            .iter()
            .map(|place| self.ids[*place].as_str())
            .collect();
        let text = ids.join(", ");
        Reading {
            math: Math::text(text.clone()),
            text,
            si: Vec::new(),
        }
    }

    fn feedback(&self, place: usize) -> Option<Feedback> {
        let text = self.feedback[place].as_ref()?;
        Some(Feedback::Text(text.clone()))
    }

    fn mark_one(&self, places: &[usize]) -> Marking {
        let mut places = places.to_vec();
        places.dedup();
        let [place] = &places[..] else {
            return Marking::unreadable("One option is asked: type one letter.");
        };
        let reading = self.reading(&places);
        if self.right[*place] {
            return Marking::read(reading, Credit::FULL, Reason::Matches, None);
        }
        Marking::read(reading, Credit::NONE, Reason::Other, self.feedback(*place))
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
        let mut marking = Marking::read(self.reading(places), credit, Reason::Other, None);
        if credit == Credit::FULL {
            marking.reasons = vec![Reason::Matches];
        }
        let wrong = places.iter().filter(|place| !self.right[**place]);
        marking
            .feedback
            .extend(wrong.filter_map(|place| self.feedback(*place)));
        marking
    }

    /// The pairs of neighbours in the right order count.
    fn mark_ranking(&self, places: &[usize]) -> Marking {
        let mut seen = places.to_vec();
        seen.sort_unstable();
        seen.dedup();
        if seen.len() != self.ids.len() || places.len() != self.ids.len() {
            return Marking::unreadable(format!(
                "Give all {} letters, each once, in order.",
                self.ids.len()
            ));
        }
        let ordered = places.windows(2).filter(|pair| pair[0] < pair[1]).count();
        let all = places.len() - 1;
        let credit = Rational::new(ordered as i128, all as i128)
            .and_then(Credit::new)
            .unwrap_or(Credit::NONE);
        let reason = if ordered == all {
            Reason::Matches
        } else {
            Reason::Other
        };
        Marking::read(self.reading(places), credit, reason, None)
    }
}

impl Marker for Chosen {
    fn trials(&self) -> Vec<Trial> {
        let all: Vec<usize> = (0..self.ids.len()).collect();
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
            let ids: Vec<&str> = right
                .iter()
                .map(|place| self.ids[*place].as_str())
                .collect();
            trials.push(Trial::new(Nature::Borderline, ids.join("; ")));
        }
        if !wrong.is_empty() {
            trials.push(Trial::new(Nature::Wrong, letters(&wrong)));
        }
        trials
    }

    fn key(&self) -> Key {
        let places: Vec<usize> = if self.is_ranking {
            (0..self.ids.len()).collect()
        } else {
            (0..self.ids.len())
                .filter(|place| self.right[*place])
                .collect()
        };
        let letters: Vec<String> = places
            .iter()
            .map(|place| self.letter(*place).to_string())
            .collect();
        let ids = places
            .iter()
            .map(|place| self.ids[*place].clone())
            .collect();
        let is_list = self.is_several || self.is_ranking;
        Key {
            math: Math::text(letters.join(", ")),
            accepted: None,
            value: KeyValue::Options { ids, is_list },
        }
    }

    fn mark(&self, response: &str) -> Marking {
        let places = match self.places(response) {
            Ok(places) => places,
            Err(unknown) => {
                let last = self.letter(self.order[self.order.len() - 1]);
                let shown: String = unknown.chars().take(40).collect();
                return Marking::unreadable(format!(
                    "`{shown}` is none of the options: type a letter from a to {last}."
                ));
            }
        };
        match (self.is_ranking, self.is_several) {
            (true, _) => self.mark_ranking(&places),
            (false, true) => self.mark_several(&places),
            (false, false) => self.mark_one(&places),
        }
    }
}
