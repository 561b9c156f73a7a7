//! Integrals over any kind of number.

use super::machine::Stop;
use super::search::SearchedFunction;
use crate::expr::{Doubt, Function, Precise, Scalar, Undefined};
use vibank_dynamics::numerics::Dd;

/// The finest rule has steps of two to minus this.
const FINEST: u32 = 7;
/// Most pieces into which an interval is cut.
const MAX_PIECES: usize = 400;
/// Beyond this place of the rule its nodes are the ends.
// There 1 - tanh u is 2 exp(-π sinh 6.5) = 1e-453, less than the smallest number of binary64.
const LAST_PLACE: f64 = 6.5;

/// The integral of a function over an interval.
///
/// The substitution x = tanh(π/2 sinh t) makes the trapezoidal rule converge with a number of digits that doubles with
/// the number of nodes, also where the function is singular at an end. Where it does not settle (kinks, jumps) the
/// interval is halved. The bound adds the difference of the last two rules to the bounds of the values.
///
/// # References
///
/// H. Takahasi, M. Mori, Publ. RIMS Kyoto Univ. 9 (1974) 721.
pub(crate) fn integral<S: Scalar>(curve: &mut impl SearchedFunction<S>) -> Result<S, Stop> {
    let [low, high] = curve.ends();
    let mut total = S::exact(0.0);
    let mut scale = 0.0_f64;
    let mut open = vec![(low, high)];
    let mut pieces = 0;
    while let Some((low, high)) = open.pop() {
        let rule = settled(curve, &low, &high, scale)?;
        // Errors count beside the whole integral: a piece on which the function is nearly zero need not
        // settle by itself.
        scale = scale.max(rule.magnitude);
        pieces += 1;
        if rule.error <= tolerance::<S>(scale) {
            total = total.add(&rule.value.widened(rule.error));
            continue;
        }
        if pieces > MAX_PIECES {
            return Err(Stop::Here(Undefined::NoConvergence));
        }
        let middle = low.add(&high).multiply(&S::exact(0.5)).centre();
        open.push((middle.clone(), high));
        open.push((low, middle));
    }
    Ok(total)
}

/// What an integral of this size may be off by.
fn tolerance<S: Scalar>(scale: f64) -> f64 {
    20.0 * S::ROUNDOFF * scale
}

/// The trapezoidal rule at the points so far.
struct TrapezoidalSum<S> {
    value: S,
    /// The integral of the size of the function.
    magnitude: f64,
    /// The difference to the rule before.
    error: f64,
}

/// The rule that is refined until it settles, or the finest one.
fn settled<S: Scalar>(
    curve: &mut impl SearchedFunction<S>,
    low: &S,
    high: &S,
    scale: f64,
) -> Result<TrapezoidalSum<S>, Stop> {
    let half = high.subtract(low).multiply(&S::exact(0.5));
    let mut nodes = Nodes::new(curve, low, high, &half)?;
    let mut rule = nodes.rule(curve, 0, &S::exact(0.0))?;
    for level in 1..=FINEST {
        rule = nodes.rule(curve, level, &rule.value)?;
        // The first rules have a handful of nodes, and may agree by accident.
        if level > 2 && rule.error <= tolerance::<S>(scale.max(rule.magnitude)) {
            break;
        }
    }
    Ok(rule)
}

/// The sum over the nodes so far.
struct Nodes<'a, S> {
    low: &'a S,
    high: &'a S,
    half: &'a S,
    quarter_turn: S,
    sum: S,
    magnitude: f64,
}

impl<'a, S: Scalar> Nodes<'a, S> {
    /// The node in the middle.
    fn new(
        curve: &mut impl SearchedFunction<S>,
        low: &'a S,
        high: &'a S,
        half: &'a S,
    ) -> Result<Self, Stop> {
        let quarter_turn = S::of(&Precise::of_dd(Dd::FRAC_PI_2, 1e-33));
        let sum = curve.value(&low.add(half))?.multiply(&quarter_turn);
        let magnitude = sum.to_f64().abs();
        Ok(Self {
            low,
            high,
            half,
            quarter_turn,
            sum,
            magnitude,
        })
    }

    /// The rule with steps of two to minus `level`, after the one before it.
    fn rule(
        &mut self,
        curve: &mut impl SearchedFunction<S>,
        level: u32,
        before: &S,
    ) -> Result<TrapezoidalSum<S>, Stop> {
        let step = 1.0 / f64::from(1_u32 << level);
        // The nodes of the rule before are every second one of this.
        let stride = if level == 0 { step } else { 2.0 * step };
        self.side(curve, step, stride, true)?;
        self.side(curve, step, stride, false)?;
        let width = self.half.multiply(&S::exact(step));
        let value = self.sum.multiply(&width);
        let error = value.subtract(before).to_f64().abs();
        Ok(TrapezoidalSum {
            value,
            magnitude: self.magnitude * width.to_f64().abs(),
            error,
        })
    }

    /// Adds the nodes on one side of the middle, until they no longer matter.
    fn side(
        &mut self,
        curve: &mut impl SearchedFunction<S>,
        first: f64,
        stride: f64,
        is_low: bool,
    ) -> Result<(), Stop> {
        let mut place = first;
        while place < LAST_PLACE {
            let (offset, weight) = self.node(place)?;
            let from_end = self.half.multiply(&offset);
            let x = if is_low {
                self.low.add(&from_end)
            } else {
                self.high.subtract(&from_end)
            };
            let end = if is_low { self.low } else { self.high };
            // A node that rounds to the end itself, where the function may be singular.
            if x.subtract(end).to_f64() == 0.0 {
                break;
            }
            let term = curve.value(&x)?.multiply(&weight);
            let size = term.to_f64().abs();
            self.sum = self.sum.add(&term);
            self.magnitude += size;
            // A term may be small because the function vanishes there; where the weight is small, the rest is
            // as well.
            if weight.to_f64() < 1e-3 && size <= 1e-2 * S::ROUNDOFF * self.magnitude {
                break;
            }
            place += stride;
        }
        Ok(())
    }

    /// Distance of the node from the end, 1 − tanh u with u = π/2 sinh t, and its weight, the derivative by t.
    fn node(&self, place: f64) -> Result<(S, S), Undefined> {
        let t = S::exact(place);
        let doubt = &mut Doubt::default();
        let u = self.quarter_turn.multiply(&t.unary(Function::Sinh, doubt)?);
        let decay = u.multiply(&S::exact(-2.0)).unary(Function::Exp, doubt)?;
        let whole = decay.add(&S::exact(1.0));
        let offset = decay.multiply(&S::exact(2.0)).divide(&whole)?;
        let rate = self.quarter_turn.multiply(&t.unary(Function::Cosh, doubt)?);
        let weight = rate
            .multiply(&offset)
            .multiply(&S::exact(2.0))
            .divide(&whole)?;
        Ok((offset, weight))
    }
}
