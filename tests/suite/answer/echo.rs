//! What is shown of a response while it is typed tells nothing of the key.

use crate::BANK;
use vibank::bank::{Catalogue, Template};
use vibank::grade;
use vibank::instance::Instance;
use vibank::solution::Solution;

const ITEM: &str = include_str!("../../fixtures/kinds/item.toml");
const TYPED: &str = include_str!("../../corpora/typed.tsv");
const NUMBERS: &str = include_str!("../../corpora/numbers.tsv");
const READINGS: &str = include_str!("../../corpora/readings.tsv");

/// Sides that are equal with one key and not with the other.
const SIDES: [&str; 2] = ["omega_0 .= sqrt(k/m)", "2*omega_n/2 = sqrt(k/m)"];

/// The same questions with other keys.
fn other() -> String {
    let changes = [
        ("key  = \"R + 4[ohm]*i\"", "key  = \"5*R - 7[ohm]*i\""),
        ("key  = \"2\"", "key  = \"5000\""),
        (
            "\"sqrt(k/m - (c/(2*m))^2)\"",
            "\"(2*sqrt(k/m) + sqrt(m)*c/(m*sqrt(m)))/3\"",
        ),
        ("\"sqrt(k/m)\"", "\"1000*sqrt(k/m)\""),
        ("\"[omega_n, sqrt(3*k/m)]\"", "\"[7*omega_n, 3*omega_n]\""),
        ("\"[[2*k, -k], [-k, 2*k]]\"", "\"[[3*k, 0*k], [0*k, k]]\""),
        (
            "\"l*exp(-c/(2*m)*t)*cos(omega_n*t)\"",
            "\"l*exp(-c/m*t)*sin(omega_n*t)\"",
        ),
        ("\"[1, 1]\"", "\"[1, -3]\""),
        ("\"k*l/(m*9.81[m/s^2]*10)\"", "\"k*l/(m*9.81[m/s^2]*70)\""),
        ("+ 1/2*k*(x2 - x1)^2", "+ 3/2*k*(x2 - x1)^2"),
        (
            "right = true }, { id = \"over\", text = \"Overdamped.\"",
            "}, { id = \"over\", text = \"Overdamped.\", right = true",
        ),
    ];
    changes.iter().fold(ITEM.to_owned(), |item, (old, new)| {
        assert!(item.contains(old), "{old}");
        item.replacen(old, new, 1)
    })
}

fn catalogue(item: &str) -> Catalogue {
    let (catalogue, findings) = Catalogue::load([
        ("bank.toml", "format = 1\ntitle = 'Test'\n"),
        ("kinds/_chapter.toml", "title = 'Kinds'\n"),
        ("kinds/item.toml", item),
    ]);
    assert!(catalogue.items().next().is_some(), "{findings:#?}");
    catalogue
}

#[test]
fn the_echo_does_not_depend_on_the_key() {
    let catalogues = [catalogue(ITEM), catalogue(&other())];
    let [one, two] = catalogues
        .each_ref()
        .map(|own| Solution::of(Instance::of_source(own.items().next().unwrap())));
    let last = |line: &'static str| line.rsplit('\t').next().unwrap_or_default();
    let lines = [TYPED, NUMBERS, READINGS].into_iter().flat_map(str::lines);
    let lines = lines.filter(|line| !line.starts_with('#')).map(last);
    // A third of them: a general solution takes its time, and `fuzz/` asks for the same without end.
    let lines = lines.step_by(3).chain(SIDES);
    let (mut faults, mut count) = (Vec::new(), 0);
    for line in lines {
        let response = line.replace("\\neq", "≠").replace("\\n", "\n");
        for place in 0..one.template().parts.len() {
            let echo = |solution| {
                let echo = grade::echo(solution, place, &response);
                echo.map(|echo| (echo.reading.text, echo.other))
            };
            let (first, second) = (echo(&one), echo(&two));
            count += 1;
            if first != second {
                let id = &one.template().parts[place].id;
                faults.push(format!("{id} `{response}`:\n  {first:?}\n  {second:?}"));
            }
        }
    }
    assert!(count > 5_000, "{count} echoes");
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn a_number_that_is_marked_is_echoed_as_it_was_read() {
    let catalogue = catalogue(ITEM);
    let solution = Solution::of(Instance::of_source(catalogue.items().next().unwrap()));
    let of = |response| grade::echo(&solution, 0, response).expect("it is read");
    let echo = of("5,000 rad/s");
    assert_eq!(echo.reading.text, "5.000 rad/s");
    assert!(
        echo.other
            .is_some_and(|other| other.plain().contains("5000"))
    );
    assert_eq!(of("5.1 rad/s").other, None);
    assert!(grade::echo(&solution, 0, "some").is_err());
}

#[test]
fn an_echo_is_read_as_it_stands() {
    let catalogue = catalogue(ITEM);
    let solution = Solution::of(Instance::of_source(catalogue.items().next().unwrap()));
    let mut count = 0;
    for response in ["1 m", "(1) m", "(1) k/m", "(2) m", "1) sqrt(k/m)"] {
        for place in 0..solution.template().parts.len() {
            let Ok(echo) = grade::echo(&solution, place, response) else {
                continue;
            };
            let again = grade::echo(&solution, place, &echo.reading.text);
            let again = again.map(|again| again.reading.text);
            assert_eq!(again, Ok(echo.reading.text), "`{response}`");
            count += 1;
        }
    }
    assert!(count >= 10, "{count}");
}

/// What reads the parts of an item and knows no key, with the places of those that it reads.
fn stripped(template: &Template) -> (Template, Vec<usize>) {
    let places = 0..template.parts.len();
    let places: Vec<usize> = places
        .filter(|place| template.stripped(&[*place]).is_some())
        .collect();
    let compiled = template
        .stripped(&places)
        .expect("each of them alone was read");
    let own = compiled
        .template()
        .expect("it was compiled by this program");
    (own, places)
}

#[test]
fn what_knows_no_key_reads_as_the_item_does() {
    let catalogue = catalogue(ITEM);
    let item = catalogue.items().next().expect("the item is sound");
    let (bare, places) = stripped(item);
    assert_eq!(places.len(), item.parts.len(), "{places:?}");
    let [one, two] = [item, &bare].map(|own| Solution::of(Instance::of_source(own)));
    let last = |line: &'static str| line.rsplit('\t').next().unwrap_or_default();
    let lines = [TYPED, NUMBERS, READINGS].into_iter().flat_map(str::lines);
    let lines = lines.filter(|line| !line.starts_with('#')).map(last);
    let (mut faults, mut count) = (Vec::new(), 0);
    for line in lines.step_by(3) {
        let response = line.replace("\\neq", "≠").replace("\\n", "\n");
        for (own, place) in places.iter().enumerate() {
            let echo = |solution, place| {
                let echo = grade::echo(solution, place, &response);
                echo.map(|echo| (echo.reading.text, echo.other))
            };
            let (first, second) = (echo(&one, *place), echo(&two, own));
            count += 1;
            if first != second {
                let id = &item.parts[*place].id;
                faults.push(format!("{id} `{response}`:\n  {first:?}\n  {second:?}"));
            }
        }
    }
    assert!(count > 5_000, "{count} echoes");
    assert!(
        faults.is_empty(),
        "{} of {count}\n{}",
        faults.len(),
        faults[..faults.len().min(40)].join("\n")
    );
}

/// Parts of the bank that no page can read without their keys, each with the reason.
const NOT_STRIPPED: [(&str, &str); 0] = [];

#[test]
fn all_parts_of_the_bank_can_be_read_without_their_keys() {
    let (mut lost, mut other, mut count) = (Vec::new(), Vec::new(), 0);
    for item in BANK.items() {
        let (bare, places) = stripped(item);
        for place in 0..item.parts.len() {
            if !places.contains(&place) {
                lost.push(format!("{} {}", item.id, item.parts[place].id));
            }
        }
        let json = serde_json::to_string(&vibank::bank::Compiled::of(&bare)).expect("JSON");
        for words in ["sqrt", "model.", "feedback", "tolerance"] {
            let is_known = item.parts.iter().any(|part| part.id.contains(words));
            assert!(
                is_known || !json.contains(words) || words == "model.",
                "{} has `{words}`",
                item.id
            );
        }
        let [full, own] = [item, &bare].map(|own| Solution::of(Instance::of_source(own)));
        for (at, place) in places.iter().enumerate() {
            let Ok(marker) = full.marker(*place) else {
                continue;
            };
            for trial in marker.trials() {
                let echo = |solution, place| {
                    let echo = grade::echo(solution, place, &trial.response);
                    echo.map(|echo| echo.reading.text).ok()
                };
                count += 1;
                let (first, second) = (echo(&full, *place), echo(&own, at));
                if first != second {
                    let id = &item.parts[*place].id;
                    other.push(format!(
                        "{} {id} `{}`: {first:?} {second:?}",
                        item.id, trial.response
                    ));
                }
            }
        }
    }
    lost.retain(|own| NOT_STRIPPED.iter().all(|(known, _)| own != known));
    assert!(lost.is_empty(), "{} parts: {}", lost.len(), lost.join(", "));
    assert!(count > 3_000, "{count} responses");
    assert!(
        other.is_empty(),
        "{} of {count}\n{}",
        other.len(),
        other[..other.len().min(60)].join("\n")
    );
}
