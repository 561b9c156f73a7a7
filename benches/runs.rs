//! Whole runs: sheets of five questions as HTML with keys, and the marking of all their answers, beside what the machine
//! cannot do without: the bytes copied in memory, the JSON read, and one exponential with a sine and a cosine.
//!
//! Processor time of the children of this process, as Linux counts it: in hundredths of a second.
#![allow(
    clippy::disallowed_methods,
    clippy::print_stdout,
    reason = "a bench reads clocks and files, and prints what it found"
)]

use std::collections::BTreeMap;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Instant;

/// Sheets of a run: enough that a hundredth of a second is little beside it.
const SHEETS: usize = 300;
/// Ticks of the clock of Linux in a second.
const TICKS: f64 = 100.0;
/// One answer in so many is that of the next sheet.
const STRAY: usize = 5;

type Failed = Box<dyn std::error::Error>;

fn main() -> Result<(), Failed> {
    if of_children().is_none() {
        println!("skipped: this system does not count processor time as Linux does");
        return Ok(());
    }
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("bench-runs");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder)?;
    println!("exp with sine and cosine: {:.1} ns", yardstick() * 1e9);

    let html = run(&folder, "html", "formats = [\"html\"]\nsolutions = false")?;
    let out = folder.join("html");
    let bytes: Vec<u8> = ["sheets.html", "keys.html", "key-table.html"]
        .iter()
        .map(|name| std::fs::read(out.join(name)))
        .collect::<Result<Vec<_>, _>>()?
        .concat();
    let floor = best(|| black_box(bytes.clone()).len());
    print_row(
        "a sheet of five questions as HTML with its key",
        html,
        floor,
    );
    println!(
        "    its {:.0} kB copied in memory",
        bytes.len() as f64 / 1e3 / SHEETS as f64
    );

    run(&folder, "json", "formats = [\"json\"]\nsolutions = false")?;
    let keys = keys(&folder.join("json/sheets.jsonl"))?;
    for (name, stray) in [("right answers", usize::MAX), ("one in five astray", STRAY)] {
        let form = filled(&out.join("responses.csv"), &keys, stray)?;
        let responses = folder.join("responses.csv");
        std::fs::write(&responses, &form)?;
        let marks = folder.join("marks");
        let _ = std::fs::remove_dir_all(&marks);
        let manifest = out.join("manifest.json");
        let paths = [&manifest, &responses, &marks].map(|path| path.to_string_lossy().into_owned());
        let [manifest_path, responses_path, marks_path] = &paths;
        let marked = vibank(&[
            "grade",
            manifest_path,
            responses_path,
            "--out",
            marks_path,
            "--no-feedback",
        ])?;
        let manifest = std::fs::read_to_string(&manifest)?;
        let floor = best(|| {
            let read: serde_json::Value = serde_json::from_str(&manifest).unwrap_or_default();
            black_box(read).is_object()
        });
        let parts = keys.len() / SHEETS;
        print_row(&format!("a student's {parts} parts, {name}"), marked, floor);
    }
    println!("    their part of the manifest read as JSON");
    Ok(())
}

/// Prints what a sheet of a run took, and how often that is the floor.
fn print_row(what: &str, run: f64, floor: f64) {
    let each = |seconds: f64| seconds / SHEETS as f64;
    println!(
        "{what}: {:.2} ms, {:.0} times the floor of {:.1} µs",
        each(run) * 1e3,
        run / floor,
        each(floor) * 1e6
    );
}

/// Makes the sheets of the midterm in one way; the processor time that it took.
fn run(folder: &Path, name: &str, top: &str) -> Result<f64, Failed> {
    let midterm = include_str!("../examples/midterm.toml");
    let count = format!("variants = {SHEETS}\n{top}");
    let blueprint = folder.join(format!("{name}.toml"));
    std::fs::write(&blueprint, midterm.replace("variants = 4", &count))?;
    let out = folder.join(name);
    let [blueprint, out] = [blueprint, out].map(|path| path.to_string_lossy().into_owned());
    vibank(&["sheet", &blueprint, "--out", &out])
}

/// Runs the program on one thread; the processor time that it took.
fn vibank(arguments: &[&str]) -> Result<f64, Failed> {
    let before = of_children().unwrap_or_default();
    let ran = Command::new(env!("CARGO_BIN_EXE_vibank"))
        .args(arguments)
        .env("RAYON_NUM_THREADS", "1")
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()?;
    if !ran.success() {
        return Err(format!("`{}` ended with {ran}", arguments.join(" ")).into());
    }
    Ok(of_children().unwrap_or_default() - before)
}

/// The printed keys, by code, question and letter.
fn keys(sheets: &Path) -> Result<BTreeMap<[String; 3], String>, Failed> {
    let mut keys = BTreeMap::new();
    for line in std::fs::read_to_string(sheets)?.lines() {
        let sheet: serde_json::Value = serde_json::from_str(line)?;
        let text = |value: &serde_json::Value| value.as_str().unwrap_or_default().to_owned();
        for question in sheet["questions"].as_array().into_iter().flatten() {
            for part in question["parts"].as_array().into_iter().flatten() {
                let place = [
                    text(&sheet["code"]),
                    question["number"].to_string(),
                    text(&part["letter"]),
                ];
                keys.insert(place, text(&part["key"]["printed"]));
            }
        }
    }
    Ok(keys)
}

/// The form with an answer in each row: that of the sheet, or one in `stray` that of the next one.
fn filled(
    form: &Path,
    keys: &BTreeMap<[String; 3], String>,
    stray: usize,
) -> Result<String, Failed> {
    let form = std::fs::read_to_string(form)?;
    let (head, rows) = form.split_once('\n').ok_or("the form is empty")?;
    let rows: Vec<&str> = rows.lines().collect();
    let place = |row: &str| {
        let cells: Vec<&str> = row.split(',').collect();
        [cells[0], cells[2], cells[3]].map(str::to_owned)
    };
    let parts = keys.len() / SHEETS;
    let mut filled = format!("{head}\n");
    for (number, row) in rows.iter().enumerate() {
        let is_stray = number % stray == stray - 1;
        let of = if is_stray { number + parts } else { number };
        let key = keys.get(&place(rows[of % rows.len()]));
        let key = key.map_or("", String::as_str).replace('"', "\"\"");
        filled.push_str(&format!("{row}\"{key}\"\n"));
    }
    Ok(filled)
}

/// Processor time of all children so far, in seconds.
fn of_children() -> Option<f64> {
    let stat = std::fs::read_to_string("/proc/self/stat").ok()?;
    // The name of the program stands in brackets, and may hold spaces.
    let (_, fields) = stat.rsplit_once(')')?;
    let mut times = fields.split_whitespace().skip(13);
    let mut time = || times.next()?.parse::<f64>().ok();
    Some((time()? + time()?) / TICKS)
}

/// The least time of a task in ten tries, in seconds.
fn best<T>(mut task: impl FnMut() -> T) -> f64 {
    let tries = (0..10).map(|_| {
        let start = Instant::now();
        black_box(task());
        start.elapsed().as_secs_f64()
    });
    tries.fold(f64::INFINITY, f64::min)
}

/// The time of one exponential with a sine and a cosine.
fn yardstick() -> f64 {
    const COUNT: u32 = 100_000;
    let all = || {
        (0..COUNT).fold(0.0, |sum, place| {
            let x = 0.5 + f64::from(place) * 1e-5;
            sum + black_box(libm::exp(black_box(x))) + black_box(libm::sincos(black_box(x)).0)
        })
    };
    best(all) / f64::from(COUNT)
}
