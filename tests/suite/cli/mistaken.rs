//! Files given where other ones belong: the message says what was found, and what to give.

use super::desk::Desk;
use super::{content, put, text_of};

#[test]
fn swapped_arguments_are_named() {
    let desk = Desk::with_class("mistaken-swapped", 2);
    let plan = desk.plan("seed = 1\nstudents = \"class.csv\"");
    desk.sheet(&plan, &[]).ends(0);
    let (manifest, form) = (desk.path("manifest.json"), desk.path("responses.csv"));
    desk.run(&["grade", &form, &manifest])
        .ends(2)
        .complains("is the manifest of a run, not a list of answers")
        .complains("give the manifest first");
    desk.run(&["grade", &plan, &form])
        .ends(2)
        .complains("is a blueprint, not a manifest")
        .complains(&format!("vibank sheet {plan}"));
    for command in ["form", "enter"] {
        desk.run(&[command, &form])
            .ends(2)
            .complains("is a table of answers, not a manifest");
        desk.run(&[command, &plan])
            .ends(2)
            .complains("is a blueprint, not a manifest");
    }
    let class = text_of(&desk.folder.join("class.csv"));
    for command in ["sheet", "page"] {
        for (file, what) in [
            (&manifest, "the manifest of a run"),
            (&form, "a table of answers"),
            (&class, "a table"),
        ] {
            desk.run(&[command, file])
                .ends(2)
                .complains(&format!("is {what}, not a blueprint"));
        }
    }
}

#[test]
fn items_stand_in_the_place_of_a_blueprint() {
    let desk = Desk::with_class("mistaken-items", 1);
    let out = text_of(&desk.folder.join("page.html"));
    for (word, questions) in [
        ("free/spring-mass", "1 question"),
        ("on a spring", "2 questions"),
        ("free", "2 questions"),
    ] {
        desk.run(&["page", word, "--out", &out])
            .ends(0)
            .says(questions);
    }
    let questions = text_of(&desk.folder.join("questions.xml"));
    desk.run(&["export", "moodle", "free/spring-mass", "--out", &questions])
        .ends(0);
    desk.run(&["page", "free/sprng-mass", "--out", &out])
        .ends(2)
        .complains("did you mean `free/spring-mass`?");
    desk.run(&["page", "exam.toml", "--out", &out])
        .ends(2)
        .complains("cannot read `exam.toml`");
}

#[test]
fn what_is_no_item_is_named_and_shown_by_its_own_command() {
    let desk = Desk::with_class("mistaken-item", 2);
    let plan = desk.plan("seed = 1\nstudents = \"class.csv\"");
    desk.sheet(&plan, &[]).ends(0);
    let (manifest, form) = (desk.path("manifest.json"), desk.path("responses.csv"));
    let run = text_of(&desk.out);
    for (given, what, way) in [
        (
            &manifest,
            "the manifest of a run",
            "vibank show CODE --manifest",
        ),
        (
            &run,
            "the manifest of a run",
            &*format!("--manifest {manifest}"),
        ),
        (&plan, "a blueprint", "vibank preview"),
        (&form, "a table of answers", "vibank list"),
    ] {
        for command in ["show", "solve"] {
            desk.run(&[command, given])
                .ends(2)
                .complains(&format!("is {what}, not an item"))
                .complains(way);
        }
    }
    desk.run(&["preview", &manifest])
        .ends(2)
        .complains("is the manifest of a run, not a blueprint");
}

#[test]
fn the_folder_of_a_run_stands_for_its_manifest() {
    let desk = Desk::with_class("mistaken-folder", 2);
    let plan = desk.plan("seed = 1\nstudents = \"class.csv\"");
    desk.sheet(&plan, &[]).ends(0);
    let (run, form) = (text_of(&desk.out), desk.path("responses.csv"));
    desk.run(&["grade", &run, &form]).ends(0);
    let marks = content(desk.out.join("marks/marks.csv"));
    desk.run(&["grade", &desk.path("manifest.json"), &form])
        .ends(0);
    assert_eq!(content(desk.out.join("marks/marks.csv")), marks);
    desk.run(&["form", &run]).ends(0);
    assert!(desk.out.join("form").is_dir());
    // A folder without one is no manifest.
    desk.run(&["grade", &text_of(&desk.folder), &form])
        .ends(2)
        .complains("is a folder, not a file")
        .complains("give a file in it");
}

#[test]
fn a_file_is_no_folder_to_write_to() {
    let desk = Desk::with_class("mistaken-out", 2);
    let plan = desk.plan("seed = 1\nstudents = \"class.csv\"");
    let before = content(&plan);
    desk.run(&["sheet", &plan, "--out", &plan])
        .ends(2)
        .complains("is a file, not a folder")
        .complains("name a folder with `--out`");
    assert_eq!(content(&plan), before);
    desk.sheet(&plan, &[]).ends(0);
    desk.run(&[
        "grade",
        &text_of(&desk.out),
        &desk.path("responses.csv"),
        "--out",
        &plan,
    ])
    .ends(2)
    .complains("is a file, not a folder");
    assert_eq!(content(&plan), before);
}

#[test]
fn headings_that_say_nothing_of_answers_are_listed() {
    let desk = Desk::with_class("mistaken-headings", 2);
    let plan = desk.plan("seed = 1\nstudents = \"class.csv\"");
    desk.sheet(&plan, &[]).ends(0);
    let table = put(
        &desk.folder,
        "answers.csv",
        "code,question,part,respnse\nABC,1,a,2\n",
    );
    desk.run(&["grade", &text_of(&desk.out), &table])
        .ends(2)
        .complains("but `code`, `question`, `part`, `respnse`")
        .complains("is `respnse` meant to be `response`?");
}
