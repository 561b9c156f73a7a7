//! Any text as a response to a part of every kind: marked without a panic and without delay.
//!
//! ```sh
//! cargo +nightly fuzz run response -- -max_len=400 -max_total_time=600
//! ```

#![no_main]

use libfuzzer_sys::fuzz_target;
use vibank::bank::Catalogue;
use vibank::grade::Grade;
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
        let item = catalogue.items().next();
        Solution::of(Instance::of_source(
            item.unwrap_or_else(|| panic!("{findings:?}")),
        ))
    };
}

fuzz_target!(|text: &str| {
    SOLUTION.with(|solution| {
        let places = 0..solution.template().parts.len();
        // Among each other, and as follow-through of those before.
        Grade::mark(solution, places.map(|place| (place, text)));
    });
});
