//! Drawing a sheet of one item, and writing it: its question, its key, its worked solution.

use divan::{Bencher, black_box};
use vibank::bank::{Catalogue, embedded};
use vibank::output::{self, PageKind, Pages, Run};
use vibank::source::Source;
use vibank::worksheet::{Blueprint, Plan, Sheet};

fn main() {
    divan::main();
}

const ITEMS: [&str; 4] = [
    "ch2/e8-springs-parallel-series",
    "ch3/e4-underdamped-response",
    "ch4/p1-rolling-disk-hub-moment",
    "ch5/e5-coupled-pendulums-modes",
];

/// A sheet of one item.
fn blueprint(item: &str) -> Blueprint {
    let text = format!("title = \"T\"\nseed = 1\nvariants = 1\n[[question]]\nitem = \"{item}\"\n");
    Blueprint::read(&Source::new("bench.toml", text)).expect("it is sound")
}

/// A drawn variant.
fn draw<'a>(plan: &Plan<'a>, index: u64) -> Sheet<'a> {
    let variant = plan.variant(black_box(index), 0);
    Sheet::draw(plan, variant, None).expect("the item can be drawn")
}

/// Writes sheets of one item that are drawn.
fn page(bencher: Bencher, item: &str, kind: PageKind, format: &str) {
    let (catalogue, _) = Catalogue::load(embedded());
    let blueprint = blueprint(item);
    let plan = Plan::of(&blueprint, &catalogue, None).expect("the item is there");
    let writer = output::writer(format).expect("the format is there");
    let pages =
        Pages::new(writer, Run::of(&blueprint, writer), &[]).expect("the layouts are sound");
    let mut index = 0;
    bencher
        .with_inputs(|| {
            index += 1;
            draw(&plan, index)
        })
        .bench_local_values(|sheet| {
            let page = pages.page(kind, &sheet).expect("the sheet can be written");
            (page.text.len(), sheet)
        });
}

/// Draws sheets of one item.
#[divan::bench(args = ITEMS)]
fn drawn(bencher: Bencher, item: &str) {
    let (catalogue, _) = Catalogue::load(embedded());
    let blueprint = blueprint(item);
    let plan = Plan::of(&blueprint, &catalogue, None).expect("the item is there");
    let mut index = 0;
    bencher.bench_local(|| {
        index += 1;
        draw(&plan, index)
    });
}

#[divan::bench(args = ITEMS)]
fn question_as_html(bencher: Bencher, item: &str) {
    page(bencher, item, PageKind::Sheet, "html");
}

#[divan::bench(args = ITEMS)]
fn key_as_html(bencher: Bencher, item: &str) {
    page(bencher, item, PageKind::Key, "html");
}

#[divan::bench(args = ITEMS)]
fn solution_as_html(bencher: Bencher, item: &str) {
    page(bencher, item, PageKind::Solutions, "html");
}

#[divan::bench(args = ITEMS)]
fn question_as_markdown(bencher: Bencher, item: &str) {
    page(bencher, item, PageKind::Sheet, "md");
}
