//! Streams of random integers, one for each name.

use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use sha2::{Digest, Sha256};

use super::Seed;
use super::digest::{HashedField, feed};

/// All streams of one item: for each name an independent one.
///
/// # Examples
///
/// ```
/// use vibank::seed::{Seed, Streams};
///
/// let streams = Streams::of(Seed::new(7), "ch1/e1");
/// let (mut m, mut k) = (streams.named("m"), streams.named("k"));
/// let draws = [m.below(1000), m.below(1000), k.below(1000)];
/// // Each name has its own stream, whatever else was drawn.
/// assert_eq!(streams.named("k").below(1000), draws[2]);
/// ```
#[derive(Clone, Debug)]
pub struct Streams {
    prefix: Sha256,
}

impl Streams {
    /// The streams of the item `item` for the seed `seed`.
    pub fn of(seed: Seed, item: &str) -> Self {
        let mut prefix = Sha256::new();
        for field in [
            HashedField::Text("vibank 1"),
            HashedField::Number(seed.number()),
            HashedField::Text(item),
        ] {
            feed(field, |bytes| prefix.update(bytes));
        }
        Self { prefix }
    }

    /// The stream of one name, at its beginning.
    pub fn named(&self, name: &str) -> Stream {
        let mut hash = self.prefix.clone();
        feed(HashedField::Text(name), |bytes| hash.update(bytes));
        Stream(ChaCha8Rng::from_seed(hash.finalize().into()))
    }
}

/// A stream of random integers. The draw of attempt *n* is the *n*-th one taken from it.
#[derive(Clone, Debug)]
pub struct Stream(ChaCha8Rng);

impl Stream {
    /// The next integer in `0..n`, each equally likely; 0 for an `n` of 0.
    ///
    /// The high half of a 64-bit word times `n`; words that would favour some integers are skipped.
    ///
    /// # References
    ///
    /// D. Lemire, Fast random integer generation in an interval, ACM TOMACS 29 (2019), 3.
    pub fn below(&mut self, n: u64) -> u64 {
        let mut product = u128::from(self.0.next_u64()) * u128::from(n);
        if (product as u64) < n {
            let surplus = n.wrapping_neg() % n;
            while (product as u64) < surplus {
                product = u128::from(self.0.next_u64()) * u128::from(n);
            }
        }
        (product >> 64) as u64
    }

    /// Puts a list in random order, each order equally likely.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank::seed::{Seed, Streams};
    ///
    /// let mut options = ["a", "b", "c", "d"];
    /// Streams::of(Seed::new(7), "ch1/e1").named("options").shuffle(&mut options);
    /// options.sort_unstable();
    /// assert_eq!(options, ["a", "b", "c", "d"]);
    /// ```
    ///
    /// # References
    ///
    /// R. Durstenfeld, Algorithm 235: Random permutation, Communications of the ACM 7 (1964), 420.
    pub fn shuffle<T>(&mut self, list: &mut [T]) {
        for last in (1..list.len()).rev() {
            list.swap(last, self.below(last as u64 + 1) as usize);
        }
    }

    /// The numbers `0..n` in random order.
    pub fn permutation(&mut self, n: usize) -> Vec<usize> {
        let mut order: Vec<usize> = (0..n).collect();
        self.shuffle(&mut order);
        order
    }
}

/// Frozen: sheets that are printed depend on these numbers. The vectors were computed apart from this code, from the
/// definitions of SHA-256 and ChaCha8 in another language.
#[cfg(test)]
mod tests {
    use super::*;

    const ITEM: &str = "ch2/p1-pinned-bar-block";

    fn draws(stream: &mut Stream, n: u64) -> [u64; 8] {
        std::array::from_fn(|_| stream.below(n))
    }

    #[test]
    fn generator_is_frozen() {
        let mut rng = ChaCha8Rng::from_seed([7; 32]);
        rng.set_stream(3);
        assert_eq!(draws(&mut Stream(rng), 61), [7, 27, 15, 29, 27, 21, 23, 45]);
        assert_eq!(
            ChaCha8Rng::seed_from_u64(42).next_u64(),
            0xAE90_BFB5_395D_5BA1
        );
    }

    #[test]
    fn named_streams_are_frozen() {
        let streams = Streams::of(Seed::new(2026), ITEM);
        assert_eq!(
            draws(&mut streams.named("m"), 46),
            [36, 17, 17, 12, 21, 9, 11, 13]
        );
        assert_eq!(
            draws(&mut streams.named("k"), 46),
            [0, 21, 45, 17, 26, 5, 40, 19]
        );
        assert_eq!(
            streams.named("options").permutation(8),
            [5, 7, 2, 3, 4, 6, 1, 0]
        );
    }

    #[test]
    fn skipped_words_are_frozen() {
        // A quarter of all words is skipped here.
        let mut stream = Streams::of(Seed::new(1), "a").named("b");
        for expected in [
            9_433_548_569_811_261_751,
            13_764_027_567_563_323_972,
            4_365_200_528_606_977_957,
            2_228_081_072_154_093_448,
        ] {
            assert_eq!(stream.below(3 << 62), expected);
        }
    }

    #[test]
    fn fields_do_not_run_into_each_other() {
        let first =
            |item: &str, name: &str| Streams::of(Seed::new(1), item).named(name).below(u64::MAX);
        assert_ne!(first("ab", "c"), first("a", "bc"));
        assert_ne!(first("a", ""), first("", "a"));
    }

    #[test]
    fn small_ranges_are_drawn_evenly() {
        let mut stream = Streams::of(Seed::new(5), ITEM).named("x");
        assert_eq!([stream.below(0), stream.below(1)], [0, 0]);
        let mut counts = [0.0_f64; 7];
        for _ in 0..70_000 {
            counts[stream.below(7) as usize] += 1.0;
        }
        // Chi-squared with 6 degrees of freedom: 22.5 is passed once in a thousand seeds.
        let chi_squared: f64 = counts
            .iter()
            .map(|count| (count - 1e4) * (count - 1e4) / 1e4)
            .sum();
        assert!(chi_squared < 22.5, "{chi_squared}");
    }

    #[test]
    fn every_order_comes_up() {
        let mut stream = Streams::of(Seed::new(6), ITEM).named("x");
        let orders: std::collections::BTreeSet<_> =
            (0..500).map(|_| stream.permutation(4)).collect();
        assert_eq!(orders.len(), 24);
        assert_eq!(stream.permutation(0), Vec::<usize>::new());
    }
}
