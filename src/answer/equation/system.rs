//! Equations that the parts of an item ask for one by one, as far as they belong to one system.

use super::Setup;
use super::marker::Prepared;
use super::points::Choices;
use super::rows::Rows;
use super::terms::{Coefficients, terms};
use crate::answer::{Beside, Equations};
use crate::expr::{Equation, Program};
use crate::numerics::SortedMap;

/// Other parts that are looked at; what they can say together grows with every one.
const MAX_OTHERS: usize = 5;

/// The equation of a part, and those that other parts ask for beside it.
pub(crate) struct System<'a> {
    setup: &'a Setup,
    key: &'a [Program],
    choices: &'a Choices,
    others: Vec<Other>,
}

/// The key of another part of the system, and what was answered to it.
struct Other {
    key: Vec<Program>,
    typed: Vec<Program>,
}

impl<'a> System<'a> {
    /// With what the other parts of the system ask for and got. Equations of one system have the same unknowns, are
    /// no more than these, and are all linear or all not: the equation of a pendulum at any angle and that for
    /// small angles answer two questions.
    pub(crate) fn of(part: &'a Prepared, others: &[Beside<'_>]) -> Self {
        let mut system = Self {
            setup: &part.setup,
            key: &part.key,
            choices: &part.choices,
            others: Vec::new(),
        };
        let others = others.iter().filter_map(|beside| system.other(beside));
        system.others = others.take(MAX_OTHERS).collect();
        system
    }

    /// What another part asks for and got, if it belongs to the system.
    fn other(&self, beside: &Beside<'_>) -> Option<Other> {
        let Equations {
            unknowns,
            key,
            typed,
        } = beside.marker.equations(beside.response)?;
        let equations: Vec<&Equation> = self.setup.key.iter().chain(&key).collect();
        let occurring = unknowns.iter().filter(|name| {
            let mut all = equations.iter();
            all.any(|equation| equation.difference().names().uses(name))
        });
        let fits = equations.len() <= occurring.count() && unknowns == self.setup.unknowns;
        let none = SortedMap::new();
        let other = Other {
            key: self.setup.compile(&key, &none)?,
            typed: self.setup.compile(&typed, &none)?,
        };
        let is_alike = self.is_linear(&other.key) == self.is_linear(self.key);
        (fits && is_alike).then_some(other)
    }

    fn is_linear(&self, equations: &[Program]) -> bool {
        let all = terms(self.setup);
        let Some(point) = self
            .choices
            .points
            .first()
            .and_then(|choice| choice.first())
        else {
            return true;
        };
        equations
            .iter()
            .all(|program| Coefficients::of(program, &all, point).is_none_or(|own| own.is_linear()))
    }

    /// Whether the response and those to some of the other parts together say what their keys say.
    pub(crate) fn is_completed_by(&self, typed: &[Program]) -> bool {
        let given = self
            .others
            .iter()
            .filter(|other| !other.typed.is_empty())
            .collect::<Vec<_>>();
        // What the others say twice does not stand for what is missing here.
        if given.is_empty() || self.rank(typed) < self.rank(self.key) {
            return false;
        }
        (1..1_u32 << given.len()).any(|chosen| {
            let is_chosen = |place: &usize| chosen & (1 << place) != 0;
            let taken = || (0..given.len()).filter(is_chosen).map(|place| given[place]);
            let keys = self.key.iter().chain(taken().flat_map(|other| &other.key));
            let typed = typed.iter().chain(taken().flat_map(|other| &other.typed));
            self.choices.compare(keys, typed) == Rows::Same
        })
    }

    /// Whether a response follows from the keys of the system, where there are other parts.
    pub(crate) fn implies(&self, typed: &[Program]) -> bool {
        let keys = self.others.iter().flat_map(|other| &other.key);
        let found = || self.choices.compare(self.key.iter().chain(keys), typed);
        !self.others.is_empty() && matches!(found(), Rows::Same | Rows::Fewer { .. })
    }

    /// The number of independent equations.
    fn rank(&self, equations: &[Program]) -> Option<usize> {
        Rows::rank(equations, self.choices.points.first()?)
    }
}
