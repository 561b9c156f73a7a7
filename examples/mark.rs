//! Marks answers to a part of an item, as students type them.
//!
//! cargo run --example mark

use std::error::Error;
use std::io::{self, Write};

use vibank::bank::{Catalogue, embedded};
use vibank::grade;
use vibank::instance::Instance;
use vibank::message::Language;
use vibank::solution::Solution;

fn main() -> Result<(), Box<dyn Error>> {
    let (bank, _) = Catalogue::load(embedded());
    let item = bank
        .find("ch2/e8-springs-parallel-series")
        .ok_or("the bank has the item")?;
    let part = item
        .parts
        .iter()
        .position(|part| part.has_id("k_par"))
        .ok_or("the item has the part")?;
    // The data of the source; `Instance::draw` draws others from a seed.
    let solution = Solution::of(Instance::of_source(item));

    let mut out = io::stdout().lock();
    for response in [
        "k2 + k1",
        r"\frac{k_1 k_2}{k_1 + k_2}",
        "k1 + k2 N/m",
        "k1 +",
    ] {
        let marking = grade::mark(&solution, part, response);
        writeln!(out, "{response}: {}", marking.verdict.name())?;
        if !marking.remarks.is_empty() {
            for remark in grade::remarks(&solution, part, &marking, Language::English) {
                writeln!(out, "    {}", remark.plain())?;
            }
        }
    }
    Ok(())
}
