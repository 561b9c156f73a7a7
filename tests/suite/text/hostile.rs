//! Nothing that anybody writes makes a text panic, hang or print markup.

use proptest::prelude::*;
use vibank::document::{Document, Filling, read_math};
use vibank::math::{Display, Math, Voice};

/// Pieces of LaTeX, from which formulas right and wrong are put together.
const PIECES: &[&str] = &[
    "x",
    "y",
    "1",
    "2.5",
    "3,4",
    ".",
    ",",
    "+",
    "-",
    "=",
    "'",
    "^",
    "_",
    "{",
    "}",
    "(",
    ")",
    "[",
    "]",
    "|",
    "/",
    "*",
    " ",
    "&",
    r"\\ ",
    r"\frac",
    r"\sqrt",
    r"\sqrt[",
    r"\dot",
    r"\ddot",
    r"\dddot",
    r"\bar",
    r"\omega ",
    r"\Omega ",
    r"\cdot ",
    r"\sin ",
    r"\lim",
    r"\sum",
    r"\int",
    r"\limits",
    r"\text{a b}",
    r"\mathrm{kg}",
    r"\mathbf{",
    r"\left(",
    r"\right)",
    r"\left.",
    r"\right|",
    r"\begin{pmatrix}",
    r"\end{pmatrix}",
    r"\begin{cases}",
    r"\end{cases}",
    r"\begin{aligned}",
    r"\end{aligned}",
    r"\underbrace",
    r"\overset",
    r"\underset",
    r"\operatorname{sgn}",
    r"\,",
    r"\ ",
    r"\mkern7mu",
    r"\le ",
    r"\prime ",
    r"\degree ",
    r"\circ ",
    r"{,}",
    r"\tfrac12",
    r"\binom",
    r"\vec",
    r"\hat",
    r"\qty",
    r"\to ",
    r"\lvert ",
    r"\rvert ",
    r"\%",
    "~",
    "%",
    "$",
    "#",
    "ω",
    "é",
    r"\foo",
    r"\xrightarrow",
];

fn formula() -> impl Strategy<Value = String> {
    prop::collection::vec(prop::sample::select(PIECES), 0..14).prop_map(|pieces| pieces.concat())
}

proptest! {
    #![proptest_config(ProptestConfig::default())]

    #[test]
    fn what_reads_reads_back(source in formula()) {
        if let Ok(math) = read_math(&source) {
            let latex = math.latex();
            let again = read_math(&latex);
            prop_assert_eq!(again.as_ref(), Ok(&math), "{} -> {}", source, latex);
            math.mathml(Display::Block, Voice::ENGLISH);
            math.plain();
            math.spoken(Voice::ENGLISH);
        }
    }

    #[test]
    fn any_text_is_read_without_panic(text in any::<String>()) {
        let reading = Document::read(&text);
        reading.document.html(&Vec::<Filling>::new(), Voice::ENGLISH);
        reading.document.markdown(&Vec::<Filling>::new());
        reading.document.plain(&Vec::<Filling>::new());
        for error in reading.errors {
            prop_assert!(text.get(error.span().range()).is_some(), "{:?}", error);
        }
        let _ = read_math(&text);
    }

    #[test]
    fn texts_of_many_pieces_are_read_without_panic(
        pieces in prop::collection::vec(prop_oneof![
            prop::sample::select(PIECES),
            prop::sample::select(&[
                "$", "$$", "<<", ">>", "<< m >>", "<< x.given >>", "<< figure >>", "\\<<", "\n", "\n\n",
                "- ", "> ", "1. ", "| a | b |\n|---|---|\n| ", "```", "`", "**", "*", "<b>", "[a](", ")", "# ",
            ][..]),
        ], 0..40)
    ) {
        let text = pieces.concat();
        let reading = Document::read(&text);
        let json = serde_json::to_string(&reading.document).unwrap();
        let again: Document = serde_json::from_str(&json).unwrap();
        let fills: Vec<Filling> = Vec::new();
        prop_assert_eq!(again.html(&fills, Voice::ENGLISH), reading.document.html(&fills, Voice::ENGLISH));
        for error in reading.errors {
            prop_assert!(text.get(error.span().range()).is_some(), "{:?} in {:?}", error, text);
        }
    }

    #[test]
    fn words_are_never_markup(words in "[<>&\"'a-z$\\\\{}%#_^~ ]{0,40}") {
        let fills = vec![Filling::words(words.clone()), Filling::words(words.clone())];
        let document = Document::read("<< a >> and $x + << a >>$").document;
        let html = document.html(&fills, Voice::ENGLISH);
        let bare: String = html
            .split(['<', '>'])
            .enumerate()
            .filter(|(number, _)| number % 2 == 1)
            .map(|(_, tag)| tag.trim_start_matches('/').split(' ').next().unwrap_or_default().to_owned() + " ")
            .collect();
        prop_assert_eq!(bare, "p math mi mi mo mo mtext mtext math p ");
        if !words.contains('~') {
            let text = Math::Text(words.clone());
            let again = read_math(&text.latex()).unwrap();
            prop_assert_eq!(read_math(&again.latex()), Ok(again));
        }
    }
}

#[test]
fn depth_and_length_are_bounded() {
    for source in [
        "{".repeat(100_000),
        r"\sqrt".repeat(1_000) + "x",
        r"\dot ".repeat(1_000) + "x",
        r"\left(".repeat(1_000),
        "x^{".repeat(1_000) + &"}".repeat(1_000),
        r"\begin{pmatrix}".repeat(200),
        "'".repeat(8_000),
        "x".repeat(100_000),
    ] {
        let _ = read_math(&source);
        Document::read(&format!("${source}$"));
    }
    for text in [
        ">".repeat(60_000),
        "- ".repeat(30_000),
        "*a ".repeat(20_000),
        "[".repeat(60_000),
        "<< m >>".repeat(9_000),
        "`".repeat(60_000),
        "$".repeat(60_000),
        "| a ".repeat(10_000) + "\n" + &"|---".repeat(10_000),
    ] {
        let reading = Document::read(&text);
        serde_json::to_string(&reading.document)
            .ok()
            .and_then(|json| serde_json::from_str::<Document>(&json).ok())
            .expect("a compiled text reads back");
    }
}
