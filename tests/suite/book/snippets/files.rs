//! The items, blueprints and forms that the book shows, and the fields of what a run writes.

use std::fs;
use std::path::PathBuf;

use vibank::bank::{Catalogue, embedded};
use vibank::diagnostic::Severity;
use vibank::source::Source;
use vibank::worksheet::Decisions;

use super::{blocks, put, run, with_codes_of_today, workplace};

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
            && !block.text.starts_with("[bank]")
            && !block.text.contains("[[decision]]");
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
fn the_decisions_of_the_book_are_read() {
    let blocks = blocks();
    let of_decisions = blocks
        .iter()
        .filter(|block| block.text.contains("[[decision]]"));
    let mut count = 0;
    for block in of_decisions.filter(|block| block.language == "toml") {
        let source = Source::new(block.place(), block.text.as_str());
        let read = Decisions::read(&source).map_err(|findings| {
            let words = findings.iter().map(ToString::to_string);
            words.collect::<Vec<_>>().join("\n")
        });
        let read = read.unwrap_or_else(|words| panic!("{words}"));
        count += read.decisions.len();
    }
    assert!(count >= 4, "{count} decisions");
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

/// The fields of the files that a run and its marking write.
#[test]
fn the_fields_of_the_output_are_listed() {
    let page = fs::read_to_string("book/src/reference/outputs.md").unwrap();
    let listed: Vec<&str> = page.split('`').skip(1).step_by(2).collect();
    let place = workplace();
    run(
        place,
        "vibank grade midterm/manifest.json midterm/responses.csv --out fields",
    )
    .unwrap();
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
                if !["files", "pages", "values", "items"].contains(&name.as_str()) {
                    names(field, found);
                }
            }
        }
        serde_json::Value::Array(items) => items.iter().for_each(|item| names(item, found)),
        _ => {}
    }
}
