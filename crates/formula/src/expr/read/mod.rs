//! Reading formulas, equations and intervals.
//!
//! Length, number of nodes and nesting are bounded, the last also where brackets make no nodes.

mod call;
mod error;
mod parser;
mod slip;
mod token;

pub use error::ReadError;

use self::parser::{Parser, Strength};
use super::{Equation, Expr, Interval};

pub(crate) fn formula(text: &str) -> Result<Expr, ReadError> {
    let mut reader = Parser::new(text)?;
    let formula = reader.formula()?;
    reader.end()?;
    Ok(formula)
}

pub(crate) fn equation(text: &str) -> Result<Equation, ReadError> {
    let mut reader = Parser::new(text)?;
    let left = reader.expression(Strength::Sum)?;
    reader.expect("=", "`=` and the other side of the equation")?;
    let right = reader.expression(Strength::Sum)?;
    reader.end()?;
    Ok(Equation { left, right })
}

pub(crate) fn interval(text: &str) -> Result<Interval, ReadError> {
    let mut reader = Parser::new(text)?;
    let open_from = reader.bracket("[", "(", "`[` or `(`, the beginning of an interval")?;
    let from = reader.expression(Strength::Sum)?;
    reader.expect(",", "`,` and the upper end")?;
    let to = reader.expression(Strength::Sum)?;
    let open_to = reader.bracket("]", ")", "`]` or `)`, the end of the interval")?;
    reader.end()?;
    Ok(Interval {
        from,
        to,
        open: [open_from, open_to],
    })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::expr::{Kind, Operator};
    use vibank_source::diagnostic::Diagnose;

    /// The formula with all its brackets.
    fn bracketed(expr: &Expr) -> String {
        match expr.kind() {
            Kind::Binary(operator, a, b) => {
                let sign = match operator {
                    Operator::Add => "+",
                    Operator::Subtract => "-",
                    Operator::Multiply => "*",
                    Operator::Divide => "/",
                    Operator::Power => "^",
                };
                format!("({}{sign}{})", bracketed(a), bracketed(b))
            }
            Kind::Negate(a) => format!("(-{})", bracketed(a)),
            Kind::Not(a) => format!("(not {})", bracketed(a)),
            Kind::And(a, b) => format!("({} and {})", bracketed(a), bracketed(b)),
            Kind::Or(a, b) => format!("({} or {})", bracketed(a), bracketed(b)),
            Kind::Compare(all, _) => {
                format!(
                    "({})",
                    all.iter().map(bracketed).collect::<Vec<_>>().join("<")
                )
            }
            Kind::Prime(a, order) => format!("({}{})", bracketed(a), "'".repeat((*order).into())),
            Kind::Index(a, indices) => {
                let indices: Vec<_> = indices.iter().map(bracketed).collect();
                format!("({}[{}])", bracketed(a), indices.join(","))
            }
            Kind::Number(value) => value.to_string(),
            Kind::Name(name) => name.to_string(),
            other => format!("{other:?}"),
        }
    }

    #[test]
    fn operators_bind_as_on_paper() {
        for (text, expected) in [
            ("-x^2", "(-(x^2))"),
            ("2^3^2", "(2^(3^2))"),
            ("2^-1", "(2^(-1))"),
            ("2^-x^2*3", "((2^(-(x^2)))*3)"),
            ("a - b - c", "((a-b)-c)"),
            ("a/b*c", "((a/b)*c)"),
            ("-a*b", "((-a)*b)"),
            ("a*-b^2", "(a*(-(b^2)))"),
            ("+a--b", "(a-(-b))"),
            ("x'^2", "((x')^2)"),
            ("x''/2", "((x'')/2)"),
            ("u[1]'", "((u[1])')"),
            ("M[1, 2]^2", "((M[1,2])^2)"),
            ("not a < b and c or d", "(((not (a<b)) and c) or d)"),
            ("a < b <= c", "(a<b<c)"),
            ("a + b < c*d", "((a+b)<(c*d))"),
            ("(a + b)*c", "((a+b)*c)"),
        ] {
            assert_eq!(bracketed(&Expr::read(text).unwrap()), expected, "{text}");
        }
    }

    #[test]
    fn every_node_knows_its_place() {
        let text = "(a + b)*sin(2*x')";
        let expr = Expr::read(text).unwrap();
        let mut places = Vec::new();
        expr.walk(&mut |node| places.push(&text[node.span().range()]));
        assert_eq!(
            places,
            [text, "a + b", "a", "b", "sin(2*x')", "2*x'", "2", "x'", "x"]
        );
    }

    #[test]
    fn slips_are_named_with_a_way_out() {
        for (text, message, help) in [
            ("2k", "no operator between `2` and `k`", "write `2*k`"),
            ("2 k", "no operator between `2` and `k`", "write `2*k`"),
            ("(a)(b)", "no operator between `)` and `(`", "write `)*(`"),
            ("a**2", "`**` is not an operator", "write `^` for a power"),
            (
                "if a = 2 then 1 else 0",
                "`=` does not compare",
                "write `==` to compare",
            ),
            ("0,5*m", "`0,5` is not a number", "write `0.5`"),
            (
                ".5",
                "a decimal point needs digits on both sides",
                "write `0.5` or `5`",
            ),
            (
                "5.",
                "a decimal point needs digits on both sides",
                "write `0.5` or `5`",
            ),
            ("sen(x)", "there is no function `sen`", "write `sin`"),
            (
                "k(x + 1)",
                "there is no function `k`",
                "write `k*(` if a product is meant",
            ),
            (
                "0.1 [m]",
                "the unit of a number stands right after it",
                "remove the space before the bracket",
            ),
            (
                "0.1[m",
                "the bracket of this unit is not closed",
                "close the unit with `]`",
            ),
            ("0.1[newtn]", "`newtn` is not a known unit", "write `N`"),
            (
                "sin",
                "`sin` is a word of the language, not a name",
                "choose another name than `sin`",
            ),
        ] {
            let error = Expr::read(text).unwrap_err();
            assert_eq!(error.to_string(), message, "{text}");
            assert_eq!(error.help().as_deref(), Some(help), "{text}");
        }
    }

    #[test]
    fn what_does_not_fit_is_named_with_what_would() {
        for (text, message) in [
            ("", "expected a number, a name or `(`, found the end"),
            ("a +", "expected a number, a name or `(`, found the end"),
            ("(a", "expected an operator or `)`, found the end"),
            ("a)", "expected an operator or the end, found `)`"),
            ("[1, 2", "expected an operator, `,` or `]`, found the end"),
            (
                "1 + if a then b else c",
                "expected an operand (a case inside a formula needs parentheses), found `if`",
            ),
            ("sin(1, 2)", "`sin` takes 1 argument, not 2"),
            ("clamp(1)", "`clamp` takes 3 arguments, not 1"),
            ("diff(x)", "`diff` takes 2 to 9 arguments, not 1"),
            ("diff(x, 2)", "`diff` needs the name of a variable here"),
            ("at(x, 2)", "`at` takes values as `name = value`"),
            ("sin(x = 2)", "only `at` takes arguments with a name"),
            (
                "1e400",
                "`1e400` has too many digits or too large an exponent",
            ),
            ("x'''''''''", "more than 8 primes"),
            ("model", "expected `.` and a name, found the end"),
            ("models.a", "expected `.` and a name, found the end"),
        ] {
            assert_eq!(Expr::read(text).unwrap_err().to_string(), message, "{text}");
        }
    }

    #[test]
    fn hostile_nesting_is_refused_without_harm() {
        for unit in [
            "(",
            "[",
            "-",
            "not ",
            "sin(",
            "2^",
            "if a then ",
            "a+(",
            "((",
            "1 < (",
            "at(x, x = ",
        ] {
            let text = unit.repeat(100_000 / unit.len());
            assert!(Expr::read(&text).is_err());
        }
        let error = Expr::read(&"(".repeat(1_000_000)).unwrap_err();
        assert!(matches!(error, ReadError::TooLong { .. }));
        let long = vec!["a"; 20_000].join("+");
        assert!(matches!(Expr::read(&long), Err(ReadError::TooDeep { .. })));
        let wide = format!("[{}]", vec!["1"; 20_000].join(","));
        assert!(matches!(Expr::read(&wide), Err(ReadError::TooLarge { .. })));
        let primed = format!("x{}", "'".repeat(90_000));
        assert!(Expr::read(&primed).is_err());
        let fits = format!("{}x{}", "(".repeat(190), ")".repeat(190));
        assert!(Expr::read(&fits).is_ok());
    }

    #[test]
    fn equations_and_intervals_have_their_own_grammar() {
        let equation = Equation::read("m*x'' + k*x = -mu*m*g*sign(x')").unwrap();
        assert_eq!(bracketed(&equation.left), "((m*(x''))+(k*x))");
        assert!(Equation::read("a == b").is_err());
        assert!(Equation::read("a = b = c").is_err());
        let interval = Interval::read("(-inf, mu_min]").unwrap();
        assert_eq!(interval.open, [true, false]);
        let interval = Interval::read("[x_eq - d, (a)*b)").unwrap();
        assert_eq!(interval.open, [false, true]);
        assert!(Interval::read("1, 2").is_err());
        assert!(Interval::read("[1, 2").is_err());
    }

    proptest! {
        #[test]
        fn no_text_does_harm(text in ".{0,200}") {
            let _ = (Expr::read(&text), Equation::read(&text), Interval::read(&text));
        }

        #[test]
        fn no_words_do_harm(words in prop::collection::vec(
            prop::sample::select(vec![
                "a", "x'", "2", "0.5", "[", "]", "(", ")", ",", "=", "==", "<", "+", "-", "*", "/", "^", "if ",
                " then ", " else ", "and ", "not ", "sin(", "at(", "diff(", "root(", "model", ".", "'", " ", "[m]", "i",
            ]),
            0..60,
        )) {
            let text = words.concat();
            if let Ok(expr) = Expr::read(&text) {
                prop_assert!(expr.span().end as usize <= text.len());
                prop_assert_eq!(Expr::read(&expr.to_string()).unwrap(), expr);
            }
        }
    }
}
