//! The index of a bank in a folder: what a list shows of its items, so that a command reads those alone that it uses.
//!
//! It stands in the user's cache and can be removed at any time. A row of it counts while its file has the size, times and
//! number that it had when it was read; what is then used is read anyway, and a row of another text does not count. An
//! index that is broken, that belongs to another folder or program, or that others may have written, is made anew.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs::{self, Metadata};
use std::io::Read;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use serde::{Deserialize, Serialize};
use vibank::bank::{ItemId, Listing, Revision};

use super::files::{self, Access};
use super::setting;

/// Where indices are kept; empty for none.
const VARIABLE: &str = "VIBANK_CACHE";
/// No index is larger: rows of a hundred thousand items.
const MAX_LENGTH: u64 = 128 << 20;
/// A file that was changed this shortly before the index was written may have been changed once more without another
/// time: the coarsest file systems count in two seconds.
const RACY: Duration = Duration::from_secs(2);

/// What tells a file from one that was changed, without its text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Stamp {
    size: u64,
    /// When its text was changed, in nanoseconds.
    modified: u64,
    /// When anything of it was, where the system knows.
    changed: u64,
    /// Its number, where the system has one.
    inode: u64,
}

/// The index of one folder.
pub(crate) struct Index {
    path: PathBuf,
    head: IndexHead,
    /// The rows of an earlier run.
    text: String,
    rows: BTreeMap<String, IndexRow>,
    /// Those of this one.
    noted: BTreeMap<ItemId, String>,
    /// When the earlier run wrote it.
    written: u64,
}

/// A row of an earlier run: its listing is read when somebody asks for it.
struct IndexRow {
    stamp: Stamp,
    listing: Range<usize>,
}

/// What an index belongs to, in its first line.
#[derive(PartialEq, Eq, Serialize, Deserialize)]
struct IndexHead {
    /// The program, which another build may read items otherwise than.
    program: String,
    folder: PathBuf,
    /// The text of `bank.toml`, whose words items are held against.
    bank: Revision,
    /// SHA-256 of the rows.
    rows: String,
}

impl Stamp {
    pub(crate) fn of(metadata: &Metadata) -> Self {
        #[cfg(unix)]
        let (changed, inode) = {
            use std::os::unix::fs::MetadataExt;
            let seconds = metadata.ctime().unsigned_abs();
            let nanoseconds = metadata.ctime_nsec().unsigned_abs();
            (seconds * 1_000_000_000 + nanoseconds, metadata.ino())
        };
        #[cfg(not(unix))]
        let (changed, inode) = (0, 0);
        Self {
            size: metadata.len(),
            modified: modified(metadata),
            changed,
            inode,
        }
    }

    fn read(text: &str) -> Option<Self> {
        let mut numbers = text.split(' ').map(|number| number.parse().ok());
        let mut number = || numbers.next()?;
        Some(Self {
            size: number()?,
            modified: number()?,
            changed: number()?,
            inode: number()?,
        })
    }
}

/// When the text of a file was changed, in nanoseconds.
fn modified(metadata: &Metadata) -> u64 {
    let time = metadata.modified().unwrap_or(UNIX_EPOCH);
    nanoseconds(time)
}

fn nanoseconds(time: SystemTime) -> u64 {
    let since = time.duration_since(UNIX_EPOCH).unwrap_or_default();
    u64::try_from(since.as_nanos()).unwrap_or(u64::MAX)
}

impl Index {
    /// The index of a folder whose `bank.toml` has this text, empty where there is none to go on from; none where there is
    /// no place for one.
    pub(crate) fn of(folder: &Path, bank: &str) -> Option<Self> {
        // One index for a folder, by whatever way it is named.
        let folder = fs::canonicalize(folder).ok()?;
        let name = files::digest(folder.as_os_str().as_encoded_bytes());
        let mut index = Self {
            path: cache()?
                .join("banks")
                .join(format!("{}.index", &name[..32])),
            head: IndexHead {
                program: program(),
                folder,
                bank: Revision::of(bank),
                rows: String::new(),
            },
            text: String::new(),
            rows: BTreeMap::new(),
            noted: BTreeMap::new(),
            written: 0,
        };
        let _ = index.read();
        Some(index)
    }

    /// Takes up the rows of an earlier run, if they can be trusted.
    fn read(&mut self) -> Option<()> {
        let file = files::open(&self.path).ok()?;
        let metadata = file.metadata().ok()?;
        // In a cache that others may write to, rows could say anything of the items.
        if !is_own(&metadata) || metadata.len() > MAX_LENGTH {
            return None;
        }
        let mut text = String::new();
        file.take(MAX_LENGTH).read_to_string(&mut text).ok()?;
        let (head, rows) = text.split_once('\n')?;
        let mut head: IndexHead = serde_json::from_str(head).ok()?;
        if std::mem::take(&mut head.rows) != files::digest(rows.as_bytes()) || head != self.head {
            return None;
        }
        let mut start = text.len() - rows.len();
        for line in rows.lines() {
            let mut cells = line.splitn(3, '\t');
            let (id, stamp, listing) = (cells.next()?, cells.next()?, cells.next()?);
            let end = start + line.len();
            let row = IndexRow {
                stamp: Stamp::read(stamp)?,
                listing: end - listing.len()..end,
            };
            self.rows.insert(id.to_owned(), row);
            start = end + 1;
        }
        self.text = text;
        self.written = modified(&metadata);
        Some(())
    }

    /// Whether what is known of a file counts.
    pub(crate) fn knows(&self, id: &ItemId, stamp: &Stamp) -> bool {
        let is_racy = stamp.modified.saturating_add(RACY.as_nanos() as u64) >= self.written;
        !is_racy
            && self
                .rows
                .get(id.as_str())
                .is_some_and(|row| row.stamp == *stamp)
    }

    /// The rows that count, of files with these stamps.
    pub(crate) fn listings<'a>(
        &'a self,
        files: &'a [(ItemId, Stamp)],
    ) -> impl Iterator<Item = Listing> {
        files.iter().filter_map(|(id, stamp)| {
            let text = self.row(id, stamp)?;
            let listing: Listing = serde_json::from_str(text).ok()?;
            (listing.id == *id).then_some(listing)
        })
    }

    /// The listing of a file, as it is written.
    fn row(&self, id: &ItemId, stamp: &Stamp) -> Option<&str> {
        if let Some(noted) = self.noted.get(id) {
            return Some(noted);
        }
        let row = self.rows.get(id.as_str())?;
        self.knows(id, stamp)
            .then(|| &self.text[row.listing.clone()])
    }

    /// Notes what was read of a file.
    pub(crate) fn note(&mut self, listing: &Listing) {
        let text = serde_json::to_string(listing).expect("a row is plain data");
        self.noted.insert(listing.id.clone(), text);
    }

    /// Writes what was noted beside the rows that still count, if anything was, with the stamps that files had before they
    /// were read. An index that cannot be written is missing next time, and no failure.
    pub(crate) fn save(mut self, files: &[(ItemId, Stamp)]) {
        if self.noted.is_empty() {
            return;
        }
        let mut rows = String::new();
        for (id, stamp) in files {
            let Some(listing) = self.row(id, stamp) else {
                continue;
            };
            let Stamp {
                size,
                modified,
                changed,
                inode,
            } = stamp;
            let _ = writeln!(rows, "{id}\t{size} {modified} {changed} {inode}\t{listing}");
        }
        self.head.rows = files::digest(rows.as_bytes());
        let head = serde_json::to_string(&self.head).expect("a head is plain data");
        if let Some(folder) = self.path.parent()
            && make_private(folder)
        {
            let _ = files::write(
                &self.path,
                format!("{head}\n{rows}").as_bytes(),
                Access::Private,
            );
        }
    }
}

/// The folder of the user in which programs keep what they can make anew.
fn cache() -> Option<PathBuf> {
    if let Some(named) = setting(VARIABLE) {
        return (!named.is_empty()).then(|| PathBuf::from(named));
    }
    let usual = if cfg!(windows) {
        folder("LOCALAPPDATA")
    } else if cfg!(target_os = "macos") {
        folder("HOME").map(|home| home.join("Library").join("Caches"))
    } else {
        folder("XDG_CACHE_HOME").or_else(|| folder("HOME").map(|home| home.join(".cache")))
    };
    usual.map(|usual| usual.join("vibank"))
}

/// A folder that the environment names by its whole path.
fn folder(name: &str) -> Option<PathBuf> {
    setting(name)
        .map(PathBuf::from)
        .filter(|path| path.is_absolute())
}

/// This build of the program: one that was built anew may find other faults in the same item.
fn program() -> String {
    let own = std::env::current_exe().and_then(fs::metadata);
    let stamp = own.map_or((0, 0), |own| (own.len(), modified(&own)));
    format!("{} {} {}", env!("CARGO_PKG_VERSION"), stamp.0, stamp.1)
}

/// Whether a file is one that nobody else could have written.
fn is_own(metadata: &Metadata) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        // The owner of this process, where the system shows processes as files, or of the user's folder.
        let own = fs::metadata("/proc/self")
            .ok()
            .or_else(|| fs::metadata(setting("HOME")?).ok());
        metadata.is_file()
            && metadata.mode() & 0o022 == 0
            && own.is_none_or(|own| own.uid() == metadata.uid())
    }
    #[cfg(not(unix))]
    metadata.is_file()
}

/// Makes a folder that its owner alone may look into, where the system knows that; whether it is there.
fn make_private(folder: &Path) -> bool {
    let mut builder = fs::DirBuilder::new();
    builder.recursive(true);
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
    builder.create(folder).is_ok()
}
