//! The system of an item in motion, as the solver says, for a page that can show it.

use std::rc::Rc;

use super::Scene;
use super::notation::Symbols;
use crate::expr::Expr;
use crate::figure::{Film, Head, ModelState, MovingFigure};
use crate::math::Math;
use crate::mechanics::{Motion, Numbers, Quantity, Unavailable};
use crate::message::Phrase;
use crate::unit::{Decimal, Dimension, Unit};

/// Pictures of the shortest period that is in a motion: enough for it to look continuous in slow motion.
const PER_PERIOD: f64 = 24.0;

/// Least and most pictures of a motion.
const PICTURES: (f64, f64) = (96.0, 720.0);

/// Periods of the slowest natural vibration that are shown, and periods of a mode or of the excitation.
const PERIODS: f64 = 5.0;
const LOOPS: f64 = 2.0;

/// Longest motion, in periods of the slowest natural vibration: beats of weak coupling take many of them.
const MAX_PERIODS: f64 = 60.0;

/// Most turning points that are listed.
const LISTED: usize = 16;

/// A motion that can be shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Run {
    /// From the initial state of the model.
    Start,
    /// When all that decays has decayed.
    Steady,
    /// A mode by its number from 0, without damping; of one coordinate its free vibration.
    Mode(usize),
}

/// A motion: its pictures, its coordinates in time, its turning points.
#[derive(Clone, Debug)]
pub struct Moving {
    /// The pictures.
    pub film: Film,
    /// How long it lasts, in seconds.
    pub seconds: f64,
    /// The symbols of the coordinates.
    pub symbols: Vec<Math>,
    /// For each coordinate its share of the largest one of its dimension, picture by picture.
    pub shares: Vec<Vec<f64>>,
    /// The turning points in order: the time in seconds, the coordinate, its value as it is printed.
    pub turns: Vec<(String, usize, Math)>,
}

/// The coordinates as functions of time, each with its value at rest, how long they are shown, and the shortest period.
struct CoordinateCourse {
    motions: Vec<(Motion, f64)>,
    seconds: f64,
    shortest: f64,
}

impl CoordinateCourse {
    /// The coordinates at a time, counted from rest.
    fn at(&self, time: f64) -> Option<Vec<f64>> {
        let motions = self.motions.iter();
        motions
            .map(|(motion, rest)| Some(motion.at(0, time).ok()? - rest))
            .collect()
    }
}

pub(crate) fn runs(scene: &Scene<'_, '_>) -> Vec<Run> {
    let figure = scene.solution.template().figure.as_ref();
    let Some(numbers) = figure.filter(|own| own.moves()).and_then(|_| system(scene)) else {
        return Vec::new();
    };
    let count = numbers.model().degrees_of_freedom();
    let runs = [Run::Start, Run::Steady].into_iter();
    let runs = runs.chain((0..count).map(Run::Mode));
    runs.filter(|run| course(*run, &numbers).is_some())
        .collect()
}

pub(crate) fn moving(scene: &Scene<'_, '_>, run: Run, id: &str) -> Option<Moving> {
    let figure = scene.solution.template().figure.as_ref()?;
    let numbers = system(scene)?;
    let course = course(run, &numbers)?;
    let seconds = course.seconds;
    let pictures = (PER_PERIOD * seconds / course.shortest).clamp(PICTURES.0, PICTURES.1);
    let pictures = pictures.round() as usize;
    let step = seconds / pictures as f64;
    let states: Option<Vec<ModelState>> = (0..=pictures)
        .map(|place| {
            let time = place as f64 * step;
            let coordinates = course.at(time)?;
            Some(ModelState { coordinates, time })
        })
        .collect();
    let states = states?;
    let head = Head {
        id,
        title: &scene.language.phrase(&Phrase::Moving),
        description: "",
    };
    let film = MovingFigure::of(figure, scene).ok()??.film(&states, &head);
    let coordinates = numbers.model().coordinate_dimensions();
    let symbols = coordinates.iter();
    let symbols =
        symbols.map(|(name, _)| Expr::name(name.clone()).typeset(&Symbols(scene.solution)));
    let largest = |dimension: Dimension| {
        let alike = coordinates.iter().enumerate();
        let alike = alike.filter(|(_, (_, own))| *own == dimension);
        let all =
            alike.flat_map(|(place, _)| states.iter().map(move |own| own.coordinates[place].abs()));
        all.fold(0.0_f64, f64::max)
    };
    let shares = coordinates
        .iter()
        .enumerate()
        .map(|(place, (_, dimension))| {
            let largest = largest(*dimension);
            let share = |own: &ModelState| {
                if largest > 0.0 {
                    own.coordinates[place] / largest
                } else {
                    0.0
                }
            };
            states.iter().map(share).collect()
        });
    let turns = turns(&states, step)
        .into_iter()
        .map(|(time, place, value)| {
            let dimension = coordinates[place].1;
            let value = match run {
                // A mode has no size.
                Run::Mode(_) => shown(value / largest(dimension), Dimension::PURE, scene),
                _ => shown(value, dimension, scene),
            };
            let time = Decimal::rounded(time, 3).unwrap_or(Decimal::ZERO);
            (time.to_string(), place, value)
        });
    Some(Moving {
        turns: turns.collect(),
        shares: shares.collect(),
        symbols: symbols.collect(),
        film,
        seconds,
    })
}

fn system(scene: &Scene<'_, '_>) -> Option<Rc<Numbers>> {
    scene.solution.evaluation().model("model")
}

/// A motion with what has to be known to show it; nothing where there is none.
fn course(run: Run, numbers: &Numbers) -> Option<CoordinateCourse> {
    let count = numbers.model().degrees_of_freedom();
    let modes = numbers.modes().ok()?;
    let natural: Vec<f64> = (0..count)
        .filter_map(|mode| modes.natural_angular_frequency(mode))
        .collect();
    let largest = highest(&natural);
    // The frequency of a rigid motion may be the root of a rounding, 1e-8 of the largest.
    let vibrates = |frequency: f64| frequency > 1e-6 * largest;
    let excitation = numbers.excitation_frequencies().unwrap_or_default();
    let motions = |motion: &dyn Fn(usize) -> Result<Motion, Unavailable>| {
        let rest = numbers.equilibrium().ok()?;
        let all = rest.iter().enumerate();
        all.map(|(place, rest)| Some((motion(place).ok()?, *rest)))
            .collect::<Option<Vec<_>>>()
    };
    match run {
        Run::Mode(mode) => {
            let frequency = modes.natural_angular_frequency(mode)?;
            let shortest = vibrates(frequency).then(|| period(frequency))?;
            Some(CoordinateCourse {
                motions: motions(&|place| Motion::of_mode(numbers, mode, place))?,
                seconds: LOOPS * shortest,
                shortest,
            })
        }
        Run::Steady if !excitation.is_empty() => Some(CoordinateCourse {
            motions: motions(&|place| numbers.motion_of(Quantity::SteadyMotion(place)))?,
            seconds: LOOPS * period(lowest(&excitation)),
            shortest: period(highest(&excitation)),
        }),
        Run::Start if numbers.model().has_start() => {
            let natural = natural.into_iter().filter(|own| vibrates(*own));
            let all: Vec<f64> = natural.chain(excitation).collect();
            (!all.is_empty()).then_some(())?;
            let slow = period(lowest(&all));
            // Two frequencies near each other beat.
            let mut seconds = PERIODS * slow;
            for (place, first) in all.iter().enumerate() {
                for second in &all[..place] {
                    let beat = period((first - second).abs());
                    if beat <= MAX_PERIODS * slow {
                        seconds = seconds.max(beat);
                    }
                }
            }
            Some(CoordinateCourse {
                motions: motions(&|place| numbers.motion_of(Quantity::Motion(place)))?,
                seconds,
                shortest: period(highest(&all)),
            })
        }
        Run::Start | Run::Steady => None,
    }
}

fn period(frequency: f64) -> f64 {
    std::f64::consts::TAU / frequency
}

fn lowest(all: &[f64]) -> f64 {
    all.iter().copied().fold(f64::INFINITY, f64::min)
}

fn highest(all: &[f64]) -> f64 {
    all.iter().copied().fold(0.0, f64::max)
}

/// The turning points of sampled coordinates, by the parabola through three samples: time, coordinate, value.
fn turns(states: &[ModelState], step: f64) -> Vec<(f64, usize, f64)> {
    let count = states.first().map_or(0, |own| own.coordinates.len());
    let mut turns = Vec::new();
    for (place, window) in states.windows(3).enumerate() {
        for coordinate in 0..count {
            let [a, b, c] = [0, 1, 2].map(|at: usize| window[at].coordinates[coordinate]);
            let is_top = a < b && b >= c;
            let is_bottom = a > b && b <= c;
            if is_top || is_bottom {
                let curvature = a - 2.0 * b + c;
                let shift = 0.5 * (a - c) / curvature;
                let value = b - 0.25 * (a - c) * shift;
                turns.push((((place + 1) as f64 + shift) * step, coordinate, value));
            }
        }
    }
    turns.truncate(LISTED);
    turns
}

fn shown(value: f64, dimension: Dimension, scene: &Scene<'_, '_>) -> Math {
    let number = Decimal::rounded(value, 3).unwrap_or(Decimal::ZERO);
    let unit = if dimension.is_pure() {
        Unit::ONE
    } else {
        Unit::parse(&dimension.describe()).unwrap_or(Unit::ONE)
    };
    crate::unit::Quantity::new(number, unit).math(scene.solution.mark())
}
