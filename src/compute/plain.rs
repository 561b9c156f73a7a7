//! The reader of plain requests: objects, texts without escapes, and lists of numbers or of rows of them, at once.
//!
//! Anything else, errors among it, is left to the reader of all JSON, which takes several times as long: this one gives what
//! that one gives, or nothing.

use super::given::{GivenValue, Object};

/// Objects within objects that are read here; a request has two levels.
const MAX_DEPTH: usize = 8;

/// The `id` of a plain request, and its other members; none for anything else.
pub(crate) fn request(line: &str) -> Option<(serde_json::Value, Object<'_>)> {
    let mut reader = Reader { text: line, at: 0 };
    let mut id = serde_json::Value::Null;
    let mut members = Vec::new();
    reader.members(|reader, key| {
        if key == "id" {
            let start = reader.at;
            reader.value(MAX_DEPTH)?;
            id = serde_json::from_str(&line[start..reader.at]).ok()?;
        } else {
            members.push((key.into(), reader.value(MAX_DEPTH)?));
        }
        Some(())
    })?;
    reader.skip_spaces();
    (reader.at == line.len()).then(|| (id, Object::of(members)))
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Reader<'a> {
    fn byte(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    fn skip_spaces(&mut self) {
        while matches!(self.byte(), Some(b' ' | b'\t' | b'\n' | b'\r')) {
            self.at += 1;
        }
    }

    /// Takes a byte, and spaces before it.
    fn take(&mut self, byte: u8) -> bool {
        self.skip_spaces();
        let is_here = self.byte() == Some(byte);
        self.at += usize::from(is_here);
        is_here
    }

    /// Whether another entry comes after one, and not the end.
    fn goes_on(&mut self, end: u8) -> Option<bool> {
        self.skip_spaces();
        let byte = self.byte().filter(|byte| [b',', end].contains(byte))?;
        self.at += 1;
        Some(byte == b',')
    }

    fn members(&mut self, mut member: impl FnMut(&mut Self, &'a str) -> Option<()>) -> Option<()> {
        if !self.take(b'{') {
            return None;
        }
        if self.take(b'}') {
            return Some(());
        }
        loop {
            self.skip_spaces();
            let key = self.string()?;
            if !self.take(b':') {
                return None;
            }
            self.skip_spaces();
            member(self, key)?;
            if !self.goes_on(b'}')? {
                return Some(());
            }
        }
    }

    /// A value that begins here.
    fn value(&mut self, depth: usize) -> Option<GivenValue<'a>> {
        match &self.text.as_bytes()[self.at..] {
            [b'"', ..] => self.string().map(|text| GivenValue::Text(text.into())),
            [b'[', ..] => self.list(),
            [b'{', ..] => {
                let inner = depth.checked_sub(1)?;
                let mut members = Vec::new();
                self.members(|reader, key| {
                    members.push((key.into(), reader.value(inner)?));
                    Some(())
                })?;
                Some(GivenValue::Object(Object::of(members)))
            }
            [b'n', ..] => self.word("null").map(|()| GivenValue::Null),
            [b't', ..] => self.word("true").map(|()| GivenValue::Truth),
            [b'f', ..] => self.word("false").map(|()| GivenValue::Truth),
            _ => self.number().map(GivenValue::Number),
        }
    }

    fn word(&mut self, word: &str) -> Option<()> {
        let is_here = self.text[self.at..].starts_with(word);
        self.at += word.len();
        is_here.then_some(())
    }

    /// A text without escapes.
    fn string(&mut self) -> Option<&'a str> {
        let start = self.at + 1;
        if self.byte() != Some(b'"') {
            return None;
        }
        let bytes = &self.text.as_bytes()[start..];
        let is_plain = |byte: u8| byte >= b' ' && byte != b'\\' && byte != b'"';
        let length = bytes.iter().position(|byte| !is_plain(*byte))?;
        self.at = start + length + 1;
        (bytes[length] == b'"').then(|| &self.text[start..start + length])
    }

    /// A list of numbers, or of rows of as many numbers each.
    fn list(&mut self) -> Option<GivenValue<'a>> {
        let mut entries = Vec::new();
        if !self.take(b'[') {
            return None;
        }
        self.skip_spaces();
        if self.byte() != Some(b'[') {
            self.numbers(&mut entries)?;
            return Some(GivenValue::Numbers(entries));
        }
        let (mut width, mut end) = (0, 0);
        loop {
            if !self.take(b'[') {
                return None;
            }
            self.skip_spaces();
            self.numbers(&mut entries)?;
            let own = entries.len() - end;
            end = entries.len();
            if own == 0 || width > 0 && own != width {
                return None;
            }
            width = own;
            if !self.goes_on(b']')? {
                return Some(GivenValue::Table { entries, width });
            }
        }
    }

    /// Numbers up to the end of their list, which has begun.
    fn numbers(&mut self, numbers: &mut Vec<f64>) -> Option<()> {
        if self.take(b']') {
            return Some(());
        }
        loop {
            numbers.push(self.number()?);
            if !self.goes_on(b']')? {
                return Some(());
            }
            self.skip_spaces();
        }
    }

    /// A number, rounded once; none for an integer that binary64 does not hold, and for what is beyond its range.
    fn number(&mut self) -> Option<f64> {
        let (bytes, start) = (self.text.as_bytes(), self.at);
        let byte = |at: usize| bytes.get(at).copied();
        let is_negative = byte(start) == Some(b'-');
        let first = start + usize::from(is_negative);
        let (mut at, mut digits) = appended_digits(bytes, first, 0);
        let mut count = at - first;
        if count == 0 || count > 1 && byte(first) == Some(b'0') {
            return None;
        }
        let (mut power, mut is_integer) = (0, true);
        if byte(at) == Some(b'.') {
            let before = at + 1;
            (at, digits) = appended_digits(bytes, before, digits);
            let decimals = at - before;
            if decimals == 0 {
                return None;
            }
            (power, is_integer) = (-(decimals as i64), false);
            count += decimals;
        }
        if matches!(byte(at), Some(b'e' | b'E')) {
            let (end, raised) = exponent(bytes, at + 1)?;
            (at, power, is_integer) = (end, power + raised, false);
        }
        self.at = at;
        // Both are binary64 numbers, so that one operation rounds what they make rightly.
        let factor = POWERS.get(power.unsigned_abs() as usize);
        if let Some(factor) = factor.filter(|_| count < 19 && digits <= MAX_EXACT) {
            let digits = digits as f64;
            let size = if power < 0 {
                digits / factor
            } else {
                digits * factor
            };
            return Some(if is_negative { -size } else { size });
        }
        if is_integer {
            return None;
        }
        let number = self.text[start..at].parse::<f64>().ok()?;
        number.is_finite().then_some(number)
    }
}

/// Appends the digits at a place to a number, of which the first eighteen count; where they end.
fn appended_digits(bytes: &[u8], mut at: usize, mut number: u64) -> (usize, u64) {
    while let Some(digit @ b'0'..=b'9') = bytes.get(at) {
        number = number
            .wrapping_mul(10)
            .wrapping_add(u64::from(digit - b'0'));
        at += 1;
    }
    (at, number)
}

/// Where an exponent ends that begins at a place, and which it is: of three digits at most, which is more than a number
/// needs.
fn exponent(bytes: &[u8], at: usize) -> Option<(usize, i64)> {
    let sign = bytes.get(at).filter(|sign| b"+-".contains(sign));
    let first = at + usize::from(sign.is_some());
    let (end, size) = appended_digits(bytes, first, 0);
    let size = (1..=3).contains(&(end - first)).then_some(size as i64)?;
    let exponent = if sign == Some(&b'-') { -size } else { size };
    Some((end, exponent))
}

/// Integers up to this are binary64 numbers.
const MAX_EXACT: u64 = 1 << f64::MANTISSA_DIGITS;

/// The powers of ten that are binary64 numbers.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::compute::given::RequestLine;

    /// What the reader of all JSON finds, and what is read here.
    fn both(line: &str) -> [Option<String>; 2] {
        let shown = |(id, rest)| format!("{:?}", RequestLine::Request { id, rest });
        let all = serde_json::from_str::<RequestLine>(line).ok();
        [all.map(|all| format!("{all:?}")), request(line).map(shown)]
    }

    #[test]
    fn plain_requests_are_read_at_once() {
        for line in [
            r#"{"id":1,"task":"modes","params":{"masses":[1,2.5],"springs":[[0,1,100],[1,2,62.5]]}}"#,
            " { \"id\" : \"a\" , \"task\":\"t\",\t\"params\" : { \"t\":[ 0 , -0.0, -0, 1.25 ] } } ",
            r#"{"id":[1,2],"params":{},"t":[],"n":null,"T":true,"F":false}"#,
            r#"{"id":{"a":"é"},"id":3,"x":9007199254740992,"y":0.123456789012345}"#,
            r#"{"id":1.5e3,"x":[1e3,-2.5E-3,1e22,1e+23,1e-5,4.9e-324,1.7976931348623157e308]}"#,
            r#"{"x":0.1234567890123456789,"y":9007199254740993.0,"z":[[7.0420557077594588669468784357561207e28]]}"#,
            "{}",
        ] {
            let [all, own] = both(line);
            assert!(own.is_some() && own == all, "{line}: {own:?}");
        }
    }

    #[test]
    fn all_else_is_left_to_the_reader_of_all_json() {
        for line in [
            "",
            "[]",
            "{} {}",
            r#"{"a":01}"#,
            r#"{"a":1.}"#,
            r#"{"a":.5}"#,
            r#"{"a":-}"#,
            r#"{"a":1.2.3}"#,
            r#"{"a":1e999}"#,
            r#"{"a":1e}"#,
            r#"{"a":1e0001}"#,
            r#"{"a":18446744073709551616}"#,
            r#"{"a":9007199254740993}"#,
            r#"{"a":[1,"2"]}"#,
            r#"{"a":[[1],[2,3]]}"#,
            r#"{"a":[[]]}"#,
            r#"{"a":[[[1]]]}"#,
            r#"{"a":[1,]}"#,
            r#"{"a":[1}"#,
            r#"{"a":"\n"}"#,
            "{\"a\":\"\t\"}",
            r#"{"a":"b}"#,
            r#"{"a":nul}"#,
            r#"{"a" 1}"#,
            r#"{"a":1,}"#,
        ] {
            assert!(request(line).is_none(), "{line}");
        }
    }

    proptest! {
        /// What is read here is read alike by the reader of all JSON, to the last bit.
        #[test]
        fn nothing_is_read_otherwise(
            line in r#"\{"(a|id)":(-?(0|[1-9][0-9]{0,16})(\.[0-9]{1,17})?([eE][-+]?[0-9]{1,3})?|\[(\[?-?[0-9.]{1,4}\]?,? ?){0,4}\]|"[a-c\\é]{0,3}"|null|true|[\[\]{},:"0-9a ]{0,9}) ?\}"#
        ) {
            let [all, own] = both(&line);
            prop_assert!(own.is_none() || own == all, "{}: {:?}", line, own);
        }
    }
}
