//! What goes wrong on the first day: a line that is uncommented, a key in the wrong place, a text that says nothing.

use vibank::source::Source;
use vibank::worksheet::Blueprint;

use super::{blueprint, content, folder, put, small, text_of, vibank};

const UNKNOWN: &str = "bank::unknown-key";

/// The codes of what is wrong with a blueprint.
fn codes(text: &str) -> Vec<&'static str> {
    let source = Source::new("exam.toml", text);
    let findings = Blueprint::read(&source).err().unwrap_or_default();
    findings.iter().map(|own| own.code.name()).collect()
}

/// A text with some of its lines uncommented.
fn uncommented(text: &str, lines: std::ops::Range<usize>) -> String {
    let line = |(at, line): (usize, &str)| match line.strip_prefix("# ") {
        Some(bare) if lines.contains(&at) => format!("{bare}\n"),
        _ => format!("{line}\n"),
    };
    text.lines().enumerate().map(line).collect()
}

#[test]
fn each_line_of_a_new_blueprint_can_be_uncommented_where_it_stands() {
    for (text, least) in [
        (include_str!("../../../templates/new/exam.toml"), 15),
        (include_str!("../../../templates/new/sheet.toml"), 30),
    ] {
        let lines: Vec<&str> = text.lines().collect();
        let mut tried = 0;
        for (at, line) in lines.iter().enumerate() {
            let Some(bare) = line.strip_prefix("# ") else {
                continue;
            };
            let is_key = bare.split_once('=').is_some_and(|(key, _)| {
                key.trim()
                    .chars()
                    .all(|sign| sign == '_' || sign.is_alphabetic())
            });
            // A header that is commented comes with the lines below it.
            let below = lines[at..]
                .iter()
                .take_while(|line| line.starts_with("# "))
                .count();
            let has_header = lines[..at]
                .iter()
                .rev()
                .take_while(|line| line.starts_with("# "))
                .any(|line| line.starts_with("# ["));
            let range = match (bare.starts_with('['), is_key) {
                (true, _) => at..at + below,
                (false, true) if !has_header => at..at + 1,
                _ => continue,
            };
            tried += 1;
            let changed = uncommented(text, range);
            assert!(
                !codes(&changed).contains(&UNKNOWN),
                "{line}: {:?}",
                codes(&changed)
            );
        }
        assert!(tried >= least, "{tried}");
    }
}

#[test]
fn a_key_of_the_file_below_a_header_is_told_where_it_belongs() {
    let folder = folder("below-a-header");
    let text = "[[question]]\nitem = \"free/spring-mass\"\nformats = [\"html\"]\n";
    let plan = put(
        &folder,
        "plan.toml",
        format!("title = \"T\"\nseed = 1\nvariants = 1\n{text}"),
    );
    small(&["sheet", &plan])
        .ends(2)
        .complains("`formats` is not a key of `question`")
        .complains("`formats` is a key of the whole file: move it above the first `[header]`");
    // A table has its header with it, and stands wherever it likes.
    let plan = put(
        &folder,
        "plan.toml",
        blueprint("seed = 1\nvariants = 1").replace("[[question]]", "[[question]]\nprint = {}"),
    );
    let ran = small(&["sheet", &plan]).ends(2);
    assert!(!ran.err.contains("whole file"), "{}", ran.err);
}

#[test]
fn a_text_that_has_to_say_something_is_not_empty() {
    let folder = folder("empty-texts");
    for title in ["", "  ", "\\t"] {
        let text = blueprint("seed = 1\nvariants = 1")
            .replace("title = \"A test\"", &format!("title = \"{title}\""));
        let plan = put(&folder, "plan.toml", &text);
        small(&["sheet", &plan])
            .ends(2)
            .complains("`title` is empty")
            .complains("plan.toml:");
    }
    let own = "title = \"T\"\nseed = 1\nvariants = 1\n[[question]]\ntitle = \"\"\nstatement = \"A swing.\"\n\
               [[question.part]]\nask = \"Its period?\"\nkey = \"2 s\"\n";
    let plan = put(&folder, "own.toml", own);
    vibank(&["check", &plan])
        .ends(1)
        .complains("`title` is empty")
        .complains("own.toml:5:9");
    let bank = folder.join("bank");
    let bank = text_of(&bank);
    vibank(&["new", "bank", &bank]).ends(0);
    let item = folder.join("bank/ch1/block-on-a-spring.toml");
    let text = std::fs::read_to_string(&item).unwrap();
    let title = text.lines().find(|line| line.starts_with("title")).unwrap();
    std::fs::write(&item, text.replace(title, "title = \" \"")).unwrap();
    vibank(&["check", "--bank", &bank])
        .ends(1)
        .complains("`title` is empty");
}

#[test]
fn a_file_of_another_kind_is_named() {
    let folder = folder("other-kinds");
    let plan = put(&folder, "plan.toml", blueprint("seed = 1\nvariants = 1"));
    let out = text_of(&folder.join("out"));
    small(&["sheet", &plan, "-o", &out]).ends(0);
    let page = text_of(&folder.join("out/sheets.html"));
    for (file, kind) in [(&plan, "is a blueprint"), (&page, "is a page")] {
        small(&["grade", &out, file])
            .ends(2)
            .complains(kind)
            .complains("not a list of answers")
            .complains("`responses.csv`");
    }
    let list = put(&folder, "class.csv", "id,name\ns1,A\n");
    let manifest = text_of(&folder.join("out/manifest.json"));
    for (file, kind) in [
        (&list, "is a table"),
        (&manifest, "is the manifest of a run"),
        (&page, "is a page"),
    ] {
        small(&["check", file])
            .ends(2)
            .complains(kind)
            .complains("not an item or a blueprint");
    }
}

#[test]
fn a_gradebook_needs_a_column_that_the_class_list_has() {
    let folder = folder("gradebook-column");
    put(&folder, "class.csv", "id,name,email\ns1,A,a@x.example\n");
    let plan = put(
        &folder,
        "plan.toml",
        blueprint("seed = 1\nstudents = \"class.csv\""),
    );
    let out = text_of(&folder.join("out"));
    small(&["sheet", &plan, "-o", &out]).ends(0);
    let form = text_of(&folder.join("out/responses.csv"));
    let grade = |id: &str| {
        small(&[
            "grade",
            &out,
            &form,
            "--gradebook",
            "moodle",
            "--gradebook-id",
            id,
        ])
    };
    grade("emial")
        .ends(2)
        .complains("the class list has no column `emial`")
        .complains("did you mean `email`?");
    assert!(!folder.join("out/marks/marks.csv").exists());
    grade("Email").ends(0);
    // Nobody is known by a name where there is no list.
    let bare = put(&folder, "bare.toml", blueprint("seed = 1\nvariants = 1"));
    let out = text_of(&folder.join("bare"));
    small(&["sheet", &bare, "-o", &out]).ends(0);
    let form = text_of(&folder.join("bare/responses.csv"));
    small(&["grade", &out, &form, "--gradebook", "moodle"])
        .ends(2)
        .complains("the sheets have no names");
}

#[cfg(unix)]
#[test]
fn a_pipe_or_a_device_takes_what_is_written_and_stays() {
    use std::os::unix::fs::FileTypeExt as _;
    use std::process::{Command, Stdio};

    let folder = folder("pipe");
    let plan = put(&folder, "plan.toml", blueprint("seed = 1\nvariants = 1"));
    let pipe = text_of(&folder.join("pipe"));
    let made = Command::new("mkfifo").arg(&pipe).status();
    assert!(made.expect("the system has pipes").success());
    let reader = Command::new("cat")
        .arg(&pipe)
        .stdout(Stdio::piped())
        .spawn();
    let mut reader = reader.expect("it can be read");
    let ran = small(&["export", "moodle", &plan, "-o", &pipe]);
    let kind = std::fs::metadata(&pipe).expect("it is there").file_type();
    if !kind.is_fifo() {
        reader.kill().expect("it is ours");
        panic!("the pipe has become a file");
    }
    ran.ends(0);
    let read = reader.wait_with_output().expect("it ends").stdout;
    assert!(String::from_utf8_lossy(&read).contains("</quiz>"));
    let ran = small(&["export", "moodle", &plan, "-o", &text_of(&folder)]);
    ran.ends(2).complains("is a folder, not a file");
}

#[test]
fn what_is_marked_stands_in_the_order_of_the_sheet_on_its_paper() {
    let folder = folder("order");
    let exam = text_of(&folder.join("exam.toml"));
    vibank(&["new", "exam", &exam]).ends(0);
    let text = std::fs::read_to_string(&exam).unwrap();
    let text = text
        .replace("# paper         = \"a4\"", "paper = \"letter\"")
        .replace("# space         = \"4 cm\"", "space = \"4 cm\"");
    let exam = put(&folder, "exam.toml", text);
    let out = text_of(&folder.join("out"));
    vibank(&["sheet", &exam, "-o", &out]).ends(0);
    // What a choice asks stands by its options, and the room for work below.
    let sheets = content(folder.join("out/sheets.html"));
    let options = sheets.find("it gets shorter").expect("the choice is there");
    let rest = &sheets[options..];
    let asked = rest.find("choose one").expect("it says how many");
    assert!(asked < rest.find("class=\"space").expect("there is room"));
    let form = text_of(&folder.join("out/responses.csv"));
    vibank(&["grade", &out, &form]).ends(0).says("4 sheets: ");
    let marks = content(folder.join("out/marks/marks.csv"));
    let head = marks.lines().next().unwrap();
    assert!(
        head.contains(",1a,1b,1c1,1c2,1d1,1d2,1e1,1e2,1f,"),
        "{head}"
    );
    let report = content(folder.join("out/marks/report.html"));
    assert!(report.contains("A swing: "), "the question has a title");
    let table = content(folder.join("out/marks/report.csv"));
    let places: Vec<&str> = table
        .lines()
        .filter_map(|row| row.split(',').next())
        .collect();
    let place = |name: &str| places.iter().position(|own| *own == name);
    assert!(
        place("1c1").is_some() && place("1c1") < place("1f"),
        "{places:?}"
    );
    let mut feedback = std::fs::read_dir(folder.join("out/marks/feedback")).unwrap();
    let page = content(feedback.next().unwrap().unwrap().path());
    assert!(page.contains("@page { size: letter;") && report.contains("@page { size: letter;"));
}
