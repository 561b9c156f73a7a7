//! Letters that the field uses by custom where an item calls the same otherwise: ω_0 for ω_n, λ for ζ ω_n, `v` for ẋ,
//! `L` for ℓ.

use super::letters::Letters;
use super::lexicon::LexiconEntry;
use vibank_formula::expr::{Expr, Name};

/// Coordinates, and the letters of their rates with the order of each.
type CustomaryRates = (&'static [&'static str], &'static [(&'static str, u8)]);

/// Letters and words for the rates of positions: they are read wherever the item has no such letter.
const VELOCITIES: CustomaryRates = (
    &["x", "y", "z", "s", "u"],
    &[("v", 1), ("a", 2), ("vel", 1), ("accel", 2)],
);

/// Letters for the rates of other coordinates by the custom of the field. They mean other things, too, `ω` a natural
/// frequency: they are rates only where nothing else can be read.
pub(crate) const RATES: &[CustomaryRates] = &[
    (&["theta", "phi"], &[("omega", 1), ("alpha", 2)]),
    (&["q"], &[("i", 1)]),
];

/// The letter of the decay rate.
pub(crate) const DECAY_RATES: [&str; 2] = ["lambda", "lam"];

/// The letters of the damping ratio.
pub(crate) const DAMPING_RATIOS: [&str; 2] = ["zeta", "xi"];

/// `L` for ℓ, where the item may have another L.
pub const L_FOR_ELL: [&str; 2] = ["L", "ell"];

/// `e` for ε, which many cannot type.
pub const E_FOR_EPSILON: [&str; 2] = ["e", "epsilon"];

/// What is written below the letter of a natural frequency.
const INDICES: [&str; 4] = ["0", "n", "o", "N"];

/// The only natural frequency among names, `ω_n`, if it may be used.
pub(crate) fn natural_frequency(entries: &[LexiconEntry]) -> Option<&Name> {
    let mut found = entries.iter().filter(|entry| {
        let spelling = Letters::spelling(entry.name().as_str()).unwrap_or_default();
        let index = spelling.strip_prefix("omega");
        index.is_some_and(|index| INDICES.contains(&index))
    });
    match (found.next()?, found.next()) {
        (LexiconEntry::Allowed(name, ..), None) => Some(name),
        _ => None,
    }
}

/// The natural frequency under its other indices, `ω_0` for `ω_n` and the other way round.
pub(crate) fn indexed_frequencies() -> impl Iterator<Item = String> {
    let letters = ["omega", "w"].into_iter();
    letters.flat_map(|letter| INDICES.map(|index| format!("{letter}{index}")))
}

/// Symbols of the field with what textbooks define them by, in the letters of a spring, a circuit or a pendulum; the first
/// formula counts whose letters a question has.
const TEXTBOOK: [(&[&str], &[&str]); 3] = [
    (
        &["omegan", "omega0", "omega", "wn", "w0", "w"],
        &["sqrt(k/m)", "1/sqrt(L C)", "sqrt(g/ell)"],
    ),
    (&DAMPING_RATIOS, &["c/(2 sqrt(k m))", "R/2 sqrt(C/L)"]),
    (&DECAY_RATES, &["c/(2 m)", "R/(2 L)"]),
];

/// Letters for the frequency of the excitation where it has none of its own beside it.
const EXCITATION: (&[&str], &[&str]) = (&["omega", "w"], &["Omega"]);

/// The symbols of the field that a text may leave open, each with its formula as `read` has it.
pub(crate) fn of_textbooks(
    text: &str,
    read: impl Fn(&str) -> Option<Expr>,
) -> Vec<(&'static str, Expr)> {
    let has_excitation = text.contains("Omega") || text.contains('Ω');
    let excitation = (!has_excitation).then_some(EXCITATION).into_iter();
    let mut found: Vec<(&str, Expr)> = Vec::new();
    for (symbols, formulas) in excitation.chain(TEXTBOOK) {
        let Some(formula) = formulas.iter().find_map(|formula| read(formula)) else {
            continue;
        };
        let open = symbols.iter().filter(|own| read(own).is_none());
        for symbol in open {
            if found.iter().all(|(other, _)| other != symbol) {
                found.push((symbol, formula.clone()));
            }
        }
    }
    found
}

/// Whether a text is a symbol of the field that many questions leave to be defined, ω_n, ζ or λ.
pub fn is_customary(text: &str) -> bool {
    let own = Letters::spelling(text.trim_start_matches('\\'));
    own.is_some_and(|own| {
        let letters = DECAY_RATES.iter().chain(&DAMPING_RATIOS);
        letters.into_iter().any(|letter| own == **letter)
            || indexed_frequencies().any(|frequency| own == frequency)
    })
}

/// The first name that may be used among these.
fn allowed<'e>(entries: &'e [LexiconEntry], names: &[&str]) -> Option<&'e Name> {
    entries.iter().find_map(|entry| match entry {
        LexiconEntry::Allowed(name, ..) => Some(name).filter(|name| names.contains(&name.as_str())),
        LexiconEntry::Forbidden(_) => None,
    })
}

/// Letters whose value at the start, `x(0)`, and the order of the rate whose value, `x'(0)`, names of the item are: where
/// it has both `x0` and `v0`, these are no amplitudes.
pub(crate) fn initial_state(entries: &[LexiconEntry]) -> Vec<(&'static str, u8, &Name)> {
    match (allowed(entries, &["x0"]), allowed(entries, &["v0"])) {
        (Some(x0), Some(v0)) => vec![("x", 0, x0), ("x", 1, v0), ("v", 0, v0)],
        _ => Vec::new(),
    }
}

/// The natural frequency `ω_n` for which `ω` may stand, since the item has no other frequency of that letter and no angle
/// whose rate it may be.
pub(crate) fn bare_frequency(entries: &[LexiconEntry]) -> Option<&Name> {
    const ANGLES: [&str; 3] = ["theta", "phi", "alpha"];
    let mut only = None;
    for entry in entries {
        let name = entry.name();
        let is_moving = matches!(entry, LexiconEntry::Allowed(_, _, true));
        let spelling = Letters::spelling(name.as_str()).unwrap_or_default();
        let is_angle = ANGLES.iter().any(|angle| spelling.starts_with(angle));
        if is_moving && is_angle {
            return None;
        }
        let mut letters = ["omega", "Omega", "w"].iter();
        let Some(index) = letters.find_map(|letter| spelling.strip_prefix(letter)) else {
            continue;
        };
        let is_natural = spelling.starts_with("omega") && INDICES.contains(&index);
        let is_same = only.is_none_or(|own| own == name);
        if !is_natural || !is_same || matches!(entry, LexiconEntry::Forbidden(_)) {
            return None;
        }
        only = Some(name);
    }
    only
}

/// Letters with the index of the axis, `I_O`, for the moment of inertia about it: each with the name without an index for
/// which it may stand, since the item has no other name of that letter.
pub(crate) fn about_axis(entries: &[LexiconEntry]) -> Vec<(&'static str, &Name)> {
    const LETTERS: [(char, &str); 2] = [('I', "IO"), ('J', "JO")];
    let only = LETTERS.into_iter().filter_map(|(letter, word)| {
        let mut of_letter = entries
            .iter()
            .filter(|entry| entry.name().as_str().starts_with(letter));
        match (of_letter.next()?, of_letter.next()) {
            (LexiconEntry::Allowed(name, ..), None) if name.as_str().len() == 1 => {
                Some((word, name))
            }
            _ => None,
        }
    });
    only.collect()
}

/// What the decay rate λ is in the damping ratio and the natural frequency, `ζ ω_n`, if both may be used.
pub(crate) fn decay_rate(entries: &[LexiconEntry]) -> Option<Expr> {
    let ratio = allowed(entries, &DAMPING_RATIOS)?;
    let frequency = natural_frequency(entries)?;
    Some(Expr::name(ratio.clone()) * Expr::name(frequency.clone()))
}

/// What the damped frequency ω_d is in the natural one and the decay rate or the damping ratio, `√(ω_n² − λ²)`, and its
/// period, if these may be used.
pub(crate) fn damped(entries: &[LexiconEntry]) -> Option<[(&'static str, Expr); 4]> {
    let natural = natural_frequency(entries)?;
    let frequency = match allowed(entries, &DECAY_RATES) {
        Some(rate) => format!("sqrt({natural}^2 - {rate}^2)"),
        None => {
            let ratio = allowed(entries, &DAMPING_RATIOS)?;
            format!("{natural}*sqrt(1 - {ratio}^2)")
        }
    };
    let period = Expr::read(&format!("2*pi/({frequency})")).ok()?;
    let frequency = Expr::read(&frequency).ok()?;
    Some([
        ("omegad", frequency.clone()),
        ("wd", frequency),
        ("Td", period.clone()),
        ("TD", period),
    ])
}

/// A rate by a letter of its own.
pub(crate) struct CustomaryRate {
    /// The letter, which means something else where the item has it.
    pub(crate) letter: &'static str,
    /// The letter with the index of the coordinate.
    pub(crate) word: String,
    pub(crate) rate: Expr,
}

/// `v` and `a` for the velocity and the acceleration of a coordinate x, `v1` and `a1` for those of x₁, of the spellings of
/// moving names; none for an index that several coordinates have.
pub(crate) fn velocities(moving: &[(String, Name)]) -> Vec<CustomaryRate> {
    let (coordinates, rates) = VELOCITIES;
    let positions = moving.iter().filter_map(|(spelling, name)| {
        let mut letters = coordinates.iter();
        let index = letters.find_map(|letter| spelling.strip_prefix(letter))?;
        is_index(index).then(|| (index.to_owned(), name.clone()))
    });
    let mut positions: Vec<(String, Name)> = positions.collect();
    positions.dedup();
    let only = positions.iter().filter(|(index, name)| {
        let mut others = positions.iter();
        !others.any(|(own, other)| own == index && other != name)
    });
    let all = only.flat_map(|(index, name)| {
        rates.iter().map(move |(letter, order)| CustomaryRate {
            letter,
            word: format!("{letter}{index}"),
            rate: Expr::name(name.clone()).prime(*order),
        })
    });
    all.collect()
}

/// `L1` for the spelling of ℓ₁.
pub(crate) fn length(spelling: &str) -> Option<String> {
    let index = spelling.strip_prefix("ell")?;
    is_index(index).then(|| format!("L{index}"))
}

fn is_index(text: &str) -> bool {
    text.bytes().all(|byte| byte.is_ascii_digit())
}
