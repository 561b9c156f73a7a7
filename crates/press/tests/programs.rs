//! Both programs from outside: `vibank` with the press of the same build beside it.
//!
//! `cargo build -p vibank -p vibank-press` has to come first; a missing program is a failure, not a skip.

use std::collections::BTreeMap;
use std::fs;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use vibank_press::{Greeting, Job, Reply};

/// The folder of the programs of this build.
fn programs() -> PathBuf {
    let press = Path::new(env!("CARGO_BIN_EXE_vibank-press"));
    press.parent().expect("it is in a folder").to_owned()
}

fn vibank() -> Command {
    let program = programs().join(format!("vibank{}", std::env::consts::EXE_SUFFIX));
    assert!(
        program.is_file(),
        "`{}` is missing: build it first, by `cargo build -p vibank`",
        program.display()
    );
    let mut command = Command::new(program);
    command.env_remove("VIBANK_PRESS");
    command
}

#[track_caller]
fn run(arguments: &[&str], code: i32) -> Output {
    let output = vibank().args(arguments).output().expect("it starts");
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "{arguments:?}: {said}");
    assert!(!said.contains("panicked"), "{said}");
    output
}

/// An empty folder of this name.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("the folder can be made");
    folder
}

fn text_of(path: &Path) -> String {
    path.to_string_lossy().into_owned()
}

/// A blueprint of one question without solutions.
fn drill(folder: &Path, format: &str, variants: usize, item: &str) -> String {
    let plan = format!(
        "title = 'T'\nseed = 1\nvariants = {variants}\nformats = ['{format}']\nsolutions = false\n[[question]]\nitem = '{item}'\n"
    );
    let path = folder.join("test.toml");
    #[expect(clippy::disallowed_methods, reason = "a test lays out its input")]
    fs::write(&path, plan).expect("it can be written");
    text_of(&path)
}

/// The files below a folder, with their bytes.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            found.extend(files(&path));
        } else {
            #[expect(
                clippy::disallowed_methods,
                reason = "a test looks at what was written"
            )]
            let bytes = fs::read(&path).expect("it can be read");
            found.insert(path, bytes);
        }
    }
    found
}

fn inside(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let named = files(folder).into_iter().map(|(path, bytes)| {
        let name = path.strip_prefix(folder).expect("it is inside");
        (text_of(name), bytes)
    });
    named.collect()
}

/// Where there is a TeX, it compiles what is made: sheets, keys and worked solutions, without an error or an overfull line.
#[test]
fn latex_is_compiled_where_there_is_a_tex() {
    let has_tex = Command::new("pdflatex")
        .arg("--version")
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status();
    if has_tex.is_err() {
        // Reported past the capture of the test runner.
        let _ = writeln!(
            std::io::stderr(),
            "skipped 1 test: there is no pdflatex, which compiles LaTeX"
        );
        return;
    }
    let folder = folder("compiled");
    let items = [
        "ch1/e5-rod-ke-huygens",
        "ch2/e3-amplitude-phase",
        "ch3/t6-coulomb-general",
        "ch4/t4-vibration-absorber",
        "ch5/t5-double-pendulum",
    ];
    let questions = items.map(|item| format!("[[question]]\nitem = '{item}'\n"));
    let plan = format!(
        "title = 'T'\nseed = 1\nvariants = 1\nformats = ['tex']\n{}",
        questions.concat()
    );
    let path = folder.join("test.toml");
    #[expect(clippy::disallowed_methods, reason = "a test lays out its input")]
    fs::write(&path, plan).expect("it can be written");
    let out = folder.join("out");
    run(&["sheet", &text_of(&path), "--out", &text_of(&out)], 0);
    let mut compiled = 0;
    for file in inside(&out)
        .into_keys()
        .filter(|name| name.ends_with(".tex"))
    {
        let ran = Command::new("pdflatex")
            .args([
                "-interaction=nonstopmode",
                "-halt-on-error",
                "-output-directory",
            ])
            .arg(&folder)
            .arg(&file)
            .current_dir(&out)
            .output()
            .expect("it starts");
        let log = String::from_utf8_lossy(&ran.stdout);
        assert!(ran.status.success(), "{file}: {log}");
        assert!(!log.contains("Overfull \\hbox"), "{file}: {log}");
        compiled += 1;
    }
    assert!(compiled >= 3, "{compiled} files");
}

/// What draws the figures of LaTeX works on the same threads as the sheets: neither waits for the other.
#[test]
fn figures_of_latex_are_drawn_by_several_threads() {
    let folder = folder("latex");
    let plan = drill(&folder, "tex", 8, "ch5/e5-coupled-pendulums-modes");
    let made = |name: &str, threads: &str| {
        let out = folder.join(name);
        run(
            &[
                "sheet",
                &plan,
                "--out",
                &text_of(&out),
                "--threads",
                threads,
            ],
            0,
        );
        inside(&out.join("figures"))
    };
    let first = made("first", "2");
    assert!(first.len() > 1);
    assert!(first.values().all(|bytes| bytes.starts_with(b"%PDF-1.")));
    assert_eq!(first, made("second", "1"));
}

#[test]
fn pages_are_printed_the_same_by_any_number_of_processes() {
    let folder = folder("print");
    let plan = drill(&folder, "pdf", 3, "ch1/e7-rolling-disk-ke");
    let made = |name: &str, threads: &str| {
        let out = folder.join(name);
        run(
            &[
                "sheet",
                &plan,
                "--out",
                &text_of(&out),
                "--threads",
                threads,
            ],
            0,
        );
        inside(&out)
    };
    let first = made("first", "2");
    assert!(first["key-table.pdf"].starts_with(b"%PDF-1."));
    assert_eq!(first, made("second", "1"));
}

/// A run that is killed goes on where it stopped, to the same bytes, and nothing is left over; a longer campaign sets
/// `VIBANK_KILLS`.
#[test]
fn a_killed_run_goes_on_to_the_same_bytes() {
    #[expect(
        clippy::disallowed_methods,
        reason = "how long the campaign is, is the user's setting"
    )]
    let kills = std::env::var("VIBANK_KILLS").ok();
    let kills = kills.and_then(|kills| kills.parse().ok()).unwrap_or(3);
    let folder = folder("killed");
    let plan = drill(&folder, "pdf", 12, "ch1/e7-rolling-disk-ke");
    let whole = folder.join("whole");
    #[expect(
        clippy::disallowed_methods,
        reason = "kills are spread over the time of a run"
    )]
    let begin = std::time::Instant::now();
    run(&["sheet", &plan, "--out", &text_of(&whole)], 0);
    let took = begin.elapsed();
    let whole = inside(&whole);
    for kill in 0..kills {
        let out = folder.join(format!("out-{kill}"));
        let mut child = vibank()
            .args(["sheet", &plan, "--out", &text_of(&out)])
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("it starts");
        // The golden ratio spreads the points of any number of kills.
        let share = (f64::from(kill) * 0.618_033_988_749 + 0.3).fract();
        std::thread::sleep(took.mul_f64(share));
        // It may have come to its end before.
        let _ = child.kill();
        child.wait().expect("it ends");
        for (name, bytes) in inside(&out) {
            let half = whole.get(&name).is_some_and(|whole| *whole != bytes);
            assert!(!half, "{name} is half a file");
        }
        run(&["sheet", &plan, "--out", &text_of(&out)], 0);
        assert!(inside(&out) == whole, "kill {kill} of {kills}");
        let _ = fs::remove_dir_all(&out);
    }
}

/// Five chapters of 12 to 20 pages, with the notation and the contents.
#[test]
fn the_course_is_one_file() {
    let folder = folder("course");
    let out = folder.join("course.pdf");
    for paper in ["a4", "letter"] {
        run(&["course", "--out", &text_of(&out), "--paper", paper], 0);
        let file = files(&folder).remove(&out).expect("it was written");
        let text = String::from_utf8_lossy(&file);
        let pages = text.matches("/Type/Page").count() - text.matches("/Type/Pages").count();
        assert!((60..=105).contains(&pages), "{pages} pages");
    }
}

#[test]
fn feedback_is_printed() {
    let folder = folder("feedback");
    let plan = drill(&folder, "pdf", 2, "ch1/e7-rolling-disk-ke");
    let out = folder.join("out");
    run(&["sheet", &plan, "--out", &text_of(&out)], 0);
    let [manifest, responses] =
        ["manifest.json", "responses.csv"].map(|name| text_of(&out.join(name)));
    run(&["grade", &manifest, &responses, "--feedback", "pdf"], 0);
    let pages = inside(&out.join("marks/feedback"));
    assert_eq!(pages.len(), 2);
    assert!(pages.values().all(|bytes| bytes.starts_with(b"%PDF-1.")));
}

#[test]
fn a_page_that_cannot_be_printed_is_named() {
    let folder = folder("unprinted");
    let plan = drill(&folder, "pdf", 1, "ch1/e7-rolling-disk-ke");
    let layouts = folder.join("layouts");
    fs::create_dir_all(layouts.join("pdf")).expect("it can be made");
    #[expect(clippy::disallowed_methods, reason = "a test lays out its input")]
    fs::write(layouts.join("pdf/end.typ"), "#nothing-of-this-name").expect("it can be written");
    let (out, layouts) = (text_of(&folder.join("out")), text_of(&layouts));
    let output = run(&["sheet", &plan, "--out", &out, "--layouts", &layouts], 3);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(
        said.contains("could not be printed: unknown variable"),
        "{said}"
    );
}

/// Any bytes on the pipe end the press, and nothing else.
#[test]
fn the_press_bears_any_bytes() {
    let sent =
        |length: u64, bytes: &[u8]| [&[1][..], &[0; 8], &length.to_le_bytes(), bytes].concat();
    for input in [
        Vec::new(),
        b"ab".to_vec(),
        sent(u64::MAX, b"cut"),
        sent(3, b"\xff#\xfe"),
    ] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_vibank-press"))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("it starts");
        let mut stdin = child.stdin.take().expect("it has a pipe");
        let _ = stdin.write_all(&input);
        drop(stdin);
        let mut replies = child.stdout.take().expect("it has a pipe");
        assert!(Greeting::receive(&mut replies).is_ok());
        let mut rest = Vec::new();
        replies.read_to_end(&mut rest).expect("it ends");
        assert!(rest.is_empty());
        assert!(child.wait().expect("it ends").success());
    }
}

/// A job that is refused leaves the press ready for the next one.
#[test]
fn a_refused_job_is_not_the_last() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_vibank-press"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("it starts");
    let mut jobs = child.stdin.take().expect("it has a pipe");
    let mut replies = child.stdout.take().expect("it has a pipe");
    let greeting = Greeting::receive(&mut replies).expect("it greets");
    assert_eq!(greeting, vibank_press::greeting());
    let mut asked = |text: &str| {
        let job = Job::Page {
            text: format!("#set document(title: [T])\n#set text(lang: \"en\")\n{text}"),
            fonts: Vec::new(),
        };
        job.send(&mut jobs).expect("it listens");
        Reply::receive(&mut replies).expect("it answers")
    };
    assert!(matches!(asked("#nonsense"), Reply::Refused(why) if why.contains("line 3")));
    assert!(matches!(asked("Hello"), Reply::File(bytes) if bytes.starts_with(b"%PDF-")));
    drop(jobs);
    assert!(child.wait().expect("it ends").success());
}
