//! The command line of vibank.

use std::process::ExitCode;

mod cli;

fn main() -> ExitCode {
    cli::run()
}
