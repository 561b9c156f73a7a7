//! Ce que dit une ligne de réponse : what an answer line says.

use super::typography::spaced;
use crate::answer::{Asked, Blank, Choosing, Entries, ShapeScale};
use crate::document::{Block, Document, Inline};
use crate::math::Math;
use crate::unit::Unit;

/// What an answer line says, in parentheses: `(formule en m, k)`, `(valeur, 3 chiffres significatifs)`.
pub(crate) fn blank(blank: &Blank) -> Document {
    let mut line = Sentence(vec![Inline::Text("(".to_owned())]);
    match &blank.form {
        Asked::Value if blank.figures.is_none() => line.say("valeur exacte"),
        Asked::Value => line.say("valeur"),
        Asked::ComplexValue => line.say("nombre complexe"),
        Asked::Values { .. } if blank.figures.is_none() => line.say("valeurs exactes"),
        Asked::Values { .. } => line.say("valeurs"),
        Asked::Integer => line.say("nombre entier"),
        Asked::Formula => {
            line.say("formule");
            line.letters(" en fonction de ", blank);
        }
        Asked::Function { variable } => {
            line.say("fonction de ");
            line.math(variable.clone());
            line.letters(" avec ", blank);
            if blank.figures.is_some() {
                line.say(if blank.letters.is_empty() {
                    " avec valeurs numériques"
                } else {
                    ", ou avec valeurs numériques"
                });
                line.unit(blank.unit);
            }
        }
        Asked::GeneralSolution => {
            line.say("solution générale");
            line.letters(" avec ", blank);
            line.say(" et des constantes libres");
        }
        Asked::Equation { are_several } => {
            line.say(if *are_several {
                "équations"
            } else {
                "équation"
            });
            line.letters(" avec ", blank);
        }
        Asked::Matrix(entries) => {
            line.say("matrice");
            line.entries(*entries, blank);
        }
        Asked::Interval(entries) => {
            line.say("intervalle");
            line.entries(*entries, blank);
        }
        Asked::ModeShape {
            entries,
            scale,
            are_several,
        } => {
            line.say(if *are_several {
                "formes modales"
            } else {
                "forme modale"
            });
            match entries {
                Entries::Numbers => {}
                Entries::Formulas => line.letters(" en fonction de ", blank),
                Entries::Either => line.say(", nombres ou formules"),
            }
            line.say(match scale {
                ShapeScale::Any => ", à un facteur près",
                ShapeScale::Mass => ", normée à la masse modale 1",
                ShapeScale::First => ", normée à la première composante 1",
            });
        }
        Asked::Choice(choosing) => line.say(match choosing {
            Choosing::One => "une seule réponse",
            Choosing::Several => "toutes les réponses justes",
            Choosing::Ranking => "à mettre dans l’ordre",
        }),
        Asked::Work => line.say("corrigé à la main"),
    }
    match blank.figures {
        Some(1) => line.say(", 1 chiffre significatif"),
        Some(figures) => line.say(&format!(", {figures} chiffres significatifs")),
        None => {}
    }
    match blank.form {
        Asked::Values { is_ordered: true } => line.say(", dans l’ordre demandé"),
        Asked::Values { is_ordered: false } => line.say(", dans un ordre quelconque"),
        _ => {}
    }
    line.say(")");
    Document::of(vec![Block::Paragraph(line.0)], Vec::new())
}

struct Sentence(Vec<Inline>);

impl Sentence {
    fn say(&mut self, words: &str) {
        if let Some(Inline::Text(last)) = self.0.last_mut() {
            last.push_str(&spaced(words));
        } else {
            self.0.push(Inline::Text(spaced(words)));
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
            self.say(" en ");
            self.math(unit.math());
        }
    }

    /// Letters, numbers in their unit, or both.
    fn entries(&mut self, entries: Entries, blank: &Blank) {
        if entries != Entries::Numbers {
            self.letters(" en fonction de ", blank);
        }
        if entries != Entries::Formulas {
            if entries == Entries::Either && !blank.letters.is_empty() {
                self.say(" ou");
            }
            self.say(" de nombres");
            self.unit(blank.unit);
        }
    }
}
