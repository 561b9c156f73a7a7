//! Drawing an instance under its constraints, and judging whether it can be handed out.

use divan::{Bencher, black_box};
use vibank::bank::{Catalogue, embedded};
use vibank::instance::Instance;
use vibank::seed::Seed;
use vibank::solution::Solution;
use vibank::suitability;

fn main() {
    divan::main();
}

/// One draw, for some items.
const ITEMS: [&str; 4] = [
    "ch2/e8-springs-parallel-series",
    "ch3/e4-underdamped-response",
    "ch4/p1-rolling-disk-hub-moment",
    "ch5/e5-coupled-pendulums-modes",
];

#[divan::bench(args = ITEMS)]
fn draw(bencher: Bencher, item: &str) {
    let (catalogue, _) = Catalogue::load(embedded());
    let Some(template) = catalogue.find(item) else {
        return;
    };
    let mut seed = 0;
    bencher.bench_local(|| {
        seed += 1;
        Instance::draw(template, black_box(Seed::new(seed))).map(|instance| instance.redraws())
    });
}

/// A draw and the judgement of all its parts: what choosing a seed costs.
#[divan::bench(args = ITEMS)]
fn choose(bencher: Bencher, item: &str) {
    let (catalogue, _) = Catalogue::load(embedded());
    let Some(template) = catalogue.find(item) else {
        return;
    };
    let parts: Vec<usize> = (0..template.parts.len()).collect();
    let mut seed = 0;
    bencher.bench_local(|| {
        seed += 1;
        let instance = Instance::draw(template, black_box(Seed::new(seed))).ok()?;
        suitability::judge(&Solution::of(instance), &parts).ok()
    });
}
