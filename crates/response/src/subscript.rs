//! Subscripts of letters: `_n`, `_{st}`, `_\\mathrm{st}`, `₁`.

use super::letters::{Letters, greek_word, name_of_command, sign_in_subscript};

/// Adds the subscript whose `_` stands at a place to the letters that it belongs to; where it ends.
pub(crate) fn subscript(text: &str, at: usize, letters: &mut Letters) -> usize {
    let length = letters.text.len();
    let mut at = at + 1;
    for command in ["\\mathrm", "\\text", "\\mathit"] {
        if text[at..].starts_with(command) {
            at += command.len();
        }
    }
    if let Some((sign, width)) = sign_in_subscript(&text[at..]) {
        letters.push(sign, at, at);
        return at + width;
    }
    let end = match text[at..].chars().next() {
        Some('\\') => command(text, at, letters),
        Some('{') => braced(text, at + 1, letters),
        // Without braces the letter or the digits that follow; a longer word is recognized by its names.
        Some(char) if letters.push(char, at, at) => at + char.len_utf8(),
        _ => at,
    };
    letters.join_from(length);
    end
}

/// Adds the Greek letter of a command; where it ends.
fn command(text: &str, at: usize, letters: &mut Letters) -> usize {
    let name = name_of_command(&text[at..]);
    let Some(word) = greek_word(name) else {
        return at;
    };
    letters.push_word(word, at);
    at + 1 + name.len()
}

/// Adds the letters up to the brace that closes; where they end.
fn braced(text: &str, start: usize, letters: &mut Letters) -> usize {
    let (mut at, mut inner) = (start, 0_u32);
    while let Some(char) = text[at..].chars().next() {
        let own = at;
        if let Some((sign, width)) = sign_in_subscript(&text[at..]) {
            letters.push(sign, own, own);
            at += width;
            continue;
        }
        at += char.len_utf8();
        match char {
            '}' if inner == 0 => break,
            '}' => inner -= 1,
            '{' => inner += 1,
            ',' | ' ' | '_' => {}
            '\\' => {
                let name = name_of_command(&text[own..]);
                at += name.len();
                if let Some(word) = greek_word(name) {
                    letters.push_word(word, own);
                }
            }
            _ if letters.push(char, own, own) => {}
            _ => return own,
        }
    }
    at
}

/// Adds the subscripts that come after dots or primes; where they end.
pub(crate) fn subscripts(text: &str, at: usize, letters: &mut Letters) -> usize {
    let mut at = at;
    while let Some(char) = text[at..].chars().next() {
        match char {
            '_' => at = subscript(text, at, letters),
            '0'..='9' | '₀'..='₉' => {
                letters.push(char, at, at);
                at += char.len_utf8();
            }
            _ => break,
        }
    }
    at
}
