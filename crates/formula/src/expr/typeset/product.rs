//! Products and quotients.

use super::{Hold, Math, SetPiece, Setter, SymbolKind, call};
use crate::expr::{Expr, Kind, Operator};

/// One factor of a product as it is set.
struct Factor {
    math: Math,
    /// Whether it begins with a digit, which must not touch what stands before it.
    begins_with_number: bool,
    /// Whether it needs a dot on both sides.
    is_quantity: bool,
}

/// A product or quotient, with all factors of a chain side by side.
pub(crate) fn product(setter: &Setter<'_>, expr: &Expr) -> SetPiece {
    let mut factors = Vec::new();
    flatten(expr, &mut factors);
    let is_negative = factors.first_mut().is_some_and(take_sign);
    let product = match factors.as_slice() {
        [ProductPart::Quotient(above, below)] => {
            SetPiece::new(fraction(setter, above, below), Hold::Fraction)
        }
        _ => {
            let hold = if begins_with_sign(setter, &factors) {
                Hold::Sign
            } else {
                Hold::Product
            };
            SetPiece::new(side_by_side(setter, &factors), hold)
        }
    };
    if is_negative {
        SetPiece::new(Math::row([Math::prefix("−"), product.math]), Hold::Sign)
    } else {
        product
    }
}

/// Whether a sign stands in front, as where a negative number is substituted for the first factor.
///
/// Only what is set in one step can bear one: setting the factor to see would double the work at each level.
fn begins_with_sign(setter: &Setter<'_>, factors: &[ProductPart]) -> bool {
    let Some(ProductPart::Factor(first)) = factors.first() else {
        return false;
    };
    match first.kind() {
        Kind::Negate(_) => true,
        Kind::Name(name) if setter.notation.name(name).kind == SymbolKind::NegativeQuantity => {
            false
        }
        Kind::Number(_) | Kind::Name(_) | Kind::Path(_) => setter.piece(first).hold == Hold::Sign,
        _ => false,
    }
}

fn fraction(setter: &Setter<'_>, above: &[ProductPart], below: &[ProductPart]) -> Math {
    // A number alone above or below keeps its own size; ½ m x / l is written m x / 2 l.
    let (above, below) = hoisted(above, below);
    Math::fraction(side_by_side(setter, &above), side_by_side(setter, &below))
}

fn side_by_side(setter: &Setter<'_>, parts: &[ProductPart]) -> Math {
    if let [ProductPart::Factor(only)] = parts {
        return setter.math(only);
    }
    let mut row: Vec<Math> = Vec::new();
    let mut is_behind_quantity = false;
    for (position, part) in parts.iter().enumerate() {
        let is_first = position == 0;
        let factor = factor(setter, part, is_first, position + 1 == parts.len());
        let needs_sign = factor.is_quantity || factor.begins_with_number;
        if is_behind_quantity || needs_sign && !is_first {
            row.push(Math::binary("⋅"));
        }
        is_behind_quantity = factor.is_quantity;
        row.push(factor.math);
    }
    Math::row(row)
}

fn factor(setter: &Setter<'_>, part: &ProductPart, is_first: bool, is_last: bool) -> Factor {
    match part {
        ProductPart::Quotient(above, below) => Factor {
            math: fraction(setter, above, below),
            begins_with_number: is_number_fraction(part),
            is_quantity: false,
        },
        ProductPart::Factor(expr) => plain_factor(setter, expr, is_first, is_last),
    }
}

fn plain_factor(setter: &Setter<'_>, expr: &Expr, is_first: bool, is_last: bool) -> Factor {
    let kind = symbol_kind(setter, expr);
    let is_bare_call = !is_last
        && match expr.kind() {
            Kind::Call(..) => true,
            Kind::Binary(Operator::Power, base, _) => matches!(base.kind(), Kind::Call(..)),
            _ => false,
        };
    let math = if is_bare_call {
        call::call_before_factor(setter, expr)
    } else {
        let piece = setter.piece(expr);
        let least = match piece.hold {
            Hold::Sign if is_first && kind != SymbolKind::NegativeQuantity => Hold::Sign,
            Hold::Product if kind == SymbolKind::Quantity => Hold::Product,
            _ => Hold::Fraction,
        };
        piece.at_least(least)
    };
    Factor {
        math,
        begins_with_number: matches!(kind, SymbolKind::Number),
        is_quantity: kind == SymbolKind::Quantity,
    }
}

/// What a factor begins with.
fn symbol_kind(setter: &Setter<'_>, expr: &Expr) -> SymbolKind {
    match expr.kind() {
        Kind::Number(value) if value.is_negative() => SymbolKind::Negative,
        Kind::Number(_) => SymbolKind::Number,
        Kind::Name(name) => setter.notation.name(name).kind,
        Kind::Path(path) => setter.notation.path(path).kind,
        Kind::Binary(Operator::Power, base, _) => match symbol_kind(setter, base) {
            SymbolKind::Number => SymbolKind::Number,
            // The base stands in parentheses.
            _ => SymbolKind::Letter,
        },
        Kind::Negate(_) => SymbolKind::Negative,
        _ => SymbolKind::Letter,
    }
}

/// A factor of a chain of products, or a quotient within it.
#[derive(Clone)]
enum ProductPart {
    Factor(Expr),
    Quotient(Vec<ProductPart>, Vec<ProductPart>),
}

/// The factors of a chain of products and quotients: `a*b/c*d` is the fraction ab/c, then d.
fn flatten(expr: &Expr, parts: &mut Vec<ProductPart>) {
    match expr.kind() {
        Kind::Binary(Operator::Multiply, a, b) => {
            flatten(a, parts);
            flatten(b, parts);
        }
        Kind::Binary(Operator::Divide, a, b) => {
            let (mut above, mut below) = (Vec::new(), Vec::new());
            flatten(a, &mut above);
            flatten(b, &mut below);
            if let [ProductPart::Quotient(_, lower)] = above.as_slice()
                && !is_number_fraction(&above[0])
            {
                below = lower.iter().cloned().chain(below).collect();
                if let Some(ProductPart::Quotient(upper, _)) = above.pop() {
                    above = upper;
                }
            }
            parts.push(ProductPart::Quotient(above, below));
        }
        _ => parts.push(ProductPart::Factor(expr.clone())),
    }
}

/// Takes the sign of the first factor or numerator away, so that it stands before the product: what
/// follows a sign is set as any other factor, `-sign(v)*d` as −sgn(v)d.
fn take_sign(part: &mut ProductPart) -> bool {
    match part {
        ProductPart::Factor(first) => match first.kind() {
            Kind::Negate(inner) => {
                *first = inner.clone();
                true
            }
            _ => false,
        },
        ProductPart::Quotient(above, _) => above.first_mut().is_some_and(take_sign),
    }
}

fn is_number(part: &ProductPart) -> bool {
    matches!(part, ProductPart::Factor(expr) if expr.as_number().is_some())
}

fn is_number_fraction(part: &ProductPart) -> bool {
    match part {
        ProductPart::Factor(_) => false,
        ProductPart::Quotient(above, below) => {
            above.iter().all(is_number) && below.iter().all(is_number)
        }
    }
}

/// A fraction of numbers in front of a numerator goes to the two sides of the bar.
fn hoisted(above: &[ProductPart], below: &[ProductPart]) -> (Vec<ProductPart>, Vec<ProductPart>) {
    let Some((first, rest)) = above.split_first() else {
        return (above.to_vec(), below.to_vec());
    };
    let ProductPart::Quotient(upper, lower) = first else {
        return (above.to_vec(), below.to_vec());
    };
    if rest.is_empty() || !is_number_fraction(first) {
        return (above.to_vec(), below.to_vec());
    }
    let upper = upper
        .iter()
        .filter(|part| !matches!(part, ProductPart::Factor(expr) if expr.is_one()));
    (
        upper.chain(rest).cloned().collect(),
        lower.iter().chain(below).cloned().collect(),
    )
}

#[cfg(test)]
mod tests {
    use crate::expr::{Expr, Function, Name, Notation, Symbol, SymbolKind};
    use vibank_notation::Math;

    /// Substitutes −2 for `n` and −2 m for `v`.
    struct Substituted;

    impl Notation for Substituted {
        fn name(&self, name: &Name) -> Symbol {
            match name.as_str() {
                "n" => Symbol {
                    math: Math::row([Math::prefix("−"), Math::number("2")]),
                    kind: SymbolKind::Negative,
                },
                "v" => Symbol {
                    math: Math::row([
                        Math::prefix("−"),
                        Math::number("2"),
                        Math::thin_space(),
                        Math::upright("m"),
                    ]),
                    kind: SymbolKind::NegativeQuantity,
                },
                other => Symbol::letter(vibank_notation::symbol(other)),
            }
        }
    }

    #[test]
    fn a_function_before_a_factor_keeps_its_parentheses_behind_a_sign() {
        let [u, d] = ["u", "d"].map(Expr::name);
        let sign = Expr::call(Function::Sign, [u]);
        let plain = (-sign * d).typeset(&Substituted).plain();
        assert_eq!(plain.replace('−', "-"), "-sgn(u)d");
    }

    #[test]
    fn a_negative_value_has_parentheses_beside_other_factors_alone() {
        let [v, x] = ["v", "x"].map(Expr::name);
        let two = || Expr::number(2);
        let sign = Expr::call(Function::Sign, [v.clone()]);
        for (formula, expected) in [
            (sign, "sgn(-2 m)"),
            (v.clone() + x.clone(), "-2 m + x"),
            (x.clone() - v.clone(), "x - (-2 m)"),
            (v.clone() / x.clone(), "(-2 m)/x"),
            (v.clone() * x.clone(), "(-2 m)x"),
            (x - v.clone() * two(), "x - 2(-2 m)"),
            (v.squared(), "(-2 m)²"),
        ] {
            let plain = formula.typeset(&Substituted).plain();
            assert_eq!(plain.replace('−', "-"), expected);
        }
    }

    #[test]
    fn two_signs_never_meet() {
        let [n, x, y] = ["n", "x", "y"].map(Expr::name);
        for (formula, expected) in [
            (y.clone() - n.clone() * x.clone(), "y - (-2x)"),
            (n.clone() * x.clone() - y.clone(), "-2x - y"),
            (y.clone() - x.clone() * n.clone(), "y - x(-2)"),
            (y - n / x, "y - (-2)/x"),
        ] {
            let plain = formula.typeset(&Substituted).plain();
            assert_eq!(plain.replace('−', "-"), expected);
        }
    }
}
