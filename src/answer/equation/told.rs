//! What is wrong with equations, by their terms: a sign, a term that is missing, a datum that it misses.

use super::Setup;
use super::points::Choice;
use super::terms::{Coefficients, Match, Nature, Term, is_nearly, is_same, terms as of_unknowns};
use crate::answer::meaning::ORDERS;
use crate::answer::{Coefficient, Fault, Linearity, Term as Named, TermKind, Terms};
use crate::expr::{Name, Precise, Program};

/// What is wrong with which term.
type Faults = Vec<(Named, Fault)>;

/// Most data that are named.
const MAX_NAMED: usize = 3;

/// What is wrong with the first equation that is none of the key, next to the one of the key that is most like it.
pub(crate) fn terms(
    setup: &Setup,
    key: &[Program],
    typed: &[Program],
    points: &[Choice],
) -> Option<Terms> {
    let point = points.first()?.first()?;
    let all = of_unknowns(setup);
    let coefficients = |programs: &[Program]| -> Option<Vec<Coefficients>> {
        programs
            .iter()
            .map(|program| Coefficients::of(program, &all, point))
            .collect()
    };
    let (own, found) = (coefficients(key)?, coefficients(typed)?);
    for place in 0..typed.len() {
        let matches = (0..own.len())
            .filter_map(|key| Some((key, Match::of(&own[key].values, &found[place].values)?)));
        let best = matches.min_by_key(|(_, matched)| matched.differing.len());
        let Some((nearest, matched)) = best else {
            continue;
        };
        let pair = EquationPair {
            setup,
            terms: &all,
            point,
            key: (&key[nearest], &own[nearest]),
            typed: (&typed[place], &found[place]),
        };
        let found = match pair.linearity() {
            Some(linearity) => Some((Vec::new(), Some(linearity))),
            None if matched.differing.is_empty() => continue,
            None if own[nearest].is_linear() && !found[place].is_linear() => pair.besides_curves(),
            None => pair.faults(&matched).map(|faults| (faults, None)),
        };
        let (faults, linearity) = found?;
        return Some(Terms {
            equation: (typed.len() > 1).then_some(place + 1),
            faults,
            linearity,
        });
    }
    None
}

/// An equation of the key and a typed one that is like it.
struct EquationPair<'a> {
    setup: &'a Setup,
    terms: &'a [Term],
    point: &'a [Precise],
    key: (&'a Program, &'a Coefficients),
    typed: (&'a Program, &'a Coefficients),
}

impl EquationPair<'_> {
    /// How the two differ if they agree for small motions alone.
    fn linearity(&self) -> Option<Linearity> {
        let (own, found) = (self.key.1, self.typed.1);
        if own.is_linear() && found.is_linear() {
            return None;
        }
        let reference = (0..own.slopes.len())
            .find(|place| own.slopes[*place] != 0.0 && found.slopes[*place] != 0.0)?;
        let scale = found.slopes[reference] / own.slopes[reference];
        let agree = (0..own.slopes.len())
            .all(|place| is_nearly(scale * own.slopes[place], found.slopes[place]));
        let curves_differ = !(0..own.values.len())
            .all(|place| is_nearly(scale * own.values[place], found.values[place]));
        agree.then_some(if own.is_linear() {
            Linearity::Due
        } else if found.is_linear() {
            Linearity::Surplus
        } else if curves_differ {
            Linearity::WrongForLarge
        } else {
            return None;
        })
    }

    /// What is wrong with an equation for small motions, which has still to be linearized besides.
    fn besides_curves(&self) -> Option<(Faults, Option<Linearity>)> {
        let flat = self.typed.1.linearized();
        let pair = EquationPair {
            typed: (self.typed.0, &flat),
            ..*self
        };
        let matched = Match::of(&self.key.1.values, &flat.values)?;
        let faults = pair.faults(&matched).unwrap_or_default();
        Some((faults, Some(Linearity::DueBesides)))
    }

    fn faults(&self, matched: &Match) -> Option<Faults> {
        if !matched.is_telling() {
            return None;
        }
        let faults = matched.differing.iter().map(|&place| {
            let due = matched.scale * self.key.1.values[place];
            let given = self.typed.1.values[place];
            let name = self.name(place, due == 0.0);
            let fault = if given == 0.0 {
                Fault::Missing
            } else if due == 0.0 {
                Fault::Surplus
            } else if is_same(due, -given) {
                Fault::Sign
            } else {
                Fault::Coefficient(self.coefficient(place, matched))
            };
            (name, fault)
        });
        Some(faults.collect())
    }

    /// What is wrong with a coefficient, next to one that is right.
    fn coefficient(&self, place: usize, matched: &Match) -> Coefficient {
        let (mut missed, mut surplus) = (Vec::new(), Vec::new());
        let mut is_number = true;
        for (at, input) in self.setup.meaning.inputs.iter().enumerate() {
            if input.is_moving || input.name.as_str() == "t" {
                continue;
            }
            let change = |of: (&Program, &Coefficients)| self.change(of, at, place, matched);
            let (Some(own), Some(typed)) = (change(self.key), change(self.typed)) else {
                continue;
            };
            is_number &= is_same(own, typed);
            let symbol = || {
                let title = input.title.as_ref().map(ToString::to_string);
                (self.symbol(&input.name), title)
            };
            match (is_same(own, 1.0), is_same(typed, 1.0)) {
                (false, true) => missed.push(symbol()),
                (true, false) => surplus.push(symbol()),
                _ => {}
            }
        }
        if is_number {
            return Coefficient::Number;
        }
        if missed.is_empty() && surplus.is_empty()
            || missed.len() > MAX_NAMED
            || surplus.len() > MAX_NAMED
        {
            return Coefficient::Other;
        }
        Coefficient::Data { missed, surplus }
    }

    /// By which factor a coefficient, over another one that is right, changes with a datum.
    fn change(
        &self,
        (program, before): (&Program, &Coefficients),
        at: usize,
        place: usize,
        matched: &Match,
    ) -> Option<f64> {
        let mut moved = self.point.to_vec();
        moved[at * ORDERS] = Precise::exact(1.25 * self.point[at * ORDERS].high());
        let after = Coefficients::of(program, self.terms, &moved)?;
        let after = if before.are_linearized() {
            after.linearized()
        } else {
            after
        };
        let part = |of: &Coefficients| {
            // Where the equations are written alike, the coefficient speaks for itself.
            let one = if matched.is_plain() {
                1.0
            } else {
                of.values[matched.reference]
            };
            of.values[place] / one
        };
        Some(part(&after) / part(before)).filter(|change| change.is_finite())
    }

    /// What a term is called.
    fn name(&self, place: usize, is_of_typed: bool) -> Named {
        let of = if is_of_typed { self.typed } else { self.key };
        let Term::Unknown { place: at, order } = self.terms[place] else {
            let unknowns = self.setup.unknowns.iter();
            return Named {
                kind: if self.varies_with_time(of.0) {
                    TermKind::Exciting
                } else {
                    TermKind::Other
                },
                unknown: None,
                without: unknowns.map(|name| self.symbol(name)).collect(),
            };
        };
        let kind = match (order, of.1.nature(place)) {
            _ if !self.moves() => TermKind::Other,
            (2, _) => TermKind::Inertia,
            (1, Nature::Sign) => TermKind::Friction,
            (1, _) => TermKind::Damping,
            _ => TermKind::Stiffness,
        };
        let symbol = self.symbol(&self.setup.meaning.inputs[at].name);
        Named {
            kind,
            unknown: Some(format!("{symbol}{}", ["", "′", "″"][order.min(2)])),
            without: Vec::new(),
        }
    }

    /// Whether one of the two is about a motion: geometry knows neither inertia nor stiffness.
    fn moves(&self) -> bool {
        let is_rate = |term: &Term| matches!(term, Term::Unknown { order, .. } if *order > 0);
        let mut places = (0..self.terms.len()).filter(|place| is_rate(&self.terms[*place]));
        places.any(|place| self.key.1.values[place] != 0.0 || self.typed.1.values[place] != 0.0)
    }

    /// Whether what stands without unknowns changes with time.
    fn varies_with_time(&self, program: &Program) -> bool {
        let Some(time) = self.setup.meaning.place(&Name::new("t")) else {
            return false;
        };
        let mut later = self.point.to_vec();
        // No simple multiple, at which a periodic force may be the same again, and another time than zero.
        later[time * ORDERS] = Precise::exact(1.37 * self.point[time * ORDERS].high() + 0.1);
        let rest = |point: &[Precise]| {
            Coefficients::of(program, self.terms, point)?
                .values
                .last()
                .copied()
        };
        match (rest(self.point), rest(&later)) {
            (Some(now), Some(later)) => !is_same(now, later),
            _ => false,
        }
    }

    /// A name as it is typed: `k2` for k₂.
    fn symbol(&self, name: &Name) -> String {
        self.setup.lexicon.typable(name)
    }
}
