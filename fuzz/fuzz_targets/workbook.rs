#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    vibank_fuzz::targets::run("workbook", bytes);
});
