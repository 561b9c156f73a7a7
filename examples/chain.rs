//! Natural frequencies and mode shapes of a chain of five masses between two walls.
//!
//! cargo run --example chain

use std::error::Error;
use std::io::{self, Write};

use vibank::vibration::modes::{Link, Modes};

fn main() -> Result<(), Box<dyn Error>> {
    const MASSES: [f64; 5] = [2.0; 5];
    const STIFFNESS: f64 = 800.0;

    let walls = [Link::to_ground(1, STIFFNESS), Link::to_ground(5, STIFFNESS)];
    let between = (1..5).map(|mass| Link::between(mass, mass + 1, STIFFNESS));
    let springs: Vec<Link> = walls.into_iter().chain(between).collect();
    let modes = Modes::of_network(&MASSES, &springs)?;

    let mut out = io::stdout().lock();
    for mode in 0..modes.count() {
        let frequency = modes
            .natural_angular_frequency(mode)
            .ok_or("a chain of springs is stable")?;
        write!(out, "mode {}: {frequency:8.4} rad/s ", mode + 1)?;
        for displacement in modes.mode_shape(mode) {
            write!(out, " {displacement:7.4}")?;
        }
        writeln!(out)?;
    }
    Ok(())
}
