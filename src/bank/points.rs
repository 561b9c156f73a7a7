//! How the points of a question are shared out over its parts.

use crate::numerics::{Rational, ascending};

/// Steps of points, as their parts of one: those that people add up in their heads, then finer ones for many parts.
const STEPS: [i128; 8] = [1, 2, 4, 10, 20, 100, 1_000, 1_000_000];

/// Points of a whole, shared out by weights in the largest step, of 1, 1/2, 1/4, 1/10 and finer ones, with which
/// every part of a weight gets something; their sum is the whole, exactly.
///
/// Each part gets its proportional share rounded down to the step; what is left goes, a step each, to those that were
/// rounded down most, of equal ones to the earlier (the method of largest remainders, Hamilton 1792).
///
/// ```
/// use vibank::{bank::share_out, numerics::Rational};
/// let one = Rational::ONE;
/// let shares = share_out(one, &[one, one, one]);
/// assert_eq!(shares.iter().map(|share| share.to_f64()).collect::<Vec<_>>(), [0.5, 0.25, 0.25]);
/// ```
pub fn share_out(whole: Rational, weights: &[Rational]) -> Vec<Rational> {
    let total = Rational::sum(weights);
    let steps = STEPS.into_iter();
    let shares = steps.filter_map(|step| in_steps(whole, step, weights, total?));
    let mut fair = shares.filter(|shares| {
        let mut pairs = shares.iter().zip(weights);
        pairs.all(|(share, weight)| !share.is_zero() || weight.is_zero())
    });
    fair.next().unwrap_or_else(|| exact(whole, weights, total))
}

/// Points of a group, shared out over its blanks: proportional shares where these are multiples of a twentieth, else those of
/// [`share_out`].
///
/// ```
/// use vibank::{bank::share_in_group, numerics::Rational};
/// let [one, two, three] = [1, 2, 3].map(|whole| Rational::new(whole, 1).unwrap());
/// let shares = share_in_group(two, &[one, three]);
/// assert_eq!(shares.iter().map(|share| share.to_f64()).collect::<Vec<_>>(), [0.5, 1.5]);
/// ```
pub fn share_in_group(whole: Rational, weights: &[Rational]) -> Vec<Rational> {
    /// Parts of a point that people still add up in their heads.
    const FINEST: i128 = 20;
    let shares = exact(whole, weights, Rational::sum(weights));
    if shares.iter().all(|share| FINEST % share.denominator() == 0) {
        shares
    } else {
        share_out(whole, weights)
    }
}

/// The shares as multiples of a step of this size, if they are such multiples.
fn in_steps(
    whole: Rational,
    step: i128,
    weights: &[Rational],
    total: Rational,
) -> Option<Vec<Rational>> {
    let all = whole.checked_mul(Rational::new(step, 1)?)?;
    if !all.is_integer() {
        return None;
    }
    let quota = |weight: &Rational| all.checked_mul(*weight)?.checked_div(total);
    let quotas: Vec<Rational> = weights.iter().map(quota).collect::<Option<_>>()?;
    let mut counts: Vec<i128> = quotas
        .iter()
        .map(|quota| quota.numerator().div_euclid(quota.denominator()))
        .collect();
    let rests: Vec<Rational> = (0..counts.len())
        .map(|at| quotas[at].checked_sub(Rational::new(counts[at], 1)?))
        .collect::<Option<_>>()?;
    // Remainders are small fractions of one denominator, which doubles keep apart.
    let order = ascending(counts.len(), &|part| -rests[part].to_f64());
    let left = all.numerator() - counts.iter().sum::<i128>();
    let lucky = order.into_iter().take(usize::try_from(left).ok()?);
    lucky.for_each(|at| counts[at] += 1);
    let points = counts.into_iter().map(|count| Rational::new(count, step));
    points.collect()
}

/// Shares as fractions: of a whole that no step divides.
fn exact(whole: Rational, weights: &[Rational], total: Option<Rational>) -> Vec<Rational> {
    let shares = weights
        .iter()
        .map(|weight| whole.checked_mul(*weight)?.checked_div(total?))
        .collect::<Option<Vec<_>>>();
    shares.unwrap_or_else(|| weights.to_vec())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn shared(whole: &str, weights: &[&str]) -> Vec<String> {
        let decimal = |text: &str| Rational::from_decimal(text).expect("it is a decimal");
        let weights: Vec<Rational> = weights.iter().map(|weight| decimal(weight)).collect();
        let shares = share_out(decimal(whole), &weights);
        shares
            .iter()
            .map(|share| share.to_f64().to_string())
            .collect()
    }

    #[test]
    fn points_are_shared_out_in_steps_that_people_add_up() {
        // Nine parts of weight 1 and one of 2: proportional shares would be 0.3636… and 0.7272….
        let weights = ["1", "1", "1", "1", "1", "1", "1", "1", "1", "2"];
        let shares = [
            "0.5", "0.5", "0.5", "0.5", "0.25", "0.25", "0.25", "0.25", "0.25", "0.75",
        ];
        assert_eq!(shared("4", &weights), shares);
        assert_eq!(shared("6", &["1", "2"]), ["2", "4"]);
        assert_eq!(shared("5", &["1", "1", "1"]), ["2", "2", "1"]);
        assert_eq!(shared("2.5", &["1", "1"]), ["1.5", "1"]);
        assert_eq!(shared("1", &["1", "1", "1"]), ["0.5", "0.25", "0.25"]);
        assert_eq!(shared("3.3", &["1", "1"]), ["1.7", "1.6"]);
        assert_eq!(shared("10", &["1", "100"]), ["0.1", "9.9"]);
        assert_eq!(shared("2", &["1", "0"]), ["2", "0"]);
        assert_eq!(
            shared("1", &["1"; 15])[..6],
            ["0.1", "0.1", "0.1", "0.1", "0.1", "0.05"]
        );
        assert_eq!(shared("3", &[]), [] as [&str; 0]);
    }

    proptest! {
        #[test]
        fn shares_add_up_and_follow_the_weights(
            whole in 1_i128..4000,
            weights in prop::collection::vec(1_i128..50, 1..40),
        ) {
            let whole = Rational::new(whole, 100).expect("it is a number");
            let weights: Vec<Rational> = weights.iter().filter_map(|weight| Rational::new(*weight, 2)).collect();
            let shares = share_out(whole, &weights);
            prop_assert_eq!(Rational::sum(&shares), Some(whole));
            for (a, b) in shares.iter().zip(&weights) {
                prop_assert!(!a.is_zero() && !a.is_negative());
                for (c, d) in shares.iter().zip(&weights) {
                    // A heavier part never gets less.
                    prop_assert!(b.to_f64() <= d.to_f64() || a.to_f64() >= c.to_f64());
                }
            }
        }
    }
}
