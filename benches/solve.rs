//! Drawing an item and solving it: all numeric keys, one key, no key at all.

use divan::{Bencher, black_box};
use vibank::bank::{Catalogue, Template, embedded};
use vibank::instance::Instance;
use vibank::quantity::NodeId;
use vibank::seed::Seed;

fn main() {
    divan::main();
}

const ITEMS: [&str; 4] = [
    "ch2/e8-springs-parallel-series",
    "ch3/e4-underdamped-response",
    "ch4/p1-rolling-disk-hub-moment",
    "ch5/e5-coupled-pendulums-modes",
];

/// The formulas of the numeric keys of an item.
fn keys(template: &Template) -> Vec<NodeId> {
    let numeric = template
        .parts
        .iter()
        .filter(|part| part.answer.kind().name() == "numeric");
    numeric.flat_map(|part| part.answer.keys()).collect()
}

fn solve(bencher: Bencher, item: &str, some: impl Fn(Vec<NodeId>) -> Vec<NodeId>) {
    let (catalogue, _) = Catalogue::load(embedded());
    let Some(template) = catalogue.find(item) else {
        return;
    };
    let keys = some(keys(template));
    let mut seed = 0;
    bencher.bench_local(|| {
        seed += 1;
        let instance = Instance::draw(template, black_box(Seed::new(seed))).ok()?;
        let evaluation = instance.evaluation();
        Some(
            keys.iter()
                .filter(|key| evaluation.value(**key).is_ok())
                .count(),
        )
    });
}

#[divan::bench(args = ITEMS)]
fn all_numeric_keys(bencher: Bencher, item: &str) {
    solve(bencher, item, |keys| keys);
}

/// The same with one key asked for: what skipping saves.
#[divan::bench(args = ITEMS)]
fn one_key(bencher: Bencher, item: &str) {
    solve(bencher, item, |keys| keys.into_iter().take(1).collect());
}

#[divan::bench(args = ITEMS)]
fn no_key(bencher: Bencher, item: &str) {
    solve(bencher, item, |_| Vec::new());
}
