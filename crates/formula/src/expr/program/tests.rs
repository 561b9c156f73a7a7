use super::*;
use crate::expr::{Expr, Slots};
use vibank_dynamics::numerics::Rational;

const NAMES: [&str; 4] = ["a", "b", "x", "t"];

fn decimals(data: &[&str]) -> Vec<Precise> {
    let of = |text: &&str| Precise::from(Rational::from_decimal(text).unwrap());
    data.iter().map(of).collect()
}

fn program(formula: &str) -> Program {
    Program::compile(&Expr::read(formula).unwrap(), &Slots(&NAMES)).unwrap()
}

fn value(formula: &str, data: &[&str]) -> Result<Value, Absence> {
    program(formula).evaluate(&decimals(data)[..], &mut Workspace::default())
}

fn real(formula: &str) -> f64 {
    let value = value(formula, &["0.3", "0.1", "-2.5", "1.75"]);
    value
        .unwrap()
        .as_real()
        .unwrap_or_else(|| panic!("{formula}"))
}

fn truth(formula: &str) -> bool {
    let value = value(formula, &["0.3", "0.1", "-2.5", "1.75"]);
    value.unwrap().as_boolean().unwrap()
}

fn absence(formula: &str) -> (Undefined, &str) {
    let absence = value(formula, &["0.3", "0.1", "-2.5", "1.75"]).unwrap_err();
    (absence.reason, &formula[absence.span.range()])
}

fn assert_near(found: f64, expected: f64) {
    assert!(
        (found - expected).abs() <= 4.0 * f64::EPSILON * expected.abs(),
        "{found} {expected}"
    );
}

#[test]
fn ties_in_decimal_data_come_out_as_on_paper() {
    for holds in [
        "0.1 + 0.2 == 0.3",
        "a == 3*b",
        "3*b <= a",
        "a <= 3*b",
        "not 3*b > a",
        "b < 0.2 <= 2*b",
        "a/b == 3",
        "sqrt(a^2) == 3*b",
        "mod(a, b) == 0",
        "sign(a - 3*b) == 0",
        "(1 + 1e-12)*a > 3*b",
        "a*(1 + 1e-25) == a or a*(1 + 1e-25) > a",
        "1 < 2 < 3 and not 1 < 3 < 2",
    ] {
        assert!(truth(holds), "{holds}");
    }
    for (formula, expected) in [
        ("floor(a/b)", 3.0),
        ("floor(0.3/0.1)", 3.0),
        ("ceil(a/b)", 3.0),
        ("ceil(a/b + 1e-9)", 4.0),
        ("floor(a/b - 1e-15)", 2.0),
        ("round(5*b)", 1.0),
        ("round(-5*b)", -1.0),
        ("round(0.49999999999)", 0.0),
        ("mod(x, 1)", 0.5),
        ("a - 3*b", 0.0),
        ("sign(-a)", -1.0),
        ("(-1)^floor(a/b)", -1.0),
        ("x^2", 6.25),
        ("x^(a/b)", -15.625),
        ("abs(x)^0.5", 1.581_138_830_084_189_7),
    ] {
        assert_eq!(real(formula), expected, "{formula}");
    }
}

#[test]
fn cancellation_is_answered_with_more_digits() {
    assert_eq!(real("(1 + 1e-14*b) - 1"), 1e-15);
    assert_eq!(real("(sqrt(1 + 1e-20) - 1)/1e-20"), 0.5);
    assert_eq!(real("(1 - cos(1e-9))/1e-18"), 0.5);
    assert_eq!(real("exp(1e-18) - 1"), 1e-18);
}

/// Values by mpmath with 120 digits: differences that thirty digits lose. Data and constants are still known to thirty
/// digits, which bounds what comes out.
#[test]
fn what_thirty_digits_lose_is_found_with_more() {
    for (formula, expected) in [
        (
            "(1 - (1e-9)^2/2)/cos(1e-9) - 1",
            -4.166_666_666_666_666_4e-38,
        ),
        ("1 - cos(1e-17)", 5e-35),
        ("sin(1e-7)/1e-7 - 1 + (1e-7)^2/6", 8.333_333_333_333_331e-31),
        ("sqrt(4) - sqrt(4 - (1e-18)^2)", 2.5e-37),
        ("1/sqrt(1 - (1e-9)^2) - 1 - (1e-9)^2/2", 3.75e-37),
        (
            "exp(-1e-12) - 1 + 1e-12 - (1e-12)^2/2",
            -1.666_666_666_666_25e-37,
        ),
        (
            "(1 - 1e-16)/(1 + 1e-16) - 1 + 2e-16",
            1.999_999_999_999_999_8e-32,
        ),
        ("cos(0.5) - cos(0.5 + 1e-36)", 4.794_255_386_042_03e-37),
        (
            "2/pi*elliptic_k(sin(3.14159265/2)^2)",
            13.702_994_082_910_26,
        ),
        (
            "elliptic_k(sin(3.141592653589793/2)^2)",
            38.051_760_549_028_906,
        ),
        ("elliptic_km1(1e-30)", 35.925_070_756_030_58),
        ("elliptic_km1(0.75)", 1.685_750_354_812_596),
        ("2/pi*elliptic_k(sin(1e-9/2)^2) - 1", 6.25e-20),
    ] {
        let found = real(formula);
        assert!(
            (found - expected).abs() <= 1e-13 * expected.abs(),
            "{formula}: {found:e} {expected:e}"
        );
    }
    assert_near(real("1/((1 - (1e-9)^2/2)/cos(1e-9) - 1)"), -2.4e37);
}

#[test]
fn zeros_stay_zeros() {
    for formula in [
        "sin(pi)",
        "sqrt(2)^2 - 2",
        "a - 3*b",
        "cos(b)^2 + sin(b)^2 - 1",
        "exp(ln(a)) - a",
    ] {
        assert_eq!(real(formula), 0.0, "{formula}");
    }
}

#[test]
fn what_has_no_value_says_why_and_where() {
    for (formula, reason, place) in [
        ("1 + b/(a - 3*b)", Undefined::DivisionByZero, "b/(a - 3*b)"),
        ("2*sqrt(x)", Undefined::RootOfNegative, "sqrt(x)"),
        ("ln(x)", Undefined::LogarithmOfNegative, "ln(x)"),
        ("ln(a - 3*b)", Undefined::LogarithmOfZero, "ln(a - 3*b)"),
        ("x^a", Undefined::PowerOfNegative, "x^a"),
        (
            "acos(1 + b)",
            Undefined::OutsideDomain(crate::expr::Function::Acos),
            "acos(1 + b)",
        ),
        ("exp(1e6)", Undefined::Overflow, "exp(1e6)"),
        ("0^-1", Undefined::DivisionByZero, "0^-1"),
        (
            "root(x^2 + 1, x, 0, 1)",
            Undefined::NoSignChange,
            "root(x^2 + 1, x, 0, 1)",
        ),
        ("tan(pi/2)", Undefined::DivisionByZero, "tan(pi/2)"),
    ] {
        assert_eq!(absence(formula), (reason, place), "{formula}");
    }
    assert_eq!(real("if x > 0 then sqrt(x) else 1"), 1.0);
    assert!(truth("x < 0 or sqrt(x) > 1"));
    assert!(!truth("x > 0 and sqrt(x) > 1"));
    assert_eq!(
        value("a", &[]).unwrap_err().reason,
        Undefined::Missing { slot: 0 }
    );
    assert_eq!(real("min(a, inf)"), 0.3);
    assert!(truth("a < inf"));
}

#[test]
fn functions_at_the_ends_of_their_domains_forgive_rounding() {
    assert_eq!(real("sqrt(a - 3*b)"), 0.0);
    assert_eq!(real("acos(3*b/a)"), 0.0);
    assert_eq!(real("asin(a/(3*b))"), std::f64::consts::FRAC_PI_2);
    assert_eq!(real("acosh(3*b/a)"), 0.0);
}

#[test]
fn bound_names_are_local() {
    assert_near(real("at(x^2 + a, x = 2)"), 4.3);
    assert_near(real("at(at(x*a, x = a), a = 2) + a"), 4.3);
    assert_near(real("at(diff(x^3, x), x = 2)"), 12.0);
    assert_near(real("at(diff(x^3*a, x, x), x = 2)"), 3.6);
    assert_near(real("root(x^2 - 2, x, 0, 2)"), std::f64::consts::SQRT_2);
    assert_near(real("root(s - a, s, 0, 10)"), 0.3);
    assert_near(real("root(s^3, s, -1, 2)"), 0.0);
    assert_near(
        real("root(tanh(s)*cosh(s)^2 - a, s, -5, 8)"),
        0.284_412_449_366_123_75,
    );
    assert_near(real("integral(x^2, x, 0, 3)"), 9.0);
    assert_near(real("integral(1/sqrt(s), s, 0, 4)"), 4.0);
    assert_near(real("integral(sin(s), s, 0, pi)"), 2.0);
    assert!((real("integral(abs(s - b), s, 0, 1)") - 0.41).abs() < 1e-14);
    assert_near(real("integral(integral(s*x, s, 0, x), x, 0, 2)"), 2.0);
    assert_near(real("integral(at(x, x = 2*s), s, 0, 1)"), 1.0);
    assert_eq!(
        absence("integral(1/s, s, -1, 2)").0,
        Undefined::NoConvergence
    );
}

#[test]
fn complex_numbers_are_pairs() {
    let complex = |formula: &str| {
        let value = value(formula, &["0.3", "0.1", "-2.5", "1.75"])
            .unwrap()
            .as_complex()
            .unwrap();
        (value.re, value.im)
    };
    assert_eq!(complex("(1 + 2*i)*(3 - i)"), (5.0, 5.0));
    assert_near(complex("(1 + 2*i)/(3 - i)").1, 0.7);
    assert_eq!(complex("i^2"), (-1.0, 0.0));
    assert_eq!(complex("sqrt(-4 + 0*i)"), (0.0, 2.0));
    assert_eq!(complex("exp(i*pi)"), (-1.0, 0.0));
    assert_eq!(complex("if a > 0 then i else 1"), (0.0, 1.0));
    assert_eq!(complex("conj(2*i)"), (0.0, -2.0));
    assert_eq!(real("abs(3 + 4*i)"), 5.0);
    assert_eq!(real("arg(-1 + 0*i)"), std::f64::consts::PI);
    assert_near(real("mod(7*b, 2*b)"), 0.1);
    assert_eq!(real("im((a + i*b)^2)"), 0.06);
    assert_eq!(real("re(ln(-1 + 0*i))"), 0.0);
}

#[test]
fn vectors_and_matrices_are_lists_of_entries() {
    let numbers = |formula: &str| {
        let value = value(formula, &["0.3", "0.1", "-2.5", "1.75"]).unwrap();
        value.numbers().to_vec()
    };
    assert_eq!(numbers("[[1, 2], [3, 4]]*[5, 6]"), [17.0, 39.0]);
    assert_eq!(
        numbers("[[1, 2], [3, 4]]*[[0, 1], [1, 0]]"),
        [2.0, 1.0, 4.0, 3.0]
    );
    assert_eq!(
        numbers("transpose([[1, 2, 3], [4, 5, 6]])"),
        [1.0, 4.0, 2.0, 5.0, 3.0, 6.0]
    );
    assert_eq!(numbers("2*[1, a] - [b, 0]/2"), [1.95, 0.6]);
    assert_eq!(numbers("[[1, 2], [3, 4]][2]"), [3.0, 4.0]);
    assert_eq!(real("[[1, 2], [3, 4]][2, 1]"), 3.0);
    assert_eq!(real("det([[1, 2], [3, 4]])"), -2.0);
    assert_eq!(real("det([[2, -1, 0], [-1, 2, -1], [0, -1, 2]])"), 4.0);
    assert_eq!(
        real("det([[0, 0, 1, 0], [1, 0, 0, 0], [0, 0, 0, 2], [0, 3, 0, 0]])"),
        -6.0
    );
    assert_eq!(real("dot([1, 2, 3], [4, 5, 6])"), 32.0);
    assert_eq!(real("norm([3, 4])"), 5.0);
    assert_eq!(real("norm([3, 4*i])"), 5.0);
    let matrix = value("[[1, 2], [3, 4]]", &[]).unwrap();
    assert_eq!(matrix.as_matrix().unwrap().nth(1), Some(&[3.0, 4.0][..]));
}

#[test]
fn searches_are_bounded_in_time() {
    let nested =
        "integral(integral(integral(integral(sin(x*y*z*w), x, 0, 9), y, 0, 9), z, 0, 9), w, 0, 9)";
    assert_eq!(value(nested, &[]).unwrap_err().reason, Undefined::TooLong);
}
