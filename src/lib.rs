//! Problem bank and exercise generator for the physics of vibrations.

// Layers 0 to 2 are crates of their own: text and findings, bare numbers and vibrations, typeset mathematics, units and
// formulas, and what people type.
pub use vibank_dynamics::{numerics, vibration};
pub use vibank_formula::{expr, unit, work};
pub use vibank_notation as math;
pub use vibank_response as response;
pub use vibank_source as source;
pub use vibank_source::diagnostic;

pub mod compute;
pub mod seed;

// Layer 3: texts, figures, and mechanics from energies.
pub mod document;
pub mod figure;
pub mod mechanics;

// Layer 4: an item's quantities, and the kinds of answers.
pub mod answer;
pub mod quantity;

// Layer 5: items, and what is said about responses.
pub mod bank;
pub mod message;

// Layers 6 to 8: what is drawn from an item, and its marking.
pub mod instance;

pub mod solution;

pub mod grade;
pub mod scene;
pub mod suitability;

// Layer 9: examinations, sheets and reports.
#[cfg(feature = "render")]
pub mod examine;
pub mod report;
pub mod survey;
pub mod worksheet;

// Layer 10: courses, formats, and exports to course platforms.
#[cfg(feature = "render")]
pub mod course;
#[cfg(feature = "render")]
pub mod export;
#[cfg(feature = "render")]
pub mod output;

// Layer 11: the grader in the browser.
pub mod wasm;

// The readers of the command line, for the fuzz campaign alone; they name this library as any other user.
#[cfg(feature = "fuzzing")]
extern crate self as vibank;
#[cfg(feature = "fuzzing")]
#[doc(hidden)]
#[allow(
    dead_code,
    unused_imports,
    reason = "the campaign takes a few of its readers"
)]
pub mod cli;
