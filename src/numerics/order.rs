//! The order of numbers by their places.

/// The places up to a count in ascending order of their keys, equal ones as they came.
///
/// The keys are behind a pointer, so that sorting is compiled once for all who want an order: the grader of the page
/// would carry a copy for each.
///
/// ```
/// use vibank::numerics::ascending;
/// let frequencies = [3.0, 1.0, 2.0];
/// assert_eq!(ascending(3, &|place| frequencies[place]), [1, 2, 0]);
/// ```
pub fn ascending(count: usize, key: &dyn Fn(usize) -> f64) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|&a, &b| key(a).total_cmp(&key(b)));
    order
}
