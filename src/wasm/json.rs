//! Replies as JSON.

use std::io::{self, Write};

use serde::Serialize;
use serde_json::Serializer;
use serde_json::ser::Formatter;

/// A reply as a line of JSON.
pub(crate) fn written(reply: &impl Serialize) -> String {
    let mut line = Vec::new();
    let mut writer = Serializer::with_formatter(&mut line, Plain);
    reply
        .serialize(&mut writer)
        .expect("a reply is plain data, and a list of bytes takes it");
    String::from_utf8(line).expect("JSON is text")
}

/// Writes numbers as the grader prints all its others: what JSON has of its own would bring a table of ten kilobytes.
struct Plain;

impl Formatter for Plain {
    fn write_f64<W: ?Sized + Write>(&mut self, writer: &mut W, value: f64) -> io::Result<()> {
        // Beyond these sizes a number without an exponent has more zeros than digits.
        let is_handy = value == 0.0 || (1e-5..1e16).contains(&value.abs());
        if is_handy {
            // As everywhere on the wire, an integer among such numbers has a decimal point.
            let end = if value == value.trunc() { ".0" } else { "" };
            write!(writer, "{value}{end}")
        } else {
            write!(writer, "{value:e}")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_as_they_were() {
        let numbers = [
            0.0,
            -0.0,
            0.1,
            -2.5e-7,
            1.0 / 3.0,
            1e16,
            123_456_789.0,
            f64::MAX,
            5e-324,
        ];
        let read: Vec<f64> = serde_json::from_str(&written(&numbers)).expect("it is JSON");
        let bits = |all: &[f64]| all.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&read), bits(&numbers));
        assert_eq!(written(&[f64::NAN, f64::INFINITY]), "[null,null]");
        assert_eq!(written(&[1.5, 1e-7, 3.0]), "[1.5,1e-7,3.0]");
    }
}
