//! Reads a general solution: a formula for each coordinate, or a sum of vectors.

use super::complex::phases;
use super::{DOUBTFUL, Setup};
use crate::answer::{Unreadable, Why};
use crate::expr::Expr;
use crate::math::Math;
use crate::response::{Lexicon, Manner, Passage};

/// The formulas of a response, by coordinate; with complex numbers in them, where only so they can be read.
pub(crate) fn read(setup: &Setup, response: Passage<'_>) -> Result<Vec<Expr>, Unreadable> {
    let may_be_complex = response.may_be_complex();
    read_in(setup, response, Manner::REAL, &setup.lexicon).or_else(|why| {
        let constant = || {
            let lexicon = setup.with_doubtful.as_ref()?;
            let typed = read_in(setup, response, Manner::REAL, lexicon).ok()?;
            // In an exponent or a phase it is the imaginary unit.
            let mut phases = typed.iter().flat_map(phases);
            (!phases.any(|name| name.as_str() == DOUBTFUL)).then_some(typed)
        };
        let complex = || read_in(setup, response, Manner::COMPLEX, &setup.lexicon).ok();
        let other = may_be_complex.then(|| constant().or_else(complex));
        other.flatten().ok_or(why)
    })
}

fn read_in(
    setup: &Setup,
    response: Passage<'_>,
    manner: Manner,
    lexicon: &Lexicon,
) -> Result<Vec<Expr>, Unreadable> {
    let count = setup.coordinates.len();
    let functions = match count {
        1 => response.lines(),
        _ => response.functions(),
    };
    if functions.len() == 1 && count > 1 {
        let found = response.components(count, lexicon, manner);
        if let Some(found) = found.map_err(|error| Unreadable::typed(&error, response))? {
            return Ok(found);
        }
    }
    if functions.len() != count {
        let symbols = setup.symbols.iter().map(Math::plain).collect();
        return Err(Why::Functions(symbols).into());
    }
    let mut found: Vec<Option<Expr>> = vec![None; count];
    for (position, function) in functions.into_iter().enumerate() {
        let own = match function.equated() {
            Some((left, _)) => named(setup, left, manner, lexicon)?,
            None => None,
        };
        let typed = function
            .formula(lexicon, manner)
            .map_err(|error| Unreadable::typed(&error, function))?;
        let place = own.unwrap_or(position);
        if found[place].replace(typed.value).is_some() {
            return Err(Why::TwoFunctions(setup.symbols[place].plain()).into());
        }
    }
    found
        .into_iter()
        .collect::<Option<Vec<_>>>()
        .ok_or_else(|| Why::FunctionMissing.into())
}

/// The place of the coordinate that stands before an equals sign; none for a letter that the item does not know.
fn named(
    setup: &Setup,
    left: Passage<'_>,
    manner: Manner,
    lexicon: &Lexicon,
) -> Result<Option<usize>, Unreadable> {
    let typed = left.formula(lexicon, manner);
    let place = setup.coordinates.iter().position(|name| {
        let typed = typed.as_ref().map(|typed| &typed.value);
        typed.is_ok_and(|typed| *typed == Expr::name(name.clone()))
    });
    let time = ["t".to_owned()];
    if place.is_none() && !left.is_empty() && !left.is_free_letter(&time) {
        let asked = setup.symbols.first().map_or_else(String::new, Math::plain);
        return Err(Unreadable::at(left, Why::OtherFunction(asked + "(t)")));
    }
    Ok(place)
}
