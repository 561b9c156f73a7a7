//! The XML of a workbook, looked over before it is read: `calamine` counts places of cells in 32 bits and does not look
//! whether they fit, and makes room for as many texts as a table of them claims to have.

use quick_xml::Reader;
use quick_xml::events::Event;

/// What the reader looks for in a sheet, wherever in the archive it stands: how far it reaches, and its cells.
const SHEET: [&[u8]; 2] = [b"dimension", b"sheetData"];

/// Letters and digits of the last place that a sheet has, `XFD1048576`.
const LETTERS: usize = 3;
// 1,048,576 rows, 2^20.
const DIGITS: usize = 7;

/// What would mislead the reader of a workbook in one of its files.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub(crate) enum Misleading {
    #[error("which is not well-formed XML: {0}")]
    Broken(String),
    #[error("in an encoding other than UTF-8")]
    Encoding,
    #[error("with `{0}`, which is not a place in a sheet")]
    Place(String),
    #[error("with `{0}` for the number of its texts, more than it has room for")]
    Count(String),
}

/// The first of what would mislead the reader, in a file of the archive.
pub(crate) fn misleading(file: &[u8]) -> Option<Misleading> {
    if !is_utf8(file.trim_ascii_start()) {
        return Some(Misleading::Encoding);
    }
    let is_sheet = SHEET
        .iter()
        .any(|name| file.windows(name.len()).any(|window| window == *name));
    if is_sheet && file.contains(&0) {
        return Some(Misleading::Encoding);
    }
    if let Some(count) = claimed(file) {
        return Some(Misleading::Count(count));
    }
    // Elsewhere names of attributes such as these mean other things.
    if is_sheet { misplaced(file) } else { None }
}

/// The first attribute of a sheet that should be a place and cannot be one.
///
/// The file is read by the same reader of XML, set up as `calamine` does it: one of our own would be led to see tags where
/// that one sees values.
fn misplaced(file: &[u8]) -> Option<Misleading> {
    let mut reader = Reader::from_reader(file);
    let config = reader.config_mut();
    config.check_end_names = false;
    config.check_comments = false;
    config.expand_empty_elements = true;
    let mut buffer = Vec::new();
    loop {
        buffer.clear();
        let tag = match reader.read_event_into(&mut buffer) {
            Ok(Event::Start(tag)) => tag,
            Ok(Event::Eof) => return None,
            Ok(_) => continue,
            Err(error) => return Some(Misleading::Broken(error.to_string())),
        };
        for attribute in tag.attributes() {
            let attribute = match attribute {
                Ok(attribute) => attribute,
                Err(error) => return Some(Misleading::Broken(error.to_string())),
            };
            let is_place = matches!(attribute.key.as_ref(), "r" | "ref");
            if is_place && !is_sound(attribute.value.as_bytes()) {
                return Some(Misleading::Place(
                    attribute.value.chars().take(40).collect(),
                ));
            }
        }
    }
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
            "<c s=\"'\" t='\"' r=\"AAAAAAAA1\">",
            "<dimension ref=\"B2:A1\"/>",
        ];
        let found = |xml: &&str| matches!(sheet(xml), Some(Misleading::Place(_)));
        assert!(broken.iter().all(found));
        // A file without cells may be a sheet too.
        let reach = b"<worksheet><dimension ref=\"officeDocument/2006\"/></worksheet>";
        assert!(matches!(misleading(reach), Some(Misleading::Place(_))));
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
