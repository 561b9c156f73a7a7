//! Work against precision: how long our methods and others take, and how far off they are.
//!
//! ```text
//! cargo bench --bench numerics [-- [--gate] [--bits] [FOLDER]]
//! ```
//!
//! writes `results.csv` and pictures for each task to the folder, by default `target/bench-numerics`, and prints a summary:
//! the yardstick Y, one exponential and one pair of sine and cosine; each method on each case; what each task costs and may
//! cost; methods that are both faster and more accurate than ours. With `--gate`, a cost above its limit or such a method
//! fails the run. With `--bits` it prints the digests of all replies in this build and measures nothing; they have to be
//! those in `tests/fixtures/bits.txt`. `scipy_methods.py` adds the methods of SciPy to a results file.

#![expect(clippy::print_stdout, reason = "a benchmark reports to the terminal")]

#[path = "../../tests/suite/physics/bits.rs"]
mod bits;
#[cfg(feature = "render")]
mod checker;
mod costs;
mod friction;
mod integrate;
mod linearisation;
mod measure;
mod modes;
mod oscillator;
mod pendulum;
mod plot;
mod record;
mod reference;
mod response;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use costs::Cost;
use record::Record;

/// A task appends its measurements.
type Task = fn(&mut Vec<Record>);

const TASKS: &[Task] = &[
    oscillator::free,
    oscillator::forced,
    oscillator::steady,
    oscillator::bandwidth,
    oscillator::decrement,
    friction::from_release_to_rest,
    modes::against_size,
    modes::against_stiffness_ratio,
    response::of_ten_masses,
    response::against_time,
    pendulum::period,
    pendulum::excess,
    pendulum::motion,
    linearisation::of_a_double_pendulum,
    #[cfg(feature = "render")]
    checker::formulas,
];

fn main() -> std::io::Result<ExitCode> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if arguments.iter().any(|argument| argument == "--bits") {
        print!("{}", bits::digests());
        return Ok(ExitCode::SUCCESS);
    }
    let is_gate = arguments.iter().any(|argument| argument == "--gate");
    let folder = arguments.iter().find(|argument| !argument.starts_with('-'));
    let folder = folder.map_or_else(|| PathBuf::from("target/bench-numerics"), PathBuf::from);
    // The first measurement finds the processor at its idle clock.
    measure::yardstick();
    let before = measure::yardstick();
    let costs = costs::measure();
    let middle = measure::yardstick();
    let mut records = Vec::new();
    for task in TASKS {
        task(&mut records);
    }
    let after = measure::yardstick();
    write(&folder, &records)?;
    println!("yardstick Y: {before:.1} ns before, {middle:.1} ns between, {after:.1} ns after");
    summarize(&records);
    let missed = tell_costs(&costs);
    let beaten = tell_better(&records);
    Ok(if is_gate && (missed || beaten) {
        ExitCode::FAILURE
    } else {
        ExitCode::SUCCESS
    })
}

#[expect(
    clippy::disallowed_methods,
    reason = "results are new files that nobody reads meanwhile"
)]
fn write(folder: &Path, records: &[Record]) -> std::io::Result<()> {
    std::fs::create_dir_all(folder)?;
    std::fs::write(folder.join("results.csv"), record::table(records))?;
    let mut tasks: Vec<&str> = records.iter().map(|record| record.task.as_str()).collect();
    tasks.dedup();
    for task in tasks {
        let all: Vec<&Record> = records
            .iter()
            .filter(|record| record.task == task)
            .collect();
        std::fs::write(folder.join(format!("{task}.svg")), plot::work(task, &all))?;
        let sweep: Vec<&Record> = all
            .into_iter()
            .filter(|record| record.parameter.is_some() && record.tolerance.is_none())
            .collect();
        if !sweep.is_empty() {
            let picture = plot::sweep(task, &sweep);
            std::fs::write(folder.join(format!("{task}-sweep.svg")), picture)?;
        }
    }
    Ok(())
}

fn summarize(records: &[Record]) {
    println!(
        "\n{:<30} {:<28} {:<34} {:>6} {:>12} {:>10} {:>9}",
        "task", "case", "method", "tol", "ns", "Y", "error"
    );
    for record in records {
        let tolerance = record
            .tolerance
            .map_or(String::new(), |tolerance| format!("{tolerance:.0e}"));
        println!(
            "{:<30} {:<28} {:<34} {tolerance:>6} {:>12.1} {:>10.1} {:>9.1e}",
            record.task,
            record.case,
            record.method,
            record.timing.fast,
            record.timing.yards,
            record.error.scaled
        );
    }
}

/// Prints the costs; says whether one is above its limit.
fn tell_costs(costs: &[Cost]) -> bool {
    println!("\n{:<50} {:>10} {:>10}", "cost in Y", "found", "limit");
    let mut missed = false;
    for cost in costs {
        let (found, limit) = cost.against_limit();
        let verdict = if found > limit { "above" } else { "" };
        missed |= found > limit;
        println!("{:<50} {found:>10.2} {limit:>10.1} {verdict}", cost.task);
    }
    missed
}

/// Prints the methods that are both faster and more accurate than ours; says whether there is one.
fn tell_better(records: &[Record]) -> bool {
    let better = record::better(records);
    println!("\nfaster and more accurate than ours: {}", better.len());
    for record in &better {
        println!(
            "{} {}: {} ({:.1} ns, {:.1e})",
            record.task, record.case, record.method, record.timing.fast, record.error.scaled
        );
    }
    !better.is_empty()
}
