//! Mode shapes up to scale and sign, subspaces, normalization.

use super::check;
use vibank::instance::Instance;
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
            ("(1, 1)", "wrong near"),
        ],
    );
}

#[test]
fn the_key_has_the_scale_that_is_asked() {
    let item = format!(
        "{DATA}[[part]]\nkind = \"mode-shape\"\nkey = \"w\"\nmode = 1\nnormalization = \"first\"\nask = \"Find it.\"\n"
    );
    check(&item, &[("(1, 1)", "right"), ("(0.5, 0.5)", "wrong near")]);
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
            ("[[1, -1, 0], [-2, 2, 0]]", "wrong"),
            ("[[1, 1, 1], [1, -1, 0]]", "wrong"),
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
            ("[[1, -1, 0], [0, 1, -1]]", "right"),
            ("[[1, 0, 0], [0, 1, 0]]", "wrong"),
            ("[[2, -1, 0], [0, 1, -2]]", "wrong"),
        ],
    );
}
