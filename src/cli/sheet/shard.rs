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

    /// Its share of `count` sheets, which stand together.
    pub(crate) fn share(self, count: usize) -> Range<usize> {
        count * (self.part - 1) / self.of..count * self.part / self.of
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
        const MOST: usize = 1000;
        let parts = text.split_once('/');
        let numbers = parts.and_then(|(part, of)| Some((part.parse().ok()?, of.parse().ok()?)));
        match numbers {
            Some((part, of)) if 1 <= part && part <= of && of <= MOST => Ok(Self { part, of }),
            _ => Err(format!(
                "write the part and the number of parts, from 1/1 to {MOST}/{MOST}"
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
    fn a_shard_is_read_as_it_is_written() {
        let shard: Shard = "2/4".parse().expect("it is a shard");
        assert_eq!(shard.to_string(), "2/4");
        assert_eq!(shard.named("manifest", "json"), "manifest-2of4.json");
        for wrong in ["", "0/4", "5/4", "2", "a/b", "1/0", "1/1001"] {
            assert!(wrong.parse::<Shard>().is_err(), "{wrong}");
        }
    }
}
