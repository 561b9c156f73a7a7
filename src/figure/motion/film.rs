//! The pictures of a figure that moves: in one position, between the extremes of a mode, and one after the other.

use super::pose::{Pose, Poses, Rigid};
use super::{Displacements, ModelState, Motion};
use crate::figure::element::{Layer, Role};
use crate::figure::outline::OutlineForm;
use crate::figure::part::{LineStyle, Part};
use crate::figure::schematic::drawn;
use crate::figure::{
    Bounds, Drawing, Figure, FigureData, Fill, Head, Lettering, Path, Pen, Picture, Point,
    Undrawable, Weight, svg,
};

/// A figure that moves, as an SVG element and what is drawn in it one after the other.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    /// The element, with what does not move and an empty group for the rest.
    pub svg: String,
    /// What the group holds, picture by picture.
    pub frames: Vec<String>,
}

/// A figure that moves, at rest, with its labels at their places: ready for a drawing, a picture or a film.
pub struct MovingFigure<'f> {
    figure: &'f Figure,
    motion: &'f Motion,
    values: super::FigureValues,
    parts: Vec<Part<'f>>,
    labels: Vec<Lettering>,
    places: Vec<Point>,
    /// Whether what measures moving points is left out.
    hides: bool,
}

impl<'f> MovingFigure<'f> {
    /// A figure for these data; nothing where it has no motion.
    ///
    /// # Errors
    ///
    /// [`Undrawable`].
    pub fn of(figure: &'f Figure, given: &dyn FigureData) -> Result<Option<Self>, Undrawable> {
        let Some(motion) = &figure.motion else {
            return Ok(None);
        };
        let values = motion.values(figure, given);
        let parts = figure.parts(given)?;
        let labels = drawn(&parts, &figure.items, &figure.order).labels;
        let places = motion.points.iter();
        let places = places.map(|point| point.at(&values)).collect();
        Ok(Some(Self {
            figure,
            motion,
            values,
            parts,
            labels,
            places,
            hides: true,
        }))
    }

    /// The drawing with the coordinates of its model at a state, one unit of a shift for each metre and one radian of a
    /// turn for each radian.
    pub fn displaced(mut self, state: &ModelState) -> Drawing {
        let displacements = self.motion.displacements(&mut self.values, state);
        self.hides = false;
        let motion = self.motion;
        let rigid = motion.drawn(&self.values, &displacements, (1.0, 1.0), false);
        self.drawing(&rigid, |_| true)
    }

    /// The figure with both extremes of a shape, one in light lines and one in dots; `name` says what it is.
    pub fn extremes(mut self, shape: &[f64], (id, name, alt): (&str, &str, &str)) -> Picture {
        let all = [1.0, -1.0, 0.0].map(|sign| {
            let state = ModelState {
                coordinates: shape.iter().map(|own| own * sign).collect(),
                time: 0.0,
            };
            self.motion.displacements(&mut self.values, &state)
        });
        let poses = self.scaled(&all);
        let mut drawing = Drawing::new();
        // In other lines each, so that one sees which displacements belong together.
        for (rigid, style) in poses.iter().zip([LineStyle::Faint, LineStyle::Dotted]) {
            self.shadow(rigid, style, &mut drawing);
        }
        let middle = self.drawing(&poses[2], |_| true);
        drawing.add(middle);
        let svg = drawing.svg(&Head {
            id,
            title: name,
            description: alt,
        });
        let (width, height) = drawing.size();
        Picture {
            svg,
            alt: alt.to_owned(),
            width,
            height,
        }
    }

    /// The pictures at the states of a motion.
    pub fn film(mut self, states: &[ModelState], head: &Head<'_>) -> Film {
        let all: Vec<Displacements> = states
            .iter()
            .map(|state| self.motion.displacements(&mut self.values, state))
            .collect();
        let poses = self.scaled(&all);
        let mut still = self.drawing(&[], |place| self.is_still(place));
        let frames: Vec<Drawing> = poses
            .iter()
            .map(|rigid| {
                let mut frame = self.drawing(rigid, |place| !self.is_still(place));
                self.spokes(rigid, &mut frame, Pen::new(Weight::Thin));
                frame
            })
            .collect();
        let frame = frames
            .iter()
            .map(Drawing::frame)
            .fold(still.frame(), Bounds::joined);
        still.labels.clear();
        let content = svg::content(&still) + "<g class=\"moving\"></g>";
        Film {
            svg: svg::element(frame, head, &content),
            frames: frames.iter().map(svg::content).collect(),
        }
    }

    /// Where the points of a motion are, in the scale that shows all of it.
    fn scaled(&self, all: &[Displacements]) -> Vec<Vec<Rigid>> {
        let scales = self.motion.scales(&self.values, all);
        let all = all.iter();
        all.map(|own| self.motion.drawn(&self.values, own, scales, true))
            .collect()
    }

    /// Whether an element is ground that no motion takes along, and so lies under all that moves.
    fn is_still(&self, place: usize) -> bool {
        let item = &self.figure.items[place];
        let moves = self.motion.points.iter().any(|point| {
            let slot = point.slot();
            slot.is_some() && item.ends.iter().any(|end| end.slot() == slot)
        });
        item.kind.layer() == Layer::Support && !moves
    }

    fn poses<'a>(&'a self, rigid: &'a [Rigid]) -> Vec<Pose<'a>> {
        let poses = Poses {
            items: &self.figure.items,
            rest: &self.parts,
            moved: rigid,
            places: &self.places,
            hides: self.hides,
        };
        poses.all()
    }

    /// The elements of some layers, with their labels, which go with what they name.
    fn drawing(&self, rigid: &[Rigid], shows: impl Fn(usize) -> bool) -> Drawing {
        let poses = self.poses(rigid);
        let mut drawing = Drawing::new();
        for place in &self.figure.order {
            let (item, part) = (&self.figure.items[*place], &self.parts[*place]);
            if !shows(*place) {
                continue;
            }
            drawing.belongs_to(*place as u32);
            let from = drawing.marks.len();
            match &poses[*place] {
                Pose::Still => item.kind.draw(part, &mut drawing),
                Pose::Rigid(rigid) => {
                    item.kind.draw(part, &mut drawing);
                    let marks = drawing.marks[from..].iter_mut();
                    marks.for_each(|mark| rigid.mark(mark));
                }
                Pose::Stretched(part) => item.kind.draw(part, &mut drawing),
                Pose::Gone => {}
            }
        }
        for label in &self.labels {
            let place = label.owner as usize;
            let part = &self.parts[place];
            let shift = match &poses[place] {
                Pose::Still => Point::default(),
                Pose::Rigid(rigid) => rigid.point(part.point()) - part.point(),
                Pose::Stretched(moved) => {
                    let ends = moved.ends.iter().zip(&part.ends);
                    let sum = ends.fold(Point::default(), |sum, (end, rest)| {
                        sum + (end.point - rest.point)
                    });
                    sum * (1.0 / part.ends.len() as f64)
                }
                Pose::Gone => continue,
            };
            if shows(place) {
                drawing.labels.push(label.shifted(shift));
            }
        }
        drawing
    }

    /// What moves, in light lines.
    fn shadow(&self, rigid: &[Rigid], style: LineStyle, drawing: &mut Drawing) {
        let poses = self.poses(rigid);
        for place in &self.figure.order {
            let (item, part) = (&self.figure.items[*place], &self.parts[*place]);
            // The coils of three springs over each other show nothing.
            let is_solid = match item.kind.role() {
                Role::Body(_) => true,
                Role::Link(_) => !item.kind.spreads(),
                _ => false,
            };
            if !is_solid {
                continue;
            }
            let light = |part: &Part<'_>| {
                let mut drawing = Drawing::new();
                let part = Part {
                    style,
                    ..part.clone()
                };
                item.kind.draw(&part, &mut drawing);
                drawing.marks
            };
            match &poses[*place] {
                Pose::Rigid(rigid) => {
                    let mut marks = light(part);
                    marks.iter_mut().for_each(|mark| rigid.mark(mark));
                    drawing.marks.extend(marks);
                }
                Pose::Stretched(part) => drawing.marks.extend(light(part)),
                Pose::Still | Pose::Gone => {}
            }
        }
        self.spokes(rigid, drawing, Pen::new(Weight::Thin).faint());
    }

    /// A line on what is round, without which nobody sees it turn.
    fn spokes(&self, rigid: &[Rigid], drawing: &mut Drawing, pen: Pen) {
        let moves = self.motion.points.iter().zip(rigid);
        for (point, rigid) in moves {
            if point.turn.is_none() {
                continue;
            }
            let own = self.figure.items.iter().zip(&self.parts);
            let outlines = own.filter_map(|(item, part)| {
                let [crate::figure::schematic::ElementPlace::Named(at)] = item.ends.as_slice()
                else {
                    return None;
                };
                let outline = item
                    .kind
                    .outline(part)
                    .filter(|_| rigid.slot == Some(*at))?;
                match outline.form {
                    OutlineForm::Round { radius } if outline.has_axle => {
                        Some((outline.centre, radius))
                    }
                    _ => None,
                }
            });
            let largest = outlines.max_by(|a, b| a.1.total_cmp(&b.1));
            if let Some((centre, radius)) = largest {
                let rim = centre + Point::new(0.0, radius);
                let line = Path::line(rigid.point(centre), rigid.point(rim));
                drawing.decorate(line, Some(pen), Fill::None);
            }
        }
    }
}
