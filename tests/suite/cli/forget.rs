//! Removing one student: nothing of them is left but what is listed, and nothing of the others changes.

use std::path::{Path, PathBuf};

use serde_json::Value;

use super::desk::{Desk, all, ids};
use super::{content, put, text_of, vibank};

/// The code of a student's sheet.
fn code(desk: &Desk, id: &str) -> String {
    let manifest = desk.manifest();
    let variants = manifest["variants"].as_array().expect("it has sheets");
    let own = variants
        .iter()
        .find(|variant| variant["student"]["id"] == id);
    let code = own.and_then(|own| own["code"].as_str());
    code.expect("the student has a sheet").to_owned()
}

/// Files below a folder that contain one of these words.
fn with(folder: &Path, words: &[&str]) -> Vec<PathBuf> {
    let contains = |path: &PathBuf| {
        let text = content(path);
        words.iter().any(|word| text.contains(word))
    };
    all(folder).into_iter().filter(contains).collect()
}

const TOP: &str = "seed = 5\nstudents = 'class.csv'\nformats = ['html', 'md', 'json']";

#[test]
fn of_a_student_nothing_is_left_but_what_is_listed() {
    for split in [&[][..], &["--split"]] {
        let name = format!("forget-{}", split.len());
        let desk = Desk::with_class(&name, 12);
        let plan = desk.plan(TOP);
        desk.sheet(&plan, split).ends(0);
        let own = code(&desk, "s7");
        desk.answer("seven");
        desk.grade(&[]);
        desk.answer("8");
        desk.grade(&[]);
        let unreadable = desk.text("marks/unreadable.csv");
        let ran = desk.forget("s7", &["--dry-run"]).ends(0);
        let ran = ran.says("would be removed");
        assert!(!with(&desk.out, &[&own]).is_empty(), "{}", ran.out);
        let ran = desk.forget("s7", &[]).ends(0);
        let left = with(&desk.out, &["Name s7", "s7,", "\"s7\"", &own]);
        let is_table = |path: &PathBuf| text_of(path).contains("key-table");
        assert!(left.iter().all(is_table), "{left:?}\n{}", ran.out);
        for path in &left {
            assert!(ran.err.contains(&text_of(path)), "{}", ran.err);
        }
        assert!(!unreadable.is_empty());
        // Everybody else is marked as before.
        desk.grade(&[]).says("11 sheets").says("0 marks differ");
        desk.forget("s7", &[]).ends(2).complains("no manifest");
    }
}

#[test]
fn what_is_left_of_shared_files_is_what_the_others_had() {
    let desk = Desk::with_class("forget-pages", 9);
    let plan = desk.plan(TOP);
    desk.sheet(&plan, &[]).ends(0);
    let codes: Vec<String> = ids(1..10).iter().map(|id| code(&desk, id)).collect();
    let before: Vec<String> = ["sheets.html", "solutions.md", "sheets.jsonl"]
        .map(|name| desk.text(name))
        .into();
    for id in ["s1", "s5", "s9"] {
        desk.forget(id, &[]).ends(0);
    }
    let manifest = desk.manifest();
    for (name, before) in ["sheets.html", "solutions.md", "sheets.jsonl"]
        .iter()
        .zip(before)
    {
        let now = desk.text(name);
        for variant in manifest["variants"].as_array().expect("it has sheets") {
            let number = |at: usize| variant["pages"][name][at].as_u64().expect("a place") as usize;
            let page = &now[number(0)..number(0) + number(1)];
            assert!(
                page.contains(variant["code"].as_str().expect("a code")),
                "{name}"
            );
            assert!(before.contains(page), "{name}");
        }
        let gone = [0, 4, 8].map(|at| &codes[at]);
        assert!(gone.iter().all(|code| !now.contains(*code)), "{name}");
        assert_eq!(codes.iter().filter(|code| now.contains(*code)).count(), 6);
    }
    // The folder is sound: a run of the others finds everything as it made it.
    desk.class(&["s2", "s3", "s4", "s6", "s7", "s8"].map(str::to_owned));
    let kept = |manifest: &Value| -> Vec<String> {
        let variants = manifest["variants"].as_array().expect("it has sheets");
        variants
            .iter()
            .map(|variant| variant["code"].to_string())
            .collect()
    };
    let now = desk.text("sheets.html");
    desk.sheet(&plan, &[]).ends(0);
    assert_eq!(kept(&desk.manifest()), kept(&manifest));
    assert_eq!(desk.text("sheets.html"), now);
}

/// An accent is part of its letter in one file, and a letter of its own in the next, as systems save it.
#[test]
fn an_id_is_the_same_in_both_spellings_of_an_accent() {
    let desk = Desk::new("forget-accents");
    desk.class(&["ren\u{e9}", "ana"].map(str::to_owned));
    let plan = desk.short_plan("Accents");
    desk.sheet(&plan, &[]).ends(0);
    let own = code(&desk, "ren\u{e9}");
    desk.class(&["rene\u{301}", "ana"].map(str::to_owned));
    desk.sheet(&plan, &[]).ends(0);
    assert_eq!(code(&desk, "ren\u{e9}"), own);
    // As an early version wrote it: the student keeps the sheet, also where another one joins.
    let manifest = desk.text("manifest.json");
    let manifest = manifest.replace("ren\u{e9}", "rene\u{301}");
    put(&desk.out, "manifest.json", manifest);
    desk.class(&["rene\u{301}", "ana", "bea"].map(str::to_owned));
    desk.sheet(&plan, &["--force"]).ends(0);
    assert!(desk.text("manifest.json").contains(&own));
    assert_eq!(
        desk.manifest()["variants"].as_array().map(Vec::len),
        Some(3)
    );
    desk.forget("rene\u{301}", &[]).ends(0);
    assert!(with(&desk.out, &["ren\u{e9}"]).is_empty());
}

#[test]
fn earlier_runs_and_copies_forget_too() {
    let desk = Desk::with_class("forget-kept", 4);
    desk.sheet(&desk.short_plan("T"), &[]).ends(0);
    desk.answer("12");
    desk.grade(&[]);
    desk.sheet(&desk.short_plan("Corrected"), &["--force"])
        .ends(0);
    let own = code(&desk, "s2");
    put(&desk.out, "kept/notes.txt", "Name s2 was ill");
    let ran = desk.forget(&own.to_lowercase(), &[]);
    let ran = ran.ends(0).complains("notes.txt: the name");
    let left = with(&desk.out, &["Name s2", &own]);
    assert!(
        left.iter().all(|path| ran.err.contains(&text_of(path))),
        "{left:?}\n{}",
        ran.err
    );
    assert!(with(&desk.out.join("manifests"), &["s2"]).is_empty());
    let kept = with(&desk.out.join("kept"), &["s3"]);
    assert!(
        kept.iter().any(|path| path.ends_with("marks/marks.csv")),
        "{kept:?}"
    );
}

#[test]
fn like_answers_of_others_stay() {
    let desk = Desk::with_class("forget-like", 3);
    desk.sheet(&desk.short_plan("T"), &[]).ends(0);
    desk.answer("twelve or so");
    desk.grade(&[]);
    assert!(desk.text("marks/unreadable.csv").contains("s1; s2; s3"));
    desk.forget("s2", &[]).ends(0);
    let rows = desk.text("marks/unreadable.csv");
    let row = rows.lines().nth(1).expect("a row");
    assert!(row.starts_with("*,s1; s3,Name s1; Name s3,1,a,"), "{row}");
    assert!(row.contains(",twelve or so,2,"), "{row}");
}

#[test]
fn a_run_with_pseudonyms_forgets_by_code() {
    let desk = Desk::with_class("forget-pseudonyms", 3);
    desk.secret();
    let plan = desk.plan("secret = 'exam.key'\nstudents = 'class.csv'\nformats = ['md']");
    let key = text_of(&desk.folder.join("who.csv"));
    desk.sheet(&plan, &["--pseudonyms", &key]).ends(0);
    let who = content(&key);
    let row = who.lines().find(|row| row.contains(",s2,")).expect("a row");
    let own = row.split(',').next().expect("a code");
    desk.forget("s2", &[]).ends(2).complains("or the code");
    desk.forget(own, &[]).ends(0);
    let left = with(&desk.out, &[own]);
    assert!(
        left.iter().all(|path| text_of(path).contains("key-table")),
        "{left:?}"
    );
}

#[test]
fn an_interrupted_run_is_finished_first() {
    let desk = Desk::with_class("forget-interrupted", 2);
    desk.sheet(&desk.short_plan("T"), &[]).ends(0);
    put(&desk.out, ".sheet.run", "");
    desk.forget("s2", &[]).ends(2).complains("was interrupted");
    vibank(&["forget", &text_of(&desk.folder), "s2"])
        .ends(2)
        .complains("no manifest");
}
