//! Seeds: what the repository has of each kind of input, and what was found.

use std::fs;
use std::path::{Path, PathBuf};

/// The root of the repository.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// All files below a folder with one of these ends.
fn files(folder: &Path, ends: &[&str]) -> Vec<Vec<u8>> {
    let mut paths = Vec::new();
    let mut open = vec![folder.to_owned()];
    while let Some(folder) = open.pop() {
        for entry in fs::read_dir(&folder).into_iter().flatten().flatten() {
            let path = entry.path();
            if path.is_dir() {
                open.push(path);
            } else if ends.iter().any(|end| path.to_string_lossy().ends_with(end)) {
                paths.push(path);
            }
        }
    }
    paths.sort();
    paths.iter().filter_map(|path| fs::read(path).ok()).collect()
}

/// The texts between quotes of the bank's items, for targets that take one text.
fn texts_of(items: &[Vec<u8>]) -> Vec<Vec<u8>> {
    let texts = items.iter().flat_map(|item| {
        let text = String::from_utf8_lossy(item).into_owned();
        let pieces = text.split(['"', '\'']).map(|piece| piece.as_bytes().to_vec());
        pieces.filter(|piece| piece.len() > 3).collect::<Vec<_>>()
    });
    texts.collect()
}

fn lines(text: &str) -> Vec<Vec<u8>> {
    text.lines().map(|line| line.as_bytes().to_vec()).collect()
}

/// The seeds of a target: those of the repository, and what earlier campaigns found.
pub fn of(target: &str) -> Vec<Vec<u8>> {
    let root = root();
    let bank = || files(&root.join("bank"), &[".toml"]);
    let mut seeds = match target {
        "item" => {
            let mut items = bank();
            items.extend(files(&root.join("tests/fixtures"), &[".toml"]));
            items
        }
        "blueprint" => {
            let mut blueprints = files(&root.join("examples"), &[".toml"]);
            blueprints.extend(files(&root.join("templates"), &["blueprint.toml"]));
            blueprints
        }
        "text" => texts_of(&bank()),
        "answer" => {
            let mut typed = texts_of(&bank());
            for (number, text) in typed.iter_mut().enumerate() {
                text.insert(0, b' ' + (number % 90) as u8);
            }
            typed
        }
        "compute" => lines(include_str!("../../tests/fixtures/reference.jsonl")),
        "class_list" | "responses" | "manifest" | "page" | "workbook" => Vec::new(),
        _ => Vec::new(),
    };
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("seeds").join(target);
    seeds.extend(files(&own, &[""]));
    seeds.retain(|seed| !seed.is_empty());
    seeds
}
