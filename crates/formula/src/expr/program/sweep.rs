//! A program run at many values of some inputs: what does not depend on them is computed once.
//!
//! The first run over each kind of number takes all steps, and notes those that depend on what varies. If every branch
//! was taken for a reason that stays, later runs repeat these steps alone; else, and within searches, they are whole runs.
//! Either way each step gets the numbers that it gets in a whole run, so that results are the same to the last bit.

use super::instruction::{Instruction, ProgramStep};
use super::lanes::ProgramLanes;
use super::machine::{Machine, weight};
use super::{Absence, Inputs, Outcome, Program, Registers};
use crate::expr::{Approx, Doubt, Scalar, Undefined};
use crate::work;
use vibank_dynamics::numerics::Dd;

/// A program at hand for runs between which only some inputs change.
///
/// # Examples
///
/// ```
/// use vibank_formula::expr::{Expr, Precise, Program, Slots};
/// let formula = Expr::read("sqrt(k/m)*t")?;
/// let program = Program::compile(&formula, &Slots(&["k", "m", "t"]))?;
/// let mut data = [8.0, 2.0, 0.0].map(Precise::exact);
/// let mut sweep = program.sweep(vec![2]);
/// for time in [1.0, 2.5] {
///     data[2] = Precise::exact(time);
///     assert_eq!(sweep.real(0.0, &data[..])?, 2.0*time);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Sweep<'p> {
    program: &'p Program,
    /// The slots of the inputs that change.
    varied: Vec<u32>,
    double: Lap<Approx<f64>>,
    wide: Lap<Approx<Dd>>,
}

/// What runs over one kind of number leave for the next one.
struct Lap<S> {
    registers: Registers<S>,
    path: Option<SweptSteps>,
}

/// The steps of a run that are taken anew.
enum SweptSteps {
    /// All, since which ones are taken may change.
    Whole,
    /// These.
    Fixed {
        steps: Vec<u32>,
        /// How many steps a whole run has, which is what a run counts for.
        taken: u64,
        /// Whether more digits could change a decision among those that are not taken anew.
        is_open: bool,
    },
}

impl<'p> Sweep<'p> {
    pub(crate) fn new(program: &'p Program, varied: Vec<u32>) -> Self {
        Self {
            program,
            varied,
            double: Lap::default(),
            wide: Lap::default(),
        }
    }

    /// The real number (or truth) for these inputs, where an error of `accuracy` is good enough: as
    /// [`Program::evaluate_within`], to the last bit.
    ///
    /// # Errors
    ///
    /// Those of [`Program::evaluate_real`].
    pub fn real<I>(&mut self, accuracy: f64, inputs: &I) -> Result<f64, Absence>
    where
        I: Inputs<Approx<f64>> + Inputs<Approx<Dd>> + ?Sized,
    {
        let (program, varied) = (self.program, &self.varied);
        let double = self.double.run(program, varied, inputs);
        let wide = &mut self.wide;
        program.real(accuracy, double, move || wide.run(program, varied, inputs))
    }
}

impl Sweep<'_> {
    /// The real numbers for each of these inputs, as [`Self::real`] gives them.
    ///
    /// # Errors
    ///
    /// Those of [`Self::real`], for the first inputs that have one.
    pub fn reals<I>(&mut self, accuracy: f64, inputs: &[I]) -> Result<Vec<f64>, Absence>
    where
        I: Inputs<Approx<f64>> + Inputs<Approx<Dd>>,
    {
        let Some((first, rest)) = inputs.split_first() else {
            return Ok(Vec::new());
        };
        let first = self.real(accuracy, first)?;
        let mut all = Vec::with_capacity(inputs.len());
        all.push(first);
        let (program, varied) = (self.program, &self.varied);
        let Some(lanes) = self.double.lanes(program, rest) else {
            for own in rest {
                all.push(self.real(accuracy, own)?);
            }
            return Ok(all);
        };
        for (place, own) in rest.iter().enumerate() {
            let (number, is_open) = lanes.at(program.results[0], place);
            if !is_open && number.bound <= accuracy && number.value.is_finite() {
                all.push(number.value);
                continue;
            }
            let double = Ok(Outcome::of_one(number, is_open));
            let wide = &mut self.wide;
            all.push(program.real(accuracy, double, move || wide.run(program, varied, own))?);
        }
        Ok(all)
    }
}

impl Sweep<'_> {
    /// The real numbers for each of these inputs in binary64 alone, each with the bound on its error that it has there.
    ///
    /// # Errors
    ///
    /// The operation that has no value, for the first inputs that have one; a program that computes anything but one real
    /// number or truth is [`Undefined::NotReal`].
    pub fn doubles<I>(&mut self, inputs: &[I]) -> Result<Vec<Approx<f64>>, Absence>
    where
        I: Inputs<Approx<f64>>,
    {
        let (program, varied) = (self.program, &self.varied);
        let [result] = program.results[..] else {
            let (reason, span) = (Undefined::NotReal, program.span());
            return Err(Absence { reason, span });
        };
        let mut all = Vec::with_capacity(inputs.len());
        let Some((first, rest)) = inputs.split_first() else {
            return Ok(all);
        };
        all.extend(self.double.run(program, varied, first)?.numbers());
        if let Some(lanes) = self.double.lanes(program, rest) {
            all.extend((0..rest.len()).map(|place| *lanes.at(result, place).0));
            return Ok(all);
        }
        for own in rest {
            all.extend(self.double.run(program, varied, own)?.numbers());
        }
        Ok(all)
    }
}

impl<S> Default for Lap<S> {
    fn default() -> Self {
        Self {
            registers: Registers::default(),
            path: None,
        }
    }
}

impl<S: Scalar> Lap<S> {
    /// The runs with each of these inputs, if all of them take the steps that are known.
    fn lanes(&self, program: &Program, inputs: &[impl Inputs<S>]) -> Option<ProgramLanes<'_, S>> {
        let Some(SweptSteps::Fixed {
            steps,
            taken,
            is_open,
        }) = &self.path
        else {
            return None;
        };
        let doubt = Doubt { is_open: *is_open };
        let lanes = ProgramLanes::run(program, steps, self.registers.all(), inputs, doubt)?;
        let _ = work::spend(taken * inputs.len() as u64 * weight::<S>());
        Some(lanes)
    }

    fn run<'a>(
        &'a mut self,
        program: &'a Program,
        varied: &[u32],
        inputs: &(impl Inputs<S> + ?Sized),
    ) -> Result<Outcome<'a, S>, Absence> {
        let is_open =
            match &self.path {
                Some(SweptSteps::Whole) => return program.run(inputs, &mut self.registers),
                Some(SweptSteps::Fixed {
                    steps,
                    taken,
                    is_open,
                }) => {
                    let mut machine = Machine::new(program, &inputs, self.registers.of(program));
                    machine.doubt.is_open = *is_open;
                    machine.repeat(steps)?;
                    // The steps are taken by now; whoever spends next finds that nothing is left.
                    let _ = work::spend(taken * weight::<S>());
                    machine.doubt.is_open
                }
                None => {
                    if program.code.iter().any(|own| {
                        matches!(own.step, ProgramStep::Root(_) | ProgramStep::Integral(_))
                    }) {
                        self.path = Some(SweptSteps::Whole);
                        return program.run(inputs, &mut self.registers);
                    }
                    let mut machine = Machine::new(program, &inputs, self.registers.of(program));
                    let path = first(&mut machine, program, varied)?;
                    let is_open = machine.doubt.is_open;
                    self.path = Some(path);
                    is_open
                }
            };
        Ok(program.outcome(&self.registers, is_open))
    }
}

/// Takes all steps of a run without searches, and tells which of them depend on what varies.
fn first<S: Scalar>(
    machine: &mut Machine<'_, S>,
    program: &Program,
    varied: &[u32],
) -> Result<SweptSteps, Absence> {
    let count = program.registers as usize;
    let (mut varies, mut is_written) = (vec![false; count], vec![false; count]);
    let (mut steps, mut taken) = (Vec::with_capacity(program.code.len()), 0);
    let (mut is_fixed, mut stays_open) = (true, false);
    let mut at = 0;
    while let Some(&Instruction { step, out }) = program.code.get(at as usize) {
        let moves = match step {
            ProgramStep::Input(slot) => varied.contains(&slot),
            _ => step.reads().any(|register| varies[register as usize]),
        };
        let was_open = std::mem::take(&mut machine.doubt.is_open);
        let next = machine.take(at)?;
        stays_open |= machine.doubt.is_open && !moves;
        machine.doubt.is_open |= was_open;
        taken += 1;
        if step.is_jump() {
            is_fixed &= !moves;
        } else {
            for register in out..out + step.width() {
                // What is written twice would be read too late by the steps between.
                is_fixed &= !std::mem::replace(&mut is_written[register as usize], true);
                varies[register as usize] = moves;
            }
            steps.extend(moves.then_some(at));
        }
        at = next;
    }
    let _ = work::spend(taken * weight::<S>());
    Ok(if is_fixed {
        SweptSteps::Fixed {
            steps,
            taken,
            is_open: stays_open,
        }
    } else {
        SweptSteps::Whole
    })
}

#[cfg(test)]
mod tests {
    use crate::expr::{Expr, Precise, Program, Slots, Workspace};
    use vibank_dynamics::numerics::Rational;

    /// Results, also those that are none, are those of whole runs to the last bit, whatever the formula branches on.
    #[test]
    fn a_sweep_gives_what_whole_runs_give() {
        let formulas = [
            "a*exp(-b*t)*cos(sqrt(a/b)*t - atan2(a, b))",
            "if a > b then a*sin(b*t) else t^2",
            "if a < b then a*sin(b*t) else t^2",
            "if t > 1 then a*t else b",
            "if a > 3*b and t > 1 then a*t else b - t",
            "(a - 3*b)*t + (1 + 1e-17*t) - 1",
            "if a == 3*b then floor(a/b)*t else 7",
            "sqrt(1 - t)*ln(b)",
            "a/(t - 2)",
            "root(x^2 - a*t, x, 0, 5) + b",
            "integral(s*t, s, 0, a)",
            "a - 3*b",
            "t",
            "min(a, t)*mod(t, b)",
            "a < t",
            "a*exp(t^4)",
        ];
        let slots = ["a", "b", "t"];
        let at = |time| {
            let data = ["0.3", "0.1"].map(|own| Rational::from_decimal(own).unwrap());
            [data[0].into(), data[1].into(), Precise::exact(time)]
        };
        for text in formulas {
            let program = Program::compile(&Expr::read(text).unwrap(), &Slots(&slots)).unwrap();
            let (mut sweep, mut room) = (program.sweep(vec![2]), Workspace::default());
            for accuracy in [0.0, 1e-6] {
                for time in [0.0, 0.5, 1.0, 1.5, 2.0, 10.0, 0.5] {
                    let data = at(time);
                    let whole = program.evaluate_within(accuracy, &data[..], &mut room);
                    let found = sweep.real(accuracy, &data[..]);
                    let bits = |own: Result<f64, _>| own.map(f64::to_bits);
                    assert_eq!(bits(found), bits(whole), "{text} at {time}");
                }
                let all = [0.0, 0.5, 0.75, 1.5, 0.3].map(at);
                let together = program.sweep(vec![2]).reals(accuracy, &all);
                let whole = all.iter();
                let whole = whole.map(|data| program.evaluate_within(accuracy, data, &mut room));
                let whole: Result<Vec<f64>, _> = whole.collect();
                let bits = |own: Vec<f64>| own.into_iter().map(f64::to_bits).collect::<Vec<_>>();
                assert_eq!(together.map(bits), whole.map(bits), "{text}");
            }
        }
    }

    /// What the inputs that stay give is computed once.
    #[test]
    fn only_what_varies_is_asked_for_again() {
        use crate::expr::{Approx, Inputs, Undefined};
        use std::cell::Cell;
        struct Counted(Cell<u32>);
        impl<N: crate::expr::Real> Inputs<Approx<N>> for Counted
        where
            Approx<N>: crate::expr::Scalar,
        {
            fn input(&self, slot: u32) -> Result<Approx<N>, Undefined> {
                self.0.set(self.0.get() + 1);
                Ok(crate::expr::Scalar::of(&Precise::exact(
                    f64::from(slot) + 2.0,
                )))
            }
        }
        let formula = Expr::read("a*b + exp(a)*t").unwrap();
        let program = Program::compile(&formula, &Slots(&["a", "b", "t"])).unwrap();
        let (mut sweep, inputs) = (program.sweep(vec![2]), Counted(Cell::new(0)));
        for asked in [3, 4, 5] {
            sweep.real(0.0, &inputs).unwrap();
            assert_eq!(inputs.0.get(), asked);
        }
    }
}
