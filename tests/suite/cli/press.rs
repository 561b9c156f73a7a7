//! What a run makes of a press, played by `examples/scripted_press.rs`: one that works, fails, hangs or is missing.

use std::fs;
use std::path::{Path, PathBuf};

use super::desk::all;
use super::{Ran, blueprint, content, folder, put, run_with, text_of};

/// The scripted press, beside the programs of this build.
fn scripted() -> String {
    let program = Path::new(env!("CARGO_BIN_EXE_vibank"));
    let folder = program.parent().expect("it is in a folder");
    let name = format!("scripted_press{}", std::env::consts::EXE_SUFFIX);
    let program = folder.join("examples").join(name);
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/scripted_press.rs");
    let written = |path: &Path| fs::metadata(path).and_then(|found| found.modified()).ok();
    assert!(
        written(&program) >= written(&source),
        "`cargo test` builds the scripted press; where tests are picked by name, \
         `cargo build --example scripted_press` has to come first"
    );
    text_of(&program)
}

/// Runs the program with a press that plays a part.
#[track_caller]
pub(super) fn with_press(script: &str, arguments: &[&str]) -> Ran {
    let press = scripted();
    let variables = [
        ("VIBANK_PRESS", press.as_str()),
        ("VIBANK_SCRIPT", script),
        ("VIBANK_PRESS_SECONDS", "1"),
    ];
    run_with(&variables, arguments)
}

/// A run of the small bank into `folder/out`; the folder, and the arguments.
fn plan(name: &str, top: &str) -> (PathBuf, Vec<String>) {
    let folder = folder(name);
    let plan = put(&folder, "test.toml", blueprint(top));
    let out = text_of(&folder.join("out"));
    let arguments = ["sheet", &plan, "--out", &out, "--bank", super::BANK];
    (folder, arguments.map(str::to_owned).to_vec())
}

fn sheet(script: &str, arguments: &[String]) -> Ran {
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    with_press(script, &arguments)
}

fn sheets(folder: &Path) -> Vec<PathBuf> {
    let listed = fs::read_dir(folder.join("out/sheets"))
        .into_iter()
        .flatten();
    let mut paths: Vec<_> = listed
        .map(|entry| entry.expect("it can be listed").path())
        .collect();
    paths.sort();
    paths
}

const TOP: &str = "seed = 7\nvariants = 5\nformats = [\"html\", \"pdf\"]\nsolutions = false";

#[test]
fn each_sheet_is_printed() {
    let (folder, run) = plan("press-good", TOP);
    sheet("good", &run).ends(0);
    assert_eq!(sheets(&folder).len(), 5);
    assert!(content(&sheets(&folder)[0]).starts_with("%PDF scripted"));
    let manifest = content(folder.join("out/manifest.json"));
    assert!(manifest.contains("\"formats\":[\"html\",\"pdf\"]"));
    assert!(manifest.contains("\"press\":\"scripted good\""));
    sheet("good", &run).ends(0).complains("5 sheets unchanged");
    // Another press prints other bytes: nothing is taken for current.
    let again = sheet("dies", &run).ends(0);
    assert!(!again.err.contains("unchanged"), "{}", again.err);
}

#[test]
fn a_press_that_dies_or_answers_nonsense_once_is_replaced() {
    let (folder, run) = plan("press-dies", TOP);
    sheet("dies", &run).ends(0);
    assert_eq!(sheets(&folder).len(), 5);
}

#[test]
fn sheets_that_cannot_be_printed_are_named_and_the_run_goes_on() {
    for (script, why) in [
        ("refuses", "unknown variable in line 3"),
        ("dies-always", "the press failed twice"),
        ("babbles", "its answer is not a reply"),
        ("hangs", "no answer in"),
    ] {
        let top =
            "seed = 7\nvariants = 1\nformats = [\"html\", \"pdf\"]\nsolutions = false\nkeys = []";
        let (folder, run) = plan(&format!("press-{script}"), top);
        sheet(script, &run)
            .ends(3)
            .complains("could not be printed: ")
            .complains(why);
        assert!(folder.join("out/sheets.html").is_file(), "{script}");
        assert!(folder.join("out/manifest.json").is_file(), "{script}");
        assert!(sheets(&folder).is_empty(), "{script}");
        // With a press that works only what is missing is made.
        sheet("good", &run).ends(0);
        assert_eq!(sheets(&folder).len(), 1, "{script}");
    }
}

#[test]
fn without_a_press_the_other_formats_are_made_and_the_way_out_is_named() {
    for (script, why) in [
        ("old", "it is version 0.0.1, this program"),
        ("foreign", "it speaks protocol 2, this program 1"),
        ("mute", "cannot be used for pdf"),
    ] {
        let (folder, run) = plan(&format!("press-{script}"), TOP);
        sheet(script, &run)
            .ends(3)
            .complains(why)
            .complains("cargo build --release -p vibank-press");
        assert!(folder.join("out/sheets.html").is_file());
        assert!(sheets(&folder).is_empty());
    }
}

#[test]
fn without_formats_pdf_is_made_where_there_is_a_press() {
    let (folder, run) = plan("press-default", "seed = 7\nvariants = 2\nsolutions = false");
    let arguments: Vec<&str> = run.iter().map(String::as_str).collect();
    let bare = run_with(&[("VIBANK_PRESS", "")], &arguments).ends(0);
    bare.complains("for PDF files too, build it by");
    assert!(folder.join("out/sheets.html").is_file());
    sheet("good", &run).ends(0);
    assert_eq!(sheets(&folder).len(), 2);
    // A run without a press deletes no PDF, but says that they are older.
    run_with(&[("VIBANK_PRESS", "")], &arguments)
        .ends(0)
        .complains("of an earlier run were not renewed");
    assert_eq!(sheets(&folder).len(), 2);
}

#[test]
fn parts_of_a_run_need_formats() {
    let (_, run) = plan("press-shards", "seed = 7\nvariants = 2");
    let mut arguments: Vec<&str> = run.iter().map(String::as_str).collect();
    arguments.extend(["--shard", "1/2"]);
    run_with(&[("VIBANK_PRESS", "")], &arguments)
        .ends(2)
        .complains("the parts of a run need `formats` in the blueprint");
}

#[test]
fn parts_of_two_presses_are_not_joined() {
    let (folder, run) = plan("press-parts", TOP);
    let part = |script, part: &str| {
        let more = ["--shard", part].map(str::to_owned);
        sheet(script, &[&run[..], &more].concat())
    };
    part("good", "1/2").ends(0);
    part("another", "2/2").ends(0);
    let split = [&run[..], &["--split".to_owned()]].concat();
    sheet("good", &split).ends(0);
    let manifest = content(folder.join("out/manifest.json"));
    assert!(manifest.contains("scripted good"), "{manifest}");
    let printed: Vec<_> = sheets(&folder)
        .into_iter()
        .filter(|path| path.extension().is_some_and(|end| end == "pdf"))
        .collect();
    assert_eq!(printed.len(), 5);
    for path in printed {
        assert!(content(&path).starts_with("%PDF scripted good"), "{path:?}");
    }
}

#[test]
fn a_press_that_is_exchanged_during_a_run_prints_no_more() {
    let (folder, run) = plan("press-exchanged", TOP);
    sheet("exchanged", &run)
        .ends(3)
        .complains("was exchanged during the run");
    assert!(sheets(&folder).len() < 5);
}

#[test]
fn feedback_as_pdf_needs_a_press() {
    let (folder, run) = plan("press-grade", TOP);
    sheet("good", &run).ends(0);
    let out = folder.join("out");
    let [manifest, responses] =
        ["manifest.json", "responses.csv"].map(|name| text_of(&out.join(name)));
    let grade = [
        "grade",
        &manifest,
        &responses,
        "--feedback",
        "pdf",
        "--bank",
        super::BANK,
    ];
    with_press("good", &grade).ends(0);
    assert_eq!(
        fs::read_dir(out.join("marks/feedback"))
            .into_iter()
            .flatten()
            .count(),
        5
    );
    fs::remove_dir_all(out.join("marks")).expect("it can be removed");
    run_with(&[("VIBANK_PRESS", "")], &grade)
        .ends(3)
        .complains("there is no press here, which prints feedback pages as PDF");
    assert!(out.join("marks/marks.csv").is_file());
}

/// No font has the name: the id stands in its place, one line says whose, and all sheets are made.
#[test]
fn a_name_without_a_font_stops_nothing() {
    let (folder, arguments) = plan(
        "no-font",
        "seed = 7\nstudents = 'class.csv'\nformats = ['pdf']",
    );
    put(
        &folder,
        "class.csv",
        "id,name,group\ns1,王明,\ns2,Zoë,\ns3,Ann,三班\n",
    );
    let fonts = text_of(&folder.join("fonts"));
    fs::create_dir_all(&fonts).expect("a folder");
    let press = scripted();
    let run = |fonts: &str| {
        let variables = [
            ("VIBANK_PRESS", press.as_str()),
            ("VIBANK_SCRIPT", "good"),
            ("VIBANK_FONTS", fonts),
        ];
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        run_with(&variables, &arguments)
    };
    let ran = run(&fonts)
        .ends(0)
        .complains("the id in place of it: s1, s3;");
    assert_eq!(ran.err.matches("no font has").count(), 1, "{}", ran.err);
    assert_eq!(sheets(&folder).len(), 3);
    assert!(!content(folder.join("out/manifest.json")).contains("\"fonts\""));
    let elsewhere = text_of(&folder.join("elsewhere"));
    run(&elsewhere).ends(2).complains("there is no folder");
}

/// What goes to the press becomes the page: with a secret no seed is in it, nor in LaTeX and its figures.
#[test]
fn nothing_that_is_printed_tells_a_seed() {
    let folder = folder("printed-seeds");
    put(&folder, "exam.key", "0123456789abcdef0123456789abcdef");
    let plan = "title = 'T'\nsecret = 'exam.key'\nvariants = 4\nformats = ['pdf', 'tex']\nhints = true\n\
        [[question]]\nitem = 'ch3/e4-underdamped-response'\n\
        [[question]]\nitem = 'ch1/e9-pendulum-equilibrium-stability'\n";
    let plan = put(&folder, "exam.toml", plan);
    let out = folder.join("out");
    with_press(
        "echoes",
        &["sheet", &plan, "--split", "--out", &text_of(&out)],
    )
    .ends(0);
    let manifest = content(out.join("manifest.json"));
    let manifest = serde_json::from_str(&manifest).expect("it is JSON");
    let seeds = super::privacy::seeds(&manifest);
    assert_eq!(seeds.len(), 8);
    let handed_out = ["sheets", "solutions", "figures"].map(|name| all(&out.join(name)));
    let handed_out = handed_out.concat();
    assert!(handed_out.len() > 16, "{handed_out:?}");
    let keys: String = all(&out.join("keys")).iter().map(content).collect();
    for seed in seeds {
        for notation in super::privacy::notations(seed) {
            for path in &handed_out {
                let text = content(path).to_lowercase();
                assert!(!text.contains(&notation), "{}: {notation}", path.display());
            }
        }
        assert!(
            keys.contains(&seed.to_string()),
            "the search does find seeds"
        );
    }
}
