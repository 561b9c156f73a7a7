//! What a folder holds that a run must not overwrite: files that somebody has edited, answers and marks.
//!
//! A manifest is never replaced: sheets that were printed from it can be marked as long as it is there.

use super::known::Held;
use super::stamp::Stamp;
use crate::cli::folder::Folder;
use crate::cli::record::FORM;
use crate::cli::shard::Shard;
use crate::cli::{Failure, files, table};

/// Where manifests of earlier runs are kept, under their digests.
pub(crate) const MANIFESTS: &str = "manifests";
/// Where copies of what was overwritten are kept.
pub(crate) const KEPT: &str = "kept";
/// Where `vibank grade` writes to if it is given no other folder.
pub(crate) const MARKS: &str = "marks";

/// Makes room for a run: keeps what is to be kept, or refuses.
///
/// With `force` what somebody has edited is moved to a folder of its own.
pub(crate) fn make_room(
    out: &Folder,
    held: Option<&Held>,
    stamp: &Stamp,
    shard: Shard,
    force: bool,
) -> Result<(), Failure> {
    let name = shard.named("manifest", "json");
    let is_other = held.is_none_or(|held| held.inputs() != stamp.inputs);
    let mut precious: Vec<(String, &str)> = Vec::new();
    let edited = held.into_iter().flat_map(Held::all_files);
    let edited = edited.filter(|(file, digest)| {
        // A file that could not be printed has no digest.
        !digest.is_empty() && out.has(file) && !out.is_intact(file, digest)
    });
    precious.extend(edited.map(|(file, _)| (file.clone(), "was edited since it was made")));
    if is_other && shard.is_whole() {
        if is_filled_in(out, held)? {
            precious.push((FORM.to_owned(), "has answers or was edited"));
        }
        if out.has(&format!("{MARKS}/results.json")) {
            precious.push((MARKS.to_owned(), "holds marks of this run"));
        }
    }
    if !precious.is_empty() && !force {
        return Err(refusal(out, &precious, is_other));
    }
    let digest = match held {
        Some(_) => files::digest_of(&out.path(&name)?)?[..16].to_owned(),
        None => "before".to_owned(),
    };
    if !precious.is_empty() {
        let mut names = (1..).map(|number| match number {
            1 => format!("{KEPT}/{digest}"),
            _ => format!("{KEPT}/{digest}-{number}"),
        });
        let kept = names
            .find(|place| !out.has(place))
            .expect("there are names without end");
        for (file, _) in &precious {
            out.rename(file, &format!("{kept}/{file}"))?;
        }
        eprintln!(
            "a copy of what was there is kept in {}",
            out.root().join(&kept).display()
        );
    }
    if held.is_some() && is_other {
        let place = format!("{MANIFESTS}/{digest}.json");
        if out.has(&place) {
            // Named after what is in it.
            out.remove(&name)?;
        } else {
            out.rename(&name, &place)?;
        }
    }
    Ok(())
}

/// Whether a form is to be left as it is: there are answers in it, to the sheets that are made.
pub(crate) fn keeps_form(
    out: &Folder,
    held: Option<&Held>,
    stamp: &Stamp,
) -> Result<bool, Failure> {
    let is_same = held.is_some_and(|held| held.inputs() == stamp.inputs);
    Ok(is_same && is_filled_in(out, held)?)
}

/// Whether somebody has written into the form for the answers.
fn is_filled_in(out: &Folder, held: Option<&Held>) -> Result<bool, Failure> {
    if !out.has(FORM) {
        return Ok(false);
    }
    let digest = held.map_or("", Held::form);
    if !digest.is_empty() {
        return Ok(!out.is_intact(FORM, digest));
    }
    // Written by the first version, which noted no digest, or by somebody else.
    let text = files::read(&out.path(FORM)?)?;
    let mut reader = csv::ReaderBuilder::new()
        .flexible(true)
        .delimiter(table::delimiter(&text))
        .from_reader(text.as_bytes());
    let column = reader
        .headers()
        .ok()
        .and_then(|names| names.iter().position(|name| name == "response"));
    let Some(column) = column else {
        return Ok(true);
    };
    Ok(reader.records().any(|row| {
        row.is_err()
            || row.is_ok_and(|row| row.get(column).is_some_and(|cell| !cell.trim().is_empty()))
    }))
}

fn refusal(out: &Folder, precious: &[(String, &str)], is_other: bool) -> Failure {
    // Enough to see what is at stake, with the help below still on the screen.
    const MAX_COUNT: usize = 20;
    let shown = out.root().display();
    let mut list: Vec<String> = precious
        .iter()
        .take(MAX_COUNT)
        .map(|(file, why)| format!("  {file}: {why}"))
        .collect();
    if precious.len() > MAX_COUNT {
        list.push(format!("  and {} more", precious.len() - MAX_COUNT));
    }
    let why = if is_other {
        "other sheets would be made than those that it holds"
    } else {
        "what it holds would be made again"
    };
    Failure::new(format!(
        "`{shown}` holds work that would be overwritten, since {why}:\n{}",
        list.join("\n")
    ))
    .help(
        "give another folder with `--out`, move these files away, or add `--force`, which keeps a copy of them",
    )
}
