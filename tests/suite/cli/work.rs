//! Room for work on paper.

use std::fs;

use vibank::bank::Catalogue;
use vibank::wasm::Grader;
use vibank::worksheet::Practice;

use super::{content, fed, folder, put, text_of, vibank};

#[test]
fn room_for_work_is_printed_as_item_and_blueprint_say() {
    let folder = folder("space");
    let bank = folder.join("bank");
    fs::create_dir_all(bank.join("c")).expect("a folder can be made");
    put(&bank, "bank.toml", "format = 1\ntitle = 'T'");
    put(&bank, "c/_chapter.toml", "title = 'C'");
    let part = |id: &str, space: &str| {
        format!("[[part]]\nid = '{id}'\nkey = 'f'\nask = 'What is {id}?'\n{space}\n")
    };
    let item = |parts: &str| {
        format!(
            "[item]\ntitle = 'A'\nsource = 'S'\n[parameters]\nf = '2 Hz'\n[statement]\ntext = 'X'\n{parts}"
        )
    };
    let parts = [
        part("own", "space = '3 lines'"),
        part("bare", "space = 'none'"),
        part("usual", ""),
    ];
    put(&bank, "c/a.toml", item(&parts.concat()));
    let bank = text_of(&bank);
    let sheet = |top: &str, keys: &str| {
        let text = format!(
            "title = 'T'\nseed = 3\nvariants = 1\nformats = ['html', 'md', 'json']\n{top}\n[[question]]\n{keys}\n"
        );
        let plan = put(&folder, "plan.toml", text);
        let out = folder.join("out");
        let _ = fs::remove_dir_all(&out);
        let ran = vibank(&["sheet", &plan, "--bank", &bank, "--out", &text_of(&out)]);
        (ran, out)
    };
    let spaces = |top: &str, keys: &str| {
        let (ran, out) = sheet(top, keys);
        ran.ends(0);
        let row: serde_json::Value =
            serde_json::from_str(content(out.join("sheets.jsonl")).trim()).expect("it is JSON");
        let parts = row["questions"][0]["parts"].as_array().cloned();
        let parts = parts.expect("it has parts");
        let spaces = parts.iter().map(|part| part["space"].as_str());
        let spaces = spaces.map(|space| space.map(str::to_owned));
        (spaces.collect::<Vec<_>>(), out)
    };
    let all = |spaces: [&str; 3]| spaces.map(|space| Some(space.to_owned())).to_vec();
    let item_alone = "item = 'c/a'";
    assert_eq!(spaces("", item_alone).0, all(["3 lines", "none", "none"]));
    let (found, out) = spaces("space = '6 cm squared'", item_alone);
    assert_eq!(found, all(["3 lines", "none", "60 mm squared"]));
    let page = content(out.join("sheets.html"));
    assert!(page.contains("<div class=\"space lines\" style=\"height: 24mm\">"));
    assert!(page.contains("<div class=\"space squared\" style=\"height: 60mm\">"));
    assert_eq!(page.matches("<div class=\"space ").count(), 2);
    assert_eq!(content(out.join("sheets.md")).matches("&nbsp;").count(), 8);
    assert!(!content(out.join("keys.html")).contains("<div class=\"space "));
    let (found, _) = spaces(
        "space = '1 cm'",
        "item = 'c/a'\nspace = '2 cm'\npart_space = { usual = 'none' }",
    );
    assert_eq!(found, all(["20 mm", "20 mm", "none"]));
    for (top, keys, words) in [
        (
            "space = '5 inches'",
            item_alone,
            "`5 inches` is not a working space",
        ),
        ("space = '30 cm'", item_alone, "at most 20 cm or 25 lines"),
        (
            "",
            "item = 'c/a'\npart_space = { usuall = '2 cm' }",
            "did you mean `usual`?",
        ),
        (
            "",
            "pick = { chapter = 'c' }\npart_space = { own = '2 cm' }",
            "belongs to one `item`",
        ),
        ("", "item = 'c/a'\nspace = 5", "expected a text"),
    ] {
        sheet(top, keys).0.ends(2).complains(words);
    }
    let wrong = put(
        &folder,
        "bank/c/b.toml",
        item(&part("own", "space = '3 rows'")),
    );
    vibank(&["check", &wrong, "--bank", &bank])
        .ends(1)
        .complains("b.toml:12:9")
        .complains("`3 rows` is not a working space");
}

/// The bank with a part that a person marks, and what is made of it.
const BANK: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/work/bank");
const PLAN: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/work/plan.toml");

/// A run of three sheets in a folder, and their codes.
fn handed_out(name: &str) -> (std::path::PathBuf, Vec<String>) {
    let out = folder(name).join("out");
    vibank(&["sheet", PLAN, "--bank", BANK, "--out", &text_of(&out)]).ends(0);
    let form = content(out.join("responses.csv"));
    let mut codes: Vec<String> = form
        .lines()
        .skip(1)
        .map(|line| line[..11].to_owned())
        .collect();
    codes.dedup();
    (out, codes)
}

#[test]
fn work_is_printed_with_room_and_its_rubric_for_whoever_marks() {
    let (out, _) = handed_out("rubric");
    let [sheets, keys, solutions, table] = ["sheets", "keys", "solutions", "key-table"]
        .map(|name| content(out.join(format!("{name}.html"))));
    assert_eq!(sheets.matches("class=\"space squared\"").count(), 3);
    // The one answer line is that of the other part, and a rubric is not handed out.
    assert_eq!(sheets.matches("<span class=\"rule\">").count(), 3);
    let row = "<tr><td>2</td><td>weight and force of the spring";
    assert!(!sheets.contains("weight and force of the spring"));
    assert_eq!(keys.matches(row).count(), 3);
    assert_eq!(solutions.matches(row).count(), 3);
    assert!(table.contains("by hand"));
}

#[test]
fn points_that_a_person_gave_stand_apart_and_what_is_not_marked_is_open() {
    let (out, codes) = handed_out("by-hand");
    let grade = |rows: [&str; 3], more: &[&str]| {
        let rows = codes
            .iter()
            .zip(rows)
            .map(|(code, points)| format!("{code},{points},99 rad/s\n"));
        let text = format!("code,1a,1b\n{}", rows.collect::<String>());
        let form = put(&out, "filled.csv", text);
        let manifest = text_of(&out.join("manifest.json"));
        let all = [&["grade", &manifest, &form, "--bank", BANK], more].concat();
        vibank(&all)
    };
    grade(["1.5;1", "", "2;2"], &[])
        .ends(0)
        .says("1 partial, 3 wrong, 2 open")
        .complains("2 parts are open")
        .complains("row 4, part 1a: `2` is more than the 1 of row 2");
    let marks = content(out.join("marks/marks.csv"));
    let rows: Vec<&str> = marks.lines().collect();
    assert!(rows[0].ends_with(",auto,hand,1,1a,1b"), "{marks}");
    assert!(rows[1].ends_with(",2.5,4,0,0,0,2.5,2.5,2.5,0"), "{marks}");
    assert!(
        rows[2].ends_with(",0 + ?3,4,1,3,0,0 + ?3,0 + ?3,?3,0"),
        "{marks}"
    );
    let page = content(out.join(format!("marks/feedback/{}.html", codes[0])));
    assert!(page.contains("1.5 of 2: weight and force of the spring"));
    assert!(page.contains("2.5 of 3 points") && !page.contains("1.5;1"));
    // What the teacher mistyped is nothing for the student.
    let page = content(out.join(format!("marks/feedback/{}.html", codes[2])));
    assert!(page.contains("has not been marked yet") && !page.contains("row 4"));
    // An open part is settled as any other, each sheet for itself.
    let open = content(out.join("marks/unreadable.csv"));
    assert_eq!(open.lines().count(), 3, "{open}");
    assert!(!open.contains("\n*"), "{open}");
    let decided = put(
        &out,
        "decided.csv",
        format!(
            "code,question,part,response,points\n{},1,a,,1\n{},1,a,2;0,\n",
            codes[1], codes[2]
        ),
    );
    grade(["1.5;1", "", "2;2"], &["--overrides", &decided])
        .ends(0)
        .says("3 partial, 3 wrong");
    let marks = content(out.join("marks/marks.csv"));
    assert!(
        marks
            .lines()
            .nth(2)
            .is_some_and(|row| row.ends_with(",1,1,0")),
        "{marks}"
    );
    assert!(
        marks
            .lines()
            .nth(3)
            .is_some_and(|row| row.ends_with(",2,2,0")),
        "{marks}"
    );
    for (typed, words) in [
        ("4", "more than the 3 of this part"),
        ("-1", "is not a number of points"),
        ("good", "is not a number of points"),
        ("1;1;1", "has 3 numbers, the rubric 2 rows"),
    ] {
        grade([typed, "3", "0"], &[])
            .ends(0)
            .says("1 right, 4 wrong, 1 open")
            .complains(&format!("row 2, part 1a: `{typed}"))
            .complains(words);
    }
}

#[test]
fn a_blueprint_with_other_points_shares_them_out_over_the_rubric() {
    let folder = folder("shared-rubric");
    let plan = put(
        &folder,
        "plan.toml",
        "title = 'T'\nseed = 1\nvariants = 1\n[[question]]\nitem = 'free/block'\nparts = ['diagram']\npoints = 6\n",
    );
    let out = folder.join("out");
    vibank(&["sheet", &plan, "--bank", BANK, "--out", &text_of(&out)]).ends(0);
    let key = content(out.join("keys.html"));
    assert!(key.contains("<tr><td>4</td><td>weight") && key.contains("<tr><td>2</td><td>Newton"));
}

#[test]
fn what_a_person_marks_is_said_to_be_so() {
    vibank(&["mark", "free/block", "diagram", "3", "--bank", BANK]).says("a person marks it");
    vibank(&["check", "--bank", BANK]).ends(0);
    let folder = folder("essay");
    for (format, name, info) in [
        ("moodle", "quiz.xml", "<graderinfo"),
        ("qti", "quiz.zip", ""),
    ] {
        let out = text_of(&folder.join(name));
        vibank(&["export", format, PLAN, "--bank", BANK, "--out", &out]).ends(0);
        if !info.is_empty() {
            let quiz = content(&out);
            assert_eq!(quiz.matches("<question type=\"essay\">").count(), 3);
            assert_eq!(quiz.matches("<defaultgrade>3</defaultgrade>").count(), 3);
            assert_eq!(quiz.matches("<td>2</td><td>weight and force").count(), 3);
        }
    }
}

#[test]
fn a_rubric_has_the_points_of_its_part() {
    let folder = folder("rubrics");
    let bank = text_of(&folder);
    put(&folder, "bank.toml", "format = 1\ntitle = 'T'");
    fs::create_dir_all(folder.join("c")).expect("a folder can be made");
    put(&folder, "c/_chapter.toml", "title = 'C'");
    let check = |keys: &str| {
        let item = format!(
            "[item]\ntitle = 'A'\nsource = 'S'\n[parameters]\nf = '2 Hz'\n[statement]\ntext = 'X'\n[[part]]\nid = 'w'\nkind = 'work'\nask = 'Draw it.'\n{keys}\n"
        );
        let item = put(&folder, "c/a.toml", item);
        vibank(&["check", &item, "--bank", &bank])
    };
    for (keys, words) in [
        ("points = 2", "`rubric`"),
        ("points = 2\nrubric = []", "from 1 to 20 rows"),
        (
            "points = 2\nrubric = [{ points = 1, text = 'A' }]",
            "sum up to 1, those of the part are 2",
        ),
        ("rubric = [{ points = 0, text = 'A' }]", "a positive number"),
        ("rubric = [{ points = 1 }]", "`text`"),
        (
            "rubric = [{ points = 1, text = 'A' }]\nmistakes = [{ answer = '1', feedback = 'F' }]",
            "no named mistakes",
        ),
        (
            "rubric = [{ points = 1, text = 'A' }]\nkey = 'f'",
            "has no key",
        ),
    ] {
        check(keys).ends(1).complains(words);
    }
}

#[test]
fn practice_shows_work_with_its_solution_and_leaves_it_out_of_the_score() {
    let arguments = ["practice", "--bank", BANK, "free/block", "--seed", "3"];
    fed(&arguments, "\n1e9 rad/s\n>\n".into())
        .ends(0)
        .says("it is not marked here")
        .says("The weight mg acts downwards")
        .says("2: weight and force of the spring")
        .says("0 of 1 part right");
}

#[test]
fn a_page_shows_work_with_its_solution_and_leaves_it_out_of_the_score() {
    let file = |name: &str| content(format!("{BANK}/{name}"));
    let names = ["bank.toml", "free/_chapter.toml", "free/block.toml"];
    let files = names.map(|name| (name, file(name)));
    let (catalogue, _) = Catalogue::load(files.iter().map(|(name, text)| (*name, text.as_str())));
    let item = catalogue.find("free/block").expect("it is there");
    let (practice, items) = Practice::of_items(&catalogue, &[item], "T");
    let weights: Vec<&str> = practice.questions[0]
        .weights
        .iter()
        .map(|part| part.id.as_str())
        .collect();
    assert_eq!(weights, ["omega_n"]);
    let grader = Grader::of(&practice.lines(&items)).expect("it was written so");
    let ask = |request: serde_json::Value| -> serde_json::Value {
        serde_json::from_str(&grader.answer(&request.to_string())).expect("it is JSON")
    };
    let code = ask(serde_json::json!({ "do": "choose", "question": 0, "from": 1 }))["code"].clone();
    let of_part = |what: &str| serde_json::json!({ "do": what, "question": 0, "code": code, "part": "diagram" });
    let solved = ask(of_part("solve"));
    assert_eq!(solved["key"], "");
    assert!(
        solved["html"]
            .as_str()
            .is_some_and(|html| html.contains("acts downwards"))
    );
    let mut mark = of_part("mark");
    mark["response"] = "3".into();
    mark["earlier"] = serde_json::json!({});
    let marked = ask(mark);
    assert_eq!(marked["verdict"], "unreadable");
    assert!(
        marked["feedback"]
            .as_str()
            .is_some_and(|said| said.contains("a person marks it"))
    );
}

#[test]
fn what_students_wrote_in_a_course_is_no_number_of_points() {
    let folder = folder("essay-report");
    let out = text_of(&folder.join("quiz.xml"));
    vibank(&["export", "moodle", PLAN, "--bank", BANK, "--out", &out]).ends(0);
    let quiz = content(&out);
    let name = quiz.split("<idnumber>").find_map(|rest| {
        let (name, _) = rest.split_once("</idnumber>")?;
        name.ends_with(" a").then(|| name.to_owned())
    });
    let name = name.expect("an essay was exported");
    let report = put(
        &folder,
        "report.csv",
        format!(
            "Surname,First name,ID number,Email address,State,Started on,Completed,Time taken,Grade/3.00,Question 1,Response 1\nA,B,1,a@b.c,Finished,1 January 2026 10:00 AM,1 January 2026 11:00 AM,1 hour,-,\"Draw it. {name}\",3\n"
        ),
    );
    let manifest = fs::read_dir(&folder)
        .expect("the folder is there")
        .filter_map(|entry| Some(text_of(&entry.ok()?.path())))
        .find(|path| path.ends_with(".json"))
        .expect("a manifest stands beside the quiz");
    vibank(&[
        "grade",
        &manifest,
        &report,
        "--bank",
        BANK,
        "--out",
        &text_of(&folder.join("marks")),
    ])
    .ends(0)
    .says("1 open");
}
