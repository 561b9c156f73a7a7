//! Serves the preview to the browsers of this computer, and to nobody else.
//!
//! It listens on 127.0.0.1 alone; each address holds a word that nobody can guess, since other users of the computer can
//! reach the port, too, and the page has the keys. A request by another name of the computer is refused, so that no page
//! of the web can ask under a name of its own.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

use crate::cli::Failure;

/// Most bytes of a request.
const MAX_LENGTH: u64 = 16 << 10;

/// How long a browser may take to ask, and to take an answer.
const PATIENCE: Duration = Duration::from_secs(10);

/// Requests that are answered at once; a page has one that waits and four others.
const MAX_AT_ONCE: usize = 64;

/// What is asked for: the last word of the address, and what comes after the question mark.
#[derive(Debug)]
pub(crate) struct Request {
    pub(crate) word: String,
    query: String,
}

/// What is sent.
pub(crate) struct HttpReply {
    pub(crate) kind: &'static str,
    pub(crate) policy: &'static str,
    pub(crate) body: Vec<u8>,
}

impl Request {
    /// The number after a name, `variant=3`.
    pub(crate) fn number(&self, name: &str) -> Option<u64> {
        let mut pairs = self
            .query
            .split('&')
            .filter_map(|pair| pair.split_once('='));
        let (_, value) = pairs.find(|(key, _)| *key == name)?;
        value.parse().ok()
    }
}

/// A server that listens.
pub(crate) struct Server {
    listener: TcpListener,
    word: String,
    port: u16,
}

impl Server {
    /// Listens on a port of this computer; on any that is free with port 0.
    pub(crate) fn listen(port: u16) -> Result<Self, Failure> {
        let refuse = |error: io::Error| {
            Failure::new(format!("cannot listen on port {port}: {error}"))
                .help("give another one with `--port`, or none")
        };
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(refuse)?;
        let port = listener.local_addr().map_err(refuse)?.port();
        let mut bytes = [0; 16];
        getrandom::fill(&mut bytes).map_err(|error| {
            Failure::new(format!("the system gives no random numbers: {error}"))
        })?;
        let word = bytes.iter().map(|byte| format!("{byte:02x}")).collect();
        Ok(Self {
            listener,
            word,
            port,
        })
    }

    /// Where a browser finds the page.
    pub(crate) fn address(&self) -> String {
        format!("http://127.0.0.1:{}/{}/", self.port, self.word)
    }

    /// Answers requests for as long as the program runs.
    pub(crate) fn serve(
        self,
        answer: impl Fn(&Request) -> Option<HttpReply> + Send + Sync + 'static,
    ) {
        let shared = Arc::new((self.word, self.port, answer));
        let busy = Arc::new(AtomicUsize::new(0));
        for stream in self.listener.incoming() {
            let Ok(stream) = stream else {
                // Of too many open files, for one, some are closed soon.
                thread::sleep(Duration::from_millis(50));
                continue;
            };
            let (shared, busy) = (Arc::clone(&shared), Arc::clone(&busy));
            if busy.fetch_add(1, Ordering::Relaxed) >= MAX_AT_ONCE {
                busy.fetch_sub(1, Ordering::Relaxed);
                continue;
            }
            thread::spawn(move || {
                let (word, port, answer) = &*shared;
                // A browser that has left is no failure.
                let _ = exchange(&stream, word, *port, answer);
                busy.fetch_sub(1, Ordering::Relaxed);
            });
        }
    }
}

/// Reads a request and sends what it asks for.
fn exchange(
    mut stream: &TcpStream,
    word: &str,
    port: u16,
    answer: &impl Fn(&Request) -> Option<HttpReply>,
) -> io::Result<()> {
    stream.set_read_timeout(Some(PATIENCE))?;
    stream.set_write_timeout(Some(PATIENCE))?;
    let asked = asked(&mut BufReader::new(stream.take(MAX_LENGTH)), word, port)?;
    let reply = match asked {
        Ok(request) => answer(&request).ok_or("404 Not Found"),
        Err(status) => Err(status),
    };
    let (status, reply) = match reply {
        Ok(reply) => ("200 OK", reply),
        Err(status) => {
            let body = format!("{status}\n").into_bytes();
            let (kind, policy) = ("text/plain; charset=utf-8", "default-src 'none'");
            (status, HttpReply { kind, policy, body })
        }
    };
    let HttpReply { kind, policy, body } = reply;
    let length = body.len();
    write!(
        stream,
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {length}\r\n\
         Content-Security-Policy: {policy}\r\nCache-Control: no-store\r\n\
         X-Content-Type-Options: nosniff\r\nReferrer-Policy: no-referrer\r\n\
         Cross-Origin-Resource-Policy: same-origin\r\nConnection: close\r\n\r\n"
    )?;
    stream.write_all(&body)?;
    stream.flush()
}

/// What a browser asks for, or the status with which it is refused.
fn asked(
    lines: &mut impl BufRead,
    word: &str,
    port: u16,
) -> io::Result<Result<Request, &'static str>> {
    let mut line = String::new();
    lines.read_line(&mut line)?;
    let mut words = line.split(' ');
    let (method, target) = (words.next(), words.next().unwrap_or_default());
    let (target, is_get) = (target.to_owned(), method == Some("GET"));
    let mut is_here = false;
    loop {
        line.clear();
        if lines.read_line(&mut line)? == 0 || line.trim().is_empty() {
            break;
        }
        let Some((name, value)) = line.split_once(':') else {
            return Ok(Err("400 Bad Request"));
        };
        if name.eq_ignore_ascii_case("host") {
            let value = value.trim();
            is_here = [format!("127.0.0.1:{port}"), format!("localhost:{port}")]
                .iter()
                .any(|own| own == value);
        }
    }
    if !is_get {
        return Ok(Err("405 Method Not Allowed"));
    }
    if !is_here {
        return Ok(Err("403 Forbidden"));
    }
    let (path, query) = target.split_once('?').unwrap_or((&target, ""));
    let path = path.strip_prefix('/').and_then(|path| path.split_once('/'));
    Ok(match path {
        Some((own, last)) if own == word => Ok(Request {
            word: last.to_owned(),
            query: query.to_owned(),
        }),
        _ => Err("404 Not Found"),
    })
}
