//! An element with numbers: where it stands for the data of one drawing, and how it is to look.

use super::outline::{Outline, Side};
use super::{Dash, FigureLabel, Fill, Path, Pen, Point, Weight};
use crate::math::Math;

/// Shortest spring or damper beside a disk.
const MIN_LENGTH: f64 = 0.9;

/// An element, evaluated.
#[derive(Clone, Debug)]
pub struct Part<'f> {
    /// Its points, in the order of the file.
    pub ends: Vec<End>,
    /// Its own keys that are there, with their values.
    pub settings: Vec<(&'static str, Setting)>,
    /// What is written at it.
    pub label: Option<FigureLabel>,
    /// Where the label is wanted.
    pub at: Option<Side>,
    /// How its lines are drawn.
    pub style: LineStyle,
    /// How far it is moved to its left, where several links share their ends.
    pub shift: f64,
    /// What the label is a picture of; for descriptions.
    pub symbol: Option<&'f Math>,
}

/// A point of an element.
#[derive(Clone, Copy, Debug)]
pub struct End {
    /// Position in the figure, y upward.
    pub point: Point,
    /// The body that is placed there.
    pub body: Option<Outline>,
    /// The direction out of the body, where the point is one of its sides.
    pub out: Option<Point>,
    /// For cords: whether it goes round the body there, counterclockwise if true.
    pub pass: Option<bool>,
}

impl End {
    /// Where a line from elsewhere to `at` ends: at the outline of the body there, if that has an axle or, by `axle`, none.
    pub(crate) fn trimmed(&self, from: Point, at: Point, axle: bool) -> Point {
        match self.body {
            Some(body) if self.out.is_none() && body.has_axle == axle => body.entry(from, at),
            _ => at,
        }
    }
}

/// The value of a key.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Setting {
    /// The value of a formula, as a bare number.
    Number(f64),
    /// A direction or size.
    Vector(Point),
    /// `true` or `false`.
    Flag(bool),
    /// One of some words.
    Word(&'static str),
}

/// How the lines of an element are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LineStyle {
    /// As the element has it.
    #[default]
    Solid,
    /// Strokes with gaps.
    Dashed,
    /// Points with gaps.
    Dotted,
    /// Grey.
    Faint,
}

impl LineStyle {
    /// The words of `style`.
    pub const WORDS: [&str; 4] = ["solid", "dashed", "dotted", "faint"];

    /// The style of a word.
    pub(crate) fn of_word(word: &str) -> Option<Self> {
        let place = Self::WORDS.iter().position(|known| *known == word)?;
        Some([Self::Solid, Self::Dashed, Self::Dotted, Self::Faint][place])
    }
}

impl Part<'_> {
    /// The number of a key.
    pub fn number(&self, key: &str) -> Option<f64> {
        match self.setting(key) {
            Some(Setting::Number(number)) if number.is_finite() => Some(number),
            _ => None,
        }
    }

    /// The direction or size of a key.
    pub fn vector(&self, key: &str) -> Option<Point> {
        match self.setting(key) {
            Some(Setting::Vector(vector)) if vector.is_drawable() => Some(vector),
            _ => None,
        }
    }

    /// Whether a key is set to `true`.
    pub fn is(&self, key: &str) -> bool {
        self.setting(key) == Some(Setting::Flag(true))
    }

    /// The word of a key.
    pub fn word(&self, key: &str) -> Option<&'static str> {
        match self.setting(key) {
            Some(Setting::Word(word)) => Some(word),
            _ => None,
        }
    }

    fn setting(&self, key: &str) -> Option<Setting> {
        let found = self.settings.iter().find(|(name, _)| *name == key);
        found.map(|(_, setting)| *setting)
    }

    /// A length, kept within what can be drawn.
    pub fn length(&self, key: &str, default: f64) -> f64 {
        self.number(key).unwrap_or(default).clamp(0.02, 100.0)
    }

    /// The point at which it is placed.
    pub fn point(&self) -> Point {
        self.ends[0].point
    }

    /// The pen for its lines.
    pub fn pen(&self, weight: Weight) -> Pen {
        let pen = Pen::new(weight);
        match self.style {
            LineStyle::Solid => pen,
            LineStyle::Dashed => pen.dashed(Dash::Dashed),
            LineStyle::Dotted => pen.dashed(Dash::Dotted),
            LineStyle::Faint => pen.faint(),
        }
    }

    /// The filling of its areas: what is only hinted at has none.
    pub fn fill(&self, fill: Fill) -> Fill {
        if self.style == LineStyle::Solid {
            fill
        } else {
            Fill::None
        }
    }

    /// Where a link begins and ends: at the outlines of bodies, beside others that share its ends.
    pub fn link(&self) -> (Point, Point) {
        let (a, b) = self.moved();
        let [first, second] = [&self.ends[0], &self.ends[1]];
        (first.trimmed(b, a, false), second.trimmed(a, b, false))
    }

    /// The part of a spring or damper that is not a mere rod: it ends before the disk to whose axle it leads.
    pub fn working(&self) -> (Point, Point) {
        let (a, b) = self.link();
        let [first, second] = [&self.ends[0], &self.ends[1]];
        let (c, d) = (first.trimmed(b, a, true), second.trimmed(a, b, true));
        if c.distance(d) < MIN_LENGTH {
            (a, b)
        } else {
            (c, d)
        }
    }

    /// The rods from the working part to the axles.
    pub fn leads(&self) -> Path {
        let ((a, b), (c, d)) = (self.moved(), self.working());
        let mut path = Path::new();
        for (end, middle, outline) in [(&self.ends[0], a, c), (&self.ends[1], b, d)] {
            if end.out.is_none() && end.body.is_some_and(|body| body.has_axle) {
                path = path.and(Path::through([outline, middle, end.point]));
            }
        }
        path
    }

    /// The two points, moved aside.
    fn moved(&self) -> (Point, Point) {
        let [first, second] = [&self.ends[0], &self.ends[1]];
        let shift = (second.point - first.point).unit().left() * self.shift;
        (first.point + shift, second.point + shift)
    }
}
