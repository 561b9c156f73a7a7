//! Reads the marks on scanned pages: QR codes of version 1 with bytes in them.
//!
//! A general reader of codes looks for clean rings in a page and gives up at a speckle in one. Here the mark is known: its
//! version, and its size within the bounds of a scan. So the page is blurred by about a fifth of a module, which wipes
//! out speckles; finder patterns are looked for in rows; and each module is the mean over its middle.
//!
//! Pages are untrusted: their size is bounded, and so is the number of places that are tried in one.

mod find;
mod grey;

pub use grey::{Grey, ReadError};

/// Bytes of a mark.
const BYTES: usize = 7;

/// The bytes of the mark on a page, if one is found: those of `vibank::worksheet::ScanMark`, which checks them.
pub fn mark(page: &Grey) -> Option<[u8; BYTES]> {
    let page = page.at_reading_size()?;
    find::mark(&page.blurred(1.0)).or_else(|| find::mark(&page.median().blurred(1.0)))
}
