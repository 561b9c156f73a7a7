//! Templates and the catalogue that holds them; loading from text.
//!
//! A bank is a folder of files: `bank.toml`, `<chapter>/_chapter.toml` and `<chapter>/<slug>.toml`.
//! Opening one gives a catalogue of what can be used; an item is read when it is asked for, or all are, with
//! the findings about what cannot be used: a broken item never hides the others.

mod about;
mod bounds;
mod catalogue;
mod compiled;
#[cfg(feature = "render")]
mod corrected;
#[cfg(feature = "render")]
mod embedded;
mod folder;
mod identity;
#[cfg(feature = "render")]
mod listing;
#[cfg(feature = "render")]
mod load;
#[cfg(feature = "render")]
mod own;
mod parameter;
mod passage;
pub mod plot;
mod points;
mod read;
mod rule;
#[cfg(feature = "render")]
mod space;
#[cfg(feature = "render")]
mod stripped;
mod template;

pub use about::About;
#[cfg(feature = "render")]
pub(crate) use bounds::shortened;
pub use catalogue::{Catalogue, Open};
pub use compiled::{Compiled, CompiledError};
#[cfg(feature = "render")]
pub use corrected::CorrectionError;
#[cfg(feature = "render")]
pub use embedded::{course, embedded};
pub use folder::{BankFile, Chapter, FORMAT};
pub use identity::{ItemId, Revision};
#[cfg(feature = "render")]
pub use listing::{ListedPart, Listing};
#[cfg(feature = "render")]
pub(crate) use own::question_keys;
pub use parameter::{Domain, Grid, Parameter, ParameterError};
pub use passage::{Passage, Piece, Target};
pub use points::{share_in_group, share_out};
pub use read::ItemError;
pub use rule::Rule;
#[cfg(feature = "render")]
pub use space::{Space, SpaceError};
pub use template::{
    Allowed, Check, Constraint, Expected, Group, Mistake, MistakeAnswer, Part, QuantityInfo,
    Template, Units,
};
