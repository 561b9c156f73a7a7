//! What stands between the lines of a derivation.

use crate::document::Inline;
use crate::expr::Notation;
use crate::math::Voice;
use crate::mechanics::Reason;
use crate::message::Phrase;

/// What a step does.
pub(crate) fn step(reason: &Reason, symbols: &dyn Notation) -> Vec<Inline> {
    let symbol = |name| Inline::Math(symbols.name(name).math);
    let text = |words: &str| Inline::Text(words.to_owned());
    match reason {
        Reason::Kinematics => vec![text("Displacements:")],
        Reason::Terms(name) => vec![text("Terms for "), symbol(name), text(":")],
        Reason::Lagrange(_) => vec![text("Lagrange’s equation:")],
        Reason::Linearized => vec![text("For small displacements from equilibrium:")],
        Reason::Energy => vec![text("By energy:")],
        Reason::Power => vec![text("Power of the forces without potential energy:")],
        Reason::Balance => vec![text("Balance of energy:")],
        Reason::Divided(name) => vec![
            text("Divided by "),
            Inline::Math(symbols.name(name).math.derivative(1)),
            text(", which is not always zero:"),
        ],
        Reason::Body(name) => {
            let body = name.as_str().replace('_', " ");
            vec![text(&format!("Newton’s law, {body}:"))]
        }
        Reason::AtRest => vec![text("At rest, with all displacements zero:")],
        Reason::Letters => vec![text("So the static displacements are:")],
        Reason::InMotion => vec![text("In motion, with the balance at rest:")],
        Reason::Characteristic => {
            vec![text(
                "A motion with one angular frequency and without dampers:",
            )]
        }
        Reason::Row(row) => {
            let ordinal = if *row == 0 { "First" } else { "Second" };
            vec![text(&format!("{ordinal} row:"))]
        }
        Reason::Elimination(name, unknowns) => {
            let mut words = vec![text("Along "), symbol(name)];
            for (number, unknown) in unknowns.iter().enumerate() {
                words.push(text(if number == 0 { ", without " } else { ", " }));
                words.push(symbol(unknown));
            }
            words.push(text(":"));
            words
        }
    }
}

/// What is printed among formulas and with figures.
pub(crate) fn phrase(phrase: &Phrase<'_>) -> String {
    match phrase {
        Phrase::TurningPoints => {
            "Turning points, and the pull of all other forces there against the largest friction:"
                .to_owned()
        }
        Phrase::AndSoOnUntil => "and so on, until".to_owned(),
        Phrase::Nonexistent => "does not exist".to_owned(),
        Phrase::Moving => "The system in motion".to_owned(),
        Phrase::Mode(number) => format!("Mode {number}"),
        Phrase::ModeShown { number, shape } => {
            let shape: Vec<String> = shape
                .iter()
                .map(|(symbol, share)| format!("{} {share}", symbol.spoken(Voice::ENGLISH)))
                .collect();
            let shape = shape.join(", ");
            format!("The figure with both extremes of mode {number}: {shape}.")
        }
        Phrase::Figure(description) => format!("(Figure: {description})"),
        Phrase::Plot(description) => format!("(Plot: {description})"),
        Phrase::NoPlot => "(no plot for these data)".to_owned(),
        Phrase::NumberOnly => "(number only)".to_owned(),
        Phrase::NumberAndUnit => "(number and unit)".to_owned(),
        Phrase::Question(number) => format!("Question {number}"),
        Phrase::Essays => "essays".to_owned(),
        Phrase::Points => "Points".to_owned(),
        Phrase::GivenFor => "for".to_owned(),
    }
}
