use super::*;

#[test]
fn order_looks_at_both_parts() {
    let above = Dd::sum(1.0, 1e-20);
    assert!(above > Dd::ONE);
    assert!(-above < -Dd::ONE);
    assert!(Dd::NAN.partial_cmp(&Dd::ONE).is_none());
}

#[test]
fn rounding_looks_at_both_parts() {
    assert_eq!(Dd::sum(5.0, -1e-20).floor(), Dd::from(4.0));
    assert_eq!(Dd::sum(5.0, 1e-20).ceil(), Dd::from(6.0));
    assert_eq!(Dd::sum(1e17, 2.5).round(), Dd::sum(1e17, 3.0));
}

#[test]
fn square_roots_hold_at_the_ends_of_the_exponent_range() {
    for x in [2e-308, 3e-200, 2.0, 1e300, 1.7e308] {
        let root = Dd::from(x).sqrt();
        assert!(
            (root.square().scale(-2) - Dd::from(x).scale(-2)).abs() <= Dd::from(x * 1e-31),
            "{x}"
        );
    }
    assert_eq!(Dd::ZERO.sqrt(), Dd::ZERO);
    assert!(Dd::from(-1.0).sqrt().is_nan());
    assert_eq!(Dd::from(f64::INFINITY).sqrt().hi(), f64::INFINITY);
}

#[test]
fn integers_are_exact() {
    let n = i64::MAX;
    assert_eq!(
        Dd::from_integer(n),
        Dd::sum(9_223_372_036_854_775_808.0, -1.0)
    );
    assert_eq!(Dd::from_integer(-3), Dd::from(-3.0));
}

#[test]
fn limits_of_exponentials_are_those_of_single_numbers() {
    assert_eq!(Dd::from(1e3).exp().hi(), f64::INFINITY);
    assert_eq!(Dd::from(-1e3).exp().hi(), 0.0);
    assert_eq!(Dd::from(-1e3).expm1().hi(), -1.0);
    assert!(Dd::NAN.exp().is_nan());
    assert_eq!(Dd::ZERO.ln().hi(), f64::NEG_INFINITY);
    assert!(Dd::from(-1.0).ln().is_nan());
    assert_eq!(Dd::from(0.0).pow(Dd::from(-0.5)).hi(), f64::INFINITY);
    assert_eq!(Dd::from(2.0).powi(-1074).hi(), 5e-324);
}

#[test]
fn subnormal_arguments_have_logarithms() {
    let x = Dd::from(5e-324).ln();
    assert!((x + Dd::LN_2 * 1074.0).abs().hi() < 1e-28);
}

#[test]
fn axes_have_exact_angles() {
    assert_eq!(Dd::atan2(Dd::ONE, Dd::ZERO), Dd::FRAC_PI_2);
    assert_eq!(Dd::atan2(Dd::ZERO, -Dd::ONE), Dd::PI);
    assert_eq!(Dd::ONE.acos(), Dd::ZERO);
    assert_eq!((-Dd::ONE).asin(), -Dd::FRAC_PI_2);
    assert_eq!(Dd::from(f64::INFINITY).atan(), Dd::FRAC_PI_2);
    assert!(Dd::from(1.5).asin().is_nan());
    assert!(Dd::from(f64::INFINITY).sin().is_nan());
}

#[test]
fn rounded_phases_agree_with_the_full_ones() {
    for n in 0..2000 {
        let phase = Dd::PI * Dd::from(f64::from(n)).square() * 1e7 + 0.1 * f64::from(n);
        let (sine, cosine) = phase.sin_cos();
        let (rounded_sine, rounded_cosine) = phase.sin_cos_to_f64();
        assert!((sine - rounded_sine).abs().hi() < 1.5e-16, "{phase:?}");
        assert!((cosine - rounded_cosine).abs().hi() < 1.5e-16, "{phase:?}");
    }
}

#[test]
fn limits_of_hyperbolic_functions_are_those_of_single_numbers() {
    assert_eq!(Dd::from(-800.0).sinh().hi(), f64::NEG_INFINITY);
    assert!((Dd::from(710.0).cosh().hi() / 1.116_997_383_080_855_5e308 - 1.0).abs() < 1e-15);
    assert_eq!(Dd::from(-1e300).tanh(), -Dd::ONE);
    assert_eq!(Dd::ONE.atanh().hi(), f64::INFINITY);
    assert!(Dd::from(0.5).acosh().is_nan());
    assert_eq!(Dd::from(3e300).hypot(Dd::from(4e300)).hi(), 5e300);
    assert_eq!(Dd::from(3e-320).hypot(Dd::ZERO).hi(), 3e-320);
}
