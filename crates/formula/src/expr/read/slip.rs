//! The errors for what does not fit; the usual slips have their own.

use super::ReadError;
use super::parser::Parser;
use super::token::{Token, TokenKind};
use crate::expr::Function;
use vibank_source::nearest;

/// The error for the word at hand, which follows an operand; the usual slips have their own.
pub(crate) fn surprise(parser: &Parser<'_>, expected: &'static str) -> ReadError {
    let token = parser.peek();
    let Some(previous) = parser.at.checked_sub(1).map(|at| &parser.tokens[at]) else {
        return unexpected(token, expected);
    };
    let after_number = previous.kind == TokenKind::Number;
    match token.text {
        "=" => ReadError::SingleEquals { span: token.span },
        "**" => ReadError::DoubleStar { span: token.span },
        "." if after_number => ReadError::BarePoint {
            span: previous.span.join(token.span),
        },
        "[" if after_number => ReadError::SpaceBeforeUnit {
            span: previous.span.join(token.span),
        },
        "," if after_number => comma(parser, previous, expected),
        _ if starts_operand(token) && ends_operand(previous) => ReadError::ImplicitProduct {
            left: previous.text.to_owned(),
            right: token.text.to_owned(),
            span: previous.span.join(token.span),
        },
        _ => unexpected(token, expected),
    }
}

/// A comma after a number: a decimal comma if digits follow at once.
fn comma(parser: &Parser<'_>, whole: &Token<'_>, expected: &'static str) -> ReadError {
    let comma = parser.peek();
    let fraction = &parser.tokens[parser.at + 1];
    let touches = whole.span.end == comma.span.start && comma.span.end == fraction.span.start;
    if !touches || fraction.kind != TokenKind::Number {
        return unexpected(comma, expected);
    }
    ReadError::DecimalComma {
        whole: whole.text.to_owned(),
        fraction: fraction.text.to_owned(),
        span: whole.span.join(fraction.span),
    }
}

fn starts_operand(token: &Token<'_>) -> bool {
    match token.kind {
        TokenKind::Number => true,
        TokenKind::Word => !matches!(token.text, "if" | "then" | "else" | "and" | "or" | "not"),
        TokenKind::Sign => token.text == "(",
        TokenKind::Unit | TokenKind::End => false,
    }
}

fn ends_operand(token: &Token<'_>) -> bool {
    starts_operand(token) && token.text != "("
        || matches!(token.text, ")" | "]" | "'")
        || token.kind == TokenKind::Unit
}

pub(crate) fn unexpected(token: &Token<'_>, expected: &'static str) -> ReadError {
    ReadError::Unexpected {
        expected,
        found: token.to_string(),
        span: token.span,
    }
}

pub(crate) fn unknown_function(callee: &Token<'_>) -> ReadError {
    let known = Function::all()
        .map(Function::name)
        .chain(["at", "diff", "root", "integral"]);
    let known: Vec<&'static str> = known.collect();
    let near = nearest(callee.text, known.iter().copied());
    ReadError::UnknownFunction {
        name: callee.text.to_owned(),
        nearest: near.and_then(|near| known.into_iter().find(|name| *name == near)),
        span: callee.span,
    }
}
