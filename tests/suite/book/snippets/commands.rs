//! The commands of the book, of its workflows and of the program's own help.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use super::{Block, blocks, pages, prepared, put, run, with_codes_of_today, workplace};

/// Commands of this language, one a line, with what the book shows of their output.
fn commands(block: &Block) -> Vec<(String, Vec<String>)> {
    let mut found: Vec<(String, Vec<String>)> = Vec::new();
    for line in block.text.lines().filter(|line| !line.is_empty()) {
        match (line.strip_prefix("$ "), block.language == "sh") {
            (Some(command), false) => found.push((command.to_owned(), Vec::new())),
            (_, true) => found.push((line.to_owned(), Vec::new())),
            (None, false) => match found.last_mut() {
                Some((_, shown)) => shown.push(line.to_owned()),
                None => panic!("{}: `{line}` comes from no command", block.place()),
            },
        }
    }
    found
}

#[test]
fn the_commands_of_the_book_run() {
    let mut faults = Vec::new();
    let shells = ["sh", "console"];
    let is_session = |block: &Block| block.language == "text" && block.text.starts_with("$ ");
    for block in blocks() {
        if !shells.contains(&block.language.as_str()) && !is_session(&block) {
            continue;
        }
        for (command, shown) in commands(&block) {
            // The suite neither builds nor runs itself, and leaves the repository alone.
            if [
                "cargo build",
                "cargo check",
                "cargo test",
                ".ci/run",
                "git add",
            ]
            .iter()
            .any(|own| command.contains(own))
            {
                continue;
            }
            // What is there already is not made again.
            let ran = if command.contains("sheet examples/midterm.toml") {
                Ok(prepared().1.clone())
            } else {
                run(workplace(), &with_codes_of_today(&command))
            };
            match ran {
                Err(fault) => faults.push(format!("{}: `{command}`: {fault}", block.place())),
                Ok(printed) => faults.extend(
                    shown
                        .iter()
                        // PDF is left out here.
                        .filter(|line| !line.contains(".pdf") && !printed.contains(line.as_str()))
                        .map(|line| format!("{}: `{line}` is not in:\n{printed}", block.place())),
                ),
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// The workflows for build servers, for the shard and the job that a server would fill in.
#[test]
fn the_commands_of_the_workflows_run() {
    let place = Path::new(env!("CARGO_TARGET_TMPDIR")).join("book-servers");
    let _ = fs::remove_dir_all(&place);
    let mut count = 0;
    for block in blocks() {
        if block.language != "yaml" || !block.text.contains("vibank check") {
            continue;
        }
        let _ = fs::remove_dir_all(&place);
        copy(Path::new("tests/fixtures/bank"), &place.join("bank"));
        let questions = "[[question]]\nitem = \"free/spring-mass\"\n";
        put(
            place.join("sheets/midterm.toml"),
            &format!("title = \"T\"\nseed = 1\nvariants = 3\nformats = [\"html\"]\n{questions}"),
        );
        let lines = block
            .text
            .lines()
            .map(|line| line.trim_start().trim_start_matches("- "));
        let lines = lines.map(|line| line.strip_prefix("run: ").unwrap_or(line));
        for line in lines.filter(|line| line.starts_with("vibank ")) {
            for part in ["1", "2"] {
                let line = line
                    .replace("${{ matrix.part }}", part)
                    .replace("$CI_NODE_INDEX/$CI_NODE_TOTAL", &format!("{part}/2"));
                if let Err(fault) = run(&place, &line) {
                    panic!("{}: `{line}`: {fault}", block.place());
                }
            }
            count += 1;
        }
    }
    assert!(count >= 6, "{count} commands");
}

fn copy(from: &Path, to: &Path) {
    for entry in fs::read_dir(from).unwrap() {
        let path = entry.unwrap().path();
        let to = to.join(path.file_name().unwrap());
        if path.is_dir() {
            copy(&path, &to);
        } else {
            put(to, &fs::read_to_string(&path).unwrap());
        }
    }
}

/// The examples in the help of the commands.
#[test]
fn the_examples_of_the_commands_run() {
    let page = fs::read_to_string("book/src/reference/commands.md").unwrap();
    let mut faults = Vec::new();
    let mut count = 0;
    for example in page.split("\nExample: ").skip(1) {
        let lines = example.lines().take_while(|line| !line.is_empty());
        let command = lines.collect::<Vec<_>>().join(" ");
        count += 1;
        // The first runs until somebody ends it, `cli::authors` does; the tests of the press print the second, those of
        // the reader of scans sort with the third.
        if ["vibank preview", "vibank course", "vibank sort"]
            .iter()
            .any(|own| command.starts_with(own))
        {
            continue;
        }
        let command = with_codes_of_today(&command);
        let input = if command.contains('|') {
            ""
        } else {
            " < /dev/null"
        };
        if let Err(fault) = run(workplace(), &format!("{command}{input}")) {
            faults.push(format!("`{command}`: {fault}"));
        }
    }
    assert!(count >= 12, "{count} examples");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Commands within a sentence name verbs and options that exist.
#[test]
fn commands_within_the_text_are_those_of_the_program() {
    let mut helps: BTreeMap<String, String> = BTreeMap::new();
    let mut faults = Vec::new();
    for page in pages() {
        let text = fs::read_to_string(&page).unwrap();
        for code in text
            .lines()
            .flat_map(|line| line.split('`').skip(1).step_by(2))
        {
            let Some(command) = code.strip_prefix("vibank ") else {
                continue;
            };
            let mut words = command.split_whitespace();
            let verb = words.next().unwrap_or_default().to_owned();
            if verb.starts_with("--") {
                continue;
            }
            let help = helps.entry(verb.clone()).or_insert_with(|| {
                run(Path::new("."), &format!("vibank {verb} --help")).unwrap_or_default()
            });
            for option in words.filter(|word| word.starts_with("--")).chain(["Usage"]) {
                if !help.contains(option) {
                    faults.push(format!("{}: `{code}`: no {option}", page.display()));
                }
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
