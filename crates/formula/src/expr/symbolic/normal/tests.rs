//! Tests of the normal form.

use super::*;
use crate::expr::{Function, PlainNotation, differentiate, time_derivative};

fn name(text: &str) -> Expr {
    Expr::name(text)
}

fn number(numerator: i32, denominator: i32) -> Expr {
    Expr::number(numerator) / Expr::number(denominator)
}

fn call(function: Function, argument: Expr) -> Expr {
    Expr::call(function, [argument])
}

fn normal(expr: &Expr) -> Normal {
    Normal::of(expr).unwrap()
}

fn check_equal(left: Expr, right: Expr) {
    assert!(
        normal(&left).is_equal(&normal(&right)).unwrap(),
        "{left} and {right}"
    );
}

fn textbook() -> Order {
    Order::new()
        .moving(["theta", "phi", "x"].map(Name::new))
        .ranked(
            [
                "m", "m1", "m2", "M0", "I", "k", "k1", "k2", "c", "g", "r", "l",
            ]
            .map(Name::new),
        )
}

fn check_written(expr: Expr, expected: &str) {
    assert_eq!(normal(&expr).to_expr(&textbook()).to_string(), expected);
}

/// The left side of Lagrange's equation for one coordinate.
fn lagrange(kinetic: &Expr, potential: &Expr, dissipation: &Expr) -> Expr {
    let (q, moving) = (Name::new("theta"), SortedSet::from([Name::new("theta")]));
    let momentum = differentiate(kinetic, Variable::of(&q, 1)).unwrap();
    time_derivative(&momentum, &moving).unwrap() - differentiate(kinetic, &q).unwrap()
        + differentiate(potential, &q).unwrap()
        + differentiate(dissipation, Variable::of(&q, 1)).unwrap()
}

#[test]
fn an_equation_of_motion_is_written_as_in_a_textbook() {
    let (m, l, theta) = (|| name("m"), || name("l"), || name("theta"));
    let omega = || theta().prime(1);
    let kinetic = number(1, 2) * (m() * l().squared() / Expr::number(3)) * omega().squared()
        + number(1, 2) * (Expr::number(2) * m()) * (l() * omega() / Expr::number(2)).squared();
    let potential = number(1, 2) * name("k") * (l() * theta() / Expr::number(2)).squared()
        + number(1, 2) * name("k") * (l() * theta()).squared();
    let dissipation = number(1, 2) * name("c") * (l() * omega() / Expr::number(2)).squared();
    let equation = normal(&lagrange(&kinetic, &potential, &dissipation));
    let written = equation.to_expr(&textbook());
    assert_eq!(
        written.to_string(),
        "5/6*m*l^2*theta'' + 1/4*c*l^2*theta' + 5/4*k*l^2*theta"
    );
    assert_eq!(
        written.typeset(&PlainNotation).latex(),
        r"\frac{5}{6}ml^2\ddot{\theta} + \frac{1}{4}cl^2\dot{\theta} + \frac{5}{4}kl^2\theta"
    );
    let kept = ["theta"].map(Name::new).into();
    let (factor, rest) = equation.without_common_factor(&kept).unwrap();
    assert_eq!(factor.to_expr(&textbook()).to_string(), "1/12*l^2");
    assert_eq!(
        rest.to_expr(&textbook()).to_string(),
        "10*m*theta'' + 3*c*theta' + 15*k*theta"
    );
}

#[test]
fn coefficients_are_collected() {
    let x = || name("x");
    check_written(
        name("k2") * x() + name("k1") * x() + name("m") * x().prime(2),
        "m*x'' + (k1 + k2)*x",
    );
    check_written(
        Expr::number(2) * name("k2") * x() + Expr::number(2) * name("k1") * x(),
        "2*(k1 + k2)*x",
    );
    check_written(
        name("k1") * name("k2") / (name("k1") + name("k2")) * x(),
        "k1*k2/(k1 + k2)*x",
    );
    check_written(
        (name("m") * name("g") * name("l") - name("k") * name("l").squared()) * x(),
        "(m*g*l - k*l^2)*x",
    );
    check_written(-(name("k") * x()) + name("m") * name("g"), "-k*x + m*g");
    check_written(
        -(name("M0") / (Expr::number(2) * name("r"))
            * call(Function::Sin, name("Omega") * name("t"))),
        "-M0/(2*r)*sin(Omega*t)",
    );
    check_written(
        name("I") / name("r").squared() * x().prime(2) + name("m") * x().prime(2),
        "(m + I/r^2)*x''",
    );
}

#[test]
fn numbers_join_their_units() {
    let read = |text: &str| Expr::read(text).unwrap();
    check_written(
        read("l^2*1[kg]*2*x'' + 3[kg]*x''/4"),
        "(0.75[kg] + 2[kg]*l^2)*x''",
    );
    check_written(read("m*g - m*9.81[m/s^2]/3"), "m*g - 3.27[m/s^2]*m");
}

#[test]
fn numbers_under_roots_are_taken_apart() {
    let root = |value: i32| call(Function::Sqrt, Expr::number(value));
    check_written(root(12), "2*sqrt(3)");
    check_written(root(2) * root(3) - root(6), "0");
    check_written(Expr::number(1) / root(2), "1/2*sqrt(2)");
    check_written(call(Function::Sqrt, number(9, 4)), "3/2");
    check_written(call(Function::Sqrt, name("x").squared()), "sqrt(x^2)");
}

#[test]
fn common_denominators_cancel() {
    let sum = || name("k1") + name("k2");
    check_written(
        name("k1") * name("k1") / sum() + name("k1") * name("k2") / sum(),
        "k1",
    );
    check_written(sum().squared() / sum(), "k1 + k2");
    check_equal(
        Expr::number(1) / (Expr::number(1) / name("k1") + Expr::number(1) / name("k2")),
        name("k1") * name("k2") / sum(),
    );
    check_equal(
        Expr::number(1) / (name("a") - name("b")) + Expr::number(1) / (name("b") - name("a")),
        Expr::number(0),
    );
    check_equal(
        name("a") / sum() + name("b") / (name("c") + name("d")),
        (name("a") * (name("c") + name("d")) + name("b") * sum())
            / (sum() * (name("c") + name("d"))),
    );
}

#[test]
fn sines_and_cosines_combine() {
    let (theta, phi) = (|| name("theta"), || name("phi"));
    let sine = |expr| call(Function::Sin, expr);
    let cosine = |expr| call(Function::Cos, expr);
    check_written(
        name("m") * sine(theta()).squared() + name("m") * cosine(theta()).squared(),
        "m",
    );
    check_written(
        cosine(theta()) * cosine(phi()) + sine(theta()) * sine(phi()),
        "cos(theta - phi)",
    );
    check_written(
        sine(theta()) * cosine(phi()) - cosine(theta()) * sine(phi()),
        "-sin(phi - theta)",
    );
    check_written(sine(-theta()), "-sin(theta)");
    let pi = || Expr::constant(crate::expr::Constant::Pi);
    check_written(cosine(theta() + pi()), "-cos(theta)");
    check_written(sine(pi() / Expr::number(6)), "1/2");
    check_equal(
        Expr::number(1) - cosine(theta()),
        Expr::number(2) * sine(theta() / Expr::number(2)).squared(),
    );
    check_equal(
        cosine(theta() - phi()),
        cosine(theta()) * cosine(phi()) + sine(theta()) * sine(phi()),
    );
    check_equal(
        sine(Expr::number(3) * theta()),
        Expr::number(3) * sine(theta()) - Expr::number(4) * sine(theta()).power(Expr::number(3)),
    );
}

#[test]
fn different_formulas_are_not_equal() {
    let pairs = [
        (name("a"), name("b")),
        (name("x"), name("x").prime(1)),
        (call(Function::Sqrt, name("x").squared()), name("x")),
        (
            call(Function::Sin, name("x")),
            call(Function::Cos, name("x")),
        ),
    ];
    for (left, right) in pairs {
        assert!(!normal(&left).is_equal(&normal(&right)).unwrap());
    }
}

#[test]
fn what_has_no_normal_form_is_refused() {
    let sum = (0..12).fold(Expr::number(1), |sum, index| {
        sum + name(&format!("a{index}"))
    });
    assert_eq!(
        Normal::of(&sum.power(Expr::number(40))),
        Err(SymbolicError::TooLarge)
    );
    let zero = name("a") - name("a");
    assert_eq!(
        Normal::of(&(Expr::number(1) / zero)),
        Err(SymbolicError::Undefined)
    );
}

#[test]
fn derivatives_term_by_term_are_those_of_the_formula() {
    let moving = SortedSet::from(["x", "phi"].map(Name::new));
    for text in [
        "1/2*m*x'^2 + 1/2*(I/r^2)*x'^2 - m*g*x + x^-2 + a",
        "m*l*x'*phi'*cos(phi - x) + 1/2*m*l^2*phi'^2",
        "k*x^2/(a + b) + x/(x + l) + sqrt(x^2 + h^2)",
        "F*sin(Omega*t)*x + t^2*x' + e^(c*x) + max(x, a)*phi",
        "x''*phi^3*x + 7",
    ] {
        let expr = Expr::read(text).unwrap();
        let sum = normal(&expr);
        for name in &moving {
            for variable in (0..=2).map(|order| Variable::of(name, order)) {
                let by_formula = normal(&differentiate(&expr, variable.clone()).unwrap());
                let by_terms = sum.derivative(&variable).unwrap();
                assert!(by_terms.is_equal(&by_formula).unwrap(), "{text}");
            }
        }
        let by_formula = normal(&time_derivative(&expr, &moving).unwrap());
        let by_terms = sum.time_derivative(&moving).unwrap();
        assert!(by_terms.is_equal(&by_formula).unwrap(), "{text}");
    }
}

#[test]
fn terms_with_a_variable_that_is_zero_vanish() {
    let at_zero = |text: &str| {
        let sum = normal(&Expr::read(text).unwrap());
        let zero = sum.where_zero(&|own| own.order > 0);
        zero.map(|own| own.to_expr(&Order::new()).to_string())
    };
    assert_eq!(
        at_zero("m*x'' + c*x'*y + k*x - F").as_deref(),
        Some("k*x - F")
    );
    assert_eq!(at_zero("sin(x)*x'^2").as_deref(), Some("0"));
    for hidden in ["sin(x')", "k/x'", "1/(a + x')", "abs(x'')*x"] {
        assert_eq!(at_zero(hidden), None, "{hidden}");
    }
}
