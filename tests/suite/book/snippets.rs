//! Every command and every file that the book shows is run, or says why not.
//!
//! A block that cannot be run here stands below `<!-- not run: REASON -->`. Blocks within generated parts
//! are made by running them.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use vibank::bank::{Catalogue, embedded};
use vibank::diagnostic::Severity;

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
        let midterm: String = include_str!("../../../examples/midterm.toml")
            .lines()
            .map(|line| match line.starts_with("formats") {
                true => "formats = [\"html\"]\n".to_owned(),
                false => format!("{line}\n"),
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
            include_str!("../../fixtures/book/disk-on-a-wire.toml"),
        );
        put(place.join("bank/bank.toml"), include_str!("../../../bank/bank.toml"));
        put(place.join("bank/ch2/_chapter.toml"), "title = \"Free\"\nnumber = 2\n");
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
    let output = Command::new("sh")
        .args(["-c", &line.replace("cargo run --release -- ", "vibank ")])
        .current_dir(place)
        .env(
            "PATH",
            format!("{}:{path}", program.parent().unwrap().display()),
        )
        .env("NO_COLOR", "1")
        .output()
        .map_err(|error| error.to_string())?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    match output.status.success() {
        true => Ok(text),
        false => Err(format!("{text}{}", String::from_utf8_lossy(&output.stderr))),
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
#[cfg(unix)]
fn the_commands_of_the_book_run() {
    let mut faults = Vec::new();
    let shells = ["sh", "console"];
    let is_session = |block: &Block| block.language == "text" && block.text.starts_with("$ ");
    for block in blocks() {
        if !shells.contains(&block.language.as_str()) && !is_session(&block) {
            continue;
        }
        for (command, shown) in commands(&block) {
            // The suite does not run itself.
            if ["cargo test", ".ci/run"].iter().any(|own| command.contains(own)) {
                continue;
            }
            // What is there already is not made again.
            let ran = match command.contains("sheet examples/midterm.toml") {
                true => Ok(prepared().1.clone()),
                false => run(workplace(), &with_codes_of_today(&command)),
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

/// What a piece of an item may stand in: data, quantities and a part under the names of the book.
const SKELETON: &str = r#"
[item]
title = "T"
source = "S"
[parameters]
m = "2 kg"
M = "2 kg"
k = "50 N/m"
b = "3 N s/m"
c = "3 N s/m"
r = "0.2 m"
g = "9.81 m/s^2"
F = "4 N"
Omega = "2 rad/s"
x0 = "0.1 m"
mu = { value = "0.5", range = "0.1 .. 0.9", step = "0.1" }
mu_min = "0.2"
n_half = "3"
[model]
coordinates = { x = { unit = "m" } }
kinetic = "1/2*m*x'^2"
potential = "1/2*k*x^2"
dissipation = "1/2*c*x'^2"
initial = { x = "x0" }
[models.two]
coordinates = { x1 = { unit = "m" }, x2 = { unit = "m" } }
kinetic = "1/2*m*(x1'^2 + x2'^2)"
potential = "1/2*k*x1^2 + 1/2*k*(x2 - x1)^2 + 1/2*k*x2^2"
[quantities]
omega_n = { formula = "sqrt(k/m)", unit = "rad/s" }
zeta = { formula = "c/(2*sqrt(k*m))", unit = "1" }
omega_d = { formula = "sqrt(k/m - (c/(2*m))^2)", unit = "rad/s" }
x = { formula = "model.motion", unit = "m" }
K = { formula = "[[2*k, -k], [-k, k]]", unit = "N/m" }
u1 = { formula = "[1, 1]", unit = "1" }
[statement]
text = "X"
[[part]]
id = "whole"
key = "2*m"
unit = "kg"
ask = "Y"
"#;

/// A text cut before its tables, each with its head.
fn tables(text: &str) -> Vec<(String, String)> {
    let mut found: Vec<(String, String)> = Vec::new();
    for line in text.lines() {
        if line.starts_with('[') {
            found.push((line.trim_end().to_owned(), String::new()));
        }
        if let Some((_, body)) = found.last_mut() {
            body.push_str(line);
            body.push('\n');
        }
    }
    found
}

/// An item with the tables of a piece in place of its own; parts are added.
fn completed(item: &str, piece: &str) -> String {
    let own = tables(piece);
    let is_free = |head: &str| head.starts_with("[[") || own.iter().all(|(other, _)| other != head);
    let kept = tables(item).into_iter().filter(|(head, _)| is_free(head));
    kept.chain(own.clone()).map(|(_, body)| body).collect()
}

/// What is wrong with an item, besides warnings.
fn errors_of(item: &str) -> Vec<String> {
    let files = embedded()
        .into_iter()
        .filter(|(path, _)| ["bank.toml", "ch2/_chapter.toml"].contains(path));
    let (_, findings) = Catalogue::load(files.chain([("ch2/of-the-book.toml", item)]));
    let errors = findings
        .iter()
        .filter(|finding| finding.severity == Severity::Error);
    errors
        .map(|finding| format!("{}: {:?}", finding.message, finding.labels))
        .collect()
}

#[test]
fn the_items_of_the_book_load() {
    // These two are drawn by tests of their own.
    let drawn = ["reference/figure-elements.md", "reference/plots.md"];
    let mut faults = Vec::new();
    let mut before: Option<(PathBuf, String)> = None;
    for block in blocks() {
        let is_item = block.language == "toml"
            && !block.text.contains("[[question]]")
            && block.text.starts_with('[')
            && !block.text.starts_with("[bank]");
        if !is_item || drawn.iter().any(|page| block.is_on(page)) {
            continue;
        }
        let base = match &before {
            Some((page, item)) if *page == block.page => item.clone(),
            _ => SKELETON.to_owned(),
        };
        let item = if block.text.starts_with("[item]") {
            block.text.clone()
        } else {
            completed(&base, &block.text)
        };
        for fault in errors_of(&item) {
            faults.push(format!("{}: {fault}", block.place()));
        }
        before = Some((block.page.clone(), item));
    }
    // The examples of the kinds of answers are made from the code.
    let kinds = fs::read_to_string("book/src/reference/answers.md").unwrap();
    for example in kinds.split("```toml\n").skip(1) {
        let example = example.split("```").next().unwrap();
        let several = ["model.general_motion", "mode-shape", "\"matrix\""];
        let mut base = SKELETON.to_owned();
        if several.iter().any(|word| example.contains(word)) {
            base = base
                .replace("\n[model]", "\n[models.one]")
                .replace("[models.two]", "[model]");
            base = base.replace("x = { formula = \"model.motion\", unit = \"m\" }\n", "");
        }
        for fault in errors_of(&completed(&base, example)) {
            faults.push(format!("kinds of answers: {fault}\n{example}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn the_blueprints_of_the_book_are_made() {
    let mut faults = Vec::new();
    let mut count = 0;
    for block in blocks() {
        let is_piece = block.language == "toml" && !block.text.starts_with(['[', '{', 'p', 'e']);
        if block.language != "toml" || !(block.text.contains("[[question]]") || is_piece) {
            continue;
        }
        count += 1;
        let whole = if block.text.contains("[[question]]") {
            block.text.clone()
        } else {
            let question = "[[question]]\nitem = \"ch3/e5-log-decrement\"\n";
            let extent = if block.text.contains("students") {
                ""
            } else {
                "variants = 2\n"
            };
            let seed = if block.text.contains("secret") {
                ""
            } else {
                "seed = 1\n"
            };
            format!("title = \"T\"\n{seed}{extent}{}{question}", block.text)
        };
        let name = format!("blueprint-{count}.toml");
        put(workplace().join(&name), &whole.replace("= 30", "= 2"));
        if let Err(fault) = run(workplace(), &format!("vibank sheet {name}")) {
            faults.push(format!("{}: {fault}", block.place()));
        }
    }
    assert!(count >= 4, "{count} blueprints");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn the_forms_of_the_book_are_marked() {
    let blocks = blocks();
    let form = |mark: &str| {
        let mut forms = blocks.iter().filter(|block| block.language == "csv");
        let form = forms.find(|block| block.text.contains(mark));
        &form.unwrap_or_else(|| panic!("a form with {mark}")).text
    };
    let place = workplace();
    put(
        place.join("filled.csv"),
        &with_codes_of_today(form("kind,unit,response")),
    );
    put(
        place.join("settled.csv"),
        &with_codes_of_today(form("response,points,feedback")),
    );
    let command =
        "vibank grade midterm/manifest.json filled.csv --overrides settled.csv --out marked";
    run(place, command).unwrap();
    let details = fs::read_to_string(place.join("marked/details.csv")).unwrap();
    let verdicts = |verdict: &str| details.matches(&format!(",{verdict},")).count();
    assert!(verdicts("right") >= 3, "{details}");
    assert!(details.contains("The sketch is right."), "{details}");
}

/// The workflows for build servers, for the shard and the job that a server would fill in.
#[test]
#[cfg(unix)]
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
            &format!("title = \"T\"\nseed = 1\nvariants = 3\n{questions}"),
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

/// The examples in the help of the commands.
#[test]
#[cfg(unix)]
fn the_examples_of_the_commands_run() {
    let page = fs::read_to_string("book/src/reference/commands.md").unwrap();
    let mut faults = Vec::new();
    let mut count = 0;
    for example in page.split("\nExample: ").skip(1) {
        let lines = example.lines().take_while(|line| !line.is_empty());
        let command = lines.collect::<Vec<_>>().join(" ");
        count += 1;
        let command = with_codes_of_today(&command);
        let input = if command.contains('|') { "" } else { " < /dev/null" };
        if let Err(fault) = run(workplace(), &format!("{command}{input}")) {
            faults.push(format!("`{command}`: {fault}"));
        }
    }
    assert!(count >= 12, "{count} examples");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// The fields of the files that a run and its marking write.
#[test]
fn the_fields_of_the_output_are_listed() {
    let page = fs::read_to_string("book/src/reference/outputs.md").unwrap();
    let listed: Vec<&str> = page.split('`').skip(1).step_by(2).collect();
    let place = workplace();
    run(place, "vibank grade midterm/manifest.json midterm/responses.csv --out fields").unwrap();
    let read = |name: &str| fs::read_to_string(place.join(name)).unwrap();
    let json = |name: &str| serde_json::from_str(&read(name)).unwrap();
    let mut fields = Vec::new();
    for name in ["midterm/manifest.json", "fields/results.json"] {
        names(&json(name), &mut fields);
    }
    for name in ["midterm/responses.csv", "fields/details.csv"] {
        let header = read(name);
        let header = header.lines().next().unwrap();
        fields.extend(header.split(',').map(str::to_owned));
    }
    let missing: Vec<&String> = fields
        .iter()
        .filter(|field| !listed.contains(&field.as_str()))
        .collect();
    assert!(missing.is_empty(), "{missing:?}");
}

/// The names of fields, but for those of files and of data.
fn names(value: &serde_json::Value, found: &mut Vec<String>) {
    match value {
        serde_json::Value::Object(fields) => {
            for (name, field) in fields {
                found.push(name.clone());
                if !["files", "values"].contains(&name.as_str()) {
                    names(field, found);
                }
            }
        }
        serde_json::Value::Array(items) => items.iter().for_each(|item| names(item, found)),
        _ => {}
    }
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
