//! A campaign of typed answers: to a part of each kind, from the corpora on, and numbers that are spelt anew.
//!
//! What has to hold: nothing panics; no response of 4,000 bytes takes more than 20 ms; the echo of what is typed does not
//! depend on the key; what was read, written and read again has the same verdict, but for the last of several sides; a
//! right number is right in every spelling and every kind that can hold it, and a wrong one is not.

use std::collections::HashSet;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use vibank::answer::{Doubt, Remark, Slip, Verdict};
use vibank::bank::Catalogue;
use vibank::grade::{echo, mark};
use vibank::instance::Instance;
use vibank::solution::Solution;

use crate::generate::Stream;

const ITEM: &str = include_str!("../../tests/fixtures/kinds/item.toml");
const CORPORA: [&str; 4] = [
    include_str!("../../tests/corpora/typed.tsv"),
    include_str!("../../tests/corpora/numbers.tsv"),
    include_str!("../../tests/corpora/readings.tsv"),
    include_str!("../../tests/corpora/equations.tsv"),
];

/// The same questions with other keys.
const CHANGES: [(&str, &str); 8] = [
    ("\"R + 4[ohm]*i\"", "\"5*R - 7[ohm]*i\""),
    ("key  = \"2\"", "key  = \"5000\""),
    ("\"sqrt(k/m - (c/(2*m))^2)\"", "\"2*sqrt(k/m)\""),
    ("\"[[2*k, -k], [-k, 2*k]]\"", "\"[[3*k, 0*k], [0*k, k]]\""),
    ("*cos(omega_n*t)\"", "*sin(omega_n*t)\""),
    ("\"[1, 1]\"", "\"[1, -3]\""),
    ("\"sqrt(k/m)\"", "\"1000*sqrt(k/m)\""),
    ("+ 1/2*k*(x2 - x1)^2", "+ 3/2*k*(x2 - x1)^2"),
];

/// No response takes longer.
const BOUND: Duration = Duration::from_millis(20);
/// One response in so many is echoed with both keys.
const ECHOED: u64 = 4;
/// Different findings after which a kind is left.
const MAX_FINDINGS: usize = 20;

/// What people type into answers of all kinds.
const PIECES: &[&str] = &[
    "0", "1", "2", "5", "9", "10", "3.14", "0,5", "1,250", "1e3", "·10^3", "·10-3", "×10⁻³", "e-3", ".", ",", ";", " ",
    "  ", "\u{a0}", "\t", "\n", "+", "-", "−", "—", "±", "*", "·", "×", "/", "÷", "^", "²", "³", "⁻¹", "√", "sqrt(",
    "(", ")", "[", "]", "{", "}", "|", "=", "≈", "<", "≤", ">=", "≠", "~", "'", "''", "\"", "°", "%", "$", "\\", "\\frac{",
    "\\sqrt{", "\\left(", "\\right)", "\\cdot ", "\\mathrm{", "\\omega", "\\SI{5}{m}", "\\boxed{", "rad/s", "Hz", "m", "kg",
    "N/m", "ohm", "mm", "deg", "s", "k", "c", "t", "x1", "x2''", "x1'", "mu", "omega_n", "ω", "π", "pi", "i", "j", "e",
    "sin ", "cos(", "exp(", "ln", "max(", "and", "or", "et", "ou", "inf", "∞", "∪", "∈", "∠", "cis", "under", "a", "b",
    "[[", "]]", "x_1", "ẋ", "𝑘", "½", "\u{feff}", "\u{202e}", "é", "王",
];

struct Questions {
    own: Solution<'static>,
    generous: Solution<'static>,
    other: Solution<'static>,
}

fn solution(item: &str) -> Solution<'static> {
    let (catalogue, findings) = Catalogue::load([
        ("bank.toml", "format = 1\ntitle = 'Kinds'\n"),
        ("kinds/_chapter.toml", "title = 'Kinds'\n"),
        ("kinds/item.toml", item),
    ]);
    let catalogue: &'static Catalogue = Box::leak(Box::new(catalogue));
    let item = catalogue.items().next().unwrap_or_else(|| panic!("{findings:?}"));
    Solution::of(Instance::of_source(item))
}

/// What came of the responses to a part.
#[derive(Default)]
struct Tally {
    inputs: u64,
    verdicts: [u64; 5],
    spelt: u64,
    echoed: u64,
    slowest: Duration,
    findings: usize,
}

/// Runs so many responses to each part with this name, or to all; whether nothing was found. `keep` takes what was found.
pub fn run(
    part: Option<&str>,
    count: u64,
    seconds: u64,
    seed: u64,
    used: fn() -> Duration,
    keep: fn(&str, &[u8]),
) -> bool {
    let changed = CHANGES.iter().fold(ITEM.to_owned(), |item, (old, new)| {
        assert!(item.contains(old), "{old}");
        item.replacen(old, new, 1)
    });
    let questions = Questions {
        own: solution(ITEM),
        generous: solution(ITEM).settling(Doubt::Benefit),
        other: solution(&changed),
    };
    let parts = &questions.own.template().parts;
    let mut is_clean = true;
    for (place, own) in parts.iter().enumerate() {
        if part.is_some_and(|part| part != own.id) {
            continue;
        }
        let before = resident();
        let start = used();
        let tally = of_part(&questions, place, count, seconds, seed, used, keep);
        println!(
            "{}: {} responses ({} of them spelt anew, {} echoed with two keys) in {:.0} s of processor time: {} right, {} partial, {} wrong, {} unreadable, {} missing; slowest {:.1} ms, memory {} to {} MB, {} findings (seed {seed})",
            own.id,
            tally.inputs,
            tally.spelt,
            tally.echoed,
            (used() - start).as_secs_f64(),
            tally.verdicts[0],
            tally.verdicts[1],
            tally.verdicts[2],
            tally.verdicts[3],
            tally.verdicts[4],
            tally.slowest.as_secs_f64() * 1e3,
            before,
            resident(),
            tally.findings,
        );
        is_clean &= tally.findings == 0;
    }
    is_clean
}

fn of_part(
    questions: &Questions,
    place: usize,
    count: u64,
    seconds: u64,
    seed: u64,
    used: fn() -> Duration,
    keep: fn(&str, &[u8]),
) -> Tally {
    let id = questions.own.template().parts[place].id.as_str();
    let (mut stream, mut tally) = (Stream::of(seed ^ (place as u64) << 32), Tally::default());
    let pool = pool();
    let own = pool_of(id);
    let mut known = HashSet::new();
    let start = used();
    while tally.inputs < count && tally.findings < MAX_FINDINGS {
        // The clock is looked at now and then only.
        if tally.inputs % 1024 == 0 && used() - start > Duration::from_secs(seconds) {
            break;
        }
        tally.inputs += 1;
        let spelt = (stream.draw() % 3 == 0).then(|| spelt(id, &mut stream)).flatten();
        let (typed, due) = match spelt {
            Some((typed, is_right)) => {
                tally.spelt += 1;
                (typed, Some(is_right))
            }
            None => (mutated(if stream.draw() % 2 == 0 { &own } else { &pool }, &mut stream), None),
        };
        let is_echoed = tally.inputs % ECHOED == 0;
        tally.echoed += u64::from(is_echoed);
        let began = Instant::now();
        let outcome = catch_unwind(AssertUnwindSafe(|| mark(&questions.own, place, &typed).verdict));
        let mut took = began.elapsed();
        if took > BOUND / 10 {
            // The clock counts what others do, too.
            took = (0..3).map(|_| taken(questions, place, &typed, used)).min().unwrap_or(took);
        }
        tally.slowest = tally.slowest.max(took);
        let found = match outcome {
            Err(_) => Some("it panics".to_owned()),
            Ok(verdict) => {
                tally.verdicts[verdict as usize] += 1;
                let rest = catch_unwind(AssertUnwindSafe(|| {
                    check(questions, place, &typed, due, is_echoed)
                }));
                let rest = rest.unwrap_or_else(|_| Some("it panics".to_owned()));
                rest.or_else(|| (took > BOUND).then(|| "it is slow".to_owned()))
            }
        };
        if let Some(found) = found
            && known.insert(found.chars().take(24).collect::<String>() + &shape(&typed))
        {
            tally.findings += 1;
            eprintln!("{id}: {found}: {typed:?}");
            keep(&format!("typed-{id}"), typed.as_bytes());
        }
    }
    tally
}

/// What of a response makes two findings alike: signs, with letters and digits as one each.
fn shape(typed: &str) -> String {
    let mut shape: Vec<char> = Vec::new();
    for char in typed.chars().take(24) {
        let kind = match char {
            '0'..='9' => '0',
            'a'..='z' | 'A'..='Z' => 'a',
            char => char,
        };
        if shape.last() != Some(&kind) {
            shape.push(kind);
        }
    }
    shape.into_iter().collect()
}

fn taken(questions: &Questions, place: usize, typed: &str, used: fn() -> Duration) -> Duration {
    let began = used();
    let _ = catch_unwind(AssertUnwindSafe(|| mark(&questions.own, place, typed)));
    used() - began
}

/// What does not hold of a response.
fn check(
    questions: &Questions,
    place: usize,
    typed: &str,
    due: Option<bool>,
    is_echoed: bool,
) -> Option<String> {
    if let Some(is_right) = due {
        let verdict = mark(&questions.generous, place, typed).verdict;
        if (verdict == Verdict::Right) != is_right {
            return Some(format!("{verdict:?}, which should be {is_right}"));
        }
    }
    if !is_echoed {
        return None;
    }
    let of = |solution| echo(solution, place, typed).map(|echo| (echo.reading.text, echo.other));
    let (one, two) = (of(&questions.own), of(&questions.other));
    if one != two {
        return Some(format!("the echo tells of the key: {one:?} and {two:?}"));
    }
    let first = mark(&questions.own, place, typed);
    // The echo of a chain is its last side, which may be right where another one is not.
    let is_unequal = |remark: &Remark| *remark == Remark::Slip(Slip::UnequalSides);
    if first.remarks.iter().any(is_unequal) {
        return None;
    }
    let text = &first.reading.as_ref()?.text;
    let again = mark(&questions.own, place, text);
    let is_same = again.reading.is_none() || again.verdict == first.verdict;
    (!is_same).then(|| format!("{:?}, but its echo {text:?} is {:?}", first.verdict, again.verdict))
}

/// All responses of the corpora.
fn pool() -> Vec<String> {
    let lines = CORPORA.into_iter().flat_map(str::lines);
    let lines = lines.filter(|line| !line.starts_with('#'));
    let last = lines.filter_map(|line| line.rsplit('\t').next());
    last.map(|response| response.replace("\\n", "\n")).collect()
}

/// Those to a part.
fn pool_of(id: &str) -> Vec<String> {
    let lines = CORPORA[0].lines().filter(|line| line.split('\t').next() == Some(id));
    let last = lines.filter_map(|line| line.rsplit('\t').next());
    let mut pool: Vec<String> = last.map(|response| response.replace("\\n", "\n")).collect();
    if pool.is_empty() {
        pool.push(String::new());
    }
    pool
}

fn below(stream: &mut Stream, count: usize) -> usize {
    (stream.draw() % count.max(1) as u64) as usize
}

fn pick<'a, T: ?Sized>(stream: &mut Stream, from: &[&'a T]) -> &'a T {
    from[below(stream, from.len())]
}

/// A response of the pool with pieces put in, taken out, doubled or joined to another one.
fn mutated(pool: &[String], stream: &mut Stream) -> String {
    let mut typed: Vec<char> = pool[below(stream, pool.len())].chars().collect();
    for _ in 0..stream.draw() % 4 {
        let at = below(stream, typed.len() + 1);
        match stream.draw() % 6 {
            0 | 1 => drop(typed.splice(at..at, pick(stream, PIECES).chars())),
            2 => {
                let end = (at + 1 + below(stream, 6)).min(typed.len());
                typed.drain(at..end);
            }
            3 => {
                let end = (at + 1).min(typed.len());
                typed.splice(at..end, pick(stream, PIECES).chars());
            }
            4 => {
                let other: Vec<char> = pool[below(stream, pool.len())].chars().collect();
                let from = below(stream, other.len() + 1);
                typed.truncate(at);
                typed.extend_from_slice(&other[from..]);
            }
            // The same many times: depth and length.
            _ => {
                let end = (at + 1 + below(stream, 12)).min(typed.len());
                let piece: Vec<char> = typed[at..end].to_vec();
                let most = if stream.draw() % 64 == 0 { 400 } else { 8 };
                let times = below(stream, most);
                typed.splice(at..at, piece.repeat(times));
            }
        }
    }
    let mut typed: String = typed.into_iter().collect();
    let mut end = typed.len().min(4000);
    while !typed.is_char_boundary(end) {
        end -= 1;
    }
    typed.truncate(end);
    typed
}

/// A number in one of its spellings, right or wrong, as a response to a part that can hold it.
fn spelt(id: &str, stream: &mut Stream) -> Option<(String, bool)> {
    const RATES: [&str; 9] =
        ["", " rad/s", "rad/s", " rad s^-1", " rad·s⁻¹", " 1/s", " s^-1", " \\mathrm{rad/s}", " rad/sec"];
    let is_right = stream.draw() % 2 == 0;
    let factor = if is_right { 1.0 } else { [1.09, 0.5, -1.0, 10.0, 0.1][below(stream, 5)] };
    let mut of = |value: f64| number(value * factor, stream);
    let typed = match id {
        "omega_n" => {
            let number = of(5.0);
            let unit = pick(stream, &RATES);
            let before = pick(stream, &["", "= ", "≈ ", "omega_n = ", "ω_n = ", "\\omega_n="]);
            framed(format!("{before}{number}{unit}"), stream)
        }
        "both" => {
            let (one, two) = (of(5.0), of(8.660_254));
            let unit = pick(stream, &RATES);
            let parting = pick(stream, &["; ", ";", " ; ", " and ", "\n"]);
            format!("{one}{unit}{parting}{two}{unit}")
        }
        "Z" => {
            let (re, im) = (of(3.0), of(4.0));
            let im = im.trim_start_matches('+').to_owned();
            let (sign, im) = match im.strip_prefix(['-', '−']) {
                Some(im) => ("-", im.to_owned()),
                None => ("+", im),
            };
            let i = pick(stream, &["i", "j", "*i", " i", "·i"]);
            let unit = pick(stream, &["", " ohm", " Ω", " Ohm"]);
            if unit.is_empty() {
                format!("{re} {sign} {im}{i}")
            } else {
                format!("({re} {sign} {im}{i}){unit}")
            }
        }
        "u1" => {
            let one = number(1.0, stream);
            let two = number(factor, stream);
            pick(stream, &["[A, B]", "(A; B)", "A; B", "[A; B]"]).replace('A', &one).replace('B', &two)
        }
        _ => return None,
    };
    Some((typed, is_right))
}

/// In a frame that says nothing.
fn framed(typed: String, stream: &mut Stream) -> String {
    match stream.draw() % 8 {
        0 => format!("${typed}$"),
        1 => format!(" {typed} "),
        2 => format!("{typed}\n"),
        _ => typed,
    }
}

/// A number in one of the spellings that people use.
fn number(value: f64, stream: &mut Stream) -> String {
    let power = (stream.draw() % 5) as i32 - 2;
    let has_power = stream.draw() % 3 == 0;
    let scaled = if has_power { value / 10_f64.powi(power) } else { value };
    // Neither three decimals, which may be thousands after a comma, nor fewer figures than four.
    let mut digits = format!("{scaled:.7}");
    while digits.ends_with('0') {
        digits.pop();
    }
    while digits.rsplit('.').next().is_some_and(|decimals| decimals.len() == 3) {
        digits.push('0');
    }
    let mut digits = digits.trim_end_matches('.').to_owned();
    if stream.draw() % 3 == 0 {
        digits = digits.replace('.', ",");
    }
    let sign = pick(stream, &["-", "−", "–"]);
    digits = digits.replace('-', sign);
    if stream.draw() % 8 == 0 && value > 0.0 {
        digits.insert(0, '+');
    }
    if !has_power {
        return digits;
    }
    let raised: String = power
        .to_string()
        .chars()
        .map(|char| match char {
            '-' => '⁻',
            '1' => '¹',
            '2' => '²',
            _ => '⁰',
        })
        .collect();
    match stream.draw() % 8 {
        0 => format!("{digits}e{power}"),
        1 => format!("{digits}E{power}"),
        2 => format!("{digits}*10^{power}"),
        3 => format!("{digits}·10^({power})"),
        4 => format!("{digits} x 10^{power}"),
        5 => format!("{digits}·10{raised}"),
        6 => format!("{digits}\\cdot 10^{{{power}}}"),
        _ => format!("{digits}×10**{power}"),
    }
}

/// Resident memory in megabytes, where the system tells.
fn resident() -> u64 {
    let told = std::fs::read_to_string("/proc/self/statm").ok();
    let pages = told.and_then(|told| told.split_whitespace().nth(1)?.parse::<u64>().ok());
    pages.unwrap_or(0) * 4096 / 1_000_000
}
