//! Tables as spreadsheets write and open them: class lists, forms, marks.

use std::path::Path;

use serde_json::Value as Json;

use super::{blueprint, content, folder, put, small, text_of};

const TOP: &str = "seed = 5\nstudents = \"class.csv\"\nformats = [\"md\"]";

/// Makes the sheets of a class list; the students in the manifest, as `id name group`.
fn students(folder: &Path, list: &[u8], top: &str) -> Vec<String> {
    put(folder, "class.csv", list);
    let plan = put(folder, "test.toml", blueprint(top));
    let out = folder.join("out");
    let _ = std::fs::remove_dir_all(&out);
    small(&["sheet", &plan, "--out", &text_of(&out)]).ends(0);
    let manifest: Json = serde_json::from_str(&content(out.join("manifest.json"))).expect("JSON");
    let variants = manifest["variants"].as_array().expect("it has variants");
    let word = |variant: &Json, name: &str| {
        let word = variant["student"][name].as_str().unwrap_or_default();
        word.to_owned()
    };
    let student = |variant| {
        ["id", "name", "group"]
            .map(|name| word(variant, name))
            .join(" | ")
    };
    variants.iter().map(student).collect()
}

fn utf16(text: &str) -> Vec<u8> {
    let units = std::iter::once(0xfeff).chain(text.encode_utf16());
    units.flat_map(u16::to_le_bytes).collect()
}

#[test]
fn class_lists_are_read_as_spreadsheets_save_them() {
    let folder = folder("class-dialects");
    let class = ["007 | Zoé Doe, Jr. | A", "008 | Jürgen Straße | B"];
    let plain = "id,name,group\n007,\"Zoé Doe, Jr.\",A\n008,Jürgen Straße,B\n";
    let lists: [Vec<u8>; 7] = [
        plain.into(),
        format!("\u{feff}{}", plain.replace('\n', "\r\n")).into(),
        // Unicode text of Excel: UTF-16 with tabs.
        utf16("Student ID\tFull Name\tSection\r\n007\tZoé Doe, Jr.\tA\r\n008\tJürgen Straße\tB\r\n"),
        // CSV of a French Excel, by the code page: é is E9, ü FC, ß DF, ° B0.
        b"N\xb0 \xe9tudiant;Nom;Pr\xe9nom;Groupe\r\n007;Doe, Jr.;Zo\xe9;A\r\n008;Stra\xdfe;J\xfcrgen;B\r\n".into(),
        "sep=;\nNachname;Vorname;Matrikelnummer;Gruppe\nDoe, Jr.;Zoé;007;A\nStraße;Jürgen;008;B\n".into(),
        // Blank rows, rows of empty cells, blanks around cells, columns without a heading and without cells.
        "\n,,,\n id , name ,group,\n\n 007 , \"Zoé Doe, Jr.\" , A ,\n,,,\n008,Jürgen Straße,B,\n,,\n".into(),
        "First name;Last name;ID;Group;Mail\rZoé;Doe, Jr.;007;A;z@x\rJürgen;Straße;008;B;\r".into(),
    ];
    for list in lists {
        let shown = String::from_utf8_lossy(&list).into_owned();
        assert_eq!(students(&folder, &list, TOP), class, "{shown}");
    }
}

#[test]
fn characters_without_ink_are_no_part_of_a_name() {
    let folder = folder("class-invisible");
    let list = "id,name\n\u{feff}7,\u{202e}Ze\u{301}\u{200b} Doe\u{202c}\u{200f}\n";
    let top = TOP.replace("\"md\"", "\"md\", \"html\"");
    assert_eq!(
        students(&folder, list.as_bytes(), &top),
        ["7 | Z\u{e9} Doe | "]
    );
    let page = content(folder.join("out/sheets.html"));
    assert!(page.contains("Z\u{e9} Doe") && !page.contains('\u{202e}'));
}

#[test]
fn a_blueprint_says_what_its_class_list_calls_things() {
    let folder = folder("class-columns");
    let list = "Nr;Wer;Rufname;Team\n1;Doe;Ada;x\n";
    let columns = "columns = { id = \"nr\", name = [\"Rufname\", \"Wer\"], group = \"Team\" }";
    let top = format!("{TOP}\n{columns}");
    assert_eq!(
        students(&folder, list.as_bytes(), &top),
        ["1 | Ada Doe | x"]
    );
    let sheet = |top: &str| {
        let plan = put(&folder, "test.toml", blueprint(top));
        let out = text_of(&folder.join("none"));
        small(&["sheet", &plan, "--out", &out]).ends(2)
    };
    sheet(TOP).complains("`Nr`, `Wer`, `Rufname`, `Team`");
    sheet(&format!("{TOP}\ncolumns = {{ id = \"Nummer\" }}")).complains("no column `Nummer`");
    sheet("seed = 5\nvariants = 2\ncolumns = { id = \"Nr\" }")
        .complains("headings of a class list");
    sheet(&format!("{TOP}\ncolumns = {{ ident = \"Nr\" }}")).complains("ident");
}

#[test]
fn a_class_list_that_would_lose_a_student_is_refused_with_the_line() {
    let folder = folder("class-broken");
    let plan = put(&folder, "test.toml", blueprint(TOP));
    let out = text_of(&folder.join("out"));
    for (list, line, words) in [
        // A quote that is not closed swallowed everybody behind it.
        (
            "id,name,group\n1,Ada,A\n2,\"Bob,A\n3,Cleo,B\n4,Dan,B\n",
            3,
            "quote is not closed",
        ),
        (
            "id,name,group\n1,Ada,A\n2,\"Bob,A\n3,\"Cleo,B\n4,Dan,B\n",
            3,
            "quote is not closed",
        ),
        // A comma in a name shifts the columns after it.
        (
            "id,name,group\n1,Ada,A\n2,Doe, Bob,A\n",
            3,
            "more cells than the header",
        ),
        (
            "id;name;group\n1;Ada;A\n\n2;Doe; Bob;A\n",
            4,
            "more cells than the header",
        ),
        (
            "id,name,group,,\n1,Ada,A,,\n2,Doe, Bob,A,\n",
            3,
            "more cells than the header",
        ),
        ("id,name\n1,\"Ada\" Lovelace\n", 2, "after the quote"),
        ("id,name\n1,Ada\n,Bob\n", 3, "without `id`"),
        (
            "id,name\n1,Ada\n2,Bob\n1,Cleo\n",
            4,
            "two students `1`, the first in line 2",
        ),
        // The accent is part of the letter in one row, and a letter of its own in the other.
        (
            "id,name\nren\u{e9},Ada\nrene\u{301},Bob\n",
            3,
            "two students `ren\u{e9}`, the first in line 2",
        ),
        // What would be printed on each page of a sheet.
        (
            &format!("id,name\n1,Ada\n2,{}\n", "N".repeat(1_000_000)),
            3,
            "`name` has 1000000 letters, at most 300 are read",
        ),
        (
            &format!("id,name\n{}\n", ";".repeat(1_000_000)),
            2,
            "`id` has 1000000 letters, at most 100 are read",
        ),
        // A spreadsheet has rounded the numbers, so that they would be nobody's.
        (
            "id;name\n1,23E+11;Ada\n",
            2,
            "`1,23E+11`, which a spreadsheet has made of a long number",
        ),
        (
            "id,,name\n1,x,Ada\n",
            2,
            "column 2 has no heading; give it one, or empty it",
        ),
    ] {
        put(&folder, "class.csv", list);
        small(&["sheet", &plan, "--out", &out])
            .ends(2)
            .complains(&format!("line {line}:"))
            .complains(words);
        assert!(!folder.join("out").exists(), "{list}");
    }
    put(&folder, "class.csv", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1");
    small(&["sheet", &plan, "--out", &out])
        .ends(2)
        .complains("save it as CSV");
}

#[test]
fn what_a_class_list_may_not_mean_is_said_with_its_lines() {
    let folder = folder("class-notes");
    let list = "id,name,room,seat,format\n1,Ada,H,A1,\n2,Bob,H,a1,tablet\n3,Cleo,G,A1,screen\n4,Dan,G,window,paper\n";
    put(&folder, "class.csv", list);
    let plan = put(&folder, "test.toml", blueprint(TOP));
    small(&["sheet", &plan, "--out", &text_of(&folder.join("out"))])
        .ends(0)
        .complains("seats that two students have: `a1` of `1` (line 2) and `2` (line 3)")
        .complains("no neighbours are known: `window` of `4` (line 5)")
        .complains("words under `format`: `tablet` of `2` (line 3)");
}

#[test]
fn tables_for_a_spreadsheet_have_semicolons_a_mark_and_the_decimal_sign_of_the_class() {
    let folder = folder("excel");
    put(&folder, "class.csv", "id,name\n1,Zoé\n");
    for (top, delimiter, comma) in [
        ("decimal = \",\"", ';', true),
        ("csv = \"excel\"", ';', false),
        ("decimal = \",\"\ncsv = \"plain\"", ',', false),
    ] {
        let top = format!("{TOP}\n{top}");
        let plan = put(
            &folder,
            "test.toml",
            blueprint(&top).replacen("half-cycles\"", "half-cycles\"\npoints = 2.5", 1),
        );
        let out = folder.join("out");
        let _ = std::fs::remove_dir_all(&out);
        small(&["sheet", &plan, "--out", &text_of(&out)]).ends(0);
        let form = content(out.join("responses.csv"));
        let head = [
            "code", "student", "question", "part", "kind", "unit", "response",
        ];
        let head = head.join(&delimiter.to_string());
        let mark = if delimiter == ';' { "\u{feff}" } else { "" };
        assert!(form.starts_with(&format!("{mark}{head}\n")), "{form}");
        // As it is filled in and saved by the spreadsheet: read as it was written.
        let row = form.lines().nth(1).expect("it has a row");
        let filled = form.replacen(row, &format!("{row}1,5 rad/s"), 1);
        let filled = if delimiter == ';' {
            utf16(&filled[3..])
        } else {
            filled.replace("1,5 rad/s", "\"1,5 rad/s\"").into()
        };
        let filled = put(&folder, "filled.csv", filled);
        let manifest = text_of(&out.join("manifest.json"));
        small(&["grade", &manifest, &filled]).ends(0);
        let marks = content(out.join("marks/marks.csv"));
        let max = if comma { "8,5" } else { "8.5" };
        assert!(marks.starts_with(mark), "{marks}");
        let row: Vec<&str> = marks
            .lines()
            .nth(1)
            .expect("a row")
            .split(delimiter)
            .collect();
        assert_eq!((row[1], row[2], row[5]), ("1", "Zoé", max), "{marks}");
        for table in ["details.csv", "report.csv", "unreadable.csv"] {
            let text = content(out.join("marks").join(table));
            assert_eq!(text.starts_with('\u{feff}'), delimiter == ';', "{table}");
        }
        let details = content(out.join("marks/details.csv"));
        assert!(details.contains("1,5 rad/s"), "{details}");
    }
}
