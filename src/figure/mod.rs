//! Schematics and plots, drawn as SVG.
//!
//! A [`Drawing`] gathers lines, areas and labels in figure units (10 mm in print, y up), finds places for
//! its labels, and is written as SVG. A [`Figure`] is the schematic of an item: read from its table
//! `[figure]`, compiled, and drawn for the data of an instance by its [`element`]s.

mod arrow;
mod drawing;
pub mod element;
mod error;
mod formula;
mod free;
mod geometry;
mod label;
mod metrics;
mod motion;
mod noun;
mod outline;
mod part;
mod path;
mod pen;
mod placing;
pub mod plot;
mod read;
mod schematic;
mod spots;
pub mod story;
mod svg;

pub use drawing::{Anchor, Drawing, DrawnPath, Lettering, Spot};
pub use error::FigureError;
pub use free::{Acting, FreeError, FreeFault, Move, draw_free, free_picture};
pub use geometry::{Bounds, Point};
pub use label::{FigureLabel, LETTER_SIZE};
pub use motion::{Film, ModelState, MovingFigure};
pub use noun::Noun;
pub use outline::{Outline, OutlineForm, Side};
pub use part::{End, LineStyle, Part, Setting};
pub use path::Path;
pub use pen::{Dash, Fill, Pen, Weight};
pub use read::Subject;
pub use schematic::{Figure, FigureData, Labels, Picture, Undrawable};
pub use svg::Head;
