//! The examples of the library print what is known otherwise.

use std::path::Path;
use std::process::Command;

/// What an example prints; it stands beside the programs of this build.
fn printed(name: &str) -> String {
    let program = Path::new(env!("CARGO_BIN_EXE_vibank"));
    let folder = program.parent().expect("it is in a folder");
    let file = format!("{name}{}", std::env::consts::EXE_SUFFIX);
    let ran = Command::new(folder.join("examples").join(file))
        .output()
        .expect("`cargo test` builds the examples");
    assert!(ran.status.success(), "{name}: {ran:?}");
    String::from_utf8(ran.stdout).expect("UTF-8")
}

#[test]
fn a_chain_has_the_frequencies_of_the_textbook() {
    let text = printed("chain");
    for (line, mode) in text.lines().zip(1..) {
        // 2 √(k/m) sin(iπ/(2(n + 1))) for n equal masses between two walls.
        let known = 2.0 * 20.0 * (f64::from(mode) * std::f64::consts::PI / 12.0).sin();
        let start = format!("mode {mode}: {known:8.4} rad/s");
        assert!(line.starts_with(&start), "{line} instead of {start}");
    }
    assert_eq!(text.lines().count(), 5);
}

#[test]
fn a_plot_says_what_it_shows() {
    let svg = printed("oscillator");
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
    assert!(
        svg.contains("10 cm"),
        "it begins where it was released: {svg}"
    );
}

#[test]
fn answers_are_marked() {
    let text = printed("mark");
    let verdicts: Vec<&str> = text
        .lines()
        .filter(|line| !line.starts_with(' '))
        .filter_map(|line| line.rsplit_once(": "))
        .map(|(_, verdict)| verdict)
        .collect();
    assert_eq!(verdicts[..2], ["right", "wrong"], "{text}");
    assert!(text.contains("series"), "the mistake is explained: {text}");
}

#[test]
fn a_bank_of_ones_own_gives_a_sheet_and_its_key() {
    let text = printed("own_bank");
    assert!(
        text.contains("# Quiz") && text.contains("hangs on a spring"),
        "{text}"
    );
    assert!(text.contains(r"\mathrm{rad}"), "{text}");
}
