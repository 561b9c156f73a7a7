//! Any text as a response to a part of every kind: no panic, no hang, and too long a text is refused.
//! `fuzz/` does the same without end.

use std::cell::RefCell;

use proptest::prelude::*;
use vibank::answer::Verdict;
use vibank::bank::Catalogue;
use vibank::grade::{MAX_RESPONSE_LENGTH, mark, mark_among};
use vibank::instance::Instance;
use vibank::solution::Solution;

pub(super) fn catalogue() -> Catalogue {
    let (catalogue, _) = Catalogue::load([
        ("bank.toml", "format = 1\ntitle = 'Test'\n"),
        ("kinds/_chapter.toml", "title = 'Kinds'\n"),
        (
            "kinds/item.toml",
            include_str!("../../fixtures/kinds/item.toml"),
        ),
    ]);
    catalogue
}

/// The verdicts of all parts on one text.
fn verdicts(solution: &Solution<'_>, text: &str) -> Vec<Verdict> {
    let responses = vec![text; solution.template().parts.len()];
    (0..responses.len())
        .map(|place| mark_among(solution, place, &responses).verdict)
        .collect()
}

thread_local! {
    static SOLUTION: RefCell<Solution<'static>> = {
        let catalogue: &'static Catalogue = Box::leak(Box::new(catalogue()));
        RefCell::new(Solution::of(Instance::of_source(catalogue.items().next().unwrap())))
    };
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 150, ..ProptestConfig::default() })]

    #[test]
    fn any_text_is_marked(text in any::<String>()) {
        SOLUTION.with_borrow(|solution| verdicts(solution, &text));
    }

    #[test]
    fn any_signs_of_formulas_are_marked(text in "[0-9a-eijkmnxtω√πΩ²'=<>≤+*/^()\\[\\]{}_,;.|° \\\\-]{0,60}") {
        SOLUTION.with_borrow(|solution| verdicts(solution, &text));
    }

    #[test]
    fn any_words_of_formulas_are_marked(words in prop::collection::vec(prop::sample::select(WORDS), 0..24)) {
        SOLUTION.with_borrow(|solution| verdicts(solution, &words.concat()));
    }
}

const WORDS: &[&str] = &[
    "m", "k", "c", "l", "x1", "x2", "x1''", "t", "Omega", "omega_n", "mu", "2", "0.5", "1,5",
    "10^-3", "e", "pi", "i", "sqrt(", "sin(", "exp(", "\\frac{", "}{", "}", "(", ")", "[", "]",
    "+", "-", "*", "/", "^", " ", "=", ";", ",", "<", "≥", " or ", " at ", "∠", "°", " N/m",
    " rad/s", "dx1/dt", "\\ddot{", "|", "²", "±", "inf", "if ", "abs(",
];

#[test]
fn functions_told_by_their_own_rates_are_answered() {
    let catalogue = catalogue();
    let solution = Solution::of(Instance::of_source(catalogue.items().next().unwrap()));
    for text in [
        "x1 = x1'; x2 = x2'",
        "x1 = x2'; x2 = x1'",
        "x1 = A*x2 + x1''; x2 = dx1/dt",
        "x1', x2",
    ] {
        let verdicts = verdicts(&solution, text);
        assert!(!verdicts.contains(&Verdict::Right), "{text}: {verdicts:?}");
    }
}

#[test]
fn complex_numbers_multiplied_without_end_are_answered() {
    let catalogue = catalogue();
    let solution = Solution::of(Instance::of_source(catalogue.items().next().unwrap()));
    let power = format!("{}A+i{}", "(".repeat(20), ")^4".repeat(20));
    let inverse = format!("{}A+i{}", "1/(t+".repeat(40), ")".repeat(40));
    for formula in ["(A+i*t)*".repeat(60), power, inverse] {
        let formula = formula.trim_end_matches('*');
        let verdicts = verdicts(&solution, &format!("x1 = {formula}; x2 = {formula}"));
        assert!(!verdicts.contains(&Verdict::Right), "{formula}");
    }
}

#[test]
fn what_repeats_without_end_is_answered() {
    let catalogue = catalogue();
    let solution = Solution::of(Instance::of_source(catalogue.items().next().unwrap()));
    let most = MAX_RESPONSE_LENGTH;
    for word in [
        "(",
        "[",
        "{",
        "((",
        "[[",
        "x_{",
        "\\frac{",
        "\\sqrt{",
        "sqrt(",
        "sin",
        "-",
        "+",
        "^",
        "2^",
        "1/",
        "m/",
        "mkc",
        "d",
        "dx",
        "x'",
        "'",
        "|",
        ",",
        ";",
        "=",
        "x1=",
        "<",
        " or ",
        "or",
        "1 ",
        "1,",
        "1;",
        "9",
        "9e9",
        "é",
        "√",
        "°",
        "\\",
        "\\\\",
        "&",
        "_",
        "{}",
        "()",
        "[]",
        "∠",
        " at ",
        "e^",
        "exp(",
        "A cos(2t) + ",
        "m*",
        "(m+k)*",
        "N/",
        "kg ",
    ] {
        let count = most / word.len();
        for (before, after) in [("", ""), ("1", ""), ("(", ")"), ("x1 = ", "")] {
            for count in [count / 8, count - 4] {
                let text = format!("{before}{}{after}", word.repeat(count));
                let verdicts = verdicts(&solution, &text);
                assert!(!verdicts.contains(&Verdict::Missing), "{word}");
            }
        }
    }
}

#[test]
fn too_long_a_text_is_refused() {
    let catalogue = catalogue();
    let solution = Solution::of(Instance::of_source(catalogue.items().next().unwrap()));
    for text in ["1+".repeat(MAX_RESPONSE_LENGTH), " 9".repeat(1 << 20)] {
        for verdict in verdicts(&solution, &text) {
            assert_eq!(verdict, Verdict::Unreadable);
        }
    }
}

#[test]
fn every_kind_is_there() {
    let catalogue = catalogue();
    let parts = &catalogue.items().next().unwrap().parts;
    for kind in vibank::answer::AnswerKind::ALL {
        let is_there = parts
            .iter()
            .any(|part| part.answer.kind().name() == kind.name());
        assert!(is_there, "{}", kind.name());
    }
}

/// What was read is shown, and what is shown is read as the same.
#[test]
fn the_echo_of_an_answer_is_read_as_the_answer() {
    let catalogue = catalogue();
    let solution = Solution::of(Instance::of_source(catalogue.items().next().unwrap()));
    let typed = [
        "1- ms",
        "8628043927946727.00+0.005 m",
        "5 -248269997/s",
        "5 -3/s",
        "5 - 3 1/s",
        "0.6 < mu < 3.6",
        "360 deg deg",
        "360 deg/deg",
        "(360) °·°",
        "5 N m m",
        "0;0.002 m2  mm",
        "(1, 2) m2  mm",
        "[0, 2] s2 s",
    ];
    let mut faults = Vec::new();
    for text in typed {
        for place in 0..solution.template().parts.len() {
            let read = |text: &str| {
                mark(&solution, place, text)
                    .reading
                    .map(|reading| reading.text)
            };
            let first = read(text);
            let again = first.as_deref().and_then(read);
            if first != again {
                let id = &solution.template().parts[place].id;
                faults.push(format!("{id}: `{text}` is {first:?}, and that {again:?}"));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
