//! Seeds, the streams of numbers they stand for, and the codes on printed sheets.
//!
//! Everything random in a sheet comes from one [`Seed`] through fixed definitions (SHA-256, ChaCha8
//! and an exact map to integers), so a sheet printed today can be drawn again on any machine, in any
//! later version, and in the browser.
//!
//! - A blueprint's seed and an index, or the identity of a student, give a [`Variant`], the seed of one sheet, printed
//!   as a short code.
//! - A variant and an item's id give the [`Seed`] of that item, and nothing else does: adding an item to
//!   a sheet changes no other.
//! - An item's seed and a parameter's name give a [`Stream`]: adding a parameter changes no other.
//! - A [`Secret`] keys the first two steps for exams: without it, a code gives nothing away.
//!
//! All hashes are taken over fields of which each is preceded by its length, so that no two lists of
//! fields are hashed alike:
//!
//! ```text
//! encode(f1, f2, ...) = len(f1) f1 len(f2) f2 ...     lengths and numbers as 8 bytes, the highest first
//! stream key          = SHA-256(encode("vibank 1", seed, item, name))
//! item's seed         = first  8 bytes of H(encode("vibank 1 item", variant, item))
//! variant             = first 40 bits  of H(encode("vibank 1 variant", seed, index, attempt))
//! student's variant   = first 40 bits  of H(encode("vibank 1 student", seed, id, attempt))
//! student's rank      = first  8 bytes of H(encode("vibank 1 rank", seed, id))
//! H                   = SHA-256, or HMAC-SHA256 keyed with the secret
//! ```
//!
//! # Examples
//!
//! ```
//! use vibank::seed::{Seed, Streams, Variant};
//!
//! let sheet = Variant::of(Seed::new(2026), 0, 0, None);
//! let item = sheet.item("ch2/p1-pinned-bar-block", None);
//! let mut mass = Streams::of(item, "ch2/p1-pinned-bar-block").named("m");
//! assert!(mass.below(46) < 46);
//! ```

mod code;
mod digest;
mod stream;
mod variant;

pub use code::CodeError;
pub use digest::{Secret, SecretError};
pub use stream::{Stream, Streams};
pub use variant::Variant;

use std::fmt;

use serde::{Deserialize, Serialize};

/// The seed of everything that is drawn for one item, or of a whole blueprint: 64 bits.
///
/// It prints as a decimal number.
///
/// # Examples
///
/// ```
/// use vibank::seed::Seed;
/// assert_eq!(Seed::new(2026).to_string(), "2026");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Seed(u64);

impl Seed {
    /// The seed with this number.
    pub const fn new(number: u64) -> Self {
        Self(number)
    }

    /// The number that it was made of.
    pub const fn number(self) -> u64 {
        self.0
    }
}

impl fmt::Display for Seed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}
