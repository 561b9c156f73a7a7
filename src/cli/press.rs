//! `vibank print`: finished texts become files in processes of their own.
//!
//! What makes a PDF of a text keeps tables from text to text that never shrink. So it works in child processes, as many as
//! threads print, each of which gives way to a new one after some texts: memory stays flat, however many sheets there are.
//! A text and its file pass through pipes, each after its length; before a file stands whether it is one, or a message.

use std::io::{self, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::{Mutex, MutexGuard, PoisonError};

use vibank::output::{self, Writer};

use super::{Failure, Outcome};

/// Texts after which a process is replaced.
const TEXTS: usize = 48;

/// Print texts for another run of the program.
#[derive(clap::Args)]
#[command(hide = true)]
pub(crate) struct Arguments {
    /// The format.
    format: String,
}

/// Prints the texts that arrive until there is none.
pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let writer = output::writer(&arguments.format)
        .ok_or_else(|| Failure::unknown_format(&arguments.format, &[]))?;
    let (mut texts, mut files) = (io::stdin().lock(), io::stdout().lock());
    // A run that has ended asks for nothing more, and nobody is left to be told.
    while let Ok(text) = receive(&mut texts) {
        let text = String::from_utf8_lossy(&text).into_owned();
        let (is_file, bytes) = match writer.bind(text) {
            Ok(file) => (true, file),
            Err(error) => (false, error.to_string().into_bytes()),
        };
        let sent = files
            .write_all(&[u8::from(is_file)])
            .and_then(|()| send(&mut files, &bytes));
        if sent.is_err() {
            break;
        }
    }
    Ok(Outcome::Done)
}

/// Makes the files of one format.
pub(crate) struct Press {
    writer: &'static dyn Writer,
    idle: Mutex<Vec<Printer>>,
}

impl Press {
    /// A press for the texts of a format.
    pub(crate) fn of(writer: &'static dyn Writer) -> Self {
        Self {
            writer,
            idle: Mutex::default(),
        }
    }

    /// The file of a finished text.
    pub(crate) fn bind(&self, text: String) -> Result<Vec<u8>, Failure> {
        let idle = self.idle().pop();
        let printer = idle.or_else(|| self.start());
        let Some(mut printer) = printer else {
            let file = self.writer.bind(text);
            return file.map_err(|error| Failure::new(error.to_string()));
        };
        let file = printer
            .print(&text)
            .map_err(|error| Failure::new(format!("a page cannot be printed: {error}")))?;
        if printer.done < TEXTS {
            self.idle().push(printer);
        }
        file.map_err(Failure::new)
    }

    /// A process, where one is worth it and can be had.
    fn start(&self) -> Option<Printer> {
        if self.writer.is_bound() {
            Printer::start(self.writer.name()).ok()
        } else {
            None
        }
    }

    fn idle(&self) -> MutexGuard<'_, Vec<Printer>> {
        self.idle.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A process that prints.
struct Printer {
    child: Child,
    /// Closed to end it.
    texts: Option<ChildStdin>,
    files: ChildStdout,
    done: usize,
}

impl Printer {
    fn start(format: &str) -> io::Result<Self> {
        let mut child = Command::new(std::env::current_exe()?)
            .args(["print", format])
            // The threads are those that wait for it.
            .env("RAYON_NUM_THREADS", "1")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()?;
        let texts = child.stdin.take();
        let files = child.stdout.take().ok_or(io::ErrorKind::BrokenPipe)?;
        Ok(Self {
            child,
            texts,
            files,
            done: 0,
        })
    }

    /// The file of a text, or the message that it cannot be printed; an error where the process is lost.
    fn print(&mut self, text: &str) -> io::Result<Result<Vec<u8>, String>> {
        self.done += 1;
        let texts = self.texts.as_mut().ok_or(io::ErrorKind::BrokenPipe)?;
        send(texts, text.as_bytes())?;
        let mut is_file = [0];
        self.files.read_exact(&mut is_file)?;
        let bytes = receive(&mut self.files)?;
        Ok(if is_file == [1] {
            Ok(bytes)
        } else {
            Err(String::from_utf8_lossy(&bytes).into_owned())
        })
    }
}

impl Drop for Printer {
    fn drop(&mut self) {
        self.texts = None;
        let _ = self.child.wait();
    }
}

/// Sends some bytes after their number.
fn send(pipe: &mut impl Write, bytes: &[u8]) -> io::Result<()> {
    pipe.write_all(&(bytes.len() as u64).to_le_bytes())?;
    pipe.write_all(bytes)?;
    pipe.flush()
}

/// The bytes that were sent.
fn receive(pipe: &mut impl Read) -> io::Result<Vec<u8>> {
    let mut length = [0; 8];
    pipe.read_exact(&mut length)?;
    let length = u64::from_le_bytes(length);
    let mut bytes = Vec::new();
    pipe.take(length).read_to_end(&mut bytes)?;
    if bytes.len() as u64 == length {
        Ok(bytes)
    } else {
        Err(io::ErrorKind::UnexpectedEof.into())
    }
}
