//! What a run does to an earlier one in the same folder, and what becomes of students and of the bank in between.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::{BANK, blueprint, content, folder, put, small, text_of, vibank};

/// The codes in a manifest, by student.
fn codes(out: &Path) -> BTreeMap<String, String> {
    let manifest: Value =
        serde_json::from_str(&content(out.join("manifest.json"))).expect("it is JSON");
    let variants = manifest["variants"].as_array().expect("it has sheets");
    let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    variants
        .iter()
        .map(|variant| (text(&variant["student"]["id"]), text(&variant["code"])))
        .collect()
}

/// A class list with these students.
fn class(folder: &Path, ids: &[String]) {
    let rows: String = ids.iter().map(|id| format!("{id},Name {id}\n")).collect();
    put(folder, "class.csv", format!("id,name\n{rows}"));
}

fn ids(numbers: impl IntoIterator<Item = usize>) -> Vec<String> {
    numbers
        .into_iter()
        .map(|number| format!("s{number}"))
        .collect()
}

/// A blueprint of one item for the class list.
fn plan(folder: &Path, title: &str) -> String {
    let plan = format!(
        "title = '{title}'\nseed = 5\nstudents = 'class.csv'\nformats = ['md']\nsolutions = false\n\
        [[question]]\nitem = 'free/spring-mass'\n"
    );
    put(folder, "t.toml", plan)
}

fn sheet(plan: &str, out: &Path, more: &[&str]) -> super::Ran {
    small(&[&["sheet", plan, "--out", &text_of(out)], more].concat())
}

#[test]
fn a_student_who_is_added_moves_nobody_whose_sheet_is_there() {
    let folder = folder("added");
    class(&folder, &ids(1..60));
    let plan = plan(&folder, "T");
    let out = folder.join("out");
    sheet(&plan, &out, &[]).ends(0);
    let before = codes(&out);
    // Added in front, rows in another order, one gone.
    let mut now = ids((2..64).rev());
    now.insert(0, "a0".to_owned());
    class(&folder, &now);
    sheet(&plan, &out, &[]).ends(0);
    let after = codes(&out);
    assert_eq!(after.len(), 63);
    for (id, code) in &before {
        if id != "s1" {
            assert_eq!(after[id], *code, "{id}");
        }
    }
}

#[test]
fn without_a_manifest_only_those_move_who_are_named() {
    let folder = folder("moved");
    class(&folder, &ids(1..60));
    let plan = plan(&folder, "T");
    let (one, two) = (folder.join("one"), folder.join("two"));
    sheet(&plan, &one, &[]).ends(0);
    class(&folder, &ids((0..60).rev()));
    let ran = sheet(&plan, &two, &["--format", "json"]).ends(0);
    let named: Vec<String> = ran.lines()[0]["fairness"]["gave_way"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|id| id.as_str().expect("a text").to_owned())
        .collect();
    let (before, after) = (codes(&one), codes(&two));
    let moved: Vec<&String> = before
        .keys()
        .filter(|id| before[*id] != after[*id])
        .collect();
    assert!(moved.len() <= 6, "{moved:?}");
    assert!(
        moved.iter().all(|id| named.contains(id)),
        "{moved:?} of {named:?}"
    );
}

#[test]
fn a_changed_seat_judges_that_student_alone() {
    let folder = folder("seat-changed");
    let list = |seat: &str| {
        let rows: String = (1..13)
            .map(|id| {
                let own = if id == 5 {
                    seat.to_owned()
                } else {
                    format!("1-{id}")
                };
                format!("s{id},N,{own}\n")
            })
            .collect();
        put(&folder, "class.csv", format!("id,name,seat\n{rows}"));
    };
    list("1-5");
    let plan = plan(&folder, "T");
    let out = folder.join("out");
    sheet(&plan, &out, &[]).ends(0);
    let before = codes(&out);
    list("2-9");
    sheet(&plan, &out, &[]).ends(0);
    let after = codes(&out);
    assert!(
        before
            .iter()
            .all(|(id, code)| id == "s5" || after[id] == *code)
    );
}

#[test]
fn spare_sheets_stand_beside_a_list() {
    let folder = folder("spares");
    class(&folder, &ids(1..4));
    let top = "seed = 5\nstudents = 'class.csv'\nspares = 2";
    let plan = put(&folder, "t.toml", blueprint(top));
    let out = folder.join("out");
    sheet(&plan, &out, &[]).ends(0).says("5 sheets");
    let plan = put(
        &folder,
        "t.toml",
        blueprint("seed = 5\nvariants = 3\nspares = 2"),
    );
    sheet(&plan, &out, &[])
        .ends(2)
        .complains("`spares` stands beside `students` alone");
}

/// Fills in every row of a form.
fn fill(out: &Path) {
    let form = content(out.join("responses.csv"));
    let filled: Vec<String> = form
        .lines()
        .enumerate()
        .map(|(at, row)| {
            if at == 0 {
                row.to_owned()
            } else {
                format!("{row}7")
            }
        })
        .collect();
    put(out, "responses.csv", filled.join("\n") + "\n");
}

fn copies(out: &Path) -> Vec<PathBuf> {
    let kept = fs::read_dir(out.join("kept"))
        .into_iter()
        .flatten()
        .flatten();
    kept.map(|entry| entry.path()).collect()
}

#[test]
fn answers_and_marks_are_not_overwritten() {
    let folder = folder("answers");
    class(&folder, &ids(1..5));
    let out = folder.join("out");
    sheet(&plan(&folder, "T"), &out, &[]).ends(0);
    fill(&out);
    let filled = content(out.join("responses.csv"));
    let manifest = content(out.join("manifest.json"));
    // The same run again leaves the answers alone, even if sheets have to be made.
    fs::remove_file(out.join("sheets.md")).expect("it is there");
    sheet(&plan(&folder, "T"), &out, &[]).ends(0);
    assert_eq!(content(out.join("responses.csv")), filled);
    assert_eq!(content(out.join("manifest.json")), manifest);
    let path = text_of(&out.join("manifest.json"));
    let responses = text_of(&out.join("responses.csv"));
    small(&["grade", &path, &responses, "--no-feedback"]);
    // A corrected title, and one student more.
    class(&folder, &ids(1..6));
    let other = plan(&folder, "Corrected");
    sheet(&other, &out, &[])
        .ends(2)
        .complains("responses.csv: has answers")
        .complains("marks: holds marks")
        .complains("--force")
        .complains("--out");
    assert_eq!(content(out.join("responses.csv")), filled);
    assert_eq!(content(out.join("manifest.json")), manifest);
    sheet(&other, &out, &["--force"])
        .ends(0)
        .complains("a copy");
    let copies = copies(&out);
    assert_eq!(copies.len(), 1);
    assert_eq!(content(copies[0].join("responses.csv")), filled);
    assert!(copies[0].join("marks/results.json").is_file());
    // The manifest of the printed sheets is there, and marks them.
    let earlier = fs::read_dir(out.join("manifests"))
        .expect("a folder")
        .flatten();
    let earlier: Vec<PathBuf> = earlier.map(|entry| entry.path()).collect();
    assert_eq!(earlier.len(), 1);
    assert_eq!(content(&earlier[0]), manifest);
}

#[test]
fn an_edited_file_is_not_overwritten() {
    let folder = folder("edited");
    class(&folder, &ids(1..3));
    let out = folder.join("out");
    let own = plan(&folder, "T");
    sheet(&own, &out, &[]).ends(0);
    let edited = content(out.join("sheets.md")) + "\nA word of my own.\n";
    put(&out, "sheets.md", &edited);
    sheet(&own, &out, &[])
        .ends(2)
        .complains("sheets.md: was edited");
    assert_eq!(content(out.join("sheets.md")), edited);
    sheet(&own, &out, &["--force"]).ends(0);
    assert_eq!(content(copies(&out)[0].join("sheets.md")), edited);
    assert!(!content(out.join("sheets.md")).contains("of my own"));
}

#[test]
fn a_code_is_found_in_the_manifest_of_any_run() {
    let folder = folder("any-manifest");
    class(&folder, &ids(1..4));
    let out = folder.join("out");
    let own = plan(&folder, "T");
    sheet(&own, &out, &[]).ends(0);
    let form = content(out.join("responses.csv"));
    // Another seed: none of these codes is in the new manifest.
    let other = put(
        &folder,
        "t.toml",
        content(&own).replace("seed = 5", "seed = 6"),
    );
    sheet(&other, &out, &[]).ends(0);
    let rows: Vec<String> = form
        .lines()
        .enumerate()
        .map(|(at, row)| {
            if at == 0 {
                row.to_owned()
            } else {
                format!("{row}7")
            }
        })
        .collect();
    let old = put(&folder, "old.csv", rows.join("\n"));
    let manifest = text_of(&out.join("manifest.json"));
    let ran = small(&["grade", &manifest, &old, "--no-feedback"]);
    assert!(!ran.err.contains("no sheet"), "{}", ran.err);
    ran.says("6 sheets");
    let marks = content(out.join("marks/marks.csv"));
    let code = rows[1].split(',').next().expect("a code");
    assert!(marks.contains(code), "{code} is not in {marks}");
}

#[test]
fn what_was_handed_out_is_marked_whatever_becomes_of_the_bank() {
    let folder = folder("moved-on");
    let bank = folder.join("bank");
    for entry in walk(Path::new(BANK)) {
        let inside = entry.strip_prefix(BANK).expect("it is inside");
        put(&bank, &text_of(inside), content(&entry));
    }
    let bank_path = text_of(&bank);
    class(&folder, &ids(1..3));
    let own = plan(&folder, "T");
    let out = folder.join("out");
    let with = |arguments: &[&str]| vibank(&[arguments, &["--bank", &bank_path]].concat());
    with(&["sheet", &own, "--out", &text_of(&out)]).ends(0);
    fill(&out);
    let manifest = text_of(&out.join("manifest.json"));
    let responses = text_of(&out.join("responses.csv"));
    let first = text_of(&folder.join("first"));
    with(&[
        "grade",
        &manifest,
        &responses,
        "--no-feedback",
        "--out",
        &first,
    ]);
    let item = bank.join("free/spring-mass.toml");
    let changed = content(&item) + "\n# Another revision.\n";
    put(&bank, "free/spring-mass.toml", changed);
    let second = text_of(&folder.join("second"));
    let ran = with(&[
        "grade",
        &manifest,
        &responses,
        "--no-feedback",
        "--out",
        &second,
        "--compare",
        &first,
    ]);
    let ran = ran
        .says("0 marks differ")
        .says(concat!("vibank ", env!("CARGO_PKG_VERSION")));
    assert!(ran.err.contains("the bank has moved on"), "{}", ran.err);
    fs::remove_file(&item).expect("it is there");
    let third = text_of(&folder.join("third"));
    with(&[
        "grade",
        &manifest,
        &responses,
        "--no-feedback",
        "--out",
        &third,
    ])
    .says("2 sheets");
    let marks = |folder: &str| content(Path::new(folder).join("marks.csv"));
    assert_eq!(marks(&first), marks(&second));
    assert_eq!(marks(&first), marks(&third));
    let code = codes(&out).into_values().next().expect("a code");
    with(&["show", &code, "--manifest", &manifest]).ends(0);
}

fn walk(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder").flatten() {
        let path = entry.path();
        if path.is_dir() {
            found.extend(walk(&path));
        } else {
            found.push(path);
        }
    }
    found
}

#[test]
fn a_run_with_pseudonyms_knows_no_names() {
    let folder = folder("pseudonyms");
    class(&folder, &["id-4711".to_owned(), "id-4712".to_owned()]);
    put(&folder, "exam.key", "0123456789abcdef0123456789abcdef");
    let top = "secret = 'exam.key'\nstudents = 'class.csv'\nformats = ['html', 'md', 'json']";
    let plan = put(&folder, "t.toml", blueprint(top));
    let out = folder.join("out");
    let key = text_of(&folder.join("who.csv"));
    sheet(&plan, &out, &["--pseudonyms", &key]).ends(0);
    for path in walk(&out) {
        assert!(!content(&path).contains("id-471"), "{}", path.display());
    }
    let who = content(&key);
    assert!(who.contains("id-4711,Name id-4711"), "{who}");
    let code = who
        .lines()
        .nth(1)
        .and_then(|row| row.split(',').next())
        .expect("a code");
    assert!(content(out.join("responses.csv")).contains(code));
    // A third student moves nobody, though the manifest knows no names.
    class(
        &folder,
        &["id-4700", "id-4711", "id-4712"].map(str::to_owned),
    );
    sheet(&plan, &out, &["--pseudonyms", &key]).ends(0);
    assert!(content(&key).contains(&format!("{code},id-4711")));
    let plain = put(
        &folder,
        "p.toml",
        blueprint("seed = 1\nstudents = 'class.csv'"),
    );
    sheet(&plain, &out, &["--pseudonyms", &key])
        .ends(2)
        .complains("vibank new secret");
}

#[cfg(target_os = "linux")]
#[test]
fn what_cannot_be_printed_is_a_failure() {
    let full = fs::OpenOptions::new()
        .write(true)
        .open("/dev/full")
        .expect("Linux has it");
    let mut list = std::process::Command::new(env!("CARGO_BIN_EXE_vibank"));
    let status = list.args(["list", "--bank", BANK]).stdout(full).status();
    assert_eq!(status.expect("it starts").code(), Some(2));
}

#[test]
fn a_blueprint_that_would_be_misunderstood_is_refused() {
    let folder = folder("misunderstood");
    for (top, words) in [
        ("formats = []", "`formats` is empty"),
        ("formats = ['md', 'md']", "`md` is listed twice"),
        ("language = 'fr'", "the texts of the bank are in `en`"),
    ] {
        let plan = put(
            &folder,
            "t.toml",
            blueprint(&format!("seed = 1\nvariants = 1\n{top}")),
        );
        small(&["sheet", &plan]).ends(2).complains(words);
    }
    let plan = put(
        &folder,
        "t.toml",
        blueprint("seed = 1\nvariants = 1") + "points = nan\n",
    );
    small(&["sheet", &plan])
        .ends(2)
        .complains("expected a finite number");
}

#[test]
fn keys_in_json_have_their_text() {
    let folder = folder("json-keys");
    let plan = put(
        &folder,
        "t.toml",
        "title = 'T'\nseed = 1\nvariants = 1\nformats = ['json']\n\
        [[question]]\nitem = 'ch3/e4-underdamped-response'\n",
    );
    let out = folder.join("out");
    vibank(&["sheet", &plan, "--out", &text_of(&out)]).ends(0);
    let sheet: Value =
        serde_json::from_str(content(out.join("sheets.jsonl")).trim()).expect("JSON");
    for part in sheet["questions"][0]["parts"].as_array().expect("parts") {
        let key = part["key"].as_object().expect("a key");
        if ["formula", "function"].contains(&part["kind"].as_str().unwrap_or_default()) {
            assert!(
                key["printed"].as_str().is_some_and(|text| !text.is_empty()),
                "{part}"
            );
        }
        assert!(
            key.values().all(|value| *value != serde_json::json!([])),
            "{part}"
        );
    }
}
