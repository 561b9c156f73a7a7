//! Free-body diagrams: bodies taken out of the figure of an item, each force that acts on them as an arrow.
//!
//! A body of `[figure.free]` keeps the elements that bear its name. What joined it to the rest is cut, and each link
//! leaves an arrow along itself; contacts, reactions and weights are written. Which letter an arrow bears and in which
//! sense it points follows from the force of this name in the model: an arrow does the work that the model's force does,
//! and one that is none of the model's does no work.

mod arrows;
mod company;
mod drawn;
mod error;
mod letter;
mod read;
mod work;

pub use error::{FreeError, FreeFault};
pub(crate) use read::FreeReader;

use super::formula::{Amount, FigurePair};
use super::schematic::{ElementPlace, Item};
use super::story::{Caption, Speaker, Story};
use super::{Drawing, Figure, FigureData, FigureLabel, Noun, Picture};
use crate::expr::Name;
use crate::math::Math;
use crate::source::Span;

/// A body of the model of an item, with what acts on it.
#[derive(Clone, Debug)]
pub struct Acting {
    /// Its name.
    pub body: Name,
    /// The displacements and angles by which it moves.
    pub moves: Vec<Move>,
    /// Its forces, each with a component for each move.
    pub forces: Vec<(Name, Vec<crate::expr::Expr>)>,
}

/// A displacement or angle of a body.
#[derive(Clone, Debug)]
pub struct Move {
    /// The coordinate or kinematic name.
    pub name: Name,
    /// Whether it is an angle.
    pub is_turn: bool,
}

/// The free-body diagrams of a figure.
#[derive(Debug)]
pub(crate) struct Free {
    bodies: Vec<CutBody>,
}

impl Free {
    pub(crate) fn is_empty(&self) -> bool {
        self.bodies.is_empty()
    }
}

/// A body that is taken out.
#[derive(Debug)]
struct CutBody {
    name: String,
    /// Its elements, as places among the items of the figure.
    kept: Vec<usize>,
    /// How far it is moved aside in the drawing.
    shift: Option<FigurePair>,
    motions: Vec<BodyMotion>,
    forces: Vec<Force>,
    /// Arrows of forces that the model does not have, since they do no work.
    idle: Vec<WrittenArrow>,
    span: Span,
}

/// A way in which a body can move.
#[derive(Debug)]
enum BodyMotion {
    /// All its points along a direction.
    Along(Heading),
    /// About a point, counterclockwise if true.
    Turn(ElementPlace, TurnSense),
}

/// A direction.
#[derive(Debug)]
enum Heading {
    /// That of a coordinate or arrow of the figure.
    Shown(usize),
    Written(FigurePair),
}

/// The positive sense of an angle.
#[derive(Debug)]
enum TurnSense {
    /// That of a turn of the figure.
    Shown(usize),
    /// Counterclockwise if true.
    Written(bool),
}

/// A force of the model, and its arrow.
#[derive(Debug)]
struct Force {
    name: Name,
    /// For each motion whether the component is negative; nothing if there is none.
    signs: Vec<Option<bool>>,
    source: ForceOrigin,
    /// The velocity whose sign it has, if it is dry friction.
    velocity: Option<Math>,
}

/// Where the arrow of a force comes from.
#[derive(Debug)]
enum ForceOrigin {
    /// Links that are cut.
    Links {
        links: Vec<(usize, Strand)>,
        letter: Letter,
    },
    /// A force or moment that the figure shows.
    Shown(usize),
    /// Written in the diagram.
    Written(WrittenArrow),
}

/// Which ends of a link at a body are meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Strand {
    All,
    First,
    Last,
}

/// A letter, set and as a formula, for one arrow and for each of two.
#[derive(Debug)]
struct Letter {
    one: (FigureLabel, Math),
    each: (FigureLabel, Math),
}

/// An arrow that is written.
#[derive(Debug)]
struct WrittenArrow {
    kind: Contact,
    /// It stands in the figure as if it were an element, so that it knows the side of the body.
    item: Item,
    label: (FigureLabel, Math),
    direction: Option<FigurePair>,
    /// The share of it along the first motion, where its letter is not that of the model.
    share: Option<Amount>,
}

/// What a written arrow is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Contact {
    Normal,
    Friction,
    Reaction,
    Weight,
}

impl Contact {
    const ALL: [(&'static str, Self); 4] = [
        ("normal", Self::Normal),
        ("friction", Self::Friction),
        ("reaction", Self::Reaction),
        ("weight", Self::Weight),
    ];

    fn noun(self) -> Noun {
        match self {
            Self::Normal => Noun::NORMAL_FORCE,
            Self::Friction => Noun::FRICTION,
            Self::Reaction => Noun::REACTION,
            Self::Weight => Noun::WEIGHT,
        }
    }
}

/// The drawing of the free-body diagrams for these data.
///
/// # Errors
///
/// [`FreeError`]: an arrow and the model do not agree, or an element has no place.
pub fn draw_free(figure: &Figure, given: &dyn FigureData) -> Result<Drawing, FreeError> {
    arrows::resolved(figure, given).map(|(drawing, _)| drawing)
}

/// The picture of the free-body diagrams for these data, worded by a speaker; `id` begins all identities in it.
///
/// # Errors
///
/// As [`draw_free`].
pub fn free_picture(
    figure: &Figure,
    given: &dyn FigureData,
    id: &str,
    speaker: &dyn Speaker,
) -> Result<Picture, FreeError> {
    let (drawing, bodies) = arrows::resolved(figure, given)?;
    let Caption { title, description } = speaker.caption(&Story::FreeBodies(bodies));
    let svg = drawing.svg(&super::Head {
        id,
        title: &title,
        description: &description,
    });
    let (width, height) = drawing.size();
    Ok(Picture {
        svg,
        alt: description,
        width,
        height,
    })
}
