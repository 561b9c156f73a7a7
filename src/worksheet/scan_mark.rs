//! The mark that a program reads from a scanned page: which sheet it belongs to, and which of its pages it is.
//!
//! It is a QR code of version 1 with the highest error correction, 21 modules wide, so that it fits beside the text in the
//! margin of a page in modules of 0.6 mm. Its seven bytes are the number of the variant in five, the page in seven bits
//! and in the last one whether it is the last page, and a check. They hold no more than what is printed in words at the
//! foot of the page.
//!
//! All codes have the same mask and the check is linear, so the modules of any page are those of page 0 with the
//! modules of its bits inverted: the typesetter, which alone knows the page, needs no more than a table.

use qrcodegen::{Mask, QrCode, QrCodeEcc, QrSegment, Version};

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

/// What distinguishes the bytes of a mark from those of other codes; another layout of them would have another number.
const LAYOUT: u8 = 0x56;

/// Bytes of a mark, without those that correct errors.
const BYTES: usize = 7;

impl ScanMark {
    /// Modules on a side.
    pub const WIDTH: usize = 21;

    /// The highest page that a mark can name.
    pub const MAX_PAGE: u8 = 127;

    /// What the code holds: variant, page, and a check over both.
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
        drawn(self.bytes())
    }

    /// The modules that are inverted by each bit of the page, from the one that says that it is the last.
    pub fn page_bits() -> [Modules; 8] {
        let plain = drawn([0; BYTES]);
        std::array::from_fn(|bit| {
            let mut bytes = [0, 0, 0, 0, 0, 1 << bit, 0];
            // The check without its constant part, which the plain mark has already.
            bytes[6] = check(&bytes[..6]) ^ check(&[0; 6]);
            let changed = drawn(bytes);
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

/// The modules of these bytes: always of one version, one correction and one mask, so that they are linear in the bytes.
fn drawn(bytes: [u8; BYTES]) -> Modules {
    let segment = QrSegment::make_bytes(&bytes);
    let version = Version::new(1);
    let code = QrCode::encode_segments_advanced(
        &[segment],
        QrCodeEcc::High,
        version,
        version,
        Some(Mask::new(0)),
        false,
    );
    let code = code.expect("seven bytes fit");
    std::array::from_fn(|y| {
        let dark = (0..ScanMark::WIDTH).filter(|x| code.get_module(*x as i32, y as i32));
        dark.map(|x| 1 << x).sum()
    })
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
}
