//! The index of a bank in a folder: it saves reading, never shows anything else, and is made anew whatever became of it.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use sha2::{Digest, Sha256};

use super::{BANK, Ran, content, folder, put, run_with, text_of};

/// A copy of the small bank that was not touched lately, and an empty cache.
struct Place {
    bank: PathBuf,
    cache: PathBuf,
}

impl Place {
    fn new(name: &str) -> Self {
        let folder = folder(name);
        let bank = folder.join("bank");
        copy(Path::new(BANK), &bank);
        Self {
            bank,
            cache: folder.join("cache"),
        }
    }

    #[track_caller]
    fn run(&self, arguments: &[&str]) -> Ran {
        let bank = text_of(&self.bank);
        run_with(
            &[("VIBANK_CACHE", &text_of(&self.cache))],
            &[arguments, &["--bank", &bank]].concat(),
        )
    }

    /// What a list shows.
    #[track_caller]
    fn list(&self) -> String {
        self.run(&["list"]).ends(0).out
    }

    /// The only index of the cache.
    #[track_caller]
    fn index(&self) -> PathBuf {
        let files = fs::read_dir(self.cache.join("banks")).expect("an index was written");
        let files: Vec<PathBuf> = files.map(|file| file.expect("a file").path()).collect();
        let [index] = files.as_slice() else {
            panic!("one index: {files:?}")
        };
        index.clone()
    }

    /// Writes an index with the same head and other rows, whose digest is right.
    fn forge(&self, change: impl Fn(&str) -> String) {
        let path = self.index();
        let text = content(&path);
        let (head, rows) = text.split_once('\n').expect("a head");
        let digest = |rows: &str| -> String {
            let digest = Sha256::digest(rows.as_bytes());
            digest.iter().map(|byte| format!("{byte:02x}")).collect()
        };
        let forged = change(rows);
        let head = head.replace(&digest(rows), &digest(&forged));
        write(&path, &format!("{head}\n{forged}"));
    }
}

/// Writes a file in place, so that its permissions stay.
fn write(path: &Path, content: &str) {
    #[expect(clippy::disallowed_methods, reason = "a test lays out its input")]
    fs::write(path, content).expect("the file can be written");
}

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("a folder");
    for entry in fs::read_dir(from).expect("a folder") {
        let entry = entry.expect("an entry");
        let target = to.join(entry.file_name());
        if entry.path().is_dir() {
            copy(&entry.path(), &target);
        } else {
            fs::copy(entry.path(), &target).expect("a copy");
            age(&target);
        }
    }
}

/// As if a file had been changed long ago.
fn age(path: &Path) {
    let file = fs::File::options().append(true).open(path).expect("a file");
    #[expect(clippy::disallowed_methods, reason = "a test sets a time in the past")]
    let past = SystemTime::now() - Duration::from_hours(1);
    file.set_modified(past).expect("its time can be set");
}

#[test]
fn an_index_saves_reading_and_shows_the_same() {
    let place = Place::new("index-saves");
    let first = place.list();
    assert_eq!(first, place.run(&["list", "--no-index"]).ends(0).out);
    assert_eq!(first, place.list());
    // A row that says something else shows that the file was not read for it; what is used is.
    place.forge(|rows| rows.replace("\"title\":\"", "\"title\":\"Forged "));
    assert!(place.list().contains("Forged"));
    let shown = place.run(&["show", "free/spring-mass"]).ends(0).out;
    assert!(!shown.contains("Forged"), "{shown}");
    assert_eq!(first, place.run(&["list", "--no-index"]).ends(0).out);
}

#[test]
fn a_changed_file_is_read_anew() {
    let place = Place::new("index-changed");
    place.list();
    let path = place.bank.join("free/spring-mass.toml");
    let text = content(&path);
    let title = text
        .lines()
        .find_map(|line| line.strip_prefix("title  = "))
        .expect("a title")
        .trim_matches(['"', '\'']);
    let other: String = title.chars().rev().collect();
    // Of the same size, and as if it had been changed at the same time as before.
    let before = fs::metadata(&path).and_then(|before| before.modified());
    write(&path, &text.replacen(title, &other, 1));
    let file = fs::File::options()
        .append(true)
        .open(&path)
        .expect("a file");
    file.set_modified(before.expect("a time"))
        .expect("its time can be set");
    if cfg!(unix) {
        assert!(place.list().contains(&other));
    }
    // One that was changed just now, again and again.
    for word in ["Aaa", "Bbb", "Ccc"] {
        write(&path, &text.replacen(title, word, 1));
        assert!(place.list().contains(word), "{word}");
    }
    fs::remove_file(&path).expect("it can be removed");
    assert!(!place.list().contains("free/spring-mass"));
}

#[test]
fn the_words_of_the_bank_belong_to_its_index() {
    let place = Place::new("index-words");
    place.list();
    let path = place.bank.join("bank.toml");
    let text = content(&path);
    write(&path, &format!("{text}\n# changed\n"));
    place.forge(|rows| rows.replace("\"title\":\"", "\"title\":\"Forged "));
    assert!(!place.list().contains("Forged"));
}

#[test]
fn an_index_that_cannot_be_trusted_is_made_anew() {
    let place = Place::new("index-broken");
    let right = place.list();
    let index = place.index();
    let written = content(&index);
    let half = written.len() / 2;
    let title = written.replacen("\"title\":\"", "\"title\":\"Forged ", 1);
    let times = written.replacen('\t', "\t99999999999999999999 ", 1);
    for broken in ["", "\n", "{}\n", &written[..half], &title, &times] {
        write(&index, broken);
        assert_eq!(place.list(), right, "{broken:.80}");
        assert!(!content(&index).contains("Forged"));
        assert!(content(&index).len() == written.len(), "{broken:.80}");
    }
    // Rows that are none, under a digest that is right.
    for row in [
        "x",
        "\t\t\t",
        "free/spring-mass\t1 2 3 4\t{}",
        "free/spring-mass\t-1\tnull",
    ] {
        place.forge(|_| format!("{row}\n"));
        assert_eq!(place.list(), right, "{row}");
    }
    place.forge(|rows| rows.replace("\t{", "\t[{"));
    assert_eq!(place.list(), right);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let mode = |path: &Path| {
            fs::metadata(path)
                .expect("it is there")
                .permissions()
                .mode()
                & 0o777
        };
        place.list();
        assert_eq!((mode(&index), mode(&place.cache)), (0o600, 0o700));
        place.forge(|rows| rows.replace("\"title\":\"", "\"title\":\"Forged "));
        fs::set_permissions(&index, fs::Permissions::from_mode(0o666)).expect("a file of ours");
        assert_eq!(place.list(), right);
        // A link, or a folder, in its place.
        let elsewhere = put(&place.cache, "elsewhere", "kept");
        for _ in 0..2 {
            fs::remove_file(&index).expect("a file of ours");
            std::os::unix::fs::symlink(&elsewhere, &index).expect("a link");
            assert_eq!(place.list(), right);
        }
        assert_eq!(content(&elsewhere), "kept");
        fs::remove_file(&index).expect("a file of ours");
        fs::create_dir(&index).expect("a folder");
        assert_eq!(place.list(), right);
    }
}

#[test]
fn without_a_place_for_an_index_everything_is_read() {
    let place = Place::new("index-nowhere");
    let right = place.list();
    let bank = text_of(&place.bank);
    let file = put(&place.bank, "no-folder", "");
    for cache in ["", &file, "/dev/null/nothing"] {
        let ran = run_with(&[("VIBANK_CACHE", cache)], &["list", "--bank", &bank]).ends(0);
        assert_eq!(
            (ran.out, ran.err),
            (right.clone(), String::new()),
            "{cache}"
        );
    }
    fs::remove_dir_all(&place.cache).expect("the cache can be removed");
    place.run(&["list", "--no-index"]).ends(0);
    assert!(!place.cache.exists());
}

#[test]
fn errors_are_counted_with_and_without_an_index() {
    let place = Place::new("index-errors");
    age(Path::new(&put(
        &place.bank,
        "free/broken.toml",
        "[item]\ntitle = 3\n",
    )));
    age(Path::new(&put(
        &place.bank,
        "free/no-text.toml",
        b"title = '\xff'\n",
    )));
    let said = |arguments: &[&str]| place.run(arguments).ends(0).err;
    for command in [["list"].as_slice(), &["show", "free/spring-mass"]] {
        let without = said(&[command, &["--no-index"]].concat());
        assert!(
            without.contains("in the bank, `vibank check` shows"),
            "{without}"
        );
        for _ in 0..2 {
            assert_eq!(said(command), without);
        }
    }
}

#[test]
fn an_item_that_is_named_in_full_is_checked_alone() {
    let place = Place::new("index-exact");
    let text = content(place.bank.join("free/spring-mass.toml"));
    put(&place.bank, "free/spring-mass-two.toml", text);
    let check = |name| place.run(&["check", name, "--seeds", "1"]).err;
    assert!(check("free/spring-mass").contains("1 item,"));
    assert!(check("free/spring-mass.toml").contains("1 item,"));
    assert!(check("free/spring-ma").contains("2 items,"));
}
