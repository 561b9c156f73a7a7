//! Words, marks and numbers before an answer.

use super::behind_words;
use crate::letters::{greek_word, is_dotted};
use crate::signs::{
    BULLETS, is_apostrophe, is_digit, is_digit_or_index, is_minus, is_of_name, is_of_word,
};
use crate::words::{LEADS, REMARKS};
use vibank_source::lower;

/// Marks of Markdown before a heading, and around words that are set apart.
const MARKS: [char; 5] = ['*', '_', '#', '>', ' '];

/// The length of words before an answer, with the colon or the space after them and the marks around them:
/// `so x = 3`, `**Answer:** 5 m`, `\text{so } x = 3`.
pub(crate) fn lead(text: &str) -> Option<usize> {
    let bare = text.trim_start_matches(MARKS);
    let is_marked = bare.len() < text.len();
    let first = bare.chars().next()?;
    if first.is_ascii_digit() || "-+.([{$<".contains(first) && !bare.starts_with("->") {
        return None;
    }
    if let Some((words, behind)) = faced(bare) {
        let words = words.trim().trim_end_matches([':', ',']).trim_end();
        let is_lead = LEADS.iter().any(|lead| {
            behind_words(words, lead, str::eq_ignore_ascii_case).is_some_and(str::is_empty)
        });
        return (is_lead && !behind.trim().is_empty()).then(|| text.len() - behind.len());
    }
    LEADS.iter().find_map(|lead| {
        let behind = behind_words(bare, lead, str::eq_ignore_ascii_case)?;
        let marks: &[char] = if is_marked { &['*', '_'] } else { &[] };
        let behind = behind.trim_start_matches(marks);
        // The French set a space before a colon; `Hence, x = 3` has a comma, and Chinese no space.
        let behind = match behind.trim_start_matches(' ').strip_prefix(':') {
            Some(behind) => behind.trim_start_matches(marks),
            None => {
                let behind = behind.strip_prefix([',', '，']).unwrap_or(behind);
                let is_sign = lead.ends_with(['>', '→', '⇒', '⟹', '∴', '∝']);
                let is_apart =
                    behind.starts_with([' ', '\n']) || is_sign || is_of_one_word_a_sign(lead);
                is_apart.then_some(behind)?
            }
        };
        // `=> 3` is at least three where nothing else relates.
        let mut signs = [" in ", "\\le", "\\ge", "\\in", "\\approx"].into_iter();
        let is_lead = !behind.trim().is_empty()
            && (*lead != "=>"
                || behind.contains(['=', '<', '>', '≤', '≥', '≈', '∈'])
                || signs.any(|sign| behind.contains(sign)));
        is_lead.then(|| text.len() - behind.len())
    })
}

/// Whether a word is written in a script that sets no spaces.
fn is_of_one_word_a_sign(word: &str) -> bool {
    word.ends_with(|last: char| ('\u{4e00}'..='\u{9fff}').contains(&last))
}

/// The words in the command of LaTeX with which a text begins, and what comes after it.
fn faced(text: &str) -> Option<(&str, &str)> {
    const FACES: [&str; 4] = ["\\text{", "\\mathrm{", "\\textbf{", "\\mbox{"];
    let inner = FACES.iter().find_map(|face| text.strip_prefix(face))?;
    inner.split_once('}')
}

/// The length of words and a colon that say what follows, where that is a value or an equation:
/// `Newton's second law: m x'' = -k x`, `mode shape: (1, 2)`.
pub(crate) fn described(text: &str) -> Option<usize> {
    /// Shorter words may be letters of a formula.
    const MIN_LETTERS: usize = 4;
    const MAX_WORDS: usize = 8;
    let (words, behind) = text.split_once(':')?;
    let is_word = |word: &&str| word.chars().all(is_of_word) && greek_word(&lower(word)).is_none();
    let words: Vec<&str> = words.split_whitespace().collect();
    let are_words = words.len() <= MAX_WORDS
        && words.iter().all(is_word)
        && words.iter().any(|word| word.chars().count() >= MIN_LETTERS);
    let value = behind.trim_start();
    let is_value = value
        .starts_with(|first| is_digit(first) || "([{.+$".contains(first) || is_minus(first))
        || value.contains('=')
        || value.starts_with("\\begin");
    (are_words && is_value && !behind.starts_with('=') && !behind.contains(':'))
        .then(|| text.len() - value.len())
}

/// The length of words before a list that say what can be seen in it, `in phase, (1, 0.3)`.
pub(crate) fn remark_before(text: &str) -> Option<usize> {
    let at = text.find(['(', '[']).filter(|at| *at > 0)?;
    let said = text[..at].trim_end_matches([' ', ',', ':']);
    let is_apart = said.len() < at && text[at..].contains([',', ';']);
    (is_apart && REMARKS.contains(&lower(said).as_str())).then_some(at)
}

/// The length of what names an equation of motion before it, with its colon: `Block 1: m x'' = -k x`, `m1: …`, `eq. (2): …`,
/// `ΣF = m a: …`. A sum or a product before a colon may be divided by what comes after it.
pub(crate) fn named_equation(text: &str) -> Option<usize> {
    const MAX_WORDS: usize = 5;
    let (name, behind) = text.split_once(':')?;
    let is_one = !behind.contains(':') && !behind.starts_with('=');
    if !is_one || !behind.starts_with(' ') || !is_of_motion(behind) {
        return None;
    }
    let is_statement = name.contains('=') || name.starts_with(['Σ', '∑']);
    let words: Vec<&str> = name.split_whitespace().collect();
    // `m1:` or `2:`; `k:` may be divided.
    let is_name = |word: &&str| {
        let word = word.trim_matches(['(', ')', '.']);
        let letters = word
            .trim_end_matches(is_digit_or_index)
            .trim_end_matches('_');
        let is_numbered = letters.len() < word.len();
        letters.chars().all(char::is_alphabetic) && (is_numbered || letters.len() > 1)
    };
    let is_named = !name.ends_with(' ') && words.len() <= MAX_WORDS && words.iter().all(is_name);
    (is_statement || is_named && !words.is_empty()).then(|| text.len() - behind.len())
}

/// Whether a text is an equation of motion: it has an equals sign, and a derivative by time.
pub(crate) fn is_of_motion(text: &str) -> bool {
    const DERIVATIVES: [&str; 7] = ["dot", "d²", "d^2", "prime", "diff(", "D[", "∂²"];
    let has_derivative = text.contains(is_apostrophe)
        || text.chars().any(is_dotted)
        || DERIVATIVES.iter().any(|sign| text.contains(sign));
    has_derivative && text.contains('=')
}

/// The length of the mark of a list, a quotation or a prompt before an answer: `* x = 3`, `> x = 3`, `- **x = 3**`,
/// `>>> 3`, `Out[2]= 3`. A sign that could be a minus or compare stays.
pub(crate) fn bullet(text: &str) -> Option<usize> {
    let length = |behind: &str| {
        let behind = behind.trim_start_matches(' ');
        (!behind.is_empty()).then(|| text.len() - behind.len())
    };
    if let Some(behind) = text.strip_prefix(": ") {
        return length(behind);
    }
    if let Some(behind) = BULLETS.iter().find_map(|mark| text.strip_prefix(mark)) {
        // `* *` are signs of times.
        return length(behind).filter(|_| !behind.trim_start().starts_with(['*', '/', '^']));
    }
    if let Some(behind) = text.strip_prefix("- ") {
        let is_set_apart = ["**", "__", "$", "\\(", "`"]
            .iter()
            .any(|mark| behind.starts_with(mark));
        return length(behind).filter(|_| is_set_apart);
    }
    if let Some(behind) = text.strip_prefix("> ") {
        let begins = behind.starts_with(|own: char| own.is_alphabetic() || "\\$*".contains(own));
        return length(behind).filter(|_| begins && behind.contains('='));
    }
    if text.starts_with('#') {
        let behind = text.trim_start_matches('#').strip_prefix(' ')?;
        return length(behind);
    }
    // What programs print before a result.
    let numbered = ["Out[", "In[", "(%o"]
        .iter()
        .find_map(|prompt| text.strip_prefix(prompt))?;
    let behind = numbered.trim_start_matches(is_digit);
    let is_numbered = behind.len() < numbered.len();
    let behind = ["]:=", "]=", "]//MatrixForm=", "]:", "] =", ")"]
        .iter()
        .find_map(|end| behind.strip_prefix(end))?;
    length(behind).filter(|_| is_numbered)
}

/// The length of a name that a function gets in a program, with what says of which argument it is one:
/// `x = lambda t:`, `f = @(t)`.
pub(crate) fn definition(text: &str) -> Option<usize> {
    const HEADS: &[&str] = &["lambda t:", "@(t)", "t ->", "t →", "t ↦"];
    let start = text.trim_start();
    let behind = start.trim_start_matches(|char| is_of_name(char) || "()".contains(char));
    let is_name = behind.len() < start.len();
    let behind = behind.trim_start().strip_prefix(['=', ':'])?;
    let behind = behind.strip_prefix('=').unwrap_or(behind);
    let value = behind.trim_start();
    let body = HEADS.iter().find_map(|head| value.strip_prefix(head))?;
    (is_name && !body.trim().is_empty()).then(|| text.len() - body.len())
}
