//! A quick hash for the tables of a translation.
//!
//! The keys are small numbers that the translation itself gives out, and formulas are bounded, so that nobody gains
//! by collisions.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

/// A table whose keys are made of small numbers.
pub(crate) type NumberTable<K, V> = HashMap<K, V, BuildHasherDefault<Mixing>>;

/// Each number is mixed in by a turn, an exclusive or and a product.
#[derive(Default)]
pub(crate) struct Mixing(u64);

impl Mixing {
    fn mix(&mut self, number: u64) {
        // 2⁶⁴ divided by the golden ratio, odd.
        const FACTOR: u64 = 0x9e37_79b9_7f4a_7c15;
        self.0 = (self.0.rotate_left(5) ^ number).wrapping_mul(FACTOR);
    }
}

impl Hasher for Mixing {
    fn write(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.mix(u64::from(*byte));
        }
    }

    fn write_u8(&mut self, number: u8) {
        self.mix(u64::from(number));
    }

    fn write_u32(&mut self, number: u32) {
        self.mix(u64::from(number));
    }

    fn write_i32(&mut self, number: i32) {
        self.mix(u64::from(number.cast_unsigned()));
    }

    fn write_u64(&mut self, number: u64) {
        self.mix(number);
    }

    fn write_usize(&mut self, number: usize) {
        self.mix(number as u64);
    }

    fn write_isize(&mut self, number: isize) {
        self.mix(number as u64);
    }

    /// The upper half, which is mixed best, also in the lower bits, by which a table is entered.
    fn finish(&self) -> u64 {
        self.0 ^ self.0 >> 32
    }
}
