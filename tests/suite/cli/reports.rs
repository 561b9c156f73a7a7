//! Each finding, raised by the fixture that bears its code, with its report as it is printed.

use std::path::Path;

use vibank::diagnostic::codes::PAGES;

use super::{BANK, Ran, content, folder, put, small, text_of, vibank};

/// Codes that no file of a bank can raise by itself.
const WITHOUT_FIXTURE: [(&str, &str); 1] = [(
    "model::equilibrium",
    "a model is linearized when it is asked for; `mechanics::mistakes` raises it",
)];

/// The name of a code in files.
fn file_name(code: &str) -> String {
    code.replace("::", "-")
}

fn fixture(code: &str) -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/fixtures/invalid")
        .join(format!("{}.toml", file_name(code)))
}

/// The report about a fixture that stands in a bank beside a sound item.
fn report(code: &str) -> Ran {
    let name = file_name(code);
    let broken = content(fixture(code));
    let folder = folder(&format!("report-{name}"));
    if code.starts_with("blueprint::") || code.starts_with("marks::") {
        let plan = put(&folder, &format!("{name}.toml"), broken);
        return small(&["sheet", &plan]).ends(2);
    }
    put(&folder, "bank.toml", content(format!("{BANK}/bank.toml")));
    put(
        &folder,
        "free/_chapter.toml",
        content(format!("{BANK}/free/_chapter.toml")),
    );
    put(
        &folder,
        "free/sound.toml",
        content(format!("{BANK}/free/spring-mass.toml")),
    );
    let place = if code == "bank::format" {
        "bank.toml".to_owned()
    } else {
        format!("free/{name}.toml")
    };
    put(&folder, &place, broken);
    let bank = text_of(&folder);
    // Whatever is wrong with one item, the other is served; a bank of another format is not.
    if code != "bank::format" {
        vibank(&["show", "free/sound", "--bank", &bank]).ends(0);
    }
    // Second routes, hints and solutions that are missing are warnings.
    let arguments = [
        "check", "--bank", &bank, "--seeds", "25", "--deny", "warnings",
    ];
    vibank(&arguments).ends(1)
}

#[test]
fn each_code_has_a_fixture_that_raises_it_and_a_report_that_helps() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../../snapshots/reports");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    for page in PAGES {
        let code = page.code.name();
        if WITHOUT_FIXTURE.iter().any(|(without, _)| *without == code) {
            continue;
        }
        let report = report(code).complains(&format!("[{code}]"));
        // The place of a blueprint is reported with the folder in which the test laid it out.
        let tmp = format!(
            "{}/cli/report-{}/",
            env!("CARGO_TARGET_TMPDIR"),
            file_name(code)
        );
        let text = report.err.replace(&tmp, "");
        let text = text.replace(tmp.trim_end_matches('/'), "BANK");
        settings.bind(|| insta::assert_snapshot!(file_name(code), text));
    }
}

#[test]
fn commands_in_the_help_run_as_they_are_pasted() {
    for code in ["check::method-right", "check::routes"] {
        let report = report(code);
        let (_, help) = report
            .err
            .split_once("`vibank ")
            .expect("the help names a command");
        let (command, _) = help.split_once('`').expect("the command ends");
        let words: Vec<&str> = command
            .split('\'')
            .enumerate()
            .flat_map(|(index, piece)| match index % 2 {
                0 => piece.split_whitespace().collect(),
                _ => vec![piece],
            })
            .collect();
        vibank(&words).ends(0);
    }
}

#[test]
fn each_fixture_bears_the_name_of_a_code() {
    let folder = fixture("bank::key");
    let folder = folder.parent().expect("it stands in a folder");
    for entry in std::fs::read_dir(folder).expect("the folder is there") {
        let name = entry.expect("it can be listed").file_name();
        let name = name.to_string_lossy();
        let known = PAGES
            .iter()
            .any(|page| format!("{}.toml", file_name(page.code.name())) == name);
        assert!(known, "`{name}` is named after no code");
    }
}
