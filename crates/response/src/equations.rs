//! Where the equations of a response stand, and what is typed beside one.

use super::arguments::is_initial_state;
use super::list::cut;
use super::statements::is_approximation;
use crate::signs::is_digit;
use vibank_source::Span;

/// The equations of a text, cut at semicolons, line ends, and commas or `and` between equations.
pub(crate) fn equations(text: &str) -> Vec<Span> {
    const RELATIONS: [char; 6] = ['=', '<', '>', '≤', '≥', '≠'];
    let all = Span::new(0, text.len());
    let mut found = Vec::new();
    for line in cut(text, all, &[';', '\n']) {
        let commas = cut(text, line, &[',']).into_iter();
        let parts: Vec<Span> = commas.flat_map(|part| cut_at_and(text, part)).collect();
        let mut texts = parts.iter().map(|part| &text[part.range()]);
        let are_relations = texts.all(|text| text.contains(RELATIONS));
        found.extend(if are_relations { parts } else { vec![line] });
    }
    found.retain(|place| !text[place.range()].trim().is_empty());
    // The state at the start says nothing of the motion, where that is given; nor does what leads to it.
    let is_beside = |place: &Span| {
        let text = text[place.range()].trim();
        is_initial_state(text) || is_approximation(text)
    };
    if !found.iter().all(is_beside) {
        found.retain(|place| !is_beside(place));
    }
    if found.is_empty() {
        found.push(all);
    }
    found
}

/// The pieces of a text between the words and signs that join equations.
fn cut_at_and(text: &str, place: Span) -> Vec<Span> {
    // `∧` is folded into the sign of an intersection.
    const JOINTS: [&str; 4] = [" and ", " as well as ", " & ", "∩"];
    let mut from = place.range().start;
    let mut found = Vec::new();
    let next = |from: usize| {
        let rest = &text[from..place.range().end];
        let joints = JOINTS
            .iter()
            .filter_map(|joint| Some((rest.find(joint)?, joint.len())));
        joints.min()
    };
    while let Some((at, length)) = next(from) {
        found.push(Span::new(from, from + at));
        from += at + length;
    }
    found.push(Span::new(from, place.range().end));
    found
}

/// A number that an equation bears, `(2) m x'' = …`, `2. m x'' = …` or `m x'' = … (2)`.
pub(crate) fn number_of_equation(equation: &str) -> Option<&str> {
    let digits = |text: &str| text.len() - text.trim_start_matches(is_digit).len();
    let open = usize::from(equation.starts_with('('));
    let count = digits(&equation[open..]);
    let behind = open + count;
    let sign = equation[behind..].chars().next()?;
    let rest = &equation[behind + sign.len_utf8()..];
    let is_closed = match sign {
        ')' => true,
        '.' => open == 0 && rest.starts_with(' '),
        _ => false,
    };
    let begins_term = |char: char| char.is_alphanumeric() || "\\-√".contains(char);
    if count > 0 && is_closed && rest.trim_start().starts_with(begins_term) {
        return Some(&equation[..=behind]);
    }
    let (before, last) = equation.rsplit_once(" (")?;
    let is_number = last.len() == digits(last) + 1 && last.len() > 1 && last.ends_with(')');
    let ends_term = before.ends_with(|char: char| char.is_alphanumeric() || ")]}'".contains(char));
    // Zero times a number is zero.
    let is_zero = before
        .rsplit('=')
        .next()
        .is_some_and(|side| side.trim() == "0");
    (is_number && ends_term && !is_zero).then(|| &equation[before.len() + 1..])
}
