//! A part of a run, for machines that share the work.

use std::fmt;
use std::ops::Range;
use std::str::FromStr;

/// One of several parts of a run, `2/4`; `1/1` is all of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Shard {
    /// From 1.
    part: usize,
    of: usize,
}

impl Default for Shard {
    fn default() -> Self {
        Self { part: 1, of: 1 }
    }
}

impl Shard {
    /// Whether it is the whole run.
    pub(crate) fn is_whole(self) -> bool {
        self.of == 1
    }

    /// How many parts there are.
    pub(crate) fn of(self) -> usize {
        self.of
    }

    /// All parts of a run of this many.
    pub(crate) fn all(of: usize) -> impl Iterator<Item = Self> {
        (1..=of).map(move |part| Self { part, of })
    }

    /// Its share of `count` sheets, which stand together.
    pub(crate) fn share(self, count: usize) -> Range<usize> {
        self.share_of(&vec![1; count])
    }

    /// Its share of sheets of which each costs so much; they stand together, and the shares cost about the same.
    pub(crate) fn share_of(self, costs: &[u64]) -> Range<usize> {
        let whole: u128 = costs.iter().map(|cost| u128::from(*cost)).sum();
        // The sheets up to whose ends no more than the first `parts` parts of the whole are spent.
        let until = |parts: usize| {
            if parts == 0 {
                return 0;
            }
            let most = whole * parts as u128 / self.of as u128;
            let ends = costs.iter().scan(0, |spent, cost| {
                *spent += u128::from(*cost);
                Some(*spent)
            });
            ends.take_while(|end| *end <= most).count()
        };
        until(self.part - 1)..until(self.part)
    }

    /// The part whose file of this kind has this name; nothing for other files, and for that of the whole run.
    pub(crate) fn of_name(name: &str, stem: &str, extension: &str) -> Option<Self> {
        let (part, of) = name
            .strip_prefix(stem)?
            .strip_prefix('-')?
            .split_once("of")?;
        let of = of.strip_suffix(extension)?.strip_suffix('.')?;
        let shard: Self = format!("{part}/{of}").parse().ok()?;
        (!shard.is_whole() && shard.named(stem, extension) == name).then_some(shard)
    }

    /// The name of a file that each part has for itself: `manifest-2of4.json`.
    pub(crate) fn named(self, stem: &str, extension: &str) -> String {
        if self.is_whole() {
            format!("{stem}.{extension}")
        } else {
            format!("{stem}-{}of{}.{extension}", self.part, self.of)
        }
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        // More parts than anybody has machines, so a larger number is a slip.
        const MAX_COUNT: usize = 1000;
        let parts = text.split_once('/');
        let numbers = parts.and_then(|(part, of)| Some((part.parse().ok()?, of.parse().ok()?)));
        match numbers {
            Some((part, of)) if 1 <= part && part <= of && of <= MAX_COUNT => Ok(Self { part, of }),
            _ => Err(format!(
                "write the part and the number of parts, from 1/1 to {MAX_COUNT}/{MAX_COUNT}"
            )),
        }
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.part, self.of)
    }
}

#[cfg(test)]
mod tests {
    use super::Shard;

    #[test]
    fn shards_share_all_sheets_and_none_twice() {
        for (count, of) in [(1000, 4), (7, 3), (2, 5), (0, 2)] {
            let shares = (1..=of).flat_map(|part| Shard { part, of }.share(count));
            assert_eq!(shares.collect::<Vec<_>>(), (0..count).collect::<Vec<_>>());
        }
    }

    #[test]
    fn shares_cost_about_the_same() {
        // The second half of the class was absent.
        let costs: Vec<u64> = (0..1000).map(|at| if at < 500 { 51 } else { 1 }).collect();
        let shares: Vec<u64> = Shard::all(4)
            .map(|shard| costs[shard.share_of(&costs)].iter().sum())
            .collect();
        assert_eq!(shares.iter().sum::<u64>(), 26_000);
        assert!(
            shares.iter().all(|share| share.abs_diff(6500) <= 51),
            "{shares:?}"
        );
        let shares: Vec<usize> = Shard::all(4)
            .flat_map(|shard| shard.share_of(&costs))
            .collect();
        assert_eq!(shares, (0..1000).collect::<Vec<_>>());
        // Where nothing costs anything, all is in one of them.
        let of_nothing = Shard::all(3).flat_map(|shard| shard.share_of(&[0, 0]));
        assert_eq!(of_nothing.count(), 2);
    }

    #[test]
    fn a_shard_is_read_as_it_is_written() {
        let shard: Shard = "2/4".parse().expect("it is a shard");
        assert_eq!(shard.to_string(), "2/4");
        assert_eq!(shard.named("manifest", "json"), "manifest-2of4.json");
        let found = |name| Shard::of_name(name, "manifest", "json");
        assert_eq!(found("manifest-2of4.json"), Some(shard));
        for other in [
            "manifest.json",
            "manifest-02of4.json",
            "manifest-5of4.json",
            "x-1of2.json",
        ] {
            assert_eq!(found(other), None, "{other}");
        }
        for wrong in ["", "0/4", "5/4", "2", "a/b", "1/0", "1/1001"] {
            assert!(wrong.parse::<Shard>().is_err(), "{wrong}");
        }
    }
}
