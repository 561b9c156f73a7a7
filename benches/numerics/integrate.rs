//! Time integrators at a ladder of tolerances.

use differential_equations::prelude::*;
use vibank::numerics::Dd;

use crate::measure::time;
use crate::record::{Error, Record};
use crate::reference::Case;

/// The tolerances of the ladder.
const TOLERANCES: [f64; 6] = [1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13];

/// Most steps of one integration; a motion that needs more is left out.
const MAX_STEPS: usize = 200_000;

/// The time integrators that stand for all.
#[derive(Clone, Copy)]
enum Integrator {
    DormandPrince8,
    Verner9,
}

impl Integrator {
    const ALL: [Self; 2] = [Self::DormandPrince8, Self::Verner9];

    const fn name(self) -> &'static str {
        match self {
            Self::DormandPrince8 => "DOP853",
            Self::Verner9 => "Verner 9(8)",
        }
    }

    /// States at the given times, the first of which is the start; none if the integrator gives up.
    fn states<const N: usize>(
        self,
        equation: &impl ODE<f64, [f64; N]>,
        start: [f64; N],
        times: &[f64],
        tolerance: f64,
    ) -> Option<Vec<[f64; N]>> {
        let (first, last) = (*times.first()?, *times.last()?);
        let problem = IVP::ode(equation, first, last, start).t_eval(times);
        let solution = match self {
            Self::DormandPrince8 => {
                let method = ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance);
                problem.method(method.max_steps(MAX_STEPS)).solve()
            }
            Self::Verner9 => {
                let method = ExplicitRungeKutta::rkv988e()
                    .rtol(tolerance)
                    .atol(tolerance);
                problem.method(method.max_steps(MAX_STEPS)).solve()
            }
        };
        let states = solution.ok()?.y;
        (states.len() == times.len()).then_some(states)
    }
}

/// A task and its case, for records that have no line in the table of references.
#[derive(Clone, Copy)]
pub(crate) struct Place<'a> {
    pub(crate) task: &'a str,
    pub(crate) case: &'a str,
    /// Parts of an item that are told apart: samples of a motion.
    pub(crate) parts: usize,
}

/// Measures all integrators at all tolerances. Errors are those that `error` finds in the states.
///
/// Between its steps DOP853 of this crate interpolates with a lower order than it integrates; errors are fair at the last time.
pub(crate) fn ladder<const N: usize>(
    place: Place<'_>,
    equation: &impl ODE<f64, [f64; N]>,
    start: [f64; N],
    times: &[f64],
    error: impl Fn(&[[f64; N]]) -> Error,
) -> Vec<Record> {
    let mut records = Vec::new();
    for integrator in Integrator::ALL {
        for tolerance in TOLERANCES {
            let Some(states) = integrator.states(equation, start, times, tolerance) else {
                continue;
            };
            let run = || integrator.states(equation, start, times, tolerance);
            records.push(Record {
                task: place.task.to_owned(),
                case: place.case.to_owned(),
                parameter: None,
                method: integrator.name(),
                tolerance: Some(tolerance),
                timing: time(|_| run()).over(place.parts),
                error: error(&states),
            });
        }
    }
    records
}

impl Case {
    /// The ladder for a motion whose first component has the values of this case; an item is one sample, the error that at
    /// the last time.
    pub(crate) fn integrated<const N: usize>(
        &self,
        equation: &impl ODE<f64, [f64; N]>,
        start: [f64; N],
    ) -> Vec<Record> {
        let exact = self.values();
        let scale = exact.iter().fold(0.0_f64, |most, x| most.max(x.hi().abs()));
        let last: Option<&Dd> = exact.last();
        let place = Place {
            task: &self.task,
            case: &self.case,
            parts: self.at.len(),
        };
        let mut records = ladder(place, equation, start, &self.at, |states| {
            let found = states.last().zip(last);
            let error = found.map_or(1.0, |(state, exact)| (*exact - state[0]).hi().abs() / scale);
            Error {
                relative: error,
                scaled: error,
                digits: 50,
            }
        });
        for record in &mut records {
            record.parameter = self.parameter;
        }
        records
    }
}
