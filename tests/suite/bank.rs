//! Every item of the bank that comes with the program, over many draws.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use crate::BANK;
use serde_json::{Value as Json, json};
use vibank::answer::{KeyValue, Verdict};
use vibank::bank::{Catalogue, Listing, Template};
use vibank::grade;
use vibank::instance::Instance;
use vibank::output::{self, PageKind, Pages, Run};
use vibank::seed::Seed;
use vibank::solution::{Session, Solution, proof, request};
use vibank::source::Source;
use vibank::suitability;
use vibank::worksheet::{Blueprint, Plan, Sheet};

/// Draws of each item; `.ci/run` sets `VIBANK_DRAWS` to more.
fn draws() -> u64 {
    let draws = std::env::var("VIBANK_DRAWS");
    draws
        .ok()
        .and_then(|draws| draws.parse().ok())
        .unwrap_or(50)
}

/// Draws of each item whose keys are computed by their second routes; `vibank check` takes many more.
const PROVED: u64 = 20;

/// What `faults` finds in each item, on all cores, in the order of the bank.
fn over_all(faults: impl Fn(&Template) -> Vec<String> + Sync) -> Vec<String> {
    let catalogue = &*BANK;
    let items: Vec<_> = catalogue.items().collect();
    let next = AtomicUsize::new(0);
    let work = || {
        let mut found = Vec::new();
        while let Some(item) = items.get(next.fetch_add(1, Ordering::Relaxed)) {
            found.extend(
                faults(item)
                    .into_iter()
                    .map(|fault| format!("{}: {fault}", item.id)),
            );
        }
        found
    };
    let mut found: Vec<String> = thread::scope(|scope| {
        let workers: Vec<_> = (0..2).map(|_| scope.spawn(work)).collect();
        workers
            .into_iter()
            .flat_map(|worker| worker.join().expect("no panic"))
            .collect()
    });
    found.sort();
    found
}

#[track_caller]
fn none(faults: &[String]) {
    assert!(
        faults.is_empty(),
        "{} faults:\n{}",
        faults.len(),
        faults.join("\n")
    );
}

#[test]
fn draws_keep_to_the_constraints_and_have_all_their_keys() {
    none(&over_all(|item| {
        let mut faults = Vec::new();
        for seed in 0..draws() {
            let instance = match Instance::draw(item, Seed::new(seed)) {
                Ok(instance) => instance,
                Err(error) => return vec![error.to_string()],
            };
            let solution = Solution::of(instance);
            for constraint in &item.constraints {
                if solution.evaluation().holds(constraint.node) != Ok(true) {
                    faults.push(format!("seed {seed} breaks `{}`", constraint.name));
                }
            }
            for place in (0..item.parts.len()).filter(|place| solution.asks(*place)) {
                let id = &item.parts[place].id;
                match solution.key(place).map(|key| &key.value) {
                    Err(absent) => faults.push(format!("seed {seed}, {id}: {absent}")),
                    Ok(KeyValue::Numbers { si, .. }) if si.iter().any(|si| !si.is_finite()) => {
                        faults.push(format!("seed {seed}, {id}: {si:?}"));
                    }
                    Ok(_) => {}
                }
            }
        }
        faults
    }));
}

#[test]
fn a_key_as_it_is_printed_is_right() {
    none(&over_all(|item| {
        let mut faults = Vec::new();
        for seed in 0..draws() {
            let Ok(instance) = Instance::draw(item, Seed::new(seed)) else {
                continue;
            };
            let solution = Solution::of(instance);
            let places: Vec<usize> = (0..item.parts.len()).collect();
            // What is not fit to be handed out may have a key that is a named mistake.
            if suitability::judge(&solution, &places).is_err() {
                continue;
            }
            for place in places.into_iter().filter(|place| solution.asks(*place)) {
                let part = &item.parts[place];
                let kind = part.answer.kind().name();
                let Ok(key) = solution.key(place) else {
                    continue;
                };
                let printed = match &key.value {
                    KeyValue::Options { ids, .. } => ids.join(", "),
                    // Formulas are marked in the answers' own tests.
                    _ if ["numeric", "integer"].contains(&kind) => key.math.plain(),
                    _ => continue,
                };
                let marking = grade::mark(&solution, place, &printed);
                if marking.verdict != Verdict::Right {
                    let verdict = marking.verdict.name();
                    faults.push(format!(
                        "seed {seed}, {}: `{printed}` is {verdict}",
                        part.id
                    ));
                }
            }
        }
        faults
    }));
}

/// The worked solutions of one draw of each item, in words.
#[test]
fn one_draw_of_each_item_is_fresh() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../snapshots/items");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let catalogue = &*BANK;
    let writer = output::writer("md").expect("the format is there");
    for item in catalogue.items() {
        let text = format!(
            "title = 'One draw'\nseed = 1\nvariants = 1\nfigures = false\n[[question]]\nitem = '{}'\n",
            item.id
        );
        let blueprint = Blueprint::read(&Source::new("test.toml", text)).expect("it is sound");
        let plan = Plan::of(&blueprint, catalogue, None).expect("the item is there");
        let sheet = Sheet::draw(&plan, plan.variant(0, 0), None).expect("it can be drawn");
        let pages = Pages::new(writer, Run::of(&blueprint, writer), &[]).expect("it is sound");
        let page = pages
            .page(PageKind::Solutions, &sheet)
            .expect("it is sound");
        let name = item.id.to_string().replace('/', "-");
        settings.bind(|| insta::assert_snapshot!(name, without_pictures(&page.text)));
    }
}

/// A page without its plots, which have tests of their own.
fn without_pictures(page: &str) -> String {
    let mut pieces = page.split("<svg");
    let mut words = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        words.push_str("(a plot)");
        words.push_str(piece.split_once("</svg>").map_or("", |(_, rest)| rest));
    }
    words
}

#[test]
fn known_results_and_second_routes_hold() {
    none(&over_all(|item| {
        let findings = proof::findings(item, PROVED);
        findings.iter().map(ToString::to_string).collect()
    }));
}

/// The values of the catalogue, computed with fifty digits.
#[test]
fn the_values_of_the_catalogue_are_solved_to_the_last_digits() {
    let catalogue = &*BANK;
    let mut faults = Vec::new();
    for line in include_str!("../fixtures/reference.jsonl").lines() {
        let case: Json = serde_json::from_str(line).expect("each line is JSON");
        let id = case["id"].as_str().expect("each case has an item");
        if catalogue.find(id).is_some() {
            faults.extend(
                solved(catalogue, &case)
                    .into_iter()
                    .map(|fault| format!("{id}: {fault}")),
            );
        }
    }
    none(&faults);
}

/// What of a case of the catalogue is not solved.
fn solved(catalogue: &Catalogue, case: &Json) -> Vec<String> {
    let expected = case["expect"].as_object().expect("each case has answers");
    let mut at: Vec<&str> = expected.keys().filter_map(|key| timed(key).1).collect();
    at.dedup();
    let mut want: Vec<&str> = expected.keys().map(|key| timed(key).0).collect();
    want.dedup();
    let line = json!({"id": case["id"], "set": case["set"], "at": at, "want": want});
    let mut session = Session::new(catalogue);
    let reply = request::answer(&mut session, &line.to_string());
    let reply: Json = serde_json::from_str(&reply).expect("JSON");
    if reply.get("error").is_some() {
        return vec![reply["error"].to_string()];
    }
    let mut faults = Vec::new();
    for (key, expected) in expected {
        let (answer, time) = timed(key);
        let entry = &reply["answers"][answer];
        let (found, bound) = match time {
            None => (entry["si"].clone(), 1e-12),
            Some(time) => {
                let place = at
                    .iter()
                    .position(|at| *at == time)
                    .expect("it was asked for");
                (entry["si"][place].clone(), 1e-9)
            }
        };
        let apart = apart(&found, &expected["si"]);
        if apart.is_none_or(|apart| apart > bound) {
            faults.push(format!(
                "{key} is {found}, not {}, apart {apart:?}",
                expected["si"]
            ));
        }
    }
    faults
}

/// `x(0.37)` is the answer `x` at a time.
fn timed(key: &str) -> (&str, Option<&str>) {
    key.strip_suffix(')')
        .and_then(|key| key.split_once('('))
        .map_or((key, None), |(name, time)| (name, Some(time)))
}

/// The numbers of an answer, real and imaginary parts alike; the catalogue writes them as strings.
fn flat(value: &Json, numbers: &mut Vec<f64>) -> Option<()> {
    match value {
        Json::Number(number) => numbers.push(number.as_f64()?),
        Json::String(text) => numbers.push(text.parse().ok()?),
        Json::Array(entries) => entries.iter().try_for_each(|entry| flat(entry, numbers))?,
        Json::Object(parts) => parts.values().try_for_each(|part| flat(part, numbers))?,
        _ => return None,
    }
    Some(())
}

/// How far two answers are apart, as a share of the largest number in them; `None` if they have other forms.
fn apart(found: &Json, expected: &Json) -> Option<f64> {
    if expected.is_null() {
        return found.is_null().then_some(0.0);
    }
    let (mut a, mut b) = (Vec::new(), Vec::new());
    flat(found, &mut a)?;
    flat(expected, &mut b)?;
    if a.len() != b.len() {
        return None;
    }
    let size = b
        .iter()
        .fold(0.0_f64, |size, number| size.max(number.abs()));
    let size = if size == 0.0 { 1.0 } else { size };
    let largest = a
        .iter()
        .zip(&b)
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max);
    Some(largest / size)
}

#[test]
fn the_committed_list_is_fresh() {
    use std::fmt::Write as _;
    let catalogue = &*BANK;
    let mut rows = String::new();
    for item in catalogue.items() {
        let listing = Listing::of(item);
        let row = serde_json::to_string(&listing).expect("a row is plain data");
        assert_eq!(
            serde_json::from_str::<Listing>(&row).expect("a row"),
            listing
        );
        // The empty lines keep changes of neighbours apart when branches are merged.
        let _ = writeln!(rows, "{row}\n");
    }
    crate::generated::compare("src/bank/listings.jsonl", &rows);
}

#[test]
fn a_row_of_another_revision_does_not_count() {
    let mut catalogue = crate::small_bank();
    let id = catalogue.ids().next().expect("an item").clone();
    let row = Listing::of(catalogue.find(id.as_str()).expect("it can be used"));
    let stale = Listing {
        revision: vibank::bank::Revision::of("another text"),
        title: "Stale".to_owned(),
        ..row.clone()
    };
    catalogue.know([stale]);
    assert_eq!(catalogue.listing(&id), None);
    catalogue.know([row.clone()]);
    assert_eq!(catalogue.listing(&id), Some(&row));
}
