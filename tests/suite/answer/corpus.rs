//! The corpora of responses: formulas, numbers, equations of motion. Files and the scripts that made them lie in
//! `tests/corpora` and `tests/references`.

use std::collections::BTreeMap;

use crate::BANK;
use vibank::answer::{Marking, Reason};
use vibank::instance::Instance;
use vibank::solution::Solution;

const SYMBOLS: &str = include_str!("../../corpora/symbols.toml");
const FORMULAS: &str = include_str!("../../corpora/formulas.tsv");
const READINGS: &str = include_str!("../../corpora/readings.tsv");
const NUMBERS: &str = include_str!("../../corpora/numbers.tsv");
const EQUATIONS: &str = include_str!("../../corpora/equations.tsv");

/// The lines of a corpus as fields.
fn lines(corpus: &'static str) -> impl Iterator<Item = Vec<&'static str>> {
    let is_line = |line: &&str| !line.is_empty() && !line.starts_with('#');
    corpus
        .lines()
        .filter(is_line)
        .map(|line| line.split('\t').collect())
}

/// What a marking came to, for a message.
fn reported(marking: &Marking) -> String {
    let reasons = marking
        .reasons()
        .iter()
        .map(Reason::code)
        .collect::<Vec<_>>();
    let reading = marking
        .reading
        .as_ref()
        .map(|reading| reading.text.as_str());
    format!(
        "{} ({}), read as {reading:?}; {:?}",
        marking.verdict.name(),
        reasons.join(", "),
        super::said(marking)
    )
}

fn assert_none(faults: &[String], count: usize, least: usize) {
    assert!(count >= least, "{count} lines of at least {least}");
    assert!(
        faults.is_empty(),
        "{} of {count}:\n{}",
        faults.len(),
        faults.join("\n")
    );
}

/// Marks the responses of a corpus of formulas and says how many are right, wrong and unreadable.
fn mark_formulas(corpus: &'static str) -> (Vec<String>, [usize; 3]) {
    const RELATIONS: [(&str, &str); 3] = [("=", "right"), ("!", "wrong"), ("?", "unreadable")];
    let mut by_key: BTreeMap<&str, Vec<(&str, &str)>> = BTreeMap::new();
    for line in lines(corpus) {
        by_key.entry(line[1]).or_default().push((line[0], line[2]));
    }
    let (mut faults, mut counts) = (Vec::new(), [0; 3]);
    for (key, pairs) in by_key {
        let catalogue = super::catalogue(&format!(
            "{SYMBOLS}\n[[part]]\nid = \"p\"\nkind = \"formula\"\nask = \"Find it.\"\nkey = \"{key}\"\n"
        ));
        let solution = Solution::of(Instance::of_source(catalogue.items().next().unwrap()));
        for (relation, response) in pairs {
            let is_it = |(own, _): &(&str, &str)| *own == relation;
            let place = RELATIONS.iter().position(is_it).expect("a relation");
            counts[place] += 1;
            let marking = vibank::grade::mark(&solution, 0, response);
            if marking.verdict.name() != RELATIONS[place].1 {
                faults.push(format!(
                    "{key} {relation} {response}: {}",
                    reported(&marking)
                ));
            }
        }
    }
    (faults, counts)
}

#[test]
fn formulas_are_told_apart() {
    let (faults, [equal, near, _]) = mark_formulas(FORMULAS);
    assert_none(&faults, equal.min(near), 500);
}

#[test]
fn formulas_are_read_as_they_are_meant() {
    let (faults, counts) = mark_formulas(READINGS);
    assert_none(&faults, counts.iter().sum(), 80);
}

#[test]
fn numbers_are_read_as_they_are_meant() {
    let mut by_unit: BTreeMap<&str, Vec<(&str, &str)>> = BTreeMap::new();
    for line in lines(NUMBERS) {
        by_unit.entry(line[0]).or_default().push((line[1], line[2]));
    }
    let (mut faults, mut count) = (Vec::new(), 0);
    for (unit, typed) in by_unit {
        let catalogue = super::catalogue(&format!(
            "[parameters]\np = \"1 {unit}\"\n[quantities]\nq = {{ formula = \"2*p\", unit = \"{unit}\" }}\n[[part]]\nkey = \"q\"\nask = \"Find it.\"\n"
        ));
        let solution = Solution::of(Instance::of_source(catalogue.items().next().unwrap()));
        for (response, due) in typed {
            count += 1;
            let marking = vibank::grade::mark(&solution, 0, response);
            let is_due = match due {
                "unreadable" => marking.verdict.name() == "unreadable",
                "dimension" => marking.reasons().contains(&Reason::Dimension),
                number => {
                    let due: f64 = number.parse().expect("a number");
                    marking.reading.as_ref().is_some_and(|reading| {
                        let found = reading.answered.si()[0];
                        (found - due).abs() <= 4.0 * f64::EPSILON * due.abs()
                            && !marking.reasons().contains(&Reason::Dimension)
                    })
                }
            };
            if !is_due {
                let si = marking
                    .reading
                    .as_ref()
                    .map(|reading| reading.answered.si());
                faults.push(format!(
                    "`{response}` for {unit}: {due} is due, {si:?} {}",
                    reported(&marking)
                ));
            }
        }
    }
    assert_none(&faults, count, 300);
}

#[test]
fn equations_of_motion_are_told_apart() {
    let bank = &*BANK;
    let (mut faults, mut count) = (Vec::new(), 0);
    for line in lines(EQUATIONS) {
        count += 1;
        let [item, part, response, due, words] = line[..] else {
            panic!("five fields: {line:?}");
        };
        let template = bank.find(item).expect("an item of the bank");
        let place = template
            .parts
            .iter()
            .position(|own| own.has_id(part))
            .expect("a part of it");
        let solution = Solution::of(Instance::of_source(template));
        let marking = vibank::grade::mark(&solution, place, response);
        // A named mistake of the item says it in its own words.
        let is_named = matches!(marking.reason(), Reason::Mistake(_));
        let is_said = is_named || super::said(&marking).contains(words);
        if marking.verdict.name() != due && !is_named || !is_said {
            faults.push(format!(
                "{item} {part} `{response}`: {due}, {words}; {}",
                reported(&marking)
            ));
        }
    }
    assert_none(&faults, count, 100);
}

/// What the numbers of the issue are worth: by dimension, with 2π named, with a remark.
#[test]
fn units_count_by_dimension() {
    let item = |value: &str, unit: &str| {
        format!(
            "[parameters]\np = \"{value} {unit}\"\n[quantities]\nq = {{ formula = \"1*p\", unit = \"{unit}\" }}\n[[part]]\nkey = \"q\"\nask = \"Find it.\"\n"
        )
    };
    super::check(
        &item("10", "rad/s"),
        &[
            ("10 rad/s", "right"),
            ("10 Hz", "wrong two-pi: 2π"),
            ("1.5915 Hz", "right"),
            ("95.49 rpm", "right"),
            ("10 s^-1", "right"),
            ("10/(2*pi) Hz", "right"),
            ("-10 rad/s", "wrong sign"),
            ("10 krad/s", "wrong power-of-ten"),
            ("5 N", "wrong dimension: `N` measures a force"),
            ("10 rad/s or so", "unreadable"),
        ],
    );
    super::check(
        &item("100", "N s/m"),
        &[("100 kg/s", "right"), ("100 N/m", "wrong dimension")],
    );
    super::check(
        &item("5", "mm"),
        &[
            ("5e-3 m", "right"),
            ("5", "right"),
            ("5 m", "wrong power-of-ten"),
            (
                "5 J",
                "wrong dimension: `J` measures an energy. The answer is a length, in mm.",
            ),
        ],
    );
    super::check(
        &item("5", "N m"),
        &[
            ("5 J", "right matches: joule"),
            ("5 N m", "right"),
            ("5 N", "wrong dimension"),
        ],
    );
    super::check(&item("5", "J"), &[("5 N m", "right"), ("5 J", "right")]);
    super::check(
        &item("0.5", "1"),
        &[
            ("1/2", "right"),
            ("50 %", "right"),
            ("0.5 m", "wrong dimension: A pure number is asked"),
        ],
    );
}
