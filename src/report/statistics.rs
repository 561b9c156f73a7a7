//! Moments that are gathered one observation at a time, in memory that does not grow.
//!
//! The updates are those of B. P. Welford, Technometrics 4 (1962) 419, which lose no digits to cancellation.

/// Mean and spread of a number.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Moments {
    count: u64,
    mean: f64,
    squares: f64,
}

/// Mean and spread of two numbers, and how they go together.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Pairs {
    first: Moments,
    second: Moments,
    products: f64,
}

impl Moments {
    pub(crate) fn add(&mut self, value: f64) {
        self.count += 1;
        let before = value - self.mean;
        self.mean += before / self.count as f64;
        self.squares += before * (value - self.mean);
    }

    pub(crate) fn count(&self) -> u64 {
        self.count
    }

    pub(crate) fn mean(&self) -> Option<f64> {
        (self.count > 0).then_some(self.mean)
    }

    /// The variance of a sample, from two values on.
    pub(crate) fn variance(&self) -> Option<f64> {
        (self.count > 1).then(|| self.squares / (self.count - 1) as f64)
    }

    pub(crate) fn deviation(&self) -> Option<f64> {
        self.variance().map(f64::sqrt)
    }
}

impl Pairs {
    pub(crate) fn add(&mut self, first: f64, second: f64) {
        let before = first - self.first.mean;
        self.first.add(first);
        self.second.add(second);
        self.products += before * (second - self.second.mean);
    }

    /// Pearson's correlation, from three pairs on, where both numbers vary.
    pub(crate) fn correlation(&self) -> Option<f64> {
        let spread = (self.first.squares * self.second.squares).sqrt();
        let is_known = self.first.count > 2 && spread > 0.0;
        is_known.then(|| (self.products / spread).clamp(-1.0, 1.0))
    }
}

/// Cronbach's alpha of parts with these variances of their points in sheets whose points have this variance;
/// where all marks are all or nothing it is the KR-20 of Kuder and Richardson.
///
/// L. J. Cronbach, Psychometrika 16 (1951) 297.
pub(crate) fn alpha(parts: &[f64], whole: f64) -> Option<f64> {
    let count = parts.len() as f64;
    let is_known = parts.len() > 1 && whole > 0.0;
    is_known.then(|| count / (count - 1.0) * (1.0 - parts.iter().sum::<f64>() / whole))
}

/// The value below which a share of sorted values lies, in between where it falls between two.
pub(crate) fn quantile(sorted: &[f64], share: f64) -> Option<f64> {
    let last = sorted.len().checked_sub(1)?;
    let place = share * last as f64;
    let (low, rest) = (place.floor(), place - place.floor());
    let next = sorted[(low as usize + 1).min(last)];
    Some(sorted[low as usize] + rest * (next - sorted[low as usize]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_of_a_few_numbers() {
        let mut moments = Moments::default();
        [2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0]
            .into_iter()
            .for_each(|value| moments.add(value));
        assert_eq!(moments.mean(), Some(5.0));
        // The squares of the distances add up to 32.
        assert!((moments.variance().unwrap() - 32.0 / 7.0).abs() < 1e-14);
    }

    #[test]
    fn correlation_of_a_line_and_of_nothing() {
        let (mut line, mut flat) = (Pairs::default(), Pairs::default());
        for value in [1.0, 2.0, 5.0] {
            line.add(value, 3.0 - 2.0 * value);
            flat.add(value, 1.0);
        }
        assert!((line.correlation().unwrap() + 1.0).abs() < 1e-14);
        assert_eq!(flat.correlation(), None);
    }

    /// Three parts, four sheets, by hand: the parts have the variances 1/4, 1/3 and 1/4, the sums 3, 2, 1, 0 the
    /// variance 5/3, and KR-20 with sample variances is 3/2 (1 − (5/6)/(5/3)) = 3/4.
    #[test]
    fn alpha_of_all_or_nothing_marks_is_kr20() {
        let sheets = [
            [1.0, 1.0, 1.0],
            [1.0, 1.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 0.0, 0.0],
        ];
        let mut parts = [Moments::default(); 3];
        let mut whole = Moments::default();
        for sheet in sheets {
            parts
                .iter_mut()
                .zip(sheet)
                .for_each(|(part, mark)| part.add(mark));
            whole.add(sheet.iter().sum());
        }
        let variances = parts.map(|part| part.variance().unwrap());
        assert!((alpha(&variances, whole.variance().unwrap()).unwrap() - 0.75).abs() < 1e-14);
    }

    #[test]
    fn quantiles_lie_between() {
        assert_eq!(quantile(&[1.0, 2.0, 4.0], 0.5), Some(2.0));
        assert_eq!(quantile(&[1.0, 2.0], 0.25), Some(1.25));
        assert_eq!(quantile(&[], 0.5), None);
    }
}
