//! Marks functions by their values at the times of the span.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::Setup;
use super::around::{manner, unit_in_front, without_condition};
use crate::answer::meaning::ORDERS;
use crate::answer::trial::typed as typed_number;
use crate::answer::typed::{self, Typed};
use crate::answer::{
    Credit, Feedback, Key, Marker, Marking, Nature, Reading, Reason, Trial, Verdict,
};
use crate::expr::{Expr, Precise, Workspace};
use crate::math::Math;
use crate::unit::Dimension;

/// A prepared key.
pub(super) struct Prepared {
    pub(super) setup: Arc<Setup>,
    pub(super) times: Vec<Precise>,
    pub(super) values: Vec<f64>,
    pub(super) halves: Vec<f64>,
    pub(super) mistakes: Vec<(usize, Vec<f64>, Credit)>,
    pub(super) data: Vec<Precise>,
}

impl Prepared {
    /// The values of a typed function at the times.
    fn values_of(&self, expr: &Expr) -> Option<Vec<f64>> {
        let setup = &self.setup;
        let program = setup.meaning.compile(expr, &BTreeMap::new()).ok()?;
        let slot = setup.meaning.place(&setup.variable)? * ORDERS;
        let mut data = self.data.clone();
        let mut room = Workspace::default();
        let mut values = Vec::with_capacity(self.times.len());
        for time in &self.times {
            data[slot] = *time;
            values.push(program.evaluate(&data[..], &mut room).ok()?.as_real()?);
        }
        Some(values)
    }

    /// Whether a typed function with numbers has the dimension of the key, where that can be told.
    fn dimension_trouble(&self, expr: &Expr) -> Option<Dimension> {
        let setup = &self.setup;
        // Numbers stand for values in the unit of the key, rates and frequencies: only formulas in data alone have dimensions.
        let names = expr.names();
        let has_data = names
            .free
            .iter()
            .any(|variable| variable.name != setup.variable);
        let found = expr.check(&setup.meaning).ok().filter(|_| has_data)?;
        let (key, typed) = (setup.kind.dimension()?, found.dimension()?);
        (key != typed && !typed.is_pure()).then_some(typed)
    }

    fn is_near(&self, typed: &[f64], key: &[f64]) -> bool {
        typed
            .iter()
            .zip(key)
            .zip(&self.halves)
            .all(|((typed, key), half)| (typed - key).abs() <= half + 1e-12 * key.abs())
    }
}

impl Marker for Prepared {
    fn trials(&self) -> Vec<Trial> {
        let mut trials = vec![
            Trial::new(Nature::Unreadable, "exp("),
            Trial::new(Nature::Unreadable, "unheard_of cos(t)"),
        ];
        let text = self.setup.shown.to_string();
        let largest = self
            .values
            .iter()
            .fold(0.0_f64, |most, value| most.max(value.abs()));
        // Cases and numbers with units cannot be typed, and nothing is next to zero.
        let is_typable = !text.contains("if ") && !text.contains('[');
        if !is_typable || largest == 0.0 || !self.setup.shown.names().paths.is_empty() {
            return trials;
        }
        trials.push(Trial::new(Nature::Right, text.as_str()));
        let shares = self.values.iter().zip(&self.halves);
        let nearest = shares
            .map(|(value, half)| half / value.abs())
            .fold(f64::INFINITY, f64::min);
        if nearest.is_finite() {
            let scaled = |share: f64| format!("({})*({text})", typed_number(1.0 + share * nearest));
            trials.push(Trial::new(Nature::Borderline, scaled(0.99)));
            trials.push(Trial::new(Nature::Wrong, scaled(1.01)));
        }
        trials
    }

    fn key(&self) -> Key {
        self.setup.printed()
    }

    fn mark(&self, response: &str) -> Marking {
        let response = without_condition(response);
        let typed = typed::formula(response, &self.setup.lexicon, manner(response));
        let first = match typed {
            Ok(typed) => self.mark_typed(typed),
            Err(error) => Marking::unreadable(error.sentence(response)),
        };
        if matches!(first.verdict, Verdict::Unreadable | Verdict::Wrong)
            && !first
                .reasons
                .iter()
                .any(|reason| matches!(reason, Reason::Mistake(_)))
            && let Some(marking) = self.mark_with_unit(response)
        {
            return marking;
        }
        first
    }
}

impl Prepared {
    /// The marking of numbers with a unit, behind the function or behind its first number.
    fn mark_with_unit(&self, response: &str) -> Option<Marking> {
        let setup = &self.setup;
        let own = setup.unit?;
        let start = response.rfind('=').map_or(0, |at| at + 1);
        let value = response[start..].trim();
        let bare = |text: &str| {
            let typed = typed::formula(text, &setup.lexicon, manner(text)).ok()?;
            (!self.has_data(&typed.value)).then_some(typed)
        };
        let behind = typed::with_unit(value).find_map(|(text, unit)| Some((bare(text)?, unit)));
        let (typed, unit) = behind.or_else(|| {
            let (text, unit) = unit_in_front(value)?;
            Some((bare(&text)?, unit))
        })?;
        if unit.dimension() != own.dimension() {
            let words = format!("The unit does not fit; what is asked is in {}.", own.text());
            return Some(Marking::unreadable(words));
        }
        let values = self.values_of(&typed.value)?;
        let values: Vec<f64> = values.iter().map(|value| unit.to_si(*value)).collect();
        let reading = Reading {
            math: Math::row([
                typed.value.typeset(&setup.lexicon),
                Math::thin_space(),
                unit.math(),
            ]),
            text: format!("({}) {}", typed.value, unit.text()),
            si: Vec::new(),
        };
        Some(self.judged(
            reading,
            &typed.value,
            |key| self.is_near(&values, key),
            &values,
        ))
    }

    /// Whether letters of the question stand in a function.
    fn has_data(&self, expr: &Expr) -> bool {
        let names = expr.names();
        names
            .free
            .iter()
            .any(|variable| variable.name != self.setup.variable)
    }

    fn mark_typed(&self, Typed { value, other }: Typed<Expr>) -> Marking {
        let setup = &self.setup;
        let trouble = self.dimension_trouble(&value);
        let expr = match other {
            Some(other) if trouble.is_some() && self.dimension_trouble(&other).is_none() => other,
            _ => value,
        };
        let reading = Reading {
            math: expr.typeset(&setup.lexicon),
            text: expr.to_string(),
            si: Vec::new(),
        };
        let Some(values) = self.values_of(&expr) else {
            let words = "This has no value somewhere on the span.".to_owned();
            return Marking::read(
                reading,
                Credit::NONE,
                Reason::Other,
                Some(Feedback::Words(words)),
            );
        };
        // Numbers without data may be in the unit that is asked for.
        let shown = setup.unit.map(|unit| {
            values
                .iter()
                .map(|value| unit.to_si(*value))
                .collect::<Vec<_>>()
        });
        let shown = shown.filter(|_| !self.has_data(&expr));
        let fits = |key: &[f64]| {
            self.is_near(&values, key)
                || shown.as_ref().is_some_and(|shown| self.is_near(shown, key))
        };
        self.judged(reading, &expr, fits, &values)
    }

    /// The marking of a function that was read, by whether it fits other values at the times.
    fn judged(
        &self,
        reading: Reading,
        expr: &Expr,
        fits: impl Fn(&[f64]) -> bool,
        values: &[f64],
    ) -> Marking {
        if fits(&self.values) {
            return Marking::read(reading, Credit::FULL, Reason::Matches, None);
        }
        if let Some((number, _, credit)) = self.mistakes.iter().find(|(_, given, _)| fits(given)) {
            let feedback = Some(Feedback::Mistake(*number));
            return Marking::read(reading, *credit, Reason::Mistake(*number), feedback);
        }
        let negated: Vec<f64> = self.values.iter().map(|value| -value).collect();
        let (reason, words) = if self.dimension_trouble(expr).is_some() {
            let found = self
                .dimension_trouble(expr)
                .map_or(String::new(), Dimension::describe);
            (
                Reason::Dimension,
                Some(format!("This comes out in {found}.")),
            )
        } else if fits(&negated) {
            (Reason::Sign, Some("The sign is wrong.".to_owned()))
        } else if self.starts_right(values) {
            (
                Reason::Other,
                Some(
                    "It begins rightly, but runs away later: look at the frequency and the decay."
                        .to_owned(),
                ),
            )
        } else {
            (Reason::Other, None)
        };
        Marking::read(reading, Credit::NONE, reason, words.map(Feedback::Words))
    }

    /// Whether the first samples are right.
    fn starts_right(&self, typed: &[f64]) -> bool {
        let first = 3;
        typed[..first]
            .iter()
            .zip(&self.values)
            .zip(&self.halves)
            .all(|((typed, key), half)| (typed - key).abs() <= 2.0 * half)
    }
}
