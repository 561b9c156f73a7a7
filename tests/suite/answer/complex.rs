//! Complex numbers in Cartesian and polar form.

use super::check;

const ITEM: &str = r#"
[parameters]
R = "3 ohm"
X = "4 ohm"
[[part]]
id = "Z"
key = "R - i*X"
unit = "ohm"
tolerance = "1 %"
ask = "Find it."
mistakes = [{ answer = "X - i*R", feedback = "Swapped." }]
"#;

#[test]
fn both_forms_are_read() {
    check(
        ITEM,
        &[
            ("3 - 4i ohm", "right"),
            ("(3 - 4j) ohm", "right"),
            ("3-4i", "right matches: Taken in Ω"),
            ("3-4iΩ", "right"),
            ("3-4*I", "right"),
            ("3 - i4", "right"),
            ("Z = 3 − 4 i Ω", "right"),
            ("0.003 - 0.004i kohm", "right"),
            ("5 ohm at -53.13 deg", "right"),
            ("5∠-53.13°", "right"),
            ("5∠-53,13° ohm", "right"),
            ("5 ohm at -0.9273 rad", "right"),
            ("5 e^(-0.9273i) ohm", "right"),
            ("3 + 4i ohm", "wrong sign"),
            ("-3 + 4i ohm", "wrong sign"),
            ("4 - 3i ohm", "wrong mistake-1"),
            ("5 ohm", "wrong"),
            ("3 - 4i kohm", "wrong power-of-ten"),
            ("5∠-53.13", "unreadable: degrees"),
            ("5∠-0.9273", "right"),
            ("3 (2) - 4i", "unreadable"),
            ("3 - 4i V", "wrong dimension"),
            ("some", "unreadable"),
            ("3 - 4k ohm", "unreadable"),
        ],
    );
}
