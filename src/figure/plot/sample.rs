//! Curves as few cubic pieces: a function is asked where it bends.
//!
//! A curve is first asked at evenly spaced places, which gives its extent. Then each piece between two
//! places is compared with the cubic that has the same ends and directions, and halved until the two are
//! closer than the line's width lets anybody see. Last, neighbouring pieces that one cubic serves as
//! well are joined. Where the function has no value, or jumps, the curve is interrupted.

/// A curve: the point at each value of its variable, where there is one.
pub(crate) type SampledFunction<'a> = dyn Fn(f64) -> Option<[f64; 2]> + 'a;

/// A point of a curve with its direction, the derivative by the variable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Knot {
    pub(crate) variable: f64,
    pub(crate) at: [f64; 2],
    pub(crate) direction: [f64; 2],
}

/// A piece of a curve without interruption; between neighbours it is the cubic that they determine.
pub(crate) type CurveRun = Vec<Knot>;

/// A curve at evenly spaced places.
pub(crate) struct Coarse<'a> {
    path: &'a SampledFunction<'a>,
    range: [f64; 2],
    places: Vec<SampledPoint>,
}

/// A value of the variable, and the point of the curve there, if it has one.
#[derive(Clone, Copy)]
struct SampledPoint {
    variable: f64,
    knot: Option<Knot>,
}

/// Pieces into which the range is cut at first.
const PIECES: usize = 24;
/// How often a piece is halved at most.
const MAX_DEPTH: u32 = 9;
/// No curve is asked more often.
const MAX_CALLS: u32 = 20_000;
/// Step of the differences that give directions, as a share of the range.
// Rounding leaves ten digits of a direction; print shows three.
const STEP: f64 = 1e-6;
/// No joined piece spans more of the pieces that were found.
const MAX_JOIN_LENGTH: usize = 16;
/// Distance, in print, from which two neighbouring points are the edges of a jump.
const JUMP: f64 = 1.0;

impl<'a> Coarse<'a> {
    /// The curve over a range of its variable.
    pub(crate) fn of(path: &'a SampledFunction<'a>, range: [f64; 2]) -> Self {
        let mut coarse = Self {
            path,
            range,
            places: Vec::with_capacity(PIECES + 1),
        };
        for piece in 0..=PIECES {
            let share = piece as f64 / PIECES as f64;
            let variable = range[0] + (range[1] - range[0]) * share;
            coarse.places.push(coarse.place(variable));
        }
        coarse
    }

    /// The least and greatest coordinates so far; `None` if there is no point.
    pub(crate) fn extent(&self) -> Option<[[f64; 2]; 2]> {
        extent(self.places.iter().filter_map(|place| place.knot.as_ref()))
    }

    /// The curve to an error of at most `error` in print, where a unit of each axis measures `size`.
    pub(crate) fn refine(&self, size: [f64; 2], error: f64) -> Vec<CurveRun> {
        // Pieces and their joining have half of it each.
        let error = error / 2.0;
        let mut refined = Refined {
            coarse: self,
            size,
            error,
            calls: 0,
            runs: vec![self.places[0].knot.into_iter().collect()],
        };
        for pair in self.places.windows(2) {
            refined.piece(pair[0], pair[1], MAX_DEPTH);
        }
        let runs = refined.runs.into_iter().filter(|run| run.len() > 1);
        runs.map(|run| joined(&run, size, error)).collect()
    }

    fn at(&self, variable: f64) -> Option<[f64; 2]> {
        (self.path)(variable).filter(|point| point.iter().all(|number| number.is_finite()))
    }

    fn place(&self, variable: f64) -> SampledPoint {
        SampledPoint {
            variable,
            knot: self.knot(variable),
        }
    }

    fn knot(&self, variable: f64) -> Option<Knot> {
        let at = self.at(variable)?;
        let step = (self.range[1] - self.range[0]) * STEP;
        let difference = |step: f64| {
            let other = self.at(variable + step)?;
            Some([(other[0] - at[0]) / step, (other[1] - at[1]) / step])
        };
        // Beyond the range the function may have no value.
        let is_inside = variable + step <= self.range[1];
        let direction = is_inside.then(|| difference(step)).flatten();
        Some(Knot {
            variable,
            at,
            direction: direction.or_else(|| difference(-step)).unwrap_or_default(),
        })
    }
}

/// A curve on its way to the wanted accuracy.
struct Refined<'c, 'a> {
    coarse: &'c Coarse<'a>,
    size: [f64; 2],
    error: f64,
    calls: u32,
    runs: Vec<CurveRun>,
}

impl Refined<'_, '_> {
    /// Appends what lies between two places; the first of them stands already.
    fn piece(&mut self, from: SampledPoint, to: SampledPoint, halvings: u32) {
        match (from.knot, to.knot) {
            (Some(from), Some(to)) => self.between(from, to, halvings),
            (Some(from), None) => {
                if let Some(edge) = self.edge(&from, to.variable) {
                    self.between(from, edge, halvings.saturating_sub(1));
                }
            }
            (None, Some(to)) => {
                let edge = self.edge(&to, from.variable);
                self.runs.push(vec![edge.unwrap_or(to)]);
                if let Some(edge) = edge {
                    self.between(edge, to, halvings.saturating_sub(1));
                }
            }
            (None, None) => {}
        }
    }

    /// The last place that has a point on the way from a knot to where there is none.
    fn edge(&mut self, from: &Knot, outside: f64) -> Option<Knot> {
        // A millionth of the way from knot to knot is finer than any printer prints.
        const HALVINGS: u32 = 20;
        let (mut inside, mut outside) = (from.variable, outside);
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(inside, outside);
            if self.coarse.at(middle).is_some() {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        // Counted like the rest: a function that comes and goes often asks for many edges.
        self.calls += HALVINGS;
        let knot = self.coarse.knot(inside)?;
        (knot.variable != from.variable).then_some(knot)
    }

    fn between(&mut self, from: Knot, to: Knot, halvings: u32) {
        self.calls += 3;
        let middle = f64::midpoint(from.variable, to.variable);
        let point = self.coarse.at(middle);
        let fits = point
            .is_some_and(|point| self.fits(&from, &to, 0.5, point) && self.fits_beside(&from, &to));
        if fits {
            self.push(to);
        } else if halvings == 0 || self.calls > MAX_CALLS {
            self.end(&from, to);
        } else {
            let ends = [from, to].map(|knot| SampledPoint {
                variable: knot.variable,
                knot: Some(knot),
            });
            let middle = self.coarse.place(middle);
            self.piece(ends[0], middle, halvings - 1);
            self.piece(middle, ends[1], halvings - 1);
        }
    }

    /// A second place, so that what repeats itself is not missed.
    fn fits_beside(&self, from: &Knot, to: &Knot) -> bool {
        // Far from simple fractions, at which a periodic curve may meet the cubic again.
        const SHARE: f64 = 0.229;
        let variable = from.variable + (to.variable - from.variable) * SHARE;
        let point = self.coarse.at(variable);
        point.is_some_and(|point| self.fits(from, to, SHARE, point))
    }

    fn fits(&self, from: &Knot, to: &Knot, share: f64, point: [f64; 2]) -> bool {
        distance(from, to, share, point, self.size) <= self.error
    }

    /// A piece that is as short as they get: straight, or the edges of a jump.
    fn end(&mut self, from: &Knot, to: Knot) {
        let apart = [0, 1].map(|axis| ((to.at[axis] - from.at[axis]) * self.size[axis]).abs());
        if apart.iter().any(|distance| *distance > JUMP) {
            self.runs.push(vec![to]);
        } else {
            self.push(to);
        }
    }

    fn push(&mut self, knot: Knot) {
        if let Some(run) = self.runs.last_mut() {
            run.push(knot);
        }
    }
}

/// The least and greatest coordinates of points.
pub(crate) fn extent<'k>(knots: impl Iterator<Item = &'k Knot>) -> Option<[[f64; 2]; 2]> {
    knots.fold(None, |extent, knot| {
        let [low, high] = extent.unwrap_or([knot.at, knot.at]);
        Some([
            [low[0].min(knot.at[0]), low[1].min(knot.at[1])],
            [high[0].max(knot.at[0]), high[1].max(knot.at[1])],
        ])
    })
}

/// Joins neighbouring pieces that one cubic serves as well.
fn joined(run: &[Knot], size: [f64; 2], error: f64) -> CurveRun {
    let mut joined = vec![run[0]];
    let mut start = 0;
    while start + 1 < run.len() {
        let mut end = start + 1;
        while end + 1 < run.len()
            && end + 1 - start <= MAX_JOIN_LENGTH
            && serves(&run[start..=end + 1], size, error)
        {
            end += 1;
        }
        joined.push(run[end]);
        start = end;
    }
    joined
}

/// Whether the cubic between the ends of some knots passes close to all that lies between.
fn serves(knots: &[Knot], size: [f64; 2], error: f64) -> bool {
    let (from, to) = (&knots[0], &knots[knots.len() - 1]);
    let share = |variable: f64| (variable - from.variable) / (to.variable - from.variable);
    let is_near =
        |variable: f64, point: [f64; 2]| distance(from, to, share(variable), point, size) <= error;
    knots.windows(2).all(|pair| {
        let middle = f64::midpoint(pair[0].variable, pair[1].variable);
        is_near(middle, cubic(&pair[0], &pair[1], 0.5).0) && is_near(pair[1].variable, pair[1].at)
    })
}

/// The distance in print of a point from the cubic between two knots: across the cubic's direction, and
/// a little along it, so that a jump is none of its steep places.
fn distance(from: &Knot, to: &Knot, share: f64, point: [f64; 2], size: [f64; 2]) -> f64 {
    // At 0.04 mm of error a point may lie 2 mm off along the curve, where it is not seen; a jump is more.
    const ALONG: f64 = 0.02;
    let (at, along) = cubic(from, to, share);
    let off = [(point[0] - at[0]) * size[0], (point[1] - at[1]) * size[1]];
    let along = [along[0] * size[0], along[1] * size[1]];
    let length = crate::numerics::hypot(along[0], along[1]);
    let far = crate::numerics::hypot(off[0], off[1]);
    if length > 0.0 {
        let across = (off[0] * along[1] - off[1] * along[0]).abs() / length;
        across.max(ALONG * far)
    } else {
        far
    }
}

/// Point and direction of the cubic between two knots, at a share of the way.
pub(crate) fn cubic(from: &Knot, to: &Knot, share: f64) -> ([f64; 2], [f64; 2]) {
    let length = to.variable - from.variable;
    let (s, r) = (share, 1.0 - share);
    let point = |axis: usize| {
        r * r * (1.0 + 2.0 * s) * from.at[axis]
            + s * s * (3.0 - 2.0 * s) * to.at[axis]
            + length * s * r * (r * from.direction[axis] - s * to.direction[axis])
    };
    let direction = |axis: usize| {
        6.0 * s * r * (to.at[axis] - from.at[axis]) / length
            + r * (1.0 - 3.0 * s) * from.direction[axis]
            + s * (1.0 - 3.0 * r) * to.direction[axis]
    };
    ([point(0), point(1)], [direction(0), direction(1)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::{exp, sin};

    /// The largest error in print of a sampled graph, and how many knots it has.
    fn error(function: impl Fn(f64) -> f64, range: [f64; 2], size: [f64; 2]) -> (f64, usize) {
        let path = |x: f64| Some([x, function(x)]);
        let runs = Coarse::of(&path, range).refine(size, 0.04);
        let mut worst = 0.0_f64;
        for pair in runs.iter().flat_map(|run| run.windows(2)) {
            for part in 0..=32 {
                let (at, _) = cubic(&pair[0], &pair[1], f64::from(part) / 32.0);
                let slope = (function(at[0] + 1e-6) - function(at[0])) / 1e-6 * size[1] / size[0];
                let off = (function(at[0]) - at[1]) * size[1];
                worst = worst.max(off.abs() / crate::numerics::hypot(1.0, slope));
            }
        }
        (worst, runs.iter().map(Vec::len).sum())
    }

    #[test]
    fn smooth_curves_take_few_cubics_within_a_stroke() {
        let decay = |t: f64| exp(-0.3 * t) * sin(6.0 * t);
        let (off, knots) = error(decay, [0.0, 5.0], [20.0, 25.0]);
        assert!(off < 0.045, "{off} mm");
        assert!(knots < 40, "{knots} knots");
    }

    #[test]
    fn a_straight_line_is_one_piece_or_two() {
        let (off, knots) = error(|x| 2.0 - 3.0 * x, [0.0, 1.0], [100.0, 10.0]);
        assert!(off < 1e-6 && knots <= 3, "{off} {knots}");
    }

    #[test]
    fn a_narrow_resonance_is_not_missed() {
        let peak = |r: f64| 1.0 / ((1.0 - r * r) * (1.0 - r * r) + 1e-4 * r * r).sqrt();
        let path = |x: f64| Some([x, peak(x)]);
        let runs = Coarse::of(&path, [0.0, 3.0]).refine([33.0, 0.5], 0.04);
        let [_, high] = extent(runs.iter().flatten()).unwrap();
        assert!(high[1] > 99.0, "{high:?}");
    }

    #[test]
    fn many_cycles_that_match_the_first_pieces_are_seen() {
        let fast = |t: f64| sin(2.0 * std::f64::consts::PI * PIECES as f64 * t);
        let path = |x: f64| Some([x, fast(x)]);
        let runs = Coarse::of(&path, [0.0, 1.0]).refine([100.0, 25.0], 0.04);
        let [low, high] = extent(runs.iter().flatten()).unwrap();
        assert!(low[1] < -0.99 && high[1] > 0.99);
    }

    #[test]
    fn a_pole_and_a_hole_interrupt_the_curve() {
        let pole = |x: f64| Some([x, (1.0 / (x - 0.512)).clamp(-20.0, 20.0)]);
        let runs = Coarse::of(&pole, [0.0, 1.0]).refine([100.0, 1.5], 0.04);
        assert_eq!(runs.len(), 2);
        let root = |x: f64| (x * x > 0.1).then(|| [x, (x * x - 0.1).sqrt()]);
        let runs = Coarse::of(&root, [-1.0, 1.0]).refine([50.0, 50.0], 0.04);
        assert_eq!(runs.len(), 2);
        let gap = runs[1][0].at[0] - runs[0].last().unwrap().at[0];
        assert!((gap - 2.0 * 0.1_f64.sqrt()).abs() < 1e-4, "{gap}");
    }
}
