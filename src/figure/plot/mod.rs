//! Plots: curves over a variable, phase planes, mode shapes and phasor diagrams, for black-and-white print.
//!
//! Curves are distinguished by dashes and by labels at them, not by colours and a legend. The axes have
//! round ticks and name their units. Curves are sampled where they bend, so that few cubic pieces follow
//! them to less than the width of the line.
//!
//! What is drawn is given as numbers and functions in the units of the axes; which formulas these come
//! from is not known here.

mod axis;
mod chart;
mod course;
mod description;
mod frame;
mod lettering;
mod modes;
mod phasors;
mod room;
mod sample;
mod ticks;

use crate::figure::story::{Speaker, Story};
use crate::figure::{Dash, Drawing, Head};
use crate::math::Math;
use crate::unit::{DecimalMark, Unit};

pub use modes::{ModeShape, ModeShapes};
pub use phasors::{Phasor, PhasorAngle, Phasors};

/// Curves between two axes.
pub struct Plot<'a> {
    /// The axis to the right.
    pub x: Axis,
    /// The axis upwards.
    pub y: Axis,
    /// From where to where the variable of the curves goes; the unit is that of the axis to the right,
    /// or in a phase plane that of the time.
    pub range: [f64; 2],
    /// The curves, in the order in which dashes are given out.
    pub curves: Vec<Curve<'a>>,
    /// Points that are marked.
    pub marks: Vec<PlotMark>,
    /// The decimal sign.
    pub decimal: DecimalMark,
}

/// What one axis shows, and from where to where.
#[derive(Clone, Debug)]
pub struct Axis {
    /// What it counts; may be empty.
    pub label: Math,
    /// The unit of its numbers.
    pub unit: Unit,
    /// Whether it is logarithmic.
    pub is_logarithmic: bool,
    /// Where its ticks stand.
    pub spacing: Spacing,
    /// What is shown; what the curves need if there is none.
    pub range: Option<[f64; 2]>,
}

/// The distance of ticks.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Spacing {
    /// A round number.
    #[default]
    Round,
    /// This number.
    Step(f64),
    /// This number, a share of π, as which the labels are written.
    ShareOfPi(f64),
}

/// A function that is drawn over a range of its variable.
pub struct Curve<'a> {
    /// What belongs to each value of the variable.
    pub course: Course<'a>,
    /// What stands at it.
    pub label: Option<Math>,
    /// How it is drawn.
    pub style: CurveStyle,
}

/// A point of the plane, or the two edges of a band, at a value of the variable.
pub type Pair<'a> = Box<dyn Fn(f64) -> Option<[f64; 2]> + 'a>;

/// The course of a curve: what belongs to a value of the variable, in the units of the axes.
pub enum Course<'a> {
    /// The value of a function, if it has one there.
    Graph(Box<dyn Fn(f64) -> Option<f64> + 'a>),
    /// The two edges of a band.
    Band(Pair<'a>),
    /// A point of the plane.
    Path(Pair<'a>),
}

/// How a curve is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CurveStyle {
    /// Distinguished from the other curves by dashes.
    #[default]
    Auto,
    /// Without a gap.
    Solid,
    /// Dashes.
    Dashed,
    /// Dots.
    Dotted,
    /// A thin line that others do not pass, or tend to; named at its right end.
    Limit,
    /// A grey band.
    Band,
}

/// A marked point.
#[derive(Clone, Debug)]
pub struct PlotMark {
    /// Where, in the units of the axes.
    pub at: [f64; 2],
    /// What stands at it.
    pub label: Option<Math>,
}

/// A plot that is drawn, and what it shows.
#[derive(Clone, Debug)]
pub struct Picture {
    /// The drawing, its labels in place.
    pub drawing: Drawing,
    /// What it shows; a speaker words it.
    pub story: Story,
}

/// Why there is nothing to draw.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlotError {
    /// A range that is empty, or too large to be drawn.
    #[error("its {axis} axis would go from {from} to {to}")]
    Range {
        /// `x` or `y`.
        axis: char,
        /// Its beginning.
        from: f64,
        /// Its end.
        to: f64,
    },
    /// No curve has a value anywhere, or no phasor a length.
    #[error("nothing in it has a value")]
    Nothing,
    /// A mark that lies outside.
    #[error("a mark at ({}, {}) lies outside of the axes", .at[0], .at[1])]
    Mark {
        /// The place, in the units of the axes.
        at: [f64; 2],
    },
}

impl Picture {
    /// The plot as an SVG element, worded by a speaker; `id` begins all identities in it.
    pub fn svg(&self, id: &str, speaker: &dyn Speaker) -> String {
        let words = speaker.caption(&self.story);
        self.drawing.svg(&Head {
            id,
            title: &words.title,
            description: &words.description,
        })
    }
}

impl CurveStyle {
    const NAMES: [(&'static str, Self); 5] = [
        ("solid", Self::Solid),
        ("dashed", Self::Dashed),
        ("dotted", Self::Dotted),
        ("limit", Self::Limit),
        ("band", Self::Band),
    ];

    /// The names of all styles.
    pub fn names() -> impl Iterator<Item = &'static str> {
        Self::NAMES.iter().map(|(name, _)| *name)
    }

    /// The style of a name.
    pub fn of_name(name: &str) -> Option<Self> {
        let mut names = Self::NAMES.iter();
        names.find(|(own, _)| *own == name).map(|(_, style)| *style)
    }
}

impl Plot<'_> {
    /// Draws the plot.
    ///
    /// # Examples
    ///
    /// ```
    /// use vibank::figure::plot::{Axis, Course, Curve, Plot, Spacing, CurveStyle};
    /// use vibank::message::Language;
    /// use vibank::math::symbol;
    /// use vibank::unit::{DecimalMark, Unit};
    ///
    /// let axis = |name, unit| Axis {
    ///     label: symbol(name),
    ///     unit: Unit::parse(unit).unwrap(),
    ///     is_logarithmic: false,
    ///     spacing: Spacing::Round,
    ///     range: None,
    /// };
    /// let decay = Curve {
    ///     course: Course::Graph(Box::new(|t| Some(20.0 * (-t / 3.0_f64).exp()))),
    ///     label: Some(symbol("x")),
    ///     style: CurveStyle::Auto,
    /// };
    /// let plot = Plot {
    ///     x: axis("t", "s"),
    ///     y: axis("x", "mm"),
    ///     range: [0.0, 10.0],
    ///     curves: vec![decay],
    ///     marks: Vec::new(),
    ///     decimal: DecimalMark::Point,
    /// };
    /// let picture = plot.draw()?;
    /// let svg = picture.svg("p", &Language::English);
    /// assert!(svg.contains("falls from 20 mm to 0.7"));
    /// assert!(svg.len() < 6000);
    /// # Ok::<(), vibank::figure::plot::PlotError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`PlotError`]: nothing has a value, or a range is none.
    pub fn draw(&self) -> Result<Picture, PlotError> {
        chart::draw(self)
    }
}

/// The dashes of the curves that have no style of their own, in turn.
const DASHES: [Dash; 5] = [
    Dash::Solid,
    Dash::Dashed,
    Dash::Dotted,
    Dash::Chain,
    Dash::Long,
];
