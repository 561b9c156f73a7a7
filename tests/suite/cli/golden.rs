//! What earlier versions wrote is read by this one: blueprints, banks, manifests, responses, and programs that read JSON.

use std::path::PathBuf;

use serde_json::Value as Json;

use super::{content, fed, folder, text_of, vibank};

/// The folders of earlier versions.
fn versions() -> Vec<PathBuf> {
    let golden = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden");
    let entries = std::fs::read_dir(golden).expect("they are kept");
    let paths = entries.map(|entry| entry.expect("it can be listed").path());
    let mut versions: Vec<PathBuf> = paths.filter(|path| path.is_dir()).collect();
    versions.sort();
    assert!(!versions.is_empty(), "no version is kept in {golden}");
    versions
}

/// How closely a new value has to follow an old one.
#[derive(Clone, Copy, PartialEq)]
enum Kept {
    /// The same fields, of the same kind.
    Fields,
    /// The same fields with the same values, but for words that are written for people.
    Values,
}

/// Fields whose words may be improved, and the codes of reasons, to which finer ones may be added.
const WORDS: [&str; 7] = [
    "reading", "text", "latex", "message", "feedback", "reasons", "title",
];

/// What later versions changed on purpose, by the end of the place and version; `CHANGELOG.md` names each under
/// *Changed*.
const EXCEPTIONS: [(&str, &str); 9] = [
    // A response that could not be read is undecided, which is not the same as 0 points.
    (".credit was 0.0, is null", "0.1.0"),
    (".points was 0.0, is null", "0.1.0"),
    // Like unreadable responses are one entry, with the sheets that gave them.
    (".unreadable[0].code is gone", "0.1.0"),
    (".unreadable[0].student is gone", "0.1.0"),
    (".unreadable[0].place is gone", "0.1.0"),
    // Sheets with undecided parts are left out of the reliability: of two sheets none is left.
    (".reliability was 0.9292929292929292, is null", "0.1.0"),
    (".measurement_error was 2.068278940998478, is null", "0.1.0"),
    // The key of a function of time had empty lists of values, and has its text now.
    (".key.at is gone", "0.1.0"),
    (".key.si is gone", "0.1.0"),
];

/// Fields of an old reply that are lacking or different in a new one; new fields may be added.
fn lost(old: &Json, new: &Json, kept: Kept, place: &str, losses: &mut Vec<String>) {
    match (old, new) {
        (Json::Object(old), Json::Object(new)) => {
            for (key, value) in old {
                let place = format!("{place}.{key}");
                let kept = if WORDS.contains(&&**key) {
                    Kept::Fields
                } else {
                    kept
                };
                match new.get(key) {
                    Some(found) => lost(value, found, kept, &place, losses),
                    None => losses.push(format!("{place} is gone")),
                }
            }
        }
        (Json::Array(old), Json::Array(new)) => {
            if kept == Kept::Values && old.len() != new.len() {
                losses.push(format!("{place} had {} entries: {new:?}", old.len()));
            }
            for (number, (old, new)) in old.iter().zip(new).enumerate() {
                lost(old, new, kept, &format!("{place}[{number}]"), losses);
            }
        }
        (Json::Number(old), Json::Number(new)) => {
            let (old, new) = (old.as_f64().unwrap(), new.as_f64().unwrap());
            // Results differ between versions by a few units in the last place.
            if kept == Kept::Values && (old - new).abs() > 1e-12 * old.abs() {
                losses.push(format!("{place} was {old}, is {new}"));
            }
        }
        (old, new) => {
            let is_same_kind = std::mem::discriminant(old) == std::mem::discriminant(new);
            if !is_same_kind || kept == Kept::Values && old != new {
                losses.push(format!("{place} was {old}, is {new}"));
            }
        }
    }
}

/// Fails with what is lost between two texts of JSON, line by line.
#[track_caller]
fn keeps<'t>(
    old: impl Iterator<Item = &'t str>,
    new: impl Iterator<Item = &'t str>,
    kept: Kept,
    what: &str,
) {
    let (old, new): (Vec<&str>, Vec<&str>) = (old.collect(), new.collect());
    assert_eq!(old.len(), new.len(), "{what} has as many lines");
    let mut losses = Vec::new();
    for (number, (old, new)) in old.iter().zip(new).enumerate() {
        let [old, new] = [*old, new].map(|text| serde_json::from_str(text).expect("it is JSON"));
        let place = format!("{what}:{}", number + 1);
        lost(&old, &new, kept, &place, &mut losses);
    }
    losses.retain(|loss| !EXCEPTIONS.iter().any(|(end, _)| loss.ends_with(end)));
    assert!(losses.is_empty(), "{}", losses.join("\n"));
}

/// A sheet that was handed out years ago is marked as it would have been then.
#[test]
fn runs_of_earlier_versions_are_marked_with_the_same_result() {
    for version in versions() {
        let file = |name: &str| text_of(&version.join(name));
        let out = folder("golden-marks");
        vibank(&[
            "grade",
            &file("manifest.json"),
            &file("responses.csv"),
            "--bank",
            &file("bank"),
            "--out",
            &text_of(&out),
        ])
        .ends(0);
        let pair = |name: &str| (content(version.join(name)), content(out.join(name)));
        let (old, new) = pair("results.json");
        keeps(
            [&*old].into_iter(),
            [&*new].into_iter(),
            Kept::Values,
            "results.json",
        );
        let (old, new) = pair("report.json");
        keeps(
            [&*old].into_iter(),
            [&*new].into_iter(),
            Kept::Fields,
            "report.json",
        );
        let (old, new) = pair("marks.csv");
        let column = |text: &str, name: &str| -> Vec<String> {
            let mut lines = text.lines().map(|line| line.split(',').map(str::to_owned));
            let place = lines
                .next()
                .and_then(|mut head| head.position(|cell| cell == name))
                .unwrap_or_else(|| panic!("marks.csv has no column {name}"));
            lines.map(|mut cells| cells.nth(place).unwrap()).collect()
        };
        // Points that are still open come after those that are settled, `27 + ?1`; they counted as none in 0.1.0.
        let settled = |cells: Vec<String>| -> Vec<String> {
            let settle = |cell: String| match cell.split_once('?') {
                Some(("", _)) => "0".to_owned(),
                Some((settled, _)) => settled.trim_end_matches([' ', '+']).to_owned(),
                None => cell,
            };
            cells.into_iter().map(settle).collect()
        };
        for name in ["code", "points", "max", "1a", "5k"] {
            assert_eq!(
                column(&old, name),
                settled(column(&new, name)),
                "column {name}"
            );
        }
    }
}

/// A blueprint and a bank of an earlier version make sheets, and what programs read of them is there.
#[test]
fn blueprints_of_earlier_versions_make_sheets() {
    for version in versions() {
        let out = folder("golden-sheets");
        vibank(&[
            "sheet",
            &text_of(&version.join("midterm.toml")),
            "--bank",
            &text_of(&version.join("bank")),
            "--out",
            &text_of(&out),
        ])
        .ends(0);
        let (old, new) = (
            content(version.join("sheets.jsonl")),
            content(out.join("sheets.jsonl")),
        );
        keeps(old.lines(), new.lines(), Kept::Fields, "sheets.jsonl");
    }
}

/// Programs that were written against an earlier version find what they read.
#[test]
fn replies_keep_the_fields_and_values_of_earlier_versions() {
    for version in versions() {
        let bank = text_of(&version.join("bank"));
        for command in ["solve", "mark", "compute"] {
            let requests = content(version.join(format!("{command}.requests.jsonl")));
            let replies = content(version.join(format!("{command}.replies.jsonl")));
            let mut arguments = vec![command, "--jsonl"];
            if command != "compute" {
                arguments.extend(["--bank", &bank]);
            }
            let ran = fed(&arguments, requests.into_bytes());
            keeps(replies.lines(), ran.out.lines(), Kept::Values, command);
        }
    }
}

/// The comparison itself sees what is gone, what has another kind, and what has another value.
#[test]
fn losses_are_seen() {
    let losses = |old: &str, new: &str, kept| {
        let [old, new] = [old, new].map(|text| serde_json::from_str(text).expect("it is JSON"));
        let mut losses = Vec::new();
        lost(&old, &new, kept, "", &mut losses);
        losses.len()
    };
    let old = r#"{"a":1,"b":["x"],"text":"s"}"#;
    assert_eq!(losses(old, old, Kept::Values), 0);
    let more = r#"{"a":1,"b":["x"],"text":"better","c":3}"#;
    assert_eq!(losses(old, more, Kept::Values), 0);
    assert_eq!(losses(old, r#"{"a":1,"b":["x"]}"#, Kept::Fields), 1);
    assert_eq!(
        losses(old, r#"{"a":"1","b":["x"],"text":null}"#, Kept::Fields),
        2
    );
    assert_eq!(losses(old, r#"{"a":2,"b":[],"text":"s"}"#, Kept::Values), 2);
    assert_eq!(losses(old, r#"{"a":2,"b":[],"text":"s"}"#, Kept::Fields), 0);
}
