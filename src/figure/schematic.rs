//! A schematic as an item declares it, and its drawing for certain data.

use std::sync::OnceLock;

use super::element::{Element, Role};
use super::formula::{Amount, FigurePair, FigureValues};
use super::free::Free;
use super::motion::Motion;
use super::outline::{Outline, Side};
use super::part::{End, LineStyle, Part, Setting};
use super::read::{FigureReader, Subject};
use super::story::{self, Caption, Speaker, Story};
use super::{Bounds, Drawing, FigureLabel, Head, Point, Spot, svg};
use crate::diagnostic::Finding;
use crate::expr::Name;
use crate::math::Math;
use crate::source::Table;

/// A schematic of an item: its names and points, and its elements, compiled.
#[derive(Debug)]
pub struct Figure {
    pub(crate) alt: Option<String>,
    pub(crate) labels: Labels,
    pub(crate) locals: Vec<(u32, Local)>,
    pub(crate) taken: Vec<(Name, u32)>,
    pub(crate) slots: u32,
    pub(crate) items: Vec<Item>,
    /// The items in the order in which they cover each other.
    pub(crate) order: Vec<usize>,
    /// The free-body diagrams.
    pub(crate) free: Free,
    /// How it moves, if it does.
    pub(crate) motion: Option<Motion>,
    /// As it was drawn, where it takes nothing from the data.
    pub(crate) alike: OnceLock<Result<Sketched, Undrawable>>,
}

/// What a figure asks of the data for which it is drawn.
pub trait FigureData {
    /// The real number of a name of the item, in SI units.
    fn number(&self, name: &Name) -> Option<f64>;

    /// A name's number with its unit, as it is printed.
    fn value(&self, name: &Name) -> Option<Math>;
}

/// What labels show of a quantity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Labels {
    /// The letter, `k`.
    #[default]
    Symbol,
    /// The number with its unit, `200 N/m`.
    Value,
    /// Letter and number, `k = 200 N/m`.
    Both,
}

/// A name of a figure.
#[derive(Debug)]
pub(crate) enum Local {
    Number(Amount),
    Point(FigurePair),
}

/// An element as it is declared.
pub(crate) struct Item {
    pub(crate) kind: &'static dyn Element,
    /// By which a free-body diagram refers to it.
    pub(crate) id: Option<String>,
    pub(crate) ends: Vec<ElementPlace>,
    pub(crate) settings: Vec<(&'static str, KeyValue)>,
    pub(crate) label: Option<DeclaredLabel>,
    pub(crate) at: Option<Side>,
    pub(crate) style: LineStyle,
}

/// The place of an element.
#[derive(Clone, Debug)]
pub(crate) enum ElementPlace {
    Free(FigurePair),
    /// A point with a name, by its slot.
    Named(u32),
    Side(u32, Side),
    /// Round a pulley, counterclockwise if true.
    Pass(u32, bool),
}

/// The value of a key.
#[derive(Debug)]
pub(crate) enum KeyValue {
    Number(Amount),
    Vector(FigurePair),
    Point(ElementPlace),
    Known(Setting),
}

/// A label as it is declared.
#[derive(Debug)]
pub(crate) struct DeclaredLabel {
    pub(crate) label: FigureLabel,
    pub(crate) math: Math,
    /// The name of the item that it is, if it is one.
    pub(crate) name: Option<Name>,
}

/// A figure that was drawn, without the words about it.
#[derive(Debug)]
pub(crate) struct Sketched {
    story: Story,
    frame: Bounds,
    /// Its marks and labels, as SVG.
    content: String,
}

/// A figure that was drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// The picture, as an SVG element.
    pub svg: String,
    /// What it shows, in words.
    pub alt: String,
    /// Its width in print, in millimetres.
    pub width: f64,
    /// Its height in print, in millimetres.
    pub height: f64,
}

/// An element whose place or size is no number, or lies beyond what can be drawn, for these data.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("`{kind}`, element {number} of the figure, has no place for these data")]
pub struct Undrawable {
    /// The kind of the element.
    pub kind: &'static str,
    /// Its number, from 1.
    pub number: usize,
}

impl std::fmt::Debug for Item {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "{} at {:?}", self.kind.name(), self.ends)
    }
}

impl Figure {
    /// Reads the keys of a figure but its caption; what is wrong is reported, and left out.
    pub fn read(table: &Table<'_>, item: &dyn Subject) -> (Self, Vec<Finding>) {
        FigureReader::new(table, item).figure()
    }

    /// Whether there are free-body diagrams.
    pub fn has_free(&self) -> bool {
        !self.free.is_empty()
    }

    /// Whether it says how it moves.
    pub fn moves(&self) -> bool {
        self.motion.is_some()
    }

    /// The drawing for these data.
    ///
    /// # Errors
    ///
    /// [`Undrawable`].
    pub fn draw(&self, given: &dyn FigureData) -> Result<Drawing, Undrawable> {
        Ok(drawn(&self.parts(given)?, &self.items, &self.order))
    }

    /// The picture for these data, worded by a speaker; `id` begins all identities in it.
    ///
    /// # Errors
    ///
    /// [`Undrawable`].
    pub fn picture(
        &self,
        given: &dyn FigureData,
        id: &str,
        speaker: &dyn Speaker,
    ) -> Result<Picture, Undrawable> {
        let own;
        let sketched = if self.is_the_same_for_all() {
            let alike = self.alike.get_or_init(|| self.sketched(given));
            alike.as_ref().map_err(Undrawable::clone)?
        } else {
            own = self.sketched(given)?;
            &own
        };
        let Caption { title, description } = speaker.caption(&sketched.story);
        let alt = self.alt.clone().unwrap_or(description);
        let head = Head {
            id,
            title: &title,
            description: &alt,
        };
        let svg = svg::element(sketched.frame, &head, &sketched.content);
        let (width, height) = svg::size(sketched.frame);
        Ok(Picture {
            svg,
            alt,
            width,
            height,
        })
    }

    /// Whether it takes nothing from the data.
    fn is_the_same_for_all(&self) -> bool {
        let mut labels = self.items.iter().filter_map(|item| item.label.as_ref());
        let shows_values =
            self.labels != Labels::Symbol && labels.any(|label| label.name.is_some());
        self.taken.is_empty() && !shows_values
    }

    fn sketched(&self, given: &dyn FigureData) -> Result<Sketched, Undrawable> {
        let parts = self.parts(given)?;
        let drawing = drawn(&parts, &self.items, &self.order);
        Ok(Sketched {
            story: Story::Sketch(story::sketch(&self.items, &parts)),
            frame: drawing.frame(),
            content: svg::content(&drawing),
        })
    }

    pub(crate) fn parts(&self, given: &dyn FigureData) -> Result<Vec<Part<'_>>, Undrawable> {
        self.parts_of(&self.items.iter().collect::<Vec<_>>(), given)
    }

    /// The parts of items that stand in this figure.
    pub(crate) fn parts_of<'f>(
        &'f self,
        items: &[&'f Item],
        given: &dyn FigureData,
    ) -> Result<Vec<Part<'f>>, Undrawable> {
        let values = self.values(given);
        let mut parts = Vec::with_capacity(items.len());
        for (place, item) in items.iter().enumerate() {
            let part = self.part(item, &values, given);
            if !part.ends.iter().all(|end| end.point.is_drawable()) {
                return Err(Undrawable {
                    kind: item.kind.name(),
                    number: place + 1,
                });
            }
            parts.push(part);
        }
        join(items, &mut parts);
        spread(items, &mut parts);
        Ok(parts)
    }

    /// The numbers of all names.
    pub(crate) fn values(&self, given: &dyn FigureData) -> FigureValues {
        let mut values = FigureValues::new(self.slots);
        for (name, slot) in &self.taken {
            values.set(*slot, given.number(name).unwrap_or(f64::NAN));
        }
        for (slot, local) in &self.locals {
            match local {
                Local::Number(amount) => values.set(*slot, values.amount(amount)),
                Local::Point(pair) => {
                    let point = values.pair(pair);
                    values.set(*slot, point.x);
                    values.set(slot + 1, point.y);
                }
            }
        }
        values
    }

    fn part<'f>(&self, item: &'f Item, values: &FigureValues, given: &dyn FigureData) -> Part<'f> {
        let ends = item.ends.iter().map(|place| {
            let pass = match place {
                ElementPlace::Pass(_, is_left) => Some(*is_left),
                _ => None,
            };
            End {
                point: place.point(values),
                body: None,
                out: None,
                pass,
            }
        });
        let settings = item.settings.iter().map(|(key, value)| {
            let setting = match value {
                KeyValue::Number(amount) => Setting::Number(values.amount(amount)),
                KeyValue::Vector(pair) => Setting::Vector(values.pair(pair)),
                KeyValue::Point(place) => Setting::Vector(place.point(values)),
                KeyValue::Known(setting) => *setting,
            };
            (*key, setting)
        });
        Part {
            ends: ends.collect(),
            settings: settings.collect(),
            label: item
                .label
                .as_ref()
                .map(|written| self.label(written, given)),
            at: item.at,
            style: item.style,
            shift: 0.0,
            symbol: item.label.as_ref().map(|written| &written.math),
        }
    }

    fn label(&self, written: &DeclaredLabel, given: &dyn FigureData) -> FigureLabel {
        let value = match (self.labels, &written.name) {
            (Labels::Symbol, _) | (_, None) => None,
            (_, Some(name)) => given.value(name),
        };
        let symbol = written.label.clone();
        match value {
            None => symbol,
            Some(value) if self.labels == Labels::Value => FigureLabel::of(&value),
            Some(value) => symbol
                .followed_by(FigureLabel::upright("="))
                .followed_by(FigureLabel::of(&value)),
        }
    }
}

impl ElementPlace {
    /// The point of the figure to which it belongs.
    pub(crate) fn slot(&self) -> Option<u32> {
        match self {
            Self::Free(_) => None,
            Self::Named(slot) | Self::Side(slot, _) | Self::Pass(slot, _) => Some(*slot),
        }
    }

    pub(crate) fn point(&self, values: &FigureValues) -> Point {
        match self {
            Self::Free(pair) => values.pair(pair),
            Self::Named(slot) | Self::Side(slot, _) | Self::Pass(slot, _) => values.point(*slot),
        }
    }
}

/// Tells every end which body it meets.
fn join(items: &[&Item], parts: &mut [Part<'_>]) {
    let mut bodies: Vec<(u32, Outline)> = Vec::new();
    for (item, part) in items.iter().zip(parts.iter()) {
        let (Some(ElementPlace::Named(slot)), Some(outline)) =
            (item.ends.first(), item.kind.outline(part))
        else {
            continue;
        };
        match bodies.iter_mut().find(|(known, _)| known == slot) {
            // Of several bodies at a point the largest has the sides.
            Some((_, known)) if known.bounds().width() < outline.bounds().width() => {
                *known = outline;
            }
            Some(_) => {}
            None => bodies.push((*slot, outline)),
        }
    }
    let body = |slot: &u32| {
        bodies
            .iter()
            .find(|(known, _)| known == slot)
            .map(|(_, body)| *body)
    };
    for (item, part) in items.iter().zip(parts.iter_mut()) {
        let is_body = matches!(item.kind.role(), Role::Body(_));
        for (place, end) in item.ends.iter().zip(&mut part.ends) {
            match place {
                ElementPlace::Named(slot) if !is_body => end.body = body(slot),
                ElementPlace::Pass(slot, _) => end.body = body(slot),
                ElementPlace::Side(slot, side) => {
                    end.body = body(slot);
                    if let Some(body) = end.body {
                        let (point, out) = body.side(*side);
                        (end.point, end.out) = (point, Some(out));
                    }
                }
                ElementPlace::Named(_) | ElementPlace::Free(_) => {}
            }
        }
    }
}

/// Room that a link needs beside its neighbour.
const LINK: f64 = 0.85;

/// Spreads links that share their ends evenly, first above or left of last.
fn spread(items: &[&Item], parts: &mut [Part<'_>]) {
    let links: Vec<usize> = (0..parts.len())
        .filter(|place| items[*place].kind.spreads() && parts[*place].vector("around").is_none())
        .collect();
    let ends = |part: &Part<'_>| (part.ends[0].point, part.ends[1].point);
    let mut done: Vec<usize> = Vec::new();
    for first in &links {
        if done.contains(first) {
            continue;
        }
        let (a, b) = ends(&parts[*first]);
        let alike = links.iter().filter(|place| {
            let (c, d) = ends(&parts[**place]);
            a.distance(c).max(b.distance(d)) < 1e-6 || a.distance(d).max(b.distance(c)) < 1e-6
        });
        let group: Vec<usize> = alike.copied().collect();
        done.extend(&group);
        if group.len() < 2 {
            continue;
        }
        let breadth = |end: &End| end.body.map_or(f64::INFINITY, |body| body.breadth(b - a));
        let [start, end] = [&parts[*first].ends[0], &parts[*first].ends[1]];
        let room = breadth(start).min(breadth(end)) / group.len() as f64;
        let step = room.clamp(0.55, LINK);
        for (rank, place) in group.iter().enumerate() {
            let part = &mut parts[*place];
            let left = (part.ends[1].point - part.ends[0].point).unit().left();
            let is_first_side = left.y > 0.3 || (left.y.abs() <= 0.3 && left.x < 0.0);
            let rank = rank as f64 - (group.len() - 1) as f64 / 2.0;
            let shift = -rank * step;
            part.shift = if is_first_side { shift } else { -shift };
            if part.at.is_none() && rank != 0.0 {
                let out = left * part.shift;
                part.at = Some(
                    match (out.x.abs() > out.y.abs(), out.x > 0.0, out.y > 0.0) {
                        (true, true, _) => Side::Right,
                        (true, false, _) => Side::Left,
                        (false, _, true) => Side::Above,
                        (false, _, false) => Side::Below,
                    },
                );
            }
        }
    }
}

pub(crate) fn drawn(parts: &[Part<'_>], items: &[Item], order: &[usize]) -> Drawing {
    let mut drawing = Drawing::new();
    for place in order {
        let (item, part) = (&items[*place], &parts[*place]);
        drawing.belongs_to(*place as u32);
        item.kind.draw(part, &mut drawing);
        if let Some(label) = &part.label {
            let spots: Vec<Spot> = item.kind.spots(part);
            drawing.place(label.clone(), spots);
        }
    }
    drawing.settle();
    drawing
}
