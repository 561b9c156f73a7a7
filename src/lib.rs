//! Problem bank and exercise generator for the physics of vibrations.
#![cfg_attr(
    not(feature = "render"),
    allow(
        dead_code,
        unused_imports,
        reason = "the core holds what reads item files, which only `render` calls"
    )
)]

// Layer 0: text, random streams, bare numbers, typeset mathematics, units.
pub mod math;
pub mod numerics;
pub mod seed;
pub mod source;
pub mod unit;
pub mod work;

// Layer 1: findings.
pub mod diagnostic;

// Layer 2: formulas, and the vibrations of the textbooks.
pub mod expr;
pub mod vibration;

// Layer 3: texts, figures, and mechanics from energies.
pub mod document;
pub mod figure;
pub mod mechanics;

// Layer 4: an item's quantities, and the kinds of answers.
pub mod answer;
pub mod quantity;
pub mod response;

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
