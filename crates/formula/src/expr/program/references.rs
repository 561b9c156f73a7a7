//! Evaluation against values to 36 digits, printed by `tests/references/formulas.py`.

use proptest::prelude::*;

use super::{Outcome, Program, Registers, Slots, Workspace};
use crate::expr::{
    Approx, Binder, Binding, CompileError, Expr, Form, Name, Precise, Scalar, Scope, Shape, Type,
    Variable,
};
use crate::unit::Dimension;
use vibank_dynamics::numerics::{Dd, Rational};

/// Formulas of a = 0.3, b = 0.1, x = -2.5, t = 1.75.
const VALUES: &[(&str, &str)] = &[
    ("sqrt(a)", "0.547722557505166113456969782800802134"),
    ("exp(x)", "0.0820849986238987951695286744671598078"),
    ("ln(b)", "-2.30258509299404568401799145468436421"),
    ("log10(t)", "0.243038048686294440284738469143650140"),
    ("sin(1e6*t)", "0.810531511351881043232166270409127784"),
    ("cos(t)", "-0.178246055649492090382676943942631359"),
    ("tan(x)", "0.747022297238660279355352687825274558"),
    ("asin(a)", "0.304692654015397507972002961227529167"),
    ("acos(x/3)", "2.55590711013264227884488584480198512"),
    ("atan(x)", "-1.19028994968253173292773377482931834"),
    ("sinh(a)", "0.304520293447142618958435267005095229"),
    ("sinh(20*t)", "793006726156715.364064822312887014807"),
    ("cosh(x)", "6.13228947966368611661985231281756300"),
    ("tanh(b)", "0.0996679946249558171183050836783521835"),
    ("asinh(x)", "-1.64723114637109571062485861044361966"),
    ("acosh(t)", "1.15881036042994681173087299087873019"),
    ("atanh(a)", "0.309519604203111715474067349061069438"),
    ("atan2(b,x)", "3.10161396646650319704906553365012748"),
    ("atan2(-b,x)", "-3.10161396646650319704906553365012748"),
    ("hypot(a,x)", "2.51793566240283431114883755075097736"),
    ("elliptic_k(a)", "1.71388944817879106203893484504381765"),
    (
        "elliptic_k(1-1e-9)",
        "11.7479272822800780183016896129444435",
    ),
    ("elliptic_k(x)", "1.12088100360300672423111113895465541"),
    ("a^b", "0.886568150565213334515427088649278621"),
    ("t^x", "0.246833941557046352466623044071301264"),
    ("(a/b)^(1/3)", "1.44224957030740838232163831078010959"),
    ("x^7", "-610.351562500000000000000000000000000"),
    ("x^-5", "-0.0102400000000000000000000000000000000"),
    ("t^100", "2012819673527784914078121.46632561686"),
    (
        "exp(-x^2)*cos(100*t)",
        "0.00115534633606277885520959682502356185",
    ),
    (
        "sqrt(t^2-a^2)/(2*pi)",
        "0.274398076877758486239846969502186360",
    ),
    ("ln(1+1e-12*a)", "2.99999999999955000000000009000000000e-13"),
    ("sin(pi*t)", "-0.707106781186547524400844362104849039"),
    (
        "(1-cos(1e-6*a))/1e-12",
        "0.0449999999999996625000000000010125000",
    ),
    (
        "sqrt(1+b)-sqrt(1-b)",
        "0.100125550119637747391785450350122038",
    ),
    (
        "exp(b)-1-b-b^2/2",
        "0.000170918075647624811707826490246668225",
    ),
    ("(a+b)^9-a^9", "0.000242461000000000000000000000000000000"),
    (
        "1/(x+2.4999999999)",
        "-10000000000.0000000000000000000000000",
    ),
    ("sin(1e12*b)", "0.928693660496591952857227164175213371"),
    (
        "a*cos(40*t)+b*sin(40*t)",
        "0.267384829081678859478336513236407206",
    ),
    ("abs(3+4*i)", "5.00000000000000000000000000000000000"),
    ("arg(a-i*b)", "-0.321750554396642193401404614358661319"),
    ("re(exp(i*t))", "-0.178246055649492090382676943942631359"),
    ("im(sqrt(x+i*a))", "1.58397216869533953171420929632488113"),
    (
        "abs(1/(1-t^2+2*i*a*t))",
        "0.432079086352238676769786526226837812",
    ),
    ("re(asin(t+i*a))", "1.36682691681228835963521961415857008"),
    ("im(acos(t+i*a))", "-1.18420937414819504820708930893669433"),
    ("re(atan(x+i*b))", "-1.19076509921164758163297002841628273"),
    ("im(tanh(a+i*b))", "0.0917415902894458984308833605898466011"),
    ("re(ln(x-i*b))", "0.917090092556003579030007260673329253"),
    (
        "im((a+i*b)^(t+i*x))",
        "-0.0880045374750353411850414691913003364",
    ),
    ("re((a+i*b)^-7)", "-1992.00000000000000000000000000000000"),
    ("im(acosh(x+i*a))", "3.01160797661882515949565196562638574"),
    ("re(asinh(x+i*b))", "-1.64787118587027387151297944738757832"),
    ("im(log10(x+i*a))", "1.31250903029244525737556449628223584"),
    ("re(cosh(a+i*t))", "-0.186327466961970239800222986372736516"),
    ("im(cos(a+i*t))", "-0.824623830193139861989277210730183893"),
    ("re(tan(t+i*a))", "-1.40871971875527064446400014244316872"),
    ("im(atanh(t+i*b))", "1.52269437115606994192267912279181533"),
];

fn decimal(text: &str) -> Precise {
    // A fraction holds 38 digits; small numbers are shifted.
    let (mantissa, shift) = text.split_once('e').unwrap_or((text, "0"));
    let value = Rational::from_decimal(&format!("{:.38}", Cut(mantissa))).unwrap();
    let power = Dd::from(10.0).powi(shift.parse().unwrap());
    let (high, low) = value.to_pair();
    Precise::of_dd(Dd::sum(high, low) * power, 0.0)
}

/// The first digits of a number.
struct Cut<'a>(&'a str);

impl std::fmt::Display for Cut<'_> {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let length = formatter.precision().unwrap_or(usize::MAX);
        formatter.write_str(&self.0[..length.min(self.0.len())])
    }
}

fn data() -> [Precise; 4] {
    ["0.3", "0.1", "-2.5", "1.75"].map(decimal)
}

fn program(formula: &str) -> Program {
    Program::compile(&Expr::read(formula).unwrap(), &Slots(&["a", "b", "x", "t"])).unwrap()
}

fn only<S: Clone>(outcome: &Outcome<'_, S>) -> S {
    outcome.numbers().next().unwrap().clone()
}

#[test]
fn values_agree_to_the_last_digits() {
    for (formula, expected) in VALUES {
        let value = program(formula).evaluate(&data(), &mut Workspace::default());
        let value = value
            .unwrap_or_else(|absence| panic!("{formula}: {absence}"))
            .as_real()
            .unwrap();
        let expected = decimal(expected).high();
        // Where binary64 serves, its bound is what the result may be off by.
        assert!(
            (value - expected).abs() <= 1e-13 * expected.abs(),
            "{formula}: {value} {expected}"
        );
    }
}

#[test]
fn bounds_hold_and_are_not_wasteful() {
    for (formula, expected) in VALUES {
        let (program, expected) = (program(formula), decimal(expected));
        let exact = Dd::sum(expected.high(), expected.low());
        let (mut double, mut wide) = (Registers::default(), Registers::default());
        let double: Approx<f64> = only(&program.run(&data(), &mut double).unwrap());
        let wide: Approx<Dd> = only(&program.run(&data(), &mut wide).unwrap());
        let error = (Dd::from(double.value) - exact).abs().hi();
        assert!(
            error <= double.bound + 1e-33 * exact.hi().abs(),
            "{formula}: {error:e} {:e}",
            double.bound
        );
        let error = (wide.value - exact).abs().hi();
        let slack = 4e-32 * exact.hi().abs();
        assert!(
            error <= wide.bound + slack,
            "{formula}: {error:e} {:e}",
            wide.bound
        );
        assert!(
            wide.bound <= 1e-15 * exact.hi().abs(),
            "{formula}: {:e}",
            wide.bound
        );
        let scale = exact.hi().abs().max(1.0);
        assert!(
            double.bound() < 1e-3 * scale,
            "{formula}: {:e}",
            double.bound
        );
    }
}

/// Formulas of a, b, x, t at random.
fn formulas() -> impl Strategy<Value = String> {
    let leaf = prop::sample::select(vec![
        "a", "b", "x", "t", "2", "0.7", "1e-9", "pi", "3", "1e5", "0",
    ]);
    let leaf = leaf.prop_map(str::to_owned);
    leaf.prop_recursive(6, 40, 2, |inner| {
        let function = prop::sample::select(vec![
            "sqrt",
            "exp",
            "ln",
            "sin",
            "cos",
            "tan",
            "asin",
            "acos",
            "atan",
            "sinh",
            "cosh",
            "tanh",
            "asinh",
            "acosh",
            "atanh",
            "abs",
            "-",
            "log10",
            "elliptic_k",
            "abs(i + ",
            "re(sqrt(i*a + ",
            "im(ln(i - ",
        ]);
        let operator = prop::sample::select(vec!["+", "-", "*", "/", "^"]);
        let pair = prop::sample::select(vec!["atan2", "hypot", "min", "max"]);
        prop_oneof![
            (function, inner.clone()).prop_map(|(function, x)| {
                let open = function.matches('(').count() + 1;
                format!("{function}({x}{}", ")".repeat(open))
            }),
            (inner.clone(), operator, inner.clone())
                .prop_map(|(x, operator, y)| format!("({x}){operator}({y})")),
            (pair, inner.clone(), inner)
                .prop_map(|(function, x, y)| format!("{function}({x}, {y})")),
        ]
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn bounds_hold_for_formulas_at_random(formula in formulas()) {
        let program = program(&formula);
        let (mut double, mut wide) = (Registers::default(), Registers::default());
        let double = program.run::<Approx<f64>>(&data(), &mut double);
        let wide = program.run::<Approx<Dd>>(&data(), &mut wide);
        if let (Ok(double), Ok(wide)) = (double, wide)
            && !double.is_open
            && !wide.is_open
        {
            let (x, y) = (only(&double), only(&wide));
            let error = (Dd::from(x.value) - y.value).abs().hi();
            let is_held = error <= x.bound * (1.0 + 1e-9) + y.bound || !x.value.is_finite();
            prop_assert!(is_held, "{formula}: {x:?} {y:?} {error:e}");
        }
    }
}

/// Names a, b, x, t, z are pure real numbers, u is a vector of 2, M a matrix of 2 by 2, c is complex.
struct Anything;

impl Anything {
    fn form(name: &str) -> Option<Form> {
        Some(match name {
            "a" | "b" | "x" | "t" | "z" => Form::REAL,
            "u" => Form::real(Shape::Vector(2)),
            "M" => Form::real(Shape::Matrix(2, 2)),
            "c" => Form::COMPLEX,
            _ => return None,
        })
    }
}

impl Scope for Anything {
    fn name(&self, name: &Name) -> Option<Type> {
        Self::form(name.as_str()).map(|form| Type::uniform(form, Dimension::PURE))
    }

    fn known(&self) -> Vec<String> {
        vec!["a".to_owned()]
    }
}

impl Binder for Anything {
    fn name(&self, variable: &Variable, _local: &[Name]) -> Option<Binding> {
        let form = Self::form(variable.name.as_str())?;
        (variable.order == 0).then_some(Binding::Input { slot: 0, form })
    }
}

#[test]
fn a_constant_row_has_a_row_of_zeros_as_its_derivative() {
    for text in ["[u, [2, 1]]'", "[[2, 1], u]'", "[u, u]'"] {
        let expr = Expr::read(text).unwrap();
        let program = Program::compile(&expr, &Anything).unwrap();
        assert_eq!(program.form().shape, Shape::Matrix(2, 2), "{text}");
        let value = program.evaluate(&data(), &mut Workspace::default());
        assert_eq!(value.unwrap().numbers(), [0.0; 4], "{text}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn what_is_checked_compiles_to_the_form_that_was_promised(words in prop::collection::vec(
        prop::sample::select(vec![
            "a", "x", "u", "M", "c", "2", "0.5", "[", "]", "(", ")", ", ", "==", "<", "+", "-", "*", "/", "^", "^2",
            "if a < 1 then ", " else ", " and ", " or ", "not ", "sin(", "abs(", "re(", "det(", "dot(u, ", "transpose(",
            "at(x, x = ", "diff(", ", x)", "root(x, x, -1, ", "integral(x, x, 0, ", "min(", "[1]", "[2, 1]", "'", "i",
            "norm(", "conj(", "arg(", "u)", "mod(a, ", "[u, ", "inf",
        ]),
        1..16,
    )) {
        let text = words.concat();
        let Ok(expr) = Expr::read(&text) else { return Ok(()) };
        let Ok(found) = expr.check(&Anything) else { return Ok(()) };
        match Program::compile(&expr, &Anything) {
            Ok(program) => {
                let promised = found.form();
                // A derivative that vanishes is a real zero, also of a complex formula.
                let fits = program.form().field <= promised.field && program.form().shape == promised.shape;
                prop_assert!(fits, "{text}: {:?} {promised:?}", program.form());
                let _ = program.evaluate(&data(), &mut Workspace::default());
            }
            Err(CompileError::Symbolic(_)) => {}
            Err(error) => prop_assert!(false, "{text}: {error}"),
        }
    }
}
