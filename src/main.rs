//! The command line of vibank.

use std::process::ExitCode;

mod cli;

/// Trees of formulas, texts and pages are many small pieces.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> ExitCode {
    cli::run()
}
