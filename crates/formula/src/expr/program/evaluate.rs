//! Evaluation: in binary64, again in double-double where that leaves too much open, and with 256 bits where even that cannot
//! tell a result from zero.

use thiserror::Error;

use super::instruction::Step;
use super::machine::{Machine, weight};
use super::{Program, Value};
use crate::expr::{Approx, Field, Precise, Real, Scalar, Undefined};
use crate::work;
use vibank_dynamics::numerics::{Dd, Long};
use vibank_source::Span;

/// Most work of one run: what two integrals take that stand in each other, some tenths of a second.
const MAX_WORK: u64 = 20_000_000;

/// A result whose error may exceed this part of it is computed again with more digits.
const WIDEST: f64 = 1e-13;

/// Gives a program its inputs, each when it is asked for.
pub trait Inputs<S> {
    /// The number in a slot.
    ///
    /// # Errors
    ///
    /// Usually [`Undefined::Missing`], where it has no value.
    fn input(&self, slot: u32) -> Result<S, Undefined>;

    /// A derivative (0 for the value) of a function of time that is computed elsewhere.
    ///
    /// # Errors
    ///
    /// Why it has no value at this time.
    fn motion(&self, index: u32, order: u8, time: &S) -> Result<S, Undefined> {
        let _ = (order, time);
        Err(Undefined::Missing { slot: index })
    }
}

/// Inputs that are known as such, one per slot.
impl<S: Scalar> Inputs<S> for [Precise] {
    #[inline]
    fn input(&self, slot: u32) -> Result<S, Undefined> {
        self.get(slot as usize)
            .map(S::of)
            .ok_or(Undefined::Missing { slot })
    }
}

/// What is behind a reference, which can stand for it where a size is needed.
impl<S, I: Inputs<S> + ?Sized> Inputs<S> for &I {
    #[inline]
    fn input(&self, slot: u32) -> Result<S, Undefined> {
        (**self).input(slot)
    }

    #[inline]
    fn motion(&self, index: u32, order: u8, time: &S) -> Result<S, Undefined> {
        (**self).motion(index, order, time)
    }
}

impl<S: Scalar, const N: usize> Inputs<S> for [Precise; N] {
    #[inline]
    fn input(&self, slot: u32) -> Result<S, Undefined> {
        self.as_slice().input(slot)
    }
}

/// Why a formula has no value for these data, and the operation that has none.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("{reason}")]
pub struct Absence {
    /// What has no value, or is not a number.
    pub reason: Undefined,
    /// Where the operation stands in its formula.
    pub span: Span,
}

/// Room for a run, kept from one to the next.
#[derive(Clone, Debug)]
pub struct Registers<S>(Vec<S>);

impl<S> Default for Registers<S> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<S: Scalar> Registers<S> {
    /// What is in them.
    pub(crate) fn all(&self) -> &[S] {
        &self.0
    }

    /// Those of a program.
    pub(crate) fn of(&mut self, program: &Program) -> &mut [S] {
        let size = program.registers as usize;
        if self.0.len() < size {
            self.0.resize(size, S::exact(0.0));
        }
        &mut self.0
    }
}

/// Room for evaluations, kept from one to the next so that nothing is allocated.
#[derive(Clone, Debug, Default)]
pub struct Workspace {
    double: Registers<Approx<f64>>,
    wide: Registers<Approx<Dd>>,
    long: Registers<Approx<Long>>,
}

/// Inputs of thirty digits for a run with more.
struct Lengthened<'a, I: ?Sized>(&'a I);

impl<I: Inputs<Approx<Dd>> + ?Sized> Inputs<Approx<Long>> for Lengthened<'_, I> {
    fn input(&self, slot: u32) -> Result<Approx<Long>, Undefined> {
        let Approx { value, bound } = self.0.input(slot)?;
        let value = Long::from(value.hi()) + Long::from(value.lo());
        Ok(Approx::new(value, bound))
    }
}

/// What a run gave.
#[derive(Clone, Debug)]
pub struct Outcome<'a, S> {
    registers: &'a [S],
    results: &'a [u32],
    /// Whether a decision (a comparison, a rounding) was taken that more digits could change.
    pub is_open: bool,
}

impl<'a, S> Outcome<'a, S> {
    /// The entries by rows; of complex entries real and imaginary part.
    pub fn numbers(&self) -> impl ExactSizeIterator<Item = &'a S> + use<'a, S> {
        let registers = self.registers;
        self.results
            .iter()
            .map(move |register| &registers[*register as usize])
    }
}

impl<'a, S> Outcome<'a, S> {
    /// One number.
    pub(crate) fn of_one(number: &'a S, is_open: bool) -> Self {
        Self {
            registers: std::slice::from_ref(number),
            results: &[0],
            is_open,
        }
    }
}

impl Program {
    /// Runs the program once over one kind of number.
    ///
    /// # Errors
    ///
    /// The operation that has no value for these inputs.
    pub fn run<'a, S: Scalar>(
        &'a self,
        inputs: &(impl Inputs<S> + ?Sized),
        room: &'a mut Registers<S>,
    ) -> Result<Outcome<'a, S>, Absence> {
        let mut machine = Machine::new(self, &inputs, room.of(self));
        let length = self.code.len() as u32;
        let run = work::within(MAX_WORK, || {
            let run = machine.run(0, length);
            // The branches that are not taken cost nothing. What runs out in a search was found there.
            let steps = *run.as_ref().unwrap_or(&u64::from(length));
            let _ = work::spend(steps * weight::<S>());
            run
        });
        run.value?;
        let is_open = machine.doubt.is_open;
        Ok(self.outcome(room, is_open))
    }

    /// What a run has left in its registers.
    pub(crate) fn outcome<'a, S>(
        &'a self,
        room: &'a Registers<S>,
        is_open: bool,
    ) -> Outcome<'a, S> {
        Outcome {
            registers: &room.0,
            results: &self.results,
            is_open,
        }
    }

    /// The value for these inputs, rounded to binary64.
    ///
    /// Runs in binary64 first. If that leaves a decision open, or a result uncertain by more than 1e-13 of it, or has
    /// no value, the program runs again in double-double, and a third time with 256 bits if that does not leave a part
    /// in 1e13 of a result certain either. What cannot be told from zero even then is zero; its bound says how little is
    /// known of it.
    ///
    /// # Errors
    ///
    /// The operation that has no value for these inputs, or a result that is infinite.
    pub fn evaluate<I>(&self, inputs: &I, room: &mut Workspace) -> Result<Value, Absence>
    where
        I: Inputs<Approx<f64>> + Inputs<Approx<Dd>> + ?Sized,
    {
        let first = match self.run(inputs, &mut room.double) {
            Ok(outcome) => {
                let value = self.value(outcome.numbers().map(|x| (x.value, x.bound)));
                if is_settled(&outcome) {
                    return value;
                }
                value
            }
            Err(absence) => Err(absence),
        };
        let second = match self.run(inputs, &mut room.wide) {
            Ok(outcome) => {
                let value = self.value(outcome.numbers().map(rounded));
                if outcome.numbers().all(is_certain) {
                    return value;
                }
                value
            }
            Err(absence) if absence.reason == Undefined::TooLong => return first,
            Err(absence) if absence.reason != Undefined::DivisionByZero => return Err(absence),
            Err(absence) => Err(absence),
        };
        if !self.is_explicit() {
            return second;
        }
        match self.run(&Lengthened(inputs), &mut room.long) {
            Ok(outcome) => self.value(outcome.numbers().map(rounded)),
            Err(_) => second,
        }
    }

    /// Whether it computes numbers, step by step: searches and motions are as good as their methods, which more digits do not
    /// change.
    fn is_explicit(&self) -> bool {
        let is_step =
            |step: &Step| !matches!(step, Step::Root(_) | Step::Integral(_) | Step::Motion(..));
        self.form.field != Field::Boolean
            && self
                .code
                .iter()
                .all(|instruction| is_step(&instruction.step))
            && self
                .constants
                .iter()
                .all(|constant| constant.high().is_finite())
    }

    /// The real number (or truth) that the program computes, as [`Self::evaluate`] does with at most thirty digits, without
    /// allocation.
    ///
    /// # Errors
    ///
    /// As [`Self::evaluate`]; a program that computes anything but one real number or truth is
    /// [`Undefined::NotReal`].
    pub fn evaluate_real<I>(&self, inputs: &I, room: &mut Workspace) -> Result<f64, Absence>
    where
        I: Inputs<Approx<f64>> + Inputs<Approx<Dd>> + ?Sized,
    {
        self.evaluate_within(0.0, inputs, room)
    }

    /// The same where an error of `accuracy` is good enough, in SI units: near a zero of a function, more digits than
    /// its size asks for cost ten times as long.
    ///
    /// # Errors
    ///
    /// Those of [`Self::evaluate_real`].
    pub fn evaluate_within<I>(
        &self,
        accuracy: f64,
        inputs: &I,
        room: &mut Workspace,
    ) -> Result<f64, Absence>
    where
        I: Inputs<Approx<f64>> + Inputs<Approx<Dd>> + ?Sized,
    {
        let double = self.run(inputs, &mut room.double);
        self.real(accuracy, double, || self.run(inputs, &mut room.wide))
    }

    /// The number that a run in binary64 gave, or where that is not good enough, one in double-double.
    pub(crate) fn real<'w>(
        &self,
        accuracy: f64,
        double: Result<Outcome<'_, Approx<f64>>, Absence>,
        wide: impl FnOnce() -> Result<Outcome<'w, Approx<Dd>>, Absence>,
    ) -> Result<f64, Absence> {
        if self.form.width() != 1 {
            let (reason, span) = (Undefined::NotReal, self.span());
            return Err(Absence { reason, span });
        }
        let first = match double {
            Ok(outcome) => {
                let number = self.single(outcome.numbers().map(|x| (x.value, x.bound)));
                let is_near = |(_, bound): (f64, f64)| !outcome.is_open && bound <= accuracy;
                if is_settled(&outcome) || number.as_ref().is_ok_and(|own| is_near(*own)) {
                    return Ok(number?.0);
                }
                number
            }
            Err(absence) => Err(absence),
        };
        let number = match wide() {
            Ok(outcome) => self.single(outcome.numbers().map(rounded)),
            Err(absence) if absence.reason == Undefined::TooLong => first,
            Err(absence) => Err(absence),
        };
        Ok(number?.0)
    }

    /// A finite number with its bound.
    fn single(&self, mut numbers: impl Iterator<Item = (f64, f64)>) -> Result<(f64, f64), Absence> {
        let number = numbers.next().filter(|(number, _)| number.is_finite());
        number.ok_or_else(|| Absence {
            reason: Undefined::Overflow,
            span: self.span(),
        })
    }

    /// A value of finite numbers.
    fn value(&self, numbers: impl ExactSizeIterator<Item = (f64, f64)>) -> Result<Value, Absence> {
        let (numbers, bounds): (Vec<f64>, Vec<f64>) = numbers.unzip();
        let is_finite = numbers.iter().all(|number| number.is_finite());
        Value::new(self.form, numbers, bounds)
            .filter(|_| is_finite)
            .ok_or_else(|| Absence {
                reason: Undefined::Overflow,
                span: self.span(),
            })
    }

    /// Where the whole formula was written.
    fn span(&self) -> Span {
        self.spans.last().copied().unwrap_or(Span::NONE)
    }
}

/// Whether more digits would change nothing that matters.
fn is_settled(outcome: &Outcome<'_, Approx<f64>>) -> bool {
    !outcome.is_open && outcome.numbers().all(is_certain)
}

/// Whether the error of a result is a small part of it.
fn is_certain<T: Real>(x: &Approx<T>) -> bool {
    x.bound <= WIDEST * x.value.to_f64().abs()
}

/// A result with more digits in binary64, with its bound.
fn rounded<T: Real>(x: &Approx<T>) -> (f64, f64) {
    let (high, low) = (x.value.to_f64(), x.value.low());
    if high.abs() <= x.bound {
        return (0.0, x.bound + high.abs());
    }
    (high, x.bound + low.abs())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::{Expr, Slots};
    use vibank_dynamics::numerics::Rational;

    const NAMES: [&str; 4] = ["a", "b", "x", "t"];

    fn decimals(data: &[&str]) -> Vec<Precise> {
        let of = |text: &&str| Precise::from(Rational::from_decimal(text).unwrap());
        data.iter().map(of).collect()
    }

    fn program(formula: &str) -> Program {
        Program::compile(&Expr::read(formula).unwrap(), &Slots(&NAMES)).unwrap()
    }

    fn value(formula: &str, data: &[&str]) -> Result<Value, Absence> {
        program(formula).evaluate(&decimals(data)[..], &mut Workspace::default())
    }

    fn real(formula: &str) -> f64 {
        let value = value(formula, &["0.3", "0.1", "-2.5", "1.75"]);
        value
            .unwrap()
            .as_real()
            .unwrap_or_else(|| panic!("{formula}"))
    }

    fn truth(formula: &str) -> bool {
        let value = value(formula, &["0.3", "0.1", "-2.5", "1.75"]);
        value.unwrap().as_boolean().unwrap()
    }

    fn absence(formula: &str) -> (Undefined, &str) {
        let absence = value(formula, &["0.3", "0.1", "-2.5", "1.75"]).unwrap_err();
        (absence.reason, &formula[absence.span.range()])
    }

    fn assert_near(found: f64, expected: f64) {
        assert!(
            (found - expected).abs() <= 4.0 * f64::EPSILON * expected.abs(),
            "{found} {expected}"
        );
    }

    #[test]
    fn ties_in_decimal_data_come_out_as_on_paper() {
        for holds in [
            "0.1 + 0.2 == 0.3",
            "a == 3*b",
            "3*b <= a",
            "a <= 3*b",
            "not 3*b > a",
            "b < 0.2 <= 2*b",
            "a/b == 3",
            "sqrt(a^2) == 3*b",
            "mod(a, b) == 0",
            "sign(a - 3*b) == 0",
            "(1 + 1e-12)*a > 3*b",
            "a*(1 + 1e-25) == a or a*(1 + 1e-25) > a",
            "1 < 2 < 3 and not 1 < 3 < 2",
        ] {
            assert!(truth(holds), "{holds}");
        }
        for (formula, expected) in [
            ("floor(a/b)", 3.0),
            ("floor(0.3/0.1)", 3.0),
            ("ceil(a/b)", 3.0),
            ("ceil(a/b + 1e-9)", 4.0),
            ("floor(a/b - 1e-15)", 2.0),
            ("round(5*b)", 1.0),
            ("round(-5*b)", -1.0),
            ("round(0.49999999999)", 0.0),
            ("mod(x, 1)", 0.5),
            ("a - 3*b", 0.0),
            ("sign(-a)", -1.0),
            ("(-1)^floor(a/b)", -1.0),
            ("x^2", 6.25),
            ("x^(a/b)", -15.625),
            ("abs(x)^0.5", 1.581_138_830_084_189_7),
        ] {
            assert_eq!(real(formula), expected, "{formula}");
        }
    }

    #[test]
    fn cancellation_is_answered_with_more_digits() {
        assert_eq!(real("(1 + 1e-14*b) - 1"), 1e-15);
        assert_eq!(real("(sqrt(1 + 1e-20) - 1)/1e-20"), 0.5);
        assert_eq!(real("(1 - cos(1e-9))/1e-18"), 0.5);
        assert_eq!(real("exp(1e-18) - 1"), 1e-18);
    }

    /// Values by mpmath with 120 digits: differences that thirty digits lose. Data and constants are still known to thirty
    /// digits, which bounds what comes out.
    #[test]
    fn what_thirty_digits_lose_is_found_with_more() {
        for (formula, expected) in [
            (
                "(1 - (1e-9)^2/2)/cos(1e-9) - 1",
                -4.166_666_666_666_666_4e-38,
            ),
            ("1 - cos(1e-17)", 5e-35),
            ("sin(1e-7)/1e-7 - 1 + (1e-7)^2/6", 8.333_333_333_333_331e-31),
            ("sqrt(4) - sqrt(4 - (1e-18)^2)", 2.5e-37),
            ("1/sqrt(1 - (1e-9)^2) - 1 - (1e-9)^2/2", 3.75e-37),
            (
                "exp(-1e-12) - 1 + 1e-12 - (1e-12)^2/2",
                -1.666_666_666_666_25e-37,
            ),
            (
                "(1 - 1e-16)/(1 + 1e-16) - 1 + 2e-16",
                1.999_999_999_999_999_8e-32,
            ),
            ("cos(0.5) - cos(0.5 + 1e-36)", 4.794_255_386_042_03e-37),
            (
                "2/pi*elliptic_k(sin(3.14159265/2)^2)",
                13.702_994_082_910_26,
            ),
            (
                "elliptic_k(sin(3.141592653589793/2)^2)",
                38.051_760_549_028_906,
            ),
            ("elliptic_km1(1e-30)", 35.925_070_756_030_58),
            ("elliptic_km1(0.75)", 1.685_750_354_812_596),
            ("2/pi*elliptic_k(sin(1e-9/2)^2) - 1", 6.25e-20),
        ] {
            let found = real(formula);
            assert!(
                (found - expected).abs() <= 1e-13 * expected.abs(),
                "{formula}: {found:e} {expected:e}"
            );
        }
        assert_near(real("1/((1 - (1e-9)^2/2)/cos(1e-9) - 1)"), -2.4e37);
    }

    #[test]
    fn zeros_stay_zeros() {
        for formula in [
            "sin(pi)",
            "sqrt(2)^2 - 2",
            "a - 3*b",
            "cos(b)^2 + sin(b)^2 - 1",
            "exp(ln(a)) - a",
        ] {
            assert_eq!(real(formula), 0.0, "{formula}");
        }
    }

    #[test]
    fn what_has_no_value_says_why_and_where() {
        for (formula, reason, place) in [
            ("1 + b/(a - 3*b)", Undefined::DivisionByZero, "b/(a - 3*b)"),
            ("2*sqrt(x)", Undefined::RootOfNegative, "sqrt(x)"),
            ("ln(x)", Undefined::LogarithmOfNegative, "ln(x)"),
            ("ln(a - 3*b)", Undefined::LogarithmOfZero, "ln(a - 3*b)"),
            ("x^a", Undefined::PowerOfNegative, "x^a"),
            (
                "acos(1 + b)",
                Undefined::OutsideDomain(crate::expr::Function::Acos),
                "acos(1 + b)",
            ),
            ("exp(1e6)", Undefined::Overflow, "exp(1e6)"),
            ("0^-1", Undefined::DivisionByZero, "0^-1"),
            (
                "root(x^2 + 1, x, 0, 1)",
                Undefined::NoSignChange,
                "root(x^2 + 1, x, 0, 1)",
            ),
            ("tan(pi/2)", Undefined::DivisionByZero, "tan(pi/2)"),
        ] {
            assert_eq!(absence(formula), (reason, place), "{formula}");
        }
        assert_eq!(real("if x > 0 then sqrt(x) else 1"), 1.0);
        assert!(truth("x < 0 or sqrt(x) > 1"));
        assert!(!truth("x > 0 and sqrt(x) > 1"));
        assert_eq!(
            value("a", &[]).unwrap_err().reason,
            Undefined::Missing { slot: 0 }
        );
        assert_eq!(real("min(a, inf)"), 0.3);
        assert!(truth("a < inf"));
    }

    #[test]
    fn functions_at_the_ends_of_their_domains_forgive_rounding() {
        assert_eq!(real("sqrt(a - 3*b)"), 0.0);
        assert_eq!(real("acos(3*b/a)"), 0.0);
        assert_eq!(real("asin(a/(3*b))"), std::f64::consts::FRAC_PI_2);
        assert_eq!(real("acosh(3*b/a)"), 0.0);
    }

    #[test]
    fn bound_names_are_local() {
        assert_near(real("at(x^2 + a, x = 2)"), 4.3);
        assert_near(real("at(at(x*a, x = a), a = 2) + a"), 4.3);
        assert_near(real("at(diff(x^3, x), x = 2)"), 12.0);
        assert_near(real("at(diff(x^3*a, x, x), x = 2)"), 3.6);
        assert_near(real("root(x^2 - 2, x, 0, 2)"), std::f64::consts::SQRT_2);
        assert_near(real("root(s - a, s, 0, 10)"), 0.3);
        assert_near(real("root(s^3, s, -1, 2)"), 0.0);
        assert_near(
            real("root(tanh(s)*cosh(s)^2 - a, s, -5, 8)"),
            0.284_412_449_366_123_75,
        );
        assert_near(real("integral(x^2, x, 0, 3)"), 9.0);
        assert_near(real("integral(1/sqrt(s), s, 0, 4)"), 4.0);
        assert_near(real("integral(sin(s), s, 0, pi)"), 2.0);
        assert!((real("integral(abs(s - b), s, 0, 1)") - 0.41).abs() < 1e-14);
        assert_near(real("integral(integral(s*x, s, 0, x), x, 0, 2)"), 2.0);
        assert_near(real("integral(at(x, x = 2*s), s, 0, 1)"), 1.0);
        assert_eq!(
            absence("integral(1/s, s, -1, 2)").0,
            Undefined::NoConvergence
        );
    }

    #[test]
    fn complex_numbers_are_pairs() {
        let complex = |formula: &str| {
            let value = value(formula, &["0.3", "0.1", "-2.5", "1.75"])
                .unwrap()
                .as_complex()
                .unwrap();
            (value.re, value.im)
        };
        assert_eq!(complex("(1 + 2*i)*(3 - i)"), (5.0, 5.0));
        assert_near(complex("(1 + 2*i)/(3 - i)").1, 0.7);
        assert_eq!(complex("i^2"), (-1.0, 0.0));
        assert_eq!(complex("sqrt(-4 + 0*i)"), (0.0, 2.0));
        assert_eq!(complex("exp(i*pi)"), (-1.0, 0.0));
        assert_eq!(complex("if a > 0 then i else 1"), (0.0, 1.0));
        assert_eq!(complex("conj(2*i)"), (0.0, -2.0));
        assert_eq!(real("abs(3 + 4*i)"), 5.0);
        assert_eq!(real("arg(-1 + 0*i)"), std::f64::consts::PI);
        assert_near(real("mod(7*b, 2*b)"), 0.1);
        assert_eq!(real("im((a + i*b)^2)"), 0.06);
        assert_eq!(real("re(ln(-1 + 0*i))"), 0.0);
    }

    #[test]
    fn vectors_and_matrices_are_lists_of_entries() {
        let numbers = |formula: &str| {
            let value = value(formula, &["0.3", "0.1", "-2.5", "1.75"]).unwrap();
            value.numbers().to_vec()
        };
        assert_eq!(numbers("[[1, 2], [3, 4]]*[5, 6]"), [17.0, 39.0]);
        assert_eq!(
            numbers("[[1, 2], [3, 4]]*[[0, 1], [1, 0]]"),
            [2.0, 1.0, 4.0, 3.0]
        );
        assert_eq!(
            numbers("transpose([[1, 2, 3], [4, 5, 6]])"),
            [1.0, 4.0, 2.0, 5.0, 3.0, 6.0]
        );
        assert_eq!(numbers("2*[1, a] - [b, 0]/2"), [1.95, 0.6]);
        assert_eq!(numbers("[[1, 2], [3, 4]][2]"), [3.0, 4.0]);
        assert_eq!(real("[[1, 2], [3, 4]][2, 1]"), 3.0);
        assert_eq!(real("det([[1, 2], [3, 4]])"), -2.0);
        assert_eq!(real("det([[2, -1, 0], [-1, 2, -1], [0, -1, 2]])"), 4.0);
        assert_eq!(
            real("det([[0, 0, 1, 0], [1, 0, 0, 0], [0, 0, 0, 2], [0, 3, 0, 0]])"),
            -6.0
        );
        assert_eq!(real("dot([1, 2, 3], [4, 5, 6])"), 32.0);
        assert_eq!(real("norm([3, 4])"), 5.0);
        assert_eq!(real("norm([3, 4*i])"), 5.0);
        let matrix = value("[[1, 2], [3, 4]]", &[]).unwrap();
        assert_eq!(matrix.as_matrix().unwrap().nth(1), Some(&[3.0, 4.0][..]));
    }

    #[test]
    fn searches_are_bounded_in_time() {
        let nested = "integral(integral(integral(integral(sin(x*y*z*w), x, 0, 9), y, 0, 9), z, 0, 9), w, 0, 9)";
        assert_eq!(value(nested, &[]).unwrap_err().reason, Undefined::TooLong);
    }
}
