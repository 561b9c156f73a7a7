//! `[print]` of a blueprint: one file for the printer, lists for the room, names of files, large print, extra time.

use std::fs;
use std::path::Path;

use super::desk::{Desk, all};
use super::press::with_press;
use super::{content, put, text_of};

/// A class in two rooms, with what is granted to two of them.
const CLASS: &str = "id,name,group,room,seat,large print,extra time\n\
    s1,Ada Lovelace,B,H2,B1,,\n\
    s2,Ernst Mach,A,H1,A10,yes,25 %\n\
    s3,\"Müller, Anna\",B,H1,A9,,\n\
    s4,Emmy Noether,A,H2,A2,24 pt,\n\
    s5,王明,B,H2,,no,\n";

fn desk(name: &str) -> Desk {
    let desk = Desk::new(name);
    put(&desk.folder, "class.csv", CLASS);
    desk
}

/// A blueprint with these keys at its top and these in `[print]`.
fn plan(desk: &Desk, top: &str, print: &str) -> String {
    let question = "[[question]]\nitem = 'free/spring-mass'\n";
    let text = format!("title = 'T'\nsolutions = false\n{top}\n[print]\n{print}\n{question}");
    put(&desk.folder, "t.toml", text)
}

const CLASSES: &str = "seed = 5\nstudents = 'class.csv'\nspares = 2";

/// The places of words in a text, which has each of them.
#[track_caller]
fn places(text: &str, words: &[&str]) -> Vec<usize> {
    let place = |word: &&str| {
        text.find(*word)
            .unwrap_or_else(|| panic!("`{word}` is missing"))
    };
    words.iter().map(place).collect()
}

#[track_caller]
fn in_order(text: &str, words: &[&str]) {
    let places = places(text, words);
    assert!(places.is_sorted(), "{words:?} stand at {places:?}");
}

/// The codes in the manifest, in its order.
fn codes(desk: &Desk) -> Vec<String> {
    let manifest = desk.manifest();
    let variants = manifest["variants"].as_array().expect("it has sheets");
    let code = |variant: &serde_json::Value| variant["code"].as_str().expect("a code").to_owned();
    variants.iter().map(code).collect()
}

#[test]
fn one_file_for_the_printer_has_all_sheets_in_the_order_that_is_asked_for() {
    let desk = desk("print-order");
    for (order, names) in [
        (
            "class",
            ["Lovelace", "Mach", "Müller, Anna", "Noether", "王明"],
        ),
        (
            "group",
            ["Lovelace", "Müller, Anna", "王明", "Mach", "Noether"],
        ),
        // Rooms as the list has them first; who has no seat comes last.
        (
            "seat",
            ["Noether", "Lovelace", "王明", "Müller, Anna", "Mach"],
        ),
    ] {
        let plan = plan(&desk, CLASSES, &format!("order = '{order}'"));
        desk.sheet(&plan, &[]).ends(0).says("print/sheets.html");
        let printed = desk.text("print/sheets.html");
        assert_eq!(
            printed.matches("<article class=\"sheet").count(),
            7,
            "{order}"
        );
        let names = names.map(|name| format!("{name}</span>"));
        in_order(&printed, &names.each_ref().map(String::as_str));
        // The spare sheets come last.
        let codes = codes(&desk);
        let last = printed.rfind("class=\"code\"").expect("it has sheets");
        assert!(printed[last..].contains(&codes[6]), "{order}");
    }
}

#[test]
fn a_page_stands_before_each_group_or_room_and_before_the_spare_sheets() {
    let desk = desk("print-separators");
    let plan = plan(&desk, CLASSES, "order = 'seat'\nseparators = true");
    desk.sheet(&plan, &[]).ends(0);
    let printed = desk.text("print/sheets.html");
    assert_eq!(printed.matches("sheet separator").count(), 3);
    in_order(
        &printed,
        &[
            "Room H2",
            "3 sheets",
            "Noether</span>",
            "Room H1",
            "Müller, Anna</span>",
            "Spare sheets",
        ],
    );
}

#[test]
fn lists_name_who_sits_where_with_which_sheet() {
    let desk = desk("print-lists");
    desk.sheet(&plan(&desk, CLASSES, ""), &[])
        .ends(0)
        .says("print/attendance.html")
        .says("print/seating.html");
    let codes = codes(&desk);
    let attendance = desk.text("print/attendance.html");
    // In each room as the class list has them; nothing leads to a sheet.
    in_order(
        &attendance,
        &[
            "Room H2",
            "Ada",
            "Emmy",
            "王明",
            "Room H1",
            "Ernst",
            "Anna",
            "Spare sheets",
        ],
    );
    assert!(attendance.contains("Signature"));
    assert!(attendance.contains("large print, 18 pt; Extra time: 25 %"));
    assert!(attendance.contains("large print, 24 pt"));
    assert!(codes.iter().all(|code| !attendance.contains(code.as_str())));
    // In each room by seat, with the codes.
    let seating = desk.text("print/seating.html");
    in_order(
        &seating,
        &[
            "Room H2",
            ">A2<",
            ">B1<",
            "Room H1",
            ">A9<",
            ">A10<",
            "Spare sheets",
        ],
    );
    for (code, whose) in codes.iter().zip(["Ada", "Ernst", "Anna", "Emmy", "王明"]) {
        let row = seating
            .lines()
            .find(|line| line.contains(code.as_str()))
            .expect("a row");
        assert!(row.contains(whose), "{row}");
    }
    assert!(
        codes[5..]
            .iter()
            .all(|code| seating.contains(code.as_str()))
    );
}

#[test]
fn a_sheet_says_where_its_student_sits_and_what_is_granted() {
    let desk = desk("print-granted");
    desk.sheet(&plan(&desk, CLASSES, ""), &["--split"]).ends(0);
    let codes = codes(&desk);
    let sheet = |at: usize| desk.text(&format!("sheets/{}.html", codes[at]));
    let mach = sheet(1);
    assert!(mach.contains("Seat <span>H1, A10</span>"));
    assert!(mach.contains("Extra time: 25 %"));
    // 18 pt in place of 10.5 pt.
    assert!(mach.contains("--zoom: 1.714"));
    assert!(sheet(3).contains("--zoom: 2.28"));
    assert!(!sheet(0).contains("--zoom:") && !sheet(0).contains("Extra time"));
    assert!(!sheet(4).contains("--zoom:"), "`no` is not a large print");
    // A spare sheet has room for a seat.
    assert!(sheet(5).contains("Seat <span></span>"));
    // What comes back is read in the same size.
    let marks = text_of(&desk.folder.join("marks"));
    let form = desk.path("responses.csv");
    desk.run(&["grade", &desk.path("manifest.json"), &form, "--out", &marks]);
    let feedback = |at: usize| {
        content(
            desk.folder
                .join(format!("marks/feedback/{}.html", codes[at])),
        )
    };
    assert!(feedback(1).contains("class=\"sheet feedback large\""));
    assert!(feedback(1).contains("--zoom: 1.714") && feedback(3).contains("--zoom: 2.28"));
    assert!(!feedback(0).contains("--zoom:") && !feedback(4).contains("--zoom:"));
    // The questions are the same as in usual print.
    put(&desk.folder, "class.csv", CLASS.replace("yes", ""));
    desk.sheet(&plan(&desk, CLASSES, ""), &["--split"]).ends(0);
    assert_eq!(
        sheet(1).replace(" large\"", "\""),
        mach.replace(" large\"", "\"")
            .replace("; --zoom: 1.7142857142857142", "")
    );
}

/// Thirteen columns of 36 points were wider than the page.
#[test]
fn the_table_of_marks_has_fewer_columns_in_large_print() {
    let desk = Desk::new("print-columns");
    let list = "id,large_print\ns1,\ns2,18\ns3,36\ns4,8\n";
    put(&desk.folder, "class.csv", list);
    let questions = "[[question]]\nitem = 'free/spring-mass'\n".repeat(29);
    let top = "title = 'T'\nseed = 5\nstudents = 'class.csv'\nsolutions = false\n";
    let plan = put(&desk.folder, "t.toml", format!("{top}{questions}"));
    desk.sheet(&plan, &["--split"]).ends(0);
    let codes = codes(&desk);
    let rows = |at: usize| {
        let sheet = desk.text(&format!("sheets/{}.html", codes[at]));
        let (_, marks) = sheet
            .split_once("<div class=\"marks\">")
            .expect("it has marks");
        let marks = &marks[..marks.find("</div>").expect("it ends")];
        marks.matches("<table>").count()
    };
    // 30 columns, the sum among them.
    assert_eq!([0, 1, 2, 3].map(rows), [3, 5, 10, 3]);
}

#[test]
fn a_size_of_type_that_cannot_be_one_is_refused_with_its_line() {
    let desk = desk("print-size");
    put(&desk.folder, "class.csv", CLASS.replace("24 pt", "140"));
    desk.sheet(&plan(&desk, CLASSES, ""), &[])
        .ends(2)
        .complains("line 5")
        .complains("`140` is not a size of type");
}

/// The names in a folder of a run, in order.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    let name = |entry: std::io::Result<fs::DirEntry>| {
        let name = entry.expect("it can be listed").file_name();
        name.into_string().expect("it is UTF-8")
    };
    let mut names: Vec<String> = entries.map(name).collect();
    names.sort();
    names
}

#[test]
fn files_stand_in_the_order_of_the_list_under_id_and_name() {
    let desk = desk("print-files");
    let plan = plan(&desk, CLASSES, "files = 'student'");
    desk.sheet(&plan, &["--split"]).ends(0);
    let codes = codes(&desk);
    let spare = |at: usize| format!("{:03}-spare-{}.html", at + 1, codes[at]);
    let expected = [
        "001-s1-Ada-Lovelace.html".to_owned(),
        "002-s2-Ernst-Mach.html".to_owned(),
        "003-s3-Müller-Anna.html".to_owned(),
        "004-s4-Emmy-Noether.html".to_owned(),
        "005-s5-王明.html".to_owned(),
        spare(5),
        spare(6),
    ];
    assert_eq!(names(&desk.out.join("sheets")), expected);
    assert_eq!(names(&desk.out.join("keys")), expected);
    desk.sheet(&plan, &["--split"])
        .ends(0)
        .complains("7 sheets unchanged");
    // A student who leaves the list moves the names of those behind, whose sheets stay.
    put(
        &desk.folder,
        "class.csv",
        CLASS.replace("s1,Ada Lovelace,B,H2,B1,,\n", ""),
    );
    desk.sheet(&plan, &["--split"]).ends(0);
    let now = names(&desk.out.join("sheets"));
    assert_eq!(now.len(), 6);
    assert_eq!(now[0], "001-s2-Ernst-Mach.html");
}

#[test]
fn a_run_with_pseudonyms_prints_no_names_and_no_order_that_tells_them() {
    let desk = desk("print-pseudonyms");
    desk.secret();
    let top = "secret = 'exam.key'\nstudents = 'class.csv'\nspares = 2";
    let plan = plan(
        &desk,
        top,
        "order = 'seat'\nseparators = true\nfiles = 'student'",
    );
    let key = text_of(&desk.folder.join("who.csv"));
    desk.sheet(&plan, &["--split", "--pseudonyms", &key])
        .ends(0);
    assert_eq!(names(&desk.out.join("print")), ["sheets.html"]);
    for path in all(&desk.out) {
        let inside = path.strip_prefix(&desk.out).expect("it is inside");
        let name = text_of(inside);
        for word in [
            "Ada", "Lovelace", "Mach", "Noether", "王明", "H1, A", "Room",
        ] {
            assert!(
                !name.contains(word) && !content(&path).contains(word),
                "{word} in {name}"
            );
        }
    }
    let mut codes = codes(&desk);
    codes.sort();
    let printed = desk.text("print/sheets.html");
    let codes: Vec<String> = codes
        .iter()
        .map(|code| format!("variant <b>{code}"))
        .collect();
    in_order(
        &printed,
        &codes.iter().map(String::as_str).collect::<Vec<_>>(),
    );
}

#[test]
fn what_is_for_the_printer_needs_a_format_that_is_printed() {
    let desk = desk("print-formats");
    let plan = plan(
        &desk,
        &format!("{CLASSES}\nformats = ['md', 'json']"),
        "order = 'seats'",
    );
    desk.sheet(&plan, &[])
        .ends(2)
        .complains("`[print]` makes files for the printer")
        .complains("`order` cannot be `seats`");
}

#[test]
fn the_run_that_joins_shards_prints_them() {
    let desk = desk("print-shards");
    let plan = plan(&desk, &format!("{CLASSES}\nformats = ['html']"), "");
    for shard in ["2/2", "1/2"] {
        desk.sheet(&plan, &["--shard", shard]).ends(0);
    }
    assert!(!desk.out.join("print").exists());
    desk.sheet(&plan, &["--split"])
        .ends(0)
        .complains("7 sheets unchanged");
    assert!(desk.out.join("print/seating.html").is_file());
}

#[test]
fn a_student_who_is_forgotten_is_in_nothing_for_the_printer() {
    let desk = desk("print-forget");
    desk.sheet(&plan(&desk, CLASSES, ""), &[]).ends(0);
    desk.forget("s4", &[]).ends(0).says("print/seating.html");
    assert!(names(&desk.out.join("print")).is_empty());
}

#[test]
fn many_sheets_are_printed_in_pieces() {
    let desk = Desk::with_class("print-pieces", 70);
    let plan = plan(
        &desk,
        "seed = 5\nstudents = 'class.csv'\nformats = ['pdf']\nkeys = []",
        "",
    );
    let out = text_of(&desk.out);
    let run = ["sheet", &plan, "--out", &out, "--bank", super::BANK];
    with_press("echoes", &run)
        .ends(0)
        .says("print/sheets-*.pdf");
    assert_eq!(
        names(&desk.out.join("print")),
        [
            "attendance.pdf",
            "seating.pdf",
            "sheets-1.pdf",
            "sheets-2.pdf"
        ]
    );
    let sheets = |name: &str| {
        content(desk.out.join("print").join(name))
            .matches("#bound-sheet(true)[")
            .count()
    };
    assert_eq!([sheets("sheets-1.pdf"), sheets("sheets-2.pdf")], [64, 6]);
    with_press("echoes", &run)
        .ends(0)
        .complains("70 sheets unchanged");
    // What cannot be printed is named, and the run goes on.
    let other = plan.replace("t.toml", "u.toml");
    let text = content(&plan).replace("seed = 5", "seed = 6");
    put(&desk.folder, "u.toml", text);
    let out = text_of(&desk.folder.join("refused"));
    with_press(
        "refuses",
        &["sheet", &other, "--out", &out, "--bank", super::BANK],
    )
    .ends(3)
    .complains("could not be printed");
}

#[test]
fn the_table_of_keys_is_printed_in_pieces() {
    let text = "title = 'T'\nseed = 5\nsolutions = false\nstudents = 'class.csv'\nformats = ['pdf']\nkeys = ['table']\n\
        [[question]]\nitem = 'free/damped-block'\n";
    let made = |name: &str, students: usize, says: &str| {
        let desk = Desk::with_class(name, students);
        let plan = put(&desk.folder, "t.toml", text);
        let out = text_of(&desk.out);
        let run = ["sheet", &plan, "--out", &out, "--bank", super::BANK];
        with_press("echoes", &run).ends(0).says(says);
        desk
    };
    let desk = made("print-keys", 70, "key-table-*.pdf");
    let table = |name: &str| content(desk.out.join(name));
    let pieces = ["key-table-1.pdf", "key-table-2.pdf"].map(table);
    let codes = codes(&desk);
    for (piece, own) in pieces.iter().zip(codes.chunks(64)) {
        let (shared, rest) = piece.split_once(&own[0]).expect("it has the first sheet");
        assert!(
            shared.contains("All sheets"),
            "what they share stands first"
        );
        for code in &codes[1..] {
            assert!(!shared.contains(code), "{code}");
            let is_own = own[1..].contains(code);
            assert_eq!(rest.contains(code), is_own, "{code}");
        }
    }
    let manifest = content(desk.out.join("manifest.json"));
    assert!(manifest.contains("\"key-table-2.pdf\":\""));
    // What fits in one piece is one file.
    let small = made("print-keys-few", 2, "key-table.pdf");
    assert!(small.out.join("key-table.pdf").is_file());
}
