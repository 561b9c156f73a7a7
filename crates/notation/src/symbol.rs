//! The symbol of a name: `omega_n` is ω with the subscript n.

use super::{GREEK, Math, Style};

/// The symbol that a name stands for.
///
/// The name is cut at its underscores and between letters and the digits after them. What comes
/// first is the letter, the rest its subscript, parts of it separated by commas. A name of a
/// Greek letter is that letter, a single letter is italic, a longer word upright.
///
/// # Examples
///
/// ```
/// use vibank_notation::symbol;
///
/// assert_eq!(symbol("omega_n").latex(), r"\omega_n");
/// assert_eq!(symbol("k1").latex(), "k_1");
/// assert_eq!(symbol("X10").latex(), "X_{10}");
/// assert_eq!(symbol("m_eq").latex(), r"m_\mathrm{eq}");
/// assert_eq!(symbol("theta0_max").latex(), r"\theta_{0, \mathrm{max}}");
/// ```
pub fn symbol(name: &str) -> Math {
    let mut parts = name.split('_').filter(|part| !part.is_empty());
    let (head, digits) = cut(parts.next().unwrap_or(name));
    let subscripts = Some(digits)
        .filter(|digits| !digits.is_empty())
        .into_iter()
        .chain(parts)
        .map(subscript);
    let mut subscript = Vec::new();
    for part in subscripts {
        if !subscript.is_empty() {
            subscript.push(Math::punctuation(","));
        }
        subscript.extend(part);
    }
    if subscript.is_empty() {
        return word(head);
    }
    word(head).with_sub(Math::row(subscript))
}

/// Letters, and the digits after them with what follows.
fn cut(part: &str) -> (&str, &str) {
    match part.find(|c: char| c.is_ascii_digit()) {
        Some(at) if at > 0 => part.split_at(at),
        _ => (part, ""),
    }
}

/// One part of a subscript: `d`, `12`, `d2`, `eq`.
fn subscript(part: &str) -> Vec<Math> {
    let mut pieces = Vec::new();
    let mut rest = part;
    while let Some(first) = rest.chars().next() {
        let is_digit = first.is_ascii_digit();
        let end = rest
            .find(|c: char| c.is_ascii_digit() != is_digit)
            .unwrap_or(rest.len());
        let (piece, after) = rest.split_at(end);
        pieces.push(if is_digit {
            Math::number(piece)
        } else {
            word(piece)
        });
        rest = after;
    }
    pieces
}

fn word(word: &str) -> Math {
    if let Some((_, letter)) = GREEK.iter().find(|(name, _)| *name == word) {
        return Math::letter(*letter);
    }
    let is_single = word.chars().nth(1).is_none();
    if is_single && word.starts_with(|c: char| c.is_ascii_digit()) {
        return Math::number(word);
    }
    let style = if is_single {
        Style::Default
    } else {
        Style::Upright
    };
    Math::identifier(word, style)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_symbols() {
        for (name, latex) in [
            ("x", "x"),
            ("Omega", r"\Omega"),
            ("theta0", r"\theta_0"),
            ("x_rest", r"x_\mathrm{rest}"),
            ("omega_d2", r"\omega_{d2}"),
            ("x_theta", r"x_\theta"),
            ("mu_crit", r"\mu_\mathrm{crit}"),
            ("thetadot", r"\mathrm{thetadot}"),
            ("ratio", r"\mathrm{ratio}"),
            ("F1x", "F_{1x}"),
            ("x_1_2", "x_{1, 2}"),
            ("ell", r"\ell"),
        ] {
            assert_eq!(symbol(name).latex(), latex, "{name}");
        }
    }

    #[test]
    fn what_is_no_name_does_not_panic() {
        for name in ["", "_", "__", "1", "12", "ß_2", "a__b", "x\u{301}"] {
            symbol(name);
        }
    }
}
