//! The table of all measurements, and what it says for and against our methods.

use std::fmt::Write;

use vibank::numerics::Dd;

use crate::measure::{Timing, time};
use crate::reference::Case;

/// One measurement: a method on a case of a task.
#[derive(Clone, Debug)]
pub(crate) struct Record {
    pub(crate) task: String,
    pub(crate) case: String,
    /// The small number of a sweep.
    pub(crate) parameter: Option<f64>,
    pub(crate) method: &'static str,
    /// Tolerance of an integrator.
    pub(crate) tolerance: Option<f64>,
    pub(crate) timing: Timing,
    pub(crate) error: Error,
}

/// The error of a method on a case.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Error {
    /// Largest error of a value over that value.
    pub(crate) relative: f64,
    /// Largest error over the scale of the case.
    pub(crate) scaled: f64,
    /// Digits of the reference values.
    pub(crate) digits: u32,
}

/// Digits of the committed references.
const COMMITTED: u32 = 50;

impl Error {
    /// The errors of samples, whose scale is the largest of them.
    pub(crate) fn of_samples(values: &[f64], exact: &[Dd]) -> Self {
        let scale = exact.iter().fold(0.0_f64, |most, x| most.max(x.hi().abs()));
        Self {
            scaled: largest(values, exact, |_| scale),
            ..Self::of_each(values, exact)
        }
    }

    /// The errors of values of different kinds: each is its own scale.
    pub(crate) fn of_each(values: &[f64], exact: &[Dd]) -> Self {
        let relative = largest(values, exact, |exact| exact.hi().abs());
        Self {
            relative,
            scaled: relative,
            digits: COMMITTED,
        }
    }

    /// One number that is its own measure, against references that are computed in double-double arithmetic.
    pub(crate) const fn computed(error: f64) -> Self {
        Self {
            relative: error,
            scaled: error,
            digits: 30,
        }
    }
}

/// The largest error over its scale; a value that is no number is all wrong.
fn largest(values: &[f64], exact: &[Dd], scale: impl Fn(Dd) -> f64) -> f64 {
    let errors = values.iter().zip(exact).map(|(value, exact)| {
        let error = (*exact - *value).hi().abs();
        if error == 0.0 {
            return 0.0;
        }
        let share = error / scale(*exact);
        if share.is_nan() { 1.0 } else { share }
    });
    errors.fold(0.0, f64::max)
}

impl Case {
    fn record(&self, method: &'static str, timing: Timing, error: Error) -> Record {
        Record {
            task: self.task.clone(),
            case: self.case.clone(),
            parameter: self.parameter,
            method,
            tolerance: None,
            timing,
            error,
        }
    }

    /// Measures a method that yields one sample at a time.
    pub(crate) fn samples(&self, method: &'static str, sample: impl Fn(usize) -> f64) -> Record {
        let count = self.at.len();
        let values: Vec<f64> = (0..count).map(&sample).collect();
        let timing = time(|item| sample(item % count));
        self.record(method, timing, Error::of_samples(&values, &self.values()))
    }

    /// Measures a method that yields all samples at once; an item is one sample.
    pub(crate) fn all(&self, method: &'static str, solve: impl Fn() -> Vec<f64>) -> Record {
        let timing = time(|_| solve()).over(self.at.len());
        self.record(method, timing, Error::of_samples(&solve(), &self.values()))
    }

    /// Measures a method that yields all values of a case at once; an item is all of them.
    pub(crate) fn solution<const N: usize>(
        &self,
        method: &'static str,
        solve: impl Fn() -> [f64; N],
    ) -> Record {
        let error = Error::of_each(&solve(), &self.values());
        self.record(method, time(|_| solve()), error)
    }
}

/// The measurements as comma-separated values with a header.
pub(crate) fn table(records: &[Record]) -> String {
    let build = if cfg!(target_feature = "fma") {
        "fma"
    } else {
        "portable"
    };
    let mut text = String::from(
        "task,case,method,tolerance,ns_per_item,items,max_rel_err,max_scaled_err,ref_digits,build,median_ns\n",
    );
    for record in records {
        let tolerance = record
            .tolerance
            .map_or(String::new(), |tolerance| format!("{tolerance:e}"));
        writeln!(
            text,
            "{},{},{},{tolerance},{:.4},{},{:e},{:e},{},{build},{:.4}",
            record.task,
            record.case,
            record.method,
            record.timing.fast,
            record.timing.items,
            record.error.relative,
            record.error.scaled,
            record.error.digits,
            record.timing.median,
        )
        .expect("a string takes any text");
    }
    text
}

impl Record {
    /// Whether the method is one of ours.
    pub(crate) fn is_ours(&self) -> bool {
        self.method.starts_with("vibank")
    }

    /// Whether this method is surely faster and more accurate: by more than timing scatters, and by more than the rounding
    /// of the result itself, 2⁻⁵³.
    fn beats(&self, other: &Self) -> bool {
        const SCATTER: f64 = 1.1;
        let error = |record: &Self| record.error.scaled.max(f64::EPSILON / 2.0);
        self.timing.yards * SCATTER < other.timing.yards && error(self) < error(other)
    }
}

/// The measurements that are both faster and more accurate than each of ours on the same case.
pub(crate) fn better(records: &[Record]) -> Vec<&Record> {
    let ours = |of: &Record| {
        let (task, case) = (of.task.clone(), of.case.clone());
        records
            .iter()
            .filter(move |own| own.is_ours() && own.task == task && own.case == case)
    };
    records
        .iter()
        .filter(|record| !record.is_ours() && ours(record).all(|own| record.beats(own)))
        .collect()
}
