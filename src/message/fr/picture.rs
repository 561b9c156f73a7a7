//! Ce que montrent les figures.
//!
//! Letters stand as they are written, `k₁`: readers of screens speak them in the language of the page.

use super::listed;
use super::typography::spaced;
use crate::figure::Noun;
use crate::figure::story::{
    Action, Behaviour, Caption, Curves, DescribedCurve, FreeBody, Joint, LineKind, Mode, Pointer,
    Sense, Sketch, Story, Tendency, Thing,
};
use crate::math::Math;
use crate::source::capital;

/// The words of a picture.
pub(crate) fn caption(story: &Story) -> Caption {
    let Caption { title, description } = match story {
        Story::Sketch(sketch) => self::sketch(sketch),
        Story::FreeBodies(bodies) => free_bodies(bodies),
        Story::Curves(curves) => self::curves(curves),
        Story::ModeShapes(modes) => mode_shapes(modes),
        Story::Phasors { pointers, angles } => phasors(pointers, angles),
    };
    Caption {
        title: spaced(&title),
        description: spaced(&description),
    }
}

/// A noun without its article.
fn bare(noun: Noun) -> &'static str {
    noun.french
        .split_once(' ')
        .map_or(noun.french, |(_, bare)| bare)
}

fn definite(noun: Noun) -> String {
    let bare = bare(noun);
    if bare.starts_with(['a', 'e', 'i', 'o', 'u', 'é']) {
        format!("l’{bare}")
    } else if noun.french.starts_with("une ") {
        format!("la {bare}")
    } else {
        format!("le {bare}")
    }
}

/// After the preposition « à ».
fn behind_to(noun: Noun) -> String {
    match definite(noun) {
        definite if definite.starts_with("le ") => format!("au {}", bare(noun)),
        definite => format!("à {definite}"),
    }
}

fn sketch(sketch: &Sketch) -> Caption {
    let title = match sketch.nouns.as_slice() {
        [] => "Schéma".to_owned(),
        nouns => {
            let nouns: Vec<&str> = nouns.iter().map(|noun| bare(*noun)).collect();
            format!("Schéma : {}", listed(&nouns))
        }
    };
    let mut sentences = Vec::new();
    if !sketch.bodies.is_empty() {
        sentences.push(listed(&a_each(&sketch.bodies)));
    }
    sentences.extend(sketch.joints.iter().map(joint));
    for (force, on) in &sketch.forces {
        let on = on.as_ref();
        let on = on.map_or_else(String::new, |on| format!(" agit sur {}", the(on)));
        sentences.push(format!("{}{on}", a(force)));
    }
    let marked: Vec<String> = sketch.marked.iter().map(Math::plain).collect();
    match marked.as_slice() {
        [] => {}
        [one] => sentences.push(format!("grandeur indiquée : {one}")),
        several => sentences.push(format!("grandeurs indiquées : {}", listed(several))),
    }
    if sentences.is_empty() {
        sentences.push(title.clone());
    }
    let sentences: Vec<String> = sentences
        .iter()
        .map(|sentence| format!("{}.", capital(sentence)))
        .collect();
    Caption {
        title,
        description: sentences.join(" "),
    }
}

fn joint(joint: &Joint) -> String {
    let links = listed(&a_each(&joint.links));
    let verb = if joint.links.len() > 1 {
        "relient"
    } else {
        "relie"
    };
    match &joint.ends {
        [Some(one), Some(other)] if one != other => {
            format!("{links} {verb} {} {}", the(one), to(other))
        }
        [Some(one), _] | [None, Some(one)] => format!("{links} sur {}", the(one)),
        [None, None] => links,
    }
}

fn free_bodies(bodies: &[FreeBody]) -> Caption {
    let title = match bodies {
        [_] => "Bilan des forces",
        _ => "Bilans des forces",
    };
    let sentences: Vec<String> = bodies.iter().map(free_body).collect();
    Caption {
        title: title.to_owned(),
        description: sentences.join(" "),
    }
}

fn free_body(own: &FreeBody) -> String {
    let body = own.body.as_ref().map_or_else(|| "le corps".to_owned(), the);
    let actions: Vec<String> = own.actions.iter().map(action).collect();
    match actions.as_slice() {
        [] => format!("Rien n’agit sur {body}."),
        [one] => format!("Sur {body} agit {one}."),
        several => format!("Sur {body} agissent {}.", listed(several)),
    }
}

fn action(action: &Action) -> String {
    let force = match action.force.noun {
        Noun::MOMENT => a(&action.force),
        Noun::FORCE | Noun::NORMAL_FORCE | Noun::REACTION | Noun::FRICTION | Noun::WEIGHT => {
            the(&action.force)
        }
        link => {
            let label = plain(action.force.label.as_ref());
            let link = link.french;
            match action.sense {
                Sense::WithTwist | Sense::AgainstTwist => format!("le moment{label} d’{link},"),
                _ => format!("la force d’{link}{label}"),
            }
        }
    };
    let sense = match action.sense {
        Sense::Towards(eighth) => towards(eighth),
        Sense::Clockwise => "dans le sens horaire",
        Sense::WithTwist => "dans le sens de la torsion",
        Sense::AgainstTwist => "contre le sens de la torsion",
        Sense::Counterclockwise => "dans le sens antihoraire",
    };
    let when = action.velocity.as_ref();
    let when = when.map_or_else(String::new, |velocity| {
        format!(" (tant que {} est positif)", velocity.plain())
    });
    format!("{force} {sense}{when}")
}

fn towards(eighth: u8) -> &'static str {
    match eighth {
        0 => "vers la droite",
        1 => "vers le haut à droite",
        2 => "vers le haut",
        3 => "vers le haut à gauche",
        4 => "vers la gauche",
        5 => "vers le bas à gauche",
        6 => "vers le bas",
        _ => "vers le bas à droite",
    }
}

fn curves(curves: &Curves) -> Caption {
    let (up, across) = (curves.up.plain(), curves.across.plain());
    let title = match (up.is_empty(), across.is_empty()) {
        (false, false) => format!("{up} en fonction de {across}"),
        (false, true) => up,
        (true, false) => format!("Graphique en fonction de {across}"),
        (true, true) => "Graphique".to_owned(),
    };
    let mut description = title.clone();
    if let Some([from, to]) = &curves.range {
        description += &format!(", de {from} à {to}");
    }
    if curves.is_logarithmic {
        description += " (échelle logarithmique)";
    }
    description.push('.');
    for own in &curves.curves {
        description += &format!(" {}.", curve(own));
    }
    for (label, [across, up]) in &curves.marks {
        let label = plain(label.as_ref());
        description += &format!(" Point marqué{label} : {across} ; {up}.");
    }
    Caption { title, description }
}

fn curve(curve: &DescribedCurve) -> String {
    let label = plain(curve.label.as_ref());
    let line = match (curve.kind, label.is_empty()) {
        (LineKind::Curve, _) => format!("La courbe{label}"),
        (LineKind::Limit, _) => format!("La limite{label}"),
        (LineKind::Edge, true) => "Le bord d’une bande".to_owned(),
        (LineKind::Edge, false) => format!("Le bord de{label}"),
    };
    let verb = |rises| if rises { "croît" } else { "décroît" };
    match &curve.behaviour {
        Behaviour::Constant(value) => format!("{line} garde la valeur {value}"),
        Behaviour::Way {
            rises,
            ends: [from, to],
        } => format!("{line} {} de {from} à {to}", verb(*rises)),
        Behaviour::Turn {
            rises,
            values: [from, turn, to],
        } => format!(
            "{line} {} de {from} à {turn}, puis {} jusqu’à {to}",
            verb(*rises),
            verb(!rises)
        ),
        Behaviour::Oscillation {
            between: [low, high],
            tendency,
            turns,
        } => {
            let tendency = match tendency {
                Tendency::Decays => " en s’amortissant",
                Tendency::Grows => " en s’amplifiant",
                Tendency::Neither => "",
            };
            format!("{line} oscille entre {low} et {high}{tendency}, avec {turns} extremums")
        }
    }
}

fn mode_shapes(modes: &[Mode]) -> Caption {
    let sentences = modes.iter().enumerate().map(|(place, mode)| {
        let components = mode.components.iter();
        let components: Vec<String> = components
            .map(|(symbol, share)| format!("{} : {}", symbol.plain(), share.plain()))
            .collect();
        let heading = mode.heading.plain();
        format!(
            "Mode {}, {heading} : {}.",
            place + 1,
            components.join(" ; ")
        )
    });
    Caption {
        title: "Modes propres".to_owned(),
        description: sentences.collect::<Vec<_>>().join(" "),
    }
}

fn phasors(pointers: &[Pointer], angles: &[(Option<Math>, String)]) -> Caption {
    let title = "Diagramme de Fresnel";
    let mut description = format!("{title}.");
    for own in pointers {
        let label = plain(own.label.as_ref());
        let place = if own.is_joined {
            ", à l’extrémité du précédent"
        } else {
            ""
        };
        let Pointer { length, angle, .. } = own;
        description += &format!(" Vecteur{label} : {length} à {angle}{place}.");
    }
    for (label, size) in angles {
        let label = plain(label.as_ref());
        description += &format!(" Angle{label} : {size}.");
    }
    Caption {
        title: title.to_owned(),
        description,
    }
}

/// A letter as it is written, after a noun.
fn plain(label: Option<&Math>) -> String {
    match label.map(Math::plain).unwrap_or_default() {
        words if words.is_empty() => words,
        words => format!(" {words}"),
    }
}

fn the(thing: &Thing) -> String {
    let label = plain(thing.label.as_ref());
    format!("{}{label}", definite(thing.noun))
}

fn to(thing: &Thing) -> String {
    let label = plain(thing.label.as_ref());
    format!("{}{label}", behind_to(thing.noun))
}

fn a(thing: &Thing) -> String {
    let label = plain(thing.label.as_ref());
    format!("{}{label}", thing.noun.french)
}

fn a_each(things: &[Thing]) -> Vec<String> {
    things.iter().map(a).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::story::Speaker as _;
    use crate::message::Language;

    #[test]
    fn pictures_are_worded_in_each_language() {
        let thing = |noun, letter| Thing {
            noun,
            label: Some(Math::letter(letter)),
        };
        let block = Noun::new("block", "un bloc");
        let spring = Noun::new("spring", "un ressort");
        let damper = Noun::new("damper", "un amortisseur");
        let pulley = Noun::new("pulley", "une poulie");
        let sketch = Story::Sketch(Sketch {
            nouns: vec![block, damper, Noun::FORCE],
            bodies: vec![thing(block, 'm')],
            joints: vec![Joint {
                links: vec![thing(spring, 'k'), thing(damper, 'c')],
                ends: [
                    Some(thing(block, 'm')),
                    Some(Thing {
                        noun: Noun::FLOOR,
                        label: None,
                    }),
                ],
            }],
            forces: vec![(thing(Noun::FORCE, 'F'), Some(thing(block, 'm')))],
            marked: vec![Math::letter('x')],
        });
        let text = |language: Language| language.caption(&sketch).description;
        assert_eq!(
            text(Language::English),
            "A block m. A spring k and a damper c join the block m to the floor. \
             A force capital F acts on the block m. Marked is x."
        );
        assert_eq!(
            text(Language::French),
            "Un bloc m. Un ressort k et un amortisseur c relient le bloc m au sol. \
             Une force F agit sur le bloc m. Grandeur indiquée\u{a0}: x."
        );
        let free = Story::FreeBodies(vec![FreeBody {
            body: Some(thing(pulley, 'J')),
            actions: vec![
                Action {
                    force: thing(Noun::CORD, 'S'),
                    sense: Sense::Towards(6),
                    velocity: None,
                },
                Action {
                    force: thing(Noun::FRICTION, 'R'),
                    sense: Sense::Towards(0),
                    velocity: Some(Math::letter('v')),
                },
                Action {
                    force: thing(Noun::MOMENT, 'M'),
                    sense: Sense::Clockwise,
                    velocity: None,
                },
            ],
        }]);
        assert_eq!(
            Language::French.caption(&free).description,
            "Sur la poulie J agissent la force d’un câble S vers le bas, \
             la force de frottement R vers la droite (tant que v est positif) et \
             un moment M dans le sens horaire."
        );
        let curves = Story::Curves(Curves {
            up: Math::letter('x'),
            across: Math::letter('t'),
            range: Some(["0".to_owned(), "2 s".to_owned()]),
            is_logarithmic: false,
            curves: vec![DescribedCurve {
                kind: LineKind::Curve,
                label: None,
                behaviour: Behaviour::Oscillation {
                    between: ["−3 mm".to_owned(), "4 mm".to_owned()],
                    tendency: Tendency::Decays,
                    turns: 4,
                },
            }],
            marks: vec![(
                Some(Math::letter('P')),
                ["1 s".to_owned(), "2,5 mm".to_owned()],
            )],
        });
        assert_eq!(
            Language::English.caption(&curves).description,
            "x against t, from 0 to 2 s. Curve oscillates between −3 mm and 4 mm and decays, with 4 turning points. \
             Marked, P: 1 s, 2,5 mm."
        );
        assert_eq!(
            Language::French.caption(&curves).description,
            "x en fonction de t, de 0 à 2 s. La courbe oscille entre −3 mm et 4 mm en s’amortissant, avec 4 extremums. \
             Point marqué P\u{a0}: 1 s\u{a0}; 2,5 mm."
        );
    }
}
