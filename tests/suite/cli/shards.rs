//! `vibank grade --shard`: parts that are marked apart and joined.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use super::desk::{Desk, all};
use super::{Ran, content, put, text_of};

/// A run of a class, of which every third answer is right, wrong or cannot be read, and the last ones handed nothing in.
fn answered(name: &str, count: usize) -> Desk {
    let desk = Desk::with_class(name, count);
    desk.sheet(
        &desk.plan("seed = 3\nstudents = 'class.csv'\nformats = ['json']"),
        &[],
    )
    .ends(0);
    let form = desk.text("responses.csv");
    let rows = form.lines().enumerate().map(|(at, row)| match at {
        0 => format!("{row}\n"),
        _ if at * 3 > form.lines().count() * 2 => format!("{row}\n"),
        _ => format!("{row}{}\n", ["5", "5 rad/s", "about so much?"][at % 3]),
    });
    let filled: String = rows.collect();
    put(
        &desk.out,
        "responses.csv",
        filled + "AAA-AAA-AAA,,1,a,numeric,,1\n",
    );
    desk
}

/// Marks the form into a folder beside the run.
fn mark(desk: &Desk, into: &str, more: &[&str]) -> Ran {
    let folder = text_of(&desk.folder.join(into));
    let (manifest, form) = (desk.path("manifest.json"), desk.path("responses.csv"));
    desk.run(&[&["grade", &manifest, &form, "--out", &folder], more].concat())
}

fn files(desk: &Desk, folder: &str) -> BTreeMap<String, String> {
    let root = desk.folder.join(folder);
    let file = |path: std::path::PathBuf| {
        let inside = path.strip_prefix(&root).expect("it is inside");
        (text_of(inside), content(&path))
    };
    all(&root).into_iter().map(file).collect()
}

/// Who gave way to another student was forgotten between the parts.
#[test]
fn sheets_that_are_joined_are_those_of_one_run() {
    let desk = Desk::with_class("shard-sheets", 24);
    // So few data that many first variants repeat another's.
    let question = "title = 'T'\nseed = 3\nstudents = 'class.csv'\nformats = ['md']\nsolutions = false\n\
        [[question]]\nitem = 'free/spring-mass'\nset = { k = '400 N/m' }\n";
    let plan = put(&desk.folder, "t.toml", question);
    let make = |into: &str, more: &[&str]| {
        let folder = text_of(&desk.folder.join(into));
        desk.run(&[&["sheet", &plan, "--out", &folder], more].concat())
            .ends(0)
    };
    for part in ["1/3", "2/3", "3/3"] {
        make("joined", &["--shard", part]);
    }
    make("joined", &["--split"]);
    make("single", &["--split"]).complains("gave way");
    let (joined, single) = (files(&desk, "joined"), files(&desk, "single"));
    assert!(single["fairness.md"].contains("Gave way"));
    assert_eq!(
        joined.keys().collect::<Vec<_>>(),
        single.keys().collect::<Vec<_>>()
    );
    for (name, text) in &single {
        assert!(joined[name] == *text, "{name}");
    }
}

#[test]
fn parts_that_are_joined_are_what_one_run_makes() {
    let desk = answered("grade-shards", 40);
    // A row of a sheet that was not handed out is a finding, of the join as of the whole run.
    mark(&desk, "whole", &[])
        .ends(1)
        .complains("rows to look at");
    for shard in ["3/3", "1/3", "2/3"] {
        let ran = mark(&desk, "parts", &["--shard", shard]).ends(0);
        ran.says(&format!("part {shard}"));
        assert!(!desk.folder.join("parts/marks.csv").exists());
    }
    mark(&desk, "parts", &[])
        .ends(1)
        .complains("rows to look at")
        .says("40 sheets");
    assert_eq!(files(&desk, "parts"), files(&desk, "whole"));
}

#[test]
fn parts_cost_about_the_same() {
    let desk = answered("grade-costs", 60);
    let sheets = |shard: &str| {
        mark(&desk, "parts", &["--shard", shard, "--no-feedback"]).ends(0);
        let name = format!("parts/marked-{}.jsonl", shard.replace('/', "of"));
        let part = content(desk.folder.join(name));
        let answers =
            part.matches("\"response\":\"5").count() + part.matches("about so much").count();
        (part.lines().count() - 2, answers)
    };
    let [first, second] = ["1/2", "2/2"].map(sheets);
    assert_eq!(first.0 + second.0, 60);
    // A third of the class handed in nothing, which costs less.
    assert!(second.0 > first.0 + 10, "{first:?} {second:?}");
    let parts = (desk.text("responses.csv").lines().count() - 2) / 60;
    let cost = |(sheets, answers): (usize, usize)| sheets * parts + 3 * answers;
    assert!(
        cost(first).abs_diff(cost(second)) <= 8 * parts,
        "{first:?} {second:?} of {parts} parts"
    );
}

#[test]
fn a_part_that_is_missing_or_twice_or_of_another_run_is_not_joined() {
    let desk = answered("grade-missing", 12);
    let join = || mark(&desk, "parts", &["--no-feedback"]);
    let part = |shard: &str| mark(&desk, "parts", &["--no-feedback", "--shard", shard]).ends(0);
    part("1/3");
    part("3/3");
    join()
        .ends(2)
        .complains("1 of 3 are missing: 2/3")
        .complains("--shard 2/3");
    // Another option gives other marks.
    mark(
        &desk,
        "parts",
        &["--no-feedback", "--accept-revisions", "--shard", "2/3"],
    )
    .ends(0);
    join()
        .ends(2)
        .complains("marked-2of3.jsonl was marked with another");
    part("2/3");
    let path = desk.folder.join("parts");
    let name = "marked-2of3.jsonl";
    let whole = content(path.join(name));
    // A copy that was cut off, between two lines and within one.
    let lines: Vec<&str> = whole.split_inclusive('\n').collect();
    for cut in [
        lines[..lines.len() - 1].concat(),
        whole[..whole.len() / 2].to_owned(),
    ] {
        put(&path, name, cut);
        join().ends(2).complains(name).complains("cut off");
    }
    // A sheet that is there twice, or not at all.
    for edited in [
        [&lines[..2], &lines[1..]].concat(),
        [&lines[..1], &lines[2..]].concat(),
    ] {
        put(&path, name, edited.concat());
        join().ends(2).complains(name);
    }
    put(&path, name, &whole);
    put(&path, "marked-1of2.jsonl", "");
    join().ends(2).complains("are of different runs");
    fs::remove_file(path.join("marked-1of2.jsonl")).expect("it is there");
    join().ends(1);
    assert!(!path.join(name).exists());
}

#[test]
fn a_part_that_was_interrupted_goes_on() {
    let desk = answered("grade-interrupted", 9);
    mark(&desk, "whole", &["--no-feedback", "--shard", "1/1"]).ends(1);
    mark(&desk, "parts", &["--no-feedback", "--shard", "1/2"]).ends(0);
    mark(&desk, "parts", &["--no-feedback", "--shard", "2/2"]).ends(0);
    let path = desk.folder.join("parts");
    let part = content(path.join("marked-2of2.jsonl"));
    let some: String = part.split_inclusive('\n').take(2).collect();
    fs::remove_file(path.join("marked-2of2.jsonl")).expect("it is there");
    // What a machine leaves that was switched off.
    put(&path, ".grading-2of2.jsonl", some + "{\"code\":\"X");
    mark(&desk, "parts", &["--no-feedback"])
        .ends(2)
        .complains("2/2");
    mark(&desk, "parts", &["--no-feedback", "--shard", "2/2"])
        .ends(0)
        .complains("1 sheet was marked before");
    assert_eq!(content(path.join("marked-2of2.jsonl")), part);
    mark(&desk, "parts", &["--no-feedback"]).ends(1);
    assert_eq!(files(&desk, "parts"), files(&desk, "whole"));
}

#[test]
fn a_student_who_is_forgotten_is_in_no_part() {
    let desk = answered("grade-forget", 6);
    let has = |id: &str| {
        let parts = all(&desk.out.join("marks"));
        let mut texts = parts.iter().filter(|path| !is_feedback(path)).map(content);
        texts.any(|text| text.contains(&format!("Name {id}")))
    };
    let (manifest, form) = (desk.path("manifest.json"), desk.path("responses.csv"));
    for shard in ["1/2", "2/2"] {
        desk.run(&["grade", &manifest, &form, "--shard", shard])
            .ends(0);
    }
    assert!(has("s2"));
    desk.forget("s2", &[]).ends(0);
    assert!(!has("s2"));
}

fn is_feedback(path: &Path) -> bool {
    path.components().any(|step| step.as_os_str() == "feedback")
}
