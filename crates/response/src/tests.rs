use proptest::prelude::*;

use super::*;
use vibank_formula::expr::Name;
use vibank_notation::{Math, symbol};

fn lexicon() -> Lexicon {
    let mut lexicon = Lexicon::new();
    for name in [
        "m", "g", "l", "k", "c", "zeta", "omega_n", "omega", "t", "k1", "k2", "m1", "F0", "Omega",
        "mu", "phi", "r",
    ] {
        lexicon.allow(&Name::from(name), symbol(name), false);
    }
    for name in ["x", "theta", "x1", "x2"] {
        lexicon.allow(&Name::from(name), symbol(name), true);
    }
    lexicon.allow(&Name::from("Lh"), Math::letter('L'), false);
    lexicon.forbid(&Name::from("secret"));
    lexicon
}

const MANNER: Manner = Manner {
    comma_is_decimal: true,
    has_imaginary_unit: true,
    values: None,
    is_in_any_case: false,
};

/// A text in plain signs, as every kind gets it.
fn folded(text: &str) -> String {
    Folded::of(text).map_or(text.to_owned(), |folded| folded.text().trim().to_owned())
}

fn formula(text: &str, lexicon: &Lexicon, manner: Manner) -> Result<Typed<Expr>, TypedError> {
    super::formula(&folded(text), lexicon, manner)
}

fn reads(text: &str, expected: &str) {
    let typed = formula(text, &lexicon(), MANNER);
    let typed = typed.unwrap_or_else(|error| panic!("{text}: {:?}", error.at(Passage::of(text))));
    let strict = Expr::read(expected).unwrap();
    assert_eq!(typed.value.to_string(), strict.to_string(), "{text}");
}

#[test]
fn determinants_are_written_out() {
    for (text, expected) in [
        ("det([[k, m], [c, l]])", "k*l - m*c"),
        ("det(k, m; c, l)/2", "(k*l - m*c)/2"),
        (
            "\\begin{vmatrix} k & m \\\\ c & l \\end{vmatrix} r",
            "(k*l - m*c)*r",
        ),
        (
            "Det[{{k, 0, m}, {0, l, 0}, {c, 0, r}}]",
            "k*(l*r) + m*(-(l*c))",
        ),
    ] {
        reads(text, expected);
    }
    for text in [
        "det([[k, m], [c]])",
        "det(k)",
        "det([[k, m, c], [c, l, r]])",
        "det([[det([[k, m], [c, l]]), m], [c, l]])",
        "\\begin{pmatrix} k & m \\\\ c & l \\end{pmatrix}",
    ] {
        assert!(formula(text, &lexicon(), MANNER).is_err(), "{text}");
    }
}

#[test]
fn conjugates_are_of_what_stands_before_them() {
    for (text, expected) in [
        ("k e^(i t) + c.c.", "2*re(k*e^(i*t))"),
        ("k + m i + c.c. - c i + c.c.", "2*re(k + m*i) + 2*re(-c*i)"),
        ("k (m i + c.c.) + r", "k*(2*re(m*i)) + r"),
        ("k i + c.c. + r", "2*re(k*i) + r"),
        ("k + c c", "k + c*c"),
    ] {
        reads(text, expected);
    }
    let real = Manner {
        has_imaginary_unit: false,
        ..MANNER
    };
    assert!(formula("k + c.c.", &lexicon(), real).is_err());
}

#[test]
fn products_need_no_sign() {
    for (text, expected) in [
        ("mgl", "m*g*l"),
        ("2zeta omega_n", "2*zeta*omega_n"),
        ("kl²", "k*l^2"),
        ("4km", "4*k*m"),
        ("2ζω_n", "2*zeta*omega_n"),
        ("ωnt", "omega_n*t"),
        ("omega_nt", "omega_n*t"),
        ("k_1x_1 + k₂x₂", "k1*x1 + k2*x2"),
        ("k(x1 - x2)", "k*(x1 - x2)"),
        ("(k + k1)(x1 - x2)", "(k + k1)*(x1 - x2)"),
    ] {
        reads(text, expected);
    }
    reads("LΩ", "Lh*Omega");
    reads("2π√(m/k)", "2*pi*sqrt(m/k)");
}

#[test]
fn the_signs_of_paper_are_read() {
    for (text, expected) in [
        ("√(3k/2m)", "sqrt(3*k/(2*m))"),
        ("(3*k/2/m)^0.5", "(3*k/2/m)^0.5"),
        ("−m·g×l", "-m*g*l"),
        ("m**2", "m^2"),
        ("3×10^-4 k", "3*10^-4*k"),
        ("3e-4k", "0.0003*k"),
        ("2,5k", "2.5*k"),
        ("½ m x'^2", "0.5*m*x'^2"),
        ("2½ m x'^2", "2.5*m*x'^2"),
        ("sin x", "sin(x)"),
        ("sin^2 x", "sin(x)^2"),
        ("sin²(x)", "sin(x)^2"),
        ("sin ωt + cos(omega t)", "sin(omega*t) + cos(omega*t)"),
        ("F0 sin Omega t", "F0*sin(Omega*t)"),
        ("mgl sinθ", "m*g*l*sin(theta)"),
        ("mglsinθ", "m*g*l*sin(theta)"),
        ("arctan(c/k)", "atan(c/k)"),
        ("tan^-1(c/k)", "atan(c/k)"),
        ("|x|", "abs(x)"),
        ("|x| |theta|", "abs(x)*abs(theta)"),
        ("e^-ζω_nt", "e^(-(zeta*omega_n*t))"),
        ("e^(-t) sin(omega t)", "e^(-t)*sin(omega*t)"),
        ("[m + {k}]g", "(m + k)*g"),
        ("1/(iΩc)", "1/(i*Omega*c)"),
        ("omega = sqrt(k/m)", "sqrt(k/m)"),
        ("y_9 = sqrt(k/m)", "sqrt(k/m)"),
    ] {
        reads(text, expected);
    }
}

#[test]
fn derivatives_are_read() {
    for text in [
        "x''",
        "xddot",
        "\\ddot{x}",
        "\\ddot x",
        "d²x/dt²",
        "d^2x/dt^2",
        "\\frac{d^2 x}{dt^2}",
        "ẍ",
        "x''(t)",
    ] {
        reads(&format!("m{text}"), "m*x''");
        reads(&format!("m {text} + k x"), "m*x'' + k*x");
    }
    for text in [
        "θ'",
        "thetadot",
        "\\dot{\\theta}",
        "\\dot\\theta",
        "dθ/dt",
        "θ̇",
        "theta_dot",
        "\\frac{d\\theta}{dt}",
    ] {
        reads(&format!("c {text}"), "c*theta'");
    }
    reads("m1 \\ddot{x}_1 + x1ddot", "m1*x1'' + x1''");
    reads("x(t)", "x");
}

#[test]
fn a_datum_printed_with_its_dot_is_read_in_words_and_signs() {
    let mut lexicon = lexicon();
    let name = Name::from("thetadot0");
    let math = vibank_notation::read_latex("\\dot\\theta_0").unwrap();
    lexicon.allow(&Name::from("theta0"), symbol("theta0"), false);
    lexicon.allow(&name, math, false);
    for text in [
        "thetadot0",
        "theta0dot",
        "theta_0dot",
        "dottheta0",
        "θ̇₀",
        "θ̇_0",
        "θdot0",
        "\\dot\\theta_0",
        "\\dot{\\theta}_0",
    ] {
        let typed = formula(text, &lexicon, MANNER);
        let typed =
            typed.unwrap_or_else(|error| panic!("{text}: {:?}", error.at(Passage::of(text))));
        assert_eq!(typed.value, Expr::name(name.clone()), "{text}");
    }
}

#[test]
#[expect(clippy::too_many_lines, reason = "a table")]
fn ranges_are_read_in_signs_and_words() {
    let said = |text: &str| {
        let told = |condition: &Condition<'_>| {
            let units = condition.units.iter().map(|unit| unit.text());
            let units: String = units.map(|unit| format!(" [{unit}]")).collect();
            let said = match &condition.said {
                Said::Chain { sides, signs } => {
                    let sides: Vec<&str> = sides.iter().map(|side| side.text()).collect();
                    let signs = signs.iter().map(|sign| match (sign.is_less, sign.is_open) {
                        (true, true) => "<",
                        (true, false) => "≤",
                        (false, true) => ">",
                        (false, false) => "≥",
                    });
                    let mut text = sides[0].to_owned();
                    for (sign, side) in signs.zip(&sides[1..]) {
                        text += &format!("{sign}{side}");
                    }
                    text
                }
                Said::Interval {
                    subject,
                    ends,
                    open,
                } => {
                    let subject = subject.map_or("", Passage::text);
                    let [low, high] = ends.map(Passage::text);
                    format!("{subject}:{low};{high}{open:?}")
                }
                Said::Within { bound, open } => format!("±{}{open:?}", bound.text()),
            };
            said + &units
        };
        let asked = Wording::of("For which x does the block stay at rest?");
        match Ranges::read(Passage::of(&folded(text)), DecimalMark::Point, &asked) {
            Ok(Ranges::SideBySide(conditions)) => {
                let told: Vec<String> = conditions.iter().map(told).collect();
                told.join(" ? ")
            }
            Ok(Ranges::Union(groups)) => {
                let told = groups.iter().map(|group| {
                    let told: Vec<String> = group.conditions.iter().map(told).collect();
                    told.join(" & ")
                });
                told.collect::<Vec<_>>().join(" | ")
            }
            Err(error) => format!("{error:?}"),
        }
    };
    const CLOSED: &str = "Some([false, false])";
    for (text, due) in [
        ("0.1 m <= x < b", "0.1 m≤x<b".to_owned()),
        ("U >= 3 V", "U≥3 V".to_owned()),
        (">= 3", "≥3".to_owned()),
        ("for all x >= 3", "x≥3".to_owned()),
        ("the block stays if x >= 3 m", "x≥3 m".to_owned()),
        ("x must not exceed 3", "x≤3".to_owned()),
        ("x must be 3 or larger", "x≥3".to_owned()),
        ("3 and above", "≥3".to_owned()),
        ("max. 3 m", "≤3 m".to_owned()),
        ("x above 3 (included)", "x≥3".to_owned()),
        (
            "from 1 m (excluded) to 2 m (included)",
            ":1 m;2 mSome([true, false])".to_owned(),
        ),
        (
            "x between 1 and 2 (both included)",
            format!("x:1;2{CLOSED}"),
        ),
        ("± 3 m", "±3 mNone".to_owned()),
        (
            "more than 1 m but not more than 2 m",
            ">1 m & ≤2 m".to_owned(),
        ),
        ("x_min = 3, so x ≥ 3", "x≥3".to_owned()),
        ("And(x >= 1, x <= 2)", "x≥1 ? x≤2".to_owned()),
        ("x < 1 or x > 2 and x < 3", "x<1 | x>2 & x<3".to_owned()),
        ("x > 1, x < 3", "x>1 ? x<3".to_owned()),
        ("x > 1,5; x < 3", "x>1,5 ? x<3".to_owned()),
        ("[0, 1]", format!(":0;1{CLOSED}")),
        (
            "x \\in \\left]0, 1\\right[",
            "x:0;1Some([true, true])".to_owned(),
        ),
        ("x in [0, 1) m", "x:0;1Some([false, true]) [m]".to_owned()),
        (
            "[0, 1[ m U ]2, 3] m",
            ":0;1Some([false, true]) [m] | :2;3Some([true, false]) [m]".to_owned(),
        ),
        (
            "[0, 1], (2, 3)",
            format!(":0;1{CLOSED} | :2;3Some([true, true])"),
        ),
        ("[0, 1]∪[2, 3]", format!(":0;1{CLOSED} | :2;3{CLOSED}")),
        ("(1 < x < 2) cm", "1<x<2 [cm]".to_owned()),
        ("{x | 1 < x}", "1<x".to_owned()),
        ("Interval(0.2, oo)", format!(":0.2;oo{CLOSED}")),
        (
            "Union(Interval(0, 1), Interval.open(2, 3))",
            format!(":0;1{CLOSED} | :2;3Some([true, true])"),
        ),
        (
            "x in RealRange(Open(0), 1)",
            "x:0;1Some([true, false])".to_owned(),
        ),
        ("Interval[{0, 1}]", format!(":0;1{CLOSED}")),
        ("from 0.2 to 0.5 m", ":0.2;0.5 mNone".to_owned()),
        (
            "x between 1 and 2 or from 3 to 4",
            "x:1;2None | :3;4None".to_owned(),
        ),
        ("zwischen 1 und 2", ":1;2None".to_owned()),
        ("von 1 bis 2", ":1;2None".to_owned()),
        ("x = 0.2 … 0.5", "x:0.2;0.5None".to_owned()),
        ("1e-3-2e-3", ":1e-3;2e-3None".to_owned()),
        ("from 0.2 on", "≥0.2".to_owned()),
        ("0.2 or more", "≥0.2".to_owned()),
        ("x < ", "x<".to_owned()),
        ("", "Missing".to_owned()),
        ("0.3", "NoCondition(Passage(\"0.3\"))".to_owned()),
        ("[0, 1", "Bracket".to_owned()),
        ("[0, 1, 2]", "TwoEnds".to_owned()),
    ] {
        assert_eq!(said(text), due, "{text}");
    }
}

#[test]
fn simple_latex_is_read() {
    for (text, expected) in [
        ("\\frac{k}{m}", "k/m"),
        ("\\sqrt{\\frac{k}{m}}", "sqrt(k/m)"),
        ("\\omega_n t", "omega_n*t"),
        ("\\omega_{n}t", "omega_n*t"),
        ("2\\zeta\\omega_n", "2*zeta*omega_n"),
        ("\\left(\\frac{c}{2m}\\right)^2", "(c/(2*m))^2"),
        ("k\\cdot x", "k*x"),
        ("\\frac12 k x^{2}", "1/2*k*x^2"),
        ("$k x$", "k*x"),
        ("\\sin\\left(\\Omega t\\right)", "sin(Omega*t)"),
        ("\\mu m g \\operatorname{sign}(\\dot x)", "mu*m*g*sign(x')"),
    ] {
        reads(text, expected);
    }
}

#[test]
fn what_may_be_meant_otherwise_has_other_readings() {
    for (text, expected, others) in [
        ("k/2m", "k/(2*m)", &["k/2*m"][..]),
        ("k/2 m", "k/2*m", &["k/(2*m)"]),
        ("1/2mx'²", "1/2*m*x'^2", &["1/(2*m*x'^2)", "1/(2*m)*x'^2"]),
        ("1/2 m x'²", "1/2*m*x'^2", &[]),
        (
            "1/2π √(k/m)",
            "1/2*pi*sqrt(k/m)",
            &["1/(2*pi)*sqrt(k/m)", "1/(2*pi*sqrt(k/m))"],
        ),
        ("5/6 m l^2 θ''", "5/6*m*l^2*theta''", &[]),
        ("c l²/4 θ'", "c*l^2/4*theta'", &["c*l^2/(4*theta')"]),
        ("1/(2m)c", "1/(2*m)*c", &[]),
        ("g/l*x", "g/l*x", &[]),
        ("k/m(2-g)", "k/(m*(2 - g))", &["k/m*(2 - g)"]),
        ("k^1/2", "k^(1/2)", &["k^1/2"]),
        ("k^3/2", "k^3/2", &["k^(3/2)"]),
        ("k^2/2", "k^2/2", &[]),
        ("√(k)/m", "sqrt(k)/m", &[]),
        ("√k/m", "sqrt(k)/m", &["sqrt(k/m)"]),
        ("1/√km", "1/sqrt(k*m)", &["1/(sqrt(k)*m)", "1/sqrt(k)*m"]),
        ("√2 k", "sqrt(2)*k", &["sqrt(2*k)"]),
        ("√x²", "sqrt(x^2)", &[]),
        ("cosθ l", "cos(theta*l)", &["cos(theta)*l"]),
        ("e^-k m", "e^(-k)*m", &["e^(-(k*m))"]),
        ("k cos x·t", "k*cos(x*t)", &["k*cos(x)*t"]),
        ("k cos x·m", "k*cos(x)*m", &[]),
        ("k cos(x) t", "k*cos(x)*t", &["k*cos(x*t)"]),
        (
            "e^-kt(m + x)",
            "e^(-(k*t))*(m + x)",
            &["e^(-(k*t*(m + x)))"],
        ),
        ("e^-k(m + x)", "e^(-(k*(m + x)))", &["e^(-k)*(m + x)"]),
    ] {
        let typed = formula(text, &lexicon(), MANNER).unwrap();
        let of = |text: &str| Expr::read(text).unwrap().to_string();
        assert_eq!(typed.value.to_string(), of(expected), "{text}");
        let found: Vec<String> = typed.others.iter().map(ToString::to_string).collect();
        let due: Vec<String> = others.iter().map(|other| of(other)).collect();
        assert_eq!(found, due, "{text}");
    }
}

#[test]
fn only_the_symbol_stands_before_an_equals_sign() {
    for text in [
        "ω_9 = k/m",
        "\\omega_{9} = k/m",
        "k_{ser} = k/m",
        "y(t) = k/m",
        "|y| = k/m",
        "x' = k/m",
        "dx/dt = k/m",
        "y [m/s] = k/m",
        "= k/m",
        "k/m = ω_9",
        "y = c = k/m",
        "y == k/m",
    ] {
        reads(text, "k/m");
    }
    for text in [
        "ω_9² = k",
        "2y = k",
        "-y = k",
        "1/y = k",
        "kx = m g",
        "tan y = k",
        "tany = k",
        "k x - m g = 0",
        "k/m = k",
        "\\frac{1}{y} = k",
    ] {
        let error = formula(text, &lexicon(), MANNER).expect_err(text);
        assert_eq!(error.trouble, Trouble::Unsolved, "{text}");
    }
}

#[test]
fn what_cannot_be_read_says_where_and_why() {
    let here = |place: &str| At::Here(place.to_owned());
    let behind = |place: &str| At::Behind(place.to_owned());
    let unknown = Trouble::Unknown {
        near: None,
        letters: Vec::new(),
    };
    for (text, at, trouble) in [
        ("", behind(""), Trouble::Missing),
        ("k +", behind("k +"), Trouble::Missing),
        (
            "2 m sqrt(1600)*k/",
            behind("sqrt(1600)*k/"),
            Trouble::Missing,
        ),
        ("k + q", here("q"), unknown),
        ("m 2", here("2"), Trouble::NumberAfter),
        ("sqrt(k", here("("), Trouble::Bracket),
        ("k)", here(")"), Trouble::Bracket),
        ("log(k)", here("log"), Trouble::Logarithm),
        ("k ± m", here("±"), Trouble::TwoValues),
        ("(k, m)", here(","), Trouble::List),
        ("k ? m", here("?"), Trouble::Sign),
    ] {
        let error = formula(text, &lexicon(), MANNER).unwrap_err();
        assert_eq!(
            (error.at(Passage::of(text)), error.trouble),
            (at, trouble),
            "{text}"
        );
    }
    let error = formula("2secret", &lexicon(), MANNER).unwrap_err();
    assert!(matches!(error.trouble, Trouble::NotAllowed(_)));
    let deep = "(".repeat(500);
    assert_eq!(
        formula(&deep, &lexicon(), MANNER).unwrap_err().trouble,
        Trouble::TooDeep
    );
    let long = "1+".repeat(900) + "1";
    assert_eq!(
        formula(&long, &lexicon(), MANNER).unwrap_err().trouble,
        Trouble::TooDeep
    );
    let too_long = "1+".repeat(1500);
    assert_eq!(
        formula(&too_long, &lexicon(), MANNER).unwrap_err().trouble,
        Trouble::TooLong
    );
}

#[test]
fn lists_are_read_by_rows() {
    let manner = Manner::default();
    for (text, expected, unit) in [
        ("[[3m, 0], [0, m]]", "[[3*m, 0], [0, m]]", ""),
        ("[[4, 0], [0, 2]] kg", "[[4, 0], [0, 2]]", "kg"),
        ("m*[[3, 0], [0, 1]]", "[[3*m, 0], [0, m]]", ""),
        ("[3m, 0; 0, m]", "[[3*m, 0], [0, m]]", ""),
        ("(1, 0.618)", "[[1, 0.618]]", ""),
        ("[1; -2]", "[[1], [-2]]", ""),
        ("1, -2", "[[1, -2]]", ""),
        ("(1, (1 + sqrt(5))/2)", "[[1, (1 + sqrt(5))/2]]", ""),
        ("((1, 2), (3, 4))", "[[1, 2], [3, 4]]", ""),
        ("[[3, 0], [0, 1]] m", "[[3*m, 0], [0, m]]", ""),
        ("(1, 2)/2 * kg", "[[0.5, 1]]", "kg"),
        ("2 kg [[3, 0], [0, 1]]", "[[6, 0], [0, 2]]", "kg"),
        ("(1, 2)^T; (3, 4)^T", "[[1, 2], [3, 4]]", ""),
        ("[[1, 2], [3, 4]]^T", "[[1, 3], [2, 4]]", ""),
        ("diag(1, m)", "[[1, 0], [0, m]]", ""),
        ("u1 = (1, 2), u2 = (3, 4)", "[[1, 2], [3, 4]]", ""),
        ("1, 2 kg", "[[1, 2]]", "kg"),
        ("[[1], [2]]", "[[1], [2]]", ""),
    ] {
        let units = [vibank_formula::unit::Unit::parse("kg").unwrap()];
        let listed = list::list(&folded(text), &lexicon(), manner, &units, Wanted::Vector).unwrap();
        let rows: Vec<String> = listed
            .rows
            .iter()
            .map(|row| {
                format!(
                    "[{}]",
                    row.iter()
                        .map(ToString::to_string)
                        .collect::<Vec<_>>()
                        .join(", ")
                )
            })
            .collect();
        let shown = format!("[{}]", rows.join(", "));
        assert_eq!(shown, expected, "{text}");
        let found = listed.unit.map_or(String::new(), |unit| unit.text());
        assert_eq!(found, unit, "{text}");
    }
}

#[test]
fn lists_that_are_not_clear_are_refused() {
    let units = [vibank_formula::unit::Unit::parse("kg").unwrap()];
    for (text, trouble) in [
        ("(1, 2", Trouble::Bracket),
        ("1, 2)", Trouble::Bracket),
        ("1, 2 m", Trouble::UnitOrLetter),
        ("[1 N, 2 kN]", Trouble::UnitOfEntry),
        ("[1 N, 2]", Trouble::UnitOfEntry),
        ("(1, 2) kg, (3, 4) g", Trouble::UnitOfEntry),
        ("x2 = 1, x1 = 2", Trouble::Order),
        ("[[1, 2], [3]]", Trouble::Ragged),
        ("1; 1, 2", Trouble::Ragged),
        ("(1, 2) + 1", Trouble::LeftOver),
        ("(1, )", Trouble::Missing),
    ] {
        let found = list::list(
            &folded(text),
            &lexicon(),
            Manner::default(),
            &units,
            Wanted::Vector,
        );
        assert_eq!(found.unwrap_err().trouble, trouble, "{text}");
    }
}

proptest! {
    #[test]
    fn any_text_is_read_or_refused(text in any::<String>()) {
        let _ = formula(&text, &lexicon(), MANNER).map_err(|error| error.at(Passage::of(&text)));
        let _ = list::list(&folded(&text), &lexicon(), MANNER, &[], Wanted::Vector).map_err(|error| error.at(Passage::of(&text)));
        let _ = chain(&text, 0, text.len(), &lexicon(), MANNER).map_err(|error| error.at(Passage::of(&text)));
    }

    #[test]
    fn any_text_of_formula_signs_is_read_or_refused(text in "[mgkxθω_{}()\\[\\]|/^*+\\-'²√ 0-9.,;=<edt\\\\]{0,60}|(\\\\frac|\\\\sqrt|\\\\dot|\\\\omega|_|\\{|\\}|x|2|sin| ){0,30}") {
        let _ = formula(&text, &lexicon(), MANNER).map_err(|error| error.at(Passage::of(&text)));
        let _ = list::list(&folded(&text), &lexicon(), MANNER, &[], Wanted::Vector).map_err(|error| error.at(Passage::of(&text)));
        let _ = chain(&text, 0, text.len(), &lexicon(), MANNER).map_err(|error| error.at(Passage::of(&text)));
    }
}

/// A decimal sign that is wider in the text than in what the number is read from does not move what is pointed at.
#[test]
fn many_decimal_signs_are_refused() {
    let typed = format!("{}1", "1{,}".repeat(300));
    let text = folded(&typed);
    let style = Style {
        mark: vibank_formula::unit::DecimalMark::Point,
        comma_is_decimal: true,
        is_complex: false,
    };
    let values = Values::read(Passage::of(&text), style).unwrap();
    assert!(values.amount(&values.all()).is_err());
}
