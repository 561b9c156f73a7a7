//! Ce qui relie les lignes d’un calcul : what stands between the lines of a derivation.

use super::typography::spaced;
use crate::document::Inline;
use crate::expr::Notation;
use crate::mechanics::Reason;
use crate::message::Phrase;

/// What a step does.
pub(crate) fn step(reason: &Reason, symbols: &dyn Notation) -> Vec<Inline> {
    let symbol = |name| Inline::Math(symbols.name(name).math);
    let text = |words: &str| Inline::Text(spaced(words));
    match reason {
        Reason::Kinematics => vec![text("Déplacements :")],
        Reason::Terms(name) => vec![text("Termes relatifs à "), symbol(name), text(" :")],
        Reason::Lagrange(_) => vec![text("Équation de Lagrange :")],
        Reason::Linearized => vec![text("Pour de petits déplacements autour de l’équilibre :")],
        Reason::Energy => vec![text("Par la méthode énergétique :")],
        Reason::Power => vec![text(
            "Puissance des forces qui ne dérivent pas d’un potentiel :",
        )],
        Reason::Balance => vec![text("Bilan d’énergie :")],
        Reason::Divided(name) => vec![
            text("En divisant par "),
            Inline::Math(symbols.name(name).math.derivative(1)),
            text(", qui n’est pas identiquement nul :"),
        ],
        Reason::Body(name) => {
            let body = name.as_str().replace('_', " ");
            vec![text(&format!("Deuxième loi de Newton, {body} :"))]
        }
        Reason::AtRest => vec![text("Au repos, tous les déplacements étant nuls :")],
        Reason::Letters => vec![text("Les déplacements statiques valent donc :")],
        Reason::InMotion => vec![text("En mouvement, compte tenu de l’équilibre statique :")],
        Reason::Characteristic => {
            vec![text("Mouvement à une seule pulsation, sans amortisseurs :")]
        }
        Reason::Row(row) => {
            let ordinal = if *row == 0 { "Première" } else { "Deuxième" };
            vec![text(&format!("{ordinal} ligne :"))]
        }
        Reason::Elimination(name, unknowns) => {
            let mut words = vec![text("Suivant "), symbol(name)];
            for (number, unknown) in unknowns.iter().enumerate() {
                let last = number > 0 && number + 1 == unknowns.len();
                words.push(text(match (number, last) {
                    (0, _) => ", après élimination de ",
                    (_, true) => " et ",
                    (_, false) => ", ",
                }));
                words.push(symbol(unknown));
            }
            words.push(text(" :"));
            words
        }
    }
}

/// A word that formulas have in English.
pub(crate) fn word(word: &str) -> Option<&'static str> {
    Some(match word {
        " to " => " à ",
        " or " => " ou ",
        " any" => " quelconque",
        "no value" => "aucune valeur",
        "out of range" => "hors limites",
        "if " => "si ",
        "otherwise" => "sinon",
        "not " => "non ",
        "in " => "en ",
        _ => return None,
    })
}

/// What is printed among formulas and with figures.
pub(crate) fn phrase(phrase: &Phrase<'_>) -> String {
    spaced(&match phrase {
        Phrase::TurningPoints => "Points de rebroussement, où l’on compare la résultante des autres forces au frottement maximal :".to_owned(),
        Phrase::AndSoOnUntil => "et ainsi de suite, jusqu’à".to_owned(),
        Phrase::Nonexistent => "n’existe pas".to_owned(),
        Phrase::Moving => "Le système en mouvement".to_owned(),
        Phrase::Mode(number) => format!("Mode {number}"),
        Phrase::ModeShown { number, shape } => {
            let shape: Vec<String> = shape
                .iter()
                .map(|(symbol, share)| format!("{} {share}", symbol.plain()))
                .collect();
            let shape = shape.join(" ; ");
            format!("La figure avec les deux positions extrêmes du mode {number} : {shape}.")
        }
        Phrase::Figure(description) => format!("(Figure : {description})"),
        Phrase::Plot(description) => format!("(Graphique : {description})"),
        Phrase::NoPlot => "(pas de graphique pour ces données)".to_owned(),
        Phrase::NumberOnly => "(nombre seul)".to_owned(),
        Phrase::NumberAndUnit => "(nombre et unité)".to_owned(),
        Phrase::Question(number) => format!("Exercice {number}"),
        Phrase::Essays => "réponses rédigées".to_owned(),
        Phrase::Points => "Points".to_owned(),
        Phrase::GivenFor => "pour".to_owned(),
    })
}
