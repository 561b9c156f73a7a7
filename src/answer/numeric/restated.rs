//! One value that is said more than once: in another unit, with more figures, as a fraction.

use super::read::{Setting, TypedNumber, statement};
use crate::response::{Part, Values};

/// The first of several statements that give one value, each in another unit, `0.314 (31.4 %)`, `2 Hz or 12.57 rad/s`, or
/// with more figures, of which the most count: `2 Hz (exactly 2.013 Hz)`. The same once more says nothing else only where
/// it cannot be a factor, `5 (5)`.
pub(crate) fn said_once(
    values: &Values<'_>,
    statements: &[Part],
    may_repeat: bool,
    setting: Setting<'_>,
) -> Option<TypedNumber> {
    let numbers = statements.iter().map(|part| {
        let number = statement(values, part, setting).ok();
        number.filter(|number| number.others.is_empty())
    });
    let mut numbers: Vec<TypedNumber> = numbers.collect::<Option<_>>()?;
    // The unit may be said with one of them, `x = 5, x = 5 mm`.
    let mut units = numbers.iter().map(|number| number.quantity.unit);
    let unit = units.find(|unit| !unit.dimension().is_pure());
    if let Some(unit) = unit {
        let bare = numbers.iter_mut().filter(|own| own.quantity.unit.is_one());
        bare.for_each(|own| *own = own.clone().with_unit(unit));
    }
    let (first, others) = numbers.split_first()?;
    let unit = first.quantity.unit;
    let mut most = first.clone();
    for other in others {
        let other = other.clone();
        let figures = |number: &TypedNumber| number.quantity.value.significant_figures();
        let is_same_unit = other.quantity.unit == unit;
        let is_longer = other.arithmetic.is_none() && figures(&other) > figures(&most);
        // `0.333 (1/3)`
        let is_exact = other.arithmetic.is_some();
        let is_same = may_repeat && other.quantity.value == first.quantity.value;
        let is_restated =
            !is_same_unit || first.arithmetic.is_none() && (is_exact || is_longer || is_same);
        if !is_restated || !is_same_but_for_rounding(first, &other) {
            return None;
        }
        if is_same_unit && is_longer {
            most = other;
        }
    }
    Some(most)
}

/// Whether two numbers can be one value that was rounded twice.
fn is_same_but_for_rounding(one: &TypedNumber, other: &TypedNumber) -> bool {
    // A value of one figure restates nothing.
    const COARSEST: f64 = 0.02;
    let half = |number: &TypedNumber| match &number.arithmetic {
        Some(_) => 0.0,
        None => 0.5 * number.quantity.value.last_place().to_f64(),
    };
    other
        .quantity
        .conversion(&one.quantity.unit)
        .is_ok_and(|conversion| {
            let (value, restated) = (
                one.quantity.si(),
                conversion.apply_decimal(&other.quantity.value),
            );
            let rounding =
                one.quantity.unit.to_si(half(one)).abs() + conversion.apply(half(other)).abs();
            let most = (1.000_001 * rounding).min(COARSEST * value.abs());
            (value - restated).abs() <= most + 1e-9 * value.abs()
        })
}
