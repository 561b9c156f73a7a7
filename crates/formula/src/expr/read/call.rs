//! Functions and operators with their arguments.

use super::ReadError;
use super::parser::{MAX_PRIMES, Parser, WORDS};
use super::slip::unknown_function;
use super::token::{Token, TokenKind};
use crate::expr::{Expr, Function, Kind, Name};
use vibank_source::Span;

/// An argument of a call.
struct Argument {
    name: Option<Name>,
    value: Expr,
    span: Span,
}

/// A function or operator, whose name was just read, with its arguments.
pub(crate) fn call(parser: &mut Parser<'_>, callee: &Token<'_>) -> Result<Kind, ReadError> {
    let function = Function::of_name(callee.text);
    if function.is_none() && !matches!(callee.text, "at" | "diff" | "root" | "integral") {
        return Err(unknown_function(callee));
    }
    parser.expect("(", "`(`")?;
    let arguments = arguments(parser)?;
    let span = parser.since(callee.span);
    match (function, callee.text) {
        (Some(function), _) => {
            let (least, most) = function.arity();
            count(function.name(), &arguments, least, most, span)?;
            Ok(Kind::Call(function, unnamed(arguments)?))
        }
        (None, "at") => at(arguments, span),
        (None, "diff") => diff(arguments, span),
        (None, "root") => {
            let [f, x, low, high] = bounded("root", arguments, span)?;
            Ok(Kind::Root(f, name_of("root", &x)?, low, high))
        }
        (None, _) => {
            let [f, x, low, high] = bounded("integral", arguments, span)?;
            Ok(Kind::Integral(f, name_of("integral", &x)?, low, high))
        }
    }
}

/// The arguments up to the closing bracket.
fn arguments(parser: &mut Parser<'_>) -> Result<Vec<Argument>, ReadError> {
    let mut arguments = Vec::new();
    if parser.next_is(")") {
        parser.advance();
        return Ok(arguments);
    }
    loop {
        arguments.push(argument(parser)?);
        if parser.next_is(",") {
            parser.advance();
            continue;
        }
        parser.expect(")", "an operator, `,` or `)`")?;
        return Ok(arguments);
    }
}

fn argument(parser: &mut Parser<'_>) -> Result<Argument, ReadError> {
    let first = *parser.peek();
    let is_named = first.kind == TokenKind::Word && parser.tokens[parser.at + 1].is("=");
    let name = is_named.then(|| Name::from(first.text));
    if is_named {
        if Function::of_name(first.text).is_some() || WORDS.contains(&first.text) {
            return Err(ReadError::Reserved {
                name: first.text.to_owned(),
                span: first.span,
            });
        }
        parser.advance();
        parser.advance();
    }
    let value = parser.formula()?;
    Ok(Argument {
        name,
        value,
        span: parser.since(first.span),
    })
}

fn count(
    function: &'static str,
    arguments: &[Argument],
    least: usize,
    most: usize,
    span: Span,
) -> Result<(), ReadError> {
    if (least..=most).contains(&arguments.len()) {
        return Ok(());
    }
    Err(ReadError::ArgumentCount {
        function,
        found: arguments.len(),
        least,
        most,
        span,
    })
}

/// The values of arguments that may bear no name.
fn unnamed(arguments: Vec<Argument>) -> Result<Vec<Expr>, ReadError> {
    arguments
        .into_iter()
        .map(|argument| match argument.name {
            None => Ok(argument.value),
            Some(_) => Err(ReadError::NamedArgument {
                due: false,
                span: argument.span,
            }),
        })
        .collect()
}

/// `at(f, x = a, …)`.
fn at(arguments: Vec<Argument>, span: Span) -> Result<Kind, ReadError> {
    count("at", &arguments, 2, usize::MAX, span)?;
    let mut arguments = arguments.into_iter();
    let body = unnamed(arguments.by_ref().take(1).collect())?.remove(0);
    Ok(Kind::At(
        body,
        arguments
            .map(|argument| match argument.name {
                Some(name) => Ok((name, argument.value)),
                None => Err(ReadError::NamedArgument {
                    due: true,
                    span: argument.span,
                }),
            })
            .collect::<Result<_, _>>()?,
    ))
}

/// `diff(f, x, …)`.
fn diff(arguments: Vec<Argument>, span: Span) -> Result<Kind, ReadError> {
    count("diff", &arguments, 2, 1 + usize::from(MAX_PRIMES), span)?;
    let values = unnamed(arguments)?;
    let names = values[1..].iter().map(|value| name_of("diff", value));
    Ok(Kind::Diff(
        values[0].clone(),
        names.collect::<Result<_, _>>()?,
    ))
}

/// The four arguments of `root` and `integral`.
fn bounded(
    operator: &'static str,
    arguments: Vec<Argument>,
    span: Span,
) -> Result<[Expr; 4], ReadError> {
    count(operator, &arguments, 4, 4, span)?;
    Ok(unnamed(arguments)?
        .try_into()
        .expect("their number was just checked"))
}

/// The name that an argument is.
fn name_of(operator: &'static str, argument: &Expr) -> Result<Name, ReadError> {
    match argument.kind() {
        Kind::Name(name) => Ok(name.clone()),
        _ => Err(ReadError::NameDue {
            operator,
            span: argument.span(),
        }),
    }
}
