//! The mark that a program reads from a scanned page: which sheet it belongs to, and which of its pages it is.
//!
//! It is a QR code of version 1 with the highest error correction, 21 modules wide, so that it fits beside the text in the
//! margin of a page in modules of 0.6 mm. Its seven bytes are the number of the variant in five, the page in seven bits
//! and in the last one whether it is the last page, and a check. They hold no more than what is printed in words at the
//! foot of the page.
//!
//! All codes have the same mask and the check is linear, so the modules of any page are those of page 0 with the
//! modules of its bits inverted: the typesetter, which alone knows the page, needs no more than a table.

use crate::seed::Variant;

/// Which page of which sheet a page is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ScanMark {
    /// The variant, whose code is on the sheet.
    pub variant: Variant,
    /// The page, from 1; 0 where nobody knew.
    pub page: u8,
    /// Whether it is known to be the last one.
    pub is_last: bool,
}

/// Rows of modules; in each, bit `x` is set where the module in column `x` is dark.
pub type Modules = [u32; ScanMark::WIDTH];

/// What the bytes of a mark are told from those of other codes by; another layout of them would have another number.
const LAYOUT: u8 = 0x56;

/// Bytes of a mark, without those that correct errors.
const BYTES: usize = 7;

/// Bytes that correct errors.
const CORRECTION: usize = 17;

impl ScanMark {
    /// Modules on a side.
    pub const WIDTH: usize = 21;

    /// The highest page that a mark can name.
    pub const MAX_PAGE: u8 = 127;

    /// Its bytes.
    pub fn bytes(self) -> [u8; BYTES] {
        let [.., a, b, c, d, e] = self.variant.number().to_be_bytes();
        let page = self.page.min(Self::MAX_PAGE) << 1 | u8::from(self.is_last);
        let bytes = [a, b, c, d, e, page];
        [a, b, c, d, e, page, check(&bytes)]
    }

    /// The mark with these bytes, if they are those of a mark.
    pub fn read(bytes: &[u8]) -> Option<Self> {
        let &[a, b, c, d, e, page, sum] = bytes else {
            return None;
        };
        if check(&[a, b, c, d, e, page]) != sum {
            return None;
        }
        Some(Self {
            variant: Variant::new(u64::from_be_bytes([0, 0, 0, a, b, c, d, e]))?,
            page: page >> 1,
            is_last: page & 1 == 1,
        })
    }

    /// What is printed.
    pub fn modules(self) -> Modules {
        drawn(&codewords(&self.bytes()))
    }

    /// The modules that are inverted by each bit of the page, from the one that says that it is the last.
    pub fn page_bits() -> [Modules; 8] {
        let plain = drawn(&codewords(&[0; BYTES]));
        std::array::from_fn(|bit| {
            let mut bytes = [0, 0, 0, 0, 0, 1 << bit, 0];
            // The check without its constant part, which the plain mark has already.
            bytes[6] = check(&bytes[..6]) ^ check(&[0; 6]);
            let changed = drawn(&codewords(&bytes));
            std::array::from_fn(|row| changed[row] ^ plain[row])
        })
    }
}

/// CRC-8 of the polynomial 0x07, begun with the layout.
fn check(bytes: &[u8]) -> u8 {
    bytes.iter().fold(LAYOUT, |sum, byte| {
        (0..8).fold(sum ^ byte, |sum, _| {
            sum << 1 ^ if sum & 0x80 == 0 { 0 } else { 0x07 }
        })
    })
}

/// The data as bytes of a code, and those that correct errors.
fn codewords(bytes: &[u8; BYTES]) -> [u8; 2 + BYTES + CORRECTION] {
    let mut words = [0; 2 + BYTES + CORRECTION];
    // Four bits for bytes, eight for their number, the bytes, and four for the end.
    let mut left = 0x40 | BYTES as u8 >> 4;
    let mut rest = (BYTES as u8) << 4;
    for (at, byte) in bytes.iter().enumerate() {
        words[at] = left;
        left = rest | byte >> 4;
        rest = byte << 4;
    }
    words[BYTES] = left;
    words[BYTES + 1] = rest;
    let correction = remainder(&words[..BYTES + 2]);
    words[BYTES + 2..].copy_from_slice(&correction);
    words
}

/// The remainder of a division by the generator of Reed and Solomon, the product of all x − 2ⁱ.
fn remainder(data: &[u8]) -> [u8; CORRECTION] {
    let mut divisor = [0; CORRECTION];
    divisor[CORRECTION - 1] = 1;
    let mut root = 1;
    for _ in 0..CORRECTION {
        for at in 0..CORRECTION {
            let next = divisor.get(at + 1).copied().unwrap_or(0);
            divisor[at] = product(divisor[at], root) ^ next;
        }
        root = product(root, 2);
    }
    data.iter().fold([0; CORRECTION], |rest, byte| {
        let factor = byte ^ rest[0];
        std::array::from_fn(|at| {
            rest.get(at + 1).copied().unwrap_or(0) ^ product(divisor[at], factor)
        })
    })
}

/// The product in the field of 256 elements of QR codes.
fn product(a: u8, b: u8) -> u8 {
    (0..8).rev().fold(0, |sum: u8, bit| {
        let doubled = sum << 1 ^ if sum & 0x80 == 0 { 0 } else { 0x1d };
        doubled ^ if b >> bit & 1 == 1 { a } else { 0 }
    })
}

/// The modules of these bytes.
fn drawn(words: &[u8]) -> Modules {
    /// The highest error correction and mask 0, with the bits that correct them, from the highest.
    const FORMAT: u32 = 0b001_0110_1000_1001;
    const LAST: usize = ScanMark::WIDTH - 1;
    let mut rows = [0; ScanMark::WIDTH];
    let mut set = |x: usize, y: usize, is_dark: bool| rows[y] |= u32::from(is_dark) << x;
    for (left, top) in [(0, 0), (LAST - 6, 0), (0, LAST - 6)] {
        for y in 0..7_usize {
            for x in 0..7_usize {
                let ring = x.abs_diff(3).max(y.abs_diff(3));
                set(left + x, top + y, ring != 2);
            }
        }
    }
    for at in (8..=LAST - 8).step_by(2) {
        set(at, 6, true);
        set(6, at, true);
    }
    for bit in 0..15 {
        let is_dark = FORMAT >> bit & 1 == 1;
        match bit {
            0..6 => set(8, bit, is_dark),
            6 | 7 => set(8, bit + 1, is_dark),
            8 => set(7, 8, is_dark),
            _ => set(14 - bit, 8, is_dark),
        }
        if bit < 8 {
            set(LAST - bit, 8, is_dark);
        } else {
            set(8, LAST + bit - 14, is_dark);
        }
    }
    set(8, LAST - 7, true);
    let mut bits = words
        .iter()
        .flat_map(|word| (0..8).rev().map(move |bit| word >> bit & 1 == 1));
    for pair in 0..10 {
        // Column 6 is taken; pairs stand right and left of it, read upwards and downwards in turn.
        let right = if pair < 7 {
            LAST - 2 * pair
        } else {
            LAST - 1 - 2 * pair
        };
        for step in 0..=LAST {
            let y = if pair % 2 == 0 { LAST - step } else { step };
            for x in [right, right - 1] {
                let is_taken = y == 6 || y < 9 && (x < 9 || x > LAST - 8) || y > LAST - 8 && x < 9;
                if !is_taken {
                    let is_set = bits.next().unwrap_or(false);
                    set(x, y, is_set ^ ((x + y) % 2 == 0));
                }
            }
        }
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mark(number: u64, page: u8, is_last: bool) -> ScanMark {
        let variant = Variant::new(number).expect("it is below 2⁴⁰");
        ScanMark {
            variant,
            page,
            is_last,
        }
    }

    #[test]
    fn bytes_are_read_back_and_no_others() {
        for number in [0, 1, 0x12_3456_789a, Variant::COUNT - 1] {
            for (page, is_last) in [(0, false), (1, true), (17, false), (127, true)] {
                let mark = mark(number, page, is_last);
                let bytes = mark.bytes();
                assert_eq!(ScanMark::read(&bytes), Some(mark));
                for at in 0..56 {
                    let mut slip = bytes;
                    slip[at / 8] ^= 1 << (at % 8);
                    assert_eq!(ScanMark::read(&slip), None);
                }
            }
        }
        assert_eq!(ScanMark::read(b"https://example.org"), None);
        assert_eq!(ScanMark::read(&[]), None);
    }

    #[test]
    fn the_modules_of_a_page_follow_from_those_of_page_0() {
        let bits = ScanMark::page_bits();
        let plain = mark(0xab_cdef_0123, 0, false).modules();
        for page in [1, 2, 5, 64, 127] {
            for is_last in [false, true] {
                let mut modules = plain;
                let number = page << 1 | u8::from(is_last);
                for (bit, inverted) in bits.iter().enumerate() {
                    if number >> bit & 1 == 1 {
                        for (row, inverted) in modules.iter_mut().zip(inverted) {
                            *row ^= inverted;
                        }
                    }
                }
                assert_eq!(modules, mark(0xab_cdef_0123, page, is_last).modules());
            }
        }
    }

    #[test]
    fn the_generator_is_that_of_the_standard() {
        // The example of ISO/IEC 18004, annex I, has ten bytes; of 17, the logarithms of its table A.1.
        let logarithms: [u32; CORRECTION] = [
            43, 139, 206, 78, 43, 239, 123, 206, 214, 147, 24, 99, 150, 39, 243, 163, 136,
        ];
        let power = |exponent| (0..exponent).fold(1, |power, _| product(power, 2));
        // The remainder of x¹⁷ is the generator without its leading term.
        assert_eq!(remainder(&[1]), logarithms.map(power));
    }
}
