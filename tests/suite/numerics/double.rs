//! Double-double functions against `tests/references/double_double.py`.

use std::collections::BTreeMap;

use vibank::numerics::Dd;

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

#[test]
fn functions_of_double_doubles_keep_thirty_one_digits() {
    let mut worst: BTreeMap<String, (usize, f64, String)> = BTreeMap::new();
    for line in REFERENCES.lines() {
        let case: Case = serde_json::from_str(line).unwrap();
        let expected = number(case.2);
        let error = ((value(&case) - expected) / expected).abs().hi() / amplification(&case);
        let entry = worst.entry(case.0.clone()).or_default();
        entry.0 += 1;
        if error.is_nan() || error > entry.1 {
            (entry.1, entry.2) = (error, line.to_owned());
        }
    }
    for (name, (cases, error, _)) in &worst {
        println!("{name:8} {cases:5} cases  worst {error:.1e}  target {TARGET:.0e}");
    }
    for (name, (_, error, line)) in worst {
        assert!(error <= TARGET, "{name}: {error:e} at {line}");
    }
}
