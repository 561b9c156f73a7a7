//! Equations that the parts of an item ask for one by one, as far as they belong to one system.

use std::collections::BTreeMap;

use super::marker::Prepared;
use super::rows::Rows;
use super::terms::{Coefficients, terms};
use crate::answer::{Beside, Equations};
use crate::expr::{Equation, Name, Program};

/// Other parts that are looked at; what they can say together grows with every one.
const MAX_OTHERS: usize = 5;

/// The key of another part of the system, and what was answered to it.
pub(crate) struct Other {
    key: Vec<Program>,
    typed: Vec<Program>,
}

impl Prepared {
    /// What the other parts of the system ask for and got. Equations of one system have the same unknowns, are
    /// no more than these, and are all linear or all not: the equation of a pendulum at any angle and that for
    /// small angles answer two questions.
    pub(crate) fn others(&self, others: &[Beside<'_>]) -> Vec<Other> {
        let none = BTreeMap::new();
        let read = |beside: &Beside<'_>| {
            let Equations {
                unknowns,
                key,
                typed,
            } = beside.marker.equations(beside.response)?;
            let equations: Vec<&Equation> = self.setup.key.iter().chain(&key).collect();
            let occurs = |name: &&Name| {
                let mut all = equations.iter();
                all.any(|equation| equation.difference().names().uses(name))
            };
            let count = unknowns.iter().filter(occurs).count();
            let fits = unknowns == self.setup.unknowns && equations.len() <= count;
            let other = Other {
                key: self.setup.compile(&key, &none)?,
                typed: self.setup.compile(&typed, &none)?,
            };
            let is_alike = self.is_linear(&other.key) == self.is_linear(&self.key);
            (fits && is_alike).then_some(other)
        };
        others.iter().filter_map(read).take(MAX_OTHERS).collect()
    }

    fn is_linear(&self, equations: &[Program]) -> bool {
        let all = terms(&self.setup);
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
    pub(crate) fn is_right_beside(&self, typed: &[Program], others: &[Other]) -> bool {
        let given = others
            .iter()
            .filter(|other| !other.typed.is_empty())
            .collect::<Vec<_>>();
        // What the others say twice does not stand for what is missing here.
        if given.is_empty() || self.rank(typed) < self.rank(&self.key) {
            return false;
        }
        (1..1_u32 << given.len()).any(|chosen| {
            let is_chosen = |place: &usize| chosen & (1 << place) != 0;
            let taken = || (0..given.len()).filter(is_chosen).map(|place| given[place]);
            let keys = self.key.iter().chain(taken().flat_map(|other| &other.key));
            let typed = typed.iter().chain(taken().flat_map(|other| &other.typed));
            self.compare(keys, typed) == Rows::Same
        })
    }

    /// Whether the response follows from the keys of the system.
    pub(crate) fn follows(&self, typed: &[Program], others: &[Other]) -> bool {
        let keys = self
            .key
            .iter()
            .chain(others.iter().flat_map(|other| &other.key));
        matches!(self.compare(keys, typed), Rows::Same | Rows::Fewer { .. })
    }

    /// The number of independent equations.
    fn rank(&self, equations: &[Program]) -> Option<usize> {
        Rows::rank(equations, self.choices.points.first()?)
    }
}
