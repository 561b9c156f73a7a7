//! The formulas of a figure: over its own names, its points and the numbers of the item.
//!
//! `where` names are pure numbers, points are vectors of two. A formula without names is computed when the
//! item is read; the others run when the figure is drawn, and what they take from the item is the figure's demand.

use std::cell::RefCell;

use super::Point;
use super::error::FigureError;
use crate::diagnostic::Diagnose;
use crate::expr::{
    Approx, Binder, Binding, Expr, Form, Inputs, Kind, Name, Program, Registers, Scalar, Scope,
    Shape, Type, Undefined, Variable, fold,
};
use crate::source::{Span, Text};
use crate::unit::Dimension;

/// A number of a figure.
#[derive(Clone, Debug)]
pub(crate) enum Amount {
    /// Known.
    Fixed(f64),
    /// Computed from others.
    Computed(Box<Program>),
}

/// A pair of numbers.
#[derive(Clone, Debug)]
pub(crate) enum FigurePair {
    /// Known.
    Fixed(Point),
    /// Computed from others.
    Computed(Box<Program>),
    /// A number for each coordinate.
    Each(Box<[Amount; 2]>),
}

/// The names that the formulas of a figure may use.
#[derive(Debug, Default)]
pub(crate) struct FigureNames {
    /// Name, slot, and the dimension of a number; a point has none.
    own: Vec<(Name, u32, Option<Dimension>)>,
    /// What the formulas take from the item, with their slots.
    taken: RefCell<Vec<(Name, u32)>>,
    slots: std::cell::Cell<u32>,
}

/// The names of a figure before those of the item.
pub(crate) struct LocalScope<'a> {
    pub(crate) names: &'a FigureNames,
    pub(crate) item: &'a dyn Scope,
}

/// Where the errors of a formula go.
type ErrorReport<'r> = dyn FnMut(&dyn Diagnose, &Text) + 'r;

impl FigureNames {
    /// Adds a name of the figure; its first slot is returned.
    pub(crate) fn add(&mut self, name: &str, is_point: bool) -> u32 {
        let slot = self.slots.get();
        self.slots.set(slot + if is_point { 2 } else { 1 });
        let dimension = (!is_point).then_some(Dimension::PURE);
        self.own.push((Name::new(name), slot, dimension));
        slot
    }

    /// Adds a number that varies while the figure moves; its slot is returned.
    pub(crate) fn add_variable(&mut self, name: &Name, dimension: Dimension) -> u32 {
        let slot = self.slots.get();
        self.slots.set(slot + 1);
        self.own.push((name.clone(), slot, Some(dimension)));
        slot
    }

    /// The slot of a point.
    pub(crate) fn point(&self, name: &str) -> Option<u32> {
        self.own
            .iter()
            .rev()
            .find(|(known, _, dimension)| dimension.is_none() && known.as_str() == name)
            .map(|(_, slot, _)| *slot)
    }

    /// The names of points.
    pub(crate) fn points(&self) -> impl Iterator<Item = &str> {
        self.own
            .iter()
            .filter(|(_, _, dimension)| dimension.is_none())
            .map(|(name, ..)| name.as_str())
    }

    /// What was taken from the item, with the slots.
    pub(crate) fn taken(&self) -> Vec<(Name, u32)> {
        self.taken.borrow().clone()
    }

    /// How many slots there are.
    pub(crate) fn slots(&self) -> u32 {
        self.slots.get()
    }

    fn find(&self, name: &Name) -> Option<&(Name, u32, Option<Dimension>)> {
        self.own.iter().rev().find(|(known, ..)| known == name)
    }
}

impl Scope for LocalScope<'_> {
    fn name(&self, name: &Name) -> Option<Type> {
        match self.names.find(name) {
            Some((_, _, None)) => {
                Some(Type::uniform(Form::real(Shape::Vector(2)), Dimension::PURE))
            }
            Some((_, _, Some(dimension))) => Some(Type::real(*dimension)),
            None => self.item.name(name),
        }
    }

    fn known(&self) -> Vec<String> {
        let own = self.names.own.iter().map(|(name, ..)| name.to_string());
        own.chain(self.item.known()).collect()
    }
}

impl Binder for LocalScope<'_> {
    fn name(&self, variable: &Variable, _local: &[Name]) -> Option<Binding> {
        if variable.order > 0 {
            return None;
        }
        if let Some((_, slot, dimension)) = self.names.find(&variable.name) {
            let form = if dimension.is_none() {
                Form::real(Shape::Vector(2))
            } else {
                Form::REAL
            };
            return Some(Binding::Input { slot: *slot, form });
        }
        let form = self.item.name(&variable.name)?.form();
        let mut taken = self.names.taken.borrow_mut();
        let known = taken.iter().find(|(name, _)| *name == variable.name);
        let slot = match known {
            Some((_, slot)) => *slot,
            None => {
                let slot = self.names.slots.get();
                self.names.slots.set(slot + form.width() as u32);
                taken.push((variable.name.clone(), slot));
                slot
            }
        };
        (form == Form::REAL).then_some(Binding::Input { slot, form })
    }
}

impl LocalScope<'_> {
    /// Reads a formula for one number.
    pub(crate) fn amount(&self, text: &Text, report: &mut ErrorReport<'_>) -> Option<Amount> {
        let expr = read(text, report)?;
        if let Some(value) = fold(&expr) {
            return Some(Amount::Fixed(value.to_f64()));
        }
        let program = self.compile(&expr, Shape::Scalar, text, report)?;
        if program.slots().is_empty() {
            let value = FigureValues::new(0).amount(&Amount::Computed(Box::new(program)));
            return Some(Amount::Fixed(value));
        }
        Some(Amount::Computed(Box::new(program)))
    }

    /// A formula for a displacement or an angle: its number in SI units, and its dimension.
    pub(crate) fn measure(
        &self,
        expr: &Expr,
        text: &Text,
        report: &mut ErrorReport<'_>,
    ) -> Option<(Amount, Dimension)> {
        let found = match expr.check(self) {
            Ok(found) => found,
            Err(errors) => {
                errors.iter().for_each(|error| report(error, text));
                return None;
            }
        };
        let dimension = found.dimension()?;
        let program = Program::compile(expr, self).map_err(|error| report(&error, text));
        Some((Amount::Computed(Box::new(program.ok()?)), dimension))
    }

    /// Reads a formula for a point.
    pub(crate) fn pair(&self, text: &Text, report: &mut ErrorReport<'_>) -> Option<FigurePair> {
        let expr = read(text, report)?;
        if let Kind::Array(entries) = expr.kind()
            && let [x, y] = entries.as_slice()
            && let (Some(x), Some(y)) = (fold(x), fold(y))
        {
            return Some(FigurePair::Fixed(Point::new(x.to_f64(), y.to_f64())));
        }
        let program = self.compile(&expr, Shape::Vector(2), text, report)?;
        if program.slots().is_empty() {
            let value = FigureValues::new(0).pair(&FigurePair::Computed(Box::new(program)));
            return Some(FigurePair::Fixed(value));
        }
        Some(FigurePair::Computed(Box::new(program)))
    }

    fn compile(
        &self,
        expr: &Expr,
        shape: Shape,
        text: &Text,
        report: &mut ErrorReport<'_>,
    ) -> Option<Program> {
        let found = match expr.check(self) {
            Ok(found) => found,
            Err(errors) => {
                errors.iter().for_each(|error| report(error, text));
                return None;
            }
        };
        let is_pure = found
            .entries()
            .all(|entry| entry.is_none_or(Dimension::is_pure));
        if found.form() != Form::real(shape) || !is_pure {
            let dimension = found
                .dimension()
                .map_or_else(String::new, |dimension| dimension.describe());
            let error = FigureError::Form {
                found: format!("{} {dimension}", found.form())
                    .trim_end()
                    .to_owned(),
                is_point: shape != Shape::Scalar,
                span: Span::NONE,
            };
            report(&error, text);
            return None;
        }
        match Program::compile(expr, self) {
            Ok(program) => Some(program),
            Err(error) => {
                report(&error, text);
                None
            }
        }
    }
}

fn read(text: &Text, report: &mut ErrorReport<'_>) -> Option<Expr> {
    match Expr::read(&text.value) {
        Ok(expr) => Some(expr),
        Err(error) => {
            report(&error, text);
            None
        }
    }
}

/// The numbers in the slots while a figure is drawn. What has no value is not a number, and so is all that needs it.
#[derive(Debug)]
pub(crate) struct FigureValues {
    slots: Vec<f64>,
    room: RefCell<Registers<Approx<f64>>>,
}

impl FigureValues {
    pub(crate) fn new(slots: u32) -> Self {
        Self {
            slots: vec![f64::NAN; slots as usize],
            room: RefCell::default(),
        }
    }

    /// Fills a slot.
    pub(crate) fn set(&mut self, slot: u32, number: f64) {
        if let Some(place) = self.slots.get_mut(slot as usize) {
            *place = number;
        }
    }

    /// A number.
    pub(crate) fn amount(&self, amount: &Amount) -> f64 {
        match amount {
            Amount::Fixed(number) => *number,
            Amount::Computed(program) => self.run(program)[0],
        }
    }

    /// A pair of numbers.
    pub(crate) fn pair(&self, pair: &FigurePair) -> Point {
        match pair {
            FigurePair::Fixed(point) => *point,
            FigurePair::Computed(program) => {
                let [x, y] = self.run(program);
                Point::new(x, y)
            }
            FigurePair::Each(each) => Point::new(self.amount(&each[0]), self.amount(&each[1])),
        }
    }

    /// The point in two slots.
    pub(crate) fn point(&self, slot: u32) -> Point {
        let at = |slot: u32| self.slots.get(slot as usize).copied().unwrap_or(f64::NAN);
        Point::new(at(slot), at(slot + 1))
    }

    fn run(&self, program: &Program) -> [f64; 2] {
        let mut room = self.room.borrow_mut();
        let mut result = [f64::NAN; 2];
        if let Ok(outcome) = program.run::<Approx<f64>>(self, &mut room) {
            for (place, number) in result.iter_mut().zip(outcome.numbers()) {
                *place = number.value;
            }
        }
        result
    }
}

impl Inputs<Approx<f64>> for FigureValues {
    fn input(&self, slot: u32) -> Result<Approx<f64>, Undefined> {
        let number = self.slots.get(slot as usize).copied().unwrap_or(f64::NAN);
        if number.is_nan() {
            return Err(Undefined::Missing { slot });
        }
        Ok(Approx::exact(number))
    }
}
