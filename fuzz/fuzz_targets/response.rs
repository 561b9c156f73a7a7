//! Any text as a response to a part of every kind: marked without a panic and without delay.
//!
//!     cargo +nightly fuzz run response fuzz/corpus/response

#![no_main]

use libfuzzer_sys::fuzz_target;
use vibank::bank::Catalogue;
use vibank::grade::mark_among;
use vibank::instance::Instance;
use vibank::solution::Solution;

thread_local! {
    static SOLUTION: Solution<'static> = {
        let (catalogue, findings) = Catalogue::load([
            ("bank.toml", "format = 1\ntitle = 'Fuzz'\n"),
            ("kinds/_chapter.toml", "title = 'Kinds'\n"),
            (
                "kinds/item.toml",
                include_str!("../../tests/fixtures/kinds/item.toml"),
            ),
        ]);
        let catalogue: &'static Catalogue = Box::leak(Box::new(catalogue));
        let item = catalogue.items().first();
        Solution::of(Instance::of_source(
            item.unwrap_or_else(|| panic!("{findings:?}")),
        ))
    };
}

fuzz_target!(|text: &str| {
    SOLUTION.with(|solution| {
        let responses = vec![text; solution.template().parts.len()];
        for place in 0..responses.len() {
            mark_among(solution, place, &responses);
        }
    });
});
