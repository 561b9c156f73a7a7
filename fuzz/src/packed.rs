//! Workbooks as text, since a change to a byte of an archive mostly breaks the archive and nothing in it is read.
//!
//! ```text
//! == xl/workbook.xml
//! <workbook>…
//! == xl/worksheets/sheet1.xml
//! <worksheet>…
//! ```

use std::io::{Cursor, Write};

use zip::ZipWriter;
use zip::write::SimpleFileOptions;

/// Before the name of each file.
const MARK: &str = "== ";

/// The archive of a text, or the bytes as they are where they begin as an archive does.
pub fn archive(bytes: &[u8]) -> Vec<u8> {
    if bytes.starts_with(b"PK") {
        return bytes.to_vec();
    }
    let text = String::from_utf8_lossy(bytes);
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    // Stored as they are: what is packed and unpacked is the library's to test.
    let stored = SimpleFileOptions::default().compression_method(zip::CompressionMethod::Stored);
    for file in text.split(&format!("\n{MARK}")) {
        let file = file.strip_prefix(MARK).unwrap_or(file);
        let (name, content) = file.split_once('\n').unwrap_or((file, ""));
        // Names that occur twice are refused: then the first stands.
        if archive.start_file(name, stored).is_ok() {
            let _ = archive.write_all(content.as_bytes());
        }
    }
    archive.finish().map(Cursor::into_inner).unwrap_or_default()
}
