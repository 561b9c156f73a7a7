//! Plots: from an instance to SVG, by what they show.

use divan::{Bencher, black_box};
use vibank::bank::{Catalogue, embedded};
use vibank::instance::Instance;
use vibank::message::Language;
use vibank::scene::{Data, Scene};
use vibank::solution::Solution;

fn main() {
    divan::main();
}

const PLOTS: [(&str, &str); 6] = [
    ("ch3/e4-underdamped-response", "decay"),
    ("ch3/t2-pick-the-regime", "regimes"),
    ("ch3/p3-two-springs-coulomb", "decay"),
    ("ch4/e2-amplitude-resonance", "resonance"),
    ("ch5/p4-table-block-pulley-hanging-block", "motion"),
    ("ch5/p4-table-block-pulley-hanging-block", "modes"),
];

/// Evaluates, samples, lays out and writes a plot; the solution of its item is at hand.
#[divan::bench(args = PLOTS)]
fn plot_as_svg(bencher: Bencher, (item, plot): (&str, &str)) {
    let (catalogue, _) = Catalogue::load(embedded());
    let template = catalogue.find(item).expect("the item is there");
    let solution = Solution::of(Instance::of_source(template));
    let scene = Scene::of(&solution, Data::Both);
    bencher.bench_local(|| {
        let picture = scene.plot(black_box(plot)).ok()?;
        Some(picture.svg("p", &Language::English).len())
    });
}
