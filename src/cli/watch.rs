//! Notices that files change, by asking the system a few times a second.
//!
//! The system's own notices differ from one system to the next, are lost in network folders and in containers, and would
//! cost a library; a few files are looked at in no time.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::thread;
use std::time::{Duration, SystemTime};

use super::files;

/// Between two looks: a change is to be seen at once, and looking is to cost nothing.
const PAUSE: Duration = Duration::from_millis(150);

/// Between two looks at files that are being written.
const SETTLING: Duration = Duration::from_millis(30);

/// Looks at files that are being written; whoever writes for longer is noticed again.
const MAX_SETTLING: usize = 10;

/// Files and folders, and what they were like.
#[derive(Debug)]
pub(crate) struct Watch(BTreeMap<PathBuf, Seen>);

/// What a file was like; one that is not there is like nothing.
#[derive(Debug, Default, PartialEq, Eq)]
struct Seen {
    size: u64,
    modified: Option<SystemTime>,
    /// Of what was named: a clock can be too coarse for two changes in a row.
    digest: Option<String>,
}

impl Watch {
    /// The `named` files, which are looked into, and `others`, files and folders, of which size and time tell enough.
    pub(crate) fn of(named: &[PathBuf], others: &[PathBuf]) -> Self {
        let others = others.iter().map(|path| (path.clone(), Seen::of(path)));
        let named = named.iter().map(|path| (path.clone(), Seen::into(path)));
        Self(others.chain(named).collect())
    }

    /// Waits until something is another than it was, and changes no more; what it is.
    pub(crate) fn wait(&mut self) -> BTreeSet<PathBuf> {
        let mut changed = BTreeSet::new();
        while changed.is_empty() {
            thread::sleep(PAUSE);
            changed = self.look();
        }
        // Many programs empty a file before they fill it.
        for _ in 0..MAX_SETTLING {
            thread::sleep(SETTLING);
            let further = self.look();
            if further.is_empty() {
                break;
            }
            changed.extend(further);
        }
        changed
    }

    /// What is another than it was.
    fn look(&mut self) -> BTreeSet<PathBuf> {
        let now = self.again();
        let pairs = self.0.iter().zip(now.0.values());
        let others = pairs.filter(|((_, before), now)| before != now);
        let others = others.map(|((path, _), _)| path.clone()).collect();
        *self = now;
        others
    }

    fn again(&self) -> Self {
        let looked = self.0.iter().map(|(path, seen)| {
            let now = match seen.digest {
                Some(_) => Seen::into(path),
                None => Seen::of(path),
            };
            (path.clone(), now)
        });
        Self(looked.collect())
    }
}

/// What has changed, in words.
pub(crate) fn said(changed: &BTreeSet<PathBuf>) -> String {
    match changed.first() {
        Some(path) if changed.len() == 1 => format!("{} has changed", path.display()),
        Some(path) => format!(
            "{} and {} more have changed",
            path.display(),
            changed.len() - 1
        ),
        None => String::new(),
    }
}

impl Seen {
    fn of(path: &Path) -> Self {
        let Ok(metadata) = path.metadata() else {
            return Self::default();
        };
        Self {
            size: if metadata.is_file() {
                metadata.len()
            } else {
                0
            },
            modified: metadata.modified().ok(),
            digest: None,
        }
    }

    fn into(path: &Path) -> Self {
        let digest = files::digest_of(path).unwrap_or_default();
        Self {
            digest: Some(digest),
            ..Self::of(path)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[expect(clippy::disallowed_methods, reason = "a test makes its own files")]
    fn what_changes_is_noticed_also_where_size_and_time_do_not() {
        let folder = tempfile::tempdir().unwrap();
        let (named, other) = (folder.path().join("a.toml"), folder.path().join("b.toml"));
        std::fs::write(&named, "1").unwrap();
        std::fs::write(&other, "1").unwrap();
        let mut watch = Watch::of(std::slice::from_ref(&named), std::slice::from_ref(&other));
        assert!(watch.look().is_empty());
        let time = named.metadata().unwrap().modified().unwrap();
        std::fs::write(&named, "2").unwrap();
        let file = std::fs::File::options().append(true).open(&named).unwrap();
        file.set_modified(time).unwrap();
        let only = |path: &PathBuf| BTreeSet::from([path.clone()]);
        assert_eq!(watch.wait(), only(&named));
        std::fs::write(&other, "10").unwrap();
        assert_eq!(watch.wait(), only(&other));
        std::fs::remove_file(&other).unwrap();
        assert_eq!(watch.wait(), only(&other));
    }
}
