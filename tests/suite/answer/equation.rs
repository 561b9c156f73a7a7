//! Equations of motion, right and wrong, with what is said.

use vibank::instance::Instance;
use vibank::solution::Solution;

use super::check;

const ONE: &str = r#"
[parameters]
m = "2 kg"
l = "0.5 m"
c = "3 N s/m"
k = "50 N/m"
k2 = "30 N/m"
F0 = "4 N"
Omega = "2 rad/s"
mu = "0.2"
g = "9.81 m/s^2"
[model]
coordinates = { theta = { unit = "rad" }, x = { unit = "m" } }
kinetic = "1/2*m*(x'^2 + l^2*theta'^2)"
potential = "1/2*k*(x - l*theta)^2"
[[part]]
kind = "equation"
id = "eom"
ask = "Find it."
"#;

#[test]
fn any_form_of_the_equation_is_right() {
    let item = format!(
        "{ONE}unknowns = [\"theta\"]\nkey = \"5/6*m*l^2*theta'' + c*l^2/4*theta' + 5/4*k*l^2*theta = 0\"\n\
         mistakes = [{{ answer = \"5/6*m*l^2*theta'' + 5/4*k*l^2*theta = 0\", feedback = \"The damper is missing.\" }}]\n"
    );
    check(
        &item,
        &[
            ("5/6 m l^2 θ'' + c l²/4 θ' + 5/4 k l² θ = 0", "right"),
            ("5/6 m θ'' + c/4 θ' + 5/4 k θ = 0", "right"),
            ("θ'' = -(3c/(10m)) θ' - 3k/(2m) θ", "right"),
            ("10 m thetaddot + 3 c thetadot + 15 k theta = 0", "right"),
            (
                "\\frac{5}{6} m l^2 \\ddot{\\theta} + \\frac{c l^2}{4}\\dot\\theta + \\frac54 k l^2 \\theta = 0",
                "right",
            ),
            ("d²θ/dt² + 3c/(10m) dθ/dt + 3k/2m θ = 0", "right"),
            ("0 = 15kθ + 3cθ' + 10mθ''", "right"),
            ("l^2(5/6 m θ'' + 1/4 (c θ' + 5 k θ)) = 0", "right"),
            ("10 m θ''(t) + 3 c θ'(t) + 15 k θ(t) = 0", "right"),
            ("10mθ'' + 15kθ = 0", "wrong mistake-1"),
            ("10mθ'' - 3cθ' + 15kθ = 0", "wrong sign"),
            ("10mθ'' + 3cθ' + 15.00001kθ = 0", "wrong"),
            ("10mθ'' + 3cθ' + 5kθ = 0", "wrong"),
            ("10mθ'' + 3cθ' + 15 k sin θ = 0", "wrong"),
            ("10mθ'' + 3cθ' + 15 k θ = F0 cos(Ωt)", "wrong dimension"),
            ("10mθ'' + 3cθ'", "unreadable"),
            ("10mθ'' + 3cθ' + 15kφ = 0", "unreadable"),
        ],
    );
}

#[test]
fn forcing_and_friction_count() {
    let item = format!(
        "{ONE}unknowns = [\"x\"]\nkey = \"m*x'' + c*x' + (k + k2)*x = F0*cos(Omega*t) - mu*m*g*sign(x')\"\n"
    );
    check(
        &item,
        &[
            (
                "m x'' + c x' + (k + k2) x = F0 cos(Ω t) - μ m g sign(x')",
                "right",
            ),
            (
                "x'' + c/m x' + (k+k_2)/m x + μ g sgn(x') = F0/m cos Ωt",
                "right",
            ),
            (
                "m x'' + c x' + (k + k2) x = F0 sin(Ω t) - μ m g sign(x')",
                "wrong",
            ),
            ("m x'' + c x' + (k + k2) x = F0 cos(Ω t)", "wrong"),
            (
                "m x'' + c x' + k x = F0 cos(Ω t) - μ m g sign(x')",
                "wrong other",
            ),
            (
                "m x'' + c x' - (k + k2) x = F0 cos(Ω t) - μ m g sign(x')",
                "wrong sign",
            ),
        ],
    );
}

#[test]
fn the_equations_of_a_model_are_keys() {
    for (key, response) in [
        ("model.equation.x", "x'' = -k/m (x - l θ)"),
        (
            "model.equations",
            "m x'' + k (x - l θ) = 0; m l θ'' = k (x - l θ)",
        ),
    ] {
        let item = format!("{ONE}key = \"{key}\"\n");
        check(&item, &[(response, "right"), ("m x'' + k x = 0", "wrong")]);
    }
}

#[test]
fn several_equations_count_by_their_row_space() {
    let item = format!(
        "{ONE}unknowns = [\"theta\", \"x\"]\nkey = [\"m*x'' + k*x - k*l*theta = 0\", \"m*l*theta'' - k*x + k*l*theta = 0\"]\n"
    );
    check(
        &item,
        &[
            (
                "m x'' + k x - k l θ = 0; m l θ'' - k x + k l θ = 0",
                "right",
            ),
            ("m x'' + m l θ'' = 0, m l θ'' = k (x - l θ)", "right"),
            ("x'' + lθ'' = 0\n m x'' = k (l θ - x)", "right"),
            ("m x'' + k x - k l θ = 0", "partial"),
            (
                "m x'' + k x - k l θ = 0; 2 m x'' + 2 k x - 2 k l θ = 0",
                "partial",
            ),
            (
                "m x'' + k x + k l θ = 0; m l θ'' - k x + k l θ = 0",
                "wrong",
            ),
        ],
    );
}

/// Verdicts of the responses to the equation parts of an item, marked together.
fn together(item: &str, responses: &[&str]) -> Vec<&'static str> {
    let catalogue = super::catalogue(item);
    let solution = Solution::of(Instance::of_source(catalogue.items().next().unwrap()));
    (0..responses.len())
        .map(|place| {
            vibank::grade::mark_among(&solution, place, responses)
                .verdict
                .name()
        })
        .collect()
}

#[test]
fn equations_of_several_parts_count_together() {
    let part = |id: &str, key: &str| {
        format!(
            "[[part]]\nkind = \"equation\"\nid = \"{id}\"\nask = \"Find it.\"\nkey = \"{key}\"\n"
        )
    };
    let data = ONE.split("[[part]]").next().expect("the data");
    let item = format!(
        "{data}{}{}",
        part("first", "model.equation.x"),
        part("second", "model.equation.theta")
    );
    let (first, second) = ("m x'' + k (x - l θ) = 0", "m l θ'' = k (x - l θ)");
    let (sum, difference) = ("m x'' + m l θ'' = 0", "x'' - l θ'' = -2 k/m (x - l θ)");
    for (responses, verdicts) in [
        ([first, second], ["right", "right"]),
        ([second, first], ["right", "right"]),
        ([sum, difference], ["right", "right"]),
        ([sum, second], ["right", "right"]),
        ([first, sum], ["right", "right"]),
        // Both in one place are both.
        (
            ["m x'' + k (x - l θ) = 0; m l θ'' = k (x - l θ)", second],
            ["right", "right"],
        ),
        (
            ["m x'' + k (x - l θ) = 0; m l θ'' = k (x - l θ)", "0 = 0"],
            ["right", "wrong"],
        ),
        // An equation given twice is not two.
        ([first, first], ["right", "wrong"]),
        ([first, "2 m x'' + 2 k (x - l θ) = 0"], ["right", "wrong"]),
        ([sum, sum], ["wrong", "wrong"]),
        // What the other answer lacks cannot be made up for.
        ([sum, ""], ["wrong", "missing"]),
        ([sum, "m l θ'' ="], ["wrong", "unreadable"]),
        ([sum, "m l θ'' = k (x + l θ)"], ["wrong", "wrong"]),
        ([first, "m l θ'' = k (x + l θ)"], ["right", "wrong"]),
    ] {
        assert_eq!(together(&item, &responses), verdicts, "{responses:?}");
    }
}

#[test]
fn what_is_wrong_is_told_by_terms() {
    let item = format!(
        "{ONE}unknowns = [\"x\"]\nkey = \"(m + J/r^2)*x'' + c*x' + (k + k2)*x = F0*cos(Omega*t)\"\n"
    )
    .replace(
        "F0 =",
        "J = { name = \"moment of inertia of the disk\", value = \"0.3 kg m^2\" }\nr = \"0.2 m\"\nF0 =",
    );
    check(
        &item,
        &[
            ("(m + J/r^2) x'' + c x' + (k + k2) x = F0 cos(Ωt)", "right"),
            (
                "(m + J/r^2) x'' - c x' + (k + k2) x = F0 cos(Ωt)",
                "wrong sign: The sign of the damping term (in x′) is wrong.",
            ),
            (
                "(m + J/r^2) x'' + c x' + k x = F0 cos(Ωt)",
                "wrong other: The stiffness term (in x) misses k2.",
            ),
            (
                "m x'' + c x' + (k + k2) x = F0 cos(Ωt)",
                "wrong other: The inertia term (in x″) misses J (moment of inertia of the disk) and r.",
            ),
            (
                "(m + J/r^2) x'' + (k + k2) x = F0 cos(Ωt)",
                "wrong other: The damping term (in x′) is missing.",
            ),
            (
                "(m + J/r^2) x'' + c x' + (k + k2) x = 0",
                "wrong other: The exciting term without x is missing.",
            ),
            (
                "(m + J/r^2) x'' + c x' + (k + k2) x = -F0 cos(Ωt)",
                "wrong sign: The sign of the exciting term without x is wrong.",
            ),
            (
                "(m + J/r^2) x'' + 2 c x' + (k + k2) x = F0 cos(Ωt)",
                "wrong other: The number in front of the damping term (in x′) is wrong.",
            ),
            (
                "(m + J/r^2) x'' + c x' + (k + k2 + k l/r) x = F0 cos(Ωt)",
                "wrong other: The stiffness term (in x) should not contain",
            ),
            (
                "(m + J/r^2) x'' - c x' + k x = F0 cos(Ωt)",
                "wrong other: The sign of the damping term (in x′) is wrong. The stiffness term (in x) misses k2.",
            ),
            // A slip in a term that is small for everyday values.
            (
                "(m + J/r^2) x'' + 1.000001 c x' + (k + k2) x = F0 cos(Ωt)",
                "wrong other: The number in front of the damping term",
            ),
        ],
    );
}

#[test]
fn linearization_is_told() {
    let pendulum = |key: &str| format!("{ONE}unknowns = [\"theta\"]\nkey = \"{key}\"\n");
    check(
        &pendulum("m*l^2*theta'' + m*g*l*sin(theta) = 0"),
        &[
            ("θ'' + g/l sin θ = 0", "right"),
            ("θ'' + g/l θ = 0", "wrong other: small motions alone"),
            ("θ'' - g/l sin θ = 0", "wrong sign: stiffness term (in θ)"),
        ],
    );
    check(
        &pendulum("m*l^2*theta'' + m*g*l*theta = 0"),
        &[
            ("θ'' + g/l θ = 0", "right"),
            (
                "θ'' + g/l sin θ = 0",
                "wrong other: still has to be linearized",
            ),
            // What is wrong besides comes first.
            (
                "θ'' - g/l sin θ = 0",
                "wrong other: The sign of the stiffness term (in θ) is wrong. It has to be linearized",
            ),
            (
                "2 θ'' + g/l sin θ = 0",
                "wrong other: It has to be linearized for small motions as well",
            ),
        ],
    );
}

#[test]
fn equations_for_any_and_for_small_angles_are_two_questions() {
    let part = |id: &str, key: &str| {
        format!(
            "[[part]]\nkind = \"equation\"\nid = \"{id}\"\nunknowns = [\"theta\"]\nask = \"Find it.\"\nkey = \"{key}\"\n"
        )
    };
    let data = ONE.split("[[part]]").next().expect("the data");
    let item = format!(
        "{data}{}{}",
        part("exact", "m*l^2*theta'' + m*g*l*sin(theta) = 0"),
        part("small", "m*l^2*theta'' + m*g*l*theta = 0")
    );
    let (exact, small) = ("θ'' + g/l sin θ = 0", "θ'' + g/l θ = 0");
    for (responses, verdicts) in [
        ([exact, small], ["right", "right"]),
        ([small, exact], ["wrong", "wrong"]),
        ([exact, "θ = sin θ"], ["right", "wrong"]),
        (["sin θ = θ", small], ["wrong", "right"]),
        (["θ'' + g/l (2 sin θ - θ) = 0", small], ["wrong", "right"]),
    ] {
        assert_eq!(together(&item, &responses), verdicts, "{responses:?}");
    }
}

#[test]
fn equations_of_other_unknowns_stand_alone() {
    let part = |id: &str, key: &str, unknowns: &str| {
        format!(
            "[[part]]\nkind = \"equation\"\nid = \"{id}\"\nunknowns = {unknowns}\nask = \"Find it.\"\nkey = \"{key}\"\n"
        )
    };
    let data = ONE.split("[[part]]").next().expect("the data");
    let item = format!(
        "{data}{}{}",
        part("first", "model.equation.x", "[\"x\", \"theta\"]"),
        part("frequencies", "m*Omega^2 - k = 0", "[\"Omega\"]")
    );
    let (motion, frequencies) = ("m x'' + k (x - l θ) = 0", "m Ω^2 = k");
    assert_eq!(together(&item, &[motion, frequencies]), ["right", "right"]);
    assert_eq!(together(&item, &[frequencies, motion]), ["wrong", "wrong"]);
}

#[test]
fn what_is_no_equation_is_handed_back() {
    let item = format!("{ONE}unknowns = [\"x\"]\nkey = \"m*x'' + c*x' + k*x = 0\"\n");
    check(
        &item,
        &[
            ("m x''[t] + c x'[t] + k x[t] == 0", "right"),
            ("2 m x'' + 2 c x' + 2 k x = 0", "right"),
            ("m x'' + c x' + k x = 0 (1)", "right"),
            ("m x'' + c x' = -k x (1)", "right"),
            ("2*(m x'' + c x' + k x) = 0", "right"),
            ("(2)(m x'' + c x' + k x) = 0", "right"),
            ("(1) m x'' + c x' + k x = 0", "right"),
            ("1. m x'' + c x' + k x = 0", "right"),
            ("2) m x'' + c x' + k x = 0", "right"),
            ("(a) m x'' + c x' + k x = 0", "right"),
            (
                "(2) m x'' + c x' + k x = 0",
                "unreadable: number of the equation",
            ),
            (
                "2. m x'' + c x' + k x = 0",
                "unreadable: number of the equation",
            ),
            (
                "m x'' + c x' = -k x (2)",
                "unreadable: number of the equation",
            ),
            ("m x'' + c x' + k x = 0; x(0) = 0; x'(0) = 0", "right"),
            ("x(0) = 0; x'(0) = 0", "unreadable: the initial state"),
            (
                "m x'' + c x' + k x = 0, c > 0",
                "unreadable: not an inequality",
            ),
            (
                "m x'' + c x' + k x",
                "unreadable: an equals sign is missing",
            ),
            ("m x'' + 3 x' + 50 x = 0", "unreadable: with the letters"),
            ("2 x'' + 3 x' + 50 x = 0", "unreadable: with the letters"),
            ("x = x", "wrong: says nothing"),
            ("m x'' + c x' + k x = 0 and x = x", "right"),
        ],
    );
}

#[test]
fn a_root_may_stand_for_its_square() {
    let item = format!(
        "{ONE}unknowns = [\"x\", \"theta\"]\nkey = [\"theta = 0\", \"x^2 + l^2*theta^2 = l^2\"]\n"
    );
    check(
        &item,
        &[
            ("θ = 0; x^2 + l^2 θ^2 = l^2", "right"),
            ("θ = 0; sqrt(x^2 + l^2 θ^2) = l", "right"),
            ("l = √(x² + l²θ²) and θ = 0", "right"),
            ("θ = 0; sqrt(x^2 + l^2 θ^2) = -l", "wrong"),
            ("θ = 0; sqrt(x^2 + l^2 θ^2) = 2 l", "wrong"),
            (
                "θ = 0; sqrt(x^2 - l^2 θ^2) = l",
                "wrong: The sign of the term (in θ)",
            ),
        ],
    );
}

#[test]
fn slips_in_curved_terms_are_told() {
    let pendulum = |key: &str| format!("{ONE}unknowns = [\"theta\"]\nkey = \"{key}\"\n");
    check(
        &pendulum("m*l^2*theta'' + m*g*l*sin(theta) = 0"),
        &[
            (
                "θ'' + g/l tan θ = 0",
                "wrong other: for small motions alone",
            ),
            (
                "θ'' + g/l (θ - θ^3/6) = 0",
                "wrong other: for small motions alone",
            ),
            (
                "θ'' + 2 g/l sin θ = 0",
                "wrong other: The number in front of the stiffness term",
            ),
        ],
    );
    check(
        &pendulum("m*l^2*theta'' + m*g*l*theta = 0"),
        &[(
            "θ'' + 2 g/l sin θ = 0",
            "wrong other: The number in front of the stiffness term (in θ) is wrong. It has to be linearized",
        )],
    );
}

#[test]
fn inertia_is_rarely_what_is_wrong() {
    let item =
        format!("{ONE}unknowns = [\"x\", \"theta\"]\nkey = \"m*x'' + k*(x - l*theta) = m*g\"\n");
    check(
        &item,
        &[(
            "m x'' + k (l θ - x) = m g",
            "wrong sign: The sign of the stiffness term (in x) is wrong. The sign of the stiffness term (in θ) is wrong.",
        )],
    );
}
