//! Schematics and plots, drawn as SVG.
//!
//! A [`Drawing`] gathers lines, areas and labels in figure units (10 mm in print, y up), finds places for
//! its labels, and is written as SVG.

mod drawing;
mod geometry;
mod label;
mod metrics;
mod path;
mod pen;
mod placing;
pub mod plot;
mod svg;

pub use drawing::{Anchor, Drawing, Lettering, Mark, Spot};
pub use geometry::{Bounds, Point};
pub use label::{LETTER_SIZE, Label};
pub use path::Path;
pub use pen::{Dash, Fill, Pen, Weight};
pub use svg::Head;
