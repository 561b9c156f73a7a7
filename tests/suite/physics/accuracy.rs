//! The table of the book's page on accuracy: for each task the worst error on its stress list, and its target.

use std::fmt::Write;

use super::reference::{Accuracy, Row};
use super::{friction, linearisation, modal, modes, oscillator, pendulum};
use crate::generated;
use crate::numerics::double;

/// Where the table stands in the page.
const MARKS: [&str; 2] = ["<!-- accuracy: begin -->\n", "<!-- accuracy: end -->"];

/// A task of the table and what measures it.
type Section = (&'static str, &'static [fn(&mut Accuracy)]);

const SECTIONS: &[Section] = &[
    ("Building blocks", &[double::functions]),
    ("Free response", &[oscillator::free]),
    ("Forced response", &[oscillator::forced]),
    ("Steady state, resonance", &[oscillator::steady]),
    ("Decrement", &[oscillator::decrement]),
    ("Dry friction", &[friction::rest, friction::motion_in_time]),
    (
        "Modes",
        &[
            modes::frequencies,
            modes::rates_of_matrices,
            modes::requests,
            modes::refined_frequencies,
            modes::shapes,
            modes::refined_shapes,
            modes::residuals,
        ],
    ),
    (
        "Several degrees of freedom",
        &[modal::motion, modal::forced_motion, modal::steady],
    ),
    ("Linearisation", &[linearisation::entries]),
    ("Pendulum", &[pendulum::period, pendulum::motion]),
];

/// All rows with the names of their tasks; the tasks are measured side by side.
fn measure() -> Vec<(&'static str, Row)> {
    std::thread::scope(|scope| {
        let running: Vec<_> = SECTIONS
            .iter()
            .map(|(task, measures)| {
                let run = move || {
                    let mut accuracy = Accuracy::default();
                    for measure in *measures {
                        measure(&mut accuracy);
                    }
                    accuracy.rows()
                };
                (*task, scope.spawn(run))
            })
            .collect();
        let rows = running.into_iter().flat_map(|(task, thread)| {
            let rows = thread.join().unwrap_or_else(|_| panic!("{task} panics"));
            rows.into_iter().map(move |row| (task, row))
        });
        rows.collect()
    })
}

/// The table in Markdown.
fn table(rows: &[(&str, Row)]) -> String {
    let mut text = String::from(
        "| task | quantity | cases | worst error | target |\n| --- | --- | ---: | ---: | ---: |\n",
    );
    for (task, row) in rows {
        let name = row.name.replace('|', "\\|");
        writeln!(
            text,
            "| {task} | {name} | {} | {} | {} |",
            row.cases,
            number(row.worst),
            number(row.target)
        )
        .unwrap();
    }
    text
}

/// Numbers of everyday size as they are, others by their power of ten; a quantity that has to be exact has the smallest of
/// all targets.
fn number(x: f64) -> String {
    match x {
        x if x <= f64::MIN_POSITIVE => "0".to_owned(),
        x if (0.01..1000.0).contains(&x) => format!("{x:.2}"),
        x => format!("{x:.1e}"),
    }
}

#[test]
fn every_target_is_met() {
    let rows = measure();
    let table = table(&rows);
    println!("{table}");
    let missed: Vec<String> = rows
        .iter()
        .filter(|(_, row)| !row.is_met())
        .map(|(task, row)| {
            format!(
                "{task}, {}: {:e} of {:e} at {}",
                row.name, row.worst, row.target, row.at
            )
        })
        .collect();
    assert!(missed.is_empty(), "{}", missed.join("\n"));
    generated::compare_between("book/src/trust/accuracy.md", MARKS, &table);
}
