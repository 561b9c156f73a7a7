//! Mode shapes up to scale and sign, subspaces, normalization.

use super::check;
use vibank::instance::Instance;
use vibank::response::Passage;
use vibank::solution::Solution;

const DATA: &str = r#"
[parameters]
m = "2 kg"
[quantities]
u = { formula = "[1, (1 + sqrt(5))/2]", unit = "1" }
basis = { formula = "[[1, -1, 0], [0, 1, -1]]", unit = "1" }
w = { formula = "[0.5[kg^(-1/2)], 0.5[kg^(-1/2)]]", unit = "kg^(-1/2)" }
"#;

#[test]
fn any_scale_and_sign_is_right() {
    let item = format!(
        "{DATA}[[part]]\nkind = \"mode-shape\"\nkey = \"u\"\nmode = 1\nask = \"Find it.\"\nmistakes = [{{ answer = \"[1, 1]\", feedback = \"No.\" }}]\n"
    );
    check(
        &item,
        &[
            ("(1, 1.618)", "right"),
            ("[0.618; 1]", "right"),
            ("(-0.618, -1)", "right"),
            ("[1, (1+√5)/2]", "right"),
            ("1, 1.62", "right"),
            ("(1; 1,618)", "right"),
            ("(1, -1.618)", "wrong sign"),
            ("(2, 2)", "wrong mistake-1"),
            ("(1, 1.7)", "wrong"),
            ("(0, 0)", "wrong"),
            ("(1, 2, 3)", "unreadable"),
        ],
    );
}

#[test]
fn scale_counts_where_it_is_asked() {
    let item = format!(
        "{DATA}[[part]]\nkind = \"mode-shape\"\nkey = \"w\"\nmode = 1\nnormalization = \"mass\"\nask = \"Find it.\"\n"
    );
    check(
        &item,
        &[
            ("(0.5, 0.5)", "right"),
            ("(-0.5, -0.5)", "right"),
            ("1/sqrt(2m) * [1, 1]", "right"),
            ("(1, 1)", "partial scale"),
            ("(1, 1)/sqrt(2m)", "right"),
            ("(0.5, 0.5) kg^(-1/2)", "right"),
            ("(0.01581, 0.01581) g^-0.5", "right"),
            ("(0.5, 0.5) kg", "unreadable: does not fit"),
            ("(0.5, 0.5) m", "partial scale"),
        ],
    );
}

#[test]
fn the_key_has_the_scale_that_is_asked() {
    let item = format!(
        "{DATA}[[part]]\nkind = \"mode-shape\"\nkey = \"w\"\nmode = 1\nnormalization = \"first\"\nask = \"Find it.\"\n"
    );
    check(
        &item,
        &[("(1, 1)", "right"), ("(0.5, 0.5)", "partial scale")],
    );
    let catalogue = super::catalogue(&item);
    let solution = Solution::of(Instance::of_source(catalogue.items().next().unwrap()));
    let key = solution.marker(0).expect("the key exists").key();
    assert_eq!(key.math.plain().matches("1.00").count(), 2);
}

#[test]
fn a_basis_of_the_modes_is_right() {
    let item = format!(
        "{DATA}[[part]]\nkind = \"mode-shape\"\nkey = \"basis\"\nmode = [2, 3]\nask = \"Find it.\"\n"
    );
    check(
        &item,
        &[
            ("[[1, -1, 0], [1, 1, -2]]", "right"),
            ("(1, 0, -1), (0, 1, -1)", "right"),
            ("(1, -1, 0); (1, 1, -2)", "right"),
            ("[1, -1, 0; 0, 1, -1]", "right"),
            ("1, -1, 0\n1, 1, -2", "right"),
            ("(1, -1, 0) and (1, 1, -2)", "right"),
            ("(1, -1, 0)^T, (1, 1, -2)^T", "right"),
            ("u2 = (1, -1, 0), u3 = (1, 1, -2)", "right"),
            ("(1, -1, 0)/sqrt(2); (1, 1, -2)/sqrt(6)", "right"),
            ("[1; -1; 0], [1; 1; -2]", "right"),
            ("1, -1, 0, 1, 1, -2", "right"),
            ("[[1, 0], [-1, 1], [0, -1]]", "right"),
            ("[1 0; -1 1; 0 -1]", "right"),
            (
                "\\begin{pmatrix} 1 & 0 \\\\ -1 & 1 \\\\ 0 & -1 \\end{pmatrix}",
                "right",
            ),
            ("[[1, -1], [0, 0], [1, -1]]", "wrong"),
            ("[[1, -1, 0], [-2, 2, 0]]", "partial"),
            ("[[1, 1, 1], [1, -1, 0]]", "partial"),
            ("[[1, 1, 1], [1, 0, 0]]", "wrong"),
            ("(1, -1, 0)", "unreadable: 2 shapes"),
            ("u3 = (1, -1, 0), u2 = (1, 1, -2)", "unreadable: order"),
        ],
    );
}

#[test]
fn figures_in_print_do_not_widen_the_tolerance() {
    let data = DATA.replace("unit = \"1\" }", "unit = \"1\", digits = 1 }");
    let item = format!(
        "{data}[[part]]\nkind = \"mode-shape\"\nkey = \"basis\"\nmode = [2, 3]\nask = \"Find it.\"\n"
    );
    check(
        &item,
        &[
            ("(1, -1, 0), (0, 1, -1)", "right"),
            ("(1, 0, 0), (0, 1, 0)", "wrong"),
            ("(1, -1, 0), (1, -1, 1)", "partial"),
            ("(2, -1, 0), (0, 1, -2)", "wrong"),
        ],
    );
}

const CHAIN: &str = r#"
[parameters]
m = "2 kg"
k = "50 N/m"
[model]
coordinates = { x1 = { unit = "m" }, x2 = { unit = "m" }, x3 = { unit = "m" } }
kinetic     = "1/2*m*(x1'^2 + x2'^2 + x3'^2)"
potential   = "1/2*k*x1^2 + 1/2*k*(x2 - x1)^2 + 1/2*k*(x3 - x2)^2 + 1/2*k*x3^2"
[quantities]
modes = { formula = "model.mode_shapes", unit = "kg^(-1/2)" }
[[part]]
kind = "mode-shape"
key  = "modes"
mode = [1, 2, 3]
ask  = "Find them."
"#;

#[test]
fn all_modes_at_once_are_rows_or_columns() {
    check(
        CHAIN,
        &[
            ("(1, 1.414, 1), (1, 0, -1), (1, -1.414, 1)", "right"),
            ("[1 1 1; 1.414 0 -1.414; 1 -1 1]", "right"),
            ("[1 1 1; 1.414 0 -1.414; 1 -1 1]^T", "right"),
            ("(1, 1.414, 1), (1, 0, -1), (1, -1.414, 2)", "partial"),
            (
                "(1, 0, -1), (1, 1.414, 1), (1, -1.414, 1)",
                "partial: mode 2",
            ),
            ("(1, 0, 0), (0, 1, 0), (0, 0, 1)", "wrong"),
            ("[1 2 3; 4 5 6]", "unreadable"),
        ],
    );
}

const PAIR: &str = r#"
[parameters]
m = "2 kg"
k = "50 N/m"
[model]
coordinates = { x1 = { unit = "m" }, x2 = { unit = "m" } }
kinetic     = "1/2*m*(x1'^2 + x2'^2)"
potential   = "1/2*k*x1^2 + 1/2*k*(x2 - x1)^2"
[quantities]
omega1 = { formula = "model.natural_angular_frequencies[1]", unit = "rad/s" }
omega2 = { formula = "model.natural_angular_frequencies[2]", unit = "rad/s" }
u1     = { formula = "model.mode_shapes[1]", unit = "kg^(-1/2)" }
[[part]]
id   = "pulsations"
key  = "[omega1, omega2]"
unit = "rad/s"
ask  = "Find them."
[[part]]
kind = "mode-shape"
key  = "u1"
mode = 1
ask  = "Find it."
"#;

#[test]
fn what_an_earlier_part_lists_may_be_used() {
    let catalogue = super::catalogue(PAIR);
    let solution = Solution::of(Instance::of_source(catalogue.items().next().unwrap()));
    let marker = solution.marker(1).expect("the key exists");
    for (response, expected) in [
        ("(1, (2k - m omega1^2)/k)", "right"),
        ("(1, (2k - m omega2^2)/k)", "wrong"),
    ] {
        let marking = marker.mark(Passage::of(response));
        assert_eq!(marking.verdict.name(), expected, "{response}: {marking:?}");
    }
}
