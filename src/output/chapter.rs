//! Chapters of the course: Markdown with pictures and worked examples of the bank between its blocks.

/// What follows one another in a chapter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChapterPiece<'t> {
    /// Its level from 1, and its line as a whole.
    Heading(u8, &'t str),
    /// Blocks of Markdown, with formulas between `$` and `$$`.
    Text(&'t str),
    /// `<!-- plot ITEM NAME | WORDS -->` or `<!-- figure ITEM | WORDS -->`
    Picture {
        /// The id of an item.
        item: &'t str,
        /// A plot of the item; its figure, if none is named.
        plot: Option<&'t str>,
        /// What stands under it.
        words: &'t str,
    },
    /// `<!-- item ITEM -->`: the item with its worked solution.
    Example(&'t str),
}

/// A comment on a line of its own that stands for nothing.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "line {line}: found `{found}`, expected `plot ITEM NAME | WORDS`, `figure ITEM | WORDS` or `item ITEM`"
)]
pub struct ChapterError {
    line: usize,
    found: String,
}

/// A chapter in pieces, each with the line where it begins, from 1.
///
/// # Errors
///
/// [`ChapterError`] for a comment that asks for neither a picture nor an example.
///
/// ```
/// use vibank::output::{ChapterPiece, chapter_pieces};
///
/// let chapter = "# Beats\n\nTwo frequencies.\n\n<!-- item ch4/t5-beats-near-resonance -->\n";
/// let pieces = chapter_pieces(chapter)?;
/// assert_eq!(pieces[0], (1, ChapterPiece::Heading(1, "# Beats")));
/// assert_eq!(pieces[2], (5, ChapterPiece::Example("ch4/t5-beats-near-resonance")));
/// # Ok::<_, vibank::output::ChapterError>(())
/// ```
pub fn pieces(text: &str) -> Result<Vec<(usize, ChapterPiece<'_>)>, ChapterError> {
    let mut pieces = Vec::new();
    // Where the text begins that no piece holds yet, and on which line.
    let (mut from, mut first) = (0, 1);
    let mut at = 0;
    for (place, raw) in text.split_inclusive('\n').enumerate() {
        let (line, start) = (place + 1, at);
        at += raw.len();
        let Some(piece) = own_line(raw.trim_end(), line)? else {
            continue;
        };
        pieces.push((first, ChapterPiece::Text(&text[from..start])));
        pieces.push((line, piece));
        (from, first) = (at, line + 1);
    }
    pieces.push((first, ChapterPiece::Text(&text[from..])));
    pieces
        .retain(|(_, piece)| !matches!(piece, ChapterPiece::Text(text) if text.trim().is_empty()));
    Ok(pieces)
}

/// A heading, a picture or an example, where the line is one.
fn own_line(text: &str, line: usize) -> Result<Option<ChapterPiece<'_>>, ChapterError> {
    let level = text.bytes().take_while(|byte| *byte == b'#').count();
    if (1..=6).contains(&level) && text[level..].starts_with(' ') {
        return Ok(Some(ChapterPiece::Heading(level as u8, text)));
    }
    let Some(inner) = text.strip_prefix("<!-- ") else {
        return Ok(None);
    };
    let inner = inner.strip_suffix(" -->").unwrap_or(inner);
    let (place, words) = inner.split_once(" | ").unwrap_or((inner, ""));
    let asked: Vec<&str> = place.split(' ').collect();
    let (item, plot) = match asked[..] {
        ["plot", item, plot] => (item, Some(plot)),
        ["figure", item] => (item, None),
        ["item", item] => return Ok(Some(ChapterPiece::Example(item))),
        _ => {
            let found = inner.to_owned();
            return Err(ChapterError { line, found });
        }
    };
    Ok(Some(ChapterPiece::Picture { item, plot, words }))
}
