//! The units, one row each, and the prefixes.
//!
//! Adding a unit is adding a row. Spellings in `symbols` are read everywhere, the first is the one written
//! to files; words are read in responses only, the first two are spoken for one and for several.

use super::dimension::Dimension;
use super::scale::Scale;

/// What a unit says about angles: whether it counts radians, full cycles, or neither.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Turning {
    None,
    Radians,
    Cycles,
}

/// A unit as it is defined: its symbols, what it is made of, and which prefixes it takes.
pub(crate) struct UnitRow {
    /// As read; the first is written to files.
    pub(crate) symbols: &'static [&'static str],
    /// As printed for people.
    pub(crate) print: &'static str,
    /// As spoken in French, in the singular.
    pub(crate) french: &'static str,
    /// Singular, plural, and other words that are read in responses.
    pub(crate) words: &'static [&'static str],
    pub(crate) dimension: Dimension,
    pub(crate) scale: Scale,
    pub(crate) turning: Turning,
    /// Whether it takes SI prefixes.
    pub(crate) prefixes: bool,
    /// Whether it may be written without a space beside others in responses, `Nm`.
    pub(crate) joins: bool,
    /// The unit without a factor that it is a multiple of; nothing if it is one itself.
    pub(crate) coherent: &'static str,
}

/// A power of ten that a unit may bear, such as kilo.
pub(crate) struct Prefix {
    /// As read; the first is written to files.
    pub(crate) symbols: &'static [&'static str],
    /// As printed for people.
    pub(crate) print: &'static str,
    pub(crate) word: &'static str,
    pub(crate) french: &'static str,
    /// The power of ten.
    pub(crate) power: i8,
}

/// A place in [`ROWS`] and the power of ten of a prefix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Found {
    pub(crate) row: u8,
    pub(crate) prefix: i8,
}

#[expect(clippy::too_many_arguments, reason = "a row of the table below")]
const fn row(
    symbols: &'static [&'static str],
    print: &'static str,
    french: &'static str,
    words: &'static [&'static str],
    dimension: [i8; 7],
    scale: [i8; 5],
    turning: Turning,
    prefixes: bool,
    joins: bool,
    coherent: &'static str,
) -> UnitRow {
    UnitRow {
        symbols,
        print,
        french,
        words,
        dimension: Dimension::of(dimension),
        scale: Scale::of(scale),
        turning,
        prefixes,
        joins,
        coherent,
    }
}

use Turning::{Cycles, None as Still, Radians};

const YES: bool = true;
const NOT: bool = false;

/// All units: the exponents of kg, m, s, A, K, mol, cd; those of 2, 3, 5, 980665, π in the factor to SI.
///
/// # References
///
/// BIPM, The International System of Units, 9th edition (2019), tables 2 to 5, 7 and 8.
#[rustfmt::skip]
pub(crate) static ROWS: &[UnitRow] = &[
    //   symbols                 print  French             words                                             kg  m  s   A  K mol cd     2   3   5  g  pi          prefixes joins coherent
    row(&["m"],                  "m",   "mètre",           &["metre", "metres", "meter", "meters", "mètre", "mètres", "metro", "metros", "mtr", "mtrs"], [ 0,  1,  0,  0, 0, 0, 0], [ 0,  0,  0, 0, 0], Still,   YES, YES, ""),
    row(&["s"],                  "s",   "seconde",         &["second", "seconds", "sec", "secs", "seconde", "secondes", "sek", "sekunde", "sekunden", "seg", "segundo", "segundos"], [ 0,  0,  1,  0, 0, 0, 0], [ 0,  0,  0, 0, 0], Still,   YES, YES, ""),
    row(&["g"],                  "g",   "gramme",          &["gram", "grams", "gramme", "grammes", "gr"],    [ 1,  0,  0,  0, 0, 0, 0], [-3,  0, -3, 0, 0], Still,   YES, YES, "kg"),
    row(&["rad"],                "rad", "radian",          &["radian", "radians", "rads", "rad", "rd", "radiant", "radiants", "radianes"], [ 0,  0,  0,  0, 0, 0, 0], [ 0,  0,  0, 0, 0], Radians, YES, YES, ""),
    row(&["N"],                  "N",   "newton",          &["newton", "newtons", "n"],                      [ 1,  1, -2,  0, 0, 0, 0], [ 0,  0,  0, 0, 0], Still,   YES, YES, ""),
    row(&["Hz"],                 "Hz",  "hertz",           &["hertz", "hertz", "hz", "cps"],                 [ 0,  0, -1,  0, 0, 0, 0], [ 0,  0,  0, 0, 0], Cycles,  YES, YES, ""),
    row(&["J"],                  "J",   "joule",           &["joule", "joules"],                             [ 1,  2, -2,  0, 0, 0, 0], [ 0,  0,  0, 0, 0], Still,   YES, YES, ""),
    row(&["W"],                  "W",   "watt",            &["watt", "watts"],                               [ 1,  2, -3,  0, 0, 0, 0], [ 0,  0,  0, 0, 0], Still,   YES, YES, ""),
    row(&["Pa"],                 "Pa",  "pascal",          &["pascal", "pascals"],                           [ 1, -1, -2,  0, 0, 0, 0], [ 0,  0,  0, 0, 0], Still,   YES, YES, ""),
    row(&["V"],                  "V",   "volt",            &["volt", "volts"],                               [ 1,  2, -3, -1, 0, 0, 0], [ 0,  0,  0, 0, 0], Still,   YES, YES, ""),
    row(&["A"],                  "A",   "ampère",          &["ampere", "amperes", "ampère", "ampères", "amp", "amps"], [ 0,  0,  0,  1, 0, 0, 0], [ 0,  0,  0, 0, 0], Still,   YES, YES, ""),
    row(&["ohm", "Ω", "\u{2126}"], "Ω", "ohm",             &["ohm", "ohms"],                                 [ 1,  2, -3, -2, 0, 0, 0], [ 0,  0,  0, 0, 0], Still,   YES, YES, ""),
    row(&["F"],                  "F",   "farad",           &["farad", "farads"],                             [-1, -2,  4,  2, 0, 0, 0], [ 0,  0,  0, 0, 0], Still,   YES, YES, ""),
    row(&["H"],                  "H",   "henry",           &["henry", "henries", "henrys"],                  [ 1,  2, -2, -2, 0, 0, 0], [ 0,  0,  0, 0, 0], Still,   YES, YES, ""),
    row(&["C"],                  "C",   "coulomb",         &["coulomb", "coulombs"],                         [ 0,  0,  1,  1, 0, 0, 0], [ 0,  0,  0, 0, 0], Still,   YES, YES, ""),
    row(&["S"],                  "S",   "siemens",         &["siemens", "siemens"],                          [-1, -2,  3,  2, 0, 0, 0], [ 0,  0,  0, 0, 0], Still,   YES, NOT, ""),
    row(&["T"],                  "T",   "tesla",           &["tesla", "teslas"],                             [ 1,  0, -2, -1, 0, 0, 0], [ 0,  0,  0, 0, 0], Still,   YES, YES, ""),
    row(&["Wb"],                 "Wb",  "weber",           &["weber", "webers"],                             [ 1,  2, -2, -1, 0, 0, 0], [ 0,  0,  0, 0, 0], Still,   YES, YES, ""),
    row(&["K"],                  "K",   "kelvin",          &["kelvin", "kelvins"],                           [ 0,  0,  0,  0, 1, 0, 0], [ 0,  0,  0, 0, 0], Still,   YES, NOT, ""),
    row(&["mol"],                "mol", "mole",            &["mole", "moles"],                               [ 0,  0,  0,  0, 0, 1, 0], [ 0,  0,  0, 0, 0], Still,   YES, NOT, ""),
    row(&["cd"],                 "cd",  "candela",         &["candela", "candelas"],                         [ 0,  0,  0,  0, 0, 0, 1], [ 0,  0,  0, 0, 0], Still,   YES, NOT, ""),
    row(&["sr"],                 "sr",  "stéradian",       &["steradian", "steradians"],                     [ 0,  0,  0,  0, 0, 0, 0], [ 0,  0,  0, 0, 0], Still,   NOT, NOT, ""),
    row(&["deg", "°"],           "°",   "degré",           &["degree", "degrees", "degs", "º", "degré", "degrés", "grado", "grados"], [ 0,  0,  0,  0, 0, 0, 0], [-2, -2, -1, 0, 1], Radians, NOT, NOT, "rad"),
    row(&["rev"],                "rev", "tour",            &["revolution", "revolutions", "revs", "turn", "turns", "cycle", "cycles", "osc", "tr", "tour", "tours", "umdrehung", "umdrehungen"],
                                                                                                             [ 0,  0,  0,  0, 0, 0, 0], [ 0,  0,  0, 0, 0], Cycles,  NOT, NOT, ""),
    row(&["rpm"],                "rpm", "tour par minute", &["revolution per minute", "revolutions per minute", "rpm"],
                                                                                                             [ 0,  0, -1,  0, 0, 0, 0], [-2, -1, -1, 0, 0], Cycles,  NOT, NOT, "Hz"),
    row(&["%"],                  "%",   "pour cent",       &["percent", "percent"],                          [ 0,  0,  0,  0, 0, 0, 0], [-2,  0, -2, 0, 0], Still,   NOT, NOT, "1"),
    row(&["‰"],                  "‰",   "pour mille",      &["permille", "permille", "promille"],              [ 0,  0,  0,  0, 0, 0, 0], [-3,  0, -3, 0, 0], Still,   NOT, NOT, "1"),
    row(&["ppm"],                "ppm", "partie par million", &["part per million", "parts per million"],       [ 0,  0,  0,  0, 0, 0, 0], [-6,  0, -6, 0, 0], Still,   NOT, NOT, "1"),
    row(&["min"],                "min", "minute",          &["minute", "minutes", "mins"],                   [ 0,  0,  1,  0, 0, 0, 0], [ 2,  1,  1, 0, 0], Still,   NOT, YES, "s"),
    row(&["h"],                  "h",   "heure",           &["hour", "hours", "hr", "hrs"],                  [ 0,  0,  1,  0, 0, 0, 0], [ 4,  2,  2, 0, 0], Still,   NOT, YES, "s"),
    row(&["d"],                  "d",   "jour",            &["day", "days"],                                 [ 0,  0,  1,  0, 0, 0, 0], [ 7,  3,  2, 0, 0], Still,   NOT, NOT, "s"),
    row(&["L", "l"],             "L",   "litre",           &["litre", "litres", "liter", "liters"],          [ 0,  3,  0,  0, 0, 0, 0], [-3,  0, -3, 0, 0], Still,   YES, NOT, "m^3"),
    row(&["t"],                  "t",   "tonne",           &["tonne", "tonnes"],                             [ 1,  0,  0,  0, 0, 0, 0], [ 3,  0,  3, 0, 0], Still,   NOT, NOT, "kg"),
    row(&["bar"],                "bar", "bar",             &["bar", "bars"],                                 [ 1, -1, -2,  0, 0, 0, 0], [ 5,  0,  5, 0, 0], Still,   YES, NOT, "Pa"),
    row(&["g0"],                 "g₀",  "accélération normale de la pesanteur", &["standard gravity", "standard gravities"],      [ 0,  1, -2,  0, 0, 0, 0], [-5,  0, -5, 1, 0], Still,   NOT, NOT, "m/s^2"),
    row(&["kgf"],                "kgf", "kilogramme-force", &["kilogram-force", "kilograms-force"],           [ 1,  1, -2,  0, 0, 0, 0], [-5,  0, -5, 1, 0], Still,   NOT, NOT, "N"),
    row(&["var"],                "var", "var",             &["var", "vars"],                                 [ 1,  2, -3,  0, 0, 0, 0], [ 0,  0,  0, 0, 0], Still,   YES, NOT, ""),
    row(&["arcmin"],             "′",   "minute d’angle",  &["arcminute", "arcminutes"],                     [ 0,  0,  0,  0, 0, 0, 0], [-4, -3, -2, 0, 1], Radians, NOT, NOT, "rad"),
    row(&["arcsec"],             "″",   "seconde d’angle", &["arcsecond", "arcseconds"],                     [ 0,  0,  0,  0, 0, 0, 0], [-6, -4, -3, 0, 1], Radians, NOT, NOT, "rad"),
    row(&["gon"],                "gon", "grade",           &["gon", "gons"],                                 [ 0,  0,  0,  0, 0, 0, 0], [-3,  0, -2, 0, 1], Radians, NOT, NOT, "rad"),
];

/// The prefixes.
pub(crate) static PREFIXES: [Prefix; 14] = [
    Prefix {
        symbols: &["k"],
        print: "k",
        word: "kilo",
        french: "kilo",
        power: 3,
    },
    Prefix {
        symbols: &["m"],
        print: "m",
        word: "milli",
        french: "milli",
        power: -3,
    },
    Prefix {
        symbols: &["c"],
        print: "c",
        word: "centi",
        french: "centi",
        power: -2,
    },
    Prefix {
        symbols: &["u", "µ", "μ"],
        print: "µ",
        word: "micro",
        french: "micro",
        power: -6,
    },
    Prefix {
        symbols: &["M"],
        print: "M",
        word: "mega",
        french: "méga",
        power: 6,
    },
    Prefix {
        symbols: &["n"],
        print: "n",
        word: "nano",
        french: "nano",
        power: -9,
    },
    Prefix {
        symbols: &["G"],
        print: "G",
        word: "giga",
        french: "giga",
        power: 9,
    },
    Prefix {
        symbols: &["d"],
        print: "d",
        word: "deci",
        french: "déci",
        power: -1,
    },
    Prefix {
        symbols: &["da"],
        print: "da",
        word: "deca",
        french: "déca",
        power: 1,
    },
    Prefix {
        symbols: &["h"],
        print: "h",
        word: "hecto",
        french: "hecto",
        power: 2,
    },
    Prefix {
        symbols: &["p"],
        print: "p",
        word: "pico",
        french: "pico",
        power: -12,
    },
    Prefix {
        symbols: &["T"],
        print: "T",
        word: "tera",
        french: "téra",
        power: 12,
    },
    Prefix {
        symbols: &["f"],
        print: "f",
        word: "femto",
        french: "femto",
        power: -15,
    },
    Prefix {
        symbols: &["P"],
        print: "P",
        word: "peta",
        french: "péta",
        power: 15,
    },
];

/// For each first byte of a symbol, the rows that have such a symbol, one bit each.
static BY_FIRST_BYTE: [u64; 256] = {
    let mut rows = [0; 256];
    let mut row = 0;
    while row < ROWS.len() {
        let mut symbol = 0;
        while symbol < ROWS[row].symbols.len() {
            rows[ROWS[row].symbols[symbol].as_bytes()[0] as usize] |= 1 << row;
            symbol += 1;
        }
        row += 1;
    }
    rows
};

/// The unit of a symbol as it may stand in a file, with or without a prefix.
pub(crate) fn symbol(text: &str) -> Option<Found> {
    if let Some(row) = bare_symbol(text) {
        return Some(Found { row, prefix: 0 });
    }
    for prefix in &PREFIXES {
        for rest in prefix
            .symbols
            .iter()
            .filter_map(|&symbol| text.strip_prefix(symbol))
        {
            if let Some(row) = bare_symbol(rest).filter(|&row| ROWS[usize::from(row)].prefixes) {
                return Some(Found {
                    row,
                    prefix: prefix.power,
                });
            }
        }
    }
    None
}

/// The row of a symbol without a prefix.
pub(crate) fn bare_symbol(text: &str) -> Option<u8> {
    let mut rows = BY_FIRST_BYTE[usize::from(*text.as_bytes().first()?)];
    while rows != 0 {
        let row = rows.trailing_zeros();
        if ROWS[row as usize].symbols.contains(&text) {
            return Some(row as u8);
        }
        rows &= rows - 1;
    }
    None
}

/// The unit of a word, `kilonewtons`, in any case.
pub(crate) fn word(text: &str) -> Option<Found> {
    if let Some(row) = row_of_word(text, false) {
        return Some(Found { row, prefix: 0 });
    }
    PREFIXES.iter().find_map(|prefix| {
        let row = match text.get(..prefix.word.len()) {
            Some(head) if head.eq_ignore_ascii_case(prefix.word) => {
                // `microF`
                let rest = &text[head.len()..];
                let symbol = || bare_symbol(rest).filter(|row| ROWS[usize::from(*row)].prefixes);
                row_of_word(rest, true).or_else(symbol)
            }
            _ => None,
        };
        // `msec`, `mAmp`
        let mut symbols = prefix.symbols.iter();
        let mixed = || {
            let rest = symbols.find_map(|symbol| text.strip_prefix(symbol))?;
            row_of_word(rest, true).filter(|_| rest.len() >= MIN_MIXED)
        };
        Some(Found {
            row: row.or_else(mixed)?,
            prefix: prefix.power,
        })
    })
}

/// The shortest word after the symbol of a prefix: `mhz` may be MHz with capitals forgotten.
const MIN_MIXED: usize = 3;

/// Whether a run of letters is a prefix in words, `milli`, in any case.
pub(crate) fn is_prefix_word(text: &str) -> bool {
    let mut prefixes = PREFIXES.iter();
    prefixes.any(|prefix| prefix.word.eq_ignore_ascii_case(text))
}

/// The row of a unit by its word.
fn row_of_word(text: &str, prefixed: bool) -> Option<u8> {
    ROWS.iter()
        .position(|row| {
            (row.prefixes || !prefixed)
                && row.words.iter().any(|word| word.eq_ignore_ascii_case(text))
        })
        .map(|row| row as u8)
}

/// The prefix of a power of ten that is not zero.
pub(crate) fn prefix(power: i8) -> Option<&'static Prefix> {
    PREFIXES.iter().find(|prefix| prefix.power == power)
}

#[cfg(test)]
mod tests {
    use super::{PREFIXES, ROWS};

    #[test]
    fn no_unit_hides_another() {
        let bare = ROWS.iter().flat_map(|row| row.symbols);
        let mut symbols: Vec<String> = bare.map(|&symbol| symbol.to_owned()).collect();
        for row in ROWS.iter().filter(|row| row.prefixes) {
            let prefixes = PREFIXES.iter().flat_map(|prefix| prefix.symbols);
            symbols
                .extend(prefixes.flat_map(|prefix| {
                    row.symbols.iter().map(move |own| format!("{prefix}{own}"))
                }));
        }
        symbols.sort();
        for pair in symbols.windows(2) {
            assert_ne!(
                pair[0], pair[1],
                "two units, or one with a prefix, are written so"
            );
        }
        let mut words: Vec<(String, &str)> = ROWS
            .iter()
            .flat_map(|row| {
                row.words
                    .iter()
                    .map(|word| (word.to_lowercase(), row.print))
            })
            .collect();
        words.sort();
        for pair in words.windows(2) {
            let is_told_apart = pair[0].0 != pair[1].0 || pair[0].1 == pair[1].1;
            assert!(is_told_apart, "two units are called `{}`", pair[0].0);
        }
    }
}
