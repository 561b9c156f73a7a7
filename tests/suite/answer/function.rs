//! Motions as functions of time.

use super::check;
use crate::BANK;
use vibank::response::Passage;

const ITEM: &str = r#"
[parameters]
x0 = "0.1 m"
lam = { value = "0.2 1/s", symbol = '\lambda' }
omega = "5 rad/s"
[quantities]
x = { formula = "x0*exp(-lam*t)*(cos(omega*t) + lam/omega*sin(omega*t))", unit = "m" }
[[part]]
kind = "function"
key = "x"
span = ["0", "6*pi/omega"]
ask = "Find it."
mistakes = [{ answer = "x0*cos(omega*t)", feedback = "It is damped." }]
"#;

#[test]
fn any_form_of_the_motion_is_right() {
    check(
        ITEM,
        &[
            ("x0 e^(-λt) (cos ωt + λ/ω sin ωt)", "right"),
            ("0.1 exp(-0.2 t)(cos(5t) + 0.04 sin(5t))", "right"),
            ("x(t) = 0.1001 e^(-0.2t) cos(5t - 0.04)", "right"),
            ("0.1001 e^(-0.2t) sin(5t + 1.531)", "right"),
            ("0,1001 e^(-0,2 t) sin(5 t + 1,531 + 2π)", "right"),
            ("-0.1001 e^{-0.2t} \\cos(5t - 0.04 + \\pi)", "right"),
            ("x0 cos(ωt)", "wrong mistake-1"),
            ("0.1 cos(5t)", "wrong mistake-1"),
            ("-x0 e^(-λt) (cos ωt + λ/ω sin ωt)", "wrong sign"),
            ("0.1001 e^(-0.2t) cos(5t + 0.5)", "wrong"),
            ("0.1001 e^(-0.2t) cos(6t - 0.04)", "wrong"),
            ("0.1 sqrt(-t)", "wrong"),
            ("0.1 e^(-0.2 y)", "unreadable"),
        ],
    );
}

#[test]
fn what_stands_before_the_equals_sign_counts() {
    let right = "0.1001 e^(-0.2t) cos(5t - 0.04)";
    for (before, verdict) in [
        ("x", "right"),
        ("x(t)", "right"),
        ("x[t]", "right"),
        ("x'", "unreadable"),
        ("x''(t)", "unreadable"),
        ("dx/dt", "unreadable"),
        ("v", "unreadable"),
        ("y(t)", "right"),
        ("x(t) [m]", "right"),
        ("y'(t)", "unreadable"),
        ("x0", "unreadable"),
        ("5 cos(3t)", "unreadable"),
        ("x = 5 cos(3t)", "unreadable"),
        ("x = x0 e^(-λt) (cos ωt + λ/ω sin ωt)", "right"),
        ("0.1001 e^(-0.2t) sin(5t + 1.531)", "right"),
        ("v = 3; x", "right"),
        ("x = 3; x", "unreadable"),
        ("3; x", "right"),
    ] {
        check(ITEM, &[(&format!("{before} = {right}"), verdict)]);
    }
    check(
        ITEM,
        &[
            (&format!("x = {right}; v = 0.5 t"), "right"),
            (&format!("v = 0.5 t; w = {right}"), "unreadable"),
            (&format!("x = {right}, t >= 0"), "right"),
        ],
    );
}

#[test]
fn letters_have_no_tolerance() {
    check(
        ITEM,
        &[
            ("x0 e^(-λt) (cos ωt + λ/ω sin ωt)", "right"),
            ("x0 e^(-λt) sqrt(1 + λ²/ω²) cos(ωt - atan(λ/ω))", "right"),
            ("x0 e^(-λt) cos(ωt - λ/ω)", "wrong near"),
            ("0.1 e^(-0.2t) cos(5t - 0.04)", "right"),
            ("x0 e^(-0.2t) cos(5t - 0.04)", "right"),
        ],
    );
    check(
        &ITEM.replace("span =", "tolerance = \"2 %\"\nspan ="),
        &[("x0 e^(-λt) cos(ωt - λ/ω)", "right")],
    );
}

#[test]
fn an_exponent_is_not_left_open() {
    check(
        ITEM,
        &[
            (
                "0.1001 e^-0.2 t cos(5t - 0.04)",
                "unreadable: belong to the exponent",
            ),
            (
                "0.1001 e^-λ t cos(5t - 0.04)",
                "unreadable: belong to the exponent",
            ),
            ("0.1001 e^-0.2t cos(5t - 0.04)", "right"),
            ("0.1001 e^(-0.2 t) cos(5t - 0.04)", "right"),
        ],
    );
}

const LETTERS: &str = r#"
[parameters]
m = "2 kg"
c = "3 N s/m"
A = "0.1 m"
B = "0.05 m"
omega = "5 rad/s"
[quantities]
x = { formula = "A*cos(omega*t) + B*sin(omega*t)", unit = "m" }
[[part]]
kind = "function"
key = "x"
span = ["0", "6*pi/omega"]
ask = "Find it."
"#;

#[test]
fn a_letter_is_a_unit_where_only_that_fits() {
    check(
        LETTERS,
        &[
            ("0.1 m cos(5t) + 0.05 m sin(5t)", "right"),
            ("0.1 cos(5t) m + 0.05 sin(5t) m", "right"),
            ("10 cm cos(5t) + 5 cm sin(5t)", "right"),
            ("100 mm cos(5t) + 5×10^1 mm sin(5t)", "right"),
            ("(100 cos(5t) + 50 sin(5t)) mm", "right"),
            ("10 cm cos(5t) + 6 cm sin(5t)", "wrong"),
            ("0.1 m cos(5t) + 0.05 sin(5t)", "unreadable: each term"),
            ("0.1 kg cos(5t) + 0.05 kg sin(5t)", "unreadable"),
            ("A cos(ωt) + 0.05 sin(5t)", "right"),
            ("m cos(5t)", "wrong"),
            // The time is no tonne.
            ("0.1 + 0.05 t", "wrong"),
            ("2 t", "wrong"),
            (
                "0.1 cos(5t) + 0.05 sin(5t) H(t)",
                "unreadable: it is not clear",
            ),
            ("0.1118 cos 5t - 26.57°", "unreadable: brackets"),
            ("0.1118 cos(5t - 26.57°)", "right"),
        ],
    );
}

#[test]
fn slips_are_named() {
    check(
        LETTERS,
        &[
            ("0.1118 cos(5t - 0.4636)", "right"),
            ("-0.1118 cos(5t - 0.4636)", "wrong sign"),
            ("0.1118 cos(5t - 26.57)", "wrong angle-unit"),
            ("0.1118 cos(0.7958t - 0.4636)", "wrong two-pi"),
            ("11.18 cos(5t - 0.4636)", "wrong power-of-ten: m"),
            ("0.1118 cos(5t - 0.447)", "wrong near: Close"),
            ("0.1118 cos(5.15t - 0.4636)", "wrong other: frequency"),
        ],
    );
}

#[test]
fn data_alone_may_be_asked_for() {
    let item = LETTERS.replace(
        "x = {",
        "C = { formula = \"hypot(A, B)\", unit = \"m\" }\nphi = { formula = \"atan2(B, A)\", unit = \"rad\" }\nx = {",
    );
    let ask = |kind: &str| {
        format!(
            "[[part]]\nid = \"{kind}\"\nkey = \"{kind}\"\nask = \"Find it.\"\n[[part]]\nkind = \"function\""
        )
    };
    let item = item.replacen("[[part]]\nkind = \"function\"", &ask("C"), 1);
    let item = item.replacen("[[part]]\nkind = \"function\"", &ask("phi"), 1);
    for (listed, verdict) in [
        ("", "right"),
        ("in = [\"A\", \"B\", \"omega\"]\n", "right"),
        ("without = [\"C\", \"phi\"]\n", "unreadable"),
    ] {
        let item = item.replace("span =", &format!("{listed}span ="));
        let catalogue = super::catalogue(&item);
        let solution = vibank::solution::Solution::of(vibank::instance::Instance::of_source(
            catalogue.items().next().expect("the item"),
        ));
        let marker = solution.marker(2).expect("the key exists");
        let verdict_of = |response: &str| marker.mark(Passage::of(response)).verdict.name();
        assert_eq!(verdict_of("C cos(ωt - φ)"), verdict, "{listed}");
        assert_eq!(verdict_of("A cos(ωt) + B sin(ωt)"), "right", "{listed}");
        assert_eq!(
            verdict_of("x = C cos(ωt - φ) = 0.1118 cos(5t - 0.4636)"),
            "right",
            "{listed}"
        );
    }
}

const TWO: &str = r#"
[parameters]
m = "1 kg"
k = "4 N/m"
[model]
coordinates = { x1 = { unit = "m" }, x2 = { unit = "m" } }
kinetic = "1/2*m*(x1'^2 + x2'^2)"
potential = "1/2*k*x1^2 + 1/2*k*(x2 - x1)^2 + 1/2*k*x2^2"
[[part]]
kind = "function"
id = "general"
key = "model.general_motion"
components = ["x1", "x2"]
constants = 4
ask = "Find it."
"#;

#[test]
fn a_general_solution_may_have_short_decimals() {
    let item = TWO.replace("1 kg", "0.6 kg").replace("4 N/m", "323 N/m");
    check(
        &item,
        &[
            (
                "x1 = A cos(23.2t) + B sin(23.2t) + C cos(40.2t) + D sin(40.2t); x2 = A cos(23.2t) + B sin(23.2t) - C cos(40.2t) - D sin(40.2t)",
                "right",
            ),
            (
                "x1 = A cos(25.5t) + B sin(25.5t) + C cos(40.2t) + D sin(40.2t); x2 = A cos(25.5t) + B sin(25.5t) - C cos(40.2t) - D sin(40.2t)",
                "wrong",
            ),
        ],
    );
}

#[test]
fn a_general_solution_has_to_meet_any_initial_state() {
    check(
        TWO,
        &[
            (
                "x1 = A cos(2t) + B sin(2t) + C cos(3.464t) + D sin(3.464t); x2 = A cos(2t) + B sin(2t) - C cos(3.464t) - D sin(3.464t)",
                "right",
            ),
            (
                "x1 = A1 cos(2t + φ1) + A2 cos(2 sqrt(3) t + φ2); x2 = A1 cos(2t + φ1) - A2 cos(2 sqrt(3) t + φ2)",
                "right",
            ),
            (
                "x2 = A cos(2t) + B sin(2t) - C cos(√(3k/m) t) - D sin(√(3k/m) t); x1 = A cos(2t) + B sin(2t) + C cos(√(3k/m) t) + D sin(√(3k/m) t)",
                "right",
            ),
            (
                "x1 = A cos(2t) + B sin(2t); x2 = A cos(2t) + B sin(2t)",
                "wrong",
            ),
            (
                "x1 = A cos(2t) + B sin(2t) + C cos(3t) + D sin(3t); x2 = A cos(2t) + B sin(2t) - C cos(3t) - D sin(3t)",
                "wrong",
            ),
            (
                "x1 = A cos(2t) + C cos(3.464t); x2 = A cos(2t) - C cos(3.464t)",
                "wrong",
            ),
            ("x1 = A cos(2t)", "unreadable"),
            // A constant that does not reach all values.
            (
                "x1 = e^A cos(2t) + B sin(2t) + C cos(3.464t) + D sin(3.464t); x2 = e^A cos(2t) + B sin(2t) - C cos(3.464t) - D sin(3.464t)",
                "wrong: a factor of its own or a phase",
            ),
            (
                "x1 = (A^2 + 1) cos(2t) + B sin(2t) + C cos(3.464t) + D sin(3.464t); x2 = (A^2 + 1) cos(2t) + B sin(2t) - C cos(3.464t) - D sin(3.464t)",
                "wrong: a factor of its own or a phase",
            ),
            (
                "x1 = sin(A) cos(2t) + B sin(2t) + C cos(3.464t) + D sin(3.464t); x2 = sin(A) cos(2t) + B sin(2t) - C cos(3.464t) - D sin(3.464t)",
                "wrong: a factor of its own or a phase",
            ),
            (
                "x1 = A1 cos(2t + sin(C)/100) + A2 cos(2 sqrt(3) t + φ2); x2 = A1 cos(2t + sin(C)/100) - A2 cos(2 sqrt(3) t + φ2)",
                "wrong: a factor of its own or a phase",
            ),
            // One constant too many.
            (
                "x1 = (A + E) cos(2t) + B sin(2t) + C cos(3.464t) + D sin(3.464t); x2 = (A + E) cos(2t) + B sin(2t) - C cos(3.464t) - D sin(3.464t)",
                "right matches: 4 constants would do",
            ),
        ],
    );
}

#[test]
fn the_functions_of_the_bank_are_asked_with_data() {
    let catalogue = &*BANK;
    for (item, part, response, verdict) in [
        (
            "ch2/e3-amplitude-phase",
            "x",
            "C cos(omega0 t + phi)",
            "unreadable",
        ),
        (
            "ch2/e3-amplitude-phase",
            "x",
            "x0 cos(ω0 t) + v0/ω0 sin(ω0 t)",
            "right",
        ),
        (
            "ch2/e3-amplitude-phase",
            "x",
            "x'(t) = x0 cos(ω0 t) + v0/ω0 sin(ω0 t)",
            "unreadable",
        ),
        (
            "ch3/e3-critical-response",
            "x",
            "(C1 + C2 t) e^(-λ t)",
            "unreadable",
        ),
        (
            "ch3/e3-critical-response",
            "x",
            "(x0 + (v0 + λ x0) t) e^(-λ t)",
            "right",
        ),
        (
            "ch4/t2-base-absolute-transmissibility",
            "x_ss",
            "X sin(Ω t - ψ)",
            "unreadable",
        ),
        (
            "ch4/p3-base-excited-relative",
            "z_ss",
            "Z sin(Ω t - ψ)",
            "unreadable",
        ),
        ("ch2/e7-lc-circuit", "q", "q0 cos(t/sqrt(L C))", "right"),
    ] {
        let template = catalogue.items().find(|own| own.id.to_string() == item);
        let template = template.expect("the item");
        let place = template.parts.iter().position(|own| own.has_id(part));
        let solution =
            vibank::solution::Solution::of(vibank::instance::Instance::of_source(template));
        let marker = solution
            .marker(place.expect("the part"))
            .expect("the key exists");
        let marking = marker.mark(Passage::of(response));
        assert_eq!(
            marking.verdict.name(),
            verdict,
            "{item} {response}: {:?}",
            marking.remarks
        );
    }
}
