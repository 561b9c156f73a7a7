//! What `vibank` and `vibank-press` say to each other over a pair of pipes.
//!
//! The press greets first: [`Greeting`] names the protocol, the version of the program and a digest of everything that
//! shapes the bytes of its files. Then each [`Job`] is answered by one [`Reply`], in order. All lengths are bounded, and
//! a peer that does not keep to the form is an error of [`io`], never a panic.
//!
//! ```
//! use vibank_press_protocol::{Job, Reply};
//!
//! let mut pipe = Vec::new();
//! let job = Job::Page { text: "= Title".into(), fonts: Vec::new() };
//! job.send(&mut pipe)?;
//! assert_eq!(Job::receive(&mut pipe.as_slice())?, Some(job));
//! # Ok::<(), std::io::Error>(())
//! ```

use std::io::{self, Read, Write};

/// The version of this protocol. Programs of different versions do not work together.
pub const PROTOCOL: u32 = 1;

/// Bytes of a job's text or picture. The longest text of the bank, the keys of 300 variants, has 4 MB.
pub const MAX_TEXT: u64 = 64 << 20;

/// Bytes of a finished file.
pub const MAX_FILE: u64 = 512 << 20;

/// Bytes of a version, a digest, the path of a font or a message.
const MAX_WORDS: u64 = 64 << 10;

/// Fonts that one job may bring.
const MAX_FONTS: u64 = 64;

/// Signs that the text font of the press has, from the first to the last of each row: Latin with accents of all kinds,
/// Greek, Cyrillic, Hebrew, punctuation. Names with others need a font of their own.
const OWN_SIGNS: [(char, char); 17] = [
    (' ', '~'),
    ('\u{a0}', '\u{2e4}'),
    ('\u{300}', '\u{34e}'),
    ('\u{350}', '\u{36f}'),
    ('\u{384}', '\u{38a}'),
    ('\u{38e}', '\u{3a1}'),
    ('\u{3a3}', '\u{3ce}'),
    ('\u{3d0}', '\u{3e1}'),
    ('\u{3fd}', '\u{477}'),
    ('\u{48c}', '\u{4c4}'),
    ('\u{4d0}', '\u{4f9}'),
    ('\u{5b0}', '\u{5c3}'),
    ('\u{5d0}', '\u{5ea}'),
    ('\u{1e00}', '\u{1f15}'),
    ('\u{2010}', '\u{2027}'),
    ('\u{2030}', '\u{2037}'),
    ('\u{2039}', '\u{203e}'),
];

/// Whether the text font of the press has a sign.
///
/// ```
/// use vibank_press_protocol::has_sign;
/// assert!("Zoë Đặng Čapek Ξένια Юлия".chars().all(has_sign));
/// assert!(!has_sign('王'));
/// ```
pub fn has_sign(sign: char) -> bool {
    let mut rows = OWN_SIGNS.iter();
    rows.any(|(first, last)| (*first..=*last).contains(&sign))
}

/// What a greeting begins with, so that another program is recognized at once.
const MAGIC: &[u8; 8] = b"vibpress";

/// What a press says of itself before its first job.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Greeting {
    /// The protocol that it speaks.
    pub protocol: u32,
    /// The version of its package.
    pub version: String,
    /// A digest of what shapes the bytes of its files: the typesetter, its fonts, its own sources.
    pub digest: String,
}

/// Something to be printed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Job {
    /// A document in Typst markup, printed as a tagged PDF.
    Page {
        /// The markup.
        text: String,
        /// Files of further fonts that the text may fall back on.
        fonts: Vec<String>,
    },
    /// A figure as SVG, printed as a PDF of its own size.
    Figure {
        /// The picture.
        svg: String,
    },
}

/// What became of a job.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reply {
    /// The finished file.
    File(Vec<u8>),
    /// Why there is none.
    Refused(String),
}

impl Greeting {
    /// Writes the greeting.
    ///
    /// # Errors
    ///
    /// Those of the pipe.
    pub fn send(&self, pipe: &mut impl Write) -> io::Result<()> {
        pipe.write_all(MAGIC)?;
        pipe.write_all(&self.protocol.to_le_bytes())?;
        send(pipe, self.version.as_bytes())?;
        send(pipe, self.digest.as_bytes())?;
        pipe.flush()
    }

    /// Reads a greeting. Of another protocol only the number is read: what follows it may have changed.
    ///
    /// # Errors
    ///
    /// [`io::ErrorKind::InvalidData`] where the bytes are not such a message, and the errors of the pipe.
    pub fn receive(pipe: &mut impl Read) -> io::Result<Self> {
        let mut magic = [0; MAGIC.len()];
        pipe.read_exact(&mut magic)?;
        if &magic != MAGIC {
            return Err(invalid("it does not greet as a press does"));
        }
        let mut protocol = [0; 4];
        pipe.read_exact(&mut protocol)?;
        let protocol = u32::from_le_bytes(protocol);
        let mut greeting = Self {
            protocol,
            version: String::new(),
            digest: String::new(),
        };
        if protocol == PROTOCOL {
            greeting.version = words(pipe)?;
            greeting.digest = words(pipe)?;
        }
        Ok(greeting)
    }
}

impl Job {
    /// Writes the job.
    ///
    /// # Errors
    ///
    /// [`io::ErrorKind::InvalidInput`] where it is longer than a job may be, and those of the pipe.
    pub fn send(&self, pipe: &mut impl Write) -> io::Result<()> {
        let (kind, fonts, text) = match self {
            Self::Page { text, fonts } => (1, fonts.as_slice(), text),
            Self::Figure { svg } => (2, &[][..], svg),
        };
        if text.len() as u64 > MAX_TEXT || fonts.len() as u64 > MAX_FONTS {
            let message = format!("a page of {} bytes is too long to print", text.len());
            return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
        }
        pipe.write_all(&[kind])?;
        pipe.write_all(&(fonts.len() as u64).to_le_bytes())?;
        for font in fonts {
            send(pipe, font.as_bytes())?;
        }
        send(pipe, text.as_bytes())?;
        pipe.flush()
    }

    /// Reads the next job; none where the pipe has ended.
    ///
    /// # Errors
    ///
    /// [`io::ErrorKind::InvalidData`] where the bytes are not such a message, and the errors of the pipe.
    pub fn receive(pipe: &mut impl Read) -> io::Result<Option<Self>> {
        let mut kind = [0];
        if pipe.read(&mut kind)? == 0 {
            return Ok(None);
        }
        let count = number(pipe)?;
        if count > MAX_FONTS {
            return Err(invalid("more fonts than a job may bring"));
        }
        let fonts = (0..count)
            .map(|_| words(pipe))
            .collect::<io::Result<Vec<_>>>()?;
        let text = text(receive(pipe, MAX_TEXT)?)?;
        match kind {
            [1] => Ok(Some(Self::Page { text, fonts })),
            [2] => Ok(Some(Self::Figure { svg: text })),
            _ => Err(invalid("a job of an unknown kind")),
        }
    }
}

impl Reply {
    /// Writes the reply; a message that is too long is cut.
    ///
    /// # Errors
    ///
    /// Those of the pipe.
    pub fn send(&self, pipe: &mut impl Write) -> io::Result<()> {
        let (kind, bytes) = match self {
            Self::File(bytes) => (1, bytes.as_slice()),
            Self::Refused(message) => {
                let end = message.floor_char_boundary(MAX_WORDS as usize);
                (0, &message.as_bytes()[..end])
            }
        };
        pipe.write_all(&[kind])?;
        send(pipe, bytes)?;
        pipe.flush()
    }

    /// Reads the reply to a job.
    ///
    /// # Errors
    ///
    /// [`io::ErrorKind::InvalidData`] where the bytes are not such a message, and the errors of the pipe.
    pub fn receive(pipe: &mut impl Read) -> io::Result<Self> {
        let mut kind = [0];
        pipe.read_exact(&mut kind)?;
        match kind {
            [1] => receive(pipe, MAX_FILE).map(Self::File),
            [0] => words(pipe).map(Self::Refused),
            _ => Err(invalid("its answer is not a reply")),
        }
    }
}

fn invalid(message: &str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, message)
}

fn send(pipe: &mut impl Write, bytes: &[u8]) -> io::Result<()> {
    pipe.write_all(&(bytes.len() as u64).to_le_bytes())?;
    pipe.write_all(bytes)
}

fn number(pipe: &mut impl Read) -> io::Result<u64> {
    let mut length = [0; 8];
    pipe.read_exact(&mut length)?;
    Ok(u64::from_le_bytes(length))
}

/// Room is taken as bytes arrive, so that a length alone takes none.
fn receive(pipe: &mut impl Read, limit: u64) -> io::Result<Vec<u8>> {
    let length = number(pipe)?;
    if length > limit {
        return Err(invalid("a length beyond every bound"));
    }
    let mut bytes = Vec::new();
    pipe.take(length).read_to_end(&mut bytes)?;
    if bytes.len() as u64 == length {
        Ok(bytes)
    } else {
        Err(io::ErrorKind::UnexpectedEof.into())
    }
}

fn text(bytes: Vec<u8>) -> io::Result<String> {
    String::from_utf8(bytes).map_err(|_| invalid("a text that is not UTF-8"))
}

fn words(pipe: &mut impl Read) -> io::Result<String> {
    text(receive(pipe, MAX_WORDS)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_sent_is_received() -> io::Result<()> {
        let mut pipe = Vec::new();
        let greeting = Greeting {
            protocol: PROTOCOL,
            version: "1.2.3".into(),
            digest: "abc".into(),
        };
        greeting.send(&mut pipe)?;
        assert_eq!(Greeting::receive(&mut pipe.as_slice())?, greeting);
        for job in [
            Job::Page {
                text: "é".into(),
                fonts: vec!["/a font.ttf".into()],
            },
            Job::Figure { svg: String::new() },
        ] {
            let mut pipe = Vec::new();
            job.send(&mut pipe)?;
            assert_eq!(Job::receive(&mut pipe.as_slice())?, Some(job));
        }
        for reply in [Reply::File(vec![0, 1]), Reply::Refused("why".into())] {
            let mut pipe = Vec::new();
            reply.send(&mut pipe)?;
            assert_eq!(Reply::receive(&mut pipe.as_slice())?, reply);
        }
        Ok(())
    }

    #[test]
    fn an_ended_pipe_brings_no_job() -> io::Result<()> {
        assert_eq!(Job::receive(&mut [].as_slice())?, None);
        Ok(())
    }

    #[test]
    fn any_bytes_are_refused_and_take_no_room() {
        let huge = [&[1u8][..], &[0; 8], &u64::MAX.to_le_bytes(), b"cut"].concat();
        let cut = [&[1u8][..], &[0; 8], &9u64.to_le_bytes(), b"cut"].concat();
        let fonts = [&[1u8][..], &[255; 8]].concat();
        for bytes in [b"ab".to_vec(), huge.clone(), cut, fonts, vec![7; 40]] {
            assert!(Job::receive(&mut bytes.as_slice()).is_err(), "{bytes:?}");
            assert!(Reply::receive(&mut &bytes[1..]).is_err(), "{bytes:?}");
            assert!(
                Greeting::receive(&mut bytes.as_slice()).is_err(),
                "{bytes:?}"
            );
        }
    }

    #[test]
    fn a_press_of_another_protocol_is_recognized_by_its_number() -> io::Result<()> {
        let bytes = [&MAGIC[..], &9u32.to_le_bytes(), b"whatever follows"].concat();
        assert_eq!(Greeting::receive(&mut bytes.as_slice())?.protocol, 9);
        Ok(())
    }
}
