//! PDF files come from `vibank-press`, a program of its own: it alone carries the typesetter.
//!
//! The press is looked for once a run. It works in processes that take one job after the other, as many as threads print,
//! each of which gives way to a new one after some jobs: what a typesetter keeps from text to text never shrinks, so memory
//! stays flat, however many sheets there are. A process that dies, hangs or answers with nonsense is replaced once for a
//! job; a job that fails again is refused, and the run goes on without its file.

mod printer;

use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, PoisonError};

use vibank_press_protocol::{Job, PROTOCOL, Reply};

use self::printer::Printer;
use super::Failure;
use super::program::{self, Found};

/// The program.
const NAME: &str = "vibank-press";

/// Names the press; empty, there is none.
const VARIABLE: &str = "VIBANK_PRESS";

/// Jobs after which a process is replaced: in 48 pages it grows by some 100 MB.
const JOBS: usize = 48;

/// A press, ready to work.
pub(crate) struct Press {
    program: PathBuf,
    digest: String,
    idle: Mutex<Vec<Printer>>,
}

/// Why there is no press.
#[derive(Clone, Debug)]
pub(crate) enum Missing {
    /// None was found.
    Nowhere,
    /// One was found that cannot be used.
    Unusable {
        /// Path of the program that was started.
        program: PathBuf,
        /// What is wrong with it.
        why: String,
    },
}

/// A file, or why there is none.
pub(crate) type Printed = Result<Vec<u8>, String>;

impl Press {
    /// The press of this machine: the one that `VIBANK_PRESS` names, else the one beside the program, else the first
    /// one on the PATH, which is mentioned, since it may be another version's.
    pub(crate) fn find() -> Result<Self, Missing> {
        match program::find(NAME, VARIABLE) {
            None => Err(Missing::Nowhere),
            Some(Found::Own(program)) => Self::at(program),
            Some(Found::OnPath(program)) => {
                let press = Self::at(program)?;
                eprintln!("printing with `{}`", press.program.display());
                Ok(press)
            }
        }
    }

    /// The press at this path, if it greets as one of this version.
    fn at(program: PathBuf) -> Result<Self, Missing> {
        let unusable = |why: String| Missing::Unusable {
            program: program.clone(),
            why,
        };
        let (printer, greeting) =
            Printer::start(&program).map_err(|error| unusable(error.to_string()))?;
        if greeting.protocol != PROTOCOL {
            return Err(unusable(format!(
                "it speaks protocol {}, this program {PROTOCOL}",
                greeting.protocol
            )));
        }
        let own = env!("CARGO_PKG_VERSION");
        if greeting.version != own {
            return Err(unusable(format!(
                "it is version {}, this program {own}",
                greeting.version
            )));
        }
        Ok(Self {
            program,
            digest: greeting.digest,
            idle: Mutex::new(vec![printer]),
        })
    }

    /// A digest of everything in the press that shapes the bytes of a file.
    pub(crate) fn digest(&self) -> &str {
        &self.digest
    }

    /// The file of a page in Typst markup that may use these files of fonts.
    pub(crate) fn page(&self, text: String, fonts: &[String]) -> Printed {
        self.print(&Job::Page {
            text,
            fonts: fonts.to_vec(),
        })
    }

    /// A figure, given as SVG, as a file of its own size.
    pub(crate) fn figure(&self, svg: &str) -> Printed {
        self.print(&Job::Figure {
            svg: svg.to_owned(),
        })
    }

    fn print(&self, job: &Job) -> Printed {
        let mut lost = String::new();
        // A process that fails is replaced once, by a fresh one: what fails there as well fails for this job.
        for is_replaced in [false, true] {
            let idle = (!is_replaced).then(|| self.idle().pop()).flatten();
            let mut printer = match idle {
                Some(printer) => printer,
                None => match Printer::start(&self.program) {
                    // Files of two presses would differ within one run.
                    Ok((_, greeting)) if greeting.digest != self.digest => {
                        return Err(format!(
                            "the press `{}` was exchanged during the run: it was {}, and is {} now",
                            self.program.display(),
                            self.digest,
                            greeting.digest
                        ));
                    }
                    Ok((printer, _)) => printer,
                    Err(error) => return Err(format!("the press does not start: {error}")),
                },
            };
            match printer.print(job) {
                Ok(reply) => {
                    if printer.done() < JOBS {
                        self.idle().push(printer);
                    }
                    return match reply {
                        Reply::File(bytes) => Ok(bytes),
                        Reply::Refused(message) => Err(message),
                    };
                }
                Err(error) if error.kind() == std::io::ErrorKind::InvalidInput => {
                    return Err(error.to_string());
                }
                Err(error) => lost = format!("the press failed twice: {error}"),
            }
        }
        Err(lost)
    }

    fn idle(&self) -> MutexGuard<'_, Vec<Printer>> {
        self.idle.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Missing {
    /// What it means for these formats, with the way out.
    pub(crate) fn failure(&self, formats: &str) -> Failure {
        let message = match self {
            Self::Nowhere => format!("there is no press here, which prints {formats}"),
            Self::Unusable { program, why } => format!(
                "the press `{}` cannot be used for {formats}: {why}",
                program.display()
            ),
        };
        Failure::new(message).help(Self::WAY_OUT)
    }

    /// How to come to a press.
    pub(crate) const WAY_OUT: &'static str = "build it by `cargo build --release -p vibank-press` or take it from the release of this version, and keep it beside `vibank` or name it in VIBANK_PRESS";
}
