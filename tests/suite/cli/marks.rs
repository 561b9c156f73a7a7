//! From points to marks: scale, rounding, bonus, best questions, wrong choices, groups; and what is decided afterwards.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use super::{Ran, content, folder, put, text_of, vibank};

/// An item with a value, what follows from it, and a choice; the data are the same on all sheets.
const ITEM: &str = r#"
[item]
title = "A wheel"
source = "by hand"
[parameters]
f = "2 Hz"
R = "3 m"
[quantities]
omega = { formula = "2*pi*f", unit = "rad/s" }
v = { formula = "R*omega", unit = "m/s" }
[statement]
text = "A wheel of radius << R >> turns with << f >>."
[[part]]
key = "omega"
ask = "How fast does it turn?"
[[part]]
key = "v"
ask = "How fast is its rim?"
[[part]]
kind = "choice"
id = "way"
ask = "Its rim moves"
shuffle = false
options = [{ id = "along", text = "along the spoke" }, { id = "across", text = "across the spoke", right = true }]
"#;

/// A run of a class of four, and its marks.
struct Run {
    folder: PathBuf,
    codes: Vec<String>,
}

impl Run {
    fn new(name: &str, top: &str, questions: &str) -> Self {
        let folder = folder(name);
        put(&folder, "bank/bank.toml", "format = 1\ntitle = 'T'");
        put(&folder, "bank/c/_chapter.toml", "title = 'C'");
        put(&folder, "bank/c/a.toml", ITEM);
        put(&folder, "bank/c/b.toml", ITEM);
        put(
            &folder,
            "class.csv",
            "id,name,group\ns1,Ada,A\ns2,Ben,A\ns3,Cleo,B\ns4,Dan,B\n",
        );
        let head = "title = 'T'\nseed = 3\nstudents = 'class.csv'\nformats = ['json']\n";
        let plan = put(&folder, "plan.toml", format!("{head}{top}\n{questions}"));
        let out = text_of(&folder.join("out"));
        vibank(&[
            "sheet",
            &plan,
            "--bank",
            &text_of(&folder.join("bank")),
            "--out",
            &out,
        ])
        .ends(0);
        let manifest: serde_json::Value =
            serde_json::from_str(&content(folder.join("out/manifest.json"))).expect("JSON");
        let variants = manifest["variants"].as_array().expect("a list");
        let codes = variants.iter();
        let codes = codes.map(|own| own["code"].as_str().expect("a code").to_owned());
        Self {
            codes: codes.collect(),
            folder,
        }
    }

    /// Grades answers, a row a student: a letter for each part, `r` right, `w` wrong, `?` unreadable, `-` none.
    fn grade(&self, heads: &str, rows: &[&str], options: &[&str]) -> Ran {
        let mut form = format!("code,{heads}\n");
        for (code, row) in self.codes.iter().zip(rows) {
            form.push_str(&format!("{code},{row}\n"));
        }
        let form = put(&self.folder, "form.csv", form);
        let manifest = text_of(&self.folder.join("out/manifest.json"));
        let out = text_of(&self.folder.join("marks"));
        let bank = text_of(&self.folder.join("bank"));
        let arguments = ["grade", &manifest, &form, "--out", &out, "--bank", &bank];
        vibank(&[&arguments[..], options].concat())
    }

    /// The marks by student, each a map from headings to cells.
    fn marks(&self) -> Vec<BTreeMap<String, String>> {
        self.table("marks.csv")
    }

    fn table(&self, name: &str) -> Vec<BTreeMap<String, String>> {
        let text = content(self.folder.join("marks").join(name));
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let head: Vec<String> = reader
            .headers()
            .expect("a header")
            .iter()
            .map(str::to_owned)
            .collect();
        let rows = reader.records().map(|row| row.expect("a row"));
        rows.map(|row| {
            head.iter()
                .cloned()
                .zip(row.iter().map(str::to_owned))
                .collect()
        })
        .collect()
    }

    fn column(&self, name: &str) -> Vec<String> {
        let marks = self.marks();
        marks.iter().map(|row| row[name].clone()).collect()
    }

    fn decide(&self, text: &str) {
        put(&self.folder, "out/decisions.toml", text);
    }
}

const ONE: &str =
    "[[question]]\nitem = 'c/a'\npoints = 10\npart_points = { omega = 2, v = 5, way = 3 }\n";

#[test]
fn spare_sheets_that_nobody_used_are_in_no_statistics() {
    let top = "spares = 2\n[marks]\npass = '50 %'\n";
    let run = Run::new("marks-spares", top, ONE);
    let rows = [
        "12.57 rad/s,37.7 m/s,b",
        "12.57 rad/s,37.7 m/s,b",
        "12.57 rad/s,1 m/s,a",
        ",,",
        // Somebody who was not in the list got a spare sheet; the other one is left over.
        "12.57 rad/s,37.7 m/s,b",
    ];
    run.grade("1a,1b,1c", &rows, &[])
        .ends(0)
        .says("5 sheets: ")
        .says("1 spare sheet has no answer, and is in no statistics");
    assert_eq!(run.column("points"), ["10", "10", "2", "absent", "10", "0"]);
    let groups = run.table("groups.csv");
    let all = ["sheets", "mean", "passed", "failed"].map(|name| groups[0][name].as_str());
    assert_eq!(all, ["4", "8.000", "3", "1"]);
    let report = content(run.folder.join("marks/report.html"));
    assert!(report.contains("Spare sheets without an answer, left out: 1"));
}

#[test]
fn a_student_without_any_answer_was_absent_unless_somebody_says_otherwise() {
    let top = "[marks]\nscale = { A = '50 %', F = '0 %' }\npass = 'A'\n";
    let run = Run::new("marks-absent", top, ONE);
    let rows = [
        "12.57 rad/s,37.7 m/s,b",
        // Handed in without a word.
        "-,,",
        "1 rad/s,1 m/s,a",
        ",,",
    ];
    let heads = "1a,1b,1c";
    run.grade(heads, &rows, &["--gradebook", "canvas"])
        .ends(0)
        .says("4 sheets: ")
        .says("1 student has no answer and counts as absent: s4");
    assert_eq!(run.column("points"), ["10", "0", "0", "absent"]);
    assert_eq!(run.column("grade"), ["A", "F", "F", ""]);
    assert_eq!(run.column("passed"), ["yes", "no", "no", ""]);
    let absent = &run.marks()[3];
    assert_eq!(
        (&*absent["1"], &*absent["1a"], &*absent["undecided"]),
        ("", "", "")
    );
    assert_eq!((&*absent["name"], &*absent["max"]), ("Dan", "10"));
    let groups = run.table("groups.csv");
    let all = ["sheets", "mean", "passed", "failed", "pass rate"];
    assert_eq!(
        all.map(|name| groups[0][name].as_str()),
        ["3", "3.333", "1", "2", "0.333"]
    );
    let report = content(run.folder.join("marks/report.html"));
    assert!(report.contains("Students without an answer, absent: 1"));
    let book = content(run.folder.join("marks/gradebook.csv"));
    let row = book.lines().find(|row| row.contains("s4"));
    assert!(row.is_none_or(|row| row.ends_with(',')), "{book}");
    let feedback = |at: usize| {
        let name = format!("marks/feedback/{}.html", run.codes[at]);
        content(run.folder.join(name))
    };
    assert!(feedback(1).contains(", grade F") && !feedback(3).contains(", grade"));
    // Full marks for all are for those who were there.
    run.decide(
        "[[decision]]\nitem = 'c/a'\npart = 'v'\nvoid = 'full marks'\nwho = 'A'\nwhy = 'B'\n",
    );
    run.grade(heads, &rows, &[]).ends(0);
    assert_eq!(run.column("points"), ["10", "5", "5", "absent"]);
    // Points for this sheet say that the student was there, and so does the rule that there is no absence.
    run.decide(&format!(
        "[[decision]]\nitem = 'c/a'\npart = 'v'\nsheet = '{}'\npoints = 0\nwho = 'A'\nwhy = 'B'\n",
        run.codes[3]
    ));
    run.grade(heads, &rows, &[]).ends(0).says("4 sheets: ");
    assert_eq!(run.column("points"), ["10", "0", "0", "0"]);
    let none = "[marks]\nscale = { A = '50 %', F = '0 %' }\npass = 'A'\nabsent = 'zero'\n";
    run.decide(none);
    run.grade(heads, &rows, &[]).ends(0).says("4 sheets: ");
    assert_eq!(run.column("grade"), ["A", "F", "F", "F"]);
    run.decide(&none.replace("zero", "ill"));
    run.grade(heads, &rows, &[])
        .ends(2)
        .complains("`absent` cannot be `ill`")
        .complains("left out, zero");
}

#[test]
fn a_scale_makes_grades_and_what_is_open_leaves_them_open() {
    let top = "[marks]\nscale = { A = '90 %', B = '50 %', F = 0.0 }\n";
    let mixed = Run::new("marks-mixed", "", ONE);
    let plan = content(mixed.folder.join("plan.toml"));
    let broken = plan.replacen("[[question]]", &format!("{top}[[question]]"), 1);
    let broken = put(&mixed.folder, "broken.toml", broken);
    let bank = text_of(&mixed.folder.join("bank"));
    vibank(&["sheet", &broken, "--bank", &bank])
        .ends(2)
        .complains("grades in points and grades in percent")
        .complains("broken.toml:");
    let top = "[marks]\nscale = { A = '90 %', B = '50 %', F = '0 %' }\npass = 'B'\n";
    let run = Run::new("marks-scale", top, ONE);
    let rows = [
        "12.57 rad/s,37.7 m/s,b",
        "12.57 rad/s,about as much,b",
        "12.57 rad/s,1 m/s,a",
        ",37.7 m/s,",
    ];
    run.grade("1a,1b,1c", &rows, &[]).ends(0).says("groups.csv");
    assert_eq!(run.column("points"), ["10", "5 + ?5", "2", "5"]);
    assert_eq!(run.column("1"), ["10", "5 + ?5", "2", "5"]);
    assert_eq!(run.column("percent"), ["100", "50 + ?50", "20", "50"]);
    assert_eq!(run.column("grade"), ["A", "?B to A", "F", "B"]);
    // Whatever is decided, the second passes.
    assert_eq!(run.column("passed"), ["yes", "yes", "no", "yes"]);
    let groups = run.table("groups.csv");
    let of = |group: usize, name: &str| groups[group][name].as_str();
    assert_eq!(
        (of(0, "group"), of(0, "sheets"), of(0, "undecided")),
        ("*", "4", "1")
    );
    assert_eq!((of(0, "mean"), of(0, "median")), ("5.667", "5.000"));
    assert_eq!(of(0, "pass rate"), "0.750");
    assert_eq!(
        (of(1, "group"), of(1, "mean"), of(1, "pass rate")),
        ("A", "10.000", "1.000")
    );
    assert_eq!(
        (of(2, "mean"), of(2, "standard deviation")),
        ("3.500", "2.121")
    );
    let report = content(run.folder.join("marks/report.html"));
    assert!(report.contains("aria-label=\"Number of sheets by points. "));
    assert!(report.contains("pass mark 5"));
    assert!(
        content(
            run.folder
                .join("marks/feedback")
                .join(format!("{}.html", run.codes[0]))
        )
        .contains("10 of 10 points, grade A")
    );
}

#[test]
fn bonus_best_questions_rounding_and_wrong_choices_are_as_the_blueprint_says() {
    let top = "[marks]\nstep = 0.5\nround = 'up'\nbest = 1\nwrong_choice = '50 %'\n";
    let questions = "[[question]]\nitem = 'c/a'\npoints = 10\npart_points = { omega = 2, v = 5, way = 3 }\n\
         [[question]]\nitem = 'c/b'\nparts = ['omega', 'way']\npoints = 4.2\npart_points = { omega = 2.2, way = 2 }\n\
         [[question]]\nitem = 'c/b'\nparts = ['v']\npoints = 2\nbonus = true\n";
    let run = Run::new("marks-rules", top, questions);
    let heads = "1a,1b,1c,2a,2b,3a";
    let rows = [
        "12.57 rad/s,,a,12.57 rad/s,b,37.7 m/s",
        ",,a,,,",
        ",,,12.57 rad/s,,",
        ",,,12.57 rad/s,sideways,",
    ];
    run.grade(heads, &rows, &[]).ends(0);
    // 2 - 1.5 and 4.2 and a bonus of 2: 6.2, up to 6.5. A question is never below zero.
    assert_eq!(run.column("1"), ["0.5", "0", "0", "0"]);
    assert_eq!(run.column("1c"), ["-1.5", "-1.5", "0", "0"]);
    assert_eq!(run.column("2"), ["4.2", "0", "2.2", "1.2 + ?3"]);
    assert_eq!(run.column("points"), ["6.5", "0", "2.5", "1.5 + ?3"]);
    // Of ten and 4.2 the best one counts, and bonus is beyond.
    assert_eq!(run.column("max"), ["10"; 4]);
    let row: serde_json::Value = serde_json::from_str(
        content(run.folder.join("out/sheets.jsonl"))
            .lines()
            .next()
            .expect("a line"),
    )
    .expect("JSON");
    assert_eq!(row["points"], 10.0);
    run.decide("[marks]\nwrong_choice = 0.5\nbelow_zero = true\n");
    run.grade(heads, &rows, &[]).ends(0);
    assert_eq!(run.column("1"), ["0.5", "-1.5", "0", "0"]);
    assert_eq!(run.column("points"), ["6.7", "-1.5", "2.2", "1.2 + ?3"]);
}

#[test]
fn decisions_are_carried_out_logged_and_listed_with_what_they_change() {
    let run = Run::new("decisions", "", ONE);
    let rows = [
        "12.57 rad/s,37.7 m/s,b",
        "see sketch,12 m/s,a",
        "very fast,75.4 m/s,a",
        "0.012570 1/ms,,",
    ];
    let heads = "1a,1b,1c";
    run.grade(heads, &rows, &[]).ends(0);
    assert_eq!(run.column("1a"), ["2", "?2", "?2", "2"]);
    let signed = "who = 'A. Meyer'\nwhy = 'The committee met.'\n";
    // A key that was wrong: the rim is twice as fast.
    run.decide(&format!(
        "[[decision]]\nitem = 'c/a'\npart = 'v'\nkey = '2*R*omega'\n{signed}\
         [[decision]]\nquestion = 1\npart = 'a'\ngiven = 'very fast'\nread = '12.6 rad/s'\n{signed}\
         [[decision]]\nitem = 'c/a'\npart = 'omega'\naccept = ['see  sketch']\ncredit = 0.5\n{signed}\
         [[decision]]\nitem = 'c/a'\npart = 'way'\nsheet = '{}'\npoints = 3\nfeedback = 'You asked about it.'\n{signed}",
        run.codes[3].to_lowercase()
    ));
    run.grade(heads, &rows, &[])
        .ends(0)
        .says("4 decisions have changed 5 marks")
        .says("`v` of `c/a`: key corrected to `2*R*omega`, by A. Meyer")
        .says(&format!("{} (s1) 1b: 5 of 5 → 0 of 5", run.codes[0]))
        .says("?2 of 2 → 1 of 2")
        .says("marks differ from the earlier run");
    assert_eq!(run.column("1a"), ["2", "1", "2", "2"]);
    assert_eq!(run.column("1b"), ["0", "0", "5", "0"]);
    assert_eq!(run.column("1c"), ["3", "0", "0", "3"]);
    let log = run.table("decisions.csv");
    assert_eq!(log.len(), 5);
    assert_eq!(log[0]["who"], "A. Meyer");
    assert_eq!(
        (&*log[1]["code"], &*log[1]["points"]),
        (&*run.codes[2], "5")
    );
    // What one student wrote changes the mark of no other.
    let accepted = log
        .iter()
        .filter(|row| row["decided"].contains("see  sketch"));
    let accepted: Vec<&str> = accepted.map(|row| row["code"].as_str()).collect();
    assert_eq!(accepted, [run.codes[1].as_str()]);
    let report = content(run.folder.join("marks/report.html"));
    for words in [
        "<h2>Decisions</h2>",
        "The committee met.",
        "decisions.toml, line 1",
        "5 of 5 → 0 of 5",
    ] {
        assert!(report.contains(words), "{words}");
    }
    assert!(
        content(
            run.folder
                .join("marks/feedback")
                .join(format!("{}.html", run.codes[3]))
        )
        .contains("You asked about it.")
    );
    // Names stay out where marks are anonymous; groups stay.
    run.grade(heads, &rows, &["--anonymous"]).ends(0);
    for file in fs::read_dir(run.folder.join("marks")).expect("a folder") {
        let path = file.expect("a file").path();
        if path.is_file() && !path.ends_with("changes.csv") {
            let text = content(&path);
            assert!(
                !text.contains("Ada") && !text.contains("s1,"),
                "{}",
                path.display()
            );
        }
    }
    assert_eq!(run.column("group"), ["A", "A", "B", "B"]);
    assert_eq!(run.column("student"), [""; 4]);
}

#[test]
fn a_key_of_a_question_of_ones_own_can_be_corrected() {
    let question = "[[question]]\ntitle = 'A swing'\nstatement = 'A swing takes 2.5 s.'\nparameters = { T = '2.5 s' }\n\
        [[question.part]]\nask = 'Find its frequency.'\nkey = '0.5 Hz'\n\
        [[question.part]]\nask = 'Find ten cycles.'\nkey = '9*T'\nunit = 's'\n\
        [[question.part]]\nkind = 'formula'\nask = 'Find five cycles in T.'\nkey = '4*T'\n";
    let run = Run::new("own-key", "", question);
    let rows = ["0.4 Hz,25 s,5 T", "0.5 Hz,22.5 s,4 T", "-,,", "-,,"];
    let heads = "1a,1b,1c";
    run.grade(heads, &rows, &[]).ends(0);
    assert_eq!(run.column("points"), ["0", "3", "0", "0"]);
    let key = |part: &str, key: &str| {
        format!(
            "[[decision]]\nquestion = 1\npart = '{part}'\nkey = '{key}'\nwho = 'A'\nwhy = 'B'\n"
        )
    };
    run.decide(&[key("a", "0.4 Hz"), key("b", "10*T"), key("c", "5*T")].concat());
    run.grade(heads, &rows, &[]).ends(0);
    assert_eq!(run.column("points"), ["3", "0", "0", "0"]);
}

#[test]
fn a_void_part_gives_its_points_to_all_to_the_others_or_to_nobody() {
    let run = Run::new("void", "", ONE);
    let rows = [
        "12.57 rad/s,37.7 m/s,b",
        "12.57 rad/s,1 m/s,a",
        ",what?,b",
        "-,,",
    ];
    let void = |how: &str| {
        run.decide(&format!(
            "[[decision]]\nitem = 'c/a'\npart = 'v'\nvoid = '{how}'\nwho = 'A'\nwhy = 'B'\n"
        ));
        run.grade("1a,1b,1c", &rows, &[]).ends(0);
        [run.column("points"), run.column("max"), run.column("1b")]
    };
    let [points, max, part] = void("full marks");
    assert_eq!(points, ["10", "7", "8", "5"]);
    assert_eq!(
        (max, part),
        (vec!["10".to_owned(); 4], vec!["5".to_owned(); 4])
    );
    let [points, max, part] = void("left out");
    assert_eq!(points, ["5", "2", "3", "0"]);
    assert_eq!(
        (max, part),
        (vec!["5".to_owned(); 4], vec!["0".to_owned(); 4])
    );
    // The other parts have 5 of 10 points, which are doubled.
    let [points, max, _] = void("rescaled");
    assert_eq!(points, ["10", "4", "6", "0"]);
    assert_eq!(max, ["10"; 4]);
    assert_eq!(run.column("1a"), ["4", "4", "0", "0"]);
}

#[test]
fn points_of_a_void_part_are_changes_of_its_decision_alone() {
    let run = Run::new("void-beside", "", ONE);
    let decision = |part: &str, how: &str| {
        format!(
            "[[decision]]\nitem = 'c/a'\npart = '{part}'\nvoid = '{how}'\nwho = '{part}'\nwhy = 'B'\n"
        )
    };
    run.decide(&(decision("omega", "full marks") + &decision("v", "rescaled")));
    let rows = ["1 rad/s,1 m/s,b", ",,", ",,", ",,"];
    run.grade("1a,1b,1c", &rows, &[]).ends(0);
    let decided = run.table("decisions.csv");
    let first = decided.iter().filter(|row| row["code"] == run.codes[0]);
    let reported: Vec<(&str, &str)> = first
        .map(|row| (row["who"].as_str(), row["part"].as_str()))
        .collect();
    // All of `omega`, and twice the 3 points of the choice, which only the 5 of `v` make more.
    assert_eq!(reported, [("omega", "a"), ("v", "b"), ("v", "c")]);
    assert_eq!(run.column("points")[0], "10");
}

#[test]
fn a_decision_that_cannot_be_carried_out_is_refused_with_its_place() {
    let run = Run::new("decisions-wrong", "", ONE);
    let refused = |text: &str, words: &[&str]| {
        run.decide(text);
        let ran = run.grade("1a,1b,1c", &["", "", "", ""], &[]).ends(2);
        words.iter().fold(ran, |ran, words| ran.complains(words));
    };
    let signed = "who = 'A'\nwhy = 'B'\n";
    refused(
        "[[decision]]\nitem = 'c/a'\npart = 'v'\nvoid = 'full'\nwho = ''\n",
        &[
            "`void` cannot be `full`",
            "has no `why`",
            "`who` is empty",
            "decisions.toml:4:8",
            "full marks, rescaled",
        ],
    );
    let cases = [
        (
            "item = 'c/aa'\npart = 'v'\npoints = 1\n",
            "did you mean `c/a`?",
        ),
        (
            "item = 'c/a'\npart = 'omgea'\npoints = 1\n",
            "did you mean `omega`?",
        ),
        (
            "question = 7\npart = 'a'\npoints = 1\n",
            "no sheet has a question 7",
        ),
        ("part = 'a'\npoints = 1\n", "neither `item` nor `question`"),
        (
            "item = 'c/a'\npart = 'v'\npoints = 1\nread = '2'\n",
            "this one has read and points",
        ),
        (
            "item = 'c/a'\npart = 'v'\nsheet = 'AAA'\npoints = 1\n",
            "no sheet AAA was handed out",
        ),
        (
            "item = 'c/a'\npart = 'v'\nkey = 'R*omgea'\n",
            "part `v` cannot have this key",
        ),
        (
            "item = 'c/a'\npart = 'way'\nkey = 'beside'\n",
            "among along, across",
        ),
        (
            "item = 'c/a'\npart = 'v'\npoint = 1\n",
            "did you mean `points`?",
        ),
    ];
    for (text, words) in cases {
        refused(
            &format!("[[decision]]\n{text}{signed}"),
            &[words, "decisions.toml"],
        );
    }
    let twice = format!("[[decision]]\nitem = 'c/a'\npart = 'v'\npoints = 1\n{signed}");
    refused(&twice.repeat(2), &["already decided in line 1"]);
    let all = ["omega", "v", "way"].map(|part| {
        format!("[[decision]]\nitem = 'c/a'\npart = '{part}'\nvoid = 'rescaled'\n{signed}")
    });
    refused(&all.concat(), &["nothing can take over its points"]);
    // The right option is another one.
    run.decide(&format!(
        "[[decision]]\nitem = 'c/a'\npart = 'way'\nkey = 'along'\n{signed}"
    ));
    run.grade("1a,1b,1c", &[",,a", ",,b", "-,,", "-,,"], &[])
        .ends(0);
    assert_eq!(run.column("1c"), ["3", "0", "0", "0"]);
}
