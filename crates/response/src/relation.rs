//! Shapes that are typed as a relation of their components: `x2/x1 = -0.5`, `A1 = 2 A2`, `x1 : x2 = 1 : 2`, `1 : -0.5`.

use std::ops::Range;

use super::letters::{Letters, letter};
use super::signs::{is_between_digits, is_digit, is_of_name};
use vibank_dynamics::numerics::sort_by_key;
use vibank_source::capital;

/// The components that a relation between all of them gives, as a list; none where it is none, or more than one thing is
/// said.
pub(crate) fn components_of(typed: &str, width: usize, names: &Names) -> Option<String> {
    let text = typed.trim().trim_end_matches('.');
    let sides: Vec<&str> = text.split('=').map(str::trim).collect();
    let (last, before) = sides
        .split_last()
        .filter(|(_, before)| !before.is_empty())?;
    let places = |side: &str| -> Option<Vec<usize>> {
        let own = side.split(':').map(str::trim);
        own.map(|name| names.whole(name)).collect()
    };
    if let [ratio] = before
        && ratio.contains(':')
    {
        let (order, values) = (places(ratio)?, last.split(':').map(str::trim));
        return ordered(&order, &values.collect::<Vec<_>>(), width, names);
    }
    // `x1 = x2 = x3`, and `x1 = x2 = 1`.
    let mut equal: Vec<usize> = before.iter().map_while(|side| names.whole(side)).collect();
    if equal.len() == before.len() {
        equal.extend(names.whole(last));
        if equal.len() == width {
            let value = if names.whole(last).is_some() {
                "1"
            } else {
                last
            };
            return ordered(&equal, &vec![value; width], width, names);
        }
    }
    let [left] = before else { return None };
    if width != 2 {
        return None;
    }
    quotient(left, last, names)
        .or_else(|| quotient(last, left, names))
        .or_else(|| multiple(left, last, names))
        .or_else(|| multiple(last, left, names))
}

/// `x2/x1 = value`.
fn quotient(ratio: &str, value: &str, names: &Names) -> Option<String> {
    let (above, below) = names.quotient(ratio)?;
    let is_value = names.first_in(value).is_none() && !value.is_empty();
    if !is_value {
        return None;
    }
    ordered(&[above, below], &[value, "1"], 2, names)
}

/// `x1 = value * x2`: a product in which the other component stands once.
fn multiple(name: &str, product: &str, names: &Names) -> Option<String> {
    let own = names.whole(name)?;
    let (place, other) = names.first_in(product)?;
    let (before, behind) = (&product[..place.start], &product[place.end..]);
    if names.first_in(before).is_some() || names.first_in(behind).is_some() {
        return None;
    }
    // A sum is not a multiple, and what stands below a fraction or in a function is none either.
    let is_below =
        before.trim_end().ends_with(['/', '^']) || behind.trim_start().starts_with(['^', '\'']);
    let is_inside = before.matches(['(', '{']).count() != before.matches([')', '}']).count();
    if is_sum(before, None) || is_sum(behind, Some(')')) || is_below || is_inside {
        return None;
    }
    let factor = format!("{before}(1){behind}");
    ordered(&[own, other], &[&factor, "1"], 2, names)
}

/// Whether terms are added outside of all brackets, after a sign that stands `before` the text; a sign before the first
/// of them, or in an exponent, adds nothing.
pub(crate) fn is_sum(text: &str, mut before: Option<char>) -> bool {
    let mut depth = 0_i32;
    for char in text.chars().filter(|char| !char.is_whitespace()) {
        match char {
            '(' | '{' | '[' => depth += 1,
            ')' | '}' | ']' => depth -= 1,
            '+' | '-' if depth == 0 && !before.is_none_or(|own| "*/^eE+-".contains(own)) => {
                return true;
            }
            _ => {}
        }
        before = Some(char);
    }
    false
}

/// Values in the order of the components.
fn ordered(order: &[usize], values: &[&str], width: usize, names: &Names) -> Option<String> {
    if order.len() != width || values.len() != width {
        return None;
    }
    let entries: Option<Vec<String>> = (1..=width)
        .map(|place| {
            let at = order.iter().position(|own| *own == place)?;
            let value = values[at];
            (!value.is_empty() && names.first_in(value).is_none()).then(|| format!("({value})"))
        })
        .collect();
    Some(format!("[{}]", entries?.join("; ")))
}

/// The names of components.
#[derive(Debug, Default)]
pub(crate) struct Names {
    /// Spellings of those without an index, and which components they are.
    own: Vec<(String, usize)>,
}

impl Names {
    /// Those of coordinates with these symbols.
    pub(crate) fn of<'s>(symbols: impl IntoIterator<Item = &'s str>) -> Self {
        let mut own = Vec::new();
        for (place, symbol) in symbols.into_iter().enumerate() {
            let is_letter = symbol.chars().count() == 1 && symbol.chars().all(char::is_alphabetic);
            if !is_letter {
                continue;
            }
            let word = Letters::spelling(symbol).unwrap_or_default();
            let ordinary: String = symbol.chars().map(ordinary).collect();
            let capital = capital(&ordinary);
            let all = [symbol.to_owned(), capital, format!("\\{word}"), word];
            own.extend(all.into_iter().map(|spelling| (spelling, place + 1)));
        }
        // `theta` before `t`.
        sort_by_key(&mut own, |(spelling, _)| std::cmp::Reverse(spelling.len()));
        Self { own }
    }

    /// The component that all of a text names: `x1`, `x_1`, `X_{2}`, `θ₁`, `A1`.
    pub(crate) fn whole(&self, text: &str) -> Option<usize> {
        let text = text.trim();
        let (place, index) = self.first_in(text)?;
        (place == (0..text.len())).then_some(index)
    }

    /// The two components of `x2/x1`.
    pub(crate) fn quotient(&self, ratio: &str) -> Option<(usize, usize)> {
        let bare = ratio
            .strip_prefix('(')
            .and_then(|rest| rest.strip_suffix(')'));
        let ratio = bare.unwrap_or(ratio);
        let ratio = ratio
            .strip_prefix("\\frac{")
            .and_then(|rest| rest.strip_suffix('}'))
            .map_or_else(|| ratio.to_owned(), |rest| rest.replacen("}{", "/", 1));
        let (above, below) = ratio.split_once('/')?;
        Some((self.whole(above)?, self.whole(below)?))
    }

    /// The first name of a component in a text, and which one it is. Letters of stiffnesses, masses and lengths, which
    /// have indices too, name none.
    pub(crate) fn first_in(&self, text: &str) -> Option<(Range<usize>, usize)> {
        const STEMS: &[&str] = &[
            "x", "X", "y", "Y", "u", "U", "q", "Q", "a", "A", "B", "\\theta", "theta", "θ", "Θ",
            "\\varphi", "\\phi", "phi", "φ", "ϕ", "Φ",
        ];
        let is_letter = |char: char| char.is_alphabetic() || char == '\\';
        text.char_indices().find_map(|(at, char)| {
            let begins = is_letter(char)
                && !text[..at].ends_with(|before: char| is_letter(before) || before == '_');
            if !begins {
                return None;
            }
            let behind = &text[at..];
            let indexed = STEMS
                .iter()
                .filter(|stem| behind.starts_with(**stem))
                .find_map(|stem| {
                    let (index, length) = index_of(&behind[stem.len()..])?;
                    Some((at + stem.len() + length, index))
                });
            let mut own = self.own.iter().map(|(own, index)| (own.as_str(), index));
            let is_whole = |(end, _): &(usize, usize)| !text[*end..].starts_with(is_of_name);
            let found = indexed.filter(is_whole).or_else(|| {
                let (spelling, index) = own.find(|(own, _)| behind.starts_with(own))?;
                Some((at + spelling.len(), *index)).filter(is_whole)
            });
            found.map(|(end, index)| (at..end, index))
        })
    }
}

/// A Greek letter of another shape as the ordinary one, whose capital it has.
fn ordinary(letter: char) -> char {
    match letter {
        'ϑ' => 'θ',
        'ϕ' => 'φ',
        'ϖ' => 'π',
        'ϰ' => 'κ',
        'ϱ' => 'ρ',
        'ϵ' => 'ε',
        'ς' => 'σ',
        _ => letter,
    }
}

/// An index, `1`, `_1`, `_{1}` or `₁`, and its length.
fn index_of(text: &str) -> Option<(usize, usize)> {
    const LOWERED: [char; 9] = ['₁', '₂', '₃', '₄', '₅', '₆', '₇', '₈', '₉'];
    if let Some(place) = text
        .chars()
        .next()
        .and_then(|char| LOWERED.iter().position(|own| *own == char))
    {
        return Some((place + 1, LOWERED[place].len_utf8()));
    }
    [("_{", "}"), ("_", ""), ("", "")]
        .iter()
        .find_map(|(open, close)| {
            let inner = text.strip_prefix(open)?;
            let digit = inner
                .chars()
                .next()?
                .to_digit(10)
                .filter(|digit| *digit > 0)?;
            inner[1..]
                .starts_with(close)
                .then_some((digit as usize, open.len() + 1 + close.len()))
        })
}

/// A ratio of components, `1 : -0.5`, as a list; all places stay.
pub(crate) fn ratio_as_list(typed: &str) -> String {
    let typed = &typed.replace(" to ", " : ");
    let mut commas = typed.match_indices(',').map(|(at, _)| at);
    let has_decimals = commas.all(|at| is_between_digits(typed, at));
    let mut values = typed.split(':').skip(1).map(str::trim_start);
    // `1 : -1 : 0; 1 : 1 : -2` are several.
    let ratios: Vec<&str> = typed.split(';').map(str::trim).collect();
    let are_ratios = ratios.len() > 1
        && ratios.iter().all(|ratio| {
            let mut chars = ratio.chars();
            ratio.contains(':') && chars.all(|char| is_digit(char) || ".+-/: ".contains(char))
        });
    if are_ratios {
        let vectors = ratios
            .iter()
            .map(|ratio| format!("({})", ratio.replace(':', ", ")));
        return vectors.collect::<Vec<_>>().join(", ");
    }
    let is_label = |value: &str| value.starts_with(['(', '[', '{']);
    if has_decimals && !typed.contains(';') && !values.any(is_label) {
        return typed.replace(':', ";");
    }
    typed.to_owned()
}

/// A list of multiples of one letter, `(α, -2α)`, with one for the letter: a shape has any scale.
pub(crate) fn without_common_letter(typed: &str) -> Option<String> {
    let start = typed.rfind('=').map_or(0, |at| at + 1);
    let list = &typed[start..];
    let (mut plain, mut common, mut rest) = (String::new(), None, list);
    while let Some(first) = rest.chars().next() {
        let Some((length, name)) = letter(rest).filter(|_| !first.is_ascii_digit()) else {
            let is_of_list = first.is_ascii_digit() || " .,;()[]{}+-*/".contains(first);
            plain.push(first);
            rest = is_of_list.then(|| &rest[first.len_utf8()..])?;
            continue;
        };
        let behind = rest[length..].trim_start();
        let is_below = plain.trim_end().ends_with('/') || behind.starts_with(['^', '(', '_', '\'']);
        if is_below
            || behind.starts_with(char::is_alphanumeric)
            || *common.get_or_insert(name.clone()) != name
        {
            return None;
        }
        plain.push_str("(1)");
        rest = &rest[length..];
    }
    let is_zero = |entry: &str| entry.trim_matches(['(', ')', '[', ']', ' ']) == "0";
    let inner = plain.trim().trim_matches(['(', '[', '{', ')', ']', '}']);
    let is_entry = |entry: &str| entry.contains('1') && !is_sum(entry, None) || is_zero(entry);
    let is_whole = list.trim().starts_with(['(', '[', '{']) && !inner.is_empty();
    let are_multiples = list
        .split([',', ';'])
        .all(|entry| entry.contains(char::is_alphabetic) || is_zero(entry));
    let entries = plain.split([',', ';']);
    // `(1 m, -4 m)` has units.
    let is_bare = |entry: &str| entry.contains(char::is_alphabetic) && !entry.contains(is_digit);
    let is_whole = is_whole && list.split([',', ';']).any(is_bare);
    (common.is_some() && is_whole && are_multiples && entries.clone().all(is_entry))
        .then(|| format!("{}{plain}", &typed[..start]))
}

#[cfg(test)]
mod tests {
    use super::Names;

    fn components_of(typed: &str, width: usize) -> Option<String> {
        super::components_of(typed, width, &Names::default())
    }

    #[test]
    fn multiples_of_one_letter_have_it_for_a_scale() {
        for (typed, plain) in [
            ("(α, -α)", Some("((1), -(1))")),
            ("u2 = [A; -2 A]", Some("u2 = [(1); -2 (1)]")),
            ("(theta, 0)", Some("((1), 0)")),
            ("(A, -B)", None),
            ("(A, 1)", None),
            ("(A, A^2)", None),
            ("(A, 1/A)", None),
            ("(A1, A2)", None),
            ("(1, -1)", None),
        ] {
            assert_eq!(
                super::without_common_letter(typed).as_deref(),
                plain,
                "{typed}"
            );
        }
    }

    #[test]
    fn relations_of_all_components_are_shapes() {
        for (typed, components) in [
            ("x1 = x2", "[(1); (1)]"),
            ("x_1 = x_2 = 1", "[(1); (1)]"),
            ("x2/x1 = -0.5", "[(1); (-0.5)]"),
            ("A1/A2 = sqrt(2)", "[(sqrt(2)); (1)]"),
            ("\\frac{X_2}{X_1} = -1", "[(1); (-1)]"),
            ("X1 = -2 X2", "[(-2 (1)); (1)]"),
            ("θ₂ = -θ₁", "[(1); (-(1))]"),
            ("x1 : x2 = 1 : 2", "[(1); (2)]"),
            ("x2:x1=1:2", "[(2); (1)]"),
            ("u_{2} = k/(k - m*w^2) u_{1}", "[(1); (k/(k - m*w^2) (1))]"),
        ] {
            assert_eq!(
                components_of(typed, 2).as_deref(),
                Some(components),
                "{typed}"
            );
        }
        assert_eq!(
            components_of("x1:x2:x3 = 1:2:1", 3).as_deref(),
            Some("[(1); (2); (1)]")
        );
    }

    #[test]
    fn what_leaves_components_open_is_none() {
        for typed in [
            "x1 = x2 + 1",
            "x1 = x1",
            "x1 = 1",
            "1, 2",
            "x1/x2",
            "x1 = 1 - x2",
            "x1 = 2/x2",
            "x1 = x2^2",
            "x1 = sin(x2)",
            "x1/x2 = x2",
            "x1 = k1*k2",
            "u1 = (1, 2)",
            "x1 = x2 = x1",
            "x1:x2 = 1:2:3",
            "x1 = x3",
            "x1 = x2 x1",
            "x1 = (2) + x2",
            "x1 = x2 (3) - 1",
        ] {
            assert_eq!(components_of(typed, 2), None, "{typed}");
        }
    }
}
