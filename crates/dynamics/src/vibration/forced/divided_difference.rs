//! Divided differences of z -> e^(zt) over the two roots of an oscillator and the excitation iΩ.
//!
//! The motion from rest under a force e^(iΩt) is exp[r1, r2, iΩ; t]/m. Written so, it needs no case for equal or nearly
//! equal nodes: at resonance, at critical damping, at short times.
//!
//! ```text
//! exp[a, b; t]    = e^(at) expm1((b - a) t)/(b - a)
//! exp[a, b, c; t] = (exp[a, c; t] - exp[c, b; t])/(a - b),   a, b farthest apart
//!                 = e^(zt) t² Σ h_n t^n/(n + 2)!             where they are close, z their centroid
//! ```
//!
//! # References
//!
//! A. McCurdy, K. C. Ng, B. N. Parlett, Math. Comp. 43 (1984) 501.

use crate::numerics::{Complex, Dd};
use crate::vibration::oscillator::{Regime, Scaled};

/// A node with both parts in double-double.
#[derive(Clone, Copy, Debug)]
struct ComplexNode {
    re: Dd,
    im: Dd,
}

impl ComplexNode {
    fn minus(self, other: Self) -> Complex {
        Complex::new((self.re - other.re).hi(), (self.im - other.im).hi())
    }

    /// Whether the numbers are the conjugates of each other.
    fn mirrors(self, other: Self) -> bool {
        self.re == other.re && self.im == -other.im
    }

    fn value(self) -> Complex {
        Complex::new(self.re.hi(), self.im.hi())
    }

    /// e^(zt).
    fn exp(self, t: f64) -> Complex {
        let (sine, cosine) = if self.im == Dd::ZERO {
            (0.0, 1.0)
        } else {
            (self.im * t).sin_cos_to_f64()
        };
        let modulus = if self.re == Dd::ZERO {
            1.0
        } else {
            (self.re * t).exp_to_f64()
        };
        Complex::new(modulus * cosine, modulus * sine)
    }
}

/// Below this product of distance and time a difference of exponentials is formed by `expm1`.
// From here on e^z - 1 loses a bit or two at most, and costs what its exponential costs.
const CLOSE: f64 = 1.0;
/// Below this product of the largest distance and time the Taylor series is used.
const ALL_CLOSE: f64 = 1.5;
/// Terms of the Taylor series; the next is below u² of the sum.
const TERMS: usize = 20;

/// The three nodes: the farthest pair first and last, the other one in between.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Nodes {
    points: [ComplexNode; 3],
    /// Distances of first and second, second and third, first and third node.
    distances: [Complex; 3],
    /// Their reciprocals and lengths.
    reciprocals: [Complex; 3],
    lengths: [f64; 3],
    /// The index of the node next to zero.
    smallest: usize,
}

/// The second divided difference, and that of its derivative in time if it was asked for.
#[derive(Clone, Copy)]
pub(crate) struct Differences {
    pub(crate) position: Complex,
    pub(crate) velocity: Complex,
}

impl Nodes {
    pub(crate) fn of(scaled: &Scaled, frequency: f64) -> Self {
        let discriminant = scaled.discriminant();
        let root = scaled.root_of(discriminant);
        let (first, second) = match scaled.regime(discriminant) {
            Regime::Undamped | Regime::Underdamped => {
                let (re, im) = (-scaled.decay_rate(), root / (2.0 * scaled.mass));
                (ComplexNode { re, im }, ComplexNode { re, im: -im })
            }
            Regime::Critical | Regime::Overdamped => {
                let (slow, fast) = scaled.real_roots(root);
                (
                    ComplexNode {
                        re: slow,
                        im: Dd::ZERO,
                    },
                    ComplexNode {
                        re: fast,
                        im: Dd::ZERO,
                    },
                )
            }
        };
        Self::ordered([
            first,
            second,
            ComplexNode {
                re: Dd::ZERO,
                im: Dd::from(frequency),
            },
        ])
    }

    /// For a unit mass, and damping and stiffness of thirty digits.
    pub(crate) fn of_mode(damping: Dd, stiffness: Dd, frequency: f64) -> Self {
        // Beyond this damping the square of its coefficient is all that counts.
        const LARGE: f64 = 1e30;
        let discriminant = damping.square() - stiffness * 4.0;
        let root = if damping.hi() > LARGE {
            damping
        } else {
            discriminant.abs().sqrt()
        };
        let (first, second) = if discriminant.is_negative() {
            let (re, im) = (damping * -0.5, root * 0.5);
            (ComplexNode { re, im }, ComplexNode { re, im: -im })
        } else {
            let sum = root + damping;
            let real = |re| ComplexNode { re, im: Dd::ZERO };
            (real(stiffness * -2.0 / sum), real(sum * -0.5))
        };
        let force = ComplexNode {
            re: Dd::ZERO,
            im: Dd::from(frequency),
        };
        Self::ordered([first, second, force])
    }

    fn ordered(nodes: [ComplexNode; 3]) -> Self {
        let distance = |i: usize, j: usize| nodes[i].minus(nodes[j]).abs();
        let middle = (0..3).max_by(|&i, &j| {
            let opposite = |k: usize| distance((k + 1) % 3, (k + 2) % 3);
            opposite(i).total_cmp(&opposite(j))
        });
        let middle = middle.unwrap_or(0);
        let nodes = [
            nodes[(middle + 1) % 3],
            nodes[middle],
            nodes[(middle + 2) % 3],
        ];
        let distances = [
            nodes[1].minus(nodes[0]),
            nodes[2].minus(nodes[1]),
            nodes[2].minus(nodes[0]),
        ];
        let smallest = (0..3)
            .min_by(|&i, &j| nodes[i].value().abs().total_cmp(&nodes[j].value().abs()))
            .unwrap_or(0);
        Self {
            points: nodes,
            distances,
            reciprocals: distances.map(Complex::recip),
            lengths: distances.map(Complex::abs),
            smallest,
        }
    }

    /// exp[r1, r2, iΩ; t].
    pub(crate) fn position(&self, t: f64) -> Complex {
        if self.lengths[2] * t < ALL_CLOSE {
            self.series(t)
        } else {
            self.quotient(&self.exponentials(t), t)
        }
    }

    /// exp[r1, r2, iΩ; t] and its derivative, by way of the node next to zero: z exp[z, a, b; t] + exp[a, b; t].
    pub(crate) fn differences(&self, t: f64) -> Differences {
        let powers = self.exponentials(t);
        let position = if self.lengths[2] * t < ALL_CLOSE {
            self.series(t)
        } else {
            self.quotient(&powers, t)
        };
        let others = match self.smallest {
            0 => self.pair(1, 2, 1, &powers, t),
            1 => self.pair(0, 2, 2, &powers, t),
            _ => self.pair(0, 1, 0, &powers, t),
        };
        Differences {
            position,
            velocity: self.points[self.smallest].value() * position + others,
        }
    }

    /// e^(zt) at the nodes, of which a pair may be conjugate.
    fn exponentials(&self, t: f64) -> [Complex; 3] {
        let [first, second, third] = self.points;
        let power = first.exp(t);
        if third.mirrors(first) {
            return [power, second.exp(t), power.conjugate()];
        }
        let next = if second.mirrors(first) {
            power.conjugate()
        } else {
            second.exp(t)
        };
        let last = if third.mirrors(second) {
            next.conjugate()
        } else {
            third.exp(t)
        };
        [power, next, last]
    }

    fn quotient(&self, powers: &[Complex; 3], t: f64) -> Complex {
        (self.pair(1, 2, 1, powers, t) - self.pair(0, 1, 0, powers, t)) * self.reciprocals[2]
    }

    /// exp[a, b; t] of two nodes, whose distance b - a is at `gap`.
    fn pair(&self, a: usize, b: usize, gap: usize, powers: &[Complex; 3], t: f64) -> Complex {
        let (distance, reciprocal) = (self.distances[gap], self.reciprocals[gap]);
        if self.lengths[gap] * t >= CLOSE {
            (powers[b] - powers[a]) * reciprocal
        } else if distance == Complex::ZERO {
            powers[a] * t
        } else if distance.re <= 0.0 {
            powers[a] * (distance * t).expm1() * reciprocal
        } else {
            powers[b] * (-distance * t).expm1() * -reciprocal
        }
    }

    /// Taylor series about the centroid, for nodes that are close: the deviations sum up to zero, so that
    /// h_n = -e2 h_(n-2) + e3 h_(n-3) in their elementary symmetric polynomials.
    fn series(&self, t: f64) -> Complex {
        let [near, far, whole] = self.distances.map(|distance| distance * (t / 3.0));
        let deviations = [-(near + whole), near - far, far + whole];
        let pairs = deviations[0] * deviations[1]
            + deviations[1] * deviations[2]
            + deviations[2] * deviations[0];
        let triple = deviations[0] * deviations[1] * deviations[2];
        let mut polynomials = [Complex::ZERO, Complex::ZERO, Complex::ONE];
        let (mut sum, mut weight) = (Complex::from(0.5), 0.5);
        for n in 1..TERMS {
            let [before, last_but_one, last] = polynomials;
            let next = triple * before - pairs * last_but_one;
            polynomials = [last_but_one, last, next];
            weight /= n as f64 + 2.0;
            sum = sum + next * weight;
        }
        let real = self.points.iter().fold(Dd::ZERO, |sum, node| sum + node.re) / 3.0;
        let imaginary = self.points.iter().fold(Dd::ZERO, |sum, node| sum + node.im) / 3.0;
        ComplexNode {
            re: real,
            im: imaginary,
        }
        .exp(t)
            * sum
            * (t * t)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn node(re: f64, im: f64) -> ComplexNode {
        ComplexNode {
            re: Dd::from(re),
            im: Dd::from(im),
        }
    }

    #[test]
    fn series_and_quotient_agree_where_they_meet() {
        let nodes = Nodes::ordered([node(-0.1, 0.7), node(-0.1, -0.7), node(0.0, 0.5)]);
        let t = 1.5 / nodes.lengths[2];
        let quotient = nodes.quotient(&nodes.exponentials(t), t);
        assert!((nodes.series(t) - quotient).abs() < 2e-15 * quotient.abs());
    }

    #[test]
    fn equal_nodes_give_the_derivative() {
        let nodes = Nodes::ordered([node(0.0, 0.0), node(0.0, 0.0), node(0.0, 0.0)]);
        assert_eq!(nodes.position(3.0), Complex::from(4.5));
        let double = Nodes::ordered([node(0.0, 0.0), node(0.0, 0.0), node(-1.0, 0.0)]);
        let expected = crate::numerics::exp(-4.0) - 1.0 + 4.0;
        assert!((double.position(4.0).re - expected).abs() < 2e-15);
    }

    #[test]
    fn the_second_member_is_the_derivative_of_the_first() {
        let nodes = Nodes::ordered([node(-0.1, 0.7), node(-0.1, -0.7), node(0.0, 0.5)]);
        for t in [0.1, 2.0, 30.0] {
            let slope = (nodes.position(t + 1e-5) - nodes.position(t - 1e-5)) / 2e-5;
            assert!((nodes.differences(t).velocity - slope).abs() < 1e-8, "{t}");
        }
    }
}
