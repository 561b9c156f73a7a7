//! Ticks at round numbers, few enough to be read.

use crate::math::Math;
use crate::numerics::{log10, pow};
use crate::unit::DecimalMark;

/// A tick of an axis: where it stands, in the axis's own coordinate, and what is printed at it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tick {
    pub(crate) at: f64,
    pub(crate) label: Option<Math>,
}

/// Ticks and the power of ten that is taken out of their labels.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Ticks {
    pub(crate) ticks: Vec<Tick>,
    pub(crate) power: i32,
}

/// No axis has more.
const MAX_COUNT: usize = 60;

impl Ticks {
    /// Ticks at multiples of 1, 2 or 5 times a power of ten, about `count` of them.
    pub(crate) fn linear(range: [f64; 2], count: usize, mark: DecimalMark) -> Self {
        Self::stepped(
            range,
            round_step((range[1] - range[0]) / count as f64),
            mark,
        )
    }

    /// Ticks at the multiples of `step`.
    pub(crate) fn stepped(range: [f64; 2], step: f64, mark: DecimalMark) -> Self {
        let largest = range[0].abs().max(range[1].abs());
        let power = common_power(largest);
        let unit = pow(10.0, f64::from(power));
        let decimals = decimals(step / unit);
        Self {
            ticks: multiples(range, step)
                .map(|at| Tick {
                    at,
                    label: Some(number(at / unit, decimals, mark)),
                })
                .collect(),
            power,
        }
    }

    /// Ticks at multiples of a share of π, `step`.
    pub(crate) fn of_pi(range: [f64; 2], step: f64) -> Self {
        let pi = std::f64::consts::PI;
        let ticks = multiples(range, step).map(|at| Tick {
            at,
            label: Some(share_of_pi(at / pi)),
        });
        Self {
            ticks: ticks.collect(),
            power: 0,
        }
    }

    /// Ticks of a logarithmic axis, whose coordinate is the decimal logarithm: the powers of ten labelled.
    pub(crate) fn logarithmic(range: [f64; 2], mark: DecimalMark) -> Self {
        let decades = range[1] - range[0];
        let mut ticks = Vec::new();
        let first = range[0].floor();
        let mut decade = first;
        while decade <= range[1] && ticks.len() < MAX_COUNT {
            for digit in 1..10 {
                let at = decade + log10(f64::from(digit));
                // In so short a range there are one or two powers of ten, by which nobody reads a scale.
                let is_labelled = digit == 1 || (decades < 1.5 && [2, 5].contains(&digit));
                if at >= range[0] - SLACK && at <= range[1] + SLACK && (decades < 4.0 || digit == 1)
                {
                    let label = is_labelled.then(|| decimal(decade, digit, mark));
                    ticks.push(Tick { at, label });
                }
            }
            decade += 1.0;
        }
        Self { ticks, power: 0 }
    }
}

/// What rounding may move a tick at the end of a range.
const SLACK: f64 = 1e-9;

/// The multiples of a step in a range.
fn multiples(range: [f64; 2], step: f64) -> impl Iterator<Item = f64> {
    let slack = SLACK * (range[1] - range[0]);
    let first = ((range[0] - slack) / step).ceil();
    let last = ((range[1] + slack) / step).floor();
    let count = if step > 0.0 && last >= first {
        ((last - first) as usize).saturating_add(1)
    } else {
        0
    };
    (0..count.min(MAX_COUNT)).map(move |place| {
        let at = (first + place as f64) * step;
        // A multiple may come out as a negative zero, which would be printed with its sign.
        if at == 0.0 { 0.0 } else { at }
    })
}

/// The least of 1, 2, 5 times a power of ten that is not less than `least`.
fn round_step(least: f64) -> f64 {
    if !(least.is_finite() && least > 0.0) {
        return 1.0;
    }
    let power = pow(10.0, log10(least).floor());
    let share = least / power;
    let factor = [1.0, 2.0, 5.0]
        .into_iter()
        .find(|factor| share <= factor * (1.0 + SLACK));
    factor.unwrap_or(10.0) * power
}

/// The power of ten, a multiple of three, that labels are freed of where they would be long.
fn common_power(largest: f64) -> i32 {
    if largest >= 1e4 || (largest < 0.02 && largest > 0.0) {
        // By threes, so that the power with the unit is one with a prefix: 10⁻³ m is mm.
        3 * (log10(largest) / 3.0).floor() as i32
    } else {
        0
    }
}

/// How many decimals the multiples of a step need.
fn decimals(step: f64) -> usize {
    let mut decimals = 0;
    let mut scaled = step;
    while decimals < 12 && (scaled - scaled.round()).abs() > 1e-6 * scaled {
        scaled *= 10.0;
        decimals += 1;
    }
    decimals
}

/// A number with this many decimals, typeset.
fn number(value: f64, decimals: usize, mark: DecimalMark) -> Math {
    let digits = format!("{:.decimals$}", value.abs());
    if digits.chars().all(|letter| matches!(letter, '0' | '.')) {
        return Math::number("0");
    }
    let digits = match mark {
        DecimalMark::Comma => digits.replace('.', ","),
        DecimalMark::Point => digits,
    };
    if value < 0.0 {
        Math::row([Math::prefix("−"), Math::number(digits)])
    } else {
        Math::number(digits)
    }
}

/// `0`, `π`, `−π/2`, `3π/4`.
fn share_of_pi(share: f64) -> Math {
    let denominator = (1..=12).find(|below| {
        let above = share * f64::from(*below);
        (above - above.round()).abs() < 1e-6
    });
    let denominator = denominator.unwrap_or(1);
    let above = (share * f64::from(denominator)).round() as i64;
    if above == 0 {
        return Math::number("0");
    }
    let mut row = Vec::new();
    if above < 0 {
        row.push(Math::prefix("−"));
    }
    if above.abs() != 1 {
        row.push(Math::number(above.abs().to_string()));
    }
    row.push(Math::letter('π'));
    if denominator != 1 {
        row.push(Math::operator("/", crate::math::Class::Ordinary));
        row.push(Math::number(denominator.to_string()));
    }
    Math::row(row)
}

/// `10^decade` times a digit: as a decimal where it is short, else as a power.
fn decimal(decade: f64, digit: i32, mark: DecimalMark) -> Math {
    let power = decade as i32;
    if (-2..=3).contains(&power) {
        let value = f64::from(digit) * pow(10.0, decade);
        return number(value, (-power).max(0) as usize, mark);
    }
    let ten = power_of_ten(power);
    if digit == 1 {
        ten
    } else {
        Math::row([Math::number(digit.to_string()), Math::binary("⋅"), ten])
    }
}

/// `10³`.
pub(crate) fn power_of_ten(power: i32) -> Math {
    let digits = Math::number(power.abs().to_string());
    let exponent = if power < 0 {
        Math::row([Math::prefix("−"), digits])
    } else {
        digits
    };
    Math::number("10").with_sup(exponent)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(ticks: &Ticks) -> Vec<String> {
        let labels = ticks.ticks.iter().filter_map(|tick| tick.label.as_ref());
        labels.map(Math::plain).collect()
    }

    #[test]
    fn ticks_stand_at_round_numbers_with_as_many_decimals_as_they_need() {
        let ticks = |low, high| labels(&Ticks::linear([low, high], 6, DecimalMark::Point));
        assert_eq!(ticks(0.0, 2.1), ["0", "0.5", "1.0", "1.5", "2.0"]);
        assert_eq!(ticks(-1.0, 1.0), ["−1.0", "−0.5", "0", "0.5", "1.0"]);
        assert_eq!(ticks(0.0, 30.0), ["0", "5", "10", "15", "20", "25", "30"]);
    }

    #[test]
    fn powers_of_ten_are_taken_out_of_long_labels() {
        let ticks = Ticks::linear([0.0, 3e-4], 6, DecimalMark::Comma);
        assert_eq!(ticks.power, -6);
        assert_eq!(labels(&ticks)[1], "50");
        assert_eq!(
            Ticks::linear([0.0, 25_000.0], 5, DecimalMark::Point).power,
            3
        );
    }

    #[test]
    fn shares_of_pi_are_named() {
        let pi = std::f64::consts::PI;
        let ticks = Ticks::of_pi([-pi, pi], pi / 2.0);
        assert_eq!(labels(&ticks), ["−π", "−π/2", "0", "π/2", "π"]);
    }

    #[test]
    fn a_logarithmic_axis_names_its_decades() {
        let ticks = Ticks::logarithmic([-1.0, 2.0], DecimalMark::Point);
        assert_eq!(labels(&ticks), ["0.1", "1", "10", "100"]);
        assert_eq!(ticks.ticks.len(), 28);
    }

    #[test]
    fn hostile_ranges_give_few_ticks_and_no_panic() {
        for range in [
            [0.0, 0.0],
            [1.0, 1.0 + 1e-15],
            [-1e300, 1e300],
            [0.0, 5e-324],
        ] {
            let ticks = Ticks::linear(range, 6, DecimalMark::Point);
            assert!(ticks.ticks.len() <= MAX_COUNT);
            let ticks = Ticks::stepped(range, 1e-9, DecimalMark::Point);
            assert!(ticks.ticks.len() <= MAX_COUNT);
        }
    }
}
