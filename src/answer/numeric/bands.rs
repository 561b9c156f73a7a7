//! The ranges in which numbers are right, half right, or a named mistake, in the order in which the marker tries them.

use super::marker::Numbers;
use super::target::Target;
use crate::answer::{Band, Credit};

/// Whole turns to either side of an angle without a stated interval that a list of ranges names.
const TURNS: i32 = 2;

/// The bands of each value that is asked; empty where the values come in any order.
pub(crate) fn bands(key: &Numbers) -> Vec<Vec<Band>> {
    if key.is_list && !key.is_ordered {
        return Vec::new();
    }
    let mut bands: Vec<Vec<Band>> = key.targets.iter().map(|own| right_at(key, own)).collect();
    if let [bands] = &mut bands[..] {
        let single = key.mistakes.iter().filter(|own| own.values.len() == 1);
        bands.extend(single.map(|mistake| {
            let target = key.of_mistake(mistake.values[0]);
            let unit = mistake.unit.unwrap_or(key.unit);
            Band {
                value: unit.of_si(target.value),
                half: unit.of_si(target.half + target.slack()).abs(),
                credit: mistake.credit,
                mistake: Some(mistake.number),
            }
        }));
    }
    bands
}

/// What is right around a value, and its whole turns.
fn right_at(key: &Numbers, target: &Target) -> Vec<Band> {
    let band = |value: f64| {
        let moved = Target { value, ..*target };
        Band {
            value: key.unit.of_si(value),
            half: key.unit.of_si(target.half + target.slack()).abs(),
            credit: if is_within(key, &moved) {
                Credit::FULL
            } else {
                Credit::half()
            },
            mistake: None,
        }
    };
    let Some(period) = key.modulo else {
        return vec![band(target.value)];
    };
    let mut bands: Vec<Band> = (-TURNS..=TURNS)
        .map(|turns| band(target.value + f64::from(turns) * period))
        .collect();
    // The first that fits counts: what is right comes before what is half right.
    crate::numerics::sort_by_key(&mut bands, |band| std::cmp::Reverse(band.credit));
    bands
}

/// Whether a value lies in the interval where it is asked.
fn is_within(key: &Numbers, target: &Target) -> bool {
    let slack = target.half + target.slack();
    key.within
        .is_none_or(|[low, high]| low - slack <= target.value && target.value <= high + slack)
}
