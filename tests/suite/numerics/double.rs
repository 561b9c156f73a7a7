//! Double-double functions against `tests/references/double_double.py`.

use vibank::numerics::Dd;

use crate::physics::Accuracy;

const REFERENCES: &str = include_str!("../../fixtures/references/double-double.jsonl");

/// Relative errors up to this are met by every function, except where powers amplify them.
const TARGET: f64 = 2e-31;

type Case = (String, Vec<(i64, i64)>, (i64, i64));

fn number((hi, lo): (i64, i64)) -> Dd {
    Dd::sum(f64::from_bits(hi as u64), f64::from_bits(lo as u64))
}

fn value((name, arguments, _): &Case) -> Dd {
    let x = number(arguments[0]);
    match name.as_str() {
        "sqrt" => x.sqrt(),
        "exp" => x.exp(),
        "expm1" => x.expm1(),
        "ln" => x.ln(),
        "ln_1p" => x.ln_1p(),
        "sin" => x.sin(),
        "cos" => x.cos(),
        "tan" => x.tan(),
        "asin" => x.asin(),
        "acos" => x.acos(),
        "atan" => x.atan(),
        "sinh" => x.sinh(),
        "cosh" => x.cosh(),
        "tanh" => x.tanh(),
        "asinh" => x.asinh(),
        "acosh" => x.acosh(),
        "atanh" => x.atanh(),
        "atan2" => Dd::atan2(x, number(arguments[1])),
        "hypot" => x.hypot(number(arguments[1])),
        "pow" => x.pow(number(arguments[1])),
        "powi" => x.powi(arguments[1].0 as i32),
        unknown => panic!("no function `{unknown}`"),
    }
}

/// How much a power amplifies the rounding of its logarithm.
fn amplification(case: &Case) -> f64 {
    match case.0.as_str() {
        "pow" => 1.0 + (number(case.1[0]).ln() * number(case.1[1])).hi().abs(),
        "powi" => (case.1[1].0 as f64).abs(),
        _ => 1.0,
    }
}

/// Functions of double-double numbers.
pub(crate) fn functions(table: &mut Accuracy) {
    for line in REFERENCES.lines() {
        let case: Case = serde_json::from_str(line).unwrap();
        let expected = number(case.2);
        let error = ((value(&case) - expected) / expected).abs().hi() / amplification(&case);
        table.record("double-double functions, relative", error, TARGET, || {
            line.to_owned()
        });
    }
}
