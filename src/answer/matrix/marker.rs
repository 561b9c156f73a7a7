//! Marks matrices entry by entry, as formulas or as numbers.

use std::sync::Arc;

use super::{Setup, Written, slip};
use crate::answer::equality::{Comparable, Comparison, Points};
use crate::answer::trial::typed as typed_number;
use crate::answer::{
    Answered, Credit, Key, KeyValue, Marker, Marking, Nature, Note, Reading, Remark, Slip, Trial,
    Unreadable, Why, symbolic,
};
use crate::expr::{Expr, Value};
use crate::math::Math;
use crate::numerics::SortedMap;
use crate::response::{Listed, Manner, Passage, Wanted};
use crate::unit::{Decimal, Unit};

/// A prepared key.
pub(crate) struct Prepared {
    pub(crate) setup: Arc<Setup>,
    /// The entries as formulas, where they can be compared as such.
    pub(crate) formulas: Option<(Arc<Vec<Comparable>>, Arc<Points>)>,
    pub(crate) value: Value,
    pub(crate) halves: Vec<f64>,
    pub(crate) mistakes: Vec<Mistake>,
}

pub(crate) struct Mistake {
    pub(crate) number: usize,
    pub(crate) formulas: Option<Arc<Vec<Comparable>>>,
    pub(crate) numbers: Vec<f64>,
    pub(crate) credit: Credit,
}

impl Prepared {
    fn mark_formulas(&self, reading: Reading, entries: &[Expr]) -> Marking {
        let setup = &self.setup;
        let Some(formulas) = &self.formulas else {
            return Marking::unreadable(Why::EntriesAsNumbers);
        };
        let (keys, points) = formulas;
        let Some(typed) = setup.compile(entries, &SortedMap::new()) else {
            return Marking::unreadable(Why::IncomparableEntries);
        };
        let compare = |keys: &[Comparable]| -> Vec<Comparison> {
            let pairs = keys.iter().zip(&typed);
            pairs
                .map(|(key, typed)| points.compare(key, typed))
                .collect()
        };
        let comparisons = compare(keys);
        let is_same = |own: &Comparison| *own == Comparison::Same;
        let wrong: Vec<usize> = (0..typed.len())
            .filter(|place| !is_same(&comparisons[*place]))
            .collect();
        let named = || {
            self.mistakes.iter().find(|mistake| {
                mistake.formulas.as_ref().is_some_and(|formulas| {
                    formulas.len() == typed.len() && compare(formulas).iter().all(is_same)
                })
            })
        };
        self.marking(reading, &wrong, named, || {
            let misfit = slip::wrong_dimension(self, entries, &wrong).map(Remark::from);
            misfit.or_else(|| Some(slip::of_formulas(self, formulas, &typed, &comparisons)?.into()))
        })
    }

    /// Marks entries in symbols after which a unit stands all the same.
    fn mark_with_unit(&self, reading: Reading, entries: &[Expr], unit: &Unit) -> Marking {
        let (dimension, text) = (unit.dimension(), unit.text());
        let mut units = self.setup.units.iter();
        if !units.any(|own| own.dimension() == dimension) {
            return Marking::unreadable(Unreadable::at(text, Why::UnitBehindMatrix));
        }
        let mut marking = self.mark_formulas(reading, entries);
        marking.remarks.push(Note::LettersCarryUnits(text).into());
        marking
    }

    fn mark_numbers(&self, reading: Reading, numbers: &[f64]) -> Marking {
        let are_near =
            |keys: &[f64], place: usize| self.is_near(place, numbers[place], keys[place]);
        let keys = self.value.numbers();
        let wrong: Vec<usize> = (0..numbers.len())
            .filter(|place| !are_near(keys, *place))
            .collect();
        let named = || {
            self.mistakes.iter().find(|mistake| {
                mistake.numbers.len() == numbers.len()
                    && (0..numbers.len()).all(|place| are_near(&mistake.numbers, place))
            })
        };
        let slip = || slip::of_numbers(self, numbers).map(Remark::from);
        self.marking(reading, &wrong, named, slip)
    }

    /// Whether a number is as near to a key as the tolerance of an entry has it. Beside a zero, what rounding in a
    /// computer leaves of it counts as zero.
    pub(crate) fn is_near(&self, place: usize, number: f64, key: f64) -> bool {
        // Far above what sixteen digits leave, and far below any entry beside these.
        const DUST: f64 = 1e-9;
        let sizes = self.value.numbers().iter().map(|own| own.abs());
        let dust = if key == 0.0 {
            DUST * sizes.fold(0.0, f64::max)
        } else {
            4.0 * f64::EPSILON * key.abs()
        };
        (number - key).abs() <= self.halves[place] + self.value.bounds()[place] + dust
    }

    /// The marking of entries of which these are wrong.
    fn marking<'a>(
        &'a self,
        reading: Reading,
        wrong: &[usize],
        named: impl FnOnce() -> Option<&'a Mistake>,
        slip: impl FnOnce() -> Option<Remark>,
    ) -> Marking {
        if wrong.is_empty() {
            return Marking::right(reading);
        }
        if let Some(mistake) = named() {
            return Marking::mistake(reading, mistake.number, mistake.credit);
        }
        Marking::wrong(reading, slip().or_else(|| self.entries(wrong)))
    }

    /// Which entries are wrong, where they are few.
    fn entries(&self, wrong: &[usize]) -> Option<Remark> {
        let are_few = wrong.len() == 1 || 2 * wrong.len() <= self.halves.len();
        let places = wrong.iter().map(|place| self.place(*place));
        are_few.then(|| Slip::Entries(places.collect()).into())
    }

    /// The row and the column of an entry, from 1.
    pub(crate) fn place(&self, at: usize) -> (usize, usize) {
        let columns = self.setup.columns;
        (at / columns + 1, at % columns + 1)
    }

    /// The numbers of entries without names in SI units, or why they have none.
    fn numbers(&self, entries: &[Expr], stated: Option<&Unit>) -> Result<Vec<f64>, Unreadable> {
        let values = entries.iter().enumerate().map(|(place, entry)| {
            let number = crate::expr::Program::compile(entry, &crate::expr::Slots(&[]))
                .ok()
                .and_then(|program| {
                    let none: [crate::expr::Precise; 0] = [];
                    program
                        .evaluate(&none, &mut crate::expr::Workspace::default())
                        .ok()?
                        .as_real()
                })
                .ok_or(Why::EntryValue)?;
            let unit = self.setup.units.get(place).copied().unwrap_or(Unit::ONE);
            let shown = stated.copied().unwrap_or(unit);
            if number == 0.0 || shown.dimension() == unit.dimension() {
                Ok(shown.to_si(number))
            } else {
                Err(Why::UnitOfEntries(shown).into())
            }
        });
        values.collect()
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
        let mut formulas = texts
            .iter()
            .map(|text| Passage::of(text).formula(&setup.lexicon, Manner::default()));
        if self.formulas.is_some()
            && setup.written != Written::Number
            && is_typable
            && formulas.all(|formula| formula.is_ok())
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

    fn mark(&self, response: Passage<'_>) -> Marking {
        let setup = &self.setup;
        let fits = |listed: &Listed| {
            listed.rows.len() == setup.rows
                && listed.rows.iter().all(|row| row.len() == setup.columns)
        };
        let wanted = Wanted::Matrix(Some(setup.rows).filter(|rows| *rows == setup.columns));
        let read =
            |response: Passage<'_>| response.list(&setup.lexicon, &setup.units, wanted, fits);
        let listed = read(response).or_else(|error| {
            let bare = response.without_units_of_entries(&setup.units, false);
            bare.and_then(|bare| read(bare.passage()).ok()).ok_or(error)
        });
        let listed = match listed {
            Ok(listed) if fits(&listed) => listed,
            Ok(Listed { rows, .. }) => {
                return Marking::unreadable(Why::Shape {
                    found: (rows.len(), rows.first().map_or(0, Vec::len)),
                    asked: (setup.rows, setup.columns),
                });
            }
            Err(error) => return Marking::unreadable(Unreadable::typed(&error, response)),
        };
        let has_names = !listed.is_numeric();
        let Listed { rows, unit } = listed;
        let entries = rows.concat();
        let array = Expr::array(rows.iter().cloned().map(Expr::array).collect::<Vec<_>>());
        let mut reading = Reading {
            math: setup.typeset(&entries),
            text: array.to_string(),
            answered: Answered::SymbolicMatrix(rows),
        };
        if has_names {
            return match &unit {
                _ if setup.written == Written::Number => {
                    Marking::unreadable(Why::NumbersNotFormulas)
                }
                Some(unit) => self.mark_with_unit(reading, &entries, unit),
                None => self.mark_formulas(reading, &entries),
            };
        }
        if setup.written == Written::Formula && self.is_symbolic() {
            return Marking::unreadable(Why::FormulasNotNumbers);
        }
        let numbers = match self.numbers(&entries, unit.as_ref()) {
            Ok(numbers) => numbers,
            Err(why) => return Marking::unreadable(why),
        };
        reading.answered = Answered::Matrix(numbers.clone());
        if let Some(unit) = unit {
            reading.math = Math::row([reading.math, Math::thin_space(), unit.math()]);
            reading.text = format!("{} {unit}", reading.text);
        }
        self.mark_numbers(reading, &numbers)
    }
}

impl Prepared {
    /// Whether the key depends on data.
    fn is_symbolic(&self) -> bool {
        !self.setup.expr.names().free.is_empty()
    }
}
