//! Places of cells in the XML of a sheet, looked over before it is read: `calamine` counts in 32 bits and does not look
//! whether a place fits.

/// Letters and digits of the last place that a sheet has, `XFD1048576`.
const LETTERS: usize = 3;
const DIGITS: usize = 7;

/// The first place that no sheet has.
pub(super) fn misplaced(xml: &[u8]) -> Option<String> {
    if xml.contains(&0) {
        return Some("in an encoding other than UTF-8".to_owned());
    }
    let mut rest = xml;
    while let Some(start) = rest.iter().position(|byte| *byte == b'<') {
        rest = &rest[start..];
        let passed = [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>")];
        let passed = passed
            .iter()
            .find(|(begin, _)| rest.starts_with(begin.as_bytes()));
        if let Some((_, end)) = passed {
            let mut windows = rest.windows(end.len());
            rest = &rest[windows.position(|window| window == end.as_bytes())? + end.len()..];
            continue;
        }
        match tag(rest) {
            Ok(length) => rest = &rest[length..],
            Err(found) => return Some(found),
        }
    }
    None
}

/// The length of a tag, or a place in it that no sheet has.
fn tag(text: &[u8]) -> Result<usize, String> {
    let mut at = 0;
    while let Some(offset) = text[at..].iter().position(|byte| b"\"'>".contains(byte)) {
        let sign = at + offset;
        if text[sign] == b'>' {
            return Ok(sign + 1);
        }
        let value = &text[sign + 1..];
        let Some(length) = value.iter().position(|byte| *byte == text[sign]) else {
            break;
        };
        let name = text[at..sign].trim_ascii_end();
        let name = name.strip_suffix(b"=").unwrap_or(name).trim_ascii_end();
        // Other names end alike, such as `xmlns:r`.
        let start = name.iter().rposition(u8::is_ascii_whitespace);
        let name = start.map_or(name, |start| &name[start + 1..]);
        let is_place = matches!(name, b"r" | b"ref");
        if is_place && !is_sound(&value[..length]) {
            return Err(String::from_utf8_lossy(&value[..length.min(40)]).into_owned());
        }
        at = sign + 1 + length + 1;
    }
    Ok(text.len())
}

/// Whether a place, or a range of them from first to last, can be in a sheet. A row alone is a place too.
fn is_sound(place: &[u8]) -> bool {
    let mut last = (0, 0);
    place.split(|byte| *byte == b':').all(|part| {
        let letters = part.iter().take_while(|byte| byte.is_ascii_alphabetic());
        let letters = letters.count();
        let digits = &part[letters..];
        let is_short = letters <= LETTERS && (1..=DIGITS).contains(&digits.len());
        if !is_short || !digits.iter().all(u8::is_ascii_digit) {
            return false;
        }
        let column = part[..letters].iter().fold(0, |column, letter| {
            column * 26 + u32::from(letter.to_ascii_uppercase() - b'A') + 1
        });
        let row = digits
            .iter()
            .fold(0, |row, digit| row * 10 + u32::from(digit - b'0'));
        let is_later = column >= last.0 && row >= last.1;
        last = (column, row);
        is_later
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_that_no_sheet_has_are_found() {
        let sound = [
            "<row r=\"7\"><c r='XFD1048576' t=\"s\"><v>1</v></c></row>",
            "<worksheet xmlns:r=\"http://x\"><dimension ref=\"A1:B2\"/><!-- r=\"AAAAAAAAAA1\" --><t>r=\"AAAAAAAAAA1\"</t>",
        ];
        assert!(sound.iter().all(|xml| misplaced(xml.as_bytes()).is_none()));
        let broken = [
            "<c r=\"AAAAAAAA1\">",
            "<x:row r = '12345678901'>",
            "<!-- ' --><c s=\"1\" r=\"A\">",
            "<dimension ref=\"B2:A1\"/>",
        ];
        assert!(broken.iter().all(|xml| misplaced(xml.as_bytes()).is_some()));
    }
}
