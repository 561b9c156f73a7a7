//! What pictures show.

use super::listed;
use crate::figure::Noun;
use crate::figure::story::{
    Action, Behaviour, Caption, Curves, DescribedCurve, FreeBody, Joint, LineKind, Mode, Pointer,
    Sense, Sketch, Story, Tendency, Thing,
};
use crate::math::{Math, Voice};
use crate::source::capital;

/// The words of a picture.
pub(crate) fn caption(story: &Story) -> Caption {
    match story {
        Story::Sketch(sketch) => self::sketch(sketch),
        Story::FreeBodies(bodies) => free_bodies(bodies),
        Story::Curves(curves) => self::curves(curves),
        Story::ModeShapes(modes) => mode_shapes(modes),
        Story::Phasors { pointers, angles } => phasors(pointers, angles),
    }
}

fn sketch(sketch: &Sketch) -> Caption {
    let title = match sketch.nouns.as_slice() {
        [] => "Sketch".to_owned(),
        nouns => {
            let nouns: Vec<&str> = nouns.iter().map(|noun| noun.english).collect();
            format!("Sketch: {}", listed(&nouns))
        }
    };
    let mut sentences = Vec::new();
    if !sketch.bodies.is_empty() {
        sentences.push(listed(&a_each(&sketch.bodies)));
    }
    sentences.extend(sketch.joints.iter().map(joint));
    for (force, on) in &sketch.forces {
        let on = on.as_ref();
        let on = on.map_or_else(String::new, |on| format!(" acts on {}", the(on)));
        sentences.push(format!("{}{on}", a(force)));
    }
    let marked: Vec<String> = sketch.marked.iter().map(heard).collect();
    match marked.as_slice() {
        [] => {}
        [one] => sentences.push(format!("marked is {one}")),
        several => sentences.push(format!("marked are {}", listed(several))),
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
        "join"
    } else {
        "joins"
    };
    match &joint.ends {
        [Some(one), Some(other)] if one != other => {
            format!("{links} {verb} {} to {}", the(one), the(other))
        }
        [Some(one), _] | [None, Some(one)] => format!("{links} at {}", the(one)),
        [None, None] => links,
    }
}

fn free_bodies(bodies: &[FreeBody]) -> Caption {
    let title = match bodies {
        [_] => "Free-body diagram",
        _ => "Free-body diagrams",
    };
    let sentences: Vec<String> = bodies.iter().map(free_body).collect();
    Caption {
        title: title.to_owned(),
        description: sentences.join(" "),
    }
}

fn free_body(own: &FreeBody) -> String {
    let body = own.body.as_ref().map_or_else(|| "the body".to_owned(), the);
    let actions: Vec<String> = own.actions.iter().map(action).collect();
    match actions.as_slice() {
        [] => format!("Nothing acts on {body}."),
        [one] => format!("On {body} acts {one}."),
        several => format!("On {body} act {}.", listed(several)),
    }
}

fn action(action: &Action) -> String {
    let force = match action.force.noun {
        Noun::MOMENT => a(&action.force),
        Noun::FORCE | Noun::NORMAL_FORCE | Noun::REACTION | Noun::FRICTION | Noun::WEIGHT => {
            the(&action.force)
        }
        link => {
            let link = indefinite(link);
            let label = spoken(action.force.label.as_ref());
            match action.sense {
                Sense::WithTwist | Sense::AgainstTwist => {
                    format!("the moment{label} of {link},")
                }
                _ => format!("the force of {link}{label}"),
            }
        }
    };
    let sense = match action.sense {
        Sense::Towards(eighth) => towards(eighth),
        Sense::Clockwise => "clockwise",
        Sense::WithTwist => "in the sense of the twist",
        Sense::AgainstTwist => "against the sense of the twist",
        Sense::Counterclockwise => "counterclockwise",
    };
    let when = action.velocity.as_ref();
    let when = when.map_or_else(String::new, |velocity| {
        format!(" (where {} is positive)", velocity.spoken(Voice::ENGLISH))
    });
    format!("{force} {sense}{when}")
}

fn towards(eighth: u8) -> &'static str {
    match eighth {
        0 => "to the right",
        1 => "up and to the right",
        2 => "upwards",
        3 => "up and to the left",
        4 => "to the left",
        5 => "down and to the left",
        6 => "downwards",
        _ => "down and to the right",
    }
}

fn curves(curves: &Curves) -> Caption {
    let (up, across) = (curves.up.plain(), curves.across.plain());
    let title = match (up.is_empty(), across.is_empty()) {
        (false, false) => format!("{up} against {across}"),
        (false, true) => up,
        (true, false) => format!("Plot against {across}"),
        (true, true) => "Plot".to_owned(),
    };
    let mut description = title.clone();
    if let Some([from, to]) = &curves.range {
        description += &format!(", from {from} to {to}");
    }
    if curves.is_logarithmic {
        description += " (logarithmic)";
    }
    description.push('.');
    for own in &curves.curves {
        description += &format!(" {}.", curve(own));
    }
    for (label, [across, up]) in &curves.marks {
        let label = label.as_ref().map_or_else(String::new, |label| {
            let label = label.plain();
            if label.is_empty() {
                label
            } else {
                format!(", {label}")
            }
        });
        description += &format!(" Marked{label}: {across}, {up}.");
    }
    Caption { title, description }
}

fn curve(curve: &DescribedCurve) -> String {
    let label = curve.label.as_ref().map(Math::plain).unwrap_or_default();
    let label = if label.is_empty() {
        label
    } else {
        format!(" {label}")
    };
    let line = match (curve.kind, label.is_empty()) {
        (LineKind::Curve, _) => format!("Curve{label}"),
        (LineKind::Limit, _) => format!("Limit{label}"),
        (LineKind::Edge, true) => "Edge of a band".to_owned(),
        (LineKind::Edge, false) => format!("Edge of{label}"),
    };
    let verb = |rises| if rises { "rises" } else { "falls" };
    match &curve.behaviour {
        Behaviour::Constant(value) => format!("{line} is constant at {value}"),
        Behaviour::Way {
            rises,
            ends: [from, to],
        } => format!("{line} {} from {from} to {to}", verb(*rises)),
        Behaviour::Turn {
            rises,
            values: [from, turn, to],
        } => format!(
            "{line} {} from {from} to {turn}, then {} to {to}",
            verb(*rises),
            verb(!rises)
        ),
        Behaviour::Oscillation {
            between: [low, high],
            tendency,
            turns,
        } => {
            let tendency = match tendency {
                Tendency::Decays => " and decays",
                Tendency::Grows => " and grows",
                Tendency::Neither => "",
            };
            format!(
                "{line} oscillates between {low} and {high}{tendency}, with {turns} turning points"
            )
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
        format!("Mode {}, {heading}: {}.", place + 1, components.join(", "))
    });
    Caption {
        title: "Mode shapes".to_owned(),
        description: sentences.collect::<Vec<_>>().join(" "),
    }
}

fn phasors(pointers: &[Pointer], angles: &[(Option<Math>, String)]) -> Caption {
    let title = "Phasor diagram";
    let mut description = format!("{title}.");
    for own in pointers {
        let label = own.label.as_ref().map(Math::plain).unwrap_or_default();
        let place = if own.is_joined {
            ", from the tip of the one before"
        } else {
            ""
        };
        let Pointer { length, angle, .. } = own;
        description += &format!(" Phasor {label}: {length} at {angle}{place}.");
    }
    for (label, size) in angles {
        let label = label.as_ref().map(Math::plain).unwrap_or_default();
        description += &format!(" Angle {label}: {size}.");
    }
    Caption {
        title: title.to_owned(),
        description,
    }
}

fn heard(math: &Math) -> String {
    math.spoken(Voice::ENGLISH)
}

/// A letter as it is spoken of, after a noun.
fn spoken(label: Option<&Math>) -> String {
    match label.map(heard).unwrap_or_default() {
        words if words.is_empty() => words,
        words => format!(" {words}"),
    }
}

fn the(thing: &Thing) -> String {
    format!("the {}{}", thing.noun.english, spoken(thing.label.as_ref()))
}

fn a(thing: &Thing) -> String {
    let label = spoken(thing.label.as_ref());
    format!("{}{label}", indefinite(thing.noun))
}

fn a_each(things: &[Thing]) -> Vec<String> {
    things.iter().map(a).collect()
}

fn indefinite(noun: Noun) -> String {
    let is_vowel = noun.english.starts_with(['a', 'e', 'i', 'o', 'u']);
    let article = if is_vowel { "an" } else { "a" };
    format!("{article} {}", noun.english)
}
