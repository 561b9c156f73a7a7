//! The command line from outside: what each command prints, writes and ends with.

mod authors;
mod commands;
mod crash;
mod desk;
mod enter;
mod forget;
mod forms;
mod french;
mod golden;
mod grading;
mod groups;
mod hostile;
mod index;
mod marks;
mod mistaken;
mod newcomer;
mod platforms;
mod practice;
mod press;
mod print;
mod privacy;
mod reports;
mod requests;
mod runs;
mod shards;
mod sheets;
mod sort;
mod tables;
mod trace;
mod work;
mod workbooks;

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread;

/// The small bank of the tests.
const BANK: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/bank");

/// How a run ended and what it said.
#[derive(Debug)]
struct Ran {
    code: i32,
    out: String,
    err: String,
}

impl Ran {
    /// The run, if it ended with this code; else the test fails and shows what was said.
    #[track_caller]
    fn ends(self, code: i32) -> Self {
        assert_eq!(
            self.code, code,
            "stdout: {}\nstderr: {}",
            self.out, self.err
        );
        self
    }

    /// The run, if it says this on standard error.
    #[track_caller]
    fn complains(self, words: &str) -> Self {
        assert!(
            self.err.contains(words),
            "`{words}` is not in: {}",
            self.err
        );
        self
    }

    /// The run, if it says this on standard output.
    #[track_caller]
    fn says(self, words: &str) -> Self {
        assert!(
            self.out.contains(words),
            "`{words}` is not in: {}",
            self.out
        );
        self
    }

    /// What was printed, line by line, as JSON.
    #[track_caller]
    fn lines(&self) -> Vec<serde_json::Value> {
        self.out
            .lines()
            .map(|line| serde_json::from_str(line).expect("each line is JSON"))
            .collect()
    }
}

/// Runs the program.
fn vibank(arguments: &[&str]) -> Ran {
    fed(arguments, Vec::new())
}

/// Runs the program on the small bank.
fn small(arguments: &[&str]) -> Ran {
    vibank(&[arguments, &["--bank", BANK]].concat())
}

/// Runs the program with something on its standard input; a panic fails the test.
#[track_caller]
fn fed(arguments: &[&str], input: Vec<u8>) -> Ran {
    started(&[("VIBANK_PRESS", "")], arguments, input)
}

/// Runs the program with these variables of the environment.
#[track_caller]
fn run_with(variables: &[(&str, &str)], arguments: &[&str]) -> Ran {
    started(variables, arguments, Vec::new())
}

#[track_caller]
fn started(variables: &[(&str, &str)], arguments: &[&str], input: Vec<u8>) -> Ran {
    let mut child = Command::new(env!("CARGO_BIN_EXE_vibank"))
        .args(arguments)
        // No test leaves anything with the user.
        .env("VIBANK_CACHE", "")
        .envs(variables.iter().copied())
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let mut stdin = child.stdin.take().expect("it has a standard input");
    // The program may end before it has read everything.
    let feeding = thread::spawn(move || drop(stdin.write_all(&input)));
    let output = child.wait_with_output().expect("the program ends");
    feeding.join().expect("feeding does not fail");
    let ran = Ran {
        code: output.status.code().unwrap_or(-1),
        out: String::from_utf8(output.stdout).expect("the output is UTF-8"),
        err: String::from_utf8(output.stderr).expect("the reports are UTF-8"),
    };
    assert!(!ran.err.contains("panicked"), "{}", ran.err);
    assert!(
        (0..=3).contains(&ran.code),
        "it ended with {}: {}",
        ran.code,
        ran.err
    );
    ran
}

/// An empty folder of this name.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("cli")
        .join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("the folder can be made");
    folder
}

/// Writes a file of a folder; its path.
fn put(folder: &Path, name: &str, content: impl AsRef<[u8]>) -> String {
    let path = folder.join(name);
    fs::create_dir_all(path.parent().expect("it has a folder")).expect("the folder can be made");
    #[expect(clippy::disallowed_methods, reason = "a test lays out its input")]
    fs::write(&path, content).expect("the file can be written");
    text_of(&path)
}

/// The text of a file.
#[track_caller]
fn content(path: impl AsRef<Path>) -> String {
    #[expect(
        clippy::disallowed_methods,
        reason = "a test looks at what was written"
    )]
    fs::read_to_string(path.as_ref())
        .unwrap_or_else(|error| panic!("{}: {error}", path.as_ref().display()))
}

/// A path as an argument.
fn text_of(path: &Path) -> String {
    path.to_str().expect("the path is UTF-8").to_owned()
}

/// A blueprint over the three items of the small bank, with further keys at its top.
fn blueprint(audience: &str) -> String {
    let items = [
        "free/spring-mass",
        "free/damped-block",
        "friction/half-cycles",
    ];
    let questions = items.map(|item| format!("[[question]]\nitem = \"{item}\"\n"));
    format!("title = \"A test\"\n{audience}\n{}", questions.concat())
}
