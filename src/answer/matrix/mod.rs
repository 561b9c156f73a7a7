//! `matrix`: a matrix, entry by entry.
//!
//! The student types `[[3m, 0], [0, m]]`, `[3m, 0; 0, m]`, `m [3 0; 0 1]`, `diag(3m, m)`, or with numbers
//! `[[6, 0], [0, 2]] kg`; LaTeX matrices are read, too. Entries in symbols are right as the answers of
//! the kind `formula` are, numbers within the tolerance. A sign, a factor or the order of the coordinates that
//! is wrong throughout, and a wrong dimension are named. `form` asks for numbers or formulas alone.
//!
//! ```toml
//! [[part]]
//! kind      = "matrix"
//! key       = "K"
//! form      = "formula"     # or "number"; "either" if left out
//! ask       = "Find the stiffness matrix for $x_1$ and $x_2$."
//! mistakes  = [{ answer = "[[2*k, 0], [0, k]]", feedback = "The springs couple the blocks." }]
//! ```

mod marker;
mod slip;

use std::sync::Arc;

use self::marker::{Mistake, Prepared};
use super::equality::{BySigns, Comparable, Points, Signs};
use super::letters::Allowed;
use super::meaning::{Meaning, Prefer};
use super::shared::{self, Shared};
use super::{
    Answer, AnswerError, Asked, Blank, Context, Declare, Entries, Marker, Tolerance, symbolic,
};
use crate::expr::{Expr, Field, Form, Name, Shape};
use crate::math::Math;
use crate::numerics::SortedMap;
use crate::quantity::{Absent, NodeId};
use crate::response::Lexicon;
use crate::source::{Table, Value as Data};
use crate::unit::Unit;

/// Whether entries are asked as numbers or as formulas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Written {
    Either,
    Number,
    Formula,
}

impl Written {
    /// As the answer line says it.
    pub(crate) fn entries(self) -> Entries {
        match self {
            Self::Either => Entries::Either,
            Self::Number => Entries::Numbers,
            Self::Formula => Entries::Formulas,
        }
    }

    /// An answer line that has letters where formulas may be written, and unit and figures where numbers may.
    pub(crate) fn describe(
        self,
        mut blank: Blank,
        (letters, lexicon): (&[Expr], &Lexicon),
        (unit, figures): (Option<Unit>, u32),
    ) -> Blank {
        if self != Self::Number {
            blank = blank.with_letters(letters, lexicon);
        }
        if self != Self::Formula {
            blank = blank.with_numbers(unit, figures);
        }
        blank
    }

    /// Reads the key `form` of a part.
    pub(crate) fn read(part: &Table<'_>, declare: &mut dyn Declare) -> Self {
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
    figures: u32,
    setup: Arc<Setup>,
}

#[derive(Debug)]
pub(crate) struct Setup {
    expr: Expr,
    rows: usize,
    columns: usize,
    /// One for each entry, where they are known.
    units: Vec<Unit>,
    written: Written,
    meaning: Meaning,
    lexicon: Lexicon,
    /// The letters of its answer line.
    letters: Vec<Expr>,
    /// The entries of the key and of the named mistakes, compiled once for all data.
    compiled: Shared<Vec<Comparable>>,
    /// The points at which answers are compared with the key.
    points: BySigns<Points>,
}

/// Reads the keys of a part that belong to this kind; what is wrong is noted.
pub(crate) fn read(part: &Table<'_>, declare: &mut dyn Declare) -> Option<Box<dyn Answer>> {
    let text = part
        .required("key")
        .and_then(|key| part.as_formula("key", key));
    let tolerance = part.text("tolerance");
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
    let allowed = Allowed::read(part, declare, named.as_ref(), false)?;
    let setup = Setup {
        expr: symbolic::formula(declare.graph(), key),
        rows,
        columns,
        units,
        written,
        meaning: Meaning::of(declare, Prefer::Quantities),
        letters: allowed.letters(),
        lexicon: allowed.lexicon,
        compiled: Shared::default(),
        points: BySigns::default(),
    };
    Some(Box::new(Matrix {
        key,
        tolerance,
        figures: u32::from(declare.figures()),
        setup: Arc::new(setup),
    }))
}

impl Setup {
    fn shape(&self) -> Shape {
        Shape::Matrix(self.rows, self.columns)
    }

    fn compile(
        &self,
        entries: &[Expr],
        replaced: &SortedMap<Name, Expr>,
    ) -> Option<Vec<Comparable>> {
        let compile = |entry: &Expr| Comparable::of(&self.meaning, entry, replaced).ok();
        entries.iter().map(compile).collect()
    }

    /// Entries by rows, typeset.
    fn typeset(&self, entries: &[Expr]) -> Math {
        let rows = entries.chunks(self.columns.max(1)).map(|row| {
            let entries = row.iter().map(|entry| entry.typeset(&self.lexicon));
            entries.collect()
        });
        Math::matrix(rows.collect())
    }
}

impl Answer for Matrix {
    fn kind(&self) -> crate::answer::AnswerKind {
        crate::answer::AnswerKind::Matrix
    }

    fn blank(&self) -> Blank {
        let Setup {
            written,
            letters,
            lexicon,
            ..
        } = &*self.setup;
        let blank = Blank::of(Asked::Matrix(written.entries()));
        written.describe(blank, (letters, lexicon), (self.unit(), self.figures))
    }

    fn keys(&self) -> Vec<NodeId> {
        vec![self.key]
    }

    fn unit(&self) -> Option<Unit> {
        let first = self.setup.units.first()?;
        let is_one = self.setup.units.iter().all(|unit| unit == first);
        let has_numbers = self.setup.written != Written::Formula;
        Some(*first).filter(|unit| is_one && has_numbers && !unit.is_one())
    }

    fn keeps_mistakes(&self) -> bool {
        true
    }

    fn read_mistake(
        &mut self,
        _number: usize,
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
        Some(vec![node])
    }

    fn figures(&self) -> u32 {
        self.figures
    }

    fn states_tolerance(&self) -> bool {
        !self.tolerance.is_derived()
    }

    fn prepare<'t>(&self, context: &Context<'t>) -> Result<Box<dyn Marker + 't>, Absent> {
        let (setup, evaluation) = (&self.setup, &*context.evaluation);
        let graph = evaluation.graph();
        let value = evaluation.value(self.key)?.clone();
        let spreads = std::cell::OnceCell::new();
        let halves = value.numbers().iter().enumerate().map(|(entry, number)| {
            let spread = || spreads.get_or_init(|| evaluation.spread(self.key))[entry];
            self.tolerance
                .half_width(*number, spread, self.figures, evaluation)
        });
        let halves = halves.collect();
        let none = SortedMap::new();
        let entries = symbolic::entries(&setup.expr, setup.shape());
        let own = context.standing.get(&Name::new(graph.label(self.key)));
        let formulas = match own {
            Some(own) => {
                let entries = symbolic::entries(own, setup.shape());
                setup.compile(&entries, &none).map(Arc::new)
            }
            None if context.standing.is_empty() => setup
                .compiled
                .get(shared::KEY, || setup.compile(&entries, &none)),
            None => setup.compile(&entries, &context.standing).map(Arc::new),
        };
        let formulas = formulas.map(|formulas| {
            let signs = Signs::of(&setup.meaning.values(evaluation));
            let keys: Vec<&Comparable> = formulas.iter().collect();
            let around = || Points::around(&setup.meaning, &context.sampling, &signs, &keys);
            let points = setup.points.kept(&signs, context, around);
            (formulas, points)
        });
        let mistakes = context.mistakes.iter().map(|mistaken| {
            let own = mistaken.given.first();
            let number = shared::of_mistake(mistaken.number);
            let numbers = own.and_then(|node| evaluation.value(*node).ok());
            Mistake {
                number: mistaken.number,
                formulas: setup.compiled.get(number, || match own {
                    Some(node) => {
                        let expr = symbolic::formula(graph, *node);
                        setup.compile(&symbolic::entries(&expr, setup.shape()), &none)
                    }
                    None => setup.compile(&entries, &symbolic::replaced(graph, mistaken)),
                }),
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
