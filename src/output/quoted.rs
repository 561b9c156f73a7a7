//! Messages on a page: what they quote between backticks is set as code.

use serde::Serialize;

/// A piece of a message.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub(crate) struct MessagePiece<'m> {
    text: &'m str,
    is_code: bool,
}

/// The pieces of a message; a backtick without a second one is itself.
pub(crate) fn pieces(message: &str) -> Vec<MessagePiece<'_>> {
    let (mut pieces, mut rest) = (Vec::new(), message);
    let mut add = |text, is_code| pieces.push(MessagePiece { text, is_code });
    while let Some((before, behind)) = rest.split_once('`')
        && let Some((quoted, after)) = behind.split_once('`')
    {
        add(before, false);
        add(quoted, true);
        rest = after;
    }
    add(rest, false);
    pieces.retain(|piece| !piece.text.is_empty());
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_between_two_backticks_is_quoted() {
        let shown = |message| {
            let pieces = pieces(message).into_iter();
            let pieces = pieces.map(|piece| {
                if piece.is_code {
                    format!("<{}>", piece.text)
                } else {
                    piece.text.to_owned()
                }
            });
            pieces.collect::<String>()
        };
        assert_eq!(
            shown("row 3: `x` is not part of `A`"),
            "row 3: <x> is not part of <A>"
        );
        assert_eq!(shown("`5` and a ` alone"), "<5> and a ` alone");
        assert_eq!(shown("no quotes"), "no quotes");
        assert_eq!(shown("``"), "");
    }
}
