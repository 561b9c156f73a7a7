//! Reads the equations of a response.

use super::{Setup, written};
use crate::answer::{Answered, Reading, Unreadable, Why};
use crate::expr::{Equation, Expr, Relation};
use crate::math::Math;
use crate::response::{self, Chain, Manner, Trouble, cut};
use crate::source::Span;

impl Setup {
    /// The equations that a response is.
    pub(crate) fn read(&self, response: &str) -> Result<Vec<Equation>, Unreadable> {
        let manner = Manner {
            comma_is_decimal: true,
            has_imaginary_unit: false,
            values: None,
        };
        let mut found = Vec::new();
        for place in pieces(response) {
            let (from, to) = (place.range().start, place.range().end);
            if let Some(why) = beside_the_point(&response[place.range()]) {
                return Err(why);
            }
            let chain = response::chain(response, from, to, &self.lexicon, manner);
            let chain = chain.map_err(|error| match error.trouble {
                Trouble::NoRelation => Why::NoEquation.into(),
                _ => Unreadable::typed(&error, response),
            })?;
            let fits = |chain: &Chain| {
                let equations = of_chain(chain).unwrap_or_default();
                let mut equations = equations.iter();
                equations.all(|equation| equation.check(&self.meaning).is_ok())
            };
            found.extend(of_chain(&chain.fitting(fits))?);
        }
        Ok(found)
    }

    /// How equations were read.
    pub(crate) fn reading(&self, equations: &[Equation]) -> Reading {
        Reading {
            math: self.typeset(equations),
            text: written(equations),
            answered: Answered::Equations(equations.to_vec()),
        }
    }

    /// Equations side by side, typeset.
    pub(crate) fn typeset(&self, equations: &[Equation]) -> Math {
        let mut row = Vec::new();
        for equation in equations {
            if !row.is_empty() {
                row.push(Math::punctuation(";"));
            }
            row.push(equation.left.typeset(&self.lexicon));
            row.push(Math::relation("="));
            row.push(equation.right.typeset(&self.lexicon));
        }
        Math::row(row)
    }
}

/// The equations `a = b = c` is.
fn of_chain(chain: &Chain) -> Result<Vec<Equation>, Unreadable> {
    if chain
        .relations
        .iter()
        .any(|relation| *relation != Relation::Equal)
    {
        return Err(Why::NotInequality.into());
    }
    let pair = |sides: &[Expr]| Equation {
        left: sides[0].clone(),
        right: sides[1].clone(),
    };
    Ok(chain.sides.windows(2).map(pair).collect())
}

/// The equations of a text, cut at semicolons, line ends, and commas or `and` between equations.
fn pieces(text: &str) -> Vec<Span> {
    const RELATIONS: [char; 6] = ['=', '<', '>', '≤', '≥', '≠'];
    let all = Span::new(0, text.len());
    let mut found = Vec::new();
    for line in cut(text, all, &[';', '\n']) {
        let commas = cut(text, line, &[',']).into_iter();
        let parts: Vec<Span> = commas.flat_map(|part| cut_at_and(text, part)).collect();
        let is_relation = |part: &Span| text[part.range()].contains(RELATIONS);
        found.extend(if parts.iter().all(is_relation) {
            parts
        } else {
            vec![line]
        });
    }
    found.retain(|place| !text[place.range()].trim().is_empty());
    if found.is_empty() {
        found.push(all);
    }
    found
}

fn cut_at_and(text: &str, place: Span) -> Vec<Span> {
    const AND: &str = " and ";
    let mut from = place.range().start;
    let mut found = Vec::new();
    while let Some(at) = text[from..place.range().end].find(AND) {
        found.push(Span::new(from, from + at));
        from += at + AND.len();
    }
    found.push(Span::new(from, place.range().end));
    found
}

/// What is said about a number of an equation, which could be a factor, and about the state at the start.
fn beside_the_point(equation: &str) -> Option<Unreadable> {
    let equation = equation.trim();
    if let Some(number) = number_of(equation) {
        return Some(Unreadable::at(number, Why::EquationNumber));
    }
    let (left, _) = equation.split_once('=')?;
    let name = left.trim_end().strip_suffix("(0)")?;
    let is_name = name.starts_with(char::is_alphabetic)
        && name
            .chars()
            .all(|char| char.is_alphanumeric() || "_'\"".contains(char));
    is_name.then(|| Unreadable::at(equation, Why::InitialState))
}

/// A number that an equation bears, `(2) m x'' = …`, `2. m x'' = …` or `m x'' = … (2)`.
fn number_of(equation: &str) -> Option<&str> {
    let digits = |text: &str| {
        let end = text.find(|char: char| !char.is_ascii_digit());
        end.unwrap_or(text.len())
    };
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
