//! The files, pages and entries of a student's sheets.

use std::collections::BTreeSet;

use vibank::worksheet::Manifest;

use super::{Task, entries, runs};
use crate::cli::folder::{Folder, is_plain};
use crate::cli::sheet::MANIFESTS;
use crate::cli::{Failure, files, form, record};

/// Removes the student's files, pages and entries.
pub(crate) fn remove(
    task: &mut Task,
    out: &Folder,
    manifests: Vec<(String, Manifest)>,
) -> Result<(), Failure> {
    let (own, others): (Vec<_>, Vec<_>) =
        entries(&manifests).partition(|entry| task.person.has(entry));
    // Figures belong to all who have the same one.
    let shared = others.iter().flat_map(|entry| entry.files.keys());
    let shared: BTreeSet<&String> = shared.collect();
    let own: BTreeSet<String> = own
        .iter()
        .flat_map(|entry| entry.files.keys())
        .filter(|file| is_plain(file) && !shared.contains(file))
        .cloned()
        .collect();
    let codes = entries(&manifests).filter(|entry| task.person.has(entry));
    let pages = codes.flat_map(|entry| {
        [form::PAGES, form::SCREEN].map(|folder| format!("{folder}{}.html", entry.code))
    });
    let own: BTreeSet<String> = own.into_iter().chain(pages).collect();
    for run in runs(out) {
        for file in &own {
            task.remove(out, &format!("{run}{file}"))?;
        }
    }
    for (name, mut manifest) in manifests {
        cut(task, out, &mut manifest)?;
        let before = manifest.variants.len();
        manifest.variants.retain(|entry| !task.person.has(entry));
        let count = before - manifest.variants.len();
        task.note(count, ["entry", "entries"], &name);
        renew(task, out, &name, manifest)?;
    }
    Ok(())
}

/// Cuts the student's pages out of the files that all sheets share.
///
/// One that was edited, or made by another run, is left: the search in the end finds it.
fn cut(task: &mut Task, out: &Folder, manifest: &mut Manifest) -> Result<(), Failure> {
    let own = manifest
        .variants
        .iter()
        .filter(|entry| task.person.has(entry));
    let pages: Vec<(String, (u64, u64))> = own.flat_map(|entry| entry.pages.clone()).collect();
    let names: BTreeSet<&String> = pages.iter().map(|(name, _)| name).collect();
    for name in names {
        let digest = manifest.files.get(name);
        if !digest.is_some_and(|digest| out.is_intact(name, digest)) {
            continue;
        }
        let whole = files::read_bytes(&out.path(name)?)?;
        let own = pages.iter().filter(|(file, _)| file == name);
        let mut places: Vec<(u64, u64)> = own.map(|(_, place)| *place).collect();
        places.sort_unstable();
        let Some(rest) = without(&whole, &places) else {
            continue;
        };
        task.write(out, name, &rest)?;
        manifest.files.insert(name.clone(), files::digest(&rest));
        for entry in &mut manifest.variants {
            if let Some((start, _)) = entry.pages.get_mut(name) {
                let before = places.iter().filter(|(own, _)| *own < *start);
                *start -= before.map(|(_, length)| length).sum::<u64>();
            }
        }
        task.note(places.len(), ["page", "pages"], name);
    }
    Ok(())
}

/// Writes a manifest anew where it has changed; an earlier one is named after its digest.
fn renew(task: &Task, out: &Folder, name: &str, mut manifest: Manifest) -> Result<(), Failure> {
    if let Some((before, after)) = &task.form
        && manifest.form == *before
    {
        manifest.form.clone_from(after);
    }
    let text = record::written(manifest);
    if files::read(&out.path(name)?)? == text {
        return Ok(());
    }
    let new = match name.strip_prefix(MANIFESTS) {
        Some(_) => format!("{MANIFESTS}/{}.json", &files::digest(text.as_bytes())[..16]),
        None => name.to_owned(),
    };
    task.write(out, &new, text.as_bytes())?;
    if new != name && !task.is_dry {
        out.remove(name)?;
    }
    Ok(())
}

/// What is left without some places, which are in order; nothing where they are none of it, or overlap.
fn without(whole: &[u8], places: &[(u64, u64)]) -> Option<Vec<u8>> {
    let (mut rest, mut at) = (Vec::with_capacity(whole.len()), 0);
    for (start, length) in places {
        let start = usize::try_from(*start).ok()?;
        rest.extend_from_slice(whole.get(at..start)?);
        at = start.checked_add(usize::try_from(*length).ok()?)?;
    }
    rest.extend_from_slice(whole.get(at..)?);
    Some(rest)
}
