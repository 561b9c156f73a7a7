//! The protocol of requests and replies, as files: what programs and pages send and get.
//!
//! `UPDATE_PROTOCOL=1 cargo test --test suite protocol` writes the replies anew. Names of fields stay; those of earlier
//! versions are held by `cli/golden.rs`.

use std::fs;
use std::path::Path;

use crate::BANK;
use vibank::bank::Compiled;
use vibank::document::Document;
use vibank::scene::Data;
use vibank::solution::Session;
use vibank::wasm::Grader;
use vibank::worksheet::{Practice, PracticeQuestion};

/// Compares the replies to the requests of a file with those that are kept.
#[track_caller]
fn keeps(name: &str, reply: impl FnMut(&str) -> String) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/protocol");
    let requests = folder.join(format!("{name}.requests.jsonl"));
    let replies = folder.join(format!("{name}.replies.jsonl"));
    let requests = fs::read_to_string(requests).expect("the requests are there");
    let found: String = requests
        .lines()
        .map(reply)
        .map(|reply| reply + "\n")
        .collect();
    if std::env::var_os("UPDATE_PROTOCOL").is_some() {
        fs::write(&replies, &found).expect("it can be written");
    }
    let due = fs::read_to_string(replies).expect("the replies are there");
    for (due, found) in due.lines().zip(found.lines()) {
        assert_eq!(found, due);
    }
    assert_eq!(found.lines().count(), due.lines().count());
}

#[test]
fn the_replies_of_solve_are_kept() {
    let bank = &*BANK;
    let mut session = Session::new(bank);
    keeps("solve", |line| {
        vibank::solution::request::answer(&mut session, line)
    });
}

#[test]
fn the_replies_of_mark_are_kept() {
    let bank = &*BANK;
    let mut session = Session::new(bank);
    keeps("mark", |line| {
        vibank::grade::request::answer(&mut session, line)
    });
}

#[test]
fn the_replies_of_compute_are_kept() {
    keeps("compute", vibank::compute::answer);
}

#[test]
fn the_replies_of_a_page_are_kept() {
    let bank = crate::answer::kinds();
    let item = bank.items().next().expect("an item");
    let practice = Practice {
        program: "test".into(),
        title: "Practice".into(),
        instructions: Document::default(),
        language: "en".into(),
        decimal: '.',
        doubt: vibank::answer::Doubt::default(),
        other_form: None,
        data: Data::Both,
        questions: vec![PracticeQuestion {
            parts: vec!["omega_n".into(), "both".into()],
            ..PracticeQuestion::of(item, 0, "Kinds")
        }],
    };
    let grader = Grader::of(&practice.lines(&[Compiled::of(item)])).expect("a page");
    let chosen = grader.answer(r#"{"do":"choose","question":0,"from":7}"#);
    let code: serde_json::Value = serde_json::from_str(&chosen).expect("it is JSON");
    let code = code["code"].as_str().expect("a code").to_owned();
    keeps("page", |line| grader.answer(&line.replace("CODE", &code)));
}
