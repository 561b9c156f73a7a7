//! A figure in another position: what moves as a whole, what is stretched, and what stays.

use crate::figure::element::{Layer, Role};
use crate::figure::outline::{Outline, OutlineForm, turned};
use crate::figure::part::{Part, Setting};
use crate::figure::schematic::{ElementPlace, Item};
use crate::figure::{DrawnPath, Path, Point};

/// How far from the outline of a body a link may end that is fastened to it.
const TOUCH: f64 = 0.06;

/// How far from the middle line of a bar or rod a link may end that is fastened to it.
const BESIDE: f64 = 0.13;

/// A turn about a point, and a shift.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Rigid {
    /// The point of the figure that it moves.
    pub(crate) slot: Option<u32>,
    pub(crate) shift: Point,
    pub(crate) turn: f64,
    /// Where the centre is at rest.
    pub(crate) about: Point,
}

/// What becomes of an element.
pub(crate) enum Pose<'f> {
    Still,
    /// It is drawn as at rest, and moved as a whole.
    Rigid(Rigid),
    /// It is drawn anew between its moved ends.
    Stretched(Part<'f>),
    /// It measures what is elsewhere now.
    Gone,
}

/// Where everything is at rest, and how its points have moved.
pub(crate) struct Poses<'a, 'f> {
    pub(crate) items: &'a [Item],
    pub(crate) rest: &'a [Part<'f>],
    pub(crate) moved: &'a [Rigid],
    /// Where the moving points are at rest.
    pub(crate) places: &'a [Point],
    /// Whether what measures moving points is left out.
    pub(crate) hides: bool,
}

/// A straight body between two points, at rest and moved.
struct Beam {
    rest: [Point; 2],
    moved: [Point; 2],
}

impl Rigid {
    pub(crate) fn point(&self, rest: Point) -> Point {
        if self.turn == 0.0 {
            return rest + self.shift;
        }
        self.about + turned(rest - self.about, self.turn) + self.shift
    }

    /// The same without its turn, for what a point carries along upright.
    fn carrying(&self, rest: Point) -> Self {
        Self {
            shift: self.point(rest) - rest,
            turn: 0.0,
            about: rest,
            ..*self
        }
    }

    fn outline(&self, rest: Outline) -> Outline {
        let form = match rest.form {
            OutlineForm::Box { half, angle } => OutlineForm::Box {
                half,
                angle: angle + self.turn,
            },
            round @ OutlineForm::Round { .. } => round,
        };
        Outline {
            centre: self.point(rest.centre),
            form,
            ..rest
        }
    }

    pub(crate) fn mark(&self, mark: &mut DrawnPath) {
        if self.turn != 0.0 || self.shift != Point::default() {
            mark.path = self.path(&mark.path);
        }
    }

    fn path(&self, path: &Path) -> Path {
        path.mapped(|point| self.point(point), self.turn)
    }
}

impl<'f> Poses<'_, 'f> {
    /// What becomes of each element.
    pub(crate) fn all(&self) -> Vec<Pose<'f>> {
        let beams = self.beams();
        let items = self.items.iter().zip(self.rest);
        items
            .map(|(item, part)| self.pose(item, part, &beams))
            .collect()
    }

    /// How a place moves that says itself where it belongs.
    fn of_place(&self, place: &ElementPlace) -> Option<&Rigid> {
        let slot = place.slot()?;
        self.moved.iter().find(|rigid| rigid.slot == Some(slot))
    }

    /// How a place moves by its name, or since a moving point lies there.
    fn of_point(&self, place: &ElementPlace, rest: Point) -> Option<&Rigid> {
        self.of_place(place).or_else(|| {
            let mut points = self.places.iter().zip(self.moved);
            let found = points.find(|(own, _)| own.distance(rest) < 1e-6);
            found.map(|(_, rigid)| rigid)
        })
    }

    fn pose(&self, item: &Item, part: &Part<'f>, beams: &[Beam]) -> Pose<'f> {
        let role = item.kind.role();
        if let [place] = item.ends.as_slice() {
            let rest = part.ends[0].point;
            let own = self.of_point(place, rest).copied();
            return match (role, own) {
                (Role::Body(_), Some(rigid)) => Pose::Rigid(rigid),
                (Role::Measure, _) if item.kind.name() != "radius" => Pose::Still,
                (_, Some(rigid)) => Pose::Rigid(rigid.carrying(part.point())),
                (Role::Thing(_) | Role::Mark, None) if matches!(place, ElementPlace::Free(_)) => {
                    match self.touched(part.point(), false) {
                        Some(rigid) => Pose::Rigid(rigid.carrying(part.point())),
                        None => Pose::Still,
                    }
                }
                _ => Pose::Still,
            };
        }
        // Walls and dashed lines may pass a moving body without being fastened to it.
        let is_link = matches!(role, Role::Link(_));
        let is_bound = is_link || item.kind.layer() != Layer::Support;
        let is_cord = item.kind.name() == "cord";
        let mut stretched = part.clone();
        let (mut is_moved, mut is_held) = (false, false);
        for (place, end) in item.ends.iter().zip(&mut stretched.ends) {
            let rest = end.point;
            let own = if is_bound {
                self.of_point(place, rest)
            } else {
                self.of_place(place)
            };
            if let Some(rigid) = own {
                is_moved = true;
                end.point = rigid.point(rest);
                end.body = end.body.map(|body| rigid.outline(body));
                end.out = end.out.map(|out| turned(out, rigid.turn));
                continue;
            }
            if is_link && let Some(point) = self.fastened(rest, is_cord, beams) {
                is_moved |= point != rest;
                end.point = point;
            } else {
                is_held = true;
            }
        }
        match (is_moved, role) {
            (false, _) => Pose::Still,
            // A line of reference at a moving point would point elsewhere.
            (true, Role::Mark) if is_held && self.hides => Pose::Gone,
            (true, Role::Measure) if self.hides => Pose::Gone,
            (true, Role::Measure) => Pose::Still,
            (true, _) => {
                if let Some((key, length)) = item.kind.kept(part) {
                    stretched.settings.push((key, Setting::Number(length)));
                }
                Pose::Stretched(stretched)
            }
        }
    }

    /// Where the end of a link goes that does not name what it is fastened to.
    fn fastened(&self, rest: Point, is_cord: bool, beams: &[Beam]) -> Option<Point> {
        if let Some(rigid) = self.touched(rest, is_cord) {
            return Some(rigid.point(rest));
        }
        beams.iter().find_map(|beam| beam.carry(rest))
    }

    /// The motion of the body at whose outline a point lies. A cord leaves a disk where it touches it, however it turns.
    fn touched(&self, point: Point, is_cord: bool) -> Option<Rigid> {
        let items = self.items.iter().zip(self.rest);
        items.into_iter().find_map(|(item, part)| {
            let (Role::Body(_), [place]) = (item.kind.role(), item.ends.as_slice()) else {
                return None;
            };
            let rigid = self.of_place(place)?;
            let outline = item.kind.outline(part)?;
            let is_round = matches!(outline.form, OutlineForm::Round { .. });
            outline
                .is_near(point, TOUCH)
                .then_some(if is_cord && is_round {
                    Rigid {
                        turn: 0.0,
                        ..*rigid
                    }
                } else {
                    *rigid
                })
        })
    }

    /// Bars and rods with a moving end.
    fn beams(&self) -> Vec<Beam> {
        let items = self.items.iter().zip(self.rest);
        let stiff = items.filter(|(item, _)| {
            item.kind.name() == "rod"
                || (item.kind.layer() == Layer::Body && matches!(item.kind.role(), Role::Link(_)))
        });
        let beams = stiff.filter_map(|(item, part)| {
            let (first, last) = (item.ends.first()?, item.ends.last()?);
            let rest = [part.ends[0].point, part.ends[part.ends.len() - 1].point];
            let own = [self.of_point(first, rest[0]), self.of_point(last, rest[1])];
            if own == [None, None] {
                return None;
            }
            let moved =
                [0, 1].map(|at: usize| own[at].map_or(rest[at], |rigid| rigid.point(rest[at])));
            Some(Beam { rest, moved })
        });
        beams.collect()
    }
}

impl Beam {
    /// Where a point goes that lies on it.
    fn carry(&self, point: Point) -> Option<Point> {
        let [a, b] = self.rest;
        let (way, length) = ((b - a).unit(), a.distance(b));
        let (along, beside) = ((point - a).dot(way), way.cross(point - a));
        if along < -BESIDE || along > length + BESIDE || beside.abs() > BESIDE || length < 1e-9 {
            return None;
        }
        let [c, d] = self.moved;
        Some(c.towards(d, along / length) + (d - c).unit().left() * beside)
    }
}
