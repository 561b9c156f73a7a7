//! `vibank-scan FILES…` prints what `vibank sort` asks of scanned pages: first its version, then a line for each file, with
//! its number and `mark` with the bytes of the mark, `none`, or `unreadable` with the reason.

use std::fs::File;
use std::io::{self, Read as _, Write as _};
use std::path::Path;
use std::process::ExitCode;

use vibank_scan::{Grey, ReadError, mark};

/// No scanned page is a larger file.
const LIMIT: u64 = 256 << 20;

fn main() -> ExitCode {
    let answered = answer();
    // A reader that has left wants no more.
    ExitCode::from(u8::from(answered.is_err()))
}

fn answer() -> io::Result<()> {
    let mut out = io::stdout().lock();
    writeln!(out, "vibank-scan {}", env!("CARGO_PKG_VERSION"))?;
    for (number, file) in std::env::args_os().skip(1).enumerate() {
        match read(Path::new(&file)).map(|page| mark(&page)) {
            Ok(Some(bytes)) => {
                let shown: String = bytes.iter().map(|byte| format!("{byte:02x}")).collect();
                writeln!(out, "{number} mark {shown}")?;
            }
            Ok(None) => writeln!(out, "{number} none")?,
            Err(error) => {
                let shown = error.to_string().replace(char::is_control, " ");
                writeln!(out, "{number} unreadable {shown}")?;
            }
        }
        // What was read stays read, should the next file end the process.
        out.flush()?;
    }
    Ok(())
}

fn read(path: &Path) -> Result<Grey, ReadError> {
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(|error| ReadError::Broken(error.to_string()))?;
    file.take(LIMIT + 1)
        .read_to_end(&mut bytes)
        .map_err(|error| ReadError::Broken(error.to_string()))?;
    if bytes.len() as u64 > LIMIT {
        return Err(ReadError::Large);
    }
    Grey::read(&bytes)
}
