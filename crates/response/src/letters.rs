//! Letters of names in one spelling: Greek as words, subscripts as plain characters, no underscores.

use vibank_notation::{GREEK, greek_name};

/// A name or a run of typed letters in one spelling, and where in the text its pieces may be cut.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Letters {
    /// The spelling.
    pub(crate) text: String,
    /// For each place in the spelling where it may be cut, the place in the source; ascending.
    pub(crate) cuts: Vec<(usize, usize)>,
}

impl Letters {
    /// The spelling of a whole name.
    pub(crate) fn spelling(name: &str) -> Option<String> {
        let mut letters = Self::default();
        for (at, char) in name.char_indices() {
            if char != '_' && char != '{' && char != '}' && !letters.push(char, at, at) {
                return None;
            }
        }
        Some(letters.text).filter(|text| !text.is_empty())
    }

    /// Adds a letter or digit that begins at `at`; whether it is one.
    pub(crate) fn push(&mut self, char: char, at: usize, _end: usize) -> bool {
        // `k_∥`
        if let Some(word) = sign_of_subscript(char).filter(|_| !self.text.is_empty()) {
            self.text.push_str(word);
            return true;
        }
        let plain = match char {
            '₀'..='₉' => char::from(b'0' + (u32::from(char) - u32::from('₀')) as u8),
            _ => lowered(char).unwrap_or(char),
        };
        if !plain.is_ascii_alphanumeric() && greek(plain).is_none() && !is_letter(plain) {
            return false;
        }
        // Digits and subscripts belong to the letter before them.
        let is_subscript = plain.is_ascii_digit() || plain != char;
        if !is_subscript || self.text.is_empty() {
            self.cuts.push((self.text.len(), at));
        }
        match greek(plain) {
            Some(name) => self.text.push_str(name),
            None => self.text.push(plain),
        }
        true
    }

    /// The place of an unknown letter that is the last of a run, after names: where the run cannot be split.
    pub(crate) fn unknown_from(&self, stuck: usize) -> Option<usize> {
        let (_, last) = self.cuts.last()?;
        (*last == stuck).then_some(stuck)
    }

    /// Adds a word that is not cut, such as a Greek letter by its command.
    pub(crate) fn push_word(&mut self, word: &str, at: usize) {
        self.cuts.push((self.text.len(), at));
        self.text.push_str(word);
    }

    /// Takes back the last cut: what follows belongs to what stands before it.
    pub(crate) fn join_from(&mut self, length: usize) {
        self.cuts.retain(|(own, _)| *own < length || *own == 0);
    }
}

/// The letter or digit with which a text begins, by its length and in one spelling: `ω` and `omega` are one.
pub(crate) fn letter(text: &str) -> Option<(usize, String)> {
    let run = text.find(|char: char| !char.is_ascii_alphabetic());
    let run = &text[..run.unwrap_or(text.len())];
    let word = (2..=run.len())
        .rev()
        .find_map(|end| greek_word(&run[..end]).map(|word| (end, word)));
    if let Some((length, word)) = word {
        return Some((length, word.to_owned()));
    }
    let first = text.chars().next()?;
    let mut letters = Letters::default();
    let is_letter = letters.push(first, 0, 0);
    is_letter.then_some((first.len_utf8(), letters.text))
}

/// The name of the command of LaTeX that begins a text with its backslash.
pub(crate) fn name_of_command(text: &str) -> &str {
    let name = &text[1..];
    let end = name.find(|char: char| !char.is_ascii_alphabetic());
    &name[..end.unwrap_or(name.len())]
}

/// The letter that stands as a subscript.
pub(crate) fn lowered(char: char) -> Option<char> {
    const LOWERED: &[(char, char)] = &[
        ('ₐ', 'a'),
        ('ₑ', 'e'),
        ('ₕ', 'h'),
        ('ᵢ', 'i'),
        ('ⱼ', 'j'),
        ('ₖ', 'k'),
        ('ₗ', 'l'),
        ('ₘ', 'm'),
        ('ₙ', 'n'),
        ('ₒ', 'o'),
        ('ₚ', 'p'),
        ('ᵣ', 'r'),
        ('ₛ', 's'),
        ('ₜ', 't'),
        ('ᵤ', 'u'),
        ('ᵥ', 'v'),
        ('ₓ', 'x'),
    ];
    let found = LOWERED.iter().find(|(sign, _)| *sign == char);
    found.map(|(_, letter)| *letter)
}

/// The word of a sign that stands as a subscript: what is parallel or at right angles.
fn sign_of_subscript(char: char) -> Option<&'static str> {
    match char {
        '∥' => Some("par"),
        '⊥' => Some("perp"),
        _ => None,
    }
}

/// The sign of a subscript with which a text begins, in the ways in which it is typed, and its length.
pub(crate) fn sign_in_subscript(text: &str) -> Option<(char, usize)> {
    const SPELLINGS: [(&str, char); 5] = [
        ("\\parallel", '∥'),
        ("\\|", '∥'),
        ("||", '∥'),
        ("//", '∥'),
        ("\\perp", '⊥'),
    ];
    let found = SPELLINGS
        .iter()
        .find(|(spelling, _)| text.starts_with(spelling));
    found.map(|(spelling, sign)| (*sign, spelling.len()))
}

/// Letters that are neither ASCII nor Greek, as in `ℓ`.
fn is_letter(char: char) -> bool {
    char == 'ℓ'
}

/// The word of a Greek letter, its variants included.
pub(crate) fn greek(char: char) -> Option<&'static str> {
    Some(match char {
        'ϕ' => "phi",
        'ϵ' => "epsilon",
        'ϑ' => "theta",
        'µ' => "mu",
        'Ω' => "Omega",
        'ϱ' => "rho",
        'ℓ' => "ell",
        _ => return greek_name(char).map(unvaried),
    })
}

/// The word of a Greek letter by its command, `omega` or `varphi`.
pub(crate) fn greek_word(command: &str) -> Option<&'static str> {
    let (name, _) = GREEK.iter().find(|(name, _)| *name == command)?;
    Some(unvaried(name))
}

fn unvaried(name: &'static str) -> &'static str {
    match name {
        "varphi" => "phi",
        "varepsilon" => "epsilon",
        "vartheta" => "theta",
        "varrho" => "rho",
        _ => name,
    }
}

/// A letter with dots over it.
pub(crate) fn dotted(char: char) -> Option<(char, u8)> {
    Some(match char {
        'Ė' => ('E', 1),
        'ẋ' => ('x', 1),
        'ẍ' => ('x', 2),
        'ẏ' => ('y', 1),
        'ÿ' => ('y', 2),
        'ż' => ('z', 1),
        'ẇ' => ('w', 1),
        'ẅ' => ('w', 2),
        'ṙ' => ('r', 1),
        'ṡ' => ('s', 1),
        'ḣ' => ('h', 1),
        'ḧ' => ('h', 2),
        'ṗ' => ('p', 1),
        _ => return None,
    })
}

/// Whether a letter has dots over it.
pub(crate) fn is_dotted(char: char) -> bool {
    dotted(char).is_some()
}

/// Combining dots.
pub(crate) fn combining(char: char) -> Option<u8> {
    match char {
        '\u{307}' => Some(1),
        '\u{308}' => Some(2),
        _ => None,
    }
}
