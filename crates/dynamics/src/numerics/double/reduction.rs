//! Angles modulo a quarter turn, for any exponent.
//!
//! The angle over 2π is formed in fixed point with 320 fractional bits from as many bits of 2/π as the exponent asks
//! for, so the remainder keeps its full relative precision however many turns are taken off.
//!
//! # References
//!
//! M. H. Payne, R. N. Hanek, ACM SIGNUM Newsletter 18 (1983) 19.

use super::Dd;
use super::constants::TWO_OVER_PI;

// A mantissa of 53 bits spoils as many of the 320, which leaves 267. There are fewer than 2^128
// double-doubles, so that none is to be expected much closer than 2^-128 to a multiple of a quarter turn: the
// remainder still has its 106 bits.
const WORDS: usize = 5;

/// A fraction of a turn in two's complement, the leading word first; turns wrap around.
type TurnFraction = [u64; WORDS];

/// Quarter turns nearest to the angle, modulo four, and the angle that is left, in [-π/4, π/4].
pub(crate) fn quarter_turns(angle: Dd) -> (u8, Dd) {
    // Of the leading word, whose range of 2^64 is one turn.
    const EIGHTH: u64 = 1 << 61;
    if angle.abs() <= Dd::FRAC_PI_4 {
        return (0, angle);
    }
    if !angle.is_finite() {
        return (0, Dd::NAN);
    }
    let mut turn = sum(turn_of(angle.hi), turn_of(angle.lo));
    turn[0] = turn[0].wrapping_add(EIGHTH);
    let quarters = (turn[0] >> 62) as u8;
    turn[0] = (turn[0] & ((1 << 62) - 1)).wrapping_sub(EIGHTH);
    (quarters, signed(turn) * Dd::TAU)
}

/// x/(2π) modulo 1.
fn turn_of(x: f64) -> TurnFraction {
    let bits = x.to_bits();
    let exponent = ((bits >> 52) & 0x7ff) as i32;
    let fraction = bits & ((1 << 52) - 1);
    let (mantissa, exponent) = if exponent == 0 {
        (fraction, -1074)
    } else {
        (fraction | 1 << 52, exponent - 1075)
    };
    let turn = product(window(exponent - 2), mantissa);
    if x < 0.0 { negated(turn) } else { turn }
}

/// The fractional bits of 2^shift * 2/π.
fn window(shift: i32) -> TurnFraction {
    let (start, offset) = (shift.div_euclid(64), shift.rem_euclid(64) as u32);
    std::array::from_fn(|i| {
        let at = start + i as i32;
        let pair = u128::from(word(at)) << 64 | u128::from(word(at + 1));
        (pair << offset >> 64) as u64
    })
}

/// A word of 2/π, zero outside of it.
fn word(i: i32) -> u64 {
    usize::try_from(i)
        .ok()
        .and_then(|i| TWO_OVER_PI.get(i))
        .copied()
        .unwrap_or(0)
}

fn product(turn: TurnFraction, factor: u64) -> TurnFraction {
    let mut result = [0; WORDS];
    let mut carry = 0u128;
    for (out, word) in result.iter_mut().zip(turn).rev() {
        let wide = u128::from(word) * u128::from(factor) + carry;
        *out = wide as u64;
        carry = wide >> 64;
    }
    result
}

fn sum(a: TurnFraction, b: TurnFraction) -> TurnFraction {
    let mut result = [0; WORDS];
    let mut carry = false;
    for i in (0..WORDS).rev() {
        let (partial, first) = a[i].overflowing_add(b[i]);
        let (total, second) = partial.overflowing_add(u64::from(carry));
        result[i] = total;
        carry = first || second;
    }
    result
}

fn negated(turn: TurnFraction) -> TurnFraction {
    let mut one = [0; WORDS];
    one[WORDS - 1] = 1;
    sum(turn.map(|word| !word), one)
}

/// The fraction nearest to zero that the turn stands for.
fn signed(turn: TurnFraction) -> Dd {
    if turn[0] >> 63 == 1 {
        -unsigned(negated(turn))
    } else {
        unsigned(turn)
    }
}

/// Three words from the first that is not zero hold 128 bits at least.
fn unsigned(turn: TurnFraction) -> Dd {
    let first = turn.iter().position(|&word| word != 0).unwrap_or(WORDS);
    turn.iter()
        .enumerate()
        .skip(first)
        .take(3)
        .rev()
        .fold(Dd::ZERO, |total, (i, &word)| {
            let scale = -64 * (i as i32 + 1);
            total
                + Dd::from((word & 0xffff_ffff) as f64).scale(scale)
                + Dd::from((word >> 32) as f64).scale(scale + 32)
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_multiple_of_a_quarter_turn_nearest_to_it_keeps_its_remainder() {
        // The double that comes nearest to a multiple of π/2: J.-M. Muller, Elementary Functions, 3rd ed., table 11.1.
        let x = 6_381_956_970_095_103.0 * crate::numerics::powi(2.0, 797);
        let (quarters, rest) = quarter_turns(Dd::from(x));
        assert_eq!(quarters, 1);
        assert!(
            (rest.hi() / 4.687_165_924_254_628e-19 - 1.0).abs() < 1e-15,
            "{rest:?}"
        );
    }

    #[test]
    fn the_low_part_counts() {
        let (quarters, rest) = quarter_turns(Dd::TAU * 1e20 + 0.25);
        assert_eq!(quarters, 0);
        assert!((rest.hi() - 0.25).abs() < 1e-10);
    }
}
