//! French.

mod blank;
pub(crate) mod derivation;
mod misfit;
pub(crate) mod picture;
mod typography;
mod unreadable;
pub(crate) mod voice;

pub(crate) use self::blank::blank;
use self::misfit::misfit;
use self::typography::spaced;

use crate::answer::{
    Close, Coefficient, Decades, Fault, Linearity, Negated, Note, Remark, Scaling, Shape, Slip,
    Term, TermKind, Terms, TwoPi, Verdict,
};
use crate::document::{Block, Document, Inline};
use crate::math::Math;
use crate::message::ByHand;
use crate::source::capital;
use crate::unit::DecimalMark;

/// What is said of a remark.
pub(crate) fn say(remark: &Remark) -> Option<Document> {
    let words = match remark {
        Remark::Mistake(_) => return None,
        Remark::Option(text) => return Some(text.clone()),
        Remark::Followed(symbols) => return Some(followed(symbols)),
        Remark::Slip(slip) => self::slip(slip),
        Remark::Dimension(misfit) => self::misfit(misfit),
        Remark::Unreadable(unreadable) => unreadable::unreadable(unreadable),
        Remark::Note(note) => self::note(note),
    };
    Some(Document::sentence(&spaced(&words)))
}

/// What is said of a verdict alone.
pub(crate) fn verdict(verdict: Verdict) -> Document {
    Document::sentence(match verdict {
        Verdict::Right => "C’est juste.",
        Verdict::Partial => "C’est juste en partie.",
        Verdict::Wrong => "Ce n’est pas la réponse.",
        Verdict::Unreadable => "La réponse n’a pas pu être lue.",
        Verdict::Missing => "Il n’y a pas de réponse.",
    })
}

/// A verdict in short.
pub(crate) fn heading(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Right => "Juste",
        Verdict::Partial => "Juste en partie",
        Verdict::Wrong => "Faux",
        Verdict::Unreadable => "Illisible",
        Verdict::Missing => "Sans réponse",
    }
}

/// Of an answer that nobody could read yet.
pub(crate) const UNDECIDED: &str = "Pas encore décidé";

/// What a person did with a response.
pub(crate) fn by_hand(what: &ByHand) -> String {
    spaced(&match what {
        ByHand::Open => "Cette question n’a pas encore été corrigée.".to_owned(),
        ByHand::Marked => "Noté par votre enseignant.".to_owned(),
        ByHand::ReadAs => "Votre enseignant a lu votre réponse comme vous l’entendiez :".to_owned(),
        ByHand::Unclear => {
            "Le fichier des réponses ne dit pas clairement ce qui a été répondu ici.".to_owned()
        }
        ByHand::Accepted => "Votre enseignant accepte cette réponse.".to_owned(),
        ByHand::Shared => {
            "Votre enseignant accorde une partie des points pour cette réponse.".to_owned()
        }
        ByHand::FullMarks => "Tout le monde reçoit les points de cette question.".to_owned(),
        ByHand::Rescaled => {
            "Cette question ne compte pas ; les autres se partagent ses points.".to_owned()
        }
        ByHand::LeftOut => "Cette question ne compte pas.".to_owned(),
        ByHand::Charged { points, is_one } => {
            let noun = if *is_one { "point" } else { "points" };
            format!("Un mauvais choix coûte {points} {noun}.")
        }
        ByHand::Row {
            given: Some(given),
            most,
        } => format!("{given} sur {most} : "),
        ByHand::Row { given: None, most } => format!("au plus {most} : "),
    })
}

/// A slip in short, by the code of its reason.
pub(crate) fn slip_in_short(code: &str) -> Option<&'static str> {
    Some(match code {
        "dimension" => "mauvaise dimension",
        "two-pi" => "un facteur 2π entre pulsation et fréquence",
        "power-of-ten" => "une puissance de dix ou un préfixe",
        "sign" => "le signe",
        "near" => "proche de la réponse, mais hors tolérance",
        "scale" => "juste à un facteur près",
        "figures" => "chiffres significatifs",
        "angle-unit" => "degrés et radians",
        _ => return None,
    })
}

fn followed(symbols: &[Math]) -> Document {
    let text = |words: &str| Inline::Text(spaced(words));
    let mut words = vec![text("Compté avec report d’erreur : c’est juste pour ")];
    words.push(text(match symbols {
        [] => "votre propre équation",
        [_] => "votre propre valeur de ",
        _ => "vos propres valeurs de ",
    }));
    for (at, symbol) in symbols.iter().enumerate() {
        match at {
            0 => {}
            at if at + 1 == symbols.len() => words.push(text(" et ")),
            _ => words.push(text(", ")),
        }
        words.push(Inline::Math(symbol.clone()));
    }
    words.push(text("."));
    Document::of(vec![Block::Paragraph(words)], Vec::new())
}

fn note(note: &Note) -> String {
    match note {
        Note::TakenIn(unit) => format!("Pris en {}.", unit.text()),
        Note::TakenAs { taken, other } => {
            format!("Ceci peut se lire {taken} ou {other} ; la lecture retenue est {taken}.")
        }
        Note::Figures { asked, typed: None } => {
            format!("Un nombre décimal à {asked} chiffres significatifs est demandé.")
        }
        Note::Figures {
            asked,
            typed: Some((number, has)),
        } => {
            format!("{asked} chiffres significatifs sont demandés, `{number}` en a {has}.")
        }
        Note::JouleForMoment(unit) => {
            format!(
                "Le joule est réservé aux énergies : écrivez ceci en {}.",
                unit.text()
            )
        }
        Note::RightBut(misfit) => format!("C’est juste, mais : {}", self::misfit(misfit)),
        Note::LettersCarryUnits(unit) => {
            format!("Les lettres portent leurs unités : supprimez `{unit}`.")
        }
        Note::RightTogether => "C’est juste avec les autres équations.".to_owned(),
        Note::OthersBelongElsewhere => {
            "C’est juste ; les autres équations relèvent des autres questions.".to_owned()
        }
        Note::OtherForm => {
            "C’est juste, mais pas sous la forme demandée ; voyez la ligne de réponse.".to_owned()
        }
        Note::WithValues => {
            "C’est juste avec les valeurs de cette feuille ; avec des lettres, ce le serait pour toutes.".to_owned()
        }
        Note::ByTextbooks => {
            "C’est juste, avec les symboles absents de l’énoncé tels que les manuels les définissent ; dites ce qu’ils sont.".to_owned()
        }
        Note::RoundedNumbers => {
            "C’est juste ; les nombres sont arrondis, on les demande exacts.".to_owned()
        }
        Note::ConstantsToSpare { needed, found } => {
            format!("C’est juste ; {needed} constantes suffisent, en voici {found}.")
        }
    }
}

#[expect(clippy::too_many_lines, reason = "a table")]
fn slip(slip: &Slip) -> String {
    match slip {
        Slip::TwoPi(slip) => return two_pi(slip),
        Slip::PowerOfTen(Decades::Function(unit)) => {
            return format!(
                "Les chiffres conviennent, la puissance de dix non : une fonction dans une autre unité que {} doit porter son unité.",
                unit.text()
            );
        }
        Slip::AngleUnit(unit) => {
            return format!(
                "Le nombre convient dans une autre unité d’angle, pas en {}.",
                unit.text()
            );
        }
        Slip::OutsideInterval(ends) => {
            let [low, high] = **ends;
            return format!(
                "La direction est juste ; donnez l’angle entre {} et {}.",
                low.math(DecimalMark::Comma).plain(),
                high.math(DecimalMark::Comma).plain()
            );
        }
        Slip::Entries(places) => return entries(places),
        Slip::Shapes(shapes) => {
            let sentences: Vec<String> = shapes.iter().map(shape).collect();
            return sentences.join(" ");
        }
        Slip::Fewer {
            typed,
            found,
            needed,
        } => return fewer(*typed, *found, *needed),
        Slip::Terms(terms) => return self::terms(terms),
        Slip::Counted {
            right,
            of,
            surplus,
            is_order_wrong,
        } => {
            let are_right = right_of(*right, *of, "valeurs");
            return match surplus {
                Some(given) => format!("{are_right}, mais {given} sont données."),
                None if *is_order_wrong && right == of => {
                    "Les valeurs sont justes, leur ordre ne l’est pas.".to_owned()
                }
                None if *is_order_wrong => format!("{are_right}, mais dans un autre ordre."),
                None => format!("{are_right}."),
            };
        }
        Slip::TooFewConstants { found, needed } => {
            return format!(
                "Ceci vérifie les équations, mais a {found} des {needed} constantes libres d’une solution générale. Une lettre de l’énoncé compte comme une donnée."
            );
        }
        Slip::CountedComplex { right, of } => {
            return format!("{}.", right_of(*right, *of, "valeurs"));
        }
        Slip::PowerOfTen(Decades::Prefix) => {
            "Les chiffres conviennent, la puissance de dix non : vérifiez les préfixes."
        }
        Slip::PowerOfTen(Decades::Percent) => {
            "Les chiffres conviennent : un pourcentage demande son signe, `%`."
        }
        Slip::Sign(negated) => match negated {
            Negated::Whole => "Le signe est faux.",
            Negated::Number => "La valeur absolue convient, le signe non.",
            Negated::Angle => "L’angle convient avec le signe opposé.",
            Negated::Imaginary => "Le signe de la partie imaginaire est faux.",
            Negated::Entries => "Tous les signes sont inversés.",
        },
        Slip::PhaseInDegrees => {
            "La phase est en degrés : écrivez-la en radians, ou avec le signe °."
        }
        Slip::Near(close) => match close {
            Close::Rounding => {
                "Proche, mais hors tolérance : une étape est trop arrondie, ou il manque un petit terme."
            }
            Close::RoundedFormula => {
                "Presque juste : donnez-en les nombres exactement, par des fractions, des racines ou des multiples de π."
            }
            Close::Function => {
                "Avec ces données on s’en approche, mais la formule diffère : un petit terme manque ou est faux."
            }
            Close::Ends => {
                "Les bornes sont justes ; revoyez lesquelles font partie de l’intervalle."
            }
        },
        Slip::Scale(Scaling::First) => {
            "La forme est juste ; normez-la pour que sa première composante soit 1."
        }
        Slip::Scale(Scaling::Mass) => {
            "La forme est juste ; normez-la pour que sa masse modale soit 1."
        }
        Slip::Angle => "Le module convient, l’argument non.",
        Slip::UnequalSides => "Les membres de cette égalité ne sont pas égaux.",
        Slip::NotInteger => "Un nombre entier est demandé.",
        Slip::NoValueForData => {
            "Ceci n’a pas de valeur pour des données pour lesquelles il y a une réponse."
        }
        Slip::NoValueOnSpan => "Ceci n’a pas de valeur en certains points de l’intervalle.",
        Slip::NoValueAtTimes => "Ceci n’a pas de valeur à certains instants.",
        Slip::Zero => "Ceci est nul.",
        Slip::Factor => {
            "Il y a un facteur constant de trop ou de moins : revoyez chaque nombre et chaque terme."
        }
        Slip::RunsAway => {
            "Le début est juste, puis la fonction s’écarte : revoyez la pulsation et l’amortissement."
        }
        Slip::CommonFactor => "Tous les éléments sont faux d’un même facteur.",
        Slip::OtherOrder => {
            "Ce sont les éléments pour les coordonnées dans un autre ordre."
        }
        Slip::Reversed => "L’ordre est juste, mais il commence par le mauvais bout.",
        Slip::CountOfIntervals => "Revoyez combien il y a d’intervalles.",
        Slip::DependentShapes => {
            "Ces formes sont proportionnelles ; des formes indépendantes sont demandées."
        }
        Slip::NoMotion => "Une forme dont toutes les composantes sont nulles n’est pas un mouvement.",
        Slip::Unsatisfied => {
            "Ceci ne vérifie pas les équations du mouvement pour toutes les valeurs de ses constantes."
        }
        Slip::NotGeneral => {
            "Ceci vérifie les équations, mais ses constantes ne permettent pas toutes les conditions initiales : ce n’est pas la solution générale."
        }
        Slip::NotFactors => {
            "Ceci vérifie les équations, mais chaque constante doit être un facteur ou une phase pour satisfaire \
             toutes les conditions initiales."
        }
        Slip::OtherEquation => {
            "Ceci découle des équations du mouvement, mais ce n’est pas celle qui est demandée ici, et avec \
             les autres réponses elle ne les donne pas toutes."
        }
        Slip::Tautology => {
            "Ceci est vrai pour tout mouvement : cela ne dit rien de celui-ci."
        }
    }
    .to_owned()
}

fn right_of(right: usize, of: usize, what: &str) -> String {
    let are = if right < 2 {
        "est juste"
    } else {
        "sont justes"
    };
    format!("{right} des {of} {what} {are}")
}

fn two_pi(slip: &TwoPi) -> String {
    match slip {
        TwoPi::Formula => "Il y a un facteur 2π d’écart.".to_owned(),
        TwoPi::Frequency => {
            "Il y a un facteur 2π d’écart : c’est celui entre la pulsation et la fréquence en hertz."
                .to_owned()
        }
        TwoPi::Number => {
            "Un facteur 2π s’est glissé : une pulsation ω en rad/s vaut 2π fois la fréquence f en Hz."
                .to_owned()
        }
        TwoPi::Cycles { typed, asked } => format!(
            "Un facteur 2π s’est glissé : `{}` compte des cycles, la réponse est demandée en {}.",
            typed.text(),
            asked.text()
        ),
        TwoPi::Wave => {
            "Un facteur 2π s’est glissé : l’argument du sinus et du cosinus contient la pulsation ω en rad/s, \
             2π fois la fréquence f en Hz."
                .to_owned()
        }
    }
}

fn entries(places: &[(usize, usize)]) -> String {
    match places {
        [one] => format!("L’élément {} est faux.", entry(*one)),
        many => {
            let places: Vec<String> = many.iter().map(|place| entry(*place)).collect();
            format!("Les éléments {} sont faux.", places.join(", "))
        }
    }
}

fn entry((row, column): (usize, usize)) -> String {
    format!("({row}, {column})")
}

fn shape(shape: &Shape) -> String {
    match shape {
        Shape::OfMode { found, asked } => format!(
            "C’est la forme du mode {found}, pas du mode {asked} ; les modes se comptent à partir de la plus basse fréquence."
        ),
        Shape::Reversed => {
            "Les valeurs absolues conviennent, mais revoyez quelles parties sont en opposition."
                .to_owned()
        }
        Shape::Wrong(mode) => format!("La forme du mode {mode} est fausse."),
    }
}

fn fewer(typed: usize, found: usize, needed: usize) -> String {
    if typed > found {
        let are = if found < 2 {
            "seule 1 est indépendante".to_owned()
        } else {
            format!("seules {found} sont indépendantes")
        };
        return format!(
            "C’est juste jusque-là, mais de ces équations {are} ; {needed} sont demandées."
        );
    }
    format!("C’est juste jusque-là : {needed} équations indépendantes sont demandées.")
}

fn terms(terms: &Terms) -> String {
    let mut sentences: Vec<String> = Vec::new();
    if let Some(equation) = terms.equation {
        sentences.push(format!("Équation {equation} :"));
    }
    sentences.extend(
        terms
            .faults
            .iter()
            .map(|(term, fault)| of_term(term, fault)),
    );
    let last = terms.linearity.map(|linearity| match linearity {
        Linearity::Due => {
            "C’est juste ainsi, mais il reste à linéariser pour les petits mouvements."
        }
        Linearity::Surplus => {
            "Ceci ne vaut que pour les petits mouvements ; l’équation est demandée sans cette approximation."
        }
        Linearity::WrongForLarge => {
            "C’est juste pour les petits mouvements seulement : revoyez la dépendance pour les grands."
        }
        Linearity::DueBesides if terms.faults.is_empty() => {
            "Ce n’est pas encore juste, et il faut aussi linéariser pour les petits mouvements."
        }
        Linearity::DueBesides => "Il faut aussi linéariser pour les petits mouvements.",
    });
    sentences.extend(last.map(str::to_owned));
    sentences.join(" ")
}

fn of_term(term: &Term, fault: &Fault) -> String {
    let name = name(term);
    match fault {
        Fault::Missing => format!("Il manque le {name}."),
        Fault::Surplus => format!("Il ne devrait pas y avoir de {name}."),
        Fault::Sign => format!("Le signe du {name} est faux."),
        Fault::Coefficient(Coefficient::Number) => {
            format!("Le nombre devant le {name} est faux.")
        }
        Fault::Coefficient(Coefficient::Other) => format!("Le coefficient du {name} est faux."),
        Fault::Coefficient(Coefficient::Data { missed, surplus }) => {
            let data = |data: &[(String, Option<String>)]| {
                let named = data.iter().map(|(symbol, title)| match title {
                    Some(title) => format!("{symbol} ({title})"),
                    None => symbol.clone(),
                });
                listed(&named.collect::<Vec<_>>())
            };
            match (missed.is_empty(), surplus.is_empty()) {
                (_, true) => format!("Au {name} il manque {}.", data(missed)),
                (true, false) => format!("Le {name} ne devrait pas contenir {}.", data(surplus)),
                (false, false) => format!(
                    "Au {name} il manque {}, et il ne devrait pas contenir {}.",
                    data(missed),
                    data(surplus)
                ),
            }
        }
    }
}

fn name(term: &Term) -> String {
    let kind = match term.kind {
        TermKind::Exciting => "terme d’excitation",
        TermKind::Inertia => "terme d’inertie",
        TermKind::Friction => "terme de frottement",
        TermKind::Damping => "terme d’amortissement",
        TermKind::Stiffness => "terme de raideur",
        TermKind::Other => "terme",
    };
    match &term.unknown {
        Some(unknown) => format!("{kind} (en {unknown})"),
        None => format!("{kind} sans {}", listed(&term.without)),
    }
}

/// Names with commas and a last `et`.
fn listed<T: AsRef<str>>(names: &[T]) -> String {
    super::listed(names, "et")
}
