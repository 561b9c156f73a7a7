//! Units as they are written in files.
//!
//! ```text
//! unit     = "1" | product [ "/" divisor ] | "1" "/" divisor
//! product  = factor { ( " " | "*" ) factor }
//! divisor  = factor | "(" product ")"
//! factor   = symbol [ "^" exponent ]
//! exponent = [ "-" ] digits | "(" [ "-" ] digits [ "/" digits ] ")"
//! ```

use super::error::{Error, ErrorKind};
use super::factor::{Builder, Factor};
use super::nearest::unknown;
use super::product::Unit;
use super::rational::Rational;
use super::scanner::Scanner;
use super::table::symbol;

/// The longest text of a unit or a quantity.
pub(crate) const MAX_LENGTH: usize = 200;

/// Reads a unit that makes up the whole text.
pub(crate) fn unit(text: &str) -> Result<Unit, Error> {
    let mut scanner = Scanner::new(text)?;
    scanner.space();
    if scanner.is_at_end() {
        return Err(scanner.error(ErrorKind::Empty));
    }
    rest(scanner)
}

/// Reads the rest of a text as a unit.
pub(crate) fn rest(mut scanner: Scanner<'_>) -> Result<Unit, Error> {
    let mut builder = Builder::new();
    if !scanner.takes_one() {
        product(&mut scanner, &mut builder)?;
    }
    scanner.space();
    if scanner.takes('/') {
        let start = builder.len();
        divisor(&mut scanner, &mut builder)?;
        builder.divide(start);
        scanner.space();
    }
    match scanner.peek() {
        None => builder
            .finish()
            .map_err(|kind| Error::new(kind, 0..scanner.at())),
        Some('/') => Err(scanner.error(ErrorKind::SecondSlash)),
        Some(')') => Err(scanner.error(ErrorKind::Parenthesis)),
        Some('*') => Err(scanner.error(ErrorKind::ProductAfterSlash)),
        Some(char) if char.is_alphabetic() => Err(scanner.error(ErrorKind::ProductAfterSlash)),
        Some(found) => Err(scanner.error(ErrorKind::Unexpected { found })),
    }
}

fn product(scanner: &mut Scanner<'_>, builder: &mut Builder) -> Result<(), Error> {
    loop {
        factor(scanner, builder)?;
        scanner.space();
        let starred = scanner.takes('*');
        scanner.space();
        if !starred && scanner.peek().is_none_or(|char| !is_letter(char)) {
            return Ok(());
        }
    }
}

fn divisor(scanner: &mut Scanner<'_>, builder: &mut Builder) -> Result<(), Error> {
    scanner.space();
    if !scanner.takes('(') {
        return factor(scanner, builder);
    }
    scanner.space();
    product(scanner, builder)?;
    scanner.space();
    if scanner.takes(')') {
        Ok(())
    } else {
        Err(scanner.error(ErrorKind::Parenthesis))
    }
}

fn factor(scanner: &mut Scanner<'_>, builder: &mut Builder) -> Result<(), Error> {
    let start = scanner.at();
    let mut name = scanner.run(is_letter);
    // Standard gravity is the one unit with a digit.
    if name == "g" && scanner.takes('0') {
        name = "g0";
    }
    if name.is_empty() {
        return Err(scanner.error(ErrorKind::UnitMissing));
    }
    let found = symbol(name).ok_or_else(|| unknown(name, start..scanner.at()))?;
    let power = exponent(scanner)?;
    builder
        .push(Factor::new(found, power))
        .map_err(|kind| Error::new(kind, start..scanner.at()))
}

fn exponent(scanner: &mut Scanner<'_>) -> Result<Rational, Error> {
    if !scanner.takes('^') {
        return Ok(Rational::ONE);
    }
    let start = scanner.at();
    let parsed = scanner.exponent(false);
    parsed
        .filter(|power| !power.is_zero())
        .ok_or_else(|| Error::new(ErrorKind::NotAnExponent, start..scanner.at()))
}

/// Whether a character may stand in the symbol of a unit.
pub(crate) fn is_letter(char: char) -> bool {
    char.is_alphabetic() || matches!(char, '%' | '‰' | '°')
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn reads_what_files_hold() {
        for (text, dimension) in [
            ("1", "1"),
            ("N m/rad", "kg m^2 s^-2"),
            ("N*m*s/rad", "kg m^2 s^-1"),
            ("kg m^2", "kg m^2"),
            ("kg*m^2", "kg m^2"),
            ("kg^(-1/2)*m^(-1)", "kg^(-1/2) m^-1"),
            ("m*kg^(1/2)", "kg^(1/2) m"),
            ("N^2*s^2/m^2", "kg^2 s^-2"),
            ("1/s^2", "1/s^2"),
            ("1/kg", "1/kg"),
            ("m/N", "s^2/kg"),
            ("J/(kg K)", "m^2 s^-2 K^-1"),
            (" N  m / rad ", "kg m^2 s^-2"),
            ("uF", "kg^-1 m^-2 s^4 A^2"),
            ("Ω", "kg m^2 s^-3 A^-2"),
            ("%", "1"),
            ("g0", "m/s^2"),
        ] {
            let unit = unit(text).unwrap_or_else(|error| panic!("`{text}`: {error}"));
            let printed = unit.dimension().to_string();
            let same = |text: &str| self::unit(text).map(|unit| unit.dimension());
            assert_eq!(
                same(&printed).unwrap_or(unit.dimension()),
                unit.dimension(),
                "{text}: {printed}"
            );
            assert_eq!(
                same(dimension).unwrap(),
                unit.dimension(),
                "{text}: {printed}"
            );
        }
    }

    #[test]
    fn refuses_what_may_be_misread() {
        for (text, place, message) in [
            ("", "", "nothing is written"),
            (
                "N m/rad s",
                "s",
                "a product after a slash may belong above or below it",
            ),
            (
                "N/rad*s",
                "*",
                "a product after a slash may belong above or below it",
            ),
            ("N/m/s", "/", "a second slash"),
            ("Ns/m", "Ns", "`Ns` is not a known unit"),
            ("N·m", "·", "`·` does not belong here"),
            ("m²", "²", "`²` does not belong here"),
            ("kg m^", "", "not an exponent"),
            ("m^(1/2", "(1/2", "not an exponent"),
            ("newton", "newton", "`newton` is not a known unit"),
            ("kmin", "kmin", "`kmin` is not a known unit"),
            ("m m m m m m m m m", "m", "more than 8 factors"),
            ("2", "2", "a unit is missing"),
        ] {
            let error = unit(text).unwrap_err();
            let found = (error.span.clone(), error.to_string());
            assert_eq!(
                (&text[found.0], found.1.as_str()),
                (place, message),
                "`{text}`"
            );
        }
        assert_eq!(
            unit("newton").unwrap_err().help().as_deref(),
            Some("write `N`")
        );
    }

    proptest! {
        #[test]
        fn any_text_is_read_or_refused_in_place(text in any::<String>()) {
            if let Err(error) = unit(&text) {
                prop_assert!(text.get(error.span).is_some());
            }
        }

        #[test]
        fn reading_inverts_printing(text in "(1|k?N|mm|s\\^-2|kg\\^\\(-1/2\\))( (m|kg|rad|ohm|deg))?( us\\^2)?(/(rad|m\\^3|\\(kg K\\)))?") {
            if let Ok(read) = unit(&text) {
                prop_assert_eq!(unit(&read.to_string()), Ok(read));
                prop_assert_eq!(Unit::read(&read.to_string()), Ok(read));
                if !read.is_one() {
                    let people = Unit::read(&read.text()).unwrap();
                    prop_assert_eq!(people.coherent().dimension(), read.dimension());
                    prop_assert_eq!(people.to_si(1.0), read.to_si(1.0));
                }
            }
        }
    }
}
