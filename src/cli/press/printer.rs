//! One process of the press, and the time that it has for a job.

use std::io;
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread;
use std::time::Duration;

use vibank_press_protocol::{Greeting, Job, Reply};

/// A process has this long for a greeting and for any job: a page takes some 40 ms, and a slow machine may be ten times as
/// slow and busy.
const PATIENCE: Duration = Duration::from_mins(1);

/// Bytes of text for which it has a second more: a key table of 300 variants, 4 MB, takes less than a minute.
const BYTES_A_SECOND: usize = 20_000;

/// Bytes of text for which a job counts as one more: a sheet of some pages.
const BYTES_A_JOB: usize = 32_000;

/// Seconds of patience in place of [`PATIENCE`].
const VARIABLE: &str = "VIBANK_PRESS_SECONDS";

/// A process of the press.
pub(crate) struct Printer {
    child: Child,
    /// Jobs for the thread that talks with the process; closed to end both.
    jobs: Option<Sender<Job>>,
    replies: Receiver<io::Result<Reply>>,
    done: usize,
}

impl Printer {
    /// Starts the program; what it says of itself.
    ///
    /// # Errors
    ///
    /// Where it does not start, or does not greet in time.
    pub(crate) fn start(program: &Path) -> io::Result<(Self, Greeting)> {
        let mut child = Command::new(program)
            // The threads are those that wait for it.
            .env("RAYON_NUM_THREADS", "1")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()?;
        let (Some(texts), Some(files)) = (child.stdin.take(), child.stdout.take()) else {
            return Err(io::ErrorKind::BrokenPipe.into());
        };
        let (jobs, waiting) = channel();
        let (greet, greeted) = channel();
        let (answer, replies) = channel();
        // A pipe has no time limit: a thread waits at it, and the process is ended where it waits too long.
        thread::spawn(move || talk(texts, files, &waiting, &greet, &answer));
        let mut printer = Self {
            child,
            jobs: Some(jobs),
            replies,
            done: 0,
        };
        let greeting = printer.within(patience(0), &greeted)?;
        Ok((printer, greeting))
    }

    /// Jobs that it has taken, where a long one counts as several.
    pub(crate) fn done(&self) -> usize {
        self.done
    }

    /// The reply to a job; an error where the process is lost.
    pub(crate) fn print(&mut self, job: &Job) -> io::Result<Reply> {
        let (Job::Page { text, .. } | Job::Figure { svg: text }) = job;
        self.done += 1 + text.len() / BYTES_A_JOB;
        let limit = patience(text.len());
        let sent = self.jobs.as_ref().map(|jobs| jobs.send(job.clone()));
        if !matches!(sent, Some(Ok(()))) {
            return Err(io::ErrorKind::BrokenPipe.into());
        }
        let (_, closed) = channel();
        let replies = std::mem::replace(&mut self.replies, closed);
        let reply = self.within(limit, &replies);
        self.replies = replies;
        reply
    }

    /// What arrives in time; else the process is ended.
    fn within<T>(&mut self, limit: Duration, from: &Receiver<io::Result<T>>) -> io::Result<T> {
        match from.recv_timeout(limit) {
            Ok(arrived) => arrived,
            Err(RecvTimeoutError::Disconnected) => Err(io::ErrorKind::BrokenPipe.into()),
            Err(RecvTimeoutError::Timeout) => {
                let _ = self.child.kill();
                let message = format!("no answer in {} s", limit.as_secs());
                Err(io::Error::new(io::ErrorKind::TimedOut, message))
            }
        }
    }
}

impl Drop for Printer {
    fn drop(&mut self) {
        self.jobs = None;
        // One that has done its work ends with its pipe; one that is busy or confused is ended.
        for _ in 0..20 {
            if !matches!(self.child.try_wait(), Ok(None)) {
                return;
            }
            thread::sleep(Duration::from_millis(5));
        }
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Passes jobs and replies between the run and the process until one of them ends.
fn talk(
    mut texts: ChildStdin,
    mut files: ChildStdout,
    jobs: &Receiver<Job>,
    greet: &Sender<io::Result<Greeting>>,
    answer: &Sender<io::Result<Reply>>,
) {
    let greeting = Greeting::receive(&mut files);
    let is_greeted = greeting.is_ok();
    if greet.send(greeting).is_err() || !is_greeted {
        return;
    }
    while let Ok(job) = jobs.recv() {
        let reply = job
            .send(&mut texts)
            .and_then(|()| Reply::receive(&mut files));
        let is_lost = reply.is_err();
        if answer.send(reply).is_err() || is_lost {
            return;
        }
    }
}

/// How long a process may take for a text of this many bytes.
fn patience(bytes: usize) -> Duration {
    let least = crate::cli::setting(VARIABLE)
        .and_then(|seconds| seconds.to_str()?.parse().ok())
        .map_or(PATIENCE, Duration::from_secs);
    least + Duration::from_secs((bytes / BYTES_A_SECOND) as u64)
}
