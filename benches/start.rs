//! What a command takes from the start of the program to its end, beside the program that prints its version.
//!
//! Processor time of the children of this process, as Linux counts it: in hundredths of a second, so that each command runs
//! often.
#![allow(
    clippy::disallowed_methods,
    clippy::print_stdout,
    reason = "a bench reads what the system counts, and prints it"
)]

use std::process::{Command, Stdio};

/// Runs of each command.
const RUNS: u32 = 50;
/// Ticks of the clock of Linux in a second.
const TICKS: f64 = 100.0;

const COMMANDS: &[&[&str]] = &[
    &["--version"],
    &["show", "ch1/e7-rolling-disk-ke"],
    &["solve", "ch2/e8-springs-parallel-series", "--seed", "7"],
    &["mark", "ch2/e8-springs-parallel-series", "k_par", "k1 + k2"],
    &["list"],
    &["practice", "ch3", "--seed", "1", "--count", "1"],
    &["check", "ch1/e7-rolling-disk-ke", "--seeds", "1"],
    // The same items as a folder: read anew, and with the index that the second run finds.
    &["list", "--bank", "bank", "--no-index"],
    &["list", "--bank", "bank"],
    &["show", "ch1/e7-rolling-disk-ke", "--bank", "bank"],
];

/// Processor time of all children so far, in seconds.
fn of_children() -> Option<f64> {
    let stat = std::fs::read_to_string("/proc/self/stat").ok()?;
    // The name of the program stands in brackets, and may hold spaces.
    let (_, fields) = stat.rsplit_once(')')?;
    let mut times = fields.split_whitespace().skip(13);
    let mut time = || times.next()?.parse::<f64>().ok();
    Some((time()? + time()?) / TICKS)
}

fn main() {
    let Some(mut before) = of_children() else {
        println!("skipped: this system does not count processor time as Linux does");
        return;
    };
    let mut floor = None;
    println!("command: processor time, and beside that of `--version`");
    for arguments in COMMANDS {
        for _ in 0..RUNS {
            let ran = Command::new(env!("CARGO_BIN_EXE_vibank"))
                .args(*arguments)
                .env("VIBANK_CACHE", env!("CARGO_TARGET_TMPDIR"))
                .stdin(Stdio::null())
                .stdout(Stdio::null())
                .stderr(Stdio::null())
                .status();
            if let Err(error) = ran {
                println!("`{}` did not run: {error}", arguments.join(" "));
                return;
            }
        }
        let after = of_children().unwrap_or(before);
        let each = (after - before) / f64::from(RUNS);
        before = after;
        let floor = *floor.get_or_insert(each);
        println!(
            "{:<60} {:6.1} ms {:6.1}",
            arguments.join(" "),
            each * 1e3,
            each / floor
        );
    }
}
