//! What people say around an answer: "so", "the answer is", quotation marks.

use std::ops::Range;

use super::letters::greek_word;
use super::list::cut;
use super::signs::{BULLETS, QUOTES, is_apostrophe, is_minus};
use super::words::{ASIDES, LEADS, REASONS, SEALS, TRAILS, WITHDRAWALS};
use vibank_formula::unit::Unit;
use vibank_source::{Span, lower};

/// Where the answer stands in what was typed.
pub(crate) fn answer_in(typed: &str) -> Range<usize> {
    /// More layers than anybody puts around an answer.
    const MAX_LAYERS: usize = 24;
    let mut range = 0..typed.len();
    for _ in 0..MAX_LAYERS {
        let own = trimmed(typed, &range);
        let text = &typed[own.clone()];
        let inner = lead(text)
            .or_else(|| described(text))
            .or_else(|| bullet(text))
            .or_else(|| definition(text))
            .or_else(|| number_of_item(text))
            .map(|length| own.start + length..own.end)
            .or_else(|| trail(text).map(|length| own.start..own.end - length))
            .or_else(|| quotes(text).map(|(open, close)| own.start + open..own.end - close))
            .or_else(|| fence(text).map(|(open, close)| own.start + open..own.end - close))
            .or_else(|| program(text).map(|(open, close)| own.start + open..own.end - close))
            .or_else(|| bracketed(text).then(|| own.start + 1..own.end - 1));
        match inner {
            Some(inner) => range = inner,
            None => return range,
        }
    }
    range
}

/// What comes after the arrow with which a response begins, `=> 5 m`, where none asks for a bound.
pub fn behind_arrow(typed: &str) -> &str {
    let behind = typed.strip_prefix("=>").map(str::trim_start);
    behind.filter(|behind| !behind.is_empty()).unwrap_or(typed)
}

/// The words or the mark by which a response takes itself back: `~~5 m~~`, and where words are none of what may be
/// answered, `wrong: 5 m`, `5 m is wrong`.
pub fn withdrawn(typed: &str, may_be_words: bool) -> Option<&str> {
    // Two spaces of LaTeX come after what they part, a mark that strikes out before what it strikes.
    let struck = typed.match_indices("~~").find(|(at, mark)| {
        let behind = &typed[at + mark.len()..];
        let opens = typed[..*at]
            .chars()
            .next_back()
            .is_none_or(char::is_whitespace);
        let inner = behind.split_once("~~").map_or("", |(inner, _)| inner);
        opens && !inner.is_empty() && inner.trim() == inner && !inner.starts_with(['=', '+', '-'])
    });
    if let Some((at, mark)) = struck {
        return Some(&typed[at..at + mark.len()]);
    }
    let is_alone = !typed.trim().contains(char::is_whitespace);
    if may_be_words || is_alone {
        return None;
    }
    let bare = |word: &str| lower(word.trim_matches(['(', ')', '.', ',', '!', ':', ';']));
    let first = typed.split_whitespace().next();
    let last = typed.split_whitespace().next_back();
    let mut ends = [first, last].into_iter().flatten();
    ends.find(|word| WITHDRAWALS.contains(&bare(word).as_str()))
}

fn trimmed(typed: &str, range: &Range<usize>) -> Range<usize> {
    let text = &typed[range.clone()];
    let start = range.start + text.len() - text.trim_start().len();
    start..start + text.trim().len()
}

/// What comes after words, however they are spaced; `is_same` says when two words are.
pub(crate) fn behind_words<'t>(
    text: &'t str,
    words: &str,
    is_same: impl Fn(&str, &str) -> bool,
) -> Option<&'t str> {
    let mut rest = text;
    for (place, word) in words.split(' ').enumerate() {
        if place > 0 {
            rest = rest.strip_prefix(' ')?.trim_start_matches(' ');
        }
        let head = rest.get(..word.len())?;
        rest = is_same(head, word).then(|| &rest[word.len()..])?;
    }
    Some(rest)
}

/// Marks of Markdown before a heading, and around words that are set apart.
const MARKS: [char; 5] = ['*', '_', '#', '>', ' '];

/// The length of words before an answer, with the colon or the space after them and the marks around them:
/// `so x = 3`, `**Answer:** 5 m`, `\text{so } x = 3`.
fn lead(text: &str) -> Option<usize> {
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
        // Most answers begin with another letter than any of these words.
        let is_it = lead.as_bytes()[0].eq_ignore_ascii_case(&bare.as_bytes()[0]);
        let behind = is_it
            .then(|| behind_words(bare, lead, str::eq_ignore_ascii_case))
            .flatten()?;
        let without_marks = |behind: &'_ str| {
            let marks: &[char] = if is_marked { &['*', '_'] } else { &[] };
            behind.trim_start_matches(marks).len()
        };
        let behind = &behind[behind.len() - without_marks(behind)..];
        // The French set a space before a colon; `Hence, x = 3` has a comma, and Chinese no space.
        let behind = match behind.trim_start_matches(' ').strip_prefix(':') {
            Some(behind) => &behind[behind.len() - without_marks(behind)..],
            None => {
                let behind = behind.strip_prefix([',', '，']).unwrap_or(behind);
                let is_apart = behind.starts_with([' ', '\n']) || is_of_one_word_a_sign(lead);
                is_apart.then_some(behind)?
            }
        };
        // `=> 3` is at least three where nothing else relates.
        let relates = || {
            behind.contains(['=', '<', '>', '≤', '≥', '≈', '∈'])
                || [" in ", "\\le", "\\ge", "\\in", "\\approx"]
                    .iter()
                    .any(|sign| behind.contains(sign))
        };
        let is_lead = !behind.trim().is_empty() && (*lead != "=>" || relates());
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
fn described(text: &str) -> Option<usize> {
    /// Shorter words may be letters of a formula.
    const MIN_LETTERS: usize = 4;
    const MAX_WORDS: usize = 8;
    let (words, behind) = text.split_once(':')?;
    let is_word = |word: &str| {
        let is_of_word = |char: char| char.is_alphabetic() || char == '-' || is_apostrophe(char);
        word.chars().all(is_of_word) && greek_word(&lower(word)).is_none()
    };
    let is_long = |word: &str| word.chars().count() >= MIN_LETTERS;
    let words: Vec<&str> = words.split_whitespace().collect();
    let are_words = words.len() <= MAX_WORDS
        && words.iter().all(|word| is_word(word))
        && words.iter().any(|word| is_long(word));
    let begins_value = |first: char| first.is_ascii_digit() || "([{.+$".contains(first);
    let value = behind.trim_start();
    let is_value = value.starts_with(|first| begins_value(first) || is_minus(first))
        || value.contains('=')
        || value.starts_with("\\begin");
    (are_words && is_value && !behind.starts_with('=') && !behind.contains(':'))
        .then(|| text.len() - value.len())
}

/// The length of the mark of a list, a quotation or a prompt before an answer: `* x = 3`, `> x = 3`, `- **x = 3**`,
/// `>>> 3`, `Out[2]= 3`. A sign that could be a minus or compare stays.
fn bullet(text: &str) -> Option<usize> {
    let length = |behind: &str| {
        let behind = behind.trim_start_matches(' ');
        (!behind.is_empty()).then(|| text.len() - behind.len())
    };
    if let Some(behind) = BULLETS.iter().find_map(|mark| text.strip_prefix(mark)) {
        return length(behind);
    }
    if let Some(behind) = text.strip_prefix("- ") {
        let is_set_apart = ["**", "__", "$", "\\(", "`"]
            .iter()
            .any(|mark| behind.starts_with(mark));
        return length(behind).filter(|_| is_set_apart);
    }
    if let Some(behind) = text.strip_prefix("> ") {
        let begins = |first: char| first.is_alphabetic() || "\\$*".contains(first);
        return length(behind).filter(|_| behind.starts_with(begins) && behind.contains('='));
    }
    if text.starts_with('#') {
        let behind = text.trim_start_matches('#').strip_prefix(' ')?;
        return length(behind);
    }
    // What programs print before a result.
    let numbered = ["Out[", "In[", "(%o"]
        .iter()
        .find_map(|prompt| text.strip_prefix(prompt))?;
    let behind = numbered.trim_start_matches(|char: char| char.is_ascii_digit());
    let is_numbered = behind.len() < numbered.len();
    let behind = ["]:=", "]=", "]//MatrixForm=", "]:", "] =", ")"]
        .iter()
        .find_map(|end| behind.strip_prefix(end))?;
    length(behind).filter(|_| is_numbered)
}

/// The lengths of the fence around a block of code, with the language after its first mark.
fn fence(text: &str) -> Option<(usize, usize)> {
    const MARK: &str = "```";
    let inner = text.strip_prefix(MARK)?.strip_suffix(MARK)?;
    let is_language = |line: &str| line.chars().all(|char| char.is_ascii_alphabetic());
    let own = match inner.split_once('\n') {
        Some((line, own)) if is_language(line.trim()) => own,
        _ => inner,
    };
    let is_whole = !own.trim().is_empty() && !own.contains(MARK);
    is_whole.then(|| (text.len() - MARK.len() - own.len(), MARK.len()))
}

/// The length of a number or letter before an answer, as the parts of a sheet have: `1) 5 m`, `(a) x = 5 m`, `1. -5 m`.
fn number_of_item(text: &str) -> Option<usize> {
    let open = usize::from(text.starts_with('('));
    let label = text[open..].chars().next()?;
    let behind = &text[open + label.len_utf8()..];
    let is_number = label.is_ascii_digit();
    if !is_number && !('a'..='h').contains(&label) || !enumeration(text).is_empty() {
        return None;
    }
    let begins_value = |behind: &str| {
        let behind = behind.trim_start();
        let unsigned = behind.strip_prefix(is_minus).unwrap_or(behind);
        unsigned.starts_with(|next: char| next.is_ascii_digit())
    };
    let (is_label, behind) = if let Some(behind) = behind.strip_prefix(')') {
        // Of a choice, `a) static`, letters are answers. `(2) x` may be a product; `(1) 5 m` is the same either way.
        let is_statement = behind.contains('=') || begins_value(behind);
        // The brackets of `1) 5 m 2) 6 m` are of several answers.
        let is_one = behind.matches('(').count() == behind.matches(')').count();
        let may_be_label = !is_number || label == '1';
        let is_sure = is_number && open == 0 || may_be_label && is_statement;
        (is_one && is_sure, behind)
    } else {
        let behind = behind.strip_prefix('.').filter(|_| open == 0)?;
        // `1. m` is a metre.
        let begins = behind
            .trim_start()
            .starts_with(|next: char| next.is_alphabetic() || next == '\\');
        let is_equation = label == '1' && begins && behind.contains('=');
        (is_number && (is_equation || begins_value(behind)), behind)
    };
    let is_apart = behind.starts_with(' ')
        && !behind.trim().is_empty()
        && !behind.trim_start().starts_with('=');
    (is_label && is_apart).then(|| text.len() - behind.len())
}

/// The labels of several answers, `1) … 2) …`, `(a) … (b) …`, `1. x = … 2. y = …`; none where that is not how the text
/// goes.
pub(crate) fn enumeration(text: &str) -> Vec<Range<usize>> {
    const STYLES: [(&str, char, &str); 5] = [
        ("", '1', ")"),
        ("(", '1', ")"),
        ("", 'a', ")"),
        ("(", 'a', ")"),
        ("", '1', "."),
    ];
    let start = text.trim_start();
    let head = start.strip_prefix('(').unwrap_or(start);
    let is_label = head.starts_with(['1', 'a']) && matches!(head.get(1..3), Some(") " | ". "));
    if !is_label {
        return Vec::new();
    }
    let mut found = STYLES.into_iter().map(|(open, first, close)| {
        let labels = labels(text, open, first, close);
        let are_labels = labels.len() > 1 && are_apart(text, &labels, close);
        labels.into_iter().filter(|_| are_labels).collect()
    });
    found
        .find(|labels: &Vec<_>| !labels.is_empty())
        .unwrap_or_default()
}

/// The labels of one style that follow each other in a text, the first one at its start.
fn labels(text: &str, open: &str, first: char, close: &str) -> Vec<Range<usize>> {
    const MAX_LABELS: u8 = 6;
    let (mut found, mut at) = (Vec::new(), text.len() - text.trim_start().len());
    for label in (0..MAX_LABELS).map(|place| char::from(first as u8 + place)) {
        let label = format!("{open}{label}{close} ");
        let place = if found.is_empty() {
            text[at..].starts_with(&label).then_some(at)
        } else {
            let mut next = text[at..].match_indices(&label);
            let next = next.find(|(place, _)| text[..at + place].ends_with([' ', '\n']));
            next.map(|(place, _)| at + place)
        };
        let Some(place) = place else { break };
        at = place + label.len() - 1;
        found.push(place..at);
    }
    found
}

/// Whether a statement comes after each label: `(1) + (2) x` and `1. m + 2. m` are sums.
fn are_apart(text: &str, labels: &[Range<usize>], close: &str) -> bool {
    let ends = labels[1..]
        .iter()
        .map(|label| label.start)
        .chain([text.len()]);
    let mut pieces = labels
        .iter()
        .zip(ends)
        .map(|(label, end)| text[label.end..end].trim());
    pieces.all(|piece| {
        let goes_on = piece.ends_with(['+', '-', '*', '/', '=', '<', '>', '(', '^']);
        let is_statement =
            piece.contains('=') || piece.starts_with(|first: char| first.is_ascii_digit());
        // A number with a point is a label only where it can be no factor.
        let is_sure = close == ")" || is_statement || labels.len() > 2;
        !piece.is_empty() && !goes_on && is_sure
    })
}

/// Whether brackets stand around a whole statement, `(x = 3 m)`.
fn bracketed(text: &str) -> bool {
    let inner = text
        .strip_prefix('(')
        .and_then(|text| text.strip_suffix(')'));
    let Some(inner) =
        inner.filter(|inner| !inner.contains([',', ';', '<', '>', '≤', '≥', '!', '|']))
    else {
        return false;
    };
    let mut depth = 0_i32;
    let is_whole = inner.chars().all(|char| {
        depth += match char {
            '(' => 1,
            ')' => -1,
            _ => 0,
        };
        depth >= 0
    });
    is_whole && inner.contains('=')
}

/// The length of a name that a function gets in a program, with what says of which argument it is one:
/// `x = lambda t:`, `f = @(t)`.
fn definition(text: &str) -> Option<usize> {
    const HEADS: &[&str] = &["lambda t:", "@(t)", "t ->", "t →", "t ↦"];
    let is_of_name = |char: char| char.is_alphanumeric() || "_()".contains(char);
    let start = text.trim_start();
    let behind = start.trim_start_matches(is_of_name);
    let is_name = behind.len() < start.len();
    let behind = behind.trim_start().strip_prefix(['=', ':'])?;
    let behind = behind.strip_prefix('=').unwrap_or(behind);
    let value = behind.trim_start();
    let body = HEADS.iter().find_map(|head| value.strip_prefix(head))?;
    (is_name && !body.trim().is_empty()).then(|| text.len() - body.len())
}

/// The lengths of what programs write around a function or a solution: `Function[t, …]`, `{{x -> …}}`.
fn program(text: &str) -> Option<(usize, usize)> {
    const HEADS: &[&str] = &["Function[t,", "Function[{t},", "Function[t_,"];
    let head = HEADS.iter().find(|head| text.starts_with(**head));
    if let Some(head) = head.filter(|_| text.ends_with(']')) {
        return Some((head.len(), 1));
    }
    let inner = text.strip_prefix('{')?.strip_suffix('}')?;
    // `{x1(t) = …, x2(t) = …}`, as Maple gives solutions.
    let is_set = || {
        let pieces = cut(inner, Span::new(0, inner.len()), &[',']);
        let is_equation = |piece: &Span| {
            let text = &inner[piece.range()];
            text.contains('=') && !text.contains(['<', '>', '!', '|', '{', '}'])
        };
        pieces.len() > 1 && pieces.iter().all(is_equation)
    };
    (text.contains("->") && !inner.is_empty() || is_set()).then_some((1, 1))
}

/// The length of words after an answer, of a remark in brackets, of a semicolon, or of a comma.
fn trail(text: &str) -> Option<usize> {
    // The sentence may end after them.
    let ended = text.strip_suffix('.').map_or(text, str::trim_end);
    let of_words = |text: &'_ str| TRAILS.iter().find(|trail| text.ends_with(**trail));
    let found = of_words(text).map(|words| (text, words));
    if let Some((own, words)) = found.or_else(|| Some((ended, of_words(ended)?))) {
        let before = &own[..own.len() - words.len()];
        let is_apart = before.ends_with([' ', ')', ']']) || words.starts_with(',');
        return is_apart.then(|| text.len() - before.len());
    }
    if let Some(before) = SEALS.iter().find_map(|seal| ended.strip_suffix(seal)) {
        return (!before.trim().is_empty()).then(|| text.len() - before.len());
    }
    // `…, where A and B are constants`
    if ended.ends_with("constants")
        && let Some((before, _)) = ended.split_once(" where ")
    {
        return (!before.trim().is_empty()).then(|| text.len() - before.len());
    }
    if let Some(at) = reason(text) {
        return Some(text.len() - at);
    }
    // A row of LaTeX that none follows.
    if text.ends_with("\\\\") {
        return Some(2);
    }
    if let Some(length) = comment(text) {
        return Some(length);
    }
    if let Some(length) = aside(text).or_else(|| precision(text)) {
        return Some(length);
    }
    if text.ends_with(">.") {
        return Some(1);
    }
    if let Some(before) = text.strip_suffix('!') {
        // `3!` is a factorial. The French set a space before the mark.
        let ends = |last: char| last.is_alphabetic() || before.ends_with(' ');
        return before.trim_end().ends_with(ends).then_some(1);
    }
    if let Some(before) = text.strip_suffix(';') {
        let ends = |last: char| last.is_alphanumeric() || ")]}°%²³'".contains(last);
        return before.trim_end().ends_with(ends).then_some(1);
    }
    let before = text.strip_suffix(',')?;
    before.ends_with(char::is_alphanumeric).then_some(1)
}

/// The length of a remark in brackets after an answer: `(3 s.f.)`, `(see above)`, and the `(1)` by which an equation is
/// numbered, which is the same as a factor.
fn aside(text: &str) -> Option<usize> {
    /// A shorter word may be a letter of a formula, and a unit.
    const MIN_LETTERS: usize = 4;
    let pairs = [(')', " ("), (']', " [")];
    let (before, aside) = pairs
        .iter()
        .find_map(|(close, open)| text.strip_suffix(*close)?.rsplit_once(open))?;
    let length = || Some(text.len() - before.len());
    if aside == "1" && before.contains('=') {
        return length();
    }
    // `overdamped (ζ > 1)`
    let is_of_words = |char: char| char.is_alphabetic() || " -".contains(char);
    let is_named = before
        .split(' ')
        .any(|word| word.chars().count() > MIN_LETTERS)
        && before.chars().all(is_of_words);
    if is_named && aside.contains(['<', '>']) {
        return length();
    }
    let is_number = |word: &str| word.bytes().all(|byte| byte.is_ascii_digit());
    let is_said = |word: &str| {
        let word = word.trim_end_matches([',', ';', ':']);
        // `3sf`
        let unit = word.trim_start_matches(|char: char| char.is_ascii_digit());
        is_number(word) || ASIDES.contains(&word) || ASIDES.contains(&unit)
    };
    // `12 (in)` has inches.
    let says_nothing = |word: &str| {
        let word = word.trim_end_matches([',', ';', ':']);
        is_number(word) || ["in", "to", "à"].contains(&word)
    };
    let mut words = aside.split_whitespace();
    if words.clone().all(is_said) && !words.clone().all(says_nothing) {
        return length();
    }
    let is_word = |word: &str| {
        let word = word.trim_end_matches([',', ';', '.', '!', '?']);
        let mut letters = word.chars();
        !word.is_empty()
            && letters.all(|char| char.is_alphabetic() || char == '-' || is_apostrophe(char))
    };
    let is_no_letter = |word: &str| {
        word.chars().filter(|char| char.is_alphabetic()).count() >= MIN_LETTERS
            && greek_word(&lower(word)).is_none()
            && Unit::read(word).is_err()
    };
    // One word alone may name an option, `underdamped (aperiodic)`.
    let are_words = words.clone().count() > 1
        && words.clone().all(is_word)
        && words.any(is_no_letter)
        && Unit::read(aside).is_err();
    if are_words { length() } else { None }
}

/// The length of what says to how many figures an answer is given: `to 3 s.f.`, `to 3 significant figures`.
fn precision(text: &str) -> Option<usize> {
    let (before, said) = text.rsplit_once(" to ")?;
    let mut words = said.split_whitespace();
    let is_number = words
        .next()
        .is_some_and(|first| first.parse::<u8>().is_ok());
    let mut rest = words.peekable();
    let is_said = rest.peek().is_some() && rest.all(|word| ASIDES.contains(&word));
    (is_number && is_said).then(|| text.len() - before.len())
}

/// Where the reason begins that is given after an answer: `5 m, since k = 3 N/m`.
fn reason(text: &str) -> Option<usize> {
    text.match_indices(' ').find_map(|(at, _)| {
        let rest = &text[at + 1..];
        let is_reason = |word: &&&str| {
            let behind = rest.strip_prefix(**word);
            behind.is_some_and(|behind| behind.starts_with(' '))
        };
        let word = REASONS.iter().find(is_reason)?;
        let before = text[..at].trim_end();
        // Short words are letters elsewhere: `da` and `car` say why only after a comma.
        let is_apart = before.ends_with(',') || word.len() > 4;
        (is_apart && !before.trim_end_matches(',').is_empty()).then_some(at)
    })
}

/// The length of a comment of a program, `# checked`, `// by Newton`. One that is a unit or says where it is measured is
/// more than that, and `k1 // k2` are springs in parallel.
fn comment(text: &str) -> Option<usize> {
    /// Longer words are no symbols of units.
    const MAX_UNIT: usize = 5;
    // Most responses have neither sign, and a search for two letters takes longer than one for their bytes.
    if !text.bytes().any(|byte| b"#/".contains(&byte)) {
        return None;
    }
    let (before, comment) = text.split_once(" # ").or_else(|| text.split_once(" // "))?;
    // A word after `//` that is as short as a letter of a formula may be one.
    let word = comment.split([' ', ',', ':']).next().unwrap_or(comment);
    let is_word =
        word.starts_with(char::is_alphabetic) && (text.contains(" # ") || word.chars().count() > 2);
    let is_unit = comment.len() <= MAX_UNIT && Unit::read(comment).is_ok();
    (is_word && !is_unit && !before.trim().is_empty()).then(|| text.len() - before.len())
}

/// The lengths of the marks around an answer.
fn quotes(text: &str) -> Option<(usize, usize)> {
    // A star or two underscores that begin a text multiply nothing, whatever is multiplied between them.
    for mark in ["*", "__"] {
        let inner = text
            .strip_prefix(mark)
            .and_then(|text| text.strip_suffix(mark));
        let inner = inner.filter(|_| !text.starts_with("**"));
        if inner.is_some_and(|inner| !inner.trim().is_empty() && !inner.ends_with('^')) {
            return Some((mark.len(), mark.len()));
        }
    }
    QUOTES.iter().find_map(|(open, close)| {
        let inner = text.strip_prefix(open)?.strip_suffix(close)?;
        let is_whole = !inner.trim().is_empty() && !inner.contains(open) && !inner.contains(close);
        is_whole.then_some((open.len(), close.len()))
    })
}

#[cfg(test)]
mod tests {
    use super::{answer_in, enumeration, withdrawn};

    #[test]
    #[expect(clippy::too_many_lines, reason = "a table")]
    fn what_is_said_around_an_answer_is_no_part_of_it() {
        for (typed, answer) in [
            ("so ω = 5 rad/s", "ω = 5 rad/s"),
            ("The answer is 5 rad/s", "5 rad/s"),
            ("Answer: b", "b"),
            ("⇒ x = 3", "x = 3"),
            ("=> x = 3", "x = 3"),
            ("=> 3", "=> 3"),
            ("so, approx. 5", "5"),
            ("Hence, x = 3", "x = 3"),
            ("I got 5 m", "5 m"),
            ("Final answer: k/m", "k/m"),
            ("Lösung: k/m", "k/m"),
            ("-> 5 m", "5 m"),
            ("1) 5 m", "5 m"),
            ("1) 5 m 2) 6 m", "1) 5 m 2) 6 m"),
            ("a) -5 m", "-5 m"),
            ("(b) x = 5 m", "x = 5 m"),
            ("2) x = 5 m", "x = 5 m"),
            ("1. x'' = 0", "x'' = 0"),
            ("1. m", "1. m"),
            ("1. -5 m", "-5 m"),
            ("1. - 5 m", "1. - 5 m"),
            ("5 m # ok", "5 m"),
            ("I  get 5 m", "5 m"),
            ("5 m environ.", "5 m"),
            ("5 m approx.", "5 m"),
            ("5 m // Newton", "5 m"),
            ("(2) x = 5", "(2) x = 5"),
            ("(b) x + c", "(b) x + c"),
            ("a) static", "a) static"),
            ("k/m // from Newton", "k/m"),
            ("0.2 // mm", "0.2 // mm"),
            ("k1 // k2", "k1 // k2"),
            ("(x = 3 m)", "x = 3 m"),
            ("(x) = (3)", "(x) = (3)"),
            ("(x = 3, y = 2)", "(x = 3, y = 2)"),
            ("k/m ✓", "k/m"),
            ("k/m # checked", "k/m"),
            (r"k/m\\", "k/m"),
            ("5 m ;", "5 m"),
            ("so approx. 5 m (approx.)", "5 m"),
            ("\"5 m\"", "5 m"),
            ("“about 5 m”", "5 m"),
            ("**5**", "5"),
            ("5\"", "5\""),
            ("\"\"", "\"\""),
            ("k = 3 N/m,", "k = 3 N/m"),
            ("5,", "5"),
            ("5 m/s²;", "5 m/s²"),
            ("5; ;", "5; ;"),
            ("5 m (3 s.f.)", "5 m"),
            ("5 m (to 3 significant figures)", "5 m"),
            ("2 cos(3) (4)", "2 cos(3) (4)"),
            ("12 (in)", "12 (in)"),
            ("2 sin(t) (in SI units)", "2 sin(t)"),
            ("lambda t: 2*t", "2*t"),
            ("x = lambda t: 2*t", "2*t"),
            ("f = @(t) 2*t", "2*t"),
            ("x(t) := t ↦ 2t", "2t"),
            ("x: t -> 2*t", "2*t"),
            ("Function[t, 2 t]", "2 t"),
            ("{{x -> 2}}", "x -> 2"),
            ("x = t", "x = t"),
            ("t -> 2*t", "2*t"),
            ("**Answer:** 5 m", "5 m"),
            ("**Answer**: x = 5 m", "x = 5 m"),
            ("**Final answer:** *5 m*", "5 m"),
            ("### Answer\nx = 5 m", "x = 5 m"),
            ("- **x = 5 m**", "x = 5 m"),
            ("- x = 5 m", "- x = 5 m"),
            ("- 5 m", "- 5 m"),
            ("* 5 m", "5 m"),
            ("> x = 5 m", "x = 5 m"),
            ("> 5 m", "> 5 m"),
            (">>> 5", "5"),
            ("Out[12]= 5", "5"),
            ("```\n5 m\n```", "5 m"),
            ("```python\nsqrt(k)\n```", "sqrt(k)"),
            ("__5 m__", "5 m"),
            ("2*x*", "2*x*"),
            ("\\text{so } x = 3", "x = 3"),
            ("\\text{kg}", "\\text{kg}"),
            ("Newton's second law: m x'' = -k x", "m x'' = -k x"),
            ("mode shape: (1, 2)", "(1, 2)"),
            ("above: x", "above: x"),
            ("theta: 3", "theta: 3"),
            ("so the answer is 5 m, since k = 3", "5 m"),
            ("5 m because k = 3", "5 m"),
            ("c as k", "c as k"),
            ("5 m (see above)", "5 m"),
            ("5 m (3sf)", "5 m"),
            ("5 m [3 s.f.]", "5 m"),
            ("5 m to 3 s.f.", "5 m"),
            ("u = (1, 2), v = (3, 4)", "u = (1, 2), v = (3, 4)"),
            ("5 (newton metre)", "5 (newton metre)"),
            ("x (aperiodic)", "x (aperiodic)"),
            ("x = 0 (1)", "x = 0"),
            ("x = 0 (2)", "x = 0 (2)"),
            ("5 m✔", "5 m"),
            ("5 !", "5"),
            ("5!", "5!"),
            ("5?", "5?"),
            ("la risposta è 5 m", "5 m"),
            ("答:5 m", "5 m"),
            ("所以 x = 5 m", "x = 5 m"),
            ("sons", "sons"),
            ("so", "so"),
        ] {
            assert_eq!(typed[answer_in(typed)].trim(), answer, "{typed}");
        }
    }

    #[test]
    fn what_is_taken_back_is_no_answer() {
        for (typed, mark) in [
            ("~~5 m~~", Some("~~")),
            ("6 m ~~5 m~~", Some("~~")),
            (r"x~~=~~5~~\mathrm{m}", None),
            ("x ~~=~~ 5", None),
            ("x ~~= 5~~m", None),
            ("~5 m", None),
            ("wrong: 5 m", Some("wrong:")),
            ("5 m is wrong.", Some("wrong.")),
            ("5 m (false)", Some("(false)")),
            ("false", None),
            ("5 m", None),
        ] {
            assert_eq!(withdrawn(typed, false), mark, "{typed}");
        }
        assert_eq!(withdrawn("the sign is wrong", true), None);
    }

    #[test]
    fn several_answers_bear_labels() {
        for (typed, labels) in [
            ("1) 5 m 2) 6 m", &["1)", "2)"][..]),
            ("(a) x = 5 m, (b) y = 6 m", &["(a)", "(b)"]),
            ("1. z = 0, 2. x = l", &["1.", "2."]),
            ("1. 5 m, 2. 6 m", &["1.", "2."]),
            ("1. ring 2. block 3. disk", &["1.", "2.", "3."]),
            ("1. m + 2. k", &[]),
            ("(1) + (2) x", &[]),
            ("1) 5 m", &[]),
            ("(a) (b)", &[]),
        ] {
            let found = enumeration(typed);
            let found: Vec<&str> = found.into_iter().map(|label| &typed[label]).collect();
            assert_eq!(found, labels, "{typed}");
        }
    }
}
