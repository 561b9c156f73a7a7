//! Loading a bank: reading, checking and compiling its items.

use divan::{Bencher, black_box};
use vibank::bank::{Catalogue, embedded};

/// That of the program: much of loading is small pieces.
#[cfg(feature = "cli")]
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() {
    divan::main();
}

/// The bank that comes with the program; the report is per item.
#[divan::bench(sample_count = 20)]
fn whole_bank(bencher: Bencher) {
    let items = Catalogue::load(embedded()).0.items().count();
    bencher
        .counter(divan::counter::ItemsCount::new(items))
        .bench(|| Catalogue::load(black_box(embedded())));
}

/// One small item with the files that a bank has to have.
#[divan::bench]
fn one_small_item() -> usize {
    let (catalogue, _) = Catalogue::load(black_box([
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
    ]));
    catalogue.items().count()
}
