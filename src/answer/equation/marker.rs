//! Marks equations: alone, and together with the responses to the other parts that ask for equations.

use std::cell::OnceCell;

use super::points::{Choice, Choices, of_instance};
use super::quotient::without_quotients;
use super::root::without_roots;
use super::rows::Rows;
use super::system::System;
use super::terms::{Coefficients, terms};
use super::{Arc, Setup, read, told, written};
use crate::answer::recalled::Recalled;
use crate::answer::rounded::{rounding_of_values, settle_rounded, with_fractions};
use crate::answer::settle::{Candidate, settle_by_rule};
use crate::answer::{
    Beside, Credit, Doubt, Echo, Equations, Key, Marker, Marking, Misfit, Nature, Note, Reading,
    Remark, Slip, Trial, Unreadable, Verdict, Why,
};
use crate::expr::{Equation, Expr, Kind, Name, Program};
use crate::numerics::{Rational, SortedMap};
use crate::response::{Defining, L_FOR_ELL, Passage};
use crate::work;

/// A prepared key.
pub(crate) struct Prepared {
    pub(crate) setup: Arc<Setup>,
    pub(crate) key: Arc<Vec<Program>>,
    /// The data for which equations are compared.
    pub(crate) choices: Arc<Choices>,
    pub(crate) recalled: Option<Arc<Recalled>>,
    /// The data of the instance, by input.
    pub(crate) data: Vec<Option<f64>>,
    /// The points for these, once numbers were typed in place of letters.
    pub(crate) own: OnceCell<Choice>,
    pub(crate) mistakes: Vec<(usize, Arc<Vec<Program>>, Credit)>,
    pub(crate) doubt: Doubt,
}

impl Prepared {
    /// The points for the data of the instance.
    fn own(&self) -> &Choice {
        self.own
            .get_or_init(|| work::aside(|| of_instance(&self.setup, &self.key, &self.data)))
    }

    /// Equations, their programs, and how they compare with the key: as they were typed or, unless that is right,
    /// without roots, or without quotients of unknowns.
    fn compared(&self, equations: Vec<Equation>) -> Option<(Vec<Equation>, Vec<Program>, Rows)> {
        let compared = |equations: Vec<Equation>| {
            let typed = self.setup.compile(&equations, &SortedMap::new())?;
            let rows = self.choices.compare_with_key(&typed);
            Some((equations, typed, rows))
        };
        let as_typed = compared(equations)?;
        if as_typed.2 == Rows::Same {
            return Some(as_typed);
        }
        let other = without_roots(&self.setup, &self.choices, &as_typed.0)
            .or_else(|| without_quotients(&self.setup.unknowns, &as_typed.0));
        match other {
            Some(other) => compared(other),
            None => Some(as_typed),
        }
    }

    fn misfit(&self, equations: &[Equation]) -> Option<Misfit> {
        let errors = equations
            .iter()
            .find_map(|equation| equation.check(&self.setup.meaning).err());
        errors.map(|errors| Misfit::Step {
            entry: None,
            error: errors.first().cloned(),
        })
    }

    /// Whether equations are right with the values of the instance in place of letters, be these rounded.
    fn are_right_for_the_data(&self, equations: &[Equation], typed: &[Program]) -> bool {
        let (key, typed) = (
            self.key.iter().collect::<Vec<_>>(),
            typed.iter().collect::<Vec<_>>(),
        );
        Rows::of(&key, &typed, self.own()) == Rows::Same
            || self.are_rounded_for(equations, self.own())
    }

    /// Whether numbers stand in equations where the key has data: in place of them all, or of some.
    fn has_values(&self, equations: &[Equation], are_right: impl FnOnce() -> bool) -> bool {
        let data = |equations: &[Equation]| -> Vec<Name> {
            let names = equations
                .iter()
                .flat_map(|own| own.difference().names().free);
            names
                .map(|variable| variable.name)
                .filter(|own| !self.setup.unknowns.contains(own) && own.as_str() != "t")
                .collect()
        };
        let has_number = |equation: &Equation| {
            let mut found = false;
            equation.difference().walk(&mut |node| {
                found |= matches!(node.kind(), Kind::Number(value) if *value != Rational::ZERO);
            });
            found
        };
        let (key, typed) = (data(&self.setup.key), data(equations));
        // One as a value is not written: a letter that is missing is missing.
        let mut missing = key.iter().filter(|name| !typed.contains(name));
        let lacks_some = missing.any(|name| {
            let place = self.setup.meaning.place(name);
            place.and_then(|place| self.data[place]) != Some(1.0)
        });
        lacks_some && equations.iter().any(has_number) && (typed.is_empty() || are_right())
    }

    /// The marking of equations that are not right.
    fn wrong(
        &self,
        reading: Reading,
        equations: &[Equation],
        typed: &[Program],
        system: &System<'_>,
    ) -> Marking {
        if system.implies(typed) {
            if matches!(
                self.choices.compare(typed, &*self.key),
                Rows::Same | Rows::Fewer { .. }
            ) {
                let note = Remark::from(Note::OthersBelongElsewhere);
                return Marking::read(reading, Credit::FULL, note);
            }
            return Marking::wrong(reading, Remark::from(Slip::OtherEquation));
        }
        let misfit = self.misfit(equations);
        let are_right = || misfit.is_some() && self.are_right_for_the_data(equations, typed);
        if self.has_values(equations, are_right) {
            return Marking::unreadable(Why::ValuesForLetters);
        }
        if let Some(misfit) = misfit {
            return Marking::wrong(reading, Remark::from(misfit));
        }
        let terms = told::terms(&self.setup, &self.key, typed, &self.choices.points);
        Marking::wrong(reading, terms.map(|terms| Slip::Terms(terms).into()))
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
        Key::clone(self.setup.printed())
    }

    fn echo(&self, response: Passage<'_>) -> Result<Echo, Unreadable> {
        let equations = read::equations(&self.setup, response)
            .or_else(|why| read::by_textbooks(&self.setup, response, &why).ok_or(why))?;
        Ok(Echo::of_reading(self.setup.reading(&equations)))
    }

    fn mark(&self, response: Passage<'_>) -> Marking {
        self.mark_beside(response, &[])
    }

    fn mark_beside(&self, response: Passage<'_>, others: &[Beside<'_>]) -> Marking {
        let setup = &self.setup;
        let equations = match read::equations(setup, response) {
            Ok(equations) => equations,
            Err(why) => {
                let meant = self.right_with(L_FOR_ELL, response, others);
                let meant = meant.or_else(|| self.right_by_textbooks(response, &why, others));
                return meant.unwrap_or_else(|| Marking::unreadable(why));
            }
        };
        let candidate = |equations: Vec<Equation>| Candidate {
            shown: written(&equations),
            marking: self.judged(equations, others),
        };
        // Looked for only where the conventional reading is not right.
        let readings = std::iter::once_with(|| read::others(setup, response, &equations)).flatten();
        let first = self.judged(equations.clone(), others);
        let written = || written(&equations);
        let marking = settle_by_rule(self.doubt, first, written, readings.map(candidate));
        if marking.verdict == Verdict::Right {
            // Of alternatives each has to be right alone.
            let not_right = |own: &Equation| {
                let alone = self.judged(vec![own.clone()], others);
                Some(alone).filter(|alone| alone.verdict != Verdict::Right)
            };
            let mut alternatives = equations.iter().filter(|_| response.has_alternatives());
            return alternatives.find_map(not_right).unwrap_or(marking);
        }
        if marking.credit < Credit::FULL && self.is_rounded(&equations) {
            let all = equations.iter().map(Equation::difference);
            let rounding = all
                .filter_map(|own| rounding_of_values(&own))
                .fold(0.0, f64::max);
            return settle_rounded(
                self.doubt,
                rounding,
                Marking::right(setup.reading(&equations)),
            );
        }
        let in_letters = self.without_values(&equations);
        let in_letters = in_letters.map(|equations| self.judged(equations, others));
        if let Some(right) = in_letters.filter(|marking| marking.verdict == Verdict::Right) {
            return right;
        }
        // `M x'' + … = 0, M = 3m/2`, where M is a letter of the question, too.
        let defined = read::defined(setup, response, Defining::Anew);
        let defined = defined.map(|equations| self.judged(equations, others));
        defined
            .filter(|defined| defined.verdict == Verdict::Right)
            .or_else(|| self.right_with(L_FOR_ELL, response, others))
            .unwrap_or(marking)
    }

    fn recalled(&self) -> Option<&Recalled> {
        // What was compared for the data of the sheet may be right for them alone.
        self.recalled
            .as_deref()
            .filter(|_| self.own.get().is_none())
    }

    fn equations(&self, response: Passage<'_>) -> Option<Equations> {
        Some(Equations {
            unknowns: self.setup.unknowns.clone(),
            key: self.setup.key.clone(),
            typed: read::equations(&self.setup, response).unwrap_or_default(),
        })
    }
}

impl Prepared {
    /// The marking of a response that leaves symbols of the field open, `ẍ + ω_n² x = 0`, where it is right as textbooks
    /// define these. Where it is not, it may have meant them otherwise.
    fn right_by_textbooks(
        &self,
        response: Passage<'_>,
        why: &Unreadable,
        others: &[Beside<'_>],
    ) -> Option<Marking> {
        // With the values of one instance letters that go against the dimensions could be right by chance.
        if self.choices.of_one_instance().is_some() {
            return None;
        }
        let equations = read::by_textbooks(&self.setup, response, why)?;
        let marking = self.judged(equations, others);
        let reading = marking
            .reading
            .filter(|_| marking.verdict == Verdict::Right)?;
        let note = Remark::from(Note::ByTextbooks);
        Some(Marking::read(reading, Credit::FULL, note))
    }

    /// Whether equations are the key but for the rounding of their numbers: of coefficients, `0.333 m l² θ''`, or where
    /// the values stand for the letters, of these.
    fn is_rounded(&self, equations: &[Equation]) -> bool {
        let compared = || self.compared(exact(equations)?);
        self.are_rounded_values(equations)
            || compared().is_some_and(|(_, _, rows)| rows == Rows::Same)
    }

    fn are_rounded_values(&self, equations: &[Equation]) -> bool {
        let points = self.choices.of_one_instance();
        points.is_some_and(|points| self.are_rounded_for(equations, points))
    }

    /// The marking of equations with a letter for another one that it is alike, if they are right.
    fn right_with(
        &self,
        custom: [&str; 2],
        response: Passage<'_>,
        others: &[Beside<'_>],
    ) -> Option<Marking> {
        let meant = read::with(custom, &self.setup, response)?;
        Some(self.judged(meant, others)).filter(|meant| meant.verdict == Verdict::Right)
    }

    /// Some of several equations, where each other one is the key once more with the values of the sheet in place of
    /// letters: `m x'' + k x = 0, x'' + 100 x = 0`.
    fn without_values(&self, equations: &[Equation]) -> Option<Vec<Equation>> {
        let is_again = |own: &Equation| {
            let own = std::slice::from_ref(own);
            let typed = || self.setup.compile(own, &SortedMap::new());
            self.has_values(own, || true)
                && typed().is_some_and(|typed| self.are_right_for_the_data(own, &typed))
        };
        let (again, others): (Vec<_>, Vec<_>) = equations.iter().cloned().partition(is_again);
        (!again.is_empty() && !others.is_empty()).then_some(others)
    }

    /// Whether an equation is the key for data but for the rounding of its numbers.
    fn are_rounded_for(&self, equations: &[Equation], points: &Choice) -> bool {
        let ([own], [key]) = (equations, &self.key[..]) else {
            return false;
        };
        let are_nearly = || {
            let part = rounding_of_values(&own.difference())?;
            let typed = self.setup.compile(equations, &SortedMap::new())?;
            let (terms, point) = (terms(&self.setup), points.first()?);
            let key = Coefficients::of(key, &terms, point)?;
            let typed = Coefficients::of(typed.first()?, &terms, point)?;
            Some(typed.are_nearly(&key, part))
        };
        are_nearly().unwrap_or(false)
    }

    /// The marking of a reading, beside the responses to other parts.
    fn judged(&self, equations: Vec<Equation>, others: &[Beside<'_>]) -> Marking {
        let reading = self.setup.reading(&equations);
        let Some((equations, typed, rows)) = self.compared(equations) else {
            return Marking::unreadable(Why::IncomparableEquation);
        };
        if rows == Rows::Same {
            return Marking::right(reading);
        }
        let system = System::of(self, others);
        if system.is_completed_by(&typed) {
            return Marking::read(reading, Credit::FULL, Remark::from(Note::RightTogether));
        }
        let named = self
            .mistakes
            .iter()
            .find(|(_, given, _)| self.choices.compare(&**given, &typed) == Rows::Same);
        if let Some((number, _, credit)) = named {
            return Marking::mistake(reading, *number, *credit);
        }
        if let Rows::Fewer { found, needed } = rows {
            return fewer(reading, typed.len(), found, needed);
        }
        self.wrong(reading, &equations, &typed, &system)
    }
}

/// The equations of which these may be rounded forms.
fn exact(equations: &[Equation]) -> Option<Vec<Equation>> {
    let sides = equations.iter().flat_map(|own| [&own.left, &own.right]);
    let sides: Vec<Expr> = sides.cloned().collect();
    let exact = with_fractions(&sides)?;
    let (pairs, _) = exact.as_chunks();
    let pairs = pairs.iter().cloned();
    Some(
        pairs
            .map(|[left, right]| Equation { left, right })
            .collect(),
    )
}

/// The marking of fewer independent equations than are asked.
fn fewer(reading: Reading, typed: usize, found: usize, needed: usize) -> Marking {
    let credit = Rational::new(found as i128, needed as i128).and_then(Credit::new);
    let slip = match found {
        0 => Slip::Tautology,
        _ => Slip::Fewer {
            typed,
            found,
            needed,
        },
    };
    Marking::read(reading, credit.unwrap_or(Credit::NONE), Remark::from(slip))
}
