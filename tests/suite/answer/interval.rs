//! Intervals and their unions.

use super::check;

const DATA: &str = r#"
[parameters]
m = "6 kg"
k = "128 N/m"
g = "9.81 m/s^2"
mu = { value = "0.5", range = "0.1 .. 0.9", step = "0.1" }
x0 = { value = "0.03 m", range = "0 .. 0.5 m", step = "0.01 m" }
[quantities]
mu_min = { formula = "5*k*x0/(m*g)", unit = "1" }
d = { formula = "0.25[m]", unit = "m" }
"#;

#[test]
fn one_bound() {
    let item = format!(
        "{DATA}[[part]]\nkind = \"interval\"\nid = \"r\"\nvariable = \"mu\"\nkey = \"[mu_min, inf)\"\nwithin = \"[0, inf)\"\nask = \"When?\"\n\
         mistakes = [{{ answer = \"(-inf, mu_min]\", feedback = \"More friction holds better.\" }}]\n"
    );
    check(
        &item,
        &[
            ("mu >= 0.32619775739", "right"),
            ("μ ≥ 0.326", "right"),
            ("0.326 <= mu", "right"),
            ("[0.326, inf)", "right"),
            ("[0.326, ∞[", "right"),
            ("mu >= 5 k x0/(m g)", "right"),
            ("mu ≥ 0,326", "right"),
            ("mu > 0.326", "wrong near"),
            ("mu <= 0.326", "wrong mistake-1"),
            ("0 <= mu <= 0.326", "wrong mistake-1"),
            ("mu >= 0.4", "wrong"),
            ("0.326", "unreadable"),
            ("from 0.326 to 0.9", "wrong"),
            ("x > 2", "unreadable"),
            ("", "missing"),
        ],
    );
}

#[test]
fn two_pieces() {
    let item = format!(
        "{DATA}[[part]]\nkind = \"interval\"\nid = \"r\"\nvariable = \"x0\"\nkey = [\"[0[m], d/5)\", \"(2*d, 3*d]\"]\nwithin = \"[0, inf)\"\nask = \"When?\"\n"
    );
    check(
        &item,
        &[
            ("0 <= x0 < 0.05 or 0.5 < x0 <= 0.75", "right"),
            ("x0 < 0.05 m or 0.5 m < x0 <= 0.75 m", "right"),
            ("[0, 5 cm) ∪ (50 cm, 75 cm]", "right"),
            ("]50, 75] cm or [0, 5[ cm", "right"),
            ("[0, 0.05), (0.5, 0.75]", "right"),
            ("x0 < 0.05 or x0 > 0.5 and x0 <= 0.75", "right"),
            ("x0 <= 0.05 or 0.5 < x0 <= 0.75", "wrong near"),
            ("x0 < 0.05", "wrong"),
            ("0.5 < x0 <= 0.75 kg", "wrong dimension: is in m"),
            ("0 <= x0 < 5 or 50 < x0 <= 75 cm", "right"),
            ("[0, 5) or (50, 75] cm", "right"),
            ("0 <= x0 < 5 and 50 < x0 <= 75 cm", "right"),
            (
                "everything but [0, 0.05) or (0.5, 0.75]",
                "unreadable: may stand before",
            ),
        ],
    );
}

/// A symmetric range, and what lies outside it.
#[test]
fn distances() {
    let part = "[[part]]\nkind = \"interval\"\nid = \"r\"\nvariable = \"x\"\n";
    let symbol = "[symbols]\nx = \"m\"\n";
    // From 5 cm to 25 cm on both sides of x0 = 3 cm.
    let item = format!(
        "{DATA}{symbol}{part}key = [\"[x0 - d, x0 - d/5)\", \"(x0 + d/5, x0 + d]\"]\nask = \"When?\"\n"
    );
    check(
        &item,
        &[
            ("-0.22 <= x < -0.02 or 0.08 < x <= 0.28", "right"),
            ("0.05 < |x - x0| <= 0.25", "right"),
            ("5 < |x0 - x| <= 25 cm", "right"),
            ("|x - x0| > 0.05 and |x0 - x| ≤ 0.25", "right"),
            ("0.1 < 2*|x - x0| <= 0.5", "unreadable: Solve for"),
            ("|x - x0| > 0.05", "wrong"),
            ("0.05 < |x + x0| <= 0.25", "wrong"),
        ],
    );
}
