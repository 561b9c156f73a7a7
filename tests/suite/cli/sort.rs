//! `vibank sort`, with a reader of scans that is played by a script, and the marks that sheets have for it.

use std::path::Path;

use vibank::seed::Variant;
use vibank::worksheet::ScanMark;

use super::press::with_press;
use super::{BANK, Ran, blueprint, content, folder, put, run_with, small, text_of};

/// The code of the only sheet of a run in `folder/out`.
fn run(folder: &Path, top: &str) -> String {
    let plan = put(folder, "test.toml", blueprint(top));
    let out = folder.join("out");
    small(&["sheet", &plan, "--out", &text_of(&out)]).ends(0);
    let manifest: serde_json::Value =
        serde_json::from_str(&content(out.join("manifest.json"))).expect("it is JSON");
    let code = manifest["variants"][0]["code"].as_str();
    code.expect("it has a code").to_owned()
}

/// What the reader says of a page of the sheet with this code.
fn said(code: &str, page: u8, is_last: bool) -> String {
    let variant: Variant = code.parse().expect("it is a code");
    let mark = ScanMark {
        variant,
        page,
        is_last,
    };
    let digits: String = mark
        .bytes()
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect();
    format!("mark {digits}")
}

/// Sorts scans, of which a script says these lines.
#[cfg(unix)]
fn sort(folder: &Path, lines: &[String], arguments: &[&str]) -> Ran {
    use std::os::unix::fs::PermissionsExt as _;
    let mut script = format!(
        "#!/bin/sh\necho 'vibank-scan {}'\n[ $# = 0 ] && exit\n",
        env!("CARGO_PKG_VERSION")
    );
    for (number, line) in lines.iter().enumerate() {
        script.push_str(&format!("echo '{number} {line}'\n"));
    }
    let reader = put(folder, "reader", script);
    let executable = std::fs::Permissions::from_mode(0o755);
    std::fs::set_permissions(&reader, executable).expect("it is our file");
    let scans = folder.join("scans");
    for number in 0..lines.len() {
        put(&scans, &format!("s{number}.png"), format!("scan {number}"));
    }
    let (scans, out) = (text_of(&scans), text_of(&folder.join("sorted")));
    let arguments = [&["sort", &scans, "--out", &out], arguments].concat();
    run_with(&[("VIBANK_SCAN", &reader)], &arguments)
}

#[test]
#[cfg(unix)]
fn scans_are_copied_to_the_sheets_of_students() {
    let folder = folder("sort");
    put(&folder, "class.csv", "id,name\ns1,Müller Anna\ns2,Ngo\n");
    let top = "seed = 1\nstudents = \"class.csv\"\nscan_marks = true\nformats = [\"html\"]";
    let code = run(&folder, top);
    let other = Variant::new(77).expect("it is in range").to_string();
    let lines = [
        said(&code, 2, true),
        said(&code, 1, false),
        "none".to_owned(),
        said(&code, 2, true),
        said(&other, 1, true),
        "unreadable it is too large".to_owned(),
    ];
    let manifest = text_of(&folder.join("out"));
    sort(&folder, &lines, &["--manifest", &manifest])
        .ends(1)
        .says("s2.png: no mark was found; it is unsorted/0003-s2.png")
        .says("page 2 of 001-s1-Müller-Anna once more")
        .says(&format!("{other} is not a sheet of this run"))
        .says("s5.png: it is too large")
        .says("no page of 1 sheet:\n  002-s2-Ngo");
    let sorted = folder.join("sorted");
    for (file, scan) in [
        ("001-s1-Müller-Anna/page-01.png", 1),
        ("001-s1-Müller-Anna/page-02.png", 0),
        ("001-s1-Müller-Anna/page-02-2.png", 3),
        (&format!("foreign/{other}/page-01.png"), 4),
        ("unsorted/0003-s2.png", 2),
        ("unsorted/0006-s5.png", 5),
    ] {
        assert_eq!(content(sorted.join(file)), format!("scan {scan}"), "{file}");
    }
    // What is there is never written over.
    sort(&folder, &lines, &[])
        .ends(2)
        .complains("there is something in");
}

#[test]
#[cfg(unix)]
fn a_reader_that_fails_on_a_scan_goes_on_after_it() {
    let folder = folder("sort-failing");
    let code = Variant::new(5).expect("it is in range").to_string();
    let line = said(&code, 1, true);
    // Of four scans it says one, then of the two that are left the first again.
    let script_lines = [line.clone()];
    for number in 1..4 {
        put(&folder.join("scans"), &format!("s{number}.png"), "scan");
    }
    sort(&folder, &script_lines, &[])
        .ends(1)
        .says("s1.png: its reader failed")
        .says("s3.png: its reader failed")
        .says("s2.png: page 1 of");
}

#[test]
fn without_a_reader_it_says_how_to_come_to_one() {
    let folder = folder("sort-without");
    let scan = put(&folder, "s.png", "scan");
    let out = text_of(&folder.join("sorted"));
    run_with(&[("VIBANK_SCAN", "")], &["sort", &scan, "--out", &out])
        .ends(2)
        .complains("cargo build --release -p vibank-scan");
    assert!(!folder.join("sorted").exists());
    run_with(&[("VIBANK_SCAN", "")], &["sort", "nowhere.png"])
        .ends(2)
        .complains("nowhere.png");
    let empty = text_of(&super::folder("sort-empty"));
    run_with(&[("VIBANK_SCAN", "")], &["sort", &empty])
        .ends(2)
        .complains("there is no image in");
}

#[test]
fn sheets_have_marks_where_they_are_asked_for() {
    let folder = folder("scan-marks");
    let page = |name: &str, switch: &str| {
        let top = format!("seed = 1\nvariants = 1\n{switch}\nformats = [\"html\", \"pdf\"]");
        let plan = put(&folder, &format!("{name}.toml"), blueprint(&top));
        let out = folder.join(name);
        let arguments = ["sheet", &plan, "--out", &text_of(&out), "--bank", BANK];
        with_press("echoes", &arguments).ends(0);
        let sheet = std::fs::read_dir(out.join("sheets"))
            .expect("it is there")
            .map(|entry| entry.expect("it can be listed").path())
            .find(|path| path.extension().is_some_and(|ending| ending == "pdf"));
        let html = content(out.join("sheets.html"));
        let others = content(out.join("solutions.html")) + &content(out.join("keys.html"));
        (html, content(sheet.expect("there is a sheet")), others)
    };
    let (html, pdf, others) = page("with", "scan_marks = true");
    assert_eq!(html.matches("data:image/svg+xml").count(), 2);
    assert_eq!(pdf.matches("#show: scan-marks.with(").count(), 1);
    assert!(!others.contains("svg+xml"), "answers are not sorted");
    let (bare, bare_pdf, _) = page("without", "");
    assert_eq!(page("off", "scan_marks = false").0, bare);
    assert!(!bare.contains("svg+xml") && !bare_pdf.contains("scan-marks"));
}
