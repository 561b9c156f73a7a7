//! Worksheets: blueprints, variants, the manifest, and the document made of scenes; no format.
//!
//! A [`Blueprint`] is what a teacher writes; with the bank it becomes a [`Plan`]. A [`Chooser`]
//! proposes and takes suitable variants, each drawn as a [`Sheet`], which the formats write.
//! The [`Manifest`] keeps what marking needs.
//! A [`Practice`] is what a self-check page offers.

#[cfg(feature = "render")]
mod blueprint;
#[cfg(feature = "render")]
mod candidate;
#[cfg(feature = "render")]
mod decisions;
#[cfg(feature = "render")]
mod draw;
mod fairness;
mod manifest;
mod marks;
#[cfg(feature = "render")]
mod own;
mod paper;
#[cfg(feature = "render")]
mod plan;
mod practice;
#[cfg(feature = "render")]
mod printing;
#[cfg(feature = "render")]
mod rules;
#[cfg(feature = "render")]
mod scan_mark;
#[cfg(feature = "render")]
mod seat;
mod sheet;
#[cfg(feature = "render")]
mod usual;
#[cfg(feature = "render")]
mod variants;

#[cfg(feature = "render")]
pub use blueprint::{
    AnswerSpace, Audience, Blueprint, BlueprintError, Choice, Columns, FORMATS, Filter, Keys,
    Question,
};
#[cfg(feature = "render")]
pub use candidate::{Candidate, Fixed};
#[cfg(feature = "render")]
pub use decisions::{
    Corrected, Decision, DecisionError, Decisions, Effect, HandedOut, Subject, Void,
};
#[cfg(feature = "render")]
pub use draw::SheetError;
pub use fairness::{Alike, Fairness, ItemFairness, QuestionFairness, Range};
pub use manifest::{
    BankStamp, Csv, EntryError, FORMAT, FileStamp, Manifest, PartEntry, QuestionEntry, VariantEntry,
};
#[cfg(feature = "render")]
pub use marks::MarksError;
pub use marks::{
    Absence, Best, Bound, Direction, Exact, GradeStep, Marks, Rounding, Scored, Total, Worth,
};
#[cfg(feature = "render")]
pub use own::Own;
pub use paper::Paper;
#[cfg(feature = "render")]
pub use plan::{Plan, Planned};
pub use practice::{Practice, PracticeError, PracticeQuestion, Weighed};
#[cfg(feature = "render")]
pub use printing::{FileNames, PrintOrder, Printing, Section, TypeSizeError, Whose, file_stem};
#[cfg(feature = "render")]
pub use rules::{Feedback, Rules, Worked};
#[cfg(feature = "render")]
pub use scan_mark::{Modules, ScanMark};
pub use sheet::{Heading, Sheet, SheetQuestion, Student, headings, letter};
#[cfg(feature = "render")]
pub use variants::Chooser;
