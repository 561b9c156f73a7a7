//! Time integrators at a ladder of tolerances.

use differential_equations::prelude::*;

use crate::measure::time;
use crate::record::Record;

/// The tolerances of the ladder.
pub(crate) const TOLERANCES: [f64; 6] = [1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13];

/// Most steps of one integration; a motion that needs more is left out.
const MAX_STEPS: usize = 200_000;

/// The time integrators that stand for all.
#[derive(Clone, Copy)]
pub(crate) enum Integrator {
    DormandPrince8,
    Verner9,
}

impl Integrator {
    pub(crate) const ALL: [Self; 2] = [Self::DormandPrince8, Self::Verner9];

    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::DormandPrince8 => "DOP853",
            Self::Verner9 => "Verner 9(8)",
        }
    }

    /// States at the given times, the first of which is the start; none if the integrator gives up.
    pub(crate) fn states<const N: usize>(
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

/// Measures all integrators at all tolerances. Errors are those that `error` finds in the states.
///
/// Between its steps DOP853 of this crate interpolates with a lower order than it integrates; errors are fair at the last time.
pub(crate) fn ladder<const N: usize>(
    records: &mut Vec<Record>,
    (task, case): (&'static str, &str),
    equation: &impl ODE<f64, [f64; N]>,
    start: [f64; N],
    times: &[f64],
    error: impl Fn(&[[f64; N]]) -> f64,
) {
    for integrator in Integrator::ALL {
        for tolerance in TOLERANCES {
            let Some(states) = integrator.states(equation, start, times, tolerance) else {
                continue;
            };
            let error = error(&states);
            records.push(Record {
                task,
                case: case.to_owned(),
                method: integrator.name(),
                tolerance: Some(tolerance),
                timing: time(|_| integrator.states(equation, start, times, tolerance)),
                relative_error: error,
                scaled_error: error,
            });
        }
    }
}
