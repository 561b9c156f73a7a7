//! Reference tables made from the program's own lists.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::process::{Command, Stdio};

use vibank::answer::AnswerKind;
use vibank::diagnostic::codes::PAGES;
use vibank::expr::Function;
use vibank::mechanics::Quantity;
use vibank::unit::KnownUnit;

/// What the program prints to standard output, given these lines to read.
fn printed(arguments: &[&str], typed: &str) -> String {
    let mut child = Command::new(env!("CARGO_BIN_EXE_vibank"))
        .args(arguments)
        .env("NO_COLOR", "1")
        .env("COLUMNS", "100")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    // A command that reads nothing may have ended before it reads anything.
    let _ = child.stdin.take().unwrap().write_all(typed.as_bytes());
    let output = child.wait_with_output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    let lines = text.lines().map(str::trim_end);
    lines.collect::<Vec<_>>().join("\n")
}

fn console(text: &str) -> String {
    format!("```console\n{}\n```", text.trim_end())
}

/// A command with what it prints: `vibank list --topic "beats"`, and after `<<<` what is typed,
/// between bars.
pub(super) fn run(command: &str) -> String {
    let (command, typed) = command.split_once(" <<< ").unwrap_or((command, ""));
    let typed: String = typed.split(" | ").map(|line| format!("{line}\n")).collect();
    // What stands between quotes is one word.
    let pieces = command.split('"').enumerate();
    let words: Vec<&str> = pieces
        .flat_map(|(place, piece)| match place % 2 {
            0 => piece.split_whitespace().collect(),
            _ => vec![piece],
        })
        .skip(1)
        .collect();
    let replies = printed(&words, &typed);
    // A session shows what is typed by itself.
    if command.ends_with("--jsonl") {
        console(&format!("$ {command} << END\n{typed}END\n{replies}"))
    } else {
        console(&format!("$ {command}\n{replies}"))
    }
}

/// The help of each command.
pub(super) fn commands() -> String {
    let help = printed(&["--help"], "");
    let verbs = help
        .lines()
        .skip_while(|line| !line.starts_with("Commands:"))
        .skip(1)
        .take_while(|line| !line.is_empty())
        // What is indented further goes on with the line before.
        .filter(|line| line.starts_with("  ") && !line.starts_with("   "))
        .filter_map(|line| line.split_whitespace().next())
        .filter(|verb| *verb != "help");
    let mut out = String::new();
    for verb in verbs {
        let _ = writeln!(
            out,
            "## {verb}\n\n{}\n",
            console(&printed(&[verb, "--help"], ""))
        );
    }
    out
}

/// The units with all their spellings.
pub(super) fn units() -> String {
    let mut out = String::from(
        "| unit | written | words in responses | prefixes |\n| --- | --- | --- | --- |\n",
    );
    for unit in KnownUnit::all() {
        let code = |texts: &[&str]| {
            let texts = texts.iter().map(|text| format!("`{text}`"));
            texts.collect::<Vec<_>>().join(" ")
        };
        // The plural of some is the singular.
        let mut words = unit.words.to_vec();
        words.dedup();
        let _ = writeln!(
            out,
            "| {} | {} | {} | {} |",
            unit.printed,
            code(unit.symbols),
            words.join(", "),
            if unit.takes_prefixes { "yes" } else { "" }
        );
    }
    out
}

/// The codes of findings with their pages.
pub(super) fn codes() -> String {
    let mut out = String::new();
    for page in PAGES {
        let _ = writeln!(
            out,
            "### `{}`\n\n{}\n\n{}\n",
            page.code.name(),
            page.title,
            page.text
        );
    }
    out
}

/// The kinds of answers: what their files say of themselves, which begins with their names.
pub(super) fn answer_kinds() -> String {
    let mut out = String::new();
    for kind in AnswerKind::ALL {
        let file = kind.name().replace('-', "_");
        let source = fs::read_to_string(format!("src/answer/{file}.rs"))
            .or_else(|_| fs::read_to_string(format!("src/answer/{file}/mod.rs")));
        let source = source.unwrap_or_else(|_| panic!("`{file}` has a file"));
        let lines = source.lines().map_while(|line| line.strip_prefix("//!"));
        let lines: Vec<&str> = lines
            .map(|line| line.strip_prefix(' ').unwrap_or(line))
            .collect();
        let text = lines.join("\n");
        let (title, text) = text.split_once('\n').expect("a title and a text");
        let title = title.trim_end_matches('.');
        let minutes = match kind.minutes() {
            1 => "1 minute".to_owned(),
            more => format!("{more} minutes"),
        };
        let (text, example) = text.trim().split_once("```toml").expect("an example");
        let _ = writeln!(
            out,
            "## {title}\n\n{}\n\nIt counts {minutes} if the item states no time.\n\n```toml{example}\n",
            text.trim_end()
        );
    }
    out
}

/// The kinds of elements of figures, with what their first key holds and their own keys.
pub(super) fn elements() -> String {
    let mut out = String::from("| kind | its first key holds | own keys |\n| --- | --- | --- |\n");
    for kind in vibank::figure::element::KINDS {
        let name = kind.name();
        let keys = kind.keys().iter().map(|key| format!("`{}`", key.name));
        let _ = writeln!(
            out,
            "| [`{name}`](figure-elements.md#{name}) | {} | {} |",
            kind.takes().describe(),
            keys.collect::<Vec<_>>().join(" ")
        );
    }
    out
}

/// The names in code that stand in the first column, or after the first, of the table under a heading.
fn listed(heading: &str) -> BTreeSet<String> {
    let page = include_str!("../../../book/src/reference/item-file.md");
    let (_, text) = page
        .split_once(heading)
        .unwrap_or_else(|| panic!("the page has `{heading}`"));
    let rows = text
        .lines()
        .skip_while(|line| !line.starts_with('|'))
        .take_while(|line| line.starts_with('|'));
    let names = rows.flat_map(|row| {
        let words = row.split('`').skip(1).step_by(2);
        words.flat_map(|words| {
            words
                .split_whitespace()
                .map(str::to_owned)
                .collect::<Vec<_>>()
        })
    });
    let bare = names.map(|name| {
        let end = name.find(['(', '*']).unwrap_or(name.len());
        name[..end].to_owned()
    });
    bare.filter(|name| name.starts_with(|letter: char| letter.is_ascii_alphabetic()))
        .collect()
}

#[test]
fn the_table_of_models_has_all_quantities_and_no_other() {
    let known: BTreeSet<String> = Quantity::names().map(str::to_owned).collect();
    assert_eq!(listed("A model offers these quantities"), known);
}

#[test]
fn the_table_of_functions_has_all_functions() {
    let listed = listed("Functions by what they take");
    let missing: Vec<&str> = Function::all()
        .map(Function::name)
        .filter(|name| !listed.contains(*name))
        .collect();
    assert!(missing.is_empty(), "{missing:?}");
}

#[test]
fn the_table_of_numerical_tasks_has_all_of_them() {
    let page = include_str!("../../../book/src/reference/programs.md");
    let missing: Vec<&str> = vibank::compute::tasks()
        .filter(|task| !page.contains(&format!("\n| `{task}` |")))
        .collect();
    assert!(missing.is_empty(), "{missing:?}");
}

#[test]
fn the_table_of_formats_has_all_formats() {
    let page = include_str!("../../../book/src/reference/outputs.md");
    let missing: Vec<&&str> = vibank::worksheet::FORMATS
        .iter()
        .filter(|format| !page.contains(&format!("\n| `{format}` |")))
        .collect();
    assert!(
        missing.is_empty(),
        "{missing:?} in reference/outputs.md of the book"
    );
}
