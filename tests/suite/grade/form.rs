//! Values in place of formulas, formulas in place of values, and statements in both forms.

use crate::BANK;
use vibank::answer::{Credit, Verdict};
use vibank::grade::{Grade, Sheet};
use vibank::instance::Instance;
use vibank::seed::Seed;
use vibank::solution::Solution;
use vibank::wasm::Grader;
use vibank::worksheet::{Practice, PracticeQuestion};

const ITEM: &str = "ch2/p3-parallel-springs-damper";

/// The marking of a response to one part on a sheet that asks for these.
fn marked(
    part: &str,
    response: &str,
    asked: &[&str],
    share: Option<&str>,
) -> (Verdict, f64, String) {
    let template = BANK.find(ITEM).expect("the item");
    let set = [("m", "2 kg"), ("k1", "30 N/m"), ("k2", "20 N/m")];
    let instance = Instance::of(template, None, &set).expect("the data");
    let solution = Solution::of(instance);
    let place = |id: &str| {
        let found = template.parts.iter().position(|part| part.has_id(id));
        found.expect("the part")
    };
    let asked: Vec<usize> = asked.iter().map(|id| place(id)).collect();
    let sheet = Sheet {
        asked: &asked,
        other_form: share.and_then(Credit::read),
    };
    let grade = Grade::mark_on(&solution, &sheet, [(place(part), response)]);
    let marking = grade.part(place(part)).expect("it was marked");
    let remarks = format!("{:?}", marking.remarks);
    (marking.verdict, marking.credit.share().to_f64(), remarks)
}

#[test]
fn the_other_form_has_its_share_where_no_other_part_pays_for_it() {
    use Verdict::{Partial, Right, Unreadable};
    let both = ["omega_n", "omega_n_value"];
    for (part, response, asked, share, verdict, credit) in [
        ("omega_n", "5 rad/s", &both[..1], None, Partial, 0.5),
        ("omega_n", "5", &both[..1], Some("0.25"), Partial, 0.25),
        ("omega_n", "5 rad/s", &both[..1], Some("0"), Unreadable, 0.0),
        ("omega_n", "5 rad/s", &both[..], None, Unreadable, 0.0),
        ("omega_n", "6 rad/s", &both[..1], None, Unreadable, 0.0),
        (
            "omega_n_value",
            "sqrt((k1+k2)/m)",
            &both[1..],
            None,
            Partial,
            0.5,
        ),
        (
            "omega_n_value",
            "sqrt((k1+k2)/m)",
            &both[..],
            None,
            Unreadable,
            0.0,
        ),
        (
            "omega_n_value",
            "sqrt((k1-k2)/m)",
            &both[1..],
            None,
            Unreadable,
            0.0,
        ),
        ("omega_n_value", "5 rad/s", &both[..], None, Right, 1.0),
        ("eom", "5 rad/s", &["eom"][..], None, Unreadable, 0.0),
    ] {
        let (found, paid, why) = marked(part, response, asked, share);
        assert_eq!(
            (found, paid),
            (verdict, credit),
            "{part}: {response} on {asked:?}: {why}"
        );
    }
}

/// `l` and `g` are a litre and a gram as well.
#[test]
fn letters_that_are_units_are_a_formula_where_that_is_right() {
    let verdict = |item: &str, id: &str, response: &str| {
        let template = BANK.find(item).expect("the item");
        let place = template.parts.iter().position(|part| part.has_id(id));
        let place = place.expect("the part");
        let solution = Solution::of(Instance::of_source(template));
        let grade = Grade::mark(&solution, [(place, response)]);
        grade.part(place).expect("it was marked").verdict
    };
    let pendulum = "ch2/e4-simple-pendulum";
    for response in ["2*pi*sqrt(l/g)", "T0 = 2 pi sqrt(l/g)", "2π√(ℓ/g)"] {
        assert_eq!(
            verdict(pendulum, "T0", response),
            Verdict::Partial,
            "{response}"
        );
    }
    for response in ["1/(2pi) sqrt(g/l)", "5 kg", "2*pi*sqrt(2 l/g)"] {
        assert_eq!(
            verdict(pendulum, "T0", response),
            Verdict::Wrong,
            "{response}"
        );
    }
    assert_eq!(
        verdict("ch2/e7-lc-circuit", "T0", "2*pi*sqrt(L*C)"),
        Verdict::Partial
    );
    // A zero of another dimension has no letters.
    assert_eq!(
        verdict("ch5/t7-ring-of-three", "omega1", "0 kg"),
        Verdict::Wrong
    );
}

#[test]
fn a_statement_in_both_forms_counts_by_the_one_that_is_asked() {
    use Verdict::{Right, Wrong};
    let both = ["omega_n", "omega_n_value"];
    for (part, response, verdict) in [
        ("omega_n", "omega_n = sqrt((k1+k2)/m) = 5 rad/s", Right),
        ("omega_n", "sqrt((k1+k2)/m) = 5 rad/s", Right),
        ("omega_n", "omega_n = 5 rad/s = sqrt((k1+k2)/m)", Right),
        ("omega_n", "omega_n = sqrt((k1+k2)/m) = 7 rad/s", Wrong),
        ("omega_n", "omega_n = sqrt(m/(k1+k2)) = 5 rad/s", Wrong),
        (
            "omega_n_value",
            "omega_n = sqrt((k1+k2)/m) = 5 rad/s",
            Right,
        ),
        ("omega_n_value", "sqrt((k1+k2)/m) = 5 rad/s", Right),
        // Letters of a textbook and data that were substituted are as frequent before a right value.
        ("omega_n_value", "omega_n = sqrt(k1/m) = 5 rad/s", Right),
        (
            "omega_n_value",
            "omega_n = sqrt((k1+k2)/m) = 7 rad/s",
            Wrong,
        ),
    ] {
        let (found, _, why) = marked(part, response, &both, None);
        assert_eq!(found, verdict, "{part}: {response}: {why}");
    }
}

const SHEETS: &str = include_str!("../../corpora/sheets.tsv");

#[test]
fn answers_on_sheets_are_marked_as_they_were_meant() {
    let (mut faults, mut count) = (Vec::new(), 0);
    for line in SHEETS.lines().filter(|line| !line.starts_with('#')) {
        let [item, part, seed, verdict, response] = line.split('\t').collect::<Vec<_>>()[..] else {
            panic!("item, part, seed, verdict, response: {line}");
        };
        let template = BANK.find(item).expect("the item");
        // Within its group, if it has one.
        let is_it = |id: &str| id.rsplit('.').next() == Some(part);
        let place = template.parts.iter().position(|own| is_it(&own.id));
        let place = place.unwrap_or_else(|| panic!("{item} has no part {part}"));
        let seed = Seed::new(seed.parse().expect("a number"));
        let solution = Solution::of(Instance::draw(template, seed).expect("the data"));
        let grade = Grade::mark(&solution, [(place, response)]);
        let marking = grade.part(place).expect("it was marked");
        count += 1;
        if marking.verdict.name() != verdict {
            let found = marking.verdict.name();
            faults.push(format!(
                "{item} {part} `{response}`: {found}, not {verdict}; {:?}",
                marking.remarks
            ));
        }
    }
    assert!(count > 50, "{count} answers");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn alternatives_have_no_better_one() {
    for part in ["omega_n", "omega_n_value"] {
        for response in [
            "5 rad/s; sqrt((k1+k2)/m)",
            "5 rad/s or 6 rad/s",
            "5 rad/s\n6 rad/s",
            "sqrt((k1+k2)/m) or sqrt(k1/m)",
            "sqrt((k1+k2)/m)\nsqrt(k1/m)",
        ] {
            let (found, credit, why) = marked(part, response, &[part], None);
            assert_eq!(credit, 0.0, "{part}: {response}: {found:?} {why}");
        }
    }
}

/// The credit of a value for `omega_n` on a page that asks for these parts.
fn credit_on_page(asked: &[&str], share: Option<f64>) -> f64 {
    let catalogue = &*BANK;
    let item = catalogue.find(ITEM).expect("the item");
    let (mut practice, items) = Practice::of_items(catalogue, &[item], "Practice");
    practice.other_form = share;
    practice.questions = vec![PracticeQuestion {
        parts: asked.iter().map(|id| (*id).to_owned()).collect(),
        set: [("m", "2 kg"), ("k1", "30 N/m"), ("k2", "20 N/m")]
            .map(|(name, value)| (name.to_owned(), value.to_owned()))
            .to_vec(),
        ..PracticeQuestion::of(item, 0, "Free vibrations")
    }];
    let grader = Grader::of(&practice.lines(&items)).expect("a page");
    let read = |text: String| -> serde_json::Value { serde_json::from_str(&text).expect("JSON") };
    let chosen = read(grader.answer(r#"{"do":"choose","question":0,"from":7}"#));
    let request = serde_json::json!({
        "do": "mark", "question": 0, "code": chosen["code"], "part": "omega_n", "response": "5 rad/s",
    });
    let marked = read(grader.answer(&request.to_string()));
    let credit = &marked["credit"];
    credit
        .as_f64()
        .unwrap_or_else(|| panic!("no credit in {marked}"))
}

#[test]
fn a_page_pays_for_the_other_form_by_the_parts_that_it_asks() {
    assert_eq!(credit_on_page(&["omega_n"], None), 0.5);
    assert_eq!(credit_on_page(&["omega_n"], Some(0.25)), 0.25);
    assert_eq!(credit_on_page(&["omega_n", "omega_n_value"], None), 0.0);
    assert_eq!(credit_on_page(&[], None), 0.0);
}
