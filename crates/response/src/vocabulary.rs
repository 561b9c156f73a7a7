//! The words of a response: the names that it may use, functions and constants; runs of letters split into them.

use std::sync::Arc;

use super::customary::{
    CustomaryRate, DECAY_RATES, about_axis, bare_frequency, damped, decay_rate,
    indexed_frequencies, initial_state, length, natural_frequency, velocities,
};
use super::letters::Letters;
use super::lexicon::LexiconEntry;
use super::near::typable;
use super::spellings::{
    first_rates, in_other_case, others, rates, second_rates, shortened, undotted,
};
use super::words::{ALIASES, BARE, INFINITY, POWERS, Powered};
use vibank_dynamics::numerics::SortedMap;
use vibank_formula::expr::{Constant, Expr, Function, Kind, Name};
use vibank_notation::Math;

/// Names with the symbols by which they are printed.
type Symbols = SortedMap<Name, Arc<Math>>;

/// The words that a response may use.
#[derive(Debug, Default)]
pub(crate) struct Words {
    words: Vec<Word>,
    /// Words by first letter.
    by_letter: SortedMap<u8, Vec<usize>>,
    allowed: Vec<String>,
    /// Spellings with a Greek letter shortened.
    shortened: Vec<String>,
    /// Spellings of names that are not printed so.
    lent: Vec<String>,
    /// The words before the letters of names that are printed as parts of others, `Im` and `Z`, with these names.
    parts: Vec<(String, String, Name)>,
    /// Spellings of the names that move with time.
    moving: Vec<(String, Name)>,
}

#[derive(Debug)]
struct Word {
    spelling: String,
    sense: WordSense,
    ending: Ending,
}

/// What stands after the letters of a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ending {
    /// So many primes.
    Primes(u8),
    /// So many primes and the start in brackets, as initial values have them, `x'(0)`.
    Initial(u8),
}

impl Ending {
    const NONE: Self = Self::Primes(0);
}

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

impl WordSense {
    fn of_name(name: &Name) -> Self {
        Self::Leaf(Expr::name(name.clone()))
    }

    /// A time derivative of a name.
    fn of_rate(name: &Name, order: u8) -> Self {
        Self::Leaf(Expr::name(name.clone()).prime(order))
    }
}

/// A word within a run of letters.
pub(crate) struct WordPiece {
    pub(crate) sense: WordSense,
    /// Places in the source.
    pub(crate) start: usize,
    pub(crate) end: usize,
    /// Whether what follows is a part of its spelling.
    pub(crate) takes_ending: bool,
}

impl Words {
    /// Functions, constants and the names of a part, in the order in which they were given.
    pub(crate) fn of(entries: &[LexiconEntry], symbols: &Symbols) -> Self {
        let mut words = Self::common();
        let decay_rate = decay_rate(entries);
        // What can be said in the letters of the part may be said by its own letter.
        for entry in entries {
            match entry {
                LexiconEntry::Allowed(name, symbol, is_moving) => {
                    words.allow(name, symbol, *is_moving);
                }
                LexiconEntry::Forbidden(name)
                    if decay_rate.is_some() && DECAY_RATES.contains(&name.as_str()) => {}
                LexiconEntry::Forbidden(name) => words.forbid(name),
            }
        }
        words.add_capital_w(entries, symbols);
        words.add_lengths();
        words.add_velocities();
        words.add_first_rates();
        if let Some(name) = bare_frequency(entries) {
            for word in ["omega", "w"] {
                words.offer(word, &WordSense::of_name(name));
            }
        }
        if let Some(name) = natural_frequency(entries) {
            for word in indexed_frequencies() {
                words.offer(&word, &WordSense::of_name(name));
            }
        }
        for (word, name) in about_axis(entries) {
            words.offer(word, &WordSense::of_name(name));
        }
        for (word, meaning) in damped(entries).into_iter().flatten() {
            words.offer(word, &WordSense::Leaf(meaning));
        }
        for (letter, order, name) in initial_state(entries) {
            words.add_ended(letter, WordSense::of_name(name), Ending::Initial(order));
        }
        if let Some(rate) = decay_rate {
            for word in DECAY_RATES {
                words.offer(word, &WordSense::Leaf(rate.clone()));
            }
        }
        words
    }

    /// `W` for Ω, where no letter is printed so and it cannot be a `w` for ω.
    fn add_capital_w(&mut self, entries: &[LexiconEntry], symbols: &Symbols) {
        let spellings = |entry: &LexiconEntry| {
            let name = entry.name();
            let printed = symbols.get(name).map(|own| own.plain());
            let all = [Some(name.to_string()), printed].into_iter().flatten();
            all.filter_map(|own| Letters::spelling(&own))
                .collect::<Vec<_>>()
        };
        let is_rival = |own: &String| own.starts_with(['W', 'w']) || own.starts_with("omega");
        if entries.iter().flat_map(spellings).any(|own| is_rival(&own)) {
            return;
        }
        for entry in entries {
            let LexiconEntry::Allowed(name, ..) = entry else {
                continue;
            };
            for own in spellings(entry) {
                if let Some(index) = own.strip_prefix("Omega") {
                    self.offer(&format!("W{index}"), &WordSense::of_name(name));
                }
            }
        }
    }

    /// The same with the names in the other case.
    pub(crate) fn in_any_case(entries: &[LexiconEntry], symbols: &Symbols) -> Self {
        let mut words = Self::of(entries, symbols);
        words.add_other_case(entries);
        words
    }

    /// The names in the other case, where the item has no such name.
    fn add_other_case(&mut self, entries: &[LexiconEntry]) {
        // `ω` for Ω is no natural frequency only where the item has none.
        let mut names = entries.iter().map(|entry| entry.name().as_str());
        let has_natural = names.any(|name| name.starts_with("omega"));
        for entry in entries {
            let LexiconEntry::Allowed(name, symbol, is_moving) = entry else {
                continue;
            };
            let spellings = [name.as_str(), &symbol.plain()].map(Letters::spelling);
            for spelling in spellings.into_iter().flatten() {
                let word = in_other_case(&spelling).filter(|word| !self.knows(word));
                let Some(word) = word.filter(|word| !(has_natural && word.starts_with("omega")))
                else {
                    continue;
                };
                let short: Vec<String> = shortened(&word).collect();
                self.add(&word, WordSense::of_name(name));
                for word in short {
                    self.offer(&word, &WordSense::of_name(name));
                }
                let orders: &[u8] = if *is_moving { &[1, 2] } else { &[] };
                for order in orders {
                    for rate in rates(&word, *order) {
                        self.add(&rate, WordSense::of_rate(name, *order));
                    }
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
            words.add(spelling, WordSense::Leaf(Expr::constant(constant)));
        }
        words.add("i", WordSense::Imaginary);
        words.add("j", WordSense::Imaginary);
        words.add("log", WordSense::Logarithm);
        for (name, powered) in POWERS {
            words.add(name, WordSense::Power(*powered));
        }
        let infinity = WordSense::Leaf(Expr::constant(Constant::Infinity));
        for name in INFINITY {
            words.add(name, infinity.clone());
        }
        use Function::{Det, Dot, Norm, Transpose};
        let scalar = Function::all().filter(|own| !matches!(own, Transpose | Det | Dot | Norm));
        scalar.for_each(|function| words.add_function(function.name(), function));
        for (name, function) in ALIASES {
            words.add_function(name, *function);
        }
        // `Asin(2t)` is an amplitude before a sine.
        for function in BARE {
            let name = function.name();
            if name.len() <= 2 || name.starts_with('a') {
                continue;
            }
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
        let sense = WordSense::of_name(name);
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
                self.add_ended(&base, sense.clone(), Ending::Primes(primes));
                let dots = if primes == 2 { "ddot" } else { "dot" };
                self.add(&format!("{dots}{base}"), sense.clone());
            }
        }
        let plain = math.plain();
        if let Some((part @ ("Re" | "Im" | "arg"), whole)) = plain.split_once(' ')
            && let Some(whole) = Letters::spelling(whole)
        {
            self.parts.push((part.to_owned(), whole, name.clone()));
        }
        if let Some(value) = plain.strip_suffix("(0)") {
            let (base, order) = undotted(value)
                .unwrap_or_else(|| (Letters::spelling(value).unwrap_or_default(), 0));
            self.add_ended(&base, sense.clone(), Ending::Initial(order));
        }
        if let Some((base, order)) = undotted(&plain) {
            self.add_ended(&base, sense.clone(), Ending::Primes(order));
            // `theta0dot`, `thetadot0` for a datum that is printed with its dots.
            for word in rates(&base, order) {
                if !self.is_taken(&word) {
                    self.add(&word, sense.clone());
                }
            }
        }
        let printed = Letters::spelling(&plain).unwrap_or_default();
        self.shortened
            .extend([own.as_str(), &printed].into_iter().flat_map(shortened));
        for spelling in others(name, &own, math) {
            // `ℓ` for L gives way to a letter that is printed so.
            let is_printed = spelling == printed;
            if is_printed && self.lent.contains(&spelling) || !self.is_taken(&spelling) {
                self.replace(&spelling, sense.clone());
                self.lent.extend((!is_printed).then(|| spelling.clone()));
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
        if self.shortened.contains(&own) {
            self.replace(&own, WordSense::NotAllowed);
        } else if !self.knows(&own) {
            self.add(&own, WordSense::NotAllowed);
        }
    }

    /// The name that a text begins with as the part of another, `Im Z` and `Im(Z)`, and how long that is.
    pub(crate) fn part(&self, text: &str) -> Option<(&Name, usize)> {
        let is_letter = |char: char| char.is_alphanumeric() || char == '_';
        self.parts.iter().find_map(|(part, whole, name)| {
            let behind = text.strip_prefix(part.as_str())?.trim_start_matches(' ');
            let inner = behind.strip_prefix('(');
            let letters = inner.unwrap_or(behind);
            let rest = letters.trim_start_matches(is_letter);
            let own = Letters::spelling(&letters[..letters.len() - rest.len()])?;
            let end = inner.map_or(Some(rest), |_| rest.strip_prefix(')'))?;
            (own == *whole).then_some((name, text.len() - end.len()))
        })
    }

    /// The symbols of the names that may be used.
    pub(crate) fn allowed(&self) -> &[String] {
        &self.allowed
    }

    /// The first word of this spelling.
    fn word(&self, spelling: &str) -> Option<&Word> {
        let places = self.by_letter.get(spelling.as_bytes().first()?)?;
        let mut words = places.iter().map(|place| &self.words[*place]);
        words.find(|word| word.spelling == spelling && word.ending == Ending::NONE)
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
        let leaf = self.leaf(spelling, Ending::NONE)?;
        let Kind::Prime(inner, order) = leaf.kind() else {
            return None;
        };
        match inner.kind() {
            Kind::Name(name) => Some((name, *order)),
            _ => None,
        }
    }

    /// The name that is spelled with this ending.
    pub(crate) fn ended(&self, spelling: &str, ending: Ending) -> Option<Expr> {
        self.leaf(spelling, ending).cloned()
    }

    fn leaf(&self, spelling: &str, ending: Ending) -> Option<&Expr> {
        let mut words = self.words.iter();
        let own = words.find(|word| word.spelling == spelling && word.ending == ending)?;
        match &own.sense {
            WordSense::Leaf(leaf) => Some(leaf),
            _ => None,
        }
    }

    /// The words of a run with this ending, as few as can be; the place where it sticks.
    pub(crate) fn split(
        &self,
        letters: &Letters,
        end: usize,
        ending: Ending,
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
                    ending: own,
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
                let has_ending = *own != Ending::NONE;
                if !is_bare || has_ending && !(is_last && *own == ending) {
                    continue;
                }
                // A name that is spelled with its ending goes before the derivative of another.
                let cost = cost + price(sense) - u32::from(has_ending);
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
                takes_ending: self.words[word].ending != Ending::NONE,
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

    /// Adds a word that is not known.
    fn offer(&mut self, spelling: &str, sense: &WordSense) {
        if !self.knows(spelling) {
            self.add(spelling, sense.clone());
        }
    }

    fn add(&mut self, spelling: &str, sense: WordSense) {
        self.add_ended(spelling, sense, Ending::NONE);
    }

    /// Adds a word that is spelled with what stands after it.
    fn add_ended(&mut self, spelling: &str, sense: WordSense, ending: Ending) {
        let Some(&first) = spelling.as_bytes().first() else {
            return;
        };
        let places = self.by_letter.get_or_insert_with(first, Vec::new);
        places.push(self.words.len());
        self.words.push(Word {
            spelling: spelling.to_owned(),
            sense,
            ending,
        });
    }

    /// Adds a word in place of others of its spelling: the item's own names go before constants.
    fn replace(&mut self, spelling: &str, sense: WordSense) {
        let found = self
            .words
            .iter_mut()
            .find(|word| word.spelling == spelling && word.ending == Ending::NONE);
        match found {
            Some(word) => word.sense = sense,
            None => self.add(spelling, sense),
        }
    }

    fn add_function(&mut self, name: &str, function: Function) {
        let spelling = name.replace('_', "");
        self.add(&spelling, WordSense::Function(function));
    }

    /// `L` for ℓ and `L1` for ℓ₁, where no name of the item has that letter.
    fn add_lengths(&mut self) {
        let lengths = self.words.iter().filter_map(|word| {
            let is_own = word.ending == Ending::NONE && matches!(word.sense, WordSense::Leaf(_));
            let word_for_it = length(&word.spelling).filter(|_| is_own)?;
            Some((word_for_it, word.sense.clone()))
        });
        let lengths: Vec<(String, WordSense)> = lengths.collect();
        for (spelling, sense) in lengths {
            if !self.knows("L") {
                self.offer(&spelling, &sense);
            }
        }
    }

    /// `v` and `a` for the velocity and the acceleration of a coordinate, where no name of the item has that letter.
    fn add_velocities(&mut self) {
        for CustomaryRate { letter, word, rate } in velocities(&self.moving) {
            if !self.knows(letter) {
                self.offer(&word, &WordSense::Leaf(rate));
            }
        }
    }

    /// `xd`, `thetad`, `x1d` and `xd1`, where no name of the item is the letter d.
    fn add_first_rates(&mut self) {
        if self.knows("d") {
            return;
        }
        for (spelling, name) in std::mem::take(&mut self.moving) {
            for word in first_rates(&spelling) {
                self.offer(&word, &WordSense::of_rate(&name, 1));
            }
        }
    }

    /// `xdot`, `xddot`, and with a subscript `xdot1`.
    fn add_dotted(&mut self, spelling: &str, name: &Name) {
        self.moving.push((spelling.to_owned(), name.clone()));
        for word in second_rates(spelling) {
            if !self.is_taken(&word) {
                self.add(&word, WordSense::of_rate(name, 2));
            }
        }
        for order in [1, 2] {
            let written = (order == 1).then(|| format!("d{spelling}dt"));
            for word in rates(spelling, order).into_iter().chain(written) {
                self.add(&word, WordSense::of_rate(name, order));
            }
        }
    }
}

/// What a word costs in a split; the least sum wins.
fn price(sense: &WordSense) -> u32 {
    match sense {
        WordSense::Leaf(leaf) if *leaf.kind() == Kind::Constant(Constant::E) => 3,
        WordSense::Imaginary | WordSense::NotAllowed => 3,
        _ => 2,
    }
}
