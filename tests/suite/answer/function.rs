//! Motions as functions of time.

use super::check;

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
        ],
    );
}
