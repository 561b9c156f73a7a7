//! How the turning points shrink.
//!
//! Let U be the distance of a turning point from the equilibrium, counted on the side where the mass turns. The next one
//! is on the other side, at `q U - a (1 + q)`, with the slip a and `q = e^-theta`. A negative distance means that the
//! mass stops before it reaches the equilibrium, on the side it came from.

use crate::numerics::{Dd, ln_1p};

/// The rule from one turning point to the next.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Decay {
    slip: Dd,
    /// None without viscous damping.
    viscous: Option<Viscous>,
}

#[derive(Clone, Copy, Debug)]
struct Viscous {
    theta: Dd,
    /// `1 - q`.
    lost: Dd,
}

/// Below this decay in a half-cycle, damping changes no digit within any number of half-cycles that is allowed.
const NEGLIGIBLE: f64 = 1e-200;

impl Decay {
    /// The rule for a slip and a decay `theta` in a half-cycle.
    pub(crate) fn new(slip: Dd, theta: Dd) -> Self {
        let viscous = (theta.hi() > NEGLIGIBLE).then(|| Viscous {
            theta,
            lost: -(-theta).expm1(),
        });
        Self { slip, viscous }
    }

    pub(crate) fn is_viscous(&self) -> bool {
        self.viscous.is_some()
    }

    /// The decay in a half-cycle, 0 without viscous damping.
    pub(crate) fn theta(&self) -> f64 {
        self.viscous.map_or(0.0, |viscous| viscous.theta.hi())
    }

    /// How many half-cycles bring the distance `reach` down to `hold`, as a real number; off by less than a quarter
    /// up to 1e14.
    ///
    /// ```text
    /// (U - h)/(2 a)   or   ln(1 + (U - h)/(h + b))/theta,   b = a/tanh(theta/2) = a (1 + q)/(1 - q)
    /// ```
    pub(crate) fn steps_until(&self, reach: Dd, hold: Dd) -> f64 {
        let surplus = (reach - hold).hi();
        match self.viscous {
            None => surplus / (2.0 * self.slip.hi()),
            Some(viscous) => {
                let lost = viscous.lost.hi();
                let bound = hold.hi() * lost + self.slip.hi() * (2.0 - lost);
                ln_1p(surplus * lost / bound) / viscous.theta.hi()
            }
        }
    }

    /// The distance after a number of half-cycles.
    ///
    /// ```text
    /// U - 2 a j   or   U - (U (1 - q) + a (1 + q)) (1 - q^j)/(1 - q)
    /// ```
    pub(crate) fn after(&self, reach: Dd, steps: f64) -> Dd {
        match self.viscous {
            None => reach - self.slip * (2.0 * steps),
            Some(viscous) => {
                let lost = -(-viscous.theta * steps).expm1();
                reach - self.loss(viscous, reach) * (lost / viscous.lost)
            }
        }
    }

    /// The distance after one half-cycle more.
    pub(crate) fn next(&self, reach: Dd) -> Dd {
        match self.viscous {
            None => reach - self.slip * 2.0,
            Some(viscous) => reach - self.loss(viscous, reach),
        }
    }

    /// By how much the distance shrinks in a half-cycle, `U (1 - q) + a (1 + q)`.
    fn loss(&self, viscous: Viscous, reach: Dd) -> Dd {
        reach * viscous.lost + self.slip * (2.0 - viscous.lost)
    }

    /// The length of a number of half-cycles, `sum (U_j + U_(j+1))`, from the first distance and the last.
    pub(crate) fn path(&self, reach: Dd, steps: f64, last: Dd) -> Dd {
        match self.viscous {
            None => (reach + last) * steps,
            Some(viscous) => {
                let (first_sum, second_sum) = viscous.sums(steps);
                let sum = reach * first_sum - self.slip * (2.0 - viscous.lost) * second_sum;
                sum * 2.0 - reach + last
            }
        }
    }

    /// The length of all half-cycles if they never end.
    pub(crate) fn endless_path(&self, reach: Dd) -> Dd {
        match self.viscous {
            None => Dd::from(f64::INFINITY),
            Some(viscous) => reach * (2.0 - viscous.lost) / viscous.lost,
        }
    }
}

impl Viscous {
    /// `sum q^j` and `sum (1 - q^j)/(1 - q)` for j from 0 to n - 1.
    ///
    /// The second is `(n - first)/(1 - q)`, whose difference keeps enough digits unless hardly anything decays; then its
    /// expansion `n (n-1)/2 - theta n (n-1) (n-2)/6` is exact.
    fn sums(&self, n: f64) -> (Dd, Dd) {
        // Above this the difference keeps 18 digits of 31; below it the next term of the expansion is less than
        // 1e-26 of the sum.
        const HARDLY: f64 = 1e-13;
        let decay = self.theta * n;
        let first = -(-decay).expm1() / self.lost;
        let second = if decay.hi() < HARDLY {
            let pairs = Dd::product(n, n - 1.0) * 0.5;
            pairs - pairs * self.theta * (n - 2.0) / 3.0
        } else {
            (n - first) / self.lost
        };
        (first, second)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rule, step by step.
    fn step_by_step(slip: Dd, theta: Dd, mut reach: Dd, steps: u32) -> (Dd, Dd) {
        let q = (-theta).exp();
        let mut path = Dd::ZERO;
        for _ in 0..steps {
            let next = q * reach - slip * (q + 1.0);
            path += reach + next;
            reach = next;
        }
        (reach, path)
    }

    #[test]
    fn closed_forms_repeat_the_steps() {
        let (slip, reach) = (Dd::from(0.01), Dd::from(50.0));
        for theta in [0.0, 1e-300, 1e-40, 1e-17, 1e-14, 1e-9, 1e-4, 0.3, 5.0] {
            let decay = Decay::new(slip, Dd::from(theta));
            for steps in [0, 1, 2, 3, 10, 200] {
                let (expected, expected_path) = step_by_step(slip, Dd::from(theta), reach, steps);
                let steps = f64::from(steps);
                assert!(
                    (decay.after(reach, steps) - expected).hi().abs() < 1e-27,
                    "{theta} {steps}"
                );
                let path = decay.path(reach, steps, decay.after(reach, steps));
                let error = (path - expected_path).hi().abs();
                assert!(
                    error <= 1e-14 * expected_path.hi().abs(),
                    "{theta} {steps} {error:e}"
                );
            }
        }
    }

    #[test]
    fn steps_invert_the_decay() {
        let (slip, reach) = (Dd::from(0.01), Dd::from(50.0));
        for theta in [0.0, 1e-40, 1e-9, 1e-3, 0.3] {
            let decay = Decay::new(slip, Dd::from(theta));
            let hold = decay.after(reach, 7.0);
            assert!(
                (decay.steps_until(reach, hold) - 7.0).abs() < 1e-13,
                "{theta}"
            );
        }
    }
}
