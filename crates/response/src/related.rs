//! Components of a shape from several relations, `x2/x1 = 1.5, x3 = -x1`, or from one that is solved for none of them,
//! `m1 x1 + m2 x2 = 0`.

use super::relation::{Names, is_sum};
use vibank_dynamics::numerics::Rational;

/// Most components that are looked for.
const MAX_WIDTH: usize = 9;

/// What is said of components.
enum Relation {
    /// One is a number.
    Value { of: usize, value: String },
    /// One is a multiple of another.
    Multiple {
        of: usize,
        factor: String,
        by: usize,
    },
}

/// The components that relations give, as a list; the first one that they leave open is 1. Nothing where they leave more
/// of them open, or where two say the same.
pub(crate) fn components_of(typed: &str, width: usize, names: &Names) -> Option<String> {
    if !(2..=MAX_WIDTH).contains(&width) {
        return None;
    }
    let text = typed.trim().trim_end_matches('.');
    let mut relations = Vec::new();
    for statement in statements(text) {
        relations.extend(of_statement(statement, names)?);
    }
    solved(relations, width)
}

/// The statements that commas, semicolons, line ends and `and` part; a comma between two digits is a decimal sign.
fn statements(text: &str) -> Vec<&str> {
    let (mut pieces, mut start, mut depth) = (Vec::new(), 0, 0_i32);
    for (at, char) in text.char_indices() {
        let digit = |char: char| char.is_ascii_digit();
        let behind = &text[at + char.len_utf8()..];
        let is_decimal = char == ',' && text[..at].ends_with(digit) && behind.starts_with(digit);
        match char {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            ',' | ';' | '\n' if depth == 0 && !is_decimal => {
                pieces.push(&text[start..at]);
                start = at + char.len_utf8();
            }
            _ => {}
        }
    }
    pieces.push(&text[start..]);
    let pieces = pieces.into_iter().flat_map(|piece| piece.split(" and "));
    pieces
        .map(str::trim)
        .filter(|piece| !piece.is_empty())
        .collect()
}

/// The relations of a chain of equals signs.
fn of_statement(text: &str, names: &Names) -> Option<Vec<Relation>> {
    let sides: Vec<&str> = text.split(['=', '≈']).map(str::trim).collect();
    let [first, .., last] = sides[..] else {
        return None;
    };
    // `x2/x1 = (k - m ω²)/K = 0.29`
    let behind = &sides[1..];
    if behind.iter().all(|side| names.first_in(side).is_none()) {
        return Some(vec![of_sides(first, last, names)?]);
    }
    let pairs = sides.windows(2);
    pairs
        .map(|pair| of_sides(pair[0], pair[1], names))
        .collect()
}

fn of_sides(left: &str, right: &str, names: &Names) -> Option<Relation> {
    let is_bare = |side: &str| names.first_in(side).is_none();
    match (is_bare(left), is_bare(right)) {
        (true, true) => None,
        (true, false) => of_sides(right, left, names),
        (false, true) if right.is_empty() || is_list(right) => None,
        (false, true) => {
            if is_zero(right)
                && let Some([one, other]) = two_terms(left)
            {
                let ((factor, of), (own, by)) = (term(one, names)?, term(other, names)?);
                let factor = format!("-({own})/({factor})");
                return (of != by).then_some(Relation::Multiple { of, factor, by });
            }
            let value = right.to_owned();
            if let Some(of) = names.whole(left) {
                return Some(Relation::Value { of, value });
            }
            let (of, by) = names.quotient(left)?;
            let factor = format!("({value})");
            (of != by).then_some(Relation::Multiple { of, factor, by })
        }
        (false, false) => {
            let ((own, of), (factor, by)) = (term(left, names)?, term(right, names)?);
            let factor = format!("({factor})/({own})");
            (of != by).then_some(Relation::Multiple { of, factor, by })
        }
    }
}

fn is_zero(text: &str) -> bool {
    Rational::from_decimal(text).is_some_and(Rational::is_zero)
}

/// Whether brackets with several entries stand in a value, `u1 = (1, 2)`.
fn is_list(text: &str) -> bool {
    text.contains(['[', ';', '&']) || text.contains('(') && text.contains(',')
}

/// The two terms of a sum, each with its sign.
fn two_terms(text: &str) -> Option<[&str; 2]> {
    let mut depth = 0_i32;
    let mut signs = Vec::new();
    for (at, char) in text.char_indices() {
        match char {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            '+' | '-' if depth == 0 && !text[..at].trim().is_empty() => signs.push(at),
            _ => {}
        }
    }
    let [sign] = signs[..] else {
        return None;
    };
    let (one, other) = text.split_at(sign);
    Some([one.trim(), other.strip_prefix('+').unwrap_or(other).trim()])
}

/// What multiplies the one component in a term, and which one it is.
fn term(text: &str, names: &Names) -> Option<(String, usize)> {
    let (place, of) = names.first_in(text)?;
    let (before, behind) = (&text[..place.start], &text[place.end..]);
    let is_other = names.first_in(before).is_some() || names.first_in(behind).is_some();
    let is_below =
        before.trim_end().ends_with(['/', '^']) || behind.trim_start().starts_with(['^', '\'']);
    let is_inside = before.matches(['(', '{']).count() != before.matches([')', '}']).count();
    let is_sum = is_sum(before, None) || is_sum(behind, Some(')'));
    let is_term = !is_other && !is_below && !is_inside && !is_sum && !is_list(text);
    is_term.then(|| (format!("{before}(1){behind}"), of))
}

/// The components of relations, each of which gives one of them.
fn solved(relations: Vec<Relation>, width: usize) -> Option<String> {
    let mut found: Vec<Option<String>> = vec![None; width];
    let (mut multiples, mut has_value) = (Vec::new(), false);
    for relation in relations {
        match relation {
            Relation::Value { of, value } => {
                has_value |= !is_zero(&value);
                let place = found.get_mut(of - 1)?;
                if place.replace(format!("({value})")).is_some() {
                    return None;
                }
            }
            Relation::Multiple { of, factor, by } => multiples.push((of, factor, by)),
        }
    }
    if !has_value {
        let open = found.iter_mut().find(|own| own.is_none())?;
        *open = Some("1".to_owned());
    }
    // Each round solves one, or none is left that can be.
    for _ in 0..multiples.len() {
        let known = |found: &[Option<String>], of: usize| found.get(of - 1).cloned().flatten();
        let at = multiples
            .iter()
            .position(|(of, _, by)| known(&found, *of).is_some() != known(&found, *by).is_some())?;
        let (of, factor, by) = multiples.swap_remove(at);
        match (known(&found, of), known(&found, by)) {
            (None, Some(by)) => *found.get_mut(of - 1)? = Some(format!("({factor})*({by})")),
            (Some(of), None) => *found.get_mut(by - 1)? = Some(format!("({of})/({factor})")),
            _ => return None,
        }
    }
    let all: Option<Vec<String>> = found.into_iter().collect();
    Some(format!("[{}]", all?.join("; ")))
}

#[cfg(test)]
mod tests {
    use super::components_of;
    use crate::relation::Names;

    #[test]
    fn several_relations_give_the_components_of_a_shape() {
        for (typed, names, width, components) in [
            (
                "x2/x1 = 1.5, x3/x1 = 2",
                &["x₁", "x₂", "x₃"][..],
                3,
                "[1; ((1.5))*(1); ((2))*(1)]",
            ),
            (
                "x1 = -x3, x2 = 0",
                &["x₁", "x₂", "x₃"],
                3,
                "[1; (0); (1)/((-(1))/((1)))]",
            ),
            (
                "m1 x1 + m2 x2 = 0",
                &["x₁", "x₂"],
                2,
                "[1; (1)/(-(m2 (1))/(m1 (1)))]",
            ),
            ("θ/x1 = -7.49", &["x₁", "θ"], 2, "[1; ((-7.49))*(1)]"),
            ("x1 = 1; θ = -7,49", &["x₁", "θ"], 2, "[(1); (-7,49)]"),
            (
                "x2/x1 = (k - m)/K = 0.29",
                &["x₁", "x₂"],
                2,
                "[1; ((0.29))*(1)]",
            ),
        ] {
            let names = Names::of(names.iter().copied());
            let found = components_of(typed, width, &names);
            assert_eq!(found.as_deref(), Some(components), "{typed}");
        }
    }

    #[test]
    fn relations_that_leave_components_open_are_no_shape() {
        let names = Names::of(["x₁", "x₂", "x₃"]);
        for typed in [
            "x1 = x2",
            "x1 = 1, x2 = 2",
            "x1 = 1, x2 = 2, x3 = x1 + x2",
            "x1 = x2, x2 = x1",
            "x1 = 1, x1 = 2, x2 = x3",
            "x1 = (1, 2, 3)",
            "x1 = x2, x3 = sin(x1)",
            "1, 2, 3",
        ] {
            assert_eq!(components_of(typed, 3, &names), None, "{typed}");
        }
    }
}
