//! What a folder already holds, by the manifests in it: what is intact and would come out the same is not made again.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{BufRead, BufReader};

use serde::Deserialize;
use vibank::worksheet::{Fixed, Plan, QuestionEntry, Student, VariantEntry};

use super::guard::MANIFESTS;
use super::stamp::Stamp;
use crate::cli::files;
use crate::cli::folder::{Folder, is_plain};
use crate::cli::shard::Shard;
use crate::cli::table::composed;

/// What the manifests of a folder say.
#[derive(Default)]
pub(crate) struct KnownFiles {
    manifests: BTreeMap<String, Held>,
    /// Of earlier runs, kept in a folder of their own.
    earlier: Vec<Held>,
}

/// What one manifest says.
#[derive(Default)]
pub(crate) struct Held {
    inputs: String,
    look: String,
    /// Files of the run, with their digests.
    files: BTreeMap<String, String>,
    /// Digest of the form for the answers; empty if the manifest notes none.
    form: String,
    /// By code.
    sheets: BTreeMap<String, HeldSheet>,
}

/// A sheet that was made.
pub(crate) struct HeldSheet {
    /// Digest of its entry, without its files.
    entry: String,
    files: BTreeMap<String, String>,
    /// Its place in the run.
    place: u64,
    /// Whose it is, and where that student sits, as far as the manifest says so.
    student: Option<(String, String)>,
    questions: Vec<QuestionEntry>,
    /// Whether it is not the first variant of the student.
    gave_way: bool,
}

/// The sheets that look as those of a run.
pub(crate) struct AlikeSheets<'k>(Vec<&'k Held>);

#[derive(Deserialize)]
struct ManifestHead {
    #[serde(default)]
    inputs: String,
    #[serde(default)]
    look: String,
}

#[derive(Deserialize)]
struct Foot {
    #[serde(default)]
    files: BTreeMap<String, String>,
    #[serde(default)]
    form: String,
}

impl KnownFiles {
    /// What the manifests of a folder say; one that cannot be read says nothing.
    pub(crate) fn in_folder(out: &Folder) -> Self {
        let mut known = Self::default();
        for name in out.names("") {
            let is_manifest = name == "manifest.json"
                || (name.starts_with("manifest-") && name.ends_with(".json"));
            if let Some(held) = is_manifest.then(|| Held::read(out, &name)).flatten() {
                known.manifests.insert(name, held);
            }
        }
        let earlier = out.names(MANIFESTS).into_iter();
        let earlier = earlier.filter(|name| name.ends_with(".json"));
        known.earlier = earlier
            .filter_map(|name| Held::read(out, &format!("{MANIFESTS}/{name}")))
            .collect();
        known
    }

    /// Whether the folder holds what a run would make, whole and unchanged.
    pub(crate) fn is_current(&self, out: &Folder, shard: Shard, stamp: &Stamp) -> bool {
        let held = self.manifests.get(&shard.named("manifest", "json"));
        held.is_some_and(|held| held.inputs == stamp.inputs && held.is_intact(out))
    }

    /// What the manifest of a part of the run says.
    pub(crate) fn of(&self, shard: Shard) -> Option<&Held> {
        self.manifests.get(&shard.named("manifest", "json"))
    }

    /// The sheets that students have already, by identity, as far as they follow from the seed or secret of the plan.
    ///
    /// Manifests of earlier runs count where later ones know nothing of a student. A run tries at most `tries` seeds for
    /// one.
    pub(crate) fn fixed(
        &self,
        plan: &Plan<'_>,
        students: &[Student],
        tries: u64,
    ) -> BTreeMap<String, Fixed> {
        let mut fixed = BTreeMap::new();
        for held in self.manifests.values().chain(&self.earlier) {
            let mut by_id = BTreeMap::new();
            for (code, sheet) in &held.sheets {
                if let Some((id, seat)) = &sheet.student {
                    by_id.insert(id.as_str(), (code, sheet, seat.as_str()));
                }
            }
            let has_pseudonyms = by_id.is_empty();
            for student in students {
                if fixed.contains_key(&student.id) {
                    continue;
                }
                let own = |attempt| plan.variant_of_student(&student.id, attempt);
                let found = match by_id.get(student.id.as_str()) {
                    Some((code, sheet, seat)) => {
                        // The first version drew variants by the place in the list.
                        let mut variants = (0..tries)
                            .flat_map(|attempt| [own(attempt), plan.variant(sheet.place, attempt)]);
                        let variant = variants.find(|variant| variant.to_string() == **code);
                        let now = seat_in(&student.room, &student.seat);
                        variant.map(|variant| (variant, *sheet, *seat != now))
                    }
                    None if has_pseudonyms => (0..tries).map(own).find_map(|variant| {
                        let sheet = held.sheets.get(&variant.to_string())?;
                        Some((variant, sheet, false))
                    }),
                    None => None,
                };
                if let Some((variant, sheet, has_moved)) = found {
                    let own =
                        Fixed::new(variant, &sheet.questions, has_moved).giving_way(sheet.gave_way);
                    fixed.insert(student.id.clone(), own);
                }
            }
        }
        fixed
    }

    /// The sheets whose pages depend on nothing but their entries, if these are the same.
    pub(crate) fn for_look(&self, look: &str) -> AlikeSheets<'_> {
        let alike = self.manifests.values().filter(|held| held.look == look);
        AlikeSheets(alike.collect())
    }

    /// Removes what earlier runs made here and this one did not, unless somebody has changed it: sheets that are
    /// not handed out any more, and the manifests and forms of the parts that are joined now.
    ///
    /// Files with an ending of `kept` stay, since this run could not renew them; their number is returned.
    pub(crate) fn tidy(&self, out: &Folder, shard: Shard, kept: &[&str]) -> usize {
        let own = shard.named("manifest", "json");
        let others = self.manifests.keys().filter(|name| **name != own);
        let stale = others.filter(|_| shard.is_whole());
        // A folder that was empty needs no look at what was written to it.
        if self.manifests.is_empty() {
            return 0;
        }
        let Some(made) = Held::read(out, &own) else {
            return 0;
        };
        let mut left = 0;
        let made: BTreeSet<&String> = made.all_files().map(|(file, _)| file).collect();
        for name in stale
            .clone()
            .chain(self.manifests.get_key_value(&own).map(|(own, _)| own))
        {
            for (file, digest) in self.manifests[name].all_files() {
                // A file that somebody has written into is theirs by now.
                if made.contains(file) || !out.is_intact(file, digest) {
                    continue;
                }
                let ending = std::path::Path::new(file)
                    .extension()
                    .and_then(|ending| ending.to_str());
                if ending.is_some_and(|ending| kept.contains(&ending)) {
                    left += 1;
                } else {
                    let _ = out.remove(file);
                }
            }
        }
        for name in stale {
            let _ = out.remove(name);
        }
        left
    }
}

impl Held {
    /// Reads a manifest line by line, as it was written.
    fn read(out: &Folder, name: &str) -> Option<Self> {
        let mut lines = BufReader::new(out.open(name).ok()?).lines();
        let head = lines.next()?.ok()?;
        // The first line ends in the open list of sheets, and is made whole to be read alone.
        let head: ManifestHead = serde_json::from_str(&format!("{head}]}}")).ok()?;
        let mut held = Self {
            inputs: head.inputs,
            look: head.look,
            ..Self::default()
        };
        for line in lines {
            let line = line.ok()?;
            if let Some(foot) = line.strip_prefix("],") {
                let foot: Foot = serde_json::from_str(&format!("{{{foot}")).ok()?;
                held.form = foot.form;
                held.files = foot
                    .files
                    .into_iter()
                    .filter(|(path, _)| is_plain(path))
                    .collect();
                return Some(held);
            }
            let entry: VariantEntry = serde_json::from_str(line.trim_end_matches(',')).ok()?;
            entry.check().ok()?;
            let digest = digest(&entry);
            let files = entry.files.into_iter().filter(|(path, _)| is_plain(path));
            let student = entry.student.as_ref().and_then(|student| {
                let [room, seat] =
                    ["room", "seat"].map(|name| student.get(name).map_or("", String::as_str));
                let seat = seat_in(room, seat);
                // Lists that were read by an early version may have accents of their own.
                Some((composed(student.get("id")?.clone()), seat))
            });
            let sheet = HeldSheet {
                entry: digest,
                files: files.collect(),
                place: held.sheets.len() as u64,
                student,
                gave_way: entry.gave_way,
                // Nobody has to keep a sheet that is nobody's.
                questions: if entry.student.is_some() {
                    entry.questions
                } else {
                    Vec::new()
                },
            };
            held.sheets.insert(entry.code, sheet);
        }
        None
    }

    /// Digest of everything that its run depends on.
    pub(crate) fn inputs(&self) -> &str {
        &self.inputs
    }

    /// Digest of the form for the answers; empty if the manifest notes none.
    pub(crate) fn form(&self) -> &str {
        &self.form
    }

    fn is_intact(&self, out: &Folder) -> bool {
        let mut files = self.all_files();
        files.all(|(file, digest)| out.is_intact(file, digest))
    }

    /// The files of the run and of its sheets, with their digests.
    pub(crate) fn all_files(&self) -> impl Iterator<Item = (&String, &String)> {
        let sheets = self.sheets.values().flat_map(|sheet| &sheet.files);
        self.files.iter().chain(sheets)
    }
}

impl AlikeSheets<'_> {
    /// The files of a sheet with this entry, if they are all intact.
    pub(crate) fn files(
        &self,
        out: &Folder,
        entry: &VariantEntry,
    ) -> Option<&BTreeMap<String, String>> {
        let same = |held: &&Held| {
            held.sheets
                .get(&entry.code)
                .is_some_and(|sheet| sheet.entry == digest(entry))
        };
        let sheet = &self.0.iter().find(|held| same(held))?.sheets[&entry.code];
        let mut files = sheet.files.iter();
        let is_intact =
            // A sheet without files of its own stands in files of the whole run, which are made anew in any
            // case.
            !sheet.files.is_empty() && files.all(|(file, digest)| out.is_intact(file, digest));
        is_intact.then_some(&sheet.files)
    }
}

/// The digest of an entry without its files and places.
fn digest(entry: &VariantEntry) -> String {
    let bare = VariantEntry {
        files: BTreeMap::new(),
        pages: BTreeMap::new(),
        ..entry.clone()
    };
    let text = serde_json::to_string(&bare).expect("an entry is plain data");
    files::digest(text.as_bytes())
}

/// A seat with its room: a change of either gives the student other neighbours.
fn seat_in(room: &str, seat: &str) -> String {
    // No cell of a class list has a line break.
    format!("{room}\n{seat}")
}
