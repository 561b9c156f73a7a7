//! `matrix`: a matrix, entry by entry.
//!
//! The student types `[[3m, 0], [0, m]]`, `[3m, 0; 0, m]`, `m [[3, 0], [0, 1]]`, or with numbers
//! `[[6, 0], [0, 2]] kg`; LaTeX matrices are read, too. Entries in symbols are right as the answers of
//! the kind `formula` are, numbers within the tolerance. `form` asks for numbers or formulas alone.
//!
//! ```toml
//! [[part]]
//! kind      = "matrix"
//! key       = "K"
//! form      = "formula"     # or "number"; "either" if left out
//! ask       = "Find the stiffness matrix for $x_1$ and $x_2$."
//! mistakes  = [{ answer = "[[2*k, 0], [0, k]]", feedback = "The springs couple the blocks." }]
//! ```

use std::collections::BTreeMap;
use std::sync::Arc;

use super::equality::{Comparable, Comparison, Points};
use super::meaning::{Meaning, Prefer, lexicon};
use super::typed::{self, Lexicon, Listed, Manner};
use super::{
    Answer, AnswerError, AnswerKind, Context, Credit, Declare, Feedback, Key, KeyValue, Marker,
    Marking, Reading, Reason, Tolerance, symbolic,
};
use crate::expr::{Expr, Field, Form, Name, Shape, Value};
use crate::math::Math;
use crate::quantity::{Absent, NodeId};
use crate::source::{Table, Value as Data};
use crate::unit::{Decimal, Unit};

/// The kind.
pub(super) struct Kind;

/// Whether entries are asked as numbers or as formulas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Written {
    Either,
    Number,
    Formula,
}

impl Written {
    /// Reads the key `form` of a part.
    pub(super) fn read(part: &Table<'_>, declare: &mut dyn Declare) -> Self {
        let Some(text) = part.text("form") else {
            return Self::Either;
        };
        match text.value.as_str() {
            "number" => Self::Number,
            "formula" => Self::Formula,
            "either" => Self::Either,
            _ => {
                declare.find(&AnswerError::Written(text.value.clone()), &text);
                Self::Either
            }
        }
    }
}

#[derive(Debug)]
struct Matrix {
    key: NodeId,
    tolerance: Tolerance,
    digits: u32,
    setup: Arc<Setup>,
    mistakes: Vec<(usize, NodeId)>,
}

#[derive(Debug)]
struct Setup {
    expr: Expr,
    rows: usize,
    columns: usize,
    /// One for each entry, where they are known.
    units: Vec<Unit>,
    written: Written,
    meaning: Meaning,
    lexicon: Lexicon,
}

struct Prepared {
    setup: Arc<Setup>,
    /// The entries as formulas, where they can be compared as such.
    formulas: Option<(Vec<Comparable>, Points)>,
    value: Value,
    halves: Vec<f64>,
    mistakes: Vec<Mistake>,
}

struct Mistake {
    number: usize,
    formulas: Vec<Comparable>,
    numbers: Vec<f64>,
    credit: Credit,
}

impl AnswerKind for Kind {
    fn name(&self) -> &'static str {
        "matrix"
    }

    fn minutes(&self) -> u32 {
        5
    }

    fn read(&self, part: &Table<'_>, declare: &mut dyn Declare) -> Option<Box<dyn Answer>> {
        let text = part
            .required("key")
            .and_then(|key| part.as_formula("key", key));
        let (listed, tolerance) = (part.texts("in"), part.text("tolerance"));
        let written = Written::read(part, declare);
        let text = text?;
        let key = declare.formula("key", &text)?;
        let kind = declare.graph().kind(key)?.clone();
        let (Field::Real, Shape::Matrix(rows, columns)) = (kind.field(), kind.shape()) else {
            let found = kind.form().to_string();
            declare.find(
                &AnswerError::KeyForm {
                    expected: "a real matrix",
                    found,
                },
                &text,
            );
            return None;
        };
        let units = declare.units_of(key);
        let unit = units.first().copied().unwrap_or(Unit::ONE);
        let tolerance = match tolerance {
            Some(text) => Tolerance::read(&text, &unit, declare)?,
            None => Tolerance::default(),
        };
        let own = Name::new(text.value.as_str());
        let named = declare.graph().find(&own).map(|_| own);
        let (lexicon, _) = lexicon(declare, &listed, named.as_ref());
        let setup = Setup {
            expr: symbolic::formula(declare.graph(), key),
            rows,
            columns,
            units,
            written,
            meaning: Meaning::of(declare, Prefer::Quantities),
            lexicon,
        };
        Some(Box::new(Matrix {
            key,
            tolerance,
            digits: u32::from(declare.digits_of(key)),
            setup: Arc::new(setup),
            mistakes: Vec::new(),
        }))
    }
}

impl Setup {
    fn shape(&self) -> Shape {
        Shape::Matrix(self.rows, self.columns)
    }

    fn compile(
        &self,
        entries: &[Expr],
        replaced: &BTreeMap<Name, Expr>,
    ) -> Option<Vec<Comparable>> {
        let compile = |entry: &Expr| Comparable::of(&self.meaning, entry, replaced).ok();
        entries.iter().map(compile).collect()
    }

    /// Entries by rows, typeset.
    fn typeset(&self, entries: &[Expr]) -> Math {
        let set = |row: &[Expr]| {
            row.iter()
                .map(|entry| entry.typeset(&self.lexicon))
                .collect()
        };
        Math::matrix(entries.chunks(self.columns.max(1)).map(set).collect())
    }
}

impl Answer for Matrix {
    fn kind(&self) -> &'static dyn AnswerKind {
        &Kind
    }

    fn keys(&self) -> Vec<NodeId> {
        vec![self.key]
    }

    fn unit(&self) -> Option<Unit> {
        let first = self.setup.units.first()?;
        let is_one = self.setup.units.iter().all(|unit| unit == first);
        Some(*first).filter(|unit| is_one && !unit.is_one())
    }

    fn keeps_mistakes(&self) -> bool {
        true
    }

    fn read_mistake(
        &mut self,
        number: usize,
        answer: &Data,
        part: &Table<'_>,
        declare: &mut dyn Declare,
    ) -> Option<Vec<NodeId>> {
        let text = part.as_formula("answer", answer)?;
        let node = declare.formula("mistake", &text)?;
        let kind = declare.graph().kind(node)?.clone();
        if kind.form() != Form::real(self.setup.shape()) {
            let found = kind.form().to_string();
            declare.find(
                &AnswerError::KeyForm {
                    expected: "a matrix of this size",
                    found,
                },
                &text,
            );
            return None;
        }
        self.mistakes.push((number, node));
        Some(Vec::new())
    }

    fn prepare(&self, context: &Context<'_>) -> Result<Box<dyn Marker>, Absent> {
        let (setup, evaluation) = (&self.setup, context.evaluation);
        let graph = evaluation.graph();
        let value = evaluation.value(self.key)?.clone();
        let spreads = std::cell::OnceCell::new();
        let halves = value.numbers().iter().enumerate().map(|(entry, number)| {
            let spread = || spreads.get_or_init(|| evaluation.spread(self.key))[entry];
            self.tolerance
                .half_width(*number, spread, self.digits, evaluation)
        });
        let halves = halves.collect();
        let none = BTreeMap::new();
        let entries = symbolic::entries(&setup.expr, setup.shape());
        let formulas = setup.compile(&entries, &none).map(|formulas| {
            let points = Points::around(
                &setup.meaning,
                evaluation,
                &formulas.iter().collect::<Vec<_>>(),
            );
            (formulas, points)
        });
        let mistakes = context.mistakes.iter().map(|mistaken| {
            let own = self
                .mistakes
                .iter()
                .find(|(number, _)| *number == mistaken.number);
            let formulas = match own {
                Some((_, node)) => {
                    let expr = symbolic::formula(graph, *node);
                    setup.compile(&symbolic::entries(&expr, setup.shape()), &none)
                }
                None => setup.compile(&entries, &symbolic::replaced(graph, mistaken)),
            };
            let numbers = own.and_then(|(_, node)| evaluation.value(*node).ok());
            Mistake {
                number: mistaken.number,
                formulas: formulas.unwrap_or_default(),
                numbers: numbers.map_or(Vec::new(), |value| value.numbers().to_vec()),
                credit: mistaken.credit,
            }
        });
        Ok(Box::new(Prepared {
            setup: Arc::clone(setup),
            formulas,
            value,
            halves,
            mistakes: mistakes.collect(),
        }))
    }
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
        let manner = Manner::default();
        let Listed { rows, tail } =
            match typed::list(response, start, response.len(), &setup.lexicon, manner) {
                Ok(listed) => listed,
                Err(error) => return Marking::unreadable(error.sentence(response)),
            };
        let (height, width) = (rows.len(), rows.first().map_or(0, Vec::len));
        if (height, width) != (setup.rows, setup.columns) {
            return Marking::unreadable(format!(
                "This has {height} rows of {width}; a matrix of {} by {} is asked, such as `[[a, b], [c, d]]`.",
                setup.rows, setup.columns
            ));
        }
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

impl Prepared {
    /// Whether the key depends on data.
    fn is_symbolic(&self) -> bool {
        !self.setup.expr.names().free.is_empty()
    }
}
