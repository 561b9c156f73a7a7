//! Dry friction: number of half-cycles, position and time of rest, path, against their number.

use differential_equations::prelude::*;
use vibank::numerics::{ExactNumber, exp};
use vibank::vibration::{DryFriction, FrictionOscillator};

use crate::integrate::{Place, ladder};
use crate::record::{Error, Record};
use crate::reference::Case;

/// One half-cycle after the other, as it stands in textbooks; for unit mass and stiffness.
fn textbook(slip: f64, start: f64, damping: f64) -> [f64; 4] {
    let half = std::f64::consts::PI / (1.0 - damping * damping / 4.0).sqrt();
    let decay = exp(-damping / 2.0 * half);
    let (mut position, mut slides, mut path) = (start, 0.0, 0.0);
    while position.abs() > slip {
        let next = -(decay * position - slip * (1.0 + decay) * position.signum());
        path += (position - next).abs();
        position = next;
        slides += 1.0;
    }
    [slides, position, slides * half, path]
}

fn ours([slip, start, damping]: [ExactNumber; 3]) -> [f64; 4] {
    let one = ExactNumber::from(1);
    let friction = DryFriction::of_forces(slip, slip);
    let motion = FrictionOscillator::new(one, damping, one, friction)
        .and_then(|system| system.motion(start, ExactNumber::ZERO))
        .expect("the motion is sound");
    [
        motion.slides().map_or(f64::NAN, |slides| slides as f64),
        motion.rest_position().unwrap_or(f64::NAN),
        motion.stop_time(),
        motion.path_length(),
    ]
}

/// The sign of the velocity in the right-hand side; after the true time of rest the mass trembles.
struct Equation {
    slip: f64,
    damping: f64,
}

impl ODE<f64, [f64; 2]> for Equation {
    fn diff(&self, _time: f64, state: &[f64; 2], rate: &mut [f64; 2]) {
        let friction = if state[1] == 0.0 {
            self.slip.min(state[0].abs()) * -state[0].signum()
        } else {
            self.slip * state[1].signum()
        };
        rate[0] = state[1];
        rate[1] = -state[0] - self.damping * state[1] - friction;
    }
}

/// From release to rest, set-up included.
pub(crate) fn from_release_to_rest(records: &mut Vec<Record>) {
    for case in Case::of("dry-friction") {
        let given = ["slip", "x0", "c"].map(|name| case.exact(name));
        let [slip, start, damping] = given.map(ExactNumber::to_f64);
        let (exact, before) = (case.values(), records.len());
        records.push(case.solution("vibank", || ours(given)));
        let loop_over = || textbook(slip, start, damping);
        records.push(case.solution("half-cycle by half-cycle", loop_over));
        if exact[0].hi() == 10.0 {
            let place = Place {
                task: &case.task,
                case: &case.case,
                parts: 1,
            };
            let equation = Equation { slip, damping };
            let times = [0.0, exact[2].hi()];
            // What is left at the time of rest, as a part of the slip.
            records.extend(ladder(place, &equation, [start, 0.0], &times, |states| {
                let error = (exact[1] - states[1][0]).hi().abs() / slip;
                Error {
                    relative: error / exact[1].hi().abs() * slip,
                    scaled: error,
                    digits: 50,
                }
            }));
        }
        // Positions are given in units of the slip.
        for record in &mut records[before..before + 2] {
            let [_, position, ..] = if record.is_ours() {
                ours(given)
            } else {
                loop_over()
            };
            record.error.scaled = (exact[1] - position).hi().abs() / slip;
        }
    }
}
