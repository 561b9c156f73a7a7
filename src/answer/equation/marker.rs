//! Marks equations: alone, and together with the responses to the other parts that ask for equations.

use std::collections::BTreeMap;

use super::points::Choice;
use super::rows::Rows;
use super::system::Other;
use super::{Arc, Setup, told, written};
use crate::answer::{
    Beside, Credit, Equations, Feedback, Key, Marker, Marking, Nature, Reading, Reason, Trial,
};
use crate::expr::{Equation, Kind, Program};
use crate::numerics::Rational;

/// A prepared key.
pub(super) struct Prepared {
    pub(super) setup: Arc<Setup>,
    pub(super) key: Vec<Program>,
    /// For each choice of data, points that differ in all else; the last choice is that of the instance.
    pub(super) points: Vec<Choice>,
    pub(super) mistakes: Vec<(usize, Vec<Program>, Credit)>,
}

impl Prepared {
    pub(super) fn compare<'p>(
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

    /// Equations, their programs, and how they compare with the key: as they were typed or, unless that is right,
    /// without roots.
    fn compared(&self, equations: Vec<Equation>) -> Option<(Vec<Equation>, Vec<Program>, Rows)> {
        let typed = self.setup.compile(&equations, &BTreeMap::new())?;
        let rows = self.compare(&self.key, &typed);
        match self.without_roots(&equations) {
            Some(squared) if rows != Rows::Same => {
                let typed = self.setup.compile(&squared, &BTreeMap::new())?;
                let rows = self.compare(&self.key, &typed);
                Some((squared, typed, rows))
            }
            _ => Some((equations, typed, rows)),
        }
    }

    fn trouble(&self, equations: &[Equation]) -> Option<String> {
        let errors = equations
            .iter()
            .find_map(|equation| equation.check(&self.setup.meaning).err());
        errors.map(|errors| crate::answer::formula::explained(errors.first()))
    }

    /// Whether equations are right with the values of the instance in place of letters.
    fn is_right_for_the_data(&self, typed: &[Program]) -> bool {
        let (key, typed) = (
            self.key.iter().collect::<Vec<_>>(),
            typed.iter().collect::<Vec<_>>(),
        );
        let last = self.points.last();
        last.is_some_and(|points| Rows::of(&key, &typed, points) == Rows::Same)
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
        let trouble = self.trouble(equations);
        let has_values = || trouble.is_some() && self.is_right_for_the_data(typed);
        if self.is_in_numbers(equations) || has_values() {
            return Marking::unreadable(
                "Write the equation with the letters of the question, not with their values.",
            );
        }
        if let Some(trouble) = trouble {
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
        let Some((equations, typed, rows)) = self.compared(equations) else {
            return Marking::unreadable(
                "This equation cannot be compared; write it in a simpler form.",
            );
        };
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
            return fewer(reading, typed.len(), found, needed);
        }
        self.wrong(reading, &equations, &typed, &others)
    }

    fn equations(&self, response: &str) -> Option<Equations> {
        Some(Equations {
            unknowns: self.setup.unknowns.clone(),
            key: self.setup.key.clone(),
            typed: self.setup.read(response).unwrap_or_default(),
        })
    }
}

/// The marking of fewer independent equations than are asked.
fn fewer(reading: Reading, typed: usize, found: usize, needed: usize) -> Marking {
    let credit = Rational::new(found as i128, needed as i128).and_then(Credit::new);
    let words = if found == 0 {
        "This holds for any motion: it says nothing about this one.".to_owned()
    } else if typed > found {
        format!(
            "Right as far as it goes, but of these equations only {found} {} independent; {needed} are asked.",
            if found == 1 { "is" } else { "are" }
        )
    } else {
        format!("Right as far as it goes: {needed} independent equations are asked.")
    };
    let (credit, words) = (credit.unwrap_or(Credit::NONE), Feedback::Words(words));
    Marking::read(reading, credit, Reason::Other, Some(words))
}
