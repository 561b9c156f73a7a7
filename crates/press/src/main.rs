//! `vibank-press`: prints what `vibank` sends it through a pipe.

use std::io::{self, IsTerminal, Write};
use std::process::ExitCode;

use vibank_press::{Job, Reply, greeting, print};

/// What is laid out is many small pieces.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

const HELP: &str = "\
Prints the pages of vibank as PDF. `vibank sheet` starts it where it is needed: keep it beside the program `vibank`, on
the PATH, or name it in VIBANK_PRESS.

Usage: vibank-press [--version | --help]
";

fn main() -> ExitCode {
    let (mut out, input) = (io::stdout().lock(), io::stdin().lock());
    let greeting = greeting();
    // A reader that has left, as `head` does, is no failure.
    let shown = match std::env::args().nth(1).as_deref() {
        Some("--version" | "-V") => {
            writeln!(out, "vibank-press {} {}", greeting.version, greeting.digest)
        }
        None if !input.is_terminal() => {
            let _ = serve(input, out);
            return ExitCode::SUCCESS;
        }
        None | Some("--help" | "-h") => out.write_all(HELP.as_bytes()),
        Some(_) => {
            let _ = io::stderr().lock().write_all(HELP.as_bytes());
            return ExitCode::from(2);
        }
    };
    let _ = shown;
    ExitCode::SUCCESS
}

/// Greets, then prints the jobs that arrive until there is none; ends where the pipe does.
fn serve(mut jobs: impl io::Read, mut replies: impl Write) -> io::Result<()> {
    greeting().send(&mut replies)?;
    while let Some(job) = Job::receive(&mut jobs)? {
        let reply = match print(job) {
            Ok(file) => Reply::File(file),
            Err(message) => Reply::Refused(message),
        };
        reply.send(&mut replies)?;
    }
    Ok(())
}
