//! Inputs from seeds, by mutation and splice; which of them, a number decides.

use arbitrary::{Arbitrary, Result, Unstructured};

/// What an input is never longer than.
pub const MAX_LENGTH: usize = 1 << 15;

/// A stream of numbers: splitmix64, of which the campaign asks no more than that it is the same everywhere.
pub struct Stream(u64);

impl Stream {
    /// The stream of a seed.
    pub fn of(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x5851_f42d_4c95_7f2d)
    }

    /// The next number.
    pub fn draw(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Bytes of which an input is made.
    pub fn bytes(&mut self, count: usize) -> Vec<u8> {
        let words = std::iter::repeat_with(|| self.draw().to_le_bytes());
        words.flatten().take(count).collect()
    }
}

/// Pieces that inputs of all kinds are sensitive to.
const PIECES: &[&str] = &[
    "sin(", "integral(", "root(", "diff(", "at(", "exp(", ")", "((((((((", "]]]]", "[[[[", "{{{{",
    "<< m >>", "<<", ">>", "$", "$$", "\\frac{", "\\sqrt{", "\\", "\u{0}", "\u{feff}", "\u{202e}",
    "é", "王", "𝕏", "1e308", "-1e-308", "1e999", "nan", "inf", "0", "-0", "9223372036854775807",
    "18446744073709551616", "0.1", ",", ";", "\t", "\r\n", "\n", "\"", "'''", "\"\"\"", "=", "[",
    "[[part]]\n", "[x]\n", "../../", "/abs/", "null", "true", "m", "k", "omega_n", "x'", "^", "/",
    "*", "-", "²", "√", "π", "°", " ", "#", "|", "&", "code,question,part,response\n",
];

/// An input from the pool: one of it mutated, two of it spliced, or made up.
pub fn input(pool: &[Vec<u8>], stream: &mut Stream) -> Vec<u8> {
    let raw = stream.bytes(1024);
    let mut raw = Unstructured::new(&raw);
    let mut made = make(pool, &mut raw).unwrap_or_default();
    made.truncate(MAX_LENGTH);
    made
}

fn make(pool: &[Vec<u8>], raw: &mut Unstructured<'_>) -> Result<Vec<u8>> {
    if pool.is_empty() || raw.ratio(1, 50)? {
        return Ok(if raw.arbitrary()? {
            String::arbitrary(raw)?.into_bytes()
        } else {
            Vec::arbitrary(raw)?
        });
    }
    let mut made = raw.choose(pool)?.clone();
    if raw.ratio(1, 4)? {
        let other = raw.choose(pool)?;
        let (a, b) = (place(&made, raw)?, place(other, raw)?);
        made.truncate(a);
        made.extend_from_slice(&other[b..]);
    }
    for _ in 0..raw.int_in_range(0..=5)? {
        mutate(&mut made, pool, raw)?;
    }
    Ok(made)
}

/// A place between two bytes.
fn place(bytes: &[u8], raw: &mut Unstructured<'_>) -> Result<usize> {
    raw.int_in_range(0..=bytes.len())
}

fn mutate(made: &mut Vec<u8>, pool: &[Vec<u8>], raw: &mut Unstructured<'_>) -> Result<()> {
    let at = place(made, raw)?;
    let end = (at + raw.int_in_range(0..=40_usize)?).min(made.len());
    match raw.int_in_range(0..=8)? {
        0 if at < made.len() => made[at] = raw.arbitrary()?,
        1 if at < made.len() => made[at] ^= 1 << raw.int_in_range(0..=7)?,
        2 => drop(made.drain(at..end)),
        3 => {
            let piece = raw.choose(PIECES)?.as_bytes();
            made.splice(at..at, piece.iter().copied());
        }
        4 => {
            let piece = raw.choose(PIECES)?.as_bytes();
            made.splice(at..end, piece.iter().copied());
        }
        // The same once more, up to many times: depth and length.
        5 => {
            let piece = made[at..end].to_vec();
            let times = 1 << raw.int_in_range(0..=8)?;
            if piece.len() * times <= MAX_LENGTH {
                made.splice(at..at, piece.repeat(times));
            }
        }
        6 => {
            let other = raw.choose(pool)?;
            let from = place(other, raw)?;
            let to = (from + raw.int_in_range(1..=200_usize)?).min(other.len());
            made.splice(at..at, other[from..to].iter().copied());
        }
        // Another number where one stands.
        7 => {
            let digit = made[at..].iter().position(u8::is_ascii_digit);
            if let Some(first) = digit.map(|first| at + first) {
                let number: i64 = raw.arbitrary()?;
                let shift = raw.int_in_range(0..=63)?;
                let written = (number >> shift).to_string();
                made.splice(first..=first, written.into_bytes());
            }
        }
        _ => made.rotate_left(at),
    }
    Ok(())
}
