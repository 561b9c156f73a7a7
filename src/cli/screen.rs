//! What commands that ask print and read: wrapped text, with colour on a terminal, and lines that are typed.

use std::io::{BufRead, IsTerminal, Read, Write};
use std::sync::atomic::Ordering;

use super::Failure;

/// How a line is set off on a terminal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Tone {
    Plain,
    Bold,
    Faint,
    Good,
    Bad,
    Unsure,
}

/// Where a session is printed.
pub(crate) struct Screen {
    has_colour: bool,
}

/// Longest line that is read.
const MAX_LENGTH: u64 = 8 << 10;

/// Lines are no longer than this; what is longer is hard to read.
const WIDTH: usize = 78;

impl Screen {
    /// Standard output, in colour if it is a terminal.
    pub(crate) fn of_stdout() -> Self {
        #[expect(
            clippy::disallowed_methods,
            reason = "NO_COLOR is how a user asks for plain text: https://no-color.org"
        )]
        let is_plain = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
        Self {
            has_colour: std::io::stdout().is_terminal() && !is_plain,
        }
    }

    /// Prints a text, wrapped, each line moved in.
    pub(crate) fn say(&self, tone: Tone, indent: &str, text: &str) {
        for line in wrapped(text, WIDTH - indent.len()) {
            let line = format!("{indent}{line}");
            super::print_toned(&self.toned(tone, line.trim_end()));
        }
    }

    /// An empty line.
    pub(crate) fn gap() {
        println!();
    }

    /// Asks for a line, without the blanks around it; none at the end of the input.
    ///
    /// There is none either where nobody sees what is asked: input without end would be answered for ever.
    pub(crate) fn ask(&self, prompt: &str) -> Result<Option<String>, Failure> {
        let mut out = std::io::stdout().lock();
        let asked = write!(out, "{}", self.toned(Tone::Bold, prompt));
        super::note(asked.and_then(|()| out.flush()));
        drop(out);
        if super::IS_UNHEARD.load(Ordering::Relaxed) {
            return Ok(None);
        }
        let mut line = Vec::new();
        let mut input = std::io::stdin().lock().take(MAX_LENGTH);
        let length = input
            .read_until(b'\n', &mut line)
            .map_err(|error| Failure::new(format!("cannot read standard input: {error}")))?;
        let text = typed(&String::from_utf8_lossy(&line));
        let text = text.trim();
        if !std::io::stdin().is_terminal() {
            // In a transcript the answer stands where it would have been typed.
            println!("{}", text.replace(char::is_control, " "));
        } else if length == 0 {
            println!();
        }
        Ok((length > 0).then(|| text.to_owned()))
    }

    fn toned(&self, tone: Tone, text: &str) -> String {
        let code = match tone {
            _ if !self.has_colour || text.is_empty() => return text.to_owned(),
            Tone::Plain => return text.to_owned(),
            Tone::Bold => 1,
            Tone::Faint => 2,
            Tone::Good => 32,
            Tone::Bad => 31,
            Tone::Unsure => 33,
        };
        format!("\u{1b}[{code}m{text}\u{1b}[0m")
    }
}

/// A line as it was meant: what arrows and other keys of a terminal send is no part of it.
fn typed(line: &str) -> String {
    let mut text = String::with_capacity(line.len());
    let mut rest = line.chars().peekable();
    while let Some(char) = rest.next() {
        if char != '\u{1b}' {
            text.push(char);
            continue;
        }
        if rest.next_if(|next| matches!(next, '[' | 'O')).is_some() {
            // Parameters, then the sign that ends it.
            while rest.next_if(|next| matches!(next, ' '..='?')).is_some() {}
            rest.next_if(|next| matches!(next, '@'..='~'));
        }
    }
    text
}

/// The lines of a text, broken between words; lines that are moved in, such as formulas, stay whole.
/// Control characters are left out, so that nothing that was typed can steer the terminal.
fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines = Vec::new();
    for line in text.lines() {
        let line: String = line.chars().filter(|char| !char.is_control()).collect();
        if line.starts_with("  ") || line.chars().count() <= width {
            lines.push(line);
            continue;
        }
        let mut current = String::new();
        for word in line.split(' ') {
            let length = current.chars().count() + 1 + word.chars().count();
            if !current.is_empty() && length > width {
                lines.push(std::mem::take(&mut current));
            }
            if !current.is_empty() {
                current.push(' ');
            }
            current.push_str(word);
        }
        lines.push(current);
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::{typed, wrapped};

    #[test]
    fn keys_that_write_nothing_are_no_part_of_a_line() {
        assert_eq!(typed("\u{1b}[A"), "");
        assert_eq!(typed("5\u{1b}[3~ m\u{1b}[1;5D/s\u{1b}OP"), "5 m/s");
        assert_eq!(typed("x [1]"), "x [1]");
        assert_eq!(typed("\u{1b}"), "");
    }

    #[test]
    fn words_stay_whole_and_formulas_stay_on_their_line() {
        assert_eq!(wrapped("one two three", 8), ["one two", "three"]);
        assert_eq!(wrapped("    ω = √(k/m)", 8), ["    ω = √(k/m)"]);
        assert_eq!(wrapped("a\n\nb", 8), ["a", "", "b"]);
        assert_eq!(wrapped("unbreakable", 4), ["unbreakable"]);
    }
}
