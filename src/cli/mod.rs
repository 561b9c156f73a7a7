//! The command line: one file per command, and what they share.
//!
//! Results go to standard output, progress and reports to standard error.
//! Exit codes: 0 done, 1 findings or wrong answers, 2 misuse, 3 done but for what a press would have printed.

/// Prints a line to standard output; a reader that has left, as `head` does, is no failure.
macro_rules! println {
    () => {
        $crate::cli::print_line(format_args!(""))
    };
    ($($piece:tt)+) => {
        $crate::cli::print_line(format_args!($($piece)+))
    };
}

/// Prints a line to standard error, in the same way.
macro_rules! eprintln {
    ($($piece:tt)*) => {
        $crate::cli::print_error(&format!($($piece)*))
    };
}

mod bank;
mod check;
mod class_list;
mod completions;
mod compute;
mod course;
mod doubt;
mod enter;
mod explain;
mod export;
mod faces;
mod failure;
mod file_kind;
mod files;
mod filter;
mod folder;
mod forget;
mod form;
#[cfg(feature = "fuzzing")]
#[allow(
    missing_docs,
    unreachable_pub,
    reason = "a way for `fuzz/`, no interface"
)]
pub mod fuzz;
mod grade;
mod index;
mod journal_file;
mod lines;
mod list;
mod mark;
mod new;
mod package;
mod page;
mod platform;
mod practice;
mod press;
mod preview;
mod program;
mod progress;
mod record;
mod report;
mod responses;
mod saved;
mod scanner;
mod schema;
mod screen;
mod shard;
mod sheet;
mod show;
mod shown;
mod solve;
mod sort;
mod survey;
mod table;
mod watch;

use std::fmt;
use std::io::{self, IsTerminal as _, Write as _};
use std::process::ExitCode;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::{Parser, Subcommand};

pub(crate) use failure::{Failure, Outcome};

/// Problem bank and exercise generator for the physics of vibrations.
#[derive(Parser)]
#[command(
    name = "vibank",
    version,
    max_term_width = 100,
    arg_required_else_help = true
)]
#[command(after_help = "Begin with `vibank sheet examples/midterm.toml`.")]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    List(list::Arguments),
    Show(show::Arguments),
    Solve(solve::Arguments),
    Mark(mark::Arguments),
    Sheet(sheet::Arguments),
    Preview(preview::Arguments),
    Sort(sort::Arguments),
    Enter(enter::Arguments),
    Form(form::Arguments),
    Grade(grade::Arguments),
    Forget(forget::Arguments),
    Practice(practice::Arguments),
    Compute(compute::Arguments),
    Check(check::Arguments),
    Explain(explain::Arguments),
    New(new::Arguments),
    Page(page::Arguments),
    Course(course::Arguments),
    Export(export::Arguments),
    Schema(schema::Arguments),
    Completions(completions::Arguments),
}

/// How results are printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Format {
    /// For people.
    #[default]
    Text,
    /// For programs.
    Json,
}

/// Why something could not be printed, once it could not.
static UNPRINTED: OnceLock<String> = OnceLock::new();

/// Whether a line was lost, so that nobody sees what is asked.
static IS_UNHEARD: AtomicBool = AtomicBool::new(false);

/// Prints a line; what a full disk does not take is noted, and the program fails in the end.
///
/// On a terminal nothing in it does anything; a file or another program gets it as it is.
fn print_line(line: fmt::Arguments<'_>) {
    if io::stdout().is_terminal() {
        print_toned(&shown::still(&line.to_string()));
    } else {
        let mut out = io::stdout().lock();
        note(writeln!(out, "{line}").and_then(|()| out.flush()));
    }
}

/// Prints a line that may set colours.
fn print_toned(line: &str) {
    let mut out = io::stdout().lock();
    note(writeln!(out, "{line}").and_then(|()| out.flush()));
}

/// Notes whether something was printed.
fn note(printed: io::Result<()>) {
    let Err(error) = printed else {
        return;
    };
    IS_UNHEARD.store(true, Ordering::Relaxed);
    if error.kind() != io::ErrorKind::BrokenPipe {
        UNPRINTED.get_or_init(|| error.to_string());
    }
}

/// Prints a message, in which nothing steers the terminal; each of its lines may be long.
fn print_error(message: &str) {
    let mut error = io::stderr().lock();
    for line in message.split('\n') {
        let _ = writeln!(error, "{}", shown::shown(line));
    }
}

/// A variable of the environment.
#[expect(
    clippy::disallowed_methods,
    reason = "where the press and fonts are found, how long the press may take and how many threads work is the user's setting"
)]
fn setting(name: &str) -> Option<std::ffi::OsString> {
    std::env::var_os(name)
}

/// Runs the command that the arguments name.
pub(crate) fn run() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            let is_printed = match error.print() {
                Ok(()) => true,
                Err(error) => error.kind() == io::ErrorKind::BrokenPipe,
            };
            let is_asked = is_printed && !error.use_stderr();
            return ExitCode::from(if is_asked { 0 } else { 2 });
        }
    };
    if let Err(failure) = check_threads() {
        let _ = write!(io::stderr().lock(), "{failure}");
        return ExitCode::from(2);
    }
    let outcome = match arguments.command {
        Command::List(arguments) => list::run(&arguments),
        Command::Show(arguments) => show::run(&arguments),
        Command::Mark(arguments) => mark::run(&arguments),
        Command::Sort(arguments) => sort::run(&arguments),
        Command::Enter(arguments) => enter::run(&arguments),
        Command::Form(arguments) => form::run(&arguments),
        Command::Grade(arguments) => grade::run(&arguments),
        Command::Forget(arguments) => forget::run(&arguments),
        Command::Solve(arguments) => solve::run(&arguments),
        Command::Sheet(arguments) => sheet::run(&arguments),
        Command::Preview(arguments) => preview::run(arguments),
        Command::Practice(arguments) => practice::run(&arguments),
        Command::Compute(arguments) => compute::run(&arguments),
        Command::Check(arguments) => check::run(&arguments),
        Command::Explain(arguments) => explain::run(&arguments),
        Command::Completions(arguments) => completions::run(&arguments),
        Command::New(arguments) => new::run(&arguments),
        Command::Page(arguments) => page::run(&arguments),
        Command::Course(arguments) => course::run(&arguments),
        Command::Export(arguments) => export::run(&arguments),
        Command::Schema(arguments) => schema::run(&arguments),
    };
    match outcome {
        Ok(outcome) => match UNPRINTED.get() {
            Some(error) => {
                eprintln!("error: cannot write to standard output: {error}");
                ExitCode::from(2)
            }
            None => outcome.into(),
        },
        Err(failure) => {
            let _ = write!(std::io::stderr().lock(), "{failure}");
            ExitCode::from(2)
        }
    }
}

/// Refuses a number of threads that no machine has: `RAYON_NUM_THREADS` is read where work is shared out.
fn check_threads() -> Result<(), Failure> {
    const VARIABLE: &str = "RAYON_NUM_THREADS";
    let found = setting(VARIABLE).and_then(|value| value.to_str()?.trim().parse::<u64>().ok());
    match found {
        Some(found) if found > sheet::MAX_THREADS => Err(Failure::new(format!(
            "{VARIABLE} asks for {found} threads, at most {} are used",
            sheet::MAX_THREADS
        ))
        .help(format!(
            "unset {VARIABLE} for as many as the machine has processors"
        ))),
        _ => Ok(()),
    }
}

/// A number of things, in words.
pub(crate) fn counted(number: usize, thing: &str) -> String {
    let plural = match number {
        1 => "",
        _ if thing.ends_with('x') => "es",
        _ => "s",
    };
    format!("{number} {thing}{plural}")
}
