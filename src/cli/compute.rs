//! `vibank compute --jsonl`

use super::{Failure, Outcome, lines};

/// Answer bare numerical tasks of vibrations, one JSON object a line.
///
/// Example: echo '{"id":1,"task":"free_response","params":{"m":1,"c":0.1,"k":4,"x0":1,"v0":0,"t":2.5}}' | vibank compute --jsonl
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// Read requests from standard input, one a line.
    #[arg(long, required = true)]
    jsonl: bool,
}

pub(crate) fn run(_: &Arguments) -> Result<Outcome, Failure> {
    lines::answer(vibank::compute::answer)
}
