//! The fuzz campaign of vibank: targets with their oracles, seeds, and a generator for stable toolchains.
//!
//! With `cargo-fuzz` and a nightly toolchain the targets are guided by coverage:
//!
//! ```sh
//! cargo run --release --bin campaign -- seeds      # writes what the repository has into corpus/
//! cargo +nightly fuzz run --features libfuzzer item -- -max_len=20000 -max_total_time=1800
//! ```
//!
//! Without them `campaign` runs the same targets from the same seeds, by mutation and splice from a numbered seed:
//!
//! ```sh
//! cargo run --release --bin campaign -- run all --seconds 15 --seed 1
//! ```

pub mod generate;
pub mod packed;
pub mod seeds;
pub mod targets;
pub mod typed;
