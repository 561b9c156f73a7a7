//! The functions of the module: bytes in, bytes out.
//!
//! A page calls `reserve(n)`, writes `n` bytes of UTF-8 there, and hands them over with `load` (the lines of
//! the page) or `ask` (one request). Both give back where the reply stands: its address in the upper and its
//! length in the lower half of 64 bits. The page copies it and calls `release`. The module imports
//! nothing and keeps one grader.
#![expect(
    unsafe_code,
    reason = "bytes cross the border of the module as an address and a length"
)]

use std::cell::RefCell;

use super::Grader;

thread_local! {
    static GRADER: RefCell<Option<Grader>> = const { RefCell::new(None) };
}

/// Room for this many bytes, which belongs to the caller until it is handed over.
#[unsafe(no_mangle)]
extern "C" fn reserve(length: usize) -> *mut u8 {
    Box::into_raw(vec![0_u8; length].into_boxed_slice()).cast()
}

/// Gives back what was reserved, or a reply.
///
/// # Safety
///
/// Address and length are those of one reservation or reply that was not given back yet.
#[unsafe(no_mangle)]
unsafe extern "C" fn release(start: *mut u8, length: usize) {
    // SAFETY: such a slice was boxed in `reserve` or `reply`.
    drop(unsafe { Box::from_raw(std::ptr::slice_from_raw_parts_mut(start, length)) });
}

/// Takes the lines of a page; the reply is empty, or says what is wrong.
///
/// # Safety
///
/// As for [`release`]; the bytes are handed over.
#[unsafe(no_mangle)]
unsafe extern "C" fn load(start: *mut u8, length: usize) -> u64 {
    // SAFETY: the caller's promise is the same.
    let lines = unsafe { taken(start, length) };
    let error = match Grader::of(&lines) {
        Ok(grader) => {
            GRADER.set(Some(grader));
            String::new()
        }
        Err(error) => error.to_string(),
    };
    reply(error)
}

/// Answers a request.
///
/// # Safety
///
/// As for [`release`]; the bytes are handed over.
#[unsafe(no_mangle)]
unsafe extern "C" fn ask(start: *mut u8, length: usize) -> u64 {
    // SAFETY: the caller's promise is the same.
    let request = unsafe { taken(start, length) };
    reply(GRADER.with_borrow(|grader| match grader {
        Some(grader) => grader.answer(&request),
        None => r#"{"error":"nothing is loaded"}"#.to_owned(),
    }))
}

/// # Safety
///
/// As for [`release`].
unsafe fn taken(start: *mut u8, length: usize) -> String {
    // SAFETY: such a slice was boxed in `reserve`.
    let bytes = unsafe { Box::from_raw(std::ptr::slice_from_raw_parts_mut(start, length)) };
    String::from_utf8_lossy(&bytes).into_owned()
}

fn reply(text: String) -> u64 {
    let bytes = text.into_bytes().into_boxed_slice();
    let length = bytes.len() as u64;
    let start = Box::into_raw(bytes).cast::<u8>() as usize as u64;
    start << 32 | length
}
