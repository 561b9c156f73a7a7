//! Marking one response, with the solution and its tolerance at hand and without.

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use vibank::answer::{Key, KeyValue};
use vibank::bank::{Catalogue, Part, embedded};
use vibank::grade;
use vibank::instance::Instance;
use vibank::solution::{Session, Solution};

fn main() {
    divan::main();
}

const RESPONSES: [&str; 5] = ["20 rad/s", "3,18 Hz", "1.6e-2 m", "twenty", "20 Hz"];

fn small() -> Catalogue {
    let files = [
        (
            "bank.toml",
            include_str!("../tests/fixtures/bank/bank.toml"),
        ),
        (
            "free/_chapter.toml",
            include_str!("../tests/fixtures/bank/free/_chapter.toml"),
        ),
        (
            "free/spring-mass.toml",
            include_str!("../tests/fixtures/bank/free/spring-mass.toml"),
        ),
    ];
    Catalogue::load(files).0
}

/// A numeric response to a part whose key is prepared.
#[divan::bench(args = RESPONSES)]
fn numeric(bencher: Bencher, response: &str) {
    let catalogue = small();
    let template = catalogue.find("free/spring-mass").expect("the item loads");
    let solution = Solution::of(Instance::of_source(template));
    let _ = solution.marker(0);
    bencher.bench_local(|| grade::mark(&solution, 0, black_box(response)).verdict);
}

/// The same with drawing, solving and the derivation of the tolerance.
#[divan::bench]
fn numeric_from_the_data() -> vibank::answer::Verdict {
    use std::sync::LazyLock;
    static CATALOGUE: LazyLock<Catalogue> = LazyLock::new(small);
    let template = CATALOGUE.find("free/spring-mass").expect("the item loads");
    let solution = Solution::of(Instance::of_source(black_box(template)));
    grade::mark(&solution, 0, "20 rad/s").verdict
}

/// Responses of other kinds, to parts of the bank whose keys are prepared: right ones, and wrong ones with what is said.
#[divan::bench(args = [
    ("ch2/p1-pinned-bar-block", "omega_d", "sqrt(3*k/(2*m) - (3*c/(20*m))^2)"),
    ("ch2/e8-springs-parallel-series", "k_par", "k1 + k2"),
    ("ch4/p1-rolling-disk-hub-moment", "eom", "3/2*m*x'' + b*x' + 11/2*k*x = -M0/r*sin(Omega*t)"),
    ("ch4/p1-rolling-disk-hub-moment", "eom", "m*x'' + b*x' + 11/2*k*x = -M0/r*sin(Omega*t)"),
    ("ch5/e1-elastic-coupling", "eom1", "m1*x1'' + alpha1*x1' + (k1 + kc)*x1 = kc*x2"),
])]
fn other(bencher: Bencher, (item, part, response): (&str, &str, &str)) {
    let (catalogue, _) = Catalogue::load(embedded());
    let template = catalogue.find(item).expect("an item of the bank");
    let Some(place) = template.parts.iter().position(|found| found.has_id(part)) else {
        return;
    };
    let solution = Solution::of(Instance::of_source(template));
    let _ = solution.marker(place);
    bencher.bench_local(|| grade::mark(&solution, place, black_box(response)).verdict);
}

/// A formula with radicals over a small item.
#[divan::bench(args = [
    "sqrt(4*k*m - c^2)/(2*m)",
    "sqrt(k/m)*sqrt(1 - c^2/(4*k*m))",
    "sqrt(k/m - (c/m)^2)",
    "k1 - k1^2/(k1 + k2)",
])]
fn formula(bencher: Bencher, response: &str) {
    let item = "[item]\ntitle = 'T'\nsource = 'by hand'\n[parameters]\nm = '2 kg'\nk = '800 N/m'\nc = '4 N s/m'\nk1 = '100 N/m'\nk2 = '150 N/m'\n[statement]\ntext = 'T'\n[[part]]\nid = 'p'\nkind = 'formula'\nkey = 'sqrt(k/m - (c/(2*m))^2)'\nask = 'Find it.'\n";
    let (catalogue, _) = Catalogue::load([
        ("bank.toml", "format = 1\ntitle = 'T'\n"),
        ("c/_chapter.toml", "title = 'C'\n"),
        ("c/a.toml", item),
    ]);
    let solution = Solution::of(Instance::of_source(
        catalogue.find("c/a").expect("the item loads"),
    ));
    let _ = solution.marker(0);
    bencher.bench_local(|| grade::mark(&solution, 0, black_box(response)).verdict);
}

/// The time that the others are measured in: one exponential and one pair of sine and cosine.
#[divan::bench]
fn yardstick(bencher: Bencher) {
    let mut x = 0.5_f64;
    bencher.bench_local(|| {
        x = 0.5 + 1e-3 * (x - x.floor());
        black_box(libm::exp(black_box(x))) + black_box(libm::sincos(black_box(x)).0)
    });
}

/// Responses to all parts of one kind of the whole bank, one request a line as `mark --jsonl` reads them; the keys are
/// prepared by a first round. Items are responses: right ones, or those that test each part, right, at the edge, wrong and
/// unreadable.
#[divan::bench(args = [
    ("numeric", false), ("formula", false), ("equation", false), ("function", false), ("matrix", false),
    ("numeric", true), ("formula", true), ("equation", true), ("function", true), ("matrix", true),
])]
fn stream(bencher: Bencher, (kind, is_mixed): (&str, bool)) {
    let (catalogue, _) = Catalogue::load(embedded());
    let mut lines = Vec::new();
    for template in catalogue.items() {
        let solution = Solution::of(Instance::of_source(template));
        for (place, part) in template.parts.iter().enumerate() {
            if part.answer.kind().name() != kind || !solution.asks(place) {
                continue;
            }
            let Ok(marker) = solution.marker(place) else {
                continue;
            };
            let responses = if is_mixed {
                marker
                    .trials()
                    .into_iter()
                    .map(|trial| trial.response)
                    .collect()
            } else {
                vec![right(part, &marker.key())]
            };
            lines.extend(responses.into_iter().map(|response| {
                let id = template.id.to_string();
                serde_json::json!({ "id": id, "part": part.id, "response": response }).to_string()
            }));
        }
    }
    let mut session = Session::new(&catalogue);
    let mut round = || {
        for line in &lines {
            black_box(grade::request::answer(&mut session, black_box(line)));
        }
    };
    round();
    let count = ItemsCount::new(lines.len());
    bencher.counter(count).bench_local(round);
}

/// The printed key of a part as a response.
fn right(part: &Part, key: &Key) -> String {
    match &key.value {
        KeyValue::Formula { text, .. } => text.clone(),
        KeyValue::Numbers { si, .. } if si.len() == 1 => {
            let unit = part.answer.unit().map(|unit| unit.coherent().to_string());
            format!("{} {}", si[0], unit.unwrap_or_default())
        }
        _ => key.math.plain(),
    }
}
