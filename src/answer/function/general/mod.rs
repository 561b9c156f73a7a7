//! The general solution of a model's equations, with free constants that the student names.
//!
//! A response is right when it satisfies the equations for all values of its constants, and the constants
//! can meet any initial state: each is a factor or a phase, and the positions and velocities at the start,
//! as functions of the constants, have full rank.

mod complex;
mod constants;
mod equations;
mod marker;
mod read;
mod solution;

use std::sync::Arc;

use self::marker::Prepared;
use crate::answer::letters::Allowed;
use crate::answer::meaning::{Meaning, ORDERS, Prefer};
use crate::answer::{Answer, Asked, Blank, Context, Declare, Marker, Role};
use crate::expr::{Equation, Expr, Kind, Name};
use crate::math::Math;
use crate::quantity::{Absent, NodeId};
use crate::response::Lexicon;
use crate::source::{Table, Text};

/// Letters that people give to constants, alone or with a number: all but those of time, of e and of i.
const LETTERS: &str = "A B C D E F G H J K L M N O P Q R S T U V W X Y Z a b c d f g h k l m n p q r s u v w x y z \
    phi psi alpha beta delta theta gamma epsilon eta chi";
/// What those write who cannot use C and D, as in Mathematica.
const DOUBLED: &str = "AA BB CC DD";
/// A letter that is a constant, or the imaginary unit as programs write it: which is seen from where it stands.
const DOUBTFUL: &str = "I";
/// Highest number after such a letter.
const MAX_NUMBERED: usize = 6;

#[derive(Debug)]
pub(crate) struct General(Arc<Setup>);

#[derive(Debug)]
pub(crate) struct Setup {
    equations: Vec<Equation>,
    coordinates: Vec<Name>,
    symbols: Vec<Math>,
    constants: Vec<Name>,
    /// Where their values stand in a point.
    slots: Vec<usize>,
    frequencies: Option<NodeId>,
    shapes: Option<NodeId>,
    meaning: Meaning,
    lexicon: Lexicon,
    /// With the letter that may be a constant or the imaginary unit among the constants.
    with_doubtful: Option<Lexicon>,
    /// The letters of its answer line.
    letters: Vec<Expr>,
}

impl Setup {
    /// The slot of a name in a point.
    fn slot(&self, name: &Name) -> Option<usize> {
        Some(self.meaning.place(name)? * ORDERS)
    }
}

/// Reads a part that asks for a general solution.
pub(crate) fn read(
    part: &Table<'_>,
    key: &Text,
    components: &[Text],
    declare: &mut dyn Declare,
) -> Option<Box<dyn Answer>> {
    let of = |quantity: &str| Text {
        value: key.value.replace("general_motion", quantity),
        span: key.span,
    };
    let equations = declare.equations(&of("equations"))?;
    let known = declare.known();
    let is_asked = |name: &Name| {
        components.is_empty() || components.iter().any(|text| text.value == name.as_str())
    };
    let coordinates: Vec<_> = known
        .iter()
        .filter(|own| own.role == Role::Coordinate && is_asked(&own.name))
        .collect();
    let mut meaning = Meaning::of(declare, Prefer::Coordinates);
    let allowed = Allowed::read(part, declare, None, true)?;
    let mut letters = allowed.letters();
    letters.retain(|letter| match letter.kind() {
        Kind::Name(name) => !allowed.lexicon.is_moving(name),
        _ => true,
    });
    let mut lexicon = allowed.lexicon;
    let listed = part.texts("in");
    // What is neither printed nor needed is free to be used.
    let is_taken = |name: &Name| {
        let own = known.iter().find(|own| own.name == *name);
        let is_shown = own.is_some_and(|own| !matches!(own.role, Role::Quantity { .. }));
        let mut names = equations
            .iter()
            .flat_map(|of| [of.left.names(), of.right.names()]);
        is_shown
            || listed.iter().any(|text| text.value == name.as_str())
            || own.is_some() && names.any(|names| names.uses(name))
    };
    let numbered = LETTERS.split_whitespace().flat_map(|letter| {
        (0..=MAX_NUMBERED).map(move |number| match number {
            0 => letter.to_owned(),
            number => format!("{letter}{number}"),
        })
    });
    let all = numbered.chain(DOUBLED.split_whitespace().map(str::to_owned));
    // `w1` stays ω₁. All are asked for before any is added: what people type is made out anew for each lexicon.
    let free = all.map(Name::new).filter(|name| {
        !is_taken(name) && lexicon.reads(name.as_str()).is_none_or(|own| *own == *name)
    });
    let mut constants: Vec<Name> = free.collect();
    let doubtful = Name::new(DOUBTFUL);
    let is_free = !is_taken(&doubtful) && lexicon.reads(DOUBTFUL).is_none();
    for name in &constants {
        meaning.add_free(name);
        lexicon.allow(name, crate::math::symbol(name.as_str()), false);
    }
    lexicon.allow(&Name::new("t"), crate::math::symbol("t"), false);
    let with_doubtful = is_free.then(|| {
        meaning.add_free(&doubtful);
        constants.push(doubtful.clone());
        lexicon.with(&doubtful, crate::math::symbol(DOUBTFUL))
    });
    letters.retain(|letter| {
        !constants
            .iter()
            .any(|own| *letter == Expr::name(own.clone()))
    });
    let places = constants.iter().filter_map(|name| meaning.place(name));
    let slots = places.map(|place| place * ORDERS).collect();
    let frequencies = declare.formula("frequencies", &of("natural_angular_frequencies"));
    let shapes = declare.formula("shapes", &of("mode_shapes"));
    Some(Box::new(General(Arc::new(Setup {
        equations,
        coordinates: coordinates.iter().map(|own| own.name.clone()).collect(),
        symbols: coordinates
            .iter()
            .map(|own| Math::clone(&own.symbol))
            .collect(),
        constants,
        slots,
        frequencies,
        shapes,
        meaning,
        lexicon,
        with_doubtful,
        letters,
    }))))
}

impl Answer for General {
    fn kind(&self) -> crate::answer::AnswerKind {
        crate::answer::AnswerKind::Function
    }

    fn blank(&self) -> Blank {
        Blank::of(Asked::GeneralSolution).with_letters(&self.0.letters, &self.0.lexicon)
    }

    fn keys(&self) -> Vec<NodeId> {
        Vec::new()
    }

    fn prepare<'t>(&self, context: &Context<'t>) -> Result<Box<dyn Marker + 't>, Absent> {
        let setup = &self.0;
        let value =
            |node: Option<NodeId>| node.and_then(|node| context.evaluation.value(node).ok());
        let modes = match (value(setup.frequencies), value(setup.shapes)) {
            (Some(frequencies), Some(shapes)) => {
                let rows = shapes.numbers().chunks(setup.coordinates.len().max(1));
                frequencies
                    .numbers()
                    .iter()
                    .copied()
                    .zip(rows.map(<[f64]>::to_vec))
                    .collect()
            }
            _ => Vec::new(),
        };
        Ok(Box::new(Prepared {
            setup: Arc::clone(setup),
            data: setup.meaning.data(&context.evaluation),
            modes,
        }))
    }
}
