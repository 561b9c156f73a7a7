//! What an answer line says.

use crate::answer::{Asked, Blank, Choosing, Entries, ShapeScale};
use crate::document::{Block, Document, Inline};
use crate::math::Math;
use crate::unit::Unit;

/// What an answer line says, in parentheses: `(formula in m, k)`, `(value, 3 figures)`.
pub(crate) fn blank(blank: &Blank) -> Document {
    let mut line = Sentence(vec![Inline::Text("(".to_owned())]);
    match &blank.form {
        Asked::Value if blank.figures.is_none() => line.say("exact value"),
        Asked::Value => line.say("value"),
        Asked::ComplexValue => line.say("complex number"),
        Asked::Values { .. } if blank.figures.is_none() => line.say("exact values"),
        Asked::Values { .. } => line.say("values"),
        Asked::Integer => line.say("integer"),
        Asked::Formula => {
            line.say("formula");
            line.letters(" in ", blank);
        }
        Asked::Function { variable } => {
            line.say("function of ");
            line.math(variable.clone());
            line.letters(" in ", blank);
            if blank.figures.is_some() {
                let or = if blank.letters.is_empty() {
                    " "
                } else {
                    ", or "
                };
                line.say(&format!("{or}with numbers"));
                line.unit(blank.unit);
            }
        }
        Asked::GeneralSolution => {
            line.say("general solution");
            line.letters(" in ", blank);
            line.say(" and free constants");
        }
        Asked::Equation { are_several } => {
            line.say(if *are_several {
                "equations"
            } else {
                "equation"
            });
            line.letters(" in ", blank);
        }
        Asked::Matrix(entries) => {
            line.say("matrix");
            line.entries(*entries, blank, " of");
        }
        Asked::Interval(entries) => {
            line.say("interval");
            line.entries(*entries, blank, " with");
        }
        Asked::ModeShape {
            entries,
            scale,
            are_several,
        } => {
            line.say(if *are_several {
                "mode shapes"
            } else {
                "mode shape"
            });
            match entries {
                Entries::Numbers => {}
                Entries::Formulas => line.letters(" in ", blank),
                Entries::Either => line.say(", numbers or formulas"),
            }
            line.say(match scale {
                ShapeScale::Any => ", any scale",
                ShapeScale::Mass => ", scaled to unit modal mass",
                ShapeScale::First => ", scaled to a first component of 1",
            });
        }
        Asked::Choice(choosing) => line.say(match choosing {
            Choosing::One => "choose one",
            Choosing::Several => "choose all that apply",
            Choosing::Ranking => "put all in order",
        }),
        Asked::Work => line.say("marked by a person"),
    }
    match blank.figures {
        Some(1) => line.say(", 1 figure"),
        Some(figures) => line.say(&format!(", {figures} figures")),
        None => {}
    }
    match blank.form {
        Asked::Values { is_ordered: true } => line.say(", in the order asked for"),
        Asked::Values { is_ordered: false } => line.say(", in any order"),
        _ => {}
    }
    line.say(")");
    Document::of(vec![Block::Paragraph(line.0)], Vec::new())
}

struct Sentence(Vec<Inline>);

impl Sentence {
    fn say(&mut self, words: &str) {
        if let Some(Inline::Text(last)) = self.0.last_mut() {
            last.push_str(words);
        } else {
            self.0.push(Inline::Text(words.to_owned()));
        }
    }

    fn math(&mut self, math: Math) {
        self.0.push(Inline::Math(math));
    }

    /// The letters, if there are any.
    fn letters(&mut self, before: &str, blank: &Blank) {
        for (place, letter) in blank.letters.iter().enumerate() {
            self.say(if place == 0 { before } else { ", " });
            self.math(letter.symbol.clone());
        }
    }

    fn unit(&mut self, unit: Option<Unit>) {
        if let Some(unit) = unit {
            self.say(" in ");
            self.math(unit.math());
        }
    }

    /// Letters, numbers in their unit, or both.
    fn entries(&mut self, entries: Entries, blank: &Blank, joint: &str) {
        if entries != Entries::Numbers {
            self.letters(" in ", blank);
        }
        if entries != Entries::Formulas {
            if entries == Entries::Either && !blank.letters.is_empty() {
                self.say(" or");
            }
            self.say(&format!("{joint} numbers"));
            self.unit(blank.unit);
        }
    }
}
