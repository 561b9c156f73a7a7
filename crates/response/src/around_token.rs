//! What stands before and after a place among tokens, where that says how the token there is meant.

use super::token::{Item, Token, is_time};
use vibank_formula::expr::{Constant, Expr, Kind};

fn before(tokens: &[Token], at: usize, places: usize) -> Option<&Token> {
    tokens.get(at.checked_sub(places)?)
}

/// Whether a token comes right after a constant.
pub(crate) fn is_after_constant(tokens: &[Token], at: usize, constant: Constant) -> bool {
    before(tokens, at, 1).is_some_and(
        |token| matches!(&token.item, Item::Leaf(leaf) if *leaf.kind() == Kind::Constant(constant)),
    )
}

/// Whether a factor after a unit has none, as in `3 m * 4`: the unit stands last.
pub(crate) fn is_bare_behind_unit(tokens: &[Token], at: usize) -> bool {
    let is_number = |token: &Token| matches!(token.item, Item::Number(_));
    let is_unit = |token: &Token| matches!(token.item, Item::Unit(_));
    tokens.get(at).is_some_and(is_number)
        && !tokens.get(at + 1).is_some_and(is_unit)
        && before(tokens, at, 2).is_some_and(is_unit)
}

/// Whether it is not clear of a bracket whether it is a factor or another value: after a unit, a number alone after
/// another, arithmetic after a space.
pub(crate) fn is_doubtful_bracket(tokens: &[Token], at: usize) -> bool {
    let item = |at: usize| tokens.get(at).map(|token| &token.item);
    let (Some(open), Some(before)) = (tokens.get(at), before(tokens, at, 1)) else {
        return false;
    };
    if !matches!(open.item, Item::Sign('(' | '[' | '{')) {
        return false;
    }
    let is_number = matches!(item(at + 1), Some(Item::Number(_)));
    let is_alone = is_number && matches!(item(at + 2), Some(Item::Sign(')' | ']' | '}')));
    let is_arithmetic = is_number || matches!(item(at + 1), Some(Item::Sign('+' | '-')));
    match before.item {
        Item::Unit(_) => true,
        Item::Number(_) => is_alone || is_arithmetic && open.is_spaced,
        _ => false,
    }
}

/// Whether a number goes on as a fraction that is not whole: after it a slash and a number, without a space.
pub(crate) fn begins_fraction(tokens: &[Token], at: usize, above: &Expr) -> bool {
    let Some([slash, below]) = tokens.get(at..at + 2) else {
        return false;
    };
    let (Some(above), Item::Sign('/'), Item::Number(number)) =
        (above.as_number(), &slash.item, &below.item)
    else {
        return false;
    };
    let is_broken = above
        .checked_div(*number)
        .is_some_and(|fraction| !fraction.is_integer());
    is_broken && !slash.is_spaced && !below.is_spaced
}

/// How many tokens after a name or π only call it: `x(t)` and `x[t]` are `x`, and `PI()` of spreadsheets is π.
pub(crate) fn length_of_call(tokens: &[Token], at: usize, leaf: &Expr) -> usize {
    let is_called = match leaf.kind() {
        Kind::Constant(Constant::Pi) => {
            let call = tokens.get(at..at + 2);
            let is_empty = matches!(
                call,
                Some([open, close])
                    if (&open.item, &close.item) == (&Item::Sign('('), &Item::Sign(')'))
            );
            return if is_empty { 2 } else { 0 };
        }
        Kind::Name(name) => name.as_str() != "t",
        Kind::Prime(..) => true,
        _ => false,
    };
    let Some([open, time, close]) = tokens.get(at..at + 3).filter(|_| is_called) else {
        return 0;
    };
    let are_brackets = matches!(
        (&open.item, &close.item),
        (Item::Sign('('), Item::Sign(')')) | (Item::Sign('['), Item::Sign(']'))
    );
    if are_brackets && is_time(time) && !open.is_spaced {
        3
    } else {
        0
    }
}
