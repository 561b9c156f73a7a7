//! Reads the equations of a response.

use super::Setup;
use crate::answer::{Unreadable, Why};
use crate::expr::{Equation, Expr, Kind, Relation, Substitution};
use crate::math::symbol;
use crate::response::{
    Chain, Defining, Lexicon, Manner, Passage, Reworded, Trouble, Typed, unit_of_zero,
};

/// The equations that a response is; where others say what letters mean that the question does not have, with
/// these in their place.
pub(crate) fn equations(setup: &Setup, response: Passage<'_>) -> Result<Vec<Equation>, Unreadable> {
    let lexicon = &setup.lexicon;
    alone(setup, lexicon, response, Manner::REAL).or_else(|why| {
        // What is said beside the point stays so, whatever letters mean.
        let is_beside = matches!(
            *why.why,
            Why::EquationNumber | Why::InitialState | Why::UnitOfZero | Why::NotInequality
        );
        // `[M][x''] + [K][x] = 0`
        let rows = response.equations_of_matrices();
        rows.and_then(|rows| alone(setup, lexicon, rows.passage(), Manner::REAL).ok())
            .or_else(|| (!is_beside).then(|| defined(setup, response, Defining::Statements))?)
            .or_else(|| by_direction(setup, response).map(|own| vec![own]))
            .or_else(|| alone(setup, lexicon, response, Manner::REAL.in_any_case()).ok())
            .ok_or(why)
    })
}

/// The equations of a response that leaves symbols of the field open, as textbooks define these.
pub(crate) fn by_textbooks(
    setup: &Setup,
    response: Passage<'_>,
    why: &Unreadable,
) -> Option<Vec<Equation>> {
    let is_of_formula = matches!(*why.why, Why::Formula(_));
    is_of_formula.then(|| defined(setup, response, Defining::Textbooks))?
}

/// What else a response of one equation may be meant as, of the same dimension: `k l^2/4θ`.
pub(crate) fn others(
    setup: &Setup,
    response: Passage<'_>,
    taken: &[Equation],
) -> Vec<Vec<Equation>> {
    let [own] = response.equations()[..] else {
        return Vec::new();
    };
    let Ok(typed) = own.chain(&setup.lexicon, Manner::REAL) else {
        return Vec::new();
    };
    let is_sound = |own: &[Equation]| own.iter().all(|own| own.check(&setup.meaning).is_ok());
    let has_sound = is_sound(taken);
    let all = [typed.value].into_iter().chain(typed.others);
    let all = all.filter_map(|chain| of_chain(&chain).ok());
    all.filter(|own| *own != taken && (!has_sound || is_sound(own)))
        .collect()
}

/// The equations of a response in which letters are defined beside the question.
pub(crate) fn defined(
    setup: &Setup,
    response: Passage<'_>,
    defining: Defining,
) -> Option<Vec<Equation>> {
    // Equations that hold together are no alternatives: `z = 0 or x² + y² = l²`.
    if setup.key.len() > 1 && response.has_alternatives() {
        return None;
    }
    let chains = response
        .defined_chains(&setup.lexicon, Manner::REAL, defining)?
        .ok()?;
    let mut found = Vec::new();
    for chain in chains {
        found.extend(of_chain(&fitting(setup, chain)).ok()?);
    }
    (!found.is_empty()).then_some(found)
}

/// The equation of a motion that has one for either direction, `m x'' = -F for x' > 0, m x'' = F for x' < 0`.
fn by_direction(setup: &Setup, response: Passage<'_>) -> Option<Equation> {
    let cases = response.cases()?;
    let [one, other] = &cases[..] else {
        return None;
    };
    let read = |case: &Reworded| {
        let chain = chain_alone(setup, case.passage())?;
        let [equation] = <[Equation; 1]>::try_from(of_chain(&chain).ok()?).ok()?;
        let (rate, is_positive) = direction(setup, case.conditions().next()?)?;
        Some((rate, is_positive, equation))
    };
    let ((rate, is_positive, one), (other_rate, is_other_positive, other)) =
        (read(one)?, read(other)?);
    if rate != other_rate || is_positive == is_other_positive {
        return None;
    }
    let (forth, back) = if is_positive {
        (one, other)
    } else {
        (other, one)
    };
    let is_forth = Kind::Compare(vec![rate, Expr::number(0)], vec![Relation::Greater]);
    let is_forth = Expr::derived(is_forth);
    let either = |forth: Expr, back: Expr| {
        if forth == back {
            return forth;
        }
        Expr::derived(Kind::If(is_forth.clone(), forth, back))
    };
    let has_one_left = forth.left == back.left;
    let equation = Equation {
        left: either(forth.left, back.left),
        right: either(forth.right, back.right),
    };
    // One of the two may be divided by the mass.
    let fits = has_one_left || equation.check(&setup.meaning).is_ok();
    fits.then_some(equation)
}

/// The rate that a condition compares with zero, and whether it is to be positive.
fn direction(setup: &Setup, condition: Passage<'_>) -> Option<(Expr, bool)> {
    let Chain { sides, relations } = chain_alone(setup, condition)?;
    let ([left, right], [relation]) = (&sides[..], &relations[..]) else {
        return None;
    };
    let is_greater = match relation {
        Relation::Greater | Relation::GreaterOrEqual => true,
        Relation::Less | Relation::LessOrEqual => false,
        Relation::Equal | Relation::NotEqual => return None,
    };
    // `0 < x'`
    let (rate, zero, is_positive) = if left.is_zero() {
        (right, left, !is_greater)
    } else {
        (left, right, is_greater)
    };
    let is_rate = matches!(rate.kind(), Kind::Prime(of, 1)
        if matches!(of.kind(), Kind::Name(name) if setup.unknowns.contains(name)));
    (is_rate && zero.is_zero()).then(|| (rate.clone(), is_positive))
}

/// The only chain of a response, with the letters of the field for rates.
fn chain_alone(setup: &Setup, response: Passage<'_>) -> Option<Chain> {
    let lexicon = &setup.lexicon;
    let chain = match response.defined_chains(lexicon, Manner::REAL, Defining::Statements) {
        Some(chains) => {
            let [chain] = <[Typed<Chain>; 1]>::try_from(chains.ok()?).ok()?;
            chain
        }
        None => response.chain(lexicon, Manner::REAL).ok()?,
    };
    Some(fitting(setup, chain))
}

/// The reading of a chain that has the dimensions of equations, if one has.
fn fitting(setup: &Setup, chain: Typed<Chain>) -> Chain {
    chain.fitting(|chain| {
        let equations = of_chain(chain).unwrap_or_default();
        let mut equations = equations.iter();
        equations.all(|equation| equation.check(&setup.meaning).is_ok())
    })
}

/// The equations of a response with a letter for another one that it is alike, `L` for the length ℓ where the item has
/// another L.
pub(crate) fn with(
    custom: [&str; 2],
    setup: &Setup,
    response: Passage<'_>,
) -> Option<Vec<Equation>> {
    let [other, meant] = setup.lexicon.stand_in(custom)?;
    let lexicon = setup.lexicon.with(&other, symbol(other.as_str()));
    let put = Substitution::moving(setup.unknowns.iter().cloned()).with(other, Expr::name(meant));
    let found = alone(setup, &lexicon, response, Manner::REAL)
        .ok()?
        .into_iter();
    let meant = found.map(|own| {
        let [left, right] = [own.left, own.right].map(|side| put.apply(&side).ok());
        Some(Equation {
            left: left?,
            right: right?,
        })
    });
    meant.collect()
}

fn alone(
    setup: &Setup,
    lexicon: &Lexicon,
    response: Passage<'_>,
    manner: Manner,
) -> Result<Vec<Equation>, Unreadable> {
    let mut found = Vec::new();
    for own in response.equations() {
        if let Some(why) = beside_the_point(own) {
            return Err(why);
        }
        let chain = own.chain(lexicon, manner);
        let chain = chain.map_err(|error| match error.trouble {
            Trouble::NoRelation => Why::NoEquation.into(),
            _ => Unreadable::typed(&error, own),
        })?;
        for equation in of_chain(&fitting(setup, chain))? {
            found.push(without_unit_of_zero(setup, equation, own)?);
        }
    }
    Ok(found)
}

/// An equation without the unit after its zero, which has to be that of the other side.
fn without_unit_of_zero(
    setup: &Setup,
    equation: Equation,
    typed: Passage<'_>,
) -> Result<Equation, Unreadable> {
    let Equation { left, right } = &equation;
    let found = [(left, right), (right, left)]
        .into_iter()
        .find_map(|(zero, other)| Some((zero, unit_of_zero(zero)?, other)));
    let Some((zero, unit, other)) = found else {
        return Ok(equation);
    };
    let measured = Equation {
        left: other.clone(),
        right: unit.clone(),
    };
    if measured.check(&setup.meaning).is_err() {
        return Err(Unreadable::at(typed.part(zero.span()), Why::UnitOfZero));
    }
    Ok(Equation {
        left: other.clone(),
        right: Expr::number(0),
    })
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
    let equations = chain.sides.windows(2).map(|sides| Equation {
        left: sides[0].clone(),
        right: sides[1].clone(),
    });
    Ok(equations.collect())
}

/// What is said about a number of an equation, which could be a factor, and about the state at the start.
fn beside_the_point(equation: Passage<'_>) -> Option<Unreadable> {
    if let Some(number) = equation.number_of_equation() {
        return Some(Unreadable::at(number, Why::EquationNumber));
    }
    equation
        .is_initial_state()
        .then(|| Unreadable::at(equation, Why::InitialState))
}
