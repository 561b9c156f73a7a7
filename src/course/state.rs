//! How much of a sitting a platform keeps, and what has to fit.

/// How much state a standard lets a package keep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Room {
    /// The standard, in words.
    pub standard: &'static str,
    /// The most characters that a platform has to keep of it.
    pub characters: usize,
}

/// A package whose state would not fit.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "{parts} parts need {needed} characters of state, and {} keeps {}",
    room.standard, room.characters
)]
pub struct NoRoom {
    /// Parts of the package.
    pub parts: usize,
    /// What they need without any typed text.
    pub needed: usize,
    /// What there is.
    pub room: Room,
}

/// What stands before the parts: format, digest, submitted or not, count of changes, question.
const HEADER: usize = 16;

/// Credit in 2520ths, verdict, attempts, hints and solution seen are 24 bits: four digits of base 64.
const PART: usize = 4;

impl Room {
    /// What the state of so many parts needs whatever happens: credit, verdict, attempts, hints and solutions seen of each,
    /// in a code of fixed length. Typed text gets what is left.
    ///
    /// # Errors
    ///
    /// [`NoRoom`].
    pub fn fit(self, parts: usize) -> Result<usize, NoRoom> {
        let needed = HEADER + PART * parts;
        if needed > self.characters {
            return Err(NoRoom {
                parts,
                needed,
                room: self,
            });
        }
        Ok(needed)
    }
}
