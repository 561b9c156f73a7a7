//! `vibank preview BLUEPRINT`

mod duration;
mod made;
mod server;

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use serde_json::json;
use vibank::bank::Catalogue;
use vibank::diagnostic::Finding;

pub(crate) use self::made::beside;

use self::made::{Made, Trouble};
use self::server::{HttpReply, Request, Server};
use super::bank::{self, BankArgument};
use super::watch::{self, Watch};
use super::{Failure, Outcome};

/// Show the sheet of a blueprint beside its key and its solutions in a browser, made anew while its files change.
///
/// The page also shows points and minutes of all questions, and what is wrong with the files, with its place. It is served
/// to this computer alone, at an address that nobody can guess; nothing is written. Ctrl-C ends it.
///
/// Example: vibank preview examples/midterm.toml
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The blueprint; `vibank new exam FILE` begins one.
    blueprint: PathBuf,
    /// The port to listen on; else one that is free.
    #[arg(
        long,
        value_name = "NUMBER",
        default_value_t = 0,
        hide_default_value = true
    )]
    port: u16,
    #[command(flatten)]
    bank: BankArgument,
}

/// What requests are answered from.
struct Bench {
    blueprint: PathBuf,
    bank: BankArgument,
    /// The bank, whose items are read once.
    catalogue: Mutex<Option<Arc<Opened>>>,
    board: Mutex<Board>,
    changed: Condvar,
}

/// A bank, and what is wrong with the files that are not items.
type Opened = (Catalogue, Vec<Finding>);

/// What was made last.
#[derive(Default)]
struct Board {
    /// Grows with each change.
    version: u64,
    /// What is wrong with the files, if they cannot be used.
    trouble: Option<String>,
    /// Sheets by their place in the run, of the last files that could be used.
    made: BTreeMap<usize, Arc<Made>>,
}

pub(crate) fn run(arguments: Arguments) -> Result<Outcome, Failure> {
    // What is no file at all, or surely another one, is misuse and not to be waited for.
    super::file_kind::blueprint(&arguments.blueprint)?;
    let server = Server::listen(arguments.port)?;
    let bench = Arc::new(Bench {
        blueprint: arguments.blueprint,
        bank: arguments.bank,
        catalogue: Mutex::default(),
        board: Mutex::default(),
        changed: Condvar::new(),
    });
    let mut watched = bench.watched();
    let mut watch = Watch::of(&watched.0, &watched.1);
    bench.renew();
    println!("{}", server.address());
    eprintln!("open this address in a browser; Ctrl-C ends");
    let own = Arc::clone(&bench);
    thread::spawn(move || server.serve(move |request| own.answer(request)));
    loop {
        let changed = watch.wait();
        eprintln!("{}", watch::said(&changed));
        if changed.iter().any(|path| !watched.0.contains(path)) {
            bench.forget_bank();
        }
        let now = bench.watched();
        if now != watched {
            watched = now;
            watch = Watch::of(&watched.0, &watched.1);
        }
        bench.renew();
    }
}

/// Sheets that are kept; all are made anew when a file changes.
const MAX_KEPT: usize = 32;

/// How long a request for a change waits before it is asked anew.
const PATIENCE: Duration = Duration::from_secs(8);

impl Bench {
    /// Files that are looked into, and others of which size and time tell enough.
    fn watched(&self) -> (Vec<PathBuf>, Vec<PathBuf>) {
        let mut named = vec![self.blueprint.clone()];
        named.extend(beside(&self.blueprint));
        (named, self.bank.watched())
    }

    fn board(&self) -> MutexGuard<'_, Board> {
        self.board.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The bank as it was opened, at the latest when one of its files changed.
    fn opened(&self) -> Result<Arc<Opened>, Failure> {
        let mut held = self
            .catalogue
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        if let Some(opened) = &*held {
            return Ok(Arc::clone(opened));
        }
        let opened = Arc::new(self.bank.open(&[])?);
        *held = Some(Arc::clone(&opened));
        Ok(opened)
    }

    fn forget_bank(&self) {
        *self
            .catalogue
            .lock()
            .unwrap_or_else(PoisonError::into_inner) = None;
    }

    fn make(&self, place: usize) -> Result<Made, Trouble> {
        let opened = self.opened()?;
        Made::of(&self.blueprint, &opened, place)
    }

    /// Makes the first sheet anew, and says what is wrong on the terminal, too.
    fn renew(&self) {
        let made = self.make(0);
        let mut board = self.board();
        board.version += 1;
        match made {
            Ok(made) => {
                eprintln!("{}", made.line());
                board.made = BTreeMap::from([(0, Arc::new(made))]);
                board.trouble = None;
            }
            Err(trouble) => {
                match &trouble {
                    Trouble::Findings(findings) => bank::print(findings),
                    Trouble::Failure(failure) => eprintln!("{}", failure.to_string().trim_end()),
                }
                board.trouble = Some(trouble.to_string());
            }
        }
        drop(board);
        self.changed.notify_all();
    }

    /// The sheet at a place of the run; where the files cannot be used, that of the last ones that could.
    fn made(&self, place: usize) -> Option<Arc<Made>> {
        let board = self.board();
        if let Some(made) = board.made.get(&place) {
            return Some(Arc::clone(made));
        }
        if board.trouble.is_some() {
            return None;
        }
        let version = board.version;
        drop(board);
        let made = Arc::new(self.make(place).ok()?);
        let mut board = self.board();
        if board.version == version {
            if board.made.len() >= MAX_KEPT {
                board.made.pop_last();
            }
            board.made.insert(place, Arc::clone(&made));
        }
        Some(made)
    }

    fn answer(&self, request: &Request) -> Option<HttpReply> {
        let place = request.number("variant").unwrap_or(0);
        let place = usize::try_from(place).ok()?;
        let file = |kind, text: &str| HttpReply {
            kind,
            policy: PAGE,
            body: text.as_bytes().to_vec(),
        };
        Some(match request.word.as_str() {
            "" => file(
                "text/html; charset=utf-8",
                include_str!("../../../templates/preview/page.html"),
            ),
            "preview.js" => file(
                "text/javascript; charset=utf-8",
                include_str!("../../../templates/preview/preview.js"),
            ),
            "preview.css" => file(
                "text/css; charset=utf-8",
                include_str!("../../../templates/preview/preview.css"),
            ),
            "state" => self.state(place, request.number("since")),
            name => {
                let made = self.made(place)?;
                let pane = made.pane(name)?;
                HttpReply {
                    kind: "text/html; charset=utf-8",
                    policy: PANE,
                    body: pane.as_bytes().to_vec(),
                }
            }
        })
    }

    /// What the page shows beside the panes, once it is another than that of a version.
    fn state(&self, place: usize, since: Option<u64>) -> HttpReply {
        let board = self.board();
        let waited = self
            .changed
            .wait_timeout_while(board, PATIENCE, |board| since == Some(board.version));
        let (board, _) = waited.unwrap_or_else(PoisonError::into_inner);
        let (version, trouble) = (board.version, board.trouble.clone());
        drop(board);
        let made = self.made(place);
        let state = json!({
            "version": version,
            "file": self.blueprint.display().to_string(),
            "trouble": trouble,
            "sheet": made.as_ref().map(|made| &made.summary),
        });
        HttpReply {
            kind: "application/json",
            policy: "default-src 'none'",
            body: state.to_string().into_bytes(),
        }
    }
}

/// The page takes its parts from this server, and nothing from elsewhere.
const PAGE: &str = "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; \
                    frame-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// Sheets run no programs.
const PANE: &str = "default-src 'none'; style-src 'unsafe-inline'; img-src data:; font-src data:; \
                    base-uri 'none'; form-action 'none'; frame-ancestors 'self'";
