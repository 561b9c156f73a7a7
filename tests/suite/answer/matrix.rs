//! Matrices in symbols and in numbers.

use super::check;
use vibank::instance::Instance;
use vibank::response::Passage;
use vibank::solution::Solution;

const ITEM: &str = r#"
[parameters]
m = "2 kg"
k = "16 N/m"
[quantities]
M = { formula = "[[2*m, 0], [0, m]]", unit = "kg" }
K = { formula = "[[3*k, -k], [-k, k]]", unit = "N/m" }
[[part]]
kind = "matrix"
key = "K"
ask = "Find it."
mistakes = [{ answer = "[[2*k, 0], [0, k]]", feedback = "They are coupled." }]
"#;

#[test]
fn entries_are_compared() {
    check(
        ITEM,
        &[
            ("[[3k, -k], [-k, k]]", "right"),
            ("[3k, -k; -k, k]", "right"),
            ("k [[3, -1], [-1, 1]]", "right"),
            ("K = [[3k, -k], [-k, k]]", "right"),
            ("((k + 2k, -k), (-k, k))", "right"),
            (
                "\\begin{pmatrix} 3k & -k \\\\ -k & k \\end{pmatrix}",
                "right",
            ),
            ("[[48, -16], [-16, 16]] N/m", "right"),
            ("[[48, -16], [-16, 16]]", "right"),
            ("[[0.048, -0.016], [-0.016, 0.016]] N/mm", "right"),
            ("[[3k, k], [k, k]]", "wrong"),
            ("[[48, -16], [-16, 17]]", "wrong"),
            ("[[2k, 0], [0, k]]", "wrong mistake-1"),
            ("[[32, 0], [0, 16]]", "wrong mistake-1"),
            ("[[3m, -k], [-k, k]]", "wrong"),
            ("[[3k, -k]]", "unreadable"),
            ("[[48, -16], [-16, 16]] kg", "unreadable"),
            ("[[3k, -k], [-k]]", "unreadable"),
            ("stiff", "unreadable"),
        ],
    );
}

#[test]
fn slips_of_a_whole_matrix_are_told() {
    check(
        ITEM,
        &[
            ("[[-3k, k], [k, -k]]", "wrong sign: reversed"),
            ("[[-48, 16], [16, -16]]", "wrong sign: reversed"),
            (
                "[[48, -16], [-16, 16]] kN/m",
                "wrong power-of-ten: prefixes",
            ),
            ("[[48, -16], [-16, 16]] mN/m", "wrong power-of-ten"),
            ("[[6k, -2k], [-2k, 2k]]", "wrong other: one factor"),
            ("[[3, -1], [-1, 1]]", "wrong other: one factor"),
            ("[[k, -k], [-k, 3k]]", "wrong other: another order"),
            ("[[16, -16], [-16, 48]]", "wrong other: another order"),
            (
                "[[3k/m, -k/m], [-k/m, k/m]]",
                "wrong dimension: (1, 1) comes out in",
            ),
            (
                "[[3k, -k], [-k, m]]",
                "wrong dimension: (2, 2) comes out in",
            ),
            ("[[3k, -1], [-1, k]]", "wrong dimension: as a pure number"),
            ("[[3k, -k], [-k, 2k]]", "wrong other: (2, 2) is wrong"),
        ],
    );
}

#[test]
fn what_rounding_leaves_of_a_zero_is_zero() {
    let item = ITEM.replace("key = \"K\"", "key = \"M\"");
    check(
        &item,
        &[
            ("[[4, 1e-9], [-2e-16, 2]] kg", "right"),
            ("[[4, 1e-4], [0, 2]] kg", "wrong"),
            ("diag(2m, m)", "right"),
            ("m diag(2, 1)", "right"),
            ("[[4000, 0], [0, 2000]] g", "right"),
            ("2 m [1 0; 0 0,5]", "right"),
            ("2m\t0\n0\tm", "right"),
            ("4, 0; 0, 2 kg", "right"),
        ],
    );
}

#[test]
fn what_is_typed_is_shown_with_its_unit() {
    let catalogue = super::catalogue(ITEM);
    let solution = Solution::of(Instance::of_source(catalogue.items().next().unwrap()));
    let marker = solution.marker(0).expect("the key exists");
    let reading = marker
        .mark(Passage::of("[[0.048, -0.016], [-0.016, 0.016]] kN/m"))
        .reading;
    let reading = reading.expect("it can be read");
    assert!(reading.math.plain().ends_with("kN/m"), "{}", reading.text);
    assert!(reading.text.ends_with("kN/m"), "{}", reading.text);
}
