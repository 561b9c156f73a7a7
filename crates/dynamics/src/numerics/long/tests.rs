use super::*;

/// A decimal, to the last bits.
fn decimal(text: &str) -> Long {
    let (mantissa, power) = text.split_once('e').unwrap_or((text, "0"));
    let digits = mantissa.trim_start_matches('-').replace('.', "");
    let decimals = mantissa.split_once('.').map_or(0, |(_, part)| part.len());
    let whole = digits.bytes().fold(Long::ZERO, |sum, digit| {
        sum * Long::from(10.0) + Long::from(f64::from(digit - b'0'))
    });
    let power = power.parse::<i32>().unwrap() - decimals as i32;
    let value = whole * Long::from(10.0).powi(power);
    if mantissa.starts_with('-') {
        -value
    } else {
        value
    }
}

fn assert_near(name: &str, found: Long, expected: &str) {
    let expected = decimal(expected);
    let error = ((found - expected) / expected).abs();
    assert!(error.to_f64() < 1e-70, "{name}: {:e}", error.to_f64());
}

/// Functions, arguments and values to 74 digits by mpmath: `nstr(f(mpf(x)), 74)`.
const VALUES: &str = include_str!("values.txt");

fn function(name: &str) -> fn(Long) -> Long {
    match name {
        "exp" => Long::exp,
        "ln" => Long::ln,
        "log10" => Long::log10,
        "sin" => Long::sin,
        "cos" => Long::cos,
        "tan" => Long::tan,
        "atan" => Long::atan,
        "asin" => Long::asin,
        "acos" => Long::acos,
        "sinh" => Long::sinh,
        "cosh" => Long::cosh,
        "tanh" => Long::tanh,
        "asinh" => Long::asinh,
        "acosh" => Long::acosh,
        "atanh" => Long::atanh,
        "sqrt" => Long::sqrt,
        other => panic!("there is no {other}"),
    }
}

#[test]
fn functions_agree_to_seventy_digits() {
    for line in VALUES.lines() {
        let [name, x, expected] = line.split(' ').collect::<Vec<_>>()[..] else {
            panic!("{line}");
        };
        let x = x.parse::<f64>().unwrap();
        assert_near(line, function(name)(Long::from(x)), expected);
    }
}

#[test]
fn roundings_and_conversions() {
    for x in [0.0, 1.0, -2.5, 1e-300, 5e-324, 1.797e308, 0.1] {
        assert_eq!(Long::from(x).to_f64(), x);
    }
    for (x, floor) in [
        (2.5, 2.0),
        (-2.5, -3.0),
        (0.3, 0.0),
        (-0.3, -1.0),
        (4.0, 4.0),
        (-4.0, -4.0),
    ] {
        assert_eq!(Long::from(x).floor().to_f64(), floor, "{x}");
    }
    let third = Long::from(1.0) / Long::from(3.0);
    assert!((third * Long::from(3.0) - Long::from(1.0)).abs().to_f64() < 1e-75);
    let tiny = (Long::from(1.0) + Long::from(1e-60)) - Long::from(1.0);
    assert!((tiny.to_f64() / 1e-60 - 1.0).abs() < 1e-15);
}
