//! `vibank grade`: a filled form with everything that can go wrong in one, and nothing is lost.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::path::PathBuf;

use serde_json::Value as Json;

use super::{Ran, blueprint, content, folder, put, small, text_of, vibank};

/// A run of thirty sheets, and the form as it is filled in.
struct Exam {
    folder: PathBuf,
    manifest: Json,
    rows: Vec<[String; 4]>,
}

impl Exam {
    fn new(name: &str, top: &str) -> Self {
        let folder = folder(name);
        put(
            &folder,
            "class.csv",
            "id,name,group\n1,<b>Ada</b>,=A1\n2,\"Nobody,\nat all\",\n",
        );
        let plan = put(&folder, "test.toml", blueprint(top));
        small(&["sheet", &plan, "--out", &text_of(&folder.join("out"))]).ends(0);
        let manifest = serde_json::from_str(&content(folder.join("out/manifest.json")));
        Self {
            folder,
            manifest: manifest.expect("the manifest is JSON"),
            rows: Vec::new(),
        }
    }

    fn code(&self, variant: usize) -> String {
        self.manifest["variants"][variant]["code"]
            .as_str()
            .expect("it has a code")
            .to_owned()
    }

    /// A datum of a question, in its own unit.
    fn datum(&self, variant: usize, question: usize, name: &str) -> f64 {
        let values = &self.manifest["variants"][variant]["questions"][question - 1]["values"];
        let text = values[name].as_str().expect("it has the datum");
        let number = text.split(' ').next().unwrap_or_default();
        number.parse().expect("a value begins with its number")
    }

    /// √(k/m) of the first question, by hand.
    fn omega(&self, variant: usize) -> f64 {
        (self.datum(variant, 1, "k") / self.datum(variant, 1, "m")).sqrt()
    }

    fn answer(&mut self, variant: usize, place: &str, response: impl Into<String>) {
        let (question, part) = place.split_at(1);
        let row = [
            self.code(variant),
            question.to_owned(),
            part.to_owned(),
            response.into(),
        ];
        self.rows.push(row);
    }

    /// Grades the form; the details by sheet and part.
    fn grade(&self, more: &str) -> (Ran, BTreeMap<(String, String), Json>) {
        self.grade_with(more, &[])
    }

    fn grade_with(&self, more: &str, options: &[&str]) -> (Ran, BTreeMap<(String, String), Json>) {
        let mut form = csv::Writer::from_writer(Vec::new());
        form.write_record(["code", "question", "part", "response"])
            .expect("it is in memory");
        for row in &self.rows {
            form.write_record(row).expect("it is in memory");
        }
        let mut form = form.into_inner().expect("it is in memory");
        form.extend_from_slice(more.as_bytes());
        let form = put(&self.folder, "form.csv", form);
        let manifest = text_of(&self.folder.join("out/manifest.json"));
        let out = text_of(&self.folder.join("marks"));
        let arguments = ["grade", &manifest, &form, "--out", &out];
        let ran = small(&[&arguments[..], options].concat());
        let results: Vec<Json> =
            serde_json::from_str(&content(self.folder.join("marks/results.json"))).expect("JSON");
        let key = |entry: &Json| {
            let text = |name: &str| entry[name].as_str().unwrap_or_default().to_owned();
            (
                text("code"),
                format!("{}{}", entry["question"], text("part")),
            )
        };
        (
            ran,
            results
                .into_iter()
                .map(|entry| (key(&entry), entry))
                .collect(),
        )
    }
}

#[test]
fn a_filled_form_is_marked_row_by_row_and_nothing_is_lost() {
    let mut exam = Exam::new("grade", "seed = 7\nvariants = 30");
    for variant in 0..30 {
        let omega = exam.omega(variant);
        exam.answer(variant, "1a", format!("{omega:.4} rad/s"));
    }
    let omega = |exam: &Exam, variant| exam.omega(variant);
    let (zero, one, two) = (omega(&exam, 0), omega(&exam, 1), omega(&exam, 2));
    exam.answer(0, "1b", format!("{:.3} Hz", zero / TAU));
    exam.answer(1, "1b", format!("{:.3} Hz", 1.5 * one / TAU));
    exam.answer(2, "1b", format!("{two:.3} Hz"));
    exam.answer(3, "1b", "3.2 kg");
    exam.answer(4, "1b", "about as much");
    exam.answer(
        5,
        "1b",
        format!("{:.3} Hz", 2_f64.sqrt() * omega(&exam, 5) / TAU),
    );
    exam.answer(6, "1b", "");
    let right = format!("{:.3} Hz", omega(&exam, 7) / TAU);
    exam.answer(7, "1b", right.clone());
    exam.answer(7, "1b", right);
    exam.answer(7, "1b", "");
    exam.answer(8, "1b", "3 Hz");
    exam.answer(8, "1b", "4 Hz");
    exam.answer(9, "1b", format!("{:.4} rpm", 60.0 * omega(&exam, 9) / TAU));
    exam.answer(10, "1b", "=HYPERLINK(\"http://x\")");
    exam.answer(11, "1b", "3,1 \"Hz\"\nor so");
    exam.answer(12, "9z", "5");
    let more = "AAA-AAA-AAA,1,a,5 rad/s\nAAA-AAA-AAA,two,a,5 rad/s\n";
    let (ran, details) = exam.grade(more);
    let ran = ran.ends(1);
    // Every part of every sheet has its entry.
    assert_eq!(details.len(), 30 * 7);
    let of = |variant: usize, part: &str| &details[&(exam.code(variant), part.to_owned())];
    for variant in 0..30 {
        assert_eq!(
            of(variant, "1a")["verdict"],
            "right",
            "{}",
            of(variant, "1a")
        );
    }
    let expected = [
        (0, "right", "matches"),
        (1, "wrong", "other"),
        (2, "wrong", "two-pi"),
        (3, "wrong", "dimension"),
        (4, "unreadable", "unreadable"),
        (5, "wrong", "mistake-1"),
        (6, "missing", "missing"),
        (7, "right", "matches"),
        (8, "unreadable", "unreadable"),
        (9, "right", "matches"),
        (10, "unreadable", "unreadable"),
        (11, "unreadable", "unreadable"),
        (12, "missing", "missing"),
    ];
    for (variant, verdict, reason) in expected {
        let entry = of(variant, "1b");
        assert_eq!(
            (&entry["verdict"], &entry["reasons"][0]),
            (&verdict.into(), &reason.into()),
            "{entry}"
        );
        assert_ne!(entry["feedback"], "", "each has its line: {entry}");
        let points = match verdict {
            "right" => Json::from(2.0),
            "unreadable" => Json::Null,
            _ => Json::from(0.0),
        };
        assert_eq!(entry["points"], points);
    }
    assert_eq!(of(5, "1b")["feedback"], "There is one spring only.");
    assert!(
        of(2, "1b")["feedback"]
            .as_str()
            .is_some_and(|text| text.contains("2π"))
    );
    assert_eq!(of(11, "1b")["response"], "3,1 \"Hz\"\nor so");
    // What could not be counted is reported with its line.
    ran.complains("part 1b of sheet")
        .complains("was already answered differently in line")
        .complains("question `two` is not a number")
        .complains("no part 1a of a sheet AAA-AAA-AAA")
        .complains("no part 9z of a sheet")
        .complains("about as much")
        .says("30 sheets");
    sums_agree(&exam, &details);
}

/// The marks are the sums of the details, and both tables are CSV with a row for each.
fn sums_agree(exam: &Exam, details: &BTreeMap<(String, String), Json>) {
    let text = content(exam.folder.join("marks/marks.csv"));
    let mut marks = csv::Reader::from_reader(text.as_bytes());
    let columns = marks.headers().expect("it has a header").clone();
    assert_eq!(
        columns.iter().collect::<Vec<_>>(),
        [
            "code",
            "student",
            "name",
            "group",
            "points",
            "max",
            "undecided",
            "undecided points",
            "1",
            "1a",
            "1b",
            "2",
            "2a",
            "2b",
            "2c",
            "3",
            "3a",
            "3b"
        ]
    );
    let rows: Vec<csv::StringRecord> = marks.records().map(|row| row.expect("a row")).collect();
    assert_eq!(rows.len(), 30);
    for row in &rows {
        let sum: f64 = details
            .iter()
            .filter(|((code, _), _)| *code == row[0])
            .filter_map(|(_, entry)| entry["points"].as_f64())
            .sum();
        // What is not decided comes after the sum of what is.
        let points = row[4].split(" + ?").next().expect("it begins with points");
        assert_eq!(points.parse::<f64>().expect("points are a number"), sum);
        assert_eq!(&row[5], "8");
    }
    let text = content(exam.folder.join("marks/details.csv"));
    let mut table = csv::Reader::from_reader(text.as_bytes());
    let rows: Vec<csv::StringRecord> = table.records().map(|row| row.expect("a row")).collect();
    assert_eq!(rows.len(), details.len());
    let formula = rows
        .iter()
        .find(|row| row[6].contains("HYPERLINK"))
        .expect("it is there");
    assert!(
        formula[6].starts_with('\''),
        "a spreadsheet takes it for text"
    );
}

#[test]
fn marks_go_to_the_gradebook_of_a_platform_and_what_is_undecided_is_no_mark() {
    let mut exam = Exam::new("gradebook", "seed = 7\nstudents = \"class.csv\"");
    let omega = exam.omega(0);
    exam.answer(0, "1a", format!("{omega:.4} rad/s"));
    exam.answer(1, "1a", "about as much");
    let book = |exam: &Exam, options: &[&str]| {
        let (ran, results) = exam.grade_with("", options);
        let points = results
            .values()
            .filter(|part| part["code"] == exam.code(0).as_str());
        let points: f64 = points.filter_map(|part| part["points"].as_f64()).sum();
        let most: f64 = results
            .values()
            .filter(|part| part["code"] == exam.code(0).as_str())
            .filter_map(|part| part["max"].as_f64())
            .sum();
        let table = content(exam.folder.join("marks/gradebook.csv"));
        let mut reader = csv::ReaderBuilder::new()
            .has_headers(false)
            .from_reader(table.as_bytes());
        let rows: Vec<Vec<String>> = reader
            .records()
            .map(|row| row.expect("a row").iter().map(str::to_owned).collect())
            .collect();
        (ran, rows, points, most)
    };
    let (_, rows, points, _) = book(&exam, &["--gradebook", "moodle"]);
    assert_eq!(rows[0][0], "ID number");
    assert_eq!(rows[1][0], "1");
    assert!((rows[1][1].parse::<f64>().expect("points") - points).abs() < 0.01 && points > 0.0);
    assert_eq!(rows.len(), 2, "nobody has decided the second one");
    let (_, rows, _, most) = book(&exam, &["--gradebook", "canvas"]);
    let head = ["Student", "ID", "SIS User ID", "SIS Login ID", "Section"];
    assert_eq!(rows[0][..5], head);
    assert_eq!(rows[1][0], "Points Possible");
    assert!((rows[1][5].parse::<f64>().expect("points") - most).abs() < 0.01);
    assert_eq!(rows[2][2], "1");
    assert_eq!([&rows[3][2], &rows[3][5]], ["2", ""]);
}

#[test]
fn what_students_write_stays_text_on_their_page() {
    let mut exam = Exam::new("escape", "seed = 7\nstudents = \"class.csv\"");
    exam.answer(0, "1a", "<img src=x onerror=alert(1)> rad/s");
    exam.answer(0, "2c", "<script>alert(1)</script>");
    exam.answer(1, "1a", "20 rad/s\" onclick=\"alert(1)");
    exam.grade("").0.ends(0);
    for variant in 0..2 {
        let page = content(
            exam.folder
                .join(format!("marks/feedback/{}.html", exam.code(variant))),
        );
        for tag in ["<img", "<script", "<b>Ada", "\" onclick=\""] {
            assert!(!page.contains(tag), "{tag} is executed");
        }
    }
    let page = content(
        exam.folder
            .join(format!("marks/feedback/{}.html", exam.code(0))),
    );
    assert!(page.contains("&lt;img") && page.contains("&lt;b&gt;Ada&lt;/b&gt;"));
    let marks = content(exam.folder.join("marks/marks.csv"));
    assert!(
        marks.contains("'=A1"),
        "a group that looks like a formula: {marks}"
    );
}

#[test]
fn a_form_with_one_row_a_sheet_and_one_in_json_are_marked_alike() {
    let exam = Exam::new("layouts", "seed = 7\nvariants = 2");
    let answer = format!("{:.4}", exam.omega(0));
    let code = exam.code(0);
    let forms = [
        (
            "wide.csv",
            format!(
                "code;1a;1b\n{};{} rad/s;\n",
                code.to_lowercase(),
                answer.replace('.', ",")
            ),
        ),
        (
            "bom.csv",
            format!("\u{feff}part,code,response,question\r\nA, {code} ,{answer} rad/s,1\r\n"),
        ),
        (
            "list.json",
            format!(
                "[{{\"code\":\"{code}\",\"question\":1,\"part\":\"a\",\"response\":\"{answer} rad/s\"}}]"
            ),
        ),
    ];
    let manifest = text_of(&exam.folder.join("out/manifest.json"));
    for (name, form) in forms {
        let form = put(&exam.folder, name, form);
        let out = text_of(&exam.folder.join("marks"));
        small(&["grade", &manifest, &form, "--out", &out])
            .ends(0)
            .says("1 right");
    }
}

#[test]
fn files_that_are_no_form_or_manifest_are_refused() {
    let exam = Exam::new("refused-forms", "seed = 7\nvariants = 1");
    let manifest = text_of(&exam.folder.join("out/manifest.json"));
    let refused = |name: &str, form: &[u8]| {
        let form = put(&exam.folder, name, form);
        small(&["grade", &manifest, &form]).ends(2)
    };
    refused("empty.csv", b"").complains("is empty");
    refused("other.csv", b"a,b,c\n1,2,3\n").complains("the header needs `code`");
    refused("object.json", b"{}").complains("give an array of objects");
    let form = put(&exam.folder, "form.csv", "code,question,part,response\n");
    let no_manifest = put(&exam.folder, "no.json", "{\"format\": 1}");
    small(&["grade", &no_manifest, &form])
        .ends(2)
        .complains("is not a manifest");
    let listed = put(&exam.folder, "listed.json", "[]");
    small(&["grade", &listed, &form])
        .ends(2)
        .complains("is not a manifest: it is not one JSON object");
    let newer = content(&manifest).replace("\"format\":1", "\"format\":99");
    let newer = put(&exam.folder, "newer.json", newer);
    small(&["grade", &newer, &form])
        .ends(2)
        .complains("format 99");
    let other = content(&manifest).replace("\"revision\":\"", "\"revision\":\"00000000");
    let other = put(&exam.folder, "other.json", other);
    small(&["grade", &other, &form]).ends(2);
    // A line that is not UTF-8 is reported; the others are marked.
    let answer = format!("{:.4}", exam.omega(0));
    let mut rows = format!(
        "code,question,part,response\n{},1,a,{answer} rad/s\n",
        exam.code(0)
    );
    rows.push_str("x,1,a,");
    let bytes = [rows.as_bytes(), b"\xff\xfe\n"].concat();
    let form = put(&exam.folder, "bytes.csv", bytes);
    small(&["grade", &manifest, &form])
        .ends(1)
        .complains("line 3")
        .says("1 right");
}

#[test]
fn what_could_not_be_read_comes_first_and_is_settled_by_the_overrides() {
    let mut exam = Exam::new("overrides", "seed = 7\nvariants = 3");
    for variant in 0..3 {
        exam.answer(variant, "1a", "rather fast, I think");
    }
    exam.answer(0, "2a", "nonsense");
    let (ran, _) = exam.grade("");
    ran.ends(0)
        .says("4 unreadable")
        .says("unreadable.csv")
        .complains("3 times 1a: `rather fast, I think`");
    let report: Json =
        serde_json::from_str(&content(exam.folder.join("marks/report.json"))).expect("JSON");
    // Like answers are one entry.
    let lost = report["unreadable"].as_array().expect("a list");
    let times = |lost: &Json| lost["sheets"].as_array().map(Vec::len);
    assert_eq!(
        lost.iter().map(times).collect::<Vec<_>>(),
        [Some(3), Some(1)]
    );
    assert!(content(exam.folder.join("marks/report.html")).contains("Not yet decided (4)"));
    // The table of what could not be read, filled in: one row settles those that are alike, another row a single one.
    let table = content(exam.folder.join("marks/unreadable.csv"));
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    let mut filled = csv::Writer::from_writer(Vec::new());
    filled
        .write_record(reader.headers().expect("it has a header"))
        .expect("it is in memory");
    let rows: Vec<csv::StringRecord> = reader.records().map(|row| row.expect("a row")).collect();
    assert_eq!(rows.len(), 2, "{table}");
    for row in &rows {
        let mut cells: Vec<String> = row.iter().map(str::to_owned).collect();
        if &row[0] == "*" {
            assert_eq!((&row[3], &row[4], &row[8]), ("1", "a", "3"));
            cells[11] = "1/3".to_owned();
            cells[12] = "Well meant, <b>but</b> no.".to_owned();
        }
        filled.write_record(&cells).expect("it is in memory");
    }
    let mut filled = filled.into_inner().expect("it is in memory");
    let own = format!("{},,,1,a,,,,,,{:.4} rad/s,,\n", exam.code(0), exam.omega(0));
    filled.extend_from_slice(own.as_bytes());
    let wrong = "*,,,2,c,,,,,,,2,Given to all\nZZZ,,,1,a,,,,,,,1,\nx,,,one,a,,,,,,,1,\n*,,,1,a,free/spring-mass,omega_n,never said,,,,1,\n";
    filled.extend_from_slice(wrong.as_bytes());
    let overrides = put(&exam.folder, "overrides.csv", filled);
    let manifest = text_of(&exam.folder.join("out/manifest.json"));
    let form = text_of(&exam.folder.join("form.csv"));
    let out = text_of(&exam.folder.join("marks"));
    small(&[
        "grade",
        &manifest,
        &form,
        "--out",
        &out,
        "--overrides",
        &overrides,
    ])
    .ends(1)
    .complains("no part 1a of a sheet ZZZ was handed out")
    .complains("question `one` is not a number")
    .complains("nobody gave this answer to part `omega_n`")
    .says("1 unreadable")
    .says("marks differ from the earlier run");
    let results: Vec<Json> =
        serde_json::from_str(&content(exam.folder.join("marks/results.json"))).expect("JSON");
    let of = |variant: usize, question: u64, part: &str| {
        let found = results.iter().find(|entry| {
            entry["code"] == exam.code(variant)
                && entry["question"] == question
                && entry["part"] == part
        });
        found.expect("each part has its entry").clone()
    };
    assert_eq!(of(0, 1, "a")["verdict"], "right");
    assert_eq!(of(0, 1, "a")["reasons"][0], "override");
    assert_eq!(of(1, 1, "a")["verdict"], "partial");
    assert_eq!(of(1, 1, "a")["points"], 1.0 / 3.0);
    assert_eq!(of(2, 1, "a")["points"], 1.0 / 3.0);
    assert_eq!(of(0, 2, "a")["verdict"], "unreadable");
    assert_eq!(of(0, 2, "a")["points"], Json::Null);
    for variant in 0..3 {
        assert_eq!(of(variant, 2, "c")["points"], 2.0);
    }
    let changes = content(exam.folder.join("marks/changes.csv"));
    assert_eq!(changes.lines().count(), 1 + 3 + 3, "{changes}");
    let page = content(
        exam.folder
            .join(format!("marks/feedback/{}.html", exam.code(1))),
    );
    assert!(page.contains("Well meant, &lt;b&gt;but&lt;/b&gt; no."));
}

#[test]
fn undecided_is_not_wrong() {
    let mut exam = Exam::new("undecided", "seed = 7\nvariants = 4");
    for variant in 0..4 {
        exam.answer(
            variant,
            "1b",
            format!("{:.4} Hz", exam.omega(variant) / TAU),
        );
    }
    exam.answer(0, "1a", "rather fast, I think");
    let silent = ["?", "-", "n/a", "Je ne sais pas."];
    for (variant, words) in silent.into_iter().enumerate() {
        exam.answer(variant, "2a", words);
    }
    let (ran, details) = exam.grade("");
    ran.ends(0).says("1 unreadable");
    for variant in 0..4 {
        let part = &details[&(exam.code(variant), "2a".to_owned())];
        assert_eq!(part["verdict"], "missing", "{part}");
    }
    let marks = content(exam.folder.join("marks/marks.csv"));
    let mut marks = csv::Reader::from_reader(marks.as_bytes());
    let names: Vec<String> = marks
        .headers()
        .expect("a header")
        .iter()
        .map(str::to_owned)
        .collect();
    let rows: Vec<Vec<String>> = marks
        .records()
        .map(|row| row.expect("a row").iter().map(str::to_owned).collect())
        .collect();
    let cell = |row: usize, name: &str| {
        let at = names.iter().position(|own| own == name).expect("a column");
        rows[row][at].as_str()
    };
    let read = |row: usize| {
        ["points", "undecided", "undecided points", "1a", "1b"].map(|name| cell(row, name))
    };
    assert_eq!(read(0), ["2 + ?1", "1", "1", "?1", "2"]);
    assert_eq!(read(1), ["2", "0", "0", "0", "2"]);
    let page = content(
        exam.folder
            .join(format!("marks/feedback/{}.html", exam.code(0))),
    );
    for words in ["2 + ?1 of", "? of 1 point", "Not yet decided"] {
        assert!(page.contains(words), "{words}");
    }
    // The share of the first sheet is that of its decided parts.
    let report: Json =
        serde_json::from_str(&content(exam.folder.join("marks/report.json"))).expect("JSON");
    let summary = &report["summary"];
    assert_eq!(
        (&summary["sheets"], &summary["undecided"]),
        (&4.into(), &1.into())
    );
    let max: f64 = cell(0, "max").parse().expect("a number");
    let mean = (2.0 / (max - 1.0) + 3.0 * 2.0 / max) / 4.0;
    let found = summary["shares"]["mean"].as_f64().expect("a number");
    assert!((found - mean).abs() < 1e-12, "{found} {mean}");
}

#[test]
fn an_interrupted_run_goes_on_and_ends_as_one_that_was_not() {
    let mut exam = Exam::new("resume", "seed = 7\nvariants = 6");
    for variant in 0..6 {
        exam.answer(variant, "1a", format!("{:.4} rad/s", exam.omega(variant)));
        exam.answer(variant, "1b", "3 Hz");
    }
    exam.grade("").0.ends(0);
    let names = [
        "marks.csv",
        "details.csv",
        "results.json",
        "report.json",
        "report.html",
        "unreadable.csv",
    ];
    let before: Vec<String> = names
        .iter()
        .map(|name| content(exam.folder.join("marks").join(name)))
        .collect();
    assert!(!exam.folder.join("marks/.grading.jsonl").exists());
    // A journal as it stands after two sheets and in the middle of the third: that of this input is believed.
    let manifest = text_of(&exam.folder.join("out/manifest.json"));
    let form = text_of(&exam.folder.join("form.csv"));
    let out = exam.folder.join("again");
    let journal = journal_of(&exam, &manifest, &form);
    let mut lines: Vec<&str> = journal.lines().collect();
    lines.truncate(4);
    lines[3] = &lines[3][..40];
    put(&out, ".grading.jsonl", lines.join("\n"));
    small(&["grade", &manifest, &form, "--out", &text_of(&out)])
        .ends(0)
        .complains("2 sheets were marked before");
    let after: Vec<String> = names.iter().map(|name| content(out.join(name))).collect();
    assert_eq!(before, after);
    // That of another input is not.
    put(
        &out,
        ".grading.jsonl",
        format!("another input\n{}", lines[1]),
    );
    let ran = small(&["grade", &manifest, &form, "--out", &text_of(&out)]).ends(0);
    assert!(!ran.err.contains("were marked before"), "{}", ran.err);
}

/// The journal of a run, caught by a folder in the way of its last file.
fn journal_of(exam: &Exam, manifest: &str, form: &str) -> String {
    let out = exam.folder.join("caught");
    put(&out, "report.json/in-the-way", "");
    small(&["grade", manifest, form, "--out", &text_of(&out)]).ends(2);
    content(out.join(".grading.jsonl"))
}

#[test]
fn a_changed_item_counts_when_it_is_asked_for_and_changed_marks_are_listed() {
    let mut exam = Exam::new("revisions", "seed = 7\nvariants = 2");
    for variant in 0..2 {
        exam.answer(variant, "1a", format!("{:.4} rad/s", exam.omega(variant)));
    }
    exam.grade("").0.ends(0);
    // The bank with another key in the first item: ω is half of what it was.
    let bank = exam.folder.join("bank");
    for (name, text) in [
        ("bank.toml", include_str!("../../fixtures/bank/bank.toml")),
        (
            "free/_chapter.toml",
            include_str!("../../fixtures/bank/free/_chapter.toml"),
        ),
        (
            "free/damped-block.toml",
            include_str!("../../fixtures/bank/free/damped-block.toml"),
        ),
        (
            "friction/_chapter.toml",
            include_str!("../../fixtures/bank/friction/_chapter.toml"),
        ),
        (
            "friction/half-cycles.toml",
            include_str!("../../fixtures/bank/friction/half-cycles.toml"),
        ),
    ] {
        put(&bank, name, text);
    }
    let item = include_str!("../../fixtures/bank/free/spring-mass.toml");
    assert!(item.contains("sqrt(k/m)"), "the key is there");
    put(
        &bank,
        "free/spring-mass.toml",
        item.replace("sqrt(k/m)", "sqrt(k/m)/2"),
    );
    let (manifest, form) = (
        exam.folder.join("out/manifest.json"),
        exam.folder.join("form.csv"),
    );
    let (manifest, form) = (text_of(&manifest), text_of(&form));
    let (out, bank) = (text_of(&exam.folder.join("marks")), text_of(&bank));
    let arguments = ["grade", &manifest, &form, "--out", &out, "--bank", &bank];
    // The run has kept what it handed out.
    super::vibank(&arguments)
        .ends(0)
        .complains("the bank has moved on: free/spring-mass")
        .says("0 marks differ");
    // One of the first version has not.
    let text = content(&manifest);
    let (entries, _) = text.split_once("\n],").expect("it has a foot");
    let old = put(
        &exam.folder,
        "old.json",
        format!("{entries}\n],\"files\":{{}}}}\n"),
    );
    super::vibank(&["grade", &old, &form, "--out", &out, "--bank", &bank])
        .ends(2)
        .complains("`free/spring-mass` has changed since the sheets were made");
    super::vibank(&[&arguments[..], &["--accept-revisions"]].concat())
        .ends(0)
        .complains("marked with changed items: free/spring-mass")
        .says("2 marks differ");
    let changes = content(exam.folder.join("marks/changes.csv"));
    assert!(changes.contains("1,a,right,1,wrong,0"), "{changes}");
}

#[test]
fn tables_are_read_as_spreadsheets_and_hands_leave_them() {
    let exam = Exam::new("spreadsheets", "seed = 7\nvariants = 3");
    let manifest = text_of(&exam.folder.join("out/manifest.json"));
    let out = text_of(&exam.folder.join("marks"));
    let grade = |name: &str, form: Vec<u8>| {
        let path = exam.folder.join(name);
        std::fs::write(&path, form).expect("it can be written");
        small(&["grade", &manifest, &text_of(&path), "--out", &out])
    };
    let row = |variant: usize| {
        format!(
            "{};1;a;{:.4} rad/s",
            exam.code(variant),
            exam.omega(variant)
        )
    };
    // Ends of lines, empty lines and empty rows are no rows, and are counted.
    let head = "code;question;part;response";
    let form = format!(
        "sep=;\r\n{head}\r\n\r\n;;;\r\n{};x;a;1\r\n{}\r\n",
        exam.code(1),
        row(0)
    );
    grade("crlf.csv", form.into_bytes())
        .ends(1)
        .complains("line 5: question `x` is not a number")
        .says("1 right");
    // A quote that is closed by that of another row.
    let form = format!(
        "{head}\n{};1;b;\"3.1 Hz\n{}\n{};1;b;\"3.1 Hz\"\n{}\n",
        exam.code(0),
        row(0),
        exam.code(1),
        row(2)
    );
    grade("quotes.csv", form.into_bytes())
        .ends(1)
        .complains("line 2: a quote is not closed")
        .says("2 right");
    // An answer of several lines is one.
    let form = format!("{head}\n{};1;b;\"3.1\nHz\"\n{}\n", exam.code(0), row(1));
    grade("lines.csv", form.into_bytes()).ends(0);
    // A comma that cuts an answer in two.
    let form = format!(
        "code,question,part,response,\n{},1,a,3,14,\n{}\n",
        exam.code(0),
        row(1).replace(';', ",")
    );
    grade("cells.csv", form.into_bytes())
        .ends(1)
        .complains("line 2: more cells than the header has")
        .says("1 right");
    let form = format!(
        "code,question,part,response\n{},1,a,3,14\n{},,\n",
        exam.code(0),
        row(1).replace(';', ",")
    );
    grade("more.csv", form.into_bytes())
        .ends(1)
        .complains("line 2: more cells than the header has")
        .says("1 right");
    let text = format!("{head}\r\n{}\r\n", row(1));
    let wide = text.encode_utf16().flat_map(u16::to_le_bytes);
    grade("wide.csv", [0xff, 0xfe].into_iter().chain(wide).collect())
        .ends(0)
        .says("1 right");
}

#[test]
fn more_points_than_a_part_has_are_told() {
    let exam = Exam::new("many-points", "seed = 7\nvariants = 1");
    let manifest = text_of(&exam.folder.join("out/manifest.json"));
    let form = put(
        &exam.folder,
        "form.csv",
        format!("code,question,part,response\n{},1,a,2\n", exam.code(0)),
    );
    let settled = put(
        &exam.folder,
        "settled.csv",
        "code,question,part,points\r\n*,1,a,90\r\n*,9,a,1\r\n",
    );
    let out = text_of(&exam.folder.join("marks"));
    small(&[
        "grade",
        &manifest,
        &form,
        "--out",
        &out,
        "--overrides",
        &settled,
    ])
    .ends(1)
    .complains("overrides, line 2: 90 points were given for part 1a")
    .complains("overrides, line 3: no part 9a");
}

#[test]
fn a_decision_for_all_is_about_an_item_and_not_about_a_number() {
    let folder = folder("shuffled");
    let items = ["ch2/e4-simple-pendulum", "ch3/e1-damped-elastic-pendulum"];
    let questions: String = items
        .iter()
        .map(|item| format!("[[question]]\nitem = '{item}'\n"))
        .collect();
    let top = "title = 'T'\nseed = 5\nvariants = 6\nshuffle = true\nformats = ['json']\n";
    let plan = put(&folder, "test.toml", format!("{top}{questions}"));
    let out = text_of(&folder.join("out"));
    vibank(&["sheet", &plan, "--out", &out]).ends(0);
    let manifest = text_of(&folder.join("out/manifest.json"));
    let form = text_of(&folder.join("out/responses.csv"));
    let graded = |row: &str| {
        let head = "code,question,part,item,id,given,points,feedback";
        let overrides = put(&folder, "settled.csv", format!("{head}\n{row}\n"));
        let marks = text_of(&folder.join("marks"));
        vibank(&[
            "grade",
            &manifest,
            &form,
            "--overrides",
            &overrides,
            "--out",
            &marks,
        ])
    };
    // By its number alone it could be either.
    graded("*,1,a,,,,1,The figure was wrong.")
        .ends(2)
        .complains("line 2: question 1 is not the same on all sheets")
        .complains("`ch2/e4-simple-pendulum`")
        .complains("`ch3/e1-damped-elastic-pendulum`");
    for row in [
        "*,1,a,ch2/e4-simple-pendulum,,,1,The figure was wrong.",
        "*,,,ch2/e4-simple-pendulum,eom_exact,,1,The figure was wrong.",
    ] {
        graded(row);
        let results: Vec<Json> =
            serde_json::from_str(&content(folder.join("marks/results.json"))).expect("JSON");
        let given = results
            .iter()
            .filter(|part| part["reasons"][0] == "override");
        let items: Vec<&Json> = given.map(|part| &part["item"]).collect();
        assert_eq!(items, ["ch2/e4-simple-pendulum"; 6], "{row}");
    }
    graded("*,,,ch2/e4-simple-pendulum,nothing,,1,")
        .complains("no part `nothing` of `ch2/e4-simple-pendulum`");
}

#[test]
fn broken_rows_are_told_and_the_rest_is_marked() {
    let exam = Exam::new("broken-rows", "seed = 7\nvariants = 2");
    let manifest = text_of(&exam.folder.join("out/manifest.json"));
    let answer = |variant: usize| {
        format!(
            "{},1,a,{:.4} rad/s\n",
            exam.code(variant),
            exam.omega(variant)
        )
    };
    let form = format!(
        "code,question,part,response\n{},1,b,\"3.1 Hz\n{}{}",
        exam.code(0),
        answer(0),
        answer(1)
    );
    let form = put(&exam.folder, "open.csv", form);
    let out = text_of(&exam.folder.join("marks"));
    small(&["grade", &manifest, &form, "--out", &out])
        .ends(1)
        .complains("line 2: a quote is not closed")
        .says("2 right, 1 unreadable");
    let marks = content(exam.folder.join("marks/marks.csv"));
    let row = marks.lines().find(|line| line.starts_with(&exam.code(0)));
    assert!(row.is_some_and(|row| row.contains('?')), "{marks}");
    let list = format!(
        "[17, {{\"code\":\"{0}\",\"1a\":\"{1:.4} rad/s\",\"1b\":null}}, {{\"part\":\"a\"}}, \
         {{\"code\":\"{0}\",\"question\":{{}},\"part\":\"a\"}}]",
        exam.code(1),
        exam.omega(1)
    );
    let form = put(&exam.folder, "list.json", list);
    small(&["grade", &manifest, &form, "--out", &out])
        .ends(1)
        .complains("entry 1 is not an object")
        .complains("entry 3 has no `code`")
        .complains("line 4: question `` is not a number")
        .says("1 right");
    // A code with a character that is another one is reported as mistyped.
    let code = exam.code(0);
    let other = if code.starts_with('2') { '3' } else { '2' };
    let code = format!("{other}{}", &code[1..]);
    let form = put(
        &exam.folder,
        "typo.csv",
        format!("code,question,part,response\n{code},1,a,5\n"),
    );
    small(&["grade", &manifest, &form, "--out", &out])
        .ends(1)
        .complains("mistyped");
}

#[test]
fn the_report_counts_mistakes_and_alike_wrong_answers() {
    let mut exam = Exam::new("report", "seed = 7\nvariants = 12");
    for variant in 0..12 {
        let omega = exam.omega(variant);
        let factor = if variant < 5 { 1.0 } else { 1.25 };
        exam.answer(variant, "1a", format!("{:.5} rad/s", factor * omega));
        let twice = if variant < 8 { 2_f64.sqrt() } else { 1.0 };
        exam.answer(variant, "1b", format!("{:.4} Hz", twice * omega / TAU));
    }
    exam.grade("").0.ends(0);
    let report: Json =
        serde_json::from_str(&content(exam.folder.join("marks/report.json"))).expect("JSON");
    let parts = report["summary"]["parts"].as_array().expect("it has parts");
    assert_eq!(parts[0]["places"][0], "1a");
    let facility = parts[0]["facility"].as_f64().expect("it is a number");
    assert!((facility - 5.0 / 12.0).abs() < 1e-12);
    assert_eq!(
        parts[0]["others"][0],
        serde_json::json!({ "what": "1.25 × the key", "count": 7 })
    );
    assert_eq!(
        parts[1]["mistakes"][0],
        serde_json::json!({ "code": "mistake-1", "what": "There is one spring only.", "count": 8 })
    );
    assert_eq!(report["summary"]["sheets"], 12);
    assert!(report["summary"]["reliability"].is_number());
    let table = content(exam.folder.join("marks/report.csv"));
    assert_eq!(table.lines().count(), 1 + 7, "{table}");
}
