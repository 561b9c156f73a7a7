//! The examples of the book's page for students.

use vibank::instance::Instance;
use vibank::solution::Solution;

const PAGE: &str = include_str!("../../../book/src/students/typing.md");

#[test]
fn the_examples_of_the_book_are_marked_as_it_says() {
    let catalogue = super::hostile::catalogue();
    let solution = Solution::of(Instance::of_source(catalogue.items().next().unwrap()));
    let parts = &catalogue.items().next().unwrap().parts;
    let (mut faults, mut count) = (Vec::new(), 0);
    let mut asked: Option<(usize, &str)> = None;
    for line in PAGE.lines() {
        if let Some(comment) = line.strip_prefix("<!-- part: ") {
            let (part, verdict) = comment
                .trim_end_matches(" -->")
                .split_once(", ")
                .expect("a part and a verdict");
            let place = parts.iter().position(|own| own.has_id(part));
            asked = Some((place.expect("a part of the item"), verdict));
        }
        // A table ends with the section that it stands in.
        if line.starts_with('#') {
            asked = None;
        }
        let example = line
            .strip_prefix("| `")
            .and_then(|rest| rest.split_once('`'));
        let (Some((place, verdict)), Some((response, _))) = (asked, example) else {
            continue;
        };
        count += 1;
        let marking = vibank::grade::mark(&solution, place, response);
        if marking.verdict.name() != verdict {
            faults.push(format!(
                "`{response}`: {}, not {verdict}; {:?} {:?}",
                marking.verdict.name(),
                marking.reading.map(|reading| reading.text),
                marking.remarks
            ));
        }
    }
    assert!(count >= 60, "{count} examples");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
