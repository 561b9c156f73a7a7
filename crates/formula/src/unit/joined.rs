//! Letters without a space between them: one unit, or several, `Nm`, `kgm`, `Nms`.

use std::ops::Range;

use super::dimension::Dimension;
use super::error::{Error, ErrorKind};
use super::nearest::unknown;
use super::table::{Found, PREFIXES, ROWS, Turning, bare_symbol, symbol, word};

/// The most units that are written together.
const MAX_COUNT: usize = 4;

/// The longest run of letters that may be several units.
// Twelve letters can be cut in 2¹¹ ways.
const MAX_LENGTH: usize = 12;

/// Several units in a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Joined {
    units: [Found; MAX_COUNT],
    length: usize,
}

impl Joined {
    const NONE: Self = Self {
        units: [Found { row: 0, prefix: 0 }; MAX_COUNT],
        length: 0,
    };

    fn with(mut self, found: Found) -> Option<Self> {
        // Nobody writes `mm` for square metres.
        let is_repeated = self.iter().any(|known| known.row == found.row);
        // Inside, a prefix is at home with metres, seconds and the kilogram only: `Nps` is not a picosecond.
        let is_odd = self.length > 0 && !is_plain(found);
        if is_repeated || is_odd {
            return None;
        }
        *self.units.get_mut(self.length)? = found;
        self.length += 1;
        Some(self)
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = Found> {
        self.units.into_iter().take(self.length)
    }

    /// The lower, the likelier: few prefixes inside, then few units. So `Nms` is N m s, and `mAh` is mA h.
    fn unlikeliness(&self) -> (usize, usize) {
        let inside = self
            .iter()
            .skip(1)
            .filter(|found| found.prefix != 0 && !is_kilogram(*found))
            .count();
        (inside, self.length)
    }

    fn text(&self) -> String {
        let names = self.iter().map(|found| {
            let prefix = PREFIXES
                .iter()
                .find(|prefix| prefix.power == found.prefix)
                .map_or("", |prefix| prefix.symbols[0]);
            format!("{prefix}{}", ROWS[usize::from(found.row)].symbols[0])
        });
        names.collect::<Vec<_>>().join(" ")
    }
}

fn is_plain(found: Found) -> bool {
    let symbol = ROWS[usize::from(found.row)].symbols[0];
    match found.prefix {
        0 => true,
        -3 => matches!(symbol, "m" | "s"),
        -2 => symbol == "m",
        3 => matches!(symbol, "m" | "g"),
        _ => false,
    }
}

fn is_kilogram(found: Found) -> bool {
    found.prefix == 3 && ROWS[usize::from(found.row)].symbols[0] == "g"
}

/// Runs that some take for one unit and some for another.
const AMBIGUOUS: [(&str, &str, &str); 2] = [("grad", "deg", "gon"), ("kmh", "km/h", "km h")];

/// Words that are recognized by their capitals: the noun of German is always the degree.
const CAPITALS: [(&str, &str); 2] = [("Grad", "deg"), ("KG", "kg")];

/// What a run of letters means: a symbol, a word, or several symbols.
pub(crate) fn units(name: &str, span: Range<usize>) -> Result<Joined, Error> {
    if let Some((found, one, other)) = AMBIGUOUS.into_iter().find(|(found, ..)| *found == name) {
        let kind = ErrorKind::AmbiguousUnit {
            found: found.to_owned(),
            one: one.to_owned(),
            other: other.to_owned(),
        };
        return Err(Error::new(kind, span));
    }
    let capital = CAPITALS.iter().find(|(own, _)| *own == name);
    let single = symbol(capital.map_or(name, |(_, plain)| plain))
        .or_else(|| word(name))
        .or_else(|| capital_kilo(name));
    if let Some(joined) = single.and_then(|found| Joined::NONE.with(found)) {
        return Ok(joined);
    }
    if let Some(stem) = name
        .strip_suffix('s')
        // English plurals of symbols: `5 kgs` may be kilograms or kilogram seconds.
        .filter(|stem| ["g", "kg", "mm", "cm", "km"].contains(stem))
    {
        let kind = ErrorKind::AmbiguousUnit {
            found: name.to_owned(),
            one: stem.to_owned(),
            other: format!("{stem} s"),
        };
        return Err(Error::new(kind, span));
    }
    // `Nsec`; in `radsec` a slash was forgotten.
    let glued = name
        .strip_suffix("sec")
        .filter(|head| !measures_way(head))
        .map(|head| format!("{head}s"));
    let mut search = CutSearch {
        best: None,
        rival: None,
    };
    if name.len() <= MAX_LENGTH {
        search.split(glued.as_deref().unwrap_or(name), Joined::NONE);
    }
    match (search.best, search.rival) {
        (None, _) => Err(unknown(name, span)),
        (Some(best), None) => Ok(best),
        (Some(best), Some(rival)) => {
            let kind = ErrorKind::AmbiguousUnit {
                found: name.to_owned(),
                one: best.text(),
                other: rival.text(),
            };
            Err(Error::new(kind, span))
        }
    }
}

/// What is counted per second in `mps` and `radps`: a length or an angle.
pub(crate) fn per_second(name: &str) -> Option<&str> {
    name.strip_suffix("ps").filter(|head| measures_way(head))
}

/// Whether this is the symbol of a length or an angle.
fn measures_way(name: &str) -> bool {
    symbol(name).is_some_and(|found| {
        let row = &ROWS[usize::from(found.row)];
        row.dimension == Dimension::LENGTH || row.turning == Turning::Radians
    })
}

/// `KN`, `Khz`: a kilo that should be small. Kelvin stands alone.
fn capital_kilo(name: &str) -> Option<Found> {
    let rest = name.strip_prefix('K')?;
    // `KN` is typed for kN; a kelvin newton is in no textbook of vibrations.
    let row = bare_symbol(rest).or_else(|| {
        word(rest)
            .filter(|found| found.prefix == 0 && rest == "hz")
            .map(|found| found.row)
    });
    row.filter(|&row| ROWS[usize::from(row)].prefixes)
        .map(|row| Found { row, prefix: 3 })
}

/// The likeliest way to cut a run into symbols, and another one as likely.
struct CutSearch {
    best: Option<Joined>,
    rival: Option<Joined>,
}

impl CutSearch {
    fn split(&mut self, rest: &str, head: Joined) {
        if rest.is_empty() {
            self.offer(head);
            return;
        }
        let ends = rest.char_indices().map(|(at, char)| at + char.len_utf8());
        for end in ends {
            let found = symbol(&rest[..end]).filter(|found| ROWS[usize::from(found.row)].joins);
            if let Some(longer) = found.and_then(|found| head.with(found)) {
                self.split(&rest[end..], longer);
            }
        }
    }

    fn offer(&mut self, joined: Joined) {
        match self
            .best
            .map(|best| joined.unlikeliness().cmp(&best.unlikeliness()))
        {
            Some(std::cmp::Ordering::Greater) => {}
            Some(std::cmp::Ordering::Equal) => self.rival = Some(joined),
            _ => {
                *self = Self {
                    best: Some(joined),
                    rival: None,
                }
            }
        }
    }
}
