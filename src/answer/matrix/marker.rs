//! Marks matrices entry by entry, as formulas or as numbers.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::{Setup, Written};
use crate::answer::equality::{Comparable, Comparison, Points};
use crate::answer::trial::typed as typed_number;
use crate::answer::typed::{self, Listed, Manner};
use crate::answer::{
    Credit, Feedback, Key, KeyValue, Marker, Marking, Nature, Reading, Reason, Trial, symbolic,
};
use crate::expr::{Expr, Value};
use crate::math::Math;
use crate::unit::{Decimal, Unit};

/// A prepared key.
pub(super) struct Prepared {
    pub(super) setup: Arc<Setup>,
    /// The entries as formulas, where they can be compared as such.
    pub(super) formulas: Option<(Vec<Comparable>, Points)>,
    pub(super) value: Value,
    pub(super) halves: Vec<f64>,
    pub(super) mistakes: Vec<Mistake>,
}

pub(super) struct Mistake {
    pub(super) number: usize,
    pub(super) formulas: Vec<Comparable>,
    pub(super) numbers: Vec<f64>,
    pub(super) credit: Credit,
}

impl Prepared {
    fn mark_formulas(&self, reading: Reading, entries: &[Expr]) -> Marking {
        let setup = &self.setup;
        let Some((keys, points)) = &self.formulas else {
            return Marking::unreadable("Give the entries as numbers.");
        };
        let Some(typed) = setup.compile(entries, &BTreeMap::new()) else {
            return Marking::unreadable(
                "These entries cannot be compared; write them in a simpler form.",
            );
        };
        let is_same = |keys: &[Comparable], place: usize| {
            points.compare(&keys[place], &typed[place]) == Comparison::Same
        };
        let wrong: Vec<usize> = (0..typed.len())
            .filter(|place| !is_same(keys, *place))
            .collect();
        if wrong.is_empty() {
            return Marking::read(reading, Credit::FULL, Reason::Matches, None);
        }
        let named = self.mistakes.iter().find(|mistake| {
            mistake.formulas.len() == typed.len()
                && (0..typed.len()).all(|place| is_same(&mistake.formulas, place))
        });
        self.wrong(reading, named, &wrong)
    }

    /// Marks entries in symbols behind which a unit stands all the same.
    fn mark_with_unit(&self, reading: Reading, entries: &[Expr], tail: &str) -> Marking {
        let unit = tail.trim();
        let dimension = Unit::read(unit).ok().map(|unit| unit.dimension());
        let is_own = |own: &Unit| Some(own.dimension()) == dimension;
        if !self.setup.units.iter().any(is_own) {
            return Marking::unreadable(format!(
                "At `{unit}`: this is left over behind the matrix. Letters carry their units: leave it out."
            ));
        }
        let mut marking = self.mark_formulas(reading, entries);
        let words = format!("Letters carry their units: leave out `{unit}`.");
        marking.feedback.push(Feedback::Words(words));
        marking
    }

    fn mark_numbers(&self, reading: Reading, numbers: &[f64]) -> Marking {
        let near = |place: usize, key: f64| {
            let slack = 4.0 * f64::EPSILON * key.abs() + self.value.bounds()[place];
            (numbers[place] - key).abs() <= self.halves[place] + slack
        };
        let keys = self.value.numbers();
        let wrong: Vec<usize> = (0..numbers.len())
            .filter(|place| !near(*place, keys[*place]))
            .collect();
        if wrong.is_empty() {
            return Marking::read(reading, Credit::FULL, Reason::Matches, None);
        }
        let named = self.mistakes.iter().find(|mistake| {
            mistake.numbers.len() == numbers.len()
                && (0..numbers.len()).all(|place| near(place, mistake.numbers[place]))
        });
        self.wrong(reading, named, &wrong)
    }

    fn wrong(&self, reading: Reading, named: Option<&Mistake>, wrong: &[usize]) -> Marking {
        if let Some(mistake) = named {
            let feedback = Some(Feedback::Mistake(mistake.number));
            return Marking::read(
                reading,
                mistake.credit,
                Reason::Mistake(mistake.number),
                feedback,
            );
        }
        let place = |at: &usize| {
            format!(
                "({}, {})",
                at / self.setup.columns + 1,
                at % self.setup.columns + 1
            )
        };
        let words = match wrong {
            [one] => format!("The entry {} is wrong.", place(one)),
            many if 2 * many.len() <= self.halves.len() => {
                let places: Vec<String> = many.iter().map(place).collect();
                format!("The entries {} are wrong.", places.join(", "))
            }
            _ => return Marking::read(reading, Credit::NONE, Reason::Other, None),
        };
        Marking::read(
            reading,
            Credit::NONE,
            Reason::Other,
            Some(Feedback::Words(words)),
        )
    }

    /// The numbers of entries without names in SI units, or why they have none.
    fn numbers(&self, entries: &[Expr], tail: &str) -> Result<Vec<f64>, String> {
        let stated = match tail.trim() {
            "" => None,
            tail => Some(Unit::read(tail).map_err(|error| format!("At `{tail}`: {error}."))?),
        };
        let value = |(place, entry): (usize, &Expr)| {
            let number = crate::expr::Program::compile(entry, &crate::expr::Slots(&[]))
                .ok()
                .and_then(|program| {
                    let none: [crate::expr::Precise; 0] = [];
                    program
                        .evaluate(&none, &mut crate::expr::Workspace::default())
                        .ok()?
                        .as_real()
                })
                .ok_or_else(|| "An entry has no value.".to_owned())?;
            let unit = self.setup.units.get(place).copied().unwrap_or(Unit::ONE);
            let shown = stated.unwrap_or(unit);
            if number == 0.0 || shown.dimension() == unit.dimension() {
                Ok(shown.to_si(number))
            } else {
                Err(format!(
                    "The unit `{}` does not fit all entries.",
                    tail.trim()
                ))
            }
        };
        entries.iter().enumerate().map(value).collect()
    }
}

impl Marker for Prepared {
    fn trials(&self) -> Vec<Trial> {
        let setup = &self.setup;
        let rows = |entries: Vec<String>| {
            let rows = entries.chunks(setup.columns.max(1));
            let rows = rows.map(|row| format!("[{}]", row.join(", ")));
            format!("[{}]", rows.collect::<Vec<_>>().join(", "))
        };
        let mut trials = vec![
            Trial::new(Nature::Unreadable, "stiff"),
            Trial::new(Nature::Unreadable, "[[1, 2, 3, 4, 5, 6, 7]]"),
        ];
        if setup.written != Written::Formula || !self.is_symbolic() {
            let numbers = |place: usize, share: f64| {
                let entries = self.value.numbers().iter().enumerate().map(|(at, number)| {
                    let step = if at == place {
                        share * self.halves[at]
                    } else {
                        0.0
                    };
                    let unit = setup.units.get(at).copied().unwrap_or(Unit::ONE);
                    typed_number(unit.of_si(number + step))
                });
                rows(entries.collect())
            };
            trials.push(Trial::new(Nature::Right, numbers(0, 0.0)));
            if let Some(place) = self.halves.iter().position(|half| *half > 0.0) {
                trials.push(Trial::new(Nature::Borderline, numbers(place, 0.99)));
                trials.push(Trial::new(Nature::Wrong, numbers(place, 1.01)));
            }
        }
        let texts: Vec<String> = symbolic::entries(&setup.expr, setup.shape())
            .iter()
            .map(ToString::to_string)
            .collect();
        let is_typable = texts
            .iter()
            .all(|text| !text.contains('[') && !text.contains("if "));
        // What the entries are written in may be more than an answer may use.
        let reads = |text: &String| typed::formula(text, &setup.lexicon, Manner::default()).is_ok();
        if self.formulas.is_some()
            && setup.written != Written::Number
            && is_typable
            && texts.iter().all(reads)
        {
            trials.push(Trial::new(Nature::Right, rows(texts.clone())));
            if let Some(place) = texts.iter().position(|text| text != "0") {
                let mut wrong = texts;
                wrong[place] = format!("1.000001*({})", wrong[place]);
                trials.push(Trial::new(Nature::Wrong, rows(wrong)));
            }
        }
        trials
    }

    fn key(&self) -> Key {
        let setup = &self.setup;
        let digits = 6;
        let entry = |number: f64| match Decimal::rounded(number, digits) {
            Some(_) if number == 0.0 => Math::number("0"),
            Some(decimal) => {
                let shortest = Decimal::shortest(decimal.to_f64()).unwrap_or(decimal);
                Math::number(shortest.to_string())
            }
            None => Math::text("out of range"),
        };
        let math = if self.formulas.is_some() && setup.written != Written::Number {
            setup.typeset(&symbolic::entries(&setup.expr, setup.shape()))
        } else {
            let rows = self.value.numbers().chunks(setup.columns);
            Math::matrix(
                rows.map(|row| row.iter().map(|number| entry(*number)).collect())
                    .collect(),
            )
        };
        Key {
            math,
            accepted: None,
            value: KeyValue::Numbers {
                form: self.value.form(),
                si: self.value.numbers().to_vec(),
            },
        }
    }

    fn mark(&self, response: &str) -> Marking {
        let setup = &self.setup;
        let start = response.rfind('=').map_or(0, |at| at + 1);
        let response = &typed::rows_by_line(response);
        let fits = |listed: &Listed| {
            listed.rows.len() == setup.rows
                && listed.rows.iter().all(|row| row.len() == setup.columns)
        };
        let listed = typed::list_of_size(response, start, &setup.lexicon, Manner::default(), fits);
        let Listed { rows, tail } = match listed {
            Ok(listed) if fits(&listed) => listed,
            Ok(Listed { rows, .. }) => {
                return Marking::unreadable(format!(
                    "This has {} of {}; a matrix of {} by {} is asked, such as `[[a, b], [c, d]]`.",
                    counted(rows.len(), "row"),
                    rows.first().map_or(0, Vec::len),
                    setup.rows,
                    setup.columns
                ));
            }
            Err(error) => return Marking::unreadable(error.sentence(response)),
        };
        let entries = rows.concat();
        let tail = response.get(tail.range()).unwrap_or_default();
        let has_names = entries.iter().any(|entry| !entry.names().free.is_empty());
        let mut reading = Reading {
            math: setup.typeset(&entries),
            text: Expr::array(rows.into_iter().map(Expr::array).collect::<Vec<_>>()).to_string(),
            si: Vec::new(),
        };
        match (has_names, setup.written) {
            (true, Written::Number) => Marking::unreadable("Numbers are asked here, not formulas."),
            (true, _) if !tail.trim().is_empty() => self.mark_with_unit(reading, &entries, tail),
            (true, _) => self.mark_formulas(reading, &entries),
            (false, Written::Formula) if self.is_symbolic() => {
                Marking::unreadable("Formulas in symbols are asked here, not numbers.")
            }
            (false, _) => match self.numbers(&entries, tail) {
                Ok(numbers) => {
                    reading.si.clone_from(&numbers);
                    self.mark_numbers(reading, &numbers)
                }
                Err(words) => Marking::unreadable(words),
            },
        }
    }
}

/// A count with its noun.
pub(in crate::answer) fn counted(count: usize, noun: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {noun}{plural}")
}

impl Prepared {
    /// Whether the key depends on data.
    fn is_symbolic(&self) -> bool {
        !self.setup.expr.names().free.is_empty()
    }
}
