//! What becomes of responses with two readings, against the table in the book.

use crate::BANK;
use vibank::answer::{Doubt, Remark, Verdict};
use vibank::grade;
use vibank::instance::Instance;
use vibank::solution::Solution;
use vibank::unit::DecimalMark;

const PAGE: &str = include_str!("../../../book/src/teachers/grading.md");

#[test]
fn doubts_are_settled_as_the_book_says() {
    let bank = &*BANK;
    let (_, table) = PAGE.split_once("<!-- doubts -->").expect("the table");
    let rows = table.lines().skip_while(|line| !line.starts_with('|'));
    let rows = rows.take_while(|line| line.starts_with('|'));
    let (mut part, mut faults, mut count) = (None, Vec::new(), 0);
    for row in rows.skip(2) {
        let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
        let [place, response, verdicts @ ..] = &cells[..] else {
            panic!("cells: {row}");
        };
        let quoted = |cell: &str| -> Vec<String> {
            cell.split('`')
                .skip(1)
                .step_by(2)
                .map(str::to_owned)
                .collect()
        };
        if let [item, id] = &quoted(place)[..] {
            part = Some((item.clone(), id.clone()));
        }
        let (item, id) = part.clone().expect("a part");
        let template = bank.find(&item).expect("an item of the bank");
        let place = template.parts.iter().position(|own| own.has_id(&id));
        let place = place.expect("a part of the item");
        let response = &quoted(response)[0];
        assert_eq!(verdicts.len(), Doubt::ALL.len(), "{row}");
        for (doubt, due) in Doubt::ALL.into_iter().zip(verdicts) {
            let solution = Solution::of(Instance::of_source(template)).settling(doubt);
            let marking = grade::mark(&solution, place, response);
            count += 1;
            if marking.verdict.name() != *due {
                let found = marking.verdict.name();
                faults.push(format!(
                    "{item} {id} `{response}` {doubt:?}: {found}, not {due}"
                ));
            }
        }
    }
    assert!(count >= 20, "{count} verdicts");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn a_decimal_comma_that_is_set_is_no_doubt() {
    let bank = &*BANK;
    let template = bank
        .find("ch2/p2-centre-pinned-bar-cable")
        .expect("an item");
    let place = template
        .parts
        .iter()
        .position(|own| own.has_id("omega_n_value"));
    let place = place.expect("a part of the item");
    for doubt in Doubt::ALL {
        let instance = Instance::of_source(template);
        let solution = Solution::with_mark(instance, DecimalMark::Comma).settling(doubt);
        let marking = grade::mark(&solution, place, "6,124 rad/s");
        assert_eq!(marking.verdict, Verdict::Right, "{doubt:?}");
        let is_note = |remark: &Remark| format!("{remark:?}").contains("TakenAs");
        assert!(!marking.remarks.iter().any(is_note), "{doubt:?}");
    }
}
