//! The formulas of a model compiled for numbers, each when it is first asked for.

use std::sync::OnceLock;

use super::Unavailable;
use super::linear::Matrix;
use crate::expr::{
    Approx, Binder, Binding, Expr, Form, Inputs, Name, Normal, Order, Precise, Program, Scalar,
    Undefined, Value, Variable, Workspace,
};

/// A formula and its program.
#[derive(Clone, Debug)]
pub(crate) struct Compiled {
    formula: PendingFormula,
    program: OnceLock<Result<Ready, Unavailable>>,
}

/// What is to be compiled; sums are written as formulas only then.
#[derive(Clone, Debug)]
enum PendingFormula {
    Written(Expr),
    List(Vec<Normal>),
    Rows(Matrix),
}

impl PendingFormula {
    fn written(&self) -> Expr {
        let order = Order::new();
        let list = |sums: &[Normal]| {
            let entries = sums.iter().map(|sum| sum.to_expr(&order));
            Expr::array(entries.collect::<Vec<_>>())
        };
        match self {
            Self::Written(formula) => formula.clone(),
            Self::List(sums) => list(sums),
            Self::Rows(rows) => Expr::array(rows.iter().map(|row| list(row)).collect::<Vec<_>>()),
        }
    }
}

/// A program and the slots that it reads, ascending.
#[derive(Clone, Debug)]
pub(crate) struct Ready {
    pub(crate) program: Program,
    slots: Vec<u32>,
}

impl Ready {
    /// Whether the program reads a slot.
    pub(crate) fn reads(&self, slot: u32) -> bool {
        self.slots.binary_search(&slot).is_ok()
    }

    /// Whether the program reads constants alone, of which there are as many as given.
    pub(crate) fn is_constant(&self, constants: usize) -> bool {
        self.slots
            .last()
            .is_none_or(|slot| (*slot as usize) < constants)
    }
}

impl Compiled {
    pub(crate) fn new(formula: Expr) -> Self {
        Self::of(PendingFormula::Written(formula))
    }

    /// Sums of products as a list.
    pub(crate) fn sums(sums: Vec<Normal>) -> Self {
        Self::of(PendingFormula::List(sums))
    }

    /// Sums of products by rows.
    pub(crate) fn matrix(matrix: &Matrix) -> Self {
        Self::of(PendingFormula::Rows(matrix.clone()))
    }

    fn of(formula: PendingFormula) -> Self {
        Self {
            formula,
            program: OnceLock::new(),
        }
    }

    /// A list of formulas that are evaluated together.
    pub(crate) fn list(formulas: impl IntoIterator<Item = Expr>) -> Self {
        Self::new(Expr::array(formulas.into_iter().collect::<Vec<_>>()))
    }

    pub(crate) fn ready(&self, names: &Slots) -> Result<&Ready, Unavailable> {
        self.program
            .get_or_init(|| {
                let program = Program::compile(&self.formula.written(), names)?;
                let slots = program.slots();
                Ok(Ready { program, slots })
            })
            .as_ref()
            .map_err(Clone::clone)
    }

    /// Its value for these data.
    pub(crate) fn value(&self, names: &Slots, data: &ModelData<'_>) -> Result<Value, Unavailable> {
        let program = &self.ready(names)?.program;
        Ok(program.evaluate(data, &mut Workspace::default())?)
    }
}

/// Which number each name is: constants first, then coordinates, velocities and time.
#[derive(Clone, Debug)]
pub(crate) struct Slots {
    pub(crate) constants: Vec<Name>,
    pub(crate) coordinates: Vec<Name>,
}

impl Binder for Slots {
    fn name(&self, variable: &Variable, _local: &[Name]) -> Option<Binding> {
        let (constants, size) = (self.constants.len(), self.coordinates.len());
        let coordinate = self
            .coordinates
            .iter()
            .position(|own| *own == variable.name);
        let slot = match (coordinate, variable.order) {
            (Some(at), order @ (0 | 1)) => constants + usize::from(order) * size + at,
            (None, 0) if variable.name.as_str() == "t" => constants + 2 * size,
            (None, 0) => self.constants.binary_search(&variable.name).ok()?,
            _ => return None,
        };
        Some(Binding::Input {
            slot: slot as u32,
            form: Form::REAL,
        })
    }
}

/// The numbers for one evaluation; coordinates, velocities and time that are not given are zero.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ModelData<'a> {
    pub(crate) constants: &'a [Result<Precise, Undefined>],
    pub(crate) position: &'a [Precise],
}

impl ModelData<'_> {
    pub(crate) fn precise(&self, slot: u32) -> Result<Precise, Undefined> {
        let slot = slot as usize;
        match slot.checked_sub(self.constants.len()) {
            None => self.constants[slot],
            Some(at) => Ok(self
                .position
                .get(at)
                .copied()
                .unwrap_or(Precise::exact(0.0))),
        }
    }
}

impl<T> Inputs<Approx<T>> for ModelData<'_>
where
    Approx<T>: Scalar,
{
    fn input(&self, slot: u32) -> Result<Approx<T>, Undefined> {
        self.precise(slot).map(|number| Approx::<T>::of(&number))
    }
}
