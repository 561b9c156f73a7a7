//! What each task may cost, in units of the yardstick or of time, and what it costs.

use vibank::mechanics::Model;
use vibank::numerics::ExactNumber;
use vibank::vibration::modal::{Damping, ModalResponse};
use vibank::vibration::modes::{Link, Modes, Pair, System, natural_angular_frequencies};
use vibank::vibration::{
    DryFriction, ForcedResponse, FreeResponse, FrequencyResponse, FrictionOscillator,
    HarmonicForce, Oscillator, Pendulum, State,
};

use crate::linearisation;
use crate::measure::time;
use crate::modes::uniform_chain;

/// Arguments that differ from item to item.
const ARGUMENTS: usize = 4096;

/// The yardstick in nanoseconds on the processor for which limits are stated in microseconds.
const REFERENCE: f64 = 13.0;

/// A limit on the cost of a task.
#[derive(Clone, Copy)]
pub(crate) enum Limit {
    /// In yardsticks, with and without instructions for the fused multiply-add.
    Yards(f64, f64),
    /// In microseconds on a processor whose yardstick is [`REFERENCE`].
    Micros(f64),
}

/// A task and what it costs.
pub(crate) struct Cost {
    pub(crate) task: &'static str,
    limit: Limit,
    yards: f64,
}

impl Cost {
    /// The cost and its limit in yardsticks.
    pub(crate) fn against_limit(&self) -> (f64, f64) {
        let limit = match self.limit {
            Limit::Yards(with_fused, _) if cfg!(target_feature = "fma") => with_fused,
            Limit::Yards(_, without) => without,
            Limit::Micros(limit) => 1e3 * limit / REFERENCE,
        };
        (self.yards, limit)
    }
}

/// An argument between 0 and 1 for each item.
fn share(item: usize) -> f64 {
    (item % ARGUMENTS) as f64 / ARGUMENTS as f64
}

fn oscillator(damping: f64) -> Oscillator {
    Oscillator::new(1.3, damping, 2.1).expect("the oscillator is sound")
}

const START: State = State {
    position: 0.7,
    velocity: -0.4,
};

/// Measures all tasks that have a limit.
pub(crate) fn measure() -> Vec<Cost> {
    let mut costs = Vec::new();
    free(&mut costs);
    forced(&mut costs);
    friction(&mut costs);
    modes(&mut costs);
    pendulum(&mut costs);
    mechanics(&mut costs);
    costs
}

/// Adds a task.
fn add<T>(costs: &mut Vec<Cost>, task: &'static str, limit: Limit, item: impl FnMut(usize) -> T) {
    costs.push(Cost {
        task,
        limit,
        yards: time(item).yards,
    });
}

fn free(costs: &mut Vec<Cost>) {
    const SAMPLE: Limit = Limit::Yards(2.0, 3.5);
    let critical = 2.0 * (1.0_f64 * 4.0).sqrt();
    for (task, oscillator) in [
        ("free: position and velocity, underdamped", oscillator(0.3)),
        (
            "free: position and velocity, critical",
            Oscillator::new(1.0, critical, 4.0).expect("the oscillator is sound"),
        ),
        ("free: position and velocity, overdamped", oscillator(9.0)),
    ] {
        let motion = FreeResponse::of(&oscillator, START);
        add(costs, task, SAMPLE, |i| motion.state(30.0 * share(i)));
    }
    for (task, damping) in [
        ("free: set-up, underdamped", 0.3),
        ("free: set-up, overdamped", 9.0),
    ] {
        add(costs, task, Limit::Yards(3.0, 3.0), |i| {
            let oscillator = Oscillator::new(1.3 + share(i), damping, 2.1)?;
            Ok::<_, vibank::vibration::OscillatorError>(FreeResponse::of(&oscillator, START))
        });
    }
    let motion = FreeResponse::of(&oscillator(0.3), START);
    let mut positions = [0.0; 1000];
    let grid = time(|i| {
        motion.positions(share(i), 0.01, &mut positions);
        positions[999]
    });
    costs.push(Cost {
        task: "free: sample on a uniform grid of 1000",
        limit: Limit::Yards(0.3, 0.3),
        yards: grid.yards / 1000.0,
    });
}

fn forced(costs: &mut Vec<Cost>) {
    let damped = oscillator(0.3);
    add(costs, "steady amplitude", Limit::Yards(2.0, 2.0), |i| {
        FrequencyResponse::at(&damped, 0.3 + 2.0 * share(i)).amplitude(3.0)
    });
    add(
        costs,
        "steady amplitude and lag",
        Limit::Yards(2.0, 2.0),
        |i| {
            let response = FrequencyResponse::at(&damped, 0.3 + 2.0 * share(i));
            (response.amplitude(3.0), response.phase_lag())
        },
    );
    let natural = damped.natural_angular_frequency();
    for (task, damping, frequency, longest, limit) in [
        (
            "forced: position, undamped, near resonance",
            0.0,
            natural * 1.0001,
            100.0,
            6.0,
        ),
        (
            "forced: position, off resonance",
            0.3,
            3.0 * natural,
            100.0,
            4.0,
        ),
        (
            "forced: position, early, near resonance",
            1e-3,
            natural,
            50.0,
            6.0,
        ),
    ] {
        let force = HarmonicForce::cosine(3.0, frequency);
        let motion = ForcedResponse::of(&oscillator(damping), force, State::REST);
        add(costs, task, Limit::Yards(limit, limit), |i| {
            motion.position(0.1 + longest * share(i))
        });
    }
}

fn friction(costs: &mut Vec<Cost>) {
    const STOP: Limit = Limit::Yards(10.0, 10.0);
    let number = |text| ExactNumber::from_decimal(text).expect("it is a decimal");
    let starts: Vec<ExactNumber> = (0..ARGUMENTS)
        .filter_map(|i| ExactNumber::from_f64(0.5 + 10.0 * share(i)))
        .collect();
    let friction =
        DryFriction::of_weight(number("0.2"), number("0.2"), number("1.3"), number("9.81"));
    for (setup, stop, damping) in [
        ("friction: set-up", "friction: stop from rest", "0"),
        (
            "friction with damping: set-up",
            "friction with damping: stop from rest",
            "0.4",
        ),
    ] {
        let system =
            || FrictionOscillator::new(number("1.3"), number(damping), number("470"), friction);
        let (mass, resistance, stiffness) = (number("1.3"), number(damping), number("470"));
        add(costs, setup, STOP, |_| {
            FrictionOscillator::new(mass, resistance, stiffness, friction)
                .map(|system| system.stick_half_width())
        });
        let system = system().expect("the system is sound");
        add(costs, stop, STOP, |i| {
            let motion = system
                .motion(starts[i % ARGUMENTS], ExactNumber::ZERO)
                .ok()?;
            Some((motion.slides(), motion.rest_position(), motion.stop_time()))
        });
    }
}

fn modes(costs: &mut Vec<Cost>) {
    add(
        costs,
        "modes: two masses, frequencies",
        Limit::Yards(2.0, 2.0),
        |i| Pair::of_network([1.0, 2.0 + share(i)], [3.0, 0.7, 1.1]).natural_angular_frequencies(),
    );
    for (task, size, limit) in [
        ("modes: chain of 3, with shapes", 3, 1.0),
        ("modes: chain of 10, with shapes", 10, 30.0),
        ("modes: chain of 50, with shapes", 50, 1500.0),
        ("modes: chain of 200, with shapes", 200, 25_000.0),
    ] {
        let (masses, springs) = uniform_chain(size);
        add(costs, task, Limit::Micros(limit), |_| {
            Modes::of_network(&masses, &springs)
        });
    }
    let (masses, springs) = uniform_chain(200);
    let chain = System::of_network(&masses, &springs).expect("the chain is sound");
    add(
        costs,
        "modes: chain of 200, frequencies",
        Limit::Micros(3000.0),
        |_| natural_angular_frequencies(&chain),
    );
    for (task, size, limit) in [
        ("modes: dense network of 10, with shapes", 10, 30.0),
        ("modes: dense network of 50, with shapes", 50, 1500.0),
        ("modes: dense network of 200, with shapes", 200, 25_000.0),
    ] {
        let (masses, springs) = dense_network(size);
        add(costs, task, Limit::Micros(limit), |_| {
            Modes::of_network(&masses, &springs)
        });
    }
    let (masses, springs) = uniform_chain(10);
    let mut start = [0.0; 10];
    start[9] = 1.0;
    let mut displacements = [0.0; 2010];
    add(
        costs,
        "response of 10 masses, 201 samples",
        Limit::Micros(30.0),
        |_| {
            let modes = Modes::of_network(&masses, &springs)?;
            let motion = ModalResponse::of(&modes, &Damping::none(), &start, &[0.0; 10], 200.0)?;
            motion.grid(0.0, 0.625, &mut displacements)?;
            Ok::<_, vibank::vibration::modes::ModesError>(displacements[2009])
        },
    );
}

/// Every mass joined to the ground and to some twenty others, by springs of all magnitudes between 0.1 and 10 N/m.
fn dense_network(size: usize) -> (Vec<f64>, Vec<Link>) {
    let stiffness =
        |i: usize, j: usize| vibank::numerics::pow(10.0, share(i * 977 + j * 331) * 2.0 - 1.0);
    let masses = (1..=size).map(|i| 1.0 + share(i * 571)).collect();
    let links = (1..=size).flat_map(|i| {
        (0..i)
            .filter(move |j| *j == 0 || (i + j * 7) % (size / 20 + 1) == 0)
            .map(move |j| Link::between(j, i, stiffness(i, j)))
    });
    (masses, links.collect())
}

fn pendulum(costs: &mut Vec<Cost>) {
    let pendulum = Pendulum::new(1.0, 9.81).expect("the pendulum is sound");
    let period = Limit::Yards(1.0, 1.0);
    add(costs, "pendulum: period up to 1.5 rad", period, |i| {
        pendulum.period(0.01 + 1.5 * share(i))
    });
    add(costs, "pendulum: period up to 3.1 rad", period, |i| {
        pendulum.period(0.01 + 3.1 * share(i))
    });
    for (angle, state, velocity) in [
        (
            "pendulum: angle, swinging",
            "pendulum: angle and velocity, swinging",
            4.0,
        ),
        (
            "pendulum: angle, turning over",
            "pendulum: angle and velocity, turning over",
            9.0,
        ),
    ] {
        let motion = pendulum.motion(0.0, velocity).expect("the motion is sound");
        let sample = Limit::Yards(8.0, 8.0);
        add(costs, angle, sample, |i| motion.angle(30.0 * share(i)));
        add(costs, state, sample, |i| motion.state(30.0 * share(i)));
    }
}

fn mechanics(costs: &mut Vec<Cost>) {
    let cart = linearisation::cart();
    add(
        costs,
        "energies: equations of three coordinates",
        Limit::Micros(2000.0),
        |_| Model::derive(cart.clone()).is_ok(),
    );
    let model = linearisation::model();
    let hanging = linearisation::numbers(&model, 0.0);
    let at_rest = hanging.equilibrium().is_ok();
    assert!(at_rest, "the double pendulum has an equilibrium");
    add(
        costs,
        "energies: M, C, K of two coordinates",
        Limit::Micros(5.0),
        |_| hanging.linearization().is_ok(),
    );
    add(
        costs,
        "energies: the same from the data",
        Limit::Micros(20.0),
        |_| linearisation::numbers(&model, 0.0).linearization().is_ok(),
    );
}
