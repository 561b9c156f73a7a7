//! The list of units, for those who want to know what can be typed.

use super::Unit;
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

impl Unit {
    /// All units.
    ///
    /// ```
    /// use vibank_formula::unit::Unit;
    /// let newton = Unit::known().find(|unit| unit.printed == "N").unwrap();
    /// assert!(newton.takes_prefixes);
    /// assert!(newton.symbols.iter().all(|symbol| Unit::parse(symbol).is_ok()));
    /// ```
    pub fn known() -> impl Iterator<Item = KnownUnit> {
        ROWS.iter().map(|row| KnownUnit {
            printed: row.print,
            symbols: row.symbols,
            words: row.words,
            takes_prefixes: row.prefixes,
        })
    }
}
