//! Functions and operators.

use super::{Hold, Math, SetPiece, Setter, separated};
use crate::expr::{Expr, Function, Kind, Name, Operator};
use vibank_notation::Class;

/// Exponentials of arguments up to this many nodes are set as powers of e.
const MAX_EXPONENT: u32 = 16;

/// Numerators and denominators of exponents have up to this many nodes, as in −t/(2τ): a fraction in an exponent is set
/// at half of the size of the letters around it.
const MAX_SHARE: u32 = 4;

pub(crate) fn call(setter: &Setter<'_>, function: Function, arguments: &[Expr]) -> SetPiece {
    let one = arguments.first();
    match (function, one) {
        (Function::Sqrt, Some(u)) => SetPiece::atom(Math::root(setter.math(u))),
        (Function::Exp, Some(u)) if u.size() <= MAX_EXPONENT && !is_tiny_as_exponent(u) => {
            SetPiece::new(Math::upright("e").with_sup(setter.math(u)), Hold::Power)
        }
        (Function::Abs, Some(u)) => SetPiece::atom(setter.math(u).fenced("|", "|")),
        (Function::Norm, Some(u)) => SetPiece::atom(setter.math(u).fenced("‖", "‖")),
        (Function::Floor, Some(u)) => SetPiece::atom(setter.math(u).fenced("⌊", "⌋")),
        (Function::Ceil, Some(u)) => SetPiece::atom(setter.math(u).fenced("⌈", "⌉")),
        (Function::Conj, Some(u)) => {
            let conjugate = setter.math(u).with_accent(vibank_notation::Accent::Bar);
            SetPiece::atom(conjugate)
        }
        (Function::Transpose, Some(u)) => {
            let base = setter.piece(u).at_least(Hold::Atom);
            SetPiece::new(base.with_sup(Math::upright("T")), Hold::Power)
        }
        (Function::Hypot, _) => {
            let squares = arguments.iter().cloned().map(Expr::squared);
            let sum = squares.reduce(|sum, square| sum + square);
            SetPiece::atom(Math::root(
                sum.map_or(Math::row([]), |sum| setter.math(&sum)),
            ))
        }
        (Function::EllipticKm1, Some(p)) => {
            let parameter = Expr::number(1) - p.clone();
            call(setter, Function::EllipticK, &[parameter])
        }
        (Function::Dot, Some(_)) => between(setter, "⋅", arguments),
        (Function::Mod, Some(_)) => between(setter, "mod", arguments),
        _ => applied(setter, written_name(function), arguments),
    }
}

/// A sign or word between operands.
fn between(setter: &Setter<'_>, sign: &str, operands: &[Expr]) -> SetPiece {
    let operands = operands
        .iter()
        .map(|operand| setter.piece(operand).at_least(Hold::Fraction));
    let sign = Math::binary(sign);
    SetPiece::new(separated(operands, Some(&sign)), Hold::Product)
}

/// A named function before its arguments; one that is a single symbol stands bare.
pub(crate) fn applied(setter: &Setter<'_>, name: &str, arguments: &[Expr]) -> SetPiece {
    let function = function_name(name);
    named(setter, function, arguments)
}

fn named(setter: &Setter<'_>, function: Math, arguments: &[Expr]) -> SetPiece {
    let argument = match arguments {
        [only] if is_symbol(only) => setter.piece(only).at_least(Hold::Atom),
        _ => in_parentheses(setter, arguments),
    };
    SetPiece::new(Math::row([function, argument]), Hold::Fraction)
}

fn in_parentheses(setter: &Setter<'_>, arguments: &[Expr]) -> Math {
    let arguments = arguments.iter().map(|argument| setter.math(argument));
    separated(arguments, Some(&Math::punctuation(","))).fenced("(", ")")
}

/// A function that is followed by another factor has its argument in parentheses.
pub(crate) fn call_before_factor(setter: &Setter<'_>, expr: &Expr) -> Math {
    match expr.kind() {
        Kind::Call(function, arguments) if is_bare(*function, arguments) => {
            let name = function_name(written_name(*function));
            Math::row([name, in_parentheses(setter, arguments)])
        }
        Kind::Binary(Operator::Power, base, exponent) => match base.kind() {
            Kind::Call(function, arguments) if has_powers(*function) => {
                match power_of_name(exponent) {
                    Some(power) => {
                        let name = function_name(written_name(*function));
                        Math::row([name.with_sup(power), in_parentheses(setter, arguments)])
                    }
                    None => setter.math(expr),
                }
            }
            _ => setter.math(expr),
        },
        _ => setter.piece(expr).at_least(Hold::Fraction),
    }
}

/// sin²x for sin(x)^2.
pub(crate) fn power_of_call(setter: &Setter<'_>, base: &Expr, exponent: &Expr) -> Option<SetPiece> {
    let Kind::Call(function, arguments) = base.kind() else {
        return None;
    };
    let power = power_of_name(exponent).filter(|_| has_powers(*function))?;
    let name = function_name(written_name(*function)).with_sup(power);
    Some(named(setter, name, arguments))
}

/// f with a bar and the values of its names below it.
pub(crate) fn at(setter: &Setter<'_>, inner: &Expr, values: &[(Name, Expr)]) -> SetPiece {
    let equations = values.iter().map(|(name, value)| {
        let name = setter.math(&Expr::name(name.clone()));
        Math::row([name, Math::relation("="), setter.math(value)])
    });
    let condition = separated(equations, Some(&Math::punctuation(",")));
    SetPiece::atom(setter.math(inner).fenced("", "|").with_sub(condition))
}

/// ∂²f/∂x∂y.
pub(crate) fn partial_derivative(setter: &Setter<'_>, inner: &Expr, names: &[Name]) -> SetPiece {
    let above = match names.len() {
        1 => Math::operator("∂", Class::Ordinary),
        n => Math::operator("∂", Class::Ordinary).with_sup(Math::number(n.to_string())),
    };
    let mut below = Vec::new();
    for same in names.chunk_by(|a, b| a == b) {
        let name = setter.math(&Expr::name(same[0].clone()));
        below.push(Math::operator("∂", Class::Ordinary));
        below.push(match same.len() {
            1 => name,
            n => name.with_sup(Math::number(n.to_string())),
        });
    }
    let below = Math::row(below);
    let math = if is_symbol(inner) {
        Math::fraction(Math::row([above, setter.math(inner)]), below)
    } else {
        let body = setter.piece(inner).at_least(Hold::Atom);
        Math::row([Math::fraction(above, below), body])
    };
    SetPiece::new(math, Hold::Fraction)
}

pub(crate) fn integral(
    setter: &Setter<'_>,
    inner: &Expr,
    name: &Name,
    from: &Expr,
    to: &Expr,
) -> SetPiece {
    let sign = Math::operator("∫", Class::Large)
        .with_sub(setter.math(from))
        .with_sup(setter.math(to));
    let body = setter.piece(inner).at_least(Hold::Product);
    let variable = setter.math(&Expr::name(name.clone()));
    let row = [sign, body, Math::thin_space(), Math::upright("d"), variable];
    SetPiece::new(Math::row(row), Hold::Sum)
}

fn function_name(name: &str) -> Math {
    match name {
        "log10" => Math::function("log").with_sub(Math::number("10")),
        _ => Math::function(name),
    }
}

/// Whether it is one symbol, which may follow the name of a function without parentheses.
fn is_symbol(expr: &Expr) -> bool {
    match expr.kind() {
        Kind::Name(_) | Kind::Constant(_) => true,
        Kind::Prime(inner, _) => matches!(inner.kind(), Kind::Name(_)),
        _ => false,
    }
}

/// Whether the call is set as a name and a bare argument.
fn is_bare(function: Function, arguments: &[Expr]) -> bool {
    let is_framed = matches!(
        function,
        Function::Sqrt
            | Function::Exp
            | Function::Abs
            | Function::Norm
            | Function::Floor
            | Function::Ceil
            | Function::Conj
            | Function::Transpose
            | Function::Hypot
            | Function::Dot
            | Function::Mod
    );
    !is_framed && matches!(arguments, [only] if is_symbol(only))
}

/// An exponent that may stand at the name of a function.
fn power_of_name(exponent: &Expr) -> Option<Math> {
    let exponent = exponent.as_number()?;
    let is_usual = exponent.is_integer() && (2..10).contains(&exponent.numerator());
    is_usual.then(|| Math::number(exponent.numerator().to_string()))
}

/// Functions whose power is written at the name.
fn has_powers(function: Function) -> bool {
    matches!(
        function,
        Function::Sin
            | Function::Cos
            | Function::Tan
            | Function::Sinh
            | Function::Cosh
            | Function::Tanh
            | Function::Ln
    )
}

/// Whether an exponent would be set too small to be read.
fn is_tiny_as_exponent(expr: &Expr) -> bool {
    let mut found = false;
    expr.walk(&mut |node| {
        found |= matches!(node.kind(), Kind::If(..) | Kind::Array(_))
            || matches!(node.kind(), Kind::Binary(Operator::Divide, a, b) if a.size().max(b.size()) > MAX_SHARE);
    });
    found
}

/// The name as it is printed.
fn written_name(function: Function) -> &'static str {
    match function {
        Function::Asin => "arcsin",
        Function::Acos => "arccos",
        Function::Atan => "arctan",
        Function::Asinh => "arsinh",
        Function::Acosh => "arcosh",
        Function::Atanh => "artanh",
        Function::Sign => "sgn",
        Function::Re => "Re",
        Function::Im => "Im",
        Function::EllipticK => "K",
        other => other.name(),
    }
}
