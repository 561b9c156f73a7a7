//! Groups of close frequencies, and the comparison of the motions they span.
//!
//! The shapes inside a group are not determined, or badly; the space they span is. Shapes are therefore never
//! compared component by component.

use std::ops::Range;

use super::{Modes, ModesError};
use crate::numerics::jacobi::{ScaledColumns, dot};

impl Modes {
    /// Groups of consecutive modes whose frequencies differ by at most `tolerance` times the larger one.
    ///
    /// # Examples
    ///
    /// An equilateral ring of three masses: one rigid motion, then two motions of the same frequency.
    ///
    /// ```
    /// use vibank_dynamics::vibration::modes::{Link, Modes};
    ///
    /// let ring = [Link::between(1, 2, 5.0), Link::between(2, 3, 5.0), Link::between(3, 1, 5.0)];
    /// let modes = Modes::of_network(&[1.0; 3], &ring)?;
    /// assert_eq!(modes.clusters(1e-9), [0..1, 1..3]);
    /// # Ok::<(), vibank_dynamics::vibration::modes::ModesError>(())
    /// ```
    pub fn clusters(&self, tolerance: f64) -> Vec<Range<usize>> {
        let mut clusters: Vec<Range<usize>> = Vec::new();
        for (mode, &rate) in self.rates.iter().enumerate() {
            let is_close =
                |other: f64| (rate - other).abs() <= tolerance * rate.abs().max(other.abs());
            match clusters.last_mut() {
                Some(cluster) if is_close(self.rates[mode - 1]) => cluster.end = mode + 1,
                _ => clusters.push(mode..mode + 1),
            }
        }
        clusters
    }

    /// Smallest relative distance of a group of modes to the other frequencies; infinite if there are none.
    ///
    /// The shapes of the group are determined to about the precision of the data over this number.
    pub fn relative_gap(&self, cluster: Range<usize>) -> f64 {
        let distance = |inside: usize, outside: usize| {
            let (a, b) = (self.rates[inside], self.rates[outside]);
            if a == b {
                0.0
            } else {
                (a - b).abs() / a.abs().max(b.abs())
            }
        };
        let last = cluster.end.min(self.count()).saturating_sub(1);
        let below = cluster
            .start
            .checked_sub(1)
            .map(|outside| distance(cluster.start, outside));
        let above = (last + 1 < self.count()).then(|| distance(last, last + 1));
        below.into_iter().chain(above).fold(f64::INFINITY, f64::min)
    }

    /// Sine of the largest angle between the span of some shapes and that of a group of modes, in the inner product of M.
    ///
    /// ```text
    /// max over w in the span of  |(I - U Uᵀ M) w| / |w|,    |w|² = wᵀ M w
    /// ```
    ///
    /// For one shape this is `sqrt(1 - MAC)`. Scale, sign and order are free; dependent shapes count as what they span.
    ///
    /// # Errors
    ///
    /// A shape that does not fit the system or is not finite.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank_dynamics::vibration::modes::{Link, Modes};
    ///
    /// let springs = [Link::to_ground(1, 2.0), Link::between(1, 2, 1.0), Link::to_ground(2, 2.0)];
    /// let modes = Modes::of_network(&[1.0, 1.0], &springs)?;
    /// assert!(modes.largest_principal_angle_sine(0..1, &[vec![3.0, 3.0]])? < 1e-15);
    /// assert!(modes.largest_principal_angle_sine(1..2, &[vec![3.0, 3.0]])? > 0.999);
    /// # Ok::<(), vibank_dynamics::vibration::modes::ModesError>(())
    /// ```
    ///
    /// # References
    ///
    /// Björck, Golub, Math. Comp. 27 (1973) 579. Allemang, Sound and Vibration 37 (2003) 14.
    pub fn largest_principal_angle_sine(
        &self,
        cluster: Range<usize>,
        shapes: &[Vec<f64>],
    ) -> Result<f64, ModesError> {
        let mut entries = Vec::new();
        for shape in shapes {
            self.check_length(shape)?;
            if shape.iter().any(|x| !x.is_finite()) {
                return Err(ModesError::NotFinite);
            }
            // Before the weights and after them: shapes are typed in any unit, and neither products nor
            // squares are to overflow.
            entries.extend(normalized(self.root.weighted(&normalized(shape.clone()))));
        }
        let span =
            ScaledColumns::new(self.count(), entries, vec![1.0; shapes.len()]).left_singular();
        let independent = span
            .values
            .iter()
            .zip(span.vectors.chunks_exact(self.count()))
            // Columns have a largest entry of one: less than this is what rounding leaves of a shape that
            // depends on the others.
            .filter(|(value, _)| **value > 1e-12);
        let mut residuals = Vec::new();
        for (_, direction) in independent {
            residuals.extend(self.without(cluster.clone(), direction));
        }
        let count = residuals.len() / self.count();
        let sines = ScaledColumns::new(self.count(), residuals, vec![1.0; count]).left_singular();
        Ok(sines.values.last().copied().unwrap_or(0.0).min(1.0))
    }

    /// What a weighted direction has outside a group of modes.
    fn without(&self, cluster: Range<usize>, direction: &[f64]) -> Vec<f64> {
        let mut rest = direction.to_vec();
        for mode in cluster.start..cluster.end.min(self.count()) {
            let shape = self.weighted_shape(mode);
            let overlap = dot(&rest, shape);
            rest.iter_mut()
                .zip(shape)
                .for_each(|(x, y)| *x -= overlap * y);
        }
        rest
    }
}

/// The vector over its largest component, or zero.
fn normalized(mut vector: Vec<f64>) -> Vec<f64> {
    let largest = vector
        .iter()
        .fold(0.0_f64, |largest, x| largest.max(x.abs()));
    if largest > 0.0 {
        for x in &mut vector {
            *x /= largest;
        }
    }
    vector
}
