//! Matrices in symbols and in numbers.

use super::check;

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
