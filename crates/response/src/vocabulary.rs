//! The words of a response: the names that it may use, functions and constants; runs of letters split into them.

use std::collections::BTreeMap;

use super::letters::{Letters, combining, dotted, greek_word};
use super::lexicon::LexiconEntry;
use super::near::typable;
use super::words::VELOCITIES;
use vibank_formula::expr::{Constant, Expr, Function, Kind, Name};
use vibank_notation::{Math, symbol};

/// The words that a response may use.
#[derive(Debug, Default)]
pub(crate) struct Words {
    words: Vec<Word>,
    /// Words by first letter.
    by_letter: BTreeMap<u8, Vec<usize>>,
    allowed: Vec<String>,
    /// Spellings with a letter that looks like the right one.
    latin: Vec<String>,
    /// Spellings of the names that move with time.
    moving: Vec<(String, Name)>,
}

#[derive(Debug)]
struct Word {
    spelling: String,
    sense: WordSense,
    /// The number of primes with which it is written.
    primes: u8,
}

/// Added to the primes of a name that is written as an initial value, `x(0)`.
pub(crate) const INITIAL: u8 = 100;

/// What a word means.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum WordSense {
    /// A name, or a time derivative of it.
    Leaf(Expr),
    /// A function of the formula language, such as `sin`.
    Function(Function),
    /// `pow`, `cbrt`: powers that are written as functions.
    Power(Powered),
    /// The imaginary unit, if there is one.
    Imaginary,
    /// `log`.
    Logarithm,
    /// A name of the item that is not allowed.
    NotAllowed,
}

/// A power that is written as a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Powered {
    /// `pow(base, exponent)`.
    Any,
    /// `cbrt(base)`.
    CubeRoot,
    /// `root(base)`, `nthroot(base, degree)`.
    Root,
    /// `complex(real, imaginary)`, which is not a power.
    Complex,
    /// `polar(modulus, angle)`.
    Polar,
    /// `Rational(1, 2)`.
    Quotient,
}

/// A word within a run of letters.
pub(crate) struct WordPiece {
    pub(crate) sense: WordSense,
    /// Places in the source.
    pub(crate) start: usize,
    pub(crate) end: usize,
    /// Whether it is spelled with the primes that follow.
    pub(crate) takes_primes: bool,
}

/// The functions that people type under other names than files do.
pub(crate) const ALIASES: &[(&str, Function)] = &[
    ("arcsin", Function::Asin),
    ("arccos", Function::Acos),
    ("arctan", Function::Atan),
    ("arctg", Function::Atan),
    ("arctan2", Function::Atan2),
    ("Arctan2", Function::Atan2),
    ("ArcTan2", Function::Atan2),
    ("ATAN2", Function::Atan2),
    ("arctg2", Function::Atan2),
    ("Arctan", Function::Atan),
    ("ArcTan", Function::Atan),
    ("ARCTAN", Function::Atan),
    ("ARCSIN", Function::Asin),
    ("ARCCOS", Function::Acos),
    ("ATAN", Function::Atan),
    ("ASIN", Function::Asin),
    ("ACOS", Function::Acos),
    ("ArcSin", Function::Asin),
    ("ArcCos", Function::Acos),
    ("fabs", Function::Abs),
    ("Abs", Function::Abs),
    ("ABS", Function::Abs),
    ("tg", Function::Tan),
    ("arsinh", Function::Asinh),
    ("arcosh", Function::Acosh),
    ("artanh", Function::Atanh),
    ("sgn", Function::Sign),
    ("signum", Function::Sign),
    // French and German.
    ("racine", Function::Sqrt),
    ("Racine", Function::Sqrt),
    ("Wurzel", Function::Sqrt),
    ("wurzel", Function::Sqrt),
    ("Re", Function::Re),
    ("Im", Function::Im),
    ("real", Function::Re),
    ("imag", Function::Im),
];

/// Whether a word is a function, also one that files do not have.
pub(crate) fn is_function(word: &str) -> bool {
    Function::of_name(word).is_some()
        || ALIASES.iter().any(|(alias, _)| *alias == word)
        || POWERS.iter().any(|(name, _)| *name == word)
}

/// What stands for infinity, in words.
const INFINITY: &[&str] = &[
    "inf",
    "Inf",
    "INF",
    "infinity",
    "Infinity",
    "infini",
    "infinito",
    "unendlich",
    "oo",
    "infty",
];

/// Powers that are written as functions.
const POWERS: &[(&str, Powered)] = &[
    ("pow", Powered::Any),
    ("power", Powered::Any),
    ("Power", Powered::Any),
    ("POWER", Powered::Any),
    ("POTENZ", Powered::Any),
    ("PUISSANCE", Powered::Any),
    ("POTENCIA", Powered::Any),
    ("POTENZA", Powered::Any),
    ("Rational", Powered::Quotient),
    ("Fraction", Powered::Quotient),
    ("cbrt", Powered::CubeRoot),
    ("root", Powered::Root),
    ("nroot", Powered::Root),
    ("nthroot", Powered::Root),
    ("complex", Powered::Complex),
    ("Complex", Powered::Complex),
    ("polar", Powered::Polar),
    ("rect", Powered::Polar),
    ("surd", Powered::Root),
    ("Surd", Powered::Root),
];

/// Functions that can stand within a run of letters, without a bracket after them.
pub(crate) const BARE: &[Function] = &[
    Function::Sin,
    Function::Cos,
    Function::Tan,
    Function::Asin,
    Function::Acos,
    Function::Atan,
    Function::Sinh,
    Function::Cosh,
    Function::Tanh,
    Function::Asinh,
    Function::Acosh,
    Function::Atanh,
    Function::Exp,
    Function::Ln,
    Function::Log10,
    Function::Sqrt,
    Function::Sign,
];

/// What is written below the letter of a natural frequency.
const INDICES: [&str; 4] = ["0", "n", "o", "N"];

/// The only natural frequency among names, `ω_n`, if it may be used.
fn natural_frequency(entries: &[LexiconEntry]) -> Option<&Name> {
    let is_natural = |entry: &&LexiconEntry| {
        let (LexiconEntry::Allowed(name, ..) | LexiconEntry::Forbidden(name)) = entry;
        let spelling = Letters::spelling(name.as_str()).unwrap_or_default();
        spelling
            .strip_prefix("omega")
            .is_some_and(|index| INDICES.contains(&index))
    };
    let mut found = entries.iter().filter(is_natural);
    match (found.next()?, found.next()) {
        (LexiconEntry::Allowed(name, ..), None) => Some(name),
        _ => None,
    }
}

/// The letter of the decay rate.
pub(crate) const DECAY_RATES: [&str; 2] = ["lambda", "lam"];

/// What the decay rate λ is in the damping ratio and the natural frequency, `ζ ω_n`, if both may be used.
fn decay_rate(entries: &[LexiconEntry]) -> Option<Expr> {
    const RATIOS: [&str; 2] = ["zeta", "xi"];
    let is_ratio = |name: &Name| RATIOS.contains(&name.as_str());
    let ratio = entries.iter().find_map(|entry| match entry {
        LexiconEntry::Allowed(name, ..) => Some(name).filter(|name| is_ratio(name)),
        LexiconEntry::Forbidden(_) => None,
    })?;
    let frequency = natural_frequency(entries)?;
    let [ratio, frequency] = [ratio, frequency].map(|name| Expr::name(name.clone()));
    Some(ratio * frequency)
}

impl Words {
    /// Functions, constants and the names of a part, in the order in which they were given.
    pub(crate) fn of(entries: &[LexiconEntry]) -> Self {
        let mut words = Self::common();
        let decay_rate = decay_rate(entries);
        // What can be said in the letters of the part may be said by its own letter.
        let is_said = |name: &Name| decay_rate.is_some() && DECAY_RATES.contains(&name.as_str());
        for entry in entries {
            match entry {
                LexiconEntry::Allowed(name, symbol, is_moving) => {
                    words.allow(name, symbol, *is_moving);
                }
                LexiconEntry::Forbidden(name) if is_said(name) => {}
                LexiconEntry::Forbidden(name) => words.forbid(name),
            }
        }
        words.add_lengths();
        words.add_velocities();
        words.add_rates();
        words.add_bare_frequency(entries);
        if let Some(name) = natural_frequency(entries) {
            words.add_indices_of_frequency(name);
        }
        if let Some(rate) = decay_rate {
            for word in DECAY_RATES {
                if !words.knows(word) {
                    words.add(word, WordSense::Leaf(rate.clone()), 0);
                }
            }
        }
        words
    }

    /// The same with the names in the other case.
    pub(crate) fn in_any_case(entries: &[LexiconEntry]) -> Self {
        let mut words = Self::of(entries);
        words.add_other_case(entries);
        words
    }

    /// `M` for m and `k1` for K₁, as telephones and shouting have them, where the item has no such name. The time, the
    /// constants, and the Greek letters whose capitals mean something else stay as they are.
    fn add_other_case(&mut self, entries: &[LexiconEntry]) {
        const OWN_SENSE: [char; 8] = ['t', 'T', 'e', 'E', 'i', 'I', 'j', 'J'];
        for entry in entries {
            let LexiconEntry::Allowed(name, symbol, is_moving) = entry else {
                continue;
            };
            let spellings = [name.as_str(), &symbol.plain()].map(Letters::spelling);
            for spelling in spellings.into_iter().flatten() {
                let mut chars = spelling.chars();
                let first = chars.next().unwrap_or_default();
                // Capitals that mean something else in this field, and those of the constants.
                const OTHERS: [&str; 5] = ["omega", "delta", "sigma", "gamma", "pi"];
                let stem = spelling.trim_end_matches(|last: char| last.is_ascii_digit());
                let is_greek = greek_word(stem).is_some() && !OTHERS.contains(&stem);
                let is_index = || chars.as_str().bytes().all(|byte| byte.is_ascii_digit());
                let is_letter = is_greek || is_index();
                let other = if first.is_ascii_uppercase() {
                    first.to_ascii_lowercase()
                } else {
                    first.to_ascii_uppercase()
                };
                let word = format!("{other}{}", chars.as_str());
                if !is_letter || !is_greek && OWN_SENSE.contains(&first) || self.knows(&word) {
                    continue;
                }
                self.add(&word, WordSense::Leaf(Expr::name(name.clone())), 0);
                let orders: &[u8] = if *is_moving { &[1, 2] } else { &[] };
                for order in orders {
                    let rate = WordSense::Leaf(Expr::name(name.clone()).prime(*order));
                    for rate_word in rates(&word, *order) {
                        self.add(&rate_word, rate.clone(), 0);
                    }
                }
            }
        }
    }

    /// `ω` for the natural frequency `ω_n` where the item has no other frequency of that letter and no angle whose rate it
    /// may be.
    fn add_bare_frequency(&mut self, entries: &[LexiconEntry]) {
        const ANGLES: [&str; 3] = ["theta", "phi", "alpha"];
        let mut only = None;
        for entry in entries {
            let (name, is_moving) = match entry {
                LexiconEntry::Allowed(name, _, is_moving) => (name, *is_moving),
                LexiconEntry::Forbidden(name) => (name, false),
            };
            let spelling = Letters::spelling(name.as_str()).unwrap_or_default();
            let is_angle = ANGLES.iter().any(|angle| spelling.starts_with(angle));
            if is_moving && is_angle {
                return;
            }
            let Some(index) = ["omega", "Omega", "w"]
                .iter()
                .find_map(|letter| spelling.strip_prefix(letter))
            else {
                continue;
            };
            let is_natural = spelling.starts_with("omega") && INDICES.contains(&index);
            let is_same = only.is_none_or(|own| own == name);
            if !is_natural || !is_same || matches!(entry, LexiconEntry::Forbidden(_)) {
                return;
            }
            only = Some(name);
        }
        let Some(name) = only else { return };
        for word in ["omega", "w"] {
            if !self.knows(word) {
                self.add(word, WordSense::Leaf(Expr::name(name.clone())), 0);
            }
        }
    }

    /// `ω_0` for the natural frequency `ω_n`, and the other way round.
    fn add_indices_of_frequency(&mut self, name: &Name) {
        for letter in ["omega", "w"] {
            for index in INDICES {
                let word = format!("{letter}{index}");
                if !self.knows(&word) {
                    self.add(&word, WordSense::Leaf(Expr::name(name.clone())), 0);
                }
            }
        }
    }

    /// Functions and constants alone.
    fn common() -> Self {
        let mut words = Self::default();
        for (constant, spelling) in [
            (Constant::Pi, "pi"),
            (Constant::Pi, "Pi"),
            (Constant::Pi, "PI"),
            // `M_PI`, as C has it.
            (Constant::Pi, "MPI"),
            (Constant::E, "e"),
        ] {
            words.add(spelling, WordSense::Leaf(Expr::constant(constant)), 0);
        }
        words.add("i", WordSense::Imaginary, 0);
        words.add("j", WordSense::Imaginary, 0);
        words.add("log", WordSense::Logarithm, 0);
        for (name, powered) in POWERS {
            words.add(name, WordSense::Power(*powered), 0);
        }
        let infinity = WordSense::Leaf(Expr::constant(Constant::Infinity));
        for name in INFINITY {
            words.add(name, infinity.clone(), 0);
        }
        let is_scalar = |function: &Function| {
            !matches!(
                function,
                Function::Transpose | Function::Det | Function::Dot | Function::Norm
            )
        };
        for function in Function::all().filter(is_scalar) {
            words.add_function(function.name(), function);
        }
        for (name, function) in ALIASES {
            words.add_function(name, *function);
        }
        // `Asin(2t)` is an amplitude before a sine.
        let is_capital = |name: &&str| name.len() > 2 && !name.starts_with('a');
        for function in BARE {
            let Some(name) = Some(function.name()).filter(is_capital) else {
                continue;
            };
            let upper = name.to_ascii_uppercase();
            let capital = format!("{}{}", &upper[..1], &name[1..]);
            words.add_function(&upper, *function);
            words.add_function(&capital, *function);
        }
        words
    }

    /// Adds a name with its symbol; one that moves with time may be primed.
    fn allow(&mut self, name: &Name, math: &Math, is_moving: bool) {
        let shown = typable(&math.plain());
        if !self.allowed.contains(&shown) {
            self.allowed.push(shown);
        }
        let sense = WordSense::Leaf(Expr::name(name.clone()));
        let own = Letters::spelling(name.as_str()).unwrap_or_default();
        self.replace(&own, sense.clone());
        if is_moving {
            self.add_dotted(&own, name);
        }
        if let Some(base) = name.as_str().strip_suffix("dot") {
            let (base, primes) = match base.strip_suffix('d') {
                Some(shorter) => (shorter, 2),
                None => (base, 1),
            };
            if let Some(base) = Letters::spelling(base.trim_end_matches('_')) {
                self.add(&base, sense.clone(), primes);
                let dots = if primes == 2 { "ddot" } else { "dot" };
                self.add(&format!("{dots}{base}"), sense.clone(), 0);
            }
        }
        let plain = math.plain();
        if let Some(value) = plain.strip_suffix("(0)") {
            let (base, order) = undotted(value)
                .unwrap_or_else(|| (Letters::spelling(value).unwrap_or_default(), 0));
            self.add(&base, sense.clone(), order + INITIAL);
        }
        if let Some((base, order)) = undotted(&plain) {
            self.add(&base, sense.clone(), order);
            // `theta0dot`, `thetadot0` for a datum that is printed with its dots.
            for word in rates(&base, order) {
                if !self.is_taken(&word) {
                    self.add(&word, sense.clone(), 0);
                }
            }
        }
        let printed = Letters::spelling(&math.plain());
        let usual = Letters::spelling(&symbol(name.as_str()).plain());
        let lambda = (name.as_str() == "lam").then(|| "lambda".to_owned());
        // As often misspelled as not.
        let is_lambda = own.starts_with("lam");
        let misspelled =
            is_lambda.then(|| own.replacen("lambda", "lam", 1).replacen("lam", "lamda", 1));
        // The letter that looks like it, `w0` for ω₀.
        let latin = [Some(&own), printed.as_ref()].map(|spelling| {
            let rest = spelling?.strip_prefix("omega")?;
            Some(format!("w{rest}"))
        });
        self.latin.extend(latin.iter().flatten().cloned());
        let ell = printed
            .as_deref()
            .and_then(|printed| printed.strip_prefix("ell"));
        let ell = match ell {
            Some(rest) => Some(format!("l{rest}")),
            // `\ell` for a letter that is printed l.
            None => own
                .strip_prefix('l')
                .filter(|rest| rest.bytes().all(|byte| byte.is_ascii_digit()))
                .map(|rest| format!("ell{rest}")),
        };
        // `varepsilon` without its backslash.
        let varied = printed.as_deref().filter(|printed| {
            let mut varied = ["epsilon", "phi", "theta", "rho"].iter();
            varied.any(|letter| printed.starts_with(letter))
        });
        let varied = varied.map(|printed| format!("var{printed}"));
        // `EA` for AE, two letters that are one name.
        let turned = match own.as_bytes() {
            [a, b] if a.is_ascii_uppercase() && b.is_ascii_uppercase() => {
                Some([*b, *a].map(char::from).into_iter().collect::<String>())
            }
            _ => None,
        };
        // `Dm` and `delta_m` for Δm.
        let difference = |letter: &str| {
            let rest = printed.as_deref()?.strip_prefix("Delta")?;
            Some(format!("{letter}{rest}"))
        };
        let (difference, small) = (difference("D"), difference("delta"));
        let [latin, of_printed] = latin;
        let others = [
            printed.clone(),
            usual,
            lambda,
            misspelled,
            latin,
            of_printed,
            ell,
            varied,
            difference,
            small,
            turned,
        ];
        for spelling in others.into_iter().flatten() {
            if spelling != own && !self.is_taken(&spelling) {
                self.replace(&spelling, sense.clone());
                if is_moving {
                    self.add_dotted(&spelling, name);
                }
            }
        }
    }

    /// Adds a name of the item that the answer may not use, so that it can be said.
    fn forbid(&mut self, name: &Name) {
        let Some(own) = Letters::spelling(name.as_str()) else {
            return;
        };
        if self.latin.contains(&own) {
            self.replace(&own, WordSense::NotAllowed);
        } else if !self.knows(&own) {
            self.add(&own, WordSense::NotAllowed, 0);
        }
    }

    /// The symbols of the names that may be used.
    pub(crate) fn allowed(&self) -> &[String] {
        &self.allowed
    }

    /// The first word of this spelling.
    fn word(&self, spelling: &str) -> Option<&Word> {
        let places = self.by_letter.get(spelling.as_bytes().first()?)?;
        let mut words = places.iter().map(|place| &self.words[*place]);
        words.find(|word| word.spelling == spelling && word.primes == 0)
    }

    /// The name of this spelling.
    pub(crate) fn name(&self, spelling: &str) -> Option<&Name> {
        match &self.word(spelling)?.sense {
            WordSense::Leaf(leaf) => match leaf.kind() {
                Kind::Name(name) => Some(name),
                _ => None,
            },
            _ => None,
        }
    }

    /// The name and the order of the rate that a word alone stands for.
    pub(crate) fn rate(&self, spelling: &str) -> Option<(&Name, u8)> {
        let own = |word: &&Word| word.spelling == spelling && word.primes == 0;
        let WordSense::Leaf(leaf) = &self.words.iter().find(own)?.sense else {
            return None;
        };
        let Kind::Prime(inner, order) = leaf.kind() else {
            return None;
        };
        match inner.kind() {
            Kind::Name(name) => Some((name, *order)),
            _ => None,
        }
    }

    /// The name that is spelled with this many primes.
    pub(crate) fn dotted_word(&self, spelling: &str, primes: u8) -> Option<Expr> {
        let own = |word: &&Word| word.spelling == spelling && word.primes == primes;
        match &self.words.iter().find(own)?.sense {
            WordSense::Leaf(leaf) => Some(leaf.clone()),
            _ => None,
        }
    }

    /// The words of a run with this many primes after it, as few as can be; the place where it sticks.
    pub(crate) fn split(
        &self,
        letters: &Letters,
        end: usize,
        primes: u8,
        has_bracket: bool,
    ) -> Result<Vec<WordPiece>, usize> {
        let text = &letters.text;
        let places: Vec<(usize, usize)> = letters
            .cuts
            .iter()
            .copied()
            .chain([(text.len(), end)])
            .collect();
        // For each place the least cost of what comes before, and the word that ends there.
        let mut best: Vec<Option<(u32, usize, usize)>> = vec![None; places.len()];
        best[0] = Some((0, 0, 0));
        let mut furthest = 0;
        for (from, (at, _)) in places.iter().enumerate() {
            let Some((cost, ..)) = best[from] else {
                continue;
            };
            furthest = from;
            let Some(first) = text.as_bytes().get(*at) else {
                continue;
            };
            for &word in self.by_letter.get(first).map_or(&[][..], Vec::as_slice) {
                let Word {
                    spelling,
                    sense,
                    primes: own,
                } = &self.words[word];
                if !text[*at..].starts_with(spelling.as_str()) {
                    continue;
                }
                let Ok(to) = places.binary_search_by_key(&(at + spelling.len()), |place| place.0)
                else {
                    continue;
                };
                let is_last = to + 1 == places.len();
                let is_bare = match sense {
                    WordSense::Function(function) => {
                        BARE.contains(function) || is_last && has_bracket
                    }
                    WordSense::Power(_) => is_last && has_bracket,
                    _ => true,
                };
                if !is_bare || *own > 0 && !(is_last && *own == primes) {
                    continue;
                }
                // A name that is spelled with its primes goes before the derivative of another.
                let cost = cost + price(sense) - u32::from(*own > 0);
                if best[to].is_none_or(|(old, ..)| cost < old) {
                    best[to] = Some((cost, from, word));
                }
            }
        }
        let last = places.len() - 1;
        if best[last].is_none() {
            return Err(places[furthest].1);
        }
        let (mut pieces, mut to) = (Vec::new(), last);
        while to > 0 {
            let Some((_, from, word)) = best[to] else {
                break;
            };
            pieces.push(WordPiece {
                sense: self.words[word].sense.clone(),
                start: places[from].1,
                end: places[to].1,
                takes_primes: self.words[word].primes > 0,
            });
            to = from;
        }
        pieces.reverse();
        Ok(pieces)
    }

    pub(crate) fn knows(&self, spelling: &str) -> bool {
        self.word(spelling).is_some()
    }

    /// Whether a spelling is that of a name or function; the item may have `e` and `i` for its own.
    fn is_taken(&self, spelling: &str) -> bool {
        self.word(spelling).is_some_and(|word| match &word.sense {
            WordSense::Leaf(leaf) => *leaf.kind() != Kind::Constant(Constant::E),
            WordSense::Imaginary | WordSense::NotAllowed => false,
            _ => true,
        })
    }

    fn add(&mut self, spelling: &str, sense: WordSense, primes: u8) {
        let Some(&first) = spelling.as_bytes().first() else {
            return;
        };
        self.by_letter
            .entry(first)
            .or_default()
            .push(self.words.len());
        self.words.push(Word {
            spelling: spelling.to_owned(),
            sense,
            primes,
        });
    }

    /// Adds a word in place of others of its spelling: the item's own names go before constants.
    fn replace(&mut self, spelling: &str, sense: WordSense) {
        let found = self
            .words
            .iter_mut()
            .find(|word| word.spelling == spelling && word.primes == 0);
        match found {
            Some(word) => word.sense = sense,
            None => self.add(spelling, sense, 0),
        }
    }

    fn add_function(&mut self, name: &str, function: Function) {
        let spelling = name.replace('_', "");
        self.add(&spelling, WordSense::Function(function), 0);
    }

    /// `L` for ℓ and `L1` for ℓ₁, where no name of the item has that letter.
    fn add_lengths(&mut self) {
        let is_length = |word: &Word| {
            let index = word.spelling.strip_prefix("ell")?;
            let is_index = index.bytes().all(|byte| byte.is_ascii_digit());
            let is_own = is_index && word.primes == 0 && matches!(word.sense, WordSense::Leaf(_));
            is_own.then(|| (format!("L{index}"), word.sense.clone()))
        };
        let lengths: Vec<(String, WordSense)> = self.words.iter().filter_map(is_length).collect();
        for (spelling, sense) in lengths {
            if !self.knows("L") && !self.knows(&spelling) {
                self.add(&spelling, sense, 0);
            }
        }
    }

    /// `v` and `a` for the velocity and the acceleration of a coordinate x, `v1` and `a1` for those of x₁, where no name
    /// of the item has that letter and no other coordinate that index.
    fn add_velocities(&mut self) {
        let (coordinates, rates) = VELOCITIES;
        let of = |(spelling, name): &(String, Name)| {
            let index = coordinates
                .iter()
                .find_map(|letter| spelling.strip_prefix(letter))?;
            let is_index = index.bytes().all(|byte| byte.is_ascii_digit());
            is_index.then(|| (index.to_owned(), name.clone()))
        };
        let mut positions: Vec<(String, Name)> = self.moving.iter().filter_map(of).collect();
        positions.dedup();
        for (index, name) in &positions {
            let is_other = |(own, other): &(String, Name)| own == index && other != name;
            if positions.iter().any(is_other) {
                continue;
            }
            for (letter, order) in rates {
                let word = format!("{letter}{index}");
                if !self.knows(letter) && !self.knows(&word) {
                    let rate = Expr::name(name.clone()).prime(*order);
                    self.add(&word, WordSense::Leaf(rate), 0);
                }
            }
        }
    }

    /// `xd`, `thetad`, `x1d` and `xd1`, where no name of the item is the letter d.
    fn add_rates(&mut self) {
        if self.knows("d") {
            return;
        }
        for (spelling, name) in std::mem::take(&mut self.moving) {
            let stem = spelling.trim_end_matches(|last: char| last.is_ascii_digit());
            let digits = &spelling[stem.len()..];
            let rate = WordSense::Leaf(Expr::name(name).prime(1));
            for word in [format!("{spelling}d"), format!("{stem}d{digits}")] {
                if !self.knows(&word) {
                    self.add(&word, rate.clone(), 0);
                }
            }
        }
    }

    /// `xdot`, `xddot`, and with a subscript `xdot1`.
    fn add_dotted(&mut self, spelling: &str, name: &Name) {
        self.moving.push((spelling.to_owned(), name.clone()));
        let stem = spelling.trim_end_matches(|last: char| last.is_ascii_digit());
        let digits = &spelling[stem.len()..];
        // As people call them in programs: `ddx1`, `xdd1`, `x1dd`, `D2x1`, `x1pp`; `dx` and `xp` mean other things, too.
        let second = WordSense::Leaf(Expr::name(name.clone()).prime(2));
        for word in [
            format!("dd{spelling}"),
            format!("D2{spelling}"),
            format!("d2{spelling}"),
            format!("{spelling}dd"),
            format!("{spelling}pp"),
            format!("{stem}dd{digits}"),
            format!("{stem}pp{digits}"),
            format!("d2{spelling}dt2"),
        ] {
            if !self.is_taken(&word) {
                self.add(&word, second.clone(), 0);
            }
        }
        for order in [1, 2] {
            let sense = WordSense::Leaf(Expr::name(name.clone()).prime(order));
            let written = (order == 1).then(|| format!("d{spelling}dt"));
            for word in rates(spelling, order).into_iter().chain(written) {
                self.add(&word, sense.clone(), 0);
            }
        }
    }
}

/// A letter with its dots as words: `xdot`, `ddotx`, and with a subscript `xdot1`.
fn rates(spelling: &str, order: u8) -> Vec<String> {
    let stem = spelling.trim_end_matches(|last: char| last.is_ascii_digit());
    let digits = &spelling[stem.len()..];
    let dots: &[&str] = match order {
        1 => &["dot"],
        2 => &["ddot", "dotdot"],
        _ => &[],
    };
    let mut words = Vec::new();
    for dots in dots {
        words.extend([format!("{spelling}{dots}"), format!("{dots}{spelling}")]);
        words.extend((!digits.is_empty()).then(|| format!("{stem}{dots}{digits}")));
    }
    words
}

/// The spelling of a symbol with dots over its letter, and how many.
fn undotted(symbol: &str) -> Option<(String, u8)> {
    let (mut plain, mut order) = (String::new(), 0);
    for char in symbol.chars() {
        if let Some(dots) = combining(char) {
            order = dots;
            continue;
        }
        let (char, dots) = dotted(char).unwrap_or((char, 0));
        order = order.max(dots);
        plain.push(char);
    }
    (order > 0).then_some((Letters::spelling(&plain)?, order))
}

/// What a word costs in a split; the least sum wins.
fn price(sense: &WordSense) -> u32 {
    match sense {
        WordSense::Leaf(leaf) if *leaf.kind() == Kind::Constant(Constant::E) => 3,
        WordSense::Imaginary | WordSense::NotAllowed => 3,
        _ => 2,
    }
}
