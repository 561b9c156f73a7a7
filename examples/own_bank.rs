//! Makes a sheet in Markdown from a bank of one's own, with its key.
//!
//! cargo run --example own_bank

use std::error::Error;
use std::io::{self, Write};

use vibank::bank::Catalogue;
use vibank::output::{self, PageKind, Pages, Run};
use vibank::source::Source;
use vibank::worksheet::{Blueprint, Plan, Sheet};

const ITEM: &str = r#"
[item]
title  = "Natural frequency"
source = "by hand"

[parameters]
m = { name = "mass", value = "2 kg", range = "1 .. 5 kg", step = "0.1 kg" }
k = { name = "stiffness", value = "800 N/m", range = "200 .. 900 N/m", step = "10 N/m" }

[statement]
text = "A block of mass << m.given >> hangs on a spring of stiffness << k.given >>."

[[part]]
id   = "omega_n"
key  = "sqrt(k/m)"
unit = "rad/s"
ask  = "Find its natural angular frequency."
"#;

fn main() -> Result<(), Box<dyn Error>> {
    let (bank, findings) = Catalogue::load([
        ("bank.toml", "format = 1\ntitle = 'My bank'\n"),
        ("free/_chapter.toml", "title = 'Free vibration'\n"),
        ("free/block.toml", ITEM),
    ]);
    for finding in findings {
        writeln!(io::stderr(), "{}", finding.message)?;
    }
    let text = "title = 'Quiz'\nseed = 7\nvariants = 1\n[[question]]\nitem = 'free/block'\n";
    let blueprint = Blueprint::read(&Source::new("quiz.toml", text)).map_err(|_| "a blueprint")?;
    let plan = Plan::of(&blueprint, &bank, None).map_err(|_| "a plan")?;
    let sheet = Sheet::draw(&plan, plan.variant(0, 0), None)?;

    let writer = output::writer("md").ok_or("a format")?;
    let pages = Pages::new(writer, Run::of(&blueprint, writer), &[])?;
    for kind in [PageKind::Sheet, PageKind::Key] {
        writeln!(io::stdout(), "{}", pages.page(kind, &sheet)?.text)?;
    }
    Ok(())
}
