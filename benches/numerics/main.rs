//! Work against precision: how long our methods and others take, and how far off they are.
//!
//! ```text
//! cargo bench --no-default-features --bench numerics [-- FOLDER]
//! ```
//!
//! writes `results.csv` and one picture for each task to the folder, by default `target/bench-numerics`, and prints a
//! summary in units of the yardstick, one exponential and one pair of sine and cosine.

#![expect(clippy::print_stdout, reason = "a benchmark reports to the terminal")]

mod integrate;
mod measure;
mod modes;
mod oscillator;
mod plot;
mod record;
mod response;

use std::path::{Path, PathBuf};

use record::Record;

/// A task appends its measurements.
type Task = fn(&mut Vec<Record>);

const TASKS: &[Task] = &[
    oscillator::free,
    oscillator::forced,
    oscillator::steady,
    modes::against_size,
    modes::against_stiffness_ratio,
    response::of_ten_masses,
    response::against_time,
];

fn main() -> std::io::Result<()> {
    let folder = std::env::args()
        .skip(1)
        .find(|argument| !argument.starts_with('-'));
    let folder = folder.map_or_else(|| PathBuf::from("target/bench-numerics"), PathBuf::from);
    // The first measurement finds the processor at its idle clock.
    measure::yardstick();
    let before = measure::yardstick();
    let mut records = Vec::new();
    for task in TASKS {
        task(&mut records);
    }
    let after = measure::yardstick();
    write(&folder, &records)?;
    summarize(&records, before, after);
    Ok(())
}

#[expect(
    clippy::disallowed_methods,
    reason = "results are new files that nobody reads meanwhile"
)]
fn write(folder: &Path, records: &[Record]) -> std::io::Result<()> {
    std::fs::create_dir_all(folder)?;
    std::fs::write(folder.join("results.csv"), record::table(records))?;
    let mut tasks: Vec<&str> = records.iter().map(|record| record.task).collect();
    tasks.dedup();
    for task in tasks {
        let of_task: Vec<&Record> = records
            .iter()
            .filter(|record| record.task == task)
            .collect();
        std::fs::write(
            folder.join(format!("{task}.svg")),
            plot::svg(task, &of_task),
        )?;
    }
    Ok(())
}

fn summarize(records: &[Record], before: f64, after: f64) {
    println!("yardstick Y: {before:.1} ns before, {after:.1} ns after");
    println!(
        "{:<22} {:<26} {:<26} {:>7} {:>12} {:>10} {:>9}",
        "task", "case", "method", "tol", "ns", "Y", "error"
    );
    for record in records {
        let tolerance = record
            .tolerance
            .map_or(String::new(), |tolerance| format!("{tolerance:.0e}"));
        println!(
            "{:<22} {:<26} {:<26} {tolerance:>7} {:>12.1} {:>10.1} {:>9.1e}",
            record.task,
            record.case,
            record.method,
            record.timing.fast,
            record.timing.fast / before,
            record.scaled_error
        );
    }
}
