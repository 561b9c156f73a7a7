use proptest::prelude::*;

use super::*;

fn decimal(text: &str) -> Decimal {
    Decimal::parse(text).unwrap_or_else(|error| panic!("`{text}`: {error}"))
}

#[test]
fn numbers_stay_as_they_are_written() {
    for text in [
        "0",
        "0.00",
        "2.50",
        "-0.125",
        "1200",
        "1.60e-2",
        "3e4",
        "-1e-300",
        "12345678901234567890123456789012345678",
    ] {
        assert_eq!(decimal(text).to_string(), text);
    }
    for (text, printed) in [
        ("+5", "5"),
        ("-0", "0"),
        ("05.10", "5.10"),
        ("12.5e3", "1.25e4"),
        ("0e7", "0"),
        ("0.0e-240", "0.00000000000000000000000000000000000000"),
    ] {
        assert_eq!(decimal(text).to_string(), printed);
    }
}

#[test]
fn bounds_are_refused_with_a_message() {
    for (text, message) in [
        ("", "a number is missing"),
        ("1e400", "the value is out of range"),
        ("1e-301", "the value is out of range"),
        ("1e99999999999999999999", "the value is out of range"),
        (
            "123456789012345678901234567890123456789",
            "more than 38 significant digits",
        ),
        ("NaN", "`NaN` is not a number"),
        ("inf", "`inf` is not a number"),
        ("1.", "`1.` is not a number"),
        (".5", "`.5` is not a number"),
        ("1e", "`1e` is not a number"),
        ("0x10", "`0x10` is not a number"),
    ] {
        assert_eq!(
            Decimal::parse(text).unwrap_err().to_string(),
            message,
            "`{text}`"
        );
    }
    assert!(Decimal::parse(&"1".repeat(10_000_000)).is_err());
}

#[test]
fn equal_values_are_equal() {
    use std::collections::HashSet;
    let set: HashSet<Decimal> = ["2.5", "2.50", "0.25e1", "25e-1"].map(decimal).into();
    assert_eq!(set.len(), 1);
    assert!(decimal("-1e300") < decimal("-1e-300"));
    assert!(decimal("0") > decimal("-1e-300") && decimal("0.0") == decimal("-0"));
    assert_eq!(
        decimal("0.1").checked_add(decimal("0.20")),
        Some(decimal("0.3"))
    );
    assert_eq!(decimal("1e300").checked_mul(decimal("10")), None);
    assert_eq!(decimal("1e300").checked_add(decimal("1")), None);
}

/// Digits from the exact binary values, by Python's `decimal`.
#[test]
fn computed_numbers_are_rounded_from_their_exact_value() {
    for (value, figures, printed) in [
        (2.5, 1, "2"),
        (0.125, 2, "0.12"),
        (1.005, 3, "1.00"),
        (9.995, 3, "9.99"),
        (0.1, 20, "0.10000000000000000555"),
        (123_456.0, 4, "1.235e5"),
        (2.675, 3, "2.67"),
        (999.6, 3, "1.00e3"),
        (0.000_999_6, 3, "0.00100"),
        (0.000_999_4, 3, "9.99e-4"),
        (-158.0, 2, "-160"),
        (1e22, 5, "1.0000e22"),
    ] {
        assert_eq!(
            Decimal::rounded(value, figures).unwrap().to_string(),
            printed
        );
    }
    for value in [f64::NAN, f64::INFINITY, 5e-324, 1e305] {
        assert_eq!(Decimal::rounded(value, 3), None);
    }
}

prop_compose! {
    fn written()(sign in "-?", whole in "[0-9]{1,17}", tenths in "([.][0-9]{1,17})?", power in prop::option::of(-250_i32..250)) -> String {
        format!("{sign}{whole}{tenths}{}", power.map(|power| format!("e{power}")).unwrap_or_default())
    }
}

proptest! {
    #[test]
    fn values_agree_with_the_library(text in written()) {
        prop_assert_eq!(decimal(&text).to_f64(), text.parse::<f64>().unwrap());
    }

    #[test]
    fn reading_inverts_printing(text in written()) {
        let value = decimal(&text);
        prop_assert_eq!(value.to_string(), decimal(&value.to_string()).to_string());
        prop_assert_eq!(value, decimal(&value.to_string()));
        for mark in [DecimalMark::Point, DecimalMark::Comma] {
            let people = value.text(mark);
            match Decimal::read(&people, mark) {
                Ok(read) => prop_assert_eq!(read, (value, people.len())),
                Err(error) => prop_assert!(false, "{}: {}", people, error),
            }
        }
    }

    #[test]
    fn pairs_hold_what_is_left(text in written()) {
        let value = decimal(&text);
        let (high, low) = value.to_pair();
        prop_assert_eq!(high, value.to_f64());
        prop_assert_eq!(high + low, high);
        // With the exact value of the first number, the decimal leaves the second, to 30 digits and more.
        let (Some(exact), Some(rest)) = (Decimal::rounded(high, 30), Decimal::rounded(low, 15)) else { return Ok(()) };
        if let Some(left) = value.checked_sub(exact).filter(|_| exact.to_pair().1 == 0.0 && low != 0.0) {
            let difference = (left.to_f64() - rest.to_f64()).abs();
            prop_assert!(difference <= 1e-14 * low.abs(), "{} {}", left, rest);
        }
    }

    #[test]
    fn shortest_reads_back(value in any::<f64>()) {
        if let Some(shortest) = Decimal::shortest(value) {
            prop_assert_eq!(shortest.to_f64(), value);
            prop_assert_eq!(Decimal::rounded(value, 17).unwrap().to_f64(), value);
        }
    }

    #[test]
    fn any_text_is_read_or_refused_in_place(text in any::<String>()) {
        for error in [Decimal::parse(&text).err(), Decimal::read(&text, DecimalMark::Point).err()].into_iter().flatten() {
            prop_assert!(text.get(error.span).is_some());
        }
    }

    #[test]
    fn order_is_that_of_the_values(a in "-?[0-9]{1,20}([.][0-9]{1,9})?(e-?[0-9]{1,2})?", b in "-?[0-9]{1,20}([.][0-9]{1,9})?") {
        let (a, b) = (decimal(&a), decimal(&b));
        match a.to_f64().total_cmp(&b.to_f64()) {
            Ordering::Equal => {}
            order if a.to_f64() != b.to_f64() => prop_assert_eq!(a.cmp(&b), order),
            _ => {}
        }
        prop_assert_eq!(a.cmp(&b), b.cmp(&a).reverse());
    }

    #[test]
    fn sums_and_differences_undo_each_other(a in -1_000_000_i32.., b in -1_000_000_i32.., places in 0_u32..9) {
        let small = |number: i32| Decimal::from(number).checked_mul(decimal(&format!("1e-{places}"))).unwrap();
        let (a, b) = (small(a), small(b));
        prop_assert_eq!(a.checked_add(b).unwrap().checked_sub(b), Some(a));
    }
}
