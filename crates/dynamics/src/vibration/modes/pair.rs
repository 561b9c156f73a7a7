//! Two degrees of freedom in closed form.

use crate::numerics::Dd;

/// The modes of two masses on three springs: wall - spring - mass - spring - mass - spring - wall.
///
/// With `a = (k01+k12)/m1`, `c = (k02+k12)/m2`, `b = k12/sqrt(m1 m2)`,
///
/// ```text
/// ω₂² = (a + c)/2 + sqrt(((a - c)/2)² + b²)
/// ω₁² = (k01 k12 + k01 k02 + k12 k02) / (m1 m2 ω₂²)
/// ```
///
/// All terms are positive, so neither frequency loses digits, however weak a spring is.
///
/// # Examples
///
/// ```
/// use vibank_dynamics::vibration::modes::Pair;
///
/// // Equal masses between walls, weakly coupled: in phase at 10 rad/s, out of phase slightly above.
/// let pair = Pair::of_network([1.0, 1.0], [100.0, 0.5, 100.0]);
/// let [first, second] = pair.natural_angular_frequencies();
/// assert_eq!((first, second * second), (10.0, 101.0));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    masses: [f64; 2],
    /// Squared natural angular frequencies, ascending.
    squares: [f64; 2],
    /// Half the difference `(c - a)/2` and `b` of the mass-weighted stiffness matrix.
    half_difference: f64,
    coupling: f64,
}

impl Pair {
    /// Masses in kg; springs wall-first, first-second and second-wall in N/m.
    ///
    /// Masses have to be positive and springs must not be negative, else the result is NaN.
    pub fn of_network(masses: [f64; 2], springs: [f64; 3]) -> Self {
        let [m1, m2] = masses;
        let [k01, k12, k02] = springs;
        let (a, c) = ((k01 + k12) / m1, (k02 + k12) / m2);
        let half_difference = (c - a) / 2.0;
        let square = k12 / m1 * (k12 / m2);
        let larger = f64::midpoint(a, c) + (half_difference * half_difference + square).sqrt();
        let smaller = if larger > 0.0 {
            (k01 / m1 * ((k12 + k02) / m2) + k12 / m1 * (k02 / m2)) / larger
        } else {
            0.0
        };
        Self {
            masses,
            squares: [smaller, larger],
            half_difference,
            coupling: -square.sqrt(),
        }
    }

    /// Whether all products of the closed form stay well inside the exponent range.
    pub(crate) fn is_in_range(masses: &[f64], springs: [f64; 3]) -> bool {
        const RANGE: std::ops::Range<f64> = 1e-70..1e70;
        masses.iter().all(|m| RANGE.contains(m))
            && springs.iter().all(|k| *k == 0.0 || RANGE.contains(k))
    }

    /// Natural angular frequencies in rad/s, ascending.
    pub fn natural_angular_frequencies(&self) -> [f64; 2] {
        self.squares.map(f64::sqrt)
    }

    /// The natural angular frequencies of the same formulas in double-double arithmetic, correctly rounded but for rare ties.
    pub(crate) fn exact_frequencies([m1, m2]: [f64; 2], [k01, k12, k02]: [f64; 3]) -> [f64; 2] {
        let (first, second) = (Dd::sum(k01, k12), Dd::sum(k02, k12));
        let (a, c) = (first / m1, second / m2);
        let square = Dd::product(k12, k12) / m1 / m2;
        let larger = (a + c) * 0.5 + ((c - a).square() * 0.25 + square).sqrt();
        if larger == Dd::ZERO {
            return [0.0; 2];
        }
        let product = (second * k01 + Dd::product(k12, k02)) / m1 / m2;
        [(product / larger).sqrt().hi(), larger.sqrt().hi()]
    }

    /// Mass-weighted shapes, orthonormal, in the order of the frequencies.
    pub(crate) fn weighted_shapes(&self) -> [[f64; 2]; 2] {
        let (h, b) = (self.half_difference, self.coupling);
        if b == 0.0 {
            let (first, second) = ([1.0, 0.0], [0.0, 1.0]);
            return if h >= 0.0 {
                [first, second]
            } else {
                [second, first]
            };
        }
        let root = (h * h + b * b).sqrt();
        // The smaller angle of rotation, whose denominator does not cancel.
        let tangent = b / (h + root.copysign(h));
        let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
        let sine = cosine * tangent;
        // The direction of the entry `a`, lowered for h > 0, and the one of `c`, raised.
        let (of_first, of_second) = ([cosine, -sine], [sine, cosine]);
        if h >= 0.0 {
            [of_first, of_second]
        } else {
            [of_second, of_first]
        }
    }

    /// Mass-normalized mode shapes `φᵀ M φ = 1`, the first component that is not zero positive.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_dynamics::vibration::modes::Pair;
    ///
    /// let [in_phase, out_of_phase] = Pair::of_network([0.5, 0.5], [3.0, 1.0, 3.0]).mode_shapes();
    /// assert!((in_phase[0] - 1.0).abs() < 1e-15 && (in_phase[1] - 1.0).abs() < 1e-15);
    /// assert!((out_of_phase[0] - 1.0).abs() < 1e-15 && (out_of_phase[1] + 1.0).abs() < 1e-15);
    /// ```
    pub fn mode_shapes(&self) -> [[f64; 2]; 2] {
        let roots = self.masses.map(f64::sqrt);
        self.weighted_shapes().map(|[first, second]| {
            let sign = if first < 0.0 || first == 0.0 && second < 0.0 {
                -1.0
            } else {
                1.0
            };
            [sign * first / roots[0], sign * second / roots[1]]
        })
    }
}
