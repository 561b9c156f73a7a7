//! Derivatives inside a program: names are substituted as far as they depend on the variable, then the formula is derived.

use super::compile::Compiler;
use super::error::Result;
use super::{Binding, CompileError};
use crate::expr::{
    Expr, Kind, Name, Path, SymbolicError, Variable, differentiate, time_derivative,
};
use vibank_dynamics::numerics::SortedSet;

/// Most nodes of a formula with its names substituted.
const MAX_NODES: u32 = 50_000;
/// Most formulas inside one another while names are substituted.
const MAX_DEPTH: u32 = 300;

/// The formula of `diff(inner, name, …)`.
pub(crate) fn derivative(
    compiler: &mut Compiler<'_>,
    inner: &Expr,
    names: &[Name],
) -> Result<Expr> {
    let mut result = inner.clone();
    for name in names {
        let full = expanded(compiler, &result, name)?;
        result = if name.as_str() == "t" {
            let moving = moving(compiler, &full);
            time_derivative(&full, &moving)?
        } else {
            differentiate(&full, name)?
        };
    }
    Ok(result)
}

/// The formula of a primed formula, `(x1 - x2)'`.
pub(crate) fn of_primed(compiler: &mut Compiler<'_>, primed: &Expr) -> Result<Expr> {
    let Kind::Prime(inner, order) = primed.kind() else {
        return Ok(primed.clone());
    };
    let time = vec![Name::from("t"); usize::from(*order)];
    derivative(compiler, inner, &time)
}

/// What a name stands for where time runs.
pub(crate) fn time_binding(compiler: &Compiler<'_>, name: &Name) -> Option<Binding> {
    let alias = compiler.aliases.get(name).cloned();
    alias.or_else(|| binding(compiler, &Variable::from(name), &Name::from("t")))
}

fn binding(compiler: &Compiler<'_>, variable: &Variable, by: &Name) -> Option<Binding> {
    let mut local = compiler.local_names.clone();
    local.push(by.clone());
    compiler.binder.name(variable, &local)
}

/// The names of a formula that move with time without being written in it.
fn moving(compiler: &Compiler<'_>, expr: &Expr) -> SortedSet<Name> {
    let moves = |name: &Name| {
        let rate = compiler
            .binder
            .name(&Variable::of(name, 1), &compiler.local_names);
        rate.is_some() || matches!(time_binding(compiler, name), Some(Binding::Motion(_)))
    };
    let mut moving = SortedSet::new();
    expr.walk(&mut |node| {
        if let Kind::Name(name) = node.kind()
            && !moving.contains(name)
            && moves(name)
        {
            moving.insert(name.clone());
        }
    });
    moving
}

/// The formula with everything substituted that depends on `by`.
fn expanded(compiler: &mut Compiler<'_>, expr: &Expr, by: &Name) -> Result<Expr> {
    Expansion {
        compiler,
        by,
        bound: Vec::new(),
    }
    .of(expr)
}

/// Puts formulas in for names.
struct Expansion<'a, 'b> {
    compiler: &'a mut Compiler<'b>,
    by: &'a Name,
    /// Names bound by operators inside the formula.
    bound: Vec<Name>,
}

impl Expansion<'_, '_> {
    fn of(&mut self, expr: &Expr) -> Result<Expr> {
        self.compiler.expanding += 1;
        if self.compiler.expanding > MAX_DEPTH {
            return Err(CompileError::TooDeep);
        }
        let result = self.node(expr)?;
        self.compiler.expanding -= 1;
        if result.size() > MAX_NODES {
            return Err(CompileError::Symbolic(SymbolicError::TooLarge));
        }
        Ok(result)
    }

    fn node(&mut self, expr: &Expr) -> Result<Expr> {
        match expr.kind() {
            Kind::Name(name) => self.name(name, expr),
            Kind::Path(path) => self.path(path, expr),
            Kind::Prime(inner, order) => self.prime(inner, *order, expr),
            Kind::Diff(inner, names) => {
                let derived = derivative(self.compiler, inner, names)?;
                self.of(&derived)
            }
            Kind::At(_, values) => {
                let names = values.iter().map(|(name, _)| name.clone()).collect();
                self.within(names, expr)
            }
            Kind::Root(_, name, ..) | Kind::Integral(_, name, ..) => {
                self.within(vec![name.clone()], expr)
            }
            _ => expr.try_map_children(&mut |child| self.of(child)),
        }
    }

    /// The operands of an operator that binds names.
    fn within(&mut self, names: Vec<Name>, expr: &Expr) -> Result<Expr> {
        let outside = self.bound.len();
        self.bound.extend(names);
        let result = expr.try_map_children(&mut |child| self.of(child));
        self.bound.truncate(outside);
        result
    }

    fn is_fixed(&self, name: &Name) -> bool {
        name == self.by
            || self.bound.contains(name)
            || self.compiler.local_names.contains(name)
            || self.compiler.aliases.contains_key(name)
    }

    fn name(&mut self, name: &Name, expr: &Expr) -> Result<Expr> {
        if self.is_fixed(name) {
            return Ok(expr.clone());
        }
        match binding(self.compiler, &Variable::from(name), self.by) {
            Some(Binding::Formula(formula)) => self.of(&formula),
            _ => Ok(expr.clone()),
        }
    }

    /// A quantity of a model: its formula, or a name that stands for what the binder computes.
    fn path(&mut self, path: &Path, expr: &Expr) -> Result<Expr> {
        let mut local = self.compiler.local_names.clone();
        local.push(self.by.clone());
        match self.compiler.binder.path(path, &local) {
            Some(Binding::Formula(formula)) => self.of(&formula),
            Some(binding) => {
                // No name that can be written has a point in it.
                let alias = Name::new(path.to_string());
                self.compiler.aliases.insert(alias.clone(), binding);
                Ok(Expr::name(alias))
            }
            None => Err(CompileError::UnknownPath {
                path: path.clone(),
                span: expr.span(),
            }),
        }
    }

    /// A time derivative that the binder knows, or its formula.
    fn prime(&mut self, inner: &Expr, order: u8, expr: &Expr) -> Result<Expr> {
        if let Kind::Name(name) = inner.kind() {
            if self.is_fixed(name)
                || binding(self.compiler, &Variable::of(name, order), self.by).is_some()
            {
                return Ok(expr.clone());
            }
            if let Some(Binding::Motion(_)) = time_binding(self.compiler, name) {
                return Ok(expr.clone());
            }
        }
        let rate = of_primed(self.compiler, expr)?;
        self.of(&rate)
    }
}

#[cfg(test)]
mod tests {
    use std::result::Result;

    use super::*;
    use crate::expr::{
        Absence, Approx, Binder, Form, Inputs, Precise, Program, Scalar, Undefined, Workspace,
    };
    use vibank_dynamics::numerics::{cos, sin};

    /// Parameters a and w, the coordinate q with its velocity, formulas for the rest.
    struct Item;

    const FORMULAS: [(&str, &str); 8] = [
        ("V", "1/2*a*q^2 + b*q"),
        ("b", "a*w"),
        ("x", "b*cos(w*t)"),
        ("z", "2*x"),
        ("loop", "1 + pool"),
        ("pool", "2*loop"),
        ("swing", "1 + swing'"),
        ("turn", "diff(turn, t)"),
    ];

    impl Binder for Item {
        fn name(&self, variable: &Variable, local: &[Name]) -> Option<Binding> {
            let name = variable.name.as_str();
            let input = |slot| {
                Some(Binding::Input {
                    slot,
                    form: Form::REAL,
                })
            };
            match (name, variable.order) {
                ("a", 0) => input(0),
                ("w", 0) => input(1),
                ("q", 0) => input(2),
                ("q", 1) => input(3),
                ("t", 0) => input(4),
                // The value of `b`, unless what it depends on varies.
                ("b", 0) if !local.iter().any(|name| ["a", "w"].contains(&name.as_str())) => {
                    input(5)
                }
                ("motion", 0) => Some(Binding::Motion(7)),
                (_, 0) => {
                    let (_, formula) = FORMULAS.iter().find(|(known, _)| *known == name)?;
                    Some(Binding::Formula(Expr::read(formula).unwrap()))
                }
                _ => None,
            }
        }

        fn path(&self, path: &Path, _local: &[Name]) -> Option<Binding> {
            match path.to_string().as_str() {
                "model.motion" => Some(Binding::Motion(7)),
                "model.potential" => Some(Binding::Formula(Expr::read("V").unwrap())),
                "model.stiffness" => Some(Binding::Input {
                    slot: 0,
                    form: Form::REAL,
                }),
                _ => None,
            }
        }
    }

    /// a = 3, w = 2, q = 5, q' = 7, t = 0.5, b = 6; the motion is sin.
    struct Data;

    impl<S: Scalar> Inputs<S> for Data {
        fn input(&self, slot: u32) -> Result<S, Undefined> {
            [3.0, 2.0, 5.0, 7.0, 0.5, 6.0]
                .as_slice()
                .get(slot as usize)
                .map(|x| S::exact(*x))
                .ok_or(Undefined::NotReal)
        }

        fn motion(&self, index: u32, order: u8, time: &S) -> Result<S, Undefined> {
            assert_eq!(index, 7);
            let derivatives: [fn(f64) -> f64; 4] = [sin, cos, |t| -sin(t), |t| -cos(t)];
            Ok(S::exact(derivatives[usize::from(order) % 4](time.to_f64())))
        }
    }

    fn value(formula: &str) -> Result<f64, Absence> {
        let program = Program::compile(&Expr::read(formula).unwrap(), &Item).unwrap();
        program.evaluate_real(&Data, &mut Workspace::default())
    }

    #[test]
    fn derivatives_reach_through_names() {
        let sine_of_one = sin(1.0);
        for (formula, expected) in [
            ("diff(V, q)", 21.0),
            ("diff(V, q, q)", 3.0),
            ("at(diff(V, q), q = 0)", 6.0),
            ("at(diff(model.potential, q), q = a)", 15.0),
            ("diff(V, a)", 12.5 + 10.0),
            ("diff(b, w)", 3.0),
            ("x'", -12.0 * sine_of_one),
            ("z''", -48.0 * cos(1.0)),
            ("diff(x, t)", -12.0 * sine_of_one),
            ("at(x', t = 0)", 0.0),
            ("at(z, t = 0)", 12.0),
            ("at(x, w = 0)", 0.0),
            ("(x + t^2)'", -12.0 * sine_of_one + 1.0),
            ("V'", 21.0 * 7.0),
            ("motion", sin(0.5)),
            ("motion'", cos(0.5)),
            ("model.motion''", -sin(0.5)),
            ("(t*model.motion)'", sin(0.5) + 0.5 * cos(0.5)),
            ("diff(a*motion, t)", 3.0 * cos(0.5)),
            ("at(model.motion', t = 0)", 1.0),
            ("diff(model.stiffness*q^2, q)", 30.0),
            ("root(at(diff(V, q), q = s), s, -10, 10)", -2.0),
            ("root(diff(V, q), q, -10, 10)", -2.0),
            ("integral(diff(V, q), q, 0, 1)", 7.5),
            ("integral(x', t, 0, pi)", 0.0),
        ] {
            let found = value(formula).unwrap();
            assert!(
                (found - expected).abs() <= 1e-14 * expected.abs().max(1.0),
                "{formula}: {found} {expected}"
            );
        }
    }

    #[test]
    fn circles_and_missing_names_are_refused() {
        let compile =
            |formula: &str| Program::compile(&Expr::read(formula).unwrap(), &Item).unwrap_err();
        assert_eq!(compile("loop"), CompileError::TooDeep);
        assert_eq!(compile("diff(loop, q)"), CompileError::TooDeep);
        for formula in [
            "loop'",
            "swing",
            "swing'",
            "diff(swing, q)",
            "turn",
            "turn'",
        ] {
            assert_eq!(compile(formula), CompileError::TooDeep, "{formula}");
        }
        assert!(matches!(
            compile("nothing + 1"),
            CompileError::UnknownName { .. }
        ));
        assert!(matches!(
            compile("model.nothing'"),
            CompileError::UnknownPath { .. }
        ));
        assert!(matches!(
            compile("diff(gone*q^2, q)"),
            CompileError::UnknownName { .. }
        ));
    }

    #[test]
    fn deep_formulas_compile_within_a_small_stack() {
        let deep = (0..190).fold("q".to_owned(), |inner, _| format!("sin({inner})"));
        let run = move || {
            let program = Program::compile(&Expr::read(&deep).unwrap(), &Item).unwrap();
            let derivative = Expr::read(&format!("diff({deep}, q)")).unwrap();
            assert!(Program::compile(&derivative, &Item).is_ok());
            program.len()
        };
        let thread = std::thread::Builder::new()
            .stack_size(1 << 20)
            .spawn(run)
            .unwrap();
        assert_eq!(thread.join().unwrap(), 191);
    }

    #[test]
    fn a_formula_with_complex_inputs_is_complex() {
        struct Plane;
        impl Binder for Plane {
            fn name(&self, _variable: &Variable, _local: &[Name]) -> Option<Binding> {
                Some(Binding::Input {
                    slot: 0,
                    form: Form::COMPLEX,
                })
            }
        }
        let program = Program::compile(&Expr::read("sqrt(z^2 + 1)/z").unwrap(), &Plane).unwrap();
        let data = [Precise::exact(0.0), Precise::exact(2.0)];
        let value = program
            .evaluate(&data, &mut Workspace::default())
            .unwrap()
            .as_complex()
            .unwrap();
        assert!(
            (value.re - 0.75_f64.sqrt()).abs() < 1e-15 && value.im.abs() < 1e-15,
            "{value:?}"
        );
        let real: Approx<f64> = Approx::certain(1.0);
        assert_eq!(real.bound(), 0.0);
    }
}
