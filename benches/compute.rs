//! What a bare numerical request takes, read and printed: against the yardstick, and its modes against SciPy.
//!
//! ```text
//! cargo bench --bench compute
//! ```
//!
//! The yardstick Y is one exponential and one pair of sine and cosine. SciPy's `eigh` solves the same systems in a process of
//! its own, on one thread, without reading or printing them; where there is no Python with SciPy, a word says so.
//! `PYTHON` names the interpreter. Processor time, since the machine may have others to serve; the allocator of the program.
#![allow(
    clippy::disallowed_methods,
    clippy::print_stdout,
    reason = "a bench reads the clock and its environment, and prints what it finds"
)]

use std::fmt::Write;
use std::hint::black_box;
use std::io::Write as _;
use std::process::{Command, Stdio};
use std::time::Instant;

use vibank::compute::answer;
use vibank::numerics::{exp, sin_cos};

/// That of the program.
#[cfg(feature = "cli")]
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// A request, and how many times it tells the state.
struct Row {
    name: &'static str,
    line: String,
    samples: usize,
    /// In yardsticks or, for modes, times `eigh`.
    limit: f64,
}

fn request(task: &str, parameters: &str) -> String {
    format!(r#"{{"id":1,"task":"{task}","params":{{{parameters}}}}}"#)
}

/// Requests of one state, and of lists of a thousand.
fn small() -> Vec<Row> {
    let times = listed((0..1000).map(|i| format!("{:.2}", f64::from(i) / 100.0)));
    let oscillator = r#""m":1,"c":0.1,"k":4"#;
    let row = |name, task, parameters: String, samples, limit| Row {
        name,
        line: request(task, &parameters),
        samples,
        limit,
    };
    // 3 µs a request and 0.15 µs a sample, where a yardstick takes 20 ns.
    let (each, sample) = (150.0, 7.5);
    vec![
        row(
            "free response",
            "free_response",
            format!(r#"{oscillator},"x0":1,"v0":0,"t":2.5"#),
            1,
            each,
        ),
        row(
            "steady state",
            "steady_amplitude_phase",
            format!(r#"{oscillator},"F0":2,"Omega":1.9"#),
            1,
            each,
        ),
        row(
            "decrement",
            "log_decrement",
            r#""x1":8,"xn1":1,"n":3,"Td":0.5"#.to_owned(),
            1,
            each,
        ),
        row(
            "period of a pendulum",
            "pendulum_period",
            r#""L":1,"g":9.81,"theta0":1.2"#.to_owned(),
            1,
            each,
        ),
        row(
            "dry friction",
            "coulomb_stop",
            r#""m":1,"k":100,"mu":0.2,"g":9.81,"x0":0.3"#.to_owned(),
            1,
            each,
        ),
        row(
            "free response, a sample of 1000",
            "free_response",
            format!(r#"{oscillator},"x0":1,"v0":0,"t":{times}"#),
            1000,
            sample,
        ),
        row(
            "forced response, a sample of 1000",
            "forced_response",
            format!(r#"{oscillator},"F0":1,"Omega":1.5,"x0":1,"v0":0,"t":{times}"#),
            1000,
            sample,
        ),
    ]
}

fn listed(entries: impl Iterator<Item = String>) -> String {
    format!("[{}]", entries.collect::<Vec<_>>().join(","))
}

/// Numbers of three decimals from 1 to 10 that look like data.
fn drawn(i: usize, j: usize) -> f64 {
    let mixed = (i * 7919 + j * 104_729 + 12_345) % 9001;
    1.0 + mixed as f64 / 1000.0
}

/// Systems whose modes are asked for.
fn modes() -> Vec<Row> {
    let chain = |n: usize| {
        let masses = listed((0..n).map(|_| "1".to_owned()));
        let springs = listed((0..n).map(|i| format!("[{i},{},1]", i + 1)));
        format!(r#""masses":{masses},"springs":{springs}"#)
    };
    let dense = |n: usize| {
        let masses = listed((0..n).map(|i| drawn(i, i).to_string()));
        let pairs = (1..=n).flat_map(|i| (0..i).map(move |j| (i, j)));
        let springs = listed(pairs.map(|(i, j)| format!("[{i},{j},{}]", drawn(i, j))));
        format!(r#""masses":{masses},"springs":{springs}"#)
    };
    let matrices = |n: usize| {
        let row = |entry: &dyn Fn(usize) -> f64| listed((0..n).map(|j| entry(j).to_string()));
        let mass = |i: usize| move |j: usize| if i == j { drawn(i, i) } else { 0.0 };
        let stiffness = |i: usize| {
            move |j: usize| {
                if i == j {
                    10.0 * n as f64 + drawn(i, j)
                } else {
                    -drawn(i.max(j), i.min(j))
                }
            }
        };
        let m = listed((0..n).map(|i| row(&mass(i))));
        let k = listed((0..n).map(|i| row(&stiffness(i))));
        format!(r#""M":{m},"K":{k}"#)
    };
    let row = |name, parameters: String, limit| Row {
        name,
        line: request("modes", &parameters),
        samples: 1,
        limit,
    };
    vec![
        row("chain of 50", chain(50), 2.0),
        row("chain of 200", chain(200), 1.5),
        row("dense network of 50", dense(50), 2.0),
        row("dense network of 200", dense(200), 2.0),
        row("matrices of 50", matrices(50), 2.0),
        row("matrices of 200", matrices(200), 2.0),
    ]
}

/// Processor time of this thread in seconds, as Linux counts it, in steps of some milliseconds; time where it does not.
fn spent(start: Instant) -> f64 {
    let counted = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = counted.and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| start.elapsed().as_secs_f64(), |time| time / 1e9)
}

/// Processor time that an operation takes, in seconds, over so many runs that the steps of the clock do not count.
fn mean<T>(mut operation: impl FnMut() -> T, items: usize) -> f64 {
    const LONG_ENOUGH: f64 = 0.4;
    let start = Instant::now();
    let before = spent(start);
    let mut count = 0;
    loop {
        for _ in 0..items {
            black_box(operation());
        }
        count += items;
        let time = spent(start) - before;
        if time > LONG_ENOUGH {
            return time / count as f64;
        }
    }
}

fn yardstick() -> f64 {
    let mut x = 0.0;
    let operation = || {
        x = if x > 100.0 { 0.0 } else { x + 0.37 };
        let (sine, cosine) = sin_cos(black_box(x));
        exp(black_box(-x / 100.0)) + sine + cosine
    };
    mean(operation, 100_000)
}

/// Seconds that SciPy takes for each system, or why there are none.
fn peers(rows: &[Row]) -> Result<Vec<f64>, String> {
    let python = std::env::var("PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let mut child = Command::new(&python)
        .arg(concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/benches/peers/modes.py"
        ))
        .env_remove("OPENBLAS_CORETYPE")
        .env_remove("OPENBLAS_L2_SIZE")
        .env("OPENBLAS_NUM_THREADS", "1")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .map_err(|error| format!("{python}: {error}"))?;
    let mut lines = String::new();
    for row in rows {
        writeln!(lines, "{}", row.line).map_err(|error| error.to_string())?;
    }
    if let Some(mut input) = child.stdin.take() {
        input
            .write_all(lines.as_bytes())
            .map_err(|error| error.to_string())?;
    }
    let output = child
        .wait_with_output()
        .map_err(|error| error.to_string())?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let times: Option<Vec<f64>> = text.lines().map(|line| line.parse().ok()).collect();
    times
        .filter(|times| times.len() == rows.len())
        .ok_or_else(|| text.trim().to_owned())
}

fn main() {
    let yard = yardstick();
    println!("Y = {:.1} ns", yard * 1e9);
    println!("{:<40} {:>10} {:>8} {:>8}", "request", "time", "Y", "limit");
    for row in small() {
        let time = mean(|| answer(&row.line), 1000 / row.samples) / row.samples as f64;
        println!(
            "{:<40} {:>7.3} µs {:>8.1} {:>8.1}",
            row.name,
            time * 1e6,
            time / yard,
            row.limit
        );
    }
    let rows = modes();
    let times: Vec<f64> = rows
        .iter()
        .map(|row| mean(|| answer(&row.line), 1))
        .collect();
    let peers = peers(&rows);
    println!(
        "\n{:<40} {:>10} {:>10} {:>8} {:>8}",
        "modes with shapes", "time", "eigh", "ratio", "limit"
    );
    if let Err(reason) = &peers {
        println!("eigh: skipped, {reason}");
    }
    for (i, (row, time)) in rows.iter().zip(times).enumerate() {
        let peer = peers.as_ref().ok().map(|peers| peers[i]);
        let beside = peer.map_or("-".to_owned(), |peer| format!("{:.3} ms", peer * 1e3));
        let ratio = peer.map_or("-".to_owned(), |peer| format!("{:.2}", time / peer));
        println!(
            "{:<40} {:>7.3} ms {beside:>10} {ratio:>8} {:>8.1}",
            row.name,
            time * 1e3,
            row.limit
        );
    }
}
