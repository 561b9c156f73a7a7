//! What is wrong with equations, told by their terms: a sign, a term that is missing, a datum that it misses.

use super::Setup;
use super::points::Choice;
use super::terms::{Coefficients, Match, Nature, Term, is_nearly, is_same, terms};
use crate::answer::meaning::ORDERS;
use crate::expr::{Name, Notation, Precise, Program};

/// What is said about wrong equations.
pub(super) struct Told {
    pub(super) words: String,
    /// Whether only signs are wrong.
    pub(super) is_sign: bool,
}

/// What is wrong with one equation.
struct Fault {
    sentences: Vec<String>,
    is_sign: bool,
}

/// Most data that a sentence names.
const MOST_NAMED: usize = 3;

/// What is wrong with the first equation that is none of the key, next to the one of the key that is most like it.
pub(super) fn told(
    setup: &Setup,
    key: &[Program],
    typed: &[Program],
    points: &[Choice],
) -> Option<Told> {
    let point = points.first()?.first()?;
    let all = terms(setup);
    let coefficients = |programs: &[Program]| -> Option<Vec<Coefficients>> {
        programs
            .iter()
            .map(|program| Coefficients::of(program, &all, point))
            .collect()
    };
    let (own, found) = (coefficients(key)?, coefficients(typed)?);
    let best = |place: usize| {
        let matches = (0..own.len()).filter_map(|key| {
            let matched = Match::of(&own[key].values, &found[place].values)?;
            Some((key, matched))
        });
        matches.min_by_key(|(_, matched)| matched.differing.len())
    };
    for place in 0..typed.len() {
        let Some((nearest, matched)) = best(place) else {
            continue;
        };
        let pair = Pair {
            setup,
            terms: &all,
            point,
            key: (&key[nearest], &own[nearest]),
            typed: (&typed[place], &found[place]),
        };
        let fault = match pair.linearization() {
            Some(sentence) => Some(Fault {
                sentences: vec![sentence.to_owned()],
                is_sign: false,
            }),
            None if matched.differing.is_empty() => continue,
            None if own[nearest].is_linear() && !found[place].is_linear() => pair.besides_curves(),
            None => pair.fault(&matched),
        };
        let fault = fault?;
        let words = fault.sentences.join(" ");
        let words = if typed.len() > 1 {
            format!("Equation {}: {words}", place + 1)
        } else {
            words
        };
        return Some(Told {
            words,
            is_sign: fault.is_sign,
        });
    }
    None
}

/// An equation of the key and a typed one that is like it.
struct Pair<'a> {
    setup: &'a Setup,
    terms: &'a [Term],
    point: &'a [Precise],
    key: (&'a Program, &'a Coefficients),
    typed: (&'a Program, &'a Coefficients),
}

impl Pair<'_> {
    /// What is said if the two agree for small motions alone.
    fn linearization(&self) -> Option<&'static str> {
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
            "It is right as it stands, but it has still to be linearized for small motions."
        } else if found.is_linear() {
            "This holds for small motions alone; the equation is asked without that approximation."
        } else if curves_differ {
            "It is right for small motions alone: look at how it depends on large ones."
        } else {
            return None;
        })
    }

    /// What is wrong with an equation for small motions, which has still to be linearized besides.
    fn besides_curves(&self) -> Option<Fault> {
        let flat = self.typed.1.linearized();
        let pair = Pair {
            typed: (self.typed.0, &flat),
            ..*self
        };
        let matched = Match::of(&self.key.1.values, &flat.values)?;
        let known = pair.fault(&matched);
        let last = match &known {
            Some(_) => "It has to be linearized for small motions as well.",
            None => "It is not right yet, and it has to be linearized for small motions as well.",
        };
        let mut sentences = known.map_or(Vec::new(), |fault| fault.sentences);
        sentences.push(last.to_owned());
        Some(Fault {
            sentences,
            is_sign: false,
        })
    }

    fn fault(&self, matched: &Match) -> Option<Fault> {
        if !matched.is_telling() {
            return None;
        }
        let mut fault = Fault {
            sentences: Vec::new(),
            is_sign: true,
        };
        for &place in &matched.differing {
            let due = matched.scale * self.key.1.values[place];
            let given = self.typed.1.values[place];
            let name = self.name(place, due == 0.0);
            let is_sign = is_same(due, -given);
            fault.is_sign &= is_sign;
            fault.sentences.push(if given == 0.0 {
                format!("The {name} is missing.")
            } else if due == 0.0 {
                format!("There should be no {name}.")
            } else if is_sign {
                format!("The sign of the {name} is wrong.")
            } else {
                self.coefficient(place, matched, &name)
            });
        }
        Some(fault)
    }

    /// What is wrong with a coefficient, next to one that is right.
    fn coefficient(&self, place: usize, matched: &Match, name: &str) -> String {
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
            let symbol = || match &input.title {
                Some(title) => format!("{} ({title})", self.symbol(&input.name)),
                None => self.symbol(&input.name),
            };
            match (is_same(own, 1.0), is_same(typed, 1.0)) {
                (false, true) => missed.push(symbol()),
                (true, false) => surplus.push(symbol()),
                _ => {}
            }
        }
        if is_number {
            return format!("The number in front of the {name} is wrong.");
        }
        let few = |names: &[String]| (1..=MOST_NAMED).contains(&names.len());
        match (few(&missed), few(&surplus)) {
            (true, false) if surplus.is_empty() => {
                format!("The {name} misses {}.", listed(&missed))
            }
            (false, true) if missed.is_empty() => {
                format!("The {name} should not contain {}.", listed(&surplus))
            }
            (true, true) => format!(
                "The {name} misses {} and should not contain {}.",
                listed(&missed),
                listed(&surplus)
            ),
            _ => format!("The coefficient of the {name} is wrong."),
        }
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
    fn name(&self, place: usize, is_of_typed: bool) -> String {
        let of = if is_of_typed { self.typed } else { self.key };
        let Term::Unknown { place: at, order } = self.terms[place] else {
            let names: Vec<String> = self
                .setup
                .unknowns
                .iter()
                .map(|name| self.symbol(name))
                .collect();
            let kind = if self.varies_with_time(of.0) {
                "exciting term"
            } else {
                "term"
            };
            return format!("{kind} without {}", listed(&names));
        };
        let kind = match (order, of.1.nature(place)) {
            _ if !self.moves() => "term",
            (2, _) => "inertia term",
            (1, Nature::Sign) => "friction term",
            (1, _) => "damping term",
            _ => "stiffness term",
        };
        let symbol = self.symbol(&self.setup.meaning.inputs[at].name);
        format!("{kind} (in {symbol}{})", ["", "′", "″"][order.min(2)])
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
        let digit = |char: char| match char {
            '₀'..='₉' => char::from(b'0' + (u32::from(char) - u32::from('₀')) as u8),
            char => char,
        };
        let plain = self.setup.lexicon.name(name).math.plain();
        plain.chars().map(digit).collect()
    }
}

/// Names with commas and a last `and`.
fn listed(names: &[String]) -> String {
    match names {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}
