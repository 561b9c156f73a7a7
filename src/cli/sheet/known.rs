//! What a folder already holds, by the manifests in it: what is intact and would come out the same is not made again.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;

use serde::Deserialize;
use vibank::worksheet::VariantEntry;

use super::shard::Shard;
use super::stamp::Stamp;
use crate::cli::files;

/// What the manifests of a folder say.
#[derive(Default)]
pub(crate) struct Known {
    manifests: BTreeMap<String, Held>,
}

/// What one manifest says.
#[derive(Default)]
struct Held {
    inputs: String,
    look: String,
    /// Files of the run, with their digests.
    files: BTreeMap<String, String>,
    /// By code.
    sheets: BTreeMap<String, HeldSheet>,
}

/// A sheet that was made.
pub(crate) struct HeldSheet {
    /// Digest of its entry, without its files.
    entry: String,
    files: BTreeMap<String, String>,
}

/// The sheets that look as those of a run.
pub(crate) struct Alike<'k>(Vec<&'k Held>);

#[derive(Deserialize)]
struct Head {
    #[serde(default)]
    inputs: String,
    #[serde(default)]
    look: String,
}

#[derive(Deserialize)]
struct Foot {
    #[serde(default)]
    files: BTreeMap<String, String>,
}

impl Known {
    /// What the manifests of a folder say; one that cannot be read says nothing.
    pub(crate) fn in_folder(out: &Path) -> Self {
        let mut known = Self::default();
        for entry in fs::read_dir(out).into_iter().flatten().flatten() {
            let name = entry.file_name().to_string_lossy().into_owned();
            let is_manifest = name == "manifest.json"
                || (name.starts_with("manifest-") && name.ends_with(".json"));
            if let Some(held) = is_manifest.then(|| Held::read(&entry.path())).flatten() {
                known.manifests.insert(name, held);
            }
        }
        known
    }

    /// Whether the folder holds what a run would make, whole and unchanged.
    pub(crate) fn is_current(&self, out: &Path, shard: Shard, stamp: &Stamp) -> bool {
        let held = self.manifests.get(&shard.named("manifest", "json"));
        held.is_some_and(|held| held.inputs == stamp.inputs && held.is_intact(out))
    }

    /// The sheets whose pages depend on nothing but their entries, if these are the same.
    pub(crate) fn for_look(&self, look: &str) -> Alike<'_> {
        let alike = self.manifests.values().filter(|held| held.look == look);
        Alike(alike.collect())
    }

    /// Removes what earlier runs made here and this one did not, unless somebody has changed it: sheets that are
    /// not handed out any more, and the manifests and forms of the parts that are joined now.
    ///
    /// Files with an ending of `kept` stay, since this run could not renew them; their number is returned.
    pub(crate) fn tidy(&self, out: &Path, shard: Shard, kept: &[&str]) -> usize {
        let own = shard.named("manifest", "json");
        let others = self.manifests.keys().filter(|name| **name != own);
        let stale = others.filter(|_| shard.is_whole());
        let Some(made) = Held::read(&out.join(&own)) else {
            return 0;
        };
        let mut left = 0;
        let made: BTreeSet<&String> = made.all_files().map(|(file, _)| file).collect();
        for name in stale
            .clone()
            .chain(self.manifests.get_key_value(&own).map(|(own, _)| own))
        {
            for (file, digest) in self.manifests[name].all_files() {
                if made.contains(file) || !files::is_intact(&out.join(file), digest) {
                    continue;
                }
                let ending = Path::new(file)
                    .extension()
                    .and_then(|ending| ending.to_str());
                if ending.is_some_and(|ending| kept.contains(&ending)) {
                    left += 1;
                } else {
                    let _ = fs::remove_file(out.join(file));
                }
            }
        }
        for name in stale {
            let _ = fs::remove_file(out.join(name));
        }
        left
    }
}

impl Held {
    /// Reads a manifest line by line, as it was written.
    fn read(path: &Path) -> Option<Self> {
        let mut lines = BufReader::new(fs::File::open(path).ok()?).lines();
        let head = lines.next()?.ok()?;
        let head: Head = serde_json::from_str(&format!("{head}]}}")).ok()?;
        let mut held = Self {
            inputs: head.inputs,
            look: head.look,
            ..Self::default()
        };
        for line in lines {
            let line = line.ok()?;
            if let Some(foot) = line.strip_prefix("],") {
                let foot: Foot = serde_json::from_str(&format!("{{{foot}")).ok()?;
                held.files = foot
                    .files
                    .into_iter()
                    .filter(|(path, _)| is_inside(path))
                    .collect();
                return Some(held);
            }
            let entry: VariantEntry = serde_json::from_str(line.trim_end_matches(',')).ok()?;
            let digest = digest(&entry);
            let files = entry.files.into_iter().filter(|(path, _)| is_inside(path));
            let sheet = HeldSheet {
                entry: digest,
                files: files.collect(),
            };
            held.sheets.insert(entry.code, sheet);
        }
        None
    }

    fn is_intact(&self, out: &Path) -> bool {
        let mut files = self.all_files();
        files.all(|(file, digest)| files::is_intact(&out.join(file), digest))
    }

    /// The files of the run and of its sheets, with their digests.
    fn all_files(&self) -> impl Iterator<Item = (&String, &String)> {
        let sheets = self.sheets.values().flat_map(|sheet| &sheet.files);
        self.files.iter().chain(sheets)
    }
}

impl Alike<'_> {
    /// The files of a sheet with this entry, if they are all intact.
    pub(crate) fn files(
        &self,
        out: &Path,
        entry: &VariantEntry,
    ) -> Option<&BTreeMap<String, String>> {
        let same = |held: &&Held| {
            held.sheets
                .get(&entry.code)
                .is_some_and(|sheet| sheet.entry == digest(entry))
        };
        let sheet = &self.0.iter().find(|held| same(held))?.sheets[&entry.code];
        let mut files = sheet.files.iter();
        let is_intact = !sheet.files.is_empty()
            && files.all(|(file, digest)| files::is_intact(&out.join(file), digest));
        is_intact.then_some(&sheet.files)
    }
}

/// The digest of an entry without its files.
fn digest(entry: &VariantEntry) -> String {
    let bare = VariantEntry {
        files: BTreeMap::new(),
        ..entry.clone()
    };
    let text = serde_json::to_string(&bare).expect("an entry is plain data");
    files::digest(text.as_bytes())
}

/// Whether a path of a manifest stays inside its folder.
fn is_inside(path: &str) -> bool {
    let mut steps = Path::new(path).components();
    steps.all(|step| matches!(step, std::path::Component::Normal(_)))
}
