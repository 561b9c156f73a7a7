//! What the pages of vibank are as PDF: every text of the bank, tagged, the same bytes again; and LaTeX.

use vibank::answer::Verdict;
use vibank::bank::{Catalogue, embedded};
use vibank::document::{Document, Fill, Fills};
use vibank::grade::{Comment, Feedback, PartFeedback, QuestionFeedback};
use vibank::math::{Display, Math, TYPST_PRELUDE, Voice};
use vibank::numerics::Rational;
use vibank::output::{self, KeyTable, List, PageKind, Pages, Roll, Run};
use vibank::source::Source;
use vibank::worksheet::{Blueprint, Plan, PrintOrder, Sheet, Student};
use vibank_press::{Job, print};

/// The PDF of a finished text.
fn bound(text: String) -> Result<Vec<u8>, String> {
    let fonts = Vec::new();
    print(Job::Page { text, fonts })
}

fn blueprint(items: &[&str]) -> Blueprint {
    let mut text = String::from(
        "title = 'A \"title\" of #1, 50 % & more'\ncourse = 'C_1 \\ $x$'\nseed = 1\nvariants = 3\n",
    );
    for item in items {
        text.push_str(&format!("[[question]]\nitem = \"{item}\"\n"));
    }
    Blueprint::read(&Source::new("test.toml", text)).expect("it is sound")
}

/// The file of the first sheet, and the text that it was made of.
fn file(pages: &Pages, kind: PageKind, sheet: &Sheet<'_>) -> (Vec<u8>, String) {
    let begin = pages
        .begin(pages.subtitle(kind))
        .expect("the layout is sound");
    let page = pages.page(kind, sheet).expect("the layout is sound");
    let end = pages.end().expect("the layout is sound");
    let text = format!("{begin}{}{end}", page.text);
    let bytes = bound(text.clone());
    (
        bytes.unwrap_or_else(|error| panic!("{error}\n{text}")),
        text,
    )
}

fn pages(blueprint: &Blueprint, format: &str) -> Pages {
    let writer = output::writer(format).expect("the format is there");
    Pages::new(writer, Run::of(blueprint, writer), &[]).expect("the layouts are sound")
}

fn count(bytes: &[u8], mark: &str) -> usize {
    bytes
        .windows(mark.len())
        .filter(|window| *window == mark.as_bytes())
        .count()
}

/// One page of each chapter, each of its kinds: tagged, with embedded fonts, the same bytes again.
#[test]
fn sheets_are_tagged_pdf_of_the_same_bytes() {
    let (catalogue, _) = Catalogue::open(embedded());
    let blueprint = blueprint(&[
        "ch3/e4-underdamped-response",
        "ch5/e5-coupled-pendulums-modes",
    ]);
    let plan = Plan::of(&blueprint, &catalogue, None).expect("the items are there");
    let pages = pages(&blueprint, "pdf");
    let sheet = Sheet::draw(&plan, plan.variant(0, 0), None).expect("it can be drawn");
    for kind in [PageKind::Sheet, PageKind::Key, PageKind::Solutions] {
        let (bytes, _) = file(&pages, kind, &sheet);
        assert!(bytes.starts_with(b"%PDF-1."));
        assert!(count(&bytes, "/StructTreeRoot") > 0, "it has tags");
        assert!(count(&bytes, "pdfuaid:part") > 0, "it claims PDF/UA");
        assert_eq!(file(&pages, kind, &sheet).0, bytes);
    }
    let mut table = KeyTable::default();
    for index in 0..3 {
        let sheet = Sheet::draw(&plan, plan.variant(index, 0), None).expect("it can be drawn");
        table.add(output::key_row(&pages, &sheet));
    }
    let text = [
        pages
            .begin("answers of all variants")
            .expect("the layout is sound"),
        output::key_table_page(&pages, &table).expect("the layout is sound"),
        pages.end().expect("the layout is sound"),
    ];
    assert!(bound(text.concat()).is_ok());
}

/// What PDF/UA-1 (ISO 14289-1) asks of a file and can be seen from outside: it says so, it has tags, a language, a title that
/// is shown, an order of tabs on each page, and words for each figure and formula.
#[track_caller]
fn is_accessible(bytes: &[u8]) {
    for mark in [
        "<pdfuaid:part>1</pdfuaid:part>",
        "/StructTreeRoot",
        "/Marked true",
        "/Lang(en)",
        "/DisplayDocTitle true",
        "<dc:title>",
    ] {
        assert!(count(bytes, mark) > 0, "`{mark}` is missing");
    }
    let shown = count(bytes, "/S/Figure") + count(bytes, "/S/Formula");
    assert_eq!(
        count(bytes, "/Alt"),
        shown,
        "words for figures and formulas"
    );
    assert_eq!(
        count(bytes, "/Tabs/S"),
        pages_of(bytes),
        "the order of tabs"
    );
}

/// How many pages a file has.
fn pages_of(bytes: &[u8]) -> usize {
    count(bytes, "/Type/Page") - count(bytes, "/Type/Pages")
}

/// Students of whom one has a seat, one large print, one extra time; the last sheet is nobody's.
fn class() -> Vec<Student> {
    let student = |name: &str| Student {
        id: name.to_lowercase(),
        name: name.to_owned(),
        room: "H#1".to_owned(),
        ..Student::default()
    };
    let seat = "C7".to_owned();
    let extra_time = "25 % & $x$".to_owned();
    vec![
        Student {
            seat,
            ..student("Ada")
        },
        Student {
            type_size: Some(24),
            ..student("Ernst")
        },
        Student {
            extra_time,
            ..student("Emmy")
        },
    ]
}

#[test]
fn a_file_for_the_printer_is_accessible_and_each_sheet_has_an_even_number_of_pages() {
    let (catalogue, _) = Catalogue::open(embedded());
    let blueprint = blueprint(&[
        "ch3/e4-underdamped-response",
        "ch2/p3-parallel-springs-damper",
    ]);
    let plan = Plan::of(&blueprint, &catalogue, None).expect("the items are there");
    let students = class();
    let writer = output::writer("pdf").expect("the format is there");
    let run = Run::of(&blueprint, writer).with_seats(&students);
    let pages = Pages::new(writer, run, &[]).expect("the layouts are sound");
    let sheet = |place: usize| {
        let student = students.get(place).cloned();
        let sheet = Sheet::draw(&plan, plan.variant(place as u64, 0), student);
        let sheet = sheet.expect("it can be drawn");
        let page = pages
            .page(PageKind::Sheet, &sheet)
            .expect("the layout is sound");
        (sheet.variant.to_string(), page.text)
    };
    let (codes, texts): (Vec<String>, Vec<String>) = (0..4).map(sheet).unzip();
    let roll = Roll {
        students: &students,
        codes: &codes,
    };
    let file = |texts: &[String], duplex: bool| {
        let among = |text: &String| pages.among(text, duplex).expect("the layout is sound");
        let [begin, end] = [pages.begin(""), pages.end()].map(|text| text.expect("it is sound"));
        let body: String = texts.iter().map(among).collect();
        bound(format!("{begin}{body}{end}")).unwrap_or_else(|error| panic!("{error}"))
    };
    // Alone each has as many pages as it needs, and large print more than usual print.
    let alone: Vec<usize> = texts
        .iter()
        .map(|text| pages_of(&file(std::slice::from_ref(text), false)))
        .collect();
    assert!(alone[1] > alone[0], "{alone:?}");
    assert!(
        alone.iter().any(|count| count % 2 == 1),
        "a case without padding: {alone:?}"
    );
    let simplex = file(&texts, false);
    assert_eq!(pages_of(&simplex), alone.iter().sum::<usize>());
    let section = &PrintOrder::Seat.sections(&students, codes.len())[0];
    let separator = output::separator_page(&pages, section, roll).expect("the layout is sound");
    let all: Vec<String> = std::iter::once(separator).chain(texts).collect();
    let duplex = file(&all, true);
    is_accessible(&duplex);
    let even = |count: &usize| count + count % 2;
    assert_eq!(pages_of(&duplex), 2 + alone.iter().map(even).sum::<usize>());
    for list in List::ALL {
        let sections = PrintOrder::Seat.sections(&students, codes.len());
        let begin = pages
            .begin(pages.list_title(list))
            .expect("the layout is sound");
        let page = output::list_page(&pages, list, &sections, roll).expect("the layout is sound");
        let end = pages.end().expect("the layout is sound");
        let bytes = bound(format!("{begin}{page}{end}"));
        let bytes = bytes.unwrap_or_else(|error| panic!("{error}"));
        is_accessible(&bytes);
        assert_eq!(
            pages_of(&bytes),
            2,
            "a page for the room, one for the spare sheet"
        );
    }
}

/// Every text and key of a chapter: nothing in them is an error of Typst.
fn the_chapter_prints(chapter: &str) {
    let (catalogue, _) = Catalogue::open(embedded());
    let items: Vec<&str> = catalogue
        .items()
        .map(|template| template.id.as_str())
        .filter(|id| id.starts_with(chapter))
        .collect();
    assert!(items.len() > 10, "{items:?}");
    let blueprint = blueprint(&items);
    let plan = Plan::of(&blueprint, &catalogue, None).expect("the items are there");
    let sheet = Sheet::draw(&plan, plan.variant(0, 0), None).expect("it can be drawn");
    file(&pages(&blueprint, "pdf"), PageKind::Solutions, &sheet);
}

#[test]
fn chapter_1_prints() {
    the_chapter_prints("ch1/");
}

#[test]
fn chapter_2_prints() {
    the_chapter_prints("ch2/");
}

#[test]
fn chapter_3_prints() {
    the_chapter_prints("ch3/");
}

#[test]
fn chapter_4_prints() {
    the_chapter_prints("ch4/");
}

#[test]
fn chapter_5_prints() {
    the_chapter_prints("ch5/");
}

/// What a student wrote stands on the feedback page as it was written.
#[test]
fn nothing_typed_is_read_as_markup() {
    let typed = "#panic(\"x\") $x$ \\ \" ] ) } // /* `#` *_* <a> @b \\input{x} 50 % & ~^";
    let (points, max) = (Rational::ZERO, Rational::ONE);
    let part = PartFeedback {
        letter: "a".to_owned(),
        verdict: Verdict::Wrong,
        points,
        max,
        response: typed.to_owned(),
        reading: None,
        remarks: vec![Comment::sentence("Not `5 m`.")],
    };
    let feedback = Feedback {
        code: "X".to_owned(),
        name: typed.to_owned(),
        student: typed.to_owned(),
        points,
        max,
        open: Rational::ZERO,
        grade: None,
        type_size: None,
        questions: vec![QuestionFeedback {
            open: Rational::ZERO,
            number: 1,
            title: typed.to_owned(),
            points,
            max,
            parts: vec![part],
        }],
    };
    let blueprint = blueprint(&["ch3/e4-underdamped-response"]);
    let pages_of = |format| {
        let pages = pages(&blueprint, format);
        let begin = pages.begin("feedback").expect("the layout is sound");
        let page = output::feedback_page(&pages, &feedback).expect("the layout is sound");
        let end = pages.end().expect("the layout is sound");
        (format!("{begin}{page}{end}"), pages)
    };
    let (text, _) = pages_of("pdf");
    let quoted = typed.replace('\\', "\\\\").replace('"', "\\\"");
    assert_eq!(text.matches(&format!("#\"{quoted}\"")).count(), 4, "{text}");
    bound(text).expect("it is sound Typst");

    let (text, _) = pages_of("tex");
    assert!(
        text.contains(r"\#panic(\textquotedbl{}x\textquotedbl{}) \$x\$ \textbackslash{}"),
        "{text}"
    );
    assert!(!text.contains(r"\input{x}"));
}

/// A figure stands in a PDF as what it is, and beside LaTeX as a PDF of its own.
#[test]
fn figures_are_vectors_with_words() {
    const SVG: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"30mm\" height=\"10mm\" viewBox=\"0 0 300 100\">\
        <title>A &lt;spring&gt;</title><path d=\"M0 0L300 100\" stroke=\"currentColor\"/><text x=\"9\" y=\"50\" font-family=\"Libertinus Serif\">k</text></svg>";
    struct Figure;
    impl Fills for Figure {
        fn fill(&self, _: u32) -> Option<Fill<'_>> {
            Some(Fill::Figure(SVG))
        }
    }
    let reading = Document::read("See\n\n<< figure >>\n\nhere.");
    let typst = reading.document.typst(&Figure, Voice::ENGLISH);
    assert!(typst.contains("picture(\"A <spring>\",\"<svg "), "{typst}");
    let latex = reading.document.latex(&Figure);
    assert!(latex.contains(r"\figureblock{figure-"), "{latex}");
    let figure = || {
        let svg = SVG.to_owned();
        print(Job::Figure { svg }).expect("it is an SVG")
    };
    let picture = figure();
    assert!(picture.starts_with(b"%PDF-1."));
    assert_eq!(figure(), picture);
    assert_eq!(count(&picture, "/Subtype /Image"), 0, "it is not a bitmap");
}

#[test]
fn errors_of_a_layout_name_their_line() {
    let error = bound("#set document(title: [T])\n\n#nonsense".to_owned());
    let error = error.expect_err("there is no such name");
    assert!(
        error.contains("unknown variable: nonsense in line 3"),
        "{error}"
    );
}

/// Every kind of piece compiles, alone and inside the others.
#[test]
fn every_piece_of_a_formula_is_typst() {
    let letter = || Math::letter('x');
    let sum = || Math::row([letter(), Math::binary("+"), Math::number("2,5")]);
    let pieces = [
        Math::fraction(sum(), Math::letter('Ω')),
        Math::root(sum()),
        sum().fenced("(", ")"),
        sum().fenced("|", "|"),
        sum().in_parentheses(),
        letter()
            .derivative(2)
            .with_sub(Math::upright("eq"))
            .with_sup(Math::number("2")),
        Math::matrix(vec![
            vec![letter(), sum()],
            vec![Math::prefix("−"), letter()],
        ]),
        Math::cases(vec![
            vec![sum(), Math::text("if \"#x\" \\ , ; : & $")],
            vec![letter()],
        ]),
        Math::aligned(vec![
            vec![letter(), Math::row([Math::relation("="), sum()])];
            2
        ]),
        Math::row([
            Math::function("sin"),
            letter(),
            Math::Space(18),
            Math::operator("√;,:&#$\"/_^'", vibank::math::Class::Ordinary),
        ]),
        Math::Hole(0),
    ];
    let nested = pieces
        .iter()
        .map(|piece| Math::fraction(piece.clone(), Math::root(piece.clone())));
    let mut text = String::from(TYPST_PRELUDE);
    text.push_str("#set document(title: [T])\n");
    for math in pieces.iter().cloned().chain(nested.collect::<Vec<_>>()) {
        text.push_str(&math.typst(Display::Inline, Voice::ENGLISH));
        text.push_str(&math.typst(Display::Block, Voice::ENGLISH));
        text.push('\n');
    }
    if let Err(error) = bound(text.clone()) {
        panic!("{error}\n{text}");
    }
}

/// Names in these signs need no font of the machine.
#[test]
fn the_text_font_has_the_signs_that_it_is_said_to_have() {
    let signs: Vec<char> = ('\u{20}'..'\u{3000}')
        .filter(|sign| vibank_press_protocol::has_sign(*sign))
        .collect();
    assert!(signs.len() > 1400);
    for row in signs.chunks(64) {
        let text: String = row.iter().collect();
        let mut words = String::new();
        for sign in text.chars() {
            words.push_str(&format!("#\"\\u{{{:x}}}\" ", sign as u32));
        }
        let markup = format!(
            "#set document(title: [T])\n#set text(font: \"Libertinus Serif\", fallback: false)\n{words}"
        );
        // A sign without a letter is refused in an accessible file.
        bound(markup).unwrap_or_else(|error| panic!("{error}: {text}"));
    }
}
