//! Solves a damped oscillator in closed form and plots its motion as SVG on standard output.
//!
//! cargo run --example oscillator > oscillator.svg

use std::error::Error;
use std::io::{self, Write};

use vibank::figure::plot::{Axis, Course, Curve, CurveStyle, Plot, Spacing};
use vibank::math::symbol;
use vibank::message::Language;
use vibank::unit::{DecimalMark, Unit};
use vibank::vibration::{FreeResponse, Oscillator, State};

fn axis(name: &str, unit: &str) -> Result<Axis, vibank::unit::Error> {
    Ok(Axis {
        label: symbol(name),
        unit: Unit::parse(unit)?,
        is_logarithmic: false,
        spacing: Spacing::Round,
        range: None,
    })
}

fn main() -> Result<(), Box<dyn Error>> {
    // 2 kg on a spring of 50 N/m with a dashpot of 3 N·s/m, released 10 cm from equilibrium.
    let oscillator = Oscillator::new(2.0, 3.0, 50.0)?;
    let released = State {
        position: 0.1,
        velocity: 0.0,
    };
    let motion = FreeResponse::of(&oscillator, released);

    let curve = Curve {
        course: Course::Graph(Box::new(|time| Some(100.0 * motion.position(time)))),
        label: None,
        style: CurveStyle::Solid,
    };
    let plot = Plot {
        x: axis("t", "s")?,
        y: axis("x", "cm")?,
        range: [0.0, 6.0],
        curves: vec![curve],
        marks: Vec::new(),
        decimal: DecimalMark::Point,
    };
    let picture = plot.draw()?;
    let svg = picture.svg("oscillator", &Language::English);
    writeln!(io::stdout(), "{svg}")?;
    Ok(())
}
