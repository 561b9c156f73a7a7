//! Drawing the schematic of an item as SVG, its places computed for the data.

use divan::{Bencher, black_box};
use vibank::bank::{Catalogue, embedded};
use vibank::instance::Instance;
use vibank::scene::{Data, Scene};
use vibank::seed::Seed;
use vibank::solution::Solution;

fn main() {
    divan::main();
}

/// From a block on a spring to the fullest drawings of the bank.
const ITEMS: [&str; 6] = [
    "ch2/t1-stiffness-from-period",
    "ch2/p2-centre-pinned-bar-cable",
    "ch2/p5-stepped-disk-two-springs",
    "ch4/p1-rolling-disk-hub-moment",
    "ch5/e4-coupled-pendulums-general",
    "ch5/p1-stepped-disk-two-blocks",
];

#[divan::bench(args = ITEMS)]
fn schematic(bencher: Bencher, item: &str) {
    let (catalogue, _) = Catalogue::load(embedded());
    let Some(template) = catalogue.find(item) else {
        return;
    };
    let Ok(instance) = Instance::draw(template, Seed::new(1)) else {
        return;
    };
    let solution = Solution::of(instance);
    let scene = Scene::of(&solution, Data::Both);
    bencher.bench_local(|| black_box(&scene).picture().map(|picture| picture.svg.len()));
}
