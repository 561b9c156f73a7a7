//! `vibank enter`: answers typed from paper, kept whatever happens.

use std::io::Write as _;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value as Json;

use super::desk::Desk;
use super::{BANK, Ran, content, fed, text_of};

/// A run of three sheets; the codes.
fn run(name: &str) -> (Desk, Vec<String>) {
    let desk = Desk::with_class(name, 3);
    let plan = desk.plan("seed = 7\nstudents = 'class.csv'\nformats = ['md']");
    desk.sheet(&plan, &[]).ends(0);
    let manifest: Json =
        serde_json::from_str(&content(desk.out.join("manifest.json"))).expect("JSON");
    let codes = manifest["variants"].as_array().expect("sheets").iter();
    let codes = codes
        .map(|sheet| sheet["code"].as_str().expect("a code").to_owned())
        .collect();
    (desk, codes)
}

fn enter(desk: &Desk, typed: &str) -> Ran {
    let manifest = desk.path("manifest.json");
    fed(&["enter", &manifest, "--bank", &desk.bank], typed.into())
}

/// The file of answers: code, place, response.
fn entered(desk: &Desk) -> Vec<(String, String, String)> {
    let rows: Vec<Json> =
        serde_json::from_str(&content(desk.out.join("entered.json"))).expect("JSON");
    let text = |row: &Json, name: &str| row[name].as_str().unwrap_or_default().to_owned();
    rows.iter()
        .map(|row| {
            (
                text(row, "code"),
                format!("{}{}", row["question"], text(row, "part")),
                text(row, "response"),
            )
        })
        .collect()
}

#[test]
fn answers_are_echoed_kept_and_marked() {
    let (desk, codes) = run("enter");
    // Small letters and no hyphens, as one types them; back to the first part, and one that cannot be read.
    let code = codes[0].to_lowercase().replace('-', "");
    let ran = enter(
        &desk,
        &format!("{code}\n20 rad/s\n<\n12,5 rad/s\nabout three\n-k x\n>>\nquit\n"),
    );
    ran.ends(0)
        .says("Name s1, s1: ")
        .says("1a  ωₙ = ____ rad/s (value, 3 figures)> 20 rad/s")
        .says("read as 20")
        .says("[20 rad/s]> 12,5 rad/s")
        .says("could not be read; kept as it is")
        .says("1 of 3 sheets have answers");
    let rows = entered(&desk);
    let own =
        |place: &str, response: &str| (codes[0].clone(), place.to_owned(), response.to_owned());
    assert_eq!(
        rows,
        [
            own("1a", "12,5 rad/s"),
            own("1b", "about three"),
            own("2a", "-k x")
        ]
    );
    let answers = desk.path("entered.json");
    desk.run(&["grade", &desk.path("manifest.json"), &answers])
        .ends(0)
        .says("unreadable");
    // It goes on: an answer is taken away, the others stay.
    enter(&desk, &format!("{}\n\n-\n", codes[0]))
        .ends(0)
        .says("3 answered before")
        .says("[about three]");
    assert_eq!(entered(&desk).len(), 2);
}

#[test]
fn a_code_that_is_none_is_asked_for_again() {
    let (desk, codes) = run("enter-codes");
    let mut wrong: Vec<char> = codes[1].chars().collect();
    wrong.swap(0, 1);
    let wrong: String = wrong.into_iter().collect();
    let ran = enter(&desk, &format!("{wrong}\n\u{1b}[31m\n"));
    ran.ends(0)
        .says(&format!("did you mean {}?", codes[1]))
        .says("0 of 3 sheets");
    assert_eq!(entered(&desk), []);
}

#[test]
fn nothing_is_lost_when_it_is_killed() {
    let (desk, codes) = run("enter-killed");
    let journal = desk.out.join(".entered.json.journal");
    let mut child = Command::new(env!("CARGO_BIN_EXE_vibank"))
        .args(["enter", &desk.path("manifest.json"), "--bank", BANK])
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    let mut input = child.stdin.take().expect("it has an input");
    write!(input, "{}\n1 rad/s\n2 Hz\n", codes[2]).expect("it is typed");
    input.flush().expect("it is typed");
    let begun = Instant::now();
    let kept = |journal: &PathBuf| journal.exists() && content(journal).contains("2 Hz");
    while !kept(&journal) && begun.elapsed() < Duration::from_mins(1) {
        std::thread::sleep(Duration::from_millis(20));
    }
    // Nobody else types into the file meanwhile.
    enter(&desk, "")
        .ends(2)
        .complains("somebody else types into");
    child.kill().expect("it is killed");
    child.wait().expect("it has ended");
    drop(input);
    // A line that was cut off in the middle.
    let mut file = std::fs::OpenOptions::new()
        .append(true)
        .open(&journal)
        .expect("it is there");
    file.write_all(b"{\"code\":\"").expect("it is written");
    drop(file);
    enter(&desk, &format!("{}\n\n\n3\n", codes[2]))
        .ends(0)
        .says("2 answered before");
    let typed: Vec<String> = entered(&desk)
        .into_iter()
        .map(|(_, place, typed)| format!("{place} {typed}"))
        .collect();
    assert_eq!(typed, ["1a 1 rad/s", "1b 2 Hz", "2a 3"]);
    // A file of others is not replaced.
    std::fs::remove_file(&journal).expect("it is there");
    enter(&desk, "")
        .ends(2)
        .complains("exists, and its journal does not");
    assert_eq!(entered(&desk).len(), 3);
    let other = text_of(&desk.folder.join("other.json"));
    fed(
        &[
            "enter",
            &desk.path("manifest.json"),
            "--out",
            &other,
            "--bank",
            BANK,
        ],
        Vec::new(),
    )
    .ends(0);
}
