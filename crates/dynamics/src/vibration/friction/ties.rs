//! Ties, decided on the numbers as they were given.

use std::cmp::Ordering;

use super::{Factors, StatedNumbers};
use crate::numerics::{ExactNumber, sign_of_sum};

impl StatedNumbers {
    /// Whether friction holds the mass at a position: `|k x - F| <= F_s`.
    pub(crate) fn holds_at(&self, position: ExactNumber) -> bool {
        self.rests_from_rest(position, 0)
    }

    /// On which side of the equilibrium a position lies, by the sign of `k x - F`.
    pub(crate) fn side_of(&self, position: ExactNumber) -> Ordering {
        sign_of_sum(&[&[self.stiffness, position], &[-self.force]])
    }

    /// Whether a mass released at rest rests after n half-cycles: `|k x0 - F| <= F_s + 2 n F_k`. Undamped.
    pub(crate) fn rests_from_rest(&self, position: ExactNumber, slides: u64) -> bool {
        let side = match self.side_of(position) {
            Ordering::Less => -ExactNumber::from(1),
            _ => ExactNumber::from(1),
        };
        let [mu, mass, gravity] = negated(self.friction.kinetic);
        let lost = [ExactNumber::from(2 * slides), mu, mass, gravity];
        let reach = [&[side, self.stiffness, position][..], &[-side, self.force]];
        sign_of_sum(&[reach[0], reach[1], &negated(self.friction.fixed), &lost]).is_le()
    }

    /// Whether a mass thrown in a direction rests n half-cycles after its first turning point. Undamped.
    ///
    /// ```text
    /// (k x0 - F + s F_k)^2 + k m v0^2 <= (F_s + (2 n + 1) F_k)^2
    /// ```
    pub(crate) fn rests_from_throw(
        &self,
        position: ExactNumber,
        velocity: ExactNumber,
        slides: u64,
    ) -> bool {
        let one = ExactNumber::from(1);
        let direction = if velocity.signum() < 0 { -one } else { one };
        let towards = Sum(vec![
            vec![self.stiffness, position],
            vec![-self.force],
            with(self.friction.kinetic, direction),
        ]);
        let bound = Sum(vec![
            self.friction.fixed.to_vec(),
            with(self.friction.kinetic, ExactNumber::from(2 * slides + 1)),
        ]);
        let kinetic = vec![self.stiffness, self.mass, velocity, velocity];
        let mut terms = towards.squared(one);
        terms.push(kinetic);
        terms.extend(bound.squared(-one));
        let terms: Vec<&[ExactNumber]> = terms.iter().map(Vec::as_slice).collect();
        sign_of_sum(&terms).is_le()
    }
}

/// A sum of products.
struct Sum(Vec<Vec<ExactNumber>>);

impl Sum {
    /// The products of its square, each times a factor.
    fn squared(&self, factor: ExactNumber) -> Vec<Vec<ExactNumber>> {
        self.0
            .iter()
            .flat_map(|left| self.0.iter().map(move |right| (left, right)))
            .map(|(left, right)| [&[factor], left.as_slice(), right].concat())
            .collect()
    }
}

fn with(factors: Factors, more: ExactNumber) -> Vec<ExactNumber> {
    [&factors[..], &[more]].concat()
}

/// The product with the other sign.
pub(crate) fn negated([first, second, third]: Factors) -> Factors {
    [-first, second, third]
}
