//! Reference tables made from the program's own lists.

use std::fmt::Write as _;
use std::process::Command;

use vibank::answer::KINDS;
use vibank::diagnostic::codes::PAGES;
use vibank::expr::Function;
use vibank::mechanics::Model;
use vibank::unit::Unit;

/// What the program prints to standard output.
fn printed(arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_vibank"))
        .args(arguments)
        .env("NO_COLOR", "1")
        .env("COLUMNS", "100")
        .output()
        .unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    let lines = text.lines().map(str::trim_end);
    lines.collect::<Vec<_>>().join("\n")
}

fn console(text: &str) -> String {
    format!("```console\n{}\n```", text.trim_end())
}

/// A command with what it prints.
pub(super) fn run(command: &str) -> String {
    let words: Vec<&str> = command.split_whitespace().skip(1).collect();
    console(&format!("$ {command}\n{}", printed(&words)))
}

/// The help of each command.
pub(super) fn commands() -> String {
    let help = printed(&["--help"]);
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
            console(&printed(&[verb, "--help"]))
        );
    }
    out
}

/// The units with all their spellings.
pub(super) fn units() -> String {
    let mut out = String::from(
        "| unit | written | words in responses | prefixes |\n| --- | --- | --- | --- |\n",
    );
    for unit in Unit::known() {
        let code = |texts: &[&str]| {
            let texts = texts.iter().map(|text| format!("`{text}`"));
            texts.collect::<Vec<_>>().join(" ")
        };
        let _ = writeln!(
            out,
            "| {} | {} | {} | {} |",
            unit.printed,
            code(unit.symbols),
            unit.words.join(", "),
            if unit.takes_prefixes { "yes" } else { "" }
        );
    }
    out
}

/// The functions of the formula language.
pub(super) fn functions() -> String {
    let mut out =
        String::from("| function | arguments | of complex numbers |\n| --- | --- | --- |\n");
    for function in Function::all() {
        let arguments = match function.arity() {
            (least, most) if least == most => least.to_string(),
            (least, most) if most > 99 => format!("{least} or more"),
            (least, most) => format!("{least} to {most}"),
        };
        let complex = if function.is_real_only() { "" } else { "yes" };
        let _ = writeln!(out, "| `{}` | {arguments} | {complex} |", function.name());
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

/// The quantities that a model offers.
pub(super) fn model_quantities() -> String {
    let names = Model::quantity_names().map(|name| format!("`{name}`"));
    names.collect::<Vec<_>>().join(" ")
}

/// The kinds of answers.
pub(super) fn answer_kinds() -> String {
    let mut out = String::from("| kind | minutes if the item states none |\n| --- | --- |\n");
    for kind in KINDS {
        let _ = writeln!(out, "| `{}` | {} |", kind.name(), kind.minutes());
    }
    out
}
