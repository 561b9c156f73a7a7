//! Marking one response, with the solution and its tolerance at hand and without.

use divan::{Bencher, black_box};
use vibank::bank::{Catalogue, embedded};
use vibank::grade;
use vibank::instance::Instance;
use vibank::solution::Solution;

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

/// One response of each other kind, to parts of the bank.
#[divan::bench(args = [
    ("ch4/p1-rolling-disk-hub-moment", "eom", "3/2*m*x'' + b*x' + 11/2*k*x = -M0/r*sin(Omega*t)"),
    ("ch2/t2-pendulum-exact-period", "T0", "2 s"),
])]
fn other(bencher: Bencher, (item, part, response): (&str, &str, &str)) {
    let (catalogue, _) = Catalogue::load(embedded());
    let Some(template) = catalogue.find(item) else {
        return;
    };
    let Some(place) = template.parts.iter().position(|found| found.id == part) else {
        return;
    };
    let solution = Solution::of(Instance::of_source(template));
    let _ = solution.marker(place);
    bencher.bench_local(|| grade::mark(&solution, place, black_box(response)).verdict);
}
