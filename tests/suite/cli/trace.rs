//! `--trace`: what a command computed and what it skipped.

use super::{Ran, blueprint, folder, put, small, text_of};

/// The names after a word at the beginning of a line.
fn names(ran: &Ran, word: &str) -> Vec<String> {
    let line = ran
        .err
        .lines()
        .find_map(|line| line.strip_prefix(word))
        .expect("the list is there");
    line.split(',')
        .map(|name| name.trim().to_owned())
        .filter(|name| !name.is_empty())
        .collect()
}

#[test]
fn showing_a_question_computes_no_key() {
    let ran = small(&["show", "free/spring-mass", "--trace"]).ends(0);
    assert!(names(&ran, "computed:").is_empty(), "{}", ran.err);
    assert_eq!(names(&ran, "skipped:")[..3], ["omega_n", "f_n", "delta"]);
    let ran = small(&["show", "free/spring-mass", "--seed", "4", "--trace"]).ends(0);
    assert!(names(&ran, "computed:").is_empty(), "{}", ran.err);
}

#[test]
fn a_wanted_answer_computes_that_and_what_it_needs() {
    let solve =
        |want: &str| small(&["solve", "free/spring-mass", "--want", want, "--trace"]).ends(0);
    assert_eq!(names(&solve("delta"), "computed:"), ["delta"]);
    assert_eq!(names(&solve("omega_n"), "computed:"), ["omega_n"]);
    assert_eq!(names(&solve("f_n"), "computed:"), ["omega_n", "f_n"]);
}

#[test]
fn a_sheet_traces_its_first_variant() {
    let folder = folder("trace");
    let plan = put(&folder, "plan.toml", blueprint("seed = 1\nvariants = 1"));
    let out = text_of(&folder.join("out"));
    small(&["sheet", &plan, "--out", &out, "--trace"])
        .ends(0)
        .complains("question 1 of free/spring-mass: computed nothing; skipped omega_n");
}
