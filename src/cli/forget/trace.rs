//! Who is to be forgotten, and where something still tells of them.

use std::collections::BTreeSet;

use vibank::worksheet::{Manifest, VariantEntry};

use super::entries;
use crate::cli::files;
use crate::cli::folder::Folder;
use crate::cli::table::composed;

/// A student, as the manifests of a run know them.
pub(crate) struct Person {
    /// The `id` in the class list; none where the run has pseudonyms.
    pub(crate) id: Option<String>,
    names: BTreeSet<String>,
    /// The codes of their sheets that are nobody else's.
    pub(crate) codes: BTreeSet<String>,
}

/// The `id` of the student of a sheet, in the spelling of a list that is read today: an early version kept accents that
/// were letters of their own.
fn id_of(entry: &VariantEntry) -> Option<String> {
    Some(composed(entry.student.as_ref()?.get("id")?.clone()))
}

impl Person {
    /// A student by `id` or by the code of a sheet.
    pub(crate) fn find(manifests: &[(String, Manifest)], wanted: &str) -> Option<Self> {
        let code = wanted.trim().to_uppercase();
        let typed = composed(wanted.to_owned());
        let id = if entries(manifests).any(|entry| id_of(entry).as_ref() == Some(&typed)) {
            Some(typed)
        } else {
            let found = entries(manifests).find(|entry| entry.code == code)?;
            id_of(found)
        };
        let mut person = Self {
            codes: BTreeSet::from_iter(id.is_none().then_some(code)),
            id,
            names: BTreeSet::new(),
        };
        let (own, others): (Vec<_>, Vec<_>) =
            entries(manifests).partition(|entry| person.has(entry));
        let names = own
            .iter()
            .filter_map(|entry| entry.student.as_ref()?.get("name"));
        person.names = names.map(|name| composed(name.trim().to_owned())).collect();
        person.names.remove("");
        // The first version gave codes by the row of the list: one may have been another student's in another run.
        let shared: BTreeSet<&String> = others.iter().map(|entry| &entry.code).collect();
        let codes = own.iter().map(|entry| &entry.code);
        person.codes = codes
            .filter(|code| !shared.contains(code))
            .cloned()
            .collect();
        Some(person)
    }

    /// Whether a sheet is theirs.
    pub(crate) fn has(&self, entry: &VariantEntry) -> bool {
        match id_of(entry) {
            Some(id) => self.id == Some(id),
            None => self.codes.contains(&entry.code),
        }
    }

    /// Whether a row or an entry with this code and this student is theirs.
    pub(crate) fn is_own(&self, code: &str, student: &str) -> bool {
        match &self.id {
            Some(id) if !student.is_empty() => id == student,
            _ => self.codes.contains(code),
        }
    }

    /// Whether a name is theirs.
    pub(crate) fn is_named(&self, name: &str) -> bool {
        self.names.contains(&composed(name.trim().to_owned()))
    }

    /// What of them a text contains.
    pub(crate) fn trace(&self, text: &str) -> Option<&'static str> {
        let text = &composed(text.to_owned());
        if self.names.iter().any(|name| has_word(text, name)) {
            Some("the name")
        } else if self.id.iter().any(|id| has_word(text, id)) {
            Some("the id")
        } else if self.codes.iter().any(|code| has_word(text, code)) {
            Some("the code, without id and name")
        } else {
            None
        }
    }

    /// Files of a folder with something of them, and those that cannot be looked through.
    pub(crate) fn traces(&self, folder: &Folder, inside: &str, left: &mut BTreeSet<String>) {
        for name in folder.names(inside) {
            let name = if inside.is_empty() {
                name
            } else {
                format!("{inside}/{name}")
            };
            let Ok(path) = folder.path(&name) else {
                left.insert(format!("{name}: a link, which is not followed"));
                continue;
            };
            if path.is_dir() {
                self.traces(folder, &name, left);
                continue;
            }
            let is_packed = [".pdf", ".xlsx"].iter().any(|end| name.ends_with(end));
            let is_whole = ["key-table", "marks."].iter().any(|own| name.contains(own));
            let bytes = files::read_bytes(&path).unwrap_or_default();
            let found = self.trace(&String::from_utf8_lossy(&bytes));
            let shown = path.display();
            if let Some(found) = found {
                left.insert(format!("{shown}: {found}"));
            } else if is_packed && is_whole {
                left.insert(format!("{shown}: packed, and not looked through"));
            }
        }
    }
}

/// Whether a word is in a text with no letter or digit beside it, and not in the base 64 of a font.
fn has_word(text: &str, word: &str) -> bool {
    let is_free = |sign: Option<char>| {
        !sign.is_some_and(|sign| sign.is_alphanumeric() || "+/=".contains(sign))
    };
    text.match_indices(word).any(|(at, word)| {
        is_free(text[..at].chars().next_back()) && is_free(text[at + word.len()..].chars().next())
    })
}
