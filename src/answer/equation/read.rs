//! Reads the equations of a response.

use super::{Setup, written};
use crate::answer::Reading;
use crate::answer::typed::{self, Chain, Manner, Typed, cut};
use crate::expr::{Equation, Expr, Relation};
use crate::math::Math;
use crate::source::Span;

impl Setup {
    /// The equations that a response is.
    pub(super) fn read(&self, response: &str) -> Result<Vec<Equation>, String> {
        let manner = Manner {
            comma_is_decimal: true,
            has_imaginary_unit: false,
        };
        let mut found = Vec::new();
        for place in pieces(response) {
            let (from, to) = (place.range().start, place.range().end);
            let chain = typed::chain(response, from, to, &self.lexicon, manner);
            let Typed { value, other } = chain.map_err(|error| error.sentence(response))?;
            let first = of_chain(value)?;
            let other = other.and_then(|other| of_chain(other).ok());
            let fits = |equations: &[Equation]| {
                equations
                    .iter()
                    .all(|equation| equation.check(&self.meaning).is_ok())
            };
            found.extend(match other {
                Some(other) if !fits(&first) && fits(&other) => other,
                _ => first,
            });
        }
        Ok(found)
    }

    /// How equations were read.
    pub(super) fn reading(&self, equations: &[Equation]) -> Reading {
        Reading {
            math: self.typeset(equations),
            text: written(equations),
            si: Vec::new(),
        }
    }

    /// Equations side by side, typeset.
    pub(super) fn typeset(&self, equations: &[Equation]) -> Math {
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
fn of_chain(chain: Chain) -> Result<Vec<Equation>, String> {
    if chain
        .relations
        .iter()
        .any(|relation| *relation != Relation::Equal)
    {
        return Err("An equation is asked, not an inequality.".to_owned());
    }
    let pair = |sides: &[Expr]| Equation {
        left: sides[0].clone(),
        right: sides[1].clone(),
    };
    Ok(chain.sides.windows(2).map(pair).collect())
}

/// The equations of a text, cut at semicolons, line ends, and commas between equations.
fn pieces(text: &str) -> Vec<Span> {
    let all = Span::new(0, text.len());
    let mut found = Vec::new();
    for line in cut(text, all, &[';', '\n']) {
        let parts = cut(text, line, &[',']);
        let are_equations = parts.iter().all(|part| text[part.range()].contains('='));
        found.extend(if are_equations { parts } else { vec![line] });
    }
    found.retain(|place| !text[place.range()].trim().is_empty());
    if found.is_empty() {
        found.push(all);
    }
    found
}
