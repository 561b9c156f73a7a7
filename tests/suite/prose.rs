//! The prose of the bank: what is said again and again teaches nothing.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use toml::Value;

/// Words outside of formulas from which on a sentence says something of its own; "Check:" or "With the data" does not.
const FEWEST_WORDS: usize = 5;

/// Solutions in which one sentence may occur: two of a pair, as for two modes.
const MAX_SOLUTIONS: usize = 2;

/// Parts with one hint; a question that three items ask alike may have the same nudge.
const MAX_HINTS: usize = 3;

fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).expect("it is a folder") {
        let path = entry.expect("it can be listed").path();
        if path.is_dir() {
            found.extend(files(&path, ending));
        } else if path.extension().is_some_and(|own| own == ending) {
            found.push(path);
        }
    }
    found.sort();
    found
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The texts of a field: one, several, or alternatives with their conditions.
fn texts(value: &Value) -> Vec<&str> {
    match value {
        Value::String(text) => vec![text],
        Value::Array(all) => all.iter().flat_map(texts).collect(),
        Value::Table(table) => table.get("text").map(texts).unwrap_or_default(),
        _ => Vec::new(),
    }
}

/// The parts of an item with the blanks in them.
fn parts(item: &Value) -> Vec<&Value> {
    let mut found = Vec::new();
    for part in item
        .get("part")
        .and_then(Value::as_array)
        .into_iter()
        .flatten()
    {
        found.push(part);
        found.extend(
            part.get("blank")
                .and_then(Value::as_array)
                .into_iter()
                .flatten(),
        );
    }
    found
}

/// A text without its formulas and placeholders.
fn words_of(text: &str) -> usize {
    let mut plain = String::new();
    for (at, piece) in text.split('$').enumerate() {
        if at % 2 == 0 {
            plain.push_str(piece);
            plain.push(' ');
        }
    }
    let words = plain.split(|letter: char| !letter.is_alphabetic() && letter != '’');
    words.filter(|word| word.chars().count() > 1).count()
}

/// The sentences that say something, placeholders apart.
fn sentences(text: &str) -> Vec<String> {
    let mut plain = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once("<<") {
        plain.push_str(before);
        rest = after.split_once(">>").map_or("", |(_, after)| after);
    }
    plain.push_str(rest);
    let mut found = Vec::new();
    let mut sentence = String::new();
    for word in plain.split_whitespace() {
        sentence.push_str(word);
        sentence.push(' ');
        if word.ends_with(['.', ':', ';', '?', '!']) {
            found.push(std::mem::take(&mut sentence));
        }
    }
    found.push(sentence);
    found.retain(|sentence| words_of(sentence) >= FEWEST_WORDS);
    found
}

/// What occurs more often than it may, with where.
fn repeated(places: BTreeMap<String, Vec<String>>, most: usize) -> Vec<String> {
    let often = places.into_iter().filter(|(_, places)| places.len() > most);
    often
        .map(|(text, places)| format!("{text}: {}", places.join(", ")))
        .collect()
}

#[test]
fn no_sentence_is_said_again_and_again() {
    let (mut said, mut hinted) = (BTreeMap::new(), BTreeMap::new());
    for path in files(&root().join("bank"), "toml") {
        let text = std::fs::read_to_string(&path).expect("it is text");
        let item = Value::Table(text.parse().expect("it is TOML"));
        let name = path
            .file_stem()
            .expect("a name")
            .to_string_lossy()
            .into_owned();
        for part in parts(&item) {
            let id = ["id", "key"].iter().find_map(|key| part.get(key)?.as_str());
            let place = format!("{name}/{}", id.unwrap_or("?"));
            let mut own: Vec<String> = Vec::new();
            for text in part.get("solution").map(texts).unwrap_or_default() {
                own.extend(sentences(text));
            }
            own.sort();
            own.dedup();
            for sentence in own {
                said.entry(sentence)
                    .or_insert_with(Vec::new)
                    .push(place.clone());
            }
            for hint in part.get("hints").map(texts).unwrap_or_default() {
                let hint = hint.split_whitespace().collect::<Vec<_>>().join(" ");
                hinted
                    .entry(hint)
                    .or_insert_with(Vec::new)
                    .push(place.clone());
            }
        }
    }
    assert!(
        said.len() > 500 && hinted.len() > 500,
        "{} {}",
        said.len(),
        hinted.len()
    );
    let mut faults = repeated(said, MAX_SOLUTIONS);
    faults.extend(repeated(hinted, MAX_HINTS));
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn a_sentence_without_its_placeholders_is_compared() {
    let found = sentences(
        "With the data << M >>. The row of the matrix adds up to zero: check $x = 1$ and",
    );
    assert_eq!(found, ["The row of the matrix adds up to zero: "]);
    let places = |text: &str| {
        (
            text.to_owned(),
            vec!["a".to_owned(), "b".to_owned(), "c".to_owned()],
        )
    };
    assert_eq!(repeated([places("It is.")].into(), 2), ["It is.: a, b, c"]);
    assert!(repeated([places("It is.")].into(), 3).is_empty());
}
