//! What a run does to an earlier one in the same folder, and what becomes of students and of the bank in between.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::desk::{Desk, all, answered, ids};
use super::{BANK, blueprint, content, folder, put, text_of, vibank};

/// The codes in the manifest, by student.
fn codes(desk: &Desk) -> BTreeMap<String, String> {
    let manifest = desk.manifest();
    let variants = manifest["variants"].as_array().expect("it has sheets");
    let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    variants
        .iter()
        .map(|variant| (text(&variant["student"]["id"]), text(&variant["code"])))
        .collect()
}

#[test]
fn a_student_who_is_added_moves_nobody_whose_sheet_is_there() {
    let desk = Desk::with_class("added", 59);
    let plan = desk.short_plan("T");
    desk.sheet(&plan, &[]).ends(0);
    let before = codes(&desk);
    // Added in front, rows in another order, one gone.
    let mut now = ids((2..64).rev());
    now.insert(0, "a0".to_owned());
    desk.class(&now);
    desk.sheet(&plan, &[]).ends(0);
    let after = codes(&desk);
    assert_eq!(after.len(), 63);
    for (id, code) in &before {
        if id != "s1" {
            assert_eq!(after[id], *code, "{id}");
        }
    }
}

#[test]
fn without_a_manifest_only_those_move_who_are_named() {
    let mut desk = Desk::with_class("moved", 59);
    let plan = desk.short_plan("T");
    desk.sheet(&plan, &[]).ends(0);
    let before = codes(&desk);
    desk.class(&ids((0..60).rev()));
    desk.out = desk.folder.join("two");
    let ran = desk.sheet(&plan, &["--format", "json"]).ends(0);
    let named: Vec<String> = ran.lines()[0]["fairness"]["gave_way"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|id| id.as_str().expect("a text").to_owned())
        .collect();
    let after = codes(&desk);
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
    let desk = Desk::new("seat-changed");
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
        put(&desk.folder, "class.csv", format!("id,name,seat\n{rows}"));
    };
    list("1-5");
    let plan = desk.short_plan("T");
    desk.sheet(&plan, &[]).ends(0);
    let before = codes(&desk);
    list("2-9");
    desk.sheet(&plan, &[]).ends(0);
    let after = codes(&desk);
    assert!(
        before
            .iter()
            .all(|(id, code)| id == "s5" || after[id] == *code)
    );
}

#[test]
fn seats_of_two_rooms_are_no_neighbours() {
    let desk = Desk::new("two-rooms");
    let plan = desk.short_plan("T");
    let has_neighbours = |rooms: [&str; 3]| {
        let rows = (1..).zip(rooms);
        let rows: String = rows
            .map(|(id, room)| format!("s{id},N,{room},1-{id}\n"))
            .collect();
        put(
            &desk.folder,
            "class.csv",
            format!("id,name,room,seat\n{rows}"),
        );
        let _ = fs::remove_dir_all(&desk.out);
        desk.sheet(&plan, &[]).ends(0);
        desk.text("fairness.md").contains("beside each other")
    };
    assert!(has_neighbours(["H", "H", "H"]));
    assert!(!has_neighbours(["H", "G", "H"]));
}

#[test]
fn spare_sheets_stand_beside_a_list() {
    let desk = Desk::with_class("spares", 3);
    let plan = desk.plan("seed = 5\nstudents = 'class.csv'\nspares = 2");
    desk.sheet(&plan, &[]).ends(0).says("5 sheets");
    let plan = desk.plan("seed = 5\nvariants = 3\nspares = 2");
    desk.sheet(&plan, &[])
        .ends(2)
        .complains("`spares` needs `students`");
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
    let desk = Desk::with_class("answers", 4);
    desk.sheet(&desk.short_plan("T"), &[]).ends(0);
    desk.answer("7");
    let filled = desk.text("responses.csv");
    let manifest = desk.text("manifest.json");
    // The same run again leaves the answers alone, even if sheets have to be made.
    fs::remove_file(desk.path("sheets.md")).expect("it is there");
    desk.sheet(&desk.short_plan("T"), &[]).ends(0);
    assert_eq!(desk.text("responses.csv"), filled);
    assert_eq!(desk.text("manifest.json"), manifest);
    desk.grade(&["--no-feedback"]);
    // A corrected title, and one student more.
    desk.class(&ids(1..6));
    let other = desk.short_plan("Corrected");
    desk.sheet(&other, &[])
        .ends(2)
        .complains("responses.csv: has answers")
        .complains("marks: holds marks")
        .complains("--force")
        .complains("--out");
    assert_eq!(desk.text("responses.csv"), filled);
    assert_eq!(desk.text("manifest.json"), manifest);
    desk.sheet(&other, &["--force"]).ends(0).complains("a copy");
    let copies = copies(&desk.out);
    assert_eq!(copies.len(), 1);
    assert_eq!(content(copies[0].join("responses.csv")), filled);
    assert!(copies[0].join("marks/results.json").is_file());
    // The manifest of the printed sheets is there, and marks them.
    let earlier = all(&desk.out.join("manifests"));
    assert_eq!(earlier.len(), 1);
    assert_eq!(content(&earlier[0]), manifest);
}

#[test]
fn an_edited_file_is_not_overwritten() {
    let desk = Desk::with_class("edited", 2);
    let own = desk.short_plan("T");
    desk.sheet(&own, &[]).ends(0);
    let edited = desk.text("sheets.md") + "\nA word of my own.\n";
    put(&desk.out, "sheets.md", &edited);
    desk.sheet(&own, &[])
        .ends(2)
        .complains("sheets.md: was edited");
    assert_eq!(desk.text("sheets.md"), edited);
    desk.sheet(&own, &["--force"]).ends(0);
    assert_eq!(content(copies(&desk.out)[0].join("sheets.md")), edited);
    assert!(!desk.text("sheets.md").contains("of my own"));
}

#[test]
fn a_code_is_found_in_the_manifest_of_any_run() {
    let desk = Desk::with_class("any-manifest", 3);
    let own = desk.short_plan("T");
    desk.sheet(&own, &[]).ends(0);
    let old = answered(&desk.text("responses.csv"), "7");
    // Another seed: none of these codes is in the new manifest.
    let other = content(&own).replace("seed = 5", "seed = 6");
    let other = put(&desk.folder, "t.toml", other);
    desk.sheet(&other, &[]).ends(0);
    put(&desk.out, "responses.csv", &old);
    let ran = desk.grade(&["--no-feedback"]);
    assert!(!ran.err.contains("no sheet"), "{}", ran.err);
    assert!(!ran.out.contains("absent"), "{}", ran.out);
    ran.says("6 sheets");
    let marks = desk.text("marks/marks.csv");
    let row = old.lines().nth(1).expect("a row");
    let code = row.split(',').next().expect("a code");
    assert!(marks.contains(code), "{code} is not in {marks}");
}

#[test]
fn what_was_handed_out_is_marked_whatever_becomes_of_the_bank() {
    let mut desk = Desk::with_class("moved-on", 2);
    let bank = desk.folder.join("bank");
    for entry in all(Path::new(BANK)) {
        let inside = entry.strip_prefix(BANK).expect("it is inside");
        put(&bank, &text_of(inside), content(&entry));
    }
    desk.bank = text_of(&bank);
    desk.sheet(&desk.short_plan("T"), &[]).ends(0);
    desk.answer("7");
    let marks = ["first", "second", "third"].map(|name| text_of(&desk.folder.join(name)));
    let [first, second, third] = &marks;
    desk.grade(&["--no-feedback", "--out", first]);
    let item = bank.join("free/spring-mass.toml");
    let changed = content(&item) + "\n# Another revision.\n";
    put(&bank, "free/spring-mass.toml", changed);
    let again = || desk.grade(&["--no-feedback", "--out", second, "--compare", first]);
    let this = concat!("vibank ", env!("CARGO_PKG_VERSION"));
    let same = again().says("0 marks differ");
    assert!(!same.out.contains(this), "one version needs no name");
    let report = desk.folder.join("first/report.json");
    let former = content(&report).replace(this, "vibank 0.0.9");
    put(&desk.folder, "first/report.json", former);
    let ran = again().says("vibank 0.0.9 marked").says(this);
    assert!(ran.err.contains("the bank has moved on"), "{}", ran.err);
    fs::remove_file(&item).expect("it is there");
    desk.grade(&["--no-feedback", "--out", third])
        .says("2 sheets");
    let [first, second, third] = marks.map(|folder| content(Path::new(&folder).join("marks.csv")));
    assert_eq!(first, second);
    assert_eq!(first, third);
    let code = codes(&desk).into_values().next().expect("a code");
    desk.run(&["show", &code, "--manifest", &desk.path("manifest.json")])
        .ends(0);
}

#[test]
fn a_run_with_pseudonyms_knows_no_names() {
    let desk = Desk::new("pseudonyms");
    desk.class(&["id-4711", "id-4712"].map(str::to_owned));
    desk.secret();
    let top = "secret = 'exam.key'\nstudents = 'class.csv'\nformats = ['html', 'md', 'json']";
    let plan = desk.plan(top);
    let key = text_of(&desk.folder.join("who.csv"));
    desk.sheet(&plan, &["--pseudonyms", &key]).ends(0);
    for path in all(&desk.out) {
        assert!(!content(&path).contains("id-471"), "{}", path.display());
    }
    let who = content(&key);
    assert!(who.contains("id-4711,Name id-4711"), "{who}");
    let code = who
        .lines()
        .nth(1)
        .and_then(|row| row.split(',').next())
        .expect("a code");
    assert!(desk.text("responses.csv").contains(code));
    // A third student moves nobody, though the manifest knows no names.
    desk.class(&["id-4700", "id-4711", "id-4712"].map(str::to_owned));
    desk.sheet(&plan, &["--pseudonyms", &key]).ends(0);
    assert!(content(&key).contains(&format!("{code},id-4711")));
    let plain = desk.plan("seed = 1\nstudents = 'class.csv'");
    desk.sheet(&plain, &["--pseudonyms", &key])
        .ends(2)
        .complains("vibank new secret");
}

#[cfg(target_os = "linux")]
#[test]
fn what_cannot_be_printed_is_a_failure() {
    let item = "free/spring-mass";
    let commands: [&[&str]; 8] = [
        &["list", "--bank", BANK],
        &["show", item, "--bank", BANK],
        &["solve", item, "--bank", BANK],
        &["explain", "bank::size"],
        &["schema", "item"],
        &["completions", "bash"],
        &["completions", "--man"],
        &["--help"],
    ];
    for arguments in commands {
        let full = fs::OpenOptions::new().write(true).open("/dev/full");
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_vibank"));
        let command = command.args(arguments).stdout(full.expect("Linux has it"));
        let ran = command.output().expect("it starts");
        assert_eq!(ran.status.code(), Some(2), "{arguments:?}");
    }
}

/// Who reads the first lines and leaves, as `head` does, is no failure.
#[cfg(unix)]
#[test]
fn a_reader_that_leaves_is_no_failure() {
    for arguments in [
        &["completions", "bash"] as &[&str],
        &["--help"],
        &["list", "--bank", BANK],
    ] {
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_vibank"));
        let command = command.args(arguments).env("VIBANK_CACHE", "");
        let command = command
            .stdout(std::process::Stdio::piped())
            .stderr(std::process::Stdio::piped());
        let mut child = command.spawn().expect("it starts");
        drop(child.stdout.take());
        let ran = child.wait_with_output().expect("it ends");
        assert_eq!(ran.status.code(), Some(0), "{arguments:?}");
        assert!(ran.stderr.is_empty(), "{arguments:?}");
    }
}

#[test]
fn a_blueprint_that_would_be_misunderstood_is_refused() {
    let desk = Desk::new("misunderstood");
    for (top, words) in [
        ("formats = []", "`formats` is empty"),
        ("formats = ['md', 'md']", "`md` is listed twice"),
        ("language = 'de'", "the texts of the bank are in `en`"),
    ] {
        let plan = desk.plan(&format!("seed = 1\nvariants = 1\n{top}"));
        desk.sheet(&plan, &[]).ends(2).complains(words);
    }
    let plan = blueprint("seed = 1\nvariants = 1") + "points = nan\n";
    let plan = put(&desk.folder, "t.toml", plan);
    desk.sheet(&plan, &[])
        .ends(2)
        .complains("expected a number of points from 0.001 to 1000000");
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
