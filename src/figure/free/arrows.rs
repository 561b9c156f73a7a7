//! From the forces of a body to arrows, for certain data.

use super::drawn::{Arrow, Drawn, Way};
use super::error::{FreeError, FreeFault};
use super::work::{Moved, SQUARE, agrees, fault, sense, twisted, works};
use super::{
    BodyMotion, Contact, CutBody, Force, ForceOrigin, Heading, Letter, Strand, TurnSense,
    WrittenArrow,
};
use crate::figure::element::{Role, turn};
use crate::figure::formula::FigureValues;
use crate::figure::part::Part;
use crate::figure::schematic::Item;
use crate::figure::story::{self, Action, FreeBody, Thing};
use crate::figure::{Drawing, Figure, FigureData, Noun, Outline, Point};
use crate::math::Math;

/// Length of an arrow.
const LENGTH: f64 = 1.05;

/// Least length of an arrow at a short link.
const MIN_LENGTH: f64 = 0.6;

/// How near to a body a link ends that is fastened to it: half of the breadth of a bar and a little.
const NEAR: f64 = 0.12;

/// Arrows at one axle are nearer to each other than the links were: this share of their distance.
const CLOSE: f64 = 0.4;

/// A figure with numbers: the parts of its elements, then those of the arrows that are written.
struct NumberedFigure<'f> {
    figure: &'f Figure,
    items: Vec<&'f Item>,
    parts: Vec<Part<'f>>,
    values: FigureValues,
}

/// Where a link was fastened to a body.
struct Cut {
    /// The point at which it acts.
    at: Point,
    /// The point at which its arrow begins.
    drawn: Point,
    /// Out of the body, along the link.
    out: Point,
    /// The length of the straight piece there.
    length: f64,
}

/// The drawing, and what it says of each body.
pub(crate) fn resolved(
    figure: &Figure,
    given: &dyn FigureData,
) -> Result<(Drawing, Vec<FreeBody>), FreeError> {
    let written = figure.free.bodies.iter().flat_map(CutBody::written);
    let items: Vec<&Item> = figure
        .items
        .iter()
        .chain(written.map(|written| &written.item))
        .collect();
    let span = figure.free.bodies.first().map(|body| body.span);
    let parts = figure.parts_of(&items, given).map_err(|error| FreeError {
        fault: FreeFault::Undrawable(error),
        span: span.unwrap_or(crate::source::Span::NONE),
    })?;
    let scene = NumberedFigure {
        figure,
        parts,
        values: figure.values(given),
        items,
    };
    let mut drawing = Drawing::new();
    let mut bodies = Vec::new();
    let mut owner = figure.items.len() as u32;
    for body in &figure.free.bodies {
        let drawn = scene.arrows(body).map_err(|fault| FreeError {
            fault,
            span: body.span,
        })?;
        scene.draw(body, &drawn, &mut owner, &mut drawing);
        bodies.push(FreeBody {
            body: scene.named(body),
            actions: drawn.actions,
        });
    }
    drawing.settle();
    Ok((drawing, bodies))
}

impl CutBody {
    fn written(&self) -> impl Iterator<Item = &WrittenArrow> {
        let origins = self.forces.iter().filter_map(|force| match &force.source {
            ForceOrigin::Written(written) => Some(written),
            ForceOrigin::Links { .. } | ForceOrigin::Shown(_) => None,
        });
        origins.chain(&self.idle)
    }
}

impl<'f> NumberedFigure<'f> {
    fn arrows(&self, body: &'f CutBody) -> Result<Drawn<'f>, FreeFault> {
        let moved: Vec<Moved> = body
            .motions
            .iter()
            .map(|motion| self.moved(motion))
            .collect();
        let mut drawn = Drawn::default();
        for force in &body.forces {
            match &force.source {
                ForceOrigin::Links { links, letter } => {
                    self.linked(body, force, &moved, (links.as_slice(), letter), &mut drawn)?;
                }
                ForceOrigin::Shown(item) => {
                    self.shown(body, force, &moved, *item, &mut drawn)?;
                }
                ForceOrigin::Written(written) => {
                    let part = self.written(written);
                    let base = self.direction(written, part, &moved);
                    let at = part.point();
                    // Friction is written without a direction: it is along the motion.
                    let direction =
                        if written.direction.is_none() && written.kind == Contact::Friction {
                            base * sense(body, force, &moved, at, base)?
                        } else {
                            base
                        };
                    let share = written
                        .share
                        .as_ref()
                        .map(|share| self.values.amount(share));
                    works(body, force, &moved, at, direction, share)?;
                    drawn.arrows.push(Self::contact(written, part, direction));
                    let along = story::Sense::along(direction);
                    drawn.actions.push(Action {
                        velocity: force.velocity.clone(),
                        ..action(written.kind.noun(), &written.label.1, along)
                    });
                }
            }
        }
        for written in &body.idle {
            let part = self.written(written);
            let direction = self.direction(written, part, &moved);
            let is_idle = moved
                .iter()
                .all(|motion| motion.work(part.point(), direction).abs() < SQUARE);
            if !is_idle {
                return Err(FreeFault::Idle {
                    body: body.name.clone(),
                    arrow: written.kind.noun().english,
                });
            }
            drawn.arrows.push(Self::contact(written, part, direction));
            let along = story::Sense::along(direction);
            let action = action(written.kind.noun(), &written.label.1, along);
            drawn.actions.push(action);
        }
        self.hold_links(body)?;
        Ok(drawn)
    }

    /// A force of links that were cut: an arrow along each.
    fn linked(
        &self,
        body: &CutBody,
        force: &'f Force,
        moved: &[Moved],
        (links, letter): (&[(usize, Strand)], &'f Letter),
        drawn: &mut Drawn<'f>,
    ) -> Result<(), FreeFault> {
        let mut cuts = Vec::new();
        for (item, strand) in links {
            let own = self.cuts(body, *item, *strand);
            if own.is_empty() {
                return Err(FreeFault::Apart {
                    body: body.name.clone(),
                    link: self.link(*item),
                });
            }
            cuts.extend(own.into_iter().map(|cut| (self.noun(*item), cut)));
        }
        let (label, letter) = match cuts.len() {
            1 => &letter.one,
            2 => &letter.each,
            _ => return Err(fault(body, force)),
        };
        for (noun, cut) in cuts {
            let Cut {
                at,
                drawn: start,
                out,
                length,
            } = cut;
            if let Some((axis, sense)) = twisted(body, force, moved, out)? {
                drawn.twist(start, out, (axis, &sense), label);
                drawn.actions.push(action(noun, letter, sense));
                continue;
            }
            let sense = sense(body, force, moved, at, out)?;
            let direction = out * sense;
            works(body, force, moved, at, direction, None)?;
            let is_push = sense < 0.0;
            if is_push && noun == Noun::CORD {
                return Err(FreeFault::Push {
                    body: body.name.clone(),
                    force: force.name.to_string(),
                });
            }
            // Half of a link between two bodies that are cut is left to the arrow of the other.
            let end = start + out * (0.42 * length).clamp(MIN_LENGTH, LENGTH);
            let (from, to) = if is_push { (end, start) } else { (start, end) };
            drawn.arrows.push(Arrow {
                way: Way::Straight { from, to, is_push },
                label,
                at: None,
            });
            let sense = story::Sense::along(direction);
            drawn.actions.push(action(noun, letter, sense));
        }
        Ok(())
    }

    /// A force or moment that the figure shows.
    fn shown(
        &self,
        body: &CutBody,
        force: &Force,
        moved: &[Moved],
        item: usize,
        drawn: &mut Drawn<'_>,
    ) -> Result<(), FreeFault> {
        let part = &self.parts[item];
        let noun = self.noun(item);
        let sense = if noun == Noun::MOMENT {
            let is_left = part.word("sense") != Some("cw");
            let sign = if is_left { 1.0 } else { -1.0 };
            let works = moved.iter().map(|motion| sign * motion.work_of_moment());
            agrees(body, force, works)?;
            if is_left {
                story::Sense::Counterclockwise
            } else {
                story::Sense::Clockwise
            }
        } else {
            let out = part.ends[0].out.unwrap_or(Point::new(1.0, 0.0));
            let direction = part.vector("direction").unwrap_or(out).unit();
            works(body, force, moved, part.point(), direction, None)?;
            story::Sense::along(direction)
        };
        drawn.shown.push(item);
        drawn.actions.push(Action {
            force: Thing::of(noun, part),
            sense,
            velocity: None,
        });
        Ok(())
    }

    fn moved(&self, motion: &BodyMotion) -> Moved {
        match motion {
            BodyMotion::Along(Heading::Written(pair)) => {
                Moved::Along(self.values.pair(pair).unit())
            }
            BodyMotion::Along(Heading::Shown(item)) => {
                let part = &self.parts[*item];
                let direction = match part.ends.as_slice() {
                    [from, to] => to.point - from.point,
                    ends => part
                        .vector("direction")
                        .or(ends[0].out)
                        .unwrap_or(Point::new(1.0, 0.0)),
                };
                Moved::Along(direction.unit())
            }
            BodyMotion::Turn(about, sense) => {
                let is_left = match sense {
                    TurnSense::Written(is_left) => *is_left,
                    TurnSense::Shown(item) => {
                        let part = &self.parts[*item];
                        let (from, to) = turn::degrees(part);
                        let sign = if to > from { 1.0 } else { -1.0 };
                        if let Some(axis) = part.vector("axis") {
                            return Moved::Twist(axis.unit() * sign);
                        }
                        to > from
                    }
                };
                Moved::Turn(about.point(&self.values), if is_left { 1.0 } else { -1.0 })
            }
        }
    }

    /// Where a link is fastened to a body.
    fn cuts(&self, body: &CutBody, item: usize, strand: Strand) -> Vec<Cut> {
        let part = &self.parts[item];
        let mut cuts = Vec::new();
        for (a, b) in self.items[item].kind.pieces(part) {
            for (drawn, other) in [(a, b), (b, a)] {
                if !self.touches(body, drawn) {
                    continue;
                }
                let out = (other - drawn).unit();
                // Links that share an axle are drawn beside each other, and all act at the axle.
                let axle = part
                    .ends
                    .iter()
                    .filter(|_| part.shift != 0.0)
                    .find(|end| end.body.is_some_and(|body| body.has_axle))
                    .map(|end| end.point);
                let aside = axle.map(|axle| out.left() * (drawn - axle).dot(out.left()));
                cuts.push(Cut {
                    at: drawn - aside.unwrap_or_default(),
                    drawn: drawn - aside.unwrap_or_default() * (1.0 - CLOSE),
                    out,
                    length: drawn.distance(other),
                });
            }
        }
        match strand {
            Strand::All => {}
            Strand::First => cuts.truncate(1),
            Strand::Last => {
                cuts.drain(..cuts.len().saturating_sub(1));
            }
        }
        cuts
    }

    fn touches(&self, body: &CutBody, point: Point) -> bool {
        body.kept.iter().any(|place| {
            let (item, part) = (self.items[*place], &self.parts[*place]);
            match (item.kind.role(), item.kind.outline(part)) {
                (_, Some(outline)) => outline.is_near(point, NEAR),
                (Role::Link(_), None) => {
                    let (a, b) = part.link();
                    let share = (point - a).dot(b - a) / (b - a).dot(b - a).max(1e-12);
                    point.distance(a.towards(b, share.clamp(0.0, 1.0))) < NEAR
                }
                _ => false,
            }
        })
    }

    /// What is fastened to a body is kept with it, cut to a force, or what a written reaction stands for.
    fn hold_links(&self, body: &CutBody) -> Result<(), FreeFault> {
        let is_cut = |place: &usize| {
            body.forces.iter().any(|force| match &force.source {
                ForceOrigin::Links { links, .. } => links.iter().any(|(item, _)| item == place),
                ForceOrigin::Shown(_) | ForceOrigin::Written(_) => false,
            })
        };
        let reactions: Vec<Point> = body
            .written()
            .filter(|written| written.kind == Contact::Reaction)
            .map(|written| self.written(written).point())
            .collect();
        for place in 0..self.figure.items.len() {
            let is_link = matches!(self.items[place].kind.role(), Role::Link(_));
            if !is_link || body.kept.contains(&place) || is_cut(&place) {
                continue;
            }
            let are_held = self.cuts(body, place, Strand::All).iter().all(|cut| {
                reactions
                    .iter()
                    .any(|reaction| reaction.distance(cut.at) < NEAR)
            });
            if !are_held {
                return Err(FreeFault::Uncut {
                    body: body.name.clone(),
                    link: self.link(place),
                });
            }
        }
        Ok(())
    }

    /// The part of an arrow that is written.
    fn written(&self, written: &WrittenArrow) -> &Part<'f> {
        let place = self
            .items
            .iter()
            .position(|item| std::ptr::eq(*item, &raw const written.item));
        &self.parts[place.unwrap_or_default()]
    }

    fn direction(&self, written: &WrittenArrow, part: &Part<'_>, moved: &[Moved]) -> Point {
        if let Some(direction) = &written.direction {
            return self.values.pair(direction).unit();
        }
        let into = part.ends[0].out.map(|out| -out);
        match written.kind {
            Contact::Weight => Point::new(0.0, -1.0),
            Contact::Normal | Contact::Reaction => into.unwrap_or(Point::new(0.0, 1.0)),
            Contact::Friction => moved
                .iter()
                .find_map(|motion| match motion {
                    Moved::Along(along) => Some(*along),
                    Moved::Turn(..) | Moved::Twist(_) => None,
                })
                .unwrap_or(Point::new(1.0, 0.0)),
        }
    }

    fn contact<'w>(written: &'w WrittenArrow, part: &Part<'_>, direction: Point) -> Arrow<'w> {
        let at = part.point();
        let is_push = written.kind == Contact::Normal;
        let (from, to) = match written.kind {
            Contact::Normal => (at - direction * LENGTH, at),
            Contact::Weight | Contact::Reaction => (at, at + direction * LENGTH),
            // Along the contact, beside it.
            Contact::Friction => {
                let aside = part.ends[0].out.unwrap_or_default() * 0.14;
                (at + aside, at + aside + direction * LENGTH)
            }
        };
        Arrow {
            way: Way::Straight { from, to, is_push },
            label: &written.label.0,
            at: written.item.at,
        }
    }

    fn draw(&self, body: &CutBody, drawn: &Drawn<'_>, owner: &mut u32, drawing: &mut Drawing) {
        let shift = body
            .shift
            .as_ref()
            .map_or_else(Point::default, |shift| self.values.pair(shift));
        for place in &self.figure.order {
            if !body.kept.contains(place) && !drawn.shown.contains(place) {
                continue;
            }
            let (item, mut part) = (self.items[*place], self.parts[*place].clone());
            for end in &mut part.ends {
                end.point = end.point + shift;
                if let Some(outline) = &mut end.body {
                    *outline = Outline {
                        centre: outline.centre + shift,
                        ..*outline
                    };
                }
            }
            // What holds a pin is cut off.
            part.settings.retain(|(key, _)| *key != "support");
            drawing.belongs_to(*place as u32);
            item.kind.draw(&part, drawing);
            if let Some(label) = &part.label {
                drawing.place(label.clone(), item.kind.spots(&part));
            }
        }
        for own in &drawn.arrows {
            drawing.belongs_to(*owner);
            *owner += 1;
            own.draw(shift, drawing);
        }
    }

    /// What a body is called: after the first of its elements that is one.
    fn named(&self, body: &CutBody) -> Option<Thing> {
        body.kept
            .iter()
            .find_map(|place| match self.items[*place].kind.role() {
                Role::Body(noun) | Role::Link(noun) => Some(Thing::of(noun, &self.parts[*place])),
                _ => None,
            })
    }

    /// What a link that is cut, or a force that is shown, is called; what has no name of its own acts by a force.
    fn noun(&self, item: usize) -> Noun {
        let noun = self.items[item].kind.role().noun();
        noun.unwrap_or(Noun::FORCE)
    }

    fn link(&self, item: usize) -> String {
        format!(
            "the {}",
            Thing::of(self.noun(item), &self.parts[item]).words()
        )
    }
}

fn action(noun: Noun, letter: &Math, sense: story::Sense) -> Action {
    Action {
        force: Thing {
            noun,
            label: Some(letter.clone()),
        },
        sense,
        velocity: None,
    }
}
