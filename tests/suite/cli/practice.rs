//! `vibank practice` with answers from a pipe.

use super::{BANK, content, fed, folder, text_of};

fn practice(arguments: &[&str], answers: &str) -> super::Ran {
    fed(
        &[&["practice", "--bank", BANK], arguments].concat(),
        answers.into(),
    )
}

#[test]
fn answers_from_a_pipe_are_marked_with_hints_and_solutions() {
    let ran = practice(
        &["free/spring-mass", "--seed", "3"],
        "?\n?\nquite fast\n1e9 rad/s\n!\n>\n",
    );
    ran.ends(0)
        .says("Natural frequency of a block on a spring")
        .says("a) Find its natural angular frequency.\n   ωₙ = ____ rad/s (value, 3 figures)")
        .says("hint 1 of 1: Compare stiffness and mass.")
        .says("There are no more hints")
        .says("? Could not be read")
        .says("✗ Not right")
        .says("With ω")
        .says("b) Find its natural frequency.")
        .says("0 of 1 part right");
}

#[test]
fn own_answers_go_on_and_nothing_is_kept_unless_asked() {
    let folder = folder("practice");
    let log = text_of(&folder.join("log.jsonl"));
    let ran = practice(
        &["free/spring-mass", "--seed", "3", "--log", &log],
        "30 rad/s\n>\n4.775 Hz\n",
    );
    ran.ends(0)
        .says("follow-through")
        .says("1 of 2 parts right");
    let kept = content(&log);
    let entries: Vec<serde_json::Value> = kept
        .lines()
        .map(|line| serde_json::from_str(line).expect("each line is JSON"))
        .collect();
    assert_eq!(entries.len(), 2);
    assert_eq!(entries[1]["reasons"][0], "follow-through");
}

#[test]
fn a_session_can_be_repeated_and_ends_with_its_input() {
    let first = practice(&["--seed", "5"], ">>\n>>\nquit\n").ends(0);
    let second = practice(&["--seed", "5"], ">>\n>>\nquit\n").ends(0);
    assert_eq!(first.out, second.out);
    assert!(first.out.contains("3 exercises"), "{}", first.out);
    // The exercises of a round differ.
    let titles: std::collections::BTreeSet<&str> = first
        .out
        .lines()
        .filter(|line| line.contains(" # "))
        .collect();
    assert_eq!(titles.len(), 3, "{}", first.out);
    practice(&["friction"], "")
        .ends(0)
        .says("1 exercise to choose");
    practice(&["no such thing"], "")
        .ends(2)
        .complains("no item fits");
}

#[test]
fn what_is_typed_cannot_steer_the_terminal() {
    let ran = practice(&["free/spring-mass"], "\u{1b}[31m5\u{7} rad/s\n").ends(0);
    assert!(
        !ran.out.contains('\u{1b}') && !ran.out.contains('\u{7}'),
        "{:?}",
        ran.out
    );
}

#[test]
fn what_comes_before_the_solutions_of_the_parts_is_shown_with_the_first_of_them() {
    let item = ["practice", "ch2/p4-disk-on-incline", "--seed", "1"];
    let shown = |answers: &str| {
        let ran = fed(&item, answers.into()).ends(0);
        let words: Vec<&str> = ran.out.split_whitespace().collect();
        let words = words.join(" ");
        words
            .matches("the disk turns about the contact point")
            .count()
    };
    assert_eq!(shown("quit\n"), 0);
    assert_eq!(shown(">\n!\nquit\n"), 1);
    assert_eq!(shown("!\n!\n!\nquit\n"), 1);
}
