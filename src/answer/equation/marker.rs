//! Marks equations: alone, and together with the responses to the other parts that ask for equations.

use std::collections::BTreeMap;

use super::points::Choice;
use super::rows::Rows;
use super::{Arc, Setup, told, written};
use crate::answer::{
    Beside, Credit, Equations, Feedback, Key, Marker, Marking, Nature, Reading, Reason, Trial,
};
use crate::expr::{Equation, Kind, Program};
use crate::numerics::Rational;

/// Other parts that are looked at; what they can say together grows with every one.
const MOST_OTHERS: usize = 5;

/// A prepared key.
pub(super) struct Prepared {
    pub(super) setup: Arc<Setup>,
    pub(super) key: Vec<Program>,
    /// For each choice of data, points that differ in all else.
    pub(super) points: Vec<Choice>,
    pub(super) mistakes: Vec<(usize, Vec<Program>, Credit)>,
}

/// The key of another part, and what was answered to it.
struct Other {
    key: Vec<Program>,
    typed: Vec<Program>,
}

impl Prepared {
    fn compare<'p>(
        &self,
        key: impl IntoIterator<Item = &'p Program>,
        typed: impl IntoIterator<Item = &'p Program>,
    ) -> Rows {
        let key: Vec<&Program> = key.into_iter().collect();
        let typed: Vec<&Program> = typed.into_iter().collect();
        let at = self
            .points
            .iter()
            .map(|points| Rows::of(&key, &typed, points));
        at.reduce(Rows::worse).unwrap_or(Rows::Undefined)
    }

    /// What other parts ask for and got, as far as it is written in names of this one.
    fn others(&self, others: &[Beside<'_>]) -> Vec<Other> {
        let none = BTreeMap::new();
        let read = |beside: &Beside<'_>| {
            let Equations { key, typed } = beside.marker.equations(beside.response)?;
            Some(Other {
                key: self.setup.compile(&key, &none)?,
                typed: self.setup.compile(&typed, &none)?,
            })
        };
        others.iter().filter_map(read).take(MOST_OTHERS).collect()
    }

    /// Whether the response and those to some of the other parts together say what their keys say.
    fn is_right_beside(&self, typed: &[Program], others: &[Other]) -> bool {
        let given = others
            .iter()
            .filter(|other| !other.typed.is_empty())
            .collect::<Vec<_>>();
        (1..1_u32 << given.len()).any(|chosen| {
            let is_chosen = |place: &usize| chosen & (1 << place) != 0;
            let taken = || (0..given.len()).filter(is_chosen).map(|place| given[place]);
            let keys = self.key.iter().chain(taken().flat_map(|other| &other.key));
            let typed = typed.iter().chain(taken().flat_map(|other| &other.typed));
            self.compare(keys, typed) == Rows::Same
        })
    }

    /// Whether the response follows from the keys of all parts.
    fn follows(&self, typed: &[Program], others: &[Other]) -> bool {
        let keys = self
            .key
            .iter()
            .chain(others.iter().flat_map(|other| &other.key));
        matches!(self.compare(keys, typed), Rows::Same | Rows::Fewer { .. })
    }

    fn trouble(&self, equations: &[Equation]) -> Option<String> {
        let errors = equations
            .iter()
            .find_map(|equation| equation.check(&self.setup.meaning).err());
        errors.map(|errors| crate::answer::formula::explained(errors.first()))
    }

    /// Whether no data stand in equations, though some stand in the key.
    fn is_in_numbers(&self, equations: &[Equation]) -> bool {
        let has_data = |equation: &Equation| {
            let names = equation.difference().names();
            names.free.iter().any(|variable| {
                !self.setup.unknowns.contains(&variable.name) && variable.name.as_str() != "t"
            })
        };
        let has_number = |equation: &Equation| {
            let mut found = false;
            equation.difference().walk(&mut |node| {
                found |= matches!(node.kind(), Kind::Number(value) if *value != Rational::ZERO);
            });
            found
        };
        self.setup.key.iter().any(has_data)
            && !equations.iter().any(has_data)
            && equations.iter().any(has_number)
    }

    /// The marking of equations that are not right.
    fn wrong(
        &self,
        reading: Reading,
        equations: &[Equation],
        typed: &[Program],
        others: &[Other],
    ) -> Marking {
        let say = |words: String| Some(Feedback::Words(words));
        if !others.is_empty() && self.follows(typed, others) {
            if matches!(
                self.compare(typed, &self.key),
                Rows::Same | Rows::Fewer { .. }
            ) {
                let words = "Right; the other equations belong to the other parts.".to_owned();
                return Marking::read(reading, Credit::FULL, Reason::Matches, say(words));
            }
            let words = "This follows from the equations of motion, but it is not the one that is asked here, and with \
                         the other answers it does not make up all of them.";
            return Marking::read(reading, Credit::NONE, Reason::Other, say(words.to_owned()));
        }
        if self.is_in_numbers(equations) {
            return Marking::unreadable(
                "Write the equation with the letters of the question, not with their values.",
            );
        }
        if let Some(trouble) = self.trouble(equations) {
            return Marking::read(reading, Credit::NONE, Reason::Dimension, say(trouble));
        }
        let told = told::told(&self.setup, &self.key, typed, &self.points);
        let reason = match &told {
            Some(told) if told.is_sign => Reason::Sign,
            _ => Reason::Other,
        };
        Marking::read(
            reading,
            Credit::NONE,
            reason,
            told.and_then(|told| say(told.words)),
        )
    }
}

impl Marker for Prepared {
    fn trials(&self) -> Vec<Trial> {
        let mut trials = vec![
            Trial::new(Nature::Unreadable, "x'' ="),
            Trial::new(Nature::Unreadable, "sqrt(2)"),
        ];
        let text = written(&self.setup.key);
        // Numbers with units cannot be typed.
        if text.contains('[') || text.contains("if ") {
            return trials;
        }
        let of = |left: &str, right: &str| {
            let equations = self.setup.key.iter().map(|equation| {
                let fill = |form: &str| {
                    let form = form.replace("{l}", &equation.left.to_string());
                    form.replace("{r}", &equation.right.to_string())
                };
                format!("{} = {}", fill(left), fill(right))
            });
            equations.collect::<Vec<_>>().join("; ")
        };
        trials.push(Trial::new(Nature::Right, text));
        trials.push(Trial::new(Nature::Borderline, of("2*({r})", "2*({l})")));
        trials.push(Trial::new(
            Nature::Unreadable,
            of("{l}", "unheard_of + {r}"),
        ));
        if let Some(unknown) = self.setup.unknowns.first() {
            trials.push(Trial::new(
                Nature::Wrong,
                of(&format!("{{l}} + {unknown}^3"), "{r}"),
            ));
        }
        trials
    }

    fn key(&self) -> Key {
        self.setup.printed()
    }

    fn mark(&self, response: &str) -> Marking {
        self.mark_beside(response, &[])
    }

    fn mark_beside(&self, response: &str, others: &[Beside<'_>]) -> Marking {
        let setup = &self.setup;
        let equations = match setup.read(response) {
            Ok(equations) => equations,
            Err(words) => return Marking::unreadable(words),
        };
        let reading = setup.reading(&equations);
        let Some(typed) = setup.compile(&equations, &BTreeMap::new()) else {
            return Marking::unreadable(
                "This equation cannot be compared; write it in a simpler form.",
            );
        };
        let rows = self.compare(&self.key, &typed);
        if rows == Rows::Same {
            return Marking::read(reading, Credit::FULL, Reason::Matches, None);
        }
        let others = self.others(others);
        if self.is_right_beside(&typed, &others) {
            let words = "Right together with the other equations.".to_owned();
            let feedback = Some(Feedback::Words(words));
            return Marking::read(reading, Credit::FULL, Reason::Matches, feedback);
        }
        let named = self
            .mistakes
            .iter()
            .find(|(_, given, _)| self.compare(given, &typed) == Rows::Same);
        if let Some((number, _, credit)) = named {
            let feedback = Some(Feedback::Mistake(*number));
            return Marking::read(reading, *credit, Reason::Mistake(*number), feedback);
        }
        if let Rows::Fewer { found, needed } = rows {
            let credit = Rational::new(found as i128, needed as i128).and_then(Credit::new);
            let words = if typed.len() > found {
                format!(
                    "Right as far as it goes, but these are {found} independent equations, however often they are \
                     written; {needed} are asked."
                )
            } else {
                format!("Right as far as it goes: {needed} independent equations are asked.")
            };
            return Marking::read(
                reading,
                credit.unwrap_or(Credit::NONE),
                Reason::Other,
                Some(Feedback::Words(words)),
            );
        }
        self.wrong(reading, &equations, &typed, &others)
    }

    fn equations(&self, response: &str) -> Option<Equations> {
        Some(Equations {
            key: self.setup.key.clone(),
            typed: self.setup.read(response).unwrap_or_default(),
        })
    }
}
