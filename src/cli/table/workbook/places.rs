//! The XML of a workbook, looked over before it is read: `calamine` counts places of cells in 32 bits and does not look
//! whether they fit, and makes room for as many texts as a table of them claims to have.

/// What is in each sheet, wherever in the archive it stands.
const SHEET: &[u8] = b"sheetData";

/// Letters and digits of the last place that a sheet has, `XFD1048576`.
const LETTERS: usize = 3;
const DIGITS: usize = 7;

/// What would mislead the reader of a workbook in one of its files.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub(super) enum Misleading {
    #[error("in an encoding other than UTF-8")]
    Encoding,
    #[error("with `{0}`, which is no place in a sheet")]
    Place(String),
    #[error("with `{0}` for the number of its texts, more than it has room for")]
    Count(String),
}

/// The first of what would mislead the reader, in a file of the archive.
pub(super) fn misleading(file: &[u8]) -> Option<Misleading> {
    if !is_utf8(file.trim_ascii_start()) {
        return Some(Misleading::Encoding);
    }
    let is_sheet = file.windows(SHEET.len()).any(|window| window == SHEET);
    if is_sheet && file.contains(&0) {
        return Some(Misleading::Encoding);
    }
    if let Some(count) = claimed(file) {
        return Some(Misleading::Count(count));
    }
    let mut rest = file;
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
        match tag(rest, is_sheet) {
            Ok(length) => rest = &rest[length..],
            Err(found) => return Some(found),
        }
    }
    None
}

/// Whether a file is no XML, or XML that neither begins as one in another encoding does nor declares one.
fn is_utf8(file: &[u8]) -> bool {
    // Images and the like have zeros too, but none of them begins as XML does.
    let wide: [&[u8]; 4] = [b"\xfe\xff", b"\xff\xfe", b"<\0", b"\0<"];
    if wide.iter().any(|begin| file.starts_with(begin)) {
        return false;
    }
    let text = file.strip_prefix(b"\xef\xbb\xbf").unwrap_or(file);
    let Some(declaration) = text.strip_prefix(b"<?xml") else {
        return true;
    };
    let end = declaration.iter().position(|byte| *byte == b'>');
    let declaration =
        String::from_utf8_lossy(&declaration[..end.unwrap_or(declaration.len())]).to_lowercase();
    let Some((_, encoding)) = declaration.split_once("encoding") else {
        return true;
    };
    let mut quoted = encoding.split(['"', '\'']).skip(1);
    matches!(quoted.next(), Some("utf-8" | "utf8" | "us-ascii"))
}

/// The length of a tag; or a place in it that no sheet has.
fn tag(text: &[u8], is_sheet: bool) -> Result<usize, Misleading> {
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
        let value = &value[..length];
        let shown = || String::from_utf8_lossy(&value[..length.min(40)]).into_owned();
        // Elsewhere names such as these mean other things.
        if is_sheet && matches!(name, b"r" | b"ref") && !is_sound(value) {
            return Err(Misleading::Place(shown()));
        }
        at = sign + 1 + length + 1;
    }
    Ok(text.len())
}

/// More texts than the file has bytes, wherever in it that many are claimed: where quotation marks are out of step, the
/// reader finds attributes in what is a value for others.
fn claimed(file: &[u8]) -> Option<String> {
    const NAME: &[u8] = b"uniqueCount";
    let mut rest = file;
    while let Some(at) = rest.windows(NAME.len()).position(|window| window == NAME) {
        rest = &rest[at + NAME.len()..];
        let value = rest.trim_ascii_start();
        let value = value.strip_prefix(b"=").unwrap_or(value).trim_ascii_start();
        let value = value
            .strip_prefix(b"\"")
            .or_else(|| value.strip_prefix(b"'"));
        let value = value.unwrap_or_default().trim_ascii_start();
        let digits = value.strip_prefix(b"+").unwrap_or(value);
        let digits = &digits[..digits
            .iter()
            .take_while(|byte| byte.is_ascii_digit())
            .count()];
        let number = str::from_utf8(digits).unwrap_or_default();
        if !number.is_empty()
            && number
                .parse()
                .map_or(true, |count: usize| count > file.len())
        {
            return Some(number.chars().take(40).collect());
        }
    }
    None
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

    fn sheet(cells: &str) -> Option<Misleading> {
        misleading(format!("<worksheet><sheetData>{cells}").as_bytes())
    }

    #[test]
    fn places_that_no_sheet_has_are_found() {
        let sound = [
            "<row r=\"7\"><c r='XFD1048576' t=\"s\"><v>1</v></c></row>",
            "<x xmlns:r=\"http://x\"><dimension ref=\"A1:B2\"/><!-- r=\"AAAAAAAAAA1\" --><t>r=\"AAAAAAAAAA1\"</t>",
        ];
        assert!(sound.iter().all(|xml| sheet(xml).is_none()));
        let broken = [
            "<c r=\"AAAAAAAA1\">",
            "<x:row r = '12345678901'>",
            "<!-- ' --><c s=\"1\" r=\"A\">",
            "<dimension ref=\"B2:A1\"/>",
        ];
        let found = |xml: &&str| matches!(sheet(xml), Some(Misleading::Place(_)));
        assert!(broken.iter().all(found));
        // In other files the same names mean other things.
        assert_eq!(misleading(b"<mergeCell ref=\"x\"/>"), None);
    }

    #[test]
    fn a_table_of_texts_has_no_more_of_them_than_it_has_room_for() {
        let table = |count: &str| {
            misleading(format!("<sst uniqueCount=\"{count}\"><si><t>a</t></si></sst>").as_bytes())
        };
        assert_eq!(table("1"), None);
        for count in ["885616922839495", "99999999999999999999"] {
            assert_eq!(table(count), Some(Misleading::Count(count.to_owned())));
        }
        // Quotation marks out of step.
        let astray =
            "<sst xmlns=\"a<?xml version=\"1.0\"?><sst uniqueCount=\"885616922839495\"><si>";
        assert_eq!(
            misleading(astray.as_bytes()),
            Some(Misleading::Count("885616922839495".to_owned()))
        );
    }

    #[test]
    fn xml_is_in_utf8() {
        let wide: Vec<u8> = "<sst>".encode_utf16().flat_map(u16::to_le_bytes).collect();
        assert_eq!(misleading(&wide), Some(Misleading::Encoding));
        assert_eq!(misleading(b"<sheetData>\0"), Some(Misleading::Encoding));
        assert_eq!(
            misleading(b"<?xml version='1.0' encoding='UTF-16'?>"),
            Some(Misleading::Encoding)
        );
        for sound in [
            &b"\x89PNG\0\0"[..],
            b"<?xml version='1.0'?>",
            b"<?xml version=\"1.0\" encoding=\"UTF-8\"?>",
        ] {
            assert_eq!(misleading(sound), None);
        }
    }
}
