//! Runs that do not come to their end: killed, interrupted, without room, without permission, two at once. Whatever
//! happens, a file is there whole or not at all, and the same run once more ends with the same bytes.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use super::{BANK, Ran, blueprint, content, folder, put, small, text_of};

/// How often each command is killed; a longer campaign sets `VIBANK_KILLS`.
fn kills() -> u64 {
    let kills = std::env::var("VIBANK_KILLS");
    kills.ok().and_then(|kills| kills.parse().ok()).unwrap_or(3)
}

/// A run whose files are known: its folder, blueprint, manifest and form.
struct Known {
    folder: PathBuf,
    plan: String,
    /// What `sheet` writes.
    sheets: Tree,
}

/// The files below a folder, hidden ones too.
type Tree = BTreeMap<PathBuf, Vec<u8>>;

fn tree(folder: &Path) -> Tree {
    let (mut tree, mut open) = (Tree::new(), vec![folder.to_owned()]);
    while let Some(inner) = open.pop() {
        for entry in fs::read_dir(&inner).into_iter().flatten().flatten() {
            let path = entry.path();
            if path.is_dir() {
                open.push(path);
            } else {
                let name = path.strip_prefix(folder).expect("it is inside").to_owned();
                #[expect(
                    clippy::disallowed_methods,
                    reason = "a test looks at what was written"
                )]
                tree.insert(name, fs::read(&path).expect("it can be read"));
            }
        }
    }
    tree
}

#[track_caller]
fn same(found: &Tree, expected: &Tree) {
    let names = |tree: &Tree| tree.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(found), names(expected), "other files");
    for (name, bytes) in expected {
        assert!(found[name] == *bytes, "{} has other bytes", name.display());
    }
}

/// Where files bear the names of finished ones, they are whole; drafts have names of their own.
#[track_caller]
fn whole(found: &Tree, expected: &Tree) {
    for (name, bytes) in found {
        if let Some(whole) = expected.get(name) {
            assert!(bytes == whole, "{} is half a file", name.display());
        }
    }
}

impl Known {
    fn new(name: &str) -> Self {
        let folder = folder(name);
        let book = if cfg!(feature = "xlsx") {
            ", 'xlsx'"
        } else {
            ""
        };
        let top = format!("seed = 3\nvariants = 40\nformats = ['html', 'md'{book}]");
        let plan = blueprint(&top);
        let plan = put(&folder, "plan.toml", plan);
        let known = Self {
            sheets: Tree::new(),
            folder,
            plan,
        };
        known.sheet("whole").ends(0);
        let sheets = tree(&known.folder.join("whole"));
        Self { sheets, ..known }
    }

    fn path(&self, name: &str) -> String {
        text_of(&self.folder.join(name))
    }

    fn sheet_arguments(&self, out: &str) -> Vec<String> {
        let words = [
            "sheet",
            &self.plan,
            "--bank",
            BANK,
            "--out",
            &self.path(out),
        ];
        words.map(str::to_owned).to_vec()
    }

    fn sheet(&self, out: &str) -> Ran {
        small(&["sheet", &self.plan, "--out", &self.path(out)])
    }

    /// The arguments that mark the whole run, its form filled in with one answer for all.
    fn grade_arguments(&self, out: &str) -> Vec<String> {
        let form = content(self.folder.join("whole/responses.csv"));
        let mut rows = form.lines();
        let header = rows.next().expect("a header").to_owned();
        let filled: String = rows.map(|row| format!("{row}3.5 rad/s\n")).collect();
        put(&self.folder, "form.csv", format!("{header}\n{filled}"));
        let (manifest, form) = (self.path("whole/manifest.json"), self.path("form.csv"));
        let out = self.path(out);
        let words = ["grade", &manifest, &form, "--bank", BANK, "--out", &out];
        words.map(str::to_owned).to_vec()
    }

    fn grade(&self, out: &str) -> Ran {
        let arguments = self.grade_arguments(out);
        super::vibank(&arguments.iter().map(String::as_str).collect::<Vec<_>>())
    }
}

fn start(arguments: &[String]) -> Child {
    Command::new(env!("CARGO_BIN_EXE_vibank"))
        .args(arguments)
        .env("VIBANK_CACHE", "")
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts")
}

/// Kills runs at points spread over their time, each again and again until one comes through.
fn survives_kills(
    name: &str,
    arguments: &dyn Fn(&str) -> Vec<String>,
    out: &dyn Fn(&str) -> PathBuf,
    whole_run: &Tree,
    took: Duration,
) {
    let kills = kills();
    for kill in 0..kills {
        let place = format!("{name}-{kill}");
        // The golden ratio spreads the points of any number of kills.
        let share = (kill as f64 * 0.618_033_988_749 + 0.3).fract();
        let mut child = start(&arguments(&place));
        std::thread::sleep(took.mul_f64(share));
        let _ = child.kill();
        let _ = child.wait();
        whole(&tree(&out(&place)), whole_run);
        let mut again = start(&arguments(&place));
        let status = again.wait().expect("it ends");
        assert!(status.code().is_some_and(|code| code < 2), "{status}");
        let mut found = tree(&out(&place));
        // Who marks a run that was marked to the end sees what has changed: nothing.
        if let Some(changes) = found.remove(Path::new("changes.csv")) {
            assert!(String::from_utf8_lossy(&changes).lines().count() <= 1);
        }
        same(&found, whole_run);
        let _ = fs::remove_dir_all(out(&place));
    }
}

#[test]
fn killed_runs_are_taken_up_and_end_with_the_same_bytes() {
    let known = Known::new("kills");
    let out = |place: &str| known.folder.join(place);
    let begin = Instant::now();
    known.sheet("timed").ends(0);
    let took = begin.elapsed();
    same(&tree(&out("timed")), &known.sheets);
    survives_kills(
        "sheet",
        &|place| known.sheet_arguments(place),
        &out,
        &known.sheets,
        took,
    );
    let begin = Instant::now();
    let code = known.grade("marked").code;
    assert!(code < 2);
    let took = begin.elapsed();
    let marked = tree(&out("marked"));
    survives_kills(
        "grade",
        &|place| known.grade_arguments(place),
        &out,
        &marked,
        took,
    );
}

#[test]
fn two_runs_at_once_leave_what_one_leaves() {
    let known = Known::new("at-once");
    let out = |place: &str| known.folder.join(place);
    let mut runs = [(); 2].map(|()| start(&known.sheet_arguments("both")));
    let codes = runs
        .each_mut()
        .map(|run| run.wait().expect("it ends").code());
    assert!(codes.contains(&Some(0)), "{codes:?}");
    assert!(
        codes.iter().all(|code| matches!(code, Some(0 | 2))),
        "{codes:?}"
    );
    same(&tree(&out("both")), &known.sheets);
}

/// Runs a command with files of at most so many blocks of 512 bytes, as on a full disk.
#[cfg(unix)]
fn without_room(blocks: u32, arguments: &[String]) -> Ran {
    let script = format!("trap '' XFSZ; ulimit -f {blocks}; exec \"$0\" \"$@\"");
    let output = Command::new("sh")
        .args(["-c", &script, env!("CARGO_BIN_EXE_vibank")])
        .args(arguments)
        .env("VIBANK_CACHE", "")
        .output()
        .expect("a shell");
    Ran {
        code: output.status.code().unwrap_or(-1),
        out: String::from_utf8_lossy(&output.stdout).into_owned(),
        err: String::from_utf8_lossy(&output.stderr).into_owned(),
    }
}

#[cfg(unix)]
#[test]
fn a_full_disk_ends_a_run_with_words_and_no_half_files() {
    let known = Known::new("full");
    let out = |place: &str| known.folder.join(place);
    for blocks in [0, 1, 16] {
        let ran = without_room(blocks, &known.sheet_arguments("sheets"));
        let ran = ran.ends(2).complains("cannot write");
        assert!(!ran.err.contains("panicked"), "{}", ran.err);
        whole(&tree(&out("sheets")), &known.sheets);
    }
    // With room again the run comes to its end, and leaves nothing behind.
    known.sheet("sheets").ends(0);
    same(&tree(&out("sheets")), &known.sheets);
    let code = known.grade("marked").code;
    assert!(code < 2);
    let marked = tree(&out("marked"));
    for blocks in [0, 1, 8] {
        let ran = without_room(blocks, &known.grade_arguments("marks"));
        let ran = ran.ends(2).complains("cannot write");
        assert!(!ran.err.contains("panicked"), "{}", ran.err);
        whole(&tree(&out("marks")), &marked);
    }
    assert!(known.grade("marks").code < 2);
    same(&tree(&out("marks")), &marked);
}

#[cfg(unix)]
#[test]
fn a_folder_that_cannot_be_written_is_named() {
    use std::os::unix::fs::PermissionsExt as _;

    let known = Known::new("read-only");
    let closed = known.folder.join("closed");
    fs::create_dir_all(&closed).expect("the folder can be made");
    fs::set_permissions(&closed, fs::Permissions::from_mode(0o555)).expect("it is ours");
    // Who may write everywhere is stopped by a file where a folder is due.
    put(&known.folder, "file", "");
    let is_closed = fs::create_dir(closed.join("inner")).is_err();
    let places = [known.folder.join("file/out"), closed.join("out")];
    for place in places.iter().take(1 + usize::from(is_closed)) {
        let text = text_of(place);
        let ran = small(&["sheet", &known.plan, "--out", &text]).ends(2);
        ran.complains("cannot write").complains(&text);
    }
    fs::set_permissions(&closed, fs::Permissions::from_mode(0o755)).expect("it is ours");
}

#[cfg(unix)]
#[test]
fn an_interrupt_from_the_keyboard_ends_a_run_which_can_be_taken_up() {
    let known = Known::new("interrupt");
    let mut run = start(&known.sheet_arguments("sheets"));
    std::thread::sleep(Duration::from_millis(60));
    let _ = Command::new("kill")
        .args(["-INT", &run.id().to_string()])
        .status();
    let begin = Instant::now();
    let status = run.wait().expect("it ends");
    assert!(begin.elapsed() < Duration::from_secs(20));
    // It may have come to its end before.
    assert!(
        status.success() || status.code().is_none_or(|code| code == 130),
        "{status}"
    );
    whole(&tree(&known.folder.join("sheets")), &known.sheets);
    known.sheet("sheets").ends(0);
    same(&tree(&known.folder.join("sheets")), &known.sheets);
}
