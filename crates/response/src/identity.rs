//! The identity matrix among what people type: `m I`, `k \mathbf{I}_2`, `m*eye(3)`, `IdentityMatrix[2]`.

use super::Lexicon;
use super::frame::without_module;
use vibank_source::Span;

/// Most rows of an identity that is called by its size.
const MAX_SIZE: usize = 20;
/// What programs call the identity matrix, the longer names before those with which they begin.
const CALLS: [&str; 5] = ["IdentityMatrix", "identity", "Identity", "eye", "Id"];
/// Its names in words, the longer ones before those that they hold.
const NAMES: [&str; 6] = [
    "the identity matrix",
    "the unit matrix",
    "identity matrix",
    "unit matrix",
    "the identity",
    "identity",
];
/// Commands of LaTeX for the face of its letter.
const FACES: [&str; 7] = [
    "\\mathbb",
    "\\mathbf",
    "\\mathrm",
    "\\mathds",
    "\\boldsymbol",
    "\\bm",
    "\\bf",
];
/// Its letters, the one of German last.
const LETTERS: [&str; 3] = ["Id", "I", "E"];

/// Where the identity of a matrix of so many rows stands in a piece, and how many rows it has itself; nothing where its
/// letter is a name of the item.
pub(crate) fn identity_in(
    text: &str,
    piece: Span,
    rows: usize,
    lexicon: &Lexicon,
) -> Option<(Span, usize)> {
    let text = &text[piece.range()];
    let named = || {
        let text = text.to_ascii_lowercase();
        let (name, at) = NAMES
            .iter()
            .find_map(|name| Some((name, text.find(name)?)))?;
        Some((at, name.len(), rows))
    };
    let (start, length, rows) = called(text).or_else(named).or_else(|| {
        let places = text.char_indices().map(|(at, _)| at);
        let mut found =
            places.filter_map(|at| Some((at, letter_at(text, at, rows, lexicon)?, rows)));
        found.next()
    })?;
    let from = piece.range().start + start;
    Some((Span::new(from, from + length), rows))
}

/// The length of the letter of the identity with its face and its index, if it stands at a place.
fn letter_at(text: &str, at: usize, rows: usize, lexicon: &Lexicon) -> Option<usize> {
    let (before, rest) = text.split_at(at);
    let face = FACES.iter().find_map(|face| rest.strip_prefix(*face));
    let faced = face.map_or(rest, |rest| rest.trim_start_matches(['{', ' ']));
    let letters = LETTERS.iter().chain(face.is_some().then_some(&"1"));
    let (letter, mut behind) = letters
        .into_iter()
        .find_map(|own| Some((*own, faced.strip_prefix(*own)?)))?;
    if face.is_some() {
        behind = behind.strip_prefix('}').unwrap_or(behind);
    }
    let mut indices = indices(rows).into_iter();
    let own = indices.find_map(|index| behind.strip_prefix(index.as_str()));
    let behind = own.unwrap_or(behind);
    let is_index = ["_", "^", "\\", "_{", "^{"]
        .iter()
        .any(|sign| before.ends_with(sign));
    let goes_on = behind.starts_with(|next: char| next.is_alphanumeric() || "_^({[".contains(next));
    // `AE` and `5E` end with another letter.
    let is_alone = letter != "E" || !before.ends_with(char::is_alphanumeric);
    let is_free =
        lexicon.reads(letter).is_none() && lexicon.reads(&format!("{letter}{rows}")).is_none();
    (!is_index && !goes_on && is_alone && is_free).then(|| rest.len() - behind.len())
}

/// The spellings of the number of rows after its letter.
fn indices(rows: usize) -> [String; 4] {
    let digit = u32::try_from(rows).ok().filter(|rows| *rows < 10);
    let lowered = digit.and_then(|digit| char::from_u32(u32::from('₀') + digit));
    let lowered = lowered.map_or_else(|| rows.to_string(), String::from);
    [
        format!("_{{{rows}}}"),
        format!("_{rows}"),
        rows.to_string(),
        lowered,
    ]
}

/// The identity that a program calls by its size: where it stands, how long it is, and its rows.
fn called(text: &str) -> Option<(usize, usize, usize)> {
    let (at, behind) = CALLS.iter().find_map(|name| {
        let at = text.find(&format!("{name}("));
        let at = at.or_else(|| text.find(&format!("{name}[")))?;
        Some((at, &text[at + name.len() + 1..]))
    })?;
    let end = behind.find([')', ']'])?;
    let sizes: Vec<usize> = behind[..end]
        .split(',')
        .map(|size| size.trim().parse().ok())
        .collect::<Option<_>>()?;
    let rows = match sizes[..] {
        [rows] => rows,
        [rows, columns] if rows == columns => rows,
        _ => return None,
    };
    let start = without_module(&text[..at]).len();
    let length = text.len() - behind.len() + end + 1 - start;
    (1..=MAX_SIZE)
        .contains(&rows)
        .then_some((start, length, rows))
}
