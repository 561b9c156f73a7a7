//! What names a response may use, with their symbols; what people type for them is made out when one is read.

use std::sync::{Arc, OnceLock};

use super::letters::Letters;
use super::near::{ends_with_function, nearest, typable};
use super::signs::is_digit;
use super::vocabulary::{Ending, WordPiece, Words};
use super::{Manner, Trouble};
use vibank_dynamics::numerics::SortedMap;
use vibank_formula::expr::{Expr, Kind, Name, Notation, Substitution, Symbol};
use vibank_notation::{Math, symbol};

/// The names that a response may use.
#[derive(Debug, Default)]
pub struct Lexicon {
    entries: Vec<LexiconEntry>,
    symbols: SortedMap<Name, Arc<Math>>,
    moving: Vec<Name>,
    /// Only a response asks for them.
    words: OnceLock<Words>,
    /// With the names in the other case; only where words cannot be read.
    in_any_case: OnceLock<Words>,
    /// How the names that may not be used are spelt, by themselves and as they are printed; asked for each statement.
    forbidden: OnceLock<Vec<(String, Name)>>,
}

/// A name of the item.
#[derive(Clone, Debug)]
pub(crate) enum LexiconEntry {
    /// It may be used; with its symbol, and whether it moves with time.
    Allowed(Name, Arc<Math>, bool),
    /// It may not.
    Forbidden(Name),
}

impl LexiconEntry {
    pub(crate) fn name(&self) -> &Name {
        let (Self::Allowed(name, ..) | Self::Forbidden(name)) = self;
        name
    }
}

impl Lexicon {
    /// Functions and constants alone.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a name with its symbol; one that moves with time may be primed.
    pub fn allow(&mut self, name: &Name, math: impl Into<Arc<Math>>, is_moving: bool) {
        let math = math.into();
        self.symbols.insert(name.clone(), Arc::clone(&math));
        if is_moving {
            self.moving.push(name.clone());
        }
        self.add(LexiconEntry::Allowed(name.clone(), math, is_moving));
    }

    /// The same with one name more, which does not move with time.
    #[must_use]
    pub fn with(&self, name: &Name, math: impl Into<Arc<Math>>) -> Self {
        let mut lexicon = self.unworded();
        lexicon.allow(name, math, false);
        lexicon
    }

    /// The same with more names, which move with time.
    #[must_use]
    pub(crate) fn with_moving(&self, names: impl Iterator<Item = Name>) -> Self {
        let mut lexicon = self.unworded();
        for name in names {
            let own = self.symbols.get(&name).cloned();
            let own = own.unwrap_or_else(|| Arc::new(symbol(name.as_str())));
            lexicon.allow(&name, own, true);
        }
        lexicon
    }

    /// The same names before their words were made out.
    fn unworded(&self) -> Self {
        Self {
            entries: self.entries.clone(),
            symbols: self.symbols.clone(),
            moving: self.moving.clone(),
            words: OnceLock::new(),
            in_any_case: OnceLock::new(),
            forbidden: OnceLock::new(),
        }
    }

    /// The name of this spelling that may not be used, by itself or as it is printed.
    pub(crate) fn forbidden(&self, spelling: &str) -> Option<&Name> {
        let spellings = self.forbidden.get_or_init(|| self.forbidden_spellings());
        let found = spellings.iter().find(|(own, _)| own == spelling);
        found.map(|(_, name)| name)
    }

    fn forbidden_spellings(&self) -> Vec<(String, Name)> {
        let mut spellings = Vec::new();
        for entry in &self.entries {
            let LexiconEntry::Forbidden(name) = entry else {
                continue;
            };
            let printed = self.symbols.get(name).map(|own| own.plain());
            let texts = [Some(name.as_str()), printed.as_deref()].into_iter();
            let own = texts.flatten().filter_map(Letters::spelling);
            spellings.extend(own.map(|own| (own, name.clone())));
        }
        spellings
    }

    /// The names that move with time.
    pub(crate) fn moving_names(&self) -> impl Iterator<Item = &Name> {
        self.moving.iter()
    }

    /// The name of this letter, whether the answer may use it or not, and that of the one for which many type it as well,
    /// `L` and ℓ, if the latter may be used and both are not the same.
    pub fn stand_in(&self, [letter, meant]: [&str; 2]) -> Option<[Name; 2]> {
        let meant = self.reads(meant)?.clone();
        let own = self.reads(letter).or_else(|| self.forbidden(letter));
        let own = own.cloned().unwrap_or_else(|| Name::new(letter));
        (own != meant).then_some([own, meant])
    }

    /// Adds a name of the item that the answer may not use, so that it can be said.
    pub fn forbid(&mut self, name: &Name) {
        self.add(LexiconEntry::Forbidden(name.clone()));
    }

    /// The name of two letters that a text begins with as a product, `A*E` and `E A` for AE, and how long that is.
    pub(crate) fn product(&self, text: &str) -> Option<(&Name, usize)> {
        let first = text.chars().next().filter(char::is_ascii_uppercase)?;
        let second = text[1..].trim_start_matches([' ', '*']);
        let length = text.len() - second.len() + 1;
        let second = second.chars().next().filter(char::is_ascii_uppercase)?;
        let is_whole =
            !text[length..].starts_with(|next: char| next.is_alphanumeric() || "_'".contains(next));
        let is_known = |letter: char| self.reads(letter.encode_utf8(&mut [0; 4])).is_some();
        let mut allowed = self.entries.iter().filter_map(|entry| match entry {
            LexiconEntry::Allowed(name, ..) => Some(name),
            LexiconEntry::Forbidden(_) => None,
        });
        let name = allowed.find(|name| {
            let own = name.as_str().chars();
            own.clone().eq([first, second]) || own.eq([second, first])
        })?;
        (is_whole && !is_known(first) && !is_known(second)).then_some((name, length))
    }

    /// The name that a text begins with as the part of another, `Im Z`, and how long that is.
    pub(crate) fn part(&self, text: &str) -> Option<(&Name, usize)> {
        self.words().part(text)
    }

    /// Whether no name may be used.
    pub(crate) fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    fn add(&mut self, entry: LexiconEntry) {
        self.entries.push(entry);
        self.words.take();
        self.in_any_case.take();
        self.forbidden.take();
    }

    fn words(&self) -> &Words {
        self.words
            .get_or_init(|| Words::of(&self.entries, &self.symbols))
    }

    /// The name that a word is read as, also in another spelling: ω₁ for `w1`.
    pub fn reads(&self, word: &str) -> Option<&Name> {
        self.words().name(word)
    }

    /// Another symbol for a name that is there.
    pub fn set_symbol(&mut self, name: &Name, math: Arc<Math>) {
        self.symbols.insert(name.clone(), math);
        self.forbidden.take();
    }

    /// A name as it is printed, in signs that can be typed: `k2` for k₂.
    pub fn typable(&self, name: &Name) -> String {
        typable(&self.name(name).math.plain())
    }

    /// A letter or its time derivative as it can be typed: as it is printed where that is read as this letter, by its
    /// name otherwise.
    pub fn typed(&self, letter: &Expr) -> String {
        let (name, order) = match letter.kind() {
            Kind::Prime(inner, order) => (inner.kind(), usize::from(*order)),
            kind => (kind, 0),
        };
        let Kind::Name(name) = name else {
            return letter.to_string();
        };
        let printed = self.typable(name);
        let is_read = super::formula(&printed, self, Manner::default())
            .is_ok_and(|typed| typed.value == Expr::name(name.clone()) && typed.others.is_empty());
        let base = if is_read { printed } else { name.to_string() };
        base + &"'".repeat(order)
    }

    /// A formula in the formula language with the names as they are printed.
    pub fn written(&self, formula: &Expr) -> String {
        let names = formula.names().free.into_iter();
        let printed = names.fold(Substitution::new(), |put, variable| {
            let printed = Expr::name(self.typable(&variable.name).as_str());
            put.with(variable.name, printed)
        });
        let printed = printed.apply(formula);
        printed.map_or_else(|_| formula.to_string(), |printed| printed.to_string())
    }

    /// That a name of the item may not be used, with those that may.
    pub(crate) fn not_allowed(&self) -> Trouble {
        Trouble::NotAllowed(self.listed())
    }

    /// That a word is no name, with the name that is nearest to it or all that there are.
    pub(crate) fn unknown(&self, word: &str) -> Trouble {
        let near = nearest(self.words().allowed(), word);
        let letters = match near {
            Some(_) => Vec::new(),
            None => self.listed(),
        };
        Trouble::Unknown { near, letters }
    }

    /// The names that may be used, unless they are too many to be read.
    fn listed(&self) -> Vec<String> {
        const MAX_LISTED: usize = 12;
        let allowed = self.words().allowed();
        if (1..=MAX_LISTED).contains(&allowed.len()) {
            allowed.to_vec()
        } else {
            Vec::new()
        }
    }

    /// Whether a run of letters ends with a function for which the number after it is the argument, `sin2θ`.
    pub(crate) fn ends_with_function(&self, run: &str, behind: &str) -> bool {
        let digits = behind.trim_start_matches(is_digit);
        let number = &behind[..behind.len() - digits.len()];
        ends_with_function(run, number) && !self.knows(&format!("{run}{number}"))
    }

    /// Whether a spelling is that of a name or function.
    pub(crate) fn knows(&self, spelling: &str) -> bool {
        self.words().knows(spelling)
    }

    /// Whether a name moves with time.
    pub fn is_moving(&self, name: &Name) -> bool {
        self.moving.contains(name)
    }

    /// The moving name of this spelling.
    pub(crate) fn moving(&self, spelling: &str) -> Option<&Name> {
        self.words()
            .name(spelling)
            .filter(|name| self.is_moving(name))
    }

    /// The derivative of this order of the name of this spelling, as dots over it would have it.
    pub(crate) fn dotted(&self, spelling: &str, order: u8) -> Option<Expr> {
        if let Some(name) = self.moving(spelling) {
            return Some(Expr::name(name.clone()).prime(order));
        }
        self.ended(spelling, Ending::Primes(order))
    }

    /// The derivative of this order of the rate that a letter stands for, `dv/dt`.
    pub(crate) fn rate(&self, letter: &str, order: u8) -> Option<Expr> {
        let (name, own) = self.words().rate(letter)?;
        Some(Expr::name(name.clone()).prime(own + order))
    }

    /// The name that is spelled with this ending.
    pub(crate) fn ended(&self, spelling: &str, ending: Ending) -> Option<Expr> {
        self.words().ended(spelling, ending)
    }

    /// The words of a run with this ending, as few as can be; the place where it sticks.
    pub(crate) fn split(
        &self,
        letters: &Letters,
        end: usize,
        ending: Ending,
        has_bracket: bool,
    ) -> Result<Vec<WordPiece>, usize> {
        self.words().split(letters, end, ending, has_bracket)
    }

    /// The words of a run whose letters may be in the other case, `K1` for k1.
    pub(crate) fn split_in_any_case(
        &self,
        letters: &Letters,
        end: usize,
        ending: Ending,
    ) -> Option<Vec<WordPiece>> {
        let words = || Words::in_any_case(&self.entries, &self.symbols);
        let words = self.in_any_case.get_or_init(words);
        words.split(letters, end, ending, false).ok()
    }
}

impl Notation for Lexicon {
    fn name(&self, name: &Name) -> Symbol {
        let own = self.symbols.get(name);
        Symbol::letter(own.map_or_else(|| symbol(name.as_str()), |own| Math::clone(own)))
    }
}
