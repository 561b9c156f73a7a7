//! Every command and every file that the book shows is run, or says why not.
//!
//! A block that cannot be run here stands below `<!-- not run: REASON -->`. Blocks within generated parts
//! are made by running them.

mod commands;
mod files;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use super::{BEGIN, END, pages};

/// A block of code on a page.
struct Block {
    page: PathBuf,
    language: String,
    text: String,
}

impl Block {
    fn place(&self) -> String {
        let first = self.text.lines().next().unwrap_or_default();
        format!("{}: {first}", self.page.display())
    }

    fn is_on(&self, page: &str) -> bool {
        self.page.ends_with(page)
    }
}

/// All blocks that somebody typed and that are to be run.
fn blocks() -> Vec<Block> {
    let outside = ["README.md", "CONTRIBUTING.md"].map(PathBuf::from);
    let mut found = Vec::new();
    for page in pages().into_iter().chain(outside) {
        let text = fs::read_to_string(&page).unwrap();
        let (mut is_made, mut is_excused) = (false, false);
        let mut lines = text.lines();
        while let Some(line) = lines.next() {
            is_made |= line.starts_with(BEGIN.trim_start());
            is_made &= !line.starts_with(END);
            if let Some(reason) = line.strip_prefix("<!-- not run: ") {
                assert!(reason.len() > 8, "{}: {line}", page.display());
                is_excused = true;
            } else if let Some(language) = line.strip_prefix("```") {
                let inside = lines.by_ref().take_while(|line| !line.starts_with("```"));
                let text: String = inside.map(|line| format!("{line}\n")).collect();
                if !is_made && !is_excused {
                    found.push(Block {
                        page: page.clone(),
                        language: language.to_owned(),
                        text,
                    });
                }
                is_excused = false;
            }
        }
    }
    found
}

fn put(path: PathBuf, text: &str) {
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

/// A folder in which the commands of the book can be run, with the midterm of the examples made.
fn workplace() -> &'static Path {
    &prepared().0
}

/// The folder, and what making the midterm printed.
fn prepared() -> &'static (PathBuf, String) {
    static PLACE: OnceLock<(PathBuf, String)> = OnceLock::new();
    PLACE.get_or_init(|| {
        let place = Path::new(env!("CARGO_TARGET_TMPDIR")).join("book");
        let _ = fs::remove_dir_all(&place);
        // Pages alone: PDF is printed by tests of its own.
        let midterm: String = include_str!("../../../../examples/midterm.toml")
            .lines()
            .map(|line| {
                if line.starts_with("variants") {
                    format!("{line}\nformats = [\"html\"]\n")
                } else {
                    format!("{line}\n")
                }
            })
            .collect();
        put(place.join("examples/midterm.toml"), &midterm);
        put(place.join("midterm.toml"), &midterm);
        put(place.join("exam.key"), "sixteen bytes are the least\n");
        put(
            place.join("class.csv"),
            "id,name,seat\n1042,Ada,A1\n1043,Émilie,A2\n",
        );
        put(
            place.join("exam.toml"),
            &first_toml("book/src/teachers/first-exam.md").replace("= 30", "= 2"),
        );
        put(
            place.join("requests.jsonl"),
            "{\"id\": \"ch2/e8-springs-parallel-series\", \"set\": {\"k1\": 200}}\n",
        );
        put(
            place.join("bank/ch2/disk-on-a-wire.toml"),
            include_str!("../../../fixtures/book/disk-on-a-wire.toml"),
        );
        put(
            place.join("bank/bank.toml"),
            include_str!("../../../../bank/bank.toml"),
        );
        put(
            place.join("bank/ch2/_chapter.toml"),
            "title = \"Free\"\nnumber = 2\n",
        );
        let printed = run(&place, "vibank sheet examples/midterm.toml").unwrap();
        (place, printed)
    })
}

fn first_toml(page: &str) -> String {
    let text = fs::read_to_string(page).unwrap();
    let (_, rest) = text.split_once("```toml\n").unwrap();
    rest.split("```").next().unwrap().to_owned()
}

/// Runs a line as a shell does; what it printed.
fn run(place: &Path, line: &str) -> Result<String, String> {
    let program = Path::new(env!("CARGO_BIN_EXE_vibank"));
    let path = std::env::var("PATH").unwrap_or_default();
    // However the program is started from a clone, here it is the one under test.
    let own = line
        .replace("cargo run --release -- ", "vibank ")
        .replace("target/debug/vibank ", "vibank ");
    let output = Command::new("sh")
        .args(["-c", &own])
        .current_dir(place)
        .env(
            "PATH",
            format!("{}:{path}", program.parent().unwrap().display()),
        )
        .env("NO_COLOR", "1")
        .env("VIBANK_CACHE", "")
        .output()
        .map_err(|error| error.to_string())?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    if output.status.success() {
        Ok(text)
    } else {
        let reports = String::from_utf8_lossy(&output.stderr);
        Err(format!("{text}{reports}"))
    }
}

/// The codes of the midterm, in place of those that the book shows.
fn with_codes_of_today(text: &str) -> String {
    let manifest = fs::read_to_string(workplace().join("midterm/manifest.json")).unwrap();
    let mut fresh = manifest
        .split("\"code\":\"")
        .skip(1)
        .map(|rest| &rest[..11]);
    let is_code = |word: &str| {
        word.len() == 11
            && word.split('-').count() == 3
            && word.split('-').all(|piece| piece.len() == 3)
            && word
                .bytes()
                .all(|byte| byte == b'-' || byte.is_ascii_uppercase() || byte.is_ascii_digit())
    };
    let mut known: BTreeMap<&str, &str> = BTreeMap::new();
    for word in text.split(|letter: char| !(letter.is_ascii_alphanumeric() || letter == '-')) {
        if is_code(word) && !known.contains_key(word) {
            known.insert(word, fresh.next().expect("the midterm has four codes"));
        }
    }
    let mut out = text.to_owned();
    for (shown, fresh) in known {
        out = out.replace(shown, fresh);
    }
    out
}

#[test]
fn every_block_is_of_a_language_that_is_looked_at() {
    let known = ["sh", "console", "toml", "csv", "yaml", "text", "ebnf"];
    let other: Vec<String> = blocks()
        .iter()
        .filter(|block| !known.contains(&block.language.as_str()))
        .map(Block::place)
        .collect();
    assert!(other.is_empty(), "{other:#?}");
}
