//! Runs targets on a stable toolchain, or writes their seeds for `cargo fuzz`.
//!
//! ```sh
//! campaign seeds [TARGET]
//! campaign run TARGET|all [--seconds N | --inputs N] [--seed N]
//! campaign typed [PART] [--count N] [--seconds N] [--seed N]
//! campaign again TARGET FILE…
//! ```
//!
//! Seconds are those of the processor; a number of inputs makes the same run on every machine. A run ends with 1 where an oracle does not hold; the input stands in `findings/TARGET/`, and `again` runs it.

use std::collections::HashSet;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::{Arc, LazyLock, Mutex, PoisonError};
use std::time::{Duration, Instant};

use vibank_fuzz::generate::{Stream, input};
use vibank_fuzz::{seeds, targets, typed};

/// Findings after which a target is left.
const MAX_FINDINGS: usize = 20;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let option = |name: &str, usual: u64| {
        let at = words.iter().position(|word| *word == name);
        let value = at.and_then(|at| words.get(at + 1)?.parse().ok());
        value.unwrap_or(usual)
    };
    let (seconds, seed) = (option("--seconds", 15), option("--seed", 1));
    let extent = match option("--inputs", 0) {
        0 => Extent::Seconds(seconds),
        inputs => Extent::Inputs(inputs),
    };
    match words.as_slice() {
        ["seeds", rest @ ..] => {
            let chosen = |name: &&&str| rest.is_empty() || rest.contains(*name);
            targets::NAMES.iter().filter(chosen).for_each(|name| write_seeds(name));
            ExitCode::SUCCESS
        }
        ["run", "all", ..] => {
            let clean = targets::NAMES.map(|name| run(name, extent, seed));
            ExitCode::from(u8::from(clean.contains(&false)))
        }
        ["run", target, ..] if targets::NAMES.contains(target) => {
            ExitCode::from(u8::from(!run(target, extent, seed)))
        }
        ["typed", rest @ ..] => {
            let part = rest.first().copied().filter(|word| !word.starts_with("--"));
            let count = option("--count", 1_000_000);
            let keep = |target: &str, bytes: &[u8]| {
                let name = bytes.iter().fold(0_u64, |name, byte| name.wrapping_mul(31) + u64::from(*byte));
                write(&folder("findings", target), &format!("{name:016x}"), bytes);
            };
            let seconds = option("--seconds", u64::MAX);
            ExitCode::from(u8::from(!typed::run(part, count, seconds, seed, used, keep)))
        }
        ["again", target, paths @ ..] if !paths.is_empty() => {
            // What all inputs share is made once, and does not count.
            targets::run(target, b"");
            for path in paths {
                let bytes = fs::read(path).unwrap_or_default();
                let start = used();
                let seen = targets::run(target, &bytes);
                println!("{path}: saw {seen:016x} in {:?}", used() - start);
            }
            ExitCode::SUCCESS
        }
        _ => {
            eprintln!("campaign seeds | run TARGET|all [--seconds N | --inputs N] [--seed N] | typed [PART] [--count N] [--seconds N] [--seed N] | again TARGET FILE…");
            eprintln!("targets: {}", targets::NAMES.join(", "));
            ExitCode::from(2)
        }
    }
}

/// Processor time of this thread, where the system tells; else what the clock says since the first call. On a busy machine
/// the clock alone would call everything slow.
fn used() -> Duration {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    let told = fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = told.and_then(|told| told.split_whitespace().next()?.parse().ok());
    nanoseconds.map_or_else(|| START.elapsed(), Duration::from_nanos)
}

fn folder(name: &str, target: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name).join(target)
}

fn write(folder: &Path, name: &str, bytes: &[u8]) {
    let written = fs::create_dir_all(folder).and_then(|()| fs::write(folder.join(name), bytes));
    if let Err(error) = written {
        eprintln!("cannot write to `{}`: {error}", folder.display());
    }
}

fn write_seeds(target: &str) {
    let folder = folder("corpus", target);
    for (number, bytes) in seeds::of(target).iter().enumerate() {
        write(&folder, &format!("seed-{number:05}"), bytes);
    }
}

/// How far a run goes beyond the seeds, all of which it runs.
#[derive(Clone, Copy)]
enum Extent {
    /// Of the processor.
    Seconds(u64),
    Inputs(u64),
}

/// An input that runs, and since when.
type Running = Mutex<Option<(Instant, Vec<u8>)>>;

/// Ends the program at an input that does not come to an end, and keeps the input: a missing bound of work would
/// otherwise only show as a run that never reports.
struct Watch(Arc<Running>);

impl Watch {
    /// Longer than any input takes on a machine a hundred times as slow.
    const LONGEST: Duration = Duration::from_secs(120);

    fn over(target: &str) -> Self {
        let (running, target) = (Arc::new(Running::default()), target.to_owned());
        let seen = Arc::downgrade(&running);
        std::thread::spawn(move || {
            while let Some(running) = seen.upgrade() {
                Self::check(&running, &target);
                drop(running);
                std::thread::sleep(Duration::from_secs(1));
            }
        });
        Self(running)
    }

    fn begin(&self, bytes: &[u8]) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Some((Instant::now(), bytes.to_vec()));
    }

    fn check(running: &Running, target: &str) {
        let running = running.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((begin, bytes)) = &*running
            && begin.elapsed() > Self::LONGEST
        {
            write(&folder("findings", target), "endless", bytes);
            let longest = Self::LONGEST.as_secs();
            eprintln!("{target}: an input takes more than {longest} s; it stands in `findings/{target}/endless`");
            std::process::exit(1);
        }
    }
}

/// Runs a target; whether nothing was found.
fn run(target: &str, extent: Extent, seed: u64) -> bool {
    let mut pool = seeds::of(target);
    let (given, mut stream) = (pool.len(), Stream::of(seed));
    let mut seen = HashSet::new();
    let (mut inputs, mut findings, mut slowest) = (0_u64, 0, Duration::ZERO);
    let mut messages = HashSet::new();
    targets::run(target, b"");
    let watch = Watch::over(target);
    let start = used();
    let goes_on = |inputs: u64| match extent {
        Extent::Seconds(seconds) => used() - start < Duration::from_secs(seconds),
        Extent::Inputs(most) => inputs - (given as u64) < most,
    };
    while findings < MAX_FINDINGS && (inputs < given as u64 || goes_on(inputs)) {
        let bytes = match pool.get(inputs as usize).filter(|_| inputs < given as u64) {
            Some(seed) => seed.clone(),
            None => input(&pool, &mut stream),
        };
        inputs += 1;
        watch.begin(&bytes);
        let begin = used();
        let outcome = catch_unwind(AssertUnwindSafe(|| targets::run(target, &bytes)));
        let took = used() - begin;
        if took > slowest {
            slowest = took;
            // Not a finding by itself, since machines differ: to be looked at.
            if took > Duration::from_secs(2) {
                write(&folder("slow", target), &format!("{}ms-{inputs}", took.as_millis()), &bytes);
            }
        }
        match outcome {
            Ok(what) => {
                if seen.insert(what) && inputs > given as u64 {
                    pool.push(bytes);
                }
            }
            Err(panic) => {
                let words = panic.downcast_ref::<String>().cloned();
                let words = words.or_else(|| panic.downcast_ref::<&str>().map(|text| (*text).to_owned()));
                let words: String = words.unwrap_or_default().chars().take(80).collect();
                if messages.insert(words) {
                    findings += 1;
                    write(&folder("findings", target), &format!("{seed}-{inputs}"), &bytes);
                }
            }
        }
    }
    println!(
        "{target}: {inputs} inputs from {given} seeds in {:.0} s of processor time, {} kinds of outcome, slowest {:.2} s, {findings} findings (seed {seed})",
        (used() - start).as_secs_f64(),
        seen.len(),
        slowest.as_secs_f64(),
    );
    findings == 0
}
