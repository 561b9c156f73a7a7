//! What options say, clause by clause, and which of them is meant by a response in other words.

use super::wording::{NOT, Wording, is_symbol};
use super::words::{DOUBTS, STRESSES, THINGS, TURNS};
use super::{Phrase, counts};
use vibank_source::EditDistance;

/// What joins statements of which one is enough.
const OR: &str = "or";

/// What the options of a question say.
///
/// A response means an option where each of its clauses has words of one statement of that option alone: `raise the
/// damping` stands in "lower the quality factor, that is raise the damping", `lower the damping` does not. So words may
/// come in any order, and what belongs together stays together.
///
/// ```
/// use vibank_response::{Phrase, Senses, Wording};
///
/// let options = ["elastic, through a spring", "inertial, through a mass"].map(Phrase::of_printed);
/// let senses = Senses::of(options.iter().zip(["k", "m"]), Wording::of("Which coupling is it?"));
/// let meant = |text| senses.chosen(&[senses.said(&Phrase::of(text))?], None);
/// assert_eq!(meant("by a spring"), Some(0));
/// assert_eq!(meant("inertial coupling"), Some(1));
/// assert_eq!(meant("by an inertial spring"), None);
/// ```
#[derive(Debug)]
pub struct Senses {
    options: Vec<Sense>,
    /// The words of the options, with their endings.
    spellings: Vec<String>,
    /// The words of the question, which say nothing beside an option.
    asked: Wording,
    stresses: Wording,
    things: Wording,
    turns: Wording,
    doubts: Wording,
}

/// What an option says.
#[derive(Debug)]
struct Sense {
    /// What is said at once: the words between `and`, `but`, `that is`.
    statements: Vec<Wording>,
    /// The statements and their clauses, between commas and brackets.
    clauses: Vec<Wording>,
    /// What it is called in the file.
    id: Wording,
}

impl Sense {
    fn of(option: &Phrase, id: &str) -> Self {
        let read = |pieces: Vec<Phrase>| {
            let words = pieces.iter().map(Phrase::wording);
            words.filter(|words| !words.is_empty()).collect()
        };
        Self {
            statements: read(option.statements()),
            clauses: read(option.clauses()),
            id: Wording::of(id),
        }
    }

    fn all(&self) -> impl Iterator<Item = &Wording> {
        self.statements.iter().chain([&self.id])
    }

    fn has_word(&self, word: &str) -> bool {
        self.statements.iter().any(|own| own.has_word(word))
    }

    /// Whether it is one word.
    fn is_word(&self, word: &str) -> bool {
        matches!(&self.statements[..], [only] if only.words() == [word])
    }

    /// Whether words say a whole clause of a statement of it.
    fn says_clause(&self, statement: &Wording, words: &Wording) -> bool {
        let mut clauses = self.clauses.iter();
        clauses.any(|own| own.is_part_of(words) && own.is_part_of(statement))
    }

    /// Whether it is a list of symbols, `x, y`.
    fn is_in_symbols(&self) -> bool {
        let mut words = self.statements.iter().flat_map(Wording::words);
        words.all(|word| is_symbol(word))
    }
}

impl Senses {
    /// What options with these names say.
    pub fn of<'o>(options: impl Iterator<Item = (&'o Phrase, &'o str)>, asked: Wording) -> Self {
        let mut spellings = Vec::new();
        let options = options.map(|(own, id)| {
            spellings.extend(own.spellings());
            Sense::of(own, id)
        });
        Self {
            options: options.collect(),
            spellings,
            asked,
            stresses: Wording::of(STRESSES),
            things: Wording::of(&THINGS.join(" ")),
            turns: Wording::of(&TURNS.join(" ")),
            doubts: Wording::of(&DOUBTS.join(" ")),
        }
    }

    /// What a clause says of the options; none where a word of it is unknown.
    pub fn said(&self, clause: &Phrase) -> Option<Wording> {
        let own = self.words(clause);
        let has_word = own.iter().any(|word| self.knows(word) && !is_symbol(word));
        let (mut said, mut is_cut) = (Vec::new(), false);
        for word in own {
            let is_open = word == NOT || self.doubts.has_word(&word);
            if is_open || self.knows(&word) || is_symbol(&word) && !has_word {
                said.push(word);
            } else if !self.stresses.has_word(&word) {
                let is_idle = self.asked.has_word(&word) || self.things.has_word(&word);
                if is_idle || is_name(&word) || counts::is_count(&word) {
                    is_cut = true;
                } else if self.knows_of(&word) {
                    said.push(word);
                } else {
                    return None;
                }
            }
        }
        // `lower the peak` is not "lower".
        let is_meant = !is_cut || !self.turns(&said);
        (is_meant && !self.swaps(clause)).then(|| Wording::of_words(said))
    }

    /// Whether the things of the question are named in another order: `the force lags the displacement`.
    fn swaps(&self, clause: &Phrase) -> bool {
        let own = clause.wording();
        let things = own.words().iter().filter(|word| self.things.has_word(word));
        let places =
            things.filter_map(|word| self.asked.words().iter().position(|own| own == word));
        !places.is_sorted()
    }

    /// Whether a word of a clause stands in an option.
    pub fn know(&self, clause: &Phrase) -> bool {
        self.words(clause).iter().any(|word| self.knows(word))
    }

    /// Whether a clause has words of an option, or is all symbols.
    pub fn touches(&self, clause: &Phrase) -> bool {
        let words = self.words(clause);
        let are_symbols = words.iter().all(|word| is_symbol(word));
        let own = Wording::of_words(words);
        let (mut words, mut options) = (own.words().iter(), self.options.iter());
        are_symbols
            || words.any(|word| self.knows_of(word) && !self.things.has_word(word))
            || options.any(|other| other.says_clause(&own, &own))
    }

    /// The words of a clause without slips.
    fn words(&self, clause: &Phrase) -> Vec<String> {
        let own = clause.wording();
        let own = own.words().iter();
        own.map(|word| self.slip(word).unwrap_or_else(|| word.clone()))
            .collect()
    }

    /// The only option that means all that is said; with a letter, that of the letter.
    pub fn chosen(&self, said: &[Wording], letter: Option<usize>) -> Option<usize> {
        let knows = |clause: &&Wording| clause.words().iter().any(|word| self.knows_of(word));
        let known: Vec<&Wording> = said.iter().filter(knows).collect();
        let mut words = known.iter().flat_map(|clause| clause.words());
        // Symbols that no option has may stand beside words, other values of theirs may not.
        let mut idle = said.iter().filter(|clause| !knows(clause));
        let are_names = idle.all(|clause| clause.words().iter().all(|word| is_name(word)));
        let are_idle = known.len() == said.len() || words.any(|word| !is_symbol(word));
        if known.is_empty() || !are_idle || !are_names {
            return None;
        }
        let mut places = self.meaning(&known, false);
        if places.is_empty() {
            places = self.meaning(&known, true);
        }
        if let Some(letter) = letter {
            return places.contains(&letter).then_some(letter);
        }
        let only = |holds: &dyn Fn(usize) -> bool| {
            let mut found = places.iter().copied().filter(|place| holds(*place));
            found.next().filter(|_| found.next().is_none())
        };
        only(&|place| self.is_whole(place, &known))
            .or_else(|| only(&|place| !self.leaves_out(place, &known)))
    }

    /// The options that clauses may mean, or where `is_loose` those that have their words but for what is asked about,
    /// `elastic coupling`.
    fn meaning(&self, clauses: &[&Wording], is_loose: bool) -> Vec<usize> {
        let meant = (0..self.options.len()).filter(|place| {
            clauses.iter().all(|clause| {
                let is_loose = is_loose && !self.turns(clause.words());
                let option = &self.options[*place];
                let mut all = option.all();
                all.any(|own| self.stands_in(clause, own, option, is_loose))
            })
        });
        meant.collect()
    }

    /// Whether a word says which way something goes.
    fn turns(&self, words: &[String]) -> bool {
        words.iter().any(|word| self.turns.has_word(word))
    }

    /// Whether a clause is part of a statement of an option: what is denied in one is denied in the other.
    fn stands_in(&self, clause: &Wording, own: &Wording, option: &Sense, is_loose: bool) -> bool {
        let is_thing = |word: &str| self.things.has_word(word);
        let is_idle = |word: &str| {
            // `if` is said once for all that `or` joins.
            let is_open = self.doubts.has_word(word) && option.has_word(word);
            let mut options = self.options.iter();
            // `above resonance`, where the question and an option are about that.
            let is_asked = self.asked.has_word(word) && options.any(|own| own.is_word(word));
            is_open || is_asked || is_thing(word) || self.stresses.has_word(word)
        };
        let mut words = clause.words().iter();
        let mut shared = words.clone().filter(|word| own.has_word(word));
        words.all(|word| own.has_word(word) || is_loose && is_idle(word))
            && clause.denies() == own.denies()
            && (shared.any(|word| !is_thing(word)) || option.says_clause(own, clause))
    }

    /// Whether each clause of an option is said.
    fn is_whole(&self, place: usize, said: &[&Wording]) -> bool {
        let own = &self.options[place];
        own.clauses.iter().all(|clause| {
            let mut words = clause.words().iter();
            words.any(|word| {
                !self.things.has_word(word) && said.iter().any(|said| said.has_word(word))
            })
        })
    }

    /// Whether what is not said of an option changes it: a denial, a symbol of a list, or what other options say, too.
    fn leaves_out(&self, place: usize, said: &[&Wording]) -> bool {
        let own = &self.options[place];
        let mut left = own.statements.iter().filter(|statement| {
            let mut said = said.iter();
            !said.any(|clause| self.stands_in(clause, statement, own, true))
        });
        let is_shared = |statement: &Wording| {
            let saying = self.options.iter().filter(|other| {
                let mut clauses = other.clauses.iter();
                clauses.any(|clause| clause.is_part_of(statement) || statement.is_part_of(clause))
            });
            (2..self.options.len()).contains(&saying.count())
        };
        own.is_in_symbols() || left.any(|own| own.denies() || own.has_word(OR) || is_shared(own))
    }

    /// Whether a word stands in an option.
    fn knows(&self, word: &str) -> bool {
        self.options.iter().any(|own| own.has_word(word))
    }

    /// Whether a word stands in an option or in what it is called.
    fn knows_of(&self, word: &str) -> bool {
        let mut all = self.options.iter().flat_map(Sense::all);
        all.any(|own| own.has_word(word))
    }

    /// The word of an option of which a long word is a slip by one letter, not the first.
    fn slip(&self, word: &str) -> Option<String> {
        /// Shorter words are others by one letter: `charge` and `change`, `spring` and `string`.
        const MIN_LETTERS: usize = 7;
        if self.knows_of(word) || self.asked.has_word(word) {
            return None;
        }
        let distance = EditDistance::from_word(word);
        let mut found = self.spellings.iter().filter(|own| {
            own.chars().count() >= MIN_LETTERS
                && own.chars().next() == word.chars().next()
                && distance.word(own.chars(), 1).is_some()
        });
        let meant = Wording::of(found.next()?).words().first().cloned();
        meant.filter(|meant| found.all(|own| Wording::of(own).has_word(meant)))
    }
}

/// Whether a word is a symbol, and no value of it.
fn is_name(word: &str) -> bool {
    is_symbol(word) && word.chars().all(char::is_alphanumeric)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The option that clauses of a response mean.
    fn meant(asked: &str, options: &[&str], typed: &str) -> Option<usize> {
        let words: Vec<Phrase> = options.iter().map(|own| Phrase::of_printed(own)).collect();
        let named = words.iter().zip(std::iter::repeat(""));
        let senses = Senses::of(named, Wording::of(asked));
        let clauses = Phrase::unfolded(typed).clauses();
        let said: Option<Vec<Wording>> = clauses.iter().map(|own| senses.said(own)).collect();
        senses.chosen(&said?, None)
    }

    #[test]
    fn what_belongs_together_stays_together() {
        let asked = "To make the peak of the resonance lower, one has to";
        let options = [
            "lower the quality factor, that is raise the damping",
            "raise the quality factor, that is lower the damping",
        ];
        for (typed, place) in [
            ("raise the damping", Some(0)),
            ("more damping", Some(0)),
            ("decrease Q", Some(0)),
            ("Q must go down", Some(0)),
            ("raise the damping, lower Q", Some(0)),
            ("less damping", Some(1)),
            ("higher quality factor", Some(1)),
            ("lower Q, lower the damping", None),
            ("do not lower Q", None),
            ("lower the peak", None),
            ("lower the force", None),
            ("half the damping", None),
            ("damping", None),
        ] {
            assert_eq!(meant(asked, &options, typed), place, "{typed}");
        }
        let asked = "Does the displacement lag behind the force or lead it?";
        let options = [
            "lags, at every frequency",
            "leads, at every frequency",
            "lags below $\\omega_n$ and leads above",
        ];
        for (typed, place) in [
            ("it trails the force", Some(0)),
            ("behind, always", Some(0)),
            ("leads above, lags below", Some(2)),
            ("leads below and lags above", None),
            ("the force lags behind the displacement", None),
            ("lags below", None),
            ("never lags", None),
            ("lags or leads", None),
        ] {
            assert_eq!(meant(asked, &options, typed), place, "{typed}");
        }
    }

    #[test]
    fn symbols_are_those_of_the_option() {
        let asked = "To the stiffness k?";
        let options = [
            "the moment of inertia and the inductance $L$",
            "the torsion constant and $1/C$",
            "the torsional compliance and the capacitance $C$",
        ];
        for (typed, place) in [
            ("inductance and moment of inertia", Some(0)),
            ("1/C, torsion constant", Some(1)),
            ("the capacitor", Some(2)),
            ("torsion constant and capacitance", None),
            ("inverse of the torsion constant and 1/C", None),
            ("torsion constant and L", None),
        ] {
            assert_eq!(meant(asked, &options, typed), place, "{typed}");
        }
        let asked = "Which is a valid set of generalized coordinates of one free point?";
        let options = ["$x, y, z$", "$x, y$", "$x, y, z, \\varphi, \\theta, \\psi$"];
        for (typed, place) in [
            ("x; y; z", Some(0)),
            ("x, y and z", Some(0)),
            ("the three coordinates x, y, z", Some(0)),
            ("x and y", Some(1)),
            ("x, z", None),
            ("x, y, w", None),
            ("x, y, z, φ", None),
            ("x, y or z", None),
        ] {
            assert_eq!(meant(asked, &options, typed), place, "{typed}");
        }
        let options = ["if $K = 0$ or $a = 0$", "only if $K = 0$", "never"];
        for (typed, place) in [
            ("if a = 0 or K = 0", Some(0)),
            ("if K = 0 and a = 0", None),
            ("if K = 0 or a = 1", None),
            ("a = 0", None),
            ("K = 0", Some(1)),
        ] {
            assert_eq!(
                meant("When are they independent?", &options, typed),
                place,
                "{typed}"
            );
        }
    }
}
