//! What pictures show, as data: a language words it for those who cannot see them.
//!
//! Things are called as their elements say it, in each language.

use super::element::Role;
use super::part::Part;
use super::schematic::Item;
use super::{Noun, Path, Point};
use crate::math::{Math, Voice};

/// What a picture shows.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Story {
    /// A schematic.
    Sketch(Sketch),
    /// Free-body diagrams, body by body.
    FreeBodies(Vec<FreeBody>),
    /// Curves between two axes.
    Curves(Curves),
    /// Mode shapes, the lowest frequency first.
    ModeShapes(Vec<Mode>),
    /// Pointers in the complex plane.
    Phasors {
        /// The pointers, in the order in which they are drawn.
        pointers: Vec<Pointer>,
        /// Angles between them: what stands at each, and how large it is.
        angles: Vec<(Option<Math>, String)>,
    },
}

/// The words of a picture.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Caption {
    /// What it is, in a few words.
    pub title: String,
    /// What it shows, for those who cannot see it.
    pub description: String,
}

/// Words what pictures show.
pub trait Speaker {
    /// The words of a picture.
    fn caption(&self, story: &Story) -> Caption;
}

/// An element of a schematic, by what it is and the letter at it.
#[derive(Clone, Debug, PartialEq)]
pub struct Thing {
    /// The words for it, such as `spring`.
    pub noun: Noun,
    /// What stands at it.
    pub label: Option<Math>,
}

/// What a schematic shows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sketch {
    /// The kinds of things in it, each once.
    pub nouns: Vec<Noun>,
    /// What stands or moves.
    pub bodies: Vec<Thing>,
    /// What joins them; links between the same two things are together.
    pub joints: Vec<Joint>,
    /// Forces and moments, each with what it acts on.
    pub forces: Vec<(Thing, Option<Thing>)>,
    /// What is measured, each once.
    pub marked: Vec<Math>,
}

/// Links between the same two things.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// Each spring, damper or other link between them.
    pub links: Vec<Thing>,
    /// What they end at.
    pub ends: [Option<Thing>; 2],
}

/// A body that is taken out of a schematic, with what acts on it.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeBody {
    /// The body; nothing where none of its elements has a name.
    pub body: Option<Thing>,
    /// The forces and moments.
    pub actions: Vec<Action>,
}

/// A force or a moment on a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Action {
    /// What exerts it, or what kind of force it is, and its letter.
    pub force: Thing,
    /// Where it points.
    pub sense: Sense,
    /// The velocity of whose sign it depends, if it is dry friction: it is drawn where that is positive.
    pub velocity: Option<Math>,
}

/// Where a force or a moment points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sense {
    /// Along the nearest of eight directions, counted counterclockwise from 0, to the right.
    Towards(u8),
    /// A moment in the plane of the drawing.
    Clockwise,
    /// A moment in the plane of the drawing, the other way.
    Counterclockwise,
    /// A moment about the line of a link that is twisted, in the sense of the twist.
    WithTwist,
    /// A moment about that line against the twist.
    AgainstTwist,
}

impl Sense {
    /// The nearest of the eight directions.
    pub(crate) fn along(direction: Point) -> Self {
        let eighths = direction.angle() / std::f64::consts::FRAC_PI_4;
        Self::Towards((eighths.round() as i64).rem_euclid(8) as u8)
    }
}

/// Curves between two axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Curves {
    /// What the axis upwards counts; may be empty.
    pub up: Math,
    /// What the axis to the right counts; may be empty.
    pub across: Math,
    /// From where to where the axis to the right goes, where that tells something.
    pub range: Option<[String; 2]>,
    /// Whether the axis to the right is logarithmic.
    pub is_logarithmic: bool,
    /// The curves of which something can be said.
    pub curves: Vec<DescribedCurve>,
    /// Marked points: what stands there, and where they are.
    pub marks: Vec<(Option<Math>, [String; 2])>,
}

/// What a curve does.
#[derive(Clone, Debug, PartialEq)]
pub struct DescribedCurve {
    /// What kind of line it is.
    pub kind: LineKind,
    /// What stands at it.
    pub label: Option<Math>,
    /// What its values do.
    pub behaviour: Behaviour,
}

/// What kind of line a curve is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineKind {
    /// The graph of a function.
    Curve,
    /// A line that others do not pass, or tend to.
    Limit,
    /// An edge of a band.
    Edge,
}

/// What values do from first to last.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Behaviour {
    /// All are alike.
    Constant(String),
    /// They go one way.
    Way {
        /// Whether they rise.
        rises: bool,
        /// The first and the last value.
        ends: [String; 2],
    },
    /// They turn once.
    Turn {
        /// Whether they rise at first.
        rises: bool,
        /// The first value, that of the turn, and the last.
        values: [String; 3],
    },
    /// They turn several times.
    Oscillation {
        /// The lowest and the highest value.
        between: [String; 2],
        /// What becomes of their swings.
        tendency: Tendency,
        /// How often they turn.
        turns: usize,
    },
}

/// What becomes of the swings of an oscillation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tendency {
    /// Each is smaller than the one before.
    Decays,
    /// Each is larger than the one before.
    Grows,
    /// None of the two holds for all of them.
    Neither,
}

/// A mode shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// What stands above it.
    pub heading: Math,
    /// The symbol of each coordinate, and its share.
    pub components: Vec<(Math, Math)>,
}

/// A pointer in the complex plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Pointer {
    /// What stands at it.
    pub label: Option<Math>,
    /// The magnitude, as it is printed.
    pub length: String,
    /// The angle from the real axis, as it is printed.
    pub angle: String,
    /// Whether it begins at the tip of the one before.
    pub is_joined: bool,
}

impl Thing {
    pub(crate) fn of(noun: Noun, part: &Part<'_>) -> Self {
        Self {
            noun,
            label: part.symbol.cloned(),
        }
    }

    /// What it is, with its letter.
    pub(crate) fn words(&self) -> String {
        let label = self.label.as_ref();
        let label = label.map_or_else(String::new, |label| label.spoken(Voice::ENGLISH));
        format!("{} {label}", self.noun.english)
            .trim_end()
            .to_owned()
    }
}

/// What the elements of a schematic show.
pub(crate) fn sketch(items: &[Item], parts: &[Part<'_>]) -> Sketch {
    let elements: Vec<(&Item, &Part<'_>)> = items.iter().zip(parts).collect();
    let mut sketch = Sketch {
        joints: joints(&elements),
        ..Sketch::default()
    };
    for (item, part) in &elements {
        match item.kind.role() {
            Role::Thing(noun @ (Noun::FORCE | Noun::MOMENT)) => {
                let end = part.ends.first();
                let on = end.and_then(|end| met(&elements, end.point, noun));
                sketch.forces.push((Thing::of(noun, part), on));
            }
            Role::Body(noun) | Role::Thing(noun) => sketch.bodies.push(Thing::of(noun, part)),
            Role::Measure => {
                let symbol = part
                    .symbol
                    .filter(|symbol| !sketch.marked.contains(symbol))
                    .cloned();
                sketch.marked.extend(symbol);
            }
            Role::Ground | Role::Link(_) | Role::Mark => {}
        }
        let noun = item.kind.role().noun();
        sketch
            .nouns
            .extend(noun.filter(|noun| !sketch.nouns.contains(noun)));
    }
    sketch
}

/// Links, those between the same two things together.
fn joints(elements: &[(&Item, &Part<'_>)]) -> Vec<Joint> {
    let mut joints: Vec<Joint> = Vec::new();
    for (item, part) in elements {
        let Role::Link(noun) = item.kind.role() else {
            continue;
        };
        let (Some(first), Some(last)) = (part.ends.first(), part.ends.last()) else {
            continue;
        };
        let mut ends = [first, last].map(|end| met(elements, end.point, noun));
        crate::numerics::sort_by(&mut ends, |one, other| {
            one.as_ref()
                .map(Thing::words)
                .cmp(&other.as_ref().map(Thing::words))
        });
        let link = Thing::of(noun, part);
        match joints.iter_mut().find(|known| known.ends == ends) {
            Some(joint) => joint.links.push(link),
            None => joints.push(Joint {
                links: vec![link],
                ends,
            }),
        }
    }
    joints
}

/// What lies at a point: a body, a bar or a ground.
fn met(elements: &[(&Item, &Part<'_>)], point: Point, except: Noun) -> Option<Thing> {
    // 1.2 mm in print: ends that look joined may lie a line's width apart.
    const NEAR: f64 = 0.12;
    let is_near_line = |part: &Part<'_>| {
        let (a, b) = (part.ends[0].point, part.ends[part.ends.len() - 1].point);
        let mut is_near = false;
        Path::line(a, b).for_each_segment(|a, b| is_near = distance(point, a, b) < NEAR);
        is_near
    };
    let body = elements.iter().find_map(|(item, part)| {
        let Role::Body(noun) = item.kind.role() else {
            return None;
        };
        let outline = item.kind.outline(part)?;
        let is_there = noun != except && outline.bounds().grown(NEAR).has(point);
        is_there.then(|| Thing::of(noun, part))
    });
    body.or_else(|| {
        elements.iter().find_map(|(item, part)| {
            let Role::Link(noun @ (Noun::BAR | Noun::ROD)) = item.kind.role() else {
                return None;
            };
            (noun != except && is_near_line(part)).then(|| Thing::of(noun, part))
        })
    })
    .or_else(|| {
        elements.iter().find_map(|(item, part)| {
            (item.kind.role() == Role::Ground && is_near_line(part)).then(|| ground(part))
        })
    })
}

/// A ground is called by where it lies.
fn ground(part: &Part<'_>) -> Thing {
    let out = -(part.ends[1].point - part.ends[0].point).unit().left();
    let noun = if out.y.abs() >= out.x.abs() {
        if out.y < 0.0 {
            Noun::FLOOR
        } else {
            Noun::CEILING
        }
    } else if out.x < 0.0 {
        Noun::LEFT_WALL
    } else {
        Noun::RIGHT_WALL
    };
    Thing { noun, label: None }
}

fn distance(point: Point, a: Point, b: Point) -> f64 {
    let way = b - a;
    let share = (point - a).dot(way) / way.dot(way).max(1e-12);
    point.distance(a + way * share.clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_the_nearest_of_eight() {
        let eighth = |x, y| Sense::along(Point::new(x, y));
        assert_eq!(eighth(0.1, 1.0), Sense::Towards(2));
        assert_eq!(eighth(-1.0, 0.0), Sense::Towards(4));
        assert_eq!(eighth(1.0, -1.0), Sense::Towards(7));
    }
}
