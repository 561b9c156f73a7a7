//! What a run gives away, what it follows and what it leaves: nothing that it should not.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::desk::{Desk, all, answered};
use super::{content, folder, put, small, text_of, vibank};

fn json(path: &Path) -> Value {
    serde_json::from_str(&content(path)).expect("it is JSON")
}

/// A number in the notations in which a page could carry it.
pub(super) fn notations(number: u64) -> Vec<String> {
    let in_base = |digits: &[u8]| {
        let (mut rest, mut text) = (number, Vec::new());
        while rest > 0 {
            text.push(digits[(rest % 32) as usize]);
            rest /= 32;
        }
        text.reverse();
        String::from_utf8(text).expect("digits are ASCII")
    };
    vec![
        number.to_string(),
        format!("{number:x}"),
        in_base(b"0123456789abcdefghjkmnpqrstvwxyz"),
        in_base(b"abcdefghijklmnopqrstuvwxyz234567"),
        in_base(b"0123456789abcdefghijklmnopqrstuv"),
    ]
}

/// The seeds of all items in a manifest.
pub(super) fn seeds(manifest: &Value) -> BTreeSet<u64> {
    let variants = manifest["variants"].as_array().expect("it has sheets");
    let questions = variants
        .iter()
        .flat_map(|variant| variant["questions"].as_array().expect("it has questions"));
    questions
        .map(|question| question["seed"].as_u64().expect("it has a seed"))
        .collect()
}

/// A run with a secret whose items have figures and plots.
fn keyed(folder: &Path, split: bool) -> PathBuf {
    let key = text_of(&folder.join("exam.key"));
    let _ = fs::remove_file(&key);
    vibank(&["new", "secret", &key]).ends(0);
    let plan = "title = 'T'\nsecret = 'exam.key'\nvariants = 5\nformats = ['html', 'md']\nhints = true\n\
        [[question]]\nitem = 'ch3/e4-underdamped-response'\n\
        [[question]]\nitem = 'ch4/e2-amplitude-resonance'\n\
        [[question]]\nitem = 'ch1/e9-pendulum-equilibrium-stability'\n";
    let plan = put(folder, "exam.toml", plan);
    let out = folder.join(if split { "split" } else { "whole" });
    let mut arguments = vec!["sheet", &plan, "--out"];
    let text = text_of(&out);
    arguments.push(&text);
    if split {
        arguments.push("--split");
    }
    vibank(&arguments).ends(0);
    out
}

#[test]
fn nothing_that_is_handed_out_tells_a_seed() {
    let folder = folder("handed-out");
    for split in [false, true] {
        let out = keyed(&folder, split);
        let manifest = out.join("manifest.json");
        let seeds = seeds(&json(&manifest));
        assert_eq!(seeds.len(), 15);
        // Every part is answered with something that gets a remark.
        let answered = answered(&content(out.join("responses.csv")), "1.5");
        let responses = put(&folder, "responses.csv", answered);
        let marks = text_of(&folder.join(if split { "marks-split" } else { "marks" }));
        let manifest = text_of(&manifest);
        vibank(&["grade", &manifest, &responses, "--out", &marks]);
        let kinds = ["/sheets", "/solutions", "/feedback"];
        let is_handed_out = |path: &PathBuf| {
            let inside = text_of(path);
            kinds.iter().any(|kind| inside.contains(kind))
        };
        let (given, kept): (Vec<PathBuf>, Vec<PathBuf>) = all(&out)
            .into_iter()
            .chain(all(Path::new(&marks)))
            .partition(is_handed_out);
        for kind in kinds {
            let made = given.iter().any(|path| text_of(path).contains(kind));
            assert!(made, "nothing was made in {kind}");
        }
        for path in given {
            let text = content(&path).to_lowercase();
            for seed in &seeds {
                for notation in notations(*seed) {
                    assert!(
                        !text.contains(&notation),
                        "{} holds the seed {seed} as {notation}",
                        path.display()
                    );
                }
            }
        }
        // What the teacher keeps has them: the search does find seeds.
        let kept = kept.iter().find(|path| path.ends_with("manifest.json"));
        let kept = content(kept.expect("there is a manifest"));
        assert!(seeds.iter().all(|seed| kept.contains(&seed.to_string())));
    }
}

#[test]
fn a_page_of_a_secret_blueprint_is_that_of_any_other() {
    let folder = folder("secret-page");
    let question = "[[question]]\nitem = 'ch3/e5-log-decrement'\n";
    let page = |top: &str| {
        let plan = put(
            &folder,
            "exam.toml",
            format!("title = 'T'\nvariants = 2\n{top}\n{question}"),
        );
        let out = text_of(&folder.join("page.html"));
        vibank(&["page", &plan, "--out", &out]).ends(0);
        content(&out)
    };
    put(&folder, "exam.key", "0123456789abcdef0123456789abcdef");
    assert_eq!(page("secret = 'exam.key'"), page("seed = 4"));
}

#[test]
fn a_plain_run_says_that_its_codes_give_the_sheets_back() {
    let desk = Desk::new("plain");
    desk.sheet(&desk.plan("seed = 3\nvariants = 2"), &[])
        .ends(0)
        .complains("vibank new secret");
}

#[test]
fn a_seed_and_a_secret_are_not_taken_together() {
    let desk = Desk::new("seed-and-secret");
    desk.secret();
    let plan = desk.plan("seed = 3\nsecret = 'exam.key'\nvariants = 2");
    desk.sheet(&plan, &[])
        .ends(2)
        .complains("t.toml:3:10")
        .complains("either `seed` or `secret`")
        .complains("remove `seed`");
}

#[test]
fn a_secret_is_made_once_and_named_where_one_is_missing() {
    let desk = Desk::new("new-secret");
    let key = text_of(&desk.folder.join("exam.key"));
    vibank(&["new", "secret", &key])
        .ends(0)
        .says("secret = \"exam.key\"");
    let secret = content(&key);
    assert_eq!(secret.trim_end().len(), 64);
    vibank(&["new", "secret", &key])
        .ends(2)
        .complains("exists already");
    assert_eq!(content(&key), secret);
    let other = text_of(&desk.folder.join("other.key"));
    vibank(&["new", "secret", &other]).ends(0);
    assert_ne!(content(&other), secret);
    for (name, text) in [("none.key", None), ("short.key", Some("1234"))] {
        if let Some(text) = text {
            put(&desk.folder, name, text);
        }
        let plan = desk.plan(&format!("secret = '{name}'\nvariants = 2"));
        desk.sheet(&plan, &[])
            .ends(2)
            .complains("vibank new secret");
    }
}

/// A run of two sheets.
fn plain(name: &str) -> Desk {
    let desk = Desk::new(name);
    desk.sheet(&desk.plan("seed = 3\nvariants = 2"), &[])
        .ends(0);
    desk
}

#[test]
fn no_manifest_names_a_file_outside_of_its_folder() {
    let desk = plain("outside");
    let (folder, manifest) = (&desk.folder, desk.text("manifest.json"));
    let code = desk.manifest()["variants"][0]["code"]
        .as_str()
        .expect("it has a code")
        .to_owned();
    let outside = folder.join("escaped");
    let bad = [
        "../../escaped/x".to_owned(),
        text_of(&outside.join("x")),
        "..".to_owned(),
        "a/b".to_owned(),
        String::new(),
        code.to_lowercase(),
        "3PZ-HEN-YFA".to_owned(),
    ];
    for form in ["lines", "pretty"] {
        for bad in &bad {
            let quoted = serde_json::to_string(bad).expect("a text");
            let mut forged = manifest.replace(&format!("\"{code}\""), &quoted);
            if form == "pretty" {
                let value: Value = serde_json::from_str(&forged).expect("it is JSON");
                forged = serde_json::to_string_pretty(&value).expect("it is JSON");
            }
            let forged = put(folder, "forged.json", forged);
            let responses = desk.path("responses.csv");
            let marks = text_of(&folder.join("a/b/marks"));
            small(&["grade", &forged, &responses, "--out", &marks])
                .ends(2)
                .complains("not a code of a sheet");
            assert!(!outside.exists() && !folder.join("a/escaped").exists());
            let shown = small(&["show", &code, "--manifest", &forged]).ends(2);
            assert!(shown.err.contains("not a code of a sheet"), "{}", shown.err);
        }
    }
}

#[test]
fn no_part_of_a_manifest_has_points_that_none_can_have() {
    let desk = plain("forged-points");
    let manifest = desk.text("manifest.json");
    for bad in ["-1.0", "1e300"] {
        let forged = manifest.replacen("\"points\":1.0}", &format!("\"points\":{bad}}}"), 1);
        assert_ne!(forged, manifest);
        let forged = put(&desk.folder, "forged.json", forged);
        small(&["grade", &forged, &desk.path("responses.csv")])
            .ends(2)
            .complains("is not a number of points");
    }
}

#[cfg(unix)]
mod on_unix {
    use std::fs;
    use std::os::unix::fs::{PermissionsExt, symlink};
    use std::path::Path;

    use super::super::{content, put, small, text_of};
    use super::{Desk, all, plain};

    fn mode(path: &Path) -> u32 {
        fs::metadata(path)
            .expect("it is there")
            .permissions()
            .mode()
            & 0o777
    }

    #[test]
    fn what_a_run_writes_is_its_owners_alone() {
        let desk = plain("modes");
        desk.grade(&[]).ends(0);
        for path in all(&desk.out) {
            assert_eq!(mode(&path), 0o600, "{}", path.display());
        }
        for inside in ["", "marks", "marks/feedback"] {
            assert_eq!(mode(&desk.out.join(inside)), 0o700, "{inside}");
        }
        let key = text_of(&desk.folder.join("exam.key"));
        super::vibank(&["new", "secret", &key]).ends(0);
        assert_eq!(mode(Path::new(&key)), 0o600);
    }

    #[test]
    fn no_link_is_followed() {
        let desk = Desk::new("links");
        let Desk { folder, out, .. } = &desk;
        let victim = folder.join("victim.txt");
        let elsewhere = folder.join("elsewhere");
        fs::create_dir_all(&elsewhere).expect("a folder");
        let plan = desk.plan("seed = 3\nvariants = 2");
        for (name, target) in [
            (".manifest.json.part", &victim),
            (".sheet.run", &victim),
            ("manifest.json", &victim),
            ("sheets.html", &victim),
            ("sheets", &elsewhere),
            ("keys", &elsewhere),
        ] {
            let _ = fs::remove_dir_all(out);
            fs::create_dir_all(out).expect("a folder");
            put(folder, "victim.txt", "precious");
            symlink(target, out.join(name)).expect("a link");
            let split = if name == "sheets" || name == "keys" {
                "--split"
            } else {
                "--trace"
            };
            let ran = desk.sheet(&plan, &[split]);
            if name != ".manifest.json.part" {
                let ran = ran.ends(2);
                assert!(ran.err.contains("link"), "{name}: {}", ran.err);
            }
            assert_eq!(content(&victim), "precious", "{name}");
            assert!(all(&elsewhere).is_empty(), "{name}");
        }
        // A second name of a file is no ledger of ours, either.
        let _ = fs::remove_dir_all(out);
        fs::create_dir_all(out).expect("a folder");
        fs::hard_link(&victim, out.join(".sheet.run")).expect("a second name");
        desk.sheet(&plan, &[]).ends(2);
        assert_eq!(content(&victim), "precious");
    }

    #[test]
    fn marking_follows_no_link() {
        let desk = plain("grade-links");
        let folder = &desk.folder;
        let victim = folder.join("victim.txt");
        let elsewhere = folder.join("elsewhere");
        fs::create_dir_all(&elsewhere).expect("a folder");
        for (name, target) in [
            ("marks.csv", &victim),
            (".grading.jsonl", &victim),
            ("feedback", &elsewhere),
        ] {
            let marks = folder.join("marks");
            let _ = fs::remove_dir_all(&marks);
            fs::create_dir_all(&marks).expect("a folder");
            put(folder, "victim.txt", "precious");
            symlink(target, marks.join(name)).expect("a link");
            desk.grade(&["--out", &text_of(&marks)])
                .ends(2)
                .complains("link");
            assert_eq!(content(&victim), "precious", "{name}");
            assert!(all(&elsewhere).is_empty(), "{name}");
        }
    }

    /// Folders that a run makes within its own are such that somebody could have put a link in their place.
    #[test]
    fn no_link_in_place_of_a_folder_of_the_run_is_followed() {
        let desk = plain("inner-links");
        let elsewhere = desk.folder.join("elsewhere");
        fs::create_dir_all(&elsewhere).expect("a folder");
        for name in ["marks", "form"] {
            symlink(&elsewhere, desk.out.join(name)).expect("a link");
        }
        desk.grade(&[]).ends(2).complains("marks` is a link");
        desk.run(&["form", &desk.path("manifest.json")])
            .ends(2)
            .complains("form` is a link");
        assert!(all(&elsewhere).is_empty());
        // Who names it knows where it leads.
        desk.grade(&["--out", &desk.path("marks")]).ends(0);
        assert!(elsewhere.join("marks.csv").exists());
    }

    #[test]
    fn what_is_no_file_is_refused_at_once() {
        let desk = Desk::new("pipes");
        let pipe = desk.folder.join("class.csv");
        let made = std::process::Command::new("mkfifo").arg(&pipe).status();
        assert!(made.is_ok_and(|made| made.success()), "a pipe can be made");
        desk.sheet(&desk.plan("seed = 3\nstudents = 'class.csv'"), &[])
            .ends(2)
            .complains("a pipe or a device");
        small(&["sheet", &text_of(&desk.folder)])
            .ends(2)
            .complains("is a folder, not a file");
    }
}

#[test]
fn what_interrupted_commands_have_left_beside_a_file_is_removed() {
    let folder = folder("left-beside");
    for name in [
        ".p.html.8pxHX8.part",
        ".q.xml.a.part",
        ".other.html.b.part",
        ".p.html.b.c.part",
    ] {
        put(&folder, name, "left");
    }
    // One that a program still writes to.
    let busy = put(&folder, ".p.html.busy.part", "being written");
    let busy = fs::File::open(busy).expect("it is there");
    busy.lock().expect("it can be locked");
    let item = "free/spring-mass";
    small(&["page", item, "--out", &text_of(&folder.join("p.html"))]).ends(0);
    let out = text_of(&folder.join("q.xml"));
    small(&["export", "moodle", item, "--out", &out]).ends(0);
    let hidden = |path: &PathBuf| {
        let name = path.file_name().expect("it has a name").to_string_lossy();
        name.starts_with('.').then(|| name.into_owned())
    };
    let mut left: Vec<String> = all(&folder).iter().filter_map(hidden).collect();
    left.sort();
    let busy: &[&str] = if cfg!(unix) {
        &[".p.html.busy.part"]
    } else {
        &[]
    };
    let others: &[&str] = &[".other.html.b.part", ".p.html.b.c.part"];
    let expected = [others, busy].concat();
    assert_eq!(left, expected);
}

#[test]
fn a_bank_that_was_begun_is_completed_and_one_of_somebody_stays() {
    let folder = folder("begun-bank");
    let bank = text_of(&folder.join("bank"));
    vibank(&["new", "bank", &bank]).ends(0);
    let item = content(folder.join("bank/ch1/block-on-a-spring.toml"));
    vibank(&["new", "bank", &bank])
        .ends(2)
        .complains("exists already");
    // The file that makes it a bank is written last.
    fs::remove_file(folder.join("bank/bank.toml")).expect("it is there");
    put(&folder, "bank/ch1/._chapter.toml.Ab12.part", "left");
    vibank(&["new", "bank", &bank]).ends(0);
    assert_eq!(all(&folder.join("bank")).len(), 3);
    fs::remove_file(folder.join("bank/bank.toml")).expect("it is there");
    put(
        &folder,
        "bank/ch1/block-on-a-spring.toml",
        format!("{item}# mine\n"),
    );
    vibank(&["new", "bank", &bank])
        .ends(2)
        .complains("exists already");
}

#[test]
fn what_an_interrupted_run_has_left_is_removed() {
    let desk = plain("left-over");
    let out = &desk.out;
    fs::create_dir_all(out.join("sheets")).expect("a folder");
    put(&out.join("form"), ".3PZ-HEN-YFB.html.y.part", "left");
    let left = [
        ".manifest.json.AbC123.part",
        ".sheets.html.part",
        "sheets/.3PZ-HEN-YFB.html.x.part",
    ];
    for name in left {
        put(out, name, "left");
    }
    fs::remove_file(out.join("sheets.html")).expect("it is there");
    desk.sheet(&desk.plan("seed = 3\nvariants = 2"), &[])
        .ends(0);
    desk.grade(&[]).ends(0);
    let marks = [".details.csv.17-3.part", "feedback/.x.html.y.part"];
    for name in marks {
        put(&out.join("marks"), name, "left");
    }
    desk.grade(&[]).ends(0);
    desk.run(&["form", &desk.path("manifest.json")]).ends(0);
    let hidden = |path: &PathBuf| {
        let name = path.file_name().expect("it has a name").to_string_lossy();
        name.starts_with('.')
    };
    let found: Vec<PathBuf> = all(out).into_iter().filter(hidden).collect();
    assert!(found.is_empty(), "{found:?}");
}

#[cfg(unix)]
#[test]
fn a_secret_that_others_can_read_is_a_warning() {
    use std::os::unix::fs::PermissionsExt;

    let desk = Desk::new("open-secret");
    desk.secret();
    let plan = desk.plan("secret = 'exam.key'\nvariants = 2");
    let key = desk.folder.join("exam.key");
    let set = |mode| fs::set_permissions(&key, fs::Permissions::from_mode(mode)).unwrap();
    set(0o644);
    let out = text_of(&desk.folder.join("out"));
    let ran = small(&["sheet", &plan, "--out", &out]).ends(0);
    ran.complains("others can read the secret")
        .complains("chmod 600");
    set(0o600);
    let ran = small(&["sheet", &plan, "--out", &out]).ends(0);
    assert!(!ran.err.contains("others"), "{}", ran.err);
}
