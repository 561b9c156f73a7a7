//! From a formula to the steps of a program.

use super::array::Array;
use super::assembler::Assembler;
use super::derive;
use super::error::Result;
use super::hash::NumberTable;
use super::instruction::{ProgramStep, SearchBody};
use super::{Binder, Binding, CompileError, EntryRegister, Program};
use crate::expr::{
    Constant, Expr, Field, Form, Function, Kind, Name, Operator, Path, Precise, Relation, Shape,
    Variable,
};
use vibank_dynamics::numerics::{Dd, Rational, SortedMap};
use vibank_source::Span;

/// Most formulas inside one another, substituted names included.
const MAX_DEPTH: u32 = 400;

/// Most steps for which there is room from the start.
const MAX_ROOM: u32 = 64;

/// The state of a translation.
pub(crate) struct Compiler<'a> {
    pub(crate) binder: &'a dyn Binder,
    assembler: Assembler,
    /// The names bound by the operators around the place, with their values, innermost last.
    locals: Vec<BoundName>,
    /// The names alone, as binders take them.
    pub(crate) local_names: Vec<Name>,
    /// What nodes to which several ways lead have become, by node and innermost local.
    known: NumberTable<(usize, usize), Array>,
    learned: Vec<(usize, usize)>,
    /// Numbers of the scopes of locals that were opened.
    scopes: usize,
    depth: u32,
    /// Formulas inside one another while names are substituted, across the derivatives among them.
    pub(crate) expanding: u32,
    /// Keeps the nodes alive that `known` speaks of.
    kept: Vec<Expr>,
    /// Names made up for what derivatives hold constant or leave to the binder.
    pub(crate) aliases: SortedMap<Name, Binding>,
}

struct BoundName {
    name: Name,
    value: Array,
    scope: usize,
}

/// Translates a formula.
pub(crate) fn compile(expr: &Expr, binder: &dyn Binder) -> Result<Program> {
    let mut compiler = Compiler {
        binder,
        assembler: Assembler::with_room(expr.size().min(MAX_ROOM) as usize),
        locals: Vec::new(),
        local_names: Vec::new(),
        known: NumberTable::default(),
        learned: Vec::new(),
        scopes: 0,
        depth: 0,
        expanding: 0,
        kept: Vec::new(),
        aliases: SortedMap::new(),
    };
    let value = compiler.array(expr)?;
    let form = value.form();
    let mut results = Vec::with_capacity(form.width());
    for entry in value.entries.iter() {
        match form.field {
            Field::Complex => results.extend(compiler.assembler.pair(*entry)?),
            Field::Boolean | Field::Real => results.push(entry.real),
        }
    }
    let Assembler {
        code,
        spans,
        constants,
        registers,
        ..
    } = compiler.assembler;
    Ok(Program {
        code,
        spans,
        constants,
        registers,
        form,
        results,
    })
}

impl Compiler<'_> {
    /// What a formula becomes; each node once.
    fn array(&mut self, expr: &Expr) -> Result<Array> {
        let is_shared = expr.is_shared();
        let key = (expr.address(), self.scope());
        if is_shared && let Some(known) = self.known.get(&key) {
            return Ok(known.clone());
        }
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err(CompileError::TooDeep);
        }
        let around = self.assembler.place(expr.span());
        let value = self.node(expr)?;
        self.assembler.return_to(around);
        self.depth -= 1;
        // A node to which one way leads is not met again, and would only fill the table.
        if is_shared {
            self.kept.push(expr.clone());
            self.known.insert(key, value.clone());
            self.learned.push(key);
        }
        Ok(value)
    }

    /// The number of the innermost scope of locals.
    fn scope(&self) -> usize {
        self.locals.last().map_or(0, |local| local.scope)
    }

    fn node(&mut self, expr: &Expr) -> Result<Array> {
        match expr.kind() {
            Kind::Number(value) => self.precise((*value).into()),
            Kind::Measure(value, unit) => self.precise(super::measure(*value, unit)),
            Kind::Constant(constant) => self.reserved(*constant),
            Kind::Name(name) => self.name(name, expr.span()),
            Kind::Path(path) => self.path(path, 0, expr),
            Kind::Prime(inner, order) => self.prime(inner, *order, expr),
            Kind::Index(inner, indices) => self.index(inner, indices),
            Kind::Negate(inner) => self
                .array(inner)?
                .map(&mut self.assembler, EntryRegister::negate),
            Kind::Binary(Operator::Power, base, exponent) => self.power(base, exponent),
            Kind::Binary(operator, a, b) => {
                let (a, b) = (self.array(a)?, self.array(b)?);
                a.arithmetic(*operator, &b, &mut self.assembler)
            }
            Kind::Compare(operands, relations) => self.compare(operands, relations),
            Kind::And(a, b) => self.shortcut(a, b, ProgramStep::JumpUnless),
            Kind::Or(a, b) => self.shortcut(a, b, ProgramStep::JumpIf),
            Kind::Not(inner) => {
                let condition = self.array(inner)?.condition()?;
                Ok(Array::boolean(
                    self.assembler.compute(ProgramStep::Not(condition))?,
                ))
            }
            Kind::If(condition, first, second) => self.choice(condition, first, second),
            Kind::Call(function, arguments) => self.call(*function, arguments),
            Kind::At(inner, values) => self.at(inner, values),
            Kind::Diff(inner, names) => {
                let derivative = derive::derivative(self, inner, names)?;
                self.derived(&derivative, inner)
            }
            Kind::Root(inner, name, low, high) => {
                self.search(ProgramStep::Root, inner, name, [low, high])
            }
            Kind::Integral(inner, name, low, high) => {
                self.search(ProgramStep::Integral, inner, name, [low, high])
            }
            Kind::Array(parts) => {
                let parts = parts.iter().map(|part| self.array(part));
                Array::of_parts(&parts.collect::<Result<Vec<_>>>()?)
            }
        }
    }

    fn precise(&mut self, value: Precise) -> Result<Array> {
        Ok(Array::scalar(EntryRegister::real(
            self.assembler.constant(value)?,
        )))
    }

    fn reserved(&mut self, constant: Constant) -> Result<Array> {
        // More than a double-double leaves out of π and e: 2⁻¹⁰⁶ of them at most.
        const REST: f64 = 1e-31;
        match constant {
            Constant::Pi => self.precise(Precise::of_dd(Dd::PI, REST)),
            Constant::E => self.precise(Precise::of_dd(Dd::E, REST)),
            Constant::Infinity => self.precise(Precise::exact(f64::INFINITY)),
            Constant::ImaginaryUnit => {
                let (zero, one) = (self.assembler.exact(0.0)?, self.assembler.exact(1.0)?);
                Ok(Array::scalar(EntryRegister::complex(zero, one)))
            }
        }
    }

    fn name(&mut self, name: &Name, span: Span) -> Result<Array> {
        if let Some(local) = self.locals.iter().rev().find(|local| local.name == *name) {
            return Ok(local.value.clone());
        }
        let alias = self.aliases.get(name).cloned();
        let binding = alias.or_else(|| self.binder.name(&Variable::from(name), &self.local_names));
        match binding {
            Some(binding) => self.bound(binding, 0),
            None => Err(CompileError::UnknownName {
                name: name.clone(),
                span,
            }),
        }
    }

    fn path(&mut self, path: &Path, order: u8, expr: &Expr) -> Result<Array> {
        match self.binder.path(path, &self.local_names) {
            Some(Binding::Motion(index)) => self.bound(Binding::Motion(index), order),
            Some(binding) if order == 0 => self.bound(binding, 0),
            Some(_) => {
                let rate = derive::of_primed(self, expr)?;
                self.derived(&rate, &Expr::derived(Kind::Path(path.clone())))
            }
            None => Err(CompileError::UnknownPath {
                path: path.clone(),
                span: expr.span(),
            }),
        }
    }

    /// What a name or path stands for, as registers.
    fn bound(&mut self, binding: Binding, order: u8) -> Result<Array> {
        match binding {
            Binding::Formula(formula) => self.array(&formula),
            Binding::Input { slot, form } => self.input(slot, form),
            Binding::Motion(index) => {
                let time = self.name(&Name::from("t"), Span::NONE)?.real()?;
                let step = ProgramStep::Motion(index, order, time);
                Ok(Array::scalar(EntryRegister::real(
                    self.assembler.compute(step)?,
                )))
            }
        }
    }

    fn input(&mut self, slot: u32, form: Form) -> Result<Array> {
        if form == Form::REAL {
            return Ok(Array::scalar(EntryRegister::real(
                self.assembler.compute(ProgramStep::Input(slot))?,
            )));
        }
        let mut slots = slot..slot + form.width() as u32;
        let mut entries = Vec::with_capacity(form.shape.len());
        while let Some(slot) = slots.next() {
            let real = self.assembler.compute(ProgramStep::Input(slot))?;
            let imaginary = match form.field {
                Field::Complex => slots
                    .next()
                    .map(|slot| self.assembler.compute(ProgramStep::Input(slot)))
                    .transpose()?,
                Field::Boolean | Field::Real => None,
            };
            entries.push(EntryRegister { real, imaginary });
        }
        let is_boolean = form.field == Field::Boolean;
        Ok(Array {
            is_boolean,
            ..Array::new(form.shape, entries)
        })
    }

    fn prime(&mut self, inner: &Expr, order: u8, expr: &Expr) -> Result<Array> {
        match inner.kind() {
            Kind::Name(name) => {
                let variable = Variable::of(name, order);
                if let Some(binding) = self.binder.name(&variable, &self.local_names) {
                    return self.bound(binding, 0);
                }
                if let Some(Binding::Motion(index)) = derive::time_binding(self, name) {
                    return self.bound(Binding::Motion(index), order);
                }
            }
            Kind::Path(path) => return self.path(path, order, expr),
            _ => {}
        }
        let rate = derive::of_primed(self, expr)?;
        self.derived(&rate, inner)
    }

    /// The derivative of a formula; that of a constant is zero in the shape of the constant.
    fn derived(&mut self, derivative: &Expr, of: &Expr) -> Result<Array> {
        if !vanishes(derivative) {
            return self.array(derivative);
        }
        let zero = self.array(&Expr::number(0))?.number()?;
        let shape = self.shape(of)?;
        Ok(Array::new(shape, vec![zero; shape.len()]))
    }

    /// The shape of a formula; no steps are kept.
    fn shape(&mut self, expr: &Expr) -> Result<Shape> {
        let mark = self.open();
        let start = self.assembler.code.len();
        let shape = self.array(expr)?.shape;
        self.assembler.code.truncate(start);
        self.assembler.spans.truncate(start);
        self.close(mark);
        Ok(shape)
    }

    fn index(&mut self, inner: &Expr, indices: &[Expr]) -> Result<Array> {
        let indices = indices
            .iter()
            .map(|index| {
                let value = index.as_number().filter(|value| value.is_integer());
                let value = value.and_then(|value| usize::try_from(value.numerator()).ok());
                value.ok_or(CompileError::Index { span: index.span() })
            })
            .collect::<Result<Vec<_>>>()?;
        self.array(inner)?.component(&indices)
    }

    /// A power; constant exponents that are whole or a half have steps of their own.
    fn power(&mut self, base: &Expr, exponent: &Expr) -> Result<Array> {
        let base = self.array(base)?.number()?;
        if let Some(value) = crate::expr::fold(exponent) {
            if value.is_integer() && value.numerator().abs() <= i128::from(i32::MAX) {
                return Ok(Array::scalar(
                    base.power_whole(value.numerator() as i32, &mut self.assembler)?,
                ));
            }
            if (value.numerator(), value.denominator()) == (1, 2) {
                return Ok(Array::scalar(
                    base.function(Function::Sqrt, &mut self.assembler)?,
                ));
            }
        }
        let exponent = self.array(exponent)?.number()?;
        Ok(Array::scalar(base.power(exponent, &mut self.assembler)?))
    }

    /// `a < b <= c`: later operands are computed only if the earlier relations hold.
    fn compare(&mut self, operands: &[Expr], relations: &[Relation]) -> Result<Array> {
        let mut left = self.array(&operands[0])?.real()?;
        let mut right = self.array(&operands[1])?.real()?;
        let first = self
            .assembler
            .compute(ProgramStep::Compare(relations[0], left, right))?;
        if relations.len() == 1 {
            return Ok(Array::boolean(first));
        }
        let out = self.assembler.register();
        self.assembler.push(ProgramStep::Copy(first), out)?;
        let mark = self.open();
        let mut jumps = Vec::new();
        for (operand, relation) in operands[2..].iter().zip(&relations[1..]) {
            jumps.push(self.assembler.push(ProgramStep::JumpUnless(out, 0), 0)?);
            left = right;
            right = self.array(operand)?.real()?;
            self.assembler
                .push(ProgramStep::Compare(*relation, left, right), out)?;
        }
        for jump in jumps {
            self.assembler.land(jump);
        }
        self.close(mark);
        Ok(Array::boolean(out))
    }

    /// `and` and `or`: the second operand is computed only if it matters.
    fn shortcut(&mut self, a: &Expr, b: &Expr, jump: fn(u32, u32) -> ProgramStep) -> Result<Array> {
        let first = self.array(a)?.condition()?;
        let out = self.assembler.register();
        self.assembler.push(ProgramStep::Copy(first), out)?;
        let over = self.assembler.push(jump(out, 0), 0)?;
        let mark = self.open();
        let second = self.array(b)?.condition()?;
        self.assembler.push(ProgramStep::Copy(second), out)?;
        self.close(mark);
        self.assembler.land(over);
        Ok(Array::boolean(out))
    }

    /// Computes one of two values. The copies of the first stand after the second, when it is known what both are.
    fn choice(&mut self, condition: &Expr, first: &Expr, second: &Expr) -> Result<Array> {
        let condition = self.array(condition)?.condition()?;
        let to_second = self
            .assembler
            .push(ProgramStep::JumpUnless(condition, 0), 0)?;
        let mark = self.open();
        let first = self.array(first)?;
        self.close(mark);
        let to_copies = self.assembler.push(ProgramStep::Jump(0), 0)?;
        self.assembler.land(to_second);
        let mark = self.open();
        let second = self.array(second)?;
        if first.shape != second.shape || first.is_boolean != second.is_boolean {
            return Err(CompileError::Form {
                found: second.form(),
            });
        }
        let is_complex = first.is_complex() || second.is_complex();
        let merged: Vec<EntryRegister> = (0..first.shape.len())
            .map(|_| EntryRegister {
                real: self.assembler.register(),
                imaginary: is_complex.then(|| self.assembler.register()),
            })
            .collect();
        self.copy(&second, &merged)?;
        self.close(mark);
        let to_end = self.assembler.push(ProgramStep::Jump(0), 0)?;
        self.assembler.land(to_copies);
        let mark = self.open();
        self.copy(&first, &merged)?;
        self.close(mark);
        self.assembler.land(to_end);
        Ok(Array {
            is_boolean: first.is_boolean,
            ..Array::new(first.shape, merged)
        })
    }

    fn copy(&mut self, from: &Array, to: &[EntryRegister]) -> Result<()> {
        for (from, to) in from.entries.iter().zip(to) {
            self.assembler.push(ProgramStep::Copy(from.real), to.real)?;
            if let Some(imaginary) = to.imaginary {
                let part = self.assembler.pair(*from)?[1];
                self.assembler.push(ProgramStep::Copy(part), imaginary)?;
            }
        }
        Ok(())
    }

    fn call(&mut self, function: Function, arguments: &[Expr]) -> Result<Array> {
        if let (Function::EllipticK, [parameter]) = (function, arguments)
            && let Some(angle) = angle_of_squared_sine(parameter)
        {
            // K(sin²) by the squared cosine: the sine forgets how far the angle is from a right one.
            let angle = self.array(angle)?.real()?;
            let cosine = self.assembler.unary(Function::Cos, angle)?;
            let square = self
                .assembler
                .compute(ProgramStep::Multiply(cosine, cosine))?;
            let integral = self.assembler.unary(Function::EllipticKm1, square)?;
            return Ok(Array::scalar(EntryRegister::real(integral)));
        }
        let arrays = arguments
            .iter()
            .map(|argument| self.array(argument))
            .collect::<Result<Vec<_>>>()?;
        let to = &mut self.assembler;
        match (function, arrays.as_slice()) {
            (Function::Transpose, [matrix]) => Ok(matrix.transpose()),
            (Function::Det, [matrix]) => matrix.determinant(to),
            (Function::Norm, [vector]) => vector.norm(to),
            (Function::Dot, [a, b]) => a.dot(b, to),
            (Function::Re | Function::Im | Function::Conj, [a]) => {
                a.map(to, |entry, to| entry.part(function, to))
            }
            (Function::Arg, [a]) => Ok(Array::scalar(a.number()?.part(function, to)?)),
            (Function::Clamp, [x, low, high]) => {
                let raised = ProgramStep::Binary(Function::Max, x.real()?, low.real()?);
                let raised = to.compute(raised)?;
                let step = ProgramStep::Binary(Function::Min, raised, high.real()?);
                Ok(Array::scalar(EntryRegister::real(to.compute(step)?)))
            }
            (Function::Min | Function::Max, [first, rest @ ..]) => {
                let mut extreme = first.real()?;
                for other in rest {
                    extreme = to.compute(ProgramStep::Binary(function, extreme, other.real()?))?;
                }
                Ok(Array::scalar(EntryRegister::real(extreme)))
            }
            (_, [a, b]) => {
                let step = ProgramStep::Binary(function, a.real()?, b.real()?);
                Ok(Array::scalar(EntryRegister::real(to.compute(step)?)))
            }
            (_, [a]) if function.is_real_only() => Ok(Array::scalar(EntryRegister::real(
                to.unary(function, a.real()?)?,
            ))),
            (_, [a]) => Ok(Array::scalar(a.number()?.function(function, to)?)),
            _ => Err(CompileError::TooLarge),
        }
    }

    /// The value of a formula where names have these values; the values themselves are those outside.
    fn at(&mut self, inner: &Expr, values: &[(Name, Expr)]) -> Result<Array> {
        let mut locals = Vec::with_capacity(values.len());
        for (name, value) in values {
            locals.push((name.clone(), self.array(value)?));
        }
        self.with_locals(locals, |compiler| compiler.array(inner))
    }

    /// Runs a translation in which names have other values.
    fn with_locals(
        &mut self,
        values: Vec<(Name, Array)>,
        translate: impl FnOnce(&mut Self) -> Result<Array>,
    ) -> Result<Array> {
        let outside = self.locals.len();
        self.scopes += 1;
        for (name, value) in values {
            self.local_names.push(name.clone());
            self.locals.push(BoundName {
                name,
                value,
                scope: self.scopes,
            });
        }
        let value = translate(self)?;
        self.locals.truncate(outside);
        self.local_names.truncate(outside);
        Ok(value)
    }

    /// A search over the values of a name in an interval.
    fn search(
        &mut self,
        step: fn(SearchBody) -> ProgramStep,
        inner: &Expr,
        name: &Name,
        [low, high]: [&Expr; 2],
    ) -> Result<Array> {
        let ends = [self.array(low)?.real()?, self.array(high)?.real()?];
        let variable = self.assembler.register();
        let out = self.assembler.register();
        let search = SearchBody {
            ends,
            variable,
            value: 0,
            end: 0,
        };
        let at = self.assembler.push(step(search), out)?;
        let mark = self.open();
        let local = Array::scalar(EntryRegister::real(variable));
        let value = self.with_locals(vec![(name.clone(), local)], |compiler| {
            compiler.array(inner)
        })?;
        self.assembler.set_value(at, value.real()?);
        self.close(mark);
        self.assembler.land(at);
        Ok(Array::scalar(EntryRegister::real(out)))
    }

    /// From here on steps may not be run.
    fn open(&mut self) -> KnownMark {
        KnownMark {
            steps: self.assembler.open(),
            nodes: self.learned.len(),
        }
    }

    /// Forgets what was computed since.
    fn close(&mut self, mark: KnownMark) {
        self.assembler.close(mark.steps);
        for key in self.learned.drain(mark.nodes..) {
            self.known.remove(&key);
        }
    }
}

/// What was known where steps began that may not be run.
struct KnownMark {
    steps: super::assembler::Scope,
    nodes: usize,
}

/// Whether a derivative is zero, in every entry if it is an array.
fn vanishes(derivative: &Expr) -> bool {
    match derivative.kind() {
        Kind::Array(entries) => entries.iter().all(vanishes),
        _ => derivative.is_zero(),
    }
}

/// The angle of which an expression is the squared sine.
fn angle_of_squared_sine(expr: &Expr) -> Option<&Expr> {
    let Kind::Binary(Operator::Power, base, exponent) = expr.kind() else {
        return None;
    };
    match base.kind() {
        Kind::Call(Function::Sin, arguments) if exponent.as_number() == Some(Rational::from(2)) => {
            arguments.first()
        }
        _ => None,
    }
}
