//! The bits of all tasks over their stress lists, as digests that hold on every platform.
//!
//! The same list runs with and without instructions for the fused multiply-add and in WebAssembly: a reply is a text of
//! shortest decimals, so that two platforms agree on it if and only if they agree on every bit. The benchmark of the
//! numerics prints these digests for its own build.

use std::collections::BTreeMap;
use std::fmt::Write;

use serde_json::{Map, Value, json};
use sha2::{Digest, Sha256};
use vibank::compute::answer;

/// Cases of the stress lists; some lines hold no request.
const LISTS: [&str; 7] = [
    include_str!("../../fixtures/references/free.jsonl"),
    include_str!("../../fixtures/references/forced.jsonl"),
    include_str!("../../fixtures/references/steady.jsonl"),
    include_str!("../../fixtures/references/decrement.jsonl"),
    include_str!("../../fixtures/references/friction.jsonl"),
    include_str!("../../fixtures/references/pendulum.jsonl"),
    include_str!("../../fixtures/references/modes.jsonl"),
];

const MOTIONS: &str = include_str!("../../fixtures/references/modal-response.jsonl");

/// What a line asks for; none if it is for the interface of the library.
fn request(line: &str) -> Option<(String, Value)> {
    const OF_MODES: [&str; 4] = ["masses", "springs", "M", "K"];
    const OF_MOTIONS: [&str; 7] = ["masses", "springs", "dampers", "rayleigh", "x0", "v0", "t"];
    let case: Map<String, Value> = serde_json::from_str(line).ok()?;
    let part = |names: &[&str]| -> Map<String, Value> {
        let given = names.iter().filter_map(|name| case.get_key_value(*name));
        given
            .map(|(name, value)| (name.clone(), value.clone()))
            .collect()
    };
    let (task, params) = if let Some(Value::String(task)) = case.get("task") {
        (task.as_str(), case.get("params")?.clone())
    } else if case.contains_key("rates") {
        ("modes", part(&OF_MODES).into())
    } else if case.contains_key("x0") {
        ("modal_response", part(&OF_MOTIONS).into())
    } else {
        return None;
    };
    if ["forced_by_sine", "transfer"].contains(&task) {
        return None;
    }
    Some((
        task.to_owned(),
        json!({ "id": 0, "task": task, "params": params }),
    ))
}

/// A line for each task: its name, the number of requests, the digest of all replies.
pub(crate) fn digests() -> String {
    let mut tasks: BTreeMap<String, (usize, Sha256)> = BTreeMap::new();
    for line in LISTS.iter().chain([&MOTIONS]).flat_map(|list| list.lines()) {
        let Some((task, request)) = request(line) else {
            continue;
        };
        let (count, digest) = tasks.entry(task).or_default();
        *count += 1;
        digest.update(answer(&request.to_string()));
        digest.update("\n");
    }
    let mut text = String::new();
    for (task, (count, digest)) in tasks {
        write!(text, "{task} {count} ").expect("a string takes any text");
        for byte in digest.finalize() {
            write!(text, "{byte:02x}").expect("a string takes any text");
        }
        text.push('\n');
    }
    text
}

#[test]
fn replies_have_the_same_bits_on_every_platform() {
    let found = digests();
    assert!(
        found == include_str!("../../fixtures/bits.txt"),
        "this platform or this change gives other bits than `tests/fixtures/bits.txt`:\n{found}"
    );
}
