//! With a secret, no PDF file that is handed out tells a seed: not in what its streams unpack to, its metadata, its
//! alternative texts, nor in the text of its pages.

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

fn programs() -> PathBuf {
    let press = Path::new(env!("CARGO_BIN_EXE_vibank-press"));
    press.parent().expect("it is in a folder").to_owned()
}

/// Runs `vibank` of the same build, in a folder.
fn vibank(folder: &Path, arguments: &[&str]) {
    let program = programs().join(format!("vibank{}", std::env::consts::EXE_SUFFIX));
    let mut command = Command::new(&program);
    command.env_remove("VIBANK_PRESS").args(arguments);
    let output = command.current_dir(folder).output();
    let output = output.expect("`cargo build -p vibank` has to come first");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{arguments:?}: {said}");
}

fn bytes_of(path: &Path) -> Vec<u8> {
    #[expect(
        clippy::disallowed_methods,
        reason = "a test looks at what was written"
    )]
    let bytes = fs::read(path);
    bytes.expect("it can be read")
}

/// The bytes of a PDF file and of all its streams that are deflated, unpacked.
fn unpacked(bytes: &[u8]) -> (Vec<u8>, usize) {
    let (mut all, mut streams) = (bytes.to_vec(), 0);
    let mark = b"stream";
    for at in 0..bytes.len().saturating_sub(mark.len()) {
        let is_begin = bytes[at..].starts_with(mark) && !bytes[..at].ends_with(b"end");
        if !is_begin {
            continue;
        }
        let rest = &bytes[at + mark.len()..];
        let rest = rest.strip_prefix(b"\r").unwrap_or(rest);
        let rest = rest.strip_prefix(b"\n").unwrap_or(rest);
        // What follows the stream is not read: its own end is marked in it.
        if let Ok(stream) = miniz_oxide::inflate::decompress_to_vec_zlib(rest) {
            all.push(b'\n');
            all.extend(stream);
            streams += 1;
        }
    }
    (all, streams)
}

/// The text of the pages, where there is a program that tells it: in the file letters are numbers of glyphs.
fn printed(path: &Path) -> Option<String> {
    let output = Command::new("pdftotext").arg(path).arg("-").output().ok()?;
    Some(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// A number in the notations in which a file could carry it.
fn notations(number: u64) -> Vec<String> {
    let in_base = |digits: &[u8]| {
        let (mut rest, mut text) = (number, Vec::new());
        while rest > 0 {
            text.push(digits[(rest % 32) as usize]);
            rest /= 32;
        }
        text.reverse();
        String::from_utf8(text).expect("digits are ASCII")
    };
    vec![
        number.to_string(),
        format!("{number:x}"),
        in_base(b"0123456789abcdefghjkmnpqrstvwxyz"),
        in_base(b"abcdefghijklmnopqrstuvwxyz234567"),
        in_base(b"0123456789abcdefghijklmnopqrstuv"),
    ]
}

/// Whether bytes hold a word of ASCII, in any case, as it stands or in UTF-16, as strings of PDF have it.
fn holds(bytes: &[u8], word: &str) -> bool {
    let wide: Vec<u8> = word.bytes().flat_map(|byte| [0, byte]).collect();
    [word.as_bytes(), &wide].iter().any(|word| {
        bytes
            .windows(word.len())
            .any(|window| window.eq_ignore_ascii_case(word))
    })
}

/// The seeds of the items in a manifest; that of a variant has 40 bits, and is the code that is printed.
fn seeds(manifest: &str) -> Vec<u64> {
    let found = manifest.split("\"seed\":").skip(1).filter_map(|rest| {
        let rest = rest.trim_start();
        let end = rest.find(|sign: char| !sign.is_ascii_digit())?;
        rest[..end].parse::<u64>().ok()
    });
    let seeds: Vec<u64> = found.filter(|seed| *seed >= 1 << 40).collect();
    assert!(seeds.len() >= 6, "{seeds:?}");
    seeds
}

#[test]
fn no_pdf_that_is_handed_out_tells_a_seed() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pdf-seeds");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("the folder can be made");
    vibank(&folder, &["new", "secret", "exam.key"]);
    let plan = "title = 'Marker4711'\nsecret = 'exam.key'\nvariants = 3\nformats = ['pdf']\nhints = true\n\
        [[question]]\nitem = 'ch3/e4-underdamped-response'\n\
        [[question]]\nitem = 'ch1/e9-pendulum-equilibrium-stability'\n";
    #[expect(clippy::disallowed_methods, reason = "a test lays out its input")]
    fs::write(folder.join("exam.toml"), plan).expect("it can be written");
    vibank(&folder, &["sheet", "exam.toml", "--out", "out"]);
    let out = folder.join("out");
    vibank(
        &folder,
        &[
            "grade",
            "out/manifest.json",
            "out/responses.csv",
            "--feedback",
            "pdf",
        ],
    );
    let manifest = String::from_utf8_lossy(&bytes_of(&out.join("manifest.json"))).into_owned();
    let seeds = seeds(&manifest);
    let mut looked = 0;
    for kind in ["sheets", "solutions", "marks/feedback", "keys"] {
        for entry in fs::read_dir(out.join(kind)).expect("it was made").flatten() {
            let path = entry.path();
            let (mut bytes, streams) = unpacked(&bytes_of(&path));
            assert!(streams > 3, "{}: {streams} streams", path.display());
            assert!(
                holds(&bytes, "Marker4711"),
                "the title is found: {}",
                path.display()
            );
            let text = printed(&path);
            bytes.extend(text.iter().flat_map(|text| text.bytes()));
            let found = |seed: &u64| notations(*seed).iter().any(|word| holds(&bytes, word));
            if kind == "keys" {
                assert!(
                    text.is_none() || seeds.iter().any(found),
                    "the search does find seeds"
                );
                continue;
            }
            let found: Vec<&u64> = seeds.iter().filter(|seed| found(seed)).collect();
            assert!(found.is_empty(), "{}: {found:?}", path.display());
            looked += 1;
            if text.is_none() {
                let _ = writeln!(
                    std::io::stderr(),
                    "without pdftotext the text of pages is not searched"
                );
            }
        }
    }
    assert_eq!(looked, 9);
}
