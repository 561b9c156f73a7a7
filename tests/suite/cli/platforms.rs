//! `vibank grade` on reports of course platforms, as `tests/fixtures/platforms/README.md` says where they come from.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::{Ran, content, folder, put, text_of, vibank};

const FIXTURES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/platforms");

/// What was exported, and where it is marked.
struct Course {
    folder: PathBuf,
    bank: String,
}

impl Course {
    fn new(name: &str) -> Self {
        Self {
            folder: folder(name),
            bank: format!("{FIXTURES}/bank"),
        }
    }

    fn run(&self, arguments: &[&str]) -> Ran {
        vibank(&[arguments, &["--bank", &self.bank]].concat())
    }

    /// Makes what the fixture `report` answers; the path of the manifest or package.
    fn questions(&self, report: &str) -> String {
        let quiz = format!("{FIXTURES}/quiz.toml");
        let path = |name: &str| text_of(&self.folder.join(name));
        match report {
            "moodle-quiz.csv" | "moodle-quiz-fr.csv" => {
                let out = path("quiz.xml");
                self.run(&["export", "moodle", &quiz, "--essay", "--out", &out])
                    .ends(0);
                path("quiz.manifest.json")
            }
            "moodle-scorm.txt" => {
                let out = path("quiz.zip");
                self.run(&["page", &quiz, "--scorm", "1.2", "--out", &out])
                    .ends(0);
                out
            }
            _ => {
                let out = path("quiz.zip");
                self.run(&[
                    "export", "qti", &quiz, "--qti", "1.2", "--essay", "--out", &out,
                ])
                .ends(0);
                path("quiz.manifest.json")
            }
        }
    }

    fn grade(&self, questions: &str, report: &str, more: &[&str]) -> Ran {
        let out = text_of(&self.folder.join("marks"));
        self.run(&[&["grade", questions, report, "--out", &out], more].concat())
    }

    /// The verdicts by student and part, `1001 1a`.
    fn verdicts(&self) -> BTreeMap<String, String> {
        let details = content(self.folder.join("marks/details.csv"));
        let mut rows = csv::Reader::from_reader(details.as_bytes());
        let headings = rows.headers().expect("it has headings").clone();
        let at = |name: &str| {
            headings
                .iter()
                .position(|own| own == name)
                .expect("a column")
        };
        let [student, question, part, verdict] = ["student", "question", "part", "verdict"].map(at);
        rows.records()
            .map(|row| row.expect("a row"))
            .map(|row| {
                let place = format!("{} {}{}", &row[student], &row[question], &row[part]);
                (place, row[verdict].to_owned())
            })
            .collect()
    }
}

/// Exports, marks the fixture, and compares verdicts: `1001 1a right`, …
fn marked(report: &str, more: &[&str], expected: &str) -> (Course, Ran) {
    let course = Course::new(&format!("platform-{report}-{}", more.join("")));
    let questions = course.questions(report);
    let ran = course.grade(&questions, &format!("{FIXTURES}/{report}"), more);
    let verdicts = course.verdicts();
    let reported: Vec<String> = verdicts
        .iter()
        .map(|(place, verdict)| format!("{place} {verdict}"))
        .collect();
    let expected: Vec<&str> = expected
        .lines()
        .map(str::trim)
        .filter(|line| !line.is_empty())
        .collect();
    assert_eq!(reported, expected, "{}", ran.err);
    (course, ran)
}

/// What Moodle wrote of one quiz, on a site in English and on one in French.
const QUIZ: [&str; 2] = ["moodle-quiz.csv", "moodle-quiz-fr.csv"];

#[test]
fn answers_to_a_quiz_of_moodle_are_marked_by_this_grader() {
    for (report, [question, response]) in QUIZ
        .into_iter()
        .zip([["Question 3", "Response 2"], ["Question 3", "Réponse 2"]])
    {
        let (_, ran) = marked(report, &[], VERDICTS);
        ran.ends(1)
            .says("4 attempts of 3 students; of several the last counts")
            .complains(&format!("not marked: `{question}`"))
            .complains(&format!(
                "line 5, column `{response}`: the answers to b, d, e do not follow their letters"
            ));
    }
}

const VERDICTS: &str = "1001 1a right
         1001 1b right
         1001 1c right
         1001 1d right
         1001 1e right
         1002 1a wrong
         1002 1b unreadable
         1002 1c missing
         1002 1d unreadable
         1002 1e unreadable
         1004 1a right
         1004 1b unreadable
         1004 1c wrong
         1004 1d right
         1004 1e missing";

#[test]
fn first_and_best_attempts_are_told_apart() {
    let rest =
        "1002 1a wrong\n1002 1b unreadable\n1002 1c missing\n1002 1d unreadable\n1002 1e unreadable
         1004 1a right\n1004 1b unreadable\n1004 1c wrong\n1004 1d right\n1004 1e missing";
    let first = "1001 1a wrong\n1001 1b missing\n1001 1c wrong\n1001 1d missing\n1001 1e missing";
    marked(
        "moodle-quiz.csv",
        &["--attempt", "first"],
        &format!("{first}\n{rest}"),
    );
    let best = first.replace("wrong", "right").replace("missing", "right");
    marked(
        "moodle-quiz.csv",
        &["--attempt", "best"],
        &format!("{best}\n{rest}"),
    );
}

#[test]
fn answers_in_a_package_are_marked_anew() {
    let (_, ran) = marked(
        "moodle-scorm.txt",
        &[],
        "1001 1a right
         1001 1b right
         1001 1c right
         1001 1d partial
         1001 1e missing
         1002 1a wrong
         1002 1b missing
         1002 1c missing
         1002 1d missing
         1002 1e unreadable",
    );
    ran.ends(1)
        .complains("line 4, column `Response 1`: the platform keeps 255 characters of an answer");
}

#[test]
fn of_the_tries_in_a_package_the_one_that_is_wished_counts() {
    // Tries at `a` were wrong and right, at `d` right and half right.
    for (which, [a, d]) in [
        ("first", ["wrong", "right"]),
        ("last", ["right", "partial"]),
        ("best", ["right", "right"]),
    ] {
        let course = Course::new(&format!("platform-tries-{which}"));
        let package = course.questions("moodle-scorm.txt");
        let report = format!("{FIXTURES}/moodle-scorm.txt");
        course.grade(&package, &report, &["--attempt", which]);
        let verdicts = course.verdicts();
        assert_eq!(
            [&verdicts["1001 1a"], &verdicts["1001 1d"]],
            [a, d],
            "{which}"
        );
    }
}

#[test]
fn answers_to_a_quiz_of_canvas_are_marked_by_this_grader() {
    let (course, ran) = marked(
        "canvas-student-analysis.csv",
        &["--gradebook", "canvas"],
        "1001 1a right
         1001 1b right
         1001 1c right
         1001 1d right
         1001 1e missing
         502 1a right
         502 1b right
         502 1c wrong
         502 1d right
         502 1e right",
    );
    ran.ends(0).says("3 attempts of 2 students");
    let gradebook = content(course.folder.join("marks/gradebook.csv"));
    assert!(gradebook.contains("Ada Abel,501,1001,,,4\n"), "{gradebook}");
    assert!(gradebook.contains("Ben Berg,502,,,,4\n"), "{gradebook}");
}

/// The report of a quiz, changed.
fn changed(course: &Course, change: impl Fn(&str) -> String) -> String {
    let report = content(Path::new(FIXTURES).join("moodle-quiz.csv"));
    let changed = change(&report);
    assert_ne!(changed, report);
    put(&course.folder, "report.csv", changed)
}

#[test]
fn reports_are_read_in_the_language_of_the_site() {
    let course = Course::new("platform-german");
    let manifest = course.questions("moodle-quiz.csv");
    let report = changed(&course, |text| {
        text.replace("\"Last name\",\"First name\",\"ID number\",\"Email address\",Status,Started,Completed,Duration,Grade/10.00", "Nachname,Vorname,Kennung,E-Mail-Adresse,Status,Begonnen,Beendet,Dauer,\"Bewertung/10,00\"")
            .replace("Right answer ", "Richtige Antwort ")
            .replace("Question ", "Frage ")
            .replace("Response ", "Antwort ")
            .replace("part 1:", "Teil 1:")
            .replace("part 2:", "Teil 2:")
            .replace("2 November 2026  8:52 AM", "2. November 2026 08:52")
            .replace("2 November 2026  5:07 PM", "2. November 2026 17:07")
            .replace("18.7;", "18,7;")
    });
    course.grade(&manifest, &report, &[]).ends(1);
    let verdicts = course.verdicts();
    // No heading that is known says who it was: the address does.
    assert_eq!(verdicts["ada@example.org 1a"], "right");
    assert_eq!(verdicts["ada@example.org 1c"], "right");
    assert_eq!(verdicts["dev@example.org 1a"], "right");
}

#[test]
fn what_a_report_lacks_is_said() {
    let course = Course::new("platform-lacks");
    let manifest = course.questions("moodle-quiz.csv");
    let without = |name: &str| {
        changed(&course, |text| {
            let mut rows = csv::ReaderBuilder::new()
                .has_headers(false)
                .from_reader(text.as_bytes());
            let rows: Vec<csv::StringRecord> =
                rows.records().map(|row| row.expect("a row")).collect();
            let keeps: Vec<bool> = rows[0]
                .iter()
                .map(|heading| !heading.starts_with(name))
                .collect();
            let mut out = csv::Writer::from_writer(Vec::new());
            for row in &rows {
                let cells = row.iter().zip(&keeps).filter(|(_, keeps)| **keeps);
                out.write_record(cells.map(|(cell, _)| cell))
                    .expect("it is in memory");
            }
            String::from_utf8(out.into_inner().expect("it is in memory")).expect("it is text")
        })
    };
    let report = without("Question");
    course
        .grade(&manifest, &report, &[])
        .ends(2)
        .complains("tick the display of the question text");
    let report = without("Response");
    course
        .grade(&manifest, &report, &[])
        .ends(2)
        .complains("none with the response to it");
    // The questions of another export.
    let report = format!("{FIXTURES}/moodle-quiz.csv");
    let quiz = put(
        &course.folder,
        "other.toml",
        content(format!("{FIXTURES}/quiz.toml")).replace("seed = 7", "seed = 8"),
    );
    let out = text_of(&course.folder.join("other.xml"));
    course
        .run(&["export", "moodle", &quiz, "--out", &out])
        .ends(0);
    let other = text_of(&course.folder.join("other.manifest.json"));
    course
        .grade(&other, &report, &[])
        .ends(2)
        .complains("none of the questions of this report of responses is in the manifest");
    // Words of another box within an answer.
    let report = changed(&course, |text| {
        text.replace("part 1: 18.7;", "part 1: 3; part 2: 4;")
    });
    course
        .grade(&manifest, &report, &[])
        .ends(1)
        .complains("the answers of its boxes cannot be told apart");
    assert_eq!(course.verdicts()["1001 1a"], "unreadable");
}

/// A blueprint with two questions on the same item, which ask different parts under the same letters.
fn twice(course: &Course, second: &str) -> String {
    let question = |part: &str| {
        format!(
            "[[question]]\nitem = \"free/spring\"\nparts = [\"{part}\"]\nset = {{ m = \"2 kg\", k = \"800 N/m\" }}\n"
        )
    };
    let text = format!(
        "title = \"Twice\"\nseed = 7\nvariants = 1\n{}{}",
        question("omega_n"),
        question(second)
    );
    put(&course.folder, "twice.toml", text)
}

#[test]
fn an_item_that_stands_twice_gives_questions_that_are_told_apart() {
    let course = Course::new("platform-twice");
    let out = text_of(&course.folder.join("twice.xml"));
    course
        .run(&[
            "export",
            "moodle",
            &twice(&course, "heavier"),
            "--out",
            &out,
        ])
        .ends(0);
    let xml = content(&out);
    let names = xml.split("<name><text>").skip(1);
    let origins: Vec<&str> = names
        .filter_map(|name| name.split_once('[')?.1.split_once(']'))
        .map(|(origin, _)| origin)
        .collect();
    let [first, second] = origins[..] else {
        panic!("{origins:?}");
    };
    assert!(first.ends_with(" 1 a") && second.ends_with(" 2 a"));
    let manifest = text_of(&course.folder.join("twice.manifest.json"));
    // In the order of a quiz that is shuffled: sqrt(800/2) is 20.
    let report = format!(
        "Last name,First name,ID number,Question 1,Response 1,Question 2,Response 2\n\
         Abel,Ada,1001,{second},\"part 1: It becomes lower, as 12.\",{first},part 1: 20\n"
    );
    let report = put(&course.folder, "report.csv", report);
    course.grade(&manifest, &report, &[]).ends(0);
    let right = |place: &str| (place.to_owned(), "right".to_owned());
    let both: BTreeMap<String, String> = ["1001 1a", "1001 2a"].map(right).into();
    assert_eq!(course.verdicts(), both);
}

#[test]
fn an_item_that_stands_twice_in_a_package_is_marked_twice() {
    let course = Course::new("platform-package-twice");
    let package = text_of(&course.folder.join("twice.zip"));
    course
        .run(&[
            "page",
            &twice(&course, "symbol"),
            "--scorm",
            "1.2",
            "--out",
            &package,
        ])
        .ends(0);
    let shown = course.run(&["show", "--learner", "1001", &package]);
    let codes: Vec<&str> = shown
        .out
        .split(|char: char| char.is_whitespace() || char == ',')
        .filter(|word| word.len() == 11 && word.matches('-').count() == 2)
        .collect();
    let [first, second] = codes[..] else {
        panic!("{}", shown.out);
    };
    let report = |answers: &str| {
        let text = format!(
            "Name\tID number\tAttempt\tScore\tQuestion 0\tResponse 0\tResult 0\tQuestion 1\tResponse 1\tResult 1\nAda Abel\t1001\t1\t60\t{answers}\n"
        );
        put(&course.folder, "report.txt", text)
    };
    let both = format!(
        "free.spring.symbol.{second}.1\tsqrt(k/m)\tcorrect\tfree.spring.omega_n.{first}.1\t20 rad/s\tcorrect"
    );
    course.grade(&package, &report(&both), &[]).ends(0);
    let verdicts = course.verdicts();
    assert_eq!(
        (&*verdicts["1001 1a"], &*verdicts["1001 2a"]),
        ("right", "right")
    );
    // Of two questions on an item, the one that nobody answered counts as missing.
    let one = format!("free.spring.symbol.{second}.1\tsqrt(k/m)\tcorrect\t\t\t");
    course.grade(&package, &report(&one), &[]).ends(0);
    let verdicts = course.verdicts();
    assert_eq!(
        (&*verdicts["1001 1a"], &*verdicts["1001 2a"]),
        ("missing", "right")
    );
}
