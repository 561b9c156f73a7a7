//! The list of units, for those who want to know what can be typed.

use super::table::ROWS;

/// A unit of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct KnownUnit {
    /// As printed for people.
    pub printed: &'static str,
    /// As read everywhere; the first is written to files.
    pub symbols: &'static [&'static str],
    /// Words that are read in responses.
    pub words: &'static [&'static str],
    /// Whether it takes SI prefixes.
    pub takes_prefixes: bool,
}

impl KnownUnit {
    /// All units.
    ///
    /// ```
    /// use vibank_formula::unit::{KnownUnit, Unit};
    /// let newton = KnownUnit::all().find(|unit| unit.printed == "N").unwrap();
    /// assert!(newton.takes_prefixes);
    /// assert!(newton.symbols.iter().all(|symbol| Unit::parse(symbol).is_ok()));
    /// ```
    pub fn all() -> impl Iterator<Item = Self> {
        ROWS.iter().map(|row| Self {
            printed: row.print,
            symbols: row.symbols,
            words: row.words,
            takes_prefixes: row.prefixes,
        })
    }
}
