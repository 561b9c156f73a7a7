//! What shows late: windows after the span, in which functions are compared by their size.
//!
//! Light damping hardly shows over three periods, so that a motion without it is as near to the key as rounding allows.
//! Many periods later the damping shows, but there a frequency of three figures has lost the phase. So where a datum of
//! the key does not show on the span, the function is compared once more in a window after it, by its root mean square
//! under a Hann weight, which the phase does not change:
//!
//! ```text
//! size² = Σ w(s) x(s)² / Σ w(s),   w(s) = sin²(π s),   0 < s < 1 over the window.
//! ```
//!
//! Its tolerance is derived as that of the values is. A key in pieces is not compared beyond its span, where the
//! response need not hold.

use std::sync::OnceLock;

use super::SAMPLES;
use super::samples::{fine, samples};
use crate::answer::Tolerance;
use crate::expr::{Expr, Function, Kind, Name, Precise, Value};
use crate::numerics::sin;
use crate::quantity::{Evaluation, NodeId};

/// A datum shows where its own size moves the function by this many half-widths: an error of an eighth is seen.
const SHOWS: f64 = 8.0;
/// Windows that are tried; each lies twice as far after the span as the one before.
const MAX_DOUBLINGS: i32 = 12;
/// The times of the span are thinned out by this where it is looked whether a datum shows.
const STRIDE: usize = 4;
/// The relative step of the derivatives.
const STEP: f64 = 1e-6;

/// A window after the span.
#[derive(Clone, Debug)]
pub(crate) struct Window {
    pub(crate) times: Vec<Precise>,
    size: f64,
    half: f64,
}

/// A window before its tolerance is known.
struct Outline {
    times: Vec<Precise>,
    size: f64,
    /// The larger one of the sizes there and on the span.
    largest: f64,
    /// What its half-width is at least.
    least: f64,
}

/// What is known of a key when the windows are chosen.
pub(crate) struct OnSpan<'a> {
    pub(crate) evaluation: &'a Evaluation<'a>,
    pub(crate) key: NodeId,
    pub(crate) ends: [f64; 2],
    pub(crate) times: &'a [Precise],
    pub(crate) values: &'a [f64],
    pub(crate) halves: &'a [f64],
    /// The share by which rounding moves a value.
    pub(crate) share: f64,
    /// The tolerance that the item states, with the figures of the answer.
    pub(crate) stated: Option<(&'a Tolerance, u32)>,
}

impl Window {
    /// Whether a function with these values at its times has the size of the key there.
    pub(crate) fn admits(&self, values: &[f64]) -> bool {
        (size(values) - self.size).abs() <= self.half
    }
}

impl OnSpan<'_> {
    /// The windows in which those data of the key show that do not show on its span.
    pub(crate) fn windows(&self) -> Vec<Window> {
        let graph = self.evaluation.graph();
        let data = graph.parameters(self.key).into_iter();
        let mut hidden: Vec<NodeId> = data.filter(|datum| !self.shows(*datum)).collect();
        let mut windows = Vec::new();
        for doubling in 0..MAX_DOUBLINGS {
            if hidden.is_empty() {
                break;
            }
            let Some(outline) = self.outline(doubling) else {
                break;
            };
            let slopes: Vec<f64> = hidden
                .iter()
                .map(|datum| self.slope(*datum, &outline))
                .collect();
            let shows = |slope: &f64, half: f64| *slope >= SHOWS * half;
            // What rounding in the steps adds is computed where it may decide.
            if !slopes.iter().any(|slope| shows(slope, outline.least)) {
                continue;
            }
            let Some(window) = self.window(outline) else {
                break;
            };
            let count = hidden.len();
            let mut slopes = slopes.iter();
            hidden.retain(|_| !slopes.next().is_some_and(|slope| shows(slope, window.half)));
            if hidden.len() < count {
                windows.push(window);
            }
        }
        windows
    }

    /// Whether a datum shows on the span. Most do at any time, so that one is looked at before all others.
    fn shows(&self, datum: NodeId) -> bool {
        let Some(evaluation) = self.beside(datum) else {
            return true;
        };
        let places = (STRIDE / 2..self.times.len()).step_by(STRIDE);
        let places: Vec<usize> = places.collect();
        let (first, rest) = places.split_at(places.len().min(1));
        self.shows_at(&evaluation, first) || self.shows_at(&evaluation, rest)
    }

    /// Whether other values of the key differ from its own at one of these times, or are none.
    fn shows_at(&self, evaluation: &Evaluation<'_>, places: &[usize]) -> bool {
        let times: Vec<Precise> = places.iter().map(|place| self.times[*place]).collect();
        let Ok(moved) = samples(evaluation, self.key, &times, self.fine()) else {
            return true;
        };
        places.iter().zip(moved).any(|(place, moved)| {
            (moved - self.values[*place]).abs() / STEP >= SHOWS * self.halves[*place]
        })
    }

    /// The window that lies `2^doubling` spans after the span, but for what rounding in the steps does to it.
    fn outline(&self, doubling: i32) -> Option<Outline> {
        let [from, to] = self.ends;
        let start = to + (to - from) * (crate::numerics::powi(2.0, doubling) - 1.0);
        let times = super::span::times([start, start + to - from]);
        let own = size(&samples(self.evaluation, self.key, &times, self.fine()).ok()?);
        let largest = own.max(size(self.values));
        let stated = self
            .stated
            .map_or(self.share * largest, |(given, figures)| {
                given.half_width(largest, || 0.0, figures, self.evaluation)
            });
        // A factor that the span admits is admitted here, too.
        let shares = self.values.iter().zip(self.halves);
        let factor = shares
            .map(|(value, half)| half / value.abs())
            .fold(f64::INFINITY, f64::min);
        let least = stated.max(factor * own);
        let outline = Outline {
            times,
            size: own,
            largest,
            least,
        };
        least.is_finite().then_some(outline)
    }

    /// The window with its tolerance.
    fn window(&self, outline: Outline) -> Option<Window> {
        let mut half = outline.least;
        if self.stated.is_none() {
            let steps = self.evaluation.graph().steps(self.key).into_iter();
            let steps = steps.filter(|step| self.is_number(*step));
            let spread: f64 = steps.map(|step| self.slope(step, &outline)).sum();
            half = half.max(self.share * (outline.largest + spread));
        }
        half.is_finite().then_some(Window {
            times: outline.times,
            size: outline.size,
            half,
        })
    }

    /// How fast the size in a window grows with a datum or step, which grows by its own size; 0 where it cannot.
    fn slope(&self, node: NodeId, outline: &Outline) -> f64 {
        self.moved(node, &outline.times)
            .map_or(0.0, |moved| (size(&moved) - outline.size).abs() / STEP)
    }

    fn fine(&self) -> f64 {
        let sizes = self.values.iter().map(|value| value.abs());
        fine(sizes.fold(0.0, f64::max))
    }

    fn is_number(&self, step: NodeId) -> bool {
        self.evaluation.graph().variables(step).is_empty()
    }

    /// The values of the key where a datum or step is a little larger; `None` where it is zero or no number.
    fn moved(&self, node: NodeId, times: &[Precise]) -> Option<Vec<f64>> {
        samples(&self.beside(node)?, self.key, times, self.fine()).ok()
    }

    /// The data with a datum or step a little larger; `None` where it is zero or no number.
    fn beside(&self, node: NodeId) -> Option<Evaluation<'_>> {
        let given = self.evaluation.real(node).ok().filter(|own| *own != 0.0)?;
        let moved = Value::real(given * (1.0 + STEP), 0.0);
        Some(self.evaluation.replacing(vec![(node, moved)]))
    }
}

/// The weights of Hann at the times of a window.
fn weights() -> &'static [f64; SAMPLES] {
    static WEIGHTS: OnceLock<[f64; SAMPLES]> = OnceLock::new();
    let weight = |place: usize| {
        let share = (place as f64 + 0.5) / SAMPLES as f64;
        let root = sin(std::f64::consts::PI * share);
        root * root
    };
    WEIGHTS.get_or_init(|| std::array::from_fn(weight))
}

/// The root mean square of a function under a Hann weight.
fn size(values: &[f64]) -> f64 {
    let (mut sum, mut all) = (0.0, 0.0);
    for (weight, value) in weights().iter().zip(values) {
        sum += weight * value * value;
        all += weight;
    }
    (sum / all).sqrt()
}

/// Whether a function is another one in different pieces of its variable.
pub(crate) fn is_in_pieces(expr: &Expr, variable: &Name) -> bool {
    let mut found = false;
    let moves = |inner: &Expr| inner.reaches(|name| name == variable);
    expr.walk(&mut |node| {
        found |= match node.kind() {
            Kind::If(condition, ..) => moves(condition),
            Kind::Call(
                Function::Floor
                | Function::Ceil
                | Function::Round
                | Function::Mod
                | Function::Sign
                | Function::Abs
                | Function::Min
                | Function::Max,
                of,
            ) => of.iter().any(moves),
            _ => false,
        };
    });
    found
}
