//! Commands that answer line by line: one JSON object in, one out, in order.

use std::borrow::Cow;
use std::io::{self, BufRead, Read, Write};

use super::{Failure, Outcome};

/// Longest line that is kept; of a longer one the rest is skipped, and its answer says so.
const MAX_LENGTH: usize = 5 << 20;

/// Answers each line of standard input on standard output; empty lines are skipped.
pub(crate) fn answer(mut reply: impl FnMut(&str) -> String) -> Result<Outcome, Failure> {
    let mut input = io::BufReader::new(io::stdin().lock());
    let mut output = io::BufWriter::new(io::stdout().lock());
    let mut line = Vec::new();
    loop {
        line.clear();
        if !take(&mut input, &mut line)
            .map_err(|error| Failure::new(format!("cannot read standard input: {error}")))?
        {
            break;
        }
        // What is text, as all requests are, is not gone through piece by piece.
        let text = match str::from_utf8(&line) {
            Ok(text) => Cow::Borrowed(text),
            Err(_) => String::from_utf8_lossy(&line),
        };
        let text = text.trim_matches(['\r', '\n', '\u{feff}']);
        if text.trim().is_empty() {
            continue;
        }
        // Who sends one request and waits for its reply gets it; those that wait together are answered together.
        let written = writeln!(output, "{}", reply(text)).and_then(|()| {
            if input.buffer().is_empty() {
                output.flush()
            } else {
                Ok(())
            }
        });
        match written {
            Err(error) if error.kind() == io::ErrorKind::BrokenPipe => return Ok(Outcome::Done),
            other => other.map_err(|error| Failure::new(format!("cannot write: {error}")))?,
        }
    }
    output
        .flush()
        .map_err(|error| Failure::new(format!("cannot write: {error}")))?;
    Ok(Outcome::Done)
}

/// Reads one line, keeping at most [`MAX_LENGTH`] bytes of it; `false` at the end.
fn take(input: &mut impl BufRead, line: &mut Vec<u8>) -> io::Result<bool> {
    let kept = input
        .by_ref()
        .take(MAX_LENGTH as u64)
        .read_until(b'\n', line)?;
    if kept == MAX_LENGTH && !line.ends_with(b"\n") {
        input.skip_until(b'\n')?;
    }
    Ok(kept > 0)
}
