//! Ce que montrent les figures.
//!
//! Letters stand as they are written, `k₁`: readers of screens speak them in the language of the page.

use super::listed;
use super::typography::spaced;
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

/// A noun with its gender, which its articles follow.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Noun {
    word: &'static str,
    is_feminine: bool,
}

impl Noun {
    /// The French word for an English noun; nothing where there is none yet.
    pub(crate) fn of(english: &str) -> Option<Self> {
        let (is_feminine, word) = match english {
            "ball" => (true, "boule"),
            "bar" => (true, "barre"),
            "bead" => (true, "perle"),
            "block" => (false, "bloc"),
            "body" => (false, "corps"),
            "capacitor" => (false, "condensateur"),
            "cart" => (false, "chariot"),
            "ceiling" => (false, "plafond"),
            "coil" => (true, "bobine"),
            "cord" => (false, "câble"),
            "damper" => (false, "amortisseur"),
            "disk" => (false, "disque"),
            "elastic column" => (true, "colonne élastique"),
            "elastic wire" => (false, "fil élastique"),
            "floor" => (false, "sol"),
            "force" => (true, "force"),
            "friction" => (true, "force de frottement"),
            "moment" => (false, "moment"),
            "moving base" => (false, "support mobile"),
            "normal force" => (true, "force normale"),
            "pulley" => (true, "poulie"),
            "reaction" => (true, "réaction"),
            "resistor" => (true, "résistance"),
            "ring" => (false, "anneau"),
            "rod" => (true, "tige"),
            "slope" => (false, "plan incliné"),
            "spring" => (false, "ressort"),
            "torsion spring" => (false, "ressort de torsion"),
            "U-tube with liquid" => (false, "tube en U rempli de liquide"),
            "unbalanced rotor" => (false, "rotor à balourd"),
            "voltage source" => (true, "source de tension"),
            "wall on the left" => (false, "mur de gauche"),
            "wall on the right" => (false, "mur de droite"),
            "weight" => (false, "poids"),
            _ => return None,
        };
        Some(Self { word, is_feminine })
    }

    /// A test holds that every noun of a figure has its word.
    fn known(english: &'static str) -> Self {
        Self::of(english).unwrap_or(Self {
            word: english,
            is_feminine: false,
        })
    }

    fn indefinite(self) -> String {
        let article = if self.is_feminine { "une" } else { "un" };
        format!("{article} {}", self.word)
    }

    fn definite(self) -> String {
        let Self { word, is_feminine } = self;
        match (
            word.starts_with(['a', 'e', 'i', 'o', 'u', 'é']),
            is_feminine,
        ) {
            (true, _) => format!("l’{word}"),
            (false, true) => format!("la {word}"),
            (false, false) => format!("le {word}"),
        }
    }

    /// After the preposition « à ».
    fn behind_to(self) -> String {
        match self.definite() {
            definite if definite.starts_with("le ") => format!("au {}", self.word),
            definite => format!("à {definite}"),
        }
    }
}

fn sketch(sketch: &Sketch) -> Caption {
    let title = match sketch.nouns.as_slice() {
        [] => "Schéma".to_owned(),
        nouns => {
            let nouns: Vec<&str> = nouns.iter().map(|noun| Noun::known(noun).word).collect();
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
        "moment" => a(&action.force),
        "force" | "normal force" | "reaction" | "friction" | "weight" => the(&action.force),
        link => {
            let label = plain(action.force.label.as_ref());
            let link = Noun::known(link).indefinite();
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
    format!("{}{label}", Noun::known(thing.noun).definite())
}

fn to(thing: &Thing) -> String {
    let label = plain(thing.label.as_ref());
    format!("{}{label}", Noun::known(thing.noun).behind_to())
}

fn a(thing: &Thing) -> String {
    let label = plain(thing.label.as_ref());
    format!("{}{label}", Noun::known(thing.noun).indefinite())
}

fn a_each(things: &[Thing]) -> Vec<String> {
    things.iter().map(a).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::element::Role;
    use crate::figure::story::Speaker as _;
    use crate::message::Language;

    #[test]
    fn french_has_a_noun_for_all_that_figures_show() {
        let roles = crate::figure::element::KINDS.iter().map(|kind| kind.role());
        let nouns = roles.filter_map(|role| match role {
            Role::Body(noun) | Role::Link(noun) | Role::Thing(noun) => Some(noun),
            Role::Ground | Role::Measure | Role::Mark => None,
        });
        // Grounds by where they lie, and the forces that free-body diagrams write.
        let others = [
            "floor",
            "ceiling",
            "wall on the left",
            "wall on the right",
            "normal force",
            "friction",
            "reaction",
            "weight",
        ];
        for noun in nouns.chain(others) {
            assert!(
                Noun::of(noun).is_some(),
                "`{noun}` has no French word: `Noun::of` needs a row for it"
            );
        }
    }

    #[test]
    fn pictures_are_worded_in_each_language() {
        let thing = |noun, letter| Thing {
            noun,
            label: Some(Math::letter(letter)),
        };
        let sketch = Story::Sketch(Sketch {
            nouns: vec!["block", "damper", "force"],
            bodies: vec![thing("block", 'm')],
            joints: vec![Joint {
                links: vec![thing("spring", 'k'), thing("damper", 'c')],
                ends: [
                    Some(thing("block", 'm')),
                    Some(Thing {
                        noun: "floor",
                        label: None,
                    }),
                ],
            }],
            forces: vec![(thing("force", 'F'), Some(thing("block", 'm')))],
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
            body: Some(thing("pulley", 'J')),
            actions: vec![
                Action {
                    force: thing("cord", 'S'),
                    sense: Sense::Towards(6),
                    velocity: None,
                },
                Action {
                    force: thing("friction", 'R'),
                    sense: Sense::Towards(0),
                    velocity: Some(Math::letter('v')),
                },
                Action {
                    force: thing("moment", 'M'),
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
