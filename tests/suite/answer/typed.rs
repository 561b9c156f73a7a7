//! Answers as people type them, of every kind, and what they are marked as.

use crate::BANK;
use vibank::answer::{At, Remark, Unreadable};
use vibank::grade;
use vibank::instance::Instance;
use vibank::solution::Solution;

const TYPED: &str = include_str!("../../corpora/typed.tsv");

#[test]
fn typed_answers_are_marked_as_they_were_meant() {
    let catalogue = super::hostile::catalogue();
    let solution = Solution::of(Instance::of_source(catalogue.items().next().unwrap()));
    let parts = &catalogue.items().next().unwrap().parts;
    let (mut faults, mut count) = (Vec::new(), 0);
    for line in TYPED.lines().filter(|line| !line.starts_with('#')) {
        let fields: Vec<&str> = line.split('\t').collect();
        let [part, verdict, response] = fields[..] else {
            panic!("part, verdict, response: {line}");
        };
        let place = parts.iter().position(|own| own.has_id(part));
        let place = place.expect("a part of the item");
        // `\neq` is a command.
        let response = response
            .replace("\\neq", "≠")
            .replace("\\n", "\n")
            .replace('⇥', "\t");
        let mut responses = vec![""; parts.len()];
        responses[place] = &response;
        let marking = grade::mark_among(&solution, place, &responses);
        count += 1;
        if marking.verdict.name() != verdict {
            faults.push(format!(
                "{part} `{response}`: {}, not {verdict}; {:?} {:?}",
                marking.verdict.name(),
                marking.reading.map(|reading| reading.text),
                marking.remarks
            ));
        }
    }
    assert!(count >= 400, "{count} answers");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

const ITEMS: &str = include_str!("../../corpora/items.tsv");

#[test]
fn answers_to_parts_of_the_bank_are_marked_as_they_were_meant() {
    let bank = &*BANK;
    let (mut faults, mut count) = (Vec::new(), 0);
    for line in ITEMS.lines().filter(|line| !line.starts_with('#')) {
        let fields: Vec<&str> = line.split('\t').collect();
        let (fields, set) = match fields[..] {
            [item, part, verdict, response] => ([item, part, verdict, response], None),
            [item, part, verdict, response, set] => ([item, part, verdict, response], Some(set)),
            _ => panic!("item, part, verdict, response, data: {line}"),
        };
        let [item, part, verdict, response] = fields;
        let set: Vec<(&str, &str)> = set
            .and_then(|set| set.split_once('='))
            .into_iter()
            .collect();
        let template = bank.find(item).expect("an item of the bank");
        let place = template.parts.iter().position(|own| own.has_id(part));
        let place = place.expect("a part of the item");
        let instance = Instance::of(template, None, &set).expect("an instance");
        let response = response.replace('⏎', "\n");
        let solution = Solution::of(instance);
        let marking = grade::mark(&solution, place, &response);
        count += 1;
        // What is right by its own kind is right on a sheet, too.
        let graded = grade::Grade::mark(&solution, [(place, response.as_str())]);
        let on_sheet = graded.part(place).map(|marking| marking.verdict.name());
        if verdict == "right" && on_sheet != Some(verdict) {
            faults.push(format!(
                "{item} {part} `{response}` on a sheet: {on_sheet:?}"
            ));
        }
        if marking.verdict.name() != verdict {
            faults.push(format!(
                "{item} {part} `{response}`: {marking:?}, not {verdict}"
            ));
        }
    }
    assert!(count > 0, "there are answers");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Calls a test with each part of the fixture and each response to it in the corpus.
fn with_responses(mut test: impl FnMut(&Solution<'_>, usize, &str)) {
    let catalogue = super::hostile::catalogue();
    let template = catalogue.items().next().expect("the fixture");
    let solution = Solution::of(Instance::of_source(template));
    for line in TYPED.lines().filter(|line| !line.starts_with('#')) {
        let [part, _, response] = line.split('\t').collect::<Vec<_>>()[..] else {
            panic!("part, verdict, response: {line}");
        };
        let place = template.parts.iter().position(|own| own.has_id(part));
        let response = response.replace("\\neq", "≠").replace("\\n", "\n");
        test(&solution, place.expect("a part of the item"), &response);
    }
}

#[test]
fn what_is_pointed_at_was_typed() {
    let (mut faults, mut count) = (Vec::new(), 0);
    with_responses(|solution, place, response| {
        // Cut off anywhere, a response is unreadable in all ways.
        let ends = response.char_indices().map(|(at, _)| at).step_by(4);
        for end in ends.chain([response.len()]) {
            let typed = &response[..end];
            for remark in &grade::mark(solution, place, typed).remarks {
                let Remark::Unreadable(Unreadable { at: Some(at), .. }) = remark else {
                    continue;
                };
                let (At::Here(quoted) | At::Behind(quoted)) = at;
                count += 1;
                if !typed.contains(quoted.as_str()) {
                    faults.push(format!("{typed}: {quoted}"));
                }
            }
        }
    });
    assert!(count > 500, "{count} places");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn what_is_echoed_is_marked_alike() {
    let (mut faults, mut count) = (Vec::new(), 0);
    with_responses(|solution, place, response| {
        let first = grade::mark(solution, place, response);
        let Some(reading) = first.reading else {
            return;
        };
        let again = grade::mark(solution, place, &reading.text);
        count += 1;
        if again.verdict != first.verdict {
            faults.push(format!(
                "{response}: {:?}; {}: {:?} {:?}",
                first.verdict, reading.text, again.verdict, again.remarks
            ));
        }
    });
    assert!(count > 300, "{count} readings");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
