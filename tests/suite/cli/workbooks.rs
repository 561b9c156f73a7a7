//! Workbooks of spreadsheets: class lists and answers that are read, marks and keys that are written.

#[cfg(not(feature = "xlsx"))]
use super::desk::Desk;

/// A program without them says which feature it lacks, and the way out.
#[cfg(not(feature = "xlsx"))]
#[test]
fn a_program_without_workbooks_says_so() {
    let desk = Desk::new("no-workbooks");
    super::put(&desk.folder, "class.xlsx", b"PK\x03\x04");
    let plan = desk.plan("seed = 1\nstudents = 'class.xlsx'");
    let ran = desk.sheet(&plan, &[]).ends(2);
    ran.complains("without the feature `xlsx`")
        .complains("save the table as CSV");
    let plan = desk.plan("seed = 1\nvariants = 1\nformats = ['md', 'xlsx']");
    let ran = desk.sheet(&plan, &[]).ends(2);
    ran.complains("without the feature `xlsx`")
        .complains("csv = \"excel\"");
    assert!(!desk.out.exists());
}

#[cfg(feature = "xlsx")]
mod with {
    use std::fs;
    use std::io::{Cursor, Write as _};

    use calamine::{Data, Reader as _, Xlsx};
    use rust_xlsxwriter::{ExcelDateTime, Format, Workbook, Worksheet};

    use super::super::desk::{Desk, all};
    use super::super::{Ran, put};

    /// A workbook with one sheet.
    fn book(fill: impl Fn(&mut Worksheet)) -> Vec<u8> {
        let mut book = Workbook::new();
        fill(book.add_worksheet());
        book.save_to_buffer().expect("it can be written")
    }

    fn texts(sheet: &mut Worksheet, row: u32, cells: &[&str]) {
        for (column, cell) in (0..).zip(cells) {
            sheet.write_string(row, column, *cell).expect("a cell");
        }
    }

    fn date(sheet: &mut Worksheet, row: u32, column: u16) {
        let format = Format::new().set_num_format("d.m.yyyy");
        let date = ExcelDateTime::from_ymd(2026, 2, 1).expect("a date");
        let written = sheet.write_datetime_with_format(row, column, &date, &format);
        written.expect("a cell");
    }

    fn sheet_of(name: &str, class: &[u8], more: &str) -> (Desk, Ran) {
        let desk = Desk::new(name);
        put(&desk.folder, "class.xlsx", class);
        let top = format!("seed = 3\nstudents = 'class.xlsx'\nformats = ['md', 'xlsx']\n{more}");
        let plan = desk.plan(&top);
        let ran = desk.sheet(&plan, &[]);
        (desk, ran)
    }

    /// The cells of a workbook that was written.
    fn cells(desk: &Desk, name: &str) -> Vec<Vec<Data>> {
        #[expect(
            clippy::disallowed_methods,
            reason = "a test looks at what was written"
        )]
        let bytes = fs::read(desk.out.join(name)).expect("it is there");
        let mut book: Xlsx<_> = Xlsx::new(Cursor::new(bytes)).expect("a workbook");
        let range = book.worksheet_range_at(0).expect("a sheet").expect("cells");
        range.rows().map(<[Data]>::to_vec).collect()
    }

    fn class() -> Vec<u8> {
        book(|sheet| {
            texts(sheet, 0, &["Nr", "name", "group", "born"]);
            // A number as a spreadsheet keeps it, a blank row, a formula that is a name, a date that means nothing here.
            sheet.write_number(1, 0, 1_234_567).expect("a cell");
            texts(sheet, 3, &["007", "=1+1"]);
            sheet.write_string(1, 1, "Zoé Doe, Jr.").expect("a cell");
            date(sheet, 1, 3);
        })
    }

    #[test]
    fn a_class_list_is_read_and_keys_are_written() {
        let columns = "columns = { id = 'Nr' }";
        let (desk, ran) = sheet_of("workbook-class", &class(), columns);
        ran.ends(0).says("key-table.xlsx");
        let manifest = desk.manifest();
        let ids: Vec<_> = (0..2)
            .map(|at| manifest["variants"][at]["student"]["id"].as_str())
            .collect();
        assert_eq!(ids, [Some("1234567"), Some("007")]);
        let keys = cells(&desk, "key-table.xlsx");
        assert_eq!(keys.len(), 3);
        assert_eq!(keys[0][4], Data::String("1a".into()));
        assert_eq!(keys[2][2], Data::String("=1+1".into()));
        assert!(
            keys[1][4..]
                .iter()
                .all(|key| matches!(key, Data::String(_)))
        );
        // The same run elsewhere gives the same bytes, and the same folder stays as it is.
        let (other, ran) = sheet_of("workbook-again", &class(), columns);
        ran.ends(0);
        for path in all(&desk.out) {
            let name = path.strip_prefix(&desk.out).expect("it is inside");
            #[expect(clippy::disallowed_methods, reason = "a test compares bytes")]
            let [one, two] = [&desk, &other].map(|desk| fs::read(desk.out.join(name)).ok());
            assert!(one == two, "{}", name.display());
        }
    }

    #[test]
    fn answers_are_read_and_marks_are_written() {
        let (desk, ran) = sheet_of("workbook-marks", &class(), "columns = { id = 'Nr' }");
        ran.ends(0);
        let form = desk.text("responses.csv");
        let rows: Vec<Vec<&str>> = form.lines().map(|line| line.split(',').collect()).collect();
        let answers = book(|sheet| {
            for (at, row) in (0..).zip(&rows) {
                texts(sheet, at, &row[..row.len() - 1]);
                let last = row.len() as u16 - 1;
                match at {
                    0 => drop(sheet.write_string(at, last, "response")),
                    1 => drop(sheet.write_number(at, last, 0.25)),
                    2 => date(sheet, at, last),
                    _ => drop(sheet.write_string(at, last, "see back")),
                }
            }
        });
        let answers = put(&desk.folder, "answers.xlsx", answers);
        let manifest = desk.path("manifest.json");
        let ran = desk.run(&["grade", &manifest, &answers]).ends(1);
        let ran = ran.complains("row 3, column `response`: a date");
        ran.says("marks.csv, marks.xlsx");
        assert!(desk.text("marks/details.csv").contains(",0.25,"));
        let marks = cells(&desk, "marks/marks.xlsx");
        let plain = desk.text("marks/marks.csv");
        for (book, line) in marks.iter().zip(plain.lines()) {
            let written = book.iter().map(|cell| match cell {
                Data::Float(number) => number.to_string(),
                other => other.to_string(),
            });
            let written = written.collect::<Vec<_>>().join(",");
            assert_eq!(written, line.replace('"', "").replace("'=", "="));
        }
        assert!(matches!(marks[1][5], Data::Float(_)), "sums are numbers");
        assert_eq!(marks[1][1], Data::String("1234567".into()), "ids are not");
        // What is packed cannot be taken apart, and goes as a whole.
        desk.forget("1234567", &[]).ends(0).says("marks.xlsx");
        for name in ["key-table.xlsx", "marks/marks.xlsx"] {
            assert!(!desk.out.join(name).exists(), "{name}");
        }
    }

    #[test]
    fn what_a_spreadsheet_has_spoilt_is_found() {
        let list = |fill: &dyn Fn(&mut Worksheet)| {
            book(|sheet| {
                texts(sheet, 0, &["id", "name", "seat"]);
                texts(sheet, 1, &["s1", "Zoé", "1-1"]);
                fill(sheet);
            })
        };
        let far = list(&|sheet| texts(sheet, 1_048_575, &["s9"]));
        sheet_of("workbook-far", &far, "").1.ends(0);
        let cases: [(Vec<u8>, &str); 4] = [
            (
                list(&|sheet| date(sheet, 1, 2)),
                "row 2, column `seat`: a date",
            ),
            (
                list(&|sheet| drop(sheet.write_string(1, 4, "lost"))),
                "row 2: a cell in a column without a heading",
            ),
            (
                list(&|sheet| drop(sheet.write_string(1, 16_383, "x"))),
                "row 2 has a cell beyond column 1000",
            ),
            (book(|_| ()), "is empty"),
        ];
        for (class, words) in cases {
            let (desk, ran) = sheet_of("workbook-spoilt", &class, "");
            ran.ends(2).complains(words);
            assert!(!desk.out.exists());
        }
    }

    /// The files of a workbook, one of them exchanged.
    fn exchanged(class: &[u8], name: &str, content: &[u8]) -> Vec<u8> {
        let mut old = zip::ZipArchive::new(Cursor::new(class)).expect("an archive");
        let mut new = zip::ZipWriter::new(Cursor::new(Vec::new()));
        let options = zip::write::SimpleFileOptions::default();
        for place in 0..old.len() {
            let mut file = old.by_index(place).expect("a file");
            let own = file.name().expect("a name").into_owned();
            new.start_file(own.as_str(), options).expect("a file");
            if own == name {
                new.write_all(content).expect("room");
            } else {
                std::io::copy(&mut file, &mut new).expect("room");
            }
        }
        new.finish().expect("an archive").into_inner()
    }

    #[test]
    fn hostile_workbooks_are_refused() {
        let class = class();
        let sheet = "xl/worksheets/sheet1.xml";
        let cases: [(Vec<u8>, &str); 6] = [
            (b"PK\x03\x04".to_vec(), "an archive that cannot be read"),
            (
                class[..class.len() / 2].to_vec(),
                "an archive that cannot be read",
            ),
            (
                exchanged(&class, sheet, &vec![b' '; 200 << 20]),
                "more than 128 MiB, unpacked",
            ),
            (
                exchanged(&class, sheet, b"<worksheet><sheetData><row"),
                "not well-formed XML",
            ),
            (exchanged(&class, sheet, b"\xff\xfe\0"), ""),
            (exchanged(&class, "xl/sharedStrings.xml", b"<sst/>"), ""),
        ];
        for (class, words) in cases {
            let (_, ran) = sheet_of("workbook-hostile", &class, "");
            ran.ends(2).complains("error: ").complains(words);
        }
    }

    /// Bytes of the files inside changed, doubled and taken away: a message or a run, no panic.
    #[test]
    fn broken_workbooks_break_nothing() {
        let class = class();
        let desk = Desk::new("workbook-broken");
        let plan = desk.plan("seed = 3\nstudents = 'class.xlsx'\nformats = ['md']");
        let mut archive = zip::ZipArchive::new(Cursor::new(&class)).expect("an archive");
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        let mut draw = |bound: usize| {
            state = state
                .wrapping_mul(0x5851_f42d_4c95_7f2d)
                .wrapping_add(0x1405_7b7e_f767_814f);
            (state >> 33) as usize % bound
        };
        let files = [
            "xl/worksheets/sheet1.xml",
            "xl/sharedStrings.xml",
            "xl/workbook.xml",
            "xl/styles.xml",
        ];
        for round in 0..160 {
            let name = files[round % files.len()];
            let mut content = Vec::new();
            let mut file = archive.by_name(name).expect("a file");
            std::io::copy(&mut file, &mut content).expect("room");
            drop(file);
            for _ in 0..=draw(4) {
                let at = draw(content.len());
                let end = (at + draw(40)).min(content.len());
                match draw(3) {
                    0 => content[at] = draw(256) as u8,
                    1 => drop(content.drain(at..end)),
                    _ => {
                        let piece = content[at..end].repeat(1 + draw(200));
                        content.splice(at..at, piece);
                    }
                }
            }
            put(
                &desk.folder,
                "class.xlsx",
                exchanged(&class, name, &content),
            );
            let ran = desk.sheet(&plan, &["--force"]);
            let is_sound = [0, 2].contains(&ran.code) && !ran.err.contains("panicked");
            assert!(is_sound, "round {round}: {}", ran.err);
        }
    }
}
